/* Functions of a mechanism's quantities, and their discrete gradients by the chain rule
   (theory 2.5). */
#include "internal.h"

#include <math.h>
#include <string.h>

/* sin(x)/x and sinh(x)/x, whose 0/0 is removable; below 1e-2 the series is exact to the last
   digit. */
static double sinc(double x)
{
    const double x2 = x * x;
    return x2 < 1e-4 ? 1.0 - x2 / 6.0 * (1.0 - x2 / 20.0 * (1.0 - x2 / 42.0)) : hm_sin(x) / x;
}

static double sinhc(double x)
{
    const double x2 = x * x;
    return x2 < 1e-4 ? 1.0 + x2 / 6.0 * (1.0 + x2 / 20.0 * (1.0 + x2 / 42.0)) : hm_sinh(x) / x;
}

/* (tanh x1 - tanh x0)/(x1 - x0) = sinhc(dx)/(cosh x0 cosh x1); a long step loses no digits by the
   difference. */
HM_SELDOM static double tanh_slope(double x0, double x1, double dx)
{
    return fabs(dx) > 1.0 ? (hm_tanh(x1) - hm_tanh(x0)) / dx
                          : 2.0 * sinhc(dx) / (hm_cosh(x0 + x1) + hm_cosh(dx));
}

/* (log x1 - log x0)/(x1 - x0), both positive: 2 atanh(z)/dx with z = dx/(x0 + x1). */
HM_SELDOM static double log_slope(double x0, double x1, double dx)
{
    const double sum = x0 + x1, z = dx / sum, z2 = z * z;
    if (z2 > 0.98)
        return (hm_log(x1) - hm_log(x0))
               / dx; /* nothing cancels where one is far larger; 1 - z would */
    const double ratio =
        z2 < 1e-4 ? 1.0 + z2 * (1.0 / 3.0 + z2 * (0.2 + z2 / 7.0)) : hm_atanh(z) / z;
    return 2.0 * ratio / sum;
}

/* (asin x1 - asin x0)/(x1 - x0): the sine of the difference, x1 c0 - x0 c1, is dx times `ratio`,
   since c1 - c0 = -dx (x0 + x1)/(c0 + c1). */
HM_SELDOM static double asin_slope(double x0, double x1, double dx)
{
    const double c0 = sqrt((1.0 - x0) * (1.0 + x0)), c1 = sqrt((1.0 - x1) * (1.0 + x1));
    const double ratio = 0.5 * (c0 + c1) + 0.5 * (x0 + x1) * (x0 + x1) / (c0 + c1);
    return hm_angle_over(dx * ratio, c0 * c1 + x0 * x1) * ratio;
}

/* (x1^n - x0^n)/(x1 - x0) for a whole number n: a sum of products, or of 1/x. */
static double whole_power_slope(double x0, double x1, int n)
{
    if (n < 0) return -whole_power_slope(x0, x1, -n) / (hm_pow(x0, -n) * hm_pow(x1, -n));
    double sum = 0.0, power = 1.0; /* Horner's rule for sum_k x1^k x0^(n-1-k) */
    for (int k = 0; k < n; k++) {
        sum = sum * x1 + power;
        power *= x0;
    }
    return sum;
}

/* Slopes of pow with respect to base and exponent: x^y = exp(y log x). */
HM_SELDOM static void power_slopes(double x0, double x1, double dx, double y0, double y1, double dy,
                                   double *slope)
{
    if (dy == 0.0 && y0 == floor(y0) && fabs(y0) <= 16.0) {
        slope[0] = whole_power_slope(x0, x1, (int)y0);
        slope[1] = x0 > 0.0 ? hm_pow(x0, y0) * hm_log(x0) : 0.0;
        return;
    }
    if (dy == 0.0 && y0 > 1.0 && x0 >= 0.0 && x1 >= 0.0
        && (x0 == 0.0 || x1 == 0.0)) { /* 0 has no logarithm */
        slope[0] = x0 + x1 > 0.0 ? hm_pow(x0 + x1, y0 - 1.0) : 0.0;
        slope[1] = 0.0;
        return;
    }
    const double l0 = hm_log(x0), l1 = hm_log(x1), per_x = log_slope(x0, x1, dx), dl = per_x * dx;
    const double middle = 0.5 * (y0 * l0 + y1 * l1),
                 change = 0.5 * ((y0 + y1) * dl + (l0 + l1) * dy);
    const double outer = hm_exp(middle) * sinhc(0.5 * change);
    slope[0] = outer * 0.5 * (y0 + y1) * per_x;
    slope[1] = outer * 0.5 * (l0 + l1);
}

