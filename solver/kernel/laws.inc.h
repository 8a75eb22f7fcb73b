/* Forces besides the constraints: springs, dampers, moments and loads, each with the discrete form whose work
   is exact. Included once per dimension, after forms.inc.h.                                                 */

/* Spring and damper along a link of length l: tension N = k (lbar - l_free) + c dl/h acts along
   2 u_m/(l_0 + l_1), so that its work is exactly -dV - c dl^2/h (Gonzalez 2000; paper, eq 11).                */
typedef struct line_state {
    double kappa;    /* N/(l_0 + l_1) [N/m]: force on node a is -kappa 2 alpha_a u_m                          */
    double slope;    /* d kappa / d l_1                                                                      */
    double l1, rate; /* length at the end [m], elongation in the step [m]                                    */
} line_state;

static int32_t line_law(const context *c, int32_t j, const motion *g, line_state *law)
{
    const double k = c->number[c->m->stiffness_at + j], free_length = c->number[c->m->free_length_at + j];
    const double damping = c->number[c->m->damping_at + j];
    if (!(k >= 0.0 && free_length >= 0.0 && damping >= 0.0)) return HOLONOM_BAD_LAW;
    double u1[DIM];
    EACH(i) u1[i] = g->u0[i] + g->du[i];
    const double l0 = sqrt(dot(g->u0, g->u0)), sum = l0 + (law->l1 = sqrt(dot(u1, u1)));
    law->kappa = 0.5 * k;
    law->slope = law->rate = 0.0;
    if (free_length == 0.0 && damping == 0.0) return HOLONOM_OK; /* V = k s/2: no direction is needed         */
    if (!(l0 > 0.0) || !(law->l1 > 0.0)) return HOLONOM_ZERO_LENGTH;
    law->rate = 2.0 * dot(g->um, g->du) / sum; /* not l_1 - l_0: that would cancel                            */
    law->kappa += (damping * law->rate / c->h - k * free_length) / sum;
    law->slope = (k * free_length + damping * (sum - law->rate) / c->h) / (sum * sum);
    return HOLONOM_OK;
}

/* Moment m on a link u: couple f = g (m x u_m) with g = beta/|u_0 x u_1|, beta the angle between u_0 and u_1.
   In the plane its work is exactly m beta. f (DIM) and, if wanted, its tangent in du (DIM x DIM), overwritten. */
static void moment_tangent(const double *moment, const motion *g, const double *cross, double size2, double y,
                           double factor, const double *f, double *tangent)
{
    const double z2 = size2 / (y * y), radius2 = size2 + y * y;
    const double c1 = z2 < 1e-4 ? (-2.0 / 3.0 + z2 * (0.8 - z2 * (6.0 / 7.0 - z2 * 8.0 / 9.0))) / (y * y * y)
                                : (y / radius2 - factor) / size2;
    double direction[DIM], axis[3] = {0.0, 0.0, 0.0};
#if DIM == 2
    axis[2] = moment[0];
    direction[0] = -c1 * cross[0] * g->u0[1] - g->u0[0] / radius2;
    direction[1] = c1 * cross[0] * g->u0[0] - g->u0[1] / radius2;
#else
    EACH(i) axis[i] = moment[i];
    EACH(i) direction[i] = c1 * (cross[(i + 1) % 3] * g->u0[(i + 2) % 3] - cross[(i + 2) % 3] * g->u0[(i + 1) % 3]) -
                           g->u0[i] / radius2;
#endif
    const double skew[3][3] = {{0.0, -axis[2], axis[1]}, {axis[2], 0.0, -axis[0]}, {-axis[1], axis[0], 0.0}};
    EACH(i) EACH(j) tangent[DIM * i + j] = 0.5 * factor * skew[i][j] + f[i] / factor * direction[j];
}

static int32_t moment_law(const context *c, int32_t j, const motion *g, double *f, double *tangent)
{
    double u1[DIM];
    EACH(i) u1[i] = g->u0[i] + g->du[i];
    const double y = dot(g->u0, u1);
#if DIM == 2
    const double *moment = c->number + c->m->moment_at + j;
    const double cross[1] = {g->u0[0] * u1[1] - g->u0[1] * u1[0]};
    const double size2 = cross[0] * cross[0];
    f[0] = -moment[0] * g->um[1];
    f[1] = moment[0] * g->um[0];
#else
    const double *moment = c->number + c->m->moment_at + 3 * j;
    double cross[3];
    EACH(i) cross[i] = g->u0[(i + 1) % 3] * u1[(i + 2) % 3] - g->u0[(i + 2) % 3] * u1[(i + 1) % 3];
    const double size2 = dot(cross, cross);
    EACH(i) f[i] = moment[(i + 1) % 3] * g->um[(i + 2) % 3] - moment[(i + 2) % 3] * g->um[(i + 1) % 3];
#endif
    if (!(size2 + y * y > 0.0)) return HOLONOM_ZERO_LENGTH;
    const double size = sqrt(size2), z2 = size2 / (y * y);
    const double factor = y > 0.0 && z2 < 1e-4 ? (1.0 - z2 * (1.0 / 3.0 - z2 * (0.2 - z2 / 7.0))) / y
                                               : atan2(size, y) / size;
    EACH(i) f[i] *= factor;
    if (tangent) moment_tangent(moment, g, cross, size2, y, factor, f, tangent);
    return HOLONOM_OK;
}

/* momentum -= h Q for loads, gravity, springs, dampers and moments, all at the present increment d. */
static int32_t subtract_forces(context *c, double *momentum)
{
    const holonom_model *m = c->m;
    const double h = c->h, *gravity = c->number + m->gravity_at;
    motion g;
    for (int32_t a = 0; a < m->n_free; a++) {
        const double mass = h * c->number[m->node_mass_at + a];
        EACH(k) momentum[DIM * a + k] -= mass * gravity[k];
    }
    for (int32_t j = 0; j < m->n_loads; j++)
        EACH(k) momentum[DIM * m->load_node[j] + k] -= h * c->number[m->load_at + DIM * j + k];
    for (int32_t j = 0; j < m->n_lines; j++) {
        line_state law;
        form_motion(c, m->line_form[j], &g);
        const int32_t status = line_law(c, j, &g, &law);
        if (status) return status;
        add_gradient(c, m->line_form[j], h * law.kappa, g.um, g.wm, momentum);
    }
    for (int32_t j = 0; j < m->n_moments; j++) {
        double f[DIM];
        form_motion(c, m->moment_form[j], &g);
        const int32_t status = moment_law(c, j, &g, f, NULL);
        if (status) return status;
        /* alpha = beta on a square form: the couple acts with alpha at each end */
        add_gradient(c, m->moment_form[j], -0.5 * h, f, f, momentum);
    }
    return HOLONOM_OK;
}
