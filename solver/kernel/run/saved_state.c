/* States of an instance as bytes: saved, checked, taken back. */
#include "small.h"

#include "instance_parts.h"

#include <string.h>

typedef struct saved_state {
    char magic[8], fingerprint[32];
    int64_t phase, length;
    uint32_t checksum, unused;
} saved_state;

static const char SAVED[8] = "holonom5"; /* the digit is the version of the format */

static uint32_t checksum_of(saved_state head, const void *block)
{
    head.checksum = 0;
    return hm_checksum(hm_checksum(0, &head, sizeof head), block,
                       sizeof(double) * (size_t)head.length);
}

int64_t holonom_saved_size(const holonom_instance *i)
{ return (int64_t)sizeof(saved_state) + 8 * i->state_size; }

void holonom_keep(const holonom_instance *i, void *bytes)
{
    saved_state head;
    memset(&head, 0, sizeof head);
    memcpy(head.magic, SAVED, sizeof SAVED);
    memcpy(head.fingerprint, i->file.header->fingerprint, sizeof head.fingerprint);
    head.phase = i->phase;
    head.length = i->state_size;
    memcpy(bytes, &head, sizeof head);
    memcpy((char *)bytes + sizeof head, i->state, sizeof(double) * (size_t)i->state_size);
}

void holonom_seal(void *bytes)
{
    saved_state head;
    memcpy(&head, bytes, sizeof head);
    head.checksum = checksum_of(head, (const char *)bytes + sizeof head);
    memcpy(bytes, &head, sizeof head);
}

void holonom_save(const holonom_instance *i, void *bytes)
{
    holonom_keep(i, bytes);
    holonom_seal(bytes);
}

static int32_t refuse_state(holonom_instance *i, const char *why)
{
    return hm_answer(i, HOLONOM_REFUSED, "the saved state %s", why);
}

/* Part of its size up to which a row may be off: loosely solved steps left up to 4e-4. */
static const double FARTHEST_OFF = 0.1;

/* Whether a saved block has only numbers that a run can come to; they steer what is not checked
   again. */
static const char *flaw_of_block(holonom_instance *i, const double *block)
{
    const hm_model_file *f = &i->file;
    for (int64_t k = 0; k < i->state_size; k++) {
        const int may_be_infinite = k == S_MEAN_TIME || k == S_MEAN_TIME_BEFORE || k == S_WANTED;
        if (!(fabs(block[k]) < INFINITY) && !(may_be_infinite && block[k] == INFINITY))
            return "has a number that is not finite; save it again";
    }
    const double order = block[S_ORDER_IN_USE];
    if (!(order >= 0.0 && order <= 8.0 && (order == 5.0 || order == 2.0 * floor(0.5 * order))))
        return "has a number that no run comes to; save it again";
    const double *island = block + (i->s.islands - i->s.head);
    for (int32_t k = 0; k < f->model.n_islands; k++) {
        const double level = island[I_SIZE * k + I_PENALTY_LEVEL];
        if (!(level >= 0.0 && level <= MOST_LEVELS && level == floor(level)))
            return "has a penalty that no run comes to; save it again";
        const double bend = island[I_SIZE * k + I_BEND],
                     lean = island[I_SIZE * k + I_LEAN_CONTRACTION];
        const double predicts = island[I_SIZE * k + I_PREDICTS_LAMBDA];
        if (!(bend >= 0.0 && bend <= MOST_LEARNED && lean >= 0.0 && lean <= MOST_LEARNED)
            || (predicts != 0.0 && predicts != 1.0))
            return "has a contraction that no run comes to; save it again";
    }
    for (uint32_t k = 0; k < f->header->n_variables; k++) {
        const hm_variable *v = f->variable + k;
        if (v->kind == KIND_OPTION && hm_objects(&i->message, f, v, block[v->place], NULL, 0))
            return "has a setting that is not allowed; save it again";
    }
    return NULL;
}

/* Refuses the block of a state in motion that deforms a rigid part, as no run does: its steps, none
   of which can be solved, would take thousands of iterations. */
static int32_t refuse_deformed(holonom_instance *i, const void *block)
{
    const holonom_model *m = &i->file.model;
    const int32_t n_rigid = first_function_row(m);
    double *scale = i->numbers + m->row_scale_at, most = FARTHEST_OFF;
    int32_t worst = -1;
    hm_put_all_aside(i);
    memcpy(i->state, block, sizeof(double) * (size_t)i->state_size);
    hm_evaluate(i);
    holonom_rows(i, i->phi, i->rate);
    for (int32_t row = 0; row < n_rigid; row++) {
        const double off = fabs(i->phi[row]) / scale[row];
        if (!(off <= most)) most = off, worst = row;
    }
    hm_take_all_back(i);
    if (worst < 0) return HOLONOM_DONE;
    return hm_answer(i, HOLONOM_REFUSED,
                     "the saved state does not fit %s, by %3g of its size; save it again",
                     text_of(i, i->file.row[worst].name), most);
}

int32_t holonom_check_saved(holonom_instance *i, const void *bytes, int64_t length)
{
    saved_state head;
    const char *block = (const char *)bytes + sizeof head;
    if (length < (int64_t)sizeof head || memcmp(bytes, SAVED, sizeof SAVED))
        return refuse_state(i, "is not one of this format; save it again with this FMU");
    memcpy(&head, bytes, sizeof head);
    if (memcmp(head.fingerprint, i->file.header->fingerprint, sizeof head.fingerprint))
        return refuse_state(i,
                            "belongs to another model or version; restore it where it was saved");
    if (length != holonom_saved_size(i) || head.length != i->state_size)
        return hm_answer(i, HOLONOM_REFUSED,
                         "the saved state is %d bytes long, not what its header says", (int)length);
    if (head.checksum != checksum_of(head, block) || head.phase < HOLONOM_CONFIGURED
        || head.phase > HOLONOM_MOVING)
        return refuse_state(i, "is damaged: its checksum does not fit; save it again");
    memcpy(i->before, block, sizeof(double) * (size_t)i->state_size);
    const char *flaw = flaw_of_block(i, i->before);
    if (flaw) return refuse_state(i, flaw);
    return head.phase == HOLONOM_CONFIGURED ? HOLONOM_DONE : refuse_deformed(i, block);
}

int32_t holonom_return_to(holonom_instance *i, const void *bytes)
{
    saved_state head;
    memcpy(&head, bytes, sizeof head);
    if (memcmp(head.magic, SAVED, sizeof SAVED) || head.length != i->state_size ||
        memcmp(head.fingerprint, i->file.header->fingerprint, sizeof head.fingerprint))
        return refuse_state(i,
                            "belongs to another model or version; restore it where it was saved");
    memcpy(i->state, (const char *)bytes + sizeof head, sizeof(double) * (size_t)i->state_size);
    i->phase = (int32_t)head.phase;
    i->measured = 0;
    /* Numbers are no part of the state: those that depend on parameters, inputs and the time are
       computed again. */
    if (i->phase != HOLONOM_CONFIGURED) hm_evaluate(i);
    return HOLONOM_DONE;
}

int32_t holonom_restore(holonom_instance *i, const void *bytes, int64_t length)
{
    const int32_t result = holonom_check_saved(i, bytes, length);
    return result ? result : holonom_return_to(i, bytes);
}

#include "small.h"
