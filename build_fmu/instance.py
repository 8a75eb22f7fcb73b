"""An instance of an FMU in fmpy: unpacked, checked, and with a log of its own.

fmpy's logger serves one instance of a process: with several, each message arrives at the one that
was made last, and what it does not format, where it has no library for the machine, keeps the
doubled per cent signs of the FMU. Here each instance has callbacks of its own.
"""

from __future__ import annotations

import contextlib
import logging
import signal
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from os import PathLike, fspath
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any

from build_fmu.archive_check import require_whole
from build_fmu.errors import EnvironmentLackError, UsageError
from fmu_src.interrupt_guard import takes_signals
from fmu_src.status import DISCARD, ERROR, LOGGER, WARNING
from solver.files import writing

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription

    from build_fmu.fmpy_slaves import FMU2Run, FMU3Run

LOADING = threading.Lock()
"""Held while fmpy loads a library: it takes the whole process to the folder of it and back."""

_is_read = ContextVar("_is_read", default=False)
"""Whether this thread reads the log of the FMU that it calls."""
logging.getLogger(LOGGER).addFilter(lambda _: not _is_read.get())


@contextlib.contextmanager
def not_said_twice() -> Iterator[None]:
    """Keep the FMUs that this thread calls from saying aloud what their log has: it is read."""
    token = _is_read.set(True)
    try:
        yield
    finally:
        _is_read.reset(token)


_is_taken, _depth = False, 0
_struck: list[int] = []
"""Whether Ctrl-C is answered here, in how many blocks that hold it back, and what was held."""


def _strike(number: int, frame: FrameType | None) -> None:
    if _depth:
        _struck.append(number)
    # An FMU that is written in Python takes it there, within a long step, and refuses that step.
    if not _depth or (frame and frame.f_code.co_name == takes_signals.__name__):
        raise KeyboardInterrupt


def _pass_interrupts() -> None:
    if _struck:
        _struck.clear()
        raise KeyboardInterrupt


def _is_main() -> bool:
    return threading.current_thread() is threading.main_thread()


@contextlib.contextmanager
def interrupts_taken() -> Iterator[None]:
    """Answer Ctrl-C here, as Python does: `interrupts_held` then takes a tenth of the time."""
    global _is_taken
    mine = _is_main() and signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if not mine:  # another thread has it, or nobody, or it is taken
        yield
        return
    signal.signal(signal.SIGINT, _strike)
    _is_taken = True
    try:
        yield
    finally:
        _is_taken = False
        signal.signal(signal.SIGINT, signal.default_int_handler)


@contextlib.contextmanager
def interrupts_held() -> Iterator[Callable[[], None]]:
    """Hold Ctrl-C back until the function that this yields is called, or the end.

    An FMU that is written in Python would take the exception for a failure of its own.
    """
    global _depth
    if not _is_main():
        yield lambda: None
        return
    with contextlib.nullcontext() if _is_taken else interrupts_taken():
        _depth += 1
        try:
            yield _pass_interrupts
        finally:
            _depth -= 1
            if not _depth:
                _pass_interrupts()


