/* Damped islands that come to rest. */
#ifndef HOLONOM_COME_TO_REST_H
#define HOLONOM_COME_TO_REST_H

#include "composite.h"
#include "context.h"
#include "ledger.h"
#include "rest.h"
#include "step.h"

/* Of an island's weights times the size: speed at which it stands still, and what its velocities may hold besides. */
#define STILL 1e-14
#define LEAST_ENERGY 1e-9

static int is_damped(const context *c)
{
    for IN_ISLAND(c, j, ISLAND_ELEMENT)
        if (c->number[c->m->damping_at + j] != 0.0) return 1;
    return 0;
}

static double kinetic_of_island(const context *c)
{
    double sum = 0.0;
    for IN_ISLAND(c, e, ISLAND_MASS) {
        const int32_t *node = c->m->mass_node + 2 * e;
        sum += 0.5 * c->number[c->m->mass_at + e] * dot(c->s.v + DIM * node[0], c->s.v + DIM * node[1]);
    }
    return sum;
}

/* Mass norm of the displacement over the pair that has just been solved. Velocities across the constraints, which no
   damper sees, turn round in its middle and do not show in it.                                                 */
static double displacement_over_pair(const context *c)
{
    const double *q = c->k.pair_backup + (c->s.q - c->s.head), *q_low = c->k.pair_backup + (c->s.q_low - c->s.head);
    double sum = 0.0;
    for IN_ISLAND(c, a, ISLAND_FREE)
        for (int32_t k = DIM * a; k < DIM * (a + 1); k++) {
            const double moved = (c->s.q[k] - q[k]) + (c->s.q_low[k] - q_low[k]);
            sum += c->number[c->m->node_mass_at + a] * moved * moved;
        }
    return sqrt(sum);
}

static void stop_island(const context *c)
{
    const hm_state *s = &c->s;
    const int64_t n = DIM * c->n_moving, rows = c->m->n_rows;
    EACH_COORDINATE(c, k) {
        s->v[k] = s->v_low[k] = s->imbalance[k] = s->imbalance_before[k] = s->a[0][k] = s->a[1][k] = 0.0;
        for (int slot = 0; slot < c->m->n_slots; slot++) s->a_change[n * slot + k] = 0.0;
    }
    EACH_ROW(c, i) {
        s->mu[0][i] = s->mu[1][i] = c->k.mu[i];
        for (int slot = 0; slot < c->m->n_slots; slot++) s->mu_change[rows * slot + i] = 0.0;
    }
}

/* An island that dampers have brought to a standstill over a pair of length h rests where its forces balance, with the
   mean of its last multipliers. The energy it still had is booked as the dampers'. Measured by its own weight: an
   island without weight may drift for ever.                                                                    */
static void come_to_rest(context *c, double h)
{
    double mass, weight2;
    if (!is_damped(c) || !may_rest(c)) return;
    weigh_island(c, &mass, &weight2);
    const double energy = sqrt(mass * weight2) * c->number[c->m->extent_at];
    if (!(displacement_over_pair(c) <= STILL * h * sqrt(2.0 * energy))) return;
    const double kinetic = kinetic_of_island(c);
    if (kinetic == 0.0 || !(kinetic <= LEAST_ENERGY * energy)) return;
    links_at_start(c);
    rows_at_start(c);
    EACH_COORDINATE(c, k) c->k.hv[k] = c->k.w[k] = c->k.d[k] = 0.0;
    EACH_ROW(c, i) c->k.lambda[i] = c->k.mu[i] = 0.5 * (c->s.mu[0][i] + c->s.mu[1][i]);
    const int rests = is_balanced(c);
    EACH_ROW(c, i) c->k.mu[i] = c->k.lambda[i];
    if (!rests) return;
    stop_island(c);
    book(c, S_DISSIPATED, kinetic);
}

/* After a pair of length h. */
static void let_islands_rest(context *c, double h)
{
    const int32_t parts = n_apart(c);
    for (int32_t part = 0; part < parts; part++) {
        look_at_part(c, part, parts);
        if (!is_asleep(c)) come_to_rest(c, h);
    }
    look_at_all(c);
}

#endif
