/* Closes a mechanism that is drawn inexactly. First the smallest displacement in the mass metric,
   one step of initialise.h. Where that step fails or leads far away, three others follow until one
   closes the mechanism:

     0. full turns, which drivers ask for at the start: on a path, until the drawing recurs, and
   then by their number alone,
     1. a path on which the gaps of the drawing shrink to zero, r(q) = (1 - s) r(q_drawn): it keeps
   the branch that is drawn. Gaps of joints come first, while drivers keep those of the drawing: the
   branch does not depend on what drivers ask for. Where joints do not close like that, all gaps
   shrink together,
     2. Levenberg-Marquardt from the end of a path,   x = -M^-1 G' (G M^-1 G' + damping S)^-1 r,   S
   = diag(scale^2),
     3. the same from drawings that are shaken more and more, of which the nearest pose counts.

   Unknowns are places and turns of bodies, which stay rigid; gaps r are the rows, of a rod l - L
   (Levenberg 1944; Marquardt 1963). Where no pose closes it, the best one is left: a minimum of sum
   (r/scale)^2. Random numbers are always the same. */
#ifndef HOLONOM_CLOSE_H
#define HOLONOM_CLOSE_H

#include "even_metric.h"
#include "fault.h"
#include "put_back.h"

enum {
    STAGES = 80,
    ROUNDS_OF_STAGE = 12,
    ROUNDS_OF_TRY = 200,
    TRIES = 20,
    TRIES_FOR_OTHERS = 6,
    MOST_LED = 2000
};

#define CLOSED                                                                                     \
    1e-10 /* gap over its scale that counts as none, but for round-off of angles of many turns */
#define ROUND_OFF_OF_ANGLE 1e-15
#define FULL_TURN 6.283185307179586
#define FARTHEST_ROUND                                                                             \
    0.5 /* turn of a body in a round [rad]; a point moves by a third of the mechanism at most */
#define FARTHEST_STAGE 0.6    /* from pose to pose: farther ones may lie on another branch */
#define SHORTEST_STAGE 1e-3   /* of the path, over its longest gap where that is above its scale */
#define FARTHEST_PATH 2e3     /* gap over its scale that a path is followed along */
#define FIRST_SHAKE                                                                                \
    0.05 /* turns that the first try adds [rad]; each later one takes 1.3 times as much */
#define LARGEST_SHAKE 1.5
#define FAR 0.1 /* from the drawing: a pose is told, and others are searched that are as near */
#define OTHER_POSE 0.02       /* from pose to pose: these are two, where nothing can move */
#define AS_NEAR                                                                                    \
    1.5 /* times as far from the drawing as the pose that is taken: a drawing tells them apart no  \
           more */

/* Rows, by whether they follow signals; a whole turn of one of these. */
enum { JOINTS, DRIVERS, TURN, LED };

/* Equations whose unknowns are turns of bodies, at the present state; gaps of the drawing (n_rows),
   and the part of them that is aimed at, of joints and of drivers; and of `turn` [rad], which row
   `turned` is led by. */
typedef struct closing {
    context at;
    double *drawn, aimed[LED], turn;
    int32_t turned;
    double sum, largest; /* of squares of the gaps, over their scales; of these alone */
    double farthest;     /* gap of the drawing, over its scale */
    double none;         /* gap over its scale that counts as none */
    uint32_t random;
} closing;

/* ----------------------------------------------------------------------------------------- gaps */

/* Gap of row i from its value phi, its scale, and the gradient of phi over that of the gap. */
static double gap_of_row(const context *at, int32_t i, double phi, double *scale, double *slope)
{
    const holonom_model *m = at->m;
    *scale = at->number[m->row_scale_at + i];
    *slope = 1.0;
    if (i >= m->n_form_rows || !(m->form_kind[m->row_form[i]] & FORM_SQUARE)) return phi;
    const double length2 = at->number[m->row_constant_at + i], length = sqrt(fmax(length2, 0.0));
    *scale = at->number[m->extent_at];
    *slope = 2.0 * sqrt(fmax(length2 + phi, 0.0));
    return 0.5 * *slope - length;
}

/* Whether row i follows signals: its own, or of driven nodes. */
static int is_driver(const context *c, int32_t i)
{
    const holonom_model *m = c->m;
    const int32_t function = composite_of(c, i), coincident = i - m->n_form_rows;
    if (function >= 0) return has_signal(c, function);
    const int32_t f = coincident >= 0 ? m->coincidence_form[coincident / DIM] : m->row_form[i];
    return m->form_moving[f] > m->form_free[f];
}

