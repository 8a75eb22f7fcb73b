"""Puts numbers into the text of a scene, in place: comments, order and all else stay."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from typing import TypeAlias

from solver.scene.positions import Path, spans_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

Written: TypeAlias = (
    float | str | Sequence[float] | Sequence[list[float]] | Mapping[str, Sequence[float]]
)
"""A number, a formula, a vector, some of them, or a table, ``{"quaternion": [1, 0, 0, 0]}``."""


class UnwrittenError(Exception):
    """A value stands in the text in a form that is not replaced; `path` is its place."""

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.path = path


def rewritten(text: str, notation: str, values: Mapping[Path, Written]) -> str:
    """Return the text with these values; one that it lacks comes behind the position of its part.

    Raises
    ------
    UnwrittenError
        For the path of a value that the text has in several lines of its own, as a table.
    """
    spans = spans_of(text, notation)
    changes: list[tuple[int, int, str]] = []
    for path, value in values.items():
        shown = _shown(value, notation)
        if path in spans:
            changes.append((spans[path].begin, spans[path].end, shown))
            continue
        place = spans.get((*path[:-1], "position"))
        if place is None or any(known[: len(path)] == path for known in spans):
            raise UnwrittenError(path)
        before, _, after = place.key.rpartition("position")
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


def less(written: str, notation: str, number: float) -> Written:
    """Return what stands in a text, a number or a formula, less a number."""
    given = json.loads(written) if notation == "json" else tomllib.loads(f"x = {written}")["x"]
    if not isinstance(given, str):
        return float(given) - number
    return f"({given}) {'+' if number < 0.0 else '-'} {abs(number)!r}"


def _shown(value: Written, notation: str) -> str:
    if isinstance(value, Mapping):
        ((name, vector),) = value.items()
        if notation == "json":
            return f'{{ "{name}": {_shown(vector, notation)} }}'
        return f"{{ {name} = {_shown(vector, notation)} }}"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Sequence):
        return f"[{', '.join(_shown(x, notation) for x in value)}]"
    return repr(float(value) + 0.0)  # no negative zero
