"""`holonom check` measures accuracy: what it says is off is off by that, by closed forms."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest

import solver
from build_fmu import build
from build_fmu.accuracy import Comparison, of_a_tolerance, of_equal_steps
from build_fmu.finer_run import accuracy
from build_fmu.run import run_fmu
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import scene_fmu, text_fmu
from tests.support.mechanisms.exact_motions import double_pendulum_motion, pendulum_angle
from tests.support.mechanisms.reduced_models import heavy_top, matrix_of, rotation

PENDULUM = """
name = "swing"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[experiment]
stop_time = 5.0
step_size = 0.05
"""

SHAKEN = """
name = "shaken"
dimension = 2
gravity = [0, 0]
[points]
base = { position = [0, 0], mass = 0.5, velocity = [0.3, 0] }
load = { position = [1, 0], mass = 1.0 }
[drivers]
hand = { type = "position", point = "base", value = ["0.1*sin(3*t)", "0"] }
[forces]
s = { type = "spring", points = ["base", "load"], stiffness = 100, free_length = 1 }
[experiment]
stop_time = 2.0
step_size = 0.02
[solver]
step_size = 0.02
"""

ROTOR = """
name = "rotor"
dimension = 2
[bodies]
r = { position = [0, 0], mass = 1, inertia = 0.01 }
[joints]
j = { type = "revolute", bodies = ["ground", "r"], position = [0, 0] }
[forces]
m = { type = "joint_torque", joint = "j", value = 2.4 }
"""


def checked(capsys, target, *arguments):
    """Exit code, what --json prints of accuracy, and stderr."""
    code, out, err = run(capsys, "check", target, "--json", *arguments)
    return code, json.loads(out)["accuracy"], err


def of_kind(seen, kind):
    return next(each for each in seen["differences"] if each["of"] == kind)


# ------------------------------------------------------------------------------------ equal steps


@pytest.mark.parametrize(("order", "step"), [(2, 0.05), (2, 0.01), (4, 0.05)])
def test_the_error_of_a_pendulum_is_that_of_elliptic_functions(capsys, order, step):
    """A quarter turn, so that the box of its places has the diagonal sqrt(5)."""
    values = ("--set", f"solver.order={order}", "--set", f"solver.step_size={step}")
    fmu = text_fmu(PENDULUM)
    _, seen, _ = checked(capsys, fmu, *values)
    ours = run_fmu(fmu, settings={"solver.order": order, "solver.step_size": step}).values
    angle = pendulum_angle(ours["time"], math.pi / 2)
    error = max(abs(ours["A.x"] - np.sin(angle)).max(), abs(ours["A.y"] + np.cos(angle)).max())
    assert seen["error"] == pytest.approx(error / math.sqrt(5.0), rel=0.2)
    # The difference itself lacks the error of the finer run, 2^-p.
    assert of_kind(seen, "places")["largest"] == pytest.approx((1 - 2.0**-order) * error, rel=0.2)


def work_of_a_shaken_base(times):
    """Spring of 100 N/m between a base of 0.5 kg, driven as 0.1 sin(3 t), and 1 kg at rest [J]."""
    forced = 0.1 * 100.0 / (100.0 - 9.0)
    place = forced * (np.sin(3.0 * times) - 0.3 * np.sin(10.0 * times))
    rate = forced * (3.0 * np.cos(3.0 * times) - 3.0 * np.cos(10.0 * times))
    base, base_rate = 0.1 * np.sin(3.0 * times), 0.3 * np.cos(3.0 * times)
    energy = 0.25 * base_rate**2 + 0.5 * rate**2 + 50.0 * (place - base) ** 2
    return energy - energy[0]


@pytest.mark.parametrize("order", [2, 4])
def test_the_error_of_the_work_of_a_driver_is_shown(capsys, order):
    """`energy.error` is round-off whatever the work is."""
    fmu = text_fmu(SHAKEN)
    values = ("--set", f"solver.order={order}")
    _, seen, _ = checked(capsys, fmu, *values)
    ours = run_fmu(fmu, settings={"solver.order": order}).values
    error = abs(ours["energy.work"] - work_of_a_shaken_base(ours["time"])).max()
    assert error > 1e5 * abs(ours["energy.error"]).max()
    assert of_kind(seen, "works and losses")["largest"] == pytest.approx(
        (1 - 2.0**-order) * error, rel=0.2
    )
    _, out, _ = run(capsys, "check", fmu, *values)
    assert "energy.error tests the ledger, not the works in it" in out


def test_speeds_of_a_wheel_count_over_those_of_its_points_however_far_it_rolls():
    """A disc of 0.1 m at 2 m/s and 20 rad/s, for 50 s: no point of it is faster than 4 m/s."""
    times = np.linspace(0.0, 50.0, 11)
    run_ = {"w.x": 2.0 * times, "w.vx": np.full(11, 2.0), "w.angular_velocity": np.full(11, -20.0)}
    run_ |= {"w.force.x": np.full(11, 3.0), "w.torque": np.full(11, 0.3)}
    off = run_ | {"w.vx": run_["w.vx"] + 1e-3, "w.torque": run_["w.torque"] + 3e-4}
    units = {"w.x": "m", "w.vx": "m/s", "w.angular_velocity": "rad/s"}
    units |= {"w.force.x": "N", "w.torque": "N.m"}
    seen = Comparison(times, run_, off, units, 0.1).differences
    assert seen["m/s"].relative == pytest.approx(1e-3 / 2.0)
    assert seen["rad/s"].scale == pytest.approx(20.0)
    assert seen["N.m"].relative == pytest.approx(3e-4 / 0.3)
    assert seen["m"].scale == pytest.approx(100.0)


def test_steps_too_long_for_a_rotor_are_said_so_with_the_step_that_is_short_enough(capsys):
    """M/J = 240 rad/s2: 120 rad after 1 s; steps of 10 ms, in which it turns 2.4 rad, miss 8."""
    fmu = text_fmu(f"{ROTOR}[solver]\nstep_size = 0.01\n")
    code, seen, err = checked(capsys, fmu)
    error = 120.0 - run_fmu(fmu).values["r.angle"][-1]
    assert error > 8.0
    assert 0.5 * error < seen["error"] < 2.0 * error
    assert code == 1  # it turns by more than 0.22 rad in a step
    assert "steps of 0.01 s are too long for this motion: it is off in angles by about" in err
    assert "('r.angle' at t = 1 s)" in err
    assert "chaos" not in err
    proposed = float(err.split("solver.step_size <= ")[-1].split()[0])
    shorter = run_fmu(fmu, settings={"solver.step_size": proposed}).values["r.angle"][-1]
    assert 0.3e-4 < abs(120.0 - shorter) < 1.5e-4  # 1e-4, from steps that are no small ones


def test_the_remedy_for_steps_that_are_too_long_leaves_out_what_is_set(capsys):
    for setting in ("step_size=0.01", "order=4"):
        code, _, err = checked(capsys, text_fmu(ROTOR), "--set", f"solver.{setting}")
        assert code == 1
        assert f"; leave solver.{setting.partition('=')[0]} out, so that steps follow" in err


def test_forces_that_are_off_are_said_where_the_path_is_exact(capsys):
    """A shaft that is driven: its places are prescribed, the torque is not."""
    text = """
    name = "shaft"
    dimension = 2
    [bodies]
    r = { position = [0, 0], mass = 1, inertia = 0.2 }
    [joints]
    j = { type = "revolute", bodies = ["ground", "r"], position = [0, 0] }
    [drivers]
    motor = { type = "angle", joint = "j", value = "3*sin(20*t)" }
    """
    _, seen, err = checked(capsys, text_fmu(text), "--set", "solver.step_size=0.01")
    assert seen["error"] < 1e-12
    assert "off in" in err
    assert "torques by about" in err
    assert "('motor.torque' at t = " in err


def test_a_top_turns_off_by_what_another_program_says(capsys):
    """Orientations are compared by the angle between them, whatever the signs of quaternions."""
    fmu = scene_fmu("heavy_top")
    _, seen, err = checked(capsys, fmu, "--set", "solver.step_size=0.005")
    found = run_fmu(fmu, settings={"solver.step_size": 0.005}).values
    exact, _ = heavy_top().motion(rotation([0.05, 0, 0]), np.array([0.0, 0.0, 50.0]), found["time"])
    ours = [matrix_of(np.array([row[f"top.q{k}"] for k in "wxyz"])) for row in found]
    cosines = [0.5 * (np.trace(a.T @ b) - 1.0) for a, b in zip(exact, ours, strict=True)]
    error = max(np.arccos(np.clip(cosines, -1.0, 1.0)))
    assert error > 0.1
    assert seen["error"] == pytest.approx(error, rel=0.1)
    assert of_kind(seen, "angles")["output"] == "top"
    assert "too long" in err


# -------------------------------------------------------------------------------------- tolerance


@pytest.mark.parametrize("tolerance", [1e-3, 1e-5])
def test_the_error_under_a_tolerance_is_that_of_elliptic_functions(capsys, tolerance):
    fmu = text_fmu(PENDULUM.replace("stop_time = 5.0", "stop_time = 20.0"))
    code, seen, err = checked(capsys, fmu, "--set", f"solver.tolerance={tolerance}", "--step", 1)
    ours = run_fmu(fmu, settings={"solver.tolerance": tolerance}, step_size=1.0).values
    angle = pendulum_angle(ours["time"], math.pi / 2)
    error = max(abs(ours["A.x"] - np.sin(angle)).max(), abs(ours["A.y"] + np.cos(angle)).max())
    assert (code, err) == (0, "")
    assert seen["finer"] == {"solver.tolerance": pytest.approx(0.1 * tolerance)}
    assert 0.5 * error < of_kind(seen, "places")["largest"] < 2.0 * error


def test_where_communication_steps_limit_steps_a_finer_run_is_found(capsys):
    """At 1e-2 and 1e-3 steps of 0.05 s are of order 5 alike."""
    values = ("--set", "solver.tolerance=0.01", "--set", "solver.method=fastest")
    _, seen, _ = checked(capsys, text_fmu(PENDULUM), *values)
    assert seen["finer"] == {"solver.tolerance": pytest.approx(1e-5)}
    assert 0.0 < seen["error"] < 1e-2


def test_a_tenth_of_the_tolerance_that_changes_hardly_a_step_does_not_tell_the_error(capsys):
    """At 1e-4 and 1e-5 nearly all steps of 0.01 s are of order 4, and both runs err alike."""
    fmu = text_fmu(PENDULUM.replace("5.0", "20.0").replace("0.05", "0.01"))
    _, seen, _ = checked(capsys, fmu)
    ours = run_fmu(fmu).values
    angle = pendulum_angle(ours["time"], math.pi / 2)
    error = max(abs(ours["A.x"] - np.sin(angle)).max(), abs(ours["A.y"] + np.cos(angle)).max())
    assert 0.5 * error < of_kind(seen, "places")["largest"] < 2.0 * error


# ------------------------------------------------------------------------------------------ chaos


@pytest.mark.parametrize(
    ("value", "failed"), [("solver.step_size=0.01", 1), ("solver.tolerance=1e-6", 0)]
)
def test_chaos_of_a_double_pendulum_is_told_with_the_time_until_which_it_is_right(
    capsys, value, failed
):
    """A double pendulum from the horizontal over 60 s; DOP853 is right to 1e-4 m until 25 s."""
    fmu = scene_fmu("double_pendulum")
    name, _, number = value.partition("=")
    code, _, err = checked(capsys, fmu, "--set", value, "--stop", 60)
    assert code == failed  # steps of 10 ms add up to more than 3 % of the size in 60 s
    said = err.splitlines()[-1]
    assert "this motion multiplies small errors" in said
    assert "too long" not in said
    until = float(err.split("until t = ")[1].split()[0])
    agreed = float(err.split("agree to ")[1].split()[0])
    ours = run_fmu(fmu, settings={name: float(number)}, stop_time=60.0).values
    ours = ours[ours["time"] <= 25.0]  # the tolerance is for the run of 60 s
    places, _ = double_pendulum_motion(ours["time"], math.pi / 2)
    columns = [[ours[f"{point}.{k}"] for k in "xy"] for point in "AB"]
    errors = abs(np.moveaxis(np.array(columns), -1, 0) - places).max(axis=(1, 2))
    size = math.hypot(4.0, 2.0)
    before = errors[ours["time"] < until].max()
    assert 0.1 * agreed * size < before < 2.0 * agreed * size
    assert errors.max() > 100.0 * agreed * size


def test_a_regular_motion_of_the_same_length_is_not_called_chaos(capsys):
    """A pendulum at 90 degrees: its phase error grows with time."""
    values = ("--set", "solver.step_size=0.01", "--stop", 60, "--step", 0.1)
    _, seen, err = checked(capsys, scene_fmu("pendulum"), *values)
    assert seen["error"] > 1e-3
    assert "multiplies" not in err
    assert "too long" in err


def test_a_ball_whose_spin_has_just_begun_is_not_called_chaos(capsys):
    """It slides until it rolls: what grows is the spin, and with it the error of long steps."""
    _, seen, err = checked(capsys, scene_fmu("putting_green"), "--set", "solver.order=2")
    assert seen["error"] > 1.0
    assert "multiplies" not in err
    assert "too long" in err


# ------------------------------------------------------------------------------- what is compared


def compared(a, b, units, times=(0.0, 1.0)):
    """Two runs of columns by name."""
    a, b = ({name: np.array(x, float) for name, x in run.items()} for run in (a, b))
    return Comparison(np.array(times), a, b, units, 1.0)


def test_angles_of_formulas_may_jump_by_a_turn_and_those_of_parts_may_not():
    a, b = ({"way": [0.0, x], "rod.angle": [0.0, y]} for x, y in ((3.14, 0.1), (-3.14, 6.383)))
    seen = compared(a, b, {"way": "rad", "rod.angle": "rad"})
    assert (seen.differences["rad"].name, seen.path) == ("rod.angle", pytest.approx(6.283))
    alone = compared({"way": a["way"]}, {"way": b["way"]}, {"way": "rad"})
    assert alone.path == pytest.approx(2 * math.pi - 6.28)


def test_quaternions_of_other_sign_are_the_same_orientation():
    half = 0.5 * 0.02
    a = {f"b.q{k}": [x, x] for k, x in zip("wxyz", (1.0, 0.0, 0.0, 0.0), strict=True)}
    turned = (-math.cos(half), 0.0, -math.sin(half), 0.0)
    b = {f"b.q{k}": [-a[f"b.q{k}"][0], x] for k, x in zip("wxyz", turned, strict=True)}
    seen = compared(a, b, dict.fromkeys(a, "1"))
    assert seen.path == pytest.approx(0.02)
    assert (seen.differences["rad"].name, seen.differences["rad"].time) == ("b", 1.0)


def test_what_says_how_exact_a_run_is_is_left_out():
    units = {
        "solver.longest": "m", "constraint.velocity": "1/s", "energy.total": "J", "body.hits": "1",
    }  # fmt: skip
    a, b = ({name: [x, x] for name in units} for x in (1.0, 2.0))
    assert compared(a, b, units).is_none


@pytest.mark.parametrize(
    "judged", [lambda x: of_equal_steps(x, 2, 0.1), lambda x: of_a_tolerance(x, 1e-4)]
)
def test_runs_that_are_the_same_show_nothing(judged):
    a = {"A.x": [0.0, 1.0]}
    found = judged(compared(a, a, {"A.x": "m"}))
    assert (found.error, found.is_warning) == (0.0, False)
    assert "does not show" in found.sentence


@pytest.mark.parametrize(("power", "begin"), [(1, 0.0), (2, 0.0), (4, 0.0), (2, 7.0)])
def test_errors_that_add_up_are_no_chaos_wherever_they_begin(power, begin):
    times = np.linspace(0.0, 10.0, 201)
    error = 0.5 * (np.maximum(times - begin, 0.0) / (10.0 - begin)) ** power + 1e-17 * times
    zero = {"A.x": 0.0 * times}
    seen = compared(zero, {"A.x": error}, {"A.x": "m"}, times)
    assert "too long" in of_equal_steps(seen, 2, 0.1).sentence
    grown = compared(zero, {"A.x": 1e-6 * np.exp(1.3 * times)}, {"A.x": "m"}, times)
    assert "multiplies" in of_equal_steps(grown, 2, 0.1).sentence
    assert grown.growth[1] == pytest.approx(math.log(10.0) / 1.3, rel=0.05)


# ------------------------------------------------------------------------ commands and exit codes


@pytest.mark.parametrize(("limit", "code", "word"), [(1e-2, 0, "yes"), (1e-6, 1, "NO")])
def test_a_limit_of_accuracy_is_tested_as_the_others(capsys, limit, code, word):
    values = ("--set", "solver.step_size=0.01", "--accuracy", limit)
    found, out, _ = run(capsys, "check", text_fmu(PENDULUM), *values)
    assert found == code
    row = next(line for line in out.splitlines() if line.startswith("error of the path"))
    assert row.split()[-1] == word


def test_the_table_names_the_worst_output_of_each_kind(capsys):
    code, out, err = run(capsys, "check", text_fmu(PENDULUM), "--set", "solver.step_size=0.001")
    assert (code, err) == (0, "")
    assert "differences from a run with solver.step_size = 0.0005" in out
    assert [line.split()[0] for line in out.splitlines()[-5:-2]] == [
        "places",
        "velocities",
        "forces",
    ]
    assert "its path is off by about" in out


def test_what_does_not_move_is_not_repeated(capsys):
    fmu = text_fmu(PENDULUM.replace("-9.81", "0"))
    _, out, err = run(capsys, "check", fmu, "--json")
    assert "accuracy" not in json.loads(out)
    assert err == ""
    code, out, err = run(capsys, "check", fmu, "--accuracy", 1e-3)
    assert (code, err) == (0, "")
    assert out.splitlines()[-1] == "nothing moved, so that no error of the path is measured"


def test_both_runs_have_the_same_inputs(capsys, tmp_path):
    """A mass that is pushed by a constant force moves exactly as 2 t^2, at any step."""
    text = """
    name = "pushed"
    dimension = 2
    [inputs]
    push = { start = 0.0, unit = "N" }
    [points]
    A = { position = [0, 0], mass = 1.0 }
    [forces]
    f = { type = "force", point = "A", value = ["push", 0] }
    """
    (tmp_path / "in.csv").write_text("time,push\n0,4\n1,4\n")
    _, seen, err = checked(capsys, text_fmu(text), "--inputs", tmp_path / "in.csv")
    assert err == ""
    assert of_kind(seen, "places")["largest"] < 1e-12
    assert run(capsys, "check", text_fmu(text), "--set", "push=4", "--json")[0] == 0


def test_an_fmu_that_hides_its_settings_is_measured_as_well(capsys, tmp_path):
    """With `[fmu] parameters` of its own, `solver.step_size` is no port."""
    fmu = build(solver.loads(f"{PENDULUM}[fmu]\nparameters = []\n"), tmp_path / "hides.fmu")
    hidden, open_ = (checked(capsys, path)[1] for path in (fmu, text_fmu(PENDULUM)))
    assert hidden == open_


def test_a_finer_run_that_fails_leaves_the_accuracy_open_and_fails_a_limit():
    fmu = str(text_fmu(f"{PENDULUM}[solver]\nstep_size = 0.01\n"))
    coarse = run_fmu(fmu, with_local=True)
    found = accuracy(fmu, {}, coarse, lambda _: replace(coarse, finished=False, reason="it broke"))
    assert found.verdict.is_warning
    assert "was not measured: with solver.step_size = 0.005 the run ended" in found.verdict.sentence
    assert not found.verdict.error <= 1.0


def test_an_absolute_tolerance_adds_to_the_relative_one(capsys):
    """1 mm of a pendulum of 1 m: a finer run has a tenth of both."""
    values = ("--set", "solver.tolerance=1e-6", "--set", "solver.absolute_tolerance=1e-3")
    code, seen, err = checked(capsys, text_fmu(PENDULUM), *values, "--step", 1)
    assert (code, err) == (0, "")
    assert seen["finer"] == pytest.approx(
        {"solver.tolerance": 1e-7, "solver.absolute_tolerance": 1e-4}
    )
    assert 1e-6 < of_kind(seen, "places")["largest"] < 1e-3