/* Looks at the gaps of the state less those aimed at; right-hand sides of their equations in phi,
   compliances in epsilon. */
static void look_at_gaps(closing *x, double damping)
{
    context *at = &x->at;
    const holonom_model *m = at->m;
    const double size2 = hm_square(at->number[m->extent_at + 1]);
    look_at_rows(at);
    x->sum = x->largest = 0.0;
    memset(at->k.mu, 0, sizeof(double) * (size_t)m->n_rows);
    EACH_ROW(at, i) {
        double scale, slope;
        const double led = i == x->turned ? (1.0 - x->aimed[TURN]) * x->turn : 0.0;
        const double aimed = x->aimed[is_driver(at, i)] * x->drawn[i] + led;
        const double gap = gap_of_row(at, i, at->k.phi0[i], &scale, &slope) - aimed,
                     part = gap / scale;
        const double usual = hm_square(slope * scale) / (size2 > 0.0 ? size2 : 1.0);
        at->k.phi[i] = slope * gap;
        at->k.epsilon[i] =
            fmax(damping * usual, at->number[m->row_sigma_at + i] / AT_STATE_PENALTY);
        x->sum += part * part;
        if (exceeds(fabs(part), x->largest)) x->largest = fabs(part);
    }
}

static int is_closed_now(const closing *x) { return x->largest <= x->none; }

/* ---------------------------------------------------------------------------------------- poses */

/* How far the state is from a pose: the largest turn of a body, as the chord of its directors, or
   way of a point over the size of the mechanism. */
static double distance_from(const context *c, const double *pose)
{
    const double *q = pose + (c->s.q - c->s.head);
    double farthest = 0.0;
    for (int32_t a = 0; a < c->m->n_free; a++) {
        double square = 0.0;
        EACH(k) square += hm_square(c->s.q[DIM * a + k] - q[DIM * a + k]);
        farthest =
            fmax(farthest, sqrt(square) / (c->m->node_kind[a] ? 1.0 : c->number[c->m->extent_at]));
    }
    return farthest;
}

/* Turns the body with first director a by 2 atan(|turn|/2) about `turn`. */
static void turn_once_by(context *c, int32_t a, const double *turn)
{
    double t[TURNING], size2 = 0.0;
    for (int k = 0; k < TURNING; k++) t[k] = 0.5 * turn[k], size2 += t[k] * t[k];
    for (int32_t at = DIM * a; at < DIM * (a + TURNING); at += DIM) {
        double once[DIM], twice[DIM];
        turned_by(t, c->s.q + at, once);
        turned_by(t, once, twice);
        EACH(k)
            hm_add(c->s.q + at + k, c->s.q_low + at + k,
                   2.0 / (1.0 + size2) * (once[k] + twice[k]));
    }
}

/* Moves the state by `part` of x, in the order of the unknowns. */
static void move_by(context *at, const double *x, double part)
{
    for (int32_t a = 0, next; a < at->m->n_free; a = next) {
        const double *own = x + at->factors.lu->node_position[a];
        double way[DIM];
        next = next_unknown(at, a);
        for (int k = 0; k < unknown_size(at, a); k++) way[k] = part * own[k];
        if (is_director(at, a)) turn_once_by(at, a, way);
        else EACH(k) hm_add(at->s.q + DIM * a + k, at->s.q_low + DIM * a + k, way[k]);
    }
    follow_angles(at, NULL);
}

/* Largest part of x, in that order, that one round may move by. */
static double allowed_part(const context *at, const double *x)
{
    double farthest = 0.0;
    for (int32_t a = 0; a < at->m->n_free; a = next_unknown(at, a)) {
        const double *own = x + at->factors.lu->node_position[a], turns = is_director(at, a);
        double square = 0.0;
        for (int k = 0; k < unknown_size(at, a); k++) square += own[k] * own[k];
        farthest = fmax(
            farthest, sqrt(square) / (turns ? FARTHEST_ROUND : at->number[at->m->extent_at] / 3.0));
    }
    return farthest > 1.0 ? 1.0 / farthest : 1.0;
}

static double random_number(closing *x) /* between -1 and 1, of variance 1/3 */
{
    x->random = 1664525u * x->random + 1013904223u;
    return (double)x->random / 2147483648.0 - 1.0;
}

