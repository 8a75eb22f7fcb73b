/* Stepped mode: contacts change at the ends of half steps alone, however many, and no event is located.

   A half step h has two stages. The first is a conserving step in which each contact obeys

       0 <= N _|_ g(q_1) >= 0,     |T| <= c_s N + preload where there is no slip, else T = (c N + preload) t,

   with the rows of closed contacts and of frictions that stick on; which these are is found by solving the step with a
   choice of them, and changing what fails. Its contacts take -N (g_1 - g_0) >= 0. A friction whose slip s_0 the step would
   reverse stops in it, after the way s_0^2/2a that it takes with the deceleration a of that step.
   The second stage acts on the velocities alone, at q_1: closed contacts part with rates f e |g'_0| where they have just
   closed, and with none where they were closed before; what holds is held. f is such that e^2 of what both stages take
   with f = 0 is given back (energetic restitution, Stronge 1990), a quadratic equation.                         */
#ifndef HOLONOM_STEPPED_H
#define HOLONOM_STEPPED_H

#include "contact.h"
#include "context.h"
#include "energy.h"
#include "event.h"
#include "half_step.h"
#include "impact.h"
#include "rigid.h"
#include "start.h"
#include "step_halving.h"

enum {
    MOST_CHOICES = 60,  /* solutions of a half step                                                               */
    PATIENCE = 5,       /* choices in turn that may not lower the number of objections                            */
    MOST_LAGS = 6,      /* solutions with the cones of the one before                                             */
    MOST_DIVISIONS = 7, /* of a half step that fails                                                              */
    FEW = 2,            /* objections that change the choice without a guess                                      */
    FEW_NEAR = 8,       /* contacts near that need no guess                                                       */
    MOST_GUESSES = 8,
    MOST_SWEEPS = 10000 /* of a guess                                                                             */
};
#define RELAXATION 1.6    /* of these sweeps                                                                    */
#define BEYOND 10.0       /* times the largest force guessed: contacts contradict each other                    */
#define PENETRATION 1e-13 /* gap below 0, over the size of the mechanism, that counts as zero                   */
#define ROUND_OFF 1e-15   /* of a coordinate, over the same                                                */
#define CONE_MARGIN 1e-9  /* part of the cone, or of a slip, beyond its limit at which a mode is kept             */
#define LAG_TOLERANCE 1e-9 /* change of a normal force over the largest one at which cones no longer lag        */

/* What stepped mode knows of each contact in a half step. */
typedef struct touch {
    double gap, rate; /* at its start; the rate where it is near, else 0                                         */
    double was_closed, is_near;
    double normal; /* its force by the last choice that was solved, or guessed                                    */
} touch;

static inline touch *touch_of(const context *c, int32_t i) { return (touch *)(void *)c->k.touch + i; }

static inline int is_landing(const context *c, int32_t i) { return is_closed(c, i) && touch_of(c, i)->was_closed == 0.0; }

static double normal_in_step(const context *c, int32_t i) { return -c->k.mu[row_of(c, c->m->contact_row[i])]; }

static double largest_normal_in_step(const context *c)
{
    double largest = 0.0;
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (is_closed(c, i)) largest = fmax(largest, fabs(normal_in_step(c, i)));
    return largest;
}

/* Sum of the slips of friction f (by row) along its direction. */
static double along_direction(const context *c, int32_t f, const double *slip)
{
    double sum = 0.0;
    for (int k = 0; k < n_slips(c, f); k++) sum += friction_of(c, f)[F_ALONG_1 + k] * slip[row_of(c, slip_row(c, f, k))];
    return sum;
}

/* --------------------------------------------------------------------------------------- first stage */

/* Accelerations that contacts may have: of two nodes, as weight and the last half steps tell. */
static double largest_acceleration(const context *c)
{
    const double *gravity = c->number + c->m->gravity_at;
    const double largest2 = fmax(largest_square(c, c->s.a[0]), largest_square(c, c->s.a[1]));
    return 2.0 * sqrt(fmax(dot(gravity, gravity), largest2));
}

/* Closes contact i so that its gap is 0 at the end of the half step. */
static void close_at_zero(context *c, int32_t i)
{
    const int32_t f = c->m->contact_friction[i];
    double *x = contact_of(c, i);
    x[C_CLOSED] = 1.0;
    x[C_REFERENCE] = 0.0;
    if (f >= 0) guess_friction(c, f);
}

static void forget_stop(const context *c, int32_t f)
{
    c->k.share[f] = 0.0;
    for (int k = 0; k < n_slips(c, f); k++) c->k.stop[row_of(c, slip_row(c, f, k))] = 0.0;
}

