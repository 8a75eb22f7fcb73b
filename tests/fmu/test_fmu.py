"""FMUs in fmpy: the same numbers as the library, values that take effect, exact states."""

from __future__ import annotations

import pytest

from tests.fmu_instance import instance, pendulum, scene_fmu

# ------------------------------------------------------------------------- values take effect


def test_parameters_do_what_the_same_scene_with_the_numbers_written_in_does():
    with instance(pendulum()) as set_later, instance(pendulum(length=1.3, mass=2.0)) as written:
        set_later.initialise(length=1.3, mass=2.0, push=0.5)
        written.initialise(push=0.5)
        assert set_later.run(0.0, 0.05, 20) == written.run(0.0, 0.05, 20)


def test_an_input_does_what_the_same_scene_with_the_number_written_in_does():
    with instance(pendulum()) as driven, instance(pendulum(push="3.5")) as written:
        driven.initialise(push=3.5)
        written.initialise()
        for i in range(20):
            driven.step(i * 0.05, 0.05)
            written.step(i * 0.05, 0.05)
            assert driven.get("A.x") == pytest.approx(written.get("A.x"), abs=1e-12)
            assert driven.get("A.vy") == pytest.approx(written.get("A.vy"), abs=1e-12)


def test_a_tunable_parameter_may_change_between_steps_and_the_change_is_booked_as_work():
    with instance(scene_fmu("spring_pendulum")) as fmu:
        fmu.initialise(damping=0.0)
        fmu.run(0.0, 0.05, 5)
        before = fmu.get("energy.total")
        stretch = fmu.get("stretch")
        fmu.set(stiffness=300.0)
        jump = fmu.get("energy.total") - before
        assert jump == pytest.approx(0.5 * 100.0 * stretch**2, rel=1e-9)
        assert fmu.get("energy.work") == pytest.approx(jump, rel=1e-9)
        assert fmu.get("frequency") == pytest.approx((300.0 / 2.0) ** 0.5)
        fmu.run(0.25, 0.05, 5)
        assert fmu.get("energy.error") < 1e-9


def test_a_value_beyond_its_limits_is_refused():
    with instance(scene_fmu("spring_pendulum")) as fmu:
        fmu.initialise(push=101.0)
        assert "push" in fmu.log[-1][2]
        assert "100" in fmu.log[-1][2]
        assert not fmu.step(0.0, 0.05)
        fmu.set(push=100.0)
        assert fmu.step(0.0, 0.05)


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


def test_a_serialised_state_continues_in_another_instance():
    path = scene_fmu("four_bar")
    with instance(path) as fmu, instance(path) as other:
        fmu.initialise(drive=1.5, solver__step_size=0.01)
        fmu.run(0.0, 0.05, 10)
        state = fmu.fmu.getFMUState()
        data = fmu.fmu.serializeFMUState(state)
        other.fmu.setFMUState(other.fmu.deserializeFMUState(data))
        assert other.get("drive") == 1.5
        assert other.outputs() == fmu.outputs()
        assert other.run(0.5, 0.05, 20) == fmu.run(0.5, 0.05, 20)


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
