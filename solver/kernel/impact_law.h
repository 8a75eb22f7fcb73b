/* Impact at a fixed configuration: Newton's law of restitution with Coulomb's cone (Moreau 1988), for all contacts at
   once. With gamma+ = gamma- + W p, each contact obeys

       0 <= p_N _|_ gamma_N+ + e gamma_N- >= 0,    |p_T| <= coefficient p_N,    p_T against gamma_T+ where that is not 0.

   Projected Gauss-Seidel guesses which contacts part, stick and slide. Newton's iteration solves the equations of that
   guess, linear but for the directions of slip in space. Contacts whose inequalities fail change; until none does. */
#ifndef HOLONOM_IMPACT_LAW_H
#define HOLONOM_IMPACT_LAW_H

#include "internal.h"

/* What a contact does after the impact: closed, it has no friction or slides; sticks, it has friction and no slip. One
   with neither impulse nor gamma_N+ + e gamma_N- may be called any of them.                                     */
enum impact_status { IMPACT_PARTED, IMPACT_CLOSED, IMPACT_STICKS };

/* Rows are rates [m/s or rad/s], and impulses of the same contacts [N s or N m s]. */
typedef struct hm_impact {
    int32_t contacts, rows;
    const int32_t *first, *tangents; /* per contact: its normal row; rows of slip that follow it: 0 to 3        */
    const double *coefficient;       /* per contact, >= 0                                                       */
    double *restitution;             /* per contact, 0 .. 1; all are halved, and 0 below 1e-3, where the law would create
                                        energy (Kane and Levinson 1985) or no impulses obey it                  */
    const double *W;                 /* rows x rows: G M^-1 G' reduced by the bilateral rows; may be singular    */
    const double *before;            /* rows: gamma-; of a normal row negative where bodies approach            */
    double *impulse, *after;         /* rows, overwritten: p, gamma+                                            */
    int32_t *status;                 /* per contact, overwritten                                                */
    double *scratch;                 /* IMPACT_SCRATCH(rows) doubles                                            */
} hm_impact;

#define IMPACT_TOLERANCE 1e-12 /* of the sum of a row's terms: what is called 0 when inequalities are checked  */
#define IMPACT_DEPENDENT 1e-11 /* pivot of a matrix with diagonal 1: a smaller one is that of a dependent row   */

/* Scratch by its parts; rows each, the matrix rows x rows, equation and unknown 4 a row. */
typedef struct impact_parts {
    double *matrix, *rhs, *change, *order;
    double *size;               /* sum of the sizes of the terms of gamma+ = gamma- + W p                        */
    double *direction;          /* of slip, at the tangents of a sliding contact                                 */
    double *equation, *unknown; /* weights of a contact's rows in an equation, and in the impulse of an unknown  */
} impact_parts;

static inline impact_parts impact_map(const hm_impact *x)
{
    const int64_t n = (int64_t)x->rows;
    double *s = x->scratch;
    return (impact_parts){s + 13 * n, s, s + n, s + 2 * n, s + 3 * n, s + 4 * n, s + 5 * n, s + 9 * n};
}

static inline int32_t impact_slips(const hm_impact *x, int32_t i) { return x->coefficient[i] > 0.0 ? x->tangents[i] : 0; }

static inline double impact_cone(const hm_impact *x, int32_t i) { return x->coefficient[i] * x->impulse[x->first[i]]; }

static inline double impact_length(int32_t n, const double *u)
{
    return n == 1 ? fabs(u[0]) : sqrt(u[0] * u[0] + u[1] * u[1] + (n == 3 ? u[2] * u[2] : 0.0));
}

/* n - 1 unit vectors across the unit vector u (n), at right angles to each other. */
HM_SELDOM static void impact_across(int32_t n, const double *u, double across[2][3])
{
    across[0][0] = -u[1], across[0][1] = u[0], across[0][2] = 0.0;
    if (n < 3) return;
    const double side = u[2] < 0.0 ? -1.0 : 1.0, a = -1.0 / (side + u[2]), b = u[0] * u[1] * a; /* Duff et al. 2017 */
    across[0][0] = 1.0 + side * u[0] * u[0] * a, across[0][1] = side * b, across[0][2] = -side * u[0];
    across[1][0] = b, across[1][1] = side + u[1] * u[1] * a, across[1][2] = -u[1];
}

