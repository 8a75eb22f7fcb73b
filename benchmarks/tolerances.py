"""Error of a run against the tolerance asked for, and what it costs, for the scenes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import solver
from benchmarks.effort import Effort
from benchmarks.report import Section, Table, Value
from benchmarks.timing import Entry, interleave
from solver.runtime import Integrator, Model
from tests.kernel_calls import kernel_of

SCENES = Path(__file__).resolve().parents[1] / "scenes"
STOP = 5.0
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10)
POINTS = 10
SHARPEST = 1e-12
"""Tolerance of the run that others are compared with."""

SMOOTH = (
    *("andrews", "bifilar", "bricard", "car_axis", "chaplygin_sleigh", "double_pendulum"),
    *("dzhanibekov", "four_bar", "heavy_top", "peaucellier", "pendulum", "rolling_disc"),
    *("screw_jack", "sleeping_top", "slider_crank", "snakeboard", "spatial_slider_crank"),
    *("stephenson", "triangle", "watt"),
)
DAMPED = ("spring_pendulum", "double_wishbone", "flyball_governor")

COLUMNS = {
    "scene": "scene",
    "tolerance": "tolerance",
    "ratio": "error/tolerance",
    "order": "last order",
    "halves": "half steps",
    "ms": "ms",
    "energy": "energy error",
}
FORMATS = {
    "tolerance": ".0e",
    "ratio": ".2g",
    "order": "g",
    "halves": "g",
    "ms": ".2f",
    "energy": ".0e",
}


@dataclass(frozen=True, slots=True)
class Course:
    """Where a run is at its communication points, and what it cost.

    `q`, `v` (points, coordinates): mass-weighted, q over the size; `speed` is the scale of v.
    """

    q: np.ndarray
    v: np.ndarray
    speed: float
    energy: float
    halves: float
    order: float

    def error(self, exact: Course) -> float:
        """Largest error of places and rates at any point, relative to size and speed."""
        of_q = np.linalg.norm(self.q - exact.q, axis=1)
        of_v = np.linalg.norm(self.v - exact.v, axis=1) / exact.speed
        return float(max(of_q.max(), of_v.max()))


def prepared(name: str, tolerance: float, stop: float) -> tuple[Model, Integrator, float]:
    """A scene that is about to move for `stop` s, or as long as its experiment, if that is less."""
    drawn = solver.load(SCENES / f"{name}.toml", {"solver.tolerance": tolerance})
    model = solver.assemble(drawn)
    start, end, *_ = model.experiment
    length = min(stop, end - start)
    integrator = Integrator(model)
    integrator["solver.longest_step"] = 1e6  # the scenes' own steps are those of order 2
    integrator.initialise()
    integrator.state.head["horizon"] = length
    return model, integrator, length


def move(integrator: Integrator, length: float, points: int = POINTS) -> Iterator[float]:
    """Move from one communication point to the next; yield the half steps solved."""
    for _ in range(points):
        integrator.advance(integrator.time, length / points)
        yield integrator.state.head["substeps"]


def course_of(name: str, tolerance: float, stop: float, *, each: int = 1) -> Course:
    """Where a run of a scene is at its communication points; `each` times as many are taken."""
    model, integrator, length = prepared(name, tolerance, stop)
    dim, free, at = model.sizes["dim"], model.sizes["n_free"], model.offsets["node_mass"]
    root = np.sqrt(np.repeat(np.array(kernel_of(integrator).numbers[at : at + free]), dim))
    vectors, head = integrator.state.vectors, integrator.state.head
    halves, found = 0.0, []
    for k, solved in enumerate(move(integrator, length, each * POINTS), 1):
        halves += solved
        if k % each == 0:
            found.append([root * np.array(vectors[part])[: dim * free] for part in "qv"])
    return Course(
        q=np.array([q for q, _ in found]) / vectors["derived"][1],
        v=np.array([v for _, v in found]),
        speed=math.sqrt(2.0 * head["energy_reference"]),
        energy=float(integrator["energy.error"]),
        halves=halves,
        order=head["order_in_use"],
    )


def measure(effort: Effort) -> Section:
    stop = max(0.01, STOP * effort.scale)
    rows = [
        row(name, tolerance, stop, effort)
        for names in (SMOOTH, DAMPED)
        for name in (names if effort.steps > 2 else names[:1])
        for tolerance in TOLERANCES[: effort.steps]
    ]
    return Section(
        name="tolerances",
        title="Error against the tolerance asked for",
        method=(
            f"Scenes over {stop:g} s or their own experiment, in ten communication steps, order "
            "and length of internal steps chosen. Error: the largest of places and rates at any "
            "of the points, in the mass norm over size and speed of the mechanism, against a run "
            f"with {SHARPEST:.0e}."
        ),
        tables=[Table(title="Tolerances", columns=COLUMNS, rows=rows, formats=FORMATS)],
    )


_EXACT: dict[tuple[str, float], Course] = {}


def row(name: str, tolerance: float, stop: float, effort: Effort) -> dict[str, Value]:
    """What a tolerance gives and costs."""
    exact = _EXACT.get((name, stop)) or course_of(name, SHARPEST, stop)
    _EXACT[name, stop] = exact
    found = course_of(name, tolerance, stop)
    runs: list[tuple[Integrator, float]] = []

    def prepare() -> None:
        runs[:] = [prepared(name, tolerance, stop)[1:]]

    times = interleave({"run": Entry(lambda: sum(move(*runs[0])), prepare)}, effort)
    return {
        "scene": name,
        "tolerance": tolerance,
        "ratio": found.error(exact) / tolerance,
        "order": found.order,
        "halves": found.halves,
        "ms": 1e3 * times["run"].minimum,
        "energy": found.energy,
    }
