/* Checks a model from outside before anything follows its indices: each table is as long as its readers think, and each index
   lies within what it points into. A model that is wrong within these bounds moves wrongly, but its run ends. */
#include "small.h"

#include "internal.h"
#include "model_file.h"

/* Place of a table among the lengths. */
#define TABLE(name) ((offsetof(holonom_model, name) - offsetof(holonom_model, island_begin)) / sizeof(const int32_t *))

enum { LARGEST_SIZE = 1 << 26 }; /* so that no sum of a few overflows */

typedef struct checker {
    const holonom_model *m;
    const int32_t *length;
    int64_t n_nodes, n_moving, n_composites;
} checker;

static int is_long(const checker *c, size_t table, int64_t length) { return c->length[table] == length; }

static int within(const int32_t *value, int64_t count, int64_t low, int64_t end)
{
    for (int64_t i = 0; i < count; i++)
        if (value[i] < low || value[i] >= end) return 0;
    return 1;
}

/* Whether a table has `count` indices from `low` to below `end`. */
static int has(const checker *c, size_t table, int64_t count, int64_t low, int64_t end)
{
    return is_long(c, table, count) && within((&c->m->island_begin)[table], count, low, end);
}

/* Whether a table has count + 1 places that rise from 0 to `total`, by at most `most` each. */
static int rises(const checker *c, size_t table, int64_t count, int64_t total, int64_t most)
{
    const int32_t *at = (&c->m->island_begin)[table];
    if (!is_long(c, table, count + 1) || at[0] != 0 || at[count] != total) return 0;
    for (int64_t i = 0; i < count; i++)
        if (at[i + 1] < at[i] || at[i + 1] - (int64_t)at[i] > most) return 0;
    return 1;
}

static int has_sizes(const checker *c)
{
    const holonom_model *m = c->m;
    const int32_t *size = &m->dim;
    for (size_t i = 0; i <= (size_t)(&m->n_sampled - &m->dim); i++)
        if (size[i] < 0 || size[i] > LARGEST_SIZE) return 0;
    const int64_t rows = (int64_t)m->n_form_rows + DIM * (int64_t)m->n_coincidences + m->n_function_rows + m->n_velocity_rows;
    return rows == m->n_rows && m->n_active <= m->n_quantities && m->n_mass_free <= m->n_mass && m->n_slots <= 64 &&
           m->time_dependent <= 1 && m->variable_potential <= 1 && m->sensing <= 1 && DIM * (int64_t)m->n_driven <= m->n_signals;
}

/* Whether a section of the numbers lies within them. */
static int holds(const checker *c, int32_t at, int64_t length) { return at >= 0 && at + length <= c->m->n_numbers; }

static int has_sections(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t n = DIM * c->n_moving, turning = DIM == 2 ? 1 : 3;
    int turned = 0;
    for (int32_t f = 0; f < m->n_forms; f++) turned |= m->form_kind[f] & FORM_TURNED;
    return (!turned || (DIM == 2 && holds(c, m->alpha_turn_at, m->n_entries) && holds(c, m->beta_turn_at, m->n_entries))) &&
           holds(c, m->mass_at, m->n_mass) && holds(c, m->alpha_at, m->n_entries) && holds(c, m->beta_at, m->n_entries) &&
           holds(c, m->row_constant_at, m->n_form_rows) && holds(c, m->row_base_at, m->n_rows) &&
           holds(c, m->extent_at, 2 + 2 * (int64_t)m->n_rows) && m->row_scale_at == m->extent_at + 2 &&
           m->row_sigma_at == m->row_scale_at + m->n_rows && holds(c, m->stiffness_at, m->n_elements) &&
           holds(c, m->rest_at, m->n_elements) && holds(c, m->damping_at, m->n_elements) && holds(c, m->drive_at, m->n_elements) &&
           holds(c, m->gravity_at, DIM) && holds(c, m->support_at, DIM * (int64_t)m->n_support) &&
           holds(c, m->initial_position_at, n) && holds(c, m->initial_velocity_at, n) &&
           holds(c, m->load_at, DIM * (int64_t)m->n_loads) && holds(c, m->moment_at, turning * m->n_moments) &&
           holds(c, m->body_moment_at, 3 * (int64_t)m->n_body_moments) && holds(c, m->parameter_at, m->n_parameters) &&
           holds(c, m->input_at, m->n_inputs) && holds(c, m->time_at, 1) && holds(c, m->signal_at, m->n_signals) &&
           holds(c, m->sensor_at, m->n_quantities) && holds(c, m->sensor_rate_at, m->n_quantities) &&
           holds(c, m->node_mass_at, c->n_moving) && holds(c, m->node_weight_at, c->n_moving) &&
           holds(c, m->velocity_weight_at, c->n_moving) && holds(c, m->measured_at, holonom_measured_size(m));
}

