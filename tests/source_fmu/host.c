/* A program of two FMUs of FMI 2 or, with -DFMI=3, 3 that are compiled into it, as a controller has
   them, with prefixes a_ and b_:

       host STEPS  GUID STEP INPUT OUTPUT ...  -  GUID STEP INPUT OUTPUT ...

   Both move in turns. INPUT, a value reference or -1, is 0, 0.25, 0.5, 0.75, 0, ...; the OUTPUTs
   are written after each step, one a line. Exit code 1: a call was refused. */
#include "fmi2.h"
#include "fmi3.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_OUTPUTS = 200 };

#if FMI == 3
#define FUNCTIONS FMI3_FUNCTIONS
typedef fmi3_instance instance;
#else
#define FUNCTIONS FMI2_FUNCTIONS
typedef fmi2_component instance;
#endif

typedef struct fmu {
#define FIELD(result, name, arguments) result (*name) arguments;
    FUNCTIONS(FIELD)
    instance instance;
    double t, step;
    int input;
    uint32_t output[MOST_OUTPUTS];
    size_t n_outputs;
} fmu;

#define DECLARE_A(result, name, arguments) result a_##name arguments;
#define DECLARE_B(result, name, arguments) result b_##name arguments;
FUNCTIONS(DECLARE_A)
FUNCTIONS(DECLARE_B)
#define TAKE_A(result, name, arguments) .name = a_##name,
#define TAKE_B(result, name, arguments) .name = b_##name,
static fmu both[] = {{FUNCTIONS(TAKE_A).t = 0.0}, {FUNCTIONS(TAKE_B).t = 0.0}};

static void must(int status)
{
    if (status) exit(1);
}

#if FMI == 3

static void hear(void *environment, fmi3_status status, fmi3_text category, fmi3_text message)
{
    (void)environment;
    fprintf(stderr, "%d %s: %s\n", (int)status, category, message);
}

static void initialise(fmu *f, const char *token)
{
    f->instance = f->fmi3InstantiateCoSimulation("compiled in", token, NULL, 0, 0, 0, 0, NULL, 0,
                                                 NULL, hear, NULL);
    if (!f->instance) exit(1);
    must(f->fmi3EnterInitializationMode(f->instance, 0, 0.0, 0.0, 0, 0.0));
    must(f->fmi3ExitInitializationMode(f->instance));
}

static void set(fmu *f, uint32_t input, double value)
{ must(f->fmi3SetFloat64(f->instance, &input, 1, &value, 1)); }
static void get(fmu *f, double *output)
{ must(f->fmi3GetFloat64(f->instance, f->output, f->n_outputs, output, f->n_outputs)); }

static void step(fmu *f, double t)
{
    fmi3_boolean flag[3];
    double last;
    must(f->fmi3DoStep(f->instance, t, f->step, 1, flag, flag + 1, flag + 2, &last));
}

static void release(fmu *f) { f->fmi3FreeInstance(f->instance); }

#else

static void hear(void *environment, fmi2_text instance, fmi2_status status, fmi2_text category,
                 fmi2_text message, ...)
{
    (void)environment;
    fprintf(stderr, "%s %d %s: %s\n", instance, (int)status, category, message);
}

static void initialise(fmu *f, const char *guid)
{
    static const fmi2_callbacks callbacks = {.logger = hear};
    f->instance =
        f->fmi2Instantiate("compiled in", FMI2_CO_SIMULATION, guid, NULL, &callbacks, 0, 0);
    if (!f->instance) exit(1);
    must(f->fmi2SetupExperiment(f->instance, 0, 0.0, 0.0, 0, 0.0));
    must(f->fmi2EnterInitializationMode(f->instance));
    must(f->fmi2ExitInitializationMode(f->instance));
}

static void set(fmu *f, uint32_t input, double value)
{ must(f->fmi2SetReal(f->instance, &input, 1, &value)); }
static void get(fmu *f, double *output)
{ must(f->fmi2GetReal(f->instance, f->output, f->n_outputs, output)); }
static void step(fmu *f, double t) { must(f->fmi2DoStep(f->instance, t, f->step, 1)); }
static void release(fmu *f) { f->fmi2FreeInstance(f->instance); }

#endif

/* Takes the arguments of one FMU, and returns those behind. */
static char **begin(fmu *f, char **a)
{
    const char *token = a[0];
    f->step = atof(a[1]), f->input = atoi(a[2]);
    for (a += 3; *a && strcmp(*a, "-") && f->n_outputs < MOST_OUTPUTS; a++)
        f->output[f->n_outputs++] = (uint32_t)atoi(*a);
    initialise(f, token);
    return a + !!*a;
}

static void move(fmu *f, int k)
{
    double output[MOST_OUTPUTS];
    if (f->input >= 0) set(f, (uint32_t)f->input, 0.25 * (k % 4));
    step(f, k * f->step);
    get(f, output);
    for (size_t i = 0; i < f->n_outputs; i++) printf("%.17g\n", output[i]);
}

int main(int count, char **a)
{
    if (count < 9) return 2;
    begin(both + 1, begin(both, a + 2));
    for (int k = 0; k < atoi(a[1]); k++) move(both, k), move(both + 1, k);
    for (int i = 0; i < 2; i++) release(both + i);
    return 0;
}
