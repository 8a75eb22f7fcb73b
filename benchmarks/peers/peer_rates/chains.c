/* Chains of points and of bars, and the governor; functions and arguments as in planar.c. */
#include <math.h>

#define EXPORT __attribute__((visibility("default")))
#define LARGEST 1024 /* points of a chain */
#define LINKS 16     /* bars of a hanging chain */

static double dot(const double *a, const double *b, int n)
{
    double sum = 0.0;
    for (int k = 0; k < n; k++)
        sum += a[k] * b[k];
    return sum;
}

/* --------------------------------------------------------------------------------- chain of points
   y = places and velocities, 3 each; p = count, mass. Rows d_i = q_i - q_{i-1} of constant length:
   m a_i = lam_{i+1} d_{i+1} - lam_i d_i with d_i.(a_i - a_{i-1}) = -|w_i|^2: tridiagonal in lam. */

EXPORT void chain_rates(double t, const double *y, double *dy, const double *p)
{
    const int n = (int)p[0];
    const double *q = y, *v = y + 3 * n;
    double d[LARGEST][3], lam[LARGEST + 1], upper[LARGEST + 1], last = 0.0;
    (void)t;
    for (int i = 0; i < n; i++) {
        double w[3];
        for (int k = 0; k < 3; k++) {
            d[i][k] = q[3 * i + k] - (i ? q[3 * i + k - 3] : 0.0);
            w[k] = v[3 * i + k] - (i ? v[3 * i + k - 3] : 0.0);
            dy[3 * i + k] = v[3 * i + k];
        }
        const double side = i ? -dot(d[i], d[i - 1], 3) : 0.0;
        const double pivot = (i ? 2.0 : 1.0) * dot(d[i], d[i], 3) - side * (i ? upper[i - 1] : 0.0);
        upper[i] = i + 1 < n ? -(d[i][0] * (q[3 * i + 3] - q[3 * i]) +
                                 d[i][1] * (q[3 * i + 4] - q[3 * i + 1]) +
                                 d[i][2] * (q[3 * i + 5] - q[3 * i + 2])) / pivot : 0.0;
        lam[i] = last = (dot(w, w, 3) - side * last) / pivot;
    }
    lam[n] = 0.0;
    for (int i = n - 2; i >= 0; i--)
        lam[i] -= upper[i] * lam[i + 1];
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            dy[3 * (n + i) + k] = (i + 1 < n ? lam[i + 1] * d[i + 1][k] : 0.0) - lam[i] * d[i][k];
}

EXPORT void chain_look(double t, const double *y, double *out, const double *p)
{
    const int n = (int)p[0], shown[2] = {n - 1, (n + 1) / 2 - 1};
    (void)t;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++) {
            out[3 * i + k] = y[3 * shown[i] + k];
            out[6 + 3 * i + k] = y[3 * (n + shown[i]) + k];
        }
    out[12] = 0.5 * p[1] * dot(y + 3 * n, y + 3 * n, 3 * n);
}

/* --------------------------------------------------------------------------- hanging chain of bars
   y = places and velocities of the n - 1 inner nodes, 2 each; p = n, mass of a bar, gravity,
   damping, node with the damper, then the inverse of the nodes' mass matrix (n - 1)^2, and of it
   D Minv D' (n^2) with D the differences of neighbours. Nails at (-1, 0) and (1, 0), the damper's
   foot at (0, -2). With directions d_j: K_jk (d_j.d_k) lam_k = d_j.(D Minv f)_j + |w_j|^2. */

static void differences(const double *q, int n, double ends, double (*d)[2])
{
    for (int j = 0; j < n; j++)
        for (int k = 0; k < 2; k++) {
            const double last = j ? q[2 * j + k - 2] : (k ? 0.0 : -ends);
            d[j][k] = (j < n - 1 ? q[2 * j + k] : (k ? 0.0 : ends)) - last;
        }
}

/* Solves the symmetric definite S x = b in place, by Cholesky's method. */
static void solve(double (*S)[LINKS], double *b, int n)
{
    for (int j = 0; j < n; j++) {
        for (int i = j; i < n; i++) {
            double sum = S[i][j] - dot(S[i], S[j], j);
            S[i][j] = i == j ? sqrt(sum) : sum / S[j][j];
        }
        b[j] = (b[j] - dot(S[j], b, j)) / S[j][j];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            b[i] -= S[k][i] * b[k];
        b[i] /= S[i][i];
    }
}

/* a = Minv f for n nodes. */
static void accelerate(const double *Minv, double (*f)[2], double *a, int n)
{
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) {
            a[2 * i + k] = 0.0;
            for (int j = 0; j < n; j++)
                a[2 * i + k] += Minv[n * i + j] * f[j][k];
        }
}

/* Weight and damper. */
static void load(const double *q, const double *v, const double *p, double (*f)[2])
{
    const int m = (int)p[4];
    const double u[2] = {q[2 * m], q[2 * m + 1] + 2.0};
    const double drag = p[3] * dot(u, v + 2 * m, 2) / dot(u, u, 2);
    for (int i = 0; i < (int)p[0] - 1; i++) {
        f[i][0] = i == m ? -drag * u[0] : 0.0;
        f[i][1] = -p[1] * p[2] - (i == m ? drag * u[1] : 0.0);
    }
}

