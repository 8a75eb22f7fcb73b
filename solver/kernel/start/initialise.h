/* Seeks an initial configuration: closes a mechanism that is drawn inexactly, or lets it settle.
   Both are steps from rest whose forces and constraints act at their end, (2/h) M d + h (G_1' mu +
   dU_1 - Q_1) = 0, Phi(q + d) = 0: without forces the smallest displacement in the mass metric,
   with forces a descent, since the energy at the end is smaller by what motion would have taken; h
   grows until it is Newton's iteration for the equilibrium. */
#ifndef HOLONOM_INITIALISE_H
#define HOLONOM_INITIALISE_H

#include "close.h"
#include "dead_centre.h"
#include "stepped.h"

#define MOST_SOUGHT 20.0 /* twice the tangent of half a turn: some 170 degrees */

/* Whether bodies turn so little in a step that is sought that turns tell where they are. */
static int turns_tell(const context *c)
{
    double most = 0.0;
    EACH_TURN(c, b)
        for (int k = 0; k < TURNING; k++)
            most = fmax(most, fabs(c->k.move[DIM * c->m->body_node[b] + k]));
    return most <= MOST_SOUGHT;
}

/* One increment of Newton's iteration, no longer than a third of the mechanism; its length, and
   that of d. */
static int32_t seek_increment(context *c, double *increment, double *size)
{
    const double longest = 0.3 * c->number[c->m->extent_at + 1];
    gather_rhs(c);
    solve_factors(c);
    add_increment(c, increment, size);
    *increment = sqrt(*increment);
    if (!(*increment < 1e150)) return HOLONOM_NOT_FINITE;
    if (*increment > longest) {
        const double part = longest / *increment;
        double unused;
        take_back(c);
        for (int32_t k = first_pivot(c); k < end_pivot(c); k++) c->k.rhs[k] *= part;
        add_increment(c, &unused, size);
    }
    EACH_ROW(c, i) c->k.lambda[i] = c->k.mu[i];
    *size = sqrt(*size);
    return turns_tell(c) ? HOLONOM_OK : HOLONOM_NEWTON_DIVERGED;
}

/* One such step of length h, without forces where `constraints_only`; its size in the mass norm.
   Multipliers start from those of the state. */
HM_SELDOM static int32_t seek_step(const context *begun, double h, int constraints_only,
                                   double *size)
{
    context seeking = *begun, *c = &seeking;
    const holonom_model *m = c->m;
    const double tolerance = c->s.head[S_NEWTON_TOLERANCE],
                 floor = 1e-13 * c->number[m->extent_at + 1];
    double last = INFINITY;
    /* With forces the rows' compliance G A^-1 G' grows with h^2 only until springs hold the
       mechanism. */
    const double holding = constraints_only ? h : fmin(h, hm_step_size(c->s.head));
    stand_still(c);
    c->step.theta = 1.0;
    c->h = h;
    c->step.constraints_only = constraints_only;
    EACH_TURN(c, b) rest_as_body(c, c->m->body_node[b]);
    for (int32_t i = 0; i < m->n_rows; i++) {
        c->k.mu[i] = c->k.lambda[i] = c->s.mu[0][i];
        c->k.epsilon[i] =
            holding * holding * c->number[m->row_sigma_at + i] / (2.0 * c->s.head[S_PENALTY]);
    }
    int32_t status = evaluate_residual(c);
    for (int iteration = 0; !status && iteration < 60; iteration++) {
        double increment;
        if (is_stopped(c)) return HOLONOM_STOPPED;
        if ((status = factorise(c))) break;
        if ((status = seek_increment(c, &increment, size))) break;
        status = evaluate_residual(c);
        const double defect = constraint_defect(c);
        if (!status && defect <= tolerance
            && (increment <= floor || (increment > 0.5 * last && increment <= 100.0 * floor)))
            break;
        last = increment;
        if (iteration == 59) status = HOLONOM_NEWTON_DIVERGED;
    }
    return status;
}

