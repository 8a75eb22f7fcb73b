"""Where everything of a model and a state lies in memory: each field declared once, in its order.

``build_kernel.model_tables`` writes from this file the structures, enumerations, lengths and simple
checks of the core, with the comment behind a field as its text; and Python finds here the names.

A model has `SIZES`, integer `TABLES`, and one vector of numbers in sections, `OFFSETS`. A state is
one block of doubles: `HEAD`, then `STATE`; all that survives a step is in it. Lengths are products
of sizes, `COUNTS` and whole numbers.
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Mapping
from functools import cache
from types import CodeType
from zlib import crc32

ENTRY_POINTS = 21
"""To be raised when functions that the core exports change, or the order of a model's bytes."""


class Table(namedtuple("Table", "length low end width", defaults=("", None, None, 1))):
    """An integer table; `length` is empty where other tables tell it; an item has `width` integers.

    These lie from `low` to below `end`, where that alone can be said of them.
    """

    __slots__ = ()


class Pointers(namedtuple("Pointers", "count total most", defaults=("",))):
    """A table of `count` + 1 places that rise from 0 to `total`, by at most `most` each."""

    __slots__ = ()


# fmt: off
SIZES = (
    "dim",  # 2 or 3: coordinates of a node
    "n_free",  # moving nodes that are unknown
    "n_driven",  # moving nodes whose coordinates are the first dim n_driven signals
    "n_support",  # nodes that do not move
    "n_forms",  # forms s = u . w
    "n_entries",  # entries of all forms
    "n_quantities",  # the first n_active take part in the motion, the others are measured
    "n_active",
    "n_always_active",  # of these the first, others for contacts and frictions alone
    "n_linked",  # forms that a step needs at its beginning
    "n_always_linked",  # of these the first, others for contacts and frictions alone
    "n_form_rows",  # s - c = 0
    "n_rigidity_rows",  # of these the last: lengths and angles of the directors of bodies
    "n_coincidences",  # u = 0, dim rows each
    "n_function_rows",  # phi = 0
    "n_velocity_rows",  # psi = 0, linear in rates
    "n_rows",  # all rows, in this order: one multiplier each
    "n_elements",  # springs, dampers and drives, along one quantity each
    "n_potentials",  # functions V, and functions N of forces along a quantity
    "n_loads",  # forces on a link
    "n_moments",  # moments that turn a link
    "n_body_moments",  # moments on spatial bodies
    "n_mass",  # entries of the mass matrix between moving nodes, both triangles
    "n_mass_free",  # of these, the first ones couple free nodes
    "n_bodies",  # rigid bodies
    "n_places",  # points of bodies that are measured
    "n_reactions",  # joints whose reaction is measured
    "n_reaction_entries",
    "n_signals",  # prescribed values that rows contain
    "n_parameters",  # of the scene
    "n_inputs",  # of the scene
    "n_numbers",  # length of the vector of numbers
    "n_tape_parameters",  # operations of parameters alone
    "n_tape_laws",  # also of the time, inputs, tunable parameters
    "n_tape_signals",
    "n_tape_outputs",  # of measurements
    "n_tape_ticks",  # next values of sampled states
    "steep_signals",  # 1: an operation of signals may have no finite slope where it has a value
    "time_dependent",  # 1: the laws change within a communication step
    "variable_potential",  # 1: the laws write springs or potentials, so stored energy may jump
    "sensing",  # 1: the laws read quantities
    "accelerates",  # 1: accelerations are measured
    "fits_velocities",  # 1: velocities are made to fit joints, whose axes are not quite as written
    "n_registers",  # most leaves and operations of a function
    "n_local_forms",  # most forms of a composite
    "n_local_nodes",  # most free nodes of a composite
    "n_lu_values",  # stored entries of the factors
    "n_lean_values",  # likewise of those without stiffness; 0 where these are not worth while
    "n_open_values", "n_bare_values",  # likewise of full and of lean ones without contacts
    "n_slots",  # half steps of an internal one whose misses a state keeps, see predict.h
    "n_islands",  # parts that no mass, row or force joins: each is solved by itself
    "n_sampled",  # loads that read quantities
    "n_contacts",  # gaps, each a function row that is on while it is closed
    "n_frictions",  # each of 1 to 3 velocity rows that are on while it sticks
    "n_hit_rows",  # most rows of an impact
    "n_hit_forces",  # multipliers by which joints rub in impacts
    "unilateral",  # 1: there are contacts or frictions
    "n_held",  # sampled states: they change at ticks of their clocks alone
    "n_switches",  # conditions and kinks of formulas that change with the motion or time
    "switching",  # 1: there are some
    "n_motion_switches",  # of these, how many read quantities
    "n_kinks",  # of these, the last ones, how many have no side: kinks of forces, then of energies
    "n_energy_kinks",  # of these, the last ones, how many are of energies: with a tolerance alone
)
"""Integers of a model."""

