/* Second stage of a half step of stepped mode: velocities change alone, at q_1.

   Where contacts land, the law of impact of located mode acts at q_1 (impact_sweep.h) on all that
   touch in their islands: closed ones have no restitution. The velocities before are those of the
   first stage without its impulses in contacts and joints that rub: all but the part 1 - kappa of
   the normal ones of landing contacts. These impulses took energy; kappa = 1 + O(h) is such that
   all of that is given back, a quadratic equation, so that an impact loses what its law says,
   wherever in the half step it falls.

   In islands where none lands, what holds has no rate. That is so, too, where so much touches that
   the path of an impact takes longer than the step, or hits one by one do not end: landing
   contacts then part with rates f e
   |g'_0|, without friction, such that e^2 of what both stages take with f = 0 is given back. */
#ifndef HOLONOM_VELOCITY_STAGE_H
#define HOLONOM_VELOCITY_STAGE_H

#include "half_step_contacts.h"

/* How a contact takes part in the second stage: RUBS, was closed before, in a half step whose
   frictions are deferred. */
enum { IS_HELD, LANDS, LANDS_AMONG_MANY, RUBS };
/* Of contacts, frictions and joints that rub: dense matrices of theirs are factored for each piece
   of a path. */
enum { MANY_ROWS = 60 };

static double booked(const context *c, int account)
{ return c->s.head[account] + c->s.head[account + 1]; }

/* Keeps what contacts and frictions did in the first stage, which is at hand: impulses against all
   rows (in event_mu), and energies. */
static void keep_first_stage(const context *c)
{
    for (int32_t i = 0; i < c->m->n_rows; i++) c->k.event_mu[i] = c->h * c->k.mu[i];
    EACH_CONTACT(c, i) {
        const int32_t row = row_of(c, c->m->contact_row[i]);
        touch_of(c, i)->lands = is_landing(c, i)                        ? LANDS
                                : is_closed(c, i) && c->friction.is_deferred ? RUBS
                                                                        : IS_HELD;
        touch_of(c, i)->taken = is_closed(c, i) ? c->k.mu[row] * c->k.change[row] : 0.0;
    }
    EACH_FRICTION(c, f) {
        c->k.rubbed[f] = 0.0;
        for (int k = 0; k < n_slips(c, f) && friction_mode(c, f) != FRICTION_OFF; k++) {
            const int32_t row = row_of(c, slip_row(c, f, k));
            c->k.rubbed[f] += c->k.mu[row] * c->k.change[row];
        }
    }
}

/* Whether composite j, a row, is of that island. */
static int is_of_island(const context *c, int32_t j, int32_t island)
{
    const int32_t *begin = c->m->island_begin + ISLAND_COLUMNS * island;
    return j >= begin[ISLAND_FUNCTION] && j < begin[ISLAND_COLUMNS + ISLAND_FUNCTION];
}

/* Whether a contact of that island takes part so. */
static int island_has(const context *c, int32_t island, int how)
{
    EACH_CONTACT(c, i)
        if (touch_of(c, i)->lands == how && is_of_island(c, c->m->contact_row[i], island)) return 1;
    return 0;
}

/* Whether the law of impact acts on that island. */
static int is_hit(const context *c, int32_t island)
{ return island_has(c, island, LANDS) || island_has(c, island, RUBS); }

static inline int has_landed(const touch *x)
{ return x->lands == LANDS || x->lands == LANDS_AMONG_MANY; }

/* Restitution of contact i. A flight that begins and ends in one half step is the last one, unless
   nothing is lost. */
static double restitution_in_step(const context *c, int32_t i)
{
    const touch *x = touch_of(c, i);
    const double e = has_landed(x) ? c->number[c->m->restitution_at + i] : 0.0;
    return e < 1.0 && x->gap <= gap_tolerance(c) && x->rate > 0.0 ? 0.0 : e;
}

