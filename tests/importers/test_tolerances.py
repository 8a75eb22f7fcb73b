"""One FMU in three hosts: libcosimpy, fmpy and, by tests/fmu/test_c_host.py, one in C."""

from __future__ import annotations

from pathlib import Path

import fmpy
import pytest

from tests.fmu.test_c_host import FINER, POINT, POINTS, SWINGS, in_fmpy
from tests.importers.tools import drive, need
from tests.support.fmus.fmu_instance import text_fmu

WATCH = ("B.x", "rope.force")


def in_libcosimpy(path: Path, **parameters: float) -> list[list[float]]:
    """Outputs after each step, with an input of 1, 2, 3, ...; libcosim passes no tolerance."""
    variables = fmpy.read_model_description(str(path)).modelVariables
    job = {
        "fmus": {"a": str(path)},
        "links": [],
        "references": {"a": {v.name: v.valueReference for v in variables}},
        "parameters": {"a": parameters},
        "pushed": [("a", "push")],
        "h": POINT,
        "steps": POINTS,
        "watch": [("a", name) for name in WATCH],
    }
    return drive(need("libcosimpy"), job)


@pytest.mark.parametrize("scene", SWINGS)
@pytest.mark.parametrize("is_native", [False, True], ids=["python", "native"])
@pytest.mark.parametrize("tolerance", [None, FINER])
def test_an_fmu_moves_in_libcosimpy_as_in_fmpy_bit_for_bit(scene, is_native, tolerance):
    path = text_fmu(SWINGS[scene], native=is_native)
    given = {} if tolerance is None else {"solver.tolerance": tolerance}
    here = [in_fmpy(path, "push", name, POINT, POINTS, tolerance) for name in WATCH]
    assert in_libcosimpy(path, **given) == [list(row) for row in zip(*here, strict=True)]
