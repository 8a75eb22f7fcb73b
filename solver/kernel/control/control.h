/* Internal steps as long, and of the order, that a tolerance asks for.

   A step may add tolerance h/horizon, so that a run over the horizon ends with an error of the
   tolerance, and what steps before it have left of theirs: where a few steps fill a communication
   step, one step less is often only a little too few. */
#ifndef HOLONOM_CONTROL_H
#define HOLONOM_CONTROL_H

#include "estimate.h"
#include "stepped.h"
#include "side_changes.h"

enum { MAX_REPEATS = 40 };
#define SAFETY 0.5    /* of what a step may add, aimed at */
#define MOST_AIMED 1.5 /* times what a step may add, aimed at where steps before have added less */
#define REJECTED 2.0  /* times what a step may add, at which it is repeated */
#define REJECTED_EXPLICIT 4.0 /* likewise of an explicit one, which costs more to repeat */
#define SLIVER                                                                                     \
    1e-3 /* part of a step: what is shorter before a point of the grid belongs to the next step */
#define STRETCHED 1.1 /* times the length wanted, where that spares a step */
#define SHORTER                                                                                    \
    5.0 /* runs begin with pairs where springs are faster than the motion by this, and would be    \
           all that others show */
#define COVERED_TURN 0.8 /* of springs in a cover, over that in an explicit step */
#define LITTLE_TURN                                                                                \
    0.05 /* of the motion, or a body, in a pair that takes the place of an explicit step [rad] */
#define PRESENT 0.9 /* times its cost, of the method that is in use */
#define MOST_HALF_STEPS 2e6 /* in a communication step, those that are repeated included */
#define OF_LIGHT_NODES 4.0 /* error that a swinging light node ends with, over what steps tell */
#define OFTEN 0.05 /* changes of sides for a half step, which take half steps for themselves */
/* Of pieces in a communication step: 20 halvings of each of 50 slips that stop. */
enum { MOST_CUTS = 1000 };
#define MOMENT                                                                                     \
    1e4 /* half steps for which steps may be short where a contact changes or a force jumps: they  \
           foretell nothing */

/* Number of equal steps of at most a length that cover a time. */
static double steps_over(const context *c, double time, double longest)
{
    return fmax(1.0, ceil(time / fmin(longest, c->s.head[S_LONGEST_STEP]) * (1.0 - 1e-10)));
}

/* Longest cover: weights swing springs up that it does not resolve. Where dampers are strong, and
   where nothing tells how fast springs are, it may be of any length. */
static double longest_cover(const context *c)
{
    const double longest = COVERED_TURN * longest_of(c, 8);
    return longest > 0.0 && knows_rates(c) ? longest : INFINITY;
}

/* Longest of the next steps, in equal parts of a time: they may add what steps before them have
   left. */
static double longest_next(const context *c, double time)
{
    const double *head = c->s.head,
                 share = SAFETY + fmax(0.0, head[S_UNSPENT]) * head[S_HORIZON] / time;
    double h = STRETCHED * head[S_WANTED];
    if (h < time)
        h = fmax(h, hm_pow(fmin(MOST_AIMED, share) / SAFETY, 1.0 / head[S_ORDER_IN_USE])
                        * head[S_WANTED]);
    if (head[S_EXPLICIT] != 0.0) return fmin(h, longest_now(c, (int)head[S_ORDER_IN_USE]));
    return head[S_ORDER_IN_USE] > 2.0 ? fmin(h, longest_cover(c)) : h;
}

/* Length of a step that adds what it may where the motion changes at a rate. A difference of
   explicit steps tells nothing of a body that spins steadily, which is exact there, and not in half
   steps. */
static double length_for(const context *c, const method *x, const step_error *e)
{
    const int is_explicit = x->kind == EXPLICIT;
    const double rate = is_explicit ? e->free : e->rate;
    const double may =
        SAFETY * tolerated(c) / (c->last.growth * x->mean * rate * c->s.head[S_HORIZON]);
    const double h = fmin(hm_pow(may, 1.0 / x->order), x->fastest) / rate;
    if (is_explicit)
        return fmin(h, fmin(c->last.longest_put_back, longest_now(c, x->order) / STRETCHED));
    return c->last.method == EXPLICIT ? fmin(h, LITTLE_TURN / hm_hypot(rate, fastest_turn(c))) : h;
}

/* Cost of a step in increments of Newton's iteration: each half step has some where the motion
   turns by so much in a step, and a beginning and an end that take as long as two; a stage takes as
   long as four. Dampers settle within long covers. */
