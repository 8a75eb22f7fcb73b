/* Factors of a body together with the joint that carries it (articulated bodies: Featherstone
   1983).

   A group of 9 + a pivots is the turn of a body b (3), its place (3), three rows of a coincidence
   and a rows of axes, a <= 3. The other body of the joint, if it is not the ground, comes first
   among the later places X, turn and place:

       [ A     U    J_m' ] [ x_b ]   [ r ]      J:  s (dr_b + dtheta_b x arm - dr - dtheta x (arm +
   reach)) = c_0, [ L     .    .    ] [ X   ] = [ . ]          g_k . (dtheta_b - dtheta) = c_k, [ J
   .    0    ] [ mu  ]   [ c ]

   s = 1 or -1. All that the joint allows is x_b = T X + S q + e, and what its forces do no work on
   is the same with arms and directions g in the middle, T_m and S_m. With the equation S_m' (A x_b
   + U X) = S_m' r of 3 - a unknowns, x_b and mu drop out, and X gets

       (L + T_m' A) T + T_m' U - (L S + T_m' A S) K (S_m' U + S_m' A T),     K = (S_m' A S)^-1.

   A group has p = 9 + a pivots, f = 3 - a free directions and m later places, an even number;
   `has_parent` is 1 where the other body moves. The compliance epsilon of its rows is left out:
   they are independent, and it is some 1e-8 of the rest. Their residuals have it, so that a
   solution has its effect after one increment more. */
#ifndef HOLONOM_ARTICULATED_H
#define HOLONOM_ARTICULATED_H

#include "internal.h"
#include "lanes.h"
#include "vectors.h"

#include <math.h>
#include <string.h>

/* What solutions read, in the place of the joint's rows; behind it K (f x f), and of joints with
   axes their duals at the end and in the middle (3 x 3 each). The last entry of these rows stays 0,
   see lu_ptr. */
typedef struct joint_motion {
    double sign, rate; /* s, and 1/(h s): multiplier of a row over its force */
    double arm[2][3], reach[2][3];
} joint_motion;

enum { OF_END, OF_MIDDLE };

#define KEPT(a) (sizeof(joint_motion) / sizeof(double) + (3 - (a)) * (3 - (a)) + ((a) ? 18 : 0))
_Static_assert(KEPT(0) < 3 * 9 && KEPT(1) < 4 * 10 && KEPT(2) < 5 * 11 && KEPT(3) < 6 * 12,
               "fits rows 6 .. of D, less the last entry");

HM_OFTEN void keep_joint(const int a, const joint_motion *x, const double *axis, const double *K,
                         double *kept)
{
    const int of_K = (3 - a) * (3 - a);
    memcpy(kept, x, sizeof *x);
    memcpy(kept + sizeof *x / sizeof(double), K, sizeof(double) * (size_t)of_K);
    if (a) memcpy(kept + sizeof *x / sizeof(double) + of_K, axis, sizeof(double) * 18);
}

static inline const double *inverse_of(const joint_motion *x)
{ return (const double *)(const void *)(x + 1); }

/* The a directions dual to g, and free ones. */
static inline const double *axes_at(const int a, const joint_motion *x, int at)
{
    return inverse_of(x) + (3 - a) * (3 - a) + 9 * at;
}

/* a . b of six components. */
HM_OFTEN double product(const double *a, const double *b)
{
    lanes sum = lanes_times(lanes_at(a), lanes_at(b));
    for (int k = 2; k < BODY_UNKNOWNS; k += 2)
        sum = lanes_plus(sum, lanes_at(a + k), lanes_at(b + k));
    return LANE(sum, 0) + LANE(sum, 1);
}

/* The basis x dual to g. Returns 1 if g lies in a plane. */
static int dual_basis(const double *g, double *x)
{
    cross_product(g + 3, g + 6, x);
    const double volume = dot(g, x), scale = 1.0 / volume;
    if (!(fabs(volume) > 1e-300 && fabs(volume) < 1e300)) return 1;
    cross_product(g + 6, g, x + 3);
    cross_product(g, g + 3, x + 6);
    for (int i = 0; i < 9; i++) x[i] *= scale;
    return 0;
}

