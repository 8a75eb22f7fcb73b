/* Steps of order 4, 6 and 8 as weighted covers (theory 8.3): where dampers take energy out, and under a tolerance.

   A composition goes back in time in between, where dampers would give energy. Here a step is covered by 1, 2, ... pairs
   of half steps, all forwards. Their ends have errors in even powers of the pairs' length, which weights cancel
   (Richardson). Pairs conserve, without dampers as far as they are solved; weighted ends do so up to the order: they are put
   back onto the constraints, onto the momenta that every cover kept, and onto the energy that the weighted ledger asks for. Contacts do not change
   within a step (event.h): closed ones, and frictions that stick, are rows like others; what slides takes energy as
   dampers do. */
#ifndef HOLONOM_EXTRAPOLATION_H
#define HOLONOM_EXTRAPOLATION_H

#include "context.h"
#include "energy.h"
#include "half_step.h"
#include "inputs_signals.h"
#include "ledger.h"
#include "norms.h"
#include "predict.h"
#include "put_back.h"
#include "rigid.h"
#include "start.h"
#include "tangent.h"

#define LARGEST_CHANGE 1e-2      /* by the weights, relative to size and speed: beyond, errors have no powers yet */
#define MOMENTUM_ROUND_OFF 1e-12 /* relative change of a momentum */
#define LOOSE 1e-2               /* part of a step's allowed error that each of its half steps may leave */
#define UNSEEN 1e-4              /* part of the mass from which on points count as much lighter than the mechanism */

enum { N_WEIGHTED = 3 };
static const int WEIGHTED_ACCOUNTS[N_WEIGHTED] = {S_WORK, S_DISSIPATED, S_FRICTION};

typedef struct extrapolation {
    double booked[N_WEIGHTED];              /* weighted changes in the ledger                             */
    double may_differ;                      /* relative change of a momentum that is kept                 */
    kept_momenta momenta;                   /* those that every cover keeps                               */
    int damped;                             /* whether something takes energy out                         */
} extrapolation;

/* Ledger and momenta are those of the whole: put back, separate islands would exchange energy and momentum. */
static int may_extrapolate(const context *c)
{
    return c->m->n_islands == 1 && hm_conserves_all(c->formulation);
}

/* Steps in a row that were to be covers but left no velocity free to bring their energy back, or were too long for the springs: then
   compositions serve for good. */
#define MOST_HELD 3.0

/* Whether covers without dampers are sure to serve: nothing puts back what drivers ask for or what velocity rows keep by
   reversibility, and potentials do not tell how stiff they are (theory 8.3).                                     */
static inline int may_cover_undamped(const context *c)
{
    const holonom_model *m = c->m;
    return c->s.head[S_HELD] < MOST_HELD && !m->sensing && !m->n_signals && !m->n_velocity_rows && !m->n_potentials;
}

/* Springs turn by no more than this in a step of covers of order 4, 6 and 8, which let swing up what they do not resolve: here by
   1e-3 a step. Scenes whose springs move them keep below 1.7. */
static const double MOST_TURNED[] = {1.7, 2.8, 4.2};

/* Products of inertia, squared over both moments, up to which the diagonal of M tells M^-1: bars have 1/4. */
#define DIAGONAL_ENOUGH 0.3

/* Estimate of the fastest motion of springs alone [1/s], by the trace of M^-1 K with the diagonal of M; infinite with large products
   of inertia and with springs of other quantities than lengths. */
static double elastic_rate(const context *c)
{
    const holonom_model *m = c->m;
    double trace = 0.0, *diagonal = c->k.ahead;
    if (!m->n_elements) return 0.0;
    memset(diagonal, 0, sizeof(double) * (size_t)m->n_free);
    for (int32_t e = 0; e < m->n_mass_free; e++)
        if (m->mass_node[2 * e] == m->mass_node[2 * e + 1]) diagonal[m->mass_node[2 * e]] += c->number[m->mass_at + e];
    for (int32_t e = 0; e < m->n_mass_free; e++) {
        const int32_t a = m->mass_node[2 * e], b = m->mass_node[2 * e + 1];
        if (a != b && hm_square(c->number[m->mass_at + e]) > DIAGONAL_ENOUGH * diagonal[a] * diagonal[b]) return INFINITY;
    }
    for (int32_t j = 0; j < m->n_elements; j++) {
        const double stiffness = c->number[m->stiffness_at + j];
        const int32_t q = m->leaf[4 * m->leaf_ptr[j] + 1], f = m->quantity_form[2 * q];
        if (stiffness == 0.0) continue;
        if (m->quantity_kind[q] != QUANTITY_LENGTH) return INFINITY;
        for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++) {
            const double turn = m->form_kind[f] & FORM_TURNED ? c->number[m->alpha_turn_at + e] : 0.0;
            trace += stiffness * (hm_square(c->number[m->alpha_at + e]) + turn * turn) / diagonal[m->form_node[e]];
        }
    }
    return sqrt(trace);
}

