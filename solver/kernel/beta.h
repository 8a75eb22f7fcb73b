/* The intermediate configuration of eq 8 (theory 2.3), for `conserving-al-beta`. */
#ifndef HOLONOM_BETA_H
#define HOLONOM_BETA_H

#include "composite.h"
#include "context.h"
#include "forms.h"
#include "registers.h"

/* Leaf l of function j at q_n + beta d, from its forms there: value in x1, slopes p. */
static int32_t set_leaf_at(const context *c, const int32_t *entry, double beta, leaf_state *leaf, double *value)
{
    const holonom_model *m = c->m;
    const local_form *local = (const local_form *)c->k.local;
    if (entry[0] == LEAF_SIGNAL) {
        const double b0 = c->s.signal[entry[1]], b1 = c->k.signal1[entry[1]];
        *value = b0 + beta * (b1 - b0);
        return HOLONOM_OK;
    }
    const int32_t status = set_leaf(c, entry, 0, leaf);
    if (!status && m->quantity_kind[entry[1]] == QUANTITY_ANGLE) { /* on the turn of the angle at q_n */
        const int32_t *forms = m->quantity_form + 2 * entry[1];
        const double c0 = dot(c->k.u0 + DIM * forms[0], c->k.w0 + DIM * forms[0]);
        const double s0 = dot(c->k.u0 + DIM * forms[1], c->k.w0 + DIM * forms[1]);
        const double cb = local[entry[2]].s1, sb = local[entry[3]].s1;
        leaf->x1 = c->k.sigma0[entry[1]] + hm_atan2(c0 * sb - s0 * cb, c0 * cb + s0 * sb);
    }
    *value = leaf->x1;
    return status;
}

/* Part of a function's change by its signals, with the slopes in the registers. */
static double signal_part(const context *c, int32_t j)
{
    double sum = 0.0;
    for (int32_t at = c->m->leaf_ptr[j], l = 0; at < c->m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = c->m->leaf + 4 * at;
        if (entry[0] == LEAF_SIGNAL)
            sum += c->k.r.adjoint[l] * (c->k.signal1[entry[1]] - c->s.signal[entry[1]]);
    }
    return sum;
}

/* excess = grad phi(q_beta) d + (signals) - change, with forms, leaves and registers left as they are at q_beta. */
HM_SELDOM static int32_t slope_at(const context *c, int32_t j, double beta, double change, double *excess)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    leaf_state *leaf = (leaf_state *)c->k.leaves;
    local_form *local = (local_form *)c->k.local;
    const int32_t *forms = m->composite_form + m->composite_form_ptr[j];
    set_local_forms(c, j, beta);
    for (int32_t f = 0; f < m->composite_form_ptr[j + 1] - m->composite_form_ptr[j]; f++) {
        local[f].s0 = local[f].s1 = dot(local[f].um, local[f].wm);
        local[f].ds = 0.0;
    }
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t status = set_leaf_at(c, m->leaf + 4 * at, beta, leaf + l, r->r0 + l);
        if (status) return status;
        r->r1[l] = r->r0[l];
        r->dr[l] = 0.0;
    }
    run_function(c, j);
    *excess = signal_part(c, j) - change;
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        for (int f = 0; f < 2 && entry[0] != LEAF_SIGNAL && entry[2 + f] >= 0; f++) {
            const local_form *at_beta = local + entry[2 + f];
            motion g;
            form_motion(c, forms[entry[2 + f]], &g);
            *excess += r->adjoint[l] * leaf[l].p[f] * (dot(at_beta->um, g.dw) + dot(at_beta->wm, g.du));
        }
    }
    return HOLONOM_OK;
}

/* Finds beta in (0, 1), nearest to 1/2, where the excess vanishes, and leaves everything as it is there. Where the
   function is quadratic every beta will do, and 1/2 is taken: outwards from it the first change of sign is
   bisected; if there is none, the excess is round-off.                                                        */
static int32_t find_beta(const context *c, int32_t j, double change)
{
    const double scale = c->number[c->m->row_scale_at + row_of(c, j)];
    double middle, low = 0.5, high = 0.5, at_low, at_high;
    int32_t status = slope_at(c, j, 0.5, change, &middle);
    if (status || !(fabs(middle) > 1e-14 * scale)) return status;
    at_low = at_high = middle;
    for (int i = 1; i <= 16 && at_low * middle > 0.0 && at_high * middle > 0.0; i++) {
        low = 0.5 - 0.03125 * i;
        high = 0.5 + 0.03125 * i;
        if ((status = slope_at(c, j, low, change, &at_low))) return status;
        if ((status = slope_at(c, j, high, change, &at_high))) return status;
    }
    if (at_low * middle > 0.0 && at_high * middle > 0.0) return slope_at(c, j, 0.5, change, &middle);
    double inner = 0.5, outer = at_low * middle <= 0.0 ? low : high;
    for (int i = 0; i < 60; i++) {
        double value;
        const double beta = 0.5 * (inner + outer);
        if ((status = slope_at(c, j, beta, change, &value))) return status;
        if (value * middle > 0.0) inner = beta;
        else outer = beta;
    }
    return HOLONOM_OK;
}

#endif
