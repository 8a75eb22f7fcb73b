/* Explicit Runge-Kutta steps of order 8 or 5, under a tolerance (theory 8.8).

   Accelerations follow from velocities, forces and rows by one linear solution, M a + G' mu = Q, G
   a = -bias. Twelve or six of them tell the end of a step, which is right to the order. It is put
   back onto rows, momenta and energy, so that a step keeps them as exactly as half steps do
   (Hairer, Lubich and Wanner 2006, IV.4). */
#ifndef HOLONOM_RUNGE_KUTTA_H
#define HOLONOM_RUNGE_KUTTA_H

#include "force_rates.h"
#include "half_step.h"
#include "mesh.h"
#include "stages.h"

enum { MOST_PASSES = 8 };
#define SOFTER                                                                                     \
    1024.0 /* compliance of dependent rows in stages, over the usual: off the rows they would stop \
              motion */
#define SHORTEST 0.2            /* times the length of the last step, of the next one */
#define LEFT_OF_ROWS 1e-11      /* of their second derivatives, by Uzawa updates */
#define WEAKEST_PIVOT                                                                              \
    0.1 /* compliance of a row over what it determines, in stages: beyond, half steps pass a       \
           singular place */
#define SLOW 0.5 /* more than so much of what was left before: rows depend on each other */
#define LARGEST_DIFFERENCE                                                                         \
    1e-2 /* of a step from one of lower order: beyond, it is too long to be put back */
#define AIMED_DIFFERENCE                                                                           \
    5e-4 /* by the next try; with 1e-3 errors of wide requests set chains swinging, which asked    \
            for more steps */
/* Impacts multiply errors of the motion before them; explicit steps have no margin for that, so
   that each error counts so many times. */
#define IMPACTS_GROW 10.0
#define MOST_HELD                                                                                  \
    3.0 /* steps in a row that could not be put back: then covers serve for good */

/* Whether a model allows explicit steps: put_back brings rows and energy back, and laws tell their
   powers at any moment. `but_forces`: whatever forces do at kinks. */
HM_SELDOM static int allows_explicit(const context *c, int but_forces)
{
    return !is_stepped(c) && !(c->m->variable_potential && c->m->time_dependent)
           && are_smooth(c, but_forces);
}

/* Whether derivatives tell now how fast springs and dampers are. A friction that slides takes
   energy by pairs alone: some weights of stages are negative. */
static int knows_rates_of_forces(const context *c, int but_forces)
{
    const double mass =
        c->number[c->m->extent_at
                  + 1]; /* none where drivers move springs alone: then nothing measures errors */
    return mass > 0.0 && c->tolerance > 0.0 && !c->friction.slides && c->s.head[S_HELD] < MOST_HELD
           && allows_explicit(c, but_forces);
}

/* They do where a law of a damper has a kink, too, which steps end at. */
static int knows_rates(const context *c) { return knows_rates_of_forces(c, 1); }

/* Whether steps may be explicit now. */
HM_SELDOM static int may_step_explicitly(const context *c) { return knows_rates_of_forces(c, 0); }

/* Whether the state is the end of an explicit step. */
static int ends_explicitly(const context *c)
{ return c->s.head[S_HALVES] == 0.0 && c->s.head[S_KNOWN] > 0.0; }

/* Longest explicit step, where the last one was none. */
HM_SELDOM static void find_longest(context *c)
{
    context at = rows_at_state(c);
    take_unknowns(&at);
    c->s.head[S_LONGEST_EXPLICIT] = factorise_here(&at) ? 0.0 : longest_explicit(&at);
}

/* Second derivative of a row that holds directions a and b, which may be one of the ground, in form
   f, at angular velocities (in spun) that do not change. */
