/* One conserving step: Uzawa's iteration around Newton's. Included once per dimension, after predict.inc.h.      */

/* Whether a step is long enough to tell an acceleration and a multiplier: rounding errors enter both over h^2. A
   shorter one leaves those of the last step, which are as good, and the constraints' round-off as it is.       */
static inline int is_telling(const context *c) { return fabs(c->h) >= 1e-5 * c->s.head[S_STEP_SIZE]; }

/* Rows at the beginning of the step, to the last digit where they are quadratic. */
static void rows_at_start(context *c)
{
    const holonom_model *m = c->m;
    const int exact = is_telling(c) || is_penalty(c);
    for (int32_t i = 0; i < m->n_form_rows; i++) c->k.phi0[i] = exact ? row_at_state(c, i) : 0.0;
    for (int32_t j = 0; j < m->n_coincidences; j++)
        EACH(k) {
            double high = 0.0, low = 0.0;
            if (exact) exact_link(c, m->coincidence_form[j], k, m->alpha_at, m->alpha_turn_at, &high, &low);
            c->k.phi0[m->n_form_rows + DIM * j + k] = high + low;
        }
    for (int32_t j = first_function(c); j < first_velocity_row(c); j++)
        c->k.phi0[row_of(c, j)] = exact ? function_value(c, j) : 0.0;
    for (int32_t j = first_velocity_row(c); j < first_potential(c); j++) c->k.phi0[row_of(c, j)] = 0.0;
}

/* Whether no direction is about to turn by more than 2.5 rad: a step would take the shorter way round, with an exact
   ledger and the wrong motion.                                                                               */
static int turns_little(const context *c)
{
    for (int32_t a = 0; a < c->n_moving; a++)
        if (c->m->node_kind[a] && !(dot(c->k.hv + DIM * a, c->k.hv + DIM * a) <= 6.25)) return 0;
    return 1;
}

/* Part of the last multipliers that is forgotten at the beginning of a step where rows depend on each other. What
   they leave undetermined would otherwise grow without bound, since every solve adds their inconsistency, a rounding
   error of the drawn configuration, over epsilon. What is determined comes back in the first solves.             */
#define LEAK 1e-3

/* Links, rows, compliances, warm start and predictor at the beginning of a step of length c->h. */
static void prepare_step(context *c, int parity)
{
    const holonom_model *m = c->m;
    const double h = c->h;
    links_at_start(c);
    const int reach = known_changes(c);
    const int64_t n = DIM * c->n_moving;
    double *const *a = c->s.a, *const *mu = c->s.mu;
    for (int32_t k = 0; k < n; k++) { /* w is h^2/2 times an acceleration */
        c->k.hv[k] = h * c->s.v[k] + h * c->s.v_low[k];
        c->k.w[k] = 0.5 * h * h * predicted(c, reach, a[parity], a[1 - parity], c->s.a_change, n, k);
        c->k.d[k] = c->k.hv[k] + c->k.w[k];
    }
    for (int32_t k = DIM * m->n_free, b = 0; k < DIM * c->n_moving; k++, b++) { /* driven nodes go where they must */
        c->k.d[k] = (c->k.signal1[b] - c->s.q[k]) - c->s.q_low[k];
        c->k.w[k] = c->k.d[k] - c->k.hv[k];
    }
    rows_at_start(c);
    const int dependent = c->s.head[S_DEPENDENT] != 0.0;
    const double kept = dependent ? 1.0 - LEAK : 1.0;
    const int mu_reach = dependent ? 0 : reach; /* a line would amplify what rows leave undetermined */
    for (int32_t i = 0; i < m->n_rows; i++) {
        c->k.epsilon[i] = row_compliance(c, i);
        c->k.mu[i] = kept * predicted(c, mu_reach, mu[parity], mu[1 - parity], c->s.mu_change, m->n_rows, i);
    }
}

/* Uzawa update: the total multiplier becomes the one held fixed. The paper's eq 16 adds alpha (Phi_n + Phi_1)/2
   to lambda; with lambda + alpha/2 Phi_n held here, this leaves an extra alpha/2 Phi_n and the fixed point
   Phi_1 = -Phi_n. A conserving penalty holds alpha/2 Phi_n, the others nothing.                               */
static void update_multipliers(context *c)
{
    const int paper = c->s.head[S_PAPER_UPDATE] != 0.0;
    for (int32_t i = 0; i < c->m->n_rows; i++) {
        double lambda = is_penalty(c) ? 0.0 : c->k.mu[i];
        if ((c->formulation == HOLONOM_CONSERVING_AL && paper) || c->formulation == HOLONOM_CONSERVING_PENALTY)
            lambda += c->k.phi0[i] / c->k.epsilon[i];
        c->k.lambda[i] = lambda;
    }
}

