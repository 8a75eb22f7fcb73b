/* Equations at a state: mass matrix and gradients of rows, forces, second derivatives of the rows,
   and their solution for given momenta. */
#ifndef HOLONOM_EQUATIONS_AT_STATE_H
#define HOLONOM_EQUATIONS_AT_STATE_H

#include "inputs_signals.h"

/* Links, quantities, rows and signals of the islands at hand at the state, for a step that has not
   begun: d = w = mu = lambda = 0. */
static void stand_still(context *c)
{
    links_at_start(c);
    memcpy(c->k.signal1, c->s.signal, sizeof(double) * (size_t)c->m->n_signals);
    clear_nodes(c, c->k.hv);
    clear_nodes(c, c->k.w);
    clear_nodes(c, c->k.d);
    EACH_ROW(c, i) c->k.mu[i] = c->k.lambda[i] = 0.0;
    rows_at_start(c, 1);
    stand_still_as_bodies(c);
}

#define AT_STATE_PENALTY 1e8
/* Repeats of a solution with fixed compliances: usual ones, and the most where what rows lack still
   falls by so much in each. It falls slowly where masses are many powers of ten apart; it does not
   where rows contradict each other. */
#define USUAL_REPEATS 40
#define MOST_REPEATS 1000
#define STILL_FALLS 0.997

/* Context of the equations of solve_at_state, with links at the present state: a tangent without a
   step. Multipliers become 0. */
static context equations_at_state(const context *c)
{
    context rows = *c;
    rows.factors.lu = &c->m->full;
    rows.h = 1.0;
    rows.step.constraints_only = rows.step.at_state = 1;
    for (int k = 0; k < NEAR_LISTS; k++) rows.view.near[k] = NULL;
    rows.view.row = c->view.all_row, rows.view.composite = c->view.all_composite;
    rows.view.rows = c->view.all_rows, rows.view.composites = c->view.all_composites;
    memset(c->k.mu, 0, sizeof(double) * (size_t)c->m->n_rows);
    return rows;
}

/* Likewise for new factors: epsilon becomes the compliances of the rows. */
static context rows_at_state(const context *c)
{
    for (int32_t i = 0; i < c->m->n_rows; i++)
        c->k.epsilon[i] = 1.0 / AT_STATE_PENALTY * c->number[c->m->row_sigma_at + i];
    return equations_at_state(c);
}

/* Their number, and they: multipliers of rows that are on. */
static inline int32_t *rows_on(const context *c) { return (int32_t *)(void *)c->k.rows_on; }

/* Lists the multipliers whose rows are on, which the factors at hand join to the motion. */
static void list_rows_on(const context *rows)
{
    int32_t *on = rows_on(rows), n = 0;
    EACH_ROW(rows, i)
        if (state_of_multiplier(rows, i) != ROW_IS_OFF) on[++n] = i;
    on[0] = n;
}

/* Factors of these equations. */
static int32_t factorise_at_state(const context *c)
{
    const context rows = rows_at_state(c);
    const int32_t status = assemble_tangent(&rows);
    list_rows_on(&rows);
    return status ? status : factorise_matrix(&rows);
}

/* Solves  A x + G' mu = -f,  G x = -g  with A the mass matrix of the factors at hand and G at the
   present links; a sliding row has mu - (that of its cone) = g instead. f is `momentum` over the
   unknowns, g is `phi` (both not modified); x in rhs order of the unknowns; regularised and
   iterated so that dependent rows do no harm. */
static void solve_with_factors(const context *c)
{
    const context rows = equations_at_state(c);
    const int32_t *on = rows_on(c), n = *on++, *position = rows.factors.lu->row_position;
    double largest = 0.0, change = INFINITY, before = INFINITY;
    EACH_ROW(&rows, i) c->k.rhs[position[i]] = 0.0;
    for (int repeat = 0; repeat < MOST_REPEATS && (repeat < 4 || change > 1e-14 * largest)
                         && (repeat < USUAL_REPEATS || change < STILL_FALLS * before);
         repeat++) {
        before = change;
        gather_momentum(&rows);
        for (int32_t j = 0; j < n; j++) {
            const int32_t i = on[j];
            c->k.rhs[position[i]] = state_of_multiplier(c, i) == ROW_IS_SLIDING
                                        ? -c->k.epsilon[i] * c->k.phi[i]
                                        : -(c->k.phi[i] + c->k.epsilon[i] * c->k.mu[i]);
        }
        solve_factors(&rows);
        largest = change = 0.0;
        for (int32_t j = 0; j < n; j++) {
            const int32_t i = on[j];
            const double mu = c->k.rhs[position[i]];
            change = fmax(change,
                          c->k.epsilon[i] * fabs(mu - c->k.mu[i])); /* what the row still lacks */
            largest = fmax(largest, c->k.epsilon[i] * fabs(mu));
            c->k.mu[i] = mu;
        }
    }
}

