"""CPU and wall time of work that takes place in new processes, the minimum of several."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from benchmarks.measuring.effort import Effort
from benchmarks.measuring.first_step import PARTS
from benchmarks.measuring.timing import Times
from build_fmu import build

ROOT = Path(__file__).resolve().parents[2]
LIMIT = 5
"""Repetitions of what takes a process."""


class Durations(NamedTuple):
    """CPU and wall times of the same repetitions."""

    cpu: Times
    wall: Times

    @classmethod
    def of(cls, runs: Iterable[Iterable[float]]) -> Durations:
        """Those of (CPU, wall) seconds of each repetition."""
        return cls(*map(Times, zip(*runs, strict=True)))


def build_times(scene: Path, target: Path, effort: Effort) -> dict[str, Durations]:
    """Building an FMU by the command line in a new process, and again in this one."""
    command = [sys.executable, "-m", "build_fmu", "build", str(scene), "-o", str(target)]
    new, same = [], []
    build(scene, target)
    for _ in range(min(effort.repetitions, LIMIT)):
        before, begin = children_cpu(), time.perf_counter()
        printed(command)
        wall = time.perf_counter() - begin
        after = children_cpu()
        new.append((wall if before is None or after is None else after - before, wall))
        cpu, begin = time.process_time(), time.perf_counter()
        build(scene, target)
        same.append((time.process_time() - cpu, time.perf_counter() - begin))
    return {"new process": Durations.of(new), "same process": Durations.of(same)}


def first_step_times(fmu: Path, effort: Effort) -> dict[str, Durations]:
    """Parts of the way from a new process to a first step in fmpy."""
    runs = [
        json.loads(printed([sys.executable, "-m", "benchmarks.measuring.first_step", str(fmu)]))
        for _ in range(min(effort.repetitions, LIMIT))
    ]
    return {part: Durations.of(run[part] for run in runs) for part in PARTS}


def printed(command: Sequence[str], folder: Path = ROOT) -> str:
    """What a program prints that is started in a folder, by default the repository.

    Raises
    ------
    RuntimeError
        When it fails; the text is what it says of that.
    """
    run = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)
    if run.returncode:
        raise RuntimeError(run.stderr.strip() or f"ended with code {run.returncode}")
    return run.stdout


def children_cpu() -> float | None:
    """CPU seconds of all processes that were started and have ended; None if not known."""
    try:
        import resource
    except ImportError:
        return None
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
