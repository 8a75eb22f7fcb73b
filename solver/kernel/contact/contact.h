/* Contacts and frictions at a state: gaps, slips, and what holds at the level of accelerations.

   Touching contacts that do not part, and frictions that do not slide, are rows. Which do is a
   complementarity problem

       0 <= N _|_ gap'' >= 0,     |T| <= c_s N + preload where there is no slip,

   with the coefficient c_s of sticking, solved by changing one at a time, the worst first. */
#ifndef HOLONOM_CONTACT_H
#define HOLONOM_CONTACT_H

#include "start.h"

/* What counts as zero, relative to the scale named. */
#define TOUCHING                                                                                   \
    1e-10 /* gap over the size of the mechanism up to which a contact takes part in an impact */
#define RESTING 1e-10  /* speed over that of the mechanism */
#define NO_FORCE 1e-11 /* force over the largest normal force */
#define NO_GROWTH 1e-9 /* acceleration over the largest one */
#define GIVEN_BY_FORCE 1e-12 /* growth of a slip over what its force changes of it */
#define TURNED 1e-9    /* change of a unit direction */
#define PARTING 1e-5   /* likewise, of the gap of a contact that the event at hand has opened */

static double speed_tolerance(const context *c)
{
    const double *extent = c->number + c->m->extent_at;
    return fmax(RESTING * speed_scale(c) * extent[0] / extent[1], 1e-300);
}

/* Acceleration that counts as zero, with the accelerations in w. */
HM_SELDOM static double growth_tolerance(const context *c)
{
    double most2 = dot(c->number + c->m->gravity_at, c->number + c->m->gravity_at);
    for (int32_t a = 0; a < c->n_moving; a++)
        if (!c->m->node_kind[a]) most2 = fmax(most2, dot(c->k.w + DIM * a, c->k.w + DIM * a));
    return NO_GROWTH * sqrt(most2);
}

HM_SELDOM static double gap_tolerance(const context *c)
{ return TOUCHING * c->number[c->m->extent_at]; }

/* Gap of contact i at the state. Its quantities, as those of the rates below, are evaluated
   before. */
static double gap_of(const context *c, int32_t i)
{ return value_of_function(c, c->m->contact_row[i], 0); }

/* Rate of a function row, value of a velocity row at the state. */
static double rate_of_row(const context *c, int32_t j)
{
    return function_rate(c, j, c->s.v, c->k.signal_rate);
}

static double gap_rate(const context *c, int32_t i) { return rate_of_row(c, c->m->contact_row[i]); }

/* Second derivative of a function row, rate of a velocity row, with the accelerations in w. */
HM_SELDOM static double second_rate_of_row(const context *c, int32_t j)
{
    double *none = c->k.signal_before; /* second derivatives of signals are in the bias */
    memset(none, 0, sizeof(double) * (size_t)c->m->n_signals);
    const double bias = bias_of_row(c, j);
    return function_rate(c, j, c->k.w, none) + bias;
}

/* Rates of the slips of friction f in the motion v, at the state. */
static void slips_in_motion(const context *c, int32_t f, const double *v, const double *signal_rate,
                            double *rate)
{
    for (int k = 0; k < n_slips(c, f); k++)
        rate[k] = next_rate(c, k > 0 ? slip_row(c, f, k - 1) : -1, slip_row(c, f, k), v,
                            signal_rate);
}

/* Likewise with the velocities. */
static inline void slip_rates(const context *c, int32_t f, double *slip)
{ slips_in_motion(c, f, c->s.v, c->k.signal_rate, slip); }

