/* Function rows, velocity rows, potentials and forces: functions of quantities, rates and signals
   on the tape of operations. */
#ifndef HOLONOM_FUNCTION_H
#define HOLONOM_FUNCTION_H

#include "composite.h"

enum register_mode { OVER_STEP, AT_END };

/* Fills the registers of the leaves: values at both ends. A velocity row is a point function of
   mean quantities and mean rates. A signal is known at both ends. */
HM_OFTEN void load_registers(const context *c, int32_t j, int mode)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const int is_velocity = is_velocity_row(c, j);
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        if (entry[0] == LEAF_SIGNAL) {
            r->r0[l] =
                is_seeking(c) || mode == AT_END ? c->k.signal1[entry[1]] : c->s.signal[entry[1]];
            r->r1[l] = c->k.signal1[entry[1]];
            r->dr[l] = r->r1[l] - r->r0[l];
        } else if (entry[0] == LEAF_RATE) {
            r->r0[l] = r->r1[l] = leaf[l].dx / c->h;
            r->dr[l] = 0.0;
        } else if (is_velocity) {
            r->r0[l] = r->r1[l] = leaf[l].x0 + 0.5 * leaf[l].dx;
            r->dr[l] = 0.0;
        } else {
            r->r0[l] = mode == AT_END ? leaf[l].x1 : leaf[l].x0;
            r->r1[l] = leaf[l].x1;
            r->dr[l] = mode == AT_END ? 0.0 : leaf[l].dx;
        }
    }
}

/* Likewise of a velocity row that follows no signal: what its leaves are on the mean. */
HM_OFTEN void load_means(const context *c, int32_t j)
{
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const int32_t *entry = c->m->leaf + 4 * c->m->leaf_ptr[j],
                  *end = c->m->leaf + 4 * c->m->leaf_ptr[j + 1];
    for (double *x = c->k.r.r0; entry < end; entry += 4, leaf++)
        *x++ = entry[0] == LEAF_RATE ? leaf->dx / c->h : leaf->x0 + 0.5 * leaf->dx;
}

/* Runs function j; returns the register of its value. */
static int32_t run_function(const context *c, int32_t j)
{
    const holonom_model *m = c->m;
    const int32_t f = j - first_function(c), begin = m->function_ptr[f];
    return hm_discrete_gradient(m->operation + 4 * begin, m->leaf_ptr[j + 1] - m->leaf_ptr[j],
                                m->function_ptr[f + 1] - begin, c->number, &c->k.r);
}

/* Likewise of a velocity row, which is a function of one point, with its slopes with respect to
   rates alone or, for a tangent, to all; `is_next`: the registers are those of the row before,
   which has the same leaves. */
static int32_t run_velocity_row(const context *c, int32_t j, int asked, int is_next)
{
    const holonom_model *m = c->m;
    const int32_t f = j - first_function(c), begin = m->function_ptr[f],
                  count = m->function_ptr[f + 1] - begin;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j], *op = m->operation + 4 * begin;
    hm_value(op, n, count, is_next ? m->function_known[f] : 0, c->number, c->k.r.r0);
    hm_gradient(op, n, count, asked ? 0 : m->function_still[f], c->number, &c->k.r);
    return n + count - 1;
}

/* A damped potential U = K delta^(n+1)/(n+1) acts with 1 + x times its slopes, x = max(-1, a
   ddelta/h) (Hunt and Crossley 1975): it never pulls, and takes x dU >= 0 out exactly. At the
   equilibrium it is not damped. This is x. */
static double damping_share(const context *c, int32_t j, double rate_of_depth)
{
    return fmax(-1.0, c->number[c->m->depth_damping_at + (j - first_potential(c))] * rate_of_depth);
}

static inline int is_damped(const context *c, int32_t j)
{
    return j >= first_potential(c) && c->m->depth_register[j - first_potential(c)] >= 0;
}

