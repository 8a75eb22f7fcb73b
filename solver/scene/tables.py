"""From the text of a file to its tables, in TOML or JSON, with the mistakes in the notation."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path as FilePath
from typing import Any, NoReturn

from solver.files import read_whole
from solver.scene.fields import shown
from solver.scene.grammar import is_readable
from solver.scene.mistakes import Problem, SceneError, Source, location_of
from solver.scene.positions import first_of_repeated, lines_of_json
from solver.scene.units import unit_help

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

MOST_LEVELS = 50
"""Levels of tables and lists within each other; scenes have 4."""
_BITS = 4096
"""Digits of an integer; the largest double has 309."""
_TUPLE, _QUOTED = re.compile(r"\(('[^']*',? ?)+\)"), re.compile(r"'([^']*)'")
"""Keys as the reader of TOML names them: ('points', 'A')."""
_TWICE = "Cannot overwrite a value"
_TOML_HELP = {
    "Illegal character '\\n'": "a text ends on the line it begins on: close its quotes",
    _TWICE: "the same key is given twice",
    "Cannot declare": "put the fields of both tables below one heading",
    "Expected '=' after a key": "write name = value; a name has letters, digits, _ and -",
    "Expected ']' at the end of a table": "a heading is [name], on a line of its own",
    "Expected newline or end of document": "write one field a line, and numbers as 1 or 0.5",
    "Invalid value": "quote texts; write numbers as 0.5 or 1e-3, true and false in small letters",
    "Unclosed array": "close it by ], and put commas between its values",
    "Unclosed inline table": "close it by }, and put commas between its fields",
    "Unescaped '\\' in a string": "write it twice, or put the text in single quotes",
}
"""What helps, by the beginning of what the reader of TOML says."""


def text_of(path: str) -> tuple[str, str]:
    """Text and notation of a scene file.

    Raises
    ------
    SceneError
        If there is no such file, or none of text.
    """
    notation = FilePath(path).suffix.lower().removeprefix(".")
    if notation not in ("toml", "json"):
        message = f"unknown kind of file '{FilePath(path).suffix}'"
        _give_up(Source(path), message, "known: .toml, .json")
    try:
        data = read_whole(path)
    except FileNotFoundError:
        _give_up(Source(path), "file not found")
    except OSError as error:
        _give_up(Source(path), f"cannot be read: {error.strerror}")
    try:
        return data.decode("utf-8-sig"), notation
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        message = f"not a UTF-8 text: byte 0x{data[error.start]:02x}"
        source = Source(path, data.decode("utf-8", errors="replace"))
        _give_up(source, message, "save the file as UTF-8", line)


def tables_of(text: str, name: str, notation: str) -> tuple[dict[str, Any], list[Problem]]:
    """Tables of a text, and the keys that are given twice in it.

    Raises
    ------
    SceneError
        If the text cannot be read.
    """
    problems: list[Problem] = []
    source = Source(name, text)
    try:
        data = _json(source, problems) if notation == "json" else _toml(source)
    except RecursionError:
        _give_up(source, f"{notation.upper()}: nested too deeply")
    except ValueError:  # of Python, which limits integers, and not of the notation
        _refuse_digits(source)
    _shallow(data, source)
    return data, problems


def _give_up(
    source: Source, message: str, help: str | None = None,
    line: int | None = None, column: int | None = None,
) -> NoReturn:  # fmt: skip
    """Raise a mistake that lets nothing else be found."""
    raise SceneError([Problem("", message, help, line, column)], source)


def _toml(source: Source) -> dict[str, Any]:
    text = source.text
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        words = str(error)
        place = re.search(r" \(at (?:line (\d+), column (\d+)|end of document)\)", words)
        message = words[: place.start()] if place else words
        message = _TUPLE.sub(lambda found: ".".join(_QUOTED.findall(found[0])), message)
        line = int(place[1]) if place and place[1] else len(text.rstrip().split("\n"))
        column = int(place[2]) if place and place[2] else None
        help = next((x for start, x in _TOML_HELP.items() if message.startswith(start)), None)
        if message == _TWICE:
            before = sum(len(each) + 1 for each in text.split("\n")[: line - 1])
            first = first_of_repeated(text[: before + column - 1] if column else text)
            help = f"{help}, first in line {first}" if first else help
        else:  # such as angle = 90 deg
            pieces = re.split(r"[=,{}\[\]]", text.split("\n")[line - 1])
            help = next(filter(None, map(unit_help, pieces)), help)
        _give_up(source, f"TOML: {message}", help, line, column)


def _json(source: Source, problems: list[Problem]) -> dict[str, Any]:
    twice: list[str] = []

    def table(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        entries = dict(pairs)
        if len(entries) < len(pairs):
            twice.extend(key for key, _ in pairs)
        return entries

    try:
        data = json.loads(source.text, object_pairs_hook=table)
    except json.JSONDecodeError as error:
        _give_up(source, f"JSON: {error.msg}", None, error.lineno, error.colno)
    if not isinstance(data, dict):
        _give_up(source, f"must be a table of fields, got {shown(data)}")
    if twice:
        lines, repeated = lines_of_json(source.text)
        for path, line in repeated:
            message = f"given twice, first in line {lines[path]}"
            problems.append(Problem(location_of(path), message, line=line))
    return data


def _refuse_digits(source: Source) -> NoReturn:
    """Give up on an integer that Python does not read or write, as that would take long."""
    long = re.compile(r"[0-9a-fA-F_]{640}")
    line = next((k for k, x in enumerate(source.text.split("\n"), 1) if long.search(x)), None)
    _give_up(source, "an integer with thousands of digits", None, line)


def _shallow(data: Any, source: Source) -> None:
    """Give up on nesting and texts that no scene has, before anything descends into them."""
    level = [data]
    for _ in range(MOST_LEVELS):
        inside = [[*x, *x.values()] if isinstance(x, dict) else x for x in level]
        if not all(is_readable(x) for items in inside for x in items if isinstance(x, str)):
            _give_up(source, "a text with half a character, such as \\ud800")
        if any(type(x) is int and x.bit_length() > _BITS for items in inside for x in items):
            _refuse_digits(source)
        level = [item for items in inside for item in items if isinstance(item, (dict, list))]
        if not level:
            return
    _give_up(source, "nested too deeply")
