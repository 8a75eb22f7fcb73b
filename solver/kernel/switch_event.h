/* Steps that end at switches, and sides that change there (theory 8.6).

   Within a step all laws are as they are on the sides at its beginning. After it, and wherever it has evaluated the laws, one looks
   whether a switch of the motion is off its side. If so the step is made anew, of other lengths, until it ends just behind the first
   crossing: an accepted step is one like any other, of the method's order. A formula that has no value beyond its switch, as
   sqrt(x) if x > 0, makes the step fail there: then it ends just before. If none is off its side, but a parabola through an argument
   at both ends and inside comes near to its level, the step is made to where it turns, to look there. */
#ifndef HOLONOM_SWITCH_EVENT_H
#define HOLONOM_SWITCH_EVENT_H

#include "jumps.h"
#include "stepped.h"
#include "switches.h"

/* Changes of sides in a communication step, and in turn without a pause; lengths of a step that ends at a switch. */
enum { MOST_CHANGES = 1000000, MOST_QUICK = 1000, MOST_TRIALS = 200 };
#define NO_PIECE 1e-12 /* part of a step, within which two places are one */
enum { MOST_LOOKS = 8 }; /* places at which an argument that comes near to its level is looked for to turn */
#define COMES_NEAR 0.1 /* part of its way, within which it may touch the level: parabolas are as good as that */
#define CLOSER 1e-3 /* part of a step, within which a switch may be crossed there and back without being looked for */

typedef int32_t (*step_function)(context *, double);

/* Before a step from the present state, which find_switch may make anew. */
static void begin_watched(context *c, double h)
{
    if (!c->m->n_motion_switches) return;
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
    keep_state(c, c->k.switch_backup);
    c->k.watched[0] = c->t + rounding_of_time(c->t, h);
    c->k.watched[1] = c->t + h + rounding_of_time(c->t, h);
    for (int32_t k = 0; k < c->m->n_switches; k++) {
        arguments_kept(c, SEEN)[k] = 0.0;
        arguments_kept(c, AT_BEGIN)[k] = c->number[switch_of(c, k)->argument];
        arguments_kept(c, AT_LEAST)[2 * k + 1] = INFINITY;
        arguments_kept(c, AT_LARGEST)[2 * k + 1] = -INFINITY;
    }
}

static int has_seen_switch(const context *c)
{
    for (int32_t k = 0; k < c->m->n_switches && c->m->n_motion_switches; k++)
        if (arguments_kept(c, SEEN)[k] != 0.0 && arguments_kept(c, BY_ROUNDING)[k] == 0.0) return 1;
    return 0;
}

#define ROUNDED 1e-12 /* part of size and speed of the mechanism, within which quantities are known */

/* How far an argument may be off by rounding: how wide its range is where quantities are known within a part of size and speed. */
HM_SELDOM static double rounding_of(const context *c, const switch_place *x)
{
    const holonom_model *m = c->m;
    const double speed = fmax(fastest_rate(c, c->s.v), speed_scale(c) / c->number[m->extent_at + 1]);
    hm_stop_ranges(m, c->number, x->segment, c->k.bounds);
    for (int32_t j = 0; j < m->n_active; j++) {
        const double off = ROUNDED * (m->quantity_kind[j] == QUANTITY_ANGLE ? 1.0 : c->number[m->extent_at]);
        const double value = c->number[m->sensor_at + j], rate = c->number[m->sensor_rate_at + j];
        hm_set_range(c->k.bounds, m->sensor_at + j, value - off, value + off, 0.0, 0.0);
        hm_set_range(c->k.bounds, m->sensor_rate_at + j, rate - off * speed, rate + off * speed, 0.0, 0.0);
    }
    hm_run_ranges(m, c->number, x->segment, c->k.bounds);
    const double *range = c->k.bounds + 4 * (int64_t)x->argument, wide = range[1] - range[0];
    return wide < INFINITY ? wide : 0.0;
}

/* Whether an argument is off the side of switch k, and not by rounding alone. */
static int is_off(const context *c, int32_t k, double g)
{
    const switch_place *x = switch_of(c, k);
    return x->is_of_motion && is_off_side(x->kind, g, c->s.side[k]) && arguments_kept(c, BY_ROUNDING)[k] == 0.0;
}

/* Forgives switches that are off their sides by rounding in a step just made with this status: a quantity that rows hold at 0 has either
   sign. A step that failed tells nothing of it. */
