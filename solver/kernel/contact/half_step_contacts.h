/* Contacts and frictions in a half step of stepped mode: gaps, rates and slips at its start, and
   which close or stop first.

   A slip s_0 that the step would reverse stops in it, after the way s_0^2/2a that it takes with the
   deceleration a of that step. */
#ifndef HOLONOM_HALF_STEP_CONTACTS_H
#define HOLONOM_HALF_STEP_CONTACTS_H

#include "event.h"

#define PENETRATION 1e-13 /* gap below 0, over the size of the mechanism, that counts as zero */

/* What stepped mode knows of each contact in a half step. */
typedef struct touch {
    double gap, rate; /* at its start; the rate where it is near, else 0 */
    double was_closed, is_near;
    double normal; /* its force by the last choice that was solved, or guessed */
    double lands, taken; /* after the first stage: how it takes part in the second
                            (velocity_stage.h); energy that its normal force took */
} touch;

static inline touch *touch_of(const context *c, int32_t i)
{ return (touch *)(void *)c->k.touch + i; }

static inline int is_landing(const context *c, int32_t i)
{ return is_closed(c, i) && touch_of(c, i)->was_closed == 0.0; }

static double normal_in_step(const context *c, int32_t i)
{ return -c->k.mu[row_of(c, c->m->contact_row[i])]; }

/* Sum of the slips of friction f (by row) along its direction. */
static double along_direction(const context *c, int32_t f, const double *slip)
{
    double sum = 0.0;
    for (int k = 0; k < n_slips(c, f); k++)
        sum += friction_of(c, f)[F_ALONG_1 + k] * slip[row_of(c, slip_row(c, f, k))];
    return sum;
}

/* Accelerations that contacts may have: of two nodes, as weight and the last half steps tell. */
static double largest_acceleration(const context *c)
{
    const double *gravity = c->number + c->m->gravity_at;
    const double largest2 = fmax(largest_square(c, c->s.a[0]), largest_square(c, c->s.a[1]));
    return 2.0 * sqrt(fmax(dot(gravity, gravity), largest2));
}

static void forget_stop(const context *c, int32_t f)
{
    c->k.share[f] = 0.0;
    for (int k = 0; k < n_slips(c, f); k++) c->k.stop[row_of(c, slip_row(c, f, k))] = 0.0;
}

/* Friction f stops after that share of a half step, along a way that its slip takes there on the
   mean. */
static void let_stop(const context *c, int32_t f, double share)
{
    c->k.share[f] = share;
    for (int k = 0; k < n_slips(c, f); k++) {
        const int32_t row = row_of(c, slip_row(c, f, k));
        c->k.stop[row] = 0.5 * share * c->h * c->k.slip_before[row];
    }
}

/* Where slips of one body stop, their ways must not contradict each other: all stop after the least
   share. Returns whether there is any. */
static int stop_together(const context *c)
{
    double least = INFINITY;
    EACH_FRICTION(c, f)
        if (c->k.share[f] > 0.0) least = fmin(least, c->k.share[f]);
    EACH_FRICTION(c, f)
        if (c->k.share[f] > 0.0) let_stop(c, f, least);
    return least < INFINITY;
}

/* Ways that what moves may have in a half step, by velocities and by accelerations. */
static double way_at_speed(const context *c, double h) { return 4.0 * h * fastest_node(c); }
static double way_of_fall(const context *c, double h)
{ return 3.0 * h * h * largest_acceleration(c); }

/* Lets contacts sleep that are far in a half step of length h. */
static void look_far_in_step(context *c, double h)
{
    const double reach = way_at_speed(c, h) + way_of_fall(c, h);
    if (asks_for_far(c, reach)) look_far(c, reach, NULL, NULL);
}

/* Gaps and slips at the start of a half step of length h, and a first choice: what was closed stays
   so, what is reached at the present rate closes. */
static void begin_choice(context *c, double h)
{
    const holonom_model *m = c->m;
    const double speed = way_at_speed(c, h), fall = way_of_fall(c, h);
    const double none = PENETRATION * c->number[m->extent_at];
    forget_shares(c);
    memset(c->k.stop, 0, sizeof(double) * (size_t)m->n_rows);
    quantities_at_state(c);
    signal_rates_at(c, c->t, c->k.signal_rate);
    EACH_CONTACT(c, i) {
        touch *x = touch_of(c, i);
        x->was_closed = contact_of(c, i)[C_CLOSED];
        x->gap = gap_of(c, i);
        x->is_near = x->was_closed != 0.0 || x->gap < speed + fall + none;
        x->rate = x->is_near != 0.0 ? gap_rate(c, i) : 0.0;
        if (x->was_closed == 0.0) c->view.may_fall_asleep |= is_far_enough(c, i, x->gap);
        x->is_near = x->was_closed != 0.0 || x->gap + 2.0 * h * fmin(x->rate, 0.0) - fall < none;
    }
    EACH_FRICTION(c, f) {
        const int mode = friction_mode(c, f);
        c->k.flips[f] = 0.0;
        forget_stop(c, f);
        for (int k = 0; k < n_slips(c, f); k++)
            c->k.slip_before[row_of(c, slip_row(c, f, k))] = rate_of_row(c, slip_row(c, f, k));
        if (mode == FRICTION_SLIDES || !is_of_contact(c, f) || is_deferred(c, f))
            guess_friction(c, f);
        for (int k = 0; k < n_slips(c, f); k++) {
            const int32_t row = row_of(c, slip_row(c, f, k));
            c->k.slip[row] = c->k.slip_before[row];
        }
    }
    EACH_CONTACT(c, i) {
        const touch *x = touch_of(c, i);
        double *reference =
            contact_of(c, i)
            + C_REFERENCE; /* a negative one: round-off of the drawing, which no step pushes out */
        if (x->was_closed != 0.0) *reference = fmin(*reference, 0.0);
        else if (x->is_near != 0.0 && x->gap + h * x->rate < -none) close_contact_at(c, i, 0.0);
    }
}

/* Gap of contact i at the end of the half step. */
static int32_t gap_at_end(const context *c, int32_t i, double *gap)
{
    composite_result result = {0.0, 0.0, 0.0};
    const int32_t status = composite_slopes(c, c->m->contact_row[i], SLOPES_ALONE, &result);
    *gap = touch_of(c, i)->gap + result.change;
    return status;
}

#endif
