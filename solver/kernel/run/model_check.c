/* Checks a model from outside before anything follows its indices: each table is as long as its
   readers think, and each index lies within what it points into. A model that is wrong within these
   bounds moves wrongly, but its run ends. */
#include "small.h"

#include "check_tables.h"
#include "internal.h"

/* Place of a table among all. */
#define TABLE(name)                                                                                \
    ((offsetof(holonom_model, name) - offsetof(holonom_model, island_begin))                       \
     / sizeof(const int32_t *))

enum { LARGEST_SIZE = 1 << 26 }; /* so that no sum of a few overflows */

typedef struct checker {
    const holonom_model *m;
    const int32_t *length;
    hm_counts count;
    int lean; /* of the factors at hand */
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

int hm_holds(const holonom_model *m, int32_t at, int64_t length)
{ return at >= 0 && at + length <= m->n_numbers; }

/* Each column rises from the first of its kind to the last. */
int hm_divides(const holonom_model *m, const int64_t (*bound)[2])
{
    for (int k = 0; k < ISLAND_COLUMNS; k++) {
        const int32_t *at = m->island_begin + k;
        if (at[0] != bound[k][0] || at[(int64_t)ISLAND_COLUMNS * m->n_islands] != bound[k][1])
            return 0;
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
    const int64_t rows = (int64_t)m->n_form_rows + DIM * (int64_t)m->n_coincidences
                         + m->n_function_rows + m->n_velocity_rows;
    return rows == m->n_rows && m->n_active <= m->n_quantities && m->n_mass_free <= m->n_mass
           && m->n_slots <= 64 && m->steep_signals <= 1 && m->time_dependent <= 1
           && m->variable_potential <= 1 && m->sensing <= 1 && m->accelerates <= 1
           && m->fits_velocities <= 1
           && m->switching == (m->n_switches > 0) && m->n_motion_switches <= m->n_switches
           && m->n_kinks <= m->n_motion_switches
           && m->n_energy_kinks <= m->n_kinks
           && DIM * (int64_t)m->n_driven <= m->n_signals;
}

static int has_turns_and_derived(const checker *c)
{
    const holonom_model *m = c->m;
    int turned = 0;
    for (int32_t f = 0; f < m->n_forms; f++) turned |= m->form_kind[f] & FORM_TURNED;
    if (turned
        && (DIM == 3 || !hm_holds(m, m->alpha_turn_at, m->n_entries)
            || !hm_holds(m, m->beta_turn_at, m->n_entries)))
        return 0;
    return m->row_scale_at == m->extent_at + 2 && m->row_sigma_at == m->row_scale_at + m->n_rows;
}

/* Whether the directors of each body lie one behind the other among the free nodes, those of the
   next one behind, and no other node is a direction. */
static int has_bodies(const checker *c)
{
    const holonom_model *m = c->m;
    int32_t bodies = 0, expected = NODE_POINT; /* 1 more than the kind before, within a body */
    for (int32_t a = 0; a < c->count.n_moving; a++) {
        const int32_t kind = m->node_kind[a];
        if (expected == NODE_POINT && kind == NODE_DIRECTION) {
            if (a >= m->n_free || bodies >= m->n_bodies || m->body_node[bodies++] != a) return 0;
        } else if (kind != expected || (kind != NODE_POINT && a >= m->n_free))
            return 0;
        expected = kind == NODE_POINT || kind == c->count.turning ? NODE_POINT : kind + 1;
    }
    if (bodies != m->n_bodies || expected != NODE_POINT) return 0;
    for (int32_t j = 0; j < m->n_loads; j++)
        if (m->load_axes[j] >= 0 && m->node_kind[m->load_axes[j]] != NODE_DIRECTION) return 0;
    for (int32_t j = 0; j < m->n_body_moments; j++)
        if (m->node_kind[m->body_moment[2 * j]] != NODE_DIRECTION) return 0;
    return m->n_rigidity_rows <= m->n_form_rows &&
           m->n_rigidity_rows == c->count.turning * (DIM - 1) * m->n_bodies;
}

HM_SELDOM static int has_forms(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t n_moving = c->count.n_moving, n_nodes = c->count.n_nodes;
    for (int32_t f = 0; f < m->n_forms; f++) { /* free nodes come first, then driven ones */
        const int32_t *node = m->form_node + m->form_ptr[f];
        const int32_t count = m->form_ptr[f + 1] - m->form_ptr[f], moving = m->form_moving[f],
                      free = m->form_free[f];
        if (free > moving || moving > count || !within(node, free, 0, m->n_free)
            || !within(node + free, moving - free, m->n_free, n_moving)
            || !within(node + moving, count - moving, n_moving, n_nodes))
            return 0;
    }
    return 1;
}

static int has_quantities(const checker *c)
{
    const holonom_model *m = c->m;
    for (int32_t j = 0; j < m->n_quantities; j++)
        if (m->quantity_form[2 * j] < 0
            || (m->quantity_kind[j] == QUANTITY_ANGLE && m->quantity_form[2 * j + 1] < 0))
            return 0;
    return 1;
}

/* Whether leaf `entry` of a composite with so many forms names a quantity or a signal, and forms
   for each slope. */
static int is_leaf(const checker *c, const int32_t *entry, int32_t forms)
{
    const holonom_model *m = c->m;
    if (entry[2] >= forms || entry[3] >= forms || entry[2] < -1 || entry[3] < -1) return 0;
    if (entry[0] == LEAF_SIGNAL)
        return entry[1] >= 0 && entry[1] < m->n_signals && entry[2] < 0 && entry[3] < 0;
    if (entry[0] < 0 || entry[0] > LEAF_SIGNAL || entry[1] < 0 || entry[1] >= m->n_active
        || entry[2] < 0)
        return 0;
    return (m->quantity_kind[entry[1]] == QUANTITY_ANGLE) == (entry[3] >= 0);
}

/* Whether an operation needs no table, or has one between these places: of whole rows, or of a grid
   with its `coordinates`. */
static int has_table(int32_t code, int64_t first, int64_t last, int coordinates)
{
    if (code >= T_GRID)
        return HM_CONTACTS && code < T_END && coordinates && first >= 0 && last >= first + 7;
    return code < T_SPLINE || (first >= 0 && last >= first + 6 && (last - first) % 6 == 0);
}

/* Whether the operations of a function read what comes before them. */
static int is_function(const checker *c, const int32_t *operation, int32_t n_leaves, int32_t count)
{
    for (const int32_t *op = operation; op < operation + 4 * (int64_t)count; op += 4, n_leaves++)
        if (!within(op + 1, 3, -(int64_t)c->m->n_numbers, n_leaves)
            || !has_table(op[0], -1 - (int64_t)op[2], -1 - (int64_t)op[3],
                          op[1] >= 0 && op[1] <= n_leaves - 3))
            return 0;
    return n_leaves > 0 && n_leaves <= c->m->n_registers;
}

/* Whether potential j is an energy, or a force along its first leaf that reads no signals. */
static int fits_its_role(const checker *c, int32_t j)
{
    const holonom_model *m = c->m;
    if (m->force_role[j - c->count.first_potential] == STORES) return 1;
    for (int32_t l = m->leaf_ptr[j]; l < m->leaf_ptr[j + 1]; l++)
        if (m->leaf[4 * l] == LEAF_SIGNAL) return 0;
    return m->leaf_ptr[j + 1] > m->leaf_ptr[j] && m->leaf[4 * m->leaf_ptr[j]] == LEAF_VALUE
           && m->depth_register[j - c->count.first_potential] < 0;
}

static int is_composite(const checker *c, int32_t j)
{
    const holonom_model *m = c->m;
    const int32_t forms = m->composite_form_ptr[j + 1] - m->composite_form_ptr[j],
                  leaves = m->leaf_ptr[j + 1] - m->leaf_ptr[j];
    const int32_t nodes = m->composite_node_ptr[j + 1] - m->composite_node_ptr[j];
    int64_t places = 0;
    for (int32_t at = m->composite_form_ptr[j]; at < m->composite_form_ptr[j + 1]; at++)
        places += m->form_free[m->composite_form[at]];
    if (places != m->composite_local_ptr[j + 1] - m->composite_local_ptr[j] ||
        !within(m->composite_local + m->composite_local_ptr[j], places, 0, nodes))
        return 0;
    for (int32_t l = m->leaf_ptr[j]; l < m->leaf_ptr[j + 1]; l++)
        if (!is_leaf(c, m->leaf + 4 * l, forms)) return 0;
    if (j < m->n_elements) return leaves == 1 && m->leaf[4 * m->leaf_ptr[j]] == LEAF_VALUE;
    const int32_t begin = m->function_ptr[j - m->n_elements],
                  end = m->function_ptr[j - m->n_elements + 1];
    return is_function(c, m->operation + 4 * (int64_t)begin, leaves, end - begin)
           && (j < c->count.first_potential || fits_its_role(c, j));
}

HM_SELDOM static int has_composites(const checker *c)
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
        if (m->load_axes[j] >= 0 && m->load_axes[j] > c->count.n_moving - c->count.turning)
            return 0;
    for (int32_t j = 0; j < m->n_body_moments; j++)
        if (m->body_moment[2 * j] < 0 || m->body_moment[2 * j] > m->n_free - 3) return 0;
    for (int32_t e = 0; e < m->n_reaction_entries; e++) {
        const int32_t *entry = m->reaction_entry + 4 * e;
        if (!within(entry, 1, 0, m->n_reactions) || !within(entry + 1, 1, 0, REACTION_TORQUE + 1)
            || !within(entry + 2, 1, 0,
                       entry[1] == REACTION_COINCIDENCE ? m->n_coincidences : m->n_form_rows))
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
        if (!within(op + 1, 4, 0, c->m->n_numbers)
            || !has_table(op[0], op[3], op[4], hm_holds(c->m, op[2], 3)))
            return 0;
    for (const int32_t *at = c->m->switch_table;
         at < c->m->switch_table + 5 * (int64_t)c->m->n_switches; at += 5)
        if (!within(at, 2, 0, c->m->n_numbers) || !within(at + 2, 1, SWITCH_SIGN, SWITCH_LEVEL + 1)
            || !within(at + 3, 1, 1, 3) || !within(at + 4, 1, 0, 2))
            return 0;
    for (const int32_t *at = c->m->held_table; at < c->m->held_table + 2 * (int64_t)c->m->n_held;
         at += 2)
        if (!within(at, 1, 0, c->m->n_numbers)
            || !within(at + 1, 1, 0, c->m->n_switches - c->m->n_kinks))
            return 0;
    return within(c->m->mass_node, 2 * (int64_t)c->m->n_mass_free, 0, c->m->n_free);
}

/* Whether the lists of slots that the table `ptr` divides have these lengths. */
static int has_slots(const checker *c, size_t ptr, int64_t (*length)(const checker *, int32_t))
{
    const int32_t *at = (&c->m->island_begin)[ptr];
    for (int32_t i = 0; i < c->length[ptr] - 1; i++)
        if (at[i + 1] - (int64_t)at[i] != length(c, i)) return 0;
    return 1;
}

/* Whether turns of bodies are unknowns. */
static inline int is_of_turns(const checker *c) { return n_bodies(c->m) > 0; }

static int is_turning(const checker *c, int32_t node)
{ return is_of_turns(c) && c->m->node_kind[node]; }

static int64_t size_of_unknown(const checker *c, int32_t node)
{ return is_turning(c, node) ? c->count.turning : DIM; }

/* Entry behind those with the unknown of entry e of form f. */
static int32_t end_of_side(const checker *c, int32_t f, int32_t e)
{
    const int32_t *node = c->m->form_node, end = c->m->form_ptr[f] + c->m->form_free[f],
                  first = node[e];
    const int32_t last = is_turning(c, first) ? first - (c->m->node_kind[first] - NODE_DIRECTION)
                                                    + (int32_t)c->count.turning
                                              : first;
    for (e++; is_turning(c, first) && e < end && node[e] < last; e++) continue;
    return e;
}

/* Components of the unknowns of form f. */
static int64_t components_of(const checker *c, int32_t f)
{
    const int32_t end = c->m->form_ptr[f] + c->m->form_free[f];
    int64_t sum = 0;
    for (int32_t e = c->m->form_ptr[f]; e < end; e = end_of_side(c, f, e))
        sum += size_of_unknown(c, c->m->form_node[e]);
    return sum;
}

/* Whether the free nodes of form f rise, and have as many unknowns as a tangent has room for. */
static int has_sides(const checker *c, int32_t f)
{
    const int32_t begin = c->m->form_ptr[f], end = begin + c->m->form_free[f];
    int sides = 0;
    for (int32_t e = begin; e < end; e = end_of_side(c, f, e)) sides++;
    for (int32_t e = begin + 1; e < end; e++)
        if (c->m->form_node[e] <= c->m->form_node[e - 1]) return 0;
    return sides <= MOST_SIDES;
}

/* Elements of all pairs of unknowns of form f: whole blocks if `full` or of a turn, else the
   diagonals. */
static int64_t elements(const checker *c, int32_t f, int full)
{
    const int32_t *node = c->m->form_node, begin = c->m->form_ptr[f],
                  end = begin + c->m->form_free[f];
    int64_t sum = 0;
    for (int32_t p = begin; p < end; p = end_of_side(c, f, p))
        for (int32_t q = begin; q < end; q = end_of_side(c, f, q))
            sum += full || is_turning(c, node[p]) || is_turning(c, node[q])
                       ? size_of_unknown(c, node[p]) * size_of_unknown(c, node[q])
                       : DIM;
    return sum;
}

/* Slots of a form that holds directions of two bodies, or of one and the ground; -1 if it does
   not. */
static int64_t axes_slots(const checker *c, int32_t f)
{
    const int32_t begin = c->m->form_ptr[f], end = begin + c->m->form_free[f];
    const int64_t sides = c->m->form_kind[f] & FORM_LINEAR ? 1 : 2, turning = c->count.turning;
    if (c->m->form_moving[f] != c->m->form_free[f] || components_of(c, f) != sides * turning)
        return -1;
    for (int32_t e = begin; e < end; e++)
        if (!is_turning(c, c->m->form_node[e])) return -1;
    return 2 * sides * turning + (c->lean || sides == 1 ? 0 : 2 * turning * turning);
}

static int64_t row_slots(const checker *c, int32_t i)
{
    const int32_t f = c->m->row_form[i], kind = c->m->form_kind[f];
    if (is_of_turns(c) && i >= c->count.n_joint_rows) return 0;
    if (!has_sides(c, f)) return -1;
    if (is_of_turns(c) && kind & FORM_AXES) return axes_slots(c, f);
    return 2 * components_of(c, f)
           + (c->lean || kind & FORM_LINEAR ? 0 : elements(c, f, kind & FORM_TURNED));
}

static int64_t coincidence_slots(const checker *c, int32_t j)
{
    const int32_t f = c->m->coincidence_form[j];
    const int32_t end = c->m->form_ptr[f] + c->m->form_free[f];
    int64_t sum = 0;
    if (!has_sides(c, f)) return -1;
    for (int32_t e = c->m->form_ptr[f]; e < end; e = end_of_side(c, f, e)) {
        const int32_t node = c->m->form_node[e];
        sum += 2 * DIM
               * (is_turning(c, node) || c->m->form_kind[f] & FORM_TURNED ? size_of_unknown(c, node)
                                                                          : 1);
    }
    return sum;
}

static int64_t composite_slots(const checker *c, int32_t j)
{
    const holonom_model *m = c->m;
    const int row = j >= m->n_elements && j < c->count.first_potential;
    int64_t size = 0;
    int32_t last = -1;
    for (int32_t at = m->composite_node_ptr[j]; at < m->composite_node_ptr[j + 1]; at++) {
        const int32_t node = m->composite_node[at],
                      own =
                          is_turning(c, node) ? node - (m->node_kind[node] - NODE_DIRECTION) : node;
        if (node <= last) return -1; /* they rise */
        if (own > last) size += size_of_unknown(c, node);
        last = node;
    }
    return c->lean && !row ? 0 : (c->lean ? 0 : size * size) + (row ? 2 * size : 0);
}

/* Components of the unknowns of all entries of form f that are free nodes. */
static int64_t all_components(const checker *c, int32_t f)
{
    int64_t sum = 0;
    for (int32_t e = c->m->form_ptr[f]; e < c->m->form_ptr[f] + c->m->form_free[f]; e++)
        sum += size_of_unknown(c, c->m->form_node[e]);
    return sum;
}

static int64_t load_slots(const checker *c, int32_t j)
{
    if (c->lean || c->m->load_axes[j] < 0) return 0;
    return c->count.turning * all_components(c, c->m->load_form[j])
           * size_of_unknown(c, c->m->load_axes[j]);
}

static int64_t moment_slots(const checker *c, int32_t j)
{
    const int64_t size = all_components(c, c->m->moment_form[j]);
    return c->lean ? 0 : size * size;
}

static int64_t cone_slots(const checker *c, int32_t f)
{
    const holonom_model *m = c->m;
    return (m->friction_row_ptr[f + 1] - m->friction_row_ptr[f])
           * (int64_t)(m->normal_ptr[f + 1] - m->normal_ptr[f]);
}

/* Whether contacts are gaps among the function rows, and frictions slips among the velocity rows,
   with something that presses on each. */
HM_SELDOM static int has_contacts(const checker *c)
{
    const holonom_model *m = c->m;
    const int64_t slips = c->length[TABLE(friction_row)],
                  normals = c->length[TABLE(normal_row)] / 2;
    int64_t forces = 0;
    if (m->unilateral > 1 || (!m->unilateral && (m->n_contacts || m->n_frictions))
        || m->n_hit_rows > 2 * m->n_rows)
        return 0;
    if (!HM_CONTACTS) return m->n_hit_forces == 0;
    if (!within(m->contact_row, m->n_contacts, m->n_elements, c->count.first_velocity) ||
        !within(m->friction_row, slips, c->count.first_velocity, c->count.first_potential))
        return 0;
    for (int32_t f = 0; f < m->n_frictions; f++)
        if (m->friction_row_ptr[f] == m->friction_row_ptr[f + 1]
            || m->normal_ptr[f] == m->normal_ptr[f + 1])
            return 0;
    for (int64_t i = 0; i < normals; i++)
        if (!within(m->normal_row + 2 * i, 1, 0, m->n_rows)
            || !within(m->normal_row + 2 * i + 1, 1, 0, NORMAL_SUMS))
            return 0;
    for (int32_t f = 0; f < m->n_frictions && m->n_contacts;
         f++) /* those of joints take part in impacts */
        if (m->normal_row[2 * m->normal_ptr[f] + 1] != NORMAL_PUSHES)
            forces += m->normal_ptr[f + 1] - m->normal_ptr[f];
    if (forces != m->n_hit_forces) return 0;
    for (int32_t j = 0; j < c->count.n_owned; j++) { /* the owner of a row has it */
        const int32_t owner = m->row_owner[j], row = m->n_elements + j, f = owner - m->n_contacts;
        if (owner < 0) continue;
        if (f < 0 ? m->contact_row[owner] != row
                  : row < m->friction_row[m->friction_row_ptr[f]]
                        || row > m->friction_row[m->friction_row_ptr[f + 1] - 1])
            return 0;
    }
    return 1;
}

/* Whether nodes and rows have their places among the pivots where the factors have unknowns of
   theirs, and none elsewhere. */
static int has_positions(const checker *c, const holonom_elimination *e, int64_t n)
{
    const holonom_model *m = c->m;
    for (int32_t a = 0; a < m->n_free; a++) {
        const int none = is_turning(c, a) && m->node_kind[a] != NODE_DIRECTION;
        if (none ? e->node_position[a] != -1
                 : e->node_position[a] < 0 || e->node_position[a] + size_of_unknown(c, a) > n)
            return 0;
    }
    for (int32_t i = 0; i < m->n_rows; i++) {
        const int none = is_of_turns(c) && i >= c->count.n_joint_rows && i < m->n_form_rows;
        if (none ? e->row_position[i] != -1 : e->row_position[i] < 0) return 0;
    }
    return 1;
}

/* Whether an elimination is one of this model. */
HM_SELDOM static int has_elimination(const checker *c, const holonom_elimination *e, size_t first)
{
    const holonom_model *m = c->m;
    const int64_t n = c->count.n_pivots;
#define OWN(name) (first + TABLE(full.name) - TABLE(full))
    const int64_t n_groups = c->length[OWN(lu_group)] ? c->length[OWN(lu_group)] / 3 : n;
    const int32_t *group = c->length[OWN(lu_group)] ? e->lu_group : NULL;
    int64_t columns = 0, targets = 0;
    int32_t island = 0;
    const int grouped =
        is_of_turns(c) && (m->n_contacts <= FEW_CONTACTS || e == &m->open || e == &m->bare);
    if (n_groups < 0 || grouped != (group != NULL)
        || (group
            && (c->length[OWN(lu_group)] % 3 != 1 || group[0] != 0 || group[3 * n_groups] != n)))
        return 0;
    for (int32_t g = 0, k = 0; g <= n_groups;
         g++) { /* where islands begin: a pivot, its group, the targets and columns before it */
        const int32_t *at = e->lu_island + 4 * island;
        for (; island <= m->n_islands && at[0] == k; island++, at += 4)
            if (at[1] != g || at[2] != targets || at[3] != columns || (island == 0 && k)) return 0;
        if (g == n_groups) break;
        const int64_t size = group ? group[3 * g + 3] - (int64_t)group[3 * g] : 1;
        const int jointed = DIM == 3 && size >= LEAST_WITH_JOINT && size <= MOST_WITH_JOINT;
        if (size < 1 || (size > MOST_IN_GROUP && !jointed) || k + size > n) return 0;
        for (int32_t i = 1; i < size; i++) {
            const int64_t last = jointed && i >= BODY_UNKNOWNS ? size - 1 : i;
            if (e->lu_ptr[k + i] != e->lu_ptr[k] + last * (size + 1)) return 0;
        }
        const int64_t width = e->lu_ptr[k + size] - (int64_t)e->lu_ptr[k] - size * size,
                      neighbours = width / (2 * size);
        if (width < 0 || width % (2 * size) || columns + neighbours > c->length[OWN(lu_column)]
            || !within(e->lu_column + columns, neighbours, k + size, n)
            || (group && (group[3 * g + 1] != neighbours || neighbours % 2)))
            return 0;
        if (group && group[3 * g + 2] != 0
            && !(jointed && group[3 * g + 2] == 1 && neighbours >= BODY_UNKNOWNS))
            return 0;
        columns += neighbours;
        targets += neighbours * neighbours;
        k += (int32_t)size;
    }
    return island == m->n_islands + 1
           && (e->lu_island[4 * m->n_islands] == n || e == &m->open || e == &m->bare)
           && c->length[OWN(lu_column)] == columns && c->length[OWN(lu_target)] == targets
           && has_slots(c, OWN(row_slot_ptr), row_slots)
           && has_slots(c, OWN(coincidence_slot_ptr), coincidence_slots)
           && has_slots(c, OWN(composite_slot_ptr), composite_slots)
           && has_slots(c, OWN(cone_slot_ptr), cone_slots)
           && has_slots(c, OWN(load_slot_ptr), load_slots)
           && has_slots(c, OWN(moment_slot_ptr), moment_slots)
           && c->length[OWN(body_moment_slot)] == (c->lean ? 0 : 81 * (int64_t)m->n_body_moments)
           && c->length[OWN(inertia_slot)]
                  == (is_of_turns(c) ? c->count.turning * c->count.turning * m->n_bodies : 0)
           && has_positions(c, e, n);
#undef OWN
}

HM_SELDOM int hm_is_consistent(const holonom_model *m, const int32_t *table_length)
{
    checker checked = {m, table_length, {0}, 0};
    const checker *c = &checked;
    if (!has_sizes(c)) return 0;
    const hm_counts *count = &checked.count;
    checked.count = counts_of(m);
    if (!has_tables(m, count, table_length) || !has_forms(c) || !has_sections(m, count)
        || !has_turns_and_derived(c) || !has_quantities(c) || !has_composites(c)
        || !has_sound_loads(c) || !has_bodies(c) || !has_contacts(c) || !has_tape(c)
        || !has_islands(m, count))
        return 0;
    const holonom_elimination *factors[] = {&m->full, &m->open, &m->lean, &m->bare};
    const size_t place[] = {TABLE(full), TABLE(open), TABLE(lean), TABLE(bare)};
    const int32_t n_values[] = {m->n_lu_values, m->n_open_values, m->n_lean_values,
                                m->n_bare_values};
    for (int i = 0; i < 4; i++) {
        if (i && !n_values[i]) continue;
        checked.lean = i > 1;
        if (n_values[i] > m->n_lu_values
            || !has_factors(m, count, factors[i], table_length + place[i], n_values[i])
            || !has_elimination(c, factors[i], place[i]))
            return 0;
    }
    return 1;
}

#include "small.h"
