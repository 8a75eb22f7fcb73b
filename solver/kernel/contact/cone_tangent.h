/* Derivatives of the multipliers that sliding frictions are held to. */
#ifndef HOLONOM_CONE_TANGENT_H
#define HOLONOM_CONE_TANGENT_H

#include "function.h"
#include "row_state.h"

/* Place of the unknown of a node among those of composite j, or -1. */
static int32_t place_of_unknown(const context *c, int32_t j, int32_t node)
{
    const int32_t begin = c->m->composite_node_ptr[j],
                  count = c->m->composite_node_ptr[j + 1] - begin;
    int32_t *place = local_place(c) + c->m->n_local_nodes;
    local_places(c, j, place);
    for (int32_t k = 0; k < count; k++)
        if (first_of_unknown(c, c->m->composite_node[begin + k]) == first_of_unknown(c, node))
            return place[k];
    return -1;
}

/* Slots of the lower part of row j, the entries of its own line in the tangent. */
static const int32_t *lower_slots(const context *c, int32_t j)
{
    const int32_t size = local_places(c, j, local_place(c) + c->m->n_local_nodes);
    return c->factors.lu->composite_slot + c->factors.lu->composite_slot_ptr[j] + size
           + (is_lean(c) ? 0 : size * size);
}

/* Adds to the tangent how a friction of several rows, or a smooth one, turns with its slip of row
   j, epsilon d lambda_k/d psi_j d psi_j/d w; the slopes of j and their gradients, over so many
   unknowns, are at hand. */
HM_SELDOM static void turning_tangent(const context *c, int32_t j, int32_t size, double *value)
{
    const holonom_model *m = c->m;
    const int32_t f = owner_of(c, j) - m->n_contacts,
                  forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
    const int32_t *node = m->composite_node + m->composite_node_ptr[j],
                  *end = m->composite_node + m->composite_node_ptr[j + 1];
    double along[3], turn[3];
    if (n_slips(c, f) == 1 && !is_smooth(c, f)) return;
    const double slip = slip_direction(c, f, along);
    const int32_t *slots[3];
    /* A slip that is stopped overshoots by the slope of its law, and comes back so, for ever; by a
       part of the chord it does not. */
    const double turns = c->step.careful && is_smooth(c, f) ? 0.5 : 1.0;
    const double per_slip =
        slip != 0.0 ? cone(c, f, 1, normal_force(c, f, c->friction.cone_mu)) / slip : 0.0;
    if (per_slip == 0.0) return;
    int l = 0;
    while (slip_row(c, f, l) != j) l++;
    for (int k = 0; k < n_slips(c, f); k++) {
        slots[k] = lower_slots(c, slip_row(c, f, k));
        turn[k] = per_slip * ((k == l) - turns * along[k] * along[l]);
    }
    for (int32_t at = 0, next = 0; node < end; node++) { /* each unknown once */
        if (*node < next) continue;
        next = next_unknown(c, first_of_unknown(c, *node));
        const int32_t count = unknown_size(c, *node);
        double slope[DIM]; /* d psi_j/d w */
        for (int i = 0; i < count; i++) {
            slope[i] = 0.0;
            for (int32_t g = 0; g < forms; g++)
                slope[i] += c->k.end[g] * c->k.gradient_end[size * g + at + i];
            slope[i] /= c->h;
        }
        for (int k = 0; k < n_slips(c, f); k++) {
            const int32_t own = slip_row(c, f, k),
                          place = own == j ? at : place_of_unknown(c, own, *node);
            const double epsilon = c->k.epsilon[row_of(c, own)];
            for (int i = 0; i < count && place >= 0; i++)
                value[slots[k][place + i]] += epsilon * (turn[k] * slope[i]);
        }
        at += count;
    }
}

/* Adds to the tangent epsilon times the derivatives of the multipliers of sliding frictions with
   respect to the multipliers of their normal forces. */
HM_SELDOM static void cone_tangent(const context *c, double *value)
{
    const holonom_model *m = c->m;
    for (int32_t f = 0; f < m->n_frictions && c->friction.slides; f++) {
        double along[3], root = 0.0;
        if (friction_mode(c, f) != FRICTION_SLIDES || !is_at_hand(c, f)) continue;
        const int32_t *slot = c->factors.lu->cone_slot + c->factors.lu->cone_slot_ptr[f];
        slip_direction(c, f, along);
        for (int k = 0; k < n_slips(c, f); k++)
            for (int32_t at = m->normal_ptr[f]; at < m->normal_ptr[f + 1]; at++) {
                const int32_t row = m->normal_row[2 * at], how = m->normal_row[2 * at + 1];
                if (how == NORMAL_BEGINS) sum_of_squares(c, f, at, c->friction.cone_mu, &root);
                const double slope = how == NORMAL_PUSHES ? -1.0
                                     : root > 0.0         ? c->friction.cone_mu[row] / root
                                                          : 0.0;
                const double epsilon = c->k.epsilon[row_of(c, slip_row(c, f, k))];
                value[*slot++] += epsilon * c->number[m->sliding_at + f] * slope * along[k];
            }
    }
}

#endif
