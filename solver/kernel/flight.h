/* What flies: its energy is brought back by a turn, since its momenta determine all velocities. */
#ifndef HOLONOM_FLIGHT_H
#define HOLONOM_FLIGHT_H

#include "kept_motion.h"

#define LARGEST_TURN_BACK 0.1 /* rad */

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
        if (!(fabs(s) * sqrt(slope) <= LARGEST_TURN_BACK)) return 0;
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

#endif
