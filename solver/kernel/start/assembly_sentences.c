/* What is said of a mechanism when its parameters have arrived: numbers, drawn places,
   velocities. */
#include "small.h"

#include "sentences.h"

static const double DRAWN = 1e-9; /* largest residual of a drawn mechanism against the size of its
                                     row: the first step would turn a larger one into a jolt */
static const double PRESCRIBED =
    1e-6; /* largest relative error of a velocity that a formula prescribes: rates of signals are
             differences, which leaves of a signal at rest what rounding makes, less than DRAWN in a
             second */
static const double REST_OF_SOLVING =
    1e-13; /* what solving for velocities leaves, against the size of a row and the fastest motion,
              or in a second: what moves so little has no speed */

#define IS_ZERO "its value%s is %6g as drawn and must be 0; move or turn a part"
#define ASSEMBLE ", or set [solver] assemble = true"

static const struct { const char *sentence, *unit;
} KIND[ROW_KINDS] = {
    /* detail, gap */
    [ROW_LENGTH] = {"", " m"},
    [ROW_APART] = {"its places%s are drawn %6g m apart; move one", " m"},
    [ROW_OFF] = {"its places%s are drawn %6g m off its line or plane; move one", " m"},
    [ROW_HEIGHT] = {"the centre of the disc%s is drawn %6g m off its height; move it", " m"},
    [ROW_TURNED] = {"its axes%s are drawn %6g rad off; turn a body", " rad"},
    [ROW_ANGLE] =
        {"the cosine of its angle%s is %6g off as drawn; turn a body, or correct the value", ""},
    [ROW_AXES] = {"its axes%s are %6g off perpendicular unit vectors; correct its orientation", ""},
    [ROW_VALUE] = {IS_ZERO, ""},
    [ROW_COUPLED] = {IS_ZERO, ""},
    [ROW_DRIVER] =
        {"the drawing%s is %6g off its value at the start; move a part, correct the formula", ""},
    [ROW_VELOCITY] = {"its velocities%s are %6g off", ""},
};

/* A message with {value!r}, or {value:.6g}. */
static void say_filled(hm_text *text, const char *message, double value)
{
    char one[2] = "";
    while (*message) {
        if (strncmp(message, "{value", 6)) {
            one[0] = *message++;
            hm_say(text, "%s", one);
            continue;
        }
        hm_say(text, message[6] == ':' ? "%6g" : "%r", value);
        while (*message && *message != '}') message++;
        message += *message == '}';
    }
}

static int holds(const hm_rule *rule, double value)
{
    const int relation = rule->relation & ~OF_A_LAW;
    if (relation == IS_FINITE) return fabs(value) < INFINITY;
    if (relation == IS_NOTED) return value == 0.0;
    return relation == IS_ABOVE ? value > rule->bound : value >= rule->bound;
}

/* Counts the other places of a part that are drawn in penetration; -1 if one of them is deeper and
   is told instead. */
static int others_drawn(const hm_model_file *f, const double *numbers, uint32_t k)
{
    const hm_rule *rule = f->rule + k;
    int others = 0;
    for (uint32_t i = 0; i < f->header->n_rules; i++) {
        const hm_rule *other = f->rule + i;
        const double gap = numbers[other->number], own = numbers[rule->number];
        if (i == k || other->relation != IS_DRAWN || other->name != rule->name || holds(other, gap))
            continue;
        if (gap < own || (gap == own && i < k)) return -1;
        others++;
    }
    return others;
}

int hm_broken_rules(hm_text *text, const hm_model_file *f, const double *numbers,
                    enum hm_rules which)
{
    int broken = 0;
    for (uint32_t k = 0; k < f->header->n_rules; k++) {
        const hm_rule *rule = f->rule + k;
        const int is_asked = (rule->relation == IS_NOTED) == (which == RULES_NOTED)
                             && (which != RULES_OF_LAWS || rule->relation & OF_A_LAW);
        if (!is_asked || holds(rule, numbers[rule->number])) continue;
        const int others = rule->relation == IS_DRAWN ? others_drawn(f, numbers, k) : 0;
        if (others < 0) continue;
        hm_say(text, "%s%s: ", text->used ? "\n" : "", f->text + rule->name);
        broken++;
        say_filled(text, f->text + rule->message, numbers[rule->number]);
        if (others) hm_say(text, " (also at %d more of its places)", others);
    }
    return broken;
}

