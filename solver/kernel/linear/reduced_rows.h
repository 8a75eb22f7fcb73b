/* Forms and coincidences in the tangent: sums over each unknown, a point or the turn of a body.

   The part of a link u that a body carries, U = sum alpha d_i over its directors, turns with it:
   delta U = spin x U. So a form u . w has the gradient  U x w + W x u  over the turn of a body, and
   the second derivative

       (U . W') 1 - W' U' + (W . U') 1 - U' W'

   over those of two bodies, U and W taken in the middle, U' and W' at the end. */
#ifndef HOLONOM_REDUCED_ROWS_H
#define HOLONOM_REDUCED_ROWS_H

#include "body_turns.h"
#include "forms.h"

/* Free entries of a form with the same unknown: the parts of links that a body carries, or one
   point. */
typedef struct form_side {
    int turns;
    int32_t entry;
    double u[2][DIM], w[2][DIM]; /* in the middle, at the end */
} form_side;

static inline int is_axes_row(const context *c, int32_t i)
{ return has_turns(c) && c->m->form_kind[c->m->row_form[i]] & FORM_AXES; }

/* Entry behind those of form f with the unknown of entry e. */
HM_OFTEN int32_t behind_side(const context *c, int32_t f, int32_t e)
{
    const int32_t *node = c->m->form_node, end = c->m->form_ptr[f] + c->m->form_free[f];
    const int32_t last = next_unknown(c, first_of_unknown(c, node[e]));
    for (e++; e < end && node[e] < last; e++) continue;
    return e;
}

/* Part x of a link that directors carry, at least one: entries begin .. end - 1 with these
   coefficients. */
HM_OFTEN void carried(const context *c, int32_t begin, int32_t end, int32_t at, int32_t turn_at,
                      const double *directors, double *x)
{
    const double *factor = c->number + at;
    const int32_t *node = c->m->form_node;
    EACH(k) x[k] = factor[begin] * directors[DIM * node[begin] + k];
    for (int32_t e = begin + 1; e < end; e++)
        EACH(k) x[k] += factor[e] * directors[DIM * node[e] + k];
    for (int32_t e = begin; DIM == 2 && turn_at >= 0 && e < end; e++)
        add_turned(c->number[turn_at + e], directors + DIM * node[e], x);
}

/* The side that begins with entry e of form f; returns the entry behind it. */
static int32_t next_side(const context *c, int32_t f, int32_t e, form_side *x)
{
    const holonom_model *m = c->m;
    const int32_t end = behind_side(c, f, e), turned = m->form_kind[f] & FORM_TURNED;
    x->turns = is_director(c, m->form_node[e]);
    x->entry = e;
    if (!x->turns) return end;
    for (int at = 0; at < 2; at++) {
        const double *directors = at ? c->k.turned : c->k.middle;
        carried(c, e, end, m->alpha_at, turned ? m->alpha_turn_at : -1, directors, x->u[at]);
        carried(c, e, end, m->beta_at, turned ? m->beta_turn_at : -1, directors, x->w[at]);
    }
    return end;
}

/* Gradient of form f over a side, with its links u and w, in the middle (at = 0) or at the end;
   returns its components. */
HM_OFTEN int side_gradient(const context *c, int32_t f, const form_side *x, int at, const double *u,
                           const double *w, double *g)
{
    double other[DIM];
    if (!x->turns) {
        entry_gradient(c, f, x->entry, u, w, g);
        return DIM;
    }
    cross_product(x->u[at], w, g);
    cross_product(x->w[at], u, other);
    for (int k = 0; k < TURNING; k++) g[k] += other[k];
    return TURNING;
}

/* x += the matrix of factor times the cross product with a: TURNING x DIM, or the other way round
   and negative. */
static inline void add_cross(double factor, const double *a, int turned_back, double *x)
{
#if DIM == 2
    (void)turned_back;
    x[0] -= factor * a[1];
    x[1] += factor * a[0];
#else
    const double s = turned_back ? -factor : factor;
    x[1] -= s * a[2], x[2] += s * a[1];
    x[3] += s * a[2], x[5] -= s * a[0];
    x[6] -= s * a[1], x[7] += s * a[0];
#endif
}

