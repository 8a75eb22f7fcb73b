/* Products of vectors of DIM components. */
#ifndef HOLONOM_VECTORS_H
#define HOLONOM_VECTORS_H

#define EACH(k) for (int k = 0; k < DIM; k++)
#define TURNING (DIM == 2 ? 1 : 3) /* components of a moment */

static inline double dot(const double *a, const double *b)
{
    double sum = 0.0;
    EACH(k) sum += a[k] * b[k];
    return sum;
}

/* x = a x b, in the plane its one component. */
static inline void cross_product(const double *a, const double *b, double *x)
{
#if DIM == 2
    x[0] = a[0] * b[1] - a[1] * b[0];
#else
    EACH(k) x[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
#endif
}

/* The vector whose cross products with the directors d_i of a body come nearest to x_i: for
   orthonormal ones half the sum of d_i x x_i, in the plane d x x. */
static inline void turn_of_directors(const double *d, const double *x, double *turn)
{
    double own[TURNING];
    for (int k = 0; k < TURNING; k++) turn[k] = 0.0;
    for (int i = 0; i < TURNING; i++) {
        cross_product(d + DIM * i, x + DIM * i, own);
        for (int k = 0; k < TURNING; k++) turn[k] += (DIM == 2 ? 1.0 : 0.5) * own[k];
    }
}

#endif
