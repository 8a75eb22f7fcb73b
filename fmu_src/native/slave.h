/* An instance of an FMU: an instance of the core with the states of the standard, a log, and saved
   states. fmi2.c and fmi3.c give it the functions of the two versions.

   What is refused changes nothing and is answered at once; a step that fails leaves all as it
   was. */
#ifndef HOLONOM_SLAVE_H
#define HOLONOM_SLAVE_H

#include "instance.h"
#include "model_file.h"
#include "text.h"

#include <stddef.h>

/* As fmi2Status and fmi3Status begin. */
typedef enum { ANSWER_OK, ANSWER_WARNING, ANSWER_DISCARD, ANSWER_ERROR } slave_answer;

typedef struct slave slave;

/* Hands one sentence to the importer; `environment` is its own. */
typedef void (*slave_say_line)(const slave *slave, slave_answer level, const char *sentence);

typedef struct slave_log {
    void *logger, *environment; /* the importer's function, NULL for none, and what it wants back */
    slave_say_line say_line;
    int32_t wanted;             /* bit k: level k */
    int32_t is_format;          /* whether a sentence is read as a format of printf */
} slave_log;

enum {
    QUIET = 1 << ANSWER_DISCARD | 1 << ANSWER_ERROR,
    DEBUGGING = QUIET | 1 << ANSWER_OK | 1 << ANSWER_WARNING
};

enum { N_CATEGORIES = 4 };
/* By level, then that of all. */
static const char *const slave_categories[N_CATEGORIES] = {"logAll", "logStatusWarning",
                                                           "logStatusDiscard", "logStatusError"};

/* What a slave knows besides its instance. */
typedef struct slave_memory {
    int32_t phase, is_assembled; /* see slave_parts.h; with the present parameters */
    int32_t status, refusal; /* of the last step, 0 where the core knows it; code that an importer
                                reads in its place, or 0 */
    double start_time;           /* s */
} slave_memory;

/* The first two lie where fmu_src/slave.py, which is called where no call can be refused, reads and
   writes them. */
struct slave {
    slave_memory memory;
    int32_t (*look)(
        void); /* asked within starts and steps, returns 1 for their end; NULL for none */
    holonom_instance *instance;
    const hm_model_file *file;
    const void *model; /* bytes that the slave owns, NULL if they are the program's */
    slave_log log;
    int32_t first, status_index; /* value references of the first variable, and of solver.status */
    double stop_time, last_digit,
        own_horizon; /* no communication step ends after it, and its last digit; of the model [s] */
    double failed_at, shortest, longest;
    int32_t n_failures;         /* in a row from the time failed_at, and the lengths tried [s] */
    hm_text text;
    char name[128];
};

/* Makes a slave of FMI 2 or 3 of the model in a folder of resources, in FMI 2 a URI, in FMI 3 a
   path; NULL where it cannot, for a reason that the log has. */
slave *slave_make(const char *name, const char *guid, const char *resources, int32_t fmi,
                  slave_log log);
void slave_free(slave *s);
slave_answer slave_reset(slave *s);

/* Tells the log a sentence, and returns its level. */
slave_answer slave_tell(slave *s, slave_answer level, const char *format, ...);

/* Switches levels of the log on or off by their categories, all of them if there is none. */
slave_answer slave_switch_log(slave *s, int32_t on, size_t count, const char *const *category);

/* The course of a run. Times in s; stop time and tolerance are NULL where they are not given. */
slave_answer slave_set_up(slave *s, double start, const double *stop, const double *tolerance);
slave_answer slave_begin_initialization(slave *s);
slave_answer slave_end_initialization(slave *s);
slave_answer slave_step(slave *s, double t, double step);
slave_answer slave_terminate(slave *s);
double slave_last_time(const slave *s);

/* Values of variables of one type (TYPE_REAL, ...) by their value references, from 0 in FMI 2 and
   from 1 in FMI 3, words as their places in a list. What cannot be read is 0 and an error; the
   others are read all the same. `shown`: how a sentence shows each value, or NULL. */
slave_answer slave_get(slave *s, int32_t type, const uint32_t *index, size_t count, double *value);
slave_answer slave_set(slave *s, int32_t type, const uint32_t *index, size_t count,
                       const double *value, const char *const *shown);

/* Derivatives of Real outputs, all of order 1. */
slave_answer slave_get_derivatives(slave *s, const uint32_t *index, size_t count,
                                   const int32_t *order, double *value);

/* Values of Strings, and of one Boolean. */
slave_answer slave_get_words(slave *s, const uint32_t *index, size_t count, const char **word);
slave_answer slave_get_truth(slave *s, uint32_t index, int32_t *truth);

/* Sets Strings, and Booleans as 0 or 1: all of at most MOST_WORDS, or none. */
enum { MOST_WORDS = 64 };
slave_answer slave_set_words(slave *s, const uint32_t *index, size_t count,
                             const char *const *word);
slave_answer slave_set_truths(slave *s, const uint32_t *index, size_t count, const double *truth);

/* States: kept in memory, as bytes with a checksum, and taken back. */
typedef struct slave_kept slave_kept;
slave_answer slave_keep(slave *s, slave_kept **kept);
slave_answer slave_return_to(slave *s, const slave_kept *kept);
slave_answer slave_free_kept(slave_kept **kept);
slave_answer slave_size_of_bytes(slave *s, const slave_kept *kept, size_t *size);
slave_answer slave_bytes_of(slave *s, const slave_kept *kept, void *bytes, size_t size);
slave_answer slave_kept_of(slave *s, const void *bytes, size_t size, slave_kept **kept);

#endif