static double second_rate_of_axes(const context *at, int32_t f)
{
    const axes x = axes_of(at, f, at->k.middle);
    double a[DIM], b[DIM], bend[DIM];
    turned_by(at->k.spun + x.first, x.a, a);
    turned_by(at->k.spun + x.first, a, bend);
    double rate = dot(bend, x.b);
    if (x.second < 0) return rate;
    turned_by(at->k.spun + x.second, x.b, b);
    turned_by(at->k.spun + x.second, b, bend);
    return rate + 2.0 * dot(a, b) + dot(x.a, bend);
}

/* Second derivatives of the rows at hand at the accelerations w, of bodies that do not turn faster
   (in phi). */
static void second_rates(const context *at)
{
    const holonom_model *m = at->m;
    const double *rest = at->k.d,
                 *steady = at->k.signal_before; /* what signals do is in the biases */
    double vu[DIM], vw[DIM], au[DIM], aw[DIM];
    memset(at->k.signal_before, 0, sizeof(double) * (size_t)m->n_signals);
    EACH_FORM_ROW(at, i) {
        const int32_t f = m->row_form[i];
        if (is_axes_row(at, i)) {
            at->k.phi[i] = second_rate_of_axes(at, f);
            continue;
        }
        link_of(at, f, at->s.v, vu, vw);
        link_of(at, f, at->k.w, au, aw);
        at->k.phi[i] =
            2.0 * dot(vu, vw) + dot(at->k.u0 + DIM * f, aw) + dot(at->k.w0 + DIM * f, au);
    }
    for
        IN_ISLAND(at, j, ISLAND_COINCIDENCE)
        link_of(at, m->coincidence_form[j], at->k.w, at->k.phi + row_of_coincidence(m, j), aw);
    for (int k = ISLAND_FUNCTION; k <= ISLAND_VELOCITY; k++)
        for IN_ISLAND(at, j, k) {
            double *rate = at->k.phi + row_of(at, j);
            *rate = bias_of(at, j) + function_rate(at, j, at->k.w, steady);
            if (is_velocity_row(at, j)) *rate -= function_rate(at, j, rest, steady);
        }
}

/* Multiplies the compliance of rows that depend on each other. */
static void soften(const context *at, double times)
{
    if (at->view.scalars[I_DEPENDENT] == ROWS_ARE_INDEPENDENT) return;
    EACH_ROW(at, i) at->k.epsilon[i] *= times;
}

/* Accelerations a (n) and multipliers (n_rows; near ones on entry) of the island at hand at the
   state. */
static int32_t solve_accelerations(context *at, double *a, double *multipliers)
{
    const holonom_model *m = at->m;
    double largest = 0.0, last = INFINITY;
    int32_t status = factorise_here(at);
    if (status) return status;
    clear_nodes(at, at->k.w);
    for (int32_t k = DIM * at->view.begin[ISLAND_DRIVEN]; k < DIM * at->view.end[ISLAND_DRIVEN];
         k++)
        at->k.w[k] = at->k.signal_bend[k - DIM * m->n_free];
    EACH_TURN(at, b) { /* what directors have where their bodies do not turn faster */
        const int32_t first = DIM * m->body_node[b];
        double *omega = at->k.spun + first;
        common_turn(at, m->body_node[b], at->s.v + first, omega);
        for (int i = first; i < first + DIM * TURNING; i += DIM)
            turned_by(omega, at->s.v + i, at->k.w + i);
    }
    /* What dependent rows do not determine would stay and grow; those of rows in trees are found at
       once. */
    EACH_ROW(at, i) {
        if (at->view.scalars[I_DEPENDENT] != ROWS_ARE_INDEPENDENT || is_in_tree(at, i))
            multipliers[i] = 0.0;
        at->k.mu[i] = at->k.lambda[i] = multipliers[i];
    }
    if ((status = residual_at_state(at))) return status;
    second_rates(at);
    EACH_COORDINATE(at, k) a[k] = at->k.w[k];
    for (int pass = 0; pass < MOST_PASSES; pass++) {
        double size = 0.0, left = 0.0;
        gather_rhs(at);
        solve_factors(at);
        add_solution(at, a);
        clear_nodes(at, at->k.momentum);
        EACH_ROW(at, i) {
            const double change = at->k.rhs[at->factors.lu->row_position[i]], before = at->k.phi[i];
            multipliers[i] = at->k.lambda[i] = at->k.mu[i] += change;
            at->k.phi[i] = is_in_tree(at, i) ? 0.0 : at->k.epsilon[i] * change;
            if (is_in_tree(at, i)) continue;
            size = fmax(size, fabs(before) / at->number[m->row_scale_at + i]);
            left = fmax(left, fabs(at->k.phi[i]) / at->number[m->row_scale_at + i]);
        }
        if (pass == 0) largest = size;
        if (!(left > LEFT_OF_ROWS * largest && left < SLOW * last)) break;
        last = left;
    }
    const int32_t first = DIM * at->view.begin[ISLAND_FREE];
    return all_finite(a + first, DIM * at->view.end[ISLAND_FREE] - first) ? HOLONOM_OK
                                                                     : HOLONOM_NOT_FINITE;
}

