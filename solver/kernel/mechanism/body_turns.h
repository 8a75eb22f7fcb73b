/* Turns of rigid bodies in a step, the unknowns of their directors (theory 9.6).

   With theta = h omega + turn and t = theta/2 the directors of a body go to

       d_i + Delta d_i,     Delta d_i = theta x m_i,     m_i = (d_i + t x d_i + t (t . d_i))/(1 +
   t^2),

   m_i in the middle of both ends (Cayley). They stay orthonormal; and since the vectors theta x m_i
   are all that the rows of rigidity leave free there, these drop out of the step, and the balance
   of momentum of the directors becomes that of the torques m_i x p_i. In the plane t x is a quarter
   turn, times a number.

   The velocities v_i of directors need not be those of a turn: v_i = omega x d_i + n_i, with

       w_i = Delta d_i - h v_i = turn x d_i + t x Delta d_i - h n_i,

   all of it of the size of the forces, so that no digits are lost. Newton's unknown is the turn
   `spin` at the end, delta d_i = spin x (d_i + Delta d_i); the turn then changes by spin - t x spin
   + t (t . spin). */
#ifndef HOLONOM_BODY_TURNS_H
#define HOLONOM_BODY_TURNS_H

#include "context.h"

/* x = a x b of a turn a (TURNING) and a vector b. */
static inline void turned_by(const double *a, const double *b, double *x)
{
#if DIM == 2
    x[0] = -a[0] * b[1];
    x[1] = a[0] * b[0];
#else
    cross_product(a, b, x);
#endif
}

/* Whether a free node is a director that turns with its body. */
static inline int is_director(const context *c, int32_t node)
{ return has_turns(c) && c->m->node_kind[node]; }

/* Components of the unknown of a free node: a director has those of its body's turn. */
static inline int unknown_size(const context *c, int32_t node)
{ return is_director(c, node) ? TURNING : DIM; }

/* The free node whose unknown moves free node a. */
static inline int32_t first_of_unknown(const context *c, int32_t a)
{
    return is_director(c, a) ? a - (c->m->node_kind[a] - NODE_DIRECTION) : a;
}

/* First free node behind those that share the unknown of free node a. */
static inline int32_t next_unknown(const context *c, int32_t a)
{ return a + (is_director(c, a) ? TURNING : 1); }

/* Replaces a gradient g over a free node by that over its unknown; arms are the directors at the
   point that it is taken at. Returns its components. */
static inline int to_unknown(const context *c, int32_t node, const double *arms, double *g)
{
    if (!is_director(c, node)) return DIM;
    double own[DIM];
    EACH(k) own[k] = g[k];
    cross_product(arms + DIM * node, own, g);
    return TURNING;
}

/* Second derivative B of nodes a and b, (DIM x DIM), forces in the middle by places at the end,
   over their unknowns: x, overwritten, row by row. Returns the number of its elements. */
static int block_to_unknowns(const context *c, int32_t a, int32_t b, const double *B, double *x)
{
    const int rows = unknown_size(c, a), columns = unknown_size(c, b);
    double side[DIM][DIM];
    EACH(i) {
        EACH(k) side[i][k] = B[DIM * i + k];
        to_unknown(c, b, c->k.turned, side[i]);
    }
    for (int k = 0; k < columns; k++) {
        double g[DIM];
        EACH(i) g[i] = side[i][k];
        to_unknown(c, a, c->k.middle, g);
        for (int i = 0; i < rows; i++) x[columns * i + k] = g[i];
    }
    return rows * columns;
}

/* same I + quarter J of nodes a and b, over their unknowns; returns the number of elements. Of two
   directors that is same ((m . d) 1 - d m'), m that in the middle and d that at the end. */
HM_OFTEN int block_of_same(const context *c, int32_t a, int32_t b, double same, double quarter,
                           double *x)
{
#if DIM == 2
    const double block[4] = {same, -quarter, quarter, same};
    return block_to_unknowns(c, a, b, block, x);
#else
    const double *m = c->k.middle + 3 * a, *d = c->k.turned + 3 * b;
    (void)quarter;
    if (is_director(c, a) && is_director(c, b)) {
        const double along = same * dot(m, d);
        EACH(k) EACH(l) x[3 * k + l] = -same * d[k] * m[l];
        EACH(k) x[4 * k] += along;
        return 9;
    }
    const double block[9] = {same, 0.0, 0.0, 0.0, same, 0.0, 0.0, 0.0, same};
    return block_to_unknowns(c, a, b, block, x);
#endif
}

/* value += so many elements. */
static inline const int32_t *scatter(int n, const double *x, const int32_t *slot, double *value)
{
    for (int k = 0; k < n; k++) value[*slot++] += x[k];
    return slot;
}

/* Directors of the body with first director a, by its turn: with x = t x d and y = t x x

       Delta d = 2 (x + y)/(1 + t^2),     t x Delta d = 2 (y - t^2 x)/(1 + t^2). */
