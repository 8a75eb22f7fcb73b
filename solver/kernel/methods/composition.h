/* Steps of order 4, 6 and 8 as symmetric compositions of pairs of half steps, for equal steps of
   what loses no energy (theory 8.1). */
#ifndef HOLONOM_COMPOSITION_H
#define HOLONOM_COMPOSITION_H

#include "half_step.h"

/* Pairs in a composition of an order. */
static int n_stages(int order) { return order == 8 ? 15 : order == 6 ? 9 : order == 4 ? 5 : 1; }

/* A symmetric composition of pairs with these parts of the step has the order given: each stage
   conserves by itself. The plain step is not near the identity as h goes to 0 (it reflects the
   velocity normal to the constraints), the pair is, so that it composes (theory 8.1). Parts beyond
   the middle repeat the first ones in reverse. Order 4: Suzuki 1990; 6: Kahan and Li 1997, s9odr6a;
   8: the 15 stages of Suzuki and Umeno 1993. */
static double stage(int order, int i)
{
    static const double fourth[] = {0.41449077179437573714, 0.41449077179437573714,
                                    -0.65796308717750294857};
    static const double sixth[] = {0.39216144400731413928, 0.33259913678935943860,
                                   -0.70624617255763935981, 0.082213596293550800230,
                                   0.79854399093482996340};
    static const double eighth[] = {0.74167036435061295344822780, -0.40910082580003159399730010,
                                    0.19075471029623837995387626, -0.57386247111608226665638773,
                                    0.29906418130365592384446354, 0.33462491824529818378495798,
                                    0.31529309239676659663205666, -0.79688793935291635401978882};
    static const double whole[] = {1.0};
    const double *parts = order == 8 ? eighth : order == 6 ? sixth : order == 4 ? fourth : whole;
    const int last = n_stages(order) - 1;
    return parts[i <= last / 2 ? i : last - i];
}

/* Pairs of a composition, from half step number `first` of the internal one on. */
static int32_t take_pairs(context *c, double h, int order, int first)
{
    const double dissipated = c->s.head[S_DISSIPATED] - 1e-9 * c->s.head[S_ENERGY_REFERENCE];
    for (int i = 0; i < n_stages(order); i++) {
        const double half = 0.5 * h * stage(order, i);
        int32_t status = single_step(c, half, first + 2 * i);
        if (!status) status = single_step(c, half, first + 2 * i + 1);
        if (status) return status;
        average_multipliers(c, c->t - half);
        keep_forces(c, c->s.head[S_MEAN_TIME], c->s.mean);
    }
    /* Dampers too strong for the parts that go back in time run away, with a ledger that closes. */
    return order > 2 && !(c->s.head[S_DISSIPATED] >= dissipated) ? HOLONOM_DAMPING_REVERSED
                                                                 : HOLONOM_OK;
}

/* A composition of pairs of half steps, of order 2 one pair. */
static int32_t composed_step(context *c, double h, int order, step_result *result)
{
    result->method = COMPOSED;
    keep_state(c, c->k.pair_backup);
    begin_halves(c, 2 * n_stages(order));
    c->step.n_kept_forces = 0;
    return take_pairs(c, h, order, 0);
}

#endif
