/* Sines, cosines, tangents, angles and lengths. Systems' own differ in the last bit, and with them
   the motion; these use IEEE additions, multiplications, divisions and square roots alone. */
#include "elementary.h"
#include "trigonometric_tables.h"

/* (asin s/s - 1)/s^2 in powers of s^2 up to 1/4, near-minimax */
static const double ARCSINE[13] = {
    0x1.5555555555556p-3, 0x1.3333333332ecap-4, 0x1.6db6db6e31f13p-5, 0x1.f1c71c1db0623p-6,
    0x1.6e8bb1c8209a2p-6, 0x1.1c4d35cf95421p-6, 0x1.c9cf07674736ap-7, 0x1.782651caa6547p-7,
    0x1.52420b04b37bep-7, 0x1.65a9c4dfcf8b2p-8, 0x1.1d189408314eep-6, -0x1.e6aaa8a0a04ccp-7,
    0x1.d72b2bc8155f8p-6
};

/* 32 bits of 2/pi from this bit on, zeros before the first. */
static uint64_t bits_of_two_over_pi(int first)
{
    const int word = first >> 5, shift = first & 31;
    const uint64_t here = word < 0 ? 0 : TWO_OVER_PI[word],
                   next = word < -1 ? 0 : TWO_OVER_PI[word + 1];
    return (here << 32 | next) >> (32 - shift) & 0xffffffffu;
}

/* x - k pi/2 of a large x: only the bits of 2/pi count whose product with x is no multiple of 4
   (Payne & Hanek 1983). */
static pair far_remainder(double x, int *quadrant)
{
    const uint64_t bits = bits_of(x), m = (bits & 0xfffffffffffffu) | 0x10000000000000u;
    const int first = (int)(bits >> 52 & 2047) - 1077; /* x = m 2^(first + 2) */
    uint64_t limb[6], carry = 0;
    pair rest = {0.0, 0.0};
    for (int i = 5; i >= 0; i--) { /* the lower 192 bits of the product of m and 192 bits */
        const uint64_t w = bits_of_two_over_pi(first + 32 * i);
        const uint64_t low = (m & 0xffffffffu) * w + carry;
        limb[i] = low & 0xffffffffu;
        carry = (low >> 32) + (m >> 32) * w;
    }
    *quadrant = (int)(limb[0] >> 30);
    const int above =
        limb[0] >> 29 & 1; /* of one half of pi/2: what is missing to the next multiple */
    limb[0] &= 0x3fffffffu;
    if (above) {
        *quadrant = (*quadrant + 1) & 3;
        for (int i = 0; i < 6; i++) limb[i] = (i ? 0xffffffffu : 0x3fffffffu) - limb[i];
    }
    double weight = 0x1p-30;
    for (int i = 0; i < 6; i++, weight *= 0x1p-32) {
        const pair s = sum_of(rest.hi, (double)limb[i] * weight);
        rest = sum_of_ordered(s.hi, rest.lo + s.lo);
    }
    const pair p = product_of(rest.hi, PI[0].hi);
    const pair r = sum_of_ordered(p.hi, p.lo + (rest.hi * PI[0].lo + rest.lo * PI[0].hi));
    return above ? (pair){-r.hi, -r.lo} : r;
}

/* x - k pi/2, of at most pi/4, and k modulo 4, of a finite x. */
static pair remainder_of(double x, int *quadrant)
{
    if (fabs(x) < 0.785) return *quadrant = 0, (pair){x, 0.0};
    if (fabs(x) > 1e6) {
        const pair r = far_remainder(fabs(x), quadrant);
        if (x > 0.0) return r;
        *quadrant = (4 - *quadrant) & 3;
        return (pair){-r.hi, -r.lo};
    }
    const int k = nearest(x * 0x1.45f306dc9c883p-1); /* 2/pi */
    const pair a = sum_of(x - k * HALF_PI[0], -k * HALF_PI[1]); /* products exact */
    const pair b = sum_of(a.hi, -k * HALF_PI[2]);
    const pair c = sum_of_ordered(b.hi, a.lo + b.lo);
    *quadrant = k & 3;
    return sum_of_ordered(c.hi, c.lo - k * HALF_PI[3]);
}

