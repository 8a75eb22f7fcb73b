"""Values of parameters as they are written, with the place where they were, and their mistakes."""

from __future__ import annotations

import difflib
import json
import math
import re
import reprlib
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeGuard

from build_fmu.errors import UsageError

if TYPE_CHECKING:
    from solver.scene.units import BaseUnit

MOST_MISTAKES = 30
"""Mistakes that are shown; of the rest only their number."""
_LONG_NAMES = ("parameters.{}", "inputs.{}", "parameters.{}.value", "inputs.{}.start")
"""How a parameter or input may be named besides its name."""
_LONG_NAME = re.compile("|".join(x.replace(".", r"\.").format(r"(\w+)") for x in _LONG_NAMES))


class _Short(reprlib.Repr):
    def repr_int(self, x: int, level: int) -> str:  # noqa: ARG002
        from solver.scene.fields import shown as as_in_scenes

        return as_in_scenes(x)


_SHORT = _Short()
_SHORT.maxstring = _SHORT.maxother = 80


@dataclass(frozen=True)
class Entry:
    """A value, where it was given ("masses.csv:3"), and in which unit if that was said."""

    value: object
    where: str
    unit: str = ""
    named: str = ""
    """Where its name was given, if that is elsewhere: in the header of a table."""
    base: BaseUnit | None = None
    """What the file says of its unit."""
    repeats: bool = False
    """Whether it comes from a list of all parameters, most of which are as they were."""
    wrong: Mistake | None = None
    """Instead of a value: what is wrong in its file, to be told with the mistakes of the others."""


@dataclass(frozen=True)
class Mistake:
    """What is wrong, where, and what to write instead."""

    where: str
    message: str
    help: str = ""

    def __str__(self) -> str:
        return f"{self.where}: error: {self.message}" + (
            f"\n  = help: {self.help}" * bool(self.help)
        )


class WrongValueError(ValueError):
    """A value is wrong: its name, what is wrong, perhaps a remedy; the caller knows its place."""

    def at(self, where: str) -> Mistake:
        """The mistake, in its place."""
        name, words, *help = self.args
        return Mistake(where, f"{name}: {words}", *help)


def refuse(mistakes: Iterable[Mistake | str]) -> None:
    """Raise UsageError with all mistakes, each once, if there are any."""
    if text := in_one_text(mistakes):
        raise UsageError(text)


def in_one_text(mistakes: Iterable[Mistake | str]) -> str:
    """All mistakes, each once, or the first of them and the number of the rest."""
    texts = list(dict.fromkeys(str(mistake) for mistake in mistakes))
    left = len(texts) - MOST_MISTAKES
    more = [f"... and {left} more mistakes"] if left > 0 else []
    return "\n".join([*texts[:MOST_MISTAKES], *more])


def read_value(text: str) -> object:
    """Number, true or false, list, else the text as it stands.

    Raises
    ------
    ValueError
        If a list is not one of JSON, or a number is written as only Python and TOML know it.
    """
    text = text.strip()
    if text in ("true", "false"):
        return text == "true"
    for read in (int, float):
        try:
            number = read(text)
        except ValueError:
            continue
        if "_" in text:
            message = "a number has no '_'"
            raise ValueError(message)
        return number
    if not text.startswith(("[", "{")):
        return text
    try:
        return json.loads(text, parse_int=read_value)
    except RecursionError:
        message = "nested too deeply"
        raise ValueError(message) from None


def not_finite(value: object) -> float | None:
    """First number of a value or list that is infinite or none; None if all are finite."""
    if isinstance(value, list):
        return next((x for x in map(not_finite, value) if x is not None), None)
    return value if isinstance(value, float) and not math.isfinite(value) else None


def keep(found: dict[str, Entry], name: str, entry: Entry, mistakes: list[Mistake]) -> None:
    """Take a value of a file, unless it was there; `parameters.mass` is `mass`."""
    short = _LONG_NAME.fullmatch(name)
    known = short[short.lastindex or 0] if short else name
    for other in (known, *(each.format(known) for each in _LONG_NAMES)):
        if other in found:
            first = "first" if other == name else f"first as {other}"
            message = f"{name}: given twice, {first} at {found[other].where}"
            mistakes.append(Mistake(entry.where, message))
            return
    found[name] = entry


def plain(value: object) -> object:
    """Value as Python's own type: NumPy's numbers and arrays as numbers and lists."""
    return getattr(value, "tolist", lambda: value)()


def shown(value: object) -> str:
    """Value in one line of a message, cut where it is long."""
    return _SHORT.repr(plain(value))


def is_number(value: object) -> TypeGuard[float]:
    """Whether it is a number, which true and false are not."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def is_finite(value: object) -> TypeGuard[float]:
    """Whether it is a number that a double can hold."""
    return is_number(value) and abs(value) <= sys.float_info.max


def wanted_instead(value: object) -> str:
    """What a value that is not a finite number should be."""
    return "a finite number" if is_number(value) else "a number"


def nearest(wrong: object, known: Iterable[str], others: Iterable[str] = ()) -> str:
    """Suggest the name that was perhaps meant, last among others, or say which are known."""
    names = list(known)
    near = [x for each in (names, others) for x in difflib.get_close_matches(str(wrong), each, 1)]
    if near:
        return f"did you mean {near[0]!r}?"
    from solver.scene.words import listed  # --help needs nothing of the solver

    return f"known: {listed(names)}" if names else ""


def counted(count: int, word: str) -> str:
    """Number of things in words: 1 run, 2 runs."""
    return f"{count} {word}" if count == 1 else f"{count} {word}s"
