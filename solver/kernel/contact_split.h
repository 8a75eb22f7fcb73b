/* How contacts at rest share their forces. The multipliers of rows that hold the same thing twice are one split of many, and may
   lie outside the cones while others do not: what sticks holds as long as there is one inside (rest_split.h).

   W = G M^-1 G' of the rows of closed contacts that do not slide, reduced by the bilateral rows; all splits x of the forces p at hand
   have W x = W p. With the factors W = L L', pivoted, these are as many equations L' x = L' p as W has rank.     */
#ifndef HOLONOM_CONTACT_SPLIT_H
#define HOLONOM_CONTACT_SPLIT_H

#include "impact.h"
#include "rest_split.h"

#define SAME_ROW 1e-10   /* pivot of W with the diagonal 1 that counts as zero                                       */
#define WELL_INSIDE 1e-7 /* of the coefficients: a split that is so far inside its cones if there is one stays inside as it is */
#define SLIPS 1e-6       /* rate over the largest one that counts as a slip                                          */

/* Vectors of a split over the scratch `rest`. */
typedef struct shared_forces {
    rest_split split;
    int32_t *contact, *row, *first, *tangents, *order;
    double *matrix, *p, *weight, *coefficient, *g, *diagonal;
} shared_forces;

HM_SELDOM static shared_forces map_shared(const context *c)
{
    const int64_t n = c->m->n_hit_rows;
    double *d = c->k.rest;
    int32_t *i = (int32_t *)(void *)(d + 2 * n * n + 10 * n);
    shared_forces x = {.matrix = d, .p = d + 2 * n * n, .weight = d + 2 * n * n + n, .coefficient = d + 2 * n * n + 2 * n,
                       .g = d + 2 * n * n + 3 * n, .diagonal = d + 2 * n * n + 4 * n, .contact = i, .row = i + n, .first = i + 2 * n,
                       .tangents = i + 3 * n, .order = i + 4 * n};
    x.split = (rest_split){.first = x.first, .tangents = x.tangents, .coefficient = x.coefficient, .B = c->k.hit_reach, .g = x.g,
                           .force = d + 2 * n * n + 5 * n, .dual = d + 2 * n * n + 6 * n, .way = d + 2 * n * n + 7 * n,
                           .defect = d + 2 * n * n + 8 * n, .trial = d + 2 * n * n + 9 * n, .matrix = d + n * n};
    return x;
}

static double sigma_of(const context *c, int32_t j) { return c->number[c->m->row_sigma_at + row_of(c, j)]; }

/* Whether friction f of contact i holds, as far as it has a cone. */
static int is_stuck(const context *c, int32_t f) { return f >= 0 && friction_mode(c, f) == FRICTION_STICKS; }

/* Collects the closed contacts that do not slide; 0 if they cannot share forces. */
HM_SELDOM static int collect_shared(const context *c, shared_forces *x)
{
    rest_split *s = &x->split;
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        const int32_t f = c->m->contact_friction[i], slips = is_stuck(c, f) ? n_slips(c, f) : 0;
        if (!is_closed(c, i) || (f >= 0 && friction_mode(c, f) == FRICTION_SLIDES)) continue;
        if (slips && (c->m->normal_ptr[f + 1] != c->m->normal_ptr[f] + 1 || c->number[c->m->preload_at + f] != 0.0)) return 0;
        if (s->rows + 1 + slips > c->m->n_hit_rows) return 0;
        x->contact[s->contacts] = i;
        x->first[s->contacts] = s->rows;
        x->tangents[s->contacts] = slips;
        x->coefficient[s->contacts++] = slips ? c->number[c->m->static_at + f] : 0.0;
        const double weight = sigma_of(c, c->m->contact_row[i]);
        for (int k = 0; k <= slips; k++) {
            x->weight[s->rows] = weight;
            x->row[s->rows++] = k ? slip_row(c, f, k - 1) : c->m->contact_row[i];
        }
    }
    return s->contacts > 1;
}

