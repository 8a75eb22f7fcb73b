/* Start of a run, measurements, and a look into one step. Included once per dimension.                       */

static int all_finite(const double *x, int64_t n)
{
    for (int64_t k = 0; k < n; k++)
        if (!(fabs(x[k]) < INFINITY)) return 0;
    return 1;
}

/* Forces at rest in the step: momentum = -Q with the dampers' forces taken from the velocities. */
static int32_t forces_at_state(context *c)
{
    const holonom_model *m = c->m;
    const size_t bytes = sizeof(double) * (size_t)(DIM * m->n_free);
    memset(c->k.d, 0, bytes);
    memset(c->k.momentum, 0, bytes);
    c->h = 1.0;
    const int32_t status = subtract_forces(c, c->k.momentum);
    for (int32_t j = 0; j < m->n_lines && !status; j++) {
        const double *u = c->k.u0 + DIM * m->line_form[j], damping = c->number[m->damping_at + j];
        double vu[DIM], vw[DIM];
        if (damping == 0.0) continue;
        link_of(c, m->line_form[j], c->s.v, vu, vw);
        add_gradient(c, m->line_form[j], 0.5 * damping * dot(u, vu) / dot(u, u), u, u, c->k.momentum);
    }
    return status;
}

int32_t NAME(hm_initialise)(const holonom_model *m, double *number, double *state, double *work)
{
    context c;
    const size_t bytes = sizeof(double) * (size_t)(DIM * m->n_free);
    open_context(&c, m, number, state, work);
    double *head = c.s.head;
    memset(head + S_KINETIC_START, 0, sizeof(double) * (S_FORMULATION - S_KINETIC_START));
    memset(c.s.q, 0, (size_t)((char *)c.s.inputs - (char *)c.s.q));
    memcpy(c.s.q, number + m->initial_position_at, bytes);
    memcpy(c.s.v, number + m->initial_velocity_at, bytes);
    load_inputs(&c);
    set_laws(&c, head[S_TIME], 0);
    derive_numbers(&c);
    if (!all_finite(number, m->measured_at)) return HOLONOM_NOT_FINITE;
    for (int32_t f = 0; f < m->n_forms; f++) link_at_state(&c, f, c.k.u0 + DIM * f, c.k.w0 + DIM * f);
    int32_t status = forces_at_state(&c);
    if (!status) status = first_multipliers(&c);
    if (status) return status;
    const double kinetic = kinetic_energy(&c, c.k.momentum);
    double mass = 0.0;
    for (int32_t a = 0; a < m->n_free; a++) mass += number[m->node_mass_at + a];
    head[S_KINETIC_START] = kinetic;
    head[S_STORED_START] = spring_energy(&c) + penalty_energy(&c);
    head[S_POTENTIAL_START] = head[S_STORED_START];
    for (int32_t a = 0; a < m->n_free; a++)
        head[S_POTENTIAL_START] -= number[m->node_mass_at + a] * dot(number + m->gravity_at, c.s.q + DIM * a);
    /* A floor, so that a mechanism at rest has a finite relative error. */
    const double gravity = sqrt(dot(number + m->gravity_at, number + m->gravity_at));
    const double floor = 1e-3 * (mass * gravity * number[m->extent_at] + head[S_STORED_START]);
    head[S_ENERGY_REFERENCE] = fmax(kinetic, floor);
    return all_finite(state, c.state_size) ? HOLONOM_OK : HOLONOM_NOT_FINITE;
}

static double *measure_motion(const context *c, double *y)
{
    const holonom_model *m = c->m;
    const int32_t n = DIM * m->n_free;
    double u[DIM], w[DIM], vu[DIM], vw[DIM];
    memcpy(y, c->s.q, sizeof(double) * (size_t)n);
    memcpy(y + n, c->s.v, sizeof(double) * (size_t)n);
    y += 2 * n;
#if DIM == 2
    for (int32_t j = 0; j < m->n_angles; j++) {
        link_at_state(c, m->angle_form[j], u, w);
        link_of(c, m->angle_form[j], c->s.v, vu, vw);
        y[j] = atan2(u[1] + 0.0, u[0]) + 6.283185307179586477 * c->s.turns[j]; /* + 0.0: no negative zero */
        y[m->n_angles + j] = (u[0] * vu[1] - u[1] * vu[0]) / dot(u, u);
    }
#endif
    y += 2 * m->n_angles;
    for (int32_t j = 0; j < m->n_lines; j++) {
        link_at_state(c, m->line_form[j], u, w);
        link_of(c, m->line_form[j], c->s.v, vu, vw);
        const double length = sqrt(dot(u, u)), rate = length > 0.0 ? dot(u, vu) / length : 0.0;
        y[j] = length;
        y[m->n_lines + j] = c->number[m->stiffness_at + j] * (length - c->number[m->free_length_at + j]) +
                            c->number[m->damping_at + j] * rate;
    }
    return y + 2 * m->n_lines;
}

