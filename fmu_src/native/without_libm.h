/* In sources that an importer compiles: functions of libm that are exact, so that none is called.
   What a compiler makes of the standard's own depends on its flags, and some importers do not link
   libm. */
#ifndef HOLONOM_WITHOUT_LIBM_H
#define HOLONOM_WITHOUT_LIBM_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>
#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#endif

static inline uint64_t own_bits(double x) { uint64_t u; memcpy(&u, &x, 8); return u; }
static inline double own_double(uint64_t u) { double x; memcpy(&x, &u, 8); return x; }

static inline double own_fabs(double x)
{
#if defined(__GNUC__)
    return __builtin_fabs(x); /* never a call */
#else
    return own_double(own_bits(x) & INT64_MAX);
#endif
}
static inline int own_signbit(double x) { return own_bits(x) >> 63 != 0; }
static inline int own_isinf(double x) { return own_fabs(x) > DBL_MAX; }
static inline double own_copysign(double x, double sign)
{ return (own_signbit(x) != own_signbit(sign)) ? -x : x; }

/* The second of two that are equal, such as 0 and -0. */
static inline double own_fmax(double x, double y) { return x > y || y != y ? x : y; }
static inline double own_fmin(double x, double y) { return x < y || y != y ? x : y; }

/* The digits of a number behind its point are cleared. */
static double own_trunc(double x)
{
    const int exponent = (int)(own_bits(x) >> 52 & 2047) - 1023;
    if (exponent >= 52) return x;
    return exponent < 0 ? own_copysign(0.0, x)
                        : own_double(own_bits(x) & ~(UINT64_MAX >> 12 >> exponent));
}

static double own_floor(double x)
{
    const double whole = own_trunc(x);
    return whole > x ? whole - 1.0 : whole;
}

static double own_ceil(double x)
{
    const double whole = own_trunc(x);
    return whole < x ? own_copysign(whole + 1.0, x) : whole;
}

/* The next number above an x >= 0, which is all that is asked for. */
static double own_nextafter(double x, double above)
{ return x < above ? own_double(own_bits(x) + 1) : x; }

/* 53 digits and the exponent of a positive finite number, of small ones, too. */
static uint64_t own_digits(double x, int *exponent)
{
    uint64_t digits = own_bits(x) & (UINT64_MAX >> 12);
    *exponent = (int)(own_bits(x) >> 52 & 2047);
    if (*exponent) return digits | (uint64_t)1 << 52;
    for (*exponent = 1; !(digits >> 52); digits <<= 1) --*exponent;
    return digits;
}

static double own_composed(uint64_t digits, int exponent)
{
    return own_double(exponent > 0 ? digits + ((uint64_t)(exponent - 1) << 52)
                                   : digits >> (1 - exponent));
}

/* Rest of a division, by long division of the digits. */
static double own_fmod(double a, double b)
{
    const double x = own_fabs(a), y = own_fabs(b);
    int from, to;
    if (!(x <= DBL_MAX && y > 0.0)) return NAN;
    if (x < y) return a;
    uint64_t rest = own_digits(x, &from);
    const uint64_t by = own_digits(y, &to);
    for (;; rest <<= 1, from--) {
        if (rest >= by) rest -= by;
        if (from == to) break;
    }
    if (!rest) return own_copysign(0.0, a);
    for (; !(rest >> 52); rest <<= 1) from--;
    return own_copysign(own_composed(rest, from), a);
}

/* Where there is no instruction: 54 digits one by one, of which the last rounds; it is never a
   tie. */
static inline double own_slow_sqrt(double x)
{
    int exponent;
    uint64_t root = 0, rest = 0;
    if (!(x > 0.0 && x <= DBL_MAX)) return x >= 0.0 ? x : NAN;
    const uint64_t digits = own_digits(x, &exponent);
    const int odd = exponent & 1; /* x = digits 2^(exponent - 1075) */
    const uint64_t square = odd ? digits : digits << 1;
    for (int k = 0; k < 54; k++) {
        rest = rest << 2 | (k < 27 ? square >> (52 - 2 * k) & 3 : 0);
        root <<= 1;
        if (rest > 2 * root) rest -= 2 * root + 1, root++;
    }
    return own_composed((root >> 1) + (root & 1), (exponent + 1023 - (odd ? 0 : 1)) / 2);
}

static inline double own_sqrt(double x)
{
#if defined(__SSE2__) || defined(_M_X64)
    const __m128d one = _mm_set_sd(x);
    return _mm_cvtsd_f64(_mm_sqrt_sd(one, one));
#elif defined(__aarch64__) && defined(__GNUC__)
    double root;
    __asm__("fsqrt %d0, %d1" : "=w"(root) : "w"(x));
    return root;
#else
    return own_slow_sqrt(x);
#endif
}

#undef signbit
#undef isinf
#define fabs own_fabs
#define signbit own_signbit
#define isinf own_isinf
#define copysign own_copysign
#define fmax own_fmax
#define fmin own_fmin
#define floor own_floor
#define ceil own_ceil
#define nextafter own_nextafter
#define fmod own_fmod
#define sqrt own_sqrt

#endif
