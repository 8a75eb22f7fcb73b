/* Newton's iteration of one step. */
#ifndef HOLONOM_NEWTON_H
#define HOLONOM_NEWTON_H

#include "context.h"
#include "forms.h"
#include "linear_solve.h"
#include "tangent.h"

/* Uzawa update: the total multiplier becomes the one held fixed. The paper's eq 16 adds alpha (Phi_n + Phi_1)/2
   to lambda; with lambda + alpha/2 Phi_n held here, this leaves an extra alpha/2 Phi_n and the fixed point
   Phi_1 = -Phi_n. A conserving penalty holds alpha/2 Phi_n, the others nothing.                               */
static void update_multipliers(context *c)
{
    const int paper = c->s.head[S_PAPER_UPDATE] != 0.0;
    EACH_ROW(c, i) {
        double lambda = is_penalty(c) ? 0.0 : c->k.mu[i];
        if ((c->formulation == HOLONOM_CONSERVING_AL && paper) || c->formulation == HOLONOM_CONSERVING_PENALTY)
            lambda += c->k.phi0[i] / c->k.epsilon[i];
        c->k.lambda[i] = lambda;
    }
}

/* Largest |Phi|/l^2 of the rows that the Uzawa update drives to zero. */
static double constraint_defect(const context *c)
{
    const int averaged = c->formulation == HOLONOM_CONSERVING_AL && c->s.head[S_PAPER_UPDATE] != 0.0;
    double largest = 0.0;
    EACH_ROW(c, i) {
        const double phi = averaged ? 0.5 * (c->k.phi0[i] + c->k.phi[i]) : c->k.phi[i];
        const double scaled = fabs(phi) / c->number[c->m->row_scale_at + i];
        if (!(scaled <= largest) && largest == largest) largest = scaled; /* a NaN stays */
    }
    return largest;
}

/* Hands on what the last two half steps have left of the momentum balance, e_1 and e_2: the residual R of this one is
   solved for R + 2 e_1 - e_2 = 0. Newton's iteration leaves a part of what it corrects, with one sign over many steps,
   and the energies v'e would grow with the number of steps. With it the steps leave second differences of e: their
   energies cancel, except where the velocity itself changes (double pendulum, 1e6 steps of 10 ms: 1e-14 J, and 4e-12 J
   without it). The round-off of stiff springs is larger and of either sign; handed on it would grow, so it is not. */
#define SLIGHT 1e-14 /* speed of what is handed on, in the mass norm, over that of the reference energy */

static void hand_on(context *c)
{
    const double *e = c->s.imbalance, *before = c->s.imbalance_before;
    EACH_COORDINATE(c, k) c->k.handed_on[k] = 2.0 * e[k] - before[k];
}

/* Residuals with what was handed on. */
static int32_t evaluate_balance(context *c)
{
    const int32_t status = evaluate_residual(c);
    for (int32_t k = DIM * c->begin[ISLAND_FREE]; k < DIM * c->end[ISLAND_FREE]; k++) c->k.momentum[k] += c->k.handed_on[k];
    return status;
}

typedef struct newton_record {
    double theta, eta, size; /* contraction; in the mass norm, the last increment and d [kg^1/2 m]               */
    double target, floor;    /* tolerance and round-off of increments                                          */
    double energy, noise;    /* reference energy, and kinetic energy of the round-off of positions [J]          */
    int factorised, stiffened;
    int taken_over;          /* factors are those of the half step before                                           */
    int increments;      /* of the step                                                                            */
    int updates;         /* Uzawa updates of the step                                                             */
} newton_record;