/* Friction f stops after that share of a half step, along a way that its slip takes there on the mean. */
static void let_stop(const context *c, int32_t f, double share)
{
    c->k.share[f] = share;
    for (int k = 0; k < n_slips(c, f); k++) {
        const int32_t row = row_of(c, slip_row(c, f, k));
        c->k.stop[row] = 0.5 * share * c->h * c->k.slip_before[row];
    }
}

/* Where slips of one body stop, their ways must not contradict each other: all stop after the same share, the least one or,
   if that does not help, at once. Returns whether there is any.                                                 */
static int stop_together(const context *c, int at_once)
{
    double least = INFINITY;
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        if (c->k.share[f] > 0.0) least = fmin(least, c->k.share[f]);
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        if (c->k.share[f] > 0.0) let_stop(c, f, at_once ? 0.0 : least);
    return least < INFINITY;
}

/* Gaps and slips at the start of a half step of length h, and a first choice: what was closed stays so, what is reached
   at the present rate closes. */
static void begin_choice(context *c, double h)
{
    const holonom_model *m = c->m;
    const double speed = 4.0 * h * fastest_node(c), fall = 3.0 * h * h * largest_acceleration(c);
    const double none = PENETRATION * c->number[m->extent_at];
    memset(c->k.stop, 0, sizeof(double) * (size_t)m->n_rows);
    quantities_at_state(c);
    signal_rates_at(c, c->t, c->k.signal_rate);
    for (int32_t i = 0; i < m->n_contacts; i++) {
        touch *x = touch_of(c, i);
        x->was_closed = contact_of(c, i)[C_CLOSED];
        x->gap = gap_of(c, i);
        x->is_near = x->was_closed != 0.0 || x->gap < speed + fall + none;
        x->rate = x->is_near != 0.0 ? gap_rate(c, i) : 0.0;
        x->is_near = x->was_closed != 0.0 || x->gap + 2.0 * h * fmin(x->rate, 0.0) - fall < none;
    }
    for (int32_t f = 0; f < m->n_frictions; f++) {
        const int mode = friction_mode(c, f);
        c->k.flips[f] = 0.0;
        forget_stop(c, f);
        for (int k = 0; k < n_slips(c, f); k++)
            c->k.slip_before[row_of(c, slip_row(c, f, k))] = rate_of_row(c, slip_row(c, f, k));
        if (mode == FRICTION_SLIDES || !is_of_contact(c, f)) guess_friction(c, f);
    }
    for (int32_t i = 0; i < m->n_contacts; i++) {
        const touch *x = touch_of(c, i);
        if (x->was_closed != 0.0) contact_of(c, i)[C_REFERENCE] = 0.0;
        else if (x->is_near != 0.0 && x->gap + h * x->rate < -none) close_at_zero(c, i);
    }
}

/* Gap of contact i at the end of the half step. */
static int32_t gap_at_end(const context *c, int32_t i, double *gap)
{
    composite_result result = {0.0, 0.0, 0.0};
    const int32_t status = composite_slopes(c, c->m->contact_row[i], 0, &result);
    *gap = touch_of(c, i)->gap + result.change;
    return status;
}

/* Way of the node that moves most in the half step. */
static double largest_way(const context *c) { return sqrt(largest_square(c, c->k.d)); }

/* Contacts and frictions (behind the contacts) that object to a choice: how many, and the last one; and which of them are to
   change. */
typedef struct objections {
    int count;
    int32_t last, changing;
    int at_once; /* whether slips that stop do so at the start of the half step */
} objections;

enum { NONE_CHANGES = -2, ALL_CHANGE = -1 };

/* Counts contact k, or friction k - n_contacts, among the objections; returns whether it is to change. */
static int add_objection(context *c, objections *x, int32_t k)
{
    const int changes = x->changing == ALL_CHANGE || x->changing == k;
    x->count++;
    x->last = k;
    if (changes) blame(c, k < c->m->n_contacts ? c->m->contact_row[k] : slip_row(c, k - c->m->n_contacts, 0));
    return changes;
}

/* Closes open contacts that the half step leaves in penetration, of those that are near or of `all`. */
static int32_t close_crossed(context *c, int all, objections *x)
{
    const double none = PENETRATION * c->number[c->m->extent_at], reach = 4.0 * largest_way(c);
    int32_t status = HOLONOM_OK;
    for (int32_t i = 0; i < c->m->n_contacts && !status; i++) {
        const int32_t *leaf = c->m->leaf + 4 * c->m->leaf_ptr[c->m->contact_row[i]];
        const int turns = leaf[0] != LEAF_SIGNAL && c->m->quantity_kind[leaf[1]] == QUANTITY_ANGLE;
        double gap = INFINITY;
        if (is_closed(c, i) || (touch_of(c, i)->is_near == 0.0 && (!all || (!turns && touch_of(c, i)->gap > reach)))) continue;
        status = gap_at_end(c, i, &gap);
        if (!(gap < -none)) continue;
        touch_of(c, i)->is_near = 1.0;
        if (add_objection(c, x, i)) close_at_zero(c, i);
    }
    return status;
}

