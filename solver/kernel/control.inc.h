/* Internal steps as long, and of the order, that a tolerance asks for. Included once per dimension, after interval.inc.h.

   The differences from two embedded solutions, e_high ~ (omega h)^(r+1) and e_low ~ (omega h)^(l+1), tell the error of the
   step's own order p, C e_high (e_high/e_low)^((p-r)/(r-l)), and the first how fast the motion changes.
   A step may add tolerance h/horizon, so that a run over the horizon ends with an error of the tolerance.           */

enum { N_ORDERS = 4, MAX_REPEATS = 40 };
#define SAFETY 0.5    /* of what a step may add, aimed at */
#define REJECTED 2.0  /* times what a step may add */
static const int ORDERS[N_ORDERS] = {2, 4, 6, 8}, N_STAGES[N_ORDERS] = {1, 5, 9, 15};

/* By order p: r and r - l; error over e_high (e_high/e_low)^((p-r)/(r-l)); omega h over e_high^(1/(r+1)); error over
   (omega h)^(p+1): means over mechanisms; largest omega h at which Newton's iteration still converges well.          */
static const double HIGH[N_ORDERS] = {2.0, 3.0, 4.0, 5.0}, GAP[N_ORDERS] = {2.0, 1.0, 2.0, 2.0};
static const double ERROR[N_ORDERS] = {1.1e-2, 2.5e-3, 4e-3, 5e-4};
static const double RATE[N_ORDERS] = {1.0, 2.7, 2.9, 2.6};
static const double PREDICTED[N_ORDERS] = {1.1e-2, 5e-5, 5e-6, 1e-7};
static const double FASTEST[N_ORDERS] = {1.0, 1.5, 2.0, 2.5};

typedef struct step_error {
    double rate;  /* omega [1/s]                                              */
    double size;  /* error over the mean one of that order at this rate       */
    double share; /* error over what the step may add                         */
} step_error;

static inline int index_of(int order) { return order / 2 - 1; }

/* Whether something takes energy out: parts of a step that go back in time would give it. */
static int is_dissipative(const context *c)
{
    if (c->formulation == HOLONOM_PENALTY_VELOCITY) return 1;
    for (int32_t j = 0; j < c->m->n_elements; j++)
        if (c->number[c->m->damping_at + j] != 0.0) return 1;
    return 0;
}

static double mass_norm(const context *c, const double *x)
{
    double sum = 0.0;
    for (int32_t a = 0; a < c->m->n_free; a++) sum += c->number[c->m->node_mass_at + a] * dot(x + DIM * a, x + DIM * a);
    return sqrt(sum);
}

/* Speed of the mechanism, in the mass norm; 0 only as long as nothing has moved or could. */
static double speed_scale(const context *c)
{
    return fmax(sqrt(2.0 * c->s.head[S_ENERGY_REFERENCE]), mass_norm(c, c->s.v));
}

/* Mass norms of a difference in q and in v, relative to size and speed of the mechanism. */
static double relative_size(const context *c, double of_q, double of_v)
{
    const double speed = speed_scale(c);
    return hypot(of_q / c->number[c->m->extent_at + 1], speed > 0.0 ? of_v / speed : 0.0);
}

/* The differences for a pair, which has no stages: from the rate of change of the mean acceleration of pairs. */
static int differences_of_pairs(const context *c, double h, double *high, double *low)
{
    const int64_t n = DIM * c->n_moving;
    const double *first = c->s.a[0], *second = c->s.a[1], *change = c->s.a_change;
    const double between = 0.5 * (h + c->s.head[S_LAST_LENGTH]);
    double *rate = c->k.estimate;
    c->s.head[S_LAST_LENGTH] = h;
    if (c->s.head[S_KNOWN] < 4.0) return 0;
    for (int64_t k = 0; k < n; k++) /* means (a_1 + a_2)/2 of this pair, and of that before from its halves' changes */
        rate[k] = (0.5 * (second[k] - first[k]) + change[k] + 0.5 * change[3 * n + k]) / between;
    const double of_rate = mass_norm(c, rate), speed = mass_norm(c, c->s.v);
    const double omega = speed > 0.0 ? sqrt(of_rate / speed) : 0.0;
    *high = h * h * h * relative_size(c, of_rate, omega * of_rate);
    *low = h * relative_size(c, speed, mass_norm(c, second));
    return 1;
}

