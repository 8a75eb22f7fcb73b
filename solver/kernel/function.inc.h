/* Function rows, velocity rows and potentials: functions of quantities, rates and signals on the tape of
   operations. Included once per dimension, after composite.inc.h.                                             */

enum register_mode { OVER_STEP, AT_END };

/* Fills the registers of the leaves: values at both ends. A velocity row is a point function of mean quantities
   and mean rates. A signal is known at both ends.                                                            */
static void load_registers(const context *c, int32_t j, int mode)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const int is_velocity = j >= first_velocity_row(c) && j < first_potential(c);
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        if (entry[0] == LEAF_SIGNAL) {
            r->r0[l] = is_seeking(c) || mode == AT_END ? c->k.signal1[entry[1]] : c->s.signal[entry[1]];
            r->r1[l] = c->k.signal1[entry[1]];
            r->dr[l] = r->r1[l] - r->r0[l];
        } else if (entry[0] == LEAF_RATE) {
            r->r0[l] = r->r1[l] = leaf[l].dx / c->h;
            r->dr[l] = 0.0;
        } else if (is_velocity) {
            r->r0[l] = r->r1[l] = leaf[l].x0 + 0.5 * leaf[l].dx;
            r->dr[l] = 0.0;
        } else {
            r->r0[l] = mode == AT_END ? leaf[l].x1 : leaf[l].x0;
            r->r1[l] = leaf[l].x1;
            r->dr[l] = mode == AT_END ? 0.0 : leaf[l].dx;
        }
    }
}

/* Runs function j; returns the register of its value. */
static int32_t run_function(const context *c, int32_t j)
{
    const holonom_model *m = c->m;
    const int32_t f = j - first_function(c), begin = m->function_ptr[f];
    return hm_discrete_gradient(m->operation + 4 * begin, m->leaf_ptr[j + 1] - m->leaf_ptr[j],
                                m->function_ptr[f + 1] - begin, c->number, &c->k.r);
}

/* Derivatives of the leaves' slopes with respect to the leaves at the end, by central differences, n x n into
   `matrix`: only the rate of Newton's iteration depends on them.                                              */
static void differentiate_slopes(const context *c, int32_t j, double *matrix)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j];
    const int is_velocity = j >= first_velocity_row(c) && j < first_potential(c);
    for (int32_t k = 0; k < n; k++) {
        const int32_t *entry = m->leaf + 4 * (m->leaf_ptr[j] + k);
        for (int32_t l = 0; l < n; l++) matrix[n * l + k] = 0.0;
        if (entry[0] != LEAF_VALUE) continue;
        load_registers(c, j, OVER_STEP);
        const double delta = 1e-6 * (fabs(r->r0[k]) + fabs(r->r1[k]) + 1e-2 * (1.0 + c->number[m->extent_at]));
        for (int side = 0; side < 2; side++) {
            const double shift = side ? -delta : delta;
            load_registers(c, j, OVER_STEP);
            r->r1[k] += shift;
            if (is_velocity || is_seeking(c)) r->r0[k] += shift;
            else r->dr[k] += shift;
            run_function(c, j);
            const double weight = (side ? -0.5 : 0.5) / delta * (is_velocity ? c->lever : 1.0);
            for (int32_t l = 0; l < n; l++) matrix[n * l + k] += weight * r->adjoint[l];
        }
    }
}

/* curve_fg = d slope_f/d s_g at the end, and end_g = d C/d s_g. */
static void function_tangent(const context *c, int32_t j, const double *matrix)
{
    const holonom_model *m = c->m;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j], forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
    const int is_velocity = j >= first_velocity_row(c) && j < first_potential(c);
    memset(c->k.curve, 0, sizeof(double) * (size_t)(forms * forms));
    memset(c->k.end, 0, sizeof(double) * (size_t)forms);
    for (int32_t l = 0; l < n; l++) {
        const int32_t *a = m->leaf + 4 * (m->leaf_ptr[j] + l);
        if (a[0] == LEAF_SIGNAL) continue;
        double weight = leaf[l].n_end;
        if (is_velocity && a[0] == LEAF_VALUE) weight *= c->lever * c->h;
        for (int f = 0; f < 2 && a[2 + f] >= 0; f++) c->k.end[a[2 + f]] += weight * leaf[l].e[f];
        if (is_velocity && a[0] == LEAF_VALUE) continue; /* forces act along the rates */
        for (int f = 0; f < 2 && a[2 + f] >= 0; f++)
            for (int g = 0; g < 2 && a[2 + g] >= 0; g++)
                c->k.curve[forms * a[2 + f] + a[2 + g]] += c->k.r.adjoint[l] * leaf[l].curve[2 * f + g];
        for (int32_t k = 0; k < n; k++) {
            const int32_t *b = m->leaf + 4 * (m->leaf_ptr[j] + k);
            if (b[0] != LEAF_VALUE || matrix[n * l + k] == 0.0) continue;
            for (int f = 0; f < 2 && a[2 + f] >= 0; f++)
                for (int g = 0; g < 2 && b[2 + g] >= 0; g++)
                    c->k.curve[forms * a[2 + f] + b[2 + g]] += leaf[l].p[f] * matrix[n * l + k] * leaf[k].e[g];
        }
    }
}

