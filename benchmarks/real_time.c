/* How long communication steps of a source FMU take, the worst of them included
   (docs/real_time.md):

       holonom build scene.toml --native --sources && unzip -q scene.fmu -d fmu
       cc -O2 -DHOLONOM_BLOCKS=1 -Ifmu/sources benchmarks/real_time.c -o real_time
       ./real_time STEP [COUNT [REPETITIONS]]

   STEP in s; COUNT steps, 1000000 if it is not given, in a run that is repeated, 5 times. Each
   takes the same instructions in each repetition: the least of its times is what the mechanism
   needs, and what is beyond it is the machine's. */
#define _POSIX_C_SOURCE 200809L

#include "all.c"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void hear(void *environment, fmi2_text instance, fmi2_status status, fmi2_text category,
                 fmi2_text message, ...)
{
    (void)environment, (void)instance, (void)status, (void)category;
    fprintf(stderr, "%s\n", message);
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print(const char *what, double *took, int count)
{
    double sum = 0.0;
    for (int k = 0; k < count; k++) sum += took[k];
    qsort(took, (size_t)count, sizeof *took, compare);
    printf("%s [us]: mean %.2f, 99.99 %% %.2f, worst %.2f\n", what, 1e6 * sum / count,
           1e6 * took[(size_t)(0.9999 * count)], 1e6 * took[count - 1]);
}

int main(int n_arguments, char **argument)
{
    static const fmi2_callbacks callbacks = {.logger = hear};
    const double step = n_arguments > 1 ? (atof)(argument[1]) : 0.01;
    const int count = n_arguments > 2 ? atoi(argument[2]) : 1000000,
              repetitions = n_arguments > 3 ? atoi(argument[3]) : 5;
    double *took = malloc(sizeof *took * (size_t)count),
           *least = malloc(sizeof *took * (size_t)count);
    void *fmu = fmi2Instantiate("timed", FMI2_CO_SIMULATION, ((const hm_header *)hm_model)->guid,
                                NULL, &callbacks, 0, 0);
    if (!took || !least || !fmu) return 1;
    for (int k = 0; k < count; k++) least[k] = 1e300;
    for (int r = 0; r < repetitions; r++) {
        if (fmi2Reset(fmu) || fmi2SetupExperiment(fmu, 0, 0.0, 0.0, 0, 0.0)
            || fmi2EnterInitializationMode(fmu) || fmi2ExitInitializationMode(fmu))
            return 1;
        for (int k = 0; k < count; k++) {
            const double begin = now();
            if (fmi2DoStep(fmu, k * step, step, 1)) return 1;
            took[k] = now() - begin;
            if (took[k] < least[k]) least[k] = took[k];
        }
    }
    printf("instance %d bytes\n", (int)(8 * BLOCK_WORDS));
    print("last run", took, count);
    print("least of each step", least, count);
    return 0;
}
