/* What the functions of a call share: the model, its numbers, state and scratch, and the islands
   that are at hand, for DIM coordinates a node. */
#ifndef HOLONOM_CONTEXT_H
#define HOLONOM_CONTEXT_H

#include "chosen_steps.h"
#include "vectors.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* Compositions of pairs, weighted covers by pairs (extrapolation.h), explicit steps
   (runge_kutta.h), or none of them. */
enum method_kind { COMPOSED, COVERED, EXPLICIT, UNTAKEN };

/* How an internal step was taken, and what it tells of its error. */
typedef struct step_result {
    enum method_kind method;
    int finest;               /* pairs of a cover whose weighted end was not taken; else 0 */
    double difference; /* of an explicit step from one of lower order, relative to size and speed */
    double free_part;         /* of it, that rows leave free */
    double energy_correction; /* change of velocities that brought energy onto the ledger, relative
                                 to speed */
    double growth;            /* of its error by the motion to come, see flight.h */
    double longest_put_back;  /* next explicit step, by the difference of this one [s] */
    double shorter;           /* length of the next try over that of a step that failed */
} step_result;

/* Pairs of increments and what they changed, at length h with these factors, and whether the last
   ones are known; see secants.h. */
typedef struct secant_pairs {
    int32_t count;
    int has_last;
    double h;
    const holonom_elimination *lu;
} secant_pairs;

/* Switches of laws: when the next of the time changes, infinite without one, NaN: not known; the
   time after which one that changes again does not go forth and back without end; when they last
   changed, how often in turn without a pause, and which. */
typedef struct switch_times {
    double next, pause, last;
    int quick;
    int32_t which;
} switch_times;

/* The event at hand: the function that has become 0, or -1; whether event_backup has the start of
   the piece; whether the piece is to be made anew, shorter, since contacts seem to have passed an
   edge, a gap jumped past its zero, or friction gave energy (`cuts`); of contacts at rest whether
   forces as half steps tell them are outside the cones, whether functions are those of what sticks
   together, and whether these hold no longer. */
typedef struct event_at_hand {
    int32_t function;
    int divided, cuts, outside, together, gives_way;
} event_at_hand;

/* Factors: of the tangent at hand, all of it or lean ones; whether rows determine all multipliers
   well by them, and whether rows may depend on each other by the forces evaluated last. Kept ones
   are those of the internal step at hand: of which length of a half step (0: none are), and
   increments of the last one that made its own. */
typedef struct factors_at_hand {
    const holonom_elimination *lu;
    int firm, may_share;
    double kept_h;
    const holonom_elimination *kept_lu;
    int kept_increments;
} factors_at_hand;

typedef struct span {
    int32_t begin, end;
} span;

/* What is near, see far_contacts.h: contacts, frictions, composites that are rows, forms and
   quantities of these. */
enum near_list { NEAR_CONTACTS, NEAR_FRICTIONS, NEAR_ROWS, NEAR_LINKED, NEAR_ACTIVE, NEAR_LISTS };

/* Which islands an internal step moves: all, or those that take covers, or the others, see
   divided_step. */
enum chosen_islands { ALL_ISLANDS, COVERED_ISLANDS, COMPOSED_ISLANDS };

/* The islands at hand, one or all: the first and the one behind the last, where they begin and end
   by columns, the scalars of the first, their moving nodes (driven ones belong to the last island),
   and pieces that need not lie side by side: rows (form rows, coincidences, functions, velocity
   rows) and composites. */
typedef struct island_view {
    enum chosen_islands chosen;
    int32_t first, last;
    const int32_t *begin, *end;
    double *scalars;
    span node, all_row[4], all_composite[4];
    const span *row, *composite;
    int rows, composites, all_rows, all_composites;
    int left_out;        /* whether rows that are off are not among these pieces, see row_state.h */
    int asleep; /* whether all contacts and frictions of these islands are off, in a step */
    int may_fall_asleep; /* whether a contact that is awake is far enough, see far_contacts.h */
    const int32_t *near[NEAR_LISTS]; /* of each index the first one from it on that is near; NULL:
                                        all are */
} island_view;

/* What is solved for: a half step, or accelerations and multipliers at a state. */
typedef struct step_at_hand {
    int half, halves; /* which half step of an internal one this is, from 0, and of how many */
    /* Of the last half steps in the prediction of this one, see predict.h. */
    double weight[4], parabola[4];
    /* Where between the two ends gradients are taken: 1/2 in a step; 1 where the initial
       configuration is sought, by a step from rest whose forces and constraints act at its end. */
    double theta;
    int at_state;         /* 1: there is no step, and slips are those of the velocities */
    int constraints_only; /* 1: only the rows act */
    int changes_contacts; /* whether contacts change at the ends of half steps, see stepped.h */
    int damped;           /* whether something takes energy out of it, under a tolerance */
    int careful; /* 1: smooth frictions have steeper slopes in the tangent: a step has failed */
    double unsettled;      /* size of the last increment over its length [kg^1/2 m/s]; infinite
                              before the first one */
    int rows_known;        /* whether phi has the rows at the state, from the half step before in
                              this internal one */
    int32_t n_kept_forces; /* times within it of which multipliers are kept, see keep_forces */
    int32_t at_fault;      /* multiplier of the contact that keeps it from being solved or changed
                              last, and 1; or 0; see fault.h */
} step_at_hand;