/* Likewise, of dependent rows with a larger compliance. */
static int32_t accelerate(context *at, double *a, double *multipliers)
{
    soften(at, SOFTER);
    const int32_t status = solve_accelerations(at, a, multipliers);
    soften(at, 1.0 / SOFTER);
    return status;
}

/* Adds `time` times the powers of the island at hand at the state: of loads, moments and drives,
   and of each damper to its loss. */
HM_SELDOM static int32_t add_powers(const context *at, double time, kept_motion *x)
{
    const holonom_model *m = at->m;
    const double *v = at->s.v, *gravity = at->number + m->gravity_at;
    EACH_ELEMENT(at, j) {
        const element_work work = kind_of(at, j)->rate(at, j, time);
        x->work += work.done;
        at->k.loss[j] += work.lost;
    }
    if (!is_loaded(at)) return HOLONOM_OK;
    clear_nodes(at, at->k.momentum);
    const int32_t status = subtract_forces(at, at->k.momentum); /* of weights, too */
    for (int32_t a = at->view.begin[ISLAND_FREE]; a < at->view.end[ISLAND_FREE]; a++)
        x->work -= time * (dot(v + DIM * a, at->k.momentum + DIM * a) / at->h +
                           at->number[m->node_weight_at + a] * dot(gravity, v + DIM * a));
    return status;
}

/* Laws at part c of a step of length h from t, of its inside: they may jump at its ends. What they
   read is the state. */
HM_SELDOM static void laws_within(context *at, double t, double h, double c)
{
    const int reads = at->m->sensing || n_kinks(at);
    if (reads) sense(at, 0.0, 0);
    if (at->m->time_dependent || reads) set_laws(at, inside_of_step(t, h, c), 0);
}

/* Forgets those momenta of the island at hand that the accelerations a change in a time h, beyond
   what weights do to what flies. If nothing else acts on that it keeps all: between rows that
   stages are off by a little reactions seem to turn it. */
HM_SELDOM static void look_for_forces(const context *c, double h, const double *a, kept_motion *x)
{
    double rate[RIGID], size[RIGID];
    if (x->flies && !is_loaded(c)) return;
    inertia(c, 1.0, a, c->k.momentum);
    find_centre(c, x);
    rigid_momenta(c, x->centre, x->kept, c->k.momentum, rate, size);
    for (int i = 0; i < RIGID; i++)
        x->kept[i] &= fabs(h * rate[i] - x->impulse[i])
                      <= MOMENTUM_ROUND_OFF * fmax(h * size[i], x->scale[i]);
}

/* Whether some rows of the island at hand, of which none depend on each other elsewhere, hardly
   determine their multipliers at this state: their compliance would hold as much as they do. */