/* How fast they change, with the accelerations in w. */
HM_SELDOM static void slip_changes(const context *c, int32_t f, double *change)
{
    double own[3], *none = c->k.signal_before, *rest = c->k.ahead;
    memset(none, 0, sizeof(double) * (size_t)c->m->n_signals);
    memset(rest, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    slips_in_motion(c, f, rest, c->k.signal_rate, own);
    slips_in_motion(c, f, c->k.w, none, change);
    for (int k = 0; k < n_slips(c, f); k++) {
        const int32_t j = slip_row(c, f, k);
        change[k] +=
            next_bias(c, k > 0 ? slip_row(c, f, k - 1) : -1, j) - own[k] + c->k.drift[row_of(c, j)];
    }
}

/* Normal force of contact i at the state, after evaluate_forces. */
static double normal_of(const context *c, int32_t i)
{ return -c->k.event_mu[row_of(c, c->m->contact_row[i])]; }

/* Size of n slips, or of what acts along them, and their direction if wanted. */
static double direction_of(int n, const double *x, double *along)
{
    double size2 = 0.0;
    for (int k = 0; k < n; k++) size2 += hm_square(x[k]);
    for (int k = 0; k < n && along; k++) along[k] = size2 > 0.0 ? x[k] / sqrt(size2) : 0.0;
    return sqrt(size2);
}

/* Size of those of the multipliers mu that are of friction f, and these over it as a direction if
   wanted. */
static double friction_force(const context *c, int32_t f, const double *mu, double *along)
{
    double own[3];
    for (int k = 0; k < n_slips(c, f); k++) own[k] = mu[row_of(c, slip_row(c, f, k))];
    return direction_of(n_slips(c, f), own, along);
}

/* Slip of friction f at the state, and its direction if wanted. */
static double slip_of(const context *c, int32_t f, double *along)
{
    double slip[3];
    slip_rates(c, f, slip);
    return direction_of(n_slips(c, f), slip, along);
}

/* Likewise; of a smooth friction the direction is less than 1, as its law makes it. */
HM_SELDOM static double slip_at_state(const context *c, int32_t f, double *along)
{
    const double slip = slip_of(c, f, along);
    for (int k = 0; k < n_slips(c, f) && is_smooth(c, f); k++)
        along[k] *= slip / hm_hypot(slip, c->number[c->m->smooth_speed_at + f]);
    return slip;
}

/* Evaluates laws, quantities and rates of signals at the present state. */
HM_SELDOM static void evaluate_state(context *c)
{
    if (!c->step.changes_contacts) see_all(c);
    if (c->m->sensing) sense(c, 0.0, 0);
    if (c->m->time_dependent || c->m->sensing) set_laws(c, c->t, 1);
    quantities_at_state(c);
    signal_rates_at(c, c->t, c->k.signal_rate);
    c->factors.kept_h = 0.0; /* factors of a step do not outlast what follows */
}

/* Blames the closed contact that is pressed most, by the means of the last half step; none if all
   are open. */
HM_SELDOM static void blame_hardest(context *c)
{
    double most = -INFINITY;
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        const int32_t j = c->m->contact_row[i];
        if (!is_closed(c, i) || !(-c->s.mean[row_of(c, j)] > most)) continue;
        most = -c->s.mean[row_of(c, j)];
        blame(c, j);
    }
}

/* ---------------------------------------------------------------------------------------- modes */

HM_SELDOM static void let_stick(context *c, int32_t f)
{ friction_of(c, f)[F_MODE] = FRICTION_STICKS; }

/* Friction f slides along that direction, from now on: what a step before left for its slip is
   none. */
HM_SELDOM static void let_slide(context *c, int32_t f, const double *along)
{
    for (int k = 0; k < n_slips(c, f) && friction_mode(c, f) != FRICTION_SLIDES; k++)
        c->k.slip[row_of(c, slip_row(c, f, k))] = NAN;
    friction_of(c, f)[F_MODE] = FRICTION_SLIDES;
    c->friction.slides = 1;
    for (int k = 0; k < n_slips(c, f); k++) friction_of(c, f)[F_ALONG_1 + k] = along[k];
}

/* First guess of a friction's mode: with slip it slides; without slip one that was about to slide
   still is, and others stick. Without coefficient and preload it is off, since it would be at its
   cone always. A smooth one slides. That of a contact is off while it is deferred. */
HM_SELDOM static void guess_friction(context *c, int32_t f)
{
    double along[3];
    if (!(cone(c, f, 0, 1.0) > 0.0) || is_deferred(c, f)) friction_of(c, f)[F_MODE] = FRICTION_OFF;
    else if (slip_at_state(c, f, along) > speed_tolerance(c) || is_smooth(c, f))
        let_slide(c, f, along);
    else if (friction_mode(c, f) != FRICTION_SLIDES) let_stick(c, f);
}

/* Value at time t on the line through the means of the last steps. */
static void extrapolate(const context *c, double t, int32_t n, const double *mean,
                        const double *before, double *y)
{
    const double *head = c->s.head, gap = head[S_MEAN_TIME] - head[S_MEAN_TIME_BEFORE];
    double ahead = gap > 0.0 && gap < INFINITY ? (t - head[S_MEAN_TIME]) / gap : 0.0;
    if (is_unilateral(c->m) && !(ahead <= FARTHEST))
        ahead = 0.0; /* a short piece lies between the means */
    for (int32_t i = 0; i < n; i++) y[i] = mean[i] + ahead * (mean[i] - before[i]);
}