static int has_forms(const checker *c)
{
    const holonom_model *m = c->m;
    if (!rises(c, TABLE(form_ptr), m->n_forms, m->n_entries, INT32_MAX) || !has(c, TABLE(form_free), m->n_forms, 0, INT32_MAX) ||
        !has(c, TABLE(form_moving), m->n_forms, 0, INT32_MAX) || !is_long(c, TABLE(form_node), m->n_entries) ||
        !has(c, TABLE(form_kind), m->n_forms, 0, 8) || !has(c, TABLE(node_kind), c->n_nodes, 0, 2))
        return 0;
    for (int32_t f = 0; f < m->n_forms; f++) { /* free nodes come first, then driven ones */
        const int32_t *node = m->form_node + m->form_ptr[f];
        const int32_t count = m->form_ptr[f + 1] - m->form_ptr[f], moving = m->form_moving[f], free = m->form_free[f];
        if (free > moving || moving > count || !within(node, free, 0, m->n_free) ||
            !within(node + free, moving - free, m->n_free, c->n_moving) ||
            !within(node + moving, count - moving, c->n_moving, c->n_nodes))
            return 0;
    }
    return 1;
}

static int has_quantities(const checker *c)
{
    const holonom_model *m = c->m;
    if (!has(c, TABLE(quantity_kind), m->n_quantities, 0, 3)) return 0;
    if (!has(c, TABLE(quantity_form), 2 * (int64_t)m->n_quantities, -1, m->n_forms)) return 0;
    for (int32_t j = 0; j < m->n_quantities; j++)
        if (m->quantity_form[2 * j] < 0 || (m->quantity_kind[j] == QUANTITY_ANGLE && m->quantity_form[2 * j + 1] < 0)) return 0;
    return 1;
}

/* Whether leaf `entry` of a composite with so many forms names a quantity or a signal, and forms for each slope. */
static int is_leaf(const checker *c, const int32_t *entry, int32_t forms)
{
    const holonom_model *m = c->m;
    if (entry[2] >= forms || entry[3] >= forms || entry[2] < -1 || entry[3] < -1) return 0;
    if (entry[0] == LEAF_SIGNAL) return entry[1] >= 0 && entry[1] < m->n_signals && entry[2] < 0 && entry[3] < 0;
    if (entry[0] < 0 || entry[0] > LEAF_SIGNAL || entry[1] < 0 || entry[1] >= m->n_active || entry[2] < 0) return 0;
    return (m->quantity_kind[entry[1]] == QUANTITY_ANGLE) == (entry[3] >= 0);
}

/* Whether the operations of a function read what comes before them. */
static int is_function(const checker *c, const int32_t *operation, int32_t n_leaves, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        if (!within(operation + 4 * i + 1, 3, -(int64_t)c->m->n_numbers, n_leaves + i)) return 0;
    return n_leaves + count > 0 && n_leaves + count <= c->m->n_registers;
}

static int is_composite(const checker *c, int32_t j)
{
    const holonom_model *m = c->m;
    const int32_t forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j], leaves = m->leaf_ptr[j + 1] - m->leaf_ptr[j];
    const int32_t nodes = m->composite_node_ptr[j + 1] - m->composite_node_ptr[j];
    int64_t places = 0;
    for (int32_t at = m->composite_form_ptr[j]; at < m->composite_form_ptr[j + 1]; at++) places += m->form_free[m->composite_form[at]];
    if (places != m->composite_local_ptr[j + 1] - m->composite_local_ptr[j] ||
        !within(m->composite_local + m->composite_local_ptr[j], places, 0, nodes))
        return 0;
    for (int32_t l = m->leaf_ptr[j]; l < m->leaf_ptr[j + 1]; l++)
        if (!is_leaf(c, m->leaf + 4 * l, forms)) return 0;
    if (j < m->n_elements) return leaves == 1 && m->leaf[4 * m->leaf_ptr[j]] == LEAF_VALUE;
    const int32_t begin = m->function_ptr[j - m->n_elements], end = m->function_ptr[j - m->n_elements + 1];
    return is_function(c, m->operation + 4 * (int64_t)begin, leaves, end - begin);
}

