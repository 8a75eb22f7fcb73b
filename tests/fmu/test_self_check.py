"""The run that a build makes: what its page says of errors, of size, and of what is at rest."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

import solver
from build_fmu.documentation import accuracy, solved
from build_fmu.motion import Poses
from build_fmu.self_check import SelfCheck, self_check
from tests.support.fmus.fmu_instance import SCENES
from tests.support.mechanisms.reduced_models import heavy_top, matrix_of, rotation

OF_HALF_A_STEP = 4.0 / 3.0
"""Error of a step of order 2, over the difference to half of it."""


def test_a_trial_that_fails_is_no_obstacle_and_is_told():
    text = """
    name = "doomed"
    dimension = 2
    [points]
    A = { position = [1, 0], mass = 1.0 }
    [forces]
    push = { type = "force", point = "A", value = ["sqrt(0.25 - t)", 0] }
    """
    seen = self_check(solver.assemble(solver.loads(text)))
    assert 0.1 <= seen.duration <= 0.25
    assert "grew beyond all bounds" in seen.reason
    assert (seen.position_error, seen.rotation_error) == (None, None)


def test_twice_as_fine_a_run_halves_the_step_and_shows_the_error_of_second_order():
    """Error of a pendulum with step h is near 4/3 of the difference to half the step."""
    equal = {"solver.step_size": 0.01}
    model = solver.assemble(solver.load(SCENES / "pendulum.toml", equal))
    seen = self_check(model)
    exact = solver.simulate(model, stop_time=seen.duration, step_size=0.05, order=8)
    coarse = solver.simulate(model, stop_time=seen.duration, step_size=0.05)
    names = [v.name for v in model.variables if v.unit == "m" and v.name[-2:] in (".x", ".y", ".z")]
    error = max(abs(exact[name] - coarse[name]).max() for name in names)
    assert error == pytest.approx(4.0 / 3.0 * seen.position_error, rel=0.2)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6])
def test_a_run_with_a_hundredth_of_the_tolerance_shows_the_error_of_the_tolerance(tolerance):
    """Of the same run, whose steps are chosen for the whole experiment."""
    model = solver.assemble(
        solver.load(SCENES / "double_pendulum.toml", {"solver.tolerance": tolerance})
    )
    seen = self_check(model)
    exact, coarse = solver.simulate(model, tolerance=1e-12), solver.simulate(model)
    looked = exact.t < seen.duration + 1e-9
    names = [v.name for v in model.variables if v.unit == "m" and v.name[-2:] in (".x", ".y", ".z")]
    error = max(abs(exact[name] - coarse[name])[looked].max() for name in names)
    assert seen.position_error == pytest.approx(error, rel=0.2)
    assert "a hundredth of the tolerance" in accuracy(model, seen)
    same = replace(seen, position_error=0.0)
    assert accuracy(model, same).endswith("gave the same, and does not show how exact that is.")


# ------------------------------------------------------------------------------------- rotations


def rotation_error(text: str) -> float:
    """The number of a page in rad."""
    return float(re.search(r"([0-9.e+-]+) rad", text)[1])


def test_the_rotation_error_of_the_page_is_that_of_a_top_by_another_program():
    """Within 2 s the tip of the nose is off by 2e-6 m, and the top by 8 mrad."""
    model = solver.assemble(solver.load(SCENES / "heavy_top.toml"))
    page = accuracy(model, self_check(model))
    assert "it ran for 2 s." in page
    assert "In these 2 s " in page
    found = solver.simulate(model)
    exact, _ = heavy_top().motion(rotation([0.05, 0, 0]), np.array([0.0, 0.0, 50.0]), found.t)
    ours = [matrix_of(np.array([found[f"top.q{k}"][i] for k in "wxyz"])) for i in range(len(exact))]
    cosines = [0.5 * (np.trace(a.T @ b) - 1.0) for a, b in zip(exact, ours, strict=True)]
    error = max(np.arccos(np.clip(cosines, -1.0, 1.0)))
    assert error > 0.005
    assert error == pytest.approx(OF_HALF_A_STEP * rotation_error(page), rel=0.1)


PENDULUM = """
name = "swing"
dimension = 2
gravity = [0, -9.81]
[bodies]
rod = { position = [1, 0], mass = 1.0, inertia = 0.3 }
[joints]
pin = { type = "revolute", bodies = ["ground", "rod"], position = [0, 0] }
[solver]
step_size = 0.02
[experiment]
stop_time = 2.0
"""


def test_the_rotation_error_in_the_plane_is_that_of_the_angle():
    model = solver.assemble(solver.loads(PENDULUM))
    seen = self_check(model)
    times = {"stop_time": seen.duration, "step_size": 0.1, "outputs": ["rod.angle"]}
    fine = solver.simulate(model, **times, order=8, internal_step=0.005)
    error = abs(solver.simulate(model, **times)["rod.angle"] - fine["rod.angle"]).max()
    assert error == pytest.approx(OF_HALF_A_STEP * seen.rotation_error, rel=0.1)


def test_points_alone_have_no_rotation_error():
    model = solver.assemble(solver.loads("""
    name = "falls"
    gravity = [0, 0, -9.81]
    [points]
    A = { position = [1, 0, 0], mass = 1.0 }
    """))  # fmt: skip
    seen = self_check(model)
    assert seen.position_error is not None
    assert seen.rotation_error is None
    assert "rad" not in accuracy(model, seen)


# ---------------------------------------------------------------------------------------- at rest


def test_the_page_of_what_does_not_move_has_no_errors():
    model = solver.assemble(solver.loads(PENDULUM.replace("-9.81", "0")))
    seen = self_check(model)
    assert not seen.moved
    page = accuracy(model, seen)
    assert "Nothing moved" in page
    assert "e+00" not in page


def test_what_turns_on_the_spot_moves():
    model = solver.assemble(solver.loads("""
    name = "spins"
    [bodies]
    disc = { position = [0, 0, 0], mass = 1.0, inertia = [1, 1, 2], angular_velocity = [0, 0, 1] }
    """))  # fmt: skip
    assert self_check(model).moved


def test_of_an_fmu_without_positions_nothing_is_said():
    assert Poses({"pressure": "Pa"}).moved(np.empty((3, 0)))


# ------------------------------------------------------------------------------------------- size


@pytest.mark.parametrize("bodies", [1, 2])
def test_sentences_on_size_have_the_right_plural(bodies):
    points = "".join(f"P{i} = {{ position = [{i}, 0], mass = 1.0 }}\n" for i in range(bodies))
    model = solver.assemble(solver.loads(f'name = "x"\ndimension = 2\n[points]\n{points}'))
    sentences = solved(model, SelfCheck(duration=1.0))
    assert "(s)" not in sentences
    assert ("parts" in sentences) == (bodies > 1)
    assert sentences.startswith(f"{2 * bodies} coordinates and 0 constraint rows")


def test_outputs_named_as_parts_of_a_quaternion_are_one_only_if_all_four_are_there():
    four = {f"a.q{k}": "1" for k in "wxyz"}
    assert Poses(four).turn
    for name in four:
        assert not Poses({other: unit for other, unit in four.items() if other != name}).turn
