/* The motion: all that time integrates, as one vector, whatever it has in it.

   A state has it (MOTION of layout.py, n_motion numbers) from q on and, in the same order, what
   rounding left over from q_low on. A change of it is a vector (n_motion) as well: places, then
   velocities, then the others. */
#ifndef HOLONOM_MOTION_H
#define HOLONOM_MOTION_H

#include "norms.h"

/* Takes a section of the state, of so many numbers, back from a backup of the state. */
static inline void take_section(context *c, double *section, int64_t count, const double *backup)
{
    memcpy(section, backup + (section - c->s.head), sizeof(double) * (size_t)count);
}

/* Takes the motion back from a backup of the state. */
static void take_motion_back(context *c, const double *backup)
{
    take_section(c, c->s.q, 2 * c->s.n_motion, backup); /* what rounding left over lies behind */
}

/* Likewise all that goes with it, the ledger included. */
static void go_back(context *c, const double *backup)
{
    take_motion_back(c, backup);
    take_section(c, c->s.imbalance, c->s.n_following, backup);
    take_section(c, c->s.head + S_WORK, 2 * N_ACCOUNTS, backup);
}

/* x += weight times the change of the motion since a backup of the state. */
static void add_change(const context *c, const double *backup, double weight, double *x)
{
    const double *high = c->s.q, *low = c->s.q_low;
    const double *high0 = backup + (high - c->s.head), *low0 = backup + (low - c->s.head);
    for (int64_t k = 0; k < c->s.n_motion; k++)
        x[k] += weight * ((high[k] - high0[k]) + (low[k] - low0[k]));
}

/* Adds a change to the motion. */
static void change_motion(context *c, const double *x)
{
    for (int64_t k = 0; k < c->s.n_motion; k++) hm_add(c->s.q + k, c->s.q_low + k, x[k]);
}

/* Adds what a time h adds along the parabola of the velocities and accelerations a (n). */
static void move_along(context *c, double h, const double *a)
{
    for (int64_t k = 0; k < DIM * c->n_moving; k++) {
        hm_add(c->s.q + k, c->s.q_low + k, h * (c->s.v[k] + 0.5 * h * a[k]));
        hm_add(c->s.v + k, c->s.v_low + k, h * a[k]);
    }
}

/* Size of a change of the motion, relative to size and speed of the mechanism. */
static double motion_norm(const context *c, const double *x)
{
    return relative_size(c, mass_norm(c, x), mass_norm(c, x + DIM * c->n_moving));
}

/* Likewise of an error, in which islands count as in weight_of_island. */
static double motion_error(const context *c, const double *x)
{
    return relative_size(c, error_norm(c, x), error_norm(c, x + DIM * c->n_moving));
}

/* Largest error of a node, of a step of length h. */
static double motion_error_at_node(const context *c, const double *x, double h)
{
    const node_scales scales = scales_of_nodes(c, h);
    return hm_hypot(largest_node_error(c, &scales, 0, x),
                    largest_node_error(c, &scales, 1, x + DIM * c->n_moving));
}

#endif
