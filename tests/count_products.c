/* Counts what factorisations and solves of a kernel multiply: linked in their place with --wrap, which hands on to them. */
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

void __real_hm_lu_solve(int32_t begin, int32_t end, const int32_t *ptr, const int32_t *column, const double *value, double *x);
int32_t __real_hm_lu_factor(int32_t begin, int32_t end, const int32_t *ptr, const int32_t *target, double *value);
__attribute__((visibility("default"))) int64_t counted[4]; /* factorisations, their products, solves, their products */

/* Pivot k has (ptr[k + 1] - ptr[k] - 1)/2 neighbours m: m (m + 1) products to eliminate it, 2 m + 1 to solve. */
int32_t __wrap_hm_lu_factor(int32_t begin, int32_t end, const int32_t *ptr, const int32_t *target, double *value)
{
    counted[0] += 1;
    for (int32_t k = begin; k < end; k++) {
        const int64_t m = (ptr[k + 1] - ptr[k] - 1) / 2;
        counted[1] += m * (m + 1);
    }
    return __real_hm_lu_factor(begin, end, ptr, target, value);
}

void __wrap_hm_lu_solve(int32_t begin, int32_t end, const int32_t *ptr, const int32_t *column, const double *value, double *x)
{
    counted[2] += 1;
    counted[3] += ptr[end] - ptr[begin];
    __real_hm_lu_solve(begin, end, ptr, column, value, x);
}
#endif
