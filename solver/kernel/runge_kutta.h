/* Explicit Runge-Kutta steps of order 8 or 5, under a tolerance (theory 8.8).

   Accelerations follow from velocities, forces and rows by one linear solution, M a + G' mu = Q, G a = -bias. Twelve or six of them
   tell the end of a step, which is right to the order. It is put back onto rows, momenta and energy, so that a step keeps them as
   exactly as half steps do (Hairer, Lubich and Wanner 2006, IV.4). */
#ifndef HOLONOM_RUNGE_KUTTA_H
#define HOLONOM_RUNGE_KUTTA_H

#include "context.h"
#include "force_rates.h"
#include "half_step.h"
#include "lanes.h"
#include "ledger.h"
#include "norms.h"
#include "put_back.h"
#include "signal_course.h"
#include "start.h"

enum { MOST_STAGES = 12, MOST_PASSES = 8 };
#define SOFTER 1024.0           /* compliance of dependent rows: off the rows, as stages are, they would hold what they leave free */
#define SHORTEST 0.2            /* times the length of a step that failed, of the next try */
#define LEFT_OF_ROWS 1e-11      /* of their second derivatives, by Uzawa updates */
#define SLOW 0.5                /* more than so much of what was left before: rows depend on each other */
#define LARGEST_DIFFERENCE 1e-2 /* of a step from one of lower order: beyond, it is too long to be put back */
#define AIMED_DIFFERENCE 1e-3   /* by the next try */
#define MOST_HELD 3.0           /* steps in a row that could not be put back: then compositions serve for good */

/* Methods: parts of the stages before in each stage, its time, weights of the end and of its differences from one or two ends of
   lower order. Order 5 of Cash and Karp 1990; order 8 of Dormand and Prince 1981, with the differences of Hairer, Norsett and
   Wanner 1993, II.10. */
typedef struct runge_kutta {
    int order, stages, differences;
    double resolved; /* turn of a spring that a step resolves, over that of order 8 */
    double part[MOST_STAGES][MOST_STAGES - 1], node[MOST_STAGES], weight[MOST_STAGES], difference[2][MOST_STAGES];
} runge_kutta;

static const runge_kutta FIFTH_ORDER = {
    5, 6, 1, 0.23,
    {{0},
     {1.0 / 5},
     {3.0 / 40, 9.0 / 40},
     {3.0 / 10, -9.0 / 10, 6.0 / 5},
     {-11.0 / 54, 5.0 / 2, -70.0 / 27, 35.0 / 27},
     {1631.0 / 55296, 175.0 / 512, 575.0 / 13824, 44275.0 / 110592, 253.0 / 4096}},
    {0, 1.0 / 5, 3.0 / 10, 3.0 / 5, 1, 7.0 / 8},
    {37.0 / 378, 0, 250.0 / 621, 125.0 / 594, 0, 512.0 / 1771},
    {{-277.0 / 64512, 0, 6925.0 / 370944, -6925.0 / 202752, -277.0 / 14336, 277.0 / 7084}}};