/* Error of a run that is asked for, relative to size and speed. */
static double tolerated(const context *c)
{
    return c->s.head[S_TOLERANCE] + c->s.head[S_ABSOLUTE_TOLERANCE] / c->number[c->m->extent_at];
}

/* Error of the last step, of length h; 0 where nothing tells it yet. */
static int estimate_error(const context *c, int order, double h, step_error *e)
{
    const int64_t n = DIM * c->n_moving;
    const int p = index_of(order);
    const double *x = c->k.estimate, *head = c->s.head;
    double high, low;
    if (order > 2) {
        high = relative_size(c, mass_norm(c, x), mass_norm(c, x + n));
        low = relative_size(c, mass_norm(c, x + 2 * n), mass_norm(c, x + 3 * n));
    } else if (!differences_of_pairs(c, h, &high, &low)) return 0;
    const double ratio = low > 0.0 ? fmin(high / low, 1e3) : 0.0;
    const double error = ERROR[p] * high * pow(ratio, (order - HIGH[p]) / GAP[p]);
    const double turned = RATE[p] * pow(high, 1.0 / (HIGH[p] + 1.0));
    e->rate = turned / h;
    e->size = turned > 0.0 ? error / (PREDICTED[p] * pow(turned, order + 1)) : 0.0;
    e->share = error * head[S_HORIZON] / (h * tolerated(c));
    /* Velocities are only known to round-off of places over h: shorter steps would show more of it, not less error. */
    const double round_off = 1e-13 * (1.0 + c->number[c->m->extent_at + 1] / (h * fmax(speed_scale(c), 1e-300)));
    if (high <= round_off) e->share = fmin(e->share, SAFETY);
    return 1;
}

/* Length of a step of an order that adds what it may, at the rate and size of the last error. */
static double length_for(const context *c, int p, const step_error *e)
{
    const double *head = c->s.head;
    const double may = SAFETY * tolerated(c) / (PREDICTED[p] * e->size * e->rate * head[S_HORIZON]);
    return fmin(pow(may, 1.0 / ORDERS[p]), FASTEST[p]) / e->rate;
}

/* Order and length of the steps to come, for the least number of pairs in a communication step of length `step`. */
static void choose_order(context *c, const step_error *e, double step)
{
    double *head = c->s.head, least = INFINITY;
    const int present = index_of((int)head[S_ORDER_IN_USE]);
    int best = present;
    for (int p = 0; p < N_ORDERS; p++) {
        const double h = fmin(length_for(c, p, e), head[S_LONGEST_STEP]);
        const double n = fmax(1.0, ceil(step / h * (1.0 - 1e-10))), iterations = 2.0 + 3.0 * e->rate * step / n;
        const double cost = N_STAGES[p] * n * iterations * (p == present ? 0.8 : 1.0);
        if (!(cost < least) || 2 * N_STAGES[p] > c->m->n_slots) continue;
        least = cost;
        best = p;
    }
    if (best == present) return;
    head[S_ORDER_IN_USE] = ORDERS[best];
    head[S_WANTED] = length_for(c, best, e);
}

