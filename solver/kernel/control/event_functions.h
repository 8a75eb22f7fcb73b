/* Functions of events: of each contact and each friction one of the state, positive as long as its
   mode holds. Those at the end of a communication step stand in the state for the next one. */
#ifndef HOLONOM_EVENT_FUNCTIONS_H
#define HOLONOM_EVENT_FUNCTIONS_H

#include "contact_modes.h"
#include "far_contacts.h"
#include "force_dips.h"
#include "short_piece.h"

/* Values of the functions of contacts, then of frictions, and their rates where they are known,
   else NaN. */
typedef struct event_values {
    double *value, *rate;
} event_values;

static inline event_values values_at(const context *c, int which)
{
    const int64_t n = c->m->n_contacts + c->m->n_frictions;
    return (event_values){c->k.event + 2 * n * which, c->k.event + 2 * n * which + n};
}

static inline void copy_values(const context *c, event_values from, event_values to)
{
    memcpy(to.value, from.value,
           sizeof(double) * (size_t)(2 * (c->m->n_contacts + c->m->n_frictions)));
}

/* The first function from k on of a contact or friction that is near. */
static inline int32_t next_function(const context *c, int32_t k)
{
    const int32_t n = c->m->n_contacts;
    if (k < n && (k = next_near(c, NEAR_CONTACTS, k)) < n) return k;
    return n + next_near(c, NEAR_FRICTIONS, k - n);
}

static int has_closed(const context *c)
{
    EACH_CONTACT(c, i) if (is_closed(c, i)) return 1;
    return 0;
}

/* Whether a contact or friction is on, so that its function needs forces. */
static int has_forces(const context *c)
{
    if (has_closed(c)) return 1;
    EACH_FRICTION(c, f) if (friction_mode(c, f) != FRICTION_OFF && !is_smooth(c, f)) return 1;
    return 0;
}

/* Slip of friction f at the state, along the direction in which it slides; its rates are kept, see
   follow_slips. */
static double slip_along(const context *c, int32_t f)
{
    double *slip = c->k.slip_at_end + 3 * f, sum = 0.0;
    slip_rates(c, f, slip);
    for (int k = 0; k < n_slips(c, f); k++) sum += friction_of(c, f)[F_ALONG_1 + k] * slip[k];
    return sum;
}

/* Where contacts and joints hold the same thing twice, none of them ends by itself: the functions
   of those that stick together are 1 less the least factor of their coefficients that would hold
   them, times their cones, and those of closed ones stay positive. */
#define SURELY 1e-3 /* of the largest normal force: a function that does not become 0 */

HM_SELDOM static void value_together(context *c, event_values x, double load)
{
    const int32_t n = c->m->n_contacts;
    const double largest = SURELY * largest_normal(c, c->k.event_mu);
    c->event.together = 1;
    for (int32_t i = 0; i < n; i++)
        if (is_closed(c, i)) x.value[i] = fmax(x.value[i], largest);
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        if (!is_stuck(c, f)) continue;
        const double limit = cone(c, f, 0, normal_force(c, f, c->k.event_mu));
        x.value[n + f] =
            (1.0 + CONE_MARGIN - load) * (is_of_contact(c, f) ? fmax(limit, largest) : limit);
    }
}

/* Whether the forces that are shared have left their cones, by more than rounding. */
HM_SELDOM static int is_outside(const context *c)
{
    const double none = CONE_MARGIN * largest_normal(c, c->k.event_mu);
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (is_closed(c, i) && normal_of(c, i) < -none) return 1;
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        if (!is_stuck(c, f)) continue;
        if (excess_of(c, f)
            > (is_of_contact(c, f)
                   ? none
                   : CONE_MARGIN * cone(c, f, 0, normal_force(c, f, c->k.event_mu))))
            return 1;
    }
    return 0;
}

