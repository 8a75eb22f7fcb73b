/* What the files of the kernel share and nobody else sees. */
#ifndef HOLONOM_INTERNAL_H
#define HOLONOM_INTERNAL_H

#include "elementary.h"
#include "holonom.h"
#include "rounding.h"

#include <float.h>
#include <math.h>

#if DIM != 2 && DIM != 3
#error "-DDIM= must say whether the library is for the plane, 2, or for space, 3"
#endif

/* Functions outside the usual step: they, and what only they call, are compiled for size. And
   functions of every step which the compiler would call rather than copy to where they are needed,
   and which then cost 0.5 to 10 % more. */
#if defined(__clang__)
#define HM_SELDOM __attribute__((cold, minsize))
#elif defined(__GNUC__)
#define HM_SELDOM __attribute__((cold))
#else
#define HM_SELDOM
#endif
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define HM_OFTEN static inline __attribute__((always_inline))
#else
#define HM_OFTEN static inline
#endif

/* Functions that stay calls: in one that is seldom entered GCC would copy by the processor's own
   loop, which takes up to twice as long as a call for states of small mechanisms. */
#if defined(__GNUC__)
#define HM_CALLED __attribute__((noinline))
#else
#define HM_CALLED
#endif

/* Short loops stay loops. GCC makes calls of memset and memcpy of those that clear or copy, which
   costs small mechanisms a tenth of a step, and saves large ones nothing that could be measured.
   Short loops over coordinates are unrolled, which saves up to a tenth; instructions stay in the
   order that leaves most in registers. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-loop-distribute-patterns", "peel-loops", "no-schedule-insns2",       \
                     "align-jumps=1")
/* Nor may it copy and move code for a gain that a step does not show: a twentieth of a library, and
   no instruction more. */
#pragma GCC optimize("align-functions=1", "align-loops=1", "no-tree-pre", "no-gcse",               \
                     "no-tree-vrp", "no-tree-dominator-opts")
#pragma GCC optimize("no-tree-tail-merge", "no-optimize-strlen", "no-inline-functions",            \
                     "ira-region=one")
/* Nor may it put neighbours into vectors where the caller of the compiler does not forbid it: sums
   would round otherwise. */
#pragma GCC optimize("no-tree-vectorize", "no-tree-slp-vectorize")
#endif

/* A library serves models of points and bars (0), with rigid bodies (1), with contacts and
   frictions as well (2), and has nothing that only others need. */
#ifndef HM_SCOPE
#define HM_SCOPE 2
#endif
#define HM_BODIES (HM_SCOPE > 0)
#define HM_CONTACTS (HM_SCOPE > 1)
static inline int32_t n_bodies(const holonom_model *m) { return HM_BODIES ? m->n_bodies : 0; }
static inline int is_unilateral(const holonom_model *m) { return HM_CONTACTS && m->unilateral; }
static inline int32_t n_contacts(const holonom_model *m) { return HM_CONTACTS ? m->n_contacts : 0; }
static inline int32_t n_frictions(const holonom_model *m)
{ return HM_CONTACTS ? m->n_frictions : 0; }

/* Rows are those of forms, of which those that keep directors of bodies orthonormal are the last,
   then those of coincidences, DIM each, then those of functions. */
static inline int32_t first_rigidity_row(const holonom_model *m)
{ return m->n_form_rows - m->n_rigidity_rows; }
static inline int32_t row_of_coincidence(const holonom_model *m, int32_t j)
{ return m->n_form_rows + DIM * j; }
static inline int32_t first_function_row(const holonom_model *m)
{ return row_of_coincidence(m, m->n_coincidences); }

/* What a step leaves out where it can (docs/skips.md), and the places that ask. Always so, but for
   benchmarks/sections/skips.py, which measures what each saves with kernels compiled with
   -DHOLONOM_WITHOUT=<sum of these>. */
enum skip {
    SKIP_STIFFNESS = 1,       /* lean factors: choose_factors */
    SKIP_FACTORISATION = 2,   /* factors kept while they contract: may_keep_factors */
    SKIP_OUTER_ITERATION = 4, /* early Uzawa updates: may_update_early */
    SKIP_OLD_GUESS = 8,       /* predicted half steps: known_misses */
    SKIP_SECOND_LINK = 16,    /* rows |u|^2 - c in one pass: is_square_row */
    SKIP_MEASURED_FORMS = 32, /* links of other forms: links_at_start */
    SKIP_LOW_PENALTY = 64,    /* raised in long chains: follow_contraction */
    SKIP_ISLANDS = 128,       /* each solved by itself: n_apart */
    SKIP_FRESH_FACTORS = 256, /* those of the half step before: take_factors_over */
    SKIP_FAR_CONTACTS = 512   /* that sleep until they might touch: look_far */
};
#ifndef HOLONOM_WITHOUT
#define HOLONOM_WITHOUT 0
#endif
/* Largest of the numbers that islands learn of Newton's contraction. */
#define MOST_LEARNED 1e16

