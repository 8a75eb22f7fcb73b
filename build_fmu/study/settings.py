"""Values from files and the command line, brought to the units and types of what they are for."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING

from build_fmu.study.names import OURS, SETTABLE, not_settable
from build_fmu.study.parameter_files import entries_of_files
from build_fmu.study.values import (
    Entry,
    Mistake,
    is_finite,
    plain,
    refuse,
    shown,
    wanted_instead,
)
from build_fmu.version import VERSION
from solver.scene.units import base_unit

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription, ScalarVariable

    from solver.runtime import Model
    from solver.scene import Scene
    from solver.scene.units import BaseUnit

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
    told_before = len(mistakes)
    entries = {name: entry for name, entry in entries.items() if not entry.wrong}
    if any(entry.unit or entry.repeats for entry in entries.values()):
        from build_fmu.export import compile_scene

        entries = _fitted(compile_scene(scene), entries, mistakes)
    found: dict[str, object] = {
        name: Given(entry.value, entry.where, entry.named) for name, entry in entries.items()
    }
    if told_before:
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
    variables = {v.name: v for v in model.variables if v.causality in ("parameter", "input")}
    fitted: dict[str, Entry] = {}
    for name, entry in entries.items():
        variable = variables.get(name)
        if variable is None:
            if entry.unit:
                message = f"{name}: only values of parameters and inputs can have a unit"
                mistakes.append(Mistake(entry.where, message, "leave the unit out"))
            fitted[name] = entry
            continue
        before = len(mistakes)
        value = converted(entry, name, variable.unit, mistakes)
        if value == variable.start or len(mistakes) > before:
            continue
        if variable.kind == "option" and isinstance(value, float) and value.is_integer():
            value = int(value)  # an FMU's numbers are Real, a scene's counts are not
        fitted[name] = Entry(value, entry.where)
    return fitted


def converted(entry: Entry, name: str, unit: str, mistakes: list) -> object:
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
    if not unit and given and given.factor == 1.0 and not name.startswith("solver."):
        return value  # nobody said what the parameter is measured in
    if given is None or wanted is None or not fits:
        words = f"the unit {unit!r}" if unit else "no unit"
        message = f"{name}: given in {entry.unit!r}, but has {words}"
        mistakes.append(Mistake(entry.where, message, _unit_help(entry.unit, given, unit)))
        return value
    ratio = given.factor / wanted.factor
    if same and math.isclose(ratio, 1.0):
        return value  # 0.0174533 and all digits of it are one degree
    return float(value) * given.factor / wanted.factor


def _unit_help(given: str, base: BaseUnit | None, wanted: str) -> str:
    if not wanted:
        return "leave the unit out"
    unknown = f"{given!r} is not known, and the file does not define it"
    reason = f"{given!r} measures something else" if base else unknown
    return f"{reason}; give the value in {wanted}"


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
                mistakes.append(not_settable(entry.named or entry.where, name, description))
                continue
            known = (name, entry.where, repr(entry.value))
            if known not in seen:
                found: list[Mistake] = []
                value = _checked(entry, variables[name], found)
                seen[known] = value
                mistakes += found or _refused(entry, name, value, description)
            values[name] = seen[known]
        settings.append(values)
    refuse(mistakes if told is None else [])
    return settings


def _checked(entry: Entry, variable: ScalarVariable, mistakes: list[Mistake]) -> object:
    """Value in the unit and of the type of its variable, within its limits."""
    unit = getattr(variable, "unit", None) or ""
    value = converted(entry, variable.name, unit, mistakes)
    if mistakes:
        return value  # nobody knows whether it is within the limits
    fits, words = _KINDS.get(variable.type, _KINDS["Integer"])  # an Enumeration is one
    in_unit = f" in {unit}" if unit else ""
    if not fits(value):
        words = wanted_instead(value) if variable.type == "Real" else words
        message = f"{variable.name}: must be {words}{in_unit}, got {shown(value)}"
        with_unit = isinstance(value, str) and re.fullmatch(r"[-+]?[\d.]+ ?[^\W\d].*", value)
        help = "a unit is not written here" if with_unit and variable.type != "Boolean" else ""
        mistakes.append(Mistake(entry.where, message, help))
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


def _refused(
    entry: Entry, name: str, value: object, description: ModelDescription
) -> list[Mistake]:
    """What an FMU of this version would say of a setting of its solver in the run."""
    setting = name.removeprefix("solver.")
    if setting == name or description.generationTool != f"{OURS}{VERSION}":
        return []
    from solver.runtime import OptionError
    from solver.runtime.options import encode

    try:
        encode(setting, value)
    except OptionError as error:
        return [Mistake(entry.where, str(error))]
    return []
