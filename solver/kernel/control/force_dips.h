/* Forces that vanish within a step and come back: a contact would pull for a while, or a friction
   be more than its cone, though neither end of the step shows it. Means of its pairs of half steps,
   or multipliers of the stages of an explicit step, tell where to look. */
#ifndef HOLONOM_FORCE_DIPS_H
#define HOLONOM_FORCE_DIPS_H

#include "contact.h"

/* Where the parabola through three places is lowest, and how low it is there; NaN if it is not
   between them. */
static double lowest_between(const double *x, const double *y, double *least)
{
    const double before = (y[1] - y[0]) / (x[1] - x[0]), after = (y[2] - y[1]) / (x[2] - x[1]),
                 bend = (after - before) / (x[2] - x[0]);
    const double lowest = 0.5 * (x[0] + x[1] - before / bend);
    *least = y[0] + (lowest - x[0]) * (before + (lowest - x[1]) * bend);
    return bend > 0.0 && lowest > x[0] && lowest < x[2] ? lowest : NAN;
}

/* By how much forces of these multipliers hold contact k closed, or friction k less the number of
   contacts; infinite where none is to. */
static double force_margin(const context *c, int32_t k, const double *mu)
{
    const int32_t f = k - c->m->n_contacts;
    if (f < 0) return is_closed(c, k) ? -mu[row_of(c, c->m->contact_row[k])] : INFINITY;
    return friction_mode(c, f) == FRICTION_STICKS
               ? cone(c, f, 0, normal_force(c, f, mu)) - friction_force(c, f, mu, NULL)
               : INFINITY;
}

/* Where in a piece of length h from time t the margin of function k, known at both ends, is lowest
   by the parabola through the lowest mean and what is beside it; that margin is then in y[1]. NaN
   if no mean is below both ends. */
static double lowest_margin(const context *c, int32_t k, double t, double h, double *y)
{
    double x[3] = {0.0, NAN, h};
    const double ends[2] = {y[0], y[2]};
    double least = fmin(ends[0], ends[1]);
    for (int32_t j = 0; j < c->step.n_kept_forces; j++) {
        const double at = c->k.kept_time[j] - t,
                     margin = force_margin(c, k, c->k.kept_forces + (int64_t)c->m->n_rows * j);
        if (at > 0.0 && at < h && margin < least) x[1] = at, least = y[1] = margin;
    }
    if (x[1] != x[1]) return NAN;
    for (int32_t j = 0; j < c->step.n_kept_forces; j++) {
        const double at = c->k.kept_time[j] - t;
        const int later = at > x[1];
        if (at == x[1] || !(at > x[0] && at < x[2])) continue;
        x[later ? 2 : 0] = at;
        y[later ? 2 : 0] = force_margin(c, k, c->k.kept_forces + (int64_t)c->m->n_rows * j);
    }
    double lowest = lowest_between(x, y, &least);
    if (lowest == lowest) y[1] = fmin(y[1], least);
    return lowest == lowest ? lowest : x[1];
}

#endif
