"""What is imported when it is asked for: modules that take long, and packages that few need."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Sequence
from typing import Any


def from_homes(
    package: str, names: Sequence[str], homes: Sequence[str]
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return `__getattr__` and `__dir__` of a package whose names are in other modules.

    These are imported in turn, when a name is asked for, until one has it.
    """

    def found(name: str) -> Any:
        for home in map(importlib.import_module, homes if name in names else ()):
            if hasattr(home, name):
                return getattr(home, name)
        message = f"module {package!r} has no attribute {name!r}"
        raise AttributeError(message)

    return found, lambda: sorted(names)


def missing(package: str, extra: str) -> str:
    """Sentence about a package that is not installed, and the extra that has it; empty if it is."""
    if importlib.util.find_spec(package) is not None:
        return ""
    return f"the package {package} is missing; install it: pip install 'holonom[{extra}]'"


def imported(package: str, extra: str) -> Any:
    """Return a package.

    Raises
    ------
    ModuleNotFoundError
        If it is not installed; the sentence says how to get it.
    """
    if text := missing(package, extra):
        raise ModuleNotFoundError(text, name=package)
    return importlib.import_module(package)
