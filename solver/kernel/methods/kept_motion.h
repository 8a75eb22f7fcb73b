/* What each island keeps over a step: its ledger, and momenta that nothing changes. */
#ifndef HOLONOM_KEPT_MOTION_H
#define HOLONOM_KEPT_MOTION_H

#include "energy.h"
#include "rigid.h"

#define LEDGER_ROUND_OFF 1e-15 /* of its balance, over the sum of its summands */
#define MOMENTUM_ROUND_OFF 1e-12 /* relative change of a momentum */

/* What an island keeps over a step. */
typedef struct kept_motion {
    int flies; /* 1: nothing but weights joins it to the ground; its angular momenta are about its
                  centre of mass, else the origin */
    int kept[RIGID];
    double before[RIGID],
        scale[RIGID]; /* momenta that it is to have, and sums of their terms' sizes */
    double impulse[RIGID];              /* of its weights over the step */
    double kinetic, potential;          /* energies at the start of the step */
    double lacking;                     /* energy that its ledger lacked there */
    double work, dissipated;            /* in the step */
    double correction, growth;          /* as in a step_result */
    double centre[DIM];                 /* which angular momenta are about */
} kept_motion;

enum { KEPT_SIZE = 4 * RIGID + DIM + 6 }; /* doubles of scratch for an island, as in scratch.py */
_Static_assert(sizeof(kept_motion) <= sizeof(double) * KEPT_SIZE, "scratch of an island");

/* What the islands at hand, one, keep. */
static kept_motion *kept_of(const context *c)
{
    return (kept_motion *)(void *)(c->k.kept + KEPT_SIZE * (int64_t)c->view.first);
}

static int touches_ground(const context *c, int32_t f)
{ return c->m->form_free[f] < c->m->form_ptr[f + 1] - c->m->form_ptr[f]; }

/* Whether no row, spring, function or potential joins the island at hand to the ground or to a
   driven point. */
HM_SELDOM static int may_fly(const context *c)
{
    const holonom_model *m = c->m;
    if (c->view.begin[ISLAND_DRIVEN] < c->view.end[ISLAND_DRIVEN]) return 0;
    EACH_FORM_ROW(c, i) if (touches_ground(c, m->row_form[i])) return 0;
    for IN_ISLAND(c, j, ISLAND_COINCIDENCE) if (touches_ground(c, m->coincidence_form[j])) return 0;
    EACH_COMPOSITE(c, j)
        for (int32_t i = m->composite_form_ptr[j]; i < m->composite_form_ptr[j + 1]; i++)
            if (touches_ground(c, m->composite_form[i])) return 0;
    return 1;
}

/* Whether loads or moments act on the islands at hand. */
static int is_loaded(const context *c)
{
    static const int LOADS[] = {ISLAND_LOAD, ISLAND_MOMENT, ISLAND_BODY_MOMENT};
    int loaded = 0;
    for (int k = 0; k < 3; k++) loaded |= c->view.begin[LOADS[k]] < c->view.end[LOADS[k]];
    return loaded;
}

/* Angular momenta are about this point: the centre of mass of what flies. That of a point alone is
   the point itself, to the last bit: an arm of round-off would have an angular momentum to keep. */
HM_SELDOM static void find_centre(const context *c, kept_motion *x)
{
    const holonom_model *m = c->m;
    const int is_alone = c->view.end[ISLAND_MASS] - c->view.begin[ISLAND_MASS] == 1;
    double sum[DIM] = {0.0}, mass = 0.0;
    EACH(k) x->centre[k] = 0.0;
    if (!x->flies) return;
    for IN_ISLAND(c, e, ISLAND_MASS) {
        const int32_t a = m->mass_node[2 * e], b = m->mass_node[2 * e + 1];
        if (m->node_kind[a]) continue;
        const double own = is_alone ? 1.0 : c->number[m->mass_at + e];
        if (!m->node_kind[b]) mass += own;
        EACH(k) sum[k] += own * c->s.q[DIM * b + k];
    }
    if (mass > 0.0) EACH(k) x->centre[k] = sum[k] / mass;
}