/* What rounding errors of the coordinates make of the normal force of contact i. */
static double noise_of_normal(const context *c, int32_t i)
{
    const double *number = c->number, place = ROUND_OFF * number[c->m->extent_at];
    return 2.0 * place / (c->h * c->h * number[c->m->row_sigma_at + row_of(c, c->m->contact_row[i])]);
}

/* Opens closed contacts that would pull. One whose friction sticks slides first: its friction may be what pulls. */
static void open_pulling(context *c, objections *x)
{
    const double none = NO_FORCE * largest_normal_in_step(c);
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        const int32_t f = c->m->contact_friction[i];
        double along[3], size2 = 0.0;
        if (!is_closed(c, i) || !(normal_in_step(c, i) < -none - noise_of_normal(c, i)) || !add_objection(c, x, i)) continue;
        const int jams = f >= 0 && friction_mode(c, f) == FRICTION_STICKS && c->k.flips[f] < 2.0;
        for (int k = 0; jams && k < n_slips(c, f); k++) size2 += hm_square(along[k] = c->k.mu[row_of(c, slip_row(c, f, k))]);
        if (!(size2 > 0.0)) {
            open_contact(c, i);
            continue;
        }
        for (int k = 0; k < n_slips(c, f); k++) along[k] /= sqrt(size2);
        c->k.flips[f] = 2.0;
        forget_stop(c, f);
        let_slide(c, f, along);
    }
}

/* Lets frictions beyond their cones slide, and those stop whose slip the half step would reverse. A contact that lands slows
   the slip of joints, too: one that then goes on until the end does not stop before. */
static void change_frictions(context *c, objections *x)
{
    const double none = NO_FORCE * largest_normal_in_step(c), still = 1e-3 * speed_tolerance(c);
    int lands = 0;
    for (int32_t i = 0; i < c->m->n_contacts; i++) lands |= is_landing(c, i);
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        const int mode = friction_mode(c, f), n = n_slips(c, f);
        double along[3], size2 = 0.0;
        if (mode == FRICTION_OFF || is_smooth(c, f)) continue;
        if (mode == FRICTION_STICKS) {
            const double limit = cone(c, f, 0, normal_in_cone(c, f, c->k.mu));
            for (int k = 0; k < n; k++) size2 += hm_square(along[k] = c->k.mu[row_of(c, slip_row(c, f, k))]);
            if (!(sqrt(size2) > limit + CONE_MARGIN * fabs(limit) + none) || !add_objection(c, x, c->m->n_contacts + f)) continue;
            for (int k = 0; k < n; k++) along[k] /= sqrt(size2);
            forget_stop(c, f);
            let_slide(c, f, along);
        } else {
            const double before = along_direction(c, f, c->k.slip_before), mean = along_direction(c, f, c->k.slip);
            const double least = x->at_once || (lands && !is_of_contact(c, f)) ? 0.0 : 0.5 * (1.0 - CONE_MARGIN) * fmax(before, 0.0);
            if (!(mean < least - still) || !add_objection(c, x, c->m->n_contacts + f)) continue;
            forget_stop(c, f);
            if (before > 0.0 && !x->at_once) let_stop(c, f, 0.5 * before / (before - mean));
            let_stick(c, f);
        }
        c->k.flips[f] += 1.0;
    }
}

/* Counts the objections to the step that was solved with `status`, and changes those of `changing`. Rows that contradict each
   other leave a step unsolved, with forces that pull. */
static int32_t look_for_objections(context *c, int32_t status, objections *x)
{
    x->count = 0;
    open_pulling(c, x);
    if (status) return x->count ? HOLONOM_OK : status;
    status = close_crossed(c, 0, x);
    if (!status) change_frictions(c, x);
    if (!status && !x->count) status = close_crossed(c, 1, x);
    return status;
}

/* Gradient of gap i over its free nodes, in the middle of the half step. */
static int32_t gradient_of_gap(const context *c, int32_t i, double *gradient, double *gap)
{
    const holonom_model *m = c->m;
    const int32_t j = m->contact_row[i], size = DIM * (m->composite_node_ptr[j + 1] - m->composite_node_ptr[j]);
    const int32_t status = gap_at_end(c, i, gap);
    if (status) return status;
    local_gradients(c, j);
    for (int32_t k = 0; k < size; k++) gradient[k] = 0.0;
    for (int32_t f = 0; f < m->composite_form_ptr[j + 1] - m->composite_form_ptr[j]; f++)
        for (int32_t k = 0; k < size; k++) gradient[k] += c->k.slope[f] * c->k.gradient[size * f + k];
    return HOLONOM_OK;
}

