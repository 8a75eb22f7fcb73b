/* Velocities at a dead centre. There the rows allow more velocities than elsewhere, but motions
   only along some of them: with a velocity v rows also ask for  G a = -(dG/dt) v,  which has no
   solution a unless v is that of a motion. */
#ifndef HOLONOM_DEAD_CENTRE_H
#define HOLONOM_DEAD_CENTRE_H

#include "even_metric.h"

#define LACKING 1e-6   /* part of the second derivatives of rows that no accelerations make up for
                          \ */
#define ROUNDED 1e-10  /* of the accelerations: what rounding leaves of these derivatives */

/* Second derivatives of rows (phi), over their scales, with accelerations x, of what always
   holds. */
static double rows_bend(const context *c, const double *bias, double *x)
{
    memset(c->k.signal_rate, 0, sizeof(double) * (size_t)c->m->n_signals);
    row_rates(c, x, c->k.signal_rate, c->k.phi);
    for (int32_t i = 0; i < c->m->n_rows; i++)
        c->k.phi[i] = state_of_multiplier(c, i) == ROW_IS_ON ? c->k.phi[i] + bias[i] : 0.0;
    return largest_row(c, c->k.phi);
}

/* Refuses velocities that no accelerations lead on, beginning with those of the state; phi has what
   each row then lacks. */
HM_SELDOM static int32_t refuse_dead_centre(context *c)
{
    double *x = c->k.free, *bias = c->k.row_bias, last = INFINITY;
    stand_still(c);
    row_biases(c);
    memcpy(x, c->s.a[0], sizeof(double) * (size_t)(DIM * c->n_moving));
    const double allowed = LACKING * largest_row(c, bias) + ROUNDED * fastest_rate(c, x);
    double lacking = rows_bend(c, bias, x);
    if (!(lacking > allowed)) return HOLONOM_OK;
    int32_t status = take_even_metric(c);
    for (int i = 0; i < 8 && !status && lacking > allowed && lacking < 0.9 * last; i++) {
        memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
        if ((status = solve_at_state(c))) break;
        add_solution(c, x);
        last = lacking;
        lacking = rows_bend(c, bias, x);
    }
    leave_even_metric(c);
    return status ? status : lacking > allowed ? HOLONOM_AT_DEAD_CENTRE : HOLONOM_OK;
}

#endif
