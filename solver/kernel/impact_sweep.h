/* Impact at a fixed configuration: the energetic sweep. With rates gamma = gamma- + W p, contacts i that approach with v_i
   are held from below by walls that move with a clock tau = -1 ..:

       0 <= p'_N _|_ gamma_N - c_i >= 0,   c_i = tau v_i as long as contact i is live, then 0,
       |p'_T| <= mu p'_N,   p'_T = -mu p'_N gamma_T/|gamma_T| where there is slip.

   Contact i has compressed with C_i = -int p'_N gamma_N over gamma_N < 0, expands with X_i, and is live until X_i = e_i^2 C_i
   (energetic restitution, Stronge 1990; walls after Moreau 1988; increments of friction after Routh 1905). For frictionless
   contacts with one e it is Newton's law; p is in Coulomb's cone, energy never grows, and the loss is
   sum (C_i - X_i) + D with the work D >= 0 of friction.

   The path is straight between events, but where slip turns in space: there a pair of order 8 follows it.

   Jam: strong friction may leave no rates with which the walls go on (Painleve). Then all walls retreat until there are such
   rates; if that does not help, slip of 1e-6 of the speed counts as none; then the least sets of contacts without which there
   are rates end; at last all contacts stop at once, without restitution.                                         */
#ifndef HOLONOM_IMPACT_SWEEP_H
#define HOLONOM_IMPACT_SWEEP_H

#include "contact_solver.h"
#include "runge_kutta_methods.h"

/* Ways out of a jam, as bits. */
enum { JAM_RETREATED = 1, JAM_SLOW_STOPPED = 2, JAM_ENDED = 4, JAM_PLASTIC = 8 };

/* Rows are rates [m/s or rad/s], and impulses of the same contacts [N s or N m s]. A joint that rubs is a contact as well, whose
   p_N is a sum of norms of impulses in its rows; its normal row has no rate. */
typedef struct hm_impact {
    int32_t contacts, rows;
    const int32_t *first, *tangents; /* per contact: its normal row; rows of slip that follow it: 0 to 3          */
    const double *coefficient;       /* per contact, >= 0                                                         */
    const double *restitution;       /* per contact, 0 .. 1                                                       */
    double *W;                       /* rows x rows: G M^-1 G' reduced by the bilateral rows; may be singular. Normal rows
                                        of joints, 0, are overwritten                                             */
    const double *before;            /* rows: gamma-; of a normal row negative where bodies approach              */
    int32_t forces;                  /* impulses in joints                                                        */
    const double *force;             /* rows x forces: of unit impulses                                           */
    const int32_t *force_begin, *force_end; /* per contact: those of a joint; else none                           */
    const int32_t *force_continues;  /* per force: whether it belongs to the norm of the one before               */
    double *impulse, *after;         /* rows, overwritten: p, gamma+                                              */
    double *compression, *expansion; /* per contact, overwritten: C, X [J]                                        */
    double friction, plastic;        /* overwritten: D; what the last way out of a jam takes [J]                  */
    int32_t jam, several, pieces;    /* overwritten: ways out taken; whether rates were not unique; parts of the path */
    int32_t newton;                  /* overwritten: whether Newton's restitution stood in, see hm_solve_impact   */
    double *scratch;                 /* IMPACT_SCRATCH(rows) doubles                                              */
} hm_impact;

#define SWEEP_ROUND_OFF 1e-12  /* of the sum of a row's terms: what counts as none                                */
#define SWEEP_ERROR 1e-13      /* likewise, the error of a part in which slip turns                               */
#define SWEEP_STOPS 5e-12      /* likewise, slip that turns and counts as stopped                                 */
#define SLOW_SLIP 1e-6         /* likewise, in a jam                                                              */
#define BUDGET_SPENT 1e-14     /* of C                                                                            */
#define CONE_LEFT 1e-8         /* of the cone, beyond which a contact that sticks beside slip that turns begins to slide;
                                  more than FITS, so that it is not found to stick at once                        */
#define BEGINS_SLOWLY 1e-3     /* growth of a slip, likewise: its direction then follows from its rate              */
#define HAS_BEGUN 1e-6         /* likewise, slip whose direction counts                                           */
#define LARGE_RATES 30.0       /* of impulses, over those that walls bring about alone                            */
#define CONE_CLIPPED 1e-10     /* of the cone, by which friction of a turning slip may miss it                     */
#define NO_WORK 1e-18          /* of p'.W p', over that of the rates of walls: rates of 0                         */
enum { MOST_PRESSES = 100, MOST_ENDINGS = 10 };

/* Who pushes in a turning piece, and whether it slides, sticks or begins to slide: fixed as long as the piece lasts. */
enum { IDLE, PUSHES_SLIDING, PUSHES_STUCK, PUSHES_BEGINNING };

/* Numbers of a sweep: rows each, those of contacts as many. */
typedef struct impact_path {
    hm_impact *x;
    contact_problem rates; /* of the active contacts                                                               */
    double *matrix;        /* its W                                                                                */
    double *b, *way, *p, *rate, *coefficient; /* likewise                                                          */
    int32_t *first, *tangents, *slides, *active; /* likewise; active: the contact of each                          */
    double *gamma, *size;  /* rates now; sum of the sizes of their terms so far                                    */
    double *q, *turn;      /* p' and gamma' of the piece                                                           */
    double *lead;          /* rows: direction of slip that begins                                                  */
    double *speed, *retreat, *deep, *wall; /* per contact: v; rate of its wall in a jam; how far that is; its rate in the piece */
    double *stage, *start; /* 12 stages of rows + contacts + 2; one more                                           */
    double *kept;          /* rows                                                                                 */
    int32_t *live, *on, *stuck, *begins;
    double tau, way_sign;
    double energy; /* of the rates before, at each row alone; the largest                                          */
    int by_law;  /* whether the piece asks for the law at every stage: a slip begins slowly beside slip that turns  */
    int by_path; /* whether its step runs along impulses, since walls hardly move: p' is large                      */
} impact_path;

