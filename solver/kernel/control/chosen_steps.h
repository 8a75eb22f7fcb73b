/* Which steps the settings of a run choose, by the formulas of solver/options.py. */
#ifndef HOLONOM_CHOSEN_STEPS_H
#define HOLONOM_CHOSEN_STEPS_H

#include "internal.h"

/* Tolerance of a run, or 0 for equal steps. That of an importer may be tighter than what is set,
   and neither loosens it nor turns equal steps into others: many importers pass one that nobody
   chose. */
static inline double hm_tolerance(const double *head)
{
    const double own = HOLONOM_CHOSEN_TOLERANCE(head), host = head[S_HOST_TOLERANCE];
    return host > 0.0 ? fmin(own, host) : own;
}

/* Longest of equal steps [s]. */
static inline double hm_step_size(const double *head) { return HOLONOM_CHOSEN_STEP(head); }

#endif
