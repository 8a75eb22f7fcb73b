/* Planar mechanisms in fewest coordinates, for integrators of ordinary differential equations.

   Every problem has two functions of the same arguments: `..._rates` writes y' and `..._look` the
   positions and velocities of its watched places, 3 each, and then its energy [J]. The order of the
   constants p is that of benchmarks/peers/peer_reduced.py; SI units. */
#include <math.h>

#define EXPORT __attribute__((visibility("default")))

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1]; }

/* ------------------------------------------------------------------------------- double pendulum
   y = (a, b, a', b'), angles from the vertical; p = length, mass, gravity.
   2 a'' + c b'' = -s b'^2 - 2 (g/l) sin a,  c a'' + b'' = s a'^2 - (g/l) sin b */

EXPORT void double_pendulum_rates(double t, const double *y, double *dy, const double *p)
{
    const double s = sin(y[0] - y[1]), c = cos(y[0] - y[1]), w = p[2] / p[0];
    const double f = -s * y[3] * y[3] - 2.0 * w * sin(y[0]);
    const double g = s * y[2] * y[2] - w * sin(y[1]);
    (void)t;
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] = (f - c * g) / (2.0 - c * c);
    dy[3] = (2.0 * g - c * f) / (2.0 - c * c);
}

EXPORT void double_pendulum_look(double t, const double *y, double *out, const double *p)
{
    const double l = p[0];
    double energy = 0.0;
    (void)t;
    for (int i = 0; i < 2; i++) {
        double *q = out + 3 * i, *v = out + 6 + 3 * i;
        q[0] = l * sin(y[i]);
        q[1] = -l * cos(y[i]);
        v[0] = l * cos(y[i]) * y[2 + i];
        v[1] = l * sin(y[i]) * y[2 + i];
        q[2] = v[2] = 0.0;
        for (int k = 0; i && k < 2; k++) {
            q[k] += q[k - 3];
            v[k] += v[k - 3];
        }
        energy += p[1] * (0.5 * dot(v, v) + p[2] * q[1]);
    }
    out[12] = energy;
}

/* -------------------------------------------------------------------------------------- four-bar
   All cranks stay parallel: y = (phi, phi') from the upright; p = I, W (for unit bars of unit
   mass), gravity, place of the last pivot. I phi'' = W g sin phi */

EXPORT void four_bar_rates(double t, const double *y, double *dy, const double *p)
{
    (void)t;
    dy[0] = y[1];
    dy[1] = p[1] * p[2] / p[0] * sin(y[0]);
}

EXPORT void four_bar_look(double t, const double *y, double *out, const double *p)
{
    const double s = sin(y[0]), c = cos(y[0]);
    (void)t;
    for (int i = 0; i < 2; i++) {
        double *q = out + 3 * i, *v = out + 6 + 3 * i;
        q[0] = s + (i ? p[3] : 0.0);
        q[1] = c;
        v[0] = c * y[1];
        v[1] = -s * y[1];
        q[2] = v[2] = 0.0;
    }
    out[12] = 0.5 * p[0] * y[1] * y[1] + p[1] * p[2] * c;
}

/* --------------------------------------------------------------------------------------- Andrews
   One freedom, the crank's angle beta: I(beta) b'' + h(beta) b'^2 = torque - dV/dbeta. All points
   follow by intersecting circles, with their first and second derivatives by beta. */

typedef struct {
    double q[2], d[2], dd[2]; /* place, first and second derivative */
} Point;