static void take_over(context *c)
{
    for (int32_t k = 0; k < DIM * c->n_moving; k++) hm_add(c->s.q + k, c->s.q_low + k, c->k.d[k]);
    EACH_TURN(c, b) straighten(c, c->m->body_node[b]);
    memcpy(c->s.mu[0], c->k.mu, sizeof(double) * (size_t)c->m->n_rows);
}

enum { ROUNDS = 8 };

static int is_given(const context *c, int32_t a)
{ return c->number[c->m->velocity_weight_at + a] > 1.0; }

#define RATES_HOLD 1e-10 /* rates of rows over the fastest motion */
#define GIVEN_HOLD 1e-9  /* changes of given velocities, likewise */

/* Largest change of a given velocity, over the fastest motion. */
static double lost_of_given(const context *c, const double *given)
{
    const holonom_model *m = c->m;
    const double fastest = fmax(fastest_rate(c, c->s.v), fastest_rate(c, given));
    double lost = 0.0;
    for (int32_t a = 0; a < m->n_free; a++) {
        double change[DIM];
        EACH(k) change[k] = is_given(c, a) ? c->s.v[DIM * a + k] - given[DIM * a + k] : 0.0;
        lost = fmax(lost,
                    sqrt(dot(change, change)) / (m->node_kind[a] ? 1.0 : c->number[m->extent_at]));
    }
    return fastest > 0.0 ? lost / fastest : 0.0;
}

/* Velocities next to those given (n), in the mass metric, that the rows allow. Where they are to be
   kept, by large weights, three rounds each begin with them again, and more follow where that
   brings them nearer: gears may make what is not given heavier yet. The others let the rows hold to
   round-off. What rows still ask for, over their scales, becomes `defect`. */
HM_SELDOM static int32_t project_initial_velocities(context *c, const double *given, int keep_given,
                                                    double *defect)
{
    const holonom_model *m = c->m;
    double *factor = c->k.stages; /* powers of 2: masses come back exactly */
    double last = INFINITY, lost = INFINITY;
    for (int32_t a = 0; a < m->n_free; a++) factor[a] = sqrt(c->number[m->velocity_weight_at + a]);
    for (int round = keep_given ? 0 : 3; round <= ROUNDS; round++) {
        if (round == 3 && keep_given) {
            const double before = lost;
            lost = lost_of_given(c, given);
            if (lost > GIVEN_HOLD && lost < 0.9 * before) round = 2;
        }
        for (int32_t k = 0; k < DIM * m->n_free && round < 3; k++)
            if (is_given(c, k / DIM)) c->s.v[k] = given[k];
        turn_as_bodies(c);
        stand_still(c);
        memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
        signal_rates_at(c, c->t, c->k.signal_rate);
        row_rates(c, c->s.v, c->k.signal_rate, c->k.phi);
        *defect = largest_row(c, c->k.phi);
        if (round == ROUNDS || (round > 3 && !(*defect < 0.5 * last)))
            break; /* light parts cost digits: again, as long as it helps */
        last = round < 3 ? INFINITY : *defect;
        if (round < 3) scale_masses(c, factor, 0);
        const int32_t status = solve_at_state(c);
        if (round < 3) scale_masses(c, factor, 1);
        if (status) return status;
        add_solution(c, c->s.v);
    }
    return HOLONOM_OK;
}

/* Velocities that the rows allow. Where light parts cost all digits, or heavy ones keep light ones
   from what is given, once more in an even metric; a contradiction of those given is shared out by
   masses. */
HM_SELDOM static int32_t make_velocities_consistent(context *c, int keep_given)
{
    const size_t bytes = sizeof(double) * (size_t)(DIM * c->n_moving);
    double *given = c->k.pair_backup, *by_masses = given + DIM * c->n_moving, defect;
    memcpy(given, c->s.v, bytes);
    int32_t status = project_initial_velocities(c, given, keep_given, &defect);
    if (status) return status;
    const int holds = defect <= RATES_HOLD * fastest_rate(c, c->s.v);
    const double lost = keep_given ? lost_of_given(c, given) : 0.0;
    if (holds && !(lost > GIVEN_HOLD)) return HOLONOM_OK;
    memcpy(by_masses, c->s.v, bytes);
    memcpy(c->s.v, given, bytes);
    status = take_even_metric(c);
    if (!status) status = project_initial_velocities(c, given, keep_given, &defect);
    leave_even_metric(c);
    if (holds && (status || !(lost_of_given(c, given) < 0.5 * lost)))
        memcpy(c->s.v, by_masses, bytes);
    return holds ? HOLONOM_OK : status;
}

