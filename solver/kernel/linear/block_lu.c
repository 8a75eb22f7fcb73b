/* Sparse LU factors of groups of pivots with nearly the same pattern, as bodies and their joints
   make; zeros fill it.

   A group of p pivots coupled to m later places, an even number, owns one piece of `value`: the
   block D (p x p, row by row), then U and L, of each two later places the entries of one pivot
   after the other. So what two places need is found, and computed, side by side. Factors are those
   of D, in its place, U itself, and L D^-1. `target` has m x m places for each group. Where the
   last place is listed twice, its second entries are 0. Orders and pivots are as in lu.c. */
#if DIM == 3
#include "articulated.h"
#endif
#include "holonom.h"
#include "internal.h"
#include "lanes.h"

#include <math.h>

#if defined(__GNUC__) && !defined(__clang__)
#define UNROLL _Pragma("GCC unroll 5")
#else
#define UNROLL
#endif

_Static_assert(MOST_IN_GROUP == 5, "groups of these sizes are compiled");

/* x[place[i]] -= the sum of a_k b_ki, k < p, of two places. */
HM_OFTEN void subtract_from_two(const int p, const lanes *a, const double *b, const int32_t *place,
                                double *x)
{
    lanes sum = lanes_times(a[0], lanes_at(b));
    UNROLL
    for (int k = 1; k < p; k++) sum = lanes_plus(sum, a[k], lanes_at(b + 2 * k));
    x[place[0]] -= LANE(sum, 0);
    x[place[1]] -= LANE(sum, 1);
}

/* One group. These functions are compiled for each p, with what is used again in registers. */
HM_OFTEN int factor_group(const int p, int32_t m, double *D, const int32_t *target, double *value)
{
    double *const U = D + p * p, *const L = U + p * m;
    lanes x[MOST_IN_GROUP];
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
    for (double *l = L; l < L + p * m; l += 2 * p) {
        UNROLL
        for (int k = 0; k < p; k++) {
            x[k] = lanes_at(l + 2 * k);
            UNROLL
            for (int j = 0; j < k; j++) x[k] = lanes_less(x[k], both_lanes(D[p * j + k]), x[j]);
            x[k] = lanes_times(both_lanes(D[p * k + k]), x[k]);
        }
        UNROLL
        for (int k = p - 1; k >= 0; k--) {
            UNROLL
            for (int j = k + 1; j < p; j++) x[k] = lanes_less(x[k], both_lanes(D[p * j + k]), x[j]);
            put_lanes(l + 2 * k, x[k]);
        }
        for (int lane = 0; lane < 2; lane++) {
            UNROLL
            for (int k = 0; k < p; k++) x[k] = both_lanes(l[2 * k + lane]);
            for (const double *u = U; u < L; u += 2 * p, target += 2)
                subtract_from_two(p, x, u, target, value);
        }
    }
    return 0;
}

HM_OFTEN void reduce_group(const int p, int32_t m, const double *D, const int32_t *column,
                           const double *y, double *x)
{
    const double *l = D + p * p + p * m;
    lanes own[MOST_IN_GROUP];
    UNROLL
    for (int k = 0; k < p; k++) own[k] = both_lanes(y[k]);
    for (int32_t i = 0; i < m; i += 2, l += 2 * p) subtract_from_two(p, own, l, column + i, x);
}

HM_OFTEN void solve_group(const int p, int32_t m, const double *D, const int32_t *column, double *y,
                          const double *x)
{
    const double *u = D + p * p;
    lanes sum[MOST_IN_GROUP];
    double own[MOST_IN_GROUP];
    UNROLL
    for (int k = 0; k < p; k++) sum[k] = lanes_of(y[k], 0.0);
    for (int32_t j = 0; j < m; j += 2, u += 2 * p) {
        const lanes other = lanes_of(x[column[j]], x[column[j + 1]]);
        UNROLL
        for (int k = 0; k < p; k++) sum[k] = lanes_less(sum[k], lanes_at(u + 2 * k), other);
    }
    UNROLL
    for (int k = 0; k < p; k++) {
        own[k] = LANE(sum[k], 0) + LANE(sum[k], 1);
        UNROLL
        for (int j = 0; j < k; j++) own[k] -= D[p * k + j] * own[j];
    }
    UNROLL
    for (int k = p - 1; k >= 0; k--) {
        UNROLL
        for (int j = k + 1; j < p; j++) own[k] -= D[p * k + j] * own[j];
        y[k] = own[k] *= D[p * k + k];
    }
}

