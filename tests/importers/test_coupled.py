"""Each importer couples the FMUs of examples/ as one of our schemes does, to round-off.

Those with Python and native ones; ours are the results of those with Python.
"""

from __future__ import annotations

import functools
import tempfile
from pathlib import Path

import fmpy
import numpy as np
import pytest

from examples import __main__ as examples
from examples import couple
from examples.unit import open_units
from tests.importers.tools import drive, need

H, STEPS = 0.005, 200
LINKS = [
    (name, f"{point}.{axis}", "spring", f"{end}{axis}")
    for name, (point, end) in couple.ENDS.items()
    for axis in "xy"
] + [
    ("spring", f"on_{end}_{axis}", name, f"pull_{axis}")
    for name, (_, end) in couple.ENDS.items()
    for axis in "xy"
]
WATCH = [(name, f"{couple.ENDS[name][0]}.{axis}") for name in couple.MECHANISMS for axis in "xy"]
_FOLDER = tempfile.TemporaryDirectory(prefix="importers-", ignore_cleanup_errors=True)


KINDS = pytest.mark.parametrize("native", [False, True], ids=["python", "native"])


@functools.cache
def fmus(native: bool = False) -> dict[str, Path]:
    folder = Path(_FOLDER.name, "native" if native else "python")
    return examples.build_coupled(folder, native=native)


@functools.cache
def ours(scheme: str, steps: int = STEPS) -> np.ndarray:
    """Positions after each step, m."""
    with open_units(fmus()) as units:
        return np.array(couple.run_coupled(units, couple.SCHEMES[scheme], H, steps).positions[1:])


@functools.cache
def start_values() -> dict[str, dict[str, float]]:
    """What the inputs are before the first step."""
    values: dict[str, dict[str, float]] = {name: {} for name in fmus()}
    with open_units(fmus()) as units:
        for unit in units.values():
            unit.start()
        for source, output, target, input_ in LINKS:
            values[target][input_] = units[source][output]
    return values


def theirs(name: str, scheme: str = "parallel", native: bool = False) -> np.ndarray:
    """Positions after each step, m, in an importer."""
    tool = need(name)
    paths = {name: str(path) for name, path in fmus(native).items()}
    descriptions = {name: fmpy.read_model_description(path) for name, path in paths.items()}
    references = {
        name: {v.name: v.valueReference for v in description.modelVariables}
        for name, description in descriptions.items()
    }
    job = {
        "fmus": paths,
        "links": LINKS,
        "references": references,
        "start": start_values(),
        "h": H,
        "steps": STEPS,
        "watch": WATCH,
        "scheme": scheme,
    }
    return np.array(drive(tool, job))


@KINDS
@pytest.mark.parametrize("name", ["libcosimpy", "ecospy", "cofmupy"])
def test_an_importer_that_steps_all_at_once_is_our_parallel_scheme(name, native):
    # They add t up in other ways, and its last digit is a length of a step, 1e-16 s.
    assert theirs(name, native=native) == pytest.approx(ours("parallel"), abs=1e-12)


@KINDS
@pytest.mark.parametrize("scheme", ["parallel", "sequential"])
def test_a_container_of_fmus_steps_them_bit_for_bit_as_we_do(scheme, native):
    assert np.array_equal(theirs("fmu-manipulation-toolbox", scheme, native), ours(scheme))


@KINDS
def test_pathsim_is_our_sequential_scheme_one_step_ahead(native):
    found = theirs("pathsim-fmi", native=native)
    assert found == pytest.approx(ours("sequential", STEPS + 1)[1:], abs=1e-12)


def test_cofmupys_gauss_seidel_is_closer_to_the_conserving_scheme_than_its_jacobi():
    conserving = ours("conserving")
    parallel, sequential = (
        np.abs(theirs("cofmupy", scheme) - conserving).max()
        for scheme in ("parallel", "sequential")
    )
    assert sequential < 0.75 * parallel