/* Completes a directions g to a basis, and takes its dual one; without any they are those of
   space. */
HM_OFTEN int free_axes(const int a, double *g, double *x)
{
    for (int i = 0; i < 9 && !a; i++) x[i] = i % 4 == 0;
    if (!a) return 0;
    if (a == 1) {
        const double size[3] = {fabs(g[0]), fabs(g[1]), fabs(g[2])};
        const int least =
            size[0] < size[1] ? (size[0] < size[2] ? 0 : 2) : (size[1] < size[2] ? 1 : 2);
        for (int k = 0; k < 3; k++) g[6 + k] = k == least;
        cross_product(g, g + 6, g + 3);
    }
    if (a < 3) cross_product(g, g + 3, g + 6);
    return dual_basis(g, x);
}

/* Motions S (f x 6) along free directions: the turn, and what it does to the place. */
HM_OFTEN void free_motions(const int a, const double *arm, const double *axis,
                           double S[3][BODY_UNKNOWNS])
{
    for (int k = 0; k < 3 - a; k++) {
        for (int i = 0; i < 3; i++) S[k][i] = axis[3 * (a + k) + i];
        cross_product(arm, S[k], S[k] + 3);
    }
}

/* The geometry of a joint, from its rows in D, U and L: entries of the matrices of cross products
   with s and h s times the arms, the other body's with the opposite sign. */
HM_OFTEN joint_motion read_joint(const int p, int32_t has_parent, const double *D, const double *U,
                                 const double *L)
{
    const double s = D[6 * p + 3], r = 1.0 / D[3 * p + 6], *theta0 = U, *theta2 = U + 2 * p,
                 *of0 = L, *of1 = L + 1;
    joint_motion x = {s,
                      r,
                      {{s * D[7 * p + 2], -s * D[6 * p + 2], s * D[6 * p + 1]},
                       {-r * D[p + 8], r * D[8], -r * D[7]}},
                      {{0.0}}};
    if (has_parent) {
        x.reach[OF_END][0] = -s * theta2[2 * 7] - x.arm[OF_END][0];
        x.reach[OF_END][1] = s * theta2[2 * 6] - x.arm[OF_END][1];
        x.reach[OF_END][2] = -s * theta0[2 * 6 + 1] - x.arm[OF_END][2];
        x.reach[OF_MIDDLE][0] = r * of1[2 * 8] - x.arm[OF_MIDDLE][0];
        x.reach[OF_MIDDLE][1] = -r * of0[2 * 8] - x.arm[OF_MIDDLE][1];
        x.reach[OF_MIDDLE][2] = r * of0[2 * 7] - x.arm[OF_MIDDLE][2];
    }
    return x;
}

/* Directions of the joint at the end or in the middle, from its rows, and their dual and free
   axes. */
HM_OFTEN int read_axes(const int a, const double *D, int at, double *axis)
{
    const int p = 9 + a;
    double g[9];
    for (int k = 0; k < a; k++)
        for (int i = 0; i < 3; i++)
            g[3 * k + i] = at == OF_END ? D[(9 + k) * p + i] : D[i * p + 9 + k];
    return free_axes(a, g, axis);
}

