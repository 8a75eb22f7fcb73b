/* Which rows are on: those of contacts while they are closed, those of frictions while they stick.
   While a friction slides, its rows' multipliers follow the cone

       mu_k = (c N + preload) t_k,      N = sum of |lambda of some rows|,

   c the coefficient of sliding, t the direction of the slip psi; the friction -mu_k grad psi_k then
   works -mu_k psi_k <= 0, exactly. Smooth friction always slides, with t = psi/sqrt(psi^2 +
   smooth_speed^2). */
#ifndef HOLONOM_ROW_STATE_H
#define HOLONOM_ROW_STATE_H

#include "composite.h"

/* Multipliers are extrapolated from their last two means no farther than this many times the time
   between these. */
#define FARTHEST 2.0

enum row_state { ROW_IS_ON, ROW_IS_OFF, ROW_IS_SLIDING };

static inline double *contact_of(const context *c, int32_t i) { return c->s.contacts + C_SIZE * i; }

static inline double *friction_of(const context *c, int32_t f)
{ return c->s.frictions + F_SIZE * f; }

/* Notes composite j, a row, as the one to name if the step fails. */
static inline void blame(context *c, int32_t j) { c->step.at_fault = row_of(c, j) + 1; }

static inline int is_closed(const context *c, int32_t i)
{ return contact_of(c, i)[C_CLOSED] != 0.0; }

static inline int friction_mode(const context *c, int32_t f)
{
    const double mode = friction_of(c, f)[F_MODE];
    return mode == FRICTION_STICKS   ? FRICTION_STICKS
           : mode == FRICTION_SLIDES ? FRICTION_SLIDES
                                     : FRICTION_OFF;
}

/* Contact i, or friction f as n_contacts + f, that composite j is a row of; -1: of neither, it is
   always on. */
static inline int32_t owner_of(const context *c, int32_t j)
{
    return is_unilateral(c->m) && is_row(c, j) ? c->m->row_owner[j - first_function(c)] : -1;
}

static inline enum row_state state_of_row(const context *c, int32_t j)
{
    const int32_t owner = owner_of(c, j), f = owner - n_contacts(c->m);
    if (owner < 0) return ROW_IS_ON;
    if (f < 0) return is_closed(c, owner) ? ROW_IS_ON : ROW_IS_OFF;
    const int mode = friction_mode(c, f);
    return mode == FRICTION_STICKS   ? ROW_IS_ON
           : mode == FRICTION_SLIDES ? ROW_IS_SLIDING
                                     : ROW_IS_OFF;
}

/* The composite of multiplier i, or -1 if it is no function. */
static inline int32_t composite_of(const context *c, int32_t i)
{
    const int32_t j = i - first_function_row(c->m);
    return j < 0 ? -1 : j + first_function(c);
}

/* State of the row of multiplier i. */
static inline enum row_state state_of_multiplier(const context *c, int32_t i)
{
    const int32_t j = is_unilateral(c->m) ? composite_of(c, i) : -1;
    return j < 0 ? ROW_IS_ON : state_of_row(c, j);
}

/* Whether all contacts and frictions are off. */
static int are_all_off(const context *c)
{
    EACH_CONTACT(c, i) if (is_closed(c, i)) return 0;
    EACH_FRICTION(c, f) if (friction_mode(c, f) != FRICTION_OFF) return 0;
    return 1;
}

/* Takes rows that are off out of the pieces at hand, until take_all_rows: a step has no multipliers
   and residuals of theirs. */
static void leave_rows_out(context *c)
{
    const holonom_model *m = c->m;
    span *row = (span *)(void *)c->k.pieces,
         *composite = row + 2 + m->n_function_rows + m->n_velocity_rows;
    const int32_t first = row_of(c, first_function(c));
    c->view.asleep = 1;
    int rows = 0, composites = add_piece(composite, 0, c->view.begin[ISLAND_ELEMENT],
                                         c->view.end[ISLAND_ELEMENT]);
    for (; rows < c->view.rows && c->view.row[rows].begin < first; rows++)
        row[rows] = (span){c->view.row[rows].begin,
                           c->view.row[rows].end < first ? c->view.row[rows].end : first};
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY; k++)
        EACH_ROW_OF_KIND(c, j, k) {
            const int32_t i = row_of(c, j);
            if (state_of_row(c, j) == ROW_IS_OFF) {
                c->k.mu[i] = c->k.lambda[i] = c->k.phi[i] = 0.0;
                continue;
            }
            c->view.asleep &= owner_of(c, j) < 0;
            rows = add_piece(row, rows, i, i + 1);
            composites = add_piece(composite, composites, j, j + 1);
        }
    c->view.composites = add_piece(composite, composites, c->view.begin[ISLAND_POTENTIAL],
                                   c->view.end[ISLAND_POTENTIAL]);
    c->view.rows = rows;
    c->view.row = row, c->view.composite = composite;
    c->view.left_out = 1;
}

