/* A metric in which all points weigh the same, and all directors: rows have compliances by their largest term (row_sigma), so that
   beside very light parts those between heavy ones would hardly be seen. */
#ifndef HOLONOM_EVEN_METRIC_H
#define HOLONOM_EVEN_METRIC_H

#include "context.h"
#include "start.h"

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

typedef struct even_metric {
    double *weight, *mass, *sigma; /* of free nodes, over their masses; masses and row_sigma as they were */
} even_metric;

/* Gives nodes even masses, of norms alone: solve_at_state takes `weight`. */
HM_SELDOM static int32_t take_even_metric(context *c, even_metric *x)
{
    const holonom_model *m = c->m;
    double *mass = c->number + m->node_mass_at;
    *x = (even_metric){c->k.estimate, c->k.estimate + m->n_free, c->k.moved};
    memcpy(x->mass, mass, sizeof(double) * (size_t)c->n_moving);
    memcpy(x->sigma, c->number + m->row_sigma_at, sizeof(double) * (size_t)m->n_rows);
    for (int32_t a = 0; a < m->n_free; a++) {
        const double even = m->node_kind[a] ? hm_square(c->number[m->extent_at]) : 1.0;
        x->weight[a] = even / mass[a];
        mass[a] = even;
    }
    return derive_scales(c);
}

HM_SELDOM static void leave_even_metric(const context *c, const even_metric *x)
{
    memcpy(c->number + c->m->node_mass_at, x->mass, sizeof(double) * (size_t)c->n_moving);
    memcpy(c->number + c->m->row_sigma_at, x->sigma, sizeof(double) * (size_t)c->m->n_rows);
}

#endif