/* gamma_N+ + e gamma_N- of contact i. */
static inline double impact_gap_rate(const hm_impact *x, int32_t i)
{
    return x->after[x->first[i]] + x->restitution[i] * x->before[x->first[i]];
}

/* gamma+ of row k, and the sum of the sizes of its terms. */
HM_SELDOM static double impact_rate(const hm_impact *x, int32_t k, double *size)
{
    double sum = x->before[k];
    *size = fabs(sum);
    for (int32_t j = 0; j < x->rows; j++) {
        const double term = x->W[k * x->rows + j] * x->impulse[j];
        sum += term;
        *size += fabs(term);
    }
    return sum;
}

/* The contact slides along sign u/|u|, with what friction then is. */
HM_SELDOM static void impact_slide(const hm_impact *x, int32_t i, double sign, const double *u, double *direction)
{
    const int32_t n = impact_slips(x, i), t = x->first[i] + 1;
    const double length = n ? impact_length(n, u) : 0.0;
    x->status[i] = IMPACT_CLOSED;
    for (int32_t a = 0; a < n; a++) {
        direction[t + a] = length > 0.0 ? sign * u[a] / length : 0.0;
        x->impulse[t + a] = -impact_cone(x, i) * direction[t + a];
    }
}

/* One projected change of the impulses of contact i; whether they moved. */
HM_SELDOM static int impact_relax(hm_impact *x, int32_t i)
{
    const int32_t k = x->first[i], n = impact_slips(x, i), m = x->rows;
    const double *w = x->W + k * m + k, *v = w + m + 1;
    double *p = x->impulse + k, pull[3], size;
    const double old = p[0];
    x->after[k] = impact_rate(x, k, &size);
    const double brake = n == 0 ? 0.0 : x->coefficient[i] * impact_length(n, w + 1);
    p[0] = w[0] > 0.0 ? fmax(0.0, old - impact_gap_rate(x, i) / (w[0] + brake)) : 0.0;
    int moved = fabs(p[0] - old) > DBL_EPSILON * old;
    if (n == 0) return moved;
    double stiffness = n == 1 ? v[0] : 0.5 * (v[0] + v[m + 1] + sqrt(hm_square(v[0] - v[m + 1]) + 4.0 * v[1] * v[m]));
    if (n == 3) stiffness = v[0] + v[m + 1] + v[2 * m + 2]; /* no less than the largest eigenvalue */
    for (int32_t a = 0; a < n; a++)
        pull[a] = stiffness > 0.0 ? p[1 + a] - impact_rate(x, k + 1 + a, &size) / stiffness : 0.0;
    const double length = impact_length(n, pull), cone = impact_cone(x, i);
    for (int32_t a = 0; a < n; a++) {
        const double held = length > cone ? pull[a] * (cone / length) : pull[a];
        moved |= fabs(held - p[1 + a]) > DBL_EPSILON * length;
        p[1 + a] = held;
    }
    return moved;
}

/* Projected Gauss-Seidel from impulses of 0, and the statuses at which it ends. */
HM_SELDOM static void impact_guess(hm_impact *x, const impact_parts *s, int32_t sweeps)
{
    int moved = 1;
    for (int32_t k = 0; k < x->rows; k++) x->impulse[k] = 0.0;
    for (int32_t sweep = 0; sweep < sweeps && moved; sweep++) {
        moved = 0;
        for (int32_t i = 0; i < x->contacts; i++) moved |= impact_relax(x, i);
    }
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t n = impact_slips(x, i);
        const double *p = x->impulse + x->first[i], cone = impact_cone(x, i);
        x->status[i] = p[0] > 0.0 ? IMPACT_STICKS : IMPACT_PARTED;
        if (p[0] > 0.0 && (n == 0 || impact_length(n, p + 1) >= cone * (1.0 - IMPACT_TOLERANCE)))
            impact_slide(x, i, -1.0, p + 1, s->direction);
    }
}

static inline void impact_swap(double *a, double *b)
{
    const double kept = *a;
    *a = *b;
    *b = kept;
}

/* Solves A x = b (n) with complete pivoting, both modified; x and order (n) overwritten. Unknowns of dependent columns
   are 0.                                                                                                       */
