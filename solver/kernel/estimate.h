/* What a step adds to the error of a run (theory 8.6).

   The difference from an embedded solution of order r, e ~ (omega h)^(r+1), tells how fast the motion changes, and with it
   the error of the step's own order p, (omega h)^(p+1) times a mean over mechanisms. How far a mechanism is from the mean
   is learned by repeating a few steps as two of half the length. Of weighted covers, the embedded solution is that of all but
   the coarsest. */
#ifndef HOLONOM_ESTIMATE_H
#define HOLONOM_ESTIMATE_H

#include "body_turns.h"
#include "composite.h"
#include "context.h"
#include "energy.h"
#include "forms.h"
#include "inputs_signals.h"
#include "norms.h"
#include "row_state.h"
#include "start.h"
#include "step_halving.h"
#include "tangent.h"

/* Of the mean over mechanisms, the least and the largest multiple that an error is taken for; the largest one squared
   with dampers, of which strong ones show on weighted covers. */
#define LEAST_MULTIPLE 0.01
#define LARGEST_MULTIPLE 100.0
/* Of what does not add up, as much as one step leaves behind: at the largest of all steps, over the mean of those measured. */
#define PASSING 5.0
/* Of what a body turns by in a step: a top's difference from an embedded solution tells how fast it precesses, the step errs by
   its spin. */
#define SPINNING 2.0

enum { N_ORDERS = 1 + N_COMPOSED };

/* A step of order p, if there is one. */
typedef struct method {
    int order, pairs;  /* p, and pairs of half steps in it, or what costs as much                              */
    double lower;      /* r                                                                                   */
    double rate, mean; /* omega h over e^(1/(r+1)), and error over (omega h)^(p+1): means over mechanisms      */
    double round_off;  /* of the difference: the norm of the weights times that of a solved step              */
    double fastest;    /* largest omega h at which Newton's iteration still converges well                    */
} method;

#define PAIR {2, 1, 2.0, 1.0, 1.1e-2, 1e-13, 1.0}

/* By the ways of steps. The rates of explicit ones are of a spring that swings, their errors between those of all scenes. */
static const method METHODS[][N_ORDERS] = {
    [COMPOSED] = {PAIR,
                  {4, 5, 3.0, 2.7, 6e-5, 1e-13, 1.5},
                  {6, 9, 4.0, 2.9, 5.2e-6, 1e-13, 2.0},
                  {8, 15, 6.0, 2.64, 3.1e-7, 1e-12, 2.5}},
    [COVERED] = {PAIR,
                 {4, 3, 2.0, 4.9, 1.2e-3, 1e-13, 1.0},
                 {6, 6, 4.0, 5.9, 3e-5, 1e-13, 1.5},
                 {8, 10, 6.0, 6.2, 7e-7, 1e-12, 2.0}},
    [EXPLICIT] = {{0}, {5, 4, 4.0, 5.3, 2.5e-4, 1e-14, 2.0}, {0}, {8, 7, 7.0, 6.2, 5e-8, 1e-14, 4.0}}};

typedef struct step_error {
    double rate;  /* omega [1/s]                                                            */
    double free;  /* likewise of what rows leave free                                       */
    double mean;  /* error in the mean over mechanisms, relative to size and speed          */
    int is_noise; /* whether round-off of velocities is all that the difference shows       */
} step_error;

static inline int index_of(int order) { return order / 2 - 1; }

/* The difference for a pair, which has no stages: from the rate of change of the mean acceleration of pairs; 0 where
   nothing tells it yet.                                                                                         */
static int difference_of_pairs(const context *c, double h, double *difference)
{
    const int64_t n = DIM * c->n_moving;
    double *const *a = c->s.a, *const *before = c->s.a_before;
    const double between = 0.5 * (h + c->s.head[S_LAST_LENGTH]);
    double *rate = c->k.estimate;
    c->s.head[S_LAST_LENGTH] = h;
    if (c->s.head[S_KNOWN] < 4.0) return 0;
    for (int64_t k = 0; k < n; k++) rate[k] = 0.5 * ((a[0][k] - before[0][k]) + (a[1][k] - before[1][k])) / between;
    const double of_rate = mass_norm(c, rate), speed = mass_norm(c, c->s.v);
    const double omega = speed > 0.0 ? sqrt(of_rate / speed) : 0.0;
    *difference = h * h * h * relative_size(c, of_rate, omega * of_rate);
    return 1;
}

