/* Steps of order 4, 6 and 8 as weighted covers, under a tolerance and of islands in which dampers
   take energy out (theory 8.3).

   A composition goes back in time in between, where dampers would give energy. Here a step is
   covered by 1, 2, ... pairs of half steps, all forwards. Their ends have errors in even powers of
   the pairs' length, which weights cancel (Richardson). Pairs keep constraints and ledger, weighted
   ends do so up to the order: they are put back onto the constraints, onto the momenta that every
   cover kept, and onto the energy that the weighted ledger asks for. Contacts do not change within
   a step (event.h): closed ones, and frictions that stick, are rows like others; what slides takes
   energy as dampers do. Some weights are negative: where one of the losses would be, the end of the
   finest cover stands, in which each is what its pairs have taken. */
#ifndef HOLONOM_EXTRAPOLATION_H
#define HOLONOM_EXTRAPOLATION_H

#include "half_step.h"
#include "put_back.h"

#define LARGEST_CHANGE                                                                             \
    1e-2 /* by the weights, relative to size and speed: beyond, errors have no powers yet */

enum { N_WEIGHTED = 3 };
static const int WEIGHTED_ACCOUNTS[N_WEIGHTED] = {S_WORK, S_DISSIPATED, S_FRICTION};

/* Weight of the end after so many pairs, among the ends after `first` ... `last`. */
static double weight_of(int pairs, int first, int last)
{
    double weight = pairs < first ? 0.0 : 1.0;
    for (int k = first; k <= last; k++)
        if (k != pairs) weight *= (double)(pairs * pairs) / (pairs * pairs - k * k);
    return weight;
}

/* Lets laws be those at the start of the step; what predicts half steps stays. */
static void begin_anew(context *c, double t, double law_time)
{
    if (c->m->time_dependent) set_laws(c, law_time, 0);
    c->t = t;
    c->step.rows_known = 0;
}

/* Begins the next cover at the start of the step. */
static void begin_cover(context *c, double t, double law_time)
{
    go_back(c, c->k.pair_backup);
    memset(c->k.loss, 0, sizeof(double) * (size_t)n_composites(c));
    begin_anew(c, t, law_time);
}

/* Adds the end of a cover to the weighted changes of the motion (in estimate), ledger and losses;
   and to what they differ by from those without the coarsest cover, and these from those without
   the two coarsest. Energies of several islands are weighted, too, that of an only one is the
   ledger's; momenta that changed are not kept. */
static void weigh(context *c, int pairs, int covers, double *booked)
{
    const int64_t n = c->s.n_motion;
    const double weight = weight_of(pairs, 1, covers), less = weight_of(pairs, 2, covers);
    const hm_state *s = &c->s;
    const double *start = c->k.pair_backup;
    for (int32_t j = 0; j < n_composites(c); j++) c->k.weighted_loss[j] += weight * c->k.loss[j];
    add_change(c, start, weight, c->k.estimate);
    add_change(c, start, weight - less, c->k.estimate + n);
    add_change(c, start, less - weight_of(pairs, 3, covers), c->k.estimate + 2 * n);
    for (int i = 0; i < N_WEIGHTED; i++) {
        const int at = WEIGHTED_ACCOUNTS[i];
        booked[i] += weight * ((s->head[at] - start[at]) + (s->head[at + 1] - start[at + 1]));
    }
    forget_changed(c);
    if (c->m->n_islands > 1) weigh_energies(c, weight);
}

