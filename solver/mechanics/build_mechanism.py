"""A scene becomes a mechanism: every part adds its nodes, rows and forces, in a fixed order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from solver.mechanics.bodies import add_bar, add_point, add_rigid
from solver.mechanics.combination import node
from solver.mechanics.contacts import CONTACTS
from solver.mechanics.couplings import COUPLINGS, driven_points
from solver.mechanics.ellipsoids import ELLIPSOIDS
from solver.mechanics.forces import FORCES
from solver.mechanics.formulas import sensed
from solver.mechanics.joints import JOINTS, add_joint
from solver.mechanics.mechanism import FREE, Held, Mechanism
from solver.mechanics.meshes import MESHES
from solver.mechanics.parts import JointParts, Parts
from solver.mechanics.rows import Rows
from solver.mechanics.shapes import SHAPES
from solver.mechanics.surfaces import SURFACES
from solver.scene import Bar, ExpressionError, Gear, Rack, Scene
from solver.scene.body_sizes import PLACED, places_of_bodies, squared_sizes
from solver.scene.expression import symbol
from solver.scene.states import sampled_states

ADD: dict[type, Callable[[Rows, Any, JointParts], None]] = {
    **dict.fromkeys(JOINTS, add_joint), **COUPLINGS, **CONTACTS, **SURFACES, **SHAPES, **ELLIPSOIDS,
    **MESHES, **FORCES,
}  # fmt: skip


def build_mechanism(scene: Scene) -> Parts:
    """Return the parts of a scene, with the mechanism that they make up.

    Raises
    ------
    SceneError
        Where a part does not fit another one.
    """
    parts = Parts(scene, Mechanism(scene.dimension, scene.values(), _varying(scene)))
    _add_points_and_bodies(parts)
    for table in ("joints", "constraints", "contacts", "forces", "drivers"):
        items = getattr(scene, table).items()
        for name, part in sorted(items, key=lambda item: isinstance(item[1], Gear | Rack)):
            rows, found = Rows(parts, table, name), JointParts()
            if table not in ("contacts", "forces"):
                parts.joints[name] = found
            if table != "drivers":
                rows.demand(part)
            try:
                ADD[type(part)](rows, part, found)
            except ExpressionError as error:  # a formula that has no place in a mechanism
                rows.problem(error.message)
    _add_states(parts)
    _check_rows(parts)
    if parts.problems:
        scene.fail(scene.error(location, text) for location, text in parts.problems)
    return parts


def _varying(scene: Scene) -> frozenset[str]:
    tunable = (name for name, p in scene.parameters.items() if p.variability == "tunable")
    states = (name for name, *_ in sampled_states(scene.states))
    return frozenset(["t", *scene.inputs, *tunable, *states])


def _add_states(parts: Parts) -> None:
    demanded: set[str] = set()
    for _, owner, state, found in sampled_states(parts.scene.states):
        rows = Rows(parts, "states", owner)
        if owner not in demanded:
            rows.demand(state)
            demanded.add(owner)
        clock = (symbol("t") - state.offset) / state.sample_time
        following = sensed(parts, found.next, by_laws=False)
        parts.mechanism.held.append(Held(following, found.start, clock))


def _add_points_and_bodies(parts: Parts) -> None:
    mechanism, scene = parts.mechanism, parts.scene
    parts.paths = driven_points(scene)
    for name, point in scene.points.items():
        path = parts.paths[name][1] if name in parts.paths else None
        rows = Rows(parts, "points", name)
        rows.demand(point)
        parts.points[name] = add_point(rows, point, path)
    tables = {name: getattr(scene, name) for name in PLACED}
    sizes2 = squared_sizes(tables, places_of_bodies(tables), mechanism.default)
    for name, body in scene.bodies.items():
        rows = Rows(parts, "bodies", name)
        rows.demand(body)
        try:
            if isinstance(body, Bar):
                frame = add_bar(rows, body)
                first, second = frame.ends
                parts.links[name] = node(second) - node(first)
                if scene.dimension == 2:
                    parts.frames[name] = frame
            else:
                parts.frames[name] = add_rigid(rows, body, sizes2[name])
        except ExpressionError as error:
            text = f"a number of it has no finite value: {error.message}"
            scene.fail([scene.error(rows.location, f"{text}; look for a very large or small one")])
    for name, index in parts.points.items():
        if mechanism.nodes[index].motion == FREE:
            text = "mass must be > 0 kg, with the bars that end at it"
            Rows(parts, "points", name).rule(mechanism.nodes[index].mass, ">", text)


def _check_rows(parts: Parts) -> None:
    """Report rows in which nothing can move: no multiplier could change them."""
    mechanism = parts.mechanism
    found = {
        row.row.location: None
        for rows in (
            mechanism.form_rows, mechanism.coincidences, mechanism.function_rows,
            mechanism.velocity_rows,
        )
        for row in rows
        if not any(mechanism.nodes[n].motion == FREE for n in mechanism.joined(row))
    }  # fmt: skip
    parts.problems.extend((location, "joins only parts that cannot move") for location in found)