/* Momenta of the island at hand, of the kept ones: the others are left out. */
static void momenta_now(const context *c, kept_motion *x, double *total, double *size)
{
    momenta(c, c->k.momentum);
    find_centre(c, x);
    rigid_momenta(c, x->centre, x->kept, c->k.momentum, total, size);
}

/* Potential energy of the island at hand, of the only one as its change since the start of the
   run. */
static double potential_of_island(const context *c)
{
    return potential_since(c, c->m->n_islands == 1 ? c->s.head[S_STORED_START] : 0.0);
}

/* What dampers (S_DISSIPATED), or frictions (S_FRICTION), of the island at hand have taken in the
   step. */
HM_SELDOM static double lost_of(const context *c, int account)
{
    double sum = 0.0;
    if (account == S_DISSIPATED) EACH_ELEMENT(c, j) sum += c->k.loss[j];
    else for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY; k++)
        for IN_ISLAND(c, j, k) sum += c->k.loss[j];
    return sum;
}

/* Takes down what the islands have at the start of a step of length h: of their momenta all may be
   kept, of driven islands none. */
HM_SELDOM static void keep_motion(context *c, double h)
{
    const holonom_model *m = c->m;
    memset(c->k.loss, 0, sizeof(double) * (size_t)n_composites(c));
    EACH_ISLAND(c, island) {
        kept_motion *x = kept_of(c);
        memset(x, 0, sizeof *x);
        x->flies = may_fly(c);
        for (int i = 0; i < RIGID; i++)
            x->kept[i] = c->view.begin[ISLAND_DRIVEN] == c->view.end[ISLAND_DRIVEN];
        x->potential = potential_of_island(c);
        x->kinetic = kinetic_energy(c, c->k.momentum); /* leaves M v in momentum */
        x->lacking = c->m->n_islands == 1 ? ledger_balance(c, x->kinetic, x->potential)
                                          : c->view.scalars[I_UNBALANCED];
        find_centre(c, x);
        rigid_momenta(c, x->centre, x->kept, c->k.momentum, x->before, x->scale);
        for (int32_t a = c->view.begin[ISLAND_FREE]; a < c->view.end[ISLAND_FREE] && x->flies; a++)
            EACH(k)
                x->impulse[k] +=
                    h * c->number[m->node_weight_at + a] * c->number[m->gravity_at + k];
        EACH(k) x->before[k] += x->impulse[k];
    }
}

/* Lets no momentum count as kept. */
static void forget_momenta(context *c)
{
    EACH_ISLAND(c, island) {
        memset(kept_of(c)->kept, 0, sizeof(kept_of(c)->kept));
    }
}

/* Energy that the ledger of the island at hand does not know of, with this potential energy. That
   of an only island is the ledger of the run. */
static double unbalanced(const context *c, const kept_motion *x, double potential)
{
    const double kinetic = kinetic_energy(c, c->k.momentum); /* leaves M v in momentum */
    if (c->m->n_islands == 1) return ledger_balance(c, kinetic, potential);
    return x->lacking + ((kinetic - x->kinetic) + (potential - x->potential))
           - (x->work - x->dissipated);
}

/* Forgets those momenta of the islands that velocities have changed. */
HM_SELDOM static void forget_changed(context *c)
{
    EACH_ISLAND(c, island) {
        double after[RIGID], scale[RIGID];
        kept_motion *x = kept_of(c);
        momenta_now(c, x, after, scale);
        for (int i = 0; i < RIGID; i++)
            x->kept[i] &=
                fabs(after[i] - x->before[i]) <= MOMENTUM_ROUND_OFF * fmax(scale[i], x->scale[i]);
    }
}

/* Adds the energies that the islands have gained so far, `weight` times, to those that they are to
   gain. */
HM_SELDOM static void weigh_energies(context *c, double weight)
{
    EACH_ISLAND(c, island) {
        kept_motion *x = kept_of(c);
        x->work += weight
                   * ((kinetic_energy(c, c->k.momentum) - x->kinetic)
                      + (potential_of_island(c) - x->potential));
    }
}

/* Lets the islands gain `total` together, as the ledger says. The one with most energy makes up for
   the round-off of differences of energies, which may be more than another one has that comes to
   rest. */
