"""A driver starts as its formula goes on after the start, whatever the formula is before."""

from __future__ import annotations

import math

import numpy as np
import pytest

import holonom

SCENE = """
name = "driven"
dimension = {dimension}
[bodies]
arm = {{ mass = 1, inertia = {inertia}, position = {origin} }}
[joints]
pin = {{ type = "revolute", bodies = ["ground", "arm"], position = {origin}{axis} }}
[drivers]
motor = {{ type = "angle", joint = "pin", value = "{value} - 0.3" }}
[experiment]
stop_time = 0.1
"""


def run(dimension: int, value: str) -> holonom.Trajectory:
    spatial = dimension == 3
    scene = SCENE.format(
        dimension=dimension,
        inertia="[1, 1, 1]" if spatial else 1,
        origin="[0, 0, 0]" if spatial else "[0, 0]",
        axis=", axis = [0, 0, 1]" if spatial else "",
        value=value,
    )
    return holonom.simulate(holonom.loads(scene))


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize(
    ("value", "same"),
    [
        ("0.3 + 2*max(t, 0) + 3*t**2", "0.3 + 2*t + 3*t**2"),
        ("0.3 + 2*abs(t) + 3*max(t, 0)**2", "0.3 + 2*t + 3*t**2"),
        ("0.3 + 3*max(t, 0)**2", "0.3 + 3*t**2"),
        ("0.3 + 100*t + 0.05*max(t, 0)", "0.3 + 100.05*t"),
        ("0.3 + 2*mod(t, 10) + 3*t**2", "0.3 + 2*t + 3*t**2"),
        ("0.3 + 7*floor(t) + 2*t + 3*t**2", "0.3 + 2*t + 3*t**2"),
        ("0.3 + 2*sqrt(t)**2 + 3*t**2", "0.3 + 2*t + 3*t**2"),
        ("0.8 - 0.5*cos(max(t, 0))", "0.8 - 0.5*cos(t)"),
    ],
)
def test_what_a_formula_is_before_the_start_does_not_matter(dimension, value, same):
    smooth, bent = run(dimension, same), run(dimension, value)
    for name in (name for name in smooth if not name.startswith("solver.")):
        # The jet of sqrt(t)^2 is 0 times infinity at 0: its limit is extrapolated.
        scale = max(1.0, float(np.max(np.abs(smooth[name]))))
        np.testing.assert_allclose(
            bent[name], smooth[name], rtol=0, atol=1e-6 * scale, err_msg=name
        )


def test_a_driver_starts_with_the_rate_and_the_torque_of_its_formula():
    trajectory = run(2, "0.3 + 2*max(t, 0) + 3*max(t, 0)**2")
    assert trajectory["pin.angular_velocity"][0] == pytest.approx(2.0, rel=1e-9)
    assert trajectory["motor.torque"][0] == pytest.approx(6.0, rel=1e-6)


POINT = """
name = "hand"
dimension = 2
[points]
B = {{ position = [{x}, 0], mass = 1 }}
[drivers]
hand = {{ type = "position", point = "B", value = ["{value}", "0"] }}
[solver]
{settings}
[experiment]
step_size = 1e-3
stop_time = 1e-3
"""

FORMULAS = {
    "2 + 0.5*sin(t)": (2.0, 0.0),
    "exp(0.7*t)*cos(2*t)": (1.0, 0.49 - 4.0),
    "(t + 2)**3/4 - 2/(t + 1)": (0.0, 3.0 - 4.0),
    "(t + 1)**(t + 1)": (1.0, 2.0),
    "1.5*atan2(t, 2 + t)": (0.0, -0.75),
    "log(1 + t) + sqrt(4 + t) - 2": (0.0, -1.0 - 1 / 32),
    "asin(t/2 + 0.5) - pi/6": (0.0, 0.5 * 0.25 / 0.75**1.5),
    "acos(t/2 + 0.5) - pi/3": (0.0, -0.5 * 0.25 / 0.75**1.5),
    "atan(1 + t) + tan(t) - pi/4": (0.0, -0.5),
    "sinh(t) + cosh(2*t) + tanh(t)": (1.0, 4.0),
    "min(t**2, t) + max(t**3, 3*t**2) + abs(-t**2)": (0.0, 2.0 + 6.0 + 2.0),
    "7*mod(2 - t**2, 1) - 7": (0.0, -14.0),
    "(5*t**2 if t > 0 else 1) + floor(-t) + ceil(t) + sign(t) - 1": (0.0, 10.0),
}
"""Of the time: place and acceleration of a point of 1 kg at 0, by hand."""


