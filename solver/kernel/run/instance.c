/* Memory of an instance, its start and its motion. */
#include "small.h"

#include "instance_parts.h"

#include <string.h>

enum { MESSAGE_ROOM = 4096, ROOM_PER_ROW = 256, MOST_ROWS = 500, REMARK_ROOM = 2048 };
static const double
    LAST_DIGITS = 8.0,
    STEP_SLACK =
        1e-6; /* a step begins at the present time, up to so many last digits and this part of it */

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

hm_text *hm_open_remarks(holonom_instance *i)
{
    if (!i->has_remarks) hm_clear(&i->remarks);
    return &i->remarks;
}

void hm_begin_line(hm_text *text) { hm_say(text, "%s", text->used ? "\n" : ""); }

void hm_put_all_aside(const holonom_instance *i)
{
    memcpy(i->before, i->state, sizeof(double) * (size_t)i->state_size);
    memcpy(i->before + i->state_size, i->numbers, sizeof(double) * (size_t)i->file.model.n_numbers);
}

void hm_take_all_back(const holonom_instance *i)
{
    memcpy(i->state, i->before, sizeof(double) * (size_t)i->state_size);
    memcpy(i->numbers, i->before + i->state_size, sizeof(double) * (size_t)i->file.model.n_numbers);
}

int32_t hm_done(const holonom_instance *i)
{ return i->has_remarks ? HOLONOM_REMARKED : HOLONOM_DONE; }

int32_t hm_answer(holonom_instance *i, int32_t result, const char *format, ...)
{
    va_list values;
    hm_clear(&i->message);
    va_start(values, format);
    hm_say_all(&i->message, format, values);
    va_end(values);
    return result;
}

void hm_evaluate(holonom_instance *i)
{
    const holonom_model *m = &i->file.model;
    memcpy(i->numbers + m->input_at, i->s.inputs, sizeof(double) * (size_t)m->n_inputs);
    memcpy(i->numbers + m->parameter_at, i->s.parameters, sizeof(double) * (size_t)m->n_parameters);
    memcpy(i->numbers + m->held_at, i->s.held, sizeof(double) * (size_t)m->n_held);
    i->numbers[m->time_at] = i->s.head[S_TIME];
    holonom_evaluate(m, i->numbers, 0);
    holonom_evaluate(m, i->numbers, 1);
}

/* --------------------------------------------------------------------------------------- motion */

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
    hm_text *remarks = hm_open_remarks(i);
    for (int what = 0; what < 2; what++) {
        const size_t end = remarks->used;
        hm_begin_line(remarks);
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
    hm_evaluate(i);
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
    return hm_done(i);
}

const char *holonom_steps(holonom_instance *i, int32_t has_explicit)
{
    holonom_methods methods;
    hm_evaluate(i); /* a formula may tell what takes energy out */
    holonom_find_methods(&i->file.model, i->numbers, i->state, i->work, &methods);
    hm_clear(&i->message);
    hm_say_steps(&i->message, &i->file, i->numbers, i->s.head, &methods,
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
    hm_evaluate(i);
    hm_answer(i, HOLONOM_FAILED, "step from t = %6g s with h = %6g s: ", t,
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
        return hm_answer(i, HOLONOM_UNTRIED,
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
    i->said = hm_remark(hm_open_remarks(i), &i->file, i->numbers, &i->s, i->said, i->heard);
    i->has_remarks = i->remarks.used > 0;
    return hm_done(i);
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
