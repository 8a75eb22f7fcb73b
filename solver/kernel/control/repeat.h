/* Repeats the mesh of a run with other numbers: each internal step as the recorded one was taken,
   of a length that is a smooth function of the numbers.

   Steps are as long as they were, until an event, of contacts or a switch, comes sooner or later.
   The steps from the last such point, or from the communication point before, to that one are then
   longer or shorter by one factor: that at which its function has the value which the recorded step
   has left of it, or at which a switch of the time changes now. Those from there to the
   communication point take up the difference. No step is judged: a motion that changes its contacts
   or the sides of its laws in another order is refused. */
#ifndef HOLONOM_REPEAT_H
#define HOLONOM_REPEAT_H

#include "repeat_switches.h"

enum { MOST_TRIED = 40 };
#define FIRST_SECANT 1e-4 /* by which the second factor differs from 1 */
#define ROUND_OFF_SECANT 1e-9 /* so near to the factor before it round-off is all that is left */
#define ROUND_OFF_VALUE                                                                            \
    10.0 /* times what counts as zero: gaps of short pieces are not told more exactly */
#define FIRST_SHORTER 0.01 /* likewise where steps beyond the event fail */
#define MOST_FACTOR 4.0   /* of lengths, and its inverse */

/* Steps between two points that the mesh keeps: rows from first to last, which begin at `begin`
   now, `factor` times as long; `end` is their end, or NAN where the last one is as long as that
   tells. */
typedef struct mesh_piece {
    const double *first, *last;
    double begin, factor, end;
} mesh_piece;

static double recorded_length(const mesh_piece *x)
{ return x->last[MESH_TIME] + x->last[MESH_LENGTH] - x->first[MESH_TIME]; }

static int is_as_recorded(const mesh_piece *x)
{ return x->factor == 1.0 && x->begin == x->first[MESH_TIME]; }

/* Lets a piece end at a time at which a switch changes. */
static void end_at_time(mesh_piece *x, double end)
{
    const double recorded = x->last[MESH_VALUE];
    if (end == recorded && x->begin == x->first[MESH_TIME]) return;
    x->factor = (end - x->begin) / (recorded - x->first[MESH_TIME]);
    x->end = end;
}

/* Whether contacts end the step of a row. */
static int is_event(const double *row)
{ return row[MESH_END] == END_EVENT || row[MESH_END] == END_STOP; }

/* Takes the step of a row again, of length h. */
static int32_t take_again(context *c, const double *row, double h)
{
    double *head = c->s.head;
    int32_t status = HOLONOM_OK;
    head[S_WANTED] = row[MESH_USUAL];
    head[S_ORDER_IN_USE] = row[MESH_ORDER];
    head[S_EXPLICIT] = row[MESH_EXPLICIT];
    head[S_KNOWN] = fmin(head[S_KNOWN], row[MESH_KNOWN]);
    c->step.careful = row[MESH_CAREFUL] != 0.0;
    c->step.damped = is_dissipative(c);
    if (row[MESH_ANEW] != 0.0) forget_secants(c);
    if (row[MESH_LOWERED] != 0.0) lower_penalties(c);
    for (double k = 0.0; !status && k < row[MESH_PROJECTED]; k++)
        status = project_velocities(c, S_IMPACT);
    for (double k = 0.0; !status && k < row[MESH_STARTED]; k++) {
        context at = rows_at_state(c);
        take_unknowns(&at);
        status = keep_explicit_start(c, &at);
    }
    if (!status && row[MESH_PROJECTED] != 0.0) status = event_functions(c, values_at(c, AT_LOW));
    if (status) return status;
    begin_watched(c, h);
    if (is_unilateral(c->m)) keep_start(c);
    const int is_brief = row[MESH_TAKEN] == TAKEN_SHORT;
    status = is_brief ? short_piece(c, h) : internal_step(c, h);
    if (status) return status;
    if (!is_brief && taken_as(&c->last) != row[MESH_TAKEN]) return HOLONOM_MESH_METHODS;
    if (row[MESH_PUT_BACK] != 0.0) put_only_velocities_back(c);
    return HOLONOM_OK;
}

/* Refuses changes of contacts in a step that has just been taken, of length h from t, where the
   recorded one had none. */
static int32_t refuse_events(context *c, double t, double law_time, double h)
{
    const event_values high = values_at(c, AT_HIGH);
    double covered;
    const int32_t status = cut_piece(c, t, law_time, h, &covered);
    if (status) return status;
    if (c->event.function >= 0 || covered < h || follow_slips(c, high)) return HOLONOM_MESH_EVENTS;
    copy_values(c, high, values_at(c, AT_LOW));
    return HOLONOM_OK;
}

/* The row behind a row, if a switch of the motion ends its step, or NULL. */
static const double *next_row(const context *c, const double *row)
{
    const holonom_mesh *x = repeated_by(c);
    const double *next = row + row_size(c);
    return row[MESH_END] == END_SWITCH && next < x->row + row_size(c) * x->count ? next : NULL;
}

