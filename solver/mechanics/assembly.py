"""Assembly: a scene becomes a model. Here, and nowhere else, names turn into indices."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence

from solver.mechanics.build_mechanism import collect
from solver.mechanics.dependencies import dependencies
from solver.mechanics.kkt_pattern import eliminations
from solver.mechanics.model_numbers import sections_of, sizes_of
from solver.mechanics.numbers import Numbers
from solver.mechanics.outputs import named
from solver.mechanics.sensors import Measures, Named, Ref
from solver.mechanics.structure import Structure, pointers
from solver.mechanics.tape import Segment
from solver.mechanics.variables import Symbols, distance_between, output, variable_table
from solver.options import OPTIONS
from solver.runtime import AssemblyError, Experiment, Integrator, Model, OptionError
from solver.runtime.layout import TABLES, measured_sections
from solver.runtime.model import Rule, Variable
from solver.scene import Expr, ExpressionError, Scene
from solver.scene.reader import collector_paused


def assemble(scene: Scene) -> Model:
    """Return the model of a scene.

    Raises
    ------
    SceneError
        When the mechanism of the scene cannot be assembled with its own numbers: every broken rule,
        with its line. A scene made by hand can also have a setting that is out of range.
    """
    try:
        model = model_of(scene)
    except ExpressionError as error:
        text = f"a number of the mechanism has no finite value: {error.message}"
        scene.fail([scene.error("", f"{text}; look for a very large or small one")])
    except AssemblyError as error:
        scene.fail([scene.error("", str(error))])
    try:
        Integrator(model).initialise()
    except (AssemblyError, OptionError) as error:
        _report(scene, model, str(error).splitlines())
    return model


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


@collector_paused()
def model_of(scene: Scene) -> Model:
    """Return the model of a scene; its numbers are not yet checked."""
    parts = collect(scene)
    measures = Measures(parts)
    table = list(named(measures))
    structure = Structure(parts.mechanism)
    known = Symbols(scene, measures, table, structure)
    sections = sections_of(scene, structure)
    dim = scene.dimension
    mechanism = parts.mechanism
    signals = [*mechanism.driven_signals, *mechanism.signals]
    numbers = Numbers(
        sections, signals, known.meaning, lambda call: distance_between(dim, str(call))
    )
    tables = structure.tables() | eliminations(structure) | _functions(structure, numbers)
    places = map(numbers.place, mechanism.rule_numbers)
    rules = tuple(Rule(x, *rule[1:]) for x, rule in zip(places, mechanism.rules, strict=True))
    tables["input_ramp"] = array("i", (x.interpolation == "ramp" for x in scene.inputs.values()))
    variables = _variables(scene, table, structure, numbers)
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
        forces={name: force.type for name, force in scene.forces.items()},
        settings=_settings(scene),
        experiment=Experiment(
            start_time=scene.experiment.start_time,
            stop_time=scene.experiment.stop_time,
            step_size=scene.experiment.step_size,
            tolerance=scene.experiment.tolerance or scene.solver.tolerance or None,
        ),
    )
    model.dependencies = dependencies(scene, structure, known, variables)
    return model


def _settings(scene: Scene) -> dict[str, float | str | bool]:
    """Return the settings; whole numbers become floats, as all numbers of a state are."""
    given = {name: getattr(scene.solver, name) for name in OPTIONS}
    return {
        name: float(value) if isinstance(value, int) and not isinstance(value, bool) else value
        for name, value in given.items()
    }


def _variables(
    scene: Scene, table: Sequence[Named], structure: Structure, numbers: Numbers
) -> tuple[Variable, ...]:  # fmt: skip
    calculated = {
        name: numbers.place(parameter.value)
        for name, parameter in scene.parameters.items()
        if isinstance(parameter.value, Expr)
    }
    outputs = [
        output(name, x.unit, x.description, "number", numbers.place(x.value, Segment.OUTPUTS))
        for name, x in scene.outputs.items()
    ]
    sections = measured_sections(structure.sizes)
    measured = [
        output(x.name, x.unit, x.text, "measured", x.meaning.place(structure, sections))
        if isinstance(x.meaning, Ref)
        else output(x.name, x.unit, x.text, "number", numbers.place(x.meaning, Segment.OUTPUTS))
        for x in table
        if x.listed
    ]
    return variable_table(scene, outputs, measured, calculated)


def _functions(structure: Structure, numbers: Numbers) -> dict[str, array]:
    """Operations of the function rows, velocity rows and potentials."""
    formulas = (*(row.formula for row in structure.functions), *structure.potentials.items)
    operations = [numbers.operations(x.value, len(x.leaves)) for x in formulas]
    counted = pointers([range(len(x) // 4) for x in operations])
    flat = array("i", (x for listed in operations for x in listed))
    return {"function_ptr": counted, "operation": flat}
