/* First stage of a half step of stepped mode: solves the step with a choice of the contacts that
   are closed and of the frictions that stick, an active set, and changes those that object until
   none does. */
#ifndef HOLONOM_ACTIVE_CONTACTS_H
#define HOLONOM_ACTIVE_CONTACTS_H

#include "complementarity.h"

enum {
    MOST_CHOICES = 60, /* solutions of a half step */
    PATIENCE = 5,      /* choices in turn that may not lower the number of objections */
    FEW = 2,           /* objections that change the choice without a guess */
    FEW_NEAR = 8,      /* contacts near that need no guess */
    MOST_GUESSES = 8,
    MOST_SWEEPS = 10000, /* of a guess */
    CHOSEN = 20          /* sweeps in turn that close and open none: the choice is made */
};
#define RELAXATION 1.6     /* of these sweeps */
#define BEYOND 10.0        /* times the largest force guessed: contacts contradict each other */

/* Gradient of gap i over its free nodes, in the middle of the half step. */
static int32_t gradient_of_gap(const context *c, int32_t i, double *gradient, double *gap)
{
    const holonom_model *m = c->m;
    const int32_t j = m->contact_row[i],
                  size = DIM * (m->composite_node_ptr[j + 1] - m->composite_node_ptr[j]);
    const int32_t status = gap_at_end(c, i, gap);
    if (status) return status;
    local_gradients(c, j, 1);
    for (int32_t k = 0; k < size; k++) gradient[k] = 0.0;
    for (int32_t f = 0; f < m->composite_form_ptr[j + 1] - m->composite_form_ptr[j]; f++)
        for (int32_t k = 0; k < size; k++)
            gradient[k] += c->k.slope[f] * c->k.gradient[size * f + k];
    return HOLONOM_OK;
}

/* Chooses anew, from the half step that is solved, those contacts that would be closed if masses of
   nodes were all that couples gaps: N >= 0 _|_ g + W (N - N_0) >= 0 by projected over-relaxed
   sweeps (Cryer 1971), which cost far less than another factorisation, until the choice settles:
   forces in a pile do so far later. Where rows couple gaps, too, more will object. */
