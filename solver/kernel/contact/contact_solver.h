/* Contacts with Coulomb's friction: impulses p, or rates of impulses or forces, and rates gamma = b
   + W p with

       0 <= p_N _|_ gamma_N >= 0,      |p_T| <= mu p_N,  p_T against gamma_T where that is not 0,

   or, of a contact that slides along d already, p_T = -mu p_N d. One solver for impacts and for
   accelerations:

   1. all contacts push and none begins to slide, if that obeys the law;
   2. few contacts with at most one row of slip each: all choices of who parts, sticks and slides.
   Of several solutions the one of least p.W p counts, which knows neither the order of contacts nor
   units, nor that one of them stands there twice;
   3. else Newton's iteration on the projections of Alart and Curnier 1991, after relaxed sweeps
   over all contacts at once; then with friction that grows from 0.

   Impulses that redundant contacts leave open are those of the least size, |p|^2 weighted with W_NN
   of each contact, among the impulses with these rates: as if all yielded alike
   (hm_share_impulses). */
#ifndef HOLONOM_CONTACT_SOLVER_H
#define HOLONOM_CONTACT_SOLVER_H

#include "least_squares.h"
#include "rest_split.h"

typedef struct contact_problem {
    int32_t contacts, rows;
    const int32_t *first,
        *tangents; /* per contact: its normal row; rows of slip that follow it: 0 to 3 */
    const double *coefficient;       /* per contact: mu >= 0 */
    const int32_t *slides;           /* per contact: whether it slides along `way` */
    const double *way; /* rows: unit vector d at the tangents of a contact that slides */
    const double *W, *b;             /* rows x rows, may be singular; rows */
    double *p, *rate;                /* rows, overwritten: p, gamma */
    double *scratch;                 /* CONTACT_SCRATCH(rows) doubles */
    double least_size; /* weighted rate below which none counts as large: of b that is a small rest
                          of larger terms, else 0 */
    int32_t several;   /* overwritten: whether there are several solutions with different rates */
} contact_problem;

enum solution_wanted {
    LEAST_WORK,
    MOST_WORK,
    LEAST_WORK_IF_ANY
}; /* the last where there may be none: no long search then */

#define SOLVED 1e-12          /* defect over the largest rate that counts as none */
#define FITS 1e-10            /* likewise, of inequalities when choices are tried */
#define DIFFERENT_RATES 1e-7  /* difference of two solutions' rates over the largest one */
#define DEPENDENT_ROWS                                                                             \
    1e-12 /* of a matrix with diagonal 1: a smaller pivot is that of a dependent row */
#define REDUNDANT 1e-10       /* likewise, where it decides whether impulses are shared */
enum {
    MOST_CHOICES_TRIED = 1024,
    MOST_SWEEPS_FIRST = 60,
    MOST_ITERATIONS = 60,
    MOST_IN_SETS = 5,
    SCATTERED_STARTS = 200
};

/* Parts of the scratch; rows each, the matrices rows x rows. */
typedef struct contact_parts {
    double *matrix, *columns, *basis;
    double *weight; /* 1/sqrt of the stiffness of each row: impulses over it, and rates times it,
                       are the root of an energy */
    double *defect, *change, *rhs, *kept, *head; /* head: 3 a row */
    double *mu, *slope;        /* slope: 16 a row */
    int32_t *order, *digit;    /* two a row each */
} contact_parts;

static inline contact_parts contact_map(const contact_problem *x)
{
    const int64_t n = x->rows;
    double *s = x->scratch, *v = s + 3 * n * n;
    return (contact_parts){s,
                           s + n * n,
                           s + 2 * n * n,
                           v,
                           v + n,
                           v + 2 * n,
                           v + 3 * n,
                           v + 4 * n,
                           v + 5 * n,
                           v + 8 * n,
                           v + 9 * n,
                           (int32_t *)(void *)(v + 25 * n),
                           (int32_t *)(void *)(v + 26 * n)};
}

static inline int32_t slips_of(const contact_problem *x, int32_t i)
{ return x->coefficient[i] > 0.0 ? x->tangents[i] : 0; }

/* Whether contact i may stick: it has friction and does not slide yet. */
static inline int may_stick(const contact_problem *x, int32_t i)
{ return slips_of(x, i) > 0 && !x->slides[i]; }

