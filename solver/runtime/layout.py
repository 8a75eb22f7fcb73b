"""Where everything of a model and a state lies in memory, in one place.

The names are those of ``solver/kernel/holonom.h``, in its order: `SIZES`, `TABLES`, `OFFSETS` make
up its ``holonom_model``; `HEAD` lists the scalars at the beginning of a state. A state is one block
of doubles: the head, then the vectors of `state_sections`. All that survives a step is in it.
"""

from __future__ import annotations

from collections.abc import Mapping

ABI = 2
"""``HOLONOM_ABI`` of the header: changes with the structures, the head and the entry points."""

SIZES = (
    "dim", "n_free", "n_support", "n_forms", "n_rows", "n_lines", "n_moments", "n_loads", "n_mass",
    "n_angles", "n_parameters", "n_inputs", "n_numbers", "n_tape_parameters", "n_tape_laws",
    "n_tape_outputs", "time_dependent", "variable_potential", "n_lu_values",
)  # fmt: skip
"""Integers of a model, each a 32-bit field."""

TABLES = (
    "form_ptr", "form_free", "form_node", "form_square", "row_form", "line_form", "moment_form",
    "load_node", "angle_form", "mass_node", "tape", "node_position", "row_position", "lu_ptr",
    "lu_column", "lu_target", "mass_slot", "row_slot", "line_slot", "moment_slot",
)  # fmt: skip
"""Integer arrays of a model, each a pointer."""

OFFSETS = (
    "mass", "alpha", "beta", "row_constant", "row_scale", "row_sigma", "stiffness", "free_length",
    "damping", "gravity", "support", "initial_position", "initial_velocity", "load", "moment",
    "parameter", "input", "time", "node_mass", "extent", "measured",
)  # fmt: skip
"""Sections of the vector of numbers, each a 32-bit offset."""

HEAD = (
    "time", "kinetic_start", "potential_start", "stored_start", "energy_reference", "work",
    "work_low", "dissipated", "dissipated_low", "defect", "defect_low", "residual", "residual_low",
    "mean_time", "mean_time_before", "parity",
    "newton_iterations", "uzawa_iterations", "substeps", "status", "formulation", "simultaneous",
    "paper_update", "paired", "step_size", "tolerance", "penalty", "xi", "omega", "max_newton",
    "max_uzawa",
)  # fmt: skip
"""Scalars at the head of a state."""

PLACE = {name: place for place, name in enumerate(HEAD)}
"""Index of each scalar of the head."""


def state_sections(sizes: Mapping[str, int]) -> dict[str, tuple[int, int]]:
    """Return the offset and length of each vector of a state behind its head.

    ``q, q_low, v, v_low`` (n each): coordinates [m], velocities [m/s], and what rounding left over;
    ``a_first, a_second`` (n each): last 2 (d - h v)/h^2 of either half of a pair; ``mu_first,
    mu_second`` (n_rows each): last multipliers; ``mean, mean_before``: means of two neighbours;
    ``turns``: full turns of planar links; ``inputs, parameters``.
    """
    n = sizes["dim"] * sizes["n_free"]
    lengths = {
        **dict.fromkeys(("q", "q_low", "v", "v_low", "a_first", "a_second"), n),
        **dict.fromkeys(("mu_first", "mu_second", "mean", "mean_before"), sizes["n_rows"]),
        "turns": sizes["n_angles"],
        "inputs": sizes["n_inputs"],
        "parameters": sizes["n_parameters"],
    }
    sections, start = {}, len(HEAD)
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
    n, momenta = sizes["dim"] * sizes["n_free"], 1 if sizes["dim"] == 2 else 3
    lengths = {
        "position": n,
        "velocity": n,
        "angle": sizes["n_angles"],
        "angular_velocity": sizes["n_angles"],
        "line_length": sizes["n_lines"],
        "line_force": sizes["n_lines"],
        "rod_force": sizes["n_rows"],
        "energy": 7,
        "residual": 2,
        "momentum": sizes["dim"],
        "angular_momentum": momenta,
        "solver": 4,
    }
    sections, start = {}, 0
    for name, length in lengths.items():
        sections[name] = (start, length)
        start += length
    return sections


def measured_size(sizes: Mapping[str, int]) -> int:
    """Return the number of measurements."""
    start, length = measured_sections(sizes)["solver"]
    return start + length
