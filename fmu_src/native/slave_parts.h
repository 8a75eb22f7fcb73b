/* What the files of a slave share, and no other. */
#ifndef HOLONOM_SLAVE_PARTS_H
#define HOLONOM_SLAVE_PARTS_H

#include "chosen_steps.h"
#include "slave.h"

/* FAILED: after a step that could not be. */
enum { INSTANTIATED, INITIALIZING, STEPPING, TERMINATED, FAILED };
#define RESET_FIRST "reset the instance first"

#define ALLOWED(call, name, states, early) call,
typedef enum {
#include "allowed_calls.def"
} slave_call;
#undef ALLOWED

/* Whether the present state allows a call, which is refused with a sentence by the second if it
   does not. */
int slave_allows(const slave *s, slave_call call);
slave_answer slave_check(slave *s, slave_call call);

/* Codes of log lines; fmu_src/status.py has them all. */
enum { ASSEMBLY_FAILED = 101, STEP_REFUSED = 103, NOT_FINITE = 107 };
/* Of a text, in bytes; rows that it can have a sentence of. */
enum { ROOM = 4096, ROOM_OF_ROW = 512, ROWS_SAID = 500 };

/* Room of a slave's text for a mechanism with so many rows and rules. */
#define slave_text_room(rows) (ROOM + ROOM_OF_ROW * ((rows) < ROWS_SAID ? (rows) : ROWS_SAID))

/* Memory of slaves, set to 0, and saved states; NULL if there is none. */
void *slave_allocate(size_t size);
void slave_release(void *memory);

/* Scalars of the state, by S_TIME and the others. */
double *slave_head(const slave *s);

/* Tells the log what s->text has, and returns the level. */
slave_answer slave_tell_text(slave *s, slave_answer level);

/* Appends the sentences of the core's last refusal, in one line, or tells them. */
void slave_say_message(slave *s);
slave_answer slave_tell_message(slave *s, slave_answer level);

/* Tells what the core has noticed; returns whether it has refused nothing. */
int slave_hears(slave *s, int32_t result);

int slave_is_utf8(const char *text);

/* Assembles the mechanism at the start time. */
slave_answer slave_assemble(slave *s);

#endif
