/* The laws of contact, for a caller that lays its arrays out itself. */
#include "impact_sweep.h"

HOLONOM_API int64_t contact_scratch(int32_t rows);
HOLONOM_API int64_t impact_scratch(int32_t rows);
HOLONOM_API int solve_contacts(contact_problem *x, int wanted, int shares);
HOLONOM_API int solve_impact(hm_impact *x);

int64_t contact_scratch(int32_t rows) { return CONTACT_SCRATCH(rows); }

int64_t impact_scratch(int32_t rows) { return IMPACT_SCRATCH(rows); }

int solve_contacts(contact_problem *x, int wanted, int shares)
{
    const int failed = hm_solve_contacts(x, wanted);
    if (!failed && shares) hm_share_impulses(x);
    return failed;
}

int solve_impact(hm_impact *x) { return hm_solve_impact(x); }
