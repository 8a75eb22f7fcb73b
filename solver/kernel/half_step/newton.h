/* Newton's iteration of one step. */
#ifndef HOLONOM_NEWTON_H
#define HOLONOM_NEWTON_H

#include "policy_penalty.h"
#include "secants.h"
#include "sensors.h"
#include "tangent.h"

/* Uzawa update: the total multiplier becomes the one held fixed. The paper's eq 16 adds alpha
   (Phi_n + Phi_1)/2 to lambda; with lambda + alpha/2 Phi_n held here, that would leave an extra
   alpha/2 Phi_n and the fixed point Phi_1 = -Phi_n (theory 3.3). */
static void update_multipliers(context *c)
{
    EACH_ROW(c, i) c->k.lambda[i] = c->k.mu[i];
    if (n_frictions(c->m)) follow_cones(c);
}

/* P x of multipliers x (modified), P = epsilon (G A^-1 G' + epsilon)^-1: what an Uzawa update with
   the factors at hand leaves of their error; that of a sliding row follows its cone. */
HM_SELDOM static void contract_multipliers(const context *c, double *x)
{
    memset(c->k.rhs + first_pivot(c), 0, sizeof(double) * (size_t)(end_pivot(c) - first_pivot(c)));
    EACH_ROW(c, i)
        if (state_of_multiplier(c, i) != ROW_IS_SLIDING)
            c->k.rhs[c->factors.lu->row_position[i]] = -c->k.epsilon[i] * x[i];
    solve_factors(c);
    EACH_ROW(c, i) x[i] = c->k.rhs[c->factors.lu->row_position[i]];
}

/* What two powers of P leave of multipliers differs by no more than so much of them where none of
   their rows are weakly determined. */
#define WEAK 1e-4
/* Likewise of what no row determines at all. A body 5e6 m long on a guide, whose rows determine it,
   needs less than 1e-5. */
#define UNDETERMINED 2e-6
#define MOST_REPEATED 12 /* powers of P */

/* Leaves of multipliers x (modified) what their rows do not determine, by powers of P: of what is
   determined it leaves some 1e-8, its square nothing. Of what is weakly determined, as next to a
   dead centre, higher powers leave less; 0 if they still leave much, but not the same. With `all`
   of it taken out, powers differ by no less than the ones before. */
HM_SELDOM static int keep_undetermined(const context *c, double *x, int all)
{
    const double most2 = hm_square(all ? UNDETERMINED : WEAK);
    double size2 = 0.0, change2 = INFINITY, before2, *last = c->k.row_rate;
    int is_told = 0;
    EACH_ROW(c, i) size2 += c->k.epsilon[i] * x[i] * x[i];
    contract_multipliers(c, x);
    for (int power = 2; power <= (all ? MOST_REPEATED : 2) && !is_told; power++) {
        before2 = change2;
        change2 = 0.0;
        EACH_ROW(c, i) last[i] = x[i];
        contract_multipliers(c, x);
        EACH_ROW(c, i) change2 += c->k.epsilon[i] * hm_square(x[i] - last[i]);
        is_told = change2 <= most2 * size2 && (!all || change2 >= 0.25 * before2);
    }
    return is_told;
}

/* Takes from multipliers x (modified) the part of dependent rows that is not determined; 0 if that
   cannot be told. */
HM_SELDOM static int leave_undetermined(const context *c, double *x, int all)
{
    double *left = c->k.row_bias;
    EACH_ROW(c, i) left[i] = state_of_multiplier(c, i) == ROW_IS_ON ? x[i] : 0.0;
    if (!keep_undetermined(c, left, all)) return 0;
    EACH_ROW(c, i) x[i] -= left[i];
    return 1;
}

/* Multipliers that the next step begins with, in the place of lambda: those of this one, less that
   part. */
static void clean_multipliers(context *c)
{
    EACH_ROW(c, i) c->k.lambda[i] = c->k.mu[i];
    if (!leave_undetermined(c, c->k.lambda, 0)) c->view.scalars[I_DEPENDENT] = ROWS_ARE_WEAK;
}

/* Takes from rows phi (modified) what dependent ones cannot meet together, whatever moves; row_bias
   has it. 0 if that cannot be told. */
HM_SELDOM static int leave_contradiction(const context *c, double *phi)
{
    EACH_ROW(c, i) phi[i] /= c->k.epsilon[i];
    const int is_told = leave_undetermined(c, phi, 1);
    EACH_ROW(c, i) phi[i] *= c->k.epsilon[i];
    EACH_ROW(c, i) c->k.row_bias[i] *= c->k.epsilon[i];
    return is_told;
}

