/* Forces besides those along quantities: moments on links and on bodies, forces on links, weights;
   each with the discrete form whose work is exact. */
#ifndef HOLONOM_LAWS_H
#define HOLONOM_LAWS_H

#include "body_turns.h"
#include "forms.h"

static inline double square_of_cross(const double *cross)
{
    double sum = 0.0;
    for (int i = 0; i < TURNING; i++) sum += cross[i] * cross[i];
    return sum;
}

/* Moment m on a link u: couple f = g (m x u_m) with g = beta/|u_0 x u_1|, beta the angle between
   u_0 and u_1. In the plane its work is exactly m beta. f (DIM) and, if wanted, its tangent in du
   (DIM x DIM), overwritten. */
static void moment_tangent(const double *moment, const double *u0, const double *cross, double y,
                           double factor, const double *f, double *tangent)
{
    const double size2 = square_of_cross(cross), radius2 = size2 + y * y,
                 c1 = hm_angle_over_bend(sqrt(size2), y, factor);
    double direction[DIM], axis[3] = {0.0, 0.0, 0.0};
#if DIM == 2
    axis[2] = moment[0];
    direction[0] = -c1 * cross[0] * u0[1] - u0[0] / radius2;
    direction[1] = c1 * cross[0] * u0[0] - u0[1] / radius2;
#else
    EACH(i) axis[i] = moment[i];
    EACH(i)
        direction[i] =
            c1 * (cross[(i + 1) % 3] * u0[(i + 2) % 3] - cross[(i + 2) % 3] * u0[(i + 1) % 3])
            - u0[i] / radius2;
#endif
    const double skew[3][3] = {
        {0.0, -axis[2], axis[1]}, {axis[2], 0.0, -axis[0]}, {-axis[1], axis[0], 0.0}};
    EACH(i) EACH(j) tangent[DIM * i + j] = 0.5 * factor * skew[i][j] + f[i] / factor * direction[j];
}

static int32_t moment_law(const context *c, int32_t j, const motion *g, double *f, double *tangent)
{
    double u1[DIM];
    EACH(i) u1[i] = g->u0[i] + g->du[i];
    const double *u0 = is_seeking(c) ? u1 : g->u0;
    const double y = dot(u0, u1), *moment = c->number + c->m->moment_at + TURNING * j;
    double cross[TURNING];
    cross_product(u0, u1, cross);
    const double size2 = square_of_cross(cross);
#if DIM == 2
    f[0] = -moment[0] * g->um[1];
    f[1] = moment[0] * g->um[0];
#else
    cross_product(moment, g->um, f);
#endif
    if (!(size2 + y * y > 0.0)) return HOLONOM_ZERO_LENGTH;
    const double factor = hm_angle_over(sqrt(size2), y);
    EACH(i) f[i] *= factor;
    if (tangent) {
        moment_tangent(moment, u0, cross, y, factor, f, tangent);
        if (is_seeking(c)) EACH(i) EACH(k) tangent[DIM * i + k] *= 2.0;
    }
    return HOLONOM_OK;
}

/* Moment on a spatial body: f_i = m x d^i/2 on the directors, d^i the dual ones at the midpoint,
   since sum d_i x (m x d^i)/2 = m whatever their lengths and angles. `dual` (9) and `f` (9)
   overwritten. */
#if DIM == 3
static int32_t body_moment_law(const context *c, int32_t j, double *moment, double *dual, double *f)
{
    const holonom_model *m = c->m;
    const int32_t node = m->body_moment[2 * j];
    const double *given = c->number + m->body_moment_at + 3 * j;
    double d[9];
    for (int k = 0; k < 9; k++) d[k] = c->s.q[3 * node + k] + c->step.theta * c->k.d[3 * node + k];
    for (int i = 0; i < 3; i++)
        cross_product(d + 3 * ((i + 1) % 3), d + 3 * ((i + 2) % 3), dual + 3 * i);
    const double volume = dot(d, dual);
    if (!(fabs(volume) > 0.0)) return HOLONOM_ZERO_LENGTH;
    for (int k = 0; k < 9; k++) dual[k] /= volume;
    EACH(k)
        moment[k] = m->body_moment[2 * j + 1]
                        ? given[0] * d[k] + given[1] * d[3 + k] + given[2] * d[6 + k]
                        : given[k];
    for (int i = 0; i < 3; i++) {
        cross_product(moment, dual + 3 * i, f + 3 * i);
        EACH(k) f[3 * i + k] *= 0.5;
    }
    return HOLONOM_OK;
}

static void skew_of(const double *a, double *matrix)
{
    const double s[9] = {0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0};
    memcpy(matrix, s, sizeof(s));
}

