"""Record what Exudyn computes, in this folder: `python -m tests.recorded.peer_models [NAME ...]`.

Each model of `benchmarks/peers/exudyn_models.py` is solved with steps h, h/2 and h/4. Generalized
alpha is of order 2, so that E(h) = (4 q(h/2) - q(h))/3 is of order 3; recorded is E(h/2), and as
its uncertainty the largest |E(h/2) - E(h)|, which is about seven times the error that remains.
"""

from __future__ import annotations

import datetime
import json
import sys
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np

FOLDER = Path(__file__).parent


@dataclass(frozen=True, slots=True)
class Run:
    """A model by its name, and how it is solved."""

    model: str
    stop: float
    """End [s]."""
    period: float
    """Between records [s]."""
    step: float
    """The coarsest of the three [s]."""
    newton: float = 1e-12
    """Relative tolerance of Newton's iteration."""


RUNS = {
    run.model: run
    for run in (
        Run("bricard", 10.0, 0.5, 1e-3),
        Run("heavy_top", 2.0, 0.1, 2e-5),
        Run("spatial_slider_crank", 0.1, 0.005, 2e-5),
        Run("free_slider_crank", 0.1, 0.005, 1e-5),
        Run("flyball_governor", 5.0, 0.25, 2e-4, newton=1e-10),  # stiff: rounding
        Run("double_wishbone", 2.0, 0.1, 2e-4, newton=1e-10),
    )
}


def solved(run: Run, step: float) -> dict[str, np.ndarray]:
    """Values (times, components) by name; needs Exudyn."""
    from benchmarks.peers.exudyn_models import moved

    values = moved(run.model, run.stop, run.period, step, run.newton)
    count = round(run.stop / run.period) + 1
    assert all(len(table) == count for table in values.values()), "a record is missing"
    return values


def extrapolated(run: Run, step: float) -> dict[str, np.ndarray]:
    """E(step): without the error of order 2."""
    coarse, fine = solved(run, step), solved(run, step / 2)
    return {name: (4.0 * fine[name] - coarse[name]) / 3.0 for name in fine}


def record(run: Run) -> dict[str, Any]:
    """Recorded values of a model with their origin."""
    coarse, fine = extrapolated(run, run.step), extrapolated(run, run.step / 2)
    differences = {name: float(np.max(np.abs(fine[name] - coarse[name]))) for name in fine}
    origin = {
        "program": "Exudyn",
        "version": metadata.version("exudyn"),
        "model": f"benchmarks/peers/exudyn_models.py, {run.model}",
        "integrator": "generalized alpha, index 3, spectral radius 0.9",
        "newton": run.newton,
        "steps": [run.step, run.step / 2, run.step / 4],
        "extrapolation": "(4 q(h/4) - q(h/2))/3",
        "uncertainty": "largest change when the steps of the extrapolation are halved",
        "day": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
    }
    times = [round(i * run.period, 12) for i in range(round(run.stop / run.period) + 1)]
    values = {name: np.round(table, 12).tolist() for name, table in fine.items()}
    return {"origin": origin, "times": times, "uncertainty": differences, "values": values}


def text(content: Any, depth: int = 0) -> str:
    """JSON with one line for each list of numbers."""
    items: list[str] = []
    if isinstance(content, dict):
        items = [f"{json.dumps(key)}: {text(value, depth + 1)}" for key, value in content.items()]
    elif isinstance(content, list) and content and isinstance(content[0], list):
        items = [json.dumps(row) for row in content]
    if not items:
        return json.dumps(content)
    indent = " " * (depth + 1)
    body = f",\n{indent}".join(items)
    first, last = ("{", "}") if isinstance(content, dict) else ("[", "]")
    return f"{first}\n{indent}{body}\n{indent[1:]}{last}" + ("" if depth else "\n")


def load(name: str) -> dict[str, Any]:
    """Record of a model."""
    return json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))


def main() -> None:
    """Write the records of the models that are named, or of all."""
    for name in sys.argv[1:] or RUNS:
        content = record(RUNS[name])
        (FOLDER / f"{name}.json").write_text(text(content), encoding="utf-8")
        print(name, content["uncertainty"])  # noqa: T201


if __name__ == "__main__":
    main()