static const runge_kutta EIGHTH_ORDER = {
    8, 12, 2, 1.0,
    {{0},
     {0.05260015195876773},
     {0.0197250569845379, 0.0591751709536137},
     {0.02958758547680685, 0, 0.08876275643042054},
     {0.2413651341592667, 0, -0.8845494793282861, 0.924834003261792},
     {0.037037037037037035, 0, 0, 0.17082860872947386, 0.12546768756682242},
     {0.037109375, 0, 0, 0.17025221101954405, 0.06021653898045596, -0.017578125},
     {0.03709200011850479, 0, 0, 0.17038392571223998, 0.10726203044637328, -0.015319437748624402, 0.008273789163814023},
     {0.6241109587160757, 0, 0, -3.3608926294469414, -0.868219346841726, 27.59209969944671, 20.154067550477894,
      -43.48988418106996},
     {0.47766253643826434, 0, 0, -2.4881146199716677, -0.590290826836843, 21.230051448181193, 15.279233632882423,
      -33.28821096898486, -0.020331201708508627},
     {-0.9371424300859873, 0, 0, 5.186372428844064, 1.0914373489967295, -8.149787010746927, -18.52006565999696,
      22.739487099350505, 2.4936055526796523, -3.0467644718982196},
     {2.273310147516538, 0, 0, -10.53449546673725, -2.0008720582248625, -17.9589318631188, 27.94888452941996,
      -2.8589982771350235, -8.87285693353063, 12.360567175794303, 0.6433927460157636}},
    {0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274, 0.2816496580927726, 0.3333333333333333, 0.25,
     0.3076923076923077, 0.6512820512820513, 0.6, 0.8571428571428571, 1.0},
    {0.054293734116568765, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585, 0.3111643669578199,
     -0.1521609496625161, 0.20136540080403034, 0.04471061572777259},
    {{0.01312004499419488, 0, 0, 0, 0, -1.2251564463762044, -0.4957589496572502, 1.6643771824549864, -0.35032884874997366,
      0.3341791187130175, 0.08192320648511571, -0.022355307863886294},
     {-0.18980075407240762, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585, -0.4226823213237919,
      -0.1521609496625161, 0.20136540080403034, 0.02265179219836082}}};

static inline int is_explicit_order(int order) { return order == 5 || order == 8; }

static const runge_kutta *method_of_order(int order) { return order == 5 ? &FIFTH_ORDER : &EIGHTH_ORDER; }

/* How far a body may turn in a step [rad]: angles are followed where they change by less than pi, and one between two bodies by
   what both turn. */
HM_SELDOM static double most_turned(const context *c)
{
    const holonom_model *m = c->m;
    for (int32_t j = 0; j < m->n_quantities; j++) {
        const int32_t f = m->quantity_form[2 * j];
        int first = 0, second = 0;
        if (m->quantity_kind[j] != QUANTITY_ANGLE) continue;
        for (int32_t e = m->form_ptr[f]; e < m->form_ptr[f] + m->form_free[f]; e++) {
            first |= c->number[m->alpha_at + e] != 0.0;
            second |= c->number[m->beta_at + e] != 0.0;
        }
        if (first && second) return 1.5;
    }
    return 2.9;
}

/* Whether steps may be explicit: put_back brings rows and energy back, and laws tell their powers at any moment. */
HM_SELDOM static int may_step_explicitly(const context *c)
{
    const holonom_model *m = c->m;
    return c->s.head[S_TOLERANCE] > 0.0 && c->s.head[S_HELD] < MOST_HELD && may_put_back(c) && !m->sensing && !is_unilateral(m) && !(m->variable_potential && m->time_dependent);
}

/* Whether the state is the end of an explicit step. */
static int ends_explicitly(const context *c) { return c->s.head[S_HALVES] == 0.0 && c->s.head[S_KNOWN] > 0.0; }

/* Longest explicit step, where the last one was none. */
HM_SELDOM static void find_longest(const context *c)
{
    context at = rows_at_state(c, 0.0);
    take_unknowns(&at);
    c->s.head[S_LONGEST_EXPLICIT] = factorise_here(&at) ? 0.0 : longest_explicit(&at);
}

/* Second derivative of a row that holds directions a and b, which may be one of the ground, in form f. */
static double second_rate_of_axes(const context *at, int32_t f)
{
    const axes x = axes_of(at, f, at->k.middle), v = axes_of(at, f, at->s.v), a = axes_of(at, f, at->k.w);
    return dot(a.a, x.b) + (x.second < 0 ? 0.0 : 2.0 * dot(v.a, v.b) + dot(x.a, a.b));
}

