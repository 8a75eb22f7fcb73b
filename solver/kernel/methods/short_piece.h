/* Pieces too short for half steps, by Taylor's series of second order. */
#ifndef HOLONOM_SHORT_PIECE_H
#define HOLONOM_SHORT_PIECE_H

#include "contact.h"
#include "step_halving.h"

/* Pieces shorter than this part of a usual step are stepped over by Taylor's series: half steps would divide the rounding
   errors of rows and signals by their length. What it leaves out is of the third order.                         */
#define SHORTEST_PIECE 1e-6

static int is_short(const context *c, double h) { return h < SHORTEST_PIECE * usual_length(c); }

/* Whether loads, drivers or moving surfaces may do work. */
HM_SELDOM static int has_loads(const context *c)
{
    const holonom_model *m = c->m;
    int has = m->n_signals > 0 || n_frictions(m) > 0 || m->n_loads > 0 || m->n_moments > 0 || m->n_body_moments > 0;
    for (int32_t j = 0; j < m->n_elements; j++) has |= c->number[m->drive_at + j] != 0.0;
    return has;
}

/* Power that dampers, and frictions that slide, take at the state, with the forces evaluated. */
HM_SELDOM static void powers_at_state(const context *c, double *damping, double *friction)
{
    const holonom_model *m = c->m;
    *damping = *friction = 0.0;
    for (int32_t j = 0; j < m->n_elements; j++) {
        double rate;
        quantity_at(c, m->leaf[4 * m->leaf_ptr[j] + 1], c->s.q, c->s.q_low, c->s.v, &rate);
        *damping += c->number[m->damping_at + j] * rate * rate;
    }
    for (int32_t j = first_potential(c); j < n_composites(c); j++) {
        double power;
        if (!is_damped(c, j)) continue;
        const double share = damping_at_state(c, j, &power);
        *damping += share * power;
    }
    for (int32_t f = 0; f < n_frictions(m); f++)
        if (friction_mode(c, f) == FRICTION_SLIDES)
            for (int k = 0; k < n_slips(c, f); k++)
                *friction += c->k.event_mu[row_of(c, slip_row(c, f, k))] * rate_of_row(c, slip_row(c, f, k));
}

/* Moves on by h with the accelerations in w; what signals drive goes where they are then. */
HM_SELDOM static void move_by_series(context *c, double h)
{
    const int32_t n_free = c->m->n_free;
    signals_at(c, c->t + h, c->k.signal1);
    memcpy(c->s.signal, c->k.signal1, sizeof(double) * (size_t)c->m->n_signals);
    for (int32_t k = 0; k < DIM * c->n_moving; k++) {
        hm_add(c->s.q + k, c->s.q_low + k, h * (c->s.v[k] + 0.5 * h * c->k.w[k]));
        hm_add(c->s.v + k, c->s.v_low + k, h * c->k.w[k]);
    }
    for (int32_t k = 0; k < DIM * c->m->n_driven; k++) {
        c->s.q[DIM * n_free + k] = c->s.signal[k];
        c->s.q_low[DIM * n_free + k] = 0.0;
    }
    c->t += h;
    follow_turns(c);
}

/* A piece of length h, with what dampers and frictions take; the rest of the change of energy is work. */
HM_SELDOM static int32_t short_piece(context *c, double h)
{
    double damping, friction;
    if (mesh_of(c)) begin_row(c, h);
    keep_start(c);
    evaluate_state(c);
    const int32_t status = evaluate_forces(c);
    if (status) return status;
    const double before = kinetic_energy(c, c->k.momentum) + potential_change(c);
    powers_at_state(c, &damping, &friction);
    move_by_series(c, h);
    book(c, S_DISSIPATED, h * damping);
    book(c, S_FRICTION, h * friction);
    const double after = kinetic_energy(c, c->k.momentum) + potential_change(c);
    if (has_loads(c)) book(c, S_WORK, after - before + h * (damping + friction));
    if (mesh_of(c)) end_row(c, TAKEN_SHORT);
    return HOLONOM_OK;
}

#endif
