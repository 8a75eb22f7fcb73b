"""Which engine moves a model: the compiled kernel, or its NumPy reference."""

from __future__ import annotations

from .errors import OptionError
from .kernel import Kernel
from .model import Model

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from .engine import Engine


def engine_for(model: Model, kernel: str) -> Engine:
    """Bind a model to the compiled kernel, or, in tests, to the NumPy reference.

    Raises
    ------
    OptionError
        When there is no such kernel.
    KernelMissingError
        When no compiled kernel fits this platform, or it belongs to another version.
    """
    if kernel not in ("auto", "c", "numpy"):
        message = f"kernel: must be auto, c or numpy, got {kernel!r}"
        raise OptionError(message)
    if kernel != "numpy":
        return Kernel(model)
    from .reference import Reference  # no part of an archive; NumPy is imported here alone

    return Reference(model)