/* Whether what sticks shares forces otherwise than rows do. */
static int has_shares(const context *c) { return c->s.head[S_SHARES] != 0.0; }

/* Adds to multipliers mu of half steps what is shared otherwise than rows do, see
   contact_split.h. */
static void add_shares(const context *c, double *mu)
{
    for (int32_t i = 0; i < c->m->n_rows && has_shares(c); i++) mu[i] += c->s.shift[i];
}

/* Evaluates multipliers (in event_mu) and accelerations (in w) at the state, with the modes at
   hand; signal_rate is that of the state. */
HM_SELDOM static int32_t evaluate_forces(context *c)
{
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        if (is_smooth(c, f) && friction_mode(c, f) == FRICTION_SLIDES) guess_friction(c, f);
    const int32_t status = accelerations(c, c->k.event_mu);
    c->factors.may_share = has_small_pivot(c);
    signal_rates_at(c, c->t, c->k.signal_rate);
    quantities_at_state(c);
    return status;
}

HM_SELDOM static void open_contact(context *c, int32_t i)
{
    const int32_t f = c->m->contact_friction[i];
    contact_of(c, i)[C_CLOSED] = 0.0;
    if (f >= 0) friction_of(c, f)[F_MODE] = FRICTION_OFF;
}

/* Lets go all that contacts and frictions hold, as an impact asks for. */
HM_SELDOM static void open_all(context *c)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++) open_contact(c, i);
    for (int32_t f = 0; f < c->m->n_frictions; f++) friction_of(c, f)[F_MODE] = FRICTION_OFF;
}

/* Closes contact i at this gap. */
HM_SELDOM static void close_contact_at(context *c, int32_t i, double gap)
{
    const int32_t f = c->m->contact_friction[i];
    double *x = contact_of(c, i);
    x[C_CLOSED] = 1.0;
    x[C_ASLEEP_UNTIL] = 0.0;
    x[C_REFERENCE] = gap;
    if (f >= 0) guess_friction(c, f);
}

/* Closes contact i at the gap that it has. */
HM_SELDOM static void close_contact(context *c, int32_t i)
{
    close_contact_at(c, i, is_closed(c, i) ? contact_of(c, i)[C_REFERENCE] : gap_of(c, i));
}

/* Opens the closed contact that pulls most; 0 if none does. */
HM_SELDOM static int open_worst(context *c, double none)
{
    int32_t worst = -1;
    double least = -none;
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (is_closed(c, i) && normal_of(c, i) < least) least = normal_of(c, i), worst = i;
    if (worst < 0) return 0;
    open_contact(c, worst);
    blame(c, c->m->contact_row[worst]);
    return 1;
}

/* How far the force of friction f that sticks is beyond its cone, less a little of that. */
HM_SELDOM static double excess_of(const context *c, int32_t f)
{
    const double limit = cone(c, f, 0, normal_force(c, f, c->k.event_mu));
    return friction_force(c, f, c->k.event_mu, NULL) - limit - 1e-10 * fabs(limit);
}

/* Whether a closed contact pulls or a friction that sticks is beyond its cone. */
HM_SELDOM static int is_beyond(const context *c, double none)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (is_closed(c, i) && normal_of(c, i) < -none) return 1;
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        if (friction_mode(c, f) == FRICTION_STICKS && excess_of(c, f) > none) return 1;
    return 0;
}

/* Lets the friction that is farthest beyond its cone slide; 0 if all hold. */
HM_SELDOM static int slide_worst(context *c, double none)
{
    int32_t worst = -1;
    double most = none, along[3];
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        if (friction_mode(c, f) != FRICTION_STICKS) continue;
        const double excess = excess_of(c, f);
        if (excess > most) most = excess, worst = f;
    }
    if (worst < 0) return 0;
    friction_force(c, worst, c->k.event_mu, along);
    let_slide(c, worst, along);
    blame(c, slip_row(c, worst, 0));
    return 1;
}

/* Of frictions that stick though their slip grows, the one whose slip does so fastest; -1: there is
   none. No force of its own stops it: the mechanism is at a dead centre, where forces do not change
   the slip, or others contradict it. `along`, if wanted: the way in which it grows. */
