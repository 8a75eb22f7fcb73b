/* A communication step: pairs of half steps, halving on failure. Included once per dimension, after composition.inc.h. */

enum { MAX_HALVINGS = 6 };

/* No line through means and changes from before and after a jump. */
static void start_anew(context *c)
{
    c->s.head[S_MEAN_TIME] = INFINITY;
    forget_changes(c);
}

void NAME(hm_set_inputs)(const holonom_model *m, double *number, double *state, double *work,
                         const double *inputs, const double *parameters)
{
    context c;
    open_context(&c, m, number, state, work);
    set_laws(&c, c.t, 0);
    int changed = memcmp(c.s.parameters, parameters, sizeof(double) * (size_t)m->n_parameters) != 0;
    for (int32_t i = 0; i < m->n_inputs; i++) changed |= !m->input_ramp[i] && c.s.inputs[i] != inputs[i];
    memcpy(c.s.inputs, inputs, sizeof(double) * (size_t)m->n_inputs);
    memcpy(c.s.parameters, parameters, sizeof(double) * (size_t)m->n_parameters);
    set_laws(&c, c.t, 1);
    if (changed) start_anew(&c);
}

static int32_t single_step(context *c, double h, int half)
{
    const int parity = half % 2;
    c->h = h;
    c->half = half;
    if (c->m->sensing) sense(c, h, parity);
    if (c->m->time_dependent || c->m->sensing) set_laws(c, c->t + 0.5 * h, 1);
    signals_at(c, c->t + h, c->k.signal1);
    const int32_t status = solve_step(c, parity);
    if (!status) accept_step(c, parity);
    return status;
}

/* mu is constant over a step and has a part that changes sign from step to step: only the mean of two neighbours
   is smooth, and it belongs to the time between them. Two means give the multiplier at the output's time.      */
static void average_multipliers(context *c, double time)
{
    double *head = c->s.head;
    const hm_state *s = &c->s;
    if (!is_telling(c)) return;
    head[S_MEAN_TIME_BEFORE] = head[S_MEAN_TIME];
    head[S_MEAN_TIME] = time;
    for (int32_t i = 0; i < c->m->n_rows; i++) {
        s->mean_before[i] = s->mean[i];
        s->mean[i] = 0.5 * (s->mu[0][i] + s->mu[1][i]);
    }
    for (int32_t k = 0; k < DIM * c->m->n_driven; k++) {
        s->driven_mean_before[k] = s->driven_mean[k];
        s->driven_mean[k] = 0.5 * (s->driven[0][k] + s->driven[1][k]);
    }
}

/* One internal step: pairs of half steps, or the plain step, whose velocities and multipliers are less smooth. */
static int32_t internal_step(context *c, double h)
{
    const int order = (int)c->s.head[S_ORDER];
    int32_t status = HOLONOM_OK;
    if (c->s.head[S_PAIRED] == 0.0 && order == 2) {
        begin_halves(c, 2);
        status = single_step(c, h, (int)c->s.head[S_PARITY]);
        if (!status) average_multipliers(c, c->t - h);
        return status;
    }
    const double dissipated = c->s.head[S_DISSIPATED] - 1e-9 * c->s.head[S_ENERGY_REFERENCE];
    memcpy(c->k.pair_backup, c->s.head, sizeof(double) * (size_t)c->state_size);
    int stages = 1;
    stage(order, 0, &stages);
    begin_halves(c, 2 * stages);
    for (int i = 0; i < stages && !status; i++) {
        const double half = 0.5 * h * stage(order, i, &stages);
        status = single_step(c, half, 2 * i);
        if (!status) status = single_step(c, half, 2 * i + 1);
        if (!status) average_multipliers(c, c->t - half);
    }
    /* Dampers too strong for the parts that go back in time run away, with a ledger that closes. */
    if (!status && order > 2 && !(c->s.head[S_DISSIPATED] >= dissipated)) return HOLONOM_DAMPING_REVERSED;
    return status;
}

