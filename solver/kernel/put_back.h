/* Puts a state that is right up to the order of its step back onto rows, rates of rows, momenta that are kept, and the energy
   that the ledger asks for. */
#ifndef HOLONOM_PUT_BACK_H
#define HOLONOM_PUT_BACK_H

#include "body_turns.h"
#include "context.h"
#include "energy.h"
#include "inputs_signals.h"
#include "ledger.h"
#include "newton.h"
#include "norms.h"
#include "rigid.h"
#include "start.h"
#include "tangent.h"

enum { MAX_CORRECTIONS = 8 };
#define LARGEST_SCALING 0.1 /* part by which velocities are changed for the energy; rad by which what flies is turned for it */
#define ENERGY_ROUND_OFF 1e-12 /* of what brings the energy back, over the speed */
#define LEDGER_ROUND_OFF 1e-15 /* of its balance, over the sum of its summands */
#define MOMENTUM_ROUND_OFF 1e-12 /* relative change of a momentum */
#define LEAST_FREE 1e-8     /* part of the kinetic energy that velocities must have which momenta and rows leave free */

/* What an island keeps over a step. */
typedef struct kept_motion {
    int flies; /* 1: nothing but weights joins it to the ground; its angular momenta are about its centre of mass, else the origin */
    int kept[RIGID];
    double before[RIGID], scale[RIGID]; /* momenta that it is to have, and sums of their terms' sizes */
    double impulse[RIGID];              /* of its weights over the step */
    double kinetic, potential;          /* energies at the start of the step */
    double lacking;                     /* energy that its ledger lacked there */
    double work, dissipated;            /* in the step */
    double centre[DIM];                 /* which angular momenta are about */
} kept_motion;

_Static_assert(sizeof(kept_motion) <= sizeof(double) * (4 * RIGID + DIM + 6), "scratch of an island");

/* What the islands at hand, one, keep. */
static kept_motion *kept_of(const context *c)
{
    return (kept_motion *)(void *)(c->k.kept + (4 * RIGID + DIM + 6) * (int64_t)c->first_island);
}

/* Lets island i be at hand in both contexts; all of them if i is their number. */
static void look_at_island(context *c, context *at, int32_t i)
{
    const int32_t all = i == c->m->n_islands;
    look_at(c, all ? 0 : i, all ? i : i + 1);
    look_at(at, all ? 0 : i, all ? i : i + 1);
}

static int touches_ground(const context *c, int32_t f) { return c->m->form_free[f] < c->m->form_ptr[f + 1] - c->m->form_ptr[f]; }

/* Whether no row, spring, function or potential joins the island at hand to the ground or to a driven point. */
HM_SELDOM static int may_fly(const context *c)
{
    const holonom_model *m = c->m;
    if (c->begin[ISLAND_DRIVEN] < c->end[ISLAND_DRIVEN]) return 0;
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
    for (int k = 0; k < 3; k++) loaded |= c->begin[LOADS[k]] < c->end[LOADS[k]];
    return loaded;
}

