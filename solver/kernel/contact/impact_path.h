/* The path of an impact at a fixed configuration, and its rates at a place of it. With rates gamma
   = gamma- + W p, contacts i that approach with v_i are held from below by walls that move with a
   clock tau = -1 ..:

       0 <= p'_N _|_ gamma_N - c_i >= 0,   c_i = tau v_i as long as contact i is live, then 0,
       |p'_T| <= mu p'_N,   p'_T = -mu p'_N gamma_T/|gamma_T| where there is slip.

   Contact i has compressed with C_i = -int p'_N gamma_N over gamma_N < 0, expands with X_i, and is
   live until X_i = e_i^2 C_i (energetic restitution, Stronge 1990; walls after Moreau 1988;
   increments of friction after Routh 1905). For frictionless contacts with one e it is Newton's
   law; p is in Coulomb's cone, energy never grows, and the loss is sum (C_i - X_i) + D with the
   work D >= 0 of friction.

   The path is straight between events, but where slip turns in space: there a pair of order 8
   follows it.

   Jam: strong friction may leave no rates with which the walls go on (Painleve). Then all walls
   retreat until there are such rates; if that does not help, slip of 1e-6 of the speed counts as
   none; then the least sets of contacts without which there are rates end; at last all contacts
   stop at once, without restitution. */
#ifndef HOLONOM_IMPACT_PATH_H
#define HOLONOM_IMPACT_PATH_H

#include "contact_solver.h"
#include "share_impulses.h"

/* Ways out of a jam, as bits. */
enum { JAM_RETREATED = 1, JAM_SLOW_STOPPED = 2, JAM_ENDED = 4, JAM_PLASTIC = 8 };

/* Impulses in joints, as many as forces: of unit impulses (rows x forces); those of each contact,
   none of one that is no joint; of each whether it belongs to the norm of the one before. */
typedef struct joint_impulses {
    int32_t forces;
    const double *force;
    const int32_t *begin, *end, *continues;
} joint_impulses;

/* Rows are rates [m/s or rad/s], and impulses of the same contacts [N s or N m s]. A joint that
   rubs is a contact as well, whose p_N is a sum of norms of impulses in its rows; its normal row
   has no rate. */
typedef struct hm_impact {
    int32_t contacts, rows;
    const int32_t *first,
        *tangents; /* per contact: its normal row; rows of slip that follow it: 0 to 3 */
    const double *coefficient;       /* per contact, >= 0 */
    const double *restitution;       /* per contact, 0 .. 1 */
    double *W; /* rows x rows: G M^-1 G' reduced by the bilateral rows; may be singular. Normal rows
                  of joints, 0, are overwritten */
    const double *before; /* rows: gamma-; of a normal row negative where bodies approach */
    joint_impulses joints;
    double *impulse, *after;         /* rows, overwritten: p, gamma+ */
    double *compression, *expansion; /* per contact, overwritten: C, X [J] */
    double friction, plastic;        /* overwritten: D; what the last way out of a jam takes [J] */
    int32_t jam, several,
        pieces; /* overwritten: ways out taken; whether rates were not unique; parts of the path */
    int32_t newton; /* overwritten: whether Newton's restitution stood in, see hm_solve_impact */
    double *scratch;                 /* IMPACT_SCRATCH(rows) doubles */
} hm_impact;

#define SWEEP_ROUND_OFF 1e-12  /* of the sum of a row's terms: what counts as none */
#define SWEEP_ERROR 1e-13      /* likewise, the error of a part in which slip turns */
#define SWEEP_STOPS 5e-12      /* likewise, slip that turns and counts as stopped */
#define SLOW_SLIP 1e-6         /* likewise, in a jam */
#define BUDGET_SPENT 1e-14     /* of C */
#define CONE_LEFT                                                                                  \
    1e-8 /* of the cone, beyond which a contact that sticks beside slip that turns begins to       \
            slide; more than FITS, so that it is not found to stick at once */
#define BEGINS_SLOWLY                                                                              \
    1e-3 /* growth of a slip, likewise: its direction then follows from its rate */
