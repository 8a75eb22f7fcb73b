"""Inputs that change during a run, from a file or arrays."""

from __future__ import annotations

import numpy as np
import pytest

from build_fmu.errors import UsageError
from build_fmu.run import run_fmu
from tests.commands import run
from tests.fmu_instance import text_fmu

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


def test_a_force_that_grows_moves_a_mass_as_its_integral_says():
    ramp = {"time": [0.0, 1.0], "push": [0.0, 4.0]}
    found = run_fmu(text_fmu(CART), stop_time=2.0, step_size=H, inputs=ramp).values
    t = found["time"]
    # dv/dt = 2 t until 1 s, then 2. Held over a communication step it is too small by H in the
    # mean, so that v lacks H after 1 s.
    exact = np.where(t < 1.0, t**2, 2.0 * t - 1.0)
    assert np.abs(found["A.vx"] - exact).max() < H + 1e-12
    assert found["A.vy"] == pytest.approx(0.25 / 2.0 * t, abs=1e-12)  # no column: its start value


def test_an_input_without_a_column_keeps_its_value():
    ramp = {"time": [0.0, 1.0], "push": [0.0, 4.0]}
    found = run_fmu(
        text_fmu(CART), stop_time=1.0, step_size=H, settings={"lift": 2.0}, inputs=ramp
    ).values
    assert found["A.vy"][-1] == pytest.approx(1.0, abs=1e-12)


def test_a_file_of_inputs_drives_a_run_of_the_command_line(capsys, tmp_path):
    scene, file = tmp_path / "cart.toml", tmp_path / "push.csv"
    scene.write_text(CART)
    file.write_text("time,push\n0,1\n1,1\n")
    csv = tmp_path / "out.csv"
    arguments = ("--inputs", file, "--stop", "1", "--step", "0.5", "--csv", csv)
    code, _, _ = run(capsys, "simulate", scene, *arguments)
    assert code == 0
    rows = np.genfromtxt(csv, delimiter=",", names=True, deletechars="")
    assert rows["A.vx"][-1] == pytest.approx(0.5, abs=1e-12)


@pytest.mark.parametrize(
    ("inputs", "settings", "report"),
    [
        ({"time": [0, 1], "pusch": [0, 1]}, {}, "cart has no input 'pusch'\n  = help: did you"),
        ({"time": [0, 1], "A.x": [0, 1]}, {}, "cart has no input 'A.x'"),
        ({"time": [0, 1], "push": [0, 1]}, {"push": 1.0}, "push: there is a value for the whole"),
        ({"time": [0, 1]}, {}, "has no column of an input\n  = help: there are push, lift"),
        ({"time": [1, 0], "push": [0, 1]}, {}, "time must ascend"),
        ({"time": [0, 1], "push": [0, float("nan")]}, {}, "push: must be finite numbers"),
    ],
    ids=str,
)
def test_mistakes_of_inputs_are_sentences(inputs, settings, report):
    with pytest.raises(UsageError) as mistake:
        run_fmu(text_fmu(CART), settings=settings, inputs=inputs)
    assert report in str(mistake.value)