/* Chooses anew, from the half step that is solved, those contacts that would be closed if masses of nodes were all that
   couples gaps: N >= 0 _|_ g + W (N - N_0) >= 0 by projected over-relaxed sweeps (Cryer 1971), which cost far less than
   another factorisation. Where rows couple gaps, too, more will object.                                          */
static int32_t guess_choice(context *c, int parity)
{
    const holonom_model *m = c->m;
    const int32_t stride = DIM * m->n_local_nodes + 4;
    const double half = 0.5 * c->h * c->h, none = PENETRATION * c->number[m->extent_at];
    double *way = c->k.ahead, *const first = c->k.sweep, *end = first; /* of each near contact: gap, N, W, its index, gradient */
    memset(way, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t i = 0; i < m->n_contacts; i++) {
        const int32_t j = m->contact_row[i], *node = m->composite_node + m->composite_node_ptr[j];
        const int32_t size = DIM * (m->composite_node_ptr[j + 1] - m->composite_node_ptr[j]);
        if (touch_of(c, i)->is_near == 0.0) continue;
        const int32_t status = gradient_of_gap(c, i, end + 4, end);
        if (status) return status;
        end[1] = is_closed(c, i) ? normal_in_step(c, i) : 0.0;
        end[2] = 0.0;
        end[3] = i;
        for (int32_t k = 0; k < size; k++) end[2] += half * hm_square(end[4 + k]) / c->number[m->node_mass_at + node[k / DIM]];
        end += stride;
    }
    for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
        double largest = 0.0;
        for (double *at = first; at < end; at += stride) {
            const int32_t j = m->contact_row[(int32_t)at[3]], *node = m->composite_node + m->composite_node_ptr[j];
            const int32_t size = DIM * (m->composite_node_ptr[j + 1] - m->composite_node_ptr[j]);
            double gap = at[0];
            for (int32_t k = 0; k < size; k++) gap += at[4 + k] * way[DIM * node[k / DIM] + k % DIM];
            const double normal = at[2] > 0.0 ? fmax(at[1] - RELAXATION * gap / at[2], 0.0) : 0.0, change = normal - at[1];
            for (int32_t k = 0; k < size; k++)
                way[DIM * node[k / DIM] + k % DIM] += half * change * at[4 + k] / c->number[m->node_mass_at + node[k / DIM]];
            at[1] = normal;
            largest = fmax(largest, fabs(change) * at[2]);
        }
        if (largest <= none) break;
    }
    for (const double *at = first; at < end; at += stride) {
        const int32_t i = (int32_t)at[3];
        touch_of(c, i)->normal = at[1];
        c->s.mu[parity][row_of(c, m->contact_row[i])] = -at[1]; /* decides what dependent rows leave open */
        if (at[1] > 0.0 && !is_closed(c, i)) close_at_zero(c, i);
        else if (!(at[1] > 0.0) && is_closed(c, i)) open_contact(c, i);
    }
    return HOLONOM_OK;
}

/* Of closed contacts that contradict each other, since there are more of them than they can hold, opens the one whose force
   vanishes first on the way from the last one solved to where the failed iteration has gone; 0 if there is none.  */
static int open_contradicting(context *c)
{
    double least = INFINITY;
    int32_t first = -1;
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        const double before = fmax(touch_of(c, i)->normal, 0.0), change = is_closed(c, i) ? before - normal_in_step(c, i) : 0.0;
        if (change > before && before / change < least) least = before / change, first = i;
    }
    if (first < 0) return 0;
    blame(c, c->m->contact_row[first]);
    open_contact(c, first);
    return 1;
}

/* Whether forces are far beyond those that were guessed: closed contacts hold each other, up to a little that they contradict. */
static int contradicts(const context *c, int guessed)
{
    double largest = 0.0;
    for (int32_t i = 0; i < c->m->n_contacts && guessed; i++) largest = fmax(largest, touch_of(c, i)->normal);
    return largest > 0.0 && largest_normal_in_step(c) > BEYOND * largest;
}

static int n_near(const context *c)
{
    int n = 0;
    for (int32_t i = 0; i < c->m->n_contacts; i++) n += touch_of(c, i)->is_near != 0.0;
    return n;
}

static void keep_normals(const context *c)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        touch_of(c, i)->normal = is_closed(c, i) ? normal_in_step(c, i) : 0.0;
}

/* Whether a step that was solved so may have failed by its choice. */
static inline int may_choose_anew(int32_t status)
{
    return status == HOLONOM_CONTACT_UNDECIDED || status == HOLONOM_NEWTON_DIVERGED || status == HOLONOM_UZAWA_DIVERGED;
}

/* Solves the half step with the choice at hand until no contact or friction objects. Where many do, they are guessed anew.
   Else all change at once as long as they become fewer now and then, or the last one alone, by which no choice comes back
   (Murty 1974; Judice and Pires 1994), until they are fewer again.                                              */