static int is_small_contradiction(const context *c)
{
    double largest = 0.0;
    EACH_ROW(c, i)
        largest = fmax(largest, fabs(c->k.row_bias[i]) / c->number[c->m->row_scale_at + i]);
    return largest <= LARGEST_CONTRADICTION;
}

/* Takes what dependent rows cannot meet together for what they ask for, and its part out of the
   multipliers, which would grow with each update: parallel axes hold a loop once too often, and
   what rounding of its drawing misses would stop it in steps of 1e-6 s, whose multipliers grow as
   1/h^2. In two passes: what one leaves of it would do work. */
HM_SELDOM static int accept_contradiction(const context *c)
{
    EACH_ROW(c, i) c->k.lambda[i] = c->k.mu[i];
    for (int pass = 0; pass < 2; pass++) {
        if (!leave_contradiction(c, c->k.phi) || !is_small_contradiction(c)) return pass;
        EACH_ROW(c, i) c->k.phi0[i] -= c->k.row_bias[i];
        leave_undetermined(c, c->k.lambda, 1);
    }
    return 1;
}

/* Hands on what the last two half steps have left of the momentum balance, e_1 and e_2: the
   residual R of this one is solved for R + 2 e_1 - e_2 = 0. Newton's iteration leaves a part of
   what it corrects, with one sign over many steps, and the energies v'e would grow with the number
   of steps. With it the steps leave second differences of e: their energies cancel, except where
   the velocity itself changes (double pendulum, 1e6 steps of 10 ms: 1e-14 J, and 4e-12 J without
   it). The round-off of stiff springs is larger and of either sign; handed on it would grow, so it
   is not. */

static void hand_on(context *c)
{
    const double *e = c->s.imbalance, *before = c->s.imbalance_before;
    EACH_COORDINATE(c, k) c->k.handed_on[k] = 2.0 * e[k] - before[k];
}

/* Residuals with what was handed on. */
static int32_t evaluate_balance(context *c)
{
    if (c->laws.reads) read_the_step(c);
    const int32_t status = evaluate_residual(c);
    for (int32_t k = DIM * c->view.begin[ISLAND_FREE]; k < DIM * c->view.end[ISLAND_FREE]; k++)
        c->k.momentum[k] += c->k.handed_on[k];
    return status;
}

/* A row whose pivot is so many times epsilon determines its multiplier well: an Uzawa update leaves
   nothing of a prediction's error in it. */
#define FIRM 1e6

static int rows_are_firm(const context *c)
{
    double largest = 0.0;
    EACH_ROW(c, i) largest = fmax(largest, fabs(inverse_pivot(c, i)) * c->k.epsilon[i]);
    return largest * FIRM < 1.0;
}

/* The next step begins with predicted multipliers held fixed, too, where one increment may be all
   it takes: where the rows determine them well (a prediction would amplify from step to step what
   they do not), and the first increment of this step was short. Else those of the last pair are
   held: they are corrected once more, each time by another amount, and rounded to either side. A
   prediction is so smooth that rounding errors add up (heavy top, 3e5 steps of 4 ms: 3e-14 of the
   energy, and 5e-15 like this). */
#define NEARLY_THERE 1e-8

static void choose_lambda(context *c, const newton_record *r)
{
    const int is_short = r->first_increment < NEARLY_THERE * r->size;
    const double left = known_contraction(c, r->first_increment, r->size) * r->first_increment;
    const int is_enough = left <= NEWTON_MARGIN * r->target;
    c->view.scalars[I_PREDICTS_LAMBDA] = r->increments > 0 && c->factors.firm
                                   && (c->view.asleep || !is_unilateral(c->m))
                                   && (is_short || is_enough);
}

/* Whether factors may leave out how forces of sliding frictions turn with the place: first ones
   contract well enough. In space what they leave out costs as much as a dozen increments. */
static int is_soft_enough(const context *c, const newton_record *r)
{
    return c->friction.slides && (r->increments == 0 || slides_in_space(c));
}

