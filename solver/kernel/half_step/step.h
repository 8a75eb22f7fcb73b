/* One conserving step: Uzawa's iteration around Newton's. */
#ifndef HOLONOM_STEP_H
#define HOLONOM_STEP_H

#include "newton.h"
#include "predict.h"

/* Round-off of the coordinates in the mass norm. */
static inline double round_off_of_places(const context *c)
{ return 32.0 * 2.3e-16 * c->number[c->m->extent_at + 1]; }

/* Whether a step is long enough to tell an acceleration and a multiplier: rounding errors enter
   both over h^2. A shorter one leaves those of the last step, which are as good, and the
   constraints' round-off as it is. */
static inline int is_telling(const context *c)
{
    return fabs(c->h) >= (is_unilateral(c->m) ? 1e-3 : 1e-5)
                             * usual_length(c); /* pieces between events are short */
}

/* Form rows and coincidences at the state, to the last digit; 0 if not `exact`. */
static void form_rows_at_state(const context *c, int exact)
{
    const holonom_model *m = c->m;
    EACH_FORM_ROW(c, i) c->k.phi0[i] = exact ? row_at_state(c, i) : 0.0;
    for IN_ISLAND(c, j, ISLAND_COINCIDENCE) {
        double high[DIM] = {0.0}, low[DIM] = {0.0};
        if (exact) exact_link(c, m->coincidence_form[j], m->alpha_at, m->alpha_turn_at, high, low);
        EACH(k) c->k.phi0[row_of_coincidence(m, j) + k] = high[k] + low[k];
    }
}

/* Rows at the beginning of the step; functions in double precision, others to the last digit, or
   with the digits that the end of the half step before has, of its increments, which are smaller
   than the coordinates. */
static void rows_at_start(context *c, int exact)
{
    if (exact && c->step.rows_known && c->view.scalars[I_DEPENDENT] == ROWS_ARE_INDEPENDENT)
        EACH_ROW(c, i) c->k.phi0[i] = c->k.phi[i];
    else form_rows_at_state(c, exact);
    EACH_ROW_OF_KIND(c, j, ISLAND_FUNCTION)
        c->k.phi0[row_of(c, j)] = exact && state_of_row(c, j) == ROW_IS_ON
                                      ? function_value(c, j) - reference_of(c, j)
                                      : 0.0;
    EACH_ROW_OF_KIND(c, j, ISLAND_VELOCITY)
        c->k.phi0[row_of(c, j)] = c->step.changes_contacts ? -c->k.stop[row_of(c, j)] : 0.0;
}

#define MOST_TURNED 2.5 /* rad */

/* Whether no direction is about to turn by more: a step would take the shorter way round, with an
   exact ledger and the wrong motion. */
static int turns_little(const context *c)
{
    EACH_NODE(c, a)
        if (c->m->node_kind[a]
            && !(dot(c->k.hv + DIM * a, c->k.hv + DIM * a) <= MOST_TURNED * MOST_TURNED))
            return 0;
    return 1;
}

/* Increments of the unknowns where there are bodies. */
static void begin_unknowns(const context *c, int parity, int reach)
{
    const history turn = turning_so_far(c, parity);
    EACH_COORDINATE(c, k) c->k.move[k] = c->k.d[k];
    EACH_TURN(c, b) {
        const int32_t a = c->m->body_node[b];
        double acceleration[TURNING];
        for (int k = 0; k < DIM * TURNING; k++) c->k.move[DIM * a + k] = 0.0;
        for (int k = 0; k < TURNING; k++)
            acceleration[k] = predicted(reach, &turn, TURNING * b + k);
        begin_turn(c, a, acceleration);
    }
}

