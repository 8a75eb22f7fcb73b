"""Two mechanisms joined by a spring, each an FMU: three ways to take a communication step of H.

    parallel     all FMUs step at once with what the others had at t: what most importers do. The
                 spring of `coupling_spring.toml` is a third FMU, which lags one step behind.
    sequential   the spring steps after the mechanisms, with where they have arrived: the force
                 that they feel is that at the beginning of the step.
    conserving   both feel, for the whole step, the discrete gradient of the spring's energy V,

                     f = k (l_n + l_n1 - 2 l0)/(l_n + l_n1) (d_n + d_n1)/2,

                 d being the vector between the two points and l its length. Then f.(d_n1 - d_n) is
                 V_n1 - V_n whatever the motion: nothing is lost between the FMUs. d_n1 depends on
                 f, so the step is repeated from a saved state until d_n1 stays. The spring's FMU
                 then only follows.

Each FMU keeps its own ledger (energy.balance), so the energy of all three changes by the sum of
their energy.work; the work that one does on the other cancels in it, and what is left over is the
error of the coupling.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from .unit import Unit

MECHANISMS = ("swing", "rocker")
ENDS = {"swing": ("tip", "a"), "rocker": ("corner", "b")}
"""The point of each mechanism that the spring pulls at, and the spring's end there."""
TOLERANCE = 1e-14
"""m: a conserving step ends when the points move less by another repetition."""
MAX_REPETITIONS = 50

Units = dict[str, Unit]
Scheme = Callable[[Units, float, float], None]


@dataclass
class Run:
    """What happened at the communication points, the first one included."""

    t: list[float] = field(default_factory=list)
    """s"""
    positions: list[tuple[float, ...]] = field(default_factory=list)
    """x and y of the two points, m"""
    energy: list[float] = field(default_factory=list)
    """J, of all FMUs"""
    work: list[float] = field(default_factory=list)
    """J: sum of the FMUs' energy.work"""
    works: list[tuple[float, ...]] = field(default_factory=list)
    """J: energy.work of each FMU"""

    def record(self, t: float, units: Units) -> None:
        """Note what the FMUs show at t."""
        works = tuple(unit["energy.work"] for unit in units.values())
        self.t.append(t)
        self.positions.append(tuple(x for name in MECHANISMS for x in place(units, name)))
        self.energy.append(math.fsum(unit["energy.total"] for unit in units.values()))
        self.work.append(math.fsum(works))
        self.works.append(works)

    @property
    def drift(self) -> float:
        """Largest change of the energy of all FMUs, J: the error of the coupling."""
        return max(abs(e - self.energy[0]) for e in self.energy)


def place(units: Units, name: str) -> list[float]:
    """Position of a mechanism's point at the spring, m."""
    point, _ = ENDS[name]
    return units[name].get([f"{point}.x", f"{point}.y"])


def hand_positions(units: Units) -> None:
    """Tell the spring where the mechanisms are."""
    for name, (_, end) in ENDS.items():
        x, y = place(units, name)
        units["spring"].set({f"{end}x": x, f"{end}y": y})


def hand_forces(units: Units) -> None:
    """Let the mechanisms feel the spring."""
    for name, (_, end) in ENDS.items():
        pull(units[name], units["spring"].get([f"on_{end}_x", f"on_{end}_y"]))


def pull(mechanism: Unit, force: Sequence[float]) -> None:
    """Apply a force [N] to a mechanism."""
    mechanism.set({"pull_x": force[0], "pull_y": force[1]})


def parallel(units: Units, t: float, h: float) -> None:
    """All with what the others had at t."""
    hand_positions(units)
    hand_forces(units)
    for unit in units.values():
        unit.step(t, h)


def sequential(units: Units, t: float, h: float) -> None:
    """The mechanisms, then the spring."""
    hand_forces(units)
    for name in MECHANISMS:
        units[name].step(t, h)
    hand_positions(units)
    units["spring"].step(t, h)


def conserving(units: Units, t: float, h: float) -> None:
    """Repeat the mechanisms' steps until the force is the discrete gradient of the spring."""
    saved = {name: units[name].save() for name in MECHANISMS}
    k, l0 = units["spring"].get(["stiffness", "free_length"])
    d_n = d_n1 = distance_vector(units)
    for _ in range(MAX_REPETITIONS):
        guess = d_n1
        force = discrete_gradient(d_n, guess, k, l0)
        for name, sign in zip(MECHANISMS, (1.0, -1.0), strict=True):
            units[name].restore(saved[name])
            pull(units[name], [sign * f for f in force])
            units[name].step(t, h)
        d_n1 = distance_vector(units)
        if math.dist(d_n1, guess) < TOLERANCE:
            break
    for name, state in saved.items():
        units[name].forget(state)
    hand_positions(units)
    units["spring"].step(t, h)


def distance_vector(units: Units) -> list[float]:
    """From the first mechanism's point to the second's, m."""
    first, second = (place(units, name) for name in MECHANISMS)
    return [b - a for a, b in zip(first, second, strict=True)]


def discrete_gradient(
    d_n: Sequence[float], d_n1: Sequence[float], k: float, l0: float
) -> list[float]:
    """Force [N] on the first point over a step, from the vectors [m] at its beginning and end."""
    lengths = math.hypot(*d_n) + math.hypot(*d_n1)
    factor = 0.5 * k * (lengths - 2.0 * l0) / lengths
    return [factor * (a + b) for a, b in zip(d_n, d_n1, strict=True)]


SCHEMES: dict[str, Scheme] = {
    "parallel": parallel,
    "sequential": sequential,
    "conserving": conserving,
}


def run_coupled(units: Units, scheme: Scheme, h: float, steps: int) -> Run:
    """Start the FMUs, still in their initialization, and take communication steps of h [s]."""
    hand_positions(units)
    for unit in units.values():
        unit.start()
    run = Run()
    run.record(0.0, units)
    for i in range(steps):
        scheme(units, i * h, h)
        run.record((i + 1) * h, units)
    return run