HM_SELDOM static void forgive_rounding(context *c, int32_t status)
{
    memset(arguments_kept(c, BY_ROUNDING), 0, sizeof(double) * (size_t)c->m->n_switches);
    if (status) return;
    c->k.watched[1] = -INFINITY;
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
    for (int32_t k = 0; k < c->m->n_switches; k++) {
        const switch_place *x = switch_of(c, k);
        const double side = c->s.side[k], end = c->number[x->argument];
        if (!x->is_of_motion || !(arguments_kept(c, SEEN)[k] != 0.0 || is_off(c, k, end))) continue;
        double beyond = beyond_side(x->kind, end, side);
        for (const double *inside = arguments_kept(c, AT_LEAST) + 2 * k; inside <= arguments_kept(c, AT_LARGEST) + 2 * k; inside += 2 * (int64_t)c->m->n_switches)
            beyond = fmax(beyond, inside[1] != inside[1] ? INFINITY : beyond_side(x->kind, inside[1], side));
        arguments_kept(c, BY_ROUNDING)[k] = end == end && beyond <= rounding_of(c, x);
    }
}

/* The same step with another length, from time t. */
static int32_t step_anew(context *c, step_function take, double t, double h)
{
    restore_state(c, c->k.switch_backup, t, t);
    sense(c, 0.0, 0);
    set_laws(c, t, 0);
    begin_watched(c, h);
    c->unweighted = 0;
    return take(c, h);
}

/* Arguments of the switches of the motion at the present state (n_switches, overwritten); whether one is off its side. */
static int look_at_switches(context *c, double *argument)
{
    int off = 0;
    c->k.watched[1] = -INFINITY; /* that the end is off its side is no news */
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
    for (int32_t k = 0; k < c->m->n_switches; k++) {
        const switch_place *x = switch_of(c, k);
        argument[k] = c->number[x->argument];
        off |= is_off(c, k, argument[k]);
    }
    return off;
}

/* Where between two lengths the first switch is crossed, by lines through the arguments there; their middle where these do not tell. */
static double crossing_between(const context *c, double low, double high, const double *at_low, const double *at_high)
{
    double first = high;
    for (int32_t k = 0; k < c->m->n_switches; k++) {
        const switch_place *x = switch_of(c, k);
        const double side = c->s.side[k], level = x->kind == SWITCH_LEVEL ? side + (at_high[k] >= side) : 0.0;
        if (!is_off(c, k, at_high[k])) continue;
        const double part = (level - at_low[k]) / (at_high[k] - at_low[k]);
        first = fmin(first, part >= 0.0 && part <= 1.0 ? low + part * (high - low) : low + 0.5 * (high - low));
    }
    return first;
}

/* Whether the end of a step from time t, made with this status, is behind a switch; arguments there are overwritten. A step that
   fails behind one has none. */
static int is_behind(context *c, int32_t status, double *argument)
{
    if (!status) return look_at_switches(c, argument);
    for (int32_t k = 0; k < c->m->n_switches; k++) argument[k] = arguments_kept(c, SEEN)[k] != 0.0 && arguments_kept(c, BY_ROUNDING)[k] == 0.0 ? NAN : c->s.side[k];
    return 1;
}

/* Whether a switch that stands on its level leaves it in a step. */
static int leaves_level(const context *c, const double *argument)
{
    for (int32_t k = 0; k < c->m->n_switches; k++)
        if (switch_of(c, k)->kind == SWITCH_SIGN && c->s.side[k] == 0.0 && is_off(c, k, argument[k])) return 1;
    return 0;
}

/* Where the parabola through three places is lowest, and how low it is there; NaN if it is not between them. */
static double lowest_between(const double *x, const double *y, double *least)
{
    const double before = (y[1] - y[0]) / (x[1] - x[0]), after = (y[2] - y[1]) / (x[2] - x[1]), bend = (after - before) / (x[2] - x[0]);
    const double lowest = 0.5 * (x[0] + x[1] - before / bend);
    *least = y[0] + (lowest - x[0]) * (before + (lowest - x[1]) * bend);
    return bend > 0.0 && lowest > x[0] && lowest < x[2] ? lowest : NAN;
}

/* Looks in a step of length h from time t for a switch that leaves its side upwards (way = 1) or downwards (-1) and comes back, where a
   parabola through its arguments at the ends and inside comes near to the level. Returns a length at which one is off its side or was
   seen so, the step to which is made, or 0: then the whole step is made again. */
