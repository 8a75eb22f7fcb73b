/* The life of a slave and the course of its run. */
#include "small.h"

#include "slave_parts.h"

#include "fp_environment.h"
#include "resources.h"

#include <math.h>
#include <string.h>

/* Failures in a row at the same time after which it is said what else to change. */
enum { MANY = 3 };
static const double STOP_DIGITS = 8.0, STOP_SLACK = 1e-3; /* see ends_too_late */

double *slave_head(const slave *s) { return holonom_state_of(s->instance); }

static int32_t variable_named(const slave *s, const char *name)
{
    for (uint32_t k = 0; k < s->file->header->n_variables; k++)
        if (!strcmp(s->file->text + s->file->variable[k].name, name)) return (int32_t)k + s->first;
    return -1;
}

/* Memory of a slave of a model: itself, its text, then the instance, 16-aligned. */
static slave *make_in_memory(const hm_bytes *model, size_t size)
{
    const hm_header *h = model->begin;
    const size_t rows = (size_t)h->n_rows + h->n_rules, room = slave_text_room(rows);
    slave *s = slave_allocate(sizeof *s + room + 16 + size);
    if (!s) return NULL;
    char *behind = (char *)(s + 1);
    s->text = (hm_text){behind, room, 0};
    behind += room;
    s->instance = holonom_make(model->begin, behind + (-(uintptr_t)behind & 15), 1);
    s->file = holonom_file_of(s->instance);
    return s;
}

/* Why there is no slave of these arguments, and if there is one, it. */
static slave *made(const char *name, const char *guid, const char *resources, int32_t is_uri,
                   hm_text *why)
{
    if (!name || !*name || !slave_is_utf8(name)) {
        hm_say(why, "instantiate: the name of an instance must %s",
               name && *name ? "be UTF-8" : "not be empty");
        return NULL;
    }
    const hm_bytes model = hm_model_bytes(resources, is_uri, why);
    if (!model.begin) return NULL;
    const int64_t size =
        holonom_instance_size(model.begin, model.length, why->begin, (int64_t)why->room);
    const char *own = ((const hm_header *)model.begin)->guid;
    slave *s = NULL;
    if (size && strcmp(guid ? guid : "", own))
        hm_say(why, "instantiate: the GUID %s is not that of this FMU, %s", guid ? guid : "NULL",
               own);
    else if (size && !(s = make_in_memory(&model, (size_t)size)))
        hm_say(why, "instantiate: there is no memory for %d bytes", (int)size);
    if (!s && model.is_owned) slave_release((void *)(uintptr_t)model.begin);
    if (s && model.is_owned) s->model = model.begin;
    return s;
}

slave *slave_make(const char *name, const char *guid, const char *resources, int32_t fmi,
                  slave_log log)
{
    char reason[ROOM];
    slave early = {.log = log, .text = {reason, sizeof reason, 0}};
    const fp_environment host = fp_enter();
    hm_clear(&early.text);
    slave *s = made(name, guid, resources, fmi == 2, &early.text);
    hm_text short_name = {s ? s->name : early.name, sizeof early.name, 0};
    hm_clear(&short_name);
    if (name && slave_is_utf8(name)) hm_say(&short_name, "%s", name);
    if (s) {
        s->log = log;
        s->first = fmi - 2;
        holonom_count_from(s->instance, s->first);
        s->own_horizon = slave_head(s)[S_HORIZON];
        s->status_index = variable_named(s, "solver.status");
        slave_reset(s);
    } else slave_tell_text(&early, ANSWER_ERROR);
    fp_leave(host);
    return s;
}

void slave_free(slave *s)
{
    if (!s) return;
    slave_release((void *)(uintptr_t)s->model);
    slave_release(s);
}

slave_answer slave_reset(slave *s)
{
    holonom_reset(s->instance);
    s->memory = (slave_memory){.phase = INSTANTIATED, .start_time = slave_head(s)[S_TIME]};
    s->stop_time = INFINITY;
    s->last_digit = 0.0;
    s->n_failures = 0;
    return ANSWER_OK;
}

/* --------------------------------------------------------------------------------------- states */

#define AT(phase) (1 << (phase))
#define ALLOWED(call, name, states, early) {name, early, states},
static const struct {
    const char *name, *early;
    int32_t states;
} allowed[] = {
#include "allowed_calls.def"
};
#undef ALLOWED
#undef AT

