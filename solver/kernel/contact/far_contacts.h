/* Contacts that are far sleep: a step does not look at them until what moves has travelled so far
   that they might touch.

   The travel counts, over all steps, the way of the place that moved most; that of a director
   counts times the size of the mechanism. With coefficients alpha of a link u = sum alpha x, |u|
   changes in a travel s by no more than L_u s, L_u = sum |alpha| over the weight of the node; and a
   gap that is linear in lengths |u| and forms u . w by no more than

       a s + b s^2,     a = sum |c| L_u,  or  sum |c| (|u| L_w + |w| L_u),     b = sum |c| L_u L_w.

   An open contact sleeps until the travel at which that is its gap. Its rows, frictions, forms and
   quantities are in no list then. Others stay awake: gaps that angles, signals or curves tell. */
#ifndef HOLONOM_FAR_CONTACTS_H
#define HOLONOM_FAR_CONTACTS_H

#include "contact.h"

#define NEVER_SLEEPS -1e300 /* a state is finite */
/* Travels of a piece: with which contacts are looked at; with which one is then, so that it is not
   the next one; and that let it sleep. What moves may become twice as fast in a piece. */
#define WAKES 2.0
#define WAKES_AS_WELL 4.0
#define FALLS_ASLEEP 8.0
#define TRAVEL_ROUND_OFF 1e-15

/* Contacts: to look at fewer costs less than to follow the travel (one bouncing ball: 10 % of a
   step). */
enum { WORTH_SLEEP = 8 };

static inline int is_asleep(const context *c, int32_t i)
{ return contact_of(c, i)[C_ASLEEP_UNTIL] > 0.0; }

static inline int some_sleep(const context *c) { return c->s.head[S_NEXT_AWAKE] > 0.0; }

/* Travel that is left until the first contact might touch. */
static inline double travel_left(const context *c)
{ return c->s.head[S_NEXT_AWAKE] - c->s.head[S_TRAVEL]; }

/* Whether a piece of this travel may bring a contact near that sleeps, or contacts may fall
   asleep. */
static inline int asks_for_far(const context *c, double reach)
{
    return c->view.may_fall_asleep
           || (c->view.near[NEAR_CONTACTS] && !(travel_left(c) > WAKES * reach));
}

/* Wakes all contacts for good. */
static void wake_all(context *c)
{
    for (int32_t i = 0; i < n_contacts(c->m); i++) contact_of(c, i)[C_ASLEEP_UNTIL] = 0.0;
    c->s.head[S_TRAVEL] = c->s.head[S_NEXT_AWAKE] = 0.0;
    see_all(c);
}

/* Sets the travel to that of the state `start` and what has moved since then. */
static void follow_travel(context *c, const double *start)
{
    double *head = c->s.head, most2 = 0.0;
    const double *q = c->s.q, *q0 = start + (q - head),
                 extent2 = hm_square(c->number[c->m->extent_at]);
    if (!some_sleep(c)) return;
    for (int32_t a = 0; a < c->n_moving; a++, q += DIM, q0 += DIM) {
        double way[DIM];
        EACH(k) way[k] = q[k] - q0[k];
        double way2 = dot(way, way);
        if (c->m->node_kind[a]) way2 *= extent2;
        if (way2 > most2) most2 = way2;
    }
    const double travel = start[S_TRAVEL] + sqrt(most2);
    head[S_TRAVEL] = travel + TRAVEL_ROUND_OFF * travel;
}

/* How far the links of form f may go, per travel: of u and of w. */
static void stretch_of(const context *c, int32_t f, double *u, double *w)
{
    const holonom_model *m = c->m;
    const double extent = c->number[m->extent_at];
    const int32_t begin = m->form_ptr[f], end = begin + m->form_moving[f];
    *u = *w = 0.0;
    for (int32_t e = begin; e < end; e++) {
        const double weight = m->node_kind[m->form_node[e]] ? extent : 1.0;
        *u += fabs(c->number[m->alpha_at + e]) / weight,
            *w += fabs(c->number[m->beta_at + e]) / weight;
        if (!(m->form_kind[f] & FORM_TURNED)) continue;
        *u += fabs(c->number[m->alpha_turn_at + e]) / weight,
            *w += fabs(c->number[m->beta_turn_at + e]) / weight;
    }
    if (m->form_kind[f] & FORM_SQUARE) *w = *u;
}

