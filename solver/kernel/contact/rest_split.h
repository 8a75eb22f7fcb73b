/* Forces of contacts at rest, or impulses with the same rates: the least ones inside Coulomb's
   cones that do together what they must.

       min |x|^2/2,     B x = g,     x_i in K_i = {|x_T| <= c_i x_N},

   x = sqrt(weight) times the forces, B with independent rows. Contacts that hold the same thing
   twice have many splits; this one is that of equally yielding feet, and knows no order of
   contacts. Its dual has as many unknowns as B has rows, and none of them is bounded:

       max_y  y.g - |P_K(B'y)|^2/2,     x = P_K(B'y),

   with the projection P_K on the cones; solved by Newton's semismooth iteration. Without a split
   the dual grows without bound. */
#ifndef HOLONOM_REST_SPLIT_H
#define HOLONOM_REST_SPLIT_H

#include "cone_projection.h"

typedef struct rest_split {
    int32_t contacts, rows, rank;
    const int32_t *first,
        *tangents; /* per contact: its normal force; forces of friction that follow it: 0 to 3 */
    const double *coefficient;       /* per contact, >= 0 */
    const double *B, *g;             /* rank x rows, rank; |g| = 1 */
    double *force, *base;            /* rows each, overwritten: x, and what it is near to */
    double *dual, *way, *defect, *trial; /* rank each, overwritten */
    double *matrix;                  /* rank x rank, overwritten */
} rest_split;

#define SPLIT_TOLERANCE 1e-13 /* of B x - g, over the forces */
#define SPLIT_ACCEPTED 1e-11  /* likewise, where rounding allows no less */
#define LARGEST_SPLIT 1e8     /* of forces over the load: what needs larger ones is not held */
#define STEEP 0.5 /* part of the slope at which the dual is left to rise: a longer way is tried */
#define BACK 0.1              /* likewise, to fall: a shorter one */
#define DUAL_ROUNDING 2e-16   /* of the dual */
#define LONGEST_WAY 1e20      /* over a step of Newton's iteration */

enum { MOST_SPLIT_ITERATIONS = 200, MOST_SHARES = 80, MOST_BASES = 4 };

/* Forces of the dual y, B x - g in `defect`; with `hessian` also the negative second derivatives of
   the dual. */
static void split_of_dual(const rest_split *s, double factor, const double *y, int hessian)
{
    double slope[MOST_IN_CONE * MOST_IN_CONE];
    for (int32_t k = 0; k < s->rank; k++) s->defect[k] = -s->g[k];
    for (int32_t k = 0; k < s->rank * s->rank && hessian; k++) s->matrix[k] = 0.0;
    for (int32_t i = 0; i < s->contacts; i++) {
        const int32_t first = s->first[i], n = 1 + s->tangents[i];
        double *x = s->force + first;
        for (int32_t l = 0; l < n; l++) {
            x[l] = s->base[first + l];
            for (int32_t k = 0; k < s->rank; k++) x[l] += s->B[s->rows * k + first + l] * y[k];
        }
        project_on_cone(n, factor * s->coefficient[i], x, hessian ? slope : NULL);
        for (int32_t l = 0; l < n; l++)
            for (int32_t k = 0; k < s->rank; k++)
                s->defect[k] += s->B[s->rows * k + first + l] * x[l];
        for (int32_t k = 0; k < s->rank && hessian; k++)
            for (int32_t l = 0; l < n; l++) {
                double sum = 0.0;
                for (int32_t a = 0; a < n; a++)
                    sum += s->B[s->rows * k + first + a] * slope[n * a + l];
                for (int32_t j = 0; j <= k; j++)
                    s->matrix[s->rank * k + j] += sum * s->B[s->rows * j + first + l];
            }
    }
}

/* Solves matrix x = b (both modified) with the matrix symmetric and positive definite, its lower
   part given. */
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

/* Whether forces inside the cones, if there are some, are larger than LARGEST_SPLIT: of each g.y =
   x.B'y <= |x| |P_K(B'y)|. */
