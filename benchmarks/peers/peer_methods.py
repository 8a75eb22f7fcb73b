"""A way of solving a problem with settings from coarse to fine, and how it is measured.

The same loop runs here and, for codes that have interpreters of their own, in theirs
(`benchmarks.peers.peer_run`): NumPy alone is needed.
"""

from __future__ import annotations

import gc
import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib import import_module
from typing import Any

from benchmarks.measuring.effort import Effort, repeated
from benchmarks.measuring.timing import Entry, interleave
from benchmarks.problems.catalogue import PROBLEMS
from benchmarks.problems.parts import Array, Problem

FLOOR = 3e-12
"""Error [m] below which no finer setting is tried: the last digits of the references."""
LONGEST = 0.06
"""CPU seconds of a run after which no finer one is tried in a full run."""
PATIENCE = 4
"""Settings that fail, after which a curve is given up."""
SAMPLES = 50
"""Times at which the energy of a run is looked at."""
LARGEST = 100
"""Most bodies of a model, for codes that take too long on larger ones."""
Row = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Observed:
    """What a run came to: positions and velocities of the watched places at the end [m, m/s]."""

    q: Sequence[Sequence[float]]
    v: Sequence[Sequence[float]]
    energy: float
    """Largest deviation from the energy at the start, of all that was looked at [J]."""
    change: float
    """Energy at the end less that at the start [J]."""
    remark: str = ""

    @classmethod
    def of(cls, q: Array, v: Array, energies: Sequence[float], remark: str = "") -> Observed:
        """From arrays (places, 3) and the energies of the samples, that of the start first."""
        deviations = [float(energy - energies[0]) for energy in energies]
        largest = max(map(abs, deviations))
        return cls(q.tolist(), v.tolist(), largest, deviations[-1], remark)


class GaveUpError(Exception):
    """A code did not solve a problem with a setting; the text says why."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Method:
    """A solver as a curve: one point of it for each setting."""

    name: str
    label: str
    """How a setting is written, as a format of it."""
    settings: Callable[[Problem], Sequence[float]]
    """From coarse to fine; none where the problem cannot be modelled."""
    observe: Callable[[Problem, float], Observed]
    """A run that is looked at; raises `GaveUpError`."""
    entry: Callable[[Problem, float], Entry]
    """The same run, to be timed: from the state at the start to that at the end."""
    excuse: Callable[[Problem], str] = lambda _: ""
    """Why there are no settings."""


@dataclass(frozen=True, slots=True)
class Limits:
    """Where a curve ends."""

    run: float
    """CPU seconds of a run after which no finer one is tried."""
    settings: int
    """Most settings of a curve."""
    repetitions: int
    budget: float
    """CPU seconds after which a run is repeated three times at most."""

    @classmethod
    def of(cls, effort: Effort) -> Limits:
        """Those of an effort: a quick or tiny run has coarse settings alone."""
        return cls(LONGEST * effort.scale**0.5, effort.steps, min(5, effort.repetitions), 0.02)


def too_large(problem: Problem) -> str:
    """Excuse of a code that is not measured on large models; empty where a model is not."""
    return f"not measured: more than {LARGEST} bodies" if len(problem.bodies) > LARGEST else ""


def run(request: dict[str, Any]) -> list[Row]:
    """Rows of the methods of a `module` on a `problem`, with `limits` and `expected` places."""
    methods = import_module(f"benchmarks.peers.{request['module']}").METHODS
    problem = PROBLEMS[request["problem"]]()
    return measured(problem, methods, Limits(**request["limits"]), request["expected"])


def measured(
    problem: Problem,
    methods: Sequence[Method],
    limits: Limits,
    expected: Sequence[Sequence[float]],
) -> list[Row]:
    """Rows of all methods on a problem, timed in turn; JSON can hold them.

    `expected` is where the watched places should be at the end [m].
    """
    # What is there stays there: the collections before each repetition need not look at it again.
    gc.collect()
    gc.freeze()
    try:
        return _measured(problem, methods, limits, expected)
    finally:
        gc.unfreeze()


def _measured(
    problem: Problem,
    methods: Sequence[Method],
    limits: Limits,
    expected: Sequence[Sequence[float]],
) -> list[Row]:
    rows: list[Row] = []
    entries: dict[str, Entry] = {}
    for method in methods:
        if excuse := method.excuse(problem):
            rows.append({"solver": method.name, "setting": "", "remark": excuse})
            continue
        failures = 0
        for setting in method.settings(problem)[: limits.settings]:
            label = method.label.format(setting)
            row: Row = {"solver": method.name, "setting": label, "value": setting}
            rows.append(row)
            try:
                row |= asdict(method.observe(problem, setting))
                entry = method.entry(problem, setting)
                seconds = once(entry)
            except GaveUpError as reason:
                row["remark"] = str(reason)
                failures += 1
                if failures == PATIENCE:
                    break
                continue
            entries[str(len(rows) - 1)] = entry
            if seconds > limits.run or distance(row["q"], expected) < FLOOR:
                break
    _time(rows, entries, limits)
    return rows


def once(entry: Entry) -> float:
    """CPU time of one run [s]."""
    entry.prepare()
    begin = time.process_time()
    entry.run()
    return time.process_time() - begin


def _time(rows: list[Row], entries: Mapping[str, Entry], limits: Limits) -> None:
    effort = repeated(limits.repetitions, limits.budget)
    for key, times in interleave(entries, effort).items():
        rows[int(key)] |= {"ms": 1e3 * times.minimum, "noise": times.noise}


def distance(found: Sequence[Sequence[float]], expected: Sequence[Sequence[float]]) -> float:
    """Largest distance of places, or difference of velocities, from where they should be."""
    return max(math.dist(a, b) for a, b in zip(found, expected, strict=True))