/* Solves for one Newton increment and adds it; its size, that of d, and what they are measured against. */
static int32_t newton_update(context *c, newton_record *r)
{
    const holonom_model *m = c->m;
    double *rhs = c->k.rhs, increment2 = 0.0, size2 = 0.0;
    gather_rhs(c);
    hm_lu_solve(first_pivot(c), end_pivot(c), c->lu->lu_ptr, c->lu->lu_column, c->k.value, rhs);
    EACH_NODE(c, a) {
        const double mass = c->number[m->node_mass_at + a];
        double *w = c->k.w + DIM * a, *d = c->k.d + DIM * a;
        if (a < m->n_free) {
            const double *x = rhs + c->lu->node_position[a];
            EACH(k) w[k] += x[k];
            EACH(k) d[k] = c->k.hv[DIM * a + k] + w[k];
            increment2 += mass * dot(x, x);
        }
        size2 += mass * dot(d, d);
    }
    EACH_ROW(c, i) c->k.mu[i] += rhs[c->lu->row_position[i]];
    const double reference = c->s.head[S_ENERGY_REFERENCE], h2 = c->h * c->h;
    r->eta = sqrt(increment2);
    r->size = sqrt(size2);
    r->target = c->s.head[S_NEWTON_TOLERANCE] * sqrt(size2 + 2.0 * h2 * reference);
    r->energy = 0.5 * size2 / h2 + reference;
    r->noise = 0.5 * r->floor * r->floor / h2;
    r->increments++;
    return r->eta < 1e150 && r->size < 1e150 ? HOLONOM_OK : HOLONOM_NOT_FINITE;
}

/* A step's error must lie far below the tolerance: what is left in momentum or constraints has one sign over
   many steps and adds up in the energy (measured: double pendulum, h = 1e-3, 2e5 steps, |dE| 4.8e-11 J with
   margins of 1e-4 and 1e-3, 4e-14 J with these). The factors are kept, so that the last digits cost little.   */
#define NEWTON_MARGIN 1e-6
#define CONSTRAINT_MARGIN 1e-5
#define QUARTER_ULP 5.6e-17 /* of 1: no row is evaluated better */
/* Energy that the momentum residual may add: with near-singular factors increments shrink before the residual does,
   so it is asked for by itself; where round-off ends the iteration it must still be no more than round-off.      */
#define ENERGY_MARGIN 1e-3
#define ENERGY_LIMIT 1e4

/* Energies that unfinished iterations would add: v'R by the momentum balance, Phi'mu by the constraints. Small
   increments alone do not tell that a step is solved: they also become small where mu grows beyond all bounds. */
static double residual_energy(const context *c)
{
    double sum = 0.0;
    const int32_t end = DIM * c->end[ISLAND_FREE];
    for (int32_t k = DIM * c->begin[ISLAND_FREE]; k < end; k++) sum += c->k.d[k] * c->k.momentum[k];
    return fabs(sum / c->h); /* h < 0 in the parts of a composition that go back */
}

static double constraint_energy(const context *c)
{
    double sum = 0.0;
    EACH_ROW(c, i) sum += c->k.phi[i] * c->k.mu[i];
    return fabs(sum);
}

/* Raises the penalty of the step at hand a thousandfold, twice at most. Where the singular configuration lies
   between the midpoint and the end of a step, the gradients there differ in sign along one combination of rows;
   if both are small, the Uzawa factor 1/(1 + chi g_1 g_m/sigma) of that combination has its pole nearby.         */
static int stiffen(context *c, int *stiffened)
{
    if (is_penalty(c) || *stiffened >= 2) return 0;
    *stiffened += 1;
    EACH_ROW(c, i) c->k.epsilon[i] *= 1e-3;
    return 1;
}

/* From this penalty on, an Uzawa update contracts far better than a Newton iteration, and the multipliers of a nested
   iteration need not wait for its end: an inner solve has to be no more exact than the outer one (inexact Uzawa). */
#define EARLY_UPDATE_PENALTY 1e6
/* Defect below which a row needs no update: what is left, epsilon (mu - lambda), has the sign of dmu/dt at every step
   and adds up in the energy (double pendulum, 2e5 steps of 1 ms: 4e-13 J with 6e-17, 1e-14 J with this). */
#define UNBIASED 1e-19
#define GOOD_CONTRACTION 0.05

