/* What is said of steps that fail, and of what a run shows though it goes on. */
#include "small.h"

#include "coarseness.h"
#include "sentences.h"

#define HALVED_SO_OFTEN "even with the step halved again and again"
#define HALVED HALVED_SO_OFTEN "; "
#define FAR_APART                                                                                  \
    "; if not, look for a driver that asks for a place out of reach, or for masses or sizes that " \
    "are many powers of ten apart"
#define SMALLER                                                                                    \
    "a smaller solver.step_size, or solver.longest_step with a tolerance, or a larger "            \
    "solver.max_newton usually helps" FAR_APART

static const double LEDGER_OPEN =
    1e3; /* error of the ledger, over newton_tolerance, that no run of solved steps comes to */
static const double FAR_APART_MASSES =
    1e5; /* from here on light parts are told in a step that is not solved */
static const double LEDGER_LONG =
    1e-9; /* error of the ledger that round-off of a long run may come to */

const char *hm_about_step(int32_t status)
{
    switch (status) {
    case HOLONOM_OK: return "done";
    case HOLONOM_NEWTON_DIVERGED: return "Newton's iteration did not converge, " HALVED SMALLER;
    case HOLONOM_UZAWA_DIVERGED:
        return "the constraints could not be met, " HALVED
               "check that the lengths can be closed; a larger solver.penalty or "
               "solver.max_uzawa may help" FAR_APART;
    case HOLONOM_SINGULAR_TANGENT:
        return "the tangent matrix is singular, " HALVED
               "look for a force that pushes without bound, or use a smaller solver.penalty";
    case HOLONOM_NOT_FINITE: return "a number grew beyond all bounds, " HALVED SMALLER;
    case HOLONOM_ZERO_LENGTH:
        return "a spring, damper, torque, driver or formula acts along two points that coincide, "
               "or by an angle of a vector of "
               "length zero, so that its direction is undefined; move the points apart, or use a "
               "spring with free_length = 0";
    case HOLONOM_BAD_STEP:
        return "the step must be a finite number > 1e-100 s and at most 1e9 internal steps long; "
               "use a shorter communication step or a "
               "larger solver.step_size";
    case HOLONOM_BAD_LAW:
        return "a stiffness, free length or damping became negative, or a spring, damper or "
               "potential not a number; look at their "
               "expressions at this time and with these inputs";
    case HOLONOM_TURN_TOO_LARGE:
        return "a body turns by more than 2.5 rad within a half step, " HALVED
               "a smaller solver.step_size is needed to tell which way it "
               "turns";
    case HOLONOM_DAMPING_REVERSED:
        return "dampers fed energy, " HALVED_SO_OFTEN
               ": steps of an order above 2 also go back, too far for such "
               "strong dampers; use solver.order = 2 or a smaller step_size";
    case HOLONOM_STOPPED: return "it was interrupted; all is as before it";
    case HOLONOM_STEP_COLLAPSED:
        return "the internal step collapsed: solver.tolerance asks for more than 1e6 pairs of half "
               "steps in this communication "
               "step, or for a shorter one after 40 tries; take shorter communication steps or a "
               "wider solver.tolerance; if neither "
               "helps, look for masses or sizes that are many powers of ten apart";
    case HOLONOM_BAD_DRIVER:
        return "it has no finite value at this time, and velocities or forces would be infinite; "
               "write a formula that is smooth there, "
               "as t**2 is and t**1.5 is not, or start at another time";
#if !defined(HOLONOM_STATIC)
    case HOLONOM_MESH_EVENTS:
        return "contacts or frictions change in another order than in the run whose mesh is "
               "repeated; change its numbers by less, or record "
               "a mesh with these";
    case HOLONOM_MESH_METHODS:
        return "a step cannot be taken as in the run whose mesh is repeated; change its numbers by "
               "less, or record a mesh with these";
    case HOLONOM_MESH_SWITCHES:
        return "it changes in another order, or in another communication step, than in the run "
               "whose mesh is repeated; change its numbers by less, or record a mesh with these";
    case HOLONOM_MESH_STEPPED:
        return "contacts of the run whose mesh is repeated change at the ends of half steps, and "
               "no event is located (solver.stepped is 1); "
               "repeat a run with solver.contact_mode located that ends before";
#endif
    case HOLONOM_LAW_SWITCHES:
        return "it switches 1000 times at one moment, or hundreds of thousands of times in this "
               "communication step; give it a hysteresis, or "
               "a slope in the place of the jump, as min(max(20*x, -1), 1) has for sign(x); a "
               "force -c*sign(s) that rubs holds where s is the rate along which it acts, and c "
               "of numbers, parameters and s alone";
    case HOLONOM_NEXT_STATE:
        return "its next value is not a finite number; look at its formula at this time and with "
               "these inputs";
    case HOLONOM_SIGNAL_JUMPS:
        return "what it drives would jump to another place in this communication step; let its "
               "value go there smoothly, over some time";
#if HM_CONTACTS
    case HOLONOM_CONTACT_UNDECIDED:
        return "no choice of closed contacts and sticking frictions agrees with the forces; there "
               "may be several or none where friction "
               "is strong: look at its coefficient and at contacts that hold the same thing twice, "
               "or give them a smooth_speed";
    case HOLONOM_IMPACT_UNSOLVED:
        return "no impulses were found that obey the law of impact; look for a driver that pushes "
               "against the contact, for contacts "
               "that hold the same thing twice, or for masses that are many powers of ten apart";
    case HOLONOM_PENETRATION: return "its gap is negative at the start; draw its parts apart";
    case HOLONOM_TOO_MANY_EVENTS:
        return "contacts change more often than solver.max_events in a communication step; take "
               "shorter ones, or larger "
               "solver.max_events, solver.rest_speed or solver.rest_time";
#endif
    default: return "it ended with an unknown status, a fault of this program; please report it";
    }
}

