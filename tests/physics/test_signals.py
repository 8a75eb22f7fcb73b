"""Inputs that change during a run: from a file, arrays or functions, in an FMU and in Python."""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from build_fmu.errors import UsageError
from build_fmu.run import run_fmu
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import text_fmu

CART = """
name = "cart"
dimension = 2
[inputs]
push = { unit = "N", start = 0.5 }
lift = { unit = "N", start = 0.25 }
[points]
A = { position = [0, 0], mass = 2.0 }
[forces]
hand = { type = "force", point = "A", value = ["push", "lift"] }
"""
H = 0.01


def test_an_input_without_a_column_keeps_its_value():
    ramp = {"time": [0.0, 1.0], "push": [0.0, 4.0]}
    found = run_fmu(
        text_fmu(CART), stop_time=1.0, step_size=H, settings={"lift": 2.0}, inputs=ramp
    ).values
    assert found["A.vy"][-1] == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize(
    ("inputs", "settings", "report"),
    [
        ({"time": [0, 1], "pusch": [0, 1]}, {}, "cart has no input 'pusch'\n  = help: did you"),
        ({"time": [0, 1], "A.x": [0, 1]}, {}, "cart has no input 'A.x'"),
        ({"time": [0, 1], "push": [0, 1]}, {"push": 1.0}, "push: there is a value for the whole"),
        ({"time": [0, 1]}, {}, "has no column of an input\n  = help: known: push, lift"),
        ({"time": [1, 0], "push": [0, 1]}, {}, "time must ascend"),
        ({"time": [0, 1], "push": [0, float("nan")]}, {}, "push: must be finite numbers"),
    ],
    ids=str,
)
def test_mistakes_of_inputs_are_sentences(inputs, settings, report):
    with pytest.raises(UsageError) as mistake:
        run_fmu(text_fmu(CART), settings=settings, inputs=inputs)
    assert report in str(mistake.value)


# --------------------------------------------------------------------- the same in the solver

RAMPED = CART.replace("start = 0.25", 'start = 0.25, interpolation = "ramp"')
RAMP = {"time": [0.2, 0.7, 1.5], "push": [1.0, -2.0, 4.0], "lift": [0.0, 3.0, 3.5]}
SIGNALS = {
    "arrays": RAMP,
    "functions": {"push": lambda t: 2.0 * t, "lift": math.cos},
    "both": {"time": [0.0, 1.0], "push": np.array([0.0, 4.0]), "lift": math.sin},
    "a number": {"time": (0.0, 1.0), "push": [0.0, 4.0], "lift": 2.0},
    "numbers": {"push": 1.0, "lift": 2.0},
}


@pytest.mark.parametrize("scene", [CART, RAMPED], ids=["held", "ramped"])
@pytest.mark.parametrize("signals", SIGNALS)
def test_the_solver_moves_as_the_fmu_with_the_same_inputs(scene, signals):
    """Bit for bit, and both have the inputs as columns."""
    inputs = SIGNALS[signals]
    times = {"stop_time": 1.95, "step_size": 0.1}
    ours = solver.simulate(solver.loads(scene), inputs=inputs, **times)
    fmus = run_fmu(text_fmu(scene), inputs=inputs, **times).values
    assert {*ours} == {*fmus.dtype.names} - {"time"}
    assert "push" in ours
    for name, values in ours.items():
        assert values.tolist() == fmus[name].tolist()
    assert ours["A.vx"][-1] != 0.0


def test_inputs_in_the_results_are_those_of_the_times_of_the_rows():
    found = run_fmu(text_fmu(CART), stop_time=2.0, step_size=0.25, inputs=RAMP).values
    assert found["push"] == pytest.approx(np.interp(found["time"], RAMP["time"], RAMP["push"]))
    assert run_fmu(text_fmu(CART), stop_time=1.0).values["push"].tolist() == [0.5] * 101


def test_the_file_of_a_run_has_the_inputs_as_columns(capsys, tmp_path):
    scene, file, csv = tmp_path / "cart.toml", tmp_path / "push.csv", tmp_path / "out.csv"
    scene.write_text(CART)
    file.write_text("time,push\n0,1\n1,3\n")
    assert run(capsys, "simulate", scene, "--inputs", file, "--csv", csv)[0] == 0
    rows = np.genfromtxt(csv, delimiter=",", names=True, deletechars="")
    assert rows["push"] == pytest.approx(1.0 + 2.0 * rows["time"], abs=1e-12)
    assert set(rows["lift"]) == {0.25}


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ({"push": [0, 1]}, "inputs: has no column 'time'; columns: push"),
        ({"time": [1, 0], "push": [0, 1]}, "inputs: time must ascend"),
        ({"time": [0, 1], "push": [0, 1, 2]}, "inputs: push: not one value for each time"),
        ({"time": [0, 1], "push": [0, "a"]}, "inputs: push: not numbers"),
        ({"push": lambda _: math.nan}, "inputs: push: must be finite numbers"),
        ({"push": lambda _: None}, "inputs: push: must be finite numbers"),
        ({"push": lambda _: 10**400}, "inputs: push: must be finite numbers"),
        ({"time": [0, 1], "push": [0, 10**5000]}, "inputs: push: must be finite numbers"),
        ({"time": [0, 1], "pusch": [0, 1]}, "'pusch'; did you mean 'push'"),
        ({"A.x": lambda t: t}, "A.x: is calculated"),
        ({"time": lambda t: t, "push": [0, 1]}, "inputs: 'time' must be an array"),
        ({"push": "a"}, "push: must be a finite number in N"),
    ],
    ids=range(12),
)
def test_mistakes_of_inputs_in_python_are_sentences(inputs, words):
    with pytest.raises(solver.OptionError, match=words):
        solver.simulate(solver.loads(CART), inputs=inputs)


# ------------------------------------------------------------------------- files that begin late


@pytest.mark.parametrize("command", ["simulate", "check"])
@pytest.mark.parametrize(("first", "late"), [(0, False), (-1, False), (0.5, True)])
def test_a_file_of_inputs_that_begins_late_is_noted(capsys, tmp_path, command, first, late):
    scene, file = tmp_path / "cart.toml", tmp_path / "push.csv"
    scene.write_text(CART)
    file.write_text(f"time,push\n{first},2\n1,2\n")
    code, _, err = run(capsys, command, scene, "--inputs", file)
    assert code == 0
    note = f"{file}: begins at t = 0.5 s; from 0 s until then the inputs have the values of its"
    assert err == (f"{note} first row\n" if late else "")


@pytest.mark.parametrize("largest", [0.0, 0.5, 0.995])
def test_every_value_of_a_changing_input_is_checked_the_last_one_too(largest):
    scene = solver.loads(CART.replace("start = 0.5", f"start = 0, max = {largest}"))
    with pytest.raises(solver.OptionError, match=f"push: must be <= {largest:g} N"):
        solver.simulate(scene, inputs={"push": lambda t: t})
