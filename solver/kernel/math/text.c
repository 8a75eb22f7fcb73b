/* Sentences with numbers as Python writes them. */
#include "small.h"

#include "decimal.h"
#include "text.h"

#include <math.h>
#include <string.h>

void hm_say_part(hm_text *t, const char *from, size_t count)
{
    const size_t room = t->room - t->used - 1;
    if (count
        > room) /* not within a character of UTF-8, whose later bytes begin with the bits 10 */
        for (count = room; count && (from[count] & 0xc0) == 0x80;) count--;
    memcpy(t->begin + t->used, from, count);
    t->used += count;
    t->begin[t->used] = 0;
}

static void append_digit(hm_text *t, int digit) { hm_say_part(t, &"0123456789"[digit], 1); }

static void say_fixed(hm_text *t, const decimal *d, int decimals)
{
    for (int place = d->exponent > 0 ? d->exponent : 0; place >= -decimals; place--) {
        if (place == -1) hm_say_part(t, ".", 1);
        append_digit(t, digit_at(d, d->exponent - place));
    }
}

static void say_scientific(hm_text *t, const decimal *d, int decimals)
{
    const int size = d->exponent < 0 ? -d->exponent : d->exponent;
    for (int k = 0; k <= decimals; k++) {
        if (k == 1) hm_say_part(t, ".", 1);
        append_digit(t, digit_at(d, k));
    }
    hm_say_part(t, d->exponent < 0 ? "e-" : "e+", 2);
    if (size >= 100) append_digit(t, size / 100);
    append_digit(t, size / 10 % 10);
    append_digit(t, size % 10);
}

/* `style` r, g, e, f: see text.h; r and g choose between the other two by the exponent. */
static void say_double(hm_text *t, double x, char style, int digits)
{
    decimal d;
    if (x < 0.0 || (x == 0.0 && signbit(x))) hm_say_part(t, "-", 1);
    if (!(fabs(x) < INFINITY)) {
        hm_say_part(t, x != x ? "nan" : "inf", 3);
        return;
    }
    decimal_of(x, style == 'r', &d);
    if (style != 'r')
        round_decimal(&d, style == 'f'   ? d.exponent + 1 + digits
                          : style == 'e' ? digits + 1
                                         : digits);
    if (style == 'e' || style == 'f') {
        (style == 'e' ? say_scientific : say_fixed)(t, &d, digits);
        return;
    }
    while (d.count > 1 && !d.digit[d.count - 1]) d.count--;
    const int last = d.count > 1 ? d.count - 1 : 0,
              decimals = last > d.exponent ? last - d.exponent : style == 'r';
    if (d.exponent < -4 || d.exponent >= (style == 'r' ? 16 : digits)) say_scientific(t, &d, last);
    else say_fixed(t, &d, decimals);
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
        hm_say_part(t, plain, (size_t)(c - plain));
        if (!*c) break;
        for (c++; *c >= '0' && *c <= '9'; c++) digits = 10 * digits + (*c - '0');
        if (*c == 's' || *c == 'u') {
            const char *text = va_arg(values, const char *);
            hm_say_part(t, " ", *c == 'u' && *text);
            hm_say_part(t, text, strlen(text));
        } else if (*c == 'd') say_double(t, va_arg(values, int), 'f', 0);
        else say_double(t, va_arg(values, double), *c, digits);
    }
}

#include "small.h"
