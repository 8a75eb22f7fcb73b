"""Scene files: from text (TOML or JSON) and overrides to a checked ``Scene``."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path as FilePath

from solver.scene.build import build
from solver.scene.collector import collector_paused
from solver.scene.draft import Draft
from solver.scene.overrides import apply_overrides
from solver.scene.report import Problem, SceneError, Source
from solver.scene.tables import give_up, tables_of
from solver.scene.vocabulary import Scene


def read_file(path: str, overrides: Mapping[str, object]) -> Scene:
    """Read a scene file; see ``solver.scene.load``."""
    notation = FilePath(path).suffix.lower().removeprefix(".")
    if notation not in ("toml", "json"):
        message = f"unknown kind of file '{FilePath(path).suffix}'"
        give_up(Source(path), Problem("", message, "known: .toml, .json"))
    try:
        data = FilePath(path).read_bytes()
    except FileNotFoundError:
        give_up(Source(path), Problem("", "file not found"))
    except OSError as error:
        give_up(Source(path), Problem("", f"cannot be read: {error.strerror}"))
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        message = f"not a UTF-8 text: byte 0x{data[error.start]:02x}"
        source = Source(path, data.decode("utf-8", errors="replace"))
        give_up(source, Problem("", message, "save the file as UTF-8", line))
    return read_text(text, path, notation, overrides)


@collector_paused()
def read_text(text: str, name: str, notation: str, overrides: Mapping[str, object]) -> Scene:
    """Read the text of a scene; see ``solver.scene.loads``."""
    text = text.replace("\r\n", "\n")
    data, problems = tables_of(text, name, notation)
    source = Source(name, text, notation, *apply_overrides(data, overrides, problems))
    draft = Draft(data, source, problems)
    scene = build(draft)
    if problems:
        raise SceneError(problems, source)
    return scene