/* Second derivatives of the rows at the accelerations w (in phi). */
static void second_rates(const context *at)
{
    const holonom_model *m = at->m;
    const double *rest = at->k.d, *steady = at->k.signal_sample; /* what signals do is in the biases */
    double vu[DIM], vw[DIM], au[DIM], aw[DIM];
    memset(at->k.signal_sample, 0, sizeof(double) * (size_t)m->n_signals);
    EACH_FORM_ROW(at, i) {
        const int32_t f = m->row_form[i];
        if (is_axes_row(at, i)) {
            at->k.phi[i] = second_rate_of_axes(at, f);
            continue;
        }
        link_of(at, f, at->s.v, vu, vw);
        link_of(at, f, at->k.w, au, aw);
        at->k.phi[i] = 2.0 * dot(vu, vw) + dot(at->k.u0 + DIM * f, aw) + dot(at->k.w0 + DIM * f, au);
    }
    for IN_ISLAND(at, j, ISLAND_COINCIDENCE) link_of(at, m->coincidence_form[j], at->k.w, at->k.phi + m->n_form_rows + DIM * j, aw);
    for (int32_t j = first_function(at); j < first_potential(at); j++) {
        double *rate = at->k.phi + row_of(at, j);
        *rate = bias_of(at, j) + function_rate(at, j, at->s.q, at->s.q_low, at->k.w, at->s.signal, steady);
        if (is_velocity_row(at, j)) *rate -= function_rate(at, j, at->s.q, at->s.q_low, rest, at->s.signal, steady);
    }
}

/* Multiplies the compliance of rows that depend on each other. */
static void soften(const context *at, double times)
{
    if (at->island[I_DEPENDENT] == ROWS_ARE_INDEPENDENT) return;
    EACH_ROW(at, i) at->k.epsilon[i] *= times;
}

static int32_t solve_accelerations(context *at, double *a, double *multipliers)
{
    const holonom_model *m = at->m;
    const size_t n = sizeof(double) * (size_t)(DIM * at->n_moving), rows = sizeof(double) * (size_t)m->n_rows;
    double largest = 0.0, last = INFINITY;
    int32_t status = factorise_here(at);
    if (status) return status;
    memset(at->k.w, 0, n);
    memcpy(at->k.w + DIM * m->n_free, at->k.signal_before, sizeof(double) * (size_t)(DIM * m->n_driven));
    EACH_TURN(at, b) { /* what directors have where their bodies do not turn faster */
        const int32_t first = DIM * m->body_node[b];
        double omega[TURNING];
        common_turn(at, m->body_node[b], at->s.v + first, omega);
        for (int i = first; i < first + DIM * TURNING; i += DIM) turned_by(omega, at->s.v + i, at->k.w + i);
    }
    if (at->island[I_DEPENDENT] != ROWS_ARE_INDEPENDENT) memset(multipliers, 0, rows); /* what is not determined would stay and grow */
    memcpy(at->k.mu, multipliers, rows);
    memcpy(at->k.lambda, multipliers, rows);
    if ((status = residual_at_state(at))) return status;
    second_rates(at);
    memcpy(a, at->k.w, n);
    for (int pass = 0; pass < MOST_PASSES; pass++) {
        double size = 0.0, left = 0.0;
        gather_rhs(at);
        solve_factors(at);
        add_solution(at, a);
        memset(at->k.momentum, 0, n);
        EACH_ROW(at, i) {
            const double change = at->k.rhs[at->lu->row_position[i]], scale = at->number[m->row_scale_at + i];
            size = fmax(size, fabs(at->k.phi[i]) / scale);
            multipliers[i] = at->k.lambda[i] = at->k.mu[i] += change;
            at->k.phi[i] = inverse_pivot(at, i) == 0.0 ? 0.0 : at->k.epsilon[i] * change; /* rows in trees hold at once */
            left = fmax(left, fabs(at->k.phi[i]) / scale);
        }
        if (pass == 0) largest = size;
        if (!(left > LEFT_OF_ROWS * largest && left < SLOW * last)) break;
        last = left;
    }
    at->s.head[S_NEWTON_ITERATIONS] += 1.0;
    return all_finite(a, DIM * m->n_free) ? HOLONOM_OK : HOLONOM_NOT_FINITE;
}

