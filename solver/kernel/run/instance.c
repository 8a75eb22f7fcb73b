#include "small.h"

#include "instance.h"
#include "sentences.h"

#include <string.h>

struct holonom_instance {
    hm_model_file file;
    hm_state s;
    double *numbers, *state, *work;
    double *before;              /* state and numbers, while a change of inputs is tried */
    double *inputs, *parameters; /* those to come */
    double *phi, *rate;          /* n_rows each */
    char at_fault[2 * NAME_ROOM];
    char *clipped;               /* of each variable: whether it was said that it is clipped */
    hm_text message, remarks;
    int64_t state_size;
    int32_t phase, measured, heard, has_rules_of_laws, said, has_remarks;
    int32_t first;               /* number of the first variable */
    int32_t group_end[HOLONOM_GROUPS];
    holonom_watch watch;
    holonom_mesh *mesh;
};

enum { MESSAGE_ROOM = 4096, ROOM_PER_ROW = 256, MOST_ROWS = 500, REMARK_ROOM = 2048 };
static const double
    LAST_DIGITS = 8.0,
    STEP_SLACK =
        1e-6; /* a step begins at the present time, up to so many last digits and this part of it */

static const char *text_of(const holonom_instance *i, uint32_t at) { return i->file.text + at; }

/* --------------------------------------------------------------------------------------- memory */

static size_t up(size_t bytes) { return (bytes + 15) & ~(size_t)15; }

static size_t message_room(const hm_model_file *f)
{
    const size_t rows = (size_t)f->header->n_rows + f->header->n_rules;
    return MESSAGE_ROOM + ROOM_PER_ROW * (rows < MOST_ROWS ? rows : MOST_ROWS);
}

static size_t work_bytes(const holonom_model *m)
{ return up(sizeof(double) * (size_t)holonom_work_size(m)); }

/* Lays an instance over `memory`, or only measures it; returns its bytes, of which the scratch is
   last. */
static size_t lay_out(const hm_model_file *f, char *memory, holonom_instance *i)
{
    const holonom_model *m = &f->model;
    const size_t state = (size_t)holonom_state_size(m), rows = (size_t)m->n_rows;
    size_t used = up(sizeof *i);
    struct { double **vector; size_t length;
    } part[] = {
        {&i->numbers, (size_t)m->n_numbers},
        {&i->state, state},
        {&i->before, state + (size_t)m->n_numbers},
        {&i->inputs, (size_t)m->n_inputs},
        {&i->parameters, (size_t)m->n_parameters},
        {&i->phi, rows},
        {&i->rate, rows},
    };
    for (size_t k = 0; k < sizeof part / sizeof *part; k++) {
        if (memory) *part[k].vector = (double *)(void *)(memory + used);
        used += up(sizeof(double) * part[k].length);
    }
    if (memory) {
        i->state_size = (int64_t)state;
        i->clipped = memory + used;
        i->message = (hm_text){i->clipped + up(f->header->n_variables + 1), message_room(f), 0};
        i->remarks = (hm_text){i->message.begin + up(i->message.room), REMARK_ROOM, 0};
    }
    used += up(f->header->n_variables + 1) + up(message_room(f)) + REMARK_ROOM;
    if (memory) i->work = (double *)(void *)(memory + used);
    return used + work_bytes(m);
}

int64_t holonom_instance_size(const void *model, int64_t length, char *why, int64_t room)
{
    hm_model_file f;
    holonom_instance none;
    hm_text text = {why, (size_t)room, 0};
    const char *flaw = hm_bind(model, length, &f);
    for (uint32_t k = 0; !flaw && k < f.header->n_variables;
         k++) /* the settings that a run begins with are allowed */
        if (f.variable[k].kind == KIND_OPTION
            && hm_objects(&text, &f, f.variable + k, f.settings[f.variable[k].place], NULL, 0))
            flaw = "a setting is not allowed";
    hm_clear(&text);
    if (!flaw) return (int64_t)lay_out(&f, NULL, &none);
    hm_say(&text, "the model cannot be used: %s; build it again", flaw);
    return 0;
}

