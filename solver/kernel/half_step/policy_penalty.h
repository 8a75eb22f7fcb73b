/* Decides on penalties, and on updates of the multipliers before an inner iteration has ended. */
#ifndef HOLONOM_POLICY_PENALTY_H
#define HOLONOM_POLICY_PENALTY_H

#include "policy_factors.h"

/* Raises the penalty of the step at hand a thousandfold, twice at most. Where the singular
   configuration lies between the midpoint and the end of a step, the gradients there differ in sign
   along one combination of rows; if both are small, the Uzawa factor 1/(1 + chi g_1 g_m/sigma) of
   that combination has its pole nearby. */
static int raise_penalty(context *c, newton_record *r)
{
    if (r->penalty_raises >= 2) return 0;
    r->penalty_raises += 1;
    r->factors.made = 0;
    r->contraction = 1.0;
    EACH_ROW(c, i) c->k.epsilon[i] *= 1e-3;
    return 1;
}

/* Whether an Uzawa update has left more than a quarter of the rows' defect, and ten times what the
   penalty promises. */
static inline int updates_slowly(const context *c, double defect, double last)
{
    return defect > 0.25 * last && defect > 10.0 * last / (1.0 + c->s.head[S_PENALTY]);
}

/* Defect below which a row needs no update: what is left, epsilon (mu - lambda), has the sign of
   dmu/dt at every step and adds up in the energy (double pendulum, 2e5 steps of 1 ms: 4e-13 J with
   6e-17, 1e-14 J with this). */
#define UNBIASED 1e-19

/* What I_DEPENDENT says of the rows of an island. Of dependent ones each step takes out of the
   multipliers what they leave undetermined, to which every solve adds their inconsistency, a
   rounding error of the drawn configuration, over epsilon. Where it cannot be told from what is
   weakly determined, a part of all is forgotten at the beginning of a step. */
enum { ROWS_ARE_INDEPENDENT, ROWS_ARE_DEPENDENT, ROWS_ARE_WEAK, ROWS_CONTRADICT };

/* Whether rows of any island share forces at will, as far as is known. */
static int may_have_dependent_rows(const context *c)
{
    for (int32_t island = 0; island < c->m->n_islands; island++)
        if (c->s.islands[I_SIZE * island + I_DEPENDENT] != ROWS_ARE_INDEPENDENT) return 1;
    return 0;
}
#define FORGOTTEN 1e-3

/* First increment, over the size of a step, that is short. */
#define SHORT_INCREMENT 1e-2

/* Whether lambda may follow early, after this Newton iteration, and not at the end alone: the
   update costs no increment where another one follows anyway, and that one leaves no part of the
   rows, whose energy would add up. With contacts and frictions that are on and located it does not
   pay. Of dependent rows the part of the multipliers that is not determined gets the errors of a
   solve over epsilon, which the next one with lambda held removes: there the update comes once,
   after the second increment or a short first one. See theory 3.4. */
static int may_update_early(const context *c, const newton_record *r)
{
    if (r->contraction >= GOOD_CONTRACTION || !hm_skips(SKIP_OUTER_ITERATION)) return 0;
    const double rows = c->view.scalars[I_DEPENDENT];
    if (rows == ROWS_ARE_INDEPENDENT && is_unilateral(c->m) && !c->step.changes_contacts
        && !c->view.asleep)
        return 0;
    const int is_short = r->iteration == 0 && r->eta < SHORT_INCREMENT * r->size;
    if (rows != ROWS_ARE_INDEPENDENT && r->iteration != 1
        && !(rows == ROWS_ARE_DEPENDENT && is_short))
        return 0;
    return r->iteration > 0 || constraint_defect(c) > UNBIASED;
}

/* The penalty of an island is raised a hundredfold as often as it takes for an Uzawa update to
   leave no more than this of any multipliers. */
#define GOOD_UPDATE 1e-7
#define LARGEST_RAISED 1e14

/* Chooses the level of an island's penalty at the start; `left` over the penalty is what an update
   leaves of the multipliers that it contracts least. The least eigenvalue of G M^-1 G' falls like
   1/N^2 in long chains (theory 3.6). */
static void start_penalty(const context *c, double left)
{
    double penalty = c->s.head[S_PENALTY], *level = c->view.scalars + I_PENALTY_LEVEL;
    if (!hm_skips(SKIP_LOW_PENALTY)) return;
    *level = 0.0;
    for (; left > GOOD_UPDATE * penalty && *level < MOST_LEVELS && 1e2 * penalty <= LARGEST_RAISED;
         penalty *= 1e2)
        *level += 1.0;
}

#define MOST_LATER 2.0 /* levels that are reached on the way */

/* Raises the penalty of an island after eight solves in a row of three increments or more: with
   dependent rows, whose rounding errors it multiplies, of three updates that each waited for the
   end of an inner iteration (`outer`). */
static void follow_contraction(double *island, int increments, int outer)
{
    const int slow = island[I_DEPENDENT] != 0.0 ? outer >= 3 : increments >= 3;
    island[I_SLOW_STEPS] = slow ? island[I_SLOW_STEPS] + 1.0 : 0.0;
    if (!hm_skips(SKIP_LOW_PENALTY) || island[I_SLOW_STEPS] < 8.0
        || island[I_PENALTY_LEVEL] >= MOST_LATER)
        return;
    island[I_PENALTY_LEVEL] += 1.0;
    island[I_SLOW_STEPS] = 0.0;
}

#endif