int slave_allows(const slave *s, slave_call call)
{ return allowed[call].states >> s->memory.phase & 1; }

slave_answer slave_check(slave *s, slave_call call)
{
    static const char *const when[] = {"before the initialization mode",
                                       "in the initialization mode", "after the initialization",
                                       "after terminate", "after an error in doStep"};
    const int32_t phase = s->memory.phase;
    const char *remedy = phase < STEPPING  ? allowed[call].early
                         : phase == FAILED ? "restore a saved state or " RESET_FIRST
                                           : RESET_FIRST;
    return slave_allows(s, call) ? ANSWER_OK
                                 : slave_tell(s, ANSWER_ERROR, "%s is refused %s; %s",
                                              allowed[call].name, when[phase], remedy);
}

/* ------------------------------------------------------------------------------- initialization */

/* A host may ask for less error than the run is set to, and never for more: it often passes a
   tolerance that nobody chose. */
static void take_tolerance(slave *s, double tolerance)
{
    double *head = slave_head(s);
    const double own = hm_tolerance(head);
    if (!(tolerance >= HOLONOM_LEAST_TOLERANCE)) {
        slave_tell(s, ANSWER_OK, "tolerance %r has no effect: it must be >= %6g, some round-off",
                   tolerance, HOLONOM_LEAST_TOLERANCE);
        return;
    }
    head[S_HOST_TOLERANCE] = tolerance;
    if (own == 0.0)
        slave_tell(s, ANSWER_OK,
                   "tolerance %r has no effect: this run has fixed steps, set by solver.step_size "
                   "and solver.order",
                   tolerance);
    else if (tolerance > own)
        slave_tell(s, ANSWER_OK,
                   "tolerance %r has no effect: that of this run is %r, which is tighter",
                   tolerance, own);
}

slave_answer slave_set_up(slave *s, double start, const double *stop, const double *tolerance)
{
    const slave_answer answer =
        slave_check(s, s->first ? CALL_BEGIN_INITIALIZATION : CALL_SET_UP); /* one call in FMI 3 */
    if (answer) return answer;
    if (!(fabs(start) < INFINITY))
        return slave_tell(s, ANSWER_ERROR, "the start time must be a finite number, got %r s",
                          start);
    if (stop && !(*stop >= start))
        return slave_tell(s, ANSWER_ERROR,
                          "the stop time must not be before the start time %r s, got %r s", start,
                          *stop);
    const double last = stop ? fmax(fabs(*stop), fabs(start)) : 0.0,
                 length = stop ? *stop - start : 0.0;
    s->memory.start_time = start;
    s->memory.is_assembled = 0;
    s->stop_time = stop ? *stop : INFINITY;
    s->last_digit = nextafter(last, INFINITY) - last;
    slave_head(s)[S_HORIZON] = length > 0.0 && length < INFINITY ? length : s->own_horizon;
    slave_head(s)[S_HOST_TOLERANCE] = 0.0; /* an experiment takes that of one before back */
    if (tolerance) take_tolerance(s, *tolerance);
    return ANSWER_OK;
}

slave_answer slave_begin_initialization(slave *s)
{
    const slave_answer answer = slave_check(s, CALL_BEGIN_INITIALIZATION);
    if (!answer) s->memory.phase = INITIALIZING;
    return answer;
}

slave_answer slave_assemble(slave *s)
{
    slave_head(s)[S_TIME] = s->memory.start_time;
    holonom_let_look(s->instance, s->look);
    s->memory.is_assembled = slave_hears(s, holonom_assemble(s->instance));
    s->memory.status = s->memory.is_assembled ? 0 : ASSEMBLY_FAILED;
    return s->memory.is_assembled ? ANSWER_OK : slave_tell_message(s, ANSWER_ERROR);
}

slave_answer slave_end_initialization(slave *s)
{
    slave_answer answer = slave_check(s, CALL_END_INITIALIZATION);
    if (answer) return answer;
    const fp_environment host = fp_enter();
    answer = slave_assemble(s);
    fp_leave(host);
    if (answer) return answer;
    holonom_begin(s->instance);
    s->memory.phase = STEPPING;
    return slave_tell(s, ANSWER_OK, "solver: %s", holonom_steps(s->instance, 1));
}