/* W in `matrix`, with all contacts open; w and modes stay as they are. */
HM_SELDOM static int32_t fill_shared(context *c, const shared_forces *x)
{
    const int64_t n = DIM * c->n_moving;
    const size_t modes = sizeof(double) * (size_t)(C_SIZE * c->m->n_contacts + F_SIZE * c->m->n_frictions);
    double *kept = c->k.rest_modes, *w = kept + C_SIZE * c->m->n_contacts + F_SIZE * c->m->n_frictions;
    memcpy(kept, c->s.contacts, modes);
    memcpy(w, c->k.w, sizeof(double) * (size_t)n);
    for (int32_t i = 0; i < c->m->n_contacts; i++) open_contact(c, i);
    stand_still(c);
    int32_t status = factorise_at_state(c, NULL);
    for (int32_t r = 0; r < x->split.rows && !status; r++) status = find_reach(c, x->row[r], r);
    if (!status) status = fill_matrix(c, x->split.rows, x->row, x->matrix);
    memcpy(c->s.contacts, kept, modes);
    memcpy(c->k.w, w, sizeof(double) * (size_t)n);
    return status;
}

/* Factors W = L L' by rows with pivots: B = L', g = L' p over its size, which it returns. */
HM_SELDOM static double equations_of_split(const context *c, shared_forces *x)
{
    rest_split *s = &x->split;
    const int32_t n = s->rows;
    double *W = x->matrix, *B = c->k.hit_reach, size2 = 0.0;
    for (int32_t k = 0; k < n; k++) x->diagonal[k] = W[n * k + k], x->order[k] = 0;
    s->rank = 0;
    for (int32_t step = 0; step < n; step++) {
        int32_t pivot = -1;
        double most = SAME_ROW;
        for (int32_t k = 0; k < n; k++) {
            const double left = x->order[k] ? 0.0 : x->diagonal[k] / W[n * k + k];
            if (left > most) most = left, pivot = k;
        }
        if (pivot < 0) break;
        double *line = B + n * s->rank, root = sqrt(x->diagonal[pivot]);
        for (int32_t k = 0; k < n; k++) {
            line[k] = 0.5 * (W[n * pivot + k] + W[n * k + pivot]);
            for (int32_t a = 0; a < s->rank; a++) line[k] -= B[n * a + pivot] * B[n * a + k];
            line[k] = x->order[k] ? 0.0 : line[k] / root;
            x->diagonal[k] -= line[k] * line[k];
        }
        x->order[pivot] = 1;
        s->rank++;
    }
    for (int32_t k = 0; k < s->rank; k++) {
        x->g[k] = 0.0;
        for (int32_t l = 0; l < n; l++) x->g[k] += B[n * k + l] * x->p[l];
        size2 += x->g[k] * x->g[k];
    }
    const double size = sqrt(size2);
    for (int32_t k = 0; k < s->rank; k++) x->g[k] /= size > 0.0 ? size : 1.0;
    return size;
}

/* Forces p (overwritten) of the split without cones, over its size, that steps have: the least one by the scales of the rows, as regularised rows
   yield. Then B of the split with cones, by one scale a contact, with which its cone is as round as it was. */
HM_SELDOM static void split_of_rows(const context *c, const shared_forces *x)
{
    const rest_split *s = &x->split;
    const int32_t n = s->rows;
    double *B = c->k.hit_reach;
    for (int32_t k = 0; k < s->rank; k++) {
        s->way[k] = x->g[k];
        for (int32_t j = 0; j <= k; j++) {
            double sum = 0.0;
            for (int32_t l = 0; l < n; l++) sum += B[n * k + l] * B[n * j + l] / sigma_of(c, x->row[l]);
            s->matrix[s->rank * k + j] = sum;
        }
    }
    solve_definite(s->rank, s->matrix, s->way);
    for (int32_t l = 0; l < n; l++) {
        double sum = 0.0;
        for (int32_t k = 0; k < s->rank; k++) sum += B[n * k + l] * s->way[k];
        x->p[l] = sum / sigma_of(c, x->row[l]);
    }
    for (int32_t k = 0; k < s->rank; k++)
        for (int32_t l = 0; l < n; l++) B[n * k + l] /= sqrt(x->weight[l]);
}

HM_SELDOM static void forget_shares(const context *c)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++) contact_of(c, i)[C_SHARES] = contact_of(c, i)[C_SHIFT] = 0.0;
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        for (int k = 0; k < 3; k++) friction_of(c, f)[F_SHIFT_1 + k] = 0.0;
}

