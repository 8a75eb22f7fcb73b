/* How fast springs and dampers move a mechanism: what an explicit step can resolve (theory 8.8). */
#ifndef HOLONOM_FORCE_RATES_H
#define HOLONOM_FORCE_RATES_H

#include "context.h"
#include "norms.h"
#include "put_back.h"
#include "start.h"
#include "tangent.h"

/* Turn of a spring's motion, and way of a damper's, over its time constant, in an explicit step. The method is stable to 5.8
   and 6.4 (Hairer, Norsett and Wanner 1993, II.10); springs that move so far shorten steps by their errors first.
   Powers come near the largest eigenvalue from below. */
#define SPRING_TURN 5.0
#define DAMPER_WAY 4.0

#define STIFF 100.0 /* rate of a damper over that of the motion: beyond, covers let it settle within a step */

enum { MOST_POWERS = 10 };
#define CLOSE 0.02 /* change of a rate by a power, of it, after which no more are taken */

/* x (n, overwritten) = -M^-1 of the forces in momentum, along the rows. */
static void respond(const context *at, double *x)
{
    clear_bodies(at, at->k.torque, TURNING);
    if (is_reduced(at)) reduce_momentum(at);
    gather_momentum(at);
    EACH_ROW(at, i) at->k.rhs[at->lu->row_position[i]] = 0.0;
    solve_factors(at);
    memset(x, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
    add_solution(at, x);
}

/* Largest eigenvalue of M^-1 K along the rows, by powers of it. */
static double largest_rate(const context *at, int64_t coefficient_at)
{
    double *x = at->k.ahead, rate = 0.0, last = INFINITY, size;
    uint32_t random = 1;
    int32_t j = 0;
    while (j < at->m->n_elements && at->number[coefficient_at + j] == 0.0) j++;
    if (j == at->m->n_elements) return 0.0;
    for (int32_t k = 0; k < DIM * at->n_moving; k++)
        at->k.momentum[k] = (double)(random = 1664525u * random + 1013904223u) - 2147483648.0;
    respond(at, x);
    size = mass_norm(at, x);
    for (int i = 0; i < MOST_POWERS && size > 0.0 && !(fabs(rate - last) <= CLOSE * rate); i++) {
        const double before = size;
        memset(at->k.momentum, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
        if (add_forces_of_elements(at, coefficient_at, x)) return INFINITY;
        respond(at, x);
        size = mass_norm(at, x);
        last = rate;
        rate = size / before;
    }
    return rate;
}

/* How fast springs answer to the velocities [1/s]: they may be about to swing while no acceleration tells it yet. */
HM_SELDOM static double rate_of_springs(const context *c)
{
    context at = rows_at_state(c, 0.0);
    const double speed = mass_norm(c, c->s.v);
    take_unknowns(&at);
    if (!(speed > 0.0) || factorise_here(&at)) return 0.0;
    clear_nodes(&at, at.k.momentum);
    if (add_forces_of_elements(&at, c->m->stiffness_at, c->s.v)) return 0.0;
    respond(&at, at.k.ahead);
    return sqrt(mass_norm(c, at.k.ahead) / speed);
}

/* Longest step [s] that resolves springs and dampers at the state, but for what their tension does, by its factors; 0 with stiff
   dampers, and with potentials, which do not tell how fast they are. */
HM_SELDOM static double longest_explicit(const context *at)
{
    if (at->m->n_potentials) return 0.0;
    const double springs = largest_rate(at, at->m->stiffness_at), dampers = largest_rate(at, at->m->damping_at);
    if (dampers > STIFF * rate_of_motion(at)) return 0.0;
    const double rate = hm_hypot(sqrt(springs) / SPRING_TURN, dampers / DAMPER_WAY);
    return rate < INFINITY ? 1.0 / fmax(1e-300, rate) : 0.0; /* finite: a state keeps it */
}

#endif
