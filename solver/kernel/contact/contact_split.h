/* How contacts at rest and joints that rub share their forces. The multipliers of rows that hold
   the same thing twice are one split of many, and may lie outside the cones while others do not:
   what sticks holds as long as there is one inside (rest_split.h).

   Parts of a split are closed contacts, those that slide as rays (1, -c d), and frictions of joints
   that stick, inside the cone |T| <= L of their limit L = c N + preload. With W = G M^-1 G' of
   their rows, reduced by the bilateral rows, all splits x of the forces p at hand have the same
   accelerations, and limits that are linear in x while the forces that press keep their directions.
   B has orthonormal rows that span those of these equations: B x = B p. What bilateral rows hold is
   no equation, and their forces are what they have to be: one contact alone may have many splits
   beside a joint. */
#ifndef HOLONOM_CONTACT_SPLIT_H
#define HOLONOM_CONTACT_SPLIT_H

#include "impact.h"
#include "rest_split.h"

#define SAME_ROW 1e-10   /* pivot of rows of size 1 that counts as zero */
#define NO_LOAD 1e-12 /* part of the forces at hand that is left of them where they hold nothing
                         \ */
#define STILL_MOVES                                                                                \
    1e-12 /* rate of a row that should have none, over that without other rows: it is solved for   \
             anew above */
#define WELL_INSIDE                                                                                \
    1e-7 /* of the coefficients: a split that is so far inside its cones if there is one stays     \
            inside as it is */
#define SLIPS 1e-6       /* rate over the largest one that counts as a slip */

/* A split over the scratch `rest`. Its parts have rows, the units, and forces, the columns of the
   equations. */
typedef struct shared_forces {
    rest_split split;
    int32_t units, joints;  /* joints: parts that are frictions of joints */
    int32_t *contact;       /* of each part; of friction f of a joint -1 - f */
    int32_t *unit, *first, *tangents, *order;
    int32_t *row;           /* composite of each unit */
    double *ray;            /* of each unit: part of the force of its ray, 1 elsewhere */
    double *W, *A, *B;      /* units x units; rows x equations; that of the split */
    double *limit;          /* of each part and unit: derivative of the limit of a joint */
    double *p, *weight, *coefficient, *g, *head;
} shared_forces;

HM_SELDOM static shared_forces map_shared(const context *c)
{
    const int64_t n = c->m->n_hit_rows;
    double *d = c->k.rest, *v = d + 5 * n * n;
    int32_t *i = (int32_t *)(void *)(v + 13 * n);
    shared_forces x = {.W = d,
                       .A = d + n * n,
                       .B = d + 3 * n * n,
                       .limit = d + 2 * n * n,
                       .p = v,
                       .weight = v + 2 * n,
                       .coefficient = v + 3 * n,
                       .g = v + 4 * n,
                       .head = v + 5 * n,
                       .ray = v + 6 * n,
                       .contact = i,
                       .unit = i + n,
                       .first = i + 2 * n,
                       .tangents = i + 3 * n,
                       .order = i + 4 * n,
                       .row = i + 5 * n};
    x.split = (rest_split){.first = x.first,
                           .tangents = x.tangents,
                           .coefficient = x.coefficient,
                           .B = x.B,
                           .g = x.g,
                           .force = v + 7 * n,
                           .dual = v + 8 * n,
                           .way = v + 9 * n,
                           .defect = v + 10 * n,
                           .trial = v + 11 * n,
                           .base = v + 12 * n,
                           .matrix = d + 4 * n * n};
    return x;
}

static double sigma_of(const context *c, int32_t j)
{ return c->number[c->m->row_sigma_at + row_of(c, j)]; }

/* Whether friction f holds, as far as there is one. */
static int is_stuck(const context *c, int32_t f)
{ return f >= 0 && friction_mode(c, f) == FRICTION_STICKS; }

