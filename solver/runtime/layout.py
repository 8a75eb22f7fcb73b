"""Where everything of a model and a state lies in memory, in one place.

The names are those of ``solver/kernel/holonom.h``, in its order: `SIZES`, `TABLES`, `OFFSETS` make
up its ``holonom_model``; `HEAD` lists the scalars at the beginning of a state. A state is one block
of doubles: the head, then the vectors of `state_sections`. All that survives a step is in it.
"""

from __future__ import annotations

from collections.abc import Mapping

ABI = 16
"""``HOLONOM_ABI`` of the header: changes with the structures, the head and the entry points."""

SIZES = (
    "dim", "n_free", "n_driven", "n_support", "n_forms", "n_entries", "n_quantities", "n_active",
    "n_linked", "n_form_rows", "n_coincidences", "n_function_rows", "n_velocity_rows", "n_rows",
    "n_elements", "n_potentials", "n_loads", "n_moments", "n_body_moments", "n_mass",
    "n_mass_free", "n_bodies", "n_places", "n_reactions", "n_reaction_entries", "n_signals",
    "n_parameters", "n_inputs", "n_numbers", "n_tape_parameters", "n_tape_laws", "n_tape_signals",
    "n_tape_outputs", "time_dependent", "variable_potential", "sensing", "n_registers",
    "n_local_forms", "n_local_nodes", "n_lu_values", "n_lean_values", "n_slots",
    "n_islands", "n_sampled",
)  # fmt: skip
"""Integers of a model, each a 32-bit field."""

_ELIMINATION = (
    "node_position", "row_position", "lu_ptr", "lu_column", "lu_target", "lu_island", "mass_slot",
    "row_slot_ptr", "row_slot", "coincidence_slot_ptr", "coincidence_slot", "composite_slot_ptr",
    "composite_slot",
)  # fmt: skip

TABLES = (
    "island_begin", "node_kind", "form_ptr", "form_free", "form_moving", "form_node", "form_kind",
    "quantity_kind", "quantity_form", "linked_form", "row_form", "row_power", "coincidence_form",
    "composite_form_ptr", "composite_form", "composite_node_ptr", "composite_node",
    "composite_local_ptr", "composite_local", "leaf_ptr", "leaf", "function_ptr", "operation",
    "load_form", "load_axes", "moment_form", "body_moment", "body_node", "place_form",
    "reaction_entry", "mass_node", "input_ramp", "sampled_load", "tape",
    *_ELIMINATION, *(f"lean_{name}" for name in _ELIMINATION),
    "load_slot_ptr", "load_slot", "moment_slot_ptr", "moment_slot", "body_moment_slot",
)  # fmt: skip
"""Integer arrays of a model, each a pointer."""

OFFSETS = (
    "mass", "alpha", "beta", "alpha_turn", "beta_turn", "row_constant", "row_base", "extent",
    "row_scale", "row_sigma", "stiffness", "rest", "damping", "drive", "gravity", "support",
    "initial_position", "initial_velocity", "load", "moment", "body_moment", "parameter", "input",
    "time", "signal", "sensor", "sensor_rate", "node_mass", "node_weight", "velocity_weight",
    "measured",
)  # fmt: skip
"""Sections of the vector of numbers, each a 32-bit offset."""

HEAD = (
    "time", "kinetic_start", "potential_start", "stored_start", "energy_reference", "work",
    "work_low", "dissipated", "dissipated_low", "defect", "defect_low", "residual", "residual_low",
    "mean_time", "mean_time_before", "parity", "known", "halves", "wanted", "last_length",
    "judged_4", "judged_6", "judged_8", "learned_4", "learned_6", "learned_8", "across",
    "order_in_use", "newton_iterations", "uzawa_iterations", "substeps", "ledger_error", "status",
    "formulation", "simultaneous", "paper_update", "paired", "step_size", "newton_tolerance",
    "penalty", "xi", "omega", "max_newton", "max_uzawa", "assemble", "equilibrium", "order",
    "tolerance", "absolute_tolerance", "longest_step", "horizon",
)  # fmt: skip
"""Scalars at the head of a state."""

ISLAND = (
    "penalty_level", "slow_steps", "dependent", "full_steps", "full_wait", "fresh_steps",
    "fresh_wait",
)  # fmt: skip
"""Scalars of each island in the section `islands` of a state."""

PLACE = {name: place for place, name in enumerate(HEAD)}
"""Index of each scalar of the head."""