/* Point at distances r of c and s of e, on the side of `side` seen from c to e. */
static Point meet(const Point *c, double r, const Point *e, double s, double side)
{
    Point x;
    const double u[2] = {e->q[0] - c->q[0], e->q[1] - c->q[1]};
    const double l2 = dot(u, u), along = 0.5 * (r * r - s * s + l2) / l2;
    const double across = side * sqrt(r * r / l2 - along * along);
    x.q[0] = c->q[0] + along * u[0] - across * u[1];
    x.q[1] = c->q[1] + along * u[1] + across * u[0];
    const double m[2] = {x.q[0] - c->q[0], x.q[1] - c->q[1]};
    const double n[2] = {x.q[0] - e->q[0], x.q[1] - e->q[1]};
    const double det = m[0] * n[1] - m[1] * n[0];
    double f = dot(m, c->d), g = dot(n, e->d);
    x.d[0] = (f * n[1] - g * m[1]) / det;
    x.d[1] = (g * m[0] - f * n[0]) / det;
    const double a[2] = {x.d[0] - c->d[0], x.d[1] - c->d[1]};
    const double b[2] = {x.d[0] - e->d[0], x.d[1] - e->d[1]};
    f = dot(m, c->dd) - dot(a, a);
    g = dot(n, e->dd) - dot(b, b);
    x.dd[0] = (f * n[1] - g * m[1]) / det;
    x.dd[1] = (g * m[0] - f * n[0]) / det;
    return x;
}

/* Place along a body from a to b and across it, in units of their distance. */
static Point on(const Point *a, const Point *b, double along, double across)
{
    Point x;
    const double *from[3] = {a->q, a->d, a->dd}, *to[3] = {b->q, b->d, b->dd};
    double *into[3] = {x.q, x.d, x.dd};
    for (int k = 0; k < 3; k++) {
        const double u[2] = {to[k][0] - from[k][0], to[k][1] - from[k][1]};
        into[k][0] = from[k][0] + along * u[0] - across * u[1];
        into[k][1] = from[k][1] + along * u[1] + across * u[0];
    }
    return x;
}

/* Adds a body from a to b to the moment of inertia I and to h, half its derivative;
   k = length, mass, moment of inertia, place of the centre of mass along and across. */
static void add_body(const Point *a, const Point *b, const double *k, double *I, double *h)
{
    const Point c = on(a, b, k[3] / k[0], k[4] / k[0]);
    const double w[2] = {b->d[0] - a->d[0], b->d[1] - a->d[1]};
    const double dw[2] = {b->dd[0] - a->dd[0], b->dd[1] - a->dd[1]};
    *I += k[1] * dot(c.d, c.d) + k[2] * dot(w, w) / (k[0] * k[0]);
    *h += k[1] * dot(c.d, c.dd) + k[2] * dot(w, dw) / (k[0] * k[0]);
}

typedef struct {
    Point p1, p2;
    double I, h, V, dV;
} Squeezer;

/* p = 7 bodies of 5 numbers each, A, B, C, spring's place along and across K3, c0, l0, torque */
static Squeezer squeezer(double beta, const double *p)
{
    const double *k = p, s = sin(beta), c = cos(beta), *more = p + 35;
    const Point O = {{0}, {0}, {0}}, A = {{more[0], more[1]}, {0}, {0}};
    const Point B = {{more[2], more[3]}, {0}, {0}};
    const Point p1 = {{k[0] * c, k[0] * s}, {-k[0] * s, k[0] * c}, {-k[0] * c, -k[0] * s}};
    const Point p2 = meet(&p1, k[5], &B, k[10], 1.0);
    const Point p3 = meet(&p2, k[15], &A, k[20], -1.0), p4 = meet(&p2, k[25], &A, k[30], 1.0);
    const Point *ends[7][2] = {{&O, &p1}, {&p1, &p2}, {&B, &p2}, {&p3, &p2},
                               {&A, &p3}, {&p4, &p2}, {&A, &p4}};
    Squeezer z = {p1, p2, 0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < 7; i++)
        add_body(ends[i][0], ends[i][1], k + 5 * i, &z.I, &z.h);
    const Point D = on(&B, &p2, more[6] / k[10], more[7] / k[10]);
    const double u[2] = {D.q[0] - more[4], D.q[1] - more[5]}, l = sqrt(dot(u, u));
    z.V = 0.5 * more[8] * (l - more[9]) * (l - more[9]);
    z.dV = more[8] * (l - more[9]) * dot(u, D.d) / l;
    return z;
}

EXPORT void andrews_rates(double t, const double *y, double *dy, const double *p)
{
    const Squeezer z = squeezer(y[0], p);
    (void)t;
    dy[0] = y[1];
    dy[1] = (p[45] - z.dV - z.h * y[1] * y[1]) / z.I;
}

