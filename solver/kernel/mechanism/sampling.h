/* Whether loads that read the mechanism are sampled often enough (theory 5.6).

   Such a load is evaluated once a half step, at the motion that is foreseen for its middle, and
   acts over all of it. The work that it would do along the foreseen increment, x, is compared with
   what it does along the one that it brought about, y: a damper c on a mass m that is new in a half
   step h takes |x| c h/(2 m) off |x|, and beyond 1 it pushes the mass back faster than it came.
   Sums of |x| and of what y takes off it over the last half steps give the ratio, so that a motion
   which passes through rest does not count, but a load that alternates from half step to half step
   does. A motor that does more work than foreseen, as where it starts, is no error of sampling. */
#ifndef HOLONOM_SAMPLING_H
#define HOLONOM_SAMPLING_H

#include "function.h"
#include "laws.h"

#define FORGETTING 0.8   /* of a sum, that a half step leaves */
#define NEGLIGIBLE 1e-14 /* work, over the reference energy */

HM_SELDOM static double sampled_work(const context *c, int32_t kind, int32_t j)
{
    composite_result result = {0.0, 0.0, 0.0};
    if (kind == SAMPLED_LOAD) return load_work(c, j);
    if (kind == SAMPLED_MOMENT) return moment_work(c, j);
    if (kind == SAMPLED_BODY_MOMENT) return body_moment_work(c, j);
    if (composite_slopes(c, j, SLOPES_ALONE, &result)) return 0.0;
    return c->number[c->m->drive_at + j] * result.mechanical;
}

/* Compares works after a half step that is solved and not yet taken over. The state keeps of each
   load both sums and the largest ratio in this communication step. */
HM_SELDOM static void judge_sampling(context *c, int parity)
{
    const double *a = c->s.a[parity],
                 negligible = NEGLIGIBLE * c->s.head[S_ENERGY_REFERENCE] + DBL_MIN;
    double *kept = c->s.sampled;
    context ahead = *c;
    ahead.k.d = c->k.sensed;
    for (int32_t k = 0; k < DIM * c->n_moving; k++)
        c->k.sensed[k] =
            k < DIM * c->m->n_free ? c->h * (c->s.v[k] + 0.5 * c->h * a[k]) : c->k.d[k];
    for (int32_t i = 0; i < c->m->n_sampled; i++, kept += 3) {
        const int32_t *load = c->m->sampled_load + 2 * i;
        const double done = sampled_work(c, load[0], load[1]);
        const double foreseen = sampled_work(&ahead, load[0], load[1]);
        kept[0] = FORGETTING * kept[0] + fabs(foreseen);
        kept[1] =
            FORGETTING * kept[1] + fmax(foreseen < 0.0 ? done - foreseen : foreseen - done, 0.0);
        kept[2] = fmax(kept[2], kept[1] / (kept[0] + negligible));
    }
}

/* Largest ratio of a load in this communication step. */
HM_SELDOM static double sampling(const context *c)
{
    double largest = 0.0;
    for (int32_t i = 0; i < c->m->n_sampled; i++) largest = fmax(largest, c->s.sampled[3 * i + 2]);
    return largest;
}

#endif