/* Collects what touches in that island, and joints that rub, with what the first stage did there:
   impulses to be taken out as a whole, those of the normals of landing contacts, and energies
   taken. Returns 0 if these are many. */
static int collect_landing(const context *c, hit *x, int32_t island, double *taken, double *rubbed)
{
    *taken = *rubbed = 0.0;
    EACH_CONTACT(c, i) {
        const touch *own = touch_of(c, i);
        if (!is_of_island(c, c->m->contact_row[i], island)
            || !(is_closed(c, i) || gap_of(c, i) <= gap_tolerance(c)))
            continue;
        if (!add_to_hit(c, x, i, restitution_in_step(c, i))) return 0;
        *taken += own->taken;
        if (c->m->contact_friction[i] >= 0) *rubbed += c->k.rubbed[c->m->contact_friction[i]];
    }
    const int one_by_one = c->s.head[S_IMPACT_LAW] != 0.0;
    if (!add_joints_to_hit(c, x) || (x->law.rows > MANY_ROWS && !one_by_one)) return 0;
    for (int32_t k = 0; k < x->law.contacts; k++) {
        const int32_t i = x->contact[k], first = x->first[k];
        for (int32_t r = first; r <= first + x->tangents[k]; r++) {
            x->out[r] = x->row[r] < 0 ? 0.0 : -c->k.event_mu[row_of(c, x->row[r])];
            x->normal[r] = 0.0;
        }
        if (i < 0) *rubbed += c->k.rubbed[-1 - i];
        else if (has_landed(touch_of(c, i))) x->normal[first] = x->out[first], x->out[first] = 0.0;
    }
    return 1;
}

/* Part of the impulses x->normal to be taken out, with all of x->out, that gives back what was
   `taken`: the larger root of the energies; negative: there is none. */
static double part_taken_out(const hit *x, double taken)
{
    const int32_t n = x->law.rows;
    double square = 0.0, linear = 0.0, rest = -taken;
    for (int32_t r = 0; r < n; r++) {
        double by_normal = 0.0, by_others = 0.0;
        for (int32_t s = 0; s < n; s++) {
            by_normal += x->W[(int64_t)n * r + s] * x->normal[s];
            by_others += x->W[(int64_t)n * r + s] * x->out[s];
        }
        square += 0.5 * x->normal[r] * by_normal;
        linear += x->normal[r] * (by_others - x->before[r]);
        rest += x->out[r] * (0.5 * by_others - x->before[r]);
    }
    const double root2 = linear * linear - 4.0 * square * rest;
    return square > 0.0 && root2 >= 0.0 ? 0.5 * (sqrt(root2) - linear) / square : -1.0;
}

/* Takes these impulses out of the rates before, and tells all in x->out. Where the others alone
   would give back more than was taken, the same part of all of them goes. Where none `lands` all of
   them go. */
static void take_out(context *c, const hit *x, double taken, int lands)
{
    const int32_t n = x->law.rows;
    double part = lands ? part_taken_out(x, taken) : 0.0;
    if (part < 0.0) {
        for (int32_t r = 0; r < n; r++) x->normal[r] += x->out[r], x->out[r] = 0.0;
        part = fmax(part_taken_out(x, taken), 0.0);
        c->s.head[S_MIXED_IMPACTS] += 1.0;
    }
    for (int32_t r = 0; r < n; r++) x->out[r] += part * x->normal[r];
    for (int32_t r = 0; r < n; r++)
        for (int32_t s = 0; s < n; s++) x->before[r] -= x->W[(int64_t)n * r + s] * x->out[s];
}

/* Restitution of contact k of an impact that approaches at that rate, of those that `rebound`. */
static double restitution_of_hit(const context *c, const hit *x, int32_t k, double rate,
                                 int rebounds)
{
    const int is_fast = -rate > fmax(c->s.head[S_REST_SPEED], speed_tolerance(c));
    return !is_fast || x->contact[k] < 0 ? 0.0
           : rebounds                    ? c->number[c->m->restitution_at + x->contact[k]]
                                         : x->restitution[k];
}

