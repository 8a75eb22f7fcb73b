/* A half step, and what two neighbours tell of the multipliers. */
#ifndef HOLONOM_HALF_STEP_H
#define HOLONOM_HALF_STEP_H

#include "inputs_signals.h"

/* Laws and signals of a half step of length h; returns its parity. */
static int begin_half(context *c, double h, int half)
{
    const int parity = half % 2;
    c->h = h;
    c->step.half = half;
    if (n_kinks(c)) watch_kinks(c);
    if (c->m->sensing) sense(c, h, parity);
    if (c->m->time_dependent || c->m->sensing) set_laws(c, c->t + 0.5 * h, 1);
    signals_at(c, c->t + h, c->k.signal1);
    return parity;
}

static int32_t single_step(context *c, double h, int half)
{
    const int parity = begin_half(c, h, half);
    const int32_t status = solve_step(c, parity);
    if (!status) accept_step(c, parity);
    return status;
}

enum { MOST_KEPT_FORCES = 16 }; /* of a step: the composition of order 8 has 15 */

/* Keeps the multipliers mu at a time within the step at hand: its contacts are looked at when it
   ends (force_dips.h). */
static void keep_forces(context *c, double time, const double *mu)
{
    if (!c->m->unilateral || c->step.n_kept_forces == MOST_KEPT_FORCES) return;
    c->k.kept_time[c->step.n_kept_forces] = time;
    memcpy(c->k.kept_forces + (int64_t)c->m->n_rows * c->step.n_kept_forces++, mu,
           sizeof(double) * (size_t)c->m->n_rows);
}

/* Means of the islands at hand; those before become the means before. */
static void average_at_hand(context *c)
{
    hm_state *s = &c->s;
    const int32_t first = c->m->n_free, begin = c->view.begin[ISLAND_DRIVEN],
                  end = c->view.end[ISLAND_DRIVEN];
    EACH_ROW(c, i) {
        s->mean_before[i] = s->mean[i];
        s->mean[i] = 0.5 * (s->mu[0][i] + s->mu[1][i]);
    }
    for (int32_t k = DIM * (begin - first); k < DIM * (end - first); k++) {
        s->driven_mean_before[k] = s->driven_mean[k];
        s->driven_mean[k] = 0.5 * (s->driven[0][k] + s->driven[1][k]);
    }
}

/* mu is constant over a step and has a part that changes sign from step to step: only the mean of
   two neighbours is smooth, and it belongs to the time between them. Two means give the multiplier
   at the output's time. */
static void average_multipliers(context *c, double time)
{
    double *head = c->s.head;
    if (!is_telling(c)) return;
    head[S_MEAN_TIME_BEFORE] = head[S_MEAN_TIME];
    head[S_MEAN_TIME] = time;
    EACH_CHOSEN(c, island) average_at_hand(c);
}

#endif
