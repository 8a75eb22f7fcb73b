#include "small.h"

#include "slave.h"

#include "fp_environment.h"
#include "internal.h"
#include "resources.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { INSTANTIATED, INITIALIZING, STEPPING, TERMINATED };
enum { ASSEMBLY_FAILED = 101, STEP_REFUSED = 103 }; /* fmu_src/status.py has them all */

enum { ROOM = 4096, ROOM_PER_ROW = 512, MOST_ROWS = 500 };
enum { MANY = 3 }; /* failures in a row at the same time after which it is said what else to change */
static const double ROUNDING = 8.0, STOP_SLACK = 1e-3; /* a step may end after the stop time by so many last digits of it and this part
                                                          of the step: communication points are often sums */

const char *const slave_categories[N_CATEGORIES] = {"logAll", "logStatusWarning", "logStatusDiscard", "logStatusError"};

static double *head_of(const slave *s) { return holonom_state_of(s->instance); }

/* ------------------------------------------------------------------------------------------------------------ log */

/* Writes each % twice: the text is a format of printf, and hosts in other languages can read no arguments. */
static void double_percents(hm_text *t)
{
    size_t count = 0;
    for (const char *c = t->begin; *c; c++) count += *c == '%';
    if (t->used + count >= t->room) hm_take_back(t, t->room - 1 - count);
    char *to = t->begin + t->used + count;
    for (const char *from = t->begin + t->used; from >= t->begin; from--) {
        *to-- = *from;
        if (*from == '%') *to-- = '%';
        if (to < from) break;
    }
}

/* Length of what is behind the first "; " of a line of so many bytes: its remedy. */
static size_t remedy_of(const char *line, size_t length, const char **remedy)
{
    for (size_t k = 0; k + 1 < length; k++)
        if (line[k] == ';' && line[k + 1] == ' ') {
            *remedy = line + k + 2;
            return length - k - 2;
        }
    *remedy = line + length;
    return 0;
}

static int is_said_later(const char *rest, const char *remedy, size_t length)
{
    while (*rest) {
        const size_t own = strcspn(rest, "\n");
        const char *other;
        if (remedy_of(rest, own, &other) == length && !memcmp(other, remedy, length)) return 1;
        rest += own + (rest[own] == '\n');
    }
    return 0;
}

/* Says sentences of one line each in one line; a remedy of several is said once, behind the last of them. */
static void say_in_one_line(hm_text *t, const char *lines)
{
    for (const char *line = lines, *next; *line; line = next) {
        size_t length = strcspn(line, "\n");
        const char *remedy;
        next = line + length + (line[length] == '\n');
        const size_t own = remedy_of(line, length, &remedy);
        if (own && is_said_later(next, remedy, own)) length -= own + 2;
        for (size_t k = 0; k < length; k += 255) {
            char part[256];
            const size_t count = length - k < 255 ? length - k : 255;
            memcpy(part, line + k, count);
            part[count] = 0;
            hm_say(t, "%s", part);
        }
        if (*next) hm_say(t, "; ");
    }
}

static slave_answer tell(slave *s, slave_answer level)
{
    if (s->log.logger && s->log.wanted >> level & 1) {
        if (s->log.is_format) double_percents(&s->text);
        s->log.say_line(s, level, s->text.begin);
    }
    return level;
}

slave_answer slave_tell(slave *s, slave_answer level, const char *format, ...)
{
    va_list values;
    hm_clear(&s->text);
    va_start(values, format);
    hm_say_all(&s->text, format, values);
    va_end(values);
    return tell(s, level);
}

/* Tells the sentences of the core's last refusal. */
static slave_answer tell_message(slave *s, slave_answer level)
{
    hm_clear(&s->text);
    say_in_one_line(&s->text, holonom_message(s->instance));
    return tell(s, level);
}

/* Tells what the core has noticed; returns whether it has refused nothing. */
static int hears(slave *s, int32_t result)
{
    if (result & HOLONOM_REMARKED)
        for (const char *line = holonom_remarks(s->instance); *line;) {
            const size_t length = strcspn(line, "\n");
            hm_clear(&s->text);
            for (size_t k = 0; k < length; k++) hm_say(&s->text, "%s", (char[]){line[k], 0});
            tell(s, ANSWER_WARNING);
            line += length + (line[length] == '\n');
        }
    return !(result & ~HOLONOM_REMARKED);
}