class Log:
    """What an instance said: sentences with status Warning and above."""

    def __init__(self) -> None:
        self._lines: list[tuple[int, str]] = []

    def clear(self) -> None:
        """Forget what was said."""
        self._lines.clear()

    @property
    def messages(self) -> tuple[str, ...]:
        """All sentences."""
        return tuple(text for _, text in self._lines)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences that are no more than a warning."""
        return tuple(text for level, text in self._lines if level == WARNING)

    @property
    def error(self) -> str:
        """First sentence about an error; empty if there is none."""
        return next((text for level, text in self._lines if level >= ERROR), "")

    def reason(self, failure: str = "") -> str:
        """Last sentence about a refusal: why a run ended; else `failure`, if it has one."""
        severe = [text for level, text in self._lines if level >= DISCARD]
        return severe[-1] if severe else failure or "the FMU ended the run without a message"

    def callbacks(self) -> Any:
        """Functions for fmi2Instantiate, which write here."""
        from fmpy import fmi2

        callbacks = fmi2.fmi2CallbackFunctions()
        callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(self._hear)
        callbacks.allocateMemory = fmi2.fmi2CallbackAllocateMemoryTYPE(fmi2.calloc)
        callbacks.freeMemory = fmi2.fmi2CallbackFreeMemoryTYPE(fmi2.free)
        return callbacks

    def _hear(self, _environment: Any, _name: Any, level: int, kind: Any, message: bytes) -> None:
        # A format of printf. None of our FMUs asks for arguments, and ctypes could give none.
        self.hear(_environment, level, kind, message.replace(b"%%", b"%"))

    def hear(self, _environment: Any, level: int, _kind: Any, message: bytes) -> None:
        """Take a sentence, as FMI 3.0 hands it on."""
        if level >= WARNING:
            self._lines.append((level, message.decode("utf-8", "replace")))


def unpacked(
    path: str | PathLike[str], parent: str | None = None
) -> tempfile.TemporaryDirectory[str]:
    """Temporary folder with the files of an FMU, below `parent` or that for temporary files.

    Raises
    ------
    EnvironmentLackError
        If the FMU has no library for this platform, or the folder for temporary files has a name
        that the library cannot read.
    OSError
        With the folder, if it cannot be written, as where the disk is full.
    """
    import fmpy

    check_platform(fspath(path))
    check_unpack_folder(Path(parent or tempfile.gettempdir()))
    folder = tempfile.TemporaryDirectory(prefix="fmu-", dir=parent, ignore_cleanup_errors=True)
    try:
        with writing(folder.name):
            fmpy.extract(fspath(path), folder.name)
    except BaseException:
        folder.cleanup()
        raise
    return folder


def instantiated(description: ModelDescription, folder: str, log: Log) -> FMU2Run | FMU3Run:
    """Instance of an unpacked FMU, which logs to `log`.

    Raises
    ------
    UsageError
        If it cannot be made.
    """
    from build_fmu.fmpy_slaves import FMU2Run, FMU3Run

    unit = description.coSimulation
    assert unit is not None
    try:
        with LOADING:
            fmu = (FMU3Run if description.fmiVersion == "3.0" else FMU2Run)(
                guid=description.guid,
                unzipDirectory=folder,
                modelIdentifier=unit.modelIdentifier,
                instanceName=unit.modelIdentifier,
            )
        fmu.make(log)
    except Exception as error:  # fmpy raises a bare Exception
        reason = " ".join(log.reason(str(error)).split())
        text = (
            f"{unit.modelIdentifier} cannot be instantiated: {reason}; if the archive is damaged, "
            "build it again"
        )
        raise UsageError(text) from None
    return fmu


def description_of(path: str | PathLike[str]) -> ModelDescription:
    """Model description of an FMU that can be run here: whole, FMI 2.0, co-simulation.

    Raises
    ------
    UsageError
        If it is another file, or its archive or its model description is damaged.
    """
    import fmpy

    require_whole(path)
    try:
        description = fmpy.read_model_description(fspath(path))
    except Exception as error:  # whatever lxml and fmpy raise on a text that is no description
        first = (str(error).splitlines() or [type(error).__name__])[:2][-1].removeprefix("- ")
        text = f"{fspath(path)}: modelDescription.xml is not one that FMI allows ({first})"
        raise UsageError(text) from None
    if description.fmiVersion not in ("2.0", "3.0") or description.coSimulation is None:
        text = f"{fspath(path)}: not an FMI 2.0 or 3.0 co-simulation unit"
        raise UsageError(text)
    return _in_words_of_fmi2(description)


def _in_words_of_fmi2(description: ModelDescription) -> ModelDescription:
    """Give variables of FMI 3.0 the types of FMI 2.0, and leave out the time."""
    known = [v for v in description.modelVariables if v.causality != "independent"]
    for variable in known:
        if variable.type == "Float64":
            variable.type = "Real"
    description.modelVariables = known
    return description


def start_time_of(description: ModelDescription) -> float:
    """Start time of the default experiment, in s."""
    return float(getattr(description.defaultExperiment, "startTime", None) or 0.0)


def check_platform(path: str) -> None:
    """Refuse an FMU that has no library for this machine."""
    from fmpy import platform, platform_tuple, supported_platforms

    from build_fmu.package import package_of

    # FMI 3.0 has other names
    if not {platform, platform_tuple} & {*supported_platforms(path)}:
        text = f"{path} has no library for this platform, {platform}"
        if package_of(path)["sources"]:
            text += f"; compile its sources: fmpy compile {path}"
        raise EnvironmentLackError(text)


def check_unpack_folder(folder: Path) -> None:
    """Refuse a folder below which an FMU would end the process: its library decodes %20 alone."""
    wrong = "%" in folder.absolute().as_uri().replace("%20", "")
    if wrong:
        text = (
            f"the folder for temporary files, {folder}, has a character in its path that "
            "pythonfmu's library cannot read; set TMPDIR to a folder of plain letters"
        )
        raise EnvironmentLackError(text)
