"""Contacts with triangle meshes, and the files of these: STL or OBJ.

A mesh must be watertight, as it has an inside then. ``trimesh`` reads it, which only scenes with
meshes need.
"""

import io
import re
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from typing import TYPE_CHECKING, Annotated, Any, Literal

from solver.scene import fields as kind
from solver.scene.contact_laws import RubbingContact
from solver.scene.contacts import check_size, read_corners
from solver.scene.couplings import check_point_and_body
from solver.scene.expression import Number, Vector
from solver.scene.fields import BROKEN, PointReference
from solver.scene.files import DataFile, read_file
from solver.scene.mistakes import Path
from solver.scene.rules import NOT_NEGATIVE, POSITIVE, Rule
from solver.scene.shapes import PairContact

if TYPE_CHECKING:
    from solver.scene.references import Reader

LIBRARIES = ("trimesh", "igl", "scipy")
"""What meshes need besides: their modules."""


NO_MESH = DataFile("", "stl", b"")
"""Stands for one that has been reported."""


@lru_cache(maxsize=8)
def triangles_of(mesh: DataFile) -> Any:
    """Return the ``trimesh.Trimesh`` of a file, each corner once, its triangles facing outwards."""
    import trimesh

    content = mesh.content
    if mesh.form == "obj":  # of colours, textures, normals and groups nothing is wanted
        lines = [line for line in content.splitlines() if line[:2].rstrip() in (b"v", b"f")]
        content = b"\n".join(re.sub(rb"/\S*", b"", line) for line in lines)
    found: Any = trimesh.load_mesh(io.BytesIO(content), file_type=mesh.form)
    if found.is_watertight and found.is_winding_consistent and found.volume < 0.0:
        found.invert()
    return found


def read_mesh(reader: "Reader", path: Path, file: Any, _: Any) -> DataFile:
    """Read a file of triangles that have an inside; report one that has not."""
    if file is BROKEN:
        return NO_MESH
    error, help = reader.draft.error, 'pip install "holonom[mesh]"'
    if missing := [name for name in LIBRARIES if find_spec(name) is None]:
        message = f"meshes need Python packages that are not installed: {', '.join(missing)}"
        error(path, message, help)
        return NO_MESH
    help = "export the surface as STL or OBJ"
    mesh = read_file(reader.draft, path, file, ("stl", "obj"), help)
    if mesh is None:
        return NO_MESH
    try:
        found = triangles_of(mesh)
        flaw = _flaw(found)
    except Exception as problem:  # whatever a reader of damaged files raises
        flaw = f"is damaged: {problem}"
    if flaw:
        help = "export a closed surface, with a mesh tool that repairs holes if need be"
        error(path, f"the mesh '{mesh.name}' {flaw}", help)
        return NO_MESH
    return mesh


def _flaw(found: Any) -> str:
    """What keeps triangles from having an inside; empty if they have one."""
    import numpy as np

    if not len(found.faces):
        return "holds no triangles"
    if not np.isfinite(found.vertices).all():
        return "has corners that are not finite"
    if not found.is_watertight:
        counts = np.unique(found.edges_sorted, axis=0, return_counts=True)[1]
        odd = int((counts != 2).sum())
        return f"is not watertight: {odd} of its {len(counts)} edges do not join two triangles"
    if not found.is_winding_consistent:
        return "has neighbouring triangles that face opposite sides"
    return "" if found.volume else "has no volume"


def _points(reader: "Reader", path: Path, names: Any, _: Any) -> tuple[PointReference, ...]:
    if names is BROKEN:
        return ()
    if not names:
        reader.draft.error(path, "must have at least one point, got none")
    return tuple(reader.point(path[:-1], name, None, "points") for name in names)


def _part(reader: "Reader", path: Path, name: Any, _: Any) -> str:
    if name is BROKEN:
        return ""
    reader.body(path, name)
    return name


_FILE = "found from the scene's folder"
_COUNT = Rule(lambda x: 1 <= x <= 1000, "from 1 to 1000")


