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
#define LARGEST_SCALING 0.1 /* part by which velocities are changed for the energy */
#define ENERGY_ROUND_OFF 1e-12 /* of what brings the energy back, over the speed */
#define LEDGER_ROUND_OFF 1e-15 /* of its balance, over the sum of its summands */
#define MOMENTUM_ROUND_OFF 1e-12 /* relative change of a momentum */
#define LEAST_FREE 1e-8     /* part of the kinetic energy that velocities must have which momenta and rows leave free */

typedef struct kept_momenta {
    int kept[RIGID];
    double before[RIGID], scale[RIGID]; /* at the start of the step, and sums of their terms' sizes */
} kept_momenta;

/* Ledger and momenta are those of the whole: put back, separate islands would exchange energy and momentum. */
static int may_put_back(const context *c)
{
    return (c->m->n_islands == 1 || !c->m->n_free);
}

/* Momenta at the state, of which all may be kept. */
HM_SELDOM static kept_momenta momenta_at_start(const context *c)
{
    kept_momenta x;
    momenta(c, c->k.momentum);
    for (int i = 0; i < RIGID; i++) x.kept[i] = 1;
    rigid_momenta(c, x.kept, c->k.momentum, x.before, x.scale);
    return x;
}

/* Changes of velocities that make up for the rates g in `phi`, as small as can be, or of coordinates for rows; added to x. */
static void add_correction(const context *at, double *x)
{
    memset(at->k.momentum, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
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
    const size_t n = sizeof(double) * (size_t)(DIM * at->n_moving);
    links_at_start(at);
    memcpy(at->k.signal1, at->s.signal, sizeof(double) * (size_t)at->m->n_signals);
    memset(at->k.hv, 0, n);
    memset(at->k.d, 0, n);
    stand_still_as_bodies(at);
}

/* Factors at the state. */
static int32_t factorise_here(context *at)
{
    rest_here(at);
    memset(at->k.mu, 0, sizeof(double) * (size_t)at->m->n_rows);
    at->constraints_only = 1;
    const int32_t status = factorise(at);
    at->constraints_only = 0;
    return status;
}

/* Rows at the state, and bodies that turn as wholes. */
static void look_at_rows(context *at)
{
    memset(at->k.phi0, 0, sizeof(double) * (size_t)at->m->n_rows);
    EACH_TURN(at, b) straighten(at, at->m->body_node[b]);
    stand_still(at);
    stand_still_as_bodies(at);
}

/* Puts coordinates back onto the rows, by displacements as small as can be. A
   correction leaves the same part as the one before it: where that is round-off, rows are not looked at again.       */
HM_SELDOM static int32_t close_rows(context *at)
{
    const size_t rows = sizeof(double) * (size_t)at->m->n_rows, n = sizeof(double) * (size_t)(DIM * at->n_moving);
    double last = INFINITY;
    for (int i = 0; i < MAX_CORRECTIONS; i++) {
        look_at_rows(at);
        memcpy(at->k.phi, at->k.phi0, rows);
        const double defect = largest_row(at, at->k.phi);
        if (defect < 1e-17 || (defect <= at->s.head[S_NEWTON_TOLERANCE] && !(defect < 0.5 * last))) return HOLONOM_OK;
        memset(at->k.w, 0, n);
        add_correction(at, at->k.w);
        for (int32_t k = 0; k < DIM * at->m->n_free; k++) hm_add(at->s.q + k, at->s.q_low + k, at->k.w[k]);
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

/* Lets velocities follow rows and signals, by the smallest change; it ends likewise. */
HM_SELDOM static void follow_rows(context *at)
{
    const double round_off = 1e-17 * speed_scale(at) / at->number[at->m->extent_at + 1];
    double last = INFINITY, size = INFINITY;
    turn_as_bodies(at);
    signal_rates_at(at, at->t, at->k.signal_rate);
    for (int i = 0; i < MAX_CORRECTIONS && (i < 2 || !(size / last * size < round_off)); i++) {
        last = size;
        row_rates(at, at->s.q, at->s.q_low, at->s.v, at->s.signal, at->k.signal_rate, at->k.phi);
        size = largest_row(at, at->k.phi);
        if (!(size < 0.5 * last)) return;
        memset(at->k.w, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
        add_correction(at, at->k.w);
        for (int32_t k = 0; k < DIM * at->m->n_free; k++) hm_add(at->s.v + k, at->s.v_low + k, at->k.w[k]);
    }
}

/* Rates that rows ask of what stands still, in row_rate; whether they ask any. */
HM_SELDOM static int find_asked_rates(context *at)
{
    double *rest = at->k.w;
    memset(rest, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
    row_rates(at, at->s.q, at->s.q_low, rest, at->s.signal, at->k.signal_rate, at->k.row_rate);
    return largest_row(at, at->k.row_rate) > 0.0;
}

/* Takes from u (n) what rows do not allow, beyond the rates that they ask of what stands still, in row_rate. */
HM_SELDOM static void leave_free(context *at, double *u)
{
    row_rates(at, at->s.q, at->s.q_low, u, at->s.signal, at->k.signal_rate, at->k.phi);
    for (int32_t i = 0; i < at->m->n_rows; i++) at->k.phi[i] -= at->k.row_rate[i];
    add_correction(at, u);
}

/* The velocities' part u (n) that rows leave free and that has none of the kept momenta; there are no signals. */
HM_SELDOM static void free_velocities(context *at, const int *kept, double L[RIGID][RIGID])
{
    const holonom_model *m = at->m;
    double momentum[RIGID], unused[RIGID], *u = at->k.free;
    const int asks = m->n_velocity_rows && find_asked_rates(at); /* else velocities on the rows are free */
    memset(u, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
    for (int32_t k = 0; k < DIM * m->n_free; k++) u[k] = at->s.v[k] + at->s.v_low[k];
    for (int repeat = 0; repeat < 3 && asks; repeat++) leave_free(at, u); /* what regularised factors leave is corrected again */
    inertia(at, 2.0, u, at->k.momentum);
    rigid_momenta(at, kept, at->k.momentum, momentum, unused);
    for (int i = 0; i < RIGID; i++) momentum[i] = -momentum[i];
    add_rigid(at, L, momentum, u);
}

/* Energy that the ledger does not know of. */
static double unbalanced(const context *c)
{
    return ledger_balance(c, kinetic_energy(c, c->k.momentum), potential_change(c));
}

/* Sizes of what the energy is summed of: weights, loads, springs and potentials act on places that are known to round-off of the
   mechanism's size, however little it has moved. */
HM_SELDOM static double sizes_of_summands(const context *c)
{
    const holonom_model *m = c->m;
    const double *head = c->s.head, *gravity = c->number + m->gravity_at, extent = c->number[m->extent_at];
    double sum = kinetic_energy(c, c->k.ahead) + head[S_KINETIC_START], weight = 0.0;
    sum += fabs(head[S_WORK]) + fabs(head[S_DISSIPATED]) + fabs(head[S_FRICTION]) + fabs(head[S_IMPACT]);
    for (int32_t a = 0; a < c->n_moving; a++) weight += c->number[m->node_weight_at + a];
    sum += weight * sqrt(dot(gravity, gravity)) * extent;
    for (int32_t k = 0; k < DIM * m->n_loads; k++) sum += fabs(c->number[m->load_at + k]) * extent;
    for (int32_t k = 0; k < TURNING * m->n_moments; k++) sum += fabs(c->number[m->moment_at + k]);
    for (int32_t k = 0; k < TURNING * m->n_body_moments; k++) sum += fabs(c->number[m->body_moment_at + k]);
    for (int32_t j = 0; j < m->n_elements; j++) {
        const double rest = c->number[m->rest_at + j];
        const int32_t measured = m->leaf[4 * m->leaf_ptr[j] + 1];
        const double sigma = quantity_at(c, measured, c->s.q, c->s.q_low, NULL, NULL);
        const double size = m->quantity_kind[measured] == QUANTITY_ANGLE ? 1.0 : extent;
        sum += fabs(c->number[m->drive_at + j]) * fmax(fabs(sigma), size);
        sum += c->number[m->stiffness_at + j] * fabs(sigma - rest) * (fabs(sigma) + fabs(rest));
    }
    if (m->n_potentials) quantities_at_state(c);
    for (int32_t j = first_potential(c); j < n_composites(c); j++) {
        sum += fabs(function_value(c, j));
        for (int32_t l = 0; l < m->leaf_ptr[j + 1] - m->leaf_ptr[j]; l++) sum += fabs(c->k.r.adjoint[l] * c->k.r.r0[l]);
    }
    return sum;
}

/* Brings the energy onto the ledger by a change of the velocities along u, those that are free:
   u'Mu s^2/2 + v'Mu s + excess = 0. Where the mechanism almost stands, round-off of the energy would be much velocity: it is left. */
HM_SELDOM static int32_t balance_energy(context *c)
{
    const double *u = c->k.free, square = mass_product(c, u, u);
    for (int i = 0; i < 3; i++) {
        const double excess = unbalanced(c); /* leaves M v in momentum */
        double along = 0.0;
        for (int32_t a = 0; a < c->n_moving; a++) along += dot(u + DIM * a, c->k.momentum + DIM * a);
        if (excess == 0.0) return HOLONOM_OK;
        const double part = -2.0 * excess / (along + copysign(sqrt(along * along - 2.0 * square * excess), along));
        const double change = fabs(part) * sqrt(square) / speed_scale(c);
        if (!(change <= ENERGY_ROUND_OFF) && fabs(excess) <= LEDGER_ROUND_OFF * sizes_of_summands(c)) return HOLONOM_OK;
        if (!(fabs(part) <= LARGEST_SCALING)) return HOLONOM_NOT_FINITE;
        c->balanced = fmax(c->balanced, change);
        for (int32_t k = 0; k < DIM * c->m->n_free; k++) hm_add(c->s.v + k, c->s.v_low + k, part * u[k]);
    }
    return HOLONOM_OK;
}

/* Puts velocities back: onto the rows' rates, momenta that are kept, and the energy. `held` says whether they cannot be, as none is
   free to bring the energy back: a body that flies has none but those of its momenta, and a spherical pendulum none for a moment.
   Factors at hand are those of equations at the state, or at one as near. */
HM_SELDOM static int32_t put_velocities_back(context *c, context *at, const kept_momenta *x, int *held)
{
    double L[RIGID][RIGID] = {{0.0}}, lacking[RIGID], size[RIGID];
    follow_rows(at);
    factor_rigid(c, x->kept, L);
    momenta(c, c->k.momentum);
    rigid_momenta(c, x->kept, c->k.momentum, lacking, size);
    for (int i = 0; i < RIGID; i++) lacking[i] = x->before[i] - lacking[i];
    memset(c->k.w, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    add_rigid(c, L, lacking, c->k.w);
    for (int32_t k = 0; k < DIM * c->m->n_free; k++) hm_add(c->s.v + k, c->s.v_low + k, c->k.w[k]);
    *held = 0;
    /* Drivers leave little or nothing free; their work, and that of loads that read the mechanism, is known to the order. */
    if (c->m->n_signals || c->m->sensing) {
        book(c, S_WORK, unbalanced(c));
        return HOLONOM_OK;
    }
    free_velocities(at, x->kept, L);
    *held = !(mass_product(c, c->k.free, c->k.free) >= LEAST_FREE * mass_product(c, c->s.v, c->s.v));
    const int32_t status = *held ? HOLONOM_NOT_FINITE : balance_energy(c);
    *held = status != HOLONOM_OK;
    return status;
}

/* Forgets those momenta that velocities have changed. */
HM_SELDOM static void forget_changed(const context *c, kept_momenta *x)
{
    double after[RIGID], scale[RIGID];
    momenta(c, c->k.momentum);
    rigid_momenta(c, x->kept, c->k.momentum, after, scale);
    for (int i = 0; i < RIGID; i++) x->kept[i] &= fabs(after[i] - x->before[i]) <= MOMENTUM_ROUND_OFF * fmax(scale[i], x->scale[i]);
}

/* Takes from velocities what half steps have left of them across the rows, which alternates from one to the next and is not damped:
   places are on the rows. Momenta that rows let be are kept, and the energy. Where that cannot be, velocities stay as they are.  */
HM_SELDOM static void put_only_velocities_back(context *c)
{
    context at = rows_at_state(c, 0.0);
    const size_t bytes = sizeof(double) * (size_t)c->state_size;
    double *before = c->k.whole_backup;
    int held = 1;
    memcpy(before, c->s.head, bytes);
    kept_momenta x = momenta_at_start(c);
    signals_at(c, c->t, c->k.signal1);
    signal_rates_at(c, c->t, c->k.signal_rate);
    place_driven(c); /* half steps leave rates of driven nodes that are right to the order */
    take_unknowns(&at);
    if (!factorise_here(&at)) {
        follow_rows(&at);
        forget_changed(c, &x);
        put_velocities_back(c, &at, &x, &held);
    }
    if (held) memcpy(c->s.head, before, bytes);
}

/* Puts the state back, coordinates first; `held` also says where rows are too weak for it. */
HM_SELDOM static int32_t put_back(context *c, context *at, const kept_momenta *x, int *held)
{
    for (int i = 0; i < 2; i++) EACH_TURN(at, b) straighten(c, c->m->body_node[b]); /* errors are squared in each */
    const int32_t status = close_rows(at);
    *held = status != HOLONOM_OK;
    return status ? status : put_velocities_back(c, at, x, held);
}

#endif
