/* Decimal digits of doubles, exact, and rounded half to even as C's printf and Python round them;
   no locale, no C library. */
#ifndef HOLONOM_DECIMAL_H
#define HOLONOM_DECIMAL_H

#include <stdint.h>
#include <string.h>

/* 2^-1075 and its odd multiples have up to 770 digits. */
enum { BILLION = 1000000000, LIMBS = 90, LIMB_DIGITS = 9 };

/* digit[0].digit[1] digit[2] ... 10^exponent; those behind `count` are 0. */
typedef struct decimal {
    int exponent, count;
    char digit[LIMBS * LIMB_DIGITS + 1];
} decimal;

static int digit_at(const decimal *d, int k) { return k >= 0 && k < d->count ? d->digit[k] : 0; }

/* m 2^e: where e is negative, the digits of m 5^-e. */
static void set_decimal(decimal *d, uint64_t m, int e)
{
    uint32_t limb[LIMBS];
    int n = 0;
    for (; m; m /= BILLION) limb[n++] = (uint32_t)(m % BILLION);
    for (int k = 0; k < (e < 0 ? -e : e); k++) {
        uint64_t carry = 0;
        for (int i = 0; i < n; i++, carry /= BILLION) {
            carry += (uint64_t)limb[i] * (e < 0 ? 5 : 2);
            limb[i] = (uint32_t)(carry % BILLION);
        }
        if (carry) limb[n++] = (uint32_t)carry;
    }
    d->count = 0;
    for (int i = n - 1; i >= 0; i--)
        for (uint32_t unit = BILLION / 10; unit; unit /= 10) {
            const uint32_t digit = limb[i] / unit % 10;
            if (d->count || digit) d->digit[d->count++] = (char)digit;
        }
    d->exponent = n ? d->count - 1 + (e < 0 ? e : 0) : 0;
}

/* Rounds to n digits; n may be negative. */
static void round_decimal(decimal *d, int n)
{
    int beyond = 0;
    for (int k = n < 0 ? 0 : n + 1; k < d->count; k++) beyond |= d->digit[k];
    const int next = n < 0 ? 0 : digit_at(d, n),
              is_up = next > 5 || (next == 5 && (beyond || digit_at(d, n - 1) & 1));
    if (n < d->count) d->count = n < 0 ? 0 : n;
    if (!is_up) return;
    while (n > 0 && d->digit[n - 1] == 9) d->digit[--n] = 0;
    if (n > 0) {
        d->digit[n - 1]++;
        return;
    }
    memmove(d->digit + 1, d->digit, (size_t)d->count++);
    d->digit[0] = 1;
    d->exponent++;
}

/* The sign of a - b; both > 0. */
static int compare_decimals(const decimal *a, const decimal *b)
{
    int difference = a->exponent - b->exponent;
    for (int k = 0; !difference && (k < a->count || k < b->count); k++)
        difference = digit_at(a, k) - digit_at(b, k);
    return difference;
}

/* |x|, rounded to the fewest digits that give it back if `is_shortest`. */
static void decimal_of(double x, int is_shortest, decimal *d)
{
    uint64_t m;
    memcpy(&m, &x, 8);
    const int field = (int)(m >> 52 & 2047), e = (field ? field : 1) - 1075;
    m &= UINT64_MAX >> 12;
    const int is_power = field > 1 && !m; /* of 2: numbers below it lie twice as close */
    if (field) m |= (uint64_t)1 << 52;
    set_decimal(d, m, e);
    if (!is_shortest || !m) return;
    const decimal exact = *d;
    decimal low, high;
    set_decimal(&low, (is_power ? 4 * m : 2 * m) - 1, is_power ? e - 2 : e - 1);
    set_decimal(&high, 2 * m + 1, e - 1);
    for (int n = 1, ends = !(m & 1); n <= 17;
         n++) { /* of an even m, numbers half way round to it */
        *d = exact;
        round_decimal(d, n);
        if (compare_decimals(&low, d) < ends && compare_decimals(d, &high) < ends) break;
    }
}

#endif