/* Likewise to value; its diagonal has slots, too. */
HM_OFTEN const int32_t *scatter_cross(double factor, const double *a, const int32_t *slot,
                                      double *value)
{
#if DIM == 2
    value[slot[0]] -= factor * a[1];
    value[slot[1]] += factor * a[0];
#else
    const double x = factor * a[0], y = factor * a[1], z = factor * a[2];
    value[slot[1]] -= z, value[slot[2]] += y;
    value[slot[3]] += z, value[slot[5]] -= x;
    value[slot[6]] -= y, value[slot[7]] += x;
#endif
    return slot + DIM * TURNING;
}

/* Second derivative of form f over sides p and q, times a factor: x, overwritten, row by row;
   returns the number of its elements, or -1 if it is one number times 1, which is then x[0]. */
static int side_stiffness(const context *c, int32_t f, double factor, const form_side *p,
                          const form_side *q, double *x)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at, *beta = c->number + m->beta_at;
    const int turned = DIM == 2 && m->form_kind[f] & FORM_TURNED;
    const double *alpha_turn = c->number + m->alpha_turn_at,
                 *beta_turn = c->number + m->beta_turn_at;
    const int size = (p->turns ? TURNING : DIM) * (q->turns ? TURNING : DIM);
    for (int k = 0; k < size; k++) x[k] = 0.0;
    if (p->turns && q->turns) {
        const double along = factor * (dot(p->u[0], q->w[1]) + dot(p->w[0], q->u[1]));
#if DIM == 2
        x[0] = along;
#else
        EACH(k)
            EACH(l) x[3 * k + l] = -factor * (q->w[1][k] * p->u[0][l] + q->u[1][k] * p->w[0][l]);
        EACH(k) x[4 * k] += along;
#endif
    } else if (p->turns) {
        add_cross(factor * beta[q->entry], p->u[0], 0, x);
        add_cross(factor * alpha[q->entry], p->w[0], 0, x);
        if (turned)
            EACH(k)
                x[k] +=
                    factor * (beta_turn[q->entry] * p->u[0][k] + alpha_turn[q->entry] * p->w[0][k]);
    } else if (q->turns) {
        add_cross(factor * alpha[p->entry], q->w[1], 1, x);
        add_cross(factor * beta[p->entry], q->u[1], 1, x);
        if (turned)
            EACH(k)
                x[k] +=
                    factor * (alpha_turn[p->entry] * q->w[1][k] + beta_turn[p->entry] * q->u[1][k]);
    } else {
        double same, quarter;
        pair_stiffness(c, f, p->entry, q->entry, &same, &quarter);
        x[0] = factor * same;
        if (!turned) return -1;
        x[1] = -(x[2] = factor * quarter), x[3] = x[0];
    }
    return size;
}

/* x += factor ((a . b) 1 - b a'), of directions a in the middle and b at the end. */
static inline void add_turning(double factor, const double *a, const double *b, double *x)
{
    const double along = factor * dot(a, b);
#if DIM == 2
    x[0] += along;
#else
    EACH(k) {
        const double own = -factor * b[k];
        EACH(l) x[3 * k + l] += own * a[l];
        x[4 * k] += along;
    }
#endif
}

/* A row that holds directions a and b, of the body that comes first and of another one or the
   ground. In a step these turn by theta_a and theta_b, so that

       a . b  changes by  (theta_a - theta_b) . (a x b)

   with both in the middle, and the torques a x b act on the first body and against the other. */
typedef struct axes {
    int32_t first, second; /* components of the turns; second -1: the ground */
    double a[DIM], b[DIM];
} axes;

/* Both, from directors in the middle or at the end. */
static void turn_axes(const context *c, int32_t f, const double *directors, axes *x)
{
    const holonom_model *m = c->m;
    const int32_t kind = m->form_kind[f], begin = m->form_ptr[f], end = begin + m->form_free[f],
                  swapped = kind & FORM_AXES_OF_W;
    const int32_t of_u = m->alpha_at, of_w = m->beta_at, turned = DIM == 2 && kind & FORM_TURNED;
    const int32_t u_turn = turned ? m->alpha_turn_at : -1, w_turn = turned ? m->beta_turn_at : -1;
    const int32_t middle = x->second < 0 ? end : behind_side(c, f, begin);
    carried(c, begin, middle, swapped ? of_w : of_u, swapped ? w_turn : u_turn, directors, x->a);
    if (x->second < 0) EACH(k) x->b[k] = c->k.w0[DIM * f + k];
    else carried(c, middle, end, swapped ? of_u : of_w, swapped ? u_turn : w_turn, directors, x->b);
}

