/* What is said of a mechanism that was closed: what moved far from its drawing, whether other poses
   are as near, and which given velocity joints do not allow. */
#include "small.h"

#include "sentences.h"
#include "vectors.h"

enum { MOST_TOLD = 5 };
static const double TENTH = 0.1;      /* of the size of the mechanism, or of a full turn */
static const double ROUND_OFF = 1e-9; /* of a way over that size, and of a turn */
static const double SLOW = 1e-3;      /* of the fastest motion: what is slower counts as at rest */

/* Way of a part from its drawing [m], and the angle it turned by [rad]. */
typedef struct move {
    const char *name;
    int length;
    double way, turn;
} move;

/* Component k of measured place j, the end of a link, at coordinates q. */
static double measured_place(const hm_model_file *f, const double *numbers, const double *q,
                             int32_t j, int k)
{
    const holonom_model *m = &f->model;
    const int32_t form = m->place_form[j];
    double sum = 0.0;
    for (int32_t e = m->form_ptr[form]; e < m->form_ptr[form + 1]; e++) {
        const double *place = hm_place_of_node(m, numbers, q, m->form_node[e]);
        sum += numbers[m->alpha_at + e] * place[k];
        if (DIM == 2 && m->form_kind[form] & FORM_TURNED)
            sum += numbers[m->alpha_turn_at + e] * (k ? 1.0 : -1.0) * place[1 - k];
    }
    return sum;
}

/* Angle between two orientations of the body with first director `a`. */
static double turned_angle(const double *now, const double *drawn, int32_t a)
{
    double cosines = 0.0, sine = 0.0;
    const double *d = drawn + DIM * a, *e = now + DIM * a;
    for (int k = 0; k < (DIM == 2 ? 2 : 9); k++) cosines += d[k] * e[k];
    if (DIM == 2) {
        sine = d[0] * e[1] - d[1] * e[0];
        return hm_atan2(sine, cosines);
    }
    return hm_acos(fmax(-1.0, fmin(1.0, 0.5 * (cosines - 1.0))));
}

/* The angle that the body of this name turned by; 0 if there is none. */
static double turn_of(const hm_model_file *f, const double *numbers, const hm_state *s,
                      const char *name, int length)
{
    const holonom_model *m = &f->model;
    for (int32_t i = first_rigidity_row(m); i < m->n_form_rows; i++)
        /* the first of a body has its first director */
        if (hm_is_of_body(f, i, name, (size_t)length))
            return turned_angle(s->q, numbers + m->initial_position_at,
                                m->form_node[m->form_ptr[m->row_form[i]]]);
    return 0.0;
}

/* How far the part moved whose x coordinate this variable is; 0 if it is none of a point or of the
   origin of a body. */
static int find_move(const hm_model_file *f, const double *numbers, const hm_state *s,
                     const hm_variable *v, move *x)
{
    const holonom_model *m = &f->model;
    const char *name = f->text + v->name, *dot = strchr(name, '.');
    const hm_measured y = hm_measured_in(f, numbers);
    const int32_t first_place = (int32_t)(y.place - y.position);
    double square = 0.0;
    if (v->kind != KIND_MEASURED || !dot || strcmp(dot, ".x")) return 0;
    const int is_node = v->place < DIM * m->n_free; /* driven nodes go where they must */
    if (!is_node && (v->place < first_place || v->place >= first_place + DIM * m->n_places))
        return 0;
    for (int k = 0; k < DIM; k++) {
        const double *drawn = numbers + m->initial_position_at;
        const int32_t j = (v->place - first_place) / DIM;
        const double way = is_node ? s->q[v->place + k] - drawn[v->place + k]
                                   : measured_place(f, numbers, s->q, j, k)
                                         - measured_place(f, numbers, drawn, j, k);
        square += way * way;
    }
    *x = (move){name, (int)(dot - name), sqrt(square),
                turn_of(f, numbers, s, name, (int)(dot - name))};
    return 1;
}

/* How far that is, over a tenth of the mechanism or of a turn. */
static double farness(const hm_model_file *f, const double *numbers, const move *x)
{
    const double turn = 6.283185307179586;
    return fmax(x->way / numbers[f->model.extent_at], fabs(x->turn) / turn) / TENTH;
}

