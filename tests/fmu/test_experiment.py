"""What setupExperiment brings: the length of a run and its tolerance."""

from __future__ import annotations

from tests.fmu_instance import instance, pendulum, slave_of


def test_the_tolerance_of_the_importer_replaces_one_that_the_scene_asks_for():
    with instance(pendulum()) as fmu:
        slave = slave_of(fmu)
    slave._integrator["solver.tolerance"] = 1e-4
    slave.setup_experiment(0.0, 2.0, 1e-7)
    assert slave._integrator["solver.tolerance"] == 1e-7
    assert slave._integrator.state.head["horizon"] == 2.0


def test_a_run_of_fixed_steps_says_that_a_tolerance_has_no_effect():
    with instance(pendulum()) as fmu:
        slave = slave_of(fmu)
    slave.setup_experiment(0.0, 2.0, 1e-7)
    assert slave._integrator["solver.tolerance"] == 0.0
    assert any("no effect" in message.msg for message in slave._get_log_queue())


def test_a_second_experiment_without_a_stop_time_takes_the_first_one_back():
    with instance(pendulum()) as fmu:
        slave = slave_of(fmu)
    of_the_scene = slave._integrator.state.head["horizon"]
    slave.setup_experiment(0.0, 0.25)
    assert slave._integrator.state.head["horizon"] == 0.25
    slave.setup_experiment(0.0)
    assert slave._integrator.state.head["horizon"] == of_the_scene
    slave.enter_initialization_mode()
    slave.exit_initialization_mode()
    assert slave.do_step(0.0, 0.5)
