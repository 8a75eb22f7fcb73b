/* Rows |u|^2 - c = 0 - distances, lengths of directions: most rows there are - in fewer operations
   than forms u . w take. */
#ifndef HOLONOM_SQUARE_ROWS_H
#define HOLONOM_SQUARE_ROWS_H

#include "context.h"

/* A square form within a step, s = |u|^2: the link where gradients are taken, the increment;
   returns the change of s. */
static inline double square_motion(const context *c, int32_t f, double *du, double *um)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at, *u0 = c->k.u0 + DIM * f, *d = c->k.d;
    const int32_t begin = m->form_ptr[f], end = begin + m->form_moving[f];
    EACH(k) du[k] = 0.0;
    for (int32_t e = begin; e < end; e++) EACH(k) du[k] += alpha[e] * d[DIM * m->form_node[e] + k];
    EACH(k) um[k] = u0[k] + 0.5 * du[k];
    return 2.0 * dot(um, du);
}

/* Whether row i is |u|^2 - c = 0 in a step: a distance or the length of a direction, as most rows
   are. */
static inline int is_square_row(const context *c, int32_t i)
{
    return !is_seeking(c) && hm_skips(SKIP_SECOND_LINK)
           && c->m->form_kind[c->m->row_form[i]] == FORM_SQUARE;
}

/* Form row i of the kind of is_square_row: the same numbers in one pass. */
static void square_row_tangent(const context *c, int32_t i, const int32_t *slot, double *value)
{
    const holonom_model *m = c->m;
    const int32_t f = m->row_form[i], begin = m->form_ptr[f], free = m->form_free[f];
    const double *alpha = c->number + m->alpha_at + begin, h = c->h, stiffness = h * c->k.mu[i];
    double du[DIM], um[DIM];
    square_motion(c, f, du, um);
    for (int32_t p = 0; p < free && !is_lean(c); p++)
        for (int32_t q = 0; q < free; q++) {
            const double same = stiffness * (alpha[p] * alpha[q]);
            EACH(k) value[*slot++] += same;
        }
    const double *u0 = c->k.u0 + DIM * f;
    const int32_t *lower = slot + DIM * free;
    for (int32_t e = 0; e < free; e++) EACH(k) {
            const double twice = 2.0 * alpha[e];
            value[*slot++] += h * (twice * um[k]);
            value[*lower++] += twice * (u0[k] + du[k]);
        }
}

/* Form row i of the kind of is_square_row: its function, and its force in the momentum balance. */
static inline void square_row_residual(const context *c, int32_t i)
{
    const holonom_model *m = c->m;
    const int32_t f = m->row_form[i], begin = m->form_ptr[f], end = begin + m->form_moving[f];
    const double *alpha = c->number + m->alpha_at;
    const double factor = c->h * c->k.mu[i];
    double du[DIM], um[DIM];
    c->k.phi[i] = c->k.phi0[i] + square_motion(c, f, du, um);
    for (int32_t e = begin; e < end; e++) {
        double *node = c->k.momentum + DIM * m->form_node[e];
        const double twice = 2.0 * (factor * alpha[e]);
        EACH(k) node[k] += twice * um[k];
    }
}

#endif
