"""Impacts: error of their times and of the energy against time, beside other codes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict

import solver
from benchmarks.contact import ours, scipy_events
from benchmarks.contact.methods import USUAL, Limits, Row, measured, reached
from benchmarks.contact.problems import PROBLEMS, Problem
from benchmarks.measuring.effort import Effort
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.peers.peer_interpreter import InterpreterError, answer, packages_there, remarks
from benchmarks.peers.peer_processes import ONE

CODES = {"mujoco_soft": ("MuJoCo", "mujoco"), "exudyn_penalty": ("Exudyn", "exudyn")}
"""Module of each code that runs in a process of its own, its name and that of its package."""
OWN = "holonom"
LEVELS = (1e-2, 1e-3, 1e-4, 1e-6, 1e-8)
GOAL = 1e-4
"""Of the times of impacts, where ours is to be the fastest."""
ELASTIC = 1e-12
"""Of the energy after 100 elastic impacts."""
LONGEST = 0.15
"""CPU seconds of a run after which no finer one is tried."""
PATIENCE = 300.0
"""Seconds after which a code is stopped at a problem."""

TIMES = {
    "problem": "problem",
    "solver": "solver",
    **{f"{level:.0e}": f"ms to {level:.0e}" for level in LEVELS},
    "setting": f"setting for {GOAL:.0e}",
}
REACHED = {
    "problem": "problem",
    "solver": "solver",
    "what": "run with the least",
    "setting": "setting",
    "ms": "ms",
    "events": ("largest error of a time", ".1e"),
    "seen": ("impacts seen", ".0f"),
    "energy": ("error of energy", ".1e"),
}
RUNS = {key: header for key, header in REACHED.items() if key != "what"} | {
    "noise": ("noise", ".2f")
}


def measure(effort: Effort) -> Section:
    limits = Limits(LONGEST * effort.scale**0.5, effort.steps)
    packages = packages_there([package for _, package in CODES.values()])
    said = remarks(packages, dict(CODES.values()))
    absence = _absence()
    said += [f"{OWN}: not measured: {absence}"] if absence else []
    there = {
        module: code for module, (code, package) in CODES.items() if package in packages.versions
    }
    rows: list[Row] = []
    for problem in PROBLEMS.values():
        methods = [*scipy_events.METHODS, *([] if absence else ours.METHODS)]
        found = measured(problem, methods, limits)
        for module, code in there.items():
            try:
                found += _answered(module, problem, limits)
            except InterpreterError as error:
                said.append(f"{code}, {problem.title}: {error}")
        rows += [{"problem": problem.title} | row for row in found]
    elastic = PROBLEMS["ball_elastic"].title
    usual = [row for row in rows if row["problem"] == elastic and row["h"] == USUAL]
    tables = [
        Table(title="Time to an error of times", columns=TIMES, rows=_times(rows)),
        Table(title="What is reached", columns=REACHED, rows=_ends(rows)),
        Table(title="100 elastic impacts, steps of 1 ms", columns=RUNS, rows=usual),
        Table(title="", columns=RUNS, rows=rows, on_page=False),
    ]
    return Section(
        name="contact",
        title="Impacts",
        method=METHOD,
        tables=[table for table in tables if table.rows],
        goals=_goals(rows),
        remarks=[*said, *REMARKS],
    )


METHOD = (
    "The error of times is the largest of all counted impacts, each over the impact's own time; "
    "that of energy is at the end, over the energy of the motion. References: closed forms for "
    "the ball, and DOP853 with polished events. Each code is tried with many settings, as long "
    f"as a run takes less than {LONGEST:g} s of CPU time, and its best are shown. MuJoCo's "
    "contacts are soft: `solref` is (-k, -d), elastic at d = 0, with d for the restitution of a "
    "linear spring and damper that cannot pull; `solimp` as by default and constant, 0.9999; "
    "integrators Euler and RK4. Exudyn has penalty contacts with its impact model 2; generalized "
    "alpha, the trapezoidal rule and, without constraints, RK44, with steps that it divides at "
    "contacts. In both the stiffness follows the step, for 5 to 160 steps of a contact. SciPy "
    "has equations that were reduced by hand, in Python, with the gap as event. Ours are "
    "scenes (`benchmarks/contact/*.toml`) with the default of everything but order and step."
)
REMARKS = (
    "A soft contact lasts for π/√k: each impact of MuJoCo and Exudyn delays what follows.",
    "Without settings MuJoCo's contact has a time constant of 0.02 s and does not bounce.",
    "The impacts of others are when the gap closes, by the parabola of the last free step.",
)


def _absence() -> str:
    """Why our solver cannot run the scenes; empty if it can."""
    try:
        for problem in PROBLEMS.values():
            ours.model(problem.kind)
    except (solver.SceneError, solver.AssemblyError) as error:
        return str(error).strip().partition("\n")[0]
    return ""


def _answered(module: str, problem: Problem, limits: Limits) -> list[Row]:
    request = {"module": module, "problem": problem.key, "limits": asdict(limits)}
    program = ["-m", "benchmarks.peers.peer_run", "benchmarks.contact.methods"]
    return answer(program, request, patience=PATIENCE, environment=ONE)


def _of(rows: Iterable[Row]) -> dict[tuple[str, str], list[Row]]:
    """Rows by problem and solver."""
    groups: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        groups.setdefault((row["problem"], row["solver"]), []).append(row)
    return groups


def _times(rows: Sequence[Row]) -> list[dict[str, Value]]:
    found = []
    for (title, code), group in _of(rows).items():
        fastest = {level: reached(group, level) for level in LEVELS}
        times = {f"{level:.0e}": row["ms"] if row else None for level, row in fastest.items()}
        goal = fastest[GOAL]
        setting = goal["setting"] if goal else None
        found.append({"problem": title, "solver": code, "setting": setting} | times)
    return found


def _ends(rows: Sequence[Row]) -> list[dict[str, Value]]:
    """The run with the best times and that with the best energy."""
    found = []
    for group in _of(rows).values():
        timely = [row for row in group if row["events"] is not None]
        if timely:
            found.append({"what": "error of times"} | min(timely, key=lambda row: row["events"]))
        found.append({"what": "error of energy"} | min(group, key=lambda row: row["energy"]))
    return found


def _goals(rows: Sequence[Row]) -> list[Goal]:
    goals, groups = [], _of(rows)
    for problem in PROBLEMS.values():
        own = groups.get((problem.title, OWN))
        if not own:
            continue
        mine = reached(own, GOAL)
        for code, _ in CODES.values():
            theirs = groups.get((problem.title, code), [])
            timely = [row for row in theirs if row["events"] is not None]
            if not timely:
                continue
            # Where it does not get so far, its most accurate run stands for it.
            other = reached(theirs, GOAL) or min(timely, key=lambda row: row["events"])
            remark = "" if other["events"] <= GOAL else f", which came to {other['events']:.0e}"
            goals.append(
                Goal(
                    what=f"{problem.title}, times to {GOAL:.0e}: time over {code}'s{remark}",
                    unit="1",
                    goal=1.0,
                    value=mine["ms"] / other["ms"] if mine else None,
                )
            )
        if problem.key == "ball_elastic":
            energy = max(row["energy"] for row in own)
            what = f"{problem.title}: error of energy, worst of the runs shown"
            goals.append(Goal(what=what, unit="1", goal=ELASTIC, value=energy))
    return goals