COUNTS = {
    "n_moving": "n_free + n_driven",
    "n_nodes": "n_moving + n_support",
    "n": "dim * n_moving",
    "n_joint_rows": "n_form_rows - n_rigidity_rows",
    # turns of bodies take a coordinate and a row each from what keeps directors orthonormal
    "n_pivots": "dim * n_free + n_rows - 2 * n_rigidity_rows",
    "n_functions": "n_function_rows + n_velocity_rows + n_potentials",
    "n_composites": "n_elements + n_functions",
    "first_velocity": "n_elements + n_function_rows",  # among the composites
    "first_potential": "first_velocity + n_velocity_rows",
    "n_tape": "n_tape_parameters + n_tape_laws + n_tape_signals + n_tape_outputs + n_tape_ticks",
    "n_island_ends": "n_islands + 1",
    "n_derived": "2 + 2 * n_rows",
    "turning": "2 * dim - 3",  # components of a moment, and directors of a body
    "n_first_directors": "n_free - turning + 1",
    "n_oriented": "(dim - 2) * n_bodies",  # bodies with quaternions
    "n_turns": "turning * n_bodies",
    "n_owned": "unilateral * (n_function_rows + n_velocity_rows)",
    "n_owners": "n_contacts + n_frictions",
}
"""What lengths are made of besides sizes."""

ELIMINATION = {
    "node_position": Table("n_free", -1, "n_pivots"),  # first place in the elimination order
    "row_position": Table("n_rows", -1, "n_pivots"),  # place of the row's multiplier
    "lu_ptr": Pointers("n_pivots", "n_lu_values"),  # diagonal of each pivot, see lu.c
    "lu_group": Table(),  # of each: first pivot, m (even), 1: has a parent; the end; or no groups
    "lu_column": Table(),  # m places coupled to each group or pivot, in the order of its U row
    "lu_target": Table("", 0, "n_lu_values"),  # m x m targets of its update, row by row
    "lu_island": Table("4 * n_island_ends"),  # its first pivot, its group, its targets, columns
    "mass_slot": Table("dim * n_mass_free", -1, "n_lu_values"),  # -1: of directors
    "inertia_slot": Table("", 0, "n_lu_values"),  # turning turning of each body
    "row_slot_ptr": Pointers("n_form_rows", "row_slot"),  # where each row's slots begin
    "row_slot": Table("", 0, "n_lu_values"),  # k free entries: stiffness, k dim upper, k dim lower
    "coincidence_slot_ptr": Pointers("n_coincidences", "coincidence_slot"),
    "coincidence_slot": Table("", 0, "n_lu_values"),  # dim upper, dim lower; if turned dim dim
    "composite_slot_ptr": Pointers("n_composites", "composite_slot"),
    "composite_slot": Table("", 0, "n_lu_values"),  # K nodes: (K dim)^2, of rows 2 K dim more
    "cone_slot_ptr": Pointers("n_frictions", "cone_slot"),
    "cone_slot": Table("", 0, "n_lu_values"),  # of each velocity row: rows of the normal force
    "load_slot_ptr": Pointers("n_loads", "load_slot"),
    "load_slot": Table("", 0, "n_lu_values"),  # follower load: free entries directors dim dim
    "moment_slot_ptr": Pointers("n_moments", "moment_slot"),
    "moment_slot": Table("", 0, "n_lu_values"),  # k k dim dim each
    "body_moment_slot": Table("", 0, "n_lu_values"),  # 3 x 3 blocks of 3 x 3 each
}
"""Tables of a factorisation: of the whole tangent, or lean.

Lean factors leave stiffness out: G and what M couples remain, a Schur complement G M^-1 G' in
disguise, cheap where M is diagonal, and good for short steps. A row has k k dim stiffnesses; turned
k k dim dim; linear or lean none.

Open factors are those of the whole tangent while all contacts and frictions are off, bare ones the
lean factors then: rows of contacts and frictions lie behind all pivots, and have no slots to use.

The turn of each body has the place of its directors, and the rows that turns fulfil have none: an
entry of a director has `turning` components, in full blocks: turning by dim, or by turning.
"""
FACTORS = ("open", "lean", "bare")
"""Kinds of factors besides full ones."""

