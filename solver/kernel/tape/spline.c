/* Curves of profiles: polynomials of degree 4 at most in pieces, continuous. What takes the slope
   of a derivative across pieces needs that to be continuous as well.

   A table of numbers is the period, 0 for none, then rows (x_k, c_0, ..., c_4) that mean sum_j c_j
   (x - x_k)^j from x_k on: first the continuation to the left, which has the x_0 of the row behind
   it, last that to the right. */
#include "internal.h"

enum { ROW = 6, DEGREE = 4 };

typedef struct spot {
    double x, turns; /* within the table, and the periods left out */
    int32_t row;
} spot;

/* Whatever the table holds, the row is one of its rows. */
static spot spot_of(double x, const double *row, int32_t count, double period)
{
    spot at = {x, period > 0.0 ? floor((x - row[0]) / period) : 0.0, 0};
    if (at.turns != 0.0) at.x -= at.turns * period;
    for (int32_t end = count; end - at.row > 1;) {
        const int32_t middle = (at.row + end) / 2;
        if (at.x >= row[ROW * middle]) at.row = middle;
        else end = middle;
    }
    return at;
}

/* Coefficients of a derivative of a row. */
static void derive(const double *row, int order, double *c)
{
    for (int j = 0; j <= DEGREE; j++) c[j] = row[1 + j];
    for (; order > 0; order--) {
        for (int j = 0; j < DEGREE; j++) c[j] = (j + 1) * c[j + 1];
        c[DEGREE] = 0.0;
    }
}

/* A derivative of a row at x. */
HM_OFTEN double value_in_row(const double *row, int order, double x)
{
    double c[DEGREE + 1], value = 0.0;
    derive(row, order, c);
    for (int j = DEGREE; j >= 0; j--) value = value * (x - row[0]) + c[j];
    return value;
}

double hm_spline(int order, double x, const double *first, const double *last)
{
    const spot at = spot_of(x, first + 1, (int32_t)((last - first) / ROW), *first);
    return value_in_row(first + 1 + ROW * at.row, order, at.x);
}

/* A spot at the beginning of a row becomes the end of the row before; in a period that before the
   first is the last. */
static spot spot_before(spot at, const double *row, int32_t count, double period)
{
    if (at.row == 0 || at.x != row[ROW * at.row]) return at;
    if (period > 0.0 && at.row == 1)
        return (spot){row[ROW * (count - 1)], at.turns - 1.0, count - 2};
    return (spot){at.x, at.turns, at.row - 1};
}

void hm_spline_derivatives(int order, double x, int falls, const double *first, const double *last,
                           double *found)
{
    const double *row = first + 1, period = *first;
    const int32_t count = (int32_t)((last - first) / ROW);
    spot at = spot_of(x, row, count, period);
    if (falls) at = spot_before(at, row, count, period);
    for (int k = 0; k < 3; k++) found[k] = value_in_row(row + ROW * at.row, order + k, at.x);
}

/* (p(x1) - p(x0))/(x1 - x0) of one row: p = p(x0) + (x - x0) q, and q at x1, both by Horner's
   rule. */
static double row_slope(const double *row, int order, double x0, double x1)
{
    double c[DEGREE + 1], b = 0.0, q = 0.0;
    derive(row, order, c);
    for (int j = DEGREE; j > 0; j--) {
        b = b * (x0 - row[0]) + c[j];
        q = q * (x1 - row[0]) + b;
    }
    return q;
}

/* Adds length and change from one spot to another that lies behind it in the table, row by row. */
static void add_span(const double *row, int order, spot from, spot to, double *length,
                     double *change)
{
    for (int32_t k = from.row; k <= to.row; k++) {
        const double x0 = k == from.row ? from.x : row[ROW * k],
                     x1 = k == to.row ? to.x : row[ROW * (k + 1)];
        *length += x1 - x0;
        *change += (x1 - x0) * row_slope(row + ROW * k, order, x0, x1);
    }
}

double hm_spline_slope(int order, double x0, double x1, const double *first, const double *last)
{
    const double *row = first + 1, period = *first;
    const int32_t count = (int32_t)((last - first) / ROW);
    const spot from = spot_of(x0 < x1 ? x0 : x1, row, count, period),
               to = spot_of(x0 < x1 ? x1 : x0, row, count, period);
    const double turns = to.turns - from.turns;
    double length = 0.0, change = 0.0;
    if (turns == 0.0 && from.row == to.row)
        return row_slope(row + ROW * to.row, order, from.x, to.x);
    if (turns > 0.0 && count > 2) { /* to the end of the period, then from its beginning; whole
                                       periods change nothing */
        add_span(row, order, from, (spot){row[ROW * (count - 1)], 0.0, count - 2}, &length,
                 &change);
        add_span(row, order, (spot){row[ROW], 0.0, 1}, to, &length, &change);
        length += (turns - 1.0) * period;
    } else {
        add_span(row, order, from, to, &length, &change);
    }
    return length != 0.0 ? change / length : row_slope(row + ROW * to.row, order, to.x, to.x);
}

/* Bounds of a derivative of a row between u0 and u1, from its beginning: by Taylor's series about
   the middle. */
static void widen_by_row(const double *row, int order, double x0, double x1, double *found)
{
    const double middle = 0.5 * (x0 + x1), half = 0.5 * (x1 - x0);
    double way = 1.0, wide = 0.0;
    const double value = value_in_row(row, order, middle);
    for (int j = 1; j <= DEGREE; j++) {
        way *= half / j;
        wide += way * fabs(value_in_row(row, order + j, middle));
    }
    if (!(value - wide >= found[0])) found[0] = value - wide;
    if (!(value + wide <= found[1])) found[1] = value + wide;
}

void hm_spline_range(int order, double low, double high, const double *first, const double *last,
                     double *found)
{
    const double *row = first + 1, period = *first;
    const int32_t count = (int32_t)((last - first) / ROW);
    found[0] = INFINITY, found[1] = -INFINITY;
    if (!(low > -INFINITY && high < INFINITY)) {
        found[0] = -INFINITY, found[1] = INFINITY;
        return;
    }
    const spot from = spot_of(low, row, count, period), to = spot_of(high, row, count, period);
    const double turns = to.turns - from.turns;
    for (int32_t k = 0; k < count;
         k++) { /* between both, or behind the first and before the last one, in another period */
        const double begin = k ? row[ROW * k] : -INFINITY,
                     end = k + 1 < count ? row[ROW * (k + 1)] : INFINITY;
        const int is_within = k > 0 && k + 1 < count;
        if (turns == 0.0 && k >= from.row && k <= to.row)
            widen_by_row(row + ROW * k, order, fmax(begin, from.x), fmin(end, to.x), found);
        if (turns > 1.0 && is_within) widen_by_row(row + ROW * k, order, begin, end, found);
        if (turns == 1.0 && is_within && k >= from.row)
            widen_by_row(row + ROW * k, order, fmax(begin, from.x), end, found);
        if (turns == 1.0 && is_within && k <= to.row)
            widen_by_row(row + ROW * k, order, begin, fmin(end, to.x), found);
    }
}
