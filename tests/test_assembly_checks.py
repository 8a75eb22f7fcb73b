"""What is checked when the parameters have arrived: drawn lengths and the velocities of rods."""

from __future__ import annotations

import math

import pytest

from solver.scene import SceneError
from tests.twins import PENDULUM, model_of


def pendulum(angle: float, speed: float, along: float = 0.0) -> str:
    """Pendulum at an angle, moving across its rod with a speed and along it with another."""
    x, y = math.cos(angle), math.sin(angle)
    text = PENDULUM.replace("[0.6, -0.8]", str([x, y]))
    return text.replace("[0.8, 0.6]", str([along * x - speed * y, along * y + speed * x]))


@pytest.mark.parametrize("speed", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("angle", [0.1, 0.7, 2.0, 4.0])
def test_rounding_of_a_velocity_across_a_rod_does_not_contradict_it(angle, speed):
    """Its component along the rod is 1e-16 of the speed, and not zero."""
    assert model_of(pendulum(angle, speed)).sizes["n_rows"] == 1


@pytest.mark.parametrize("speed", [0.0, 1.0])
def test_a_velocity_along_a_rod_contradicts_it(speed):
    with pytest.raises(SceneError, match="the velocities of its points contradict it"):
        model_of(pendulum(0.7, speed, along=1e-6))