typedef struct part_name {
    char text[NAME_ROOM];
} part_name;

/* Name of the part that the measurement at `place` is of; empty if there is none. */
static part_name name_of_part(const hm_model_file *f, int32_t place)
{
    part_name found;
    hm_text name = {found.text, sizeof found.text, 0};
    hm_clear(&name);
    for (uint32_t k = 0; k < f->header->n_variables && !name.used; k++) {
        const hm_variable *v = f->variable + k;
        if (v->kind == KIND_MEASURED && v->place == place) hm_say(&name, "%s", f->text + v->name);
    }
    size_t end = name.used;
    for (size_t k = 0; k < name.used; k++)
        if (found.text[k] == '.') end = k;
    hm_take_back(&name, end);
    return found;
}

/* Row of rigidity of a body: by its name, or by one of its directions. */
static int is_row_of(const hm_model_file *f, int32_t row, const char *name, int32_t node)
{
    const holonom_model *m = &f->model;
    if (!m->node_kind[node]) return *name && hm_is_of_body(f, row, name, strlen(name));
    for (int32_t e = m->form_ptr[m->row_form[row]]; e < m->form_ptr[m->row_form[row] + 1]; e++)
        if (m->form_node[e] == node) return 1;
    return 0;
}

int hm_say_node(hm_text *text, const hm_model_file *f, int32_t node)
{
    const holonom_model *m = &f->model;
    const part_name name = name_of_part(f, m->node_kind[node] ? -1 : DIM * node);
    for (int32_t i = first_rigidity_row(m); i < m->n_form_rows; i++)
        if (is_row_of(f, i, name.text, node)) {
            hm_say(text, "%s", f->text + f->row[i].name);
            return 1;
        }
    if (*name.text) hm_say(text, "point '%s'", name.text);
    return *name.text != '\0';
}

/* Says the part of a node with a colon; nothing if none is known. */
static void say_fault_node(hm_text *text, const hm_model_file *f, const char *before, int32_t node)
{
    const size_t begin = text->used;
    hm_say(text, "%s", before);
    if (hm_say_node(text, f, node)) hm_say(text, ": ");
    else hm_take_back(text, begin);
}

/* Says what of a signal is not finite, and its driver or constraint: 3 b + 0, 1 or 2, see
   blame_signal. */
