"""One odd call of FMI 2.0 by ctypes, in a process of its own, as the library may end it.

python -m tests.support.fmus.odd_calls CALL FOLDER

FOLDER is that of an unpacked FMU of a pendulum. Prints the answer in one line.
"""

from __future__ import annotations

import ctypes
import math
import os
import sys
from collections.abc import Callable
from pathlib import Path

from fmpy import fmi2

REFERENCES, TEXTS = ctypes.c_uint * 1, ctypes.c_char_p * 1
FATAL = 4
NO_LOGGER = ctypes.cast(None, fmi2.fmi2CallbackLoggerTYPE)


class Host:
    """Library of an unpacked FMU, and what it logs."""

    def __init__(self, folder: Path) -> None:
        self.library = ctypes.CDLL(str(next(folder.glob("binaries/linux64/*.so"))))
        self.resources = (folder / "resources").as_uri().encode()
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        self.heard: list[str] = []
        self.callbacks = fmi2.fmi2CallbackFunctions()
        self.callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(self._hear)

    def named(self, start: bytes) -> bytes:
        """URI of the resources that begins otherwise."""
        return self.resources.replace(b"file:///", start)

    def _hear(self, _environment, _name, _status, _category, message: bytes) -> None:
        self.heard.append(message.decode())

    def instance(
        self,
        name: bytes | None = b"a",
        kind: int = 1,
        guid: bytes | None = b"guid",
        resources: bytes | None = b"",
        callbacks: object | None = b"",
    ) -> ctypes.c_void_p:
        """What fmi2Instantiate answers."""
        made = self.library.fmi2Instantiate(
            name,
            kind,
            guid,
            self.resources if resources == b"" else resources,
            ctypes.byref(self.callbacks) if callbacks == b"" else callbacks,
            0,
            1,
        )
        return ctypes.c_void_p(made)

    def made(self, **arguments: object) -> str:
        """Whether there is an instance."""
        made = self.instance(**arguments)  # type: ignore[arg-type]
        return "an instance" if made.value else f"none: {' '.join(self.heard)}"

    def stepping(self) -> ctypes.c_void_p:
        """Return an instance at the end of its initialization."""
        made = self.instance()
        start = (ctypes.c_double(2.0), 0, ctypes.c_double())
        self.library.fmi2SetupExperiment(made, 0, ctypes.c_double(), *start)
        self.library.fmi2EnterInitializationMode(made)
        self.library.fmi2ExitInitializationMode(made)
        return made

    def last_successful_time(self) -> str:
        """What fmi2GetRealStatus answers before the first step."""
        time = ctypes.c_double()
        self.library.fmi2GetRealStatus(self.stepping(), 2, ctypes.byref(time))
        return "nan" if math.isnan(time.value) else repr(time.value)

    def without_logger(self) -> str:
        """What a refused step does where there is no logger."""
        self.callbacks.logger = NO_LOGGER
        return str(self.step(self.stepping(), -1.0))

    def step(self, made: ctypes.c_void_p, size: float) -> int:
        """Status of fmi2DoStep at 2 s."""
        return self.library.fmi2DoStep(made, ctypes.c_double(2.0), ctypes.c_double(size), 1)

    def text(self, text: bytes | None) -> str:
        """Status of fmi2SetString, and of the next step."""
        made = self.stepping()
        status = self.library.fmi2SetString(made, REFERENCES(), ctypes.c_size_t(1), TEXTS(text))
        return "fatal" if status == FATAL else f"{status}, {self.step(made, 0.1)}"

    def category(self) -> str:
        """Status of fmi2SetDebugLogging with a category that does not exist."""
        names = TEXTS(b"nonsense")
        return str(self.library.fmi2SetDebugLogging(self.stepping(), 1, ctypes.c_size_t(1), names))


CALLS: dict[str, Callable[[Host], str]] = {
    "model exchange": lambda host: host.made(kind=0),
    "empty name": lambda host: host.made(name=b""),
    "name NULL": lambda host: host.made(name=None),
    "name not UTF-8": lambda host: host.made(name=b"\xff\xfe"),
    "GUID NULL": lambda host: host.made(guid=None),
    "resources NULL": lambda host: host.made(resources=None),
    "no such resources": lambda host: host.made(resources=b"file:///nowhere/resources"),
    "resources file:/path": lambda host: host.made(resources=host.named(b"file:/")),
    "resources file://localhost/path": lambda host: host.made(
        resources=host.named(b"file://localhost/")
    ),
    "resources FILE:///path": lambda host: host.made(resources=host.named(b"FILE:///")),
    "callbacks NULL": lambda host: host.made(callbacks=None),
    "logger NULL": Host.without_logger,
    "text NULL": lambda host: host.text(None),
    "text not UTF-8": lambda host: host.text(b"\xff\xfe"),
    "unknown log category": Host.category,
    "last successful time": Host.last_successful_time,
}

if __name__ == "__main__":
    sys.stdout.write(CALLS[sys.argv[1]](Host(Path(sys.argv[2]))))
    sys.stdout.flush()
    os._exit(0)
