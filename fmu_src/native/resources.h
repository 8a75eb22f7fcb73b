/* The model that an FMU carries: a file among its resources, or a table compiled in. */
#ifndef HOLONOM_RESOURCES_H
#define HOLONOM_RESOURCES_H

#include "text.h"

#include <stdint.h>

typedef struct hm_bytes {
    const void *begin; /* 8-aligned */
    int64_t length;
    int32_t is_owned;  /* to be freed by who asked for it */
} hm_bytes;

/* Bytes of model.bin in a folder, a file URI or a path in UTF-8; begin is NULL where they cannot be
   read, and `why` says why. */
hm_bytes hm_model_bytes(const char *folder, int32_t is_uri, hm_text *why);

#endif