static int32_t interval(context *c, double h, int halvings)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    const double newton = c->s.head[S_NEWTON], uzawa = c->s.head[S_UZAWA];
    int32_t status = internal_step(c, h);
    if (!status) return HOLONOM_OK;
    if (c->s.head[S_PAIRED] != 0.0 || c->s.head[S_ORDER] != 2.0) {
        memcpy(c->s.head, c->k.pair_backup, sizeof(double) * (size_t)c->state_size);
        if (c->m->time_dependent) set_laws(c, law_time, 0); /* the work of what they did is undone too */
    }
    c->t = t;
    c->s.head[S_PENALTY_LEVEL] = c->s.head[S_SLOW_STEPS] = 0.0;
    c->s.head[S_NEWTON] = newton;
    c->s.head[S_UZAWA] = uzawa;
    if (halvings == MAX_HALVINGS) return status;
    status = interval(c, 0.5 * h, halvings + 1);
    return status ? status : interval(c, 0.5 * h, halvings + 1);
}

/* How fast input i goes to its new value over a communication step; a held one does not. */
static double ramp_slope(const context *c, int32_t i, double step)
{
    return c->m->input_ramp[i] ? (c->s.inputs[i] - c->s.inputs_before[i]) / step : 0.0;
}

/* Ramped inputs change their slopes at communication points, and with them the rates of signals jump. Velocities jump
   by what that asks for, M dv + G'p = 0, G dv + db/dt = 0; the energy is the drivers' work.                      */
static int32_t start_ramps(context *c, double step)
{
    const holonom_model *m = c->m;
    double *slope = c->s.inputs_slope, *before = c->k.signal1, *jump = c->k.signal_rate;
    int changed = 0;
    for (int32_t i = 0; i < m->n_inputs; i++) changed |= ramp_slope(c, i, step) != slope[i];
    if (!changed) return HOLONOM_OK;
    signal_rates_at(c, c->t, before);
    for (int32_t i = 0; i < m->n_inputs; i++) slope[i] = ramp_slope(c, i, step);
    if (!m->n_signals) return HOLONOM_OK;
    signal_rates_at(c, c->t, jump);
    for (int32_t b = 0; b < m->n_signals; b++) jump[b] -= before[b];
    const double kinetic = kinetic_energy(c, c->k.momentum);
    stand_still(c);
    memcpy(c->k.w + DIM * m->n_free, jump, sizeof(double) * (size_t)(DIM * m->n_driven));
    row_rates(c, c->s.q, c->s.q_low, c->k.w, c->s.signal, jump, c->k.phi);
    c->h = sqrt(2.0);
    inertia(c, c->k.w, c->k.momentum);
    const int32_t status = solve_at_state(c, NULL);
    if (status) return status;
    add_solution(c, c->k.w);
    for (int32_t k = 0; k < DIM * c->n_moving; k++) hm_add(c->s.v + k, c->s.v_low + k, c->k.w[k]);
    book(c, S_WORK, kinetic_energy(c, c->k.momentum) - kinetic);
    start_anew(c);
    return HOLONOM_OK;
}

int32_t NAME(hm_advance)(const holonom_model *m, double *number, double *state, double *work, double step)
{
    context c;
    open_context(&c, m, number, state, work);
    double *head = c.s.head;
    head[S_STATUS] = HOLONOM_BAD_STEP;
    if (!(step > 0.0 && step < 1e300)) return HOLONOM_BAD_STEP;
    const double count = ceil(step / head[S_STEP_SIZE] * (1.0 - 1e-10)); /* robust against the last digit */
    if (!(count < 1e9)) return HOLONOM_BAD_STEP;
    memcpy(c.k.step_backup, head, sizeof(double) * (size_t)c.state_size);
    head[S_NEWTON] = head[S_UZAWA] = head[S_SUBSTEPS] = 0.0;
    const int64_t n = count < 1.0 ? 1 : (int64_t)count;
    const double start = head[S_TIME], h = step / (double)n;
    int32_t status = start_ramps(&c, step);
    set_laws(&c, start, 0);
    for (int64_t i = 0; i < n && !status; i++) {
        c.t = start + h * (double)i;
        status = interval(&c, h, 0);
    }
    if (!status && m->time_dependent) set_laws(&c, start + step, 1);
    if (!status && !(fabs(head[S_WORK]) < INFINITY)) status = HOLONOM_BAD_LAW;
    if (status) {
        memcpy(head, c.k.step_backup, sizeof(double) * (size_t)c.state_size);
        head[S_STATUS] = status;
        return status;
    }
    memcpy(c.s.inputs_before, c.s.inputs, sizeof(double) * (size_t)m->n_inputs);
    head[S_TIME] = start + step;
    head[S_STATUS] = HOLONOM_OK;
    follow_energy_reference(&c);
    return HOLONOM_OK;
}
