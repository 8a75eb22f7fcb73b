"""Random laws with switches on simple mechanisms, and their motion by SciPy's DOP853, cut there.

A law is drawn once and written twice: as an expression of a scene, and as a Python function that
reads the side of each switch from a list, so that it is smooth between switches. The reference
integrates these smooth pieces, ends each at the first crossing and goes on with the other side.
"""

from __future__ import annotations

import math
import random
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

import solver

Array = NDArray[np.float64]
GRAVITY = 9.81
MOST_CROSSINGS = 300
"""Of a run that is compared."""
MOST_EVALUATIONS = 200_000
"""Of a law in its references: where it has no finite slope they end nowhere."""
LATER = 1e-7
"""Time after a crossing at which the other side tells whether it leads on [s]."""


class UnfitError(Exception):
    """A law that has no motion to compare: it slides along a switch, touches it or chatters."""


@dataclass(frozen=True)
class Switch:
    """What decides between the smooth pieces of a law."""

    argument: str
    """Python expression of t, the quantities and the sides S of switches before it."""
    is_level: bool = False
    """Whether its side is the whole number below the argument, and not the sign."""
    times: Callable[[float], list[float]] | None = None
    """Times up to an end at which it is crossed, of one that depends on the time alone."""

    def side(self, value: float) -> float:
        """Side of a value."""
        return math.floor(value) if self.is_level else math.copysign(1.0, value)


