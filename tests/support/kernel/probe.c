/* A look into one step: its residual, its tangent times a direction; and a half step alone. */
#include "energy.h"
#include "half_step.h"
#include "inputs_signals.h"
#include "step.h"
#include "tangent.h"

HOLONOM_API int64_t holonom_model_bytes(void);
HOLONOM_API int32_t holonom_probe(const holonom_model *m, double *number, double *state,
                                  double *work, double h, const double *w, const double *mu,
                                  double *x, double *r, double *tx);

HOLONOM_API int32_t holonom_half_step(const holonom_model *m, double *number, double *state,
                                      double *work, double h, int32_t half);

int64_t holonom_model_bytes(void) { return (int64_t)sizeof(holonom_model); }

/* y += the product of x with p pivots from k on: their block D, and so many later places. A joint's
   rows (articulated.h) have compliances beside it. */
static void multiply_group(int32_t p, int32_t k, int32_t places, const int32_t *column,
                           const double *D, const double *epsilon, const double *x, double *y)
{
    const double *U = D + p * p, *L = U + p * places;
    const int32_t pivots = p >= LEAST_WITH_JOINT ? BODY_UNKNOWNS : p;
    for (int32_t i = 0; i < p; i++) {
        for (int32_t j = 0; j < p; j++)
            if (i < pivots || j < pivots) y[k + i] += D[p * i + j] * x[k + j];
        if (i >= pivots) y[k + i] -= epsilon[k + i] * x[k + i];
        for (int32_t l = 0; l < places; l++) {
            const int32_t at = 2 * p * (l / 2) + 2 * i + l % 2, one = p == 1 ? l : at;
            y[k + i] += U[one] * x[column[l]];
            y[column[l]] += L[one] * x[k + i];
        }
    }
}

/* Product y = A x with the unfactorised matrix; x, y in elimination order, y overwritten. */
static void multiply(const context *c, const double *epsilon, const double *x, double *y)
{
    const holonom_elimination *lu = c->factors.lu;
    const int32_t n = end_pivot(c), *column = lu->lu_column;
    for (int32_t k = 0; k < n; k++) y[k] = 0.0;
    for (int32_t k = 0, g = 0, p; k < n; k += p, g++) {
        p = has_groups(c) ? lu->lu_group[3 * g + 3] - lu->lu_group[3 * g] : 1;
        const int32_t places = has_groups(c) ? lu->lu_group[3 * g + 1]
                                             : (lu->lu_ptr[k + 1] - lu->lu_ptr[k] - 1) / 2;
        multiply_group(p, k, places, column, c->k.value + lu->lu_ptr[k], epsilon, x, y);
        column += places;
    }
}

/* Unknowns x (dim n_free, and n_rows) in elimination order, or back. */
static void order(const context *c, double *x, double *ordered, int back)
{
    const int32_t n = DIM * c->m->n_free;
    for (int32_t a = 0; a < c->m->n_free; a = next_unknown(c, a))
        for (int k = 0; k < unknown_size(c, a); k++)
            *(back ? x + DIM * a + k : ordered + c->factors.lu->node_position[a] + k) =
                back ? ordered[c->factors.lu->node_position[a] + k] : x[DIM * a + k];
    EACH_ROW(c, i)
        *(back ? x + n + i : ordered + c->factors.lu->row_position[i]) =
            back ? ordered[c->factors.lu->row_position[i]] : x[n + i];
}

/* One step of length h from `state` (not modified): residual r at the increment w = d - h v of the
   free points, turns theta of bodies in the place of those of first directors (together dim
   n_free), and multipliers mu (n_rows), r (dim n_free + n_rows, overwritten), and the tangent times
   a direction x, of spins at the end, tx (both dim n_free + n_rows; tx overwritten). Numbers of
   what is no unknown are 0. */
int32_t holonom_probe(const holonom_model *m, double *number, double *state, double *work, double h,
                      const double *w, const double *mu, double *x, double *r, double *tx)
{
    context c;
    const int32_t n = DIM * m->n_free;
    open_context(&c, m, number, state, work);
    c.h = h;
    signals_at(&c, c.t + h, c.k.signal1);
    prepare_step(&c, 0);
    for (int32_t k = 0; k < n; k++) {
        if (is_director(&c, k / DIM)) continue;
        c.k.w[k] = w[k];
        c.k.d[k] = c.k.hv[k] + w[k];
    }
    EACH_TURN(&c, b) {
        const int32_t at = DIM * m->body_node[b];
        for (int k = 0; k < TURNING; k++) c.k.turn[at + k] = w[at + k] - c.k.spun[at + k];
        turn_body(&c, m->body_node[b]);
    }
    for (int32_t i = 0; i < m->n_rows; i++) {
        c.k.mu[i] = mu[i];
        c.k.lambda[i] = 0.0;
    }
    int32_t status = evaluate_residual(&c);
    if (!status) status = assemble_tangent(&c);
    if (status) return status;
    double *in = c.k.rhs, *out = c.k.product, *epsilon = c.k.stages;
    memset(tx, 0, sizeof(double) * (size_t)(n + m->n_rows));
    memcpy(tx + n, c.k.epsilon, sizeof(double) * (size_t)m->n_rows);
    order(&c, tx, epsilon, 0);
    order(&c, x, in, 0);
    multiply(&c, epsilon, in, out);
    memset(tx, 0, sizeof(double) * (size_t)(n + m->n_rows));
    order(&c, tx, out, 1);
    memset(r, 0, sizeof(double) * (size_t)(n + m->n_rows));
    memcpy(r, c.k.momentum, sizeof(double) * (size_t)n);
    EACH_ROW(&c, i) r[n + i] = row_residual(&c, i);
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