static void say_signal(hm_text *text, const hm_model_file *f, const double *numbers, int32_t what)
{
    static const char *const OF[] = {"the value of ", "the rate of ", "the second derivative of "};
    const holonom_model *m = &f->model;
    const int32_t b = what / 3, first = first_function_row(m);
    hm_say(text, "%s", OF[what % 3]);
    if (b < DIM * m->n_driven) {
        const hm_measured y = hm_measured_in(f, numbers);
        part_name name = name_of_part(f, (int32_t)(y.driven_force - y.position) + b);
        name.text[strcspn(name.text, ".")] = '\0'; /* hand, of hand.force.x */
        hm_say(text, "driver '%s': ", name.text);
        return;
    }
    for (int32_t row = first; row < m->n_rows; row++) {
        const int32_t j = m->n_elements + row - first;
        for (int32_t at = m->leaf_ptr[j]; at < m->leaf_ptr[j + 1]; at++)
            if (m->leaf[4 * at] == LEAF_SIGNAL && m->leaf[4 * at + 1] == b) {
                hm_say(text, "%s: ", f->text + f->row[row].name);
                return;
            }
    }
}

static int is_no_number(const double *x, int32_t n)
{
    for (int32_t k = 0; k < n; k++)
        if (!(fabs(x[k]) < INFINITY)) return 1;
    return 0;
}

int hm_say_composite(hm_text *text, const hm_model_file *f, const double *numbers, int32_t j)
{
    const holonom_model *m = &f->model;
    const int32_t row = first_function_row(m) + j - m->n_elements;
    const hm_measured y = hm_measured_in(f, numbers);
    if (j >= m->n_elements) {
        hm_say(text, "%s", row < m->n_rows ? f->text + f->row[row].name : "a contact that yields");
        return 1;
    }
    const part_name name = name_of_part(f, (int32_t)(y.element_force - y.position) + j);
    if (*name.text) hm_say(text, "'%s'", name.text);
    return *name.text != '\0';
}

/* Says a spring or damper, what it does, and a colon. */
static void say_element(hm_text *text, const hm_model_file *f, const double *numbers, int32_t j,
                        const char *does)
{
    if (hm_say_composite(text, f, numbers, j)) hm_say(text, "%s: ", does);
}

/* Says a load, spring or damper whose law gives no number, or one that it may not give. */
static void say_broken_law(hm_text *text, const hm_model_file *f, const double *numbers)
{
    const holonom_model *m = &f->model;
    const int32_t turning = 2 * DIM - 3;
    static const char FORCE[] = "a force is not a finite number, on ",
                      TORQUE[] = "a torque is not a finite number, on ";
    for (int32_t j = 0; j < m->n_elements && !text->used; j++) {
        const double law[] = {numbers[m->stiffness_at + j], numbers[m->rest_at + j],
                              numbers[m->damping_at + j], numbers[m->drive_at + j]};
        const int is_length = m->quantity_kind[m->leaf[4 * m->leaf_ptr[j] + 1]] == QUANTITY_LENGTH;
        if (!is_no_number(law, 4) && law[0] >= 0.0 && (law[1] >= 0.0 || !is_length)
            && law[2] >= 0.0)
            continue;
        say_element(text, f, numbers, j, "");
    }
    for (int32_t j = 0; j < m->n_loads && !text->used; j++)
        if (is_no_number(numbers + m->load_at + DIM * j, DIM))
            say_fault_node(text, f, FORCE, m->form_node[m->form_ptr[m->load_form[j]]]);
    for (int32_t j = 0; j < m->n_moments && !text->used; j++)
        if (is_no_number(numbers + m->moment_at + turning * j, turning))
            say_fault_node(text, f, TORQUE, m->form_node[m->form_ptr[m->moment_form[j]]]);
    for (int32_t j = 0; j < m->n_body_moments && !text->used; j++)
        if (is_no_number(numbers + m->body_moment_at + 3 * j, 3))
            say_fault_node(text, f, TORQUE, m->body_moment[2 * j]);
}

static int lacks_solution(int32_t status)
{
    return status <= HOLONOM_NOT_FINITE || status == HOLONOM_TURN_TOO_LARGE
           || status == HOLONOM_STEP_COLLAPSED || status == HOLONOM_DAMPING_REVERSED;
}