static inline impact_path sweep_map(hm_impact *x)
{
    const int64_t n = x->rows;
    double *s = x->scratch + CONTACT_SCRATCH(n), *v = s + n * n;
    int32_t *i = (int32_t *)(void *)(v + 17 * n);
    impact_path y = {.x = x, .matrix = s, .b = v, .way = v + n, .p = v + 2 * n, .rate = v + 3 * n, .coefficient = v + 4 * n,
               .gamma = v + 5 * n, .size = v + 6 * n, .q = v + 7 * n, .turn = v + 8 * n, .lead = v + 9 * n,
               .speed = v + 10 * n, .retreat = v + 11 * n, .deep = v + 12 * n, .wall = v + 13 * n, .kept = v + 14 * n,
               .first = i, .tangents = i + n, .slides = i + 2 * n, .active = i + 3 * n, .live = i + 4 * n, .on = i + 5 * n,
               .stuck = i + 6 * n, .begins = i + 7 * n, .start = v + 21 * n, .stage = v + 24 * n};
    y.rates = (contact_problem){.first = y.first, .tangents = y.tangents, .coefficient = y.coefficient, .slides = y.slides,
                                .way = y.way, .W = y.matrix, .b = y.b, .p = y.p, .rate = y.rate, .scratch = x->scratch};
    return y;
}

static inline int32_t impact_slips(const hm_impact *x, int32_t i) { return x->coefficient[i] > 0.0 ? x->tangents[i] : 0; }

/* Whether contact i is a joint that rubs. */
static inline int is_joint(const hm_impact *x, int32_t i) { return x->forces > 0 && x->force_end[i] > x->force_begin[i]; }

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
static inline double none_of_row(const impact_path *s, int32_t k) { return SWEEP_ROUND_OFF * s->size[k]; }

static inline double none_of_slip(const impact_path *s, int32_t i)
{
    double largest = 0.0;
    for (int32_t t = s->x->first[i] + 1; t <= s->x->first[i] + s->x->tangents[i]; t++) largest = fmax(largest, s->size[t]);
    return largest * (s->x->tangents[i] > 1 ? 2.0 * SWEEP_STOPS : SWEEP_ROUND_OFF);
}

static inline double slip_now(const impact_path *s, int32_t i) { return hm_length(s->x->tangents[i], s->gamma + s->x->first[i] + 1); }

/* Equations p_N = d . P of the joints, with the directions d of the impulses P that p brings about. Returns the largest
   |p_N - |P|| over the largest |P|.                                                                              */
HM_SELDOM static double press_joints(const hm_impact *x, const double *p)
{
    double error = 0.0, largest = 0.0;
    for (int32_t i = 0; i < x->contacts; i++) {
        if (!is_joint(x, i)) continue;
        const int64_t k = x->first[i], n = x->rows;
        double *line = x->W + k * n, pressed = 0.0;
        const double slip = x->tangents[i] ? x->W[(k + 1) * n + k + 1] : 0.0, scale = slip > 0.0 ? slip : 1.0;
        memset(line, 0, sizeof(double) * (size_t)n);
        for (int32_t at = x->force_begin[i]; at < x->force_end[i];) {
            const int32_t begin = at;
            double sum = 0.0;
            do {
                double impulse = 0.0;
                for (int32_t r = 0; r < n; r++) impulse += p[r] * x->force[(int64_t)r * x->forces + at];
                sum += hm_square(impulse);
                at++;
            } while (at < x->force_end[i] && x->force_continues[at]);
            const double root = sqrt(sum);
            pressed += root;
            for (int32_t f = begin; f < at && root > 0.0; f++) {
                double impulse = 0.0;
                for (int32_t r = 0; r < n; r++) impulse += p[r] * x->force[(int64_t)r * x->forces + f];
                for (int32_t r = 0; r < n; r++) line[r] -= scale * impulse / root * x->force[(int64_t)r * x->forces + f];
            }
        }
        line[k] += scale;
        error = fmax(error, fabs(p[k] - pressed));
        largest = fmax(largest, pressed);
    }
    return largest > 0.0 ? error / largest : 0.0;
}

/* ------------------------------------------------------------------------------------ rates of the path */

/* Rates at which the walls move: that of contact i, with advancing (1) or retreating (-1) walls. */
static inline double wall_rate(const impact_path *s, int32_t i, int is_active)
{
    if (s->way_sign > 0.0) return s->live[i] ? s->speed[i] : s->deep[i] > 0.0 ? s->retreat[i] : 0.0;
    return s->live[i] ? -s->speed[i] : is_active ? -s->retreat[i] : 0.0;
}

static inline double wall_now(const impact_path *s, int32_t i) { return s->live[i] ? s->tau * s->speed[i] : -s->deep[i]; }

static inline int is_active(const impact_path *s, int32_t i)
{
    const int32_t k = s->x->first[i];
    return impact_weight(s->x, i) > 0.0 && s->gamma[k] <= wall_now(s, i) + none_of_row(s, k);
}

/* Lays out the problem of the rates for the contacts that are active. Slip of `slow` of its terms counts as none. */
HM_SELDOM static void pack_rates(impact_path *s, double slow)
{
    const hm_impact *x = s->x;
    contact_problem *y = &s->rates;
    y->contacts = y->rows = 0;
    for (int32_t i = 0; i < x->contacts; i++) {
        if (s->by_law ? s->on[i] == IDLE : !is_active(s, i)) continue;
        const int32_t c = y->contacts++, k = x->first[i], n = impact_slips(x, i);
        const double slip = n ? slip_now(s, i) : 0.0;
        s->active[c] = i;
        s->first[c] = y->rows, s->tangents[c] = n, s->coefficient[c] = x->coefficient[i];
        s->slides[c] = n && !s->stuck[i] && slip > slow * s->size[k + 1];
        s->b[y->rows] = s->by_law ? -s->wall[i] : -wall_rate(s, i, 1);
        for (int32_t a = 1; a <= n; a++) {
            s->b[y->rows + a] = 0.0;
            s->way[y->rows + a] = s->slides[c] ? s->gamma[k + a] / slip : 0.0;
        }
        y->rows += 1 + n;
    }
    for (int32_t c = 0; c < y->contacts; c++)
        for (int32_t a = 0; a <= s->tangents[c]; a++) {
            const double *from = x->W + (int64_t)x->rows * (x->first[s->active[c]] + a);
            double *to = s->matrix + (int64_t)y->rows * (s->first[c] + a);
            for (int32_t d = 0; d < y->contacts; d++)
                for (int32_t b = 0; b <= s->tangents[d]; b++) to[s->first[d] + b] = from[x->first[s->active[d]] + b];
        }
}

