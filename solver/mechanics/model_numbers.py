"""Contents of the vector of numbers of a model, section by section, and the sizes of a model."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise

from solver.mechanics.numbers import Numbers
from solver.mechanics.structure import Structure
from solver.mechanics.tape import Segment
from solver.runtime.layout import SIZES, measured_size
from solver.runtime.options import slots_for
from solver.scene import Expr, Number, Scene


def sections_of(scene: Scene, structure: Structure) -> dict[str, Sequence[Number]]:
    """Return the contents of the sections, in their order; what is derived later is 0."""
    moving = structure.nodes[: structure.n_moving]
    entries = [entry for entries in structure.entries for entry in entries]
    turned = entries if structure.any_turned else []
    parameters = [p.value for p in scene.parameters.values() if not isinstance(p.value, Expr)]
    sizes = structure.sizes
    zeros = [0.0] * sizes["n_rows"]
    return {
        "mass": [mass for _, _, mass in structure.masses],
        "alpha": [entry.alpha[0] for entry in entries],
        "beta": [entry.beta[0] for entry in entries],
        "alpha_turn": [entry.alpha[1] for entry in turned],
        "beta_turn": [entry.beta[1] for entry in turned],
        "row_constant": [row.constant for row in structure.form_rows.items],
        "row_base": [row.scale.base for row in structure.multipliers],
        "extent": [0.0, 0.0],
        "row_scale": zeros,
        "row_sigma": zeros,
        "stiffness": [element.stiffness for element in structure.elements.items],
        "rest": [element.rest for element in structure.elements.items],
        "damping": [element.damping for element in structure.elements.items],
        "drive": [element.drive for element in structure.elements.items],
        "gravity": list(scene.gravity),
        "support": _flat(node.position for node in structure.nodes[structure.n_moving :]),
        "initial_position": _flat(node.position for node in moving),
        "initial_velocity": _flat(node.velocity for node in moving),
        "load": _flat(load.value for load in structure.loads.items),
        "moment": _flat(moment.value for moment in structure.moments.items),
        "body_moment": _flat(moment.value for moment in structure.body_moments.items),
        "parameter": parameters,
        "input": [given.start for given in scene.inputs.values()],
        "time": [scene.experiment.start_time],
        "signal": [0.0] * sizes["n_signals"],
        "sensor": [0.0] * sizes["n_quantities"],
        "sensor_rate": [0.0] * sizes["n_quantities"],
        "node_mass": [node.mass for node in moving],
        "node_weight": [node.weight for node in moving],
        "velocity_weight": [node.velocity_weight for node in moving],
        "measured": [0.0] * measured_size(sizes),
    }


def _flat(vectors: Iterable[Sequence[Number]]) -> list[Number]:
    return [number for vector in vectors for number in vector]


def sizes_of(
    scene: Scene, structure: Structure, numbers: Numbers, tables: Mapping[str, array]
) -> dict[str, int]:
    """Return all sizes of a model."""
    tape = numbers.tape
    ramped = {name for name, given in scene.inputs.items() if given.interpolation == "ramp"}
    stored = [numbers.segment_of[name] for name in ("stiffness", "rest")]
    formulas = structure.composites[len(structure.elements) :]
    operations = [b - a for a, b in pairwise(tables["function_ptr"])]
    registers = [len(c.leaves) + n for c, n in zip(formulas, operations, strict=True)]
    known = {
        **structure.sizes,
        **{f"n_tape_{x.name.lower()}": len(tape.operations[x]) // 5 for x in Segment},
        "n_parameters": sum(not isinstance(p.value, Expr) for p in scene.parameters.values()),
        "n_inputs": len(scene.inputs),
        "n_numbers": tape.end,
        "time_dependent": int(bool(tape.used[Segment.LAWS] & {"t", *ramped})),
        "variable_potential": int(Segment.LAWS in stored or numbers.formulas_vary),
        "n_registers": max([1, *registers]),
        "n_lu_values": tables["lu_ptr"][-1],
        "n_lean_values": (tables["lean_lu_ptr"] or (0,))[-1],
        "n_slots": slots_for(scene.solver.order, chosen=scene.solver.tolerance > 0.0),
    }
    return {name: known[name] for name in SIZES}
