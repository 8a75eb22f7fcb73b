/* How fast springs, potentials and dampers move a mechanism: what an explicit step can resolve
   (theory 8.8). */
#ifndef HOLONOM_FORCE_RATES_H
#define HOLONOM_FORCE_RATES_H

#include "put_back.h"

/* Turn of a spring's motion, and way of a damper's, over its time constant, in an explicit step.
   The method is stable to 5.8 and 6.4 (Hairer, Norsett and Wanner 1993, II.10); springs that move
   so far shorten steps by their errors first. Powers come near the largest eigenvalue from
   below. */
#define SPRING_TURN 5.0
#define DAMPER_WAY 4.0

#define STIFF                                                                                      \
    100.0 /* rate of a damper over that of the motion: beyond, covers let it settle within a step
             \ */

enum { MOST_POWERS = 10 };
#define CLOSE 0.02 /* change of a rate by a power, of it, after which no more are taken */

/* x (n, overwritten) = -M^-1 of the forces in momentum, along the rows. */
static void respond(const context *at, double *x)
{
    clear_bodies(at, at->k.torque, TURNING);
    if (has_turns(at)) reduce_momentum(at);
    gather_momentum(at);
    EACH_ROW(at, i) at->k.rhs[at->factors.lu->row_position[i]] = 0.0;
    solve_factors(at);
    memset(x, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
    add_solution(at, x);
}

/* Whether the potentials have derivatives of all orders: no kinks, jumps or tables, and no
   dampers; `but_forces`: forces may have what they like. */
static int are_smooth(const context *at, int but_forces)
{
    const holonom_model *m = at->m;
    for (int32_t j = first_potential(at); j < n_composites(at); j++) {
        const int32_t f = j - first_function(at);
        if (but_forces && is_force(at, j)) continue;
        if (is_damped(at, j)) return 0;
        for (int32_t i = m->function_ptr[f]; i < m->function_ptr[f + 1]; i++) {
            const int32_t code = m->operation[4 * i];
            if (code > T_LOG && !(code >= T_SINH && code <= T_TANH)) return 0;
        }
    }
    return 1;
}

/* Second derivative of potential j along rates of its leaves (in r0) with `more` added to that of
   leaf l; values are in r1. */
static double bend_along(const context *at, int32_t j, int32_t l, double more)
{
    hm_jet *x = (hm_jet *)at->k.leaves;
    for (int32_t k = 0; k < at->m->leaf_ptr[j + 1] - at->m->leaf_ptr[j]; k++)
        x[k] = (hm_jet){at->k.r.r1[k], at->k.r.r0[k] + (k == l ? more : 0.0), 0.0};
    return function_jet(at, j, 0, x, NULL).bend;
}

/* Adds to momentum the change of the potentials' forces in the motion x, by their second
   derivatives H in what they measure: of its rates r, 4 s e'H r = (r + s e)'H (r + s e) - (r - s
   e)'H (r - s e). */
static int32_t add_forces_of_potentials(const context *at, const double *x)
{
    const holonom_model *m = at->m;
    for (int32_t j = first_potential(at); j < n_composites(at); j++) {
        const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j],
                      *entry = m->leaf + 4 * m->leaf_ptr[j];
        double s = 0.0;
        if (is_force(at, j)) continue;
        set_local_forms(at, j, 0.5);
        for (int32_t l = 0; l < n; l++) {
            double *rate = at->k.r.r0 + l;
            const int is_signal = entry[4 * l] == LEAF_SIGNAL, q = entry[4 * l + 1];
            at->k.r.r1[l] =
                is_signal ? at->s.signal[q] : quantity_at(at, q, at->s.q, at->s.q_low, x, rate);
            if (is_signal) *rate = 0.0;
            s = fmax(s, fabs(*rate));
        }
        for (int32_t l = 0; l < n && s > 0.0; l++, entry += 4) {
            leaf_state leaf;
            if (entry[0] == LEAF_SIGNAL) continue;
            const double along = (bend_along(at, j, l, s) - bend_along(at, j, l, -s)) / (4.0 * s);
            const int32_t status = set_leaf(at, entry, 0, &leaf);
            if (status) return status;
            add_leaf_force(at, j, entry, &leaf, along);
        }
    }
    return HOLONOM_OK;
}

/* Likewise of forces N: adds the change of each by its leaves of one kind, quantities or their
   rates, which change as in the motion x. */
