/* Events: steps with contacts as they are, cut where a gap closes, a normal force vanishes, slip
   stops or friction gives way.

   After a step the earliest zero of the functions of contacts and frictions (event_functions.h) is
   sought by the cubics through their values and rates at both ends (event_roots.h); every trial is
   the whole step anew, of the length tried, so that an accepted one is a step like any other. */
#ifndef HOLONOM_EVENT_H
#define HOLONOM_EVENT_H

#include "edges.h"
#include "event_roots.h"

/* A normal force above this part of its mean and of what it was at the start of the piece, and a
   friction that leaves this part of its cone, change no mode in the piece: forces at the state need
   not be evaluated. */
#define SAFE_NORMAL 0.3
#define SAFE_FRICTION 0.2
/* Likewise gaps farther than this many times the way of the fastest node, and slips larger than
   this many times their own change: two sides may approach each other, and speeds may double in the
   piece. */
#define SAFE_WAYS 4.0

/* Whether multipliers are those of the half steps before. */
static int forces_stand_still(const context *c)
{
    const double none = CONE_MARGIN * largest_normal(c, c->s.mean);
    for (int32_t i = 0; i < c->m->n_rows; i++)
        if (!(fabs(c->s.mean[i] - c->s.mean_before[i]) <= none)) return 0;
    return 1;
}

/* Where in a piece of length h from time t a force falls below the part of its larger value at both
   ends that is safe, and that of which function (`which`) falls deepest; 0 if none does. */
static double find_dip(const context *c, double t, double h, event_values low, event_values high,
                       int32_t *which)
{
    double deepest = SAFE_NORMAL, place = 0.0;
    if (has_shares(c)) return 0.0; /* no force of theirs vanishes by itself */
    for (int32_t k = 0; (k = next_function(c, k)) < c->m->n_contacts + c->m->n_frictions; k++) {
        const int is_on = k < c->m->n_contacts
                              ? is_closed(c, k)
                              : friction_mode(c, k - c->m->n_contacts) == FRICTION_STICKS;
        if (!is_on) continue;
        double y[3] = {low.value[k], NAN, high.value[k]};
        const double largest = fmax(y[0], y[2]), lowest = lowest_margin(c, k, t, h, y);
        if (lowest == lowest && largest > value_tolerance(c, k) && y[1] < deepest * largest)
            deepest = y[1] / largest, place = lowest, *which = k;
    }
    return place;
}

/* Whether a slip in space has not stopped in a piece of length h, at whose start it was v0, with
   the rate r0, and at whose end it is v1: the parabola through these keeps a good part of the
   lesser one. `rate` is the mean rate on entry and that at the end on return, by which a stop
   within two more pieces is foreseen. */
#define SAFE_SLIP 0.5
#define FORESEEN 2.0

static int is_quiet_slip(double h, double v0, double r0, double v1, double *rate)
{
    const double bend = *rate - r0, lesser = fmin(v0, v1);
    *rate += bend;
    const double lowest = r0 < 0.0 && *rate > 0.0 ? v0 - 0.25 * h * r0 * r0 / bend : lesser;
    return lesser > 0.0 && lowest > SAFE_SLIP * lesser && v1 > -FORESEEN * h * *rate;
}

/* Rates of open gaps where a quiet piece ends: under a tolerance the next one may be far longer,
   and a gap may close and open in it. */
static void find_gap_rates(context *c, event_values x)
{
    int is_evaluated = 0;
    EACH_CONTACT(c, i) {
        if (is_closed(c, i)) continue;
        if (!is_evaluated) evaluate_state(c);
        is_evaluated = 1;
        x.rate[i] = gap_rate(c, i);
    }
}

/* The functions (x) at the end of a piece of length h, whose values at its start are `low`, from
   multipliers that the last two means extrapolate; `reach` are SAFE_WAYS of the fastest node.
   Returns 0, with x not to be used, if that leaves doubt whether an event has passed. */
