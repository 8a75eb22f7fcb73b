/* What a step adds to the error of a run (theory 8.6).

   The difference from a solution of lower order r, e ~ (omega h)^(r+1), tells how fast the motion
   changes, and with it the error of the step's own order p, (omega h)^(p+1) times a mean over
   mechanisms. Of explicit steps that solution has other weights, of weighted covers it has all but
   the coarsest one. Pairs have none: the rate of their accelerations tells. The mass norm hides
   light nodes, which count by themselves. */
#ifndef HOLONOM_ESTIMATE_H
#define HOLONOM_ESTIMATE_H

#include "coarseness.h"
#include "method_table.h"
#include "step_halving.h"

/* Error of a cover over d_1^2/d_0, the last two differences between orders, of a spring that
   swings, and of what strong dampers settle, which no cover resolves. */
#define FALL 4.6
#define SETTLING 50.0
/* Largest swing of a node that pairs need not resolve, over the tolerance: where its phase is lost,
   the node errs by twice as much at most. */
#define SMALL_SWING 1.5
/* Of a node that swings in a cover of order 6 or 8: its turn in the step over the root of e/e_0,
   and the largest turn that is told so [rad]. */
#define SWING 10.0
#define FASTEST_SWING 3.0
/* Least error of a node in a cover of order 4 over its difference, where that is HIDDEN times what
   the mass norm tells: the difference of a light node that swings by little tells no turn. */
#define SWINGS_ALONE 0.03
#define HIDDEN 2.0
/* Least error of a cover over its difference, with strong dampers. */
#define SETTLED 1e-3
/* Error of velocities of parts that stiff springs or dampers hold, and that follow a force: of a
   pair over h^2 times the rate of accelerations, of a cover of order 4 over its difference: 1.5 as
   the weights of nodes take some of it off light ones. It is there at the end of each step, and
   does not add up. */
#define SLAVED 0.3
#define SLAVED_COVER 1.5
/* Least error of a cover of order 4 over its difference where that tells SUDDEN times the rate of
   the step before: a force has jumped within the step, and no difference before it tells. Likewise
   of an explicit step that begins where a law has switched, or SOON_BEHIND: the switch lies less
   than so many of its lengths before its end. */
#define AT_A_JUMP 1.0
#define SUDDEN 1.5
#define SOON_BEHIND 1.5
/* Round-off of the difference of a pair. */
#define ROUND_OFF_OF_PAIRS 1e-15
/* Of what a body turns by in a step: a top's difference from an embedded solution tells how fast it
   precesses, the step errs by its spin. */
#define SPINNING 2.0

typedef struct step_error {
    double rate;  /* omega [1/s] */
    double rate_of_all; /* likewise by the mass norm, which changes less from step to step */
    double free;  /* likewise of what rows leave free */
    double mean;  /* error, relative to size and speed */
    double settled; /* likewise of what strong dampers settle: it is gone with the step, and does
                       not add up */
    int is_noise; /* whether round-off of velocities is all that the difference shows */
    int is_hidden; /* whether a light node has it, which the mass norm hides */
} step_error;

/* Square of the angular velocity of a body from the rates of its first director, or of three:
   |omega x d_1|^2 + ... = 2 omega^2. */
static inline double square_of_turn(const double *rate)
{
    double square = 0.0;
    for (int k = 0; k < DIM * TURNING; k++) square += rate[k] * rate[k];
    return square / (DIM - 1);
}

/* Rate of change of the mean acceleration of pairs (in estimate); 0 where nothing tells it yet. */
static int find_rate_of_pairs(context *c, double h)
{
    const int64_t n = DIM * c->n_moving;
    double *const *a = c->s.a, *const *before = c->s.a_before;
    const double between = 0.5 * (h + c->s.head[S_LAST_LENGTH]);
    double *rate = c->k.estimate;
    c->s.head[S_LAST_LENGTH] = h;
    if (c->s.head[S_KNOWN] < 4.0) return 0;
    for (int64_t k = 0; k < n; k++)
        rate[k] = 0.5 * ((a[0][k] - before[0][k]) + (a[1][k] - before[1][k])) / between;
    return 1;
}