static int32_t solve_choices(context *c, int parity, int at_once)
{
    int fewest = INT_MAX, patience = PATIENCE, together = 0, guesses = 0;
    const int are_many = !at_once && n_near(c) > FEW_NEAR;
    for (int choice = 0; choice < MOST_CHOICES; choice++) {
        objections x = {0, 0, NONE_CHANGES, at_once};
        c->factors_h = 0.0;
        int32_t status = solve_step(c, parity), solved = status;
        if (status && !may_choose_anew(status)) return status;
        if (status && together < 2 && stop_together(c, together++)) continue;
        status = look_for_objections(c, solved, &x);
        if (status || !x.count) return status;
        if (x.count < fewest) fewest = x.count, patience = PATIENCE;
        else if (patience > 0) patience--;
        if (are_many && solved && !guesses) { /* closed contacts contradict each other: from none on */
            for (int32_t i = 0; i < c->m->n_contacts; i++) open_contact(c, i);
            continue;
        }
        if (are_many && (solved || contradicts(c, guesses)) && open_contradicting(c)) continue;
        if (!solved) keep_normals(c);
        if (are_many && !solved && x.count > FEW && guesses++ < MOST_GUESSES) {
            if ((status = guess_choice(c, parity))) return status;
            continue;
        }
        x.changing = patience > 0 ? ALL_CHANGE : x.last;
        look_for_objections(c, solved, &x);
        if (together) stop_together(c, together > 1);
    }
    return HOLONOM_CONTACT_UNDECIDED;
}

/* Sets contacts and frictions back to what they were at the start of the half step; their sections are neighbours. */
static void take_modes_back(context *c)
{
    const size_t bytes = sizeof(double) * (size_t)(C_SIZE * c->m->n_contacts + F_SIZE * c->m->n_frictions);
    memcpy(c->s.contacts, c->k.stepped_backup + (c->s.contacts - c->s.head), bytes);
}

/* First stage. Where no choice agrees, since friction is strong, the cones' normal forces lag: each problem is then one of
   a convex function, and what friction does is booked as it is.                                                 */
static int32_t solve_contacts(context *c, int parity)
{
    const holonom_model *m = c->m;
    const double *last = c->s.mu[1 - parity];
    int32_t status = HOLONOM_CONTACT_UNDECIDED;
    c->lagged = 0;
    for (int at_once = 0; at_once < 2; at_once++) {
        begin_choice(c, c->h);
        status = solve_choices(c, parity, at_once);
        if (!may_choose_anew(status) || !m->n_frictions) return status;
        take_modes_back(c);
    }
    for (int32_t f = 0; f < m->n_frictions; f++)
        c->k.lag[f] = friction_mode(c, f) == FRICTION_OFF ? 0.0 : fmax(normal_force(c, f, last), 0.0);
    c->lagged = 1;
    for (int lag = 0; lag < MOST_LAGS; lag++) {
        double change = 0.0, largest = 0.0;
        take_modes_back(c);
        begin_choice(c, c->h);
        if ((status = solve_choices(c, parity, 1))) break;
        for (int32_t f = 0; f < m->n_frictions; f++) {
            const double normal = friction_mode(c, f) == FRICTION_OFF ? 0.0 : fmax(normal_force(c, f, c->k.mu), 0.0);
            change = fmax(change, fabs(normal - c->k.lag[f]));
            largest = fmax(largest, normal);
            c->k.lag[f] = lag > 1 ? 0.5 * (c->k.lag[f] + normal) : normal;
        }
        if (change <= LAG_TOLERANCE * largest) break;
    }
    c->lagged = 0;
    return status;
}

/* -------------------------------------------------------------------------------------- second stage */

static int island_has_contact(context *c)
{
    EACH_IN(c, composites, composite, j)
        if (is_row(c, j) && owner_of(c, j) >= 0 && state_of_row(c, j) != ROW_IS_OFF) return 1;
    return 0;
}

/* Rates of rows that are to vanish (in phi): of islands in which a contact is closed. */
static void rates_to_stop(context *c)
{
    row_rates(c, c->s.q, c->s.q_low, c->s.v, c->s.signal, c->k.signal_rate, c->k.phi);
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        look_at(c, island, island + 1);
        if (island_has_contact(c)) continue;
        EACH_ROW(c, i) c->k.phi[i] = 0.0;
    }
    look_at(c, 0, c->m->n_islands);
}