static int is_quiet(context *c, double h, double reach, event_values low, event_values x)
{
    const holonom_model *m = c->m;
    const double gap = c->s.head[S_MEAN_TIME] - c->s.head[S_MEAN_TIME_BEFORE];
    const double ahead = gap > 0.0 && gap < INFINITY ? (c->t - c->s.head[S_MEAN_TIME]) / gap : 0.0;
    c->event.outside = 0;
    if (has_forces(c) && !(fabs(c->t - c->s.head[S_MEAN_TIME]) <= h && ahead <= FARTHEST)) return 0;
    for (int32_t i = 0; i < m->n_rows && has_forces(c); i++)
        c->k.event_mu[i] = c->s.mean[i] + ahead * (c->s.mean[i] - c->s.mean_before[i]);
    const int rests = has_shares(c), is_shared = may_have_dependent_rows(c);
    if (rests) add_shares(c, c->k.event_mu);
    c->event.outside = has_forces(c) && is_outside(c);
    if (c->event.outside || (rests && !forces_stand_still(c))) return 0;
    EACH_CONTACT(c, i) {
        x.rate[i] = NAN;
        if (is_closed(c, i)) {
            const double mean = -c->s.mean[row_of(c, m->contact_row[i])];
            x.value[i] = normal_of(c, i);
            if (!rests && !(mean > 0.0 && x.value[i] > SAFE_NORMAL * fmax(mean, low.value[i])))
                return 0;
            if (is_edge_near(c, i, h, low.value[i], rests || is_shared)) return 0;
        } else if (!((x.value[i] = gap_of(c, i)) > reach && low.value[i] > reach)) return 0;
        else c->view.may_fall_asleep |= is_far_enough(c, i, x.value[i]);
    }
    EACH_FRICTION(c, f) {
        const int mode = friction_mode(c, f);
        const int32_t k = m->n_contacts + f;
        x.value[k] = INFINITY, x.rate[k] = NAN;
        if (mode == FRICTION_STICKS) {
            const double limit = cone(c, f, 0, normal_force(c, f, c->k.event_mu));
            x.value[k] = limit - friction_force(c, f, c->k.event_mu, NULL);
            if (!rests && !(x.value[k] > SAFE_FRICTION * limit)) return 0;
        } else if (mode == FRICTION_SLIDES && !is_smooth(c, f)) {
            x.value[k] = slip_along(c, f);
            x.rate[k] = (x.value[k] - low.value[k]) / h;
            if (n_slips(c, f) > 1 && low.rate[k] == low.rate[k]) {
                if (!is_quiet_slip(h, low.value[k], low.rate[k], x.value[k], x.rate + k)) return 0;
                continue;
            }
            const double change =
                SAFE_WAYS * h
                * fmax(fabs(x.rate[k]), low.rate[k] == low.rate[k] ? fabs(low.rate[k]) : 0.0);
            if (!(x.value[k] > change && low.value[k] > change)) return 0;
        }
    }
    int32_t which;
    if (find_dip(c, c->t - h, h, low, x, &which) != 0.0) return 0;
    if (c->tolerance > 0.0) find_gap_rates(c, x);
    return 1;
}

/* A piece of length h. */
static int32_t step_piece(context *c, double h)
{
    return is_short(c, h) ? short_piece(c, h) : step_halving(c, h, UNDIVIDED);
}

HM_SELDOM static void undo_piece(context *c, double t, double law_time)
{
    restore_state(c, start_of_piece(c), t, law_time);
    if (c->event.divided) put_ahead_back(c);
}

/* Finds the first event of a piece of length h from time t, whose functions at both ends are known,
   and leaves the state there; `covered` is its time, h if there is none. */
