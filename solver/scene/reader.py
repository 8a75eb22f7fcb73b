"""Scene files: from text (TOML or JSON) and overrides to a checked ``Scene``.

Every mistake of a file is reported in one run. A field with a mistake is reported once and counts
as broken from then on; a part that was left out because its type is unknown still lends its name.
So nothing is reported twice.
"""

from __future__ import annotations

import gc
import os
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from typing import Any, Literal

from solver.scene.advice import advise
from solver.scene.bodies import Bar
from solver.scene.draft import Draft
from solver.scene.drivers import PositionDriver
from solver.scene.fields import BROKEN, Part, fields_of
from solver.scene.looks import read_view
from solver.scene.mistakes import (
    Path,
    SceneError,
    SceneWarning,
    Source,
    in_order,
    location_of,
)
from solver.scene.names import check_body_points, check_names, check_scene_name, known_names
from solver.scene.overrides import apply_overrides
from solver.scene.parallel_axes import align_axes
from solver.scene.parameters import read_parameters
from solver.scene.profiles import Profile, read_profiles
from solver.scene.references import Reader
from solver.scene.scene import HEADING, Scene
from solver.scene.settings import read_ports, read_settings
from solver.scene.tables import tables_of, text_of
from solver.scene.words import did_you_mean

_MOVING = ("parameters", "points", "bodies")
"""Tables whose numbers say where bodies and their points are."""
_MANY_OBJECTS = 200_000
"""Objects that the garbage collector would look at for more than some 10 ms."""


@contextmanager
def collector_paused() -> Iterator[None]:
    """Make objects without a search for cycles among them; works as a decorator as well.

    A large scene is millions of objects that all stay. Python's cyclic garbage collector would look
    at every one of them again and again: for 10^5 points that is a third of the time. In the end
    many are put with the old ones; it would look at all of them at once otherwise. Of few that
    costs nothing, while to ask whether a caller has frozen objects is to count them all.
    """
    running = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if running:
            if gc.get_count()[0] > _MANY_OBJECTS and not gc.get_freeze_count():
                gc.freeze()
                gc.unfreeze()
            gc.enable()


def load(path: str | os.PathLike[str], overrides: Mapping[str, object] | None = None) -> Scene:
    """Read a scene file.

    Parameters
    ----------
    path : path-like
        A ``.toml`` or ``.json`` file.
    overrides : mapping, optional
        New values by name: a parameter or input, ``"length"``, or any field of the scene,
        ``"points.A.mass"``. A value is a number or a text as it would stand in the file, or one of
        these as ``Given`` with the place that reports of mistakes in it shall name.

    Raises
    ------
    SceneError
        With every mistake in the file and the overrides.

    Warns
    -----
    SceneWarning
        Of what is legal and seldom meant; the scene keeps these as its `warnings`.
    """
    return _with_warnings(read_file(os.fspath(path), overrides or {}))


def loads(
    text: str,
    *,
    name: str = "scene.toml",
    format: Literal["toml", "json"] = "toml",
    overrides: Mapping[str, object] | None = None,
) -> Scene:
    """Read a scene from text; `name` stands for the file in reports. See ``load``."""
    return _with_warnings(read_text(text, name, format, overrides or {}))


def _with_warnings(scene: Scene) -> Scene:
    """Give the warnings of a scene to Python, at the line that called this package's function."""
    for sentence in scene.sentences():
        warnings.warn(sentence, SceneWarning, stacklevel=3)
    return scene


def read_file(path: str, overrides: Mapping[str, object]) -> Scene:
    """Read a scene file; see ``solver.scene.load``."""
    text, notation = text_of(path)
    return read_text(text, path, notation, overrides)


@collector_paused()
def read_text(text: str, name: str, notation: str, overrides: Mapping[str, object]) -> Scene:
    """Read the text of a scene; see ``solver.scene.loads``."""
    line_end = "\r\n" if text.count("\r\n") * 2 > text.count("\n") else "\n"
    text = text.replace("\r\n", "\n")
    data, problems = tables_of(text, name, notation)
    source = Source(name, text, notation, line_end, *apply_overrides(data, overrides, problems))
    draft = Draft(data, source, problems)
    if data.get("bodies") and any(path[0] in _MOVING for path in source.overrides):
        drawn = Draft(tables_of(text, name, notation)[0], Source(name, text, notation), [])
        drawn.seats = draft.seats_of_file = {}
        _build(drawn)
    scene = _build(draft)
    if problems:
        raise SceneError(problems, source)
    return scene