/* Adds a part with its weight, coefficient and tangents, whose units follow. */
HM_SELDOM static void add_part(shared_forces *x, int32_t contact, int32_t tangents, double weight,
                               double coefficient)
{
    rest_split *s = &x->split;
    const int32_t k = s->contacts++;
    x->contact[k] = contact;
    x->unit[k] = x->units;
    x->first[k] = s->rows;
    x->tangents[k] = tangents;
    x->coefficient[k] = coefficient;
    for (int32_t l = 0; l <= tangents; l++) x->weight[s->rows++] = weight;
}

static void add_unit(shared_forces *x, int32_t row, double ray)
{
    x->ray[x->units] = ray;
    x->row[x->units++] = row;
}

/* Collects closed contacts and frictions of joints that stick; 0 if they cannot share forces. */
HM_SELDOM static int collect_shared(const context *c, shared_forces *x)
{
    const holonom_model *m = c->m;
    for (int32_t i = 0; i < m->n_contacts; i++) {
        const int32_t f = m->contact_friction[i],
                      mode = f >= 0 ? friction_mode(c, f) : FRICTION_OFF;
        const int32_t slips = mode == FRICTION_OFF ? 0 : n_slips(c, f),
                      slides = mode == FRICTION_SLIDES;
        double size2 = 1.0;
        if (!is_closed(c, i)) continue;
        if (slips
            && (m->normal_ptr[f + 1] != m->normal_ptr[f] + 1
                || c->number[m->preload_at + f] != 0.0))
            return 0;
        if (x->units + 1 + slips > m->n_hit_rows) return 0;
        const double along = slides ? -c->number[m->sliding_at + f] : 1.0,
                     *way = f >= 0 ? friction_of(c, f) + F_ALONG_1 : NULL;
        for (int k = 0; k < slips && slides; k++) size2 += hm_square(along * way[k]);
        add_part(x, i, slides ? 0 : slips, size2 * sigma_of(c, m->contact_row[i]),
                 mode == FRICTION_STICKS ? c->number[m->static_at + f] : 0.0);
        add_unit(x, m->contact_row[i], 1.0);
        for (int k = 0; k < slips; k++)
            add_unit(x, slip_row(c, f, k), slides ? along * way[k] : 1.0);
    }
    for (int32_t f = 0; f < m->n_frictions; f++) {
        const int32_t slips = n_slips(c, f);
        if (is_of_contact(c, f) || !is_stuck(c, f)) continue;
        if (x->units + x->joints + 1 + slips > m->n_hit_rows) return 0;
        add_part(x, -1 - f, slips, sigma_of(c, slip_row(c, f, 0)), 1.0);
        for (int k = 0; k < slips; k++) add_unit(x, slip_row(c, f, k), 1.0);
        x->joints++;
    }
    return x->split.contacts > 1 || (x->split.contacts && c->factors.may_share);
}

/* What the limit of friction f, less its preload, is with multipliers mu if the forces that press
   have the directions of those in rest_mu: no more than it is. */
HM_SELDOM static double limit_along(const context *c, int32_t f, const double *mu)
{
    const holonom_model *m = c->m;
    double sum = 0.0, root = 0.0;
    for (int32_t at = m->normal_ptr[f]; at < m->normal_ptr[f + 1]; at++) {
        const int32_t row = m->normal_row[2 * at], how = m->normal_row[2 * at + 1];
        if (how == NORMAL_BEGINS) sum_of_squares(c, f, at, c->k.rest_mu, &root);
        sum += how == NORMAL_PUSHES ? -mu[row]
               : root > 0.0         ? c->k.rest_mu[row] / root * mu[row]
                                    : 0.0;
    }
    return c->number[m->static_at + f] * sum;
}

/* Takes from the velocities x that a unit force brings about, with the multipliers in mu, what rows
   that hold leave of them by rounding, as far from where moments of a joint are measured: W tells
   by its digits which rows depend on each other. */
