"""What a native FMU adds to the steps of its mechanism: calls in C and in fmpy, runs of sweeps."""

from __future__ import annotations

import functools
import shutil
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave

import solver
from benchmarks.measuring.effort import Effort
from benchmarks.measuring.processes import printed
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.sections.fmu import started
from benchmarks.sections.instructions import counted
from build_fmu import build, sweep
from build_fmu.platforms import SCOPES, library_scope
from build_kernel.compiler import CompilerError, Kind, any_compiler, compile_library, includes

ROOT = Path(__file__).resolve().parents[2]
SCENES = ("double_pendulum", "four_bar", "bricard", "pendulum_with_stop", "flyball_governor")
STEP = 1e-3
"""Communication step in s: short, so that what is beyond the steps is seen."""
SWEPT = {"double_pendulum": "mass", "four_bar": "drive"}
"""Scenes of sweeps, and what is varied there, by so little that all runs take equally long."""
STEPS, READ, RUNS, BATCH, ROUNDS = 200, 8, 200, 20, 5
BEYOND_IN_C, BEYOND_IN_FMPY, GET, COPY, INSTANCE = 0.5, 2.0, 0.15, 1.0, 0.5
MORE_IN_A_SWEEP = 1.1

CALLS = {
    "scene": "scene",
    "core": ("holonom_advance in C, µs", ".2f"),
    "c": ("fmi2DoStep in C, µs", ".2f"),
    "beyond": ("beyond, µs", ".2f"),
    "instructions": ("beyond, instructions", ".0f"),
    "fmi2": ("beyond in fmpy, FMI 2.0, µs", ".2f"),
    "fmi3": ("beyond in fmpy, FMI 3.0, µs", ".2f"),
}
OTHERS = {
    "scene": "scene",
    "model": ("model, kB", ".0f"),
    "get": (f"fmi2GetReal of {READ}, µs", ".3f"),
    "copy": ("fmi2GetFMUstate, µs", ".3f"),
    "instance": ("fmi2Instantiate and free, ms", ".3f"),
}
SWEEPS = {
    "scene": "scene",
    "outputs": ("outputs", ".0f"),
    "c": ("host in C, ms", ".3f"),
    "memory": ("sweep, ms", ".3f"),
    "ratio": ("ratio", ".3f"),
    "file": ("sweep into a .csv, ms", ".3f"),
    "file_ratio": ("ratio", ".3f"),
}


def measure(effort: Effort) -> Section:
    remarks, calls, others, sweeps = [], [], [], []
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        try:
            chosen = SCENES[: effort.repetitions]  # fewer for a quick look
            fmus = [_unpacked(scene, Path(name)) for scene in chosen]
        except (CompilerError, RuntimeError) as error:
            remarks.append(f"Not measured: {error}")
            fmus = []
        if not shutil.which("valgrind"):
            remarks.append("Instructions are not counted: valgrind is not installed.")
        for fmu in fmus:
            found = _times(fmu, effort)
            calls.append(_call_row(fmu, found, effort))
            others.append(_other_row(fmu, found))
            if fmu.scene in SWEPT:
                sweeps += _sweeps(fmu, effort)
    return Section(
        name="native",
        title="In native FMUs",
        method=(
            f"A host in C loads the library of the FMU, and the core alone, compiled from the same "
            f"sources with the same flags. Both take the same {STEPS} communication steps of "
            f"{STEP:g} s in turn, from the same state, and come to the same bits; fmpy takes them "
            "in a loop of FMU2Slave.doStep and FMU3Slave.doStep. Instructions are those of the "
            f"process by callgrind, as below. A run: from the reset to the end of the scene's "
            f"experiment, with outputs after each step; mean of {BATCH} runs, the least of all, "
            f"in {ROUNDS} processes for the host and {ROUNDS} sweeps in turn."
        ),
        tables=[
            Table(title="A communication step", columns=CALLS, rows=calls),
            Table(title="Other calls in C", columns=OTHERS, rows=others),
            Table(title="A run in a sweep", columns=SWEEPS, rows=sweeps),
        ],
        goals=[
            # Of longer steps the noise is longer than what is beyond them.
            _goal("doStep beyond the steps in C, worst", "µs", BEYOND_IN_C, calls[:2], "beyond"),
            _goal("doStep beyond those in fmpy, worst", "µs", BEYOND_IN_FMPY, calls[:2], "fmi2"),
            _goal(f"fmi2GetReal of {READ} in C, worst", "µs", GET, others, "get"),
            _goal("fmi2GetFMUstate, worst", "µs", COPY, others, "copy"),
            _goal("instantiate a model of 120 kB", "ms", INSTANCE, others, "instance"),
            _goal("a run in a sweep over one in C, worst", "1", MORE_IN_A_SWEEP, sweeps, "ratio"),
            _goal("the same, into a .csv, worst", "1", MORE_IN_A_SWEEP, sweeps, "file_ratio"),
        ],
        remarks=remarks,
    )  # fmt: skip


