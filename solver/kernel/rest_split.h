/* Forces of contacts at rest, or impulses with the same rates: the least ones inside Coulomb's cones that do together what they must.

       min |x|^2/2,     B x = g,     x_i in K_i = {|x_T| <= c_i x_N},

   x = sqrt(weight) times the forces, B with independent rows. Contacts that hold the same thing twice have many splits; this one is
   that of equally yielding feet, and knows no order of contacts. Its dual has as many unknowns as B has rows, and none of
   them is bounded:

       max_y  y.g - |P_K(B'y)|^2/2,     x = P_K(B'y),

   with the projection P_K on the cones; solved by Newton's semismooth iteration. Without a split the dual grows without bound. */
#ifndef HOLONOM_REST_SPLIT_H
#define HOLONOM_REST_SPLIT_H

#include "cone_projection.h"

typedef struct rest_split {
    int32_t contacts, rows, rank;
    const int32_t *first, *tangents; /* per contact: its normal force; forces of friction that follow it: 0 to 3        */
    const double *coefficient;       /* per contact, >= 0                                                       */
    const double *B, *g;             /* rank x rows, rank; |g| = 1                                              */
    double *force;                   /* rows, overwritten: x                                                    */
    double *dual, *way, *defect, *trial; /* rank each, overwritten                                                */
    double *matrix;                  /* rank x rank, overwritten                                                */
} rest_split;

#define SPLIT_TOLERANCE 1e-13 /* of B x - g                                                                      */
#define SPLIT_ACCEPTED 1e-11  /* likewise, where rounding allows no less                                          */
#define SPLIT_UNBOUNDED 1e8   /* size of a dual that grows without bound                                          */
#define VALUE_ROUNDING 1e-14  /* of values of the dual: near its top they tell no increase, but slopes do (Hager and Zhang 2005)   */

enum { MOST_SPLIT_ITERATIONS = 200 };

/* Forces of the dual y, B x - g in `defect`, and the value of the dual; with `hessian` also its negative second derivatives. */
static double split_of_dual(const rest_split *s, double factor, const double *y, int hessian)
{
    double value = 0.0, slope[MOST_IN_CONE * MOST_IN_CONE];
    for (int32_t k = 0; k < s->rank; k++) value += y[k] * s->g[k];
    for (int32_t k = 0; k < s->rank; k++) s->defect[k] = -s->g[k];
    for (int32_t k = 0; k < s->rank * s->rank && hessian; k++) s->matrix[k] = 0.0;
    for (int32_t i = 0; i < s->contacts; i++) {
        const int32_t first = s->first[i], n = 1 + s->tangents[i];
        double *x = s->force + first;
        for (int32_t l = 0; l < n; l++) {
            x[l] = 0.0;
            for (int32_t k = 0; k < s->rank; k++) x[l] += s->B[s->rows * k + first + l] * y[k];
        }
        project_on_cone(n, factor * s->coefficient[i], x, hessian ? slope : NULL);
        for (int32_t l = 0; l < n; l++) {
            value -= 0.5 * x[l] * x[l];
            for (int32_t k = 0; k < s->rank; k++) s->defect[k] += s->B[s->rows * k + first + l] * x[l];
        }
        for (int32_t k = 0; k < s->rank && hessian; k++)
            for (int32_t l = 0; l < n; l++) {
                double sum = 0.0;
                for (int32_t a = 0; a < n; a++) sum += s->B[s->rows * k + first + a] * slope[n * a + l];
                for (int32_t j = 0; j <= k; j++) s->matrix[s->rank * k + j] += sum * s->B[s->rows * j + first + l];
            }
    }
    return value;
}

/* Solves matrix x = b (both modified) with the matrix symmetric and positive definite, its lower part given. */
static void solve_definite(int32_t n, double *matrix, double *b)
{
    for (int32_t k = 0; k < n; k++) {
        for (int32_t j = 0; j <= k; j++) {
            double sum = matrix[n * k + j];
            for (int32_t a = 0; a < j; a++) sum -= matrix[n * k + a] * matrix[n * j + a];
            matrix[n * k + j] = j < k ? sum / matrix[n * j + j] : sqrt(fmax(sum, 1e-300));
        }
        for (int32_t a = 0; a < k; a++) b[k] -= matrix[n * k + a] * b[a];
        b[k] /= matrix[n * k + k];
    }
    for (int32_t k = n - 1; k >= 0; k--) {
        for (int32_t a = k + 1; a < n; a++) b[k] -= matrix[n * a + k] * b[a];
        b[k] /= matrix[n * k + k];
    }
}

static double largest_of(int32_t n, const double *x)
{
    double largest = 0.0;
    for (int32_t k = 0; k < n; k++) largest = fmax(largest, fabs(x[k]));
    return largest;
}

/* Whether there is a split with coefficients times `factor`; then `force` is the least one. */
static int has_split(const rest_split *s, double factor)
{
    double *y = s->dual;
    for (int32_t k = 0; k < s->rank; k++) y[k] = s->g[k];
    double value = split_of_dual(s, factor, y, 1);
    for (int iteration = 0; iteration < MOST_SPLIT_ITERATIONS; iteration++) {
        double size2 = 0.0, slope = 0.0, next = value, share = 1.0;
        if (largest_of(s->rank, s->defect) < SPLIT_TOLERANCE) return 1;
        for (int32_t k = 0; k < s->rank; k++) size2 += s->defect[k] * s->defect[k];
        for (int32_t k = 0; k < s->rank; k++) {
            s->way[k] = -s->defect[k];
            s->matrix[s->rank * k + k] += 1e-14 + 1e-3 * fmin(1.0, size2);
        }
        solve_definite(s->rank, s->matrix, s->way);
        for (int32_t k = 0; k < s->rank; k++) slope -= s->defect[k] * s->way[k];
        for (; share > 1e-11; share *= 0.5) {
            double ahead = 0.0; /* slope of the dual there */
            for (int32_t k = 0; k < s->rank; k++) s->trial[k] = y[k] + share * s->way[k];
            next = split_of_dual(s, factor, s->trial, 0);
            for (int32_t k = 0; k < s->rank; k++) ahead -= s->defect[k] * s->way[k];
            if (next >= value + 1e-4 * share * slope) break;
            if (next >= value - VALUE_ROUNDING * (1.0 + fabs(value)) && ahead >= -0.9 * slope) break;
        }
        for (int32_t k = 0; k < s->rank; k++) y[k] = s->trial[k];
        value = split_of_dual(s, factor, y, 1);
        if (!(largest_of(s->rank, y) < SPLIT_UNBOUNDED && value < SPLIT_UNBOUNDED)) return 0;
    }
    return largest_of(s->rank, s->defect) < SPLIT_ACCEPTED;
}

#endif
