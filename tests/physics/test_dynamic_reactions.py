"""Reactions in motion: force and couple on the second body against Newton's and Euler's equations.

Nothing but its joint acts on B of `joint_scenes`, so that F = m dv/dt of its centre of mass, and
the couple about the joint's place p on B is M = dL/dt - (p - c) x F, L its moment of momentum about
its centre c. Rates are central differences over two steps: as the reactions, of second order.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

import solver
from tests.support.mechanisms.joint_scenes import pair, train
from tests.support.mechanisms.mechanism_runs import run
from tests.support.mechanisms.reduced_models import Array, matrix_of, rotation

CENTRE = np.array([0.02, 0.05, -0.03])
INERTIA = np.array([[0.05, 0.01, 0.0], [0.01, 0.06, -0.005], [0.0, -0.005, 0.04]])
DRAWN_B = np.array([0.9, 0.3, -0.1])
ATTITUDE_B = matrix_of(np.array([0.9, 0.1, -0.3, 0.2]))
ATTITUDE_A = rotation([0.2, -0.3, 0.4])
"""Bodies of the scenes as drawn; B has a mass of 1 kg."""
AXES = "xyz"
BODY = [*AXES, "vx", "vy", "vz", "qw", "qx", "qy", "qz", "wx", "wy", "wz"]
STEPS = (0.01, 0.005, 0.0025)
SAMPLES = 0.1 * np.arange(1, 6)
"""Times [s] at which every run has a step, and so do its neighbours."""
UNIT_AXIS = np.array([1.0, 2.0, 2.0]) / 3


@dataclass(frozen=True)
class Flight:
    """Places x (n, 3), attitudes R (n, 3, 3) of the bodies, and what the joint says, at samples."""

    place: dict[str, Array]
    attitude: dict[str, Array]
    force: Array
    """m dv/dt of B's centre, (n, 3) [N]."""
    turning: Array
    """dL/dt of B about its centre, (n, 3) [N.m]."""
    said: Array
    """Outputs of the joint, (n, k)."""

    def couple(self, at: Array) -> Array:
        """Couple on B about places `at` (n, 3) [N.m]."""
        centre = self.place["B"] + self.attitude["B"] @ CENTRE
        return self.turning - np.cross(at - centre, self.force)


def fly(text: str, h: float, outputs: list[str], bodies: tuple[str, ...] = ("A", "B")) -> Flight:
    """Run in steps of h, every one recorded, and differentiate what B does."""
    names = [*outputs, *(f"{body}.{part}" for body in bodies for part in BODY)]
    values = run(solver.loads(text), names, h, SAMPLES[-1] + 0.1, every=h)
    at = np.rint(SAMPLES / h).astype(int)
    of_body = np.split(values[:, len(outputs) :], len(bodies), axis=1)
    own = dict(zip(bodies, of_body, strict=True))
    attitude = {name: np.array([matrix_of(q) for q in own[name][:, 6:10]]) for name in bodies}
    R, omega = attitude["B"], own["B"][:, 10:]
    arm = R @ CENTRE
    velocity = own["B"][:, 3:6] + np.cross(omega, arm)
    spin = np.einsum("nij,jk,nlk,nl->ni", R, INERTIA, R, omega)

    def rate(x: Array) -> Array:
        return (x[at + 1] - x[at - 1]) / (2 * h)

    return Flight(
        {name: x[at, :3] for name, x in own.items()},
        {name: x[at] for name, x in attitude.items()},
        rate(velocity), rate(spin), values[at, : len(outputs)],
    )  # fmt: skip


def on_second(flight: Flight, drawn: Array) -> Array:
    """Where a place on B is, drawn at global coordinates."""
    return flight.place["B"] + flight.attitude["B"] @ (ATTITUDE_B.T @ (drawn - DRAWN_B))


def force_and_torque(name: str) -> list[str]:
    return [f"{name}.{what}.{axis}" for what in ("force", "torque") for axis in AXES]