HM_SELDOM static void contact_rates(const contact_problem *x)
{
    for (int32_t k = 0; k < x->rows; k++) {
        double sum = x->b[k];
        for (int32_t j = 0; j < x->rows; j++) sum += x->W[(int64_t)k * x->rows + j] * x->p[j];
        x->rate[k] = sum;
    }
}

/* p . W p */
static inline double work_of_solution(const contact_problem *x)
{
    double sum = 0.0;
    for (int32_t k = 0; k < x->rows; k++) sum += x->p[k] * (x->rate[k] - x->b[k]);
    return sum;
}

/* Weights of rows, and the largest weighted rate without impulses. The tangents of a contact share
   one, so that cones stay round. */
HM_SELDOM static double weigh_rows(const contact_problem *x, const contact_parts *s)
{
    double size = x->least_size;
    for (int32_t i = 0; i < x->contacts; i++) {
        double stiffness = 0.0;
        const int32_t k = x->first[i];
        for (int32_t r = k + 1; r <= k + x->tangents[i]; r++)
            stiffness += x->W[(int64_t)r * x->rows + r];
        for (int32_t r = k; r <= k + x->tangents[i]; r++) {
            const double w = r == k ? x->W[(int64_t)k * x->rows + k] : stiffness;
            s->weight[r] = w > 0.0 ? 1.0 / sqrt(w) : 0.0;
            size = fmax(size, fabs(x->b[r]) * s->weight[r]);
        }
    }
    return size;
}

/* -------------------------------------------------------------------------------------- choices */

/* CHOICE_PUSHES: and sticks where it may. */
enum { CHOICE_PUSHES, CHOICE_PARTS, CHOICE_PLUS, CHOICE_MINUS };

/* Direction of the impulse of contact i in row r by the choice at hand, for a normal impulse of
   1. */
static inline double choice_direction(const contact_problem *x, const contact_parts *s, int32_t i,
                                      int32_t r)
{
    const int32_t k = x->first[i];
    if (r == k) return 1.0;
    if (x->slides[i]) return -x->coefficient[i] * x->way[r];
    return s->digit[i] == CHOICE_PLUS    ? -x->coefficient[i]
           : s->digit[i] == CHOICE_MINUS ? x->coefficient[i]
                                         : 0.0;
}

/* Solves for the impulses of the choice at hand; returns whether they obey the law. */
HM_SELDOM static int choice_fits(const contact_problem *x, const contact_parts *s, double size)
{
    const int32_t n = x->rows;
    int32_t count = 0, *row = s->order + n; /* the row of each equation; order has room for both */
    for (int32_t i = 0; i < x->contacts; i++) {
        if (s->digit[i] == CHOICE_PARTS) continue;
        row[count++] = x->first[i];
        for (int32_t a = 1; a <= slips_of(x, i) && may_stick(x, i) && s->digit[i] == CHOICE_PUSHES;
             a++)
            row[count++] = x->first[i] + a;
    }
    for (int32_t e = 0; e < count; e++) s->rhs[e] = -x->b[row[e]] * s->weight[row[e]];
    for (int32_t i = 0, u = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], free = may_stick(x, i) && s->digit[i] == CHOICE_PUSHES;
        if (s->digit[i] == CHOICE_PARTS) continue;
        for (int32_t e = 0; e < count; e++) {
            const double *w = x->W + (int64_t)row[e] * n;
            double sum = w[k];
            for (int32_t r = k + 1; r <= k + slips_of(x, i) && !free; r++)
                sum += w[r] * choice_direction(x, s, i, r);
            s->matrix[e * count + u] = sum * s->weight[row[e]] * s->weight[k];
        }
        u++;
        for (int32_t a = 1; a <= slips_of(x, i) && free; a++, u++)
            for (int32_t e = 0; e < count; e++)
                s->matrix[e * count + u] =
                    x->W[(int64_t)row[e] * n + k + a] * s->weight[row[e]] * s->weight[k + a];
    }
    hm_least_squares(count, s->matrix, s->rhs, s->change, s->head, s->order, DEPENDENT_ROWS);
    double largest = 0.0;
    for (int32_t k = 0; k < n; k++) x->p[k] = 0.0;
    for (int32_t i = 0, u = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], free = may_stick(x, i) && s->digit[i] == CHOICE_PUSHES;
        if (s->digit[i] == CHOICE_PARTS) continue;
        largest = fmax(largest, fabs(s->change[u]));
        x->p[k] = s->change[u++] * s->weight[k];
        for (int32_t a = 1; a <= slips_of(x, i); a++)
            x->p[k + a] = free ? s->change[u++] * s->weight[k + a]
                               : x->p[k] * choice_direction(x, s, i, k + a);
    }
    contact_rates(x);
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n_t = slips_of(x, i);
        const double cone = x->coefficient[i] * x->p[k], none = FITS * size,
                     rate = x->rate[k] * s->weight[k];
        if (!(x->p[k] >= -FITS * largest * s->weight[k]) || !(rate >= -none)) return 0;
        if (s->digit[i] != CHOICE_PARTS && !(rate <= 10.0 * none)) return 0;
        if (!may_stick(x, i) || s->digit[i] == CHOICE_PARTS) continue;
        if (s->digit[i] == CHOICE_PLUS && !(x->rate[k + 1] * s->weight[k + 1] >= -none)) return 0;
        if (s->digit[i] == CHOICE_MINUS && !(x->rate[k + 1] * s->weight[k + 1] <= none)) return 0;
        if (s->digit[i] != CHOICE_PUSHES) continue;
        if (!(hm_length(n_t, x->p + k + 1) <= cone + FITS * largest * s->weight[k])) return 0;
        if (!(hm_length(n_t, x->rate + k + 1) * s->weight[k + 1] <= 10.0 * none)) return 0;
    }
    return 1;
}