HM_SELDOM static void impact_eliminate(int32_t n, double *A, double *b, double *order, double *solution)
{
    int32_t rank = 0;
    for (int32_t c = 0; c < n; c++) order[c] = c;
    for (; rank < n; rank++) {
        int32_t row = rank, column = rank;
        for (int32_t r = rank; r < n; r++)
            for (int32_t c = rank; c < n; c++)
                if (fabs(A[r * n + c]) > fabs(A[row * n + column])) row = r, column = c;
        if (!(fabs(A[row * n + column]) > IMPACT_DEPENDENT)) break;
        for (int32_t c = 0; c < n; c++) impact_swap(A + row * n + c, A + rank * n + c);
        for (int32_t r = 0; r < n; r++) impact_swap(A + r * n + column, A + r * n + rank);
        impact_swap(b + row, b + rank);
        impact_swap(order + column, order + rank);
        for (int32_t r = 0; r < n; r++) {
            if (r == rank) continue;
            const double factor = A[r * n + rank] / A[rank * n + rank];
            for (int32_t c = rank; c < n; c++) A[r * n + c] -= factor * A[rank * n + c];
            b[r] -= factor * b[rank];
        }
    }
    for (int32_t r = 0; r < n; r++) solution[(int32_t)order[r]] = r < rank ? b[r] / A[r * n + r] : 0.0;
}

/* Equations and unknowns of contact i, so that the matrix has a diagonal of 1: gamma_N+ + e gamma_N- = 0 for p_N, with
   the friction that it brings where the contact slides; gamma_T+ = 0 for p_T where it sticks; in space the slip across
   its direction, for the friction across it. What such friction adds to the diagonal is put there.              */
HM_SELDOM static void impact_weigh(const hm_impact *x, const impact_parts *s, int32_t i)
{
    const int32_t k = x->first[i], n = impact_slips(x, i), t = k + 1, m = x->rows;
    for (int32_t r = 4 * k; r < 4 * (t + x->tangents[i]); r++) s->equation[r] = s->unknown[r] = 0.0;
    if (x->status[i] == IMPACT_PARTED) return;
    for (int32_t a = 0; a <= (x->status[i] == IMPACT_STICKS ? n : 0); a++) {
        const double stiffness = x->W[(k + a) * m + k + a];
        s->unknown[4 * (k + a) + a] = stiffness > 0.0 ? 1.0 / sqrt(stiffness) : 0.0;
        s->equation[4 * (k + a) + a] = stiffness > 0.0 ? 1.0 / sqrt(stiffness) : 1.0;
    }
    if (x->status[i] == IMPACT_STICKS) return;
    const double *u = s->direction + t, *v = x->W + t * m + t, cone = impact_cone(x, i);
    for (int32_t a = 0; a < n; a++) s->unknown[4 * k + 1 + a] = -x->coefficient[i] * u[a] * s->unknown[4 * k];
    if (n < 2 || !(cone > 0.0)) return;
    double across[2][3], along = 0.0;
    for (int32_t a = 0; a < n; a++) along += u[a] * x->after[t + a];
    const double turning = fmax(0.0, along) / cone;
    impact_across(n, u, across);
    for (int32_t e = 0; e < n - 1; e++) {
        double stiffness = turning;
        for (int32_t a = 0; a < n; a++)
            for (int32_t b = 0; b < n; b++) stiffness += across[e][a] * v[a * m + b] * across[e][b];
        const double scale = stiffness > 0.0 ? 1.0 / sqrt(stiffness) : 0.0;
        for (int32_t a = 0; a < n; a++)
            s->equation[4 * (t + e) + 1 + a] = s->unknown[4 * (t + e) + 1 + a] = across[e][a] * scale;
        s->matrix[(t + e) * m + t + e] = turning * scale * scale;
    }
}

/* Right-hand side of the equations of contact i; returns the largest over the sizes of its terms. */
HM_SELDOM static double impact_defect(const hm_impact *x, const impact_parts *s, int32_t i)
{
    double largest = 0.0;
    for (int32_t k = x->first[i], r = k; r <= k + x->tangents[i]; r++) {
        const double *weight = s->equation + 4 * r;
        double size = 0.0;
        s->rhs[r] = -weight[0] * impact_gap_rate(x, i);
        for (int32_t a = 0; a <= x->tangents[i]; a++) {
            if (a > 0) s->rhs[r] -= weight[a] * x->after[k + a];
            size += fabs(weight[a]) * s->size[k + a];
        }
        if (!(fabs(s->rhs[r]) <= largest * size)) largest = fabs(s->rhs[r]) / size;
    }
    return largest;
}

