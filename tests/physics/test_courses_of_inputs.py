"""Inputs arrive when they are meant to: jumps at their time, what moves without a lag."""

from __future__ import annotations

import math
import re
import warnings
import zipfile
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from fmpy import read_model_description

import solver
from build_fmu.errors import UsageError
from build_fmu.run import run_fmu
from tests.physics.test_smooth_inputs import ARM, torque
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import text_fmu
from tests.support.fmus.native_fmus import native_fmu
from tests.support.mechanisms.problems import observed_order

Columns = Mapping[str, np.ndarray]


def _in_python(text: str, inputs: Mapping[str, Any], stop: float, step: float) -> Columns:
    moved = solver.simulate(solver.loads(text), inputs=inputs, stop_time=stop, step_size=step)
    return {"time": moved.t, **moved}


def _in_fmu(fmu: Callable[[str], Any]) -> Callable[[str, Mapping[str, Any], float, float], Columns]:
    def ran(text: str, inputs: Mapping[str, Any], stop: float, step: float) -> Columns:
        found = run_fmu(fmu(text), inputs=inputs, stop_time=stop, step_size=step)
        assert found.reason == ""
        return {name: found.values[name] for name in found.values.dtype.names or ()}

    return ran


def _native(fmi: int) -> Callable[[str], Any]:
    return lambda text: native_fmu(solver.assemble(solver.loads(text)), fmi)


RUNS = {
    "python": _in_python,
    "FMU with Python": _in_fmu(text_fmu),
    "native FMU": _in_fmu(_native(2)),
    "native FMU of FMI 3": _in_fmu(_native(3)),
}
EVERYWHERE = pytest.mark.parametrize("moved", RUNS.values(), ids=RUNS)

# --------------------------------------------------------------------------- what moves in a step

SMOOTH = ARM.replace("TOLERANCE", "0")
RAMPED = SMOOTH.replace('"smooth"', '"ramp"')
STEPS = (0.04, 0.02, 0.01)


@EVERYWHERE
def test_an_arm_follows_a_smooth_course_without_a_lag(moved):
    """Its angle is that of the course at each communication point, not that of a step before.

    The motion sin(t)^2 begins at rest; the first steps, which do not know its acceleration, are
    left out of the orders.
    """
    errors = []
    for step in STEPS:
        found = moved(SMOOTH, {"u": lambda t: math.sin(t) ** 2}, 1.2, step)
        t = found["time"]
        assert found["A.angle"] == pytest.approx(np.sin(t) ** 2, abs=1e-12)
        assert found["u"].tolist() == [math.sin(x) ** 2 for x in t.tolist()]
        force = found["motor.torque"] - torque(np.sin(t) ** 2, 2.0 * np.cos(2.0 * t))
        rate = found["A.angular_velocity"] - np.sin(2.0 * t)
        errors.append([abs(force[4:]).max(), abs(rate[4:]).max()])
    of_torque, of_rate = np.array(errors).T
    assert observed_order(STEPS, of_torque) == pytest.approx(2.0, abs=0.1)
    assert observed_order(STEPS, of_rate) == pytest.approx(3.0, abs=0.1)


@EVERYWHERE
def test_an_arm_follows_a_ramped_course_without_a_lag(moved):
    found = moved(RAMPED, {"time": [0.0, 0.5, 1.0], "u": [0.0, 0.6, 0.2]}, 1.0, 0.1)
    t = found["time"]
    exact = np.where(t < 0.5, 1.2 * t, 0.6 - 0.8 * (t - 0.5))
    assert found["A.angle"] == pytest.approx(exact, abs=1e-12)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "moves (a ramp: before each step set it)",
        "smooth: before each step set its value at the end of the step",
    ],
)
@pytest.mark.parametrize("word", ["hold", "ramp", "smooth"])
@EVERYWHERE
def test_how_an_input_moves_does_not_hang_on_words_of_its_description(moved, word, text):
    """The impulse of t in a step: held, H times its value at the beginning; else that of a line."""
    scene = MASS.replace('"N"', f'"N", interpolation = "{word}", description = "{text}"')
    found = moved(scene, {"push": lambda t: t}, 0.4, 0.1)
    held = 0.1 * np.cumsum([0.0, 0.0, 0.1, 0.2, 0.3]) / 2.0
    line = found["time"] ** 2 / 4.0
    late = np.abs(found["A.vx"] - (held if word == "hold" else line)).max()
    assert late < (1e-3 if word == "smooth" else 1e-12)  # a smooth one begins from rest