/* Whether round-off explains a difference between steps of length h. Velocities are only known to round-off of places over
   h: shorter steps would show more of it, not less error.                                                        */
static int is_noise(const context *c, double round_off, double difference, double h)
{
    return difference <= round_off * (1.0 + c->number[c->m->extent_at + 1] / (h * fmax(speed_scale(c), 1e-300)));
}

/* Error of the last step, of length h; 0 where nothing tells it yet. */
static int estimate_error(const context *c, int order, double h, step_error *e)
{
    const method *used = &METHODS[c->way][index_of(order)];
    const int64_t n = DIM * c->n_moving;
    const double *x = c->k.estimate + (c->way == COVERED && !c->unweighted ? 2 * n : 0);
    double difference;
    if (c->way == EXPLICIT) difference = c->difference;
    else if (order > 2) difference = relative_size(c, mass_norm(c, x), mass_norm(c, x + n));
    else if (!difference_of_pairs(c, h, &difference)) return 0;
    const double part = c->way == EXPLICIT ? c->free_part : 1.0, root = 1.0 / (used->lower + 1.0);
    const double turned = used->rate * hm_pow(difference, root), freed = used->rate * hm_pow(part * difference, root);
    e->free = c->unweighted ? 0.0 : freed / h;
    e->rate = c->unweighted ? 0.0 : turned / h; /* the end that was not taken tells the error of the one that was */
    e->mean = c->unweighted ? difference : used->mean * hm_pow(freed, order + 1);
    if (c->way == EXPLICIT) e->mean *= fmax(1.0, SPINNING * h * fastest_turn(c) / fmax(freed, 1e-30));
    e->is_noise = is_noise(c, used->round_off, difference, h);
    return 1;
}

/* Bounds on what a step adds to velocities across the rows, over the fastest velocity: ACROSS_ROWS times the tolerance,
   and NEGLIGIBLE_ACROSS_ROWS, below which nothing is done. Such velocities alternate from half step to half step:
   shorter steps that follow do not undo them. */
#define ACROSS_ROWS 10.0
#define NEGLIGIBLE_ACROSS_ROWS 1e-6

/* Largest rate of a row over its scale and the fastest motion, without what round-off of places over h explains. Errors in
   the mass norm do not see light parts: their velocities show here. Rows of drivers have rates of signals, which are
   differences and tell nothing at a kink.                                                                       */
HM_SELDOM static double velocity_defect(context *c, double h)
{
    const holonom_model *m = c->m;
    const double extent = c->number[m->extent_at];
    double fastest = speed_scale(c) / c->number[m->extent_at + 1];
    for (int32_t a = 0; a < c->n_moving; a++) {
        const double *v = c->s.v + DIM * a, size = m->node_kind[a] ? 1.0 : extent;
        fastest = fmax(fastest, sqrt(dot(v, v)) / size);
    }
    if (!(fastest > 0.0)) return 0.0;
    memset(c->k.signal_rate, 0, sizeof(double) * (size_t)m->n_signals);
    row_rates(c, c->s.q, c->s.q_low, c->s.v, c->s.signal, c->k.signal_rate, c->k.row_rate);
    for (int32_t j = first_function(c); j < first_potential(c) && m->n_signals; j++)
        if (has_signal(c, j)) c->k.row_rate[row_of(c, j)] = 0.0;
    const double rounding = NEGLIGIBLE_ACROSS_ROWS + 1e-13 / (h * fastest);
    return fmax(0.0, largest_row(c, c->k.row_rate) / fastest - rounding);
}

/* How many times larger than in the mean the mechanism's errors are at an order; explicit steps learn none, but for what flies. */
static double times_mean(const context *c, enum way way, int p)
{
    if (way == EXPLICIT) return c->growth;
    return p > 0 ? hm_exp(c->s.head[S_LEARNED_4 + p - 1]) : 1.0;
}

/* Number of checks before that of the n-th step of an order, which is the 2nd, 8th, 24th and every 64th; -1 for any other. */
static int checks_before(double n)
{
    const int first = n == 2.0 ? 0 : n == 8.0 ? 1 : n == 24.0 ? 2 : -1;
    return fmod(n, 64.0) == 0.0 ? 3 : first;
}

/* Takes from the difference in v (n) of the state from another one, `whole`, what does not add up in a run, and puts it into
   `passing`: what rows do not allow, which alternates from step to step, and what dampers take away within a step of length
   h. What is left follows the difference in q: along rows that have turned.                                     */