@pytest.mark.parametrize("settings", ["step_size = 1e-6", "step_size = 1e-3", "tolerance = 1e-6"])
@pytest.mark.parametrize("value", FORMULAS)
def test_a_driver_of_any_formula_starts_with_its_exact_force(value: str, settings: str) -> None:
    x, force = FORMULAS[value]
    scene = POINT.format(x=x, value=value, settings=settings)
    found = holonom.simulate(holonom.loads(scene), stop_time=1e-3)["hand.force.x"][0]
    assert found == pytest.approx(force, rel=1e-14, abs=1e-14)


LIMITS = {
    "sqrt(t**2)": (0.0, 1.0, 0.0),
    "sqrt(t**4)": (0.0, 0.0, 2.0),
    "3*(t**4)**0.5 + t": (0.0, 1.0, 6.0),
    "sqrt(t)*sqrt(t**3)": (0.0, 0.0, 2.0),
    "sqrt(4*t**2 + t**3)": (0.0, 2.0, 0.5),
    "sqrt(2 - 2*cos(t))": (0.0, 1.0, 0.0),
    "sqrt(2 - 2*cos(300*t)) / 300": (0.0, 1.0, 0.0),
    "hypot": (0.0, 1.0, 0.0),
    "acos(cos(t))": (0.0, 1.0, 0.0),
    "acos(1 - t**2)": (0.0, math.sqrt(2.0), 0.0),
    "asin(1 - t**4) - pi/2": (0.0, 0.0, -2.0 * math.sqrt(2.0)),
    "t + t**2 if t**3 > 0 else 0": (0.0, 1.0, 2.0),
    "t**2*sign(t**5) + floor(-t**3) + ceil(t**3)": (0.0, 0.0, 2.0),
    "sqrt(max(0*t, 0)) + t**2": (0.0, 0.0, 2.0),
    "sqrt(t**7) + t**2": (0.0, 0.0, 2.0),
    "t**2*sqrt(t) + t": (0.0, 1.0, 0.0),
    "2*(t**5)**0.5": (0.0, 0.0, 0.0),
}
"""Of formulas whose derivatives at 0 are 0/0: place, rate and acceleration there, by hand.

sqrt(2 - 2 cos t) = 2 sin(t/2); acos(1 - t^2) = 2 asin(t/sqrt 2) = sqrt 2 t + O(t^3).
"""


@pytest.mark.parametrize("value", LIMITS)
def test_a_driver_starts_with_the_limits_of_its_derivatives(value: str) -> None:
    x, rate, force = LIMITS[value]
    formula = "sqrt((1 - cos(t))**2 + sin(t)**2)" if value == "hypot" else value
    scene = POINT.format(x=x, value=formula, settings="")
    found = holonom.simulate(holonom.loads(scene), stop_time=1e-3)
    assert found["B.vx"][0] == pytest.approx(rate, abs=1e-9)
    assert found["hand.force.x"][0] == pytest.approx(force, abs=1e-7)