/* Angular momenta are about this point: the centre of mass of what flies. */
HM_SELDOM static void find_centre(const context *c, kept_motion *x)
{
    const holonom_model *m = c->m;
    double sum[DIM] = {0.0}, mass = 0.0;
    EACH(k) x->centre[k] = 0.0;
    if (!x->flies) return;
    for IN_ISLAND(c, e, ISLAND_MASS) {
        const int32_t a = m->mass_node[2 * e], b = m->mass_node[2 * e + 1];
        if (m->node_kind[a]) continue;
        if (!m->node_kind[b]) mass += c->number[m->mass_at + e];
        EACH(k) sum[k] += c->number[m->mass_at + e] * c->s.q[DIM * b + k];
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

/* What dampers (S_DISSIPATED), or frictions (S_FRICTION), of the island at hand have taken in the step. */
HM_SELDOM static double lost_of(const context *c, int account)
{
    static const int PARTS[2][2] = {{ISLAND_ELEMENT, ISLAND_POTENTIAL}, {ISLAND_FUNCTION, ISLAND_VELOCITY}};
    double sum = 0.0;
    for (int k = 0; k < 2; k++)
        for IN_ISLAND(c, j, PARTS[account == S_FRICTION][k]) sum += c->k.loss[j];
    return sum;
}

/* Potential energy of the island at hand, of the only one as its change since the start of the run. */
static double potential_of_island(const context *c)
{
    return potential_since(c, c->m->n_islands == 1 ? c->s.head[S_STORED_START] : 0.0);
}

/* Takes down what the islands have at the start of a step of length h, which has lost nothing yet: of their momenta all may be kept, of driven islands none. */
HM_SELDOM static void keep_motion(context *c, double h)
{
    const holonom_model *m = c->m;
    memset(c->k.loss, 0, sizeof(double) * (size_t)n_composites(c));
    for (int32_t island = 0; island < m->n_islands; island++) {
        look_at(c, island, island + 1);
        kept_motion *x = kept_of(c);
        memset(x, 0, sizeof *x);
        x->flies = may_fly(c);
        for (int i = 0; i < RIGID; i++) x->kept[i] = c->begin[ISLAND_DRIVEN] == c->end[ISLAND_DRIVEN];
        x->kinetic = kinetic_energy(c, c->k.momentum);
        x->potential = potential_of_island(c);
        x->lacking = c->m->n_islands == 1 ? ledger_balance(c, x->kinetic, x->potential) : c->island[I_UNBALANCED];
        momenta_now(c, x, x->before, x->scale);
        for (int32_t a = c->begin[ISLAND_FREE]; a < c->end[ISLAND_FREE] && x->flies; a++)
            EACH(k) x->impulse[k] += h * c->number[m->node_weight_at + a] * c->number[m->gravity_at + k];
        EACH(k) x->before[k] += x->impulse[k];
    }
    look_at(c, 0, m->n_islands);
}

/* Lets no momentum count as kept. */
static void forget_momenta(context *c)
{
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        look_at(c, island, island + 1);
        memset(kept_of(c)->kept, 0, sizeof(kept_of(c)->kept));
    }
    look_at(c, 0, c->m->n_islands);
}

/* Energy that the ledger of the island at hand does not know of, with this potential energy. That of an only island is the ledger of
   the run. */
static double unbalanced(const context *c, const kept_motion *x, double potential)
{
    const double kinetic = kinetic_energy(c, c->k.momentum); /* leaves M v in momentum */
    if (c->m->n_islands == 1) return ledger_balance(c, kinetic, potential);
    return x->lacking + ((kinetic - x->kinetic) + (potential - x->potential)) - (x->work - x->dissipated);
}

#define EACH_FREE(c, k) for (int32_t k = DIM * (c)->begin[ISLAND_FREE], k##_end = DIM * (c)->end[ISLAND_FREE]; k < k##_end; k++)

/* Adds so much of u (n) to the velocities at hand. */
static void add_to_velocities(const context *c, double part, const double *u)
{
    EACH_FREE(c, k) hm_add(c->s.v + k, c->s.v_low + k, part * u[k]);
}

/* Changes of velocities that make up for the rates g in `phi`, as small as can be, or of coordinates for rows; added to x. */
static void add_correction(const context *at, double *x)
{
    clear_nodes(at, at->k.momentum);
    gather_momentum(at);
    EACH_ROW(at, i) at->k.rhs[at->lu->row_position[i]] = -at->k.phi[i];
    solve_factors(at);
    add_solution(at, x);
}

/* Lets equations at the state have turns of bodies for unknowns, and factors without stiffness where there are any. */
static void take_unknowns(context *at)
{
    take_turns(at, at->m->n_reduced_values > 0);
    at->rows_known = 0;
    if (at->m->n_lean_values && is_reduced(at) == (n_bodies(at->m) > 0)) at->lu = lean_factors(at);
}

/* Links at the state, and no increments. */
static void rest_here(context *at)
{
    links_at_start(at);
    memcpy(at->k.signal1, at->s.signal, sizeof(double) * (size_t)at->m->n_signals);
    clear_nodes(at, at->k.hv);
    clear_nodes(at, at->k.d);
    stand_still_as_bodies(at);
}

/* Factors at the state. */
static int32_t factorise_here(context *at)
{
    rest_here(at);
    EACH_ROW(at, i) at->k.mu[i] = 0.0;
    at->constraints_only = 1;
    const int32_t status = factorise(at);
    at->constraints_only = 0;
    return status;
}

/* Rows at the state, and bodies that turn as wholes. */
static void look_at_rows(context *at)
{
    EACH_TURN(at, b) straighten(at, at->m->body_node[b]);
    stand_still(at);
    stand_still_as_bodies(at);
}

/* Puts coordinates back onto the rows, by displacements as small as can be. A
   correction leaves the same part as the one before it: where that is round-off, rows are not looked at again.       */
HM_SELDOM static int32_t close_rows(context *at)
{
    double last = INFINITY;
    for (int i = 0; i < MAX_CORRECTIONS; i++) {
        look_at_rows(at);
        EACH_ROW(at, row) at->k.phi[row] = at->k.phi0[row];
        const double defect = largest_row(at, at->k.phi);
        if (defect < 1e-17 || (defect <= at->s.head[S_NEWTON_TOLERANCE] && !(defect < 0.5 * last))) return HOLONOM_OK;
        clear_nodes(at, at->k.w);
        add_correction(at, at->k.w);
        EACH_FREE(at, k) hm_add(at->s.q + k, at->s.q_low + k, at->k.w[k]);
        if (i && defect <= at->s.head[S_NEWTON_TOLERANCE] && defect / last * defect < 1e-17) return HOLONOM_OK;
        last = defect;
    }
    return last <= at->s.head[S_NEWTON_TOLERANCE] ? HOLONOM_OK : HOLONOM_UZAWA_DIVERGED;
}

/* Takes from the velocities of directors what is not a turn of their body. */
HM_SELDOM static void turn_as_bodies(const context *at)
{
    EACH_TURN(at, b) {
        const int32_t first = DIM * at->m->body_node[b];
        double omega[TURNING], rest[TURNING], left[DIM * TURNING], turned[DIM];
        common_turn(at, at->m->body_node[b], at->s.v + first, omega);
        for (int k = 0; k < TURNING; k++) omega[k] = (double)(float)omega[k];
        for (int i = 0; i < DIM * TURNING; i += DIM)
            internal_velocity(at->s.v + first + i, at->s.v_low + first + i, omega, at->s.q + first + i, at->s.q_low + first + i, left + i);
        common_turn(at, at->m->body_node[b], left, rest);
        for (int i = 0; i < DIM * TURNING; i += DIM) {
            turned_by(rest, at->s.q + first + i, turned);
            EACH(k) hm_add(at->s.v + first + i + k, at->s.v_low + first + i + k, turned[k] - left[i + k]);
        }
    }
}

/* Lets velocities follow rows and signals (in signal_rate), by the smallest change; it ends likewise. */
HM_SELDOM static void follow_rows(context *at)
{
    const double round_off = 1e-17 * speed_scale(at) / at->number[at->m->extent_at + 1];
    double last = INFINITY, size = INFINITY;
    turn_as_bodies(at);
    for (int i = 0; i < MAX_CORRECTIONS && (i < 2 || !(size / last * size < round_off)); i++) {
        last = size;
        row_rates(at, at->s.q, at->s.q_low, at->s.v, at->s.signal, at->k.signal_rate, at->k.phi);
        size = largest_row(at, at->k.phi);
        if (!(size < 0.5 * last)) return;
        clear_nodes(at, at->k.w);
        add_correction(at, at->k.w);
        add_to_velocities(at, 1.0, at->k.w);
    }
}

/* Rates that rows ask of what stands still, in row_rate; whether they ask any. */
HM_SELDOM static int find_asked_rates(context *at)
{
    double *rest = at->k.w;
    clear_nodes(at, rest);
    row_rates(at, at->s.q, at->s.q_low, rest, at->s.signal, at->k.signal_rate, at->k.row_rate);
    return largest_row(at, at->k.row_rate) > 0.0;
}

/* Takes from u (n) what rows do not allow, beyond the rates that they ask of what stands still, in row_rate. */
HM_SELDOM static void leave_free(context *at, double *u)
{
    row_rates(at, at->s.q, at->s.q_low, u, at->s.signal, at->k.signal_rate, at->k.phi);
    EACH_ROW(at, i) at->k.phi[i] -= at->k.row_rate[i];
    add_correction(at, u);
}

/* The velocities' part u (n) that rows leave free and that has none of the kept momenta; there are no signals. */
HM_SELDOM static void free_velocities(context *at, const kept_motion *x, double L[RIGID][RIGID])
{
    double momentum[RIGID], unused[RIGID], *u = at->k.free;
    const int asks = at->begin[ISLAND_VELOCITY] < at->end[ISLAND_VELOCITY] && find_asked_rates(at); /* else velocities on the rows are free */
    clear_nodes(at, u);
    EACH_FREE(at, k) u[k] = at->s.v[k] + at->s.v_low[k];
    for (int repeat = 0; repeat < 3 && asks; repeat++) leave_free(at, u); /* what regularised factors leave is corrected again */
    inertia(at, 2.0, u, at->k.momentum);
    rigid_momenta(at, x->centre, x->kept, at->k.momentum, momentum, unused);
    for (int i = 0; i < RIGID; i++) momentum[i] = -momentum[i];
    add_rigid(at, x->centre, L, momentum, u);
}

/* Sizes of what the energy of the island at hand is summed of: weights, loads, springs and potentials act on places that are known
   to round-off of the mechanism's size, however little it has moved. */
HM_SELDOM static double sizes_of_summands(const context *c, const kept_motion *x)
{
    const holonom_model *m = c->m;
    const double *gravity = c->number + m->gravity_at, extent = c->number[m->extent_at];
    double sum = kinetic_energy(c, c->k.ahead) + x->kinetic + fabs(x->work) + fabs(x->dissipated), weight = 0.0;
    EACH_NODE(c, a) weight += c->number[m->node_weight_at + a];
    sum += weight * sqrt(dot(gravity, gravity)) * extent;
    for IN_ISLAND(c, j, ISLAND_LOAD) EACH(k) sum += fabs(c->number[m->load_at + DIM * j + k]) * extent;
    for IN_ISLAND(c, j, ISLAND_MOMENT)
        for (int k = 0; k < TURNING; k++) sum += fabs(c->number[m->moment_at + TURNING * j + k]);
    for IN_ISLAND(c, j, ISLAND_BODY_MOMENT)
        for (int k = 0; k < TURNING; k++) sum += fabs(c->number[m->body_moment_at + TURNING * j + k]);
    for IN_ISLAND(c, j, ISLAND_ELEMENT) {
        const double rest = c->number[m->rest_at + j];
        const int32_t measured = m->leaf[4 * m->leaf_ptr[j] + 1];
        const double sigma = quantity_at(c, measured, c->s.q, c->s.q_low, NULL, NULL);
        const double size = m->quantity_kind[measured] == QUANTITY_ANGLE ? 1.0 : extent;
        sum += fabs(c->number[m->drive_at + j]) * fmax(fabs(sigma), size);
        sum += c->number[m->stiffness_at + j] * fabs(sigma - rest) * (fabs(sigma) + fabs(rest));
    }
    if (m->n_potentials) quantities_at_state(c);
    for IN_ISLAND(c, j, ISLAND_POTENTIAL) {
        sum += fabs(function_value(c, j));
        for (int32_t l = 0; l < m->leaf_ptr[j + 1] - m->leaf_ptr[j]; l++) sum += fabs(c->k.r.adjoint[l] * c->k.r.r0[l]);
    }
    return sum;
}

/* Brings momenta of the island at hand back that are kept, by a motion as one rigid body: L is its mass matrix (factor_rigid). */
HM_SELDOM static void put_momenta_back(const context *c, kept_motion *x, double L[RIGID][RIGID])
{
    double lacking[RIGID], size[RIGID];
    momenta_now(c, x, lacking, size);
    factor_rigid(c, x->centre, x->kept, L);
    for (int i = 0; i < RIGID; i++) lacking[i] = x->before[i] - lacking[i];
    clear_nodes(c, c->k.w);
    add_rigid(c, x->centre, L, lacking, c->k.w);
    add_to_velocities(c, 1.0, c->k.w);
}

/* Brings the energy onto the ledger by a change of the velocities along u, those that are free:
   u'Mu s^2/2 + v'Mu s + excess = 0. Where the mechanism almost stands, round-off of the energy would be much velocity: it is left.
   Returns whether it could be done. */
HM_SELDOM static int balance_energy(context *c, const kept_motion *x, double potential)
{
    const double *u = c->k.free, square = mass_product(c, u, u);
    for (int i = 0;; i++) {
        const double excess = unbalanced(c, x, potential);
        double along = 0.0;
        EACH_NODE(c, a) along += dot(u + DIM * a, c->k.momentum + DIM * a);
        if (excess == 0.0 || i == 3) {
            c->island[I_UNBALANCED] = excess;
            return 1;
        }
        const double part = -2.0 * excess / (along + copysign(sqrt(along * along - 2.0 * square * excess), along));
        const double change = fabs(part) * sqrt(square) / speed_scale(c);
        if (!(change <= ENERGY_ROUND_OFF) && fabs(excess) <= LEDGER_ROUND_OFF * sizes_of_summands(c, x)) {
            c->island[I_UNBALANCED] = excess;
            return 1;
        }
        if (!(fabs(part) <= LARGEST_SCALING)) return 0;
        c->balanced = fmax(c->balanced, change);
        add_to_velocities(c, part, u);
    }
}

#if DIM == 3
/* Turns the island at hand, places and velocities, by the rotation vector psi about its centre. Returns how far, in the mass norm. */
HM_SELDOM static double turn_island(const context *c, const kept_motion *x, const double *psi)
{
    const double theta = sqrt(dot(psi, psi)), half = hm_sin(0.5 * theta), sine = hm_sin(theta) / theta, bend = 2.0 * half * half / (theta * theta);
    double *moved = c->k.w;
    EACH_NODE(c, a) {
        double arm[DIM], once[DIM], twice[DIM];
        arm_of(c, x->centre, a, arm);
        cross_product(psi, arm, once);
        cross_product(psi, once, twice);
        EACH(k) moved[DIM * a + k] = sine * once[k] + bend * twice[k];
        EACH(k) hm_add(c->s.q + DIM * a + k, c->s.q_low + DIM * a + k, moved[DIM * a + k]);
        cross_product(psi, c->s.v + DIM * a, once);
        cross_product(psi, once, twice);
        EACH(k) hm_add(c->s.v + DIM * a + k, c->s.v_low + DIM * a + k, sine * once[k] + bend * twice[k]);
    }
    return sqrt(mass_product(c, moved, moved));
}
#endif

#if DIM == 3
/* How many times larger an error along the path of a rigid body grows that flies with the angular momentum l and g = omega x l.
   It moves on as fast as l does in the body, and fastest with g^2 = (a_1 l^2 - 2T)(2T - a_3 l^2), a_1 > a_2 > a_3 the eigenvalues of
   I^-1 and T its energy: far faster than now if it turns about nearly its middle axis. */
HM_SELDOM static double growth_of_errors(double L[RIGID][RIGID], const double *l, const double *omega, const double *g)
{
    double trace = 0.0, minors = 0.0, det, a[3][RIGID] = {{0.0}}, minor[DIM];
    for (int i = 0; i < 3; i++) {
        a[i][DIM + i] = 1.0;
        solve_rigid(L, a[i]);
        trace += a[i][DIM + i];
    }
    cross_product(a[1] + DIM, a[2] + DIM, minor);
    det = dot(a[0] + DIM, minor);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        minors += a[i][DIM + i] * a[j][DIM + j] - hm_square(a[i][DIM + j]);
    }
    double middle = trace / 3.0; /* where the characteristic polynomial has its point of inflection: Newton's iteration finds a_2 */
    for (int i = 0; i < 20; i++) {
        const double slope = minors + middle * (3.0 * middle - 2.0 * trace);
        if (slope < 0.0) middle -= (middle * (minors + middle * (middle - trace)) - det) / slope;
    }
    const double l2 = dot(l, l), twice = dot(l, omega), outer = trace - middle;
    const double fastest2 = twice * (l2 * outer - twice) - (minors - middle * outer) * l2 * l2, now2 = dot(g, g);
    return fastest2 > now2 && now2 > 0.0 ? sqrt(fastest2 / now2) : 1.0;
}
#endif