static int has_composites(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t n = c->n_composites, n_forms = c->length[TABLE(composite_form)], n_nodes = c->length[TABLE(composite_node)];
    const int64_t n_leaves = c->length[TABLE(leaf)] / 4, n_operations = c->length[TABLE(operation)] / 4;
    if (!rises(c, TABLE(composite_form_ptr), n, n_forms, m->n_local_forms) ||
        !has(c, TABLE(composite_form), n_forms, 0, m->n_forms) ||
        !rises(c, TABLE(composite_node_ptr), n, n_nodes, m->n_local_nodes) ||
        !has(c, TABLE(composite_node), n_nodes, 0, m->n_free) ||
        !rises(c, TABLE(composite_local_ptr), n, c->length[TABLE(composite_local)], INT32_MAX) ||
        !rises(c, TABLE(leaf_ptr), n, n_leaves, m->n_registers) || !is_long(c, TABLE(leaf), 4 * n_leaves) ||
        !rises(c, TABLE(function_ptr), n - m->n_elements, n_operations, m->n_registers) ||
        !is_long(c, TABLE(operation), 4 * n_operations) || m->n_registers > n_leaves + n_operations + 1 ||
        m->n_local_forms > n_forms + 1 || m->n_local_nodes > n_nodes + 1)
        return 0;
    for (int32_t j = 0; j < n; j++)
        if (!is_composite(c, j)) return 0;
    return 1;
}

static int has_loads(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t directors = DIM == 2 ? 1 : 3, axes_end = c->n_moving < directors ? 0 : c->n_moving - directors + 1;
    const int32_t end[] = {m->n_loads, m->n_moments, m->n_body_moments, m->n_elements};
    if (!has(c, TABLE(load_form), m->n_loads, 0, m->n_forms) ||
        !has(c, TABLE(load_axes), m->n_loads, -1, axes_end) ||
        !has(c, TABLE(moment_form), m->n_moments, 0, m->n_forms) || !is_long(c, TABLE(body_moment), 2 * (int64_t)m->n_body_moments) ||
        !has(c, TABLE(body_node), m->n_bodies, 0, c->n_moving - 2) || !has(c, TABLE(place_form), m->n_places, 0, m->n_forms) ||
        !is_long(c, TABLE(reaction_entry), 4 * (int64_t)m->n_reaction_entries) || !has(c, TABLE(input_ramp), m->n_inputs, 0, 2) ||
        !is_long(c, TABLE(sampled_load), 2 * (int64_t)m->n_sampled))
        return 0;
    for (int32_t j = 0; j < m->n_body_moments; j++)
        if (m->body_moment[2 * j] < 0 || m->body_moment[2 * j] > m->n_free - 3) return 0;
    for (int32_t e = 0; e < m->n_reaction_entries; e++) {
        const int32_t *entry = m->reaction_entry + 4 * e;
        if (!within(entry, 1, 0, m->n_reactions) || !within(entry + 1, 1, 0, REACTION_TORQUE + 1) ||
            !within(entry + 2, 1, 0, entry[1] == REACTION_COINCIDENCE ? m->n_coincidences : m->n_form_rows))
            return 0;
    }
    for (int32_t i = 0; i < m->n_sampled; i++)
        if (!within(m->sampled_load + 2 * i, 1, 0, SAMPLED_DRIVE + 1) ||
            !within(m->sampled_load + 2 * i + 1, 1, 0, end[m->sampled_load[2 * i]]))
            return 0;
    return 1;
}

