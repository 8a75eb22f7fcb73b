"""The base of the slave: who it is, and a log that takes any text.

pythonfmu hands nothing on to an importer that has not switched the log on, and many end a run at a
discarded step without a word. So warnings, and what is refused or discarded, also go to Python's
own logging, which writes to stderr where the host has not said otherwise.
"""

from __future__ import annotations

from types import SimpleNamespace

from .status import DISCARD, ERROR, LOG_CATEGORIES, LOGGER, OK, WARNING

MOST_TOLD = 20
"""Sentences of an instance that go there: an importer may set a wrong value at every step."""
CATEGORIES = dict(zip((WARNING, DISCARD, ERROR, OK), LOG_CATEGORIES, strict=True))
"""Of what is logged at each level."""


class Fmi2Slave:
    """A slave that pythonfmu's library takes for one of its own: it looks for a base of this name.

    pythonfmu's also describes variables in XML, and the modules it imports for this (uuid,
    datetime, xml) take a third of the time in which an FMU is loaded.
    """

    def __init__(self, *, instance_name: str, resources: str | None = None, **_: object) -> None:
        self.instance_name, self.resources = instance_name, resources
        self.log_queue: list[SimpleNamespace] = []
        self._aloud: set[str] = set()

    def _get_log_queue(self) -> list[SimpleNamespace]:
        return self.log_queue

    def say(self, text: str, level: int, what: str = "") -> None:
        """Log a text; where it is no mere note also aloud, once for each `what`.

        That is the text itself where left out. Importers retry, and the reasons differ.
        """
        text = text.encode("utf-8", "replace").decode()  # no stream takes surrogates
        # pythonfmu hands the text to a C function as its printf format.
        line = text.replace("%", "%%")
        self.log_queue.append(SimpleNamespace(status=level, category=CATEGORIES[level], msg=line))
        what = what or text
        if level == OK or what in self._aloud or len(self._aloud) >= MOST_TOLD:
            return
        self._aloud.add(what)
        try:
            import logging  # takes as long as to import all this, and few runs need it

            severity = logging.WARNING if level == WARNING else logging.ERROR
            logging.getLogger(LOGGER).log(severity, "FMU %s: %s", self.instance_name, text)
        except Exception:  # of a handler of the host: no exception leaves the slave
            return