/* Turns bodies and, by a tenth of as much, moves points by random ways of that size. */
static void shake(closing *x, double size)
{
    context *at = &x->at;
    double *way = at->k.rhs;
    for (int32_t a = 0; a < at->m->n_free; a = next_unknown(at, a))
        for (int k = 0; k < unknown_size(at, a); k++) {
            const double unit = is_director(at, a) ? sqrt(3.0) : 0.1 * at->number[at->m->extent_at];
            way[at->factors.lu->node_position[a] + k] = size * unit * random_number(x);
        }
    move_by(at, way, 1.0);
}

/* -------------------------------------------------------------------------------- ways to close */

/* Levenberg-Marquardt from the present pose towards the gaps aimed at. */
static int32_t approach(closing *x, int rounds)
{
    context *at = &x->at;
    double damping = 1e-3, *before = at->k.whole_backup;
    look_at_gaps(x, damping);
    for (int round = 0; round < rounds && x->largest > 1e-17 && damping < 1e12; round++) {
        const double sum = x->sum, largest = x->largest;
        if (is_stopped(at)) return HOLONOM_STOPPED;
        const int32_t status = assemble_tangent(at);
        if (status) return status;
        if (!factorise_matrix(at)) {
            memset(at->k.momentum, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
            gather_momentum(at);
            EACH_ROW(at, i) at->k.rhs[at->factors.lu->row_position[i]] = -at->k.phi[i];
            solve_factors(at);
            keep_state(at, before);
            move_by(at, at->k.rhs, allowed_part(at, at->k.rhs));
            look_at_gaps(x, damping *= 0.2);
            if (x->sum < sum) {
                if (sum - x->sum > 1e-9 * sum || is_closed_now(x)) continue;
                break; /* a minimum that is not zero */
            }
            take_state(at, before);
        }
        look_at_gaps(x, damping *= 20.0);
        if (largest <= x->none) break; /* round-off */
    }
    return HOLONOM_OK;
}

/* Follows the gaps of the rows `first` to `last` to zero, as far as it goes; whether that is all
   the way. */
static int follow_gaps(closing *x, int first, int last)
{
    context *at = &x->at;
    const double way = fmin(fmax(first == TURN ? FULL_TURN : x->farthest, 1.0), FARTHEST_PATH);
    double done = 0.0, length = 0.25, *stage = at->k.finest;
    for (int i = 0; i < STAGES * way && length * way >= SHORTEST_STAGE; i++) {
        const double end = fmin(1.0, done + length);
        keep_state(at, stage);
        for (int k = first; k <= last; k++) x->aimed[k] = 1.0 - end;
        const int fails =
            approach(x, end < 1.0 ? ROUNDS_OF_STAGE : ROUNDS_OF_TRY) || !is_closed_now(x);
        if (fails || distance_from(at, stage) > FARTHEST_STAGE) {
            take_state(at, stage);
            length *= 0.5;
            continue;
        }
        if (end == 1.0) return 1;
        done = end;
        length *= 1.6;
    }
    for (int k = first; k <= last; k++) x->aimed[k] = 0.0;
    return 0;
}

/* Closes these rows on a path or, where it ends, behind it; that is noted in `how`. */
static int32_t lead_gaps(closing *x, int first, int last, int *how)
{
    if (follow_gaps(x, first, last)) return HOLONOM_OK;
    *how = CLOSING_BEHIND_PATH;
    return approach(x, ROUNDS_OF_TRY);
}

/* Equations at the drawing, whose gaps they note; it is kept in step_backup. */
static void begin_closing(const context *c, closing *x)
{
    double turned = 0.0;
    x->farthest = 0.0;
    x->at = rows_at_state(c);
    stand_still_as_bodies(&x->at);
    x->drawn = c->k.row_bias;
    x->aimed[JOINTS] = x->aimed[DRIVERS] = x->aimed[TURN] = 0.0;
    x->turned = -1;
    x->random = 1;
    memset(x->drawn, 0, sizeof(double) * (size_t)c->m->n_rows);
    look_at_gaps(x, 1.0);
    for (int32_t j = 0; j < c->m->n_quantities; j++)
        turned = fmax(turned, FULL_TURN * fabs(c->s.turns[j]));
    EACH_ROW(&x->at, i) {
        double scale, slope;
        x->drawn[i] = gap_of_row(&x->at, i, x->at.k.phi0[i], &scale, &slope);
        x->farthest = fmax(x->farthest, fabs(x->drawn[i]) / scale);
    }
    x->none = CLOSED + ROUND_OFF_OF_ANGLE * fmax(turned, x->farthest);
}

/* Adds turns to the angles that row i reads; returns how many these are. */
static int add_turns(context *c, int32_t i, double count)
{
    const holonom_model *m = c->m;
    const int32_t j = composite_of(c, i);
    int angles = 0;
    for (int32_t l = m->leaf_ptr[j]; l < m->leaf_ptr[j + 1]; l++) {
        const int32_t *leaf = m->leaf + 4 * l;
        if (leaf[0] != LEAF_VALUE || m->quantity_kind[leaf[1]] != QUANTITY_ANGLE) continue;
        c->s.turns[leaf[1]] += count;
        angles++;
    }
    return angles;
}

/* Whether row i follows signals and reads an angle, whose full turns count. */
static int is_driven_angle(context *c, int32_t i)
{ return composite_of(c, i) >= 0 && is_driver(c, i) && add_turns(c, i, 0.0); }

/* Takes the pose `begun` with those turns of angles that are counted at present, if it has the gaps
   aimed at then; whether it has. */
static int recurs(closing *x, const double *begun)
{
    context *at = &x->at;
    double *now = at->k.pair_backup;
    keep_state(at, now);
    take_state(at, begun);
    take_section(at, at->s.turns, at->m->n_quantities, now);
    look_at_gaps(x, 0.0);
    if (is_closed_now(x)) return 1;
    take_state(at, now);
    return 0;
}

/* Leads row i by whole turns towards its signal, all other gaps as drawn, until less than a turn is
   left. Once the drawing fits again, the turns that are left are only counted, those of all angles.
   So are those of row i where it cannot be led. */
static void wind_row(closing *x, int32_t i)
{
    context *at = &x->at;
    double *begun = at->k.step_backup, *turns = begun + (at->s.turns - at->s.head),
           *gap = x->drawn + i;
    double left = floor(fabs(*gap) / FULL_TURN + 0.5), led = 0.0;
    x->turn = *gap < 0.0 ? FULL_TURN : -FULL_TURN;
    keep_state(at, begun);
    for (int turn = 0; turn < MOST_LED && left > 0.0; turn++) {
        x->turned = i;
        x->aimed[TURN] = 1.0;
        const int is_led = follow_gaps(x, TURN, TURN);
        x->turned = -1;
        if (!is_led) break;
        *gap += x->turn;
        left--, led++;
        if (!recurs(x, begun)) continue;
        const double skipped = floor(left / led);
        for (int32_t j = 0; j < at->m->n_quantities; j++)
            at->s.turns[j] += skipped * (at->s.turns[j] - turns[j]);
        *gap += skipped * led * x->turn;
        left -= skipped * led;
        led = 0.0;
        keep_state(at, begun);
    }
    if (left == 0.0) return;
    take_state(at, begun);
    *gap += left * x->turn;
    add_turns(at, i, x->turn < 0.0 ? -(led + left) : led + left);
    look_at_gaps(x, 0.0);
    if (is_closed_now(x)) return;
    take_state(at, begun);
    *gap -= (led + left) * x->turn;
}

/* Counts the full turns that drivers ask for at the start, so that what is left of each is less
   than half a turn. */
HM_SELDOM static void wind(context *c)
{
    closing x;
    keep_state(c, c->k.whole_backup);
    begin_closing(c, &x);
    take_state(c, c->k.whole_backup); /* its bodies need not be rigid as drawn */
    x.aimed[JOINTS] = x.aimed[DRIVERS] = 1.0;
    for (int32_t i = 0; i < c->m->n_rows && x.sum < INFINITY; i++)
        if (fabs(x.drawn[i]) > 0.5 * FULL_TURN && is_driven_angle(c, i)) wind_row(&x, i);
}

/* Whether the closed mechanism can move: whether rows leave something of random velocities. */
static int can_move(closing *x)
{
    context *at = &x->at;
    double left = 0.0, all = 0.0;
    look_at_gaps(x, 0.0);
    if (assemble_tangent(at) || factorise_matrix(at)) return 1;
    for (int32_t k = 0; k < DIM * at->n_moving; k++) at->k.momentum[k] = random_number(x);
    gather_momentum(at);
    for (int32_t a = 0; a < at->m->n_free; a = next_unknown(at, a)) {
        const double *momentum = at->k.momentum + DIM * a;
        all += is_director(at, a) ? turning_norm2(at, a, momentum, -1)
                                  : dot(momentum, momentum) / at->number[at->m->node_mass_at + a];
    }
    EACH_ROW(at, i) at->k.rhs[at->factors.lu->row_position[i]] = 0.0;
    solve_factors(at);
    for (int32_t a = 0; a < at->m->n_free; a = next_unknown(at, a))
        for (int k = 0; k < unknown_size(at, a); k++)
            left -= at->k.momentum[DIM * a + k] * at->k.rhs[at->factors.lu->node_position[a] + k];
    return !(fabs(left) < 1e-4 * all);
}

/* Tries from shaken drawings. Where a pose is `known`, which lies in pair_backup, some tell whether
   there are others; else the nearest to the drawing is taken of those that close the mechanism, or,
   where none does, the best that was met. Whether one is closed. */
static int try_shaken(closing *x, int known)
{
    context *at = &x->at;
    double *drawn = at->k.step_backup, *taken = at->k.pair_backup,
           *best = at->k.whole_backup + at->state_size;
    double way = known ? distance_from(at, drawn) : INFINITY, other = INFINITY, sum = x->sum,
           size = FIRST_SHAKE;
    int tries = 0, found = known;
    keep_state(at, best);
    for (; tries < (known ? TRIES_FOR_OTHERS : TRIES);
         tries++, size = fmin(1.3 * size, LARGEST_SHAKE)) {
        take_state(at, drawn);
        shake(x, size);
        if (approach(x, ROUNDS_OF_TRY)) continue;
        if (!is_closed_now(x)) {
            if (x->sum < sum) sum = x->sum, keep_state(at, best);
            continue;
        }
        const double own = distance_from(at, drawn);
        if (found && distance_from(at, taken) <= OTHER_POSE) continue;
        const int is_nearer = own < way && !known;
        other = fmin(other, is_nearer ? way : own);
        if (is_nearer) keep_state(at, taken), way = own;
        found = 1;
    }
    take_state(at, found ? taken : best);
    at->s.head[S_CLOSING_TRIES] = tries;
    at->s.head[S_CLOSING_OTHERS] = found && other < AS_NEAR * way && !can_move(x);
    return found;
}

/* Searches a pose that closes the mechanism, near the drawing in step_backup, and others that are
   as near. `is_closed`: the state is one already. Where none is found, the best pose is left, and
   HOLONOM_UZAWA_DIVERGED returned. */
HM_SELDOM static int32_t find_pose(context *c, int is_closed)
{
    double *head = c->s.head, *drawn = c->k.step_backup, *taken = c->k.pair_backup;
    closing x;
    keep_state(c, taken);
    take_state(c, drawn);
    begin_closing(c, &x);
    if (!(x.sum < INFINITY)) return HOLONOM_NOT_FINITE;
    int how = CLOSING_AT_ONCE;
    if (is_closed) take_state(c, taken);
    for (int first = c->m->n_signals ? DRIVERS : JOINTS; first >= JOINTS && !is_closed; first--) {
        take_state(c, drawn);
        how = CLOSING_ON_PATH;
        x.aimed[DRIVERS] = 1.0;
        if (first == DRIVERS && (lead_gaps(&x, JOINTS, JOINTS, &how) || !is_closed_now(&x)))
            continue;
        const int32_t status = lead_gaps(&x, first, DRIVERS, &how);
        if (status) return status;
        is_closed = is_closed_now(&x);
        if (is_closed) keep_state(c, taken);
    }
    x.aimed[JOINTS] = x.aimed[DRIVERS] = 0.0;
    const int found = try_shaken(&x, is_closed);
    head[S_CLOSING] = is_closed ? how : CLOSING_SHAKEN;
    return found ? HOLONOM_OK : HOLONOM_UZAWA_DIVERGED;
}

/* Searches once more in an even metric: else rounds that follow a curved way get ever shorter. */
HM_SELDOM static int32_t find_pose_of_even_masses(context *c)
{
    take_state(c, c->k.step_backup);
    stand_still(c);
    int32_t status = take_even_metric(c);
    if (!status) status = find_pose(c, 0);
    leave_even_metric(c);
    return status;
}

#endif
