"""Error of a run against the tolerance asked for, and what it costs, for the scenes.

The price of a tolerance is its time over that of the best fixed step, of any order, whose errors
are no larger at any communication point.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

import solver
from benchmarks.measuring.effort import Effort
from benchmarks.measuring.timing import Entry, interleave
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.sections.work_precision_ours import STAGES, STEPPED_BY
from solver.runtime import Integrator, Model, StepError
from tests.support.kernel.kernel_calls import kernel_of

SCENES = Path(__file__).resolve().parents[2] / "scenes"
STOP = 5.0
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10)
POINTS = 10
SHARPEST = 1e-12
"""Tolerance of the run that others are compared with."""
PRICED = 1e-6
"""Tolerance whose price is measured."""
DEAR, MOST_DEAR = 1.5, 3
"""Goal: no more than so many scenes at which it costs so many times the best fixed step."""
LONGER = 3.0
"""An order that needs so many times the half steps of another is not the best."""

SMOOTH = (
    *("andrews", "bifilar", "bricard", "car_axis", "chaplygin_sleigh", "double_pendulum"),
    *("dzhanibekov", "four_bar", "heavy_top", "peaucellier", "pendulum", "rolling_disc"),
    *("screw_jack", "sleeping_top", "slider_crank", "snakeboard", "spatial_slider_crank"),
    *("stephenson", "triangle", "watt"),
)
DAMPED = ("spring_pendulum", "double_wishbone", "flyball_governor")

COLUMNS = {
    "scene": "scene",
    "method": "method",
    "tolerance": ("tolerance", ".0e"),
    "ratio": ("error/tolerance", ".2g"),
    "order": ("last order", "g"),
    "halves": ("half steps", "g"),
    "ms": ("ms", ".2f"),
    "energy": ("energy error", ".0e"),
}
PRICES = {
    "scene": "scene",
    "method": "method",
    "error": ("error", ".1e"),
    "order": ("last order", "g"),
    "halves": ("half steps", "g"),
    "ms": ("ms", ".2f"),
    "fixed_order": ("best order", "g"),
    "fixed_halves": ("its half steps", "g"),
    "fixed_ms": ("its ms", ".2f"),
    "price": ("times as long", ".2f"),
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


def prepared(
    name: str, method: str, tolerance: float, stop: float
) -> tuple[Model, Integrator, float]:
    """A scene that is about to move for `stop` s, or as long as its experiment, if that is less."""
    asked = {"solver.tolerance": tolerance, "solver.method": method}
    drawn = solver.load(SCENES / f"{name}.toml", asked)
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


def course_of(name: str, method: str, tolerance: float, stop: float) -> Course:
    """Where a run of a scene is at its communication points."""
    return course(*prepared(name, method, tolerance, stop))


def course(model: Model, integrator: Integrator, length: float, *, each: int = 1) -> Course:
    """Where a run that is about to move is at its communication points."""
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


def fixed(name: str, order: int, count: int, length: float) -> tuple[Model, Integrator, float]:
    """A scene that is about to move for a length in `count` steps of an order."""
    steps = {"solver.step_size": length / count, "experiment.step_size": length / POINTS}
    chosen = {"solver.order": order, "solver.tolerance": 0.0, **steps}
    model = solver.assemble(solver.load(SCENES / f"{name}.toml", chosen))
    integrator = Integrator(model)
    integrator.initialise()
    return model, integrator, length


def fewest_steps(
    name: str, order: int, length: float, exact: Course, error: float, most: float
) -> int:
    """Fewest steps of an order in each communication step that err no more; 0 if more than most."""

    def is_enough(each: int) -> bool:
        try:
            return course(*fixed(name, order, POINTS * each, length)).error(exact) <= error
        except StepError:
            return False

    short, enough = 0, 1
    while not is_enough(enough):
        short, enough = enough, math.ceil(1.5 * enough)
        if enough > most:
            return 0
    while enough - short > max(1, 0.05 * enough):
        middle = (short + enough) // 2
        short, enough = (short, middle) if is_enough(middle) else (middle, enough)
    return enough


def price(name: str, method: str, stop: float, effort: Effort) -> dict[str, Value]:
    """What a tolerance costs beside the best fixed step that errs no more."""
    exact, found = exact_course(name, stop), course_of(name, method, PRICED, stop)
    _, integrator, length = prepared(name, method, PRICED, stop)
    error, least = found.error(exact), math.inf
    halves: dict[str, int] = {}
    entries = {"run": _entry(integrator, length)}
    for order, pairs in reversed(STAGES.items()):  # the lower ones end early
        most = LONGER * min(least, 4.0 * found.halves) / (2 * pairs * POINTS)
        count = POINTS * fewest_steps(name, order, length, exact, error, most)
        if count:
            entries[str(order)] = _entry(*fixed(name, order, count, length)[1:])
            halves[str(order)] = 2 * pairs * count
            least = min(halves.values())
    ms = {key: 1e3 * times.minimum for key, times in interleave(entries, effort).items()}
    row: dict[str, Value] = {"scene": name, "method": method, "error": error, "order": found.order}
    row |= {"halves": found.halves, "ms": ms["run"]}
    if not halves:
        return row
    best = min(halves, key=ms.__getitem__)
    row |= {"fixed_order": float(best), "fixed_halves": halves[best]}
    return row | {"fixed_ms": ms[best], "price": ms["run"] / ms[best]}


def _entry(integrator: Integrator, length: float) -> Entry:
    """A run, and the way back to where it begins."""
    state, horizon = integrator.save(), integrator.state.head["horizon"]

    def prepare() -> None:
        integrator.restore(state)
        integrator.state.head["horizon"] = horizon

    return Entry(lambda: sum(move(integrator, length)), prepare)


def measure(effort: Effort) -> Section:
    stop = max(0.01, STOP * effort.scale)
    names = [n for group in (SMOOTH, DAMPED) for n in (group if effort.steps > 2 else group[:1])]
    rows = [
        row(n, method, tolerance, stop, effort)
        for n in names
        for method in STEPPED_BY
        for tolerance in TOLERANCES[: effort.steps]
    ]
    prices = [price(n, method, stop, effort) for n in names for method in STEPPED_BY]
    return Section(
        name="tolerances",
        title="Error against the tolerance asked for",
        method=(
            f"Scenes over {stop:g} s or their own experiment, in ten communication steps, order "
            "and length of internal steps chosen. Error: the largest of places and rates at any "
            "of the points, in the mass norm over size and speed of the mechanism, against a run "
            f"with {SHARPEST:.0e} by the method fastest. Price: a run with {PRICED:.0e} and, in "
            "turn with it, the fixed steps of each order that err no more at any of the points, "
            "the fewest to 5 %; the best of these. Fixed steps of a motion that comes back the way "
            "it went lose their errors again, which steps of changing length do not."
        ),
        tables=[
            Table(title="Tolerances", columns=COLUMNS, rows=rows),
            Table(title=f"Price of a tolerance of {PRICED:.0e}", columns=PRICES, rows=prices),
        ],
        goals=[
            Goal(
                what=f"{method}: scenes whose tolerance costs more than {DEAR:g} times the best "
                "fixed step",
                unit="1",
                goal=MOST_DEAR,
                value=float(_dear(prices, method)),
            )
            for method in STEPPED_BY
        ],
    )


def _dear(prices: list[dict[str, Value]], method: str) -> int:
    mine = [row.get("price") for row in prices if row["method"] == method]
    return sum(isinstance(found, float) and found > DEAR for found in mine)


@cache
def exact_course(name: str, stop: float) -> Course:
    """What runs of a scene are compared with."""
    return course_of(name, "fastest", SHARPEST, stop)


def row(name: str, method: str, tolerance: float, stop: float, effort: Effort) -> dict[str, Value]:
    """What a tolerance gives and costs."""
    found = course_of(name, method, tolerance, stop)
    times = interleave({"run": _entry(*prepared(name, method, tolerance, stop)[1:])}, effort)
    return {
        "scene": name,
        "method": method,
        "tolerance": tolerance,
        "ratio": found.error(exact_course(name, stop)) / tolerance,
        "order": found.order,
        "halves": found.halves,
        "ms": 1e3 * times["run"].minimum,
        "energy": found.energy,
    }
