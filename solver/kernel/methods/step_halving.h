/* Internal steps of order 2, 4, 6 and 8: compositions of pairs of half steps, weighted covers, both
   for islands of their own, or explicit; halving on failure. */
#ifndef HOLONOM_STEP_HALVING_H
#define HOLONOM_STEP_HALVING_H

#include "divided_step.h"
#include "runge_kutta.h"

/* Light links whip about a heavy load where their chain comes straight, in steps 1e4 times as short
   for a moment. Shorter steps do not help rows that may contradict each other, what turns all the
   time too fast even for a step with FEW_HALVINGS, and an iteration that is allowed few
   increments. */
enum { MOST_HALVINGS = 16, FEW_HALVINGS = 6, FEW_INCREMENTS = 10 };

static int most_halvings(const context *c, double h, int32_t status)
{
    const double longest = MOST_TURNED * (2 << FEW_HALVINGS);
    const int is_whipped = status == HOLONOM_NEWTON_DIVERGED || status == HOLONOM_NOT_FINITE
                           || status == HOLONOM_TURN_TOO_LARGE;
    int few = !is_whipped || c->s.head[S_MAX_NEWTON] < FEW_INCREMENTS
              || fabs(h) * fastest_turn(c) > longest;
    few |= may_have_dependent_rows(c);
    return few ? FEW_HALVINGS : MOST_HALVINGS;
}

/* Longest explicit step of an order. */
static double longest_of(const context *c, int order)
{ return method_of_order(order)->resolved * c->s.head[S_LONGEST_EXPLICIT]; }

/* Likewise at the present angular velocities, which may grow in the step. */
static double longest_now(const context *c, int order)
{
    return fmin(longest_of(c, order), 0.9 * MOST_TURNED / fmax(fastest_turn(c), fastest_angle(c)));
}

/* Goes back to the state `backup` of time t, with laws of law_time; what the step has cost stays
   counted. */
static void restore_state(context *c, const double *backup, double t, double law_time)
{
    const double newton = c->s.head[S_NEWTON_ITERATIONS], uzawa = c->s.head[S_UZAWA_ITERATIONS],
                 as_pairs = c->s.head[S_AS_PAIRS];
    take_state(c, backup);
    if (c->m->time_dependent || c->m->sensing)
        set_laws(c, law_time, 0); /* the work of what they did is undone too */
    c->t = t;
    forget_secants(c);
    if (mesh_of(c)) mesh_of(c)->back_at = t;
    c->s.head[S_NEWTON_ITERATIONS] = newton;
    c->s.head[S_UZAWA_ITERATIONS] = uzawa;
    c->s.head[S_AS_PAIRS] = as_pairs;
}

/* Takes an internal step back. */
static void undo_step(context *c, double t, double law_time)
{ restore_state(c, c->k.pair_backup, t, law_time); }

/* Takes an internal step by the method in use, or by another one where that cannot. */
static int32_t take_step(context *c, double h, step_result *result)
{
    int order = (int)c->s.head[S_ORDER_IN_USE];
    result->method = UNTAKEN;
    result->finest = 0;
    if (c->s.head[S_EXPLICIT] != 0.0 && is_explicit_order(order) && may_step_explicitly(c)) {
        const double t = c->t, law_time = c->number[c->m->time_at];
        const int32_t status = runge_kutta_step(c, h, result);
        if (status || result->method == EXPLICIT) return status;
        undo_step(c, t, law_time);
    }
    if (order == 5)
        c->s.head[S_ORDER_IN_USE] = order =
            6; /* of order 4 nothing tells how fast differences fall, at a kink for one */
    const int is_judged = c->tolerance > 0.0;
    const int is_first =
        c->s.head[S_HALVES] != 2.0 || c->s.head[S_KNOWN] < 4.0; /* no pair before it judges it */
    if (order == 2 && is_judged && is_first) return judged_pair(c, h, result);
    if (order == 2 || !(is_judged || is_dissipative(c))) return composed_step(c, h, order, result);
    if (!is_judged && choose_methods(c)) return divided_step(c, h, order, result);
    return extrapolated_step(c, h, 0, result);
}

/* One internal step of length h. */
static int32_t internal_step(context *c, double h)
{
    if (mesh_of(c)) begin_row(c, h);
    const int32_t status = take_step(c, h, &c->last);
    if (!status && mesh_of(c)) end_row(c, taken_as(&c->last));
    return status;
}

/* After a failure penalties are those that were asked for with contacts, whose rows may have become
   dependent. Else they stay raised: a heavy load on light links fails where its tension ends, and
   needs them all the more in shorter steps. */
HM_OFTEN void lower_penalties(context *c)
{
    if (!is_unilateral(c->m)) return;
    if (mesh_of(c)) note_ahead(c, 0);
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        double *own = c->s.islands + I_SIZE * island;
        own[I_PENALTY_LEVEL] = own[I_SLOW_STEPS] = 0.0;
    }
}

/* Keeps the state before a step that is divided: events may cut it. */
static void keep_start(context *c)
{
    keep_state(c, c->k.event_backup);
    keep_ahead(c);
    c->event.divided = 1;
}

/* A step of length h, divided until it can be taken; `left` halvings may follow, UNDIVIDED where
   none has been. */
enum { UNDIVIDED = -1 };

static int32_t step_halving(context *c, double h, int left)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    if (is_stopped(c)) return HOLONOM_STOPPED;
    if (left == UNDIVIDED) c->event.divided = 0;
    int32_t status = internal_step(c, h);
    c->step.careful = status != HOLONOM_OK;
    if (!status) return HOLONOM_OK;
    undo_step(c, t, law_time);
    lower_penalties(c);
    if (known_misses(c)) { /* Newton's iteration may only have begun too far away: polynomials miss
                              what turns fast */
        forget_halves(c);
        return step_halving(c, h, left);
    }
    if (is_unilateral(c->m)) return status; /* an event may be in it: the piece is cut instead */
    if (left == UNDIVIDED) left = most_halvings(c, h, status);
    if (left == 0) return status;
    status = step_halving(c, 0.5 * h, left - 1);
    return status ? status : step_halving(c, 0.5 * h, left - 1);
}

#endif
