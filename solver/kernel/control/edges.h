/* Edges that closed contacts pass within a step.

   A step of a closed contact past an edge turns a velocity about the chord between its ends, at any
   angle, and closes the ledger all the same. What shows it are a rate across the surface, over the
   speed at the contact, and an impulse that the forces at both ends do not tell: it makes a speed
   of free nodes, over that of the contact's own. Other parts may be far faster. */
#ifndef HOLONOM_EDGES_H
#define HOLONOM_EDGES_H

#include "event_functions.h"

/* Parts of these speeds: on smooth surfaces steps of a usual length leave 1e-2 of it,
   or less. */
#define ACROSS_EDGE 0.05
#define SURELY_SMOOTH 1e-3 /* a smaller part: forces at the end need not be evaluated */
#define NO_EDGE 100.0      /* a larger one: no edge turns by so much, but a load that jumps may */
#define JUMP_AT_EDGE 1e-3  /* in a short piece, in which forces change the rate by some 1e-6 */

/* Multipliers have a part that changes sign from one half step to the next: they tell less than
   rates do. */
#define TOLD_BY_FORCES 0.25

/* State at the start of the piece at hand. */
static const double *start_of_piece(const context *c)
{ return c->event.divided ? c->k.event_backup : c->k.pair_backup; }

/* Rate of form f if its links moved along each other; its value is *s. */
static double rate_of_links(const context *c, int32_t f, double *s)
{
    double u[DIM], w[DIM], u_rate[DIM], w_rate[DIM];
    link_at_state(c, f, u, w);
    link_of(c, f, c->s.v, u_rate, w_rate);
    *s = dot(u, w);
    return sqrt(dot(u, u) * dot(w_rate, w_rate)) + sqrt(dot(w, w) * dot(u_rate, u_rate));
}

/* Likewise of quantity q. */
static double rate_of_its_links(const context *c, int32_t q)
{
    const int32_t *form = c->m->quantity_form + 2 * q, kind = c->m->quantity_kind[q];
    double s[2], rate = rate_of_links(c, form[0], s);
    if (kind == QUANTITY_LENGTH) return s[0] > 0.0 ? 0.5 * rate / sqrt(s[0]) : 0.0;
    if (kind == QUANTITY_FORM) return rate;
    const double other = rate_of_links(c, form[1], s + 1), square = s[0] * s[0] + s[1] * s[1];
    return square > 0.0 ? (fabs(s[0]) * other + fabs(s[1]) * rate) / square : 0.0;
}

/* Speed at contact i, along its surface, too: the rate that its gap would have if all links moved
   along each other. */
static double speed_at_contact(const context *c, int32_t i)
{
    const int32_t j = c->m->contact_row[i], n = c->m->leaf_ptr[j + 1] - c->m->leaf_ptr[j],
                  *entry = c->m->leaf + 4 * c->m->leaf_ptr[j];
    double speed = 0.0;
    gap_rate(c, i); /* slopes of the leaves, and rates of signals */
    for (int32_t l = 0; l < n; l++, entry += 4)
        speed +=
            fabs(c->k.r.adjoint[l])
            * (entry[0] == LEAF_SIGNAL ? fabs(c->k.leaves[l]) : rate_of_its_links(c, entry[1]));
    return speed;
}

/* Speed of the fastest of its free nodes; directors count times the size of the mechanism. */
static double fastest_of_contact(const context *c, int32_t i)
{
    const holonom_model *m = c->m;
    const int32_t j = m->contact_row[i];
    double largest = 0.0;
    for (int32_t at = m->composite_node_ptr[j]; at < m->composite_node_ptr[j + 1]; at++) {
        const int32_t a = m->composite_node[at];
        const double square = dot(c->s.v + DIM * a, c->s.v + DIM * a);
        largest =
            fmax(largest, m->node_kind[a] ? square * hm_square(c->number[m->extent_at]) : square);
    }
    return sqrt(largest);
}

/* What a normal force does to the rate of gap i in a time h, if its nodes were free. No speed there
   counts as less: rates across a surface are left from when a contact was faster, and one that is
   so slow errs by no more than forces in a piece do if it passes an edge. */
static double speed_by_force(const context *c, int32_t i, double h, double force)
{ return fabs(force) * h * c->number[c->m->row_sigma_at + row_of(c, c->m->contact_row[i])]; }

