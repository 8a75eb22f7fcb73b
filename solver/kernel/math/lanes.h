/* Two numbers that are computed side by side, by one instruction where the compiler knows such
   vectors. Each is rounded as it would be alone. */
#ifndef HOLONOM_LANES_H
#define HOLONOM_LANES_H

#if defined(__GNUC__) && !defined(HM_NO_VECTORS)
typedef double lanes __attribute__((vector_size(16), aligned(8), may_alias));
#define LANE(x, i) ((x)[i])
#define LANES(vector, of_lane) (vector)
#else
typedef struct lanes {
    double lane[2];
} lanes;
#define LANE(x, i) ((x).lane[i])
#define LANES(vector, of_lane) lanes_of(of_lane(0), of_lane(1))
#endif

static inline lanes lanes_of(double a, double b)
{
    const lanes x = {a, b};
    return x;
}

static inline lanes lanes_at(const double *x) { return *(const lanes *)(const void *)x; }

static inline void put_lanes(double *x, lanes a) { *(lanes *)(void *)x = a; }

static inline lanes both_lanes(double x) { return lanes_of(x, x); }

/* The product of each lane's numbers, and a sum with it or less it. */
#define PRODUCT(i) LANE(a, i) * LANE(b, i)
#define SUM(i) LANE(a, i) + LANE(b, i)
#define WITH_PRODUCT(i) LANE(sum, i) + PRODUCT(i)
#define LESS_PRODUCT(i) LANE(sum, i) - PRODUCT(i)

static inline lanes lanes_times(lanes a, lanes b) { return LANES(a * b, PRODUCT); }

static inline lanes lanes_sum(lanes a, lanes b) { return LANES(a + b, SUM); }

static inline lanes lanes_plus(lanes sum, lanes a, lanes b)
{ return LANES(sum + a * b, WITH_PRODUCT); }

static inline lanes lanes_less(lanes sum, lanes a, lanes b)
{ return LANES(sum - a * b, LESS_PRODUCT); }

#undef PRODUCT
#undef SUM
#undef WITH_PRODUCT
#undef LESS_PRODUCT

#endif
