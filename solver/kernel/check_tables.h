/* Written by build_kernel/model_tables.py. */
#ifndef HOLONOM_CHECK_TABLES_H
#define HOLONOM_CHECK_TABLES_H

#include "model_file.h"

typedef struct hm_counts {
    int64_t n_moving;
    int64_t n_nodes;
    int64_t n;
    int64_t n_joint_rows;
    int64_t n_pivots;
    int64_t n_reduced_pivots;
    int64_t n_functions;
    int64_t n_composites;
    int64_t first_velocity;
    int64_t first_potential;
    int64_t n_tape;
    int64_t n_island_ends;
    int64_t n_derived;
    int64_t turning;
    int64_t n_first_directors;
    int64_t n_oriented;
    int64_t n_turns;
    int64_t n_owned;
    int64_t n_owners;
} hm_counts;

static hm_counts counts_of(const holonom_model *m)
{
    const int64_t n_moving = (int64_t)m->n_free + (int64_t)m->n_driven;
    const int64_t n_nodes = n_moving + (int64_t)m->n_support;
    const int64_t n = (int64_t)m->dim * n_moving;
    const int64_t n_joint_rows = (int64_t)m->n_form_rows - (int64_t)m->n_rigidity_rows;
    const int64_t n_pivots = (int64_t)m->dim * (int64_t)m->n_free + (int64_t)m->n_rows;
    const int64_t n_reduced_pivots = n_pivots - 2 * (int64_t)m->n_rigidity_rows;
    const int64_t n_functions = (int64_t)m->n_function_rows + (int64_t)m->n_velocity_rows + (int64_t)m->n_potentials;
    const int64_t n_composites = (int64_t)m->n_elements + n_functions;
    const int64_t first_velocity = (int64_t)m->n_elements + (int64_t)m->n_function_rows;
    const int64_t first_potential = first_velocity + (int64_t)m->n_velocity_rows;
    const int64_t n_tape = (int64_t)m->n_tape_parameters + (int64_t)m->n_tape_laws + (int64_t)m->n_tape_signals + (int64_t)m->n_tape_outputs;
    const int64_t n_island_ends = (int64_t)m->n_islands + 1;
    const int64_t n_derived = 2 + 2 * (int64_t)m->n_rows;
    const int64_t turning = 2 * (int64_t)m->dim - 3;
    const int64_t n_first_directors = (int64_t)m->n_free - turning + 1;
    const int64_t n_oriented = ((int64_t)m->dim - 2) * (int64_t)m->n_bodies;
    const int64_t n_turns = turning * (int64_t)m->n_bodies;
    const int64_t n_owned = (int64_t)m->unilateral * ((int64_t)m->n_function_rows + (int64_t)m->n_velocity_rows);
    const int64_t n_owners = (int64_t)m->n_contacts + (int64_t)m->n_frictions;
    return (hm_counts){n_moving, n_nodes, n, n_joint_rows, n_pivots, n_reduced_pivots, n_functions, n_composites, first_velocity, first_potential, n_tape, n_island_ends, n_derived, turning, n_first_directors, n_oriented, n_turns, n_owned, n_owners};
}

static int has_factors(const holonom_model *m, const hm_counts *k, const holonom_elimination *e, const int32_t *length, int64_t n_pivots, int64_t n_values)
{
    return hm_has(e->node_position, length[0], (int64_t)m->n_free, -1, n_pivots) &&
           hm_has(e->row_position, length[1], (int64_t)m->n_rows, -1, n_pivots) &&
           hm_rises(e->lu_ptr, length[2], n_pivots, n_values, INT32_MAX) &&
           hm_has(e->lu_target, length[5], length[5], 0, n_values) &&
           length[6] == 4 * k->n_island_ends /* lu_island */ &&
           hm_has(e->mass_slot, length[7], (int64_t)m->dim * (int64_t)m->n_mass_free, -1, n_values) &&
           hm_has(e->inertia_slot, length[8], length[8], 0, n_values) &&
           hm_rises(e->row_slot_ptr, length[9], (int64_t)m->n_form_rows, length[10] / 1, INT32_MAX) &&
           hm_has(e->row_slot, length[10], length[10], 0, n_values) &&
           hm_rises(e->coincidence_slot_ptr, length[11], (int64_t)m->n_coincidences, length[12] / 1, INT32_MAX) &&
           hm_has(e->coincidence_slot, length[12], length[12], 0, n_values) &&
           hm_rises(e->composite_slot_ptr, length[13], k->n_composites, length[14] / 1, INT32_MAX) &&
           hm_has(e->composite_slot, length[14], length[14], 0, n_values) &&
           hm_rises(e->cone_slot_ptr, length[15], (int64_t)m->n_frictions, length[16] / 1, INT32_MAX) &&
           hm_has(e->cone_slot, length[16], length[16], 0, n_values) &&
           hm_rises(e->load_slot_ptr, length[17], (int64_t)m->n_loads, length[18] / 1, INT32_MAX) &&
           hm_has(e->load_slot, length[18], length[18], 0, n_values) &&
           hm_rises(e->moment_slot_ptr, length[19], (int64_t)m->n_moments, length[20] / 1, INT32_MAX) &&
           hm_has(e->moment_slot, length[20], length[20], 0, n_values) &&
           hm_has(e->body_moment_slot, length[21], length[21], 0, n_values);
}