HM_SELDOM static void hold_rows(const context *c, double *x)
{
    const int32_t rows = c->m->n_rows;
    const double *sigma = c->number + c->m->row_sigma_at,
                 least = STILL_MOVES * sqrt(fmax(0.0, mass_product(c, x, x)));
    double *mu = c->k.row_rate, *more = c->k.ahead;
    int is_held = 1;
    memset(c->k.signal_before, 0, sizeof(double) * (size_t)c->m->n_signals);
    row_rates(c, x, c->k.signal_before, c->k.phi);
    EACH_ROW(c, i) is_held &= fabs(c->k.phi[i]) <= least * sqrt(sigma[i]);
    if (is_held) return;
    memcpy(mu, c->k.mu, sizeof(double) * (size_t)rows);
    velocities_for(c, more);
    for (int32_t k = 0; k < DIM * c->n_moving; k++) x[k] += more[k];
    for (int32_t i = 0; i < rows; i++) c->k.mu[i] += mu[i];
}

/* W, and what units do to limits. What shares its forces is off, w and modes are to be put back. */
HM_SELDOM static int32_t fill_shared(context *c, const shared_forces *x)
{
    const int32_t n = x->units;
    for (int32_t i = 0; i < c->m->n_contacts; i++) open_contact(c, i);
    for (int32_t k = 0; k < x->split.contacts; k++)
        if (x->contact[k] < 0) friction_of(c, -1 - x->contact[k])[F_MODE] = FRICTION_OFF;
    stand_still(c);
    c->friction.cone_mu = c->k.event_mu;
    int32_t status = factorise_at_state(c);
    c->friction.cone_mu = c->k.mu;
    for (int32_t u = 0; u < n && !status; u++) {
        status = find_reach(c, x->row[u], u);
        hold_rows(c, c->k.hit_reach + (int64_t)DIM * c->n_moving * u);
        for (int32_t k = 0; k < x->split.contacts && x->joints; k++)
            x->limit[n * k + u] =
                x->contact[k] < 0 ? limit_along(c, -1 - x->contact[k], c->k.mu) : 0.0;
    }
    if (!status) status = fill_matrix(c, n, x->row, x->W);
    for (int32_t u = 0; u < n && !status; u++) {
        if (x->W[(n + 1) * u] > HELD * stiffness_alone(c, x->row[u])) continue;
        for (int32_t v = 0; v < n; v++) x->W[n * u + v] = x->W[n * v + u] = 0.0;
    }
    return status;
}

/* What the force of column l of part k does to a row of values of units. */
static double sum_of_column(const shared_forces *x, int32_t k, int32_t l, const double *value)
{
    const int32_t unit = x->unit[k];
    if (x->contact[k] < 0) return l ? value[unit + l - 1] : 0.0;
    if (x->tangents[k]) return value[unit + l];
    const int32_t end = k + 1 < x->split.contacts ? x->unit[k + 1] : x->units;
    double sum = 0.0;
    for (int32_t u = unit; u < end; u++) sum += x->ray[u] * value[u];
    return sum;
}

/* Forces of parts (x->p, overwritten), times the roots of their weights, of multipliers mu. */
HM_SELDOM static void take_forces(const context *c, const shared_forces *x, const double *mu)
{
    for (int32_t k = 0; k < x->split.contacts; k++) {
        const int32_t f = -1 - x->contact[k], is_joint = f >= 0;
        for (int32_t l = 0; l <= x->tangents[k]; l++) {
            const int32_t at = x->first[k] + l;
            const double force = is_joint && !l
                                     ? limit_along(c, f, mu) + c->number[c->m->preload_at + f]
                                     : -mu[row_of(c, x->row[x->unit[k] + l - is_joint])];
            x->p[at] = sqrt(x->weight[at]) * force;
        }
    }
}

/* Equation e of the parts, of size 1: no other acceleration along a unit, or the limit of a joint
   (part k). The rows of what others hold are 0. */
HM_SELDOM static void add_equation(const shared_forces *x, int32_t e, int32_t equations, int32_t k)
{
    const rest_split *s = &x->split;
    const double *value = e < x->units ? x->W + x->units * e : x->limit + x->units * k;
    double size2 = 0.0;
    for (int32_t j = 0; j < s->contacts; j++)
        for (int32_t l = 0; l <= x->tangents[j]; l++) {
            const int32_t column = x->first[j] + l;
            double sum = sum_of_column(x, j, l, value);
            if (e >= x->units) sum = (j == k && !l) - sum;
            x->A[equations * column + e] = sum /= sqrt(x->weight[column]);
            size2 += sum * sum;
        }
    for (int32_t column = 0; column < s->rows; column++)
        x->A[equations * column + e] /= size2 > 0.0 ? sqrt(size2) : 1.0;
}

