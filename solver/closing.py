"""Closes the mechanism of a scene, and writes the closed pose into its text."""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from solver.closed_pose import Pose, axes_of, moving
from solver.closed_text import SAME, Edit, files_from
from solver.files import write_whole, wrong_ending
from solver.mechanics.assembly import assemble_parts
from solver.mechanics.mobility import Survey, survey
from solver.mechanics.parts import Parts
from solver.runtime import Integrator, OptionError
from solver.runtime.layout import CLOSINGS
from solver.scene import Scene, SceneWarning, load, loads
from solver.scene.mistakes import location_of
from solver.scene.overrides import value_of
from solver.scene.positions import Path, spans_of
from solver.scene.rewriting import UnwrittenError, Written, rewritten
from solver.scene.rewriting import value_of as value_in

METHODS = {
    "at_once": "by the smallest displacement",
    "on_path": "on a path from the drawing",
    "behind_path": "from the end of a path from the drawing, at a dead centre",
    "shaken": "from a shaken drawing",
}
"""How a mechanism was closed, by the words of ``CLOSINGS``."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Closing:
    """A closed mechanism."""

    moved: dict[str, tuple[float, float]]
    """How far each point and body moved from its drawing [m], and the angle it turned by [rad]."""
    method: str
    """How it was closed, in words."""
    tries: int
    """Shaken drawings that were tried, to find a pose or others."""
    others: bool
    """Whether another pose is as near to the drawing."""
    freedoms: int | None
    """Degrees of freedom that joints and drivers leave; None of more than 2000 rows."""
    redundant: tuple[str, ...]
    """Parts whose rows depend on each other in the closed pose."""
    remarks: tuple[str, ...]
    """Formulas that numbers replace, and what counts from the drawing, by how much it changes."""
    text: str
    """The scene with the closed pose."""


def close(
    scene: str | os.PathLike[str] | Scene, path: str | os.PathLike[str] | None = None
) -> Closing:
    """Close the mechanism of a scene; its text gets the closed places and velocities.

    Parameters
    ----------
    scene
        A scene file (.toml or .json) or a loaded scene. Values that it was loaded with, in place of
        those of its file, are written into the text as well.
    path
        File to write the closed scene into; None: none is written. In another folder the names of
        files in the scene are changed so that they are found from there.

    Returns
    -------
    Closing
        What moved, how, and the text: positions, orientations and velocities are numbers in m, rad
        and s, all else, comments too, is as it was.

    Raises
    ------
    SceneError
        With every mistake of the scene; where no pose closes the mechanism, by how much each part
        misses in the best one; or where a place of the drawing cannot be written.
    OptionError
        If the name of the file does not end as the notation of the scene, .toml or .json; or if the
        scene was made without a text.
    """
    given = scene if isinstance(scene, Scene) else load(scene)
    if not given.source.notation:
        text = f"close: the scene '{given.name}' has no text that gets the closed pose; load a file"
        raise OptionError(text)
    if path is not None and (wrong := wrong_ending(path, (f".{given.source.notation}",))):
        raise OptionError(wrong)
    drawn = _with_values_in_its_text(given)
    parts, closed, counts, integrator = _closed(given)
    poses = {name: Pose.of(drawn, name, closed) for name in moving(drawn)}
    size = max(integrator.numbers[integrator.model.offsets["extent"]], math.ulp(0.0))
    edit = Edit(drawn, parts, poses, closed, size)
    text = _rewritten(drawn, edit.values)
    _check_again(given, text, closed, size)
    remarks = [*edit.remarks]
    if path is not None and (files := files_from(drawn, os.path.dirname(os.path.abspath(path)))):
        text = rewritten(text, drawn.source.notation, files)
        remarks += [
            f"{location_of(place)}: {new!r} from its folder" for place, new in files.items()
        ]
    text = text.replace("\n", drawn.source.line_end)
    head = integrator.state.head
    result = Closing(
        moved={name: pose.moved for name, pose in poses.items()},
        method=METHODS[CLOSINGS[int(head["closing"])]],
        tries=int(head["closing_tries"]),
        others=bool(head["closing_others"]),
        freedoms=counts.degrees_of_freedom,
        redundant=counts.redundant_parts or (),
        remarks=tuple(remarks),
        text=text,
    )
    if path is not None:
        write_whole(path, text)
    return result


def _closed(scene: Scene) -> tuple[Parts, dict[str, float], Survey, Integrator]:
    """Values of all outputs in the closed pose."""
    settings: Any = scene.solver  # a dataclass, as all parts of a scene
    scene = replace(scene, solver=replace(settings, assemble=True))
    parts, model = assemble_parts(scene)
    integrator = Integrator(model, log=lambda _: None)  # what moved is in the result
    integrator.initialise()
    indices = [k for k, v in enumerate(model.variables) if v.causality == "output"]
    names = (model.variables[k].name for k in indices)
    values = integrator.get(indices)
    numbers = {n: float(x) for n, x in zip(names, values, strict=True) if not isinstance(x, str)}
    return parts, numbers, survey(model), integrator


def _rewritten(scene: Scene, values: Mapping[Path, Written]) -> str:
    """Text of a scene with these values, or an error that says which cannot be written."""
    text, notation = scene.source.text, scene.source.notation
    try:
        return rewritten(text, notation, values)
    except UnwrittenError as error:
        spans = spans_of(text, notation)
        message = "is of a table that the text lacks"
        help = f"write the table '{location_of(error.path[:-1])}' into the file"
        if any(known[: len(error.path)] == error.path for known in spans):
            message = "is written as a table of several lines, which is not replaced"
            help = "write it in one line, such as orientation = { axis = [0, 0, 1], angle = 0.1 }"
        scene.fail([scene.source.problem(error.path, message, help)])


def _read(scene: Scene, text: str) -> Scene:
    """Read another text of a scene, whose warnings were given with the first."""
    form: Any = scene.source.notation
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SceneWarning)
        return loads(text, name=scene.source.name, format=form)


def _with_values_in_its_text(scene: Scene) -> Scene:
    """Scene whose text has the values that replaced some of it when it was read."""
    source = scene.source
    spans, new = spans_of(source.text, source.notation), dict[Path, Any]()
    for path, text in source.overrides.items():
        if path not in source.places:  # the content of a file
            continue
        whole = path[: next((k for k, x in enumerate(path) if isinstance(x, int)), len(path))]
        value = value_of(text.partition("=")[2])
        if whole != path:  # an element of a list
            span = spans[whole]
            written = source.text[span.begin : span.end]
            outer = inner = new[whole] if whole in new else value_in(written, source.notation)
            for step in path[len(whole) : -1]:
                inner = inner[step]
            inner[path[-1]], value = value, outer
        new[whole] = value
    return _read(scene, _rewritten(scene, new)) if new else scene


def _check_again(scene: Scene, text: str, closed: Mapping[str, float], size: float) -> None:
    """Read the closed text again; it must need no closing."""
    again = _closed(_read(scene, text))[1]
    for name in moving(scene):
        gap = math.dist(
            *([x[f"{name}.{axis}"] for axis in axes_of(scene)] for x in (closed, again))
        )
        if gap > SAME * size:
            message = (
                f"the closed pose cannot be written: read again, '{name}' moves by {gap:.3g} m"
            )
            if scene.source.places:
                message += (
                    ", since values that were given from outside move places that are fixed to "
                    "parts; write these values into the file"
                )
            scene.fail([scene.error("", message)])