holonom_instance *holonom_make(const void *model, void *memory, int32_t heard)
{
    holonom_instance *i = memory;
    hm_model_file file;
    if (!hm_view(model, &file)) return NULL;
    memset(i, 0,
           lay_out(&file, NULL, i)
               - work_bytes(&file.model)); /* most of a large one is scratch that few steps need */
    i->file = file;
    lay_out(&file, memory, i);
    hm_map_state(&i->file.model, i->state, &i->s);
    holonom_group_ends(&i->file.model, i->numbers, i->group_end);
    i->heard = heard;
    for (uint32_t k = 0; k < i->file.header->n_rules; k++)
        i->has_rules_of_laws |= i->file.rule[k].relation & OF_A_LAW;
    holonom_reset(i);
    return i;
}

void holonom_reset(holonom_instance *i)
{
    const hm_model_file *f = &i->file;
    memset(i->state, 0, sizeof(double) * (size_t)i->state_size);
    memcpy(i->numbers, f->numbers, sizeof(double) * (size_t)f->model.n_numbers);
    memcpy(i->state, f->settings, sizeof(double) * S_HEAD);
    for (uint32_t k = 0; k < f->header->n_variables; k++) {
        const hm_variable *v = f->variable + k;
        if (v->kind == KIND_PARAMETER) i->s.parameters[v->place] = v->start;
        if (v->kind == KIND_INPUT) i->s.inputs[v->place] = v->start;
    }
    memset(i->clipped, 0, f->header->n_variables);
    hm_clear(&i->message);
    hm_clear(&i->remarks);
    i->phase = HOLONOM_CONFIGURED;
    i->measured = i->said = i->has_remarks = 0;
}

const char *holonom_message(const holonom_instance *i) { return i->message.begin; }

const char *holonom_remarks(holonom_instance *i)
{
    i->has_remarks = 0;
    return i->remarks.begin;
}

/* Remarks not yet fetched, to which others may be added. */
static hm_text *open_remarks(holonom_instance *i)
{
    if (!i->has_remarks) hm_clear(&i->remarks);
    return &i->remarks;
}

static void begin_line(hm_text *text) { hm_say(text, "%s", text->used ? "\n" : ""); }

/* Puts state and numbers aside, and takes them back. */
static void put_all_aside(const holonom_instance *i)
{
    memcpy(i->before, i->state, sizeof(double) * (size_t)i->state_size);
    memcpy(i->before + i->state_size, i->numbers, sizeof(double) * (size_t)i->file.model.n_numbers);
}

static void take_all_back(const holonom_instance *i)
{
    memcpy(i->state, i->before, sizeof(double) * (size_t)i->state_size);
    memcpy(i->numbers, i->before + i->state_size, sizeof(double) * (size_t)i->file.model.n_numbers);
}

static int32_t done(const holonom_instance *i)
{ return i->has_remarks ? HOLONOM_REMARKED : HOLONOM_DONE; }

/* --------------------------------------------------------------------------------------- values */

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

/* Makes a sentence the message, and returns the result. */
static int32_t answer(holonom_instance *i, int32_t result, const char *format, ...)
{
    va_list values;
    hm_clear(&i->message);
    va_start(values, format);
    hm_say_all(&i->message, format, values);
    va_end(values);
    return result;
}

static int32_t refuse_index(holonom_instance *i, int32_t index)
{
    return answer(i, HOLONOM_REFUSED, "no variable has the index %d", index);
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
        HOLONOM_MEASURE_SOLVER, HOLONOM_MEASURE_CONTACTS};
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
            return answer(i, HOLONOM_UNTRIED, "%s is not finite at t = %6g s", text_of(i, v->name),
                          i->s.head[S_TIME]);
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
    put_all_aside(i);
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
    take_all_back(i);
    i->measured = 0;
    return !status ? HOLONOM_DONE
                   : answer(i, HOLONOM_UNTRIED, "rates of outputs at t = %6g s: %s",
                            i->s.head[S_TIME], hm_about_step(status));
}

