"""Small mechanisms written by hand, which together use every part of a model."""

from __future__ import annotations

import numpy as np

from tests.hand_models import Hand, Node, Place

TIME: Place = ("time", 0)


def axes(hand: Hand) -> list[Node]:
    """The ground's axes."""
    return [hand.fixed(row, direction=True) for row in np.eye(hand.dim).tolist()]


def angle_of(hand: Hand, d: Node, ground: list[Node]) -> int:
    """Angle of a planar body from the x axis."""
    x, y = (hand.form({d: 1.0}, {axis: 1.0}) for axis in ground)
    return hand.quantity(2, x, y)


def planar_body(**numbers: float) -> Hand:
    """A body of 2 kg on a pivot, with a torsion spring, damper, drive and a load that turns."""
    hand = Hand(2, [0.0, -9.81])
    pivot, ground = hand.fixed([0.2, 0.1]), axes(hand)
    r, d = hand.body([1.2, 0.1], [0.3], mass=2.0, velocity=[0.0, 1.0], rate=1.0)
    hand.coincidence(hand.form({r: 1.0, d: (-1.0, 0.0), pivot: -1.0}, {}))
    law = {"stiffness": 3.0, "rest": 0.5, "damping": 0.2, "drive": 1.0} | numbers
    hand.element(angle_of(hand, d, ground), **law)
    tip = hand.form({r: 1.0, d: (0.3, 0.4)}, {})
    hand.place(tip)
    hand.load(tip, [1.0, 2.0], axes=d)
    hand.tables["moment_form"].append(hand.form({d: 1.0}))
    hand.numbers["moment"].append(0.7)
    return hand


def heavy_top() -> Hand:
    """The heavy top of Simo and Wong, 1991: A = 5, C = 1 kg m^2 about its tip, 50 rad/s."""
    hand = Hand(3, [0.0, 0.0, -20.0])
    tip, (c, s) = hand.fixed([0.0, 0.0, 0.0]), (np.cos(0.05), np.sin(0.05))
    R = np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
    rate, r = 50.0 * R[:, 2], R[:, 2]
    velocity = np.cross(rate, r).tolist()
    nodes = hand.body(r.tolist(), [0.5, 0.5, 3.5], R=R, velocity=velocity, rate=rate)
    hand.coincidence(hand.form({nodes[0]: 1.0, nodes[3]: -1.0, tip: -1.0}, {}))
    hand.tables["body_node"] = [nodes[1]]
    return hand


def functions() -> Hand:
    """Geared bodies, a body that slides on a sine and rolls along, and a potential between them."""
    hand = Hand(2, [0.0, -9.81])
    pivots, ground = [hand.fixed([0.0, 0.0]), hand.fixed([1.5, 0.0])], axes(hand)
    r1, d1 = hand.body([0.3, 0.0], [0.3], mass=2.0, velocity=[0.0, 0.3], rate=1.0)
    r2, d2 = hand.body([1.5, 0.0], [0.2], rate=-0.5)
    r3, d3 = hand.body([0.0, 2.0], [0.2], velocity=[0.4, 0.4], rate=-1.0)
    hand.coincidence(hand.form({r1: 1.0, d1: -0.3, pivots[0]: -1.0}, {}))
    hand.coincidence(hand.form({r2: 1.0, pivots[1]: -1.0}, {}))
    first, second, third = (angle_of(hand, d, ground) for d in (d1, d2, d3))
    x, y = (hand.quantity(0, hand.form({r3: 1.0}, {axis: 1.0})) for axis in ground)
    gap = hand.quantity(1, hand.form({r3: 1.0, r1: -1.0}))
    two, radius, three = (hand.constant(value) for value in (2.0, 0.4, 3.0))
    gear = [("mul", 1, two), ("add", 0, 2)]
    hand.function("row", [(0, first), (0, second)], gear)
    curve = [("sin", 1), ("sub", 0, 2), ("sub", 3, two)]
    hand.function("row", [(0, y), (0, x)], curve, power=1)
    roll = [("mul", 1, radius), ("add", 0, 2)]
    hand.function("velocity", [(1, x), (1, third)], roll, power=1)
    law = [("neg", 0), ("exp", 2), ("mul", 3, three), ("cos", 1), ("add", 4, 5)]
    hand.function("potential", [(0, gap), (0, first)], law)
    hand.element(gap, stiffness=5.0, rest=1.0, damping=0.3)
    return hand


