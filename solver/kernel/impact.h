/* Impacts at a fixed configuration: what touches and approaches parts with the restitution asked for, or stays closed.

   With x_r = M^-1 (g_r + G_B' p_B), G_B x_r = 0, the velocities that a unit impulse along row r brings about while all
   bilateral rows hold, W = g_r . x_s is what impact_law.h works on, and v+ = v- + sum p_r x_r.

   A joint that rubs takes part as a contact of its own: its tangents are its slips, and the equation of its normal row is
   p_N = d . P, with P the impulses of the rows that it rubs by, linear in all p, and d their direction, found by iteration. */
#ifndef HOLONOM_IMPACT_H
#define HOLONOM_IMPACT_H

#include "contact.h"
#include "context.h"
#include "energy.h"
#include "impact_law.h"
#include "rigid.h"
#include "start.h"

#define HELD 1e-10 /* of W without bilateral rows: what these leave of a row that depends on them */

/* Momentum += factor times the gradient of row j at the state; of a velocity row with respect to the velocities. */
HM_SELDOM static int32_t add_row_gradient(const context *c, int32_t j, double factor)
{
    composite_result result = {0.0, 0.0, 0.0};
    context still = *c;
    still.h = AT_STATE;
    const int32_t status = composite_slopes(&still, j, 0, &result);
    const local_form *local = (const local_form *)c->k.local;
    if (status) return status;
    for (int32_t at = c->m->composite_form_ptr[j], f = 0; at < c->m->composite_form_ptr[j + 1]; at++, f++)
        add_gradient(c, c->m->composite_form[at], factor * c->k.slope[f], local[f].um, local[f].wm, c->k.momentum);
    return HOLONOM_OK;
}

/* Velocities x (n, overwritten) that impulses in `momentum`, times -sqrt 2, bring about; those of the rows are in mu. */
HM_SELDOM static void velocities_of_impulses(const context *c, double *x)
{
    memset(c->k.mu, 0, sizeof(double) * (size_t)c->m->n_rows);
    memset(c->k.phi, 0, sizeof(double) * (size_t)c->m->n_rows);
    memset(x, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    solve_with_factors(c);
    add_solution(c, x);
}

/* An impact as it is set up: the rows of contacts that take part, and what is known of each. */
typedef struct hit {
    hm_impact law;
    double *W, *coefficient, *before; /* what law reads, to be filled                                          */
    int32_t *first, *tangents;        /* likewise                                                              */
    int32_t *contact;                 /* number of each contact that takes part; of joint friction f -1 - f     */
    int32_t *row;                     /* composite of each row; -1: of the normal force of a joint             */
    double *given;                    /* restitution of each                                                   */
} hit;

/* Lays the vectors of an impact over the scratch. */
HM_SELDOM static void map_hit(const context *c, hit *x)
{
    const int64_t n = c->m->n_hit_rows;
    double *d = c->k.hit;
    int32_t *i = (int32_t *)(void *)(d + 6 * n);
    x->W = c->k.hit_matrix;
    x->coefficient = d + n;
    x->before = d + 2 * n;
    x->first = i;
    x->tangents = i + n;
    x->law = (hm_impact){.W = x->W, .restitution = d, .coefficient = x->coefficient, .before = x->before,
                         .impulse = d + 3 * n, .after = d + 4 * n, .scratch = c->k.hit_scratch,
                         .first = x->first, .tangents = x->tangents, .status = i + 2 * n};
    x->contact = i + 3 * n;
    x->row = i + 4 * n;
    x->given = d + 5 * n;
}

/* Adds friction f with that normal row, of a contact or of the joint that rubs; 0 if there is no room. */
HM_SELDOM static int add_rows_to_hit(const context *c, hit *x, int32_t contact, int32_t row, int32_t f, double restitution)
{
    const int32_t k = x->law.contacts, slips = f < 0 ? 0 : n_slips(c, f);
    if (x->law.rows + 1 + slips > c->m->n_hit_rows) return 0;
    x->first[k] = x->law.rows;
    x->tangents[k] = slips;
    x->coefficient[k] = f < 0 ? 0.0 : c->number[c->m->sliding_at + f];
    x->law.restitution[k] = x->given[k] = restitution;
    x->contact[k] = contact;
    x->row[x->law.rows++] = row;
    for (int s = 0; s < slips; s++) x->row[x->law.rows++] = slip_row(c, f, s);
    x->law.contacts++;
    return 1;
}

/* Adds contact i with its friction; 0 if there is no room. */
HM_SELDOM static int add_to_hit(const context *c, hit *x, int32_t i, double restitution)
{
    return add_rows_to_hit(c, x, i, c->m->contact_row[i], c->m->contact_friction[i], restitution);
}

/* Whether a contact that takes part is of the island of composite j. */
HM_SELDOM static int reaches(const context *c, const hit *x, int32_t j)
{
    const int32_t *end = c->m->island_begin + ISLAND_COLUMNS;
    while (j >= end[ISLAND_VELOCITY]) end += ISLAND_COLUMNS;
    const int32_t *begin = end - ISLAND_COLUMNS;
    for (int32_t k = 0; k < x->law.contacts; k++)
        if (x->contact[k] >= 0 && x->row[x->first[k]] >= begin[ISLAND_FUNCTION] && x->row[x->first[k]] < end[ISLAND_FUNCTION])
            return 1;
    return 0;
}

/* Adds the joints that rub and that impulses of the contacts may reach; 0 if there is no room. */
HM_SELDOM static int add_joints_to_hit(const context *c, hit *x)
{
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        if (is_of_contact(c, f) || !(c->number[c->m->sliding_at + f] > 0.0) || !reaches(c, x, slip_row(c, f, 0))) continue;
        if (!add_rows_to_hit(c, x, -1 - f, -1, f, 0.0)) return 0;
    }
    return 1;
}

