/* The tape: a list of scalar operations on the vector of numbers. Expressions of a scene are
   compiled to it, so that parameters, inputs and time take effect inside an FMU without any
   expression parser there. */
#include "internal.h"

#include <math.h>

/* What a exceeds a multiple of b by, with the sign of b. */
static double modulo(double a, double b)
{
    const double rest = fmod(a, b);
    if (rest == 0.0) return copysign(0.0, b);
    return (rest < 0.0) != (b < 0.0) ? rest + b : rest;
}

/* min and max hand a NaN on, unlike fmin and fmax: it must be seen, not hidden. */
double hm_operate(int32_t code, double a, double b, double c)
{
    switch (code) {
    case T_COPY: return a;
    case T_ADD: return a + b;
    case T_SUB: return a - b;
    case T_MUL: return a * b;
    case T_DIV: return a / b;
    case T_POW: return hm_pow(a, b);
    case T_NEG: return -a;
    case T_SIN: return hm_sin(a);
    case T_COS: return hm_cos(a);
    case T_TAN: return hm_tan(a);
    case T_ASIN: return hm_asin(a);
    case T_ACOS: return hm_acos(a);
    case T_ATAN: return hm_atan(a);
    case T_ATAN2: return hm_atan2(a, b);
    case T_SQRT: return sqrt(a);
    case T_EXP: return hm_exp(a);
    case T_LOG: return hm_log(a);
    case T_ABS: return fabs(a);
    case T_MIN: return (a <= b || a != a) ? a : b;
    case T_MAX: return (a >= b || a != a) ? a : b;
    case T_SIGN: return a != a ? a : (double)((a > 0.0) - (a < 0.0));
    case T_LT: return (double)(a < b);
    case T_LE: return (double)(a <= b);
    case T_GT: return (double)(a > b);
    case T_GE: return (double)(a >= b);
    case T_EQ: return (double)(a == b);
    case T_NE: return (double)(a != b);
    case T_AND: return (double)(a != 0.0 && b != 0.0);
    case T_OR: return (double)(a != 0.0 || b != 0.0);
    case T_NOT: return (double)(a == 0.0);
    case T_SELECT: return a != 0.0 ? b : c;
    case T_SINH: return hm_sinh(a);
    case T_COSH: return hm_cosh(a);
    case T_TANH: return hm_tanh(a);
    case T_FLOOR: return floor(a);
    case T_CEIL: return ceil(a);
    case T_MOD: return modulo(a, b);
    default: return NAN; /* an unknown code is caught by the check for finite numbers */
    }
}

void hm_run_tape(const holonom_model *model, double *numbers, int32_t segment)
{
    const int32_t *op = model->tape, *length = &model->n_tape_parameters;
    for (int32_t before = 0; before < segment; before++) op += 5 * (int64_t)length[before];
    for (int32_t i = 0; i < length[segment]; i++, op += 5)
        numbers[op[1]] = op[0] < T_SPLINE
                             ? hm_operate(op[0], numbers[op[2]], numbers[op[3]], numbers[op[4]])
                             : hm_look_up(op[0], numbers + op[2], numbers + op[3], numbers + op[4]);
}