static void leave_what_adds_up(context *c, const double *whole, double h, double *v, double *passing)
{
    const size_t n = (size_t)(DIM * c->n_moving);
    const double *head = c->s.head, *q = whole + (c->s.q - head), *q_low = whole + (c->s.q_low - head), *v0 = whole + (c->s.v - head);
    const double length = c->damped ? 2.0 * h : AT_STATE;
    suspend_sliding(c, 1);
    stand_still(c);
    memset(passing, 0, sizeof(double) * n);
    if (!factorise_with_forces(c, NULL, c->damped ? length : 0.0)) {
        signal_rates_at(c, c->t, c->k.signal_rate);
        row_rates(c, q, q_low, v0, c->s.signal, c->k.signal_rate, c->k.row_rate);
        row_rates(c, c->s.q, c->s.q_low, v0, c->s.signal, c->k.signal_rate, c->k.phi);
        for (int32_t i = 0; i < c->m->n_rows; i++) c->k.phi[i] -= c->k.row_rate[i];
        inertia(c, -length, v, c->k.momentum);
        memcpy(passing, v, sizeof(double) * n);
        memset(v, 0, sizeof(double) * n);
        solve_with_factors(c);
        add_solution(c, v);
        for (size_t k = 0; k < n; k++) passing[k] -= v[k];
    }
    suspend_sliding(c, 0);
    c->factors_h = 0.0; /* Newton's factors are gone */
}

/* Difference of a step of length h from t, just taken, from two of half the length, relative to size and speed; 0 if they
   cannot be taken. The state, its backup and the laws are left as they are; what it cost is counted.            */
static double difference_from_halves(context *c, double t, double h, double law_time)
{
    double *head = c->s.head, *whole = c->k.whole_backup, *before = whole + c->state_size, *x = c->k.estimate;
    const size_t bytes = sizeof(double) * (size_t)c->state_size;
    const double law_time_after = c->number[c->m->time_at], balanced = c->balanced;
    const int64_t n = DIM * c->n_moving;
    const enum way way = c->way;
    memcpy(whole, head, bytes);
    memcpy(before, c->k.pair_backup, bytes);
    memcpy(head, before, bytes);
    if (c->m->time_dependent) set_laws(c, law_time, 0);
    c->t = t;
    int32_t status = internal_step(c, 0.5 * h);
    if (!status) status = internal_step(c, 0.5 * h);
    memset(x, 0, sizeof(double) * (size_t)(2 * n));
    add_change(c, whole, 1.0, x);
    double found = 0.0;
    if (!status && !c->unweighted) {
        leave_what_adds_up(c, whole, h, x + n, x + 2 * n);
        found = relative_size(c, mass_norm(c, x), mass_norm(c, x + n));
        found += PASSING * h / head[S_HORIZON] * relative_size(c, 0.0, mass_norm(c, x + 2 * n));
    }
    c->unweighted = 0;
    c->way = way;
    c->balanced = balanced;
    whole[S_NEWTON_ITERATIONS] += head[S_NEWTON_ITERATIONS] - before[S_NEWTON_ITERATIONS];
    whole[S_UZAWA_ITERATIONS] += head[S_UZAWA_ITERATIONS] - before[S_UZAWA_ITERATIONS];
    memcpy(head, whole, bytes);
    memcpy(c->k.pair_backup, before, bytes);
    if (c->m->time_dependent) set_laws(c, law_time_after, 0);
    return found;
}

/* Counts a step of length h from t that has been judged, and learns from some of them how far errors are from the mean. */
static void learn(context *c, int order, double t, double h, double law_time, const step_error *e)
{
    if (c->way != way_of(c, c->damped, order, h)) return; /* taken otherwise than those to come */
    const int p = index_of(order), checks = checks_before(c->s.head[S_JUDGED_4 + p - 1] += 1.0);
    if (checks < 0 || e->is_noise || c->m->sensing || c->way == EXPLICIT) return; /* whose errors are near the mean */
    const double error = difference_from_halves(c, t, h, law_time);
    if (!(error > 0.0)) return;
    const double largest = c->damped ? LARGEST_MULTIPLE * LARGEST_MULTIPLE : LARGEST_MULTIPLE;
    const double found = fmin(fmax(error / e->mean, LEAST_MULTIPLE), largest), mean = times_mean(c, c->way, p);
    c->s.head[S_LEARNED_4 + p - 1] = hm_log(mean + (found - mean) / (checks + 1.25));
}

#endif
