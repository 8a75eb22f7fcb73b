/* Sentences in memory of a fixed size, with numbers as Python writes them, whatever the locale. */
#ifndef HOLONOM_TEXT_H
#define HOLONOM_TEXT_H

#include <stdarg.h>
#include <stddef.h>

typedef struct hm_text {
    char *begin; /* ends with 0 */
    size_t room, used;
} hm_text;

void hm_clear(hm_text *text);

/* Takes away what was said since `begin` was used. */
void hm_take_back(hm_text *text, size_t begin);

/* Appends so many bytes of a text. */
void hm_say_part(hm_text *text, const char *from, size_t count);

/* Appends; what has no room is cut off. In `format`: %s a text, %u a unit, behind a space unless it
   is empty, %d an int, %r a double with the fewest digits that give it back, %6g one of at most 6
   significant digits, %1e of 1 and %1f of 1 decimal. */
void hm_say(hm_text *text, const char *format, ...);
void hm_say_all(hm_text *text, const char *format, va_list values);

#endif