def _goal(what: str, unit: str, goal: float, rows: list[dict[str, Value]], key: str) -> Goal:
    values = [float(row[key] or 0.0) for row in rows]
    return Goal(what=what, unit=unit, goal=goal, value=max(values) if values else None)


class Unpacked(NamedTuple):
    """A native FMU of a scene, for both versions of the standard, and what is compiled for it."""

    scene: str
    paths: dict[int, Path]
    folder: Path
    """Where that of FMI 2.0 is unpacked."""
    description: Any
    step: float
    model: int
    """Bytes."""
    kernel: Path
    host: Path

    @property
    def outputs(self) -> list[int]:
        """Value references."""
        variables = self.description.modelVariables
        return [v.valueReference for v in variables if v.causality == "output"]


def _unpacked(name: str, folder: Path) -> Unpacked:
    scene = solver.load(ROOT / "scenes" / f"{name}.toml")
    fmi2, fmi3 = (
        build(scene, folder / f"{name}_{v}.fmu", native=True, fmi=v) for v in (2, 3)
    )  # fmt: skip
    fmpy.extract(str(fmi2), str(folder / name))
    sizes = solver.assemble(scene).sizes
    kind = Kind(sizes["dim"], library_scope(sizes))
    return Unpacked(
        name, {2: fmi2, 3: fmi3}, folder / name, fmpy.read_model_description(str(fmi2)),
        scene.experiment.step_size, Path(folder, name, "resources/model.bin").stat().st_size,
        *_compiled(kind, folder),
    )  # fmt: skip


@functools.cache
def _compiled(kind: Kind, folder: Path) -> tuple[Path, Path]:
    """The core alone, and the host in C.

    Raises
    ------
    CompilerError
        Where there is no compiler.
    RuntimeError
        Where the host does not compile: it is for Unix.
    """
    compiler = any_compiler()
    sources, name = ROOT / "solver/kernel", f"{kind.dimension}_{kind.scope}"
    kernel, host = folder / f"kernel_{name}.so", folder / f"host_{name}"
    compile_library(compiler, sources, kind, kernel)
    include = f"-I{ROOT / 'fmu_src/native'}", *includes(sources)
    macros = f"-DDIM={kind.dimension}", f"-DHM_SCOPE={SCOPES.index(kind.scope)}"
    program = str(ROOT / "benchmarks/sections/native_calls.c"), "-o", str(host), "-ldl"
    printed([*compiler, "-std=c99", "-O2", *include, *macros, *program])
    return kernel, host


def _command(
    fmu: Unpacked, step: float, count: int, repetitions: int, what: str, read: list[int]
) -> list[str]:
    library = next(fmu.folder.glob("binaries/*/*"))
    places = str(library), str(fmu.folder / "resources"), fmu.description.guid, str(fmu.kernel)
    numbers = repr(step), str(count), str(repetitions), what, *map(str, read)
    return [str(fmu.host), *places, *numbers]


def _in_c(*arguments: Any) -> dict[str, float]:
    """Seconds by the letters of native_calls.c; arguments as of ``_command``."""
    lines = printed(_command(*arguments)).splitlines()
    return {key: float(value) for key, value in map(str.split, lines)}


def _times(fmu: Unpacked, effort: Effort) -> dict[str, float]:
    """Seconds of one call."""
    count, repetitions = effort.count(STEPS, 3), 10 * effort.repetitions
    found = _in_c(fmu, STEP, count, repetitions, "dags", fmu.outputs[:READ])
    times = {key: value / count for key, value in found.items()}
    for version, slave in ((2, FMU2Slave), (3, FMU3Slave)):
        times[f"fmi{version}"] = _in_fmpy(fmu.paths[version], slave, count, repetitions)
    return times | {"i": _in_c(fmu, STEP, 10, effort.repetitions, "i", [])["i"] / 10}


