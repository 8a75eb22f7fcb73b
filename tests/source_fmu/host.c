/* A program of two FMUs that are compiled into it, as a controller has them, with the prefixes a_ and b_:

       host STEPS  GUID STEP INPUT OUTPUT ...  -  GUID STEP INPUT OUTPUT ...

   Both move in turns. INPUT, a value reference or -1, is 0, 0.25, 0.5, 0.75, 0, ...; the OUTPUTs are written after each step, one a
   line. Exit code 1: a call was refused. */
#include "fmi2.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_OUTPUTS = 200 };

typedef struct fmu {
#define FIELD(result, name, arguments) result (*name) arguments;
    FMI2_FUNCTIONS(FIELD)
    fmi2_component instance;
    double t, step;
    int input;
    fmi2_reference output[MOST_OUTPUTS];
    size_t n_outputs;
} fmu;

#define DECLARE_A(result, name, arguments) result a_##name arguments;
#define DECLARE_B(result, name, arguments) result b_##name arguments;
FMI2_FUNCTIONS(DECLARE_A)
FMI2_FUNCTIONS(DECLARE_B)
#define TAKE_A(result, name, arguments) .name = a_##name,
#define TAKE_B(result, name, arguments) .name = b_##name,
static fmu both[] = {{FMI2_FUNCTIONS(TAKE_A).t = 0.0}, {FMI2_FUNCTIONS(TAKE_B).t = 0.0}};

static void hear(void *environment, fmi2_text instance, fmi2_status status, fmi2_text category, fmi2_text message, ...)
{
    (void)environment;
    fprintf(stderr, "%s %d %s: %s\n", instance, (int)status, category, message);
}

static void must(fmi2_status status)
{
    if (status != FMI2_OK) exit(1);
}

/* Takes the arguments of one FMU, and returns those behind. */
static char **begin(fmu *f, char **a)
{
    static const fmi2_callbacks callbacks = {.logger = hear};
    f->instance = f->fmi2Instantiate("compiled in", FMI2_CO_SIMULATION, a[0], NULL, &callbacks, 0, 0);
    if (!f->instance) exit(1);
    f->step = atof(a[1]), f->input = atoi(a[2]);
    for (a += 3; *a && strcmp(*a, "-") && f->n_outputs < MOST_OUTPUTS; a++) f->output[f->n_outputs++] = (fmi2_reference)atoi(*a);
    must(f->fmi2SetupExperiment(f->instance, 0, 0.0, 0.0, 0, 0.0));
    must(f->fmi2EnterInitializationMode(f->instance));
    must(f->fmi2ExitInitializationMode(f->instance));
    return a + !!*a;
}

static void move(fmu *f, int k)
{
    const fmi2_reference input = (fmi2_reference)f->input;
    const double value = 0.25 * (k % 4);
    double output[MOST_OUTPUTS];
    if (f->input >= 0) must(f->fmi2SetReal(f->instance, &input, 1, &value));
    must(f->fmi2DoStep(f->instance, k * f->step, f->step, 1));
    must(f->fmi2GetReal(f->instance, f->output, f->n_outputs, output));
    for (size_t i = 0; i < f->n_outputs; i++) printf("%.17g\n", output[i]);
}

int main(int count, char **a)
{
    if (count < 9) return 2;
    begin(both + 1, begin(both, a + 2));
    for (int k = 0; k < atoi(a[1]); k++) move(both, k), move(both + 1, k);
    for (int i = 0; i < 2; i++) both[i].fmi2FreeInstance(both[i].instance);
    return 0;
}
