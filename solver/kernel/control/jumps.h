/* What jumps of inputs, parameters and laws do to the state.

   Rates of signals may jump: velocities follow. Where a value jumps that somebody sets, a held
   input or a parameter, it stands for a course that is not known better: what is driven follows at
   once under a tolerance. A formula whose value jumps at a switch asks for no motion at all: it is
   refused by name (switch_event.h). */
#ifndef HOLONOM_JUMPS_H
#define HOLONOM_JUMPS_H

#include "measure.h"
#include "put_back.h"

#define SAME_VALUE 1e-12 /* part of a signal, or of 1 m or rad, by which it may jump by rounding */

/* Whether the value of a signal has jumped (n_signals each). */
static int have_jumped(const context *c, const double *now, const double *before)
{
    for (int32_t b = 0; b < c->m->n_signals; b++)
        if (!(fabs(now[b] - before[b]) <= SAME_VALUE * (1.0 + fabs(now[b])))) return 1;
    return 0;
}

/* No polynomial through means and values from before and after a jump. */
static void start_anew(context *c)
{
    c->s.head[S_MEAN_TIME] = INFINITY;
    c->s.head[S_HELD] = 0.0;
    forget_halves(c);
    forget_secants(c);
}

/* No line leads through means from before and after a jump; outputs at the communication point
   belong to the step that led there, and stay where its line ends. */
HM_SELDOM static void end_line(context *c)
{
    extrapolate(c, c->s.head[S_TIME], c->m->n_rows, c->s.mean, c->s.mean_before, c->s.mean);
    extrapolate(c, c->s.head[S_TIME], DIM * c->m->n_driven, c->s.driven_mean,
                c->s.driven_mean_before, c->s.driven_mean);
    c->s.head[S_MEAN_TIME] = INFINITY;
}

/* Where the rates of signals, which were signal_before, have jumped at time t, velocities do so by
   what that asks for, M dv + G'p = 0, G dv + db/dt = 0; the energy is the drivers' work. */
HM_SELDOM static int32_t jump_with_signals(context *c, double t)
{
    const holonom_model *m = c->m;
    double *jump = c->k.signal_rate;
    int jumps = 0;
    signal_rates_at(c, t, jump);
    for (int32_t b = 0; b < m->n_signals; b++) jumps |= (jump[b] -= c->k.signal_before[b]) != 0.0;
    if (!jumps) return HOLONOM_OK;
    const double kinetic = kinetic_energy(c, c->k.momentum);
    stand_still(c);
    memcpy(c->k.w + DIM * m->n_free, jump, sizeof(double) * (size_t)(DIM * m->n_driven));
    row_rates(c, c->k.w, jump, c->k.phi);
    inertia(c, 1.0, c->k.w, c->k.momentum);
    const int32_t status = solve_at_state(c);
    if (status) return status;
    add_solution(c, c->k.w);
    for (int32_t k = 0; k < DIM * c->n_moving; k++) hm_add(c->s.v + k, c->s.v_low + k, c->k.w[k]);
    book(c, S_WORK, kinetic_energy(c, c->k.momentum) - kinetic);
    start_anew(c);
    return HOLONOM_OK;
}

/* Lets what drivers hold follow signals that have jumped since the last communication step: steps
   of any length would throw it about, as much faster as they are shorter. The work is what energies
   ask for. Where rows cannot follow, all stays as it is. */
HM_SELDOM static void follow_jumps(context *c)
{
    int held = 1;
    signals_at(c, c->t, c->k.signal1);
    if (!have_jumped(c, c->k.signal1, c->s.signal)) return;
    context at = rows_at_state(c);
    double *before = c->k.whole_backup;
    keep_state(c, before);
    keep_motion(c, 0.0);
    forget_momenta(c); /* which drivers change */
    follow_drivers(c);
    take_unknowns(&at);
    for (int i = 0; i < MAX_CORRECTIONS && held && !factorise_here(&at); i++)
        held = put_back(c, &at) != HOLONOM_OK;
    /* Velocities of a body that has turned far want factors of where it is now. */
    const int is_placed = !held && !factorise_here(&at);
    if (is_placed) {
        keep_motion(c, 0.0); /* what went before is booked */
        forget_momenta(c);
    }
    if (!is_placed || !put_velocities_back(c, &at)) take_state(c, before);
    else follow_turns(c);
    start_anew(c);
}

#endif
