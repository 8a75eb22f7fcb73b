/* What the caller asks before a step: version, dimension, layout of the memory that it lends. */
#include "small.h"
#include "section_tables.h"

#include <stddef.h>

int32_t holonom_abi(void) { return HOLONOM_ABI; }

int32_t holonom_dimension(void) { return DIM; }

int64_t holonom_state_size(const holonom_model *m)
{
    return hm_size_of_state(m);
}

int64_t holonom_work_size(const holonom_model *m)
{
    return hm_size_of_work(m);
}

int64_t holonom_measured_size(const holonom_model *m)
{
    return hm_size_of_measured(m);
}

double holonom_operate(int32_t code, const double *value, int32_t count)
{
    return code < T_SPLINE
               ? hm_operate(code, value[0], value[1], value[2])
               : hm_look_up(code, value, value + (code < T_GRID ? 1 : 3), value + count - 1);
}

void holonom_evaluate(const holonom_model *m, double *numbers, int32_t segment)
{ hm_run_tape(m, numbers, segment); }

#include "small.h"