HM_SELDOM static double find_turn(context *c, step_function take, double t, double h, int32_t k, int way, int32_t *status)
{
    const switch_place *x = switch_of(c, k);
    const double side = c->s.side[k], *inside = arguments_kept(c, way < 0 ? AT_LEAST : AT_LARGEST) + 2 * k;
    const double level = x->kind == SWITCH_LEVEL ? side + (way > 0) : side * way < 0.0 ? 0.0 : way * INFINITY;
    double place[] = {0.0, inside[0] - t, h}, *at = arguments_kept(c, AT_LENGTH);
    double left[] = {way * (level - arguments_kept(c, AT_BEGIN)[k]), way * (level - inside[1]), way * (level - arguments_kept(c, AT_HIGH_LENGTH)[k])};
    int tried = 0;
    const int is_on = x->is_of_motion && !is_off(c, k, arguments_kept(c, AT_HIGH_LENGTH)[k]);
    while (is_on && tried < MOST_LOOKS && place[1] > place[0] && place[1] < place[2]) {
        double least;
        const double lowest = lowest_between(place, left, &least);
        if (!(lowest > NO_PIECE * h && least < COMES_NEAR * (fmax(left[0], left[2]) - least))) break;
        *status = step_anew(c, take, t, lowest);
        if (is_behind(c, *status, at) || has_seen_switch(c)) return lowest;
        const double there = way * (level - at[k]);
        const int is_better = !tried++ || there < left[1], is_before = lowest < place[1], end = is_before == is_better ? 2 : 0;
        if (tried > 1) place[end] = is_better ? place[1] : lowest, left[end] = is_better ? left[1] : there;
        if (is_better) place[1] = lowest, left[1] = there;
    }
    if (tried) *status = step_anew(c, take, t, h);
    return 0.0;
}

/* The same for all switches. */
HM_SELDOM static double find_turns(context *c, step_function take, double t, double h, int32_t *status)
{
    double turn = 0.0;
    for (int32_t k = 0; k < c->m->n_switches && turn == 0.0; k++)
        for (int way = -1; way <= 1 && turn == 0.0 && !*status; way += 2) turn = find_turn(c, take, t, h, k, way, status);
    return turn;
}

/* Whether a switch was seen off its side that is on it at the end of the last length behind one. */
static int has_other_seen(const context *c)
{
    for (int32_t k = 0; k < c->m->n_switches; k++)
        if (arguments_kept(c, SEEN)[k] != 0.0 && arguments_kept(c, BY_ROUNDING)[k] == 0.0 && !is_off(c, k, arguments_kept(c, AT_HIGH_LENGTH)[k])) return 1;
    return 0;
}

/* Ends a step of length *h from time t, just made with this status, at the first crossing of a switch in it, if there is one:
   *crossed = 1, and *h is its length then, 0 if that is where it begins. */
HM_SELDOM static int32_t find_switch(context *c, step_function take, double t, double *h, int32_t status, int *crossed)
{
    const int32_t n = c->m->n_switches;
    double *at_low = arguments_kept(c, AT_LOW_LENGTH), *at_high = arguments_kept(c, AT_HIGH_LENGTH), *at = arguments_kept(c, AT_LENGTH);
    const double least = CLOSER * *h, round = 4e-16 * (fabs(t) + *h);
    double low = 0.0, high = *h, made = *h, last = INFINITY;
    *crossed = 0;
    if (!n || !c->m->n_motion_switches) return status;
    forgive_rounding(c, status);
    if (status && !has_seen_switch(c)) return status;
    int32_t failed = status;
    while (!is_behind(c, status, at_high)) { /* it may have been crossed there and back */
        const int is_seen = has_seen_switch(c);
        const double turn = is_seen ? 0.5 * high : high > least ? find_turns(c, take, t, high, &status) : 0.0;
        if (turn == 0.0 || !(high > least)) {
            *h = high;
            return status;
        }
        made = high = turn;
        if (is_seen) status = step_anew(c, take, t, high);
        failed = status;
        if (status && !has_seen_switch(c)) return status;
    }
    restore_state(c, c->k.switch_backup, t, t);
    look_at_switches(c, at_low);
    const double whole = high;
    if (leaves_level(c, at_high)) high = 0.0;
    for (int trial = 0; trial < MOST_TRIALS && high - low > round; trial++) {
        const double width = high - low, guess = crossing_between(c, low, high, at_low, at_high);
        const int halves = failed || (width > 0.5 * last && trial % 3 == 2);
        const double behind = guess + fmax(0.1 * fmin(guess - low, high - guess), 0.5 * round); /* an end may not stand still */
        made = halves || !(behind > low && behind < high) ? low + 0.5 * width : trial % 2 ? behind : fmax(guess, low + 0.5 * round);
        if (!(made > low && made < high)) break;
        last = width;
        status = step_anew(c, take, t, made);
        if (status && !has_seen_switch(c) && !failed) return status;
        const int is_late = is_behind(c, status, at);
        memcpy(is_late ? at_high : at_low, at, sizeof(double) * (size_t)n);
        if (is_late) high = made, failed = status;
        else low = made;
    }
    int is_known = !failed;
    for (int32_t k = 0; k < n; k++) is_known |= at_high[k] != at_high[k];
    if (!is_known) return failed; /* for another reason */
    *h = failed ? low : high;
    *crossed = 1;
    if (!(*h > NO_PIECE * whole)) {
        *h = 0.0;
        restore_state(c, c->k.switch_backup, t, t);
        return HOLONOM_OK;
    }
    if (made != *h || status) status = step_anew(c, take, t, *h);
    if (status || failed || !(*h > least)) return status;
    const int is_seen = has_other_seen(c); /* another one was crossed there and back before */
    const double turn = is_seen ? 0.5 * *h : find_turns(c, take, t, *h, &status);
    if (turn == 0.0) return status;
    *h = turn;
    return find_switch(c, take, t, h, is_seen ? step_anew(c, take, t, turn) : status, crossed);
}

