"""What stands still: static equilibria, balances, trusses, and what hangs; with their reactions."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np
from scipy.optimize import brentq

from tests.truth.system import Array, System, Values

G = 9.81


def _still(values: Mapping[str, float]) -> Callable[[Array], Values]:
    """Right values that stay."""

    def right(t: Array) -> Values:
        return {name: np.full_like(t, value) for name, value in values.items()}

    return right


def _system(
    name: str, origin: str, text: str, values: Mapping[str, float],
    *, start: str = "equilibrium", scale: Mapping[str, float] | None = None, stop: float = 1.0,
) -> System:  # fmt: skip
    return System(
        name=name, kind="equilibria", origin=origin, scene=text, stop=stop,
        right=_still(values), settings={"start": start},
        scale={"speed": 1.0, "turn": 1.0, **(scale or {})},
    )  # fmt: skip


def _blown() -> System:
    """Bar in the wind: tan a = F/(m g) with both at its mass centre."""
    m, r, F = 1.4, 0.6, 5.2
    a = math.atan2(F, m * G)
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        b = {{ position = [0, {-r}], mass = {m}, inertia = 0.1 }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "b"], position = [0, 0] }}
        [forces]
        wind = {{ type = "force", point = "b", value = [{F}, 0] }}
    """
    return _system("bar_in_the_wind", "closed form: tan a = F/(m g)", text, {
        "b.angle": a, "b.x": r * math.sin(a), "b.y": -r * math.cos(a), "b.angular_velocity": 0.0,
        "j.force.x": -F, "j.force.y": m * G,
    })  # fmt: skip


def _pulled_chain() -> System:
    """Three unequal bars drawn aside at their end: tan a_i = F/(weight below the middle of i)."""
    lengths, masses, F = (0.5, 0.3, 0.4), (2.0, 0.7, 1.1), 6.0
    below = [masses[i] / 2 + sum(masses[i + 1 :]) for i in range(3)]
    angles = [math.atan2(F, w * G) for w in below]
    text = ["dimension = 2", f"gravity = [0, {-G}]", "[bodies]"]
    top = 0.0
    for i, (c, m) in enumerate(zip(lengths, masses, strict=True)):
        text.append(
            f"b{i} = {{ position = [0, {top - c / 2!r}], mass = {m}, inertia = {m * c * c / 12!r}, "
            f"points = {{ a = [0, {c / 2}], e = [0, {-c / 2}] }} }}"
        )
        top -= c
    text += ["[joints]", 'j0 = { type = "revolute", points = ["ground", "b0.a"], at = [0, 0] }']
    text += [f'j{i} = {{ type = "revolute", points = ["b{i - 1}.e", "b{i}.a"] }}' for i in (1, 2)]
    text += ["[forces]", f'f = {{ type = "force", point = "b2.e", value = [{F}, 0] }}']
    weights = [G * sum(masses[i:]) for i in range(3)]
    values = {f"b{i}.angle": a for i, a in enumerate(angles)}
    values |= {f"j{i}.force.y": w for i, w in enumerate(weights)}
    values |= {"j0.force.x": -F, "b2.angular_velocity": 0.0}
    return _system("chain_drawn_aside", "closed form: tan a = F/(weight below)",
                   "\n".join(text), values)  # fmt: skip