slave_answer slave_switch_log(slave *s, int32_t on, size_t count, const char *const *category)
{
    int32_t chosen = count ? 0 : DEBUGGING;
    for (size_t k = 0; k < count; k++) {
        int level = 0;
        while (level < N_CATEGORIES && !(category && category[k] && !strcmp(category[k], slave_categories[level]))) level++;
        if (level == N_CATEGORIES)
            return slave_tell(s, ANSWER_ERROR, "setDebugLogging: no category of the log is named %s; there are %s, %s, %s, %s",
                           category && category[k] ? category[k] : "NULL", slave_categories[0], slave_categories[1], slave_categories[2],
                           slave_categories[3]);
        chosen |= level ? 1 << level : DEBUGGING;
    }
    s->log.wanted = on ? s->log.wanted | chosen : s->log.wanted & ~chosen;
    return ANSWER_OK;
}

/* ----------------------------------------------------------------------------------------------------------- life */

static int is_utf8(const char *text)
{
    for (const unsigned char *c = (const unsigned char *)text; *c;) {
        const int more = *c < 0x80 ? 0 : *c >= 0xc2 && *c < 0xe0 ? 1 : *c >= 0xe0 && *c < 0xf0 ? 2 : *c >= 0xf0 && *c < 0xf5 ? 3 : -1;
        if (more < 0) return 0;
        for (int k = 1; k <= more; k++)
            if ((c[k] & 0xc0) != 0x80) return 0;
        c += more + 1;
    }
    return 1;
}

static int32_t index_of(const slave *s, const char *name)
{
    for (uint32_t k = 0; k < s->file->header->n_variables; k++)
        if (!strcmp(s->file->text + s->file->variable[k].name, name)) return (int32_t)k;
    return -1;
}

/* Memory of a slave of a model: itself, its text, then the instance, 16-aligned. */
static slave *lay_out(const hm_bytes *model, size_t size)
{
    const hm_header *h = model->begin;
    const size_t rows = (size_t)h->n_rows + h->n_rules, room = ROOM + ROOM_PER_ROW * (rows < MOST_ROWS ? rows : MOST_ROWS);
    slave *s = calloc(1, sizeof *s + room + 16 + size);
    if (!s) return NULL;
    char *behind = (char *)(s + 1);
    s->text = (hm_text){behind, room, 0};
    behind += room;
    s->instance = holonom_make(model->begin, behind + (-(uintptr_t)behind & 15), 1);
    s->file = holonom_file_of(s->instance);
    return s;
}

/* Why there is no slave of these arguments, and if there is one, it. */
static slave *made(const char *name, const char *guid, const char *resources, int32_t is_uri, hm_text *why)
{
    if (!name || !*name || !is_utf8(name)) {
        hm_say(why, "instantiate: the name of an instance must %s", name && *name ? "be UTF-8" : "not be empty");
        return NULL;
    }
    const hm_bytes model = hm_model_bytes(resources, is_uri, why);
    if (!model.begin) return NULL;
    const int64_t size = holonom_instance_size(model.begin, model.length, why->begin, (int64_t)why->room);
    const char *own = ((const hm_header *)model.begin)->guid;
    slave *s = NULL;
    if (size && strcmp(guid ? guid : "", own))
        hm_say(why, "instantiate: the GUID %s is not that of this FMU, %s", guid ? guid : "NULL", own);
    else if (size && !(s = lay_out(&model, (size_t)size)))
        hm_say(why, "instantiate: there is no memory for %d bytes", (int)size);
    if (!s && model.is_owned) free((void *)(uintptr_t)model.begin);
    if (s && model.is_owned) s->model = model.begin;
    return s;
}

slave *slave_make(const char *name, const char *guid, const char *resources, int32_t is_uri, slave_log log)
{
    char reason[ROOM];
    slave early = {.log = log, .text = {reason, sizeof reason, 0}};
    const fp_environment host = fp_enter();
    hm_clear(&early.text);
    slave *s = made(name, guid, resources, is_uri, &early.text);
    hm_text short_name = {s ? s->name : early.name, sizeof early.name, 0};
    hm_clear(&short_name);
    if (name && is_utf8(name)) hm_say(&short_name, "%s", name);
    if (s) {
        s->log = log;
        s->own_horizon = head_of(s)[S_HORIZON];
        s->status_index = index_of(s, "solver.status");
        slave_reset(s);
    } else tell(&early, ANSWER_ERROR);
    fp_leave(host);
    return s;
}