/* Velocity by which node a swings in pairs of length h, at most `fastest`; of_pairs is the second
   difference of its velocities between pairs. Turning by x in a half step, a swing of f has second
   differences of 4 f sin^2(x/2) between half steps and of 4 f sin^2 x between pairs: from both f,
   resolved or not. Between half steps rows show, too, so that what they hold counts as fastest. */
static double swing_of_node(const context *c, double h, int32_t a, double of_pairs, double fastest)
{
    const double *now = c->s.a[0] + DIM * a, *before = c->s.a_before[1] + DIM * a;
    if (c->s.freedom[a] != UNHELD) return fastest;
    double square = 0.0;
    EACH(k) square += hm_square(now[k] - before[k]);
    const double of_halves = 0.5 * h * sqrt(square), left = 4.0 * of_halves - of_pairs;
    return of_halves * of_halves < left * fastest ? of_halves * of_halves / left : fastest;
}

/* Largest difference of a node for a pair of length h, from the rate of its mean accelerations.
   A small swing does not count. */
HM_SELDOM static double difference_at_node(const context *c, double h, const double *rate)
{
    const node_scales scales = scales_of_nodes(c, h);
    double largest = 0.0;
    EACH_FREE_NODE(c, node) {
        const int32_t a = node.a;
        const double fastest = (c->m->node_kind[a] ? scales.direction : scales.point)[1],
                     mass = c->number[c->m->node_mass_at + a],
                     of_pairs = h * h * sqrt(dot(rate + DIM * a, rate + DIM * a)),
                     swing = swing_of_node(c, h, a, of_pairs, fastest);
        if (!(swing > SMALL_SWING * tolerated(c) * fastest)) continue;
        const double of_v = of_pairs * sqrt(of_pairs / swing);
        const double q = node_error(c, &scales, 0, node, h * of_pairs, mass),
                     v = node_error(c, &scales, 1, node, of_v, mass);
        largest = fmax(largest, hm_hypot(fmax(0.0, q), fmax(0.0, v)));
    }
    return largest;
}

/* The difference for a pair. */
static int difference_of_pairs(context *c, double h, double *difference)
{
    if (!find_rate_of_pairs(c, h)) return 0;
    const double of_rate = error_norm(c, c->k.estimate), speed = error_norm(c, c->s.v);
    const double omega = speed > 0.0 ? sqrt(of_rate / speed) : 0.0;
    *difference = h * h * h * relative_size(c, of_rate, omega * of_rate);
    return 1;
}

static void judge_coarseness(context *c, double h, double over)
{
    if (over <= c->s.head[S_COARSENESS]) return;
    c->s.head[S_COARSENESS] = over;
    c->s.head[S_COARSE_LENGTH] = h;
}

/* Distance of a node from where it began. */
static double way_of(const context *c, int32_t a)
{
    double square = 0.0;
    EACH(k) square += hm_square(c->s.q[DIM * a + k] - c->s.start[DIM * a + k]);
    return sqrt(square);
}

/* Largest change of acceleration of a place (x[0]) and of a body's turn (x[1]) among free nodes. An
   error where a path bends sharply turns all of the path, and so counts by half its reach over that
   bend's radius, v^1.5/rate^0.5. */
static void largest_rates(context *c, const double *rate, double *x)
{
    double *reach = c->s.head + S_REACH;
    x[0] = x[1] = 0.0;
    for (int32_t a = 0; a < c->m->n_free; a++) {
        if (c->m->node_kind[a] || c->s.freedom[a] == 0.0) continue;
        const double of_a = sqrt(dot(rate + DIM * a, rate + DIM * a)),
                     speed = sqrt(dot(c->s.v + DIM * a, c->s.v + DIM * a));
        *reach = fmax(*reach, way_of(c, a));
        const double times = 0.5 * *reach * sqrt(of_a) / fmax(speed * sqrt(speed), 1e-300);
        x[0] = fmax(x[0], of_a * fmin(fmax(times, 1.0), LONGEST_LEVER));
    }
    for (int32_t b = 0; b < n_bodies(c->m); b++) {
        const int32_t a = c->m->body_node[b];
        if (a < c->m->n_free && c->s.freedom[a] != 0.0)
            x[1] = fmax(x[1], sqrt(square_of_turn(rate + DIM * a)));
    }
}

