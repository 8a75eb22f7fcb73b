/* holonom: the conserving augmented-Lagrangian kernel.

   A mechanism is a set of node vectors X_0, X_1, ...: points and directions, `dim` coordinates each. The first
   `n_free` nodes are unknown, the next `n_driven` move as prescribed, the rest stays. Everything a mechanism is
   made of is a function of *forms*

       s(q) = u . w,     u = sum_e alpha_e X_node(e),     w = sum_e beta_e X_node(e),

   that is, of quadratics in q written as dot products, so that they are evaluated from differences and lose
   no digits far from the origin. In the plane a coefficient may have a quarter turn, alpha + alpha_turn J.

   A *quantity* is a form, the length sqrt(s) of one, or the angle atan2(s_2, s_1) of two, unwrapped. Rows are

       s - c = 0,      u = 0 (a coincidence: dim rows),      phi(quantities, signals) = 0,      psi(.., rates) = 0,

   forces act along quantities (springs, dampers, drives), are gradients of potentials V(quantities), or act on a
   link (loads, moments). A *composite* is whatever is built from quantities: an element, or a function on the
   tape of operations; its discrete gradient is that of its forms times slopes (function.h).

   Rules: no allocation, no globals, no I/O; the caller owns all memory; a status code has one meaning each;
   comparisons are written so that NaN fails. Arrays are "not modified" unless said otherwise. */
#ifndef HOLONOM_H
#define HOLONOM_H

#include <stdint.h>

#if defined(_WIN32)
#define HOLONOM_API __declspec(dllexport)
#else
#define HOLONOM_API __attribute__((visibility("default")))
#endif

/* Changes whenever the structures below, the head of a state or an entry point change. */
#define HOLONOM_ABI 16

enum holonom_status {
    HOLONOM_OK = 0,
    HOLONOM_NEWTON_DIVERGED = 1,   /* inner Newton iteration did not reach the tolerance                 */
    HOLONOM_UZAWA_DIVERGED = 2,    /* outer Uzawa iteration left the constraints unsatisfied              */
    HOLONOM_SINGULAR_TANGENT = 3,  /* a pivot of the tangent matrix is zero                              */
    HOLONOM_NOT_FINITE = 4,        /* an increment, a residual or a number of the model is not finite     */
    HOLONOM_ZERO_LENGTH = 5,       /* a length or a turned link is zero, an angle has no direction          */
    HOLONOM_BAD_STEP = 6,          /* step length is not a finite positive number                        */
    HOLONOM_BAD_LAW = 7,           /* a stiffness, free length or damping is negative, or work not a number */
    HOLONOM_TURN_TOO_LARGE = 8,    /* a body would turn by more than 2.5 rad in a half step                 */
    HOLONOM_DAMPING_REVERSED = 9,  /* over a step of order > 2, which goes back in between, dampers fed energy */
    HOLONOM_STEP_COLLAPSED = 10    /* a tolerance asks for more than 1e6 internal steps in a communication step */
};

enum holonom_formulation {
    HOLONOM_CONSERVING_AL = 0,      /* eq 15 with beta = 1/2 (exact for quadratic rows), eq 26        */
    HOLONOM_MIDPOINT_AL = 1,        /* eq 5                                                           */
    HOLONOM_CONSERVING_PENALTY = 2, /* eqs 9 and 11                                                   */
    HOLONOM_MIDPOINT_PENALTY = 3,   /* eq 7                                                           */
    HOLONOM_PENALTY_VELOCITY = 4,   /* eq 3 under the midpoint rule                                   */
    HOLONOM_CONSERVING_AL_BETA = 5     /* eq 15, function rows with the intermediate configuration of eq 8 */
};

/* Elimination of the tangent: of all of it, or lean, without stiffness, which leaves G and what M couples. Lean
   factors are a Schur complement G M^-1 G' in disguise: cheap where M is diagonal, and good for short steps.     */
