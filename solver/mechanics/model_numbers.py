"""Contents of the vector of numbers of a model, section by section, and the sizes of a model."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Mapping, Sequence

from solver.mechanics.numbers import Numbers
from solver.mechanics.structure import Structure
from solver.mechanics.tape import Segment
from solver.runtime.layout import SIZES, measured_size
from solver.runtime.options import slots_for
from solver.scene import Expr, Number, Scene


def sections_of(
    scene: Scene, structure: Structure, counts: Mapping[str, int]
) -> dict[str, Sequence[Number]]:
    """Return the contents of the sections, in their order; what is derived later is 0."""
    moving = structure.nodes[: structure.n_moving]
    entries = [entry for entries in structure.entries for entry in entries]
    turned = entries if structure.any_turned else []
    parameters = [p.value for p in scene.parameters.values() if not isinstance(p.value, Expr)]
    zeros = [0.0] * counts["n_rows"]
    return {
        "mass": [mass for _, _, mass in structure.masses],
        "alpha": [entry.alpha[0] for entry in entries],
        "beta": [entry.beta[0] for entry in entries],
        "alpha_turn": [entry.alpha[1] for entry in turned],
        "beta_turn": [entry.beta[1] for entry in turned],
        "row_constant": [row.constant for row in structure.form_rows.items],
        "row_base": _bases(structure),
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
        "signal": [0.0] * counts["n_signals"],
        "sensor": [0.0] * counts["n_quantities"],
        "sensor_rate": [0.0] * counts["n_quantities"],
        "node_mass": [node.mass for node in moving],
        "node_weight": [node.weight for node in moving],
        "velocity_weight": [node.velocity_weight for node in moving],
        "measured": [0.0] * measured_size(counts),
    }


def _flat(vectors: Iterable[Sequence[Number]]) -> list[Number]:
    return [number for vector in vectors for number in vector]


def _bases(structure: Structure) -> list[Number]:
    return [
        *(row.scale.base for row in structure.form_rows.items),
        *([1.0] * (structure.mechanism.dim * len(structure.coincidences))),
        *(row.scale.base for row in structure.functions),
    ]


def sizes_of(
    scene: Scene, structure: Structure, counts: Mapping[str, int], numbers: Numbers,
    tables: Mapping[str, array],
) -> dict[str, int]:  # fmt: skip
    """Return all sizes of a model."""
    tape, composites = numbers.tape, structure.composites
    length = {segment: len(tape.operations[segment]) // 5 for segment in Segment}
    stored = [numbers.segment_of[name] for name in ("stiffness", "rest")]
    ramped = {name for name, given in scene.inputs.items() if given.interpolation == "ramp"}
    formulas = composites[len(structure.elements) :]
    operations = [b - a for a, b in zip(*_shifted(tables["function_ptr"]), strict=True)]
    registers = [len(c.leaves) + n for c, n in zip(formulas, operations, strict=True)]
    known = {
        **counts,
        "n_numbers": tape.end,
        "n_tape_parameters": length[Segment.PARAMETERS],
        "n_tape_laws": length[Segment.LAWS],
        "n_tape_signals": length[Segment.SIGNALS],
        "n_tape_outputs": length[Segment.OUTPUTS],
        "time_dependent": int(bool(tape.used[Segment.LAWS] & {"t", *ramped})),
        "variable_potential": int(Segment.LAWS in stored or numbers.formulas_vary),
        "sensing": int(structure.mechanism.sensing),
        "n_registers": max([1, *registers]),
        "n_local_forms": max([1, *(len(c.forms) for c in composites)]),
        "n_local_nodes": max([1, *(len(c.nodes) for c in composites)]),
        "n_lu_values": tables["lu_ptr"][-1],
        "n_lean_values": (tables["lean_lu_ptr"] or (0,))[-1],
        "n_slots": slots_for(scene.solver.order, chosen=scene.solver.tolerance > 0.0),
        "n_islands": structure.islands.count,
        "n_sampled": len(structure.sampled),
    }
    return {name: known[name] for name in SIZES}


def _shifted(ptr: array) -> tuple[array, array]:
    return ptr[:-1], ptr[1:]