/* p' (q) of the contacts that are active; 0, or 1 if there is none, or no other than 0 with walls that retreat. */
HM_SELDOM static int rates_of_path(impact_path *s, double slow)
{
    hm_impact *x = s->x;
    contact_problem *y = &s->rates;
    int joints = 0, presses = 0, moves = 0;
    for (int32_t i = 0; i < x->contacts; i++) joints |= is_joint(x, i);
    if (joints) press_joints(x, s->q);
    do {
        pack_rates(s, slow);
        for (int32_t k = 0; k < y->rows; k++) moves |= s->b[k] != 0.0;
        memset(s->q, 0, sizeof(double) * (size_t)x->rows);
        if (!moves) return 0;
        if (hm_solve_contacts(y, s->way_sign > 0.0 ? LEAST_WORK : MOST_WORK)) return 1;
        if (!joints) hm_share_impulses(y);
        for (int32_t c = 0; c < y->contacts; c++)
            for (int32_t a = 0; a <= s->tangents[c]; a++) s->q[x->first[s->active[c]] + a] = s->p[s->first[c] + a];
    } while (joints && press_joints(x, s->q) > SWEEP_ROUND_OFF && ++presses < MOST_PRESSES);
    if (s->way_sign > 0.0) x->several |= y->several;
    double most = 0.0;
    for (int32_t k = 0; k < y->rows; k++)
        if (s->matrix[k * (y->rows + 1)] > 0.0) most = fmax(most, hm_square(s->b[k]) / s->matrix[k * (y->rows + 1)]);
    return s->way_sign < 0.0 && !(work_of_solution(y) > NO_WORK * most);
}

/* Contacts that end where no path goes on: the union of the least sets of live ones without which there are rates. */
HM_SELDOM static void end_unsolvable(impact_path *s)
{
    int32_t count = 0, which[MOST_ENDINGS], out = 0;
    for (int32_t i = 0; i < s->x->contacts; i++)
        if (s->live[i] && count++ < MOST_ENDINGS) which[count - 1] = i;
    for (int32_t size = 1; size <= count && count <= MOST_ENDINGS && !out; size++)
        for (int32_t set = 1; set < 1 << count; set++) {
            int32_t bits = 0;
            for (int32_t k = 0; k < count; k++) bits += set >> k & 1;
            if (bits != size) continue;
            for (int32_t k = 0; k < count; k++) s->live[which[k]] = !(set >> k & 1);
            if (!rates_of_path(s, 0.0)) out |= set;
            for (int32_t k = 0; k < count; k++) s->live[which[k]] = 1;
        }
    for (int32_t i = 0, k = 0; i < s->x->contacts; i++)
        if (s->live[i] && (count > MOST_ENDINGS || !out || out >> k++ & 1)) s->live[i] = 0;
}

/* Finds the rates, with a remedy where walls cannot go on; 0, 1 if contacts have ended instead, or -1 if nothing helps. */
HM_SELDOM static int find_rates(impact_path *s)
{
    int lives = 0;
    s->way_sign = 1.0;
    if (!rates_of_path(s, 0.0)) return 0;
    s->way_sign = -1.0;
    if (!rates_of_path(s, 0.0)) {
        s->x->jam |= JAM_RETREATED;
        return 0;
    }
    s->way_sign = 1.0;
    if (!rates_of_path(s, SLOW_SLIP)) {
        s->x->jam |= JAM_SLOW_STOPPED;
        return 0;
    }
    for (int32_t i = 0; i < s->x->contacts; i++) lives |= s->live[i];
    if (!lives) return -1;
    s->x->jam |= JAM_ENDED;
    end_unsolvable(s);
    return 1;
}

/* --------------------------------------------------------------------------------------- straight pieces */

/* e^2 C - X of contact i */
static inline double budget(const impact_path *s, int32_t i)
{
    return hm_square(s->x->restitution[i]) * s->x->compression[i] - s->x->expansion[i];
}

/* Counts the sizes of the terms of rates over a part h of the piece. */
HM_SELDOM static void grow_sizes(const impact_path *s, double h)
{
    for (int32_t k = 0; k < s->x->rows; k++)
        for (int32_t j = 0; j < s->x->rows; j++) s->size[k] += fabs(s->x->W[(int64_t)k * s->x->rows + j] * h * s->q[j]);
}

/* Whether a slip that is pushed turns. */
HM_SELDOM static int slip_turns(const impact_path *s)
{
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const int32_t k = s->x->first[i], n = impact_slips(s->x, i);
        if (n < 2 || s->stuck[i] || !(s->q[k] > 0.0)) continue;
        const double *u = s->gamma + k + 1, *du = s->turn + k + 1, slip = hm_length(n, u);
        double along = 0.0, across = 0.0, terms = 0.0;
        for (int32_t a = 0; a < n; a++) along += u[a] * du[a] / slip;
        for (int32_t a = 0; a < n; a++) across += hm_square(du[a] - along * u[a] / slip);
        for (int32_t j = 0; j < s->x->rows; j++) terms += fabs(s->x->W[(int64_t)(k + 1) * s->x->rows + j] * s->q[j]);
        if (sqrt(across) > 1e-12 * hm_length(n, du) + 1e-15 * terms) return 1;
    }
    return 0;
}

/* Part of the piece after which the walls are at the ends of their ways: what no piece goes beyond. */
static inline double end_of_walls(const impact_path *s)
{
    double h = s->way_sign * s->tau < 0.0 ? fabs(s->tau) : INFINITY;
    for (int32_t i = 0; i < s->x->contacts; i++)
        if (s->deep[i] > 0.0 && s->wall[i] > 0.0) h = fmin(h, s->deep[i] / s->wall[i]);
    return h;
}