void slave_free(slave *s)
{
    if (!s) return;
    free((void *)(uintptr_t)s->model);
    free(s);
}

slave_answer slave_reset(slave *s)
{
    holonom_reset(s->instance);
    s->memory = (slave_memory){INSTANTIATED, 0, 0, 0, head_of(s)[S_TIME]};
    s->latest = INFINITY;
    s->n_failures = 0;
    return ANSWER_OK;
}

/* ---------------------------------------------------------------------------------------------------- initialization */

static void take_tolerance(slave *s, double tolerance)
{
    const int32_t index = index_of(s, "solver.tolerance");
    const char *reason = tolerance > 0.0 ? "this run has fixed steps, set by solver.step_size and solver.order" : "it must be > 0";
    if (head_of(s)[S_TOLERANCE] != 0.0 && tolerance > 0.0 && index >= 0) {
        if (hears(s, holonom_set(s->instance, &index, 1, &tolerance, NULL))) return;
        reason = holonom_message(s->instance);
    }
    slave_tell(s, ANSWER_OK, "tolerance %r has no effect: %s", tolerance, reason);
}

slave_answer slave_set_up(slave *s, double start, const double *stop, const double *tolerance)
{
    if (s->memory.phase != INSTANTIATED)
        return slave_tell(s, ANSWER_ERROR, "setupExperiment was ignored: it belongs before the initialization mode");
    if (!(fabs(start) < INFINITY))
        return slave_tell(s, ANSWER_ERROR, "setupExperiment: the start time must be a finite number, got %r s", start);
    if (stop && !(*stop >= start))
        return slave_tell(s, ANSWER_ERROR, "setupExperiment: the stop time must not be before the start time %r s, got %r s", start, *stop);
    const double last = stop ? fmax(fabs(*stop), fabs(start)) : 0.0, length = stop ? *stop - start : 0.0;
    s->memory.start_time = start;
    s->memory.is_assembled = 0;
    s->latest = stop ? *stop + ROUNDING * (nextafter(last, INFINITY) - last) : INFINITY;
    head_of(s)[S_HORIZON] = length > 0.0 && length < INFINITY ? length : s->own_horizon;
    if (tolerance) take_tolerance(s, *tolerance);
    return ANSWER_OK;
}

slave_answer slave_begin_initialization(slave *s)
{
    if (s->memory.phase != INSTANTIATED)
        return slave_tell(s, ANSWER_ERROR, "enterInitializationMode was ignored: reset the instance first");
    s->memory.phase = INITIALIZING;
    return ANSWER_OK;
}

static slave_answer assemble(slave *s)
{
    head_of(s)[S_TIME] = s->memory.start_time;
    s->memory.is_assembled = hears(s, holonom_assemble(s->instance));
    s->memory.status = s->memory.is_assembled ? 0 : ASSEMBLY_FAILED;
    return s->memory.is_assembled ? ANSWER_OK : tell_message(s, ANSWER_ERROR);
}

slave_answer slave_end_initialization(slave *s)
{
    if (s->memory.phase != INITIALIZING)
        return slave_tell(s, ANSWER_ERROR, "exitInitializationMode was ignored: enterInitializationMode comes first");
    const fp_environment host = fp_enter();
    const slave_answer answer = assemble(s);
    fp_leave(host);
    if (answer) return answer;
    holonom_begin(s->instance);
    s->memory.phase = STEPPING;
    return ANSWER_OK;
}

slave_answer slave_terminate(slave *s)
{
    if (s->memory.phase != STEPPING)
        return slave_tell(s, ANSWER_ERROR, "terminate was ignored: %s",
                       s->memory.phase == TERMINATED ? "it was already called" : "exitInitializationMode comes first");
    s->memory.phase = TERMINATED;
    return ANSWER_OK;
}

/* ---------------------------------------------------------------------------------------------------------- steps */

double slave_last_time(const slave *s) { return s->memory.phase < STEPPING ? s->memory.start_time : head_of(s)[S_TIME]; }