/* Signals and their rates (signal1, signal_before) at time t, on the sides that they leave. */
static void keep_signals(const context *c, double t)
{
    if (!c->m->n_signals) return;
    signals_at(c, t, c->k.signal1);
    signal_rates_at(c, t, c->k.signal_before);
}

/* Begins anew on other sides from time t on. Signals and their rates were those of keep_signals. */
HM_SELDOM static int32_t begin_on_sides(context *c, double t)
{
    double *now = c->k.signal_rate;
    int jumps = 0;
    if (c->m->n_signals) signals_at(c, t, now);
    for (int32_t b = 0; b < c->m->n_signals; b++)
        if (has_another_value(now[b], c->k.signal1[b])) return HOLONOM_SIGNAL_JUMPS;
    if (c->m->n_signals) signal_rates_at(c, t, now);
    for (int32_t b = 0; b < c->m->n_signals; b++) jumps |= now[b] != c->k.signal_before[b];
    c->stop = NAN;
    start_anew(c);
    c->s.head[S_SWITCHED] += 1.0;
    c->quick = t - c->switched > c->pause ? 0 : c->quick + 1;
    c->switched = t;
    if (!(c->s.head[S_SWITCHED] < MOST_CHANGES && c->quick < MOST_QUICK)) return HOLONOM_LAW_SWITCHES;
    return jumps ? jump_with_signals(c) : HOLONOM_OK;
}

/* Blames a switch, by its number and 1, for a failure at it. */
static int32_t blame_switch(context *c, int32_t status, int32_t k)
{
    if (status) c->at_fault = 1 + k;
    return status;
}

/* Changes the sides of switches of the time. Signals whose rates jump take velocities along. */
HM_SELDOM static int32_t pass_time(context *c, double time)
{
    keep_signals(c, time);
    double *before = arguments_kept(c, AT_LOW_LENGTH);
    memcpy(before, c->s.side, sizeof(double) * (size_t)c->m->n_switches);
    settle_sides(c, time, 1);
    int32_t first = c->m->n_switches - 1;
    for (int32_t k = first; k >= 0; k--)
        if (before[k] != c->s.side[k]) first = k;
    return blame_switch(c, begin_on_sides(c, time), first);
}

/* Changes the sides of the switches that find_switch has ended a step at: their arguments, just behind, are those of the last length
   tried that was too long. Others change that depend on them. */
HM_SELDOM static int32_t pass_motion(context *c)
{
    const int32_t n = c->m->n_switches;
    const double *at_high = arguments_kept(c, AT_HIGH_LENGTH);
    int32_t last = 0;
    keep_signals(c, c->t);
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
    for (int32_t k = 0; k < n; k++) {
        const switch_place *x = switch_of(c, k);
        const double g = at_high[k], side = c->s.side[k];
        if (!is_off(c, k, g)) continue;
        last = k;
        if (x->kind == SWITCH_LEVEL) c->s.side[k] = g == g ? floor(g) : c->number[x->argument] < side + 0.5 ? side - 1.0 : side + 1.0;
        else c->s.side[k] = g == g ? (double)((g > 0.0) - (g < 0.0)) : -side;
    }
    set_laws(c, c->t, 1);
    return blame_switch(c, begin_on_sides(c, c->t), last);
}

/* Shortens a step from time t, in a communication step of length `step` that goes on for `rest`, to the next switch of the time;
   passes it if it is now. *stops = 1 if it ends at one. */
HM_SELDOM static int32_t stop_at_switch(context *c, double t, double rest, double step, double *h, int *stops)
{
    const double round = rounding_of_time(t, step);
    double stop;
    *stops = 0;
    if (!c->m->switching) return HOLONOM_OK;
    while ((stop = next_stop(c, t, c->start + step)) <= t + round) {
        const int32_t status = pass_time(c, stop);
        if (status) return status;
    }
    if (stop < t + rest - round && stop <= t + *h + round) {
        *h = stop - t;
        *stops = 1;
    }
    return HOLONOM_OK;
}

/* Sides at the end of a communication step that ends where a switch of the time changes. */
HM_SELDOM static int32_t end_at_switch(context *c, double t, double step)
{
    c->t = t;
    c->stop = NAN;
    const double round = rounding_of_time(t, step);
    if (next_stop(c, t, t + 2.0 * round) > t + round) return HOLONOM_OK;
    end_line(c);
    return pass_time(c, c->stop);
}

#endif
