/* Composites: what is built from quantities - elements (springs, dampers, drives), function rows,
   velocity rows and potentials.

   A composite's discrete gradient is sum_f g_f grad s_f(q_m), g_f = sum_l N_l p_lf: N_l is the
   slope of the law or function with respect to leaf l, p_lf that of the leaf with respect to form
   f. Every slope is exact over the step, so the products are (discrete chain rule), and the forms'
   invariance carries over to momenta. */
#ifndef HOLONOM_COMPOSITE_H
#define HOLONOM_COMPOSITE_H

#include "body_turns.h"
#include "forms.h"

/* A form of the composite at hand, in the scratch `local`. */
typedef struct local_form {
    double um[DIM], wm[DIM], u1[DIM], w1[DIM], s0, s1, ds;
} local_form;

/* A leaf of the composite at hand: values at both ends, slopes p with respect to its forms, their
   derivatives e and curve with respect to the forms at the end, and the function's slope at the
   end. */
typedef struct leaf_state {
    double x0, x1, dx, p[2], e[2], curve[4], n_end;
} leaf_state;

_Static_assert(sizeof(local_form) <= (4 * DIM + 3) * sizeof(double), "scratch of a form");
_Static_assert(sizeof(leaf_state) <= 12 * sizeof(double), "scratch of a leaf");

typedef struct composite_result {
    double row;        /* C(d) of a row */
    double change;     /* of a function over the step */
    double mechanical; /* of this, by the quantities: work of a unit multiplier. Of an element: its
                          elongation */
} composite_result;

static inline int32_t first_function(const context *c) { return c->m->n_elements; }
static inline int32_t first_velocity_row(const context *c)
{ return first_function(c) + c->m->n_function_rows; }
static inline int32_t first_potential(const context *c)
{ return first_velocity_row(c) + c->m->n_velocity_rows; }
static inline int32_t n_composites(const context *c)
{ return first_potential(c) + c->m->n_potentials; }

static inline int is_row(const context *c, int32_t j)
{ return j >= first_function(c) && j < first_potential(c); }

static inline int is_velocity_row(const context *c, int32_t j)
{
    return j >= first_velocity_row(c) && j < first_potential(c);
}

/* Place of a composite's row among all rows. */
static inline int32_t row_of(const context *c, int32_t j)
{ return first_function_row(c->m) + (j - first_function(c)); }

/* Whether composite j follows a signal. */
static int has_signal(const context *c, int32_t j)
{
    for (int32_t l = c->m->leaf_ptr[j]; l < c->m->leaf_ptr[j + 1] && c->m->n_signals; l++)
        if (c->m->leaf[4 * l] == LEAF_SIGNAL) return 1;
    return 0;
}

/* Links and values of the forms of composite j, gradients to be taken at q_n + theta d. */
static void set_local_forms(const context *c, int32_t j, double theta)
{
    const holonom_model *m = c->m;
    local_form *local = (local_form *)c->k.local;
    for (int32_t at = m->composite_form_ptr[j]; at < m->composite_form_ptr[j + 1]; at++, local++) {
        motion g;
        form_motion(c, m->composite_form[at], &g);
        EACH(k) local->um[k] = g.u0[k] + theta * g.du[k];
        EACH(k) local->wm[k] = g.w0[k] + theta * g.dw[k];
        EACH(k) local->u1[k] = g.u0[k] + g.du[k];
        EACH(k) local->w1[k] = g.w0[k] + g.dw[k];
        local->s0 = dot(g.u0, g.w0);
        local->s1 = dot(local->u1, local->w1);
        local->ds = g.ds;
    }
}

/* sqrt(s) of a form: the slope of the length over the step, and at its end. */
static int32_t set_length(double s0, double s1, double ds, leaf_state *leaf)
{
    if (!(s0 > 0.0) || !(s1 > 0.0)) return HOLONOM_ZERO_LENGTH;
    const double sum = (leaf->x0 = sqrt(s0)) + (leaf->x1 = sqrt(s1));
    leaf->p[0] = 1.0 / sum;
    leaf->dx = ds / sum; /* not x1 - x0: that would cancel */
    leaf->e[0] = 0.5 / leaf->x1;
    leaf->curve[0] = -leaf->e[0] / (sum * sum);
    return HOLONOM_OK;
}

