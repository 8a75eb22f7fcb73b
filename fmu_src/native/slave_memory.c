/* Where instances and saved states lie: in memory of malloc, or in a program without that, in
   blocks of its own. */
#include "small.h"

#include "slave_parts.h"

#include <string.h>

#ifdef HOLONOM_BLOCKS
/* So many, one for each instance and each state; no two threads may make or free them at once. */

enum {
    BLOCK_WORDS =
        (sizeof(slave) + slave_text_room(HOLONOM_TEXT_ROWS) + 16 + HOLONOM_INSTANCE_BYTES + 7)
    / 8
};
static uint64_t blocks[HOLONOM_BLOCKS][BLOCK_WORDS];
static char is_taken[HOLONOM_BLOCKS];

void *slave_allocate(size_t size)
{
    for (size_t k = 0; k < HOLONOM_BLOCKS && size <= sizeof *blocks; k++)
        if (!is_taken[k]) {
            is_taken[k] = 1;
            return memset(blocks[k], 0, sizeof *blocks);
        }
    return NULL;
}

void slave_release(void *memory)
{
    for (size_t k = 0; k < HOLONOM_BLOCKS; k++) is_taken[k] &= memory != (void *)blocks[k];
}

#else

#include <stdlib.h>

void *slave_allocate(size_t size) { return calloc(1, size); }
void slave_release(void *memory) { free(memory); }

#endif

#include "small.h"