static inline int32_t choices_of(const contact_problem *x, int32_t i)
{ return may_stick(x, i) ? 4 : 2; }

/* Number of all choices, or 0 if there are too many, or slips of several rows among them. */
HM_SELDOM static int32_t count_choices(const contact_problem *x)
{
    int32_t count = 1;
    for (int32_t i = 0; i < x->contacts; i++) {
        if (may_stick(x, i) && x->tangents[i] > 1) return 0;
        count *= choices_of(x, i);
        if (count > MOST_CHOICES_TRIED) return 0;
    }
    return count;
}

static inline int has_friction(const contact_problem *x)
{
    for (int32_t i = 0; i < x->contacts; i++)
        if (slips_of(x, i)) return 1;
    return 0;
}

/* Keeps the solution at hand if it is the first or the better one. */
HM_SELDOM static void keep_solution(contact_problem *x, const contact_parts *s, double size,
                                    int wanted, int *found, double *best)
{
    const double work = work_of_solution(x);
    int differs = 0;
    for (int32_t k = 0; k < x->rows && *found; k++) {
        double rate = x->b[k];
        for (int32_t j = 0; j < x->rows; j++) rate += x->W[(int64_t)k * x->rows + j] * s->kept[j];
        differs |= fabs(rate - x->rate[k]) * s->weight[k] > DIFFERENT_RATES * size;
    }
    x->several |= differs;
    if (*found && !(differs && (wanted != MOST_WORK ? work < *best : work > *best))) return;
    *found = 1, *best = work;
    memcpy(s->kept, x->p, sizeof(double) * (size_t)x->rows);
}

/* Tries all choices; returns whether one fits. */
HM_SELDOM static int try_choices(contact_problem *x, const contact_parts *s, double size,
                                 int32_t count, int wanted)
{
    double best = 0.0;
    int found = 0;
    for (int32_t choice = 0; choice < count; choice++) {
        for (int32_t i = 0, rest = choice; i < x->contacts; rest /= choices_of(x, i), i++)
            s->digit[i] = rest % choices_of(x, i);
        if (!choice_fits(x, s, size)) continue;
        keep_solution(x, s, size, wanted, &found, &best);
    }
    if (found) memcpy(x->p, s->kept, sizeof(double) * (size_t)x->rows);
    return found;
}

/* --------------------------------------------------------------------------- Newton's iteration */

/* Distance (defect) of p from its projection; the largest of it, over the size of rates. With
   `jacobian` its derivatives in weighted rows and columns. */