def _hung_chain() -> System:
    """Five rods and four unequal loads between two hooks: H tan a_i steps by each weight."""
    loads, link, span, drop = (1.0, 3.0, 0.5, 2.0), 0.5, 2.0, 0.3

    def hang(H: float) -> tuple[float, list[float]]:
        """Pull of the first rod's rise, and tangents, for which the end is `drop` lower."""

        def height(V: float) -> float:
            tangents = [(V - G * sum(loads[:i])) / H for i in range(5)]
            return sum(link * x / math.hypot(1, x) for x in tangents)

        V = brentq(lambda V: height(V) - drop, -1e4, 1e4, xtol=1e-14, rtol=1e-15)
        return V, [(V - G * sum(loads[:i])) / H for i in range(5)]

    H = brentq(
        lambda H: sum(link / math.hypot(1, x) for x in hang(H)[1]) - span, 1.0, 500.0,
        xtol=1e-13, rtol=1e-15,
    )  # fmt: skip
    _, tangents = hang(H)
    x = np.cumsum([link / math.hypot(1, q) for q in tangents])
    y = -np.cumsum([link * q / math.hypot(1, q) for q in tangents])
    # Drawn hanging, a little beside the equilibrium: symmetric arc through both hooks.
    text = ["dimension = 2", f"gravity = [0, {-G}]", "[points]"]
    for i, m in enumerate(loads):
        px, py = span * (i + 1) / 5, -drop * (i + 1) / 5 - 0.5 * math.sin(math.pi * (i + 1) / 5)
        text.append(f"p{i} = {{ position = [{px!r}, {py!r}], mass = {m} }}")
    ends = [f'"p{i}"' for i in range(4)]
    text += [
        "[joints]",
        f'r0 = {{ type = "distance", points = ["ground", {ends[0]}], at = [0, 0], length = {link} }}',
    ]
    text += [
        f'r{i} = {{ type = "distance", points = [{ends[i - 1]}, {ends[i]}], length = {link} }}'
        for i in (1, 2, 3)
    ]
    text += [
        f'r4 = {{ type = "distance", points = ["ground", {ends[3]}], at = [{span}, {-drop}], length = {link} }}'
    ]
    text += ["[solver]", "assemble = true"]
    values = {f"p{i}.x": float(x[i]) for i in range(4)} | {f"p{i}.y": float(y[i]) for i in range(4)}
    values |= {f"r{i}.force": H * math.hypot(1, tangents[i]) for i in range(5)}
    return _system(
        "loads_on_a_hung_chain", "force polygon, two roots by brentq", "\n".join(text), values
    )


def _on_springs() -> System:
    """Load between two slanted springs: 2 k (l - l0) y/l = m g."""
    m, k, half, free = 2.0, 160.0, 0.8, 0.7

    def rest(y: float) -> float:
        length = math.hypot(half, y)
        return 2 * k * (length - free) * y / length - m * G

    y = brentq(rest, 0.01, 2.0, xtol=1e-15, rtol=1e-15)
    length = math.hypot(half, y)
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        A = {{ position = [0, -0.2], mass = {m} }}
        [forces]
        l = {{ type = "spring", points = ["ground", "A"], at = [{-half}, 0], stiffness = {k}, free_length = {free} }}
        r = {{ type = "spring", points = ["ground", "A"], at = [{half}, 0], stiffness = {k}, free_length = {free} }}
    """
    return _system("load_on_slanted_springs", "closed form of one root, by brentq", text, {
        "A.x": 0.0, "A.y": -y, "A.vy": 0.0, "l.length": length,
    })  # fmt: skip


def _sagging_arm() -> System:
    """Bar on a torsion spring: k a = m g r cos a (a below the horizontal)."""
    m, r, k = 1.1, 0.5, 9.0
    a = brentq(lambda a: k * a - m * G * r * math.cos(a), 0.0, 1.5, xtol=1e-15, rtol=1e-15)
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        b = {{ position = [{r}, 0, 0], mass = {m}, inertia = [0.01, 0.09, 0.09] }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "b"], position = [0, 0, 0], axis = [0, 1, 0] }}
        [forces]
        s = {{ type = "torsion_spring", joint = "j", stiffness = {k} }}
    """
    return _system("arm_on_a_torsion_spring", "closed form of one root, by brentq", text, {
        "j.angle": a, "b.x": r * math.cos(a), "b.z": -r * math.sin(a), "j.force.x": 0.0,
        "j.force.z": m * G, "j.angular_velocity": 0.0,
    })  # fmt: skip


