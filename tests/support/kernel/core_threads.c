/* Runs instances of one model in threads at once and prints a hash of all values of each thread:
   they must be equal. */
#include "instance.h"

#include <inttypes.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_THREADS = 64, STEPS = 40, MOST_VALUES = 1000 };

static const void *model;
static int64_t model_length;
static int32_t n_values;
static double length; /* of a step, s */
static uint64_t hash_of_thread[MOST_THREADS];

static uint64_t hashed(uint64_t hash, const void *bytes, size_t count)
{
    for (const unsigned char *byte = bytes; count; count--, byte++)
        hash = (hash ^ *byte) * 1099511628211u;
    return hash;
}

static void *run(void *hash)
{
    char why[200];
    const int64_t size = holonom_instance_size(model, model_length, why, sizeof why);
    void *memory = malloc((size_t)size + 16);
    holonom_instance *i =
        holonom_make(model, (void *)(((uintptr_t)memory + 15) & ~(uintptr_t)15), 1);
    int32_t index[MOST_VALUES];
    double value[MOST_VALUES];
    uint64_t found = 14695981039346656037u;
    char *saved = malloc((size_t)holonom_saved_size(i));
    for (int32_t k = 0; k < n_values; k++) index[k] = k;
    for (int step = 0; step < STEPS; step++) {
        if (step == 10) holonom_save(i, saved);
        if (step == 20) holonom_restore(i, saved, holonom_saved_size(i));
        const int32_t moved = holonom_move(i, holonom_state_of(i)[0], length),
                      got = holonom_get(i, index, n_values, value);
        found = hashed(hashed(found, &moved, sizeof moved), &got, sizeof got);
        found = hashed(found, value, sizeof(double) * (size_t)n_values);
        found = hashed(found, holonom_message(i), strlen(holonom_message(i)));
    }
    *(uint64_t *)hash = found;
    free(saved);
    free(memory);
    return NULL;
}

int main(int count,
         char **word) /* model file, number of values, length of a step, number of threads */
{
    pthread_t thread[MOST_THREADS];
    const int n_threads = count > 4 ? atoi(word[4]) : 1;
    FILE *file = fopen(word[1], "rb");
    double *content = malloc(1 << 22);
    model_length = (int64_t)fread(content, 1, 1 << 22, file);
    fclose(file);
    model = content;
    n_values = atoi(word[2]);
    length = atof(word[3]);
    for (int k = 0; k < n_threads; k++) pthread_create(thread + k, NULL, run, hash_of_thread + k);
    for (int k = 0; k < n_threads; k++) pthread_join(thread[k], NULL);
    for (int k = 0; k < n_threads; k++) printf("%016" PRIx64 "\n", hash_of_thread[k]);
    free(content);
    return 0;
}