static int has_masses_and_rows(const checker *c)
{
    const holonom_model *m = c->m;
    return has(c, TABLE(mass_node), 2 * (int64_t)m->n_mass, 0, c->n_moving) &&
           within(m->mass_node, 2 * (int64_t)m->n_mass_free, 0, m->n_free) &&
           has(c, TABLE(linked_form), m->n_linked, 0, m->n_forms) && has(c, TABLE(row_form), m->n_form_rows, 0, m->n_forms) &&
           has(c, TABLE(row_power), m->n_rows, 0, 9) && has(c, TABLE(coincidence_form), m->n_coincidences, 0, m->n_forms);
}

static int has_tape(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t count = (int64_t)m->n_tape[0] + m->n_tape[1] + m->n_tape[2] + m->n_tape[3];
    if (!is_long(c, TABLE(tape), 5 * count)) return 0;
    for (int64_t i = 0; i < count; i++)
        if (!within(m->tape + 5 * i + 1, 4, 0, m->n_numbers)) return 0;
    return 1;
}

/* Whether columns of islands rise from the first of their kind to the last. */
static int has_islands(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t first_velocity = (int64_t)m->n_elements + m->n_function_rows, first_potential = first_velocity + m->n_velocity_rows;
    const int64_t bounds[ISLAND_COLUMNS][2] = {
        [ISLAND_FREE] = {0, m->n_free}, [ISLAND_DRIVEN] = {m->n_free, c->n_moving}, [ISLAND_ELEMENT] = {0, m->n_elements},
        [ISLAND_FUNCTION] = {m->n_elements, first_velocity}, [ISLAND_VELOCITY] = {first_velocity, first_potential},
        [ISLAND_POTENTIAL] = {first_potential, c->n_composites}, [ISLAND_FORM_ROW] = {0, m->n_form_rows},
        [ISLAND_COINCIDENCE] = {0, m->n_coincidences}, [ISLAND_LOAD] = {0, m->n_loads}, [ISLAND_MOMENT] = {0, m->n_moments},
        [ISLAND_BODY_MOMENT] = {0, m->n_body_moments}, [ISLAND_MASS] = {0, m->n_mass}, [ISLAND_LINKED] = {0, m->n_linked},
        [ISLAND_ACTIVE] = {0, m->n_active}, [ISLAND_BODY] = {0, m->n_bodies},
    };
    if (!is_long(c, TABLE(island_begin), ISLAND_COLUMNS * ((int64_t)m->n_islands + 1))) return 0;
    for (int k = 0; k < ISLAND_COLUMNS; k++) {
        const int32_t *at = m->island_begin + k;
        if (at[0] != bounds[k][0] || at[(int64_t)ISLAND_COLUMNS * m->n_islands] != bounds[k][1]) return 0;
        for (int32_t i = 0; i < m->n_islands; i++)
            if (at[ISLAND_COLUMNS * (i + 1)] < at[ISLAND_COLUMNS * i]) return 0;
    }
    return 1;
}

/* Whether `ptr` has the places of lists of slots with these lengths, and the slots lie in n values. */
static int has_slots(const checker *c, size_t ptr, size_t slots, int64_t count, int64_t (*length)(const checker *, int32_t, int), int lean, int64_t n)
{
    const int32_t *at = (&c->m->island_begin)[ptr];
    if (!rises(c, ptr, count, c->length[slots], INT32_MAX)) return 0;
    for (int32_t i = 0; i < count; i++)
        if (at[i + 1] - (int64_t)at[i] != length(c, i, lean)) return 0;
    return within((&c->m->island_begin)[slots], c->length[slots], 0, n);
}

static int64_t row_slots(const checker *c, int32_t i, int lean)
{
    const int32_t f = c->m->row_form[i], kind = c->m->form_kind[f];
    const int64_t k = c->m->form_free[f];
    return 2 * DIM * k + (lean || kind & FORM_LINEAR ? 0 : k * k * (kind & FORM_TURNED ? DIM * DIM : DIM));
}

static int64_t coincidence_slots(const checker *c, int32_t j, int lean)
{
    const int32_t f = c->m->coincidence_form[j];
    (void)lean;
    return 2 * DIM * (int64_t)c->m->form_free[f] * (c->m->form_kind[f] & FORM_TURNED ? DIM : 1);
}

static int64_t composite_slots(const checker *c, int32_t j, int lean)
{
    const holonom_model *m = c->m;
    const int64_t size = DIM * (int64_t)(m->composite_node_ptr[j + 1] - m->composite_node_ptr[j]);
    const int row = j >= m->n_elements && j < c->n_composites - m->n_potentials;
    return lean && !row ? 0 : (lean ? 0 : size * size) + (row ? 2 * size : 0);
}

