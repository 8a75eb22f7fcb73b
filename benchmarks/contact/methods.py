"""A way of solving problems with impacts, its settings, and the best of what it reaches.

The same loop runs here and, for codes that have interpreters of their own, in theirs
(`benchmarks.peers.peer_run`): NumPy alone is needed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib import import_module
from typing import Any

from benchmarks.contact.problems import PROBLEMS, Problem, Score
from benchmarks.measuring.effort import repeated
from benchmarks.measuring.timing import Entry, interleave
from benchmarks.peers.peer_methods import GaveUpError, Row, once

Setting = dict[str, Any]
REPETITIONS = 5
STEPS = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8)
PHASES = (0.6, 0.2, 0.06, 0.02)
"""Step times √(k/m), of a soft contact's oscillation: π/phase steps a contact."""
USUAL = 1e-3
"""A step [s] whose runs are kept, whatever they reach."""


def steps(problem: Problem) -> list[float]:
    """Steps of codes with soft contacts, from coarse to fine [s]."""
    return [h for h in STEPS if h <= (1e-4 if problem.kind == "slider_crank" else 1e-2)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Method:
    """A solver; all its settings are tried, those of a family from coarse to fine."""

    name: str
    families: Callable[[Problem], Iterable[Iterable[Setting]]]
    label: Callable[[Setting], str]
    entry: Callable[[Problem, Setting], Entry]
    """The run as it is timed, without looking at it."""
    score: Callable[[Problem, Setting], Score]
    """The same run, looked at; raises `GaveUpError`."""


@dataclass(frozen=True, slots=True)
class Limits:
    """Where a family ends."""

    run: float
    """CPU seconds of a run after which no finer one is tried."""
    settings: int
    """Most settings of a family."""


def run(request: dict[str, Any]) -> list[Row]:
    """Rows of the methods of a `module` on a `problem`, with `limits`."""
    methods = import_module(f"benchmarks.contact.{request['module']}").METHODS
    return measured(PROBLEMS[request["problem"]], methods, Limits(**request["limits"]))


def measured(problem: Problem, methods: Sequence[Method], limits: Limits) -> list[Row]:
    """The best runs of each method, timed in turn; JSON can hold them."""
    rows: list[Row] = []
    entries: dict[str, Entry] = {}
    for method in methods:
        tried = [
            row for family in method.families(problem) for row in _family(
                problem, method, list(family)[: limits.settings], limits.run
            )
        ]  # fmt: skip
        for row in best(tried):
            setting = row["setting"]
            entries[str(len(rows))] = method.entry(problem, setting)
            rows.append(row | {"setting": method.label(setting), "h": setting.get("h")})
    for key, times in interleave(entries, repeated(REPETITIONS, limits.run)).items():
        rows[int(key)] |= {"ms": 1e3 * times.minimum, "noise": times.noise}
    return rows


def _family(
    problem: Problem, method: Method, settings: Sequence[Setting], limit: float
) -> Iterable[Row]:
    for setting in settings:
        try:
            entry = method.entry(problem, setting)
            seconds = once(entry)
            found = method.score(problem, setting)
        except GaveUpError:
            continue
        if math.isfinite(found.energy):
            yield {"solver": method.name, "setting": setting, "ms": 1e3 * seconds} | asdict(found)
        if seconds > limit:
            break


def best(rows: Sequence[Row]) -> list[Row]:
    """Rows that no faster one beats in the times of impacts or in the energy."""
    front: list[Row] = []
    events, energy = math.inf, math.inf
    for row in sorted(rows, key=lambda row: row["ms"]):
        timely = row["events"] is not None and row["events"] < events
        if timely or row["energy"] < energy or row["setting"].get("h") == USUAL:
            front.append(row)
        events = row["events"] if timely else events
        energy = min(energy, row["energy"])
    return front


def reached(rows: Iterable[Mapping[str, Any]], error: float) -> Mapping[str, Any] | None:
    """The fastest row whose times of impacts are as good as an error."""
    good = [row for row in rows if row["events"] is not None and row["events"] <= error]
    return min(good, key=lambda row: row["ms"], default=None)
