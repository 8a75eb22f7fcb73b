/* Links and rows at the state to about twice the digits of a double (theory 1.6). */
#ifndef HOLONOM_EXACT_H
#define HOLONOM_EXACT_H

#include "context.h"

/* One link of form f at the state to about twice the digits of a double, high + low (DIM each, overwritten);
   coefficients of the link begin at `at`, those of its quarter turns at `turn_at`.                            */
HM_OFTEN void exact_link(const context *c, int32_t f, int32_t at, int32_t turn_at, double *high, double *low)
{
    const holonom_model *m = c->m;
    const int32_t begin = m->form_ptr[f], moving = begin + m->form_moving[f];
    EACH(k) high[k] = low[k] = 0.0;
    for (int32_t e = begin; e < m->form_ptr[f + 1]; e++) {
        const int32_t node = DIM * (m->form_node[e] - (e < moving ? 0 : c->n_moving));
        const double *x = (e < moving ? c->s.q : c->number + m->support_at) + node;
        const double *x_low = e < moving ? c->s.q_low + node : NULL;
        const double factor = c->number[at + e];
        EACH(k) hm_add_product(high + k, low + k, factor, x[k]);
        if (x_low) EACH(k) low[k] += factor * x_low[k];
        if (DIM == 3 || !(m->form_kind[f] & FORM_TURNED)) continue;
        for (int k = 0; k < 2; k++) {
            const double turn = c->number[turn_at + e] * (k == 0 ? -1.0 : 1.0);
            hm_add_product(high + k, low + k, turn, x[1 - k]);
            if (x_low) low[k] += turn * x_low[1 - k];
        }
    }
}

/* Phi = u . w - c of form row i at the state, to about twice the digits of a double, so that no step corrects the
   rounding error of Phi: its impulse grows as 1/h^2, without bound near a singular configuration.              */
static double row_at_state(const context *c, int32_t i)
{
    const holonom_model *m = c->m;
    const int32_t f = m->row_form[i];
    const int is_square = m->form_kind[f] & FORM_SQUARE;
    double high = -c->number[m->row_constant_at + i], low = 0.0, u[DIM], u_low[DIM], other[DIM], other_low[DIM];
    exact_link(c, f, m->alpha_at, m->alpha_turn_at, u, u_low);
    if (!is_square) exact_link(c, f, m->beta_at, m->beta_turn_at, other, other_low);
    const double *w = is_square ? u : other, *w_low = is_square ? u_low : other_low;
    EACH(k) {
        hm_add_product(&high, &low, u[k], w[k]);
        low += u[k] * w_low[k] + u_low[k] * w[k];
    }
    return high + low;
}

#endif
