/* Ranges: between what numbers of a tape, and their rates in time, lie while the time goes from one
   value to another (interval arithmetic; Moore 1966). Each operation's range holds all its values,
   a little more for rounding, and shrinks with those of its arguments, so that a switch whose
   argument's range lacks zero is not crossed, however short a pulse may be. */
#include "small.h"

#include "internal.h"

#include <string.h>

typedef struct range {
    double low, high;
} range;

typedef struct moving_range {
    range value, rate;
} moving_range;

#define ROUNDING 1e-15 /* part of a value by which an operation may be off */
#define HALF_TURN 3.14159265358979323846

static const range ANYTHING = {-INFINITY, INFINITY}, ZERO = {0.0, 0.0};

static int is_point(range a) { return a.low == a.high; }
static int has_zero(range a) { return a.low <= 0.0 && a.high >= 0.0; }

/* The range from one value to another, in either order, a little wider. */
static range between(double a, double b)
{
    if (a != a || b != b) return ANYTHING;
    const double low = fmin(a, b), high = fmax(a, b),
                 wider = ROUNDING * fmax(fabs(low), fabs(high));
    return wider < INFINITY ? (range){low - wider, high + wider} : (range){low, high};
}

static range sum_range(range a, range b)
{
    const int is_bounded = fmin(a.low, b.low) > -INFINITY && fmax(a.high, b.high) < INFINITY;
    return is_bounded ? between(a.low + b.low, a.high + b.high) : ANYTHING;
}

static range negative_range(range a) { return (range){-a.high, -a.low}; }

static range product_range(range a, range b)
{
    if ((a.low == 0.0 && a.high == 0.0) || (b.low == 0.0 && b.high == 0.0)) return ZERO;
    const double x[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 4; i++) {
        if (x[i] != x[i]) return ANYTHING;
        low = fmin(low, x[i]);
        high = fmax(high, x[i]);
    }
    return between(low, high);
}

static range inverse_range(range a)
{ return has_zero(a) ? ANYTHING : between(1.0 / a.low, 1.0 / a.high); }
static range quotient_range(range a, range b) { return product_range(a, inverse_range(b)); }
static range square_range(range a)
{
    return has_zero(a) ? between(0.0, fmax(a.low * a.low, a.high * a.high))
                       : between(a.low * a.low, a.high * a.high);
}

static range range_of_sine(range a)
{
    if (!(a.high - a.low < 2.0 * HALF_TURN)) return (range){-1.0 - ROUNDING, 1.0 + ROUNDING};
    range found = between(hm_sin(a.low), hm_sin(a.high));
    const double turn = 2.0 * HALF_TURN;
    if (floor((a.high - 0.5 * HALF_TURN) / turn + ROUNDING)
        > floor((a.low - 0.5 * HALF_TURN) / turn - ROUNDING))
        found.high = 1.0 + ROUNDING;
    if (floor((a.high + 0.5 * HALF_TURN) / turn + ROUNDING)
        > floor((a.low + 0.5 * HALF_TURN) / turn - ROUNDING))
        found.low = -1.0 - ROUNDING;
    return found;
}

static range range_of_cosine(range a)
{ return range_of_sine(sum_range(a, (range){0.5 * HALF_TURN, 0.5 * HALF_TURN})); }

/* a^n of a fixed number n. */
static range power(range a, double n)
{
    if (n == 0.0) return (range){1.0, 1.0};
    if (n < 0.0) return inverse_range(power(a, -n));
    if (a.low < 0.0 && n != floor(n))
        return a.high < 0.0 ? ANYTHING : between(0.0, hm_pow(a.high, n));
    const double low = hm_pow(a.low, n), high = hm_pow(a.high, n);
    return a.low < 0.0 && a.high > 0.0 && n == 2.0 * floor(0.5 * n) ? between(0.0, fmax(low, high))
                                                                    : between(low, high);
}

/* A function that rises, and its slope's range. */
static moving_range rising(int32_t code, moving_range a, range slope)
{
    const range value =
        between(hm_operate(code, a.value.low, 0.0, 0.0), hm_operate(code, a.value.high, 0.0, 0.0));
    return (moving_range){value, product_range(slope, a.rate)};
}

