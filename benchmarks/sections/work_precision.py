"""Error at the end against CPU time, ours and of peers, for all problems of the catalogue."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib.util import find_spec

from benchmarks.measuring.effort import Effort
from benchmarks.pages.picture import draw as draw
from benchmarks.pages.report import Section, Table, Value
from benchmarks.peers import peer_processes
from benchmarks.peers.peer_interpreter import Packages
from benchmarks.peers.peer_methods import LONGEST, Limits, Row, distance, measured
from benchmarks.peers.peer_scipy import PEERS
from benchmarks.problems.catalogue import PROBLEMS
from benchmarks.problems.parts import Problem
from benchmarks.problems.work_precision_references import Reference, reference
from benchmarks.sections import work_precision_chains, work_precision_goals, work_precision_ours

CHAIN = "chain_"
PATIENT = {"net_30": 10.0, "rigid_chain_100": 5.0}
"""Factor on the longest run, where one step takes as long."""
COLUMNS = {
    "solver": "solver",
    "setting": "setting",
    "ms": "CPU ms",
    "position": ("position error, m", ".1e"),
    "velocity": ("velocity error, m/s", ".1e"),
    "energy": ("energy error, J", ".1e"),
    "noise": ("noise", ".2f"),
    "remark": "",
}
SOURCES = {
    "problem": "problem",
    "source": "reference",
    "stop": ("end, s", "g"),
    "ours": ("our best is off by, m", ".0e"),
    "theirs": ("best of other multibody codes is off by, m", ".0e"),
}
METHOD = (
    "Largest error of the positions and velocities of watched places at the end, against the "
    "references below. The energy error is the largest deviation from the energy at the start, "
    "looked at up to 50 times; where energy is fed or dissipated, it is that of the change over "
    "the whole run. Every code takes its numbers from `benchmarks/problems/catalogue.py`. "
    "holonom solves the mechanism as drawn, each step solved to 1e-12: by its *conserving* "
    "method, which is the default, in equal steps of an order or as a tolerance asks, and by "
    "*fastest*, which takes explicit steps as well. SciPy and CVODE solve equations in fewest "
    "coordinates, reduced by hand and compiled from C, by tolerance; the others solve the "
    "mechanism built body by body, in processes of their own in the same run, with their own "
    "settings from coarse to fine. What is timed leads from an assembled model to the final state. "
    "All settings with their errors are in the data; the pictures show them. "
    f"A curve ends with the first run below 3e-12 m or above {1e3 * LONGEST:g} ms, "
    f"{1e3 * peer_processes.LEEWAY * LONGEST:g} ms in other processes."
)
REMARKS = (
    "The reduced four-bar, Andrews' squeezer and Bricard's mechanism are one equation each, "
    "derived by hand for this mechanism alone.",
    "A dash in the overview: not reached with any of the settings measured. A dash in the ratios: "
    "reached by no other multibody code (Exudyn, MuJoCo, Drake, Simbody, IDAS).",
    "Drake closes no loops in continuous time, and has the chains and the heavy top alone.",
    "*holonom conserving* in the overview is the best of its orders and of the choice by "
    "tolerance.",
    "SUNDIALS' CVODE comes with scikit-sundae, IDAS with CasADi: `assimulo` and "
    "`scikits-odes-sundials` have no wheels. Simbody comes with OpenSim, which has no damper "
    "between two points.",
)


@dataclass(frozen=True, slots=True)
class Solved:
    """A problem with its reference and the rows of all solvers."""

    problem: Problem
    reference: Reference
    rows: Sequence[dict[str, Value]]


def measure(effort: Effort) -> Section:
    limits = Limits.of(effort)
    peers = peer_processes.found()
    problems = [build() for build in PROBLEMS.values()]
    solved = [solve(p, limits, peers) for p in problems if len(p.bodies) <= effort.largest]
    curves = {case.problem.key: (case.problem, case.rows) for case in solved}
    points = {
        int(key.removeprefix(CHAIN)): rows
        for key, (_, rows) in curves.items()
        if key.startswith(CHAIN)
    }
    chains = work_precision_chains.steps(points, effort)
    drawn = find_spec("matplotlib") is not None
    return Section(
        name="work-precision",
        title="Work and precision",
        method=METHOD,
        tables=[
            work_precision_goals.overview(curves),
            work_precision_goals.ratios(curves),
            _references(solved),
            work_precision_chains.table(chains),
            _told(solved),
            *(
                Table(
                    title=case.problem.title,
                    columns=COLUMNS,
                    rows=case.rows,
                    picture=f"work_precision_{case.problem.key}.png" if drawn else None,
                    on_page=not drawn,
                )
                for case in solved
            ),
        ],
        goals=[*work_precision_goals.goals(curves), *work_precision_chains.goals(chains)],
        remarks=[*REMARKS, *peer_processes.remarks(peers)],
        picture="work_precision.png" if drawn else None,
    )


def solve(problem: Problem, limits: Limits, peers: Packages) -> Solved:
    """Rows of all solvers on one problem, ours first."""
    limits = replace(limits, run=limits.run * PATIENT.get(problem.key, 1.0))
    right = reference(problem)
    rows = measured(problem, [*work_precision_ours.methods(problem), *PEERS], limits, right.q)
    rows += peer_processes.measured(problem, limits, right.q, peers)
    return Solved(problem, right, [judged(row, problem, right) for row in rows])


def judged(row: Row, problem: Problem, right: Reference) -> dict[str, Value]:
    """A row with errors in the place of what was found."""
    kept = {k: row[k] for k in ("solver", "setting", "value", "ms", "noise", "remark") if k in row}
    if "q" not in row:
        return kept
    energy = row["energy"] if problem.conserves else abs(row["change"] - right.change)
    return kept | {
        "position": distance(row["q"], right.q),
        "velocity": distance(row["v"], right.v),
        "energy": energy,
    }


def _references(solved: Sequence[Solved]) -> Table:
    rows = [
        {
            "problem": case.problem.title,
            "source": case.reference.source,
            "stop": case.problem.stop,
            "ours": _best(case.rows, "holonom"),
            "theirs": _best(case.rows, *work_precision_goals.MULTIBODY),
        }
        for case in solved
    ]
    title = "References, and how far codes that share nothing with them come to them"
    return Table(title=title, columns=SOURCES, rows=rows)


def _told(solved: Sequence[Solved]) -> Table:
    """What there is to say of single runs, with the number of settings that it is said of."""
    counts: dict[tuple[str, str, str], int] = {}
    for case in solved:
        for row in case.rows:
            if row.get("remark"):
                told = (str(row["remark"]), str(row["solver"]), case.problem.title)
                counts[told] = counts.get(told, 0) + 1
    rows: dict[tuple[str, str], list[str]] = {}
    for (remark, solver, title), count in counts.items():
        rows.setdefault((solver, remark), []).append(f"{title} ({count})")
    return Table(
        title="What failed, was halved or is not measured, with the number of settings",
        columns={"solver": "solver", "remark": "", "problems": "problems"},
        rows=[
            {"solver": solver, "remark": remark, "problems": "; ".join(titles)}
            for (solver, remark), titles in sorted(rows.items())
        ],
    )


def _best(rows: Sequence[dict[str, Value]], *names: str) -> float | None:
    errors = [
        float(row["position"])  # type: ignore[arg-type]
        for row in rows
        if str(row["solver"]).startswith(names) and row.get("position") is not None
    ]
    return min(errors, default=None)