/* Keeps the angular velocities of bodies that were turned from their drawing. */
HM_SELDOM static void turn_velocities(const context *c)
{
    for (int32_t b = 0; b < n_bodies(c->m); b++) {
        const int32_t first = DIM * c->m->body_node[b];
        double omega[TURNING];
        turn_of_directors(c->number + c->m->initial_position_at + first, c->s.v + first, omega);
        for (int i = 0; i < DIM * TURNING; i += DIM)
            turned_by(omega, c->s.q + first + i, c->s.v + first + i);
    }
}

/* Closes the mechanism, by the smallest displacement if that leads to a pose near the drawing. */
static int32_t close_places(context *c)
{
    double size;
    follow_angles(c, NULL);
    memset(c->s.turns, 0, sizeof(double) * (size_t)c->m->n_quantities);
    if (c->m->n_signals) wind(c);
    keep_state(c, c->k.step_backup);
    int32_t status = seek_step(c, 1.0, 1, &size);
    if (status == HOLONOM_ZERO_LENGTH || status == HOLONOM_BAD_LAW || status == HOLONOM_STOPPED)
        return status;
    if (!status) take_over(c), follow_angles(c, NULL);
    const double way = status ? INFINITY : distance_from(c, c->k.step_backup);
    if (way <= FAR) return HOLONOM_OK;
    status = find_pose(c, way <= FARTHEST_STAGE);
    return status == HOLONOM_UZAWA_DIVERGED ? find_pose_of_even_masses(c) : status;
}

static int32_t close_mechanism(context *c)
{
    const int32_t status = close_places(c);
    if (status) return status;
    turn_velocities(c);
    return make_velocities_consistent(c, 1);
}

enum {
    MOST_CHOICES_AT_START = 200, /* of closed contacts in a step towards the equilibrium */
    FREE_CHOICES = 8 /* in which all contacts that object change; in others the first one, and they
                        come to an end (Murty 1974) */
};

/* Opens closed contacts that pull, and closes open ones that overlap, or the first of these; 0 if
   none does. */
static int change_objecting(context *c, int the_first)
{
    const double most = PENETRATION * c->number[c->m->extent_at];
    int changed = 0;
    for (int32_t i = 0; i < n_contacts(c->m) && !(the_first && changed); i++) {
        const int closed = is_closed(c, i),
                  pulls = closed && c->k.mu[row_of(c, c->m->contact_row[i])] > 0.0;
        if (!pulls && (closed || !(gap_of(c, i) < -most))) continue;
        contact_of(c, i)[C_CLOSED] = !closed;
        changed = 1;
    }
    return changed;
}

/* A step of seek_step with 0 <= N _|_ g >= 0 at its end, taken over; as it was if none is found, as
   in long steps that go through a contact. Frictions are off: they hold nothing. */
static int32_t seek_contacts(context *c, double h, double *size)
{
    double *begun = c->k.pair_backup;
    int32_t status = HOLONOM_OK;
    keep_state(c, begun);
    for (int choice = 0; choice < MOST_CHOICES_AT_START; choice++) {
        if ((status = seek_step(c, h, 0, size))) break;
        take_over(c);
        if (!change_objecting(c, choice >= FREE_CHOICES)) return HOLONOM_OK;
        take_motion_back(c, begun);
    }
    take_state(c, begun);
    return status ? status : HOLONOM_NEWTON_DIVERGED;
}

