"""Mechanisms in the plane: Andrews' squeezer, car axis, slider-crank, famous linkages."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.support.mechanisms.mechanism_kinematics import (
    jansen,
    peaucellier,
    slider_crank,
    stephenson,
)
from tests.support.mechanisms.mechanism_runs import extrapolated, run, times, vector
from tests.support.mechanisms.problems import observed_order
from tests.support.mechanisms.reduced_models import Array, bars_in_motion

ANDREWS = [f"K{i}.angle" for i in range(1, 8)]
ANDREWS_AT_30_MS = np.array(
    [
        15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948,
        0.5244099658805304, 0.5347301163226948, 1.048080741042263,
    ]
)  # fmt: skip
"""Angles beta, theta, gamma, phi, delta, omega, epsilon [rad] of the squeezer at 0.03 s, from the
Test Set for Initial Value Problem Solvers."""

CAR_AXIS = ["A.x", "A.y", "B.x", "B.y"]
CAR_AXIS_AT_3_S = np.array(
    [0.04934557842755629, 0.4969894602303324, 1.0417425248854, 0.3739110272652214]
)
"""From the same source; velocities likewise."""
CAR_AXIS_RATES = np.array(
    [-0.07705836840321485, 0.007446866596327776, 0.01755681574942899, 0.7703410437794031]
)


def angles_of_the_test_set(bodies: Array) -> Array:
    """Angles of the squeezer as its source defines them, from those of the bodies' x axes."""
    k1, k2, k3, k4, k5, k6, k7 = np.moveaxis(bodies, -1, 0)
    half = math.pi / 2
    epsilon = k7 + half
    return np.stack(
        [k1, k2 - math.pi - k1, k3 + half, k4 + half - k5, k5, k6 - epsilon, epsilon], -1
    )


def test_the_squeezer_meets_the_published_angles_with_600_pairs_of_steps():
    # 200 and 400 pairs extrapolated; the crank turns 15.8 rad, at last 0.17 rad in a coarse pair.
    found = extrapolated("andrews", ANDREWS, 0.03 / 200, 0.03)[-1]
    assert angles_of_the_test_set(found) == pytest.approx(ANDREWS_AT_30_MS, abs=1e-5)


def test_the_squeezer_is_of_second_order_and_books_the_work_of_its_motor():
    names = [*ANDREWS, "energy.work", "energy.error", "constraint.position"]
    runs = [run("andrews", names, 0.03 / n, 0.03)[-1] for n in (300, 600, 1200)]
    angles = angles_of_the_test_set(np.array(runs)[:, :7])
    errors = np.abs(angles - ANDREWS_AT_30_MS).max(axis=1)
    assert observed_order([4, 2, 1], errors) == pytest.approx(2.0, abs=0.1)
    turned = angles[:, 0] + 0.0617138900142764496
    assert np.array(runs)[:, 7] == pytest.approx(0.033 * turned, rel=1e-12)
    assert np.array(runs)[:, 8:].max() < 1e-12


def test_the_car_axis_goes_to_the_published_place():
    found = extrapolated(
        "car_axis", [*CAR_AXIS, *vector("A", "v", "xy"), *vector("B", "v", "xy")], 3.0 / 4800, 3.0
    )[-1]
    assert found[:4] == pytest.approx(CAR_AXIS_AT_3_S, abs=2e-5)
    assert found[4:] == pytest.approx(CAR_AXIS_RATES, abs=5e-4)


def test_the_rods_of_the_car_axis_pull_as_published():
    # Published as forces +lambda grad: -0.4736886750784630e-2 of A.x R.x + A.y R.y and
    # -0.1104680411345730e-2 of |A - B|^2, whose gradient is 2 m long.
    found = extrapolated("car_axis", ["upright.multiplier", "chassis.force"], 3.0 / 2400, 3.0)[-1]
    assert found == pytest.approx([0.4736886750784630e-2, 2 * 0.1104680411345730e-2], rel=1e-3)


@pytest.mark.parametrize("n", [500, 2000])
def test_the_slider_crank_is_where_its_crank_puts_it_at_any_step(n):
    h = 0.1 / n
    names = [
        "slider.x",
        "rod.angle",
        "bearing.angle",
        "energy.kinetic",
        "energy.work",
        "energy.balance",
    ]
    x, swing, angle, kinetic, work, balance = run("slider_crank", names, h, 0.1, every=0.01).T
    exact_swing, exact_x = slider_crank(150.0 * times(0.1, 0.01), 0.15, 0.30)
    assert angle == pytest.approx(150.0 * times(0.1, 0.01), abs=1e-11)
    assert x == pytest.approx(exact_x, abs=1e-12)
    assert swing == pytest.approx(exact_swing, abs=1e-11)
    # Some 40 J go to and fro between motor and mechanism; 1e-10 J of them are lost to rounding.
    assert kinetic - kinetic[0] == pytest.approx(work, abs=1e-9)
    assert np.abs(balance).max() < 1e-9


