/* Which part a step has failed at, as far as the residuals of its last try tell. */
#ifndef HOLONOM_FAULT_H
#define HOLONOM_FAULT_H

#include "inputs_signals.h"

/* Whether x is larger than the largest so far, or no number: nothing is larger than that. */
static int exceeds(double x, double largest) { return largest == largest && !(x <= largest); }

#define MET 1e-9 /* part of its size by which a row may be off and is met */

/* The row that is off most, against its size; -1 if all are met. */
static int32_t worst_row(const context *c)
{
    double largest = MET;
    int32_t worst = -1;
    for (int32_t i = 0; i < c->m->n_rows; i++) {
        const double off = fabs(c->k.phi[i]) / c->number[c->m->row_scale_at + i];
        if (exceeds(off, largest)) largest = off, worst = i;
    }
    return worst;
}

/* The free node whose balance of momentum is off most, in the norm of its mass. */
static int32_t worst_node(const context *c)
{
    double largest = 0.0;
    int32_t worst = -1;
    for (int32_t a = 0; a < c->m->n_free; a++) {
        const double *x = c->k.momentum + DIM * a,
                     off = dot(x, x) / c->number[c->m->node_mass_at + a];
        if (exceeds(off, largest)) largest = off, worst = a;
    }
    return worst;
}

#define AT_ZERO 1e-4 /* length over the size of the mechanism */

/* The spring or damper whose points pass each other, where its force jumps to the opposite
   direction; -1 if there is none. */
static int32_t passed_element(const context *c)
{
    const holonom_model *m = c->m;
    for (int32_t j = 0; j < m->n_elements; j++) {
        const int32_t quantity = m->leaf[4 * m->leaf_ptr[j] + 1];
        const double at_zero = fabs(c->number[m->stiffness_at + j] * c->number[m->rest_at + j])
                               + fabs(c->number[m->drive_at + j]);
        double rate;
        if (m->quantity_kind[quantity] != QUANTITY_LENGTH
            || !(at_zero > 0.0 || c->number[m->damping_at + j] > 0.0))
            continue;
        if (quantity_at(c, quantity, c->s.q, c->s.q_low, c->s.v, &rate)
            < AT_ZERO * c->number[m->extent_at])
            return j;
    }
    return -1;
}

/* Blames a row, by its multiplier and 1, or a node or an element, by its number behind these and 1;
   nothing if none is known. */
HM_SELDOM static void blame_worst(context *c, int32_t status)
{
    const int of_elements = status == HOLONOM_STEP_COLLAPSED || status == HOLONOM_DAMPING_REVERSED
                            || status == HOLONOM_NEWTON_DIVERGED;
    const int32_t element = of_elements ? passed_element(c) : -1;
    const int of_rows = status == HOLONOM_UZAWA_DIVERGED || status == HOLONOM_NEWTON_DIVERGED;
    const int of_nodes = status == HOLONOM_NEWTON_DIVERGED || status == HOLONOM_NOT_FINITE
                         || status == HOLONOM_TURN_TOO_LARGE;
    const int32_t row = of_rows ? worst_row(c) : -1,
                  node = row < 0 && of_nodes ? worst_node(c) : -1;
    if (element >= 0) c->step.at_fault = 1 + c->m->n_rows + c->m->n_free + element;
    else if (row >= 0) c->step.at_fault = 1 + row;
    else if (node >= 0) c->step.at_fault = 1 + c->m->n_rows + node;
}

/* Blames a signal whose value, rate or second derivative at time t is not finite, of those up to an
   order: by its number thrice, plus that order, behind the nodes. Returns whether there is one;
   signal1, signal_rate and signal_bend are overwritten. */
HM_SELDOM static int blame_signal(context *c, double t, int orders)
{
    const double *found[] = {c->k.signal1, c->k.signal_rate, c->k.signal_bend};
    signals_at(c, t, c->k.signal1);
    signal_jets_at(c, t, c->k.signal_rate, c->k.signal_bend);
    for (int32_t b = 0; b < c->m->n_signals; b++)
        for (int order = 0; order <= orders; order++)
            if (!(fabs(found[order][b]) < INFINITY)) {
                c->step.at_fault = 1 + c->m->n_rows + c->n_moving + 3 * b + order;
                return 1;
            }
    return 0;
}

#endif