HM_SELDOM static double project(const contact_problem *x, const contact_parts *s, double *jacobian)
{
    const int64_t m = x->rows;
    double largest = 0.0;
    contact_rates(x);
    for (int64_t e = 0; jacobian && e < m * m; e++) jacobian[e] = 0.0;
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = x->tangents[i];
        const double w = s->weight[k], mu = s->mu[i];
        const double normal = x->p[k] - x->rate[k] * w * w,
                     pushed = w > 0.0 ? fmax(normal, 0.0) : 0.0;
        s->defect[k] = x->p[k] - pushed;
        if (jacobian) {
            jacobian[k * m + k] = 1.0;
            for (int32_t j = 0; j < m && pushed > 0.0; j++)
                jacobian[k * m + j] =
                    x->W[k * m + j] * w * (s->weight[j] > 0.0 ? s->weight[j] : 1.0);
        }
        double pull[3], u[3] = {0.0, 0.0, 0.0};
        const double v = n ? s->weight[k + 1] : 0.0, held = mu * pushed;
        for (int32_t a = 0; a < n; a++) pull[a] = x->p[k + 1 + a] - x->rate[k + 1 + a] * v * v;
        const double length = n ? hm_length(n, pull) : 0.0;
        const int sticks = length <= held;
        for (int32_t a = 0; a < n; a++) {
            const int32_t t = k + 1 + a;
            u[a] = length > 0.0 ? pull[a] / length : 0.0;
            if (x->slides[i] || !(v > 0.0))
                s->defect[t] = x->p[t] + (v > 0.0 ? mu * x->p[k] * x->way[t] : 0.0);
            else s->defect[t] = x->p[t] - (sticks ? pull[a] : held * u[a]);
        }
        for (int32_t a = 0; a < n && jacobian; a++) {
            const int32_t t = k + 1 + a;
            double *row = jacobian + t * m;
            row[t] = 1.0;
            if (!(v > 0.0)) continue;
            if (x->slides[i]) {
                row[k] += mu * x->way[t] * w / v;
                continue;
            }
            const double part = sticks ? 1.0 : length > 0.0 ? held / length : 0.0;
            for (int32_t j = 0; j < m;
                 j++) { /* - d(projection)/dp, by way of the pull and of the cone */
                const double weight_j = s->weight[j] > 0.0 ? s->weight[j] : 1.0;
                double along = 0.0;
                for (int32_t c = 0; c < n && !sticks; c++)
                    along += u[c] * ((j == k + 1 + c) - x->W[(k + 1 + c) * m + j] * v * v);
                const double own = (j == t) - x->W[t * m + j] * v * v;
                row[j] -= part * (own - (sticks ? 0.0 : u[a] * along)) * weight_j / v;
                if (!sticks && pushed > 0.0)
                    row[j] -= mu * u[a] * ((j == k) - x->W[k * m + j] * w * w) * weight_j / v;
            }
        }
        for (int32_t r = k; r <= k + n; r++)
            largest = fmax(largest, s->weight[r] > 0.0 ? fabs(s->defect[r]) / s->weight[r] : 0.0);
    }
    return largest;
}

/* Root of the sum of squares of weighted defects. */
static inline double size_of_defect(const contact_problem *x, const contact_parts *s)
{
    double sum = 0.0;
    for (int32_t k = 0; k < x->rows; k++)
        if (s->weight[k] > 0.0) sum += hm_square(s->defect[k] / s->weight[k]);
    return sqrt(sum);
}

/* Newton's iteration from p, after so many relaxed sweeps; returns whether p solves. */
HM_SELDOM static int iterate_contacts(const contact_problem *x, const contact_parts *s, double size,
                                      int32_t sweeps)
{
    double least = INFINITY;
    for (int32_t sweep = 0; sweep < sweeps; sweep++) {
        if (project(x, s, NULL) <= 1e-15 * size) break;
        for (int32_t k = 0; k < x->rows; k++) x->p[k] -= s->defect[k] / x->contacts;
    }
    for (int32_t iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
        const double error = project(x, s, s->matrix), before = size_of_defect(x, s);
        if (!(error < INFINITY)) break;
        if (error < least) {
            least = error;
            memcpy(s->kept, x->p, sizeof(double) * (size_t)x->rows);
        } else if (least <= 0.1 * SOLVED * size)
            break;
        if (error <= 1e-15 * size) break;
        for (int32_t k = 0; k < x->rows; k++)
            s->rhs[k] = s->weight[k] > 0.0 ? -s->defect[k] / s->weight[k] : -s->defect[k];
        hm_least_squares(x->rows, s->matrix, s->rhs, s->change, s->head, s->order, DEPENDENT_ROWS);
        double part = 1.0;
        memcpy(s->rhs, x->p, sizeof(double) * (size_t)x->rows);
        for (int halving = 0; halving < 4; halving++, part *= 0.5) {
            for (int32_t k = 0; k < x->rows; k++)
                x->p[k] =
                    s->rhs[k] + part * s->change[k] * (s->weight[k] > 0.0 ? s->weight[k] : 1.0);
            project(x, s, NULL);
            if (size_of_defect(x, s) < before) break;
        }
    }
    memcpy(x->p, s->kept, sizeof(double) * (size_t)x->rows);
    return least <= SOLVED * size;
}

