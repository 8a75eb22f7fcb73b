"""Problems with impacts, when they hit and what they lose, and how a run is scored.

The references are closed forms (ball) and DOP853 with polished events, run with two step controls
that agree to 3e-11 s (circle, slider-crank). NumPy alone is needed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from benchmarks.problems.parts import Array

GRAVITY = 9.81
FALL = math.sqrt(2.0 / GRAVITY)
"""Time [s] of the first fall from 1 m."""
START = (0.3, 0.0), (0.6, 0.8)
"""Position and velocity of the mass in a circle of 1 m [m, m/s]."""
CIRCLE = (
    0.4941982660591, 0.8282069296622, 1.681786791329, 2.602345089557, 3.294516720469,
    3.594271652386, 3.890731346973, 4.595967468117, 5.516904984944, 6.388115388731,
    6.748494102387, 7.521782727713,
)  # fmt: skip
CIRCLE_LOSSY = (
    0.4941982660591, 0.7269779934221, 0.8485909048961, 0.9162339029737, 0.9528686716561,
)  # fmt: skip
"""The first five of a series that ends at 0.992 s; the mass then slides."""
SLIDER_CRANK = (
    0.00119481935377, 0.002945449291185, 0.003815936076778, 0.004480015883807, 0.007628156450661,
    0.009282173653204, 0.01191150427891, 0.01484520218614, 0.01738819183353, 0.02128714046717,
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Crank:
    """Slider-crank whose wrist pin has a radial clearance; lengths in m, masses in kg."""

    crank: float = 0.05
    rod: float = 0.12
    crank_mass: float = 0.30
    crank_inertia: float = 1e-4
    rod_mass: float = 0.21
    rod_inertia: float = 2.5e-4
    slider_mass: float = 0.14
    clearance: float = 0.5e-3
    speed: float = 100.0
    """Of the crank at the start, where all is stretched along x [rad/s]."""

    @property
    def rod_speed(self) -> float:
        """Of the rod at the start, at which the slider is at rest [rad/s]."""
        return -self.speed * self.crank / self.rod

    def play(self, angles: Array, slider: Array) -> Array:
        """Of the pin's centre from the slider's [m]; angles are absolute, (2, ...)."""
        crank, rod = self.crank * _circle(angles[0]), self.rod * _circle(angles[1])
        return crank + rod - np.stack([slider, np.zeros_like(slider)])

    def play_rate(self, angles: Array, rates: Array, slider_rate: Array) -> Array:
        """Its velocity [m/s]."""
        crank = self.crank * rates[0] * _circle(angles[0] + math.pi / 2)
        rod = self.rod * rates[1] * _circle(angles[1] + math.pi / 2)
        return crank + rod - np.stack([slider_rate, np.zeros_like(slider_rate)])

    def mass(self, angles: Array) -> Array:
        """Mass matrix of (crank angle, rod angle, slider)."""
        l1, l2 = self.crank, self.rod
        own = self.crank_inertia + self.crank_mass * l1**2 / 4 + self.rod_mass * l1**2
        mixed = self.rod_mass * l1 * l2 / 2 * math.cos(angles[0] - angles[1])
        rod = self.rod_inertia + self.rod_mass * l2**2 / 4
        return np.array([[own, mixed, 0.0], [mixed, rod, 0.0], [0.0, 0.0, self.slider_mass]])


CRANK = Crank()


def _circle(angle: Array) -> Array:
    return np.stack([np.cos(angle), np.sin(angle)])


def gap_of(kind: str, q: Array, v: Array) -> tuple[Array, Array]:
    """Gap and its rate [m, m/s] of samples.

    q, v (coordinates, samples) are the height of a ball, the place of a mass in its circle, or the
    angles of crank and rod and the place of the slider.
    """
    if kind == "ball":
        return q[0], v[0]
    place, rate, most = q[:2], v[:2], 1.0
    if kind == "slider_crank":
        place, rate = CRANK.play(q[:2], q[2]), CRANK.play_rate(q[:2], v[:2], v[2])
        most = CRANK.clearance
    r = np.maximum(np.hypot(*place), 1e-12)
    return most - r, -np.sum(place * rate, axis=0) / r


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """A motion with impacts."""

    key: str
    title: str
    kind: str
    """`ball`, `circle` or `slider_crank`."""
    restitution: float
    stop: float
    """End [s], in flight or sliding."""
    hits: tuple[float, ...]
    """Times of the impacts that count [s]."""
    energy: float
    """Reference energy [J]: kinetic at the start, and above the lowest place."""
    loss: float
    """Energy lost in all impacts until the end [J]."""
    mass: float
    """Of a point that hits as hard, from which peers choose their stiffness [kg]."""


def _ball(restitution: float, count: int) -> tuple[float, ...]:
    return tuple(
        FALL * (1.0 + 2.0 * sum(restitution**i for i in range(1, k + 1))) for k in range(count)
    )


PROBLEMS = {
    problem.key: problem
    for problem in (
        Problem(
            key="ball_elastic", title="ball, e = 1, 100 impacts", kind="ball", restitution=1.0,
            stop=200.0 * FALL, hits=_ball(1.0, 100), energy=GRAVITY, loss=0.0, mass=1.0,
        ),
        Problem(
            key="ball_lossy", title="ball, e = 0.8, 6 impacts", kind="ball", restitution=0.8,
            stop=3.0, hits=_ball(0.8, 6), energy=GRAVITY, loss=GRAVITY * (1.0 - 0.8**12), mass=1.0,
        ),
        Problem(
            key="circle_elastic", title="mass in a circle, e = 1, 12 impacts", kind="circle",
            restitution=1.0, stop=8.0, hits=CIRCLE, energy=0.5 + GRAVITY, loss=0.0, mass=1.0,
        ),
        Problem(
            key="circle_lossy", title="mass in a circle, e = 0.5, until it slides", kind="circle",
            restitution=0.5, stop=2.0, hits=CIRCLE_LOSSY, energy=0.5 + GRAVITY,
            loss=6.891693941328, mass=1.0,
        ),
        Problem(
            key="slider_crank", title="slider-crank with clearance, e = 0.9, 10 impacts",
            kind="slider_crank", restitution=0.9, stop=0.0230, hits=SLIDER_CRANK,
            energy=2.310763888888889, loss=0.02039143829513189, mass=0.1,
        ),
    )
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Score:
    """How far a run is from the reference."""

    events: float | None
    """Largest error of an impact's time over that time; None where impacts are missing."""
    energy: float
    """Error of the energy at the end over the reference energy."""
    seen: int
    """Impacts that were found, of those that count."""


