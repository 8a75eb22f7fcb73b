/* Steps that end at switches of the motion (theory 8.6).

   Within a step all laws are as they are on the sides at its beginning. After it, and wherever it
   has evaluated the laws, one looks whether a switch of the motion is off its side. If so the step
   is made anew, of other lengths, until it ends just behind the first crossing: an accepted step is
   one like any other, of the method's order. A formula that has no value beyond its switch, as
   sqrt(x) if x > 0, makes the step fail there: then it ends just before. If none is off its side,
   but a parabola through an argument at both ends and inside comes near to its level, the step is
   made to where it turns, to look there. */
#ifndef HOLONOM_SWITCH_EVENT_H
#define HOLONOM_SWITCH_EVENT_H

#include "jumps.h"
#include "stepped.h"
#include "switches.h"

/* Lengths of a step that ends at a switch. */
enum { MOST_TRIALS = 200 };
#define NO_PIECE 1e-12 /* part of a step, within which two places are one */
/* Places at which an argument that comes near to its level is looked for to turn. */
enum { MOST_LOOKS = 8 };
#define COMES_NEAR                                                                                 \
    0.1 /* part of its way, within which it may touch the level: parabolas are as good as that */
#define CLOSER                                                                                     \
    1e-3 /* part of a step, within which a switch may be crossed there and back without being      \
            looked for */

/* A piece of a communication step: a step from time t, which ends at a switch at the latest. */
typedef struct piece {
    double t, length;
    int32_t (*take)(context *, double); /* step of that length */
    int32_t status;                     /* of the last one taken */
    int stops, crossed; /* whether a switch of the time changes at its end, or one of the motion,
                           which is just behind the level then */
    int is_anew;        /* whether the last step was made in looking for switches */
} piece;

/* Before a step of a piece is taken from the present state, maybe several times with other
   lengths. */
static void begin_watched(context *c, double h)
{
    if (!n_motion_switches(c)) return;
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
    keep_state(c, c->k.switch_backup);
    keep_ahead(c);
    c->k.watched[0] = c->t + rounding_of_time(c->t, h);
    c->k.watched[1] = c->t + h + rounding_of_time(c->t, h);
    for (int32_t k = 0; k < n_switches(c); k++) {
        c->k.seen[k] = 0.0;
        c->k.argument_begin[k] = c->number[switch_of(c, k)->argument];
        c->k.argument_least[2 * k + 1] = INFINITY;
        c->k.argument_largest[2 * k + 1] = -INFINITY;
    }
}

static int has_seen_switch(const context *c)
{
    for (int32_t k = 0; k < n_switches(c) && n_motion_switches(c); k++)
        if (c->k.seen[k] != 0.0 && c->k.by_rounding[k] == 0.0) return 1;
    return 0;
}

#define ARGUMENT_ROUNDED                                                                           \
    1e-12 /* part of size and speed of the mechanism, within which quantities are known */

/* How far an argument may be off by rounding: how wide its range is where quantities are known
   within a part of size and speed. */
HM_SELDOM static double rounding_of(const context *c, const switch_place *x)
{
    const holonom_model *m = c->m;
    const double speed =
        fmax(fastest_rate(c, c->s.v), speed_scale(c) / c->number[m->extent_at + 1]);
    hm_stop_ranges(m, c->number, x->segment, c->k.bounds);
    for (int32_t j = 0; j < m->n_active; j++) {
        const double off =
            ARGUMENT_ROUNDED
            * (m->quantity_kind[j] == QUANTITY_ANGLE ? 1.0 : c->number[m->extent_at]);
        const double value = c->number[m->sensor_at + j], rate = c->number[m->sensor_rate_at + j];
        hm_set_range(c->k.bounds, m->sensor_at + j, value - off, value + off, 0.0, 0.0);
        hm_set_range(c->k.bounds, m->sensor_rate_at + j, rate - off * speed, rate + off * speed,
                     0.0, 0.0);
    }
    hm_run_ranges(m, c->number, x->segment, c->k.bounds);
    const double *range = c->k.bounds + 4 * (int64_t)x->argument, wide = range[1] - range[0];
    return wide < INFINITY ? wide : 0.0;
}

/* Whether an argument is off the side of switch k, and not by rounding alone. */
static int is_off(const context *c, int32_t k, double g)
{
    const switch_place *x = switch_of(c, k);
    return x->is_of_motion && is_off_side(x->kind, g, c->s.side[k]) && c->k.by_rounding[k] == 0.0;
}

/* Forgives switches that are off their sides by rounding in a step just made with this status: a
   quantity that rows hold at 0 has either sign. A step that failed tells nothing of it. */
