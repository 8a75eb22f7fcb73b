"""What the FMU adds: time of doStep above the kernel's, of building, of loading."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import fmpy
from fmpy.fmi2 import FMU2Slave

import solver
from benchmarks.measuring.effort import Effort
from benchmarks.measuring.first_step import PARTS
from benchmarks.measuring.processes import Durations, build_times, first_step_times
from benchmarks.measuring.timing import Entry, Times, interleave
from benchmarks.pages.report import Goal, Section, Table, Value
from build_fmu import build
from solver.runtime import Integrator
from tests.support.kernel.kernel_calls import kernel_of

if TYPE_CHECKING:
    from solver.scene import Scene

SCENES = Path(__file__).resolve().parents[2] / "scenes"
NAMES = ("double_pendulum", "four_bar", "chain")
STEP = 1e-3
INTERNAL = 10
"""Internal steps (pairs) of a communication step."""

COUNT = 500
OVERHEAD, BUILD, LOAD = 15.0, 1.5, 0.3

COLUMNS = {
    "scene": "scene",
    "step": ("doStep, µs", ".1f"),
    "library": ("Integrator.advance, µs", ".1f"),
    "kernel": ("kernel alone, µs", ".1f"),
    "above": ("doStep above the kernel, µs", ".1f"),
    "outputs": ("number of outputs", ".0f"),
    "read": ("getReal of all outputs, µs", ".1f"),
    "noise": ("noise of doStep", ".2f"),
}
PART_COLUMNS = {
    "part": "part",
    "cpu": ("CPU, s", ".3f"),
    "wall": ("wall, s", ".3f"),
    "noise": ("noise of CPU", ".2f"),
}


def measure(effort: Effort) -> Section:
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        folder = Path(name)
        steps = [_steps(scene, folder, effort) for scene in NAMES]
        fmu = build(SCENES / "four_bar.toml", folder / "timed.fmu")
        building = build_times(SCENES / "four_bar.toml", folder / "built.fmu", effort)
        loading = first_step_times(fmu, effort)
    after_import = _sum([loading[part] for part in PARTS[1:]])
    parts = [
        _part("holonom build, new process", building["new process"]),
        _part("build_fmu.build, in a process that has built before", building["same process"]),
        *(_part(f"first step: {part}", times) for part, times in loading.items()),
        _part("first step: all but Python's start and importing fmpy", after_import),
    ]
    return Section(
        name="fmu",
        title="In the FMU",
        method=(
            f"One doStep of fmpy's FMU2Slave with {INTERNAL} internal steps (pairs) of 1 ms, "
            f"{COUNT} of them from the same saved state in each repetition, in turn with the same "
            "steps in the library and in the kernel alone. Building and loading: the four-bar; a "
            "new process each time, a new unpack folder each time, files in the system's cache."
        ),
        tables=[
            Table(title="A communication step", columns=COLUMNS, rows=steps),
            Table(title="Building and loading", columns=PART_COLUMNS, rows=parts),
        ],
        goals=_goals(steps[0], building["new process"], after_import),
    )


def _goals(steps: dict[str, Value], building: Durations, loading: Durations) -> list[Goal]:
    what = f"doStep of {INTERNAL} internal steps above the kernel, double pendulum"
    return [
        Goal.of_row(what, OVERHEAD, steps, "above"),
        *(
            Goal(what=f"{what}, CPU", unit="s", goal=goal, value=cpu.minimum, noise=cpu.noise)
            for what, goal, cpu in (
                ("build of an FMU in a new process", BUILD, building.cpu),
                ("load and first step in fmpy, after importing fmpy", LOAD, loading.cpu),
            )
        ),
    ]


def _part(name: str, times: Durations) -> dict[str, Value]:
    cpu, wall = times
    return {"part": name, "cpu": cpu.minimum, "wall": wall.minimum, "noise": cpu.noise}


def _sum(parts: list[Durations]) -> Durations:
    clocks = zip(*parts, strict=True)
    sums = (map(sum, zip(*(part.seconds for part in clock), strict=True)) for clock in clocks)
    return Durations(*(Times(tuple(each)) for each in sums))


def started(path: Path, folder: Path | str, description: Any, slave: type[Any]) -> Any:
    """Slave of fmpy for an FMU, which is unpacked into a folder, at the start of its run."""
    fmpy.extract(str(path), str(folder))
    assert description.coSimulation is not None
    fmu = slave(
        guid=description.guid,
        unzipDirectory=str(folder),
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="timed",
    )
    fmu.instantiate()
    if slave is FMU2Slave:
        fmu.setupExperiment(startTime=0.0)
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    return fmu


class Running:
    """An instance in fmpy that repeats the same communication steps."""

    def __init__(self, path: Path, folder: Path) -> None:
        description = fmpy.read_model_description(str(path))
        outputs = [v for v in description.modelVariables if v.causality == "output"]
        self.outputs = [variable.valueReference for variable in outputs]
        self.fmu = started(path, folder, description, FMU2Slave)
        self.fmu.doStep(0.0, INTERNAL * STEP)
        self._state = self.fmu.getFMUState()

    def restore(self) -> None:
        """Return to the time after the first communication step."""
        self.fmu.setFMUState(self._state)

    def close(self) -> None:
        """Free the instance, which holds the unpack folder."""
        self.fmu.freeFMUState(self._state)
        self.fmu.terminate()
        self.fmu.freeInstance()


def _steps(name: str, folder: Path, effort: Effort) -> dict[str, Value]:
    scene = solver.load(SCENES / f"{name}.toml", {"solver.step_size": STEP})
    running = Running(build(scene, folder / f"{name}.fmu"), folder / name)
    times = interleave(_entries(running, scene, effort.count(COUNT)), effort)
    count = effort.count(COUNT)
    micro = {key: 1e6 * value.minimum / count for key, value in times.items()}
    running.close()
    return {
        "scene": name,
        **micro,
        "above": micro["step"] - micro["kernel"],
        "outputs": float(len(running.outputs)),
        "noise": times["step"].noise,
    }


def _entries(running: Running, scene: Scene, count: int) -> dict[str, Entry]:
    """Loops over the same communication steps on the three levels, and over reading outputs."""
    integrator = Integrator(solver.assemble(scene))
    h = INTERNAL * STEP
    times = [i * h for i in range(1, count + 1)]
    integrator.advance(0.0, h)
    state = integrator.save()
    fmu, engine, outputs = running.fmu, kernel_of(integrator), running.outputs

    def step() -> None:
        for t in times:
            fmu.doStep(t, h)

    def library() -> None:
        for t in times:
            integrator.advance(t, h)

    def kernel() -> None:
        for _ in times:
            engine.advance(h)

    def read() -> None:
        for _ in times:
            fmu.getReal(outputs)

    def restore() -> None:
        integrator.restore(state)

    return {
        "step": Entry(step, running.restore),
        "library": Entry(library, restore),
        "kernel": Entry(kernel, restore),
        "read": Entry(read),
    }
