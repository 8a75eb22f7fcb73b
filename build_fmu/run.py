"""One run of an FMU in fmpy, from the archive: trajectory, log, and whether it is a clean one.

`fmpy.simulate_fmu` ends quietly at a discarded step, with success, and says nothing of errors that
the FMU logs on its way. Here both are facts of the result, with the sentence that says why.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np

from build_fmu.errors import UsageError
from build_fmu.fmu_runner import FmuRunner
from build_fmu.instance import description_of, start_time_of
from build_fmu.motion import Poses, largest_by_unit
from build_fmu.reference import Reference
from build_fmu.signals import inputs_of, interpolations_in
from build_fmu.study.settings import Source, entries_of, fmu_settings
from solver.runtime import AssemblyError, OptionError, StepError
from solver.signals import communication_points

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription, ScalarVariable

    from solver.runtime import Model

RECORDED = ("input", "output")
"""What a run collects, by causality."""


@dataclass(frozen=True)
class Run:
    """Result of `run_fmu`."""

    values: np.ndarray
    """Structured array: "time", all outputs, and all inputs as they were given, one row per
    communication point."""
    stop_time: float
    wall_time: float
    """Seconds for unpacking, instantiation and all steps."""
    messages: tuple[str, ...]
    """A note on inputs that begin late, and the FMU's log with status Warning and above."""
    finished: bool
    """Whether it came to its stop time."""
    reason: str
    """Why it ended early, or the first error that the FMU logged; empty if it is a clean run."""
    moved: bool = True
    """Whether any position or orientation changed."""
    largest_by_unit: Mapping[str, float] = field(default_factory=dict)
    """Largest magnitude of what moves, by unit."""
    variables: Sequence[ScalarVariable] = ()
    """What the FMU says of the columns."""

    @property
    def end_time(self) -> float:
        """Time of the last row."""
        return float(self.values["time"][-1])

    @property
    def steps(self) -> int:
        """Number of communication steps that succeeded."""
        return len(self.values) - 1

    @property
    def failure(self) -> str:
        """Where it ended and the reason, in a sentence; empty if it is a clean run."""
        return failure(self.end_time, self.stop_time, self.finished, self.reason)

    def largest(self, name: str) -> float:
        """Largest magnitude of an output over the run."""
        return float(abs(self.values[name]).max())


def run_fmu(
    path: str | PathLike[str],
    *,
    stop_time: float | None = None,
    step_size: float | None = None,
    settings: Source | None = None,
    inputs: Reference | None = None,
    progress: Callable[[float], object] | None = None,
    with_local: bool = False,
    finer: Mapping[str, float] | None = None,
) -> Run:
    """Simulate an FMU from its archive.

    Parameters
    ----------
    path
        The .fmu file.
    stop_time, step_size
        Stop time and communication step in s; None: of the FMU's default experiment.
    settings
        Values of parameters and inputs by name, or a file of them.
    inputs
        Inputs that change during the run: a CSV file with a column "time" and one for each; or by
        name numbers, functions of the time in s, and arrays, with their times as "time". Between
        the times inputs go in straight lines, before and after them they stay; a time that stands
        twice is a jump, where a step ends too. A held input gets its value at the beginning of each
        communication step, a ramped or smooth one, which the FMU's annotations name, that at its
        end: hence a short `step_size`.
    progress
        Called after every communication step with the part of the run that is done, 0 to 1.
    with_local
        Whether to record what is no port of the FMU, too.
    finer
        Settings of the solver that count in place of others, also where they are no ports.

    Raises
    ------
    UsageError
        If the FMU has no variable of a name in `settings` or `inputs`, a value is not of its type,
        its unit or within its limits, or a time makes no sense.
    EnvironmentLackError
        If the FMU has no library for this platform, or the folder for temporary files has a name
        that the library cannot read.
    """
    with contextlib.closing(FmuRunner(path)) as fmu:
        description = fmu.description
        given = inputs_of(inputs)
        entries = {**entries_of(given.held, "inputs"), **entries_of(settings, "settings")}
        start_values = fmu_settings(description, [entries])[0]
        times = communication_times(description, stop_time, step_size)
        signals = given.courses(description, interpolations_in(path), start_values, times)
        variables, names = _recorded(description, with_local)
        begin = time.perf_counter()
        record = fmu.run(
            {**start_values, **(finer or {})}, signals.times, names, signals.sent, progress
        )
        wall_time = time.perf_counter() - begin
    if not len(record.values):
        raise UsageError(record.reason)
    reached = record.values[[k for k in signals.rows if k < len(record.values)]]
    values = np.empty(len(reached), [(name, float) for name in ("time", *names)])
    columns = dict(zip(names, reached.T, strict=True), time=times)
    for name, column in {**columns, **signals.values}.items():  # the FMU has what was set last
        values[name] = column[: len(values)]
    return _run(
        values, variables, times[-1], wall_time, record.reason,
        messages=(*given.notes(times[0]), *signals.remarks, *record.messages),
        finished=len(values) == len(times),
    )  # fmt: skip


