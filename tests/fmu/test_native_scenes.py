"""Scenes as native FMUs, of FMI 2.0 and 3.0: the library bit for bit, and valid."""

from __future__ import annotations

import numpy as np
import pytest
from fmpy.validation import validate_fmu

from build_fmu.fmu_runner import FmuRunner
from tests.fmu.test_fmu_scenes import STEPS, follow, inputs_at, moved
from tests.support.fmus.fmu_instance import instance
from tests.support.fmus.native_fmus import native_scene_fmu

OF_EACH_KIND = ["double_wishbone", "jansen_with_clearance", "pendulum", "die_in_a_bowl"]
"""Ramped inputs, contacts, all types of variables; each of the four libraries."""


@pytest.mark.parametrize("name", OF_EACH_KIND)
def test_a_native_fmu_is_the_library_bit_for_bit_over_saved_states(name):
    """FMUs with Python have the same libraries, and are tried with all scenes."""
    with instance(native_scene_fmu(name)) as fmu:
        follow(fmu, name)


@pytest.mark.parametrize("name", OF_EACH_KIND)
def test_fmi_3_gives_what_fmi_2_gives(name):
    """The layer of FMI 3 knows no scene: what it hands on to are the libraries of FMI 2."""
    both = [FmuRunner(native_scene_fmu(name, fmi)) for fmi in (2, 3)]
    integrator = moved(name)
    h = integrator.model.experiment.step_size
    times = [k * h for k in range(STEPS)]
    driven = [inputs_at(integrator, k) for k in range(STEPS)]
    inputs = {n: np.array([values[n] for values in driven]) for n in driven[0]}
    names = [v.name for v in integrator.model.variables if v.type == "Real"]
    found = [fmu.run({}, times, names, inputs) for fmu in both]
    for fmu in both:
        fmu.close()
    assert [record.reason for record in found] == ["", ""]
    assert np.array_equal(*(record.values for record in found))


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", OF_EACH_KIND)
def test_the_validator_finds_nothing_in_a_native_fmu(name, fmi):
    assert validate_fmu(str(native_scene_fmu(name, fmi))) == []