def _build(draft: Draft) -> Scene:
    """Check a draft and turn it into a scene; the draft collects the mistakes."""
    check_names(draft)
    profiles = read_profiles(draft)
    named = draft.parts("expressions")
    heading = _heading(draft)
    drawn = {table: draft.parts(table) for table in ("points", "bodies")}
    _forgotten_dimension(draft, drawn, heading.gravity)
    known = known_names(draft)
    check_body_points(draft, known)
    reader = Reader(draft, known, profiles)
    reader.read("expressions", named)
    read_parameters(reader)
    reader.read("inputs")
    reader.read("states")
    for table in ("points", "bodies"):
        reader.read(table, drawn[table])
    for table in ("joints", "constraints", "contacts", "forces", "drivers", "sensors"):
        reader.read(table)
    _something_moves(draft, reader.parts["points"])
    _free_points_have_mass(draft, drawn["points"], reader.parts)
    gravity = reader.zero()
    if heading.gravity is not None:
        gravity = reader.vector(("gravity",), heading.gravity)
    reader.read("outputs")
    reader.read("looks")
    solver, experiment = read_settings(reader)
    aligned = {} if draft.problems else align_axes(draft, reader.parts["joints"])
    reader.parts["joints"] |= aligned
    if not draft.problems:
        advise(reader, profiles, reader.parts, vars(solver))
    return Scene(
        name=heading.name,
        description=heading.description or "",
        dimension=2 if draft.dimension == 2 else 3,
        gravity=gravity,
        profiles=profiles,
        **reader.parts,
        solver=solver,
        experiment=experiment,
        fits_velocities=bool(aligned) and _have_velocities(reader.parts),
        fmu=read_ports(reader),
        view=read_view(reader),
        source=_without_files(draft.source, profiles, reader.parts["contacts"]),
        warnings=in_order(draft.warnings),
    )


def _without_files(
    source: Source, profiles: Mapping[str, Profile], contacts: Mapping[str, Part]
) -> Source:
    """Return the source with what files hold as overrides: it is to be read elsewhere too."""
    read: dict[Path, str] = {
        ("profiles", name): profile.text for name, profile in profiles.items() if profile.file
    }
    for name, contact in contacts.items():
        files = getattr(contact, "files", {})
        read |= {("contacts", name, word): file.text for word, file in files.items()}
    texts = {path: f"{location_of(path)}={text}" for path, text in read.items()}
    return replace(source, overrides={**source.overrides, **texts}) if texts else source


def _heading(draft: Draft) -> Any:
    """Read what the file says about the scene as a whole, and report unknown tables."""
    known = fields_of(Scene)
    for name in draft.data:
        if name not in known:
            help = did_you_mean(name, known, "known tables and fields", "file")
            draft.error((name,), "unknown table or field", help)
    heading = draft.part(
        (), Scene, {name: draft.data[name] for name in HEADING if name in draft.data}
    )
    if heading.name is not BROKEN:
        check_scene_name(draft, heading.name)
    return heading


def _forgotten_dimension(
    draft: Draft, drawn: Mapping[str, Mapping[str, Any]], gravity: Any
) -> None:
    """Say once, not at every vector, that a planar scene does not call itself planar."""
    places = [
        (table, given.position)
        for table, parts in drawn.items()
        for _, given in parts.values()
        if getattr(given, "position", BROKEN) is not BROKEN
    ]
    if gravity not in (None, BROKEN):
        places.append(("gravity", gravity))
    lengths = {len(vector) for _, vector in places}
    if lengths == {2} and "dimension" not in draft.data:
        draft.dimension = 2
        what = "gravity has" if places[0][0] == "gravity" else "positions have"
        message = f"{what} 2 numbers, but the scene has dimension 3 (the default)"
        help = "write dimension = 2 at the top of the file"
        draft.error((places[0][0],), message, help)


def _have_velocities(parts: Mapping[str, Mapping[str, Any]]) -> bool:
    given = (part for table in ("points", "bodies") for part in parts[table].values())
    fields = ("velocity", "angular_velocity")
    return any(getattr(part, field, None) is not None for part in given for field in fields)


def _something_moves(draft: Draft, points: Mapping[str, Any]) -> None:
    tables = [draft.data.get(name, {}) for name in ("points", "bodies")]
    if not all(isinstance(table, dict) for table in tables) or tables[1]:
        return
    if not tables[0]:
        message = "no points and no bodies: nothing can move"
        draft.error((), message, "write a table [points] or [bodies]")
    elif points and all(point.fixed for point in points.values()):
        draft.error(("points",), "all points are fixed: nothing can move")


def _free_points_have_mass(
    draft: Draft, drawn: Mapping[str, Any], read: Mapping[str, Mapping[str, Any]]
) -> None:
    """Report points that have no mass: none of their own or of a bar, and no driver."""
    if any(len(read[table]) < len(draft.table(table)) for table in ("bodies", "drivers")):
        return  # what was left out may carry any point
    bars = [body for body in read["bodies"].values() if isinstance(body, Bar)]
    carried = {end for bar in bars for end in bar.points}
    if not carried <= read["points"].keys():
        return  # a name that is none is reported already, and may mean any point
    carried |= {x.point.point for x in read["drivers"].values() if isinstance(x, PositionDriver)}
    for name, (_, given) in drawn.items():
        nothing = given.mass is None or (given.mass is not BROKEN and given.mass.number == 0.0)
        if nothing and not given.fixed and name not in carried:
            message = f"free point '{name}' has no mass"
            help = "give it a mass, a bar or fixed = true, or make it a point of a body"
            draft.error(("points", name), message, help)
