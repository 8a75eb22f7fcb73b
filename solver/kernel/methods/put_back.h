/* Puts a state that is right up to the order of its step back onto rows, rates of rows, momenta
   that are kept, and the energy that the ledger asks for. */
#ifndef HOLONOM_PUT_BACK_H
#define HOLONOM_PUT_BACK_H

#include "flight.h"
#include "start.h"

enum { MAX_CORRECTIONS = 8 };
#define LARGEST_SCALING 0.1 /* part by which velocities are changed for the energy */
#define ENERGY_ROUND_OFF 1e-12 /* of what brings the energy back, over the speed */
#define LEAST_FREE                                                                                 \
    1e-8 /* part of the kinetic energy that velocities must have which momenta and rows leave free
            \ */

/* Islands, one after the other at hand in both contexts, as EACH_ISLAND. */
#define EACH_ISLAND_OF_BOTH(c, at, i)                                                              \
    for (int32_t i = next_chosen(c, 0); take_island(c, i) & take_island(at, i);                    \
         i = next_chosen(c, i + 1))

/* Changes of velocities that make up for the rates g in `phi`, as small as can be, or of
   coordinates for rows; added to x. */
static void add_correction(const context *at, double *x)
{
    clear_nodes(at, at->k.momentum);
    gather_momentum(at);
    EACH_ROW(at, i) at->k.rhs[at->factors.lu->row_position[i]] = -at->k.phi[i];
    solve_factors(at);
    add_solution(at, x);
}

/* Lets equations at the state have factors without stiffness where there are any. */
static void take_unknowns(context *at)
{
    select_all_islands(at);
    stand_still_as_bodies(at);
    at->step.rows_known = 0;
    if (at->m->n_lean_values) at->factors.lu = lean_factors(at);
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
    at->step.constraints_only = 1;
    const int32_t status = factorise(at);
    at->step.constraints_only = 0;
    return status;
}

/* Rows at the state, and bodies that turn as wholes. */
static void look_at_rows(context *at)
{
    EACH_TURN(at, b) straighten(at, at->m->body_node[b]);
    stand_still(at);
}

/* Puts coordinates back onto the rows, by displacements as small as can be. A
   correction leaves the same part as the one before it: where that is round-off, rows are not
   looked at again. */
HM_SELDOM static int32_t close_rows(context *at)
{
    double last = INFINITY;
    for (int i = 0; i < MAX_CORRECTIONS; i++) {
        look_at_rows(at);
        EACH_ROW(at, row) at->k.phi[row] = at->k.phi0[row];
        const double defect = largest_row(at, at->k.phi);
        if (defect < 1e-17 || (defect <= at->s.head[S_NEWTON_TOLERANCE] && !(defect < 0.5 * last)))
            return HOLONOM_OK;
        clear_nodes(at, at->k.w);
        add_correction(at, at->k.w);
        EACH_FREE(at, k) hm_add(at->s.q + k, at->s.q_low + k, at->k.w[k]);
        if (i && defect <= at->s.head[S_NEWTON_TOLERANCE] && defect / last * defect < 1e-17)
            return HOLONOM_OK;
        last = defect;
    }
    return last <= at->s.head[S_NEWTON_TOLERANCE] ? HOLONOM_OK : HOLONOM_UZAWA_DIVERGED;
}

/* Takes from the velocities of directors what is not a turn of their body. */
HM_SELDOM static void turn_as_bodies(context *at)
{
    beside_turns(at, at->k.w);
    add_to_velocities(at, 1.0, at->k.w);
}

/* Lets velocities follow rows and signals (in signal_rate), by the smallest change; it ends
   likewise. */
HM_SELDOM static void follow_rows(context *at)
{
    const double round_off = 1e-17 * speed_scale(at) / at->number[at->m->extent_at + 1];
    double last = INFINITY, size = INFINITY;
    turn_as_bodies(at);
    for (int i = 0; i < MAX_CORRECTIONS && (i < 2 || !(size / last * size < round_off)); i++) {
        last = size;
        row_rates(at, at->s.v, at->k.signal_rate, at->k.phi);
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
    row_rates(at, rest, at->k.signal_rate, at->k.row_rate);
    return largest_row(at, at->k.row_rate) > 0.0;
}

/* Takes from u (n) what rows do not allow, beyond the rates that they ask of what stands still, in
   row_rate. */
HM_SELDOM static void leave_free(context *at, double *u)
{
    row_rates(at, u, at->k.signal_rate, at->k.phi);
    EACH_ROW(at, i) at->k.phi[i] -= at->k.row_rate[i];
    add_correction(at, u);
}

/* The velocities' part u (n) that rows leave free and that has none of the kept momenta; there are
   no signals. */
HM_SELDOM static void free_velocities(context *at, const kept_motion *x, double L[RIGID][RIGID])
{
    double momentum[RIGID], unused[RIGID], *u = at->k.free;
    const int asks = at->view.begin[ISLAND_VELOCITY] < at->view.end[ISLAND_VELOCITY]
                     && find_asked_rates(at); /* else velocities on the rows are free */
    clear_nodes(at, u);
    EACH_FREE(at, k) u[k] = at->s.v[k] + at->s.v_low[k];
    for (int repeat = 0; repeat < 3 && asks; repeat++)
        leave_free(at, u); /* what regularised factors leave is corrected again */
    inertia(at, 1.0, u, at->k.momentum);
    rigid_momenta(at, x->centre, x->kept, at->k.momentum, momentum, unused);
    for (int i = 0; i < RIGID; i++) momentum[i] = -momentum[i];
    add_rigid(at, x->centre, L, momentum, u);
}

/* Brings the energy onto the ledger by a change of the velocities along u, those that are free:
   u'Mu s^2/2 + v'Mu s + excess = 0. Where the mechanism almost stands, round-off of the energy
   would be much velocity: it is left. Returns whether it could be done. */
HM_SELDOM static int balance_energy(context *c, kept_motion *x, double potential)
{
    const double *u = c->k.free, square = mass_product(c, u, u);
    for (int i = 0; i < 3; i++) {
        const double excess = unbalanced(c, x, potential);
        double along = 0.0;
        c->view.scalars[I_UNBALANCED] = excess;
        if (excess == 0.0) return 1;
        EACH_NODE(c, a) along += dot(u + DIM * a, c->k.momentum + DIM * a);
        const double part =
            -2.0 * excess / (along + copysign(sqrt(along * along - 2.0 * square * excess), along));
        const double change = fabs(part) * sqrt(square) / speed_scale(c);
        if (!(change <= ENERGY_ROUND_OFF) && is_round_off(c, x, excess)) return 1;
        if (!(fabs(part) <= LARGEST_SCALING)) return 0;
        x->correction = fmax(x->correction, change);
        add_to_velocities(c, part, u);
    }
    if (c->m->n_islands > 1) c->view.scalars[I_UNBALANCED] = unbalanced(c, x, potential);
    return 1;
}

/* Whether drivers move the island at hand, or loads that read the mechanism may act on it: their
   work is known to the order. */
HM_SELDOM static int has_unknown_work(const context *c)
{
    if (c->view.begin[ISLAND_DRIVEN] < c->view.end[ISLAND_DRIVEN]) return 1;
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY && c->m->n_signals; k++)
        for IN_ISLAND(c, j, k) if (has_signal(c, j)) return 1;
    return c->m->sensing && (is_loaded(c) || has_drives(c));
}

