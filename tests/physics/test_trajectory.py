"""`simulate` runs from Python: its times, its names, and what it refuses."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import pytest

import build_fmu
import holonom
import solver
from solver.runtime import OptionError
from tests.support.kernel.twins import PENDULUM, model_of


def run(**arguments):
    return solver.simulate(model_of(PENDULUM), **arguments)


def test_what_is_left_out_is_that_of_the_scene():
    trajectory = run()
    assert trajectory.t == pytest.approx(np.linspace(0.0, 1.0, 101))
    variables = model_of(PENDULUM).variables
    assert trajectory.names == tuple(v.name for v in variables if v.causality == "output")
    assert trajectory.table.shape == (101, len(trajectory.names))


@pytest.mark.parametrize(
    ("stop", "internal", "communication"),
    [(1, 0.01, 0.01), (10, 0.01, 0.1), (3, 0.01, 0.03), (2.5, 0.01, 0.02), (1000, 0.01, 0.1),
     (0.5, 0.001, 0.005), (1, 0.1, 0.1), (0.005, 0.01, 0.01)],
)  # fmt: skip
def test_the_default_run_has_a_hundred_rows_or_one_for_each_internal_step(
    stop, internal, communication
):
    text = f"{PENDULUM}\n[solver]\nstep_size = {internal}\n[experiment]\nstop_time = {stop}\n"
    assert solver.loads(text).experiment.step_size == pytest.approx(communication, rel=1e-15)


def test_a_communication_step_of_whole_internal_steps_does_not_change_the_motion():
    """The internal steps are the same, up to the rounding of 0.1 s / 10."""
    often, seldom = (run(outputs=["A.x", "A.y"], step_size=h) for h in (0.01, 0.1))
    assert often.table[::10] == pytest.approx(seldom.table, abs=1e-13)


def test_what_is_asked_for_is_collected_in_that_order():
    trajectory = run(outputs=["energy.total", "A.x"], stop_time=0.25, step_size=0.1)
    assert trajectory.names == ("energy.total", "A.x")
    assert trajectory.t.tolist() == [0.0, 0.1, 0.2, 0.25]
    assert trajectory["A.x"][0] == 0.6


def test_a_line_tells_what_a_trajectory_has():
    trajectory = run(outputs=["A.x", "A.y"], stop_time=0.25)
    assert repr(trajectory) == "<Trajectory: 26 times from 0 to 0.25 s, 2 variables: A.x, A.y>"
    assert len(repr(run())) < 120


STOP, STEP = "the stop time", "the communication step"


@pytest.mark.parametrize("step_size", [0.0, -0.1, math.nan, math.inf, 1.01])
def test_a_step_that_leads_nowhere_is_refused(step_size):
    with pytest.raises(OptionError, match=f"^{STEP} .* s"):
        run(step_size=step_size)


@pytest.mark.parametrize("stop_time", [0.0, -1.0, math.nan, math.inf])
def test_an_end_that_is_not_after_the_start_is_refused(stop_time):
    with pytest.raises(OptionError, match=f"^{STOP} .* after the start time 0.0 s"):
        run(stop_time=stop_time)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"outputs": []}, "^outputs: must name at least one"),
        ({"outputs": "A.x"}, "^outputs: must be a sequence of names"),
        ({"outputs": ["A.xx"]}, "'A.xx'; did you mean 'A.x'"),
        ({"parameters": {"solver.penalt": 1.0}}, "'solver.penalt'; did you mean 'solver.penalty'"),
        ({"inputs": {"A.x": 1.0}}, "A.x: is calculated"),
        ({"toleranec": 1e-6}, "did you mean 'solver.tolerance'"),
    ],
    ids=str,
)
def test_a_name_that_cannot_be_meant_is_answered(arguments, words):
    with pytest.raises(OptionError, match=words):
        run(**arguments)


def test_a_trajectory_answers_a_wrong_name_too():
    trajectory = run(outputs=["A.x"])
    with pytest.raises(KeyError, match=r"^no variable is named 'A.z'; did you mean 'A.x'\?$"):
        trajectory["A.z"]


def test_a_trajectory_is_a_mapping_of_names_to_arrays():
    trajectory = run(outputs=["A.x", "energy.total"])
    assert isinstance(trajectory, Mapping)
    assert "A.x" in trajectory
    assert "A.z" not in trajectory
    assert list(trajectory) == list(trajectory.keys()) == ["A.x", "energy.total"]
    assert len(trajectory) == 2
    assert trajectory.get("A.z") is None
    for name, values in trajectory.items():
        assert np.array_equal(values, trajectory[name])
    assert trajectory == run(outputs=["A.x", "energy.total"])
    assert trajectory != run(outputs=["A.x"])


def test_a_trajectory_becomes_a_data_frame():
    pytest.importorskip("pandas")
    trajectory = run(outputs=["A.x", "energy.total"])
    frame = trajectory.to_pandas()
    assert frame.index.name == "time"
    assert frame.index.tolist() == trajectory.t.tolist()
    assert list(frame.columns) == list(trajectory)
    assert np.array_equal(frame["A.x"], trajectory["A.x"])


@pytest.mark.parametrize("package", [solver, build_fmu, holonom], ids=lambda x: x.__name__)
def test_dir_lists_the_names_for_users(package):
    assert dir(package) == sorted(package.__all__)
    assert all(hasattr(package, name) for name in dir(package))


@pytest.mark.parametrize(
    ("arguments", "name"),
    [
        ({"stop_time": 10**400}, STOP), ({"step_size": -(10**5000)}, STEP),
        ({"tolerance": 10**400}, "solver.tolerance"), ({"order": 10**400}, "solver.order"),
        ({"parameters": {"solver.penalty": 10**5000}}, "solver.penalty"),
    ],
    ids=range(5),
)  # fmt: skip
def test_an_integer_that_no_double_holds_is_refused(arguments, name):
    with pytest.raises(OptionError, match=f"^{name}:? must be .*got an integer of more"):
        run(**arguments)


@pytest.mark.parametrize("value", ["1", 1j, (1.0,)])
@pytest.mark.parametrize(("name", "words"), [("stop_time", STOP), ("step_size", STEP)])
def test_a_time_that_is_no_number_is_refused(name, words, value):
    with pytest.raises(OptionError, match=f"^{words} must be a finite number .* s, got"):
        run(**{name: value})