void hm_say_pressed(hm_text *text, const hm_model_file *f, int32_t row, double gap, int others)
{
    hm_say(text, "%s%s: its gap would be %6g%s; a stop may be moved as far as there is room",
           others ? "\n" : "", f->text + f->row[row].name, gap, KIND[f->row[row].kind].unit);
}

/* Names of the sampled loads, each once. */
static void say_sampled(hm_text *text, const hm_model_file *f)
{
    if (!f->model.n_sampled) hm_say(text, "a force");
    for (int32_t k = 0; k < f->model.n_sampled; k++) {
        int32_t before = 0;
        while (before < k && strcmp(f->text + f->sampled[before], f->text + f->sampled[k]))
            before++;
        if (before == k) hm_say(text, "%s%s", k ? ", " : "", f->text + f->sampled[k]);
    }
}

int hm_unknown_to_method(hm_text *text, const hm_model_file *f, const double *head)
{
    const holonom_model *m = &f->model;
    if (head[S_EQUILIBRIUM] == 0.0 || !m->sensing) return 0;
    hm_say(text, "solver.start: no equilibrium is sought, because ");
    say_sampled(text, f);
    hm_say(text, " reads the motion; write it as a spring, damper, torsion_spring, torsion_damper "
                 "or potential, or begin as drawn");
    return 1;
}

/* ----------------------------------------------------------------------------------- drawn rows */

typedef struct drawing {
    const hm_model_file *f;
    const holonom_model *m;
    const double *numbers, *phi, *rate;
    const hm_state *s;
    double fastest; /* largest angular velocity, and speed over the size of the mechanism [1/s] */
} drawing;

static double length_of(const double *x)
{
    return DIM == 2 ? hm_hypot(x[0], x[1]) : hm_hypot(hm_hypot(x[0], x[1]), x[DIM - 1]);
}

static int32_t n_moving(const drawing *d) { return d->m->n_free + d->m->n_driven; }

static const double *velocity_of(const drawing *d, int32_t node)
{
    static const double rest[DIM] = {0.0};
    return node < n_moving(d) ? d->s->v + DIM * node : rest;
}

static double fastest(const drawing *d)
{
    double largest = 0.0;
    for (int32_t node = 0; node < n_moving(d); node++) {
        const double speed = length_of(velocity_of(d, node));
        largest =
            fmax(largest, d->m->node_kind[node] ? speed : speed / d->numbers[d->m->extent_at]);
    }
    return largest;
}

/* How far a row is from what it demands; 0 where rounding explains it. */
static double drawn_gap(const drawing *d, int32_t row)
{
    const double size = d->numbers[d->m->row_scale_at + row], gap = fabs(d->phi[row]);
    const double twice = d->f->row[row].kind == ROW_LENGTH ? 2.0 : 1.0; /* of squared lengths */
    return gap <= twice * DRAWN * size ? 0.0 : gap;
}

/* What the rate of u . w, or of u alone, would be if nothing cancelled. */
static double bound_of_rate(const drawing *d, int32_t form)
{
    const holonom_model *m = d->m;
    const double *alpha = d->numbers + m->alpha_at, *beta = d->numbers + m->beta_at;
    const int turned = m->form_kind[form] & FORM_TURNED;
    double u[DIM] = {0.0}, w[DIM] = {0.0}, sum = 0.0;
    int alone = 1;
    for (int32_t e = m->form_ptr[form]; e < m->form_ptr[form + 1]; e++) {
        const double *x = hm_place_of_node(m, d->numbers, d->s->q, m->form_node[e]);
        for (int k = 0; k < DIM; k++) u[k] += alpha[e] * x[k], w[k] += beta[e] * x[k];
        alone &= beta[e] == 0.0 && !(turned && d->numbers[m->beta_turn_at + e] != 0.0);
    }
    const double arm = alone ? 1.0 : length_of(w), other = length_of(u);
    for (int32_t e = m->form_ptr[form]; e < m->form_ptr[form + 1]; e++) {
        double a = fabs(alpha[e]), b = fabs(beta[e]);
        if (turned)
            a += fabs(d->numbers[m->alpha_turn_at + e]), b += fabs(d->numbers[m->beta_turn_at + e]);
        sum += (a * arm + b * other) * length_of(velocity_of(d, m->form_node[e]));
    }
    return sum;
}