/* Says which parts moved far, the farthest first; returns how many. */
static int say_moves(hm_text *text, const hm_model_file *f, const double *numbers,
                     const hm_state *s)
{
    double last = INFINITY;
    uint32_t last_variable = 0;
    int told = 0, all = 0;
    for (uint32_t k = 0; k < f->header->n_variables; k++) {
        move x;
        all += find_move(f, numbers, s, f->variable + k, &x) && farness(f, numbers, &x) > 1.0;
    }
    for (; told < all && told < MOST_TOLD; told++) {
        move next = {0}, x;
        uint32_t at = 0;
        double most = 0.0;
        for (uint32_t k = 0; k < f->header->n_variables; k++) {
            if (!find_move(f, numbers, s, f->variable + k, &x)) continue;
            const double far = farness(f, numbers, &x);
            if (far > most && (far < last || (far == last && k > last_variable)))
                most = far, at = k, next = x;
        }
        hm_say(text, "%s", told ? ", " : "closing the mechanism moved ");
        hm_say_part(text, next.name, (size_t)next.length);
        const int goes = next.way > ROUND_OFF * numbers[f->model.extent_at],
                  turns = fabs(next.turn) > ROUND_OFF;
        if (goes) hm_say(text, " by %3g m", next.way);
        if (turns) hm_say(text, " %s %3g rad", goes ? "and" : "by", next.turn);
        last = most, last_variable = at;
    }
    if (all > told) hm_say(text, " and %d more", all - told);
    if (all)
        hm_say(text,
               ", more than a tenth of its size, %3g m, or of a turn; draw what moved nearer to "
               "its place",
               numbers[f->model.extent_at]);
    return all;
}

/* Velocity of node a in motion v [m/s], or the angular velocity of the body that it is the first
   director of [rad/s]; its size. */
static double rate_of(const holonom_model *m, int32_t a, const double *q, const double *v,
                      double *rate)
{
    double square = 0.0;
    const int n = m->node_kind[a] ? TURNING : DIM;
    if (m->node_kind[a]) turn_of_directors(q + DIM * a, v + DIM * a, rate);
    else memcpy(rate, v + DIM * a, sizeof(double) * DIM);
    for (int k = 0; k < n; k++) square += rate[k] * rate[k];
    return sqrt(square);
}

/* Says which given velocity joints have changed most, if by more than a tenth of it. */
static void say_changed_velocity(hm_text *text, int others, const hm_model_file *f,
                                 const double *numbers, const hm_state *s)
{
    const holonom_model *m = &f->model;
    double most = TENTH, far = 0.0, fastest = 0.0, unused[DIM];
    int32_t worst = -1;
    for (int32_t a = 0; a < m->n_free; a++)
        if (m->node_kind[a] <= NODE_DIRECTION)
            fastest = fmax(fastest, rate_of(m, a, s->q, s->v, unused)
                                        / (m->node_kind[a] ? 1.0 : numbers[m->extent_at]));
    for (int32_t a = 0; a < m->n_free; a++) {
        double given[DIM], now[DIM], square = 0.0;
        if (m->node_kind[a] > NODE_DIRECTION || numbers[m->velocity_weight_at + a] <= 1.0) continue;
        const double size = rate_of(m, a, numbers + m->initial_position_at,
                                    numbers + m->initial_velocity_at, given);
        const double own = rate_of(m, a, s->q, s->v, now);
        for (int k = 0; k < (m->node_kind[a] ? TURNING : DIM); k++)
            square += hm_square(now[k] - given[k]);
        const double least = SLOW * fastest * (m->node_kind[a] ? 1.0 : numbers[m->extent_at]);
        const double change = sqrt(square) / fmax(fmax(size, own), least / TENTH);
        if (change > most) worst = a, far = sqrt(square), most = change;
    }
    if (worst < 0) return;
    hm_say(text, "%sjoints%s do not allow the velocity that is given for ", others ? "; " : "",
           m->n_signals ? " and drivers" : "");
    hm_say_node(text, f, worst);
    hm_say(text, ": it starts %3g %s away from it", far, m->node_kind[worst] ? "rad/s" : "m/s");
    hm_say(text, "; give velocities that belong to one motion, or one alone");
}

int hm_say_closing(hm_text *text, const hm_model_file *f, const double *numbers, const hm_state *s)
{
    const double *head = s->head;
    const size_t begin = text->used;
    if (say_moves(text, f, numbers, s) && head[S_CLOSING] == CLOSING_BEHIND_PATH)
        hm_say(text, "; on the way from the drawing it came to a dead centre, and may have gone to "
                     "another branch");
    if (text->used > begin && head[S_CLOSING] == CLOSING_SHAKEN)
        hm_say(text,
               "; the drawing itself leads to no pose, this one was found from one of %d drawings "
               "that were shaken",
               (int)head[S_CLOSING_TRIES]);
    if (head[S_CLOSING_OTHERS] != 0.0)
        hm_say(text,
               "%s another pose closes it, too, and is as near to the drawing: turn a body towards "
               "the one that is meant",
               text->used > begin ? ";" : "closing the mechanism:");
    say_changed_velocity(text, text->used > begin, f, numbers, s);
    return text->used > begin;
}

#include "small.h"
