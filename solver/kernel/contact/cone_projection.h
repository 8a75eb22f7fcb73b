/* Coulomb's cone |x_T| <= c x_N, and projection on it. */
#ifndef HOLONOM_CONE_PROJECTION_H
#define HOLONOM_CONE_PROJECTION_H

#include "internal.h"

#include <math.h>
#include <stddef.h>

#define CONE_MARGIN                                                                                \
    1e-9 /* part of the cone, or of a slip, beyond its limit at which a mode is kept */
enum { MOST_IN_CONE = 4 }; /* a normal force, and three of friction */

/* Projects n forces x on the cone |x_T| <= c x_N, in place; the derivative of that (n x n,
   overwritten) if wanted. */
HM_SELDOM static void project_on_cone(int32_t n, double c, double *x, double *slope)
{
    double size2 = 0.0;
    for (int32_t k = 1; k < n; k++) size2 += x[k] * x[k];
    const double size = sqrt(size2);
    const int is_inside = x[0] >= 0.0 && size <= c * x[0],
              is_polar = x[0] <= 0.0 && c * size <= -x[0];
    for (int32_t k = 0; k < n * n && slope; k++)
        slope[k] = is_inside && k % (n + 1) == 0 ? 1.0 : 0.0;
    if (is_inside) return;
    if (is_polar) {
        for (int32_t k = 0; k < n; k++) x[k] = 0.0;
        return;
    }
    const double normal = (x[0] + c * size) / (1.0 + c * c);
    double edge[MOST_IN_CONE] = {1.0, 0.0, 0.0, 0.0};
    for (int32_t k = 1; k < n; k++) edge[k] = size > 0.0 ? c * x[k] / size : 0.0;
    for (int32_t k = 0; k < n && slope; k++)
        for (int32_t l = 0; l < n; l++) {
            slope[n * k + l] = edge[k] * edge[l] / (1.0 + c * c);
            if (k && l && size > 0.0)
                slope[n * k + l] += c * normal / size * ((k == l) - x[k] * x[l] / size2);
        }
    for (int32_t k = 0; k < n; k++) x[k] = normal * edge[k];
}

#endif