/* Gap at which the contact of composite j closed and which its row keeps; 0 for other rows. */
static inline double reference_of(const context *c, int32_t j)
{
    const int32_t owner = owner_of(c, j);
    return owner >= 0 && owner < n_contacts(c->m) ? contact_of(c, owner)[C_REFERENCE] : 0.0;
}

/* Whether friction f belongs to the islands at hand. */
static inline int is_at_hand(const context *c, int32_t f)
{
    const int32_t j = c->m->friction_row[c->m->friction_row_ptr[f]];
    return j >= c->view.begin[ISLAND_VELOCITY] && j < c->view.end[ISLAND_VELOCITY];
}

/* Whether friction f is that of a contact, off while the contact is open, and not that of a
   joint. */
static inline int is_of_contact(const context *c, int32_t f)
{
    return c->m->normal_row[2 * c->m->normal_ptr[f] + 1] == NORMAL_PUSHES;
}

/* Whether contacts change at the ends of half steps only (stepped.h). */
static inline int is_stepped(const context *c)
{ return is_unilateral(c->m) && c->s.head[S_CONTACT_MODE] != 0.0; }

static inline int n_slips(const context *c, int32_t f)
{ return c->m->friction_row_ptr[f + 1] - c->m->friction_row_ptr[f]; }

static inline int32_t slip_row(const context *c, int32_t f, int k)
{ return c->m->friction_row[c->m->friction_row_ptr[f] + k]; }

/* Whether a friction in space slides. Its direction turns the faster the slower it is. */
static int slides_in_space(const context *c)
{
    EACH_FRICTION(c, f) if (n_slips(c, f) > 1 && friction_mode(c, f) == FRICTION_SLIDES) return 1;
    return 0;
}

/* Norm (in `root`) of the multipliers whose list begins at entry `at` of the normal force of
   friction f; the entry behind the list. */
static int32_t sum_of_squares(const context *c, int32_t f, int32_t at, const double *mu,
                              double *root)
{
    double sum = 0.0;
    do {
        sum += hm_square(mu[c->m->normal_row[2 * at]]);
        at++;
    } while (at < c->m->normal_ptr[f + 1] && c->m->normal_row[2 * at + 1] == NORMAL_CONTINUES);
    *root = sqrt(sum);
    return at;
}

/* Normal force of friction f with multipliers mu: what gaps push, and norms of the multipliers of
   joints. */
static double normal_force(const context *c, int32_t f, const double *mu)
{
    double sum = 0.0, root;
    for (int32_t at = c->m->normal_ptr[f]; at < c->m->normal_ptr[f + 1];) {
        if (c->m->normal_row[2 * at + 1] == NORMAL_PUSHES) sum -= mu[c->m->normal_row[2 * at++]];
        else {
            at = sum_of_squares(c, f, at, mu, &root);
            sum += root;
        }
    }
    return sum;
}

/* Friction with that normal force: the one with which f slides, or up to which it sticks. */
static double cone(const context *c, int32_t f, int sliding, double normal)
{
    const double coefficient = c->number[(sliding ? c->m->sliding_at : c->m->static_at) + f];
    return coefficient * normal + c->number[c->m->preload_at + f];
}

/* Whether friction f is smooth: it always slides, and no event begins or ends with it. */
static inline int is_smooth(const context *c, int32_t f)
{ return c->number[c->m->smooth_speed_at + f] > 0.0; }

/* Whether friction f may be deferred to the end of a half step: that of a contact with Coulomb's
   law. */
static inline int may_be_deferred(const context *c, int32_t f)
{ return is_of_contact(c, f) && !is_smooth(c, f); }

static inline int is_deferred(const context *c, int32_t f)
{ return c->friction.is_deferred && may_be_deferred(c, f); }

/* Whether a friction at hand is smooth. */
static int has_smooth(const context *c)
{
    for (int32_t f = 0; f < n_frictions(c->m); f++)
        if (is_smooth(c, f) && is_at_hand(c, f)) return 1;
    return 0;
}

