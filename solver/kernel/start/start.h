/* Start of a run: scales of the rows, first accelerations and multipliers, closing a mechanism, its
   equilibrium. */
#ifndef HOLONOM_START_H
#define HOLONOM_START_H

#include "inputs_signals.h"

static int all_finite(const double *x, int64_t n)
{
    for (int64_t k = 0; k < n; k++)
        if (!(fabs(x[k]) < INFINITY)) return 0;
    return 1;
}

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
    const int32_t with_force = m->n_form_rows - m->n_rigidity_rows;
    for (int32_t row = 0; row < with_force + m->n_coincidences; row++) {
        const int32_t j = row - with_force, i = j < 0 ? row : m->n_form_rows + j;
        const int32_t f = j < 0 ? m->row_form[i] : m->coincidence_form[j];
        for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++) {
            const double inverse = 1.0 / node_mass[m->form_node[e]];
            double g[DIM], square = hm_square(c->number[m->alpha_at + e]);
            if (m->form_kind[f] & FORM_TURNED) square += hm_square(c->number[m->alpha_turn_at + e]);
            entry_gradient(c, f, e, c->k.u0 + DIM * f, c->k.w0 + DIM * f, g);
            if (j < 0) sigma[i] += dot(g, g) * inverse;
            else EACH(k) sigma[m->n_form_rows + DIM * j + k] += square * inverse;
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

/* Velocity that momenta of 1 give a node of 1 kg where rows and drivers leave it none:
   round-off. */
#define NO_FREEDOM 1e-9

#define AT_STATE_PENALTY 1e8

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
    double largest = 0.0, change = INFINITY;
    EACH_ROW(&rows, i) c->k.rhs[position[i]] = 0.0;
    for (int repeat = 0; repeat < 40 && (repeat < 4 || change > 1e-14 * largest); repeat++) {
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
    const double own = function_rate(c, j, c->s.q, c->s.q_low, rest, c->s.signal, c->k.signal_rate);
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

HM_SELDOM static void forget_dependent_rows(context *c)
{
    for (int32_t island = 0; island < c->m->n_islands; island++)
        c->s.islands[I_SIZE * island + I_DEPENDENT] = 0.0;
}

/* The largest eigenvalue of P (contract_multipliers): what the last of four updates leaves of
   random multipliers. Rows that are off keep theirs whatever moves, and do not count. */
static double left_by_updates(const context *c)
{
    double *x = c->k.row_bias, size2 = 0.0, left2 = 0.0;
    uint32_t random = 1;
    EACH_ROW(c, i) {
        random = 1664525u * random + 1013904223u;
        x[i] = state_of_multiplier(c, i) == ROW_IS_OFF ? 0.0 : random & 0x80000000u ? 1.0 : -1.0;
    }
    for (int time = 0; time < 4; time++) {
        size2 = left2 = 0.0;
        EACH_ROW(c, i) size2 += c->k.epsilon[i] * x[i] * x[i];
        contract_multipliers(c, x);
        EACH_ROW(c, i) left2 += c->k.epsilon[i] * x[i] * x[i];
    }
    return size2 > 0.0 ? sqrt(left2 / size2) : 0.0;
}

/* Whether a row's pivot, by factors lu at the state, is no more than a hundred times that of a
   dependent row, epsilon. */
static int has_small_pivot(const context *c, const holonom_elimination *lu)
{
    EACH_ROW(c, i)
        if (state_of_multiplier(c, i) == ROW_IS_ON
            && !(fabs(c->k.value[lu->lu_ptr[lu->row_position[i]]])
                 < 1e6 / c->number[c->m->row_sigma_at + i]))
            return 1;
    return 0;
}

/* Updates leave all of what dependent rows do not determine. A chain of 1e4 bars between two nails
   has pivots as small, but they leave .17 of its multipliers: its rows are independent, and a
   larger penalty serves them. */
#define LEFT_OF_DEPENDENT_ROWS 0.5

/* Marks islands whose rows depend on each other, by factors at the state, and chooses the penalties
   of the others. Takes from multipliers mu (n_rows, modified), if any, what dependent rows do not
   determine, as steps do. */
static void judge_rows(const context *c, double *mu)
{
    const holonom_model *m = c->m;
    context rows = rows_at_state(c);
    stand_still_as_bodies(&rows);
    const int fails = assemble_tangent(&rows) || factorise_matrix(&rows);
    for (int32_t island = 0; island < m->n_islands; island++) {
        look_at(&rows, island, island + 1);
        const double left = fails ? 1.0 : left_by_updates(&rows);
        if (fails || (left > LEFT_OF_DEPENDENT_ROWS && has_small_pivot(&rows, rows.factors.lu))) {
            rows.view.scalars[I_DEPENDENT] = ROWS_ARE_DEPENDENT;
            if (!fails && mu) leave_undetermined(&rows, mu, 0);
        } else if (!is_unilateral(m)) start_penalty(&rows, AT_STATE_PENALTY * left);
    }
}

/* Whether the friction of a joint slides: its cone turns with the multipliers that it is made
   from. */
HM_SELDOM static int has_sliding_joint(const context *c)
{
    for (int32_t f = 0; f < n_frictions(c->m); f++)
        if (friction_mode(c, f) == FRICTION_SLIDES && !is_of_contact(c, f)) return 1;
    return 0;
}

#define REFINED 1e-14

/* Whether a refinement has changed multipliers mu, to which it has been added, by rounding
   alone. */
HM_SELDOM static int is_refined(const context *c, const double *mu)
{
    double size2 = 0.0, change2 = 0.0; /* sums, which hand on what is no number */
    for (int32_t i = 0; i < c->m->n_rows; i++) {
        size2 += c->number[c->m->row_sigma_at + i] * mu[i] * mu[i];
        change2 += c->number[c->m->row_sigma_at + i] * c->k.mu[i] * c->k.mu[i];
    }
    return change2 <= REFINED * REFINED * size2;
}

/* Multipliers mu (n_rows, overwritten) and accelerations (in w) from  M a + G' mu = Q,  G a =
   -bias, refined with the factors at hand: light directions cost digits. */
HM_SELDOM static int32_t accelerations(context *c, double *mu)
{
    const holonom_model *m = c->m;
    const size_t rows = sizeof(double) * (size_t)m->n_rows;
    double *rate = c->k.row_rate;
    const int turns = has_sliding_joint(c);
    int32_t status = HOLONOM_OK;
    stand_still(c);
    row_biases(c);
    EACH_TURN(c, b) { /* directors stay orthonormal */
        const int32_t first = DIM * m->body_node[b];
        for (int i = first; i < first + DIM * TURNING; i += DIM)
            for (int j = first; j < first + DIM * TURNING; j += DIM) {
                const double both = dot(c->s.v + i, c->s.v + j);
                EACH(k) c->k.w[i + k] -= both * c->s.q[j + k];
            }
    }
    memset(mu, 0, rows);
    c->friction.cone_mu = mu;
    memset(c->k.signal_rate, 0, sizeof(double) * (size_t)m->n_signals);
    for (int refinement = 0; refinement < 4; refinement++) {
        memcpy(c->k.mu, mu, rows);
        if ((status = forces_at_state(c))) return status;
        row_rates(c, c->s.q, c->s.q_low, c->k.w, c->s.signal, c->k.signal_rate, rate);
        EACH_ROW(c, i)
            c->k.phi[i] = state_of_multiplier(c, i) == ROW_IS_SLIDING ? c->k.lambda[i] - mu[i]
                                                                      : c->k.row_bias[i] + rate[i];
        if ((refinement == 0 || turns) && (status = factorise_at_state(c))) return status;
        solve_with_factors(c);
        add_solution(c, c->k.w);
        EACH_ROW(c, i) mu[i] += c->k.mu[i];
        if (slides_in_space(c) && is_refined(c, mu)) break; /* each refinement runs its slips */
    }
    c->friction.cone_mu = c->k.mu;
    return status;
}

/* Marks nodes that no row holds; bodies' directions are held by rigidity. */
HM_SELDOM static void find_unheld(context *c)
{
    const holonom_model *m = c->m;
    for (int32_t a = 0; a < m->n_free; a++) c->s.freedom[a] = UNHELD;
    for (int32_t i = 0; i < m->n_form_rows; i++)
        for (int32_t e = m->form_ptr[m->row_form[i]]; e < m->form_ptr[m->row_form[i] + 1]; e++)
            if (m->form_node[e] < m->n_free) c->s.freedom[m->form_node[e]] = 1.0;
}

/* Marks nodes to which rows and drivers leave a motion of their own: those that momenta of all of
   them move. What drivers move alone is where it has to be in steps of any length. */
HM_SELDOM static void find_freedom(context *c)
{
    const holonom_model *m = c->m;
    double *x = c->k.w;
    for (int32_t a = 0; a < c->n_moving; a++) c->s.freedom[a] = 1.0;
    if (is_unilateral(m)) return;
    if (m->n_rows == m->n_form_rows) find_unheld(c);
    if (!m->n_signals) return;
    stand_still(c);
    memset(c->k.phi, 0, sizeof(double) * (size_t)m->n_rows);
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t k = 0; k < DIM * m->n_free; k++) /* in no simple relation to each other */
        c->k.momentum[k] =
            sqrt(c->number[m->node_mass_at + k / DIM]) * (1.0 + 0.618 * k - floor(0.618 * k));
    if (factorise_at_state(c)) return;
    solve_for(c, x);
    for (int32_t a = 0; a < m->n_free; a++)
        c->s.freedom[a] *=
            c->number[m->node_mass_at + a] * dot(x + DIM * a, x + DIM * a) > hm_square(NO_FREEDOM);
}

static int32_t first_multipliers(context *c)
{
    const holonom_model *m = c->m;
    const size_t rows = sizeof(double) * (size_t)m->n_rows,
                 driven = sizeof(double) * (size_t)(DIM * m->n_driven);
    double *mu = c->s.mu[0];
    int32_t status = accelerations(c, mu);
    if (status) return status;
    memcpy(c->s.mean, mu, rows);
    judge_rows(c, c->s.mean);
    memcpy(c->k.mu, mu, rows);
    if (m->n_driven && (status = forces_at_state(c))) return status;
    memcpy(c->s.a[0], c->k.w, sizeof(double) * (size_t)(DIM * c->n_moving));
    memcpy(c->s.a[1], c->k.w, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t b = 0; b < n_bodies(m); b++)
        common_turn(c, m->body_node[b], c->k.w + DIM * m->body_node[b], c->s.turn[0] + TURNING * b);
    memcpy(c->s.turn[1], c->s.turn[0], sizeof(double) * (size_t)(TURNING * n_bodies(m)));
    for (int32_t k = 0; k < DIM * m->n_driven; k++)
        c->s.driven[0][k] = c->k.momentum[DIM * m->n_free + k];
    memcpy(c->s.driven[1], c->s.driven[0], driven);
    memcpy(c->s.driven_mean, c->s.driven[0], driven);
    memcpy(c->s.driven_mean_before, c->s.driven[0], driven);
    memcpy(c->s.mu[1], mu, rows);
    memcpy(c->s.mean_before, c->s.mean, rows);
    c->s.head[S_MEAN_TIME] = c->s.head[S_MEAN_TIME_BEFORE] = c->t;
    return HOLONOM_OK;
}

#endif