/* Takes the steps of a piece; with `looks` events are looked for in those that had none. */
static int32_t take_piece(context *c, const mesh_piece *x, int looks)
{
    const int same = is_as_recorded(x), tight = c->tolerance > 0.0;
    for (const double *row = x->first; row <= x->last; row += row_size(c)) {
        const double law_time = c->number[c->m->time_at];
        const double t =
            same ? row[MESH_TIME] : x->begin + x->factor * (row[MESH_TIME] - x->first[MESH_TIME]);
        const int is_last = row == x->last;
        const int32_t other = next_other_side(c, row, 0);
        const double h =
            !same && is_last && x->end == x->end ? x->end - t : x->factor * row[MESH_LENGTH];
        if (is_stopped(c)) return HOLONOM_STOPPED;
        if (row[MESH_TAKEN] == TAKEN_STEPPED) return HOLONOM_MESH_STEPPED;
        if (!(h > 0.0) || modes_of(c) != row[MESH_MODES]) return HOLONOM_MESH_EVENTS;
        if (other < n_switches(c)) return refuse_switch(c, other);
        c->t = t;
        int32_t status = take_again(c, row, h);
        if (!status && looks) status = check_step(c, row, next_row(c, row));
        if (!status && looks && is_unilateral(c->m) && !is_event(row))
            status = refuse_events(c, t, law_time, h);
        else if (!is_event(row)) follow_slips(c, values_at(c, AT_HIGH));
        if (status) return status;
        if (row[MESH_END] > END_LENGTH) return HOLONOM_OK; /* contacts or sides change first */
        if (tight) follow_energies(c);
        else follow_coarseness(c, h);
    }
    return HOLONOM_OK;
}

/* Value of the function of an event at the present state. */
static int32_t value_at_event(context *c, const double *row, double *value)
{
    const event_values at = values_at(c, AT_TRIAL);
    if (row[MESH_END] == END_SWITCH) {
        look_at_switches(c, c->k.argument_tried);
        *value = c->k.argument_tried[switch_of_row(c, row)];
        return HOLONOM_OK;
    }
    const int32_t status = event_functions(c, at);
    *value = at.value[(int32_t)row[MESH_FUNCTION]];
    return status;
}

/* Values of the function of an event that count as zero, where it is at hand. */
static double round_off_of_event(const context *c, const double *row)
{
    if (row[MESH_END] == END_STOP) return SLIP_LEFT / RESTING * speed_tolerance(c);
    return ROUND_OFF_VALUE
           * (row[MESH_END] == END_SWITCH ? rounding_of(c, switch_of(c, switch_of_row(c, row)))
                                          : value_tolerance(c, (int32_t)row[MESH_FUNCTION]));
}

/* Takes a piece from its start, which the mesh keeps; `left` of the function of its event there is
   more than in the recorded run. */
static int32_t take_to_event(context *c, const mesh_piece *x, double law_time, double *left)
{
    restore_state(c, repeated_by(c)->start, x->begin, law_time);
    int32_t status = take_piece(c, x, 0);
    if (!status) status = value_at_event(c, x->last, left);
    *left -= x->last[MESH_VALUE];
    return status;
}

/* Finds the factor at which a piece ends nearest to its event, by secants until round-off ends
   them. Beyond the event steps may fail. */
static int32_t meet_event(context *c, mesh_piece *x, double law_time, double longest)
{
    double left = 0.0, before = 0.0, last = NAN, best = NAN, least = INFINITY;
    double shorter = FIRST_SHORTER;
    int32_t status = HOLONOM_OK;
    int is_met = 0;
    for (int k = 0; k < MOST_TRIED; k++) {
        status = take_to_event(c, x, law_time, &left);
        double next;
        if (status == HOLONOM_STOPPED) return status;
        if (status || !(fabs(left) < INFINITY)) {
            next = last == last ? 0.5 * (last + x->factor) : x->factor - shorter;
            shorter *= 2.0;
        } else {
            if (fabs(left) < least) least = fabs(left), best = x->factor;
            is_met |= left == 0.0 || fabs(x->factor - last) < ROUND_OFF_SECANT;
            next = last == last ? x->factor - left * (x->factor - last) / (left - before)
                                : x->factor + copysign(FIRST_SECANT, left);
            last = x->factor;
            before = left;
        }
        const int is_near =
            next * MOST_FACTOR > 1.0 && next < MOST_FACTOR && next * recorded_length(x) <= longest;
        if (is_met || next == x->factor || !is_near) break;
        x->factor = next;
    }
    x->factor = best;
    if (!(least < INFINITY)) return status;
    if (is_met || least <= round_off_of_event(c, x->last)) return HOLONOM_OK;
    return x->last[MESH_END] == END_SWITCH ? refuse_switch(c, switch_of_row(c, x->last))
                                           : HOLONOM_MESH_EVENTS;
}