void hm_say_fault(hm_text *text, const hm_model_file *f, const double *numbers, const double *head,
                  int32_t status)
{
    const int is_sure = status >= HOLONOM_CONTACT_UNDECIDED;
    const int32_t fault = is_sure || lacks_solution(status) ? (int32_t)head[S_AT_FAULT] - 1 : -1,
                  n_rows = (int32_t)f->header->n_rows;
    if (lacks_solution(status) || status == HOLONOM_BAD_LAW) say_broken_law(text, f, numbers);
    if (text->used || fault < 0) return;
    if (status == HOLONOM_LAW_SWITCHES || status == HOLONOM_SIGNAL_JUMPS
        || status == HOLONOM_MESH_SWITCHES || status == HOLONOM_NEXT_STATE)
        hm_say(text, "%s: ", f->text + f->switches[fault]);
    else if (status == HOLONOM_BAD_DRIVER)
        say_signal(text, f, numbers, fault - n_rows - f->model.n_free - f->model.n_driven);
    else if (fault < n_rows)
        hm_say(text, "%s%s: ", is_sure ? "" : "near ", f->text + f->row[fault].name);
    else if (fault - n_rows < f->model.n_free) say_fault_node(text, f, "near ", fault - n_rows);
    else
        say_element(text, f, numbers, fault - n_rows - f->model.n_free,
                    " passes through length zero, where the direction of its force jumps; a spring "
                    "with free_length = 0 does not jump there");
}

void hm_say_far_apart(hm_text *text, const hm_model_file *f, const double *numbers, int32_t status)
{
    const holonom_model *m = &f->model;
    const double *mass = numbers + m->node_mass_at;
    int32_t heaviest = -1, lightest = -1;
    if (!lacks_solution(status)) return;
    for (int32_t a = 0; a < m->n_free; a++) {
        if (m->node_kind[a] || !(mass[a] > 0.0)) continue;
        if (heaviest < 0 || mass[a] > mass[heaviest]) heaviest = a;
        if (lightest < 0 || mass[a] < mass[lightest]) lightest = a;
    }
    if (heaviest < 0 || !(mass[heaviest] > FAR_APART_MASSES * mass[lightest])) return;
    const part_name heavy = name_of_part(f, DIM * heaviest),
                    light = name_of_part(f, DIM * lightest);
    if (*heavy.text && *light.text)
        hm_say(text,
               "; '%s' has %3g times the mass of '%s', which it throws about where they come into "
               "line",
               heavy.text, mass[heaviest] / mass[lightest], light.text);
}

/* Friction from here on keeps no digit of what sliding changes of the forces of a step. */
static const double STRONG_FRICTION = 1e5;
static const double STRONG_ENOUGH = 1e3; /* what holds as well, in any scene */

int hm_say_strong_friction(hm_text *text, const hm_model_file *f, const double *numbers,
                           int32_t status)
{
    const holonom_model *m = &f->model;
    const double *coefficient = numbers + m->static_at;
    int32_t worst = -1;
    if (!HM_CONTACTS || !(lacks_solution(status) || status == HOLONOM_CONTACT_UNDECIDED)) return 0;
    for (int32_t k = 0; k < m->n_frictions; k++)
        if (coefficient[k] >= STRONG_FRICTION && (worst < 0 || coefficient[k] > coefficient[worst]))
            worst = k;
    if (worst < 0) return 0;
    const int32_t row = first_function_row(m) - m->n_elements
                        + m->friction_row[m->friction_row_ptr[worst]];
    hm_say(text,
           "%s: a friction of %6g is so strong that the forces of a step keep no digits; "
           "one of %6g holds as well, and a joint holds whatever comes",
           f->text + f->row[row].name, coefficient[worst], STRONG_ENOUGH);
    return 1;
}

static int model_has_dampers(const hm_model_file *f, const double *numbers)
{
    for (int32_t j = 0; j < f->model.n_elements; j++)
        if (numbers[f->model.damping_at + j] != 0.0) return 1;
    for (int32_t j = 0; j < f->model.n_potentials; j++)
        if (f->model.force_role[j] != STORES) return 1;
    return 0;
}

/* Says which settings a step with contacts that are not located did not follow; nothing where it
   followed all. Returns whether it is so for all steps. */