/* Whether steps of an order above 2 are weighted covers: with dampers, or under a tolerance, where they take fewer half steps and
   increments than compositions. */
static int is_covering(const context *c, int damped, int order)
{
    if (order == 2 || !may_extrapolate(c)) return 0;
    return damped || (c->s.head[S_TOLERANCE] > 0.0 && may_cover_undamped(c));
}

HM_OFTEN int is_extrapolating(const context *c) { return is_covering(c, is_dissipative(c), (int)c->s.head[S_ORDER_IN_USE]); }

/* Whether a step of length h without dampers is too long for the springs. */
static int swings_up(const context *c, double h)
{
    return !is_dissipative(c) && !(h * elastic_rate(c) <= MOST_TURNED[(int)c->s.head[S_ORDER_IN_USE] / 2 - 2]);
}

/* Counts a step that was to be one of covers and was too long for the springs; what is at rest tells no length. */
static void count_held(context *c)
{
    double *head = c->s.head;
    head[S_HELD] += mass_product(c, c->s.v, c->s.v) > 0.0;
    if (head[S_HELD] < MOST_HELD) return;
    for (int i = S_JUDGED_4; i < S_JUDGED_4 + 6; i++) head[i] = 0.0; /* of covers; compositions learn for themselves */
}

/* Weight of the end after so many pairs, among the ends after `first` ... `last`. */
static double weight_of(int pairs, int first, int last)
{
    double weight = pairs < first ? 0.0 : 1.0;
    for (int k = first; k <= last; k++)
        if (k != pairs) weight *= (double)(pairs * pairs) / (pairs * pairs - k * k);
    return weight;
}

/* Goes back to the start of the step, from which its next cover begins; what predicts half steps stays. */
static void go_back(context *c, double t, double law_time)
{
    const hm_state *s = &c->s;
    const double *start = c->k.pair_backup;
    memcpy(s->q, start + (s->q - s->head), sizeof(double) * (size_t)(6 * DIM * c->n_moving)); /* q, v, imbalances */
    memcpy(s->turns, start + (s->turns - s->head), sizeof(double) * (size_t)(s->derived - s->turns));
    for (int i = S_WORK; i <= S_FRICTION_LOW; i++) s->head[i] = start[i];
    if (c->m->time_dependent) set_laws(c, law_time, 0);
    c->t = t;
    c->rows_known = 0;
}

/* Adds the end of a cover, `weight` times, to the weighted changes of q and v (in estimate) and ledger; and to what they
   differ by from those of one order less, without the coarsest cover: `less` times. Momenta that changed are not kept. */
static void weigh(context *c, double weight, double less, extrapolation *x)
{
    const hm_state *s = &c->s;
    const double *start = c->k.pair_backup;
    double total[RIGID], size[RIGID];
    add_change(c, start, weight, c->k.estimate);
    add_change(c, start, less, c->k.estimate + 2 * DIM * c->n_moving);
    for (int i = 0; i < N_WEIGHTED; i++) {
        const int at = WEIGHTED_ACCOUNTS[i];
        x->booked[i] += weight * ((s->head[at] - start[at]) + (s->head[at + 1] - start[at + 1]));
    }
    momenta(c, c->k.momentum);
    rigid_momenta(c, x->momenta.kept, c->k.momentum, total, size);
    for (int i = 0; i < RIGID; i++)
        if (!(fabs(total[i] - x->momenta.before[i]) <= x->may_differ * fmax(size[i], x->momenta.scale[i])) || c->m->n_driven)
            x->momenta.kept[i] = 0;
}