/* How friction acts in the step at hand: whether one slides, so that multipliers follow cones;
   whether the tangent leaves out how forces of sliding ones turn with the place; whether frictions
   of contacts act at the end of a half step alone, see stepped.h; multipliers at which the cones
   of sliding ones are linearised. */
typedef struct friction_at_hand {
    int slides, soft, is_deferred;
    const double *cone_mu;
} friction_at_hand;

/* What laws read: whether it is the increment that is solved for, see sensors.h; where the
   communication step begins [s], for inputs that move, and whether held inputs have jumped by what
   samples of a smooth course do, see advance.h. */
typedef struct law_inputs {
    int reads;
    double start;
    int are_samples;
} law_inputs;

typedef struct context {
    const holonom_model *m;
    double *number;
    hm_state s;
    hm_work k;
    int64_t state_size;
    int32_t n_moving;
    double tolerance; /* of the run, or 0 for equal steps */
    double h, t;
    holonom_watch *watch; /* who may end the start or the step, or NULL */
    holonom_mesh *mesh;   /* where steps are recorded, or those to repeat, or NULL */
    island_view view;
    step_at_hand step;
    friction_at_hand friction;
    law_inputs laws;
    factors_at_hand factors;
    step_result last; /* of the last internal step */
    secant_pairs secants;
    switch_times switches;
    event_at_hand event;
} context;

/* Whether who waits for the start or the step has asked for its end. */
HM_OFTEN int is_stopped(const context *c)
{
    holonom_watch *w = c->watch;
    if (!w || (w->left -= c->state_size) > 0) return 0;
    if (w->is_stopped) return 1;
    w->left = HOLONOM_WORK_BETWEEN_LOOKS;
    w->is_stopped = w->look();
    if (w->is_stopped) w->left = 0;
    return w->is_stopped;
}