/* Over the step, where the potential has been run. */
static double damping_share_of_step(const context *c, int32_t j)
{
    return damping_share(c, j, c->k.r.dr[c->m->depth_register[j - first_potential(c)]] / c->h);
}

/* Slopes of the function that has been run, with its damping. */
static inline void damp_slopes(const context *c, int32_t j)
{
    if (!is_damped(c, j) || is_seeking(c)) return;
    const double factor = 1.0 + damping_share_of_step(c, j);
    for (int32_t l = 0; l < c->m->leaf_ptr[j + 1] - c->m->leaf_ptr[j]; l++)
        c->k.r.adjoint[l] *= factor;
}

/* Jet of function j, whose leaves begin its registers x and whose first `known` operations have
   their results there; numbers stand still, or move as `jet` says. */
HM_SELDOM static hm_jet function_jet(const context *c, int32_t j, int32_t known, hm_jet *x,
                                     const double *jet)
{
    const holonom_model *m = c->m;
    const int32_t f = j - first_function(c);
    int32_t l = m->leaf_ptr[j + 1] - m->leaf_ptr[j] + known;
    for (int32_t at = m->function_ptr[f] + known; at < m->function_ptr[f + 1]; at++, l++) {
        const int32_t *op = m->operation + 4 * at;
        hm_jet argument[3];
        for (int i = 0; i < 3; i++) {
            const int32_t number = -1 - op[1 + i];
            argument[i] = number < 0 ? x[op[1 + i]] : (hm_jet){c->number[number], 0.0, 0.0};
            if (number >= 0 && jet)
                argument[i].rate = jet[2 * number], argument[i].bend = jet[2 * number + 1];
        }
        x[l] = op[0] < T_SPLINE ? hm_operate_jet(op[0], argument[0], argument[1], argument[2])
                                : hm_look_up_jet(op[0], op[1] < 0 ? argument : x + op[1],
                                                 c->number - 1 - op[2], c->number - 1 - op[3]);
    }
    return x[l - 1];
}

/* Share of a damped potential at the state, and the rate of its energy without damping. */
HM_SELDOM static double damping_at_state(const context *c, int32_t j, double *power)
{
    const int32_t *entry = c->m->leaf + 4 * c->m->leaf_ptr[j];
    hm_jet *x = (hm_jet *)c->k.leaves;
    for (int32_t l = 0; l < c->m->leaf_ptr[j + 1] - c->m->leaf_ptr[j]; l++, entry += 4)
        x[l].bend = 0.0,
        x[l].value = quantity_at(c, entry[1], c->s.q, c->s.q_low, c->s.v, &x[l].rate);
    *power = function_jet(c, j, 0, x, NULL).rate;
    return damping_share(c, j, x[c->m->depth_register[j - first_potential(c)]].rate);
}

/* --------------------------------------------------------------------------------------- forces */

/* Whether function j is no energy, but a force N along its first quantity, of means and mean rates.
   It takes N dsigma out in a step, whatever its law. */
static inline int is_force(const context *c, int32_t j)
{
    return j >= first_potential(c) && c->m->force_role[j - first_potential(c)] != STORES;
}

/* Runs force j, whose leaves are in r0; slopes with respect to them, if asked for. */
static double run_force(const context *c, int32_t j, int asked)
{
    const holonom_model *m = c->m;
    const int32_t f = j - first_function(c), begin = m->function_ptr[f],
                  count = m->function_ptr[f + 1] - begin,
                  n = m->leaf_ptr[j + 1] - m->leaf_ptr[j], *op = m->operation + 4 * begin;
    const double force = hm_value(op, n, count, 0, c->number, c->k.r.r0);
    if (asked) hm_gradient(op, n, count, 0, c->number, &c->k.r);
    return force;
}