slave_answer slave_terminate(slave *s)
{
    const slave_answer answer = slave_check(s, CALL_TERMINATE);
    if (!answer) s->memory.phase = TERMINATED;
    return answer;
}

/* ---------------------------------------------------------------------------------------- steps */

double slave_last_time(const slave *s)
{ return s->memory.phase < STEPPING ? s->memory.start_time : slave_head(s)[S_TIME]; }

/* Counts a failed step, and says behind its reason, from the third one at the same time on, what to
   change. */
static void say_remedy(slave *s, double t, double step)
{
    if (!s->n_failures || t != s->failed_at) s->n_failures = 0, s->shortest = s->longest = step;
    s->failed_at = t;
    s->shortest = fmin(s->shortest, step);
    s->longest = fmax(s->longest, step);
    if (++s->n_failures < MANY) return;
    hm_say(&s->text, "; %d steps in a row failed at this time, ", s->n_failures);
    if (s->shortest == s->longest)
        hm_say(&s->text, "all of %6g s: take a smaller communication step", step);
    else
        hm_say(&s->text, "from %6g to %6g s: shorter communication steps alone do not help",
               s->longest, s->shortest);
    hm_say(&s->text,
           ", set solver.step_size below %6g s, and look for very small masses, very stiff "
           "springs, dampers or forces "
           "that jump, and lengths that cannot be closed at this time",
           fmin(hm_step_size(slave_head(s)), s->shortest));
}

/* Whether a step ends after the stop time by more than round-off: some last digits, and one for
   each step of this size from the start, as communication points are often sums; never more than a
   part of the step. fmin leaves out the NaN that it may be where there is no stop time. */
static int ends_too_late(const slave *s, double t, double step)
{
    const double additions = (s->stop_time - s->memory.start_time) / step;
    return t + step
           > s->stop_time + fmin(STOP_SLACK * step, (STOP_DIGITS + additions) * s->last_digit);
}

/* Ends the run with what s->text says: the answer to a step that cannot be, however short. Then
   only a saved state or a reset leads back (FMI 2.0.5, 4.2.4, state error; FMI 3.0.1, 2.3.1, state
   Terminated). */
static slave_answer end_by_error(slave *s)
{
    s->memory.status = STEP_REFUSED;
    s->memory.phase = FAILED;
    return slave_tell_text(s, ANSWER_ERROR);
}

static slave_answer refuse_step(slave *s, double t, double step)
{
    hm_clear(&s->text);
    hm_say(&s->text, "step from t = %r s with size %r s: ", t, step);
    if (!(step > 0.0)) hm_say(&s->text, "the size must be > 0 s");
    else if (ends_too_late(s, t, step))
        hm_say(&s->text,
               "it ends after the stop time that the importer gave, %r s; take a shorter step or "
               "define no stop time",
               s->stop_time);
    else
        hm_say(&s->text, "the size must be a finite number");
    return end_by_error(s);
}

static slave_answer move_on(slave *s, double t, double step)
{
    holonom_let_look(s->instance, s->look);
    const int32_t result = holonom_move(s->instance, t, step);
    if (slave_hears(s, result)) {
        s->memory.status = s->n_failures = 0;
        return ANSWER_OK;
    }
    hm_clear(&s->text);
    slave_say_message(s);
    const double *head = slave_head(s);
    const int is_too_short =
        !(t + step > t) || (head[S_STATUS] == HOLONOM_BAD_STEP && step < hm_step_size(head));
    if ((result & ~HOLONOM_REMARKED) != HOLONOM_FAILED || is_too_short) return end_by_error(s);
    s->memory.status = 0; /* the core knows more */
    say_remedy(s, t, step);
    return slave_tell_text(s, ANSWER_DISCARD);
}

slave_answer slave_step(slave *s, double t, double step)
{
    slave_answer answer = slave_check(s, CALL_STEP);
    if (answer) {
        s->memory.status = STEP_REFUSED;
        return answer;
    }
    if (!(step > 0.0 && step < INFINITY) || ends_too_late(s, t, step))
        return refuse_step(s, t, step);
    const fp_environment host = fp_enter();
    answer = move_on(s, t, step);
    fp_leave(host);
    return answer;
}

#include "small.h"
