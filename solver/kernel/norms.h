/* Sizes of motions in the mass norm. */
#ifndef HOLONOM_NORMS_H
#define HOLONOM_NORMS_H

#include "context.h"

static double mass_norm(const context *c, const double *x)
{
    double sum = 0.0;
    for (int32_t a = 0; a < c->m->n_free; a++) sum += c->number[c->m->node_mass_at + a] * dot(x + DIM * a, x + DIM * a);
    return sqrt(sum);
}

/* Largest of phi (n_rows) over the scale of its row, of the rows at hand. */
static double largest_row(const context *c, const double *phi)
{
    double largest = 0.0;
    EACH_ROW(c, i) {
        const double scaled = fabs(phi[i]) / c->number[c->m->row_scale_at + i];
        if (!(scaled <= largest) && largest == largest) largest = scaled; /* a NaN stays */
    }
    return largest;
}

/* Speed of the mechanism, in the mass norm; 0 only as long as nothing has moved or could. */
static double speed_scale(const context *c)
{
    return fmax(sqrt(2.0 * c->s.head[S_ENERGY_REFERENCE]), mass_norm(c, c->s.v));
}

/* Mass norms of a difference in q and in v, relative to size and speed of the mechanism. */
static double relative_size(const context *c, double of_q, double of_v)
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
