/* States of a slave: kept in memory, as bytes with checksums, and returned to. */
#include "small.h"

#include "slave_parts.h"

#include "fp_environment.h"

#include <math.h>
#include <string.h>

/* A state in memory, and as bytes: this, then what the core saves. */
struct slave_kept {
    char magic[8];
    uint32_t checksum, unused; /* of what follows it in this structure; 0 in memory */
    uint64_t size;             /* of all */
    slave_memory memory;
};

static const char KEPT[8] = "holslv1"; /* the digit is the version of the format */
#define NO_PLACE "there is no place for the state"
#define OF_ANOTHER                                                                                 \
    "the saved state belongs to another model or version; restore it where it was saved"

static uint32_t checksum_of_kept(const slave_kept *kept)
{
    const size_t begin = offsetof(slave_kept, unused);
    return hm_checksum(0, (const char *)kept + begin, sizeof *kept - begin);
}

static size_t size_of(const slave *s)
{ return sizeof(slave_kept) + (size_t)holonom_saved_size(s->instance); }

slave_answer slave_size_of_bytes(slave *s, const slave_kept *kept, size_t *size)
{
    if (!kept || !size)
        return slave_tell(s, ANSWER_ERROR, "there is no state, or no place for its size");
    *size = (size_t)kept->size;
    return ANSWER_OK;
}

slave_answer slave_keep(slave *s, slave_kept **kept)
{
    const size_t size = size_of(s);
    if (!kept) return slave_tell(s, ANSWER_ERROR, NO_PLACE);
    if (*kept && (*kept)->size != size)
        return slave_tell(s, ANSWER_ERROR, "the state to be overwritten is one of another FMU");
    if (!*kept && !(*kept = slave_allocate(size)))
        return slave_tell(s, ANSWER_ERROR, "there is no memory for a state of %d bytes", (int)size);
    memset(*kept, 0, sizeof **kept);
    memcpy((*kept)->magic, KEPT, sizeof KEPT);
    (*kept)->size = size;
    (*kept)->memory = s->memory;
    holonom_keep(s->instance, *kept + 1);
    return ANSWER_OK;
}

slave_answer slave_return_to(slave *s, const slave_kept *kept)
{
    const fp_environment host = fp_enter();
    const int is_own = kept && kept->size == size_of(s)
                       && slave_hears(s, holonom_return_to(s->instance, kept + 1));
    if (is_own) s->memory = kept->memory;
    fp_leave(host);
    return is_own ? ANSWER_OK : slave_tell(s, ANSWER_ERROR, OF_ANOTHER);
}

slave_answer slave_free_kept(slave_kept **kept)
{
    if (kept) {
        slave_release(*kept);
        *kept = NULL;
    }
    return ANSWER_OK;
}

slave_answer slave_bytes_of(slave *s, const slave_kept *kept, void *bytes, size_t size)
{
    if (!kept || !bytes || size < kept->size)
        return slave_tell(s, ANSWER_ERROR, "a state needs %d bytes, %d are given",
                          kept ? (int)kept->size : 0, (int)size);
    slave_kept *copy = bytes;
    slave_kept head = *kept;
    head.checksum = checksum_of_kept(&head);
    memcpy(copy, kept, (size_t)kept->size);
    memcpy(copy, &head, sizeof head);
    holonom_seal((char *)bytes + sizeof head);
    return ANSWER_OK;
}

slave_answer slave_kept_of(slave *s, const void *bytes, size_t size, slave_kept **kept)
{
    slave_kept head;
    if (!kept) return slave_tell(s, ANSWER_ERROR, NO_PLACE);
    *kept = NULL;
    if (!bytes || size < sizeof head || memcmp(bytes, KEPT, sizeof KEPT))
        return slave_tell(
            s, ANSWER_ERROR,
            "the bytes are no FMU state of this version; save the state again with this FMU");
    memcpy(&head, bytes, sizeof head);
    const int is_damaged = head.checksum != checksum_of_kept(&head) || head.size != size
                           || head.memory.phase < INSTANTIATED || head.memory.phase > FAILED
                           || !(fabs(head.memory.start_time) < INFINITY);
    if (is_damaged)
        return slave_tell(s, ANSWER_ERROR,
                          "the bytes of the FMU state are damaged; save the state again");
    if (size != size_of(s)) return slave_tell(s, ANSWER_ERROR, OF_ANOTHER);
    const fp_environment host = fp_enter();
    const int is_good =
        slave_hears(s, holonom_check_saved(s->instance, (const char *)bytes + sizeof head,
                                           (int64_t)(size - sizeof head)));
    fp_leave(host);
    if (!is_good) return slave_tell_message(s, ANSWER_ERROR);
    if (!(*kept = slave_allocate(size)))
        return slave_tell(s, ANSWER_ERROR, "there is no memory for a state of %d bytes", (int)size);
    memcpy(*kept, bytes, size);
    return ANSWER_OK;
}

#include "small.h"
