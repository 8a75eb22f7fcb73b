/* Residual and tangent of one step, the regularised KKT system

       [ A      h Gm' ] [dw ]     [ (2/h) M w + h (Gm' mu - Q) ]      A = (2/h) M + h (1/2 sum mu_i H_i + K),
       [ G_1    -eps  ] [dmu] = - [ C(d) - eps (mu - lambda)   ]      w = d - h v_n.

   It is not symmetric: Gm is taken at the midpoint, G_1 is the gradient of C at the end. Unknown is w, not
   q_1 or d: M (v_1 - v_n) = (2/h) M w then has the size of the forces, not of the momenta, and keeps its digits.
   Included once per dimension, after laws.inc.h.                                                            */

static void row_stiffness(const context *c, int32_t f, double factor, const int32_t *slot, double *value)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at + m->form_ptr[f], *beta = c->number + m->beta_at + m->form_ptr[f];
    const int32_t free = m->form_free[f];
    for (int32_t p = 0; p < free; p++)
        for (int32_t q = 0; q < free; q++) {
            const double x = factor * (alpha[p] * beta[q] + beta[p] * alpha[q]);
            EACH(k) value[*slot++] += x;
        }
}

static void scatter_gradient(const context *c, int32_t f, double factor, const double *u, const double *w,
                             const int32_t *slot, double *value)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at + m->form_ptr[f], *beta = c->number + m->beta_at + m->form_ptr[f];
    for (int32_t p = 0; p < m->form_free[f]; p++)
        EACH(k) value[*slot++] += factor * (alpha[p] * w[k] + beta[p] * u[k]);
}

/* Adds factor alpha_p alpha_q B for all pairs of free entries of form f, B (DIM x DIM). */
static const int32_t *scatter_block(const context *c, int32_t f, double factor, const double *block,
                                    const int32_t *slot, double *value)
{
    const holonom_model *m = c->m;
    const double *alpha = c->number + m->alpha_at + m->form_ptr[f];
    for (int32_t p = 0; p < m->form_free[f]; p++)
        for (int32_t q = 0; q < m->form_free[f]; q++)
            EACH(i) EACH(j) value[*slot++] += factor * alpha[p] * alpha[q] * block[DIM * i + j];
    return slot;
}

static int32_t law_tangent(const context *c, double *value)
{
    const holonom_model *m = c->m;
    const int32_t *slot = m->line_slot;
    double block[DIM * DIM];
    motion g;
    for (int32_t j = 0; j < m->n_lines; j++) {
        line_state law;
        form_motion(c, m->line_form[j], &g);
        const int32_t status = line_law(c, j, &g, &law);
        if (status) return status;
        const double rank = law.slope != 0.0 ? 2.0 * law.slope / law.l1 : 0.0;
        EACH(i) EACH(k) block[DIM * i + k] = rank * g.um[i] * (g.u0[k] + g.du[k]) + (i == k ? law.kappa : 0.0);
        slot = scatter_block(c, m->line_form[j], c->h, block, slot, value);
    }
    slot = m->moment_slot;
    for (int32_t j = 0; j < m->n_moments; j++) {
        double f[DIM];
        form_motion(c, m->moment_form[j], &g);
        const int32_t status = moment_law(c, j, &g, f, block);
        if (status) return status;
        slot = scatter_block(c, m->moment_form[j], -c->h, block, slot, value);
    }
    return HOLONOM_OK;
}

/* Writes the tangent at the present (w, mu) into value. */
static int32_t assemble_tangent(context *c)
{
    const holonom_model *m = c->m;
    double *value = c->k.value;
    const double h = c->h;
    memset(value, 0, sizeof(double) * (size_t)m->n_lu_values);
    for (int32_t e = 0; e < m->n_mass; e++)
        EACH(k) value[m->mass_slot[DIM * e + k]] += 2.0 / h * c->number[m->mass_at + e];
    const int32_t *slot = m->row_slot;
    for (int32_t i = 0; i < m->n_rows; i++) {
        const int32_t f = m->row_form[i], free = m->form_free[f];
        motion g;
        double u[DIM], w[DIM];
        form_motion(c, f, &g);
        row_function(c, i, &g, u, w);
        row_stiffness(c, f, 0.5 * h * c->k.mu[i], slot, value);
        slot += DIM * free * free;
        scatter_gradient(c, f, h, g.um, g.wm, slot, value);
        slot += DIM * free;
        scatter_gradient(c, f, 1.0, u, w, slot, value);
        slot += DIM * free;
        value[m->lu_ptr[m->row_position[i]]] -= c->k.epsilon[i];
    }
    return m->n_lines || m->n_moments ? law_tangent(c, value) : HOLONOM_OK;
}

/* momentum = (2/h) M x, the inertia term of the residual. */
static void inertia(const context *c, const double *x, double *momentum)
{
    const holonom_model *m = c->m;
    memset(momentum, 0, sizeof(double) * (size_t)(DIM * m->n_free));
    for (int32_t e = 0; e < m->n_mass; e++) {
        const double mass = 2.0 / c->h * c->number[m->mass_at + e];
        const double *column = x + DIM * m->mass_node[2 * e + 1];
        EACH(k) momentum[DIM * m->mass_node[2 * e] + k] += mass * column[k];
    }
}

/* Evaluates both residuals at the present (w, d, mu): momentum, phi = C(d), constraint. */
static int32_t evaluate_residual(context *c)
{
    const holonom_model *m = c->m;
    inertia(c, c->k.w, c->k.momentum);
    for (int32_t i = 0; i < m->n_rows; i++) {
        motion g;
        double u[DIM], w[DIM];
        form_motion(c, m->row_form[i], &g);
        c->k.phi[i] = row_function(c, i, &g, u, w);
        add_gradient(c, m->row_form[i], c->h * c->k.mu[i], g.um, g.wm, c->k.momentum);
        c->k.constraint[i] = c->k.phi[i] - c->k.epsilon[i] * (c->k.mu[i] - c->k.lambda[i]);
    }
    return subtract_forces(c, c->k.momentum);
}

/* Right-hand side -(momentum, constraint) in elimination order. */
static void gather_rhs(context *c)
{
    const holonom_model *m = c->m;
    for (int32_t a = 0; a < m->n_free; a++)
        EACH(k) c->k.rhs[m->node_position[a] + k] = -c->k.momentum[DIM * a + k];
    for (int32_t i = 0; i < m->n_rows; i++) c->k.rhs[m->row_position[i]] = -c->k.constraint[i];
}

static inline int32_t factorise(context *c)
{
    const holonom_model *m = c->m;
    const int32_t status = assemble_tangent(c);
    if (status) return status;
    return hm_lu_factor(DIM * m->n_free + m->n_rows, m->lu_ptr, m->lu_target, c->k.value) ? HOLONOM_SINGULAR_TANGENT
                                                                                         : HOLONOM_OK;
}
