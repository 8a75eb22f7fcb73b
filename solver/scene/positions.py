"""Lines of a scene file: where each key and each array element stands, and numbers as written.

TOML and JSON readers hand out values without their places. This scanner walks a text that the
reader has already accepted and notes a line for every path, so it need not judge the syntax.
Both notations share one rule, ``key separator value`` within brackets; TOML adds headers.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

Path: TypeAlias = tuple[str | int, ...]
"""Place in a scene: keys of tables and indices of arrays, ``("points", "A", "position", 0)``."""

_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_COMMENT_LINES = re.compile(r"(?:[ \t\r\n,]|#[^\n]*)*")
STRING = re.compile(
    r'"""(?:\\.|[^\\])*?"{3,5}|"(?:\\.|[^"\\\n])*"'
    r"|'''.*?'{3,5}|'[^'\n]*'",
    re.DOTALL,
)
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_SCALAR = re.compile(r"[^,\]}#\n]*")


def lines_of(text: str, notation: str) -> Mapping[Path, int]:
    """Line of each path of a text; nothing has a line where the notation is unknown.

    Only a report of mistakes asks for lines.
    """
    return _scanned(text, notation).lines


def written(text: str, notation: str) -> Mapping[Path, str]:
    """Text of each number of a text, with all its digits; nothing where the notation is unknown."""
    return _scanned(text, notation).scalars


def lines_of_json(text: str) -> tuple[Mapping[Path, int], list[tuple[Path, int]]]:
    """Line of each path of a JSON text that a reader has accepted, and of keys given twice."""
    scanner = _scanned(text, "json")
    return scanner.lines, scanner.repeated


def first_of_repeated(text: str) -> int | None:
    """Line of the key that the last entry of a TOML text, which ends with it, gives once more."""
    scanner = _scanned(text, "toml")
    return scanner.lines[scanner.repeated[-1][0]] if scanner.repeated else None


@dataclass(frozen=True, slots=True)
class Span:
    """Where the value of a key stands in a text, and its key."""

    begin: int
    end: int
    key: str
    """As it is written, with the keys of outer tables if it has them."""
    in_brackets: bool
    """Whether the entry stands within braces, and so ends with a comma and not with its line."""


def spans_of(text: str, notation: str) -> Mapping[Path, Span]:
    """Where the value of each key of a text stands that a reader has accepted."""
    return _scanned(text, notation).spans


@lru_cache(maxsize=4)
def _scanned(text: str, notation: str) -> _Scanner:
    """Scanner at the end of a text; at its beginning where the notation is unknown."""
    scanner = _Scanner(text)
    if notation == "toml":
        scanner.document()
    elif notation == "json":
        scanner.skip(_BLANK)
        scanner.value(())
    return scanner


class _Scanner:
    def __init__(self, text: str) -> None:
        self.text = text
        self.spans: dict[Path, Span] = {}
        self.at = 0
        self.line = 1
        self.counted = 0
        """Characters whose line breaks `line` has counted."""
        self.lines: dict[Path, int] = {}
        self.scalars: dict[Path, str] = {}
        self.repeated: list[tuple[Path, int]] = []
        """Keys given twice in one bracket, and the line of the second."""
        self.counts: dict[Path, int] = {}
        """Elements seen of each array of tables."""

    def skip(self, pattern: re.Pattern[str]) -> str:
        match = pattern.match(self.text, self.at)
        assert match is not None
        self.at = match.end()
        return match.group()

    def peek(self, text: str) -> bool:
        return self.text.startswith(text, self.at)

    def note(self, path: Path) -> None:
        self.line += self.text.count("\n", self.counted, self.at)
        self.counted = self.at
        self.lines.setdefault(path, self.line)

    def document(self) -> None:
        table: Path = ()
        while True:
            self.skip(_BLANK)
            if self.at >= len(self.text):
                return
            if self.peek("["):
                table = self.header()
            else:
                self.entry(table)

    def header(self) -> Path:
        """Read ``[a.b]`` or ``[[a.b]]``; an array of tables grows by one."""
        brackets = 2 if self.peek("[[") else 1
        self.at += brackets
        keys = self.key()
        self.at += brackets
        path: Path = ()
        for i, part in enumerate(keys):
            path = (*path, part)
            self.note(path)
            if brackets == 2 and i == len(keys) - 1:
                self.counts[path] = self.counts.get(path, 0) + 1
            if path in self.counts:
                path = (*path, self.counts[path] - 1)
                self.note(path)
        return path

    def entry(self, table: Path, *, in_brackets: bool = False) -> None:
        """Read ``key = value``, or ``"key": value``."""
        known, begin = False, self.at
        keys = self.key()
        key = self.text[begin : self.at].strip()
        for part in keys:
            table = (*table, part)
            known = table in self.lines
            self.note(table)
        if known:
            self.repeated.append((table, self.line))
        self.at += 1  # the separator
        self.skip(_BLANK)
        begin = self.at
        self.value(table)
        end = begin + len(self.text[begin : self.at].rstrip())
        self.spans[table] = Span(begin, end, key, in_brackets)

    def key(self) -> list[str]:
        """Read a dotted key."""
        parts = []
        while True:
            self.skip(_BLANK)
            parts.append(_unquoted(self.skip(STRING if self.text[self.at] in "\"'" else _BARE_KEY)))
            self.skip(_BLANK)
            if not self.peek("."):
                return parts
            self.at += 1

    def value(self, path: Path) -> None:
        if path:
            self.note(path)
        if self.peek("["):
            self.at += 1
            index = 0
            while self.skip(_COMMENT_LINES) is not None and not self.peek("]"):
                self.value((*path, index))
                index += 1
            self.at += 1
        elif self.peek("{"):
            self.at += 1
            while self.skip(_COMMENT_LINES) is not None and not self.peek("}"):
                self.entry(path, in_brackets=True)
            self.at += 1
        elif self.text[self.at] in "\"'":
            self.skip(STRING)
        else:
            self.scalars[path] = self.skip(_SCALAR).strip()


def _unquoted(key: str) -> str:
    """Meaning of a key; escapes of TOML's basic strings that JSON lacks stay as written."""
    if key.startswith("'"):
        return key[1:-1]
    if not key.startswith('"'):
        return key
    try:
        return json.loads(key)
    except ValueError:
        return key[1:-1]
