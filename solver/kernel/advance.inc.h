/* A communication step: laws at their times, pairs of half steps, halving on failure. Included once per
   dimension, after step.inc.h and energy.inc.h.                                                             */

enum { MAX_HALVINGS = 6 };

/* Runs the second tape at time t. If it writes springs, their stored energy jumps: work of whoever turns them. */
static void set_laws(context *c, double t, int booked)
{
    const holonom_model *m = c->m;
    if (!m->n_tape[1]) return;
    const double before = booked && m->variable_potential ? spring_energy(c) : 0.0;
    c->number[m->time_at] = t;
    hm_run_tape(m, c->number, 1);
    if (booked && m->variable_potential)
        hm_add(c->s.head + S_WORK, c->s.head + S_WORK_LOW, spring_energy(c) - before);
}

static void load_inputs(context *c)
{
    const holonom_model *m = c->m;
    memcpy(c->number + m->input_at, c->s.inputs, sizeof(double) * (size_t)m->n_inputs);
    memcpy(c->number + m->parameter_at, c->s.parameters, sizeof(double) * (size_t)m->n_parameters);
}

void NAME(hm_set_inputs)(const holonom_model *m, double *number, double *state, double *work,
                         const double *inputs, const double *parameters)
{
    context c;
    open_context(&c, m, number, state, work);
    load_inputs(&c);
    set_laws(&c, c.t, 0);
    const int changed = memcmp(c.s.inputs, inputs, sizeof(double) * (size_t)m->n_inputs) ||
                        memcmp(c.s.parameters, parameters, sizeof(double) * (size_t)m->n_parameters);
    memcpy(c.s.inputs, inputs, sizeof(double) * (size_t)m->n_inputs);
    memcpy(c.s.parameters, parameters, sizeof(double) * (size_t)m->n_parameters);
    load_inputs(&c);
    set_laws(&c, c.t, 1);
    if (changed) c.s.head[S_MEAN_TIME] = INFINITY; /* no line through means from before and after a jump */
}

static int32_t single_step(context *c, double h, int parity)
{
    c->h = h;
    if (c->m->time_dependent) set_laws(c, c->t + 0.5 * h, 1);
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
    if (m->n_tape[1]) load_inputs(&c);
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
    head[S_TIME] = start + step;
    head[S_STATUS] = HOLONOM_OK;
    follow_energy_reference(&c);
    return HOLONOM_OK;
}
