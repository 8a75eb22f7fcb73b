/* Pieces of the path of an impact in which rates of impulses stay as they are, and its books. */
#ifndef HOLONOM_STRAIGHT_PIECES_H
#define HOLONOM_STRAIGHT_PIECES_H

#include "impact_path.h"

/* e^2 C - X of contact i */
static inline double budget(const impact_path *s, int32_t i)
{
    return hm_square(s->x->restitution[i]) * s->x->compression[i] - s->x->expansion[i];
}

/* Counts the sizes of the terms of rates over a part h of the piece. */
HM_SELDOM static void grow_sizes(const impact_path *s, double h)
{
    for (int32_t k = 0; k < s->x->rows; k++)
        for (int32_t j = 0; j < s->x->rows; j++)
            s->size[k] += fabs(s->x->W[(int64_t)k * s->x->rows + j] * h * s->q[j]);
}

/* Whether a slip that is pushed turns. */
HM_SELDOM static int slip_turns(const impact_path *s)
{
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const int32_t k = s->x->first[i], n = impact_slips(s->x, i);
        if (n < 2 || s->walls.stuck[i] || !(s->q[k] > 0.0)) continue;
        const double *u = s->gamma + k + 1, *du = s->turn + k + 1, slip = hm_length(n, u);
        double along = 0.0, across = 0.0, terms = 0.0;
        for (int32_t a = 0; a < n; a++) along += u[a] * du[a] / slip;
        for (int32_t a = 0; a < n; a++) across += hm_square(du[a] - along * u[a] / slip);
        for (int32_t j = 0; j < s->x->rows; j++)
            terms += fabs(s->x->W[(int64_t)(k + 1) * s->x->rows + j] * s->q[j]);
        if (sqrt(across) > 1e-12 * hm_length(n, du) + 1e-15 * terms) return 1;
    }
    return 0;
}

/* Part of the piece after which the walls are at the ends of their ways: what no piece goes
   beyond. */
static inline double end_of_walls(const impact_path *s)
{
    double h = s->way_sign * s->tau < 0.0 ? fabs(s->tau) : INFINITY;
    for (int32_t i = 0; i < s->x->contacts; i++)
        if (s->walls.deep[i] > 0.0 && s->walls.rate[i] > 0.0)
            h = fmin(h, s->walls.deep[i] / s->walls.rate[i]);
    return h;
}

/* Length of a straight piece: until a slip stops, a contact meets its wall, or one has expanded. */
HM_SELDOM static double length_of_straight(const impact_path *s)
{
    const hm_impact *x = s->x;
    double h = end_of_walls(s);
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = impact_slips(x, i);
        if (n && !s->walls.stuck[i] && s->q[k] > 0.0) {
            const double slip = slip_now(s, i);
            double growth = 0.0;
            for (int32_t a = 1; a <= n; a++) growth += s->gamma[k + a] / slip * s->turn[k + a];
            if (growth < 0.0) h = fmin(h, slip / -growth);
        }
        const double gap = s->gamma[k] - wall_now(s, i), nears = s->walls.rate[i] - s->turn[k];
        if (!(s->q[k] > 0.0) && nears > 0.0 && gap > none_of_row(s, k) && impact_weight(x, i) > 0.0)
            h = fmin(h, gap / nears);
        if (s->walls.live[i] && s->tau >= 0.0 && s->q[k] > 0.0) {
            const double left = budget(s, i), a1 = s->q[k] * s->gamma[k],
                         a2 = 0.5 * s->q[k] * s->turn[k];
            const double square = a1 * a1 + 4.0 * a2 * left,
                         root = square >= 0.0 ? a1 + sqrt(square) : 0.0;
            if (root > 0.0 && left > 0.0) h = fmin(h, 2.0 * left / root);
        }
    }
    return h;
}

/* Books the work of impulses over a part of the path: of contact i along its normal, and of all
   friction. */
static inline void book_normal(const impact_path *s, int32_t i, double work)
{
    if (is_joint(s->x, i)) return;
    if (work < 0.0) s->x->compression[i] -= work;
    else s->x->expansion[i] += work;
}

/* Moves clock and walls on by a part h of the piece; returns whether a wall is back from its
   retreat. */
HM_SELDOM static int move_walls(impact_path *s, double h)
{
    int is_back = 0;
    if (h == fabs(s->tau) && s->way_sign * s->tau < 0.0) s->tau = 0.0;
    else s->tau += s->way_sign * h;
    if (fabs(s->tau) < SWEEP_ROUND_OFF)
        s->tau = 0.0; /* what slips stop with the walls has no order */
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const double way = h * s->walls.rate[i];
        if (s->walls.live[i]) s->walls.deep[i] = 0.0;
        else s->walls.deep[i] -= way;
        if (s->walls.deep[i] > none_of_row(s, s->x->first[i])) continue;
        is_back |= s->walls.deep[i] != 0.0 || (way > 0.0 && !s->walls.live[i]);
        s->walls.deep[i] = 0.0;
        s->walls.waits[i] = 0;
    }
    return is_back;
}

HM_SELDOM static void go_straight(impact_path *s, double h)
{
    const hm_impact *x = s->x;
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i];
        book_normal(s, i, h * s->q[k] * (s->gamma[k] + 0.5 * h * s->turn[k]));
        for (int32_t t = k + 1; t <= k + x->tangents[i]; t++)
            s->x->friction -= h * s->q[t] * (s->gamma[t] + 0.5 * h * s->turn[t]);
    }
    grow_sizes(s, h);
    for (int32_t k = 0; k < x->rows; k++) {
        s->gamma[k] += h * s->turn[k];
        x->impulse[k] += h * s->q[k];
    }
    move_walls(s, h);
}

#endif
