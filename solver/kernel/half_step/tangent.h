/* Residual and tangent of one step, the regularised KKT system

       [ A      h Gm' ] [dw ]     [ (2/h) M w + h (Gm' mu - Q) ]      A = (2/h) M + h (1/2 sum mu_i
   H_i + K), [ G_1    -eps  ] [dmu] = - [ Phi_1 - eps (mu - lambda)  ]      w = d - h v_n.

   It is not symmetric: Gm is taken at the midpoint, G_1 at the end. Unknown is w, not
   q_1 or d: M (v_1 - v_n) = (2/h) M w then has the size of the forces, not of the momenta, and
   keeps its digits. */
#ifndef HOLONOM_TANGENT_H
#define HOLONOM_TANGENT_H

#include "cone_tangent.h"
#include "laws.h"
#include "reduced_rows.h"
#include "square_rows.h"

/* Adds factor alpha_p alpha_q B for all pairs of free entries of form f, B (DIM x DIM). */
static const int32_t *scatter_block(const context *c, int32_t f, double factor, const double *block,
                                    const int32_t *slot, double *value)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at + m->form_ptr[f];
    const int32_t *node = m->form_node + m->form_ptr[f];
    for (int32_t p = 0; p < m->form_free[f]; p++)
        for (int32_t q = 0; q < m->form_free[f]; q++) {
            double own[DIM * DIM], x[DIM * DIM];
            for (int k = 0; k < DIM * DIM; k++) own[k] = factor * alpha[p] * alpha[q] * block[k];
            slot = scatter(block_to_unknowns(c, node[p], node[q], own, x), x, slot, value);
        }
    return slot;
}

/* block += grad s_i(theta) (sum curve_ig grad s_g(end))' of form i. */
HM_OFTEN void add_curves(const context *c, int32_t i, int32_t forms, int32_t size)
{
    const double *gradient = c->k.gradient + size * i;
    int acts = 0;
    if (forms == 1) {
        for (int32_t a = 0; a < size; a++) {
            const double x = c->k.curve[0] * gradient[a];
            double *row = c->k.block + size * a;
            for (int32_t b = 0; b < size; b++) row[b] += x * c->k.gradient_end[b];
        }
        return;
    }
    for (int32_t k = 0; k < forms; k++) acts |= c->k.curve[forms * i + k] != 0.0;
    for (int32_t b = 0; b < size && acts; b++) {
        double *column = c->k.block + b, sum = 0.0;
        for (int32_t k = 0; k < forms; k++)
            sum += c->k.curve[forms * i + k] * c->k.gradient_end[size * k + b];
        for (int32_t a = 0; a < size && sum != 0.0; a++) column[size * a] += gradient[a] * sum;
    }
}

/* block = sum curve_fg grad s_f(theta) grad s_g(end)' + theta sum slope_f H_f. */
static void composite_stiffness(const context *c, int32_t j, int32_t size)
{
    const holonom_model *m = c->m;
    const int32_t *local = places_of(c, j), *place = local_place(c);
    const int32_t forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
    memset(c->k.block, 0, sizeof(double) * (size_t)(size * size));
    for (int32_t i = 0; i < forms; i++) {
        const int32_t f = m->composite_form[m->composite_form_ptr[j] + i], begin = m->form_ptr[f];
        add_curves(c, i, forms, size);
        const double factor = c->step.theta * c->k.slope[i];
        for (int32_t p = 0; p < m->form_free[f] && !(m->form_kind[f] & FORM_LINEAR); p++)
            for (int32_t q = 0; q < m->form_free[f]; q++) {
                double same, quarter,
                    *corner = c->k.block + size * place[local[p]] + place[local[q]];
                const int32_t *node = m->form_node + begin;
                pair_stiffness(c, f, begin + p, begin + q, &same, &quarter);
                if (is_director(c, node[p]) || is_director(c, node[q])) {
                    double x[DIM * DIM];
                    block_of_same(c, node[p], node[q], factor * same, factor * quarter, x);
                    const int rows = unknown_size(c, node[p]), columns = unknown_size(c, node[q]);
                    for (int r = 0; r < rows; r++)
                        for (int k = 0; k < columns; k++)
                            corner[size * r + k] += x[columns * r + k];
                    continue;
                }
                EACH(k) corner[size * k + k] += factor * same;
#if DIM == 2
                corner[1] -= factor * quarter;
                corner[size] += factor * quarter;
#endif
            }
        local += m->form_free[f];
    }
}

