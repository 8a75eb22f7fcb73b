"""Values from files and the command line, brought to the units and types of what they are for."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING

from build_fmu.study.parameter_files import read_parameters
from build_fmu.study.values import (
    Entry,
    Mistake,
    is_finite,
    nearest,
    plain,
    refuse,
    shown,
    wanted_instead,
)
from solver.scene.units import base_unit

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription, ScalarVariable

    from solver.runtime import Model
    from solver.scene import Scene

Source = Mapping[str, object] | str | PathLike[str]
"""Values by name, or a file of them."""


def entries_of(source: Source | None) -> dict[str, Entry]:
    """Values by name, each with its place."""
    if source is None:
        return {}
    if isinstance(source, str | PathLike):
        return read_parameters([source])
    return {
        name: value if isinstance(value, Entry) else Entry(plain(value), f"--set {name}={value}")
        for name, value in source.items()
    }


# -------------------------------------------------------------------------------------- scenes


def scene_overrides(
    scene: str | PathLike[str] | Scene, entries: Mapping[str, Entry]
) -> dict[str, object]:
    """Overrides of a scene by name.

    What a .ssv file says of settings that are as the scene has them changes nothing: it has all of
    an FMU, also those that follow from others.
    """
    from solver.scene import Given

    if any(entry.unit or entry.repeats for entry in entries.values()):
        from build_fmu.export import compile_scene

        entries = _fitted(compile_scene(scene), entries)
    return {name: Given(entry.value, entry.where, entry.named) for name, entry in entries.items()}


def _fitted(model: Model, entries: Mapping[str, Entry]) -> dict[str, Entry]:
    """Values in the units of the scene, without those that it has already."""
    variables = {v.name: v for v in model.variables if v.causality in ("parameter", "input")}
    mistakes: list[Mistake] = []
    fitted: dict[str, Entry] = {}
    step = entries.get("solver.step_size", Entry(None, ""))
    step = converted(step, "solver.step_size", "s", mistakes)  # which refuse() says once
    for name, entry in entries.items():
        variable = variables.get(name)
        if variable is None:
            if entry.unit:
                message = f"{name}: only values of parameters and inputs can have a unit"
                mistakes.append(Mistake(entry.where, message, "leave the unit out"))
            fitted[name] = entry
            continue
        value = converted(entry, name, variable.unit, mistakes)
        follows = name == "solver.longest_step" and value == step
        if value == variable.start or follows:
            continue
        if variable.kind == "option" and isinstance(value, float) and value.is_integer():
            value = int(value)  # an FMU's numbers are Real, a scene's counts are not
        fitted[name] = Entry(value, entry.where)
    refuse(mistakes)
    return fitted


def converted(entry: Entry, name: str, unit: str, mistakes: list[Mistake]) -> object:
    """Value in `unit`; where the entry has another of another kind, a mistake."""
    value = entry.value
    same, stated = entry.unit == unit, entry.base
    if not entry.unit or (same and not stated) or not is_finite(value):
        return value
    given, wanted = stated or base_unit(entry.unit), base_unit(unit or "1")
    if same and not wanted:
        return value
    # Of equal names one may count the radian, and the other not.
    fits = given and wanted and given.fits(wanted, radians=not same)
    if not unit and given and given.factor == 1.0:
        return value  # nobody said what the parameter is measured in
    if given is None or wanted is None or not fits:
        words = f"the unit {unit!r}" if unit else "no unit"
        mistakes.append(Mistake(entry.where, f"{name}: given in {entry.unit!r}, but has {words}"))
        return value
    ratio = given.factor / wanted.factor
    if same and math.isclose(ratio, 1.0):
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
    description: ModelDescription, rows: Iterable[Mapping[str, Entry]]
) -> list[dict[str, object]]:
    """Values of parameters and inputs of an FMU, for each of several runs.

    Raises
    ------
    UsageError
        With every name that it does not have, and every value of a wrong type, unit or size.
    """
    variables = {
        v.name: v for v in description.modelVariables if v.causality in ("parameter", "input")
    }
    mistakes: list[Mistake] = []
    seen: dict[tuple[str, str, str], object] = {}  # of a grid every value comes many times
    settings = []
    for row in rows:
        values = {}
        for name, entry in row.items():
            if name not in variables:
                message = f"{description.modelName} has no parameter or input {name!r}"
                where = entry.named or entry.where
                mistakes.append(Mistake(where, message, nearest(name, variables)))
                continue
            known = (name, entry.where, repr(entry.value))
            if known not in seen:
                seen[known] = _checked(entry, variables[name], mistakes)
            values[name] = seen[known]
        settings.append(values)
    refuse(mistakes)
    return settings


def _checked(entry: Entry, variable: ScalarVariable, mistakes: list[Mistake]) -> object:
    """Value in the unit and of the type of its variable, within its limits."""
    unit = getattr(variable, "unit", None) or ""
    value = converted(entry, variable.name, unit, mistakes)
    fits, words = _KINDS.get(variable.type, _KINDS["Integer"])  # an Enumeration is one
    in_unit = f" in {unit}" if unit else ""
    if not fits(value):
        words = wanted_instead(value) if variable.type == "Real" else words
        message = f"{variable.name}: must be {words}{in_unit}, got {shown(value)}"
        mistakes.append(Mistake(entry.where, message))
    elif isinstance(value, int | float):
        for bound, relation in ((variable.min, ">="), (variable.max, "<=")):
            if bound is None or (
                value >= float(bound) if relation == ">=" else value <= float(bound)
            ):
                continue
            limit = f"{variable.name}: must be {relation} {float(bound):g}"
            unit_of_limit = f" {unit}" if unit else ""
            mistakes.append(Mistake(entry.where, f"{limit}{unit_of_limit}, got {value!r}"))
    return float(value) if variable.type == "Real" and is_finite(value) else value


def given_on_the_command_line(
    files: Sequence[str], settings: Iterable[tuple[str, object]]
) -> dict[str, Entry]:
    """Values of `--parameters` and `--set`, of which the latter count."""
    return read_parameters(files) | entries_of(dict(settings))