static moving_range power_of(moving_range a, moving_range b)
{
    if (is_point(b.value)) {
        const double n = b.value.low;
        const range slope = n == 0.0 ? ZERO : product_range((range){n, n}, power(a.value, n - 1.0));
        return (moving_range){power(a.value, n), product_range(slope, a.rate)};
    }
    if (!(a.value.low > 0.0)) return (moving_range){ANYTHING, ANYTHING};
    const range log = between(hm_log(a.value.low), hm_log(a.value.high)),
                exponent = product_range(log, b.value);
    const range value = between(hm_exp(exponent.low), hm_exp(exponent.high));
    return (moving_range){
        value,
        product_range(value, sum_range(product_range(quotient_range(a.rate, a.value), b.value),
                                       product_range(log, b.rate)))};
}

/* Angle of (b, a): its extremes are at corners where neither the origin nor the cut behind it is
   inside. */
static moving_range angle(moving_range a, moving_range b)
{
    const range y = a.value, x = b.value, size = sum_range(square_range(x), square_range(y));
    const range rate = quotient_range(
        sum_range(product_range(x, a.rate), negative_range(product_range(y, b.rate))), size);
    if (has_zero(y) && x.low <= 0.0) return (moving_range){{-HALF_TURN, HALF_TURN}, rate};
    range found = {INFINITY, -INFINITY};
    for (int i = 0; i < 4; i++) {
        const double corner = hm_atan2(i % 2 ? y.high : y.low, i / 2 ? x.high : x.low);
        found.low = fmin(found.low, corner);
        found.high = fmax(found.high, corner);
    }
    return (moving_range){between(found.low, found.high), rate};
}

static moving_range arc_sine(int32_t code, moving_range a)
{
    const range inside = {fmax(a.value.low, -1.0), fmin(a.value.high, 1.0)};
    if (inside.low > inside.high) return (moving_range){ANYTHING, ANYTHING};
    const double widest = fmax(inside.low * inside.low, inside.high * inside.high),
                 least =
                     has_zero(inside)
                         ? 1.0
                         : 1.0
                               / sqrt(1.0
                                      - fmin(inside.low * inside.low, inside.high * inside.high));
    const range slope =
        widest < 1.0 ? between(least, 1.0 / sqrt(1.0 - widest)) : (range){least, INFINITY};
    const range value =
        between(hm_operate(code, inside.low, 0.0, 0.0), hm_operate(code, inside.high, 0.0, 0.0));
    return (moving_range){value,
                          product_range(code == T_ASIN ? slope : negative_range(slope), a.rate)};
}

static moving_range root(moving_range a)
{
    if (a.value.high < 0.0) return (moving_range){ANYTHING, ANYTHING};
    const double low = sqrt(fmax(a.value.low, 0.0)), high = sqrt(a.value.high);
    const range slope = low > 0.0 ? between(0.5 / high, 0.5 / low) : (range){0.5 / high, INFINITY};
    return (moving_range){between(low, high), product_range(slope, a.rate)};
}

static range hull(range a, range b) { return (range){fmin(a.low, b.low), fmax(a.high, b.high)}; }

/* Operations without a table. Those that jump are on sides here, which stand: what else jumps may
   be anything. */
