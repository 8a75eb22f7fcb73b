/* What steps tell the steps after them of Newton's contraction, so that one increment may end a
   step.

   Fresh full factors leave of a short increment its square over the size of the step, times the
   bend of the equations; lean ones lack the stiffness, and leave h^2 times a part. Second
   increments measure both. */
#ifndef HOLONOM_LEARNED_CONTRACTION_H
#define HOLONOM_LEARNED_CONTRACTION_H

#include "newton_record.h"

/* A second increment that is shorter than this, over the size of the step, may be round-off (up to
   5e-14 in a wishbone), of which bends would show the most. It is never more than the contraction
   makes of the first and round-off. */
#define ROUND_OFF_SHOWS(c) (is_lean(c) ? 1e-14 : 1e-12)
/* Bends of 0.1 to 0.5 were measured where bodies turn, of 1e3 near singular configurations. They
   may change after they are measured (double pendulum, 1e6 steps of 10 ms: energy 4e-15 with this
   one at least, a passing 1e-13 with 0.1). */
#define LEAST_BEND 1.0
#define LEAST_LEAN_CONTRACTION 1e-8
/* Nothing is learned in steps that take one increment: trust in what was fades with each, until a
   second one tells that it still holds, or that there is nothing but round-off left. */
#define FADING 1.05
#define TRUSTED_AGAIN 0.05

static inline double *learned(context *c)
{ return c->view.scalars + (is_lean(c) ? I_LEAN_CONTRACTION : I_BEND); }

static void learn_contraction(context *c, const newton_record *r)
{
    if (r->increments != 2 || r->iteration != 1 || !r->factors.kept || r->factors.taken_over
        || !(r->first_increment > 0.0))
        return;
    const double contraction = r->eta / r->first_increment,
                 told = contraction / (is_lean(c) ? c->h * c->h : r->first_increment / r->size);
    double *known = learned(c);
    if (*known == 0.0 || told < *known || r->eta > ROUND_OFF_SHOWS(c) * r->size)
        *known = fmin(told, MOST_LEARNED);
    else *known *= TRUSTED_AGAIN;
}

/* After a step of one increment. */
static void trust_less(context *c) { *learned(c) = fmin(FADING * *learned(c), MOST_LEARNED); }

/* What fresh factors leave of a first increment, over its size; 1 where nothing tells it, and with
   frictions, whose cones follow multipliers from one update to the next. */
static double known_contraction(context *c, double first, double size)
{
    const double known = *learned(c);
    if (!(known > 0.0) || (n_frictions(c->m) && !c->view.asleep)) return 1.0;
    return fmin(is_lean(c) ? fmax(known * c->h * c->h, LEAST_LEAN_CONTRACTION)
                           : fmax(known, LEAST_BEND) * first / size,
                1.0);
}

#endif