/* Rate of a row; 0 where rounding explains it. */
static double speed_of(const drawing *d, int32_t row)
{
    const holonom_model *m = d->m;
    const double scale = d->numbers[m->row_scale_at + row], rate = fabs(d->rate[row]);
    const int32_t coincidence = row - m->n_form_rows;
    double size =
        REST_OF_SOLVING * scale * (d->fastest + 1.0); /* of velocities that were made consistent */
    if (rate <= size) return 0.0; /* then its bound, which takes long, need not be known */
    if (coincidence < 0) size += DRAWN * bound_of_rate(d, m->row_form[row]);
    else if (coincidence < DIM * m->n_coincidences)
        size += DRAWN * bound_of_rate(d, m->coincidence_form[coincidence / DIM]);
    else size = scale * (PRESCRIBED * d->fastest + DRAWN);
    return rate <= size ? 0.0 : rate;
}

/* Length that a rod must have, and the one that it has. */
static void lengths_of(const drawing *d, int32_t row, double *length, double *drawn)
{
    const double length2 = d->numbers[d->m->row_constant_at + row], drawn2 = length2 + d->phi[row];
    *length = sqrt(length2);
    *drawn = sqrt(drawn2 > 0.0 ? drawn2 : 0.0);
}

/* Velocities of the two points of a rod along it; 0 if it has not two. */
static int speeds_along(const drawing *d, int32_t row, double *speed)
{
    const holonom_model *m = d->m;
    const int32_t begin = m->form_ptr[m->row_form[row]],
                  first = d->numbers[m->alpha_at + begin] < 0.0 ? begin : begin + 1;
    if (m->form_ptr[m->row_form[row] + 1] - begin != 2) return 0;
    const int32_t second = 2 * begin + 1 - first;
    if (d->numbers[m->alpha_at + first] != -1.0 || d->numbers[m->alpha_at + second] != 1.0)
        return 0;
    const int32_t node[2] = {m->form_node[first], m->form_node[second]};
    double link[DIM], length;
    const double *from = hm_place_of_node(m, d->numbers, d->s->q, node[0]),
                 *to = hm_place_of_node(m, d->numbers, d->s->q, node[1]);
    for (int k = 0; k < DIM; k++) link[k] = to[k] - from[k];
    length = length_of(link);
    for (int i = 0; i < 2; i++) {
        speed[i] = 0.0;
        for (int k = 0; k < DIM; k++) speed[i] += velocity_of(d, node[i])[k] * link[k];
        speed[i] /= length != 0.0 ? length : 1.0;
    }
    return 1;
}

/* Of the rows with the name of `row`, from it on, by `value`: the one with the largest, and the
   root of the sum of squares, of those alike if asked; 0 if one before it has the name. */
typedef double (*row_value)(const drawing *d, int32_t row);

static int gather(const drawing *d, int32_t row, row_value value, int alike, int32_t *worst,
                  double *whole)
{
    const uint32_t name = d->f->row[row].name;
    double largest = -1.0, sum = 0.0;
    for (int32_t i = 0; i < row; i++)
        if (d->f->row[i].name == name && value(d, i) != 0.0) return 0;
    for (int32_t i = row; i < d->m->n_rows; i++) {
        if (d->f->row[i].name != name) continue;
        const double x = value(d, i);
        if (x == 0.0) continue;
        if (!(x < largest)) largest = x, *worst = i;
    }
    for (int32_t i = row; i < d->m->n_rows; i++)
        if (d->f->row[i].name == name && (!alike || d->f->row[i].kind == d->f->row[*worst].kind)) {
            const double x = value(d, i) / largest;
            sum += x * x;
        }
    *whole = largest * sqrt(sum);
    return 1;
}

