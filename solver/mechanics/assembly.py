"""Assembly: a scene becomes a model. Here, and nowhere else, names turn into indices."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence

from solver.mechanics.elimination import Pattern, eliminate
from solver.mechanics.numbers import Numbers
from solver.mechanics.parts import Parts, collect
from solver.mechanics.tape import Segment
from solver.mechanics.variables import distance_between, meanings, measured, variable_table
from solver.runtime import AssemblyError, Experiment, Integrator, Model, OptionError, Rule
from solver.runtime.layout import SIZES
from solver.runtime.options import DEFAULTS
from solver.scene import Expr, Number, Scene


def assemble(scene: Scene) -> Model:
    """Return the model of a scene.

    Raises
    ------
    SceneError
        When the mechanism of the scene cannot be assembled with its own numbers: every broken rule,
        with its line. A scene made by hand can also have a setting that is out of range.
    """
    parts = collect(scene)
    model = _model(scene, parts)
    try:
        Integrator(model).initialise()
    except (AssemblyError, OptionError) as error:
        _report(scene, str(error).splitlines())
    return model


def _report(scene: Scene, sentences: Iterable[str]) -> None:
    tables = {"point": "points", "body": "bodies", "joint": "joints", "force": "forces"}
    problems = []
    for sentence in sentences:
        label, _, rest = sentence.partition(": ")
        kind, _, name = label.partition(" ")
        location = f"{tables[kind]}.{name.strip(chr(39))}" if kind in tables else ""
        if label.startswith("solver."):
            location = label
        problems.append(scene.error(location, rest if location else sentence))
    scene.fail(problems)


def _flat(vectors: Iterable[Sequence[Number]]) -> list[Number]:
    return [number for vector in vectors for number in vector]


def _sections(scene: Scene, parts: Parts) -> dict[str, Sequence[Number]]:
    """Contents of the sections of the vector of numbers, in their order."""
    entries = [entry for link in parts.links for entry in link.entries]
    laws = list(zip(*parts.line_law, strict=True)) or [(), (), ()]
    parameters = [p.value for p in scene.parameters.values() if not isinstance(p.value, Expr)]
    return {
        "mass": list(parts.coupling.values()),
        "alpha": [coefficient for _, coefficient in entries],
        "beta": [coefficient for _, coefficient in entries],
        "row_constant": parts.row_length2,
        "row_scale": parts.row_length2,
        "row_sigma": [0.0] * len(parts.row_link),
        "stiffness": list(laws[0]),
        "free_length": list(laws[1]),
        "damping": list(laws[2]),
        "gravity": list(scene.gravity),
        "support": _flat(parts.support),
        "initial_position": _flat(parts.position),
        "initial_velocity": _flat(parts.velocity),
        "load": _flat(parts.load),
        "moment": _flat(parts.moment),
        "parameter": parameters,
        "input": [given.start for given in scene.inputs.values()],
        "time": [scene.experiment.start_time],
        "node_mass": parts.mass,
        "extent": [0.0, 0.0],
        "measured": [0.0] * sum(1 for _ in measured(parts)),
    }


def _free(parts: Parts, link: int) -> list[int]:
    return [node for node, _ in parts.links[link].entries if node >= 0]


def _pattern(parts: Parts) -> Pattern:
    couplings = [pair for pair in parts.coupling if pair[0] != pair[1]]
    laws = [_free(parts, link) for link in (*parts.line_link, *parts.moment_link)]
    rows = [_free(parts, link) for link in parts.row_link]
    return eliminate(len(parts.free_names), parts.dim, rows, [*couplings, *laws])


def _slots(parts: Parts, pattern: Pattern) -> dict[str, array]:
    """Where in the factors' values each contribution to the tangent goes."""
    dim, at = parts.dim, pattern.node_position

    def diagonal(a: int, b: int) -> list[int]:
        return [pattern.slot(at[a] + k, at[b] + k) for k in range(dim)]

    def block(a: int, b: int) -> list[int]:
        return [pattern.slot(at[a] + i, at[b] + k) for i in range(dim) for k in range(dim)]

    rows = array("i")
    for row, link in enumerate(parts.row_link):
        free, place = _free(parts, link), pattern.row_position[row]
        rows.extend(slot for a in free for b in free for slot in diagonal(a, b))
        rows.extend(pattern.slot(at[a] + k, place) for a in free for k in range(dim))
        rows.extend(pattern.slot(place, at[a] + k) for a in free for k in range(dim))

    def law(links: list[int]) -> array:
        frees = [_free(parts, link) for link in links]
        return array("i", (s for free in frees for a in free for b in free for s in block(a, b)))

    masses = (slot for a, b in parts.coupling for slot in diagonal(a, b))
    return {
        "mass_slot": array("i", masses),
        "row_slot": rows,
        "line_slot": law(parts.line_link),
        "moment_slot": law(parts.moment_link),
    }


