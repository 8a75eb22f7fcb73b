/* Islands at rest: no work as long as nothing touches them (theory 4.8).

   A state without velocities in which forces and multipliers balance is a fixed point of the step, whatever its length:
   w = 0 and the last multipliers solve it. That is seen without an iteration, and once the island has stood still for
   so many half steps that all it remembers of earlier ones is zero, without a look. Inputs and parameters that
   change wake all islands. Laws that follow time or the motion may touch any: where there are some, none sleeps; nor does
   one with a node or row that follows a signal. */
#ifndef HOLONOM_REST_H
#define HOLONOM_REST_H

#include "context.h"
#include "forms.h"
#include "tangent.h"

static int is_asleep(const context *c) { return c->island[I_RESTING] > c->m->n_slots + 2; }

static void wake(const context *c)
{
    for (int32_t island = 0; island < c->m->n_islands; island++) c->s.islands[I_SIZE * island + I_RESTING] = 0.0;
}

#define ROUND_OFF (256.0 * 2.2e-16) /* of sums of forces along an island, over its weights and rows' forces */

/* What an island's balance is measured by: mass [kg], and weights in the norm sum R^2/m, squared. */
static void weigh_island(const context *c, double *mass, double *weight2)
{
    const double *node_mass = c->number + c->m->node_mass_at, *weight = c->number + c->m->node_weight_at;
    const double *gravity = c->number + c->m->gravity_at;
    *mass = *weight2 = 0.0;
    for IN_ISLAND(c, a, ISLAND_FREE) {
        *mass += node_mass[a];
        *weight2 += weight[a] * weight[a] / node_mass[a];
    }
    *weight2 *= dot(gravity, gravity);
}

static double momentum_norm2(const context *c)
{
    double sum = 0.0;
    for IN_ISLAND(c, a, ISLAND_FREE)
        sum += dot(c->k.momentum + DIM * a, c->k.momentum + DIM * a) / c->number[c->m->node_mass_at + a];
    return sum;
}

/* Whether forces and multipliers (k.mu) balance to round-off where the island stands: d = w = 0, links and rows are those
   of the state. Measured by the island alone: its weights and the forces of its rows; rows hold to the round-off of the
   coordinates that they are made of, |G| eps x.                                                                */
static int is_balanced(context *c)
{
    const int constraints_only = c->constraints_only;
    double mass, weight2;
    weigh_island(c, &mass, &weight2);
    c->constraints_only = 1;
    const int32_t failed = evaluate_residual(c);
    const double rows2 = momentum_norm2(c), closed = 4.0 * 2.2e-16 * sqrt(mass) * c->number[c->m->extent_at];
    c->constraints_only = constraints_only;
    if (failed || evaluate_residual(c)) return 0;
    EACH_ROW(c, i) if (!(fabs(c->k.phi[i]) <= closed * sqrt(c->number[c->m->row_sigma_at + i]))) return 0;
    return momentum_norm2(c) <= ROUND_OFF * ROUND_OFF * (c->h * c->h * weight2 + rows2);
}

/* Whether composite j follows a signal. */
static int has_signal(const context *c, int32_t j)
{
    for (int32_t l = c->m->leaf_ptr[j]; l < c->m->leaf_ptr[j + 1]; l++)
        if (c->m->leaf[4 * l] == LEAF_SIGNAL) return 1;
    return 0;
}

/* Whether the island at hand has a node or row that follows a signal. */
static int follows_signal(const context *c)
{
    const holonom_model *m = c->m;
    if (!m->n_signals) return 0;
    if (c->begin[ISLAND_DRIVEN] < c->end[ISLAND_DRIVEN]) return 1;
    EACH_COMPOSITE(c, j) if (has_signal(c, j)) return 1;
    return 0;
}

/* Whether nothing but a touch could set the island in motion. */
static int may_rest(const context *c)
{
    if (c->m->time_dependent || c->m->sensing || !is_conserving(c) || is_penalty(c) || !hm_skips(SKIP_REST)) return 0;
    return !follows_signal(c);
}

static int stands_still(const context *c)
{
    EACH_COORDINATE(c, k) if (c->k.hv[k] != 0.0 || c->k.w[k] != 0.0) return 0;
    return may_rest(c);
}

/* Whether a step of an island that stands still leaves it so; then w = 0 and the multipliers are the last ones. */
static int stays_at_rest(context *c, int parity)
{
    EACH_ROW(c, i) c->k.mu[i] = c->s.mu[parity][i];
    const int rests = is_balanced(c);
    EACH_ROW(c, i) c->k.mu[i] = c->s.mu[parity][i];
    EACH_COORDINATE(c, k) c->k.momentum[k] = c->k.handed_on[k] = 0.0;
    c->island[I_RESTING] = rests ? c->island[I_RESTING] + 1.0 : 0.0;
    return rests;
}

/* At the start an island without velocities whose forces balance is at rest: its accelerations are round-off. */
static void find_rest(context *c)
{
    const holonom_model *m = c->m;
    c->h = 1.0;
    for (int32_t island = 0; island < m->n_islands; island++) {
        look_at(c, island, island + 1);
        EACH_COORDINATE(c, k) {
            c->k.hv[k] = c->s.v[k];
            c->k.w[k] = c->k.d[k] = 0.0;
        }
        if (stands_still(c) && stays_at_rest(c, 0)) EACH_COORDINATE(c, k) c->s.a[0][k] = c->s.a[1][k] = 0.0;
        c->island[I_RESTING] = 0.0;
    }
    look_at(c, 0, m->n_islands);
}

#endif
