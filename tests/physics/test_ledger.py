"""Every joule is booked: the energy ledger closes in every mechanism and under every change.

E = E_0 + work - dissipated, to the tolerance of a step, 1e-12 of the energy that is exchanged.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import solver
from solver.runtime import Integrator
from tests.support.mechanisms.problems import (
    Content,
    move,
    observe,
    start,
    tethered,
    view,
)
from tests.support.mechanisms.random_mechanisms import driven_systems
from tests.support.mechanisms.scene_files import ALL


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_the_ledger_of_every_scene_closes(path):
    # With every input changed from step to step within its limits, no longer than the scene is
    # meant to run, and the tolerance of a step, 1e-12, as measure.
    integrator = Integrator(solver.assemble(solver.load(path)))
    model = integrator.model
    inputs = [v for v in model.variables if v.causality == "input"]
    experiment = model.experiment
    for i in range(min(100, round(experiment.stop_time / experiment.step_size))):
        for variable in inputs:
            size = min(3.0, 0.5 * (variable.maximum or 6.0))
            integrator[variable.name] = size * math.sin(0.7 * i)
        integrator.advance(integrator.time, experiment.step_size)
        assert integrator["energy.error"] < 1e-12
        assert integrator["constraint.position"] < 1e-12
    assert not inputs or integrator["energy.work"] != 0.0


def tuned_spring() -> Content:
    content = tethered({"type": "spring", "stiffness": "k", "free_length": "l"}, gravity=True)
    parameters = {
        "k": {"value": 40.0, "unit": "N/m", "variability": "tunable"},
        "l": {"value": 0.7, "unit": "m", "variability": "tunable"},
    }
    return content | {"parameters": parameters}


def test_a_spring_that_is_tuned_while_it_moves_takes_work():
    # Half the change of stiffness times the square of the stretch, and likewise for the length.
    integrator = start(tuned_spring(), h=0.05)
    move(integrator, 0.05, 20)
    assert integrator["energy.work"] == 0.0
    length = float(np.linalg.norm(view(integrator, "q")[0]))
    before = integrator["energy.total"]
    integrator["k"] = 90.0
    stiffer = 0.5 * 50.0 * (length - 0.7) ** 2
    assert integrator["energy.work"] == pytest.approx(stiffer, rel=1e-12)
    assert integrator["energy.total"] == pytest.approx(before + stiffer, rel=1e-13)
    integrator["l"] = 0.9
    longer = 0.5 * 90.0 * ((length - 0.9) ** 2 - (length - 0.7) ** 2)
    assert integrator["energy.work"] == pytest.approx(stiffer + longer, rel=1e-12)
    move(integrator, 0.05, 50)
    assert integrator["energy.work"] == pytest.approx(stiffer + longer, rel=1e-12)
    assert integrator["energy.error"] < 1e-12


@settings(max_examples=60)
@given(driven_systems(), st.sampled_from([0.005, 0.05]))
def test_the_ledger_of_any_mechanism_closes(content, h):
    names = ["energy.error", "constraint.position", "energy.dissipated"]
    error, constraint, dissipated = observe(start(content, h=h), h, 200, names).T
    assert error.max() < 1e-12
    assert constraint.max() < 1e-12
    assert (np.diff(dissipated) >= 0).all()
