"""What instantiation and setupExperiment bring: a place, the length of a run and its tolerance."""

from __future__ import annotations

import pytest

from tests.fmu_instance import Instance, instance, pendulum, slave_of


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


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
@pytest.mark.parametrize(
    ("own", "tolerance", "taken", "words"),
    [
        (1e-4, 1e-7, 1e-7, ""),
        (1e-4, -1.0, 1e-4, "tolerance -1.0 has no effect: it must be > 0"),
        (1e-4, 7.0, 1e-4, "tolerance 7.0 has no effect: solver.tolerance: must be 0 or"),
        (0.0, 1e-7, 0.0, "tolerance 1e-07 has no effect: this run has fixed steps"),
    ],
)
def test_an_fmu_takes_a_tolerance_that_has_an_effect_and_else_says_why(
    own, tolerance, taken, words, native
):
    with instance(pendulum(native=native)) as fmu:
        fmu.set(solver__tolerance=own)
        fmu.fmu.setupExperiment(tolerance=tolerance, startTime=0.0, stopTime=2.0)
        assert fmu.get("solver.tolerance") == taken
        said = [text for _, _, text in fmu.log if "tolerance" in text]
        assert len(said) == bool(words)
        assert all(text.startswith(words) for text in said)


def test_a_native_fmu_finds_its_model_in_a_folder_whose_name_has_a_space(tmp_path):
    folder = tmp_path / "a folder 100 %"
    fmu = Instance(pendulum(native=True), str(folder))  # fmpy writes the URI with %20 and %25
    fmu.initialise()
    assert fmu.get("reach") == 1.0
    fmu.fmu.terminate()
    fmu.fmu.freeInstance()