/* Newton's iteration with friction that grows from none to all of it. */
HM_SELDOM static int continue_in_friction(const contact_problem *x, const contact_parts *s,
                                          double size, double *start)
{
    double done = -1.0, step = 0.125;
    for (int32_t k = 0; k < x->rows; k++) start[k] = 0.0;
    while (step > 1e-3) {
        const double part = done < 0.0 ? 0.0 : fmin(done + step, 1.0);
        for (int32_t i = 0; i < x->contacts; i++) s->mu[i] = part * x->coefficient[i];
        memcpy(x->p, start, sizeof(double) * (size_t)x->rows);
        if (!iterate_contacts(x, s, size, part == 0.0 ? MOST_SWEEPS_FIRST : 0)) {
            if (part == 0.0) return 0;
            step *= 0.5;
            continue;
        }
        if (part == 1.0) return 1;
        memcpy(start, x->p, sizeof(double) * (size_t)x->rows);
        done = part;
        step *= 2.0;
    }
    return 0;
}

/* From starts all over the cones, of the size of the rates. */
HM_SELDOM static int from_anywhere(const contact_problem *x, const contact_parts *s, double size)
{
    uint32_t number = 1;
    double largest = 0.0;
    for (int32_t k = 0; k < x->rows; k++) largest = fmax(largest, fabs(x->b[k]) * s->weight[k]);
    for (int32_t start = 0; start < SCATTERED_STARTS; start++) {
        for (int32_t i = 0; i < x->contacts; i++) {
            const int32_t k = x->first[i];
            for (int32_t r = k; r <= k + x->tangents[i]; r++) {
                number = 1664525u * number
                         + 1013904223u; /* a congruence, so that every run starts alike */
                const double part = (double)number / 4294967296.0,
                             cone = x->coefficient[i] * x->p[k];
                if (r == k) x->p[r] = largest * s->weight[k] * fmax(0.0, 4.0 * part - 1.0);
                else x->p[r] = x->slides[i] ? -cone * x->way[r] : cone * (2.0 * part - 1.0);
            }
        }
        if (iterate_contacts(x, s, size, 0)) return 1;
    }
    return 0;
}

/* From starts at which one set of contacts after the other pushes, sticking as it must or with
   impulses of the size of rates, the solution of that work. */
HM_SELDOM static int from_pushing(contact_problem *x, const contact_parts *s, double size,
                                  int wanted)
{
    double best = 0.0, *start = s->columns;
    int found = 0;
    const int32_t n = x->contacts, sets = n <= MOST_IN_SETS ? (1 << n) - 1 : n + 1;
    for (int32_t set = 1; set <= sets; set++)
        for (int far = 0; far < 3; far++) {
            for (int32_t i = 0; i < n; i++) {
                const int pushes = n <= MOST_IN_SETS ? set >> i & 1 : set > n || set == i + 1;
                s->digit[i] = pushes ? CHOICE_PUSHES : CHOICE_PARTS;
            }
            if (far == 0) choice_fits(x, s, size);
            for (int32_t k = 0; k < x->rows && far > 0; k++) x->p[k] = 0.0;
            for (int32_t i = 0; i < n && far > 0; i++) {
                const int32_t k = x->first[i];
                if (s->digit[i] == CHOICE_PARTS) continue;
                x->p[k] = (far > 1 ? 10.0 : 1.0) * size * s->weight[k];
                for (int32_t t = k + 1; t <= k + x->tangents[i] && x->slides[i]; t++)
                    x->p[t] = -x->coefficient[i] * x->p[k] * x->way[t];
            }
            if (!iterate_contacts(x, s, size, 0)) continue;
            contact_rates(x);
            const double work = work_of_solution(x);
            if (found && !(wanted == MOST_WORK ? work > best : work < best)) continue;
            found = 1, best = work;
            memcpy(start, x->p, sizeof(double) * (size_t)x->rows);
        }
    if (found) memcpy(x->p, start, sizeof(double) * (size_t)x->rows);
    return found;
}