/* Whether contacts or frictions are at hand. */
static int has_events(const context *c)
{
    const int32_t first = c->view.begin[ISLAND_FUNCTION], last = c->view.end[ISLAND_FUNCTION];
    for (int32_t i = 0; i < n_contacts(c->m); i++)
        if (c->m->contact_row[i] >= first && c->m->contact_row[i] < last) return 1;
    for (int32_t f = 0; f < n_frictions(c->m); f++)
        if (is_at_hand(c, f)) return 1;
    return 0;
}

/* A slip smaller than this part of what its friction changes in the step does not turn it at
   once. */
#define TURNING_PART 0.1
/* But does once the increments are so many times smaller than what would let Newton's iteration
   miss it: a slip s that is off by d turns a friction that changes slips by a through d/s, of which
   the iteration leaves a (d/s)^2, to be less than s. */
#define KNOWN_SLIP 10.0

/* Direction of the slip of friction f, of a smooth one less than 1, and the size of that slip: of
   several rows or of a smooth one that of the step at hand, else, at a state, or without slip, the
   direction with which it began to slide, and 0.

   Of several rows the size is negative where the slip is against the direction with which it began,
   as in stages that go back in time. A slip near 0 is no direction to follow, as Newton's iteration
   meets it where sliding begins or stops: the force then turns towards it from where it is, and
   both agree after some iterations, which contract by a third only. From where the slip is known
   the force follows it, as a smooth one does. */
static double slip_direction(const context *c, int32_t f, double *along)
{
    const int n = n_slips(c, f), smooth = is_smooth(c, f);
    const double *began = friction_of(c, f) + F_ALONG_1;
    const double sigma = c->number[c->m->row_sigma_at + row_of(c, slip_row(c, f, 0))]; /* [1/kg] */
    const double doubt2 = hm_square(KNOWN_SLIP * c->step.unsettled) * sigma;
    double slip2 = 0.0, turn2 = 0.0, size2 = hm_square(c->number[c->m->smooth_speed_at + f]),
           ahead = 0.0, way[3];
    for (int k = 0; k < n; k++) along[k] = began[k];
    if (c->step.at_state || (n == 1 && !smooth)) return 0.0;
    for (int k = 0; k < n; k++) {
        const int32_t row = row_of(c, slip_row(c, f, k));
        slip2 += hm_square(c->k.slip[row]);
        way[k] =
            smooth ? 0.0
                   : TURNING_PART * fabs(c->h) * c->number[c->m->row_sigma_at + row] * c->k.mu[row];
        turn2 += way[k] * way[k];
        ahead += c->k.slip[row] * began[k];
    }
    const double sign = ahead < 0.0 && !smooth ? -1.0 : 1.0;
    const double part =
        slip2 < turn2 && slip2 * slip2 * slip2 < doubt2 * doubt2 * turn2 ? 1.0 : 0.0;
    for (int k = 0; k < n; k++) {
        way[k] = part * way[k] + sign * c->k.slip[row_of(c, slip_row(c, f, k))];
        size2 += way[k] * way[k];
    }
    for (int k = 0; k < n && size2 > 0.0; k++) along[k] = way[k] / sqrt(size2);
    return sign * sqrt(size2);
}

/* Sets the multipliers lambda that the rows of sliding frictions are held to, from those of the
   normal forces in mu. */
static void follow_cones(const context *c)
{
    if (!c->friction.slides) return;
    EACH_FRICTION(c, f) {
        double along[3];
        if (friction_mode(c, f) != FRICTION_SLIDES || !is_at_hand(c, f)) continue;
        const double force = cone(c, f, 1, normal_force(c, f, c->k.mu));
        slip_direction(c, f, along);
        for (int k = 0; k < n_slips(c, f); k++)
            c->k.lambda[row_of(c, slip_row(c, f, k))] = force * along[k];
    }
}

/* Switches sliding frictions off (their mode changes its sign, which counts as off), or on again:
   part of the velocities that they bring about would not be orthogonal to what rows allow. */
static void suspend_sliding(context *c, int suspended)
{
    EACH_FRICTION(c, f) {
        double *x = friction_of(c, f);
        if (x[F_MODE] == (suspended ? FRICTION_SLIDES : -FRICTION_SLIDES)) x[F_MODE] = -x[F_MODE];
    }
}

#endif
