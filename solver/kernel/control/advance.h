/* A communication step. */
#ifndef HOLONOM_ADVANCE_H
#define HOLONOM_ADVANCE_H

#include "fault.h"
#include "measure.h"
#include "repeat.h"

/* Whether an input that is held over a communication step differs. */
HM_OFTEN int has_jumped(const context *c, const double *before, const double *inputs)
{
    for (int32_t i = 0; i < c->m->n_inputs; i++)
        if (c->m->input_course[i] == INPUT_HELD && before[i] != inputs[i]) return 1;
    return 0;
}

int32_t holonom_set_inputs(const holonom_model *m, double *number, double *state, double *work,
                           const double *inputs, const double *parameters, double *gap)
{
    context c;
    int32_t pressed = -1;
    open_context(&c, m, number, state, work);
    set_laws(&c, c.t, 0);
    const int has_new_parameters =
        memcmp(c.s.parameters, parameters, sizeof(double) * (size_t)m->n_parameters) != 0;
    double *before = values_at(&c, AT_LOW).value;
    if (has_new_parameters && n_contacts(m)) quantities_at_state(&c);
    for (int32_t i = 0; i < n_contacts(m) && has_new_parameters; i++) before[i] = gap_of(&c, i);
    const int has_new_inputs =
        memcmp(c.s.inputs, inputs, sizeof(double) * (size_t)m->n_inputs) != 0;
    if (has_new_parameters) start_anew(&c), wake_all(&c);
    if (has_jumped(&c, c.s.inputs, inputs)) end_line(&c);
    if (has_new_parameters || has_new_inputs) c.s.head[S_UNSETTLED] = 1.0;
    memcpy(c.s.inputs, inputs, sizeof(double) * (size_t)m->n_inputs);
    memcpy(c.s.parameters, parameters, sizeof(double) * (size_t)m->n_parameters);
    set_laws(&c, c.t, 1);
    if (has_new_parameters || has_new_inputs) settle_sides(&c, c.t, 1);
    for (int32_t i = 0; i < n_contacts(m) && has_new_parameters; i++) {
        const double now = gap_of(&c, i);
        if (now < before[i] && now < -gap_tolerance(&c))
            *gap = now, pressed = row_of(&c, m->contact_row[i]);
    }
    return pressed;
}

/* Mean slope of input i in a communication step. */
static double mean_slope(const context *c, int32_t i, double step)
{ return (c->s.inputs[i] - c->s.inputs_before[i]) / step; }

#define FAR_AHEAD                                                                                  \
    3.0 /* times the step before: a polynomial through that one would enlarge what its values lack
           \ */

#define MUCH_LONGER 1.25 /* likewise: values so unevenly apart tell no third derivative */
#define LONGER 1.01     /* likewise: steps of a regular run differ by round-off */

static int is_longer(double step, double before, double times)
{ return before != 0.0 && !(step <= times * before); }

static int stands(const context *c, int32_t i)
{ return c->s.inputs_slope[i] == 0.0 && c->s.inputs_mean[i] == 0.0; }

/* Change of the mean slope of a smooth input from the last step, over the time between: half its
   acceleration. One that stands begins from rest. */
HM_SELDOM static double curve_of_input(const context *c, int32_t i, double step)
{
    return (mean_slope(c, i, step) - c->s.inputs_mean[i])
           / (stands(c, i) ? step : step + c->s.head[S_INPUT_STEP]);
}

/* Slope of a smooth input at the end of a step: that of the cubic through its last four values, as
   far as there are so many. */
HM_SELDOM static double slope_at_end(const context *c, int32_t i, double step)
{
    const double before = c->s.head[S_INPUT_STEP], earlier = c->s.head[S_INPUT_STEP_BEFORE];
    const double curve = curve_of_input(c, i, step), slope = mean_slope(c, i, step) + step * curve;
    if (is_longer(step, before, FAR_AHEAD)) return mean_slope(c, i, step);
    if (c->s.inputs_curve[i] == 0.0 || is_longer(before, earlier, MUCH_LONGER)
        || is_longer(step, before, MUCH_LONGER))
        return slope;
    return slope
           + step * (step + before) * (curve - c->s.inputs_curve[i]) / (step + before + earlier);
}

/* Slope of an input in a step, of a smooth one at its beginning: as it came, unless its value
   jumped in a step before that was shorter. Then the cubic would leave its values far behind, and
   the slope stays within 3 mean slopes, as that of a monotone cubic does (Fritsch and Carlson
   1980): that of the step, or the smaller one of the two before it. Steady accelerations are
   within. */