/* sin r and cos r for |r| < 0.8. */
static pair sine(pair r)
{
    const double q = r.hi * r.hi, p = q * q;
    const double low =
        1.0 / 120.0 + q * (-1.0 / 5040.0) + p * (1.0 / 362880.0 + q * (-1.0 / 39916800.0));
    const double high =
        1.0 / 6227020800.0 + q * (-1.0 / 1307674368000.0) + p * (1.0 / 355687428096000.0);
    const double terms = r.hi * q * (-1.0 / 6.0 + q * (low + p * p * high));
    return sum_of_ordered(r.hi, terms + r.lo * (1.0 - 0.5 * q));
}

static pair cosine(pair r)
{
    const double q = r.hi * r.hi, p = q * q, top = leading(r.hi);
    const double low =
        1.0 / 24.0 + q * (-1.0 / 720.0) + p * (1.0 / 40320.0 + q * (-1.0 / 3628800.0));
    const double high =
        1.0 / 479001600.0 + q * (-1.0 / 87178291200.0) + p * (1.0 / 20922789888000.0);
    const double below = 0.5 * (r.hi - top) * (r.hi + top) + r.hi * r.lo; /* of r^2/2 */
    const pair half = sum_of_ordered(1.0, -0.5 * top * top);
    return sum_of_ordered(half.hi, half.lo + (p * (low + p * p * high) - below));
}

double hm_sin(double x)
{
    if (!(fabs(x) < INFINITY)) return x - x;
    if (fabs(x) < 0x1p-27) return x;
    int quadrant;
    const pair r = remainder_of(x, &quadrant);
    const double y = quadrant & 1 ? cosine(r).hi : sine(r).hi;
    return quadrant & 2 ? -y : y;
}

double hm_cos(double x)
{
    if (!(fabs(x) < INFINITY)) return x - x;
    int quadrant;
    const pair r = remainder_of(x, &quadrant);
    const double y = quadrant & 1 ? sine(r).hi : cosine(r).hi;
    return (quadrant + 1) & 2 ? -y : y;
}

double hm_tan(double x)
{
    if (!(fabs(x) < INFINITY)) return x - x;
    if (fabs(x) < 0x1p-27) return x;
    int quadrant;
    const pair r = remainder_of(x, &quadrant), s = sine(r), c = cosine(r);
    return quadrant & 1 ? -quotient(c, s).hi : quotient(s, c).hi;
}

/* --------------------------------------------------------------------------------------- angles */

/* Angle of a direction with y >= 0, by the next atan(c), c = j/32, and a series in the tangent t of
   the rest. */
static double angle_above(double y, double x)
{
    const int back = x < 0.0, steep = y > fabs(x);
    const double up = steep ? fabs(x) : y, along = steep ? y : fabs(x),
                 sign = steep == back ? 1.0 : -1.0;
    const int next = nearest(32.0 * (up / along)), j = next < 4 ? 0 : next;
    const double c = j / 32.0, top = leading(along);
    const double t = j ? ((up - c * top) - c * (along - top)) / (along + c * up) : up / along,
                 q = t * t, p = q * q;
    const double low = (-1.0 / 3.0 + q * (1.0 / 5.0)) + p * (-1.0 / 7.0 + q * (1.0 / 9.0));
    const double high = (-1.0 / 11.0 + q * (1.0 / 13.0)) + p * (-1.0 / 15.0 + q * (1.0 / 17.0));
    const double lacks = j ? ANGLES[j].lo : lack_of(t, up, along) / along;
    const double rest = t + (t * q * (low + p * p * high) + lacks);
    if (!steep && !back) return ANGLES[j].hi + rest;
    const pair whole = PI[steep ? 0 : 1], sum = sum_of_ordered(whole.hi, sign * ANGLES[j].hi);
    return sum.hi + (sum.lo + (whole.lo + sign * rest));
}

double hm_atan(double x)
{
    const double size = fabs(x);
    if (!(size < 0x1p60)) return x != x ? x : x > 0.0 ? PI[0].hi : -PI[0].hi;
    if (size < 0x1p-27) return x;
    const double a = angle_above(size, 1.0);
    return x < 0.0 ? -a : a;
}

