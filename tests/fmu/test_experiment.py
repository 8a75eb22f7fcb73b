"""What instantiation and setupExperiment bring: a place, the length of a run and its tolerance."""

from __future__ import annotations

import pytest

from tests.support.fmus.fmu_instance import Instance, instance, pendulum

CHOSEN = {"step_size": 0.0, "order": 0.0, "tolerance": 0.0}
"""Settings of which none is given."""


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
def test_a_second_experiment_without_a_stop_time_takes_the_first_one_back(native):
    """Both the last time of a step, and the length of the run for which a tolerance holds."""
    found = []
    for stops in ([None], [0.25, None], [0.25]):
        with instance(pendulum(native=native)) as fmu:
            fmu.set(solver__tolerance=1e-5)
            for stop in stops:
                fmu.fmu.setupExperiment(startTime=0.0, stopTime=stop)
            fmu.fmu.enterInitializationMode()
            fmu.fmu.exitInitializationMode()
            found.append(fmu.run(0.0, 0.1, 2))
            if stops[-1] is None:
                assert fmu.step(0.2, 0.5)
    assert found[0] == found[1] != found[2]


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
def test_a_second_experiment_without_a_tolerance_takes_the_first_one_back(native):
    found = []
    for tolerances in ([None], [1e-9, None], [1e-9]):
        with instance(pendulum(native=native)) as fmu:
            fmu.set(solver__tolerance=1e-4)
            for tolerance in tolerances:
                fmu.fmu.setupExperiment(tolerance=tolerance, startTime=0.0)
            fmu.fmu.enterInitializationMode()
            fmu.fmu.exitInitializationMode()
            found.append(fmu.run(0.0, 0.1, 2))
    assert found[0] == found[1] != found[2]


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
@pytest.mark.parametrize(
    ("own", "tolerance", "taken", "words"),
    [
        ({"tolerance": 1e-4}, 1e-7, 1e-7, ""),
        ({}, 1e-7, 1e-7, ""),  # for 1e-4
        ({"tolerance": 1e-5}, -1.0, 1e-5, "tolerance -1.0 has no effect: it must be >= 1e-14"),
        ({"tolerance": 1e-5}, 1e-20, 1e-5, "tolerance 1e-20 has no effect: it must be >= 1e-14"),
        (
            {"tolerance": 1e-5},
            1e-2,
            1e-5,
            "tolerance 0.01 has no effect: that of this run is 1e-05",
        ),
        ({}, 1e-2, 1e-4, "tolerance 0.01 has no effect: that of this run is 0.0001"),
        ({"step_size": 0.01}, 1e-7, 0.0, "tolerance 1e-07 has no effect: this run has fixed steps"),
    ],
)
def test_an_fmu_takes_a_tolerance_that_is_tighter_than_its_own_and_else_says_why(
    own, tolerance, taken, words, native
):
    runs = []
    for asked, settings in ((tolerance, own), (None, {"tolerance": taken} if taken else own)):
        with instance(pendulum(native=native)) as fmu:
            fmu.set(**{f"solver__{name}": value for name, value in {**CHOSEN, **settings}.items()})
            fmu.fmu.setupExperiment(tolerance=asked, startTime=0.0, stopTime=2.0)
            fmu.fmu.enterInitializationMode()
            fmu.fmu.exitInitializationMode()
            said = [text for _, _, text in fmu.log if "tolerance" in text]
            assert len(said) == bool(words and asked)
            assert all(text.startswith(words) for text in said)
            runs.append(fmu.run(0.0, 0.1, 10))
    assert runs[0] == runs[1]


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
def test_a_tolerance_of_the_host_does_not_turn_equal_steps_that_are_set_later_into_others(native):
    runs = []
    for tolerance in (None, 1e-7):
        with instance(pendulum(native=native)) as fmu:
            fmu.set(**{f"solver__{name}": value for name, value in CHOSEN.items()})
            fmu.fmu.setupExperiment(tolerance=tolerance, startTime=0.0, stopTime=2.0)
            fmu.set(solver__step_size=0.01)
            fmu.fmu.enterInitializationMode()
            fmu.fmu.exitInitializationMode()
            runs.append(fmu.run(0.0, 0.1, 10))
    assert runs[0] == runs[1]


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
def test_a_wider_tolerance_of_the_host_changes_no_bit(native):
    found = []
    for tolerance in (None, 1e-2, 1e-7):
        with instance(pendulum(native=native)) as fmu:
            fmu.set(solver__tolerance=1e-5)
            fmu.fmu.setupExperiment(tolerance=tolerance, startTime=0.0, stopTime=1.0)
            fmu.fmu.enterInitializationMode()
            fmu.fmu.exitInitializationMode()
            found.append(fmu.run(0.0, 0.1, 10))
    assert found[0] == found[1] != found[2]


def test_a_native_fmu_finds_its_model_in_a_folder_whose_name_has_a_space(tmp_path):
    folder = tmp_path / "a folder 100 %"
    fmu = Instance(pendulum(native=True), str(folder))  # fmpy writes the URI with %20 and %25
    fmu.initialise()
    assert fmu.get("reach") == 1.0
    fmu.fmu.terminate()
    fmu.fmu.freeInstance()