HM_SELDOM static int32_t torn_loose(const context *c, double *along)
{
    int32_t fastest = -1;
    double most = growth_tolerance(c);
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        double growth[3], size2 = 0.0;
        if (friction_mode(c, f) != FRICTION_STICKS) continue;
        slip_changes(c, f, growth);
        for (int k = 0; k < n_slips(c, f); k++) size2 += hm_square(growth[k]);
        const double size = sqrt(size2),
                     sigma = c->number[c->m->row_sigma_at + row_of(c, slip_row(c, f, 0))];
        if (!(size
              > fmax(most, GIVEN_BY_FORCE * sigma * friction_force(c, f, c->k.event_mu, NULL))))
            continue;
        most = size, fastest = f;
        for (int k = 0; k < n_slips(c, f) && along; k++) along[k] = growth[k] / size;
    }
    return fastest;
}

/* Lets that friction slide; 0 if there is none. */
HM_SELDOM static int tear_loose(context *c)
{
    double along[3];
    const int32_t f = torn_loose(c, along);
    if (f < 0) return 0;
    let_slide(c, f, along);
    blame(c, slip_row(c, f, 0));
    return 1;
}

/* Rate at which the slip of friction f grows along its direction. */
HM_SELDOM static double slip_growth(const context *c, int32_t f)
{
    double growth[3], sum = 0.0;
    slip_changes(c, f, growth);
    for (int k = 0; k < n_slips(c, f); k++) sum += friction_of(c, f)[F_ALONG_1 + k] * growth[k];
    return sum;
}

/* Lets a friction stick whose slip would begin against its own direction; 0 if there is none. */
HM_SELDOM static int turn_back(context *c)
{
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        double *x = friction_of(c, f);
        if (x[F_MODE] != FRICTION_SLIDES || is_smooth(c, f)
            || slip_of(c, f, NULL) > speed_tolerance(c)
            || !(slip_growth(c, f) < -growth_tolerance(c)))
            continue;
        x[F_MODE] = FRICTION_STICKS;
        blame(c, slip_row(c, f, 0));
        return 1;
    }
    return 0;
}

/* Lets frictions stick that were let slide but have no slip and do not begin one, as others that
   began to slide with them gave way for them; 0 if there are none. */
HM_SELDOM static int hold_still(context *c)
{
    int held = 0;
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        double growth[3], growth2 = 0.0;
        if (friction_mode(c, f) != FRICTION_SLIDES || is_smooth(c, f)
            || slip_of(c, f, NULL) > speed_tolerance(c))
            continue;
        slip_changes(c, f, growth);
        for (int k = 0; k < n_slips(c, f); k++) growth2 += hm_square(growth[k]);
        if (growth2 > hm_square(growth_tolerance(c))) continue;
        let_stick(c, f);
        held = 1;
    }
    return held;
}

#define TURNING_STIFFNESS 0.6 /* over the sum of those of the rows */
/* Of a friction that turns, in k.turning: how it is to turn, how it was to before, and where that
   was; and whether it turns. */
enum { TURNS_NOW = 0, TURNED_LAST = 3, WAS_ALONG = 6, IS_TURNING = 9, TURNING_SIZE };

/* Whether friction f has several slips, slides, and its slip is about to begin. */
static int begins_in_space(context *c, int32_t f)
{
    return n_slips(c, f) > 1 && friction_mode(c, f) == FRICTION_SLIDES
           && slip_of(c, f, NULL) <= speed_tolerance(c);
}

/* How the direction of the beginning slip of friction f is to turn (turn, overwritten): towards the
   way in which it grows. With a stiffness of more than half of that of the rows, a step to the
   friction that stops the slip and back to the cone converges. */
HM_SELDOM static void turn_towards_growth(context *c, int32_t f, double *turn)
{
    const int n = n_slips(c, f);
    const double *along = friction_of(c, f) + F_ALONG_1,
                 force = cone(c, f, 1, normal_force(c, f, c->k.event_mu));
    double pull[3], growth[3], stiffness = 0.0;
    for (int k = 0; k < n; k++)
        stiffness +=
            TURNING_STIFFNESS * c->number[c->m->row_sigma_at + row_of(c, slip_row(c, f, k))];
    slip_changes(c, f, growth);
    for (int k = 0; k < n; k++) pull[k] = force * along[k] + growth[k] / stiffness;
    const double size = direction_of(n, pull, pull);
    for (int k = 0; k < n; k++) turn[k] = size > 0.0 ? pull[k] - along[k] : 0.0;
}

/* Turns slips of several rates that are about to begin; 0 if they begin as they grow. Turns
   contract by a constant: from the second in turn on (`again`) the secant of the last two leads on
   (Anderson 1965), as long as they become smaller. */