/* value -= h df_i/dd_j: the dual directors change by -(d^i . dd_j) d^j. */
static int32_t body_moment_tangent(const context *c, int32_t b, const int32_t *slot, double *value)
{
    double moment[3], dual[9], f[9], skew[9];
    const int32_t node = c->m->body_moment[2 * b];
    const int32_t status = body_moment_law(c, b, moment, dual, f);
    if (status) return status;
    const double *given = c->number + c->m->body_moment_at + 3 * b,
                 factor = -0.5 * c->h * c->step.theta;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double turned[3];
            cross_product(moment, dual + 3 * j, turned);
            skew_of(dual + 3 * i, skew);
            double block[9], x[9];
            EACH(k) EACH(l) {
                block[3 * k + l] = -factor * turned[k] * dual[3 * i + l];
                if (c->m->body_moment[2 * b + 1])
                    block[3 * k + l] -= factor * given[j] * skew[3 * k + l];
            }
            slot = scatter(block_to_unknowns(c, node + i, node + j, block, x), x, slot, value);
        }
    return HOLONOM_OK;
}
#endif

/* Force of load j at the midpoint, in global axes. */
static void load_force(const context *c, int32_t j, double *force)
{
    const double *given = c->number + c->m->load_at + DIM * j;
    const int32_t axes = c->m->load_axes[j];
    EACH(k) force[k] = given[k];
    if (axes < 0) return;
    double d[DIM == 2 ? 2 : 9];
    for (int k = 0; k < (DIM == 2 ? 2 : 9); k++)
        d[k] = c->s.q[DIM * axes + k] + c->step.theta * c->k.d[DIM * axes + k];
#if DIM == 2
    EACH(k) force[k] = given[0] * d[k];
    add_turned(given[1], d, force);
#else
    EACH(k) force[k] = given[0] * d[k] + given[1] * d[3 + k] + given[2] * d[6 + k];
#endif
}

/* target += factor times the force of load j on the nodes of its link. */
static void add_load(const context *c, int32_t j, double factor, double *target)
{
    double force[DIM];
    load_force(c, j, force);
    add_link_force(c, c->m->load_form[j], factor, force, target);
}

/* value -= h dF/dd of a load that a body carries; returns the slots behind its own. */
static const int32_t *load_tangent(const context *c, int32_t j, const int32_t *slot, double *value)
{
    const holonom_model *m = c->m;
    const int32_t f = m->load_form[j], axes = m->load_axes[j];
    const double *given = c->number + m->load_at + DIM * j, factor = -c->h * c->step.theta;
    if (axes < 0) return slot;
    for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++)
        for (int q = 0; q < (DIM == 2 ? 1 : 3); q++) {
            const double alpha = factor * c->number[m->alpha_at + e];
#if DIM == 2
            const double turn =
                m->form_kind[f] & FORM_TURNED ? factor * c->number[m->alpha_turn_at + e] : 0.0;
            const double same = alpha * given[0] + turn * given[1],
                         quarter = alpha * given[1] - turn * given[0];
#else
            const double same = alpha * given[q], quarter = 0.0;
#endif
            double x[DIM * DIM];
            slot = scatter(block_of_same(c, m->form_node[e], axes + q, same, quarter, x), x, slot,
                           value);
        }
    return slot;
}

/* momentum -= h Q for weights, loads and moments, all at the present increment d. */
static int32_t subtract_forces(const context *c, double *momentum)
{
    const holonom_model *m = c->m;
    const double h = c->h, *gravity = c->number + m->gravity_at;
    motion g;
    EACH_NODE(c, a) {
        const double mass = h * c->number[m->node_weight_at + a];
        EACH(k) momentum[DIM * a + k] -= mass * gravity[k];
    }
    for IN_ISLAND(c, j, ISLAND_LOAD) add_load(c, j, -h, momentum);
    for IN_ISLAND(c, j, ISLAND_MOMENT) {
        double f[DIM];
        form_motion(c, m->moment_form[j], &g);
        const int32_t status = moment_law(c, j, &g, f, NULL);
        if (status) return status;
        /* alpha = beta on a square form: the couple acts with alpha at each end */
        add_gradient(c, m->moment_form[j], -0.5 * h, f, f, momentum);
    }
#if DIM == 3
    for IN_ISLAND(c, j, ISLAND_BODY_MOMENT) {
        double moment[3], dual[9], f[9];
        const int32_t status = body_moment_law(c, j, moment, dual, f);
        if (status) return status;
        for (int k = 0; k < 9; k++) momentum[3 * m->body_moment[2 * j] + k] -= h * f[k];
    }
#endif
    return HOLONOM_OK;
}

/* Works of loads over the step. Where a law has no value, which is so for an increment that was
   only foreseen, as a solved one would have been refused, none. */
static double load_work(const context *c, int32_t j)
{
    double force[DIM], du[DIM], unused[DIM];
    load_force(c, j, force);
    link_of(c, c->m->load_form[j], c->k.d, du, unused);
    return dot(force, du);
}

static double moment_work(const context *c, int32_t j)
{
    double force[DIM];
    motion g;
    form_motion(c, c->m->moment_form[j], &g);
    return moment_law(c, j, &g, force, NULL) ? 0.0 : dot(force, g.du);
}

static double body_moment_work(const context *c, int32_t j)
{
    double work = 0.0;
#if DIM == 3
    double moment[3], dual[9], f[9];
    if (body_moment_law(c, j, moment, dual, f)) return 0.0;
    for (int k = 0; k < 9; k++) work += f[k] * c->k.d[3 * c->m->body_moment[2 * j] + k];
#else
    (void)c, (void)j;
#endif
    return work;
}

#endif