/* Length of a straight piece: until a slip stops, a contact meets its wall, or one has expanded. */
HM_SELDOM static double length_of_straight(const impact_path *s)
{
    const hm_impact *x = s->x;
    double h = end_of_walls(s);
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = impact_slips(x, i);
        if (n && !s->stuck[i] && s->q[k] > 0.0) {
            const double slip = slip_now(s, i);
            double growth = 0.0;
            for (int32_t a = 1; a <= n; a++) growth += s->gamma[k + a] / slip * s->turn[k + a];
            if (growth < 0.0) h = fmin(h, slip / -growth);
        }
        const double gap = s->gamma[k] - wall_now(s, i), nears = s->wall[i] - s->turn[k];
        if (!(s->q[k] > 0.0) && nears > 0.0 && gap > none_of_row(s, k) && impact_weight(x, i) > 0.0) h = fmin(h, gap / nears);
        if (s->live[i] && s->tau >= 0.0 && s->q[k] > 0.0) {
            const double left = budget(s, i), a1 = s->q[k] * s->gamma[k], a2 = 0.5 * s->q[k] * s->turn[k];
            const double square = a1 * a1 + 4.0 * a2 * left, root = square >= 0.0 ? a1 + sqrt(square) : 0.0;
            if (root > 0.0 && left > 0.0) h = fmin(h, 2.0 * left / root);
        }
    }
    return h;
}

/* Books the work of impulses over a part of the path: of contact i along its normal, and of all friction. */
static inline void book_normal(const impact_path *s, int32_t i, double work)
{
    if (is_joint(s->x, i)) return;
    if (work < 0.0) s->x->compression[i] -= work;
    else s->x->expansion[i] += work;
}

/* Moves clock and walls on by a part h of the piece; returns whether a wall is back from its retreat. */
HM_SELDOM static int move_walls(impact_path *s, double h)
{
    int is_back = 0;
    if (h == fabs(s->tau) && s->way_sign * s->tau < 0.0) s->tau = 0.0;
    else s->tau += s->way_sign * h;
    if (fabs(s->tau) < 1e-15) s->tau = 0.0;
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const double way = h * s->wall[i];
        if (s->live[i]) s->deep[i] = 0.0;
        else s->deep[i] -= way;
        if (s->deep[i] > none_of_row(s, s->x->first[i])) continue;
        is_back |= s->deep[i] != 0.0 || (way > 0.0 && !s->live[i]);
        s->deep[i] = 0.0;
    }
    return is_back;
}

HM_SELDOM static void go_straight(impact_path *s, double h)
{
    const hm_impact *x = s->x;
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i];
        book_normal(s, i, h * s->q[k] * (s->gamma[k] + 0.5 * h * s->turn[k]));
        for (int32_t t = k + 1; t <= k + x->tangents[i]; t++)
            s->x->friction -= h * s->q[t] * (s->gamma[t] + 0.5 * h * s->turn[t]);
    }
    grow_sizes(s, h);
    for (int32_t k = 0; k < x->rows; k++) {
        s->gamma[k] += h * s->turn[k];
        x->impulse[k] += h * s->q[k];
    }
    move_walls(s, h);
}

/* ---------------------------------------------------------------------------------------- turning pieces */

HM_SELDOM static void fix_statuses(impact_path *s)
{
    const hm_impact *x = s->x;
    double largest = 0.0;
    s->by_law = s->by_path = 0;
    for (int32_t i = 0; i < x->contacts; i++) largest = fmax(largest, s->q[x->first[i]] * sqrt(impact_weight(x, i)));
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = impact_slips(x, i);
        s->on[i] = s->q[k] * sqrt(impact_weight(x, i)) > 1e-10 * largest ? PUSHES_SLIDING : IDLE;
        if (s->on[i] == IDLE || !n || !s->stuck[i]) continue;
        const double force = hm_length(n, s->q + k + 1);
        double terms = 0.0;
        for (int32_t j = 0; j < x->rows; j++) terms += fabs(x->W[(int64_t)(k + 1) * x->rows + j] * s->q[j]);
        const double growth = hm_length(n, s->turn + k + 1);
        if (force < x->coefficient[i] * s->q[k] * (1.0 - 1e-10) || growth <= 1e-10 * terms) s->on[i] = PUSHES_STUCK;
        else if (growth < BEGINS_SLOWLY * terms) s->on[i] = PUSHES_BEGINNING;
        s->by_law |= s->on[i] == PUSHES_BEGINNING;
        for (int32_t a = 1; a <= n; a++) s->lead[k + a] = force > 0.0 ? -s->q[k + a] / force : 0.0;
    }
}