static void turn_body(const context *c, int32_t a)
{
    const double *turn = c->k.turn + DIM * a, *spun = c->k.spun + DIM * a;
    double *theta = c->k.move + DIM * a, t[TURNING], size2 = 0.0;
    for (int k = 0; k < TURNING; k++) {
        theta[k] = spun[k] + turn[k];
        t[k] = 0.5 * theta[k];
        size2 += t[k] * t[k];
    }
    const double twice = 2.0 / (1.0 + size2);
    for (int32_t at = DIM * a; at < DIM * (a + TURNING); at += DIM) {
        const double *d = c->s.q + at;
        double x[DIM], y[DIM], own[DIM];
        turned_by(t, d, x);
        turned_by(t, x, y);
        turned_by(turn, d, own);
        EACH(k) {
            const double change = twice * (x[k] + y[k]);
            c->k.d[at + k] = change;
            c->k.middle[at + k] = d[k] + c->step.theta * change;
            c->k.turned[at + k] = d[k] + change;
            c->k.w[at + k] = own[k] + twice * (y[k] - size2 * x[k]) - c->k.internal[at + k];
        }
    }
}

/* Square of a turn x of the body with first director a in the mass norm, in which all its axes are
   as heavy as the heaviest (bodies.py); of a torque with power -1. */
static double turning_norm2(const context *c, int32_t a, const double *x, int power)
{
    const double inertia = (DIM - 1) * c->number[c->m->node_mass_at + a];
    double sum = 0.0;
    for (int k = 0; k < TURNING; k++) sum += x[k] * x[k];
    return power < 0 ? sum / inertia : sum * inertia;
}

/* Changes the turn of that body by a spin at the end; what it was lies behind it. */
static void change_turn(const context *c, int32_t a, const double *spin)
{
    const double *theta = c->k.move + DIM * a;
    double *turn = c->k.turn + DIM * a;
    for (int k = 0; k < TURNING; k++) turn[TURNING + k] = turn[k];
#if DIM == 2
    turn[0] += spin[0] * (1.0 + 0.25 * theta[0] * theta[0]);
#else
    double across[3];
    const double along = 0.25 * dot(theta, spin);
    cross_product(theta, spin, across);
    EACH(k) turn[k] += spin[k] - 0.5 * across[k] + along * theta[k];
#endif
    turn_body(c, a);
}

/* Takes the last change back. */
static void undo_turn(const context *c, int32_t a)
{
    double *turn = c->k.turn + DIM * a;
    for (int k = 0; k < TURNING; k++) turn[k] = turn[TURNING + k];
    turn_body(c, a);
}

/* Parts of coordinates (x, x_low), the first of 26 digits (Veltkamp's split): products of such
   parts are exact. */
static inline void split(double x, double x_low, double *high, double *low)
{
    const double far = 134217729.0 * x; /* 2^27 + 1 */
    *high = far - (far - x);
    *low = (x - *high) + x_low;
}

/* Takes from the directors what rounding has made of them, d_i -= sum_j (d_i . d_j - delta_ij)
   d_j/2, with products to twice the digits. Turns do not bring it back, and it would grow with the
   root of the number of steps. */
static void straighten(context *c, int32_t a)
{
    double *q = c->s.q + DIM * a, *q_low = c->s.q_low + DIM * a, high[TURNING][DIM],
           low[TURNING][DIM], half[TURNING][TURNING];
    for (int i = 0; i < TURNING; i++)
        EACH(k) split(q[DIM * i + k], q_low[DIM * i + k], &high[i][k], &low[i][k]);
    for (int i = 0; i < TURNING; i++)
        for (int j = 0; j <= i; j++) {
            double sum = i == j ? -1.0 : 0.0, rest = 0.0;
            EACH(k) hm_add_exactly(&sum, &rest, high[i][k] * high[j][k]);
            EACH(k) rest += high[i][k] * low[j][k] + low[i][k] * (high[j][k] + low[j][k]);
            half[i][j] = half[j][i] = -0.5 * (sum + rest);
        }
    for (int i = 0; i < TURNING; i++)
        EACH(k) {
            double change = 0.0;
            for (int j = 0; j < TURNING; j++) change += half[i][j] * high[j][k];
            hm_add(q + DIM * i + k, q_low + DIM * i + k, change);
        }
}

/* v - omega x d to the last digit, for an omega of 24 bits: products with either half of d are
   exact. */
static void internal_velocity(const double *v, const double *v_low, const double *omega,
                              const double *d, const double *d_low, double *n)
{
    double high[DIM], low[DIM], rest[DIM];
    EACH(k) split(d[k], d_low[k], high + k, low + k);
    turned_by(omega, low, rest);
    EACH(k) {
#if DIM == 2
        const double term[1] = {k == 0 ? omega[0] * high[1] : -omega[0] * high[0]};
#else
        const double term[2] = {-omega[(k + 1) % 3] * high[(k + 2) % 3],
                                omega[(k + 2) % 3] * high[(k + 1) % 3]};
#endif
        double sum = v[k], lost = v_low[k] - rest[k];
        for (int i = 0; i < DIM - 1; i++) hm_add_exactly(&sum, &lost, term[i]);
        n[k] = sum + lost;
    }
}

