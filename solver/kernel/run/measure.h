/* Residuals and measurements. */
#ifndef HOLONOM_MEASURE_H
#define HOLONOM_MEASURE_H

#include "coarseness.h"
#include "contact_modes.h"
#include "rigid.h"
#include "runge_kutta.h"

/* The states below are mapped for writing, as a step's are, and not modified. */
HM_SELDOM void holonom_residuals(const holonom_model *m, double *number, double *state,
                                 double *work, double *phi, double *phi_dot)
{
    context c;
    open_context(&c, m, number, state, work);
    signal_rates_at(&c, c.t, c.k.signal_rate);
    row_values(&c, phi);
    all_row_rates(&c, phi_dot);
}

/* Motion: nodes, places, quantities, elements. */
static void measure_motion(const context *c, const hm_measured *y)
{
    const holonom_model *m = c->m;
    const size_t bytes = sizeof(double) * (size_t)(DIM * c->n_moving);
    double w[DIM];
    memcpy(y->position, c->s.q, bytes);
    memcpy(y->velocity, c->s.v, bytes);
    for (int32_t j = 0; j < m->n_places; j++) {
        link_at_state(c, m->place_form[j], y->place + DIM * j, w);
        link_of(c, m->place_form[j], c->s.v, y->place_velocity + DIM * j, w);
    }
    for (int32_t j = 0; j < m->n_quantities; j++)
        y->quantity[j] = quantity_at(c, j, c->s.q, c->s.q_low, c->s.v, y->quantity_rate + j);
    for (int32_t j = 0; j < m->n_elements; j++) {
        const int32_t quantity = m->leaf[4 * m->leaf_ptr[j] + 1];
        y->element_force[j] =
            c->number[m->stiffness_at + j] * (y->quantity[quantity] - c->number[m->rest_at + j])
            + c->number[m->damping_at + j] * y->quantity_rate[quantity]
            - c->number[m->drive_at + j];
    }
}

/* Multipliers and forces on driven nodes as half steps tell them: their means. */
static void mean_forces(const context *c, const hm_measured *y)
{
    extrapolate(c, c->s.head[S_TIME], c->m->n_rows, c->s.mean, c->s.mean_before, y->multiplier);
    if (is_unilateral(c->m)) add_shares(c, y->multiplier);
    extrapolate(c, c->s.head[S_TIME], DIM * c->m->n_driven, c->s.driven_mean,
                c->s.driven_mean_before, y->driven_force);
}

/* Whether the state tells forces better than means do, which are of order 2 whatever the order of
   the motion is. With equal steps of order 2 means stand: they are what acts in steps that may be
   longer than what swings; so they do where steps went over contacts. Explicit steps have solved
   for them, but before a jump. */
static int tells_forces(const context *c)
{
    const holonom_model *m = c->m;
    return (m->n_rows || m->n_driven) && (c->tolerance > 0.0 || c->s.head[S_ORDER_IN_USE] > 2.0)
           && !(is_unilateral(m) && (c->s.head[S_UNSETTLED] != 0.0 || has_shares(c)))
           && (c->s.head[S_MEAN_TIME] != c->t || m->n_signals || m->n_switches);
}

/* Likewise, as the state asks for them, beginning with those that are there, and accelerations a
   (n, overwritten); where a law jumps now, on the side that it is on now, as outputs by a formula.
   State and laws stay as they are. */
HM_SELDOM static int32_t forces_of_state(context *c, const hm_measured *y, double *a)
{
    context at = rows_at_state(c);
    keep_state(c, c->k.whole_backup);
    take_unknowns(&at);
    int32_t status = factorise_here(&at);
    signals_at(c, c->t, c->k.signal1);
    signal_jets_at(c, c->t, c->k.signal_rate, c->k.signal_bend);
    if (c->m->sensing) sense(&at, 0.0, 0);
    set_laws(&at, c->t, 0);
    EACH_ISLAND(&at, island)
        status = status ? status : accelerate(&at, a, y->multiplier);
    if (!status && c->m->n_driven)
        status = hold_driven(&at, a, y->multiplier, y->driven_force);
    take_state(c, c->k.whole_backup);
    set_laws(c, c->t, 0);
    return status;
}

/* Likewise with contacts and frictions, in the modes that they are in, or take where an input has
   just changed. Accelerations are left in k.w. */
