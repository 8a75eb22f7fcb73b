/* Checks a model from outside before anything follows its indices: each table is as long as its readers think, and each index
   lies within what it points into. A model that is wrong within these bounds moves wrongly, but its run ends. */
#include "small.h"

#include "check_tables.h"
#include "internal.h"
#include "model_file.h"

/* Place of a table among all. */
#define TABLE(name) ((offsetof(holonom_model, name) - offsetof(holonom_model, island_begin)) / sizeof(const int32_t *))

enum { LARGEST_SIZE = 1 << 26 }; /* so that no sum of a few overflows */

typedef struct checker {
    const holonom_model *m;
    const int32_t *length;
    hm_counts count;
} checker;

static int within(const int32_t *value, int64_t count, int64_t low, int64_t end)
{
    for (int64_t i = 0; i < count; i++)
        if (value[i] < low || value[i] >= end) return 0;
    return 1;
}

int hm_has(const int32_t *table, int64_t length, int64_t count, int64_t low, int64_t end)
{
    return length == count && within(table, count, low, end);
}

int hm_rises(const int32_t *at, int64_t length, int64_t count, int64_t total, int64_t most)
{
    if (length != count + 1 || at[0] != 0 || at[count] != total) return 0;
    for (int64_t i = 0; i < count; i++)
        if (at[i + 1] < at[i] || at[i + 1] - (int64_t)at[i] > most) return 0;
    return 1;
}

int hm_holds(const holonom_model *m, int32_t at, int64_t length) { return at >= 0 && at + length <= m->n_numbers; }

/* Each column rises from the first of its kind to the last. */
int hm_divides(const holonom_model *m, const int64_t (*bound)[2])
{
    for (int k = 0; k < ISLAND_COLUMNS; k++) {
        const int32_t *at = m->island_begin + k;
        if (at[0] != bound[k][0] || at[(int64_t)ISLAND_COLUMNS * m->n_islands] != bound[k][1]) return 0;
        for (int32_t i = 0; i < m->n_islands; i++)
            if (at[ISLAND_COLUMNS * (i + 1)] < at[ISLAND_COLUMNS * i]) return 0;
    }
    return 1;
}

static int has_sizes(const checker *c)
{
    const holonom_model *m = c->m;
    const int32_t *size = &m->dim;
    for (int i = 0; i < N_SIZES; i++)
        if (size[i] < 0 || size[i] > LARGEST_SIZE) return 0;
    const int64_t rows = (int64_t)m->n_form_rows + DIM * (int64_t)m->n_coincidences + m->n_function_rows + m->n_velocity_rows;
    return rows == m->n_rows && m->n_active <= m->n_quantities && m->n_mass_free <= m->n_mass && m->n_slots <= 64 &&
           m->time_dependent <= 1 && m->variable_potential <= 1 && m->sensing <= 1 && DIM * (int64_t)m->n_driven <= m->n_signals;
}

static int has_turns_and_derived(const checker *c)
{
    const holonom_model *m = c->m;
    int turned = 0;
    for (int32_t f = 0; f < m->n_forms; f++) turned |= m->form_kind[f] & FORM_TURNED;
    if (turned && (DIM == 3 || !hm_holds(m, m->alpha_turn_at, m->n_entries) || !hm_holds(m, m->beta_turn_at, m->n_entries)))
        return 0;
    return m->row_scale_at == m->extent_at + 2 && m->row_sigma_at == m->row_scale_at + m->n_rows;
}

static int has_forms(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t n_moving = c->count.n_moving, n_nodes = c->count.n_nodes;
    for (int32_t f = 0; f < m->n_forms; f++) { /* free nodes come first, then driven ones */
        const int32_t *node = m->form_node + m->form_ptr[f];
        const int32_t count = m->form_ptr[f + 1] - m->form_ptr[f], moving = m->form_moving[f], free = m->form_free[f];
        if (free > moving || moving > count || !within(node, free, 0, m->n_free) ||
            !within(node + free, moving - free, m->n_free, n_moving) || !within(node + moving, count - moving, n_moving, n_nodes))
            return 0;
    }
    return 1;
}

