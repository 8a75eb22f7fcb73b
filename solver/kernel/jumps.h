/* What jumps of inputs, parameters and laws do to the state. */
#ifndef HOLONOM_JUMPS_H
#define HOLONOM_JUMPS_H

#include "measure.h"

#define SAME_VALUE 1e-12 /* part of a signal, or of 1 m or rad, by which it may jump by rounding */

static int has_another_value(double now, double before) { return !(fabs(now - before) <= SAME_VALUE * (1.0 + fabs(now))); }

/* No polynomial through means and values from before and after a jump. */
static void start_anew(context *c)
{
    c->s.head[S_MEAN_TIME] = INFINITY;
    c->s.head[S_HELD] = 0.0;
    forget_halves(c);
}

/* No line leads through means from before and after a jump; outputs at the communication point belong to the step that led
   there, and stay where its line ends.                                                                          */
HM_SELDOM static void end_line(const context *c)
{
    extrapolate(c, c->m->n_rows, c->s.mean, c->s.mean_before, c->s.mean);
    extrapolate(c, DIM * c->m->n_driven, c->s.driven_mean, c->s.driven_mean_before, c->s.driven_mean);
    c->s.head[S_MEAN_TIME] = INFINITY;
}

/* The rates of signals, which were signal_before, jump: velocities do so by what that asks for, M dv + G'p = 0, G dv + db/dt = 0; the
   energy is the drivers' work. */
HM_SELDOM static int32_t jump_with_signals(context *c)
{
    const holonom_model *m = c->m;
    double *jump = c->k.signal_rate;
    signal_rates_at(c, c->t, jump);
    for (int32_t b = 0; b < m->n_signals; b++) jump[b] -= c->k.signal_before[b];
    const double kinetic = kinetic_energy(c, c->k.momentum);
    stand_still(c);
    memcpy(c->k.w + DIM * m->n_free, jump, sizeof(double) * (size_t)(DIM * m->n_driven));
    row_rates(c, c->s.q, c->s.q_low, c->k.w, c->s.signal, jump, c->k.phi);
    inertia(c, AT_STATE, c->k.w, c->k.momentum);
    const int32_t status = solve_at_state(c, NULL);
    if (status) return status;
    add_solution(c, c->k.w);
    for (int32_t k = 0; k < DIM * c->n_moving; k++) hm_add(c->s.v + k, c->s.v_low + k, c->k.w[k]);
    book(c, S_WORK, kinetic_energy(c, c->k.momentum) - kinetic);
    start_anew(c);
    return HOLONOM_OK;
}

#endif
