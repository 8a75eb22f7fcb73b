/* One solver of contact_problem.h, for impacts and for accelerations:

   1. all contacts push and none begins to slide, if that obeys the law;
   2. few contacts with at most one row of slip each: all choices (contact_choices.h);
   3. else Newton's iteration on the projections of Alart and Curnier 1991, after relaxed sweeps
   over all contacts at once; then with friction that grows from 0;
   4. one contact in space that slides: all directions.

   Impulses that redundant contacts leave open are shared afterwards (share_impulses.h). */
#ifndef HOLONOM_CONTACT_SOLVER_H
#define HOLONOM_CONTACT_SOLVER_H

#include "contact_choices.h"

#define SOLVED 1e-12          /* defect over the largest rate that counts as none */
enum { MOST_SWEEPS_FIRST = 60, MOST_ITERATIONS = 60, MOST_IN_SETS = 5, SCATTERED_STARTS = 200 };
enum { SLIP_DIRECTIONS = 256, DIRECTION_HALVINGS = 60 };

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

/* Sets p of the only contact, which slides along d with gamma_N = 0: p_N = -b_N/a and p_T = -mu p_N
   d, a = W_NN - mu W_NT d. The direction d is that of a place on a square, 0 to 4 round it. Values:
   a, and a times the slip across d, a polynomial in d that is 0 where friction opposes the slip. */
HM_SELDOM static void slide_along(const contact_problem *x, double place, double value[2])
{
    const int32_t k = x->first[0];
    const int64_t n = x->rows;
    const double *normal = x->W + k * n + k, *slip = normal + n, *other = slip + n;
    const double turn = place < 4.0 ? place : 0.0, mu = x->coefficient[0];
    const double corner = floor(turn), part = turn - corner;
    const double away = corner == 0.0 || corner == 3.0 ? 1.0 : -1.0, up = corner < 2.0 ? 1.0 : -1.0;
    const double along = corner == 0.0 || corner == 2.0 ? 1.0 - part : part;
    const double size = hm_length(2, (const double[]){along, 1.0 - along});
    const double d[2] = {away * along / size, up * (1.0 - along) / size};
    const double a = normal[0] - mu * (normal[1] * d[0] + normal[2] * d[1]);
    const double u[2] = {slip[0] - mu * (slip[1] * d[0] + slip[2] * d[1]),
                         other[0] - mu * (other[1] * d[0] + other[2] * d[1])};
    x->p[k] = -x->b[k] / a;
    for (int32_t c = 0; c < 2; c++) x->p[k + 1 + c] = -mu * x->p[k] * d[c];
    value[0] = a;
    value[1] =
        a * (x->b[k + 1] * d[1] - x->b[k + 2] * d[0]) - x->b[k] * (u[0] * d[1] - u[1] * d[0]);
}

/* The last place on this way at which a value has the sign that it begins with. */
HM_SELDOM static double last_alike(const contact_problem *x, int which, double from, double to)
{
    double value[2];
    slide_along(x, from, value);
    const int is_positive = value[which] > 0.0;
    for (int32_t halving = 0; halving < DIRECTION_HALVINGS; halving++) {
        const double middle = 0.5 * (from + to);
        slide_along(x, middle, value);
        if ((value[which] > 0.0) == is_positive) from = middle;
        else to = middle;
    }
    return from;
}

/* Of one contact in space that may slide anywhere, the solution of least work among all
   directions of slip in which a normal impulse pushes: strong friction leaves Newton's iteration
   no way to it. */
HM_SELDOM static int slide_anywhere(const contact_problem *x, const contact_parts *s, double size)
{
    if (x->contacts != 1 || x->tangents[0] != 2 || !may_stick(x, 0)) return 0;
    const int32_t k = x->first[0];
    if (!(s->weight[k + 1] > 0.0)) return 0;
    const double step = 4.0 / SLIP_DIRECTIONS;
    /* Friction multiplies what rounding leaves of gamma_N = 0 by mu. */
    const double none = SOLVED * size * (1.0 + 1e-3 * s->mu[0] * s->weight[k] / s->weight[k + 1]);
    double best = INFINITY, *kept = s->columns;
    for (int32_t i = 0; i < SLIP_DIRECTIONS; i++) {
        double low = i * step, high = low + step, at_low[2], at_high[2];
        slide_along(x, low, at_low);
        slide_along(x, high, at_high);
        if (!(at_low[0] > 0.0 || at_high[0] > 0.0)) continue;
        if (!(at_low[0] > 0.0)) low = last_alike(x, 0, high, low);
        if (!(at_high[0] > 0.0)) high = last_alike(x, 0, low, high);
        slide_along(x, low, at_low);
        slide_along(x, high, at_high);
        if ((at_low[1] > 0.0) == (at_high[1] > 0.0)) continue;
        slide_along(x, last_alike(x, 1, low, high), at_low);
        if (!iterate_contacts(x, s, size, 0) && !(project(x, s, NULL) <= none)) continue;
        contact_rates(x);
        if (!(work_of_solution(x) < best)) continue;
        best = work_of_solution(x);
        memcpy(kept, x->p, sizeof(double) * (size_t)x->rows);
    }
    if (best < INFINITY) memcpy(x->p, kept, sizeof(double) * (size_t)x->rows);
    return best < INFINITY;
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
    if (!found && wanted != MOST_WORK) found = slide_anywhere(x, &s, size);
    if (!found && !count && wanted == LEAST_WORK) found = from_anywhere(x, &s, size);
    if (!found) return 1;
    tidy(x, &s);
    contact_rates(x);
    return 0;
}

#endif