def slider_crank() -> Hand:
    """A crank pin driven on a circle at 3 rad/s, a rod and a slider on the x axis, and a spring."""
    hand = Hand(2, [0.0, -9.81])
    origin, (_, up) = hand.fixed([0.0, 0.0]), axes(hand)
    pin, slider = hand.driven(0.36), hand.free([0.45, 0.0], [0.0, 0.0], 0.075)
    hand.row(hand.form({slider: 1.0, pin: -1.0}), 0.09, 0.09)
    hand.row(hand.form({slider: 1.0}, {up: 1.0}), 0.0, 1.0, 1)
    hand.masses[pin, slider] = hand.masses[slider, pin] = 0.02
    turned, radius = hand.let("signals", "mul", hand.constant(0.0), TIME, hand.constant(3.0)), 0.15
    for name in ("cos", "sin"):
        share = hand.let("signals", name, hand.constant(0.0), turned)
        hand.signal(hand.let("signals", "mul", hand.constant(0.0), share, hand.constant(radius)))
    hand.element(
        hand.quantity(1, hand.form({slider: 1.0, origin: -1.0})),
        stiffness=20.0, rest=0.2, damping=0.5,
    )  # fmt: skip
    return hand


def driven_angle() -> Hand:
    """A body of 2 kg on a pivot whose angle is prescribed, 0.3 sin(2 t)."""
    hand = Hand(2, [0.0, -9.81])
    pivot, ground = hand.fixed([0.0, 0.0]), axes(hand)
    r, d = hand.body([1.0, 0.0], [0.3], mass=2.0, velocity=[0.0, 0.6], rate=0.6)
    hand.coincidence(hand.form({r: 1.0, d: -1.0, pivot: -1.0}, {}))
    phase = hand.let("signals", "mul", hand.constant(0.0), TIME, hand.constant(2.0))
    share = hand.let("signals", "sin", hand.constant(0.0), phase)
    angle = hand.signal(hand.let("signals", "mul", hand.constant(0.0), share, hand.constant(0.3)))
    hand.function("row", [(0, angle_of(hand, d, ground)), (2, angle)], [("sub", 0, 1)])
    return hand


def sensed() -> Hand:
    """A point on a spring, with a drive of -2 times its rate plus an input that ramps."""
    hand = Hand(2)
    point, origin = hand.free([1.0, 0.0], [0.0, 0.5]), hand.fixed([0.0, 0.0])
    gap = hand.quantity(1, hand.form({point: 1.0, origin: -1.0}))
    hand.element(gap)
    hand.element(gap, stiffness=4.0, rest=0.7)
    hand.inputs, hand.tables["input_ramp"] = [1.0], [1]
    damper = hand.let("laws", "mul", hand.constant(0.0), ("sensor_rate", 0), hand.constant(-2.0))
    hand.let("laws", "add", ("drive", 0), damper, ("input", 0))
    hand.flags = {"sensing": 1, "time_dependent": 1}
    return hand


def ramped_slider(dim: int = 2) -> Hand:
    """A pin driven along x by an input that ramps, a rod and a slider on the y axis."""
    hand = Hand(dim, [0.0] * (dim - 1) + [-9.81])
    ground = axes(hand)
    still = [0.0] * (dim - 2)
    pin, slider = hand.driven(0.36), hand.free([0.0, 0.4, *still], mass=0.5)
    hand.row(hand.form({slider: 1.0, pin: -1.0}), 0.25, 0.25)
    for axis in (ground[0], *ground[2:]):
        hand.row(hand.form({slider: 1.0}, {axis: 1.0}), 0.0, 1.0, 1)
    hand.inputs, hand.tables["input_ramp"] = [0.3], [1]
    hand.signal(("input", 0))
    for _ in range(dim - 1):
        hand.signal(hand.constant(0.0))
    return hand