/* Looks at an equal step of length h, number `look` of those in a row. */
HM_SELDOM static void look_at_step(context *c, double h, double look)
{
    double *head = c->s.head, x[2];
    const int is_known = find_rate_of_pairs(c, h); /* not after a jump */
    if (!is_known || (look > FIRST_LOOK && head[S_LEAST_PLACE] < 0.0)) {
        head[S_LEAST_PLACE] = -1.0;
        return;
    }
    largest_rates(c, c->k.estimate, x);
    for (int k = 0; k < 2; k++) x[k] *= OF_A_PAIR * h * h * h;
    head[S_LEAST_PLACE] = look > FIRST_LOOK ? fmin(head[S_LEAST_PLACE], x[0]) : x[0];
    head[S_LEAST_ANGLE] = look > FIRST_LOOK ? fmin(head[S_LEAST_ANGLE], x[1]) : x[1];
    if (look < LAST_LOOK) return;
    head[S_LOOKS] += 1.0;
    head[S_PLACE_ERROR] += head[S_LEAST_PLACE];
    head[S_ANGLE_ERROR] += head[S_LEAST_ANGLE];
    judge_coarseness(c, h,
                     hm_error_of_path(head, c->number[c->m->extent_at], head[S_EQUAL_STEPS])
                         / MOST_OF_THE_PATH);
}

HM_SELDOM static void turn_further(context *c, double h, int32_t node, double square)
{
    c->s.head[S_TURNED] = square;
    c->s.head[S_TURNING] = node;
    judge_coarseness(c, h, sqrt(square) / hm_longest_turn(c->s.head));
}

/* Takes from an equal step of length h, which is over, how long it was for the motion. */
HM_OFTEN void follow_coarseness(context *c, double h)
{
    double *head = c->s.head;
    for (int32_t b = 0; b < n_bodies(c->m); b++) {
        const int32_t a = c->m->body_node[b];
        const double square = h * h * square_of_turn(c->s.v + DIM * a);
        if (square > head[S_TURNED]) turn_further(c, h, a, square);
    }
    head[S_EQUAL_STEPS] += 1.0;
    if (is_unilateral(c->m) || head[S_ORDER_IN_USE] > 2.0)
        return; /* impacts would count for steps that have none */
    const double look =
        head[S_EQUAL_STEPS] - STEPS_A_LOOK * floor(head[S_EQUAL_STEPS] / STEPS_A_LOOK);
    if (look >= FIRST_LOOK && look <= LAST_LOOK) look_at_step(c, h, look);
    else head[S_LAST_LENGTH] = h;
}

/* Whether dampers are too strong for explicit steps: what they settle within a step falls little
   with the order. */
static int has_strong_dampers(const context *c)
{
    return c->step.damped && c->s.head[S_LONGEST_EXPLICIT] == 0.0 && knows_rates(c);
}

/* Largest of what functions and drivers read, an angle of many turns or a place far away, over 1
   rad and the size: they round it. */
HM_SELDOM static double largest_reading(const context *c)
{
    const double size = c->number[c->m->extent_at];
    double largest = 1.0;
    for (int32_t j = 0; j < c->m->n_active; j++) {
        const double value = fabs(quantity_at(c, j, c->s.q, c->s.q_low, NULL, NULL));
        largest = fmax(largest, c->m->quantity_kind[j] == QUANTITY_ANGLE ? value : value / size);
    }
    return largest;
}

/* Whether round-off explains a difference between steps of length h. Velocities are only known to
   round-off of places over h: shorter steps would show more of it, not less error. */
static int is_noise(const context *c, double round_off, double difference, double h)
{
    const double shown = c->number[c->m->extent_at + 1] / (h * fmax(speed_scale(c), 1e-300));
    return difference <= round_off * (1.0 + largest_reading(c) * shown);
}

