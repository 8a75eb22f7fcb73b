/* A host in C for unpacked FMUs (FMI 2.0 co-simulation), for the tests:

       host run     LIBRARY RESOURCES INPUT OUTPUT STEPS H [TOLERANCE]   output after each step
       host odd     LIBRARY RESOURCES INPUT OUTPUT STEPS H    likewise, in another floating-point
   mode host allocations LIBRARY RESOURCES INPUT OUTPUT STEPS  of memory in so many steps, and of an
   instance host instances LIBRARY RESOURCES INPUT OUTPUT COUNT    allocations by so many, and those
   not given back host calls   LIBRARY RESOURCES INPUT OUTPUT BOOLEAN STRING    every function once
       host cycles  LIBRARY RESOURCES INPUT OUTPUT COUNT      load, run, unload COUNT times: output,
                                                              pages in memory, 1 if still loaded
       host threads LIBRARY RESOURCES INPUT OUTPUT COUNT [LIBRARY RESOURCES INPUT OUTPUT]...
                                                              COUNT instances at once, each in a
   thread host turns   LIBRARY RESOURCES INPUT OUTPUT STEPS LIBRARY RESOURCES INPUT OUTPUT two FMUs,
   one ending before the other

   RESOURCES is a URI, the rest value references and numbers. HOST_PYTHON in the environment names a
   libpython that the host loads for all before it loads an FMU. Results go to stdout, one a line;
   the log goes to stderr. Exit code 1: an FMU cannot be loaded or makes no instance. */

#define _POSIX_C_SOURCE 200809L

#include "fmi2.h"

#include <dlfcn.h>
#include <immintrin.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_STEPS = 1000, MAX_THREADS = 16, THREAD_STEPS = 50, FMU_ARGUMENTS = 4 };
static const double THREAD_H = 0.01;

