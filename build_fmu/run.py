"""One run of an FMU in fmpy, from the archive: trajectory, log, and whether it came to its end.

`fmpy.simulate_fmu` ends quietly at a discarded step, with success. Here an early end is a fact of
the result, with the sentence of the FMU's log that says why.
"""

from __future__ import annotations

import contextlib
import logging
import math
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study.settings import Source, entries_of, fmu_settings
from fmu_src.status import LOGGER

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription
    from fmpy.simulation import Recorder
    from numpy import ndarray

DISCARD, ERROR = 2, 3  # fmi2Status
INSTANTIATION_FAILED = "Failed to instantiate model"
MOST_STEPS = 10_000_000
"""Most communication steps of a run: all rows are kept in memory until its end."""


@dataclass(frozen=True)
class Run:
    """Result of `run_fmu`."""

    values: ndarray
    """Structured array: "time" and every output, one row per communication point."""
    stop_time: float
    wall_time: float
    """Seconds for unpacking, instantiation and all steps."""
    messages: tuple[str, ...]
    """Lines of the FMU's log with status Warning and above."""
    reason: str
    """Why the run ended early; empty if it did not."""

    @property
    def end_time(self) -> float:
        """Time of the last row."""
        return float(self.values["time"][-1])

    @property
    def steps(self) -> int:
        """Number of communication steps that succeeded."""
        return len({float(t) for t in self.values["time"]}) - 1

    def largest(self, name: str) -> float:
        """Largest magnitude of an output over the run."""
        return float(abs(self.values[name]).max())


def run_fmu(
    path: str | PathLike[str],
    *,
    stop_time: float | None = None,
    step_size: float | None = None,
    settings: Source | None = None,
    progress: Callable[[float], object] | None = None,
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
    progress
        Called after every communication step with the part of the run that is done, 0 to 1.

    Raises
    ------
    UsageError
        If the FMU has no variable of a name in `settings`, a value is not of its type, its unit or
        within its limits, or a time makes no sense.
    EnvironmentLackError
        If the FMU has no library for this platform, or the folder for temporary files has a name
        that the library cannot read.
    """
    import fmpy

    description = fmpy.read_model_description(fspath(path), validate=False)
    check_platform(fspath(path))
    check_unpack_folder(Path(tempfile.gettempdir()))
    start_values = fmu_settings(fspath(path), description, [entries_of(settings)])[0]
    stop_time, step_size = experiment_times(description, stop_time, step_size)
    log: list[tuple[int, str]] = []
    begin = time.perf_counter()
    values, failure = _simulate(
        fspath(path),
        model_description=description,
        stop_time=stop_time,
        output_interval=step_size,
        start_values=start_values,
        debug_logging=True,
        logger=lambda *entry: log.append((entry[2], entry[4].decode("utf-8", "replace"))),
        step_finished=_reporter(progress, stop_time),
    )
    wall_time = time.perf_counter() - begin
    messages = tuple(text for level, text in log if level > 0)
    finished = values is not None and values["time"][-1] >= stop_time - 1e-6 * step_size
    reason = "" if finished else _reason(log, failure)
    if values is None:
        raise UsageError(reason)
    return Run(values, stop_time, wall_time, messages, reason)


def check_unpack_folder(folder: Path) -> None:
    """Refuse a folder below which an FMU would end the process: its library decodes %20 alone."""
    wrong = "%" in folder.absolute().as_uri().replace("%20", "")
    if wrong:
        text = (
            f"the folder for temporary files, {folder}, has a character in its path that "
            "pythonfmu's library cannot read; set TMPDIR to a folder of plain letters"
        )
        raise EnvironmentLackError(text)


def _reporter(progress: Callable[[float], object] | None, stop_time: float) -> Callable | None:
    if progress is None:
        return None

    def step_finished(now: float, recorder: Recorder) -> bool:
        start = recorder.rows[0][0]
        progress((now - start) / (stop_time - start))
        return True

    return step_finished


def _simulate(path: str, **options) -> tuple[ndarray | None, str]:
    """Result of fmpy, None with a text if an FMI function returned an error."""
    import fmpy
    from fmpy.fmi1 import FMICallException

    try:
        with not_said_twice():
            return fmpy.simulate_fmu(path, **options), ""
    except FMICallException as error:
        return None, str(error)
    except Exception as error:
        if str(error) != INSTANTIATION_FAILED:  # fmpy raises a bare Exception
            raise
        return None, f"{path} cannot be instantiated: is the archive damaged? Build it again"


@contextlib.contextmanager
def not_said_twice() -> Iterator[None]:
    """Keep the FMU from saying aloud what its log has: the log is read here."""
    logger = logging.getLogger(LOGGER)
    before, logger.disabled = logger.disabled, True
    try:
        yield
    finally:
        logger.disabled = before


def _reason(log: list[tuple[int, str]], failure: str) -> str:
    """Last sentence that the FMU logged about a refusal."""
    severe = [text for level, text in log if level >= DISCARD]
    return severe[-1] if severe else failure or "the FMU ended the simulation without a message"


def check_platform(path: str) -> None:
    """Refuse an FMU that has no library for this machine."""
    from fmpy import platform, supported_platforms

    if platform not in supported_platforms(path):
        text = f"{path} has no library for this platform, {platform}"
        raise EnvironmentLackError(text)


def experiment_times(
    description: ModelDescription, stop_time: float | None, step_size: float | None
) -> tuple[float, float]:
    """Stop time and communication step, checked: a run must come to an end."""
    experiment = description.defaultExperiment
    start = float(getattr(experiment, "startTime", None) or 0.0)
    if stop_time is None:
        stop_time = float(getattr(experiment, "stopTime", None) or start + 1.0)
    if not (math.isfinite(stop_time) and stop_time > start):
        text = f"the stop time must be after the start time {start!r} s, got {stop_time!r}"
        raise UsageError(text)
    if step_size is None:
        step_size = float(getattr(experiment, "stepSize", None) or (stop_time - start) / 100)
    if not (math.isfinite(step_size) and step_size > 0.0):
        text = f"the communication step must be > 0 s, got {step_size!r}"
        raise UsageError(text)
    steps = (stop_time - start) / step_size
    if steps > MOST_STEPS:
        text = (
            f"{stop_time - start:g} s in steps of {step_size:g} s are {steps:.3g} communication "
            f"steps, more than the {MOST_STEPS:g} of one run; take a longer step"
        )
        raise UsageError(text)
    return stop_time, step_size