static int32_t seek_equilibrium(context *c)
{
    const holonom_model *m = c->m;
    double h = hm_step_size(c->s.head), size = INFINITY;
    int small = 0, moved = 0;
    int32_t failure = HOLONOM_NEWTON_DIVERGED;
    memset(c->s.v, 0, sizeof(double) * (size_t)(DIM * m->n_free));
    memset(c->s.mu[0], 0, sizeof(double) * (size_t)m->n_rows);
    for (int step = 0; step < 100 && small < 2; step++) {
        const int32_t status = seek_contacts(c, h, &size);
        if (status == HOLONOM_STOPPED) return status;
        if (status) {
            failure = status;
            h *= 0.25;
            continue;
        }
        moved = 1;
        /* Once every motion is slower than a step, its size says how far the equilibrium is. */
        small = size <= 1e-10 * c->number[m->extent_at + 1] && h > 1e3 * hm_step_size(c->s.head)
                    ? small + 1
                    : 0;
        if (h < 1e6 * hm_step_size(c->s.head)) h *= 4.0;
    }
    for (int32_t i = 0; i < n_contacts(m); i++)
        contact_of(c, i)[C_CLOSED] = 0.0; /* begin_contacts finds their modes */
    if (small < 2) return moved ? HOLONOM_NEWTON_DIVERGED : failure;
    return m->n_signals ? make_velocities_consistent(c, 0)
                        : HOLONOM_OK; /* at rest, but for what drivers move */
}

/* Configuration, signals and velocities at the beginning, before anything is derived from them. */
static void take_initial(context *c)
{
    const holonom_model *m = c->m;
    const size_t bytes = sizeof(double) * (size_t)(DIM * c->n_moving),
                 driven = sizeof(double) * (size_t)(DIM * m->n_driven);
    memcpy(c->s.q, c->number + m->initial_position_at, bytes);
    memcpy(c->s.v, c->number + m->initial_velocity_at, bytes);
    EACH_TURN(c, b) straighten(c, m->body_node[b]);
    memcpy(c->s.held, c->number + m->held_start_at, sizeof(double) * (size_t)m->n_held);
    memcpy(c->s.inputs_before, c->s.inputs, sizeof(double) * (size_t)m->n_inputs);
    c->s.head[S_INPUT_STEP] = c->s.head[S_INPUT_STEP_BEFORE] = 0.0;
    settle_sides(c, c->t, 0); /* those of the time, for signals */
    signals_at(c, c->t, c->s.signal);
    signal_rates_at(c, c->t, c->k.signal_rate);
    memcpy(c->s.q + DIM * m->n_free, c->s.signal, driven);
    memcpy(c->s.v + DIM * m->n_free, c->k.signal_rate, driven);
}

/* Energies at the start, and the scale they are measured by. */
static void open_ledger(context *c)
{
    const holonom_model *m = c->m;
    double *head = c->s.head, mass = 0.0;
    const double *gravity = c->number + m->gravity_at;
    const double kinetic = kinetic_energy(c, c->k.momentum);
    memcpy(c->s.start, c->s.q, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t a = 0; a < c->n_moving; a++) mass += c->number[m->node_weight_at + a];
    head[S_KINETIC_START] = kinetic;
    head[S_POTENTIAL_START] = stored_energy(c);
    head[S_STORED_START] =
        potential_change(c); /* and weights on what rounding left over of the coordinates */
    /* Floors, so that a mechanism at rest has a finite relative error: of its weight and springs
       and, if it has none, of what stands still, whose places are known to round-off: 1e5 times
       theirs a step. A mechanism with weight has no such floor: where its steps are so short that
       round-off feeds the energy, energy.error shows it. */
    const double weight = mass * sqrt(dot(gravity, gravity)) * c->number[m->extent_at];
    const double still = hm_square(1e5 * round_off_of_places(c) / hm_step_size(head));
    const double floor = 1e-3 * (weight + fabs(head[S_POTENTIAL_START]));
    for (int32_t a = 0; a < c->n_moving; a++)
        head[S_POTENTIAL_START] -=
            c->number[m->node_weight_at + a] * dot(gravity, c->s.q + DIM * a);
    head[S_ENERGY_REFERENCE] = fmax(kinetic, floor > 0.0 ? floor : still);
}

static int32_t refuse_penetration(context *c)
{
    const double most = HOLONOM_DRAWN_INTO * c->number[c->m->extent_at] + round_off_of_drawing(c);
    for (int32_t i = 0; i < n_contacts(c->m); i++)
        if (!(gap_of(c, i) >= -most)) {
            blame(c, c->m->contact_row[i]);
            return HOLONOM_PENETRATION;
        }
    return HOLONOM_OK;
}