/* Intermediate configuration of eq 8: lever beta in (0, 1), nearest to 1/2, with grad phi(q_beta) d + (signals) equal
   to the change of phi. Where the function is quadratic every beta will do, and 1/2 is taken. Bisection finds the
   sign change next to 1/2; sets the leaves and registers at q_beta.                                            */
static int32_t slope_at(context *c, int32_t j, double beta, double *excess)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    leaf_state *leaf = (leaf_state *)c->k.leaves;
    double sum = 0.0;
    set_local_forms(c, j, beta);
    local_form *local = (local_form *)c->k.local;
    for (int32_t f = 0; f < m->composite_form_ptr[j + 1] - m->composite_form_ptr[j]; f++) {
        local[f].s0 = local[f].s1 = dot(local[f].um, local[f].wm);
        local[f].ds = 0.0;
    }
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        if (entry[0] == LEAF_SIGNAL) {
            const double b0 = c->s.signal[entry[1]], b1 = c->k.signal1[entry[1]];
            r->r0[l] = r->r1[l] = b0 + beta * (b1 - b0);
        } else {
            const int32_t status = set_leaf(c, entry, 0, leaf + l);
            if (status) return status;
            if (m->quantity_kind[entry[1]] == QUANTITY_ANGLE) { /* the angle at q_beta, from that at q_n */
                const int32_t *forms = m->quantity_form + 2 * entry[1];
                const double c0 = dot(c->k.u0 + DIM * forms[0], c->k.w0 + DIM * forms[0]);
                const double s0 = dot(c->k.u0 + DIM * forms[1], c->k.w0 + DIM * forms[1]);
                const double cb = local[entry[2]].s1, sb = local[entry[3]].s1;
                leaf[l].x1 = c->k.sigma0[entry[1]] + atan2(c0 * sb - s0 * cb, c0 * cb + s0 * sb);
            }
            r->r0[l] = r->r1[l] = leaf[l].x1;
        }
        r->dr[l] = 0.0;
    }
    run_function(c, j);
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        double change = 0.0;
        if (entry[0] == LEAF_SIGNAL) change = c->k.signal1[entry[1]] - c->s.signal[entry[1]];
        else
            for (int f = 0; f < 2 && entry[2 + f] >= 0; f++) {
                motion g;
                form_motion(c, m->composite_form[m->composite_form_ptr[j] + entry[2 + f]], &g);
                change += leaf[l].p[f] * (dot(local[entry[2 + f]].um, g.dw) + dot(local[entry[2 + f]].wm, g.du));
            }
        sum += r->adjoint[l] * change;
    }
    *excess = sum - *excess;
    return HOLONOM_OK;
}

static int32_t find_beta(context *c, int32_t j, double change, double scale)
{
    double middle = change, low = 0.5, high = 0.5, at_low, at_high;
    int32_t status = slope_at(c, j, 0.5, &middle);
    if (status || !(fabs(middle) > 1e-14 * scale)) return status;
    at_low = at_high = middle;
    for (int i = 1; i <= 16 && at_low * middle > 0.0 && at_high * middle > 0.0; i++) { /* outwards from 1/2 */
        low = 0.5 - 0.03125 * i;
        high = 0.5 + 0.03125 * i;
        at_low = at_high = change;
        if ((status = slope_at(c, j, low, &at_low)) || (status = slope_at(c, j, high, &at_high))) return status;
    }
    double inner = 0.5, outer = at_low * middle <= 0.0 ? low : high;
    if (at_low * middle > 0.0 && at_high * middle > 0.0) return slope_at(c, j, 0.5, &change); /* round-off only */
    for (int i = 0; i < 60; i++) {
        double value = change;
        const double beta = 0.5 * (inner + outer);
        if ((status = slope_at(c, j, beta, &value))) return status;
        if (value * middle > 0.0) inner = beta;
        else outer = beta;
    }
    return HOLONOM_OK;
}

