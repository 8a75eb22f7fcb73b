"""A scene becomes a mechanism: every part adds its nodes, rows and forces, in a fixed order."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from graphlib import TopologicalSorter

from solver.mechanics.bodies import add_bar, add_point, add_rigid, demand_masses
from solver.mechanics.combination import node
from solver.mechanics.couplings import (
    add_angle,
    add_constraint,
    add_gear,
    add_point_on,
    add_point_on_surface,
    add_rack,
    add_rod,
    add_rolling,
)
from solver.mechanics.drivers import add_driver, driven_points
from solver.mechanics.equations import FREE
from solver.mechanics.forces import add_force
from solver.mechanics.formulas import Compiler
from solver.mechanics.joints import add_joint
from solver.mechanics.mechanism import Mechanism
from solver.mechanics.parts import Parts
from solver.mechanics.vectors import Vector
from solver.scene import (
    Bar,
    BodyJoint,
    ConstantAngle,
    Distance,
    ExpressionError,
    Gear,
    Joint,
    PointOnLine,
    PointOnPlane,
    PointOnSurface,
    PointReference,
    Rack,
    Rolling,
    Scene,
    evaluate,
    symbols,
)


def collect(scene: Scene) -> Parts:
    """Return the parts of a scene, with the mechanism that they make up.

    Raises
    ------
    SceneError
        Where a part does not fit another one.
    """
    parts = Parts(scene, Mechanism(scene.dimension, _defaults(scene), _varying(scene)))
    compiler = Compiler(parts)
    _add_points_and_bodies(parts)
    first = [*scene.joints.items()]
    for name, joint in sorted(first, key=lambda item: isinstance(item[1], Gear | Rack)):
        _guarded(parts, f"joints.{name}", lambda n=name, j=joint: _add_joint(parts, compiler, n, j))
    for name, constraint in scene.constraints.items():
        _guarded(
            parts, f"constraints.{name}",
            lambda n=name, c=constraint: add_constraint(parts, compiler, n, c),
        )  # fmt: skip
    for name, force in scene.forces.items():
        _guarded(parts, f"forces.{name}", lambda n=name, f=force: add_force(parts, compiler, n, f))
    for name, driver in scene.drivers.items():
        _guarded(parts, f"drivers.{name}", lambda n=name, d=driver: add_driver(parts, n, d))
    _check_rows(parts)
    if parts.problems:
        scene.fail(scene.error(location, text) for location, text in parts.problems)
    return parts


def _guarded(parts: Parts, location: str, add) -> None:
    """Add a part; a formula that has no place in a mechanism is a mistake of the scene."""
    try:
        add()
    except ExpressionError as error:
        parts.problems.append((location, error.message))


def _defaults(scene: Scene) -> dict[str, float]:
    values = {name: given.start for name, given in scene.inputs.items()}
    values["t"] = scene.experiment.start_time
    numbers = {name: parameter.value for name, parameter in scene.parameters.items()}
    uses = {name: sorted(symbols(x) & numbers.keys()) for name, x in numbers.items()}
    for name in TopologicalSorter(uses).static_order():
        values[name] = float(evaluate(numbers[name], values))
    return values


def _varying(scene: Scene) -> frozenset[str]:
    tunable = (name for name, p in scene.parameters.items() if p.variability == "tunable")
    return frozenset(["t", *scene.inputs, *tunable])


def _add_points_and_bodies(parts: Parts) -> None:
    mechanism, scene = parts.mechanism, parts.scene
    parts.paths = driven_points(scene)
    for name, point in scene.points.items():
        path = parts.paths[name][1] if name in parts.paths else None
        parts.points[name] = add_point(mechanism, name, point, path)
    places = _places_of_bodies(scene)
    for name, body in scene.bodies.items():
        if isinstance(body, Bar):
            frame = add_bar(mechanism, name, body, parts.points)
            first, second = frame.ends
            parts.links[name] = node(second) - node(first)
            if scene.dimension == 2:
                parts.frames[name] = frame
        else:
            parts.frames[name] = add_rigid(mechanism, name, body, places[name])
    demand_masses(mechanism, parts.points)


def _places_of_bodies(scene: Scene) -> defaultdict[str | None, list[Vector]]:
    """Global positions, as drawn, where something is joined to each body."""
    places: defaultdict[str | None, list[Vector]] = defaultdict(list)
    for joint in scene.joints.values():
        if isinstance(joint, BodyJoint) and joint.bodies and joint.position:
            for body in joint.bodies:
                places[body].append(joint.position)
    for reference in _references(scene):
        if reference.at is not None:
            places[reference.point].append(reference.at)
    return places


def _references(scene: Scene) -> Iterator[PointReference]:
    for part in (*scene.joints.values(), *scene.forces.values(), *scene.drivers.values()):
        yield from getattr(part, "points", None) or ()
        point = getattr(part, "point", None)
        if point is not None:
            yield point


def _add_joint(parts: Parts, compiler: Compiler, name: str, joint: Joint) -> None:
    match joint:
        case Distance():
            add_rod(parts, name, joint)
        case BodyJoint():
            add_joint(parts, name, joint)
        case PointOnSurface():
            add_point_on_surface(parts, compiler, name, joint)
        case PointOnLine() | PointOnPlane():
            add_point_on(parts, name, joint)
        case ConstantAngle():
            add_angle(parts, name, joint)
        case Gear():
            add_gear(parts, name, joint)
        case Rack():
            add_rack(parts, name, joint)
        case Rolling():
            add_rolling(parts, name, joint)


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