typedef struct holonom_elimination {
    const int32_t *node_position; /* n_free: first place of the node in the elimination order              */
    const int32_t *row_position;  /* n_rows: place of the row's multiplier                                 */
    const int32_t *lu_ptr;        /* n + 1, n = dim n_free + n_rows: pivot k owns [diagonal, U row, L col] */
    const int32_t *lu_column;     /* places coupled to each pivot, in the order of its U row               */
    const int32_t *lu_target;     /* for each pivot m x m targets of its update, row by row                */
    const int32_t *lu_island;     /* 2 (n_islands + 1): first pivot of each island, first of its targets    */
    const int32_t *mass_slot;     /* n_mass_free * dim                                                     */
    const int32_t *row_slot_ptr;  /* n_form_rows + 1; likewise of all that follow: where each one's slots begin */
    const int32_t *row_slot;      /* per form row, k free entries: stiffness (k k dim; turned k k dim dim; linear
                                     or lean none), k dim upper, k dim lower                               */
    const int32_t *coincidence_slot_ptr;
    const int32_t *coincidence_slot; /* per coincidence and free entry: dim upper, dim lower (turned: dim dim) */
    const int32_t *composite_slot_ptr;
    const int32_t *composite_slot;   /* per composite, K nodes: (K dim)^2 unless lean; of rows also K dim upper,
                                        K dim lower                                                        */
} holonom_elimination;

/* Structure of a model: integers only, fixed when the mechanism is assembled. The numbers that belong to it
   live in one vector `numbers`; the fields `*_at` are offsets into that vector.                            */