/* Brings the energy of what flies onto the ledger by a turn of all of it along the gradient of its kinetic energy at fixed angular
   momentum l, g = omega x l: a turn s g changes it by |g|^2 s + (a'I^-1 a - omega . (g x a)) s^2/2, a = g x l. Returns whether it
   could be done. */
HM_SELDOM static int balance_by_turning(context *c, kept_motion *x, double L[RIGID][RIGID], double potential)
{
#if DIM == 3
    int keeps = x->flies;
    for (int i = 0; i < RIGID; i++) keeps &= x->kept[i];
    for (int i = 0; i < 3 && keeps; i++) {
        const double excess = unbalanced(c, x, potential), *l = x->before + DIM;
        double omega[RIGID] = {0.0}, answer[RIGID] = {0.0}, g[DIM], a[DIM], bend[DIM], psi[DIM];
        EACH(k) omega[DIM + k] = l[k];
        solve_rigid(L, omega);
        cross_product(omega + DIM, l, g);
        if (i == 0) c->growth = fmax(c->growth, growth_of_errors(L, l, omega + DIM, g));
        if (fabs(excess) <= LEDGER_ROUND_OFF * sizes_of_summands(c, x)) break;
        cross_product(g, l, a);
        cross_product(g, a, bend);
        EACH(k) answer[DIM + k] = a[k];
        solve_rigid(L, answer);
        const double slope = dot(g, g), curve = dot(a, answer + DIM) - dot(omega + DIM, bend);
        const double s = -2.0 * excess / (slope + sqrt(slope * slope - 2.0 * curve * excess));
        if (!(fabs(s) * sqrt(slope) <= LARGEST_SCALING)) return 0;
        EACH(k) psi[k] = s * g[k];
        c->balanced = fmax(c->balanced, turn_island(c, x, psi) / c->number[c->m->extent_at + 1]);
        put_momenta_back(c, x, L);
        potential = potential_of_island(c);
    }
    c->island[I_UNBALANCED] = unbalanced(c, x, potential);
    return keeps;
#else
    (void)c, (void)x, (void)L, (void)potential;
    return 0;
#endif
}

