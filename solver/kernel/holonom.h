/* holonom: the conserving augmented-Lagrangian kernel.

   A mechanism is a set of node vectors X_0, X_1, ...: points and directions, `dim` coordinates
   each. The first `n_free` nodes are unknown, the next `n_driven` move as prescribed, the rest
   stays. Everything a mechanism is made of is a function of *forms*

       s(q) = u . w,     u = sum_e alpha_e X_node(e),     w = sum_e beta_e X_node(e),

   that is, of quadratics in q written as dot products, so that they are evaluated from differences
   and lose no digits far from the origin. In the plane a coefficient may have a quarter turn, alpha
   + alpha_turn J.

   A *quantity* is a form, the length sqrt(s) of one, or the angle atan2(s_2, s_1) of two,
   unwrapped. Rows are

       s - c = 0,      u = 0 (a coincidence: dim rows),      phi(quantities, signals) = 0, psi(..,
   rates) = 0,

   forces act along quantities (springs, dampers, drives), are gradients of potentials
   V(quantities), or act on a link (loads, moments). A *composite* is whatever is built from
   quantities: an element, or a function on the tape of operations; its discrete gradient is that of
   its forms times slopes (function.h).

   The fields of a model and a state are declared in solver/runtime/layout.py; model_tables.h is
   made of them.

   Rules: no allocation, no globals, no I/O; the caller owns all memory; a status code has one
   meaning each; comparisons are written so that NaN fails. Arrays are "not modified" unless said
   otherwise. */
#ifndef HOLONOM_H
#define HOLONOM_H

#include "model_tables.h"

#if defined(HOLONOM_STATIC) /* nothing of it is seen from outside of an FMU */
#define HOLONOM_API
#elif defined(_WIN32)
#define HOLONOM_API __declspec(dllexport)
#else
#define HOLONOM_API __attribute__((visibility("default")))
#endif

HOLONOM_API int32_t holonom_abi(void);

/* Coordinates of a node in every model of this library: 2 or 3. */
HOLONOM_API int32_t holonom_dimension(void);

/* Sizes in doubles. */
HOLONOM_API int64_t holonom_state_size(const holonom_model *model);
HOLONOM_API int64_t holonom_work_size(const holonom_model *model);
HOLONOM_API int64_t holonom_measured_size(const holonom_model *model);

/* Result of one operation of the tape, by its code; of these alone, so that constants folded when a
   model is made have the bits of what is calculated in a run. Of its `count` values, 3 at least,
   those behind the first are the table of a spline, and those behind the third that of a grid. */
HOLONOM_API double holonom_operate(int32_t code, const double *value, int32_t count);

/* Runs tape `segment` on `numbers` (modified): 0 parameters, 1 laws, 2 signals, 3 measurements. */
HOLONOM_API void holonom_evaluate(const holonom_model *model, double *numbers, int32_t segment);

/* Asks who waits for a start or a step whether to go on: `look` returns 1 for its end. Of a small
   mechanism it is asked seldom, since that takes as long as a step: once in so much work, `left`
   (modified; counted in doubles of the state, an internal step reads each). */
typedef struct holonom_watch {
    int32_t (*look)(void);
    int64_t left;
    int32_t is_stopped; /* modified */
} holonom_watch;

enum { HOLONOM_WORK_BETWEEN_LOOKS = 1 << 20 };

enum { HOLONOM_AHEAD = 3 };

/* Internal steps of a communication step, a row of MESH_SIZE + n_switches numbers each (layout.py):
   those that are taken, or those to repeat. */
typedef struct holonom_mesh {
    double *row;   /* `room` rows, modified where steps are recorded */
    int64_t room, count;
    double *start; /* room for a state, to repeat; NULL to record */
    /* Modified: how often penalties were lowered, and velocities put onto the rows, of located
       contacts and of explicit steps, and when. */
    double ahead[HOLONOM_AHEAD], ahead_of[HOLONOM_AHEAD];
    double ahead_kept[HOLONOM_AHEAD], ahead_of_kept[HOLONOM_AHEAD]; /* where a piece began */
    double back_at;  /* modified: time that the last step which was taken back had begun at */
    int32_t is_full; /* modified: whether there was no room for a row */
} holonom_mesh;

