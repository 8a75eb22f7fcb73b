/* Motions of the islands at hand as one rigid body, and their momenta. */
#ifndef HOLONOM_RIGID_H
#define HOLONOM_RIGID_H

#include "context.h"

enum { RIGID = DIM + TURNING };

/* Arm of node a: a direction, or the place of a point from `centre`. */
HM_OFTEN void arm_of(const context *c, const double *centre, int32_t a, double *x)
{
    EACH(k) x[k] = c->s.q[DIM * a + k] - (c->m->node_kind[a] ? 0.0 : centre[k]);
}

/* Velocity at node a of islands moving as one rigid body: along axis i < DIM, or about an axis at
   `centre`. */
static void rigid_velocity(const context *c, const double *centre, int i, int32_t a, double *xi)
{
    double x[DIM];
    EACH(k) xi[k] = 0.0;
    if (i < DIM) {
        xi[i] = c->m->node_kind[a] ? 0.0 : 1.0;
        return;
    }
    arm_of(c, centre, a, x);
#if DIM == 2
    xi[0] = -x[1];
    xi[1] = x[0];
#else
    const int first = (i - DIM + 1) % 3, second = (i - DIM + 2) % 3;
    xi[first] = -x[second];
    xi[second] = x[first];
#endif
}

/* Those momenta of the islands at hand that are kept, from those of their nodes, and the sums of
   their terms' sizes. */
static void rigid_momenta(const context *c, const double *centre, const int *kept, const double *p,
                          double *total, double *size)
{
    for (int i = 0; i < RIGID; i++) {
        total[i] = size[i] = 0.0;
        if (!kept[i]) continue;
        const int first = (i + DIM - 2) % DIM, second = (i + DIM - 1) % DIM;
        double sum = 0.0, sizes = 0.0;
        for (int32_t k = DIM * c->view.node.begin; k < DIM * c->view.node.end; k += DIM) {
            const double *own = p + k;
            double x[DIM], one, other = 0.0;
            if (i < DIM) {
                if (c->m->node_kind[k / DIM]) continue;
                one = own[i];
            } else {
                arm_of(c, centre, k / DIM, x);
                one = x[first] * own[second];
                other = x[second] * own[first];
            }
            sum += one - other;
            sizes += fabs(one) + fabs(other);
        }
        total[i] = sum;
        size[i] = sizes;
    }
}

/* x'My over the mass matrix of the islands at hand. */
static double mass_product(const context *c, const double *x, const double *y)
{
    double sum = 0.0;
    for IN_ISLAND(c, e, ISLAND_MASS)
    sum += c->number[c->m->mass_at + e]
           * dot(x + DIM * c->m->mass_node[2 * e], y + DIM * c->m->mass_node[2 * e + 1]);
    return sum;
}

/* Rigid motions' mass matrix xi_i'M xi_j of those that are kept, as its Cholesky factor; 0 on the
   diagonal leaves a motion out, which the others contain. */
static void factor_rigid(const context *c, const double *centre, const int *kept,
                         double L[RIGID][RIGID])
{
    const holonom_model *m = c->m;
    double x[RIGID][DIM], y[RIGID][DIM], K[RIGID][RIGID] = {{0.0}};
    for IN_ISLAND(c, e, ISLAND_MASS)
        for (int i = 0; i < RIGID; i++) {
            if (!kept[i]) continue;
            rigid_velocity(c, centre, i, m->mass_node[2 * e], x[i]);
            rigid_velocity(c, centre, i, m->mass_node[2 * e + 1], y[i]);
            for (int j = 0; j <= i; j++)
                if (kept[j]) K[i][j] += c->number[m->mass_at + e] * dot(x[i], y[j]);
        }
    for (int i = 0; i < RIGID; i++)
        for (int j = 0; j <= i; j++) {
            double sum = K[i][j];
            L[i][j] = 0.0;
            if (!kept[i] || !kept[j]) continue;
            for (int k = 0; k < j; k++) sum -= L[i][k] * L[j][k];
            if (i == j) L[i][i] = sum > 1e-10 * K[i][i] ? sqrt(sum) : 0.0;
            else L[i][j] = L[j][j] > 0.0 ? sum / L[j][j] : 0.0;
        }
}

/* Momenta b of rigid motions become the velocities of these. */
static void solve_rigid(double L[RIGID][RIGID], double *b)
{
    for (int i = 0; i < RIGID; i++) {
        for (int k = 0; k < i && L[i][i] > 0.0; k++) b[i] -= L[i][k] * b[k];
        b[i] = L[i][i] > 0.0 ? b[i] / L[i][i] : 0.0;
    }
    for (int i = RIGID - 1; i >= 0; i--) {
        if (!(L[i][i] > 0.0)) continue; /* it is left out, and 0 */
        for (int k = i + 1; k < RIGID; k++) b[i] -= L[k][i] * b[k];
        b[i] /= L[i][i];
    }
}

/* Adds to velocities x the rigid motion of momenta b (modified) in the kept directions. */
static void add_rigid(const context *c, const double *centre, double L[RIGID][RIGID], double *b,
                      double *x)
{
    double xi[DIM];
    solve_rigid(L, b);
    for (int i = 0; i < RIGID; i++)
        for (int32_t a = c->view.node.begin; a < c->view.node.end && b[i] != 0.0; a++) {
            rigid_velocity(c, centre, i, a, xi);
            EACH(k) x[DIM * a + k] += b[i] * xi[k];
        }
}

#endif
