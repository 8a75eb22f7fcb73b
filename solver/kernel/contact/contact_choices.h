/* Contacts by trying choices: who parts, sticks and slides. Of several choices that obey the law
   the one of least p.W p counts, or of most, which knows neither the order of contacts nor units,
   nor that one of them stands there twice. */
#ifndef HOLONOM_CONTACT_CHOICES_H
#define HOLONOM_CONTACT_CHOICES_H

#include "contact_problem.h"
#include "least_squares.h"

enum solution_wanted {
    LEAST_WORK,
    MOST_WORK,
    LEAST_WORK_IF_ANY
}; /* the last where there may be none: no long search then */

#define DIFFERENT_RATES 1e-7  /* difference of two solutions' rates over the largest one */
#define DEPENDENT_ROWS                                                                             \
    1e-12 /* of a matrix with diagonal 1: a smaller pivot is that of a dependent row */
enum { MOST_CHOICES_TRIED = 1024 };

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

#endif
