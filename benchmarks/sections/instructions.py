"""Instructions of an inner step, counted by valgrind's callgrind: a measure without noise."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import solver
from benchmarks.measuring import by_hand
from benchmarks.measuring.effort import Effort
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.problems.mechanisms import (
    GRAVITY,
    Content,
    four_bar,
    hanging_chain,
    scene,
    start,
    waving_chain,
)
from build_kernel.compiler import CompilerError

ROOT = Path(__file__).resolve().parents[2]
STEP = 1e-3
LEAST = 2.0
"""Goal: instructions of the kernel over those of the step written by hand."""

WHOLE_BLOCKS = "glibc.cpu.x86_rep_stosb_threshold=1000000000"
WHOLE_BLOCKS += ":glibc.cpu.x86_rep_movsb_threshold=1000000000"
"""Lets large blocks be copied by vectors: valgrind counts the processor's own loop byte by byte."""

COLUMNS = {
    "mechanism": "mechanism",
    "solves": ("inner steps", ".0f"),
    "count": ("instructions per inner step", ".0f"),
    "point": ("per inner step and point", ".0f"),
    "hand": ("written by hand", ".0f"),
    "ratio": ("times as many", ".1f"),
}
METHOD = (
    "Machine instructions of the process, counted by valgrind --tool=callgrind: difference of two "
    "runs from the initial configuration, one of three times the steps, divided by the difference "
    "of inner steps. Pairs of half steps, 1 ms a pair; mechanisms as above. They do not depend on "
    "what else the machine does. *Written by hand*: the same method, predictor, stopping rule and "
    "compensated sums, but no ledger of energies, in C for this mechanism alone "
    "(benchmarks/measuring/handwritten), compiled with the kernel's flags."
)


def measure(effort: Effort) -> Section:
    rows: list[dict[str, Value]] = []
    remarks, goals = [], []
    if shutil.which("valgrind") is None:
        remarks.append("Not counted: valgrind is not installed on this machine.")
    else:
        for name, (content, points, steps) in mechanisms().items():
            try:
                row = _count(name, content, effort.count(steps, least=2))
            except (RuntimeError, CompilerError) as error:
                remarks.append(f"{name}: not counted: {error}")
                continue
            rows.append({"mechanism": name} | row | {"point": float(row["count"]) / points})
            if row["ratio"] is not None:
                what = f"{name}: instructions over those written by hand"
                goals.append(Goal(what=what, unit="1", goal=LEAST, value=row["ratio"]))
    return Section(
        name="instructions",
        title="Instructions",
        method=METHOD,
        tables=[Table(title="", columns=COLUMNS, rows=rows)] if rows else [],
        goals=goals,
        remarks=remarks,
    )


def mechanisms() -> dict[str, tuple[Content, int, int]]:
    """Content, number of moving points and of steps, by name."""
    return {
        "double pendulum": (hanging_chain(2), 2, 500),
        "four-bar (A02), N = 2": (four_bar(), 3, 200),
        "spatial chain N = 100": (waving_chain(100, 3), 100, 25),
    }


HANDWRITTEN = {
    "double pendulum": ("double_pendulum", 1.0, 1.0, GRAVITY),
    "spatial chain N = 100": ("chain", 0.1, 0.1, 0.0),
}
"""Function, mass [kg] and length [m] of a link, gravity [m/s^2] of those written by hand."""


def _count(name: str, content: Content, steps: int) -> dict[str, float | None]:
    """Instructions of an inner step, ours and those written by hand.

    Raises
    ------
    RuntimeError
        When they cannot be counted, with the reason.
    """
    settings = {"step_size": STEP}
    with tempfile.TemporaryDirectory() as folder:
        model = Path(folder, "model.bin")
        model.write_bytes(solver.assemble(scene(content, **settings)).to_bytes())
        solves, count = _difference(
            ["-m", "benchmarks.measuring.kernel_run", str(model)], steps, folder
        )
        if name not in HANDWRITTEN:
            return {"solves": solves, "count": count, "hand": None, "ratio": None}
        function, *numbers = HANDWRITTEN[name]
        library = by_hand.build(function, Path(folder))
        block = Path(folder, "block.bin")
        block.write_bytes(by_hand.block_of(start(content, **settings), *numbers).tobytes())
        command = [
            "-m",
            "benchmarks.measuring.by_hand",
            str(library),
            function,
            str(block),
            str(STEP),
        ]
        _, hand = _difference(command, steps, folder)
    return {"solves": solves, "count": count, "hand": hand, "ratio": count / hand}


def _difference(arguments: list[str], steps: int, folder: str) -> tuple[float, float]:
    """Implicit solves, and instructions of one.

    Two runs that differ in nothing but the number of steps: their difference holds no start-up, and
    the libraries need no symbols.
    """
    (few, i_few), (many, i_many) = (_run([*arguments, str(n)], folder) for n in (steps, 3 * steps))
    return float(many - few), (i_many - i_few) / (many - few)


def _run(arguments: list[str], folder: str) -> tuple[int, int]:
    """Implicit solves, which the process prints, and its instructions."""
    said, count = counted([sys.executable, *arguments], folder)
    return int(said.split()[-1]), count


def counted(command: Sequence[str], folder: str | Path) -> tuple[str, int]:
    """What a process prints, and its instructions.

    Raises
    ------
    RuntimeError
        When they cannot be counted, with the reason.
    """
    tool = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/counts"]
    run = subprocess.run(
        [*tool, *command],
        capture_output=True,
        text=True,
        check=False,
        cwd=ROOT,
        env=os.environ | {"PYTHONHASHSEED": "0", "GLIBC_TUNABLES": WHOLE_BLOCKS},
    )
    total = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode or total is None:
        reason = run.stderr.strip().rpartition("\n")[2]
        raise RuntimeError(reason or f"valgrind ended with code {run.returncode}")
    return run.stdout, int(total[1])
