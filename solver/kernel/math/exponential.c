/* Exponentials, logarithms, powers and hyperbolic functions. Systems' own differ in the last bit,
   and with them the motion; these use IEEE additions, multiplications, divisions and square roots
   alone. */
#include "elementary.h"
#include "exponential_tables.h"

/* exp(x) = (hi + lo) 2^n for |x| < 760, by 2^(j/64) and a series in the rest r, which is below
   0.0055. */
static pair power_of_e(pair x, int *n)
{
    const int k = nearest(x.hi * 0x1.71547652b82fep+6); /* 64/ln 2 */
    const pair table = ROOTS_OF_TWO[k & 63];
    const double r = (x.hi - k * LN2_OVER_64[0]) + (x.lo - k * LN2_OVER_64[1]),
                 q = r * r; /* the first is exact */
    const double series = r
                          + q
                                * ((0.5 + r * (1.0 / 6.0))
                                   + q * ((1.0 / 24.0 + r * (1.0 / 120.0)) + q * (1.0 / 720.0)));
    *n = (k - (k & 63)) / 64;
    return sum_of_ordered(table.hi, table.lo + table.hi * series);
}

/* Of x > 0, finite: log c, and the rest r of x = 2^k c (1 + r), |r| < 2^-7. */
static pair split_logarithm(double x, pair *r)
{
    int scale = 0;
    if (x < 0x1p-1022) x *= 0x1p54, scale = -54;
    const uint64_t above = bits_of(x) - bits_of(0.6875);
    const int j = (int)(above >> 45) & 127, k = (int)((int64_t)above >> 52);
    const double m = from_bits(bits_of(x) - ((above >> 52) << 52)), mh = leading(m);
    const double head = mh * RECIPROCALS[j] - 1.0,
                 tail = (m - mh) * RECIPROCALS[j]; /* both exact */
    *r = sum_of_ordered(head, tail);
    return (pair){(k + scale) * LN2[0].hi + LOGARITHMS[j].hi,
                  (k + scale) * LN2[0].lo + LOGARITHMS[j].lo};
}

/* log(1 + r) - r + r^2/2 for |r| < 2^-7. */
static double higher_terms(double r)
{
    const double q = r * r;
    const double odd = 1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0)));
    const double even = 1.0 / 4.0 + q * (1.0 / 6.0 + q * (1.0 / 8.0 + q * (1.0 / 10.0)));
    return r * q * (odd - r * even);
}

static pair logarithm(double x)
{
    pair r;
    const pair base = split_logarithm(x, &r), head = sum_of_ordered(base.hi, r.hi);
    const double top = leading(r.hi), below = 0.5 * (r.hi - top) * (r.hi + top); /* of r^2/2 */
    const pair half = sum_of_ordered(head.hi, -0.5 * top * top);
    const double rest = (higher_terms(r.hi) - below) + (r.lo * (1.0 - r.hi) + base.lo);
    return sum_of_ordered(half.hi, half.lo + (head.lo + rest));
}

double hm_exp(double x)
{
    if (!(fabs(x) < 746.0)) return x > 0.0 ? INFINITY : x < 0.0 ? 0.0 : x;
    int n;
    const pair e = power_of_e((pair){x, 0.0}, &n);
    return scaled(e.hi, n);
}

double hm_log(double x)
{
    if (!(x > 0.0 && x < INFINITY)) return x == 0.0 ? -INFINITY : x < 0.0 ? NAN : x;
    pair r;
    const pair base = split_logarithm(x, &r), head = sum_of_ordered(base.hi, r.hi);
    return head.hi + (head.lo + ((higher_terms(r.hi) - 0.5 * r.hi * r.hi) + r.lo + base.lo));
}

/* 2 for even whole numbers, 1 for odd ones, 0 for others. */
static int wholeness(double y)
{
    if (y != floor(y)) return 0;
    return fabs(y) >= 0x1p53 || 2.0 * floor(0.5 * y) == y ? 2 : 1;
}