def meets_second_order(of_step: Callable[[float], tuple[Array, Array]]) -> None:
    """What is said meets what is asked, better by four for half the step."""
    errors, size = [], 0.0
    for h in STEPS:
        said, asked = of_step(h)
        errors.append(float(np.abs(said - asked).max()))
        size = float(np.abs(asked).max())
    assert size > 0.01
    assert errors[-1] < 2e-4 * max(size, 1.0)  # (h w)^2 at up to 5 rad/s
    ratios = np.array(errors[:-1]) / errors[1:]
    assert ratios == pytest.approx(4.0, abs=0.4)


HELD = [
    "revolute",
    "universal",
    "cylindrical",
    "prismatic",
    "planar",
    "fixed",
    "screw",
]


@pytest.mark.parametrize("kind", HELD)
def test_force_and_torque_of_a_joint_are_what_moves_its_second_body(kind: str) -> None:
    def both(h: float) -> tuple[Array, Array]:
        flight = fly(pair(3, kind, h), h, force_and_torque("joint"))
        place = on_second(flight, np.array([0.5, 0.1, 0.2]))
        return flight.said, np.hstack([flight.force, flight.couple(place)])

    meets_second_order(both)


@pytest.mark.parametrize(
    "kind", ["spherical", "point_on_line", "point_on_plane", "point_on_surface"]
)
def test_a_force_at_a_place_turns_the_body_by_its_lever_alone(kind: str) -> None:
    at_joint = kind == "spherical"
    local = np.array([-0.2, 0.1, 0.05])  # the tip of B

    def both(h: float) -> tuple[Array, Array]:
        flight = fly(pair(3, kind, h), h, force_and_torque("joint")[:3])
        tip = flight.place["B"] + flight.attitude["B"] @ local
        place = on_second(flight, np.array([0.5, 0.1, 0.2])) if at_joint else tip
        asked = np.hstack([flight.force, flight.couple(place)])
        return np.hstack([flight.said, np.zeros_like(flight.said)]), asked

    meets_second_order(both)


def test_a_surface_pushes_a_moving_point_along_its_normal() -> None:
    # x^2 + 2 y^2 + 3 z^2 = 1 in the axes of A: the part of the force across its normal is nothing.
    flight = fly(pair(3, "point_on_surface", 0.01), 0.01, force_and_torque("joint")[:3])
    tip = flight.place["B"] + flight.attitude["B"] @ [-0.2, 0.1, 0.05]
    back = np.swapaxes(flight.attitude["A"], 1, 2)
    local = np.einsum("nij,nj->ni", back, tip - flight.place["A"])
    pushed = np.einsum("nij,nj->ni", back, flight.said)
    normal = local * [1.0, 2.0, 3.0]
    size = np.linalg.norm(pushed, axis=1) * np.linalg.norm(normal, axis=1)
    assert np.linalg.norm(flight.said, axis=1).min() > 1e-3
    assert np.abs(np.cross(pushed, normal)).max() < 1e-12 * size.max()


def test_a_massless_rod_pulls_two_bodies_along_itself() -> None:
    def both(h: float) -> tuple[Array, Array]:
        flight = fly(pair(3, "distance", h), h, ["joint.force"])
        tip = flight.place["B"] + flight.attitude["B"] @ [-0.2, 0.1, 0.05]
        other = flight.place["A"] + flight.attitude["A"] @ [0.3, -0.1, 0.2]
        along = (other - tip) / np.linalg.norm(other - tip, axis=1, keepdims=True)
        asked = np.hstack([flight.force, flight.couple(tip)])
        return np.hstack([flight.said * along, 0 * along]), asked

    meets_second_order(both)