/* p' (q) at these rates with the statuses of the piece: linear, but for the directions in joints. */
HM_SELDOM static void rates_by_statuses(const impact_path *s, const double *gamma, double *q)
{
    hm_impact *x = s->x;
    const contact_parts parts = contact_map(&s->rates);
    double *direction = s->kept, *A = parts.matrix, *rhs = parts.rhs, *solution = parts.change;
    int joints = 0, presses = 0;
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = impact_slips(x, i);
        const double slip = n ? hm_length(n, gamma + k + 1) : 0.0;
        const int leads = s->stuck[i] && !(slip > none_of_slip(s, i));
        joints |= is_joint(x, i);
        for (int32_t a = 1; a <= n; a++)
            direction[k + a] = s->on[i] != PUSHES_SLIDING ? 0.0 : -x->coefficient[i] * (leads ? s->lead[k + a] : slip > 0.0 ? gamma[k + a] / slip : 0.0);
    }
    do {
        int32_t count = 0;
        for (int32_t i = 0; i < x->contacts; i++)
            if (s->on[i] != IDLE) count += 1 + (s->on[i] == PUSHES_STUCK ? impact_slips(x, i) : 0);
        for (int32_t i = 0, e = 0; i < x->contacts; i++)
            for (int32_t a = 0; s->on[i] != IDLE && a <= (s->on[i] == PUSHES_STUCK ? impact_slips(x, i) : 0); a++, e++) {
                const double *w = x->W + (int64_t)x->rows * (x->first[i] + a), own = w[x->first[i] + a];
                const double scale = own > 0.0 ? 1.0 / sqrt(own) : 0.0;
                rhs[e] = a ? 0.0 : s->wall[i] * scale;
                for (int32_t j = 0, u = 0; j < x->contacts; j++)
                    for (int32_t b = 0; s->on[j] != IDLE && b <= (s->on[j] == PUSHES_STUCK ? impact_slips(x, j) : 0); b++, u++) {
                        const int32_t l = x->first[j] + b;
                        const double weight = x->W[(int64_t)l * x->rows + l];
                        double sum = w[l];
                        for (int32_t t = 1; t <= impact_slips(x, j) && s->on[j] == PUSHES_SLIDING; t++) sum += w[l + t] * direction[l + t];
                        A[e * count + u] = weight > 0.0 ? sum * scale / sqrt(weight) : e == u;
                    }
            }
        if (count == 1) solution[0] = rhs[0] / A[0];
        else hm_least_squares(count, A, rhs, solution, parts.head, parts.order, DEPENDENT_ROWS);
        for (int32_t k = 0; k < x->rows; k++) q[k] = 0.0;
        for (int32_t i = 0, u = 0; i < x->contacts; i++) {
            const int32_t k = x->first[i];
            for (int32_t a = 0; s->on[i] != IDLE && a <= (s->on[i] == PUSHES_STUCK ? impact_slips(x, i) : 0); a++, u++) {
                const double weight = x->W[(int64_t)(k + a) * (x->rows + 1)];
                q[k + a] = weight > 0.0 ? solution[u] / sqrt(weight) : 0.0;
            }
            for (int32_t a = 1; a <= impact_slips(x, i) && s->on[i] == PUSHES_SLIDING; a++) q[k + a] = q[k] * direction[k + a];
        }
    } while (joints && press_joints(x, q) > SWEEP_ROUND_OFF && ++presses < MOST_PRESSES);
}

/* Likewise, by the law: of those who push. */
HM_SELDOM static void rates_by_law(impact_path *s, double *gamma, double *q)
{
    double *const now = s->gamma;
    s->gamma = gamma;
    pack_rates(s, 0.0);
    s->gamma = now;
    for (int32_t k = 0; k < s->x->rows; k++) q[k] = 0.0;
    if (hm_solve_contacts(&s->rates, s->way_sign > 0.0 ? LEAST_WORK : MOST_WORK)) {
        q[0] = NAN; /* no step ends here */
        return;
    }
    hm_share_impulses(&s->rates);
    for (int32_t c = 0; c < s->rates.contacts; c++)
        for (int32_t a = 0; a <= s->tangents[c]; a++) q[s->x->first[s->active[c]] + a] = s->p[s->first[c] + a];
}

/* Size of p', over that of the rates that walls bring about; with the sign of what pushes. */
HM_SELDOM static double size_of_rates(const impact_path *s, const double *q)
{
    double largest = 0.0, walls = 0.0;
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const double root = sqrt(impact_weight(s->x, i)), rate = q[s->x->first[i]] * root;
        if (s->on[i] == IDLE) continue;
        if (!(fabs(rate) <= fabs(largest))) largest = rate;
        walls = fmax(walls, fabs(s->wall[i]) / root);
    }
    return walls > 0.0 ? largest / walls : 0.0;
}

/* p' (q) in the piece. Returns the rate of the clock in the step: 1, or, along impulses, less; below 0 where walls would have to
   retreat.                                                                                                       */
HM_SELDOM static double rates_in_piece(impact_path *s, double *gamma, double *q)
{
    if (s->by_law) rates_by_law(s, gamma, q);
    else rates_by_statuses(s, gamma, q);
    if (!s->by_path) return 1.0;
    const double pace = 1.0 / size_of_rates(s, q);
    for (int32_t k = 0; k < s->x->rows; k++) q[k] *= pace;
    return pace;
}

/* One Runge-Kutta step of length h from the present state: impulses, works along normals and of friction (in `end`, rows +
   contacts + 1) and the way of the clock behind them, rates there (in `gamma`). Returns its error over what is allowed. */
HM_SELDOM static double try_turning(impact_path *s, double h, double *end, double *gamma)
{
    const hm_impact *x = s->x;
    const int32_t n = x->rows + x->contacts + 2;
    const runge_kutta *pair = &EIGHTH_ORDER;
    double *const sums = s->start;
    for (int stage = 0; stage < pair->stages; stage++) {
        double *slope = s->stage + (int64_t)n * stage, friction = 0.0;
        for (int32_t e = 0; e < x->rows; e++) {
            sums[e] = 0.0;
            for (int before = 0; before < stage; before++) sums[e] += pair->part[stage][before] * s->stage[(int64_t)n * before + e];
        }
        rates_of_impulses(x, sums, gamma);
        for (int32_t k = 0; k < x->rows; k++) gamma[k] = s->gamma[k] + h * gamma[k];
        slope[n - 1] = rates_in_piece(s, gamma, slope);
        for (int32_t i = 0; i < x->contacts; i++) {
            const int32_t k = x->first[i];
            slope[x->rows + i] = slope[k] * gamma[k];
            for (int32_t t = k + 1; t <= k + x->tangents[i]; t++) friction += slope[t] * gamma[t];
        }
        slope[n - 2] = friction;
    }
    double five = 0.0, three = 0.0;
    for (int side = 1; side >= 0; side--) {
        for (int32_t e = 0; e < n; e++) {
            sums[e] = 0.0;
            for (int stage = 0; stage < pair->stages; stage++) sums[e] += pair->difference[side][stage] * s->stage[(int64_t)n * stage + e];
        }
        rates_of_impulses(x, sums, gamma);
        for (int32_t k = 0; k < x->rows; k++) {
            const double error = s->size[k] > 0.0 ? h * gamma[k] / (SWEEP_ERROR * s->size[k]) : 0.0;
            if (side) three = fmax(three, fabs(error));
            else five = fmax(five, fabs(error));
        }
        for (int32_t e = x->rows; e < n - 1; e++) { /* works */
            const double error = fabs(h * sums[e]) / (10.0 * SWEEP_ERROR * s->energy);
            if (side) three = fmax(three, error);
            else five = fmax(five, error);
        }
    }
    for (int32_t e = 0; e < n; e++) {
        end[e] = 0.0;
        for (int stage = 0; stage < pair->stages; stage++) end[e] += h * pair->weight[stage] * s->stage[(int64_t)n * stage + e];
    }
    rates_of_impulses(x, end, gamma);
    for (int32_t k = 0; k < x->rows; k++) gamma[k] += s->gamma[k];
    const double both = sqrt(five * five + 0.01 * three * three);
    return both > 0.0 ? five * five / both : 0.0;
}

