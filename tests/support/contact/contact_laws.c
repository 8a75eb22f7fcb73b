/* The laws of contact, for a caller that lays its arrays out itself. */
#include "impact_sweep.h"

HOLONOM_API int64_t contact_scratch(int32_t rows);
HOLONOM_API int64_t impact_scratch(int32_t rows);
HOLONOM_API int solve_contacts(contact_problem *x, int wanted, int shares);
HOLONOM_API int solve_impact(hm_impact *x);
HOLONOM_API int holds_load(double load);

int64_t contact_scratch(int32_t rows) { return CONTACT_SCRATCH(rows); }

int64_t impact_scratch(int32_t rows) { return IMPACT_SCRATCH(rows); }

int solve_contacts(contact_problem *x, int wanted, int shares)
{
    const int failed = hm_solve_contacts(x, wanted);
    if (!failed && shares) hm_share_impulses(x);
    return failed;
}

int solve_impact(hm_impact *x) { return hm_solve_impact(x); }

/* Whether one contact without friction has a force that meets this load. */
int holds_load(double load)
{
    const int32_t first = 0, tangents = 0;
    const double coefficient = 0.0, B = 1.0;
    double v[7];
    const rest_split x = {.contacts = 1,
                          .rows = 1,
                          .rank = 1,
                          .first = &first,
                          .tangents = &tangents,
                          .coefficient = &coefficient,
                          .B = &B,
                          .g = &load,
                          .force = v,
                          .base = v + 1,
                          .dual = v + 2,
                          .way = v + 3,
                          .defect = v + 4,
                          .trial = v + 5,
                          .matrix = v + 6};
    return has_split(&x, 1.0);
}
