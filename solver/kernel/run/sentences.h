/* What is said to users: about values, drawings, and runs that go on. */
#ifndef HOLONOM_SENTENCES_H
#define HOLONOM_SENTENCES_H

#include "chosen_steps.h"
#include "model_file.h"
#include "text.h"

#include <string.h>

/* Of a part of a sentence: names of scenes and parts have at most 200 characters. */
enum { NAME_ROOM = 256 };

/* Where measurements lie among the numbers, which are not modified. */
static inline hm_measured hm_measured_in(const hm_model_file *f, const double *numbers)
{
    hm_measured places;
    hm_map_measured(&f->model, (double *)(uintptr_t)(numbers + f->model.measured_at), &places);
    return places;
}

/* Place of a node, of moving ones at coordinates q (n). */
static inline const double *hm_place_of_node(const holonom_model *m, const double *numbers,
                                             const double *q, int32_t node)
{
    const int32_t n_moving = m->n_free + m->n_driven;
    return node < n_moving ? q + DIM * node : numbers + m->support_at + DIM * (node - n_moving);
}

/* Whether a row of rigidity is that of the body with a name of this length. */
static inline int hm_is_of_body(const hm_model_file *f, int32_t row, const char *name,
                                size_t length)
{
    const char *title = f->text + f->row[row].name + sizeof "body '" - 1;
    return !strncmp(title, name, length) && title[length] == '\'';
}

/* Says what keeps a step from being solved. */
const char *hm_about_step(int32_t status);

/* Says the part that a node belongs to: a body, of which it is the centre or a direction, or a
   point; returns whether it is known. */
int hm_say_node(hm_text *text, const hm_model_file *file, int32_t node);

/* Says which part is far heavier than which, where this may keep a step from being solved; nothing
   if none is. */
void hm_say_far_apart(hm_text *text, const hm_model_file *file, const double *numbers,
                      int32_t status);

/* Says, in place of what keeps a step from being solved, which friction is too strong; whether one
   is. */
int hm_say_strong_friction(hm_text *text, const hm_model_file *file, const double *numbers,
                           int32_t status);

/* Says that the law of impact found no path, and which law stood in; nothing if it found all. */
void hm_say_newton(hm_text *text, const double *head, const char *when);

/* A start that has ended: residuals of rows and their rates in the state, and what rows lack in the
   core's last try (n_rows each). */
typedef struct hm_start {
    int32_t status;
    const double *phi, *rate, *lacking;
} hm_start;

/* Says what keeps a mechanism from being assembled; returns how many sentences, 0 where it is. */
int hm_say_failed_start(hm_text *text, const hm_model_file *file, const double *numbers,
                        const hm_state *state, const hm_start *start);

/* Says the part that a step or the start fails at, or near which a step is not solved, and a colon;
   nothing if none is known. */
void hm_say_fault(hm_text *text, const hm_model_file *file, const double *numbers,
                  const double *head, int32_t status);

/* Says which rule a value breaks, "name: rule, got value", and returns 1; 0 if it keeps all.
   `shown`: the value as it was given, or NULL. */
int hm_objects(hm_text *text, const hm_model_file *file, const hm_variable *variable, double value,
               const char *shown, int moving);

/* Says a value as it was given, or the number if `shown` is NULL. */
void hm_say_value(hm_text *text, double value, const char *shown);

/* Limit that a value is beyond; NaN if it is within both. */
double hm_limit_before(const hm_variable *variable, double value);

/* Word number `value` of a String option, or NULL. */
const char *hm_word(const hm_model_file *file, const hm_variable *variable, double value);

/* Says a sentence for each of these rules that the numbers break, behind others, and returns how
   many. */
enum hm_rules {
    RULES_OF_ALL,
    RULES_OF_LAWS,
    RULES_NOTED
}; /* the last ones are told, and refuse nothing */
int hm_broken_rules(hm_text *text, const hm_model_file *file, const double *numbers,
                    enum hm_rules which);

/* Says that new values would press the sides of a contact, this row, into each other by -gap;
   `others` is whether there are sentences before. */
void hm_say_pressed(hm_text *text, const hm_model_file *file, int32_t row, double gap, int others);

/* Says what the search for an equilibrium does not know of this mechanism; returns how many
   sentences. */
int hm_unknown_to_method(hm_text *text, const hm_model_file *file, const double *head);

/* Says a sentence for each part whose rows the drawn mechanism contradicts, by their residuals phi
   and rates (n_rows each), and returns how many. */
int hm_contradicted_rows(hm_text *text, const hm_model_file *file, const double *numbers,
                         const hm_state *state, const double *phi, const double *rate);

/* Says which parts let the velocities at the start belong to no motion, by what their rows lack
   (n_rows), and the remedy. */
void hm_say_dead_centre(hm_text *text, const hm_model_file *file, const double *numbers,
                        const hm_state *state, const double *lacking);

/* Says what moved far when the mechanism was closed, and whether other poses are as near; whether
   there is something to say. */
int hm_say_closing(hm_text *text, const hm_model_file *file, const double *numbers,
                   const hm_state *state);

/* Says composite j, a spring, damper, friction or contact that yields; whether it has a name. */
int hm_say_composite(hm_text *text, const hm_model_file *file, const double *numbers, int32_t j);

/* Says what steps the settings choose; `is_explicit`: whether some of them are. */
void hm_say_steps(hm_text *text, const hm_model_file *file, const double *numbers,
                  const double *head, const holonom_methods *methods, int is_explicit);

/* Remarks on a run that goes on, each once; that its steps are too long again when it has lasted as
   long as it was to. */
enum hm_remark {
    REMARK_ORDER = 1,
    REMARK_LEDGER = 2,
    REMARK_SAMPLING = 4,
    REMARK_COARSENESS = 8,
    REMARK_COARSE_RUN = 16,
    REMARK_NEWTON = 32,
    REMARK_DEFERRED = 64,
    REMARK_NUMBERS = 128
};

/* Says what a step showed that was not said before; returns what was said until now. */
int hm_remark(hm_text *text, const hm_model_file *file, const double *numbers,
              const hm_state *state, int said, int heard);

#endif
