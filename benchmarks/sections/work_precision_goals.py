"""What the curves come to: CPU time at given errors, and the goals that were set for it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise

from benchmarks.pages.report import Goal, Table, Value
from benchmarks.problems.parts import Problem

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
OUR_METHODS = ("holonom conserving", "holonom fastest")
"""How the names of our curves begin: the method of a user's defaults first."""
MULTIBODY = ("Exudyn", "MuJoCo", "Drake", "Simbody", "IDAS")
"""Codes that solve the mechanism as drawn, body by body."""
RATIO_LEVELS = tuple(10.0**-k for k in range(3, 10))


def overview(curves: Curves) -> Table:
    """CPU time at errors: the best curve of each of our methods, then every other one."""
    rows: list[dict[str, Value]] = []
    for problem, table in curves.values():
        names = dict.fromkeys(
            str(row["solver"]) for row in table if row.get("position") is not None
        )
        others = [name for name in names if not name.startswith(OURS)]
        for name in (*OUR_METHODS, *others):
            times = {f"{level:g}": best(table, name, level) for level in LEVELS}
            rows.append({"problem": problem.title, "solver": name} | times)
    levels = {f"{level:g}": f"{level:.0e} m" for level in LEVELS}
    return Table(
        title="CPU ms to reach a position error",
        columns={"problem": "problem", "solver": "solver"} | levels,
        rows=rows,
    )


def ratios(curves: Curves) -> Table:
    """The best time of each of our methods over the best of all multibody codes, by error."""
    levels = {f"{level:g}": f"{level:.0e} m" for level in RATIO_LEVELS}
    rows = [
        _ratios_of(problem, table, ours)
        for problem, table in curves.values()
        for ours in OUR_METHODS
    ]
    return Table(
        title="Best of ours over best of all multibody codes, CPU time",
        columns={"problem": "problem", "solver": "ours"} | levels,
        rows=rows,
    )


def _ratios_of(problem: Problem, table: Rows, ours: str) -> dict[str, Value]:
    row: dict[str, Value] = {"problem": problem.title, "solver": ours}
    for level in RATIO_LEVELS:
        theirs = {name: ms for name in MULTIBODY if (ms := best(table, name, level))}
        if theirs:
            fastest = min(theirs, key=lambda name: theirs[name])
            ms = best(table, ours, level)
            told = f"{ms / theirs[fastest]:.2g}" if ms else "not reached"
            row[f"{level:g}"] = f"{told} ({fastest})"
    return row


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
    """The pendulum's times, and ratios to other codes, by each of our methods."""
    found: list[Goal] = []
    for ours in OUR_METHODS:
        if "double_pendulum_30" in curves:
            rows = curves["double_pendulum_30"][1]
            for level, goal in PENDULUM.items():
                what = f"{ours}: double pendulum from 30°, 10 s, error {level:.0e} m"
                found.append(Goal(what=what, unit="ms", goal=goal, value=best(rows, ours, level)))
            found += [_against_all(rows, ours, level) for level in PENDULUM]
        for key in AHEAD:
            if key in curves:
                problem, rows = curves[key]
                found += [
                    _against(problem, rows, ours, name, goal)
                    for name, goal in RATIOS.items()
                    if _has(rows, name) and _has(rows, ours)
                ]
    return found


def _has(rows: Rows, name: str) -> bool:
    return any(row.get("ms") for row in rows if str(row["solver"]).startswith(name))


def _against_all(rows: Rows, ours: str, level: float) -> Goal:
    """Time of one of our methods over that of the fastest of all others."""
    peers = dict.fromkeys(str(r["solver"]) for r in rows if not str(r["solver"]).startswith(OURS))
    times = {peer: time for peer in peers if (time := _of_curve(rows, peer, level)) is not None}
    time = best(rows, ours, level)
    what = f"{ours}: double pendulum from 30°, error {level:.0e} m, time over "
    if not times:
        return Goal(
            what=what + "that of no other code that comes there", unit="1", goal=1.0, value=0.0
        )
    fastest = min(times, key=lambda peer: times[peer])
    ratio = time / times[fastest] if time is not None else None
    return Goal(what=f"{what}{fastest}'s", unit="1", goal=1.0, value=ratio)


def _against(problem: Problem, rows: Rows, ours: str, name: str, goal: float) -> Goal:
    """Largest of the time of one of our methods over another code's, of all that it reaches."""
    ratios: dict[float, float] = {}
    for level in ALL_LEVELS:
        time, theirs = best(rows, ours, level), best(rows, name, level)
        if theirs is not None:
            ratios[level] = time / theirs if time is not None else math.inf
    what = f"{ours}: {problem.title}: time over {name}'s, "
    if not ratios:
        what += "which reaches no level of 1e-3 to 1e-10 m"
        return Goal(what=what, unit="1", goal=goal, value=0.0)
    worst = max(ratios, key=lambda level: ratios[level])
    what += f"worst of {len(ratios)} levels, at {worst:.0e} m"
    return Goal(what=what, unit="1", goal=goal, value=ratios[worst])
