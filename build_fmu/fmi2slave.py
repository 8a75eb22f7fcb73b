"""The half of pythonfmu's `Fmi2Slave` that a running instance needs: who it is, and its log.

It travels in place of the whole: that also describes variables in XML, and the modules it imports
for this (uuid, datetime, xml) take a third of the time in which an FMU is loaded. The library of
pythonfmu knows the class by its name.
"""

from __future__ import annotations

from pythonfmu.enums import Fmi2Status
from pythonfmu.logmsg import LogMsg

TYPE_CHECKING = False  # typing would take a tenth of the time to import all this
if TYPE_CHECKING:
    from typing import Any


class Fmi2Slave:
    """Base of slaves; the methods that pythonfmu's library calls are those of the derived class."""

    log_categories: dict[str, str] = {}  # noqa: RUF012 - as in pythonfmu

    def __init__(self, **kwargs: Any) -> None:
        self.instance_name = kwargs["instance_name"]
        self.resources = kwargs.get("resources")
        self.visible = kwargs.get("visible", False)
        self.log_queue: list[LogMsg] = []

    def _get_log_queue(self) -> list[LogMsg]:
        return self.log_queue

    def log(
        self, msg: str, status: Fmi2Status = Fmi2Status.ok, category: str | None = None
    ) -> None:
        """Queue a message, in the category of its status unless one is given."""
        if category is None:
            category = f"logStatus{status.name.capitalize()}"
            if category not in self.log_categories:
                category = "logAll"
        self.log_queue.append(LogMsg(status, category, msg))