/* Takes out what round-off leaves of the law: impulses of contacts that part, and friction beyond
   the cone. */
HM_SELDOM static void tidy(const contact_problem *x, const contact_parts *s)
{
    contact_rates(x);
    for (int32_t i = 0; i < x->contacts; i++) {
        double *p = x->p + x->first[i];
        const int32_t n = x->tangents[i];
        if (!(p[0] > 0.0 && p[0] - x->rate[x->first[i]] * hm_square(s->weight[x->first[i]]) > 0.0))
            p[0] = 0.0;
        const double cone = x->coefficient[i] * p[0], size = n ? hm_length(n, p + 1) : 0.0;
        for (int32_t a = 1; a <= n && size > cone; a++) p[a] *= cone / size;
    }
}

/* Solves the problem, of several solutions for the one of that work; returns 0, or 1 if none was
   found. */
HM_SELDOM static int hm_solve_contacts(contact_problem *x, int wanted)
{
    const contact_parts s = contact_map(x);
    const double size = weigh_rows(x, &s);
    const int32_t count = has_friction(x) || x->contacts == 1 ? count_choices(x) : 0;
    int found = 0;
    x->several = 0;
    for (int32_t i = 0; i < x->contacts; i++) {
        s.mu[i] = x->coefficient[i];
        s.digit[i] = CHOICE_PUSHES;
    }
    for (int32_t k = 0; k < x->rows; k++) x->p[k] = 0.0;
    if (!(size < INFINITY)) return 1;
    if (size == 0.0 && wanted != MOST_WORK) found = 1;
    if (!found && count) found = try_choices(x, &s, size, count, wanted);
    else if (!found && wanted != MOST_WORK) found = choice_fits(x, &s, size);
    for (int32_t k = 0; k < x->rows && !found; k++) x->p[k] = 0.0;
    if (!found && wanted != MOST_WORK)
        found = iterate_contacts(x, &s, size, MOST_SWEEPS_FIRST)
                || (!count && has_friction(x) && continue_in_friction(x, &s, size, s.columns));
    if (!found && !count && !has_friction(x))
        found = try_choices(x, &s, size, count_choices(x), wanted);
    for (int32_t i = 0; i < x->contacts; i++) s.mu[i] = x->coefficient[i];
    if (!found && !count) found = from_pushing(x, &s, size, wanted);
    if (!found && !count && wanted == LEAST_WORK) found = from_anywhere(x, &s, size);
    if (!found) return 1;
    tidy(x, &s);
    contact_rates(x);
    return 0;
}

/* --------------------------------------------------------------------------- redundant contacts */

/* A contact in the split: it parts, stays on its ray, or may be anywhere in its cone. */
enum { FACE_PARTS, FACE_RAY, FACE_CONE };

HM_SELDOM static int face_of(const contact_problem *x, const contact_parts *s, int32_t i,
                             double size, double *way)
{
    const int32_t k = x->first[i], n = slips_of(x, i);
    if (x->rate[k] * s->weight[k] > FITS * size) return FACE_PARTS;
    if (n == 0) return FACE_RAY;
    const double slip = hm_length(n, x->rate + k + 1);
    for (int32_t a = 0; a < n; a++)
        way[a] = x->slides[i] ? x->way[k + 1 + a] : slip > 0.0 ? x->rate[k + 1 + a] / slip : 0.0;
    return x->slides[i] || slip * s->weight[k + 1] > FITS * size ? FACE_RAY : FACE_CONE;
}

/* Impulses of the least size with the same rates: a split (rest_split.h) with B of orthonormal rows
   that span those of W. Those of a solution stay if none is found. */
