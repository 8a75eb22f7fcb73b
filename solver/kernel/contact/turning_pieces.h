/* Pieces of the path of an impact in space in which slip turns: a Runge-Kutta pair of order 8
   follows it between events. */
#ifndef HOLONOM_TURNING_PIECES_H
#define HOLONOM_TURNING_PIECES_H

#include "runge_kutta_methods.h"
#include "straight_pieces.h"

HM_SELDOM static void fix_statuses(impact_path *s)
{
    const hm_impact *x = s->x;
    double largest = 0.0;
    s->by_law = s->by_path = 0;
    for (int32_t i = 0; i < x->contacts; i++)
        largest = fmax(largest, s->q[x->first[i]] * sqrt(impact_weight(x, i)));
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = impact_slips(x, i);
        s->walls.on[i] =
            s->q[k] * sqrt(impact_weight(x, i)) > 1e-10 * largest ? PUSHES_SLIDING : IDLE;
        if (s->walls.on[i] == IDLE || !n || !s->walls.stuck[i]) continue;
        const double force = hm_length(n, s->q + k + 1);
        double terms = 0.0;
        for (int32_t j = 0; j < x->rows; j++)
            terms += fabs(x->W[(int64_t)(k + 1) * x->rows + j] * s->q[j]);
        const double growth = hm_length(n, s->turn + k + 1);
        if (force < x->coefficient[i] * s->q[k] * (1.0 - 1e-10) || growth <= 1e-10 * terms)
            s->walls.on[i] = PUSHES_STUCK;
        else if (growth < BEGINS_SLOWLY * terms) s->walls.on[i] = PUSHES_BEGINNING;
        s->by_law |= s->walls.on[i] == PUSHES_BEGINNING;
        for (int32_t a = 1; a <= n; a++) s->lead[k + a] = force > 0.0 ? -s->q[k + a] / force : 0.0;
    }
}

/* p' (q) at these rates with the statuses of the piece: linear, but for the directions in
   joints. */
HM_SELDOM static void rates_by_statuses(const impact_path *s, const double *gamma, double *q)
{
    hm_impact *x = s->x;
    const contact_parts parts = contact_map(&s->rates);
    double *direction = s->kept, *A = parts.matrix, *rhs = parts.rhs, *solution = parts.change;
    int joints = 0, presses = 0;
    for (int32_t i = 0; i < x->contacts; i++) {
        const int32_t k = x->first[i], n = impact_slips(x, i);
        const double slip = n ? hm_length(n, gamma + k + 1) : 0.0;
        const int leads = s->walls.stuck[i] && !(slip > none_of_slip(s, i));
        joints |= is_joint(x, i);
        for (int32_t a = 1; a <= n; a++)
            direction[k + a] = s->walls.on[i] != PUSHES_SLIDING
                                   ? 0.0
                                   : -x->coefficient[i]
                                         * (leads        ? s->lead[k + a]
                                            : slip > 0.0 ? gamma[k + a] / slip
                                                         : 0.0);
    }
    do {
        int32_t count = 0;
        for (int32_t i = 0; i < x->contacts; i++)
            if (s->walls.on[i] != IDLE)
                count += 1 + (s->walls.on[i] == PUSHES_STUCK ? impact_slips(x, i) : 0);
        for (int32_t i = 0, e = 0; i < x->contacts; i++)
            for (int32_t a = 0; s->walls.on[i] != IDLE
                                && a <= (s->walls.on[i] == PUSHES_STUCK ? impact_slips(x, i) : 0);
                 a++, e++) {
                const double *w = x->W + (int64_t)x->rows * (x->first[i] + a),
                             own = w[x->first[i] + a];
                const double scale = own > 0.0 ? 1.0 / sqrt(own) : 0.0;
                rhs[e] = a ? 0.0 : s->walls.rate[i] * scale;
                for (int32_t j = 0, u = 0; j < x->contacts; j++)
                    for (int32_t b = 0;
                         s->walls.on[j] != IDLE
                         && b <= (s->walls.on[j] == PUSHES_STUCK ? impact_slips(x, j) : 0);
                         b++, u++) {
                        const int32_t l = x->first[j] + b;
                        const double weight = x->W[(int64_t)l * x->rows + l];
                        double sum = w[l];
                        for (int32_t t = 1;
                             t <= impact_slips(x, j) && s->walls.on[j] == PUSHES_SLIDING; t++)
                            sum += w[l + t] * direction[l + t];
                        A[e * count + u] = weight > 0.0 ? sum * scale / sqrt(weight) : e == u;
                    }
            }
        if (count == 1) solution[0] = rhs[0] / A[0];
        else hm_least_squares(count, A, rhs, solution, parts.head, parts.order, DEPENDENT_ROWS);
        for (int32_t k = 0; k < x->rows; k++) q[k] = 0.0;
        for (int32_t i = 0, u = 0; i < x->contacts; i++) {
            const int32_t k = x->first[i];
            for (int32_t a = 0; s->walls.on[i] != IDLE
                                && a <= (s->walls.on[i] == PUSHES_STUCK ? impact_slips(x, i) : 0);
                 a++, u++) {
                const double weight = x->W[(int64_t)(k + a) * (x->rows + 1)];
                q[k + a] = weight > 0.0 ? solution[u] / sqrt(weight) : 0.0;
            }
            for (int32_t a = 1; a <= impact_slips(x, i) && s->walls.on[i] == PUSHES_SLIDING; a++)
                q[k + a] = q[k] * direction[k + a];
        }
    } while (joints && press_joints(x, q) > SWEEP_ROUND_OFF && ++presses < MOST_PRESSES);
}