@pytest.mark.parametrize("word", ["hold", "ramp", "smooth"])
def test_the_description_of_an_input_says_what_to_set_before_a_step(word):
    """In every kind of FMU, where importers show it, and on its page."""
    text = SMOOTH.replace('"smooth"', f'"{word}", description = "of the arm"')
    told = {
        "hold": "of the arm",
        "ramp": "of the arm (a ramp: before each step set its value at the end of the step)",
        "smooth": "of the arm (smooth: before each step set its value at the end of the step)",
    }
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a held input that drives
        paths = [text_fmu(text), _native(2)(text), _native(3)(text)]
    for path in paths:
        (variable,) = [v for v in read_model_description(str(path)).modelVariables if v.name == "u"]
        assert variable.description == told[word]
    with zipfile.ZipFile(paths[0]) as archive:
        assert f">{told[word]}<" in archive.read("documentation/index.html").decode()


# ------------------------------------------------------------------------------------------ jumps

MASS = """
name = "mass"
dimension = 2
[inputs]
push = { unit = "N" }
[points]
A = { position = [0, 0], mass = 2.0 }
[forces]
hand = { type = "force", point = "A", value = ["push", 0] }
"""
JUMP = {"time": [0.0, 0.5, 0.5, 1.0], "push": [1.0, 1.0, -3.0, -3.0]}


@EVERYWHERE
@pytest.mark.parametrize("step", [0.25, 0.1, 0.4, 0.3], ids=str)
def test_a_time_that_stands_twice_is_a_jump_at_that_time(moved, step):
    """Also between communication points: v = t/2 until 0.5 s, then 1/4 - 3/2 (t - 1/2)."""
    found = moved(MASS, JUMP, 1.2, step)
    t = found["time"]
    assert len(t) == math.ceil(1.2 / step - 1e-9) + 1
    assert found["A.vx"] == pytest.approx(np.where(t < 0.5, t / 2.0, 1.0 - 1.5 * t), abs=1e-12)
    assert found["push"] == pytest.approx(np.where(t < 0.5, 1.0, -3.0))


@pytest.mark.parametrize("time", [0.3, 0.7, 0.1 + 0.2])
def test_a_jump_at_a_communication_point_acts_in_the_step_that_begins_there(time):
    """Though 3*0.1 is not 0.3 in binary numbers, and 0.7 is less than 7*0.1: to the last bit."""
    found = _in_python(MASS, {"time": [0.0, time, time, 1.0], "push": [1, 1, 5, 5]}, 1.0, 0.1)
    later = np.round(found["time"], 9) >= round(time, 9)
    assert found["push"].tolist() == np.where(later, 5.0, 1.0).tolist()
    exact = (found["time"] + 4.0 * np.maximum(found["time"] - time, 0.0)) / 2.0
    assert found["A.vx"] == pytest.approx(exact, abs=1e-12)


def test_a_ramped_input_goes_to_a_jump_and_then_on_by_a_line():
    """It has no jumps: until 0.25 s it is 0, and it is 1 at the next communication point, 0.3 s."""
    jump = {"time": [0.0, 0.25, 0.25, 1.0], "push": [0.0, 0.0, 1.0, 1.0]}
    found = _in_python(MASS.replace('"N"', '"N", interpolation = "ramp"'), jump, 1.0, 0.1)
    t = found["time"]
    exact = np.where(t < 0.25, 0.0, 0.5 * (t - 0.275))  # mean time of the line from 0.25 to 0.3 s
    assert found["A.vx"] == pytest.approx(exact, abs=1e-12)


def test_a_file_with_a_jump_drives_the_command(capsys, tmp_path):
    scene, file, csv = tmp_path / "mass.toml", tmp_path / "push.csv", tmp_path / "out.csv"
    scene.write_text(MASS)
    file.write_text("time,push\n0,1\n0.5,1\n0.5,-3\n1,-3\n")
    arguments = ("--inputs", file, "--stop", "1", "--step", "0.4", "--csv", csv)
    assert run(capsys, "simulate", scene, *arguments)[0] == 0
    found = np.genfromtxt(csv, delimiter=",", names=True, deletechars="")
    assert found["time"].tolist() == [0.0, 0.4, 0.8, 1.0]
    assert found["A.vx"] == pytest.approx([0.0, 0.2, -0.2, -0.5], abs=1e-12)