static void hear(void *environment, text instance, fmi2_status status, text category, text message,
                 ...)
{
    (void)environment;
    fprintf(stderr, "%s %d %s: ", instance ? instance : "-", status, category ? category : "-");
    va_list arguments;
    va_start(arguments, message);
    vfprintf(stderr, message, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

static const fmi2_callbacks CALLBACKS = { hear, calloc, free, NULL, NULL };

static void fail(text what, text why)
{
    fprintf(stderr, "%s: %s\n", what, why ? why : "no reason given");
    exit(1);
}

static void *function_of(void *library, text name)
{
    void *function = dlsym(library, name);
    if (!function)
        fail(name, "not in the library");
    return function;
}

/* The GUID in the model description beside the folder of resources, a file URI. */
static void read_guid(text resources, char *guid, size_t room)
{
    char path[4096], line[4096], *begin = NULL;
    snprintf(path, sizeof path, "%s/../modelDescription.xml", resources + strlen("file://"));
    FILE *file = fopen(path, "r");
    while (file && !begin && fgets(line, sizeof line, file))
        begin = strstr(line, "guid=\"");
    if (begin)
        snprintf(guid, room, "%.*s", (int)strcspn(begin + 6, "\""), begin + 6);
    else
        fail(path, "no GUID");
    fclose(file);
}

static struct fmu load(text library, text resources)
{
    struct fmu fmu;
    read_guid(resources, fmu.guid, sizeof fmu.guid);
    fmu.library = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    fmu.resources = resources;
    if (!fmu.library)
        fail("dlopen", dlerror());
    /* C99 has no cast from an object's pointer to a function's; POSIX says how it is done. */
#define LOAD(result, name, arguments) *(void **)&fmu.name = function_of(fmu.library, #name);
    FMI2_FUNCTIONS(LOAD)
#undef LOAD
    return fmu;
}

static component instantiate(const struct fmu *fmu)
{
    component c = fmu->fmi2Instantiate("c host", FMI2_CO_SIMULATION, fmu->guid, fmu->resources,
                                       &CALLBACKS, 0, 1);
    if (!c)
        fail("fmi2Instantiate", "no instance");
    return c;
}

static void must(int status, text what)
{
    if (status != FMI2_OK) {
        fprintf(stderr, "%s returned %d\n", what, status);
        exit(1);
    }
}

/* `tolerance`: in words, or NULL where the host gives none. */
static void initialise(const struct fmu *fmu, component c, text tolerance)
{
    must(fmu->fmi2SetupExperiment(c, tolerance != NULL, tolerance ? atof(tolerance) : 0.0, 0.0, 0,
                                  0.0),
         "fmi2SetupExperiment");
    must(fmu->fmi2EnterInitializationMode(c), "fmi2EnterInitializationMode");
    must(fmu->fmi2ExitInitializationMode(c), "fmi2ExitInitializationMode");
}

/* Steps of size h with an input of 1, 2, 3, ...; the output after each. */
static void take_steps(const struct fmu *fmu, component c, reference input, reference output,
                       int steps, double h, double *values)
{
    for (int i = 0; i < steps; i++) {
        double push = 1.0 + i;
        must(fmu->fmi2SetReal(c, &input, 1, &push), "fmi2SetReal");
        must(fmu->fmi2DoStep(c, i * h, h, 1), "fmi2DoStep");
        must(fmu->fmi2GetReal(c, &output, 1, &values[i]), "fmi2GetReal");
    }
}

static void end(const struct fmu *fmu, component c)
{
    must(fmu->fmi2Terminate(c), "fmi2Terminate");
    fmu->fmi2FreeInstance(c);
}

static void run(char **a, text tolerance)
{
    struct fmu fmu = load(a[0], a[1]);
    component c = instantiate(&fmu);
    double values[MAX_STEPS];
    int steps = atoi(a[4]);
    if (steps > MAX_STEPS)
        fail("run", "too many steps");
    initialise(&fmu, c, tolerance);
    take_steps(&fmu, c, (reference)atoi(a[2]), (reference)atoi(a[3]), steps, atof(a[5]), values);
    end(&fmu, c);
    for (int i = 0; i < steps; i++)
        printf("%.17g\n", values[i]);
}

/* The same where the host flushes small numbers to zero and rounds towards zero; it must find that
   again. */
static void run_odd(char **a)
{
    const unsigned flushing = _mm_getcsr() | 0x8040 | 0x6000;
    _mm_setcsr(flushing);
    run(a, NULL);
    if ((_mm_getcsr() & ~0x3fu)
        != (flushing & ~0x3fu)) /* but for flags of what the host itself has done */
        fail("odd", "the floating-point environment has changed");
}

/* Allocations by anybody in this process: these stand before those of the C library. */
static volatile long n_allocations, n_frees;
#ifndef __SANITIZE_ADDRESS__ /* which has its own in that place */
void __libc_free(void *memory);
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);
void *malloc(size_t size) { n_allocations++; return __libc_malloc(size); }
void *calloc(size_t count, size_t size) { n_allocations++; return __libc_calloc(count, size); }
void *realloc(void *memory, size_t size) { n_allocations++; return __libc_realloc(memory, size); }

void free(void *memory) { n_frees += memory != NULL; __libc_free(memory); }
#endif

/* Allocations in so many steps, with values read and set, and derivatives of four outputs, and
   after one instance more. */
static void allocations(char **a)
{
    struct fmu fmu = load(a[0], a[1]);
    component c = instantiate(&fmu);
    double values[MAX_STEPS];
    initialise(&fmu, c, NULL);
    const long before = n_allocations;
    take_steps(&fmu, c, (reference)atoi(a[2]), (reference)atoi(a[3]), atoi(a[4]), 0.01, values);
    const reference first = (reference)atoi(a[3]),
                    asked[4] = {first, first + 1, first + 2, first + 3};
    const int orders[4] = {1, 1, 1, 1};
    must(fmu.fmi2GetRealOutputDerivatives(c, asked, 4, orders, values),
         "fmi2GetRealOutputDerivatives");
    const long after = n_allocations;
    component other = instantiate(&fmu);
    const long last = n_allocations;
    end(&fmu, c);
    fmu.fmi2FreeInstance(other);
    printf("%ld\n%ld\n", after - before, last - after);
}

/* Makes and frees COUNT instances: how many pieces of memory are not given back. */
static void instances(char **a)
{
    struct fmu fmu = load(a[0], a[1]);
    fmu.fmi2FreeInstance(instantiate(&fmu));
    const long held = n_allocations - n_frees;
    for (int i = 0; i < atoi(a[4]); i++) {
        component c = instantiate(&fmu);
        saved state = NULL;
        initialise(&fmu, c, NULL);
        must(fmu.fmi2GetFMUstate(c, &state), "fmi2GetFMUstate");
        must(fmu.fmi2FreeFMUstate(c, &state), "fmi2FreeFMUstate");
        fmu.fmi2FreeInstance(c);
    }
    printf("%ld\n%ld\n", n_allocations, n_allocations - n_frees - held);
}

/* Pages of this process that are in memory; 0 where the system does not tell. */
static long resident_pages(void)
{
    long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file && fscanf(file, "%*d %ld", &pages) != 1)
        pages = 0;
    if (file)
        fclose(file);
    return pages;
}

static void cycles(char **a)
{
    int count = atoi(a[4]);
    for (int i = 0; i < count; i++) {
        struct fmu fmu = load(a[0], a[1]);
        component c = instantiate(&fmu);
        double values[5];
        initialise(&fmu, c, NULL);
        take_steps(&fmu, c, (reference)atoi(a[2]), (reference)atoi(a[3]), 5, 0.01, values);
        end(&fmu, c);
        if (dlclose(fmu.library) != 0)
            fail("dlclose", dlerror());
        void *still = dlopen(a[0], RTLD_NOW | RTLD_NOLOAD);
        printf("%.17g %ld %d\n", values[4], resident_pages(), still != NULL);
        if (still)
            dlclose(still);
    }
}