static int32_t composite_tangent(const context *c, double *value)
{
    const holonom_model *m = c->m;
    int32_t before = -1, size = 0;
    EACH_COMPOSITE(c, j) {
        const int32_t *slot = c->factors.lu->composite_slot + c->factors.lu->composite_slot_ptr[j];
        const int32_t forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j],
                      row = is_row(c, j);
        composite_result result = {0.0, 0.0, 0.0};
        const enum row_state state = state_of_row(c, j);
        if (((is_lean(c) || c->step.constraints_only) && !row) || state == ROW_IS_OFF) continue;
        const double factor = row ? c->h * c->k.mu[row_of(c, j)] : c->h;
        const int is_stiff =
            !is_lean(c) && factor != 0.0 && !(c->friction.soft && state == ROW_IS_SLIDING);
        const int asked = is_stiff ? WITH_STIFFNESS : WITH_ENDS,
                  is_next = is_next_slip(c, before, j, asked);
        const int32_t status = next_slopes(c, is_next, j, asked, &result);
        if (status) return status;
        if (!is_next) size = local_gradients(c, j, 0);
        before = j;
        if (!is_lean(c) && !is_stiff) slot += size * size;
        if (is_stiff) {
            const double *block = c->k.block;
            composite_stiffness(c, j, size);
            for (int32_t k = 0; k < size * size; k++) value[*slot++] += factor * block[k];
        }
        for (int32_t k = 0; k < size && row; k++, slot++)
            for (int32_t f = 0; f < forms; f++)
                value[*slot] += c->h * c->k.slope[f] * c->k.gradient[size * f + k];
        for (int32_t k = 0; k < size && row && state == ROW_IS_ON; k++, slot++)
            for (int32_t f = 0; f < forms; f++)
                value[*slot] += c->k.end[f] * c->k.gradient_end[size * f + k];
        if (state == ROW_IS_SLIDING && !c->step.at_state) turning_tangent(c, j, size, value);
    }
    if (n_frictions(c->m)) cone_tangent(c, value);
    return HOLONOM_OK;
}

static int32_t law_tangent(const context *c, double *value)
{
    const holonom_model *m = c->m;
    const int32_t *slot =
        c->factors.lu->moment_slot + c->factors.lu->moment_slot_ptr[c->view.begin[ISLAND_MOMENT]];
    double block[DIM * DIM];
    motion g;
    for IN_ISLAND(c, j, ISLAND_MOMENT) {
        double f[DIM];
        form_motion(c, m->moment_form[j], &g);
        const int32_t status = moment_law(c, j, &g, f, block);
        if (status) return status;
        slot = scatter_block(c, m->moment_form[j], -c->h, block, slot, value);
    }
    slot = c->factors.lu->load_slot + c->factors.lu->load_slot_ptr[c->view.begin[ISLAND_LOAD]];
    for IN_ISLAND(c, j, ISLAND_LOAD) slot = load_tangent(c, j, slot, value);
#if DIM == 3
    for IN_ISLAND(c, j, ISLAND_BODY_MOMENT) {
        const int32_t status =
            body_moment_tangent(c, j, c->factors.lu->body_moment_slot + 81 * j, value);
        if (status) return status;
    }
#endif
    return HOLONOM_OK;
}

/* Pivots of the islands at hand. */
static inline int32_t first_pivot(const context *c)
{ return c->factors.lu->lu_island[4 * c->view.first]; }
static inline int32_t end_pivot(const context *c)
{ return c->factors.lu->lu_island[4 * c->view.last]; }

/* Rows that are left out: the pivot -1, no couplings, the right-hand side 0. */
static void set_rows_apart(const context *c, double *value)
{
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY; k++)
        for IN_ISLAND(c, j, k) {
            const int32_t place = c->factors.lu->row_position[row_of(c, j)];
            if (state_of_row(c, j) != ROW_IS_OFF) continue;
            value[c->factors.lu->lu_ptr[place]] = -1.0;
            c->k.rhs[place] = 0.0;
        }
}

