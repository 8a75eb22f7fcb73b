/* One mechanism in motion: parameters in, steps, values and sentences out. Nothing else moves a
   model: Python and an FMU call these. Values are doubles, words their place in a list. The caller
   lends all memory; no I/O, no globals, no allocation. */
#ifndef HOLONOM_INSTANCE_H
#define HOLONOM_INSTANCE_H

#include "holonom.h"

typedef struct holonom_instance holonom_instance;

enum holonom_phase {
    HOLONOM_CONFIGURED,
    HOLONOM_ASSEMBLED,
    HOLONOM_MOVING
}; /* values may change; start taken; after a step */

/* Bytes of memory for an instance of a model file, after all of it was checked; 0 if it cannot be
   used, and why (room bytes). */
HOLONOM_API int64_t holonom_instance_size(const void *model, int64_t length, char *why,
                                          int64_t room);

/* Makes an instance in `memory` (16-aligned, holonom_instance_size bytes) of a model that this
   function has checked, and that outlives it. `heard`: somebody reads all remarks; otherwise only
   those are made that hold for a whole run. */
HOLONOM_API holonom_instance *holonom_make(const void *model, void *memory, int32_t heard);

/* Returns to the condition after holonom_make. */
HOLONOM_API void holonom_reset(holonom_instance *instance);

/* Sentences of the last call that returned neither HOLONOM_DONE nor HOLONOM_REMARKED, one a line;
   UTF-8. */
HOLONOM_API const char *holonom_message(const holonom_instance *instance);

/* What was noticed and not yet fetched, one sentence a line, each once; overwritten by the next
   call. */
HOLONOM_API const char *holonom_remarks(holonom_instance *instance);

/* Lets indices of variables begin with `first`, not with 0; and the variable of an index, or
   NULL. */
void holonom_count_from(holonom_instance *instance, int32_t first);
const struct hm_variable *holonom_variable_at(const holonom_instance *instance, int32_t index);

/* Values of variables by their index. One that is not finite is refused (HOLONOM_UNTRIED), the
   mechanism is assembled first where an output is asked for. */
HOLONOM_API int32_t holonom_get(holonom_instance *instance, const int32_t *index, int32_t count,
                                double *value);

/* Rates of outputs by their index, in 1/s, along the motion that follows if inputs are held or move
   on as they did: those of positions, angles and lengths are the measured velocities. Nothing is
   changed. */
int32_t holonom_get_rates(holonom_instance *instance, const int32_t *index, int32_t count,
                          double *value);

/* Sets parameters, inputs and settings: all or none. `shown`, if given, has for each value how a
   sentence shows it, or NULL. */
HOLONOM_API int32_t holonom_set(holonom_instance *instance, const int32_t *index, int32_t count,
                                const double *value, const char *const *shown);

/* Word number `value` of a variable that has words, and the number of a word; NULL or NaN if there
   is none. */
HOLONOM_API const char *holonom_word(const holonom_instance *instance, int32_t index, double value);
HOLONOM_API double holonom_number_of_word(const holonom_instance *instance, int32_t index,
                                          const char *word);

/* Assembles the mechanism with the present parameters at the present time (its state's S_TIME). */
HOLONOM_API int32_t holonom_assemble(holonom_instance *instance);

/* What steps the settings choose, in words; `has_explicit`: 0 where a run has shown that none is
   explicit. Until the next call. */
HOLONOM_API const char *holonom_steps(holonom_instance *instance, int32_t has_explicit);

/* Ends the start: what is set from now on is for the step to come, as after a step. */
HOLONOM_API void holonom_begin(holonom_instance *instance);

/* Lets starts and steps ask now and then whether to go on: `look` returns 1 for their end
   (HOLONOM_STOPPED); NULL: they do not ask. */
HOLONOM_API void holonom_let_look(holonom_instance *instance, int32_t (*look)(void));

/* Lets steps be recorded in `mesh`, or repeated from it; NULL: neither. It outlives the instance,
   or the next call. */
HOLONOM_API void holonom_use_mesh(holonom_instance *instance, holonom_mesh *mesh);

/* Advances from time t, which must be the present time, by `step`, both in s. */
HOLONOM_API int32_t holonom_move(holonom_instance *instance, double t, double step);

/* The whole state as bytes: motion, multipliers, ledger, inputs, parameters, settings and phase,
   under one checksum. */
HOLONOM_API int64_t holonom_saved_size(const holonom_instance *instance);
HOLONOM_API void holonom_save(const holonom_instance *instance, void *bytes);
HOLONOM_API int32_t holonom_restore(holonom_instance *instance, const void *bytes, int64_t length);

/* The same in three parts, for states that stay in memory: kept without a checksum and returned to
   without a look at the numbers; sealed, they are as saved; checked, they may be returned to. Bytes
   of holonom_saved_size each. */
void holonom_keep(const holonom_instance *instance, void *bytes);
void holonom_seal(void *bytes);
int32_t holonom_check_saved(holonom_instance *instance, const void *bytes, int64_t length);
int32_t holonom_return_to(holonom_instance *instance, const void *bytes);

/* Residuals of the rows and their rates at the present state (n_rows each), each in the unit of its
   row. */
HOLONOM_API void holonom_rows(holonom_instance *instance, double *phi, double *rate);

HOLONOM_API int32_t holonom_phase_of(const holonom_instance *instance);

/* What an instance is made of. */
const struct hm_model_file *holonom_file_of(const holonom_instance *instance);

/* The memory of an instance: what the functions of holonom.h take. */
HOLONOM_API const holonom_model *holonom_model_of(const holonom_instance *instance);
HOLONOM_API double *holonom_numbers_of(holonom_instance *instance);
HOLONOM_API double *holonom_state_of(holonom_instance *instance);
HOLONOM_API double *holonom_work_of(holonom_instance *instance);

#endif