/* Largest |Phi|/l^2 of the rows that the Uzawa update drives to zero. */
static double constraint_defect(const context *c)
{
    const int averaged = c->formulation == HOLONOM_CONSERVING_AL && c->s.head[S_PAPER_UPDATE] != 0.0;
    double largest = 0.0;
    for (int32_t i = 0; i < c->m->n_rows; i++) {
        const double phi = averaged ? 0.5 * (c->k.phi0[i] + c->k.phi[i]) : c->k.phi[i];
        const double scaled = fabs(phi) / c->number[c->m->row_scale_at + i];
        if (!(scaled <= largest) && largest == largest) largest = scaled; /* a NaN stays */
    }
    return largest;
}

typedef struct newton_record {
    double theta, eta, size; /* contraction; in the mass norm, the last increment and d [kg^1/2 m]               */
    double target, floor;    /* tolerance and round-off of increments                                          */
    double energy, noise;    /* reference energy, and kinetic energy of the round-off of positions [J]          */
    int factorised, total, stiffened;
    int updates;         /* Uzawa updates of the step                                                             */
} newton_record;

/* Solves for one Newton increment and adds it; its size, that of d, and what they are measured against. */
static int32_t newton_update(context *c, newton_record *r)
{
    const holonom_model *m = c->m;
    double *rhs = c->k.rhs, increment2 = 0.0, size2 = 0.0;
    gather_rhs(c);
    hm_lu_solve(DIM * m->n_free + m->n_rows, c->lu->lu_ptr, c->lu->lu_column, c->k.value, rhs);
    for (int32_t a = 0; a < c->n_moving; a++) {
        const double mass = c->number[m->node_mass_at + a];
        double *w = c->k.w + DIM * a, *d = c->k.d + DIM * a;
        if (a < m->n_free) {
            const double *x = rhs + c->lu->node_position[a];
            EACH(k) w[k] += x[k];
            EACH(k) d[k] = c->k.hv[DIM * a + k] + w[k];
            increment2 += mass * dot(x, x);
        }
        size2 += mass * dot(d, d);
    }
    for (int32_t i = 0; i < m->n_rows; i++) c->k.mu[i] += rhs[c->lu->row_position[i]];
    const double reference = c->s.head[S_ENERGY_REFERENCE], h2 = c->h * c->h;
    r->eta = sqrt(increment2);
    r->size = sqrt(size2);
    r->target = c->s.head[S_NEWTON_TOLERANCE] * sqrt(size2 + 2.0 * h2 * reference);
    r->energy = 0.5 * size2 / h2 + reference;
    r->noise = 0.5 * r->floor * r->floor / h2;
    r->total++;
    return r->eta < 1e150 && r->size < 1e150 ? HOLONOM_OK : HOLONOM_NOT_FINITE;
}

/* A step's error must lie far below the tolerance: what is left in momentum or constraints has one sign over
   many steps and adds up in the energy (measured: double pendulum, h = 1e-3, 2e5 steps, |dE| 4.8e-11 J with
   margins of 1e-4 and 1e-3, 4e-14 J with these). The factors are kept, so that the last digits cost little.   */
#define NEWTON_MARGIN 1e-6
#define CONSTRAINT_MARGIN 1e-5
#define QUARTER_ULP 5.6e-17 /* of 1: no row is evaluated better */
/* Energy that the momentum residual may add: with near-singular factors increments shrink before the residual does,
   so it is asked for by itself; where round-off ends the iteration it must still be no more than round-off.      */
#define ENERGY_MARGIN 1e-3
#define ENERGY_LIMIT 1e4

/* Energies that unfinished iterations would add: v'R by the momentum balance, Phi'mu by the constraints. Small
   increments alone do not tell that a step is solved: they also become small where mu grows beyond all bounds. */
static double residual_energy(const context *c)
{
    double sum = 0.0;
    for (int32_t k = 0; k < DIM * c->m->n_free; k++) sum += c->k.d[k] * c->k.momentum[k];
    return fabs(sum / c->h); /* h < 0 in the parts of a composition that go back */
}

static double constraint_energy(const context *c)
{
    double sum = 0.0;
    for (int32_t i = 0; i < c->m->n_rows; i++) sum += c->k.phi[i] * c->k.mu[i];
    return fabs(sum);
}

