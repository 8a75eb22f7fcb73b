/* Which steps the settings of a run choose; solver/options.py has the same for pages and checks. */
#ifndef HOLONOM_CHOSEN_STEPS_H
#define HOLONOM_CHOSEN_STEPS_H

#include "internal.h"

/* Tolerance of a run, or 0 for equal steps. That of an importer may be tighter than what is set, and neither loosens it nor turns
   equal steps into others: many importers pass one that nobody chose. */
static inline double hm_tolerance(const double *head)
{
    if (head[S_CONTACT_MODE] != 0.0) return 0.0; /* stepped */
    const int is_open = head[S_STEP_SIZE] == 0.0 && head[S_ORDER] == 0.0 && head[S_TOLERANCE] == 0.0;
    const double own = is_open ? HOLONOM_USUAL_TOLERANCE : head[S_TOLERANCE], host = head[S_HOST_TOLERANCE];
    return host > 0.0 ? fmin(own, host) : own;
}

/* Longest of equal steps [s]. */
static inline double hm_step_size(const double *head)
{
    return head[S_STEP_SIZE] > 0.0 ? head[S_STEP_SIZE] : HOLONOM_USUAL_STEP;
}

#endif
