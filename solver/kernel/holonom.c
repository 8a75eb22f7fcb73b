/* What the caller asks before a step: version, dimension, layout of the memory that it lends. */
#include "holonom.h"
#include "internal.h"

#include <stddef.h>

static double *take(double *block, int64_t *used, int64_t count)
{
    double *start = block ? block + *used : NULL;
    *used += count;
    return start;
}

int64_t hm_map_state(const holonom_model *m, double *block, hm_state *s)
{
    const int64_t n = (int64_t)m->dim * (m->n_free + m->n_driven), driven = (int64_t)m->dim * m->n_driven;
    int64_t used = 0;
    s->head = take(block, &used, S_HEAD);
    s->q = take(block, &used, n);
    s->q_low = take(block, &used, n);
    s->v = take(block, &used, n);
    s->v_low = take(block, &used, n);
    s->imbalance = take(block, &used, n);
    s->imbalance_before = take(block, &used, n);
    s->start = take(block, &used, n);
    s->a[0] = take(block, &used, n);
    s->a[1] = take(block, &used, n);
    s->mu[0] = take(block, &used, m->n_rows);
    s->mu[1] = take(block, &used, m->n_rows);
    s->a_change = take(block, &used, n * m->n_slots);
    s->mu_change = take(block, &used, (int64_t)m->n_rows * m->n_slots);
    s->mean = take(block, &used, m->n_rows);
    s->mean_before = take(block, &used, m->n_rows);
    s->driven[0] = take(block, &used, driven);
    s->driven[1] = take(block, &used, driven);
    s->driven_mean = take(block, &used, driven);
    s->driven_mean_before = take(block, &used, driven);
    s->turns = take(block, &used, m->n_quantities);
    s->direction = take(block, &used, 2 * (int64_t)m->n_quantities);
    s->signal = take(block, &used, m->n_signals);
    s->quaternion = take(block, &used, 4 * (int64_t)m->n_bodies);
    s->sampled = take(block, &used, 3 * (int64_t)m->n_sampled);
    s->derived = take(block, &used, 2 + 2 * (int64_t)m->n_rows);
    s->inputs = take(block, &used, m->n_inputs);
    s->inputs_before = take(block, &used, m->n_inputs);
    s->inputs_slope = take(block, &used, m->n_inputs);
    s->islands = take(block, &used, (int64_t)I_SIZE * m->n_islands);
    s->parameters = take(block, &used, m->n_parameters);
    return used;
}

/* Scratch of one composite at a time. */
static void map_composite(const holonom_model *m, double *block, int64_t *used, hm_work *k)
{
    const int64_t forms = m->n_local_forms, size = (int64_t)m->dim * m->n_local_nodes, registers = m->n_registers;
    k->local = take(block, used, forms * (4 * m->dim + 3));
    k->slope = take(block, used, forms);
    k->end = take(block, used, forms);
    k->curve = take(block, used, forms * forms);
    k->gradient = take(block, used, forms * size);
    k->gradient_end = take(block, used, forms * size);
    k->block = take(block, used, size * size);
    k->leaves = take(block, used, registers * (12 + registers));
    k->r.r0 = take(block, used, registers);
    k->r.r1 = take(block, used, registers);
    k->r.dr = take(block, used, registers);
    k->r.adjoint = take(block, used, registers);
    k->r.slope = take(block, used, 2 * registers);
}

int64_t hm_map_work(const holonom_model *m, double *block, hm_work *k)
{
    const int64_t n = (int64_t)m->dim * (m->n_free + m->n_driven), links = (int64_t)m->dim * m->n_forms;
    hm_state ignored;
    const int64_t state_size = hm_map_state(m, NULL, &ignored);
    int64_t used = 0;
    k->u0 = take(block, &used, links);
    k->w0 = take(block, &used, links);
    k->sigma0 = take(block, &used, m->n_active);
    k->signal1 = take(block, &used, m->n_signals);
    k->signal_rate = take(block, &used, m->n_signals);
    k->signal_before = take(block, &used, m->n_signals);
    k->signal_sample = take(block, &used, 2 * (int64_t)m->n_signals);
    k->phi0 = take(block, &used, m->n_rows);
    k->phi = take(block, &used, m->n_rows);
    k->lambda = take(block, &used, m->n_rows);
    k->mu = take(block, &used, m->n_rows);
    k->epsilon = take(block, &used, m->n_rows);
    k->hv = take(block, &used, n);
    k->w = take(block, &used, n);
    k->d = take(block, &used, n);
    k->momentum = take(block, &used, n);
    k->handed_on = take(block, &used, n);
    k->sensed = take(block, &used, n);
    k->ahead = take(block, &used, n);
    k->ahead_rate = take(block, &used, n);
    k->free = take(block, &used, n);
    k->row_rate = take(block, &used, m->n_rows);
    k->row_bias = take(block, &used, m->n_rows);
    k->product = take(block, &used, (int64_t)m->dim * m->n_free + m->n_rows);
    k->rhs = take(block, &used, (int64_t)m->dim * m->n_free + m->n_rows);
    k->value = take(block, &used, m->n_lu_values);
    map_composite(m, block, &used, k);
    k->estimate = take(block, &used, 4 * n);
    k->step_backup = take(block, &used, state_size);
    k->pair_backup = take(block, &used, state_size);
    k->finest = take(block, &used, state_size);
    k->whole_backup = take(block, &used, 2 * state_size);
    return used;
}

int32_t holonom_abi(void) { return HOLONOM_ABI; }

int32_t holonom_dimension(void) { return DIM; }

int64_t holonom_model_bytes(void) { return (int64_t)sizeof(holonom_model); }

int64_t holonom_state_size(const holonom_model *m)
{
    hm_state ignored;
    return hm_map_state(m, NULL, &ignored);
}

int64_t holonom_work_size(const holonom_model *m)
{
    hm_work ignored;
    return hm_map_work(m, NULL, &ignored);
}

int64_t holonom_measured_size(const holonom_model *m)
{
    const int64_t turning = m->dim == 2 ? 1 : 3;
    const int64_t motion = 2 * (int64_t)m->dim * (m->n_free + m->n_driven + m->n_places) + 2 * (int64_t)m->n_quantities;
    const int64_t forces = (int64_t)m->n_elements + m->n_form_rows + m->n_rows;
    const int64_t reactions = (m->dim + turning) * m->n_reactions + (int64_t)m->dim * m->n_driven;
    return motion + forces + 7 * (int64_t)m->n_bodies + reactions + 9 + m->dim + turning + 6;
}

double holonom_operate(int32_t code, double a, double b, double c) { return hm_operate(code, a, b, c); }

void holonom_evaluate(const holonom_model *m, double *numbers, int32_t segment) { hm_run_tape(m, numbers, segment); }