double hm_pow(double x, double y)
{
    const double size = fabs(x);
    double sign = 1.0;
    if (y == 2.0) return x * x; /* what formulas have most, and rounded once */
    if (!(x > 0.0 && x < INFINITY && fabs(y) < INFINITY)) {
        if (y == 0.0 || x == 1.0) return 1.0;
        if (x != x || y != y) return x + y;
        const int whole = wholeness(y);
        if (signbit(x) && whole == 1) sign = -1.0;
        if (isinf(y)) return size == 1.0 ? 1.0 : (size > 1.0) == (y > 0.0) ? INFINITY : 0.0;
        if (size == 0.0 || isinf(x))
            return (size == 0.0) == (y > 0.0) ? sign * 0.0 : sign * INFINITY;
        if (!whole) return NAN;
    }
    const pair l = logarithm(size);
    const double rough = y * l.hi;
    if (!(fabs(rough) < 746.0)) return sign * (rough > 0.0 ? INFINITY : 0.0);
    if (fabs(rough) < 0x1p-60) return sign * (1.0 + rough);
    const pair exact = product_of(y, l.hi);
    int n;
    const pair e = power_of_e((pair){exact.hi, exact.lo + y * l.lo}, &n);
    return sign * scaled(e.hi, n);
}

/* ----------------------------------------------------------------------------------- hyperbolic */

/* sinh x - x and cosh x - 1 for |x| < 1. */
static double sinh_terms(double x)
{
    const double q = x * x, p = q * q;
    const double low = (1.0 / 6.0 + q * (1.0 / 120.0)) + p * (1.0 / 5040.0 + q * (1.0 / 362880.0));
    const double high = (1.0 / 39916800.0 + q * (1.0 / 6227020800.0))
                        + p * (1.0 / 1307674368000.0 + q * (1.0 / 355687428096000.0));
    return x * q * (low + p * p * high);
}

static double cosh_terms(double q)
{
    const double p = q * q;
    const double low = (0.5 + q * (1.0 / 24.0)) + p * (1.0 / 720.0 + q * (1.0 / 40320.0));
    const double high = (1.0 / 3628800.0 + q * (1.0 / 479001600.0))
                        + p * (1.0 / 87178291200.0 + q * (1.0 / 20922789888000.0));
    return q * (low + p * p * high);
}

double hm_sinh(double x)
{
    const double size = fabs(x);
    if (size < 1.0) return x + sinh_terms(x);
    if (!(size < 760.0)) return x * INFINITY;
    int n;
    const pair e = power_of_e((pair){size, 0.0}, &n);
    const double y = scaled(e.hi + (e.lo - (n < 64 ? scaled(1.0, -2 * n) / e.hi : 0.0)), n - 1);
    return x < 0.0 ? -y : y;
}

double hm_cosh(double x)
{
    const double size = fabs(x);
    if (!(size < 760.0)) return size * INFINITY;
    int n;
    const pair e = power_of_e((pair){size, 0.0}, &n);
    return scaled(e.hi + (e.lo + (n < 64 ? scaled(1.0, -2 * n) / e.hi : 0.0)), n - 1);
}

double hm_atanh(double x)
{
    if (fabs(x) < 0.01) {
        const double q = x * x;
        return x + x * q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0))));
    }
    const pair q = quotient(sum_of_ordered(1.0, x), sum_of_ordered(1.0, -x));
    if (!(q.hi > 0.0 && q.hi < INFINITY))
        return q.hi == 0.0 ? -INFINITY : x == 1.0 ? INFINITY : NAN;
    const pair l = logarithm(q.hi);
    return 0.5 * (l.hi + (l.lo + q.lo / q.hi));
}

double hm_tanh(double x)
{
    const double size = fabs(x);
    if (size < 0.3) {
        const pair cosh = sum_of_ordered(1.0, cosh_terms(x * x));
        return x == 0.0 ? x : quotient(sum_of_ordered(x, sinh_terms(x)), cosh).hi;
    }
    if (!(size < 22.0)) return x != x ? x : x > 0.0 ? 1.0 : -1.0;
    int n;
    const pair e = power_of_e((pair){2.0 * size, 0.0}, &n);
    const double power = scaled(1.0, n), lo = e.lo * power;
    const pair less = sum_of_ordered(e.hi * power, -1.0), more = sum_of_ordered(e.hi * power, 1.0);
    const double t = quotient((pair){less.hi, less.lo + lo}, (pair){more.hi, more.lo + lo}).hi;
    return x < 0.0 ? -t : t;
}
