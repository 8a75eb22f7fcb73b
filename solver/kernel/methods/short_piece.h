/* Pieces too short for half steps, by Taylor's series of second order. */
#ifndef HOLONOM_SHORT_PIECE_H
#define HOLONOM_SHORT_PIECE_H

#include "contact.h"
#include "step_halving.h"

/* Pieces shorter than this part of a usual step are stepped over by Taylor's series: half steps
   would divide the rounding errors of rows and signals by their length. What it leaves out is of
   the third order. */
#define SHORTEST_PIECE 1e-6

static int is_short(const context *c, double h) { return h < SHORTEST_PIECE * usual_length(c); }

/* Whether loads, drivers or moving surfaces may do work. */
HM_SELDOM static int has_loads(const context *c)
{
    return c->m->n_signals > 0 || n_frictions(c->m) > 0 || is_loaded(c) || has_drives(c);
}

/* Power that dampers, and frictions that slide, take at the state, with the forces evaluated. */
HM_SELDOM static void powers_at_state(const context *c, double *damping, double *friction)
{
    const holonom_model *m = c->m;
    *damping = *friction = 0.0;
    EACH_ELEMENT(c, j) *damping += kind_of(c, j)->rate(c, j, 1.0).lost;
    for (int32_t f = 0; f < n_frictions(m); f++)
        if (friction_mode(c, f) == FRICTION_SLIDES)
            for (int k = 0; k < n_slips(c, f); k++)
                *friction +=
                    c->k.event_mu[row_of(c, slip_row(c, f, k))] * rate_of_row(c, slip_row(c, f, k));
}

/* Moves on by h with the accelerations in w; what signals drive goes where they are then. */
HM_SELDOM static void move_by_series(context *c, double h)
{
    const int32_t n_free = c->m->n_free;
    signals_at(c, c->t + h, c->k.signal1);
    memcpy(c->s.signal, c->k.signal1, sizeof(double) * (size_t)c->m->n_signals);
    move_along(c, h, c->k.w);
    for (int32_t k = 0; k < DIM * c->m->n_driven; k++) {
        c->s.q[DIM * n_free + k] = c->s.signal[k];
        c->s.q_low[DIM * n_free + k] = 0.0;
    }
    c->t += h;
    follow_turns(c);
}

/* Keeps the rates of the gaps of closed contacts, which part_at_edges compares with those at the
   end. */
HM_SELDOM static void keep_gap_rates(const context *c)
{
    for (int32_t i = 0; i < n_contacts(c->m); i++)
        c->k.gap_rates[i] = is_closed(c, i) ? gap_rate(c, i) : 0.0;
}

/* A piece of length h, with what dampers and frictions take; the rest of the change of energy is
   work. */
HM_SELDOM static int32_t short_piece(context *c, double h)
{
    double damping, friction;
    if (mesh_of(c)) begin_row(c, h);
    keep_start(c);
    evaluate_state(c);
    keep_gap_rates(c);
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