/* Lets the rows of all contacts take part, or those of contact `alone` and of joints that rub, from
   rates at hand: of the others W and rates are 0. */
static void let_take_part(const hit *x, const double *W, const double *rate, int32_t alone)
{
    const int32_t n = x->law.rows;
    for (int32_t k = 0; k < x->law.contacts; k++) {
        const int acts = alone < 0 || k == alone || x->contact[k] < 0;
        for (int32_t r = x->first[k]; r <= x->first[k] + x->tangents[k]; r++) {
            x->before[r] = acts ? rate[r] : 0.0;
            for (int32_t s = 0; s < n; s++)
                x->W[(int64_t)n * r + s] = acts ? W[(int64_t)n * r + s] : 0.0;
        }
    }
    for (int32_t k = 0; k < x->law.contacts && alone >= 0; k++)
        for (int32_t s = x->first[k];
             s <= x->first[k] + x->tangents[k] && k != alone && x->contact[k] >= 0; s++)
            for (int32_t r = 0; r < n; r++) x->W[(int64_t)n * r + s] = 0.0;
}

/* Impulses by the sequential law: the contact that approaches fastest is hit alone, again and
   again, until none approaches. What was closed rebounds if others drive it together. One that does
   not rebound takes along all that touch. The rate before of a contact that is hit is then that of
   its first hit. 0, or 1 if no impulses were found. */
static int solve_in_sequence(context *c, hit *x)
{
    const int32_t n = x->law.rows;
    double *W = c->k.rest, *rate = W + (int64_t)n * n, *impulse = rate + n, *before = impulse + n,
           *own = before + n;
    int status = 0;
    memcpy(W, x->W, sizeof(double) * (size_t)n * (size_t)n);
    memcpy(rate, x->before, sizeof(double) * (size_t)n);
    memcpy(own, x->restitution, sizeof(double) * (size_t)n);
    for (int32_t r = 0; r < n; r++) impulse[r] = 0.0;
    for (int32_t k = 0; k < x->law.contacts; k++) {
        const int lands = x->contact[k] >= 0 && has_landed(touch_of(c, x->contact[k]));
        before[x->first[k]] = lands ? rate[x->first[k]] : 0.0;
    }
    for (int hits = 0; !status; hits++) {
        int32_t fastest = -1;
        double most = -speed_tolerance(c);
        for (int32_t k = 0; k < x->law.contacts; k++)
            if (x->contact[k] >= 0 && rate[x->first[k]] < most)
                most = rate[x->first[k]], fastest = k;
        if (fastest < 0) break;
        memcpy(x->restitution, own, sizeof(double) * (size_t)n);
        const int alone = restitution_of_hit(c, x, fastest, most, hits > 0) > 0.0;
        for (int32_t k = 0; k < x->law.contacts; k++)
            x->restitution[k] = restitution_of_hit(c, x, k, rate[x->first[k]], hits > 0);
        if (alone && before[x->first[fastest]] == 0.0) before[x->first[fastest]] = most;
        let_take_part(x, W, rate, alone ? fastest : -1);
        status = hits == MOST_SEQUENTIAL || solve_hit(c, x);
        for (int32_t r = 0; r < n; r++) {
            impulse[r] += x->law.impulse[r];
            for (int32_t s = 0; s < n; s++) rate[r] += W[(int64_t)n * r + s] * x->law.impulse[s];
        }
    }
    memcpy(x->law.impulse, impulse, sizeof(double) * (size_t)n);
    memcpy(x->before, before, sizeof(double) * (size_t)n);
    return status;
}

/* Impulses by the law of the scene; 0, or 1 if none were found. */
static int solve_landing(context *c, hit *x)
{
    if (c->s.head[S_IMPACT_LAW] != 0.0) return solve_in_sequence(c, x);
    for (int32_t k = 0; k < x->law.contacts; k++)
        x->restitution[k] = restitution_of_hit(c, x, k, x->before[x->first[k]], 0);
    return solve_hit(c, x);
}