/* Whether drivers move the island at hand, or loads that read the mechanism may act on it: their work is known to the order. */
HM_SELDOM static int has_unknown_work(const context *c)
{
    if (c->begin[ISLAND_DRIVEN] < c->end[ISLAND_DRIVEN]) return 1;
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY && c->m->n_signals; k++)
        for IN_ISLAND(c, j, k) if (has_signal(c, j)) return 1;
    return c->m->sensing && (is_loaded(c) || c->begin[ISLAND_ELEMENT] < c->end[ISLAND_ELEMENT]);
}

/* Lets what is lost in the step, and is known to its order, make up for an energy that velocities cannot bring back, as all stands for
   a moment, for one where a slip stops. Returns whether so much is lost. */
HM_SELDOM static int make_up(context *c, double excess)
{
    const double damped = lost_of(c, S_DISSIPATED), rubbed = lost_of(c, S_FRICTION);
    if (!(fabs(excess) <= damped + rubbed)) return 0;
    book(c, rubbed > damped ? S_FRICTION : S_DISSIPATED, -excess);
    return 1;
}

/* Puts velocities of the island at hand back: onto the rows' rates, momenta that are kept, and the energy. Returns whether they
   could be: a spherical pendulum has for a moment no velocity that is free to bring the energy back. What flies turns for it. */
