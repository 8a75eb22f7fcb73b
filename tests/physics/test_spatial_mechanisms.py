"""Mechanisms in space: loops of hinges, shafts, gears, platforms, a wheel on its suspension."""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from tests.support.mechanisms.mechanism_kinematics import (
    cardan_angle,
    differential,
    slider_crank,
    stewart,
)
from tests.support.mechanisms.mechanism_runs import extrapolated, run, scene, times, vector
from tests.support.mechanisms.newton_euler import bricard
from tests.support.mechanisms.reduced_models import Governor

CORNER = vector("rod3.end")
CORNER_AT_1_S = (0.51050146, -1.64916760, 0.14012311)
"""Corner (1, -1, 1) of Bricard's mechanism, of an earlier program converged to 1e-8."""


def test_newton_and_euler_put_bricards_corner_where_directors_do():
    x, R = bricard().motion(np.array([0.0, 1.0]))
    assert x[-1, 2] + 0.5 * R[-1, 2, :, 2] == pytest.approx(CORNER_AT_1_S, abs=1e-8)


def test_bricards_corner_is_there_after_a_second():
    found = extrapolated("bricard", CORNER, 0.005, 1.0)[-1]
    assert found == pytest.approx(CORNER_AT_1_S, abs=1e-6)


def test_a_cardan_shaft_obeys_the_law_of_its_angles():
    t = times(1.0, 0.01)
    angles = run("cardan_shaft", ["input.angle", "output.angle"], 0.001, 1.0, every=0.01)
    assert angles[:, 0] == pytest.approx(20.0 * t, abs=1e-10)
    assert angles[:, 1] == pytest.approx(cardan_angle(20.0 * t, math.pi / 6), abs=1e-10)


def test_the_motor_of_the_cardan_shaft_gives_what_brake_and_shafts_take():
    names = ["energy.work", "energy.dissipated", "energy.kinetic", "energy.error"]
    work, lost, kinetic, error = run("cardan_shaft", names, 0.001, 1.0, every=0.01).T
    assert work == pytest.approx(lost + kinetic - kinetic[0], abs=1e-11 * lost[-1])
    assert (np.diff(lost) > 0).all()
    assert error.max() < 1e-11


def test_the_slider_crank_in_space_moves_as_the_one_in_the_plane():
    t = times(0.1, 0.001)
    x, error = run("spatial_slider_crank", ["slider.x", "energy.error"], 1e-4, 0.1, every=0.001).T
    assert x == pytest.approx(slider_crank(150.0 * t, 0.15, 0.30)[1], abs=1e-10)
    assert error.max() < 1e-11


GOVERNOR = ["slider.z", "bearing.angle"]


def test_the_governor_lifts_its_slider_as_the_oracle():
    # The dampers are overdamped a thousandfold: what is left is a smooth swing of 1 Hz.
    t = times(1.0, 0.1)
    exact = Governor().motion(t)[:, [0, 4]]
    found = extrapolated("flyball_governor", GOVERNOR, 0.0025, 1.0, every=0.1)
    assert found == pytest.approx(exact, abs=2e-5)


def test_the_governor_keeps_its_moment_of_momentum_and_only_loses_energy():
    names = ["angular_momentum.z", "energy.dissipated", "energy.error", "constraint.position"]
    moment, lost, error, gap = run("flyball_governor", names, 0.005, 5.0, every=0.05).T
    assert moment == pytest.approx(moment[0], rel=1e-11)
    assert (np.diff(lost) >= 0).all()
    assert error.max() < 1e-11
    assert gap.max() < 1e-12


BASE = np.array([[1, 0, 0], [-0.5, math.sqrt(0.75), 0], [-0.5, -math.sqrt(0.75), 0]])[
    [0, 1, 1, 2, 2, 0]
]
TOP = (
    0.6
    * np.array([[0.5, math.sqrt(0.75), 0], [-1, 0, 0], [0.5, -math.sqrt(0.75), 0]])[
        [0, 0, 1, 1, 2, 2]
    ]
)
LEG = math.sqrt(1 - 0.6 + 0.36 + 1.44)