/* Travel within which contact i stays open, and its gap at the state; 0 if it touches, -1 if
   nothing tells. */
static double safe_travel(const context *c, int32_t i, double *gap)
{
    const holonom_model *m = c->m;
    const int32_t j = m->contact_row[i], n = m->leaf_ptr[j + 1] - m->leaf_ptr[j],
                  *entry = m->leaf + 4 * m->leaf_ptr[j];
    double linear = 0.0, square = 0.0, u[DIM], w[DIM], along_u, along_w;
    const hm_registers *r = &c->k.r;
    if (!is_linear(c, j)) return -1.0;
    for (int32_t l = 0; l < n; l++) {
        if (entry[4 * l] != LEAF_VALUE || m->quantity_kind[entry[4 * l + 1]] == QUANTITY_ANGLE)
            return -1.0;
        r->r0[l] = r->r1[l] = quantity_at(c, entry[4 * l + 1], c->s.q, c->s.q_low, NULL, NULL);
        r->dr[l] = 0.0;
    }
    const double left = (*gap = value_of_leaves(c, j, 0)) - gap_tolerance(c);
    if (!(left > 0.0)) return 0.0;
    run_function(c, j);
    for (int32_t l = 0; l < n; l++) {
        const int32_t q = entry[4 * l + 1], f = m->quantity_form[2 * q];
        const double size = fabs(r->adjoint[l]);
        stretch_of(c, f, &along_u, &along_w);
        if (m->quantity_kind[q] == QUANTITY_LENGTH) {
            if (!(m->form_kind[f] & FORM_SQUARE)) return -1.0;
            linear += size * along_u;
            continue;
        }
        link_at_state(c, f, u, w);
        linear += size * (sqrt(dot(u, u)) * along_w + sqrt(dot(w, w)) * along_u);
        square += size * along_u * along_w;
    }
    linear = fmax(linear, 1.0); /* gaps are compared with the travel, too */
    const double root = sqrt(linear * linear + 4.0 * square * left);
    return 2.0 * left / (linear + root);
}

/* Whether nothing remembers forces of row j: they would be taken up where they were left. */
static int is_forgotten(const context *c, int32_t j)
{
    const int32_t i = row_of(c, j);
    int is = c->s.mu[0][i] == 0.0 && c->s.mu[1][i] == 0.0 && c->s.mu_before[0][i] == 0.0
             && c->s.mu_before[1][i] == 0.0 && c->s.mean[i] == 0.0 && c->s.mean_before[i] == 0.0
             && c->s.shift[i] == 0.0;
    for (int64_t k = 0; k < c->m->n_slots && is; k++)
        is = c->s.mu_missed[c->m->n_rows * k + i] == 0.0;
    return is;
}

static int is_free_of_force(const context *c, int32_t i)
{
    const int32_t f = c->m->contact_friction[i];
    if (is_closed(c, i) || !is_forgotten(c, c->m->contact_row[i])) return 0;
    for (int k = 0; f >= 0 && k < n_slips(c, f); k++)
        if (!is_forgotten(c, slip_row(c, f, k))) return 0;
    return 1;
}

/* ---------------------------------------------------------------------------------------- lists */

/* Leaves no forces and residuals of contact i: the step does not write them while it sleeps. */
static void clear_rows(const context *c, int32_t i)
{
    const int32_t f = c->m->contact_friction[i];
    for (int32_t k = -1; k < (f < 0 ? 0 : n_slips(c, f)); k++) {
        const int32_t row = row_of(c, k < 0 ? c->m->contact_row[i] : slip_row(c, f, k));
        c->k.mu[row] = c->k.lambda[row] = c->k.phi[row] = 0.0;
    }
}

/* Turns marks of begin .. end - 1, 0 of what is far, into the first index from each on that is
   near. */