def test_a_constant_angle_turns_its_second_body_where_the_angle_grows() -> None:
    first = ATTITUDE_A.T @ UNIT_AXIS
    second = ATTITUDE_B.T @ np.array([1.0, 0.0, 0.3]) / np.hypot(1.0, 0.3)

    def both(h: float) -> tuple[Array, Array]:
        flight = fly(pair(3, "angle", h), h, ["joint.torque"])
        u, w = flight.attitude["A"] @ first, flight.attitude["B"] @ second
        across = np.cross(u, w)
        across /= np.linalg.norm(across, axis=1, keepdims=True)
        centre = flight.place["B"] + flight.attitude["B"] @ CENTRE
        asked = np.hstack([flight.force, flight.couple(centre)])
        return np.hstack([0 * across, flight.said * across]), asked

    meets_second_order(both)


@pytest.mark.parametrize("kind", ["gear", "gear on sleeves"])
def test_a_gear_adds_its_torque_about_the_axis_to_what_the_hinge_carries(kind: str) -> None:
    def both(h: float) -> tuple[Array, Array]:
        names = [*force_and_torque("second"), "mesh.torque"]
        flight = fly(train(3, kind, h), h, names, ("frame", "B"))
        axis = flight.attitude["frame"] @ np.array([2.0, -1.0, 2.0]) / 3
        said = flight.said[:, :6] + np.hstack([0 * axis, flight.said[:, 6:] * axis])
        place = on_second(flight, np.array([0.7, 0.3, 0.0]))
        return said, np.hstack([flight.force, flight.couple(place)])

    meets_second_order(both)


@pytest.mark.parametrize("kind", ["rack", "rack on sleeves"])
def test_a_rack_adds_its_force_along_the_axis_to_what_the_guide_carries(kind: str) -> None:
    def both(h: float) -> tuple[Array, Array]:
        names = [*force_and_torque("second"), "mesh.force"]
        flight = fly(train(3, kind, h), h, names, ("frame", "B"))
        axis = flight.attitude["frame"] @ np.array([2.0, -1.0, 2.0]) / 3
        said = flight.said[:, :6] + np.hstack([flight.said[:, 6:] * axis, 0 * axis])
        place = on_second(flight, np.array([0.7, 0.3, 0.0]))
        return said, np.hstack([flight.force, flight.couple(place)])

    meets_second_order(both)


@pytest.mark.parametrize("kind", ["revolute", "prismatic", "fixed"])
def test_force_and_torque_in_the_plane_are_what_moves_the_second_body(kind: str) -> None:
    local = np.array([[0.02, 0.05], [-0.4, -0.2]])  # centre, and joint less origin as drawn
    c, s = np.cos(-0.4), np.sin(-0.4)
    local[1] = local[1] @ [[c, -s], [s, c]]
    torque = [] if kind == "revolute" else ["joint.torque.z"]
    names = ["B.x", "B.y", "B.angle", "B.vx", "B.vy", "B.angular_velocity"]

    def both(h: float) -> tuple[Array, Array]:
        scene = solver.loads(pair(2, kind, h))
        outputs = [*names, "joint.force.x", "joint.force.y", *torque]
        values = run(scene, outputs, h, SAMPLES[-1] + 0.1, every=h)
        at = np.rint(SAMPLES / h).astype(int)
        c, s = np.cos(values[:, 2]), np.sin(values[:, 2])
        R = np.moveaxis(np.array([[c, -s], [s, c]]), -1, 0)
        centre, place = np.moveaxis(R @ local.T, 2, 0)
        velocity = values[:, 3:5] + values[:, 5:6] * centre @ [[0.0, 1.0], [-1.0, 0.0]]
        motion = np.column_stack([velocity, 0.05 * values[:, 5]])
        force = (motion[at + 1] - motion[at - 1]) / (2 * h)
        x, y = (place - centre)[at].T
        force[:, 2] -= x * force[:, 1] - y * force[:, 0]
        said = np.zeros((len(at), 3))
        said[:, : 2 + len(torque)] = values[at, 6:]
        return said, force

    meets_second_order(both)
