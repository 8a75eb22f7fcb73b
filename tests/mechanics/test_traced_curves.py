"""Curves of centres and of flat faces agree with the exact ones, also where the curvature jumps."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from solver.mechanics.curves import centres_above, centres_around, support_function
from solver.scene.expression import Curve, apply
from solver.scene.profiles import Profile, table_of

RADIUS = 0.05
ROAD = [0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 0.0, 0.1, 0.1, 0.0]
CAM = [0.0, 2.0, 4.0, 2.0 * math.pi], [1.0, 1.02, 1.01, 1.0]


def above(x: float, y: float, slope: float) -> tuple[float, float]:
    """Centre of a wheel: the normal is (-y', 1)/s."""
    normal = np.array([-slope, 1.0]) / math.hypot(1.0, slope)
    return tuple(np.array([x, y]) + RADIUS * normal)


def around(phi: float, r: float, slope: float) -> tuple[float, float]:
    """Angle and distance of the centre of a roller, by complex numbers; the tangent is dP/dphi."""
    place = r * np.exp(1j * phi)
    tangent = (slope + 1j * r) * np.exp(1j * phi)
    centre = place - 1j * RADIUS * tangent / abs(tangent)
    turned = centre * np.exp(-1j * phi)
    return phi + float(np.angle(turned)), float(abs(centre))


def face(phi: float, r: float, slope: float) -> tuple[float, float]:
    """Angle of the normal of a flat face, and its distance, the part of the place along it."""
    tangent = slope + 1j * r
    normal = -1j * tangent / abs(tangent)
    return phi + float(np.angle(normal)), float((r * normal.conjugate()).real)


class Rows:
    def problem(self, *told: str) -> None:
        raise AssertionError(told)


@pytest.mark.parametrize("word", ["cubic", "monotone"])
@pytest.mark.parametrize(
    ("points", "traced", "exact"),
    [
        (ROAD, lambda profile: centres_above(Rows(), profile, RADIUS), above),  # pyright: ignore[reportArgumentType]
        (CAM, lambda profile: centres_around(Rows(), profile, RADIUS), around),  # pyright: ignore[reportArgumentType]
        (CAM, lambda profile: support_function(Rows(), profile), face),  # pyright: ignore[reportArgumentType]
    ],
    ids=["wheel", "roller", "flat face"],
)
def test_a_traced_curve_is_the_exact_one(
    word: Any, points: Any, traced: Callable[[Profile], Curve], exact: Callable[..., Any]
) -> None:
    """To 1e-8 of its size, which is 1: in the middle of pieces it fits to 1e-9."""
    x, y = points
    periodic = points is CAM
    curve = Curve("p", table_of(x, y, interpolation=word, periodic=periodic))
    profile = Profile(x=tuple(x), y=tuple(y), interpolation=word, periodic=periodic, curve=curve)
    found = traced(profile)
    for at in np.linspace(x[0], x[-1], 1000)[1:-1].tolist():
        place, value = exact(at, apply("spline", at, curve), apply("spline_slope", at, curve))
        assert apply("spline", place, found) == pytest.approx(value, abs=1e-8)