#define HAS_BEGUN 1e-6         /* likewise, slip whose direction counts */
#define LARGE_RATES 30.0       /* of impulses, over those that walls bring about alone */
#define PAST_TURN                                                                                  \
    1e-6 /* rate of the clock in a step along impulses, by which a piece goes on beyond the place  \
            where walls turn back: there no rates could be told from infinite ones */
#define CONE_CLIPPED 1e-10     /* of the cone, by which friction of a turning slip may miss it */
#define REST_OF_RATES                                                                              \
    1e-3 /* of the rates before: round-off of them tells no more of rates that are less */
#define LAST_BIT 1e-8           /* of the way of the walls */
#define NO_WORK 1e-18          /* of p'.W p', over that of the rates of walls: rates of 0 */
enum { MOST_PRESSES = 100, MOST_ENDINGS = 10 };

/* Who pushes in a turning piece, and whether it slides, sticks or begins to slide: fixed as long as
   the piece lasts. */
enum { IDLE, PUSHES_SLIDING, PUSHES_STUCK, PUSHES_BEGINNING };

/* Of the active contacts: W and what else their rates are found from, and the contact of each. */
typedef struct active_rows {
    double *matrix, *b, *way, *p, *rate, *coefficient;
    int32_t *first, *tangents, *slides, *contact;
} active_rows;

/* Per contact: v; the rate of its wall in a jam, how far that is, and its rate in the piece;
   whether it is live, on, sticks, and whether it waits: it has ended below its wall, which stands
   until there are rates with which it rises. */
typedef struct impact_walls {
    double *speed, *retreat, *deep, *rate;
    int32_t *live, *on, *stuck, *waits;
} impact_walls;

/* Numbers of a sweep: rows each, those of contacts as many. */
typedef struct impact_path {
    hm_impact *x;
    contact_problem rates; /* of the active contacts */
    active_rows active;
    double *gamma, *size;  /* rates now; sum of the sizes of their terms so far */
    double *q, *turn;      /* p' and gamma' of the piece */
    double *lead;          /* rows: direction of slip that begins */
    impact_walls walls;
    double *stage, *start; /* 12 stages of rows + contacts + 2; one more */
    double *kept;          /* rows */
    double tau, way_sign;
    double pace;   /* rate of the clock in a step */
    double patience; /* factor on slip that turns and counts as stopped: 1, more once a piece has
                        taken all its steps */
    double energy; /* of the rates before, at each row alone; the largest */
    int by_law;    /* whether the piece asks for the law at every stage: a slip begins slowly beside
                      slip that turns */
    int all_rise; /* whether walls that wait rise as well */
    int by_path; /* whether its step runs along impulses, since walls hardly move: p' is large */
} impact_path;

static inline impact_path sweep_map(hm_impact *x)
{
    const int64_t n = x->rows;
    double *s = x->scratch + CONTACT_SCRATCH(n), *v = s + n * n;
    int32_t *i = (int32_t *)(void *)(v + 17 * n);
    impact_path y = {.x = x,
                     .active.matrix = s,
                     .active.b = v,
                     .active.way = v + n,
                     .active.p = v + 2 * n,
                     .active.rate = v + 3 * n,
                     .active.coefficient = v + 4 * n,
                     .gamma = v + 5 * n,
                     .size = v + 6 * n,
                     .q = v + 7 * n,
                     .turn = v + 8 * n,
                     .lead = v + 9 * n,
                     .walls.speed = v + 10 * n,
                     .walls.retreat = v + 11 * n,
                     .walls.deep = v + 12 * n,
                     .walls.rate = v + 13 * n,
                     .kept = v + 14 * n,
                     .active.first = i,
                     .active.tangents = i + n,
                     .active.slides = i + 2 * n,
                     .active.contact = i + 3 * n,
                     .walls.live = i + 4 * n,
                     .walls.on = i + 5 * n,
                     .walls.stuck = i + 6 * n,
                     .walls.waits = i + 7 * n,
                     .start = v + 21 * n,
                     .stage = v + 24 * n};
    y.rates = (contact_problem){.first = y.active.first,
                                .tangents = y.active.tangents,
                                .coefficient = y.active.coefficient,
                                .slides = y.active.slides,
                                .way = y.active.way,
                                .W = y.active.matrix,
                                .b = y.active.b,
                                .p = y.active.p,
                                .rate = y.active.rate,
                                .scratch = x->scratch};
    return y;
}