HM_SELDOM static void forgive_rounding(context *c, int32_t status)
{
    memset(c->k.by_rounding, 0, sizeof(double) * (size_t)n_switches(c));
    if (status) return;
    c->k.watched[1] = -INFINITY;
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
    for (int32_t k = 0; k < n_switches(c); k++) {
        const switch_place *x = switch_of(c, k);
        const double side = c->s.side[k], end = c->number[x->argument];
        if (!x->is_of_motion || !(c->k.seen[k] != 0.0 || is_off(c, k, end))) continue;
        double beyond = beyond_side(x->kind, end, side);
        for (const double *inside = c->k.argument_least + 2 * k;
             inside <= c->k.argument_largest + 2 * k; inside += 2 * (int64_t)c->m->n_switches)
            beyond = fmax(beyond, inside[1] != inside[1] ? INFINITY
                                                         : beyond_side(x->kind, inside[1], side));
        c->k.by_rounding[k] = end == end && beyond <= rounding_of(c, x);
    }
}

static void return_to_start(context *c, const piece *x)
{
    restore_state(c, c->k.switch_backup, x->t, x->t);
    put_ahead_back(c);
}

/* The step of a piece with another length. */
static void step_anew(context *c, piece *x, double h)
{
    return_to_start(c, x);
    sense(c, 0.0, 0);
    set_laws(c, x->t, 0);
    begin_watched(c, h);
    x->status = x->take(c, h);
    x->is_anew = 1;
}

/* Whether the last step of a piece has failed, and no switch in it tells why. */
static int fails_otherwise(const context *c, const piece *x)
{ return x->status && !has_seen_switch(c); }

/* Arguments of the switches of the motion at the present state (n_switches, overwritten); whether
   one is off its side. */
static int look_at_switches(context *c, double *argument)
{
    int off = 0;
    c->k.watched[1] = -INFINITY; /* that the end is off its side is no news */
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
    for (int32_t k = 0; k < n_switches(c); k++) {
        const switch_place *x = switch_of(c, k);
        argument[k] = c->number[x->argument];
        off |= is_off(c, k, argument[k]);
    }
    return off;
}

/* Whether the end of a step made with this status is behind a switch; arguments there are
   overwritten. A step that fails behind one has none. */
static int is_behind(context *c, int32_t status, double *argument)
{
    if (!status) return look_at_switches(c, argument);
    for (int32_t k = 0; k < n_switches(c); k++)
        argument[k] = c->k.seen[k] != 0.0 && c->k.by_rounding[k] == 0.0 ? NAN : c->s.side[k];
    return 1;
}

/* Looks in a piece, just taken, for a switch that leaves its side upwards (way = 1) or downwards
   (-1) and comes back, where a parabola through its arguments at the ends and inside comes near to
   the level. Returns a length at which one is off its side or was seen so, the step to which is
   made, or 0: then the whole piece is taken again. */
HM_SELDOM static double find_turn(context *c, piece *step, int32_t k, int way)
{
    const switch_place *x = switch_of(c, k);
    const double h = step->length, side = c->s.side[k],
                 *inside = (way < 0 ? c->k.argument_least : c->k.argument_largest) + 2 * k;
    const double level = x->kind == SWITCH_LEVEL ? side + (way > 0)
                         : side * way < 0.0      ? 0.0
                                                 : (double)way * INFINITY;
    double place[] = {0.0, inside[0] - step->t, h}, *at = c->k.argument_tried;
    double left[] = {way * (level - c->k.argument_begin[k]), way * (level - inside[1]),
                     way * (level - c->k.argument_high[k])};
    int tried = 0;
    const int is_on =
        x->is_of_motion && (left[2] > 0.0 || !is_off(c, k, c->k.argument_high[k]));
    if (!(place[1] > CLOSER * h && place[1] < (1.0 - CLOSER) * h))
        return 0.0; /* that is an end, and no parabola leads through it and the same end */
    while (is_on && tried < MOST_LOOKS && place[1] > place[0] && place[1] < place[2]) {
        double least;
        const double lowest = lowest_between(place, left, &least);
        if (!(lowest > NO_PIECE * h && least < COMES_NEAR * (fmax(left[0], left[2]) - least)))
            break;
        step_anew(c, step, lowest);
        if (is_behind(c, step->status, at) || has_seen_switch(c)) return lowest;
        const double there = way * (level - at[k]);
        const int is_better = !tried++ || there < left[1], is_before = lowest < place[1],
                  end = is_before == is_better ? 2 : 0;
        if (tried > 1)
            place[end] = is_better ? place[1] : lowest, left[end] = is_better ? left[1] : there;
        if (is_better) place[1] = lowest, left[1] = there;
    }
    if (tried) step_anew(c, step, h);
    return 0.0;
}

