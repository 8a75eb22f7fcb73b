/* Factors of one island and a solution with them, from tables by their names. */
#include "block_lu.c"

int32_t factor_and_solve(const int32_t *ptr, const int32_t *group, const int32_t *column,
                         const int32_t *target, const int32_t *island, double *value, double *x);

int32_t factor_and_solve(const int32_t *ptr, const int32_t *group, const int32_t *column,
                         const int32_t *target, const int32_t *island, double *value, double *x)
{
    const holonom_elimination lu = {.lu_ptr = ptr,
                                    .lu_group = group,
                                    .lu_column = column,
                                    .lu_target = target,
                                    .lu_island = island};
    if (hm_block_factor(&lu, 0, 1, value)) return 1;
    hm_block_solve(&lu, 0, 1, value, x);
    return 0;
}