HM_SELDOM static void equations_of_split(const shared_forces *x, rest_split *s)
{
    const int32_t n = s->rows, equations = x->units + x->joints;
    double *line = s->way;
    for (int32_t e = 0; e < x->units; e++) add_equation(x, e, equations, -1);
    for (int32_t k = 0, e = x->units; k < s->contacts; k++)
        if (x->contact[k] < 0) add_equation(x, e++, equations, k);
    s->rank = hm_triangulate(n, equations, x->A, x->head, x->order, SAME_ROW);
    for (int32_t k = 0; k < s->rank; k++) {
        for (int32_t l = 0; l < n; l++) line[l] = l == k ? 1.0 : 0.0;
        hm_reflect(n, equations, s->rank, x->A, x->head, 1, line);
        for (int32_t l = 0; l < n; l++) x->B[n * k + l] = line[l];
    }
}

/* Forces p of multipliers mu, and g = B p over its size, which it returns: 0 where others hold all
   that is to be held. */
HM_SELDOM static double forces_to_split(const context *c, const shared_forces *x, const double *mu)
{
    const rest_split *s = &x->split;
    double size2 = 0.0, whole2 = 0.0;
    take_forces(c, x, mu);
    for (int32_t l = 0; l < s->rows; l++) whole2 += hm_square(x->p[l]);
    for (int32_t k = 0; k < s->rank; k++) {
        x->g[k] = 0.0;
        for (int32_t l = 0; l < s->rows; l++) x->g[k] += s->B[s->rows * k + l] * x->p[l];
        size2 += x->g[k] * x->g[k];
    }
    const double size = size2 > hm_square(NO_LOAD) * whole2 ? sqrt(size2) : 0.0;
    for (int32_t k = 0; k < s->rank; k++) x->g[k] = size > 0.0 ? x->g[k] / size : 0.0;
    return size;
}

HM_SELDOM static void forget_shares(context *c)
{
    if (!has_shares(c)) return;
    c->s.head[S_SHARES] = 0.0;
    memset(c->s.shift, 0, sizeof(double) * (size_t)c->m->n_rows);
}

/* Adds to mu what the split at hand, of forces of this size, changes of p, and of bilateral rows,
   too. */
HM_SELDOM static int32_t add_reshare(const context *c, const shared_forces *x, double size,
                                     double *mu)
{
    const rest_split *s = &x->split;
    int32_t status = HOLONOM_OK;
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t k = 0; k < s->contacts; k++) {
        const int32_t is_joint = x->contact[k] < 0,
                      end = k + 1 < s->contacts ? x->unit[k + 1] : x->units;
        for (int32_t u = x->unit[k]; u < end && !status; u++) {
            const int32_t at = x->first[k] + (x->tangents[k] ? u - x->unit[k] + is_joint : 0);
            const double force = x->ray[u] * (size * s->force[at] - x->p[at]) / sqrt(x->weight[at]);
            mu[row_of(c, x->row[u])] -= force;
            status = add_row_gradient(c, x->row[u], -force);
        }
    }
    if (status) return status;
    velocities_of_impulses(c, c->k.hit_reach);
    for (int32_t i = 0; i < c->m->n_rows; i++) mu[i] += c->k.mu[i];
    return HOLONOM_OK;
}

/* Whether there is a split, that of well inside the cones if there is one. */
HM_SELDOM static int is_held_together(const context *c, const rest_split *s)
{
    return has_split(s, 1.0 - WELL_INSIDE)
           || (!c->event.gives_way && has_split(s, 1.0 + CONE_MARGIN));
}

/* Lets half steps to come share forces as a split of those that the means of multipliers tell, if
   it is there. */