/* Keeps the impulses that row r brings about in the joints that rub (in mu). */
static void keep_joint_impulses(const context *c, int32_t r)
{
    const holonom_model *m = c->m;
    double *force = c->k.hit_force + (int64_t)m->n_hit_forces * r;
    for (int32_t f = 0; f < m->n_frictions; f++)
        for (int32_t at = m->normal_ptr[f]; at < m->normal_ptr[f + 1] && !is_of_contact(c, f); at++)
            *force++ = c->k.mu[m->normal_row[2 * at]];
}

/* Equations p_N = d . P of the joints that rub, with the directions d of the present impulses P: rows of W, scaled as those
   of their slips. Returns the largest |p_N - |P|| over the largest |P|.                                          */
static double press_joints(const context *c, const hit *x)
{
    const holonom_model *m = c->m;
    const int32_t rows = x->law.rows;
    double error = 0.0, largest = 0.0;
    for (int32_t k = 0; k < x->law.contacts; k++) {
        const int32_t joint = -1 - x->contact[k], normal = x->first[k];
        double *line = x->W + (int64_t)rows * normal, pressed = 0.0;
        const double *force = c->k.hit_force;
        if (joint < 0) continue;
        const double slip = x->W[(int64_t)rows * (normal + 1) + normal + 1], scale = slip > 0.0 ? slip : 1.0;
        for (int32_t f = 0; f < joint; f++)
            if (!is_of_contact(c, f)) force += m->normal_ptr[f + 1] - m->normal_ptr[f];
        memset(line, 0, sizeof(double) * (size_t)rows);
        for (int32_t at = m->normal_ptr[joint]; at < m->normal_ptr[joint + 1];) {
            const double *first = force;
            double sum = 0.0;
            do {
                double impulse = 0.0;
                for (int32_t s = 0; s < rows; s++) impulse += x->law.impulse[s] * force[(int64_t)m->n_hit_forces * s];
                c->k.row_rate[m->normal_row[2 * at]] = impulse;
                sum += hm_square(impulse);
                at++, force++;
            } while (at < m->normal_ptr[joint + 1] && m->normal_row[2 * at + 1] == NORMAL_CONTINUES);
            const double root = sqrt(sum);
            const int32_t begin = at - (int32_t)(force - first);
            for (int32_t e = 0; e < at - begin && root > 0.0; e++)
                for (int32_t s = 0; s < rows; s++)
                    line[s] -= scale * c->k.row_rate[m->normal_row[2 * (begin + e)]] / root * first[e + (int64_t)m->n_hit_forces * s];
            pressed += root;
        }
        line[normal] += scale;
        error = fmax(error, fabs(x->law.impulse[normal] - pressed));
        largest = fmax(largest, pressed);
    }
    return largest > 0.0 ? error / largest : 0.0;
}