def _stands(name: str, tilt: float, motor: bool) -> System:
    """Arm of two bars in the plane that torques hold up, or that hangs straight; drawn at rest."""
    (l1, m1), (l2, m2) = (0.6, 3.0), (0.45, 1.5)
    a, b = (tilt, tilt - 0.9) if motor else (-math.pi / 2, -math.pi / 2)
    ca, sa, cb, sb = math.cos(a), math.sin(a), math.cos(b), math.sin(b)
    second = m2 * G * l2 / 2 * cb
    first = second + (m1 / 2 + m2) * G * l1 * ca
    torques = f"""
        [forces]
        A = {{ type = "joint_torque", joint = "j", value = {first!r} }}
        B = {{ type = "joint_torque", joint = "k", value = {second!r} }}
    """
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        a = {{ position = [{l1 / 2 * ca!r}, {l1 / 2 * sa!r}], orientation = {a!r}, mass = {m1}, inertia = 0.1 }}
        b = {{ position = [{l1 * ca + l2 / 2 * cb!r}, {l1 * sa + l2 / 2 * sb!r}], orientation = {b!r}, mass = {m2}, inertia = 0.03 }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "a"], position = [0, 0] }}
        k = {{ type = "revolute", bodies = ["a", "b"], position = [{l1 * ca!r}, {l1 * sa!r}] }}
        {torques if motor else ""}
    """
    return _system(name, "closed form: it stands still", text, {
        "a.angle": a, "b.angle": b, "a.angular_velocity": 0.0, "b.angular_velocity": 0.0,
        "j.force.x": 0.0, "j.force.y": (m1 + m2) * G, "k.force.y": m2 * G,
    }, start="drawn", stop=0.5)  # fmt: skip


def _spatial_arm() -> System:
    """Arm of two bars in space that torques hold, on a turntable: moments of the weights."""
    m1, m2 = 2.0, 1.3
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        base = {{ position = [0, 0, 0.2], mass = 4, inertia = [0.1, 0.1, 0.05] }}
        a = {{ position = [0.3, 0, 0.4], mass = {m1}, inertia = [0.01, 0.06, 0.06] }}
        b = {{ position = [0.6, 0, 0.65], mass = {m2}, inertia = [0.03, 0.03, 0.01] }}
        [joints]
        turn = {{ type = "revolute", bodies = ["ground", "base"], position = [0, 0, 0], axis = [0, 0, 1] }}
        j = {{ type = "revolute", bodies = ["base", "a"], position = [0, 0, 0.4], axis = [0, -1, 0] }}
        k = {{ type = "revolute", bodies = ["a", "b"], position = [0.6, 0, 0.4], axis = [0, -1, 0] }}
        [forces]
        A = {{ type = "joint_torque", joint = "j", value = {(0.3 * m1 + 0.6 * m2) * G!r} }}
    """
    return _system("arm_in_space_that_a_torque_holds", "closed form: it stands still", text, {
        "j.angle": 0.0, "k.angle": 0.0, "turn.angle": 0.0, "b.wy": 0.0, "j.force.z": (m1 + m2) * G,
        "j.force.x": 0.0, "turn.force.z": (m1 + m2 + 4) * G,
        "turn.torque.y": -(0.3 * m1 + 0.6 * m2) * G,
    }, start="drawn", stop=0.5)  # fmt: skip


