/* Whether a half step that is solved obeys the laws of contact, with which contacts are closed and
   which frictions stick:

       0 <= N _|_ g(q_1) >= 0,     |T| <= c_s N + preload where there is no slip, else T = (c N +
   preload) t.

   A contact or friction that violates its law objects to the choice, and may change. */
#ifndef HOLONOM_COMPLEMENTARITY_H
#define HOLONOM_COMPLEMENTARITY_H

#include "half_step_contacts.h"

#define ROUND_OFF 1e-15  /* of a coordinate, over the size of the mechanism */

/* Way of the node that moves most in the half step. */
static double largest_way(const context *c) { return sqrt(largest_square(c, c->k.d)); }

/* Contacts and frictions (behind the contacts) that object to a choice: how many, and the last one;
   and which of them are to change. */
typedef struct objections {
    int count;
    int32_t last, changing;
    int at_once; /* whether slips that stop do so at the start of the half step */
} objections;

enum { NONE_CHANGES = -2, ALL_CHANGE = -1 };

/* Counts contact k, or friction k - n_contacts, among the objections; returns whether it is to
   change. */
static int add_objection(context *c, objections *x, int32_t k)
{
    const int changes = x->changing == ALL_CHANGE || x->changing == k;
    x->count++;
    x->last = k;
    if (changes)
        blame(c,
              k < c->m->n_contacts ? c->m->contact_row[k] : slip_row(c, k - c->m->n_contacts, 0));
    return changes;
}

/* Closes open contacts that the half step leaves in penetration, of those that are near or of
   `all`. */
static int32_t close_crossed(context *c, int all, objections *x)
{
    const double none = PENETRATION * c->number[c->m->extent_at], reach = 4.0 * largest_way(c);
    int32_t status = HOLONOM_OK;
    EACH_CONTACT(c, i) {
        if (status) break;
        const int32_t *leaf = c->m->leaf + 4 * c->m->leaf_ptr[c->m->contact_row[i]];
        const int turns = leaf[0] != LEAF_SIGNAL && c->m->quantity_kind[leaf[1]] == QUANTITY_ANGLE;
        double gap = INFINITY;
        if (is_closed(c, i)
            || (touch_of(c, i)->is_near == 0.0
                && (!all || (!turns && touch_of(c, i)->gap > reach))))
            continue;
        status = gap_at_end(c, i, &gap);
        if (!(gap < -none)) continue;
        touch_of(c, i)->is_near = 1.0;
        if (add_objection(c, x, i)) close_contact_at(c, i, 0.0);
    }
    return status;
}

/* What rounding errors of the coordinates make of the normal force of contact i. None is allowed of
   one that slides: pulled, its friction would drive it and make energy. */
static double noise_of_normal(const context *c, int32_t i)
{
    const double *number = c->number, place = ROUND_OFF * number[c->m->extent_at];
    const int32_t f = c->m->contact_friction[i];
    if (f >= 0 && friction_mode(c, f) == FRICTION_SLIDES) return 0.0;
    return 2.0 * place
           / (c->h * c->h * number[c->m->row_sigma_at + row_of(c, c->m->contact_row[i])]);
}

/* Between two places on a surface that an edge parts, a discrete gradient may have any sign, and
   what pulls looks as if it pushed. Such a half step goes through the surface by this part of its
   way, and turns the velocity by this part of it. */
#define THROUGH_EDGE 0.02
#define TURNS_AT_EDGE 0.05

/* Whether contact i, closed at both ends of the half step that is solved, is in penetration in its
   middle, deeper than at its start; `way` is that of the fastest node. */