def test_the_motor_of_the_slider_crank_feels_what_its_inertia_asks():
    # tau = d/d phi of T at constant speed; T of rod and slider from their exact places.
    def kinetic(angle: Array) -> Array:
        swing, _ = slider_crank(angle, 0.15, 0.30)
        turning = -0.5 * np.cos(angle) / np.cos(swing) * 150.0
        across = -0.15 * np.sin(angle) * 150.0 - 0.15 * np.sin(swing) * turning
        along = 0.15 * np.cos(angle) * 150.0 + 0.15 * np.cos(swing) * turning
        slider = across - 0.15 * np.sin(swing) * turning
        return 0.5 * (
            0.151104 * (across**2 + along**2)
            + 0.151104 * 0.3**2 / 12 * turning**2
            + 0.075552 * slider**2
        )

    angle = 150.0 * times(0.1, 0.01)[1:]
    exact = (kinetic(angle + 1e-5) - kinetic(angle - 1e-5)) / 2e-5
    found = extrapolated("slider_crank", ["motor.torque"], 1e-4, 0.1, every=0.01)[1:, 0]
    assert found == pytest.approx(exact, abs=1e-4 * np.abs(exact).max())


def test_the_published_slider_crank_differs_by_the_elasticity_of_its_rod_alone():
    swing, x = slider_crank(np.array(15.0), 0.15, 0.30)
    assert swing == pytest.approx(-0.3311734988256260, abs=1.1e-5)
    assert x == pytest.approx(0.1697373328427860, abs=1.1e-5)


def test_peaucelliers_pen_stays_on_its_line():
    names = ["deviation", *vector("P", axes="xy"), *vector("C", axes="xy"), *vector("D", axes="xy")]
    values = run("peaucellier", names, 0.005, 4.0, every=0.05)
    assert np.abs(values[:, 0]).max() < 1e-12
    assert np.ptp(values[:, 2]) > 1.0  # a line of more than a metre, not a point
    pins = [peaucellier(0.5 * (1 - math.cos(math.pi * t))) for t in times(4.0, 0.05)]
    exact = [np.concatenate([pin["P"], pin["C"], pin["D"]]) for pin in pins]
    assert values[:, 1:] == pytest.approx(np.array(exact), abs=1e-10)


def test_watts_pen_swings_as_the_oracle_and_draws_nearly_a_line():
    points = {"O": [-1, 0.25], "A": [0, 0.25], "B": [0, -0.25], "Q": [1, -0.25]}
    exact = bars_in_motion(
        {name: np.array(place) for name, place in points.items()}, {"O", "Q"},
        [("O", "A", 1.0), ("A", "B", 0.5), ("B", "Q", 1.0)],
        ("A", np.array([0.0, 1.25]), 60.0, 0.8), times(2.0, 0.25),
    )  # fmt: skip
    names = ["A.x", "A.y", "B.x", "B.y", "drift", "lift"]
    found = extrapolated("watt", names, 0.005, 2.0, every=0.25)
    assert found[:, :4] == pytest.approx(np.hstack([exact["A"], exact["B"]]), abs=1e-6)
    drift, lift = run("watt", names[4:], 0.005, 10.0, every=0.05).T
    assert np.ptp(lift) > 0.08
    assert np.abs(drift).max() < 1e-4 * np.ptp(lift)


def test_stephensons_pins_are_where_the_crank_puts_them():
    # Shortest lever 0.1 m, no angle of transmission below 20 degrees: errors of the rows times 3.
    t = times(4.0, 0.1)
    pins = [stephenson(math.pi / 2 + 2 * math.pi * s) for s in t]
    exact = [np.concatenate([pin["B"], pin["C"], pin["D"]]) for pin in pins]
    names = [name for pin in "BCD" for name in vector(pin, axes="xy")]
    assert run("stephenson", names, 0.001, 4.0, every=0.1) == pytest.approx(
        np.array(exact), abs=1e-10
    )


def test_jansens_foot_walks_the_path_of_the_holy_numbers():
    # Drawn to nine digits: lengths as drawn differ from the book's by 1e-9 m, some times as much
    # at the end of six pins in a row.
    t = times(5.0, 0.1)
    turned = np.where(t < 1, t**2 / 2, t - 0.5) * 5.0
    pins = [jansen(-angle) for angle in turned]
    exact = [np.concatenate([pin["A"], pin["D"], pin["C"], pin["F"], pin["foot"]]) for pin in pins]
    names = [name for pin in ("A", "D", "C", "F", "foot") for name in vector(pin, axes="xy")]
    found = run("jansen", names, 0.002, 5.0, every=0.1)
    assert found == pytest.approx(np.array(exact), abs=2e-8)
    foot = found[10:, -2:]
    on_the_ground = foot[foot[:, 1] < foot[:, 1].min() + 0.02]
    assert np.ptp(on_the_ground[:, 0]) > 0.4  # a stride of half a leg, level to 2 cm