/* Takes the initial configuration from `numbers` (modified: derived sections) into `state`
   (modified), closes the mechanism or seeks its equilibrium if the options say so, finds the first
   multipliers from M a + G' lambda = Q and Phi'' = 0, and starts the ledger. The state's time,
   options, parameters and inputs are set beforehand. `watch` (modified) may be NULL; after
   HOLONOM_STOPPED the state is undefined. */
HOLONOM_API int32_t holonom_initialise(const holonom_model *model, double *numbers, double *state,
                                       double *work, holonom_watch *watch);

/* Residuals of the rows and their rates, signals included: phi, phi_dot (n_rows each), both
   overwritten. Inputs, time and signals among the numbers are modified, `state` is not. */
HOLONOM_API void holonom_residuals(const holonom_model *model, double *numbers, double *state,
                                   double *work, double *phi, double *phi_dot);

/* Advances `state` (modified) by `step` [s], divided into equal internal steps of at most the
   option step_size or, with a tolerance, into those that it asks for; on failure the state is as
   before, but for S_STATUS. `watch` and `mesh` (modified) may be NULL. */
HOLONOM_API int32_t holonom_advance(const holonom_model *model, double *numbers, double *state,
                                    double *work, double step, holonom_watch *watch,
                                    holonom_mesh *mesh);

/* How equal steps of an order above 2 are taken, by the present numbers: whether some islands take
   compositions, and some covers; how many parts take energy out, and the composite of the first. */
typedef struct holonom_methods {
    int32_t composed, covered, losses, first;
} holonom_methods;

void holonom_find_methods(const holonom_model *model, double *numbers, double *state, double *work,
                          holonom_methods *found);

/* Whether the settings in `state` let some steps of this model be explicit. */
int32_t holonom_may_be_explicit(const holonom_model *model, double *numbers, double *state,
                                double *work);

/* Changes inputs and tunable parameters; a jump of stored energy is booked as work. `inputs`
   (n_inputs), `parameters` (n_parameters). Returns the row of a contact whose sides they press into
   each other, with its `gap` (1, written then alone), or -1; such a state cannot be advanced. */
HOLONOM_API int32_t holonom_set_inputs(const holonom_model *model, double *numbers, double *state,
                                       double *work, const double *inputs, const double *parameters,
                                       double *gap);

/* Groups of measurements. Contacts read the forces, accelerations are solved for with them; outputs
   by formula (the fourth tape) read all others. */
enum {
    HOLONOM_MEASURE_MOTION = 1,
    HOLONOM_MEASURE_FORCES = 2,
    HOLONOM_MEASURE_BODIES = 4,
    HOLONOM_MEASURE_ENERGIES = 8,
    HOLONOM_MEASURE_MOMENTA = 16,
    HOLONOM_MEASURE_SOLVER = 32,
    HOLONOM_MEASURE_CONTACTS = 64 + HOLONOM_MEASURE_FORCES,
    HOLONOM_MEASURE_ACCELERATIONS = 128 + HOLONOM_MEASURE_FORCES,
    HOLONOM_MEASURE_ALL = 255
};

/* Fills groups of the section `measured` of `numbers`, hm_measured, from `state` (not modified). */
HOLONOM_API void holonom_measure(const holonom_model *model, double *numbers, double *state,
                                 double *work, int32_t groups);

enum { HOLONOM_GROUPS = 9 };

/* Where outputs end among the numbers, by what finds them: motion, forces, bodies, forces,
   energies, momenta, solver, contacts, accelerations. */
void holonom_group_ends(const holonom_model *model, double *numbers, int32_t *end);

/* Whether the rate of an output is known, and it, or 0: that of a position, an angle or a length is
   measured, and an error is zero up to round-off, or up to that of the method. `place` is that of
   the output among `numbers`. */
int holonom_knows_rate(const holonom_model *model, double *numbers, int32_t place, double *rate);

/* Moves the state on by `step` [s] along its velocities and accelerations, which
   holonom_begin_moving_on puts into it, for steps of `longest` in all: q + t v + t^2/2 a. Both
   modify `state` and `numbers` and leave no state that a run comes to; to be measured. */
int32_t holonom_begin_moving_on(const holonom_model *model, double *numbers, double *state,
                                double *work, double longest);
void holonom_move_on(const holonom_model *model, double *numbers, double *state, double *work,
                     double step);

#endif