static void say_position(hm_text *text, const drawing *d, int32_t row, double gap)
{
    const hm_row *record = d->f->row + row;
    hm_say(text, "%s: ", d->f->text + record->name);
    if (record->kind == ROW_LENGTH) {
        double length, drawn;
        lengths_of(d, row, &length, &drawn);
        hm_say(text,
               "length is %12g m, but its points are drawn %12g m apart; move a point, correct the "
               "length, or leave it out to "
               "take it as drawn",
               length, drawn);
    } else
        hm_say(text, KIND[record->kind].sentence, d->f->text + record->detail, gap);
    hm_say(text, ASSEMBLE);
}

static void say_velocity(hm_text *text, const drawing *d, int32_t row, double rate)
{
    const hm_row *record = d->f->row + row;
    const char *unit = KIND[record->kind].unit;
    double speed[2];
    hm_say(text, "%s: ", d->f->text + record->name);
    if (record->kind == ROW_LENGTH && speeds_along(d, row, speed))
        hm_say(text,
               "the velocities of its points contradict it: along it they are %12g m/s and %12g "
               "m/s, and must be equal" ASSEMBLE,
               speed[0], speed[1]);
    else
        hm_say(text,
               "the velocities of its parts contradict it, by %6g%s%s; correct the "
               "velocities" ASSEMBLE,
               rate, *unit ? unit : " per second", *unit ? "/s" : "");
}

static double angle_of_cosine(double cosine) { return hm_acos(fmax(-1.0, fmin(1.0, cosine))); }

/* What is missing to a row, in the unit that a user knows. */
static double missing(const drawing *d, int32_t row, double whole)
{
    const int kind = (int)d->f->row[row].kind;
    double length, drawn;
    if (kind == ROW_ANGLE) {
        const double cosine = d->numbers[d->m->row_constant_at + row];
        return fabs(angle_of_cosine(cosine + d->phi[row]) - angle_of_cosine(cosine));
    }
    if (kind != ROW_LENGTH) return whole;
    lengths_of(d, row, &length, &drawn);
    return fabs(length - drawn);
}

static const char *unit_of(const drawing *d, int32_t row)
{
    const int kind = (int)d->f->row[row].kind, turns = d->m->row_power[row] == 0;
    if (kind == ROW_DRIVER || kind == ROW_COUPLED) return turns ? " rad" : " m";
    return kind == ROW_ANGLE ? " rad" : KIND[kind].unit;
}

/* Rate of a row where it is more than dependent rows may miss together, as those of axes that are
   almost parallel do; else 0. */
static double missed_speed(const drawing *d, int32_t row)
{
    const double most = LARGEST_CONTRADICTION * d->numbers[d->m->row_scale_at + row] * d->fastest;
    return fabs(d->rate[row]) > most ? speed_of(d, row) : 0.0;
}

/* With the setting `assemble` positions and velocities have been made consistent, so that a row
   which is still violated cannot be met at all: one sentence names the parts that fight, each with
   what is missing. */
static int say_fighting(hm_text *text, const drawing *d)
{
    int problems = 0;
    for (int pass = 0; pass < 2 && !problems; pass++) {
        const row_value value = pass ? missed_speed : drawn_gap;
        for (int32_t row = 0; row < d->m->n_rows; row++) {
            int32_t worst = row;
            double whole;
            if (value(d, row) == 0.0 || !gather(d, row, value, 1, &worst, &whole)) continue;
            hm_say(text, "%s",
                   problems++ ? ", "
                   : pass     ? "the mechanism has no velocities at this place that its joints and "
                            "drivers allow; these do not fit: "
                          : "the mechanism cannot be closed: joints contradict each other; in the "
                            "best pose that was "
                            "found these do not fit: ");
            hm_say(text, "%s (%3g%s%s)", d->f->text + d->f->row[worst].name,
                   pass ? whole : missing(d, worst, whole), unit_of(d, worst),
                   !pass                ? ""
                   : *unit_of(d, worst) ? "/s"
                                        : " per second");
        }
        if (problems)
            hm_say(text, "%s",
                   pass ? "; draw it beside its dead centre, or let its drivers start from rest"
                        : "; move a part, or correct a length or a driver");
    }
    return problems > 0;
}