HM_SELDOM static int32_t find_event(context *c, double t, double law_time, double h,
                                    double *covered)
{
    const int32_t n = c->m->n_contacts + c->m->n_frictions;
    const event_values low = values_at(c, AT_LOW), high = values_at(c, AT_HIGH),
                       at = values_at(c, AT_TRIAL);
    const double least = 4e-16 * (fabs(t) + h);
    double begin = 0.0, end = h, last = INFINITY;
    int is_open = 1; /* whether no function is known to be negative at `end` */
    *covered = h;
    c->event.function = -1;
    for (int trial = 0;; trial++) { /* the piece that is left halves in three trials, or faster */
        const double width = end - begin;
        double first = INFINITY;
        int32_t which = -1;
        for (int32_t k = 0; k < n; k++) {
            const double root = root_between(c, k, width, trial > 0, low, high);
            if (root < first) first = root, which = k;
        }
        if (which < 0 && trial == 0 && (first = find_dip(c, t, h, low, high, &which)) == 0.0)
            return HOLONOM_OK;
        /* What a trial showed at `end` counts as 0 by the forces at `begin`. */
        const int is_end = which < 0 && !is_open;
        if (is_end) first = width, which = c->event.function;
        c->event.function = which;
        if (which < 0) { /* it only came close */
            undo_piece(c, t, law_time);
            int32_t status = step_piece(c, h);
            *covered = h;
            if (end < h) copy_values(c, high, low), begin = end, end = h, last = INFINITY;
            else if (!status) return event_functions(c, high);
            if (!status) status = event_functions(c, high);
            if (status) return status;
            continue;
        }
        blame(c, which < c->m->n_contacts ? c->m->contact_row[which]
                                          : slip_row(c, which - c->m->n_contacts, 0));
        if (width > 0.5 * last && trial % 3 == 2) first = 0.5 * width; /* one end does not move */
        last = width;
        *covered = fmin(begin + fmax(first, fmin(least, 0.5 * width)), end);
        undo_piece(c, t, law_time);
        int32_t status = step_piece(c, *covered);
        if (!status) status = event_functions(c, at);
        if (status) return status;
        int is_late = 0;
        for (int32_t k = 0; k < n; k++) is_late |= at.value[k] < -value_tolerance(c, k);
        if (is_end || (at.value[which] <= value_tolerance(c, which) && !is_late)) return HOLONOM_OK;
        if (width <= 2.0 * least) return HOLONOM_OK;
        /* A gap that comes close and grows here again is lowest before. */
        const int has_passed =
            is_open && high.rate[which] > 0.0 && at.rate[which] > 0.0 && low.rate[which] < 0.0;
        copy_values(c, at, is_late || has_passed ? high : low);
        if (is_late || has_passed) end = *covered;
        else begin = *covered;
        is_open &= !is_late;
    }
}

/* Whether function k is 0 at the event, so that its mode has ended. */
static int has_ended(const context *c, int32_t k)
{
    return k == c->event.function || values_at(c, AT_TRIAL).value[k] <= value_tolerance(c, k);
}

#define FAR_MORE 100.0

/* Lets friction f stick, whose slip has ended, and takes what is left of it: slips have the rates
   that a step leaves of its rows. At a dead centre, where the mechanism hardly slips however fast
   it moves, that would take much of its energy, far more than frictions do at their cones in the
   time that the slip has left. It slides on then. */
HM_SELDOM static int32_t stop_slip(context *c, int32_t f)
{
    const event_values at = values_at(c, AT_TRIAL);
    const double slip = slip_of(c, f, NULL), growth = at.rate[c->m->n_contacts + f];
    double force = 0.0, taken = 0.0;
    for (int32_t g = 0, k = c->m->n_contacts; g < c->m->n_frictions; g++, k++) {
        const double normal = normal_force(c, g, c->k.event_mu);
        if (at.rate[k] < 0.0 && has_ended(c, k))
            force += cone(c, g, 0, normal) + cone(c, g, 1, normal);
    }
    let_stick(c, f);
    const int32_t status = find_disallowed(c);
    if (status) return status;
    EACH_ROW(c, i) taken += 0.5 * c->k.mu[i] * c->k.phi[i];
    if (slip > speed_tolerance(c) && taken * -growth > FAR_MORE * 0.5 * force * slip * slip)
        friction_of(c, f)[F_MODE] = FRICTION_SLIDES;
    else take_disallowed(c, S_FRICTION);
    return HOLONOM_OK;
}

/* Changes the modes that have ended: contacts without force open, frictions at their cones slide,
   those without slip stick. */
HM_SELDOM static int32_t change_modes(context *c)
{
    const holonom_model *m = c->m;
    if (has_forces(c)) {
        const int32_t status = project_velocities(c, S_IMPACT);
        if (status) return status;
    }
    for (int32_t i = 0; i < m->n_contacts; i++)
        if (is_closed(c, i) && has_ended(c, i))
            open_contact(c, i), contact_of(c, i)[C_PARTED] = 1.0;
    for (int32_t f = 0, k = m->n_contacts; f < m->n_frictions; f++, k++) {
        const int mode = friction_mode(c, f);
        double along[3];
        if (mode == FRICTION_OFF || !has_ended(c, k)) continue;
        if (mode == FRICTION_SLIDES) {
            const int32_t status = stop_slip(c, f);
            if (status) return status;
            continue;
        }
        if (c->event.together) { /* new modes tell who slides */
            c->event.gives_way = 1;
            continue;
        }
        friction_force(c, f, c->k.event_mu, along);
        let_slide(c, f, along);
    }
    return HOLONOM_OK;
}