static void link_list(int32_t *next, int32_t begin, int32_t end)
{
    next[end] = end;
    for (int32_t i = end - 1; i >= begin; i--) next[i] = next[i] ? i : next[i + 1];
}

/* Marks forms and quantities of composite j. */
static void mark_parts(const context *c, int32_t j, int32_t *form, int32_t *active)
{
    const holonom_model *m = c->m;
    for (int32_t l = m->composite_form_ptr[j]; l < m->composite_form_ptr[j + 1]; l++)
        form[m->composite_form[l]] = 1;
    for (int32_t l = m->leaf_ptr[j]; l < m->leaf_ptr[j + 1]; l++)
        if (m->leaf[4 * l] != LEAF_SIGNAL) active[m->leaf[4 * l + 1]] = 1;
}

/* Pieces of the islands at hand; `used` of all were there before. */
static int32_t add_slice(const context *c, near_slice *own, int32_t used)
{
    span *piece = (span *)(void *)c->k.near_pieces, *row = piece + used;
    int rows = bilateral_pieces(c, row), composites = 0;
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY; k++)
        EACH_ROW_OF_KIND(c, j, k) rows = add_piece(row, rows, row_of(c, j), row_of(c, j) + 1);
    span *composite = row + rows;
    composites =
        add_piece(composite, 0, c->view.begin[ISLAND_ELEMENT], c->view.end[ISLAND_ELEMENT]);
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY; k++)
        EACH_ROW_OF_KIND(c, j, k) composites = add_piece(composite, composites, j, j + 1);
    composites = add_piece(composite, composites, c->view.begin[ISLAND_POTENTIAL],
                           c->view.end[ISLAND_POTENTIAL]);
    *own = (near_slice){used, rows, used + rows, composites};
    return used + rows + composites;
}

/* The lists, from the start of the scratch. */
typedef struct near_lists {
    int32_t *contact, *friction, *row, *linked, *active;
} near_lists;

/* Lists where all sleep, and nothing else has function rows and frictions: from where islands begin
   on there is none. */
static void list_nothing(const context *c, near_lists x)
{
    const holonom_model *m = c->m;
    x.contact[0] = m->n_contacts, x.friction[0] = m->n_frictions;
    for (const int32_t *begin = m->island_begin;
         begin <= m->island_begin + ISLAND_COLUMNS * m->n_islands; begin += ISLAND_COLUMNS) {
        x.row[begin[ISLAND_FUNCTION]] = x.row[begin[ISLAND_VELOCITY]] = first_potential(c);
        x.linked[begin[ISLAND_TOUCHING_LINKED]] = m->n_linked;
        x.active[begin[ISLAND_TOUCHING_ACTIVE]] = m->n_active;
    }
}

/* Whether all contacts sleep, and nothing else has function rows or frictions. */
static int all_is_far(const context *c)
{
    const holonom_model *m = c->m;
    int32_t frictions = 0;
    if (m->n_function_rows != m->n_contacts) return 0;
    for (int32_t i = 0; i < m->n_contacts; i++) {
        if (!is_asleep(c, i)) return 0;
        frictions += m->contact_friction[i] >= 0;
    }
    return frictions == m->n_frictions;
}

/* Lists of what is awake. */
static void list_awake(const context *c, near_lists x)
{
    const holonom_model *m = c->m;
    const int32_t first = first_function(c), end = first_potential(c);
    int32_t *contact = x.contact, *friction = x.friction, *row = x.row, *linked = x.linked,
            *active = x.active;
    int32_t *form = (int32_t *)(void *)c->k.near_form;
    for (int32_t f = 0; f < m->n_frictions; f++) friction[f] = 1;
    for (int32_t i = 0; i < m->n_contacts; i++) {
        contact[i] = !is_asleep(c, i);
        if (m->contact_friction[i] >= 0) friction[m->contact_friction[i]] = contact[i];
    }
    memset(form, 0, sizeof(int32_t) * (size_t)m->n_forms);
    memset(active, 0, sizeof(int32_t) * (size_t)m->n_active);
    for (int32_t j = first; j < end; j++) {
        const int32_t owner = owner_of(c, j);
        row[j] =
            owner < 0 || (owner < m->n_contacts ? contact[owner] : friction[owner - m->n_contacts]);
        if (row[j]) mark_parts(c, j, form, active);
    }
    for (int32_t i = m->n_always_linked; i < m->n_linked; i++)
        linked[i] = form[m->linked_form[i]];
    link_list(contact, 0, m->n_contacts);
    link_list(friction, 0, m->n_frictions);
    link_list(row, first, end);
    link_list(linked, m->n_always_linked, m->n_linked);
    link_list(active, m->n_always_active, m->n_active);
}

