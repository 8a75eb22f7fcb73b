/* Where the solution of a half step is sought first (theory 3.5).

   Accelerations and multipliers of a half step depend on its length and on which half of its pair it is, so that they
   jump from half to half of an internal step, by nearly what they jumped by in the internal step before. The state
   keeps these changes, one slot for each half of an internal step, as many as the order at assembly asks for. */
#ifndef HOLONOM_PREDICT_H
#define HOLONOM_PREDICT_H

#include "context.h"
#include "forms.h"

/* Of how many internal steps before it the changes are known and used: 1 and 2 give linear and quadratic extrapolation,
   0 leaves the values of the same half of the last pair. The formulations that do not conserve swing up from half to
   half, where a line leads astray. */
static int known_changes(const context *c)
{
    const double known = hm_skips(SKIP_OLD_GUESS) ? c->s.head[S_KNOWN] : 0.0;
    if (!is_conserving(c) || c->halves > c->m->n_slots || known < c->halves + 1) return 0;
    return 2 * c->halves <= c->m->n_slots && known >= 2 * c->halves + 1 ? 2 : 1;
}

/* Predicted value i of n: `same` and `last` belong to the same half of the last pair and to the last half. */
static inline double predicted(const context *c, int reach, const double *same, const double *last,
                               const double *change, int64_t n, int64_t i)
{
    const double *now = change + n * c->half, *before = now + n * c->halves;
    if (reach == 0) return same[i];
    return last[i] + (reach == 1 ? now[i] : 2.0 * now[i] - before[i]);
}

/* How many changes of a half the state keeps: none, that of this internal step, or that of the one before it too. */
static inline int n_kept(const context *c) { return (c->halves <= c->m->n_slots) + (2 * c->halves <= c->m->n_slots); }

/* Takes over value i of n that has just been solved for, and its change from the last half, of which `kept` are. */
static inline void remember(const context *c, int kept, double fresh, double *value, double last, double *change,
                            int64_t n, int64_t i)
{
    double *now = change + n * c->half + i;
    if (kept == 2) now[n * c->halves] = *now;
    if (kept) *now = fresh - last;
    value[i] = fresh;
}

/* No line through what was before and what is after a jump, or over internal steps of another kind. */
static void forget_changes(context *c) { c->s.head[S_KNOWN] = 0.0; }

/* Begins an internal step of so many halves. */
static void begin_halves(context *c, int halves)
{
    if (c->s.head[S_HALVES] != halves) forget_changes(c);
    c->s.head[S_HALVES] = c->halves = halves;
    c->factors_h = 0.0;
    c->rows_known = 0;
}

#endif
