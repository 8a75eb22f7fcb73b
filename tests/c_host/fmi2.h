/* FMI 2.0 as the hosts here speak of it: short names, and an FMU's library with its functions. */
#ifndef HOST_FMI2_H
#define HOST_FMI2_H

#include "../../fmu_src/native/fmi2.h"

typedef fmi2_component component;
typedef fmi2_reference reference;
typedef fmi2_boolean boolean;
typedef fmi2_text text;
typedef fmi2_saved saved;
typedef fmi2_byte byte;

struct fmu {
    void *library;
    text resources;                 /* URI of the folder */
    char guid[64];
#define FMI2_POINTER(result, name, arguments) result (*name) arguments;
    FMI2_FUNCTIONS(FMI2_POINTER)
#undef FMI2_POINTER
};

#endif
