/* Signals within a step, with two derivatives: polynomials through their values at Chebyshev's points, which lie inside of it,
   so that kinks and jumps at its ends do not matter. */
#ifndef HOLONOM_SIGNAL_COURSE_H
#define HOLONOM_SIGNAL_COURSE_H

#include "context.h"
#include "elementary.h"
#include "inputs_signals.h"

/* Courses of the signals in a step of length h from t: of each the coefficients of Chebyshev's polynomials. */
HM_SELDOM static void find_courses(const context *c, double t, double h)
{
    const int32_t n = c->m->n_signals;
    double *first = c->k.signal_sample, *value = first + n, *course = c->k.signal_course;
    memset(course, 0, sizeof(double) * (size_t)(COURSE_POINTS * n));
    for (int i = 0; i < COURSE_POINTS && n; i++) {
        const double x = hm_cos(3.14159265358979324 * (i + 0.5) / COURSE_POINTS);
        signals_at(c, t + 0.5 * h * (1.0 + x), i ? value : first);
        for (int32_t b = 0; b < n && i; b++) { /* constants have no other terms */
            const double term = 2.0 / COURSE_POINTS * (value[b] - first[b]);
            double T = 1.0, last = x, next;
            for (int k = 0; k < COURSE_POINTS; k++, next = 2.0 * x * T - last, last = T, T = next)
                course[COURSE_POINTS * b + k] += k ? term * T : 0.5 * term;
        }
    }
    for (int32_t b = 0; b < n; b++, course += COURSE_POINTS) {
        course[0] += first[b];
        /* What is round-off of values and of the time has second derivatives all the same. */
        const double noise = 4e-16 * (fabs(course[0]) + 2.0 * fabs(t / h * course[1]));
        for (int k = COURSE_POINTS - 1; k > 0 && fabs(course[k]) <= noise; k--) course[k] = 0.0;
    }
}

/* Values, rates and second derivatives of the signals at part `part` of the step. */
HM_SELDOM static void follow_courses(const context *c, double part, double h)
{
    const double x = 2.0 * part - 1.0, scale = 2.0 / h;
    for (int32_t b = 0; b < c->m->n_signals; b++) {
        const double *course = c->k.signal_course + COURSE_POINTS * b;
        double now[3] = {1.0, 0.0, 0.0}, last[3] = {x, 1.0, 0.0}, sum[3] = {0.0, 0.0, 0.0};
        for (int k = 0; k < COURSE_POINTS; k++) {
            double next[3];
            for (int i = 0; i < 3; i++) {
                sum[i] += course[k] * now[i];
                next[i] = 2.0 * x * now[i] - last[i] + (i ? 2.0 * i * now[i - 1] : 0.0);
            }
            memcpy(last, now, sizeof now);
            memcpy(now, next, sizeof now);
        }
        c->k.signal1[b] = sum[0];
        c->k.signal_rate[b] = scale * sum[1];
        c->k.signal_before[b] = scale * scale * sum[2];
    }
}

/* Sets the state's signals, and driven nodes, to signal1 and signal_rate. */
HM_SELDOM static void place_driven(const context *c)
{
    const int32_t first = DIM * c->m->n_free;
    memcpy(c->s.signal, c->k.signal1, sizeof(double) * (size_t)c->m->n_signals);
    for (int32_t k = first; k < DIM * c->n_moving; k++) {
        c->s.q[k] = c->k.signal1[k - first];
        c->s.v[k] = c->k.signal_rate[k - first];
        c->s.q_low[k] = c->s.v_low[k] = 0.0;
    }
}

#endif