/* Raises the penalty of the step at hand a thousandfold, twice at most. Where the singular configuration lies
   between the midpoint and the end of a step, the gradients there differ in sign along one combination of rows;
   if both are small, the Uzawa factor 1/(1 + chi g_1 g_m/sigma) of that combination has its pole nearby.         */
static int stiffen(context *c, int *stiffened)
{
    if (is_penalty(c) || *stiffened >= 2) return 0;
    *stiffened += 1;
    for (int32_t i = 0; i < c->m->n_rows; i++) c->k.epsilon[i] *= 1e-3;
    return 1;
}

/* From this penalty on, an Uzawa update contracts far better than a Newton iteration, and the multipliers of a nested
   iteration need not wait for its end: an inner solve has to be no more exact than the outer one (inexact Uzawa). */
#define EARLY_UPDATE_PENALTY 1e6
#define GOOD_CONTRACTION 0.05

/* Lean factors leave stiffness out, h^2 |sum mu_i H_i|/4m and h^2 k/4m against 1, which is then their contraction.
   From this one on full factors cost less; they are used for a while, each time for twice as many steps.       */
#define LEAN_CONTRACTION 3e-3

static void choose_factors(context *c)
{
    double *head = c->s.head;
    const int is_tried = c->m->n_lean_values && is_conserving(c) && !is_penalty(c);
    c->lu = is_tried && head[S_FULL_STEPS] == 0.0 ? &c->m->lean : &c->m->full;
    if (head[S_FULL_STEPS] > 0.0) head[S_FULL_STEPS] -= 1.0;
}

static void give_up_lean(context *c, newton_record *r)
{
    double *head = c->s.head;
    if (!is_lean(c) || r->theta <= LEAN_CONTRACTION || r->eta <= r->floor) return;
    head[S_FULL_STEPS] = head[S_FULL_WAIT] = fmin(fmax(2.0 * head[S_FULL_WAIT], 64.0), 4096.0);
    c->lu = &c->m->full;
    r->factorised = 0;
    r->theta = 1.0;
}

/* Newton iteration after which lambda may follow early. Multipliers that dependent rows share get the rounding errors
   of a solve over epsilon, which the next one with lambda held removes: the update waits for it.               */
static int first_early_update(const context *c)
{
    const double *head = c->s.head;
    if (is_penalty(c) || head[S_SIMULTANEOUS] != 0.0 || head[S_PENALTY] < EARLY_UPDATE_PENALTY) return INT_MAX;
    return head[S_DEPENDENT] != 0.0 ? 1 : 0;
}

/* Uzawa update, and what it changes in the residual of the rows. */
static void hold_multipliers(context *c, newton_record *r)
{
    update_multipliers(c);
    r->updates++;
    for (int32_t i = 0; i < c->m->n_rows; i++)
        c->k.constraint[i] = c->k.phi[i] - c->k.epsilon[i] * (c->k.mu[i] - c->k.lambda[i]);
}

/* Newton iteration with lambda held fixed (nested) or following mu (simultaneous; nested, while it contracts well).
   The error left behind is estimated from the observed contraction theta. It ends a margin below the tolerance, or
   where round-off stops the contraction below the tolerance. The factors are kept while they contract well.   */
