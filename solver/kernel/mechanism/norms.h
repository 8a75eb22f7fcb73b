/* Sizes of motions in the mass norm. */
#ifndef HOLONOM_NORMS_H
#define HOLONOM_NORMS_H

#include "context.h"

static double mass_norm(const context *c, const double *x)
{
    double sum = 0.0;
    for (int32_t a = 0; a < c->m->n_free; a++)
        sum += c->number[c->m->node_mass_at + a] * dot(x + DIM * a, x + DIM * a);
    return sqrt(sum);
}

static double mass_of_nodes(const context *c, int32_t begin, int32_t end)
{
    double sum = 0.0;
    for (int32_t a = begin; a < end; a++) sum += c->number[c->m->node_mass_at + a];
    return sum;
}

static double mass_of_all(const context *c) { return mass_of_nodes(c, 0, c->m->n_free); }

/* Free node a of an island, whose free nodes end at `end` and have the mass `all` together [kg]. */
typedef struct island_node {
    int32_t a, end;
    double all;
} island_node;

/* The first one of island i. */
static island_node first_node(const context *c, int32_t i)
{
    const int32_t *begin = c->m->island_begin + ISLAND_COLUMNS * i + ISLAND_FREE;
    return (island_node){begin[0], begin[ISLAND_COLUMNS],
                         mass_of_nodes(c, begin[0], begin[ISLAND_COLUMNS])};
}

/* Each free node, island by island: two loops, so that `break` would leave an island alone. */
#define EACH_FREE_NODE(c, node)                                                                    \
    for (int32_t island = 0; island < (c)->m->n_islands; island++)                                 \
        for (island_node node = first_node(c, island); node.a < node.end; node.a++)

/* By how much errors of an island of the mass `own`, in the mass norm, count more than those of
   all: else heavy ones would hide light ones. */
static double weight_of_island(const context *c, double own, double all)
{ return own > 0.0 && c->m->n_islands > 1 ? all / own : 1.0; }

/* Square of the mass norm of an error x (n), in which islands count as in weight_of_island. */
HM_SELDOM static double norm2_of_islands(const context *c, const double *x)
{
    const double all = mass_of_all(c);
    double sum = 0.0;
    EACH_FREE_NODE(c, node)
        sum += weight_of_island(c, node.all, all) * c->number[c->m->node_mass_at + node.a]
               * dot(x + DIM * node.a, x + DIM * node.a);
    return sum;
}

/* Mass norm of an error x (n). */
static double error_norm(const context *c, const double *x)
{ return c->m->n_islands > 1 ? sqrt(norm2_of_islands(c, x)) : mass_norm(c, x); }

/* The larger of phi[i] over the scale of its row and `largest`; a NaN stays. */
static inline double larger_row(const context *c, const double *phi, int32_t i, double largest)
{
    const double scaled = fabs(phi[i]) / c->number[c->m->row_scale_at + i];
    return !(scaled <= largest) && largest == largest ? scaled : largest;
}

/* Largest of phi (n_rows) over the scale of its row, of the rows at hand. */
static double largest_row(const context *c, const double *phi)
{
    double largest = 0.0;
    EACH_ROW(c, i) largest = larger_row(c, phi, i, largest);
    return largest;
}

/* Likewise, with the rows that keep directors of bodies orthonormal. */
HM_SELDOM static double largest_of_all(const context *c, const double *phi)
{
    const holonom_model *m = c->m;
    double largest = largest_row(c, phi);
    for (int32_t i = first_rigidity_row(m); i < m->n_form_rows; i++)
        largest = larger_row(c, phi, i, largest);
    return largest;
}

/* Largest angular velocity among those of the nodes, and speed over the size of the mechanism
   [1/s]; likewise of accelerations. */
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

/* Mass norms of a difference in q and in v, relative to size and speed of the mechanism. */
static double relative_size(const context *c, double of_q, double of_v)
{
    const double speed = speed_scale(c);
    return hm_hypot(of_q / c->number[c->m->extent_at + 1], speed > 0.0 ? of_v / speed : 0.0);
}

#define UNHELD 2.0 /* freedom of a node that no row holds */

/* Of the largest error of a node, in an error of the motion. With 1 scenes take 1.05 times the
   increments of the mass norm alone, with 0.6 1.015 times. */
#define NODES_COUNT 0.6
#define ROUND_OFF_OF_NODES 1e-14 /* of a node that has all of its island's mass, see node_error */

/* What errors at nodes are compared with. */
typedef struct node_scales {
    double point[2], direction[2]; /* of places, and of velocities; 0: nothing has moved or could */
    double round_off; /* of an error at a node that has all of its island's mass */
} node_scales;

/* Scales of errors of a step of length h: extent and 1, and the fastest of either now, but no less
   than the energy of the run makes of all. */
HM_SELDOM static node_scales scales_of_nodes(const context *c, double h)
{
    const double extent = c->number[c->m->extent_at];
    const double speed = speed_scale(c) * extent / c->number[c->m->extent_at + 1];
    node_scales x = {.point = {extent, speed}, .direction = {1.0, speed / extent}};
    for (int32_t a = 0; a < c->m->n_free; a++) {
        double *fastest = c->m->node_kind[a] ? x.direction + 1 : x.point + 1;
        *fastest = fmax(*fastest, sqrt(dot(c->s.v + DIM * a, c->s.v + DIM * a)));
    }
    x.round_off = ROUND_OFF_OF_NODES * (1.0 + extent / (fabs(h) * fmax(x.point[1], 1e-300)));
    return x;
}

/* Error of a size at a node, of a mass [kg, kg m^2], over its scale, without what round-off
   explains. Newton's iteration ends by the mass norm, so that velocities of light nodes have more
   round-off. */
static double node_error(const context *c, const node_scales *x, int of_velocities,
                         island_node node, double size, double mass)
{
    const int is_direction = c->m->node_kind[node.a] != 0;
    const double scale = (is_direction ? x->direction : x->point)[of_velocities],
                 whole = is_direction ? node.all * hm_square(c->number[c->m->extent_at]) : node.all;
    if (!(mass > 0.0 && scale > 0.0)) return 0.0;
    return NODES_COUNT * (size / scale - x->round_off * sqrt(whole / mass));
}

/* Largest of node_error in x (n), which the mass norm hides where other nodes are heavy. */
HM_SELDOM static double largest_node_error(const context *c, const node_scales *scales,
                                           int of_velocities, const double *x)
{
    double largest = 0.0;
    EACH_FREE_NODE(c, node) {
        const double *own = x + DIM * node.a;
        const double error = node_error(c, scales, of_velocities, node, sqrt(dot(own, own)),
                                        c->number[c->m->node_mass_at + node.a]);
        if (!(error <= largest)) largest = error; /* a NaN, too */
    }
    return largest;
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
    return c->tolerance + c->s.head[S_ABSOLUTE_TOLERANCE] / c->number[c->m->extent_at];
}

#endif
