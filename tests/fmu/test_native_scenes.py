"""Every scene as a native FMU, of FMI 2.0 and 3.0: the library bit for bit, and valid."""

from __future__ import annotations

import random

import numpy as np
import pytest
from fmpy.validation import validate_fmu

from build_fmu.fmu_runner import FmuRunner
from solver.runtime import Integrator
from tests.fmu.test_fmu_scenes import ALL_SCENES, drive, inputs_at, moved, outputs
from tests.fmu_instance import Instance, instance
from tests.native_fmus import native_scene_fmu

STEPS = 12
OF_EACH_KIND = ["double_wishbone", "jansen_with_clearance", "pendulum", "die_in_a_bowl"]
"""Ramped inputs, contacts, all types of variables; each of the four libraries."""


@pytest.mark.parametrize("name", ALL_SCENES)
def test_a_native_fmu_is_the_library_bit_for_bit_over_saved_states(name):
    """Inputs change at each step; the FMU goes elsewhere and comes back, by copy or by bytes."""
    chance, integrator = random.Random(name), moved(name)
    with instance(native_scene_fmu(name)) as fmu:
        fmu.initialise()
        assert fmu.outputs() == outputs(integrator)
        for first in range(0, STEPS, 3):
            drive(fmu, integrator, first, first + 3)
            saved = fmu.fmu.getFMUstate()
            if chance.random() < 0.5:
                saved = fmu.fmu.deserializeFMUState(fmu.fmu.serializeFMUState(saved))
            before = fmu.outputs()
            stray(fmu, integrator, first + 3)
            fmu.fmu.setFMUState(saved)
            fmu.fmu.freeFMUState(saved)
            assert fmu.outputs() == before


def stray(fmu: Instance, integrator: Integrator, k: int) -> None:
    """Take the FMU elsewhere."""
    h = integrator.model.experiment.step_size
    fmu.set(**{name: 0.9 * x for name, x in inputs_at(integrator, k + 7).items()})
    assert fmu.step(k * h, h)
    assert fmu.step((k + 1) * h, 0.5 * h)


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
