/* Solutions of least size of small square systems, singular or not. */
#ifndef HOLONOM_LEAST_SQUARES_H
#define HOLONOM_LEAST_SQUARES_H

#include <string.h>

#include "internal.h"

static inline double hm_length(int32_t n, const double *u)
{
    double sum = 0.0;
    for (int32_t a = 0; a < n; a++) sum += u[a] * u[a];
    return n == 1 ? fabs(u[0]) : sqrt(sum);
}

/* Q R = A P by Householder's reflections with column pivoting. A (n x m) holds R above the diagonal
   and, with `head` (m), the vectors of the reflections; order (m): the column of A that stands at
   each place. Returns the rank: as many pivots as exceed `dependent` times the first one. */
HM_SELDOM static int32_t hm_triangulate(int32_t n, int32_t m, double *A, double *head,
                                        int32_t *order, double dependent)
{
    const int32_t most = n < m ? n : m;
    double first = 0.0;
    for (int32_t c = 0; c < m; c++) order[c] = c;
    for (int32_t k = 0; k < most; k++) {
        int32_t pivot = k;
        double largest = -1.0;
        for (int32_t c = k; c < m; c++) {
            double sum = 0.0;
            for (int32_t r = k; r < n; r++) sum += hm_square(A[r * m + c]);
            if (sum > largest * (1.0 + 1e-12)) largest = sum, pivot = c;
        }
        const double size = sqrt(largest);
        if (k == 0) first = size;
        if (!(size > dependent * first)) return k;
        for (int32_t r = 0; r < n && pivot != k; r++) {
            const double kept = A[r * m + k];
            A[r * m + k] = A[r * m + pivot];
            A[r * m + pivot] = kept;
        }
        const int32_t kept = order[k];
        order[k] = order[pivot], order[pivot] = kept;
        const double a = A[k * m + k], end = a > 0.0 ? -size : size;
        head[k] = a - end;
        const double scale = end * head[k]; /* -|v|^2/2 */
        for (int32_t c = k + 1; c < m; c++) {
            double sum = head[k] * A[k * m + c];
            for (int32_t r = k + 1; r < n; r++) sum += A[r * m + k] * A[r * m + c];
            sum /= scale;
            A[k * m + c] += sum * head[k];
            for (int32_t r = k + 1; r < n; r++) A[r * m + c] += sum * A[r * m + k];
        }
        A[k * m + k] = end;
    }
    return most;
}

/* b (n) becomes Q' b, or Q b if `back`. */
HM_SELDOM static void hm_reflect(int32_t n, int32_t m, int32_t rank, const double *A,
                                 const double *head, int back, double *b)
{
    for (int32_t i = 0; i < rank; i++) {
        const int32_t k = back ? rank - 1 - i : i;
        double sum = head[k] * b[k];
        for (int32_t r = k + 1; r < n; r++) sum += A[r * m + k] * b[r];
        sum /= A[k * m + k] * head[k];
        b[k] += sum * head[k];
        for (int32_t r = k + 1; r < n; r++) b[r] += sum * A[r * m + k];
    }
}

/* The x (n) of least size among those with the least |A x - b|; A and b are overwritten, and so are
   head (3 n) and order (n). Of the rank only what exceeds `dependent` counts. */
HM_SELDOM static void hm_least_squares(int32_t n, double *A, double *b, double *x, double *head,
                                       int32_t *order, double dependent)
{
    const int32_t rank = hm_triangulate(n, n, A, head, order, dependent);
    double *lead = head + n, *y = head + 2 * n;
    hm_reflect(n, n, rank, A, head, 0, b);
    for (int32_t k = rank - 1; k >= 0 && rank < n;
         k--) { /* what stands behind the square part turns into it */
        double *row = A + k * n, tail = 0.0;
        for (int32_t c = rank; c < n; c++) tail += row[c] * row[c];
        lead[k] = 0.0;
        if (tail == 0.0) continue;
        const double size = sqrt(row[k] * row[k] + tail), end = row[k] > 0.0 ? -size : size;
        lead[k] = row[k] - end;
        for (int32_t r = 0; r < k; r++) {
            double sum = lead[k] * A[r * n + k];
            for (int32_t c = rank; c < n; c++) sum += row[c] * A[r * n + c];
            sum /= end * lead[k];
            A[r * n + k] += sum * lead[k];
            for (int32_t c = rank; c < n; c++) A[r * n + c] += sum * row[c];
        }
        row[k] = end;
    }
    for (int32_t k = rank - 1; k >= 0; k--) {
        double sum = b[k];
        for (int32_t c = k + 1; c < rank; c++) sum -= A[k * n + c] * y[c];
        y[k] = sum / A[k * n + k];
    }
    for (int32_t k = rank; k < n; k++) y[k] = 0.0;
    for (int32_t k = 0; k < rank && rank < n; k++) {
        if (lead[k] == 0.0) continue;
        double sum = lead[k] * y[k];
        for (int32_t c = rank; c < n; c++) sum += A[k * n + c] * y[c];
        sum /= A[k * n + k] * lead[k];
        y[k] += sum * lead[k];
        for (int32_t c = rank; c < n; c++) y[c] += sum * A[k * n + c];
    }
    for (int32_t k = 0; k < n; k++) x[order[k]] = y[k];
}

#endif