int32_t holonom_get_rates(holonom_instance *i, const int32_t *index, int32_t count, double *value)
{
    int differs = 0;
    for (int32_t k = 0; k < count; k++) {
        const hm_variable *v = holonom_variable_at(i, index[k]);
        if (!v) return refuse_index(i, index[k]);
        if (v->causality != CAUSALITY_OUTPUT)
            return answer(i, HOLONOM_REFUSED, "%s has no derivative: it is no output",
                          text_of(i, v->name));
        const int32_t measured = measure(i, HOLONOM_MEASURE_ALL);
        if (measured) return measured;
        differs |=
            !holonom_knows_rate(&i->file.model, i->numbers, place_of_variable(i, v), value + k);
    }
    const int32_t result = differs ? differ(i, index, count, value) : HOLONOM_DONE;
    for (int32_t k = 0; k < count && !result; k++)
        if (!(fabs(value[k]) < INFINITY))
            return answer(i, HOLONOM_UNTRIED, "the derivative of %s is not finite at t = %6g s",
                          text_of(i, holonom_variable_at(i, index[k])->name), i->s.head[S_TIME]);
    return result;
}

/* Changes inputs and tunable parameters in motion, unless a law would break its rule. */
static int32_t change_in_motion(holonom_instance *i)
{
    const holonom_model *m = &i->file.model;
    const int may_break = i->has_rules_of_laws || m->variable_potential || m->n_contacts;
    double gap;
    if (may_break) put_all_aside(i);
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
    take_all_back(i);
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
    hm_text *remarks = open_remarks(i);
    begin_line(remarks);
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
    return done(i);
}

/* --------------------------------------------------------------------------------------- motion */

/* All numbers that depend on parameters, inputs and the time. */
static void evaluate(holonom_instance *i)
{
    const holonom_model *m = &i->file.model;
    memcpy(i->numbers + m->input_at, i->s.inputs, sizeof(double) * (size_t)m->n_inputs);
    memcpy(i->numbers + m->parameter_at, i->s.parameters, sizeof(double) * (size_t)m->n_parameters);
    i->numbers[m->time_at] = i->s.head[S_TIME];
    holonom_evaluate(m, i->numbers, 0);
    holonom_evaluate(m, i->numbers, 1);
}

void holonom_use_mesh(holonom_instance *i, holonom_mesh *mesh) { i->mesh = mesh; }

void holonom_let_look(holonom_instance *i, int32_t (*look)(void)) { i->watch.look = look; }

/* The watch of a start or a step that begins. */
static holonom_watch *begin_watch(holonom_instance *i)
{
    i->watch.left = HOLONOM_WORK_BETWEEN_LOOKS;
    i->watch.is_stopped = 0;
    return i->watch.look ? &i->watch : NULL;
}

/* Remarks on what moved far, and on the law that impacts at the start have, as lines of their
   own. */
static void remark_on_start(holonom_instance *i, int has_moved)
{
    hm_text *remarks = open_remarks(i);
    for (int what = 0; what < 2; what++) {
        const size_t end = remarks->used;
        begin_line(remarks);
        const size_t begin = remarks->used;
        if (what == 1) hm_say_newton(remarks, i->s.head, "at the start");
        else if (has_moved) hm_say_closing(remarks, &i->file, i->numbers, &i->s);
        if (remarks->used > begin) i->has_remarks = 1;
        else hm_take_back(remarks, end);
    }
}