enum { MOST_PRESSES = 100 };

/* Solves the law of impact; returns 0, or 1 if no impulses were found. */
static int solve_hit(const context *c, hit *x)
{
    memset(x->law.impulse, 0, sizeof(double) * (size_t)x->law.rows);
    for (int turn = 0; turn < MOST_PRESSES; turn++) {
        const double error = press_joints(c, x);
        if (turn > 0 && error <= IMPACT_TOLERANCE) return 0;
        memcpy(x->law.restitution, x->given, sizeof(double) * (size_t)x->law.contacts);
        if (hm_solve_impact(&x->law)) return 1;
    }
    return 1;
}

/* Whether drivers or surfaces move, whose work is what a change of velocities adds to the kinetic energy and its losses. */
static int is_driven(const context *c)
{
    double *rest = c->k.ahead, moved = c->m->n_signals;
    memset(rest, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        for (int k = 0; k < n_slips(c, f); k++)
            moved += fabs(function_rate(c, slip_row(c, f, k), c->s.q, c->s.q_low, rest, c->s.signal, c->k.signal_rate));
    return moved > 0.0;
}

/* Part of the velocities that makes rows move which hold, with the other sign (hit_defect): a step leaves it by its order.
   It is orthogonal to all that rows allow, so that its energy is apart. Factors are those at the state.         */
HM_SELDOM static void find_defect(const context *c)
{
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    memset(c->k.mu, 0, sizeof(double) * (size_t)c->m->n_rows);
    memset(c->k.hit_defect, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    row_rates(c, c->s.q, c->s.q_low, c->s.v, c->s.signal, c->k.signal_rate, c->k.phi);
    solve_with_factors(c);
    add_solution(c, c->k.hit_defect);
}

HM_SELDOM static void add_defect(const context *c, double sign)
{
    for (int32_t k = 0; k < DIM * c->m->n_free; k++) hm_add(c->s.v + k, c->s.v_low + k, sign * c->k.hit_defect[k]);
}

/* Takes from the velocities what rows do not allow and books its energy in `account`; a change beyond it is work of
   drivers. */
HM_SELDOM static int32_t project_velocities(context *c, int account)
{
    suspend_sliding(c, 1);
    stand_still(c);
    const int32_t status = factorise_at_state(c, NULL);
    if (!status) find_defect(c);
    suspend_sliding(c, 0);
    if (status) return status;
    add_defect(c, 1.0);
    /* What was solved for near a singular configuration is not quite orthogonal: its own work is booked. */
    const double square = 0.5 * mass_product(c, c->k.hit_defect, c->k.hit_defect);
    double change = -square;
    momenta(c, c->k.momentum);
    for (int32_t k = 0; k < DIM * c->m->n_free; k++) change += c->k.hit_defect[k] * c->k.momentum[k];
    const double loss = is_driven(c) ? square : -change;
    book(c, account, loss);
    book(c, S_WORK, change + loss);
    evaluate_state(c);
    return HOLONOM_OK;
}

/* Fills W from the velocities that the impulses bring about. */
static int32_t fill_matrix(const context *c, const hit *x)
{
    const int64_t n = DIM * c->n_moving, rows = x->law.rows;
    int32_t status = HOLONOM_OK;
    for (int32_t r = 0; r < rows && !status; r++) {
        memset(c->k.momentum, 0, sizeof(double) * (size_t)n);
        if (x->row[r] >= 0) status = add_row_gradient(c, x->row[r], 1.0);
        for (int32_t s = 0; s < rows; s++) {
            double sum = 0.0;
            for (int64_t k = 0; k < n; k++) sum += c->k.momentum[k] * c->k.hit_reach[n * s + k];
            x->W[rows * r + s] = sum;
        }
    }
    return status;
}

/* Whether the bilateral rows hold row r of an impact at rest, since it depends on them. */
HM_SELDOM static int is_held(const context *c, const hit *x, int32_t r)
{
    double alone = 0.0; /* what W would be without bilateral rows */
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    add_row_gradient(c, x->row[r], 1.0);
    for (int32_t k = 0; k < DIM * c->m->n_free; k++)
        alone += hm_square(c->k.momentum[k]) / c->number[c->m->node_mass_at + k / DIM];
    return fabs(x->before[r]) <= speed_tolerance(c) && x->W[(int64_t)(x->law.rows + 1) * r] <= HELD * alone;
}

/* Takes out of the law the rows that others hold: nothing but round-off is left of them, at which no law is. */
HM_SELDOM static void leave_out_held(const context *c, const hit *x)
{
    for (int32_t r = 0; r < x->law.rows; r++) {
        if (x->row[r] < 0 || !is_held(c, x, r)) continue;
        x->before[r] = 0.0;
        for (int64_t s = 0; s < x->law.rows; s++) x->W[x->law.rows * r + s] = x->W[x->law.rows * s + r] = 0.0;
    }
}

/* Fills W and the rates before. All contacts are open, so that factors are those of the bilateral rows. */
HM_SELDOM static int32_t fill_hit(context *c, const hit *x)
{
    const int64_t n = DIM * c->n_moving, rows = x->law.rows;
    stand_still(c);
    int32_t status = factorise_at_state(c, NULL);
    if (status) return status;
    find_defect(c);
    add_defect(c, 1.0);
    for (int32_t r = 0; r < rows && !status; r++) {
        memset(c->k.momentum, 0, sizeof(double) * (size_t)n);
        if (x->row[r] >= 0) status = add_row_gradient(c, x->row[r], -AT_STATE);
        velocities_of_impulses(c, c->k.hit_reach + n * r);
        keep_joint_impulses(c, r);
    }
    for (int32_t r = 0; r < rows; r++) x->before[r] = x->row[r] < 0 ? 0.0 : rate_of_row(c, x->row[r]);
    if (!status) status = fill_matrix(c, x);
    if (!status) leave_out_held(c, x);
    return status;
}

/* What the impulses, those of the rows in mu, take with the velocities at hand: the mean of both ends is exact. */
HM_SELDOM static double loss_rate(const context *c, const hit *x)
{
    double sum = 0.0;
    row_rates(c, c->s.q, c->s.q_low, c->s.v, c->s.signal, c->k.signal_rate, c->k.row_rate);
    for (int32_t i = 0; i < c->m->n_rows; i++) sum += c->k.mu[i] * c->k.row_rate[i];
    for (int32_t r = 0; r < x->law.rows; r++)
        if (x->row[r] >= 0) sum -= x->law.impulse[r] * rate_of_row(c, x->row[r]);
    return sum;
}

/* Whether a contact without restitution has been hit: it is to stay closed. */
HM_SELDOM static int closes(const hit *x)
{
    for (int32_t k = 0; k < x->law.contacts; k++)
        if (x->contact[k] >= 0 && x->law.restitution[k] == 0.0 && x->law.impulse[x->law.first[k]] > 0.0) return 1;
    return 0;
}

/* Whether a contact that has just been hit gets closer. */
static int approaches(const context *c, const hit *x)
{
    for (int32_t k = 0; k < x->law.contacts; k++)
        if (x->contact[k] >= 0 && gap_rate(c, x->contact[k]) < -speed_tolerance(c)) return 1;
    return 0;
}

/* Applies the impulses and books what they take: along the contacts, and along rows whose rates are not quite 0, as the
   method leaves them. Where drivers move, their work is the rest of the change of energy.                       */
HM_SELDOM static int32_t apply_hit(context *c, const hit *x, double kinetic)
{
    const int driven = is_driven(c);
    int32_t status = HOLONOM_OK;
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t r = 0; r < x->law.rows && !status; r++) {
        const double p = x->law.impulse[r];
        if (x->row[r] >= 0) status = add_row_gradient(c, x->row[r], -AT_STATE * p);
    }
    if (status) return status;
    velocities_of_impulses(c, c->k.w);
    double loss = 0.5 * loss_rate(c, x);
    for (int32_t k = 0; k < DIM * c->m->n_free; k++) hm_add(c->s.v + k, c->s.v_low + k, c->k.w[k]);
    loss += 0.5 * loss_rate(c, x);
    add_defect(c, -1.0);
    if (closes(x) || approaches(c, x)) { /* their gaps must stay as they are, or open */
        add_defect(c, 1.0);
        loss += 0.5 * mass_product(c, c->k.hit_defect, c->k.hit_defect);
    }
    /* Where contacts and rows hold the same thing twice velocities are not solved for to the last digit. Differences of
       kinetic energies tell it, but for their own round-off.                                                     */
    const double change = kinetic_energy(c, c->k.momentum) - kinetic;
    if (!driven && fabs(change + loss) > 1e-13 * kinetic) loss = -change;
    book(c, S_IMPACT, loss);
    if (driven) book(c, S_WORK, change + loss);
    for (int32_t k = 0; k < x->law.contacts; k++) {
        const double p = x->law.impulse[x->law.first[k]];
        if (x->contact[k] < 0 || !(p > 0.0)) continue;
        double *own = contact_of(c, x->contact[k]);
        own[C_IMPACTS] += x->law.before[x->law.first[k]] < -speed_tolerance(c) ? 1.0 : 0.0;
        own[C_IMPULSE] += p;
    }
    return HOLONOM_OK;
}

/* Whether contact i takes part in an impact: it touches and does not part. */
HM_SELDOM static int takes_part(const context *c, int32_t i)
{
    return gap_of(c, i) <= gap_tolerance(c) && gap_rate(c, i) <= speed_tolerance(c);
}

/* Restitution of contact i, with the accelerations before the impact in w: 0 if it approaches slowly, or if the flight that
   follows would be short. Neither depends on the step, so that what is lost does not.                             */
HM_SELDOM static double restitution_of(const context *c, int32_t i)
{
    const double e = c->number[c->m->restitution_at + i], speed = -gap_rate(c, i);
    if (!(e > 0.0) || !(speed > fmax(c->s.head[S_REST_SPEED], speed_tolerance(c)))) return 0.0;
    const double growth = is_closed(c, i) || c->s.head[S_REST_TIME] == 0.0 ? 0.0 : second_rate_of_row(c, c->m->contact_row[i]);
    return growth < 0.0 && 2.0 * e * speed < c->s.head[S_REST_TIME] * -growth ? 0.0 : e;
}

/* Closes the contacts of an impact slower than rest_speed that part slower than that, too: a block that rocks from corner to
   corner would land ever faster, without end. If forces open one of them, they do so from rest.                  */
HM_SELDOM static int32_t come_to_rest(context *c, const hit *x)
{
    evaluate_state(c);
    for (int32_t k = 0; k < x->law.contacts; k++)
        if (x->contact[k] >= 0 && gap_rate(c, x->contact[k]) <= c->s.head[S_REST_SPEED]) close_contact(c, x->contact[k]);
    return project_velocities(c, S_IMPACT);
}

/* One impact of all contacts that touch, or, by the sequential law, of the one that approaches fastest. */
HM_SELDOM static int32_t hit_once(context *c, int *has_hit)
{
    hit x;
    int32_t fastest = -1;
    double most = -speed_tolerance(c);
    *has_hit = 0;
    map_hit(c, &x);
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (takes_part(c, i) && gap_rate(c, i) < most) most = gap_rate(c, i), fastest = i;
    if (fastest < 0) return HOLONOM_OK;
    *has_hit = 1;
    blame(c, c->m->contact_row[fastest]);
    int32_t status = c->s.head[S_REST_TIME] > 0.0 ? evaluate_forces(c) : HOLONOM_OK;
    if (status) return status;
    /* One that does not rebound takes along what it touches: alone, hits of two would go on and on. */
    const int sequential = c->s.head[S_IMPACT_LAW] != 0.0 && restitution_of(c, fastest) > 0.0;
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (takes_part(c, i) && (!sequential || i == fastest) && !add_to_hit(c, &x, i, restitution_of(c, i)))
            return HOLONOM_IMPACT_UNSOLVED;
    if (!add_joints_to_hit(c, &x)) return HOLONOM_IMPACT_UNSOLVED;
    open_all(c);
    const double kinetic = kinetic_energy(c, c->k.momentum);
    status = fill_hit(c, &x);
    if (status) return status;
    if (solve_hit(c, &x)) return HOLONOM_IMPACT_UNSOLVED;
    status = apply_hit(c, &x, kinetic);
    return status || !(-most <= c->s.head[S_REST_SPEED]) ? status : come_to_rest(c, &x);
}

/* Stops slips at once by impulses where no forces agree with strong friction, though nothing approaches (Lecornu 1905, for
   the rod of Painleve): the law of impact is told that all contacts at rest approach a little.                   */
HM_SELDOM static int32_t jam(context *c)
{
    hit x;
    double pushed = 0.0;
    map_hit(c, &x);
    evaluate_state(c);
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (is_at_rest(c, i) && !add_to_hit(c, &x, i, 0.0)) return HOLONOM_CONTACT_UNDECIDED;
    open_all(c);
    const double kinetic = kinetic_energy(c, c->k.momentum);
    const int32_t status = fill_hit(c, &x);
    if (status) return status;
    for (int32_t k = 0; k < x.law.contacts; k++) x.before[x.law.first[k]] -= speed_tolerance(c);
    if (hm_solve_impact(&x.law)) return HOLONOM_CONTACT_UNDECIDED;
    for (int32_t k = 0; k < x.law.contacts; k++) pushed += x.law.impulse[x.law.first[k]];
    return pushed > 0.0 ? apply_hit(c, &x, kinetic) : HOLONOM_CONTACT_UNDECIDED;
}

/* Whether an open contact that touches seems to part: rates that rows still have may hide that it gets closer. */
static int seems_to_part(const context *c)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (!is_closed(c, i) && gap_of(c, i) <= gap_tolerance(c) && gap_rate(c, i) > speed_tolerance(c)) return 1;
    return 0;
}