static int has_quantities(const checker *c)
{
    const holonom_model *m = c->m;
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

/* Whether an operation needs no table, or has one between these places: of whole rows, or of a grid with its `coordinates`. */
static int has_table(int32_t code, int64_t first, int64_t last, int coordinates)
{
    if (code >= T_GRID) return code < T_END && coordinates && first >= 0 && last >= first + 7;
    return code < T_SPLINE || (first >= 0 && last >= first + 6 && (last - first) % 6 == 0);
}

/* Whether the operations of a function read what comes before them. */
static int is_function(const checker *c, const int32_t *operation, int32_t n_leaves, int32_t count)
{
    for (const int32_t *op = operation; op < operation + 4 * (int64_t)count; op += 4, n_leaves++)
        if (!within(op + 1, 3, -(int64_t)c->m->n_numbers, n_leaves) ||
            !has_table(op[0], -1 - (int64_t)op[2], -1 - (int64_t)op[3], op[1] >= 0 && op[1] <= n_leaves - 3))
            return 0;
    return n_leaves > 0 && n_leaves <= c->m->n_registers;
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
    const int64_t parts = (int64_t)c->length[TABLE(leaf)] / 4 + c->length[TABLE(operation)] / 4;
    if (m->n_registers > parts + 1 || m->n_local_forms > c->length[TABLE(composite_form)] + 1 ||
        m->n_local_nodes > c->length[TABLE(composite_node)] + 1)
        return 0;
    for (int32_t j = 0; j < c->count.n_composites; j++)
        if (!is_composite(c, j)) return 0;
    return 1;
}

static int has_sound_loads(const checker *c)
{
    const holonom_model *m = c->m;
    const int32_t end[] = {m->n_loads, m->n_moments, m->n_body_moments, m->n_elements};
    for (int32_t j = 0; j < m->n_loads; j++)
        if (m->load_axes[j] >= 0 && m->load_axes[j] > c->count.n_moving - c->count.turning) return 0;
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

static int has_tape(const checker *c)
{
    for (const int32_t *op = c->m->tape; op < c->m->tape + 5 * c->count.n_tape; op += 5)
        if (!within(op + 1, 4, 0, c->m->n_numbers) || !has_table(op[0], op[3], op[4], hm_holds(c->m, op[2], 3))) return 0;
    return within(c->m->mass_node, 2 * (int64_t)c->m->n_mass_free, 0, c->m->n_free);
}

/* Whether the lists of slots that the table `ptr` divides have these lengths. */
static int has_slots(const checker *c, size_t ptr, int64_t (*length)(const checker *, int32_t, int), int lean)
{
    const int32_t *at = (&c->m->island_begin)[ptr];
    for (int32_t i = 0; i < c->length[ptr] - 1; i++)
        if (at[i + 1] - (int64_t)at[i] != length(c, i, lean)) return 0;
    return 1;
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
    const int row = j >= m->n_elements && j < c->count.first_potential;
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

static int64_t cone_slots(const checker *c, int32_t f, int lean)
{
    const holonom_model *m = c->m;
    (void)lean;
    return (m->friction_row_ptr[f + 1] - m->friction_row_ptr[f]) * (int64_t)(m->normal_ptr[f + 1] - m->normal_ptr[f]);
}

/* Whether contacts are gaps among the function rows, and frictions slips among the velocity rows, with something that
   presses on each. */
static int has_contacts(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t slips = c->length[TABLE(friction_row)], normals = c->length[TABLE(normal_row)] / 2;
    int64_t forces = 0;
    if (m->unilateral > 1 || (!m->unilateral && (m->n_contacts || m->n_frictions)) || m->n_hit_rows > m->n_rows) return 0;
    if (!within(m->contact_row, m->n_contacts, m->n_elements, c->count.first_velocity) ||
        !within(m->friction_row, slips, c->count.first_velocity, c->count.first_potential))
        return 0;
    for (int32_t f = 0; f < m->n_frictions; f++)
        if (m->friction_row_ptr[f] == m->friction_row_ptr[f + 1] || m->normal_ptr[f] == m->normal_ptr[f + 1]) return 0;
    for (int64_t i = 0; i < normals; i++)
        if (!within(m->normal_row + 2 * i, 1, 0, m->n_rows) || !within(m->normal_row + 2 * i + 1, 1, 0, NORMAL_SUMS)) return 0;
    for (int32_t f = 0; f < m->n_frictions && m->n_contacts; f++) /* those of joints take part in impacts */
        if (m->normal_row[2 * m->normal_ptr[f] + 1] != NORMAL_PUSHES) forces += m->normal_ptr[f + 1] - m->normal_ptr[f];
    if (forces != m->n_hit_forces) return 0;
    for (int32_t j = 0; j < c->count.n_owned; j++) { /* the owner of a row has it */
        const int32_t owner = m->row_owner[j], row = m->n_elements + j, f = owner - m->n_contacts;
        if (owner < 0) continue;
        if (f < 0 ? m->contact_row[owner] != row
                  : row < m->friction_row[m->friction_row_ptr[f]] || row > m->friction_row[m->friction_row_ptr[f + 1] - 1])
            return 0;
    }
    return 1;
}

/* Whether an elimination is one of this model. */
static int has_elimination(const checker *c, const holonom_elimination *e, size_t first)
{
    const holonom_model *m = c->m;
    const int64_t n = c->count.n_pivots;
    const int lean = e == &m->lean || e == &m->bare;
#define OWN(name) (first + TABLE(full.name) - TABLE(full))
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
    return island == m->n_islands + 1 && (e->lu_island[2 * m->n_islands] == n || e == &m->open || e == &m->bare) &&
           c->length[OWN(lu_column)] == columns && c->length[OWN(lu_target)] == targets && has_slots(c, OWN(row_slot_ptr), row_slots, lean) &&
           has_slots(c, OWN(coincidence_slot_ptr), coincidence_slots, lean) &&
           has_slots(c, OWN(composite_slot_ptr), composite_slots, lean) && has_slots(c, OWN(cone_slot_ptr), cone_slots, lean);
#undef OWN
}

int hm_is_consistent(const holonom_model *m, const int32_t *table_length)
{
    checker checked = {m, table_length, {0}};
    const checker *c = &checked;
    if (!has_sizes(c)) return 0;
    const hm_counts *count = &checked.count;
    checked.count = counts_of(m);
    if (!has_tables(m, count, table_length) || !has_forms(c) || !has_sections(m, count) || !has_turns_and_derived(c) ||
        !has_quantities(c) || !has_composites(c) || !has_sound_loads(c) || !has_contacts(c) || !has_tape(c) ||
        !has_islands(m, count))
        return 0;
    const holonom_elimination *factors[] = {&m->full, &m->lean, &m->open, &m->bare};
    const size_t place[] = {TABLE(full), TABLE(lean), TABLE(open), TABLE(bare)};
    const int32_t n_values[] = {m->n_lu_values, m->n_lean_values, m->n_open_values, m->n_bare_values};
    for (int i = 0; i < 4; i++) {
        if (i && !n_values[i]) continue;
        if (n_values[i] > m->n_lu_values || !has_factors(m, count, factors[i], table_length + place[i], n_values[i]) ||
            !has_elimination(c, factors[i], place[i]))
            return 0;
    }
    return has_slots(c, TABLE(load_slot_ptr), load_slots, 0) && has_slots(c, TABLE(moment_slot_ptr), moment_slots, 0);
}

#include "small.h"