/* Likewise at the state; the rate of what it acts along. */
HM_SELDOM static double force_at_state(const context *c, int32_t j, int asked, double *along)
{
    const int32_t *entry = c->m->leaf + 4 * c->m->leaf_ptr[j];
    for (int32_t l = 0; l < c->m->leaf_ptr[j + 1] - c->m->leaf_ptr[j]; l++, entry += 4) {
        double rate;
        const double value = quantity_at(c, entry[1], c->s.q, c->s.q_low, c->s.v, &rate);
        c->k.r.r0[l] = entry[0] == LEAF_RATE ? rate : value;
        if (l == 0) *along = rate;
    }
    return run_force(c, j, asked);
}

/* Derivatives of the slopes of force N, whose own derivatives are in the registers, with respect to
   the forms at the end. */
static void force_tangent(const context *c, int32_t j, double force)
{
    const holonom_model *m = c->m;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const int32_t forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j],
                  *entry = m->leaf + 4 * m->leaf_ptr[j];
    memset(c->k.curve, 0, sizeof(double) * (size_t)(forms * forms));
    for (int f = 0; f < 2 && entry[2 + f] >= 0; f++)
        for (int g = 0; g < 2 && entry[2 + g] >= 0; g++)
            c->k.curve[forms * entry[2 + f] + entry[2 + g]] = force * leaf->curve[2 * f + g];
    for (int32_t l = 0; l < m->leaf_ptr[j + 1] - m->leaf_ptr[j]; l++) {
        const int32_t *read = entry + 4 * l;
        const double slope =
            c->k.r.adjoint[l] * (read[0] == LEAF_RATE ? 1.0 / c->h : c->step.theta);
        for (int f = 0; f < 2 && entry[2 + f] >= 0; f++)
            for (int g = 0; g < 2 && read[2 + g] >= 0; g++)
                c->k.curve[forms * entry[2 + f] + read[2 + g]] +=
                    leaf->p[f] * slope * leaf[l].e[g];
    }
}

/* Slopes of the forms by force j in the step, or at the state. At an equilibrium nothing takes
   energy out. */
static int32_t force_slopes(const context *c, int32_t j, int asked, composite_result *result)
{
    const holonom_model *m = c->m;
    leaf_state *leaf = (leaf_state *)c->k.leaves;
    const int32_t *entry = m->leaf + 4 * m->leaf_ptr[j];
    const int rests = is_seeking(c) && m->force_role[j - first_potential(c)] == TAKES;
    double force = 0.0, unused;
    for (int32_t l = 0; l < m->leaf_ptr[j + 1] - m->leaf_ptr[j]; l++) {
        const int32_t status = set_leaf(c, entry + 4 * l, is_seeking(c), leaf + l);
        if (status) return status;
    }
    if (!c->step.at_state) load_means(c, j);
    if (rests) memset(c->k.r.adjoint, 0, sizeof(double) * (size_t)c->m->n_registers);
    else force = c->step.at_state ? force_at_state(c, j, asked, &unused) : run_force(c, j, asked);
    if (!(fabs(force) < INFINITY)) return HOLONOM_BAD_LAW;
    memset(c->k.slope, 0,
           sizeof(double) * (size_t)(m->composite_form_ptr[j + 1] - m->composite_form_ptr[j]));
    for (int f = 0; f < 2 && entry[2 + f] >= 0; f++) c->k.slope[entry[2 + f]] = force * leaf->p[f];
    result->row = 0.0;
    result->change = result->mechanical = force * leaf->dx;
    if (asked) force_tangent(c, j, force);
    return HOLONOM_OK;
}

/* --------------------------------------------------------------------------------------- slopes */

/* Whether function j is linear in its leaves, as most drivers and gears are: its slopes are the
   same everywhere. */
static int is_linear(const context *c, int32_t j)
{
    const int32_t f = j - first_function(c);
    const int32_t *op = c->m->operation + 4 * c->m->function_ptr[f],
                  *end = c->m->operation + 4 * c->m->function_ptr[f + 1];
    for (; op < end; op += 4) {
        const int is_sum = op[0] == T_ADD || op[0] == T_SUB || op[0] == T_NEG;
        if (!is_sum && !(op[0] == T_MUL && (op[1] < 0 || op[2] < 0))
            && !(op[0] == T_DIV && op[2] < 0))
            return 0;
    }
    return !is_damped(c, j);
}