static double abs_slope(double x0, double x1)
{
    const double sum = fabs(x0) + fabs(x1);
    return sum > 0.0 ? (x0 + x1) / sum : 0.0;
}

typedef struct argument {
    double x0, x1, dx, mean;
} argument;

HM_OFTEN argument argument_of(int32_t place, const double *numbers, const hm_registers *r)
{
    if (place < 0)
        return (argument){numbers[-1 - place], numbers[-1 - place], 0.0, numbers[-1 - place]};
    return (argument){r->r0[place], r->r1[place], r->dr[place],
                      0.5 * (r->r0[place] + r->r1[place])};
}

/* Slopes of one operation with respect to its first two arguments. Comparisons, sign, conditions
   and what rounds have none: the reader keeps them away from what moves. */
static void operation_slopes(int32_t code, const argument *a, const argument *b, double f0,
                             double f1, double *slope)
{
    slope[0] = slope[1] = 0.0;
    switch (code) {
    case T_COPY: slope[0] = 1.0; break;
    case T_NEG: slope[0] = -1.0; break;
    case T_ADD: slope[0] = slope[1] = 1.0; break;
    case T_SUB: slope[0] = 1.0; slope[1] = -1.0; break;
    case T_MUL: slope[0] = b->mean; slope[1] = a->mean; break;
    case T_DIV: slope[0] = b->mean / (b->x0 * b->x1); slope[1] = -a->mean / (b->x0 * b->x1); break;
    case T_POW: power_slopes(a->x0, a->x1, a->dx, b->x0, b->x1, b->dx, slope); break;
    case T_SIN: slope[0] = hm_cos(a->mean) * sinc(0.5 * a->dx); break;
    case T_COS: slope[0] = -hm_sin(a->mean) * sinc(0.5 * a->dx); break;
    case T_TAN: slope[0] = sinc(a->dx) / (hm_cos(a->x0) * hm_cos(a->x1)); break;
    case T_ASIN: slope[0] = asin_slope(a->x0, a->x1, a->dx); break;
    case T_ACOS: slope[0] = -asin_slope(a->x0, a->x1, a->dx); break;
    case T_ATAN: slope[0] = hm_angle_over(a->dx, 1.0 + a->x0 * a->x1); break;
    case T_ATAN2: {
        const double factor =
            hm_angle_over(b->mean * a->dx - a->mean * b->dx, b->x0 * b->x1 + a->x0 * a->x1);
        slope[0] = factor * b->mean;
        slope[1] = -factor * a->mean;
        break;
    }
    case T_SQRT: slope[0] = 1.0 / (f0 + f1); break;
    case T_EXP: slope[0] = hm_exp(a->mean) * sinhc(0.5 * a->dx); break;
    case T_LOG: slope[0] = log_slope(a->x0, a->x1, a->dx); break;
    case T_SINH: slope[0] = hm_cosh(a->mean) * sinhc(0.5 * a->dx); break;
    case T_COSH: slope[0] = hm_sinh(a->mean) * sinhc(0.5 * a->dx); break;
    case T_TANH: slope[0] = tanh_slope(a->x0, a->x1, a->dx); break;
    case T_ABS: slope[0] = abs_slope(a->x0, a->x1); break;
    case T_MIN: case T_MAX: {
        const double half = 0.5 * abs_slope(a->x0 - b->x0, a->x1 - b->x1),
                     sign = code == T_MAX ? 1.0 : -1.0;
        slope[0] = 0.5 + sign * half;
        slope[1] = 0.5 - sign * half;
        break;
    }
    default: break;
    }
}

static inline int is_arithmetic(const int32_t *op)
{ return op[0] == T_ADD || op[0] == T_SUB || op[0] == T_MUL; }

HM_OFTEN double number_or_register(int32_t place, const double *numbers, const double *x)
{ return place < 0 ? numbers[-1 - place] : x[place]; }