def turned(vector: list[float]) -> np.ndarray:
    """Rotation matrix of a rotation vector [rad]."""
    angle = float(np.linalg.norm(vector))
    x, y, z = np.array(vector) / angle
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K


def two_bodies(disorder: float = 0.0) -> Hand:
    """Bodies in space on a ball and a hinge, with loads, moments and a torsion spring.

    `disorder`: size of random changes of the drawn positions, and ten times that of velocities.
    """
    hand = Hand(3, [0.0, 0.3, -9.81])
    ground = hand.fixed([0.0, 0.0, 0.0])
    R, rate = turned([0.3, 0.2, -0.5]), np.array([1.0, -2.0, 0.7])
    R2, rate2 = turned([0.1, 0.9, 0.5]), rate + 3.0 * R[:, 2]
    center, hinge = R @ [0.5, 0.1, 0.0], R @ [1.0, 0.1, 0.0]
    center2 = hinge + R2 @ [0.4, 0.0, 0.0]
    speed2 = np.cross(rate, hinge) + np.cross(rate2, center2 - hinge)
    a = hand.body(
        center.tolist(), [0.2, 0.5, 0.4], mass=2.0, R=R, rate=rate,
        velocity=np.cross(rate, center).tolist(),
    )  # fmt: skip
    b = hand.body(center2.tolist(), [0.3, 0.1, 0.2], R=R2, rate=rate2, velocity=speed2.tolist())
    first = len(hand.tables["row_form"])
    axis = R2.T @ R[:, 2]
    across = np.cross(axis, [1.0, 0.0, 0.0]) / np.linalg.norm(np.cross(axis, [1.0, 0.0, 0.0]))
    for unit in (across, np.cross(axis, across)):
        hand.row(hand.form({a[3]: 1.0}, dict(zip(b[1:], unit, strict=True))), 0.0, 1.0)
    hand.coincidence(hand.form({a[0]: 1.0, a[1]: -0.5, a[2]: -0.1, ground: -1.0}, {}))
    hand.coincidence(hand.form({a[0]: 1.0, a[1]: 0.5, b[0]: -1.0, b[1]: 0.4}, {}))
    hand.tables["body_node"] = [a[1], b[1]]
    tip = hand.form({b[0]: 1.0, b[1]: 0.3, b[3]: 0.2}, {})
    hand.place(tip)
    hand.load(tip, [1.0, -2.0, 3.0], axes=b[1])
    hand.load(hand.form({a[0]: 1.0, a[3]: 0.2}, {}), [1.0, 0.0, 1.0])
    hand.tables["body_moment"] = [a[1], 0, b[1], 1]
    hand.numbers["body_moment"] = [0.5, 1.0, -0.3, 0.2, 0.4, 1.5]
    zero = dict(zip(b[1:], R2.T @ R[:, 0], strict=True))
    hinge_angle = hand.quantity(2, hand.form({a[1]: 1.0}, zero), hand.form({a[2]: 1.0}, zero))
    hand.element(hinge_angle, stiffness=2.0, damping=0.1, rest=0.3, drive=0.5)
    hand.tables["reaction_entry"] = [0, 0, 1, 1, 0, 2, first, 1, 0, 2, first + 1, 1]
    hand.flags["n_reactions"] = 1
    hand.disturb(disorder)
    return hand


def catenary(disorder: float = 0.0) -> Hand:
    """Four points of 1 kg on five rods of 0.8 m, hung 3 m apart."""
    hand = Hand(2, [0.0, -9.81])
    last, end = hand.fixed([0.0, 0.0]), hand.fixed([3.0, 0.0])
    for place in ([0.45, -0.66], [1.1, -1.13], [1.9, -1.13], [2.55, -0.66]):
        point = hand.free(place)
        hand.row(hand.form({point: 1.0, last: -1.0}), 0.64, 0.64)
        last = point
    hand.row(hand.form({end: 1.0, last: -1.0}), 0.64, 0.64)
    hand.disturb(disorder)
    return hand