/* Likewise, by the law: of those who push. */
HM_SELDOM static void rates_by_law(impact_path *s, double *gamma, double *q)
{
    double *const now = s->gamma;
    s->gamma = gamma;
    pack_rates(s, 0.0);
    s->gamma = now;
    for (int32_t k = 0; k < s->x->rows; k++) q[k] = 0.0;
    if (hm_solve_contacts(&s->rates, s->way_sign > 0.0 ? LEAST_WORK_IF_ANY : MOST_WORK)) {
        q[0] = NAN; /* no step ends here */
        return;
    }
    hm_share_impulses(&s->rates);
    for (int32_t c = 0; c < s->rates.contacts; c++)
        for (int32_t a = 0; a <= s->active.tangents[c]; a++)
            q[s->x->first[s->active.contact[c]] + a] = s->active.p[s->active.first[c] + a];
}

/* Size of p', over that of the rates that walls bring about; with the sign of what pushes. */
HM_SELDOM static double size_of_rates(const impact_path *s, const double *q)
{
    double largest = 0.0, walls = 0.0;
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const double root = sqrt(impact_weight(s->x, i)), rate = q[s->x->first[i]] * root;
        if (s->walls.on[i] == IDLE) continue;
        if (!(fabs(rate) <= fabs(largest))) largest = rate;
        walls = fmax(walls, fabs(s->walls.rate[i]) / root);
    }
    return walls > 0.0 ? largest / walls : 0.0;
}

/* p' (q) in the piece. Returns the rate of the clock in the step: 1, or, along impulses, less;
   below 0 where walls have to turn back. */
HM_SELDOM static double rates_in_piece(impact_path *s, double *gamma, double *q)
{
    if (s->by_law) rates_by_law(s, gamma, q);
    else rates_by_statuses(s, gamma, q);
    s->pace = 1.0;
    if (!s->by_path) return 1.0;
    const double pace = s->pace = 1.0 / size_of_rates(s, q);
    for (int32_t k = 0; k < s->x->rows; k++) q[k] *= pace;
    return pace;
}

/* One Runge-Kutta step of length h from the present state: impulses, works along normals and of
   friction (in `end`, rows + contacts + 1) and the way of the clock behind them, rates there (in
   `gamma`). Returns its error over what is allowed. */
