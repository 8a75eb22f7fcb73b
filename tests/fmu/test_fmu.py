"""FMUs in fmpy: the same numbers as the library, values that take effect, exact states."""

from __future__ import annotations

import pytest

from tests.support.fmus.fmu_instance import instance, pendulum, scene_fmu

# ------------------------------------------------------------------------- values take effect


def test_outputs_are_valid_in_initialization_mode_and_follow_the_parameters():
    with instance(pendulum()) as fmu:
        fmu.fmu.setupExperiment(startTime=2.0)
        fmu.set(length=0.7)
        fmu.fmu.enterInitializationMode()
        assert fmu.get("A.x") == 0.7
        assert fmu.get("clock") == 2.0
        fmu.set(length=0.9)
        assert (fmu.get("A.x"), fmu.get("reach")) == (0.9, 0.9)
        fmu.fmu.exitInitializationMode()
        assert fmu.step(2.0, 0.1)
        assert fmu.get("clock") == pytest.approx(2.1, abs=1e-15)


# ------------------------------------------------------------------------- reset, saved states


# ------------------------------------------------------------------------------- many instances


def test_what_is_read_before_the_first_step_does_not_change_it():
    path = scene_fmu("spring_pendulum")
    with instance(path) as read, instance(path) as b:
        for fmu in (read, b):
            fmu.initialise(push=1.0)
            fmu.set(stiffness=150.0)
            if fmu is read:
                assert fmu.outputs()
            fmu.set(push=3.0)
        assert read.outputs() == b.outputs()
        assert read.run(0.0, 0.05, 5) == b.run(0.0, 0.05, 5)


def test_a_tunable_parameter_set_before_the_first_step_is_booked_as_work_too():
    with instance(scene_fmu("spring_pendulum")) as fmu:
        fmu.initialise(damping=0.0)
        before, stretch = fmu.get("energy.total"), fmu.get("stretch")
        fmu.set(stiffness=300.0)
        jump = fmu.get("energy.total") - before
        assert jump == pytest.approx(0.5 * 100.0 * stretch**2, rel=1e-9, abs=1e-12)
        assert fmu.get("energy.work") == pytest.approx(jump, rel=1e-9, abs=1e-12)
        fmu.run(0.0, 0.05, 5)
        assert fmu.get("energy.error") < 1e-9