/* Likewise from momenta of nodes. */
static void solve_for_momenta(const context *c)
{
    clear_bodies(c, c->k.torque, TURNING);
    if (has_turns(c)) reduce_momentum(c);
    solve_with_factors(c);
}

/* Likewise for given `phi` and `momentum`: x in coordinates (overwritten), multipliers in mu. */
static void solve_for(const context *c, double *x)
{
    memset(x, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    solve_for_momenta(c);
    add_solution(c, x);
}

/* Likewise with new factors. */
static int32_t solve_at_state(const context *c)
{
    const int32_t status = factorise_at_state(c);
    if (!status) solve_for_momenta(c);
    return status;
}

/* Adds to momentum a force along the leaf `entry` of composite j. */
static void add_leaf_force(const context *at, int32_t j, const int32_t *entry,
                           const leaf_state *leaf, double force)
{
    for (int i = 0; i < 2 && entry[2 + i] >= 0; i++) {
        const local_form *local = (const local_form *)at->k.local + entry[2 + i];
        add_gradient(at, at->m->composite_form[at->m->composite_form_ptr[j] + entry[2 + i]],
                     force * leaf->p[i], local->um, local->wm, at->k.momentum);
    }
}

/* Adds to momentum the forces of elements with these coefficients at rates of what they measure in
   the motion x. */
static int32_t add_forces_of_elements(const context *at, int64_t coefficient_at, const double *x)
{
    const holonom_model *m = at->m;
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
        add_leaf_force(at, j, entry, &leaf, coefficient * rate);
    }
    return HOLONOM_OK;
}

/* Residual at the state, M w + G' mu - Q, with the dampers' forces from the velocities. */
static int32_t residual_at_state(const context *at)
{
    const holonom_model *m = at->m;
    int32_t status = nodal_residual(at);
    if (!status) status = add_forces_of_elements(at, m->damping_at, at->s.v);
    for (int32_t j = first_potential(at); j < n_composites(at) && !status; j++) {
        composite_result unused;
        double power;
        if (!is_damped(at, j)) continue;
        if ((status = composite_slopes(at, j, SLOPES_ALONE, &unused))) break;
        const double share = damping_at_state(at, j, &power);
        add_slopes(at, j, share, at->k.slope);
    }
    if (has_turns(at)) reduce_momentum(at);
    return status;
}

/* momentum = -Q (and M a of driven nodes, in w) at the state. */
HM_SELDOM static int32_t forces_at_state(const context *c)
{
    context at = *c;
    at.h = 1.0;
    at.step.at_state = 1;
    return residual_at_state(&at);
}

/* Second derivative of quantity j at constant velocities. */
HM_SELDOM static double second_rate(const context *c, int32_t j)
{
    const holonom_model *m = c->m;
    const int32_t kind = m->quantity_kind[j], *form = m->quantity_form + 2 * j;
    double s[2] = {0.0, 0.0}, rate[2] = {0.0, 0.0}, bend[2] = {0.0, 0.0}, vu[DIM], vw[DIM];
    for (int i = 0; i < (kind == QUANTITY_ANGLE ? 2 : 1); i++) {
        const double *u = c->k.u0 + DIM * form[i], *w = c->k.w0 + DIM * form[i];
        link_of(c, form[i], c->s.v, vu, vw);
        s[i] = dot(u, w);
        rate[i] = dot(u, vw) + dot(w, vu);
        bend[i] = 2.0 * dot(vu, vw);
    }
    if (kind == QUANTITY_FORM) return bend[0];
    const double size2 = s[0] * s[0] + s[1] * s[1];
    if (!(size2 > 0.0)) return 0.0;
    if (kind == QUANTITY_LENGTH)
        return (0.5 * bend[0] - 0.25 * rate[0] * rate[0] / s[0]) / sqrt(s[0]);
    const double turning = (s[0] * rate[1] - s[1] * rate[0]) / size2;
    return (s[0] * bend[1] - s[1] * bend[0] - 2.0 * turning * (s[0] * rate[0] + s[1] * rate[1]))
           / size2;
}

/* Bias of row j, a function or velocity row: its second derivative at constant velocities, of a
   velocity row the first. Rates of signals are `signal_rate`, their second derivatives
   `signal_bend`. `before`: the row whose bias was computed last, at the same state; -1: any. */
