"""Names of a scene: what a name looks like, which ones are taken, what an expression may mention.

The quantities of a mechanism are the variables of its FMU: ``A.x`` of a point, ``buffer.force`` of
a spring, ``energy.total`` of the whole.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Iterator
from typing import Any

from solver.scene.draft import Draft
from solver.scene.operations import FUNCTIONS, MECHANISM_FUNCTIONS
from solver.scene.report import Path

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")

KINDS: dict[str, str] = {
    "parameters": "parameter", "inputs": "input", "outputs": "output", "points": "point",
    "bodies": "bar", "joints": "joint", "forces": "force", "drivers": "driver",
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
    **dict.fromkeys([*FUNCTIONS, *MECHANISM_FUNCTIONS], "the function"),
    **dict.fromkeys([word.lower() for word in keyword.kwlist], "the language of expressions"),
    **dict.fromkeys(keyword.kwlist, "the language of expressions"),
}
"""Names with a meaning of their own: what each is reserved for."""

_ENERGIES = ("kinetic", "potential", "total", "work", "dissipated", "balance", "error")
_COUNTS = ("newton_iterations", "uzawa_iterations", "substeps", "status")


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
                article = "an" if owner[0] in "aeiou" else "a"
                draft.error(path, f"the name '{name}' is already that of {article} {owner}{where}")
            taken.setdefault(name, path)


def kinds_of_names(draft: Draft) -> dict[str, str]:
    """What each name stands for, "point", "bar", "parameter", ...; the first use counts."""
    kinds: dict[str, str] = {}
    for table, entries in draft.data.items():
        if table in KINDS and isinstance(entries, dict):
            for name in entries:
                kinds.setdefault(name, KINDS[table])
    return kinds


def quantities(
    dimension: int, points: Iterable[str], bodies: Iterable[str], joints: Iterable[str],
    forces: dict[str, Any],
) -> Iterator[str]:  # fmt: skip
    """Names of the mechanism's own quantities, which an output may use.

    `forces` gives the type of each force under its name.
    """
    axes = "xyz"[:dimension]
    for name in points:
        yield from (f"{name}.{prefix}{axis}" for prefix in ("", "v") for axis in axes)
    if dimension == 2:
        for name in bodies:
            yield from (f"{name}.angle", f"{name}.angular_velocity")
    yield from (f"{name}.force" for name in joints)
    for name, kind in forces.items():
        if kind in ("spring", "damper"):
            yield from (f"{name}.length", f"{name}.force")
    yield from (f"energy.{word}" for word in _ENERGIES)
    yield from ("constraint.position", "constraint.velocity")
    yield from (f"momentum.{axis}" for axis in axes)
    yield from (f"angular_momentum.{axis}" for axis in ("z" if dimension == 2 else "xyz"))
    yield from (f"solver.{word}" for word in _COUNTS)