static int is_singular_here(const context *at)
{
    double largest = 0.0;
    if (at->view.scalars[I_DEPENDENT] != ROWS_ARE_INDEPENDENT) return 0;
    EACH_ROW(at, i)
        if (state_of_multiplier(at, i) == ROW_IS_ON)
            largest = fmax(largest, fabs(inverse_pivot(at, i)) * at->k.epsilon[i]);
    return !(largest < WEAKEST_PIVOT);
}

/* Accelerations and multipliers of all islands at the state. */
static int32_t accelerate_all(context *at)
{
    int32_t status = HOLONOM_OK;
    EACH_ISLAND(at, island) {
        if (!status) status = accelerate(at, at->s.a[0], at->s.mu[0]);
        if (!status && is_singular_here(at)) status = HOLONOM_SINGULAR_TANGENT;
    }
    at->s.head[S_NEWTON_ITERATIONS] += 1.0;
    return status;
}

/* Works of the islands at a stage of this weight in a step of length h; where something may change
   at it, momenta that it does not. */
static int32_t follow_islands(context *at, double h, double weight, int changes)
{
    int32_t status = HOLONOM_OK;
    EACH_ISLAND(at, island) {
        if (weight != 0.0 && !status) status = add_powers(at, h * weight, kept_of(at));
        if (changes) look_for_forces(at, h, at->s.a[0], kept_of(at));
    }
    return status;
}

/* Stages of a step of length h; works, and momenta that they do not change. */
static int32_t take_stages(context *at, const runge_kutta *x, double h)
{
    const int64_t n = 2 * stage_size(at);
    const double t = at->t;
    const int changes = at->m->time_dependent || at->m->sensing || at->m->n_signals,
              known = ends_explicitly(at) && !changes;
    const int reads_angles =
        n_composites(at) || at->m->sensing; /* formulas, springs and sensors may read them */
    double *sum = at->k.estimate;
    memset(sum, 0, sizeof(double) * (size_t)n);
    for (int i = 0; i < x->stages; i++) {
        follow_signals(at, t, h, x->node[i]);
        int32_t status = i ? move_from_start(at, h, x->part[i], i) : HOLONOM_OK;
        if (i && reads_angles) turn_angles(at);
        laws_within(at, t, h, x->node[i]);
        if (!status && (i || !known)) status = accelerate_all(at);
        else if (!status) rest_here(at);
        /* Only laws, and drivers, pause at both ends and not in between. */
        if (!status)
            status = follow_islands(at, h, x->weight[i], i == 0 || i == x->stages - 1 || changes);
        if (status) return status;
        keep_forces(at, t + h * x->node[i], at->s.mu[0]);
        take_stage(at, h, sum, at->s.a[0], at->k.stages + n * i);
    }
    return HOLONOM_OK;
}

/* Difference of a step of length h from those of lower order. */
static double damped_difference(double first, double second)
{ return first > 0.0 ? first * first / hm_hypot(first, 0.1 * second) : first; }

/* Likewise, relative to size and speed, and that of the node where it is largest (of_node,
   overwritten). */
HM_SELDOM static double difference_of_stages(const context *at, const runge_kutta *x, double h,
                                             double *of_node)
{
    double node, other = 0.0;
    const double first = h * size_of_sum(at, x->difference[0], x->stages, h, &node);
    *of_node = h * node;
    if (x->differences == 1 || first == 0.0) return first;
    const double second = h * size_of_sum(at, x->difference[1], x->stages, h, &other);
    *of_node = damped_difference(*of_node, h * other);
    return damped_difference(first, second);
}

/* Part of the difference from the first step of lower order that rows leave free: of all, or of the
   nodes where it is largest. Factors are those of the end. */
