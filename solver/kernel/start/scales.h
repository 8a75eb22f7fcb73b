/* Size of a mechanism, and scales of its rows at the state. */
#ifndef HOLONOM_SCALES_H
#define HOLONOM_SCALES_H

#include "inputs_signals.h"

/* A point: place of node a [m]; NULL of a direction. */
static const double *place_of_point(const context *c, int32_t a)
{
    if (c->m->node_kind[a]) return NULL;
    return a < c->n_moving ? c->s.q + DIM * a
                           : c->number + c->m->support_at + DIM * (a - c->n_moving);
}

/* Distance of points that round-off of their coordinates, or of the numbers that these are drawn
   from, explains [m]. */
static double round_off_of_drawing(const context *c)
{
    double farthest = 0.0;
    for (int32_t a = 0; a < c->n_moving + c->m->n_support; a++) {
        const double *x = place_of_point(c, a);
        if (x) EACH(k) farthest = fmax(farthest, fabs(x[k]));
    }
    return HOLONOM_ONE_PLACE * (1.0 + farthest);
}

/* Size of the mechanism, from its points and the radii of gyration of its bodies. */
static void derive_extent(context *c)
{
    const holonom_model *m = c->m;
    double low[DIM], high[DIM], mass = 0.0, gyration = 0.0, extent2 = 0.0;
    EACH(k) low[k] = INFINITY;
    EACH(k) high[k] = -INFINITY;
    for (int32_t a = 0; a < c->n_moving + m->n_support; a++) {
        const double *x = place_of_point(c, a);
        if (a < c->n_moving) *(x ? &mass : &gyration) += c->number[m->node_mass_at + a];
        if (!x) continue;
        EACH(k) low[k] = fmin(low[k], x[k]);
        EACH(k) high[k] = fmax(high[k], x[k]);
    }
    EACH(k) extent2 += high[k] > low[k] ? hm_square(high[k] - low[k]) : 0.0;
    if (!(extent2 > hm_square(round_off_of_drawing(c)))) extent2 = 0.0;
    if (mass > 0.0) extent2 += gyration / mass;
    else if (gyration > 0.0)
        mass = gyration;                 /* pivoted bodies alone: their inertia, with unit arms */
    if (!(extent2 > 0.0)) extent2 = 1.0; /* all in one place: nothing tells a size */
    c->number[m->extent_at] = sqrt(extent2);
    c->number[m->extent_at + 1] = sqrt(mass * extent2);
}

/* The part of derive_scales for rows that are functions. */
static int32_t add_function_sigmas(const context *c, double *sigma)
{
    const holonom_model *m = c->m;
    context step = *c;
    step.h = 1.0; /* [s]: over which a velocity row is one of displacements */
    const double *node_mass = c->number + m->node_mass_at;
    for (int32_t j = first_function(c); j < first_potential(c); j++) {
        const int32_t size = m->composite_node_ptr[j + 1] - m->composite_node_ptr[j];
        const int32_t forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
        composite_result result = {0.0, 0.0, 0.0};
        const int32_t status = composite_slopes(&step, j, WITH_ENDS, &result);
        if (status) return status;
        local_gradients(&step, j, 1);
        for (int32_t k = 0; k < DIM * size; k++) {
            double g = 0.0;
            for (int32_t f = 0; f < forms; f++)
                g += c->k.end[f] * c->k.gradient_end[DIM * size * f + k];
            sigma[row_of(c, j)] +=
                g * g / node_mass[m->composite_node[m->composite_node_ptr[j] + k / DIM]];
        }
    }
    return HOLONOM_OK;
}

#define VANISHING 1e-8 /* gradient over that of a row of this scale which counts as none */

/* sigma_i = (G M^-1 G')_ii with the nodes' shares of the mass, for the scaling of the penalties;
   scales. */
static int32_t derive_scales(context *c)
{
    const holonom_model *m = c->m;
    double *sigma = c->number + m->row_sigma_at, *scale = c->number + m->row_scale_at;
    const double *node_mass = c->number + m->node_mass_at, extent = c->number[m->extent_at];
    for (int32_t i = 0; i < m->n_rows; i++) {
        sigma[i] = 0.0;
        scale[i] = c->number[m->row_base_at + i];
        for (int32_t k = 0; k < m->row_power[i]; k++) scale[i] *= extent;
    }
    const int32_t with_force = first_rigidity_row(m);
    for (int32_t row = 0; row < with_force + m->n_coincidences; row++) {
        const int32_t j = row - with_force, i = j < 0 ? row : m->n_form_rows + j;
        const int32_t f = j < 0 ? m->row_form[i] : m->coincidence_form[j];
        for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++) {
            const double inverse = 1.0 / node_mass[m->form_node[e]];
            double g[DIM], square = hm_square(c->number[m->alpha_at + e]);
            if (m->form_kind[f] & FORM_TURNED) square += hm_square(c->number[m->alpha_turn_at + e]);
            entry_gradient(c, f, e, c->k.u0 + DIM * f, c->k.w0 + DIM * f, g);
            if (j < 0) sigma[i] += dot(g, g) * inverse;
            else EACH(k) sigma[row_of_coincidence(m, j) + k] += square * inverse;
        }
    }
    const int32_t status = add_function_sigmas(c, sigma);
    if (status) return status;
    for (int32_t i = 0; i < m->n_rows; i++) {
        const double size2 = hm_square(c->number[m->extent_at + 1]),
                     usual = scale[i] * scale[i] / (size2 > 0.0 ? size2 : 1.0);
        /* A gradient that vanishes here, but for rounding errors, need not do so later. */
        if (!(sigma[i] > hm_square(VANISHING) * usual)) sigma[i] = usual;
    }
    return HOLONOM_OK;
}

#endif