ISLAND_PARTS = {
    "free": ("0", "n_free"), "driven": ("n_free", "n_moving"),
    "element": ("0", "n_elements"), "function": ("n_elements", "first_velocity"),
    "velocity": ("first_velocity", "first_potential"),
    "potential": ("first_potential", "n_composites"),
    "form_row": ("0", "n_joint_rows"),
    "coincidence": ("0", "n_coincidences"),
    "load": ("0", "n_loads"), "moment": ("0", "n_moments"),
    "body_moment": ("0", "n_body_moments"), "mass": ("0", "n_mass"), "body": ("0", "n_bodies"),
    "linked": ("0", "n_always_linked"),
    "touching_linked": ("n_always_linked", "n_linked"),
    "active": ("0", "n_always_active"), "touching_active": ("n_always_active", "n_active"),
}
"""What islands divide, each into consecutive pieces from the first place to the last."""

TABLES = {
    "island_begin": Table(f"{len(ISLAND_PARTS)} * n_island_ends"),  # of each of `ISLAND_PARTS`
    "node_kind": Table("n_nodes", 0, 4),  # NODE_..
    "form_ptr": Pointers("n_forms", "n_entries"),  # entries of form f: form_ptr[f] .. [f+1]-1
    "form_free": Table("n_forms", 0),  # how many entries are free nodes; these come first
    "form_moving": Table("n_forms", 0),  # how many are free or driven
    "form_node": Table("n_entries"),  # node of each entry
    "form_kind": Table("n_forms", 0, 32),  # flags FORM_..
    "quantity_kind": Table("n_quantities", 0, 3),  # QUANTITY_..
    "quantity_form": Table("2 * n_quantities", -1, "n_forms"),  # one form, or two of an angle
    "linked_form": Table("n_linked", 0, "n_forms"),  # of rows, composites and laws
    "row_form": Table("n_form_rows", 0, "n_forms"),
    "row_power": Table("n_rows", 0, 9),  # the row's scale is row_base extent^power
    "coincidence_form": Table("n_coincidences", 0, "n_forms"),  # the link u
    "composite_form_ptr": Pointers("n_composites", "composite_form", "n_local_forms"),
    "composite_form": Table("", 0, "n_forms"),  # of elements, functions, velocity rows, potentials
    "composite_node_ptr": Pointers("n_composites", "composite_node", "n_local_nodes"),
    "composite_node": Table("", 0, "n_free"),  # free nodes of their forms
    "composite_local_ptr": Pointers("n_composites", "composite_local"),
    "composite_local": Table(),  # place among these of each free entry of each form
    "leaf_ptr": Pointers("n_composites", "leaf", "n_registers"),
    "leaf": Table(width=4),  # LEAF_.., index, two local forms
    "function_ptr": Pointers("n_functions", "operation", "n_registers"),
    "function_still": Table("n_functions", 0, "n_registers"),  # of slips: operations without rates
    "function_known": Table("n_functions", 0, "n_registers"),  # those of the function before,
    # which has the same leaves
    "depth_register": Table("n_potentials", -1, "n_registers"),  # of damped ones: a depth; else -1
    "force_role": Table("n_potentials", 0, 3),  # STORES: a function V; else a force N, the sign of
    # its account
    "operation": Table(width=4),  # code, three arguments: a register, or -1 - a number's place
    "load_form": Table("n_loads", 0, "n_forms"),  # the link u they act on
    "load_axes": Table("n_loads", -1),  # -1 global, or first director of the body they turn with
    "moment_form": Table("n_moments", 0, "n_forms"),
    "body_moment": Table("2 * n_body_moments"),  # first director; 0 global or 1 body axes
    "body_node": Table("n_bodies", 0, "n_first_directors"),  # first director
    "place_form": Table("n_places", 0, "n_forms"),  # the link u
    "reaction_entry": Table("4 * n_reaction_entries"),  # reaction, REACTION_.., index, sign
    "mass_node": Table("2 * n_mass", 0, "n_moving"),  # row node, column node
    "input_course": Table("n_inputs", 0, 3),  # INPUT_.., over a communication step
    "sampled_load": Table("2 * n_sampled"),  # SAMPLED_.. and place among these
    "contact_row": Table("n_contacts", 0),  # composite of the gap
    "contact_friction": Table("n_contacts", -1, "n_frictions"),  # -1: there is none
    "friction_row_ptr": Pointers("n_frictions", "friction_row", "3"),
    "friction_row": Table("", 0),  # composites of the slip rates
    "normal_ptr": Pointers("n_frictions", "normal_row"),
    "normal_row": Table("", width=2),  # multiplier, and how it enters: `NORMAL_SUMS`
    "row_owner": Table("n_owned", -1, "n_owners"),  # of each composite that is a row: its contact,
    # or n_contacts + its friction; -1: it always holds
    "tape": Table("5 * n_tape"),  # of an operation: code, target, three arguments
    "held_table": Table("2 * n_held"),  # place of the next value of each, switch of its clock
    "switch_table": Table("5 * n_switches"),  # places of its argument and its side, SWITCH_..,
    # segment of the tape, whether it reads quantities; those it depends on come before it
    **ELIMINATION,
    **{
        f"{kind}_{name}": table
        for kind in FACTORS for name, table in ELIMINATION.items()
    },
}
"""Integer arrays of a model."""

