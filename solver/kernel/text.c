/* Sentences with numbers as Python writes them. */
#include "small.h"

#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 336 }; /* the largest double has 309 digits before the point */

static void append(hm_text *t, const char *from, size_t count)
{
    const size_t room = t->room - t->used - 1;
    if (count > room) /* not within a character of UTF-8, whose later bytes begin with the bits 10 */
        for (count = room; count && (from[count] & 0xc0) == 0x80;) count--;
    memcpy(t->begin + t->used, from, count);
    t->used += count;
    t->begin[t->used] = 0;
}

/* Appends a number that the C library has written, with a point for whatever its locale has instead. */
static void append_number(hm_text *t, const char *number)
{
    while (*number) {
        const size_t plain = strspn(number, "0123456789+-einf"), other = strcspn(number += plain, "0123456789");
        append(t, number - plain, plain);
        append(t, ".", other > 0);
        number += other;
    }
}

/* As `repr`: the fewest digits that give x back. */
static void say_shortest(hm_text *t, double x)
{
    char text[LONGEST];
    int digits = -1, exponent;
    do snprintf(text, sizeof text, "%.*e", ++digits, x); while (digits < 16 && strtod(text, NULL) != x);
    exponent = atoi(strchr(text, 'e') + 1);
    if (exponent >= -4 && exponent < 16) snprintf(text, sizeof text, "%.*f", digits > exponent ? digits - exponent : 1, x);
    append_number(t, text);
}

static void say_double(hm_text *t, double x, char style, int digits)
{
    char text[LONGEST];
    const char *format = style == 'f' ? "%.*f" : style == 'e' ? "%.*e" : "%.*g";
    if (x != x) append(t, "nan", 3);
    else if (style == 'r' && !isinf(x)) say_shortest(t, x);
    else {
        snprintf(text, sizeof text, format, digits, x);
        append_number(t, text);
    }
}

void hm_take_back(hm_text *t, size_t begin)
{
    t->used = begin;
    t->begin[begin] = 0;
}

void hm_clear(hm_text *t) { hm_take_back(t, 0); }

void hm_say(hm_text *t, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    hm_say_all(t, format, values);
    va_end(values);
}

void hm_say_all(hm_text *t, const char *format, va_list values)
{
    for (const char *c = format; *c; c++) {
        const char *plain = c;
        int digits = 0;
        while (*c && *c != '%') c++;
        append(t, plain, (size_t)(c - plain));
        if (!*c) break;
        for (c++; *c >= '0' && *c <= '9'; c++) digits = 10 * digits + (*c - '0');
        if (*c == 's' || *c == 'u') {
            const char *text = va_arg(values, const char *);
            append(t, " ", *c == 'u' && *text);
            append(t, text, strlen(text));
        } else if (*c == 'd') say_double(t, va_arg(values, int), 'f', 0);
        else say_double(t, va_arg(values, double), *c, digits);
    }
}