double hm_atan2(double y, double x)
{
    if (x != x || y != y) return x + y;
    double up = fabs(y), along = fabs(x), a;
    if (isinf(up) || isinf(along)) up = isinf(up) ? 1.0 : 0.0, along = isinf(along) ? 1.0 : 0.0;
    if (up == 0.0 || along == 0.0) {
        a = up == 0.0 ? (signbit(x) ? PI[1].hi : 0.0) : PI[0].hi;
    } else if (along > up * 0x1p60 && signbit(x)) {
        a = PI[1].hi;
    } else if (up > along * 0x1p60) {
        a = PI[0].hi;
    } else if (along > up * 0x1p60) {
        a = up / along;
    } else {
        const double scale = along + up > 0x1p900    ? 0x1p-200
                             : along + up < 0x1p-800 ? 0x1p200
                                                     : 1.0;
        a = angle_above(up * scale, signbit(x) ? -along * scale : along * scale);
    }
    return signbit(y) ? -a : a;
}

/* asin s - s for 0 <= s <= 1/2, by the near-minimax polynomial in q = s^2. */
static double asin_terms(double s, double q)
{
    const double *a = ARCSINE, p = q * q, o = p * p;
    const double low = (a[0] + q * a[1]) + p * (a[2] + q * a[3]),
                 middle = (a[4] + q * a[5]) + p * (a[6] + q * a[7]);
    return s * q
           * (low + o * (middle + o * ((a[8] + q * a[9]) + p * ((a[10] + q * a[11]) + p * a[12]))));
}

/* Half the angle whose cosine is 1 - 2 q. */
static pair half_angle(double q)
{
    const double s = sqrt(q), top = leading(s);
    const double below =
        ((q - top * top) - (s - top) * (s + top)) / (s + s); /* what the root lacks */
    return sum_of_ordered(s, asin_terms(s, q) + below);
}

double hm_asin(double x)
{
    const double size = fabs(x);
    if (!(size <= 1.0)) return x != x ? x : NAN;
    if (size < 0.5) return size < 0x1p-27 ? x : x + asin_terms(x, x * x);
    if (size == 1.0) return x * PI[0].hi;
    const pair h = half_angle(0.5 * (1.0 - size)), sum = sum_of_ordered(PI[0].hi, -2.0 * h.hi);
    const double a = sum.hi + (sum.lo + (PI[0].lo - 2.0 * h.lo));
    return x < 0.0 ? -a : a;
}

double hm_acos(double x)
{
    if (!(fabs(x) <= 1.0)) return x != x ? x : NAN;
    if (x == 1.0) return 0.0;
    if (fabs(x) < 0.5) {
        const pair sum = sum_of_ordered(PI[0].hi, -x);
        return sum.hi + (sum.lo + (PI[0].lo - asin_terms(x, x * x)));
    }
    if (x > 0.0) return 2.0 * half_angle(0.5 * (1.0 - x)).hi;
    if (x == -1.0) return PI[1].hi;
    const pair h = half_angle(0.5 * (1.0 + x)), sum = sum_of_ordered(PI[1].hi, -2.0 * h.hi);
    return sum.hi + (sum.lo + (PI[1].lo - 2.0 * h.lo));
}

double hm_hypot(double x, double y)
{
    double a = fabs(x), b = fabs(y);
    if (isinf(a) || isinf(b)) return INFINITY;
    if (a != a || b != b) return x + y;
    if (a < b) { const double c = a; a = b, b = c; }
    if (b <= a * 0x1p-54) return a + b;
    double scale = 1.0;
    if (a > 0x1p500) scale = 0x1p600;
    else if (b < 0x1p-400) scale = 0x1p-600;
    a *= 1.0 / scale, b *= 1.0 / scale;
    const double ah = leading(a), bh = leading(b);
    const pair s = sum_of_ordered(ah * ah, bh * bh);
    const double below = s.lo + ((a - ah) * (a + ah) + (b - bh) * (b + bh)), r = sqrt(s.hi + below),
                 rh = leading(r);
    const double lacks = ((s.hi - rh * rh) - (r - rh) * (r + rh)) + below;
    return scale * (r + 0.5 * lacks / r);
}