/* Whether round-off explains the difference of the last step, of length h. Of a pair it is h^3
   times the rate of its accelerations, which has the round-off of places, however short the pair
   is; dampers, and laws that read the motion, add what velocities have of it. Where order 2 is not
   asked for, covers beside pairs tell errors, and pairs are left as they are. */
static int shows_noise_alone(const context *c, const method *used, double difference, double h)
{
    if (c->s.head[S_ORDER] == 2.0 && used->kind == COMPOSED && !c->last.finest
        && !c->m->sensing && !c->step.damped)
        return difference <= ROUND_OFF_OF_PAIRS * largest_reading(c);
    return is_noise(c, used->round_off, difference, h);
}

/* Puts into `before`, the difference before the last one x of a cover of length h, to what x falls
   at each node if it falls as much once more: as sizes, in the first component. How fast
   differences fall tells how far a node turns that swings; its error goes to and fro between place
   and velocity, so that a velocity counts with what its place will make of it. */
HM_SELDOM static void fall_once_more(const context *c, double h, const double *x, double *before)
{
    const int64_t v = DIM * c->n_moving;
    for (int32_t a = 0; a < c->m->n_free; a++) {
        const double *now = x + DIM * a;
        double *old = before + DIM * a;
        const double q = sqrt(dot(now, now)), q_0 = sqrt(dot(old, old)),
                     w = sqrt(dot(now + v, now + v)), w_0 = sqrt(dot(old + v, old + v));
        const double fall = hm_hypot(w, FASTEST_SWING * q / h)
                            / fmax(hm_hypot(w_0, FASTEST_SWING * q_0 / h), 1e-300);
        const double omega = fmin(FASTEST_SWING, SWING * sqrt(fall)) / h;
        const double e = hm_hypot(w, omega * q), e_0 = hm_hypot(w_0, omega * q_0);
        EACH(k) old[k] = old[v + k] = 0.0;
        if (q > 0.0) old[0] = q * q / hm_hypot(q, q_0);
        if (e > 0.0) old[v] = e * e / hm_hypot(e, e_0);
    }
}

/* The difference of the last step at the node where that is largest; 0 where nothing tells it. */
static double largest_at_node(const context *c, double h, const double *x)
{
    if (c->last.finest || c->last.method == EXPLICIT) return 0.0;
    return c->last.method == COVERED ? motion_error_at_node(c, x, h)
                                     : difference_at_node(c, h, x);
}

/* Error of the last cover, of order 6 or 8, over FALL or SETTLING: differences fall from order to
   order, down to the last one x, and the error falls as much once more. */
HM_SELDOM static double fallen_difference(context *c, double h, const double *x, double difference)
{
    double *before = c->k.estimate + 2 * c->s.n_motion;
    const double of_before = fmax(motion_error(c, before), motion_error_at_node(c, before, h));
    fall_once_more(c, h, x, before);
    return fmax(difference * difference / hm_hypot(difference, of_before),
                motion_error_at_node(c, before, h));
}