/* Of masses in residual and tangent: 2/h in a step, 1 at a state, where `h` is 1. */
static inline double mass_factor(const context *c) { return c->step.at_state ? 1.0 : 2.0 / c->h; }

/* momentum = factor M x over the moving nodes, the inertia term of the residual. */
static void inertia(const context *c, double factor, const double *x, double *momentum)
{
    const holonom_model *m = c->m;
    const double *mass_of = c->number + m->mass_at;
    EACH_COORDINATE(c, k) momentum[k] = 0.0;
    for IN_ISLAND(c, e, ISLAND_MASS) {
        const int32_t *node = m->mass_node + 2 * e;
        const double mass = factor * mass_of[e], *column = x + DIM * node[1];
        double *row = momentum + DIM * node[0];
        EACH(k) row[k] += mass * column[k];
    }
}

/* Inertia of the turns of bodies, and the stiffness that all forces on their directors p_i have by
   turning with these:

       sum [ (y_i . d_i) 1 - d_i y_i' ],     y_i = (2/h) sum_k E_ik m_k - p_i/2,     d_i at the
   end. */
static void inertia_tangent(const context *c, double *value)
{
    double *y = c->k.ahead;
    inertia(c, mass_factor(c), c->k.middle, y);
    EACH_TURN(c, b) {
        const int32_t at = DIM * c->m->body_node[b],
                      *slot = c->factors.lu->inertia_slot + TURNING * TURNING * b;
        double *x = c->k.bend + at;
        for (int i = at; i < at + DIM * TURNING; i += DIM) {
            double own[DIM];
            EACH(k)
                own[k] = y[i + k] - (c->step.at_state ? 0.0 : c->step.theta * c->k.nodal[i + k]);
            add_turning(1.0, own, c->k.turned + i, x);
        }
        scatter(TURNING * TURNING, x, slot, value);
    }
}

/* Writes the tangent at the present (w, mu) into value. */
static int32_t assemble_tangent(const context *c)
{
    const holonom_model *m = c->m;
    double *value = c->k.value;
    const double factor = mass_factor(c);
    const int32_t first = c->factors.lu->lu_ptr[first_pivot(c)];
    memset(value + first, 0,
           sizeof(double) * (size_t)(c->factors.lu->lu_ptr[end_pivot(c)] - first));
    for (int32_t e = c->view.begin[ISLAND_MASS]; e < c->view.end[ISLAND_MASS] && e < m->n_mass_free;
         e++)
        EACH(k)
            if (c->factors.lu->mass_slot[DIM * e + k] >= 0)
                value[c->factors.lu->mass_slot[DIM * e + k]] += factor * c->number[m->mass_at + e];
    clear_bodies(c, c->k.bend, TURNING * TURNING);
    EACH_FORM_ROW(c, i) {
        const int32_t *slot = c->factors.lu->row_slot + c->factors.lu->row_slot_ptr[i];
        if (has_turns(c) || !is_square_row(c, i)) row_tangent(c, i, slot, value);
        else square_row_tangent(c, i, slot, value);
    }
    if (has_turns(c)) inertia_tangent(c, value);
    const int32_t *slot = c->factors.lu->coincidence_slot
                          + c->factors.lu->coincidence_slot_ptr[c->view.begin[ISLAND_COINCIDENCE]];
    for IN_ISLAND(c, j, ISLAND_COINCIDENCE)
        slot = coincidence_tangent(c, j, slot, value);
    EACH_ROW(c, i) value[c->factors.lu->lu_ptr[c->factors.lu->row_position[i]]] -= c->k.epsilon[i];
    if (c->view.left_out && !is_open(c)) set_rows_apart(c, value);
    const int32_t status = c->view.composites ? composite_tangent(c, value) : HOLONOM_OK;
    return status || c->step.constraints_only || is_lean(c) ? status : law_tangent(c, value);
}