int32_t holonom_assemble(holonom_instance *i)
{
    const holonom_model *m = &i->file.model;
    hm_text *message = &i->message;
    hm_work work;
    evaluate(i);
    hm_clear(message);
    int problems = hm_broken_rules(message, &i->file, i->numbers, RULES_OF_ALL);
    const size_t end = message->used;
    hm_say(message, "%s", problems ? "\n" : "");
    if (hm_unknown_to_method(message, &i->file, i->state)) return HOLONOM_UNASSEMBLED;
    if (problems) {
        hm_take_back(message, end); /* without the line break */
        return HOLONOM_UNASSEMBLED;
    }
    i->phase = HOLONOM_CONFIGURED;
    const int32_t status = holonom_initialise(m, i->numbers, i->state, i->work, begin_watch(i));
    i->measured = 0;
    hm_map_work(m, i->work, &work);
    memcpy(i->before, work.phi, sizeof(double) * (size_t)m->n_rows);
    holonom_rows(i, i->phi, i->rate);
    const hm_start start = {status, i->phi, i->rate, i->before};
    if (hm_say_failed_start(message, &i->file, i->numbers, &i->s, &start))
        return HOLONOM_UNASSEMBLED;
    i->phase = HOLONOM_ASSEMBLED;
    const int has_moved =
        i->s.head[S_ASSEMBLE] != 0.0 || m->n_signals > 0; /* drivers change velocities, at least */
    remark_on_start(i, has_moved && i->s.head[S_EQUILIBRIUM] == 0.0);
    return done(i);
}

const char *holonom_steps(holonom_instance *i, int32_t has_explicit)
{
    hm_clear(&i->message);
    hm_say_steps(&i->message, i->s.head,
                 has_explicit
                     && holonom_may_be_explicit(&i->file.model, i->numbers, i->state, i->work));
    return i->message.begin;
}

void holonom_begin(holonom_instance *i)
{
    if (i->phase == HOLONOM_ASSEMBLED) i->phase = HOLONOM_MOVING;
}

static int32_t fail(holonom_instance *i, double t, double step, int32_t status)
{
    double *head = i->s.head;
    const double longest = hm_tolerance(head) > 0.0 ? head[S_LONGEST_STEP] : hm_step_size(head);
    head[S_STATUS] = status;
    i->measured = 0;
    if (status != HOLONOM_BAD_STEP) { /* a law that breaks on the way mostly stays broken */
        i->numbers[i->file.model.time_at] = t + step;
        holonom_evaluate(&i->file.model, i->numbers, 1);
    }
    hm_text at_fault = {i->at_fault, sizeof i->at_fault, 0};
    hm_clear(&at_fault);
    hm_say_fault(&at_fault, &i->file, i->numbers, head, status);
    evaluate(i);
    answer(i, HOLONOM_FAILED, "step from t = %6g s with h = %6g s: ", t,
           step > longest ? longest : step);
    if (hm_say_strong_friction(&i->message, &i->file, i->numbers, status)) return HOLONOM_FAILED;
    hm_say(&i->message, "%s%s", i->at_fault, hm_about_step(status));
    hm_say_far_apart(&i->message, &i->file, i->numbers, status);
    return HOLONOM_FAILED;
}

int32_t holonom_move(holonom_instance *i, double t, double step)
{
    double *head = i->s.head;
    const double last_digit = nextafter(fabs(t), INFINITY) - fabs(t);
    const double slack =
        fabs(t + step) < INFINITY ? LAST_DIGITS * last_digit + STEP_SLACK * fabs(step) : 0.0;
    if (!(fabs(t - head[S_TIME]) <= slack))
        return answer(i, HOLONOM_UNTRIED,
                      "step from t = %r s asked for, but the mechanism is at %r s", t,
                      head[S_TIME]);
    if (!(step > 0.0)) return fail(i, t, step, HOLONOM_BAD_STEP);
    if (i->phase == HOLONOM_CONFIGURED) {
        const int32_t result = holonom_assemble(i);
        if (result & ~HOLONOM_REMARKED) return result;
    }
    /* A last digit of t that differs from the own time must not add up over many steps. */
    const int32_t status = holonom_advance(&i->file.model, i->numbers, i->state, i->work,
                                           (t - head[S_TIME]) + step, begin_watch(i), i->mesh);
    i->measured = 0;
    if (status) return fail(i, t, step, status);
    head[S_TIME] = t + step;
    i->phase = HOLONOM_MOVING;
    i->said = hm_remark(open_remarks(i), &i->file, i->numbers, &i->s, i->said, i->heard);
    i->has_remarks = i->remarks.used > 0;
    return done(i);
}