/* The same for all switches. */
HM_SELDOM static double find_turns(context *c, piece *x)
{
    double turn = 0.0;
    for (int32_t k = 0; k < n_switches(c) && turn == 0.0; k++)
        for (int way = -1; way <= 1 && turn == 0.0 && !x->status; way += 2)
            turn = find_turn(c, x, k, way);
    return turn;
}

/* Shortens a piece, just taken, until it ends behind a switch, or none in it shows: one may be
   crossed there and back. Arguments at its end are overwritten; returns whether it ends behind
   one. */
static int shorten_to_switch(context *c, piece *x, double *argument)
{
    const double least = CLOSER * x->length;
    for (;;) {
        if (fails_otherwise(c, x)) return 0;
        if (is_behind(c, x->status, argument)) return 1;
        if (!(x->length > least)) return 0;
        const int is_seen = has_seen_switch(c);
        const double shorter = is_seen ? 0.5 * x->length : find_turns(c, x);
        if (shorter == 0.0) return 0;
        x->length = shorter;
        x->stops = 0;
        if (is_seen) step_anew(c, x, shorter);
    }
}

/* Two lengths of a piece, which end ahead of the first switch and behind it, and the arguments of
   switches there. */
typedef struct bracket {
    double low, high, *at_low, *at_high;
    double of_low, of_high; /* what arguments there count: half as much each time that the other end
                               moves again, so that lines lead beyond the crossing (Illinois) */
    int moved;              /* the end that has moved last: -1 low, 1 high, 0 none */
    int32_t failed;         /* why there is no step of length `high`, or 0 */
} bracket;

/* Whether switch k stands on its level, which is a side of its own. */
static int is_on_level(const context *c, int32_t k)
{ return switch_of(c, k)->kind == SWITCH_SIGN && c->s.side[k] == 0.0; }

/* Whether a switch that stands on its level leaves it in a step; one that fails does not tell. */
static int leaves_level(const context *c, const double *argument)
{
    for (int32_t k = 0; k < n_switches(c); k++)
        if (is_on_level(c, k) && argument[k] == argument[k] && is_off(c, k, argument[k])) return 1;
    return 0;
}

/* Length at which the first switch is crossed, by lines through the arguments; the middle where
   these do not tell, as where a piece begins just behind a level to which it comes back. */
static double crossing_in(const context *c, const bracket *b)
{
    const double least = b->low > 0.0 ? 0.0 : CLOSER;
    double first = b->high;
    for (int32_t k = 0; k < n_switches(c); k++) {
        const switch_place *x = switch_of(c, k);
        const double side = c->s.side[k], low = b->at_low[k], high = b->at_high[k];
        if (!is_off(c, k, high)) continue;
        const double level = x->kind == SWITCH_LEVEL ? side + (high >= side) : 0.0,
                     ahead = b->of_low * (level - low), behind = b->of_high * (high - level),
                     part = ahead / (ahead + behind);
        first =
            fmin(first, b->low + (part >= least && part <= 1.0 ? part : 0.5) * (b->high - b->low));
    }
    return first;
}

/* Next length to try: where lines lead; the middle where the step behind fails, or three tries have
   not halved the bracket. */
static double next_length(const context *c, const bracket *b, int is_slow, double round)
{
    if (b->failed || is_slow) return b->low + 0.5 * (b->high - b->low);
    return fmin(fmax(crossing_in(c, b), b->low + 0.5 * round), b->high - 0.5 * round);
}

/* Moves the end of a bracket ahead of the switch (-1), or behind it (1), to a length. */
static void move_end(bracket *b, int end, double length)
{
    *(end > 0 ? &b->high : &b->low) = length;
    *(end > 0 ? &b->of_high : &b->of_low) = 1.0;
    if (b->moved == end) *(end > 0 ? &b->of_low : &b->of_high) *= 0.5;
    b->moved = end;
}

/* Whether the last step of a piece has seen switch k farther off its side than it is at the end. */
static int was_farther_off(const context *c, const piece *x, int32_t k)
{
    const switch_place *place = switch_of(c, k);
    const double side = c->s.side[k], *least = c->k.argument_least + 2 * k,
                 *largest = c->k.argument_largest + 2 * k,
                 before = x->t + (1.0 - NO_PIECE) * x->length,
                 at_end = fmax(0.0, beyond_side(place->kind, c->k.argument_high[k], side));
    return (least[0] < before && beyond_side(place->kind, least[1], side) > at_end)
           || (largest[0] < before && beyond_side(place->kind, largest[1], side) > at_end);
}

