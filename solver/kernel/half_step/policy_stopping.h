/* Decides when the iterations of a step have converged. */
#ifndef HOLONOM_POLICY_STOPPING_H
#define HOLONOM_POLICY_STOPPING_H

#include "learned_contraction.h"
#include "norms.h"

/* A step's error must lie far below the tolerance: what is left in momentum or constraints has one
   sign over many steps and adds up in the energy (measured: double pendulum, h = 1e-3, 2e5 steps,
   |dE| 4.8e-11 J with margins of 1e-4 and 1e-3, 4e-14 J with these). The factors are kept, so that
   the last digits cost little. */
#define NEWTON_MARGIN 1e-6
/* Old factors leave more in light directions (Bricard's spins about its rods, 1 ms: 3e-16 of the
   energy in each step). */
#define OLD_MARGIN 1e-7
#define CONSTRAINT_MARGIN 1e-5
#define QUARTER_ULP 5.6e-17 /* of 1: places tell no row better; the increments of a step do */
/* Energy that the momentum residual may add: with near-singular factors increments shrink before
   the residual does, so it is asked for by itself; where round-off ends the iteration it must still
   be no more than round-off. */
#define ENERGY_MARGIN 1e-3
#define ENERGY_LIMIT 1e4

/* Whether a step must close its ledger to count; always so, but for tests of what happens
   without. */
#ifndef HOLONOM_ENERGY_DECIDES
#define HOLONOM_ENERGY_DECIDES 1
#endif

/* Energies that unfinished iterations would add: v'R by the momentum balance, Phi'mu by the
   constraints. Small increments alone do not tell that a step is solved: they also become small
   where mu grows beyond all bounds. */
static double residual_energy(const context *c)
{
    double sum = 0.0;
    if (!HOLONOM_ENERGY_DECIDES) return 0.0;
    const int32_t end = DIM * c->view.end[ISLAND_FREE];
    for (int32_t k = DIM * c->view.begin[ISLAND_FREE]; k < end; k++)
        sum += move_of(c)[k] * c->k.momentum[k];
    return fabs(sum / c->h); /* h < 0 in the parts of a composition that go back */
}

static double constraint_energy(const context *c)
{
    double sum = 0.0;
    if (!HOLONOM_ENERGY_DECIDES) return 0.0;
    EACH_ROW(c, i) sum += c->k.phi[i] * c->k.mu[i];
    return fabs(sum);
}

/* Largest |Phi_1|/l^2. */
static double constraint_defect(const context *c) { return largest_row(c, c->k.phi); }

/* Largest increments that are still to come: by the contraction that this step shows, or, of first
   increments and where round-off hides it, by that which earlier steps tell. */
static inline double increments_left(const context *c, const newton_record *r)
{
    const int told = r->iteration > 0 || (r->factors.kept && r->increments > 1);
    const double shown = told ? r->contraction_above_round_off : 1.0;
    const int is_sure = told && r->eta > ROUND_OFF_SHOWS(c) * r->size;
    return (is_sure ? shown : fmin(shown, r->predicted_contraction)) * r->eta;
}

/* What rows may be off by after one increment, of l^2: they were not updated, and a half step that
   leaves 4e-17 just before a singular configuration, where multipliers are 2000 times as large,
   costs 2e-13 of the energy (four-bar). */
#define ROWS_AFTER_ONE 4e-18

static inline double allowed_defect(const context *c, const newton_record *r)
{
    return r->increments > 1 ? fmax(CONSTRAINT_MARGIN * c->s.head[S_NEWTON_TOLERANCE], QUARTER_ULP)
                             : ROWS_AFTER_ONE;
}

/* Energy that what is left may add. */
static inline double allowed_energy(const context *c, const newton_record *r)
{
    return ENERGY_MARGIN * (c->s.head[S_NEWTON_TOLERANCE] * r->energy + r->noise);
}

/* Energy that may be left where round-off ends an iteration. Pieces between events are as many as
   they are short: each may leave its part of what a usual step may. */
static inline double most_left(const context *c, const newton_record *r)
{
    const double part = is_unilateral(c->m) ? fmin(1.0, 2.0 * fabs(c->h) / usual_length(c)) : 1.0;
    return part * ENERGY_LIMIT * c->s.head[S_NEWTON_TOLERANCE] * r->energy + r->noise;
}

/* Whether what is left of the increments and the energy that the residual adds are a margin below
   the tolerance; or below the tolerance, where round-off has stalled the contraction. Of the rows
   rows_hold asks. */
static int has_converged(const context *c, const newton_record *r)
{
    const double margin = r->factors.taken_over ? OLD_MARGIN : NEWTON_MARGIN;
    const int stalled = r->iteration > 1 && !r->updated_multipliers && r->contraction > 0.5
                        && r->eta <= fmax(r->target, r->floor);
    const int is_short = increments_left(c, r) <= margin * r->target && !is_misled(r);
    if (!is_short && !stalled) return 0;
    const double added = residual_energy(c);
    if (is_short && added <= allowed_energy(c, r)) return 1;
    return stalled && added <= most_left(c, r);
}

/* Status of an iteration that has taken as many increments as it may. */
static int32_t outcome_at_limit(const context *c, const newton_record *r)
{
    const int holds = r->eta <= r->target && residual_energy(c) <= most_left(c, r);
    return holds ? HOLONOM_OK : HOLONOM_NEWTON_DIVERGED;
}

/* Whether the rows hold as far as is asked, and their energy is no more than so many times what it
   may be. */
static inline int rows_within(const context *c, const newton_record *r, double defect, double times)
{
    return defect <= allowed_defect(c, r) && constraint_energy(c) <= times * allowed_energy(c, r);
}

/* Whether the rows hold a margin below the tolerance, and their energy does, which is large where
   multipliers are. Near a singular configuration one combination of rows contracts slowly, or not
   at all; it need not go on where its energy is that margin below round-off. */
static int rows_hold(const context *c, const newton_record *r, double defect, double last)
{
    const double tolerance = c->s.head[S_NEWTON_TOLERANCE];
    if (rows_within(c, r, defect, 1.0)) return 1;
    return defect > 0.5 * last && defect <= tolerance
           && constraint_energy(c) <= CONSTRAINT_MARGIN * tolerance * r->energy;
}

/* Whether the rows hold as far as places tell, and their energy is nearly what it may be. No
   penalty makes that better where steps are long and multipliers large (Bricard at a tolerance of
   1e-6: half steps of 6 increments went on to 14). */
#define NEARLY 30.0

static int rows_are_round_off(const context *c, const newton_record *r, double defect)
{ return rows_within(c, r, defect, NEARLY); }

/* Whether the contraction of the rows has ended, and what is left is round-off. */
static int is_stalled_round_off(const context *c, const newton_record *r, double defect,
                                double last)
{
    return defect > 0.9 * last && defect <= c->s.head[S_NEWTON_TOLERANCE]
           && constraint_energy(c) <= most_left(c, r);
}

/* Status after as many updates of the multipliers as may be. */
static int32_t outcome_of_updates(const context *c, const newton_record *r, double defect)
{
    const double tolerance = c->s.head[S_NEWTON_TOLERANCE];
    const int holds =
        defect <= tolerance && constraint_energy(c) <= tolerance * r->energy + r->noise;
    return holds ? HOLONOM_OK : HOLONOM_UZAWA_DIVERGED;
}

#endif
