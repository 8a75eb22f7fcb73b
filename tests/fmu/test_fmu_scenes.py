"""Every scene as an FMU: valid, exact in energy and constraints, and the library bit for bit."""

from __future__ import annotations

import json
import math
import random
import re
import xml.etree.ElementTree as ElementTree
import zipfile

import fmpy
import numpy as np
import pytest

import solver
from fmu_src import status
from solver.runtime import Integrator
from tests.fmu.test_picture import pixels
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, Instance, instance, scene_fmu
from tests.support.mechanisms.scene_files import ALL
from viewer.picture import HEIGHT, MARGIN, WIDTH

STEPS = 12
ALL_SCENES = [path.stem for path in ALL]
RAMPED = ["double_wishbone", "stewart"]
STRUCTURED = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*", re.ASCII)
"""Of the names that the standard calls structured (2.2.9), those without arrays and quotes."""


def moved(name: str) -> Integrator:
    """The library's own run of a scene, ready to step."""
    integrator = Integrator(solver.assemble(solver.load(SCENES / f"{name}.toml")))
    integrator.initialise(0.0)
    return integrator


def outputs(integrator: Integrator) -> list:
    variables = enumerate(integrator.model.variables)
    return integrator.get([i for i, v in variables if v.causality == "output"])


def inputs_at(integrator: Integrator, k: int) -> dict[str, float]:
    """Value of each input in step k: its own slow sine, half as large as its limits let it be."""
    inputs = (v for v in integrator.model.variables if v.causality == "input")
    return {
        v.name: 0.5 * (v.maximum or 1.0) * math.sin(0.2 * k * (1 + i)) for i, v in enumerate(inputs)
    }


def drive(fmu: Instance, integrator: Integrator, first: int, last: int) -> None:
    """Move both by the same inputs, from step to step."""
    h = integrator.model.experiment.step_size
    for k in range(first, last):
        for name, value in inputs_at(integrator, k).items():
            integrator[name] = value
            fmu.set(**{name: value})
        integrator.advance(k * h, h)
        assert fmu.step(k * h, h), fmu.log
        assert fmu.outputs() == outputs(integrator)


def follow(fmu: Instance, name: str) -> None:
    """Move the FMU of a scene, elsewhere and back again, by copies or bytes of its state."""
    chance, integrator = random.Random(name), moved(name)
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


# --------------------------------------------------------------------------------- every scene


@pytest.fixture(scope="module", params=ALL_SCENES)
def name(request: pytest.FixtureRequest) -> str:
    """A scene; its tests come one after the other, so that one process builds its FMU."""
    return request.param


def test_the_validator_finds_nothing(name):
    """But for names, each of which takes it 2 ms; they are structured by the test below."""
    path = str(scene_fmu(name))
    fmpy.read_model_description(path, validate=True, validate_model_structure=True)


def test_the_check_passes(capsys, name):
    # Over the scene's own experiment; 1e-11 is the tolerance of a step, 1e-12, with room to add up.
    limits = ("--energy", 1e-11, "--constraint", 1e-12)
    code, out, err = run(capsys, "check", scene_fmu(name), "--json", *limits)
    document = json.loads(out)
    exact = document.get("accuracy", {"is_warning": False})  # none where nothing moves
    said = f"holonom: {exact['sentence']}\n" if exact["is_warning"] else ""
    assert (code, err) == (0, said), out
    assert document["end_time"] == solver.load(SCENES / f"{name}.toml").experiment.stop_time


def test_the_trajectory_is_the_librarys_bit_for_bit_over_saved_states(name):
    with instance(scene_fmu(name)) as fmu:
        follow(fmu, name)


def test_every_variable_has_a_structured_name_a_known_unit_and_a_meaning(name):
    with zipfile.ZipFile(scene_fmu(name)) as archive:
        root = ElementTree.fromstring(archive.read("modelDescription.xml"))
    for unit in root.findall("UnitDefinitions/Unit"):
        assert unit.find("BaseUnit") is not None, unit.get("name")
    for variable in root.findall("ModelVariables/ScalarVariable"):
        assert STRUCTURED.fullmatch(variable.get("name", ""))
        ours = "." in variable.get("name", "")  # else of the scene, which may say nothing
        assert variable.get("description") or not ours
        assert variable.find("Real") is not None or variable.get("causality") == "parameter"


