/* Forms s = u . w and their discrete gradients, for DIM coordinates a node.

   With d = q_1 - q_n and links u_m = u_0 + du/2, w_m = w_0 + dw/2 a quadratic row changes by
   exactly dPhi = u_m . dw + w_m . du = G(q_m) d, so that its discrete gradient is its gradient at
   the midpoint. */
#ifndef HOLONOM_FORMS_H
#define HOLONOM_FORMS_H

#include "context.h"

/* x += factor J y, J the quarter turn; there is none in space. */
static inline void add_turned(double factor, const double *y, double *x)
{
#if DIM == 2
    x[0] -= factor * y[1];
    x[1] += factor * y[0];
#else
    (void)factor, (void)y, (void)x;
#endif
}

/* u += sum alpha x, w += sum beta x over these entries of form f; x holds the node `first` and
   on. */
HM_OFTEN void add_links(const context *c, int32_t f, const span entries, const double *x,
                        int32_t first, double *u, double *w)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at, *beta = c->number + m->beta_at;
    if (m->form_kind[f] & FORM_TURNED) {
        const double *alpha_turn = c->number + m->alpha_turn_at,
                     *beta_turn = c->number + m->beta_turn_at;
        for (int32_t e = entries.begin; e < entries.end; e++) {
            const double *xe = x + DIM * (m->form_node[e] - first);
            add_turned(alpha_turn[e], xe, u);
            add_turned(beta_turn[e], xe, w);
        }
    }
    for (int32_t e = entries.begin; e < entries.end; e++) {
        const double *xe = x + DIM * (m->form_node[e] - first);
        EACH(k) u[k] += alpha[e] * xe[k];
        EACH(k) w[k] += beta[e] * xe[k];
    }
}

/* u = sum alpha x, w = sum beta x over the moving nodes of form f; x (DIM n_moving). */
HM_OFTEN void link_of(const context *c, int32_t f, const double *x, double *u, double *w)
{
    const holonom_model *m = c->m;
    const int32_t begin = m->form_ptr[f], end = begin + m->form_moving[f];
    EACH(k) u[k] = w[k] = 0.0;
    if (m->form_kind[f] == FORM_SQUARE) {
        const double *alpha = c->number + m->alpha_at;
        for (int32_t e = begin; e < end; e++) {
            const double *xe = x + DIM * m->form_node[e];
            EACH(k) u[k] += alpha[e] * xe[k];
        }
    } else
        add_links(c, f, (span){begin, end}, x, 0, u, w);
    if (m->form_kind[f] & FORM_SQUARE) EACH(k) w[k] = u[k];
}

/* Links of form f at the configuration (x, x_low), fixed nodes included. The differences of the
   leading parts are formed first: they are exact to the last digit of the link, not of the
   position. */
static void link_at(const context *c, int32_t f, const double *x, const double *x_low, double *u,
                    double *w)
{
    const holonom_model *m = c->m;
    double u_low[DIM], w_low[DIM];
    link_of(c, f, x, u, w);
    add_links(c, f, (span){m->form_ptr[f] + m->form_moving[f], m->form_ptr[f + 1]},
              c->number + m->support_at, c->n_moving, u, w);
    if (m->form_kind[f] & FORM_SQUARE) EACH(k) w[k] = u[k];
    link_of(c, f, x_low, u_low, w_low);
    EACH(k) u[k] += u_low[k];
    EACH(k) w[k] += w_low[k];
}

static inline void link_at_state(const context *c, int32_t f, double *u, double *w)
{
    link_at(c, f, c->s.q, c->s.q_low, u, w);
}

/* Gradient of form f with respect to entry e, from the links U, W: alpha W + beta U, turned
   back. */
static inline void entry_gradient(const context *c, int32_t f, int32_t e, const double *u,
                                  const double *w, double *g)
{
    const holonom_model *m = c->m;
    const double a = c->number[m->alpha_at + e], b = c->number[m->beta_at + e];
    EACH(k) g[k] = a * w[k] + b * u[k];
    if (m->form_kind[f] & FORM_TURNED) {
        add_turned(-c->number[m->alpha_turn_at + e], w, g);
        add_turned(-c->number[m->beta_turn_at + e], u, g);
    }
}

