/* Steps of order 4, 6 and 8 as weighted covers, where dampers take energy out (theory 8.3).

   A composition goes back in time in between, where dampers would give energy. Here a step is covered by 1, 2, ... pairs
   of half steps, all forwards. Their ends have errors in even powers of the pairs' length, which weights cancel
   (Richardson). Pairs keep constraints and ledger, weighted ends do so up to the order: they are put back onto the constraints, onto
   the momenta that every cover kept, and onto the energy that the weighted ledger asks for. Contacts do not change within a step
   (event.h): closed ones, and frictions that stick, are rows like others; what slides takes energy as dampers do. */
#ifndef HOLONOM_EXTRAPOLATION_H
#define HOLONOM_EXTRAPOLATION_H

#include "context.h"
#include "energy.h"
#include "half_step.h"
#include "inputs_signals.h"
#include "ledger.h"
#include "norms.h"
#include "predict.h"
#include "put_back.h"
#include "rigid.h"
#include "start.h"
#include "tangent.h"

#define LARGEST_CHANGE 1e-2      /* by the weights, relative to size and speed: beyond, errors have no powers yet */

enum { N_WEIGHTED = 3 };
static const int WEIGHTED_ACCOUNTS[N_WEIGHTED] = {S_WORK, S_DISSIPATED, S_FRICTION};

typedef struct extrapolation {
    double booked[N_WEIGHTED]; /* weighted changes in the ledger */
} extrapolation;

/* Weight of the end after so many pairs, among the ends after `first` ... `last`. */
static double weight_of(int pairs, int first, int last)
{
    double weight = pairs < first ? 0.0 : 1.0;
    for (int k = first; k <= last; k++)
        if (k != pairs) weight *= (double)(pairs * pairs) / (pairs * pairs - k * k);
    return weight;
}

/* Goes back to the start of the step, from which its next cover begins; what predicts half steps stays. */
static void go_back(context *c, double t, double law_time)
{
    const hm_state *s = &c->s;
    const double *start = c->k.pair_backup;
    memcpy(s->q, start + (s->q - s->head), sizeof(double) * (size_t)(6 * DIM * c->n_moving)); /* q, v, imbalances */
    memcpy(s->turns, start + (s->turns - s->head), sizeof(double) * (size_t)(s->derived - s->turns));
    for (int i = S_WORK; i <= S_FRICTION_LOW; i++) s->head[i] = start[i];
    if (c->m->time_dependent) set_laws(c, law_time, 0);
    c->t = t;
    c->rows_known = 0;
}

/* Adds the end of a cover, `weight` times, to the weighted changes of q and v (in estimate) and ledger; and to what they
   differ by from those of one order less, without the coarsest cover: `less` times. Energies of the islands are weighted, too;
   momenta that changed are not kept. */
static void weigh(context *c, double weight, double less, extrapolation *x)
{
    const hm_state *s = &c->s;
    const double *start = c->k.pair_backup;
    add_change(c, start, weight, c->k.estimate);
    add_change(c, start, less, c->k.estimate + 2 * DIM * c->n_moving);
    for (int i = 0; i < N_WEIGHTED; i++) {
        const int at = WEIGHTED_ACCOUNTS[i];
        x->booked[i] += weight * ((s->head[at] - start[at]) + (s->head[at + 1] - start[at + 1]));
    }
    forget_changed(c);
    weigh_energies(c, weight);
}

/* Takes the weighted ends over, in the place of the finest cover's. */
static int32_t take_weighted(context *c, const extrapolation *x)
{
    const int64_t n = DIM * c->n_moving;
    const hm_state *s = &c->s;
    double *head = s->head, *dq = c->k.estimate, *dv = dq + n;
    const double *start = c->k.pair_backup;
    add_change(c, start, -1.0, dq);
    const double round_off = 1e-15 * head[S_ENERGY_REFERENCE]; /* of losses that the weights take the difference of */
    if (!(x->booked[1] >= -round_off && x->booked[2] >= -round_off)) return HOLONOM_DAMPING_REVERSED;
    if (!(relative_size(c, mass_norm(c, dq), mass_norm(c, dv)) <= LARGEST_CHANGE)) return HOLONOM_NOT_FINITE;
    for (int64_t k = 0; k < n; k++) {
        hm_add(s->q + k, s->q_low + k, dq[k]);
        hm_add(s->v + k, s->v_low + k, dv[k]);
    }
    double gained = 0.0;
    for (int i = 0; i < N_WEIGHTED; i++) {
        const int at = WEIGHTED_ACCOUNTS[i];
        const double booked = i == 0 ? x->booked[i] : fmax(x->booked[i], 0.0);
        head[at] = start[at], head[at + 1] = start[at + 1];
        book(c, at, booked);
        gained += i == 0 ? booked : -booked;
    }
    gain_together(c, gained);
    suspend_sliding(c, 1); /* no friction answers the corrections */
    context at = rows_at_state(c, 0.0);
    take_unknowns(&at);
    int32_t status = factorise_here(&at);
    int unused;
    if (!status) status = put_back(c, &at, &unused);
    suspend_sliding(c, 0);
    follow_turns(c);
    return status;
}

/* Takes all covers of a step of length h, and weighs their ends. */
static int32_t take_covers(context *c, double h, int covers, extrapolation *x)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    int half = 0;
    begin_halves(c, covers * (covers + 1));
    for (int pairs = 1; pairs <= covers; pairs++) {
        const double weight = weight_of(pairs, 1, covers);
        if (pairs > 1) go_back(c, t, law_time);
        for (int i = 0; i < 2 * pairs; i++) {
            const int32_t status = single_step(c, 0.5 * h / pairs, half++);
            if (status) return status;
            if (i % 2) average_multipliers(c, c->t - 0.5 * h / pairs);
        }
        if (c->m->time_dependent) set_laws(c, t + h, 1); /* ends are compared under the same laws */
        weigh(c, weight, weight - weight_of(pairs, 2, covers), x);
    }
    return HOLONOM_OK;
}

/* One internal step. Where its weighted end cannot be put back, that of the finest cover stands, which conserves. */
HM_SELDOM static int32_t extrapolated_step(context *c, double h)
{
    const int covers = (int)c->s.head[S_ORDER_IN_USE] / 2;
    const size_t bytes = sizeof(double) * (size_t)c->state_size;
    extrapolation x = {{0.0}};
    keep_motion(c, h);
    memcpy(c->k.pair_backup, c->s.head, bytes);
    memset(c->k.estimate, 0, sizeof(double) * (size_t)(4 * DIM * c->n_moving));
    const int32_t status = take_covers(c, h, covers, &x);
    if (status) return status;
    memcpy(c->k.finest, c->s.head, bytes);
    c->way = COVERED;
    if (!take_weighted(c, &x)) return HOLONOM_OK;
    memcpy(c->s.head, c->k.finest, bytes);
    c->unweighted = 1;
    return HOLONOM_OK;
}

#endif
