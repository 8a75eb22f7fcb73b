/* The least that a half step of the method takes for a chain of N equal points on N equal rods from
   the origin, DIM coordinates each, written by hand: number, shape and order of everything are
   known to the compiler. It is the yardstick of the kernel's instructions, and nothing else uses
   it.

   Same method as the kernel's: pairs of half steps of the conserving augmented Lagrangian,
   compensated positions and velocities, rods at the beginning to twice the digits, predicted
   accelerations and multipliers, Newton's iteration with factors that are kept and multipliers that
   follow, stopped by the same rules, except that trust in a learned contraction does not fade. The
   tangent leaves the geometric stiffness out, so that its Schur complement G M^-1 G' is
   tridiagonal; what this leaves of an increment is learned on the way, so that one increment may
   end a half step. No energies are booked, and what is left of the momentum balance is not handed
   on.

   Define N, DIM and ADVANCE before this file is included. */
#include <math.h>
#include <string.h>

typedef double vector[DIM];

/* Values that are predicted: accelerations, and from MU on the multipliers. */
enum { MU = N * DIM, VALUES = MU + N };

typedef struct chain {
    double mass, length,
        gravity; /* of one point [kg], of one rod [m], along the last axis [m/s^2] */
    double penalty, tolerance;    /* as the kernel's settings penalty and newton_tolerance */
    double reference, floor; /* energy [J]; round-off of increments in the mass norm [kg^1/2 m] */
    double known, solves,
        iterations; /* half steps since the start, in this call, Newton iterations in this call */
    vector q[N], q_low[N], v[N], v_low[N];
    double pair[2][VALUES];       /* values of either half of the last pair */
    double before[2][VALUES];     /* and of the pair before it */
    double missed[2][2]
                 [VALUES]; /* [half][now, before]: what the polynomial missed in these pairs */
    double contraction;           /* of increments, as second ones have told; 1 before that */
} chain;

typedef struct half_step {
    vector hv[N], w[N], d[N], u0[N], um[N], momentum[N];
    double phi0[N], phi[N], mu[N], epsilon[N];
    vector end[N], middle[N]; /* gradients over 2 of the factors: links at the end, in the middle */
    double pivot[N], lower[N], upper[N];
} half_step;

#define POINTS(i) for (int i = 0; i < N; i++)
#define EACH(k) for (int k = 0; k < DIM; k++)

static inline double dot(const double *x, const double *y)
{
    double sum = x[0] * y[0];
    for (int k = 1; k < DIM; k++) sum += x[k] * y[k];
    return sum;
}

/* (*high + *low) += x (Dekker 1971). */
static inline void add(double *high, double *low, double x)
{
    const double a = *high, y = x + *low, s = a + y, t = s - a;
    *low = (a - (s - t)) + (y - t);
    *high = s;
}

/* |u|^2 - L^2 with u = (x + x_low) - (y + y_low) to about twice the digits of a double; y is NULL
   at the origin. */
static inline double rod_at_start(const double *x, const double *x_low, const double *y,
                                  const double *y_low, double square)
{
    double high = -square, low = 0.0;
    EACH(k) {
        const double s = y ? x[k] - y[k] : x[k], t = s - x[k];
        const double s_low = y ? (x[k] - (s - t)) - (y[k] + t) + (x_low[k] - y_low[k]) : x_low[k];
        const double far = 134217729.0 * s, near = far - (far - s), rest = s - near,
                     product = s * s;
        const double sum = high + product, part = sum - high;
        low += (high - (sum - part)) + (product - part);
        low += ((near * near - product) + 2.0 * near * rest) + rest * rest + 2.0 * s * s_low;
        high = sum;
    }
    return high + low;
}

/* Value i where the polynomial through the last four half steps leads. */
static inline double followed(const chain *c, int half, int i)
{
    const double last = c->pair[1 - half][i], same = c->pair[half][i];
    return last
           + (-6.0 * (same - last) + 4.0 * (c->before[1 - half][i] - last)
              - (c->before[half][i] - last));
}

/* Value i there, and what the polynomial will miss, as far as the pairs before tell. */
static inline double predicted(const chain *c, int half, int i)
{
    const double now = c->missed[half][0][i], before = c->missed[half][1][i];
    if (c->known < 6.0) return c->pair[half][i];
    return followed(c, half, i) + (c->known < 8.0 ? now : 2.0 * now - before);
}

