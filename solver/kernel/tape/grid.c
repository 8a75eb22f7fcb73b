/* Cubic B-splines over a grid of cubes, of three coordinates, with continuous second derivatives.

   A table of numbers is the origin (3), the length of a cube, the numbers of coefficients n along
   each axis (3), and the coefficients, the last index first. Coefficient (i, j, k) belongs to the
   origin plus i - 1, j - 1, k - 1 cubes, so that the spline stands from the origin to n - 3 cubes
   along each axis; beyond, the polynomials of the last cubes go on. */
#include "small.h"

#include "internal.h"

enum { HEADING = 7, AXES = 3, SUPPORT = 4, NODES = 5 };

#define MOST 4096.0 /* coefficients along an axis */

typedef struct grid {
    const double *origin, *coefficient;
    double spacing;
    int32_t count[AXES];
} grid;

/* Whether the table has as many coefficients as it says. */
static int is_grid(const double *first, const double *last, grid *g)
{
    int64_t total = 1;
    g->origin = first;
    g->spacing = first[AXES];
    g->coefficient = first + HEADING;
    for (int a = 0; a < AXES; a++) {
        const double n = first[AXES + 1 + a];
        if (!(n >= SUPPORT && n <= MOST)) return 0;
        g->count[a] = (int32_t)n;
        total *= g->count[a];
    }
    return total == last - first + 1 - HEADING;
}

/* A place in cubes from the origin, and its cube. */
static void locate(const grid *g, const double *x, double *u, int32_t *cube)
{
    for (int a = 0; a < AXES; a++) {
        const int32_t end = g->count[a] - SUPPORT;
        u[a] = (x[a] - g->origin[a]) / g->spacing;
        cube[a] = u[a] >= 1.0 ? (u[a] < end ? (int32_t)u[a] : end) : 0;
    }
}

/* A derivative of the four B-splines that a cube has, at t of its length. */
static void weigh_splines(int order, double t, double *w)
{
    const double s = 1.0 - t;
    if (order == 0) {
        w[0] = s * s * s / 6.0;
        w[1] = 2.0 / 3.0 - t * t * (1.0 - 0.5 * t);
        w[2] = 2.0 / 3.0 - s * s * (1.0 - 0.5 * s);
        w[3] = t * t * t / 6.0;
    } else if (order == 1) {
        w[0] = -0.5 * s * s;
        w[1] = t * (1.5 * t - 2.0);
        w[2] = s * (2.0 - 1.5 * s);
        w[3] = 0.5 * t * t;
    } else if (order == 2) {
        w[0] = s;
        w[1] = 3.0 * t - 2.0;
        w[2] = 3.0 * s - 2.0;
        w[3] = t;
    } else {
        w[0] = -1.0;
        w[1] = 3.0;
        w[2] = -3.0;
        w[3] = 1.0;
    }
}

/* Derivative of a cube's polynomial, per cube, of these orders along the axes. */
static double partial(const grid *g, const int *order, const int32_t *cube, const double *u)
{
    double w[AXES][SUPPORT], sum = 0.0;
    for (int a = 0; a < AXES; a++) weigh_splines(order[a], u[a] - cube[a], w[a]);
    for (int i = 0; i < SUPPORT; i++)
        for (int j = 0; j < SUPPORT; j++) {
            const double *c = g->coefficient
                              + ((int64_t)(cube[0] + i) * g->count[1] + cube[1] + j) * g->count[2]
                              + cube[2];
            for (int k = 0; k < SUPPORT; k++) sum += w[0][i] * w[1][j] * w[2][k] * c[k];
        }
    return sum;
}

/* Value and three slopes, per cube, of the polynomial of a cube, or of its derivative along `axis`
   (from 0). */
static void of_cube(const grid *g, int axis, const int32_t *cube, const double *u, double *found)
{
    double w[AXES][2][SUPPORT];
    for (int a = 0; a < AXES; a++)
        for (int slope = 0; slope < 2; slope++)
            weigh_splines((a == axis) + slope, u[a] - cube[a], w[a][slope]);
    for (int i = 0; i <= AXES; i++) found[i] = 0.0;
    for (int i = 0; i < SUPPORT; i++) {
        double value = 0.0, along_y = 0.0, along_z = 0.0;
        for (int j = 0; j < SUPPORT; j++) {
            const double *c = g->coefficient
                              + ((int64_t)(cube[0] + i) * g->count[1] + cube[1] + j) * g->count[2]
                              + cube[2];
            const double *z = w[2][0], *dz = w[2][1];
            const double line = z[0] * c[0] + z[1] * c[1] + z[2] * c[2] + z[3] * c[3];
            value += w[1][0][j] * line;
            along_y += w[1][1][j] * line;
            along_z += w[1][0][j] * (dz[0] * c[0] + dz[1] * c[1] + dz[2] * c[2] + dz[3] * c[3]);
        }
        found[0] += w[0][0][i] * value;
        found[1] += w[0][1][i] * value;
        found[2] += w[0][0][i] * along_y;
        found[3] += w[0][0][i] * along_z;
    }
}

