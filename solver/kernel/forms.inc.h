/* Forms s = u . w and their discrete gradients, for DIM coordinates a node. Included once per dimension.

   With d = q_1 - q_n and links u_m = u_0 + du/2, w_m = w_0 + dw/2 a quadratic row changes by exactly
   dPhi = u_m . dw + w_m . du = G(q_m) d, so that its discrete gradient is its gradient at the midpoint.      */
#include "internal.h"

#include <math.h>
#include <string.h>

#define EACH(k) for (int k = 0; k < DIM; k++)

typedef struct context {
    const holonom_model *m;
    double *number;
    hm_state s;
    hm_work k;
    int64_t state_size;
    int formulation;
    double h, t;
} context;

static inline double dot(const double *a, const double *b)
{
    double sum = 0.0;
    EACH(k) sum += a[k] * b[k];
    return sum;
}

static void open_context(context *c, const holonom_model *m, double *number, double *state, double *work)
{
    c->m = m;
    c->number = number;
    c->state_size = hm_map_state(m, state, &c->s);
    hm_map_work(m, work, &c->k);
    c->formulation = (int)c->s.head[S_FORMULATION];
    c->t = c->s.head[S_TIME];
    c->h = 0.0;
}

/* u = sum alpha x, w = sum beta x over the free nodes of form f; x (DIM n_free). */
static inline void link_of(const context *c, int32_t f, const double *x, double *u, double *w)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at, *beta = c->number + m->beta_at;
    const int32_t begin = m->form_ptr[f], end = begin + m->form_free[f];
    EACH(k) u[k] = 0.0;
    if (m->form_square[f]) {
        for (int32_t e = begin; e < end; e++) {
            const double *xe = x + DIM * m->form_node[e];
            EACH(k) u[k] += alpha[e] * xe[k];
        }
        EACH(k) w[k] = u[k];
        return;
    }
    EACH(k) w[k] = 0.0;
    for (int32_t e = begin; e < end; e++) {
        const double *xe = x + DIM * m->form_node[e];
        EACH(k) u[k] += alpha[e] * xe[k];
        EACH(k) w[k] += beta[e] * xe[k];
    }
}

/* Links of form f at the state's configuration, supports and compensation terms included. The differences of
   the leading parts are formed first: they are exact to the last digit of the link, not of the position.      */
static void link_at_state(const context *c, int32_t f, double *u, double *w)
{
    const holonom_model *m = c->m;
    const double *support = c->number + m->support_at;
    double u_low[DIM], w_low[DIM];
    link_of(c, f, c->s.q, u, w);
    for (int32_t e = m->form_ptr[f] + m->form_free[f]; e < m->form_ptr[f + 1]; e++) {
        const double *xe = support + DIM * (m->form_node[e] - m->n_free);
        EACH(k) u[k] += c->number[m->alpha_at + e] * xe[k];
        EACH(k) w[k] += c->number[m->beta_at + e] * xe[k];
    }
    link_of(c, f, c->s.q_low, u_low, w_low);
    EACH(k) u[k] += u_low[k];
    EACH(k) w[k] += w_low[k];
}

/* Phi = u . w - c of row i at the state's configuration, to about twice the digits of a double, so that no step
   corrects the rounding error of Phi: its impulse grows as 1/h^2, without bound near a singular configuration. */
static double row_at_state(const context *c, int32_t i)
{
    const holonom_model *m = c->m;
    const int32_t f = m->row_form[i], begin = m->form_ptr[f], free = begin + m->form_free[f];
    double high = -c->number[m->row_constant_at + i], low = 0.0;
    EACH(k) {
        double u = 0.0, u_low = 0.0, w = 0.0, w_low = 0.0;
        for (int32_t e = begin; e < m->form_ptr[f + 1]; e++) {
            const int32_t at = DIM * (m->form_node[e] - (e < free ? 0 : m->n_free)) + k;
            const double x = e < free ? c->s.q[at] : c->number[m->support_at + at];
            const double x_low = e < free ? c->s.q_low[at] : 0.0;
            const double alpha = c->number[m->alpha_at + e], beta = c->number[m->beta_at + e];
            hm_add_product(&u, &u_low, alpha, x);
            u_low += alpha * x_low;
            if (m->form_square[f]) continue;
            hm_add_product(&w, &w_low, beta, x);
            w_low += beta * x_low;
        }
        if (m->form_square[f]) {
            w = u;
            w_low = u_low;
        }
        hm_add_product(&high, &low, u, w);
        low += u * w_low + u_low * w;
    }
    return high + low;
}

/* target[node] += factor (alpha W + beta U): adds a multiple of the gradient of form f built from links U, W. */
static inline void add_gradient(const context *c, int32_t f, double factor, const double *u, const double *w,
                                double *target)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at, *beta = c->number + m->beta_at;
    const int32_t begin = m->form_ptr[f], end = begin + m->form_free[f];
    for (int32_t e = begin; e < end; e++) {
        double *node = target + DIM * m->form_node[e];
        const double a = factor * alpha[e], b = factor * beta[e];
        EACH(k) node[k] += a * w[k] + b * u[k];
    }
}

