/* Whether equal steps are too long for the motion (theory 8.6).

   A pair of half steps of length h in all adds q''' h^3/48 to the error of a place, or of a
   direction, and so x^3/48 to the angle of a body that turns by x in it. Limits of the turn at
   higher orders are those of about the same error a step. */
#ifndef HOLONOM_COARSENESS_H
#define HOLONOM_COARSENESS_H

#include "internal.h"

#define OF_A_PAIR (1.0 / 48.0)
#define LONGEST_LEVER                                                                              \
    10.0 /* times that an error in a sharp bend counts at most: what vibrates on its way bends it, \
            too */
#define MOST_OF_THE_PATH 0.02 /* estimated error of a run, over the size or in rad */
/* Three steps in a row of so many are looked at, which costs some percent of a step of small
   mechanisms; the least error of the three counts for all: a force that jumps in a step shows in
   two. */
enum { STEPS_A_LOOK = 24, FIRST_LOOK = 2, LAST_LOOK = 4 };

/* Order of equal steps. */
static inline double hm_order_of_steps(const double *head)
{ return head[S_STEPPED] != 0.0 ? 2.0 : fmax(head[S_ORDER], 2.0); }

/* Turn of a body in a step, by the order of steps [rad]: beyond, some hundred steps err by more
   than 1e-2. */
static inline double hm_longest_turn(const double *head)
{
    const double order = hm_order_of_steps(head);
    return order > 6.0 ? 2.5 : order > 4.0 ? 2.0 : order > 2.0 ? 1.0 : 0.22;
}

/* Error of so many equal steps, if they add as much as those looked at, of which this is the sum; 0
   where nothing tells it. */
static inline double hm_error_of_steps(const double *head, double sum, double steps)
{
    return head[S_LOOKS] > 0.0 ? sum / head[S_LOOKS] * steps : 0.0;
}

/* Error of places over the size [m], or of angles [rad], whichever is larger. */
static inline double hm_error_of_path(const double *head, double size, double steps)
{
    return fmax(hm_error_of_steps(head, head[S_PLACE_ERROR], steps) / size,
                hm_error_of_steps(head, head[S_ANGLE_ERROR], steps));
}

#endif
