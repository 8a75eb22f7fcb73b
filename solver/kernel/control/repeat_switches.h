/* Sides of switches where a mesh is repeated: laws are on those of the recorded steps, and the
   motion has to be there, too. */
#ifndef HOLONOM_REPEAT_SWITCHES_H
#define HOLONOM_REPEAT_SWITCHES_H

#include "control.h"

/* Refuses what switch k does. */
static int32_t refuse_switch(context *c, int32_t k)
{ return blame_switch(c, HOLONOM_MESH_SWITCHES, k); }

/* The switch that a row names, negative if none. */
static int32_t switch_of_row(const context *c, const double *row)
{ return (int32_t)row[MESH_FUNCTION] - c->m->n_contacts - c->m->n_frictions; }

/* The first switch from k on that is on another side than in a row, or their number. */
static int32_t next_other_side(const context *c, const double *row, int32_t k)
{
    const double *side = sides_of_row(row), *now = c->s.side;
    while (k < n_switches(c) && (side[k] == now[k] || (side[k] != side[k] && now[k] != now[k])))
        k++;
    return k;
}

/* How far beyond its side switch k was in the step at hand; what has no value is infinitely far. */
HM_SELDOM static double beyond_in_step(const context *c, int32_t k)
{
    const int kind = switch_of(c, k)->kind;
    const double least = c->k.argument_least[2 * k + 1], largest = c->k.argument_largest[2 * k + 1];
    if (least != least || largest != largest) return INFINITY;
    return fmax(beyond_side(kind, least, c->s.side[k]), beyond_side(kind, largest, c->s.side[k]));
}

/* Refuses a motion that is off the sides of its laws, by more than rounding, at the present state;
   but for switch `except`. */
HM_SELDOM static int32_t check_sides(context *c, int32_t except)
{
    double *at = c->k.argument_high;
    if (!n_motion_switches(c)) return HOLONOM_OK;
    look_at_switches(c, at);
    for (int32_t k = 0; k < n_switches(c); k++) {
        const switch_place *x = switch_of(c, k);
        const double side = c->s.side[k];
        if (k == except || !x->is_of_motion || !is_off_side(x->kind, at[k], side)) continue;
        if (!(beyond_side(x->kind, at[k], side) <= rounding_of(c, x))) return refuse_switch(c, k);
    }
    return HOLONOM_OK;
}

/* Likewise at the end of the step of a row, and in it: stages go a little farther than the end,
   beyond the level of switches that change there, as `next`, the row behind it or NULL, tells. */
HM_SELDOM static int32_t check_step(context *c, const double *row, const double *next)
{
    const int32_t except = switch_of_row(c, row);
    const int32_t status = check_sides(c, except);
    for (int32_t k = 0; !status && n_motion_switches(c) && k < n_switches(c); k++) {
        const int changes =
            k == except || (next && !(sides_of_row(next)[k] == sides_of_row(row)[k]));
        if (c->k.seen[k] == 0.0 || changes) continue;
        if (!(beyond_in_step(c, k) <= rounding_of(c, switch_of(c, k)))) return refuse_switch(c, k);
    }
    return status;
}

/* Lets a piece begin on the sides of its first row, behind one that has ended at switch `except`;
   `stop` is the next time at which a switch changes, infinite if that is not within the
   communication step, of length `step`, which goes on for `rest`. */
HM_SELDOM static int32_t begin_on_row(context *c, const double *row, double rest, double step,
                                      int32_t except, double *stop)
{
    piece x = {.t = c->t, .length = rest};
    int32_t status = stop_at_switch(c, &x, rest, step);
    const int32_t first = status ? n_switches(c) : next_other_side(c, row, 0);
    for (int32_t k = first; k < n_switches(c); k = next_other_side(c, row, k + 1))
        if (!switch_of(c, k)->is_of_motion) return refuse_switch(c, k);
    if (first < n_switches(c)) {
        status = take_sides(c, sides_of_row(row), first);
        if (!status) status = check_sides(c, except);
        x.length = rest;
        if (!status) status = stop_at_switch(c, &x, rest, step);
    }
    *stop = x.stops ? c->switches.next : INFINITY;
    return status;
}

/* Changes the side of the switch of the motion that the step of a row has ended at, and those that
   change with it: they are on their sides of the next row, NULL at the end of a communication
   step. */
HM_SELDOM static int32_t pass_switch_of_row(context *c, const double *row, const double *next)
{
    const int32_t k = switch_of_row(c, row);
    double *side = c->k.argument_low;
    for (int32_t j = 0; j < n_switches(c); j++)
        side[j] = next && switch_of(c, j)->is_of_motion ? sides_of_row(next)[j] : c->s.side[j];
    side[k] = row[MESH_SIDE];
    const int32_t status = take_sides(c, side, k);
    return status || !next ? status : check_sides(c, k);
}

#endif