/* K (f x f) becomes its inverse. Returns 1 if it is singular. */
HM_OFTEN int invert(const int f, double *K)
{
    double whole[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, x[9];
    if (f == 1) {
        if (!(fabs(K[0]) > 1e-300 && fabs(K[0]) < 1e300)) return 1;
        K[0] = 1.0 / K[0];
        return 0;
    }
    for (int i = 0; i < f; i++)
        for (int k = 0; k < f; k++) whole[3 * i + k] = K[f * i + k];
    if (f && dual_basis(whole, x)) return 1;
    for (int i = 0; i < f; i++)
        for (int k = 0; k < f; k++) K[f * i + k] = x[3 * k + i];
    return 0;
}

/* T' of two wrenches side by side, 6 lanes: their torques get reach x force. The reach at the end
   makes T, that in the middle T_m. */
HM_OFTEN void carry_two(const double *reach, lanes *x)
{
    const lanes a = both_lanes(reach[0]), b = both_lanes(reach[1]), c = both_lanes(reach[2]);
    x[0] = lanes_less(lanes_plus(x[0], b, x[5]), c, x[4]);
    x[1] = lanes_less(lanes_plus(x[1], c, x[3]), a, x[5]);
    x[2] = lanes_less(lanes_plus(x[2], a, x[4]), b, x[3]);
}

/* Likewise of one row, of 3 lanes. */
HM_OFTEN void carry_row(const double *reach, lanes *x)
{
    const double force[3] = {LANE(x[1], 1), LANE(x[2], 0), LANE(x[2], 1)};
    double turn[3];
    cross_product(reach, force, turn);
    x[0] = lanes_sum(x[0], lanes_of(turn[0], turn[1]));
    x[1] = lanes_sum(x[1], lanes_of(turn[2], 0.0));
}

/* P = T_m' (U + A T) + L T of the other body, 6 rows of 3 lanes. */
HM_OFTEN void carry_inertia(const int p, const joint_motion *x, const double *D, const double *U,
                            const double *L, lanes P[BODY_UNKNOWNS][3])
{
    for (int i = 0; i < BODY_UNKNOWNS; i++) {
        for (int k = 0; k < 3; k++) P[i][k] = lanes_at(D + p * i + 2 * k);
        carry_row(x->reach[OF_END], P[i]);
        for (int k = 0; k < 3; k++) P[i][k] = lanes_sum(P[i][k], lanes_at(U + 2 * (p * k + i)));
    }
    for (int k = 0; k < 3; k++) {
        lanes column[BODY_UNKNOWNS];
        for (int i = 0; i < BODY_UNKNOWNS; i++) column[i] = P[i][k];
        carry_two(x->reach[OF_MIDDLE], column);
        for (int i = 0; i < 3; i++) P[i][k] = column[i];
    }
    for (int i = 0; i < BODY_UNKNOWNS; i += 2) {
        lanes rows[BODY_UNKNOWNS];
        for (int k = 0; k < BODY_UNKNOWNS; k++) rows[k] = lanes_at(L + p * i + 2 * k);
        carry_two(x->reach[OF_END], rows);
        for (int k = 0; k < 3; k++) {
            P[i][k] = lanes_sum(P[i][k], lanes_of(LANE(rows[2 * k], 0), LANE(rows[2 * k + 1], 0)));
            P[i + 1][k] =
                lanes_sum(P[i + 1][k], lanes_of(LANE(rows[2 * k], 1), LANE(rows[2 * k + 1], 1)));
        }
    }
}

/* V = S_m' (U + A T) in the place of rows 6 .. of U, and W = (L + T_m' A) S K in that of L; both
   lie behind D. */
HM_OFTEN int free_factors(const int a, int32_t m, int32_t has_parent, const joint_motion *x,
                          const double *axis, double *D, double *K)
{
    const int f = 3 - a, p = 9 + a;
    double *const U = D + p * p, *const L = U + p * m;
    double S[3][BODY_UNKNOWNS], Sm[3][BODY_UNKNOWNS];
    lanes Y[3][3], Z[3][3];
    free_motions(a, x->arm[OF_END], axis, S);
    free_motions(a, x->arm[OF_MIDDLE], axis + 9, Sm);
    for (int k = 0; k < f; k++) {
        for (int i = 0; i < BODY_UNKNOWNS; i += 2)
            Y[k][i / 2] = lanes_of(product(D + p * i, S[k]), product(D + p * (i + 1), S[k]));
        for (int j = 0; j < 3; j++) {
            Z[k][j] = both_lanes(0.0);
            for (int i = 0; i < BODY_UNKNOWNS; i++)
                Z[k][j] = lanes_plus(Z[k][j], both_lanes(Sm[k][i]), lanes_at(D + p * i + 2 * j));
        }
    }
    for (int i = 0; i < f; i++)
        for (int k = 0; k < f; k++) {
            lanes sum = both_lanes(0.0);
            for (int j = 0; j < 3; j++) sum = lanes_plus(sum, lanes_at(Sm[i] + 2 * j), Y[k][j]);
            K[f * i + k] = LANE(sum, 0) + LANE(sum, 1);
        }
    if (invert(f, K)) return 1;
    for (int k = 0; k < f && has_parent; k++) {
        carry_row(x->reach[OF_END], Z[k]);
        carry_row(x->reach[OF_MIDDLE], Y[k]);
    }
    for (int32_t i = 0; i < m; i += 2) {
        double *u = U + p * i, *l = L + p * i;
        lanes w[3];
        for (int k = 0; k < f; k++) {
            const int of_other = has_parent && i < BODY_UNKNOWNS;
            lanes v = of_other ? Z[k][i / 2] : both_lanes(0.0);
            w[k] = of_other ? Y[k][i / 2] : both_lanes(0.0);
            for (int j = 0; j < BODY_UNKNOWNS; j++) {
                v = lanes_plus(v, both_lanes(Sm[k][j]), lanes_at(u + 2 * j));
                w[k] = lanes_plus(w[k], both_lanes(S[k][j]), lanes_at(l + 2 * j));
            }
            put_lanes(u + 2 * (BODY_UNKNOWNS + k), v);
        }
        for (int k = 0; k < f; k++) {
            lanes sum = lanes_times(w[0], both_lanes(K[k]));
            for (int j = 1; j < f; j++) sum = lanes_plus(sum, w[j], both_lanes(K[f * j + k]));
            put_lanes(l + 2 * (BODY_UNKNOWNS + k), sum);
        }
    }
    return 0;
}

/* x[place] += two numbers. */
HM_OFTEN void add_two(lanes sum, const int32_t *place, double *x)
{
    x[place[0]] += LANE(sum, 0);
    x[place[1]] += LANE(sum, 1);
}

/* Adds P - W V to the matrix of the other body; `target` has m x m places of the later ones. */
HM_OFTEN void add_to_other(const int f, int32_t m, lanes P[BODY_UNKNOWNS][3], const double *U,
                           const int32_t *target, double *value)
{
    const int p = 12 - f;
    const double *L = U + p * m;
    for (int i = 0; i < BODY_UNKNOWNS; i++, target += m)
        for (int k = 0; k < 3; k++) {
            lanes sum = P[i][k];
            for (int j = 0; j < f; j++)
                sum = lanes_less(sum, both_lanes(L[2 * (p * (i / 2) + BODY_UNKNOWNS + j) + i % 2]),
                                 lanes_at(U + 2 * (p * k + BODY_UNKNOWNS + j)));
            add_two(sum, target + 2 * k, value);
        }
}

/* Adds T_m' U - W V, L T - W V or -W V for pairs of later places that are not both of the other
   body, of which the `first` are. */
HM_SELDOM static void add_to_others(int f, int32_t m, int32_t first, const joint_motion *x,
                                    const double *U, const int32_t *target, double *value)
{
    const int p = 12 - f;
    const double *L = U + p * m;
    for (int32_t i = 0; i < m; i++)
        for (int32_t k = i < first ? first : 0; k < m; k += 2) {
            const double *u = U + p * k, *l = L + p * (i - i % 2) + i % 2;
            lanes column[BODY_UNKNOWNS], sum = both_lanes(0.0);
            if (i < first) {
                for (int j = 0; j < BODY_UNKNOWNS; j++) column[j] = lanes_at(u + 2 * j);
                carry_two(x->reach[OF_MIDDLE], column);
                sum = column[i];
            } else if (k < first) {
                for (int j = 0; j < BODY_UNKNOWNS; j++) column[j] = both_lanes(l[2 * j]);
                carry_two(x->reach[OF_END], column);
                sum = lanes_of(LANE(column[k], 0), LANE(column[k + 1], 0));
            }
            for (int j = 0; j < f; j++)
                sum = lanes_less(sum, both_lanes(l[2 * (BODY_UNKNOWNS + j)]),
                                 lanes_at(u + 2 * (BODY_UNKNOWNS + j)));
            add_two(sum, target + m * i + k, value);
        }
}

/* Matrix in, factors out. Returns 1 if it is singular. */
HM_OFTEN int factor_joint(const int a, int32_t m, int32_t has_parent, double *D,
                          const int32_t *target, double *value)
{
    const int p = 9 + a, first = has_parent ? BODY_UNKNOWNS : 0;
    double *const U = D + p * p, *const L = U + p * m, axis[18], K[9];
    lanes P[BODY_UNKNOWNS][3];
    const joint_motion x = read_joint(p, has_parent, D, U, L);
    if (read_axes(a, D, OF_END, axis) || read_axes(a, D, OF_MIDDLE, axis + 9)) return 1;
    if (has_parent) carry_inertia(p, &x, D, U, L, P);
    if (free_factors(a, m, has_parent, &x, axis, D, K)) return 1;
    if (has_parent) add_to_other(3 - a, m, P, U, target, value);
    if (m > first) add_to_others(3 - a, m, first, &x, U, target, value);
    keep_joint(a, &x, axis, K, D + BODY_UNKNOWNS * p);
    D[p * p - 1] = 0.0;
    return 0;
}

/* sum q_k of the free axes. */
HM_OFTEN void free_turn(const int a, const double *axis, const double *q, double *turn)
{
    for (int i = 0; i < 3; i++) {
        turn[i] = a ? 0.0 : q[i];
        for (int k = 0; k < 3 - a && a; k++) turn[i] += q[k] * axis[3 * (a + k) + i];
    }
}

/* S_m' of a wrench x. */
HM_OFTEN void free_forces(const int a, const double *arm, const double *axis, const double *x,
                          double *force)
{
    double torque[3];
    cross_product(arm, x + 3, torque);
    for (int i = 0; i < 3; i++) torque[i] = x[i] - torque[i];
    for (int k = 0; k < 3 - a; k++) force[k] = a ? dot(axis + 3 * (a + k), torque) : torque[k];
}

/* e: a motion of the body that meets the right-hand sides c of its rows while the other one
   rests. */
HM_OFTEN void particular_motion(const int a, const joint_motion *x, const double *c, double *e)
{
    double across[3];
    for (int i = 0; i < 3; i++) {
        e[i] = 0.0;
        e[3 + i] = x->sign * c[i];
        for (int k = 0; k < a; k++) e[i] += c[3 + k] * axes_at(a, x, OF_END)[3 * k + i];
    }
    if (!a) return;
    cross_product(x->arm[OF_END], e, across);
    for (int i = 0; i < 3; i++) e[3 + i] += across[i];
}

/* y -= A x. */
HM_OFTEN void subtract_motion(const int p, const double *D, const double *x, double *y)
{
    for (int i = 0; i < BODY_UNKNOWNS; i++) y[i] -= product(D + p * i, x);
}

/* y: own right-hand sides r and c; r becomes r - A e. The right-hand sides x of later places
   change. */
HM_OFTEN void reduce_joint(const int a, int32_t m, int32_t has_parent, const double *D,
                           const int32_t *column, double *y, double *x)
{
    const int f = 3 - a, p = 9 + a;
    const double *l = D + p * p + p * m;
    const joint_motion *joint = (const joint_motion *)(const void *)(D + BODY_UNKNOWNS * p);
    double e[BODY_UNKNOWNS], across[3], force[3];
    particular_motion(a, joint, y + BODY_UNKNOWNS, e);
    subtract_motion(p, D, e, y);
    free_forces(a, joint->arm[OF_MIDDLE], axes_at(a, joint, OF_MIDDLE), y, force);
    if (has_parent) {
        cross_product(joint->reach[OF_MIDDLE], y + 3, across);
        for (int k = 0; k < 3; k++) {
            x[column[k]] += across[k] + y[k];
            x[column[3 + k]] += y[3 + k];
        }
    }
    for (int32_t i = 0; i < m; i += 2, l += 2 * p) {
        lanes sum = lanes_times(both_lanes(e[0]), lanes_at(l));
        for (int k = 1; k < BODY_UNKNOWNS; k++)
            sum = lanes_plus(sum, both_lanes(e[k]), lanes_at(l + 2 * k));
        for (int k = 0; k < f; k++)
            sum = lanes_plus(sum, both_lanes(force[k]), lanes_at(l + 2 * (BODY_UNKNOWNS + k)));
        x[column[i]] -= LANE(sum, 0);
        x[column[i + 1]] -= LANE(sum, 1);
    }
}

/* y: motion of the body, then its multipliers, from the solution x of later places. */
HM_OFTEN void solve_joint(const int a, int32_t m, int32_t has_parent, const double *D,
                          const int32_t *column, double *y, const double *x)
{
    const int f = 3 - a, p = 9 + a;
    const double *u = D + p * p;
    const joint_motion *joint = (const joint_motion *)(const void *)(D + BODY_UNKNOWNS * p);
    const double *K = inverse_of(joint), *axis = axes_at(a, joint, OF_END),
                 *axis_m = axes_at(a, joint, OF_MIDDLE);
    double e[BODY_UNKNOWNS], own[BODY_UNKNOWNS], q[3] = {0.0}, left[3], across[3],
                                                 other[BODY_UNKNOWNS] = {0.0};
    lanes wrench[BODY_UNKNOWNS], force[3];
    particular_motion(a, joint, y + BODY_UNKNOWNS, e);
    free_forces(a, joint->arm[OF_MIDDLE], axis_m, y, left);
    for (int k = 0; k < f; k++) force[k] = lanes_of(left[k], 0.0);
    for (int k = 0; k < BODY_UNKNOWNS; k++) wrench[k] = both_lanes(0.0);
    for (int32_t i = 0; i < m; i += 2, u += 2 * p) {
        const lanes later = lanes_of(x[column[i]], x[column[i + 1]]);
        for (int k = 0; k < BODY_UNKNOWNS; k++)
            wrench[k] = lanes_plus(wrench[k], later, lanes_at(u + 2 * k));
        for (int k = 0; k < f; k++)
            force[k] = lanes_less(force[k], later, lanes_at(u + 2 * (BODY_UNKNOWNS + k)));
    }
    for (int i = 0; i < f; i++)
        for (int k = 0; k < f; k++) q[i] += K[f * i + k] * (LANE(force[k], 0) + LANE(force[k], 1));
    free_turn(a, axis, q, own);
    cross_product(joint->arm[OF_END], own, own + 3);
    for (int k = 0; k < BODY_UNKNOWNS && has_parent; k++) other[k] = x[column[k]];
    cross_product(other, joint->reach[OF_END], across);
    for (int k = 0; k < 3; k++) {
        own[k] += other[k];
        own[3 + k] += other[3 + k] + across[k];
    }
    for (int k = 0; k < BODY_UNKNOWNS; k++) y[k] -= LANE(wrench[k], 0) + LANE(wrench[k], 1);
    subtract_motion(p, D, own, y);
    cross_product(joint->arm[OF_MIDDLE], y + 3, across);
    for (int k = 0; k < 3; k++) {
        across[k] = y[k] - across[k];
        y[BODY_UNKNOWNS + k] = joint->rate * y[3 + k];
    }
    for (int k = 0; k < a; k++) y[9 + k] = dot(axis_m + 3 * k, across);
    for (int k = 0; k < BODY_UNKNOWNS; k++) y[k] = own[k] + e[k];
}

/* Hinges, which chains and robots are made of, have functions of their own. */
#define HINGE 2

HM_SELDOM static int factor_other_joint(int a, int32_t m, int32_t has_parent, double *D,
                                        const int32_t *target, double *value)
{
    return factor_joint(a, m, has_parent, D, target, value);
}

HM_SELDOM static void reduce_other_joint(int a, int32_t m, int32_t has_parent, const double *D,
                                         const int32_t *column, double *y, double *x)
{
    reduce_joint(a, m, has_parent, D, column, y, x);
}

HM_SELDOM static void solve_other_joint(int a, int32_t m, int32_t has_parent, const double *D,
                                        const int32_t *column, double *y, const double *x)
{
    solve_joint(a, m, has_parent, D, column, y, x);
}

#endif
