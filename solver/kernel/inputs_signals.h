/* Inputs, sensors, laws and signals at their times. */
#ifndef HOLONOM_INPUTS_SIGNALS_H
#define HOLONOM_INPUTS_SIGNALS_H

#include "composite.h"
#include "context.h"
#include "energy.h"
#include "ledger.h"

/* Inputs as they are at time t: held, or on their line or cubic from the value at the beginning of the communication step. */
static void load_inputs(const context *c, double t)
{
    const holonom_model *m = c->m;
    const hm_state *s = &c->s;
    const double past = t - c->start;
    for (int32_t i = 0; i < m->n_inputs; i++) {
        const double moved = past * (s->inputs_slope[i] + past * (s->inputs_bend[i] + past * s->inputs_third[i]));
        c->number[m->input_at + i] = m->input_course[i] == INPUT_HELD ? s->inputs[i] : s->inputs_before[i] + moved;
    }
    memcpy(c->number + m->parameter_at, c->s.parameters, sizeof(double) * (size_t)m->n_parameters);
}

/* Quantities and their rates in the middle of the step to come, predicted with the accelerations of the same half of
   the last pair.                                                                                             */
static void sense(context *c, double h, int parity)
{
    const holonom_model *m = c->m;
    double *x = c->k.ahead, *v = c->k.ahead_rate;
    for (int32_t k = 0; k < DIM * c->n_moving; k++) {
        const double a = c->s.a[parity][k];
        x[k] = c->s.q[k] + 0.5 * h * c->s.v[k] + 0.125 * h * h * a;
        v[k] = c->s.v[k] + 0.5 * h * a;
    }
    for (int32_t j = 0; j < m->n_active; j++) {
        const double turn = 6.283185307179586477;
        double angle = quantity_at(c, j, x, c->s.q_low, v, c->number + m->sensor_rate_at + j);
        if (m->quantity_kind[j] == QUANTITY_ANGLE) { /* the turn next to the state's */
            const double now = quantity_at(c, j, c->s.q, c->s.q_low, NULL, NULL);
            angle -= turn * floor((angle - now) / turn + 0.5);
        }
        c->number[m->sensor_at + j] = angle;
    }
}

/* Sets inputs, parameters and time among the numbers and runs the tape of the laws. If it writes springs, their stored
   energy jumps, which is work on the mechanism.                                                                 */
static void set_laws(context *c, double t, int booked)
{
    const holonom_model *m = c->m;
    const double before = booked && m->variable_potential && m->n_tape_laws ? stored_energy(c) : 0.0;
    load_inputs(c, t);
    c->number[m->time_at] = t;
    if (!m->n_tape_laws) return;
    hm_run_tape(m, c->number, 1);
    if (booked && m->variable_potential) book(c, S_WORK, stored_energy(c) - before);
}

/* Signals at time t (n_signals, overwritten). */
static void signals_at(const context *c, double t, double *signal)
{
    const holonom_model *m = c->m;
    const double law_time = c->number[m->time_at];
    if (!m->n_signals) return;
    load_inputs(c, t);
    c->number[m->time_at] = t;
    hm_run_tape(m, c->number, 2);
    c->number[m->time_at] = law_time;
    memcpy(signal, c->number + m->signal_at, sizeof(double) * (size_t)m->n_signals);
}

/* Rates of the signals at time t (n_signals, overwritten): forward differences of fourth order, so that what a formula is
   before t does not matter. At a kink or a jump, such as that of 2 max(t, 0) at 0, the rate is that of what follows.  */
HM_SELDOM static void signal_rates_at(const context *c, double t, double *rate)
{
    static const double weight[5] = {0.0, 48.0, -36.0, 16.0, -3.0}; /* of differences: constants have the rate 0 */
    const int32_t n = c->m->n_signals;
    const double delta = 1e-2 * c->s.head[S_STEP_SIZE];
    double *now = c->k.signal_sample, *soon = now + n;
    signals_at(c, t, now);
    for (int32_t b = 0; b < n; b++) rate[b] = 0.0;
    for (int i = 1; i < 5 && n; i++) {
        signals_at(c, t + i * delta, soon);
        for (int32_t b = 0; b < n; b++) rate[b] += weight[i] / (12.0 * delta) * (soon[b] - now[b]);
    }
}

#endif
