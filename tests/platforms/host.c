/* A host for any platform: the bits of outputs of an unpacked FMU of FMI 2.0 after each step.

       host LIBRARY RESOURCES GUID STEPS H INPUTS REFERENCE...

   RESOURCES is a URI. The first INPUTS references are set, to the number of the step over 1024; the
   rest is read and shown in hexadecimal digits, a line a step. Exit code 1 where a call is
   refused. */
#include "fmi2.h"

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

static void hear(void *environment, fmi2_text name, fmi2_status status, fmi2_text category,
                 fmi2_text message, ...)
{
    (void)environment, (void)name, (void)category;
    fprintf(stderr, "%d %s\n", (int)status, message);
}

static const fmi2_callbacks CALLBACKS = {hear, calloc, free, NULL, NULL};

static void need(int is_well, const char *what)
{
    if (is_well) return;
    fprintf(stderr, "host: %s\n", what);
    exit(1);
}

typedef struct fmu {
#define POINTER(result, name, arguments) result (*name) arguments;
    FMI2_FUNCTIONS(POINTER)
} fmu;

static fmu load(const char *path)
{
    fmu f;
#ifdef _WIN32
    HMODULE library = LoadLibraryA(path);
    need(library != NULL, "the library does not load");
#define FIND(result, name, arguments) \
    { \
        FARPROC found = GetProcAddress(library, #name); \
        need(found != NULL, #name); \
        memcpy(&f.name, &found, sizeof found); \
    }
#else
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    need(library != NULL, "the library does not load");
#define FIND(result, name, arguments) \
    { \
        void *found = dlsym(library, #name); \
        need(found != NULL, #name); \
        memcpy(&f.name, &found, sizeof found); \
    }
#endif
    FMI2_FUNCTIONS(FIND)
    return f;
}

int main(int count, char **argument)
{
    enum { FIRST = 7, MOST = 512 };
    need(count > FIRST && count - FIRST <= MOST, "usage: see the head of host.c");
    const fmu f = load(argument[1]);
    const int steps = atoi(argument[4]), n_inputs = atoi(argument[6]), n = count - FIRST - n_inputs;
    const double h = atof(argument[5]);
    fmi2_reference reference[MOST];
    double value[MOST];
    for (int k = FIRST; k < count; k++) reference[k - FIRST] = (fmi2_reference)atoi(argument[k]);
    fmi2_component c =
        f.fmi2Instantiate("host", FMI2_CO_SIMULATION, argument[3], argument[2], &CALLBACKS, 0, 0);
    need(c != NULL, "no instance");
    need(!f.fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0), "setupExperiment");
    need(!f.fmi2EnterInitializationMode(c) && !f.fmi2ExitInitializationMode(c), "initialization");
    for (int step = 0; step < steps; step++) {
        for (int k = 0; k < n_inputs; k++) value[k] = step / 1024.0;
        need(!f.fmi2SetReal(c, reference, (size_t)n_inputs, value), "setReal");
        need(!f.fmi2DoStep(c, step * h, h, 1), "doStep");
        need(!f.fmi2GetReal(c, reference + n_inputs, (size_t)n, value), "getReal");
        for (int k = 0; k < n; k++) {
            uint64_t bits;
            memcpy(&bits, value + k, sizeof bits);
            printf("%016" PRIx64 "%s", bits, k + 1 < n ? " " : "\n");
        }
    }
    need(!f.fmi2Terminate(c), "terminate");
    f.fmi2FreeInstance(c);
    return 0;
}
