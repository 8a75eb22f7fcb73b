/* Whether equal steps are too long for the motion (theory 8.6).

   A body that turns by x in a step of order p errs by C x^(p+1), at order 2 by x^3/48; limits of higher orders are turns with about
   the same error a step. What pairs of order 2 add to the error of a run is the estimate of their control, at every few steps. */
#ifndef HOLONOM_COARSENESS_H
#define HOLONOM_COARSENESS_H

#include "internal.h"

#define MOST_OF_THE_PATH 0.03 /* estimated error of a run, over size and speed: true ones exceed 1e-2 */
enum { STEPS_A_LOOK = 8 };    /* an estimate costs some percent of a step of small mechanisms */

/* Turn of a body in a step, by the order of steps [rad]: beyond, some hundred steps err by more than 1e-2. */
static inline double hm_longest_turn(const double *head)
{
    const double order = head[S_STEPPED] != 0.0 ? 2.0 : head[S_ORDER];
    return order > 6.0 ? 2.5 : order > 4.0 ? 2.0 : order > 2.0 ? 1.0 : 0.22;
}

/* Whether the present step of order 2 is one that is looked at. */
static inline int hm_is_looked_at(double steps) { return steps - STEPS_A_LOOK * floor(steps / STEPS_A_LOOK) == 2.0; }

/* Error of so many equal steps, if they add as much as those looked at, which are the second one and every eighth from there on; 0
   where nothing tells it. */
static inline double hm_error_of_steps(const double *head, double steps)
{
    const double looks = floor((head[S_EQUAL_STEPS] + (STEPS_A_LOOK - 2)) / STEPS_A_LOOK);
    return looks > 0.0 ? head[S_ERRORS_SEEN] / looks * steps : 0.0;
}

#endif
