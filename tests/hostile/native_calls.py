"""As ``calls``, of FMUs without Python: even numbers are of FMI 2.0, odd ones of FMI 3.0."""

from __future__ import annotations

from pathlib import Path

import fmpy

import solver
from tests.hostile import calls
from tests.support.fmus.native_fmus import native_fmu


def prepare(folder: Path) -> None:
    """Unpack FMUs."""
    model = solver.assemble(solver.loads(calls.SCENE))
    for number, fmi in enumerate((2, 3)):
        fmpy.extract(str(native_fmu(model, fmi)), str(folder / str(number) / "unpacked"))


def case(seed: str, number: int, folder: Path) -> str | None:
    """Make some calls."""
    return calls.case(seed, number, folder / str(number % 2))