static int say_stepped(hm_text *text, const double *head)
{
    const int is_lasting = head[S_CONTACT_MODE] != 0.0;
    const double tolerance = is_lasting ? head[S_TOLERANCE] : hm_tolerance(head);
    if (!(tolerance > 0.0) && head[S_ORDER] <= 2.0) return 0;
    hm_say(text, "%s is %6g, but steps in which contacts change without being located ",
           tolerance > 0.0 ? "the tolerance" : "solver.order",
           tolerance > 0.0 ? tolerance : head[S_ORDER]);
    if (tolerance > 0.0)
        hm_say(text,
               "are equal steps of at most solver.step_size = %6g s, of order 2, whose error no "
               "tolerance bounds; %s",
               hm_step_size(head),
               is_lasting ? "use contact_mode = \"located\", or a smaller solver.step_size"
                          : "a smaller solver.step_size helps");
    else hm_say(text, "are of order 2");
    return is_lasting;
}

/* Says what kept a step at order 2: springs under a tolerance, else losses; nothing where none is
   due. Returns whether it is so for
   all steps, by what the mechanism is and its settings, and not for one that was too long, or at
   rest. */
static int say_order_limit(hm_text *text, const hm_model_file *f, const double *numbers,
                           const double *head)
{
    if (HM_CONTACTS && head[S_STEPPED] != 0.0) return say_stepped(text, head);
    const int has_left_order = !(hm_tolerance(head) > 0.0) && head[S_AS_PAIRS] > 0.0;
    if (!has_left_order && !(head[S_ORDER] > head[S_ORDER_IN_USE])) return 0;
    hm_say(text, "solver.order is %6g, but steps are of order 2: ", head[S_ORDER]);
    if (hm_tolerance(head) > 0.0)
        hm_say(text, "springs are much faster than the motion, and steps of a higher order that do "
                     "not resolve them would swing them up; a tight solver.tolerance takes many "
                     "steps of order 2, or resolves them");
    else
        hm_say(text,
               "%s energy out, and the motion changes too much in a step of this length, "
               "or not at all",
               model_has_dampers(f, numbers) ? "dampers take" : "friction with smooth_speed takes");
    return 0;
}

void hm_say_newton(hm_text *text, const double *head, const char *when)
{
    if (!HM_CONTACTS || head[S_NEWTON_IMPACTS] == 0.0) return;
    const int one = head[S_NEWTON_IMPACTS] == 1.0;
    hm_say(text,
           "%6g impact%s %s %s Newton's restitution, lowered until no energy arises, "
           "since the energetic law found no impulses "
           "(solver.newton_impacts counts them); contacts that hold the same thing twice and "
           "strong friction make that likely",
           head[S_NEWTON_IMPACTS], one ? "" : "s", when, one ? "has" : "have");
}

/* Says that friction acted at the ends of pieces of half steps. */
static void say_deferred(hm_text *text, const double *head)
{
    if (!HM_CONTACTS || head[S_DEFERRED_FRICTIONS] == 0.0) return;
    hm_say(text,
           "until t = %6g s the friction of contacts acts at the end of %6g short pieces of half "
           "steps alone, inside its cones, since no "
           "choice of those that stick agreed with the forces (solver.deferred_frictions counts "
           "them); a smaller solver.step_size "
           "makes the error smaller",
           head[S_TIME], head[S_DEFERRED_FRICTIONS]);
}

/* Says that energies are off the ledger though steps are solved. */
static void say_open_ledger(hm_text *text, const double *head)
{
    const double limit = fmax(LEDGER_OPEN * head[S_NEWTON_TOLERANCE], LEDGER_LONG);
    if (head[S_LEDGER_ERROR] <= limit) return;
    hm_say(text,
           "the energy is off by %1e of the reference energy at t = %6g s though steps are solved: "
           "round-off is too large for this "
           "mechanism; draw it closer to the origin, with sizes, masses and stiffnesses less far "
           "apart, or take longer steps",
           head[S_LEDGER_ERROR], head[S_TIME]);
}