def state_sections(sizes: Mapping[str, int]) -> dict[str, tuple[int, int]]:
    """Return the offset and length of each vector of a state behind its head.

    ``q, q_low, v, v_low`` (n each, free and driven nodes): coordinates [m], velocities [m/s], and
    what rounding left over; ``imbalance, imbalance_before`` (n each): what Newton's iteration left
    of the momentum balance in the last two half steps; ``start`` (n): coordinates at the start;
    ``a_first, a_second`` (n each): last 2 (d - h v)/h^2 of either half of a pair; ``mu_first,
    mu_second`` (n_rows each): last multipliers; ``a_change, mu_change`` (n_slots of n and n_rows):
    how these changed from half to half of the last internal steps; ``mean, mean_before``: means of
    two neighbours; ``driven_...`` likewise: forces that move the driven nodes; ``turns``: full
    turns of angles; ``direction``: cosine and sine of each, times a factor; ``signal``: prescribed
    values at the present time; ``quaternion``: of the bodies, of continuous sign; ``sampled``: of
    loads that read the mechanism, see ``sampling.h``; ``derived``: what the start tells once
    and for all, the sections extent (2), row_scale and row_sigma (n_rows each); ``inputs,
    parameters``; ``inputs_before, inputs_slope``: where a ramped input stands at the present time,
    and how fast it arrived there; ``islands``: the scalars `ISLAND` of each.
    """
    n, n_driven = sizes["dim"] * (sizes["n_free"] + sizes["n_driven"]), sizes["n_driven"]
    lengths = {
        **dict.fromkeys(("q", "q_low", "v", "v_low", "imbalance", "imbalance_before"), n),
        **dict.fromkeys(("start", "a_first", "a_second"), n),
        **dict.fromkeys(("mu_first", "mu_second"), sizes["n_rows"]),
        "a_change": n * sizes["n_slots"],
        "mu_change": sizes["n_rows"] * sizes["n_slots"],
        **dict.fromkeys(("mean", "mean_before"), sizes["n_rows"]),
        **dict.fromkeys(
            ("driven_first", "driven_second", "driven_mean", "driven_mean_before"),
            sizes["dim"] * n_driven,
        ),
        "turns": sizes["n_quantities"],
        "direction": 2 * sizes["n_quantities"],
        "signal": sizes["n_signals"],
        "quaternion": 4 * sizes["n_bodies"],
        "sampled": 3 * sizes["n_sampled"],
        "derived": 2 + 2 * sizes["n_rows"],
        "inputs": sizes["n_inputs"],
        "inputs_before": sizes["n_inputs"],
        "inputs_slope": sizes["n_inputs"],
        "islands": len(ISLAND) * sizes["n_islands"],
        "parameters": sizes["n_parameters"],
    }
    return _consecutive(lengths, len(HEAD))


def _consecutive(lengths: Mapping[str, int], start: int) -> dict[str, tuple[int, int]]:
    sections = {}
    for name, length in lengths.items():
        sections[name] = (start, length)
        start += length
    return sections


def state_size(sizes: Mapping[str, int]) -> int:
    """Return the number of doubles of a state."""
    start, length = state_sections(sizes)["parameters"]
    return start + length


def measured_sections(sizes: Mapping[str, int]) -> dict[str, tuple[int, int]]:
    """Return the offset and length of each group of measurements (``holonom_measure``)."""
    dim, turning = sizes["dim"], 1 if sizes["dim"] == 2 else 3
    n = dim * (sizes["n_free"] + sizes["n_driven"])
    lengths = {
        "position": n,
        "velocity": n,
        "place": dim * sizes["n_places"],
        "place_velocity": dim * sizes["n_places"],
        "quantity": sizes["n_quantities"],
        "quantity_rate": sizes["n_quantities"],
        "element_force": sizes["n_elements"],
        "rod_force": sizes["n_form_rows"],
        "multiplier": sizes["n_rows"],
        "quaternion": 4 * sizes["n_bodies"],
        "body_rate": 3 * sizes["n_bodies"],
        "reaction_force": dim * sizes["n_reactions"],
        "reaction_torque": turning * sizes["n_reactions"],
        "driven_force": dim * sizes["n_driven"],
        "energy": 7,
        "residual": 2,
        "momentum": dim,
        "angular_momentum": turning,
        "solver": 6,
    }
    return _consecutive(lengths, 0)


def measured_size(sizes: Mapping[str, int]) -> int:
    """Return the number of measurements."""
    start, length = measured_sections(sizes)["solver"]
    return start + length
