/* Counts what factorisations and solves of a kernel multiply: linked in their place with --wrap,
   which hands on to them. */
#include "holonom.h"

#include <stdint.h>

#ifdef _WIN32
__declspec(dllexport)
#else
__attribute__((visibility("default")))
#endif
int holonom_without; /* bits of the skips that are left out */

#ifdef _WIN32
__declspec(dllexport)
#else
__attribute__((visibility("default")))
#endif
int holonom_energy_decides = 1; /* whether a step must close its ledger to count */

#ifndef UNWRAPPED

void __real_hm_lu_solve(const holonom_elimination *lu, int32_t begin, int32_t end,
                        const double *value, double *x);
int32_t __real_hm_lu_factor(const holonom_elimination *lu, int32_t begin, int32_t end,
                            const int32_t *target, double *value);
int32_t __real_hm_block_factor(const holonom_elimination *lu, int32_t first, int32_t last,
                               double *value);
void __real_hm_block_solve(const holonom_elimination *lu, int32_t first, int32_t last,
                           const double *value, double *x);
__attribute__((visibility(
    "default"))) int64_t counted[4]; /* factorisations, their products, solves, their products */

/* Pivot k has (ptr[k + 1] - ptr[k] - 1)/2 neighbours m: m (m + 1) products to eliminate it, 2 m + 1
   to solve. */
int32_t __wrap_hm_lu_factor(const holonom_elimination *lu, int32_t begin, int32_t end,
                            const int32_t *target, double *value)
{
    counted[0] += 1;
    for (int32_t k = begin; k < end; k++) {
        const int64_t m = (lu->lu_ptr[k + 1] - lu->lu_ptr[k] - 1) / 2;
        counted[1] += m * (m + 1);
    }
    return __real_hm_lu_factor(lu, begin, end, target, value);
}

void __wrap_hm_lu_solve(const holonom_elimination *lu, int32_t begin, int32_t end,
                        const double *value, double *x)
{
    counted[2] += 1;
    counted[3] += lu->lu_ptr[end] - lu->lu_ptr[begin];
    __real_hm_lu_solve(lu, begin, end, value, x);
}

/* A group of p pivots and m neighbours has k + m of these at its k-th pivot from the end. */
static void count_groups(const holonom_elimination *lu, int32_t first, int32_t last,
                         int64_t *of_factors, int64_t *of_solves)
{
    for (int32_t g = lu->lu_island[4 * first + 1]; g < lu->lu_island[4 * last + 1]; g++) {
        const int64_t p = lu->lu_group[3 * g + 3] - lu->lu_group[3 * g];
        for (int64_t m = lu->lu_group[3 * g + 1]; m < lu->lu_group[3 * g + 1] + p; m++) {
            *of_factors += m * (m + 1);
            *of_solves += 2 * m + 1;
        }
    }
}

int32_t __wrap_hm_block_factor(const holonom_elimination *lu, int32_t first, int32_t last,
                               double *value)
{
    int64_t unused = 0;
    counted[0] += 1;
    count_groups(lu, first, last, &counted[1], &unused);
    return __real_hm_block_factor(lu, first, last, value);
}

void __wrap_hm_block_solve(const holonom_elimination *lu, int32_t first, int32_t last,
                           const double *value, double *x)
{
    int64_t unused = 0;
    counted[2] += 1;
    count_groups(lu, first, last, &unused, &counted[3]);
    __real_hm_block_solve(lu, first, last, value, x);
}
#endif