/* Accelerations a (n) and multipliers (n_rows; near ones on entry) at the state. */
static int32_t accelerate(context *at, double *a, double *multipliers)
{
    soften(at, SOFTER);
    const int32_t status = solve_accelerations(at, a, multipliers);
    soften(at, 1.0 / SOFTER);
    return status;
}

/* Adds `time` times the powers at the state, of loads, moments and drives to the first of two works, of dampers to the other. */
HM_SELDOM static int32_t add_powers(const context *at, double time, double *work)
{
    const holonom_model *m = at->m;
    const double *v = at->s.v, *gravity = at->number + m->gravity_at;
    for (int32_t j = 0; j < m->n_elements; j++) {
        const double drive = at->number[m->drive_at + j], damping = at->number[m->damping_at + j];
        double rate;
        if (drive == 0.0 && damping == 0.0) continue;
        quantity_at(at, m->leaf[4 * m->leaf_ptr[j] + 1], at->s.q, at->s.q_low, v, &rate);
        work[0] += time * drive * rate;
        work[1] += time * damping * rate * rate;
    }
    if (!m->n_loads && !m->n_moments && !m->n_body_moments) return HOLONOM_OK;
    memset(at->k.momentum, 0, sizeof(double) * (size_t)(DIM * at->n_moving));
    const int32_t status = subtract_forces(at, at->k.momentum); /* of weights, too */
    for (int32_t a = 0; a < m->n_free; a++)
        work[0] -= time * (dot(v + DIM * a, at->k.momentum + DIM * a) / at->h +
                           at->number[m->node_weight_at + a] * dot(gravity, v + DIM * a));
    return status;
}

/* A stage has velocities and accelerations of each point, and those of the rotation vector psi of each body. */
static inline int64_t stage_size(const context *at)
{
    return DIM * (int64_t)at->n_moving - (is_reduced(at) ? (DIM - 1) * TURNING * (int64_t)n_bodies(at->m) : 0);
}

/* First node behind those of a point or a body's directors that begin with node a, and components that they have in a stage. */
static inline int32_t behind(const context *at, int32_t a, int *components)
{
    *components = a < at->m->n_free ? unknown_size(at, a) : DIM;
    return a < at->m->n_free ? next_unknown(at, a) : a + 1;
}

/* x (2 stage_size) = the weighted sum of the first stages. */
static void weigh_stages(const context *at, const double *weight, int stages, double *x)
{
    const int64_t n = 2 * stage_size(at);
    memset(x, 0, sizeof(double) * (size_t)n);
    for (int j = 0; j < stages; j++) {
        const double w = weight[j], *k = at->k.stages + n * j;
        for (int64_t i = 0; i < n && w != 0.0; i += 2) put_lanes(x + i, lanes_plus(lanes_at(x + i), both_lanes(w), lanes_at(k + i)));
    }
}

/* Size of the sum of so many stages with these weights, relative to size and speed. */
HM_SELDOM static double size_of_sum(const context *at, const double *weight, int stages)
{
    double *x = at->k.estimate, square[2];
    int components;
    weigh_stages(at, weight, stages, x);
    for (int i = 0; i < 2; i++) {
        square[i] = 0.0;
        for (int32_t a = 0; a < at->n_moving; x += components) {
            const double mass = (is_director(at, a) ? DIM - 1 : 1) * at->number[at->m->node_mass_at + a];
            a = behind(at, a, &components);
            for (int k = 0; k < components; k++) square[i] += mass * x[k] * x[k];
        }
    }
    return relative_size(at, sqrt(square[0]), sqrt(square[1]));
}

/* How fast the rotation vector psi of a turn changes at the angular velocity omega (psi_rate, overwritten):
   omega - psi x omega/2 + (1 - theta/2 cot(theta/2)) psi x (psi x omega)/theta^2, theta = |psi| (Hairer, Lubich and Wanner 2006,
   IV.7). */
