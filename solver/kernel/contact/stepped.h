/* Stepped mode: contacts change at the ends of half steps alone, however many, and no event is
   located.

   A half step h has two stages. The first is a conserving step that obeys the laws of contact
   (complementarity.h), with the rows of closed contacts and of frictions that stick on
   (active_contacts.h). Its contacts take -N (g_1 - g_0) >= 0. The second acts on the velocities
   alone (velocity_stage.h). */
#ifndef HOLONOM_STEPPED_H
#define HOLONOM_STEPPED_H

#include "active_contacts.h"
#include "estimate.h"
#include "switches.h"
#include "velocity_stage.h"

enum {
    MOST_DIVISIONS = 7, /* of a half step that fails */
    DEFERS_FROM = 5     /* of them: from there on friction may be deferred */
};
enum { WAKES_LATE = -1 }; /* instead of a status: a contact that sleeps may have come near */

/* One half step, which counts only if its ledger closes and contacts give no energy. */
static int32_t try_half(context *c, double h, int half)
{
    const double before = ledger_balance(c, kinetic_energy(c, c->k.momentum), potential_change(c));
    const double impact = booked(c, S_IMPACT), friction = booked(c, S_FRICTION);
    const int parity = begin_half(c, h, half);
    forget_halves(c);
    int32_t status = solve_contacts(c, parity);
    if (status) return status;
    if (c->view.near[NEAR_CONTACTS] && !(travel_left(c) > 4.0 * largest_way(c))) return WAKES_LATE;
    accept_step(c, parity);
    follow_travel(c, c->k.stepped_backup);
    if (has_closed(c) || c->m->n_frictions) status = change_velocities(c);
    if (status) return status;
    const double kinetic = kinetic_energy(c, c->k.momentum), potential = potential_change(c);
    const double after = ledger_balance(c, kinetic, potential);
    const double largest =
        fmax(c->s.head[S_ENERGY_REFERENCE],
             fmax(kinetic, fabs(potential))); /* the first half step from rest: its own */
    const double allowed = fmax(c->s.head[S_NEWTON_TOLERANCE], 1e-12) * largest;
    if (HOLONOM_ENERGY_DECIDES && !(fabs(after - before) <= allowed))
        return HOLONOM_NEWTON_DIVERGED;
    const double by_hits = booked(c, S_IMPACT) - impact,
                 by_slips = booked(c, S_FRICTION) - friction;
    const double given =
        fmin(by_slips, 0.0)
        - fmin(by_hits, 0.0); /* of what both take the sum alone is never negative */
    if (given != 0.0) book(c, S_IMPACT, given), book(c, S_FRICTION, -given);
    return by_hits + by_slips >= -allowed ? HOLONOM_OK : HOLONOM_CONTACT_UNDECIDED;
}

static int contacts_rub(const context *c)
{
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        if (may_be_deferred(c, f)) return 1;
    return 0;
}

/* A half step of length h; where it fails, two of half its length. No choice may agree with
   Coulomb's law: two corners of an edge that stop one after the other contradict each other,
   however short the step is. A short piece that fails is then taken with friction deferred: its
   contacts have none in the first stage, and that of the whole piece in the second, by the law of
   impact, which always has impulses inside the cones. */
static int32_t stepped_half(context *c, double h, int half, int divisions)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    const int may_defer = divisions >= DEFERS_FROM && contacts_rub(c);
    look_far_in_step(c, h);
    keep_state(c, c->k.stepped_backup);
    int32_t status = HOLONOM_CONTACT_UNDECIDED;
    for (int defers = 0; defers <= may_defer && may_choose_anew(status); defers++)
        for (c->step.careful = 0; c->step.careful <= has_smooth(c); c->step.careful++) {
            c->friction.is_deferred = defers;
            status = try_half(c, h, half);
            if (status == WAKES_LATE) {
                restore_state(c, c->k.stepped_backup, t, law_time);
                wake_all(c);
                keep_state(c, c->k.stepped_backup);
                status = try_half(c, h, half);
            }
            c->friction.is_deferred = 0;
            if (!status) {
                c->s.head[S_DEFERRED_FRICTIONS] += defers;
                return HOLONOM_OK;
            }
            restore_state(c, c->k.stepped_backup, t, law_time);
            lower_penalties(c);
        }
    if (divisions == MOST_DIVISIONS) return status;
    status = stepped_half(c, 0.5 * h, 0, divisions + 1);
    return status ? status : stepped_half(c, 0.5 * h, 1, divisions + 1);
}