/* Counts a failed step, and says behind its reason, from the third one at the same time on, what to change. */
static void say_remedy(slave *s, double t, double step)
{
    if (!s->n_failures || t != s->failed_at) s->n_failures = 0, s->shortest = s->longest = step;
    s->failed_at = t;
    s->shortest = fmin(s->shortest, step);
    s->longest = fmax(s->longest, step);
    if (++s->n_failures < MANY) return;
    hm_say(&s->text, "; %d steps in a row failed at this time, ", s->n_failures);
    if (s->shortest == s->longest) hm_say(&s->text, "all of %6g s: take a smaller communication step", step);
    else
        hm_say(&s->text, "from %6g to %6g s: shorter communication steps alone do not help", s->longest, s->shortest);
    hm_say(&s->text, ", set solver.step_size below %6g s, and look for very small masses, very stiff springs, dampers or forces "
           "that jump, and lengths that cannot be closed at this time", fmin(head_of(s)[S_STEP_SIZE], s->shortest));
}

static slave_answer refuse_step(slave *s, double t, double step)
{
    s->memory.status = STEP_REFUSED;
    return slave_tell(s, ANSWER_DISCARD, "step from t = %r s with size %r s: %s", t, step,
                   step > 0.0 ? "it ends after the stop time given to setupExperiment; take a shorter step or define no stop time"
                              : "the size must be > 0 s");
}

static slave_answer try_step(slave *s, double t, double step)
{
    const int32_t result = holonom_move(s->instance, t, step);
    if (hears(s, result)) {
        s->memory.status = s->n_failures = 0;
        return ANSWER_OK;
    }
    const int is_failure = (result & ~HOLONOM_REMARKED) == HOLONOM_FAILED;
    s->memory.status = is_failure ? 0 : STEP_REFUSED; /* of a failure the core knows more */
    hm_clear(&s->text);
    say_in_one_line(&s->text, holonom_message(s->instance));
    if (is_failure) say_remedy(s, t, step);
    return tell(s, ANSWER_DISCARD);
}

slave_answer slave_step(slave *s, double t, double step)
{
    if (s->memory.phase != STEPPING) {
        s->memory.status = STEP_REFUSED;
        return slave_tell(s, ANSWER_ERROR, "doStep was called %s; it belongs between them",
                       s->memory.phase == TERMINATED ? "after terminate" : "before the initialization");
    }
    if (!(step > 0.0) || !(t + (1.0 - STOP_SLACK) * step <= s->latest)) return refuse_step(s, t, step);
    const fp_environment host = fp_enter();
    const slave_answer answer = try_step(s, t, step);
    fp_leave(host);
    return answer;
}

/* --------------------------------------------------------------------------------------------------------- values */

static const hm_variable *variable(const slave *s, uint32_t index) { return s->file->variable + index; }

static slave_answer check_type(slave *s, int32_t type, const uint32_t *index, size_t count)
{
    if (count && !index) return slave_tell(s, ANSWER_ERROR, "no value references are given");
    for (size_t k = 0; k < count; k++)
        if (index[k] >= s->file->header->n_variables || variable(s, index[k])->type != type) {
            static const char *const names[] = {"Real", "Boolean", "String", "Integer"};
            return slave_tell(s, ANSWER_ERROR, "value references [%d] are not those of %s variables", (int)index[k], names[type]);
        }
    return ANSWER_OK;
}

/* Whether only parameters, inputs and settings are asked for, which need no assembled mechanism. */
static int are_settable(const slave *s, const uint32_t *index, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (variable(s, index[k])->causality > CAUSALITY_INPUT) return 0;
    return 1;
}

slave_answer slave_get(slave *s, int32_t type, const uint32_t *index, size_t count, double *value)
{
    slave_answer answer = check_type(s, type, index, count);
    if (answer || !count) return answer;
    if (!value) return slave_tell(s, ANSWER_ERROR, "there is no place for values");
    const fp_environment host = fp_enter();
    if (!s->memory.is_assembled && !are_settable(s, index, count)) answer = assemble(s);
    if (!answer && !hears(s, holonom_get(s->instance, (const int32_t *)index, (int32_t)count, value)))
        answer = tell_message(s, ANSWER_ERROR);
    fp_leave(host);
    if (s->memory.status && !answer)
        for (size_t k = 0; k < count; k++)
            if ((int32_t)index[k] == s->status_index) value[k] = s->memory.status;
    return answer;
}

