"""Mechanisms that cannot move every way they might get: disc, sleigh and snakeboard."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.mechanism_runs import extrapolated, run, times, vector
from tests.nonholonomic_models import chaplygin_sleigh, rolling_disc, snakeboard
from tests.reduced_models import Array, rotation

TILT, ROLL, TURN = 0.3, 15.0, -2.0
SLEIGH = ["sleigh.x", "sleigh.y", "sleigh.angle", "sleigh.angular_velocity"]


def disc_at(t: Array) -> tuple[Array, Array, Array]:
    spin = np.array([0.0, ROLL * math.cos(TILT), TURN + ROLL * math.sin(TILT)])
    return rolling_disc(rotation([TILT, 0, 0]), spin, t, radius=0.1, mass=0.5, gravity=9.81)


def test_the_oracle_of_the_disc_keeps_its_energy_and_its_contact():
    x, R, omega = disc_at(times(2.0, 0.5))
    u = np.array([0.0, 0.0, 1.0]) - R[:, 2, 1, None] * R[:, :, 1]
    v = np.cross(omega, 0.1 * u / np.linalg.norm(u, axis=1, keepdims=True))
    own = np.einsum("nij,ni->nj", R, omega)  # in body axes
    spin = 0.5 * own**2 @ (0.5 * 0.1**2 * np.array([0.25, 0.5, 0.25]))
    energy = 0.25 * (v**2).sum(axis=1) + spin + 0.5 * 9.81 * x[:, 2]
    assert energy == pytest.approx(energy[0], rel=1e-11)
    assert x[:, 2] == pytest.approx(0.1 * np.sqrt(1 - R[:, 2, 1] ** 2), abs=1e-12)


def test_the_disc_rolls_where_the_oracle_rolls():
    exact = disc_at(times(2.0, 0.5))[0]
    found = extrapolated("rolling_disc", vector("disc"), 0.002, 2.0, every=0.5)
    assert found == pytest.approx(exact, abs=1e-6)


def test_the_sleigh_follows_the_hyperbolic_functions():
    t = times(10.0, 1.0)
    x, y, angle, _, spin = chaplygin_sleigh(t, a=0.5, mass=2.0, inertia=0.5, speed=-1.0, spin=0.5).T
    found = extrapolated("chaplygin_sleigh", SLEIGH, 0.01, 10.0, every=1.0)
    assert found == pytest.approx(np.column_stack([x, y, angle, spin]), abs=1e-6)


def test_the_sleigh_ends_centre_of_mass_in_front_and_straight():
    values = run("chaplygin_sleigh", ["sleigh.vx", "sleigh.vy", *SLEIGH[2:]], 0.01, 20.0)
    vx, vy, angle, spin = values[-1]
    # All its energy, 1 + 0.125 J = m u^2/2 with 2 kg, is in the motion forwards.
    assert vx * math.cos(angle) + vy * math.sin(angle) == pytest.approx(math.sqrt(1.125), abs=1e-4)
    assert abs(spin) < 1e-4


def test_the_snakeboard_goes_as_the_oracle():
    exact = snakeboard(times(5.0, 1.0))
    found = extrapolated("snakeboard", ["board.x", "board.y", "board.angle"], 0.01, 5.0, every=1.0)
    assert exact[-1, 0] > 1.0  # it gets along, though nobody pushes
    assert found == pytest.approx(exact, abs=1e-6)


def test_the_rider_pays_for_the_way_of_the_snakeboard():
    kinetic, work, error = run(
        "snakeboard", ["energy.kinetic", "energy.work", "energy.error"], 0.01, 10.0, every=0.5
    ).T
    assert work == pytest.approx(kinetic - kinetic[0], abs=1e-12)
    assert work[-1] > 1.0
    assert error.max() < 1e-12
