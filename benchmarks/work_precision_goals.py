"""What the curves come to: CPU time at given errors, and the goals that were set for it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise

from benchmarks.problems_parts import Problem
from benchmarks.report import Goal, Table, Value

Rows = Sequence[Mapping[str, Value]]
Curves = Mapping[str, tuple[Problem, Rows]]

LEVELS = (1e-3, 1e-5, 1e-8, 1e-11)
"""Position errors of the overview [m]."""
ALL_LEVELS = tuple(10.0**-k for k in range(3, 11))
PENDULUM = dict(zip(LEVELS, (1.0, 1.5, 4.0, 9.0), strict=True))
"""Goals of the double pendulum from 30 degrees [ms]."""
AHEAD = ("four_bar_2", "andrews", "bricard", "heavy_top", "car_axis")
RATIOS = {"Exudyn": 1 / 3, "MuJoCo": 1.0}
"""Our time over the time of another code, at most, at every level that it reaches."""
OURS = "holonom"
MULTIBODY = ("Exudyn", "MuJoCo", "Drake", "Simbody", "IDAS")
"""Codes that solve the mechanism as drawn, body by body."""
RATIO_LEVELS = tuple(10.0**-k for k in range(3, 10))


def overview(curves: Curves) -> Table:
    """CPU time at errors: our best order, then every other curve."""
    rows: list[dict[str, Value]] = []
    for problem, table in curves.values():
        names = dict.fromkeys(
            str(row["solver"]) for row in table if row.get("position") is not None
        )
        others = [name for name in names if not name.startswith(OURS)]
        for name in (OURS, *others):
            times = {f"{level:g}": best(table, name, level) for level in LEVELS}
            rows.append({"problem": problem.title, "solver": name} | times)
    levels = {f"{level:g}": f"{level:.0e} m" for level in LEVELS}
    return Table(
        title="CPU ms to reach a position error",
        columns={"problem": "problem", "solver": "solver"} | levels,
        rows=rows,
    )


def ratios(curves: Curves) -> Table:
    """Our best time over the best of all multibody codes, by error."""
    levels = {f"{level:g}": f"{level:.0e} m" for level in RATIO_LEVELS}
    rows: list[dict[str, Value]] = []
    for problem, table in curves.values():
        row: dict[str, Value] = {"problem": problem.title}
        for level in RATIO_LEVELS:
            theirs = {name: ms for name in MULTIBODY if (ms := best(table, name, level))}
            if theirs:
                fastest = min(theirs, key=lambda name, theirs=theirs: theirs[name])
                ours = best(table, OURS, level)
                told = f"{ours / theirs[fastest]:.2g}" if ours else "not reached"
                row[f"{level:g}"] = f"{told} ({fastest})"
        rows.append(row)
    return Table(
        title="Best of ours over best of all multibody codes, CPU time",
        columns={"problem": "problem"} | levels,
        rows=rows,
    )


def best(rows: Rows, name: str, level: float) -> float | None:
    """Least time of all curves whose solver's name begins with `name` [ms]."""
    solvers = dict.fromkeys(str(row["solver"]) for row in rows)
    times = [
        time
        for solver in solvers
        if solver.startswith(name) and (time := _of_curve(rows, solver, level)) is not None
    ]
    return min(times, default=None)


def _of_curve(rows: Rows, solver: str, level: float) -> float | None:
    points = [
        (float(row["position"]), float(row["ms"]))  # type: ignore[arg-type]
        for row in rows
        if row["solver"] == solver and row.get("ms") and row.get("position")
    ]
    return time_to_reach(points, level)


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


# ----------------------------------------------------------------------------------------- goals


def goals(curves: Curves) -> list[Goal]:
    """The pendulum's times, and ratios to other codes."""
    found: list[Goal] = []
    if "double_pendulum_30" in curves:
        rows = curves["double_pendulum_30"][1]
        for level, goal in PENDULUM.items():
            what = f"double pendulum from 30°, 10 s, error {level:.0e} m"
            found.append(Goal(what=what, unit="ms", goal=goal, value=best(rows, OURS, level)))
        found += [_against_all(rows, level) for level in PENDULUM]
    for key in AHEAD:
        if key in curves:
            problem, rows = curves[key]
            found += [
                _against(problem, rows, name, goal)
                for name, goal in RATIOS.items()
                if any(row.get("ms") for row in rows if str(row["solver"]).startswith(name))
            ]
    return found


def _against_all(rows: Rows, level: float) -> Goal:
    """Our time over that of the fastest of all others."""
    peers = dict.fromkeys(str(r["solver"]) for r in rows if not str(r["solver"]).startswith(OURS))
    times = {peer: time for peer in peers if (time := _of_curve(rows, peer, level)) is not None}
    ours = best(rows, OURS, level)
    what = f"double pendulum from 30°, error {level:.0e} m, time over "
    if not times:
        return Goal(
            what=what + "that of no other code that comes there", unit="1", goal=1.0, value=0.0
        )
    fastest = min(times, key=lambda peer: times[peer])
    ratio = ours / times[fastest] if ours is not None else None
    return Goal(what=f"{what}{fastest}'s", unit="1", goal=1.0, value=ratio)


def _against(problem: Problem, rows: Rows, name: str, goal: float) -> Goal:
    """Largest of our time over another code's, of all levels that it reaches."""
    ratios: dict[float, float] = {}
    for level in ALL_LEVELS:
        ours, theirs = best(rows, OURS, level), best(rows, name, level)
        if theirs is not None:
            ratios[level] = ours / theirs if ours is not None else math.inf
    if not ratios:
        what = f"{problem.title}: time over {name}'s, which reaches no level of 1e-3 to 1e-10 m"
        return Goal(what=what, unit="1", goal=goal, value=0.0)
    worst = max(ratios, key=lambda level: ratios[level])
    what = f"{problem.title}: time over {name}'s, worst of {len(ratios)} levels, at {worst:.0e} m"
    return Goal(what=what, unit="1", goal=goal, value=ratios[worst])