/* Says in one refusal which of the variables are fixed. */
static slave_answer check_phase(slave *s, const uint32_t *index, size_t count)
{
    if (s->memory.phase == TERMINATED)
        return slave_tell(s, ANSWER_ERROR, "no value can be set after terminate; reset the instance first");
    if (s->memory.phase != STEPPING) return ANSWER_OK;
    hm_clear(&s->text);
    for (size_t k = 0; k < count; k++) {
        const hm_variable *v = variable(s, index[k]);
        if (v->causality <= CAUSALITY_INPUT && v->variability == VARIABILITY_FIXED)
            hm_say(&s->text, "%s%s", s->text.used ? ", " : "", s->file->text + v->name);
    }
    if (!s->text.used) return ANSWER_OK;
    hm_say(&s->text, ": a fixed parameter cannot be set after the initialization; reset first");
    return tell(s, ANSWER_ERROR);
}

slave_answer slave_set(slave *s, int32_t type, const uint32_t *index, size_t count, const double *value, const char *const *shown)
{
    slave_answer answer = check_type(s, type, index, count);
    if (answer || !count) return answer;
    if (!value) return slave_tell(s, ANSWER_ERROR, "no values are given");
    answer = check_phase(s, index, count);
    if (answer) return answer;
    const fp_environment host = fp_enter();
    if (!hears(s, holonom_set(s->instance, (const int32_t *)index, (int32_t)count, value, shown))) answer = tell_message(s, ANSWER_ERROR);
    else if (s->memory.phase < STEPPING) s->memory.is_assembled = 0;
    fp_leave(host);
    return answer;
}

/* Words and truths are set all or none, from memory for so many. */
static slave_answer check_words(slave *s, int32_t type, const uint32_t *index, size_t count, const void *value)
{
    if (count > MOST_WORDS) return slave_tell(s, ANSWER_ERROR, "%d values are set at once, at most %d can be", (int)count, MOST_WORDS);
    if (count && !value) return slave_tell(s, ANSWER_ERROR, "no values are given");
    return check_type(s, type, index, count);
}

slave_answer slave_get_word(slave *s, uint32_t index, const char **word)
{
    double value = 0.0;
    const slave_answer answer = slave_get(s, TYPE_STRING, &index, 1, &value);
    *word = answer ? "" : holonom_word(s->instance, (int32_t)index, value);
    return answer;
}

/* Says a word in quotation marks, as Python does. */
static void say_quoted(hm_text *t, const char *word)
{
    const char *mark = strchr(word, '\'') && !strchr(word, '"') ? "\"" : "'";
    hm_say(t, "%s", mark);
    for (; *word; word++) {
        const char digits[] = "0123456789abcdef", plain[] = {*word, 0};
        const unsigned char c = (unsigned char)*word;
        const char hex[] = {'\\', 'x', digits[c >> 4], digits[c & 15], 0};
        const char *name = c == '\n' ? "\\n" : c == '\r' ? "\\r" : c == '\t' ? "\\t" : c == '\\' ? "\\\\" : NULL;
        if (!name && (c == (unsigned char)*mark)) name = "\\'";
        hm_say(t, "%s", name ? name : c < 32 || c == 127 ? hex : plain);
    }
    hm_say(t, "%s", mark);
}

slave_answer slave_set_words(slave *s, const uint32_t *index, size_t count, const char *const *word)
{
    char memory[ROOM];
    double value[MOST_WORDS];
    const char *shown[MOST_WORDS];
    hm_text quoted = {memory, sizeof memory, 0};
    slave_answer answer = check_words(s, TYPE_STRING, index, count, word);
    if (answer || !count) return answer;
    hm_clear(&quoted);
    for (size_t k = 0; k < count; k++) {
        if (!word[k] || !is_utf8(word[k]))
            return slave_tell(s, ANSWER_ERROR, "a String must be a text in UTF-8, got %s", word[k] ? "other bytes" : "NULL");
        value[k] = holonom_number_of_word(s->instance, (int32_t)index[k], word[k]);
        shown[k] = memory + quoted.used;
        say_quoted(&quoted, word[k]);
        quoted.used += quoted.used + 1 < quoted.room; /* the next one begins behind its end */
    }
    return slave_set(s, TYPE_STRING, index, count, value, shown);
}

slave_answer slave_get_truth(slave *s, uint32_t index, int32_t *truth)
{
    double value = 0.0;
    const slave_answer answer = slave_get(s, TYPE_BOOLEAN, &index, 1, &value);
    *truth = value != 0.0;
    return answer;
}