/* Adds the increment in rhs; the squares of its size, and of that of d. */
HM_OFTEN void add_increment(const context *c, double *increment2, double *size2)
{
    const holonom_model *m = c->m;
    const double *rhs = c->k.rhs;
    *increment2 = *size2 = 0.0;
    EACH_NODE(c, a) {
        const double mass = c->number[m->node_mass_at + a];
        double *w = c->k.w + DIM * a, *d = c->k.d + DIM * a;
        if (a < m->n_free && !(has_turns(c) && m->node_kind[a])) {
            const double *x = rhs + c->factors.lu->node_position[a];
            EACH(k) w[k] += x[k];
            EACH(k) move_of(c)[DIM * a + k] = d[k] = c->k.hv[DIM * a + k] + w[k];
            *increment2 += mass * dot(x, x);
        } else if (a < m->n_free && m->node_kind[a] == NODE_DIRECTION) {
            const double *spin = rhs + c->factors.lu->node_position[a];
            *increment2 += turning_norm2(c, a, spin, 1);
            change_turn(c, a, spin);
        }
        *size2 += mass * dot(d, d);
    }
    EACH_ROW(c, i) c->k.mu[i] += rhs[c->factors.lu->row_position[i]];
}

/* Solves for one Newton increment and adds it; its size, that of d, and what they are measured
   against. */
static int32_t newton_update(context *c, newton_record *r)
{
    double increment2, size2;
    gather_rhs(c);
    solve_factors(c);
    if (c->laws.reads) follow_laws(c);
    add_increment(c, &increment2, &size2);
    const double reference = c->s.head[S_ENERGY_REFERENCE], h2 = c->h * c->h;
    r->eta = sqrt(increment2);
    r->size = sqrt(size2);
    r->target = c->s.head[S_NEWTON_TOLERANCE] * sqrt(size2 + 2.0 * h2 * reference);
    r->energy = 0.5 * size2 / h2 + reference;
    r->noise = 0.5 * r->floor * r->floor / h2;
    r->increments++;
    return r->eta < 1e150 && r->size < 1e150 ? HOLONOM_OK : HOLONOM_NOT_FINITE;
}

/* Takes the last increment back. */
static void take_back(context *c)
{
    for (int32_t k = DIM * c->view.begin[ISLAND_FREE]; k < DIM * c->view.end[ISLAND_FREE]; k++) {
        if (has_turns(c) && c->m->node_kind[k / DIM]) continue;
        c->k.w[k] -= c->k.rhs[c->factors.lu->node_position[k / DIM] + k % DIM];
        move_of(c)[k] = c->k.d[k] = c->k.hv[k] + c->k.w[k];
    }
    EACH_TURN(c, b) undo_turn(c, c->m->body_node[b]);
    EACH_ROW(c, i) c->k.mu[i] -= c->k.rhs[c->factors.lu->row_position[i]];
}

/* Uzawa update of a nested iteration; the residual of the rows follows. */
static void hold_multipliers(context *c, newton_record *r)
{
    update_multipliers(c);
    c->secants.has_last = 0;
    r->updates++;
}

/* Whether increments tell how far the next ones go: as soon as they contract, and until they grow.
   The first one does not. */
#define BEGIN_TO_SETTLE 0.6

static int is_settling(const context *c, const newton_record *r)
{
    const double most = c->step.unsettled < INFINITY ? 1.0 : BEGIN_TO_SETTLE;
    return r->increments >= 2 && r->contraction < most;
}

/* Newton's iteration with lambda held fixed: tangent, increment, residual; with early updates while
   it contracts well. */
static int32_t iterate_newton(context *c, newton_record *r)
{
    const int max_newton = (int)c->s.head[S_MAX_NEWTON];
    r->previous = 0.0;
    for (r->iteration = 0; r->iteration < max_newton; r->iteration++) {
        int32_t status = HOLONOM_OK;
        r->factors.kept = may_keep_factors(c, r);
        if (!r->factors.kept) {
            c->friction.soft = is_soft_enough(c, r);
            status = factorise(c);
            c->factors.firm = !status && rows_are_firm(c);
            c->secants.has_last = 0;
        }
        if (!status) status = newton_update(c, r);
        if (status) return status;
        judge_increment(c, r);
        c->step.unsettled = is_settling(c, r) ? r->eta / fabs(c->h) : INFINITY;
        if (is_misled(r)) take_back(c), c->secants.has_last = 0;
        if (r->eta <= fmax(read_enough(c) * r->size, r->floor)) c->laws.reads = 0;
        status = evaluate_balance(c);
        if (status) return status;
        if (has_converged(c, r)) return HOLONOM_OK;
        r->updated_multipliers = may_update_early(c, r);
        if (r->updated_multipliers) hold_multipliers(c, r);
        if (r->factors.slow) replace_factors(c, r);
    }
    return outcome_at_limit(c, r);
}

#endif
