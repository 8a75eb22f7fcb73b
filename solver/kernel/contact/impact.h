/* Impacts at a fixed configuration: what touches and approaches parts with the restitution asked
   for, or stays closed.

   With x_r = M^-1 (g_r + G_B' p_B), G_B x_r = 0, the velocities that a unit impulse along row r
   brings about while all bilateral rows hold, W = g_r . x_s is what impact_sweep.h works on, and v+
   = v- + sum p_r x_r. */
#ifndef HOLONOM_IMPACT_H
#define HOLONOM_IMPACT_H

#include "joint_impacts.h"
#include "velocity_projection.h"

#define HELD 1e-10 /* of W without bilateral rows: what these leave of a row that depends on them */

/* Velocities (hit_reach) that a unit impulse along row r, composite `row`, brings about; -1:
   none. */
static int32_t find_reach(const context *c, int32_t row, int64_t r)
{
    const int64_t n = DIM * c->n_moving;
    memset(c->k.momentum, 0, sizeof(double) * (size_t)n);
    const int32_t status = row >= 0 ? add_row_gradient(c, row, -1.0) : HOLONOM_OK;
    velocities_of_impulses(c, c->k.hit_reach + n * r);
    return status;
}

/* Fills W (rows x rows) of composites, -1: none, from the velocities that unit impulses along them
   bring about. */
static int32_t fill_matrix(const context *c, int32_t rows, const int32_t *row, double *W)
{
    const int64_t n = DIM * c->n_moving;
    int32_t status = HOLONOM_OK;
    for (int32_t r = 0; r < rows && !status; r++) {
        memset(c->k.momentum, 0, sizeof(double) * (size_t)n);
        if (row[r] >= 0) status = add_row_gradient(c, row[r], 1.0);
        for (int32_t s = 0; s < rows; s++) {
            double sum = 0.0;
            for (int64_t k = 0; k < n; k++) sum += c->k.momentum[k] * c->k.hit_reach[n * s + k];
            W[(int64_t)rows * r + s] = sum;
        }
    }
    return status;
}

/* What W of composite `row` would be without bilateral rows. */
HM_SELDOM static double stiffness_alone(const context *c, int32_t row)
{
    double alone = 0.0;
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    add_row_gradient(c, row, 1.0);
    for (int32_t k = 0; k < DIM * c->m->n_free; k++)
        alone += hm_square(c->k.momentum[k]) / c->number[c->m->node_mass_at + k / DIM];
    return alone;
}

/* Whether the bilateral rows hold row r of an impact at rest, since it depends on them. */
HM_SELDOM static int is_held(const context *c, const hit *x, int32_t r)
{
    return fabs(x->before[r]) <= speed_tolerance(c)
           && x->W[(int64_t)(x->law.rows + 1) * r] <= HELD * stiffness_alone(c, x->row[r]);
}

/* Takes out of the law the rows that others hold: nothing but round-off is left of them, at which
   no law is. */
HM_SELDOM static void leave_out_held(const context *c, const hit *x)
{
    for (int32_t r = 0; r < x->law.rows; r++) {
        if (x->row[r] < 0 || !is_held(c, x, r)) continue;
        x->before[r] = 0.0;
        for (int64_t s = 0; s < x->law.rows; s++)
            x->W[x->law.rows * r + s] = x->W[x->law.rows * s + r] = 0.0;
    }
}

/* Fills W and the rates before. All contacts are open, so that factors are those of the bilateral
   rows. */
HM_SELDOM static int32_t fill_hit(context *c, const hit *x)
{
    const int32_t rows = x->law.rows;
    stand_still(c);
    int32_t status = factorise_at_state(c);
    if (status) return status;
    find_defect(c);
    add_defect(c, 1.0);
    for (int32_t r = 0; r < rows && !status; r++) {
        status = find_reach(c, x->row[r], r);
        keep_joint_impulses(c, r);
    }
    for (int32_t r = 0; r < rows; r++)
        x->before[r] = x->row[r] < 0 ? 0.0 : rate_of_row(c, x->row[r]);
    if (!status) status = fill_matrix(c, rows, x->row, x->W);
    if (!status) leave_out_held(c, x);
    return status;
}

/* What the impulses, those of the rows in mu, take with the velocities at hand: the mean of both
   ends is exact. */
HM_SELDOM static double loss_rate(const context *c, const hit *x)
{
    double sum = 0.0;
    row_rates(c, c->s.v, c->k.signal_rate, c->k.row_rate);
    EACH_ROW(c, i)
        sum += c->k.mu[i] * c->k.row_rate[i]; /* rates of rows at hand alone are written */
    for (int32_t r = 0; r < x->law.rows; r++)
        if (x->row[r] >= 0) sum -= x->law.impulse[r] * rate_of_row(c, x->row[r]);
    return sum;
}

/* Whether a contact without restitution has been hit: it is to stay closed. */
HM_SELDOM static int closes(const hit *x)
{
    for (int32_t k = 0; k < x->law.contacts; k++)
        if (x->contact[k] >= 0 && x->law.restitution[k] == 0.0
            && x->law.impulse[x->law.first[k]] > 0.0)
            return 1;
    return 0;
}

/* Whether a contact that has just been hit gets closer. */
static int approaches(const context *c, const hit *x)
{
    for (int32_t k = 0; k < x->law.contacts; k++)
        if (x->contact[k] >= 0 && gap_rate(c, x->contact[k]) < -speed_tolerance(c)) return 1;
    return 0;
}

/* Solves the law of impact, and counts what a user may want to know of it; returns 0, or 1 if no
   impulses were found. */