/* Says that a load that reads the mechanism came too seldom. */
static void say_missed_load(hm_text *text, const hm_model_file *f, const hm_state *s)
{
    const double *head = s->head;
    int32_t worst = 0;
    for (int32_t i = 1; i < f->model.n_sampled; i++)
        if (s->sampled[3 * i + 2] > s->sampled[3 * worst + 2]) worst = i;
    if (!f->model.n_sampled || !(s->sampled[3 * worst + 2] > HOLONOM_MOST_SAMPLING)) return;
    hm_say(text,
           "%s is evaluated too seldom, once in a half step: until t = %6g s the motion that it "
           "causes changed its work by %1f "
           "times the work foreseen; it alternates or reverses what it should stop; use a damper "
           "or torsion_damper instead, make "
           "its formula smoother, or take ",
           f->text + f->sampled[worst], head[S_TIME], s->sampled[3 * worst + 2]);
    if (hm_tolerance(head) > 0.0 && head[S_STEPPED] == 0.0)
        hm_say(text, "a smaller solver.longest_step");
    else hm_say(text, "steps shorter than solver.step_size = %6g s", hm_step_size(head));
}

/* Node whose acceleration changed most in the last pair, in the mass norm. */
static int32_t most_accelerated(const holonom_model *m, const double *numbers, const hm_state *s)
{
    double most = 0.0;
    int32_t found = 0;
    for (int32_t a = 0; a < m->n_free; a++) {
        double square = 0.0;
        for (int32_t k = DIM * a; k < DIM * (a + 1); k++)
            square +=
                hm_square((s->a[0][k] - s->a_before[0][k]) + (s->a[1][k] - s->a_before[1][k]));
        square *= numbers[m->node_mass_at + a];
        if (square > most) most = square, found = a;
    }
    return found;
}

#define TOLD 1e-3    /* least error of a path that is told, over the size or in rad */
#define ROUNDED_SHORTER 0.95 /* rounding to two digits makes a length at most 5 % longer */
#define TURN_ERROR 2e-4 /* of a step in which a body turns by as much as it may [rad] */

/* What is off at the end of a run with equal steps that are too long. */
typedef struct coarse_run {
    double turn, longest, place, angle,
        size; /* of a body in a step, and the most it may be [rad]; errors [m, rad] and size [m] */
    double velocity, reaction; /* relative errors of a body that drivers turn, else 0 */
} coarse_run;

/* Relative error of the reactions of a body that drivers turn by x in a step, of this square. Of an
   even turn, at order 2 every other half step has rates x^2/24 too large, if x is small, and
   reactions are x^2/3 too large; the denominators are measured of shafts with x from 0.5 to 2.4. At
   higher orders reactions are those of the state, and err as rates do; the factors are measured of
   shafts with x from 0.5 to 2.2. It is so for free bodies, too, whose path tells more. */
static double error_of_reactions(double order, double square)
{
    if (order <= 2.0) return square / (3.0 + square);
    const double factor = order > 6.0 ? 1.1e-10 : order > 4.0 ? 6e-7 : 5e-4;
    return factor * hm_pow(square, 0.5 * order);
}

static coarse_run judge_run(const hm_model_file *f, const double *numbers, const hm_state *s)
{
    const double *head = s->head, turn = sqrt(head[S_TURNED]), longest = hm_longest_turn(head);
    const int is_led = turn >= longest && s->freedom[(int32_t)head[S_TURNING]] == 0.0;
    const double order = hm_order_of_steps(head);
    return (coarse_run){turn,
                        longest,
                        hm_error_of_steps(head, head[S_PLACE_ERROR], head[S_EQUAL_STEPS]),
                        hm_error_of_steps(head, head[S_ANGLE_ERROR], head[S_EQUAL_STEPS]),
                        numbers[f->model.extent_at],
                        is_led && order <= 2.0 ? head[S_TURNED] / (24.0 + 2.0 * head[S_TURNED])
                                               : 0.0,
                        is_led ? error_of_reactions(order, head[S_TURNED]) : 0.0};
}

/* Length of equal steps that is short enough for an error of HOLONOM_USUAL_TOLERANCE. */
static double short_enough(const double *head, const coarse_run *x)
{
    const double order = hm_order_of_steps(head), turn = fmax(x->turn, x->longest) / x->longest;
    double error = fmax(fmax(x->place / x->size, x->angle), x->reaction);
    if (!(error > 0.0)) error = head[S_EQUAL_STEPS] * TURN_ERROR * hm_pow(turn, order + 1.0);
    return ROUNDED_SHORTER * head[S_COARSE_LENGTH]
           * fmin(hm_pow(HOLONOM_USUAL_TOLERANCE / error, 1.0 / order), 0.9 / turn);
}

