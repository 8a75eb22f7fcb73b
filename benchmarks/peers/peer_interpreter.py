"""The interpreter that has other codes, and programs run by it in processes of their own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

VARIABLE = "EXUDYN_PYTHON"
"""Names the interpreter; without it, it is this one."""
PATIENCE = 120.0
"""Seconds after which an interpreter that only tells what it has is stopped."""
ROOM = 120
"""Characters of what an interpreter said last that a row of a table has room for."""

ASK = """
import json, sys
from importlib.metadata import PackageNotFoundError, version
def ask(name):
    try:
        return version(name)
    except PackageNotFoundError:
        return None
print()
print(json.dumps([ask(name) for name in sys.argv[1:]]))
"""


class InterpreterError(Exception):
    """The interpreter gave no answer; the text is what it said last, or how it ended."""


@dataclass(frozen=True, slots=True)
class Packages:
    """What the interpreter has of some packages."""

    versions: Mapping[str, str] = field(default_factory=dict)
    """Version of each package that is installed."""
    failure: str = ""
    """What the interpreter said last where it could not tell: then nothing is known."""

    def absence(self, package: str) -> str:
        """Why there is nothing of a package; empty if it is there."""
        if self.failure:
            return f"its interpreter failed: {self.failure}"
        return "" if package in self.versions else "not installed"


def packages_there(packages: Sequence[str], variable: str = VARIABLE) -> Packages:
    """Ask the interpreter that a variable names for the versions of packages."""
    try:
        versions = answer(["-c", ASK, *packages], patience=PATIENCE, variable=variable)
    except InterpreterError as error:
        return Packages(failure=str(error))
    told = zip(packages, versions, strict=True)
    return Packages({package: version for package, version in told if version})


def remarks(packages: Packages, codes: Mapping[str, str], variable: str = VARIABLE) -> list[str]:
    """A sentence about each code, given the names of their packages."""
    absences = [packages.absence(package) for package in codes.values()]
    sentences = [
        f"{code}: not measured: {absence}" if absence else f"{code} {packages.versions[package]}"
        for (code, package), absence in zip(codes.items(), absences, strict=True)
    ]
    if any(absences):
        what = "the extra `benchmarks`" if variable == VARIABLE else " and ".join(codes)
        sentences.append(f"`{variable}` may name an interpreter that has {what}.")
    return sentences


def answer(
    arguments: Sequence[str],
    request: object = None,
    *,
    patience: float | None = None,
    environment: Mapping[str, str] | None = None,
    variable: str = VARIABLE,
) -> Any:
    """Run Python with arguments and a request in JSON; what its last line says in JSON.

    The interpreter is the one that the environment variable names, or else this one.

    Raises
    ------
    InterpreterError
        Where there is no such answer, after `patience` seconds at the latest.
    """
    try:
        run = subprocess.run(
            [os.environ.get(variable, sys.executable), *arguments],
            input=json.dumps(request),
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            timeout=patience,
            cwd=Path(__file__).resolve().parents[2],
            # Exudyn's compiled module without range checks is the faster one.
            env={**os.environ, **(environment or {}), "EXUDYN_MODULE": "fast"},
        )
    except subprocess.TimeoutExpired:
        text = f"no end within {patience:g} s"
        raise InterpreterError(text) from None
    except OSError as error:
        text = f"it cannot be started: {error.strerror}"
        raise InterpreterError(text) from None
    if run.returncode:
        raise InterpreterError(_last_line(run.stderr)[:ROOM] or f"ended with code {run.returncode}")
    said = _last_line(run.stdout)
    try:
        return json.loads(said)
    except json.JSONDecodeError:
        text = f"no answer, but {said[:ROOM]!r}" if said else "no answer"
        raise InterpreterError(text) from None


def _last_line(text: str) -> str:
    return text.strip().rpartition("\n")[2]
