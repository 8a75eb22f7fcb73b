/* Registers of a function: its leaves over the step, and its run. */
#ifndef HOLONOM_REGISTERS_H
#define HOLONOM_REGISTERS_H

#include "composite.h"
#include "context.h"

enum register_mode { OVER_STEP, AT_END };

/* Fills the registers of the leaves: values at both ends. A velocity row is a point function of mean quantities
   and mean rates. A signal is known at both ends.                                                            */
HM_OFTEN void load_registers(const context *c, int32_t j, int mode)
{
    const holonom_model *m = c->m;
    const hm_registers *r = &c->k.r;
    const leaf_state *leaf = (const leaf_state *)c->k.leaves;
    const int is_velocity = is_velocity_row(c, j);
    for (int32_t at = m->leaf_ptr[j], l = 0; at < m->leaf_ptr[j + 1]; at++, l++) {
        const int32_t *entry = m->leaf + 4 * at;
        if (entry[0] == LEAF_SIGNAL) {
            r->r0[l] = is_seeking(c) || mode == AT_END ? c->k.signal1[entry[1]] : c->s.signal[entry[1]];
            r->r1[l] = c->k.signal1[entry[1]];
            r->dr[l] = r->r1[l] - r->r0[l];
        } else if (entry[0] == LEAF_RATE) {
            r->r0[l] = r->r1[l] = leaf[l].dx / c->h;
            r->dr[l] = 0.0;
        } else if (is_velocity) {
            r->r0[l] = r->r1[l] = leaf[l].x0 + 0.5 * leaf[l].dx;
            r->dr[l] = 0.0;
        } else {
            r->r0[l] = mode == AT_END ? leaf[l].x1 : leaf[l].x0;
            r->r1[l] = leaf[l].x1;
            r->dr[l] = mode == AT_END ? 0.0 : leaf[l].dx;
        }
    }
}

/* Runs function j; returns the register of its value. */
static int32_t run_function(const context *c, int32_t j)
{
    const holonom_model *m = c->m;
    const int32_t f = j - first_function(c), begin = m->function_ptr[f];
    return hm_discrete_gradient(m->operation + 4 * begin, m->leaf_ptr[j + 1] - m->leaf_ptr[j],
                                m->function_ptr[f + 1] - begin, c->number, &c->k.r);
}

#endif
