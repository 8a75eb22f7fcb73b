"""Which variables of an FMU its importer sees as ports: those that `[fmu]` of the scene names."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from build_fmu.study.values import Mistake, counted, refuse
from solver.scene.words import did_you_mean

if TYPE_CHECKING:
    from solver.runtime import Model
    from solver.scene import Scene

KINDS = {
    "outputs": ("output",),
    "inputs": ("input",),
    "parameters": ("parameter", "calculatedParameter"),
}
"""Causalities of variables by the field that chooses among them."""


def local_variables(model: Model, scene: Scene) -> frozenset[int]:
    """Indices of the variables that are no ports: importers may read them, and do not list them.

    Raises
    ------
    UsageError
        If a pattern matches no variable.
    """
    found: set[int] = set()
    mistakes: list[Mistake] = []
    for field, causalities in KINDS.items():
        patterns: Sequence[str] | None = getattr(scene.fmu, field)
        if patterns is None:
            continue
        known = {v.name: i for i, v in enumerate(model.variables) if v.causality in causalities}
        for pattern in patterns:
            if not any(fnmatchcase(name, pattern) for name in known):
                message = f"{pattern!r} matches none of the {len(known)} {field} of {model.name}"
                help = did_you_mean(pattern, known, f"{field} are") or ""
                mistakes.append(Mistake(f"fmu.{field}", message, help))
        found |= {i for name, i in known.items() if not any(fnmatchcase(name, p) for p in patterns)}
    refuse(mistakes)
    return frozenset(found)


def summary(model: Model, local: Collection[int]) -> str:
    """Say how many ports there are."""
    seen = [v.causality for i, v in enumerate(model.variables) if i not in local]
    counts: Mapping[str, int] = {
        field: sum(map(seen.count, causalities)) for field, causalities in KINDS.items()
    }
    ports = ", ".join(counted(count, field.removesuffix("s")) for field, count in counts.items())
    return f"{ports}; [fmu] of the scene chooses among them" if not local else ports
