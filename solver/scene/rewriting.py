"""Puts numbers into the text of a scene, in place: comments, order and all else stay."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from solver.scene.positions import Path, spans_of
from solver.scene.units import literal

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

Written: TypeAlias = "float | str | Sequence[Written] | Mapping[str, Written]"
"""A number, true or false, a formula, a list, or a table, ``{"quaternion": [1, 0, 0, 0]}``."""


class AsIs(str):
    """A text that is written as it is, without quotes."""


class UnwrittenError(Exception):
    """A value stands in the text in a form that is not replaced; `path` is its place."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.path = path


def rewritten(text: str, notation: str, values: Mapping[Path, Written]) -> str:
    """Return the text with these values; one that it lacks comes behind another of its part.

    Behind the position, if the part has one, else behind the last field in the text.

    Raises
    ------
    UnwrittenError
        For the path of a value that the text has in several lines of its own, as a table, or that
        is of a part without fields.
    """
    spans = spans_of(text, notation)
    changes: list[tuple[int, int, str]] = []
    for path, value in values.items():
        shown = _shown(value, notation)
        if path in spans:
            changes.append((spans[path].begin, spans[path].end, shown))
            continue
        if any(known[: len(path)] == path for known in spans):
            raise UnwrittenError(path)
        beside = [known for known in spans if known[:-1] == path[:-1]]
        if not beside and len(path) == 2 and notation == "toml":
            changes.append((len(text), len(text), f"\n[{path[0]}]\n{path[1]} = {shown}\n"))
            continue
        if not beside:
            raise UnwrittenError(path)
        last = max(beside, key=lambda known: (known[-1] == "position", spans[known].begin))
        place = spans[last]
        before, _, after = place.key.rpartition(str(last[-1]))
        name = f"{before}{path[-1]}{after}"
        separator, equals = (", ", ": " if notation == "json" else " = ")
        if not place.in_brackets:
            separator = "\n"
            end = text.find("\n", place.end)
            end = len(text) if end < 0 else end
        else:
            end = place.end
        changes.append((end, end, f"{separator}{name}{equals}{shown}"))
    for begin, end, shown in sorted(changes, key=lambda change: change[:2], reverse=True):
        text = text[:begin] + shown + text[end:]
    return text


def value_of(written: str, notation: str) -> Any:
    """Value that stands in a text so."""
    return json.loads(written) if notation == "json" else tomllib.loads(f"x = {written}")["x"]


def less(given: float | str, number: float) -> float | str:
    """Return a number, with a unit or without, or a formula less a number."""
    found = literal(given) if isinstance(given, str) else None
    given = found.value if found else given
    if not isinstance(given, str):
        return float(given) - number
    return f"({given}) {'+' if number < 0.0 else '-'} {abs(number)!r}"


def _shown(value: Written, notation: str) -> str:
    if isinstance(value, AsIs):
        return value
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, bool):
        return json.dumps(value)
    if isinstance(value, Mapping):
        name, equals = ('"{}"', ": ") if notation == "json" else ("{}", " = ")
        entries = [f"{name.format(n)}{equals}{_shown(x, notation)}" for n, x in value.items()]
        return f"{{ {', '.join(entries)} }}"
    if isinstance(value, Sequence):
        return f"[{', '.join(_shown(x, notation) for x in value)}]"
    return repr(value + 0.0 if isinstance(value, float) else value)  # no negative zero