/* Slopes of function j over the step with respect to its forms; with `tangent` also curve and end. */
static int32_t function_slopes(context *c, int32_t j, int tangent, composite_result *result)
{
    const holonom_model *m = c->m;
    leaf_state *leaf = (leaf_state *)c->k.leaves;
    double *matrix = c->k.leaves + 12 * (int64_t)m->n_registers;
    const int32_t n = m->leaf_ptr[j + 1] - m->leaf_ptr[j], forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j];
    const int is_velocity = j >= first_velocity_row(c) && j < first_potential(c);
    int beta = 0;
    memset(c->k.slope, 0, sizeof(double) * (size_t)forms);
    memset(result, 0, sizeof(*result));
    for (int32_t l = 0; l < n; l++) {
        const int32_t *entry = m->leaf + 4 * (m->leaf_ptr[j] + l);
        const int32_t status = entry[0] == LEAF_SIGNAL ? 0 : set_leaf(c, entry, is_seeking(c), leaf + l);
        if (status) return status;
    }
    if (tangent) {
        differentiate_slopes(c, j, matrix);
        load_registers(c, j, AT_END);
        run_function(c, j);
        for (int32_t l = 0; l < n; l++) leaf[l].n_end = c->k.r.adjoint[l];
    }
    load_registers(c, j, OVER_STEP);
    const int32_t last = run_function(c, j);
    if (tangent) function_tangent(c, j, matrix);
    result->change = is_velocity ? c->h * c->k.r.r0[last] : c->k.r.dr[last];
    result->row = is_velocity ? result->change : is_seeking(c) ? c->k.r.r0[last] : result->change;
    if (c->formulation == HOLONOM_CONSERVING_BETA && j < first_velocity_row(c) && !is_seeking(c)) {
        const int32_t status = find_beta(c, j, result->change, c->number[m->row_scale_at + row_of(c, j)]);
        if (status) return status;
        beta = 1;
        result->mechanical = result->change;
    }
    const double *slope = c->k.r.adjoint;
    for (int32_t l = 0; l < n; l++) {
        const int32_t *entry = m->leaf + 4 * (m->leaf_ptr[j] + l);
        if (entry[0] == LEAF_SIGNAL) {
            if (beta) result->mechanical -= slope[l] * (c->k.signal1[entry[1]] - c->s.signal[entry[1]]);
            continue;
        }
        if (is_velocity && entry[0] == LEAF_VALUE) continue;
        if (!beta) result->mechanical += slope[l] * leaf[l].dx;
        for (int f = 0; f < 2 && entry[2 + f] >= 0; f++) c->k.slope[entry[2 + f]] += slope[l] * leaf[l].p[f];
    }
    return HOLONOM_OK;
}

/* Slopes of composite j; a row's function value is that over phi_0. */
static int32_t composite_slopes(context *c, int32_t j, int tangent, composite_result *result)
{
    set_local_forms(c, j, c->lever);
    if (j < first_function(c)) return element_law(c, j, tangent, result);
    if (is_seeking(c) && j >= first_velocity_row(c) && j < first_potential(c)) { /* velocities do not bind positions */
        const size_t forms = (size_t)(c->m->composite_form_ptr[j + 1] - c->m->composite_form_ptr[j]);
        memset(result, 0, sizeof(*result));
        memset(c->k.slope, 0, sizeof(double) * forms);
        memset(c->k.end, 0, sizeof(double) * forms);
        memset(c->k.curve, 0, sizeof(double) * forms * forms);
        return HOLONOM_OK;
    }
    return function_slopes(c, j, tangent, result);
}

/* Value of function j at the beginning of the step; of a potential, also at the state. */
static double function_value(const context *c, int32_t j)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        r->r0[l] = entry[0] == LEAF_SIGNAL ? c->s.signal[entry[1]] : c->k.sigma0[entry[1]];
        r->r1[l] = r->r0[l];
        r->dr[l] = 0.0;
    }
    return r->r0[run_function(c, j)];
}

/* sigma0 becomes the quantities at the state. */
static void quantities_at_state(const context *c)
{
    for (int32_t j = 0; j < c->m->n_active; j++) c->k.sigma0[j] = quantity_at(c, j, c->s.q, c->s.q_low, NULL, NULL);
}
