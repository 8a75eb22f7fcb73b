#include "small.h"

#include "model_file.h"
#include "internal.h"

#include <string.h>

/* CRC-32 (IEEE 802.3). */
uint32_t hm_checksum(uint32_t before, const void *bytes, size_t count)
{
    uint32_t table[256], crc = ~before;
    for (uint32_t i = 0; i < 256; i++) {
        table[i] = i;
        for (int bit = 0; bit < 8; bit++)
            table[i] = table[i] >> 1 ^ (table[i] & 1 ? 0xEDB88320u : 0);
    }
    for (const uint8_t *byte = bytes; count; count--, byte++)
        crc = crc >> 8 ^ table[(crc ^ *byte) & 255];
    return ~crc;
}

static const char *flaw_of_header(const hm_header *h, int64_t length)
{
    if (length < (int64_t)sizeof *h || memcmp(h->magic, "HOLONOM", 8))
        return "it is no model of holonom";
    if (h->abi != HOLONOM_ABI) return "it is of another version of holonom";
    const size_t begin = offsetof(hm_header, abi);
    if (h->length != (uint64_t)length
        || h->checksum != hm_checksum(0, (const char *)h + begin, (size_t)length - begin))
        return "it is damaged";
    return NULL;
}

static uint64_t even(uint64_t count) { return count + (count & 1); }

/* Lays the parts over the bytes, which must hold them. */
static int lay_parts(const char *bytes, hm_model_file *f)
{
    const hm_header *h = f->header;
    const int32_t *ints = (const int32_t *)(const void *)(bytes + sizeof *h);
    const uint64_t n_before = N_SIZES + N_OFFSETS + N_TABLES,
                   doubles = S_HEAD + (uint64_t)h->n_numbers;
    const uint64_t need = sizeof *h + 4 * even(h->n_ints) + 8 * doubles
                          + sizeof(hm_variable) * (uint64_t)h->n_variables
                          + sizeof(hm_rule) * (uint64_t)h->n_rules
                          + sizeof(hm_row) * (uint64_t)h->n_rows + 4 * even(h->n_names) + h->n_text;
    if (need > h->length || h->n_ints < n_before || !h->n_text || h->n_text % 8) return 0;
    f->table_length = ints + N_SIZES + N_OFFSETS;
    uint64_t n_ints = n_before;
    for (size_t i = 0; i < N_TABLES; i++) {
        if (f->table_length[i] < 0) return 0;
        n_ints += (uint64_t)f->table_length[i];
    }
    if (n_ints != h->n_ints) return 0;
    const int32_t *table = ints + n_before, **pointer = &f->model.island_begin;
    memcpy(&f->model.dim, ints, 4 * N_SIZES);
    memcpy(&f->model.mass_at, ints + N_SIZES, 4 * N_OFFSETS);
    for (size_t i = 0; i < N_TABLES; table += f->table_length[i++]) pointer[i] = table;
    f->settings = (const double *)(const void *)(ints + even(h->n_ints));
    f->numbers = f->settings + S_HEAD;
    f->variable = (const hm_variable *)(const void *)(f->numbers + h->n_numbers);
    f->rule = (const hm_rule *)(const void *)(f->variable + h->n_variables);
    f->row = (const hm_row *)(const void *)(f->rule + h->n_rules);
    f->sampled = (const uint32_t *)(const void *)(f->row + h->n_rows);
    f->switches = f->sampled + f->model.n_sampled;
    f->text = (const char *)(f->sampled + even(h->n_names));
    return !f->text[h->n_text - 1];
}

static int has_text(const hm_model_file *f, uint32_t at) { return at < f->header->n_text; }

/* Whether a list of words ends, with an empty one, before the texts do. */
static int has_words(const hm_model_file *f, uint32_t at)
{
    while (has_text(f, at) && f->text[at]) at += (uint32_t)strlen(f->text + at) + 1;
    return has_text(f, at);
}

static int is_sound(const hm_model_file *f, const hm_variable *v)
{
    const holonom_model *m = &f->model;
    const int32_t end[] = {m->n_parameters, m->n_inputs, m->n_numbers,
                           m->n_numbers - m->measured_at, S_HORIZON};
    if (v->type >= TYPE_END || v->causality >= CAUSALITY_END || v->variability >= VARIABILITY_END
        || v->kind >= KIND_END)
        return 0;
    if (v->place < (v->kind == KIND_OPTION ? S_STEP_SIZE : 0) || v->place >= end[v->kind]) return 0;
    if ((v->causality <= CAUSALITY_INPUT) == (v->kind == KIND_NUMBER || v->kind == KIND_MEASURED))
        return 0;
    if (v->type != TYPE_REAL && v->kind != KIND_OPTION) return 0;
    return has_text(f, v->name) && has_text(f, v->unit) && has_words(f, v->words)
           && fabs(v->start) < INFINITY;
}

static int has_sound_records(const hm_model_file *f)
{
    const hm_header *h = f->header;
    int options = 0;
    for (uint32_t i = 0; i < h->n_variables; i++) {
        if (!is_sound(f, f->variable + i)) return 0;
        options += f->variable[i].kind == KIND_OPTION;
    }
    for (uint32_t i = 0; i < h->n_rules; i++) {
        const hm_rule *rule = f->rule + i;
        if (rule->number < 0 || rule->number >= f->model.n_numbers
            || (rule->relation & ~OF_A_LAW) > IS_NOTED || rule->relation < 0
            || !has_text(f, rule->name) || !has_text(f, rule->message))
            return 0;
    }
    for (uint32_t i = 0; i < h->n_rows; i++)
        if (!has_text(f, f->row[i].name) || !has_text(f, f->row[i].detail)
            || f->row[i].kind >= ROW_KINDS)
            return 0;
    for (uint32_t i = 0; i < h->n_names; i++)
        if (!has_text(f, f->sampled[i])) return 0;
    return options
           == (f->model.unilateral ? S_HORIZON : S_REST_SPEED)
                  - S_STEP_SIZE; /* those of contacts come last */
}

int hm_view(const void *bytes, hm_model_file *f)
{
    memset(f, 0, sizeof *f);
    f->header = bytes;
    return lay_parts(bytes, f);
}

const char *hm_bind(const void *bytes, int64_t length, hm_model_file *f)
{
    if ((uintptr_t)bytes % 8) return "it does not lie on an address that 8 divides";
    const char *flaw = flaw_of_header(bytes, length);
    if (flaw) return flaw;
    if (!hm_view(bytes, f)) return "its parts are not as long as it says";
    const hm_header *h = f->header;
    const holonom_model *m = &f->model;
    if (m->dim != DIM) return "it is of another dimension";
    if (m->n_bodies && !HM_BODIES)
        return "it has rigid bodies, and this library is for models without them";
    if (m->unilateral && !HM_CONTACTS)
        return "it has contacts or frictions, and this library is for models without them";
    if (m->n_numbers < 0 || (uint32_t)m->n_numbers != h->n_numbers || m->n_rows < 0
        || (uint32_t)m->n_rows != h->n_rows || m->n_sampled < 0 || m->n_switches < 0
        || (int64_t)m->n_sampled + m->n_switches != h->n_names
        || !hm_is_consistent(m, f->table_length) || !has_sound_records(f))
        return "an index leads beyond what it points into";
    return NULL;
}

#include "small.h"