@pytest.mark.parametrize(
    ("value", "what"),
    [
        ("sqrt(t)", "rate"),
        ("t**0.9 + t", "rate"),
        ("asin(1 - t) - pi/2", "rate"),
        ("2*t + t**1.5", "second derivative"),
        ("t + sqrt(t**3)", "second derivative"),
        ("t**2*log(t + 1e-320)/t", "value"),
        ("sin(t)/t", "value"),
    ],
)
def test_a_driver_that_would_start_infinitely_fast_is_refused_by_its_name(value, what):
    scene = POINT.format(x=0.0, value=value, settings="")
    with pytest.raises(holonom.SceneError, match=f"the {what} of driver 'hand': it has no finite"):
        holonom.simulate(holonom.loads(scene), stop_time=1e-3)


def test_a_driver_that_becomes_infinitely_fast_ends_the_run_by_its_name():
    scene = SCENE.format(
        dimension=2, inertia=1, origin="[0, 0]", axis="", value="0.3 + sqrt(abs(t - 0.25)) - 0.5"
    )
    with pytest.raises(holonom.StepError, match=r"the rate of driver 'motor': it has no finite"):
        holonom.simulate(holonom.loads(scene), stop_time=0.5, step_size=0.125)


PROFILE = """
[profiles]
p = {{ x = [-1, 0, 1, 2], y = [-1, 0, 3, 4], interpolation = "{word}" }}
cam = {{ x = [0, 1, 2, 3], y = [0, 1, 3, 0], interpolation = "{word}", periodic = true }}
"""

COURSES = {
    ("linear", "p(t)"): (0.0, 3.0, 0.0),
    ("linear", "p(-t)"): (0.0, -1.0, 0.0),
    ("linear", "p(1 + t)"): (3.0, 1.0, 0.0),
    ("linear", "p(1 - t)"): (3.0, -3.0, 0.0),
    ("linear", "p(t**2)"): (0.0, 0.0, 6.0),
    ("linear", "p(-t**2)"): (0.0, 0.0, -2.0),
    ("linear", "p(-sin(t)) + p(1 - t**3) - 3"): (0.0, -1.0, 0.0),
    ("linear", "p(cos(t))"): (3.0, 0.0, -3.0),
    ("linear", "cam(t)"): (0.0, 1.0, 0.0),
    ("linear", "cam(-t)"): (0.0, 3.0, 0.0),
    ("linear", "cam(3 - t)"): (0.0, 3.0, 0.0),
    ("linear", "cam(2 - t)"): (3.0, -2.0, 0.0),
    ("monotone", "p(t)"): (0.0, 1.5, 9.0),
    ("monotone", "p(-t)"): (0.0, -1.5, 0.0),
    ("monotone", "p(1 + t)"): (3.0, 1.5, 0.0),
    ("monotone", "p(1 - t)"): (3.0, -1.5, -9.0),
    ("monotone", "p(1 - 2*t + t**2)"): (3.0, -3.0, -33.0),
    ("monotone", "p(1 - t**2)"): (3.0, 0.0, -3.0),
}
"""Place, rate and acceleration at 0, by hand: the slopes of p are 1, 3 and 1, those of the cam 1, 2
and -3. Monotone, the slopes at the points of p are 0, 1.5, 1.5 and 0 (harmonic means, and ends that
do not overshoot), so that second derivatives are 6 - 4 d0 - 2 d1 and 2 d0 + 4 d1 - 6 s of its ends.
"""


@pytest.mark.filterwarnings("ignore::solver.SceneWarning")
@pytest.mark.parametrize(("word", "value"), COURSES)
def test_a_driver_at_a_point_of_a_profile_moves_in_the_piece_it_comes_to(word, value):
    x, rate, force = COURSES[word, value]
    scene = POINT.format(x=x, value=value, settings="") + PROFILE.format(word=word)
    found = holonom.simulate(holonom.loads(scene), stop_time=1e-3)
    assert found["B.vx"][0] == pytest.approx(rate, rel=1e-14, abs=1e-14)
    assert found["hand.force.x"][0] == pytest.approx(force, rel=1e-13, abs=1e-13)
