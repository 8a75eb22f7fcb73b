/* What a host of an FMU does in a run, in C: Python takes longer for a call than a small mechanism
   for its step. It knows the FMU by its functions alone; libraries of FMUs leave this file out. */
#include "small.h"

#include "holonom.h"

#include <stdbool.h>
#include <stddef.h>

typedef int32_t (*step_of_fmi2)(void *fmu, double time, double step, int32_t is_never_repeated);
typedef int32_t (*step_of_fmi3)(void *fmu, double time, double step, bool is_never_repeated,
                                bool *event, bool *end, bool *early, double *last);
typedef int32_t (*get_of_fmi2)(void *fmu, const uint32_t *reference, size_t count, double *value);
typedef int32_t (*get_of_fmi3)(void *fmu, const uint32_t *reference, size_t count, double *value,
                               size_t n_values);

/* build_fmu/fmpy_slaves.py has the same fields. */
typedef struct holonom_host {
    void *fmu;
    void (*step)(void),
        (*get)(void); /* fmi2DoStep and fmi2GetReal, or fmi3DoStep and fmi3GetFloat64 */
    const uint32_t *reference;        /* of the variables that are read */
    int32_t is_fmi3, n_read;
    int32_t reached;                  /* communication points of which there are values */
    int32_t is_read;                  /* whether the last call was one that reads */
} holonom_host;

static int32_t step(const holonom_host *h, double time, double length)
{
    bool flag[3];
    double last;
    if (h->is_fmi3)
        return ((step_of_fmi3)h->step)(h->fmu, time, length, true, flag, flag + 1, flag + 2, &last);
    return ((step_of_fmi2)h->step)(h->fmu, time, length, 1);
}

static int32_t get(const holonom_host *h, double *value)
{
    const size_t n = (size_t)h->n_read;
    if (h->is_fmi3) return ((get_of_fmi3)h->get)(h->fmu, h->reference, n, value, n);
    return ((get_of_fmi2)h->get)(h->fmu, h->reference, n, value);
}

/* Goes on to the communication points before `end`, at times in s, and reads values at each:
   (points, n_read). The first point is the start, to which no step leads. Returns the first status
   worse than a warning, which ends it, else 0. */
HOLONOM_API int32_t holonom_run_fmu(holonom_host *h, const double *time, int32_t end, double *value)
{
    for (int32_t status, k; (k = h->reached) < end; h->reached++) {
        h->is_read = 0;
        if (k && (status = step(h, time[k - 1], time[k] - time[k - 1])) > 1) return status;
        h->is_read = 1;
        if (h->n_read && (status = get(h, value + (size_t)k * (size_t)h->n_read)) > 1)
            return status;
    }
    return 0;
}

#include "small.h"
