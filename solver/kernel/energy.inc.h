/* Energies, momenta, residuals of the rows, and the first multipliers. Included once per dimension.          */

static double spring_energy(const context *c)
{
    const holonom_model *m = c->m;
    double sum = 0.0, u[DIM], w[DIM];
    for (int32_t j = 0; j < m->n_lines; j++) {
        if (c->number[m->stiffness_at + j] == 0.0) continue;
        link_at_state(c, m->line_form[j], u, w);
        const double stretch = sqrt(dot(u, u)) - c->number[m->free_length_at + j];
        sum += 0.5 * c->number[m->stiffness_at + j] * stretch * stretch;
    }
    return sum;
}

/* Energy alpha Phi^2/2 that eqs 7, 9 and 11 store in their rows; eq 3 damps its rows and has no potential. */
static double penalty_energy(const context *c)
{
    const holonom_model *m = c->m;
    double sum = 0.0, u[DIM], w[DIM];
    if (!is_penalty(c) || c->formulation == HOLONOM_PENALTY_VELOCITY) return 0.0;
    for (int32_t i = 0; i < m->n_rows; i++) {
        link_at_state(c, m->row_form[i], u, w);
        const double phi = dot(u, w) - c->number[m->row_constant_at + i];
        const double alpha = (c->formulation == HOLONOM_CONSERVING_PENALTY ? 2.0 : 1.0) / row_compliance(c, i);
        sum += 0.5 * alpha * phi * phi;
    }
    return sum;
}

/* Change of the potential energy since the start. Weights act on displacements: on positions they would lose the
   digits by which the mechanism is far from the origin.                                                      */
static double potential_change(const context *c)
{
    const holonom_model *m = c->m;
    const double *gravity = c->number + m->gravity_at, *start = c->number + m->initial_position_at;
    double high = 0.0, low = 0.0;
    for (int32_t a = 0; a < m->n_free; a++) {
        double moved[DIM];
        EACH(k) moved[k] = (c->s.q[DIM * a + k] - start[DIM * a + k]) + c->s.q_low[DIM * a + k];
        hm_add(&high, &low, -c->number[m->node_mass_at + a] * dot(gravity, moved));
    }
    hm_add(&high, &low, spring_energy(c) + penalty_energy(c) - c->s.head[S_STORED_START]);
    return high;
}

/* Momentum of each node, p = M v (DIM n_free, overwritten). */
static void momenta(const context *c, double *p)
{
    const holonom_model *m = c->m;
    memset(p, 0, sizeof(double) * (size_t)(DIM * m->n_free));
    for (int32_t e = 0; e < m->n_mass; e++) {
        const double *v = c->s.v + DIM * m->mass_node[2 * e + 1], *v_low = c->s.v_low + DIM * m->mass_node[2 * e + 1];
        EACH(k) p[DIM * m->mass_node[2 * e] + k] += c->number[m->mass_at + e] * (v[k] + v_low[k]);
    }
}

static double kinetic_energy(const context *c, double *p)
{
    double sum = 0.0;
    momenta(c, p);
    for (int32_t a = 0; a < c->m->n_free; a++) sum += 0.5 * dot(p + DIM * a, c->s.v + DIM * a);
    return sum;
}

/* The reference energy is the largest kinetic energy, or change of potential energy, seen so far. */
static void follow_energy_reference(context *c)
{
    double *head = c->s.head;
    const double kinetic = kinetic_energy(c, c->k.momentum);
    const double change = fabs(potential_change(c));
    double load = 0.0; /* a thousandth of what the loads could do over the size of the mechanism */
    for (int32_t j = 0; j < c->m->n_loads; j++)
        load += sqrt(dot(c->number + c->m->load_at + DIM * j, c->number + c->m->load_at + DIM * j));
    load *= 1e-3 * c->number[c->m->extent_at];
    for (int32_t j = 0; j < c->m->n_moments * (DIM == 2 ? 1 : 3); j++)
        load += 1e-3 * fabs(c->number[c->m->moment_at + j]);
    if (!(load <= head[S_ENERGY_REFERENCE])) head[S_ENERGY_REFERENCE] = load;
    if (!(kinetic <= head[S_ENERGY_REFERENCE])) head[S_ENERGY_REFERENCE] = kinetic;
    if (!(change <= head[S_ENERGY_REFERENCE])) head[S_ENERGY_REFERENCE] = change;
}

/* Phi and dPhi/dt of row i at the state, and the length of its link u. */
typedef struct row_state {
    double phi, rate, length;
} row_state;

static row_state measure_row(const context *c, int32_t i)
{
    const int32_t f = c->m->row_form[i];
    double u[DIM], w[DIM], vu[DIM], vw[DIM];
    link_at_state(c, f, u, w);
    link_of(c, f, c->s.v, vu, vw);
    return (row_state){.phi = dot(u, w) - c->number[c->m->row_constant_at + i],
                       .rate = dot(u, vw) + dot(w, vu),
                       .length = sqrt(dot(u, u))};
}

