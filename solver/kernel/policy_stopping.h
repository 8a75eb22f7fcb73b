/* Decides when the iterations of a step have converged. */
#ifndef HOLONOM_POLICY_STOPPING_H
#define HOLONOM_POLICY_STOPPING_H

#include "context.h"
#include "forms.h"
#include "newton_record.h"

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

/* Whether what is `left` of the increments, the rows' defect and the energy that the residual adds are a margin below
   the tolerance; or below the tolerance, where round-off has `stalled` the contraction.                        */
static int has_converged(const context *c, const newton_record *r, double left, double defect, int stalled)
{
    const double tolerance = c->s.head[S_NEWTON_TOLERANCE], added = residual_energy(c);
    if (left <= NEWTON_MARGIN * r->target && defect <= fmax(CONSTRAINT_MARGIN * tolerance, QUARTER_ULP) &&
        added <= ENERGY_MARGIN * (tolerance * r->energy + r->noise))
        return 1;
    return stalled && defect <= tolerance && added <= ENERGY_LIMIT * tolerance * r->energy + r->noise;
}

#endif