NODE_POINT, NODE_DIRECTION, NODE_SECOND, NODE_THIRD = 0, 1, 2, 3
"""A second and third director of a body come right behind the first."""
FORM_SQUARE, FORM_LINEAR, FORM_TURNED = 1, 2, 4  # w = u; w constant; quarter turns
FORM_AXES = 8  # u turns with one body; w with another, or is constant
FORM_AXES_OF_W = 16  # of these: w is that of the body that comes first
QUANTITY_FORM, QUANTITY_LENGTH, QUANTITY_ANGLE = 0, 1, 2
INPUT_HELD, INPUT_RAMPS, INPUT_SMOOTH = 0, 1, 2
INPUT_COURSES = ("hold", "ramp", "smooth")  # by the word of a scene
LEAF_VALUE, LEAF_RATE, LEAF_SIGNAL = 0, 1, 2
STORES, TAKES, WORKS = 0, 1, 2
"""Of potentials: an energy V, or a force N along the first leaf whose work is a loss, or work."""
SWITCH_SIGN, SWITCH_LEVEL = 0, 1
"""What the side of a switch is: the sign of its argument, or the whole number below it."""
SAMPLED_LOAD, SAMPLED_MOMENT, SAMPLED_BODY_MOMENT, SAMPLED_DRIVE = 0, 1, 2, 3  # see sampling.h
REACTION_COINCIDENCE, REACTION_FORCE, REACTION_TORQUE = 0, 1, 2

OFFSETS = {
    "mass": "n_mass",  # [kg]
    "alpha": "n_entries", "beta": "n_entries",
    "alpha_turn": "", "beta_turn": "",  # n_entries, or none if no form is turned
    "row_constant": "n_form_rows",  # c
    "row_base": "n_rows",
    "extent": "n_derived",  # size [m], in the mass norm [kg^1/2 m]; the state keeps these three
    "row_scale": "n_rows",  # makes Phi dimensionless
    "row_sigma": "n_rows",  # (G M^-1 G')_ii
    **dict.fromkeys(("stiffness", "rest", "damping", "drive"), "n_elements"),
    "depth_damping": "n_potentials",  # [s/m, s/rad], see function.h
    "restitution": "n_contacts",
    "sliding": "n_frictions", "static": "n_frictions",  # coefficients
    "preload": "n_frictions",  # [N, N m] that friction has without a normal force
    "smooth_speed": "n_frictions",  # [m/s, rad/s] over which the cone is smoothed; 0: it is not
    "gravity": "dim",  # [m/s^2]
    "support": "dim * n_support",
    "initial_position": "n", "initial_velocity": "n",
    "load": "dim * n_loads",  # [N]
    "moment": "turning * n_moments", "body_moment": "3 * n_body_moments",  # [N m]
    "parameter": "n_parameters", "input": "n_inputs", "time": "1",
    "held": "n_held", "held_start": "n_held",  # sampled states, and what they are at the start
    "signal": "n_signals",  # written by the third tape
    "sensor": "n_quantities", "sensor_rate": "n_quantities",  # in the middle of a step
    "node_mass": "n_moving",  # share of the mass in norms [kg]
    "node_weight": "n_moving",  # mass that gravity acts on [kg]
    "velocity_weight": "n_moving",  # of a velocity when it is made consistent
    "measured": "holonom_measured_size(m)",  # `MEASURED`
}
"""Sections of the vector of numbers."""

ACCOUNTS = ("work", "dissipated", "defect", "residual", "impact", "friction")
"""Of the ledger; each has behind it in the head what rounding left over."""

