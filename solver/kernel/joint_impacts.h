/* Joints that rub in an impact.

   Each takes part as a contact of its own: its tangents are its slips, and the equation of its normal row is p_N = d . P,
   with P the impulses of the rows that it rubs by, linear in all p, and d their direction, found by iteration.   */
#ifndef HOLONOM_JOINT_IMPACTS_H
#define HOLONOM_JOINT_IMPACTS_H

#include "impact_rows.h"

/* Whether a contact that takes part is of the island of composite j. */
HM_SELDOM static int reaches(const context *c, const hit *x, int32_t j)
{
    const int32_t *end = c->m->island_begin + ISLAND_COLUMNS;
    while (j >= end[ISLAND_VELOCITY]) end += ISLAND_COLUMNS;
    const int32_t *begin = end - ISLAND_COLUMNS;
    for (int32_t k = 0; k < x->law.contacts; k++)
        if (x->contact[k] >= 0 && x->row[x->first[k]] >= begin[ISLAND_FUNCTION] && x->row[x->first[k]] < end[ISLAND_FUNCTION])
            return 1;
    return 0;
}

/* Adds the joints that rub and that impulses of the contacts may reach; 0 if there is no room. */
HM_SELDOM static int add_joints_to_hit(const context *c, hit *x)
{
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        if (is_of_contact(c, f) || !(c->number[c->m->sliding_at + f] > 0.0) || !reaches(c, x, slip_row(c, f, 0))) continue;
        if (!add_rows_to_hit(c, x, -1 - f, -1, f, 0.0)) return 0;
    }
    return 1;
}

/* Keeps the impulses that row r brings about in the joints that rub (in mu). */
static void keep_joint_impulses(const context *c, int32_t r)
{
    const holonom_model *m = c->m;
    double *force = c->k.hit_force + (int64_t)m->n_hit_forces * r;
    for (int32_t f = 0; f < m->n_frictions; f++)
        for (int32_t at = m->normal_ptr[f]; at < m->normal_ptr[f + 1] && !is_of_contact(c, f); at++)
            *force++ = c->k.mu[m->normal_row[2 * at]];
}

/* Equations p_N = d . P of the joints that rub, with the directions d of the present impulses P: rows of W, scaled as those
   of their slips. Returns the largest |p_N - |P|| over the largest |P|.                                          */
static double press_joints(const context *c, const hit *x)
{
    const holonom_model *m = c->m;
    const int32_t rows = x->law.rows;
    double error = 0.0, largest = 0.0;
    for (int32_t k = 0; k < x->law.contacts; k++) {
        const int32_t joint = -1 - x->contact[k], normal = x->first[k];
        double *line = x->W + (int64_t)rows * normal, pressed = 0.0;
        const double *force = c->k.hit_force;
        if (joint < 0) continue;
        const double slip = x->W[(int64_t)rows * (normal + 1) + normal + 1], scale = slip > 0.0 ? slip : 1.0;
        for (int32_t f = 0; f < joint; f++)
            if (!is_of_contact(c, f)) force += m->normal_ptr[f + 1] - m->normal_ptr[f];
        memset(line, 0, sizeof(double) * (size_t)rows);
        for (int32_t at = m->normal_ptr[joint]; at < m->normal_ptr[joint + 1];) {
            const double *first = force;
            double sum = 0.0;
            do {
                double impulse = 0.0;
                for (int32_t s = 0; s < rows; s++) impulse += x->law.impulse[s] * force[(int64_t)m->n_hit_forces * s];
                c->k.row_rate[m->normal_row[2 * at]] = impulse;
                sum += hm_square(impulse);
                at++, force++;
            } while (at < m->normal_ptr[joint + 1] && m->normal_row[2 * at + 1] == NORMAL_CONTINUES);
            const double root = sqrt(sum);
            const int32_t begin = at - (int32_t)(force - first);
            for (int32_t e = 0; e < at - begin && root > 0.0; e++)
                for (int32_t s = 0; s < rows; s++)
                    line[s] -= scale * c->k.row_rate[m->normal_row[2 * (begin + e)]] / root * first[e + (int64_t)m->n_hit_forces * s];
            pressed += root;
        }
        line[normal] += scale;
        error = fmax(error, fabs(x->law.impulse[normal] - pressed));
        largest = fmax(largest, pressed);
    }
    return largest > 0.0 ? error / largest : 0.0;
}

enum { MOST_PRESSES = 100 };

/* Solves the law of impact; returns 0, or 1 if no impulses were found. */
static int solve_hit(const context *c, hit *x)
{
    memset(x->law.impulse, 0, sizeof(double) * (size_t)x->law.rows);
    for (int turn = 0; turn < MOST_PRESSES; turn++) {
        const double error = press_joints(c, x);
        if (turn > 0 && error <= IMPACT_TOLERANCE) return 0;
        memcpy(x->law.restitution, x->given, sizeof(double) * (size_t)x->law.contacts);
        if (hm_solve_impact(&x->law)) return 1;
    }
    return 1;
}

#endif