HM_SELDOM static int32_t share_forces(context *c, const shared_forces *x)
{
    const int32_t n = c->m->n_rows;
    forget_shares(c);
    extrapolate(c, c->t, n, c->s.mean, c->s.mean_before, c->k.rest_mean);
    const double size = forces_to_split(c, x, c->k.rest_mean);
    if (!is_held_together(c, &x->split)) return HOLONOM_OK;
    c->s.head[S_SHARES] = 1.0;
    return add_reshare(c, x, size, c->s.shift);
}

#define LARGEST_LOAD 1e3   /* load factors above count as none: no friction holds */
#define LOAD_ACCURACY 1e-12
#define FAR_BELOW                                                                                  \
    0.99 /* load factors below, which no event is near to, need no more than FEW_DIGITS */
#define FEW_DIGITS 1e-2

/* Least factor of all coefficients with which there is a split, or infinity; above 1 with this
   accuracy. */
static double load_factor(const rest_split *s, double above)
{
    double low = 0.0, high = 1.0;
    for (; !has_split(s, high); high *= 2.0)
        if (high > LARGEST_LOAD) return INFINITY;
        else low = high;
    while (high - low > (high < FAR_BELOW ? FEW_DIGITS
                         : low >= 1.0     ? above
                                          : LOAD_ACCURACY)
                            * high) {
        const double middle = 0.5 * (low + high);
        if (has_split(s, middle)) high = middle;
        else low = middle;
    }
    return high;
}

/* What parts that hold something twice do, whose multipliers are not all inside the cones. */
enum togetherness {
    NOT_TOGETHER, /* they hold nothing twice, or no forces inside cones of any width do */
    HOLD,         /* by forces inside the cones, which they share now */
    GIVE_WAY,     /* there are none */
    LET_SLIDE     /* likewise, and joints among them have been let slide */
};

/* Lets frictions slide that slip in the motion that the dual without bound is, with y for
   velocities and rates B'y: in it the forces at hand do more work than any inside the cones.
   Returns whether there is one. */
HM_SELDOM static int slip_together(context *c, const shared_forces *x)
{
    const rest_split *s = &x->split;
    double largest = 0.0;
    int slides = 0;
    for (int32_t l = 0; l < s->rows; l++) {
        x->p[l] = 0.0;
        for (int32_t k = 0; k < s->rank; k++) x->p[l] += s->B[s->rows * k + l] * s->dual[k];
        largest = fmax(largest, fabs(x->p[l]));
    }
    for (int32_t k = 0; k < s->contacts; k++) {
        const double *rate = x->p + x->first[k];
        const double size = x->tangents[k] ? hm_length(x->tangents[k], rate + 1) : 0.0;
        double along[3] = {0.0, 0.0, 0.0};
        if (!(size > SLIPS * largest)) continue;
        for (int32_t l = 1; l <= x->tangents[k]; l++) along[l - 1] = -rate[l] / size;
        let_slide(c, x->contact[k] < 0 ? -1 - x->contact[k] : c->m->contact_friction[x->contact[k]],
                  along);
        slides = 1;
    }
    return slides;
}

enum {
    MOST_DIRECTIONS = 20 /* of the forces that press joints, in turn */,
    MOST_ROUND = 3 /* joints whose forces may turn round */
};

/* Takes the forces at hand for those that press, of joint k of the split with bit k of `turned` the
   opposite ones: a contact that pushes harder may turn them round. */
HM_SELDOM static void press_as(const context *c, const shared_forces *x, int32_t turned)
{
    const holonom_model *m = c->m;
    memcpy(c->k.rest_mu, c->k.event_mu, sizeof(double) * (size_t)m->n_rows);
    for (int32_t k = 0; k < x->split.contacts; k++) {
        const int32_t f = -1 - x->contact[k];
        if (f < 0) continue;
        for (int32_t at = m->normal_ptr[f]; at < m->normal_ptr[f + 1] && (turned & 1); at++)
            c->k.rest_mu[m->normal_row[2 * at]] = -c->k.event_mu[m->normal_row[2 * at]];
        turned >>= 1;
    }
}

/* Seeks a split, and with `load` or joints the least factor of all coefficients with which there is
   one (in `least`, above 1 with the accuracy `above`); the size of its forces. Forces that press
   joints turn as they are shared, which a split with that factor tells: with their new directions
   limits are no less than before. */
