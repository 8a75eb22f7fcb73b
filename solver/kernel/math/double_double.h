/* Unevaluated sums of two doubles: twice the digits with IEEE additions and multiplications alone
   (Dekker 1971, Knuth). */
#ifndef HOLONOM_DOUBLE_DOUBLE_H
#define HOLONOM_DOUBLE_DOUBLE_H

#include "rounding.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* The second number is at most an ulp of the first. */
typedef struct pair {
    double hi, lo;
} pair;

static inline uint64_t bits_of(double x) { uint64_t u; memcpy(&u, &x, 8); return u; }
static inline double from_bits(uint64_t u) { double x; memcpy(&x, &u, 8); return x; }

/* Nearest whole number of |x| < 2^31, as the low bits of a sum with 1.5 2^52. */
static inline int nearest(double x)
{
    return (int)(uint32_t)bits_of(x + 0x1.8p52);
}

/* x 2^n of x from 1/2 to 2; what is subnormal is rounded once. */
static inline double scaled(double x, int n)
{
    if (n >= -1000 && n <= 1000) return from_bits(bits_of(x) + ((uint64_t)n << 52));
    if (n > 1000) return x * 0x1p1000 * from_bits((uint64_t)(n - 1000 + 1023) << 52);
    return x * from_bits((uint64_t)(n + 1000 + 1023) << 52) * 0x1p-1000;
}

/* a + b for |a| >= |b| or a = 0. */
static inline pair sum_of_ordered(double a, double b)
{
    const double hi = a + b;
    return (pair){hi, b - (hi - a)};
}

static inline pair sum_of(double a, double b)
{
    const double hi = a + b, part = hi - a;
    return (pair){hi, (a - (hi - part)) + (b - part)};
}

/* The leading 26 bits; the rest has 27. */
static inline double leading(double x) { return from_bits(bits_of(x) & 0xfffffffff8000000u); }

static inline pair product_of(double a, double b)
{
    const double hi = a * b, ah = leading(a), al = a - ah, bh = leading(b), bl = b - bh;
    return (pair){hi, ((ah * bh - hi) + (ah * bl + al * bh)) + al * bl};
}

/* What q lacks to be a/b, times b. */
static inline double lack_of(double q, double a, double b)
{
    const double qh = leading(q), bh = leading(b);
    return ((a - qh * bh) - qh * (b - bh)) - (q - qh) * b;
}

static inline pair quotient(pair a, pair b)
{
    const double inverse = 1.0 / b.hi, q = a.hi * inverse;
    return sum_of_ordered(q, (lack_of(q, a.hi, b.hi) + (a.lo - q * b.lo)) * inverse);
}

#endif