static double cost_of(const method *x, double turned)
{
    return x->solutions
           * (x->kind == EXPLICIT  ? 4.0
              : x->kind == COVERED ? 4.0 + 4.0 * turned
                                   : 3.0 + 1.5 * turned);
}

/* Whether nothing has a mass, which would measure errors. */
static int is_massless(const context *c) { return !(c->number[c->m->extent_at + 1] > 0.0); }

/* Whether steps of a tolerance may be explicit: `fastest` asks for them. */
static int takes_explicit(const context *c)
{ return c->s.head[S_METHOD] != 0.0 && may_step_explicitly(c); }

/* Whether a tolerance may take steps so: of the order asked for, or of order 2 where springs are
   much too fast for covers. */
static int may_take(const context *c, const method *x, const step_error *e)
{
    const int asked = (int)c->s.head[S_ORDER];
    if (asked && x->order != asked
        && !(x->kind == COMPOSED
             && length_for(c, method_of(asked, 0), e) > SHORTER * longest_cover(c)))
        return 0;
    if (x->order == 6 && !asked && has_strong_dampers(c))
        return 0; /* whose differences tell least */
    if (x->kind == EXPLICIT) return takes_explicit(c);
    if (c->last.method == EXPLICIT && c->m->n_signals && longest_now(c, 8) > 0.0)
        return 0; /* explicit steps tell nothing of what drivers move */
    return x->kind == COMPOSED || !is_massless(c);
}

/* Order and length of the steps to come, for the least cost of a communication step of length
   `step`. */
static void choose_method(context *c, const step_error *e, double step)
{
    double *head = c->s.head, least = INFINITY;
    const method *present = method_of((int)head[S_ORDER_IN_USE], head[S_EXPLICIT] != 0.0),
                 *best = present;
    for (const method *x = METHODS; x < METHODS + N_METHODS; x++) {
        if (!may_take(c, x, e)) continue;
        const double n = steps_over(
            c, step,
            STRETCHED
                * fmin(length_for(c, x, e), x->kind == COVERED ? longest_cover(c) : INFINITY));
        const double cost = n * cost_of(x, e->rate * step / n) * (x == present ? PRESENT : 1.0);
        if (!(cost < least)) continue;
        least = cost;
        best = x;
        if (x->kind == COMPOSED && n == 1.0) break; /* nothing costs less than one pair */
    }
    if (best == present && head[S_EXPLICIT] == (best->kind == EXPLICIT)
        && (c->last.method == best->kind || c->last.finest))
        return;
    head[S_ORDER_IN_USE] = best->order;
    head[S_EXPLICIT] = best->kind == EXPLICIT;
    head[S_WANTED] = length_for(c, best, e);
}

/* Order to begin with, and a length that is safe: a part of the time in which the motion changes.
   With dampers order 2 is the one for wide tolerances and strong dampers; its first pairs are
   shorter. From rest the motion tells no length, and order 4 judges itself. */
static void begin_control(context *c)
{
    double *head = c->s.head;
    const double asked = head[S_ORDER],
                 rate =
                     hm_hypot(rate_of_motion(c), head[S_WANTED] > 0.0 ? 0.0 : rate_of_springs(c));
    const int may_look = knows_rates(c), is_new = head[S_ORDER_IN_USE] == 0.0;
    c->step.damped = is_dissipative(c);
    c->last.longest_put_back = INFINITY;
    /* Pairs may be of any length: springs are looked at again where other steps come up. */
    const int are_pairs = head[S_ORDER_IN_USE] == 2.0 && head[S_EXPLICIT] == 0.0;
    if (may_look && !ends_explicitly(c) && !are_pairs) find_longest(c);
    const double eighth = is_new && rate > 0.0 ? 0.5 * hm_pow(c->tolerance, 1.0 / 9.0) / rate : 0.0;
    const int is_stiff = eighth > SHORTER * longest_of(c, 8) && longest_cover(c) < INFINITY;
    if (!takes_explicit(c) || longest_of(c, 8) == 0.0) head[S_EXPLICIT] = 0.0;
    else if (is_new) head[S_EXPLICIT] = (asked == 0.0 || asked == 8.0) && !is_stiff;
    if (head[S_EXPLICIT] != 0.0) head[S_ORDER_IN_USE] = is_new ? 8.0 : head[S_ORDER_IN_USE];
    else if (is_massless(c) || (is_new && is_stiff)) head[S_ORDER_IN_USE] = 2.0;
    else if (asked > 0.0 && (is_new || head[S_ORDER_IN_USE] != 2.0)) head[S_ORDER_IN_USE] = asked;
    else if (is_new) head[S_ORDER_IN_USE] = c->step.damped && rate > 0.0 ? 2.0 : 4.0;
    else if (head[S_ORDER_IN_USE] == 5.0) head[S_ORDER_IN_USE] = 6.0;
    if (head[S_WANTED] > 0.0) return;
    const double turned =
        (c->step.damped ? 0.25 : 0.5) * hm_pow(c->tolerance, 1.0 / (head[S_ORDER_IN_USE] + 1.0));
    head[S_WANTED] = rate > 0.0 ? turned / rate : INFINITY;
}