HM_SELDOM static double try_turning(impact_path *s, double h, double *end, double *gamma)
{
    const hm_impact *x = s->x;
    const int32_t n = x->rows + x->contacts + 2;
    const runge_kutta *pair = &EIGHTH_ORDER;
    double *const sums = s->start;
    for (int stage = 0; stage < pair->stages; stage++) {
        double *slope = s->stage + (int64_t)n * stage, friction = 0.0;
        for (int32_t e = 0; e < x->rows; e++) {
            sums[e] = 0.0;
            for (int before = 0; before < stage; before++)
                sums[e] += pair->part[stage][before] * s->stage[(int64_t)n * before + e];
        }
        rates_of_impulses(x, sums, gamma);
        for (int32_t k = 0; k < x->rows; k++) gamma[k] = s->gamma[k] + h * gamma[k];
        slope[n - 1] = rates_in_piece(s, gamma, slope);
        for (int32_t i = 0; i < x->contacts; i++) {
            const int32_t k = x->first[i];
            slope[x->rows + i] = slope[k] * gamma[k];
            for (int32_t t = k + 1; t <= k + x->tangents[i]; t++) friction += slope[t] * gamma[t];
        }
        slope[n - 2] = friction;
    }
    double five = 0.0, three = 0.0;
    for (int side = 1; side >= 0; side--) {
        for (int32_t e = 0; e < n; e++) {
            sums[e] = 0.0;
            for (int stage = 0; stage < pair->stages; stage++)
                sums[e] += pair->difference[side][stage] * s->stage[(int64_t)n * stage + e];
        }
        rates_of_impulses(x, sums, gamma);
        for (int32_t k = 0; k < x->rows; k++) {
            const double error = s->size[k] > 0.0 ? h * gamma[k] / (SWEEP_ERROR * s->size[k]) : 0.0;
            if (side) three = fmax(three, fabs(error));
            else five = fmax(five, fabs(error));
        }
        for (int32_t e = x->rows; e < n - 1; e++) { /* works */
            const double error = fabs(h * sums[e]) / (10.0 * SWEEP_ERROR * s->energy);
            if (side) three = fmax(three, error);
            else five = fmax(five, error);
        }
    }
    for (int32_t e = 0; e < n; e++) {
        end[e] = 0.0;
        for (int stage = 0; stage < pair->stages; stage++)
            end[e] += h * pair->weight[stage] * s->stage[(int64_t)n * stage + e];
    }
    rates_of_impulses(x, end, gamma);
    for (int32_t k = 0; k < x->rows; k++) gamma[k] += s->gamma[k];
    const double both = sqrt(five * five + 0.01 * three * three);
    return both > 0.0 ? five * five / both : 0.0;
}

/* What must stay above 0 in a turning piece, each over its size: of the clock until the walls
   stand, and of each contact. */
enum { UNTIL_WALLS_STAND = -1, MARGIN_PUSHES, MARGIN_CONE, MARGIN_BUDGET, MARGIN_GAP, MARGINS };

/* The margin `which` (contact times MARGINS + kind) after a step that led to `end` and `gamma`,
   with p' there in q. */
HM_SELDOM static double margin_in_piece(const impact_path *s, int32_t which, const double *end,
                                        const double *gamma, const double *q)
{
    const hm_impact *x = s->x;
    const double way = end[x->rows + x->contacts + 1], rest = end_of_walls(s);
    if (which == UNTIL_WALLS_STAND) return rest < INFINITY ? rest - way : INFINITY;
    const int32_t i = which / MARGINS, k = x->first[i], n = impact_slips(x, i);
    const double size = size_of_rates(s, q);
    switch (which % MARGINS) {
    case MARGIN_PUSHES: {
        /* Where walls turn back, what they alone push stops to push and would pull. */
        const double turned = s->by_path && s->pace < PAST_TURN ? 3.0 * PAST_TURN : -1e-14;
        return s->walls.on[i] == IDLE ? INFINITY
                                : q[k] * impact_weight(x, i) / (fabs(size) * s->size[k]) + turned;
    }
    case MARGIN_CONE:
        if (s->walls.on[i] == PUSHES_BEGINNING)
            return 1.0 - hm_length(n, gamma + k + 1) / (HAS_BEGUN * s->size[k + 1]);
        if (s->walls.on[i] != PUSHES_STUCK || !n || s->by_law) return INFINITY;
        return 1.0 + CONE_LEFT - hm_length(n, q + k + 1) / (x->coefficient[i] * q[k]);
    case MARGIN_BUDGET:
        if (s->walls.on[i] == IDLE || !s->walls.live[i] || s->tau < 0.0
            || !(x->compression[i] > 0.0))
            return INFINITY;
        return (budget(s, i) - end[x->rows + i]) / x->compression[i];
    default:
        if (s->walls.on[i] != IDLE || !(impact_weight(x, i) > 0.0)) return INFINITY;
        return (gamma[k] - wall_now(s, i) - way * s->walls.rate[i]) / s->size[k]
               + 2.0 * SWEEP_ROUND_OFF;
    }
}