def score(problem: Problem, hits: list[float], lost: float) -> Score:
    """Of the times of all impacts [s] and the energy lost [J]."""
    expected = np.array(problem.hits)
    found = np.array(hits[: len(expected)])
    complete = len(found) == len(expected) and bool(np.all(np.isfinite(found)))
    events = float(np.max(np.abs(found / expected - 1.0))) if complete else None
    return Score(events, abs(lost - problem.loss) / problem.energy, len(found))


def touches(t: Array, gap: Array, rate: Array) -> list[float]:
    """When a gap closes [s], from samples of it and of its rate.

    The parabola of the last free sample is continued: at the next one a soft contact acts already.
    """
    last = np.flatnonzero((gap[:-1] > 0.0) & (gap[1:] <= 0.0))
    before = np.maximum(last - 1, 0)
    h = t[last + 1] - t[last]
    free = (before < last) & (gap[before] > 0.0)
    bend = np.where(free, (rate[last] - rate[before]) / h, 0.0)
    g, v = gap[last], rate[last]
    root = np.sqrt(np.maximum(v * v - 2.0 * bend * g, 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        flight = 2.0 * g / (root - v)
    secant = h * g / (g - gap[last + 1])
    good = (flight > 0.0) & (flight <= 1.5 * h)
    return (t[last] + np.where(good, flight, secant)).tolist()


def damping_ratio(restitution: float) -> float:
    """Of a linear spring and damper that pull nothing, as MuJoCo's contact is.

    The contact ends where the force vanishes: with ζ = sin β, e = exp(-(π - 2β) tan β).
    """
    low, high = 0.0, math.pi / 2 - 1e-9
    for _ in range(60):
        beta = 0.5 * (low + high)
        if math.exp(-(math.pi - 2.0 * beta) * math.tan(beta)) > restitution:
            low = beta
        else:
            high = beta
    return 0.0 if restitution == 1.0 else math.sin(low)
