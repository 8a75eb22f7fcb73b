/* Function rows, velocity rows and potentials: functions of quantities, rates and signals on the tape of
   operations. */
#ifndef HOLONOM_FUNCTION_H
#define HOLONOM_FUNCTION_H

#include "beta.h"
#include "composite.h"
#include "context.h"
#include "registers.h"

/* Derivatives of the leaves' slopes with respect to the leaves at the end, by central differences, n x n into
   `matrix`: only the rate of Newton's iteration depends on them.                                              */
static void differentiate_slopes(const context *c, int32_t j, double *matrix)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j];
    const int is_velocity = is_velocity_row(c, j);
    for (int32_t k = 0; k < n; k++) {
        const int32_t *entry = m->leaf + 4 * (m->leaf_ptr[j] + k);
        for (int32_t l = 0; l < n; l++) matrix[n * l + k] = 0.0;
        if (entry[0] != LEAF_VALUE) continue;
        for (int side = 0; side < 2; side++) {
            load_registers(c, j, OVER_STEP);
            const double delta = 1e-6 * (fabs(r->r0[k]) + fabs(r->r1[k]) + 1e-2 * (1.0 + c->number[m->extent_at]));
            const double shift = side ? -delta : delta;
            r->r1[k] += shift;
            if (is_velocity || is_seeking(c)) r->r0[k] += shift;
            else r->dr[k] += shift;
            run_function(c, j);
            const double weight = (side ? -0.5 : 0.5) / delta * (is_velocity ? c->theta : 1.0);
            for (int32_t l = 0; l < n; l++) matrix[n * l + k] += weight * r->adjoint[l];
        }
    }
}

/* curve_fg = d slope_f/d s_g at the end, and end_g = d C/d s_g. */
static void function_tangent(const context *c, int32_t j, const double *matrix)
{
    const holonom_model *m = c->m;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j], forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
    const int is_velocity = is_velocity_row(c, j);
    memset(c->k.curve, 0, sizeof(double) * (size_t)(forms * forms));
    memset(c->k.end, 0, sizeof(double) * (size_t)forms);
    for (int32_t l = 0; l < n; l++) {
        const int32_t *a = m->leaf + 4 * (m->leaf_ptr[j] + l);
        if (a[0] == LEAF_SIGNAL) continue;
        double weight = leaf[l].n_end;
        if (is_velocity && a[0] == LEAF_VALUE) weight *= c->theta * c->h;
        for (int f = 0; f < 2 && a[2 + f] >= 0; f++) c->k.end[a[2 + f]] += weight * leaf[l].e[f];
        if (is_velocity && a[0] == LEAF_VALUE) continue; /* forces act along the rates */
        for (int f = 0; f < 2 && a[2 + f] >= 0; f++)
            for (int g = 0; g < 2 && a[2 + g] >= 0; g++)
                c->k.curve[forms * a[2 + f] + a[2 + g]] += c->k.r.adjoint[l] * leaf[l].curve[2 * f + g];
        for (int32_t k = 0; k < n; k++) {
            const int32_t *b = m->leaf + 4 * (m->leaf_ptr[j] + k);
            if (b[0] != LEAF_VALUE || matrix[n * l + k] == 0.0) continue;
            for (int f = 0; f < 2 && a[2 + f] >= 0; f++)
                for (int g = 0; g < 2 && b[2 + g] >= 0; g++)
                    c->k.curve[forms * a[2 + f] + b[2 + g]] += leaf[l].p[f] * matrix[n * l + k] * leaf[k].e[g];
        }
    }
}