/* Angle of (c, s): with X = c_0 s_1 - s_0 c_1 and Y = c_0 c_1 + s_0 s_1 it grows by atan2(X, Y) = g
   X, and X = c_m ds - s_m dc, so that its slopes are g (-s_m, c_m). */
static int32_t set_angle(const double *first, const double *change, double theta0, int point,
                         leaf_state *leaf)
{
    const double c1 = first[0] + change[0], s1 = first[1] + change[1];
    const double c0 = point ? c1 : first[0], s0 = point ? s1 : first[1];
    const double dc = point ? 0.0 : change[0], ds = point ? 0.0 : change[1];
    const double cm = 0.5 * (c0 + c1), sm = 0.5 * (s0 + s1);
    const double x = cm * ds - sm * dc, y = c0 * c1 + s0 * s1, radius2 = x * x + y * y;
    if (!(radius2 > 0.0)) return HOLONOM_ZERO_LENGTH;
    const double g = hm_angle_over(x, y), bend = hm_angle_over_bend(x, y, g); /* dg/dX = bend X */
    const double g_c = -bend * x * s0 - c0 / radius2, g_s = bend * x * c0 - s0 / radius2,
                 end2 = c1 * c1 + s1 * s1;
    leaf->dx = g * x;
    leaf->x0 = theta0;
    if (point) leaf->x0 += hm_atan2(first[0] * s1 - first[1] * c1, first[0] * c1 + first[1] * s1);
    leaf->x1 = leaf->x0 + leaf->dx;
    leaf->p[0] = -g * sm;
    leaf->p[1] = g * cm;
    leaf->e[0] = -s1 / end2;
    leaf->e[1] = c1 / end2;
    leaf->curve[0] = -sm * g_c;
    leaf->curve[1] = -sm * g_s - 0.5 * g;
    leaf->curve[2] = cm * g_c + 0.5 * g;
    leaf->curve[3] = cm * g_s;
    return HOLONOM_OK;
}

/* Quantity of one leaf that is no form over the step; `point`: derivatives at the end instead of
   slopes over the step. */
static int32_t set_curved_leaf(const context *c, const int32_t *entry, int point, leaf_state *leaf)
{
    const int32_t q = entry[1], kind = c->m->quantity_kind[q];
    const local_form *form = (const local_form *)c->k.local + entry[2];
    int32_t status = HOLONOM_OK;
    if (kind == QUANTITY_LENGTH)
        status = set_length(point ? form->s1 : form->s0, form->s1, point ? 0.0 : form->ds, leaf);
    else {
        const local_form *sine = (const local_form *)c->k.local + entry[3];
        const double first[2] = {form->s0, sine->s0}, change[2] = {form->ds, sine->ds};
        status = set_angle(first, change, c->k.sigma0[q], point, leaf);
    }
    for (int i = 0; point && i < (kind == QUANTITY_ANGLE ? 4 : 1); i++)
        leaf->curve[i] *= 2.0; /* both ends move */
    return status;
}

/* Likewise of any leaf. */
HM_OFTEN int32_t set_leaf(const context *c, const int32_t *entry, int point, leaf_state *leaf)
{
    if (c->m->quantity_kind[entry[1]] != QUANTITY_FORM)
        return set_curved_leaf(c, entry, point, leaf);
    const local_form *form = (const local_form *)c->k.local + entry[2];
    leaf->x0 = point ? form->s1 : form->s0;
    leaf->x1 = form->s1;
    leaf->dx = point ? 0.0 : form->ds;
    leaf->p[0] = leaf->e[0] = 1.0;
    leaf->curve[0] = 0.0;
    return HOLONOM_OK;
}

/* Momentum += factor times slopes of the forms of composite j at hand. */
HM_OFTEN void add_slopes(const context *c, int32_t j, double factor, const double *slope)
{
    const local_form *local = (const local_form *)c->k.local;
    for (int32_t at = c->m->composite_form_ptr[j], f = 0; at < c->m->composite_form_ptr[j + 1];
         at++, f++)
        add_gradient(c, c->m->composite_form[at], factor * slope[f], local[f].um, local[f].wm,
                     c->k.momentum);
}

/* Slips of one friction have the same forms: their slopes, times factors, are summed before they
   are added. */
static void sum_slopes(const context *c, int32_t j, double factor, int is_first)
{
    const int32_t forms = c->m->composite_form_ptr[j + 1] - c->m->composite_form_ptr[j];
    for (int32_t f = 0; f < forms; f++)
        c->k.slope_sum[f] = (is_first ? 0.0 : c->k.slope_sum[f]) + factor * c->k.slope[f];
}

