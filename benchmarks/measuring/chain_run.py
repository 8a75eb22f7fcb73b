"""A long chain in its own process.

`python -m benchmarks.measuring.chain_run KIND N COUNT REPETITIONS`

Prints as JSON what it took to read and assemble the chain, to step it, and the memory it needed.
"""

from __future__ import annotations

import json
import re
import sys
import time
from pathlib import Path

import solver
from benchmarks.measuring.effort import repeated
from benchmarks.measuring.stepping import Repeated
from benchmarks.measuring.timing import interleave
from benchmarks.pages.report import Value
from benchmarks.problems.mechanisms import start_scene, waving_chain
from scenes.generate import rigid_chain
from solver.runtime import Integrator, Model
from tests.support.kernel.kernel_calls import kernel_of

STEP = 2e-3  # two half steps
WARM_UP = 5


def text_of(kind: str, n: int) -> dict[str, str]:
    """Text and notation of a spatial chain of n points on rods, or of n hinged rigid bodies."""
    if kind == "points":
        return {"text": json.dumps(waving_chain(n, 3)), "format": "json"}
    return {"text": rigid_chain(n), "format": "toml"}


def run(kind: str, n: int, count: int, repetitions: int) -> dict[str, Value]:
    """Measure a chain, `count` half steps at a time."""
    start_scene(solver.loads(**text_of(kind, 10)))  # what the first scene imports is no part of it
    text = text_of(kind, n)
    before = peak_bytes()
    begin = time.process_time()
    drawn = solver.loads(**text, overrides={"solver.step_size": STEP})
    read = time.process_time()
    integrator = start_scene(drawn)
    assembled = time.process_time()
    model, engine = integrator.model, kernel_of(integrator)
    doubles = len(engine.numbers) + len(engine.state) + len(engine.work)
    integers = sum(len(table) for table in model.tables.values())
    after = peak_bytes()
    facts: dict[str, Value] = {
        "kind": kind,
        "n": n,
        "read": read - begin,
        "assemble": assembled - read,
        "kernel_bytes": 8 * doubles + 4 * integers,
        "peak_bytes": after - before if after and before else None,
    }
    return facts | steps(model, max(1, count // 2), repetitions)


def steps(model: Model, count: int, repetitions: int) -> dict[str, Value]:
    """Seconds and Newton iterations of a half step; or why there is none."""
    integrator = Integrator(model)
    integrator.initialise()
    case = Repeated(integrator, STEP, count, WARM_UP)
    if case.failure:
        return {"failure": case.failure}
    times = interleave({"steps": case.entry}, repeated(repetitions, 0.5))["steps"]
    row = case.row(times)
    return {**row, "step": times.minimum / case.solves, "failure": row.pop("remark")}


def peak_bytes() -> float | None:
    """Largest memory that this process has held so far; None where the system does not say."""
    status = Path("/proc/self/status")
    if status.exists():
        high = re.search(r"VmHWM:\s+(\d+) kB", status.read_text(encoding="ascii"))
        return 1024.0 * float(high[1]) if high else None
    try:
        import resource
    except ImportError:
        return None
    size = float(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    return size if sys.platform == "darwin" else 1024.0 * size


if __name__ == "__main__":
    print(json.dumps(run(sys.argv[1], *(int(argument) for argument in sys.argv[2:5]))))