static int goes_through_edge(context *c, int32_t i, double way)
{
    const holonom_model *m = c->m;
    const int32_t n = DIM * (m->n_free + m->n_driven);
    const double turned = normal_in_step(c, i) * c->h * c->h
                          * c->number[m->row_sigma_at + row_of(c, m->contact_row[i])];
    double *q = c->k.ahead, *signal = c->k.signal_before;
    if (touch_of(c, i)->was_closed == 0.0 || !(turned > TURNS_AT_EDGE * way)) return 0;
    memcpy(q, c->s.q, sizeof(double) * (size_t)n);
    memcpy(signal, c->s.signal, sizeof(double) * (size_t)m->n_signals);
    for (int32_t k = 0; k < n; k++) c->s.q[k] += 0.5 * c->k.d[k];
    for (int32_t k = 0; k < m->n_signals; k++)
        c->s.signal[k] += 0.5 * (c->k.signal1[k] - signal[k]);
    const double gap = gap_of(c, i);
    memcpy(c->s.q, q, sizeof(double) * (size_t)n);
    memcpy(c->s.signal, signal, sizeof(double) * (size_t)m->n_signals);
    return gap < touch_of(c, i)->gap - THROUGH_EDGE * way - PENETRATION * c->number[m->extent_at];
}

/* Opens closed contacts that would pull. One whose friction sticks slides first: its friction may
   be what pulls. */
static void open_pulling(context *c, objections *x)
{
    const double none = NO_FORCE * largest_normal(c, c->k.mu), way = largest_way(c);
    EACH_CONTACT(c, i) {
        const int32_t f = c->m->contact_friction[i];
        double along[3];
        if (!is_closed(c, i)
            || !(normal_in_step(c, i) < -none - noise_of_normal(c, i)
                 || goes_through_edge(c, i, way))
            || !add_objection(c, x, i))
            continue;
        const int jams = f >= 0 && friction_mode(c, f) == FRICTION_STICKS && c->k.flips[f] < 2.0;
        if (!jams || !(friction_force(c, f, c->k.mu, along) > 0.0)) {
            open_contact(c, i);
            continue;
        }
        c->k.flips[f] = 2.0;
        forget_stop(c, f);
        let_slide(c, f, along);
    }
}

/* Lets frictions beyond their cones slide, and those stop whose slip the half step would reverse. A
   contact that lands slows the slip of joints, too: one that then goes on until the end does not
   stop before. */
static void change_frictions(context *c, objections *x)
{
    const double none = NO_FORCE * largest_normal(c, c->k.mu), still = 1e-3 * speed_tolerance(c);
    int lands = 0;
    EACH_CONTACT(c, i) lands |= is_landing(c, i);
    EACH_FRICTION(c, f) {
        const int mode = friction_mode(c, f);
        double along[3];
        if (mode == FRICTION_OFF || is_smooth(c, f)) continue;
        if (mode == FRICTION_STICKS) {
            const double limit = cone(c, f, 0, normal_force(c, f, c->k.mu));
            const double force = friction_force(c, f, c->k.mu, along);
            if (!(force > limit + CONE_MARGIN * fabs(limit) + none)
                || !add_objection(c, x, c->m->n_contacts + f))
                continue;
            forget_stop(c, f);
            let_slide(c, f, along);
        } else {
            const double before = along_direction(c, f, c->k.slip_before),
                         mean = along_direction(c, f, c->k.slip);
            const double least = x->at_once || (lands && !is_of_contact(c, f))
                                     ? 0.0
                                     : 0.5 * (1.0 - CONE_MARGIN) * fmax(before, 0.0);
            if (!(mean < least - still) || !add_objection(c, x, c->m->n_contacts + f)) continue;
            forget_stop(c, f);
            if (before > 0.0 && !x->at_once) let_stop(c, f, 0.5 * before / (before - mean));
            let_stick(c, f);
        }
        c->k.flips[f] += 1.0;
    }
}

/* Counts the objections to the step that was solved with `status`, and changes those of `changing`.
   Rows that contradict each other leave a step unsolved, with forces that pull. */
static int32_t look_for_objections(context *c, int32_t status, objections *x)
{
    x->count = 0;
    open_pulling(c, x);
    if (status) return x->count ? HOLONOM_OK : status;
    status = close_crossed(c, 0, x);
    if (!status) change_frictions(c, x);
    if (!status && !x->count) status = close_crossed(c, 1, x);
    return status;
}

#endif