EXPORT void hanging_chain_rates(double t, const double *y, double *dy, const double *p)
{
    const int n = (int)p[0], inner = n - 1;
    const double *q = y, *v = y + 2 * inner, *Minv = p + 5, *K = Minv + inner * inner;
    double d[LINKS][2], w[LINKS][2], f[LINKS][2], D[LINKS][2];
    double S[LINKS][LINKS], lam[LINKS], a[2 * LINKS];
    (void)t;
    differences(q, n, 1.0, d);
    differences(v, n, 0.0, w);
    load(q, v, p, f);
    accelerate(Minv, f, a, inner);
    differences(a, n, 0.0, D);
    for (int j = 0; j < n; j++) {
        lam[j] = dot(d[j], D[j], 2) + dot(w[j], w[j], 2);
        for (int k = 0; k <= j; k++)
            S[j][k] = K[n * j + k] * dot(d[j], d[k], 2);
    }
    solve(S, lam, n);
    for (int i = 0; i < inner; i++)
        for (int k = 0; k < 2; k++)
            f[i][k] += lam[i + 1] * d[i + 1][k] - lam[i] * d[i][k];
    accelerate(Minv, f, a, inner);
    for (int i = 0; i < 2 * inner; i++) {
        dy[i] = v[i];
        dy[2 * inner + i] = a[i];
    }
}

EXPORT void hanging_chain_look(double t, const double *y, double *out, const double *p)
{
    const int n = (int)p[0], inner = n - 1, shown[2] = {(int)p[4], 1};
    double energy = 0.0;
    (void)t;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++) {
            out[3 * i + k] = k < 2 ? y[2 * shown[i] + k] : 0.0;
            out[6 + 3 * i + k] = k < 2 ? y[2 * (inner + shown[i]) + k] : 0.0;
        }
    for (int j = 0; j < n; j++) {
        const double zero[2] = {0.0, 0.0};
        const double *a = j ? y + 2 * (inner + j - 1) : zero;
        const double *b = j < inner ? y + 2 * (inner + j) : zero;
        energy += p[1] / 6.0 * (dot(a, a, 2) + dot(a, b, 2) + dot(b, b, 2));
        energy += j < inner ? p[1] * p[2] * y[2 * j + 1] : 0.0;
    }
    out[12] = energy;
}

/* --------------------------------------------------------------------------------------- governor
   y = (s, a, s', a', turn of the shaft): height of the slider and angle of the rods below the
   horizontal; the shaft turns as its moment of momentum L says, I(a) w = L. p = rod, ball, slider,
   stiffness, damping, gravity, L, moments of inertia of shaft and slider, of a rod across,
   along. */

static void about_shaft(double a, const double *p, double *I, double *dI)
{
    const double c = cos(a), s = sin(a), rod = p[0], ball = p[1], across = p[8], along = p[9];
    *I = p[7] + 2.0 * (rod * (0.05 + 0.5 * c) * (0.05 + 0.5 * c) + ball * (0.05 + c) * (0.05 + c) +
                       across * c * c + along * s * s);
    *dI = 2.0 * (-rod * (0.05 + 0.5 * c) * s - 2.0 * ball * (0.05 + c) * s) +
          4.0 * (along - across) * s * c;
}

EXPORT void governor_rates(double t, const double *y, double *dy, const double *p)
{
    const double a = y[1], c = cos(a), s = sin(a), x = 0.5 * c, z = 1.0 - 0.5 * s - y[0];
    const double l = sqrt(x * x + z * z), by_a = (-x * 0.5 * s - z * x) / l, by_s = -z / l;
    const double rate = by_a * y[3] + by_s * y[2];
    const double force = 2.0 * (p[3] * (l - 0.5) + p[4] * rate);
    const double of_a = 2.0 * (0.25 * p[0] + p[1] + p[8]);
    double I, dI;
    (void)t;
    about_shaft(a, p, &I, &dI);
    const double w = p[6] / I;
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] = -p[5] - force * by_s / p[2];
    dy[3] = (0.5 * w * w * dI + 2.0 * p[5] * (0.5 * p[0] + p[1]) * c - force * by_a) / of_a;
    dy[4] = w;
}

EXPORT void governor_look(double t, const double *y, double *out, const double *p)
{
    const double a = y[1], c = cos(a), s = sin(a), x = 0.5 * c, z = 1.0 - 0.5 * s - y[0];
    const double l = sqrt(x * x + z * z), r = 0.05 + c, C = cos(y[4]), S = sin(y[4]);
    double I, dI;
    (void)t;
    about_shaft(a, p, &I, &dI);
    const double w = p[6] / I, dr = -s * y[3];
    const double values[12] = {0.0, 0.0, y[0], r * C, r * S, 1.0 - s, 0.0, 0.0, y[2],
                               dr * C - r * S * w, dr * S + r * C * w, -c * y[3]};
    for (int i = 0; i < 12; i++)
        out[i] = values[i];
    out[12] = 0.5 * I * w * w + (0.25 * p[0] + p[1] + p[8]) * y[3] * y[3] +
              0.5 * p[2] * y[2] * y[2] + p[3] * (l - 0.5) * (l - 0.5) + p[2] * p[5] * y[0] +
              2.0 * p[5] * (p[0] * (1.0 - 0.5 * s) + p[1] * (1.0 - s));
}
