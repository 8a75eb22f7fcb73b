/* Laws, inputs and signals at their times, and a communication step: pairs of half steps, halving on failure.
   Included once per dimension, after energy.inc.h.                                                             */

enum { MAX_HALVINGS = 6 };

/* Inputs as they are at time t: held, or on the line from the value before to the new one. */
static void load_inputs(const context *c, double t)
{
    const holonom_model *m = c->m;
    const double part = c->span > 0.0 ? fmin(fmax((t - c->start) / c->span, 0.0), 1.0) : 0.0;
    for (int32_t i = 0; i < m->n_inputs; i++) {
        const double before = c->s.inputs_before[i], now = c->s.inputs[i];
        c->number[m->input_at + i] = m->input_ramp[i] ? before + part * (now - before) : now;
    }
    memcpy(c->number + m->parameter_at, c->s.parameters, sizeof(double) * (size_t)m->n_parameters);
}

/* Quantities and their rates in the middle of the step to come, predicted with the accelerations of the same half of
   the last pair.                                                                                             */
static void sense(context *c, double h, int parity)
{
    const holonom_model *m = c->m;
    double *x = c->k.d, *v = c->k.w;
    for (int32_t k = 0; k < DIM * c->n_moving; k++) {
        const double a = c->s.a[parity][k];
        x[k] = c->s.q[k] + 0.5 * h * c->s.v[k] + 0.125 * h * h * a;
        v[k] = c->s.v[k] + 0.5 * h * a;
    }
    for (int32_t j = 0; j < m->n_active; j++) {
        const double turn = 6.283185307179586477;
        double angle = quantity_at(c, j, x, c->s.q_low, v, c->number + m->sensor_rate_at + j);
        if (m->quantity_kind[j] == QUANTITY_ANGLE) { /* the turn next to the state's */
            const double now = quantity_at(c, j, c->s.q, c->s.q_low, NULL, NULL);
            angle -= turn * floor((angle - now) / turn + 0.5);
        }
        c->number[m->sensor_at + j] = angle;
    }
}

/* Runs the tape of the laws at time t. If it writes springs, their stored energy jumps: work of whoever turns them. */
static void set_laws(context *c, double t, int booked)
{
    const holonom_model *m = c->m;
    if (!m->n_tape[1]) return;
    const double before = booked && m->variable_potential ? stored_energy(c) : 0.0;
    load_inputs(c, t);
    c->number[m->time_at] = t;
    hm_run_tape(m, c->number, 1);
    if (booked && m->variable_potential) book(c, S_WORK, stored_energy(c) - before);
}

/* Signals at time t (n_signals, overwritten). */
static void signals_at(context *c, double t, double *signal)
{
    const holonom_model *m = c->m;
    const double law_time = c->number[m->time_at];
    if (!m->n_signals) return;
    load_inputs(c, t);
    c->number[m->time_at] = t;
    hm_run_tape(m, c->number, 2);
    c->number[m->time_at] = law_time;
    memcpy(signal, c->number + m->signal_at, sizeof(double) * (size_t)m->n_signals);
}

/* Rates of the signals at time t by differences of fourth order (n_signals, overwritten). */
static void signal_rates_at(context *c, double t, double *rate)
{
    const holonom_model *m = c->m;
    const double delta = 1e-2 * c->s.head[S_STEP_SIZE], weight[4] = {-1.0, 8.0, -8.0, 1.0};
    const double shift[4] = {2.0, 1.0, -1.0, -2.0}, law_time = c->number[m->time_at];
    for (int32_t b = 0; b < m->n_signals; b++) rate[b] = 0.0;
    for (int i = 0; i < 4 && m->n_signals; i++) {
        load_inputs(c, t);
        c->number[m->time_at] = t + shift[i] * delta;
        hm_run_tape(m, c->number, 2);
        for (int32_t b = 0; b < m->n_signals; b++) rate[b] += weight[i] / (12.0 * delta) * c->number[m->signal_at + b];
    }
    c->number[m->time_at] = law_time;
}

void NAME(hm_set_inputs)(const holonom_model *m, double *number, double *state, double *work,
                         const double *inputs, const double *parameters)
{
    context c;
    open_context(&c, m, number, state, work);
    set_laws(&c, c.t, 0);
    const int changed = memcmp(c.s.inputs, inputs, sizeof(double) * (size_t)m->n_inputs) ||
                        memcmp(c.s.parameters, parameters, sizeof(double) * (size_t)m->n_parameters);
    memcpy(c.s.inputs, inputs, sizeof(double) * (size_t)m->n_inputs);
    memcpy(c.s.parameters, parameters, sizeof(double) * (size_t)m->n_parameters);
    load_inputs(&c, c.t);
    set_laws(&c, c.t, 1);
    if (changed) c.s.head[S_MEAN_TIME] = INFINITY; /* no line through means from before and after a jump */
}

static int32_t single_step(context *c, double h, int parity)
{
    c->h = h;
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

/* One internal step, or the pair of half steps that replaces it: the plain step reflects the velocity normal to
   the constraints, the pair does not, so that its velocities are smooth.                                       */
static int32_t internal_step(context *c, double h)
{
    if (c->s.head[S_PAIRED] == 0.0) {
        const int32_t status = single_step(c, h, (int)c->s.head[S_PARITY]);
        if (!status) average_multipliers(c, c->t - h);
        return status;
    }
    memcpy(c->k.pair_backup, c->s.head, sizeof(double) * (size_t)c->state_size);
    int32_t status = single_step(c, 0.5 * h, 0);
    if (!status) status = single_step(c, 0.5 * h, 1);
    if (!status) average_multipliers(c, c->t - 0.5 * h);
    return status;
}

static int32_t interval(context *c, double h, int halvings)
{
    const double t = c->t, law_time = c->number[c->m->time_at];
    const double newton = c->s.head[S_NEWTON], uzawa = c->s.head[S_UZAWA];
    int32_t status = internal_step(c, h);
    if (!status) return HOLONOM_OK;
    if (c->s.head[S_PAIRED] != 0.0) {
        memcpy(c->s.head, c->k.pair_backup, sizeof(double) * (size_t)c->state_size);
        if (c->m->time_dependent) set_laws(c, law_time, 0); /* the work of what they did is undone too */
    }
    c->t = t;
    c->s.head[S_NEWTON] = newton;
    c->s.head[S_UZAWA] = uzawa;
    if (halvings == MAX_HALVINGS) return status;
    status = interval(c, 0.5 * h, halvings + 1);
    return status ? status : interval(c, 0.5 * h, halvings + 1);
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
    int32_t status = HOLONOM_OK;
    c.span = step;
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
