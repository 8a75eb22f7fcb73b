"""Packages that few uses need; each is an extra of the installation."""

from __future__ import annotations

import importlib.util
from typing import Any


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