@dataclass(frozen=True, slots=True, kw_only=True)
class MeshContact(RubbingContact):
    """Points, or places of a part, against the surface of a mesh that a body carries."""

    type = "mesh"
    may_be_compliant = False
    only_in = (3, "in the plane write 'profile' or 'surface'")

    file: Annotated[
        DataFile, kind.Plain(text=f"STL or OBJ, {_FILE}", example="bowl.stl", reading=read_mesh)
    ]
    body: Annotated[str | None, kind.BODY_OR_GROUND] = None
    position: Annotated[
        Vector | None, kind.Components("m", "origin of the mesh as drawn; that of the body")
    ] = None
    scale: Annotated[
        float, kind.setting("m", "of one unit of the file, 0.001 for mm", POSITIVE, 1.0)
    ] = 1.0
    resolution: Annotated[
        float | None, kind.setting("m", "cells of the grid; 1/32 of its longest side", POSITIVE)
    ] = None
    side: Annotated[
        Literal["outside", "inside"], kind.Choice(words=("outside", "inside"))
    ] = "outside"  # fmt: skip
    point: Annotated[PointReference | None, kind.ONE_END] = None
    points: Annotated[
        tuple[PointReference, ...],
        kind.ListOf(item=kind.NAME, text="several", example=["A", "B"], reading=_points),
    ] = ()
    part: Annotated[
        str, kind.Plain(text="body whose corners touch", example="cube", reading=_part)
    ] = ""  # fmt: skip
    corners: Annotated[
        tuple[Vector, ...],
        kind.ListOf(
            "m", "places in axes of the part, from its origin", item=kind.COMPONENTS,
            example=[[0, 0, 0], [1, 0, 0]], reading=read_corners,
        ),
    ] = ()  # fmt: skip
    corner_file: Annotated[
        DataFile | None,
        kind.Plain(
            text=f"STL or OBJ of the part, with the same scale, {_FILE}: its corners",
            example="cube.stl", reading=read_mesh,
        ),
    ] = None  # fmt: skip
    most_corners: Annotated[int, kind.Plain(type=int, text="of a file", rule=_COUNT)] = 32
    ball_radius: Annotated[
        Number, kind.Quantity("m", "of balls about the points and corners", NOT_NEGATIVE)
    ] = 0.0

    @property
    def files(self) -> dict[str, DataFile]:
        """Files by the fields that name them."""
        both = {"file": self.file, "corner_file": self.corner_file}
        return {name: mesh for name, mesh in both.items() if mesh is not None}

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that one kind of points is given, and none of the body that carries the mesh."""
        RubbingContact.check(self, reader, path, given)
        kinds = ("point", "points", "part")
        if sum(getattr(given, name) is not None for name in kinds) != 1:
            message = "must have one of 'point', 'points' and 'part', which touch the mesh"
            reader.draft.error(path, message, 'write point = "ball"')
        if self.point is not None:
            check_point_and_body(reader, path, self.point, self.body, given.body)
        for reference in self.points:
            check_point_and_body(reader, path, reference, self.body, given.body, "points")
        if self.part and self.part == self.body:
            reader.draft.error((*path, "part"), f"'{self.part}' carries the mesh itself")
        sources = [x for x in ("corners", "corner_file") if getattr(given, x) is not None]
        if given.part is not None and len(sources) != 1:
            message = "a part must have either 'corners' or 'corner_file'"
            help = 'write corner_file = "cube.stl", or corners = [[0, 0, 0], [1, 0, 0]]'
            reader.draft.error(path, message, help)
        for name in sources if given.part is None else ():
            message = "has no effect without 'part'"
            reader.draft.error((*path, name), message, "name the body that has them")


@dataclass(frozen=True, slots=True, kw_only=True)
class ConvexContact(PairContact):
    """Two bodies made of convex parts: the pieces of a mesh each, or a mesh and a box."""

    type = "convex"
    only_in = (3, "in the plane write 'polygon'")

    file: Annotated[
        DataFile,
        kind.Plain(
            text=f"STL or OBJ of the first body, in its axes, of convex pieces, {_FILE}",
            example="die.stl", reading=read_mesh,
        ),
    ]  # fmt: skip
    other_file: Annotated[
        DataFile | None,
        kind.Plain(text="of the second body, likewise", example="die.stl", reading=read_mesh),
    ] = None
    size: Annotated[
        Vector | None,
        kind.Components(
            "m", "instead of other_file: lengths of a box about the origin of the second body",
            rule=POSITIVE,
        ),
    ] = None  # fmt: skip
    scale: Annotated[
        float, kind.setting("m", "of one unit of the files, 0.001 for mm", POSITIVE, 1.0)
    ] = 1.0

    @property
    def files(self) -> dict[str, DataFile]:
        """Files by the fields that name them."""
        both = {"file": self.file, "other_file": self.other_file}
        return {name: mesh for name, mesh in both.items() if mesh is not None}

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that the second body has one shape."""
        PairContact.check(self, reader, path, given)
        if (given.other_file is None) == (given.size is None):
            message = "must have either 'other_file' or 'size', the shape of the second body"
            help = 'write other_file = "die.stl", or size = [...] for a box'
            reader.draft.error(path, message, help)
        if self.size is not None and given.size is not BROKEN:
            check_size(reader, (*path, "size"), self.size)


MESHES: dict[str, type[kind.Part]] = {
    contact.type: contact for contact in (MeshContact, ConvexContact)
}
"""Types of contacts with meshes."""
