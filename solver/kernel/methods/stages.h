/* Stages of an explicit step: velocities and accelerations of points and of bodies' turns, and
   where sums of them lead. */
#ifndef HOLONOM_STAGES_H
#define HOLONOM_STAGES_H

#include "lanes.h"
#include "runge_kutta_methods.h"
#include "inputs_signals.h"

/* A stage has velocities and accelerations of each point, and those of the rotation vector psi of
   each body. */
static inline int64_t stage_size(const context *at)
{
    return DIM * (int64_t)at->n_moving
           - (has_turns(at) ? (DIM - 1) * TURNING * (int64_t)n_bodies(at->m) : 0);
}

/* First node behind those of a point or a body's directors that begin with node a, and components
   that they have in a stage. */
static inline int32_t behind(const context *at, int32_t a, int *components)
{
    *components = a < at->m->n_free ? unknown_size(at, a) : DIM;
    return a < at->m->n_free ? next_unknown(at, a) : a + 1;
}

/* x (2 stage_size) = the weighted sum of the first stages. */
static void weigh_stages(const context *at, const double *weight, int stages, double *x)
{
    const int64_t n = 2 * stage_size(at);
    const double *k[MOST_STAGES];
    double w[MOST_STAGES];
    int count = 0;
    for (int j = 0; j < stages; j++)
        if (weight[j] != 0.0) w[count] = weight[j], k[count++] = at->k.stages + n * j;
    for (int64_t i = 0; i < n; i += 2) {
        lanes sum = both_lanes(0.0);
        for (int j = 0; j < count; j++) sum = lanes_plus(sum, both_lanes(w[j]), lanes_at(k[j] + i));
        put_lanes(x + i, sum);
    }
}

/* Size of the sum of so many stages with these weights, of a step of length h, relative to size and
   speed: of the island where it is largest, and of the node (of_node, overwritten). */
HM_SELDOM static double size_of_sum(const context *at, const double *weight, int stages, double h,
                                    double *of_node)
{
    const node_scales scales = scales_of_nodes(at, h);
    const double *x = at->k.estimate, *v = x + stage_size(at);
    const double all = mass_of_all(at);
    double largest = 0.0;
    int components;
    *of_node = 0.0;
    weigh_stages(at, weight, stages, at->k.estimate);
    for (int32_t island = 0; island < at->m->n_islands; island++) {
        const island_node first = first_node(at, island);
        double square[2] = {0.0, 0.0};
        for (island_node node = first, next = first; node.a < node.end;
             node = next, x += components, v += components) {
            const double mass = (is_director(at, node.a) ? DIM - 1 : 1)
                                * at->number[at->m->node_mass_at + node.a];
            double own_square[2] = {0.0, 0.0};
            next.a = behind(at, node.a, &components);
            for (int k = 0; k < components; k++)
                own_square[0] += x[k] * x[k], own_square[1] += v[k] * v[k];
            for (int k = 0; k < 2; k++) {
                const double error =
                    node_error(at, &scales, k, node, h * sqrt(own_square[k]), mass) / h;
                square[k] += mass * own_square[k];
                if (!(error <= *of_node)) *of_node = error;
            }
        }
        const double times = sqrt(weight_of_island(at, first.all, all));
        const double size = relative_size(at, times * sqrt(square[0]), times * sqrt(square[1]));
        if (!(size <= largest)) largest = size; /* a NaN, too */
    }
    return largest;
}

/* How fast the rotation vector psi of a turn changes at the angular velocity omega (psi_rate,
   overwritten): omega - psi x omega/2 + (1 - theta/2 cot(theta/2)) psi x (psi x omega)/theta^2,
   theta = |psi| (Hairer, Lubich and Wanner 2006, IV.7). */
static void rate_of_rotation(const double *psi, const double *omega, double *psi_rate)
{
#if DIM == 2
    (void)psi;
    psi_rate[0] = omega[0];
#else
    const double square = dot(psi, psi), theta = sqrt(square);
    const double bend =
        square < 0.01
            ? 1.0 / 12.0 + square * (1.0 / 720.0 + square * (1.0 / 30240.0 + square / 1209600.0))
            : (1.0 - 0.5 * theta * hm_sin(theta) / (1.0 - hm_cos(theta))) / square;
    double once[3], twice[3];
    cross_product(psi, omega, once);
    cross_product(psi, once, twice);
    EACH(k) psi_rate[k] = omega[k] - 0.5 * once[k] + bend * twice[k];
#endif
}

