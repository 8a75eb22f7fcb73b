/* Switches: what decides between the smooth pieces of laws and signals (theory 8.6).

   A comparison, floor, abs, min, ... reads on which side its argument is. Sides belong to the
   state; they stand within a step, so that laws are smooth even a little beyond a switch, and
   change where a step ends. Those of the time alone are known beforehand: the next time at which an
   argument leaves its side is found by ranges (ranges.c), none is missed, and bisection gives it to
   the last bit. */
#ifndef HOLONOM_SWITCHES_H
#define HOLONOM_SWITCHES_H

#include "inputs_signals.h"

/* Side on which an argument is from now on. */
static double side_after(int kind, hm_jet g)
{
    if (g.value != g.value) return g.value;
    if (kind == SWITCH_SIGN) return hm_sign_after(g);
    return floor(g.value) - (g.value == floor(g.value) && hm_falls(g));
}

static double argument_at(const context *c, const switch_place *x, double t)
{
    load_inputs(c, t);
    c->number[c->m->time_at] = t;
    hm_run_tape(c->m, c->number, x->segment);
    return c->number[x->argument];
}

#define A_LITTLE_LATER                                                                             \
    2.4e-7 /* [s], when arguments tell where they go that begin with neither a rate nor a second   \
              derivative */

/* Side on which the argument of a switch of the time is just after t, where its jet does not
   tell. */
HM_SELDOM static double side_later(const context *c, const switch_place *x, double t)
{
    const double g = argument_at(c, x, t + A_LITTLE_LATER);
    return side_after(x->kind, (hm_jet){g, 0.0, 0.0});
}

/* Values and rates of all arguments at time t and the present state, with the sides as they are. */
HM_SELDOM static void run_arguments(const context *c, double t)
{
    const holonom_model *m = c->m;
    load_jets(c, t, 1);
    for (int32_t j = 0; j < m->n_active && n_motion_switches(c); j++) {
        c->k.jet[2 * (m->sensor_at + j)] = c->number[m->sensor_rate_at + j];
        c->k.jet[2 * (m->sensor_rate_at + j)] = 0.0; /* accelerations depend on sides */
    }
    hm_run_jets(m, c->number, 1, c->k.jet);
    load_jets(c, t, 2);
    hm_run_jets(m, c->number, 2, c->k.jet);
}

/* When sides or inputs change, another switch may be the next one. */
static void seek_stop_anew(context *c)
{
    c->switches.next = NAN;
    c->s.head[S_QUIET_UNTIL] = -1e300; /* a state is finite */
}

/* Sides of all switches from time t on, at the present state; stored energy that springs of other
   sides have is work. Where `is_booked` is 0 nothing has happened before. */
HM_SELDOM static void settle_sides(context *c, double t, int is_booked)
{
    double *sides = c->k.seen;
    if (!n_switches(c)) return;
    if (n_motion_switches(c)) sense(c, 0.0, 0);
    set_laws(c, t, is_booked);
    memcpy(sides, c->s.side, sizeof(double) * (size_t)n_switches(c));
    for (int32_t pass = 0, changed = 1; changed && pass <= n_switches(c);
         pass++) { /* each depends on those before it */
        changed = 0;
        run_arguments(c, t);
        for (int32_t k = 0; k < n_switches(c); k++) {
            const switch_place *x = switch_of(c, k);
            const int32_t at = x->argument;
            const hm_jet g = {c->number[at], c->k.jet[2 * at], c->k.jet[2 * at + 1]};
            const int is_told = x->is_of_motion || g.rate != 0.0 || g.bend != 0.0
                                || g.value != (x->kind == SWITCH_LEVEL ? floor(g.value) : 0.0);
            const double side = is_told ? side_after(x->kind, g) : side_later(c, x, t);
            changed |= memcmp(&side, c->s.side + k, sizeof side) != 0;
            c->s.side[k] = side;
        }
    }
    for (int32_t k = 0; k < n_switches(c);
         k++) { /* booked from the laws as they were to those that they are */
        const double side = sides[k];
        sides[k] = c->s.side[k];
        c->s.side[k] = side;
    }
    set_laws(c, t, 0);
    memcpy(c->s.side, sides, sizeof(double) * (size_t)n_switches(c));
    set_laws(c, t, is_booked);
    seek_stop_anew(c);
}

/* ------------------------------------------------------------------------------ sampled states */

/* Of a sampled state: the place of its next value, and the switch of its clock, whose side counts
   the ticks. */
