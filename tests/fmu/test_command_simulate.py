"""`holonom simulate` and `check`: what they print, and what ends them before they begin."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

import solver
from build_fmu import build
from build_fmu.errors import UsageError
from build_fmu.run import run_fmu
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, scene_fmu

PENDULUM = str(SCENES / "double_pendulum.toml")


def trajectory(path: Path) -> dict[str, list[float]]:
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def test_the_csv_file_has_the_numbers_of_the_run(capsys, tmp_path):
    fmu = scene_fmu("double_pendulum")
    arguments = ("simulate", fmu, "--stop", 1, "--step", 0.05, "--csv", tmp_path / "a.csv")
    code, out, err = run(capsys, *arguments)
    assert (code, err) == (0, "")
    expected = solver.simulate(PENDULUM, stop_time=1.0, step_size=0.05)
    columns = trajectory(tmp_path / "a.csv")
    assert out == f"{tmp_path / 'a.csv'}: 21 rows, {len(columns)} columns\n"
    assert run(capsys, *arguments, "--json")[2] == out
    assert columns["B.x"] == list(expected["B.x"])
    assert columns["time"] == pytest.approx(expected.t)


def test_a_scene_is_simulated_as_its_fmu(capsys):
    arguments = ("--stop", "0.5", "--csv", "-", "--set", "mass=3")
    scene = run(capsys, "simulate", PENDULUM, *arguments)
    fmu = run(capsys, "simulate", scene_fmu("double_pendulum"), *arguments)
    assert scene == fmu
    assert scene[0] == 0


def test_a_run_that_ends_early_ends_with_3_and_the_reason(capsys):
    arguments = ("simulate", scene_fmu("four_bar"), "--set", "solver.max_newton=1", "--json")
    code, out, err = run(capsys, *arguments)
    assert code == 3
    summary = json.loads(out)
    assert (summary["finished"], summary["end_time"], summary["steps"]) == (False, 0.0, 0)
    assert "did not converge" in summary["reason"]
    assert summary["reason"] in err


@pytest.mark.parametrize("target", [str(SCENES / "four_bar.toml"), "fmu"])
def test_a_formulation_of_the_paper_runs_without_fmpy(capsys, target):
    # The four-bar's midpoint rule breaks where all bars are in one line, at 0.7 s.
    target = scene_fmu("four_bar") if target == "fmu" else target
    arguments = "simulate", target, "--formulation", "midpoint-al", "--json"
    code, out, err = run(capsys, *arguments, "--set", "solver.step_size=0.002")
    summary = json.loads(out)
    assert (code, summary["finished"]) == (3, False)
    assert summary["end_time"] == pytest.approx(0.7)
    assert summary["largest"]["energy.error"] > 0.01
    assert "step from t = 0.71" in err


def test_a_mechanism_that_the_paper_does_not_take_ends_with_2(capsys):
    arguments = "simulate", scene_fmu("bouncing_ball"), "--formulation", "midpoint-al"
    code, _, err = run(capsys, *arguments)
    assert (code, "contact 'floor': the paper's method takes no contacts" in err) == (2, True)


def test_a_name_that_the_fmu_does_not_have_ends_with_2_and_a_suggestion(capsys):
    code, _, err = run(capsys, "simulate", scene_fmu("four_bar"), "--set", "drve=1")
    assert code == 2
    assert "did you mean 'drive'?" in err


FIXED = "fields of a scene are fixed in its FMU: declare a parameter for it in the scene, or build"


@pytest.mark.parametrize(
    ("name", "message", "help"),
    [
        ("bodies.crank0.mass", "four_bar has no parameter or input 'bodies.crank0.mass'", FIXED),
        ("gravity", "four_bar has no parameter or input 'gravity'", FIXED),
        ("gravity[1]", "four_bar has no parameter or input 'gravity[1]'", FIXED),
        (
            "inputs.drive",
            "four_bar has no parameter or input 'inputs.drive'",
            "did you mean 'drive'",
        ),
        (
            "solver.ordr",
            "four_bar has no parameter or input 'solver.ordr'",
            "did you mean 'solver.o",
        ),
        ("B0.x", "B0.x: is an output and cannot be set", "settable: drive, "),
    ],
)
def test_what_an_fmu_has_not_to_be_set_is_told_with_the_reason(capsys, name, message, help):
    code, _, err = run(capsys, "simulate", scene_fmu("four_bar"), "--set", f"{name}=1")
    assert code == 2
    assert err.startswith(f"--set {name}=1: error: {message}\n  = help: {help}")


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ("drive=abc", "drive: must be a number in N.m, got 'abc'"),
        ("drive=[1,2]", "drive: must be a number in N.m, got [1, 2]"),
        ("drive=true", "drive: must be a number in N.m, got True"),
        (
            f"drive=1{'0' * 400}",
            "drive: must be a finite number in N.m, got an integer of 401 digits",
        ),
        ("drive=nan", "drive: must be a finite number in N.m, got nan"),
        ("solver.assemble=1", "solver.assemble: must be true or false, got 1"),
        ("solver.start=7", "solver.start: must be a text, got 7"),
        ("solver.start=foo", "solver.start: must be one of drawn, equilibrium"),
        ("solver.order=3", "solver.order: must be 2, 4, 6 or 8, or 0 for the one that a tolerance"),
        ("solver.max_newton=2.5", "solver.max_newton: must be a whole number >= 1 and <= 1000"),
        ("solver.max_newton=0", "solver.max_newton: must be >= 1, got 0"),
        ("solver.tolerance=1e-20", "solver.tolerance: must be 0 or a number from 1e-14"),
    ],
    ids=range(12),
)
def test_a_value_of_another_type_ends_with_2(capsys, wrong, words):
    code, out, err = run(capsys, "simulate", scene_fmu("four_bar"), "--set", wrong)
    assert (code, out) == (2, "")
    assert words in err
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--stop", "inf"), "after the start time 0.0 s, got inf"),
        (("--stop", "nan"), "after the start time 0.0 s, got nan"),
        (("--step", "inf"), "must be a finite number > 0 s, got inf"),
        (("--step", "1e-12"), "more than the 1e+07 of one run"),
        (("--stop", "1e300"), "more than the 1e+07 of one run"),
    ],
    ids=str,
)
@pytest.mark.parametrize("command", ["simulate", "check"])
def test_a_run_that_would_not_end_ends_with_2(capsys, command, arguments, words):
    code, out, err = run(capsys, command, scene_fmu("four_bar"), *arguments)
    assert (code, out) == (2, "")
    assert words in err


def test_a_number_of_an_fmu_may_have_a_unit(capsys):
    fmu = scene_fmu("four_bar")
    outputs = [
        run(capsys, "simulate", fmu, "--set", f"drive={x}", "--stop", 0.01)[1].partition("\n")[2]
        for x in ("1.5kN.m", "1500")
    ]  # the first line has the time that it took
    assert outputs[0] == outputs[1] != ""
    code, _, err = run(capsys, "simulate", fmu, "--set", "drive=1newtonmeter")
    message = "--set drive=1newtonmeter: error: drive: must be a number in N.m"
    assert code == 2
    assert err.startswith(message)
    code, _, err = run(capsys, "simulate", fmu, "--set", "drive=1 kg")
    assert (code, "'kg' measures something else; give the value in N.m" in err) == (2, True)


def test_the_folder_of_a_csv_file_is_made(capsys, tmp_path):
    file = tmp_path / "new" / "folder" / "a.csv"
    assert run(capsys, "simulate", PENDULUM, "--stop", 0.1, "--csv", file)[0] == 0
    assert trajectory(file)["time"][-1] == 0.1


@pytest.mark.parametrize("command", ["simulate", "check", "sweep"])
def test_a_step_that_is_longer_than_the_run_is_refused(capsys, tmp_path, command):
    arguments = [scene_fmu("four_bar"), "--stop", 1]
    if command == "sweep":
        arguments += ["--grid", "drive=1,2", "-o", tmp_path / "a.csv"]
    code, out, err = run(capsys, command, *arguments, "--step", 3)
    assert (code, out) == (2, "")
    words = "the communication step of 3 s is longer than the run of 1 s; take a shorter step"
    assert err == f"holonom: {words}\n"
    assert run(capsys, command, *arguments, "--step", 1)[0] == 0


def test_a_run_shorter_than_the_step_of_the_scene_is_one_step(capsys):
    code, out, _ = run(capsys, "simulate", scene_fmu("four_bar"), "--stop", 0.01, "--json")
    assert (code, json.loads(out)["steps"]) == (0, 1)


def test_check_passes_where_energy_and_constraints_hold(capsys):
    code, out, err = run(capsys, "check", scene_fmu("four_bar"), "--json")
    assert (code, err) == (0, "")
    assert json.loads(out)["holds"]


def test_check_fails_where_they_do_not(capsys):
    scene = SCENES / "four_bar.toml"
    code, out, _ = run(capsys, "check", scene, "--stop", 1, "--energy", 1e-20)
    assert code == 1
    assert "NO" in out


LIMITED = """
name = "limited"
dimension = 2
[parameters]
length = { value = 1.0, min = 0.1, max = 3, unit = "m" }
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["length", 0], mass = 1 }
B = { position = [2, 0], fixed = true }
[joints]
upper = { type = "distance", points = ["O", "A"], length = 1.0 }
lower = { type = "distance", points = ["A", "B"], length = 1.0 }
"""


@pytest.mark.parametrize("command", ["simulate", "check"])
def test_a_mechanism_that_cannot_begin_says_so_once(capsys, tmp_path, command):
    """At the limit of a parameter it cannot be assembled: there is no table of what never was."""
    scene = tmp_path / "limited.toml"
    scene.write_text(LIMITED)
    fmu = build(scene, tmp_path)
    code, out, err = run(capsys, command, fmu, "--set", "length=0.1")
    assert (code, out) == (3, "")
    for joint, distance in (("upper", 0.1), ("lower", 1.9)):
        words = f"joint '{joint}': length is 1 m, but its points are drawn {distance} m apart"
        assert err.count(words) == 1
    assert err.count("move a point, correct the length, or leave it out") == 1
    assert err.startswith("holonom: the run ended at t = 0.0 s, before 1.0 s: ")


RESTING = """
name = "resting"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0, -1], mass = 1.0, velocity = [0.0, 0] }
[joints]
rod = { type = "distance", points = ["O", "A"] }
"""


@pytest.mark.parametrize(
    ("start", "speed", "moves"),
    [("drawn", 0.0, False), ("equilibrium", 0.0, False), ("drawn", 1e-6, True)],
)
def test_what_is_at_rest_is_said_not_to_have_moved(capsys, tmp_path, start, speed, moves):
    scene = tmp_path / "resting.toml"
    scene.write_text(RESTING)
    arguments = (scene, "--set", f"points.A.velocity=[{speed},0]", "--set", f"solver.start={start}")
    _, out, _ = run(capsys, "simulate", *arguments)
    assert out.splitlines()[0].endswith("; nothing moved") is not moves
    assert json.loads(run(capsys, "simulate", *arguments, "--json")[1])["moved"] is moves
    code, out, _ = run(capsys, "check", *arguments)
    assert code == 0
    assert out.count("nothing moved") == (
        0 if moves else 3
    )  # of energy, of accuracy, and that neither was measured
    assert json.loads(run(capsys, "check", *arguments, "--json")[1])["moved"] is moves


PUSHED = """
name = "pushed"
dimension = 2
[inputs]
push = { unit = "N", max = 3 }
[points]
A = { position = [0, 0], mass = 1 }
[forces]
f = { type = "force", point = "A", value = ["push", 0] }
"""


def test_a_run_that_stops_early_has_one_row_for_each_time(capsys, tmp_path):
    scene, inputs, out = (tmp_path / name for name in ("a.toml", "in.csv", "out.csv"))
    scene.write_text(PUSHED)
    inputs.write_text("time,push\n0,0\n0.5,4\n1,4\n")
    times = ("--stop", "1", "--step", "0.125")
    assert run(capsys, "simulate", scene, "--inputs", inputs, *times, "--csv", out)[0] == 3
    assert trajectory(out)["time"] == [0.0, 0.125, 0.25, 0.375, 0.5]


@pytest.mark.parametrize("count", [400, 5000])
@pytest.mark.parametrize("form", ["push={}", "push=[{}]"])
def test_an_integer_of_very_many_digits_is_refused_in_one_short_sentence(
    capsys, tmp_path, count, form
):
    scene = tmp_path / "a.toml"
    scene.write_text(PUSHED)
    code, _, err = run(capsys, "simulate", scene, "--set", form.format("1" + "0" * count))
    assert code == 2
    assert "set_int_max_str_digits" not in err
    assert len(err.splitlines()[0]) < 700


@pytest.mark.parametrize("name", ["stop_time", "step_size"])
@pytest.mark.parametrize("value", [10**400, 10**5000], ids=["400", "5000"])
def test_a_time_that_no_double_can_hold_is_refused(name, value):
    with pytest.raises(UsageError, match="got an integer of"):
        run_fmu(scene_fmu("double_pendulum"), **{name: value})


BALL = """
name = "ball"
dimension = 2
gravity = [0, -9.81]
[points]
ball = { mass = 1.0, position = [0, 0.5], velocity = [1, 0] }
[contacts]
floor = { type = "plane", point = "ball", axis = [0, 1], restitution = 0.5, friction = 0.1 }
[experiment]
stop_time = 2.0
"""


def test_check_tells_what_took_the_energy_of_a_mechanism_that_touches(capsys, tmp_path):
    scene = tmp_path / "ball.toml"
    scene.write_text(BALL)
    code, out, _ = run(capsys, "check", scene, "--json")
    taken = json.loads(out)["taken"]
    assert code == 0
    assert taken["damping"] == 0.0
    # It comes to rest on the floor: all of its energy is gone.
    assert taken["friction"] + taken["impact"] == pytest.approx(9.81 * 0.5 + 0.5, rel=1e-12)
    _, table, _ = run(capsys, "check", scene)
    assert "energy taken out by" in table
    assert "taken" not in run(capsys, "check", SCENES / "four_bar.toml", "--stop", 1, "--json")[1]