/* The functions at the present state. */
HM_SELDOM static int32_t event_functions(context *c, event_values x)
{
    const holonom_model *m = c->m;
    evaluate_state(c);
    int32_t status = has_forces(c) ? evaluate_forces(c) : HOLONOM_OK;
    c->event.together = 0;
    for (int32_t i = 0; i < m->n_contacts && !status; i++) {
        x.value[i] = is_closed(c, i) ? force_margin(c, i, c->k.event_mu) : gap_of(c, i);
        x.rate[i] = is_closed(c, i) ? NAN : gap_rate(c, i);
    }
    for (int32_t f = 0, k = m->n_contacts; f < m->n_frictions && !status; f++, k++) {
        const int mode = friction_mode(c, f);
        x.value[k] = force_margin(c, k, c->k.event_mu), x.rate[k] = NAN;
        if (mode == FRICTION_SLIDES && !is_smooth(c, f))
            x.value[k] = slip_along(c, f), x.rate[k] = slip_growth(c, f);
    }
    if (status || !has_forces(c)) return status;
    double load = INFINITY;
    enum togetherness how = NOT_TOGETHER;
    if (c->event.outside || is_beyond(c, force_tolerance(c)))
        status = hold_together(c, &how, &load);
    else if (has_shares(c)) {
        status = share_means(c);
        if (!status) status = evaluate_forces(c); /* which the means have overwritten */
    }
    if (how != NOT_TOGETHER) value_together(c, x, load);
    return status;
}

/* Largest square of the vectors x of the moving nodes; directors count times the size of the
   mechanism. */
static double largest_square(const context *c, const double *x)
{
    const double extent2 = hm_square(c->number[c->m->extent_at]);
    double largest = 0.0;
    for (int32_t a = 0; a < c->n_moving; a++, x += DIM) {
        double square = dot(x, x);
        if (c->m->node_kind[a]) square *= extent2;
        if (square > largest)
            largest = square; /* a call of fmax for each node costs as much as the rest */
    }
    return largest;
}

/* Speed of the fastest node; no gap grows much faster. */
static double fastest_node(const context *c) { return sqrt(largest_square(c, c->s.v)); }

/* Values of function k from minus this to this count as zero. */
HM_SELDOM static double value_tolerance(const context *c, int32_t k)
{
    const int32_t f = k - c->m->n_contacts;
    if (f < 0) return is_closed(c, k) ? force_tolerance(c) : 1e-15 * c->number[c->m->extent_at];
    if (friction_mode(c, f) == FRICTION_STICKS)
        return NO_FORCE * fabs(cone(c, f, 0, normal_force(c, f, c->k.event_mu)));
    return 1e-3 * speed_tolerance(c);
}

enum { AT_LOW, AT_HIGH, AT_TRIAL };

#define NOT_A_NUMBER_IN_STATE                                                                      \
    1e300 /* a state is finite: of values this is infinity, of rates that none is known */

/* The functions at the start of a communication step: those at the end of the last one, unless
   rates of inputs may have jumped since, or forces are asked for where the first piece begins. */
static int32_t take_functions(context *c, int inputs_move)
{
    const event_values low = values_at(c, AT_LOW);
    const int asks_forces = c->s.head[S_ORDER_IN_USE] > 2.0 && slides_in_space(c);
    if (c->s.head[S_FUNCTIONS_KNOWN] == 1.0 && some_sleep(c)) leave_far_out(c);
    if (c->s.head[S_FUNCTIONS_KNOWN] == 0.0 || inputs_move || asks_forces) {
        keep_start(c);
        return event_functions(c, low);
    }
    const int32_t n = c->m->n_contacts + c->m->n_frictions;
    for (int32_t k = 0; (k = next_function(c, k)) < n; k++) {
        const double value = c->s.functions[k], rate = c->s.functions[n + k];
        low.value[k] = value == NOT_A_NUMBER_IN_STATE ? INFINITY : value;
        low.rate[k] = rate == NOT_A_NUMBER_IN_STATE ? NAN : rate;
    }
    return HOLONOM_OK;
}

/* Keeps those at the end of a communication step that located contacts, unless laws have jumped. */
static void keep_functions(context *c, int is_located)
{
    double *head = c->s.head;
    head[S_FUNCTIONS_KNOWN] = is_located && head[S_STEPPED] == 0.0 && head[S_SWITCHED] == 0.0;
    if (head[S_FUNCTIONS_KNOWN] == 0.0) return;
    if (some_sleep(c) && !c->view.near[NEAR_CONTACTS]) head[S_FUNCTIONS_KNOWN] = 2.0;
    const event_values low = values_at(c, AT_LOW);
    const int32_t n = c->m->n_contacts + c->m->n_frictions;
    for (int32_t k = 0; (k = next_function(c, k)) < n; k++) {
        c->s.functions[k] = low.value[k] < INFINITY ? low.value[k] : NOT_A_NUMBER_IN_STATE;
        c->s.functions[n + k] = low.rate[k] == low.rate[k] ? low.rate[k] : NOT_A_NUMBER_IN_STATE;
    }
}

#endif