HM_SELDOM static double free_part(context *at, const runge_kutta *x, double h)
{
    double *sum = at->k.estimate, *u = at->k.free, square[2] = {0.0, 0.0}, node[2] = {0.0, 0.0};
    const node_scales scales = scales_of_nodes(at, h);
    const double size = at->number[at->m->extent_at + 1], speed = speed_scale(at);
    int components;
    if (!at->m->n_rows) return 1.0;
    weigh_stages(at, x->difference[0], x->stages, sum);
    find_asked_rates(at);
    for (int i = 0; i < 2; i++) {
        const double scale = i ? speed : size;
        for (int32_t a = 0, next; a < at->n_moving; a = next, sum += components) {
            next = behind(at, a, &components);
            for (int32_t k = DIM * a; k < DIM * next; k += DIM) {
                if (is_director(at, k / DIM)) turned_by(sum, at->s.q + k, u + k);
                else EACH(l) u[k + l] = sum[l];
                EACH(l) u[k + l] *= h;
            }
        }
        square[0] += norm2_of_islands(at, u) / hm_square(scale);
        node[0] = hm_hypot(node[0], largest_node_error(at, &scales, i, u));
        leave_free(at, u);
        square[1] += norm2_of_islands(at, u) / hm_square(scale);
        node[1] = hm_hypot(node[1], largest_node_error(at, &scales, i, u));
    }
    const double of_all = square[0] > 0.0 ? sqrt(square[1] / square[0]) : 1.0;
    return fmin(1.0, node[0] > 0.0 ? fmax(of_all, node[1] / node[0]) : of_all);
}

/* Keeps the start of a step, of which velocities that other steps have left off the rows are put
   back first, if they can be. */
HM_SELDOM static int32_t keep_explicit_start(context *c, context *at)
{
    keep_state(c, c->k.pair_backup);
    if (ends_explicitly(c)) return HOLONOM_OK;
    follow_drivers(c);
    const int32_t status = factorise_here(at);
    if (status) return status;
    keep_motion(c, 0.0);
    forget_momenta(c);
    put_velocities_back(c, at);
    if (mesh_of(c)) note_ahead(c, MESH_STARTED - MESH_LOWERED);
    keep_state(c, c->k.pair_backup);
    return HOLONOM_OK;
}

/* Forces on driven nodes at the state, of accelerations a and multipliers mu. */
HM_SELDOM static int32_t hold_driven(const context *at, const double *a, const double *mu,
                                     double *force)
{
    const int32_t first = DIM * at->m->n_free;
    memcpy(at->k.w, a, sizeof(double) * (size_t)(DIM * at->n_moving));
    memcpy(at->k.mu, mu, sizeof(double) * (size_t)at->m->n_rows);
    const int32_t status = residual_at_state(at);
    for (int32_t k = first; k < DIM * at->n_moving; k++) force[k - first] = at->k.momentum[k];
    return status;
}

/* Accelerations and multipliers of the end of a step, for outputs and for the first stage of the
   next one. */
HM_SELDOM static int32_t remember_end(context *c, context *at)
{
    follow_signals(c, c->t - c->h, c->h, 1.0);
    laws_within(at, c->t - c->h, c->h, 1.0);
    c->s.head[S_LONGEST_EXPLICIT] = longest_explicit(at);
    int32_t status = accelerate_all(at);
    memcpy(c->s.a[1], c->s.a[0], sizeof(double) * (size_t)(DIM * c->n_moving));
    memcpy(c->s.mu[1], c->s.mu[0], sizeof(double) * (size_t)c->m->n_rows);
    if (c->m->n_driven && !status) status = hold_driven(at, c->s.a[0], c->s.mu[0], c->s.driven[0]);
    memcpy(c->s.driven[1], c->s.driven[0], sizeof(double) * (size_t)(DIM * c->m->n_driven));
    average_multipliers(c, c->t);
    c->s.head[S_HALVES] = 0.0;
    c->s.head[S_KNOWN] = 1.0;
    return status;
}

/* Books what loads and drives have done to the islands in a step, and what their dampers have
   taken. */
HM_SELDOM static void book_works(context *c)
{
    EACH_ISLAND(c, island) {
        kept_motion *x = kept_of(c);
        x->dissipated = lost_of(c, S_DISSIPATED);
        book(c, S_WORK, x->work);
        book(c, S_DISSIPATED, x->dissipated);
    }
}