/* Lean factors leave stiffness out, h^2 |sum mu_i H_i|/4m and h^2 k/4m against 1, which is then their contraction.
   From this one on, or where a step takes more increments than that, full factors cost less; they are used for a
   while, each time for twice as many steps. Not with dependent rows: what these leave undetermined would follow every
   increment, and the energy with it.                                                                          */
#define LEAN_CONTRACTION 3e-3
#define LEAN_INCREMENTS 3

static void choose_factors(context *c)
{
    double *island = c->island;
    const int is_tried = c->m->n_lean_values && is_conserving(c) && !is_penalty(c) && island[I_DEPENDENT] == 0.0 &&
                         hm_skips(SKIP_STIFFNESS);
    c->lu = is_tried && island[I_FULL_STEPS] == 0.0 ? &c->m->lean : &c->m->full;
    if (island[I_FULL_STEPS] > 0.0) island[I_FULL_STEPS] -= 1.0;
}

/* Takes the last increment back: a long one of lean factors, whose stiffness was missing, tells nothing. */
static void take_back(context *c)
{
    for (int32_t k = DIM * c->begin[ISLAND_FREE]; k < DIM * c->end[ISLAND_FREE]; k++) {
        c->k.w[k] -= c->k.rhs[c->lu->node_position[k / DIM] + k % DIM];
        c->k.d[k] = c->k.hv[k] + c->k.w[k];
    }
    EACH_ROW(c, i) c->k.mu[i] -= c->k.rhs[c->lu->row_position[i]];
}

static void pause_lean(double *island)
{
    island[I_FULL_STEPS] = island[I_FULL_WAIT] = fmin(fmax(2.0 * island[I_FULL_WAIT], 64.0), 4096.0);
}

/* Factors of the half step before serve another of the same length, where they are dear and the mechanism moves little:
   as long as they cost no increment more than fresh ones; else they are left alone for a while, each time for twice as
   many half steps. They are scratch of one internal step, and of one island.                                     */
static int take_factors_over(const context *c, newton_record *r)
{
    double *island = c->island;
    if (island[I_FRESH_STEPS] > 0.0) island[I_FRESH_STEPS] -= 1.0;
    if (c->m->n_islands > 1 || c->factors_h != c->h || c->factors_lu != c->lu || island[I_FRESH_STEPS] > 0.0 ||
        !hm_skips(SKIP_FRESH_FACTORS))
        return 0;
    r->factorised = r->taken_over = 1;
    r->theta = 0.9 * GOOD_CONTRACTION;
    return 1;
}

/* Where an increment tells that they are no good, fresh ones are made before lean ones are given up. */
static void drop_factors(newton_record *r)
{
    r->factorised = r->taken_over = 0;
    r->theta = 1.0;
}

/* What a half step tells of the factors that it used, for the next one. */
static void judge_factors(context *c, const newton_record *r, int taken_over)
{
    double *island = c->island;
    if (taken_over && r->increments > c->fresh_increments)
        island[I_FRESH_STEPS] = island[I_FRESH_WAIT] = fmin(fmax(2.0 * island[I_FRESH_WAIT], 64.0), 4096.0);
    if (!taken_over) c->fresh_increments = r->increments;
    c->factors_h = r->factorised && !r->stiffened ? c->h : 0.0;
    c->factors_lu = c->lu;
}

static void give_up_lean(context *c, newton_record *r)
{
    pause_lean(c->island);
    c->lu = &c->m->full;
    r->factorised = 0;
    r->theta = 1.0;
}

/* Whether lambda may follow early, after this Newton iteration. Multipliers that dependent rows share get the rounding
   errors of a solve over epsilon, which the next one with lambda held removes: there the update waits for it, and
   comes once.                                                                                                  */
static int may_update_early(const context *c, int iteration)
{
    const double *head = c->s.head;
    if (!hm_skips(SKIP_OUTER_ITERATION)) return 0;
    if (is_penalty(c) || head[S_SIMULTANEOUS] != 0.0 || head[S_PENALTY] < EARLY_UPDATE_PENALTY) return 0;
    return c->island[I_DEPENDENT] == 0.0 || iteration == 1;
}

