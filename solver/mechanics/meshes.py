"""Contacts with meshes: points and balls against distances that a spline over a grid gives.

gap        g = F sqrt((F^2 + a^2)/(F^2 + a^2 |grad d|^2)),
           F = s (d(c) + sqrt(|x - c|^2 + a^2) - a) - R

with the distance d of ``distance_grid``, s = 1 outside of the mesh and -1 inside, the place c of
the grid's box that is next to x, and its cells a: beyond the box the way to it adds to the
distance. Where g = 0 its gradient has size 1, also where edges are rounded off; elsewhere g is F.
A point that is drawn beyond the surface by less than the error of the grid begins with F = 0.
"""

from __future__ import annotations

from collections.abc import Iterator

from solver.mechanics.combination import Combination
from solver.mechanics.contacts import as_drawn
from solver.mechanics.distance_grid import MeshError, distance_grid, scaled, spread
from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.frames import RigidFrame
from solver.mechanics.parts import JointParts
from solver.mechanics.rows import Rows
from solver.mechanics.surfaces import add_implicit, coordinates
from solver.mechanics.vectors import Vector, dot, unit
from solver.scene import Expr, MeshContact, Number, PointReference
from solver.scene.expression import operate, sqrt

WORST = 0.01
"""Error of the distances, relative to the mesh, beyond which a build says so."""


def add_mesh(rows: Rows, contact: MeshContact, _: JointParts) -> None:
    """Keep points on one side of a mesh that a body carries."""
    mechanism = rows.mechanism
    outside = contact.side == "outside"
    sign, radius = (1.0 if outside else -1.0), contact.ball_radius
    try:
        found = distance_grid(
            contact.file, contact.scale, contact.resolution, sign * mechanism.default(radius)
        )
    except MeshError as problem:
        rows.problem(str(problem), f".{problem.field}")
        return
    if isinstance(radius, Expr):
        limit = found.reach if outside else found.depth
        text = f"ball_radius must be < {limit:.6g} m, what the grid has {contact.side} of the mesh"
        rows.rule(limit - radius, ">", f"{text}; it is {{value!r}} m below")
    x = [leaf_symbol(k) for k in range(3)]
    inside = [
        operate("min", operate("max", at, low), high)
        for at, low, high in zip(x, found.low, found.high, strict=True)
    ]
    beyond = [at - c for at, c in zip(x, inside, strict=True)]
    way = sqrt(dot(beyond, beyond) + found.spacing**2) - found.spacing
    value = sign * (operate("grid", *inside, found.grid) + way) - radius
    slopes: list[Number] = [sign * operate(f"grid_{axis}", *inside, found.grid) for axis in "xyz"]
    steepness2, cell2 = dot(slopes, slopes), found.spacing**2
    places, left = _places(rows, contact)
    for place, reference, end in places:
        forms = coordinates(rows, contact, place)
        leaves = [mechanism.leaf(mechanism.component(*form)) for form in forms]
        drawn = mechanism.default(as_drawn(mechanism, value, leaves))
        # What is drawn to touch the mesh is not refused for the error of the grid.
        free = value - drawn if -found.largest_error <= drawn < 0.0 else value
        gap = free * sqrt((free * free + cell2) / (free * free + cell2 * steepness2))
        add_implicit(rows, contact, reference, forms, gap, slopes, end, _up(rows, contact))
    corners, triangles = scaled(contact.file, contact.scale)
    size = float((corners.max(axis=0) - corners.min(axis=0)).max())
    rows.parts.meshes[rows.name] = {
        "file": contact.file.name, "triangles": len(triangles),
        "resolution": found.spacing, "cells": found.cells, "size": size,
        "largest_error": found.largest_error, "mean_error": found.mean_error,
        "points": len(places), "corners_left": left,
    }  # fmt: skip


def _places(
    rows: Rows, contact: MeshContact
) -> tuple[list[tuple[Combination, PointReference, str]], float]:
    """What touches the mesh, and the largest way from a corner that was left out to one of them."""
    parts, left = rows.parts, 0.0
    if contact.point is not None:
        return [(parts.place(contact.point), contact.point, "")], left
    if contact.points:
        return [(parts.place(x), x, f" at {x.point}") for x in contact.points], left
    frame, corners = parts.frames[contact.part], contact.corners
    assert isinstance(frame, RigidFrame)
    if contact.corner_file is not None:
        places, left = spread(scaled(contact.corner_file, contact.scale)[0], contact.most_corners)
        corners = tuple(tuple(map(float, place)) for place in places)
    owner = PointReference(point=contact.part)
    named = ((frame.at(x), owner, f" at corner {k}") for k, x in enumerate(corners, 1))
    return [*named], left


def _up(rows: Rows, contact: MeshContact) -> Vector:
    """Direction against gravity, in axes of the mesh as drawn; empty without gravity."""
    default = rows.mechanism.default
    gravity = tuple(map(default, rows.parts.scene.gravity))
    if not any(gravity):
        return ()
    axes = rows.parts.frame(contact.body).axes
    return unit(tuple(-default(dot(axis, gravity)) for axis in axes))


def accuracy(name: str, mesh: dict) -> Iterator[str]:
    """Yield a sentence about distances that are far from those of the mesh."""
    error, size = mesh["largest_error"], mesh["size"]
    if error > WORST * size:
        yield (
            f"contact '{name}': distances to the mesh '{mesh['file']}' are up to {error:.2g} m "
            f"from exact ones, {100 * error / size:.2g} % of its size; a resolution below "
            f"{mesh['resolution']:.2g} m makes them more exact"
        )


MESHES = {MeshContact: add_mesh}