/* Takes over value i, which has just been solved for. */
static inline void remember(chain *c, int half, int i, double fresh)
{
    c->missed[half][1][i] = c->missed[half][0][i];
    c->missed[half][0][i] = fresh - followed(c, half, i);
    c->before[half][i] = c->pair[half][i];
    c->pair[half][i] = fresh;
}

static inline void prepare(const chain *c, half_step *s, double h, int half)
{
    const double square = c->length * c->length,
                 stiff = h * h * 2.0 * square / (c->mass * c->penalty);
    POINTS(i) EACH(k) {
        s->hv[i][k] = h * c->v[i][k] + h * c->v_low[i][k];
        s->w[i][k] = 0.5 * h * h * predicted(c, half, DIM * i + k);
        s->d[i][k] = s->hv[i][k] + s->w[i][k];
    }
    POINTS(i) {
        const double *y = i ? c->q[i - 1] : NULL, *y_low = i ? c->q_low[i - 1] : NULL;
        EACH(k)
            s->u0[i][k] =
                i ? (c->q[i][k] - y[k]) + (c->q_low[i][k] - y_low[k]) : c->q[i][k] + c->q_low[i][k];
        s->phi0[i] = rod_at_start(c->q[i], c->q_low[i], y, y_low, square);
        s->mu[i] = predicted(c, half, MU + i);
        s->epsilon[i] = i ? 2.0 * stiff : stiff; /* h^2 sigma/(2 chi) */
    }
}

/* Residuals at the present increment. */
static inline void evaluate(const chain *c, half_step *s, double h)
{
    const double inertia = 2.0 / h * c->mass, weight = h * c->mass * c->gravity;
    POINTS(i) {
        vector du;
        EACH(k) du[k] = i ? s->d[i][k] - s->d[i - 1][k] : s->d[i][k];
        EACH(k) s->um[i][k] = s->u0[i][k] + 0.5 * du[k];
        s->phi[i] = s->phi0[i] + 2.0 * dot(s->um[i], du);
        EACH(k) {
            const double force = 2.0 * h * s->mu[i] * s->um[i][k];
            s->momentum[i][k] = inertia * s->w[i][k] + force + (k == DIM - 1 ? weight : 0.0);
            if (i) s->momentum[i - 1][k] -= force;
        }
    }
}

/* Tridiagonal Schur complement of the gradients at hand and its factors. */
static inline void factorise(const chain *c, half_step *s, double h)
{
    const double scale = 2.0 * h * h / c->mass;
    POINTS(i) {
        EACH(k) s->middle[i][k] = s->um[i][k];
        EACH(k) s->end[i][k] = 2.0 * s->um[i][k] - s->u0[i][k];
    }
    POINTS(i) {
        double diagonal = (i ? 2.0 : 1.0) * scale * dot(s->end[i], s->middle[i]) + s->epsilon[i];
        if (i) {
            s->lower[i] = -scale * dot(s->end[i], s->middle[i - 1]) * s->pivot[i - 1];
            diagonal -= s->lower[i] * s->upper[i - 1];
        }
        if (i + 1 < N) s->upper[i] = -scale * dot(s->end[i], s->middle[i + 1]);
        s->pivot[i] = 1.0 / diagonal;
    }
}

/* One increment of Newton's iteration; its length in the mass norm, and the square of that of d. */
static inline void increment(const chain *c, half_step *s, double h, double *eta, double *size2)
{
    const double inverse = h / (2.0 * c->mass);
    double x[N];
    vector sum[N];
    POINTS(i) {
        vector change;
        EACH(k) change[k] = i ? s->momentum[i][k] - s->momentum[i - 1][k] : s->momentum[i][k];
        x[i] = s->phi[i] - 2.0 * inverse * dot(s->end[i], change);
        if (i) x[i] -= s->lower[i] * x[i - 1];
    }
    for (int i = N - 1; i >= 0; i--) {
        if (i + 1 < N) x[i] -= s->upper[i] * x[i + 1];
        x[i] *= s->pivot[i];
        s->mu[i] += x[i];
        EACH(k) sum[i][k] = 2.0 * h * x[i] * s->middle[i][k];
    }
    double moved = 0.0, size = 0.0;
    POINTS(i) {
        vector change;
        EACH(k)
            change[k] =
                -inverse * (s->momentum[i][k] + sum[i][k] - (i + 1 < N ? sum[i + 1][k] : 0.0));
        EACH(k) s->w[i][k] += change[k];
        EACH(k) s->d[i][k] = s->hv[i][k] + s->w[i][k];
        moved += dot(change, change);
        size += dot(s->d[i], s->d[i]);
    }
    *eta = sqrt(c->mass * moved);
    *size2 = c->mass * size;
}

