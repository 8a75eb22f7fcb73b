/* Spatial mechanisms and chains in fewest coordinates; functions and arguments as in planar.c. */
#include <math.h>

#define EXPORT __attribute__((visibility("default")))

static double dot(const double *a, const double *b, int n)
{
    double sum = 0.0;
    for (int k = 0; k < n; k++)
        sum += a[k] * b[k];
    return sum;
}

static void cross(const double *a, const double *b, double *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* ------------------------------------------------------------------------------------- heavy top
   y = (quaternion w, x, y, z; angular velocity in body axes); p = A, C about the tip, m c, gravity.
   J omega' = J omega x omega + m c e_3 x R'g, g = -g e_z */

EXPORT void heavy_top_rates(double t, const double *y, double *dy, const double *p)
{
    const double *q = y, *o = y + 4, A = p[0], C = p[1], n2 = dot(q, q, 4);
    /* The vertical in body axes: the third row of R. */
    const double x = 2.0 * (q[1] * q[3] - q[0] * q[2]) / n2;
    const double z = 2.0 * (q[2] * q[3] + q[0] * q[1]) / n2;
    (void)t;
    dy[0] = 0.5 * (-q[1] * o[0] - q[2] * o[1] - q[3] * o[2]);
    dy[1] = 0.5 * (q[0] * o[0] + q[2] * o[2] - q[3] * o[1]);
    dy[2] = 0.5 * (q[0] * o[1] + q[3] * o[0] - q[1] * o[2]);
    dy[3] = 0.5 * (q[0] * o[2] + q[1] * o[1] - q[2] * o[0]);
    dy[4] = ((A - C) * o[1] * o[2] + p[2] * p[3] * z) / A;
    dy[5] = ((C - A) * o[2] * o[0] - p[2] * p[3] * x) / A;
    dy[6] = 0.0;
}

EXPORT void heavy_top_look(double t, const double *y, double *out, const double *p)
{
    const double *q = y, *o = y + 4, n2 = dot(q, q, 4);
    double third[3] = {2.0 * (q[1] * q[3] + q[0] * q[2]) / n2,
                       2.0 * (q[2] * q[3] - q[0] * q[1]) / n2,
                       (q[0] * q[0] + q[3] * q[3] - q[1] * q[1] - q[2] * q[2]) / n2};
    const double first[3] = {(q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3]) / n2,
                             2.0 * (q[1] * q[2] + q[0] * q[3]) / n2,
                             2.0 * (q[1] * q[3] - q[0] * q[2]) / n2};
    double second[3];
    (void)t;
    cross(third, first, second);
    for (int k = 0; k < 3; k++) {
        out[k] = third[k];
        out[3 + k] = o[1] * first[k] - o[0] * second[k];
    }
    out[6] =
        0.5 * (p[0] * (o[0] * o[0] + o[1] * o[1]) + p[1] * o[2] * o[2]) + p[2] * p[3] * third[2];
}

/* --------------------------------------------------------------------------------------- Bricard
   One freedom psi: hinges turn by -(alpha - 90°), -(beta - 90°) in turn, and the loop closes where
   (1 + u^2)(1 + w^2) = 4, u = tan(alpha/2), w = tan(beta/2): u = sqrt(3) sin psi.
   p = length, mass, moments of inertia along and across, gravity. */

typedef struct {
    double I, h, V, dV, corner[3], slope[3]; /* h: half the derivative of I by psi */
} Loop;

/* Angle -(2 atan u - 90°): cosine and sine, first and second derivative by psi. */
static void turn(double u, double du, double ddu, double *angle)
{
    const double s = 1.0 + u * u;
    angle[0] = 2.0 * u / s;
    angle[1] = (1.0 - u * u) / s;
    angle[2] = -2.0 * du / s;
    angle[3] = -2.0 * ddu / s + 4.0 * u * du * du / (s * s);
}

/* Turns the axes R (rows are axes in space) about their axis k. */
static void turn_about(double R[3][3], int k, const double *angle)
{
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    for (int n = 0; n < 3; n++) {
        const double a = R[i][n], b = R[j][n];
        R[i][n] = angle[0] * a + angle[1] * b;
        R[j][n] = angle[0] * b - angle[1] * a;
    }
}

/* Adds rod i, turned by its hinge, to the loop; W, P: angular velocity and end, each with its
   derivatives by psi. */
static void add_rod(int i, const double *angle, double R[3][3], double W[2][3], double P[3][3],
                    const double *p, Loop *z)
{
    static const int axis[5] = {1, 2, 0, 1, 2}, along[5] = {0, 1, 2, 0, 1};
    const double *e = R[axis[i]], n = 4.0 * (p[2] - p[3]) / (p[0] * p[0]);
    double d[3], Wd[3], WWd[3], dWd[3], We[3];
    cross(W[0], e, We);
    for (int k = 0; k < 3; k++) {
        W[1][k] += e[k] * angle[3] + We[k] * angle[2];
        W[0][k] += e[k] * angle[2];
    }
    turn_about(R, axis[i], angle);
    for (int k = 0; k < 3; k++)
        d[k] = (i % 2 ? -0.5 : 0.5) * p[0] * R[along[i]][k];
    cross(W[0], d, Wd);
    cross(W[0], Wd, WWd);
    cross(W[1], d, dWd);
    for (int half = 0; half < 2; half++) {
        for (int k = 0; k < 3; k++) {
            P[0][k] += d[k];
            P[1][k] += Wd[k];
            P[2][k] += dWd[k] + WWd[k];
        }
        if (half)
            continue;
        z->I += p[1] * dot(P[1], P[1], 3);
        z->h += p[1] * dot(P[1], P[2], 3);
        z->V += p[1] * p[4] * P[0][1];
        z->dV += p[1] * p[4] * P[1][1];
    }
    z->I += p[3] * dot(W[0], W[0], 3) + n * dot(W[0], d, 3) * dot(W[0], d, 3);
    z->h += p[3] * dot(W[0], W[1], 3) + n * dot(W[0], d, 3) * dot(W[1], d, 3);
}

static Loop loop_at(double psi, const double *p)
{
    const double r3 = sqrt(3.0), s = sin(psi), c = cos(psi), D = 1.0 + 3.0 * s * s, r = sqrt(D);
    double R[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, W[2][3] = {{0}}, P[3][3] = {{0}};
    double angles[2][4];
    Loop z = {0.0, 0.0, 0.0, 0.0, {0}, {0}};
    turn(r3 * s, r3 * c, -r3 * s, angles[0]);
    turn(r3 * c / r, -4.0 * r3 * s / (D * r), -4.0 * r3 * c * (1.0 - 6.0 * s * s) / (D * D * r),
         angles[1]);
    for (int i = 0; i < 5; i++) {
        add_rod(i, angles[i % 2], R, W, P, p, &z);
        for (int k = 0; k < 3 && i == 2; k++) {
            z.corner[k] = P[0][k];
            z.slope[k] = P[1][k];
        }
    }
    return z;
}

EXPORT void bricard_rates(double t, const double *y, double *dy, const double *p)
{
    const Loop z = loop_at(y[0], p);
    (void)t;
    dy[0] = y[1];
    dy[1] = -(z.dV + z.h * y[1] * y[1]) / z.I;
}

EXPORT void bricard_look(double t, const double *y, double *out, const double *p)
{
    const Loop z = loop_at(y[0], p);
    (void)t;
    for (int k = 0; k < 3; k++) {
        out[k] = z.corner[k];
        out[3 + k] = z.slope[k] * y[1];
    }
    out[6] = 0.5 * z.I * y[1] * y[1] + z.V;
}
