/* The law of impact, for a caller that lays its arrays out itself. */
#include "impact_law.h"

HOLONOM_API int64_t impact_scratch(int32_t rows);
HOLONOM_API int solve_impact(hm_impact *x);

int64_t impact_scratch(int32_t rows) { return IMPACT_SCRATCH(rows); }

int solve_impact(hm_impact *x) { return hm_solve_impact(x); }