/* Lets contacts share forces as `split` says, of that size, in event_mu; p are those by their rows. */
HM_SELDOM static void share_forces(const context *c, const shared_forces *x, double size)
{
    for (int32_t k = 0; k < x->split.contacts; k++) {
        const int32_t i = x->contact[k], f = c->m->contact_friction[i];
        contact_of(c, i)[C_SHARES] = 1.0;
        for (int32_t l = 0; l <= x->tangents[k]; l++) {
            const int32_t at = x->first[k] + l, row = row_of(c, x->row[at]);
            const double force = size * x->split.force[at] / sqrt(x->weight[at]);
            *(l ? friction_of(c, f) + F_SHIFT_1 + l - 1 : contact_of(c, i) + C_SHIFT) = size * x->p[at] - force;
            c->k.event_mu[row] = -force;
        }
    }
}

/* Lets frictions of contacts that do not hold slide, all that have a slip in the motion that the unbounded dual is: with y for
   velocities, and rates B'y, the forces at hand do more work than any inside the cones. Returns whether there is one. */
HM_SELDOM static int slide_together(context *c, const shared_forces *x)
{
    const rest_split *s = &x->split;
    double largest = 0.0;
    int slides = 0;
    for (int32_t l = 0; l < s->rows; l++) {
        x->p[l] = 0.0;
        for (int32_t k = 0; k < s->rank; k++) x->p[l] += s->B[s->rows * k + l] * s->dual[k];
        largest = fmax(largest, fabs(x->p[l]));
    }
    for (int32_t i = 0; i < s->contacts; i++) {
        const double *rate = x->p + x->first[i];
        double size2 = 0.0, along[3] = {0.0, 0.0, 0.0};
        for (int32_t l = 1; l <= x->tangents[i]; l++) size2 += rate[l] * rate[l];
        const double size = sqrt(size2);
        if (!(size > SLIPS * largest)) continue;
        for (int32_t l = 1; l <= x->tangents[i]; l++) along[l - 1] = -rate[l] / size;
        let_slide(c, c->m->contact_friction[x->contact[i]], along);
        blame(c, x->row[x->first[i] + 1]);
        slides = 1;
    }
    return slides;
}

#define LARGEST_LOAD 1e3   /* load factors above count as none: no friction holds                                   */
#define LOAD_ACCURACY 1e-12

/* Least factor of all coefficients with which there is a split, or infinity. */
static double load_factor(const rest_split *s)
{
    double low = 0.0, high = 1.0;
    for (; !has_split(s, high); high *= 2.0)
        if (high > LARGEST_LOAD) return INFINITY;
        else low = high;
    while (high - low > LOAD_ACCURACY * high) {
        const double middle = 0.5 * (low + high);
        if (has_split(s, middle)) high = middle;
        else low = middle;
    }
    return high;
}

/* What contacts that hold something twice do, whose multipliers are not all inside the cones. */
enum togetherness {
    NOT_TOGETHER, /* they hold nothing twice, or no forces inside cones of any width do                        */
    HOLD,         /* by forces inside the cones, which they share now                                          */
    GIVE_WAY      /* there are none                                                                             */
};

/* Finds out, of closed contacts that do not slide, with the multipliers in event_mu. `load`, if wanted, is the least factor of all
   coefficients with which they would hold; else those slide that give way. */
HM_SELDOM static int32_t hold_together(context *c, enum togetherness *how, double *load)
{
    shared_forces x = map_shared(c);
    rest_split *s = &x.split;
    *how = NOT_TOGETHER;
    if (!collect_shared(c, &x) || torn_loose(c, NULL) >= 0) return HOLONOM_OK; /* forces at hand do not hold: no others with the same sum do */
    for (int32_t r = 0; r < s->rows; r++) x.p[r] = -c->k.event_mu[row_of(c, x.row[r])];
    const int32_t status = fill_shared(c, &x);
    if (status) return status;
    const double size = equations_of_split(c, &x);
    if (s->rank == s->rows || !(size > 0.0)) return HOLONOM_OK;
    split_of_rows(c, &x);
    if (load) *load = load_factor(s);
    if (load && *load > 1.0 + CONE_MARGIN) {
        *how = *load < INFINITY ? GIVE_WAY : NOT_TOGETHER;
        return HOLONOM_OK;
    }
    if (has_split(s, 1.0 - WELL_INSIDE) || (!c->gives_way && has_split(s, 1.0 + CONE_MARGIN))) {
        *how = HOLD;
        share_forces(c, &x, size);
    } else if (!load && slide_together(c, &x)) *how = GIVE_WAY;
    return HOLONOM_OK;
}

#endif