HM_SELDOM static double next_bias(const context *c, int32_t before, int32_t j)
{
    const holonom_model *m = c->m;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j], *entry = m->leaf + 4 * m->leaf_ptr[j];
    hm_jet *x = (hm_jet *)c->k.leaves;
    if (is_next_slip(c, before, j, SLOPES_ALONE))
        return function_jet(c, j, m->function_known[j - first_function(c)], x, NULL).rate;
    for (int32_t l = 0; l < n; l++, entry += 4) {
        const int32_t q = entry[1];
        if (entry[0] == LEAF_SIGNAL)
            x[l] = (hm_jet){c->s.signal[q], c->k.signal_rate[q], c->k.signal_bend[q]};
        else {
            x[l].value = quantity_at(c, q, c->s.q, c->s.q_low, c->s.v, &x[l].rate);
            x[l].bend = second_rate(c, q);
        }
        if (entry[0] == LEAF_RATE) x[l] = (hm_jet){x[l].rate, x[l].bend, 0.0};
    }
    const hm_jet found = function_jet(c, j, 0, x, NULL);
    return is_velocity_row(c, j) ? found.rate : found.bend;
}

static double bias_of(const context *c, int32_t j) { return next_bias(c, -1, j); }

/* Likewise, less the value of a velocity row at rest, which belongs to G a where that is the row of
   a. */
HM_SELDOM static double bias_of_row(const context *c, int32_t j)
{
    double *rest = c->k.ahead;
    if (!is_velocity_row(c, j)) return bias_of(c, j);
    memset(rest, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    const double own = function_rate(c, j, rest, c->k.signal_rate);
    return bias_of(c, j) - own + (is_unilateral(c->m) ? c->k.drift[row_of(c, j)] : 0.0);
}

/* Rates of the slips of frictions by numbers that change with time, such as the speed of a surface
   (drift). */
HM_SELDOM static void find_drifts(context *c)
{
    const holonom_model *m = c->m;
    const double t = c->number[m->time_at];
    hm_jet *x = (hm_jet *)c->k.leaves;
    memset(c->k.drift, 0, sizeof(double) * (size_t)m->n_rows);
    if (!m->time_dependent || !n_frictions(m)) return;
    memset(c->k.jet, 0,
           sizeof(double) * (size_t)(2 * m->n_numbers)); /* frictions may read any of them */
    load_jets(c, t, 1);
    hm_run_jets(m, c->number, 1, c->k.jet);
    for (int32_t k = 0; k < m->friction_row_ptr[n_frictions(m)]; k++) {
        const int32_t j = m->friction_row[k], *entry = m->leaf + 4 * m->leaf_ptr[j];
        for (int32_t l = 0; l < m->leaf_ptr[j + 1] - m->leaf_ptr[j]; l++, entry += 4) {
            const int is_signal = entry[0] == LEAF_SIGNAL, is_value = entry[0] == LEAF_VALUE;
            x[l] = (hm_jet){is_signal ? c->s.signal[entry[1]] : 0.0, 0.0,
                            0.0}; /* rates are 0: the mechanism rests */
            if (is_value) x[l].value = quantity_at(c, entry[1], c->s.q, c->s.q_low, NULL, NULL);
        }
        c->k.drift[row_of(c, j)] = function_jet(c, j, 0, x, c->k.jet).rate;
    }
    set_laws(c, t, 0); /* as they are now, not just after a jump */
}

/* Second derivatives of the rows at constant velocities, -G a = bias; accelerations of driven nodes
   in w. Signals are as they go on from now: drivers may have a kink at the start. */
HM_SELDOM static void row_biases(context *c)
{
    const holonom_model *m = c->m;
    double *bias = c->k.row_bias, vu[DIM], vw[DIM];
    for (int32_t i = 0; i < m->n_rows; i++) bias[i] = 0.0;
    signal_jets_at(c, c->t, c->k.signal_rate, c->k.signal_bend);
    if (is_unilateral(m)) find_drifts(c);
    for (int32_t j = first_function(c); j < first_potential(c); j++)
        if (state_of_row(c, j) == ROW_IS_ON) bias[row_of(c, j)] = bias_of_row(c, j);
    for (int32_t i = 0; i < m->n_form_rows; i++) {
        link_of(c, m->row_form[i], c->s.v, vu, vw);
        bias[i] = 2.0 * dot(vu, vw); /* v'Hv */
    }
    memcpy(c->k.w + DIM * m->n_free, c->k.signal_bend,
           sizeof(double) * (size_t)(DIM * m->n_driven));
}

#endif