@pytest.mark.parametrize(
    ("times", "told"),
    [
        ([0.0, 1.0, 0.5], "time must ascend: {} has 0.5 s after 1 s; sort the rows"),
        ([1.0, 1.0, 1.0], "{} is the third row at 1 s; a jump has two rows of one time"),
    ],
    ids=["falls", "thrice"],
)
def test_rows_that_are_no_course_are_refused_with_their_place(capsys, tmp_path, times, told):
    """Line 5 of a file with an empty line and a header is the third row."""
    inputs = {"time": times, "push": [1.0, 2.0, 3.0]}
    with pytest.raises(solver.OptionError, match=re.escape(told.format("row 3"))):
        solver.simulate(solver.loads(MASS), inputs=inputs)
    with pytest.raises(UsageError, match=re.escape(told.format("row 3").partition(";")[0])):
        run_fmu(text_fmu(MASS), inputs=inputs)
    scene, file = tmp_path / "mass.toml", tmp_path / "push.csv"
    scene.write_text(MASS)
    file.write_text("time,push\n{},1\n\n{},2\n{},3\n".format(*times))
    code, _, err = run(capsys, "simulate", scene, "--inputs", file)
    assert code == 2
    assert f"{file}: error: {told.format('line 5').replace('; ', chr(10) + '  = help: ')}" in err


# ----------------------------------------------------------- smooth inputs that get straight lines


def test_a_smooth_input_that_gets_straight_lines_is_warned_of(capsys, tmp_path):
    """The lines turn by 1.2 + 0.8 rad/s at 0.5 s, in a step of 1 ms by 2000 rad/s2."""
    inputs = {"time": [0.0, 0.5, 1.0], "u": [0.0, 0.6, 0.2]}
    words = "u: is smooth and gets straight lines, which turn at t = 0.5 s by 2 rad/s within a "
    words += "communication step of 0.001 s: an acceleration of 2e+03 rad/s2"
    with pytest.warns(RuntimeWarning, match=re.escape(words)):
        solver.simulate(solver.loads(SMOOTH), inputs=inputs, stop_time=1.0, step_size=0.001)
    (told,) = run_fmu(
        text_fmu(SMOOTH), inputs=inputs, stop_time=1.0, step_size=0.001
    ).messages  # fmt: skip
    assert told.startswith(words)
    scene, file = tmp_path / "arm.toml", tmp_path / "u.csv"
    scene.write_text(SMOOTH)
    file.write_text("time,u\n0,0\n0.5,0.6\n1,0.2\n")
    _, _, err = run(capsys, "simulate", scene, "--inputs", file, "--stop", 1, "--step", 0.001)
    assert err == f"{told}\n"


@pytest.mark.parametrize(
    ("course", "at", "turn"),
    [
        ({"time": [0.0, 1.0], "u": [0.0, 0.5]}, 0.0, 0.5),  # it begins at rest
        ({"time": [0.2, 0.6], "u": [0.0, 0.2]}, 0.2, 0.5),  # and ends at rest: the first is told
        ({"time": [0.0, 0.4, 0.4, 1.0], "u": [0.0, 0.0, 0.01, 0.01]}, 0.4, 1.0),  # in a step
    ],
    ids=["from rest", "between", "jump"],
)
def test_corners_at_the_ends_and_jumps_are_told_too(course, at, turn):
    with pytest.warns(RuntimeWarning, match=f"turn at t = {at:g} s by {turn:g} rad/s within"):
        solver.simulate(solver.loads(SMOOTH), inputs=course, stop_time=1.0, step_size=0.01)


@pytest.mark.parametrize("rows", [0.01, 0.02])
def test_nothing_is_said_of_rows_that_sample_a_curve_or_of_ramps(rows):
    t = np.arange(0.0, 1.0 + 1e-9, rows)
    course = {"time": t, "u": np.sin(t) ** 2}
    solver.simulate(solver.loads(SMOOTH), inputs=course, stop_time=1.0, step_size=0.01)
    corner = {"time": [0.0, 0.5, 1.0], "u": [0.0, 0.6, 0.2]}
    solver.simulate(solver.loads(RAMPED), inputs=corner, stop_time=1.0, step_size=0.01)
    still = {"time": [0.0, 0.5, 1.0], "u": [0.0, 0.0, 0.0]}
    solver.simulate(solver.loads(SMOOTH), inputs=still, stop_time=1.0, step_size=0.01)