/* Velocities x (overwritten) and impulses (in mu) that change the rates of the rows by -phi. */
static void velocities_for(const context *c, double *x)
{
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    memset(c->k.mu, 0, sizeof(double) * (size_t)c->m->n_rows);
    memset(x, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    solve_with_factors(c);
    add_solution(c, x);
}

/* Rates at which contacts would part by themselves, with the other sign in phi; e^2 of all that land, by their energies. */
static double rates_of_landing(const context *c)
{
    double given = 0.0, taken = 0.0;
    memset(c->k.phi, 0, sizeof(double) * (size_t)c->m->n_rows);
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        const int32_t row = row_of(c, c->m->contact_row[i]);
        const double e = c->number[c->m->restitution_at + i], speed = -touch_of(c, i)->rate;
        if (!is_landing(c, i) || !(speed > 0.0)) continue;
        const double weight = speed * speed / c->number[c->m->row_sigma_at + row];
        taken += weight;
        if (!(speed > fmax(c->s.head[S_REST_SPEED], speed_tolerance(c)))) continue;
        given += e * e * weight;
        c->k.phi[row] = -e * speed;
    }
    return taken > 0.0 ? given / taken : 0.0;
}

/* Switches sliding frictions off for the second stage as suspend_sliding does, or on again, but for those of contacts that
   land. */
static void suspend_resting(const context *c, int suspended)
{
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        double *x = friction_of(c, f);
        if (c->k.lands[f] == 0.0 && x[F_MODE] == (suspended ? FRICTION_SLIDES : -FRICTION_SLIDES)) x[F_MODE] = -x[F_MODE];
    }
}

/* Adds x to the velocities and books what its impulses (in mu) take; the rest of the change of energy is work. */
static void add_velocities(context *c, const double *x, int driven)
{
    const holonom_model *m = c->m;
    double *rate = c->k.row_rate, friction = 0.0, total = 0.0;
    const double before = mass_product(c, x, c->s.v) + 0.5 * mass_product(c, x, x);
    for (int side = 0; side < 2; side++) {
        row_rates(c, c->s.q, c->s.q_low, c->s.v, c->s.signal, c->k.signal_rate, rate);
        for (int32_t f = 0; f < m->n_frictions; f++)
            for (int k = 0; k < n_slips(c, f); k++) {
                const int32_t j = slip_row(c, f, k), row = row_of(c, j);
                if (state_of_row(c, j) == ROW_IS_OFF) continue;
                rate[row] = rate_of_row(c, j);
                if (c->k.lands[f] == 0.0) friction += 0.5 * c->k.mu[row] * rate[row];
            }
        for (int32_t i = 0; i < m->n_rows; i++) total += 0.5 * c->k.mu[i] * rate[i];
        for (int32_t k = 0; k < DIM * m->n_free && !side; k++) hm_add(c->s.v + k, c->s.v_low + k, x[k]);
    }
    const double loss = driven ? total : -before;
    book(c, S_FRICTION, friction);
    book(c, S_IMPACT, loss - friction);
    if (driven) book(c, S_WORK, before + loss);
}

/* Lets those frictions stick whose slip the second stage has reversed; joints, which had none in it, slide the other way. */
static int stop_reversed(context *c)
{
    int stops = 0;
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        if (friction_mode(c, f) != FRICTION_SLIDES || is_smooth(c, f) || !(slip_along(c, f) < -speed_tolerance(c))) continue;
        if (!is_of_contact(c, f)) {
            guess_friction(c, f);
            continue;
        }
        let_stick(c, f);
        stops = 1;
    }
    return stops;
}

/* Part of the rates of landing contacts, whose velocities are `part` and whose impulses are in mu, that gives `share` of what
   both stages take back: `taken`, and what the velocities `stop` take, whose impulses are in event_mu.          */
