/* Jets: values with their rates and second derivatives in time, through the operations of tapes and
   functions (forward mode).

   They look forward: at a kink or a jump, such as that of max(t, 0) at 0, the jet is that of what
   follows, and a table is read in the piece that its argument comes to. */
#include "small.h"

#include "internal.h"

static hm_jet jet_difference(hm_jet a, hm_jet b)
{ return (hm_jet){a.value - b.value, a.rate - b.rate, a.bend - b.bend}; }

static hm_jet jet_product(hm_jet a, hm_jet b)
{
    return (hm_jet){a.value * b.value, a.rate * b.value + a.value * b.rate,
                    a.bend * b.value + 2.0 * a.rate * b.rate + a.value * b.bend};
}

static hm_jet jet_quotient(hm_jet a, hm_jet b)
{
    const double value = a.value / b.value, rate = (a.rate - value * b.rate) / b.value;
    return (hm_jet){value, rate, (a.bend - 2.0 * rate * b.rate - value * b.bend) / b.value};
}

static int jet_stands(hm_jet a) { return a.rate == 0.0 && a.bend == 0.0; }

/* Of a function of a with this value and these derivatives, which may be infinite where a stands.
   Where the slope is infinite and the rate is 0, their product may have a limit, as that of
   sqrt(t^2) does: both rates are NaN. */
static hm_jet jet_chain(hm_jet a, double value, double slope, double curvature)
{
    if (jet_stands(a)) return (hm_jet){value, 0.0, 0.0};
    if (a.rate == 0.0 && !(fabs(slope) < INFINITY)) return (hm_jet){value, NAN, NAN};
    return (hm_jet){value, slope * a.rate,
                    slope * a.bend + (a.rate == 0.0 ? 0.0 : curvature * a.rate * a.rate)};
}

/* factor a^n, without the infinite power of 0 that a factor of 0 leaves out. */
static double times_power(double factor, double a, double n)
{ return factor == 0.0 ? 0.0 : factor * hm_pow(a, n); }

static hm_jet jet_power(hm_jet a, hm_jet b)
{
    const double value = hm_pow(a.value, b.value), n = b.value;
    if (jet_stands(b))
        return jet_chain(a, value, times_power(n, a.value, n - 1.0),
                         times_power(n * (n - 1.0), a.value, n - 2.0));
    const double inverse = 1.0 / a.value;
    const hm_jet exponent =
        jet_product(jet_chain(a, hm_log(a.value), inverse, -inverse * inverse), b);
    return jet_chain(exponent, value, value, value);
}

static hm_jet jet_angle(hm_jet a, hm_jet b)
{
    const double square = a.value * a.value + b.value * b.value;
    const double rate = (b.value * a.rate - a.value * b.rate) / square;
    const double bend =
        (b.value * a.bend - a.value * b.bend - 2.0 * rate * (a.value * a.rate + b.value * b.rate))
        / square;
    return (hm_jet){hm_atan2(a.value, b.value), jet_stands(a) && jet_stands(b) ? 0.0 : rate,
                    jet_stands(a) && jet_stands(b) ? 0.0 : bend};
}

/* What a exceeds a multiple of b by: at a multiple, that from which a falls is the one before. */
static hm_jet jet_modulus(hm_jet a, hm_jet b)
{
    double value = hm_operate(T_MOD, a.value, b.value, 0.0);
    double whole = floor((a.value - value) / b.value + 0.5);
    if (value == 0.0) {
        hm_jet after = jet_quotient(a, b);
        after.value = 0.0;
        if (hm_sign_after(after) < 0.0) value = b.value, whole -= 1.0;
    }
    return (hm_jet){value, a.rate - whole * b.rate, a.bend - whole * b.bend};
}

/* Floor or ceiling: at a whole number, of the side to which a goes. */
static double rounded_jet(int32_t code, hm_jet a)
{
    const double value = hm_operate(code, a.value, 0.0, 0.0),
                 goes = hm_sign_after((hm_jet){0.0, a.rate, a.bend});
    if (value != a.value) return value;
    return code == T_FLOOR ? value - (goes < 0.0) : value + (goes > 0.0);
}

/* A comparison as it is just after the present. */
static double compared_jets(int32_t code, hm_jet a, hm_jet b)
{
    if (a.value != b.value) return hm_operate(code, a.value, b.value, 0.0);
    return hm_operate(code, hm_sign_after((hm_jet){0.0, a.rate - b.rate, a.bend - b.bend}), 0.0,
                      0.0);
}

