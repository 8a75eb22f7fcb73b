/* Start of a run: islands whose rows depend on each other, nodes with a motion of their own, first
   accelerations and multipliers. */
#ifndef HOLONOM_START_H
#define HOLONOM_START_H

#include "equations_at_state.h"
#include "scales.h"

static int all_finite(const double *x, int64_t n)
{
    for (int64_t k = 0; k < n; k++)
        if (!(fabs(x[k]) < INFINITY)) return 0;
    return 1;
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

/* Whether a row's pivot, by the factors at hand at the state, is no more than a hundred times
   that of a dependent row, epsilon. */
static int has_small_pivot(const context *c)
{
    const holonom_elimination *lu = c->factors.lu;
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
        select_islands(&rows, island, island + 1);
        const double left = fails ? 1.0 : left_by_updates(&rows);
        if (fails || (left > LEFT_OF_DEPENDENT_ROWS && has_small_pivot(&rows))) {
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
        row_rates(c, c->k.w, c->k.signal_rate, rate);
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

/* Velocity that momenta of 1 give a node of 1 kg where rows and drivers leave it none:
   round-off. */
#define NO_FREEDOM 1e-9

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