enum { MOST_SEQUENTIAL = 2000 };

/* Impacts at the present state; `hits` counts them. */
HM_SELDOM static int32_t hit_all(context *c, int *hits)
{
    evaluate_state(c);
    for (*hits = 0; *hits < MOST_SEQUENTIAL; *hits += 1) {
        int has_hit;
        int32_t status = hit_once(c, &has_hit);
        if (!status && !has_hit && *hits == 0 && seems_to_part(c)) {
            status = project_velocities(c, S_IMPACT);
            if (!status) status = hit_once(c, &has_hit);
        }
        if (status || !has_hit) return status;
        evaluate_state(c);
    }
    return HOLONOM_IMPACT_UNSOLVED;
}

/* ------------------------------------------------------------------------------------------ modes */

/* Momentum += factor times the gradient of contact i's gap, with the friction that a normal force of 1 brings about while
   it slides.                                                                                                   */
static int32_t add_push(const context *c, int32_t i, double factor)
{
    const int32_t f = c->m->contact_friction[i];
    double along[3];
    int32_t status = add_row_gradient(c, c->m->contact_row[i], factor);
    if (f < 0 || !(slip_at_state(c, f, along) > speed_tolerance(c) || is_smooth(c, f))) return status;
    for (int k = 0; k < n_slips(c, f) && !status; k++)
        status = add_row_gradient(c, slip_row(c, f, k), -factor * c->number[c->m->sliding_at + f] * along[k]);
    return status;
}

