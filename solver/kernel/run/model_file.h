/* The bytes of a model, little-endian and 8-aligned, used where they lie:
   solver/runtime/model_writing.py writes them, and solver/runtime/layout.py declares the records.

   header | int32: sizes, offsets, lengths of the tables, tables, 0 to an even count | doubles:
   settings (the head of a state), numbers | variables | rules | rows | uint32: names of the sampled
   loads and switches, 0 to an even count | texts, each ends with 0, filled to 8 bytes | JSON that
   only Python reads. Texts are given by their offset. */
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
    const uint32_t *sampled, *switches;
    const char *text;
} hm_model_file;

/* Binds `length` bytes, 8-aligned, and checks the checksum, every length and every index. Returns
   NULL, or what is wrong. */
const char *hm_bind(const void *bytes, int64_t length, hm_model_file *file);

/* Binds bytes that hm_bind has checked before; 0 if they are none. */
int hm_view(const void *bytes, hm_model_file *file);

/* Whether all indices of a model lie within what they point into, and all lists are as long as
   their readers think. */
int hm_is_consistent(const holonom_model *model, const int32_t *table_length);

/* What check_tables.h asks. Whether a table has `count` integers from `low` to below `end`; whether
   one more than `count` rise from 0 to `total`, by at most `most` each; whether a section lies
   within the numbers; whether islands divide all parts. */
int hm_has(const int32_t *table, int64_t length, int64_t count, int64_t low, int64_t end);
int hm_rises(const int32_t *table, int64_t length, int64_t count, int64_t total, int64_t most);
int hm_holds(const holonom_model *model, int32_t at, int64_t length);
int hm_divides(const holonom_model *model, const int64_t (*bound)[2]);

uint32_t hm_checksum(uint32_t before, const void *bytes, size_t count);

#endif