/* What must stay above 0 in a turning piece, each over its size: of the clock until the walls stand, and of each contact. */
enum { UNTIL_WALLS_STAND = -1, MARGIN_PUSHES, MARGIN_CONE, MARGIN_BUDGET, MARGIN_GAP, MARGINS };

/* The margin `which` (contact times MARGINS + kind) after a step that led to `end` and `gamma`, with p' there in q. */
HM_SELDOM static double margin_in_piece(const impact_path *s, int32_t which, const double *end, const double *gamma, const double *q)
{
    const hm_impact *x = s->x;
    const double way = end[x->rows + x->contacts + 1], rest = end_of_walls(s);
    if (which == UNTIL_WALLS_STAND) return rest < INFINITY ? rest - way : INFINITY;
    const int32_t i = which / MARGINS, k = x->first[i], n = impact_slips(x, i);
    const double size = size_of_rates(s, q);
    switch (which % MARGINS) {
    case MARGIN_PUSHES: return s->on[i] == IDLE ? INFINITY : q[k] * impact_weight(x, i) / (fabs(size) * s->size[k]) - 1e-14;
    case MARGIN_CONE:
        if (s->on[i] == PUSHES_BEGINNING) return 1.0 - hm_length(n, gamma + k + 1) / (HAS_BEGUN * s->size[k + 1]);
        if (s->on[i] != PUSHES_STUCK || !n || s->by_law) return INFINITY;
        return 1.0 + CONE_LEFT - hm_length(n, q + k + 1) / (x->coefficient[i] * q[k]);
    case MARGIN_BUDGET:
        if (s->on[i] == IDLE || !s->live[i] || s->tau < 0.0 || !(x->compression[i] > 0.0)) return INFINITY;
        return (budget(s, i) - end[x->rows + i]) / x->compression[i];
    default:
        if (s->on[i] != IDLE || !(impact_weight(x, i) > 0.0)) return INFINITY;
        return (gamma[k] - wall_now(s, i) - way * s->wall[i]) / s->size[k] + 2.0 * SWEEP_ROUND_OFF;
    }
}

/* The margin that is farthest below 0, or -2. */
HM_SELDOM static int32_t margin_lost(impact_path *s, const double *end, double *gamma)
{
    double least = -1e-15, *q = s->start; /* room for rows */
    int32_t lost = -2;
    rates_in_piece(s, gamma, q);
    for (int32_t which = UNTIL_WALLS_STAND; which < MARGINS * s->x->contacts; which++) {
        const double margin = margin_in_piece(s, which, end, gamma, q);
        if (!(margin >= least)) least = margin, lost = which;
    }
    return lost;
}

/* Longest step that no slip which pushes is likely to stop in: nine tenths of the way, as it slows down now. */
HM_SELDOM static double before_stops(const impact_path *s)
{
    double h = INFINITY;
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const int32_t k = s->x->first[i], n = impact_slips(s->x, i);
        if (s->on[i] != PUSHES_SLIDING || !n || !(slip_now(s, i) > none_of_slip(s, i))) continue;
        const double slip = slip_now(s, i);
        double growth = 0.0;
        for (int32_t a = 1; a <= n; a++) growth += s->gamma[k + a] / slip * s->turn[k + a];
        if (growth < 0.0) h = fmin(h, 0.9 * slip / -growth);
    }
    return h;
}

/* Whether a slip that pushes has stopped, or has turned by more than a step follows. */
HM_SELDOM static int slip_lost(const impact_path *s, const double *gamma)
{
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const int32_t k = s->x->first[i], n = impact_slips(s->x, i);
        if (s->on[i] != PUSHES_SLIDING || !n || !(slip_now(s, i) > none_of_slip(s, i))) continue;
        double along = 0.0;
        for (int32_t a = 1; a <= n; a++) along += s->gamma[k + a] * gamma[k + a];
        if (!(along > 0.5 * slip_now(s, i) * hm_length(n, gamma + k + 1))) return 1;
    }
    return 0;
}

static inline int slip_stops(const impact_path *s)
{
    for (int32_t i = 0; i < s->x->contacts; i++)
        if (impact_slips(s->x, i) && s->on[i] == PUSHES_SLIDING && !s->stuck[i] && slip_now(s, i) <= none_of_slip(s, i)) return 1;
    return 0;
}

enum { MOST_TURNING_STEPS = 5000, MOST_SEARCHES = 60 };

/* Shortens a step of length h to where the first margin vanishes (regula falsi); `lost` is one of those that are below 0 behind it. */
HM_SELDOM static double end_of_piece(impact_path *s, int32_t lost, double h, double *end, double *gamma)
{
    const int32_t n = s->x->rows + s->x->contacts + 2;
    double *q = s->start;
    for (int32_t turn = 0; turn <= s->x->contacts && lost > -2; turn++, lost = margin_lost(s, end, gamma)) {
        double low = 0.0, high = h;
        rates_in_piece(s, gamma, q);
        double at_high = margin_in_piece(s, lost, end, gamma, q);
        memset(end, 0, sizeof(double) * (size_t)n);
        rates_in_piece(s, s->gamma, q);
        double at_low = fmax(margin_in_piece(s, lost, end, s->gamma, q), 1e-15);
        for (int search = 0, side = 0; search < MOST_SEARCHES && high - low > 1e-15 * high; search++) {
            h = low + (high - low) * fmin(fmax(at_low / (at_low - at_high), 1e-9), 1.0 - 1e-9);
            try_turning(s, h, end, gamma);
            rates_in_piece(s, gamma, q);
            const double margin = margin_in_piece(s, lost, end, gamma, q);
            if (fabs(margin) <= 1e-15) break;
            if (margin > 0.0) {
                low = h, at_low = margin;
                if (side > 0) at_high *= 0.5;
                side = 1;
            } else {
                high = h, at_high = margin;
                if (side < 0) at_low *= 0.5;
                side = -1;
            }
        }
    }
    return h;
}