HEAD = (
    "time",
    "kinetic_start", "potential_start", "stored_start",
    "energy_reference",  # largest kinetic energy, or change of potential energy, so far
    *(f"{account}{part}" for account in ACCOUNTS for part in ("", "_low")),
    "mean_time", "mean_time_before",
    "known", "halves", "half_1", "half_2", "half_3", "half_4",  # see predict.h
    "wanted",  # length that a tolerance asks for
    "last_length",
    "last_rate",  # of the motion, as the last step told it [1/s]; 0 before one
    "across", "order_in_use",
    "explicit",  # whether steps to come are, of that order
    "held",  # steps in a row that were to be explicit and could not, see runge_kutta.h
    "longest_explicit",  # step that resolves springs and dampers, see force_rates.h
    "unspent",  # of what steps so far might add to the error of the run, over the tolerance
    "newton_iterations", "uzawa_iterations", "substeps",  # of the last step
    "as_pairs",  # steps in it that were to be of a higher order, and are pairs of half steps
    "ledger_error",
    "equal_steps", "equal_time",  # of the run: their number, and how long they lasted [s]
    "looks", "least_place", "least_angle",  # at some of them, see coarseness.h
    "reach",  # longest way of a place from its start [m], as far as looked at
    "place_error", "angle_error",  # sums of what these add to the error of the run [m, rad]
    "turned", "turning",  # largest turn of a body in one, squared [rad^2], and its node
    "error_estimate",  # of the run, of steps under a tolerance
    "coarseness", "coarse_length",  # the largest over what is allowed, and the length of that step
    "events",  # of contacts, in the last step
    "functions_known",  # 1: `functions` are those of contacts and frictions at the state that are
    # awake; 2: of those that sleep, too
    "travel", "next_awake",  # so far, and the least of `asleep_until`, or 0, see far_contacts.h
    "shares",  # 1: what sticks shares its forces as rest_split.h tells, not as its rows do
    "stepped",  # whether a part of it was, see stepped.h
    "jams", "newton_impacts",  # impacts in it that jammed, and where Newton's law stood in for the
    # energetic sweep, see impact_sweep.h
    "mixed_impacts",  # of stepped contacts, by the law and by the half step, see velocity_stage.h
    "deferred_frictions",  # pieces of half steps with friction at their end, see stepped.h
    "switched",  # changes of sides of laws in the last step, see switch_event.h
    "quiet_until",  # no switch of the time changes before, as far as looked at, see switches.h
    "at_fault",  # multiplier of the row that the last step failed at, and 1, or behind; else 0
    "status",  # of the last step
    "closing", "closing_tries", "closing_others",  # how the mechanism was closed, see close.h
    "step_size", "newton_tolerance", "penalty", "max_newton", "max_uzawa", "assemble",
    "equilibrium", "order", "tolerance", "method", "absolute_tolerance", "longest_step",
    "rest_speed",
    "rest_time", "max_events", "contact_mode", "impact_law",  # the settings of solver/options.py
    "horizon",  # of a run
    "host_tolerance",  # that the importer of an FMU asks for, or 0
    "input_step", "input_step_before",  # lengths of the last two communication steps
    "unsettled",  # whether contacts and frictions are to be looked at before the next step
)
"""Scalars at the head of a state."""

ISLAND = (
    "penalty_level", "slow_steps",  # see policy_penalty.h
    "dependent",  # whether rows depend on each other
    "full_steps", "full_wait", "fresh_steps", "fresh_wait",  # see policy_factors.h
    "bend", "lean_contraction",  # see learned_contraction.h
    "predicts_lambda",  # whether the multipliers held fixed are predicted, too, see newton.h
    "unbalanced",  # energy [J] that its ledger lacks, see put_back.h
)
"""Scalars of each island in the section `islands` of a state."""

CONTACT = (
    "closed",  # 1: its row holds
    "reference",  # gap at which it closed
    "parted",  # 1: the event at hand has opened it
    "impacts", "impulse",  # so far; their number, and the sum of their impulses [N s]
    "asleep_until",  # travel; up to 0 it is awake, and that is less the gap that may let it sleep
)
"""Scalars of each contact in the section `contacts` of a state."""

FRICTION = (
    "mode",  # `FRICTION_MODES`
    "along_1", "along_2", "along_3",  # unit direction of the slip
)
"""Scalars of each friction in the section `frictions` of a state."""

