/* Contacts with Coulomb's friction: impulses p, or rates of impulses or forces, and rates gamma = b
   + W p with

       0 <= p_N _|_ gamma_N >= 0,      |p_T| <= mu p_N,  p_T against gamma_T where that is not 0,

   or, of a contact that slides along d already, p_T = -mu p_N d. */
#ifndef HOLONOM_CONTACT_PROBLEM_H
#define HOLONOM_CONTACT_PROBLEM_H

#include "internal.h"

#include <string.h>

typedef struct contact_problem {
    int32_t contacts, rows;
    const int32_t *first,
        *tangents; /* per contact: its normal row; rows of slip that follow it: 0 to 3 */
    const double *coefficient;       /* per contact: mu >= 0 */
    const int32_t *slides;           /* per contact: whether it slides along `way` */
    const double *way; /* rows: unit vector d at the tangents of a contact that slides */
    const double *W, *b;             /* rows x rows, may be singular; rows */
    double *p, *rate;                /* rows, overwritten: p, gamma */
    double *scratch;                 /* CONTACT_SCRATCH(rows) doubles */
    double least_size; /* weighted rate below which none counts as large: of b that is a small rest
                          of larger terms, else 0 */
    int32_t several;   /* overwritten: whether there are several solutions with different rates */
} contact_problem;

#define FITS 1e-10            /* part of the largest rate by which inequalities may be missed */

/* Parts of the scratch; rows each, the matrices rows x rows. */
typedef struct contact_parts {
    double *matrix, *columns, *basis;
    double *weight; /* 1/sqrt of the stiffness of each row: impulses over it, and rates times it,
                       are the root of an energy */
    double *defect, *change, *rhs, *kept, *head; /* head: 3 a row */
    double *mu, *slope;        /* slope: 16 a row */
    int32_t *order, *digit;    /* two a row each */
} contact_parts;

static inline contact_parts contact_map(const contact_problem *x)
{
    const int64_t n = x->rows;
    double *s = x->scratch, *v = s + 3 * n * n;
    return (contact_parts){s,
                           s + n * n,
                           s + 2 * n * n,
                           v,
                           v + n,
                           v + 2 * n,
                           v + 3 * n,
                           v + 4 * n,
                           v + 5 * n,
                           v + 8 * n,
                           v + 9 * n,
                           (int32_t *)(void *)(v + 25 * n),
                           (int32_t *)(void *)(v + 26 * n)};
}

static inline int32_t slips_of(const contact_problem *x, int32_t i)
{ return x->coefficient[i] > 0.0 ? x->tangents[i] : 0; }

/* Whether contact i may stick: it has friction and does not slide yet. */
static inline int may_stick(const contact_problem *x, int32_t i)
{ return slips_of(x, i) > 0 && !x->slides[i]; }

HM_SELDOM static void contact_rates(const contact_problem *x)
{
    for (int32_t k = 0; k < x->rows; k++) {
        double sum = x->b[k];
        for (int32_t j = 0; j < x->rows; j++) sum += x->W[(int64_t)k * x->rows + j] * x->p[j];
        x->rate[k] = sum;
    }
}

/* p . W p */
static inline double work_of_solution(const contact_problem *x)
{
    double sum = 0.0;
    for (int32_t k = 0; k < x->rows; k++) sum += x->p[k] * (x->rate[k] - x->b[k]);
    return sum;
}

static inline int has_friction(const contact_problem *x)
{
    for (int32_t i = 0; i < x->contacts; i++)
        if (slips_of(x, i)) return 1;
    return 0;
}

/* Weights of rows, and the largest weighted rate without impulses. The tangents of a contact share
   one, so that cones stay round. */
HM_SELDOM static double weigh_rows(const contact_problem *x, const contact_parts *s)
{
    double size = x->least_size;
    for (int32_t i = 0; i < x->contacts; i++) {
        double stiffness = 0.0;
        const int32_t k = x->first[i];
        for (int32_t r = k + 1; r <= k + x->tangents[i]; r++)
            stiffness += x->W[(int64_t)r * x->rows + r];
        for (int32_t r = k; r <= k + x->tangents[i]; r++) {
            const double w = r == k ? x->W[(int64_t)k * x->rows + k] : stiffness;
            s->weight[r] = w > 0.0 ? 1.0 / sqrt(w) : 0.0;
            size = fmax(size, fabs(x->b[r]) * s->weight[r]);
        }
    }
    return size;
}

#endif
