/* A metric in which all points weigh nearly the same, and all directors: beside heavy parts light
   ones would do all of the moving, and rows have compliances by their largest term (row_sigma), so
   that those between heavy parts would hardly be seen. Factors of masses are squares of powers of
   2, which leave no round-off in them. */
#ifndef HOLONOM_EVEN_METRIC_H
#define HOLONOM_EVEN_METRIC_H

#include "equations_at_state.h"
#include "scales.h"

/* Multiplies masses of free nodes by squares of `factor`, or divides them. */
static void scale_masses(const context *c, const double *factor, int back)
{
    const holonom_model *m = c->m;
    double *mass = c->number + m->mass_at, *share = c->number + m->node_mass_at;
    for (int32_t e = 0; e < m->n_mass; e++)
        for (int side = 0; side < 2; side++) {
            const int32_t a = m->mass_node[2 * e + side];
            if (a < m->n_free) mass[e] *= back ? 1.0 / factor[a] : factor[a];
        }
    for (int32_t a = 0; a < m->n_free; a++)
        share[a] *= back ? 1.0 / hm_square(factor[a]) : hm_square(factor[a]);
}

/* Lets masses differ by less than a factor of 4. Links are those at the state. */
HM_SELDOM static int32_t take_even_metric(context *c)
{
    const holonom_model *m = c->m;
    const double extent = c->number[m->extent_at];
    double *factor = c->k.estimate, points = 0.0;
    for (int32_t a = 0; a < m->n_free; a++) {
        const double wanted =
            (m->node_kind[a] ? extent : 1.0) / sqrt(c->number[m->node_mass_at + a]);
        for (factor[a] = 1.0; factor[a] < wanted;) factor[a] *= 2.0;
        while (factor[a] > wanted) factor[a] *= 0.5;
        points += m->node_kind[a] ? 0.0 : 1.0;
    }
    scale_masses(c, factor, 0);
    const int32_t status = derive_scales(c);
    c->number[m->extent_at + 1] = extent * sqrt(fmax(points, 1.0));
    return status;
}

HM_SELDOM static void leave_even_metric(const context *c)
{
    scale_masses(c, c->k.estimate, 1);
    memcpy(c->number + c->m->extent_at, c->s.derived, derived_bytes(c->m));
}

#endif
