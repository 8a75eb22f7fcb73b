/* Sizes of motions in the mass norm, and of their differences as a user sees them. */
#ifndef HOLONOM_NORMS_H
#define HOLONOM_NORMS_H

#include "context.h"

static double mass_norm(const context *c, const double *x)
{
    double sum = 0.0;
    for (int32_t a = 0; a < c->m->n_free; a++) sum += c->number[c->m->node_mass_at + a] * dot(x + DIM * a, x + DIM * a);
    return sqrt(sum);
}

/* The larger one; a NaN stays. */
static inline double larger(double largest, double x) { return !(x <= largest) && largest == largest ? x : largest; }

/* Largest of phi (n_rows) over the scale of its row, of the rows at hand. */
static double largest_row(const context *c, const double *phi)
{
    double largest = 0.0;
    EACH_ROW(c, i) largest = larger(largest, fabs(phi[i]) / c->number[c->m->row_scale_at + i]);
    return largest;
}

/* Largest angular velocity among those of the nodes, and speed over the size of the mechanism [1/s]; likewise of accelerations. */
static double fastest_rate(const context *c, const double *v)
{
    double fastest = 0.0;
    for (int32_t a = 0; a < c->n_moving; a++) {
        const double speed = sqrt(dot(v + DIM * a, v + DIM * a));
        fastest = fmax(fastest, c->m->node_kind[a] ? speed : speed / c->number[c->m->extent_at]);
    }
    return fastest;
}

/* Speed of the mechanism, in the mass norm; 0 only as long as nothing has moved or could. */
static double speed_scale(const context *c)
{
    return fmax(sqrt(2.0 * c->s.head[S_ENERGY_REFERENCE]), mass_norm(c, c->s.v));
}

/* What differences of places, or of velocities, of points [0] and of directions [1] are compared with: the extent and 1, or the fastest
   of either, and no less than the energy of the run makes of all. */
HM_SELDOM static void scales_of_nodes(const context *c, int of_velocities, double *scale)
{
    const double extent = c->number[c->m->extent_at];
    scale[0] = of_velocities ? speed_scale(c) * extent / c->number[c->m->extent_at + 1] : extent;
    scale[1] = scale[0] / extent;
    for (int32_t a = 0; a < c->m->n_free && of_velocities; a++) {
        double *fastest = scale + (c->m->node_kind[a] != 0);
        *fastest = fmax(*fastest, sqrt(dot(c->s.v + DIM * a, c->s.v + DIM * a)));
    }
}

/* Largest difference of a point, or a direction, in u (n) over what it is compared with; heavy parts hide no light ones. 0 of
   velocities where nothing has moved or could. */
HM_SELDOM static double largest_difference(const context *c, const double *u, int of_velocities)
{
    double scale[2], largest = 0.0;
    scales_of_nodes(c, of_velocities, scale);
    for (int32_t a = 0; a < c->m->n_free && scale[0] > 0.0; a++)
        largest = larger(largest, sqrt(dot(u + DIM * a, u + DIM * a)) / scale[c->m->node_kind[a] != 0]);
    return largest;
}

/* Size of a difference in q and in v, relative to size and speed of the mechanism. */
static double relative_size(const context *c, const double *dq, const double *dv)
{
    return hm_hypot(largest_difference(c, dq, 0), largest_difference(c, dv, 1));
}

/* Likewise of mass norms, for steps of order 2: what is light, on a spring that pairs do not resolve, swings a little and goes nowhere. */
static double size_by_mass(const context *c, double of_q, double of_v)
{
    const double speed = speed_scale(c);
    return hm_hypot(of_q / c->number[c->m->extent_at + 1], speed > 0.0 ? of_v / speed : 0.0);
}

/* How fast velocities change [1/s]; 0: at rest, and for ever. */
static double rate_of_motion(const context *c)
{
    const double size = c->number[c->m->extent_at + 1], speed = mass_norm(c, c->s.v) / size;
    return sqrt(mass_norm(c, c->s.a[0]) / size + speed * speed);
}

/* Error of a run that is asked for, relative to size and speed. */
static inline double tolerated(const context *c)
{
    return c->s.head[S_TOLERANCE] + c->s.head[S_ABSOLUTE_TOLERANCE] / c->number[c->m->extent_at];
}

#endif