typedef struct held_place {
    int32_t next, clock;
} held_place;

static inline const held_place *held_of(const context *c, int32_t j)
{ return (const held_place *)(const void *)c->m->held_table + j; }

/* Whether the clock of sampled state j has gone on from its sides `before`; at the start, NULL,
   whether it ticks there. */
static int has_ticked(const context *c, int32_t j, const double *before)
{
    const int32_t k = held_of(c, j)->clock;
    return before ? c->s.side[k] > before[k]
                  : c->number[switch_of(c, k)->argument] == c->s.side[k];
}

/* Sampled states whose clocks have ticked at time t take their next values, all of the state as it
   was: quantities, inputs, and what is held. */
HM_SELDOM static int32_t tick(context *c, double t, const double *before, int is_booked)
{
    const holonom_model *m = c->m;
    int32_t ticks = 0;
    for (int32_t j = 0; j < m->n_held; j++) ticks += has_ticked(c, j, before);
    if (!ticks) return HOLONOM_OK;
    sense(c, 0.0, 0);
    set_laws(c, t, 0);
    hm_run_tape(m, c->number, 4);
    for (int32_t j = 0; j < m->n_held; j++) {
        const double next = c->number[held_of(c, j)->next];
        c->k.held_next[j] = has_ticked(c, j, before) ? next : c->s.held[j];
        if (fabs(c->k.held_next[j]) < INFINITY) continue;
        c->step.at_fault = 1 + held_of(c, j)->clock;
        return HOLONOM_NEXT_STATE;
    }
    memcpy(c->s.held, c->k.held_next, sizeof(double) * (size_t)m->n_held);
    set_laws(c, t, is_booked);
    return HOLONOM_OK;
}

/* Sides of all switches from time t on, and sampled states whose clocks have ticked since. */
HM_SELDOM static int32_t settle_and_tick(context *c, double t)
{
    memcpy(c->k.side_before, c->s.side, sizeof(double) * (size_t)n_switches(c));
    settle_sides(c, t, 1);
    return tick(c, t, c->k.side_before, 1);
}

/* ------------------------------------------------------------------------- switches of the time */

/* Range of a number a0 + a1 u + a2 u^2 + a3 u^3 and its rate from u to v. */
static void set_range_of_input(const context *c, int32_t i, double u, double v)
{
    const hm_state *s = &c->s;
    const int32_t place = c->m->input_at + i;
    const double x = 0.5 * (u + v), half = 0.5 * (v - u), third = 6.0 * s->inputs_third[i];
    const double bend = 2.0 * s->inputs_bend[i] + third * x,
                 rate = s->inputs_slope[i] + x * (2.0 * s->inputs_bend[i] + 0.5 * third * x);
    const double value =
        s->inputs_before[i]
        + x * (s->inputs_slope[i] + x * (s->inputs_bend[i] + x * s->inputs_third[i]));
    const double wide = half * (fabs(rate) + half * (0.5 * fabs(bend) + half * fabs(third) / 6.0))
                        + 1e-15 * fabs(value);
    const double wide_rate = half * (fabs(bend) + 0.5 * half * fabs(third)) + 1e-15 * fabs(rate);
    if (c->m->input_course[i] == INPUT_HELD)
        hm_set_range(c->k.bounds, place, s->inputs[i], s->inputs[i], 0.0, 0.0);
    else
        hm_set_range(c->k.bounds, place, value - wide, value + wide, rate - wide_rate,
                     rate + wide_rate);
}

/* Range of the argument of a switch, and of its rate (4), from time a to b. */
HM_SELDOM static const double *range_between(const context *c, const switch_place *x, double a,
                                             double b)
{
    const holonom_model *m = c->m;
    load_inputs(c, a);
    hm_stop_ranges(m, c->number, x->segment, c->k.bounds);
    hm_set_range(c->k.bounds, m->time_at, a, b, 1.0, 1.0);
    for (int32_t i = 0; i < m->n_inputs; i++)
        set_range_of_input(c, i, a - c->laws.start, b - c->laws.start);
    hm_run_ranges(m, c->number, x->segment, c->k.bounds);
    return c->k.bounds + 4 * (int64_t)x->argument;
}

enum { UPWARDS = 1, DOWNWARDS = -1, ANYWHERE = 0 };

/* Whether an argument has left its side in a direction; at the beginning it may still be on the
   other one by rounding. */