HM_SELDOM static double slope_at_start(const context *c, int32_t i, double step)
{
    const double slope = c->s.inputs_slope[i], mean = mean_slope(c, i, step);
    if (c->m->input_course[i] == INPUT_RAMPS) return mean;
    if (c->m->input_course[i] == INPUT_HELD || !is_longer(step, c->s.head[S_INPUT_STEP], LONGER))
        return slope;
    const double most =
        3.0 * fmax(fabs(mean), fmin(fabs(c->s.inputs_mean[i]), fabs(c->s.inputs_mean_before[i])));
    return fmin(fmax(slope, -most), most);
}

/* Cubic of a smooth input in a step, from its slope at present to that at the end. */
HM_SELDOM static void bend_input(context *c, int32_t i, double step)
{
    const double mean = mean_slope(c, i, step), first = c->s.inputs_slope[i],
                 last = slope_at_end(c, i, step);
    c->s.inputs_bend[i] = (3.0 * mean - 2.0 * first - last) / step;
    c->s.inputs_third[i] = (first + last - 2.0 * mean) / (step * step);
}

/* A held input that changes with each communication step by nearly as much as in the step before,
   less than this part of the largest change so far, is a sample of what is smooth: a controller's.
   That fades, and each step leaves so much of it. */
#define SMOOTH 0.25
#define REMEMBERED 0.98

/* Whether held inputs that jump are such samples, with one internal step between them, of a pair or
   its covers: then the same halves of internal steps follow a smooth course, too. */
HM_SELDOM static int are_samples(const context *c, double step)
{
    if (c->s.head[S_SUBSTEPS] > (c->tolerance > 0.0 ? 6.0 : 2.0)) return 0;
    for (int32_t i = 0; i < c->m->n_inputs; i++) {
        const double slope = mean_slope(c, i, step),
                     largest = fmax(fabs(slope), c->s.inputs_mean_before[i]);
        if (c->m->input_course[i] == INPUT_HELD
            && !(fabs(slope - c->s.inputs_mean[i]) <= SMOOTH * largest))
            return 0;
    }
    return 1;
}

/* After a step inputs are where they were to go, and smooth ones move on as fast, with the same
   acceleration. */
HM_SELDOM static void end_inputs(context *c, double step)
{
    for (int32_t i = 0; i < c->m->n_inputs; i++) {
        if (c->m->input_course[i] == INPUT_SMOOTH) {
            const double slope = slope_at_end(c, i, step);
            c->s.inputs_curve[i] = curve_of_input(c, i, step);
            c->s.inputs_slope[i] = slope;
            c->s.inputs_mean_before[i] = c->s.inputs_mean[i];
            c->s.inputs_mean[i] = mean_slope(c, i, step);
            c->s.inputs_bend[i] += 3.0 * step * c->s.inputs_third[i];
            c->s.inputs_third[i] = 0.0;
        } else if (c->m->input_course[i] == INPUT_HELD) {
            c->s.inputs_mean[i] = mean_slope(c, i, step);
            c->s.inputs_mean_before[i] =
                fmax(fabs(c->s.inputs_mean[i]), REMEMBERED * c->s.inputs_mean_before[i]);
        }
        c->s.inputs_before[i] = c->s.inputs[i];
    }
    c->s.head[S_INPUT_STEP_BEFORE] = c->s.head[S_INPUT_STEP];
    c->s.head[S_INPUT_STEP] = step;
}

/* Ramped inputs change their slopes at communication points, and smooth ones after a jump; with
   them the rates of signals jump. */
HM_SELDOM static int32_t start_inputs(context *c, double step)
{
    const holonom_model *m = c->m;
    double *slope = c->s.inputs_slope;
    int changed = 0;
    for (int32_t i = 0; i < m->n_inputs; i++) {
        const int begins = m->input_course[i] == INPUT_SMOOTH && stands(c, i)
                           && c->s.inputs[i] != c->s.inputs_before[i];
        if (begins) c->s.head[S_MEAN_TIME] = INFINITY; /* no line to before */
        changed |= slope_at_start(c, i, step) != slope[i];
    }
    if (changed) signal_rates_at(c, c->t, c->k.signal_before);
    for (int32_t i = 0; i < m->n_inputs; i++) {
        slope[i] = slope_at_start(c, i, step);
        if (m->input_course[i] == INPUT_SMOOTH) bend_input(c, i, step);
    }
    return changed ? jump_with_signals(c, c->t) : HOLONOM_OK;
}

HM_SELDOM int32_t holonom_may_be_explicit(const holonom_model *m, double *number, double *state,
                                          double *work)
{
    context c;
    open_context(&c, m, number, state, work);
    const double *head = c.s.head;
    const int order = (int)head[S_ORDER];
    return head[S_METHOD] != 0.0 && hm_tolerance(head) > 0.0 && (!order || is_explicit_order(order))
           && allows_explicit(&c, 0);
}

