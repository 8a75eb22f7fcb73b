"""Assembly: a scene becomes a model. Here, and nowhere else, names turn into indices."""

from __future__ import annotations

import warnings
from array import array
from collections.abc import Iterable, Mapping, Sequence
from itertools import chain, pairwise

from solver.mechanics.build_mechanism import build_mechanism
from solver.mechanics.dependencies import dependencies
from solver.mechanics.kkt_pattern import eliminations
from solver.mechanics.outputs import named
from solver.mechanics.parts import Parts
from solver.mechanics.sensors import Sensors
from solver.mechanics.structure import Structure, flat, pointers
from solver.mechanics.switches import names_of_switches
from solver.mechanics.tape import CODE, MOST_SWITCHES, Motion, Numbers, Operations, Segment
from solver.mechanics.variables import Symbols, variables_of
from solver.options import OPTIONS, tolerance_of
from solver.runtime import AssemblyError, Experiment, Integrator, Model, OptionError
from solver.runtime.layout import (
    FACTORS,
    FORM_TURNED,
    INPUT_COURSES,
    SIZES,
    STORES,
    TABLES,
    measured_size,
)
from solver.runtime.model import Rule
from solver.scene import (
    BodyJoint,
    Expr,
    ExpressionError,
    Number,
    Scene,
    SceneWarning,
    symbols,
)
from solver.scene.joint_springs import FIELD_OF
from solver.scene.reader import collector_paused
from solver.scene.states import sampled_states

STEEP = {CODE[name] for name in ("sqrt", "pow", "asin", "acos")}
"""Operations that may have a value where their slope is infinite."""
SLOTS_OF_TOLERANCE = 36
SLOTS = {2: 4, 4: 20, 6: 36, 8: 60}
"""Half steps whose misses a state keeps, by the order: all of two internal steps. A tolerance may
choose any order, and has those of two steps of order 6; where some islands take covers and
others compositions there is room for those of one. An order that is set after the assembly works
with fewer slots, and takes up to a third longer."""


def assemble(scene: Scene, asked: Iterable[str] = ()) -> Model:
    """Return the model of a scene.

    Parameters
    ----------
    scene : Scene
    asked : iterable of str, optional
        Names of quantities that are variables on demand, such as accelerations; those that the
        scene names are there as well.

    Raises
    ------
    SceneError
        When the mechanism of the scene cannot be assembled with its own numbers: every broken rule,
        with its line. A scene made by hand can also have a setting that is out of range.
    """
    return assemble_parts(scene, asked)[1]


@collector_paused()
def assemble_parts(scene: Scene, asked: Iterable[str] = ()) -> tuple[Parts, Model]:
    """Return the parts of a scene and its model; raises as `assemble`."""
    try:
        parts, model = unchecked_model(scene, asked)
    except ExpressionError as error:
        text = f"a number of the mechanism has no finite value: {error.message}"
        scene.fail([scene.error("", f"{text}; look for a very large or small one")])
    except AssemblyError as error:
        scene.fail([scene.error("", str(error))])
    try:
        Integrator(model, log=_keep_for_the_run).initialise()
    except (AssemblyError, OptionError) as error:
        _report(scene, model, str(error).splitlines())
    return parts, model


def _keep_for_the_run(_: str) -> None:
    """Say nothing of a remark: the run that follows makes it, too."""


def _report(scene: Scene, model: Model, sentences: Iterable[str]) -> None:
    """Raise the sentences, each at the part of the scene whose name it begins with."""
    location = {named.name: named.location for named in (*model.rules, *model.rows)}
    problems = []
    for sentence in sentences:
        name, _, rest = sentence.partition(": ")
        if name.startswith("solver."):
            problems.append(scene.error(name, rest))
        elif name in location:
            problems.append(scene.error(location[name], rest))
        else:
            problems.append(scene.error("", sentence))
    scene.fail(problems)