/* The common turn of x_i, at the directors of the state. */
static void common_turn(const context *c, int32_t a, const double *x, double *turn)
{ turn_of_directors(c->s.q + DIM * a, x, turn); }

/* What bodies do beside turning, with the other sign, in x (n, overwritten). */
HM_SELDOM static void beside_turns(const context *c, double *x)
{
    clear_nodes(c, x);
    EACH_TURN(c, b) {
        const int32_t first = DIM * c->m->body_node[b];
        double omega[TURNING], rest[TURNING], turned[DIM];
        common_turn(c, c->m->body_node[b], c->s.v + first, omega);
        for (int k = 0; k < TURNING; k++) omega[k] = (double)(float)omega[k];
        for (int i = first; i < first + DIM * TURNING; i += DIM)
            internal_velocity(c->s.v + i, c->s.v_low + i, omega, c->s.q + i, c->s.q_low + i, x + i);
        common_turn(c, c->m->body_node[b], x + first, rest);
        for (int i = first; i < first + DIM * TURNING; i += DIM) {
            turned_by(rest, c->s.q + i, turned);
            EACH(k) x[i + k] = turned[k] - x[i + k];
        }
    }
}

/* Largest angular velocity of a body [rad/s]. */
HM_SELDOM static double fastest_turn(const context *c)
{
    double fastest = 0.0, omega[TURNING];
    for (int32_t b = 0; b < n_bodies(c->m); b++) {
        double square = 0.0;
        common_turn(c, c->m->body_node[b], c->s.v + DIM * c->m->body_node[b], omega);
        for (int k = 0; k < TURNING; k++) square += hm_square(omega[k]);
        fastest = fmax(fastest, square);
    }
    return sqrt(fastest);
}

/* Angular acceleration of a step that is solved, 2 (theta - h omega)/h^2. */
static inline double turning_of_step(const context *c, int32_t a, int k)
{
    return 2.0 / (c->h * c->h) * (c->k.turn[DIM * a + k] - c->k.spun[DIM * a + TURNING + k]);
}

/* Begins the turn of the body with first director a in a step of length h, with the angular
   acceleration that is foreseen. */
static void begin_turn(const context *c, int32_t a, const double *acceleration)
{
    const int32_t at = DIM * a;
    double omega[TURNING], rounded[TURNING], h_high,
        h_low; /* off by rounding: h omega - spun, exactly */
    split(c->h, 0.0, &h_high, &h_low);
    common_turn(c, a, c->s.v + at, omega);
    for (int k = 0; k < TURNING; k++) {
        omega[k] = (double)(float)omega[k];
        c->k.spun[at + k] = c->h * omega[k];
        rounded[k] = (h_high * omega[k] - c->k.spun[at + k]) + h_low * omega[k];
    }
    for (int i = 0; i < TURNING; i++) {
        const int32_t own = at + DIM * i;
        double *n = c->k.internal + own, turned[DIM];
        internal_velocity(c->s.v + own, c->s.v_low + own, omega, c->s.q + own, c->s.q_low + own, n);
        turned_by(rounded, c->s.q + own, turned);
        EACH(k) n[k] = c->h * n[k] + turned[k];
    }
    double *lost = c->k.spun + at + TURNING; /* of h omega, by rounding */
    common_turn(c, a, c->k.internal + at, lost);
    for (int k = 0; k < TURNING; k++)
        c->k.turn[at + k] = lost[k] + 0.5 * c->h * c->h * acceleration[k];
    turn_body(c, a);
}

/* Begins the turn of that body in a step from rest. */
HM_SELDOM static void rest_as_body(const context *c, int32_t a)
{
    for (int32_t k = DIM * a; k < DIM * (a + TURNING); k++)
        c->k.turn[k] = c->k.spun[k] = c->k.internal[k] = c->k.move[k] = 0.0;
    turn_body(c, a);
}

/* Clears so many components with the first director of each body. */
static inline void clear_bodies(const context *c, double *x, int count)
{
    EACH_TURN(c, b)
        for (int k = 0; k < count; k++) x[DIM * c->m->body_node[b] + k] = 0.0;
}

/* The balance of momentum over the unknowns: torques of bodies in the place of what acts on their
   directors, which is kept for the tangent. */
static void reduce_momentum(const context *c)
{
    EACH_TURN(c, b) {
        const int32_t at = DIM * c->m->body_node[b];
        double *p = c->k.momentum + at, *kept = c->k.nodal + at, *torque = c->k.torque + at,
               own[TURNING];
        for (int i = 0; i < TURNING; i++) {
            cross_product(c->k.middle + at + DIM * i, p + DIM * i, own);
            for (int k = 0; k < TURNING; k++) torque[k] += own[k];
        }
        for (int k = 0; k < DIM * TURNING; k++) {
            kept[k] = p[k];
            p[k] = k < TURNING ? torque[k] : 0.0;
        }
    }
}

#endif
