/* Impact at a fixed configuration: the energetic sweep, which follows the path (impact_path.h)
   piece by piece to its end; Newton's law where there is no path. */
#ifndef HOLONOM_IMPACT_SWEEP_H
#define HOLONOM_IMPACT_SWEEP_H

#include "turning_pieces.h"

/* Rates by the impulses so far: those of the path leave out what counts as no slip, and where rows
   depend on each other what remains of them then belongs to no motion. */
static inline void rates_anew(impact_path *s)
{
    rates_of_impulses(s->x, s->x->impulse, s->gamma);
    for (int32_t k = 0; k < s->x->rows; k++) s->gamma[k] += s->x->before[k];
}

/* Impulses p of all contacts at once with 0 <= p_N _|_ gamma_N + (W p)_N >= 0 and friction against
   the slip at their end, from the rates in s->gamma; rates at the end in `rate`. 0, or 1 if none
   were found. */
HM_SELDOM static int impulses_at_once(impact_path *s, double *p, double *rate)
{
    hm_impact *x = s->x;
    contact_problem all = {.contacts = x->contacts,
                           .rows = x->rows,
                           .first = x->first,
                           .tangents = x->tangents,
                           .coefficient = x->coefficient,
                           .slides = s->active.slides,
                           .way = s->active.way,
                           .W = x->W,
                           .b = s->gamma,
                           .p = p,
                           .rate = rate,
                           .scratch = x->scratch};
    int presses = 0;
    for (int32_t i = 0; i < x->contacts; i++) s->active.slides[i] = 0;
    all.least_size = REST_OF_RATES * sqrt(s->energy);
    memset(p, 0, sizeof(double) * (size_t)x->rows);
    press_joints(x, p);
    do {
        if (hm_solve_contacts(&all, LEAST_WORK)) return 1;
    } while (press_joints(x, p) > SWEEP_ROUND_OFF && ++presses < MOST_PRESSES);
    return 0;
}

/* Where no path goes on: all contacts stop at once, without restitution; that never gives
   energy. */
HM_SELDOM static int stop_at_once(impact_path *s)
{
    hm_impact *x = s->x;
    rates_anew(s);
    if (impulses_at_once(s, s->active.p, s->active.rate)) return 1;
    x->jam |= JAM_PLASTIC;
    for (int32_t k = 0; k < x->rows; k++) {
        x->impulse[k] += s->active.p[k];
        x->plastic -= 0.5 * s->active.p[k] * (s->gamma[k] + s->active.rate[k]);
    }
    return 0;
}

/* The last bit of the way of the walls at once, where slips come to rest together with them, which
   no piece resolves. */
HM_SELDOM static void go_at_once(impact_path *s)
{
    hm_impact *x = s->x;
    rates_anew(s);
    for (int32_t i = 0; i < x->contacts; i++) s->gamma[x->first[i]] += s->walls.deep[i];
    const int failed = impulses_at_once(s, s->q, s->turn);
    for (int32_t i = 0; i < x->contacts; i++) s->gamma[x->first[i]] -= s->walls.deep[i];
    s->tau = 0.0;
    for (int32_t i = 0; i < x->contacts && failed;
         i++) { /* the path leaves out these rests, none larger than LAST_BIT of the rates */
        const int32_t k = x->first[i];
        if (fabs(s->gamma[k] + s->walls.deep[i]) <= LAST_BIT * s->size[k])
            s->gamma[k] = -s->walls.deep[i];
        for (int32_t t = k + 1; t <= k + x->tangents[i]; t++)
            if (fabs(s->gamma[t]) <= LAST_BIT * s->size[t]) s->gamma[t] = 0.0;
    }
    if (failed) return;
    for (int32_t k = 0; k < x->rows; k++) s->turn[k] -= s->gamma[k];
    for (int32_t i = 0; i < x->contacts; i++)
        s->turn[x->first[i]] -= s->walls.deep[i], s->walls.rate[i] = 0.0;
    go_straight(s, 1.0);
}

/* Starts the sweep; returns whether a contact approaches. */
HM_SELDOM static int begin_sweep(impact_path *s)
{
    hm_impact *x = s->x;
    double fastest = 0.0;
    int approaches = 0;
    x->friction = x->plastic = 0.0;
    x->jam = x->several = x->pieces = x->newton = 0;
    for (int32_t k = 0; k < x->rows; k++)
        s->gamma[k] = x->before[k], x->impulse[k] = s->q[k] = s->turn[k] = 0.0;
    press_joints(x, s->q);
    for (int32_t i = 0; i < x->contacts; i++)
        if (impact_weight(x, i) > 0.0)
            fastest = fmax(fastest, -x->before[x->first[i]] / sqrt(impact_weight(x, i)));
    for (int32_t i = 0; i < x->contacts; i++) {
        const double root = sqrt(impact_weight(x, i));
        x->compression[i] = x->expansion[i] = s->walls.deep[i] = s->walls.rate[i] = 0.0;
        s->walls.speed[i] = fmax(0.0, -x->before[x->first[i]]);
        if (!(s->walls.speed[i] > SWEEP_ROUND_OFF * fastest * root)) s->walls.speed[i] = 0.0;
        s->walls.live[i] = s->walls.speed[i] > 0.0;
        s->walls.stuck[i] = s->walls.waits[i] = 0;
        s->walls.retreat[i] = is_joint(x, i)     ? 0.0
                              : s->walls.live[i] ? s->walls.speed[i]
                                                 : fastest * root;
        approaches |= s->walls.live[i];
        for (int32_t k = x->first[i]; k <= x->first[i] + x->tangents[i]; k++)
            s->size[k] = fmax(fabs(x->before[k]),
                              fastest * sqrt(fmax(x->W[(int64_t)k * (x->rows + 1)], 0.0)));
    }
    s->tau = -1.0;
    s->patience = 1.0;
    s->energy = 0.0;
    for (int32_t k = 0; k < x->rows; k++)
        if (x->W[(int64_t)k * (x->rows + 1)] > 0.0)
            s->energy = fmax(s->energy, hm_square(s->size[k]) / x->W[(int64_t)k * (x->rows + 1)]);
    s->by_law = s->by_path = s->all_rise = 0;
    return approaches;
}

