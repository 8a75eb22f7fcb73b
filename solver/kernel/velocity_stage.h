/* Second stage of a half step of stepped mode: velocities change alone, at q_1.

   Closed contacts part with rates f e |g'_0| where they have just closed, and with none where they were closed before; what
   holds is held. f is such that e^2 of what both stages take with f = 0 is given back (energetic restitution, Stronge 1990),
   a quadratic equation.                                                                                          */
#ifndef HOLONOM_VELOCITY_STAGE_H
#define HOLONOM_VELOCITY_STAGE_H

#include "half_step_contacts.h"

static int island_has_contact(context *c)
{
    EACH_IN(c, composites, composite, j)
        if (is_row(c, j) && owner_of(c, j) >= 0 && state_of_row(c, j) != ROW_IS_OFF) return 1;
    return 0;
}

/* Rates of rows that are to vanish (in phi): of islands in which a contact is closed. */
static void rates_to_stop(context *c)
{
    row_rates(c, c->s.q, c->s.q_low, c->s.v, c->s.signal, c->k.signal_rate, c->k.phi);
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        look_at(c, island, island + 1);
        if (island_has_contact(c)) continue;
        EACH_ROW(c, i) c->k.phi[i] = 0.0;
    }
    look_at(c, 0, c->m->n_islands);
}

/* Rates at which contacts would part by themselves, with the other sign in phi; e^2 of all that land, by their energies. */
static double rates_of_landing(const context *c)
{
    double given = 0.0, taken = 0.0;
    memset(c->k.phi, 0, sizeof(double) * (size_t)c->m->n_rows);
    for (int32_t i = 0; i < c->m->n_contacts; i++) {
        const int32_t row = row_of(c, c->m->contact_row[i]);
        const double e = c->number[c->m->restitution_at + i], speed = -touch_of(c, i)->rate;
        if (!is_landing(c, i) || !(speed > 0.0)) continue;
        const double weight = speed * speed / c->number[c->m->row_sigma_at + row];
        taken += weight;
        if (!(speed > fmax(c->s.head[S_REST_SPEED], speed_tolerance(c)))) continue;
        given += e * e * weight;
        c->k.phi[row] = -e * speed;
    }
    return taken > 0.0 ? given / taken : 0.0;
}

/* Adds x to the velocities and books what its impulses (in mu) take; the rest of the change of energy is work. */
static void add_velocities(context *c, const double *x, int driven)
{
    const holonom_model *m = c->m;
    double *rate = c->k.row_rate, friction = 0.0, total = 0.0;
    const double before = mass_product(c, x, c->s.v) + 0.5 * mass_product(c, x, x);
    for (int side = 0; side < 2; side++) {
        row_rates(c, c->s.q, c->s.q_low, c->s.v, c->s.signal, c->k.signal_rate, rate);
        for (int32_t f = 0; f < m->n_frictions; f++)
            for (int k = 0; k < n_slips(c, f); k++) {
                const int32_t j = slip_row(c, f, k), row = row_of(c, j);
                if (state_of_row(c, j) == ROW_IS_OFF) continue;
                rate[row] = rate_of_row(c, j);
                if (c->k.lands[f] == 0.0) friction += 0.5 * c->k.mu[row] * rate[row];
            }
        for (int32_t i = 0; i < m->n_rows; i++) total += 0.5 * c->k.mu[i] * rate[i];
        for (int32_t k = 0; k < DIM * m->n_free && !side; k++) hm_add(c->s.v + k, c->s.v_low + k, x[k]);
    }
    const double loss = driven ? total : -before;
    book(c, S_FRICTION, friction);
    book(c, S_IMPACT, loss - friction);
    if (driven) book(c, S_WORK, before + loss);
}

/* Lets those frictions stick whose slip the second stage has reversed; joints, which had none in it, slide the other way. */
static int stop_reversed(context *c)
{
    int stops = 0;
    for (int32_t f = 0; f < c->m->n_frictions; f++) {
        if (friction_mode(c, f) != FRICTION_SLIDES || is_smooth(c, f) || !(slip_along(c, f) < -speed_tolerance(c))) continue;
        if (!is_of_contact(c, f)) {
            guess_friction(c, f);
            continue;
        }
        let_stick(c, f);
        stops = 1;
    }
    return stops;
}

/* Part of the rates of landing contacts, whose velocities are `part` and whose impulses are in mu, that gives `share` of what
   both stages take back: `taken`, and what the velocities `stop` take, whose impulses are in event_mu.          */
