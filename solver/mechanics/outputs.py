"""The names of all that is measured, in the order in which a user finds them.

Most are numbers that the kernel measures. What it does not - the torque and power of a driver, the
force that belongs to a formula - is an expression over those (``reactions``).
"""

from __future__ import annotations

from collections.abc import Iterator

from solver.mechanics.combination import Combination
from solver.mechanics.frames import RigidFrame
from solver.mechanics.reactions import of_a_driver, of_a_force, reaction
from solver.mechanics.sensors import Measures, Named, Ref, components, references
from solver.scene import Rigid

ENERGIES = {
    "kinetic": "kinetic energy",
    "potential": "energy of gravity, springs and potentials",
    "total": "kinetic and potential energy",
    "work": "work done by forces, torques, drivers and inputs since the start",
    "dissipated": "energy taken out by dampers since the start",
    "balance": "total - initial - work + dissipated: zero up to round-off",
    "error": "size of the balance over the reference energy",
}

COUNTERS = {
    "newton_iterations": "Newton iterations of the last communication step",
    "uzawa_iterations": "Uzawa updates of the last communication step",
    "substeps": "implicit steps solved in the last communication step",
    "order_in_use": "order of the last internal step, 0 before it",
    "sampling": "for forces that read the motion: part of their work that they missed, as they "
    "are evaluated once in a half step; above 1 the step is too long",
    "status": "0 after a solved step, else the code of what failed",
}


def named(measures: Measures) -> Iterator[Named]:
    """Everything of a mechanism that has a name."""
    parts, scene = measures.parts, measures.parts.scene
    for name in scene.points:
        yield from _motion(measures, name, parts.named(name))
    for name, body in scene.bodies.items():
        yield from _body(measures, name, isinstance(body, Rigid))
    for name, joint in scene.joints.items():
        yield from _joint_motion(measures, name)
        yield from reaction(measures, name, joint)
    for name in scene.constraints:
        row = parts.joints[name].row
        assert row is not None
        text = f"multiplier of {name}: its force is -multiplier times its gradient"
        yield Named(f"{name}.multiplier", "", text, measures.ref(row))
    for name, force in scene.forces.items():
        yield from of_a_force(measures, name, force)
    for name, driver in scene.drivers.items():
        yield from of_a_driver(measures, name, driver)
    yield from _whole(parts.mechanism.dim)


def _motion(measures: Measures, name: str, place: Combination) -> Iterator[Named]:
    """Position and velocity of a place."""
    x, v = measures.motion(place)
    listed = measures.parts.mechanism.moves(place)
    yield from components(f"{name}.", "m", f"position of {name}", x, listed)
    yield from components(f"{name}.v", "m/s", f"velocity of {name}", v, listed)


def _body(measures: Measures, name: str, rigid: bool) -> Iterator[Named]:
    parts, mechanism = measures.parts, measures.parts.mechanism
    frame = parts.frames.get(name)
    if rigid:
        yield from _motion(measures, name, parts.named(name))
    if mechanism.dim == 2:
        angle = parts.body_angle(name)
        assert angle is not None
        text = f"angle of {name} from the x axis, unwrapped"
        yield Named(f"{name}.angle", "rad", text, Ref("quantity", angle))
        rate = Ref("quantity_rate", angle)
        yield Named(f"{name}.angular_velocity", "rad/s", f"angular velocity of {name}", rate)
    elif isinstance(frame, RigidFrame):
        body = mechanism.bodies[frame.directors[0]]
        for k, axis in enumerate("wxyz"):
            text = f"quaternion of {name}, {axis}, of continuous sign"
            yield Named(f"{name}.q{axis}", "1", text, Ref("quaternion", body, k))
        rates = references("body_rate", body, 3)
        yield from components(f"{name}.w", "rad/s", f"angular velocity of {name}", rates)
    for point in frame.points if isinstance(frame, RigidFrame) else ():
        yield from _motion(measures, f"{name}.{point}", parts.named(f"{name}.{point}"))


def _joint_motion(measures: Measures, name: str) -> Iterator[Named]:
    found = measures.parts.joints[name]
    if found.angle is not None:
        text = f"angle of {name}, zero as drawn, unwrapped"
        yield Named(f"{name}.angle", "rad", text, Ref("quantity", found.angle))
        rate = Ref("quantity_rate", found.angle)
        yield Named(f"{name}.angular_velocity", "rad/s", f"angular velocity of {name}", rate)
    if found.displacement is not None:
        text = f"displacement of {name}, zero as drawn"
        yield Named(f"{name}.displacement", "m", text, Ref("quantity", found.displacement))
        rate = Ref("quantity_rate", found.displacement)
        yield Named(f"{name}.velocity", "m/s", f"velocity along {name}", rate)


def _whole(dim: int) -> Iterator[Named]:
    """Energies, residuals, momenta and counters."""
    for k, (name, text) in enumerate(ENERGIES.items()):
        yield Named(f"energy.{name}", "1" if name == "error" else "J", text, Ref("energy", k))
    text = "largest constraint residual over the size of its row"
    yield Named("constraint.position", "1", text, Ref("residual", 0))
    text = (
        "largest rate of a constraint residual over the size of its row; a discretization error, "
        "which at order 2 falls with the square of the step"
    )
    yield Named("constraint.velocity", "1/s", text, Ref("residual", 1))
    momentum = [Ref("momentum", k) for k in range(dim)]
    yield from components("momentum.", "kg.m/s", "linear momentum", momentum)
    turning = [Ref("angular_momentum", k) for k in range(1 if dim == 2 else 3)]
    text = "angular momentum about the origin"
    yield from components("angular_momentum.", "kg.m2/s", text, turning)
    for k, (name, text) in enumerate(COUNTERS.items()):
        yield Named(f"solver.{name}", "1", text, Ref("solver", k))