/* Links, rows, compliances, warm start and predictor at the beginning of a step of length c->h. */
static void prepare_step(context *c, int parity)
{
    c->laws.reads = reads_the_step(c);
    c->secants.has_last = 0;
    c->step.unsettled = INFINITY;
    const holonom_model *m = c->m;
    const double h = c->h;
    EACH_TURN(c, b) if (c->step.half == 0) straighten(c, m->body_node[b]);
    links_at_start(c);
    const int reach = known_misses(c);
    const history a = accelerations_so_far(c, parity), mu = multipliers_so_far(c, parity);
    EACH_COORDINATE(c, k) { /* w is h^2/2 times an acceleration */
        c->k.hv[k] = h * c->s.v[k] + h * c->s.v_low[k];
        if (is_director(c, k / DIM)) continue; /* its body's turn tells */
        c->k.w[k] = 0.5 * h * h * predicted(reach, &a, k);
        c->k.d[k] = c->k.hv[k] + c->k.w[k];
    }
    const int32_t first = DIM * m->n_free;
    for (int32_t k = DIM * c->view.begin[ISLAND_DRIVEN]; k < DIM * c->view.end[ISLAND_DRIVEN];
         k++) { /* go where they must */
        c->k.d[k] = (c->k.signal1[k - first] - c->s.q[k]) - c->s.q_low[k];
        c->k.w[k] = c->k.d[k] - c->k.hv[k];
    }
    if (has_turns(c)) begin_unknowns(c, parity, reach);
    rows_at_start(c, is_telling(c) || c->step.changes_contacts);
    const double rows = c->view.scalars[I_DEPENDENT];
    const double compliance = compliance_over_sigma(c),
                 kept = rows == ROWS_ARE_WEAK ? 1.0 - FORGOTTEN : 1.0;
    EACH_ROW(c, i) {
        c->k.epsilon[i] = compliance * c->number[m->row_sigma_at + i];
        c->k.mu[i] = kept * c->s.mu[parity][i];
    }
    /* Lambda is predicted, too, with dependent rows, whose multipliers clean_multipliers has
       cleaned, and where choose_lambda says so. Else it is the last one: near a singular
       configuration a prediction would amplify what the rows leave undetermined. */
    const int follows =
        rows == ROWS_ARE_DEPENDENT
        || (rows == ROWS_ARE_INDEPENDENT && c->view.scalars[I_PREDICTS_LAMBDA] != 0.0);
    if (!follows) update_multipliers(c);
    if (rows == ROWS_ARE_WEAK) return;
    EACH_ROW(c, i) c->k.mu[i] = predicted(reach, &mu, i);
    if (follows) update_multipliers(c);
}

/* Whether what rows that contradict each other cannot meet together is accepted; once a step, whose
   penalty, which multiplies what they miss, is not raised then. */
static int miss_together(const context *c, newton_record *r)
{
    if (c->view.scalars[I_DEPENDENT] != ROWS_CONTRADICT || r->penalty_raises || r->missed) return 0;
    if (!accept_contradiction(c)) return 0;
    r->missed = 1;
    r->updates++;
    return 1;
}

/* Outer Uzawa iteration around the inner Newton iteration (paper, section 2.2, eqs 15, 16);
   `updates` (overwritten) are those after an inner iteration, not the early ones within it. */
static int32_t iterate_uzawa(context *c, newton_record *r, int *updates)
{
    const int max_uzawa = (int)c->s.head[S_MAX_UZAWA];
    double last = INFINITY;
    for (*updates = 0;; *updates += 1) {
        const int32_t status = iterate_newton(c, r);
        if (status) return status;
        const double defect = constraint_defect(c);
        if (!(defect < INFINITY)) return HOLONOM_NOT_FINITE;
        if (rows_hold(c, r, defect, last)) return HOLONOM_OK;
        const int slow = updates_slowly(c, defect, last) && !rows_are_round_off(c, r, defect);
        if (miss_together(c, r)) {
            last = INFINITY;
            continue;
        }
        const int raised = slow && !r->missed && raise_penalty(c, r);
        if (!raised && is_stalled_round_off(c, r, defect, last)) return HOLONOM_OK;
        if (*updates >= max_uzawa) return outcome_of_updates(c, r, defect);
        last = defect;
        hold_multipliers(c, r);
    }
}

/* What a step takes. */
typedef struct effort {
    int increments, updates;
} effort;