static int64_t load_slots(const checker *c, int32_t j, int lean)
{
    (void)lean;
    return c->m->load_axes[j] < 0 ? 0 : (int64_t)c->m->form_free[c->m->load_form[j]] * (DIM == 2 ? 1 : 3) * DIM * DIM;
}

static int64_t moment_slots(const checker *c, int32_t j, int lean)
{
    const int64_t k = c->m->form_free[c->m->moment_form[j]];
    (void)lean;
    return k * k * DIM * DIM;
}

/* Whether the elimination whose tables begin at `first` is one of this model with n_values stored entries. */
static int has_elimination(const checker *c, size_t first, const holonom_elimination *e, int64_t n_values, int lean)
{
    const holonom_model *m = c->m;
    const int64_t n = DIM * (int64_t)m->n_free + m->n_rows;
#define OWN(name) (first + offsetof(holonom_elimination, name) / sizeof(const int32_t *))
    if (!has(c, OWN(node_position), m->n_free, 0, n - DIM + 1) || !has(c, OWN(row_position), m->n_rows, 0, n) ||
        !rises(c, OWN(lu_ptr), n, n_values, INT32_MAX) || !is_long(c, OWN(lu_island), 2 * ((int64_t)m->n_islands + 1)))
        return 0;
    int64_t columns = 0, targets = 0;
    int32_t island = 0;
    for (int32_t k = 0; k <= n; k++) { /* where islands begin: a pivot, and the targets before it */
        for (; island <= m->n_islands && e->lu_island[2 * island] == k; island++)
            if (e->lu_island[2 * island + 1] != targets || (island == 0 && k)) return 0;
        if (k == n) break;
        const int64_t width = e->lu_ptr[k + 1] - (int64_t)e->lu_ptr[k], neighbours = (width - 1) / 2;
        if (width % 2 == 0 || columns + neighbours > c->length[OWN(lu_column)] ||
            !within(e->lu_column + columns, neighbours, k + 1, n))
            return 0;
        columns += neighbours;
        targets += neighbours * neighbours;
    }
    return island == m->n_islands + 1 && e->lu_island[2 * m->n_islands] == n && is_long(c, OWN(lu_column), columns) &&
           has(c, OWN(lu_target), targets, 0, n_values) && has(c, OWN(mass_slot), DIM * (int64_t)m->n_mass_free, 0, n_values) &&
           has_slots(c, OWN(row_slot_ptr), OWN(row_slot), m->n_form_rows, row_slots, lean, n_values) &&
           has_slots(c, OWN(coincidence_slot_ptr), OWN(coincidence_slot), m->n_coincidences, coincidence_slots, lean, n_values) &&
           has_slots(c, OWN(composite_slot_ptr), OWN(composite_slot), c->n_composites, composite_slots, lean, n_values);
#undef OWN
}

int hm_is_consistent(const holonom_model *m, const int32_t *table_length)
{
    const checker checked = {m, table_length, (int64_t)m->n_free + m->n_driven + m->n_support, (int64_t)m->n_free + m->n_driven,
                             (int64_t)m->n_elements + m->n_function_rows + m->n_velocity_rows + m->n_potentials};
    const checker *c = &checked;
    return has_sizes(c) && has_forms(c) && has_sections(c) && has_quantities(c) && has_masses_and_rows(c) && has_composites(c) &&
           has_loads(c) && has_tape(c) && has_islands(c) && has_elimination(c, TABLE(full), &m->full, m->n_lu_values, 0) &&
           (!m->n_lean_values || has_elimination(c, TABLE(lean), &m->lean, m->n_lean_values, 1)) &&
           has_slots(c, TABLE(load_slot_ptr), TABLE(load_slot), m->n_loads, load_slots, 0, m->n_lu_values) &&
           has_slots(c, TABLE(moment_slot_ptr), TABLE(moment_slot), m->n_moments, moment_slots, 0, m->n_lu_values) &&
           has(c, TABLE(body_moment_slot), 81 * (int64_t)m->n_body_moments, 0, m->n_lu_values);
}
