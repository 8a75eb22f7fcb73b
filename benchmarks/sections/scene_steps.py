"""Microseconds per inner and per communication step of every scene without contacts."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.measuring.effort import Effort
from benchmarks.measuring.stepping import Repeated, in_equal_steps
from benchmarks.measuring.timing import Entry, Times, interleave
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.peers.exudyn_peer import METHOD, Job, beside, measured
from benchmarks.problems.mechanisms import start_scene
from solver.options import step_of
from tests.support.mechanisms.scene_files import SMOOTH

LONGEST = 500
"""Internal steps of a repetition, or those of the scene's experiment."""
GOALS = {"andrews": 12.0, "bricard": 40.0}
"""Of an inner step [µs]."""
PEERS: dict[str, tuple[str, tuple[float, ...]]] = {
    "andrews": ("andrews", ()),
    "bricard": ("bricard", ()),
    "double_wishbone": ("double_wishbone", (0.0,)),
    "flyball_governor": ("governor", ()),
    "heavy_top": ("heavy_top", ()),
}
"""Problems that Exudyn moves without calls of Python, and their arguments."""

COLUMNS = {
    "mechanism": "mechanism",
    "bodies": ("bodies and points", ".0f"),
    "h": ("step, ms", ".4g"),
    "solve": ("µs per inner step", ".2f"),
    "exudyn": ("Exudyn, µs per step", ".1f"),
    "ratio": ("Exudyn / ours", ".1f"),
    "communication": ("µs per communication step", ".1f"),
    "inner": ("inner steps in it", ".0f"),
    "newton": ("Newton iterations per inner step", ".2f"),
    "their_newton": ("Exudyn's", ".2f"),
    "energy": ("energy.error, J", ".1e"),
    "constraint": ("constraint.position, m", ".1e"),
    "noise": ("noise", ".2f"),
    "remark": "",
}


@dataclass(frozen=True, slots=True)
class Case:
    """A scene ready to be stepped, and what was found at the end of its first run."""

    bodies: int
    h: float
    """Internal step [s]."""
    period: float
    """Communication step [s]."""
    inner: int
    """Inner steps of a communication step."""
    repeated: Repeated
    entries: dict[str, Entry]

    @property
    def communications(self) -> int:
        """Communication steps of a repetition."""
        return self.repeated.solves // self.inner


def measure(effort: Effort) -> Section:
    cases = {path.stem: _case(path, effort) for path in SMOOTH}
    entries = {
        f"{name} {kind}": entry
        for name, case in cases.items()
        if not case.repeated.failure
        for kind, entry in case.entries.items()
    }
    times = interleave(entries, effort)
    jobs = [
        Job(name, *model, cases[name].period / cases[name].inner, cases[name].repeated.solves)
        for name, model in PEERS.items()
        if not cases[name].repeated.failure
    ]
    theirs, remarks = measured(jobs, effort)
    rows = [_row(name, case, times, theirs.get(name, {})) for name, case in cases.items()]
    failures = [f"{n}: {c.repeated.failure}" for n, c in cases.items() if c.repeated.failure]
    return Section(
        name="mechanisms",
        title="Mechanisms",
        method=(
            "Every scene of `scenes/` without contacts from its start, with its own settings, "
            "or equal steps of 10 ms where it has none; a "
            f"repetition is its whole experiment, or its first {LONGEST} internal steps. Energy "
            "and constraint at the end of a repetition. The communication step is that of the "
            f"scene's experiment, without reading outputs. {METHOD}"
        ),
        tables=[Table(title="", columns=COLUMNS, rows=rows)],
        goals=[
            Goal.of_row(f"inner step, {key}", GOALS[key], row, "solve")
            for row in rows
            if (key := str(row["mechanism"])) in GOALS
        ],
        remarks=[*remarks, *failures],
    )


def _case(path: Path, effort: Effort) -> Case:
    scene = in_equal_steps(path)
    integrator = start_scene(scene)
    experiment = integrator.model.experiment
    period, h = experiment.step_size, step_of(integrator.model.settings)
    steps = max(1, round(period / h))
    longest = min(LONGEST, round((experiment.stop_time - experiment.start_time) / h))
    communications = max(1, effort.count(longest) // steps)
    repeated = Repeated(integrator, period / steps, communications * steps, warm_up=0)

    def communicate() -> None:
        for _ in range(communications):
            integrator.advance(integrator.time, period)

    entries = {"steps": repeated.entry, "communication": Entry(communicate, repeated.entry.prepare)}
    bodies = len(scene.bodies) + sum(not point.fixed for point in scene.points.values())
    inner = 2 * steps
    return Case(bodies, period / steps, period, inner, repeated, entries)


def _row(
    name: str, case: Case, times: dict[str, Times], theirs: dict[str, Any]
) -> dict[str, Value]:
    row = beside(case.repeated.row(times.get(f"{name} steps")), theirs)
    if communication := times.get(f"{name} communication"):
        row["communication"] = 1e6 * communication.minimum / case.communications
        row["inner"] = case.inner
    return {"mechanism": name, "bodies": case.bodies, "h": 1e3 * case.h, **row}