/* target[node] += factor times the gradient of form f built from links U, W, over its moving nodes.
   A square form lists alpha = beta. */
HM_OFTEN void add_gradient(const context *c, int32_t f, double factor, const double *u,
                           const double *w, double *target)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at, *beta = c->number + m->beta_at;
    const int32_t begin = m->form_ptr[f], end = begin + m->form_moving[f];
    for (int32_t e = begin; e < end; e++) {
        double *node = target + DIM * m->form_node[e];
        const double a = factor * alpha[e], b = factor * beta[e];
        EACH(k) node[k] += a * w[k] + b * u[k];
        if (m->form_kind[f] & FORM_TURNED) {
            add_turned(-factor * c->number[m->alpha_turn_at + e], w, node);
            add_turned(-factor * c->number[m->beta_turn_at + e], u, node);
        }
    }
}

/* target[node] += factor times what a force on link u of form f does to its moving nodes. */
HM_OFTEN void add_link_force(const context *c, int32_t f, double factor, const double *force,
                             double *target)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at, *alpha_turn = c->number + m->alpha_turn_at;
    const int32_t begin = m->form_ptr[f], end = begin + m->form_moving[f],
                  turned = DIM == 2 && m->form_kind[f] & FORM_TURNED;
    for (int32_t e = begin; e < end; e++) {
        double *node = target + DIM * m->form_node[e];
        const double own = factor * alpha[e];
        EACH(k) node[k] += own * force[k];
        if (turned) add_turned(-factor * alpha_turn[e], force, node);
    }
}

/* Second derivative of form f with respect to entries p and q: same I + quarter J. */
static inline void pair_stiffness(const context *c, int32_t f, int32_t p, int32_t q, double *same,
                                  double *quarter)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at, *beta = c->number + m->beta_at;
    *same = alpha[p] * beta[q] + beta[p] * alpha[q];
    *quarter = 0.0;
    if (DIM == 3 || !(m->form_kind[f] & FORM_TURNED)) return;
    const double *alpha_turn = c->number + m->alpha_turn_at,
                 *beta_turn = c->number + m->beta_turn_at;
    *same += alpha_turn[p] * beta_turn[q] + beta_turn[p] * alpha_turn[q];
    *quarter = alpha[p] * beta_turn[q] - alpha_turn[p] * beta[q] + beta[p] * alpha_turn[q]
               - beta_turn[p] * alpha[q];
}

/* A form within a step: links at the beginning, their increments, links where gradients are taken,
   change of s. At a state nothing moves. */
typedef struct motion {
    const double *u0, *w0;
    double du[DIM], dw[DIM], um[DIM], wm[DIM], ds;
} motion;

HM_OFTEN void form_motion(const context *c, int32_t f, motion *g)
{
    const double theta = c->step.theta;
    g->u0 = c->k.u0 + DIM * f;
    g->w0 = c->k.w0 + DIM * f;
    if (c->step.at_state) {
        g->ds = 0.0;
        EACH(k) g->du[k] = g->dw[k] = 0.0, g->um[k] = g->u0[k], g->wm[k] = g->w0[k];
        return;
    }
    link_of(c, f, c->k.d, g->du, g->dw);
    EACH(k) g->um[k] = g->u0[k] + theta * g->du[k];
    EACH(k) g->wm[k] = g->w0[k] + theta * g->dw[k];
    g->ds = dot(g->um, g->dw) + dot(g->wm, g->du);
    if (theta != 0.5) g->ds -= (2.0 * theta - 1.0) * dot(g->du, g->dw);
}

/* Compliance of a row over its sigma, in its equation Phi_1 - epsilon (mu - lambda) = 0, where mu =
   lambda + alpha/2 Phi_1 (eq 15 with Phi_n moved into lambda): epsilon = 2/alpha. alpha is the
   dimensionless penalty chi over h^2 sigma/4. */