HM_SELDOM static int put_island_velocities_back(context *c, context *at)
{
    kept_motion *x = kept_of(c);
    double L[RIGID][RIGID] = {{0.0}};
    follow_rows(at);
    put_momenta_back(c, x, L);
    const double potential = potential_of_island(c);
    if (has_unknown_work(c)) {
        book(c, S_WORK, unbalanced(c, x, potential));
        c->island[I_UNBALANCED] = 0.0;
        return 1;
    }
    free_velocities(at, x, L);
    if (mass_product(c, c->k.free, c->k.free) >= LEAST_FREE * mass_product(c, c->s.v, c->s.v) && balance_energy(c, x, potential)) {
        if (make_up(c, c->island[I_UNBALANCED])) c->island[I_UNBALANCED] = 0.0;
        return 1;
    }
    if (balance_by_turning(c, x, L, potential)) return 1;
    /* Steady spins have no velocity and no turn that would change the energy: round-off of a step is left, and is seen in the ledger. */
    c->island[I_UNBALANCED] = 0.0;
    const double excess = unbalanced(c, x, potential);
    return make_up(c, excess) || fabs(excess - x->lacking) <= LEDGER_ROUND_OFF * sizes_of_summands(c, x);
}

/* Likewise of all islands. Factors at hand are those of equations at the state, or at one as near. */
static int put_velocities_back(context *c, context *at)
{
    int done = 1;
    signal_rates_at(c, c->t, c->k.signal_rate);
    for (int32_t island = 0; island < c->m->n_islands && done; island++) {
        look_at_island(c, at, island);
        done = put_island_velocities_back(c, at);
    }
    look_at_island(c, at, c->m->n_islands);
    return done;
}

