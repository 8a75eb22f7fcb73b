"""Names of a scene: what a name looks like, which ones are taken, what each one stands for."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterator
from typing import Any

from solver.scene.diagnostics import Draft
from solver.scene.numbers import Known
from solver.scene.operations import FUNCTIONS, MECHANISM_FUNCTIONS
from solver.scene.quantities import SHARED_POINT, Inventory
from solver.scene.report import Path
from solver.scene.schema import TYPES
from solver.scene.words import a

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")

KINDS: dict[str, str] = {
    "parameters": "parameter", "inputs": "input", "outputs": "output", "points": "point",
    "bodies": "body", "joints": "joint", "constraints": "constraint", "forces": "force",
    "drivers": "driver",
}  # fmt: skip
"""Tables whose keys are names, and what they name; one name stands for one thing in all tables."""

RESERVED: dict[str, str] = {
    "ground": "the fixed body",
    "t": "the time",
    "time": "the time in result files",
    "pi": "the number pi",
    "energy": "the energies of the mechanism",
    "constraint": "the constraint residuals",
    "momentum": "the momentum of the mechanism",
    "angular_momentum": "the angular momentum of the mechanism",
    "solver": "the solver's settings",
    **dict.fromkeys([*FUNCTIONS.keys() - {"floor"}, *MECHANISM_FUNCTIONS], "the function"),
    **dict.fromkeys([word.lower() for word in keyword.kwlist], "the language of expressions"),
    **dict.fromkeys(keyword.kwlist, "the language of expressions"),
}
"""Names with a meaning of their own: what each is reserved for. Many scenes have a floor, which the
bracket behind the function tells apart."""


def check_name(draft: Draft, path: Path, name: str) -> None:
    """Report a name that is none, or that means something else."""
    if not NAME.fullmatch(name):
        draft.error(path, f"'{name}' is not a name: a letter, then letters, digits or _")
    elif name in RESERVED:
        draft.error(path, f"the name '{name}' is reserved for {RESERVED[name]}")


def check_names(draft: Draft) -> None:
    """Report names that cannot be used and names used twice."""
    taken: dict[str, Path] = {}
    for table in draft.data:  # in the order of the file: the second use is the mistake
        entries = draft.data[table] if table in KINDS else None
        for name in entries if isinstance(entries, dict) else ():
            path = (table, name)
            check_name(draft, path, name)
            if name in taken:
                first = taken[name]
                line = draft.source.problem(first, "").line
                where = f" in line {line}" if line else ""
                owner = KINDS[str(first[0])]
                draft.error(path, f"the name '{name}' is already that of {a(owner)}{where}")
            taken.setdefault(name, path)


def check_body_points(draft: Draft, known: Known) -> None:
    """Report points of bodies whose names cannot be used after the name of their body."""
    for body, point in _body_points(draft):
        path = ("bodies", body, "points", point)
        if not NAME.fullmatch(point):
            draft.error(path, f"'{point}' is not a name: a letter, then letters, digits or _")
        elif keyword.iskeyword(point):
            draft.error(path, f"the name '{point}' is reserved for {RESERVED[point]}")
        elif f"{body}.{point}" in known.quantities:
            draft.error(path, f"the name '{body}.{point}' is that of a quantity of the body")


def kinds_of_names(draft: Draft) -> dict[str, str]:
    """What each name stands for, "point", "body", "bar", "parameter", ...; the first use counts."""
    kinds: dict[str, str] = {}
    for table in KINDS:
        for name in _names(draft, table):
            bar = table == "bodies" and _type(draft, table, name) == "bar"
            kinds.setdefault(name, "bar" if bar else KINDS[table])
    return kinds


def inventory_of_draft(draft: Draft, dimension: int) -> Inventory:
    """List the parts of a scene that is being read; a part of unknown type may be any."""
    types = {
        table: {name: _type(draft, table, name) for name in _names(draft, table)} for table in TYPES
    }
    return Inventory(
        dimension=dimension,
        points=_names(draft, "points"),
        constraints=_names(draft, "constraints"),
        body_points=tuple(f"{body}.{point}" for body, point in _body_points(draft)),
        **types,
    )


def _names(draft: Draft, table: str) -> tuple[str, ...]:
    entries = draft.data.get(table)
    return tuple(entries) if isinstance(entries, dict) else ()


def _type(draft: Draft, table: str, name: str) -> str:
    """Type of a part as the file gives it; "" where it is unknown."""
    data = draft.data[table][name]
    kind = data.get("type") if isinstance(data, dict) else None
    if kind is None and table == "bodies":
        kind = "rigid"
    if kind in ("spherical", "revolute") and "points" in data and "bodies" not in data:
        return SHARED_POINT
    return kind if isinstance(kind, str) and kind in TYPES[table] else ""


def _body_points(draft: Draft) -> Iterator[tuple[str, str]]:
    """Name of each body and of each of its points."""
    for body in _names(draft, "bodies"):
        data: Any = draft.data["bodies"][body]
        points = data.get("points") if isinstance(data, dict) else None
        for point in points if isinstance(points, dict) else ():
            yield body, point