/* A group of a body and a joint with a axes has 9 + a pivots. */
#define OF_SIZE(p, call, of_joint)                                                                 \
    switch (p) {                                                                                   \
    case 1: call(1); break;                                                                        \
    case 2: call(2); break;                                                                        \
    case 3: call(3); break;                                                                        \
    case 4: call(4); break;                                                                        \
    case 5: call(5); break;                                                                        \
    default: of_joint;                                                                             \
    }
#if DIM == 3
#define BY_JOINT(name, ...)                                                                        \
    (p == LEAST_WITH_JOINT + HINGE ? name##_joint(HINGE, __VA_ARGS__)                              \
                                   : name##_other_joint(p - LEAST_WITH_JOINT, __VA_ARGS__))
#define FACTOR_JOINT fails = BY_JOINT(factor, m, group[2], D, target, value)
#define REDUCE_JOINT BY_JOINT(reduce, m, group[2], D, column, x + group[0], x)
#define SOLVE_JOINT BY_JOINT(solve, m, group[2], D, column, x + group[0], x)
#else
#define FACTOR_JOINT fails = 1
#define REDUCE_JOINT break
#define SOLVE_JOINT break
#endif

/* Groups of islands first .. last - 1. value (modified): matrix in, factors out, pivots inverted.
   Returns 0, or 1 at a pivot that is zero or not finite. */
int32_t hm_block_factor(const holonom_elimination *lu, int32_t first, int32_t last, double *value)
{
    const int32_t *begin = lu->lu_island + 4 * first,
                  *end = lu->lu_group + 3 * lu->lu_island[4 * last + 1];
    const int32_t *group = lu->lu_group + 3 * begin[1], *target = lu->lu_target + begin[2];
    double *D = value + lu->lu_ptr[begin[0]];
    for (; group < end; group += 3) {
        const int32_t p = group[3] - group[0], m = group[1];
        int fails;
#define FACTOR(p) fails = factor_group(p, m, D, target, value)
        OF_SIZE(p, FACTOR, FACTOR_JOINT)
        if (fails) return 1;
        target += m * m;
        D += p * (p + 2 * m);
    }
    return 0;
}

/* Replaces the right-hand side x by the solution, in elimination order. */
void hm_block_solve(const holonom_elimination *lu, int32_t first, int32_t last, const double *value,
                    double *x)
{
    const int32_t *begin = lu->lu_island + 4 * first,
                  *end = lu->lu_group + 3 * lu->lu_island[4 * last + 1];
    const int32_t *group = lu->lu_group + 3 * begin[1], *column = lu->lu_column + begin[3];
    const double *D = value + lu->lu_ptr[begin[0]];
    for (; group < end; group += 3) {
        const int32_t p = group[3] - group[0], m = group[1];
#define REDUCE(p) reduce_group(p, m, D, column, x + group[0], x)
        OF_SIZE(p, REDUCE, REDUCE_JOINT)
        column += m;
        D += p * (p + 2 * m);
    }
    while (group > lu->lu_group + 3 * begin[1]) {
        group -= 3;
        const int32_t p = group[3] - group[0], m = group[1];
        column -= m;
        D -= p * (p + 2 * m);
#define SOLVE(p) solve_group(p, m, D, column, x + group[0], x)
        OF_SIZE(p, SOLVE, SOLVE_JOINT)
    }
}