DRAWN_INTO = 1e-8
"""Penetration of contacts that rounding explains, of a drawing and of closing it; relative to the
size of the mechanism."""
ONE_PLACE = 1e-12
"""Distance of places that the round-off of a drawing explains, relative to their coordinates, or in
m if these are small: a coordinate may be the difference of larger numbers."""
FEW_CONTACTS = 8
"""Up to so many contacts, most entries of factors are taken not to be zero."""
MOST_LEVELS = 3
"""How often the penalty of an island is raised, at most."""
MOST_IN_GROUP = 5
"""Pivots of a group of factors."""
BODY_UNKNOWNS = 6
"""Of a body in space: its turn and its place."""
LEAST_WITH_JOINT, MOST_WITH_JOINT = 9, 12
"""Those of a group of a body in space and the rows of its joint."""
MOST_SIDES = 16
"""Unknowns of a form u . w: u and w are links of two places, which have four nodes at most."""

CONTACT_MODES = ("open", "closed", "slides")
"""Of a contact, as its output `mode` shows them."""

NORMAL_SUMS = ("continues", "begins", "pushes")
"""How a multiplier enters a normal force: the norm of some begins or continues with it; or it is
that of a gap, which pushes with the negative multiplier."""

CLOSINGS = ("at_once", "on_path", "behind_path", "shaken")
"""How a mechanism was closed: by the smallest displacement, on a path from its drawing, from the
end of that path, or from a drawing that was shaken."""

FRICTION_MODES = ("off", "sticks", "slides")

MESH = (
    "time", "length",  # of the step: its beginning, and how long it is [s]
    "usual",  # length of steps at that time, which tells short ones [s]
    "order", "explicit",  # that it was to have, and whether it was to be explicit
    "careful",  # whether smooth frictions had steeper slopes in the tangent
    "known",  # half steps before it that tell its first guess
    "anew",  # whether it follows a try that was taken back
    "lowered", "projected", "started",  # how often, ahead of it, penalties were lowered, and
    # velocities put onto the rows: of located contacts, and of explicit steps
    "taken",  # how it was taken, `MESH_TAKEN`
    "put_back",  # whether velocities were put back behind it
    "end",  # what ended it, `MESH_ENDS`
    "function",  # whose event that was: a contact, a friction behind them, a switch behind these;
    # of a step of its length a switch that it crosses there and back, or -1
    "value",  # of the function of that event, of a switch its argument; or the time [s]
    "side",  # of that switch behind the step
    "modes",  # of contacts and frictions in the step, as one number
)
"""Numbers of each internal step in the mesh of a run, ahead of the sides of switches in it; see
mesh.h."""
MESH_TAKEN = ("pairs", "cover", "finest", "explicit", "short", "stepped")
"""How an internal step was taken: by pairs of half steps, a weighted cover, the finest cover alone,
explicitly, by Taylor's series, or with contacts that change without being located."""
MESH_ENDS = ("length", "event", "stop", "switch", "time")
"""What ended it: its length, an event of contacts, a slip in space that stops, a switch of the
motion, or one of the time."""

MOTION = {
    "q": "n",  # coordinates [m]
    "v": "n",  # velocities [m/s]
}
"""What time integrates: copied, weighted and added up as one, see motion.h."""
MODES = {
    "contacts": f"{len(CONTACT)} * n_contacts",  # `CONTACT` of each
    "frictions": f"{len(FRICTION)} * n_frictions",  # `FRICTION` of each
}
"""What contacts change."""
ANGLES = {
    "turns": "n_quantities",  # full turns of angles so far
    "sine": "n_quantities",  # of the angles, times a factor
}
FOLLOWING = {
    "imbalance": "n", "imbalance_before": "n",  # what Newton's iteration left of the momentum
    # balance in the last half step and in the one before it [kg m/s]
    **ANGLES,
    "signal": "n_signals",  # prescribed values at the present time
    "quaternion": "4 * n_oriented",  # w, x, y, z; of continuous sign
    "sampled": "3 * n_sampled",  # what is known of each sampled load, see sampling.h
    **MODES,
}
"""What follows the motion, and goes back with it to the start of a step."""
GROUPS = {"motion": MOTION, "angles": ANGLES, "modes": MODES, "following": FOLLOWING}
"""Vectors of a state that lie side by side in this order; `n_...` is the length of each group."""
COUNTS |= {f"n_{group}": " + ".join(vectors.values()) for group, vectors in GROUPS.items()}