HM_SELDOM static void gain_together(context *c, double total)
{
    double most = -1.0;
    kept_motion *strongest = NULL;
    EACH_ISLAND(c, island) {
        kept_motion *x = kept_of(c);
        const double energy = x->kinetic + fabs(x->potential) + fabs(x->work);
        total -= x->work;
        if (energy > most) most = energy, strongest = x;
    }
    strongest->work += total;
}

/* What putting the islands back has done to the step. */
HM_SELDOM static void tell_corrections(context *c, step_result *result)
{
    EACH_ISLAND(c, island) {
        result->energy_correction = fmax(result->energy_correction, kept_of(c)->correction);
        result->growth = fmax(result->growth, kept_of(c)->growth);
    }
}

#define EACH_FREE(c, k)                                                                            \
    for (int32_t k = DIM * (c)->view.begin[ISLAND_FREE],                                           \
                 k##_end = DIM * (c)->view.end[ISLAND_FREE];                                       \
         k < k##_end; k++)

/* Adds so much of u (n) to the velocities at hand. */
static void add_to_velocities(context *c, double part, const double *u)
{
    EACH_FREE(c, k) hm_add(c->s.v + k, c->s.v_low + k, part * u[k]);
}

/* Sizes of what the energy of the island at hand is summed of: weights, loads, springs and
   potentials act on places that are known to round-off of the mechanism's size, however little it
   has moved. */
HM_SELDOM static double sizes_of_summands(const context *c, const kept_motion *x)
{
    const holonom_model *m = c->m;
    const double *gravity = c->number + m->gravity_at, extent = c->number[m->extent_at];
    double sum = kinetic_energy(c, c->k.ahead) + x->kinetic + fabs(x->work) + fabs(x->dissipated),
           weight = 0.0;
    sum += LEDGER_ROUND_OFF
           * c->s.head[S_ENERGY_REFERENCE]; /* of velocities below round-off of the fastest */
    static const int ACCOUNTS[] = {S_WORK, S_DISSIPATED, S_FRICTION,
                                   S_IMPACT}; /* of the run, whose ledger an only island has */
    for (int i = 0; i < 4 && m->n_islands == 1; i++) sum += fabs(c->s.head[ACCOUNTS[i]]);
    EACH_NODE(c, a) weight += c->number[m->node_weight_at + a];
    sum += weight * sqrt(dot(gravity, gravity)) * extent;
    for
        IN_ISLAND(c, j, ISLAND_LOAD)
        EACH(k) sum += fabs(c->number[m->load_at + DIM * j + k]) * extent;
    for IN_ISLAND(c, j, ISLAND_MOMENT)
        for (int k = 0; k < TURNING; k++) sum += fabs(c->number[m->moment_at + TURNING * j + k]);
    for IN_ISLAND(c, j, ISLAND_BODY_MOMENT)
    for (int k = 0; k < TURNING; k++) sum += fabs(c->number[m->body_moment_at + TURNING * j + k]);
    if (m->n_potentials) quantities_at_state(c);
    EACH_ELEMENT(c, j) kind_of(c, j)->add_sizes(c, j, &sum);
    return sum;
}

/* Whether round-off explains an energy that the island at hand lacks, or what it lacks more than at
   the start of the step: what larger energies have left before does not keep an island from coming
   to rest, nor has what stands velocities but those of round-off of places over a step. */
HM_SELDOM static int is_round_off(const context *c, const kept_motion *x, double excess)
{
    const double standing = 0.5 * hm_square(round_off_of_places(c) / c->h);
    return fmin(fabs(excess), fabs(excess - x->lacking))
           <= LEDGER_ROUND_OFF * sizes_of_summands(c, x) + standing;
}

/* Brings momenta of the island at hand back that are kept, by a motion as one rigid body: L is its
   mass matrix (factor_rigid). */
HM_SELDOM static void put_momenta_back(context *c, kept_motion *x, double L[RIGID][RIGID])
{
    double lacking[RIGID], size[RIGID];
    momenta_now(c, x, lacking, size);
    factor_rigid(c, x->centre, x->kept, L);
    for (int i = 0; i < RIGID; i++) lacking[i] = x->before[i] - lacking[i];
    clear_nodes(c, c->k.w);
    add_rigid(c, x->centre, L, lacking, c->k.w);
    add_to_velocities(c, 1.0, c->k.w);
}

#endif