HM_SELDOM static int turn_beginning_slips(context *c, int again)
{
    double most = 0.0, size2 = 0.0, last2 = 0.0, change2 = 0.0, along_change = 0.0;
    EACH_FRICTION(c, f) {
        double *own = c->k.turning + TURNING_SIZE * f, *now = own + TURNS_NOW,
               *last = own + TURNED_LAST;
        own[IS_TURNING] = begins_in_space(c, f);
        if (own[IS_TURNING] == 0.0) continue;
        for (int k = 0; k < n_slips(c, f); k++) last[k] = now[k];
        turn_towards_growth(c, f, now);
        for (int k = 0; k < n_slips(c, f); k++) {
            most = fmax(most, fabs(now[k]));
            size2 += now[k] * now[k];
            last2 += last[k] * last[k];
            change2 += hm_square(now[k] - last[k]);
            along_change += (now[k] - last[k]) * now[k];
        }
    }
    const double part = again && size2 < last2 && change2 > 0.0 ? along_change / change2 : 0.0;
    EACH_FRICTION(c, f) {
        double *own = c->k.turning + TURNING_SIZE * f, *before = own + WAS_ALONG,
               *along = friction_of(c, f) + F_ALONG_1, turned[3];
        if (own[IS_TURNING] == 0.0) continue;
        for (int k = 0; k < n_slips(c, f); k++) {
            const double now = own[TURNS_NOW + k], change = now - own[TURNED_LAST + k];
            turned[k] =
                along[k] + now - (part != 0.0 ? part * (along[k] - before[k] + change) : 0.0);
            before[k] = along[k];
        }
        direction_of(n_slips(c, f), turned, along);
    }
    return most > TURNED;
}

/* Whether contact i touches and its gap does not move. */
HM_SELDOM static int is_at_rest(const context *c, int32_t i)
{
    return gap_of(c, i) <= gap_tolerance(c) && fabs(gap_rate(c, i)) <= speed_tolerance(c);
}

/* Closes an open contact that touches, does not move and would get closer; 0 if none does. */
HM_SELDOM static int close_worst(context *c)
{
    int32_t worst = -1;
    double least = -growth_tolerance(c);
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        if (is_closed(c, i) || !is_at_rest(c, i)) continue;
        const double growth = second_rate_of_row(c, c->m->contact_row[i]);
        if (contact_of(c, i)[C_PARTED] != 0.0
            && growth > -growth_tolerance(c) * PARTING / NO_GROWTH)
            continue;
        if (growth < least) least = growth, worst = i;
    }
    if (worst < 0) return 0;
    close_contact(c, worst);
    blame(c, c->m->contact_row[worst]);
    return 1;
}

HM_SELDOM static double largest_normal(const context *c, const double *mu)
{
    double largest = 0.0;
    EACH_CONTACT(c, i)
        if (is_closed(c, i)) largest = fmax(largest, fabs(mu[row_of(c, c->m->contact_row[i])]));
    return largest;
}

/* Force that counts as zero: relative to the largest one or to the reference energy over the size
   of the mechanism, the larger of both, so that a contact which carries nothing does not open and
   close by round-off. */
HM_SELDOM static double force_tolerance(const context *c)
{
    const double extent = c->number[c->m->extent_at];
    return NO_FORCE
           * fmax(largest_normal(c, c->k.event_mu),
                  c->s.head[S_ENERGY_REFERENCE] / fmax(extent, 1.0));
}

/* First guess of the modes at the present state: contacts that touch without approaching are
   closed, unless `parted` says that the last event opened them. */
HM_SELDOM static void guess_modes(context *c)
{
    const holonom_model *m = c->m;
    evaluate_state(c);
    for (int32_t i = 0; i < m->n_contacts; i++) {
        double *x = contact_of(c, i);
        if (is_at_rest(c, i) && x[C_PARTED] == 0.0) close_contact(c, i);
        else open_contact(c, i);
    }
    for (int32_t f = 0; f < m->n_frictions; f++)
        if (!is_of_contact(c, f)) guess_friction(c, f);
}

/* Finds multipliers and accelerations of the modes at hand, as at the start of a run. */
static int32_t start_with_modes(context *c)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++) contact_of(c, i)[C_PARTED] = 0.0;
    forget_dependent_rows(c);
    const int32_t status = first_multipliers(c);
    forget_halves(c);
    return status;
}

#endif
