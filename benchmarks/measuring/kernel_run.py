"""Advance a compiled model, and nothing else.

`python -m benchmarks.measuring.kernel_run MODEL STEPS`

Needs the standard library alone, so that a program which watches the process has little to see.
Prints the number of implicit solves.
"""

from __future__ import annotations

import sys
from pathlib import Path

from solver.options import step_of
from solver.runtime import Integrator, Model


def run(path: str, steps: int) -> int:
    """Take internal steps in one call of the kernel; return the number of implicit solves."""
    model = Model.from_bytes(Path(path).read_bytes())
    integrator = Integrator(model)
    integrator.initialise()
    integrator.advance(integrator.time, steps * step_of(model.settings))
    return round(float(integrator["solver.substeps"]))


if __name__ == "__main__":
    print(run(sys.argv[1], int(sys.argv[2])))
