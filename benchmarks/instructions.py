"""Instructions of an inner step, counted by valgrind's callgrind: a measure without noise."""

from __future__ import annotations

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
FUNCTION = "hm_advance_*"
"""The planar and the spatial one, to which the exported function jumps."""

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
            "Machine instructions of a communication step in the kernel, from the initial "
            "configuration, counted by valgrind --tool=callgrind, plain steps of 1 ms; mechanisms "
            "as above. They do not depend on what else the machine does."
        ),
        tables=[Table(title="", columns=COLUMNS, rows=rows, formats=FORMATS)] if rows else [],
        remarks=remarks,
    )


def mechanisms() -> dict[str, tuple[Content, int, int]]:
    """Content, number of moving points and of steps, by name."""
    return {
        "double pendulum": (hanging_chain(2), 2, 2000),
        "spatial chain N = 100": (waving_chain(100, 3), 100, 100),
    }


def _count(content: Content, algorithm: str, steps: int) -> tuple[dict[str, Value], str]:
    """Number of instructions of an inner step; or the reason why there is none."""
    settings = {"step_size": STEP, "paired": False, "algorithm": algorithm}
    model = solver.assemble(scene(content, **settings))
    with tempfile.TemporaryDirectory() as name:
        path, counts = Path(name, "model.bin"), Path(name, "counts")
        path.write_bytes(model.to_bytes())
        command = ["valgrind", "--tool=callgrind", f"--toggle-collect={FUNCTION}"]
        command += [f"--callgrind-out-file={counts}", sys.executable]
        command += ["-m", "benchmarks.kernel_run", str(path), str(steps)]
        run = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
        text = counts.read_text(encoding="utf-8") if counts.exists() else ""
    total = re.search(r"^(?:totals|summary): (\d+)", text, re.MULTILINE)
    if run.returncode or total is None or int(total[1]) == 0:
        return {}, run.stderr.strip().rpartition("\n")[2] or f"valgrind ended with {run.returncode}"
    solves = int(run.stdout.split()[-1])
    return {"solves": float(solves), "count": int(total[1]) / solves}, ""