static void rate_of_rotation(const double *psi, const double *omega, double *psi_rate)
{
#if DIM == 2
    (void)psi;
    psi_rate[0] = omega[0];
#else
    const double square = dot(psi, psi), theta = sqrt(square);
    const double bend = square < 0.01 ? 1.0 / 12.0 + square * (1.0 / 720.0 + square * (1.0 / 30240.0 + square / 1209600.0))
                                      : (1.0 - 0.5 * theta * hm_sin(theta) / (1.0 - hm_cos(theta))) / square;
    double once[3], twice[3];
    cross_product(psi, omega, once);
    cross_product(psi, once, twice);
    EACH(k) psi_rate[k] = omega[k] - 0.5 * once[k] + bend * twice[k];
#endif
}

/* Turns the directors from node a on by the rotation vector psi; their velocities are those of omega. */
static void turn_by(const context *at, int32_t a, const double *psi, const double *omega)
{
    double square = 0.0, x[DIM], y[DIM];
    for (int k = 0; k < TURNING; k++) square += psi[k] * psi[k];
    const double theta = sqrt(square), half = hm_sin(0.5 * theta), sine = theta > 0.0 ? hm_sin(theta) / theta : 1.0;
    const double bend = theta > 0.0 ? 2.0 * half * half / square : 0.5;
    for (int32_t i = DIM * a, end = i + DIM * TURNING; i < end; i += DIM) {
        turned_by(psi, at->s.q + i, x);
        turned_by(psi, x, y);
        EACH(k) hm_add(at->s.q + i + k, at->s.q_low + i + k, sine * x[k] + bend * y[k]);
        turned_by(omega, at->s.q + i, at->s.v + i);
        EACH(k) at->s.v_low[i + k] = 0.0;
    }
}


/* The state at h times the weighted sum from the start of the step, with the signals at hand. */
static int32_t move_from_start(context *at, double h, const double *weight, int stages)
{
    const int64_t n = DIM * at->n_moving;
    const hm_state *s = &at->s;
    const double *start = at->k.pair_backup;
    double *x = at->k.estimate, *v = x + stage_size(at), turn[TURNING], omega[TURNING];
    int components;
    weigh_stages(at, weight, stages, x);
    memcpy(s->q, start + (s->q - s->head), sizeof(double) * (size_t)(4 * n));
    memcpy(s->turns, start + (s->turns - s->head), sizeof(double) * (size_t)(2 * at->m->n_quantities)); /* and sines */
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
        if (!(square <= hm_square(at->most_turned))) return HOLONOM_TURN_TOO_LARGE;
        turn_by(at, a, turn, omega);
    }
    place_driven(at);
    for (int64_t k = 0; k < n; k++) at->k.d[k] = s->q[k] - start[s->q - s->head + k];
    follow_angles(at, at->k.d);
    return HOLONOM_OK;
}

/* Laws at part c of a step of length h from t, of its inside: they may jump where it begins or ends. */
HM_SELDOM static void laws_within(context *at, double t, double h, double c)
{
    const double margin = fmax(1e-12 * h, 4.5e-16 * fabs(t));
    if (at->m->time_dependent) set_laws(at, fmin(fmax(t + c * h, t + margin), t + h - margin), 0);
}