/* Counts impacts and impulses, and closes what does not part. */
static void end_landing(context *c, const hit *x)
{
    evaluate_state(c);
    for (int32_t k = 0; k < x->law.contacts; k++) {
        const int32_t i = x->contact[k], r = x->first[k];
        if (i < 0) {
            friction_of(c, -1 - i)[F_MODE] = FRICTION_OFF;
            guess_friction(c, -1 - i);
            continue;
        }
        double *own = contact_of(c, i);
        const int closed = is_closed(c, i);
        own[C_IMPULSE] += x->law.impulse[r] + x->out[r];
        const int is_hit = x->before[r] < -speed_tolerance(c),
                  in_sequence = is_hit && c->s.head[S_IMPACT_LAW] != 0.0;
        if (has_landed(touch_of(c, i)) || in_sequence) {
            own[C_IMPACTS] += is_hit ? 1.0 : 0.0;
            c->s.head[S_EVENTS] += 1.0;
        }
        open_contact(c, i);
        if (!(gap_rate(c, i) > speed_tolerance(c)))
            close_contact_at(c, i, closed ? own[C_REFERENCE] : 0.0);
    }
}

/* Lets the contacts that land in that island part without friction, in the other stage. */
static void let_land_among_many(const context *c, int32_t island)
{
    EACH_CONTACT(c, i)
        if (is_of_island(c, c->m->contact_row[i], island))
            touch_of(c, i)->lands = touch_of(c, i)->lands == LANDS ? LANDS_AMONG_MANY : IS_HELD;
}

/* The impact of an island in which contacts land, or its friction that was deferred. */
static int32_t land(context *c, int32_t island)
{
    const int lands = island_has(c, island, LANDS);
    const double before = booked(c, S_IMPACT);
    const size_t modes = sizeof(double) * (size_t)c->s.n_modes;
    double taken, rubbed;
    hit x;
    map_hit(c, &x);
    if (!collect_landing(c, &x, island, &taken, &rubbed)) {
        let_land_among_many(c, island);
        return HOLONOM_OK;
    }
    memcpy(c->k.rest_modes, c->s.contacts, modes);
    open_all(c);
    const double kinetic = kinetic_energy(c, c->k.momentum);
    int32_t status = fill_hit(c, &x);
    if (!status) {
        take_out(c, &x, taken + rubbed, lands);
        status = solve_landing(c, &x) ? HOLONOM_IMPACT_UNSOLVED : HOLONOM_OK;
    }
    if (status == HOLONOM_IMPACT_UNSOLVED && x.law.rows > MANY_ROWS) {
        add_defect(c, -1.0);
        memcpy(c->s.contacts, c->k.rest_modes, modes);
        let_land_among_many(c, island);
        return HOLONOM_OK;
    }
    for (int32_t r = 0; r < x.law.rows; r++) x.law.impulse[r] -= x.out[r];
    if (!status) status = apply_impulses(c, &x, kinetic);
    book(c, S_FRICTION, -rubbed); /* what friction takes in an impact is the impact's */
    book(c, S_IMPACT, rubbed);
    if (!lands) { /* its contacts stay closed: what they take is friction's */
        const double loss = booked(c, S_IMPACT) - before;
        book(c, S_IMPACT, -loss);
        book(c, S_FRICTION, loss);
    }
    memcpy(c->s.contacts, c->k.rest_modes, modes);
    if (!status) end_landing(c, &x);
    return status;
}

/* ------------------------------------------------------------------------------ without landing */

static int island_has_contact(context *c)
{
    EACH_IN(c, composites, composite, j)
        if (is_row(c, j) && owner_of(c, j) >= 0 && state_of_row(c, j) != ROW_IS_OFF) return 1;
    return 0;
}

/* Rates of rows that are to vanish (in phi): of islands in which a contact is closed and none has
   landed. Returns whether there are such. */
