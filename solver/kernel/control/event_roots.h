/* Where a function of an event becomes negative in a piece, by its values and rates at both
   ends. */
#ifndef HOLONOM_EVENT_ROOTS_H
#define HOLONOM_EVENT_ROOTS_H

#include "event_functions.h"

/* The cubic with these ends and slopes is v0 + s (r0 + s (b + s a)), s from 0 to 1. */
static inline void bend_of_cubic(double v0, double r0, double v1, double r1, double *a, double *b)
{
    *b = 3.0 * (v1 - v0) - 2.0 * r0 - r1;
    *a = 2.0 * (v0 - v1) + r0 + r1;
}

enum { BISECTIONS = 60 }; /* more than a double has bits */

/* Where in (0, 1] the cubic with these ends and slopes becomes negative, or infinity; a start below
   0 counts as 0. */
HM_SELDOM static double cubic_root(double v0, double r0, double v1, double r1)
{
    double a, b;
    bend_of_cubic(v0, r0, v1, r1, &a, &b);
    double end[4] = {0.0, 1.0, 1.0, 1.0}; /* of pieces without extremum */
    const double square = b * b - 3.0 * a * r0;
    int pieces = 0;
    if (square > 0.0) {
        const double q = -(b + copysign(sqrt(square), b)),
                     s[2] = {q != 0.0 ? r0 / q : 2.0, a != 0.0 ? q / (3.0 * a) : 2.0};
        const int later = s[1] < s[0];
        for (int i = 0; i < 2; i++)
            if (s[later ? 1 - i : i] > 0.0 && s[later ? 1 - i : i] < 1.0)
                end[++pieces] = s[later ? 1 - i : i];
    }
    for (int i = 0; i <= pieces; i++) {
        double low = end[i], high = i == pieces ? 1.0 : end[i + 1];
        if (!(v0 + high * (r0 + high * (b + high * a)) < 0.0)) continue;
        if (i == 0 && v0 <= 0.0 && r0 <= 0.0) return 0.0;
        for (int k = 0; k < BISECTIONS; k++) {
            const double s = 0.5 * (low + high);
            if (v0 + s * (r0 + s * (b + s * a)) < 0.0) high = s;
            else low = s;
        }
        return high;
    }
    return INFINITY;
}

/* Where in (0, 1) the cubic with these ends and slopes, the first one negative and the last one
   positive, is lowest. */
HM_SELDOM static double lowest_of_cubic(double v0, double r0, double v1, double r1)
{
    double a, b;
    bend_of_cubic(v0, r0, v1, r1, &a, &b);
    return -r0 / (b + sqrt(b * b - 3.0 * a * r0));
}

/* Estimate of where in (0, h] function k becomes negative, or infinity. A distance has a kink where
   the ball passes through: its tangents meet below 0, and the first trial is there. Tangents of a
   function that only comes close meet above 0 once its lowest place is known well, which is where
   the `next` trials are. */
HM_SELDOM static double root_between(const context *c, int32_t k, double h, int next,
                                     event_values low, event_values high)
{
    const double none = value_tolerance(c, k), v0 = fmax(low.value[k], 0.0), v1 = high.value[k];
    double r0 = h * low.rate[k], r1 = h * high.rate[k];
    if (!(v0 < INFINITY && v1 < INFINITY)) return INFINITY;
    if (r0 == r0 && r1 == r1) {
        if (v0 <= none && fabs(r0) <= none) r0 = 0.0;
        if (v1 >= -none && !(r0 < 0.0 && r1 > 0.0)) return INFINITY;
        const double root = h * cubic_root(v0, r0, v1, r1), touch = (v0 - v1 + r1) / (r1 - r0);
        if (root <= h || v1 < -none) return root;
        return v0 + r0 * touch < -none ? h * (next ? lowest_of_cubic(v0, r0, v1, r1) : touch)
                                       : INFINITY;
    }
    return v1 < -none ? h * v0 / (v0 - v1) : INFINITY;
}

#endif
