"""Many runs of one FMU and many FMUs of one scene: how many a second."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import build_fmu
from benchmarks.measuring.effort import Effort
from benchmarks.measuring.processes import children_cpu
from benchmarks.pages.report import Goal, Section, Table, Value
from build_fmu.run import run_fmu
from build_fmu.study.engines import processors

SCENE = Path(__file__).resolve().parents[2] / "scenes" / "four_bar.toml"
RUNS, FMUS, ALONE = 1000, 200, 20
STOP_TIME = 10.0
OUTPUTS = ["B0.x", "energy.error"]
RUNS_A_SECOND, FMUS_A_SECOND = 300.0, 20.0
REPETITIONS = 3

Work = tuple[str, int, Callable[[], None]]
"""What it is, how many there are, and all of them."""

COLUMNS = {
    "what": "what",
    "count": ("number", ".0f"),
    "wall": ("wall, s", ".2f"),
    "cpu": ("CPU of all processes, s", ".2f"),
    "each": ("CPU of each, ms", ".1f"),
    "rate": ("a second (wall)", ".0f"),
}


def measure(effort: Effort) -> Section:
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        rows = [
            _timed(what, count, work, effort)
            for what, count, work in (*_runs(Path(name), effort), *_fmus(Path(name), effort))
        ]
    return Section(
        name="sweeps",
        title="Many runs, many FMUs",
        method=(
            f"The two-loop four-bar. A run is {STOP_TIME:g} s in 200 communication steps with two "
            "outputs read at each; loading the FMU and starting processes are counted. FMUs "
            "after the first of the process, each with a trial run and its parameter set. The "
            f"least of {REPETITIONS} repetitions, by wall time; {processors()} processors."
        ),
        tables=[Table(title="Together", columns=COLUMNS, rows=rows)],
        goals=[
            _goal(f"a run of a sweep of {RUNS} over {STOP_TIME:g} s", RUNS_A_SECOND, rows[2]),
            _goal("an FMU of variants, after the first", FMUS_A_SECOND, rows[4]),
        ],
    )


def _runs(folder: Path, effort: Effort) -> list[Work]:
    """Runs of one FMU: one by one as fmpy does it, and as sweeps."""
    count = effort.count(RUNS, 4)
    drive = [-0.5 + i / count for i in range(count)]
    fmu = build_fmu.build(SCENE, folder / "four_bar.fmu")

    def sweep(engine: str) -> None:
        build_fmu.sweep(
            fmu, grid={"drive": drive}, outputs=OUTPUTS, stop_time=STOP_TIME, engine=engine
        )

    def one_by_one() -> None:
        for value in drive[:ALONE]:
            run_fmu(fmu, stop_time=STOP_TIME, settings={"drive": value})

    return [
        ("runs, each by fmpy.simulate_fmu", min(ALONE, count), one_by_one),
        ("runs, sweep --engine serial", count, lambda: sweep("serial")),
        ("runs, sweep", count, lambda: sweep("auto")),
    ]


def _fmus(folder: Path, effort: Effort) -> list[Work]:
    """FMUs of one scene."""
    count = effort.count(FMUS, 2)
    mass = [1.0 + i / count for i in range(count)]

    def variants(engine: str) -> None:
        build_fmu.variants(SCENE, folder / "v", grid={"bodies.crank0.mass": mass}, engine=engine)

    return [
        ("FMUs, variants --engine serial", count, lambda: variants("serial")),
        ("FMUs, variants", count, lambda: variants("auto")),
    ]


def _timed(what: str, count: int, work: Callable[[], object], effort: Effort) -> dict[str, Value]:
    """Least wall time of several repetitions, and the CPU time of that one."""
    times = []
    for _ in range(min(effort.repetitions, REPETITIONS)):
        cpu, begin = _cpu(), time.perf_counter()
        work()
        times.append((time.perf_counter() - begin, _cpu() - cpu))
    wall, cpu = min(times)
    return {
        "what": what,
        "count": float(count),
        "wall": wall,
        "cpu": cpu,
        "each": 1e3 * cpu / count,
        "rate": count / wall,
    }


def _cpu() -> float:
    return time.process_time() + (children_cpu() or 0.0)


def _goal(what: str, rate: float, row: dict[str, Value]) -> Goal:
    """Wall time of one, in ms."""
    wall, count = row["wall"], row["count"]
    assert isinstance(wall, float)
    assert isinstance(count, float)
    return Goal(what=f"wall time of {what}", unit="ms", goal=1e3 / rate, value=1e3 * wall / count)
