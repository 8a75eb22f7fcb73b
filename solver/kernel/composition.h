/* Parts of a step of order 2, 4, 6 and 8. */
#ifndef HOLONOM_COMPOSITION_H
#define HOLONOM_COMPOSITION_H

#include "context.h"

enum { N_COMPOSED = 3 }; /* orders 4, 6 and 8 */

/* A symmetric composition of pairs with these parts of the step has the order given: each stage conserves by itself.
   The plain step is not near the identity as h goes to 0 (it reflects the velocity normal to the constraints), the
   pair is, so that it composes (theory 8.1). Parts beyond the middle repeat the first ones in reverse.
   Order 4: Suzuki 1990; 6: Kahan and Li 1997, s9odr6a; 8: the 15 stages of Suzuki and Umeno 1993.              */
static double stage(int order, int i, int *stages)
{
    static const double fourth[] = {0.41449077179437573714, 0.41449077179437573714, -0.65796308717750294857};
    static const double sixth[] = {0.39216144400731413928, 0.33259913678935943860, -0.70624617255763935981,
                                   0.082213596293550800230, 0.79854399093482996340};
    static const double eighth[] = {0.74167036435061295344822780, -0.40910082580003159399730010,
                                    0.19075471029623837995387626, -0.57386247111608226665638773,
                                    0.29906418130365592384446354, 0.33462491824529818378495798,
                                    0.31529309239676659663205666, -0.79688793935291635401978882};
    static const double whole[] = {1.0};
    const double *parts = order == 8 ? eighth : order == 6 ? sixth : order == 4 ? fourth : whole;
    const int middle = order == 8 ? 7 : order == 6 ? 4 : order == 4 ? 2 : 0;
    *stages = 2 * middle + 1;
    return parts[i <= middle ? i : 2 * middle - i];
}

/* Weights of the outputs 0 ... s after each stage, for the difference from a solution of lower order that costs nothing:
   the sum of weighted outputs vanishes to order 3, 4 or 6. They fulfil the conditions of that order, with a unit error
   of the next one, and repeat in reverse (odd order) or with the other sign (even) (theory 8.6).                */
static double embedded(int order, int i, int stages)
{
    static const double weights[3][8] = {
        {4.1241054657117822, 5.793661999832441, -9.9177674655442232},
        {1.8226314151074883, -6.4011435573198723, -6.2891381706484477, -0.8785205100332758, -3.0344753042599},
        {55.91681365966907, -38.903798991623916, -13.314127312603684, 29.777317156091367, -24.384415134859363,
         2.2906965052155357, -1.2771797104762384, 54.44749195234535}};
    const double *w = weights[order / 2 - 2];
    if (2 * i <= stages) return w[i];
    return order == 4 ? w[stages - i] : -w[stages - i];
}

#endif
