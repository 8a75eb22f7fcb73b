/* Where the solution of a half step is sought first (theory 3.5).

   Accelerations and multipliers go on as the polynomial through the last half steps tells, and miss
   it by nearly what they missed it by in the same half of the internal step before: they depend on
   which half of its pair and which part of a composition this is. The state keeps what was missed,
   one slot for each half of an internal step, as many as the order at assembly asks for. */
#ifndef HOLONOM_PREDICT_H
#define HOLONOM_PREDICT_H

#include "forms.h"

/* Half steps that the polynomial goes through. Parts of a composition differ in length, and what
   they jump by with it: more than a line would only enlarge that. */
static inline int n_followed(const context *c) { return c->step.halves == 2 ? 4 : 2; }

/* Of how many internal steps before it the misses are known and used, the last one or a line
   through two; 0 leaves the values of the same half of the last pair. */
static int known_misses(const context *c)
{
    const double known = hm_skips(SKIP_OLD_GUESS) ? c->s.head[S_KNOWN] - n_followed(c) : 0.0;
    if (c->step.halves > c->m->n_slots || known < c->step.halves) return 0;
    return 2 * c->step.halves <= c->m->n_slots && known >= 2 * c->step.halves ? 2 : 1;
}

/* Lengths that differ by less are the same: times of communication points are rounded. */
#define SAME_LENGTH 1e-9
/* Largest weight of a value: a polynomial that leads further would enlarge errors more, and the
   last value is taken. */
#define LARGEST_WEIGHT 10.0

/* Weights of the last n half steps, the last one first, in the polynomial through their middles at
   that of this one. */
static void find_weights(const context *c, int n, double *weight)
{
    static const double even[3][4] = {
        {2.0, -1.0, 0.0, 0.0}, {3.0, -3.0, 1.0, 0.0}, {4.0, -6.0, 4.0, -1.0}};
    const double *length = c->s.head + S_HALF_1;
    double from[4], way = c->h, product[4] = {1.0, 1.0, 1.0, 1.0}, largest = 0.0;
    int is_even = 1;
    for (int i = 0; i < n; i++) is_even &= fabs(length[i] - way) <= SAME_LENGTH * fabs(way);
    for (int i = 0; i < 4; i++) weight[i] = is_even ? even[n - 2][i] : i == 0;
    if (is_even) return;
    for (int i = 0; i < n; i++) {
        from[i] = (i ? from[i - 1] : 0.0) + 0.5 * (way + length[i]);
        way = length[i];
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++)
            if (j != i) product[i] *= from[j] / (from[j] - from[i]);
        largest = fmax(largest, product[i] == product[i] ? fabs(product[i]) : INFINITY);
    }
    for (int i = 0; i < n && largest <= LARGEST_WEIGHT; i++) weight[i] = product[i];
}

/* Weights for all that is predicted, and for multipliers of dependent rows, where more than a
   parabola would enlarge what these leave undetermined (Bricard, 2e5 steps of 4.9 ms: 3e-14 of the
   energy, and 1e-15 with a parabola). */
static void set_weights(context *c)
{
    static const double by_pairs[4] = {0.0, 2.0, 0.0, -1.0};
    if (c->laws.are_samples) {
        memcpy(c->step.weight, by_pairs, sizeof by_pairs);
        memcpy(c->step.parabola, by_pairs, sizeof by_pairs);
        return;
    }
    find_weights(c, n_followed(c), c->step.weight);
    if (n_followed(c) > 3) find_weights(c, 3, c->step.parabola);
    else memcpy(c->step.parabola, c->step.weight, sizeof c->step.weight);
}

/* Values of the last four half steps, the last one first, their weights, and what the polynomial
   missed in this half of the last internal step and of the one before it. */
typedef struct history {
    const double *weight;
    double *last, *same, *last_before, *same_before, *missed, *missed_before;
} history;

static inline history so_far(const context *c, int parity, const double *weight,
                             double *const *pair, double *const *before, double *missed, int64_t n)
{
    double *now = missed + n * c->step.half;
    return (history){weight, pair[1 - parity],   pair[parity], before[1 - parity], before[parity],
                     now,    now + n * c->step.halves};
}

/* Accelerations, multipliers, and angular accelerations of bodies. */
static inline history accelerations_so_far(const context *c, int parity)
{
    return so_far(c, parity, c->step.weight, c->s.a, c->s.a_before, c->s.a_missed,
                  DIM * c->n_moving);
}

static inline history multipliers_so_far(const context *c, int parity)
{
    const double *weight = c->view.scalars[I_DEPENDENT] != 0.0 ? c->step.parabola : c->step.weight;
    return so_far(c, parity, weight, c->s.mu, c->s.mu_before, c->s.mu_missed, c->m->n_rows);
}

static inline history turning_so_far(const context *c, int parity)
{
    return so_far(c, parity, c->step.weight, c->s.turn, c->s.turn_before, c->s.turn_missed,
                  TURNING * (int64_t)n_bodies(c->m));
}

/* Weights sum to 1: in this form what rests goes on to rest, to the last bit. */
static inline double followed(const history *x, int64_t i)
{
    const double last = x->last[i];
    return last + (x->weight[1] * (x->same[i] - last) + x->weight[2] * (x->last_before[i] - last) +
                   x->weight[3] * (x->same_before[i] - last));
}

/* Predicted value i, with misses of so many internal steps. */
static inline double predicted(int reach, const history *x, int64_t i)
{
    if (reach == 0) return x->same[i];
    return followed(x, i) + (reach == 1 ? x->missed[i] : 2.0 * x->missed[i] - x->missed_before[i]);
}

/* How many misses of a half the state keeps: none, that of this internal step, or that of the one
   before it too. */
static inline int n_kept(const context *c)
{ return (c->step.halves <= c->m->n_slots) + (2 * c->step.halves <= c->m->n_slots); }

/* Takes over value i, which has just been solved for, and what was missed, of which `kept` are. */
static inline void remember(int kept, const history *x, double fresh, int64_t i)
{
    if (kept == 2) x->missed_before[i] = x->missed[i];
    if (kept) x->missed[i] = fresh - followed(x, i);
    x->same_before[i] = x->same[i];
    x->same[i] = fresh;
}

/* Takes over the length of a half step that tells. */
static void remember_length(context *c)
{
    double *length = c->s.head + S_HALF_1;
    c->s.head[S_KNOWN] += 1.0;
    for (int i = 3; i > 0; i--) length[i] = length[i - 1];
    length[0] = c->h;
}

/* No polynomial through what was before and what is after a jump, or over internal steps of another
   kind. */
static void forget_halves(context *c) { c->s.head[S_KNOWN] = 0.0; }

/* Begins an internal step of so many halves. */
static void begin_halves(context *c, int halves)
{
    if (c->s.head[S_HALVES] != halves) forget_halves(c);
    c->s.head[S_HALVES] = c->step.halves = halves;
    c->factors.kept_h = 0.0;
    c->step.rows_known = 0;
}

#endif