/* Takes from the last step, of length h, length and order of the next ones; 1 if it is to be
   repeated with shorter ones. */
static int judge_step(context *c, double h, double step)
{
    double *head = c->s.head;
    step_error e = {0};
    const int found = c->last.finest ? 2 : (int)head[S_ORDER_IN_USE],
              is_explicit = c->last.method == EXPLICIT;
    const int judged = estimate_error(c, h, &e);
    const double defect = is_explicit ? 0.0 : velocity_defect(c, h);
    const double across = REJECTED * (defect - head[S_ACROSS]) / (ACROSS_ROWS * tolerated(c));
    head[S_ACROSS] = defect;
    double share = 0.0;
    if (!judged && across <= REJECTED) return 0;
    if (judged) share = e.mean * head[S_HORIZON] / (h * tolerated(c));
    if (judged && e.is_noise) share = fmin(share, SAFETY);
    share = fmax(fmax(share, e.settled / tolerated(c)), across);
    /* Where a mechanism almost stands, little energy is much velocity. */
    if (c->last.method != COMPOSED && !c->last.finest
        && !is_noise(c, ENERGY_ROUND_OFF, c->last.energy_correction, h))
        share = fmax(share, c->last.energy_correction * head[S_HORIZON] / (h * tolerated(c)));
    const double change =
        share * (double)(1 << found) > SAFETY ? hm_pow(SAFETY / share, 1.0 / found) : 2.0;
    head[S_WANTED] = h * fmax(change, SHORTEST);
    if (is_explicit) head[S_WANTED] = fmin(head[S_WANTED], c->last.longest_put_back);
    if (share > (is_explicit ? REJECTED_EXPLICIT : REJECTED)) return 1;
    head[S_ERROR_ESTIMATE] +=
        (judged && e.is_hidden ? OF_LIGHT_NODES : 1.0) * share * h * tolerated(c) / head[S_HORIZON];
    if (judged) head[S_LAST_RATE] = e.rate_of_all;
    /* Never more than a run may add; round-off earns nothing, and a piece that an event cuts is
       judged as it was before. */
    const double left = judged && !e.is_noise && !is_unilateral(c->m)
                            ? (SAFETY - share) * h / head[S_HORIZON]
                            : 0.0;
    head[S_UNSPENT] = fmin(SAFETY, head[S_UNSPENT] + left);
    if (judged && e.rate > 0.0) choose_method(c, &e, step);
    return 0;
}

/* Velocities across the rows add up from step to step, however little each one adds: more than one
   may add is put back. */
HM_SELDOM static void bound_across(context *c)
{
    if (!(c->s.head[S_ACROSS] > ACROSS_ROWS * tolerated(c)) || is_unilateral(c->m)) return;
    put_only_velocities_back(c);
    if (mesh_of(c)) last_row(c)[MESH_PUT_BACK] = 1.0;
    c->s.head[S_ACROSS] = velocity_defect(c, c->h);
}

/* Whether so many half steps more would be too many in a communication step; `calm` ones were made
   before the present moment. */
static int are_too_many(double made, double more, double *calm, int32_t failed)
{
    if (made + more < MOST_HALF_STEPS) *calm = made;
    return !(made + (!failed && made - *calm < MOMENT ? 0.0 : more) < MOST_HALF_STEPS);
}

/* Why so many half steps are too many: laws switch nearly as often, or the tolerance asks for
   them. */
static int32_t blame_for_many(context *c, double half_steps)
{
    return c->s.head[S_SWITCHED] > OFTEN * half_steps
               ? blame_switch(c, HOLONOM_LAW_SWITCHES, c->switches.which)
               : HOLONOM_STEP_COLLAPSED;
}

/* Takes a piece in a communication step of length `step`; 1 if it is to be repeated with shorter
   ones. What is found of a step is gone where it is made anew to look for switches. The part of one
   that ends at a switch adds as much of an error, for its length, as the whole. */
