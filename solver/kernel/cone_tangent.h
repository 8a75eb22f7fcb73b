/* Derivatives of the multipliers that sliding frictions are held to. */
#ifndef HOLONOM_CONE_TANGENT_H
#define HOLONOM_CONE_TANGENT_H

#include "function.h"
#include "row_state.h"

/* Place of the unknown of a node among those of composite j, or -1. */
static int32_t place_of_unknown(const context *c, int32_t j, int32_t node)
{
    const int32_t begin = c->m->composite_node_ptr[j], count = c->m->composite_node_ptr[j + 1] - begin;
    int32_t *place = local_place(c) + c->m->n_local_nodes;
    local_places(c, j, place);
    for (int32_t k = 0; k < count; k++)
        if (first_of_unknown(c, c->m->composite_node[begin + k]) == first_of_unknown(c, node)) return place[k];
    return -1;
}

/* Slots of the lower part of row j, the entries of its own line in the tangent. */
static const int32_t *lower_slots(const context *c, int32_t j)
{
    const int32_t size = local_places(c, j, local_place(c) + c->m->n_local_nodes);
    return c->lu->composite_slot + c->lu->composite_slot_ptr[j] + size + (is_lean(c) ? 0 : size * size);
}

/* Adds to the tangent how friction f, of several rows or smooth, turns with its slip, of this size: epsilon d lambda_k/d psi_l
   d psi_l/d w. */
HM_SELDOM static int32_t turning_tangent(const context *c, int32_t f, const double *along, double slip, double *value)
{
    const holonom_model *m = c->m;
    /* A slip that is stopped overshoots by the slope of its law, and comes back so, for ever; by a part of the chord it does not. */
    const double turns = c->careful && is_smooth(c, f) ? 0.5 : 1.0;
    const double per_slip = slip != 0.0 ? cone(c, f, 1, normal_force(c, f, c->cone_mu)) / slip : 0.0;
    for (int l = 0; l < n_slips(c, f) && per_slip != 0.0; l++) {
        const int32_t j = slip_row(c, f, l), forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
        const int32_t *node = m->composite_node + m->composite_node_ptr[j], *end = m->composite_node + m->composite_node_ptr[j + 1];
        composite_result result = {0.0, 0.0, 0.0};
        const int32_t status = composite_slopes(c, j, WITH_ENDS, &result);
        if (status) return status;
        const int32_t size = local_gradients(c, j);
        for (int32_t at = 0, next = 0; node < end; node++) { /* each unknown once */
            if (*node < next) continue;
            next = next_unknown(c, first_of_unknown(c, *node));
            for (int i = 0; i < unknown_size(c, *node); i++, at++) {
                double slope = 0.0; /* d psi_l/d w */
                for (int32_t k = 0; k < forms; k++) slope += c->k.end[k] * c->k.gradient_end[size * k + at] / c->h;
                for (int k = 0; k < n_slips(c, f); k++) {
                    const int32_t own = slip_row(c, f, k), place = place_of_unknown(c, own, *node);
                    const double turn = per_slip * ((k == l) - turns * along[k] * along[l]) * slope;
                    if (place >= 0) value[lower_slots(c, own)[place + i]] += c->k.epsilon[row_of(c, own)] * turn;
                }
            }
        }
    }
    return HOLONOM_OK;
}

/* Adds to the tangent epsilon times the derivatives of the multipliers of sliding frictions: with respect to the multipliers
   of their normal forces and, of several rows, to the velocities. */
HM_SELDOM static int32_t cone_tangent(const context *c, double *value)
{
    const holonom_model *m = c->m;
    int32_t status = HOLONOM_OK;
    for (int32_t f = 0; f < m->n_frictions && c->sliding; f++) {
        double along[3], root = 0.0;
        if (friction_mode(c, f) != FRICTION_SLIDES || !is_at_hand(c, f)) continue;
        const int32_t *slot = c->lu->cone_slot + c->lu->cone_slot_ptr[f];
        const double slip = slip_direction(c, f, along);
        for (int k = 0; k < n_slips(c, f); k++)
            for (int32_t at = m->normal_ptr[f]; at < m->normal_ptr[f + 1]; at++) {
                const int32_t row = m->normal_row[2 * at], how = m->normal_row[2 * at + 1];
                if (how == NORMAL_BEGINS) sum_of_squares(c, f, at, c->cone_mu, &root);
                const double slope = how == NORMAL_PUSHES ? -1.0 : root > 0.0 ? c->cone_mu[row] / root : 0.0;
                const double epsilon = c->k.epsilon[row_of(c, slip_row(c, f, k))];
                value[*slot++] += epsilon * c->number[m->sliding_at + f] * slope * along[k];
            }
        if ((n_slips(c, f) > 1 || is_smooth(c, f)) && !c->at_state) status = turning_tangent(c, f, along, slip, value);
        if (status) return status;
    }
    return status;
}

#endif
