/* The bytes of a model, little-endian and 8-aligned, used where they lie: solver/runtime/model_writing.py writes them,
   and solver/runtime/layout.py declares the records.

   header | int32: sizes, offsets, lengths of the tables, tables, 0 to an even count | doubles: settings (the head of a state),
   numbers | variables | rules | rows | uint32: names of the sampled loads, 0 to an even count | texts, each ends with 0, filled to
   8 bytes | JSON that only Python reads. Texts are given by their offset. */
#ifndef HOLONOM_MODEL_FILE_H
#define HOLONOM_MODEL_FILE_H

#include "holonom.h"

#include <stddef.h>

typedef struct hm_model_file {
    const hm_header *header;
    holonom_model model;
    const int32_t *table_length;
    const double *settings, *numbers;
    const hm_variable *variable;
    const hm_rule *rule;
    const hm_row *row;
    const uint32_t *sampled;
    const char *text;
} hm_model_file;

/* Binds `length` bytes, 8-aligned, and checks the checksum, every length and every index. Returns NULL, or what is wrong. */
const char *hm_bind(const void *bytes, int64_t length, hm_model_file *file);

/* Whether all indices of a model lie within what they point into, and all lists are as long as their readers think. */
int hm_is_consistent(const holonom_model *model, const int32_t *table_length);

/* Length of a section or a table: a whole number times two counts. */
typedef struct section_length {
    uint8_t times, of, and_of;
} section_length;

/* Rules of a table. Its length, if `times` is not 0; items of `width` integers; if `is_within`, all from `low` to below
   `below` + a count. If `is_pointers`, one place more than the length, which rise from 0 to the count `total` of items of
   `width`, by at most the count `most` each. */
typedef struct table_rule {
    section_length length;
    uint8_t width, is_within, end, is_pointers, total, most;
    int8_t low, below;
} table_rule;

uint32_t hm_checksum(uint32_t before, const void *bytes, size_t count);

#endif