def _truss() -> System:
    """Frame of four rods with two loads that grow: nothing moves, forces by the method of joints."""
    a, b, P = 2.0, 1.5, 30.0
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        A = {{ position = [{a}, 0], mass = 1.5 }}
        B = {{ position = [{2 * a}, {b}], mass = 0.8 }}
        [joints]
        lower = {{ type = "distance", points = ["ground", "A"], at = [0, 0] }}
        upper = {{ type = "distance", points = ["ground", "B"], at = [0, {b}] }}
        brace = {{ type = "distance", points = ["ground", "A"], at = [0, {b}] }}
        tip = {{ type = "distance", points = ["A", "B"] }}
        [forces]
        load = {{ type = "force", point = "B", value = [0, "-{P}*t"] }}
    """
    c = math.hypot(a, b)
    sine, cosine = b / c, a / c

    def right(t: Array) -> Values:
        down = 0.8 * G + P * t
        tip = -down / sine  # in tension positive
        brace = (1.5 * G - tip * sine) / sine
        return {"A.x": np.full_like(t, a), "B.y": np.full_like(t, b),
                "tip.force": tip, "upper.force": -tip * cosine, "brace.force": brace,
                "lower.force": tip * cosine - brace * cosine}  # fmt: skip

    return System(
        name="truss", kind="equilibria", origin="method of joints", scene=text, stop=1.0,
        right=right,
    )  # fmt: skip


def _frame_under_a_fast_load() -> System:
    """Joint on two rods, without weight; the load swings in less than a communication step."""
    a, b, P, rate = 0.8, 0.6, 50.0, 30.0
    text = f"""
        dimension = 2
        [points]
        B = {{ position = [{a}, {-b}], mass = 2 }}
        [joints]
        left = {{ type = "distance", points = ["ground", "B"], at = [0, 0] }}
        right = {{ type = "distance", points = ["ground", "B"], at = [{2 * a}, 0] }}
        [forces]
        load = {{ type = "force", point = "B", value = [0, "-{P}*sin({rate}*t)"] }}
    """

    def right(t: Array) -> Values:
        rod = P * np.sin(rate * t) * math.hypot(a, b) / (2 * b)
        return {"B.x": np.full_like(t, a), "left.force": rod, "right.force": rod}

    return System(
        name="frame_under_a_fast_load", kind="equilibria", origin="method of joints", scene=text,
        stop=1.0, right=right,
    )  # fmt: skip


def _tripod() -> System:
    """Load on three unequal legs: forces by three equations."""
    feet = np.array([[0.8, 0.0, 0.0], [-0.5, 0.6, 0.0], [-0.4, -0.9, 0.1]])
    top, m = np.array([0.05, -0.03, 1.3]), 12.0
    legs = top - feet
    lengths = np.linalg.norm(legs, axis=1)
    forces = np.linalg.solve((-legs / lengths[:, None]).T, [0.0, 0.0, m * G])
    text = f"""
        gravity = [0, 0, {-G}]
        [points]
        T = {{ position = {top.tolist()}, mass = {m} }}
        [joints]
    """ + "\n".join(
        f'l{i} = {{ type = "distance", points = ["ground", "T"], at = {f.tolist()} }}'
        for i, f in enumerate(feet)
    )
    return _system("tripod", "three equations of statics", text,
                   {"T.z": 1.3} | {f"l{i}.force": float(f) for i, f in enumerate(forces)},
                   start="drawn")  # fmt: skip


def _ladder() -> System:
    """Ladder on a smooth wall and floor, held by a rope: N = m g/2 cot a."""
    m, c, a = 9.0, 2.4, 1.1
    x, y = c * math.cos(a), c * math.sin(a)
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        b = {{ position = [{x / 2!r}, {y / 2!r}], orientation = {-a!r}, mass = {m}, inertia = 4, points = {{ top = [{-c / 2}, 0], foot = [{c / 2}, 0] }} }}
        [joints]
        wall = {{ type = "point_on_line", point = "b.top", axis = [0, 1] }}
        floor_line = {{ type = "point_on_line", point = "b.foot", axis = [1, 0] }}
        rope = {{ type = "distance", points = ["ground", "b.foot"], at = [0, 0] }}
    """
    N = m * G / 2 / math.tan(a)
    return _system("ladder_with_a_rope", "closed form: N = m g/2 cot a", text, {
        "b.angle": -a, "wall.force.x": N, "floor_line.force.y": m * G, "rope.force": N,
    }, start="drawn")  # fmt: skip


SYSTEMS = (
    _blown(),
    _pulled_chain(),
    _hung_chain(),
    _on_springs(),
    _sagging_arm(),
    _stands("arm_that_torques_hold", 0.8, motor=True),
    _stands("double_pendulum_that_hangs", 0.0, motor=False),
    _spatial_arm(),
    _truss(),
    _frame_under_a_fast_load(),
    _tripod(),
    _ladder(),
)  # fmt: skip
