"""An `Fmi2Slave` whose log takes any text, and the sentence for an error."""

from __future__ import annotations

from pythonfmu.enums import Fmi2Status
from pythonfmu.fmi2slave import Fmi2Slave

from solver.runtime import AssemblyError, OptionError, StepError

from .snapshot import SnapshotError
from .status import LOG_CATEGORIES


class LoggedSlave(Fmi2Slave):
    """Slave with one method per severity; the importer chooses what it hears."""

    log_categories = LOG_CATEGORIES

    def note(self, text: str) -> None:
        """Log what is as it should be."""
        self._log(text, Fmi2Status.ok)

    def warn(self, text: str) -> None:
        """Log what works, but not as one might expect."""
        self._log(text, Fmi2Status.warning)

    def discard(self, text: str) -> None:
        """Log why a step was discarded."""
        self._log(text, Fmi2Status.discard)

    def error(self, text: str) -> None:
        """Log what was refused."""
        self._log(text, Fmi2Status.error)

    def _log(self, text: str, level: Fmi2Status) -> None:
        # pythonfmu hands the text to a C function as its printf format, encoded strictly.
        safe = text.encode("utf-8", "replace").decode().replace("%", "%%")
        self.log(safe, level)


def sentence(error: BaseException) -> str:
    """One line for an expected error; for an unexpected one also its type, for the report."""
    if isinstance(error, AssemblyError | OptionError | StepError | SnapshotError):
        return "; ".join(str(error).splitlines())
    return f"fault of this program, please report it: {type(error).__name__}: {error}"