static int is_unbounded(const rest_split *s, double factor, const double *y)
{
    double along = 0.0, size2 = 0.0;
    for (int32_t k = 0; k < s->rank; k++) along += y[k] * s->g[k];
    for (int32_t i = 0; i < s->contacts; i++) {
        double x[MOST_IN_CONE];
        for (int32_t l = 0; l <= s->tangents[i]; l++) {
            x[l] = 0.0;
            for (int32_t k = 0; k < s->rank; k++)
                x[l] += s->B[s->rows * k + s->first[i] + l] * y[k];
        }
        project_on_cone(1 + s->tangents[i], factor * s->coefficient[i], x, NULL);
        for (int32_t l = 0; l <= s->tangents[i]; l++) size2 += x[l] * x[l];
    }
    return along > LARGEST_SPLIT * sqrt(size2);
}

/* Moves the dual y on along `way`, to about where it rises no more. Its slope there falls all the
   way: slopes are compared alone, since values near the top tell no increase (Hager and Zhang
   2005). */
static void climb(const rest_split *s, double factor, double *y)
{
    double slope = 0.0, low = 0.0, high = INFINITY, share = 1.0;
    for (int32_t k = 0; k < s->rank; k++) slope -= s->defect[k] * s->way[k];
    for (int trial = 0; trial < MOST_SHARES; trial++) {
        double ahead = 0.0; /* slope there */
        for (int32_t k = 0; k < s->rank; k++) s->trial[k] = y[k] + share * s->way[k];
        split_of_dual(s, factor, s->trial, 0);
        for (int32_t k = 0; k < s->rank; k++) ahead -= s->defect[k] * s->way[k];
        if (ahead > STEEP * slope && share < LONGEST_WAY) low = share;
        else if (ahead < -BACK * slope) high = share;
        else break;
        share = high < INFINITY ? 0.5 * (low + high) : 8.0 * share;
    }
    for (int32_t k = 0; k < s->rank; k++) y[k] = s->trial[k];
}

static double largest_of(int32_t n, const double *x)
{
    double largest = 0.0;
    for (int32_t k = 0; k < n; k++) largest = fmax(largest, fabs(x[k]));
    return largest;
}

/* Whether B x - g is no more than this part of the forces, or of the load. */
static int is_split(const rest_split *s, double tolerance)
{
    const double most = tolerance * fmax(1.0, largest_of(s->rows, s->force));
    for (int32_t k = 0; k < s->rank; k++)
        if (!(fabs(s->defect[k]) < most)) return 0; /* nor is what is not a number */
    return 1;
}

/* Newton's iteration for the forces nearest to `base`: 1: found, -1: there are none, 0: rounding
   ends it before. */
static int iterate_split(const rest_split *s, double factor)
{
    double *y = s->dual;
    for (int iteration = 0; iteration < MOST_SPLIT_ITERATIONS; iteration++) {
        double size2 = 0.0;
        split_of_dual(s, factor, y, 1);
        if (is_split(s, SPLIT_TOLERANCE)) return 1;
        if (is_unbounded(s, factor, y)) return -1;
        for (int32_t k = 0; k < s->rank; k++) size2 += s->defect[k] * s->defect[k];
        if (size2 < hm_square(DUAL_ROUNDING * largest_of(s->rank, y))) return 0;
        for (int32_t k = 0; k < s->rank; k++) {
            s->way[k] = -s->defect[k];
            s->matrix[s->rank * k + k] += 1e-14 + 1e-3 * fmin(1.0, size2);
        }
        solve_definite(s->rank, s->matrix, s->way);
        climb(s, factor, y);
    }
    return 0;
}

/* Whether there is a split with coefficients times `factor`; then `force` is the least one. Where
   cones nearly close around a wedge the dual is the square of the forces, and its rounding counts:
   from there on forces near to those are sought. */
static int has_split(const rest_split *s, double factor)
{
    int found = 0;
    for (int32_t k = 0; k < s->rows; k++) s->base[k] = 0.0;
    for (int32_t k = 0; k < s->rank; k++) s->dual[k] = s->g[k];
    for (int time = 0; time < MOST_BASES && !found; time++) {
        if ((found = iterate_split(s, factor)) || is_split(s, SPLIT_ACCEPTED)) break;
        for (int32_t k = 0; k < s->rows; k++) s->base[k] = s->force[k];
        for (int32_t k = 0; k < s->rank; k++) s->dual[k] = 0.0;
    }
    return found > 0 || (!found && is_split(s, SPLIT_ACCEPTED));
}

#endif