static int rates_to_stop(context *c)
{
    int holds = 0;
    memset(c->k.phi, 0, sizeof(double) * (size_t)c->m->n_rows);
    rates_of_turns(c, c->k.hit_defect);
    for (int32_t island = 0; island < c->m->n_islands; island++) {
        select_islands(c, island, island + 1);
        if (island_has_contact(c) && !is_hit(c, island)) {
            holds = 1;
            continue;
        }
        EACH_ROW(c, i) c->k.phi[i] = 0.0;
        clear_nodes(c, c->k.hit_defect);
    }
    select_islands(c, 0, c->m->n_islands);
    return holds;
}

/* Work of impulses (in mu) of the rows at hand: what signals and surfaces move, as far as rows ask
   of what stands still. */
static double work_of_impulses(const context *c)
{
    double *rest = c->k.ahead, *rate = c->k.row_rate, work = 0.0;
    clear_nodes(c, rest);
    row_rates(c, rest, c->k.signal_rate, rate);
    EACH_ROW(c, i) work += c->k.mu[i] * rate[i];
    return work;
}

/* Adds x to the velocities and books what its impulses (in mu) take, and the work. */
static void add_velocities(context *c, const double *x, int driven)
{
    const double work = driven ? work_of_impulses(c) : 0.0;
    const double loss = work - mass_product(c, x, c->s.v) - 0.5 * mass_product(c, x, x);
    double friction = 0.0;
    for (int side = 0; side < 2; side++) {
        EACH_FRICTION(c, f)
            for (int k = 0; k < n_slips(c, f); k++) {
                const int32_t j = slip_row(c, f, k);
                if (state_of_row(c, j) != ROW_IS_OFF)
                    friction += 0.5 * c->k.mu[row_of(c, j)] * rate_of_row(c, j);
            }
        for (int32_t k = 0; k < DIM * c->m->n_free && !side; k++)
            hm_add(c->s.v + k, c->s.v_low + k, x[k]);
    }
    book(c, S_FRICTION, friction);
    book(c, S_IMPACT, loss - friction);
    if (driven) book(c, S_WORK, work);
}

/* Lets those frictions stick whose slip has been reversed; joints slide the other way. */
static int stop_reversed(context *c)
{
    int stops = 0;
    EACH_FRICTION(c, f) {
        if (friction_mode(c, f) != FRICTION_SLIDES || is_smooth(c, f)
            || !(slip_along(c, f) < -speed_tolerance(c)))
            continue;
        if (!is_of_contact(c, f)) {
            guess_friction(c, f);
            continue;
        }
        let_stick(c, f);
        stops = 1;
    }
    return stops;
}

/* Lets frictions slide on that would be stopped by a larger impulse (in mu) than that of their
   cones in the half step: at a dead centre, where the mechanism hardly slips however fast it moves.
   Returns whether there are such. */
static int tear_loose_in_step(context *c)
{
    int tears = 0;
    EACH_FRICTION(c, f) {
        if (friction_mode(c, f) != FRICTION_STICKS || !(slip_of(c, f, NULL) > speed_tolerance(c)))
            continue;
        const double impulse = cone(c, f, 0, normal_force(c, f, c->k.event_mu) / c->h) * c->h;
        if (!(friction_force(c, f, c->k.mu, NULL) > 2.0 * impulse)) continue;
        guess_friction(c, f);
        tears = 1;
    }
    return tears;
}

/* Adds to velocities that stop, whose impulses are in mu, those with which contacts that land among
   many part. */