@dataclass
class Law:
    """A random formula: its text in a scene, and in Python with sides S."""

    chance: random.Random
    quantities: Sequence[str]
    """Names of a scene that it may read besides t."""
    switches: list[Switch] = field(default_factory=list)
    evaluations: int = 0
    """So far, in references."""

    def count(self) -> None:
        """Count an evaluation."""
        self.evaluations += 1
        if self.evaluations > MOST_EVALUATIONS:
            raise UnfitError

    def number(self, low: float, high: float) -> float:
        """A number of a few digits, so that text and Python agree."""
        return round(self.chance.uniform(low, high), 4)

    def smooth(self) -> str:
        """A smooth factor of size 1."""
        x = self.chance.choice(self.quantities) if self.quantities else "t"
        return self.chance.choice(
            ["1", f"cos({self.number(1, 5)}*t)", f"(1 + 0.5*{x})", f"sin({x})", f"({x})**2"]
        )

    def of_time(self) -> tuple[str, Callable[[float], list[float]]]:
        """An argument of the time alone, with its roots."""
        c, w = self.number(0.05, 2.5), self.number(2, 15)
        if self.chance.random() < 0.5:
            return f"t - {c}", lambda _: [c]
        level, begin = self.number(-0.9, 0.9), self.number(0, 3)
        ways = (math.asin(level), math.pi - math.asin(level))

        def roots(end: float) -> list[float]:
            turns = range(-1, int(w * end / 2 / math.pi) + 2)
            return [(way + 2 * math.pi * k - begin) / w for k in turns for way in ways]

        return f"sin({w}*t + {begin}) - ({level})", roots

    def of_motion(self) -> str:
        """An argument that reads the motion."""
        x, y = (self.chance.choice(self.quantities) for _ in range(2))
        c, w = self.number(-0.6, 0.6), self.number(1, 6)
        return self.chance.choice([
            f"{x} - ({c})", f"{x} - ({c})", f"{x}*{y} - ({c})", f"{x} + {y}*{y} - ({c})",
            f"{x} - 0.4*sin({w}*t) - ({c})", f"{x} + 0.3*{y} - ({c})",
        ])  # fmt: skip

    def switch(self, argument: str, **how: Any) -> str:
        """A switch of this argument; its side in Python."""
        self.switches.append(Switch(argument, **how))
        return f"S[{len(self.switches) - 1}]"

    def argument(self) -> tuple[str, dict[str, Any]]:
        """An argument and how its switch is found."""
        if not self.quantities or self.chance.random() < 0.35:
            text, times = self.of_time()
            return text, {"times": times}
        return self.of_motion(), {}

    def term(self, *, continuous: bool = False) -> tuple[str, str]:
        """A term with a switch: text and Python."""
        u, how = self.argument()
        kinds = ["abs", "min", "max"]
        kinds += [] if continuous else ["sign", "choice", "pulse", "floor", "mod", "guard", "both"]
        kind = self.chance.choice(kinds)
        c = self.number(-0.4, 0.4)
        if kind in ("floor", "mod"):
            return self.steps(kind, u, is_of_time="times" in how)
        if kind in ("min", "max") and "times" in how:
            s = self.switch(u, **how)  # compared with 0, whose roots are known
            sides = ("<", f"min({u}, 0)") if kind == "min" else (">", f"max(0, {u})")
            return sides[1], f"(({u}) if {s} {sides[0]} 0 else 0.0)"
        if kind in ("min", "max"):
            v = f"{c}*{self.smooth()}"
            s = self.switch(f"({u}) - ({v})")
            way = "<" if kind == "min" else ">"
            return f"{kind}({u}, {v})", f"(({u}) if {s} {way} 0 else ({v}))"
        s = self.switch(u, **how)
        if kind == "abs":
            return f"abs({u})", f"({s}*({u}))"
        if kind == "sign":
            return f"sign({u})", s
        a, b = self.smooth(), f"{c}*{self.smooth()}"
        if kind == "guard":
            root = self.chance.choice(["sqrt({})", "({})**1.5", "({})*log({})"])
            value = root.replace("{}", "abs({})").replace("{}", u)
            text = root.replace("{}", u)
            return f"({text} if {u} > 0 else {c})", f"({value} if {s} > 0 else {c})"
        if kind == "choice":
            return f"({a} if {u} > 0 else {b})", f"(({a}) if {s} > 0 else ({b}))"
        v, how = self.argument()
        other = self.switch(v, **how)
        if kind == "pulse":
            return (
                f"({a} if {u} > 0 and {v} < 0 else 0)",
                f"(({a}) if {s} > 0 and {other} < 0 else 0.0)",
            )
        return (
            f"({a} if {u} > 0 or {v} > 0 else {b})",
            f"(({a}) if {s} > 0 or {other} > 0 else ({b}))",
        )

    def steps(self, kind: str, u: str, *, is_of_time: bool) -> tuple[str, str]:
        """Stairs or a saw of an argument; of the time alone, of a part of it."""
        how: dict[str, Any] = {}
        if is_of_time:
            rate = self.number(1, 6)
            u = f"{rate}*t"
            how["times"] = lambda end: [k / rate for k in range(1, int(rate * end) + 1)]
        if kind == "floor":
            u = u if is_of_time else f"({u})/0.5"
            s = self.switch(u, is_level=True, **how)
            return f"0.3*floor({u})", f"0.3*{s}"
        if is_of_time:
            s = self.switch(u, is_level=True, **how)
            return f"mod({u}, 1)", f"({u} - {s})"
        s = self.switch(f"({u})/0.7", is_level=True)
        return f"mod({u}, 0.7)", f"({u} - 0.7*{s})"

    def formula(self, *, continuous: bool = False) -> tuple[str, str]:
        """One to three terms: text and Python."""
        texts, codes = [], []
        for _ in range(self.chance.choice([1, 1, 2, 3])):
            text, code = self.term(continuous=continuous)
            c = self.number(-2, 2)
            by = "1" if continuous else self.smooth()
            texts.append(f"({c})*{by}*{text}")
            codes.append(f"({c})*{by}*{code}")
        return " + ".join(texts), " + ".join(codes)


SMALLEST = 5e-324
"""In the place of 0, which rounding may make of a place at its switch: x log(x) goes to 0."""


def compiled(code: str, quantities: Sequence[str]) -> Callable[..., Any]:
    """Function of t, the quantities and S of a Python expression with names of a scene."""
    for name in sorted(quantities, key=len, reverse=True):
        code = code.replace(name, name.replace(".", "_"))
    names = {x: getattr(np, x) for x in ("sin", "cos", "sqrt", "abs")}
    names["log"] = lambda x: np.log(x or SMALLEST)
    arguments = ", ".join(["t", *(x.replace(".", "_") for x in quantities), "S"])
    return eval(f"lambda {arguments}: {code}", names)


@dataclass(frozen=True)
class _Beyond:
    """An event of SciPy: an argument leaves its side at a level, upwards (way 1) or downwards."""

    argument: Callable[..., float]
    sides: list[float]
    k: int
    level: float
    way: int
    terminal: bool = True
    direction: float = -1.0

    def __call__(self, t: float, y: Array) -> float:
        return self.way * (self.level - self.argument(self.k, t, y, self.sides))


