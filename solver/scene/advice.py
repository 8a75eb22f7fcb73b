"""What is legal in a scene and seldom meant: each is a warning with its remedy."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

from solver.options import DEFAULTS, OPTIONS, tolerance_of
from solver.scene.body_sizes import TINY, places_of_bodies, squared_sizes
from solver.scene.draft import Draft
from solver.scene.expression import Number, curves_of, evaluate
from solver.scene.fields import Part
from solver.scene.joints import BodyJoint, Fixed
from solver.scene.mistakes import Path, location_of
from solver.scene.numbers import NumberChecks
from solver.scene.parallel_axes import Groups
from solver.scene.parameters import Input
from solver.scene.profiles import Profile
from solver.scene.units import literal

LARGE = 100.0
"""Length in m from which it may be one in mm, and ratio of one to the next smaller of the scene."""
SMALL = 5.0
"""Length in mm below which few numbers of a drawing in mm are."""
COMPOSED = (2.0, 4.0, 6.0)
"""Orders of which no step is explicit."""


def advise(
    numbers: NumberChecks,
    profiles: Mapping[str, Profile],
    parts: Mapping[str, Mapping[str, Any]],
    settings: Mapping[str, Any],
) -> None:
    """Warn of a scene as a whole, in which no mistake was found.

    `parts` are by table and name, `settings` those of the solver.
    """
    _unused(numbers)
    _unused_expressions(numbers.draft)
    _settings_of_contacts(numbers)
    _settings_of_tolerance(numbers, settings)
    _held(numbers, parts["inputs"])
    _with_corners(numbers.draft, profiles, parts)
    _welded_twice(numbers.draft, parts["joints"])
    _millimetres(numbers.draft)
    _tiny_inertias(numbers, parts)


def _unused(numbers: NumberChecks) -> None:
    """Warn of parameters and inputs that change nothing; a calculated one is a result."""
    known, data = numbers.known, numbers.draft.data
    for name in known.of("parameter", "input"):
        table = f"{known.parts[name]}s"
        given = data[table][name]
        value = given.get("value") if isinstance(given, dict) else given
        is_formula = isinstance(value, str) and not literal(value)
        if name not in known.uses and not is_formula:
            help = "use it in an expression, or leave it out"
            numbers.draft.warn((table, name), "nothing depends on it", help)


def _unused_expressions(draft: Draft) -> None:
    """Warn of named expressions that stand nowhere."""
    for name in draft.expressions:
        if name not in draft.expressions.used:
            help = "use it in an expression, or leave it out"
            draft.warn(("expressions", name), "nothing mentions it", help)


def _settings_of_contacts(numbers: NumberChecks) -> None:
    """Warn of settings that only contacts and friction of joints have."""
    for name in numbers.draft.table("solver"):
        if not numbers.known.touches and OPTIONS[name].of_contacts:
            message = "has no effect: nothing touches or rubs"
            numbers.draft.warn(("solver", name), message, "leave it out, or write [contacts]")


def _settings_of_tolerance(numbers: NumberChecks, settings: Mapping[str, Any]) -> None:
    """Warn of settings of chosen steps where steps are equal, or of an order that none takes so."""
    if tolerance_of(settings):
        if settings["method"] == "fastest" and settings["order"] in COMPOSED:
            message = f"has no effect: no step of order {settings['order']:g} is explicit"
            numbers.draft.warn(
                ("solver", "method"), message, "leave it out, or leave out the order"
            )
        return
    for name in numbers.draft.table("solver"):
        in_use = name == "longest_step" and numbers.known.touches  # where impacts are not located
        if OPTIONS[name].of_tolerance and settings[name] != DEFAULTS[name] and not in_use:
            message = "has no effect on steps of fixed length, which this scene has"
            help = "leave it out, or write a tolerance in place of step_size and order"
            numbers.draft.warn(("solver", name), message, help)


def _held(numbers: NumberChecks, inputs: Mapping[str, Input]) -> None:
    """Warn of inputs and tunable parameters that move something by jumps."""
    for name, given in inputs.items():
        moved = [path for path in numbers.known.uses.get(name, []) if _prescribes(path)]
        if moved and given.interpolation == "hold":
            message = f"is held in each communication step, so that {location_of(moved[0])} jumps"
            help = 'write interpolation = "smooth", or "ramp" for a signal that goes in steps'
            numbers.draft.warn(("inputs", name), message, help)
    for name, origin in numbers.known.tunable.items():
        moved = [path for path in numbers.known.uses.get(name, []) if _prescribes(path)]
        if moved:
            message = f"may change during a run, and {location_of(moved[0])} would jump then"
            help = f"make '{origin}' a fixed parameter, or an input with interpolation = \"smooth\""
            numbers.draft.warn(("parameters", name), message, help)


def _prescribes(path: Path) -> bool:
    """Whether the expression at a place says where something is."""
    return path[0] == "drivers" or (path[0] == "constraints" and path[2] == "value")


def _with_corners(
    draft: Draft, profiles: Mapping[str, Profile], parts: Mapping[str, Mapping[str, Any]]
) -> None:
    """Warn of constraints along straight lines, whose rate jumps where these meet."""
    for name, part in parts["constraints"].items():
        for curve in sorted(curves_of(getattr(part, "value", None))):
            if curve in profiles and profiles[curve].has_corners:
                message = f"moves along the straight lines of '{curve}', whose rate jumps "
                message += "where they meet; velocities do not follow a jump"
                help = f"write {profiles[curve].without_corners} in profiles.{curve}"
                draft.warn(("constraints", name, "value"), message, help)


def _welded_twice(draft: Draft, joints: Mapping[str, Part]) -> None:
    """Warn of joints between bodies that fixed joints hold together already."""
    welded = Groups()
    of_bodies = ((n, j) for n, j in joints.items() if isinstance(j, BodyJoint))
    for name, joint in sorted(of_bodies, key=lambda item: not isinstance(item[1], Fixed)):
        bodies = joint.bodies or ("", None)
        if welded.are_one(*bodies):
            message = "fixed joints hold these bodies together already, so that it is redundant"
            help = "leave it out: the reactions of redundant joints are not unique"
            draft.warn(("joints", name), message, help)
        elif isinstance(joint, Fixed):
            welded.join(*bodies)


def _millimetres(draft: Draft) -> None:
    """Warn of the largest length where all of them, or those far above the others, may be in mm."""
    if any(part.get("type") == "gravitation" for part in draft.table("forces").values()):
        return  # planets
    found = sorted((abs(value), path) for path, value in _lengths(draft) if value)
    sizes = [size for size, _ in found]
    gap = any(y >= LARGE * max(x, 1.0) for x, y in pairwise(sizes))
    if sizes and sizes[-1] >= LARGE and (gap or sizes[0] >= SMALL):
        help = f"{sizes[-1]:g} mm are {sizes[-1] / 1000.0:g} m; if metres are meant, say so by a "
        message = f"is {sizes[-1]:g} m: all lengths of a scene are in metres"
        draft.warn(found[-1][1], message, f'{help}parameter with unit = "m"')


def _tiny_inertias(numbers: NumberChecks, parts: Mapping[str, Mapping[str, Any]]) -> None:
    """Warn of bodies whose inertia is not 0 and counts as 0."""

    def default(number: Number) -> float:
        return evaluate(number, numbers.known.values)

    for name, size2 in squared_sizes(parts, places_of_bodies(parts), default).items():
        body = parts["bodies"][name]
        rows = body.inertia if isinstance(body.inertia, tuple) else ((body.inertia,),)
        moment, mass = max(default(row[i]) for i, row in enumerate(rows)), default(body.mass)
        if 0.0 < moment < TINY * mass * default(size2):
            field = "inertia" if body.shape is None else "shape"
            message = (
                f"inertia of {moment:.6g} kg.m2 counts as 0: it is below {TINY:g} of the mass "
                f"{mass:.6g} kg times the squared size {math.sqrt(default(size2)):.6g} m"
            )
            help = "write 0, or the inertia of the body in kg.m2"
            numbers.draft.warn(("bodies", name, field), message, help)


def _lengths(draft: Draft) -> Iterator[tuple[Path, float]]:
    """Plain numbers of positions and sizes, each with its place."""
    for table in ("points", "bodies"):
        for name, part in draft.table(table).items():
            for field in ("position", "points", "shape"):
                yield from _numbers((table, name, field), part.get(field))


def _numbers(path: Path, value: Any) -> Iterator[tuple[Path, float]]:
    if isinstance(value, dict | list):
        for step, item in value.items() if isinstance(value, dict) else enumerate(value):
            yield from _numbers((*path, step), item)
    elif isinstance(value, int | float) and path[-1] != "density":
        yield path, float(value)