/* The equations of contact i with the unknowns of contact j: adds to the matrix. */
HM_SELDOM static void impact_couple(const hm_impact *x, const impact_parts *s, int32_t i, int32_t j)
{
    const int32_t k = x->first[i], l = x->first[j], m = x->rows;
    for (int32_t r = 0; r <= x->tangents[i]; r++)
        for (int32_t c = 0; c <= x->tangents[j]; c++)
            for (int32_t a = 0; a <= x->tangents[i]; a++)
                for (int32_t b = 0; b <= x->tangents[j]; b++)
                    s->matrix[(k + r) * m + l + c] +=
                        s->equation[4 * (k + r) + a] * x->W[(k + a) * m + l + b] * s->unknown[4 * (l + c) + b];
}

/* The impulses of contact i after a change of its unknowns. */
HM_SELDOM static void impact_move(const hm_impact *x, const impact_parts *s, int32_t i)
{
    const int32_t k = x->first[i], n = impact_slips(x, i);
    const double cone = impact_cone(x, i);
    double u[3] = {0.0, 0.0, 0.0};
    if (x->status[i] == IMPACT_PARTED) return;
    for (int32_t a = 0; a < n; a++) {
        double across = 0.0;
        for (int32_t e = 1; e < n || e == 1; e++) across += s->unknown[4 * (k + e) + 1 + a] * s->change[k + e];
        u[a] = s->direction[k + 1 + a] - (cone > 0.0 ? across / cone : 0.0);
    }
    x->impulse[k] += s->unknown[4 * k] * s->change[k];
    if (x->status[i] == IMPACT_CLOSED) impact_slide(x, i, 1.0, u, s->direction);
    else
        for (int32_t a = 1; a <= n; a++) x->impulse[k + a] += s->unknown[4 * (k + a) + a] * s->change[k + a];
}

/* Newton's iteration for the statuses at hand; returns the largest defect over the sizes of its terms. */
HM_SELDOM static double impact_settle(const hm_impact *x, const impact_parts *s)
{
    const int64_t square = (int64_t)x->rows * (int64_t)x->rows;
    double defect = 0.0, last = 0.0;
    for (int32_t iteration = 0;; iteration++, last = defect) {
        defect = 0.0;
        for (int32_t k = 0; k < x->rows; k++) x->after[k] = impact_rate(x, k, s->size + k);
        for (int64_t e = 0; e < square; e++) s->matrix[e] = 0.0;
        for (int32_t i = 0; i < x->contacts; i++) {
            impact_weigh(x, s, i);
            const double of_contact = impact_defect(x, s, i);
            if (!(of_contact <= defect)) defect = of_contact;
        }
        const int stalls = iteration > (defect < IMPACT_TOLERANCE ? 1 : 3) && defect > 0.5 * last;
        if (!(defect > 0.5 * DBL_EPSILON) || stalls || iteration == 12) return defect;
        for (int32_t i = 0; i < x->contacts; i++)
            for (int32_t j = 0; j < x->contacts; j++) impact_couple(x, s, i, j);
        impact_eliminate(x->rows, s->matrix, s->rhs, s->order, s->change);
        for (int32_t i = 0; i < x->contacts; i++) impact_move(x, s, i);
    }
}

/* Whether contact i has friction and, to round-off, no slip. */
HM_SELDOM static int impact_rests(const hm_impact *x, const impact_parts *s, int32_t i)
{
    const int32_t t = x->first[i] + 1, n = impact_slips(x, i);
    return n > 0 && impact_length(n, x->after + t) <= IMPACT_TOLERANCE * (s->size[t] + s->size[t + n - 1]);
}

/* Changes the status of contact i if an inequality fails; returns whether it does. */
HM_SELDOM static int impact_revise(const hm_impact *x, const impact_parts *s, int32_t i)
{
    const int32_t k = x->first[i], n = impact_slips(x, i);
    double *p = x->impulse + k;
    const double *rate = x->after + k, *u = s->direction + k;
    const double small = IMPACT_TOLERANCE * s->size[k], excess = impact_gap_rate(x, i);
    if (x->status[i] == IMPACT_PARTED) {
        if (excess < -small) x->status[i] = n ? IMPACT_STICKS : IMPACT_CLOSED;
        return excess < -small;
    }
    if (p[0] < 0.0 || excess > small) {
        x->status[i] = IMPACT_PARTED;
        for (int32_t a = 0; a <= n; a++) p[a] = 0.0;
        return 1;
    }
    if (x->status[i] == IMPACT_STICKS) {
        const int holds = impact_length(n, p + 1) <= impact_cone(x, i) * (1.0 + IMPACT_TOLERANCE);
        if (holds && impact_rests(x, s, i)) return 0;
        impact_slide(x, i, holds ? 1.0 : -1.0, holds ? rate + 1 : p + 1, s->direction);
        return 1;
    }
    double along = 0.0;
    for (int32_t a = 1; a <= n; a++) along += u[a] * rate[a];
    if (n == 0 || impact_rests(x, s, i) || along > 0.0) return 0;
    x->status[i] = IMPACT_STICKS;
    return 1;
}