static void say_what_is_off(hm_text *text, const double *head, const coarse_run *x)
{
    if (x->reaction > 0.0) {
        hm_say(text, "; drivers give its place, but ");
        if (x->velocity > 0.0)
            hm_say(text, "velocities are off by about %2g %s and ", 100.0 * x->velocity, "%");
        hm_say(text, x->velocity > 0.0 ? "reactions by about %2g %s"
                                       : "reactions are off by about %2g %s",
               100.0 * x->reaction, "%");
    }
    const size_t begin = text->used;
    hm_say(text, "; after %4g s", head[S_EQUAL_TIME]);
    if (x->angle > TOLD) hm_say(text, " angles are off by about %2g rad", x->angle);
    if (x->angle > TOLD && x->place > TOLD * x->size) hm_say(text, ", and");
    if (x->place > TOLD * x->size) hm_say(text, " places are off by about %2g m", x->place);
    if (fmax(x->angle, x->place / x->size) > TOLD) return;
    if (x->reaction > 0.0) hm_take_back(text, begin);
    else hm_say(text, " the path may be far off");
}

/* Says of a run with equal steps that they are too long for the motion, as soon as they are; at the
   end of the run by how much it is off, and which step is short enough. */
static void say_coarse_steps(hm_text *text, const hm_model_file *f, const double *numbers,
                             const hm_state *s, int is_over)
{
    const double *head = s->head;
    const coarse_run x = judge_run(f, numbers, s);
    const int turns = x.turn >= x.longest || x.angle > x.place / x.size,
              is_stepped = head[S_STEPPED] != 0.0;
    hm_say(text, "steps of %3g s are too long for this motion: ", head[S_COARSE_LENGTH]);
    if (!hm_say_node(text, f,
                     turns ? (int32_t)head[S_TURNING] : most_accelerated(&f->model, numbers, s)))
        hm_say(text, "a part");
    if (turns) hm_say(text, " turns %3g rad in one", x.turn);
    else hm_say(text, " changes its acceleration too fast");
    if (is_over) say_what_is_off(text, head, &x);
    if (!is_stepped)
        hm_say(text, "; leave solver.%s out, so that steps follow the motion",
               !(head[S_ORDER] > 0.0)        ? "step_size"
               : head[S_STEP_SIZE] > 0.0 ? "step_size and solver.order"
                                         : "order");
    if (is_over)
        hm_say(text, "%s set solver.step_size <= %2g s, for an error of about %6g",
               is_stepped ? ";" : ", or", short_enough(head, &x), HOLONOM_USUAL_TOLERANCE);
    else if (is_stepped) hm_say(text, "; set a smaller solver.step_size");
}

/* Whether a run with equal steps has lasted as long as it was to. */
static int is_over(const double *head)
{ return head[S_EQUAL_TIME] >= (1.0 - 1e-9) * head[S_HORIZON]; }

int hm_remark(hm_text *text, const hm_model_file *f, const double *numbers, const hm_state *s,
              int said, int heard)
{
    if (!(said & REMARK_NUMBERS)) hm_broken_rules(text, f, numbers, RULES_NOTED);
    said |= REMARK_NUMBERS;
    for (int what = REMARK_ORDER; what <= REMARK_DEFERRED; what *= 2) {
        const size_t begin = text->used;
        if (said & what) continue;
        if (begin) hm_say(text, "\n");
        const size_t first = text->used;
        int lasting = 1;
        if (what == REMARK_ORDER) lasting = say_order_limit(text, f, numbers, s->head);
        else if (what == REMARK_LEDGER) say_open_ledger(text, s->head);
        else if (what == REMARK_NEWTON) hm_say_newton(text, s->head, "of this step");
        else if (what == REMARK_DEFERRED) say_deferred(text, s->head);
        else if (what == REMARK_SAMPLING) say_missed_load(text, f, s);
        else if (s->head[S_COARSENESS] > HOLONOM_MOST_COARSENESS
                 && is_over(s->head) == (what == REMARK_COARSE_RUN))
            say_coarse_steps(text, f, numbers, s, what == REMARK_COARSE_RUN);
        if (text->used > first && (lasting || heard)) said |= what;
        else hm_take_back(text, begin);
    }
    return said;
}

#include "small.h"
