/* Energies, momenta, and residuals of the rows. */
#ifndef HOLONOM_ENERGY_H
#define HOLONOM_ENERGY_H

#include "elements.h"
#include "step.h"

/* Energy of springs and potentials of the islands at hand. */
static double stored_energy(const context *c)
{
    double sum = 0.0;
    if (c->m->n_potentials) quantities_at_state(c);
    EACH_ELEMENT(c, j) sum += kind_of(c, j)->energy(c, j);
    return sum;
}

/* Change of the potential energy of the islands at hand since the start, where springs and
   potentials had `stored`. Weights act on displacements: on positions they would lose the digits by
   which the mechanism is far from the origin. */
static double potential_since(const context *c, double stored)
{
    const holonom_model *m = c->m;
    const double *gravity = c->number + m->gravity_at, *start = c->s.start;
    double high = 0.0, low = 0.0;
    EACH_NODE(c, a) {
        double moved[DIM];
        const double weight = c->number[m->node_weight_at + a];
        if (weight == 0.0) continue;
        EACH(k) moved[k] = (c->s.q[DIM * a + k] - start[DIM * a + k]) + c->s.q_low[DIM * a + k];
        hm_add(&high, &low, -weight * dot(gravity, moved));
    }
    hm_add(&high, &low, stored_energy(c) - stored);
    return high;
}

static double potential_change(const context *c)
{ return potential_since(c, c->s.head[S_STORED_START]); }

/* Momentum of each moving node at hand, p = M v (DIM n_moving, overwritten). */
static void momenta(const context *c, double *p)
{
    const holonom_model *m = c->m;
    clear_nodes(c, p);
    for IN_ISLAND(c, e, ISLAND_MASS) {
            const double *v = c->s.v + DIM * m->mass_node[2 * e + 1],
                         *v_low = c->s.v_low + DIM * m->mass_node[2 * e + 1];
            EACH(k)
                p[DIM * m->mass_node[2 * e] + k] += c->number[m->mass_at + e] * (v[k] + v_low[k]);
    }
}

static double kinetic_energy(const context *c, double *p)
{
    double sum = 0.0;
    momenta(c, p);
    EACH_NODE(c, a) sum += 0.5 * dot(p + DIM * a, c->s.v + DIM * a);
    return sum;
}

/* Kinetic and potential energy gained, minus the work of loads and drivers, plus what dampers took:
   0 if exact. */
HM_OFTEN double ledger_balance(const context *c, double kinetic, double potential)
{
    const double *head = c->s.head;
    return ((kinetic - head[S_KINETIC_START]) + potential) -
           (head[S_WORK] - (head[S_DISSIPATED] + (head[S_FRICTION] + head[S_IMPACT])));
}

/* The balance over the reference energy. */
static double relative_balance(const context *c, double balance)
{
    const double reference = c->s.head[S_ENERGY_REFERENCE];
    return reference > 0.0 ? fabs(balance) / reference : fabs(balance);
}

/* Follows the reference energy, the largest kinetic energy, or change of potential energy, seen so
   far, and the error of the ledger. */
static void follow_energies(context *c)
{
    const holonom_model *m = c->m;
    double *head = c->s.head;
    const double kinetic = kinetic_energy(c, c->k.momentum), extent = c->number[m->extent_at];
    const double potential = potential_change(c), change = fabs(potential);
    double load = 0.0; /* a thousandth of what the loads could do over the size of the mechanism */
    for (int32_t j = 0; j < m->n_loads; j++)
        load +=
            extent * sqrt(dot(c->number + m->load_at + DIM * j, c->number + m->load_at + DIM * j));
    for (int32_t j = 0; j < m->n_moments * TURNING; j++) load += fabs(c->number[m->moment_at + j]);
    for (int32_t j = 0; j < m->n_body_moments * 3; j++)
        load += fabs(c->number[m->body_moment_at + j]);
    for (int32_t j = 0; j < m->n_elements; j++)
        load += size_of_quantity(c, j) * fabs(linear_bound(c, j).drive);
    load *= 1e-3;
    if (!(load <= head[S_ENERGY_REFERENCE])) head[S_ENERGY_REFERENCE] = load;
    if (!(kinetic <= head[S_ENERGY_REFERENCE])) head[S_ENERGY_REFERENCE] = kinetic;
    if (!(change <= head[S_ENERGY_REFERENCE])) head[S_ENERGY_REFERENCE] = change;
    head[S_LEDGER_ERROR] = relative_balance(c, ledger_balance(c, kinetic, potential));
}

/* Rate of function row j, or value of velocity row j, as below; `before`: the row whose rate was
   computed last, with the same arguments; -1: any. */
