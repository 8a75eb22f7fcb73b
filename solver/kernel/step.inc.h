/* One conserving step, pairs of half steps, and a communication step. Included once per dimension.            */

/* Mass norms: |w|, |d|, with the node's share of the mass. */
static double mass_norm2(const context *c, const double *x)
{
    double sum = 0.0;
    for (int32_t a = 0; a < c->m->n_free; a++)
        sum += c->number[c->m->node_mass_at + a] * dot(x + DIM * a, x + DIM * a);
    return sum;
}

/* Links, rows, compliances, warm start and predictor at the beginning of a step of length c->h. */
static void prepare_step(context *c, int parity)
{
    const holonom_model *m = c->m;
    const double h = c->h;
    const int32_t n = DIM * m->n_free;
    for (int32_t f = 0; f < m->n_forms; f++) link_at_state(c, f, c->k.u0 + DIM * f, c->k.w0 + DIM * f);
    /* w is h^2/2 times an acceleration: predict that of the same half of the last pair, since v and mu have a
       component that changes sign from half to half. */
    for (int32_t k = 0; k < n; k++) {
        c->k.hv[k] = h * c->s.v[k] + h * c->s.v_low[k];
        c->k.w[k] = 0.5 * h * h * c->s.a[parity][k];
        c->k.d[k] = c->k.hv[k] + c->k.w[k];
    }
    for (int32_t i = 0; i < m->n_rows; i++) {
        const int32_t f = m->row_form[i];
        c->k.phi0[i] = dot(c->k.u0 + DIM * f, c->k.w0 + DIM * f) - c->number[m->row_constant_at + i];
        c->k.epsilon[i] = row_compliance(c, i);
        c->k.mu[i] = c->s.mu[parity][i];
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
        if (!(scaled <= largest)) largest = scaled;
    }
    return largest;
}

/* Solves for one Newton increment and adds it; *eta is its size in the mass norm. */
static int32_t newton_update(context *c, double *eta)
{
    const holonom_model *m = c->m;
    double *rhs = c->k.rhs, sum = 0.0;
    gather_rhs(c);
    hm_lu_solve(DIM * m->n_free + m->n_rows, m->lu_ptr, m->lu_column, c->k.value, rhs);
    for (int32_t a = 0; a < m->n_free; a++) {
        const double *x = rhs + m->node_position[a];
        sum += c->number[m->node_mass_at + a] * dot(x, x);
        EACH(k) c->k.w[DIM * a + k] += x[k];
        EACH(k) c->k.d[DIM * a + k] = c->k.hv[DIM * a + k] + c->k.w[DIM * a + k];
    }
    for (int32_t i = 0; i < m->n_rows; i++) c->k.mu[i] += rhs[m->row_position[i]];
    *eta = sqrt(sum);
    return *eta < 1e150 ? HOLONOM_OK : HOLONOM_NOT_FINITE;
}

/* A step's error must lie far below the tolerance: what is left in momentum or constraints has one sign over
   many steps and adds up in the energy (measured: double pendulum, h = 1e-3, 2e5 steps, |dE| 4.8e-11 J with
   margins of 1e-4 and 1e-3, 4e-14 J with these). The factors are kept, so that the last digits cost little.   */
#define NEWTON_MARGIN 1e-6
#define CONSTRAINT_MARGIN 1e-5

/* Energies that unfinished iterations would add: v'R by the momentum balance, Phi'mu by the constraints. Small
   increments alone do not tell that a step is solved: they also become small where mu grows beyond all bounds. */
static double residual_energy(const context *c)
{
    double sum = 0.0;
    for (int32_t k = 0; k < DIM * c->m->n_free; k++) sum += c->k.d[k] * c->k.momentum[k];
    return fabs(sum) / c->h;
}

static double constraint_energy(const context *c)
{
    double sum = 0.0;
    for (int32_t i = 0; i < c->m->n_rows; i++) sum += c->k.phi[i] * c->k.mu[i];
    return fabs(sum);
}

