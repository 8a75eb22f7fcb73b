/* The bytes of a model, little-endian and 8-aligned, used where they lie: solver/runtime/model_writing.py writes them.

   header | int32: sizes, offsets, lengths of the tables, tables, 0 to an even count | doubles: settings (the head of a state),
   numbers | variables | rules | rows | uint32: names of the sampled loads, 0 to an even count | texts, each ends with 0, filled to
   8 bytes | JSON that only Python reads. Texts are given by their offset. */
#ifndef HOLONOM_MODEL_FILE_H
#define HOLONOM_MODEL_FILE_H

#include "holonom.h"

#include <stddef.h>

enum { MODEL_FILE_VERSION = 5 };

typedef struct hm_header {
    char magic[8];                                                   /* "HOLONOM" and 0                              */
    uint32_t checksum;                                               /* CRC-32 of all that follows                   */
    uint32_t version, abi, n_sizes, n_offsets, n_tables, n_head;     /* of which program                             */
    uint32_t n_ints, n_numbers, n_variables, n_rules, n_rows, n_sampled, n_text; /* lengths; of texts in bytes        */
    char guid[40];                                                   /* of the FMU that carries it                   */
    char fingerprint[32];                                            /* hash of all that a run depends on            */
    uint64_t length;                                                 /* of the file in bytes                         */
} hm_header;

enum hm_type { REAL, BOOLEAN, STRING };
enum hm_causality { PARAMETER, INPUT, OUTPUT, CALCULATED_PARAMETER };
enum hm_variability { FIXED, TUNABLE, CONTINUOUS };
enum hm_kind { A_PARAMETER, AN_INPUT, A_NUMBER, A_MEASUREMENT, AN_OPTION };
enum hm_variable_flag { HAS_MINIMUM = 1, HAS_MAXIMUM = 2, HAS_START = 4, CLIPS = 8, WHOLE = 16, ORDER = 32 };

typedef struct hm_variable {
    uint32_t name, unit;
    uint8_t type, causality, variability, kind;
    int32_t place;         /* among the parameters, inputs, numbers, measurements or in the head                    */
    double start, minimum, maximum;
    double least;          /* of an option: smallest value other than 0                                             */
    uint32_t flags, words; /* of a String option: one behind the other, then an empty one                              */
} hm_variable;

enum hm_relation { IS_FINITE, IS_ABOVE, IS_AT_LEAST, OF_A_LAW = 256 };

typedef struct hm_rule {
    int32_t number, relation; /* OF_A_LAW: inputs and tunable parameters may break it in motion                     */
    double bound;
    uint32_t name, message;   /* with {value!r}                                                                     */
} hm_rule;

enum hm_row_kind { ROW_LENGTH, ROW_APART, ROW_OFF, ROW_HEIGHT, ROW_TURNED, ROW_ANGLE, ROW_AXES, ROW_VALUE, ROW_DRIVER, ROW_VELOCITY, ROW_KINDS };

typedef struct hm_row {
    uint32_t name, detail, kind, unused;
} hm_row;

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

uint32_t hm_checksum(uint32_t before, const void *bytes, size_t count);

#endif