/* The accelerations of contacts at rest obey the law that velocities obey after an impact without restitution, with
   forces for impulses: guesses all modes at once by it.                                                         */
static int32_t guess_by_law(context *c)
{
    const holonom_model *m = c->m;
    const int64_t n = DIM * c->n_moving;
    hit x;
    map_hit(c, &x);
    evaluate_state(c);
    for (int32_t i = 0; i < m->n_contacts; i++) {
        const int32_t f = m->contact_friction[i];
        open_contact(c, i);
        if (!is_at_rest(c, i)) continue;
        const int slides = f >= 0 && (is_smooth(c, f) || slip_of(c, f, NULL) > speed_tolerance(c));
        if (!add_to_hit(c, &x, i, 0.0)) return HOLONOM_CONTACT_UNDECIDED;
        const int32_t k = x.law.contacts - 1;
        if (slides) { /* its friction follows from its normal force: add_push adds it */
            x.law.rows = x.law.first[k] + 1;
            x.tangents[k] = 0;
            x.coefficient[k] = 0.0;
        } else if (f >= 0)
            x.coefficient[k] = c->number[m->static_at + f];
    }
    const int32_t rows = x.law.rows;
    int32_t status = evaluate_forces(c);
    for (int32_t r = 0; r < rows && !status; r++) x.before[r] = second_rate_of_row(c, x.row[r]);
    stand_still(c);
    if (!status) status = factorise_at_state(c, NULL);
    for (int32_t k = 0; k < x.law.contacts && !status; k++)
        for (int32_t r = x.law.first[k]; r <= x.law.first[k] + x.law.tangents[k] && !status; r++) {
            memset(c->k.momentum, 0, sizeof(double) * (size_t)n);
            status = r == x.law.first[k] ? add_push(c, x.contact[k], -AT_STATE) : add_row_gradient(c, x.row[r], -AT_STATE);
            velocities_of_impulses(c, c->k.hit_reach + n * r);
        }
    if (!status) status = fill_matrix(c, &x);
    if (!status && hm_solve_impact(&x.law)) status = HOLONOM_CONTACT_UNDECIDED;
    if (status) return status;
    evaluate_state(c);
    for (int32_t k = 0; k < x.law.contacts; k++) {
        const int32_t i = x.contact[k], f = m->contact_friction[i], t = x.law.first[k] + 1, slips = x.law.tangents[k];
        if (x.law.status[k] == IMPACT_PARTED) continue;
        close_contact(c, i);
        if (f < 0 || slips == 0 || friction_mode(c, f) == FRICTION_OFF) continue;
        const double force = impact_length(slips, x.law.impulse + t);
        double along[3] = {0.0, 0.0, 0.0};
        for (int32_t a = 0; a < slips && force > 0.0; a++) along[a] = -x.law.impulse[t + a] / force;
        if (x.law.status[k] == IMPACT_CLOSED && force > 0.0) let_slide(c, f, along);
        else let_stick(c, f);
    }
    return HOLONOM_OK;
}

/* Decides from the present state which contacts are closed and which frictions stick. */
static int32_t settle_modes(context *c)
{
    guess_modes(c);
    int32_t status = agree_with_forces(c);
    if (status == HOLONOM_CONTACT_UNDECIDED) {
        status = guess_by_law(c);
        if (!status) status = agree_with_forces(c);
    }
    return status ? status : start_with_modes(c);
}

#endif