static inline int32_t impact_slips(const hm_impact *x, int32_t i)
{ return x->coefficient[i] > 0.0 ? x->tangents[i] : 0; }

/* Whether contact i is a joint that rubs. */
static inline int is_joint(const hm_impact *x, int32_t i)
{ return x->joints.forces > 0 && x->joints.end[i] > x->joints.begin[i]; }

static inline double impact_weight(const hm_impact *x, int32_t i)
{
    const int64_t k = x->first[i];
    return x->W[k * x->rows + k];
}

/* a (rows) = W p */
HM_SELDOM static void rates_of_impulses(const hm_impact *x, const double *p, double *a)
{
    for (int32_t k = 0; k < x->rows; k++) {
        double sum = 0.0;
        for (int32_t j = 0; j < x->rows; j++) sum += x->W[(int64_t)k * x->rows + j] * p[j];
        a[k] = sum;
    }
    for (int32_t i = 0; i < x->contacts; i++)
        if (is_joint(x, i)) a[x->first[i]] = 0.0;
}

/* What counts as no rate in row k. */
static inline double none_of_row(const impact_path *s, int32_t k)
{ return SWEEP_ROUND_OFF * s->size[k]; }

static inline double none_of_slip(const impact_path *s, int32_t i)
{
    double largest = 0.0;
    for (int32_t t = s->x->first[i] + 1; t <= s->x->first[i] + s->x->tangents[i]; t++)
        largest = fmax(largest, s->size[t]);
    return largest
           * (s->x->tangents[i] > 1 ? fmin(2.0 * SWEEP_STOPS * s->patience, SLOW_SLIP)
                                    : SWEEP_ROUND_OFF);
}

static inline double slip_now(const impact_path *s, int32_t i)
{ return hm_length(s->x->tangents[i], s->gamma + s->x->first[i] + 1); }

/* Equations p_N = d . P of the joints, with the directions d of the impulses P that p brings about.
   Returns the largest |p_N - |P|| over the largest |P|. */
HM_SELDOM static double press_joints(const hm_impact *x, const double *p)
{
    double error = 0.0, largest = 0.0;
    for (int32_t i = 0; i < x->contacts; i++) {
        if (!is_joint(x, i)) continue;
        const int64_t k = x->first[i], n = x->rows;
        double *line = x->W + k * n, pressed = 0.0;
        const double slip = x->tangents[i] ? x->W[(k + 1) * n + k + 1] : 0.0,
                     scale = slip > 0.0 ? slip : 1.0;
        memset(line, 0, sizeof(double) * (size_t)n);
        for (int32_t at = x->joints.begin[i]; at < x->joints.end[i];) {
            const int32_t begin = at;
            double sum = 0.0;
            do {
                double impulse = 0.0;
                for (int32_t r = 0; r < n; r++)
                    impulse += p[r] * x->joints.force[(int64_t)r * x->joints.forces + at];
                sum += hm_square(impulse);
                at++;
            } while (at < x->joints.end[i] && x->joints.continues[at]);
            const double root = sqrt(sum);
            pressed += root;
            for (int32_t f = begin; f < at && root > 0.0; f++) {
                double impulse = 0.0;
                for (int32_t r = 0; r < n; r++)
                    impulse += p[r] * x->joints.force[(int64_t)r * x->joints.forces + f];
                for (int32_t r = 0; r < n; r++)
                    line[r] -=
                        scale * impulse / root * x->joints.force[(int64_t)r * x->joints.forces + f];
            }
        }
        line[k] += scale;
        error = fmax(error, fabs(p[k] - pressed));
        largest = fmax(largest, pressed);
    }
    return largest > 0.0 ? error / largest : 0.0;
}