/* Follows a turning piece until an event; 0, or 1 if it does not get on. */
HM_SELDOM static int go_round(impact_path *s)
{
    hm_impact *x = s->x;
    const int32_t n = x->rows + x->contacts + 2;
    double *end = s->stage + 12 * (int64_t)n, *gamma = end + n, h = 0.1, done = 0.0;
    fix_statuses(s);
    for (int step = 0; step < MOST_TURNING_STEPS; step++) {
        s->by_path = 0;
        rates_in_piece(s, s->gamma, s->q);
        const double size = size_of_rates(s, s->q);
        if (size > LARGE_RATES) {
            s->by_path = 1;
            rates_in_piece(s, s->gamma, s->q);
        }
        rates_of_impulses(x, s->q, s->turn);
        if (done > 0.0 && (slip_stops(s) || !slip_turns(s))) break;
        const double rest = end_of_walls(s), unit = s->by_path ? 1.0 / size : 1.0; /* h is by the clock */
        h = fmin(fmin(h, rest), before_stops(s) * unit);
        if (!(h > 1e-16 * unit)) break;
        const double error = try_turning(s, h / unit, end, gamma);
        if (!(error <= 1.0) || slip_lost(s, gamma)) {
            h *= error > 1.0 && error < INFINITY ? fmax(0.2, 0.9 * hm_pow(error, -0.125)) : 0.25;
            continue;
        }
        const int32_t lost = margin_lost(s, end, gamma);
        if (lost > -2) end_of_piece(s, lost, h / unit, end, gamma);
        const double way = end[n - 1], pace = rates_in_piece(s, gamma, s->start);
        memcpy(s->q, end, sizeof(double) * (size_t)x->rows);
        grow_sizes(s, 1.0);
        for (int32_t i = 0; i < x->contacts; i++) book_normal(s, i, end[x->rows + i]);
        x->friction -= end[n - 2];
        for (int32_t k = 0; k < x->rows; k++) x->impulse[k] += end[k];
        memcpy(s->gamma, gamma, sizeof(double) * (size_t)x->rows);
        const int at_rest = fabs(rest - way) <= 1e-14;
        const int is_back = move_walls(s, at_rest ? rest : way);
        done += h;
        if (lost > -2 || at_rest || is_back || !(pace > 0.0)) break;
        h *= fmin(6.0, 0.9 * hm_pow(fmax(error, 1e-10), -0.125));
    }
    s->by_law = 0;
    return !(done > 0.0);
}

/* --------------------------------------------------------------------------------------------- the impact_path */

/* Where no path goes on: all contacts stop at once, without restitution; that never gives energy. */
HM_SELDOM static int stop_at_once(impact_path *s)
{
    hm_impact *x = s->x;
    contact_problem all = {.contacts = x->contacts, .rows = x->rows, .first = x->first, .tangents = x->tangents, .coefficient = x->coefficient,
                           .slides = s->slides, .way = s->way, .W = x->W, .b = s->gamma, .p = s->p, .rate = s->rate, .scratch = x->scratch};
    for (int32_t i = 0; i < x->contacts; i++) s->slides[i] = 0;
    int presses = 0;
    memset(s->p, 0, sizeof(double) * (size_t)x->rows);
    press_joints(x, s->p);
    do {
        if (hm_solve_contacts(&all, LEAST_WORK)) return 1;
    } while (press_joints(x, s->p) > SWEEP_ROUND_OFF && ++presses < MOST_PRESSES);
    x->jam |= JAM_PLASTIC;
    for (int32_t k = 0; k < x->rows; k++) {
        x->impulse[k] += s->p[k];
        x->plastic -= 0.5 * s->p[k] * (s->gamma[k] + s->rate[k]);
    }
    return 0;
}

/* Starts the sweep; returns whether a contact approaches. */
HM_SELDOM static int begin_sweep(impact_path *s)
{
    hm_impact *x = s->x;
    double fastest = 0.0;
    int approaches = 0;
    x->friction = x->plastic = 0.0;
    x->jam = x->several = x->pieces = x->newton = 0;
    for (int32_t k = 0; k < x->rows; k++) s->gamma[k] = x->before[k], x->impulse[k] = s->q[k] = s->turn[k] = 0.0;
    press_joints(x, s->q);
    for (int32_t i = 0; i < x->contacts; i++)
        if (impact_weight(x, i) > 0.0) fastest = fmax(fastest, -x->before[x->first[i]] / sqrt(impact_weight(x, i)));
    for (int32_t i = 0; i < x->contacts; i++) {
        const double root = sqrt(impact_weight(x, i));
        x->compression[i] = x->expansion[i] = s->deep[i] = s->wall[i] = 0.0;
        s->speed[i] = fmax(0.0, -x->before[x->first[i]]);
        if (!(s->speed[i] > SWEEP_ROUND_OFF * fastest * root)) s->speed[i] = 0.0;
        s->live[i] = s->speed[i] > 0.0;
        s->stuck[i] = 0;
        s->retreat[i] = is_joint(x, i) ? 0.0 : s->live[i] ? s->speed[i] : fastest * root;
        approaches |= s->live[i];
        for (int32_t k = x->first[i]; k <= x->first[i] + x->tangents[i]; k++)
            s->size[k] = fmax(fabs(x->before[k]), fastest * sqrt(fmax(x->W[(int64_t)k * (x->rows + 1)], 0.0)));
    }
    s->tau = -1.0;
    s->energy = 0.0;
    for (int32_t k = 0; k < x->rows; k++)
        if (x->W[(int64_t)k * (x->rows + 1)] > 0.0) s->energy = fmax(s->energy, hm_square(s->size[k]) / x->W[(int64_t)k * (x->rows + 1)]);
    s->by_law = s->by_path = 0;
    return approaches;
}

