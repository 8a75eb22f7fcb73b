"""Closed loops: one or two freedoms whose closure is solved by geometry, planar and spatial."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tests.truth.minimal import (
    Body,
    Number,
    Parts,
    about,
    after,
    asin,
    atan2,
    cos,
    motion,
    sin,
    sqrt,
    turned,
    values,
)
from tests.truth.system import Array, System, Values
from tests.truth.tables import bar, hinge, pinned

G = 9.81


def _middle(a: float, x: Number | float, y: Number | float, c: Number, s: Number) -> tuple:
    return x + 0.5 * a * c, y + 0.5 * a * s


def _four_bar(
    name: str, lengths: Sequence[float], ground: float, start: float, rate: float, stop: float,
    spring: float = 0.0, **more: object,
) -> System:  # fmt: skip
    """Four-bar of heavy bars: coupler and rocker by the law of cosines, the crank's angle as q."""
    a, b, c = lengths
    masses, inertias = (1.0, 2.5, 0.7), (0.02, 0.3, 0.03)

    def angles(q: Number) -> tuple[Number, Number]:
        """Coupler's and rocker's angle; the elbow is above the diagonal."""
        x, y = ground - a * cos(q), -a * sin(q)
        diagonal2 = x * x + y * y
        diagonal = sqrt(diagonal2)
        at_coupler = (diagonal2 + (b * b - c * c)) / (2 * b * diagonal)
        inside = 0.5 * math.pi - asin(at_coupler)
        coupler = atan2(y, x) + inside
        tip = a * cos(q) + b * cos(coupler) - ground, a * sin(q) + b * sin(coupler)
        return coupler, atan2(tip[1], tip[0])

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        coupler, rocker = angles(q[0])
        pin = a * cos(q[0]), a * sin(q[0])
        bodies = [
            Body(masses[0], _middle(a, 0.0, 0.0, cos(q[0]), sin(q[0])), inertias[0], q[0]),
            Body(masses[1], _middle(b, *pin, cos(coupler), sin(coupler)), inertias[1], coupler),
            Body(masses[2], _middle(c, ground, 0.0, cos(rocker), sin(rocker)), inertias[2], rocker),
        ]
        energy = sum(G * body.mass * body.place[1] for body in bodies)
        return Parts(bodies, energy + 0.5 * spring * q[0] * q[0])

    drawn, drawn_rates = values(
        lambda n: [n[0], *angles(n[0])], np.array([[start]]), np.array([[rate]])
    )
    q0, q1, q2 = (float(x) for x in drawn[0])
    speeds = [float(x) for x in drawn_rates[0]]
    pin = a * math.cos(q0), a * math.sin(q0)
    at_pin = [-pin[1] * rate, pin[0] * rate]
    scene: dict[str, object] = {
        "dimension": 2,
        "gravity": [0, -G],
        "bodies": {
            "crank": bar(a, masses[0], inertias[0], 0, 0, q0, angular_velocity=rate),
            "coupler": bar(
                b, masses[1], inertias[1], *pin, q1, angular_velocity=speeds[1], velocity=at_pin
            ),
            "rocker": bar(c, masses[2], inertias[2], ground, 0, q2, angular_velocity=speeds[2]),
        },
        "joints": {
            "A": pinned("ground", "crank.a", at=[0, 0]),
            "B": pinned("crank.e", "coupler.a"),
            "C": pinned("coupler.e", "rocker.e"),
            "D": pinned("ground", "rocker.a", at=[ground, 0]),
        },
    }
    if spring:
        # At the crank, whose spring is free where the crank points along +x.
        scene["forces"] = {"s": {"type": "potential", "value": f"{spring / 2}*crank.angle**2"}}

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [start], [rate], t)
        found, rates = values(lambda n: [n[0], *angles(n[0])], q, v)
        names = ("crank", "coupler", "rocker")
        turns = {f"{x}.angle": np.unwrap(found[:, i]) for i, x in enumerate(names[:1])}
        return turns | {f"{x}.angular_velocity": rates[:, i] for i, x in enumerate(names)}

    return System(
        name=name, kind="loops", origin="DOP853 in the crank's angle, law of cosines",
        scene=scene, stop=stop, right=right, settings={"assemble": True},
        **more,
    )  # fmt: skip