/* Whether statuses that agree with all inequalities are found from those at hand, for which impulses follow. All contacts change
   at once, or the first `alone` (Murty 1974).                                                                     */
HM_SELDOM static int impact_agrees(hm_impact *x, const impact_parts *s, int alone, int32_t turns)
{
    for (int32_t turn = 0; turn < turns; turn++) {
        const double defect = impact_settle(x, s);
        int changes = 0;
        for (int32_t i = 0; i < x->contacts && !(alone && changes); i++) changes |= impact_revise(x, s, i);
        if (changes) continue;
        if (!(defect < 10.0 * IMPACT_TOLERANCE)) return 0;
        for (int32_t i = 0; i < x->contacts; i++)
            if (x->status[i] == IMPACT_CLOSED && impact_rests(x, s, i)) x->status[i] = IMPACT_STICKS;
        return 1;
    }
    return 0;
}

/* Gives the first contacts the statuses that the digits of a number to base 3 tell; those that slide go on as they slip now. */
HM_SELDOM static void impact_start(hm_impact *x, const impact_parts *s, int32_t digits)
{
    for (int32_t i = 0; i < x->contacts; i++, digits /= 3) {
        const int32_t k = x->first[i];
        x->status[i] = digits % 3;
        for (int32_t a = 0; a <= x->tangents[i] && x->status[i] == IMPACT_PARTED; a++) x->impulse[k + a] = 0.0;
        if (x->status[i] == IMPACT_CLOSED) impact_slide(x, i, 1.0, x->after + k + 1, s->direction);
        if (x->status[i] == IMPACT_STICKS && impact_slips(x, i) == 0) x->status[i] = IMPACT_CLOSED;
    }
}

enum { IMPACT_STARTS = 243, IMPACT_TURNS = 4 }; /* all statuses of five contacts */

/* Impulses for the restitution at hand; 0, or 1 if no statuses were found that agree with them. Where changes go round in circles,
   other statuses are begun with: five contacts of a mechanism of four freedoms did, after a guess that the last digit of a
   mass decided.                                                                                                   */
HM_SELDOM static int impact_search(hm_impact *x, const impact_parts *s)
{
    int alone = 0;
    int32_t starts = 1;
    for (int32_t sweeps = 32; sweeps <= 32768; sweeps *= 4, alone = !alone) {
        impact_guess(x, s, sweeps);
        if (impact_agrees(x, s, alone, alone ? x->contacts + 8 : 32)) return 0;
    }
    for (int32_t i = 0; i < x->contacts && starts < IMPACT_STARTS; i++) starts *= 3;
    for (int32_t start = 0; start < starts; start++) {
        impact_start(x, s, start);
        if (impact_agrees(x, s, 0, IMPACT_TURNS)) return 0;
    }
    return 1;
}

/* Solves one impact; returns 0, or 1 if no impulses were found: those left behind then mean nothing. */
HM_SELDOM static int hm_solve_impact(hm_impact *x)
{
    const impact_parts s = impact_map(x);
    for (;;) {
        const int failed = impact_search(x, &s);
        double loss = 0.0, size = 0.0, largest = 0.0;
        for (int32_t k = 0; k < x->rows; k++) {
            loss -= 0.5 * x->impulse[k] * (x->before[k] + x->after[k]);
            size += fabs(x->impulse[k]) * s.size[k];
        }
        for (int32_t i = 0; i < x->contacts; i++) largest = fmax(largest, x->restitution[i]);
        if ((!failed && loss >= -IMPACT_TOLERANCE * size) || !(largest > 0.0)) return failed;
        for (int32_t i = 0; i < x->contacts; i++) x->restitution[i] *= x->restitution[i] < 2e-3 ? 0.0 : 0.5;
    }
}

#endif