HM_SELDOM static int32_t forces_of_modes(context *c, const hm_measured *y)
{
    const holonom_model *m = c->m;
    keep_state(c, c->k.whole_backup);
    evaluate_state(c);
    int32_t status = HOLONOM_OK;
    if (c->s.head[S_UNSETTLED] != 0.0 && !is_stepped(c)) status = settle_modes(c);
    if (!status) status = evaluate_forces(c);
    memcpy(y->multiplier, c->k.event_mu, sizeof(double) * (size_t)m->n_rows);
    memcpy(c->k.mu, c->k.event_mu, sizeof(double) * (size_t)m->n_rows);
    if (!status && m->n_driven) status = forces_at_state(c);
    for (int32_t k = 0; k < DIM * m->n_driven && !status; k++)
        y->driven_force[k] = c->k.momentum[DIM * m->n_free + k];
    take_state(c, c->k.whole_backup);
    set_laws(c, c->t, 0);
    return status;
}

/* Second derivative of quantity j with accelerations a. Axes of an angle keep their lengths: rates
   of these lengths are an error of the step, which must not turn it. */
HM_SELDOM static double quantity_acceleration(const context *c, int32_t j, const double *a)
{
    const holonom_model *m = c->m;
    const int is_angle = m->quantity_kind[j] == QUANTITY_ANGLE;
    double s[2] = {0.0, 0.0}, rate[2] = {0.0, 0.0}, vu[DIM], vw[DIM], turn, change;
    for (int i = 0; i < (is_angle ? 2 : 1); i++) {
        const int32_t f = m->quantity_form[2 * j + i];
        double *u = c->k.u0 + DIM * f, *w = c->k.w0 + DIM * f;
        link_at_state(c, f, u, w);
        link_of(c, f, c->s.v, vu, vw);
        s[i] = dot(u, w);
        rate[i] = dot(u, vw) + dot(w, vu);
    }
    quantity_at(c, j, c->s.q, c->s.q_low, c->s.v, &turn);
    quantity_at(c, j, c->s.q, c->s.q_low, a, &change);
    change += second_rate(c, j);
    const double size2 = s[0] * s[0] + s[1] * s[1];
    if (!is_angle || !(size2 > 0.0)) return change;
    return change + 2.0 * turn * (s[0] * rate[0] + s[1] * rate[1]) / size2;
}

/* Lets directors have the velocities of rigid bodies: those of equal steps are off by an error of
   the steps, which would stretch bodies and bring about forces. */
HM_SELDOM static void turn_rigidly(const context *c)
{
    for (int32_t b = 0; b < n_bodies(c->m); b++) {
        const int32_t first = DIM * c->m->body_node[b];
        double omega[TURNING];
        turn_of_directors(c->s.q + first, c->s.v + first, omega);
        for (int i = first; i < first + DIM * TURNING; i += DIM)
            turned_by(omega, c->s.q + i, c->s.v + i);
    }
}

/* Measures accelerations of nodes, places, quantities and bodies at the state, at any order; NaN
   where they cannot be solved for. Returns whether multipliers and forces on driven nodes are those
   of the state as well, as under a tolerance, where velocities fit the rows. */
HM_SELDOM static int measure_accelerations(const context *measured, const hm_measured *y)
{
    const holonom_model *m = measured->m;
    context at = *measured, *c = &at; /* modes that are settled here stay here */
    const size_t bytes = sizeof(double) * (size_t)(DIM * c->n_moving);
    double w[DIM];
    keep_state(c, c->k.finest);
    if (!(c->tolerance > 0.0)) turn_rigidly(c);
    mean_forces(c, y);
    const int32_t status =
        is_unilateral(m) ? forces_of_modes(c, y) : forces_of_state(c, y, c->k.estimate);
    memcpy(y->acceleration, is_unilateral(m) ? c->k.w : c->k.estimate, bytes);
    for (int32_t k = 0; k < DIM * c->n_moving && status; k++) y->acceleration[k] = NAN;
    for (int32_t j = 0; j < m->n_places; j++)
        link_of(c, m->place_form[j], y->acceleration, y->place_acceleration + DIM * j, w);
    for (int32_t j = 0; j < m->n_quantities; j++)
        y->quantity_acceleration[j] = quantity_acceleration(c, j, y->acceleration);
#if DIM == 3
    for (int32_t j = 0; j < n_bodies(m); j++) {
        const int32_t first = 3 * m->body_node[j];
        turn_of_directors(c->s.q + first, y->acceleration + first, y->body_acceleration + 3 * j);
    }
#endif
    take_state(c, c->k.finest);
    return !status && c->tolerance > 0.0 && tells_forces(c);
}

/* Multipliers and forces on driven nodes, unless they `are_told`, that is measured already; and
   forces along rods, 2 mu |u|, positive in tension. */
