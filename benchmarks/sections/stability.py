"""Largest steps that survive: formulation, penalty, stiffness; Exudyn and MuJoCo beside them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib.util import find_spec

from benchmarks.measuring.effort import Effort
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.peers.stability_peers import present, scanned
from benchmarks.problems.stability_cases import Case, chain, maps
from benchmarks.sections.stability_picture import draw as draw
from benchmarks.sections.stability_rules import CONSTRAINT, LOOKS, LOOSE, TIGHT, Seen, largest, scan
from benchmarks.sections.stability_runs import Ready, prepare, run, run_by_paper
from solver.options import DEFAULTS
from solver.paper import FORMULATIONS

PENALTIES = (1e4, 1e8, 1e12)
CHAINS = ((10, 1.0), (100, 1.0), (1000, 1.0), (10, 10.0), (100, 10.0))
"""Points and seconds."""
SHARE = 0.25
"""Goal: no peer's largest step is more than a quarter of ours."""
PAIRS = "pairs of half steps"
"""What our core takes; all else of ours is by `solver.paper`, one step of h with one solve."""
OWN = "holonom"

Rows = list[dict[str, Value]]

MAP = {
    "solver": "solver",
    "setting": "method or formulation",
    "penalty": ("penalty", ".0e"),
    "stiffness": ("stiffness, N/m", ".0e"),
    "h": "largest step, s",
    "newton": ("Newton iterations", ".1f"),
    "energy": ("largest |ΔE|/E", ".1e"),
    "constraint": ("largest |Φ|", ".1e"),
    "above": "at the next larger step",
}


def measure(effort: Effort) -> Section:
    peers, remarks = present()
    coarse = [2.0 ** (-j / 2) for j in range(2 * effort.steps)]
    fine = [2.0 ** (2 - j / 4) for j in range(3 * effort.steps + 3)]
    chains, goals = _chains(effort, peers, fine, remarks)
    rows: dict[str, Rows] = {}
    for case in maps():
        ready = prepare(case, _stop(case, effort))
        rows.setdefault(case.name, []).extend(_map(ready, coarse))
        rows[case.name] += [
            {"solver": peer, "setting": method, "penalty": ""} | _found(ready, seen)
            for (peer, method), seen in _of_peers(peers, ready, coarse, remarks).items()
        ]
    drawn = [
        Table(title=name.capitalize(), columns=MAP, rows=found) for name, found in rows.items()
    ]
    return Section(
        name="stability",
        title="Stability: the largest step that survives",
        method=METHOD,
        tables=[chains, *drawn],
        goals=goals,
        remarks=[*remarks, *REMARKS],
        picture="stability.png" if find_spec("matplotlib") else None,
    )


METHOD = (
    "A run survives if it reaches its end with every step solved as it was asked for (ours: none "
    f"divided), if the energy has never moved by more than {LOOSE:.0%} of the largest kinetic "
    f"energy of the motion, and no constraint by more than {CONSTRAINT:.0%} of a link, looked at "
    f"after every step or {LOOKS} times; the table of chains has a second bound, {TIGHT:.0%} of "
    "the energy. The largest step is that below which all smaller ones of the grid survive as "
    "well, for every solver; steps grow by a factor of √2, for chains of ⁴√2. Our energy is "
    "kinetic and potential energy less the drivers' work, without what penalties store. Ours are "
    f"{PAIRS} of the core, and the formulations of `solver.paper`, nested. Exudyn: generalized "
    "alpha of index 3 and the trapezoidal rule of index 2, full Newton of up to 50 iterations; "
    "MuJoCo: trees in joint coordinates, loops closed by `connect`. Runs last 10 s, the chain's "
    "1 s, the car axis' 3 s."
)
REMARKS = (
    "To survive is not to be exact: at its largest step the conserving scheme has the right "
    "energy and closed joints, and phases that are wrong by radians. Work and precision are "
    "another table.",
    "Within a second neighbouring rods of the chain turn against each other by up to 3 rad for "
    "N = 10, 0.3 for 100 and 0.03 for 1000: the longer it is, the less a second asks of a step; "
    "an explicit method in joint coordinates then takes the chain of 100 in one.",
    "Springs always act by their discrete gradient; `formulation` is about constraints.",
    "The car axis is run by the core alone: `solver.paper` was not measured, and no peer has it. "
    "MuJoCo takes a second for one step of the chain of 1000 and is left out there.",
)