/* Error of the last step, of length h; 0 where nothing tells it yet. */
static int estimate_error(context *c, double h, step_error *e)
{
    const int order = (int)c->s.head[S_ORDER_IN_USE];
    const method *used = method_of(order, c->last.method == EXPLICIT), *pair = METHODS;
    const int is_cover = c->last.method == COVERED && !c->last.finest;
    const double *x = c->k.estimate + (is_cover ? c->s.n_motion : 0);
    double of_all; /* the difference by the mass norm */
    if (c->last.method == EXPLICIT) of_all = c->last.difference;
    else if (c->last.method == COVERED) of_all = motion_error(c, x);
    else if (!difference_of_pairs(c, h, &of_all)) return 0;
    const double of_node = largest_at_node(c, h, x), difference = fmax(of_all, of_node);
    e->is_noise = shows_noise_alone(c, used, difference, h);
    e->is_hidden = of_node > HIDDEN * of_all;
    if (c->last.finest) { /* the end that was not taken tells the error of the one that was, after
                             so many pairs */
        e->mean = difference;
        e->rate = e->free = e->rate_of_all =
            hm_pow(difference * c->last.finest * c->last.finest / pair->mean, 1.0 / 3.0) / h;
        return 1;
    }
    const double part = c->last.method == EXPLICIT ? c->last.free_part : 1.0,
                 root = 1.0 / (used->lower + 1.0);
    const double turned = used->rate * hm_pow(difference, root),
                 freed = part == 1.0 ? turned : used->rate * hm_pow(part * difference, root);
    e->free = freed / h;
    e->rate = turned / h;
    e->rate_of_all = used->rate * hm_pow(of_all, root) / h;
    if (c->last.method == EXPLICIT)
        e->rate = fmax(e->rate, mass_norm(c, c->s.a[0])
                                    / fmax(mass_norm(c, c->s.v), 1e-300)); /* over round-off */
    e->mean = used->mean * (order == 2 ? freed * freed * freed : hm_pow(freed, order + 1));
    const double before_it = c->s.head[S_LAST_RATE];
    const int is_settled = has_strong_dampers(c);
    const int is_slaved = c->last.method != EXPLICIT && c->step.damped && knows_rates(c)
                          && h > longest_of(c, 8);
    if (is_cover && order > 4) {
        const double fallen = fallen_difference(c, h, x, difference);
        if (is_settled) e->settled = SETTLING * fallen;
        else e->mean = fmax(e->mean, FALL * fallen);
    }
    if (order == 4 && e->is_hidden) e->mean = fmax(e->mean, SWINGS_ALONE * of_node);
    if (is_settled) e->mean = fmax(e->mean, SETTLED * difference);
    else if (order == 4 && (before_it > 0.0 || is_unilateral(c->m))
             && e->rate_of_all > SUDDEN * before_it)
        e->mean = fmax(e->mean, AT_A_JUMP * difference);
    if (is_slaved && order == 2)
        e->settled = SLAVED * h * h * error_norm(c, c->k.estimate) / fmax(speed_scale(c), 1e-300);
    if (is_slaved && order == 4) e->settled = SLAVED_COVER * difference;
    e->mean *= c->last.growth;
    if (c->last.method != EXPLICIT) return 1;
    if (n_motion_switches(c) && c->switches.last > c->t - SOON_BEHIND * h)
        e->mean = fmax(e->mean, AT_A_JUMP * difference);
    e->mean *= fmax(1.0, SPINNING * h * fastest_turn(c) / fmax(freed, 1e-30));
    return 1;
}

/* Bounds on what a step adds to velocities across the rows, over the fastest velocity: ACROSS_ROWS
   times the tolerance, and NEGLIGIBLE_ACROSS_ROWS, below which nothing is done. Such velocities
   alternate from half step to half step: shorter steps that follow do not undo them. */
#define ACROSS_ROWS 10.0
#define NEGLIGIBLE_ACROSS_ROWS 1e-6

/* Largest rate of a row over its scale and the fastest motion, without what round-off of places
   over h explains. Errors in the mass norm do not see light parts: their velocities show here. Rows
   of drivers have rates of signals, which are differences and tell nothing at a kink. */
HM_SELDOM static double velocity_defect(context *c, double h)
{
    const holonom_model *m = c->m;
    const double fastest =
        fmax(speed_scale(c) / c->number[m->extent_at + 1], fastest_rate(c, c->s.v));
    if (!(fastest > 0.0)) return 0.0;
    memset(c->k.signal_rate, 0, sizeof(double) * (size_t)m->n_signals);
    all_row_rates(c, c->k.row_rate);
    for (int32_t j = first_function(c); j < first_potential(c) && m->n_signals; j++)
        if (has_signal(c, j)) c->k.row_rate[row_of(c, j)] = 0.0;
    const double rounding = NEGLIGIBLE_ACROSS_ROWS + 1e-13 / (h * fastest);
    return fmax(0.0, largest_of_all(c, c->k.row_rate) / fastest - rounding);
}

#endif
