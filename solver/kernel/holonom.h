/* holonom: the conserving augmented-Lagrangian kernel.

   A mechanism is a set of node vectors X_0, X_1, ... (points; `dim` coordinates each). The first `n_free`
   nodes move, the others are supports. Everything a mechanism is made of is a function of *forms*

       s(q) = u . w,     u = sum_e alpha_e X_node(e),     w = sum_e beta_e X_node(e),

   that is, of quadratics in q written as dot products, so that they are evaluated from differences and lose
   no digits far from the origin. A constraint row is Phi = s - c; a line element (spring, damper) acts along
   the gradient of its form; a moment turns the link u of its form.

   Rules: no allocation, no globals, no I/O; the caller owns all memory; a status code has one meaning each;
   comparisons are written so that NaN fails. Arrays are "not modified" unless said otherwise.              */
#ifndef HOLONOM_H
#define HOLONOM_H

#include <stdint.h>

#if defined(_WIN32)
#define HOLONOM_API __declspec(dllexport)
#else
#define HOLONOM_API __attribute__((visibility("default")))
#endif

/* Changes whenever the structures below, the head of a state or an entry point change. */
#define HOLONOM_ABI 2

enum holonom_status {
    HOLONOM_OK = 0,
    HOLONOM_NEWTON_DIVERGED = 1,   /* inner Newton iteration did not reach the tolerance                 */
    HOLONOM_UZAWA_DIVERGED = 2,    /* outer Uzawa iteration left the constraints unsatisfied              */
    HOLONOM_SINGULAR_TANGENT = 3,  /* a pivot of the tangent matrix is zero                              */
    HOLONOM_NOT_FINITE = 4,        /* an increment, a residual or a number of the model is not finite     */
    HOLONOM_ZERO_LENGTH = 5,       /* a line element or a turned link has length zero: no direction       */
    HOLONOM_BAD_STEP = 6,          /* step length is not a finite positive number                        */
    HOLONOM_BAD_LAW = 7            /* a stiffness, free length or damping is negative or not a number       */
};

enum holonom_formulation {
    HOLONOM_CONSERVING_AL = 0,      /* eq 15 with beta = 1/2 (exact for quadratic rows), eq 26        */
    HOLONOM_MIDPOINT_AL = 1,        /* eq 5                                                           */
    HOLONOM_CONSERVING_PENALTY = 2, /* eqs 9 and 11                                                   */
    HOLONOM_MIDPOINT_PENALTY = 3,   /* eq 7                                                           */
    HOLONOM_PENALTY_VELOCITY = 4    /* eq 3 under the midpoint rule                                   */
};

/* Structure of a model: integers only, fixed when the mechanism is assembled. The numbers that belong to it
   live in one vector `numbers`; the fields `*_at` are offsets into that vector.                            */
typedef struct holonom_model {
    int32_t dim;          /* 2 or 3                                                                        */
    int32_t n_free;       /* moving nodes                                                                  */
    int32_t n_support;    /* nodes that do not move; node indices n_free .. n_free + n_support - 1         */
    int32_t n_forms;      /* forms s = u . w                                                               */
    int32_t n_rows;       /* constraint rows                                                               */
    int32_t n_lines;      /* springs and dampers                                                           */
    int32_t n_moments;    /* moments that turn a link                                                      */
    int32_t n_loads;      /* forces on a node                                                              */
    int32_t n_mass;       /* entries of the mass matrix between free nodes, both triangles                 */
    int32_t n_angles;     /* planar links whose unwrapped angle is followed                                */
    int32_t n_parameters; /* parameters of the scene                                                       */
    int32_t n_inputs;     /* inputs of the scene                                                           */
    int32_t n_numbers;    /* length of `numbers`                                                           */
    int32_t n_tape[3];    /* operations: of parameters alone; also of t, inputs, tunables; of measurements */
    int32_t time_dependent;        /* 1: the second tape reads t                                          */
    int32_t variable_potential;    /* 1: the second tape writes springs, so stored energy may jump        */
    int32_t n_lu_values;  /* stored entries of the factors                                                 */

    const int32_t *form_ptr;      /* n_forms + 1: entries of form f are form_ptr[f] .. form_ptr[f+1]-1     */
    const int32_t *form_free;     /* n_forms: how many entries are free nodes; these come first            */
    const int32_t *form_node;     /* node of each entry                                                   */
    const int32_t *form_square;   /* n_forms: 1 if w = u                                                  */
    const int32_t *row_form;      /* n_rows                                                               */
    const int32_t *line_form;     /* n_lines                                                              */
    const int32_t *moment_form;   /* n_moments                                                            */
    const int32_t *load_node;     /* n_loads                                                              */
    const int32_t *angle_form;    /* n_angles                                                             */
    const int32_t *mass_node;     /* 2 n_mass: row node, column node                                      */
    const int32_t *tape;          /* 5 integers an operation: code, target, three arguments               */

    const int32_t *node_position; /* n_free: first place of the node in the elimination order             */
    const int32_t *row_position;  /* n_rows: place of the row's multiplier                                */
    const int32_t *lu_ptr;        /* n + 1, n = dim n_free + n_rows: pivot k owns [diagonal, U row, L col] */
    const int32_t *lu_column;     /* places coupled to each pivot, in the order of its U row              */
    const int32_t *lu_target;     /* for each pivot m x m targets of its update, row by row               */
    const int32_t *mass_slot;     /* n_mass * dim                                                         */
    const int32_t *row_slot;      /* per row, k free entries: k k dim stiffness, k dim upper, k dim lower  */
    const int32_t *line_slot;     /* per line: k k dim dim                                                */
    const int32_t *moment_slot;   /* per moment: k k dim dim                                              */

    int32_t mass_at;              /* n_mass [kg]                                                          */
    int32_t alpha_at, beta_at;    /* one per form entry                                                   */
    int32_t row_constant_at;      /* n_rows: c [m^2]                                                      */
    int32_t row_scale_at;         /* n_rows: l^2 [m^2], makes Phi dimensionless                           */
    int32_t row_sigma_at;         /* n_rows: (G M^-1 G')_ii [m^2/kg], derived: written by holonom_initialise */
    int32_t stiffness_at, free_length_at, damping_at;   /* n_lines [N/m], [m], [N s/m]                     */
    int32_t gravity_at;           /* dim [m/s^2]                                                          */
    int32_t support_at;           /* dim n_support [m]                                                    */
    int32_t initial_position_at, initial_velocity_at;   /* dim n_free [m], [m/s]                           */
    int32_t load_at;              /* dim n_loads [N]                                                      */
    int32_t moment_at;            /* n_moments (plane) or 3 n_moments (space) [N m]                        */
    int32_t parameter_at, input_at, time_at;
    int32_t node_mass_at;         /* n_free: share of the mass, row sums of M with the supports' columns [kg] */
    int32_t extent_at;            /* 2: size of the mechanism [m], in the mass norm [kg^1/2 m]; derived    */
    int32_t measured_at;          /* measurements, see holonom_measure                                    */
} holonom_model;