def unchecked_model(scene: Scene, asked: Iterable[str] = ()) -> tuple[Parts, Model]:
    """Return the parts of a scene and its model, whose numbers are not yet checked."""
    parts = build_mechanism(scene)
    sensors = Sensors(parts, _named_by(scene).union(asked))
    table = list(named(sensors))
    structure = Structure(parts.mechanism)
    known = Symbols(scene, sensors, table, structure)
    sections = sections_of(scene, structure)
    mechanism = parts.mechanism
    signals = [*mechanism.driven_signals, *mechanism.signals]
    inputs = enumerate(scene.inputs.values())
    moving = [place for place, x in inputs if x.interpolation != "hold"]
    numbers = Numbers(sections, signals, known.meaning, moving)
    tables = structure.tables() | eliminations(structure) | _functions(structure, numbers)
    places = map(numbers.place, mechanism.rule_numbers)
    rules = tuple(Rule(x, *rule[1:]) for x, rule in zip(places, mechanism.rules, strict=True))
    courses = (INPUT_COURSES.index(x.interpolation) for x in scene.inputs.values())
    tables["input_course"] = array("i", courses)
    clocks = [numbers.tick(held) for held in mechanism.held]
    variables = tuple(variables_of(scene, table, structure, numbers))
    for kink in sorted(mechanism.kinks, key=lambda x: x.is_of_energy):
        numbers.tape.add_kink(kink)
    switches = [*numbers.tape.switches.values()]
    if numbers.tape.has_more:
        warnings.warn(
            f"the formulas of '{scene.name}' have more than {MOST_SWITCHES} conditions and kinks: "
            "steps do not end at the others, which costs accuracy there; write fewer of them",
            SceneWarning,
            stacklevel=2,
        )
    tables["switch_table"] = flat(
        [x.argument, x.side, x.kind, x.segment, x.motion == Motion.WITH_QUANTITIES]
        for x in switches
    )
    sides = [switch.side for switch in switches]
    tables["held_table"] = flat((following, sides.index(side)) for following, side in clocks)
    tables["tape"] = array("i", (x for s in Segment for x in numbers.tape.operations[s]))
    model = Model(
        name=scene.name,
        description=scene.description,
        sizes=sizes_of(scene, structure, numbers, tables),
        tables={name: tables[name] for name in TABLES},
        offsets=numbers.offsets,
        numbers=numbers.finish(),
        variables=variables,
        rules=rules,
        rows=tuple(row.row for row in structure.multipliers),
        sampled=tuple(name for _, _, name in structure.sampled),
        switches=names_of_switches(parts, switches, _clocks(scene, tables["held_table"][1::2])),
        forces=_types_of_forces(scene),
        meshes=parts.meshes,
        settings=_settings(scene, unilateral=bool(structure.sizes["unilateral"])),
        experiment=Experiment(
            start_time=scene.experiment.start_time,
            stop_time=scene.experiment.stop_time,
            step_size=scene.experiment.step_size,
            tolerance=scene.experiment.tolerance or tolerance_of(vars(scene.solver)) or None,
        ),
    )
    model.dependencies = dependencies(scene, structure, known, variables)
    model.scene = scene
    return parts, model


def _clocks(scene: Scene, switches: Iterable[int]) -> dict[int, str]:
    """Return what clocks of states are called, by their places among the switches."""
    owners: dict[int, dict[str, None]] = {}
    for (_, owner, *_), switch in zip(sampled_states(scene.states), switches, strict=True):
        owners.setdefault(switch, {})[f"'{owner}'"] = None
    return {
        switch: f"state{'s' * (len(names) > 1)} {', '.join(names)}"
        for switch, names in owners.items()
    }


def _named_by(scene: Scene) -> frozenset[str]:
    """Names in formulas of outputs, of ports of the FMU, and of plots."""
    mentioned = (name for output in scene.outputs.values() for name in symbols(output.value))
    shown = chain(*scene.view.plots, scene.fmu.outputs or ())
    return frozenset(chain(mentioned, shown))


def _types_of_forces(scene: Scene) -> dict[str, str]:
    """Types of all forces by their names, with those of springs and dampers in joints."""
    found = {name: force.type for name, force in scene.forces.items()}
    for name, joint in scene.joints.items():
        if isinstance(joint, BodyJoint):
            twists = "" if joint.springs_along else "torsion_"
            for word, field in FIELD_OF.items():
                if getattr(joint, field) is not None:
                    found[f"{name}.{word}"] = f"{twists}{word}"
    return found


def _settings(scene: Scene, *, unilateral: bool) -> dict[str, float | str | bool]:
    """Return the settings; whole numbers become floats, as all numbers of a state are."""
    used = (name for name, option in OPTIONS.items() if unilateral or not option.of_contacts)
    given = {name: getattr(scene.solver, name) for name in used}
    return {
        name: float(value) if isinstance(value, int) and not isinstance(value, bool) else value
        for name, value in given.items()
    }