/* pythonfmu's libraries race where two FMUs start Python at once, so instances are made by
   turns. */
static pthread_mutex_t one_at_a_time = PTHREAD_MUTEX_INITIALIZER;

struct job {
    struct fmu fmu;
    reference input, output;
    double values[THREAD_STEPS];
};

static void *work(void *data)
{
    struct job *job = data;
    pthread_mutex_lock(&one_at_a_time);
    component c = instantiate(&job->fmu);
    pthread_mutex_unlock(&one_at_a_time);
    initialise(&job->fmu, c, NULL);
    take_steps(&job->fmu, c, job->input, job->output, THREAD_STEPS, THREAD_H, job->values);
    end(&job->fmu, c);
    return NULL;
}

static void threads(char **a, int fmus)
{
    static struct job jobs[MAX_THREADS];
    pthread_t ids[MAX_THREADS];
    int count = atoi(a[FMU_ARGUMENTS]);
    if (count > MAX_THREADS)
        fail("threads", "too many");
    for (int i = 0; i < count; i++) {
        int which = i % fmus;
        char **b = a + which * FMU_ARGUMENTS + (which > 0);
        jobs[i].fmu = load(b[0], b[1]);
        jobs[i].input = (reference)atoi(b[2]);
        jobs[i].output = (reference)atoi(b[3]);
    }
    for (int i = 0; i < count; i++)
        must(pthread_create(&ids[i], NULL, work, &jobs[i]), "pthread_create");
    for (int i = 0; i < count; i++)
        must(pthread_join(ids[i], NULL), "pthread_join");
    for (int i = 0; i < count; i++)
        printf("%.17g\n", jobs[i].values[THREAD_STEPS - 1]);
}

/* The first FMU steps and is gone when the second one does; then it comes back and steps again. */
static void turns(char **a)
{
    int steps = atoi(a[FMU_ARGUMENTS]);
    char **b = a + FMU_ARGUMENTS + 1;
    double values[MAX_STEPS];
    if (steps < 1 || steps > MAX_STEPS)
        fail("turns", "number of steps");
    struct fmu first = load(a[0], a[1]), second = load(b[0], b[1]);
    component one = instantiate(&first), two = instantiate(&second);
    for (int again = 0; again < 2; again++) {
        initialise(&first, one, NULL);
        take_steps(&first, one, (reference)atoi(a[2]), (reference)atoi(a[3]), steps, THREAD_H,
                   values);
        end(&first, one);
        dlclose(first.library);
        printf("%.17g\n", values[steps - 1]);
        if (again == 0) {
            initialise(&second, two, NULL);
            take_steps(&second, two, (reference)atoi(b[2]), (reference)atoi(b[3]), steps, THREAD_H,
                       values);
            printf("%.17g\n", values[steps - 1]);
            first = load(a[0], a[1]);
            one = instantiate(&first);
        }
    }
    end(&second, two);
    dlclose(second.library);
}

void call_every_function(const struct fmu *fmu, component c, const reference references[4]);

static void calls(char **a)
{
    struct fmu fmu = load(a[0], a[1]);
    component c = instantiate(&fmu);
    reference references[4];
    for (int i = 0; i < 4; i++)
        references[i] = (reference)atoi(a[2 + i]);
    call_every_function(&fmu, c, references);
}

int main(int count, char **arguments)
{
    text python = getenv("HOST_PYTHON");
    if (python && !dlopen(python, RTLD_NOW | RTLD_GLOBAL))
        fail("HOST_PYTHON", dlerror());
    if ((count == 8 || count == 9) && strcmp(arguments[1], "run") == 0)
        run(arguments + 2, count == 9 ? arguments[8] : NULL);
    else if (count == 8 && strcmp(arguments[1], "odd") == 0)
        run_odd(arguments + 2);
    else if (count == 7 && strcmp(arguments[1], "allocations") == 0)
        allocations(arguments + 2);
    else if (count == 7 && strcmp(arguments[1], "instances") == 0)
        instances(arguments + 2);
    else if (count == 8 && strcmp(arguments[1], "calls") == 0)
        calls(arguments + 2);
    else if (count == 7 && strcmp(arguments[1], "cycles") == 0)
        cycles(arguments + 2);
    else if (count >= 7 && strcmp(arguments[1], "threads") == 0)
        threads(arguments + 2, (count - 3) / FMU_ARGUMENTS);
    else if (count == 11 && strcmp(arguments[1], "turns") == 0)
        turns(arguments + 2);
    else
        fail("usage", "see the head of host.c");
    return fflush(stdout) == 0 ? 0 : 1;
}