/* Takes a piece to its event. */
static int32_t take_event(context *c, mesh_piece *x, double law_time, double longest)
{
    const int32_t function = (int32_t)x->last[MESH_FUNCTION];
    const event_values at = values_at(c, AT_TRIAL);
    keep_state(c, repeated_by(c)->start);
    int32_t status = meet_event(c, x, law_time, longest);
    if (status) return status;
    restore_state(c, repeated_by(c)->start, x->begin, law_time);
    if (is_unilateral(c->m)) status = event_functions(c, values_at(c, AT_LOW));
    if (!status) status = take_piece(c, x, 1);
    if (status || !is_event(x->last)) return status;
    status = event_functions(c, at);
    if (status) return status;
    if (x->last[MESH_END] == END_STOP) follow_slips(c, at), at.value[function] = 0.0;
    for (int32_t k = 0; k < c->m->n_contacts + c->m->n_frictions; k++)
        if (k != function && at.value[k] < -value_tolerance(c, k)) return HOLONOM_MESH_EVENTS;
    return friction_takes_energy(c) ? HOLONOM_OK : HOLONOM_CONTACT_UNDECIDED;
}

/* Changes contacts at the end of a piece. */
static int32_t change_contacts(context *c, const double *row)
{
    c->event.function = row[MESH_END] == END_EVENT ? (int32_t)row[MESH_FUNCTION] : -1;
    const int32_t status = change_modes(c);
    return status ? status : settle(c);
}

/* Changes what a piece has ended at, of switches of the time at `stop`; `next` is the row behind
   it, or NULL. */
static int32_t change_at_end(context *c, const mesh_piece *x, const double *next, double stop)
{
    const int ends = (int)x->last[MESH_END];
    const int32_t status = ends == END_LENGTH   ? HOLONOM_OK
                           : ends == END_SWITCH ? pass_switch_of_row(c, x->last, next)
                           : ends == END_TIME   ? pass_time(c, stop)
                                                : change_contacts(c, x->last);
    if (!status && ends != END_LENGTH && c->tolerance > 0.0) follow_energies(c);
    return status;
}

/* Takes a piece, in a communication step of length `step` that goes on for `longest`, in which a
   switch changes at the time `stop` the next time. */
static int32_t repeat_piece(context *c, mesh_piece *x, double longest, double step, double stop)
{
    const int ends = (int)x->last[MESH_END];
    const double law_time = c->number[c->m->time_at];
    if (ends == END_TIME && !(stop < INFINITY)) return refuse_switch(c, switch_of_row(c, x->last));
    if (ends == END_TIME) end_at_time(x, stop);
    const int is_met = is_event(x->last) || ends == END_SWITCH;
    int32_t status = is_met ? take_event(c, x, law_time, longest) : take_piece(c, x, 1);
    const double end = x->begin + x->factor * recorded_length(x);
    if (status || ends == END_TIME || end <= stop + rounding_of_time(stop, step)) return status;
    status = pass_time(c, stop); /* which tells its switch */
    return status ? status : refuse_switch(c, c->switches.which);
}

/* Whether a row has no more than round-off of the time: it repeats an event, which need not happen
   so often now. */
static int is_no_time(const double *row)
{ return row[MESH_LENGTH] <= 1e-15 * fabs(row[MESH_TIME]); }

/* Repeats the steps of a communication step of length `step` from `start`. */
HM_SELDOM static int32_t cover_by_mesh(context *c, double start, double step)
{
    const int64_t size = row_size(c);
    const double *row = repeated_by(c)->row, *behind = row + size * repeated_by(c)->count,
                 end = start + step;
    double later = 0.0; /* by which the next piece begins later than in the recorded run */
    int32_t status = row < behind ? HOLONOM_OK : HOLONOM_MESH_METHODS, passed = -1;
    while (!status && row < behind) {
        mesh_piece x = {row, row, row[MESH_TIME] + later, 1.0, NAN};
        while (x.last[MESH_END] == END_LENGTH && x.last + size < behind) x.last += size;
        const double longest = end - x.begin;
        const int ends = (int)x.last[MESH_END];
        double stop = INFINITY;
        row = x.last + size;
        if (is_no_time(x.first) && modes_of(c) != x.first[MESH_MODES]) continue;
        if (ends == END_LENGTH && later != 0.0)
            x.factor = longest / (end - x.first[MESH_TIME]), x.end = end;
        c->t = x.begin;
        status = begin_on_row(c, x.first, longest, step, passed, &stop);
        if (!status) status = repeat_piece(c, &x, longest, step, stop);
        if (!status) status = change_at_end(c, &x, row < behind ? row : NULL, stop);
        if (!is_as_recorded(&x)) later += (x.factor - 1.0) * recorded_length(&x);
        passed = ends == END_SWITCH ? switch_of_row(c, x.last) : -1;
    }
    return status;
}

#endif