/* Takes the weighted ends over, in the place of the finest cover's. */
static int32_t take_weighted(context *c, const extrapolation *x)
{
    const int64_t n = DIM * c->n_moving;
    const hm_state *s = &c->s;
    double *head = s->head, *dq = c->k.estimate, *dv = dq + n;
    const double *start = c->k.pair_backup;
    add_change(c, start, -1.0, dq);
    const double round_off = 1e-15 * head[S_ENERGY_REFERENCE]; /* of losses that the weights take the difference of */
    if (!(x->booked[1] >= -round_off && x->booked[2] >= -round_off)) return HOLONOM_DAMPING_REVERSED;
    if (!(relative_size(c, mass_norm(c, dq), mass_norm(c, dv)) <= LARGEST_CHANGE)) return HOLONOM_NOT_FINITE;
    for (int64_t k = 0; k < n; k++) {
        hm_add(s->q + k, s->q_low + k, dq[k]);
        hm_add(s->v + k, s->v_low + k, dv[k]);
    }
    for (int i = 0; i < N_WEIGHTED; i++) {
        const int at = WEIGHTED_ACCOUNTS[i];
        head[at] = start[at], head[at + 1] = start[at + 1];
        book(c, at, i == 0 ? x->booked[i] : fmax(x->booked[i], 0.0));
    }
    for (int i = S_DEFECT; i <= S_RESIDUAL_LOW; i++) head[i] = start[i]; /* what half steps leave is put back, too */
    suspend_sliding(c, 1); /* no friction answers the corrections */
    const int32_t status = put_back(c, &x->momenta, x->damped);
    suspend_sliding(c, 0);
    follow_angles(c, NULL);
    for (int32_t j = 0; j < n_bodies(c->m); j++) follow_orientation(c, j);
    return status;
}

/* Takes all covers of a step of length h, and weighs their ends. */
static int32_t take_covers(context *c, double h, int covers, extrapolation *x)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    int half = 0;
    begin_halves(c, covers * (covers + 1));
    for (int pairs = 1; pairs <= covers; pairs++) {
        const double weight = weight_of(pairs, 1, covers);
        if (pairs > 1) go_back(c, t, law_time);
        for (int i = 0; i < 2 * pairs; i++) {
            const int32_t status = single_step(c, 0.5 * h / pairs, half++);
            if (status) return status;
            if (i % 2) average_multipliers(c, c->t - 0.5 * h / pairs);
        }
        if (c->m->time_dependent) set_laws(c, t + h, 1); /* ends are compared under the same laws */
        weigh(c, weight, weight - weight_of(pairs, 2, covers), x);
    }
    return HOLONOM_OK;
}

/* What the half steps of covers of a step of length h may leave, over their size. The mass norm does not see the velocities of points that
   are much lighter than the mechanism: half steps are solved further where there are such points. Events are located by gaps at
   ends, which are to be exact. */
static double loose_by(const context *c, double h)
{
    const double mass = hm_square(c->number[c->m->extent_at + 1] / c->number[c->m->extent_at]);
    double least = UNSEEN * mass;
    if (is_unilateral(c->m)) return 0.0;
    for (int32_t a = 0; a < c->m->n_free; a++)
        if (!c->m->node_kind[a]) least = fmin(least, c->number[c->m->node_mass_at + a]);
    return LOOSE * tolerated(c) * h / c->s.head[S_HORIZON] * sqrt(least / (UNSEEN * mass));
}

/* One internal step. Where its weighted end cannot be put back, that of the finest cover stands, which conserves, if there are
   dampers; else the step is to be a composition.                                                                 */
HM_SELDOM static int32_t extrapolated_step(context *c, double h)
{
    const int covers = (int)c->s.head[S_ORDER_IN_USE] / 2;
    const size_t bytes = sizeof(double) * (size_t)c->state_size;
    extrapolation x = {.momenta = momenta_at_start(c), .damped = is_dissipative(c)};
    memcpy(c->k.pair_backup, c->s.head, bytes);
    memset(c->k.estimate, 0, sizeof(double) * (size_t)(4 * DIM * c->n_moving));
    c->balanced = 0.0;
    c->left = c->loose = x.damped ? 0.0 : loose_by(c, h);
    x.may_differ = fmax(MOMENTUM_ROUND_OFF, 2 * covers * c->loose);
    const int32_t status = take_covers(c, h, covers, &x);
    c->loose = 0.0;
    c->rows_known = 0;
    if (status) return status;
    memcpy(c->k.finest, c->s.head, bytes);
    c->covered = !take_weighted(c, &x);
    if (c->covered || !x.damped) return HOLONOM_OK;
    memcpy(c->s.head, c->k.finest, bytes);
    c->unweighted = c->covered = 1;
    return HOLONOM_OK;
}

#endif