def _call_row(fmu: Unpacked, found: dict[str, float], effort: Effort) -> dict[str, Value]:
    micro = {key: 1e6 * value for key, value in found.items()}
    return {
        "scene": fmu.scene, "core": micro["a"], "c": micro["d"],
        "beyond": micro["d"] - micro["a"], "instructions": _instructions(fmu, effort),
        "fmi2": micro["fmi2"] - micro["a"], "fmi3": micro["fmi3"] - micro["a"],
    }  # fmt: skip


def _other_row(fmu: Unpacked, found: dict[str, float]) -> dict[str, Value]:
    return {
        "scene": fmu.scene, "model": 1e-3 * fmu.model, "get": 1e6 * found["g"],
        "copy": 1e6 * found["s"], "instance": 1e3 * found["i"],
    }  # fmt: skip


def _instructions(fmu: Unpacked, effort: Effort) -> float | None:
    """Instructions of fmi2DoStep beyond those of holonom_advance."""
    if not shutil.which("valgrind"):
        return None
    few = effort.count(STEPS, 3)
    numbers = [
        counted(_command(fmu, STEP, count, 1, what, []), fmu.folder)[1]
        for what in "da"
        for count in (3 * few, few)
    ]
    return (numbers[0] - numbers[1] - numbers[2] + numbers[3]) / (2 * few)


def _in_fmpy(path: Path, slave: type[Any], count: int, repetitions: int) -> float:
    """Least seconds of a doStep of fmpy's slave."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        fmu = started(path, folder, fmpy.read_model_description(str(path)), slave)
        fmu.doStep(0.0, STEP)
        state, times = fmu.getFMUState(), [k * STEP for k in range(1, count + 1)]
        least = float("inf")
        for _ in range(repetitions):
            fmu.setFMUState(state)
            begin = time.process_time()
            for t in times:
                fmu.doStep(t, STEP)
            least = min(least, time.process_time() - begin)
        fmu.freeInstance()
    return least / count


# ------------------------------------------------------------------------------------------ sweeps


def _sweeps(fmu: Unpacked, effort: Effort) -> Iterator[dict[str, Value]]:
    """Runs with all outputs, and with two."""
    by_name = {v.name: v.valueReference for v in fmu.description.modelVariables}
    names = [name for name, reference in by_name.items() if reference in fmu.outputs]
    steps = round(float(fmu.description.defaultExperiment.stopTime) / fmu.step)
    runs = max(2 * BATCH, effort.count(RUNS))
    for outputs in (names, [names[0], "energy.error"]):
        read = [by_name[name] for name in outputs]
        rounds = [
            (
                _in_c(fmu, fmu.step, steps, runs // BATCH, "r", read)["r"] / BATCH,
                _run_of_a_sweep(fmu, outputs, runs, None),
                _run_of_a_sweep(fmu, outputs, runs, fmu.folder / "runs.csv"),
            )
            for _ in range(min(effort.repetitions, ROUNDS))
        ]
        c, memory, file = (1e3 * min(times) for times in zip(*rounds, strict=True))
        yield {
            "scene": fmu.scene, "outputs": float(len(outputs)), "c": c, "memory": memory,
            "ratio": memory / c, "file": file, "file_ratio": file / c,
        }  # fmt: skip


def _run_of_a_sweep(fmu: Unpacked, outputs: list[str], runs: int, path: Path | None) -> float:
    """Seconds of a run, without what the sweep does once."""
    varied = SWEPT[fmu.scene]
    start = next(float(v.start) for v in fmu.description.modelVariables if v.name == varied)
    values = [start + 1e-9 * k for k in range(runs)]
    stamps: list[float] = []
    sweep(
        fmu.paths[2], grid={varied: values}, outputs=outputs,
        engine="serial", path=path, fresh=True,
        progress=lambda _done, _count: stamps.append(time.process_time()),
    )  # fmt: skip
    return float(np.diff(stamps[::BATCH]).min()) / BATCH