/* Whether function j takes the same values over the step and at its end: its slopes at the end are
   those over the step. */
static int is_point_function(const context *c, int32_t j)
{ return is_velocity_row(c, j) && !has_signal(c, j); }

/* Derivatives of the leaves' slopes with respect to the leaves at the end, by central differences,
   n x n into `matrix`: only the rate of Newton's iteration depends on them. */
static void differentiate_slopes(const context *c, int32_t j, double *matrix)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j];
    const int is_velocity = is_velocity_row(c, j);
    const int at_mean = is_point_function(c, j);
    for (int32_t k = 0; k < n; k++) {
        const int32_t *entry = m->leaf + 4 * (m->leaf_ptr[j] + k);
        for (int32_t l = 0; l < n; l++) matrix[n * l + k] = 0.0;
        if (entry[0] != LEAF_VALUE) continue;
        for (int side = 0; side < 2; side++) {
            if (at_mean) load_means(c, j);
            else load_registers(c, j, OVER_STEP);
            const double delta = 1e-6
                                 * (fabs(r->r0[k]) + fabs(at_mean ? r->r0[k] : r->r1[k])
                                    + 1e-2 * (1.0 + c->number[m->extent_at]));
            const double shift = side ? -delta : delta;
            if (is_velocity || is_seeking(c)) r->r0[k] += shift;
            if (at_mean)
                run_velocity_row(c, j, 0,
                                 0); /* slopes of leaves that are no rates are not asked for */
            else {
                r->r1[k] += shift;
                if (!is_velocity && !is_seeking(c)) r->dr[k] += shift;
                run_function(c, j);
                damp_slopes(c, j);
            }
            const double weight = (side ? -0.5 : 0.5) / delta * (is_velocity ? c->step.theta : 1.0);
            for (int32_t l = 0; l < n; l++) matrix[n * l + k] += weight * r->adjoint[l];
        }
    }
}

/* curve_fg = d slope_f/d s_g at the end, and end_g = d C/d s_g. Without `matrix` slopes do not
   depend on the leaves. */
static void function_tangent(const context *c, int32_t j, const double *matrix)
{
    const holonom_model *m = c->m;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j],
                  forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
    const int is_velocity = is_velocity_row(c, j);
    memset(c->k.curve, 0, sizeof(double) * (size_t)(forms * forms));
    memset(c->k.end, 0, sizeof(double) * (size_t)forms);
    for (int32_t l = 0; l < n; l++) {
        const int32_t *a = m->leaf + 4 * (m->leaf_ptr[j] + l);
        if (a[0] == LEAF_SIGNAL) continue;
        double weight = leaf[l].n_end;
        if (is_velocity && a[0] == LEAF_VALUE) weight *= c->step.theta * c->h;
        for (int f = 0; f < 2 && a[2 + f] >= 0; f++) c->k.end[a[2 + f]] += weight * leaf[l].e[f];
        if (is_velocity && a[0] == LEAF_VALUE) continue; /* forces act along the rates */
        for (int f = 0; f < 2 && a[2 + f] >= 0; f++)
            for (int g = 0; g < 2 && a[2 + g] >= 0; g++)
                c->k.curve[forms * a[2 + f] + a[2 + g]] +=
                    c->k.r.adjoint[l] * leaf[l].curve[2 * f + g];
        for (int32_t k = 0; k < n && matrix; k++) {
            const int32_t *b = m->leaf + 4 * (m->leaf_ptr[j] + k);
            if (b[0] != LEAF_VALUE || matrix[n * l + k] == 0.0) continue;
            for (int f = 0; f < 2 && a[2 + f] >= 0; f++)
                for (int g = 0; g < 2 && b[2 + g] >= 0; g++)
                    c->k.curve[forms * a[2 + f] + b[2 + g]] +=
                        leaf[l].p[f] * matrix[n * l + k] * leaf[k].e[g];
        }
    }
}

