/* Prints a hash of the bits that each elementary function returns for so many arguments, the same
   on every machine. */
#include "elementary.h"

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state = 88172645463325252u;

static uint64_t next_bits(void) /* xorshift (Marsaglia 2003) */
{
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return state;
}

static double from_bits(uint64_t u) { double x; memcpy(&x, &u, 8); return x; }

/* Any double at all, or one of a usual size. */
static double argument(int usual)
{
    const uint64_t u = next_bits();
    return from_bits(usual ? (u & 0x800fffffffffffffu) | (uint64_t)(1023 - 8 + (u >> 52 & 15)) << 52
                           : u);
}

typedef struct { const char *name; double (*one)(double); double (*two)(double, double); } function;

int main(int count, char **word)
{
    static const function all[] = {
        {"sin", hm_sin, 0},     {"cos", hm_cos, 0},   {"tan", hm_tan, 0},
        {"asin", hm_asin, 0},   {"acos", hm_acos, 0}, {"atan", hm_atan, 0},
        {"exp", hm_exp, 0},     {"log", hm_log, 0},   {"sinh", hm_sinh, 0},
        {"cosh", hm_cosh, 0},   {"tanh", hm_tanh, 0}, {"atanh", hm_atanh, 0},
        {"atan2", 0, hm_atan2}, {"pow", 0, hm_pow},   {"hypot", 0, hm_hypot},
    };
    const long cases = count > 1 ? atol(word[1]) : 1000;
    for (unsigned k = 0; k < sizeof all / sizeof *all; k++) {
        uint64_t hash = 14695981039346656037u, bits; /* FNV-1a, a double at a time */
        for (long i = 0; i < cases; i++) {
            const double x = argument(i % 4 != 0), y = argument(i % 4 != 0);
            const double found = all[k].one ? all[k].one(x) : all[k].two(x, y);
            memcpy(&bits, &found, 8);
            if (found != found) bits = 0; /* the sign of a NaN says nothing */
            hash = (hash ^ bits) * 1099511628211u;
        }
        printf("%s %016" PRIx64 "\n", all[k].name, hash);
    }
    return 0;
}
