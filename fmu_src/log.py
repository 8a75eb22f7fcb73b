"""The base of the slave: who it is, and a log that takes any text.

pythonfmu hands nothing on to an importer that has not switched the log on, and many end a run at a
discarded step without a word. So warnings, and what is refused or discarded, also go to Python's
own logging, which writes to stderr where the host has not said otherwise.
"""

from __future__ import annotations

from .status import DISCARD, ERROR, LOG_CATEGORIES, LOGGER, OK, WARNING

MOST_TOLD = 20
"""Sentences of an instance that go there: an importer may set a wrong value at every step."""
CATEGORIES = dict(zip((WARNING, DISCARD, ERROR, OK), LOG_CATEGORIES, strict=True))
"""Of what is logged at each level."""


class LogMsg:
    """A message for the importer, with the attributes that pythonfmu's library reads."""

    def __init__(self, status: int, category: str, msg: str) -> None:
        self.status, self.category, self.msg = status, category, msg


class Fmi2Slave:
    """A slave that pythonfmu's library takes for one of its own: it looks for a base of this name.

    pythonfmu's also describes variables in XML, and the modules it imports for this (uuid,
    datetime, xml) take a third of the time in which an FMU is loaded.
    """

    def __init__(self, *, instance_name: str, resources: str | None = None, **_: object) -> None:
        self.instance_name, self.resources = instance_name, resources
        self.log_queue: list[LogMsg] = []
        self._aloud: set[str] = set()

    def _get_log_queue(self) -> list[LogMsg]:
        return self.log_queue

    def note(self, text: str) -> None:
        """Log what is as it should be."""
        self._log(text, OK)

    def warn(self, text: str) -> None:
        """Log what works, but not as one might expect, aloud."""
        self._log(text, WARNING)
        self._say_aloud(text, text, "warning")

    def discard(self, text: str, what: str) -> None:
        """Log why a step was discarded; aloud the first time of each kind, as importers retry."""
        self._log(text, DISCARD)
        self._say_aloud(f"{what} step", text)

    def error(self, text: str) -> None:
        """Log what was refused, aloud."""
        self._log(text, ERROR)
        self._say_aloud(text, text)

    def _log(self, text: str, level: int) -> None:
        # pythonfmu hands the text to a C function as its printf format, encoded strictly.
        self.log_queue.append(LogMsg(level, CATEGORIES[level], _encodable(text).replace("%", "%%")))

    def _say_aloud(self, what: str, text: str, level: str = "error") -> None:
        """Say a sentence to Python's logging, once for each `what`."""
        if what in self._aloud or len(self._aloud) >= MOST_TOLD:
            return
        self._aloud.add(what)
        try:
            import logging  # takes as long as to import all this, and few runs need it

            say = getattr(logging.getLogger(LOGGER), level)
            say("FMU %s: %s", self.instance_name, _encodable(text))
        except Exception:  # of a handler of the host: no exception leaves the slave
            return


def _encodable(text: str) -> str:
    """Text without surrogates, which no stream takes."""
    return text.encode("utf-8", "replace").decode()