/* Uzawa update; the residual of the rows follows. */
static void hold_multipliers(context *c, newton_record *r)
{
    update_multipliers(c);
    r->updates++;
}

/* Whether what is `left` of the increments, the rows' defect and the energy that the residual adds are a margin below
   the tolerance; or below the tolerance, where round-off has `stalled` the contraction.                        */
static int is_solved(const context *c, const newton_record *r, double left, double defect, int stalled)
{
    const double tolerance = c->s.head[S_NEWTON_TOLERANCE], added = residual_energy(c);
    if (left <= NEWTON_MARGIN * r->target && defect <= fmax(CONSTRAINT_MARGIN * tolerance, QUARTER_ULP) &&
        added <= ENERGY_MARGIN * (tolerance * r->energy + r->noise))
        return 1;
    return stalled && defect <= tolerance && added <= ENERGY_LIMIT * tolerance * r->energy + r->noise;
}

/* Newton iteration with lambda held fixed (nested) or following mu (simultaneous; nested, while it contracts well and
   the rows do not hold yet).
   The error left behind is estimated from the observed contraction theta. It ends a margin below the tolerance, or
   where round-off stops the contraction below the tolerance. The factors are kept while they contract well.   */
static int32_t iterate_newton(context *c, newton_record *r)
{
    const int simultaneous = c->s.head[S_SIMULTANEOUS] != 0.0;
    const int max_newton = (int)c->s.head[S_MAX_NEWTON];
    const double tolerance = c->s.head[S_NEWTON_TOLERANCE];
    double previous = 0.0, defect = 0.0;
    for (int iteration = 0; iteration < max_newton; iteration++) {
        int32_t status = HOLONOM_OK;
        const int keep = r->factorised && r->theta < GOOD_CONTRACTION && hm_skips(SKIP_FACTORISATION);
        if (!keep) {
            status = factorise(c);
            if (status) return status;
            r->factorised = 1;
        }
        status = newton_update(c, r);
        if (status) return status;
        /* First increment with new factors: nothing is known but its size against the step's. */
        if (iteration > 0 && previous > 0.0) r->theta = r->eta / previous;
        else if (!keep) r->theta = r->eta < 0.02 * r->size ? 0.04 : 1.0;
        previous = r->eta;
        const int is_slow = is_lean(c) && r->eta > r->floor && r->theta > (iteration > 0 ? LEAN_CONTRACTION : 0.5);
        if (is_slow && iteration == 0) take_back(c);
        if (simultaneous) update_multipliers(c);
        status = evaluate_balance(c);
        if (status) return status;
        const double left = iteration > 0 || (keep && r->increments > 1) ? r->theta * r->eta : r->eta;
        const int stalled = iteration > 1 && r->theta > 0.5 && r->eta <= fmax(r->target, r->floor);
        if (simultaneous && !is_penalty(c)) defect = constraint_defect(c);
        if (is_solved(c, r, left, defect, stalled)) return HOLONOM_OK;
        if (simultaneous && iteration > 1 && r->theta > 0.25 && stiffen(c, &r->stiffened)) {
            update_multipliers(c);
            if ((status = evaluate_balance(c))) return status;
            r->factorised = 0;
            r->theta = 1.0;
        } else if (r->theta < GOOD_CONTRACTION && may_update_early(c, iteration) && (iteration > 0 || constraint_defect(c) > UNBIASED))
            hold_multipliers(c, r);
        if (is_slow && r->taken_over) drop_factors(r);
        else if (is_slow) give_up_lean(c, r);
    }
    if (!(r->eta <= r->target && residual_energy(c) <= ENERGY_LIMIT * tolerance * r->energy + r->noise))
        return HOLONOM_NEWTON_DIVERGED;
    return defect <= tolerance ? HOLONOM_OK : HOLONOM_UZAWA_DIVERGED;
}

#endif