static int try_piece(context *c, piece *x, double step)
{
    double *head = c->s.head;
    const int is_brief = is_unilateral(c->m) && is_short(c, x->length);
    if (is_unilateral(c->m) && head[S_KNOWN] == 0.0)
        head[S_ACROSS] = velocity_defect(c, x->length); /* as impacts have left it */
    begin_watched(c, x->length);
    if (is_unilateral(c->m)) keep_start(c);
    x->take = is_brief ? short_piece : internal_step;
    x->status = x->take(c, x->length);
    const int is_judged = !x->status && !is_brief;
    const double before = head[S_ERROR_ESTIMATE], whole = x->length;
    if (is_judged && judge_step(c, x->length, step)) return 1;
    const double rate = (head[S_ERROR_ESTIMATE] - before) / whole;
    if (find_switch(c, x)) return 1;
    if (is_brief || !(x->length > 0.0) || (is_judged && !x->is_anew)) return 0;
    if (!is_judged || !x->crossed) return judge_step(c, x->length, step);
    head[S_ERROR_ESTIMATE] += rate * x->length;
    return 0;
}

/* Goes back to the start of a piece that was tried in vain; the next one is shorter. */
static void repeat_shorter(context *c, const piece *x, double law_time)
{
    double *head = c->s.head;
    const double wanted = x->status ? c->last.shorter * x->length : head[S_WANTED];
    undo_step(c, x->t, law_time);
    head[S_WANTED] = wanted;
    if (!x->status) return;
    lower_penalties(c);
    if (!known_misses(c)) return;
    forget_halves(c); /* Newton's iteration may only have begun too far away */
    head[S_WANTED] = x->length;
}

/* Takes what rate closed contacts have across their surfaces where a piece begins that seems to
   pass an edge: it would be mirrored, however short the piece. */
HM_SELDOM static int32_t forget_rates_across(context *c)
{
    int moves = 0;
    evaluate_state(c);
    EACH_CONTACT(c, i)
        moves |= is_closed(c, i)
                 && fabs(gap_rate(c, i)) > fmax(0.5 * ACROSS_EDGE * speed_at_contact(c, i),
                                                speed_tolerance(c));
    if (!moves) return HOLONOM_OK;
    if (mesh_of(c)) note_ahead(c, MESH_PROJECTED - MESH_LOWERED);
    return project_velocities(c, S_IMPACT);
}

/* Ends a piece at its first event, at most; `covered` is its length then. Where that fails so that
   shorter steps may help, or stepped contacts, it is undone. */
static int32_t end_at_event(context *c, const piece *x, double law_time, double *covered)
{
    *covered = x->length;
    if (!is_unilateral(c->m) || (x->crossed && !(x->length > 0.0))) return HOLONOM_OK;
    const int32_t status = end_piece(c, x->t, law_time, x->length, covered);
    if (may_step_over(status)) undo_piece(c, x->t, law_time);
    const int32_t failed = c->event.cuts ? forget_rates_across(c) : HOLONOM_OK;
    return failed ? failed : status;
}

/* Covers a communication step of length `step` from `start`; its end is met exactly. */
HM_SELDOM static int32_t cover_to_tolerance(context *c, double start, double step)
{
    double *head = c->s.head, done = 0.0, half_steps = 0.0, calm = 0.0, covered;
    int32_t status, failed = HOLONOM_OK; /* why the last step could not be solved */
    int repeats = 0;
    begin_control(c);
    while (done < step) {
        if (is_stopped(c)) return HOLONOM_STOPPED;
        const double rest = step - done, n = steps_over(c, rest, longest_next(c, rest)),
                     whole = rest / n;
        const double law_time = c->number[c->m->time_at];
        piece x = {.t = start + done, .length = whole};
        c->t = x.t;
        if (are_too_many(half_steps, n * c->step.halves, &calm, failed)) {
            if (is_unilateral(c->m) && may_step_over(failed))
                return step_over(c, failed, start, done, step);
            return failed ? failed : blame_for_many(c, half_steps);
        }
        c->last.shorter = 0.5;
        c->step.damped = is_dissipative(c);
        status = is_unilateral(c->m) ? stop_before(c, &x.length) : HOLONOM_OK;
        if (!status) status = stop_at_switch(c, &x, rest, step);
        if (status) return status;
        const int rejected = try_piece(c, &x, step);
        half_steps += c->step.halves;
        failed = x.status;
        if (rejected) {
            if (++repeats > MAX_REPEATS) return failed ? failed : HOLONOM_STEP_COLLAPSED;
            repeat_shorter(c, &x, law_time);
            continue;
        }
        repeats = 0;
        bound_across(c);
        if (x.length < whole)
            head[S_WANTED] =
                fmax(head[S_WANTED], whole); /* a slip about to stop has cut it, not its error */
        if ((status = end_at_event(c, &x, law_time, &covered))) {
            if (!may_step_over(status)) return status;
            head[S_WANTED] = 0.5 * x.length;
            if (!is_to_be_cut(c, status, x.length)) return step_over(c, status, start, done, step);
            continue;
        }
        if (covered == x.length && (status = pass_switch(c, &x))) return status;
        done = covered == rest ? step : done + covered;
        follow_energies(c);
    }
    return HOLONOM_OK;
}

