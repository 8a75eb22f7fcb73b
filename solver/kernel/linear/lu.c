/* Sparse LU factors with a pattern and an elimination order that were fixed when the model was
   assembled.

   The pattern is symmetric, the values are not. Pivot k owns one contiguous piece of `value`:
   [diagonal, U_k1 .. U_km, L_1k .. L_mk]; `column` lists the m later places it is coupled to, and
   `target` says where each of the m*m products of its update goes. No pivoting: a regularised KKT
   matrix whose rows come after one of their nodes is factorisable in any such order (Vanderbei
   1995, quasidefinite matrices). */
#include "internal.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* x[place[i]] -= factor y[i], i = 0 .. m - 1. Most pivots of a chain have one or two neighbours:
   there a loop costs more than what is in it. */
static inline void subtract_products(uint32_t m, const int32_t *place, double factor,
                                     const double *y, double *x)
{
    if (m > 2) {
        uint32_t i = 0;
        for (; i + 1 < m; i += 2) {
            x[place[i]] -= factor * y[i];
            x[place[i + 1]] -= factor * y[i + 1];
        }
        if (i < m) x[place[i]] -= factor * y[i];
        return;
    }
    if (m == 0) return;
    x[place[0]] -= factor * y[0];
    if (m == 2) x[place[1]] -= factor * y[1];
}

/* start - sum of y[i] x[place[i]]. */
static inline double less_products(double start, uint32_t m, const int32_t *place, const double *y,
                                   const double *x)
{
    if (m == 2) return start - y[0] * x[place[0]] - y[1] * x[place[1]];
    for (uint32_t i = 0; i < m; i++) start -= y[i] * x[place[i]];
    return start;
}

static inline uint32_t neighbours(const int32_t *ptr, int32_t k)
{ return ((uint32_t)(ptr[k + 1] - ptr[k]) - 1) >> 1; }

/* Columns of pivot k: those before have one diagonal and two entries a column each. */
static inline const int32_t *columns_of(const int32_t *column, const int32_t *ptr, int32_t k)
{ return column + (ptr[k] - k) / 2; }

/* Pivots begin .. end - 1, an island or all. value (modified): matrix in, factors out, pivots
   inverted; `target` begins at the first pivot. Returns 0, or 1 at a pivot that is zero or not
   finite. */
int32_t hm_lu_factor(const holonom_elimination *lu, int32_t begin, int32_t end,
                     const int32_t *target, double *value)
{
    const int32_t *ptr = lu->lu_ptr;
    for (int32_t k = begin; k < end; k++) {
        double *diagonal = value + ptr[k];
        const uint32_t m = neighbours(ptr, k);
        const double *upper = diagonal + 1;
        double *lower = diagonal + 1 + m;
        if (!(fabs(*diagonal) > 1e-300 && fabs(*diagonal) < 1e300)) return 1;
        const double inverse = 1.0 / *diagonal;
        *diagonal = inverse;
        for (uint32_t i = 0; i < m; i++, target += m)
            subtract_products(m, target, lower[i] *= inverse, upper, value);
    }
    return 0;
}

/* Of pivots begin .. end - 1: which are joined to others, from each one on and back from it. */
static void list_joined(int32_t begin, int32_t end, const live_pivots *x)
{
    for (int32_t k = begin, last = begin - 1; k < end; k++)
        x->before[k] = last = x->count[k] ? k : last;
    for (int32_t k = end, next = end; k-- > begin;) x->next[k] = next = x->count[k] ? k : next;
}

/* Likewise of a matrix most of whose stored entries are 0, since few contacts are closed. Those of
   pivot k that are not go to the front. `x` overwritten. */
int32_t hm_lu_factor_live(const holonom_elimination *lu, int32_t begin, int32_t end,
                          const int32_t *target, double *value, const live_pivots *x)
{
    const int32_t *ptr = lu->lu_ptr, *column = columns_of(lu->lu_column, ptr, begin);
    int32_t *live = x->column + (ptr[begin] - begin) / 2;
    memset(x->count + begin, 0, sizeof(int32_t) * (size_t)(end - begin));
    list_joined(begin, end, x); /* no list of before stays where a pivot fails */
    for (int32_t k = begin; k < end; k++) {
        double *diagonal = value + ptr[k];
        const uint32_t m = neighbours(ptr, k);
        double *upper = diagonal + 1, *lower = diagonal + 1 + m;
        int32_t n = 0;
        if (!(fabs(*diagonal) > 1e-300 && fabs(*diagonal) < 1e300)) return 1;
        const double inverse = 1.0 / *diagonal;
        *diagonal = inverse;
        for (uint32_t i = 0; i < m; i++) {
            if (upper[i] == 0.0 && lower[i] == 0.0) continue;
            upper[n] = upper[i], lower[n] = lower[i] * inverse, live[n++] = (int32_t)i;
        }
        for (int32_t i = 0; i < n; i++)
            for (int32_t j = 0; j < n; j++)
                value[target[(int32_t)m * live[i] + live[j]]] -= lower[i] * upper[j];
        for (int32_t i = 0; i < n; i++) live[i] = column[live[i]];
        x->count[k] = n;
        column += m, live += m, target += m * m;
    }
    list_joined(begin, end, x);
    return 0;
}

/* Solves L U x = rhs in place, of pivots begin .. end - 1; x (all) holds the right-hand side, then
   the solution, in elimination order. */
void hm_lu_solve(const holonom_elimination *lu, int32_t begin, int32_t end, const double *value,
                 double *x)
{
    const int32_t *ptr = lu->lu_ptr, *column = columns_of(lu->lu_column, ptr, begin);
    for (int32_t k = begin; k < end; k++) {
        const uint32_t m = neighbours(ptr, k);
        subtract_products(m, column, x[k], value + ptr[k] + 1 + m, x);
        column += m;
    }
    for (int32_t k = end - 1; k >= begin; k--) {
        const uint32_t m = neighbours(ptr, k);
        column -= m;
        x[k] = less_products(x[k], m, column, value + ptr[k] + 1, x) * value[ptr[k]];
    }
}

/* Likewise with live factors, of one island or several. Pivots of open contacts are joined to none,
   and 0 stays 0. */
void hm_lu_solve_live(const holonom_elimination *lu, int32_t begin, int32_t end,
                      const live_pivots *live, const double *value, double *x)
{
    const int32_t *ptr = lu->lu_ptr;
    for (int32_t k = begin; k < end;) {
        if (live->next[k] != k) {
            k = live->next[k];
            continue;
        }
        subtract_products((uint32_t)live->count[k], columns_of(live->column, ptr, k), x[k],
                          value + ptr[k] + 1 + neighbours(ptr, k), x);
        k++;
    }
    for (int32_t k = begin; k < end; k++)
        if (x[k] != 0.0 && live->next[k] != k) x[k] *= value[ptr[k]];
    for (int32_t k = end - 1; k >= begin;) {
        if (live->before[k] != k) {
            k = live->before[k];
            continue;
        }
        x[k] = less_products(x[k], (uint32_t)live->count[k], columns_of(live->column, ptr, k),
                             value + ptr[k] + 1, x)
               * value[ptr[k]];
        k--;
    }
}