static inline int hm_skips(enum skip what) { return !(HOLONOM_WITHOUT & what); }

void hm_run_tape(const holonom_model *model, double *numbers, int32_t segment);

int32_t hm_lu_factor(const holonom_elimination *lu, int32_t begin, int32_t end,
                     const int32_t *target, double *value);
void hm_lu_solve(const holonom_elimination *lu, int32_t begin, int32_t end, const double *value,
                 double *x);
/* Of factors most of whose stored entries are 0: how many of each pivot are not, in U and L each;
   their columns, where those of all stored ones begin; of each pivot the first that has any, from
   it on and back from it, within what was factorised at once. */
typedef struct live_pivots {
    int32_t *count, *column, *next, *before;
} live_pivots;

int32_t hm_lu_factor_live(const holonom_elimination *lu, int32_t begin, int32_t end,
                          const int32_t *target, double *value, const live_pivots *x);
void hm_lu_solve_live(const holonom_elimination *lu, int32_t begin, int32_t end,
                      const live_pivots *live, const double *value, double *x);

int32_t hm_block_factor(const holonom_elimination *lu, int32_t first, int32_t last, double *value);
void hm_block_solve(const holonom_elimination *lu, int32_t first, int32_t last, const double *value,
                    double *x);

/* Sum with the rounding error kept: (*high + *low) += x to about twice the precision (Dekker 1971,
   Knuth). */
static inline void hm_add(double *high, double *low, double x)
{
    const double a = *high, y = x + *low;
    const double s = a + y, t = s - a;
    *low = (a - (s - t)) + (y - t);
    *high = s;
}

/* (*high + *low) += x, for terms of any size (Knuth 1969). */
static inline void hm_add_exactly(double *high, double *low, double x)
{
    const double s = *high + x, t = s - *high;
    *low += (*high - (s - t)) + (x - t);
    *high = s;
}

/* (*high + *low) += a b to about twice the precision, for terms of any size (Dekker 1971;
   Veltkamp's split rather than fma, which is a call where the processor is not known to have
   it). */