hm_jet hm_operate_jet(int32_t code, hm_jet a, hm_jet b, hm_jet c)
{
    const double x = a.value, f = hm_operate(code, x, b.value, c.value), rest = 1.0 - x * x;
    switch (code) {
    case T_COPY: return a;
    case T_ADD: return (hm_jet){f, a.rate + b.rate, a.bend + b.bend};
    case T_SUB: return jet_difference(a, b);
    case T_MUL: return jet_product(a, b);
    case T_DIV: return jet_quotient(a, b);
    case T_POW: return jet_power(a, b);
    case T_NEG: return (hm_jet){-x, -a.rate, -a.bend};
    case T_SIN: return jet_chain(a, f, hm_cos(x), -f);
    case T_COS: return jet_chain(a, f, -hm_sin(x), -f);
    case T_TAN: return jet_chain(a, f, 1.0 + f * f, 2.0 * f * (1.0 + f * f));
    case T_ASIN: return jet_chain(a, f, 1.0 / sqrt(rest), x / (rest * sqrt(rest)));
    case T_ACOS: return jet_chain(a, f, -1.0 / sqrt(rest), -x / (rest * sqrt(rest)));
    case T_ATAN:
        return jet_chain(a, f, 1.0 / (1.0 + x * x), -2.0 * x / ((1.0 + x * x) * (1.0 + x * x)));
    case T_ATAN2: return jet_angle(a, b);
    case T_SQRT: return jet_chain(a, f, 0.5 / f, -0.25 / (x * f));
    case T_EXP: return jet_chain(a, f, f, f);
    case T_LOG: return jet_chain(a, f, 1.0 / x, -1.0 / (x * x));
    case T_SINH: return jet_chain(a, f, hm_cosh(x), f);
    case T_COSH: return jet_chain(a, f, hm_sinh(x), f);
    case T_TANH: return jet_chain(a, f, 1.0 - f * f, -2.0 * f * (1.0 - f * f));
    case T_ABS:
        return hm_sign_after(a) < 0.0 ? (hm_jet){f, -a.rate, -a.bend} : (hm_jet){f, a.rate, a.bend};
    case T_MIN: return x != x || (b.value == b.value && compared_jets(T_LE, a, b) != 0.0) ? a : b;
    case T_MAX: return x != x || (b.value == b.value && compared_jets(T_GE, a, b) != 0.0) ? a : b;
    case T_SELECT: return x != 0.0 ? b : c;
    case T_MOD: return jet_modulus(a, b);
    case T_SIGN: return (hm_jet){x != x ? x : hm_sign_after(a), 0.0, 0.0};
    case T_FLOOR: case T_CEIL: return (hm_jet){rounded_jet(code, a), 0.0, 0.0};
    case T_LT:
    case T_LE:
    case T_GT:
    case T_GE:
    case T_EQ:
    case T_NE: return (hm_jet){compared_jets(code, a, b), 0.0, 0.0};
    default: return (hm_jet){f, 0.0, 0.0};
    }
}

hm_jet hm_look_up_jet(int32_t code, const hm_jet *x, const double *first, const double *last)
{
    double f[3];
    if (reads_grid(code)) return hm_grid_jet(code - T_GRID, x, first, last);
    hm_spline_derivatives(code - T_SPLINE, x->value, hm_falls(*x), first, last, f);
    return jet_chain(*x, f[0], f[1], f[2]);
}

static const int32_t *operations_of(const holonom_model *m, int32_t segment, int32_t *count)
{
    const int32_t *op = m->tape, *length = &m->n_tape_parameters;
    for (int32_t before = 0; before < segment; before++) op += 5 * (int64_t)length[before];
    *count = length[segment];
    return op;
}

void hm_stop_jets(const holonom_model *m, int32_t segment, double *jet)
{
    int32_t count;
    const int32_t *op = operations_of(m, segment, &count), *end = op + 5 * (int64_t)count;
    for (; op < end; op += 5)
        for (int k = 0; k < (reads_grid(op[0]) ? 6 : 2); k++)
            jet[2 * op[2] + k] = jet[2 * op[3] + k % 2] = jet[2 * op[4] + k % 2] = 0.0;
}

int hm_may_be_steep(const holonom_model *m, const double *numbers, int32_t segment)
{
    int32_t count;
    const int32_t *op = operations_of(m, segment, &count), *end = op + 5 * (int64_t)count;
    for (; op < end; op += 5) {
        const double x = numbers[op[2]];
        if ((op[0] == T_SQRT || op[0] == T_POW) && x == 0.0) return 1;
        if ((op[0] == T_ASIN || op[0] == T_ACOS) && fabs(x) == 1.0) return 1;
    }
    return 0;
}

static hm_jet jet_at(const double *numbers, const double *jet, int32_t place)
{
    return (hm_jet){numbers[place], jet[2 * place], jet[2 * place + 1]};
}

/* Whether the jet of an operation depends on derivatives beyond the second, unless its arguments
   stand still: at a tie, or where its slope is infinite. */
static int is_in_doubt(int32_t code, hm_jet a, hm_jet b)
{
    const hm_jet apart = jet_difference(a, b);
    switch (code) {
    case T_SQRT: return a.value == 0.0 && jet_stands(a);
    case T_POW: return a.value == 0.0 && b.value < 2.0 && jet_stands(a);
    case T_ASIN: case T_ACOS: return fabs(a.value) == 1.0 && jet_stands(a);
    case T_SIGN: return a.value == 0.0 && jet_stands(a);
    case T_FLOOR: case T_CEIL: return a.value == floor(a.value) && jet_stands(a);
    case T_LT:
    case T_LE:
    case T_GT:
    case T_GE:
    case T_EQ:
    case T_NE: return apart.value == 0.0 && jet_stands(apart);
    default: return 0;
    }
}

int32_t hm_run_jets(const holonom_model *m, double *numbers, int32_t segment, double *jet)
{
    int32_t count, doubts = 0;
    const int32_t *op = operations_of(m, segment, &count), *end = op + 5 * (int64_t)count;
    for (; op < end; op += 5) {
        hm_jet x[3] = {jet_at(numbers, jet, op[2])}, y;
        for (int k = 1; k < 3 && reads_grid(op[0]); k++) x[k] = jet_at(numbers, jet, op[2] + k);
        if (op[0] >= T_SPLINE) y = hm_look_up_jet(op[0], x, numbers + op[3], numbers + op[4]);
        else
            y = hm_operate_jet(op[0], x[0], jet_at(numbers, jet, op[3]),
                               jet_at(numbers, jet, op[4]));
        doubts += is_in_doubt(op[0], x[0], jet_at(numbers, jet, op[3]));
        numbers[op[1]] = y.value;
        jet[2 * op[1]] = y.rate;
        jet[2 * op[1] + 1] = y.bend;
    }
    return doubts;
}

#include "small.h"