/* Likewise; at a state they are at hand, in the place of the row's links. */
HM_OFTEN axes axes_of(const context *c, int32_t f, const double *directors)
{
    const holonom_model *m = c->m;
    const int32_t swapped = m->form_kind[f] & FORM_AXES_OF_W, *node = m->form_node + m->form_ptr[f];
    const double *a = (swapped ? c->k.w0 : c->k.u0) + DIM * f,
                 *b = (swapped ? c->k.u0 : c->k.w0) + DIM * f;
    axes x;
    x.first = DIM * first_of_unknown(c, node[0]);
    x.second =
        m->form_kind[f] & FORM_LINEAR ? -1 : DIM * first_of_unknown(c, node[m->form_free[f] - 1]);
    if (!c->step.at_state || x.second < 0) turn_axes(c, f, directors, &x);
    else EACH(k) x.a[k] = a[k], x.b[k] = b[k];
    return x;
}

/* Directors and axes at the state, for equations without a step. */
static void stand_still_as_bodies(const context *c)
{
    EACH_TURN(c, b)
        for (int32_t k = DIM * c->m->body_node[b], end = k + DIM * TURNING; k < end; k++) {
            c->k.middle[k] = c->k.turned[k] = c->s.q[k];
            c->k.nodal[k] = 0.0;
        }
    EACH_FORM_ROW(c, i) {
        const int32_t f = c->m->row_form[i], swapped = c->m->form_kind[f] & FORM_AXES_OF_W;
        axes x = {0};
        if (!is_axes_row(c, i) || c->m->form_kind[f] & FORM_LINEAR) continue;
        turn_axes(c, f, c->s.q, &x);
        EACH(k) c->k.u0[DIM * f + k] = swapped ? x.b[k] : x.a[k];
        EACH(k) c->k.w0[DIM * f + k] = swapped ? x.a[k] : x.b[k];
    }
}

/* Change of form f to the end, where directions in the middle are not at hand. */
HM_SELDOM static double change_of_form(const context *c, int32_t f)
{
    motion g;
    form_motion(c, f, &g);
    return g.ds;
}

/* Residual of such a row i, and its torques. */
static void axes_row_residual(const context *c, int32_t i)
{
    const double force = c->h * c->k.mu[i], *theta = c->k.move;
    double across[TURNING], change = 0.0;
    const axes x = axes_of(c, c->m->row_form[i], c->k.middle);
    cross_product(x.a, x.b, across);
    if (x.second < 0)
        for (int k = 0; k < TURNING; k++) change += theta[x.first + k] * across[k];
    else
        for (int k = 0; k < TURNING; k++) {
            change += (theta[x.first + k] - theta[x.second + k]) * across[k];
            c->k.torque[x.second + k] -= force * across[k];
        }
    for (int k = 0; k < TURNING; k++) c->k.torque[x.first + k] += force * across[k];
    c->k.phi[i] = c->k.phi0[i] + (is_seeking(c) ? change_of_form(c, c->m->row_form[i]) : change);
}

/* Its torques by a multiplier, times a factor, to value. */
HM_OFTEN const int32_t *scatter_torques(double factor, const axes *x, const int32_t *slot,
                                        double *value)
{
    double across[TURNING];
    cross_product(x->a, x->b, across);
    for (int k = 0; k < TURNING; k++) value[*slot++] += factor * across[k];
    for (int k = 0; k < TURNING && x->second >= 0; k++) value[*slot++] -= factor * across[k];
    return slot;
}

/* Its tangent. What either body's turn does to its own torque goes to `bend`; at a state there are
   no multipliers. */