/* Whether the equations of a step had no solution, as contacts and frictions were. */
static inline int is_unsolved(int32_t status)
{
    return (status >= HOLONOM_NEWTON_DIVERGED && status <= HOLONOM_NOT_FINITE)
           || status == HOLONOM_TURN_TOO_LARGE || status == HOLONOM_DAMPING_REVERSED;
}

/* Whether stepped mode may go on where located mode has failed so. */
static inline int may_step_over(int32_t status)
{
    return is_unsolved(status) || status == HOLONOM_TOO_MANY_EVENTS
           || status == HOLONOM_IMPACT_UNSOLVED || status == HOLONOM_CONTACT_UNDECIDED;
}

/* Whether a piece of length h that failed so is to be cut: an event may be in it, a slip in space
   that stops sooner than its rate says, or an edge at which a contact parts. */
static int is_to_be_cut(const context *c, int32_t status, double h)
{
    return (c->event.cuts || is_unsolved(status)) && !is_short(c, h);
}

/* Covers the rest of a communication step of length `step` that began at `start`. Multipliers are
   those of the last pair: no line through them leads across an impact. */
HM_SELDOM static int32_t cover_stepped(context *c, double start, double done, double step)
{
    double *head = c->s.head;
    const double rest = step - done, longest = fmin(hm_step_size(head), head[S_LONGEST_STEP]);
    const double n = fmax(1.0, ceil(rest / longest * (1.0 - 1e-10))), h = rest / n;
    int32_t status = n <= 1e9 ? HOLONOM_OK : HOLONOM_BAD_STEP;
    if (is_stepped(c)) c->view.may_fall_asleep = 1;
    else wake_all(c);
    head[S_STEPPED] = 1.0;
    head[S_ORDER_IN_USE] = 2.0;
    c->step.changes_contacts = 1;
    c->t = start + done;
    if (mesh_of(c)) begin_row(c, rest), end_row(c, TAKEN_STEPPED);
    for (int64_t i = 0; !status && i < (int64_t)n; i++) {
        c->t = start + done + h * (double)i;
        begin_halves(c, 2);
        status = settle_and_tick(c, c->t); /* no switch is located, either */
        if (!status)
            status = is_stopped(c) ? HOLONOM_STOPPED : stepped_half(c, 0.5 * h, 0, 0);
        if (!status) status = stepped_half(c, 0.5 * h, 1, 0);
        if (status) break;
        average_multipliers(c, c->t - 0.5 * h);
        memcpy(c->s.mean_before, c->s.mean, sizeof(double) * (size_t)c->m->n_rows);
        memcpy(c->s.driven_mean_before, c->s.driven_mean,
               sizeof(double) * (size_t)(DIM * c->m->n_driven));
        follow_energies(c);
        follow_coarseness(c, h);
    }
    c->step.changes_contacts = 0;
    see_all(c);
    if (!is_stepped(c)) head[S_UNSETTLED] = 1.0; /* located mode looks at contacts anew */
    return status;
}

/* Covers the rest after located mode has failed for the reason `why`, from the start of the piece
   that it could not solve. If that fails, too, the step fails for the same reason. */
HM_SELDOM static int32_t step_over(context *c, int32_t why, double start, double done, double step)
{
    const int32_t at_fault = c->step.at_fault, status = cover_stepped(c, start, done, step);
    if (!status) return HOLONOM_OK;
    c->step.at_fault = at_fault;
    return why;
}

/* Contacts at the start of a run. In stepped mode what hits does so in the first half step, and
   those are closed that the first multipliers agree with, if any do. */
HM_SELDOM static int32_t begin_contacts(context *c)
{
    wake_all(c);
    if (!is_stepped(c)) return settle(c);
    const int32_t status = settle_modes(c);
    c->s.head[S_UNSETTLED] = 0.0;
    return status == HOLONOM_CONTACT_UNDECIDED ? HOLONOM_OK : status;
}

#endif