EXPORT void andrews_look(double t, const double *y, double *out, const double *p)
{
    const Squeezer z = squeezer(y[0], p);
    const Point *points[2] = {&z.p1, &z.p2};
    (void)t;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++) {
            out[3 * i + k] = k < 2 ? points[i]->q[k] : 0.0;
            out[6 + 3 * i + k] = k < 2 ? points[i]->d[k] * y[1] : 0.0;
        }
    out[12] = 0.5 * z.I * y[1] * y[1] + z.V;
}

/* -------------------------------------------------------------------------------------- car axis
   y = (s, chi, s', chi'): A = s n, B = A + l (cos chi, sin chi), n across the axle, whose angle is
   asin(r sin(omega t)/l); p = mass, l, l0, r, omega, stiffness, gravity. */

static void pull(const double *from, const double *at, const double *p, double *force, double *V)
{
    const double u[2] = {at[0] - from[0], at[1] - from[1]}, l = sqrt(dot(u, u));
    const double f = p[5] * (l - p[2]) / l;
    force[0] = -f * u[0];
    force[1] = -f * u[1] - p[0] * p[6];
    *V += 0.5 * p[5] * (l - p[2]) * (l - p[2]) + p[0] * p[6] * at[1];
}

/* Axle's direction b, its angle's first and second derivative w. */
static void axle(double t, const double *p, double *b, double *w)
{
    const double s = p[3] / p[1] * sin(p[4] * t), c = sqrt(1.0 - s * s);
    const double ds = p[3] / p[1] * p[4] * cos(p[4] * t);
    b[0] = c;
    b[1] = s;
    w[0] = ds / c;
    w[1] = (-p[4] * p[4] * s + w[0] * w[0] * s) / c;
}

EXPORT void car_axis_rates(double t, const double *y, double *dy, const double *p)
{
    const double O[2] = {0.0, 0.0}, m = p[0], l = p[1], s = y[0];
    double b[2], w[2], fA[2], fB[2], V = 0.0;
    axle(t, p, b, w);
    const double n[2] = {-b[1], b[0]}, e[2] = {cos(y[1]), sin(y[1])}, g[2] = {-e[1], e[0]};
    const double A[2] = {s * n[0], s * n[1]}, B[2] = {A[0] + l * e[0], A[1] + l * e[1]};
    const double wheel[2] = {l * b[0], l * b[1]};
    pull(O, A, p, fA, &V);
    pull(wheel, B, p, fB, &V);
    double a[2], f[2]; /* acceleration of A without s'', all force */
    for (int k = 0; k < 2; k++) {
        a[k] = -2.0 * y[2] * w[0] * b[k] - s * (w[1] * b[k] + w[0] * w[0] * n[k]);
        f[k] = fA[k] + fB[k] - m * (2.0 * a[k] - l * y[3] * y[3] * e[k]);
    }
    const double cross = dot(n, g), first = dot(f, n) / m;
    const double second = dot(fB, g) / m - dot(a, g);
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] = (first - cross * second) / (2.0 - cross * cross);
    dy[3] = (2.0 * second - cross * first) / (l * (2.0 - cross * cross));
}

EXPORT void car_axis_look(double t, const double *y, double *out, const double *p)
{
    const double O[2] = {0.0, 0.0}, l = p[1];
    double b[2], w[2], unused[2], V = 0.0;
    double *A = out, *B = out + 3, *vA = out + 6, *vB = out + 9;
    axle(t, p, b, w);
    const double n[2] = {-b[1], b[0]}, e[2] = {cos(y[1]), sin(y[1])}, g[2] = {-e[1], e[0]};
    const double wheel[2] = {l * b[0], l * b[1]};
    for (int k = 0; k < 2; k++) {
        A[k] = y[0] * n[k];
        B[k] = A[k] + l * e[k];
        vA[k] = y[2] * n[k] - y[0] * w[0] * b[k];
        vB[k] = vA[k] + l * y[3] * g[k];
    }
    A[2] = B[2] = vA[2] = vB[2] = 0.0;
    pull(O, A, p, unused, &V);
    pull(wheel, B, p, unused, &V);
    out[12] = 0.5 * p[0] * (dot(vA, vA) + dot(vB, vB)) + V;
}