/* Newton iteration with lambda held fixed (nested) or following mu (simultaneous). The error left behind is
   estimated from the observed contraction theta. It ends a margin below the tolerance, or where round-off stops
   the contraction below the tolerance. The factors are kept while they contract well.                        */
typedef struct newton_record {
    double theta, eta, target, floor; /* contraction, last increment, tolerance, round-off of positions        */
    double energy;                    /* reference energy [J]                                                 */
    int factorised, total;
} newton_record;

/* A momentum residual that adds 1e4 tolerances of energy is no round-off: mu has left all bounds. */
static int is_sound(const context *c, const newton_record *r)
{
    return residual_energy(c) <= 1e4 * c->s.head[S_TOLERANCE] * r->energy;
}

static int32_t iterate_newton(context *c, newton_record *r)
{
    const int simultaneous = c->s.head[S_SIMULTANEOUS] != 0.0;
    const int max_newton = (int)c->s.head[S_MAX_NEWTON];
    const double tolerance = c->s.head[S_TOLERANCE];
    double previous = 0.0, defect = 0.0;
    for (int iteration = 0; iteration < max_newton; iteration++) {
        int32_t status = HOLONOM_OK;
        const int keep = r->factorised && r->theta < 0.05;
        if (!keep) {
            status = factorise(c);
            if (status) return status;
            r->factorised = 1;
        }
        status = newton_update(c, &r->eta);
        if (status) return status;
        r->total++;
        /* First increment with new factors: nothing is known but its size against the step's. */
        if (iteration > 0 && previous > 0.0) r->theta = r->eta / previous;
        else if (!keep) r->theta = r->eta < 0.02 * sqrt(mass_norm2(c, c->k.d)) ? 0.04 : 1.0;
        previous = r->eta;
        if (simultaneous) update_multipliers(c);
        status = evaluate_residual(c);
        if (status) return status;
        const double left = iteration > 0 || keep ? r->theta * r->eta : r->eta;
        const int stalled = iteration > 1 && r->theta > 0.5 && r->eta <= fmax(r->target, r->floor);
        if (simultaneous && !is_penalty(c)) defect = constraint_defect(c);
        const int solved = left <= NEWTON_MARGIN * r->target && defect <= CONSTRAINT_MARGIN * tolerance;
        if ((solved || (stalled && defect <= tolerance)) && is_sound(c, r)) return HOLONOM_OK;
    }
    if (!(r->eta <= r->target && is_sound(c, r))) return HOLONOM_NEWTON_DIVERGED;
    return defect <= tolerance ? HOLONOM_OK : HOLONOM_UZAWA_DIVERGED;
}

/* One step: outer Uzawa iteration around the inner Newton iteration (paper, section 2.2 and eq 15, 16). */
static int32_t solve_step(context *c, int parity)
{
    double *head = c->s.head, last = INFINITY;
    const double tolerance = head[S_TOLERANCE];
    const int max_uzawa = (int)head[S_MAX_UZAWA], single = is_penalty(c) || head[S_SIMULTANEOUS] != 0.0;
    newton_record r = {1.0, 0.0, 0.0, 0.0, 0.0, 0, 0};
    prepare_step(c, parity);
    update_multipliers(c);
    int32_t status = evaluate_residual(c);
    const double speed2 = mass_norm2(c, c->k.d) + 2.0 * c->h * c->h * head[S_ENERGY_REFERENCE];
    r.target = tolerance * sqrt(speed2);
    r.energy = 0.5 * speed2 / (c->h * c->h);
    r.floor = 32.0 * 2.3e-16 * c->number[c->m->extent_at + 1];
    for (int uzawa = 0; !status; uzawa++) {
        status = iterate_newton(c, &r);
        head[S_NEWTON] += r.total;
        r.total = 0;
        if (status || single) break;
        const double defect = constraint_defect(c);
        if (!(defect < INFINITY)) return HOLONOM_NOT_FINITE;
        if (defect <= CONSTRAINT_MARGIN * tolerance) break;
        /* Near a singular configuration one combination of rows contracts slowly: it may go on until its energy
           is round-off, or the updates are used up. Contraction that has ended is round-off of Phi itself. */
        const double energy = constraint_energy(c) / r.energy;
        const int slow = defect > 0.5 * last && energy <= CONSTRAINT_MARGIN * tolerance;
        if (defect <= tolerance && (slow || defect > 0.9 * last)) break;
        if (uzawa >= max_uzawa) {
            if (defect <= tolerance && energy <= tolerance) break;
            return HOLONOM_UZAWA_DIVERGED;
        }
        last = defect;
        head[S_UZAWA] += 1.0;
        update_multipliers(c);
        for (int32_t i = 0; i < c->m->n_rows; i++)
            c->k.constraint[i] = c->k.phi[i] - c->k.epsilon[i] * (c->k.mu[i] - c->k.lambda[i]);
    }
    return status;
}