STATE = {
    **MOTION,
    **{f"{name}_low": length for name, length in MOTION.items()},  # what rounding left over
    **FOLLOWING,
    "start": "n",  # coordinates at the start, which energies are measured from
    "a_first": "n", "a_second": "n",  # last 2 (d - h v)/h^2 of either half of a pair
    "a_before_first": "n", "a_before_second": "n",  # those before, likewise
    "mu_first": "n_rows", "mu_second": "n_rows",  # last multipliers, likewise
    "mu_before_first": "n_rows", "mu_before_second": "n_rows",
    "a_missed": "n * n_slots", "mu_missed": "n_rows * n_slots",  # see predict.h
    "turn_first": "n_turns", "turn_second": "n_turns",  # of turns of bodies: angular accelerations
    "turn_before_first": "n_turns", "turn_before_second": "n_turns",
    "turn_missed": "n_turns * n_slots",
    "mean": "n_rows", "mean_before": "n_rows",  # of the last two multipliers, and those before
    "functions": "2 * (n_contacts + n_frictions)",  # and their rates, see event_functions.h
    "shift": "n_rows * unilateral",  # of multipliers, where what sticks shares its forces
    "driven_first": "dim * n_driven", "driven_second": "dim * n_driven",  # forces on driven nodes
    "driven_mean": "dim * n_driven", "driven_mean_before": "dim * n_driven",  # likewise
    "freedom": "n_moving",  # of a node: 0 if drivers move it alone, 2 if no row holds it, else 1
    "derived": "n_derived",  # the sections extent, row_scale, row_sigma of the numbers
    "side": "n_switches",  # of each switch
    "held": "n_held",  # sampled states
    "inputs": "n_inputs",  # last given
    "inputs_before": "n_inputs",  # of those that move: at the start of the communication step
    "inputs_slope": "n_inputs",  # factors of powers of the time from there, or from the end, on
    "inputs_bend": "n_inputs", "inputs_third": "n_inputs",  # likewise
    "inputs_mean": "n_inputs",  # mean slope in the last communication step
    "inputs_mean_before": "n_inputs",  # in the step before; of held ones: the largest, which fades
    "inputs_curve": "n_inputs",  # likewise: its change from the step before, over the time between
    "islands": f"{len(ISLAND)} * n_islands",  # `ISLAND` of each
    "parameters": "n_parameters",
}
"""Vectors of a state behind its head."""

MEASURED = {
    "position": "n", "velocity": "n",
    "place": "dim * n_places", "place_velocity": "dim * n_places",
    "quantity": "n_quantities", "quantity_rate": "n_quantities",
    "element_force": "n_elements",  # along each
    "rod_force": "n_form_rows",  # 2 mu |u|, positive in tension
    "multiplier": "n_rows",
    "quaternion": "4 * n_oriented",  # w, x, y, z
    "body_rate": "3 * n_oriented",  # angular velocity
    "reaction_force": "dim * n_reactions",  # on the second body of each joint
    "reaction_torque": "turning * n_reactions",
    "driven_force": "dim * n_driven",
    "energy": "7",  # kinetic, potential, total, work, dissipated, balance, relative error
    "residual": "2",  # largest of positions and velocities, scaled
    "momentum": "dim",
    "angular_momentum": "turning",  # about the origin
    "solver": "10",  # Newton iterations, Uzawa updates, substeps, order, method, error estimate,
    # as pairs, sampling, coarseness, status
    "contact": "5 * n_contacts",  # gap, force, mode, impacts, impulse
    "friction": "3 * n_frictions",  # force, slip rate, mode
    "loss": "3 * unilateral",  # to dampers, friction and impacts
    "contact_solver": "6 * unilateral",  # events of the last step, whether it was stepped, jams,
    # impacts by Newton's law, mixed ones, deferred frictions
    "acceleration": "accelerates * n", "place_acceleration": "accelerates * dim * n_places",
    "quantity_acceleration": "accelerates * n_quantities",
    "body_acceleration": "3 * accelerates * n_oriented",  # angular acceleration
}
"""Groups of measurements, in the section `measured` of the numbers."""

HEADER = {
    "magic": "8s",  # "HOLONOM" and 0
    "checksum": "I",  # CRC-32 of all that follows
    "abi": "I",  # `ABI` of the program
    "n_ints": "I", "n_numbers": "I", "n_variables": "I", "n_rules": "I", "n_rows": "I",
    "n_names": "I", "n_text": "I",  # lengths; of texts in bytes
    "guid": "40s",  # of the FMU that carries it
    "fingerprint": "32s",  # hash of all that a run depends on
    "length": "I",  # of the file in bytes
}
"""Header of the bytes of a model, by the letters of ``struct``; likewise the records below."""