static int32_t guess_choice(context *c, int parity)
{
    const holonom_model *m = c->m;
    const int32_t stride = DIM * m->n_local_nodes + 4;
    const double half = 0.5 * c->h * c->h, none = PENETRATION * c->number[m->extent_at];
    double *way = c->k.ahead, *const first = c->k.sweep,
           *end = first; /* of each near contact: gap, N, W, its index, gradient */
    memset(way, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    EACH_CONTACT(c, i) {
        const int32_t j = m->contact_row[i], *node = m->composite_node + m->composite_node_ptr[j];
        const int32_t size = DIM * (m->composite_node_ptr[j + 1] - m->composite_node_ptr[j]);
        if (touch_of(c, i)->is_near == 0.0) continue;
        const int32_t status = gradient_of_gap(c, i, end + 4, end);
        if (status) return status;
        end[1] = is_closed(c, i) ? normal_in_step(c, i) : 0.0;
        end[2] = 0.0;
        end[3] = i;
        for (int32_t k = 0; k < size; k++)
            end[2] += half * hm_square(end[4 + k]) / c->number[m->node_mass_at + node[k / DIM]];
        end += stride;
    }
    for (int sweep = 0, since = 0; sweep < MOST_SWEEPS && since < CHOSEN; sweep++, since++) {
        double largest = 0.0;
        for (double *at = first; at < end; at += stride) {
            const int32_t j = m->contact_row[(int32_t)at[3]],
                          *node = m->composite_node + m->composite_node_ptr[j];
            const int32_t size = DIM * (m->composite_node_ptr[j + 1] - m->composite_node_ptr[j]);
            double gap = at[0];
            for (int32_t k = 0; k < size; k++)
                gap += at[4 + k] * way[DIM * node[k / DIM] + k % DIM];
            const double normal = at[2] > 0.0 ? fmax(at[1] - RELAXATION * gap / at[2], 0.0) : 0.0,
                         change = normal - at[1];
            for (int32_t k = 0; k < size; k++)
                way[DIM * node[k / DIM] + k % DIM] +=
                    half * change * at[4 + k] / c->number[m->node_mass_at + node[k / DIM]];
            if ((normal > 0.0) != (at[1] > 0.0)) since = 0;
            at[1] = normal;
            largest = fmax(largest, fabs(change) * at[2]);
        }
        if (largest <= none) break;
    }
    for (const double *at = first; at < end; at += stride) {
        const int32_t i = (int32_t)at[3];
        touch_of(c, i)->normal = at[1];
        c->s.mu[parity][row_of(c, m->contact_row[i])] =
            -at[1]; /* decides what dependent rows leave open */
        if (at[1] > 0.0 && !is_closed(c, i)) close_contact_at(c, i, 0.0);
        else if (!(at[1] > 0.0) && is_closed(c, i)) open_contact(c, i);
    }
    return HOLONOM_OK;
}

/* Of closed contacts that contradict each other, since there are more of them than they can hold,
   opens the one whose force vanishes first on the way from the last one solved to where the failed
   iteration has gone; 0 if there is none. */
static int open_contradicting(context *c)
{
    double least = INFINITY;
    int32_t first = -1;
    EACH_CONTACT(c, i) {
        const double before = fmax(touch_of(c, i)->normal, 0.0),
                     change = is_closed(c, i) ? before - normal_in_step(c, i) : 0.0;
        if (change > before && before / change < least) least = before / change, first = i;
    }
    if (first < 0) return 0;
    blame(c, c->m->contact_row[first]);
    open_contact(c, first);
    return 1;
}

/* Whether forces are far beyond those that were guessed: closed contacts hold each other, up to a
   little that they contradict. */
static int contradicts(const context *c, int guessed)
{
    double largest = 0.0;
    if (!guessed) return 0;
    EACH_CONTACT(c, i) largest = fmax(largest, touch_of(c, i)->normal);
    return largest > 0.0 && largest_normal(c, c->k.mu) > BEYOND * largest;
}

static int n_near(const context *c)
{
    int n = 0;
    EACH_CONTACT(c, i) n += touch_of(c, i)->is_near != 0.0;
    return n;
}

static void keep_normals(const context *c)
{
    EACH_CONTACT(c, i)
        touch_of(c, i)->normal = is_closed(c, i) ? normal_in_step(c, i) : 0.0;
}

/* Whether a step that was solved so may have failed by its choice. */
static inline int may_choose_anew(int32_t status)
{
    return status == HOLONOM_CONTACT_UNDECIDED || status == HOLONOM_NEWTON_DIVERGED
           || status == HOLONOM_UZAWA_DIVERGED;
}

/* Solves the half step with the choice at hand until no contact or friction objects. Where many do,
   they are guessed anew. Else all change at once as long as they become fewer now and then, or the
   last one alone, by which no choice comes back (Murty 1974; Judice and Pires 1994), until they are
   fewer again. Stops that contradict each other even after one share leave it undecided. */
static int32_t solve_choices(context *c, int parity, int at_once)
{
    int fewest = INT_MAX, patience = PATIENCE, together = 0, guesses = 0;
    const int are_many = !at_once && n_near(c) > FEW_NEAR;
    for (int choice = 0; choice < MOST_CHOICES; choice++) {
        objections x = {0, 0, NONE_CHANGES, at_once};
        c->factors.kept_h = 0.0;
        int32_t status = solve_step(c, parity), solved = status;
        if (status && !may_choose_anew(status)) return status;
        if (status && together) return HOLONOM_CONTACT_UNDECIDED;
        if (status && (together = stop_together(c))) continue;
        status = look_for_objections(c, solved, &x);
        if (status || !x.count) return status;
        if (x.count < fewest) fewest = x.count, patience = PATIENCE;
        else if (patience > 0) patience--;
        if (are_many && solved
            && !guesses) { /* closed contacts contradict each other: from none on */
            EACH_CONTACT(c, i) open_contact(c, i);
            continue;
        }
        if (are_many && (solved || contradicts(c, guesses)) && open_contradicting(c)) continue;
        if (!solved) keep_normals(c);
        if (are_many && !solved && x.count > FEW && guesses++ < MOST_GUESSES) {
            if ((status = guess_choice(c, parity))) return status;
            continue;
        }
        x.changing = patience > 0 ? ALL_CHANGE : x.last;
        look_for_objections(c, solved, &x);
        if (together) stop_together(c);
    }
    return HOLONOM_CONTACT_UNDECIDED;
}

/* First stage. Slips that stop do so within the half step or, where no choice agrees, at its
   start. */
static int32_t solve_contacts(context *c, int parity)
{
    int32_t status = HOLONOM_CONTACT_UNDECIDED;
    for (int at_once = 0; at_once < 2 && may_choose_anew(status); at_once++) {
        if (at_once) take_section(c, c->s.contacts, c->s.n_modes, c->k.stepped_backup);
        begin_choice(c, c->h);
        status = solve_choices(c, parity, at_once);
        if (!c->m->n_frictions) break;
    }
    return status;
}

#endif