static double part_given_back(context *c, double share, double taken, const double *stop, const double *part, int driven)
{
    const double curved = 0.5 * mass_product(c, part, part);
    double linear = mass_product(c, part, c->s.v) + mass_product(c, part, stop);
    double lost = taken - mass_product(c, stop, c->s.v) - 0.5 * mass_product(c, stop, stop);
    if (driven) { /* what surfaces and drivers do is no loss */
        memset(c->k.ahead, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
        row_rates(c, c->s.q, c->s.q_low, c->k.ahead, c->s.signal, c->k.signal_rate, c->k.row_rate);
        for (int32_t i = 0; i < c->m->n_rows; i++) {
            linear -= c->k.mu[i] * c->k.row_rate[i];
            lost += c->k.event_mu[i] * c->k.row_rate[i];
        }
    }
    const double back = share * fmax(lost, 0.0), root = linear + sqrt(fmax(linear * linear + 4.0 * curved * back, 0.0));
    return back > 0.0 && root > 0.0 ? 2.0 * back / root : 0.0;
}

/* Velocities of the second stage (hit_defect), and their impulses (event_mu). */
static int32_t velocities_of_parting(context *c, double taken, int driven)
{
    const int32_t n = DIM * c->n_moving, rows = c->m->n_rows;
    double *stop = c->k.hit_defect, *part = c->k.free;
    stand_still(c);
    const int32_t status = factorise_at_state(c, NULL);
    if (status) return status;
    forget_dependent_rows(c);
    find_dependent_rows(c);
    rates_to_stop(c);
    velocities_for(c, stop);
    memcpy(c->k.event_mu, c->k.mu, sizeof(double) * (size_t)rows);
    const double share = rates_of_landing(c);
    if (!(share > 0.0)) return HOLONOM_OK;
    velocities_for(c, part);
    const double f = part_given_back(c, share, taken, stop, part, driven);
    for (int32_t k = 0; k < n; k++) stop[k] += f * part[k];
    for (int32_t i = 0; i < rows; i++) c->k.event_mu[i] += f * c->k.mu[i];
    return HOLONOM_OK;
}

/* Likewise, the velocities that stop the slips of frictions which stick; contacts keep the rates that they have. */
static int32_t velocities_of_stopping(context *c)
{
    stand_still(c);
    const int32_t status = factorise_at_state(c, NULL);
    if (status) return status;
    memset(c->k.phi, 0, sizeof(double) * (size_t)c->m->n_rows);
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        for (int k = 0; k < n_slips(c, f) && friction_mode(c, f) == FRICTION_STICKS; k++)
            c->k.phi[row_of(c, slip_row(c, f, k))] = rate_of_row(c, slip_row(c, f, k));
    velocities_for(c, c->k.hit_defect);
    memcpy(c->k.event_mu, c->k.mu, sizeof(double) * (size_t)c->m->n_rows);
    return HOLONOM_OK;
}

/* Second stage; `taken` is what contacts have taken in the first one, of length h and that parity. */
static int32_t part_contacts(context *c, double taken, int parity)
{
    const holonom_model *m = c->m;
    evaluate_state(c);
    const int driven = is_driven(c);
    for (int32_t f = 0; f < m->n_frictions; f++) c->k.lands[f] = 0.0;
    for (int32_t i = 0; i < m->n_contacts; i++)
        if (m->contact_friction[i] >= 0) c->k.lands[m->contact_friction[i]] = is_landing(c, i);
    suspend_resting(c, 1);
    int32_t status = velocities_of_parting(c, taken, driven);
    if (!status) add_velocities(c, c->k.hit_defect, driven);
    for (int32_t i = 0; i < m->n_contacts && !status; i++) {
        const int32_t row = row_of(c, m->contact_row[i]);
        double *own = contact_of(c, i);
        if (!is_landing(c, i)) continue;
        own[C_IMPACTS] += touch_of(c, i)->rate < -speed_tolerance(c) ? 1.0 : 0.0;
        own[C_IMPULSE] -= c->h * c->s.mu[parity][row] + c->k.event_mu[row];
        c->s.head[S_EVENTS] += 1.0;
    }
    suspend_resting(c, 0);
    if (!status && stop_reversed(c)) {
        suspend_resting(c, 1);
        status = velocities_of_stopping(c);
        if (!status) add_velocities(c, c->k.hit_defect, driven);
        suspend_resting(c, 0);
    }
    for (int32_t i = 0; i < m->n_contacts && !status; i++)
        if (is_closed(c, i) && gap_rate(c, i) > speed_tolerance(c)) open_contact(c, i);
    return status;
}

/* ---------------------------------------------------------------------------------------- half steps */

static double booked(const context *c, int account) { return c->s.head[account] + c->s.head[account + 1]; }

static int has_closed(const context *c)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (is_closed(c, i)) return 1;
    return 0;
}

/* One half step, which counts only if its ledger closes and contacts give no energy. */
static int32_t try_half(context *c, double h, int half)
{
    const int parity = half % 2;
    const double before = ledger_balance(c, kinetic_energy(c, c->k.momentum), potential_change(c));
    const double impact = booked(c, S_IMPACT), friction = booked(c, S_FRICTION);
    c->h = h;
    c->half = half;
    if (c->m->sensing) sense(c, h, parity);
    if (c->m->time_dependent || c->m->sensing) set_laws(c, c->t + 0.5 * h, 1);
    signals_at(c, c->t + h, c->k.signal1);
    forget_changes(c);
    int32_t status = solve_contacts(c, parity);
    if (status) return status;
    accept_step(c, parity);
    if (has_closed(c) || c->m->n_frictions) status = part_contacts(c, booked(c, S_IMPACT) - impact, parity);
    if (status) return status;
    const double after = ledger_balance(c, kinetic_energy(c, c->k.momentum), potential_change(c));
    const double allowed = fmax(c->s.head[S_NEWTON_TOLERANCE], 1e-12) * c->s.head[S_ENERGY_REFERENCE];
    if (HOLONOM_ENERGY_DECIDES && !(fabs(after - before) <= allowed)) return HOLONOM_NEWTON_DIVERGED;
    const double by_hits = booked(c, S_IMPACT) - impact, by_slips = booked(c, S_FRICTION) - friction;
    const double given = fmin(by_slips, 0.0) - fmin(by_hits, 0.0); /* of what both take the sum alone is never negative */
    if (given != 0.0) book(c, S_IMPACT, given), book(c, S_FRICTION, -given);
    return by_hits + by_slips >= -allowed ? HOLONOM_OK : HOLONOM_CONTACT_UNDECIDED;
}

