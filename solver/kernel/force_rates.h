/* How fast springs and dampers alone move a mechanism: what an explicit step can resolve (theory 8.8). */
#ifndef HOLONOM_FORCE_RATES_H
#define HOLONOM_FORCE_RATES_H

#include "context.h"
#include "composite.h"
#include "forms.h"
#include "start.h"

/* Products of inertia, squared over both moments, up to which the diagonal of M tells M^-1: bars have 1/4. */
#define DIAGONAL_ENOUGH 0.3

/* Turn of a spring's motion, and way of a damper's, over its time constant, in an explicit step. The method is stable to 5.8 and 6.4
   (Hairer, Norsett and Wanner 1993, II.10); springs that move so far err more than a step may, and shorten it. */
#define MOST_TURNED 5.5
#define MOST_SETTLED 4.0

enum { MOST_POWERS = 10 };
#define CLOSE 0.02 /* change of a rate by a power, of it, after which no more are taken */

/* Diagonal of M over free nodes (overwritten); 0 where it does not tell M^-1. */
static int mass_diagonal(const context *c, double *diagonal)
{
    const holonom_model *m = c->m;
    memset(diagonal, 0, sizeof(double) * (size_t)m->n_free);
    for (int32_t e = 0; e < m->n_mass_free; e++)
        if (m->mass_node[2 * e] == m->mass_node[2 * e + 1]) diagonal[m->mass_node[2 * e]] += c->number[m->mass_at + e];
    for (int32_t e = 0; e < m->n_mass_free; e++) {
        const int32_t a = m->mass_node[2 * e], b = m->mass_node[2 * e + 1];
        if (a != b && hm_square(c->number[m->mass_at + e]) > DIAGONAL_ENOUGH * diagonal[a] * diagonal[b]) return 0;
    }
    return 1;
}

/* y (n, overwritten) = K x of elements with these coefficients, along the gradients of what they measure. */
static int32_t along_elements(const context *at, int64_t coefficient_at, const double *x, double *y)
{
    const holonom_model *m = at->m;
    memset(y, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
    for (int32_t j = 0; j < m->n_elements; j++) {
        const double coefficient = at->number[coefficient_at + j];
        const int32_t *entry = m->leaf + 4 * m->leaf_ptr[j];
        leaf_state leaf;
        double rate;
        if (coefficient == 0.0) continue;
        set_local_forms(at, j, 0.5);
        const int32_t status = set_leaf(at, entry, 0, &leaf);
        if (status) return status;
        quantity_at(at, entry[1], at->s.q, at->s.q_low, x, &rate);
        for (int i = 0; i < 2 && entry[2 + i] >= 0; i++) {
            const local_form *local = (const local_form *)at->k.local + entry[2 + i];
            add_gradient(at, m->composite_form[m->composite_form_ptr[j] + entry[2 + i]], coefficient * rate * leaf.p[i], local->um,
                         local->wm, y);
        }
    }
    return HOLONOM_OK;
}

/* Largest eigenvalue of M^-1 K of these coefficients, by powers of it; constraints only lower it. */
static double largest_rate(const context *c, int64_t coefficient_at, const double *diagonal)
{
    const int32_t n = DIM * c->m->n_free;
    double *x = c->k.w, *y = c->k.momentum, rate = 0.0, last, square = 0.0;
    uint32_t random = 1;
    memset(x, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t k = 0; k < n; k++) {
        random = 1664525u * random + 1013904223u;
        if (diagonal[k / DIM] > 0.0) x[k] = ((double)random / 2147483648.0 - 1.0) / sqrt(diagonal[k / DIM]);
        square += diagonal[k / DIM] * x[k] * x[k];
    }
    for (int i = 0; i < MOST_POWERS; i++) {
        const double size = square;
        last = rate;
        square = 0.0;
        if (along_elements(c, coefficient_at, x, y)) return INFINITY;
        for (int32_t k = 0; k < n; k++) {
            x[k] = diagonal[k / DIM] > 0.0 ? y[k] / diagonal[k / DIM] : 0.0;
            square += x[k] * y[k];
        }
        rate = square > 0.0 ? sqrt(square / size) : 0.0;
        if (fabs(rate - last) <= CLOSE * rate) break;
    }
    return rate;
}

/* Whether all that springs and dampers pull at has mass: else they do not tell how fast they are. */
static int has_rates(const context *c, const double *diagonal)
{
    const holonom_model *m = c->m;
    for (int32_t j = 0; j < m->n_elements; j++) {
        const int32_t q = m->leaf[4 * m->leaf_ptr[j] + 1], f = m->quantity_form[2 * q];
        if (c->number[m->stiffness_at + j] == 0.0 && c->number[m->damping_at + j] == 0.0) continue;
        for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++)
            if (c->number[m->alpha_at + e] != 0.0 && !(diagonal[m->form_node[e]] > 0.0)) return 0;
    }
    return 1;
}

/* Longest explicit step [s], by the fastest of springs and of dampers with the diagonal of M; 0 where these do not tell: with large
   products of inertia, and with potentials. */
HM_SELDOM static double longest_explicit(context *c)
{
    const holonom_model *m = c->m;
    double *diagonal = c->k.ahead;
    if (m->n_potentials) return 0.0;
    if (!m->n_elements) return INFINITY;
    stand_still(c);
    if (!mass_diagonal(c, diagonal) || !has_rates(c, diagonal)) return 0.0;
    const double springs = largest_rate(c, m->stiffness_at, diagonal), dampers = largest_rate(c, m->damping_at, diagonal);
    return 1.0 / hm_hypot(sqrt(springs) / MOST_TURNED, dampers / MOST_SETTLED);
}

#endif