static void axes_row_tangent(const context *c, int32_t i, const int32_t *slot, double *value)
{
    const double factor = c->step.theta * c->h * c->k.mu[i];
    const axes x = axes_of(c, c->m->row_form[i], c->k.middle);
    axes y = {x.first, x.second, {0.0}, {0.0}};
    if (!c->step.at_state) {
        double own[TURNING * TURNING] = {0.0}, other[TURNING * TURNING] = {0.0};
        turn_axes(c, c->m->row_form[i], c->k.turned, &y);
        add_turning(factor, x.b, y.a, own);
        for (int k = 0; k < TURNING * TURNING; k++) c->k.bend[x.first + k] -= own[k];
        if (x.second >= 0) {
            add_turning(factor, x.a, y.b, other);
            for (int k = 0; k < TURNING * TURNING; k++) c->k.bend[x.second + k] -= other[k];
            if (!is_lean(c))
                slot = scatter(TURNING * TURNING, own,
                               scatter(TURNING * TURNING, other, slot, value), value);
        }
    } else if (x.second >= 0 && !is_lean(c)) slot += 2 * TURNING * TURNING;
    scatter_torques(1.0, c->step.at_state ? &x : &y, scatter_torques(c->h, &x, slot, value), value);
}

/* Tangent of form row i: stiffness, the gradient in the middle, that at the end. */
static void row_tangent(const context *c, int32_t i, const int32_t *slot, double *value)
{
    const holonom_model *m = c->m;
    if (is_axes_row(c, i)) {
        axes_row_tangent(c, i, slot, value);
        return;
    }
    const int32_t f = m->row_form[i], end = m->form_ptr[f] + m->form_free[f];
    const double factor = c->step.theta * c->h * c->k.mu[i];
    double u1[DIM], w1[DIM], x[DIM * DIM];
    form_side sides[MOST_SIDES];
    int n = 0;
    motion g;
    form_motion(c, f, &g);
    EACH(k) u1[k] = g.u0[k] + g.du[k];
    EACH(k) w1[k] = g.w0[k] + g.dw[k];
    for (int32_t e = m->form_ptr[f]; e < end;) e = next_side(c, f, e, sides + n++);
    for (int p = 0; p < n && !(is_lean(c) || m->form_kind[f] & FORM_LINEAR); p++)
        for (int q = 0; q < n; q++) {
            const int size = side_stiffness(c, f, factor, sides + p, sides + q, x);
            if (size > 0) slot = scatter(size, x, slot, value);
            else EACH(k) value[*slot++] += x[0];
        }
    for (int p = 0; p < n; p++) {
        const int size = side_gradient(c, f, sides + p, 0, g.um, g.wm, x);
        for (int k = 0; k < size; k++) value[*slot++] += c->h * x[k];
    }
    for (int p = 0; p < n; p++)
        slot = scatter(side_gradient(c, f, sides + p, 1, u1, w1, x), x, slot, value);
}

/* Gradients of coincidence j: of each side those in the middle, h times, and those at the end. */
static const int32_t *coincidence_tangent(const context *c, int32_t j, const int32_t *slot,
                                          double *value)
{
    const holonom_model *m = c->m;
    const int32_t f = m->coincidence_form[j], end = m->form_ptr[f] + m->form_free[f];
    for (int32_t e = m->form_ptr[f]; e < end;) {
        const int32_t begin = e, turned = m->form_kind[f] & FORM_TURNED;
        const double alpha = c->number[m->alpha_at + e];
        e = behind_side(c, f, e);
        if (is_director(c, m->form_node[begin])) {
            double arm[DIM];
            const int32_t turn_at = turned ? m->alpha_turn_at : -1;
            carried(c, begin, e, m->alpha_at, turn_at, c->k.middle, arm);
            slot = scatter_cross(c->h, arm, slot, value);
            carried(c, begin, e, m->alpha_at, turn_at, c->k.turned, arm);
            slot = scatter_cross(DIM == 2 ? 1.0 : -1.0, arm, slot, value);
        } else if (DIM == 3 || !(m->form_kind[f] & FORM_TURNED)) {
            EACH(k) value[*slot++] += c->h * alpha;
            EACH(k) value[*slot++] += alpha;
        } else {
#if DIM == 2
            const double turn = c->number[m->alpha_turn_at + begin],
                         block[4] = {alpha, -turn, turn, alpha};
            EACH(i) EACH(k) value[*slot++] += c->h * block[DIM * k + i];
            slot = scatter(4, block, slot, value);
#endif
        }
    }
    return slot;
}

#endif
