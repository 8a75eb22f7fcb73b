/* Decides which factors of the tangent serve a step: lean or full, fresh, kept or taken over. */
#ifndef HOLONOM_POLICY_FACTORS_H
#define HOLONOM_POLICY_FACTORS_H

#include "policy_stopping.h"

#define GOOD_CONTRACTION 0.05
#define LAST_DIGITS                                                                                \
    1e-15 /* size of an increment, over that of the step, from which on round-off hides what       \
             contracts */

/* What fresh factors cost, in increments: the places that their products go to over the numbers
   that a solution reads, and the tangent. Measured: 1.7 to 2.5 times the first price are alike for
   chains of bodies, and more loses for points. */
static double price_of_factors(const context *c)
{
    const int32_t *begin = c->factors.lu->lu_island + 4 * c->view.first,
                  *end = c->factors.lu->lu_island + 4 * c->view.last;
    return (has_turns(c) ? 2.0 : 1.0)
           + (double)(end[2] - begin[2])
                 / (1.0 + c->factors.lu->lu_ptr[end[0]] - c->factors.lu->lu_ptr[begin[0]]);
}

/* Whether fresh factors would spare more increments than they cost. The next increment is the
   contraction times the last; from then on fresh factors contract by it times what is left of the
   way from where the present ones were made. Not in the place of those taken over, which
   judge_factors weighs, nor of lean ones, which would lack the same again, and not with dependent
   rows: iterations that end sooner leave more in what these determine weakly (Bricard at
   tolerances: 2e-14 of the energy in place of 5e-15). */
static int would_pay(const context *c, const newton_record *r)
{
    const double goal = NEWTON_MARGIN * r->target, next = r->contraction * r->eta,
                 fresh = r->contraction * next / r->first;
    double saved = 0.0, with_kept = next, with_fresh = next;
    if (r->factors.taken_over || is_lean(c) || c->view.scalars[I_DEPENDENT] != 0.0
        || r->iteration < 2 || next <= goal)
        return 0;
    for (; r->contraction * with_kept > goal && saved < 10.0; with_kept *= r->contraction)
        saved += 1.0;
    for (; fresh * with_fresh > goal && saved > 0.0; with_fresh *= fresh) saved -= 1.0;
    return saved > price_of_factors(c);
}

/* Factors are kept while increments contract well with them, and at round-off, which says nothing
   about them. */
static inline int may_keep_factors(const context *c, const newton_record *r)
{
    if (!r->factors.made || !hm_skips(SKIP_FACTORISATION)) return 0;
    if (c->laws.reads) return 1; /* what laws do tells nothing of the factors */
    return r->contraction < GOOD_CONTRACTION ? !would_pay(c, r)
                                       : r->iteration > 0 && r->eta < LAST_DIGITS * r->size;
}

/* Lean factors leave stiffness out, h^2 |sum mu_i H_i|/4m and h^2 k/4m against 1, which is then
   their contraction. From this one on, or where a step takes more increments than that, full
   factors cost less; they are used for a while, each time for twice as many steps. Not with
   dependent rows: what these leave undetermined would follow every increment, and the energy with
   it. */
#define LEAN_CONTRACTION 3e-3
#define LEAN_INCREMENTS 3

static void choose_factors(context *c)
{
    double *island = c->view.scalars;
    const int is_tried = c->m->n_lean_values
                         && island[I_DEPENDENT] == 0.0 && hm_skips(SKIP_STIFFNESS);
    c->factors.lu = is_tried && island[I_FULL_STEPS] == 0.0 ? lean_factors(c) : full_factors(c);
    if (island[I_FULL_STEPS] > 0.0) island[I_FULL_STEPS] -= 1.0;
}

/* What the last increment tells of the factors: the contraction or, as long as there is no
   increment before it with the same ones, its size against the step's. */
static void judge_increment(context *c, newton_record *r)
{
    r->factors.made = 1;
    if (!r->factors.kept) r->first = r->eta;
    if (r->increments == 1) r->first_increment = r->eta;
    if (r->iteration > 0 && r->previous > 0.0) r->contraction = r->eta / r->previous;
    else if (!r->factors.kept) r->contraction = r->eta < 0.02 * r->size ? 0.04 : 1.0;
    const int hides = r->factors.kept && r->eta < LAST_DIGITS * r->size;
    r->contraction_above_round_off =
        hides ? fmin(r->contraction_above_round_off, r->contraction) : r->contraction;
    learn_contraction(c, r);
    if (!r->factors.kept) r->predicted_contraction = known_contraction(c, r->first, r->size);
    r->previous = r->eta;
    const double most = r->iteration > 0 ? LEAN_CONTRACTION : 0.5;
    r->factors.slow = is_lean(c) && r->eta > r->floor && r->contraction > most;
}

/* Leaves factors that have failed alone for some half steps, and notes how many: each time for
   twice as many. */
static inline void pause_factors(double *steps, double *wait)
{ *steps = *wait = fmin(fmax(2.0 * *wait, 64.0), 4096.0); }

/* Full factors for some half steps. */
static void pause_lean(double *island)
{ pause_factors(island + I_FULL_STEPS, island + I_FULL_WAIT); }

/* Factors of the half step before serve another of the same length, where they are dear and the
   mechanism moves little: as long as they cost no increment more than fresh ones; else they are
   left alone for a while, each time for twice as many half steps. They are scratch of one internal
   step, and of one island. */
static int take_factors_over(context *c, newton_record *r)
{
    double *island = c->view.scalars;
    if (island[I_FRESH_STEPS] > 0.0) island[I_FRESH_STEPS] -= 1.0;
    if (c->m->n_islands > 1 || c->factors.kept_h != c->h || c->factors.kept_lu != c->factors.lu
        || island[I_FRESH_STEPS] > 0.0 || !hm_skips(SKIP_FRESH_FACTORS))
        return 0;
    r->factors.made = r->factors.taken_over = 1;
    r->predicted_contraction = 1.0;
    r->contraction = 0.9 * GOOD_CONTRACTION;
    return 1;
}

/* Instead of lean factors that contract too little: fresh ones if they were taken over, else full
   ones. */
static void replace_factors(context *c, newton_record *r)
{
    if (!r->factors.taken_over) {
        pause_lean(c->view.scalars);
        c->factors.lu = full_factors(c);
    }
    r->factors.made = r->factors.taken_over = 0;
    r->contraction = 1.0;
}

/* What a half step tells of the factors that it used, for the next one. */
static void judge_factors(context *c, const newton_record *r, int began_with_old)
{
    double *island = c->view.scalars;
    if (began_with_old && r->increments > c->factors.kept_increments)
        pause_factors(island + I_FRESH_STEPS, island + I_FRESH_WAIT);
    if (!began_with_old) c->factors.kept_increments = r->increments;
    c->factors.kept_h = r->factors.made && !r->penalty_raises ? c->h : 0.0;
    c->factors.kept_lu = c->factors.lu;
    if (is_lean(c) && !began_with_old && r->increments > LEAN_INCREMENTS) pause_lean(island);
}

#endif
