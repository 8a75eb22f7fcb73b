/* Joints that rub in an impact.

   Each takes part as a contact of its own: its tangents are its slips, and p_N is the sum of the
   norms of the impulses in the rows that it rubs by, which are linear in all p. */
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
        if (x->contact[k] >= 0 && x->row[x->first[k]] >= begin[ISLAND_FUNCTION]
            && x->row[x->first[k]] < end[ISLAND_FUNCTION])
            return 1;
    return 0;
}

/* Tells the law which impulses press the joint of friction f, and which of them belong to one
   norm. */
static void press_by(const context *c, hit *x, int32_t f)
{
    const holonom_model *m = c->m;
    int32_t *continues = (int32_t *)(void *)c->k.hit_norms, at = 0;
    for (int32_t g = 0; g < f; g++)
        if (!is_of_contact(c, g)) at += m->normal_ptr[g + 1] - m->normal_ptr[g];
    x->force_begin[x->law.contacts - 1] = at;
    for (int32_t e = m->normal_ptr[f]; e < m->normal_ptr[f + 1]; e++)
        continues[at++] = m->normal_row[2 * e + 1] == NORMAL_CONTINUES;
    x->force_end[x->law.contacts - 1] = at;
}

/* Adds the joints that rub and that impulses of the contacts may reach; 0 if there is no room. */
HM_SELDOM static int add_joints_to_hit(const context *c, hit *x)
{
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        if (is_of_contact(c, f) || !(c->number[c->m->sliding_at + f] > 0.0)
            || !reaches(c, x, slip_row(c, f, 0)))
            continue;
        if (!add_rows_to_hit(c, x, -1 - f, -1, f, 0.0)) return 0;
        press_by(c, x, f);
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

#endif