HM_SELDOM static void hm_share_impulses(const contact_problem *x)
{
    const contact_parts s = contact_map(x);
    const double size = weigh_rows(x, &s);
    const int32_t m = x->rows;
    int32_t *at = s.digit, count = 0; /* first column of each contact, or -1 */
    int32_t *first = s.order + m, *tangents = s.digit + m;
    double *coefficient = s.slope;
    for (int32_t r = 0; r < m; r++)
        for (int32_t c = 0; c < m; c++)
            s.columns[r * m + c] = x->W[(int64_t)r * m + c] * s.weight[r] * s.weight[c];
    if (hm_triangulate(m, m, s.columns, s.head, s.order, REDUNDANT) == m) return;
    contact_rates(x);
    double way[3], largest = 0.0;
    for (int32_t i = 0; i < x->contacts; i++) {
        const int face = face_of(x, &s, i, size, way);
        at[i] = face == FACE_PARTS ? -1 : count;
        count += face == FACE_PARTS ? 0 : face == FACE_RAY ? 1 : 1 + slips_of(x, i);
    }
    if (count == 0) return;
    /* Rows of A' are what each unknown does to the weighted rates. */
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = slips_of(x, i);
        if (at[i] < 0) continue;
        const int face = face_of(x, &s, i, size, way);
        for (int32_t a = 0; a <= (face == FACE_CONE ? n : 0); a++)
            for (int32_t r = 0; r < m; r++) {
                double sum = x->W[(int64_t)r * m + k + a];
                for (int32_t t = 0; t < n && face == FACE_RAY; t++)
                    sum -= x->coefficient[i] * way[t] * x->W[(int64_t)r * m + k + 1 + t];
                s.columns[(at[i] + a) * m + r] = sum * s.weight[r] * s.weight[k];
            }
    }
    const int32_t rank = hm_triangulate(count, m, s.columns, s.head, s.order, REDUNDANT);
    double *g = s.kept, *z = s.rhs, norm = 0.0;
    for (int32_t j = 0; j < rank; j++) { /* R' g = the rates, in the order of the columns */
        double sum = (x->rate[s.order[j]] - x->b[s.order[j]]) * s.weight[s.order[j]];
        for (int32_t e = 0; e < j; e++) sum -= s.columns[e * m + j] * g[e];
        g[j] = sum / s.columns[j * m + j];
        norm += g[j] * g[j];
    }
    norm = sqrt(norm);
    if (!(norm > 0.0)) return;
    for (int32_t j = 0; j < rank; j++) g[j] /= norm;
    double *B = s.basis; /* rank x count */
    for (int32_t j = 0; j < rank; j++) {
        for (int32_t e = 0; e < count; e++) s.change[e] = e == j ? 1.0 : 0.0;
        hm_reflect(count, m, rank, s.columns, s.head, 1, s.change);
        for (int32_t e = 0; e < count; e++) B[j * count + e] = s.change[e];
    }
    rest_split split = {.rows = count,
                        .rank = rank,
                        .first = first,
                        .tangents = tangents,
                        .coefficient = coefficient,
                        .B = B,
                        .g = g,
                        .force = z,
                        .base = s.slope + 2 * m,
                        .dual = s.defect,
                        .way = s.change,
                        .defect = s.mu,
                        .trial = s.slope + m,
                        .matrix = s.matrix};
    for (int32_t i = 0; i < x->contacts; i++) {
        if (at[i] < 0) continue;
        first[split.contacts] = at[i];
        tangents[split.contacts] = face_of(x, &s, i, size, way) == FACE_CONE ? slips_of(x, i) : 0;
        coefficient[split.contacts++] = x->coefficient[i];
    }
    if (!has_split(&split, 1.0)) return;
    /* The new impulses, unless they change the rates. */
    memcpy(s.kept, x->p, sizeof(double) * (size_t)m);
    memcpy(s.change, x->rate, sizeof(double) * (size_t)m);
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = slips_of(x, i);
        const int face = face_of(x, &s, i, size, way);
        for (int32_t a = 0; a <= x->tangents[i]; a++) s.defect[k + a] = 0.0;
        if (at[i] < 0) continue;
        for (int32_t a = 0; a <= (face == FACE_CONE ? n : 0); a++)
            s.defect[k + a] = z[at[i] + a] * norm * s.weight[k];
        for (int32_t a = 1; a <= n && face == FACE_RAY; a++)
            s.defect[k + a] = -x->coefficient[i] * way[a - 1] * s.defect[k];
    }
    memcpy(x->p, s.defect, sizeof(double) * (size_t)m);
    contact_rates(x);
    for (int32_t k = 0; k < m; k++) {
        double terms = fabs(x->b[k]);
        for (int32_t j = 0; j < m; j++) terms += fabs(x->W[(int64_t)k * m + j] * x->p[j]);
        largest = fmax(largest, (fabs(x->rate[k] - s.change[k]) - 1e-11 * terms) * s.weight[k]);
    }
    if (!(largest <= 0.0)) memcpy(x->p, s.kept, sizeof(double) * (size_t)m);
    contact_rates(x);
}

#endif
