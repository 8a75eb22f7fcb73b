/* What the files of the kernel share and nobody else sees. */
#ifndef HOLONOM_INTERNAL_H
#define HOLONOM_INTERNAL_H

#include "holonom.h"

void hm_run_tape(const holonom_model *model, double *numbers, int32_t segment);

int32_t hm_lu_factor(int32_t n, const int32_t *ptr, const int32_t *target, double *value);
void hm_lu_solve(int32_t n, const int32_t *ptr, const int32_t *column, const double *value, double *x);
void hm_lu_multiply(int32_t n, const int32_t *ptr, const int32_t *column, const double *value, const double *x,
                    double *y);

/* Sum with the rounding error kept: (*high + *low) += x to about twice the precision (Dekker 1971, Knuth). */
static inline void hm_add(double *high, double *low, double x)
{
    const double a = *high, y = x + *low;
    const double s = a + y, t = s - a;
    *low = (a - (s - t)) + (y - t);
    *high = s;
}

/* (*high + *low) += a b to about twice the precision, for terms of any size (Dekker 1971; Veltkamp's split rather
   than fma, which is a call where the processor is not known to have it). */
static inline void hm_add_product(double *high, double *low, double a, double b)
{
    const double product = a * b, s = *high + product, t = s - *high;
    *low += (*high - (s - t)) + (product - t);
    *high = s;
    if (a == 1.0 || a == -1.0) return; /* the product is exact */
    const double a_far = 134217729.0 * a, b_far = 134217729.0 * b; /* 2^27 + 1 */
    const double a_high = a_far - (a_far - a), b_high = b_far - (b_far - b);
    const double a_low = a - a_high, b_low = b - b_high;
    *low += ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

/* Vectors of a state behind its head. */
typedef struct hm_state {
    double *head;
    double *q, *q_low, *v, *v_low; /* n each: coordinates and velocities, with what rounding left over       */
    double *a[2];                  /* n each: last 2 (d - h v)/h^2 of the first and the second half of a pair */
    double *mu[2];                 /* n_rows each: last multipliers, likewise                                 */
    double *mean, *mean_before;    /* n_rows each: means of the last two multipliers, and those before them    */
    double *turns;                 /* n_angles: full turns so far                                             */
    double *inputs, *parameters;
} hm_state;

/* Scratch of one step: nothing in it survives the step. */
typedef struct hm_work {
    double *u0, *w0;      /* dim n_forms each: links at the beginning of the step                           */
    double *phi0, *phi;   /* n_rows: rows at the beginning, and the row function that shall vanish            */
    double *lambda, *mu;  /* n_rows: multiplier held fixed, total multiplier                                */
    double *epsilon;      /* n_rows: compliance 2/alpha or 1/alpha                                          */
    double *hv, *w, *d;   /* n: h v, unknown d - h v, increment d                                           */
    double *momentum;     /* n: residual of the momentum balance                                            */
    double *constraint;   /* n_rows: residual of the rows                                                   */
    double *rhs;          /* n + n_rows, elimination order                                                  */
    double *value;        /* n_lu_values: tangent and its factors                                           */
    double *step_backup, *pair_backup; /* state size each                                                   */
} hm_work;

/* Lays the named vectors over one block; each returns the number of doubles used. */
int64_t hm_map_state(const holonom_model *model, double *block, hm_state *state);
int64_t hm_map_work(const holonom_model *model, double *block, hm_work *work);

/* One set of functions a dimension. */
#define HM_DECLARE(suffix)                                                                                     \
    int32_t hm_initialise_##suffix(const holonom_model *, double *, double *, double *);                       \
    int32_t hm_advance_##suffix(const holonom_model *, double *, double *, double *, double);                  \
    void hm_residuals_##suffix(const holonom_model *, const double *, double *, double *, double *, double *); \
    void hm_set_inputs_##suffix(const holonom_model *, double *, double *, double *, const double *,           \
                                const double *);                                                               \
    void hm_measure_##suffix(const holonom_model *, double *, double *, double *);                             \
    int32_t hm_probe_##suffix(const holonom_model *, double *, double *, double *, double, const double *,     \
                              const double *, const double *, double *, double *);
HM_DECLARE(planar)
HM_DECLARE(spatial)

#endif