/* Rates at which the walls move: that of contact i, with advancing (1) or retreating (-1) walls. */
static inline double wall_rate(const impact_path *s, int32_t i, int is_active)
{
    if (s->way_sign > 0.0)
        return s->walls.live[i]                                          ? s->walls.speed[i]
               : s->walls.deep[i] > 0.0 && (s->all_rise || !s->walls.waits[i]) ? s->walls.retreat[i]
                                                                   : 0.0;
    return s->walls.live[i] ? -s->walls.speed[i] : is_active ? -s->walls.retreat[i] : 0.0;
}

static inline double wall_now(const impact_path *s, int32_t i)
{ return s->walls.live[i] ? s->tau * s->walls.speed[i] : -s->walls.deep[i]; }

static inline int is_active(const impact_path *s, int32_t i)
{
    const int32_t k = s->x->first[i];
    return impact_weight(s->x, i) > 0.0 && s->gamma[k] <= wall_now(s, i) + none_of_row(s, k);
}

/* Lays out the problem of the rates for the contacts that are active. Slip of `slow` of its terms
   counts as none. */
HM_SELDOM static void pack_rates(impact_path *s, double slow)
{
    const hm_impact *x = s->x;
    contact_problem *y = &s->rates;
    y->contacts = y->rows = 0;
    for (int32_t i = 0; i < x->contacts; i++) {
        if (s->by_law ? s->walls.on[i] == IDLE : !is_active(s, i)) continue;
        const int32_t c = y->contacts++, k = x->first[i], n = impact_slips(x, i);
        const double slip = n ? slip_now(s, i) : 0.0;
        s->active.contact[c] = i;
        s->active.first[c] = y->rows, s->active.tangents[c] = n,
        s->active.coefficient[c] = x->coefficient[i];
        s->active.slides[c] = n && !s->walls.stuck[i] && slip > slow * s->size[k + 1];
        s->active.b[y->rows] = s->by_law ? -s->walls.rate[i] : -wall_rate(s, i, 1);
        for (int32_t a = 1; a <= n; a++) {
            s->active.b[y->rows + a] = 0.0;
            s->active.way[y->rows + a] = s->active.slides[c] ? s->gamma[k + a] / slip : 0.0;
        }
        y->rows += 1 + n;
    }
    for (int32_t c = 0; c < y->contacts; c++)
        for (int32_t a = 0; a <= s->active.tangents[c]; a++) {
            const double *from = x->W + (int64_t)x->rows * (x->first[s->active.contact[c]] + a);
            double *to = s->active.matrix + (int64_t)y->rows * (s->active.first[c] + a);
            for (int32_t d = 0; d < y->contacts; d++)
                for (int32_t b = 0; b <= s->active.tangents[d]; b++)
                    to[s->active.first[d] + b] = from[x->first[s->active.contact[d]] + b];
        }
}

/* p' (q) of the contacts that are active; 0, or 1 if there is none, or no other than 0 with walls
   that retreat. */
HM_SELDOM static int rates_of_path(impact_path *s, double slow)
{
    hm_impact *x = s->x;
    contact_problem *y = &s->rates;
    int joints = 0, presses = 0, moves = 0;
    for (int32_t i = 0; i < x->contacts; i++) joints |= is_joint(x, i);
    if (joints) press_joints(x, s->q);
    do {
        pack_rates(s, slow);
        for (int32_t k = 0; k < y->rows; k++) moves |= s->active.b[k] != 0.0;
        memset(s->q, 0, sizeof(double) * (size_t)x->rows);
        if (!moves) return 0;
        if (hm_solve_contacts(y, s->way_sign > 0.0 ? LEAST_WORK_IF_ANY : MOST_WORK)) return 1;
        if (!joints) hm_share_impulses(y);
        for (int32_t c = 0; c < y->contacts; c++)
            for (int32_t a = 0; a <= s->active.tangents[c]; a++)
                s->q[x->first[s->active.contact[c]] + a] = s->active.p[s->active.first[c] + a];
    } while (joints && press_joints(x, s->q) > SWEEP_ROUND_OFF && ++presses < MOST_PRESSES);
    if (s->way_sign > 0.0) x->several |= y->several;
    double most = 0.0;
    for (int32_t k = 0; k < y->rows; k++)
        if (s->active.matrix[k * (y->rows + 1)] > 0.0)
            most = fmax(most, hm_square(s->active.b[k]) / s->active.matrix[k * (y->rows + 1)]);
    return s->way_sign < 0.0 && !(work_of_solution(y) > NO_WORK * most);
}

