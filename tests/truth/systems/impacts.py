"""Impacts: balls, rods, stops, ropes; their times, velocities and losses."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tests.truth.minimal import dop853
from tests.truth.system import Array, System, Values

G = 9.81


def _bouncing(e: float, stop: float) -> System:
    """Ball that falls from a height: each flight lasts 2 v/g, and v falls by e."""
    h, m = 1.3, 0.6
    text = f"""
        gravity = [0, 0, {-G}]
        [points]
        A = {{ position = [0, 0, {h}], velocity = [0.4, 0, 0], mass = {m} }}
        [contacts]
        c = {{ type = "plane", point = "A", axis = [0, 0, 1], restitution = {e} }}
    """

    def right(t: Array) -> Values:
        z, v, n = h - G * t**2 / 2, -G * t, np.zeros_like(t)
        at, speed, count = math.sqrt(2 * h / G), e * math.sqrt(2 * G * h), 1
        while at < stop:
            u = t - at
            z, v = np.where(u > 0, speed * u - G * u**2 / 2, z), np.where(u > 0, speed - G * u, v)
            n = np.where(u > 0, count, n)
            at, speed, count = at + 2 * speed / G, e * speed, count + 1
        return {"A.x": 0.4 * t, "A.z": z, "A.vz": v, "c.impacts": n}

    return System(
        name=f"bouncing_ball_{e:g}", kind="impacts", origin="closed form: flights of 2 v/g",
        scene=text, stop=stop, points=9, right=right, orders=(),
    )  # fmt: skip


def _in_line(
    x0: Sequence[float], v0: Sequence[float], masses: Sequence[float], e: float, times: Array
) -> tuple[Array, Array, int]:
    """Places and velocities (n, balls) of balls in a line, and how often they hit: exact flights.

    A mass of infinity is a wall. Radii are 0.
    """
    x, v = np.array(x0), np.array(v0)
    t, count, found = 0.0, 0, []
    for time in times:
        while True:
            gaps, closing = np.diff(x), -np.diff(v)
            waits = [g / c if c > 1e-12 else math.inf for g, c in zip(gaps, closing, strict=True)]
            i = int(np.argmin(waits))
            if t + waits[i] > time:
                break
            x, t, count = x + v * waits[i], t + waits[i], count + 1
            a, b = 1 / masses[i], 1 / masses[i + 1]
            impulse = (1 + e) * (v[i] - v[i + 1]) / (a + b)
            v[i], v[i + 1] = v[i] - a * impulse, v[i + 1] + b * impulse
            x[i + 1] = x[i]
        x, t = x + v * (time - t), float(time)
        found.append((x.copy(), v.copy()))
    places, speeds = (np.array(part) for part in zip(*found, strict=True))
    return places, speeds, count


def _balls(
    name: str, x0: Sequence[float], v0: Sequence[float], masses: Sequence[float], e: float,
    stop: float, *, dimension: int = 2,
) -> System:  # fmt: skip
    """Balls in a line: momentum and restitution, impact by impact."""
    r = 0.04
    rest = ", 0" * (dimension - 1)
    text = [f"dimension = {dimension}", "[points]"]
    text += [
        f"b{i} = {{ position = [{x + 2 * r * i!r}{rest}], velocity = [{v}{rest}], mass = {m} }}"
        for i, (x, v, m) in enumerate(zip(x0, v0, masses, strict=True))
    ]
    text.append("[contacts]")
    text += [
        f'c{i} = {{ type = "sphere", points = ["b{i}", "b{i + 1}"], radii = [{r}, {r}], restitution = {e} }}'
        for i in range(len(x0) - 1)
    ]

    def right(t: Array) -> Values:
        x, v, _ = _in_line(x0, v0, masses, e, t)
        found = {f"b{i}.x": x[:, i] + 2 * r * i for i in range(len(x0))}
        return found | {f"b{i}.vx": v[:, i] for i in range(len(x0))}

    return System(
        name=name, kind="impacts", origin="closed form: momentum and restitution", scene="\n".join(text),
        stop=stop, points=9, right=right, orders=(),
    )  # fmt: skip


def _oblique() -> System:
    """Two unequal discs hit each other aside, without friction: the normal part alone changes."""
    m, M, r, R, e = 0.3, 0.8, 0.1, 0.15, 0.7
    x, v = np.array([-1.0, 0.12]), np.array([2.0, 0.1])
    y, w = np.array([0.4, 0.0]), np.array([-0.5, 0.3])
    text = f"""
        dimension = 2
        [points]
        a = {{ position = {x.tolist()}, velocity = {v.tolist()}, mass = {m} }}
        b = {{ position = {y.tolist()}, velocity = {w.tolist()}, mass = {M} }}
        [contacts]
        c = {{ type = "sphere", points = ["a", "b"], radii = [{r}, {R}], restitution = {e} }}
    """

    def right(t: Array) -> Values:
        d, u = y - x, w - v
        half, square = d @ u, u @ u
        at = (-half - math.sqrt(half**2 - square * (d @ d - (r + R) ** 2))) / square
        n = (d + u * at) / (r + R)
        impulse = -(1 + e) * (u @ n) / (1 / m + 1 / M)
        after = np.maximum(t - at, 0.0)[:, None]
        a = x + v * t[:, None] - impulse / m * n * after
        b = y + w * t[:, None] + impulse / M * n * after
        hit = after > 0
        va, vb = v - impulse / m * n * hit, w + impulse / M * n * hit
        return {"a.x": a[:, 0], "a.y": a[:, 1], "b.x": b[:, 0], "b.y": b[:, 1], "a.vx": va[:, 0],
                "a.vy": va[:, 1], "b.vx": vb[:, 0], "b.vy": vb[:, 1]}  # fmt: skip

    return System(
        name="two_discs_that_hit_aside", kind="impacts", origin="closed form: impulse along the normal",
        scene=text, stop=1.0, points=9, right=right, orders=(),
    )  # fmt: skip


def _rod(e: float) -> System:
    """Rod that falls on one end without friction: impulse (1 + e) v/(1/m + r^2/J)."""
    m, half, J, tilt, h = 0.9, 0.5, 0.08, 0.5, 0.6
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies.b]
        position = [0, {h}]
        orientation = {tilt}
        velocity = [0.3, 0]
        mass = {m}
        inertia = {J}
        points = {{ a = [{-half}, 0] }}
        [contacts]
        c = {{ type = "plane", point = "b.a", axis = [0, 1], restitution = {e} }}
    """

    def right(t: Array) -> Values:
        fall = h - half * math.sin(tilt)
        at, speed = math.sqrt(2 * fall / G), math.sqrt(2 * G * fall)
        arm = -half * math.cos(tilt)
        impulse = (1 + e) * speed / (1 / m + arm**2 / J)
        u = np.maximum(t - at, 0.0)
        hit = t > at
        spin = arm * impulse / J
        return {"b.x": 0.3 * t, "b.y": h - G * t**2 / 2 + impulse / m * u, "b.angle": tilt + spin * u,
                "b.vy": -G * t + impulse / m * hit, "b.angular_velocity": spin * hit,
                "c.impulse": impulse * hit}  # fmt: skip

    return System(
        name=f"rod_hits_the_ground_{e:g}", kind="impacts", origin="closed form: impulse at its end",
        scene=text, stop=0.45, points=9, right=right, orders=(),
    )  # fmt: skip