static int has_tables(const holonom_model *m, const hm_counts *k, const int32_t *length)
{
    return length[0] == 19 * k->n_island_ends /* island_begin */ &&
           hm_has(m->node_kind, length[1], k->n_nodes, 0, 4) &&
           hm_rises(m->form_ptr, length[2], (int64_t)m->n_forms, (int64_t)m->n_entries, INT32_MAX) &&
           hm_has(m->form_free, length[3], (int64_t)m->n_forms, 0, INT64_MAX) &&
           hm_has(m->form_moving, length[4], (int64_t)m->n_forms, 0, INT64_MAX) &&
           length[5] == (int64_t)m->n_entries /* form_node */ &&
           hm_has(m->form_kind, length[6], (int64_t)m->n_forms, 0, 32) &&
           hm_has(m->quantity_kind, length[7], (int64_t)m->n_quantities, 0, 3) &&
           hm_has(m->quantity_form, length[8], 2 * (int64_t)m->n_quantities, -1, (int64_t)m->n_forms) &&
           hm_has(m->linked_form, length[9], (int64_t)m->n_linked, 0, (int64_t)m->n_forms) &&
           hm_has(m->row_form, length[10], (int64_t)m->n_form_rows, 0, (int64_t)m->n_forms) &&
           hm_has(m->row_power, length[11], (int64_t)m->n_rows, 0, 9) &&
           hm_has(m->coincidence_form, length[12], (int64_t)m->n_coincidences, 0, (int64_t)m->n_forms) &&
           hm_rises(m->composite_form_ptr, length[13], k->n_composites, length[14] / 1, (int64_t)m->n_local_forms) &&
           hm_has(m->composite_form, length[14], length[14], 0, (int64_t)m->n_forms) &&
           hm_rises(m->composite_node_ptr, length[15], k->n_composites, length[16] / 1, (int64_t)m->n_local_nodes) &&
           hm_has(m->composite_node, length[16], length[16], 0, (int64_t)m->n_free) &&
           hm_rises(m->composite_local_ptr, length[17], k->n_composites, length[18] / 1, INT32_MAX) &&
           hm_rises(m->leaf_ptr, length[19], k->n_composites, length[20] / 4, (int64_t)m->n_registers) &&
           length[20] % 4 == 0 /* leaf */ &&
           hm_rises(m->function_ptr, length[21], k->n_functions, length[25] / 4, (int64_t)m->n_registers) &&
           hm_has(m->function_still, length[22], k->n_functions, 0, (int64_t)m->n_registers) &&
           hm_has(m->function_known, length[23], k->n_functions, 0, (int64_t)m->n_registers) &&
           hm_has(m->depth_register, length[24], (int64_t)m->n_potentials, -1, (int64_t)m->n_registers) &&
           length[25] % 4 == 0 /* operation */ &&
           hm_has(m->load_form, length[26], (int64_t)m->n_loads, 0, (int64_t)m->n_forms) &&
           hm_has(m->load_axes, length[27], (int64_t)m->n_loads, -1, INT64_MAX) &&
           hm_has(m->moment_form, length[28], (int64_t)m->n_moments, 0, (int64_t)m->n_forms) &&
           length[29] == 2 * (int64_t)m->n_body_moments /* body_moment */ &&
           hm_has(m->body_node, length[30], (int64_t)m->n_bodies, 0, k->n_first_directors) &&
           hm_has(m->place_form, length[31], (int64_t)m->n_places, 0, (int64_t)m->n_forms) &&
           length[32] == 4 * (int64_t)m->n_reaction_entries /* reaction_entry */ &&
           hm_has(m->mass_node, length[33], 2 * (int64_t)m->n_mass, 0, k->n_moving) &&
           hm_has(m->input_course, length[34], (int64_t)m->n_inputs, 0, 3) &&
           length[35] == 2 * (int64_t)m->n_sampled /* sampled_load */ &&
           hm_has(m->contact_row, length[36], (int64_t)m->n_contacts, 0, INT64_MAX) &&
           hm_has(m->contact_friction, length[37], (int64_t)m->n_contacts, -1, (int64_t)m->n_frictions) &&
           hm_rises(m->friction_row_ptr, length[38], (int64_t)m->n_frictions, length[39] / 1, 3) &&
           hm_has(m->friction_row, length[39], length[39], 0, INT64_MAX) &&
           hm_rises(m->normal_ptr, length[40], (int64_t)m->n_frictions, length[41] / 2, INT32_MAX) &&
           length[41] % 2 == 0 /* normal_row */ &&
           hm_has(m->row_owner, length[42], k->n_owned, -1, k->n_owners) &&
           length[43] == 5 * k->n_tape /* tape */ &&
           length[44] == 5 * (int64_t)m->n_switches /* switch_table */;
}