def _tables(parts: Parts, numbers: Numbers) -> dict[str, array]:
    n_free, pattern = len(parts.free_names), _pattern(parts)
    ptr, nodes = array("i", [0]), array("i")
    for link in parts.links:
        nodes.extend(n if n >= 0 else n_free - 1 - n for n, _ in link.entries)
        ptr.append(len(nodes))
    operations = numbers.tape.operations
    return {
        "form_ptr": ptr,
        "form_free": array("i", (len(_free(parts, link)) for link in range(len(parts.links)))),
        "form_node": nodes,
        "form_square": array("i", [1] * len(parts.links)),
        "row_form": array("i", parts.row_link),
        "line_form": array("i", parts.line_link),
        "moment_form": array("i", parts.moment_link),
        "load_node": array("i", parts.load_node),
        "angle_form": array("i", parts.angle_link),
        "mass_node": array("i", (node for pair in parts.coupling for node in pair)),
        "tape": array("i", (x for segment in Segment for x in operations[segment])),
        "node_position": pattern.node_position,
        "row_position": pattern.row_position,
        "lu_ptr": pattern.ptr,
        "lu_column": pattern.column,
        "lu_target": pattern.target,
        **_slots(parts, pattern),
    }


def _sizes(parts: Parts, numbers: Numbers, tables: dict[str, array]) -> dict[str, int]:
    operations = {segment: len(x) // 5 for segment, x in numbers.tape.operations.items()}
    springs = max(numbers.segment_of["stiffness"], numbers.segment_of["free_length"])
    lines = {
        "dim": parts.dim,
        "n_free": len(parts.free_names),
        "n_support": len(parts.support),
        "n_forms": len(parts.links),
        "n_rows": len(parts.row_link),
        "n_lines": len(parts.line_link),
        "n_moments": len(parts.moment_link),
        "n_loads": len(parts.load_node),
        "n_mass": len(parts.coupling),
        "n_angles": len(parts.angle_link),
        "n_parameters": numbers.offsets["input"] - numbers.offsets["parameter"],
        "n_inputs": numbers.offsets["time"] - numbers.offsets["input"],
        "n_numbers": numbers.tape.end,
        "n_tape_parameters": operations[Segment.PARAMETERS],
        "n_tape_laws": operations[Segment.LAWS],
        "n_tape_outputs": operations[Segment.OUTPUTS],
        "time_dependent": int(numbers.time_dependent),
        "variable_potential": int(springs is Segment.LAWS),
        "n_lu_values": tables["lu_ptr"][-1],
    }
    return {name: lines[name] for name in SIZES}


def _model(scene: Scene, parts: Parts) -> Model:
    sections = _sections(scene, parts)
    calls = meanings(scene, parts)
    numbers = Numbers(sections, calls, lambda call: distance_between(parts.dim, call))
    rules = tuple(
        Rule(number=numbers.place(number), relation=relation, bound=bound, message=message)
        for number, relation, bound, message in parts.rules
    )
    calculated = {
        name: numbers.place(parameter.value)
        for name, parameter in scene.parameters.items()
        if isinstance(parameter.value, Expr)
    }
    outputs = {name: numbers.place(output.value) for name, output in scene.outputs.items()}
    tables = _tables(parts, numbers)
    experiment = scene.experiment
    return Model(
        name=scene.name,
        description=scene.description,
        sizes=_sizes(parts, numbers, tables),
        tables=tables,
        offsets=numbers.offsets,
        numbers=array("d", numbers.finish()),
        variables=variable_table(scene, parts, outputs, calculated),
        rules=rules,
        row_names=tuple(parts.row_labels),
        settings={
            name: float(value) if isinstance(value, int) and name != "paired" else value
            for name, value in ((name, getattr(scene.solver, name)) for name in DEFAULTS)
        },
        experiment=Experiment(
            start_time=experiment.start_time,
            stop_time=experiment.stop_time,
            step_size=experiment.step_size,
            tolerance=experiment.tolerance,
        ),
    )