@dataclass(frozen=True)
class Case:
    """A scene, and its motion in coordinates of its own."""

    scene: str
    stop: float
    points: int
    """Communication steps."""
    outputs: Sequence[str]
    law: Law
    start: Sequence[float]
    rates: Callable[[float, Array, list[float]], Sequence[float]]
    """Rates of the coordinates on given sides."""
    measured: Callable[[float, Array, list[float]], Sequence[float]]
    """Values of the outputs: places and velocities in turn, as `outputs` are."""
    read: Callable[[float, Array], Sequence[float]]
    """Values of the quantities that the law reads."""

    def times(self) -> Array:
        """Communication points [s]."""
        return np.linspace(0.0, self.stop, self.points + 1)

    def moved(self, start: Sequence[float]) -> tuple[Array, int]:
        """Values of the outputs at the communication points (n, outputs), and crossings."""
        switches = self.law.switches
        arguments = [compiled(x.argument, self.law.quantities) for x in switches]

        def argument(k: int, t: float, y: Array, sides: list[float]) -> float:
            return float(arguments[k](t, *self.read(t, y), sides))

        cuts = {self.stop}
        for x in switches:
            cuts |= {u for u in (x.times(self.stop) if x.times else []) if 0 < u < self.stop}
        ends, values = self.times(), []
        t, y, crossings = 0.0, np.array(start, dtype=float), 0
        sides = [0.0] * len(switches)
        for k, x in enumerate(switches):
            sides[k] = x.side(argument(k, t, y, sides))
        for cut in sorted(cuts):
            middle = 0.5 * (t + cut)
            for k, x in enumerate(switches):
                if x.times:
                    sides[k] = x.side(argument(k, middle, y, sides))
            while t < cut:
                self.settle(argument, t, y, sides)
                t, y, which, found = self.piece(argument, t, y, cut, sides, ends)
                values += found
                if which is not None:
                    k, way = which
                    sides[k] = sides[k] + way if switches[k].is_level else float(way)
                    crossings += 1
                    if crossings > MOST_CROSSINGS:
                        raise UnfitError
        values.append(self.measured(t, y, sides))
        return np.array(values), crossings

    def settle(self, argument: Any, t: float, y: Array, sides: list[float]) -> None:
        """Let switches of the motion that jump with others follow; refuse what leads back."""
        later = y + LATER * np.array(self.rates(t, y, sides))
        for k, x in enumerate(self.law.switches):
            if x.times:
                continue
            here, there = argument(k, t, y, sides), argument(k, t + LATER, later, sides)
            is_near = abs(here - (round(here) if x.is_level else 0.0)) < 1e-8
            if not is_near and x.side(here) != sides[k]:
                sides[k] = x.side(here)
                self.settle(argument, t, y, sides)
                return
            if is_near and x.side(there) != sides[k]:
                raise UnfitError

    def piece(
        self, argument: Any, t: float, y: Array, cut: float, sides: list[float], ends: Array
    ) -> tuple[float, Array, tuple[int, int] | None, list[Sequence[float]]]:
        """Integrate to the first crossing or the cut; with what is measured on the way."""
        events, which = [], []
        for k, x in enumerate(self.law.switches):
            ways = [] if x.times else [1, -1] if x.is_level else [-int(sides[k])]
            for way in ways:
                level = sides[k] + (way > 0) if x.is_level else 0.0

                events.append(_Beyond(argument, sides, k, level, way))
                which.append((k, way))

        def rates(t: float, y: Array) -> Sequence[float]:
            self.law.count()
            return self.rates(t, y, sides)

        run = solve_ivp(
            rates, (t, cut), y, method="DOP853", rtol=1e-11,
            atol=1e-13, max_step=0.02, events=events or None, dense_output=True,
        )  # fmt: skip
        if run.status < 0:
            raise UnfitError
        end = float(run.t[-1])
        asked = [u for u in ends if t <= u < end]
        found = [self.measured(u, run.sol(u), sides) for u in asked]
        crossed = None
        if run.status == 1:
            crossed = next(w for w, at in zip(which, run.t_events, strict=True) if len(at))
        return end, run.y[:, -1], crossed, found