static void measure_rows(context *c, const hm_measured *y, int are_told)
{
    const holonom_model *m = c->m;
    double u[DIM], w[DIM];
    if (!are_told) mean_forces(c, y);
    if (!are_told && tells_forces(c)
        && (is_unilateral(m) ? forces_of_modes(c, y) : forces_of_state(c, y, c->k.estimate)))
        mean_forces(c, y);
    for (int32_t i = 0; i < m->n_form_rows; i++) {
        link_at_state(c, m->row_form[i], u, w);
        y->rod_force[i] = y->multiplier[i] * 2.0 * sqrt(dot(u, u));
    }
}

static void measure_bodies(const context *c, const hm_measured *y)
{
    (void)c, (void)y;
#if DIM == 3
    memcpy(y->quaternion, c->s.quaternion, sizeof(double) * (size_t)(4 * n_bodies(c->m)));
    for (int32_t j = 0; j < n_bodies(c->m); j++) {
        const int32_t first = 3 * c->m->body_node[j];
        turn_of_directors(c->s.q + first, c->s.v + first, y->body_rate + 3 * j);
    }
#endif
}

/* Reactions on the second body of each joint, and forces on driven nodes. */
static void measure_reactions(const context *c, const hm_measured *y)
{
    const holonom_model *m = c->m;
    const double *mu = y->multiplier;
    double u[DIM], w[DIM], moment[TURNING];
    memset(y->reaction_force, 0,
           sizeof(double)
               * (size_t)((DIM + TURNING) * m->n_reactions)); /* and torques, behind it */
    for (int32_t e = 0; e < m->n_reaction_entries; e++) {
        const int32_t *entry = m->reaction_entry + 4 * e;
        double *force = y->reaction_force + DIM * entry[0],
               *torque = y->reaction_torque + TURNING * entry[0];
        if (entry[1] == REACTION_COINCIDENCE) {
            EACH(k) force[k] += entry[3] * mu[row_of_coincidence(m, entry[2]) + k];
            continue;
        }
        link_at_state(c, m->row_form[entry[2]], u, w);
        const double factor = -entry[3] * mu[entry[2]];
        cross_product(w, u, moment);
        if (entry[1] == REACTION_FORCE) EACH(k) force[k] += factor * w[k];
        else for (int k = 0; k < TURNING; k++) torque[k] += factor * moment[k];
    }
}

/* Contacts: gap, force, mode, impacts, impulse; frictions: force, slip, mode; losses. A friction
   of several rows has sizes, of one row signs. */
static void measure_contacts(const context *c, const hm_measured *y)
{
    const holonom_model *m = c->m;
    const double *head = c->s.head;
    if (!is_unilateral(m)) return;
    double *mu = c->k.event_mu;
    memcpy(mu, y->multiplier, sizeof(double) * (size_t)m->n_rows);
    quantities_at_state(c);
    signal_rates_at(c, head[S_TIME], c->k.signal_rate);
    for (int32_t i = 0; i < n_contacts(m); i++) {
        const double *x = contact_of(c, i);
        const int32_t f = m->contact_friction[i], j = m->contact_row[i];
        const int slides = f >= 0 && friction_mode(c, f) == FRICTION_SLIDES;
        const int mode = !is_closed(c, i) ? CONTACT_OPEN : slides ? CONTACT_SLIDES : CONTACT_CLOSED;
        const double values[] = {gap_of(c, i), is_closed(c, i) ? fmax(-mu[row_of(c, j)], 0.0) : 0.0,
                                 mode, x[C_IMPACTS], x[C_IMPULSE]};
        memcpy(y->contact + 5 * i, values, sizeof values);
    }
    for (int32_t f = 0; f < n_frictions(m); f++) {
        const int mode = friction_mode(c, f);
        double force = friction_force(c, f, mu, NULL), slip = slip_of(c, f, NULL);
        if (n_slips(c, f) == 1) {
            force = -mu[row_of(c, slip_row(c, f, 0))];
            slip = rate_of_row(c, slip_row(c, f, 0));
        }
        y->friction[3 * f] = mode == FRICTION_OFF ? 0.0 : force;
        y->friction[3 * f + 1] = mode == FRICTION_STICKS ? 0.0 : slip;
        y->friction[3 * f + 2] = mode;
    }
    y->loss[0] = head[S_DISSIPATED], y->loss[1] = head[S_FRICTION], y->loss[2] = head[S_IMPACT];
    y->contact_solver[0] = head[S_EVENTS] + head[S_SWITCHED],
    y->contact_solver[1] = head[S_STEPPED];
    y->contact_solver[2] = head[S_JAMS], y->contact_solver[3] = head[S_NEWTON_IMPACTS];
    y->contact_solver[4] = head[S_MIXED_IMPACTS], y->contact_solver[5] = head[S_DEFERRED_FRICTIONS];
}