/* Composites' part of the residual. */
static int32_t add_composites(const context *c)
{
    const holonom_model *m = c->m;
    int32_t before = -1, summed = -1; /* the last one, and if it is a slip whose slopes wait for
                                         those of the next one */
    EACH_COMPOSITE(c, j) {
        const int32_t row = is_row(c, j) ? row_of(c, j) : -1;
        composite_result result = {0.0, 0.0, 0.0};
        const enum row_state state = state_of_row(c, j);
        if (row < 0 && c->step.constraints_only) continue;
        if (state == ROW_IS_OFF) {
            c->k.phi[row] = 0.0;
            continue;
        }
        const int is_first = summed < 0 || !is_next_slip(c, summed, j, SLOPES_ALONE);
        if (summed >= 0 && is_first) add_slopes(c, summed, 1.0, c->k.slope_sum);
        summed = -1;
        const int32_t status =
            next_slopes(c, is_next_slip(c, before, j, SLOPES_ALONE), j, SLOPES_ALONE, &result);
        if (status) return status;
        before = j;
        double factor = c->h;
        if (row >= 0) {
            c->k.phi[row] =
                result.row
                + (is_seeking(c) || (j >= first_velocity_row(c) && !c->step.changes_contacts) ? 0.0
                                                                                 : c->k.phi0[row]);
            factor *= c->k.mu[row];
            c->k.change[row] = result.change;
            c->k.moved[row] = result.mechanical;
        } else if (j < first_function(c)) c->k.elongation[j] = result.mechanical;
        if (state == ROW_IS_SLIDING) {
            c->k.slip[row] = c->k.phi[row] / c->h;
            c->k.phi[row] = 0.0;
            sum_slopes(c, j, factor, is_first);
            summed = j;
        } else
            add_slopes(c, j, factor, c->k.slope);
    }
    if (summed >= 0) add_slopes(c, summed, 1.0, c->k.slope_sum);
    if (n_frictions(m)) follow_cones(c);
    return HOLONOM_OK;
}

/* Both residuals at the present (w, d, mu), of directors as points: momentum, and phi = Phi_1 of
   the rows. */
static int32_t nodal_residual(const context *c)
{
    const holonom_model *m = c->m;
    inertia(c, mass_factor(c), c->k.w, c->k.momentum);
    clear_bodies(c, c->k.torque, TURNING);
    EACH_FORM_ROW(c, i) {
        motion g;
        if (c->step.at_state && c->k.mu[i] == 0.0)
            continue; /* rows of a state are not asked for here */
        if (is_axes_row(c, i)) {
            axes_row_residual(c, i);
            continue;
        }
        if (is_square_row(c, i)) {
            square_row_residual(c, i);
            continue;
        }
        form_motion(c, m->row_form[i], &g);
        c->k.phi[i] = c->k.phi0[i] + g.ds;
        add_gradient(c, m->row_form[i], c->h * c->k.mu[i], g.um, g.wm, c->k.momentum);
    }
    for IN_ISLAND(c, j, ISLAND_COINCIDENCE) {
        const int32_t row = row_of_coincidence(m, j);
        if (c->step.at_state && dot(c->k.mu + row, c->k.mu + row) == 0.0) continue;
        coincidence_function(c, j, c->k.phi0 + row, c->k.phi + row);
        add_link_force(c, m->coincidence_form[j], c->h, c->k.mu + row, c->k.momentum);
    }
    const int32_t status = c->view.composites ? add_composites(c) : HOLONOM_OK;
    if (status) return status;
    return c->step.constraints_only ? HOLONOM_OK : subtract_forces(c, c->k.momentum);
}

/* Likewise over the unknowns. */
static int32_t evaluate_residual(const context *c)
{
    const int32_t status = nodal_residual(c);
    if (has_turns(c)) reduce_momentum(c);
    return status;
}

/* ----------------------------------------------------------- right-hand side, factors, solution */

/* Residual of a row. */
static inline double row_residual(const context *c, int32_t i)
{
    return c->k.phi[i] - c->k.epsilon[i] * (c->k.mu[i] - c->k.lambda[i]);
}