/* Forgets those momenta of the islands that velocities have changed. */
HM_SELDOM static void forget_changed(context *c)
{
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        double after[RIGID], scale[RIGID];
        look_at(c, island, island + 1);
        kept_motion *x = kept_of(c);
        momenta_now(c, x, after, scale);
        for (int i = 0; i < RIGID; i++)
            x->kept[i] &= fabs(after[i] - x->before[i]) <= MOMENTUM_ROUND_OFF * fmax(scale[i], x->scale[i]);
    }
    look_at(c, 0, c->m->n_islands);
}

/* Adds the energies that the islands have gained so far, `weight` times, to those that they are to gain. */
HM_SELDOM static void weigh_energies(context *c, double weight)
{
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        look_at(c, island, island + 1);
        kept_motion *x = kept_of(c);
        x->work += weight * ((kinetic_energy(c, c->k.momentum) - x->kinetic) + (potential_of_island(c) - x->potential));
    }
    look_at(c, 0, c->m->n_islands);
}

/* Lets the islands gain `total` together, as the ledger says: the last one makes up for the round-off of differences of energies. */
HM_SELDOM static void gain_together(context *c, double total)
{
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        look_at(c, island, island + 1);
        kept_motion *x = kept_of(c);
        if (island == c->m->n_islands - 1) x->work = total;
        total -= x->work;
    }
    look_at(c, 0, c->m->n_islands);
}

