"""Mistakes and doubts in a scene, reported like a compiler's: file, line, what to write.

scene.toml:13: error: points.B.mas: unknown field
13 | mas = 2.0
= help: did you mean 'mass'?
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Literal

from solver.scene.positions import Path, lines_of, written

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_STEP = re.compile(r'"([^"]*)"|\[(\d+)\]|([^.\[\]"]+)')
_WIDEST = 120


@dataclass(frozen=True, slots=True)
class Given:
    """The value of an override that has a place of its own, "masses.csv:3"."""

    value: object
    where: str
    named: str = ""
    """Where its name was given, if that is elsewhere."""


@dataclass(frozen=True, slots=True)
class Problem:
    """One mistake, or a warning of what is legal and seldom meant."""

    location: str
    """Place in the scene, ``points.B.position[0]``; empty for the file as a whole."""
    message: str
    help: str | None = None
    line: int | None = None
    """Line of the file, from 1; None when the mistake is in no line of it."""
    column: int | None = None
    """Column in that line, from 1, where it is known."""
    override: str | None = None
    """The override that brought the mistake in, ``--set points.B.mass=-1``; None for the file."""
    severity: Literal["error", "warning"] = "error"


def location_of(path: Path) -> str:
    """Write a path the way a user reads it, ``points.B.position[0]``."""
    text = ""
    for step in path:
        if isinstance(step, int):
            text += f"[{step}]"
        else:
            text += f".{step}" if _BARE.fullmatch(step) else f'."{step}"'
    return text.removeprefix(".")


def path_of(location: str) -> Path:
    """Read a location back into a path."""
    found = _STEP.findall(location)
    return tuple(int(index) if index else quoted or bare for quoted, index, bare in found)


@dataclass(frozen=True, slots=True)
class Source:
    """The text a scene was read from, and where in it everything stands."""

    name: str = "scene"
    text: str = ""
    notation: str = ""
    """"toml" or "json"; empty where no line can be named."""
    line_end: str = "\n"
    """Of the lines of the file; the text here has line feeds alone."""
    overrides: Mapping[Path, str] = field(default_factory=dict)
    """Text of the override that replaced a value, ``name=value``, by the path of the value."""
    places: Mapping[Path, str] = field(default_factory=dict)
    """Where each of these was given."""

    def problem(
        self,
        place: str | Path,
        message: str,
        help: str | None = None,
        mark: tuple[str, int] = ("", 1),
    ) -> Problem:
        """Describe a mistake.

        Parameters
        ----------
        place : str or tuple
            Location or path of the mistake; the nearest enclosing thing with a line is shown.
        message : str
            What is wrong: value, unit and rule.
        help : str, optional
            What to write instead.
        mark : tuple of str and int
            A text in the line and a column in that text, to be pointed at.
        """
        path = path_of(place) if isinstance(place, str) else place
        location = place if isinstance(place, str) else location_of(place)
        lines = lines_of(self.text, self.notation)
        for end in range(len(path), -1, -1):
            if path[:end] in self.places:
                return Problem(location, message, help, override=self.places[path[:end]])
            if path[:end] in lines:
                line = lines[path[:end]]
                return Problem(location, message, help, line, self._column(line, *mark))
        return Problem(location, message, help)

    def written(self, path: Path, number: float) -> str:
        """Text of a number as it stands in the file, or as Python writes that of an override."""
        if any(path[:end] in self.places for end in range(len(path) + 1)):
            return repr(number)
        return written(self.text, self.notation).get(path, repr(number))

    def report(self, problem: Problem) -> str:
        """Text of a problem as it is reported, with its line and help."""
        where = problem.override or (f"{self.name}:{problem.line}" if problem.line else self.name)
        subject = f"{problem.location}: " if problem.location else ""
        lines = [f"{where}: {problem.severity}: {subject}{problem.message}"]
        gutter = " " * (4 + len(str(problem.line or "")))
        if problem.line:
            text = self.line(problem.line).replace("\t", " ").rstrip()
            shown = text if len(text) <= _WIDEST else text[: _WIDEST - 4] + " ..."
            lines.append(f"    {problem.line} | {shown}")
            if problem.column is not None and problem.column <= len(shown) + 1:
                lines.append(f"{gutter} | {' ' * (problem.column - 1)}^")
        if problem.help:
            lines.append(f"{gutter} = help: {problem.help}")
        return "\n".join(lines).encode("utf-8", "backslashreplace").decode()

    def line(self, number: int) -> str:
        """Text of a line, from 1."""
        lines = _split(self.text)
        return lines[number - 1].rstrip() if number <= len(lines) else ""

    def _column(self, number: int, text: str, column: int) -> int | None:
        line = self.line(number)
        return line.index(text) + column if text and line.count(text) == 1 else None


@lru_cache(maxsize=4)
def _split(text: str) -> list[str]:
    return text.split("\n")


class SceneWarning(UserWarning):
    """A scene that can be built and is seldom meant so."""


def in_order(problems: Iterable[Problem]) -> tuple[Problem, ...]:
    """Each problem once, in the order of the file."""
    unique = dict.fromkeys(problems)
    return tuple(sorted(unique, key=lambda p: (p.line is None, p.line or 0, p.column or 0)))


class SceneError(Exception):
    """A scene with mistakes: all of them.

    Attributes
    ----------
    problems : tuple of Problem
        The mistakes, in the order of the file.
    source : Source
        The text they are in.
    """

    def __init__(self, problems: Iterable[Problem], source: Source) -> None:
        self.problems = in_order(problems)
        self.source = source
        super().__init__(self.problems, source)

    def __str__(self) -> str:
        return "\n".join(self.sentences())

    def sentences(self) -> list[str]:
        """Each mistake as it is reported, with its line and help."""
        return [self.source.report(problem) for problem in self.problems]