/* One piece of the path; 0, or 1 at its end, or -1 if it does not get on. */
HM_SELDOM static int sweep_on(impact_path *s)
{
    hm_impact *x = s->x;
    int goes_on = 0;
    for (int32_t i = 0; i < x->contacts; i++) {
        if (s->walls.live[i] && s->tau >= 0.0
            && budget(s, i) <= BUDGET_SPENT * (x->tangents[i] > 1 ? 10.0 : 1.0) * x->compression[i])
            s->walls.live[i] = 0;
        goes_on |= s->walls.live[i] || s->walls.deep[i] > 0.0;
        if (!impact_slips(x, i)) continue;
        s->walls.stuck[i] = slip_now(s, i) <= none_of_slip(s, i);
        for (int32_t a = 1; a <= x->tangents[i] && s->walls.stuck[i]; a++)
            s->gamma[x->first[i] + a] = 0.0;
    }
    if (!goes_on) return 1;
    const int found = find_rates(s);
    if (found == GOES_AT_ONCE) go_at_once(s);
    if (found) return found == NOTHING_HELPS ? -1 : 0;
    x->pieces++;
    for (int32_t i = 0; i < x->contacts; i++) s->walls.rate[i] = wall_rate(s, i, is_active(s, i));
    rates_of_impulses(x, s->q, s->turn);
    if (slip_turns(s)) return -go_round(s);
    const double h = length_of_straight(s);
    if (!(h < INFINITY)) return -1;
    go_straight(s, h);
    return 0;
}

/* The sweep; 0, or 1 if no impulses were found. */
HM_SELDOM static int sweep_impact(hm_impact *x)
{
    impact_path s = sweep_map(x);
    int end = !begin_sweep(&s);
    for (int32_t turn = 0; !end && turn < 60 * (x->contacts + 1); turn++) end = sweep_on(&s);
    if (end <= 0 && stop_at_once(&s)) return 1;
    for (int32_t i = 0; i < x->contacts;
         i++) { /* what the Runge-Kutta pair leaves beyond the cone */
        double *p = x->impulse + x->first[i];
        const int32_t n = x->tangents[i];
        const double cone = x->coefficient[i] * p[0], size = n ? hm_length(n, p + 1) : 0.0;
        for (int32_t a = 1; a <= n && size > cone && size <= cone * (1.0 + CONE_CLIPPED); a++)
            p[a] *= cone / size;
    }
    rates_of_impulses(x, x->impulse, x->after);
    int is_finite = 1;
    for (int32_t k = 0; k < x->rows; k++) is_finite &= fabs(x->after[k] += x->before[k]) < INFINITY;
    return !is_finite;
}

/* Newton's law at once, 0 <= p_N _|_ gamma_N+ + part e gamma_N- >= 0 with friction against the slip
   at the end; returns its loss, or NAN if no impulses were found. */
HM_SELDOM static double newton_impact(impact_path *s, double part)
{
    hm_impact *x = s->x;
    double loss = 0.0;
    memcpy(s->gamma, x->before, sizeof(double) * (size_t)x->rows);
    for (int32_t i = 0; i < x->contacts; i++)
        s->gamma[x->first[i]] += part * x->restitution[i] * fmin(x->before[x->first[i]], 0.0);
    if (impulses_at_once(s, x->impulse, x->after)) return NAN;
    rates_of_impulses(x, x->impulse, x->after);
    for (int32_t k = 0; k < x->rows; k++) {
        x->after[k] += x->before[k];
        loss -= 0.5 * x->impulse[k] * (x->before[k] + x->after[k]);
    }
    return loss;
}

enum { NEWTON_PARTS = 16, NEWTON_HALVINGS = 50 };

/* In place of a sweep that finds no path: Newton's law, with all e times the largest part of them
   at which no energy arises. */
HM_SELDOM static int newton_instead(hm_impact *x)
{
    impact_path s = sweep_map(x);
    double low = 0.0, high = 1.0;
    x->friction = x->plastic = 0.0;
    x->jam = x->several = x->pieces = 0, x->newton = 1;
    for (int32_t i = 0; i < x->contacts; i++) x->compression[i] = x->expansion[i] = 0.0;
    if (newton_impact(&s, 1.0) >= 0.0) return 0;
    for (int part = NEWTON_PARTS - 1; part > 0 && low == 0.0; part--)
        if (newton_impact(&s, (double)part / NEWTON_PARTS) >= 0.0)
            low = (double)part / NEWTON_PARTS, high = low + 1.0 / NEWTON_PARTS;
    for (int halving = 0; halving < NEWTON_HALVINGS && low > 0.0; halving++) {
        if (newton_impact(&s, 0.5 * (low + high)) >= 0.0) low = 0.5 * (low + high);
        else high = 0.5 * (low + high);
    }
    return !(newton_impact(&s, low) >= 0.0);
}

/* Solves one impact; returns 0, or 1 if no impulses were found: those left behind then mean
   nothing. */
HM_SELDOM static int hm_solve_impact(hm_impact *x)
{
    for (int32_t i = 0; i < x->contacts; i++)
        if (!is_joint(x, i) && !(impact_weight(x, i) > 0.0) && x->before[x->first[i]] < 0.0)
            return 1; /* what moves it is held */
    return sweep_impact(x) && newton_instead(x);
}

#endif