def _stops() -> System:
    """Rotor between two stops: even turning between impacts."""
    J, w, e, low, high = 0.5, 3.0, 0.8, -0.4, 0.7
    text = f"""
        dimension = 2
        [bodies]
        r = {{ position = [0, 0], mass = 1, inertia = {J}, angular_velocity = {w} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "r"], position = [0, 0] }}
        [contacts]
        s = {{ type = "stop", joint = "j", min = {low}, max = {high}, restitution = {e} }}
    """

    def right(t: Array) -> Values:
        # A ball between two walls: they weigh 1e300 and stay.
        x, v, _ = _in_line([low, 0.0, high], [0.0, w, 0.0], [1e300, J, 1e300], e, t)
        return {"j.angle": x[:, 1], "j.angular_velocity": v[:, 1]}

    return System(
        name="rotor_between_stops", kind="impacts", origin="closed form: speed e^n w",
        scene=text, stop=2.0, points=9, right=right, orders=(),
    )  # fmt: skip


def _stopped_pendulum() -> System:
    """Pendulum that swings against a stop: DOP853 between events of the angle."""
    m, r, J, e, start, low = 1.2, 0.5, 0.04, 0.6, 0.9, -0.2
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [bodies]
        b = {{ position = [{r * math.sin(start)!r}, {-r * math.cos(start)!r}], orientation = {start}, mass = {m}, inertia = {J} }}
        [joints]
        j = {{ type = "revolute", bodies = ["ground", "b"], position = [0, 0] }}
        [contacts]
        s = {{ type = "stop", joint = "j", min = {low - start!r}, restitution = {e} }}
    """
    rate = m * G * r / (J + m * r * r)

    def right(t: Array) -> Values:
        def hit(_: float, y: Array) -> float:
            return y[0] - low

        hit.terminal, hit.direction = True, -1  # type: ignore[attr-defined]
        begin, y, found = 0.0, np.array([start, 0.0]), np.zeros((len(t), 2))
        while begin < t[-1]:
            piece = dop853(lambda _, y: [y[1], -rate * math.sin(y[0])], (begin, t[-1] + 1), y,
                           events=hit, dense_output=True)  # fmt: skip
            end = piece.t[-1]
            here = (t >= begin) & (t <= end)
            found[here] = piece.sol(t[here]).T
            begin, y = end, np.array([low, -e * piece.y[1, -1]])
        return {"b.angle": found[:, 0], "b.angular_velocity": found[:, 1]}

    return System(
        name="pendulum_against_a_stop", kind="impacts", origin="DOP853 between located impacts",
        scene=text, stop=2.5, points=9, right=right, orders=(),
    )  # fmt: skip


def _rope(e: float) -> System:
    """Mass thrown about on a rope: chords of a circle, the radial part turns round by e."""
    r, m = 0.8, 0.5
    x0, v0 = np.array([0.1, -0.2]), np.array([1.5, 0.9])
    text = f"""
        dimension = 2
        [points]
        O = {{ position = [0, 0], fixed = true }}
        A = {{ position = {x0.tolist()}, velocity = {v0.tolist()}, mass = {m} }}
        [contacts]
        rope = {{ type = "stop", points = ["O", "A"], max = {r}, restitution = {e} }}
    """

    def right(t: Array) -> Values:
        x, v, at, found = x0, v0, 0.0, []
        for time in t:
            while True:
                half, square = x @ v, v @ v
                wait = (-half + math.sqrt(half**2 - square * (x @ x - r * r))) / square
                if at + wait > time:
                    break
                x, at = x + v * wait, at + wait
                n = x / np.linalg.norm(x)
                x, v = n * r, v - (1 + e) * (v @ n) * n
                x = x * (1 - 1e-15)
            found.append([*(x + v * (time - at)), *v])
        table = np.array(found)
        return dict(zip(("A.x", "A.y", "A.vx", "A.vy"), table.T, strict=True))

    return System(
        name=f"mass_on_a_rope_{e:g}", kind="impacts", origin="closed form: chords of a circle",
        scene=text, stop=2.0, points=9, right=right, orders=(),
    )  # fmt: skip


def _table() -> System:
    """Mass that falls on a table that rises evenly: v' = V + e (V - v)."""
    h, e, V = 0.7, 0.6, 0.9
    text = f"""
        dimension = 2
        gravity = [0, {-G}]
        [points]
        A = {{ position = [0, {h}], mass = 0.4 }}
        [bodies]
        table = {{ position = [0, 0], mass = 5, inertia = 1 }}
        [joints]
        guide = {{ type = "prismatic", bodies = ["ground", "table"], axis = [0, 1] }}
        [drivers]
        d = {{ type = "displacement", joint = "guide", value = "{V}*t" }}
        [contacts]
        c = {{ type = "plane", point = "A", body = "table", axis = [0, 1], position = [0, 0], restitution = {e} }}
    """

    def right(t: Array) -> Values:
        at = (-V + math.sqrt(V * V + 2 * G * h)) / G
        after = V + e * (V + G * at)
        y, v = h - G * t**2 / 2, -G * t
        begin, place, speed, relative = at, V * at, after, e * (V + G * at)
        while begin < t[-1]:
            u = t - begin
            y = np.where(u > 0, place + speed * u - G * u**2 / 2, y)
            v = np.where(u > 0, speed - G * u, v)
            begin += 2 * relative / G
            relative *= e
            place, speed = V * begin, V + relative
        return {"A.y": y, "A.vy": v, "table.y": V * t}

    return System(
        name="mass_on_a_rising_table", kind="impacts", origin="closed form: v' = V + e (V - v)",
        scene=text, stop=1.0, points=9, right=right, orders=(),
    )  # fmt: skip