#define IN_ISLAND(c, i, column)                                                                    \
    (int32_t i = (c)->view.begin[column], i##_end = (c)->view.end[column]; i < i##_end; i++)
#define EACH_IN(c, pieces, piece, i)                                                               \
    for (const span *i##_in = (c)->view.piece,                                                     \
                   *i##_last = i##_in + (c)->view.pieces;                                          \
         i##_in < i##_last;                                                                        \
         i##_in++)                                                                                 \
        for (int32_t i = i##_in->begin, i##_end = i##_in->end; i < i##_end; i++)
#define EACH_ROW(c, i) EACH_IN(c, rows, row, i)
#define EACH_FORM_ROW(c, i) for IN_ISLAND(c, i, ISLAND_FORM_ROW)
#define EACH_NODE(c, a)                                                                            \
    for (int32_t a = (c)->view.node.begin, a##_end = (c)->view.node.end; a < a##_end; a++)
#define EACH_COORDINATE(c, k)                                                                      \
    for (int32_t k = DIM * (c)->view.node.begin, k##_end = DIM * (c)->view.node.end; k < k##_end;  \
         k++)
#define EACH_TURN(c, b)                                                                            \
    for (int32_t b = (c)->view.begin[ISLAND_BODY];                                                 \
         has_turns(c) && b < (c)->view.end[ISLAND_BODY]; b++)
#define EACH_COMPOSITE(c, j) EACH_IN(c, composites, composite, j)

/* x (DIM n_moving) becomes 0 at the nodes at hand. */
static inline void clear_nodes(const context *c, double *x)
{
    memset(x + DIM * c->view.node.begin, 0,
           sizeof(double) * (size_t)(DIM * (c->view.node.end - c->view.node.begin)));
}

/* Whether there are bodies, whose turns are the unknowns of their directors. */
static inline int has_turns(const context *c) { return n_bodies(c->m) > 0; }

/* Increments of the unknowns: d, or with turns in the place of those of first directors. */
static inline double *move_of(const context *c) { return has_turns(c) ? c->k.move : c->k.d; }

/* Adds begin .. end - 1 to `count` pieces, to the last one if it ends there. */
HM_OFTEN int add_piece(span *piece, int count, int32_t begin, int32_t end)
{
    if (begin == end) return count;
    if (count && piece[count - 1].end == begin) {
        piece[count - 1].end = end;
        return count;
    }
    piece[count] = (span){begin, end};
    return count + 1;
}

static inline int32_t next_near(const context *c, enum near_list list, int32_t i)
{ return c->view.near[list] ? c->view.near[list][i] : i; }

#define EACH_NEAR(c, list, i, first, last)                                                         \
    for (int32_t i##_end = (last), i = next_near(c, list, first); i < i##_end;                     \
         i = next_near(c, list, i + 1))
#define EACH_CONTACT(c, i) EACH_NEAR(c, NEAR_CONTACTS, i, 0, n_contacts((c)->m))
#define EACH_FRICTION(c, f) EACH_NEAR(c, NEAR_FRICTIONS, f, 0, n_frictions((c)->m))
/* Function rows (k = ISLAND_FUNCTION) or velocity rows (ISLAND_VELOCITY) of the islands at hand. */
#define EACH_ROW_OF_KIND(c, j, k) EACH_NEAR(c, NEAR_ROWS, j, (c)->view.begin[k], (c)->view.end[k])

/* Pieces of rows and composites of an island, or of all behind the last one. */
typedef struct near_slice {
    int32_t row, rows, composite, composites;
} near_slice;

static inline near_slice *slice_of(const context *c, int32_t island)
{ return (near_slice *)(void *)c->k.near_slice + island; }

/* Lets rows that are off be at hand, too, but for those of contacts that are far. */
static inline void take_all_rows(context *c)
{
    c->view.left_out = c->view.asleep = 0;
    if (c->view.near[NEAR_CONTACTS]) {
        const int32_t n = c->m->n_islands, is_one = c->view.last == c->view.first + 1;
        const near_slice *own = slice_of(c, is_one ? c->view.first : n);
        const span *piece = (const span *)(void *)c->k.near_pieces;
        c->view.row = piece + own->row, c->view.composite = piece + own->composite;
        c->view.rows = own->rows, c->view.composites = own->composites;
        return;
    }
    c->view.row = c->view.all_row, c->view.composite = c->view.all_composite;
    c->view.rows = c->view.all_rows, c->view.composites = c->view.all_composites;
}

/* Pieces of rows of the islands at hand that hold always: forms and coincidences; returns their
   number. */
static int bilateral_pieces(const context *c, span *row)
{
    const int rows =
        add_piece(row, 0, c->view.begin[ISLAND_FORM_ROW], c->view.end[ISLAND_FORM_ROW]);
    return add_piece(row, rows, row_of_coincidence(c->m, c->view.begin[ISLAND_COINCIDENCE]),
                     row_of_coincidence(c->m, c->view.end[ISLAND_COINCIDENCE]));
}

/* Lets islands first .. last - 1 be those at hand. */
static void select_islands(context *c, int32_t first, int32_t last)
{
    const holonom_model *m = c->m;
    const int32_t *begin = m->island_begin + ISLAND_COLUMNS * first,
                  *end = m->island_begin + ISLAND_COLUMNS * last;
    const int32_t of_elements = first_function_row(m) - m->n_elements;
    c->view.first = first, c->view.last = last;
    c->view.begin = begin, c->view.end = end;
    c->view.scalars = c->s.islands + I_SIZE * first;
    c->view.node =
        (span){begin[ISLAND_FREE],
               begin[ISLAND_DRIVEN] < end[ISLAND_DRIVEN] ? end[ISLAND_DRIVEN] : end[ISLAND_FREE]};
    c->view.all_composites = 0;
    c->view.all_rows = bilateral_pieces(c, c->view.all_row);
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY; k++)
        c->view.all_rows =
            add_piece(c->view.all_row, c->view.all_rows, of_elements + begin[k],
                      of_elements + end[k]);
    for (int k = ISLAND_ELEMENT; k <= ISLAND_POTENTIAL; k++)
        c->view.all_composites =
            add_piece(c->view.all_composite, c->view.all_composites, begin[k], end[k]);
    take_all_rows(c);
}

/* Lets island i be at hand, or all behind the last one; returns whether there is an island i. An
   only one is at hand always. */
static inline int take_island(context *c, int32_t i)
{
    const int32_t n = c->m->n_islands;
    if (n > 1) select_islands(c, i < n ? i : 0, i < n ? i + 1 : n);
    return i < n;
}

static inline int is_chosen(const context *c, int32_t island)
{
    return c->view.chosen == ALL_ISLANDS
           || (c->k.covered[island] != 0.0) == (c->view.chosen == COVERED_ISLANDS);
}

/* The first one from island i on that is chosen, or the number of islands. */
static inline int32_t next_chosen(const context *c, int32_t i)
{
    while (i < c->m->n_islands && !is_chosen(c, i)) i++;
    return i;
}

/* Chosen islands, one after the other at hand; all are again at the end, which no break may
   skip. */
#define EACH_ISLAND(c, i)                                                                          \
    for (int32_t i = next_chosen(c, 0); take_island(c, i); i = next_chosen(c, i + 1))

/* Likewise, but all together where all are chosen. */
#define EACH_CHOSEN(c, i)                                                                          \
    for (int32_t i = (c)->view.chosen == ALL_ISLANDS ? 0 : next_chosen(c, 0);                      \
         (c)->view.chosen == ALL_ISLANDS ? i == 0 : take_island(c, i); i = next_chosen(c, i + 1))

/* Lean or bare: the last two of a model. */
static inline int is_lean(const context *c) { return c->factors.lu >= &c->m->lean; }

/* Factors without rows of contacts and frictions. */
static inline int is_open(const context *c)
{ return c->factors.lu == &c->m->open || c->factors.lu == &c->m->bare; }

/* Lets all islands be at hand, and the whole tangent. */
static void select_all_islands(context *c)
{
    c->factors.lu = &c->m->full;
    if (c->m->n_islands > 1 || c->view.left_out) select_islands(c, 0, c->m->n_islands);
}

/* Factors of the whole tangent, and lean ones, that serve. */
static inline const holonom_elimination *full_factors(const context *c)
{ return c->view.asleep && c->m->n_open_values ? &c->m->open : &c->m->full; }

static inline const holonom_elimination *lean_factors(const context *c)
{
    return c->view.asleep && c->m->n_bare_values ? &c->m->bare : &c->m->lean;
}

/* Copies the state to a backup, and back. */
HM_CALLED static void keep_state(const context *c, double *backup)
{ memcpy(backup, c->s.head, sizeof(double) * (size_t)c->state_size); }
HM_CALLED static void take_state(context *c, const double *backup)
{ memcpy(c->s.head, backup, sizeof(double) * (size_t)c->state_size); }

/* Length of usual steps: what a tolerance wants may be far from the option step_size. */
static inline double usual_length(const context *c)
{
    const double *head = c->s.head;
    return c->tolerance > 0.0 ? fmin(hm_step_size(head), head[S_WANTED]) : hm_step_size(head);
}

static inline int is_seeking(const context *c) { return c->step.theta != 0.5; }

/* The sections extent, row_scale and row_sigma lie side by side. */
static inline size_t derived_bytes(const holonom_model *m)
{ return sizeof(double) * (size_t)(2 + 2 * m->n_rows); }

/* Lets all contacts be near again. */
static void see_all(context *c)
{
    if (!c->view.near[NEAR_CONTACTS]) return;
    for (int k = 0; k < NEAR_LISTS; k++) c->view.near[k] = NULL;
    select_islands(c, c->view.first, c->view.last);
}

static void open_context(context *c, const holonom_model *m, double *number, double *state,
                         double *work)
{
    c->m = m;
    c->number = number;
    c->state_size = hm_map_state(m, state, &c->s);
    hm_map_work(m, work, &c->k);
    c->t = c->laws.start = c->s.head[S_TIME];
    c->watch = NULL;
    c->mesh = NULL;
    c->tolerance = hm_tolerance(c->s.head);
    c->h = 0.0;
    c->n_moving = m->n_free + m->n_driven;
    c->step.theta = 0.5;
    c->step.half = 0, c->step.halves = 2;
    c->last = (step_result){.method = COMPOSED,
                            .free_part = 1.0,
                            .growth = 1.0,
                            .longest_put_back = INFINITY,
                            .shorter = 0.5};
    c->switches = (switch_times){.next = NAN, .last = -INFINITY};
    if (m->switching) c->k.watched[0] = INFINITY, c->k.watched[1] = -INFINITY;
    c->friction.cone_mu = c->k.mu;
    c->step.constraints_only = c->step.careful = c->step.at_state = c->step.damped =
        c->step.at_fault = c->laws.are_samples = c->friction.slides = c->friction.soft =
            c->factors.may_share = 0;
    c->step.changes_contacts = c->laws.reads = c->step.n_kept_forces =
        c->friction.is_deferred = c->view.may_fall_asleep = c->step.rows_known = 0;
    for (int32_t f = 0; f < n_frictions(m); f++)
        c->friction.slides |= c->s.frictions[F_SIZE * f + F_MODE] == FRICTION_SLIDES;
    for (int k = 0; k < NEAR_LISTS; k++) c->view.near[k] = NULL;
    c->factors.lu = &m->full;
    c->view.chosen = ALL_ISLANDS;
    select_islands(c, 0, m->n_islands);
    c->event = (event_at_hand){0};
    c->factors.kept_lu = c->factors.lu;
    c->factors.kept_h = 0.0;
    c->factors.kept_increments = 0;
    c->secants = (secant_pairs){.lu = c->factors.lu};
    memcpy(number + m->extent_at, c->s.derived, derived_bytes(m));
}

#endif