/* Places of the composite's free entries, form by form, among its nodes. */
static inline const int32_t *places_of(const context *c, int32_t j)
{
    return c->m->composite_local + c->m->composite_local_ptr[j];
}

/* Places of the composite's free nodes among the components of its unknowns (overwritten); returns
   the number of these. */
static int32_t local_places(const context *c, int32_t j, int32_t *place)
{
    const int32_t *node = c->m->composite_node + c->m->composite_node_ptr[j],
                  *end = c->m->composite_node + c->m->composite_node_ptr[j + 1];
    int32_t size = 0, next = 0;
    for (; node < end; node++) {
        if (*node >= next)
            size += unknown_size(c, *node), next = next_unknown(c, first_of_unknown(c, *node));
        *place++ = size - unknown_size(c, *node);
    }
    return size;
}

static inline int32_t *local_place(const context *c) { return (int32_t *)(void *)c->k.place; }

/* Gradients of the composite's forms at the theta and at the end, over the unknowns of its free
   nodes, or over these nodes; returns their number. */
static int32_t local_gradients(const context *c, int32_t j, int over_nodes)
{
    const holonom_model *m = c->m;
    const int32_t *local = places_of(c, j);
    int32_t *place = local_place(c), size = 0;
    if (!over_nodes) size = local_places(c, j, place);
    else
        for (int32_t at = m->composite_node_ptr[j]; at < m->composite_node_ptr[j + 1]; at++)
            *place++ = size, size += DIM;
    place = local_place(c);
    const int32_t forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
    const local_form *form = (const local_form *)c->k.local;
    memset(c->k.gradient, 0, sizeof(double) * (size_t)(forms * size));
    memset(c->k.gradient_end, 0, sizeof(double) * (size_t)(forms * size));
    for (int32_t i = 0; i < forms; i++, form++) {
        const int32_t f = m->composite_form[m->composite_form_ptr[j] + i];
        for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++) {
            const int32_t at = size * i + place[*local++];
            double g[DIM];
            entry_gradient(c, f, e, form->um, form->wm, g);
            const int own = over_nodes ? DIM : to_unknown(c, m->form_node[e], c->k.middle, g);
            for (int k = 0; k < own; k++) c->k.gradient[at + k] += g[k];
            entry_gradient(c, f, e, form->u1, form->w1, g);
            if (!over_nodes) to_unknown(c, m->form_node[e], c->k.turned, g);
            for (int k = 0; k < own; k++) c->k.gradient_end[at + k] += g[k];
        }
    }
    return size;
}

/* Law of element j: N = k (sigma_m - rest) + c dsigma/h - drive along its quantity. Its work is
   then exactly -dV - c dsigma^2/h + drive dsigma (Gonzalez 2000; paper, eq 11). */
static int32_t element_law(const context *c, int32_t j, int tangent, composite_result *result)
{
    const holonom_model *m = c->m;
    const double stiffness = c->number[m->stiffness_at + j], rest = c->number[m->rest_at + j];
    const double damping = is_seeking(c) ? 0.0 : c->number[m->damping_at + j];
    const double drive = c->number[m->drive_at + j];
    const int32_t *entry = m->leaf + 4 * m->leaf_ptr[j];
    const int is_length = m->quantity_kind[entry[1]] == QUANTITY_LENGTH;
    leaf_state leaf;
    if (!(stiffness >= 0.0 && damping >= 0.0 && (rest >= 0.0 || !is_length)
          && fabs(drive) < INFINITY))
        return HOLONOM_BAD_LAW;
    const int32_t n = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
    if (tangent) memset(c->k.curve, 0, sizeof(double) * (size_t)(n * n));
    result->mechanical = 0.0;
    if (is_length && rest == 0.0 && damping == 0.0
        && drive == 0.0) { /* V = k s/2: no direction is needed */
        c->k.slope[0] = 0.5 * stiffness;
        return HOLONOM_OK;
    }
    const int32_t status = set_leaf(c, entry, is_seeking(c), &leaf);
    if (status) return status;
    const double force =
        stiffness * (leaf.x0 + 0.5 * leaf.dx - rest) + damping * leaf.dx / c->h - drive;
    const double slope = stiffness * c->step.theta + damping / c->h;
    const int32_t local[2] = {entry[2], entry[3]};
    result->mechanical = leaf.dx;
    for (int32_t f = 0; f < n; f++) c->k.slope[f] = 0.0;
    for (int f = 0; f < 2 && local[f] >= 0; f++) c->k.slope[local[f]] = force * leaf.p[f];
    if (!tangent) return HOLONOM_OK;
    for (int f = 0; f < 2 && local[f] >= 0; f++)
        for (int g = 0; g < 2 && local[g] >= 0; g++)
            c->k.curve[n * local[f] + local[g]] =
                force * leaf.curve[2 * f + g] + slope * leaf.p[f] * leaf.e[g];
    return HOLONOM_OK;
}

