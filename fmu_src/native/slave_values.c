/* Values of a slave: numbers, words and truths, all of a call or none. */
#include "small.h"

#include "slave_parts.h"

#include "fp_environment.h"

#include <math.h>
#include <string.h>

int slave_is_utf8(const char *text)
{
    for (const unsigned char *c = (const unsigned char *)text; *c;) {
        const int more = *c < 0x80                 ? 0
                         : *c >= 0xc2 && *c < 0xe0 ? 1
                         : *c >= 0xe0 && *c < 0xf0 ? 2
                         : *c >= 0xf0 && *c < 0xf5 ? 3
                                                   : -1;
        if (more < 0) return 0;
        for (int k = 1; k <= more; k++)
            if ((c[k] & 0xc0) != 0x80) return 0;
        c += more + 1;
    }
    return 1;
}

static const hm_variable *variable(const slave *s, uint32_t index)
{ return holonom_variable_at(s->instance, (int32_t)index); }

static slave_answer check_type(slave *s, int32_t type, const uint32_t *index, size_t count)
{
    static const char *const names[] = {"Real", "Boolean", "String"};
    if (count && !index) return slave_tell(s, ANSWER_ERROR, "no value references are given");
    hm_clear(&s->text);
    for (size_t k = 0; k < count; k++) {
        const hm_variable *v = variable(s, index[k]);
        if (!v || v->type != type)
            hm_say(&s->text, "%s%d", s->text.used ? ", " : "value references [", (int)index[k]);
    }
    if (!s->text.used) return ANSWER_OK;
    hm_say(&s->text, "] are not those of %s variables", names[type]);
    return slave_tell_text(s, ANSWER_ERROR);
}

/* Whether only parameters, inputs and settings are asked for, which need no assembled mechanism. */
static int are_settable(const slave *s, const uint32_t *index, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (variable(s, index[k])->causality > CAUSALITY_INPUT) return 0;
    return 1;
}

/* Reads each value by itself, where they cannot be read together: what cannot be read is 0, so that
   no importer takes something else for a value, and named if it is not finite. */
static void get_each(slave *s, int32_t type, const uint32_t *index, size_t count, double *value)
{
    for (size_t k = 0; k < count; k++) {
        const hm_variable *v = variable(s, index[k]);
        value[k] = 0.0;
        if (!v || v->type != type || !(s->memory.is_assembled || are_settable(s, index + k, 1)))
            continue;
        if (slave_hears(s, holonom_get(s->instance, (const int32_t *)index + k, 1, value + k)))
            continue;
        value[k] = 0.0;
        if (!s->memory.status) s->memory.status = NOT_FINITE;
        slave_tell_message(s, ANSWER_ERROR);
    }
}

slave_answer slave_get(slave *s, int32_t type, const uint32_t *index, size_t count, double *value)
{
    if (!count) return ANSWER_OK;
    if (!value) return slave_tell(s, ANSWER_ERROR, "there is no place for values");
    slave_answer answer = check_type(s, type, index, count);
    if (!index) return answer;
    const fp_environment host = fp_enter();
    if (!answer && !s->memory.is_assembled && !are_settable(s, index, count))
        answer = slave_assemble(s);
    if (!answer
        && !slave_hears(s, holonom_get(s->instance, (const int32_t *)index, (int32_t)count, value)))
        answer = ANSWER_ERROR;
    if (answer) get_each(s, type, index, count, value);
    fp_leave(host);
    const int32_t code = s->memory.refusal ? s->memory.refusal : s->memory.status;
    for (size_t k = 0; code && k < count; k++)
        if ((int32_t)index[k] == s->status_index && type == TYPE_REAL) value[k] = code;
    return answer;
}

