/* Takes from the velocities of the state what bilateral rows and closed contacts do not allow, and
   books its energy. */
#ifndef HOLONOM_VELOCITY_PROJECTION_H
#define HOLONOM_VELOCITY_PROJECTION_H

#include "contact.h"
#include "rigid.h"

/* Whether drivers or surfaces move, whose work is what a change of velocities adds to the kinetic
   energy and its losses. */
static int is_driven(const context *c)
{
    double *rest = c->k.ahead, moved = c->m->n_signals;
    memset(rest, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        for (int k = 0; k < n_slips(c, f); k++)
            moved += fabs(function_rate(c, slip_row(c, f, k), rest, c->k.signal_rate));
    return moved > 0.0;
}

/* Velocities x (overwritten) and impulses (in mu) that change the rates of the rows by -phi. */
static void velocities_for(const context *c, double *x)
{
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    solve_for(c, x);
}

/* Rates (in phi) that rows have once the velocities have lost what is no turn of a body; that loss
   is x (n, overwritten). */
HM_SELDOM static void rates_of_turns(const context *c, double *x)
{
    double *turning = c->k.ahead;
    beside_turns(c, x);
    for (int32_t k = 0; k < DIM * c->n_moving; k++) turning[k] = c->s.v[k] + x[k];
    row_rates(c, turning, c->k.signal_rate, c->k.phi);
}

/* Adds to that loss the velocities that change the rates of the rows by -phi; impulses in mu. */
static void follow_turns_by(const context *c, double *x)
{
    inertia(c, 1.0, x, c->k.momentum);
    solve_for_momenta(c);
    add_solution(c, x);
}

/* Part of the velocities that makes rows move which hold, with the other sign (hit_defect): a step
   leaves it by its order. It is orthogonal to all that rows allow, so that its energy is apart.
   Factors are those at the state. */
HM_SELDOM static void find_defect(const context *c)
{
    rates_of_turns(c, c->k.hit_defect);
    follow_turns_by(c, c->k.hit_defect);
}

HM_SELDOM static void add_defect(context *c, double sign)
{
    for (int32_t k = 0; k < DIM * c->m->n_free; k++)
        hm_add(c->s.v + k, c->s.v_low + k, sign * c->k.hit_defect[k]);
}

/* Likewise, with new factors and without what sliding frictions do. */
HM_SELDOM static int32_t find_disallowed(context *c)
{
    see_all(c);
    suspend_sliding(c, 1);
    stand_still(c);
    const int32_t status = factorise_at_state(c);
    if (!status) find_defect(c);
    suspend_sliding(c, 0);
    return status;
}

/* Takes what has been found so from the velocities and books its energy in `account`; a change
   beyond it is work of drivers. */
HM_SELDOM static void take_disallowed(context *c, int account)
{
    add_defect(c, 1.0);
    /* What was solved for near a singular configuration is not quite orthogonal: its own work is
       booked. */
    const double square = 0.5 * mass_product(c, c->k.hit_defect, c->k.hit_defect);
    double change = -square;
    momenta(c, c->k.momentum);
    for (int32_t k = 0; k < DIM * c->m->n_free; k++)
        change += c->k.hit_defect[k] * c->k.momentum[k];
    const double loss = is_driven(c) ? square : -change;
    book(c, account, loss);
    book(c, S_WORK, change + loss);
    evaluate_state(c);
}

HM_SELDOM static int32_t project_velocities(context *c, int account)
{
    const int32_t status = find_disallowed(c);
    if (!status) take_disallowed(c, account);
    return status;
}

#endif