/* Whether a switch was crossed there and back before the end of the last step of a piece, behind
   another one or the same. */
static int has_other_seen(const context *c, const piece *x)
{
    for (int32_t k = 0; k < n_switches(c); k++)
        if (c->k.seen[k] != 0.0 && c->k.by_rounding[k] == 0.0
            && (!is_off(c, k, c->k.argument_high[k]) || was_farther_off(c, x, k)))
            return 1;
    return 0;
}

/* Part of the way of an argument to its level that may be left where a step ends just before it. */
#define JUST_BEFORE 1e-9

/* Whether the arguments of switches beyond which a longer step fails (NAN in at_high) have come to
   their levels at its end (at_low). Explicit steps fail earlier, where a stage overshoots. */
HM_SELDOM static int has_come_to_level(const context *c, const double *at_low,
                                       const double *at_high)
{
    for (int32_t k = 0; k < n_switches(c); k++) {
        const switch_place *x = switch_of(c, k);
        const double begin = c->k.argument_begin[k];
        if (at_high[k] == at_high[k] || is_on_level(c, k)) continue;
        const double level = x->kind == SWITCH_LEVEL ? floor(at_low[k] + 0.5) : 0.0,
                     left = fabs(at_low[k] - level);
        if (left > fmax(JUST_BEFORE * fabs(begin - level), rounding_of(c, x))) return 0;
    }
    return 1;
}

/* Ends a piece, just taken, at the first crossing of a switch of the motion in it, if there is one:
   its length is 0 then if that is where it begins. */
HM_SELDOM static int32_t find_switch(context *c, piece *x)
{
    const int32_t n = n_switches(c);
    const double least = CLOSER * x->length, round = 4e-16 * (fabs(x->t) + x->length);
    double *at_low = c->k.argument_low, *at_high = c->k.argument_high, *at = c->k.argument_tried;
    x->crossed = 0;
    if (!n_motion_switches(c)) return x->status;
    forgive_rounding(c, x->status);
    if (!shorten_to_switch(c, x, at_high)) return x->status;
    const double whole = x->length;
    bracket b = {0.0, whole, at_low, at_high, 1.0, 1.0, 0, x->status};
    double made = whole, before = INFINITY; /* width three tries ago */
    return_to_start(c, x);
    look_at_switches(c, at_low);
    int leaves = leaves_level(c, at_high);
    for (int trial = 0; !leaves && trial < MOST_TRIALS && b.high - b.low > round; trial++) {
        const int is_third = trial % 3 == 2;
        const double width = b.high - b.low,
                     next = next_length(c, &b, is_third && width > 0.5 * before, round);
        if (!(next > b.low && next < b.high)) break;
        if (is_third) before = width;
        step_anew(c, x, made = next);
        if (fails_otherwise(c, x) && !b.failed) return x->status;
        const int is_late = is_behind(c, x->status, at);
        memcpy(is_late ? at_high : at_low, at, sizeof(double) * (size_t)n);
        move_end(&b, is_late ? 1 : -1, made);
        if (is_late) b.failed = x->status, leaves = leaves_level(c, at_high);
    }
    if (leaves) b.high = 0.0;
    int is_known = !b.failed;
    for (int32_t k = 0; k < n; k++) is_known |= at_high[k] != at_high[k] && !is_on_level(c, k);
    if (!is_known) return x->status = b.failed; /* for another reason */
    x->length = b.failed ? b.low : b.high;
    x->crossed = 1;
    if (!(x->length > NO_PIECE * whole)) {
        x->length = 0.0;
        x->status = HOLONOM_OK;
        return_to_start(c, x);
        return x->status;
    }
    if (made != x->length || x->status) step_anew(c, x, x->length);
    if (b.failed && !x->status && !has_come_to_level(c, at_low, at_high)) x->crossed = x->stops = 0;
    if (x->status || b.failed || !(x->length > least)) return x->status;
    const int is_seen = has_other_seen(c, x);
    const double turn = is_seen ? 0.5 * x->length : find_turns(c, x);
    if (turn == 0.0) return x->status;
    x->length = turn;
    x->stops = 0;
    if (is_seen) step_anew(c, x, turn);
    return find_switch(c, x);
}

/* Takes a piece from the present state. */
static int32_t take_to_switch(context *c, piece *x)
{
    begin_watched(c, x->length);
    x->status = x->take(c, x->length);
    return find_switch(c, x);
}

#endif