/* A stage from the state, the sum that it was reached by, over h, and the accelerations. */
static void take_stage(const context *at, double h, const double *sum, const double *acceleration, double *stage)
{
    double *rate = stage + stage_size(at), psi[TURNING], omega[TURNING];
    int components;
    for (int32_t a = 0, next; a < at->n_moving; a = next, stage += components, rate += components, sum += components) {
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

/* Forgets those momenta that the accelerations a change in a time h. */
HM_SELDOM static void look_for_forces(const context *c, double h, const double *a, kept_momenta *x)
{
    double rate[RIGID], size[RIGID];
    inertia(c, 2.0, a, c->k.momentum);
    rigid_momenta(c, x->kept, c->k.momentum, rate, size);
    for (int i = 0; i < RIGID; i++) x->kept[i] &= fabs(h * rate[i]) <= MOMENTUM_ROUND_OFF * fmax(h * size[i], x->scale[i]);
}

/* Stages of a step of length h; works, and momenta that they do not change. */
static int32_t take_stages(context *at, const runge_kutta *x, double h, kept_momenta *kept, double *work)
{
    const int64_t n = 2 * stage_size(at);
    const double t = at->t;
    const int known = ends_explicitly(at) && !at->m->time_dependent && !at->m->n_signals;
    double *sum = at->k.estimate, *a = at->s.a[0];
    memset(sum, 0, sizeof(double) * (size_t)n);
    find_courses(at, t, h);
    for (int i = 0; i < x->stages; i++) {
        follow_courses(at, x->node[i], h);
        int32_t status = i ? move_from_start(at, h, x->part[i], i) : HOLONOM_OK;
        laws_within(at, t, h, x->node[i]);
        if (!status && (i || !known)) status = accelerate(at, a, at->s.mu[0]);
        else if (!status) rest_here(at);
        if (!status && x->weight[i] != 0.0) status = add_powers(at, h * x->weight[i], work);
        if (status) return status;
        take_stage(at, h, sum, a, at->k.stages + n * i);
        if (i == 0 || i == x->stages - 1 || at->m->time_dependent) look_for_forces(at, h, a, kept); /* others do not pause in between */
    }
    return HOLONOM_OK;
}

/* Difference of a step of length h from one of lower order, relative to size and speed. */
HM_SELDOM static double difference_of_stages(const context *at, const runge_kutta *x, double h)
{
    const double first = h * size_of_sum(at, x->difference[0], x->stages);
    if (x->differences == 1 || first == 0.0) return first;
    return first * first / hm_hypot(first, 0.1 * h * size_of_sum(at, x->difference[1], x->stages));
}

/* Part of the difference from the first step of lower order that rows leave free. Factors are those of the end. */
HM_SELDOM static double free_part(context *at, const runge_kutta *x)
{
    double *sum = at->k.estimate, *u = at->k.free, square[2] = {0.0, 0.0};
    const double size = at->number[at->m->extent_at + 1], speed = speed_scale(at);
    int components;
    if (!at->m->n_rows) return 1.0;
    weigh_stages(at, x->difference[0], x->stages, sum);
    asks_for_rates(at);
    for (int i = 0; i < 2; i++) {
        const double scale = i ? speed : size;
        for (int32_t a = 0, next; a < at->n_moving; a = next, sum += components) {
            next = behind(at, a, &components);
            for (int32_t k = DIM * a; k < DIM * next; k += DIM) {
                if (is_director(at, k / DIM)) turned_by(sum, at->s.q + k, u + k);
                else EACH(l) u[k + l] = sum[l];
            }
        }
        square[0] += hm_square(mass_norm(at, u) / scale);
        leave_free(at, u);
        square[1] += hm_square(mass_norm(at, u) / scale);
    }
    return square[0] > 0.0 ? fmin(1.0, sqrt(square[1] / square[0])) : 1.0;
}

/* Keeps the start of a step, of which velocities that other steps have left off the rows are put back first, if they can be. */
HM_SELDOM static int32_t keep_explicit_start(context *c, context *at)
{
    const size_t bytes = sizeof(double) * (size_t)c->state_size;
    const kept_momenta none = {{0}, {0.0}, {0.0}};
    int unused;
    memcpy(c->k.pair_backup, c->s.head, bytes);
    if (ends_explicitly(c)) return HOLONOM_OK;
    const int32_t status = factorise_here(at);
    if (status) return status;
    put_velocities_back(c, at, &none, &unused);
    memcpy(c->k.pair_backup, c->s.head, bytes);
    return HOLONOM_OK;
}

/* Forces on driven nodes at the state, with its accelerations and multipliers. */
HM_SELDOM static int32_t hold_driven(const context *at)
{
    const int32_t first = DIM * at->m->n_free;
    memcpy(at->k.w, at->s.a[0], sizeof(double) * (size_t)(DIM * at->n_moving));
    memcpy(at->k.mu, at->s.mu[0], sizeof(double) * (size_t)at->m->n_rows);
    const int32_t status = residual_at_state(at);
    for (int32_t k = first; k < DIM * at->n_moving; k++) at->s.driven[0][k - first] = at->s.driven[1][k - first] = at->k.momentum[k] / AT_STATE;
    return status;
}

/* Accelerations and multipliers of the end of a step, for outputs and for the first stage of the next one. */
HM_SELDOM static int32_t remember_end(context *c, context *at)
{
    follow_courses(c, 1.0, c->h);
    if (c->s.head[S_LONGEST_EXPLICIT] < 3.0 * c->h) c->s.head[S_LONGEST_EXPLICIT] = longest_explicit(at); /* it changes slowly */
    int32_t status = accelerate(at, c->s.a[0], c->s.mu[0]);
    memcpy(c->s.a[1], c->s.a[0], sizeof(double) * (size_t)(DIM * c->n_moving));
    memcpy(c->s.mu[1], c->s.mu[0], sizeof(double) * (size_t)c->m->n_rows);
    if (c->m->n_driven && !status) status = hold_driven(at);
    average_multipliers(c, c->t);
    c->s.head[S_HALVES] = 0.0;
    c->s.head[S_KNOWN] = 1.0;
    return status;
}

/* Stages and end of a step, put back. */
HM_SELDOM static int32_t step_explicitly(context *c, context *at, const runge_kutta *x, double h, int *held)
{
    double work[2] = {0.0, 0.0};
    int32_t status = keep_explicit_start(c, at);
    kept_momenta kept = momenta_at_start(c);
    c->balanced = 0.0;
    if (!status) status = take_stages(at, x, h, &kept, work);
    if (status) return status;
    c->difference = difference_of_stages(at, x, h);
    if (!(c->difference <= LARGEST_DIFFERENCE)) {
        c->shorter = fmax(SHORTEST, hm_pow(AIMED_DIFFERENCE / c->difference, 1.0 / x->order));
        return HOLONOM_NOT_FINITE;
    }
    signals_at(c, c->t + h, c->k.signal1);
    signal_rates_at(c, c->t + h, c->k.signal_rate);
    status = move_from_start(at, h, x->weight, x->stages);
    laws_within(at, c->t, h, 1.0);
    c->t = at->t = c->t + h;
    if (!(work[1] >= -1e-15 * c->s.head[S_ENERGY_REFERENCE])) return HOLONOM_DAMPING_REVERSED;
    book(c, S_WORK, work[0]);
    book(c, S_DISSIPATED, fmax(work[1], 0.0));
    if (!status) status = factorise_here(at);
    c->within = h * hm_pow(AIMED_DIFFERENCE / fmax(c->difference, 1e-30), 1.0 / x->order);
    if (!status) c->free_part = free_part(at, x);
    return status ? status : put_back(c, at, &kept, held);
}

/* One internal step of length h. Where its end cannot be put back it is left to be taken otherwise; after
   MOST_HELD in a row others are, too: they learn their errors anew. */
HM_SELDOM static int32_t runge_kutta_step(context *c, double h)
{
    const runge_kutta *x = method_of_order((int)c->s.head[S_ORDER_IN_USE]);
    double *before = c->k.pair_backup; /* which undo_step returns to */
    int held = 0;
    context at = rows_at_state(c, 0.0);
    take_unknowns(&at);
    c->h = h;
    c->halves = x->stages;
    int32_t status = step_explicitly(c, &at, x, h, &held);
    if (held) {
        before[S_HELD] += 1.0;
        if (before[S_HELD] >= MOST_HELD) memset(c->s.head + S_JUDGED_4, 0, sizeof(double) * 6); /* undo_step keeps them */
        return HOLONOM_OK;
    }
    if (!status) status = remember_end(c, &at);
    if (status) return status;
    c->s.head[S_HELD] = 0.0;
    c->s.head[S_SUBSTEPS] += x->stages;
    c->way = EXPLICIT;
    follow_angles(c, NULL);
    for (int32_t j = 0; j < n_bodies(c->m); j++) follow_orientation(c, j);
    return HOLONOM_OK;
}

#endif