/* Leaves of function j, and for the tangent the function's slopes at the end and the derivatives of its slopes. */
static int32_t set_leaves(const context *c, int32_t j, int tangent, double *matrix)
{
    const holonom_model *m = c->m;
    leaf_state *leaf = (leaf_state *)c->k.leaves;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j];
    for (int32_t l = 0; l < n; l++) {
        const int32_t *entry = m->leaf + 4 * (m->leaf_ptr[j] + l);
        const int32_t status = entry[0] == LEAF_SIGNAL ? 0 : set_leaf(c, entry, is_seeking(c), leaf + l);
        if (status) return status;
    }
    if (!tangent) return HOLONOM_OK;
    differentiate_slopes(c, j, matrix);
    load_registers(c, j, AT_END);
    run_function(c, j);
    for (int32_t l = 0; l < n; l++) leaf[l].n_end = c->k.r.adjoint[l];
    return HOLONOM_OK;
}

/* Slopes of the forms, from those of the leaves in the registers; the part of the change by quantities. */
static double gather_slopes(const context *c, int32_t j)
{
    const holonom_model *m = c->m;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const double *slope = c->k.r.adjoint;
    double mechanical = 0.0;
    memset(c->k.slope, 0, sizeof(double) * (size_t)(m->composite_form_ptr[j + 1] - m->composite_form_ptr[j]));
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        if (entry[0] == LEAF_SIGNAL || (is_velocity_row(c, j) && entry[0] == LEAF_VALUE)) continue;
        mechanical += slope[l] * leaf[l].dx;
        for (int f = 0; f < 2 && entry[2 + f] >= 0; f++) c->k.slope[entry[2 + f]] += slope[l] * leaf[l].p[f];
    }
    return mechanical;
}

/* Slopes of function j over the step with respect to its forms; with `tangent` also curve and end. */
static int32_t function_slopes(const context *c, int32_t j, int tangent, composite_result *result)
{
    double *matrix = c->k.leaves + 12 * (int64_t)c->m->n_registers;
    int32_t status = set_leaves(c, j, tangent, matrix);
    if (status) return status;
    load_registers(c, j, OVER_STEP);
    const int32_t last = run_function(c, j);
    if (tangent) function_tangent(c, j, matrix);
    result->change = is_velocity_row(c, j) ? c->h * c->k.r.r0[last] : c->k.r.dr[last];
    result->row = is_seeking(c) && !is_velocity_row(c, j) ? c->k.r.r0[last] : result->change;
    if (c->formulation != HOLONOM_CONSERVING_AL_BETA || j >= first_velocity_row(c) || is_seeking(c)) {
        result->mechanical = gather_slopes(c, j);
        return HOLONOM_OK;
    }
    status = find_beta(c, j, result->change);
    gather_slopes(c, j);
    result->mechanical = result->change - signal_part(c, j);
    return status;
}

/* Slopes of composite j; a row's function value is that over phi_0. */
static int32_t composite_slopes(const context *c, int32_t j, int tangent, composite_result *result)
{
    set_local_forms(c, j, c->theta);
    if (j < first_function(c)) return element_law(c, j, tangent, result);
    if (is_seeking(c) && is_velocity_row(c, j)) { /* velocities do not bind positions */
        const size_t forms = (size_t)(c->m->composite_form_ptr[j + 1] - c->m->composite_form_ptr[j]);
        memset(result, 0, sizeof(*result));
        memset(c->k.slope, 0, sizeof(double) * forms);
        memset(c->k.end, 0, sizeof(double) * forms);
        memset(c->k.curve, 0, sizeof(double) * forms * forms);
        return HOLONOM_OK;
    }
    return function_slopes(c, j, tangent, result);
}

/* Value of function j at the beginning of the step; of a potential, also at the state. */
static double function_value(const context *c, int32_t j)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        r->r0[l] = entry[0] == LEAF_SIGNAL ? c->s.signal[entry[1]] : c->k.sigma0[entry[1]];
        r->r1[l] = r->r0[l];
        r->dr[l] = 0.0;
    }
    return r->r0[run_function(c, j)];
}

/* sigma0 becomes the quantities at the state. */
static void quantities_at_state(const context *c)
{
    for (int32_t j = 0; j < c->m->n_active; j++) c->k.sigma0[j] = quantity_at(c, j, c->s.q, c->s.q_low, NULL, NULL);
}

#endif
