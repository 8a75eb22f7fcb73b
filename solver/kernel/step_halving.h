/* Internal steps: pairs of half steps, halving on failure. */
#ifndef HOLONOM_STEP_HALVING_H
#define HOLONOM_STEP_HALVING_H

#include "composition.h"
#include "context.h"
#include "extrapolation.h"
#include "half_step.h"
#include "inputs_signals.h"
#include "predict.h"

enum { MAX_HALVINGS = 6 };

/* Adds the output after a stage to the difference from the embedded solution. */
static void gather_estimate(context *c, int order, int i, int stages)
{
    const int64_t n = DIM * c->n_moving;
    const hm_state *s = &c->s;
    if (!(s->head[S_TOLERANCE] > 0.0) || order == 2) return;
    const double *q0 = c->k.pair_backup + (s->q - s->head), *q0_low = c->k.pair_backup + (s->q_low - s->head);
    const double *v0 = c->k.pair_backup + (s->v - s->head), *v0_low = c->k.pair_backup + (s->v_low - s->head);
    const double weight = embedded(order, i, stages);
    double *q = c->k.estimate, *v = q + n;
    for (int64_t k = 0; k < n; k++) {
        q[k] = (i > 1 ? q[k] : 0.0) + weight * ((s->q[k] - q0[k]) + (s->q_low[k] - q0_low[k]));
        v[k] = (i > 1 ? v[k] : 0.0) + weight * ((s->v[k] - v0[k]) + (s->v_low[k] - v0_low[k]));
    }
}

/* Whether steps come one by one, not in pairs. */
static int is_unpaired(const context *c)
{
    return c->s.head[S_PAIRED] == 0.0 && c->s.head[S_ORDER_IN_USE] == 2.0 && !(c->s.head[S_TOLERANCE] > 0.0);
}

/* One internal step: pairs of half steps, or the plain step, whose velocities and multipliers are less smooth. */
static int32_t internal_step(context *c, double h)
{
    const int order = (int)c->s.head[S_ORDER_IN_USE];
    int32_t status = HOLONOM_OK;
    if (is_unpaired(c)) {
        begin_halves(c, 2);
        status = single_step(c, h, (int)c->s.head[S_PARITY]);
        if (!status) average_multipliers(c, c->t - h);
        return status;
    }
    if (is_extrapolating(c)) return extrapolated_step(c, h);
    const double dissipated = c->s.head[S_DISSIPATED] - 1e-9 * c->s.head[S_ENERGY_REFERENCE];
    memcpy(c->k.pair_backup, c->s.head, sizeof(double) * (size_t)c->state_size);
    int stages = 1;
    stage(order, 0, &stages);
    begin_halves(c, 2 * stages);
    for (int i = 0; i < stages && !status; i++) {
        const double half = 0.5 * h * stage(order, i, &stages);
        status = single_step(c, half, 2 * i);
        if (!status) status = single_step(c, half, 2 * i + 1);
        if (!status) average_multipliers(c, c->t - half);
        if (!status) gather_estimate(c, order, i + 1, stages);
    }
    /* Dampers too strong for the parts that go back in time run away, with a ledger that closes. */
    if (!status && order > 2 && !(c->s.head[S_DISSIPATED] >= dissipated)) return HOLONOM_DAMPING_REVERSED;
    return status;
}

/* Takes an internal step back, from time t with laws of law_time; what it cost stays counted, what was learned known. */
static void undo_step(context *c, double t, double law_time)
{
    double learned[2 * N_COMPOSED];
    memcpy(learned, c->s.head + S_JUDGED_4, sizeof learned);
    const double newton = c->s.head[S_NEWTON_ITERATIONS], uzawa = c->s.head[S_UZAWA_ITERATIONS];
    if (!is_unpaired(c)) {
        memcpy(c->s.head, c->k.pair_backup, sizeof(double) * (size_t)c->state_size);
        if (c->m->time_dependent) set_laws(c, law_time, 0); /* the work of what they did is undone too */
    }
    c->t = t;
    c->s.head[S_NEWTON_ITERATIONS] = newton;
    c->s.head[S_UZAWA_ITERATIONS] = uzawa;
    memcpy(c->s.head + S_JUDGED_4, learned, sizeof learned);
}

/* After a failure penalties are those that were asked for. */
static void lower_penalties(context *c)
{
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        double *own = c->s.islands + I_SIZE * island;
        own[I_PENALTY_LEVEL] = own[I_SLOW_STEPS] = 0.0;
    }
}

static int32_t step_halving(context *c, double h, int halvings)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    int32_t status = internal_step(c, h);
    if (!status) return HOLONOM_OK;
    undo_step(c, t, law_time);
    lower_penalties(c);
    if (known_changes(c)) { /* Newton's iteration may only have begun too far away: lines miss what turns fast */
        forget_changes(c);
        return step_halving(c, h, halvings);
    }
    if (halvings == MAX_HALVINGS) return status;
    status = step_halving(c, 0.5 * h, halvings + 1);
    return status ? status : step_halving(c, 0.5 * h, halvings + 1);
}

#endif
