"""Error of a run against the tolerance asked for, and what it costs, for the scenes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import solver
from benchmarks.effort import Effort
from benchmarks.report import Section, Table, Value
from benchmarks.timing import Entry, interleave
from solver.runtime import Integrator, Model

SCENES = Path(__file__).resolve().parents[1] / "scenes"
STOP = 5.0
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9)
SHARPEST = {"smooth": 1e-11, "damped": 1e-7}
"""Tolerance of the run that others are compared with."""

SMOOTH = (
    *("andrews", "bifilar", "bricard", "car_axis", "double_pendulum", "dzhanibekov", "four_bar"),
    *("heavy_top", "pendulum", "rolling_disc", "slider_crank", "snakeboard", "triangle", "watt"),
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
class End:
    """Where a run ended, mass-weighted, and what it cost; `speed` is the scale of v."""

    q: np.ndarray
    v: np.ndarray
    speed: float
    energy: float
    halves: float
    order: float

    def error(self, exact: End) -> float:
        """Larger error of places and rates, relative to size and speed."""
        of_v = np.linalg.norm(self.v - exact.v) / exact.speed
        return float(max(np.linalg.norm(self.q - exact.q), of_v))


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


def move(integrator: Integrator, length: float) -> float:
    """Move in ten communication steps; return the half steps solved."""
    halves = 0.0
    for _ in range(10):
        integrator.advance(integrator.time, length / 10)
        halves += integrator.state.head["substeps"]
    return halves


def end_of(name: str, tolerance: float, stop: float) -> End:
    """Where a run of a scene ends."""
    model, integrator, length = prepared(name, tolerance, stop)
    halves = move(integrator, length)
    dim, free, at = model.sizes["dim"], model.sizes["n_free"], model.offsets["node_mass"]
    root = np.sqrt(np.repeat(np.array(integrator.engine.numbers[at : at + free]), dim))
    vectors, head = integrator.state.vectors, integrator.state.head
    q, v = (np.array(vectors[part])[: dim * free] for part in "qv")
    return End(
        q=root * q / vectors["derived"][1],
        v=root * v,
        speed=math.sqrt(2.0 * head["energy_reference"]),
        energy=float(integrator["energy.error"]),
        halves=halves,
        order=head["order_in_use"],
    )


def measure(effort: Effort) -> Section:
    stop = max(0.01, STOP * effort.scale)
    rows = [
        row(name, kind, tolerance, stop, effort)
        for kind, names in (("smooth", SMOOTH), ("damped", DAMPED))
        for name in (names if effort.steps > 2 else names[:1])
        for tolerance in TOLERANCES[: effort.steps]
        if tolerance > 10.0 * SHARPEST[kind]
    ]
    return Section(
        name="tolerances",
        title="Error against the tolerance asked for",
        method=(
            f"Scenes over {stop:g} s or their own experiment, in ten communication steps, order "
            "and length of internal steps chosen. Error: the larger of places and rates at the "
            "end, in the mass norm over size and speed of the mechanism, against a run with "
            f"{SHARPEST['smooth']:.0e} ({SHARPEST['damped']:.0e} where dampers limit the order)."
        ),
        tables=[Table(title="Tolerances", columns=COLUMNS, rows=rows, formats=FORMATS)],
    )


_EXACT: dict[tuple[str, float], End] = {}


def row(name: str, kind: str, tolerance: float, stop: float, effort: Effort) -> dict[str, Value]:
    """What a tolerance gives and costs."""
    exact = _EXACT.get((name, stop)) or end_of(name, SHARPEST[kind], stop)
    _EXACT[name, stop] = exact
    found = end_of(name, tolerance, stop)
    runs: list[tuple[Integrator, float]] = []

    def prepare() -> None:
        runs[:] = [prepared(name, tolerance, stop)[1:]]

    times = interleave({"run": Entry(lambda: move(*runs[0]), prepare)}, effort)
    return {
        "scene": name,
        "tolerance": tolerance,
        "ratio": found.error(exact) / tolerance,
        "order": found.order,
        "halves": found.halves,
        "ms": 1e3 * times["run"].minimum,
        "energy": found.energy,
    }