def _slider_crank(offset: float, name: str, **more: object) -> System:
    """Crank, rod and slider on a line off the axis, a spring and a damper at the slider."""
    a, b, k, d, far = 0.25, 0.7, 400.0, 3.0, 0.6
    masses, inertias = (1.2, 0.8, 1.5), (0.015, 0.04, 0.01)
    start, rate = 0.7, 6.0

    def rod(q: Number) -> Number:
        return asin((offset - a * sin(q)) / b)

    def slider(q: Number) -> Number:
        return a * cos(q) + b * cos(rod(q))

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        lean, x = rod(q[0]), slider(q[0])
        pin = a * cos(q[0]), a * sin(q[0])
        bodies = [
            Body(masses[0], _middle(a, 0.0, 0.0, cos(q[0]), sin(q[0])), inertias[0], q[0]),
            Body(masses[1], _middle(b, *pin, cos(lean), sin(lean)), inertias[1], lean),
            Body(masses[2], (x, offset)),
        ]
        energy = G * (masses[0] * bodies[0].place[1] + masses[1] * bodies[1].place[1])
        energy = energy + 0.5 * k * (x - far) ** 2
        return Parts(bodies, energy, torques=-d * x.rate * x.gradient)

    drawn, speeds = values(
        lambda n: [rod(n[0]), slider(n[0])], np.array([[start]]), np.array([[rate]])
    )
    lean, x = (float(v) for v in drawn[0])
    pin = a * math.cos(start), a * math.sin(start)
    scene = {
        "dimension": 2,
        "gravity": [0, -G],
        "bodies": {
            "crank": bar(a, masses[0], inertias[0], 0, 0, start, angular_velocity=rate),
            "rod": bar(
                b, masses[1], inertias[1], *pin, lean,
                angular_velocity=float(speeds[0, 0]), velocity=[-pin[1] * rate, pin[0] * rate],
            ),
            "slider": {
                "position": [x, offset],
                "mass": masses[2],
                "inertia": inertias[2],
                "velocity": [float(speeds[0, 1]), 0],
            },
        },
        "joints": {
            "A": pinned("ground", "crank.a", at=[0, 0]),
            "B": pinned("crank.e", "rod.a"),
            "C": pinned("rod.e", "slider"),
            "guide": {"type": "prismatic", "bodies": ["ground", "slider"], "axis": [1, 0]},
        },
        "forces": {
            "s": {
                "type": "spring",
                "points": ["ground", "slider"],
                "at": [-1, offset],
                "stiffness": k,
                "free_length": 1 + far,
            },
            "d": {
                "type": "damper",
                "points": ["ground", "slider"],
                "at": [-1, offset],
                "damping": d,
            },
        },
    }  # fmt: skip

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [start], [rate], t)
        found, rates = values(lambda n: [slider(n[0]), rod(n[0])], q, v)
        return {
            "crank.angle": q[:, 0],
            "crank.angular_velocity": v[:, 0],
            "slider.x": found[:, 0],
            "slider.vx": rates[:, 0],
            "rod.angular_velocity": rates[:, 1],
        }

    return System(
        name=name, kind="loops", origin="DOP853 in the crank's angle",
        scene=scene, stop=1.5, right=right, settings={"assemble": True},
        **more,
    )  # fmt: skip


def _parallelogram() -> System:
    """Two equal cranks and a coupler that never turns: a pendulum of the cranks' angle."""
    a, wide, m_crank, J, m = 0.6, 0.9, 0.5, 0.02, 3.0
    start = -0.5
    x, y = a * math.cos(start), a * math.sin(start)
    scene = {
        "dimension": 2,
        "gravity": [0, -G],
        "bodies": {
            "l": bar(a, m_crank, J, 0, 0, start),
            "r": bar(a, m_crank, J, wide, 0, start),
            "c": {
                "position": [x, y],
                "mass": m,
                "inertia": 0.3,
                "center_of_mass": [0.2, 0.1],
                "points": {"a": [0, 0], "e": [wide, 0]},
            },
        },
        "joints": {
            "A": pinned("ground", "l.a", at=[0, 0]),
            "B": pinned("ground", "r.a", at=[wide, 0]),
            "C": pinned("l.e", "c.a"),
            "D": pinned("r.e", "c.e"),
        },
    }

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        crank = (0.5 * a * cos(q[0]), 0.5 * a * sin(q[0]))
        bodies = [Body(2 * m_crank, crank, 2 * J, q[0]), Body(m, (2 * crank[0], 2 * crank[1]))]
        return Parts(bodies, G * (2 * m_crank * crank[1] + 2 * m * crank[1]))

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [start], [0.0], t)
        return {
            "l.angle": q[:, 0],
            "c.angle": np.zeros_like(t),
            "c.x": a * np.cos(q[:, 0]),
            "c.vy": a * v[:, 0] * np.cos(q[:, 0]),
        }

    return System(
        name="parallelogram", kind="loops", origin="DOP853 in the cranks' angle",
        scene=scene, stop=0.9, right=right,
    )  # fmt: skip