/* Order to begin with, and a length that is safe: a part of the time in which the motion changes. */
static void begin_control(context *c)
{
    double *head = c->s.head;
    const double asked = head[S_ORDER], size = c->number[c->m->extent_at + 1];
    if (is_dissipative(c)) head[S_ORDER_IN_USE] = 2.0;
    else if (asked > 0.0) head[S_ORDER_IN_USE] = asked;
    else if (head[S_ORDER_IN_USE] == 0.0) head[S_ORDER_IN_USE] = 4.0;
    if (head[S_WANTED] > 0.0) return;
    const double speed = mass_norm(c, c->s.v) / size;
    const double rate = sqrt(mass_norm(c, c->s.a[0]) / size + speed * speed); /* 0: at rest, and for ever */
    head[S_WANTED] = rate > 0.0 ? 0.5 / rate * pow(head[S_TOLERANCE], 1.0 / (head[S_ORDER_IN_USE] + 1.0)) : INFINITY;
}

/* What the last step, of length h, says of the next ones; 1 if it is to be repeated with shorter ones. */
static int is_rejected(context *c, double h, double step)
{
    step_error e;
    const int order = (int)c->s.head[S_ORDER_IN_USE];
    if (!estimate_error(c, order, h, &e)) return 0;
    const double change = pow(SAFETY / fmax(e.share, 1e-30), 1.0 / order);
    c->s.head[S_WANTED] = h * fmin(fmax(change, 0.2), 2.0);
    if (e.share > REJECTED) return 1;
    if (c->s.head[S_ORDER] == 0.0 && !is_dissipative(c) && e.size > 0.0) choose_order(c, &e, step);
    return 0;
}

/* Covers a communication step of length `step` from `start`; its end is met exactly. */
static int32_t cover_to_tolerance(context *c, double start, double step)
{
    double *head = c->s.head, done = 0.0;
    int repeats = 0;
    begin_control(c);
    while (done < step) {
        const double rest = step - done, longest = fmin(head[S_WANTED], head[S_LONGEST_STEP]);
        /* A pair is judged by the one before it: after a jump two are needed, or none would ever be judged. */
        const double least = head[S_ORDER_IN_USE] == 2.0 && head[S_KNOWN] < 2.0 ? 2.0 : 1.0;
        const double n = fmax(least, ceil(rest / longest * (1.0 - 1e-10))), h = rest / n;
        const double law_time = c->number[c->m->time_at];
        if (!(n < 1e9)) return HOLONOM_BAD_STEP;
        c->t = start + done;
        const int32_t status = internal_step(c, h);
        const int rejected = status ? 1 : is_rejected(c, h, step);
        if (status || (rejected && repeats < MAX_REPEATS)) {
            const double raised = head[S_PENALTY_LEVEL], wanted = status ? 0.5 * h : head[S_WANTED];
            if (++repeats > MAX_REPEATS) return status;
            undo_step(c, start + done, law_time);
            head[S_WANTED] = wanted;
            if (!status) head[S_PENALTY_LEVEL] = raised; /* it was solved, only not short enough */
            if (status && known_changes(c)) { /* Newton's iteration may only have begun too far away */
                forget_changes(c);
                head[S_WANTED] = h;
            }
            continue;
        }
        repeats = 0;
        done = n == 1.0 ? step : done + h;
        follow_energy_reference(c);
    }
    return HOLONOM_OK;
}

/* Covers a communication step by equal steps of at most the option step_size, of the order asked for. */
static int32_t cover_evenly(context *c, double start, double step)
{
    double *head = c->s.head;
    const double n = fmax(1.0, ceil(step / head[S_STEP_SIZE] * (1.0 - 1e-10))), h = step / n;
    int32_t status = n < 1e9 ? HOLONOM_OK : HOLONOM_BAD_STEP;
    head[S_ORDER_IN_USE] = fmax(head[S_ORDER], 2.0);
    if (is_dissipative(c) && !is_extrapolating(c)) head[S_ORDER_IN_USE] = 2.0;
    for (int64_t i = 0; !status && i < (int64_t)n; i++) {
        c->t = start + h * (double)i;
        status = interval(c, h, 0);
    }
    if (c->unweighted) head[S_ORDER_IN_USE] = 2.0;
    return status;
}
