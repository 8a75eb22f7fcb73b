/* What a slave says: sentences of one line each, by the categories that the importer wants. */
#include "small.h"

#include "slave_parts.h"

#include <string.h>

/* Writes each % twice: the text is a format of printf, and hosts in other languages can read no
   arguments. */
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

/* Says sentences of one line each in one line; a remedy of several is said once, behind the last of
   them. */
static void say_in_one_line(hm_text *t, const char *lines)
{
    for (const char *line = lines, *next; *line; line = next) {
        size_t length = strcspn(line, "\n");
        const char *remedy;
        next = line + length + (line[length] == '\n');
        const size_t own = remedy_of(line, length, &remedy);
        if (own && is_said_later(next, remedy, own)) length -= own + 2;
        hm_say_part(t, line, length);
        if (*next) hm_say(t, "; ");
    }
}

slave_answer slave_tell_text(slave *s, slave_answer level)
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
    return slave_tell_text(s, level);
}

void slave_say_message(slave *s) { say_in_one_line(&s->text, holonom_message(s->instance)); }

slave_answer slave_tell_message(slave *s, slave_answer level)
{
    hm_clear(&s->text);
    slave_say_message(s);
    return slave_tell_text(s, level);
}

int slave_hears(slave *s, int32_t result)
{
    if (result & HOLONOM_REMARKED)
        for (const char *line = holonom_remarks(s->instance); *line;) {
            const size_t length = strcspn(line, "\n");
            hm_clear(&s->text);
            hm_say_part(&s->text, line, length);
            slave_tell_text(s, ANSWER_WARNING);
            line += length + (line[length] == '\n');
        }
    return !(result & ~HOLONOM_REMARKED);
}

slave_answer slave_switch_log(slave *s, int32_t on, size_t count, const char *const *category)
{
    int32_t chosen = count ? 0 : DEBUGGING;
    for (size_t k = 0; k < count; k++) {
        int level = 0;
        while (level < N_CATEGORIES
               && !(category && category[k] && !strcmp(category[k], slave_categories[level])))
            level++;
        if (level == N_CATEGORIES)
            return slave_tell(
                s, ANSWER_ERROR,
                "setDebugLogging: no category of the log is named %s; there are %s, %s, %s, %s",
                category && category[k] ? category[k] : "NULL", slave_categories[0],
                slave_categories[1], slave_categories[2], slave_categories[3]);
        chosen |= level ? 1 << level : DEBUGGING;
    }
    s->log.wanted = on ? s->log.wanted | chosen : s->log.wanted & ~chosen;
    return ANSWER_OK;
}

#include "small.h"
