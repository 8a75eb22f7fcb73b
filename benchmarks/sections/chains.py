"""Cost of a step, of assembly and of memory against the number of bodies, to 10^5."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass

from benchmarks.measuring.effort import Effort
from benchmarks.measuring.processes import printed
from benchmarks.pages.report import Goal, Section, Table, Value, exponent


@dataclass(frozen=True, slots=True)
class Kind:
    """A chain of any length."""

    key: str
    what: str
    sizes: tuple[int, ...]
    share: int
    """Points of the longest chain of points for each body of the longest one of this kind."""
    steps_times_n: int


KINDS = (
    Kind("points", "points on rods", (10, 100, 1000, 10_000, 100_000), 1, 50_000),
    Kind("bodies", "hinged rigid bodies", (10, 100, 1000, 10_000), 10, 5_000),
)
LINEAR = 1.1
FIRST_OF_FIT = 100
"""Below that, what does not depend on N is a large part of a step."""

COLUMNS = {
    "what": "chain of",
    "n": ("N", ".0f"),
    "step": ("µs per half step", ".4g"),
    "node": ("µs per half step and part", ".3f"),
    "newton": ("Newton iterations", ".1f"),
    "energy": ("energy.error", ".1e"),
    "constraint": ("constraint.position", ".1e"),
    "noise": ("noise", ".2f"),
    "read": ("read, s", ".2f"),
    "assemble": ("assemble, s", ".2f"),
    "kernel": ("kernel, bytes per part", ".0f"),
    "peak": ("process, bytes per part", ".0f"),
    "remark": "",
}


def measure(effort: Effort) -> Section:
    rows = [_row(kind, _child(kind, n, effort)) for kind in KINDS for n in _sizes(kind, effort)]
    return Section(
        name="chains",
        title="Cost against the number of bodies",
        method=(
            "The spatial chain of the table above, and spatial rigid bodies on hinges that turn "
            "across each other, let go from the horizontal; half steps of 1 ms, each N in a "
            "process of its own. *Read* is from the text of the scene to a checked scene, "
            "*assemble* from there to the first step. *Kernel* is all memory that the compiled "
            "kernel works on; *process* is the growth of the largest memory of the process, with "
            "Python's objects."
        ),
        tables=[Table(title="", columns=COLUMNS, rows=rows)],
        goals=[goal for kind in KINDS for goal in _goals(kind, rows, effort)],
        remarks=[
            f"{row['what']}, N = {row['n']}: {row['failure']}" for row in rows if row["failure"]
        ],
    )


def _sizes(kind: Kind, effort: Effort) -> list[int]:
    largest = max(kind.sizes[0], effort.largest // kind.share)
    return [n for n in kind.sizes if n <= largest]


def _goals(kind: Kind, rows: list[dict[str, Value]], effort: Effort) -> list[Goal]:
    """Growth of a step and of reading with assembly, from 100 parts to the longest chain."""
    largest = _sizes(kind, effort)[-1]
    if largest <= FIRST_OF_FIT:
        return []
    mine = [row for row in rows if row["kind"] == kind.key]
    span = f"~ N^p, N = {FIRST_OF_FIT} to {largest}, {kind.what}"
    found = {"cost of a step": "step", "time to read and assemble": "start"}
    return [
        Goal(
            what=f"p in {what} {span}", unit="1", goal=LINEAR,
            value=exponent(mine, (FIRST_OF_FIT, largest), column),
        )
        for what, column in found.items()
    ]  # fmt: skip


def _child(kind: Kind, n: int, effort: Effort) -> dict[str, Value]:
    """What was measured, in a process of its own."""
    count = effort.count(max(2, kind.steps_times_n // n), least=2)
    numbers = [str(number) for number in (n, count, effort.repetitions)]
    command = [sys.executable, "-m", "benchmarks.measuring.chain_run", kind.key, *numbers]
    try:
        return json.loads(printed(command))
    except RuntimeError as error:
        reason = str(error).rpartition("\n")[2]
        return {"kind": kind.key, "n": n, "failure": reason}


def _row(kind: Kind, facts: dict[str, Value]) -> dict[str, Value]:
    """Divide what was measured of one chain by its parts."""
    row, n = dict(facts), float(facts["n"] or 0)
    for key, source, factor in (
        ("kernel", "kernel_bytes", 1.0 / n),
        ("peak", "peak_bytes", 1.0 / n),
        ("node", "step", 1e6 / n),
        ("step", "step", 1e6),
    ):
        value = facts.get(source)
        row[key] = None if value is None else factor * float(value)
    row["what"] = kind.what
    row["start"] = float(facts.get("read") or 0) + float(facts.get("assemble") or 0) or None
    row["remark"] = "see below" if facts["failure"] else ""
    return row