double hm_grid(int derivative, const double *x, const double *first, const double *last)
{
    grid g;
    double u[AXES], found[1 + AXES];
    int32_t cube[AXES];
    if (!is_grid(first, last, &g)) return NAN;
    locate(&g, x, u, cube);
    of_cube(&g, derivative - 1, cube, u, found);
    return derivative ? found[0] / g.spacing : found[0];
}

hm_jet hm_grid_jet(int derivative, const hm_jet *x, const double *first, const double *last)
{
    grid g;
    double place[AXES], u[AXES];
    int32_t cube[AXES];
    hm_jet y = {NAN, NAN, NAN};
    if (!is_grid(first, last, &g)) return y;
    for (int a = 0; a < AXES; a++) place[a] = x[a].value;
    locate(&g, place, u, cube);
    for (int a = 0; a < AXES; a++)
        cube[a] -= cube[a] > 0 && u[a] == cube[a] && hm_falls(x[a]); /* the cube that x comes to */
    const double unit = derivative ? 1.0 / g.spacing : 1.0, per = 1.0 / g.spacing;
    int order[AXES] = {derivative == 1, derivative == 2, derivative == 3};
    y = (hm_jet){unit * partial(&g, order, cube, u), 0.0, 0.0};
    for (int a = 0; a < AXES; a++) {
        order[a]++;
        const double slope = unit * per * partial(&g, order, cube, u);
        y.rate += slope * x[a].rate;
        y.bend += slope * x[a].bend;
        for (int b = 0; b < AXES; b++) {
            order[b]++;
            y.bend += unit * per * per * partial(&g, order, cube, u) * x[a].rate * x[b].rate;
            order[b]--;
        }
        order[a]--;
    }
    return y;
}

/* The mean of the gradient along the straight line from x0 to x1: cube by cube, where the spline is
   a polynomial of degree 9 along the line, by Gauss's five nodes, which are exact for it. So sum
   slope dx is the difference of the values, though no difference is taken (averaged vector field,
   Quispel and McLaren 2008). */
void hm_grid_slopes(int derivative, const double *x0, const double *x1, const double *first,
                    const double *last, double *slope)
{
    static const double node[NODES] = {0.04691007703066800, 0.23076534494715845, 0.5,
                                       0.76923465505284155, 0.95308992296933200};
    static const double weight[NODES] = {0.11846344252809454, 0.23931433524968324,
                                         0.28444444444444444, 0.23931433524968324,
                                         0.11846344252809454};
    grid g;
    double u0[AXES], u1[AXES], d[AXES], from = 0.0, sum[AXES] = {0.0, 0.0, 0.0};
    int32_t cube[AXES], last_cube[AXES];
    for (int a = 0; a < AXES; a++) slope[a] = NAN;
    if (!is_grid(first, last, &g)) return;
    locate(&g, x1, u1, last_cube);
    locate(&g, x0, u0, cube);
    for (int a = 0; a < AXES; a++) d[a] = u1[a] - u0[a];
    const int rests = d[0] == 0.0 && d[1] == 0.0 && d[2] == 0.0;
    for (int next = 0; next >= 0;) {
        double to = 1.0, u[AXES], found[1 + AXES];
        next = -1; /* the axis along which the line leaves the cube first */
        for (int a = 0; a < AXES; a++) {
            if (cube[a] == last_cube[a]) continue;
            const double leaves = (cube[a] + (cube[a] < last_cube[a]) - u0[a]) / d[a];
            if (next < 0 || leaves < to) to = leaves, next = a;
        }
        to = fmin(fmax(to, from), 1.0);
        for (int n = 0; n < (rests ? 1 : NODES); n++) {
            for (int a = 0; a < AXES; a++) u[a] = u0[a] + (from + (to - from) * node[n]) * d[a];
            of_cube(&g, derivative - 1, cube, u, found);
            for (int a = 0; a < AXES; a++)
                sum[a] += (rests ? 1.0 : (to - from) * weight[n]) * found[1 + a];
        }
        if (next >= 0)
            cube[next] +=
                cube[next] < last_cube[next] ? 1 : -1; /* not by d, which may be no number */
        from = to;
    }
    for (int a = 0; a < AXES; a++)
        slope[a] = sum[a] / (derivative ? g.spacing * g.spacing : g.spacing);
}

#include "small.h"