static double compliance_over_sigma(const context *c)
{
    double raised = 1.0;
    for (int level = 0; level < MOST_LEVELS && level < c->view.scalars[I_PENALTY_LEVEL]; level++)
        raised *= 1e2;
    return c->h * c->h / (2.0 * (c->s.head[S_PENALTY] * raised));
}

/* Coincidence j at the end of the step, dim rows u(d) of gradient alpha, written to `row`. */
static void coincidence_function(const context *c, int32_t j, const double *phi0, double *row)
{
    double du[DIM], unused[DIM];
    link_of(c, c->m->coincidence_form[j], c->k.d, du, unused);
    EACH(k) row[k] = phi0[k] + du[k];
}

/* ------------------------------------------------------------- to twice the digits (theory 1.6) */

/* One link of form f at the state to about twice the digits of a double, high + low (DIM each,
   overwritten); coefficients of the link begin at `at`, those of its quarter turns at `turn_at`. */
static void exact_link(const context *c, int32_t f, int32_t at, int32_t turn_at, double *high,
                       double *low)
{
    const holonom_model *m = c->m;
    const int32_t begin = m->form_ptr[f], moving = begin + m->form_moving[f];
    int32_t e = begin;
    EACH(k) high[k] = low[k] = 0.0;
    while (e < moving && c->number[at + e] == 0.0) e++;
    if (e < moving && fabs(c->number[at + e]) == 1.0
        && !(DIM == 2 && m->form_kind[f] & FORM_TURNED)) { /* as most do begin */
        const int32_t node = DIM * m->form_node[e];
        EACH(k) high[k] = c->number[at + e] * c->s.q[node + k];
        EACH(k) low[k] = c->number[at + e] * c->s.q_low[node + k];
        e++;
    } else e = begin;
    for (; e < m->form_ptr[f + 1]; e++) {
        const int32_t node = DIM * (m->form_node[e] - (e < moving ? 0 : c->n_moving));
        const double *x = (e < moving ? c->s.q : c->number + m->support_at) + node;
        const double *x_low = e < moving ? c->s.q_low + node : NULL;
        const double factor = c->number[at + e];
        if (factor == 0.0 && !(DIM == 2 && m->form_kind[f] & FORM_TURNED)) continue;
        if (fabs(factor) == 1.0) EACH(k) hm_add_exactly(high + k, low + k, factor * x[k]);
        else EACH(k) hm_add_product(high + k, low + k, factor, x[k]);
        if (x_low) EACH(k) low[k] += factor * x_low[k];
        if (DIM == 3 || !(m->form_kind[f] & FORM_TURNED)) continue;
        for (int k = 0; k < 2; k++) {
            const double turn = c->number[turn_at + e] * (k == 0 ? -1.0 : 1.0);
            hm_add_product(high + k, low + k, turn, x[1 - k]);
            if (x_low) low[k] += turn * x_low[1 - k];
        }
    }
}

/* Phi = u . w - c of form row i at the state, to about twice the digits of a double, so that no
   step corrects the rounding error of Phi: its impulse grows as 1/h^2, without bound near a
   singular configuration. */
static double row_at_state(const context *c, int32_t i)
{
    const holonom_model *m = c->m;
    const int32_t f = m->row_form[i];
    const int is_square = m->form_kind[f] & FORM_SQUARE;
    double high = -c->number[m->row_constant_at + i], low = 0.0, u[DIM], u_low[DIM], other[DIM],
           other_low[DIM];
    exact_link(c, f, m->alpha_at, m->alpha_turn_at, u, u_low);
    if (!is_square) exact_link(c, f, m->beta_at, m->beta_turn_at, other, other_low);
    const double *w = is_square ? u : other, *w_low = is_square ? u_low : other_low;
    EACH(k) {
        hm_add_product(&high, &low, u[k], w[k]);
        low += u[k] * w_low[k] + u_low[k] * w[k];
    }
    return high + low;
}

#endif
