"""Scene files: from text (TOML or JSON) and overrides to a checked ``Scene``."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Mapping
from pathlib import Path as FilePath
from typing import Any, NoReturn

from solver.scene.build import build
from solver.scene.collector import collector_paused
from solver.scene.draft import Draft
from solver.scene.fields import shown
from solver.scene.overrides import apply_overrides
from solver.scene.positions import lines_of_json
from solver.scene.report import Problem, SceneError, Source, location_of
from solver.scene.vocabulary import Scene

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


_TOML_HELP = {
    "Illegal character '\\n'": "a text ends on the line it begins on: close its quotes",
    "Cannot overwrite a value": "the same key is given twice",
}


def read_file(path: str, overrides: Mapping[str, object]) -> Scene:
    """Read a scene file; see ``solver.scene.load``."""
    notation = FilePath(path).suffix.lower().removeprefix(".")
    if notation not in ("toml", "json"):
        message = f"unknown kind of file '{FilePath(path).suffix}'"
        _give_up(Source(path), Problem("", message, "known: .toml, .json"))
    try:
        data = FilePath(path).read_bytes()
    except FileNotFoundError:
        _give_up(Source(path), Problem("", "file not found"))
    except OSError as error:
        _give_up(Source(path), Problem("", f"cannot be read: {error.strerror}"))
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        message = f"not a UTF-8 text: byte 0x{data[error.start]:02x}"
        source = Source(path, data.decode("utf-8", errors="replace"))
        _give_up(source, Problem("", message, "save the file as UTF-8", line))
    return read_text(text, path, notation, overrides)


@collector_paused()
def read_text(text: str, name: str, notation: str, overrides: Mapping[str, object]) -> Scene:
    """Read the text of a scene; see ``solver.scene.loads``."""
    problems: list[Problem] = []
    text = text.replace("\r\n", "\n")
    data = _json(text, name, problems) if notation == "json" else _toml(text, name)
    _shallow(data, Source(name, text))
    source = Source(name, text, notation, *apply_overrides(data, overrides, problems))
    draft = Draft(data, source, problems)
    scene = build(draft)
    if problems:
        raise SceneError(problems, source)
    return scene


def _give_up(source: Source, problem: Problem) -> NoReturn:
    raise SceneError([problem], source)


def _toml(text: str, name: str) -> dict[str, Any]:
    try:
        return tomllib.loads(text)
    except RecursionError:
        _give_up(Source(name, text), Problem("", "TOML: nested too deeply"))
    except tomllib.TOMLDecodeError as error:
        words = str(error)
        place = re.search(r" \(at (?:line (\d+), column (\d+)|end of document)\)", words)
        message = words[: place.start()] if place else words
        line = int(place[1]) if place and place[1] else len(text.rstrip().split("\n"))
        column = int(place[2]) if place and place[2] else None
        help = _TOML_HELP.get(message)
        _give_up(Source(name, text), Problem("", f"TOML: {message}", help, line, column))


def _json(text: str, name: str, problems: list[Problem]) -> dict[str, Any]:
    twice: list[str] = []

    def table(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        entries = dict(pairs)
        if len(entries) < len(pairs):
            twice.extend(key for key, _ in pairs)
        return entries

    try:
        data = json.loads(text, object_pairs_hook=table)
    except RecursionError:
        _give_up(Source(name, text), Problem("", "JSON: nested too deeply"))
    except json.JSONDecodeError as error:
        problem = Problem("", f"JSON: {error.msg}", None, error.lineno, error.colno)
        _give_up(Source(name, text), problem)
    if not isinstance(data, dict):
        _give_up(Source(name, text), Problem("", f"must be a table of fields, got {shown(data)}"))
    if twice:
        repeated = lines_of_json(text)[1]
        problems += [
            Problem(location_of(path), "given twice", line=line) for path, line in repeated
        ]
    return data


def _shallow(data: Any, source: Source, deepest: int = 50) -> None:
    """Give up on nesting that no scene has, before anything descends into it."""
    level = [data]
    for _ in range(deepest):
        inside = [value.values() if isinstance(value, dict) else value for value in level]
        level = [item for items in inside for item in items if isinstance(item, (dict, list))]
        if not level:
            return
    _give_up(source, Problem("", "nested too deeply"))