/* One piece of the path; 0, or 1 at its end, or -1 if it does not get on. */
HM_SELDOM static int sweep_on(impact_path *s)
{
    hm_impact *x = s->x;
    int goes_on = 0;
    for (int32_t i = 0; i < x->contacts; i++) {
        if (s->live[i] && s->tau >= 0.0 && budget(s, i) <= BUDGET_SPENT * (x->tangents[i] > 1 ? 10.0 : 1.0) * x->compression[i]) s->live[i] = 0;
        goes_on |= s->live[i] || s->deep[i] > 0.0;
        if (!impact_slips(x, i)) continue;
        s->stuck[i] = slip_now(s, i) <= none_of_slip(s, i);
        for (int32_t a = 1; a <= x->tangents[i] && s->stuck[i]; a++) s->gamma[x->first[i] + a] = 0.0;
    }
    if (!goes_on) return 1;
    const int found = find_rates(s);
    if (found) return found > 0 ? 0 : -1;
    x->pieces++;
    for (int32_t i = 0; i < x->contacts; i++) s->wall[i] = wall_rate(s, i, is_active(s, i));
    rates_of_impulses(x, s->q, s->turn);
    if (slip_turns(s)) return -go_round(s);
    const double h = length_of_straight(s);
    if (!(h < INFINITY)) return -1;
    go_straight(s, h);
    return 0;
}

/* The sweep; 0, or 1 if no impulses were found. */
HM_SELDOM static int sweep_impact(hm_impact *x)
{
    impact_path s = sweep_map(x);
    int end = !begin_sweep(&s);
    for (int32_t turn = 0; !end && turn < 60 * (x->contacts + 1); turn++) end = sweep_on(&s);
    if (end <= 0 && stop_at_once(&s)) return 1;
    for (int32_t i = 0; i < x->contacts; i++) { /* what the Runge-Kutta pair leaves beyond the cone */
        double *p = x->impulse + x->first[i];
        const int32_t n = x->tangents[i];
        const double cone = x->coefficient[i] * p[0], size = n ? hm_length(n, p + 1) : 0.0;
        for (int32_t a = 1; a <= n && size > cone && size <= cone * (1.0 + CONE_CLIPPED); a++) p[a] *= cone / size;
    }
    rates_of_impulses(x, x->impulse, x->after);
    int is_finite = 1;
    for (int32_t k = 0; k < x->rows; k++) is_finite &= fabs(x->after[k] += x->before[k]) < INFINITY;
    return !is_finite;
}

/* Newton's law at once, 0 <= p_N _|_ gamma_N+ + part e gamma_N- >= 0 with friction against the slip at the end; returns its loss,
   or NAN if no impulses were found.                                                                              */
HM_SELDOM static double newton_impact(impact_path *s, double part)
{
    hm_impact *x = s->x;
    contact_problem all = {.contacts = x->contacts, .rows = x->rows, .first = x->first, .tangents = x->tangents, .coefficient = x->coefficient,
                           .slides = s->slides, .way = s->way, .W = x->W, .b = s->gamma, .p = x->impulse, .rate = x->after, .scratch = x->scratch};
    double loss = 0.0;
    memcpy(s->gamma, x->before, sizeof(double) * (size_t)x->rows);
    for (int32_t i = 0; i < x->contacts; i++) {
        s->slides[i] = 0;
        s->gamma[x->first[i]] += part * x->restitution[i] * fmin(x->before[x->first[i]], 0.0);
    }
    int presses = 0;
    memset(x->impulse, 0, sizeof(double) * (size_t)x->rows);
    press_joints(x, x->impulse);
    do {
        if (hm_solve_contacts(&all, LEAST_WORK)) return NAN;
    } while (press_joints(x, x->impulse) > SWEEP_ROUND_OFF && ++presses < MOST_PRESSES);
    rates_of_impulses(x, x->impulse, x->after);
    for (int32_t k = 0; k < x->rows; k++) {
        x->after[k] += x->before[k];
        loss -= 0.5 * x->impulse[k] * (x->before[k] + x->after[k]);
    }
    return loss;
}

enum { NEWTON_PARTS = 16, NEWTON_HALVINGS = 50 };

/* In place of a sweep that finds no path: Newton's law, with all e times the largest part of them at which no energy arises. */
HM_SELDOM static int newton_instead(hm_impact *x)
{
    impact_path s = sweep_map(x);
    double low = 0.0, high = 1.0;
    x->friction = x->plastic = 0.0;
    x->jam = x->several = x->pieces = 0, x->newton = 1;
    for (int32_t i = 0; i < x->contacts; i++) x->compression[i] = x->expansion[i] = 0.0;
    if (newton_impact(&s, 1.0) >= 0.0) return 0;
    for (int part = NEWTON_PARTS - 1; part > 0 && low == 0.0; part--)
        if (newton_impact(&s, (double)part / NEWTON_PARTS) >= 0.0) low = (double)part / NEWTON_PARTS, high = low + 1.0 / NEWTON_PARTS;
    for (int halving = 0; halving < NEWTON_HALVINGS && low > 0.0; halving++) {
        if (newton_impact(&s, 0.5 * (low + high)) >= 0.0) low = 0.5 * (low + high);
        else high = 0.5 * (low + high);
    }
    return !(newton_impact(&s, low) >= 0.0);
}

/* Solves one impact; returns 0, or 1 if no impulses were found: those left behind then mean nothing. */
HM_SELDOM static int hm_solve_impact(hm_impact *x)
{
    for (int32_t i = 0; i < x->contacts; i++)
        if (!is_joint(x, i) && !(impact_weight(x, i) > 0.0) && x->before[x->first[i]] < 0.0) return 1; /* what moves it is held */
    return sweep_impact(x) && newton_instead(x);
}

#endif
