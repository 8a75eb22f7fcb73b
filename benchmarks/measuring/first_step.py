"""`python -m benchmarks.measuring.first_step FMU`: from a new process to the first step in fmpy.

Prints as JSON the CPU and wall seconds of each part. The archive is unpacked into a new folder;
that its file is in the system's cache is all that an earlier process leaves behind.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time
from itertools import pairwise

PARTS = (
    "import fmpy",
    "read the description",
    "unpack",
    "load and instantiate",
    "initialise, step, read",
)
STEP = 0.01


def run(path: str) -> dict[str, tuple[float, float]]:
    """Load an FMU and take one step; (CPU, wall) seconds of each part."""
    marks = [_now()]
    import fmpy
    from fmpy.fmi2 import FMU2Slave

    marks.append(_now())
    description = fmpy.read_model_description(path)
    marks.append(_now())
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        fmpy.extract(path, folder)
        marks.append(_now())
        assert description.coSimulation is not None
        fmu = FMU2Slave(
            guid=description.guid,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="first",
        )
        fmu.instantiate()
        marks.append(_now())
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
        fmu.exitInitializationMode()
        fmu.doStep(0.0, STEP)
        outputs = [v for v in description.modelVariables if v.causality == "output"]
        fmu.getReal([variable.valueReference for variable in outputs])
        marks.append(_now())
        fmu.terminate()
        fmu.freeInstance()
    parts = zip(PARTS, pairwise(marks), strict=True)
    return {part: (b[0] - a[0], b[1] - a[1]) for part, (a, b) in parts}


def _now() -> tuple[float, float]:
    return time.process_time(), time.perf_counter()


if __name__ == "__main__":
    print(json.dumps(run(sys.argv[1])), flush=True)
    os._exit(0)  # without the exit handlers of pythonfmu's library, which read freed memory