/* Takes from velocities what half steps have left of them across the rows, which alternates from one to the next and is not damped:
   places are on the rows. Momenta that rows let be are kept, and the energy. Where that cannot be, velocities stay as they are.  */
HM_SELDOM static void put_only_velocities_back(context *c)
{
    context at = rows_at_state(c, 0.0);
    const size_t bytes = sizeof(double) * (size_t)c->state_size;
    double *before = c->k.whole_backup;
    int done = 0;
    memcpy(before, c->s.head, bytes);
    keep_motion(c, 0.0);
    signals_at(c, c->t, c->k.signal1);
    signal_rates_at(c, c->t, c->k.signal_rate);
    place_driven(c); /* half steps leave rates of driven nodes that are right to the order */
    take_unknowns(&at);
    if (!factorise_here(&at)) {
        follow_rows(&at);
        forget_changed(c);
        done = put_velocities_back(c, &at);
    }
    if (!done) memcpy(c->s.head, before, bytes);
}

/* Puts the state back, coordinates first; `held` says whether it cannot be, also where rows are too weak for it. */
HM_SELDOM static int32_t put_back(context *c, context *at, int *held)
{
    int32_t status = HOLONOM_OK;
    *held = 0;
    signal_rates_at(c, c->t, c->k.signal_rate);
    for (int32_t island = 0; island < c->m->n_islands && !status; island++) {
        look_at_island(c, at, island);
        for (int i = 0; i < 2; i++) EACH_TURN(at, b) straighten(c, c->m->body_node[b]); /* errors are squared in each */
        status = close_rows(at);
        if (!status && !put_island_velocities_back(c, at)) status = HOLONOM_NOT_FINITE;
        *held = status != HOLONOM_OK;
    }
    look_at_island(c, at, c->m->n_islands);
    return status;
}

#endif
