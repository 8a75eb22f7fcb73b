"""Inertias printed with a few digits: accepted as far as their digits tell, mended, and told."""

from __future__ import annotations

import json
import math
import random
import warnings

import numpy as np
import pytest

from solver import SceneError, SceneWarning, loads, simulate
from solver.scene import Rigid

HEAD = 'name = "plate"\n[parameters]\nk = 2\n[bodies.b]\nposition = [0, 0, 0]\nmass = 1\n'


def read(inertia: str, **overrides: object) -> tuple[np.ndarray, list[str]]:
    """Inertia of the body that a file writes so, and the warnings of the scene."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SceneWarning)
        text = f"{HEAD}inertia = {inertia}\nangular_velocity = ['k', 0, 0]\n"
        scene = loads(text, overrides=overrides)
    body = scene.bodies["b"]
    assert isinstance(body, Rigid)
    assert all(warning.location == "bodies.b.inertia" for warning in scene.warnings)
    return np.array(body.inertia), [warning.message for warning in scene.warnings]


def is_of_a_body(J: np.ndarray) -> bool:
    """Whether no moment is above the sum of the others, but for round-off."""
    moments = np.linalg.eigvalsh(J)
    return moments[2] <= (moments[0] + moments[1]) * (1 + 1e-12) and moments[0] >= -1e-15


def turned(moments: list[float], seed: int) -> np.ndarray:
    """Inertia of a plate in axes that lie anyhow."""
    axes = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return axes @ np.diag(moments) @ axes.T


def printed(J: np.ndarray, form: str) -> str:
    """Text of a matrix, or of moments, with so many digits."""
    if J.ndim == 1:
        return "[" + ", ".join(format(x, form) for x in J) + "]"
    return "[" + ", ".join(printed(row, form) for row in J) + "]"


@pytest.mark.parametrize("form", [".4f", ".6f", ".8f", ".12f", ".4g", ".6g", ".10g"])
@pytest.mark.parametrize("turn", [False, True])
def test_a_plate_printed_with_any_digits_is_a_body_within_them(form, turn):
    """Of moments from 0.1 to 10 kg.m2; the mended inertia is as near as the digits."""
    numbers = random.Random(form)
    mended = 0
    for seed in range(40):
        a, b = (10 ** numbers.uniform(-1, 0.7) for _ in range(2))
        exact = turned([a, b, a + b], seed) if turn else np.diag([a, b, a + b])
        J, told = read(printed(exact if turn else np.diag(exact), form))
        assert is_of_a_body(J)
        digits = int(form[1:-1])
        unit = 10.0**-digits if form[-1] == "f" else 10.0 ** (math.ceil(math.log10(a + b)) - digits)
        assert np.abs(J - exact).max() <= 2.0 * unit
        mended += len(told)
        assert len(told) <= 1
    assert 0 < mended < 40


def test_moments_become_the_nearest_that_a_body_can_have_and_the_warning_says_so():
    J, told = read("[0.3333, 0.3333, 0.6667]")
    assert np.diag(J) == pytest.approx([1 / 3, 1 / 3, 2 / 3], rel=1e-12)
    (sentence,) = told
    assert "Jz = 0.6667 > Jx + Jy = 0.6666 kg.m2" in sentence
    assert "[0.333333333333, 0.333333333333, 0.666666666667]" in sentence


@pytest.mark.parametrize(
    "inertia",
    [
        "[1, 1, 3]", "[1, 1, 2.0001]", "[0.3, 0.3, 0.8]",  # no digits explain these
        "[0.3333, 0.3333, 0.6669]", "[0.333333, 0.333333, 0.6668]",
        "[0.3333, 0.3333, 0.66670000]",  # the last one is given with more digits
        "[0.3330, 0.3330, 0.6670]",  # zeros are digits
        "[-0.0002, 0.3333, 0.3333]",
        "['0.3333', '0.3333', '0.6667']", "['0.1*k', '0.1*k', '0.2001*k']",  # formulas have none
        "[[0.5, 0.1, 0], [0.1, 0.5, 0], [0, 0, 1.0021]]",
    ],
)  # fmt: skip
def test_what_digits_do_not_explain_is_refused(inertia):
    with pytest.raises(SceneError, match="inertia that no body can have"):
        read(inertia)


def test_a_rod_printed_in_axes_of_its_own_loses_its_negative_moment():
    negative = 0
    for seed in range(20):
        exact = turned([0.0, 1 / 3, 1 / 3], seed)
        J, _ = read(printed(exact, ".4f"))
        assert is_of_a_body(J)
        assert np.abs(J - exact).max() <= 2e-4
        negative += np.linalg.eigvalsh(np.round(exact, 4))[0] < 0.0
    assert negative > 0


@pytest.mark.parametrize("inertia", ["[1.0, 2.0, 3.0000002]", "['k', 'k', '2*k*(1 + 5e-8)']"])
def test_less_than_the_inertia_that_a_flat_body_gets_is_forgiven(inertia):
    """1e-7 of the longest one, also of formulas and of numbers with all their digits."""
    _, told = read(inertia)
    assert len(told) == 1


@pytest.mark.parametrize("inertia", ["[1, 2, 3]", "[0.1, 0.2, 0.3]", "['k', 'k', '2*k']"])
def test_round_off_is_not_told(inertia):
    assert read(inertia)[1] == []


def test_digits_of_an_override_and_of_json_count_likewise():
    written = {"bodies.b.inertia": [0.3333, 0.3333, 0.6667]}
    assert len(read("[1, 1, 1]", **written)[1]) == 1
    with pytest.raises(SceneError, match="no body can have"):
        read("[1, 1, 1]", **{"bodies.b.inertia": [0.3333, 0.3333, 0.6669]})
    body = {"position": [0, 0, 0], "mass": 1, "inertia": [0.3333, 0.3333, 0.6667]}
    with pytest.warns(SceneWarning, match="Jz = 0.6667"):
        loads(json.dumps({"name": "plate", "bodies": {"b": body}}), format="json")


def test_a_printed_plate_turns_as_the_plate():
    """About an axis in its plane, which its digits leave 1/3 kg.m2: with 2 N.m at 6 rad/s2."""
    text = HEAD + "inertia = [0.3333, 0.3333, 0.6667]\n"
    text += '[forces]\nturn = { type = "torque", body = "b", value = ["k", 0, 0] }\n'
    with pytest.warns(SceneWarning):
        scene = loads(text)
    run = simulate(scene, stop_time=0.5, step_size=0.1)
    assert run["b.wx"][-1] == pytest.approx(3.0, rel=1e-6)