/* Impacts and new modes at the present state. */
HM_SELDOM static int32_t settle(context *c)
{
    int hits = 0;
    forget_secants(c);
    int32_t status = hit_all(c, &hits);
    if (!status) status = settle_modes(c);
    if (status == HOLONOM_CONTACT_UNDECIDED) {
        status = jam(c);
        if (!status) status = settle_modes(c);
    }
    c->s.head[S_EVENTS] += 1.0;
    c->s.head[S_UNSETTLED] = 0.0;
    if (!status) status = event_functions(c, values_at(c, AT_LOW));
    return status;
}

/* New modes after a change of inputs or parameters. Rates that closed contacts still have are no
   approach. */
HM_SELDOM static int32_t settle_changes(context *c)
{
    keep_start(c);
    evaluate_state(c);
    const int32_t status = has_forces(c) ? project_velocities(c, S_IMPACT) : HOLONOM_OK;
    return status ? status : settle(c);
}

/* Slip in space turns fast just before it stops, and passes through 0 along no direction known
   before. A piece ends before the time at which the slip would stop at its present rate: a tenth of
   that time is left, so that pieces are as short as the motion is fast and orders above 2 hold. A
   SLIP_LEFT part of the speed of the mechanism counts as none. */
#define SLIP_LEFT 1e-7
#define BEFORE_STOP 0.9

static double length_before_stop(const context *c, double length)
{
    const event_values low = values_at(c, AT_LOW);
    EACH_FRICTION(c, f) {
        const int32_t k = c->m->n_contacts + f;
        if (n_slips(c, f) > 1 && friction_mode(c, f) == FRICTION_SLIDES && low.rate[k] < 0.0
            && low.value[k] >= 0.0)
            length = fmin(length, BEFORE_STOP * low.value[k] / -low.rate[k]);
    }
    return length;
}

/* Shortens the piece to come, of this length, where a slip is about to stop. Rates that rows still
   have, of directors that turn, are part of the slip that the velocities show, and would be more
   than what is left of it. */
static int32_t stop_before(context *c, double *length)
{
    const double whole = *length;
    if (!(length_before_stop(c, whole) < whole)) return HOLONOM_OK;
    if (mesh_of(c)) note_ahead(c, MESH_PROJECTED - MESH_LOWERED);
    int32_t status = project_velocities(c, S_IMPACT);
    if (!status) status = event_functions(c, values_at(c, AT_LOW));
    *length = length_before_stop(c, whole);
    return status;
}

/* Friction turns a slip in space that is smaller than what it changes in a step faster than the
   slip grows: in parts of a step that go back in time the direction then runs away. Where sliding
   begins, pieces of orders above 2 are as short as the slip is small, and the first ones, this part
   of a step, are of order 2, which has no such parts. Returns 1 if the piece to come is one of
   these, and shortens its length. */
#define FIRST_PIECE 0.015625

static int begins_to_slide(const context *c, double *length)
{
    const event_values low = values_at(c, AT_LOW);
    const double shortest = FIRST_PIECE * usual_length(c);
    double most = INFINITY;
    if (!c->friction.slides || !(c->s.head[S_ORDER_IN_USE] > 2.0)) return 0;
    for (int32_t f = 0, k = c->m->n_contacts; f < c->m->n_frictions; f++, k++) {
        if (n_slips(c, f) == 1 || friction_mode(c, f) != FRICTION_SLIDES || low.rate[k] < 0.0)
            continue;
        const double force = fabs(cone(c, f, 1, normal_force(c, f, c->k.event_mu)));
        most = fmin(most,
                    low.value[k]
                        / (force * c->number[c->m->row_sigma_at + row_of(c, slip_row(c, f, 0))]));
    }
    if (!(most < *length)) return 0;
    *length = fmin(*length, fmax(most, shortest));
    return !(most > shortest);
}

/* Directions of slips in space at the end of a piece, whose functions (at) were evaluated last;
   whether one of them is about to stop. */
static int follow_slips(context *c, event_values at)
{
    int stops = 0;
    EACH_FRICTION(c, f) {
        const int32_t k = c->m->n_contacts + f;
        double along[3];
        if (n_slips(c, f) == 1 || friction_mode(c, f) != FRICTION_SLIDES || is_smooth(c, f))
            continue;
        const double before = at.value[k];
        at.value[k] = direction_of(n_slips(c, f), c->k.slip_at_end + 3 * f, along);
        if (at.value[k] > 0.0) let_slide(c, f, along);
        if (!(at.rate[k] < 0.0) || at.value[k] > SLIP_LEFT / RESTING * speed_tolerance(c)) continue;
        if (mesh_of(c)) say_end(c, END_STOP, k, before);
        at.value[k] = 0.0;
        stops = 1;
    }
    return stops;
}