slave_answer slave_get_derivatives(slave *s, const uint32_t *index, size_t count,
                                   const int32_t *order, double *value)
{
    slave_answer answer = check_type(s, TYPE_REAL, index, count);
    if (answer || !count) return answer;
    if (!order || !value)
        return slave_tell(s, ANSWER_ERROR,
                          "the orders of derivatives or the place for these are missing");
    for (size_t k = 0; k < count; k++)
        if (order[k] != 1)
            return slave_tell(s, ANSWER_ERROR,
                              "outputs have derivatives of order 1, not of order %d",
                              (int)order[k]);
    if ((answer = slave_check(s, CALL_GET_DERIVATIVES))) return answer;
    const fp_environment host = fp_enter();
    if (!slave_hears(s,
                     holonom_get_rates(s->instance, (const int32_t *)index, (int32_t)count, value)))
        answer = slave_tell_message(s, ANSWER_ERROR);
    fp_leave(host);
    return answer;
}

/* Says in one refusal which of the variables are fixed. */
static slave_answer check_settable(slave *s, const uint32_t *index, size_t count)
{
    const slave_answer answer = slave_check(s, CALL_SET);
    if (answer || slave_allows(s, CALL_SET_FIXED)) return answer;
    hm_clear(&s->text);
    for (size_t k = 0; k < count; k++) {
        const hm_variable *v = variable(s, index[k]);
        if (v->causality <= CAUSALITY_INPUT && v->variability == VARIABILITY_FIXED)
            hm_say(&s->text, "%s%s", s->text.used ? ", " : "", s->file->text + v->name);
    }
    if (!s->text.used) return ANSWER_OK;
    hm_say(&s->text, ": a fixed parameter cannot be set after the initialization; reset first");
    return slave_tell_text(s, ANSWER_ERROR);
}

slave_answer slave_set(slave *s, int32_t type, const uint32_t *index, size_t count,
                       const double *value, const char *const *shown)
{
    slave_answer answer = check_type(s, type, index, count);
    if (answer || !count) return answer;
    if (!value) return slave_tell(s, ANSWER_ERROR, "no values are given");
    answer = check_settable(s, index, count);
    if (answer) return answer;
    const fp_environment host = fp_enter();
    if (!slave_hears(
            s, holonom_set(s->instance, (const int32_t *)index, (int32_t)count, value, shown)))
        answer = slave_tell_message(s, ANSWER_ERROR);
    else if (s->memory.phase < STEPPING) s->memory.is_assembled = 0;
    fp_leave(host);
    return answer;
}

/* Words and truths are set all or none, from memory for so many. */
static slave_answer check_words(slave *s, int32_t type, const uint32_t *index, size_t count,
                                const void *value)
{
    if (count > MOST_WORDS)
        return slave_tell(s, ANSWER_ERROR, "%d values are set at once, at most %d can be",
                          (int)count, MOST_WORDS);
    if (count && !value) return slave_tell(s, ANSWER_ERROR, "no values are given");
    return check_type(s, type, index, count);
}

slave_answer slave_get_words(slave *s, const uint32_t *index, size_t count, const char **word)
{
    slave_answer worst = ANSWER_OK;
    if (count && !(index && word))
        return slave_tell(s, ANSWER_ERROR, "value references or the place for values are missing");
    for (size_t k = 0; k < count; k++) {
        double value = 0.0;
        const slave_answer answer = slave_get(s, TYPE_STRING, index + k, 1, &value);
        word[k] = answer ? "" : holonom_word(s->instance, (int32_t)index[k], value);
        if (answer) worst = answer;
    }
    return worst;
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
        const char *name = c == '\n'   ? "\\n"
                           : c == '\r' ? "\\r"
                           : c == '\t' ? "\\t"
                           : c == '\\' ? "\\\\"
                                       : NULL;
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
        if (!word[k] || !slave_is_utf8(word[k]))
            return slave_tell(s, ANSWER_ERROR, "a String must be a text in UTF-8, got %s",
                              word[k] ? "other bytes" : "NULL");
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

#include "small.h"