/* --------------------------------------------------------------------------------------- states */

typedef struct saved_state {
    char magic[8], fingerprint[32];
    int64_t phase, length;
    uint32_t checksum, unused;
} saved_state;

static const char SAVED[8] = "holonom5"; /* the digit is the version of the format */

static uint32_t checksum_of(saved_state head, const void *block)
{
    head.checksum = 0;
    return hm_checksum(hm_checksum(0, &head, sizeof head), block,
                       sizeof(double) * (size_t)head.length);
}

int64_t holonom_saved_size(const holonom_instance *i)
{ return (int64_t)sizeof(saved_state) + 8 * i->state_size; }

void holonom_keep(const holonom_instance *i, void *bytes)
{
    saved_state head;
    memset(&head, 0, sizeof head);
    memcpy(head.magic, SAVED, sizeof SAVED);
    memcpy(head.fingerprint, i->file.header->fingerprint, sizeof head.fingerprint);
    head.phase = i->phase;
    head.length = i->state_size;
    memcpy(bytes, &head, sizeof head);
    memcpy((char *)bytes + sizeof head, i->state, sizeof(double) * (size_t)i->state_size);
}

void holonom_seal(void *bytes)
{
    saved_state head;
    memcpy(&head, bytes, sizeof head);
    head.checksum = checksum_of(head, (const char *)bytes + sizeof head);
    memcpy(bytes, &head, sizeof head);
}

void holonom_save(const holonom_instance *i, void *bytes)
{
    holonom_keep(i, bytes);
    holonom_seal(bytes);
}

static int32_t refuse_state(holonom_instance *i, const char *why)
{
    return answer(i, HOLONOM_REFUSED, "the saved state %s", why);
}

/* Part of its size up to which a row may be off: loosely solved steps left up to 4e-4. */
static const double FARTHEST_OFF = 0.1;

/* Whether a saved block has only numbers that a run can come to; they steer what is not checked
   again. */
static const char *flaw_of_block(holonom_instance *i, const double *block)
{
    const hm_model_file *f = &i->file;
    for (int64_t k = 0; k < i->state_size; k++) {
        const int may_be_infinite = k == S_MEAN_TIME || k == S_MEAN_TIME_BEFORE || k == S_WANTED;
        if (!(fabs(block[k]) < INFINITY) && !(may_be_infinite && block[k] == INFINITY))
            return "has a number that is not finite; save it again";
    }
    const double order = block[S_ORDER_IN_USE];
    if (!(order >= 0.0 && order <= 8.0 && (order == 5.0 || order == 2.0 * floor(0.5 * order))))
        return "has a number that no run comes to; save it again";
    const double *island = block + (i->s.islands - i->s.head);
    for (int32_t k = 0; k < f->model.n_islands; k++) {
        const double level = island[I_SIZE * k + I_PENALTY_LEVEL];
        if (!(level >= 0.0 && level <= MOST_LEVELS && level == floor(level)))
            return "has a penalty that no run comes to; save it again";
        const double bend = island[I_SIZE * k + I_BEND],
                     lean = island[I_SIZE * k + I_LEAN_CONTRACTION];
        const double predicts = island[I_SIZE * k + I_PREDICTS_LAMBDA];
        if (!(bend >= 0.0 && bend <= MOST_LEARNED && lean >= 0.0 && lean <= MOST_LEARNED)
            || (predicts != 0.0 && predicts != 1.0))
            return "has a contraction that no run comes to; save it again";
    }
    for (uint32_t k = 0; k < f->header->n_variables; k++) {
        const hm_variable *v = f->variable + k;
        if (v->kind == KIND_OPTION && hm_objects(&i->message, f, v, block[v->place], NULL, 0))
            return "has a setting that is not allowed; save it again";
    }
    return NULL;
}

/* Refuses the block of a state in motion that deforms a rigid part, as no run does: its steps, none
   of which can be solved, would take thousands of iterations. */