VARIABLE = {
    "name": "I", "unit": "I",  # where the texts are
    "type": "B", "causality": "B", "variability": "B", "kind": "B",
    "place": "i",  # among the parameters, inputs, numbers, measurements or in the head
    "start": "d", "minimum": "d", "maximum": "d",
    "least": "d",  # of an option: smallest value other than 0
    "flags": "I",
    "words": "I",  # of an option: what it must be, one of these or, if no String, this; then ""
}
RULE = {"number": "i", "relation": "i", "bound": "d", "name": "I", "message": "I"}
ROW = {"name": "I", "detail": "I", "kind": "I", "unused": "I"}

WORDS = {
    "type": ("Real", "Boolean", "String"),
    "causality": ("parameter", "input", "output", "calculatedParameter"),
    "variability": ("fixed", "tunable", "continuous"),
    "kind": ("parameter", "input", "number", "measured", "option"),
}
"""What a record of a variable has numbers for."""

FLAGS = {"has_minimum": 1, "has_maximum": 2, "has_start": 4, "clips": 8, "whole": 16, "even": 32}
RELATIONS = {
    "finite": "is_finite", ">": "is_above", ">=": "is_at_least", "drawn": "is_drawn",
    "noted": "is_noted",
}  # fmt: skip
"""Of a number and its bound; `drawn` is >= of the mechanism as drawn, whatever it does later;
`noted` is = 0, and a run that breaks it tells so and goes on."""
OF_A_LAW = 256
"""Flag of a relation: inputs and tunable parameters may break it in motion."""
MOST_COARSENESS = 1.0
"""Largest `solver.coarseness`: beyond it equal steps are too long for the motion."""
MOST_SAMPLING = 1.0
"""Largest `solver.sampling`: beyond it loads that read the mechanism drive it by their delay."""

RESULTS = {
    "done": 0,
    "refused": 1,  # a value or a saved state that no rule allows; nothing was changed
    "unassembled": 2,  # the parameters break rules
    "failed": 3,  # a step that cannot be solved; the state is as before, but for its status
    "untried": 4,  # a step that begins at another time, or a value that is not finite
    "remarked": 256,  # alone, if nothing went wrong: there are remarks to fetch
}
"""What functions of an instance return."""

ROW_KINDS = (
    "length", "apart", "off", "height", "turned", "angle", "axes", "value", "driver", "velocity",
    "coupled",
)

CODES = (
    "copy", "add", "sub", "mul", "div", "pow", "neg", "sin", "cos", "tan", "asin", "acos", "atan",
    "atan2", "sqrt", "exp", "log", "abs", "min", "max", "sign", "lt", "le", "gt", "ge", "eq", "ne",
    "and", "or", "not", "sinh", "cosh", "tanh", "floor", "ceil", "mod", "select",
    "spline", "spline_slope", "spline_curvature",  # of x, first and last place of a table
    "grid", "grid_x", "grid_y", "grid_z",  # of the first of three numbers x, y, z, and a table
)
"""Operations of the tape and of functions, by their codes."""
# fmt: on

ABI = crc32(repr([x for name, x in sorted(globals().items()) if name.isupper()]).encode()) >> 1
"""Number of all these declarations, by which code, library and model know that they fit."""

PLACE = {name: place for place, name in enumerate(HEAD)}
"""Index of each scalar of the head."""


@cache
def _compiled(formula: str) -> CodeType:
    return compile(formula, "<length>", "eval")


class _Counts(dict[str, int]):
    """Sizes, and what is counted of them when it is asked for."""

    def __missing__(self, name: str) -> int:
        return eval(_compiled(COUNTS[name]), {}, self)


def _sections(
    lengths: Mapping[str, str], sizes: Mapping[str, int], start: int = 0
) -> dict[str, tuple[int, int]]:
    """Return the offset and length of consecutive sections."""
    known, sections = _Counts(sizes), {}
    for name, formula in lengths.items():
        sections[name] = (start, eval(_compiled(formula), {}, known))
        start += sections[name][1]
    return sections


def state_sections(sizes: Mapping[str, int]) -> dict[str, tuple[int, int]]:
    """Return the offset and length of each vector of a state behind its head."""
    return _sections(STATE, sizes, len(HEAD))


def state_size(sizes: Mapping[str, int]) -> int:
    """Return the number of doubles of a state."""
    return sum([*state_sections(sizes).values()][-1])


def measured_sections(sizes: Mapping[str, int]) -> dict[str, tuple[int, int]]:
    """Return the offset and length of each group of measurements (``holonom_measure``)."""
    return _sections(MEASURED, sizes)


def measured_size(sizes: Mapping[str, int]) -> int:
    """Return the number of measurements."""
    return sum([*measured_sections(sizes).values()][-1])
