/* Parts of a step of order 2, 4, 6 and 8. Included once per dimension, after start.inc.h. */

/* A symmetric composition of pairs with these parts of the step has the order given: each stage conserves by itself.
   The plain step is not near the identity as h goes to 0 (it reflects the velocity normal to the constraints), the
   pair is, so that it composes (numerics 8). Parts beyond the middle repeat the first ones in reverse.
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
