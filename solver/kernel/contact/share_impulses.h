/* Impulses that redundant contacts leave open: those of the least size, |p|^2 weighted with W_NN of
   each contact, among the impulses with the rates of a solution, as if all yielded alike. */
#ifndef HOLONOM_SHARE_IMPULSES_H
#define HOLONOM_SHARE_IMPULSES_H

#include "contact_problem.h"
#include "least_squares.h"
#include "rest_split.h"

#define REDUNDANT 1e-10 /* pivot of a matrix with diagonal 1, below which a row is redundant */

/* A contact in the split: it parts, stays on its ray, or may be anywhere in its cone. */
enum { FACE_PARTS, FACE_RAY, FACE_CONE };

HM_SELDOM static int face_of(const contact_problem *x, const contact_parts *s, int32_t i,
                             double size, double *way)
{
    const int32_t k = x->first[i], n = slips_of(x, i);
    if (x->rate[k] * s->weight[k] > FITS * size) return FACE_PARTS;
    if (n == 0) return FACE_RAY;
    const double slip = hm_length(n, x->rate + k + 1);
    for (int32_t a = 0; a < n; a++)
        way[a] = x->slides[i] ? x->way[k + 1 + a] : slip > 0.0 ? x->rate[k + 1 + a] / slip : 0.0;
    return x->slides[i] || slip * s->weight[k + 1] > FITS * size ? FACE_RAY : FACE_CONE;
}

/* Takes the new impulses, z times `norm` from the column `at` of each contact on, unless they
   change rates. */
HM_SELDOM static void take_shared(const contact_problem *x, const contact_parts *s,
                                  const int32_t *at, const double *z, double norm, double size)
{
    const int32_t m = x->rows;
    double way[3], largest = 0.0;
    memcpy(s->kept, x->p, sizeof(double) * (size_t)m);
    memcpy(s->change, x->rate, sizeof(double) * (size_t)m);
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = slips_of(x, i);
        const int face = face_of(x, s, i, size, way);
        for (int32_t a = 0; a <= x->tangents[i]; a++) s->defect[k + a] = 0.0;
        if (at[i] < 0) continue;
        for (int32_t a = 0; a <= (face == FACE_CONE ? n : 0); a++)
            s->defect[k + a] = z[at[i] + a] * norm * s->weight[k];
        for (int32_t a = 1; a <= n && face == FACE_RAY; a++)
            s->defect[k + a] = -x->coefficient[i] * way[a - 1] * s->defect[k];
    }
    memcpy(x->p, s->defect, sizeof(double) * (size_t)m);
    contact_rates(x);
    for (int32_t k = 0; k < m; k++) {
        double terms = fabs(x->b[k]);
        for (int32_t j = 0; j < m; j++) terms += fabs(x->W[(int64_t)k * m + j] * x->p[j]);
        largest = fmax(largest, (fabs(x->rate[k] - s->change[k]) - 1e-11 * terms) * s->weight[k]);
    }
    if (!(largest <= 0.0)) memcpy(x->p, s->kept, sizeof(double) * (size_t)m);
    contact_rates(x);
}

/* Impulses of the least size with the same rates: a split (rest_split.h) with B of orthonormal rows
   that span those of W. Those of a solution stay if none is found. */
HM_SELDOM static void hm_share_impulses(const contact_problem *x)
{
    const contact_parts s = contact_map(x);
    const double size = weigh_rows(x, &s);
    const int32_t m = x->rows;
    int32_t *at = s.digit, count = 0; /* first column of each contact, or -1 */
    int32_t *first = s.order + m, *tangents = s.digit + m;
    double *coefficient = s.slope;
    for (int32_t r = 0; r < m; r++)
        for (int32_t c = 0; c < m; c++)
            s.columns[r * m + c] = x->W[(int64_t)r * m + c] * s.weight[r] * s.weight[c];
    if (hm_triangulate(m, m, s.columns, s.head, s.order, REDUNDANT) == m) return;
    contact_rates(x);
    double way[3];
    for (int32_t i = 0; i < x->contacts; i++) {
        const int face = face_of(x, &s, i, size, way);
        at[i] = face == FACE_PARTS ? -1 : count;
        count += face == FACE_PARTS ? 0 : face == FACE_RAY ? 1 : 1 + slips_of(x, i);
    }
    if (count == 0) return;
    /* Rows of A' are what each unknown does to the weighted rates. */
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = slips_of(x, i);
        if (at[i] < 0) continue;
        const int face = face_of(x, &s, i, size, way);
        for (int32_t a = 0; a <= (face == FACE_CONE ? n : 0); a++)
            for (int32_t r = 0; r < m; r++) {
                double sum = x->W[(int64_t)r * m + k + a];
                for (int32_t t = 0; t < n && face == FACE_RAY; t++)
                    sum -= x->coefficient[i] * way[t] * x->W[(int64_t)r * m + k + 1 + t];
                s.columns[(at[i] + a) * m + r] = sum * s.weight[r] * s.weight[k];
            }
    }
    const int32_t rank = hm_triangulate(count, m, s.columns, s.head, s.order, REDUNDANT);
    double *g = s.kept, *z = s.rhs, norm = 0.0;
    for (int32_t j = 0; j < rank; j++) { /* R' g = the rates, in the order of the columns */
        double sum = (x->rate[s.order[j]] - x->b[s.order[j]]) * s.weight[s.order[j]];
        for (int32_t e = 0; e < j; e++) sum -= s.columns[e * m + j] * g[e];
        g[j] = sum / s.columns[j * m + j];
        norm += g[j] * g[j];
    }
    norm = sqrt(norm);
    if (!(norm > 0.0)) return;
    for (int32_t j = 0; j < rank; j++) g[j] /= norm;
    double *B = s.basis; /* rank x count */
    for (int32_t j = 0; j < rank; j++) {
        for (int32_t e = 0; e < count; e++) s.change[e] = e == j ? 1.0 : 0.0;
        hm_reflect(count, m, rank, s.columns, s.head, 1, s.change);
        for (int32_t e = 0; e < count; e++) B[j * count + e] = s.change[e];
    }
    rest_split split = {.rows = count,
                        .rank = rank,
                        .first = first,
                        .tangents = tangents,
                        .coefficient = coefficient,
                        .B = B,
                        .g = g,
                        .force = z,
                        .base = s.slope + 2 * m,
                        .dual = s.defect,
                        .way = s.change,
                        .defect = s.mu,
                        .trial = s.slope + m,
                        .matrix = s.matrix};
    for (int32_t i = 0; i < x->contacts; i++) {
        if (at[i] < 0) continue;
        first[split.contacts] = at[i];
        tangents[split.contacts] = face_of(x, &s, i, size, way) == FACE_CONE ? slips_of(x, i) : 0;
        coefficient[split.contacts++] = x->coefficient[i];
    }
    if (!has_split(&split, 1.0)) return;
    take_shared(x, &s, at, z, norm, size);
}

#endif
