"""`python -m examples.demo`: the FMU of a four-bar, run in fmpy, against the exact motion.

Problem A02 of the IFToMM multibody benchmark with N = 2 loops: N + 1 cranks and N couplers, uniform
rods of 1 kg and 1 m, which are all in one line twice in every revolution. The cranks stay parallel,
so the exact motion has one degree of freedom, the angle φ of a crank from the vertical:

    I φ'' = W g sin φ,   I = (N+1)/3 + N,   W = (N+1)/2 + N,   φ(0) = 0,   φ'(0) = 1 rad/s

The first run is the FMU's, in fmpy, in a process of its own that knows nothing but the archive. The
second one moves the same mechanism by the augmented-Lagrangian method with the midpoint rule, eq 5
of García Orden & Ortega, which `solver.paper` has.
"""

from __future__ import annotations

import csv
import json
import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu import build
from build_fmu.errors import UsageError
from build_fmu.printing import print_table

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy import ndarray

SCENE = Path(__file__).parents[1] / "scenes" / "four_bar.toml"
LOOPS = 2
GRAVITY = 9.81
STOP_TIME = 10.0
ENERGY_LOST = 0.01
"""Of the largest kinetic energy: the energy itself depends on where heights are counted from."""
PAGE = "four_bar_formulations.html"
RUNS = {"FMU": (), "midpoint rule": ("--formulation", "midpoint-al")}
"""Options of each run, by what it is called."""


def main() -> int:
    """Build, run twice, print the table; exit code 0 if the default method came to the end."""
    if not SCENE.is_file():
        text = f"{SCENE} is missing: the demonstration needs the source tree"
        raise UsageError(text)
    with tempfile.TemporaryDirectory() as folder:
        begin = time.perf_counter()
        fmu = build(SCENE, Path(folder, "four_bar.fmu"))
        sys.stdout.write(
            "scenes/four_bar.toml -> four_bar.fmu in a temporary folder, "
            f"{fmu.stat().st_size / 1e3:.0f} kB, built in {time.perf_counter() - begin:.2f} s\n"
        )
        sys.stdout.write(
            "running it, and then the midpoint rule in NumPy, which takes a minute\n\n"
        )
        sys.stdout.flush()
        runs = [run(fmu, name) for name in RUNS]
        write_page(fmu, runs)
    title = f"two-loop four-bar, {STOP_TIME:g} s: the FMU in fmpy, and the midpoint rule in NumPy"
    print_table(title, ("", *RUNS), table(runs))
    sys.stdout.write(f"{PAGE}: both in motion, side by side; open it in a browser\n\n")
    for name, result in zip(RUNS, runs, strict=True):
        if result["reason"]:
            sys.stdout.write(f"{name}: {result['reason']}\n")
    return 0 if runs[0]["finished"] else 1


def run(fmu: Path, name: str) -> dict:
    """Summary of one run in a clean process, with its largest error against the exact motion."""
    trajectory = fmu.with_name(f"{name}.csv")
    command = [sys.executable, "-m", "build_fmu", "simulate", str(fmu), "--json"]
    command += ["--stop", str(STOP_TIME), "--csv", str(trajectory), *RUNS[name]]
    process = subprocess.run(command, capture_output=True, text=True, check=False)
    if process.returncode not in (0, 3):
        raise UsageError(process.stderr)
    return json.loads(process.stdout) | errors(trajectory)


def write_page(fmu: Path, runs: Sequence[dict]) -> None:
    """Write the page that shows the runs side by side."""
    from build_fmu.reference import columns_of
    from build_fmu.run_page import Carried

    carried, shown = Carried(fmu, str(SCENE)), []
    for name, result in zip(RUNS, runs, strict=True):
        columns = dict(columns_of(fmu.with_name(f"{name}.csv")))
        known = {key: result[key] for key in ("stop_time", "wall_time", "reason")}
        times = columns.pop("time")
        shown.append(carried.report_run(times, columns, {}, "", label=name, **known))
    carried.write(PAGE, shown, compare=True)


def errors(trajectory: Path) -> dict[str, float | None]:
    """Largest distance of B0 from where it should be, m, and when the energy was lost, s."""
    import numpy as np

    with trajectory.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    names = ("time", "B0.x", "B0.y", "energy.total")
    t, x, y, energy = (np.array([float(row[name]) for row in rows]) for name in names)
    phi = exact_angle(t)
    lost = np.flatnonzero(np.abs(energy - energy[0]) > ENERGY_LOST * largest_kinetic_energy())
    return {
        "error": float(np.hypot(x - np.sin(phi), y - np.cos(phi)).max()),
        "lost": float(t[lost[0]]) if lost.size else None,
    }


def largest_kinetic_energy(loops: int = LOOPS) -> float:
    """Return what the bars have as they hang, J: that of the start, and 2 W g of their fall."""
    return ((loops + 1) / 3 + loops) / 2 + ((loops + 1) + 2 * loops) * GRAVITY


def exact_angle(t: Sequence[float] | ndarray, loops: int = LOOPS) -> ndarray:
    """Angle of the cranks from the vertical at the times `t` from 0, rad, to about 1e-10.

    By the classical method of Runge and Kutta, in steps of at most a millisecond.
    """
    import numpy as np

    factor = ((loops + 1) / 2 + loops) * GRAVITY / ((loops + 1) / 3 + loops)
    state, angles = np.array([0.0, 1.0]), []
    for length in np.diff(t, prepend=0.0):
        steps = math.ceil(length * 1000.0)
        for _ in range(steps):
            slope, total = np.zeros(2), np.zeros(2)
            for part, weight in ((0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)):
                angle, rate = state + part * length / steps * slope
                slope = np.array([rate, factor * math.sin(angle)])
                total += weight * slope
            state = state + length / (6.0 * steps) * total
        angles.append(state[0])
    return np.array(angles)


def table(runs: Sequence[dict]) -> list[tuple[str, ...]]:
    """Rows: one quantity each, one column per run."""
    largest = [run["largest"] for run in runs]
    return [
        ("largest energy error", *(f"{each['energy.error']:.1e}" for each in largest)),
        (
            "largest constraint residual",
            *(f"{each['constraint.position']:.1e}" for each in largest),
        ),
        ("largest error against the exact motion", *(f"{run['error']:.1e} m" for run in runs)),
        ("wall time", *(f"{run['wall_time']:.3f} s" for run in runs)),
        ("outcome", *(outcome(run) for run in runs)),
    ]


def outcome(run: dict) -> str:
    """When and how a run failed, if it did."""
    if run["reason"]:
        return f"a step failed at t = {run['end_time']:g} s"
    if run["lost"] is not None:
        joule = ENERGY_LOST * largest_kinetic_energy()
        return f"energy off by {joule:.1f} J, {100 * ENERGY_LOST:g} %, at t = {run['lost']:g} s"
    return "finished"


if __name__ == "__main__":
    try:
        sys.exit(main())
    except UsageError as fault:
        sys.exit(f"demo: {fault}")