/* Takes the weighted ends over, in the place of the finest cover's. */
static int32_t take_weighted(context *c, const double *booked, step_result *result)
{
    double *head = c->s.head, *change = c->k.estimate;
    const double *start = c->k.pair_backup;
    add_change(c, start, -1.0, change);
    if (!(motion_norm(c, change) <= LARGEST_CHANGE)) return HOLONOM_NOT_FINITE;
    memcpy(c->k.loss, c->k.weighted_loss, sizeof(double) * (size_t)n_composites(c));
    if (gives_energy(c)) return HOLONOM_DAMPING_REVERSED;
    change_motion(c, change);
    double gained = 0.0;
    for (int i = 0; i < N_WEIGHTED; i++) {
        const int at = WEIGHTED_ACCOUNTS[i];
        head[at] = start[at], head[at + 1] = start[at + 1];
        book(c, at, booked[i]);
        gained += i == 0 ? booked[i] : -booked[i];
    }
    gain_together(c, gained);
    if (c->m->n_driven) follow_drivers(c);
    else signal_rates_at(c, c->t, c->k.signal_rate);
    suspend_sliding(c, 1); /* no friction answers the corrections */
    context at = rows_at_state(c);
    take_unknowns(&at);
    int32_t status = HOLONOM_OK;
    EACH_CHOSEN(&at, island) status = status ? status : factorise_here(&at);
    if (!status) status = put_back(c, &at);
    tell_corrections(c, result);
    suspend_sliding(c, 0);
    follow_turns(c);
    return status;
}

/* Half steps of so many covers. */
static int halves_of(int covers) { return covers * (covers + 1); }

/* Takes all covers of a step of length h, and weighs their ends; that of the finest one stands. The
   internal step has so many half steps. */
static int32_t take_covers(context *c, double h, int covers, int halves, double *booked)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    const size_t losses = sizeof(double) * (size_t)n_composites(c);
    int half = 0;
    keep_motion(c, h);
    keep_state(c, c->k.pair_backup);
    begin_halves(c, halves);
    memset(c->k.estimate, 0, sizeof(double) * (size_t)(3 * c->s.n_motion));
    memset(c->k.loss, 0, losses);
    memset(c->k.weighted_loss, 0, losses);
    for (int pairs = 1; pairs <= covers; pairs++) {
        c->step.n_kept_forces = 0;
        if (pairs > 1) begin_cover(c, t, law_time);
        for (int i = 0; i < 2 * pairs; i++) {
            const int32_t status = single_step(c, 0.5 * h / pairs, half++ % halves);
            if (status) return status;
            if (i % 2 == 0) continue;
            average_multipliers(c, c->t - 0.5 * h / pairs);
            keep_forces(c, c->s.head[S_MEAN_TIME], c->s.mean);
        }
        if (c->m->time_dependent) set_laws(c, t + h, 1); /* ends are compared under the same laws */
        weigh(c, pairs, covers, booked);
    }
    return HOLONOM_OK;
}

/* What a step of covers is, whose weighted end is not taken. */
static void stand_as_finest(step_result *result, int covers)
{
    result->method = COVERED;
    result->finest = covers;
    result->growth = 1.0;
    result->energy_correction = 0.0;
}

/* A pair that no pair before it judges: the finer one of two covers, whose weighted end tells its
   error. */
HM_SELDOM static int32_t judged_pair(context *c, double h, step_result *result)
{
    double unused[N_WEIGHTED] = {0.0};
    stand_as_finest(result, 2);
    const int32_t status = take_covers(c, h, 2, 2, unused);
    if (!status) add_change(c, c->k.pair_backup, -1.0, c->k.estimate);
    c->s.head[S_LAST_LENGTH] = 0.5 * h; /* of the second pair */
    return status;
}

/* The weighted end of covers or, where that would give energy, the end of the finest one, of order
   2. With equal steps the finest cover stands, too, where the weighted end cannot be put back;
   under a tolerance the step is divided. So many half steps of other islands follow. */
HM_SELDOM static int32_t extrapolated_step(context *c, double h, int others, step_result *result)
{
    const int covers = (int)c->s.head[S_ORDER_IN_USE] / 2;
    double booked[N_WEIGHTED] = {0.0}; /* weighted changes in the ledger */
    stand_as_finest(result, covers);
    int32_t status = take_covers(c, h, covers, halves_of(covers) + others, booked);
    if (status) return status;
    keep_state(c, c->k.finest);
    status = take_weighted(c, booked, result);
    if (!status) result->finest = 0;
    if (!status || (c->tolerance > 0.0 && status != HOLONOM_DAMPING_REVERSED)) return status;
    take_state(c, c->k.finest);
    c->s.head[S_AS_PAIRS] += 1.0;
    return HOLONOM_OK;
}

#endif