static void add_parting(context *c, double *stop)
{
    const int32_t n = DIM * c->n_moving, rows = c->m->n_rows;
    double *part = c->k.free,
           lost = -mass_product(c, stop, c->s.v) - 0.5 * mass_product(c, stop, stop), given = 0.0,
           all = 0.0;
    memcpy(c->k.event_mu, c->k.mu, sizeof(double) * (size_t)rows);
    memset(c->k.phi, 0, sizeof(double) * (size_t)rows);
    EACH_CONTACT(c, i) {
        const touch *x = touch_of(c, i);
        const int32_t row = row_of(c, c->m->contact_row[i]);
        const double weight = hm_square(x->rate) / c->number[c->m->row_sigma_at + row];
        if (x->lands != LANDS_AMONG_MANY || !(x->rate < 0.0)) continue;
        lost += x->taken;
        all += weight;
        contact_of(c, i)[C_IMPACTS] += x->rate < -speed_tolerance(c) ? 1.0 : 0.0;
        c->s.head[S_EVENTS] += 1.0;
        if (!(-x->rate > fmax(c->s.head[S_REST_SPEED], speed_tolerance(c)))) continue;
        given += hm_square(c->number[c->m->restitution_at + i]) * weight;
        c->k.phi[row] = c->number[c->m->restitution_at + i] * x->rate;
    }
    if (!(given > 0.0)) return;
    c->s.head[S_MIXED_IMPACTS] += 1.0;
    velocities_for(c, part);
    const double curved = 0.5 * mass_product(c, part, part), back = given / all * fmax(lost, 0.0);
    const double linear = mass_product(c, part, c->s.v) + mass_product(c, part, stop);
    const double root = linear + sqrt(fmax(linear * linear + 4.0 * curved * back, 0.0)),
                 f = root > 0.0 ? 2.0 * back / root : 0.0;
    for (int32_t k = 0; k < n; k++) stop[k] += f * part[k];
    for (int32_t i = 0; i < rows; i++) c->k.mu[i] = c->k.event_mu[i] + f * c->k.mu[i];
}

/* Takes the rates of rows that are on, or only the slips of frictions that stick. */
static int32_t hold(context *c, int slips_alone)
{
    const int driven = is_driven(c);
    int32_t status = HOLONOM_OK;
    for (int again = 1; again && !status;) {
        suspend_sliding(c, 1);
        stand_still(c);
        if (!slips_alone) {
            forget_dependent_rows(c);
            judge_rows(c, NULL);
        }
        status = factorise_at_state(c);
        if (!status && slips_alone) {
            memset(c->k.phi, 0, sizeof(double) * (size_t)c->m->n_rows);
            EACH_FRICTION(c, f)
                for (int k = 0; k < n_slips(c, f) && friction_mode(c, f) == FRICTION_STICKS; k++)
                    c->k.phi[row_of(c, slip_row(c, f, k))] = rate_of_row(c, slip_row(c, f, k));
        }
        again = 0;
        if (!status && (slips_alone || rates_to_stop(c))) {
            if (slips_alone) velocities_for(c, c->k.hit_defect);
            else follow_turns_by(c, c->k.hit_defect);
            again = tear_loose_in_step(c);
            if (!again && !slips_alone) add_parting(c, c->k.hit_defect);
            if (!again) add_velocities(c, c->k.hit_defect, driven);
        }
        suspend_sliding(c, 0);
    }
    return status;
}

/* ----------------------------------------------------------------------------------------- both */

static int32_t change_velocities(context *c)
{
    int32_t status = HOLONOM_OK;
    keep_first_stage(c);
    evaluate_state(c);
    const int deferred = c->friction.is_deferred;
    c->friction.is_deferred = 0;
    for (int32_t i = 0; i < c->m->n_contacts && deferred; i++)
        if (is_closed(c, i) && c->m->contact_friction[i] >= 0)
            guess_friction(c, c->m->contact_friction[i]);
    for (int32_t island = 0; island < c->m->n_islands && !status; island++)
        if (is_hit(c, island)) status = land(c, island);
    if (!status) status = hold(c, 0);
    if (!status && stop_reversed(c)) status = hold(c, 1);
    if (status) return status;
    EACH_CONTACT(c, i)
        if (is_closed(c, i) && gap_rate(c, i) > speed_tolerance(c)) open_contact(c, i);
    return status;
}

#endif
