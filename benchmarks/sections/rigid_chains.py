"""Cost of an inner step against the number of rigid bodies: hinged chains and rows of four-bars."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import solver
from benchmarks.measuring.effort import Effort
from benchmarks.measuring.stepping import Repeated
from benchmarks.measuring.timing import Times, interleave
from benchmarks.pages.report import Goal, Section, Table, Value, exponent
from benchmarks.peers.exudyn_peer import METHOD, Job, beside, measured
from benchmarks.problems.mechanisms import start_scene
from scenes.generate import hanging_chain, n_four_bar, rigid_chain
from solver.options import step_of

STEPS_TIMES_BODIES = 5_000
WARM_UP = 5
"""Steps before those that are timed: the first one from rest takes more iterations."""
PER_BODY = 8.0
"""Goal of an inner step for each body in space with its joint [µs]."""
LINEAR = 1.1


@dataclass(frozen=True, slots=True)
class Family:
    """Scenes of any size."""

    name: str
    text: Callable[[int], str]
    model: str | None
    """Function of `benchmarks.problems.catalogue`, for Exudyn."""
    sizes: tuple[int, ...]
    bodies: Callable[[int], int]
    first: int
    """Size from which the exponent is taken: below, what does not grow is a large part."""


LINKS = (10, 100, 1000)
FAMILIES = (
    Family(
        "planar rigid chain", partial(rigid_chain, dimension=2), "planar_chain", LINKS, int, 100
    ),
    Family("spatial rigid chain", rigid_chain, "rigid_chain", LINKS, int, 100),
    Family("hanging chain of bars", hanging_chain, None, LINKS, int, 100),
    Family("N-four-bar (A02)", n_four_bar, "four_bar", (2, 10, 40, 200), lambda n: 2 * n + 1, 10),
)

COLUMNS = {
    "family": "mechanism",
    "n": ("N", ".0f"),
    "bodies": ("bodies", ".0f"),
    "solve": ("µs per inner step", ".4g"),
    "body": ("µs per inner step and body", ".3f"),
    "exudyn": ("Exudyn, µs per step", ".4g"),
    "ratio": ("Exudyn / ours", ".1f"),
    "newton": ("Newton iterations per inner step", ".2f"),
    "their_newton": ("Exudyn's", ".2f"),
    "iteration": ("µs per iteration and body", ".3f"),
    "energy": ("energy.error, J", ".1e"),
    "constraint": ("constraint.position, m", ".1e"),
    "noise": ("noise", ".2f"),
    "remark": "",
}


@dataclass(frozen=True, slots=True)
class Case:
    """One size of a family."""

    family: Family
    n: int
    h: float
    repeated: Repeated

    @property
    def key(self) -> str:
        """Name of the size."""
        return f"{self.family.name} N = {self.n}"


def measure(effort: Effort) -> Section:
    cases = [_case(f, n, effort) for f in FAMILIES for n in f.sizes if n <= effort.largest]
    able = [case for case in cases if not case.repeated.failure]
    times = interleave({case.key: case.repeated.entry for case in able}, effort)
    jobs = [
        Job(case.key, case.family.model, (case.n,), case.h / 2, case.repeated.solves)
        for case in able
        if case.family.model
    ]
    theirs, remarks = measured(jobs, effort)
    rows = [_row(case, times.get(case.key), theirs.get(case.key, {})) for case in cases]
    failures = [f"{c.key}: {c.repeated.failure}" for c in cases if c.repeated.failure]
    return Section(
        name="rigid-chains",
        title="Rigid chains and rows of loops",
        method=(
            "Chains of N links of 0.1 m and 0.1 kg with hinges, in space across each other, let go "
            "from the horizontal; the hanging chain is one of N bars between two nails, let go "
            "from a half circle; inner steps of 1 ms. A02: N loops of bars on N + 1 cranks, inner "
            f"steps of 2.5 ms. All as pairs, after {WARM_UP} of them, settings as by default. "
            f"{METHOD}"
        ),
        tables=[Table(title="", columns=COLUMNS, rows=rows)],
        goals=[*_per_body(rows), *_exponents(rows)],
        remarks=[*remarks, *_their_exponents(rows), *failures],
    )


def _case(family: Family, n: int, effort: Effort) -> Case:
    integrator = start_scene(solver.loads(family.text(n), name=f"{family.name}.toml"))
    h = step_of(integrator.model.settings)
    count = effort.count(max(5, STEPS_TIMES_BODIES // family.bodies(n)), least=2)
    repeated = Repeated(integrator, h, count, WARM_UP)
    return Case(family, n, h, repeated)


def _row(case: Case, times: Times | None, theirs: dict[str, Any]) -> dict[str, Value]:
    bodies, row = case.family.bodies(case.n), beside(case.repeated.row(times), theirs)
    if times is not None:
        row["body"] = float(row["solve"]) / bodies
        row["iteration"] = row["body"] / float(row["newton"])
    return {"family": case.family.name, "n": case.n, "bodies": bodies, **row}


def _per_body(rows: list[dict[str, Value]]) -> list[Goal]:
    text = "inner step and body, {family} N = {n}"
    chains = [row for row in rows if row["family"] == "spatial rigid chain"]
    return [Goal.of_row(text.format(**row), PER_BODY, row, "body") for row in chains]


def _exponents(rows: list[dict[str, Value]]) -> list[Goal]:
    goals = []
    for family in FAMILIES:
        ends, power = _exponent(rows, family, "solve")
        if len(ends) == 2:
            what = f"p in cost of a step ~ N^p, N = {ends[0]} to {ends[1]}, {family.name}"
            goals.append(Goal(what=what, unit="1", goal=LINEAR, value=power))
    return goals


def _their_exponents(rows: list[dict[str, Value]]) -> list[str]:
    found = ((family.name, _exponent(rows, family, "exudyn")[1]) for family in FAMILIES)
    return [f"Exudyn, {name}: p = {p:.2f} over the same N" for name, p in found if p is not None]


def _exponent(
    rows: list[dict[str, Value]], family: Family, column: str
) -> tuple[list[int], float | None]:
    """Sizes between which the exponent is taken, and the exponent, None if not measured."""
    mine = [row for row in rows if row["family"] == family.name]
    sizes = [int(row["n"]) for row in mine if int(row["n"]) >= family.first]
    ends = [sizes[0], sizes[-1]] if len(sizes) > 1 else []
    return ends, exponent(mine, ends, column)