/* The margin that is farthest below 0, or -2. */
HM_SELDOM static int32_t margin_lost(impact_path *s, const double *end, double *gamma)
{
    double least = -1e-15, *q = s->start; /* room for rows */
    int32_t lost = -2;
    rates_in_piece(s, gamma, q);
    for (int32_t which = UNTIL_WALLS_STAND; which < MARGINS * s->x->contacts; which++) {
        const double margin = margin_in_piece(s, which, end, gamma, q);
        if (!(margin >= least)) least = margin, lost = which;
    }
    return lost;
}

/* Longest step that no slip which pushes is likely to stop in: nine tenths of the way, as it slows
   down now. */
HM_SELDOM static double before_stops(const impact_path *s)
{
    double h = INFINITY;
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const int32_t k = s->x->first[i], n = impact_slips(s->x, i);
        if (s->walls.on[i] != PUSHES_SLIDING || !n || !(slip_now(s, i) > none_of_slip(s, i)))
            continue;
        const double slip = slip_now(s, i);
        double growth = 0.0;
        for (int32_t a = 1; a <= n; a++) growth += s->gamma[k + a] / slip * s->turn[k + a];
        if (growth < 0.0) h = fmin(h, 0.9 * slip / -growth);
    }
    return h;
}

/* Whether a slip that pushes has stopped, or has turned by more than a step follows. */
HM_SELDOM static int slip_lost(const impact_path *s, const double *gamma)
{
    for (int32_t i = 0; i < s->x->contacts; i++) {
        const int32_t k = s->x->first[i], n = impact_slips(s->x, i);
        if (s->walls.on[i] != PUSHES_SLIDING || !n || !(slip_now(s, i) > none_of_slip(s, i)))
            continue;
        double along = 0.0;
        for (int32_t a = 1; a <= n; a++) along += s->gamma[k + a] * gamma[k + a];
        if (!(along > 0.5 * slip_now(s, i) * hm_length(n, gamma + k + 1))) return 1;
    }
    return 0;
}

static inline int slip_stops(const impact_path *s)
{
    for (int32_t i = 0; i < s->x->contacts; i++)
        if (impact_slips(s->x, i) && s->walls.on[i] == PUSHES_SLIDING && !s->walls.stuck[i]
            && slip_now(s, i) <= none_of_slip(s, i))
            return 1;
    return 0;
}

/* Rows bind slips to each other: what is left of one when another has stopped, less than round-off
   of velocities, may stay as long as the impact lasts, while its direction turns ever faster. Where
   a piece takes all its steps, more slip counts as stopped, by this factor. */
#define LESS_PATIENT 100.0
enum { MOST_TURNING_STEPS = 1000, MOST_SEARCHES = 60, MOST_REFUSED = 20 };

/* Shortens a step of length h to where the first margin vanishes (regula falsi); `lost` is one of
   those that are below 0 behind it. Returns the error of the step over what is allowed. */
