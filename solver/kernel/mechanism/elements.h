/* Elements: what stores, takes or gives energy along quantities, one record of functions for each
   kind (theory 5). Slopes over a step come from next_slopes, for residual, tangent and ledger; what
   else is asked of an element is here. */
#ifndef HOLONOM_ELEMENTS_H
#define HOLONOM_ELEMENTS_H

#include "function.h"

/* What drives do, and what dampers take [J]. */
typedef struct element_work {
    double done, lost;
} element_work;

/* Factor of the rate in the force of a damper, and the force of a drive. */
typedef struct element_bound {
    double damping, drive;
} element_bound;

typedef struct element_kind {
    double (*energy)(const context *c, int32_t j); /* stored at the state; quantities are known */
    /* Of what that and the drive's work are summed of. */
    void (*add_sizes)(const context *c, int32_t j, double *sum);
    element_work (*step)(const context *c, int32_t j); /* in the step that is solved */
    /* In a time at the state's rates. */
    element_work (*rate)(const context *c, int32_t j, double time);
    element_bound (*bound)(const context *c, int32_t j);
} element_kind;

/* Elements at hand; the last ones are potentials. */
static inline int32_t next_element(const context *c, int32_t j)
{
    return j < c->view.end[ISLAND_ELEMENT] || j > c->view.begin[ISLAND_POTENTIAL]
               ? j
               : c->view.begin[ISLAND_POTENTIAL];
}

#define EACH_ELEMENT(c, j)                                                                         \
    for (int32_t j##_end = (c)->view.end[ISLAND_POTENTIAL],                                        \
                 j = next_element(c, (c)->view.begin[ISLAND_ELEMENT]);                             \
         j < j##_end; j = next_element(c, j + 1))

/* Of springs, dampers and drives, which act along one quantity. */
static inline int32_t quantity_of_element(const context *c, int32_t j)
{ return c->m->leaf[4 * c->m->leaf_ptr[j] + 1]; }

static double linear_energy(const context *c, int32_t j)
{
    const double stiffness = c->number[c->m->stiffness_at + j];
    if (stiffness == 0.0) return 0.0;
    const double stretch = quantity_at(c, quantity_of_element(c, j), c->s.q, c->s.q_low, NULL, NULL)
                           - c->number[c->m->rest_at + j];
    return 0.5 * stiffness * stretch * stretch;
}

/* 1 rad, or the size of the mechanism. */
static double size_of_quantity(const context *c, int32_t j)
{
    return c->m->quantity_kind[quantity_of_element(c, j)] == QUANTITY_ANGLE
               ? 1.0
               : c->number[c->m->extent_at];
}

static void add_linear_sizes(const context *c, int32_t j, double *sum)
{
    const double rest = c->number[c->m->rest_at + j],
                 sigma = quantity_at(c, quantity_of_element(c, j), c->s.q, c->s.q_low, NULL, NULL);
    *sum += fabs(c->number[c->m->drive_at + j]) * fmax(fabs(sigma), size_of_quantity(c, j));
    *sum += c->number[c->m->stiffness_at + j] * fabs(sigma - rest) * (fabs(sigma) + fabs(rest));
}

static element_bound linear_bound(const context *c, int32_t j)
{
    return (element_bound){c->number[c->m->damping_at + j], c->number[c->m->drive_at + j]};
}

static element_work linear_step(const context *c, int32_t j)
{
    const element_bound x = linear_bound(c, j);
    const double elongation = c->k.elongation[j];
    return (element_work){x.drive * elongation, x.damping * elongation * elongation / c->h};
}

static element_work linear_rate(const context *c, int32_t j, double time)
{
    const element_bound x = linear_bound(c, j);
    double rate;
    if (x.damping == 0.0 && x.drive == 0.0) return (element_work){0.0, 0.0};
    quantity_at(c, quantity_of_element(c, j), c->s.q, c->s.q_low, c->s.v, &rate);
    return (element_work){time * x.drive * rate, time * x.damping * rate * rate};
}

static void add_potential_sizes(const context *c, int32_t j, double *sum)
{
    const hm_registers *r = &c->k.r;
    const int32_t n = c->m->leaf_ptr[j + 1] - c->m->leaf_ptr[j];
    *sum += fabs(function_value(c, j));
    for (int32_t l = 0; l < n; l++) r->r1[l] = r->r0[l], r->dr[l] = 0.0;
    run_function(c, j);
    for (int32_t l = 0; l < n; l++) *sum += fabs(r->adjoint[l] * r->r0[l]);
}

static element_work potential_step(const context *c, int32_t j)
{
    composite_result result = {0.0, 0.0, 0.0};
    if (!is_damped(c, j)) return (element_work){0.0, 0.0};
    composite_slopes(c, j, SLOPES_ALONE, &result);
    return (element_work){0.0, damping_share_of_step(c, j) * result.change};
}

static element_work potential_rate(const context *c, int32_t j, double time)
{
    double power;
    if (!is_damped(c, j)) return (element_work){0.0, 0.0};
    const double share = damping_at_state(c, j, &power);
    return (element_work){0.0, time * share * power};
}

static element_bound potential_bound(const context *c, int32_t j)
{
    return (element_bound){c->number[c->m->depth_damping_at + (j - first_potential(c))], 0.0};
}

static double no_energy(const context *c, int32_t j)
{
    (void)c, (void)j;
    return 0.0;
}

static void add_no_sizes(const context *c, int32_t j, double *sum) { (void)c, (void)j, (void)sum; }

/* Account of the energy times*taken that force j takes, by its role: a loss where a force that
   should take does so, else work. `times` may be negative, as weights of stages are, and does not
   decide. */
static element_work work_of_force(const context *c, int32_t j, double taken, double times)
{
    const int is_loss = c->m->force_role[j - first_potential(c)] == TAKES && taken >= 0.0;
    return is_loss ? (element_work){0.0, times * taken} : (element_work){-times * taken, 0.0};
}

static element_work force_step(const context *c, int32_t j)
{
    composite_result result = {0.0, 0.0, 0.0};
    composite_slopes(c, j, SLOPES_ALONE, &result); /* of its own forms, which it sets */
    return work_of_force(c, j, result.change, 1.0);
}

static element_work force_rate(const context *c, int32_t j, double time)
{
    double along;
    const double force = force_at_state(c, j, 0, &along);
    return work_of_force(c, j, force * along, time);
}

/* A law may take energy out whatever its role, so that covers are taken: compositions go back in
   time. */
static element_bound force_bound(const context *c, int32_t j)
{
    return (element_bound){1.0, c->m->force_role[j - first_potential(c)] == WORKS};
}

static const element_kind LINEAR = {linear_energy, add_linear_sizes, linear_step, linear_rate,
                                    linear_bound},
                          POTENTIAL = {function_value, add_potential_sizes, potential_step,
                                       potential_rate, potential_bound},
                          FORCE = {no_energy, add_no_sizes, force_step, force_rate, force_bound};

static inline const element_kind *kind_of(const context *c, int32_t j)
{ return j < c->m->n_elements ? &LINEAR : is_force(c, j) ? &FORCE : &POTENTIAL; }

/* Whether an element at hand may take energy out, and whether one may do work. */
static int has_dampers(const context *c)
{
    EACH_ELEMENT(c, j) if (kind_of(c, j)->bound(c, j).damping != 0.0) return 1;
    return 0;
}

static int has_drives(const context *c)
{
    EACH_ELEMENT(c, j) if (kind_of(c, j)->bound(c, j).drive != 0.0) return 1;
    return 0;
}

#endif