def run_by_paper(
    path: str | PathLike[str], model: Model, formulation: str, *, stop_time: float | None = None,
    step_size: float | None = None, settings: Source | None = None, with_local: bool = False,
) -> Run:  # fmt: skip
    """Run the mechanism of an FMU by the method of `solver.paper`, in this process.

    Raises
    ------
    UsageError
        If a setting is wrong, or the mechanism has what this method does not take.
    """
    from solver import simulate

    description = description_of(path)
    variables, names = _recorded(description, with_local)
    values: dict[str, Any] = fmu_settings(description, [entries_of(settings, "settings")])[0]
    reason, stop = "", model.experiment.stop_time if stop_time is None else stop_time
    begin = time.perf_counter()
    try:
        run = simulate(
            model, stop_time=stop, step_size=step_size, parameters=values, outputs=names,
            formulation=formulation,
        )  # fmt: skip
    except StepError as error:
        reason = str(error)
        run: Any = error.trajectory
    except (OptionError, AssemblyError) as error:
        raise UsageError(str(error)) from None
    table = np.empty(len(run.t), [(name, float) for name in ("time", *names)])
    for name in ("time", *names):
        table[name] = run.t if name == "time" else run[name]
    spent = time.perf_counter() - begin
    return _run(table, variables, stop, spent, reason, messages=(), finished=not reason)


def _recorded(description: ModelDescription, with_local: bool) -> tuple[list, list[str]]:
    """Variables that a run collects, and the names of those that are no text."""
    recorded = (*RECORDED, "local") if with_local else RECORDED
    variables = [v for v in description.modelVariables if v.causality in recorded]
    return variables, [v.name for v in variables if v.type != "String"]


def _run(
    values: np.ndarray, variables: Sequence[ScalarVariable], stop_time: float, wall_time: float,
    reason: str, **more: Any,
) -> Run:  # fmt: skip
    """Return a run with what moved in it."""
    names = values.dtype.names or ()
    outputs = {v.name: v.unit for v in variables if v.causality != "input" and v.name in names}
    largest = {name: float(abs(values[name]).max()) for name in outputs}
    poses = Poses(outputs)
    motion = np.reshape([values[name] for name in poses.names], (-1, len(values))).T
    return Run(
        values, stop_time, wall_time, reason=reason, moved=poses.moved(motion),
        largest_by_unit=largest_by_unit(outputs, largest), variables=variables, **more,
    )  # fmt: skip


def failure(end_time: float, stop_time: float, finished: bool, reason: str) -> str:
    """Sentence about a run that is not a clean one; empty without a reason. Times in s."""
    if not reason:
        return ""
    if finished:
        return f"the run came to its end, but the FMU logged an error: {reason}"
    return f"the run ended at t = {end_time!r} s, before {stop_time!r} s: {reason}"


def communication_times(
    description: ModelDescription, stop_time: float | None, step_size: float | None
) -> list[float]:
    """Communication points from start to stop time [s]; the experiment's own where None.

    Raises
    ------
    UsageError
        If they make no sense, or are so many that the run would not come to an end.
    """
    experiment, start = description.defaultExperiment, start_time_of(description)
    chosen = step_size is not None
    if stop_time is None:
        stop_time = float(getattr(experiment, "stopTime", None) or start + 1.0)
    if step_size is None:
        step_size = float(getattr(experiment, "stepSize", None) or (stop_time - start) / 100)
    try:
        times = start, stop_time, step_size
        return communication_points(*times, step_is_chosen=chosen)
    except OptionError as error:
        raise UsageError(str(error)) from None
