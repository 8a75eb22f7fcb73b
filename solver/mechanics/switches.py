"""Names of the conditions and kinks of formulas: the part, and the condition as written."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterable, Iterator, Mapping

from solver.mechanics.formulas import rewritten
from solver.mechanics.parts import Parts
from solver.mechanics.tape import SWITCHING, Switch
from solver.scene import Expr, Scene
from solver.scene.expression import symbol
from solver.scene.scene import NOUNS

_TABLES = ("parameters", "constraints", "joints", "contacts", "forces", "drivers")


def names_of_switches(
    parts: Parts, switches: Iterable[Switch], clocks: Mapping[int, str]
) -> tuple[str, ...]:
    """Return what each switch is called in a sentence, such as ``force 'f': t < 0.6``.

    Those of `clocks` have names, by their places.
    """
    found = [(x.kink.name if x.kink else "", str(_readable(parts, x.operation))) for x in switches]
    owners = _owners(parts.scene) if found else {}
    return tuple(
        clocks.get(k) or name or named(owners.get(text, ""), text)
        for k, (name, text) in enumerate(found)
    )


def named(owner: str, text: str) -> str:
    """Return what a condition or kink is called, by the part that it belongs to and its text."""
    bare = re.sub(r"\b(\d+)\.0\b", r"\1", text[1:-1] if text.startswith("(") else text)
    return f"{owner}: {bare}" if owner else bare


def _readable(parts: Parts, operation: Expr) -> object:
    """Return an operation with the names of quantities in the place of sensors."""
    names = parts.mechanism.sensed
    return rewritten(
        operation, lambda x: symbol(names.get(str(x), str(x))) if x.op == "symbol" else None
    )


def _owners(scene: Scene) -> dict[str, str]:
    """Return the first part in which each operation stands that jumps or has a kink."""
    owners: dict[str, str] = {}
    for table in _TABLES:
        for name, part in getattr(scene, table).items():
            for operation in operations_that_switch(part):
                owners.setdefault(str(operation), f"{NOUNS[table]} '{name}'")
    return owners


def operations_that_switch(part: object) -> Iterator[Expr]:
    """Yield all operations of a part, or of an expression, that jump or have a kink."""
    pending, seen = [part], set[int]()
    while pending:
        found = pending.pop()
        if isinstance(found, Expr) and id(found) not in seen:
            seen.add(id(found))
            if found.op in SWITCHING:
                yield found
            pending += found.args
        elif dataclasses.is_dataclass(found):
            pending += [getattr(found, x.name) for x in dataclasses.fields(found)]
        elif isinstance(found, (tuple, list)):
            pending += found
        elif isinstance(found, dict):
            pending += found.values()