/* Places of the scalars at the head of a state; vectors follow in the order of holonom_state_size.         */
enum holonom_state_place {
    S_TIME, S_KINETIC_START, S_POTENTIAL_START, S_STORED_START, S_ENERGY_REFERENCE, S_WORK, S_WORK_LOW, S_DISSIPATED, S_DISSIPATED_LOW,
    S_DEFECT, S_DEFECT_LOW, S_RESIDUAL, S_RESIDUAL_LOW, S_MEAN_TIME, S_MEAN_TIME_BEFORE, S_PARITY, S_NEWTON, S_UZAWA, S_SUBSTEPS,
    S_STATUS, S_FORMULATION, S_SIMULTANEOUS, S_PAPER_UPDATE, S_PAIRED, S_STEP_SIZE, S_TOLERANCE, S_PENALTY,
    S_XI, S_OMEGA, S_MAX_NEWTON, S_MAX_UZAWA, S_HEAD
};

HOLONOM_API int32_t holonom_abi(void);

/* Sizes in doubles. */
HOLONOM_API int64_t holonom_model_bytes(void);
HOLONOM_API int64_t holonom_state_size(const holonom_model *model);
HOLONOM_API int64_t holonom_work_size(const holonom_model *model);
HOLONOM_API int64_t holonom_measured_size(const holonom_model *model);

/* Runs tape `segment` (0, 1, 2) on `numbers` (modified): parameters, then time and inputs, then measurements. */
HOLONOM_API void holonom_evaluate(const holonom_model *model, double *numbers, int32_t segment);

/* Takes the initial configuration from `numbers` (modified: derived sections) into `state` (modified), solves
   (G M^-1 G') lambda = G M^-1 Q + v'Hv for the first multipliers and starts the ledger. The state's time,
   options, parameters and inputs are set by the caller beforehand.                                          */
HOLONOM_API int32_t holonom_initialise(const holonom_model *model, double *numbers, double *state, double *work);

/* Residuals of the rows: phi (n_rows) [m^2] and phi_dot = G v (n_rows) [m^2/s], both overwritten.            */
HOLONOM_API void holonom_residuals(const holonom_model *model, const double *numbers, const double *state,
                                   double *work, double *phi, double *phi_dot);

/* Advances `state` (modified) by `step` [s], divided into equal internal steps of at most the option
   step_size; on failure the state is as before, but for S_STATUS.                                           */
HOLONOM_API int32_t holonom_advance(const holonom_model *model, double *numbers, double *state, double *work,
                                    double step);

/* Changes inputs and tunable parameters; a jump of stored energy is booked as work. `inputs` (n_inputs),
   `parameters` (n_parameters).                                                                              */
HOLONOM_API void holonom_set_inputs(const holonom_model *model, double *numbers, double *state, double *work,
                                    const double *inputs, const double *parameters);

/* Fills the section `measured` of `numbers` from `state` and runs the third tape. Sections, in order:
   positions dim n_free, velocities dim n_free, angles n_angles, angular velocities n_angles, lengths n_lines,
   tensions n_lines, rod forces n_rows, then kinetic, potential, total, work, dissipated, balance, error
   (7 energies), position and velocity residuals (2), momentum dim, angular momentum 1 or 3, Newton
   iterations, Uzawa updates, substeps, status (4).                                                           */
HOLONOM_API void holonom_measure(const holonom_model *model, double *numbers, const double *state, double *work);

/* One step of length h from `state` (not modified), for tests of the tangent: residual r at the increment
   w = d - h v (dim n_free) and multipliers mu (n_rows), r (dim n_free + n_rows, overwritten), and the tangent
   times a direction x, tx (both dim n_free + n_rows; tx overwritten).                                        */
HOLONOM_API int32_t holonom_probe(const holonom_model *model, double *numbers, const double *state,
                                  double *work, double h, const double *w, const double *mu,
                                  const double *x, double *r, double *tx);

#endif
