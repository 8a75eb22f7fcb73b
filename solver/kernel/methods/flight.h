/* What flies: its energy is brought back by a turn, since its momenta determine all velocities. */
#ifndef HOLONOM_FLIGHT_H
#define HOLONOM_FLIGHT_H

#include "kept_motion.h"

#define LARGEST_TURN_BACK 0.1 /* rad */

#if DIM == 3
/* Turns the island at hand, places and velocities, by the rotation vector psi about its centre.
   Returns how far, in the mass norm. */
HM_SELDOM static double turn_island(context *c, const kept_motion *x, const double *psi)
{
    const double theta = sqrt(dot(psi, psi)), half = hm_sin(0.5 * theta),
                 sine = hm_sin(theta) / theta, bend = 2.0 * half * half / (theta * theta);
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
        EACH(k)
            hm_add(c->s.v + DIM * a + k, c->s.v_low + DIM * a + k,
                   sine * once[k] + bend * twice[k]);
    }
    return sqrt(mass_product(c, moved, moved));
}

/* Turns a body that flies alone, places and velocities, so that its angular momentum points where
   it is to: an error of a rod's axis would else become spin about it, which has hardly any
   inertia. */
HM_SELDOM static void turn_to_momentum(context *c, kept_motion *x)
{
    int keeps = x->flies && c->view.node.end - c->view.node.begin == 1 + TURNING;
    double now[RIGID], size[RIGID], psi[DIM];
    for (int i = 0; i < RIGID; i++) keeps &= x->kept[i];
    if (!keeps) return;
    momenta_now(c, x, now, size);
    cross_product(now + DIM, x->before + DIM, psi);
    const double product = sqrt(dot(now + DIM, now + DIM) * dot(x->before + DIM, x->before + DIM)),
                 sine2 = dot(psi, psi);
    if (!(sine2 > 0.0 && sine2 <= hm_square(LARGEST_TURN_BACK * product))) return;
    EACH(k) psi[k] /= product;
    turn_island(c, x, psi);
}

#define ALIKE                                                                                      \
    1e-12 /* relative difference of principal inertias that are the same but for round-off */

/* Turns the axes of an inertia (modified), and of a vector l (modified), to the principal ones
   (Jacobi's rotations). */
HM_SELDOM static void to_principal_axes(double inertia[3][3], double *l)
{
    for (int turn = 0; turn < 15; turn++) {
        const int p = turn % 3, q = (p + 1) % 3, r = (p + 2) % 3;
        const double product = inertia[p][q], half = 0.5 * (inertia[q][q] - inertia[p][p]),
                     bent = inertia[p][r], along = l[p];
        if (product == 0.0) continue;
        const double tangent = product / (half + copysign(hm_hypot(half, product), half));
        const double cosine = 1.0 / hm_hypot(1.0, tangent), sine = tangent * cosine;
        inertia[p][p] -= tangent * product;
        inertia[q][q] += tangent * product;
        inertia[p][q] = inertia[q][p] = 0.0;
        inertia[p][r] = inertia[r][p] = cosine * bent - sine * inertia[q][r];
        inertia[q][r] = inertia[r][q] = sine * bent + cosine * inertia[q][r];
        l[p] = cosine * along - sine * l[q];
        l[q] = sine * along + cosine * l[q];
    }
}

/* How many times larger an error along the path of a rigid body grows that flies with the angular
   momentum l. It moves on as fast as l does in the body, g^2 = sum (a_i - a_j)^2 l_i^2 l_j^2, and
   fastest with g^2 = (a_1 l^2 - 2T)(2T - a_3 l^2), a_1 > a_2 > a_3 the eigenvalues of I^-1 and T
   its energy: far faster than now if it turns about nearly its middle axis. Differences are taken
   before they are weighed: l has no component but round-off along a rod, whose a_1 is huge. */
HM_SELDOM static double growth_of_errors(double L[RIGID][RIGID], const double *l)
{
    double inertia[3][3] = {{0.0}}, own[3] = {l[0], l[1], l[2]}, below[3] = {0.0}, now2 = 0.0,
           fastest2 = 0.0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) inertia[i][j] = dot(L[DIM + i] + DIM, L[DIM + j] + DIM);
    to_principal_axes(inertia, own);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double a = inertia[i][i], b = inertia[j][j],
                         less = fabs(a - b) > ALIKE * (a + b) ? 1.0 / a - 1.0 / b : 0.0;
            below[i] += less * own[j] * own[j];
            now2 += 0.5 * hm_square(less * own[i] * own[j]);
        }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) fastest2 = fmax(fastest2, -below[i] * below[j]);
    return fastest2 > now2 && now2 > 0.0 ? sqrt(fastest2 / now2) : 1.0;
}
#endif

/* Brings the energy of what flies onto the ledger by a turn of all of it along the gradient of its
   kinetic energy at fixed angular momentum l, g = omega x l: a turn s g changes it by |g|^2 s +
   (a'I^-1 a - omega . (g x a)) s^2/2, a = g x l. Returns whether it could be done. */
HM_SELDOM static int balance_by_turning(context *c, kept_motion *x, double L[RIGID][RIGID],
                                        double potential)
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
        if (i == 0) x->growth = fmax(x->growth, growth_of_errors(L, l));
        if (fabs(excess) <= LEDGER_ROUND_OFF * sizes_of_summands(c, x)) break;
        cross_product(g, l, a);
        cross_product(g, a, bend);
        EACH(k) answer[DIM + k] = a[k];
        solve_rigid(L, answer);
        const double slope = dot(g, g), curve = dot(a, answer + DIM) - dot(omega + DIM, bend);
        if (hm_square(slope) <= fabs(2.0 * curve * excess) && is_round_off(c, x, excess))
            break; /* it spins steadily: g is round-off */
        const double s = -2.0 * excess / (slope + sqrt(slope * slope - 2.0 * curve * excess));
        if (!(fabs(s) * sqrt(slope) <= LARGEST_TURN_BACK)) return 0;
        EACH(k) psi[k] = s * g[k];
        x->correction =
            fmax(x->correction, turn_island(c, x, psi) / c->number[c->m->extent_at + 1]);
        put_momenta_back(c, x, L);
        potential = potential_of_island(c);
    }
    c->view.scalars[I_UNBALANCED] = unbalanced(c, x, potential);
    return keeps;
#else
    (void)c, (void)x, (void)L, (void)potential;
    return 0;
#endif
}

#endif