def _stop(case: Case, effort: Effort) -> float:
    return max(0.05, case.stop * effort.scale)


# ------------------------------------------------------------------------------------------ chains


def _chains(
    effort: Effort, peers: Iterable[str], grid: Sequence[float], remarks: list[str]
) -> tuple[Table, list[Goal]]:
    """Largest steps of all solvers on the chains, and the goals."""
    rows: dict[tuple[str, str], dict[str, Value]] = {}
    columns, goals = {"solver": "solver", "setting": "method"}, []
    for n, stop in CHAINS:
        if n > effort.largest:
            continue
        case = chain(n, stop)
        ready = prepare(case, _stop(case, effort))
        seen = {(OWN, PAIRS): scan(grid, lambda h, r=ready: run(r, h))}
        seen |= _of_peers(peers, ready, grid, remarks)
        for bound in (LOOSE, TIGHT):
            key = f"{n} {stop:g} {bound:g}"
            columns[key] = f"N = {n}, {stop:g} s, {bound:.0%}"
            steps = {solver: largest(outcomes, bound) for solver, outcomes in seen.items()}
            found = {solver: step[0] if step else None for solver, step in steps.items()}
            for solver, h in found.items():
                rows.setdefault(solver, {"solver": solver[0], "setting": solver[1]})[key] = h
            if stop == 1.0 and len(found) > 1:
                goals.append(_goal(n, bound, found))
    title = "Point chain: largest step, s, that survives with the energy within a bound"
    return Table(title=title, columns=columns, rows=list(rows.values())), goals


def _of_peers(
    peers: Iterable[str], ready: Ready, grid: Sequence[float], remarks: list[str]
) -> dict[tuple[str, str], Seen]:
    """What was seen of peers, by their name and method."""
    seen: dict[tuple[str, str], Seen] = {}
    for peer in peers:
        theirs, problem = scanned(peer, ready, grid)
        remarks.extend([problem] if problem else [])
        seen |= {(peer, method): outcomes for method, outcomes in theirs.items()}
    return seen


def _goal(n: int, bound: float, found: dict[tuple[str, str], float | None]) -> Goal:
    """The peers' best over ours, counted in implicit solves: two of a pair."""
    theirs = max(h or 0.0 for (solver, _), h in found.items() if solver != OWN)
    ours = found[OWN, PAIRS]
    return Goal(
        what=f"largest step of peers over our half step, chain of {n}, 1 s, energy in {bound:.0%}",
        unit="1",
        goal=SHARE,
        value=theirs / (0.5 * ours) if ours else None,
    )


# -------------------------------------------------------------------------------------------- maps


def _map(ready: Ready, grid: Sequence[float]) -> Rows:
    """Pairs of the core, and formulation x penalty, each with the largest of the grid's steps."""
    case = ready.case
    penalty: float = DEFAULTS["penalty"]
    row: dict[str, Value] = {"solver": OWN, "setting": PAIRS, "penalty": penalty}
    rows = [row | _found(ready, scan(grid, lambda h: run(ready, h)))]
    for formulation in FORMULATIONS if case.on_paper else ():
        for penalty in PENALTIES if case.penalties else (DEFAULTS["penalty"],):
            settings = {"formulation": formulation, "penalty": penalty}
            seen = scan(grid, lambda h, s=settings: run_by_paper(ready, h, **s))
            rows.append({**row, "setting": formulation, "penalty": penalty, **_found(ready, seen)})
    return rows


def _found(ready: Ready, seen: Seen) -> dict[str, Value]:
    """Outcome at the largest step, and what ended the next larger one."""
    step = largest(seen, LOOSE)
    row: dict[str, Value] = {"stiffness": ready.case.stiffness or ""}
    row["above"] = seen[-1][1].end or "(none tried)"
    if step is None:
        return row | dict.fromkeys(("h", "newton", "energy", "constraint"))
    h, at = step
    return row | {
        "h": h, "newton": at.newton, "energy": at.energy, "constraint": at.constraint,
    }  # fmt: skip
