/* Islands at rest: no work as long as nothing touches them. Included once per dimension, after newton.inc.h.

   A state without velocities in which forces and multipliers balance is a fixed point of the step, whatever its length:
   w = 0 and the last multipliers solve it. That is seen without an iteration, and once the island has stood still for
   so many half steps that all it remembers of earlier ones is zero, without a look. Inputs and parameters that
   change wake all islands. Laws that follow time or the motion may touch any: where there are some, none sleeps.      */

static int is_asleep(const context *c) { return c->island[I_RESTING] > c->m->n_slots + 2; }

static void wake(const context *c)
{
    for (int32_t island = 0; island < c->m->n_islands; island++) c->s.islands[I_SIZE * island + I_RESTING] = 0.0;
}

/* Whether a row holds to the round-off of the coordinates that it is made of, |G| eps x. */
static int is_closed(const context *c, int32_t i)
{
    const double *number = c->number + c->m->extent_at;
    return fabs(c->k.phi[i]) <= 4.0 * 2.2e-16 * number[1] * sqrt(c->number[c->m->row_sigma_at + i]);
}

/* Whether forces and multipliers (k.mu) balance to the tolerance where the island stands: d = w = 0, links and rows are
   those of the state. Residuals, over h in the norm sum R^2/m, are measured against weights and the reference energy. */
static int is_balanced(context *c)
{
    const double *node_mass = c->number + c->m->node_mass_at, *weight = c->number + c->m->node_weight_at;
    const double *gravity = c->number + c->m->gravity_at, tolerance = c->s.head[S_NEWTON_TOLERANCE];
    double residual2 = 0.0, weight2 = 0.0;
    if (evaluate_residual(c)) return 0;
    EACH_ROW(c, i) if (!is_closed(c, i)) return 0;
    for IN_ISLAND(c, a, ISLAND_FREE) {
        const double *r = c->k.momentum + DIM * a;
        residual2 += dot(r, r) / node_mass[a];
        weight2 += weight[a] * weight[a] / node_mass[a];
    }
    const double by_energy = c->s.head[S_ENERGY_REFERENCE] / c->number[c->m->extent_at + 1];
    const double forces2 = weight2 * dot(gravity, gravity) + by_energy * by_energy;
    return residual2 <= tolerance * tolerance * c->h * c->h * forces2;
}

/* Whether nothing but a touch could set islands in motion. */
static int may_rest(const context *c)
{
    return !c->m->time_dependent && !c->m->sensing && is_conserving(c) && !is_penalty(c) && hm_skips(SKIP_REST);
}

static int stands_still(const context *c)
{
    if (!may_rest(c)) return 0;
    EACH_COORDINATE(c, k) if (c->k.hv[k] != 0.0 || c->k.w[k] != 0.0) return 0;
    return 1;
}

/* Whether a step of an island that stands still leaves it so; then w = 0 and the multipliers are the last ones. */
static int stays_at_rest(context *c, int parity)
{
    EACH_ROW(c, i) c->k.mu[i] = c->s.mu[parity][i];
    const int rests = is_balanced(c);
    EACH_ROW(c, i) c->k.mu[i] = c->s.mu[parity][i];
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