void NAME(hm_residuals)(const holonom_model *m, const double *number, double *state, double *work, double *phi,
                        double *phi_dot)
{
    context c;
    open_context(&c, m, (double *)number, state, work);
    for (int32_t i = 0; i < m->n_rows; i++) {
        const row_state row = measure_row(&c, i);
        phi[i] = row.phi;
        phi_dot[i] = row.rate;
    }
}

/* sigma_i = (G M^-1 G')_ii with the nodes' shares of the mass, for the scaling of the penalties; extents. */
static void derive_numbers(context *c)
{
    const holonom_model *m = c->m;
    double low[DIM], high[DIM], mass = 0.0, extent2 = 0.0, u[DIM], w[DIM];
    for (int32_t i = 0; i < m->n_rows; i++) {
        const int32_t f = m->row_form[i];
        double sigma = 0.0;
        link_at_state(c, f, u, w);
        for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++) {
            const double alpha = c->number[m->alpha_at + e], beta = c->number[m->beta_at + e];
            EACH(k) sigma += pow(alpha * w[k] + beta * u[k], 2) / c->number[m->node_mass_at + m->form_node[e]];
        }
        c->number[m->row_sigma_at + i] = sigma;
    }
    EACH(k) low[k] = INFINITY;
    EACH(k) high[k] = -INFINITY;
    for (int32_t a = 0; a < m->n_free + m->n_support; a++) {
        const double *x = a < m->n_free ? c->s.q + DIM * a : c->number + m->support_at + DIM * (a - m->n_free);
        EACH(k) low[k] = fmin(low[k], x[k]);
        EACH(k) high[k] = fmax(high[k], x[k]);
        if (a < m->n_free) mass += c->number[m->node_mass_at + a];
    }
    EACH(k) extent2 += pow(high[k] - low[k], 2);
    c->number[m->extent_at] = sqrt(extent2);
    c->number[m->extent_at + 1] = sqrt(mass * extent2);
}

/* First multipliers and accelerations from  M a + G' lambda = Q,  G a = -v'H v,  regularised and iterated so
   that dependent rows do no harm. Uses c->h = 1.                                                             */
static int32_t first_multipliers(context *c)
{
    const holonom_model *m = c->m;
    const int32_t n = DIM * m->n_free, size = n + m->n_rows;
    const int32_t *slot = m->row_slot;
    double *value = c->k.value;
    memset(value, 0, sizeof(double) * (size_t)m->n_lu_values);
    for (int32_t e = 0; e < m->n_mass; e++)
        EACH(k) value[m->mass_slot[DIM * e + k]] += c->number[m->mass_at + e];
    for (int32_t i = 0; i < m->n_rows; i++) {
        const int32_t f = m->row_form[i], free = m->form_free[f];
        double vu[DIM], vw[DIM];
        link_of(c, f, c->s.v, vu, vw);
        slot += DIM * free * free;
        scatter_gradient(c, f, 1.0, c->k.u0 + DIM * f, c->k.w0 + DIM * f, slot, value);
        slot += DIM * free;
        scatter_gradient(c, f, 1.0, c->k.u0 + DIM * f, c->k.w0 + DIM * f, slot, value);
        slot += DIM * free;
        c->k.epsilon[i] = 1e-8 * c->number[m->row_sigma_at + i];
        c->k.phi[i] = 2.0 * dot(vu, vw); /* v'Hv */
        c->k.mu[i] = 0.0;
        value[m->lu_ptr[m->row_position[i]]] -= c->k.epsilon[i];
    }
    if (hm_lu_factor(size, m->lu_ptr, m->lu_target, value)) return HOLONOM_SINGULAR_TANGENT;
    for (int repeat = 0; repeat < 4; repeat++) {
        for (int32_t i = 0; i < m->n_rows; i++) c->k.constraint[i] = c->k.phi[i] + c->k.epsilon[i] * c->k.mu[i];
        gather_rhs(c);
        hm_lu_solve(size, m->lu_ptr, m->lu_column, value, c->k.rhs);
        for (int32_t i = 0; i < m->n_rows; i++) c->k.mu[i] = c->k.rhs[m->row_position[i]];
    }
    for (int32_t a = 0; a < m->n_free; a++)
        EACH(k) c->s.a[0][DIM * a + k] = c->s.a[1][DIM * a + k] = c->k.rhs[m->node_position[a] + k];
    memcpy(c->s.mu[0], c->k.mu, sizeof(double) * (size_t)m->n_rows);
    memcpy(c->s.mu[1], c->k.mu, sizeof(double) * (size_t)m->n_rows);
    memcpy(c->s.mean, c->k.mu, sizeof(double) * (size_t)m->n_rows);
    memcpy(c->s.mean_before, c->k.mu, sizeof(double) * (size_t)m->n_rows);
    c->s.head[S_MEAN_TIME] = c->s.head[S_MEAN_TIME_BEFORE] = c->t;
    return HOLONOM_OK;
}