slave_answer slave_set_truths(slave *s, const uint32_t *index, size_t count, const double *truth)
{
    const char *shown[MOST_WORDS];
    slave_answer answer = check_words(s, TYPE_BOOLEAN, index, count, truth);
    for (size_t k = 0; k < count && !answer; k++) shown[k] = truth[k] != 0.0 ? "True" : "False";
    return answer || !count ? answer : slave_set(s, TYPE_BOOLEAN, index, count, truth, shown);
}

/* --------------------------------------------------------------------------------------------------------- states */

/* A state in memory, and as bytes: this, then what the core saves. */
struct slave_kept {
    char magic[8];
    uint32_t checksum, unused; /* of what follows in this structure; 0 in memory */
    uint64_t size;             /* of all                                         */
    slave_memory memory;
};

static const char KEPT[8] = "holslv1"; /* the digit is the version of the format */

static uint32_t checksum_of(const slave_kept *kept)
{
    const size_t begin = offsetof(slave_kept, size);
    return hm_checksum(0, (const char *)kept + begin, sizeof *kept - begin);
}

static size_t size_of(const slave *s) { return sizeof(slave_kept) + (size_t)holonom_saved_size(s->instance); }

size_t slave_size_of_kept(const slave_kept *kept) { return (size_t)kept->size; }

slave_answer slave_keep(slave *s, slave_kept **kept)
{
    const size_t size = size_of(s);
    if (*kept && (*kept)->size != size) return slave_tell(s, ANSWER_ERROR, "the state to be overwritten is one of another FMU");
    if (!*kept && !(*kept = malloc(size))) return slave_tell(s, ANSWER_ERROR, "there is no memory for a state of %d bytes", (int)size);
    memset(*kept, 0, sizeof **kept);
    memcpy((*kept)->magic, KEPT, sizeof KEPT);
    (*kept)->size = size;
    (*kept)->memory = s->memory;
    holonom_keep(s->instance, *kept + 1);
    return ANSWER_OK;
}

slave_answer slave_return_to(slave *s, const slave_kept *kept)
{
    const fp_environment host = fp_enter();
    const int is_own = kept && kept->size == size_of(s) && hears(s, holonom_return_to(s->instance, kept + 1));
    if (is_own) s->memory = kept->memory;
    fp_leave(host);
    return is_own ? ANSWER_OK : slave_tell(s, ANSWER_ERROR, "the saved state belongs to another model; restore it where it was saved");
}

void slave_free_kept(slave_kept *kept) { free(kept); }

slave_answer slave_bytes_of(slave *s, const slave_kept *kept, void *bytes, size_t size)
{
    if (!kept || !bytes || size < kept->size)
        return slave_tell(s, ANSWER_ERROR, "a state needs %d bytes, %d are given", kept ? (int)kept->size : 0, (int)size);
    slave_kept *copy = bytes;
    slave_kept head = *kept;
    head.checksum = checksum_of(&head);
    memcpy(copy, kept, (size_t)kept->size);
    memcpy(copy, &head, sizeof head);
    holonom_seal((char *)bytes + sizeof head);
    return ANSWER_OK;
}

slave_answer slave_kept_of(slave *s, const void *bytes, size_t size, slave_kept **kept)
{
    slave_kept head;
    *kept = NULL;
    if (!bytes || size < sizeof head || memcmp(bytes, KEPT, sizeof KEPT))
        return slave_tell(s, ANSWER_ERROR, "the bytes are no FMU state of this version; save the state again with this FMU");
    memcpy(&head, bytes, sizeof head);
    const int is_damaged = head.checksum != checksum_of(&head) || head.size != size || size != size_of(s) ||
                           head.memory.phase < INSTANTIATED || head.memory.phase > TERMINATED || !(fabs(head.memory.start_time) < INFINITY);
    if (is_damaged) return slave_tell(s, ANSWER_ERROR, "the bytes of the FMU state are damaged; save the state again");
    if (!hears(s, holonom_check_saved(s->instance, (const char *)bytes + sizeof head, (int64_t)(size - sizeof head))))
        return tell_message(s, ANSWER_ERROR);
    if (!(*kept = malloc(size))) return slave_tell(s, ANSWER_ERROR, "there is no memory for a state of %d bytes", (int)size);
    memcpy(*kept, bytes, size);
    return ANSWER_OK;
}
