/* Values of an instance: what is read, with rates, and what is set. */
#include "small.h"

#include "instance_parts.h"

#include <string.h>

void holonom_count_from(holonom_instance *i, int32_t first) { i->first = first; }

const hm_variable *holonom_variable_at(const holonom_instance *i, int32_t index)
{
    const uint32_t place = (uint32_t)index - (uint32_t)i->first;
    return place < i->file.header->n_variables ? i->file.variable + place : NULL;
}

const char *holonom_word(const holonom_instance *i, int32_t index, double value)
{
    return hm_word(&i->file, holonom_variable_at(i, index), value);
}

double holonom_number_of_word(const holonom_instance *i, int32_t index, const char *word)
{
    for (double k = 0.0;; k++) {
        const char *known = holonom_word(i, index, k);
        if (!known) return NAN;
        if (!strcmp(known, word)) return k;
    }
}

static int32_t refuse_index(holonom_instance *i, int32_t index)
{
    return hm_answer(i, HOLONOM_REFUSED, "no variable has the index %d", index);
}

/* Measures those groups which have not been since the state has changed. */
static int32_t measure(holonom_instance *i, int32_t groups)
{
    if (!(groups & ~i->measured)) return HOLONOM_DONE;
    if (i->phase == HOLONOM_CONFIGURED) {
        const int32_t result = holonom_assemble(i);
        if (result & ~HOLONOM_REMARKED) return result;
    }
    holonom_measure(&i->file.model, i->numbers, i->state, i->work, groups);
    i->measured |= groups;
    return HOLONOM_DONE;
}

/* Where an output is among the numbers. */
static int32_t place_of_variable(const holonom_instance *i, const hm_variable *v)
{
    return v->place + (v->kind == KIND_MEASURED ? i->file.model.measured_at : 0);
}

/* Of these each is measured with its group alone: fewer than there are groups to ask for. */
enum { FEW_VALUES = 8 };

static int32_t groups_of(const holonom_instance *i, int32_t place)
{
    static const int32_t groups[HOLONOM_GROUPS] = {
        HOLONOM_MEASURE_MOTION, HOLONOM_MEASURE_FORCES,   HOLONOM_MEASURE_BODIES,
        HOLONOM_MEASURE_FORCES, HOLONOM_MEASURE_ENERGIES, HOLONOM_MEASURE_MOMENTA,
        HOLONOM_MEASURE_SOLVER, HOLONOM_MEASURE_CONTACTS, HOLONOM_MEASURE_ACCELERATIONS};
    int k = 0;
    while (k < HOLONOM_GROUPS - 1 && place >= i->group_end[k]) k++;
    return groups[k];
}

int32_t holonom_get(holonom_instance *i, const int32_t *index, int32_t count, double *value)
{
    for (int32_t k = 0; k < count; k++) {
        const hm_variable *v = holonom_variable_at(i, index[k]);
        if (!v) return refuse_index(i, index[k]);
        switch (v->kind) {
        case KIND_PARAMETER: value[k] = i->s.parameters[v->place]; continue;
        case KIND_INPUT: value[k] = i->s.inputs[v->place]; continue;
        case KIND_OPTION: value[k] = i->state[v->place]; continue;
        default: break;
        }
        const int32_t place = place_of_variable(i, v);
        if (i->measured != HOLONOM_MEASURE_ALL) {
            const int few = v->kind == KIND_MEASURED && count <= FEW_VALUES;
            const int32_t result = measure(i, few ? groups_of(i, place) : HOLONOM_MEASURE_ALL);
            if (result) return result;
        }
        value[k] = i->numbers[place];
        if (!(fabs(value[k]) < INFINITY))
            return hm_answer(i, HOLONOM_UNTRIED, "%s is not finite at t = %6g s",
                             text_of(i, v->name), i->s.head[S_TIME]);
    }
    return HOLONOM_DONE;
}

