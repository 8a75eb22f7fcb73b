/* Decimal digits of doubles, all of them exact before they are rounded, and sentences made with them. */
#include "small.h"

#include "text.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { BILLION = 1000000000, MOST_WORDS = 90, MOST_DIGITS = 9 * MOST_WORDS };

/* 0.d_1 d_2 ... d_count 10^point, d_1 > 0; count 0 for zero. */
typedef struct decimal {
    char digit[MOST_DIGITS + 1];
    int count, point;
} decimal;

static int multiply(uint32_t *word, int count, uint32_t factor)
{
    uint64_t carry = 0;
    for (int i = 0; i < count; i++) {
        carry += (uint64_t)word[i] * factor;
        word[i] = (uint32_t)(carry % BILLION);
        carry /= BILLION;
    }
    if (carry) word[count++] = (uint32_t)carry;
    return count;
}

/* All digits of a finite x >= 0: m 2^e, or m 5^-e 10^e for e < 0. */
static void set_decimal(double x, decimal *d)
{
    int e, count = 2;
    const uint64_t m = (uint64_t)ldexp(frexp(x, &e), 53);
    uint32_t word[MOST_WORDS] = {(uint32_t)(m % BILLION), (uint32_t)(m / BILLION)};
    char *digit = d->digit;
    e -= 53;
    for (int left = abs(e); left > 0;) {
        const int now = left < 12 ? left : 12; /* 5^12 is below a billion */
        uint32_t factor = 1;
        for (int i = 0; i < now; i++) factor *= e < 0 ? 5 : 2;
        count = multiply(word, count, factor);
        left -= now;
    }
    for (int i = count - 1; i >= 0; i--)
        for (uint32_t unit = BILLION / 10; unit; unit /= 10) *digit++ = (char)('0' + word[i] / unit % 10);
    const char *first = d->digit;
    while (first < digit && *first == '0') first++;
    d->count = (int)(digit - first);
    d->point = d->count + (e < 0 ? e : 0);
    memmove(d->digit, first, (size_t)d->count);
}

/* Rounds to `count` digits, a tie to an even one; takes zeros off the end. */
static void round_decimal(decimal *d, int count)
{
    if (count < d->count) {
        if (count < 0) { d->count = 0; return; }
        int up = d->digit[count] >= '5';
        if (d->digit[count] == '5') {
            int more = 0;
            for (int i = count + 1; i < d->count; i++) more |= d->digit[i] != '0';
            if (!more) up = count && (d->digit[count - 1] & 1);
        }
        d->count = count;
        while (up && count && d->digit[count - 1] == '9') count--;
        if (up && count) d->digit[count - 1]++, d->count = count;
        else if (up) d->digit[0] = '1', d->count = 1, d->point++;
    }
    while (d->count && d->digit[d->count - 1] == '0') d->count--;
}

/* Whether digits give x back. There is no decimal point in what is read, so the locale does not matter. */
static int gives_back(const decimal *d, double x)
{
    char text[48];
    hm_text whole = {text, sizeof text, 0};
    memcpy(text, d->digit, (size_t)d->count);
    whole.used = (size_t)d->count;
    hm_say(&whole, "e%d", d->point - d->count);
    return strtod(text, NULL) == x;
}

static void append(hm_text *t, const char *from, size_t count)
{
    const size_t room = t->room - t->used - 1;
    if (count > room) /* not within a character of UTF-8, whose later bytes begin with the bits 10 */
        for (count = room; count && (from[count] & 0xc0) == 0x80;) count--;
    memcpy(t->begin + t->used, from, count);
    t->used += count;
    t->begin[t->used] = 0;
}

static void append_zeros(hm_text *t, int count)
{
    for (; count > 0; count--) append(t, "0", 1);
}

static void say_int(hm_text *t, int x)
{
    char text[12], *end = text + sizeof text, *c = end;
    unsigned left = x < 0 ? 0u - (unsigned)x : (unsigned)x;
    do *--c = (char)('0' + left % 10); while (left /= 10);
    if (x < 0) *--c = '-';
    append(t, c, (size_t)(end - c));
}

/* Digits around a decimal point, with at least so many behind it. */
static void say_plain(hm_text *t, const decimal *d, int behind)
{
    const int before = d->point > 0 ? d->point : 0, given = d->count < before ? d->count : before;
    append(t, "0", d->point <= 0);
    append(t, d->digit, (size_t)given);
    append_zeros(t, before - given);
    const int zeros = d->point < 0 && d->count ? -d->point : 0, rest = d->count - given;
    if (!rest && !behind) return;
    append(t, ".", 1);
    append_zeros(t, zeros);
    append(t, d->digit + given, (size_t)rest);
    append_zeros(t, behind - zeros - rest);
}

static void say_exponent(hm_text *t, const decimal *d, int behind)
{
    const int e = d->count ? d->point - 1 : 0, rest = d->count ? d->count - 1 : 0;
    append(t, d->count ? d->digit : "0", 1);
    append(t, ".", rest || behind);
    append(t, d->digit + 1, (size_t)rest);
    append_zeros(t, behind - rest);
    hm_say(t, e < 0 ? abs(e) < 10 ? "e-0%d" : "e-%d" : e < 10 ? "e+0%d" : "e+%d", abs(e));
}

static void say_double(hm_text *t, double x, char style, int digits)
{
    decimal d, exact;
    if (x != x) { append(t, "nan", 3); return; }
    append(t, "-", signbit(x) != 0);
    if (isinf(x)) { append(t, "inf", 3); return; }
    if (x == 0.0) exact.count = exact.point = 0;
    else set_decimal(fabs(x), &exact);
    d = exact;
    if (style == 'f') round_decimal(&d, d.point + digits);
    else if (style == 'e') round_decimal(&d, digits + 1);
    else if (style == 'g') round_decimal(&d, digits);
    else if (x != 0.0)
        for (int count = 1; count <= 17; count++) {
            d = exact;
            round_decimal(&d, count);
            if (gives_back(&d, fabs(x))) break;
        }
    if (style == 'e' || (x != 0.0 && style != 'f' && (d.point < -3 || d.point > (style == 'g' ? digits : 16))))
        say_exponent(t, &d, style == 'e' ? digits : 0);
    else
        say_plain(t, &d, style == 'r' ? 1 : style == 'f' ? digits : 0);
}

void hm_clear(hm_text *t)
{
    t->used = 0;
    t->begin[0] = 0;
}

void hm_say(hm_text *t, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    for (const char *c = format; *c; c++) {
        const char *plain = c;
        int digits = 0;
        while (*c && *c != '%') c++;
        append(t, plain, (size_t)(c - plain));
        if (!*c) break;
        for (c++; *c >= '0' && *c <= '9'; c++) digits = 10 * digits + (*c - '0');
        if (*c == 's') {
            const char *text = va_arg(values, const char *);
            append(t, text, strlen(text));
        } else if (*c == 'd') say_int(t, va_arg(values, int));
        else say_double(t, va_arg(values, double), *c, digits);
    }
    va_end(values);
}