static int solve_hit(context *c, hit *x)
{
    if (hm_solve_impact(&x->law)) return 1;
    c->s.head[S_JAMS] += x->law.jam != 0;
    c->s.head[S_NEWTON_IMPACTS] += x->law.newton;
    return 0;
}

/* Applies the impulses and books what they take: along the contacts, and along rows whose rates are
   not quite 0, as the method leaves them. Where drivers move, their work is the rest of the change
   of energy. */
HM_SELDOM static int32_t apply_impulses(context *c, const hit *x, double kinetic)
{
    const int driven = is_driven(c);
    int32_t status = HOLONOM_OK;
    memset(c->k.momentum, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
    for (int32_t r = 0; r < x->law.rows && !status; r++) {
        const double p = x->law.impulse[r];
        if (x->row[r] >= 0) status = add_row_gradient(c, x->row[r], -p);
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
    /* Where contacts and rows hold the same thing twice velocities are not solved for to the last
       digit. Differences of kinetic energies tell it, but for their own round-off. */
    const double change = kinetic_energy(c, c->k.momentum) - kinetic;
    if (!driven && fabs(change + loss) > 1e-13 * kinetic) loss = -change;
    book(c, S_IMPACT, loss);
    if (driven) book(c, S_WORK, change + loss);
    return HOLONOM_OK;
}

/* Likewise, and counts them. */
HM_SELDOM static int32_t apply_hit(context *c, const hit *x, double kinetic)
{
    const int32_t status = apply_impulses(c, x, kinetic);
    for (int32_t k = 0; k < x->law.contacts && !status; k++) {
        const double p = x->law.impulse[x->law.first[k]];
        if (x->contact[k] < 0 || !(p > 0.0)) continue;
        double *own = contact_of(c, x->contact[k]);
        own[C_IMPACTS] += x->law.before[x->law.first[k]] < -speed_tolerance(c) ? 1.0 : 0.0;
        own[C_IMPULSE] += p;
    }
    return status;
}

/* Whether contact i touches, so that it takes part in an impact. One that parts does, too: others
   may bring it back, and its rates must not jump where it parts ever slower. */
HM_SELDOM static int touches(const context *c, int32_t i)
{ return gap_of(c, i) <= gap_tolerance(c); }

/* Restitution of contact i, with the accelerations before the impact in w: 0 if it approaches
   slowly, or if the flight that follows would be short. Neither depends on the step, so that what
   is lost does not. */
HM_SELDOM static double restitution_of(const context *c, int32_t i)
{
    const double e = c->number[c->m->restitution_at + i], speed = -gap_rate(c, i);
    if (!(e > 0.0) || !(speed > fmax(c->s.head[S_REST_SPEED], speed_tolerance(c)))) return 0.0;
    const double growth = is_closed(c, i) || c->s.head[S_REST_TIME] == 0.0
                              ? 0.0
                              : second_rate_of_row(c, c->m->contact_row[i]);
    return growth < 0.0 && 2.0 * e * speed < c->s.head[S_REST_TIME] * -growth ? 0.0 : e;
}

/* Closes the contacts of an impact slower than rest_speed that part slower than that, too: a block
   that rocks from corner to corner would land ever faster, without end. If forces open one of them,
   they do so from rest. */
HM_SELDOM static int32_t come_to_rest(context *c, const hit *x)
{
    evaluate_state(c);
    for (int32_t k = 0; k < x->law.contacts; k++)
        if (x->contact[k] >= 0 && gap_rate(c, x->contact[k]) <= c->s.head[S_REST_SPEED])
            close_contact(c, x->contact[k]);
    return project_velocities(c, S_IMPACT);
}

/* One impact of all contacts that touch, or, by the sequential law, of the one that approaches
   fastest. */
HM_SELDOM static int32_t hit_once(context *c, int *has_hit)
{
    hit x;
    int32_t fastest = -1;
    double most = -speed_tolerance(c);
    *has_hit = 0;
    map_hit(c, &x);
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (touches(c, i) && gap_rate(c, i) < most) most = gap_rate(c, i), fastest = i;
    if (fastest < 0) return HOLONOM_OK;
    *has_hit = 1;
    blame(c, c->m->contact_row[fastest]);
    int32_t status = c->s.head[S_REST_TIME] > 0.0 ? evaluate_forces(c) : HOLONOM_OK;
    if (status) return status;
    /* One that does not rebound takes along what it touches: alone, hits of two would go on and
       on. */
    const int sequential = c->s.head[S_IMPACT_LAW] != 0.0 && restitution_of(c, fastest) > 0.0;
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (touches(c, i) && (!sequential || i == fastest)
            && !add_to_hit(c, &x, i, restitution_of(c, i)))
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

/* Stops slips at once by impulses where no forces agree with strong friction, though nothing
   approaches (Lecornu 1905, for the rod of Painleve): the law of impact is told that all contacts
   at rest approach a little. */
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
    if (solve_hit(c, &x)) return HOLONOM_CONTACT_UNDECIDED;
    for (int32_t k = 0; k < x.law.contacts; k++) pushed += x.law.impulse[x.law.first[k]];
    return pushed > 0.0 ? apply_hit(c, &x, kinetic) : HOLONOM_CONTACT_UNDECIDED;
}

/* Whether an open contact that touches seems to part: rates that rows still have may hide that it
   gets closer. */
static int seems_to_part(const context *c)
{
    for (int32_t i = 0; i < c->m->n_contacts; i++)
        if (!is_closed(c, i) && gap_of(c, i) <= gap_tolerance(c)
            && gap_rate(c, i) > speed_tolerance(c))
            return 1;
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

#endif
