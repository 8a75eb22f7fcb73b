"""Compliant contacts: masses on buffers, pins in soft bearings, balls on each other, ropes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from tests.truth.minimal import dop853
from tests.truth.system import Array, System, Values

G = 9.81
Rates = Callable[[float, Array, Sequence[bool]], Sequence[float]]


def _pieces(
    rates: Rates, sides: Sequence[Callable[[Array], float]], start: Sequence[float], times: Array
) -> Array:
    """Values at the times of y' = rates(t, y, negative), integrated between the zeros of `sides`.

    `negative` tells which of the sides are, all through a piece.
    """
    t, y, stop, found = 0.0, np.array(start, dtype=float), float(times[-1]), [np.array(start)]
    negative = [side(y) < 0.0 for side in sides]
    while len(found) < len(times):
        events = []
        for side, below in zip(sides, negative, strict=True):

            def crosses(_: float, y: Array, side: Callable[[Array], float] = side) -> float:
                return side(y)

            crosses.terminal, crosses.direction = True, 1 if below else -1  # type: ignore[attr-defined]
            events.append(crosses)
        piece = dop853(
            lambda t, y, negative=tuple(negative): rates(t, y, negative), (t, stop), y, least=1e-16,
            events=events, dense_output=True, max_step=stop / 50,
        )  # fmt: skip
        t, y = float(piece.t[-1]), piece.y[:, -1]
        while len(found) < len(times) and times[len(found)] <= t:
            found.append(piece.sol(times[len(found)]))
        negative = [
            x != bool(len(at)) for x, at in zip(negative, piece.t_events, strict=True)
        ]  # one that is met is on the other side
    return np.array(found)


def _push(K: float, n: float, c: float, depth: float, rate: float) -> float:
    """Force of Hunt and Crossley, which never pulls."""
    return K * max(depth, 0.0) ** n * max(1.0 + c * rate, 0.0)


def _buffer(
    name: str, law: str, n: float, c: float, *, g: float = G, stop: float = 1.0, points: int = 40
) -> System:
    """Mass against a compliant plane: m d'' = m g - K d^n (1 + c d')."""
    m, K, speed, gap = 1.1, 2e4, 0.8, 0.01
    text = f"""
        dimension = 2
        gravity = [0, {-g}]
        [points]
        A = {{ position = [0, {gap}], velocity = [0, {-speed}], mass = {m} }}
        [contacts]
        c = {{ type = "plane", point = "A", axis = [0, 1], stiffness = {K}, {law} }}
    """

    def rates(_: float, y: Array, pressed: Sequence[bool]) -> list[float]:
        return [y[1], pressed[0] * _push(K, n, c, -y[0], -y[1]) / m - g]

    def right(t: Array) -> Values:
        found = _pieces(rates, [lambda y: y[0]], [gap, -speed], t)
        return {"A.y": found[:, 0], "A.vy": found[:, 1]}

    return System(
        name=name, kind="impacts", origin="DOP853 between gaps of 0", scene=text, stop=stop,
        points=points, right=right, orders=(), scale={"length": gap},
    )  # fmt: skip


def _pulled_off() -> System:
    """Mass that is pulled off its buffer faster than 1/c, where damping would hold it back."""
    m, K, c, speed, gap, pull, at = 1.1, 2e4, 3.0, 0.8, 0.01, 400.0, 0.028
    text = f"""
        dimension = 2
        [points]
        A = {{ position = [0, {gap}], velocity = [0, {-speed}], mass = {m} }}
        [contacts]
        c = {{ type = "plane", point = "A", axis = [0, 1], stiffness = {K}, law = "hunt-crossley", damping = {c} }}
        [forces]
        f = {{ type = "force", point = "A", value = [0, "{pull} if t > {at} else 0"] }}
    """

    def rates(_: float, y: Array, below: Sequence[bool]) -> list[float]:
        pressed, lets_go, waits = below
        push = _push(K, 1.5, c, -y[0], -y[1]) if pressed and not lets_go else 0.0
        return [y[1], (push + pull * (not waits)) / m, 1.0]

    def right(t: Array) -> Values:
        sides = [lambda y: y[0], lambda y: 1.0 - c * y[1], lambda y: y[2] - at]
        found = _pieces(rates, sides, [gap, -speed, 0.0], t)
        return {"A.y": found[:, 0], "A.vy": found[:, 1]}

    return System(
        name="pulled_off_a_buffer", kind="impacts", scene=text, stop=0.06, points=12, right=right,
        origin="DOP853 between gaps of 0, where it lets go and where the pull begins", orders=(),
    )  # fmt: skip


def _soft_bearing(c: float) -> System:
    """Pin in a hole of 10 mm, under its weight: the force is along the line of centres."""
    m, K, R = 0.5, 1e6, 0.01
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        O = {{ position = [0, 0], fixed = true }}
        A = {{ position = [0.002, 0.001], velocity = [0.3, 0.1], mass = {m} }}
        [contacts]
        c = {{ type = "clearance", points = ["A", "O"], radius = {R}, stiffness = {K}, law = "hunt-crossley", damping = {c} }}
    """

    def rates(_: float, y: Array, pressed: Sequence[bool]) -> list[float]:
        r = math.hypot(y[0], y[1])
        force = _push(K, 1.5, c, r - R, (y[:2] @ y[2:]) / r) if pressed[0] else 0.0
        return [*y[2:], -force / m * y[0] / r, -force / m * y[1] / r - G]

    def right(t: Array) -> Values:
        found = _pieces(rates, [lambda y: R - math.hypot(y[0], y[1])], [0.002, 0.001, 0.3, 0.1], t)
        return dict(zip(("A.x", "A.y", "A.vx", "A.vy"), found.T, strict=True))

    return System(
        name="pin_in_a_soft_bearing", kind="impacts", origin="DOP853 between gaps of 0", scene=text,
        stop=0.3, points=30, right=right, orders=(),
    )  # fmt: skip


def _stack(c: float) -> System:
    """Ball that falls on another one, which falls on the ground."""
    m1, m2, r1, r2, K1, K2 = 1.0, 0.6, 0.1, 0.08, 1e6, 8e5
    start = [r1 + 0.02, 2 * r1 + r2 + 0.05, 0.0, -0.3]
    law = f'law = "hunt-crossley", damping = {c}'
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        A = {{ position = [0, {start[0]}], mass = {m1} }}
        B = {{ position = [0, {start[1]}], velocity = [0, {start[3]}], mass = {m2} }}
        [contacts]
        floor = {{ type = "plane", point = "A", axis = [0, 1], radius = {r1}, stiffness = {K1}, {law} }}
        pair = {{ type = "sphere", points = ["A", "B"], radii = [{r1}, {r2}], stiffness = {K2}, {law} }}
    """

    def rates(_: float, y: Array, pressed: Sequence[bool]) -> list[float]:
        floor = pressed[0] * _push(K1, 1.5, c, r1 - y[0], -y[2])
        pair = pressed[1] * _push(K2, 1.5, c, r1 + r2 - (y[1] - y[0]), y[2] - y[3])
        return [y[2], y[3], (floor - pair) / m1 - G, pair / m2 - G]

    def right(t: Array) -> Values:
        sides = [lambda y: y[0] - r1, lambda y: y[1] - y[0] - r1 - r2]
        found = _pieces(rates, sides, start, t)
        return dict(zip(("A.y", "B.y", "A.vy", "B.vy"), found.T, strict=True))

    return System(
        name="stack_of_soft_balls", kind="impacts", origin="DOP853 between gaps of 0", scene=text,
        stop=0.5, points=25, right=right, orders=(),
    )  # fmt: skip


def _elastic_rope() -> System:
    """Mass on a rope that pulls and does not push: m x'' = -k (|x| - l) x/|x| beyond l."""
    m, k, length, x0, v0 = 0.7, 300.0, 0.5, [0.3, 0.1], [1.2, 0.8]
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        O = {{ position = [0, 0], fixed = true }}
        A = {{ position = {x0}, velocity = {v0}, mass = {m} }}
        [forces]
        rope = {{ type = "spring", points = ["O", "A"], energy = "{k / 2}*max(length - {length}, 0)**2" }}
    """

    def rates(_: float, y: Array, loose: Sequence[bool]) -> list[float]:
        r = math.hypot(y[0], y[1])
        pull = 0.0 if loose[0] else k * (r - length)
        return [*y[2:], -pull / m * y[0] / r, -pull / m * y[1] / r - G]

    def right(t: Array) -> Values:
        found = _pieces(rates, [lambda y: math.hypot(y[0], y[1]) - length], [*x0, *v0], t)
        return dict(zip(("A.x", "A.y", "A.vx", "A.vy"), found.T, strict=True))

    return System(
        name="mass_on_an_elastic_rope", kind="impacts", origin="DOP853 between tight and loose",
        scene=text, stop=1.5, points=15, right=right, orders=(),
    )  # fmt: skip


HUNT_CROSSLEY = 'law = "hunt-crossley", damping = 0.4'
SYSTEMS = (
    _buffer("hertz_buffer", 'law = "hertz"', 1.5, 0.0, g=0.0, stop=0.12, points=9),
    _buffer("hunt_crossley_buffer", HUNT_CROSSLEY, 1.5, 0.4, g=0.0, stop=0.12, points=9),
    _buffer("hunt_crossley_bounces", HUNT_CROSSLEY, 1.5, 0.4),
    _buffer("linear_bounces", 'law = "hunt-crossley", damping = 0.2, exponent = 1', 1.0, 0.2),
    _buffer("lankarani_nikravesh_bounces",
            'law = "lankarani-nikravesh", restitution = 0.8, impact_speed = 0.8',
            1.5, 0.75 * (1 - 0.8**2) / 0.8),
    _pulled_off(),
    _soft_bearing(0.2),
    _stack(0.1),
    _elastic_rope(),
)  # fmt: skip