/* Speed by which the row of contact i has changed the velocities in a piece of length h beyond what
   a force does. Multipliers do not tell that of steps too short for them, in which forces do next
   to nothing. */
static double speed_beyond(const context *c, int32_t i, double h, double force)
{
    const int32_t j = c->m->contact_row[i], row = row_of(c, j);
    const double *v0 = start_of_piece(c) + (c->s.v - c->s.head);
    const double per_force = c->number[c->m->row_sigma_at + row];
    if (c->last.method == EXPLICIT) return fabs(c->s.mean[row] + force) * h * per_force;
    if (is_telling(c)) {
        const double halves = fmax(fabs(c->s.mu[0][row] + force), fabs(c->s.mu[1][row] + force));
        double means = 0.0;
        for (int32_t k = 0; k < c->step.n_kept_forces; k++)
            means = fmax(means, fabs(c->k.kept_forces[(int64_t)c->m->n_rows * k + row] + force));
        return TOLD_BY_FORCES * per_force * fabs(c->h) * fmax(halves, means);
    }
    return fabs(gap_rate(c, i) - function_rate(c, j, v0, c->k.signal_rate));
}

/* Whether contact i has a rate across its surface that only an edge leaves; `least` is
   speed_by_force. */
static int is_across(const context *c, int32_t i, double least)
{
    const double across = fabs(gap_rate(c, i));
    return across > speed_tolerance(c)
           && across > ACROSS_EDGE * fmax(speed_at_contact(c, i), least);
}

/* Whether a speed is more than a part of those of contact i: of its nodes, and at the contact,
   where driven nodes may be faster. */
static int exceeds_speeds(const context *c, int32_t i, double speed, double part, double least)
{
    return speed > fmax(part * fmax(fastest_of_contact(c, i), least), speed_tolerance(c))
           && speed > part * speed_at_contact(c, i);
}

/* Whether closed contacts seem to have passed an edge in a piece of length h that ends at the
   state, whose functions at its ends are known; under a tolerance errors tell, and cut it. */
static int passes_edge(const context *c, double h, event_values low, event_values high)
{
    if (c->tolerance > 0.0) return 0;
    const int is_shared = has_shares(c) || c->event.together || may_have_dependent_rows(c);
    EACH_CONTACT(c, i) {
        if (!is_closed(c, i)) continue;
        const double force = 0.5 * (low.value[i] + high.value[i]),
                     least = speed_by_force(c, i, h, force);
        if (is_across(c, i, least)) return 1;
        if (is_shared) continue;
        const double beyond = speed_beyond(c, i, h, force);
        if (exceeds_speeds(c, i, beyond, ACROSS_EDGE, least)
            && !exceeds_speeds(c, i, beyond, NO_EDGE, least))
            return 1;
    }
    return 0;
}

/* Whether a piece of length h, at whose start the normal force of closed contact i was `force`,
   may have ended past an edge of it, likewise. */
static int is_edge_near(const context *c, int32_t i, double h, double force, int is_shared)
{
    if (c->tolerance > 0.0) return 0;
    const double least = speed_by_force(c, i, h, force);
    if (is_shared) return is_across(c, i, least);
    return !is_telling(c)
           || exceeds_speeds(c, i, speed_beyond(c, i, h, force), SURELY_SMOOTH, least);
}

/* Whether closed contacts have passed an edge in the short piece of length h that ends here, where
   functions were `low` at its start: the rate of their gap has jumped. Longer steps across one
   fail, however often they are halved. Those whose surface falls away there part; those that run
   into another one are hit. */
HM_SELDOM static int part_at_edges(context *c, double h, event_values low)
{
    int passed = 0;
    evaluate_state(c);
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        if (!is_closed(c, i)) continue;
        const double change = gap_rate(c, i) - c->k.gap_rates[i],
                     least = speed_by_force(c, i, h, low.value[i]);
        if (!exceeds_speeds(c, i, fabs(change), JUMP_AT_EDGE, least)) continue;
        passed = 1;
        blame(c, c->m->contact_row[i]);
        if (change > 0.0) open_contact(c, i), contact_of(c, i)[C_PARTED] = 1.0;
    }
    return passed;
}

#endif
