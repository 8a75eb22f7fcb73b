"""CPU and wall time of work that takes place in new processes, the minimum of several."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.effort import Effort
from benchmarks.first_step import PARTS
from build_fmu import build

ROOT = Path(__file__).resolve().parents[1]
LIMIT = 5
"""Repetitions of what takes a process."""


@dataclass(frozen=True, slots=True)
class Durations:
    """(CPU, wall) seconds of each repetition."""

    runs: tuple[tuple[float, float], ...]

    @property
    def cpu(self) -> float:
        """Least CPU time [s]."""
        return min(run[0] for run in self.runs)

    @property
    def wall(self) -> float:
        """Least wall time [s]."""
        return min(run[1] for run in self.runs)

    @property
    def noise(self) -> float:
        """Median over minimum of the CPU time."""
        return statistics.median(run[0] for run in self.runs) / max(self.cpu, 1e-9)


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
    return {"new process": Durations(tuple(new)), "same process": Durations(tuple(same))}


def first_step_times(fmu: Path, effort: Effort) -> dict[str, Durations]:
    """Parts of the way from a new process to a first step in fmpy."""
    runs = [
        json.loads(printed([sys.executable, "-m", "benchmarks.first_step", str(fmu)]))
        for _ in range(min(effort.repetitions, LIMIT))
    ]
    return {part: Durations(tuple(tuple(run[part]) for run in runs)) for part in PARTS}


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
