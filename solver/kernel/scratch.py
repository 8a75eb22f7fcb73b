"""Scratch of one call of the core, section by section; nothing in it survives the call.

``build_kernel.model_tables`` makes a C structure of it; lengths are as in
``solver/runtime/layout.py``.
"""

# fmt: off
COUNTS = {
    "n_state": "holonom_state_size(m)",
    "n_local": "dim * n_local_nodes",
    "n_leaf_numbers": "12 + n_registers",  # see composite.h; likewise of a form
    "n_form_numbers": "4 * dim + 3",
}

WORK = {
    "u0": "dim * n_forms", "w0": "dim * n_forms",  # links at the beginning of the step
    "sigma0": "n_active",  # quantities at the beginning
    "signal1": "n_signals",  # prescribed values at the end
    "signal_rate": "n_signals", "signal_before": "n_signals",  # before inputs changed theirs
    "signal_bend": "n_signals",  # second derivatives
    "jet": "2 * n_numbers",  # rates and second derivatives of the numbers, see jets.c
    "bounds": "4 * n_numbers * switching",  # of the numbers and their rates, see ranges.c
    "watched": "2 * switching", "seen": "n_switches",  # from when to when; switches crossed then
    "argument_begin": "n_switches", "argument_low": "n_switches",  # of switches, at the start and
    "argument_high": "n_switches", "argument_tried": "n_switches",  # ends of steps: switch_event.h
    "argument_least": "2 * n_switches", "argument_largest": "2 * n_switches",  # each with its time
    "held_next": "n_held",  # next values of sampled states
    "side_before": "n_switches",  # of the switches, ahead of a change
    "by_rounding": "n_switches",  # whether a switch is off its side by rounding alone
    "switch_backup": "n_state * switching",  # before a step that a switch may cut
    "phi0": "n_rows", "phi": "n_rows",  # at the beginning, and the function that shall vanish
    "lambda": "n_rows", "mu": "n_rows",  # multiplier held fixed, total multiplier
    "change": "n_rows", "moved": "n_rows",  # of a function in the step, and its part by quantities
    "elongation": "n_elements",  # in the step
    "epsilon": "n_rows",  # compliance 2/alpha or 1/alpha
    "hv": "n", "w": "n", "d": "n",  # h v, unknown d - h v, increment d
    "momentum": "n",  # residual of the momentum balance
    "move": "n",  # increments of the unknowns, turns with first directors
    "turn": "n",  # part that is solved for; behind it that before the last increment
    "spun": "n",  # the other part, h omega; behind it what rounding to 24 bits has left out
    "internal": "n",  # h n_i of directors, see body_turns.h
    "middle": "n", "turned": "n",  # directors in the middle and at the end of a step
    "nodal": "n",  # momentum balance of directors before it is reduced to torques
    "torque": "n",  # on bodies, with their first directors: of rows between axes, then of all
    "bend": "n",  # what a turn does to its own torque, TURNING^2 each, likewise
    "handed_on": "n",  # part of it that the last half steps have left to this one
    "sensed": "n",  # increment of which sampled loads were told
    "ahead": "n", "ahead_rate": "n",  # coordinates and velocities that are foreseen
    "secants": "sensing * 26 * n_pivots",  # see secants.h
    "free": "n",  # part of the velocities that rows leave free
    "covered": "n_islands",  # whether each takes covers in the step at hand, see divided_step
    "kept": "n_islands * (4 * (dim + turning) + dim + 6)",  # KEPT_SIZE of kept_motion.h
    "slip": "n_rows * unilateral",  # rates of sliding frictions' rows over the step
    "row_rate": "n_rows", "row_bias": "n_rows",  # and second derivatives at constant velocities
    "drift": "n_rows * unilateral",  # rates of slips by the speeds of surfaces
    "product": "n_pivots",  # of the tangent and a vector
    "rhs": "n_pivots",  # elimination order
    "value": "n_lu_values",  # tangent and its factors
    "pieces": "unilateral * (2 * (n_function_rows + n_velocity_rows) + 4)",  # see leave_rows_out
    # integers of far_contacts.h: lists of what is near, forms of these, and pieces of them
    "near": "unilateral * (n_owners + n_composites + n_linked + n_active + 5)",
    "near_form": "unilateral * n_forms",
    "near_slice": "unilateral * (4 * n_islands + 4)",
    "near_pieces": "unilateral * (4 * (n_function_rows + n_velocity_rows) + 5 * n_islands + 5)",
    "live": "n_lu_values * unilateral",  # integers, see factorise_matrix
    "joined": "(dim * n_free + n_rows) * unilateral",  # two integers each, likewise
    "local": "n_local_forms * n_form_numbers",  # links and values of the forms of a composite
    "slope": "n_local_forms", "end": "n_local_forms",  # of a composite over the step, at its end
    "slope_sum": "n_local_forms",  # of the slips of a friction, times their forces
    "curve": "n_local_forms * n_local_forms",  # change of the slopes with the forms at the end
    "gradient": "n_local_forms * n_local", "gradient_end": "n_local_forms * n_local",  # of forms
    "block": "n_local * n_local", "place": "n_local_nodes",  # integers, see local_places
    "leaves": "n_registers * n_leaf_numbers",  # end slopes and changes of a composite's leaves
    "r.r0": "n_registers", "r.r1": "n_registers", "r.dr": "n_registers",  # of one function
    "r.adjoint": "n_registers", "r.slope": "3 * n_registers",
    "estimate": "3 * n_motion",  # of weighted covers: change from the finest one, behind it
    # differences from the order before, and of that from the one before it
    "loss": "n_elements + n_function_rows + n_velocity_rows + n_potentials",  # to each composite
    "weighted_loss": "n_elements + n_function_rows + n_velocity_rows + n_potentials",
    "stages": "12 * n_motion",  # velocities and accelerations of twelve, see stages.h
    "step_backup": "n_state", "pair_backup": "n_state", "finest": "n_state",
    "rows_on": "n_rows + 1",  # integers, see list_rows_on
    "event_mu": "n_rows * unilateral",  # multipliers where contacts are looked at
    "kept_forces": "16 * n_rows * unilateral", "kept_time": "16",  # of the step, see keep_forces
    "event": "6 * (n_contacts + n_frictions)",  # functions of contacts, see event_functions.h
    "gap_rates": "n_contacts",  # of closed ones before a short piece, see keep_gap_rates
    "event_backup": "n_state * unilateral",  # before a step that events may cut
    "touch": "7 * n_contacts",  # see half_step_contacts.h
    "flips": "n_frictions",  # changes of mode in the half step
    "rubbed": "n_frictions",  # energies taken in its first stage
    "share": "n_frictions",  # part of the half step until a slip stops
    "sweep": "n_contacts * (n_local + 4)",  # gradients and forces of those near
    "stop": "n_rows * unilateral",  # ways of slips that stop in the half step
    "slip_before": "n_rows * unilateral",  # slips at its start
    "turning": "10 * n_frictions",  # see turn_beginning_slips
    "slip_at_end": "3 * n_frictions",  # of frictions, see slip_along
    "stepped_backup": "n_state * unilateral",  # before a half step of stepped mode
    "hit_defect": "n * unilateral",  # velocities across the rows, see velocity_projection.h
    "hit_reach": "n * n_hit_rows",  # velocities that unit impulses bring about, see impact.h
    "hit_matrix": "n_hit_rows * n_hit_rows",
    "hit_force": "n_hit_forces * n_hit_rows",  # impulses in joints that rub, of unit impulses
    "hit_norms": "n_hit_forces",  # integers: whether each belongs to the norm of the one before
    "hit": "12 * n_hit_rows",  # nine vectors of numbers and six of integers, see map_hit
    "hit_scratch": "IMPACT_SCRATCH(n_hit_rows)",
    "rest": "SPLIT_SCRATCH(n_hit_rows) * unilateral",  # see contact_split.h
    "rest_mu": "n_rows * unilateral",  # tells directions of forces that press joints there
    "rest_mean": "n_rows * unilateral",  # multipliers of half steps there
    "rest_modes": "n_state * unilateral",  # before contacts are opened there
    "whole_backup": "2 * n_state",  # after a step and before it, while it is checked
}
# fmt: on