static int has_sections(const holonom_model *m, const hm_counts *k)
{
    return hm_holds(m, m->mass_at, (int64_t)m->n_mass) &&
           hm_holds(m, m->alpha_at, (int64_t)m->n_entries) &&
           hm_holds(m, m->beta_at, (int64_t)m->n_entries) &&
           hm_holds(m, m->row_constant_at, (int64_t)m->n_form_rows) &&
           hm_holds(m, m->row_base_at, (int64_t)m->n_rows) &&
           hm_holds(m, m->extent_at, k->n_derived) &&
           hm_holds(m, m->row_scale_at, (int64_t)m->n_rows) &&
           hm_holds(m, m->row_sigma_at, (int64_t)m->n_rows) &&
           hm_holds(m, m->stiffness_at, (int64_t)m->n_elements) &&
           hm_holds(m, m->rest_at, (int64_t)m->n_elements) &&
           hm_holds(m, m->damping_at, (int64_t)m->n_elements) &&
           hm_holds(m, m->drive_at, (int64_t)m->n_elements) &&
           hm_holds(m, m->depth_damping_at, (int64_t)m->n_potentials) &&
           hm_holds(m, m->restitution_at, (int64_t)m->n_contacts) &&
           hm_holds(m, m->sliding_at, (int64_t)m->n_frictions) &&
           hm_holds(m, m->static_at, (int64_t)m->n_frictions) &&
           hm_holds(m, m->preload_at, (int64_t)m->n_frictions) &&
           hm_holds(m, m->smooth_speed_at, (int64_t)m->n_frictions) &&
           hm_holds(m, m->gravity_at, (int64_t)m->dim) &&
           hm_holds(m, m->support_at, (int64_t)m->dim * (int64_t)m->n_support) &&
           hm_holds(m, m->initial_position_at, k->n) &&
           hm_holds(m, m->initial_velocity_at, k->n) &&
           hm_holds(m, m->load_at, (int64_t)m->dim * (int64_t)m->n_loads) &&
           hm_holds(m, m->moment_at, k->turning * (int64_t)m->n_moments) &&
           hm_holds(m, m->body_moment_at, 3 * (int64_t)m->n_body_moments) &&
           hm_holds(m, m->parameter_at, (int64_t)m->n_parameters) &&
           hm_holds(m, m->input_at, (int64_t)m->n_inputs) &&
           hm_holds(m, m->time_at, 1) &&
           hm_holds(m, m->signal_at, (int64_t)m->n_signals) &&
           hm_holds(m, m->sensor_at, (int64_t)m->n_quantities) &&
           hm_holds(m, m->sensor_rate_at, (int64_t)m->n_quantities) &&
           hm_holds(m, m->node_mass_at, k->n_moving) &&
           hm_holds(m, m->node_weight_at, k->n_moving) &&
           hm_holds(m, m->velocity_weight_at, k->n_moving) &&
           hm_holds(m, m->measured_at, holonom_measured_size(m));
}

static int has_islands(const holonom_model *m, const hm_counts *k)
{
    const int64_t bound[ISLAND_COLUMNS][2] = {
        {0, (int64_t)m->n_free}, /* free */
        {(int64_t)m->n_free, k->n_moving}, /* driven */
        {0, (int64_t)m->n_elements}, /* element */
        {(int64_t)m->n_elements, k->first_velocity}, /* function */
        {k->first_velocity, k->first_potential}, /* velocity */
        {k->first_potential, k->n_composites}, /* potential */
        {0, k->n_joint_rows}, /* form_row */
        {k->n_joint_rows, (int64_t)m->n_form_rows}, /* rigidity */
        {0, (int64_t)m->n_coincidences}, /* coincidence */
        {0, (int64_t)m->n_loads}, /* load */
        {0, (int64_t)m->n_moments}, /* moment */
        {0, (int64_t)m->n_body_moments}, /* body_moment */
        {0, (int64_t)m->n_mass}, /* mass */
        {0, (int64_t)m->n_bodies}, /* body */
        {0, (int64_t)m->n_always_linked}, /* linked */
        {(int64_t)m->n_always_linked, (int64_t)m->n_bilateral_linked}, /* rigidity_linked */
        {(int64_t)m->n_bilateral_linked, (int64_t)m->n_linked}, /* touching_linked */
        {0, (int64_t)m->n_always_active}, /* active */
        {(int64_t)m->n_always_active, (int64_t)m->n_active}, /* touching_active */
    };
    return hm_divides(m, bound);
}

#endif