/* Quantity j from its forms s, an angle on the turn that the state is on. */
static double quantity_of(const context *c, int32_t j, const double *s)
{
    const int32_t kind = c->m->quantity_kind[j];
    if (kind == QUANTITY_FORM) return s[0];
    if (kind == QUANTITY_LENGTH) return sqrt(s[0]);
    return hm_atan2(s[1] + 0.0, s[0])
           + 6.283185307179586477 * c->s.turns[j]; /* + 0.0: no negative zero */
}

/* Quantity j at the configuration (x, x_low) and, if wanted, its rate with velocities v. One whose
   direction is undefined has no rate: a length zero, an angle of a vector zero. */
HM_SELDOM static double quantity_at(const context *c, int32_t j, const double *x,
                                    const double *x_low, const double *v, double *rate)
{
    const holonom_model *m = c->m;
    const int32_t kind = m->quantity_kind[j], *form = m->quantity_form + 2 * j;
    double s[2] = {0.0, 0.0}, s_dot[2] = {0.0, 0.0}, u[DIM], w[DIM], vu[DIM], vw[DIM];
    for (int i = 0; i < (kind == QUANTITY_ANGLE ? 2 : 1); i++) {
        link_at(c, form[i], x, x_low, u, w);
        s[i] = dot(u, w);
        if (!rate) continue;
        link_of(c, form[i], v, vu, vw);
        s_dot[i] = dot(u, vw) + dot(w, vu);
    }
    const double value = quantity_of(c, j, s), size2 = s[0] * s[0] + s[1] * s[1];
    if (!rate) return value;
    if (kind == QUANTITY_FORM) *rate = s_dot[0];
    else if (kind == QUANTITY_LENGTH) *rate = value > 0.0 ? 0.5 * s_dot[0] / value : 0.0;
    else *rate = size2 > 0.0 ? (s[0] * s_dot[1] - s[1] * s_dot[0]) / size2 : 0.0;
    return value;
}

/* Links of some forms at the state, which is the beginning of the step, and the quantities they
   make. */
HM_OFTEN void links_of_parts(const context *c, int linked, int active)
{
    const holonom_model *m = c->m;
    const int touches = linked == ISLAND_TOUCHING_LINKED;
    for (int32_t i = c->view.begin[linked];
         (i = touches ? next_near(c, NEAR_LINKED, i) : i) < c->view.end[linked]; i++) {
        const int32_t f = m->linked_form[i];
        link_at_state(c, f, c->k.u0 + DIM * f, c->k.w0 + DIM * f);
    }
    for (int32_t j = c->view.begin[active];
         (j = touches ? next_near(c, NEAR_ACTIVE, j) : j) < c->view.end[active]; j++) {
        double s[2] = {0.0, 0.0};
        for (int i = 0; i < (m->quantity_kind[j] == QUANTITY_ANGLE ? 2 : 1); i++) {
            const int32_t f = m->quantity_form[2 * j + i];
            s[i] = dot(c->k.u0 + DIM * f, c->k.w0 + DIM * f);
        }
        c->k.sigma0[j] = quantity_of(c, j, s);
    }
}

/* Likewise of all that the step needs. */
static void links_at_start(const context *c)
{
    for (int32_t f = 0; f < c->m->n_forms && !hm_skips(SKIP_MEASURED_FORMS);
         f++) /* what is only measured, too */
        link_at_state(c, f, c->k.u0 + DIM * f, c->k.w0 + DIM * f);
    links_of_parts(c, ISLAND_LINKED, ISLAND_ACTIVE);
    if (!c->view.asleep || c->step.changes_contacts)
        links_of_parts(c, ISLAND_TOUCHING_LINKED, ISLAND_TOUCHING_ACTIVE);
}

#endif