/* What Newton's iteration knows of itself: contraction, the last one that is more than round-off,
   last increment and d in the mass norm, largest defect of a rod. */
typedef struct progress {
    double theta, seen, eta, size2, defect;
} progress;

/* What the last increment tells of the contraction, after the one before it of size `previous`. The
   tangent lacks the same stiffness in all increments of a half step: the second one tells what the
   first ones of the next half steps leave. */
static inline void judge(chain *c, int iteration, double previous, progress *r)
{
    const double size = sqrt(r->size2);
    r->theta = r->eta / previous;
    r->seen = r->eta < 1e-15 * size ? fmin(r->seen, r->theta) : r->theta;
    if (iteration == 1 && (r->theta < c->contraction || r->eta > 1e-12 * size))
        c->contraction = fmin(r->theta, 1.0);
}

/* Whether what is left of the increments, the rods, their energy and the work of what is left of
   the momentum balance lie far below the tolerance, or below it where rounding errors end the
   contraction. A single increment ends a half step only where the rods hold better than they must
   after two. */
static inline int is_solved(const chain *c, const half_step *s, double h, int iteration,
                            progress *r)
{
    const double target = c->tolerance * sqrt(r->size2 + 2.0 * h * h * c->reference);
    const int is_stalled = iteration > 1 && r->theta > 0.5 && r->eta <= fmax(target, c->floor);
    if (!(fmin(r->seen, c->contraction) * r->eta <= 1e-6 * target || is_stalled)) return 0;
    const double last = r->defect, square = c->length * c->length;
    double work = 0.0, rods = 0.0;
    r->defect = 0.0;
    POINTS(i) {
        const double size = fabs(s->phi[i]);
        if (!(size <= r->defect)) r->defect = size;
        work += dot(s->d[i], s->momentum[i]);
        rods += s->phi[i] * s->mu[i];
    }
    const double energy = 0.5 * r->size2 / (h * h) + c->reference,
                 noise = 0.5 * c->floor * c->floor / (h * h);
    const double round_off = c->tolerance * energy + noise;
    if (!(fabs(work / h) <= (is_stalled ? 1e4 : 1e-3) * round_off)) return 0;
    const double allowed = iteration ? fmax(1e-5 * c->tolerance, 5.6e-17) : 4e-18;
    return (r->defect <= allowed * square && fabs(rods) <= 1e-3 * round_off)
           || (r->defect > 0.9 * last && r->defect <= c->tolerance * square
               && fabs(rods) <= 1e4 * round_off);
}

static inline void accept(chain *c, const half_step *s, double h, int half)
{
    POINTS(i) {
        EACH(k) {
            add(&c->q[i][k], &c->q_low[i][k], s->d[i][k]);
            add(&c->v[i][k], &c->v_low[i][k], 2.0 * s->w[i][k] / h);
            remember(c, half, DIM * i + k, 2.0 / (h * h) * s->w[i][k]);
        }
        remember(c, half, MU + i, s->mu[i]);
    }
    c->known += 1.0;
}

/* One half step; 0, or 1 where Newton's iteration does not end: by hand one chooses steps where it
   contracts well. */
static int half_step_of(chain *c, double h, int half)
{
    half_step s;
    progress r = {1.0, 1.0, 0.0, 0.0, INFINITY};
    prepare(c, &s, h, half);
    evaluate(c, &s, h);
    factorise(c, &s, h);
    for (int iteration = 0; iteration < 20; iteration++) {
        const double previous = r.eta;
        increment(c, &s, h, &r.eta, &r.size2);
        evaluate(c, &s, h);
        if (iteration) judge(c, iteration, previous, &r);
        c->iterations += 1.0;
        if (!is_solved(c, &s, h, iteration, &r)) continue;
        accept(c, &s, h, half);
        return 0;
    }
    return 1;
}

/* Advances by `steps` internal steps of length h [s], two halves each; 0, or 1 on failure. */
int ADVANCE(chain *c, double h, long steps);
int ADVANCE(chain *c, double h, long steps)
{
    c->solves = c->iterations = 0.0;
    for (long i = 0; i < steps; i++)
        for (int half = 0; half < 2; half++) {
            if (half_step_of(c, 0.5 * h, half)) return 1;
            c->solves += 1.0;
        }
    return 0;
}