static int has_left(int kind, double g, double side, int direction)
{
    if (direction == ANYWHERE || g != g || side != side || (kind == SWITCH_SIGN && side == 0.0))
        return is_off_side(kind, g, side);
    if (direction == UPWARDS) return kind == SWITCH_SIGN ? side < 0.0 && g > 0.0 : g > side + 1.0;
    return kind == SWITCH_SIGN ? side > 0.0 && g < 0.0 : g < side;
}

/* First double in (a, b] at which it has left, if it has at b. A line through both ends, as which
   clocks go, leads there but for round-off; halves do the rest. */
HM_SELDOM static double first_left(const context *c, const switch_place *x, double side,
                                   int direction, double a, double b)
{
    const double at_b = argument_at(c, x, b);
    if (!has_left(x->kind, at_b, side, direction)) return INFINITY;
    const double at_a = argument_at(c, x, a),
                 level = x->kind == SWITCH_LEVEL ? side + (at_b > side) : 0.0,
                 guess = a + (level - at_a) / (at_b - at_a) * (b - a),
                 around = 1e-15 * (fabs(a) + fabs(b)), near[] = {guess - around, guess + around};
    for (int i = 0; i < 2 && direction != ANYWHERE; i++) {
        if (!(near[i] > a && near[i] < b)) continue;
        if (has_left(x->kind, argument_at(c, x, near[i]), side, direction)) b = near[i];
        else a = near[i];
    }
    for (;;) {
        const double middle = a + 0.5 * (b - a);
        if (!(middle > a && middle < b)) return b;
        if (has_left(x->kind, argument_at(c, x, middle), side, direction)) b = middle;
        else a = middle;
    }
}

/* Halvings of an interval; ranges looked at until only its end is. */
enum { DEEPEST = 48, MOST_RANGES = 4000 };

/* First time in (a, b] at which an argument leaves its side, or infinity. */
HM_SELDOM static double leaves_between(const context *c, const switch_place *x, double side,
                                       double a, double b, int depth, int *left)
{
    const double *range = range_between(c, x, a, b);
    const int stays = x->kind == SWITCH_LEVEL ? range[0] >= side && range[1] <= side + 1.0
                      : side > 0.0            ? range[0] >= 0.0
                      : side < 0.0            ? range[1] <= 0.0
                                              : range[0] == 0.0 && range[1] == 0.0;
    if (stays) return INFINITY;
    if (side != side) return first_left(c, x, side, ANYWHERE, a, b);
    if (range[2] > 0.0) return first_left(c, x, side, UPWARDS, a, b);
    if (range[3] < 0.0) return first_left(c, x, side, DOWNWARDS, a, b);
    const double middle = a + 0.5 * (b - a);
    if (depth == DEEPEST || --*left < 0 || !(middle > a && middle < b))
        return first_left(c, x, side, ANYWHERE, a, b);
    const double first = leaves_between(c, x, side, a, middle, depth + 1, left);
    return first < INFINITY ? first : leaves_between(c, x, side, middle, b, depth + 1, left);
}

/* Times so near to each other are one. */
static double rounding_of_time(double t, double step) { return 2e-15 * fabs(t) + 1e-14 * step; }

#define LOOKS_AHEAD                                                                                \
    64.0 /* communication steps, as long as no input moves: a look costs as much as some steps of  \
            a small mechanism */

/* Next time at which a switch of the time changes, infinite if that is after `end`. It stands until
   sides change. */
HM_SELDOM static double next_stop(context *c, double t, double end)
{
    const holonom_model *m = c->m;
    const double law_time = c->number[m->time_at];
    if (c->switches.next == c->switches.next) return c->switches.next;
    c->switches.next = INFINITY;
    if (n_motion_switches(c) == n_switches(c) || end < c->s.head[S_QUIET_UNTIL])
        return c->switches.next;
    const double last = move_inputs(c) ? end : end + LOOKS_AHEAD * (end - c->laws.start);
    for (int32_t k = 0; k < n_switches(c); k++) {
        int left = MOST_RANGES;
        if (switch_of(c, k)->is_of_motion) continue;
        c->switches.next =
            fmin(c->switches.next, leaves_between(c, switch_of(c, k), c->s.side[k], t,
                                                  fmin(c->switches.next, last), 0, &left));
    }
    const double known = fmin(c->switches.next, last);
    c->s.head[S_QUIET_UNTIL] = known - 4.0 * rounding_of_time(known, end - c->laws.start);
    set_laws(c, law_time, 0);
    return c->switches.next;
}

#endif