static inline int may_end(const impact_path *s, int32_t i)
{ return s->walls.live[i] || (s->walls.deep[i] > 0.0 && !s->walls.waits[i]); }

/* Contact i ends; one that has not stopped yet stays where it is until its wall can rise. */
static inline void end_contact(impact_path *s, int32_t i)
{
    s->walls.live[i] = 0;
    s->walls.deep[i] = -s->gamma[s->x->first[i]];
    if (!(s->walls.deep[i] > none_of_row(s, s->x->first[i]))) s->walls.deep[i] = 0.0;
    s->walls.waits[i] = s->walls.deep[i] > 0.0;
}

/* Contacts that end where no path goes on: the union of the least sets of them without which there
   are rates. */
HM_SELDOM static void end_unsolvable(impact_path *s)
{
    int32_t count = 0, which[MOST_ENDINGS], out = 0;
    for (int32_t i = 0; i < s->x->contacts; i++)
        if (may_end(s, i) && count++ < MOST_ENDINGS) which[count - 1] = i;
    for (int32_t size = 1; size <= count && count <= MOST_ENDINGS && !out; size++)
        for (int32_t set = 1; set < 1 << count; set++) {
            int32_t bits = 0, was_live[MOST_ENDINGS];
            double was_deep[MOST_ENDINGS];
            for (int32_t k = 0; k < count; k++) bits += set >> k & 1;
            if (bits != size) continue;
            for (int32_t k = 0; k < count; k++) {
                was_live[k] = s->walls.live[which[k]], was_deep[k] = s->walls.deep[which[k]];
                if (set >> k & 1) end_contact(s, which[k]);
            }
            if (!rates_of_path(s, 0.0)) out |= set;
            for (int32_t k = 0; k < count; k++)
                s->walls.live[which[k]] = was_live[k], s->walls.deep[which[k]] = was_deep[k],
                s->walls.waits[which[k]] = 0;
        }
    for (int32_t i = 0, k = 0; i < s->x->contacts; i++)
        if (may_end(s, i) && (count > MOST_ENDINGS || !out || out >> k++ & 1)) end_contact(s, i);
}

/* What is found where there are no rates with which the walls go on. */
enum { NOTHING_HELPS = -1, RATES_FOUND, HAVE_ENDED, GOES_AT_ONCE };

/* Finds the rates, with a remedy where walls cannot go on. */
HM_SELDOM static int find_rates(impact_path *s)
{
    int ends = 0, waits = 0;
    s->way_sign = 1.0;
    for (int32_t i = 0; i < s->x->contacts; i++) waits |= s->walls.waits[i];
    s->all_rise = 1;
    const int none_rise = rates_of_path(s, 0.0);
    for (int32_t i = 0; i < s->x->contacts && !none_rise; i++) s->walls.waits[i] = 0;
    s->all_rise = 0;
    if (!none_rise || (waits && !rates_of_path(s, 0.0))) return RATES_FOUND;
    if (s->tau < 0.0 && s->tau > -LAST_BIT) return GOES_AT_ONCE;
    s->way_sign = -1.0;
    if (!rates_of_path(s, 0.0)) {
        s->x->jam |= JAM_RETREATED;
        return RATES_FOUND;
    }
    s->way_sign = 1.0;
    if (!rates_of_path(s, SLOW_SLIP)) {
        s->x->jam |= JAM_SLOW_STOPPED;
        return RATES_FOUND;
    }
    for (int32_t i = 0; i < s->x->contacts; i++) ends |= may_end(s, i);
    if (!ends) return NOTHING_HELPS;
    s->x->jam |= JAM_ENDED;
    end_unsolvable(s);
    return HAVE_ENDED;
}

#endif