static void add_loss(holonom_methods *found, int32_t composite)
{
    if (!found->losses) found->first = composite;
    found->losses++;
}

HM_SELDOM void holonom_find_methods(const holonom_model *m, double *number, double *state,
                                    double *work, holonom_methods *found)
{
    context c;
    open_context(&c, m, number, state, work);
    *found = (holonom_methods){0};
    EACH_ELEMENT(&c, j) if (kind_of(&c, j)->bound(&c, j).damping != 0.0) add_loss(found, j);
    for (int32_t f = 0; f < n_frictions(m); f++)
        if (is_smooth(&c, f)) add_loss(found, slip_row(&c, f, 0));
    found->covered = found->losses > 0;
    found->composed = !found->covered || choose_methods(&c);
}

int32_t holonom_advance(const holonom_model *m, double *number, double *state, double *work,
                        double step, holonom_watch *watch, holonom_mesh *mesh)
{
    context c;
    open_context(&c, m, number, state, work);
    c.watch = watch;
    c.mesh = mesh;
    c.switches.pause = 1e-9 * step;
    double *head = c.s.head;
    head[S_STATUS] = HOLONOM_BAD_STEP;
    if (!(step > 1e-100 && step < 1e300))
        return HOLONOM_BAD_STEP; /* its square must be a number, too */
    keep_state(&c, c.k.step_backup);
    if (has_jumped(&c, c.s.inputs_before, c.s.inputs)) {
        c.laws.are_samples = !is_unilateral(m) && are_samples(&c, step);
        if (!c.laws.are_samples) forget_halves(&c);
    }
    head[S_NEWTON_ITERATIONS] = head[S_UZAWA_ITERATIONS] = head[S_SUBSTEPS] = head[S_AS_PAIRS] =
        0.0;
    for (int32_t i = 0; i < m->n_sampled; i++) c.s.sampled[3 * i + 2] = 0.0;
    const double start = head[S_TIME];
    const int moved = move_inputs(&c);
    int32_t status = start_inputs(&c, step);
    set_laws(&c, start, 0);
    const int moves = moved || move_inputs(&c);
    if (moves) settle_sides(&c, start, 1); /* slopes tell where inputs go */
    head[S_EVENTS] = 0.0;
    head[S_STEPPED] = head[S_SWITCHED] = 0.0;
    head[S_JAMS] = head[S_NEWTON_IMPACTS] = head[S_MIXED_IMPACTS] = head[S_DEFERRED_FRICTIONS] =
        0.0;
    if (repeated_by(&c)) wake_all(&c);
    if (!status && is_unilateral(m) && !is_stepped(&c))
        status = head[S_UNSETTLED] != 0.0 ? settle_changes(&c) : take_functions(&c, moves);
    if (!status && c.tolerance > 0.0) follow_jumps(&c);
    if (repeated_by(&c)) status = status ? status : cover_by_mesh(&c, start, step);
    else if (is_unilateral(m) && may_step_over(status)) {
        undo_piece(&c, start, c.number[m->time_at]);
        status = step_over(&c, status, start, 0.0, step);
    } else if (!status && is_stepped(&c)) status = cover_stepped(&c, start, 0.0, step);
    else if (!status)
        status = (c.tolerance > 0.0 ? cover_to_tolerance : cover_evenly)(&c, start, step);
    if (!status && m->time_dependent) set_laws(&c, start + step, 1);
    if (!status && n_switches(&c)) status = end_at_switch(&c, start + step, step);
    if (!status && !(fabs(head[S_WORK]) < INFINITY)) status = HOLONOM_BAD_LAW;
    if (status && watch && watch->is_stopped) status = HOLONOM_STOPPED;
    if (!status && m->steep_signals) signals_at(&c, start + step, c.k.signal1);
    const int is_tame = !status && (!m->steep_signals || !hm_may_be_steep(m, c.number, 2));
    if (!is_tame && status != HOLONOM_STOPPED
        && (blame_signal(&c, start + step, status ? 2 : 1) || blame_signal(&c, start, 2)))
        status = HOLONOM_BAD_DRIVER;
    if (status) {
        if (!c.step.at_fault) blame_hardest(&c);
        if (!c.step.at_fault) blame_worst(&c, status);
        take_state(&c, c.k.step_backup);
        head[S_STATUS] = status;
        head[S_AT_FAULT] = c.step.at_fault;
        return status;
    }
    keep_functions(&c, is_unilateral(m) && !is_stepped(&c) && !repeated_by(&c));
    end_inputs(&c, step);
    if (!(c.tolerance > 0.0)) head[S_EQUAL_TIME] += step;
    head[S_TIME] = start + step;
    head[S_STATUS] = HOLONOM_OK;
    head[S_AT_FAULT] = 0.0;
    follow_energies(&c);
    return HOLONOM_OK;
}

#endif