/* Stages and end of a step, to be put back; factors are those of the end. */
HM_SELDOM static int32_t step_explicitly(context *c, context *at, const runge_kutta *x, double h,
                                         step_result *result)
{
    int32_t status = keep_explicit_start(c, at);
    double of_node;
    keep_motion(c, h);
    result->energy_correction = 0.0;
    result->growth = n_contacts(c->m) ? IMPACTS_GROW : 1.0;
    at->step.n_kept_forces = 0;
    if (!status) status = take_stages(at, x, h);
    c->step.n_kept_forces = at->step.n_kept_forces;
    if (status) return status;
    const double of_all = difference_of_stages(at, x, h, &of_node);
    result->difference = fmax(of_all, of_node);
    if (!(of_all <= LARGEST_DIFFERENCE)) {
        result->shorter =
            fmax(SHORTEST, hm_pow(AIMED_DIFFERENCE / of_all, 1.0 / x->order));
        return HOLONOM_NOT_FINITE;
    }
    signals_at(c, c->t + h, c->k.signal1);
    signal_rates_at(c, c->t + h, c->k.signal_rate);
    status = move_from_start(at, h, x->weight, x->stages);
    turn_angles(at);
    c->t = at->t = c->t + h;
    if (!status && h * fastest_angle(c) > LARGEST_TURN) status = HOLONOM_TURN_TOO_LARGE;
    if (gives_energy(c)) return HOLONOM_DAMPING_REVERSED;
    if (!status) book_works(c);
    if (!status) status = factorise_here(at);
    result->longest_put_back =
        h * hm_pow(AIMED_DIFFERENCE / fmax(of_all, 1e-30), 1.0 / x->order);
    if (!status) result->free_part = free_part(at, x, h);
    return status;
}

/* Leaves the forces at the start of a step that has failed in momentum: t is its time; fault.h
   names the part of the largest one. */
HM_SELDOM static void find_forces_at_start(context *c, context *at, double t, double h)
{
    take_state(c, c->k.pair_backup);
    follow_signals(c, t, h, 0.0);
    laws_within(at, t, h, 0.0);
    accelerate_all(at);
    inertia(c, 1.0, c->s.a[0], c->k.momentum);
}

/* One internal step of length h. Where its end cannot be put back, or a damper gives energy, it is
   left to be taken otherwise; after MOST_HELD in a row others are, too: they learn their errors
   anew. */
HM_SELDOM static int32_t runge_kutta_step(context *c, double h, step_result *result)
{
    const runge_kutta *x = method_of_order((int)c->s.head[S_ORDER_IN_USE]);
    const double t = c->t;
    double *before = c->k.pair_backup; /* which undo_step returns to */
    context at = rows_at_state(c);
    take_unknowns(&at);
    c->h = h;
    c->step.halves = x->stages;
    int32_t status = step_explicitly(c, &at, x, h, result);
    /* Some weights are negative, those of pairs are not; and a stage lies on a singular place. */
    if (status == HOLONOM_DAMPING_REVERSED || status == HOLONOM_SINGULAR_TANGENT) return HOLONOM_OK;
    if (!status && put_back(c, &at)) {
        before[S_HELD] += 1.0;
        return HOLONOM_OK;
    }
    if (!status) {
        tell_corrections(c, result);
        status = remember_end(c, &at);
    }
    if (status == HOLONOM_SINGULAR_TANGENT) return HOLONOM_OK;
    if (status == HOLONOM_NOT_FINITE) find_forces_at_start(c, &at, t, h);
    if (status) return status;
    c->s.head[S_HELD] = 0.0;
    c->s.head[S_SUBSTEPS] += x->stages;
    result->method = EXPLICIT;
    follow_turns(c);
    return HOLONOM_OK;
}

#endif