def test_the_platform_stands_where_six_legs_put_it():
    integrator = solver.Integrator(solver.assemble(solver.load(scene("stewart"))))
    integrator.initialise()
    extension, pose = np.zeros(6), np.array([0, 0, 1.2, 0, 0, 0])
    reach = np.array([0.10, -0.05, 0.08, 0.02, -0.06, 0.04])
    for i in range(40):
        extension = reach * 0.5 * (1 - math.cos(math.pi * (i + 1) / 20))
        for k in range(6):
            integrator[f"leg{k + 1}"] = extension[k]
        integrator.advance(integrator.time, 0.02)
        pose = stewart(LEG + extension, BASE, TOP, pose)
        place = [integrator[name] for name in vector("platform")]
        assert place == pytest.approx(pose[:3], abs=1e-10)
        half = 0.5 * np.linalg.norm(pose[3:])
        attitude = [integrator[f"platform.q{axis}"] for axis in "xyz"]
        assert attitude == pytest.approx(np.sinc(half / math.pi) / 2 * pose[3:], abs=1e-10)
    assert integrator["energy.error"] < 1e-10
    assert integrator["energy.work"] != 0.0


def test_the_platform_rises_as_fast_as_its_legs_extend():
    # Legs of the same length l under a height z: l l' = z z'. A leg extends at constant rate within
    # a communication step, so the rate at its end is its mean.
    integrator = solver.Integrator(solver.assemble(solver.load(scene("stewart"))))
    integrator.initialise()
    for i in range(10):
        for k in range(6):
            integrator[f"leg{k + 1}"] = 0.1 * (1 - math.cos(0.1 * i))
        integrator.advance(integrator.time, 0.02)
    rate = 0.1 * (math.cos(0.8) - math.cos(0.9)) / 0.02
    length = LEG + 0.1 * (1 - math.cos(0.9))
    assert integrator["platform.vz"] == pytest.approx(length * rate / integrator["platform.z"])


def test_the_legs_of_the_platform_at_rest_carry_its_weight():
    # Each leg takes a sixth of it along its slope; two steps average the first swing away.
    names = [f"drive{k}.force" for k in range(1, 7)]
    weight = 700 * math.pi * 0.6**2 * 0.05 * 9.81
    found = run("stewart", names, 0.005, 0.1)[-1]
    assert np.abs(found) == pytest.approx([weight / 6 * LEG / 1.2] * 6, rel=1e-9)


def test_a_wheel_over_a_bump_comes_to_rest_as_high_as_the_road():
    integrator = solver.Integrator(solver.assemble(solver.load(scene("double_wishbone"))))
    names = ["car.z", "axle.z", "tyre_spring.force", "wheel_travel"]
    places = [integrator.model.index(name) for name in names]
    rest = []
    for road in (0.0, 0.05):
        integrator["road"] = road
        for _ in range(150):
            integrator.advance(integrator.time, 0.04)
        rest.append(integrator.get(places))
    (z0, axle0, force, travel0), (z1, axle1, _, travel1) = rest
    assert (z1 - z0, axle1 - axle0) == pytest.approx((0.05, 0.05), abs=1e-6)
    assert travel1 == pytest.approx(travel0, abs=1e-6)
    assert abs(force) == pytest.approx(
        9.81 * 431.0, rel=1e-4
    )  # all above the tyre; a little aslant
    assert integrator["energy.error"] < 1e-10


def test_a_differential_turns_at_the_mean_of_its_axles():
    names = ["crown.angle", "left_axle.angle", "right_axle.angle"]
    found = run("differential", names, 0.01, 2.0, every=0.1)
    assert found[:, 0] == pytest.approx(found[:, 1:].mean(axis=1), abs=1e-11)
    assert abs(found[-1, 1] - found[-1, 2]) > 10.0


def test_the_axles_of_a_differential_turn_as_their_brakes_let_them():
    names = ["crown.angle", "left_axle.angle", "right_axle.angle"]
    found = extrapolated("differential", names, 0.005, 2.0, every=0.2)
    assert found == pytest.approx(differential(times(2.0, 0.2)), abs=1e-5)


def test_a_screw_lifts_its_load_at_constant_acceleration():
    # Inertia of the screw: m r^2/2. It turns 0.1 rad in a step at last.
    turns = 2 * math.pi / 0.006
    J = 7800 * math.pi * 0.02**2 * 0.5 * 0.02**2 / 2
    lift = (2.0 * turns - 200.0 * 9.81) / (200.0 + J * turns**2)
    t = times(1.0, 0.1)
    found = extrapolated("screw_jack", ["load.z", "bearing.angle"], 0.001, 1.0, every=0.1)
    assert found[:, 0] - 0.4 == pytest.approx(0.5 * lift * t**2, abs=1e-8)
    assert found[:, 1] == pytest.approx(0.5 * lift * t**2 * turns, abs=1e-5)


def test_the_thread_of_a_screw_ties_lift_to_turns():
    z, angle = run("screw_jack", ["load.z", "bearing.angle"], 0.001, 1.0, every=0.1).T
    assert z - 0.4 == pytest.approx(0.006 * angle / (2 * math.pi), abs=1e-12)
    assert angle[-1] > 8 * 2 * math.pi