/* Value of an operation of any kind where registers have the values x. */
static double value_of(const int32_t *op, const double *numbers, const double *x)
{
    const double first = number_or_register(op[1], numbers, x);
    if (op[0] >= T_SPLINE)
        return hm_look_up(op[0], op[1] < 0 ? &first : x + op[1], numbers - 1 - op[2],
                          numbers - 1 - op[3]);
    return hm_operate(op[0], first, number_or_register(op[2], numbers, x),
                      number_or_register(op[3], numbers, x));
}

/* Slopes of the operation of register `at`, of any kind, whose values are known. */
static void find_slopes(const int32_t *op, int32_t at, const double *numbers, const hm_registers *r)
{
    double *slope = r->slope + 3 * at;
    const double *first = numbers - 1 - op[2],
                 *end = numbers - 1 - op[3]; /* of a table among the numbers */
    if (reads_grid(op[0])) { /* of three registers one behind the other */
        hm_grid_slopes(op[0] - T_GRID, r->r0 + op[1], r->r1 + op[1], first, end, slope);
        return;
    }
    const argument a = argument_of(op[1], numbers, r);
    if (op[0] >= T_SPLINE) {
        slope[0] = hm_spline_slope(op[0] - T_SPLINE, a.x0, a.x1, first, end);
        slope[1] = 0.0;
    } else if (op[0] == T_SELECT) { /* its condition does not move: the branch taken is linear */
        slope[0] = a.x0 != 0.0 ? 1.0 : 0.0;
        slope[1] = 1.0 - slope[0];
    } else {
        const argument b = argument_of(op[2], numbers, r);
        operation_slopes(op[0], &a, &b, r->r0[at], r->r1[at], slope);
    }
}

/* Arguments of an operation that it has slopes with respect to: two, or below 0. Grids have three
   registers. */
static inline int32_t first_argument(const int32_t *op)
{ return op[0] == T_SELECT ? op[2] : op[1]; }
static inline int32_t second_argument(const int32_t *op)
{ return op[0] >= T_SPLINE ? -1 : op[0] == T_SELECT ? op[3] : op[2]; }

/* Operation of register `at` at both ends, its slopes and its change, of any kind. */
static void run_operation(const int32_t *op, int32_t at, const double *numbers,
                          const hm_registers *r)
{
    const double *slope = r->slope + 3 * at;
    const int32_t first = first_argument(op), second = second_argument(op);
    r->r0[at] = value_of(op, numbers, r->r0);
    r->r1[at] = value_of(op, numbers, r->r1);
    find_slopes(op, at, numbers, r);
    r->dr[at] = 0.0;
    if (reads_grid(op[0])) {
        for (int k = 0; k < 3; k++) r->dr[at] += slope[k] * r->dr[first + k];
        return;
    }
    if (op[0] == T_SELECT)
        r->dr[at] = slope[0] != 0.0 ? (first < 0 ? 0.0 : r->dr[first])
                    : second < 0    ? 0.0
                                    : r->dr[second];
    else
        r->dr[at] = (first >= 0 ? slope[0] * r->dr[first] : 0.0)
                    + (second >= 0 ? slope[1] * r->dr[second] : 0.0);
}

/* Likewise of a sum, a difference or a product, as most are. */
HM_OFTEN void run_arithmetic(const int32_t *op, int32_t at, const double *numbers,
                             const hm_registers *r)
{
    const int32_t i = op[1], k = op[2];
    const double a0 = i < 0 ? numbers[-1 - i] : r->r0[i], a1 = i < 0 ? a0 : r->r1[i];
    const double b0 = k < 0 ? numbers[-1 - k] : r->r0[k], b1 = k < 0 ? b0 : r->r1[k];
    double *slope = r->slope + 3 * at;
    if (op[0] == T_MUL) {
        r->r0[at] = a0 * b0;
        r->r1[at] = a1 * b1;
        slope[0] = 0.5 * (b0 + b1);
        slope[1] = 0.5 * (a0 + a1);
    } else {
        const double sign = op[0] == T_ADD ? 1.0 : -1.0;
        r->r0[at] = a0 + sign * b0;
        r->r1[at] = a1 + sign * b1;
        slope[0] = 1.0;
        slope[1] = sign;
    }
    r->dr[at] = (i >= 0 ? slope[0] * r->dr[i] : 0.0) + (k >= 0 ? slope[1] * r->dr[k] : 0.0);
}