typedef struct holonom_model {
    int32_t dim;          /* 2 or 3                                                                        */
    int32_t n_free;       /* moving nodes that are unknown                                                 */
    int32_t n_driven;     /* moving nodes whose coordinates are the first dim n_driven signals             */
    int32_t n_support;    /* nodes that do not move                                                        */
    int32_t n_forms;      /* forms s = u . w                                                               */
    int32_t n_entries;    /* entries of all forms                                                          */
    int32_t n_quantities; /* quantities; the first n_active take part in the motion, the others are measured */
    int32_t n_active;
    int32_t n_linked;     /* forms that a step needs at its beginning                                      */
    int32_t n_form_rows;  /* s - c = 0                                                                     */
    int32_t n_coincidences;  /* u = 0, dim rows each                                                       */
    int32_t n_function_rows; /* phi = 0                                                                    */
    int32_t n_velocity_rows; /* psi = 0, linear in rates                                                   */
    int32_t n_rows;       /* all rows, in this order: one multiplier each                                  */
    int32_t n_elements;   /* springs, dampers and drives, along one quantity each                          */
    int32_t n_potentials; /* functions V                                                                   */
    int32_t n_loads;      /* forces on a link                                                              */
    int32_t n_moments;    /* moments that turn a link                                                      */
    int32_t n_body_moments; /* moments on spatial bodies                                                   */
    int32_t n_mass;       /* entries of the mass matrix between moving nodes, both triangles               */
    int32_t n_mass_free;  /* of these, the first ones couple free nodes                                    */
    int32_t n_bodies;     /* spatial rigid bodies                                                          */
    int32_t n_places;     /* points of bodies that are measured                                            */
    int32_t n_reactions;  /* joints whose reaction is measured                                             */
    int32_t n_reaction_entries;
    int32_t n_signals;    /* prescribed values that rows contain                                           */
    int32_t n_parameters; /* parameters of the scene                                                       */
    int32_t n_inputs;     /* inputs of the scene                                                           */
    int32_t n_numbers;    /* length of `numbers`                                                           */
    int32_t n_tape[4];    /* operations: of parameters alone; also of t, inputs, tunables; signals; of measurements */
    int32_t time_dependent;        /* 1: the laws change within a communication step                       */
    int32_t variable_potential;    /* 1: the laws write springs or potentials, so stored energy may jump   */
    int32_t sensing;               /* 1: the laws read quantities                                          */
    int32_t n_registers;  /* most leaves and operations of a function                                      */
    int32_t n_local_forms; /* most forms of a composite                                                    */
    int32_t n_local_nodes; /* most free nodes of a composite                                               */
    int32_t n_lu_values;  /* stored entries of the factors                                                 */
    int32_t n_lean_values; /* likewise of those without stiffness; 0 where these are not worth while         */
    int32_t n_slots;      /* half steps of an internal one whose changes a state keeps, see predict.h   */
    int32_t n_islands;    /* parts that no mass, row or force joins: each is solved by itself               */
    int32_t n_sampled;    /* loads that read quantities                                                    */

    const int32_t *island_begin;  /* (n_islands + 1) ISLAND_COLUMNS: where each island begins among these     */
    const int32_t *node_kind;     /* moving and fixed nodes: 0 point, 1 direction                          */
    const int32_t *form_ptr;      /* n_forms + 1: entries of form f are form_ptr[f] .. form_ptr[f+1]-1     */
    const int32_t *form_free;     /* n_forms: how many entries are free nodes; these come first            */
    const int32_t *form_moving;   /* n_forms: how many are free or driven                                  */
    const int32_t *form_node;     /* node of each entry                                                    */
    const int32_t *form_kind;     /* n_forms: flags FORM_...                                               */
    const int32_t *quantity_kind; /* n_quantities: QUANTITY_...                                            */
    const int32_t *quantity_form; /* 2 n_quantities: one form or two                                       */
    const int32_t *linked_form;   /* n_linked: those of rows, composites and laws; the others are measured   */
    const int32_t *row_form;      /* n_form_rows                                                           */
    const int32_t *row_power;     /* n_rows: the row's scale is row_base extent^power                      */
    const int32_t *coincidence_form;    /* n_coincidences: the link u                                      */
    const int32_t *composite_form_ptr;  /* composites + 1: elements, function and velocity rows, potentials */
    const int32_t *composite_form;
    const int32_t *composite_node_ptr;  /* composites + 1: free nodes of their forms                       */
    const int32_t *composite_node;
    const int32_t *composite_local_ptr; /* composites + 1                                                  */
    const int32_t *composite_local;     /* place among these of each free entry of each form               */
    const int32_t *leaf_ptr;      /* composites + 1                                                        */
    const int32_t *leaf;          /* 4 each: LEAF_..., index, local forms                                  */
    const int32_t *function_ptr;  /* functions + 1: the composites behind the elements                     */
    const int32_t *operation;     /* 4 each: code, three arguments: a register, or -1 - a number's place    */
    const int32_t *load_form;     /* n_loads: the link u they act on                                       */
    const int32_t *load_axes;     /* n_loads: -1 global, or the first director of the body that carries them */
    const int32_t *moment_form;   /* n_moments                                                             */
    const int32_t *body_moment;   /* 2 n_body_moments: first director; 0 global or 1 body axes             */
    const int32_t *body_node;     /* n_bodies: first of three directors                                    */
    const int32_t *place_form;    /* n_places: the link u                                                  */
    const int32_t *reaction_entry;      /* 4 each: reaction, REACTION_..., index, sign                     */
    const int32_t *mass_node;     /* 2 n_mass: row node, column node                                       */
    const int32_t *input_ramp;    /* n_inputs: 1 if it changes evenly over a communication step            */
    const int32_t *sampled_load;  /* 2 n_sampled: SAMPLED_... and place among these                          */
    const int32_t *tape;          /* 5 integers an operation: code, target, three arguments                */

    holonom_elimination full, lean;
    const int32_t *load_slot_ptr; /* n_loads + 1                                                            */
    const int32_t *load_slot;     /* per follower load: free entries x directors x dim dim                 */
    const int32_t *moment_slot_ptr; /* n_moments + 1                                                        */
    const int32_t *moment_slot;   /* per moment: k k dim dim                                               */
    const int32_t *body_moment_slot; /* per body moment: 9 x 9                                             */

    int32_t mass_at;              /* n_mass [kg]                                                           */
    int32_t alpha_at, beta_at;    /* n_entries each                                                        */
    int32_t alpha_turn_at, beta_turn_at; /* n_entries each, or none if no form is turned                   */
    int32_t row_constant_at;      /* n_form_rows: c                                                        */
    int32_t row_base_at;          /* n_rows                                                                */
    int32_t extent_at;            /* 2: size of the mechanism [m], in the mass norm [kg^1/2 m]; derived: this and
                                     the next two are written by holonom_initialise, and the state keeps them */
    int32_t row_scale_at;         /* n_rows: makes Phi dimensionless, derived                               */
    int32_t row_sigma_at;         /* n_rows: (G M^-1 G')_ii, derived                                       */
    int32_t stiffness_at, rest_at, damping_at, drive_at; /* n_elements                                     */
    int32_t gravity_at;           /* dim [m/s^2]                                                           */
    int32_t support_at;           /* dim n_support                                                         */
    int32_t initial_position_at, initial_velocity_at;    /* dim (n_free + n_driven)                        */
    int32_t load_at;              /* dim n_loads [N]                                                       */
    int32_t moment_at;            /* n_moments (plane) or 3 n_moments (space) [N m]                        */
    int32_t body_moment_at;       /* 3 n_body_moments [N m]                                                */
    int32_t parameter_at, input_at, time_at;
    int32_t signal_at;            /* n_signals: written by the third tape                                  */
    int32_t sensor_at, sensor_rate_at;   /* n_quantities each: in the middle of a step, for the second tape */
    int32_t node_mass_at;         /* moving nodes: share of the mass in norms [kg]                         */
    int32_t node_weight_at;       /* moving nodes: mass that gravity acts on [kg]                          */
    int32_t velocity_weight_at;   /* moving nodes: weight of their velocity when it is made consistent     */
    int32_t measured_at;          /* measurements, see holonom_measure                                     */
} holonom_model;