/* Energies, and the largest scaled residuals of the rows. */
static void measure_energies(context *c, const hm_measured *y)
{
    const double *head = c->s.head;
    const double kinetic = kinetic_energy(c, c->k.momentum), change = potential_change(c);
    const double potential = head[S_POTENTIAL_START] + change,
                 balance = ledger_balance(c, kinetic, change);
    const double dissipated = head[S_DISSIPATED] + (head[S_FRICTION] + head[S_IMPACT]);
    const double energy[] = {kinetic,    potential, kinetic + potential,         head[S_WORK],
                             dissipated, balance,   relative_balance(c, balance)};
    memcpy(y->energy, energy, sizeof energy);
    signal_rates_at(c, head[S_TIME], c->k.signal_rate);
    row_values(c, c->k.phi);
    all_row_rates(c, c->k.row_rate);
    y->residual[0] = largest_of_all(c, c->k.phi);
    y->residual[1] = largest_of_all(c, c->k.row_rate);
}

/* Momentum of the points, and angular momentum about the origin: directions carry only the
   latter. */
static void measure_momenta(const context *c, const hm_measured *y)
{
    const double origin[DIM] = {0.0};
    double total[RIGID], unused[RIGID];
    int all[RIGID];
    for (int i = 0; i < RIGID; i++) all[i] = 1;
    momenta(c, c->k.momentum);
    rigid_momenta(c, origin, all, c->k.momentum, total, unused);
    memcpy(y->momentum, total, sizeof(double) * DIM);
    memcpy(y->angular_momentum, total + DIM, sizeof(double) * TURNING);
}

void holonom_group_ends(const holonom_model *m, double *number, int32_t *end)
{
    hm_measured y;
    hm_map_measured(m, number + m->measured_at, &y);
    const double *const first_behind[] = {y.rod_force, y.quaternion, y.reaction_force, y.energy,
                                          y.momentum,  y.solver,     y.contact,
                                          y.acceleration};
    for (int k = 0; k < HOLONOM_GROUPS - 1; k++) end[k] = (int32_t)(first_behind[k] - number);
    end[HOLONOM_GROUPS - 1] = m->n_numbers;
}

void holonom_measure(const holonom_model *m, double *number, double *state, double *work,
                     int32_t groups)
{
    context c;
    hm_measured measured;
    const hm_measured *y = &measured;
    open_context(&c, m, number, state, work);
    hm_map_measured(m, number + m->measured_at, &measured);
    const double *head = c.s.head;
    const int all = groups == HOLONOM_MEASURE_ALL, loads = groups & HOLONOM_MEASURE_SOLVER;
    int are_told = 0;
    if (m->sensing) sense(&c, 0.0, 0);
    set_laws(&c, head[S_TIME], 0);
    if (groups & HOLONOM_MEASURE_MOTION) measure_motion(&c, y);
    if (m->accelerates && (groups & HOLONOM_MEASURE_ACCELERATIONS & ~HOLONOM_MEASURE_FORCES))
        are_told = measure_accelerations(&c, y);
    if (groups & HOLONOM_MEASURE_FORCES) measure_rows(&c, y, are_told);
    if (groups & HOLONOM_MEASURE_BODIES) measure_bodies(&c, y);
    if (groups & HOLONOM_MEASURE_FORCES) measure_reactions(&c, y);
    if (groups & (HOLONOM_MEASURE_CONTACTS & ~HOLONOM_MEASURE_FORCES)) measure_contacts(&c, y);
    if (groups & HOLONOM_MEASURE_ENERGIES) measure_energies(&c, y);
    if (groups & HOLONOM_MEASURE_MOMENTA) measure_momenta(&c, y);
    const double method = head[S_ORDER_IN_USE] == 0.0 ? 0.0 : ends_explicitly(&c) ? 2.0 : 1.0;
    const double of_solver[] = {
        head[S_NEWTON_ITERATIONS],
        head[S_UZAWA_ITERATIONS],
        head[S_SUBSTEPS],
        head[S_ORDER_IN_USE],
        method,
        head[S_ERROR_ESTIMATE]
            + hm_error_of_path(head, c.number[m->extent_at], head[S_EQUAL_STEPS]),
        head[S_AS_PAIRS],
        loads ? sampling(&c) : 0.0,
        head[S_COARSENESS],
        head[S_STATUS]};
    if (loads) memcpy(y->solver, of_solver, sizeof of_solver);
    load_inputs(&c, head[S_TIME]); /* rates of signals have looked at other times */
    if (all) hm_run_tape(m, number, 3);
}

#endif