/* Turns the directors from node a on by the rotation vector psi; their velocities are those of
   omega. */
static void turn_by(context *at, int32_t a, const double *psi, const double *omega)
{
    double square = 0.0, x[DIM], y[DIM];
    for (int k = 0; k < TURNING; k++) square += psi[k] * psi[k];
    const double theta = sqrt(square), half = hm_sin(0.5 * theta),
                 sine = theta > 0.0 ? hm_sin(theta) / theta : 1.0;
    const double bend = theta > 0.0 ? 2.0 * half * half / square : 0.5;
    for (int32_t i = DIM * a, end = i + DIM * TURNING; i < end; i += DIM) {
        turned_by(psi, at->s.q + i, x);
        turned_by(psi, x, y);
        EACH(k) hm_add(at->s.q + i + k, at->s.q_low + i + k, sine * x[k] + bend * y[k]);
        turned_by(omega, at->s.q + i, at->s.v + i);
        EACH(k) at->s.v_low[i + k] = 0.0;
    }
}

/* Of a body, and of an angle that is measured, in a step [rad]: angles are followed where they
   change by less than pi. */
#define LARGEST_TURN 2.9

/* Largest rate of an angle that is measured [rad/s]. */
HM_SELDOM static double fastest_angle(const context *c)
{
    double fastest = 0.0, rate;
    for (int32_t j = 0; j < c->m->n_quantities; j++) {
        if (c->m->quantity_kind[j] != QUANTITY_ANGLE) continue;
        quantity_at(c, j, c->s.q, c->s.q_low, c->s.v, &rate);
        fastest = fmax(fastest, fabs(rate));
    }
    return fastest;
}

/* The state at h times the weighted sum from the start of the step, with the signals at hand. */
static int32_t move_from_start(context *at, double h, const double *weight, int stages)
{
    const hm_state *s = &at->s;
    const double *start = at->k.pair_backup;
    double *x = at->k.estimate, *v = x + stage_size(at), turn[TURNING], omega[TURNING];
    int components;
    weigh_stages(at, weight, stages, x);
    take_motion_back(at, start);
    take_section(at, s->turns, s->n_angles, start);
    for (int32_t a = 0, next; a < at->n_moving; a = next, x += components, v += components) {
        next = behind(at, a, &components);
        if (!is_director(at, a)) {
            EACH(k) hm_add(s->q + DIM * a + k, s->q_low + DIM * a + k, h * x[k]);
            EACH(k) hm_add(s->v + DIM * a + k, s->v_low + DIM * a + k, h * v[k]);
            continue;
        }
        double square = 0.0;
        common_turn(at, a, s->v + DIM * a, omega);
        for (int k = 0; k < TURNING; k++) {
            turn[k] = h * x[k];
            omega[k] += h * v[k];
            square += turn[k] * turn[k];
        }
        if (!(square <= LARGEST_TURN * LARGEST_TURN)) return HOLONOM_TURN_TOO_LARGE;
        turn_by(at, a, turn, omega);
    }
    place_driven(at);
    return HOLONOM_OK;
}

/* Lets angles follow the state from the start of the step. */
static void turn_angles(context *at)
{
    const double *start = at->k.pair_backup + (at->s.q - at->s.head);
    for (int64_t k = 0; k < DIM * at->n_moving; k++) at->k.d[k] = at->s.q[k] - start[k];
    follow_angles(at, at->k.d);
}

/* A stage from the state, the sum that it was reached by, over h, and the accelerations. */
static void take_stage(const context *at, double h, const double *sum, const double *acceleration,
                       double *stage)
{
    double *rate = stage + stage_size(at), psi[TURNING], omega[TURNING];
    int components;
    for (int32_t a = 0, next; a < at->n_moving;
         a = next, stage += components, rate += components, sum += components) {
        next = behind(at, a, &components);
        if (!is_director(at, a)) {
            const double own = a < at->m->n_free; /* signals move the others */
            EACH(k) stage[k] = own * at->s.v[DIM * a + k];
            EACH(k) rate[k] = own * acceleration[DIM * a + k];
            continue;
        }
        for (int k = 0; k < TURNING; k++) psi[k] = h * sum[k];
        common_turn(at, a, at->s.v + DIM * a, omega);
        rate_of_rotation(psi, omega, stage);
        common_turn(at, a, acceleration + DIM * a, rate);
    }
}

#endif
