/* Steps in which some islands take covers and others a composition (theory 8.3).

   Islands share nothing, so that each may pass through times of its own within a step: all covers
   of those that lose energy are taken first, and then, from the start of the step again, the
   composition of the others. Both end at the same time, where events, switches and outputs are. */
#ifndef HOLONOM_DIVIDED_STEP_H
#define HOLONOM_DIVIDED_STEP_H

#include "composition.h"
#include "extrapolation.h"

/* Lets islands that lose energy take covers in the step to come, and those with contacts or
   frictions, of which pairs tell forces in one order of times alone; the others take compositions,
   which keep energy and are symmetric. Returns whether there are others: laws that read the
   mechanism may read one island and act on another. */
HM_SELDOM static int choose_methods(context *c)
{
    int composed = 0;
    if (n_apart(c) == 1 || c->m->sensing) return 0;
    EACH_ISLAND(c, island) {
        c->k.covered[island] = is_dissipative(c) || has_events(c);
        composed |= c->k.covered[island] == 0.0;
    }
    return composed;
}

/* Moves both means of multipliers and driven forces of the islands at hand, which are of the last
   two times of the composition, along their line to the times of those of the covers. */
static void move_means(context *c, double time, double before)
{
    hm_state *s = &c->s;
    const double last = s->head[S_MEAN_TIME], length = last - s->head[S_MEAN_TIME_BEFORE];
    const int64_t first = c->m->n_free;
    if (length == 0.0) return;
    EACH_ROW(c, i) {
        const double slope = (s->mean[i] - s->mean_before[i]) / length, mean = s->mean[i];
        s->mean[i] = mean + slope * (time - last);
        s->mean_before[i] = mean + slope * (before - last);
    }
    for (int64_t k = DIM * (c->view.begin[ISLAND_DRIVEN] - first);
         k < DIM * (c->view.end[ISLAND_DRIVEN] - first); k++) {
        const double mean = s->driven_mean[k], slope = (mean - s->driven_mean_before[k]) / length;
        s->driven_mean[k] = mean + slope * (time - last);
        s->driven_mean_before[k] = mean + slope * (before - last);
    }
}

/* Covers of some islands, and behind them a composition of the others, from the same time. Only
   covers tell of contacts within the step, and of its method. */
HM_SELDOM static int32_t divided_step(context *c, double h, int order, step_result *result)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    c->view.chosen = COVERED_ISLANDS;
    int32_t status = extrapolated_step(c, h, 2 * n_stages(order), result);
    if (!status) {
        double *head = c->s.head;
        const double time = head[S_MEAN_TIME], before = head[S_MEAN_TIME_BEFORE];
        const int32_t kept = c->step.n_kept_forces;
        c->view.chosen = COMPOSED_ISLANDS;
        take_section(c, c->s.signal, c->m->n_signals, c->k.pair_backup);
        begin_anew(c, t, law_time);
        EACH_ISLAND(c, island) {
            EACH_TURN(c, b) straighten(c, c->m->body_node[b]); /* as the first half of a step */
        }
        status = take_pairs(c, h, order, halves_of(order / 2));
        EACH_ISLAND(c, island) { move_means(c, time, before); }
        if (c->m->time_dependent) set_laws(c, t + h, 1); /* as covers have left them */
        head[S_MEAN_TIME] = time, head[S_MEAN_TIME_BEFORE] = before;
        c->step.n_kept_forces = kept;
    }
    c->view.chosen = ALL_ISLANDS;
    return status;
}

#endif
