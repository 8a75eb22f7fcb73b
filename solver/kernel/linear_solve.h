/* The linear system of Newton's iteration: right-hand side, factors and solution in elimination order. */
#ifndef HOLONOM_LINEAR_SOLVE_H
#define HOLONOM_LINEAR_SOLVE_H

#include "context.h"
#include "tangent.h"

/* Residual of a row. */
static inline double row_residual(const context *c, int32_t i)
{
    return c->k.phi[i] - c->k.epsilon[i] * (c->k.mu[i] - c->k.lambda[i]);
}

/* The nodes' part of the right-hand side -(momentum, rows) in elimination order. */
static void gather_momentum(const context *c)
{
    for IN_ISLAND(c, a, ISLAND_FREE)
        EACH(k) c->k.rhs[c->lu->node_position[a] + k] = -c->k.momentum[DIM * a + k];
}

static void gather_rhs(const context *c)
{
    gather_momentum(c);
    EACH_ROW(c, i) c->k.rhs[c->lu->row_position[i]] = -row_residual(c, i);
}

/* Adds what was solved for, one vector a free node, to x (DIM n_free, modified). */
static void add_solution(const context *c, double *x)
{
    for IN_ISLAND(c, a, ISLAND_FREE)
        EACH(k) x[DIM * a + k] += c->k.rhs[c->lu->node_position[a] + k];
}

static inline int32_t factorise(const context *c)
{
    const int32_t status = assemble_tangent(c), *target = c->lu->lu_target + c->lu->lu_island[2 * c->first_island + 1];
    if (status) return status;
    return hm_lu_factor(first_pivot(c), end_pivot(c), c->lu->lu_ptr, target, c->k.value) ? HOLONOM_SINGULAR_TANGENT
                                                                                         : HOLONOM_OK;
}

#endif
