/* How long a host in C takes for calls of a native FMU, beside the core's own step of the same
   model (benchmarks/sections/native.py):

       native_calls LIBRARY RESOURCES GUID KERNEL STEP COUNT REPETITIONS WHAT REFERENCE...

   RESOURCES is a folder, KERNEL a library of the core with the same sources and flags, STEP in s,
   COUNT of communication steps. WHAT has a letter for each thing that is done, and a line "letter
   seconds" is written for each: the least CPU time of the repetitions, of COUNT calls or 20
   runs. */
#define _POSIX_C_SOURCE 200809L

#include "fmi2.h"
#include "instance.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define FUNCTIONS(X)                                                                               \
    X(fmu, fmi2_component, fmi2Instantiate,                                                        \
      (fmi2_text, int, fmi2_text, fmi2_text, const fmi2_callbacks *, fmi2_boolean, fmi2_boolean))  \
    X(fmu, void, fmi2FreeInstance, (fmi2_component))                                               \
    X(fmu, fmi2_status, fmi2SetupExperiment,                                                       \
      (fmi2_component, fmi2_boolean, double, double, fmi2_boolean, double))                        \
    X(fmu, fmi2_status, fmi2EnterInitializationMode, (fmi2_component))                             \
    X(fmu, fmi2_status, fmi2ExitInitializationMode, (fmi2_component))                              \
    X(fmu, fmi2_status, fmi2Reset, (fmi2_component))                                               \
    X(fmu, fmi2_status, fmi2DoStep, (fmi2_component, double, double, fmi2_boolean))                \
    X(fmu, fmi2_status, fmi2GetReal, (fmi2_component, const fmi2_reference *, size_t, double *))   \
    X(fmu, fmi2_status, fmi2GetFMUstate, (fmi2_component, fmi2_saved *))                           \
    X(fmu, fmi2_status, fmi2SetFMUstate, (fmi2_component, fmi2_saved))                             \
    X(core, int64_t, holonom_instance_size, (const void *, int64_t, char *, int64_t))              \
    X(core, holonom_instance *, holonom_make, (const void *, void *, int32_t))                     \
    X(core, int32_t, holonom_assemble, (holonom_instance *))                                       \
    X(core, int32_t, holonom_get, (holonom_instance *, const int32_t *, int32_t, double *))        \
    X(core, const holonom_model *, holonom_model_of, (const holonom_instance *))                   \
    X(core, double *, holonom_numbers_of, (holonom_instance *))                                    \
    X(core, double *, holonom_state_of, (holonom_instance *))                                      \
    X(core, double *, holonom_work_of, (holonom_instance *))                                       \
    X(core, int64_t, holonom_state_size, (const holonom_model *))                                  \
    X(core, int32_t, holonom_advance,                                                              \
      (const holonom_model *, double *, double *, double *, double, holonom_watch *,               \
       holonom_mesh *))
#define DECLARE(library, result, name, arguments) static result(*call_##name) arguments;
FUNCTIONS(DECLARE)

static void *found(void *library, const char *name)
{
    void *function = dlsym(library, name);
    if (!function) fprintf(stderr, "%s\n", dlerror()), exit(1);
    return function;
}