static moving_range operate(int32_t code, moving_range a, moving_range b, moving_range c)
{
    const range x = a.value;
    switch (code) {
    case T_COPY: return a;
    case T_ADD: return (moving_range){sum_range(x, b.value), sum_range(a.rate, b.rate)};
    case T_SUB:
        return (moving_range){sum_range(x, negative_range(b.value)),
                              sum_range(a.rate, negative_range(b.rate))};
    case T_MUL:
        return (moving_range){product_range(x, b.value),
                              sum_range(product_range(a.rate, b.value), product_range(x, b.rate))};
    case T_DIV: {
        const range value = quotient_range(x, b.value);
        return (moving_range){
            value, quotient_range(sum_range(a.rate, negative_range(product_range(value, b.rate))),
                                  b.value)};
    }
    case T_NEG: return (moving_range){negative_range(x), negative_range(a.rate)};
    case T_POW: return power_of(a, b);
    case T_SIN: return (moving_range){range_of_sine(x), product_range(range_of_cosine(x), a.rate)};
    case T_COS:
        return (moving_range){range_of_cosine(x),
                              negative_range(product_range(range_of_sine(x), a.rate))};
    case T_TAN:
        if (floor(x.low / HALF_TURN + 0.5) != floor(x.high / HALF_TURN + 0.5))
            return (moving_range){ANYTHING, ANYTHING};
        return rising(code, a, inverse_range(square_range(range_of_cosine(x))));
    case T_ASIN: case T_ACOS: return arc_sine(code, a);
    case T_ATAN:
        return rising(code, a, inverse_range(sum_range((range){1.0, 1.0}, square_range(x))));
    case T_ATAN2: return angle(a, b);
    case T_SQRT: return root(a);
    case T_EXP: return rising(code, a, between(hm_exp(x.low), hm_exp(x.high)));
    case T_LOG:
        return x.low > 0.0 ? rising(code, a, inverse_range(x)) : (moving_range){ANYTHING, ANYTHING};
    case T_SINH: case T_COSH: {
        const range odd = between(hm_sinh(x.low), hm_sinh(x.high)),
                    ends = between(hm_cosh(x.low), hm_cosh(x.high));
        const range even = has_zero(x) ? (range){1.0 - ROUNDING, ends.high} : ends;
        return code == T_SINH ? (moving_range){odd, product_range(even, a.rate)}
                              : (moving_range){even, product_range(odd, a.rate)};
    }
    case T_TANH: {
        const range value = between(hm_tanh(x.low), hm_tanh(x.high));
        return (moving_range){
            value, product_range(sum_range((range){1.0, 1.0}, negative_range(square_range(value))),
                                 a.rate)};
    }
    case T_SELECT:
        if (is_point(x)) return x.low != 0.0 ? b : c;
        return (moving_range){hull(b.value, c.value), ANYTHING};
    default: return (moving_range){ANYTHING, ANYTHING};
    }
}

static moving_range look_up(int32_t code, moving_range a, const double *first, const double *last)
{
    double found[2];
    if (reads_grid(code)) return (moving_range){ANYTHING, ANYTHING};
    hm_spline_range(code - T_SPLINE, a.value.low, a.value.high, first, last, found);
    const range value = between(found[0], found[1]);
    hm_spline_range(code - T_SPLINE + 1, a.value.low, a.value.high, first, last, found);
    return (moving_range){value, product_range(between(found[0], found[1]), a.rate)};
}

static moving_range at_place(const double *bounds, int32_t place)
{
    const double *x = bounds + 4 * (int64_t)place;
    return (moving_range){{x[0], x[1]}, {x[2], x[3]}};
}

static int range_stands(moving_range a)
{ return is_point(a.value) && a.rate.low == 0.0 && a.rate.high == 0.0; }

void hm_set_range(double *bounds, int32_t place, double low, double high, double least, double most)
{
    const double x[] = {low, high, least, most};
    memcpy(bounds + 4 * (int64_t)place, x, sizeof x);
}

static const int32_t *segment_of(const holonom_model *m, int32_t segment, int32_t *count)
{
    const int32_t *op = m->tape, *length = &m->n_tape_parameters;
    for (int32_t before = 0; before < segment; before++) op += 5 * (int64_t)length[before];
    *count = length[segment];
    return op;
}

void hm_stop_ranges(const holonom_model *m, const double *numbers, int32_t segment, double *bounds)
{
    int32_t count;
    const int32_t *op = segment_of(m, segment, &count), *end = op + 5 * (int64_t)count;
    for (; op < end; op += 5)
        for (int k = 2; k < 5; k++)
            hm_set_range(bounds, op[k], numbers[op[k]], numbers[op[k]], 0.0, 0.0);
}

void hm_run_ranges(const holonom_model *m, const double *numbers, int32_t segment, double *bounds)
{
    int32_t count;
    const int32_t *op = segment_of(m, segment, &count), *end = op + 5 * (int64_t)count;
    for (; op < end; op += 5) {
        const moving_range a = at_place(bounds, op[2]);
        moving_range found;
        if (op[0] >= T_SPLINE) found = look_up(op[0], a, numbers + op[3], numbers + op[4]);
        else {
            const moving_range b = at_place(bounds, op[3]), c = at_place(bounds, op[4]);
            if (range_stands(a) && range_stands(b) && range_stands(c)) {
                const double value = hm_operate(op[0], a.value.low, b.value.low, c.value.low);
                found = (moving_range){{value, value}, ZERO};
            } else found = operate(op[0], a, b, c);
        }
        hm_set_range(bounds, op[1], found.value.low, found.value.high, found.rate.low,
                     found.rate.high);
    }
}

#include "small.h"
