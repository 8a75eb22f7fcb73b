/* Rows of the contacts that take part in an impact, and the velocities that impulses along them
   bring about while all bilateral rows hold. */
#ifndef HOLONOM_IMPACT_ROWS_H
#define HOLONOM_IMPACT_ROWS_H

#include "impact_sweep.h"
#include "start.h"

/* Momentum += factor times the gradient of row j at the state; of a velocity row with respect to
   the velocities. */
HM_SELDOM static int32_t add_row_gradient(const context *c, int32_t j, double factor)
{
    composite_result result = {0.0, 0.0, 0.0};
    context still = *c;
    still.h = 1.0;
    const int32_t status = composite_slopes(&still, j, SLOPES_ALONE, &result);
    if (!status) add_slopes(c, j, factor, c->k.slope);
    return status;
}

/* Velocities x (n, overwritten) that impulses, `momentum` with the other sign, bring about; those
   of the rows are in mu. */
HM_SELDOM static void velocities_of_impulses(const context *c, double *x)
{
    memset(c->k.phi, 0, sizeof(double) * (size_t)c->m->n_rows);
    solve_for(c, x);
}

/* An impact as it is set up: the rows of contacts that take part, and what is known of each. */
typedef struct hit {
    hm_impact law;
    double *W, *coefficient, *restitution, *before; /* what law reads, to be filled */
    double *normal, *out; /* in stepped mode: impulses of the first stage, see velocity_stage.h */
    int32_t *first, *tangents, *force_begin, *force_end; /* likewise */
    int32_t *contact; /* number of each contact that takes part; of joint friction f -1 - f */
    int32_t *row;     /* composite of each row; -1: of the normal force of a joint */
} hit;

/* Lays the vectors of an impact over the scratch. */
HM_SELDOM static void map_hit(const context *c, hit *x)
{
    const int64_t n = c->m->n_hit_rows;
    double *d = c->k.hit;
    int32_t *i = (int32_t *)(void *)(d + 9 * n);
    x->W = c->k.hit_matrix;
    x->restitution = d;
    x->coefficient = d + n;
    x->before = d + 2 * n;
    x->normal = d + 7 * n;
    x->out = d + 8 * n;
    x->first = i;
    x->tangents = i + n;
    x->force_begin = i + 2 * n;
    x->force_end = i + 3 * n;
    x->contact = i + 4 * n;
    x->row = i + 5 * n;
    x->law = (hm_impact){.W = x->W,
                         .restitution = d,
                         .coefficient = x->coefficient,
                         .before = x->before,
                         .impulse = d + 3 * n,
                         .after = d + 4 * n,
                         .compression = d + 5 * n,
                         .expansion = d + 6 * n,
                         .joints.forces = c->m->n_hit_forces,
                         .joints.force = c->k.hit_force,
                         .scratch = c->k.hit_scratch,
                         .first = x->first,
                         .tangents = x->tangents,
                         .joints.begin = x->force_begin,
                         .joints.end = x->force_end,
                         .joints.continues = (const int32_t *)(const void *)c->k.hit_norms};
}

/* Adds friction f with that normal row, of a contact or of the joint that rubs; 0 if there is no
   room. */
HM_SELDOM static int add_rows_to_hit(const context *c, hit *x, int32_t contact, int32_t row,
                                     int32_t f, double restitution)
{
    const int32_t k = x->law.contacts, slips = f < 0 ? 0 : n_slips(c, f);
    if (x->law.rows + 1 + slips > c->m->n_hit_rows) return 0;
    x->first[k] = x->law.rows;
    x->tangents[k] = slips;
    x->coefficient[k] = f < 0 ? 0.0 : c->number[c->m->sliding_at + f];
    x->restitution[k] = restitution;
    x->force_begin[k] = x->force_end[k] = 0;
    x->contact[k] = contact;
    x->row[x->law.rows++] = row;
    for (int s = 0; s < slips; s++) x->row[x->law.rows++] = slip_row(c, f, s);
    x->law.contacts++;
    return 1;
}

/* Adds contact i with its friction; 0 if there is no room. */
HM_SELDOM static int add_to_hit(const context *c, hit *x, int32_t i, double restitution)
{
    return add_rows_to_hit(c, x, i, c->m->contact_row[i], c->m->contact_friction[i], restitution);
}

#endif
