"""Models and states of an earlier commit, recorded in tests/recorded/of_before: refused.

They are of the pendulum after 0.05 s, by the first commit that was headed 1.0.0 in CHANGELOG.
"""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

import solver
from build_fmu.instance import Log
from solver.runtime import Integrator, Model, OptionError
from tests.support.fmus.fmu_instance import SCENES, instance, packed
from tests.support.fmus.native_fmus import native_scene_fmu, slave_of_fmi3

FOLDER = Path(__file__).parents[1] / "recorded" / "of_before"


def recorded(kind: str) -> bytes:
    return (FOLDER / f"pendulum.{kind}").read_bytes()


def test_python_refuses_a_model_of_before():
    with pytest.raises(ValueError, match="of another version of holonom; build it again"):
        Model.from_bytes(recorded("model"))


def test_a_native_library_refuses_a_model_of_before(tmp_path):
    with zipfile.ZipFile(native_scene_fmu("pendulum", 3)) as archive:
        entries = {name: archive.read(name) for name in archive.namelist()}
    fmu = tmp_path / "old.fmu"
    fmu.write_bytes(packed(entries | {"resources/model.bin": recorded("model")}))
    log = Log()
    with pytest.raises(Exception, match="instantiate"):
        slave_of_fmi3(fmu, str(tmp_path), log)
    sentence = "the model cannot be used: it is of another version of holonom; build it again"
    assert log.messages == (sentence,)


def test_a_run_refuses_a_state_of_before_and_goes_on():
    run = Integrator(solver.assemble(solver.load(SCENES / "pendulum.toml")))
    run.initialise(0.0)
    before = run.save()
    with pytest.raises(OptionError, match="saved state belongs to another model or version"):
        run.restore(recorded("state"))
    assert run.save() == before
    run.advance(0.0, 0.01)


def test_a_native_fmu_refuses_a_state_of_before_and_goes_on():
    with instance(native_scene_fmu("pendulum")) as fmu:
        fmu.initialise()
        with pytest.raises(Exception, match="fmi2DeSerializeFMUstate failed with status 3"):
            fmu.fmu.deserializeFMUState(recorded("fmu_state"))
        assert len(fmu.log[-1][2]) > 20
        assert "save" in fmu.log[-1][2]
        assert fmu.step(0.0, 0.01)