/* What is asked of a composite besides its slopes: derivatives of its value at the end, and of its
   slopes, too. */
enum { SLOPES_ALONE, WITH_ENDS, WITH_STIFFNESS };

/* Leaves of function j, and what of a function that is not linear is asked for; a point function's
   slopes at the end come later. */
static int32_t set_leaves(const context *c, int32_t j, int asked, int is_point, double *matrix)
{
    const holonom_model *m = c->m;
    leaf_state *leaf = (leaf_state *)c->k.leaves;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j];
    const int32_t *entry = m->leaf + 4 * m->leaf_ptr[j];
    const int seeks = is_seeking(c);
    for (int32_t l = 0; l < n; l++, entry += 4) {
        const int32_t status = entry[0] == LEAF_SIGNAL ? 0 : set_leaf(c, entry, seeks, leaf + l);
        if (status) return status;
    }
    if (asked == WITH_STIFFNESS) differentiate_slopes(c, j, matrix);
    if (asked == SLOPES_ALONE || is_point) return HOLONOM_OK;
    load_registers(c, j, AT_END);
    run_function(c, j);
    for (int32_t l = 0; l < n; l++) leaf[l].n_end = c->k.r.adjoint[l];
    return HOLONOM_OK;
}

/* Slopes of the forms, from those of the leaves in the registers; the part of the change by
   quantities. */
static double gather_slopes(const context *c, int32_t j)
{
    const holonom_model *m = c->m;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const double *slope = c->k.r.adjoint;
    double mechanical = 0.0;
    memset(c->k.slope, 0,
           sizeof(double) * (size_t)(m->composite_form_ptr[j + 1] - m->composite_form_ptr[j]));
    const int32_t *entry = m->leaf + 4 * m->leaf_ptr[j], *end = m->leaf + 4 * m->leaf_ptr[j + 1];
    const int32_t left_out =
        is_velocity_row(c, j) ? LEAF_VALUE : LEAF_SIGNAL; /* forces act along the rates */
    for (; entry < end; entry += 4, slope++, leaf++) {
        if (entry[0] == LEAF_SIGNAL || entry[0] == left_out) continue;
        mechanical += *slope * leaf->dx;
        for (int f = 0; f < 2 && entry[2 + f] >= 0; f++)
            c->k.slope[entry[2 + f]] += *slope * leaf->p[f];
    }
    return mechanical;
}

/* Slopes of function j over the step with respect to its forms; if asked for also curve and end.
   `is_next`: it has the leaves of the function before, which has just been run. */
static int32_t function_slopes(const context *c, int32_t j, int asked, int is_next,
                               composite_result *result)
{
    double *matrix = c->k.leaves + 12 * (int64_t)c->m->n_registers;
    const int at_mean = is_point_function(c, j), straight = asked && is_linear(c, j);
    const int32_t n = c->m->leaf_ptr[j + 1] - c->m->leaf_ptr[j];
    const int is_point = asked && !straight && at_mean;
    const int32_t status =
        is_next ? HOLONOM_OK : set_leaves(c, j, straight ? SLOPES_ALONE : asked, is_point, matrix);
    if (status) return status;
    if (!is_next && !at_mean) load_registers(c, j, OVER_STEP);
    if (!is_next && at_mean) load_means(c, j);
    const int32_t last = at_mean ? run_velocity_row(c, j, asked, is_next) : run_function(c, j);
    damp_slopes(c, j);
    leaf_state *leaf = (leaf_state *)c->k.leaves;
    for (int32_t l = 0; l < n && (straight || is_point); l++) leaf[l].n_end = c->k.r.adjoint[l];
    if (asked) function_tangent(c, j, asked == WITH_STIFFNESS && !straight ? matrix : NULL);
    result->change = is_velocity_row(c, j) ? c->h * c->k.r.r0[last] : c->k.r.dr[last];
    result->row = is_seeking(c) && !is_velocity_row(c, j) ? c->k.r.r0[last] : result->change;
    result->mechanical = gather_slopes(c, j);
    return HOLONOM_OK;
}