static int32_t add_changes_of_forces(const context *at, const double *x, int leaf_kind)
{
    const holonom_model *m = at->m;
    for (int32_t j = first_potential(at); j < n_composites(at); j++) {
        const int32_t *entry = m->leaf + 4 * m->leaf_ptr[j];
        double along, change = 0.0;
        leaf_state leaf;
        if (!is_force(at, j)) continue;
        set_local_forms(at, j, 0.5);
        force_at_state(at, j, 1, &along);
        for (int32_t l = 0; l < m->leaf_ptr[j + 1] - m->leaf_ptr[j]; l++) {
            double rate;
            if (entry[4 * l] != leaf_kind) continue;
            quantity_at(at, entry[4 * l + 1], at->s.q, at->s.q_low, x, &rate);
            change += at->k.r.adjoint[l] * rate;
        }
        const int32_t status = set_leaf(at, entry, 0, &leaf);
        if (status) return status;
        add_leaf_force(at, j, entry, &leaf, change);
    }
    return HOLONOM_OK;
}

/* Forces by what they depend on: quantities (springs, potentials) or their rates (dampers). A
   force N may depend on both, and counts in each. */
enum dependence { ON_QUANTITIES, ON_RATES };

static inline int64_t coefficients_at(const context *at, enum dependence which)
{ return which == ON_QUANTITIES ? at->m->stiffness_at : at->m->damping_at; }

static int has_forces_that_depend(const context *at, enum dependence which)
{
    for (int32_t j = 0; j < at->m->n_elements; j++)
        if (at->number[coefficients_at(at, which) + j] != 0.0) return 1;
    for (int32_t j = first_potential(at); j < n_composites(at); j++)
        if (is_force(at, j) || which == ON_QUANTITIES) return 1;
    return 0;
}

/* Adds to momentum the change of these forces in the motion x of quantities, or of rates. */
static int32_t add_changes(const context *at, enum dependence which, const double *x)
{
    int32_t status = add_forces_of_elements(at, coefficients_at(at, which), x);
    if (!status && which == ON_QUANTITIES) status = add_forces_of_potentials(at, x);
    return status ? status
                  : add_changes_of_forces(at, x, which == ON_QUANTITIES ? LEAF_VALUE : LEAF_RATE);
}

/* Largest eigenvalue of M^-1 K along the rows, by powers of it: K of springs, of the second
   derivatives of potentials and of those of forces N by quantities, or of dampers and those of
   forces N by rates. */
static double largest_rate(const context *at, enum dependence which)
{
    double *x = at->k.ahead, rate = 0.0, last = INFINITY, size;
    uint32_t random = 1;
    if (!has_forces_that_depend(at, which)) return 0.0;
    for (int32_t k = 0; k < DIM * at->n_moving; k++)
        at->k.momentum[k] = (double)(random = 1664525u * random + 1013904223u) - 2147483648.0;
    respond(at, x);
    size = mass_norm(at, x);
    for (int i = 0; i < MOST_POWERS && size > 0.0 && !(fabs(rate - last) <= CLOSE * rate); i++) {
        const double before = size;
        memset(at->k.momentum, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
        if (add_changes(at, which, x)) return INFINITY;
        respond(at, x);
        size = mass_norm(at, x);
        last = rate;
        rate = size / before;
    }
    return rate;
}

/* How fast springs answer to the velocities [1/s]: they may be about to swing while no acceleration
   tells it yet. */
HM_SELDOM static double rate_of_springs(const context *c)
{
    context at = rows_at_state(c);
    const double speed = mass_norm(c, c->s.v);
    take_unknowns(&at);
    if (!(speed > 0.0) || factorise_here(&at)) return 0.0;
    clear_nodes(&at, at.k.momentum);
    if (add_forces_of_elements(&at, c->m->stiffness_at, c->s.v)) return 0.0;
    respond(&at, at.k.ahead);
    return sqrt(mass_norm(c, at.k.ahead) / speed);
}

/* Longest step [s] that resolves springs, potentials and dampers at the state, but for what their
   tension does, by its factors; 0 with stiff dampers. */
HM_SELDOM static double longest_explicit(const context *at)
{
    const double springs = largest_rate(at, ON_QUANTITIES);
    const double dampers = largest_rate(at, ON_RATES);
    if (dampers > STIFF * rate_of_motion(at)) return 0.0;
    const double rate = hm_hypot(sqrt(springs) / SPRING_TURN, dampers / DAMPER_WAY);
    return rate < INFINITY ? 1.0 / fmax(1e-300, rate) : 0.0; /* finite: a state keeps it */
}

#endif
