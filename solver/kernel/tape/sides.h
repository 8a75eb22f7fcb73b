/* Sides on which laws and signals are, and whether an evaluation finds them left. */
#ifndef HOLONOM_SIDES_H
#define HOLONOM_SIDES_H

#include "context.h"

typedef struct switch_place {
    int32_t argument, side, kind, segment, is_of_motion;
} switch_place;

static inline const switch_place *switch_of(const context *c, int32_t k)
{ return (const switch_place *)(const void *)c->m->switch_table + k; }

/* Kinks that steps end at. Those of energies are of steps of a tolerance alone: slopes of energies
   are exact across them. */
static inline int32_t n_kinks(const context *c)
{ return c->m->n_kinks - (c->tolerance > 0.0 ? 0 : c->m->n_energy_kinks); }

/* Switches that steps end at, and of these how many read the motion. */
static inline int32_t n_switches(const context *c)
{ return c->m->n_switches - c->m->n_kinks + n_kinks(c); }
static inline int32_t n_motion_switches(const context *c)
{ return c->m->n_motion_switches - c->m->n_kinks + n_kinks(c); }

/* Whether an argument is off its side. What has no value is on a side of its own. */
static int is_off_side(int kind, double g, double side)
{
    if (g != g || side != side) return (g != g) != (side != side);
    if (kind == SWITCH_LEVEL) return !(g >= side && g <= side + 1.0);
    return side > 0.0 ? g < 0.0 : side < 0.0 ? g > 0.0 : g != 0.0;
}

/* How far an argument is off its side, or -INFINITY; not a number where it has no value. */
static double beyond_side(int kind, double g, double side)
{
    if (kind == SWITCH_LEVEL) return g == g ? fmax(side - g, g - side - 1.0) : g;
    return side == 0.0 ? fabs(g) : -side * g;
}

/* Remembers arguments of switches where laws are evaluated at time t within the step at hand, and
   that one was off its side. */
HM_SELDOM static void watch_switches(const context *c, double t)
{
    double *seen = c->k.seen, *least = c->k.argument_least, *largest = c->k.argument_largest;
    if (!(t > c->k.watched[0] && t < c->k.watched[1])) return;
    for (int32_t k = 0; k < n_switches(c); k++) {
        const switch_place *x = switch_of(c, k);
        const double g = c->number[x->argument];
        if (x->is_of_motion && is_off_side(x->kind, g, c->s.side[k])) seen[k] = 1.0;
        if (!(g >= least[2 * k + 1])) least[2 * k] = t, least[2 * k + 1] = g;
        if (!(g <= largest[2 * k + 1])) largest[2 * k] = t, largest[2 * k + 1] = g;
    }
}

#endif