static double part_given_back(context *c, double share, double taken, const double *stop, const double *part, int driven)
{
    const double curved = 0.5 * mass_product(c, part, part);
    double linear = mass_product(c, part, c->s.v) + mass_product(c, part, stop);
    double lost = taken - mass_product(c, stop, c->s.v) - 0.5 * mass_product(c, stop, stop);
    if (driven) { /* what surfaces and drivers do is no loss */
        memset(c->k.ahead, 0, sizeof(double) * (size_t)(DIM * c->n_moving));
        row_rates(c, c->s.q, c->s.q_low, c->k.ahead, c->s.signal, c->k.signal_rate, c->k.row_rate);
        for (int32_t i = 0; i < c->m->n_rows; i++) {
            linear -= c->k.mu[i] * c->k.row_rate[i];
            lost += c->k.event_mu[i] * c->k.row_rate[i];
        }
    }
    const double back = share * fmax(lost, 0.0), root = linear + sqrt(fmax(linear * linear + 4.0 * curved * back, 0.0));
    return back > 0.0 && root > 0.0 ? 2.0 * back / root : 0.0;
}

/* Velocities of the second stage (hit_defect), and their impulses (event_mu). */
static int32_t velocities_of_parting(context *c, double taken, int driven)
{
    const int32_t n = DIM * c->n_moving, rows = c->m->n_rows;
    double *stop = c->k.hit_defect, *part = c->k.free;
    stand_still(c);
    forget_dependent_rows(c);
    judge_rows(c, NULL);
    const int32_t status = factorise_at_state(c, NULL);
    if (status) return status;
    rates_to_stop(c);
    velocities_for(c, stop);
    memcpy(c->k.event_mu, c->k.mu, sizeof(double) * (size_t)rows);
    const double share = rates_of_landing(c);
    if (!(share > 0.0)) return HOLONOM_OK;
    velocities_for(c, part);
    const double f = part_given_back(c, share, taken, stop, part, driven);
    for (int32_t k = 0; k < n; k++) stop[k] += f * part[k];
    for (int32_t i = 0; i < rows; i++) c->k.event_mu[i] += f * c->k.mu[i];
    return HOLONOM_OK;
}

/* Likewise, the velocities that stop the slips of frictions which stick; contacts keep the rates that they have. */
static int32_t velocities_of_stopping(context *c)
{
    stand_still(c);
    const int32_t status = factorise_at_state(c, NULL);
    if (status) return status;
    memset(c->k.phi, 0, sizeof(double) * (size_t)c->m->n_rows);
    for (int32_t f = 0; f < c->m->n_frictions; f++)
        for (int k = 0; k < n_slips(c, f) && friction_mode(c, f) == FRICTION_STICKS; k++)
            c->k.phi[row_of(c, slip_row(c, f, k))] = rate_of_row(c, slip_row(c, f, k));
    velocities_for(c, c->k.hit_defect);
    memcpy(c->k.event_mu, c->k.mu, sizeof(double) * (size_t)c->m->n_rows);
    return HOLONOM_OK;
}

/* Second stage; `taken` is what contacts have taken in the first one, of length h and that parity. */
static int32_t part_contacts(context *c, double taken, int parity)
{
    const holonom_model *m = c->m;
    evaluate_state(c);
    const int driven = is_driven(c);
    for (int32_t f = 0; f < m->n_frictions; f++) c->k.lands[f] = 0.0;
    for (int32_t i = 0; i < m->n_contacts; i++)
        if (m->contact_friction[i] >= 0) c->k.lands[m->contact_friction[i]] = is_landing(c, i);
    suspend_sliding(c, c->k.lands, 1);
    int32_t status = velocities_of_parting(c, taken, driven);
    if (!status) add_velocities(c, c->k.hit_defect, driven);
    for (int32_t i = 0; i < m->n_contacts && !status; i++) {
        const int32_t row = row_of(c, m->contact_row[i]);
        double *own = contact_of(c, i);
        if (!is_landing(c, i)) continue;
        own[C_IMPACTS] += touch_of(c, i)->rate < -speed_tolerance(c) ? 1.0 : 0.0;
        own[C_IMPULSE] -= c->h * c->s.mu[parity][row] + c->k.event_mu[row];
        c->s.head[S_EVENTS] += 1.0;
    }
    suspend_sliding(c, c->k.lands, 0);
    if (!status && stop_reversed(c)) {
        suspend_sliding(c, c->k.lands, 1);
        status = velocities_of_stopping(c);
        if (!status) add_velocities(c, c->k.hit_defect, driven);
        suspend_sliding(c, c->k.lands, 0);
    }
    for (int32_t i = 0; i < m->n_contacts && !status; i++)
        if (is_closed(c, i) && gap_rate(c, i) > speed_tolerance(c)) open_contact(c, i);
    return status;
}

#endif