/* A form within a step: links at the beginning, their increments, and links at the midpoint. */
typedef struct motion {
    const double *u0, *w0;
    double du[DIM], dw[DIM], um[DIM], wm[DIM];
} motion;

static inline void form_motion(const context *c, int32_t f, motion *g)
{
    g->u0 = c->k.u0 + DIM * f;
    g->w0 = c->k.w0 + DIM * f;
    link_of(c, f, c->k.d, g->du, g->dw);
    EACH(k) g->um[k] = g->u0[k] + 0.5 * g->du[k];
    EACH(k) g->wm[k] = g->w0[k] + 0.5 * g->dw[k];
}

/* Compliance of row i in its equation C(d) - epsilon (mu - lambda) = 0. Conserving rows are written for
   Phi_1, where mu = lambda + alpha/2 Phi_1 (eq 15 with Phi_n moved into lambda): epsilon = 2/alpha. alpha is
   the dimensionless penalty chi over h^2 sigma/4. A penalty method stores energy in alpha, so its alpha must
   not follow h: it uses the configured step.                                                                */
static double row_compliance(const context *c, int32_t i)
{
    const double *head = c->s.head;
    const double chi = head[S_PENALTY], sigma = c->number[c->m->row_sigma_at + i];
    const double configured = head[S_STEP_SIZE] * (head[S_PAIRED] != 0.0 ? 0.5 : 1.0);
    switch (c->formulation) {
    case HOLONOM_CONSERVING_AL: return c->h * c->h * sigma / (2.0 * chi);
    case HOLONOM_MIDPOINT_AL: return c->h * c->h * sigma / (4.0 * chi);
    case HOLONOM_CONSERVING_PENALTY: return configured * configured * sigma / (2.0 * chi);
    case HOLONOM_MIDPOINT_PENALTY: return configured * configured * sigma / (4.0 * chi);
    default: return sigma / chi;
    }
}

static inline int is_penalty(const context *c) { return c->formulation >= HOLONOM_CONSERVING_PENALTY; }

static inline int is_conserving(const context *c)
{
    return c->formulation == HOLONOM_CONSERVING_AL || c->formulation == HOLONOM_CONSERVING_PENALTY;
}

/* Row function of eq 3 under the midpoint rule, Phi'' + 2 xi omega Phi' + omega^2 Phi, with the accelerations
   2 (d - h v)/h^2, and the links U, W of its gradient.                                                      */
static double velocity_row(const context *c, int32_t i, const motion *g, double *u, double *w)
{
    const double rate = 2.0 * c->s.head[S_XI] * c->s.head[S_OMEGA] / c->h;
    const double stiff = c->s.head[S_OMEGA] * c->s.head[S_OMEGA], inertia = 2.0 / (c->h * c->h);
    double wu[DIM], ww[DIM];
    link_of(c, c->m->row_form[i], c->k.w, wu, ww);
    EACH(k) u[k] = inertia * (g->um[k] + 0.5 * wu[k] + g->du[k]) + rate * (g->um[k] + 0.5 * g->du[k]) +
                   0.5 * stiff * g->um[k];
    EACH(k) w[k] = inertia * (g->wm[k] + 0.5 * ww[k] + g->dw[k]) + rate * (g->wm[k] + 0.5 * g->dw[k]) +
                   0.5 * stiff * g->wm[k];
    const double middle = c->k.phi0[i] + 0.5 * (dot(g->u0, g->dw) + dot(g->w0, g->du)) + 0.25 * dot(g->du, g->dw);
    return inertia * (dot(g->um, ww) + dot(g->wm, wu) + dot(g->du, g->dw)) +
           rate * (dot(g->um, g->dw) + dot(g->wm, g->du)) + stiff * middle;
}

/* Row function C(d) of row i and the links U, W of its gradient alpha W + beta U. */
static inline double row_function(const context *c, int32_t i, const motion *g, double *u, double *w)
{
    if (is_conserving(c)) { /* Phi_1 */
        EACH(k) u[k] = g->u0[k] + g->du[k];
        EACH(k) w[k] = g->w0[k] + g->dw[k];
        return c->k.phi0[i] + (dot(g->um, g->dw) + dot(g->wm, g->du));
    }
    if (c->formulation == HOLONOM_PENALTY_VELOCITY) return velocity_row(c, i, g, u, w);
    EACH(k) u[k] = 0.5 * g->um[k]; /* Phi at the midpoint */
    EACH(k) w[k] = 0.5 * g->wm[k];
    return c->k.phi0[i] + 0.5 * (dot(g->u0, g->dw) + dot(g->w0, g->du)) + 0.25 * dot(g->du, g->dw);
}
