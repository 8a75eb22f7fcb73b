/* What happens where sides of switches change: at the end of a step that a switch of the motion has
   cut (switch_event.h), and when one of the time does. */
#ifndef HOLONOM_SIDE_CHANGES_H
#define HOLONOM_SIDE_CHANGES_H

#include "switch_event.h"

/* Changes of sides in a communication step, and in turn without a pause. */
enum { MOST_CHANGES = 1000000, MOST_QUICK = 1000 };

/* Signals and their rates (signal1, signal_before) at time t, on the sides that they leave. */
static void keep_signals(const context *c, double t)
{
    signals_at(c, t, c->k.signal1);
    signal_rates_at(c, t, c->k.signal_before);
}

/* Begins anew on other sides from time t on. Signals and their rates were those of keep_signals. */
HM_SELDOM static int32_t begin_on_sides(context *c, double t)
{
    signals_at(c, t, c->k.signal_rate);
    if (have_jumped(c, c->k.signal_rate, c->k.signal1)) return HOLONOM_SIGNAL_JUMPS;
    seek_stop_anew(c);
    start_anew(c);
    c->s.head[S_SWITCHED] += 1.0;
    c->switches.quick = t - c->switches.last > c->switches.pause ? 0 : c->switches.quick + 1;
    c->switches.last = t;
    if (!(c->s.head[S_SWITCHED] < MOST_CHANGES && c->switches.quick < MOST_QUICK))
        return HOLONOM_LAW_SWITCHES;
    return jump_with_signals(c, t);
}

/* Blames a switch that has changed, by its number and 1, for a failure at it. */
static int32_t blame_switch(context *c, int32_t status, int32_t k)
{
    c->switches.which = k;
    if (status) c->step.at_fault = 1 + k;
    return status;
}

/* Changes the sides of switches of the time. Signals whose rates jump take velocities along. */
HM_SELDOM static int32_t pass_time(context *c, double time)
{
    keep_signals(c, time);
    const int32_t status = settle_and_tick(c, time);
    if (status) return status;
    int32_t first = n_switches(c) - 1;
    for (int32_t k = first; k >= 0; k--)
        if (c->k.side_before[k] != c->s.side[k]) first = k;
    return blame_switch(c, begin_on_sides(c, time), first);
}

/* The same within a communication step. */
static int32_t pass_stop(context *c, double time)
{
    const int32_t status = pass_time(c, time);
    if (!status && mesh_of(c)) say_switch(c, END_TIME, c->switches.which, time);
    return status;
}

/* Goes on from the present state on these sides (n_switches), of which k has changed. */
HM_SELDOM static int32_t take_sides(context *c, const double *side, int32_t k)
{
    keep_signals(c, c->t);
    sense(c, 0.0, 0);
    set_laws(c, c->t, 1);
    memcpy(c->s.side, side, sizeof(double) * (size_t)n_switches(c));
    set_laws(c, c->t, 1);
    return blame_switch(c, begin_on_sides(c, c->t), k);
}

/* Changes the sides of the switches that find_switch has ended a step at: their arguments, just
   behind, are those of the last length tried that was too long. Others change that depend on
   them. */
HM_SELDOM static int32_t pass_motion(context *c)
{
    const int32_t n = n_switches(c);
    const double *at_high = c->k.argument_high;
    double *sides = c->k.argument_low, *at_end = c->k.argument_tried;
    int32_t last = 0;
    look_at_switches(c, at_end);
    memcpy(sides, c->s.side, sizeof(double) * (size_t)n);
    for (int32_t k = 0; k < n; k++) {
        const double g = at_high[k], side = sides[k];
        if (!is_off(c, k, g)) continue;
        last = k;
        if (switch_of(c, k)->kind == SWITCH_LEVEL)
            sides[k] = g == g                    ? floor(g)
                       : at_end[k] < side + 0.5 ? side - 1.0
                                                 : side + 1.0;
        else sides[k] = g == g ? (double)((g > 0.0) - (g < 0.0)) : -side;
    }
    const int32_t status = take_sides(c, sides, last);
    if (!status && mesh_of(c)) say_switch(c, END_SWITCH, last, at_end[last]);
    return status;
}

/* Changes the sides of the switch at the end of a piece, if it has come there. The mesh keeps which
   one a piece crosses there and back, in less time than is looked at. */
static int32_t pass_switch(context *c, const piece *x)
{
    if (x->crossed) return pass_motion(c);
    for (int32_t k = 0; mesh_of(c) && n_motion_switches(c) && k < n_switches(c); k++)
        if (c->k.seen[k] != 0.0 && c->k.by_rounding[k] == 0.0)
            last_row(c)[MESH_FUNCTION] = c->m->n_contacts + c->m->n_frictions + k;
    return x->stops ? pass_stop(c, c->switches.next) : HOLONOM_OK;
}

/* Shortens a piece, in a communication step of length `step` that goes on for `rest`, to the next
   switch of the time, which is passed if it is now. */
HM_SELDOM static int32_t stop_at_switch(context *c, piece *x, double rest, double step)
{
    const double t = x->t, round = rounding_of_time(t, step);
    double stop;
    if (!n_switches(c)) return HOLONOM_OK;
    while ((stop = next_stop(c, t, c->laws.start + step)) <= t + round) {
        const int32_t status = pass_stop(c, stop);
        if (status) return status;
    }
    x->stops = stop < t + rest - round && stop <= t + x->length + round;
    if (x->stops) x->length = stop - t;
    return HOLONOM_OK;
}

/* Sides at the end of a communication step that ends where a switch of the time changes. */
HM_SELDOM static int32_t end_at_switch(context *c, double t, double step)
{
    c->t = t;
    c->switches.next = NAN;
    const double round = rounding_of_time(t, step);
    if (next_stop(c, t, t + 2.0 * round) > t + round) return HOLONOM_OK;
    end_line(c);
    return pass_time(c, c->switches.next);
}

#endif
