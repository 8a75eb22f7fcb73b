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

/* Weights of the outputs 0 ... s after each stage, for the difference from a solution of lower order that costs nothing:
   the sum of weighted outputs vanishes to order 3 and 2, 4 and 2, or 5 and 3. They fulfil the conditions of that order,
   with a unit error of the next one, and repeat in reverse (odd order) or with the other sign (even). docs/method.md. */
static double embedded(int order, int lower, int i, int stages)
{
    static const double weights[6][8] = {
        {4.1241054657117822, 5.793661999832441, -9.9177674655442232},
        {1.3408927628104155, 1.9364790969793597, 2.5412769522090053},
        {1.8226314151074883, -6.4011435573198723, -6.2891381706484477, -0.8785205100332758, -3.0344753042599},
        {1.3924516780664877, 0.79248065939298917, 0.16758936267750835, -0.74285115760501119, -0.96762658458308271},
        {15.141411217507283, -12.263374322255949, 6.9527437214117782, 8.5169471212453516, -10.225761221162973,
         -9.0240383596451892, -1.7001504698145284, 2.6022223127142272},
        {0.13199986272792208, 1.6107381537523564, -0.84908552473929788, 0.022347701637577013, -0.85249375052665732,
         -1.1474567476428574, -0.3660281753229786, 1.4499784801139359}};
    const double *w = weights[order - 4 + lower];
    if (2 * i <= stages) return w[i];
    return order == 6 || (order == 4 && lower) ? -w[stages - i] : w[stages - i];
}