/* One try with the factors chosen, from what prepare_step has left; what it takes is added to
   `total`. */
static int32_t try_step(context *c, int began_with_old, newton_record *r, effort *total)
{
    int updates = 0;
    int32_t status = turns_little(c) ? evaluate_balance(c) : HOLONOM_TURN_TOO_LARGE;
    if (!status) status = iterate_uzawa(c, r, &updates);
    judge_factors(c, r, began_with_old);
    choose_lambda(c, r);
    if (r->increments == 1) trust_less(c);
    if (!status && c->view.scalars[I_DEPENDENT] == ROWS_ARE_DEPENDENT) clean_multipliers(c);
    total->increments += r->increments;
    total->updates += r->updates;
    if (!status && !r->penalty_raises) follow_contraction(c->view.scalars, r->increments, updates);
    return status;
}

/* The record of a step that has seen nothing yet. */
static inline newton_record nothing_seen(const context *c)
{
    return (newton_record){.contraction = 1.0,
                           .contraction_above_round_off = 1.0,
                           .predicted_contraction = 1.0,
                           .floor = round_off_of_places(c)};
}

/* Another try of the step, with new factors. */
HM_SELDOM static int32_t try_again(context *c, int parity, newton_record *r, effort *total)
{
    c->factors.kept_h = 0.0;
    c->step.rows_known = 0;
    *r = nothing_seen(c);
    prepare_step(c, parity);
    return try_step(c, 0, r, total);
}

/* One step of an island; increments and updates that it takes are added to `total`. */
static int32_t solve_island(context *c, int parity, effort *total)
{
    newton_record r = nothing_seen(c);
    const double level = c->view.scalars[I_PENALTY_LEVEL];
    if (is_unilateral(c->m)) leave_rows_out(c);
    prepare_step(c, parity);
    hand_on(c);
    choose_factors(c);
    const int began_with_old = take_factors_over(c, &r);
    int32_t status = try_step(c, began_with_old, &r, total);
    if (status && began_with_old)
        status = try_again(c, parity, &r, total); /* old factors may have led astray */
    double *rows = c->view.scalars + I_DEPENDENT;
    if (status && !known_misses(c) && *rows != ROWS_ARE_INDEPENDENT && *rows != ROWS_CONTRADICT) {
        /* Dependent rows may contradict each other; a penalty would multiply what they miss. */
        *rows = ROWS_CONTRADICT;
        c->view.scalars[I_PENALTY_LEVEL] = level;
        status = try_again(c, parity, &r, total);
    }
    return status;
}

/* Into how many parts a step divides the mechanism, and lets the next one be at hand. Laws may read
   one island and act on another. */
static inline int32_t n_apart(const context *c)
{ return hm_skips(SKIP_ISLANDS) && !reads_the_step(c) ? c->m->n_islands : 1; }

static inline void select_part(context *c, int32_t part, int32_t parts)
{
    if (parts > 1) select_islands(c, part, part + 1);
}

/* One step of all islands that are chosen, each by itself. The numbers of increments and updates
   are those of the island that took most. */
static int32_t solve_step(context *c, int parity)
{
    const int32_t parts = n_apart(c);
    int32_t status = HOLONOM_OK;
    effort most = {0, 0};
    select_all_islands(c);
    set_weights(c);
    for (int32_t part = 0; part < parts && !status; part++) {
        effort own = {0, 0};
        if (!is_chosen(c, part)) continue;
        select_part(c, part, parts);
        status = solve_island(c, parity, &own);
        if (status == HOLONOM_NEWTON_DIVERGED && reads_the_step(c) && c->secants.count) {
            forget_secants(c); /* which may be of laws that have changed */
            status = solve_island(c, parity, &own);
        }
        take_all_rows(c);
        if (own.increments > most.increments) most.increments = own.increments;
        if (own.updates > most.updates) most.updates = own.updates;
    }
    select_all_islands(c);
    c->s.head[S_NEWTON_ITERATIONS] += most.increments;
    c->s.head[S_UZAWA_ITERATIONS] += most.updates;
    return status;
}

#endif