def _functions(structure: Structure, numbers: Numbers) -> dict[str, array]:
    """Operations of the function rows, velocity rows and potentials."""
    formulas = (*(row.formula for row in structure.functions), *structure.potentials.items)
    slips = {found[0]: found for found in structure.slips_together}
    operations: list[Operations] = []
    while (j := len(operations)) < len(formulas):
        value, leaves = formulas[j].value, formulas[j].leaves
        if j in slips:
            operations += numbers.slips([formulas[k].value for k in slips[j]], leaves)
        elif formulas[j].role == STORES:
            operations.append(numbers.operations(value, len(leaves)))
        else:  # no energy varies with it
            vary = numbers.formulas_vary
            operations.append(numbers.operations(value, len(leaves)))
            numbers.formulas_vary = vary
    depths = [-1] * len(structure.potentials)
    for k, (potential, found) in enumerate(
        zip(structure.potentials.items, operations[len(structure.functions) :], strict=True)
    ):
        if potential.damping is not None:  # the energy is a power of the depth, times a number
            depths[k] = [x[1] for x in found.each if x[0] == CODE["pow"]][-1]
    return {
        "function_ptr": pointers(x.each for x in operations),
        "function_still": array("i", (x.still for x in operations)),
        "function_known": array("i", (x.known for x in operations)),
        "operation": flat(y for x in operations for y in x.each),
        "depth_register": array("i", depths),
        "force_role": array("i", (x.role for x in structure.potentials.items)),
    }


def sections_of(scene: Scene, structure: Structure) -> dict[str, Sequence[Number]]:
    """Return the contents of the sections, in their order; what is derived later is 0."""
    moving = structure.nodes[: structure.n_moving]
    entries = [entry for entries in structure.entries for entry in entries]
    turned = entries if any(kind & FORM_TURNED for kind in structure.kinds) else []
    parameters = [p.value for p in scene.parameters.values() if not isinstance(p.value, Expr)]
    contacts, frictions = structure.mechanism.contacts, structure.mechanism.frictions
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
        "depth_damping": [x.damping or 0.0 for x in structure.potentials.items],
        "restitution": [contact.restitution for contact in contacts],
        "sliding": [friction.sliding for friction in frictions],
        "static": [friction.static for friction in frictions],
        "preload": [friction.preload for friction in frictions],
        "smooth_speed": [friction.smooth_speed for friction in frictions],
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
        "held": [0.0] * sizes["n_held"],
        "held_start": [held.start for held in structure.mechanism.held],
        "signal": [0.0] * sizes["n_signals"],
        "sensor": [0.0] * sizes["n_quantities"],
        "sensor_rate": [0.0] * sizes["n_quantities"],
        "node_mass": [node.mass for node in moving],
        "node_weight": [node.weight for node in moving],
        "velocity_weight": [node.velocity_weight for node in moving],
        "measured": [0.0] * measured_size(structure.sizes),
    }


def _slots(scene: Scene) -> int:
    order, adapts = scene.solver.order, tolerance_of(vars(scene.solver)) > 0.0
    return SLOTS_OF_TOLERANCE if adapts and not order else SLOTS[order or 2]


def _flat(vectors: Iterable[Sequence[Number]]) -> list[Number]:
    return [number for vector in vectors for number in vector]


def sizes_of(
    scene: Scene, structure: Structure, numbers: Numbers, tables: Mapping[str, array]
) -> dict[str, int]:
    """Return all sizes of a model."""
    tape = numbers.tape
    moving = {name for name, given in scene.inputs.items() if given.interpolation != "hold"}
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
        "steep_signals": int(not STEEP.isdisjoint(tape.operations[Segment.SIGNALS][::5])),
        "time_dependent": int(bool(tape.used[Segment.LAWS] & {"t", *moving})),
        "fits_velocities": int(scene.fits_velocities),
        "variable_potential": int(Segment.LAWS in stored or numbers.formulas_vary),
        "n_registers": max([1, *registers]),
        "n_lu_values": tables["lu_ptr"][-1],
        **{f"n_{x}_values": (tables[f"{x}_lu_ptr"] or (0,))[-1] for x in FACTORS},
        "n_slots": _slots(scene),
        "n_switches": len(tape.switches),
        "switching": int(bool(tape.switches)),
        "n_motion_switches": sum(
            x.motion is Motion.WITH_QUANTITIES for x in tape.switches.values()
        ),
        "n_kinks": sum(x.kink is not None for x in tape.switches.values()),
        "n_energy_kinks": sum(
            x.kink is not None and x.kink.is_of_energy for x in tape.switches.values()
        ),
    }
    return {name: known[name] for name in SIZES}