static void require(int holds, const char *what)
{
    if (!holds) fprintf(stderr, "native_calls: %s\n", what), exit(1);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void hear(void *environment, fmi2_text instance, fmi2_status status, fmi2_text category,
                 fmi2_text message, ...)
{
    (void)environment, (void)instance, (void)status, (void)category;
    fprintf(stderr, "%s\n", message);
}

static char *contents(const char *folder, const char *name, int64_t *length)
{
    char path[4096], *bytes;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    require(file != NULL, path);
    fseek(file, 0, SEEK_END);
    *length = ftell(file);
    rewind(file);
    bytes = malloc((size_t)*length);
    require(bytes && fread(bytes, 1, (size_t)*length, file) == (size_t)*length, path);
    fclose(file);
    return bytes;
}

/* ------------------------------------------------------------------- what is timed, COUNT times */

static const fmi2_callbacks callbacks = {.logger = hear};
static const char *guid, *uri;
static fmi2_component fmu;
static fmi2_saved kept, copy; /* after the first communication step; what a copy is made into */
static const holonom_model *model;
static double *numbers, *state, *work, *state_kept;
static size_t state_bytes;
static double h;
static int count, n_references;
static fmi2_reference *reference;
static double *value;

static fmi2_component made(void)
{ return call_fmi2Instantiate("timed", FMI2_CO_SIMULATION, guid, uri, &callbacks, 0, 0); }

static void start(void)
{
    call_fmi2SetupExperiment(fmu, 0, 0.0, 0.0, 0, 0.0);
    call_fmi2EnterInitializationMode(fmu);
    require(!call_fmi2ExitInitializationMode(fmu), "the initialization fails");
}

static void go_back(void) { call_fmi2SetFMUstate(fmu, kept); }

static void steps(void)
{
    for (int k = 1; k <= count; k++)
        require(!call_fmi2DoStep(fmu, k * h, h, 1), "fmi2DoStep fails");
}

static void core_goes_back(void) { memcpy(state, state_kept, state_bytes); }

static void core_step(double t)
{
    require(!call_holonom_advance(model, numbers, state, work, (t - state[S_TIME]) + h, NULL, NULL),
            "holonom_advance fails");
    state[S_TIME] = t + h;
}

static void core_steps(void)
{
    for (int k = 1; k <= count; k++) core_step(k * h);
}

static void reads(void)
{
    for (int k = 0; k < count; k++) call_fmi2GetReal(fmu, reference, (size_t)n_references, value);
}

static void copies(void)
{
    for (int k = 0; k < count; k++) call_fmi2GetFMUstate(fmu, &copy);
}

static void instances(void)
{
    for (int k = 0; k < count; k++) call_fmi2FreeInstance(made());
}

/* Runs from the start, with outputs after each step. */
static void run(void)
{
    call_fmi2Reset(fmu);
    start();
    call_fmi2GetReal(fmu, reference, (size_t)n_references, value);
    for (int k = 0; k < count; k++) {
        require(!call_fmi2DoStep(fmu, k * h, h, 1), "fmi2DoStep fails");
        call_fmi2GetReal(fmu, reference, (size_t)n_references, value);
    }
}

static void runs(void)
{
    for (int k = 0; k < 20; k++) run();
}

static void nothing(void) {}

static const struct { char letter; void (*prepare)(void), (*repeat)(void);
} timed[] = {
    {'d', go_back, steps},  {'a', core_goes_back, core_steps}, {'g', go_back, reads},
    {'s', nothing, copies}, {'i', nothing, instances},         {'r', nothing, runs},
};
enum { N_TIMED = sizeof timed / sizeof *timed };

/* Both come to the same bits, or their times are not those of the same. Once: the core does not
   know that its state moved on. */
static void compare(holonom_instance *core)
{
    double *other = calloc((size_t)n_references + 1, sizeof *other);
    require(other != NULL, "no memory");
    call_fmi2GetReal(fmu, reference, (size_t)n_references, value);
    require(!call_holonom_get(core, (const int32_t *)reference, n_references, other),
            "holonom_get fails");
    require(!memcmp(other, value, sizeof *other * (size_t)n_references),
            "the FMU and the core differ");
    free(other);
}

int main(int n_arguments, char **argument)
{
    require(n_arguments > 8, "arguments are missing");
    void *const library = dlopen(argument[1], RTLD_NOW | RTLD_LOCAL), *const kernel = dlopen(
                                                                          argument[4],
                                                                          RTLD_NOW | RTLD_LOCAL);
    require(library && kernel, "a library does not load");
#define FIND(from, result, name, arguments) *(void **)&call_##name = found(of_##from, #name);
    void *const of_fmu = library, *const of_core = kernel;
    FUNCTIONS(FIND)

    char why[512], address[4200];
    int64_t length;
    const char *const bytes = contents(argument[2], "model.bin", &length);
    snprintf(address, sizeof address, "file://%s", argument[2]);
    uri = address, guid = argument[3], h = atof(argument[5]), count = atoi(argument[6]);
    n_references = n_arguments - 9;
    reference = calloc((size_t)n_references + 1, sizeof *reference);
    value = calloc((size_t)n_references + 1, sizeof *value);
    for (int k = 0; k < n_references; k++) reference[k] = (fmi2_reference)atoi(argument[9 + k]);

    fmu = made();
    require(fmu != NULL, "no instance");
    start();
    call_fmi2DoStep(fmu, 0.0, h, 1);
    call_fmi2GetFMUstate(fmu, &kept);
    call_fmi2GetFMUstate(fmu, &copy);
    const int64_t size = call_holonom_instance_size(bytes, length, why, sizeof why);
    require(size > 0, why);
    holonom_instance *const core = call_holonom_make(bytes, malloc((size_t)size), 0);
    require(core && !call_holonom_assemble(core), "the core does not assemble");
    model = call_holonom_model_of(core);
    numbers = call_holonom_numbers_of(core), state = call_holonom_state_of(core),
    work = call_holonom_work_of(core);
    state_bytes = sizeof *state * (size_t)call_holonom_state_size(model);
    core_step(0.0);
    state_kept = malloc(state_bytes);
    memcpy(state_kept, state, state_bytes);

    double least[N_TIMED];
    for (int k = 0; k < N_TIMED; k++) least[k] = 1e300;
    for (int r = 0; r < atoi(argument[7]); r++)
        for (int k = 0; k < N_TIMED; k++) {
            if (!strchr(argument[8], timed[k].letter)) continue;
            timed[k].prepare();
            const double begin = now();
            timed[k].repeat();
            const double took = now() - begin;
            if (took < least[k]) least[k] = took;
            if (!r && timed[k].letter == 'a' && strchr(argument[8], 'd')) compare(core);
        }
    for (int k = 0; k < N_TIMED; k++)
        if (strchr(argument[8], timed[k].letter)) printf("%c %.17g\n", timed[k].letter, least[k]);
    return 0;
}
