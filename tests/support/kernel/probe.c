/* A look into one step: its residual, its tangent times a direction; and a half step alone. */
#include "energy.h"
#include "half_step.h"
#include "inputs_signals.h"
#include "step.h"
#include "tangent.h"

HOLONOM_API int64_t holonom_model_bytes(void);
HOLONOM_API int32_t holonom_probe(const holonom_model *m, double *number, double *state,
                                  double *work, double h, const double *w, const double *mu,
                                  const double *x, double *r, double *tx);

HOLONOM_API int32_t holonom_half_step(const holonom_model *m, double *number, double *state,
                                      double *work, double h, int32_t half);

int64_t holonom_model_bytes(void) { return (int64_t)sizeof(holonom_model); }

/* Product y = A x with the unfactorised matrix; x, y (n) in elimination order, y overwritten. */
static void multiply(int32_t n, const int32_t *ptr, const int32_t *column, const double *value,
                     const double *x, double *y)
{
    for (int32_t k = 0; k < n; k++) y[k] = 0.0;
    for (int32_t k = 0; k < n; k++) {
        const int32_t m = (ptr[k + 1] - ptr[k] - 1) / 2;
        const double *upper = value + ptr[k] + 1, *lower = upper + m;
        y[k] += value[ptr[k]] * x[k];
        for (int32_t i = 0; i < m; i++) {
            y[k] += upper[i] * x[column[i]];
            y[column[i]] += lower[i] * x[k];
        }
        column += m;
    }
}

/* One step of length h from `state` (not modified): residual r at the increment
   w = d - h v of the free nodes (dim n_free) and multipliers mu (n_rows), r (dim n_free + n_rows,
   overwritten), and the tangent times a direction x, tx (both dim n_free + n_rows; tx
   overwritten). */
int32_t holonom_probe(const holonom_model *m, double *number, double *state, double *work, double h,
                      const double *w, const double *mu, const double *x, double *r, double *tx)
{
    context c;
    const int32_t n = DIM * m->n_free, size = n + m->n_rows;
    open_context(&c, m, number, state, work);
    c.h = h;
    signals_at(&c, c.t + h, c.k.signal1);
    prepare_step(&c, 0);
    for (int32_t k = 0; k < n; k++) {
        c.k.w[k] = w[k];
        c.k.d[k] = c.k.hv[k] + w[k];
    }
    for (int32_t i = 0; i < m->n_rows; i++) {
        c.k.mu[i] = mu[i];
        c.k.lambda[i] = 0.0;
    }
    int32_t status = evaluate_residual(&c);
    if (!status) status = assemble_tangent(&c);
    if (status) return status;
    double *in = c.k.rhs, *out = c.k.product;
    for (int32_t k = 0; k < n; k++) in[m->full.node_position[k / DIM] + k % DIM] = x[k];
    for (int32_t i = 0; i < m->n_rows; i++) in[m->full.row_position[i]] = x[n + i];
    multiply(size, m->full.lu_ptr, m->full.lu_column, c.k.value, in, out);
    for (int32_t k = 0; k < n; k++) tx[k] = out[m->full.node_position[k / DIM] + k % DIM];
    for (int32_t i = 0; i < m->n_rows; i++) tx[n + i] = out[m->full.row_position[i]];
    memcpy(r, c.k.momentum, sizeof(double) * (size_t)n);
    for (int32_t i = 0; i < m->n_rows; i++) r[n + i] = row_residual(&c, i);
    return HOLONOM_OK;
}

/* Half step 0 or 1 of a pair, of length h [s]; `state` (modified) is that between the two where it
   was half step 0. */
int32_t holonom_half_step(const holonom_model *m, double *number, double *state, double *work,
                          double h, int32_t half)
{
    context c;
    open_context(&c, m, number, state, work);
    begin_halves(&c, 2);
    const int32_t status = single_step(&c, h, half);
    if (status) return status;
    if (m->time_dependent) set_laws(&c, c.t, 1);
    c.s.head[S_TIME] = c.t;
    follow_energies(&c);
    return HOLONOM_OK;
}
