/* How fast springs and dampers alone move a mechanism: what an explicit step can resolve (theory 8.8). */
#ifndef HOLONOM_FORCE_RATES_H
#define HOLONOM_FORCE_RATES_H

#include "context.h"

/* Products of inertia, squared over both moments, up to which the diagonal of M tells M^-1: bars have 1/4. */
#define DIAGONAL_ENOUGH 0.3

/* Turn of a spring's motion, and way of a damper's, over its time constant, in an explicit step. The method is stable to 5.8 and 6.4
   (Hairer, Norsett and Wanner 1993, II.10), a spring at 4.2 loses a fortieth of its motion in a step; the traces below are sums over all. */
#define MOST_TURNED 4.2
#define MOST_SETTLED 4.0

/* Longest explicit step [s], by the traces of M^-1 K and M^-1 C with the diagonal of M; 0 with large products of inertia, with
   potentials, and with springs and dampers of other quantities than lengths, which do not tell how stiff they are. */
HM_SELDOM static double longest_explicit(const context *c)
{
    const holonom_model *m = c->m;
    double springs = 0.0, dampers = 0.0, *diagonal = c->k.ahead;
    if (m->n_potentials) return 0.0;
    if (!m->n_elements) return INFINITY;
    memset(diagonal, 0, sizeof(double) * (size_t)m->n_free);
    for (int32_t e = 0; e < m->n_mass_free; e++)
        if (m->mass_node[2 * e] == m->mass_node[2 * e + 1]) diagonal[m->mass_node[2 * e]] += c->number[m->mass_at + e];
    for (int32_t e = 0; e < m->n_mass_free; e++) {
        const int32_t a = m->mass_node[2 * e], b = m->mass_node[2 * e + 1];
        if (a != b && hm_square(c->number[m->mass_at + e]) > DIAGONAL_ENOUGH * diagonal[a] * diagonal[b]) return 0.0;
    }
    for (int32_t j = 0; j < m->n_elements; j++) {
        const double stiffness = c->number[m->stiffness_at + j], damping = c->number[m->damping_at + j];
        const int32_t q = m->leaf[4 * m->leaf_ptr[j] + 1], f = m->quantity_form[2 * q];
        if (stiffness == 0.0 && damping == 0.0) continue;
        if (m->quantity_kind[q] != QUANTITY_LENGTH) return 0.0;
        for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++) {
            const double turn = m->form_kind[f] & FORM_TURNED ? c->number[m->alpha_turn_at + e] : 0.0;
            const double share = (hm_square(c->number[m->alpha_at + e]) + turn * turn) / diagonal[m->form_node[e]];
            springs += stiffness * share;
            dampers += damping * share;
        }
    }
    return 1.0 / hm_hypot(sqrt(springs) / MOST_TURNED, dampers / MOST_SETTLED);
}

#endif
