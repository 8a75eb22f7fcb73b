/* The own functions of sources beside those of libm: the number of doubles, of many kinds, in which
   a function differs. */
#include <math.h>
#include <stdio.h>

static double libm_floor(double x) { return floor(x); }
static double libm_ceil(double x) { return ceil(x); }
static double libm_sqrt(double x) { return sqrt(x); }
static double libm_fabs(double x) { return fabs(x); }
static double libm_fmod(double x, double y) { return fmod(x, y); }
static double libm_fmax(double x, double y) { return fmax(x, y); }
static double libm_fmin(double x, double y) { return fmin(x, y); }
static double libm_copysign(double x, double y) { return copysign(x, y); }
static double libm_next(double x, double y) { return (void)y, nextafter(fabs(x), INFINITY); }

#include "without_libm.h"

static double own_next(double x, double y) { return (void)y, own_nextafter(fabs(x), INFINITY); }

enum { COUNT = 200000 };
static int differs(double a, double b) { return !(a != a && b != b) && own_bits(a) != own_bits(b); }

static double some(uint64_t *seed)
{
    static const double odd[] = {
        0.0,       -0.0,        0.5,       -0.5,    1.0, 1.5, 3.0, 0x1p52, 0x1.fffffffffffffp51,
        0x1p-1074, 0x1.8p-1060, 0x1p-1022, INFINITY};
    const uint64_t r = *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    if (r >> 60 == 0) return odd[(r >> 32) % (sizeof odd / sizeof *odd)];
    if (r >> 62 == 1) return 0.0 + own_double(r << 32 | r >> 32); /* of any size, or a quiet NaN */
    return ((double)(int64_t)(r << 20) * 0x1p-63) * (double)(1u << ((r >> 50) % 24));
}

static void report(const char *name, int n) { printf("%s %d\n", name, n); }

#define COMPARE(name, own, libm) \
    { \
        uint64_t seed = 1; \
        int n = 0; \
        for (int k = 0; k < COUNT; k++) { \
            const double x = some(&seed), y = some(&seed); \
            (void)y; \
            n += differs(own, libm); \
        } \
        report(#name, n); \
    }
#define ONE(name) COMPARE(own_##name, own_##name(x), libm_##name(x))
#define TWO(name) COMPARE(own_##name, own_##name(x, y), libm_##name(x, y))

int main(void)
{
    ONE(floor)
    ONE(ceil) ONE(sqrt) ONE(fabs) TWO(fmod) TWO(copysign) TWO(next)
        COMPARE(fmax, 0.0 + own_fmax(x, y),
                0.0 + libm_fmax(x, y)) /* of 0 and -0 the standard takes either */
        COMPARE(fmin, 0.0 + own_fmin(x, y), 0.0 + libm_fmin(x, y))
            COMPARE(slow_sqrt, own_slow_sqrt(x), libm_sqrt(x)) return 0;
}