static int has_gap(const drawing *d, uint32_t name)
{
    for (int32_t i = 0; i < d->m->n_rows; i++)
        if (d->f->row[i].name == name && drawn_gap(d, i) != 0.0) return 1;
    return 0;
}

int hm_contradicted_rows(hm_text *text, const hm_model_file *f, const double *numbers,
                         const hm_state *s, const double *phi, const double *rate)
{
    drawing drawn = {f, &f->model, numbers, phi, rate, s, 0.0};
    const drawing *d = &drawn;
    int problems = 0;
    drawn.fastest = fastest(d);
    if (s->head[S_ASSEMBLE] != 0.0) return say_fighting(text, d);
    for (int pass = 0; pass < 2; pass++) {
        const row_value value = pass ? speed_of : drawn_gap;
        for (int32_t row = 0; row < f->model.n_rows; row++) {
            int32_t worst = row;
            double whole;
            if (value(d, row) == 0.0 || !gather(d, row, value, !pass, &worst, &whole)) continue;
            if (pass && has_gap(d, f->row[row].name)) continue;
            if (problems++) hm_say(text, "\n");
            (pass ? say_velocity : say_position)(text, d, worst, whole);
        }
    }
    return problems;
}

/* ---------------------------------------------------------------------------------- dead centre */

static const double SHARE = 1e-3; /* of the largest lack, from which on a row is told */

/* Names of parts, or of bodies, each once, that `counts` finds in a row. */
typedef int (*row_test)(const drawing *d, int32_t row);

static int is_of_body(const drawing *d, int32_t row) { return d->f->row[row].kind == ROW_AXES; }

static double lack(const drawing *d, int32_t row)
{
    return fabs(d->phi[row]) / d->numbers[d->m->row_scale_at + row];
}

static int lacks(const drawing *d, int32_t row)
{
    double largest = 0.0;
    for (int32_t i = 0; i < d->m->n_rows; i++) largest = fmax(largest, lack(d, i));
    return !is_of_body(d, row) && lack(d, row) > SHARE * largest;
}

/* Whether a row is of a body whose angular velocity is not given. */
static int is_of_free_body(const drawing *d, int32_t row)
{
    return is_of_body(d, row) && row < d->m->n_form_rows
           && d->numbers[d->m->velocity_weight_at
                         + d->m->form_node[d->m->form_ptr[d->m->row_form[row]]]]
                  <= 1.0;
}

static int say_names(hm_text *text, const drawing *d, row_test counts, const char *before)
{
    int said = 0;
    for (int32_t row = 0; row < d->m->n_rows; row++) {
        int is_told = !counts(d, row);
        for (int32_t i = 0; i < row && !is_told; i++)
            is_told = d->f->row[i].name == d->f->row[row].name && counts(d, i);
        if (!is_told)
            hm_say(text, "%s%s", said++ ? ", " : before, d->f->text + d->f->row[row].name);
    }
    return said;
}

void hm_say_dead_centre(hm_text *text, const hm_model_file *f, const double *numbers,
                        const hm_state *s, const double *lacking)
{
    const drawing d = {f, &f->model, numbers, lacking, lacking, s, 0.0};
    hm_say(text, "the mechanism is drawn in a singular place, a dead centre, where branches of its "
                 "motion meet: ");
    say_names(text, &d, lacks, "");
    hm_say(text, " leave more velocities free there than beside it (holonom info: mobility by rank "
                 "and by counting), and those at the "
                 "start belong to no branch; give a velocity that chooses one");
    say_names(text, &d, is_of_free_body, ", such as that of ");
    hm_say(text, ", or draw the mechanism beside this place");
}

#include "small.h"