/* Rates of outputs whose rate is not measured: forward differences of fourth order, as those of
   signals, so that what an output is before the present time does not matter. The state is put
   aside, and moves on in its place. */
static int32_t differ(holonom_instance *i, const int32_t *index, int32_t count, double *value)
{
    static const double weight[] = {48.0, -36.0, 16.0, -3.0}, part = 1e-2;
    enum { POINTS = sizeof weight / sizeof *weight };
    const holonom_model *m = &i->file.model;
    const double step = part * hm_step_size(i->s.head);
    double *now = i->before + i->state_size;
    int32_t groups = 0; /* forces under a tolerance are solved for: they are measured where their
                           rates are asked for alone */
    for (int32_t k = 0; k < count; k++) {
        const hm_variable *v = holonom_variable_at(i, index[k]);
        const int32_t place = place_of_variable(i, v);
        double known;
        if (!holonom_knows_rate(m, i->numbers, place, &known))
            groups |= v->kind == KIND_MEASURED ? groups_of(i, place) : HOLONOM_MEASURE_ALL;
    }
    hm_put_all_aside(i);
    const int32_t status = holonom_begin_moving_on(m, i->numbers, i->state, i->work, POINTS * step);
    holonom_measure(m, i->numbers, i->state, i->work, groups);
    memcpy(now, i->numbers, sizeof(double) * (size_t)m->n_numbers);
    for (int p = 0; p < POINTS && !status; p++) {
        holonom_move_on(m, i->numbers, i->state, i->work, step);
        holonom_measure(m, i->numbers, i->state, i->work, groups);
        for (int32_t k = 0; k < count; k++) {
            const int32_t place = place_of_variable(i, holonom_variable_at(i, index[k]));
            double known;
            if (!holonom_knows_rate(m, i->numbers, place, &known))
                value[k] += weight[p] / (12.0 * step) * (i->numbers[place] - now[place]);
        }
    }
    hm_take_all_back(i);
    i->measured = 0;
    return !status ? HOLONOM_DONE
                   : hm_answer(i, HOLONOM_UNTRIED, "rates of outputs at t = %6g s: %s",
                               i->s.head[S_TIME], hm_about_step(status));
}

int32_t holonom_get_rates(holonom_instance *i, const int32_t *index, int32_t count, double *value)
{
    int differs = 0;
    for (int32_t k = 0; k < count; k++) {
        const hm_variable *v = holonom_variable_at(i, index[k]);
        if (!v) return refuse_index(i, index[k]);
        if (v->causality != CAUSALITY_OUTPUT)
            return hm_answer(i, HOLONOM_REFUSED, "%s has no derivative: it is no output",
                             text_of(i, v->name));
        const int32_t measured = measure(i, HOLONOM_MEASURE_ALL);
        if (measured) return measured;
        differs |=
            !holonom_knows_rate(&i->file.model, i->numbers, place_of_variable(i, v), value + k);
    }
    const int32_t result = differs ? differ(i, index, count, value) : HOLONOM_DONE;
    for (int32_t k = 0; k < count && !result; k++)
        if (!(fabs(value[k]) < INFINITY))
            return hm_answer(i, HOLONOM_UNTRIED, "the derivative of %s is not finite at t = %6g s",
                             text_of(i, holonom_variable_at(i, index[k])->name), i->s.head[S_TIME]);
    return result;
}