/* Whether composite j, of which this is asked, may follow composite `before`, whose leaves it
   shares: those have been set at the same place, and nothing since. */
static inline int is_next_slip(const context *c, int32_t before, int32_t j, int asked)
{
    return before >= 0 && before == j - 1 && asked != WITH_STIFFNESS && is_velocity_row(c, j)
           && c->m->function_known[j - first_function(c)] > 0;
}

/* Slopes of composite j; a row's function value is that over phi_0. `is_next`: it follows as a slip
   does, is_next_slip. */
static int32_t next_slopes(const context *c, int is_next, int32_t j, int asked,
                           composite_result *result)
{
    if (!is_next) set_local_forms(c, j, c->step.theta);
    if (j < first_function(c)) return element_law(c, j, asked, result);
    if (is_seeking(c) && is_velocity_row(c, j)) { /* velocities do not bind positions */
        const size_t forms =
            (size_t)(c->m->composite_form_ptr[j + 1] - c->m->composite_form_ptr[j]);
        memset(result, 0, sizeof(*result));
        memset(c->k.slope, 0, sizeof(double) * forms);
        memset(c->k.end, 0, sizeof(double) * forms);
        memset(c->k.curve, 0, sizeof(double) * forms * forms);
        return HOLONOM_OK;
    }
    return is_force(c, j) ? force_slopes(c, j, asked, result)
                          : function_slopes(c, j, asked, is_next, result);
}

static int32_t composite_slopes(const context *c, int32_t j, int asked, composite_result *result)
{
    return next_slopes(c, 0, j, asked, result);
}

/* Value of function j, without slopes, of the leaves in r0, where that many of its operations have
   their results. */
static double value_of_leaves(const context *c, int32_t j, int32_t known)
{
    const holonom_model *m = c->m;
    const int32_t f = j - first_function(c), begin = m->function_ptr[f];
    return hm_value(m->operation + 4 * begin, m->leaf_ptr[j + 1] - m->leaf_ptr[j],
                    m->function_ptr[f + 1] - begin, known, c->number, c->k.r.r0);
}

/* Value of function j, without slopes, of quantities at the beginning of the step or, where they
   are not known, at the state. */
static double value_of_function(const context *c, int32_t j, int are_known)
{
    const holonom_model *m = c->m;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j], *entry = m->leaf + 4 * m->leaf_ptr[j];
    double *x = c->k.r.r0;
    for (int32_t l = 0; l < n; l++, entry += 4)
        x[l] = entry[0] == LEAF_SIGNAL ? c->s.signal[entry[1]]
               : are_known             ? c->k.sigma0[entry[1]]
                                       : quantity_at(c, entry[1], c->s.q, c->s.q_low, NULL, NULL);
    return value_of_leaves(c, j, 0);
}

static double function_value(const context *c, int32_t j) { return value_of_function(c, j, 1); }

/* sigma0 becomes the quantities at the state, of the islands at hand. */
static void quantities_at_state(const context *c)
{
    for
        IN_ISLAND(c, j, ISLAND_ACTIVE)
        c->k.sigma0[j] = quantity_at(c, j, c->s.q, c->s.q_low, NULL, NULL);
    EACH_NEAR(c, NEAR_ACTIVE, j, c->view.begin[ISLAND_TOUCHING_ACTIVE],
              c->view.end[ISLAND_TOUCHING_ACTIVE])
        c->k.sigma0[j] = quantity_at(c, j, c->s.q, c->s.q_low, NULL, NULL);
}

#endif