def test_its_page_does_not_say_that_velocities_lag(name):
    """As it does where a driver jumps: tests/physics/test_driver_jumps.py."""
    with zipfile.ZipFile(scene_fmu(name)) as archive:
        assert b"velocities do not follow" not in archive.read("documentation/index.html")


def test_its_picture_fills_the_frame(name):
    scene = solver.load(SCENES / f"{name}.toml")
    with zipfile.ZipFile(scene_fmu(name)) as archive:
        png = archive.read("model.png")
    assert len(png) < 20_000
    seen = pixels(png)
    assert seen.shape == (HEIGHT, WIDTH, 3)
    rows, columns = np.nonzero((seen < 250).any(axis=2))
    if len(scene.points) + len(scene.bodies) == 1 and not scene.joints:
        assert len(rows) > 0  # one place has no size that could fill the frame
        return
    room = (np.ptp(columns) / (WIDTH - 2 * MARGIN), np.ptp(rows) / (HEIGHT - 2 * MARGIN))
    assert max(room) >= 0.9
    assert max(room) <= 1.3  # with what is drawn around a place
    assert len({*map(tuple, seen[rows, columns])}) > 3


# ---------------------------------------------------------------------------------------- ramps


@pytest.mark.parametrize("name", RAMPED)
def test_a_state_saved_in_the_middle_of_a_ramp_repeats_bit_for_bit(name):
    integrator = moved(name)
    h = integrator.model.experiment.step_size
    with instance(scene_fmu(name)) as fmu, instance(scene_fmu(name)) as other:
        fmu.initialise()
        drive(fmu, integrator, 0, 5)
        target = inputs_at(integrator, 7)
        fmu.set(**target)  # they are to arrive there at the end of a step that is not yet done
        state = fmu.fmu.getFMUState()
        data = fmu.fmu.serializeFMUState(state)
        expected = fmu.run(5 * h, h, 4)
        fmu.fmu.setFMUState(state)
        assert [fmu.get(each) for each in target] == list(target.values())
        assert fmu.run(5 * h, h, 4) == expected
        other.fmu.setFMUState(other.fmu.deserializeFMUState(data))
        assert other.run(5 * h, h, 4) == expected
        # A shorter step after the rollback ramps to the same value, sooner.
        fmu.fmu.setFMUState(state)
        fmu.run(5 * h, h / 2, 2)
        assert fmu.get("energy.error") < 1e-11
        fmu.fmu.freeFMUState(state)


# ------------------------------------------------------------------------------------- settings


def test_what_the_inputs_contradict_is_closed_only_where_that_is_asked_for():
    # A leg that is 0.1 m longer than drawn.
    with instance(scene_fmu("stewart")) as fmu:
        fmu.initialise(leg1=0.1, solver__assemble=False)
        assert not fmu.step(0.0, 0.02)
        assert fmu.get("solver.status") == status.ASSEMBLY_FAILED
        assert "driver 'drive1'" in fmu.log[-1][2]
        fmu.fmu.reset()
        fmu.initialise(leg1=0.1, solver__assemble=True)
        assert fmu.get("constraint.position") < 1e-12
        assert fmu.get("platform.z") > 1.2 + 1e-3
        assert fmu.step(0.0, 0.02)


def test_an_fmu_can_begin_in_its_equilibrium():
    # 0.0981 m below the end of the spring, as m g/k says, and it stays there.
    with instance(scene_fmu("spring_pendulum")) as fmu:
        fmu.initialise(solver__start="equilibrium")
        for k in range(20):
            assert fmu.get("A.z") == pytest.approx(-0.9981, abs=1e-9)
            assert fmu.step(0.1 * k, 0.1)