def of_point(law: Law, chance: random.Random, stop: float, points: int) -> Case:
    """A free point under a law along x and a spring by a formula."""
    text, code = law.formula()
    across, code_across = law.formula() if chance.random() < 0.3 else ("0", "0.0")
    force, push = (compiled(x, law.quantities) for x in (code, code_across))
    k, damping = law.number(0, 8), law.number(0, 0.5)
    x, y, u, v = (law.number(-1, 1) for _ in range(4))
    scene = f"""
name = "point"
dimension = 2
[points]
A = {{ position = [{x}, {y}], mass = 1.0, velocity = [{u}, {v}] }}
[forces.f]
type = "force"
point = "A"
value = ["{text} - {k}*A.x - {damping}*A.vx", "{across} - {k}*A.y"]
"""

    def rates(t: float, s: Array, sides: list[float]) -> Sequence[float]:
        x, y, u, v = s
        return (
            u,
            v,
            force(t, x, u, y, v, sides) - k * x - damping * u,
            push(t, x, u, y, v, sides) - k * y,
        )

    def read(_t: float, s: Array) -> Sequence[float]:
        return s[0], s[2], s[1], s[3]

    return Case(
        scene,
        stop,
        points,
        ("A.x", "A.y", "A.vx", "A.vy"),
        law,
        (x, y, u, v),
        rates,
        lambda _t, s, _sides: s.tolist(),
        read,
    )


def of_pendulum(law: Law, _chance: random.Random, stop: float, points: int) -> Case:
    """A point on a rod, under gravity and a law along x."""
    text, code = law.formula()
    force = compiled(code, law.quantities)
    a, w = law.number(-2.5, 2.5), law.number(-3, 3)
    p, q = (math.sin(a), -math.cos(a)), (w * math.cos(a), w * math.sin(a))
    scene = f"""
name = "pendulum"
dimension = 2
gravity = [0, -{GRAVITY}]
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = [{p[0]!r}, {p[1]!r}], mass = 1.0, velocity = [{q[0]!r}, {q[1]!r}] }}
[joints]
r = {{ type = "distance", points = ["O", "A"] }}
[forces]
f = {{ type = "force", point = "A", value = ["{text}", 0] }}
"""

    def values(_t: float, s: Array, _sides: Any = None) -> Sequence[float]:
        a, w = s
        return math.sin(a), -math.cos(a), w * math.cos(a), w * math.sin(a)

    def read(t: float, s: Array) -> Sequence[float]:
        x, y, u, v = values(t, s)
        return x, u, y, v

    def rates(t: float, s: Array, sides: list[float]) -> Sequence[float]:
        a, w = s
        return w, -GRAVITY * math.sin(a) + math.cos(a) * force(t, *read(t, s), sides)

    return Case(
        scene, stop, points, ("A.x", "A.y", "A.vx", "A.vy"), law, (a, w), rates, values, read
    )


def of_driven_pendulum(law: Law, _chance: random.Random, stop: float, points: int) -> Case:
    """A point on a rod whose pivot a driver leads along x, by a course with kinks.

    With u = w + p' cos a, p the course, a'' + p'' cos a = -g sin a is u' = -(g + p' w) sin a, and
    an impulse where p' jumps leaves u as it is.
    """
    law.quantities = ()
    text, code = law.formula(continuous=True)
    wave = f" + 0.2*sin({law.number(1, 6)}*t)"
    course = compiled(code + wave, ())
    a, w = law.number(-2.5, 2.5), law.number(-2, 2)

    def rate(t: float, sides: list[float]) -> float:
        return float(np.imag(course(t + 1e-30j, sides)) / 1e-30)

    def values(t: float, s: Array, sides: list[float]) -> Sequence[float]:
        a, p, speed = float(s[0]), float(course(t, sides)), rate(t, sides)
        w = float(s[1]) - speed * math.cos(a)
        return (p + math.sin(a), -math.cos(a), speed + w * math.cos(a), w * math.sin(a))

    def rates(t: float, s: Array, sides: list[float]) -> Sequence[float]:
        a, u = s
        w = u - rate(t, sides) * math.cos(a)
        return w, -(GRAVITY + rate(t, sides) * w) * math.sin(a)

    begin = [x.side(float(compiled(x.argument, ())(0.0, []))) for x in law.switches]
    p = float(course(0.0, begin))
    x, y, u, v = values(0.0, np.array([a, w + rate(0.0, begin) * math.cos(a)]), begin)
    scene = f"""
name = "driven_pendulum"
dimension = 2
gravity = [0, -{GRAVITY}]
[points]
O = {{ position = [{p!r}, 0] }}
A = {{ position = [{x!r}, {y!r}], mass = 1.0, velocity = [{u!r}, {v!r}] }}
[joints]
r = {{ type = "distance", points = ["O", "A"] }}
[drivers]
d = {{ type = "position", point = "O", value = ["{text}{wave}", "0"] }}
"""
    start = (a, w + rate(0.0, begin) * math.cos(a))
    return Case(
        scene,
        stop,
        points,
        ("A.x", "A.y", "A.vx", "A.vy"),
        law,
        start,
        rates,
        values,
        lambda _t, _s: (),
    )