enum { FORM_SQUARE = 1, FORM_LINEAR = 2, FORM_TURNED = 4 };         /* w = u; w constant; quarter turns         */
enum { QUANTITY_FORM = 0, QUANTITY_LENGTH = 1, QUANTITY_ANGLE = 2 };
enum { LEAF_VALUE = 0, LEAF_RATE = 1, LEAF_SIGNAL = 2 };
/* What islands divide, each into consecutive pieces: nodes, composites, rows, forces, masses, ...             */
enum holonom_island_column {
    ISLAND_FREE, ISLAND_DRIVEN, ISLAND_ELEMENT, ISLAND_FUNCTION, ISLAND_VELOCITY, ISLAND_POTENTIAL, ISLAND_FORM_ROW,
    ISLAND_COINCIDENCE, ISLAND_LOAD, ISLAND_MOMENT, ISLAND_BODY_MOMENT, ISLAND_MASS, ISLAND_LINKED,
    ISLAND_ACTIVE, ISLAND_BODY, ISLAND_COLUMNS
};
/* Loads that read the mechanism, see sampling.h. */
enum { SAMPLED_LOAD = 0, SAMPLED_MOMENT = 1, SAMPLED_BODY_MOMENT = 2, SAMPLED_DRIVE = 3 };
enum { REACTION_COINCIDENCE = 0, REACTION_FORCE = 1, REACTION_TORQUE = 2 };

/* Places of the scalars at the head of a state; vectors follow in the order of hm_map_state (internal.h). */
enum holonom_state_place {
    S_TIME, S_KINETIC_START, S_POTENTIAL_START, S_STORED_START, S_ENERGY_REFERENCE, S_WORK, S_WORK_LOW, S_DISSIPATED, S_DISSIPATED_LOW,
    S_DEFECT, S_DEFECT_LOW, S_RESIDUAL, S_RESIDUAL_LOW, S_MEAN_TIME, S_MEAN_TIME_BEFORE, S_PARITY, S_KNOWN, S_HALVES,
    S_WANTED, S_LAST_LENGTH, S_JUDGED_4, S_JUDGED_6, S_JUDGED_8, S_LEARNED_4, S_LEARNED_6, S_LEARNED_8, S_ACROSS,
    S_ORDER_IN_USE, S_NEWTON, S_UZAWA, S_SUBSTEPS, S_LEDGER_ERROR,
    S_STATUS, S_FORMULATION, S_SIMULTANEOUS, S_PAPER_UPDATE, S_PAIRED, S_STEP_SIZE, S_NEWTON_TOLERANCE, S_PENALTY,
    S_XI, S_OMEGA, S_MAX_NEWTON, S_MAX_UZAWA, S_ASSEMBLE, S_EQUILIBRIUM, S_ORDER,
    S_TOLERANCE, S_ABSOLUTE_TOLERANCE, S_LONGEST_STEP, S_HORIZON, S_HEAD
};