HM_SELDOM static double end_of_piece(impact_path *s, int32_t lost, double h, double *end,
                                     double *gamma)
{
    const int32_t n = s->x->rows + s->x->contacts + 2;
    double *q = s->start, error = 0.0;
    for (int32_t turn = 0; turn <= s->x->contacts && lost > -2;
         turn++, lost = margin_lost(s, end, gamma)) {
        double low = 0.0, high = h;
        rates_in_piece(s, gamma, q);
        double at_high = margin_in_piece(s, lost, end, gamma, q);
        memset(end, 0, sizeof(double) * (size_t)n);
        rates_in_piece(s, s->gamma, q);
        double at_low = fmax(margin_in_piece(s, lost, end, s->gamma, q), 1e-15);
        for (int search = 0, side = 0; search < MOST_SEARCHES && high - low > 1e-15 * high;
             search++) {
            h = low + (high - low) * fmin(fmax(at_low / (at_low - at_high), 1e-9), 1.0 - 1e-9);
            error = try_turning(s, h, end, gamma);
            rates_in_piece(s, gamma, q);
            const double margin = margin_in_piece(s, lost, end, gamma, q);
            if (fabs(margin) <= 1e-15) break;
            if (margin > 0.0) {
                low = h, at_low = margin;
                if (side > 0) at_high *= 0.5;
                side = 1;
            } else {
                high = h, at_high = margin;
                if (side < 0) at_low *= 0.5;
                side = -1;
            }
        }
    }
    return error;
}

/* Follows a turning piece until an event; 0, or 1 if it does not get on. */
HM_SELDOM static int go_round(impact_path *s)
{
    hm_impact *x = s->x;
    const int32_t n = x->rows + x->contacts + 2;
    double *end = s->stage + 12 * (int64_t)n, *gamma = end + n, h = 0.1, done = 0.0;
    int refused = 0, step = 0;
    fix_statuses(s);
    for (; step < MOST_TURNING_STEPS; step++) {
        s->by_path = 0;
        rates_in_piece(s, s->gamma, s->q);
        const double size = size_of_rates(s, s->q);
        if (fabs(size) > LARGE_RATES) {
            s->by_path = 1;
            rates_in_piece(s, s->gamma, s->q);
        }
        rates_of_impulses(x, s->q, s->turn);
        if (done > 0.0 && (slip_stops(s) || !slip_turns(s))) break;
        const double rest = end_of_walls(s),
                     unit = s->by_path ? 1.0 / fabs(size) : 1.0; /* h is by the clock */
        h = fmin(fmin(h, rest), before_stops(s) * unit);
        if (!(h > 1e-16 * unit)) break;
        const double error = try_turning(s, h / unit, end, gamma);
        if (!(error <= 1.0) || slip_lost(s, gamma)) {
            h *= error > 1.0 && error < INFINITY ? fmax(0.2, 0.9 * hm_pow(error, -0.125)) : 0.25;
            continue;
        }
        const int32_t lost = margin_lost(s, end, gamma);
        if (lost > -2) {
            const double inaccuracy = end_of_piece(s, lost, h / unit, end, gamma);
            if ((!(inaccuracy <= 1.0) || slip_lost(s, gamma)) && refused++ < MOST_REFUSED) {
                h *= 0.25; /* what was lost may be an artefact of a stage behind the event */
                continue;
            }
        }
        const double way = end[n - 1], pace = rates_in_piece(s, gamma, s->start);
        memcpy(s->q, end, sizeof(double) * (size_t)x->rows);
        grow_sizes(s, 1.0);
        for (int32_t i = 0; i < x->contacts; i++) book_normal(s, i, end[x->rows + i]);
        x->friction -= end[n - 2];
        for (int32_t k = 0; k < x->rows; k++) x->impulse[k] += end[k];
        memcpy(s->gamma, gamma, sizeof(double) * (size_t)x->rows);
        const int at_rest = fabs(rest - way) <= 1e-14;
        const int is_back = move_walls(s, at_rest ? rest : way);
        done += h;
        if (lost > -2 || at_rest || is_back || !(pace > -PAST_TURN)) break;
        h *= fmin(6.0, 0.9 * hm_pow(fmax(error, 1e-10), -0.125));
    }
    s->by_law = 0;
    if (step == MOST_TURNING_STEPS) s->patience *= LESS_PATIENT;
    return !(done > 0.0);
}

#endif