/* Lets those contacts alone be at hand that are awake, with what belongs to them. */
static void leave_far_out(context *c)
{
    const holonom_model *m = c->m;
    const int32_t islands = m->n_islands;
    near_lists x;
    x.contact = (int32_t *)(void *)c->k.near;
    x.friction = x.contact + m->n_contacts + 1;
    x.row = x.friction + m->n_frictions + 1;
    x.linked = x.row + first_potential(c) + 1;
    x.active = x.linked + m->n_linked + 1;
    double *const rows[] = {c->k.mu, c->k.lambda,
                            c->k.phi}; /* a piece begins, which writes those at hand */
    for (int k = 0; k < 3 && !c->view.near[NEAR_CONTACTS]; k++)
        memset(rows[k] + row_of(c, first_function(c)), 0,
               sizeof(double) * (size_t)(m->n_function_rows + m->n_velocity_rows));
    if (all_is_far(c)) list_nothing(c, x);
    else list_awake(c, x);
    c->view.near[NEAR_CONTACTS] = x.contact, c->view.near[NEAR_FRICTIONS] = x.friction,
    c->view.near[NEAR_ROWS] = x.row;
    c->view.near[NEAR_LINKED] = x.linked, c->view.near[NEAR_ACTIVE] = x.active;
    int32_t used = 0;
    for (int32_t island = 0; island <= islands; island++) {
        select_islands(c, island < islands ? island : 0, island < islands ? island + 1 : islands);
        used = add_slice(c, slice_of(c, island), used);
    }
    select_islands(c, 0, islands);
}

/* Whether contact i, open and awake, has a gap that may let it sleep. */
static inline int is_far_enough(const context *c, int32_t i, double gap)
{ return gap > -contact_of(c, i)[C_ASLEEP_UNTIL]; }

/* Lets contacts sleep that are farther than a piece of this travel reaches, and wakes those that it
   may bring near, whose gaps are written into `value`, if given, with `rate` for not known. */
static void look_far(context *c, double travel, double *value, double *rate)
{
    double *head = c->s.head, next = INFINITY;
    int changes = 0;
    c->view.may_fall_asleep = 0;
    if (!hm_skips(SKIP_FAR_CONTACTS) || c->tolerance > 0.0 || n_contacts(c->m) < WORTH_SLEEP)
        return;
    for (int32_t i = 0; i < n_contacts(c->m); i++) {
        double *until = contact_of(c, i) + C_ASLEEP_UNTIL;
        const int slept = is_asleep(c, i);
        double gap = 0.0;
        if (!(*until > head[S_TRAVEL] + WAKES_AS_WELL * travel) && *until > NEVER_SLEEPS) {
            const double safe = is_free_of_force(c, i) ? safe_travel(c, i, &gap) : 0.0,
                         needed = FALLS_ASLEEP * travel;
            *until = safe < 0.0      ? NEVER_SLEEPS
                     : safe > needed ? head[S_TRAVEL] + safe
                     : safe > 0.0    ? -gap * needed / safe
                                     : 0.0;
        }
        if (!slept && is_asleep(c, i)) clear_rows(c, i);
        if (is_asleep(c, i)) next = *until < next ? *until : next;
        else if (slept && value) value[i] = gap, rate[i] = NAN;
        changes |= slept != is_asleep(c, i);
    }
    head[S_NEXT_AWAKE] = next < INFINITY ? next : 0.0;
    if (changes || (some_sleep(c) && !c->view.near[NEAR_CONTACTS])) leave_far_out(c);
}

#endif