/* Changes inputs and tunable parameters in motion, unless a law would break its rule. */
static int32_t change_in_motion(holonom_instance *i)
{
    const holonom_model *m = &i->file.model;
    const int may_break = i->has_rules_of_laws || m->variable_potential || m->n_contacts;
    double gap;
    if (may_break) hm_put_all_aside(i);
    const int32_t pressed =
        holonom_set_inputs(m, i->numbers, i->state, i->work, i->inputs, i->parameters, &gap);
    if (!may_break) return HOLONOM_DONE;
    hm_clear(&i->message);
    int problems = hm_broken_rules(&i->message, &i->file, i->numbers, RULES_OF_LAWS);
    if (pressed >= 0) hm_say_pressed(&i->message, &i->file, pressed, gap, problems++);
    if (!(fabs(i->s.head[S_WORK]) < INFINITY))
        hm_say(&i->message, "%swith these values a spring or potential has no finite energy",
               problems++ ? "\n" : "");
    if (!problems) return HOLONOM_DONE;
    hm_take_all_back(i);
    return HOLONOM_REFUSED;
}

static int32_t check_values(holonom_instance *i, const int32_t *index, int32_t count,
                            const double *value, const char *const *shown)
{
    hm_clear(&i->message);
    for (int32_t k = 0; k < count; k++) {
        const hm_variable *v = holonom_variable_at(i, index[k]);
        if (!v) return refuse_index(i, index[k]);
        if (hm_objects(&i->message, &i->file, v, value[k], shown ? shown[k] : NULL,
                       i->phase == HOLONOM_MOVING))
            return HOLONOM_REFUSED;
    }
    return HOLONOM_DONE;
}

/* Limit that a value is clipped to; NaN if it is taken as it is. */
static double clipping_limit(const hm_variable *v, double value)
{ return v->flags & CLIPS ? hm_limit_before(v, value) : NAN; }

/* Says once of an input that it is clipped. */
static void say_clipped(holonom_instance *i, const hm_variable *v, double value, const char *shown)
{
    const double limit = clipping_limit(v, value);
    const char *unit = text_of(i, v->unit);
    char *said = i->clipped + (v - i->file.variable);
    if (limit != limit || *said) return;
    *said = 1;
    hm_text *remarks = hm_open_remarks(i);
    hm_begin_line(remarks);
    hm_say(remarks, "%s: ", text_of(i, v->name));
    hm_say_value(remarks, value, shown);
    hm_say(remarks, "%u is beyond %6g%u, and is clipped to this limit (reported once)", unit, limit,
           unit);
    i->has_remarks = 1;
}

int32_t holonom_set(holonom_instance *i, const int32_t *index, int32_t count, const double *value,
                    const char *const *shown)
{
    const holonom_model *m = &i->file.model;
    int32_t result = check_values(i, index, count, value, shown), arriving = 1;
    if (result) return result;
    memcpy(i->inputs, i->s.inputs, sizeof(double) * (size_t)m->n_inputs);
    memcpy(i->parameters, i->s.parameters, sizeof(double) * (size_t)m->n_parameters);
    for (int32_t k = 0; k < count; k++) {
        const hm_variable *v = holonom_variable_at(i, index[k]);
        const double limit = clipping_limit(v, value[k]), taken = limit == limit ? limit : value[k];
        arriving &= v->kind == KIND_INPUT;
        if (v->kind == KIND_INPUT) i->inputs[v->place] = taken;
        if (v->kind == KIND_PARAMETER) i->parameters[v->place] = taken;
    }
    /* An input that arrives after the start is one for the step to come, not for the start. */
    if (i->phase == HOLONOM_MOVING || (i->phase == HOLONOM_ASSEMBLED && arriving)) {
        if ((result = change_in_motion(i))) return result;
    } else {
        memcpy(i->s.inputs, i->inputs, sizeof(double) * (size_t)m->n_inputs);
        memcpy(i->s.parameters, i->parameters, sizeof(double) * (size_t)m->n_parameters);
        i->phase = HOLONOM_CONFIGURED;
    }
    for (int32_t k = 0; k < count; k++) {
        const hm_variable *v = holonom_variable_at(i, index[k]);
        if (v->kind == KIND_OPTION) i->state[v->place] = value[k];
        say_clipped(i, v, value[k], shown ? shown[k] : NULL);
    }
    i->measured = 0;
    return hm_done(i);
}

#include "small.h"