/* A half step of length h; where it fails, two of half its length. */
static int32_t stepped_half(context *c, double h, int half, int divisions)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    memcpy(c->k.stepped_backup, c->s.head, sizeof(double) * (size_t)c->state_size);
    int32_t status = HOLONOM_OK;
    for (c->careful = 0; c->careful <= has_smooth(c); c->careful++) {
        status = try_half(c, h, half);
        if (!status) return HOLONOM_OK;
        restore_state(c, c->k.stepped_backup, t, law_time);
        lower_penalties(c);
    }
    if (divisions == MOST_DIVISIONS) return status;
    status = stepped_half(c, 0.5 * h, 0, divisions + 1);
    return status ? status : stepped_half(c, 0.5 * h, 1, divisions + 1);
}

static inline int is_stepped(const context *c) { return c->m->unilateral && c->s.head[S_CONTACT_MODE] != 0.0; }

/* Whether the equations of a step had no solution, as contacts and frictions were. */
static inline int is_unsolved(int32_t status)
{
    return (status >= HOLONOM_NEWTON_DIVERGED && status <= HOLONOM_NOT_FINITE) || status == HOLONOM_TURN_TOO_LARGE ||
           status == HOLONOM_DAMPING_REVERSED;
}

/* Whether stepped mode may go on where located mode has failed so. */
static inline int may_step_over(int32_t status)
{
    return is_unsolved(status) || status == HOLONOM_TOO_MANY_EVENTS || status == HOLONOM_IMPACT_UNSOLVED ||
           status == HOLONOM_CONTACT_UNDECIDED;
}

/* Whether a piece of length h that failed so is to be cut: a slip in space may stop sooner than its rate says. */
static int is_to_be_cut(const context *c, int32_t status, double h)
{
    return is_unsolved(status) && slides_in_space(c) && !is_short(c, h);
}

/* Covers the rest of a communication step of length `step` that began at `start`. Multipliers are those of the last pair:
   no line through them leads across an impact.                                                                  */
HM_SELDOM static int32_t cover_stepped(context *c, double start, double done, double step)
{
    double *head = c->s.head;
    const double rest = step - done, longest = fmin(head[S_STEP_SIZE], head[S_LONGEST_STEP]);
    const double n = fmax(1.0, ceil(rest / longest * (1.0 - 1e-10))), h = rest / n;
    int32_t status = n < 1e9 ? HOLONOM_OK : HOLONOM_BAD_STEP;
    head[S_STEPPED] = 1.0;
    head[S_ORDER_IN_USE] = 2.0;
    c->stepping = 1;
    for (int64_t i = 0; !status && i < (int64_t)n; i++) {
        c->t = start + done + h * (double)i;
        c->unweighted = 0;
        begin_halves(c, 2);
        status = stepped_half(c, 0.5 * h, 0, 0);
        if (!status) status = stepped_half(c, 0.5 * h, 1, 0);
        if (status) break;
        average_multipliers(c, c->t - 0.5 * h);
        memcpy(c->s.mean_before, c->s.mean, sizeof(double) * (size_t)c->m->n_rows);
        memcpy(c->s.driven_mean_before, c->s.driven_mean, sizeof(double) * (size_t)(DIM * c->m->n_driven));
        follow_energies(c);
    }
    c->stepping = 0;
    if (!is_stepped(c)) head[S_UNSETTLED] = 1.0; /* located mode looks at contacts anew */
    return status;
}

/* Covers the rest after located mode has failed for the reason `why`, from the start of the piece that it could not solve.
   If that fails, too, the step fails for the same reason.                                                       */
HM_SELDOM static int32_t step_over(context *c, int32_t why, double start, double done, double step)
{
    const int32_t at_fault = c->at_fault, status = cover_stepped(c, start, done, step);
    if (!status) return HOLONOM_OK;
    c->at_fault = at_fault;
    return why;
}

/* Contacts at the start of a run. In stepped mode what hits does so in the first half step, and those are closed that the
   first multipliers agree with, if any do.                                                                      */
HM_SELDOM static int32_t begin_contacts(context *c)
{
    if (!is_stepped(c)) return settle(c);
    const int32_t status = settle_modes(c);
    c->s.head[S_UNSETTLED] = 0.0;
    return status == HOLONOM_CONTACT_UNDECIDED ? HOLONOM_OK : status;
}

#endif
