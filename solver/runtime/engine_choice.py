"""Which engine moves a model: the compiled kernel, or its NumPy reference."""

from __future__ import annotations

from collections.abc import Callable

from .errors import OptionError, tell
from .kernel import Kernel, KernelMissingError
from .model import Model

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from .engine import Engine


def engine_for(model: Model, kernel: str, log: Callable[[str], None] | None) -> Engine:
    """Bind a model to the compiled kernel, or to the NumPy reference.

    That the reference steps in is said in the log, or in a warning if there is none.

    Raises
    ------
    OptionError
        When there is no such kernel.
    KernelMissingError
        When `kernel` is "c" and it was not built, or belongs to another version.
    """
    if kernel not in ("auto", "c", "numpy"):
        message = f"kernel: must be auto, c or numpy, got {kernel!r}"
        raise OptionError(message)
    if kernel != "numpy":
        try:
            return Kernel(model)
        except KernelMissingError as missing:
            if kernel == "c":
                raise
            slower = f"{missing}; the NumPy reference replaces it, some hundred times slower"
            tell(log, slower)
    from .reference import Reference  # NumPy is imported here and nowhere else

    return Reference(model)