static inline void hm_add_product(double *high, double *low, double a, double b)
{
    const double product = a * b;
    const double a_far = 134217729.0 * a, b_far = 134217729.0 * b; /* 2^27 + 1 */
    const double a_high = a_far - (a_far - a), b_high = b_far - (b_far - b);
    const double a_low = a - a_high, b_low = b - b_high;
    hm_add_exactly(high, low, product);
    *low += ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

static inline double hm_square(double x) { return x * x; }

/* atan2(x, y)/x, whose 0/0 is removable for y > 0, and its derivative with respect to x over x;
   with respect to y it is -1/(x^2 + y^2). */
static inline double hm_angle_over(double x, double y)
{
    const double z2 = x * x / (y * y);
    return y > 0.0 && z2 < 1e-4 ? (1.0 - z2 * (1.0 / 3.0 - z2 * (0.2 - z2 / 7.0))) / y
                                : hm_atan2(x, y) / x;
}

static inline double hm_angle_over_bend(double x, double y, double angle_over)
{
    const double z2 = x * x / (y * y);
    return y > 0.0 && z2 < 1e-4
               ? (-2.0 / 3.0 + z2 * (0.8 - z2 * (6.0 / 7.0 - z2 * 8.0 / 9.0))) / (y * y * y)
               : (y / (x * x + y * y) - angle_over) / (x * x);
}

/* A function of a composite over a step, by the discrete chain rule: each operation has a slope
   that is symmetric in the two ends and exact, f_1 - f_0 = sum slope dx, so that the slopes of the
   whole give a discrete gradient. r0, r1, dr hold the leaves at both ends and their differences on
   entry, all registers on return; adjoint (overwritten) the slopes of the value with respect to
   every register. All as long as leaves + operations; slope thrice that. Returns the register of
   the value. */
int32_t hm_discrete_gradient(const int32_t *operation, int32_t n_leaves, int32_t n_operations,
                             const double *numbers, const hm_registers *r);

/* Value of such a function whose leaves begin the registers x; its first `known` operations have
   their results there. */
double hm_value(const int32_t *operation, int32_t n_leaves, int32_t n_operations, int32_t known,
                const double *numbers, double *x);

/* Likewise its derivatives, with the registers of its value in r0; nothing moves. With respect to
   what only the first `still` operations read they are left incomplete. */
void hm_gradient(const int32_t *operation, int32_t n_leaves, int32_t n_operations, int32_t still,
                 const double *numbers, const hm_registers *r);

/* One operation of the tape, other than those with a table. */
double hm_operate(int32_t code, double a, double b, double c);

/* A number that changes with time: value, rate [1/s], and second derivative [1/s^2]. See jets.c. */
typedef struct hm_jet {
    double value, rate, bend;
} hm_jet;

/* The same operation of jets, one with a table (of one or three), and a segment of the tape. Rates
   and second derivatives of the numbers lie in `jet`, 2 for each; what a segment reads stands still
   after hm_stop_jets. hm_run_jets returns how many operations took for granted that arguments whose
   first two derivatives are 0 stand still. */
hm_jet hm_operate_jet(int32_t code, hm_jet a, hm_jet b, hm_jet c);
hm_jet hm_look_up_jet(int32_t code, const hm_jet *x, const double *first, const double *last);
/* Whether a segment of the tape, as it was last run, has an operation where its slope is infinite
   though its value is finite. */
int hm_may_be_steep(const holonom_model *model, const double *numbers, int32_t segment);
void hm_stop_jets(const holonom_model *model, int32_t segment, double *jet);
int32_t hm_run_jets(const holonom_model *model, double *numbers, int32_t segment, double *jet);

/* Ranges of numbers and of their rates, 4 for each in `bounds`: see ranges.c. What a segment of the
   tape reads has the range of its value after hm_stop_ranges. */
void hm_set_range(double *bounds, int32_t place, double low, double high, double least,
                  double most);
void hm_stop_ranges(const holonom_model *model, const double *numbers, int32_t segment,
                    double *bounds);
void hm_run_ranges(const holonom_model *model, const double *numbers, int32_t segment,
                   double *bounds);

/* Sign that a jet has just after the present: of the first of value, rate and second derivative
   that is not 0. */
static inline double hm_sign_after(hm_jet a)
{
    const double first = a.value != 0.0 ? a.value : a.rate != 0.0 ? a.rate : a.bend;
    return (double)((first > 0.0) - (first < 0.0));
}

/* Whether a jet falls from now on. */
static inline int hm_falls(hm_jet a) { return hm_sign_after((hm_jet){0.0, a.rate, a.bend}) < 0.0; }

/* A spline, or its derivative of that order, 1 or 2, at x; it and its next two derivatives (3,
   overwritten), at a knot those of the piece that x comes to if it `falls` or not; and its slope
   (f(x1) - f(x0))/(x1 - x0), without a difference of values. Its table lies from `first` to `last`,
   one row at least behind its first number; see spline.c. */
double hm_spline(int order, double x, const double *first, const double *last);
void hm_spline_derivatives(int order, double x, int falls, const double *first, const double *last,
                           double *found);
double hm_spline_slope(int order, double x0, double x1, const double *first, const double *last);

/* Bounds (2, overwritten) of a spline, or of its derivative of that order, from x = low to high. */
void hm_spline_range(int order, double low, double high, const double *first, const double *last,
                     double *found);

/* A spline of three coordinates x, or one of its three derivatives; NaN if the table is none. And
   its mean gradient between two places, with sum slope dx the difference of its values; and its jet
   where x moves; see grid.c. */
double hm_grid(int derivative, const double *x, const double *first, const double *last);
hm_jet hm_grid_jet(int derivative, const hm_jet *x, const double *first, const double *last);
void hm_grid_slopes(int derivative, const double *x0, const double *x1, const double *first,
                    const double *last, double *slope);

/* Contacts with meshes alone have grids. */
static inline int reads_grid(int32_t code) { return HM_CONTACTS && code >= T_GRID; }

/* An operation with a table, by its code. */
static inline double hm_look_up(int32_t code, const double *x, const double *first,
                                const double *last)
{
    return reads_grid(code) ? hm_grid(code - T_GRID, x, first, last)
                            : hm_spline(code - T_SPLINE, *x, first, last);
}

/* Largest part of their scale that dependent rows may miss together, see newton.h; of rates also
   over the fastest motion. */
#define LARGEST_CONTRADICTION 1e-12

/* Scratch of contacts and of an impact with so many rows, see contact_map and sweep_map. */
#define CONTACT_SCRATCH(rows) ((int64_t)(rows) * (3 * (int64_t)(rows) + 27))
#define IMPACT_SCRATCH(rows) (CONTACT_SCRATCH(rows) + (int64_t)(rows) * ((int64_t)(rows) + 80))

/* Scratch of the split of that many forces at rest, see contact_split.h: five matrices, and 16
   numbers a force. */
#define SPLIT_SCRATCH(rows) ((int64_t)(rows) * (5 * (int64_t)(rows) + 16))

/* Lays the named vectors over one block; each returns the number of doubles used. */
int64_t hm_size_of_state(const holonom_model *model);
int64_t hm_size_of_work(const holonom_model *model);
int64_t hm_size_of_measured(const holonom_model *model);
int64_t hm_map_state(const holonom_model *model, double *block, hm_state *state);
int64_t hm_map_work(const holonom_model *model, double *block, hm_work *work);
int64_t hm_map_measured(const holonom_model *model, double *block, hm_measured *measured);

#endif