/* Adds the slope of an operation, `adjoint`, times its slopes with respect to its arguments to
   theirs. */
HM_OFTEN void pass_back(const int32_t *op, int32_t at, const hm_registers *r)
{
    const double adjoint = r->adjoint[at], *slope = r->slope + 3 * at;
    const int32_t first = first_argument(op), second = second_argument(op);
    if (first >= 0) r->adjoint[first] += adjoint * slope[0];
    if (second >= 0) r->adjoint[second] += adjoint * slope[1];
    for (int k = 1; k < 3 && reads_grid(op[0]); k++) r->adjoint[first + k] += adjoint * slope[k];
}

#define MANY_REGISTERS 8 /* for which a call of memset pays */

HM_OFTEN void start_adjoints(int32_t count, const hm_registers *r)
{
    if (count > MANY_REGISTERS) memset(r->adjoint, 0, sizeof(double) * (size_t)count);
    else
        for (int32_t i = 0; i < count; i++) r->adjoint[i] = 0.0;
    r->adjoint[count - 1] = 1.0;
}

double hm_value(const int32_t *operation, int32_t n_leaves, int32_t n_operations, int32_t known,
                const double *numbers, double *x)
{
    const int32_t *op = operation + 4 * (int64_t)known,
                  *end = operation + 4 * (int64_t)n_operations;
    double *result = x + n_leaves + known;
    for (; op < end; op += 4) {
        if (!is_arithmetic(op)) {
            *result++ = value_of(op, numbers, x);
            continue;
        }
        const double a = number_or_register(op[1], numbers, x),
                     b = number_or_register(op[2], numbers, x);
        if (op[0] == T_MUL) *result++ = a * b;
        else *result++ = op[0] == T_ADD ? a + b : a - b;
    }
    return result[-1];
}

void hm_gradient(const int32_t *operation, int32_t n_leaves, int32_t n_operations, int32_t still,
                 const double *numbers, const hm_registers *r)
{
    const hm_registers one = {r->r0, r->r0, r->dr, r->adjoint, r->slope}; /* both ends are one */
    const double *x = r->r0;
    double *adjoint = r->adjoint, *own = adjoint + n_leaves + n_operations;
    start_adjoints(n_leaves + n_operations, r);
    for (const int32_t *op = operation + 4 * (int64_t)n_operations,
                       *end = operation + 4 * (int64_t)still;
         op > end;) {
        op -= 4;
        const double slope = *--own;
        const int32_t i = op[1], k = op[2];
        if (op[0] == T_MUL) {
            if (i >= 0) adjoint[i] += slope * number_or_register(k, numbers, x);
            if (k >= 0) adjoint[k] += slope * number_or_register(i, numbers, x);
        } else if (is_arithmetic(op)) {
            if (i >= 0) adjoint[i] += slope;
            if (k >= 0) adjoint[k] += op[0] == T_ADD ? slope : -slope;
        } else {
            if (i >= 0) r->dr[i] = 0.0;
            if (k >= 0) r->dr[k] = 0.0;
            find_slopes(op, (int32_t)(own - adjoint), numbers, &one);
            pass_back(op, (int32_t)(own - adjoint), r);
        }
    }
}

int32_t hm_discrete_gradient(const int32_t *operation, int32_t n_leaves, int32_t n_operations,
                             const double *numbers, const hm_registers *r)
{
    const int32_t count = n_leaves + n_operations;
    int moves = 0;
    for (int32_t i = 0; i < n_leaves && !moves; i++)
        moves = r->dr[i] != 0.0 || r->r0[i] != r->r1[i];
    if (!moves) {
        for (int32_t i = n_leaves; i < count; i++) r->dr[i] = 0.0;
        hm_value(operation, n_leaves, n_operations, 0, numbers, r->r0);
        hm_gradient(operation, n_leaves, n_operations, 0, numbers, r);
        return count - 1;
    }
    for (int32_t at = n_leaves; at < count; at++) {
        const int32_t *op = operation + 4 * (at - n_leaves);
        if (is_arithmetic(op)) run_arithmetic(op, at, numbers, r);
        else run_operation(op, at, numbers, r);
    }
    start_adjoints(count, r);
    for (int32_t at = count - 1; at >= n_leaves; at--)
        pass_back(operation + 4 * (at - n_leaves), at, r);
    return count - 1;
}
