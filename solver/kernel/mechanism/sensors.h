/* What laws read of the motion: at a state, in the middle of the step to come, or of the one that
   is solved for. */
#ifndef HOLONOM_SENSORS_H
#define HOLONOM_SENSORS_H

#include "function.h"

/* Quantities that laws read, and their rates, at the configuration in `ahead` with the velocities
   in `ahead_rate`. */
static void sense_ahead(const context *c)
{
    const holonom_model *m = c->m;
    double *x = c->k.ahead, *v = c->k.ahead_rate;
    for (int32_t j = 0; j < m->n_active; j++) {
        const double turn = 6.283185307179586477;
        double angle = quantity_at(c, j, x, c->s.q_low, v, c->number + m->sensor_rate_at + j);
        if (m->quantity_kind[j] == QUANTITY_ANGLE) { /* the turn next to the state's */
            const double now = quantity_at(c, j, c->s.q, c->s.q_low, NULL, NULL);
            angle -= turn * floor((angle - now) / turn + 0.5);
        }
        c->number[m->sensor_at + j] = angle;
    }
}

/* Likewise in the middle of the step to come, predicted with the accelerations of the same half of
   the last pair. */
static void sense(const context *c, double h, int parity)
{
    for (int32_t k = 0; k < DIM * c->n_moving; k++) {
        const double a = c->s.a[parity][k];
        c->k.ahead[k] = c->s.q[k] + 0.5 * h * c->s.v[k] + 0.125 * h * h * a;
        c->k.ahead_rate[k] = c->s.v[k] + 0.5 * h * a;
    }
    sense_ahead(c);
}

/* Whether laws read the middle of the increment that is solved for, and no prediction of it: under
   a tolerance, whose steps follow what they do. */
static int reads_the_step(const context *c)
{
    return c->m->sensing && c->tolerance > 0.0 && !c->step.changes_contacts;
}

/* Laws at the middle of the present increment d: so half steps are symmetric, and weighted covers
   keep their order. Potentials do not read the motion, and stay as they are. */
HM_SELDOM static void read_the_step(const context *c)
{
    for (int32_t k = 0; k < DIM * c->n_moving; k++) {
        c->k.ahead[k] = c->s.q[k] + 0.5 * c->k.d[k];
        c->k.ahead_rate[k] = c->k.d[k] / c->h;
    }
    sense_ahead(c);
    hm_run_tape(c->m, c->number, 1);
}

#endif