def _spinning(name: str, mu: float, velocity: Sequence[float], spin: Sequence[float]) -> System:
    """Ball that hits a rough floor: it slides through the impact, or rolls out of it.

    The tangential impulse is mu times the normal one, or 2/7 m u where that is less: the slip u of
    a ball is parallel to itself and does not act on the normal velocity (Routh 1905).
    """
    m, R, e, h = 0.2, 0.05, 0.7, 0.5
    J = 0.4 * m * R * R
    v0, w0 = np.array([*velocity, 0.0]), np.array(spin)
    text = f"""
        gravity = [0, 0, {-G}]
        [bodies]
        b = {{ position = [0, 0, {R + h}], velocity = {v0.tolist()}, angular_velocity = {w0.tolist()}, mass = {m}, inertia = [{J!r}, {J!r}, {J!r}] }}
        [contacts]
        c = {{ type = "plane", point = "b", axis = [0, 0, 1], radius = {R}, friction = {mu}, restitution = {e} }}
    """
    down = np.array([0.0, 0.0, -R])
    slip = v0 + np.cross(w0, down)
    size = float(np.linalg.norm(slip))
    at, speed = math.sqrt(2 * h / G), math.sqrt(2 * G * h)
    normal = m * (1 + e) * speed
    kick = -min(mu * normal, 2 / 7 * m * size) * slip / size

    def right(t: Array) -> Values:
        hit, u = (t > at)[:, None], np.maximum(t - at, 0.0)
        v = v0 + kick / m * hit
        w = w0 + np.cross(down, kick) / J * hit
        z = R + h - G * t**2 / 2 + (1 + e) * speed * u
        return {"b.z": z, "b.vx": v[:, 0], "b.vy": v[:, 1], "b.vz": -G * t + (1 + e) * speed * (t > at),
                "b.wx": w[:, 0], "b.wy": w[:, 1], "b.wz": w[:, 2]}  # fmt: skip

    return System(
        name=name, kind="impacts", origin="closed form: impulse mu N or 2/7 m u (Routh 1905)",
        scene=text, stop=0.7, points=9, right=right, orders=(),
    )  # fmt: skip


SYSTEMS = (
    _bouncing(0.8, 2.2),
    _bouncing(1.0, 3.1),
    _balls("two_balls", [0.0, 0.5], [1.3, -0.4], [0.2, 0.7], 0.6, 1.0),
    _balls("three_unequal_balls", [0.0, 0.31, 0.72], [2.0, 0.0, 0.0], [0.5, 0.2, 0.9], 1.0, 1.0,
           dimension=3),
    _balls("cradle_with_gaps", [0.0, 0.2, 0.3, 0.45, 0.52], [1.0, 0.0, 0.0, 0.0, 0.0], [0.3] * 5,
           1.0, 1.1),
    _oblique(),
    _rod(1.0),
    _rod(0.3),
    _stops(),
    _stopped_pendulum(),
    _rope(1.0),
    _rope(0.5),
    _table(),
    _spinning("ball_slides_through_an_impact", 0.08, (1.0, 0.4), (10.0, -30.0, 5.0)),
    _spinning("ball_rolls_out_of_an_impact", 0.6, (1.0, 0.4), (10.0, -30.0, 5.0)),
)  # fmt: skip
