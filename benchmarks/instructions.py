"""Instructions of an inner step, counted by valgrind's callgrind: a measure without noise."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import solver
from benchmarks.effort import Effort
from benchmarks.mechanisms import Content, hanging_chain, scene, waving_chain
from benchmarks.report import Section, Table, Value

ROOT = Path(__file__).resolve().parents[1]
STEP = 1e-3
COLUMNS = {
    "mechanism": "mechanism",
    "algorithm": "algorithm",
    "solves": "inner steps",
    "count": "instructions per inner step",
    "point": "per inner step and point",
}
FORMATS = {"solves": ".0f", "count": ".0f", "point": ".0f"}


def measure(effort: Effort) -> Section:
    rows: list[dict[str, Value]] = []
    remarks = []
    if shutil.which("valgrind") is None:
        remarks.append("Not counted: valgrind is not installed on this machine.")
    else:
        for name, (content, points, steps) in mechanisms().items():
            for algorithm in ("nested", "simultaneous"):
                row, reason = _count(content, algorithm, effort.count(steps, least=2))
                if reason:
                    remarks.append(f"{name}, {algorithm}: not counted: {reason}")
                    continue
                count = row["count"]
                each = {"point": float(count or 0.0) / points}
                rows.append({"mechanism": name, "algorithm": algorithm} | row | each)
    return Section(
        name="instructions",
        title="Instructions",
        method=(
            "Machine instructions of the process, counted by valgrind --tool=callgrind: difference "
            "of two runs from the initial configuration, one of three times the steps, divided by "
            "the difference of inner steps. Plain steps of 1 ms; mechanisms as above. They do not "
            "depend on what else the machine does."
        ),
        tables=[Table(title="", columns=COLUMNS, rows=rows, formats=FORMATS)] if rows else [],
        remarks=remarks,
    )


def mechanisms() -> dict[str, tuple[Content, int, int]]:
    """Content, number of moving points and of steps, by name."""
    return {
        "double pendulum": (hanging_chain(2), 2, 1000),
        "spatial chain N = 100": (waving_chain(100, 3), 100, 50),
    }


def _count(content: Content, algorithm: str, steps: int) -> tuple[dict[str, Value], str]:
    """Instructions of an inner step; or the reason why they could not be counted.

    Two runs that differ in nothing but the number of steps: their difference holds no start-up, and
    the kernel needs no symbols.
    """
    settings = {"step_size": STEP, "paired": False, "algorithm": algorithm}
    model = solver.assemble(scene(content, **settings))
    with tempfile.TemporaryDirectory() as name:
        path = Path(name, "model.bin")
        path.write_bytes(model.to_bytes())
        try:
            (few, i_few), (many, i_many) = (_run(path, n) for n in (steps, 3 * steps))
        except RuntimeError as error:
            return {}, str(error)
    return {"solves": float(many - few), "count": (i_many - i_few) / (many - few)}, ""


def _run(model: Path, steps: int) -> tuple[int, int]:
    """Implicit solves and instructions of a process that takes `steps` internal steps."""
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={model.with_name('counts')}"]
    command += [sys.executable, "-m", "benchmarks.kernel_run", str(model), str(steps)]
    run = subprocess.run(
        command,
        capture_output=True,
        text=True,
        check=False,
        cwd=ROOT,
        env=os.environ | {"PYTHONHASHSEED": "0"},
    )
    total = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode or total is None:
        reason = run.stderr.strip().rpartition("\n")[2]
        raise RuntimeError(reason or f"valgrind ended with code {run.returncode}")
    return int(run.stdout.split()[-1]), int(total[1])