/* Whether friction has given no energy over the piece. It gives some where rows that hold the same
   thing twice share a normal force at will and one of them pulls; the ledger closes even then. */
static int friction_takes_energy(const context *c)
{
    const double *start = start_of_piece(c), *head = c->s.head;
    return head[S_FRICTION] >= start[S_FRICTION] - 1e-9 * head[S_ENERGY_REFERENCE];
}

/* Gaps of contacts that sleep, for a piece that is made again with all awake. */
static void value_asleep(const context *c, event_values x)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (is_asleep(c, i))
            x.value[i] = value_of_function(c, c->m->contact_row[i], 0), x.rate[i] = NAN;
}

/* No events of contacts that sleep: their functions are infinite. */
static void forget_asleep(const context *c, event_values x)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        const int32_t f = c->m->contact_friction[i];
        if (!is_asleep(c, i)) continue;
        x.value[i] = INFINITY, x.rate[i] = NAN;
        if (f >= 0) x.value[c->m->n_contacts + f] = INFINITY, x.rate[c->m->n_contacts + f] = NAN;
    }
}

/* Whether a gap lies behind its zero where the search of an event has ended. The equations of a
   step may have two solutions, as where friction turns a slip within far less than the step; if
   those of lengths beside each other differ, no length has the gap closed. */
static int gap_has_jumped(const context *c)
{
    const event_values at = values_at(c, AT_TRIAL);
    if (c->event.function < 0) return 0;
    EACH_CONTACT(c, i)
        if (!is_closed(c, i) && at.value[i] < -gap_tolerance(c)) return 1;
    return 0;
}

/* Cuts a piece of length h from time t, whose step has just been made, at its first event;
   `covered` is the length that it then has. */
static int32_t cut_piece(context *c, double t, double law_time, double h, double *covered)
{
    const event_values low = values_at(c, AT_LOW), high = values_at(c, AT_HIGH);
    double reach = SAFE_WAYS * h * fastest_node(c);
    int32_t status = HOLONOM_OK;
    *covered = h;
    c->event.function = -1;
    c->event.cuts = 0;
    follow_travel(c, start_of_piece(c));
    if (c->view.near[NEAR_CONTACTS]
        && !(travel_left(c)
             > reach)) { /* what moves has become much faster: once more, with all awake */
        undo_piece(c, t, law_time);
        value_asleep(c, low);
        wake_all(c);
        status = step_piece(c, h);
        if (status) return status;
        reach = SAFE_WAYS * h * fastest_node(c);
    }
    if (!is_quiet(c, h, reach, low, high)) {
        if (c->view.near[NEAR_CONTACTS]) forget_asleep(c, low);
        status = event_functions(c, high);
        c->event.cuts = !status && !is_short(c, h) && passes_edge(c, h, low, high);
        if (c->event.cuts) return HOLONOM_CONTACT_UNDECIDED;
        if (!status) status = find_event(c, t, law_time, h, covered);
        follow_travel(c, start_of_piece(c));
    } else if (asks_for_far(c, reach)) {
        look_far(c, reach, high.value, high.rate);
    }
    c->event.cuts = !status && (gap_has_jumped(c) || !friction_takes_energy(c));
    return c->event.cuts ? HOLONOM_CONTACT_UNDECIDED : status;
}

/* Likewise; changes modes there. */
static int32_t end_piece(context *c, double t, double law_time, double h, double *covered)
{
    const event_values low = values_at(c, AT_LOW), high = values_at(c, AT_HIGH);
    int32_t status = cut_piece(c, t, law_time, h, covered);
    if (status) return status;
    if (*covered == h && c->event.function < 0 && is_short(c, h) && part_at_edges(c, h, low)) {
        if (!(c->s.head[S_EVENTS] < c->s.head[S_MAX_EVENTS])) return HOLONOM_TOO_MANY_EVENTS;
        return settle(c);
    }
    if (*covered == h && c->event.function < 0) {
        const int stops = follow_slips(c, high);
        copy_values(c, high, stops ? values_at(c, AT_TRIAL) : low);
        if (!stops) return HOLONOM_OK;
    } else if (mesh_of(c))
        say_end(c, END_EVENT, c->event.function, values_at(c, AT_TRIAL).value[c->event.function]);
    if (!(c->s.head[S_EVENTS] < c->s.head[S_MAX_EVENTS])) return HOLONOM_TOO_MANY_EVENTS;
    status = change_modes(c);
    return status ? status : settle(c);
}

#endif