def _trammel() -> System:
    """Bar whose ends slide on two lines at right angles, under gravity: one angle."""
    a, m, J, start = 1.2, 2.0, 0.35, 0.8
    x, y = a * math.cos(start), a * math.sin(start)
    scene = {
        "dimension": 2,
        "gravity": [0, -G],
        "bodies": {
            "b": {
                "position": [x / 2, y / 2],
                "orientation": -start,
                "mass": m,
                "inertia": J,
                "points": {"h": [-a / 2, 0], "e": [a / 2, 0]},
            }
        },
        "joints": {
            "up": {"type": "point_on_line", "point": "b.h", "axis": [0, 1]},
            "along": {"type": "point_on_line", "point": "b.e", "axis": [1, 0]},
        },
    }

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        place = (0.5 * a * cos(q[0]), 0.5 * a * sin(q[0]))
        return Parts([Body(m, place, J, -q[0])], m * G * place[1])

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [start], [0.0], t)
        return {
            "b.x": 0.5 * a * np.cos(q[:, 0]),
            "b.y": 0.5 * a * np.sin(q[:, 0]),
            "b.angle": -q[:, 0],
            "b.angular_velocity": -v[:, 0],
        }

    return System(
        name="bar_on_two_lines", kind="loops", origin="DOP853 in the angle",
        scene=scene, stop=2.0, right=right,
    )  # fmt: skip


def _five_bar() -> System:
    """Two cranks and two coupler points: two freedoms, the tip where two circles meet."""
    a, b, ground, m_tip = (0.5, 0.4), (1.1, 1.2), 0.6, 1.5
    masses, inertias = (0.6, 0.4), (0.02, 0.01)
    start, rates = (2.0, 1.0), (1.0, -2.0)

    def tip(q: Sequence[Number]) -> tuple[Number, Number]:
        x0, y0 = a[0] * cos(q[0]), a[0] * sin(q[0])
        x1, y1 = ground + a[1] * cos(q[1]), a[1] * sin(q[1])
        dx, dy = x1 - x0, y1 - y0
        d2 = dx * dx + dy * dy
        d = sqrt(d2)
        along = (d2 + (b[0] ** 2 - b[1] ** 2)) / (2 * d)
        off = sqrt(b[0] ** 2 - along * along)
        return x0 + (along * dx - off * dy) / d, y0 + (along * dy + off * dx) / d

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        place = tip(q)
        bodies = [
            Body(masses[0], _middle(a[0], 0.0, 0.0, cos(q[0]), sin(q[0])), inertias[0], q[0]),
            Body(masses[1], _middle(a[1], ground, 0.0, cos(q[1]), sin(q[1])), inertias[1], q[1]),
            Body(m_tip, place),
        ]
        return Parts(bodies, sum(G * x.mass * x.place[1] for x in bodies))

    drawn, speed = values(lambda n: list(tip(n)), np.array([start]), np.array([rates]))
    scene = {
        "dimension": 2,
        "gravity": [0, -G],
        "bodies": {
            "l": bar(a[0], masses[0], inertias[0], 0, 0, start[0], angular_velocity=rates[0]),
            "r": bar(a[1], masses[1], inertias[1], ground, 0, start[1], angular_velocity=rates[1]),
        },
        "points": {
            "tip": {"position": drawn[0].tolist(), "velocity": speed[0].tolist(), "mass": m_tip}
        },
        "joints": {
            "A": pinned("ground", "l.a", at=[0, 0]),
            "B": pinned("ground", "r.a", at=[ground, 0]),
            "p": {"type": "distance", "points": ["l.e", "tip"]},
            "q": {"type": "distance", "points": ["r.e", "tip"]},
        },
    }

    def right(t: Array) -> Values:
        q, v = motion(mechanism, start, rates, t)
        place, speeds = values(lambda n: list(tip(n)), q, v)
        return {
            "tip.x": place[:, 0],
            "tip.y": place[:, 1],
            "tip.vx": speeds[:, 0],
            "l.angle": q[:, 0],
            "r.angular_velocity": v[:, 1],
        }

    return System(
        name="five_bar_with_a_mass", kind="loops", origin="DOP853 in both cranks' angles",
        scene=scene, stop=0.6, right=right, settings={"assemble": True},
    )  # fmt: skip


