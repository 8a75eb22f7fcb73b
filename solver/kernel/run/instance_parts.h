/* What the files of an instance share, and no other. */
#ifndef HOLONOM_INSTANCE_PARTS_H
#define HOLONOM_INSTANCE_PARTS_H

#include "instance.h"
#include "sentences.h"

struct holonom_instance {
    hm_model_file file;
    hm_state s;
    double *numbers, *state, *work;
    double *before;              /* state and numbers, while a change of inputs is tried */
    double *inputs, *parameters; /* those to come */
    double *phi, *rate;          /* n_rows each */
    char at_fault[2 * NAME_ROOM];
    char *clipped;               /* of each variable: whether it was said that it is clipped */
    hm_text message, remarks;
    int64_t state_size;
    int32_t phase, measured, heard, has_rules_of_laws, said, has_remarks;
    int32_t first;               /* number of the first variable */
    int32_t group_end[HOLONOM_GROUPS];
    holonom_watch watch;
    holonom_mesh *mesh;
};

static inline const char *text_of(const holonom_instance *i, uint32_t at)
{ return i->file.text + at; }

/* Puts state and numbers aside, and takes them back. */
void hm_put_all_aside(const holonom_instance *i);
void hm_take_all_back(const holonom_instance *i);

/* All numbers that depend on parameters, inputs and the time. */
void hm_evaluate(holonom_instance *i);

/* Makes a sentence the message, and returns the result. */
int32_t hm_answer(holonom_instance *i, int32_t result, const char *format, ...);

/* Result of what was done: whether there are remarks. */
int32_t hm_done(const holonom_instance *i);

/* Remarks not yet fetched, to which others may be added, each in a line that begins so. */
hm_text *hm_open_remarks(holonom_instance *i);
void hm_begin_line(hm_text *text);

#endif
