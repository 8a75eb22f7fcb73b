"""Cost of a step, of assembly and of memory against the number of bodies, to 10^5."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path

from benchmarks.effort import Effort
from benchmarks.report import Goal, Section, Table, Value

POINTS = (10, 100, 1000, 10_000, 100_000)
STEPS_TIMES_POINTS = 50_000
LINEAR = 1.1
FIRST_OF_FIT = 100
"""Below that, what does not depend on N is a large part of a step."""

COLUMNS = {
    "n": "N",
    "algorithm": "algorithm",
    "step": "µs per step",
    "node": "µs per step and point",
    "newton": "Newton iterations",
    "noise": "noise",
    "read": "read, s",
    "assemble": "assemble, s",
    "kernel": "kernel, bytes per point",
    "peak": "process, bytes per point",
    "remark": "",
}
FORMATS = {
    "n": ".0f", "step": ".4g", "node": ".3f", "newton": ".1f", "noise": ".2f",
    "read": ".2f", "assemble": ".2f", "kernel": ".0f", "peak": ".0f",
}  # fmt: skip


def measure(effort: Effort) -> Section:
    rows = [_row(f) for n in POINTS if n <= effort.largest for f in _child(n, effort)]
    largest = max(n for n in POINTS if n <= effort.largest)
    return Section(
        name="chains",
        title="Cost against the number of bodies",
        method=(
            "The spatial chain of the table above, plain steps of 1 ms, each N in a "
            "process of its own. *Read* is from the text of the scene to a checked scene, "
            "*assemble* from there to the first step. *Kernel* is all memory that the compiled "
            "kernel works on; *process* is the growth of the largest memory of the process, with "
            "Python's objects."
        ),
        tables=[Table(title="", columns=COLUMNS, rows=rows, formats=FORMATS)],
        goals=[
            Goal(
                what=f"p in cost of a step ~ N^p, N = {FIRST_OF_FIT} to {largest}, {algorithm}",
                unit="1",
                goal=LINEAR,
                value=_exponent(rows, algorithm),
            )
            for algorithm in ("nested", "simultaneous")
        ]
        if largest > FIRST_OF_FIT
        else [],
        remarks=[
            f"N = {row['n']}, {row.get('algorithm', 'both')}: {row['failure']}"
            for row in rows
            if row["failure"]
        ],
    )


def _child(n: int, effort: Effort) -> list[dict[str, Value]]:
    """One row for each algorithm, from a process of its own."""
    count = effort.count(max(2, STEPS_TIMES_POINTS // n), least=2)
    numbers = [str(number) for number in (n, count, effort.repetitions)]
    run = subprocess.run(
        [sys.executable, "-m", "benchmarks.chain_run", *numbers],
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).resolve().parents[1],
    )
    if run.returncode:
        reason = run.stderr.strip().rpartition("\n")[2] or f"ended with code {run.returncode}"
        return [{"n": n, "failure": reason}]
    return json.loads(run.stdout)


def _row(facts: dict[str, Value]) -> dict[str, Value]:
    """Divide what was measured of one chain by its points."""
    row, n = dict(facts), float(facts["n"] or 0)
    for key, source, factor in (
        ("kernel", "kernel_bytes", 1.0 / n),
        ("peak", "peak_bytes", 1.0 / n),
        ("node", "step", 1e6 / n),
        ("step", "step", 1e6),
    ):
        value = facts.get(source)
        row[key] = None if value is None else factor * float(value)
    row["remark"] = "see below" if facts["failure"] else ""
    return row


def _exponent(rows: list[dict[str, Value]], algorithm: str) -> float | None:
    """Slope between the chain of 100 points and the longest; None when either was not measured."""
    ends = [row for row in rows if row["n"] in (FIRST_OF_FIT, rows[-1]["n"])]
    points = [
        (math.log(float(row["n"] or 0)), math.log(float(step)))
        for row in ends
        if row.get("algorithm") == algorithm and (step := row.get("step")) is not None
    ]
    if len(points) != 2:
        return None
    (small, first), (large, last) = points
    return (last - first) / (large - small)