static int32_t iterate_newton(context *c, newton_record *r)
{
    const int simultaneous = c->s.head[S_SIMULTANEOUS] != 0.0;
    const int max_newton = (int)c->s.head[S_MAX_NEWTON], first_update = first_early_update(c);
    const double tolerance = c->s.head[S_NEWTON_TOLERANCE];
    double previous = 0.0, defect = 0.0;
    for (int iteration = 0; iteration < max_newton; iteration++) {
        int32_t status = HOLONOM_OK;
        const int keep = r->factorised && r->theta < GOOD_CONTRACTION;
        if (!keep) {
            status = factorise(c);
            if (status) return status;
            r->factorised = 1;
        }
        status = newton_update(c, r);
        if (status) return status;
        /* First increment with new factors: nothing is known but its size against the step's. */
        if (iteration > 0 && previous > 0.0) r->theta = r->eta / previous;
        else if (!keep) r->theta = r->eta < 0.02 * r->size ? 0.04 : 1.0;
        previous = r->eta;
        if (simultaneous) update_multipliers(c);
        status = evaluate_residual(c);
        if (status) return status;
        const double left = iteration > 0 || keep ? r->theta * r->eta : r->eta;
        const int stalled = iteration > 1 && r->theta > 0.5 && r->eta <= fmax(r->target, r->floor);
        if (simultaneous && !is_penalty(c)) defect = constraint_defect(c);
        const double added = residual_energy(c);
        if (left <= NEWTON_MARGIN * r->target && defect <= fmax(CONSTRAINT_MARGIN * tolerance, QUARTER_ULP) &&
            added <= ENERGY_MARGIN * (tolerance * r->energy + r->noise))
            return HOLONOM_OK;
        if (stalled && defect <= tolerance && added <= ENERGY_LIMIT * tolerance * r->energy + r->noise) return HOLONOM_OK;
        if (simultaneous && iteration > 1 && r->theta > 0.25 && stiffen(c, &r->stiffened)) {
            update_multipliers(c);
            if ((status = evaluate_residual(c))) return status;
            r->factorised = 0;
            r->theta = 1.0;
        } else if (iteration >= first_update && r->theta < GOOD_CONTRACTION)
            hold_multipliers(c, r);
        if (iteration > 0) give_up_lean(c, r);
    }
    if (!(r->eta <= r->target && residual_energy(c) <= ENERGY_LIMIT * tolerance * r->energy + r->noise))
        return HOLONOM_NEWTON_DIVERGED;
    return defect <= tolerance ? HOLONOM_OK : HOLONOM_UZAWA_DIVERGED;
}

/* In long chains the least eigenvalue of G M^-1 G' falls like 1/N^2, and Uzawa's iteration needs more updates the longer
   they are. Where steps have needed two or more again and again, the penalty of those to come is a hundred times
   larger, twice at most. Not from the start, and with dependent rows, whose rounding errors it multiplies, only where
   `outer` updates are many: those that a converged Newton iteration did not bring along.                     */
static void follow_contraction(double *head, int updates, int outer)
{
    const int slow = head[S_DEPENDENT] != 0.0 ? outer >= 3 : updates >= 2;
    head[S_SLOW_STEPS] = slow ? head[S_SLOW_STEPS] + 1.0 : 0.0;
    if (head[S_SLOW_STEPS] < 8.0 || head[S_PENALTY_LEVEL] >= 2.0) return;
    head[S_PENALTY_LEVEL] += 1.0;
    head[S_SLOW_STEPS] = 0.0;
}

/* One step: outer Uzawa iteration around the inner Newton iteration (paper, section 2.2 and eq 15, 16). */
static int32_t solve_step(context *c, int parity)
{
    double *head = c->s.head, last = INFINITY;
    const double tolerance = head[S_NEWTON_TOLERANCE];
    const int max_uzawa = (int)head[S_MAX_UZAWA], single = is_penalty(c) || head[S_SIMULTANEOUS] != 0.0;
    newton_record r = {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0, 0, 0, 0};
    prepare_step(c, parity);
    choose_factors(c);
    update_multipliers(c);
    int32_t status = turns_little(c) ? evaluate_residual(c) : HOLONOM_TURN_TOO_LARGE;
    int uzawa = 0;
    r.floor = 32.0 * 2.3e-16 * c->number[c->m->extent_at + 1];
    for (; !status; uzawa++) {
        status = iterate_newton(c, &r);
        head[S_NEWTON] += r.total;
        r.total = 0;
        if (status || single) break;
        const double defect = constraint_defect(c);
        if (!(defect < INFINITY)) return HOLONOM_NOT_FINITE;
        if (defect <= fmax(CONSTRAINT_MARGIN * tolerance, QUARTER_ULP)) break;
        /* Near a singular configuration one combination of rows contracts slowly, or not at all. It need not go on
           where its energy is round-off; else the penalty is raised; contraction that ends even so is round-off. */
        const double energy = constraint_energy(c);
        if (defect > 0.5 * last && defect <= tolerance && energy <= CONSTRAINT_MARGIN * tolerance * r.energy) break;
        if (defect > 0.25 * last && defect > 10.0 * last / (1.0 + head[S_PENALTY]) && stiffen(c, &r.stiffened))
            r.factorised = 0;
        else if (defect > 0.9 * last && defect <= tolerance) break;
        if (uzawa >= max_uzawa) {
            if (defect <= tolerance && energy <= tolerance * r.energy + r.noise) break;
            return HOLONOM_UZAWA_DIVERGED;
        }
        last = defect;
        hold_multipliers(c, &r);
    }
    c->lu = &c->m->full;
    head[S_UZAWA] += r.updates;
    if (!status && !single && !r.stiffened) follow_contraction(head, r.updates, uzawa);
    return status;
}