def _spatial_slider_crank() -> System:
    """Crank about an inclined axis, a massless rod and a slider on x: |pin - slider| = L."""
    a, rod, tilt, J, m = 0.2, 0.9, 0.5, 0.03, 1.1
    start, rate = 0.4, 5.0

    def pinned(q: Number) -> list[Number]:
        return turned(after(about(0, _constant(q, tilt)), about(2, q)), [a, 0.0, 0.0])

    def slide(q: Number) -> Number:
        x, y, z = pinned(q)
        return x + sqrt(rod * rod - y * y - z * z)

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        x = slide(q[0])
        bodies = [Body(0.0, [x], J, q[0]), Body(m, (x,))]
        return Parts(bodies, m * 2.0 * x)

    drawn, speed = values(
        lambda n: [*pinned(n[0]), slide(n[0])], np.array([[start]]), np.array([[rate]])
    )
    axis = [0.0, -math.sin(tilt), math.cos(tilt)]
    scene = {
        "gravity": [-2.0, 0, 0],
        "bodies": {
            "crank": {
                "position": [0, 0, 0],
                "orientation": {"rotation_vector": [tilt, 0, 0]},
                "mass": 1.0,
                "inertia": [J, J, J],
                "angular_velocity": [rate * x for x in axis],
                "points": {"pin": [a * math.cos(start), a * math.sin(start), 0]},
            }
        },
        "points": {
            "S": {
                "position": [float(drawn[0, 3]), 0, 0],
                "velocity": [float(speed[0, 3]), 0, 0],
                "mass": m,
            }
        },
        "joints": {
            "A": hinge("ground", "crank", [0, 0, 0], axis),
            "rod": {"type": "distance", "points": ["crank.pin", "S"]},
            "rail": {"type": "point_on_line", "point": "S", "axis": [1, 0, 0]},
        },
    }

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [start], [rate], t)
        x, rates = values(lambda n: [slide(n[0])], q, v)
        return {
            "A.angle": q[:, 0] - start,
            "A.angular_velocity": v[:, 0],
            "S.x": x[:, 0],
            "S.vx": rates[:, 0],
        }

    return System(
        name="slider_crank_in_space", kind="loops", origin="DOP853 in the crank's angle",
        scene=scene, stop=2.0, right=right, settings={"assemble": True},
    )  # fmt: skip


def _constant(like: Number, value: float) -> Number:
    """Plain number among numbers that know their derivatives."""
    return 0.0 * like + value


def _cardan_pair() -> System:
    """Two shafts at an angle with a universal joint between them: tan b = cos(angle) tan a."""
    bend, J1, J2, rate = 0.6, 0.02, 0.05, 9.0
    axis = [math.cos(bend), math.sin(bend), 0.0]

    def driven(q: Number) -> Number:
        return atan2(math.cos(bend) * sin(q), cos(q))

    def mechanism(_: float, q: Sequence[Number]) -> Parts:
        return Parts([Body(0.0, [], J1, q[0]), Body(0.0, [], J2, driven(q[0]))])

    _, speed = values(lambda n: [driven(n[0])], np.array([[0.0]]), np.array([[rate]]))
    scene = {
        "bodies": {
            "a": {
                "position": [-0.3, 0, 0],
                "mass": 1,
                "inertia": [J1, 0.03, 0.03],
                "angular_velocity": [rate, 0, 0],
            },
            "b": {
                "position": [0.3 * axis[0], 0.3 * axis[1], 0],
                "orientation": {"rotation_vector": [0, 0, bend]},
                "mass": 1,
                "inertia": [J2, 0.06, 0.06],
                "angular_velocity": [float(speed[0, 0]) * x for x in axis],
            },
        },
        "joints": {
            "ja": hinge("ground", "a", [-0.3, 0, 0], [1, 0, 0]),
            "jb": hinge("ground", "b", [0.3 * axis[0], 0.3 * axis[1], 0], axis),
            "u": {
                "type": "universal",
                "bodies": ["a", "b"],
                "position": [0, 0, 0],
                "axes": [[0, 0, 1], [-axis[1], axis[0], 0]],
            },
        },
    }

    def right(t: Array) -> Values:
        q, v = motion(mechanism, [0.0], [rate], t)
        found, rates = values(lambda n: [driven(n[0])], q, v)
        return {
            "ja.angle": q[:, 0],
            "jb.angle": np.unwrap(found[:, 0]),
            "ja.angular_velocity": v[:, 0],
            "jb.angular_velocity": rates[:, 0],
        }

    return System(
        name="universal_joint_of_two_shafts", kind="loops",
        origin="DOP853 in the first angle, tan b = cos(bend) tan a",
        scene=scene, stop=1.0, right=right, points=20,
    )  # fmt: skip


SYSTEMS = (
    _four_bar("crank_and_rocker", [0.3, 0.9, 0.6], 0.8, 1.0, 8.0, 1.5),
    _four_bar("rocker_on_a_spring", [0.5, 0.75, 0.85], 0.65, 1.2, 0.0, 2.0, spring=60.0),
    _slider_crank(0.0, "central_slider_crank"),
    _slider_crank(0.12, "offset_slider_crank"),
    _parallelogram(),
    _trammel(),
    _five_bar(),
    _spatial_slider_crank(),
    _cardan_pair(),
)
