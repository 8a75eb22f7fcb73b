"""A driver starts as its formula goes on after the start, whatever the formula is before."""

from __future__ import annotations

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
        # Torques at the start are second differences over 1e-4 s: round-off of 10 eps / 1e-8 s^2.
        scale = max(1.0, float(np.max(np.abs(smooth[name]))))
        np.testing.assert_allclose(
            bent[name], smooth[name], rtol=0, atol=1e-6 * scale, err_msg=name
        )


def test_a_driver_starts_with_the_rate_and_the_torque_of_its_formula():
    trajectory = run(2, "0.3 + 2*max(t, 0) + 3*max(t, 0)**2")
    assert trajectory["pin.angular_velocity"][0] == pytest.approx(2.0, rel=1e-9)
    assert trajectory["motor.torque"][0] == pytest.approx(6.0, rel=1e-6)
