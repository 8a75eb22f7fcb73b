"""Values by name, brought to the units and types of what they are for: scenes and FMUs."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from os import PathLike
from typing import TYPE_CHECKING, Any

from build_fmu.errors import UsageError
from build_fmu.study.parameter_files import entries_of_files
from build_fmu.study.values import (
    Entry,
    Mistake,
    WrongValueError,
    is_finite,
    is_number,
    nearest,
    plain,
    refuse,
    shown,
    wanted_instead,
)
from build_fmu.version import VERSION
from solver.options import OPTIONS, removed
from solver.scene.units import base_unit, literal, offset_of, si_unit, unit_help
from solver.scene.words import listed

if TYPE_CHECKING:
    from argparse import Namespace

    from fmpy.model_description import ModelDescription, ScalarVariable

    from solver.runtime import Model
    from solver.scene import Scene

SETTABLE = ("parameter", "input")
OURS = "holonom "
"""What the name of the tool begins with that wrote an FMU of this package."""
Source = Mapping[str, object] | str | PathLike[str]
"""Values by name, or a file of them."""


def entries_of(source: Source | None, argument: str = "parameters") -> dict[str, Entry]:
    """Values by name, each with its place; `argument` is what a mapping was given as."""
    if source is None:
        return {}
    if isinstance(source, str | PathLike):
        return entries_of_files([source])
    return {
        name: value
        if isinstance(value, Entry)
        else Entry(plain(value), f"{argument}[{name!r}]={shown(value)}")
        for name, value in source.items()
    }


def given_on_the_command_line(
    files: Sequence[str], settings: Iterable[tuple[str, object]]
) -> dict[str, Entry]:
    """Values of `--parameters` and `--set`, of which the latter count."""
    given = {
        name: Entry(value, f"--set {name}={shown(value) if type(value) is int else value}")
        for name, value in settings
    }
    return entries_of_files(files) | given


def study_arguments(arguments: Namespace) -> dict[str, Any]:
    """What sweeps and variants take of the command line, by its names in Python."""
    if not arguments.grid and not arguments.table:
        text = "nothing is varied; give --grid a=1:5:9 or --table FILE.csv"
        raise UsageError(text)
    return {
        "grid": arguments.grid,
        "table": arguments.table,
        "parameters": given_on_the_command_line(arguments.parameters, arguments.settings),
        "fresh": arguments.fresh,
        "engine": arguments.engine,
        "workers": arguments.jobs,
    }


# -------------------------------------------------------------------------------------- scenes


def scene_overrides(
    scene: str | PathLike[str] | Scene, entries: Mapping[str, Entry], told: Iterable[Mistake] = ()
) -> dict[str, object]:
    """Overrides of a scene by name.

    What a .ssv file says of settings that are as the scene has them changes nothing: it has all of
    an FMU, also those that follow from others.

    Raises
    ------
    UsageError
        With every mistake of files, of units, and those `told` before. Where there are some, those
        that the scene has with the other values are told as well.
    """
    from solver.scene import Given, SceneError

    mistakes: list[Mistake | str] = [*told, *(e.wrong for e in entries.values() if e.wrong)]
    is_told = bool(mistakes)
    entries = {name: entry for name, entry in entries.items() if not entry.wrong}
    if any(entry.unit or entry.repeats for entry in entries.values()):
        from build_fmu.export import load_scene
        from solver.mechanics import assemble

        entries = _fitted(assemble(load_scene(scene)), entries, mistakes)
    found: dict[str, object] = {
        name: Given(entry.value, entry.where, entry.named) for name, entry in entries.items()
    }
    if is_told:
        from build_fmu.export import load_scene

        try:
            load_scene(scene, found)
        except SceneError as error:
            mistakes += error.sentences()
    refuse(mistakes)
    return found


def _fitted(
    model: Model, entries: Mapping[str, Entry], mistakes: list[Mistake | str]
) -> dict[str, Entry]:
    """Values in the units of the scene, without those that it has already."""
    variables = {v.name: v for v in model.variables if v.causality in SETTABLE}
    fitted: dict[str, Entry] = {}
    for name, entry in entries.items():
        variable = variables.get(name)
        if variable is None:
            if entry.unit:
                message = f"{name}: only values of parameters and inputs can have a unit"
                mistakes.append(Mistake(entry.where, message, "leave the unit out"))
            fitted[name] = entry
            continue
        try:
            value = converted(entry, name, variable.unit)
        except WrongValueError as wrong:
            mistakes.append(wrong.at(entry.where))
            continue
        if value != variable.start:
            if variable.kind == "option" and isinstance(value, float) and value.is_integer():
                value = int(value)  # an FMU's numbers are Real, a scene's counts are not
            fitted[name] = Entry(value, entry.where)
    return fitted


def converted(entry: Entry, name: str, unit: str) -> object:
    """Value in `unit`; WrongValueError where the entry has one of another kind."""
    value = entry.value
    same, stated = entry.unit == unit, entry.base
    if not entry.unit or (same and not stated) or not is_finite(value):
        return value
    given, wanted = stated or base_unit(entry.unit), base_unit(unit or "1")
    if same and not wanted:
        return value
    # Of equal names one may count the radian, and the other not.
    fits = given and wanted and given.fits(wanted, radians=not same)
    if not unit and given and given.factor == 1.0 and not name.startswith("solver."):
        return value  # nobody said what the parameter is measured in
    if given is None or wanted is None or not fits:
        words = f"the unit {unit!r}" if unit else "no unit"
        unknown = f"{entry.unit!r} is not known, and the file does not define it"
        reason = f"{entry.unit!r} measures something else" if given else unknown
        help = f"{reason}; give the value in {unit}" if unit else "leave the unit out"
        if not given and (offset := offset_of(entry.unit)):
            help = "; ".join(offset)
        raise WrongValueError(name, f"given in {entry.unit!r}, but has {words}", help)
    if same and math.isclose(given.factor / wanted.factor, 1.0):
        return value  # 0.0174533 and all digits of it are one degree
    return float(value) * given.factor / wanted.factor


# ---------------------------------------------------------------------------------------- FMUs

_KINDS = {
    "Real": (is_finite, "a number"),
    "Integer": (lambda value: isinstance(value, int) and is_finite(value), "a whole number"),
    "Boolean": (lambda value: isinstance(value, bool), "true or false"),
    "String": (lambda value: isinstance(value, str), "a text"),
}
"""What a value for each type of variable must be."""


def fmu_settings(
    description: ModelDescription,
    rows: Iterable[Mapping[str, Entry]],
    told: list[Mistake] | None = None,
) -> list[dict[str, object]]:
    """Values of parameters and inputs of an FMU, for each of several runs.

    Raises
    ------
    UsageError
        With every name that it does not have, and every value of a wrong type, unit or size. If
        there is a list of those `told` already, it takes them instead.
    """
    variables = {v.name: v for v in description.modelVariables if v.causality in SETTABLE}
    mistakes = [] if told is None else told
    seen: dict[tuple[str, str, str], object] = {}  # of a grid every value comes many times
    settings = []
    for row in rows:
        values = {}
        for name, entry in row.items():
            if entry.wrong:
                mistakes.append(entry.wrong)
                continue
            if name not in variables:
                mistakes.append(_not_settable(entry.named or entry.where, name, description))
                continue
            known = (name, entry.where, repr(entry.value))
            if known not in seen:
                seen[known] = None
                try:
                    seen[known] = _checked(entry, variables[name], description.generationTool)
                except WrongValueError as wrong:
                    mistakes.append(wrong.at(entry.where))
            values[name] = seen[known]
        settings.append(values)
    refuse(mistakes if told is None else [])
    return settings


def _checked(entry: Entry, variable: ScalarVariable, tool: str | None) -> object:
    """Value in the unit and of the type of its variable, within its limits."""
    unit = getattr(variable, "unit", None) or ""
    found = (
        literal(entry.value) if variable.type == "Real" and isinstance(entry.value, str) else None
    )
    if found and not entry.unit:
        entry = replace(entry, value=found.value, unit=si_unit(found.unit))
    value = converted(entry, variable.name, unit)
    fits, words = _KINDS.get(variable.type, _KINDS["Integer"])  # an Enumeration is one
    in_unit = f" {unit}" if unit else ""
    if not fits(value):
        words = wanted_instead(value) if variable.type == "Real" else words
        words = f"{words} in{in_unit}" if unit else words
        help = (
            (unit_help(value) or "") if isinstance(value, str) and variable.type == "Real" else ""
        )
        raise WrongValueError(variable.name, f"must be {words}, got {shown(value)}", help)
    is_ours = tool == f"{OURS}{VERSION}" and variable.name.startswith("solver.")
    option = OPTIONS[variable.name.removeprefix("solver.")] if is_ours else None
    if is_number(value):
        low, high = (float(x) if x is not None else value for x in (variable.min, variable.max))
        if not low <= value <= high:
            limit = f">= {low:g}" if value < low else f"<= {high:g}"
            help = option.below if option and value < low else ""
            raise WrongValueError(variable.name, f"must be {limit}{in_unit}, got {value!r}", help)
    if option and not option.holds(value):  # an FMU of this version would refuse it in the run
        raise WrongValueError(variable.name, f"must be {option.rule}, got {value!r}")
    return float(value) if variable.type == "Real" and is_finite(value) else value


def _not_settable(where: str, name: str, description: ModelDescription) -> Mistake:
    """Mistake of a name that is none of a parameter or input."""
    causality = {v.name: v.causality for v in description.modelVariables}
    settable = [each for each, kind in causality.items() if kind in SETTABLE]
    if name in causality:
        kind = "an output" if causality[name] == "output" else f"a variable ({causality[name]})"
        help = f"settable: {listed(settable)}" if settable else "it has no parameters and inputs"
        return Mistake(where, f"{name}: is {kind} and cannot be set", help)
    message = f"{description.modelName} has no parameter or input {name!r}"
    if gone := removed(name):
        return Mistake(where, f"{message}: {gone}", "leave it out")
    table, dot, part = str(name).partition(".")
    if table in ("parameters", "inputs"):
        return Mistake(where, message, nearest(part.partition(".")[0], settable))
    is_field = bool(dot) or name == "gravity" or "[" in part + table
    if is_field and table != "solver" and (description.generationTool or "").startswith(OURS):
        help = "fields of a scene are fixed in its FMU: declare a parameter for it in the scene, "
        return Mistake(where, message, help + "or build FMUs with other values (build, variants)")
    return Mistake(where, message, nearest(name, settable))


def outputs_of(
    description: ModelDescription, names: Sequence[str] | None, mistakes: list[Mistake]
) -> list[str]:
    """Outputs that are asked for, each once, or all; any variable that is a number can be one."""
    kinds = {v.name: v.type for v in description.modelVariables}
    outputs = [v.name for v in description.modelVariables if v.causality == "output"]
    if names is None:
        return outputs
    names = [names] if isinstance(names, str) else names
    for name in names:
        where = f"output {name}"
        if name not in kinds:
            message = f"{description.modelName} has no variable {name!r}"
            mistakes.append(Mistake(where, message, nearest(name, outputs, kinds)))
        elif kinds[name] == "String":
            help = "a sweep stores only numbers"
            mistakes.append(Mistake(where, f"{name}: is a text, not a number", help))
    return list(dict.fromkeys(names))
