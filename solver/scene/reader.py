"""Scene files: from text (TOML or JSON) and overrides to a checked ``Scene``."""

from __future__ import annotations

from collections.abc import Mapping

from solver.scene.build import build
from solver.scene.collector import collector_paused
from solver.scene.diagnostics import Draft
from solver.scene.overrides import apply_overrides
from solver.scene.report import SceneError, Source
from solver.scene.tables import tables_of, text_of
from solver.scene.vocabulary import Scene

_MOVING = ("parameters", "points", "bodies")
"""Tables whose numbers say where bodies and their points are."""


def read_file(path: str, overrides: Mapping[str, object]) -> Scene:
    """Read a scene file; see ``solver.scene.load``."""
    text, notation = text_of(path)
    return read_text(text, path, notation, overrides)


@collector_paused()
def read_text(text: str, name: str, notation: str, overrides: Mapping[str, object]) -> Scene:
    """Read the text of a scene; see ``solver.scene.loads``."""
    text = text.replace("\r\n", "\n")
    data, problems = tables_of(text, name, notation)
    source = Source(name, text, notation, *apply_overrides(data, overrides, problems))
    draft = Draft(data, source, problems)
    if data.get("bodies") and any(path[0] in _MOVING for path in source.overrides):
        drawn = Draft(tables_of(text, name, notation)[0], Source(name, text, notation), [])
        drawn.seats = draft.seats_of_file = {}
        build(drawn)
    scene = build(draft)
    if problems:
        raise SceneError(problems, source)
    return scene