static int32_t refuse_deformed(holonom_instance *i, const void *block)
{
    const holonom_model *m = &i->file.model;
    const int32_t n_rigid = first_function_row(m);
    double *scale = i->numbers + m->row_scale_at, most = FARTHEST_OFF;
    int32_t worst = -1;
    put_all_aside(i);
    memcpy(i->state, block, sizeof(double) * (size_t)i->state_size);
    evaluate(i);
    holonom_rows(i, i->phi, i->rate);
    for (int32_t row = 0; row < n_rigid; row++) {
        const double off = fabs(i->phi[row]) / scale[row];
        if (!(off <= most)) most = off, worst = row;
    }
    take_all_back(i);
    if (worst < 0) return HOLONOM_DONE;
    return answer(i, HOLONOM_REFUSED,
                  "the saved state does not fit %s, by %3g of its size; save it again",
                  text_of(i, i->file.row[worst].name), most);
}

int32_t holonom_check_saved(holonom_instance *i, const void *bytes, int64_t length)
{
    saved_state head;
    const char *block = (const char *)bytes + sizeof head;
    if (length < (int64_t)sizeof head || memcmp(bytes, SAVED, sizeof SAVED))
        return refuse_state(i, "is not one of this format; save it again with this FMU");
    memcpy(&head, bytes, sizeof head);
    if (memcmp(head.fingerprint, i->file.header->fingerprint, sizeof head.fingerprint))
        return refuse_state(i,
                            "belongs to another model or version; restore it where it was saved");
    if (length != holonom_saved_size(i) || head.length != i->state_size)
        return answer(i, HOLONOM_REFUSED,
                      "the saved state is %d bytes long, not what its header says", (int)length);
    if (head.checksum != checksum_of(head, block) || head.phase < HOLONOM_CONFIGURED
        || head.phase > HOLONOM_MOVING)
        return refuse_state(i, "is damaged: its checksum does not fit; save it again");
    memcpy(i->before, block, sizeof(double) * (size_t)i->state_size);
    const char *flaw = flaw_of_block(i, i->before);
    if (flaw) return refuse_state(i, flaw);
    return head.phase == HOLONOM_CONFIGURED ? HOLONOM_DONE : refuse_deformed(i, block);
}

int32_t holonom_return_to(holonom_instance *i, const void *bytes)
{
    saved_state head;
    memcpy(&head, bytes, sizeof head);
    if (memcmp(head.magic, SAVED, sizeof SAVED) || head.length != i->state_size ||
        memcmp(head.fingerprint, i->file.header->fingerprint, sizeof head.fingerprint))
        return refuse_state(i,
                            "belongs to another model or version; restore it where it was saved");
    memcpy(i->state, (const char *)bytes + sizeof head, sizeof(double) * (size_t)i->state_size);
    i->phase = (int32_t)head.phase;
    i->measured = 0;
    /* Numbers are no part of the state: those that depend on parameters, inputs and the time are
       computed again. */
    if (i->phase != HOLONOM_CONFIGURED) evaluate(i);
    return HOLONOM_DONE;
}

int32_t holonom_restore(holonom_instance *i, const void *bytes, int64_t length)
{
    const int32_t result = holonom_check_saved(i, bytes, length);
    return result ? result : holonom_return_to(i, bytes);
}

void holonom_rows(holonom_instance *i, double *phi, double *rate)
{
    holonom_residuals(&i->file.model, i->numbers, i->state, i->work, phi, rate);
}

int32_t holonom_phase_of(const holonom_instance *i) { return i->phase; }
const hm_model_file *holonom_file_of(const holonom_instance *i) { return &i->file; }
const holonom_model *holonom_model_of(const holonom_instance *i) { return &i->file.model; }
double *holonom_numbers_of(holonom_instance *i) { return i->numbers; }
double *holonom_state_of(holonom_instance *i) { return i->state; }
double *holonom_work_of(holonom_instance *i) { return i->work; }

#include "small.h"