/* Force along each rod, positive in tension, from the multiplier at the present time: the line through the means
   of the last steps.                                                                                         */
static double *measure_rows(const context *c, double *y, double *position, double *velocity)
{
    const holonom_model *m = c->m;
    const double *head = c->s.head, gap = head[S_MEAN_TIME] - head[S_MEAN_TIME_BEFORE];
    const double ahead = gap > 0.0 && gap < INFINITY ? (head[S_TIME] - head[S_MEAN_TIME]) / gap : 0.0;
    *position = *velocity = 0.0;
    for (int32_t i = 0; i < m->n_rows; i++) {
        const row_state row = measure_row(c, i);
        const double scale = c->number[m->row_scale_at + i];
        const double mu = c->s.mean[i] + ahead * (c->s.mean[i] - c->s.mean_before[i]);
        y[i] = mu * 2.0 * row.length;
        const double phi = fabs(row.phi) / scale, rate = fabs(row.rate) / scale;
        if (!(phi <= *position)) *position = phi; /* not fmax, which would hide a NaN */
        if (!(rate <= *velocity)) *velocity = rate;
    }
    return y + m->n_rows;
}

void NAME(hm_measure)(const holonom_model *m, double *number, double *state, double *work)
{
    context c;
    open_context(&c, m, number, state, work);
    const double *head = c.s.head;
    double *y = number + m->measured_at, *p = c.k.momentum, position, velocity;
    if (m->n_tape[1] || m->n_tape[2]) load_inputs(&c);
    set_laws(&c, head[S_TIME], 0);
    number[m->time_at] = head[S_TIME];
    y = measure_rows(&c, measure_motion(&c, y), &position, &velocity);
    const double kinetic = kinetic_energy(&c, p), change = potential_change(&c);
    const double spent = head[S_WORK] - head[S_DISSIPATED];
    y[0] = kinetic;
    y[1] = head[S_POTENTIAL_START] + change;
    y[2] = y[0] + y[1];
    y[3] = head[S_WORK];
    y[4] = head[S_DISSIPATED];
    y[5] = ((kinetic - head[S_KINETIC_START]) + change) - spent;
    y[6] = head[S_ENERGY_REFERENCE] > 0.0 ? fabs(y[5]) / head[S_ENERGY_REFERENCE] : fabs(y[5]);
    y[7] = position;
    y[8] = velocity;
    y += 9;
    EACH(k) y[k] = 0.0;
    for (int32_t a = 0; a < m->n_free; a++) EACH(k) y[k] += p[DIM * a + k];
    y += DIM;
    memset(y, 0, sizeof(double) * (DIM == 2 ? 1 : 3));
    for (int32_t a = 0; a < m->n_free; a++) {
        const double *x = c.s.q + DIM * a, *pa = p + DIM * a;
#if DIM == 2
        y[0] += x[0] * pa[1] - x[1] * pa[0];
#else
        EACH(k) y[k] += x[(k + 1) % 3] * pa[(k + 2) % 3] - x[(k + 2) % 3] * pa[(k + 1) % 3];
#endif
    }
    y += DIM == 2 ? 1 : 3;
    y[0] = head[S_NEWTON];
    y[1] = head[S_UZAWA];
    y[2] = head[S_SUBSTEPS];
    y[3] = head[S_STATUS];
    hm_run_tape(m, number, 2);
}

int32_t NAME(hm_probe)(const holonom_model *m, double *number, double *state, double *work, double h,
                       const double *w, const double *mu, const double *x, double *r, double *tx)
{
    context c;
    const int32_t n = DIM * m->n_free, size = n + m->n_rows;
    open_context(&c, m, number, state, work);
    c.h = h;
    prepare_step(&c, 0);
    for (int32_t k = 0; k < n; k++) {
        c.k.w[k] = w[k];
        c.k.d[k] = c.k.hv[k] + w[k];
    }
    for (int32_t i = 0; i < m->n_rows; i++) {
        c.k.mu[i] = mu[i];
        c.k.lambda[i] = 0.0;
    }
    int32_t status = evaluate_residual(&c);
    if (!status) status = assemble_tangent(&c);
    if (status) return status;
    double *in = c.k.rhs, *out = c.k.step_backup;
    for (int32_t k = 0; k < n; k++) in[m->node_position[k / DIM] + k % DIM] = x[k];
    for (int32_t i = 0; i < m->n_rows; i++) in[m->row_position[i]] = x[n + i];
    hm_lu_multiply(size, m->lu_ptr, m->lu_column, c.k.value, in, out);
    for (int32_t k = 0; k < n; k++) tx[k] = out[m->node_position[k / DIM] + k % DIM];
    for (int32_t i = 0; i < m->n_rows; i++) tx[n + i] = out[m->row_position[i]];
    memcpy(r, c.k.momentum, sizeof(double) * (size_t)n);
    memcpy(r + n, c.k.constraint, sizeof(double) * (size_t)m->n_rows);
    return HOLONOM_OK;
}
