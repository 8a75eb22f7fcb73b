/* How fast what is measured changes at the state: the state moves on along the parabola of its
   motion, q + t v + t^2/2 a, and is measured again. Multipliers stay on the line through their
   means; works are booked as in a step. */
#ifndef HOLONOM_RATES_H
#define HOLONOM_RATES_H

#include "measure.h"

enum { ENERGY_BALANCE = 5 }; /* the first of the errors of energies and rows */

int holonom_knows_rate(const holonom_model *m, double *number, int32_t place, double *rate)
{
    const double *x = number + place;
    hm_measured y;
    hm_map_measured(m, number + m->measured_at, &y);
    double *const group[][3] = {
        /* values, right behind them their rates, and the end */
        {y.position, y.velocity, y.place},
        {y.place, y.place_velocity, y.quantity},
        {y.quantity, y.quantity_rate, y.element_force},
    };
    for (size_t k = 0; k < sizeof group / sizeof *group; k++)
        if (x >= group[k][0] && x < group[k][1]) return *rate = x[group[k][1] - group[k][0]], 1;
    *rate = 0.0;
    return x >= y.energy + ENERGY_BALANCE && x < y.momentum;
}

HM_SELDOM int32_t holonom_begin_moving_on(const holonom_model *m, double *number, double *state,
                                          double *work, double longest)
{
    context c;
    open_context(&c, m, number, state, work);
    double *head = c.s.head;
    const double gap = head[S_MEAN_TIME] - head[S_MEAN_TIME_BEFORE];
    /* No multiplier leaves its line on the way. */
    if (m->unilateral && !(c.t + longest - head[S_MEAN_TIME] <= FARTHEST * gap))
        head[S_MEAN_TIME] = INFINITY;
    if (m->sensing) sense(&c, 0.0, 0);
    set_laws(&c, c.t, 0);
    const int32_t status = accelerations(&c, c.s.mu[0]);
    memcpy(c.s.a[0], c.k.w, sizeof(double) * (size_t)(DIM * c.n_moving));
    return status;
}

/* Changes of elements and of functions of rows by increments that were not solved for; where one
   has no value, none. */
HM_SELDOM static void changes_of_composites(const context *c)
{
    EACH_COMPOSITE(c, j) {
        composite_result result = {0.0, 0.0, 0.0};
        if (j >= first_potential(c)) continue;
        composite_slopes(c, j, SLOPES_ALONE, &result);
        if (j < first_function(c)) c->k.elongation[j] = result.mechanical;
        if (!is_row(c, j)) continue;
        c->k.change[row_of(c, j)] = result.change;
        c->k.moved[row_of(c, j)] = result.mechanical;
    }
}

HM_SELDOM void holonom_move_on(const holonom_model *m, double *number, double *state, double *work,
                               double step)
{
    context c;
    open_context(&c, m, number, state, work);
    double *head = c.s.head, *const driving = c.k.momentum + DIM * m->n_free;
    const int64_t n = DIM * c.n_moving;
    c.h = step;
    head[S_TIME] = c.t + 0.5 * step;
    if (m->sensing) sense(&c, step, 0);
    set_laws(&c, head[S_TIME], 1);
    signals_at(&c, c.t + step, c.k.signal1);
    links_at_start(&c);
    rows_at_start(&c, 0);
    extrapolate(&c, c.s.head[S_TIME], m->n_rows, c.s.mean, c.s.mean_before, c.k.mu);
    memset(c.k.phi, 0, sizeof(double) * (size_t)m->n_rows);
    memset(c.k.momentum, 0, sizeof(double) * (size_t)n);
    memset(c.k.handed_on, 0, sizeof(double) * (size_t)n);
    extrapolate(&c, c.s.head[S_TIME], DIM * m->n_driven, c.s.driven_mean, c.s.driven_mean_before,
                driving);
    for (int32_t k = 0; k < DIM * m->n_driven; k++) driving[k] *= step;
    for (int64_t k = 0; k < n; k++)
        move_of(&c)[k] = c.k.d[k] = step * (c.s.v[k] + 0.5 * step * c.s.a[0][k]);
    changes_of_composites(&c);
    book_step(&c);
    move_along(&c, step, c.s.a[0]);
    for (int32_t j = 0; j < n_bodies(m); j++) follow_orientation(&c, j);
    follow_angles(&c, c.k.d);
    memcpy(c.s.signal, c.k.signal1, sizeof(double) * (size_t)m->n_signals);
    head[S_TIME] = c.t + step;
    set_laws(&c, head[S_TIME], 1);
    for (int32_t i = 0; i < m->n_inputs; i++) {
        c.s.inputs_before[i] += step * (c.s.inputs_slope[i] + step * c.s.inputs_bend[i]);
        c.s.inputs_slope[i] += 2.0 * step * c.s.inputs_bend[i];
    }
}

#endif