/* Covers a communication step of n steps of length h, each cut at events; what is left of a grid
   step that is shorter than a thousandth of it belongs to the next one, since round-off of rows
   enters velocities over the length. */
static int32_t cover_between_events(context *c, double start, double step, double h)
{
    double *head = c->s.head, done = 0.0, cut = INFINITY, covered;
    int cuts = 0, stalls = 0;
    while (done < step) {
        const double law_time = c->number[c->m->time_at],
                     grid = (floor(done / h + SLIVER) + 1.0) * h;
        const double next = grid > step - SLIVER * h ? step : grid, order = head[S_ORDER_IN_USE];
        piece x = {.t = start + done, .length = fmin(next - done, cut), .take = step_piece};
        c->t = x.t;
        int32_t status = stop_before(c, &x.length);
        if (!status && begins_to_slide(c, &x.length)) head[S_ORDER_IN_USE] = 2.0;
        if (!status) status = stop_at_switch(c, &x, step - done, step);
        if (!status) status = take_to_switch(c, &x);
        if (may_step_over(status)) undo_piece(c, x.t, law_time);
        else if (!status) status = end_at_event(c, &x, law_time, &covered);
        head[S_ORDER_IN_USE] = order;
        if (status) {
            if (!may_step_over(status)) return status;
            cut = 0.5 * x.length;
            if (is_to_be_cut(c, status, x.length) && cuts++ < MOST_CUTS) continue;
            return step_over(c, status, start, done, step);
        }
        cut = INFINITY;
        if (covered == x.length && (status = pass_switch(c, &x))) return status;
        follow_coarseness(c, h);
        const double before = done;
        done = covered == next - done ? next : done + covered;
        if (done > before) stalls = 0;
        else if (++stalls > MOST_CUTS)
            return HOLONOM_STEP_COLLAPSED; /* a slip stops again and again, in no time */
    }
    return HOLONOM_OK;
}

static int32_t undivided_step(context *c, double h) { return step_halving(c, h, UNDIVIDED); }

/* Covers an equal step of length h from `start`, in a communication step of length `step`, by
   pieces that end at switches. */
HM_SELDOM static int32_t cover_between_switches(context *c, double start, double h, double step)
{
    double done = 0.0;
    while (done < h) {
        piece x = {.t = start + done, .length = h - done, .take = undivided_step};
        c->t = x.t;
        int32_t status = stop_at_switch(c, &x, h - done, step);
        if (!status) status = take_to_switch(c, &x);
        if (!status) status = pass_switch(c, &x);
        if (status) return status;
        done = x.length == h - done ? h : done + x.length;
    }
    return HOLONOM_OK;
}

/* Covers a communication step by equal steps of at most the option step_size, of the order asked
   for. */
static int32_t cover_evenly(context *c, double start, double step)
{
    double *head = c->s.head;
    const double n = fmax(1.0, ceil(step / hm_step_size(head) * (1.0 - 1e-10))), h = step / n;
    int32_t status = n <= 1e9 ? HOLONOM_OK : HOLONOM_BAD_STEP;
    head[S_ORDER_IN_USE] = fmax(head[S_ORDER], 2.0);
    head[S_EXPLICIT] = 0.0;
    if (!status && is_unilateral(c->m)) return cover_between_events(c, start, step, h);
    for (int64_t i = 0; !status && i < (int64_t)n; i++) {
        c->t = start + h * (double)i;
        status = n_switches(c) ? cover_between_switches(c, c->t, h, step)
                                 : step_halving(c, h, UNDIVIDED);
        if (!status) follow_coarseness(c, h);
    }
    if (c->last.finest) head[S_ORDER_IN_USE] = 2.0;
    return status;
}

#endif