/* The nodes' part of the right-hand side -(momentum, rows) in elimination order. */
static void gather_momentum(const context *c)
{
    for (int32_t a = c->view.begin[ISLAND_FREE]; !has_turns(c) && a < c->view.end[ISLAND_FREE]; a++)
        EACH(k) c->k.rhs[c->factors.lu->node_position[a] + k] = -c->k.momentum[DIM * a + k];
    for (int32_t a = c->view.begin[ISLAND_FREE]; has_turns(c) && a < c->view.end[ISLAND_FREE];
         a = next_unknown(c, a))
        for (int k = 0; k < unknown_size(c, a); k++)
            c->k.rhs[c->factors.lu->node_position[a] + k] = -c->k.momentum[DIM * a + k];
}

static void gather_rhs(const context *c)
{
    gather_momentum(c);
    EACH_ROW(c, i) c->k.rhs[c->factors.lu->row_position[i]] = -row_residual(c, i);
}

/* Adds what was solved for, one vector a free node, to x (DIM n_free, modified); directors at the
   end turn with their body. */
static void add_solution(const context *c, double *x)
{
    for (int32_t a = c->view.begin[ISLAND_FREE], next; a < c->view.end[ISLAND_FREE]; a = next) {
        const double *own = c->k.rhs + c->factors.lu->node_position[a];
        next = next_unknown(c, a);
        for (int32_t k = DIM * a; k < DIM * next; k += DIM) {
            double turned[DIM];
            if (is_director(c, a)) turned_by(own, c->k.turned + k, turned);
            EACH(l) x[k + l] += is_director(c, a) ? turned[l] : own[l];
        }
    }
}

/* Many contacts, of which few are closed at a time, leave most of the pattern empty. */
static inline int is_mostly_empty(const context *c)
{ return n_contacts(c->m) > FEW_CONTACTS && !is_open(c); }

static inline live_pivots live_pivots_of(const context *c)
{
    int32_t *count = (int32_t *)(void *)c->k.live;
    const int32_t n = c->factors.lu->lu_island[4 * c->m->n_islands];
    int32_t *joined = (int32_t *)(void *)c->k.joined;
    return (live_pivots){count, count + n, joined, joined + n};
}

/* Whether pivots are eliminated in groups. */
static inline int has_groups(const context *c) { return has_turns(c) && !is_mostly_empty(c); }

/* Makes factors of the matrix in value, of the islands at hand. */
static inline int32_t factorise_matrix(const context *c)
{
    const holonom_elimination *lu = c->factors.lu;
    const int32_t begin = first_pivot(c), end = end_pivot(c),
                  *target = lu->lu_target + lu->lu_island[4 * c->view.first + 2];
    if (has_groups(c))
        return hm_block_factor(lu, c->view.first, c->view.last, c->k.value)
                   ? HOLONOM_SINGULAR_TANGENT
                   : HOLONOM_OK;
    const live_pivots live = live_pivots_of(c);
    const int fails = is_mostly_empty(c)
                          ? hm_lu_factor_live(lu, begin, end, target, c->k.value, &live)
                          : hm_lu_factor(lu, begin, end, target, c->k.value);
    return fails ? HOLONOM_SINGULAR_TANGENT : HOLONOM_OK;
}

static inline int32_t factorise(const context *c)
{
    const int32_t status = assemble_tangent(c);
    return status ? status : factorise_matrix(c);
}

/* Inverse pivot of row i, of what is left of -G A^-1 G' - epsilon; 0 of a row in a tree. */
static inline double inverse_pivot(const context *c, int32_t i)
{ return c->k.value[c->factors.lu->lu_ptr[c->factors.lu->row_position[i]]]; }

/* Whether row i is one of a tree (articulated.h), which is independent, well determined, and holds
   at once. */
static inline int is_in_tree(const context *c, int32_t i) { return inverse_pivot(c, i) == 0.0; }

/* Replaces the right-hand side by the solution. */
static inline void solve_factors(const context *c)
{
    const holonom_elimination *lu = c->factors.lu;
    const int32_t begin = first_pivot(c), end = end_pivot(c);
    if (has_groups(c)) hm_block_solve(lu, c->view.first, c->view.last, c->k.value, c->k.rhs);
    else if (is_mostly_empty(c)) {
        const live_pivots live = live_pivots_of(c);
        hm_lu_solve_live(lu, begin, end, &live, c->k.value, c->k.rhs);
    } else hm_lu_solve(lu, begin, end, c->k.value, c->k.rhs);
}

#endif