def of_double_pendulum(law: Law, _chance: random.Random, stop: float, points: int) -> Case:
    """Two points on rods, one after the other, and a law at the end."""
    text, code = law.formula()
    force = compiled(code, law.quantities)
    a, b, v, w = (law.number(-1, 1) for _ in range(4))

    def values(_t: float, s: Any, _sides: Any = None) -> Sequence[float]:
        a, b, v, w = s
        x, y, u, z = math.sin(a), -math.cos(a), v * math.cos(a), v * math.sin(a)
        return (
            x,
            y,
            x + math.sin(b),
            y - math.cos(b),
            u,
            z,
            u + w * math.cos(b),
            z + w * math.sin(b),
        )

    x = values(0.0, (a, b, v, w))
    scene = f"""
name = "double_pendulum"
dimension = 2
gravity = [0, -{GRAVITY}]
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = [{x[0]!r}, {x[1]!r}], mass = 1.0, velocity = [{x[4]!r}, {x[5]!r}] }}
B = {{ position = [{x[2]!r}, {x[3]!r}], mass = 0.5, velocity = [{x[6]!r}, {x[7]!r}] }}
[joints]
r = {{ type = "distance", points = ["O", "A"] }}
s = {{ type = "distance", points = ["A", "B"] }}
[forces]
f = {{ type = "force", point = "B", value = ["{text}", 0] }}
"""

    def read(t: float, s: Array) -> Sequence[float]:
        x = values(t, s)
        return x[0], x[4], x[2], x[6]

    def rates(t: float, s: Array, sides: list[float]) -> Sequence[float]:
        a, b, v, w = s
        f = force(t, *read(t, s), sides)
        c, d = 0.5 * math.cos(a - b), 0.5 * math.sin(a - b)
        first = -d * w * w - 1.5 * GRAVITY * math.sin(a) + f * math.cos(a)
        second = d * v * v - 0.5 * GRAVITY * math.sin(b) + f * math.cos(b)
        down = 1.5 * 0.5 - c * c
        return v, w, (0.5 * first - c * second) / down, (1.5 * second - c * first) / down

    outputs = ("A.x", "A.y", "B.x", "B.y", "A.vx", "A.vy", "B.vx", "B.vy")
    return Case(scene, stop, points, outputs, law, (a, b, v, w), rates, values, read)


KINDS: Mapping[Callable[..., Case], Sequence[str]] = {
    of_point: ("A.x", "A.vx", "A.y", "A.vy"),
    of_pendulum: ("A.x", "A.vx", "A.y", "A.vy"),
    of_driven_pendulum: (),
    of_double_pendulum: ("A.x", "A.vx", "B.x", "B.vx"),
}


def drawn(seed: str) -> Case:
    """The case of a seed."""
    chance = random.Random(seed)
    kind = chance.choice(list(KINDS))
    stop = round(chance.uniform(0.5, 3.0), 2)
    return kind(Law(chance, KINDS[kind]), chance, stop, chance.choice([1, 3, 10, 40]))


MOST_GROWTH = 1e3
"""Growth of a small change at the start beyond which runs are not compared."""


def excess(case: Case, tolerance: float, method: str = "conserving") -> float:
    """Error of a run over the request, and over the growth of a small change at the start.

    Errors are over the largest place and speed of the run, or 1 m and 1 m/s. UnfitError is
    raised also where a change of 1e-6 at the start gives other crossings, or grows beyond all
    bounds.
    """
    right, crossings = case.moved(case.start)
    change = 1e-6 * (-1.0) ** np.arange(len(case.start))
    near, others = case.moved(list(np.array(case.start) + change))
    half = len(case.outputs) // 2
    scale = np.maximum(1.0, [np.abs(right[:, :half]).max(), np.abs(right[:, half:]).max()])
    scale = np.repeat(scale, half)
    growth = max(1.0, float(np.abs((near - right) / scale).max()) / 1e-6)
    if others != crossings or growth > MOST_GROWTH:
        raise UnfitError
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        run = solver.simulate(
            solver.loads(case.scene), stop_time=case.stop, step_size=case.stop / case.points,
            outputs=list(case.outputs), tolerance=tolerance, method=method,
        )  # fmt: skip
    found = np.column_stack([run[x] for x in case.outputs])
    return float(np.abs((found - right) / scale).max()) / tolerance / growth