/* Lets what is lost in the step, and is known to its order, make up for an energy that velocities
   cannot bring back, as all stands for a moment, for one where a slip stops. Returns whether so
   much is lost. */
HM_SELDOM static int make_up(context *c, double excess)
{
    const double damped = lost_of(c, S_DISSIPATED), rubbed = lost_of(c, S_FRICTION);
    if (!(fabs(excess) <= fmax(damped, rubbed))) return 0; /* no account becomes negative by it */
    book(c, rubbed > damped ? S_FRICTION : S_DISSIPATED, -excess);
    return 1;
}

/* Puts velocities of the island at hand back: onto the rows' rates, momenta that are kept, and the
   energy. Returns whether they could be: a spherical pendulum has for a moment no velocity that is
   free to bring the energy back. What flies turns for it. */
HM_SELDOM static int put_island_velocities_back(context *c, context *at)
{
    kept_motion *x = kept_of(c);
    double L[RIGID][RIGID] = {{0.0}};
    follow_rows(at);
#if DIM == 3
    turn_to_momentum(c, x);
#endif
    put_momenta_back(c, x, L);
    const double potential = potential_of_island(c);
    if (has_unknown_work(c)) {
        book(c, S_WORK, unbalanced(c, x, potential));
        c->view.scalars[I_UNBALANCED] = 0.0;
        return 1;
    }
    free_velocities(at, x, L);
    if (mass_product(c, c->k.free, c->k.free) >= LEAST_FREE * mass_product(c, c->s.v, c->s.v)
        && balance_energy(c, x, potential)) {
        if (make_up(c, c->view.scalars[I_UNBALANCED])) c->view.scalars[I_UNBALANCED] = 0.0;
        return 1;
    }
    if (balance_by_turning(c, x, L, potential)) return 1;
    /* Steady spins have no velocity and no turn that would change the energy: round-off of a step
       is left, and is seen in the ledger. */
    c->view.scalars[I_UNBALANCED] = 0.0;
    const double excess = unbalanced(c, x, potential);
    return make_up(c, excess) || is_round_off(c, x, excess);
}

/* Likewise of all islands. Factors at hand are those of equations at the state, or at one as near;
   rates of signals are those now. */
static int put_velocities_back(context *c, context *at)
{
    int done = 1;
    EACH_ISLAND_OF_BOTH(c, at, island) done = done && put_island_velocities_back(c, at);
    return done;
}

/* Takes from velocities what half steps have left of them across the rows, which alternates from
   one to the next and is not damped: places are on the rows. Momenta that rows let be are kept, and
   the energy. Where that cannot be, velocities stay as they are. */
HM_SELDOM static void put_only_velocities_back(context *c)
{
    context at = rows_at_state(c);
    double *before = c->k.whole_backup;
    int done = 0;
    keep_state(c, before);
    keep_motion(c, 0.0);
    follow_drivers(c);
    take_unknowns(&at);
    if (!factorise_here(&at)) {
        follow_rows(&at);
        forget_changed(c);
        done = put_velocities_back(c, &at);
    }
    if (!done) take_state(c, before);
}

/* Likewise coordinates, ahead of velocities; returns a failure where they cannot be, also where
   rows are too weak for it. */
HM_SELDOM static int32_t put_back(context *c, context *at)
{
    int32_t status = HOLONOM_OK;
    EACH_ISLAND_OF_BOTH(c, at, island) {
        if (status) continue;
        for (int i = 0; i < 2; i++)
            EACH_TURN(at, b) straighten(c, c->m->body_node[b]); /* errors are squared in each */
        status = close_rows(at);
        if (!status && !put_island_velocities_back(c, at)) status = HOLONOM_NOT_FINITE;
    }
    return status;
}

#endif
