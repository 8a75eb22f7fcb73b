"""Scene files: from text (TOML or JSON) and overrides to a checked ``Scene``."""

from __future__ import annotations

from collections.abc import Mapping

from solver.scene.build import build
from solver.scene.collector import collector_paused
from solver.scene.draft import Draft
from solver.scene.overrides import apply_overrides
from solver.scene.report import SceneError, Source
from solver.scene.tables import tables_of, text_of
from solver.scene.vocabulary import Scene


def read_file(path: str, overrides: Mapping[str, object]) -> Scene:
    """Read a scene file; see ``solver.scene.load``."""
    text, notation = text_of(path)
    return read_text(text, path, notation, overrides)


@collector_paused()
def read_text(text: str, name: str, notation: str, overrides: Mapping[str, object]) -> Scene:
    """Read the text of a scene; see ``solver.scene.loads``."""
    text = text.replace("\r\n", "\n")
    data, problems = tables_of(text, name, notation)
    drawn = Draft(data, Source(name, text, notation), [])
    if overrides and data.get("bodies"):
        build(drawn)  # for where its places lie on its bodies
    source = Source(name, text, notation, *apply_overrides(data, overrides, problems))
    draft = Draft(data, source, problems)
    draft.seats_of_file = drawn.seats
    scene = build(draft)
    if problems:
        raise SceneError(problems, source)
    return scene