/* Books the step in the ledger: Delta T = -dPhi'mu - Delta U + work - dissipation + v'R, term by term. */
static void book_step(context *c)
{
    const holonom_model *m = c->m;
    double *head = c->s.head;
    motion g;
    for (int32_t i = 0; i < m->n_rows; i++) {
        form_motion(c, m->row_form[i], &g);
        hm_add(head + S_DEFECT, head + S_DEFECT_LOW, c->k.mu[i] * (dot(g.um, g.dw) + dot(g.wm, g.du)));
    }
    for (int32_t k = 0; k < DIM * m->n_free; k++)
        hm_add(head + S_RESIDUAL, head + S_RESIDUAL_LOW, c->k.d[k] * c->k.momentum[k] / c->h);
    for (int32_t j = 0; j < m->n_loads; j++)
        hm_add(head + S_WORK, head + S_WORK_LOW,
               dot(c->number + m->load_at + DIM * j, c->k.d + DIM * m->load_node[j]));
    for (int32_t j = 0; j < m->n_moments; j++) {
        double f[DIM];
        form_motion(c, m->moment_form[j], &g);
        moment_law(c, j, &g, f, NULL);
        hm_add(head + S_WORK, head + S_WORK_LOW, dot(f, g.du));
    }
    for (int32_t j = 0; j < m->n_lines; j++) {
        if (c->number[m->damping_at + j] == 0.0) continue;
        line_state law;
        form_motion(c, m->line_form[j], &g);
        line_law(c, j, &g, &law);
        hm_add(head + S_DISSIPATED, head + S_DISSIPATED_LOW,
               c->number[m->damping_at + j] * law.rate * law.rate / c->h);
    }
}

/* Counts full turns of planar links: a link that crosses the negative first axis leaves (-pi, pi]. */
static void follow_angles(context *c)
{
#if DIM == 2
    for (int32_t j = 0; j < c->m->n_angles; j++) {
        const double *u0 = c->k.u0 + DIM * c->m->angle_form[j];
        double u1[DIM], w1[DIM];
        link_at_state(c, c->m->angle_form[j], u1, w1);
        const double sense = u0[0] * u1[1] - u0[1] * u1[0];
        if (u0[1] >= 0.0 && u1[1] < 0.0 && sense > 0.0) c->s.turns[j] += 1.0;
        if (u0[1] < 0.0 && u1[1] >= 0.0 && sense < 0.0) c->s.turns[j] -= 1.0;
    }
#else
    (void)c;
#endif
}

/* Takes the solved step over into the state. */
static void accept_step(context *c, int parity)
{
    const int32_t n = DIM * c->m->n_free;
    book_step(c);
    for (int32_t k = 0; k < n; k++) {
        hm_add(c->s.q + k, c->s.q_low + k, c->k.d[k]);
        hm_add(c->s.v + k, c->s.v_low + k, 2.0 / c->h * c->k.w[k]);
        c->s.a[parity][k] = 2.0 / (c->h * c->h) * c->k.w[k];
    }
    memcpy(c->s.mu[parity], c->k.mu, sizeof(double) * (size_t)c->m->n_rows);
    follow_angles(c);
    c->s.head[S_PARITY] = 1 - parity;
    c->s.head[S_SUBSTEPS] += 1.0;
    c->t += c->h;
}
