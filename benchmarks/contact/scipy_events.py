"""SciPy's `solve_ivp` with events on reduced equations, restarted after each impact.

The engineer writes what the other codes derive: equations in fewest coordinates (in Python), the
gap as event, Newton's impact law, and that the mass slides when its approach is slower than
`rest_speed`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.contact.methods import Method, Setting
from benchmarks.contact.problems import CRANK, GRAVITY, START, Problem, Score, score
from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_methods import GaveUpError
from benchmarks.problems.parts import Array

METHOD_NAMES = ("RK45", "DOP853", "LSODA")
TOLERANCES = tuple(10.0**-k for k in range(3, 13))
REST_SPEED = 1e-2
"""Approach below which a mass stays on the wall [m/s]."""
LEAVE = 1e-9
"""Of the stretch behind an impact in which the same gap does not count again [s]."""
MOST = 500
"""Impacts after which a run is given up: they do not end."""


@dataclass(frozen=True, slots=True)
class Motion:
    """A mechanism with one gap, in fewest coordinates."""

    start: Array
    rates: Callable[[float, Array], Array]
    gap: Callable[[float, Array], float]
    bounce: Callable[[Array, float], tuple[Array, float]]
    """State after an impact with a restitution, and the gap's rate before it [m/s]."""
    energy: Callable[[Array], float]
    slide: Callable[[Array, float, dict[str, float | str]], Array] | None = None
    """State after sliding for some time with tolerances."""


def _ball() -> Motion:
    def bounce(y: Array, restitution: float) -> tuple[Array, float]:
        return np.array([0.0, -restitution * y[1]]), y[1]

    return Motion(
        start=np.array([1.0, 0.0]),
        rates=lambda _, y: np.array([y[1], -GRAVITY]),
        gap=lambda _, y: y[0],
        bounce=bounce,
        energy=lambda y: 0.5 * y[1] ** 2 + GRAVITY * y[0],
    )


def _circle() -> Motion:
    def bounce(y: Array, restitution: float) -> tuple[Array, float]:
        n = y[:2] / math.hypot(y[0], y[1])
        outward = float(y[2:] @ n)
        # On the wall exactly: else the error of the root stays in the gap.
        return np.concatenate([n, y[2:] - (1.0 + restitution) * outward * n]), -outward

    def slide(y: Array, stop: float, options: dict[str, float | str]) -> Array:
        angle, speed = math.atan2(y[0], -y[1]), y[3] * y[0] - y[2] * y[1]
        pendulum = lambda _, z: np.array([z[1], -GRAVITY * math.sin(z[0])])  # noqa: E731
        solution = solve_ivp(pendulum, (0.0, stop), [angle, speed], **options)
        angle, speed = solution.y[:, -1]
        s, c = math.sin(angle), math.cos(angle)
        return np.array([s, -c, speed * c, speed * s])

    return Motion(
        start=np.concatenate(START),
        rates=lambda _, y: np.array([y[2], y[3], 0.0, -GRAVITY]),
        gap=lambda _, y: 1.0 - math.hypot(y[0], y[1]),
        bounce=bounce,
        energy=lambda y: float(0.5 * y[2:] @ y[2:]) + GRAVITY * y[1],
        slide=slide,
    )


def _slider_crank() -> Motion:
    coupling = CRANK.rod_mass * CRANK.crank * CRANK.rod / 2

    def rates(_: float, y: Array) -> Array:
        k = coupling * math.sin(y[0] - y[1])
        a, b, _, _, d, *_ = CRANK.mass(y).flat
        right = -k * y[4] ** 2, k * y[3] ** 2
        det = a * d - b * b
        bends = (d * right[0] - b * right[1]) / det, (a * right[1] - b * right[0]) / det
        return np.array([y[3], y[4], y[5], *bends, 0.0])

    def gap(_: float, y: Array) -> float:
        x = CRANK.crank * math.cos(y[0]) + CRANK.rod * math.cos(y[1]) - y[2]
        z = CRANK.crank * math.sin(y[0]) + CRANK.rod * math.sin(y[1])
        return CRANK.clearance - math.hypot(x, z)

    def bounce(y: Array, restitution: float) -> tuple[Array, float]:
        play = CRANK.play(y[:2], y[2])
        n = -play / math.hypot(*play)
        row = np.array([
            CRANK.crank * (n[1] * math.cos(y[0]) - n[0] * math.sin(y[0])),
            CRANK.rod * (n[1] * math.cos(y[1]) - n[0] * math.sin(y[1])),
            -n[0],
        ])  # fmt: skip
        lever = np.linalg.solve(CRANK.mass(y), row)
        rate = float(row @ y[3:])
        v = y[3:] - (1.0 + restitution) * rate / float(row @ lever) * lever
        return np.concatenate([y[:3], v]), rate

    speeds = CRANK.speed, CRANK.rod_speed, 0.0
    return Motion(
        start=np.array([0.0, 0.0, CRANK.crank + CRANK.rod, *speeds]),
        rates=rates,
        gap=gap,
        bounce=bounce,
        energy=lambda y: float(0.5 * y[3:] @ CRANK.mass(y) @ y[3:]),
    )


MOTIONS = {"ball": _ball(), "circle": _circle(), "slider_crank": _slider_crank()}


def solve(problem: Problem, setting: Setting) -> tuple[list[float], Array]:
    """Times of the impacts [s], and the state at the end."""
    motion = MOTIONS[problem.kind]
    options = {"method": setting["method"], "rtol": setting["tolerance"]}
    options["atol"] = 1e-2 * setting["tolerance"]

    def event(t: float, y: Array) -> float:
        # A gap that has just been hit does not count before it is left.
        return motion.gap(t, y) if t > since + LEAVE else LEAVE

    event.terminal, event.direction = True, -1.0
    since, y, hits = 0.0, motion.start, []
    while True:
        solution = solve_ivp(motion.rates, (since, problem.stop), y, events=event, **options)
        if solution.status < 0 or len(hits) == MOST:
            message = solution.message
            raise GaveUpError(message)
        y = solution.y[:, -1]
        if solution.status == 0:
            return hits, y
        since = float(solution.t[-1])
        hits.append(since)
        left, rate = motion.bounce(y, problem.restitution)
        if motion.slide and -rate < REST_SPEED:
            y = motion.bounce(y, 0.0)[0]
            return hits, motion.slide(y, problem.stop - since, options)
        y = left


def _score(problem: Problem, setting: Setting) -> Score:
    hits, y = solve(problem, setting)
    energy = MOTIONS[problem.kind].energy
    return score(problem, hits, energy(MOTIONS[problem.kind].start) - energy(y))


def _families(_: Problem) -> Iterable[Iterable[Setting]]:
    for method in METHOD_NAMES:
        # Without a tolerance `solve_ivp` takes the first one.
        yield [{"method": method, "tolerance": tolerance} for tolerance in TOLERANCES]


METHODS = (
    Method(
        name="SciPy with events",
        families=_families,
        label=lambda setting: f"{setting['method']}, tolerance {setting['tolerance']:.0e}",
        entry=lambda problem, setting: Entry(lambda: solve(problem, setting)),
        score=_score,
    ),
)