HM_SELDOM static int32_t seek_split(context *c, shared_forces *x, const double *load, double above,
                                    int *inside, double *least, double *size)
{
    rest_split *s = &x->split;
    double before;
    *least = INFINITY;
    for (int time = 0;; time++) {
        int32_t status = fill_shared(c, x);
        if (status) return status;
        equations_of_split(x, s);
        *size = forces_to_split(c, x, c->k.event_mu);
        if (s->rank == s->rows) return HOLONOM_OK; /* there is one split */
        before = *least;
        if (load) *least = *size > 0.0 ? load_factor(s, above) : 0.0;
        if (load && *least > 1.0 + CONE_MARGIN && has_split(s, 1.0 - WELL_INSIDE))
            *least = 1.0; /* forces near LARGEST_SPLIT */
        *inside = load ? *least <= 1.0 + CONE_MARGIN : is_held_together(c, s);
        if (*inside || !x->joints || time == MOST_DIRECTIONS) return HOLONOM_OK;
        if (!load) *least = load_factor(s, above);
        if (!(*least < before * (1.0 - LOAD_ACCURACY)) || !has_split(s, *least)) return HOLONOM_OK;
        memcpy(c->k.rest_mu, c->k.event_mu, sizeof(double) * (size_t)c->m->n_rows);
        if ((status = add_reshare(c, x, *size, c->k.rest_mu))) return status;
    }
}

/* Likewise, see hold_together, with what shares its forces off. */
HM_SELDOM static int32_t try_together(context *c, shared_forces *x, enum togetherness *how,
                                      double *load)
{
    rest_split *s = &x->split;
    const int32_t turn = x->joints == s->contacts ? 0
                         : x->joints < MOST_ROUND ? x->joints
                                                  : MOST_ROUND,
                  ways = 1 << turn;
    double size, least = INFINITY, factor;
    int inside = 0;
    for (int32_t turned = 0; turned < ways && !inside; turned++) {
        press_as(c, x, turned);
        const int32_t status =
            seek_split(c, x, load, turned ? FEW_DIGITS : LOAD_ACCURACY, &inside, &factor, &size);
        if (status || s->rank == s->rows) return status;
        least = fmin(least, factor);
    }
    if (load) *load = least;
    *how = inside ? HOLD : load && !(least < INFINITY) ? NOT_TOGETHER : GIVE_WAY;
    if (is_held_together(c, s) && inside) {
        const int32_t status = add_reshare(c, x, size, c->k.event_mu);
        return status ? status : share_forces(c, x);
    }
    if (inside || ways == 1) return HOLONOM_OK; /* the dual that is left tells what slips */
    press_as(c, x, 0);
    return seek_split(c, x, NULL, LOAD_ACCURACY, &inside, &factor, &size);
}

/* Finds out, of closed contacts and joints that rub, with the multipliers in event_mu. `load`, if
   wanted, is the least factor of all coefficients with which they would hold; else frictions of
   joints slide that give way. */
HM_SELDOM static int32_t hold_together(context *c, enum togetherness *how, double *load)
{
    const size_t modes = sizeof(double) * (size_t)c->s.n_modes;
    const size_t n = sizeof(double) * (size_t)(DIM * c->n_moving);
    double *kept = c->k.rest_modes, *w = kept + c->s.n_modes;
    shared_forces x = map_shared(c);
    *how = NOT_TOGETHER;
    if (!collect_shared(c, &x) || torn_loose(c, NULL) >= 0)
        return HOLONOM_OK; /* forces at hand do not hold: no others with the same sum do */
    memcpy(kept, c->s.contacts, modes);
    memcpy(w, c->k.w, n);
    const int32_t status = try_together(c, &x, how, load);
    memcpy(c->s.contacts, kept, modes);
    memcpy(c->k.w, w, n);
    if (!status && *how == GIVE_WAY && !load && x.joints)
        *how = slip_together(c, &x) ? LET_SLIDE : NOT_TOGETHER;
    return status;
}

#endif