/* Blames, of contacts that touch, the one of the largest coefficient of friction; returns whether
   there is one that rubs. */
static int blame_roughest(context *c)
{
    double most = 0.0;
    for (int32_t i = 0; i < n_contacts(c->m); i++) {
        const int32_t f = c->m->contact_friction[i];
        if (f < 0 || !(gap_of(c, i) <= gap_tolerance(c))
            || !(c->number[c->m->sliding_at + f] > most))
            continue;
        most = c->number[c->m->sliding_at + f];
        blame(c, c->m->contact_row[i]);
    }
    return most > 0.0;
}

/* Modes of contacts at the start. Forces were found without contacts: where with them there are
   none, or none that are finite, friction is so strong that no modes agree with it. */
static int32_t start_contacts(context *c, const double *state)
{
    int32_t status = refuse_penetration(c);
    if (!status) status = begin_contacts(c);
    if (!status && !all_finite(state, c->state_size)) status = HOLONOM_NOT_FINITE;
    if ((status == HOLONOM_SINGULAR_TANGENT || status == HOLONOM_NOT_FINITE) && blame_roughest(c))
        status = HOLONOM_CONTACT_UNDECIDED;
    if (status) c->s.head[S_AT_FAULT] = c->step.at_fault;
    return status;
}

HM_SELDOM int32_t holonom_initialise(const holonom_model *m, double *number, double *state,
                                     double *work, holonom_watch *watch)
{
    context c;
    open_context(&c, m, number, state, work);
    c.watch = watch;
    double *head = c.s.head;
    memset(head + S_KINETIC_START, 0, sizeof(double) * (S_STEP_SIZE - S_KINETIC_START));
    memset(c.s.q, 0, (size_t)((char *)c.s.inputs - (char *)c.s.q));
    memset(c.s.inputs_slope, 0,
           (size_t)((char *)c.s.parameters - (char *)c.s.inputs_slope)); /* of islands, too */
    take_initial(&c);
    derive_extent(&c);
    if (m->sensing) sense(&c, 0.0, 0);
    set_laws(&c, head[S_TIME], 0);
    settle_sides(&c, head[S_TIME], 0);
    if (blame_signal(&c, c.t, 2)) {
        head[S_AT_FAULT] = c.step.at_fault;
        return HOLONOM_BAD_DRIVER;
    }
    if (!all_finite(number, m->measured_at)) return HOLONOM_NOT_FINITE;
    stand_still(&c);
    int32_t status = derive_scales(&c);
    memcpy(c.s.derived, number + m->extent_at, derived_bytes(m));
    if (!status && head[S_ASSEMBLE] != 0.0) status = close_mechanism(&c);
    else if (!status && (m->n_signals || m->fits_velocities))
        status = make_velocities_consistent(&c, 1); /* those not given follow */
    if (!status && head[S_EQUILIBRIUM] != 0.0) status = seek_equilibrium(&c);
    if (watch && watch->is_stopped) return HOLONOM_STOPPED;
    settle_sides(&c, head[S_TIME], 0); /* where it has come to */
    if (!status && (status = tick(&c, head[S_TIME], NULL, 0)))
        head[S_AT_FAULT] = c.step.at_fault;
    if (!status) status = first_multipliers(&c);
    if (!status && fastest_rate(&c, c.s.v) > 0.0) status = refuse_dead_centre(&c);
    if (status) return status;
    follow_angles(&c, NULL);
    if (head[S_ASSEMBLE] == 0.0) /* the first sines have crossed nothing */
        memset(c.s.turns, 0, sizeof(double) * (size_t)m->n_quantities);
    for (int32_t j = 0; j < n_bodies(m); j++) follow_orientation(&c, j);
    open_ledger(&c);
    find_freedom(&c);
    if (is_unilateral(m) && (status = start_contacts(&c, state))) return status;
    head[S_EVENTS] = 0.0;
    return all_finite(state, c.state_size) ? HOLONOM_OK : HOLONOM_NOT_FINITE;
}

#endif