static double next_rate(const context *c, int32_t before, int32_t j, const double *v,
                        const double *signal_rate)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j], *entry = m->leaf + 4 * m->leaf_ptr[j];
    double *change = c->k.leaves;
    if (is_next_slip(c, before, j, SLOPES_ALONE))
        return value_of_leaves(c, j, c->m->function_known[j - first_function(c)]);
    for (int32_t l = 0; l < n; l++, entry += 4) {
        if (entry[0] == LEAF_SIGNAL) {
            r->r0[l] = c->s.signal[entry[1]];
            change[l] = signal_rate[entry[1]];
        } else if (entry[0] == LEAF_RATE && l > 0 && entry[-4] == LEAF_VALUE
                   && entry[-3] == entry[1])
            r->r0[l] = change[l] = change[l - 1]; /* as slips have the places and rates of axes */
        else {
            r->r0[l] = quantity_at(c, entry[1], c->s.q, c->s.q_low, v, change + l);
            if (entry[0] == LEAF_RATE) r->r0[l] = change[l];
        }
        r->r1[l] = r->r0[l];
        r->dr[l] = 0.0;
    }
    if (j >= first_velocity_row(c)) return value_of_leaves(c, j, 0);
    double rate = 0.0;
    run_function(c, j);
    for (int32_t l = 0; l < n; l++) rate += r->adjoint[l] * change[l];
    return rate;
}

static double function_rate(const context *c, int32_t j, const double *v, const double *signal_rate)
{ return next_rate(c, -1, j, v, signal_rate); }

/* Rate of form row i, likewise. */
static double form_row_rate(const context *c, int32_t i, const double *v)
{
    double u[DIM], w[DIM], vu[DIM], vw[DIM];
    link_at(c, c->m->row_form[i], c->s.q, c->s.q_low, u, w);
    link_of(c, c->m->row_form[i], v, vu, vw);
    return dot(u, vw) + dot(w, vu);
}

/* Rates of the rows at hand that hold (n_rows, overwritten) at the places and signals of the state,
   with velocities v and rates `signal_rate` of the signals. Linear in both, but for a velocity
   row's own terms. */
HM_SELDOM static void row_rates(const context *c, const double *v, const double *signal_rate,
                                double *rate)
{
    const holonom_model *m = c->m;
    double vw[DIM];
    EACH_FORM_ROW(c, i) rate[i] = form_row_rate(c, i, v);
    for
        IN_ISLAND(c, j, ISLAND_COINCIDENCE)
        link_of(c, m->coincidence_form[j], v, rate + row_of_coincidence(m, j), vw);
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY; k++)
        EACH_ROW_OF_KIND(c, j, k)
            rate[row_of(c, j)] = state_of_row(c, j) == ROW_IS_ON
                                     ? function_rate(c, j, v, signal_rate)
                                     : 0.0;
}

/* Rates of all rows (n_rows), with those that keep directors of bodies orthonormal: turns keep
   them, but velocities of directors need not be those of a turn. */
HM_SELDOM static void all_row_rates(const context *c, double *rate)
{
    row_rates(c, c->s.v, c->k.signal_rate, rate);
    for (int32_t i = first_rigidity_row(c->m); i < c->m->n_form_rows; i++)
        rate[i] = form_row_rate(c, i, c->s.v);
}

/* Part of its scale above which a row may show round-off of places alone, far from where it was
   drawn. */
#define MAY_BE_ROUNDED 1e-12

static int may_be_rounded(const context *c, const double *phi, int32_t i)
{
    return !(fabs(phi[i]) <= MAY_BE_ROUNDED * c->number[c->m->row_scale_at + i]);
}

/* Rows at the state (n_rows, overwritten). */
HM_SELDOM static void row_values(const context *c, double *phi)
{
    const holonom_model *m = c->m;
    double u[DIM], w[DIM];
    for (int32_t i = 0; i < m->n_form_rows; i++) {
        link_at_state(c, m->row_form[i], u, w);
        phi[i] = dot(u, w) - c->number[m->row_constant_at + i];
        if (may_be_rounded(c, phi, i)) phi[i] = row_at_state(c, i);
    }
    for (int32_t j = 0, i = m->n_form_rows; j < m->n_coincidences; j++, i += DIM) {
        link_at_state(c, m->coincidence_form[j], phi + i, w);
        for (int k = 0; k < DIM; k++)
            if (may_be_rounded(c, phi, i + k)) {
                exact_link(c, m->coincidence_form[j], m->alpha_at, m->alpha_turn_at, u, w);
                phi[i + k] = u[k] + w[k];
            }
    }
    if (first_velocity_row(c) > first_function(c)) quantities_at_state(c);
    for (int32_t j = first_function(c); j < first_velocity_row(c); j++)
        phi[row_of(c, j)] =
            state_of_row(c, j) == ROW_IS_ON ? function_value(c, j) - reference_of(c, j) : 0.0;
    for (int32_t j = first_velocity_row(c); j < first_potential(c); j++) phi[row_of(c, j)] = 0.0;
}

/* Whether something takes energy out: parts of a step that go back in time would give it. */
static int is_dissipative(const context *c) { return has_dampers(c) || has_smooth(c); }

#endif
