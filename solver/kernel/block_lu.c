/* Sparse LU factors of groups of pivots with nearly the same pattern, as bodies and their joints make; zeros fill it.

   A group of p pivots coupled to m later places owns one piece of `value`: the block D (p x p, row by row), the columns
   of U, p entries for each later place, and the rows of L, likewise. `target` has m x m places for each group. So each
   of p products finds its operands side by side, and one place. Orders and pivots are as in lu.c.               */
#include "holonom.h"
#include "internal.h"

#include <math.h>

#if defined(__GNUC__) && !defined(__clang__)
#define UNROLL _Pragma("GCC unroll 6")
#else
#define UNROLL
#endif

_Static_assert(MOST_IN_GROUP == 6, "groups of these sizes are compiled");

/* One group. These functions are compiled for each p, with what is used again in registers.                     */
HM_OFTEN int factor_group(const int p, int32_t m, double *D, const int32_t *target, double *value)
{
    double *const U = D + p * p, *const L = U + p * m;
    UNROLL
    for (int k = 0; k < p; k++) {
        double *row = D + p * k;
        if (!(fabs(row[k]) > 1e-300 && fabs(row[k]) < 1e300)) return 1;
        row[k] = 1.0 / row[k];
        UNROLL
        for (int i = k + 1; i < p; i++) {
            const double factor = D[p * i + k] *= row[k];
            UNROLL
            for (int j = k + 1; j < p; j++) D[p * i + j] -= factor * row[j];
        }
    }
    for (double *u = U; p > 1 && u < L; u += p)
        UNROLL
        for (int k = 0; k < p; k++)
            UNROLL
            for (int i = k + 1; i < p; i++) u[i] -= D[p * i + k] * u[k];
    for (double *l = L; l < L + p * m; l += p) {
        double x[MOST_IN_GROUP];
        UNROLL
        for (int k = 0; k < p; k++) {
            double sum = l[k];
            UNROLL
            for (int j = 0; j < k; j++) sum -= x[j] * D[p * j + k];
            l[k] = x[k] = sum * D[p * k + k];
        }
        for (const double *u = U; u < L; u += p) {
            double sum = x[0] * u[0];
            UNROLL
            for (int k = 1; k < p; k++) sum += x[k] * u[k];
            value[*target++] -= sum;
        }
    }
    return 0;
}

HM_OFTEN void reduce_group(const int p, int32_t m, const double *D, const int32_t *column, double *y, double *x)
{
    const double *l = D + p * p + p * m;
    double own[MOST_IN_GROUP];
    UNROLL
    for (int k = 0; k < p; k++) {
        double sum = y[k];
        UNROLL
        for (int j = 0; j < k; j++) sum -= D[p * k + j] * own[j];
        y[k] = own[k] = sum;
    }
    for (int32_t i = 0; i < m; i++, l += p) {
        double sum = l[0] * own[0];
        UNROLL
        for (int k = 1; k < p; k++) sum += l[k] * own[k];
        x[column[i]] -= sum;
    }
}

HM_OFTEN void solve_group(const int p, int32_t m, const double *D, const int32_t *column, double *y, const double *x)
{
    const double *u = D + p * p;
    double own[MOST_IN_GROUP];
    UNROLL
    for (int k = 0; k < p; k++) own[k] = y[k];
    for (int32_t j = 0; j < m; j++, u += p) {
        const double other = x[column[j]];
        UNROLL
        for (int k = 0; k < p; k++) own[k] -= u[k] * other;
    }
    UNROLL
    for (int k = p - 1; k >= 0; k--) {
        UNROLL
        for (int j = k + 1; j < p; j++) own[k] -= D[p * k + j] * own[j];
        y[k] = own[k] *= D[p * k + k];
    }
}

#define OF_SIZE(p, call)                                                                                       \
    switch (p) {                                                                                               \
    case 1: call(1); break;                                                                                    \
    case 2: call(2); break;                                                                                    \
    case 3: call(3); break;                                                                                    \
    case 4: call(4); break;                                                                                    \
    case 5: call(5); break;                                                                                    \
    default: call(6);                                                                                          \
    }

/* Groups of islands first .. last - 1. value (modified): matrix in, factors out, pivots inverted. Returns 0, or 1 at a
   pivot that is zero or not finite. */
int32_t hm_block_factor(const holonom_elimination *lu, int32_t first, int32_t last, double *value)
{
    const int32_t *begin = lu->lu_island + 4 * first, *end = lu->lu_group + 2 * lu->lu_island[4 * last + 1];
    const int32_t *group = lu->lu_group + 2 * begin[1], *target = lu->lu_target + begin[2];
    double *D = value + lu->lu_ptr[begin[0]];
    for (; group < end; group += 2) {
        const int32_t p = group[2] - group[0], m = group[1];
        int fails;
#define FACTOR(p) fails = factor_group(p, m, D, target, value)
        OF_SIZE(p, FACTOR)
        if (fails) return 1;
        target += m * m;
        D += p * (p + 2 * m);
    }
    return 0;
}

/* Replaces the right-hand side x by the solution, in elimination order. */
void hm_block_solve(const holonom_elimination *lu, int32_t first, int32_t last, const double *value, double *x)
{
    const int32_t *begin = lu->lu_island + 4 * first, *end = lu->lu_group + 2 * lu->lu_island[4 * last + 1];
    const int32_t *group = lu->lu_group + 2 * begin[1], *column = lu->lu_column + begin[3];
    const double *D = value + lu->lu_ptr[begin[0]];
    for (; group < end; group += 2) {
        const int32_t p = group[2] - group[0], m = group[1];
#define REDUCE(p) reduce_group(p, m, D, column, x + group[0], x)
        OF_SIZE(p, REDUCE)
        column += m;
        D += p * (p + 2 * m);
    }
    while (group > lu->lu_group + 2 * begin[1]) {
        group -= 2;
        const int32_t p = group[2] - group[0], m = group[1];
        column -= m;
        D -= p * (p + 2 * m);
#define SOLVE(p) solve_group(p, m, D, column, x + group[0], x)
        OF_SIZE(p, SOLVE)
    }
}
