"""Error after ten seconds against CPU time, with the energy error on the same line."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from benchmarks.effort import Effort
from benchmarks.mechanisms import start
from benchmarks.observe import Observer
from benchmarks.peers import PEERS, Peer
from benchmarks.problems import Problem, all_problems
from benchmarks.report import Section, Table, Value
from benchmarks.stepping import Repeated
from benchmarks.timing import Entry, interleave
from solver.runtime import StepError

STOP = 10.0
SAMPLES = 100
STEPS = (0.1, 0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4)
TOLERANCES = tuple(10.0**-k for k in range(3, 14))
LEVELS = (1e-3, 1e-5, 1e-7, 1e-9)

Array = NDArray[np.float64]

COLUMNS = {
    "solver": "solver",
    "setting": "setting",
    "ms": "CPU ms",
    "position": "position error, m",
    "velocity": "velocity error, m/s",
    "energy": "largest |ΔE|, J",
    "noise": "noise",
    "remark": "",
}
FORMATS = {
    "ms": ".2f", "position": ".1e", "velocity": ".1e", "energy": ".1e", "noise": ".2f",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Candidate:
    """A solver with one setting: its accuracy, known before it is timed, and what is timed."""

    solver: str
    setting: str
    accuracy: dict[str, Value]
    entry: Entry | None


def measure(effort: Effort) -> Section:
    tables, summary = [], []
    for problem in all_problems():
        rows = curve(problem, effort)
        summary += [{"problem": problem.name} | row for row in _reaching(rows)]
        tables.append(
            Table(title=problem.name.capitalize(), columns=COLUMNS, rows=rows, formats=FORMATS)
        )
    levels = {f"{level:g}": f"{level:.0e} m" for level in LEVELS}
    overview = Table(
        title="CPU ms to reach a position error",
        columns={"problem": "problem", "solver": "solver"} | levels,
        rows=summary,
        formats=dict.fromkeys(levels, ".2f"),
    )
    return Section(
        name="work-precision",
        title="Work and precision",
        method=(
            f"Largest error of a moving point's position and velocity at {STOP:g} s, against an "
            "independent solution (double pendulum: extrapolation to order 20 in extended "
            "precision; four-bar: Jacobi's elliptic functions). The energy error is the largest "
            "over the run. holonom solves the mechanism as drawn, in pairs of half steps of order "
            "2; the peers solve equations in minimal coordinates, reduced by hand, with a "
            "right-hand side in plain Python, and choose their steps by tolerance."
        ),
        tables=[overview, *tables],
        remarks=REMARKS,
        picture="work_precision.png" if find_spec("matplotlib") else None,
    )


REMARKS = (
    "The reduced four-bar is one equation, which assumes that all cranks stay parallel; the "
    "mechanism as drawn has five constraints on six coordinates, dependent whenever all bars lie "
    "in one line.",
    "A right-hand side compiled with Numba or written in C would make the compiled peer several "
    "times faster; a right-hand side of this size spends most of its time in Python's interpreter.",
    "A dash in the overview: not reached with any of the settings measured.",
)


def curve(problem: Problem, effort: Effort) -> list[dict[str, Value]]:
    """Rows of all solvers on one problem; timed in turn."""
    candidates = [
        _ours(problem, algorithm, h)
        for algorithm in ("nested", "simultaneous")
        for h in STEPS[: effort.steps]
    ]
    candidates += [
        _peer(problem, peer, tolerance)
        for peer in PEERS
        for tolerance in TOLERANCES[: effort.steps + 1]
    ]
    entries = {str(i): c.entry for i, c in enumerate(candidates) if c.entry}
    times = interleave(entries, effort)
    rows: list[dict[str, Value]] = []
    for i, candidate in enumerate(candidates):
        row = {"solver": candidate.solver, "setting": candidate.setting} | candidate.accuracy
        if str(i) in times:
            row |= {"ms": 1e3 * times[str(i)].minimum, "noise": times[str(i)].noise}
        rows.append(row)
    return rows


def _ours(problem: Problem, algorithm: str, h: float) -> Candidate:
    solver, setting = f"holonom {algorithm}", f"h = {h:g}"
    settings = {"step_size": h, "algorithm": algorithm}
    integrator = start(problem.content, **settings)
    observer = Observer(problem.content, integrator)
    initial, energy = observer.energy(), 0.0
    try:
        for _ in range(SAMPLES):
            integrator.advance(integrator.time, STOP / SAMPLES)
            energy = max(energy, abs(observer.energy() - initial))
    except StepError:
        remark = f"a step failed at {integrator.time:g} s"
        return Candidate(solver, setting, {"remark": remark}, None)
    steps = Repeated(start(problem.content, **settings), h, round(STOP / h), warm_up=0)
    if steps.failure:
        return Candidate(solver, setting, {"energy": energy, "remark": "a step failed"}, None)
    q, v = Observer(problem.content, steps.integrator).moving_points()
    accuracy = errors(problem, q, v) | {"energy": energy}
    accuracy["remark"] = "some steps halved" if steps.halved else ""
    return Candidate(solver, setting, accuracy, steps.entry)


def _peer(problem: Problem, peer: Peer, tolerance: float) -> Candidate:
    setting = f"rtol = atol = {tolerance:.0e}"
    states = peer.path(problem, tolerance, STOP)
    energies = problem.energy(states)
    accuracy = errors(problem, *problem.points(tuple(float(x) for x in states[:, -1])))
    accuracy["energy"] = float(np.max(np.abs(energies - energies[0])))
    accuracy["remark"] = ""

    def run() -> object:
        return peer.run(problem, tolerance, STOP)

    return Candidate(peer.name, setting, accuracy, Entry(run))


def errors(problem: Problem, q: Array, v: Array, t: float = STOP) -> dict[str, Value]:
    """Largest distances from where the points should be at `t`, and from how fast."""
    q_exact, v_exact = problem.exact(t)
    return {
        "position": float(np.max(np.linalg.norm(q - q_exact, axis=1))),
        "velocity": float(np.max(np.linalg.norm(v - v_exact, axis=1))),
    }


def _reaching(rows: Sequence[dict[str, Value]]) -> list[dict[str, Value]]:
    """CPU time of each solver at given errors, between the settings on the logarithmic scale."""
    found: list[dict[str, Value]] = []
    for solver in dict.fromkeys(str(row["solver"]) for row in rows):
        points = [
            (float(row["position"]), float(row["ms"]))  # type: ignore[arg-type]
            for row in rows
            if row["solver"] == solver and row.get("ms") and row.get("position")
        ]
        reached = {f"{level:g}": time_to_reach(points, level) for level in LEVELS}
        found.append({"solver": solver} | reached)
    return found


def time_to_reach(points: Sequence[tuple[float, float]], level: float) -> float | None:
    """Least time at which the curve through (error, time) comes down to `level`.

    The curve is straight between neighbouring settings on logarithmic scales; a setting that is
    better than `level` without one that is worse counts with its own time.
    """
    times = [time for error, time in points if error <= level]
    for (e0, t0), (e1, t1) in pairwise(points):
        if min(e0, e1) < level < max(e0, e1):
            share = math.log(level / e0) / math.log(e1 / e0)
            times.append(t0 * (t1 / t0) ** share)
    return min(times, default=None)