/* Scalars of each island in the section `islands` of a state. */
enum holonom_island_place { I_PENALTY_LEVEL, I_SLOW_STEPS, I_DEPENDENT, I_FULL_STEPS, I_FULL_WAIT, I_FRESH_STEPS, I_FRESH_WAIT, I_SIZE };

HOLONOM_API int32_t holonom_abi(void);

/* Coordinates of a node in every model of this library: 2 or 3. */
HOLONOM_API int32_t holonom_dimension(void);

/* Bytes of a holonom_model. */
HOLONOM_API int64_t holonom_model_bytes(void);

/* Sizes in doubles. */
HOLONOM_API int64_t holonom_state_size(const holonom_model *model);
HOLONOM_API int64_t holonom_work_size(const holonom_model *model);
HOLONOM_API int64_t holonom_measured_size(const holonom_model *model);

/* Result of one operation of the tape, by its code; of these alone, so that constants folded when a model is made have
   the bits of what is calculated in a run. */
HOLONOM_API double holonom_operate(int32_t code, double a, double b, double c);

/* Runs tape `segment` on `numbers` (modified): 0 parameters, 1 laws, 2 signals, 3 measurements.               */
HOLONOM_API void holonom_evaluate(const holonom_model *model, double *numbers, int32_t segment);

/* Takes the initial configuration from `numbers` (modified: derived sections) into `state` (modified), closes the
   mechanism or seeks its equilibrium if the options say so, finds the first multipliers from M a + G' lambda = Q
   and Phi'' = 0, and starts the ledger. The state's time, options, parameters and inputs are set beforehand.   */
HOLONOM_API int32_t holonom_initialise(const holonom_model *model, double *numbers, double *state, double *work);

/* Residuals of the rows and their rates, signals included: phi, phi_dot (n_rows each), both overwritten. Inputs, time
   and signals among the numbers are modified, `state` is not. */
HOLONOM_API void holonom_residuals(const holonom_model *model, double *numbers, double *state,
                                   double *work, double *phi, double *phi_dot);

/* Advances `state` (modified) by `step` [s], divided into equal internal steps of at most the option
   step_size or, with a tolerance, into those that it asks for; on failure the state is as before, but for S_STATUS. */
HOLONOM_API int32_t holonom_advance(const holonom_model *model, double *numbers, double *state, double *work,
                                    double step);

/* Changes inputs and tunable parameters; a jump of stored energy is booked as work. `inputs` (n_inputs),
   `parameters` (n_parameters). */
HOLONOM_API void holonom_set_inputs(const holonom_model *model, double *numbers, double *state, double *work,
                                    const double *inputs, const double *parameters);

/* Fills the section `measured` of `numbers` from `state` (not modified) and runs the fourth tape. Sections, in order: positions
   and velocities of the moving nodes, of the places, quantities, their rates, forces along elements, rod forces of
   the form rows, multipliers, quaternions (w, x, y, z) and angular velocities of the bodies, reaction forces,
   reaction torques, forces on driven nodes, then kinetic, potential, total, work, dissipated, balance, error
   (7 energies), position and velocity residuals (2), momentum dim, angular momentum 1 or 3, Newton
   iterations, Uzawa updates, substeps, order in use, sampling, status (6). */
HOLONOM_API void holonom_measure(const holonom_model *model, double *numbers, double *state, double *work);

/* One step of length h from `state` (not modified), for tests of the tangent: residual r at the increment
   w = d - h v of the free nodes (dim n_free) and multipliers mu (n_rows), r (dim n_free + n_rows, overwritten), and the
   tangent times a direction x, tx (both dim n_free + n_rows; tx overwritten). */
HOLONOM_API int32_t holonom_probe(const holonom_model *model, double *numbers, double *state,
                                  double *work, double h, const double *w, const double *mu,
                                  const double *x, double *r, double *tx);

#endif
