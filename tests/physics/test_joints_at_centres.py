"""Joints at the centre of mass of a moving body: of one of two, or of both at once.

What is right comes from closed forms, from the same hinge drawn elsewhere on its axis, and from
Newton's and Euler's equations.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import solver
from tests.support.mechanisms.newton_euler import GROUND, Mechanism, Meet, Perpendicular
from tests.support.mechanisms.problems import Content
from tests.support.mechanisms.work_sums import vector

A, B = [0.2, -0.1, 0.3], [0.7, 0.4, 0.1]
AXIS, ACROSS = [1, 2, 2], [2, 1, -2]
CENTRES = {"first": (A, B, A), "second": (A, B, B), "both": (A, A, A)}
"""Places of two bodies, and of the joint."""
AT_CENTRES = pytest.mark.parametrize("at", CENTRES)
KINDS = {
    "spherical": {}, "revolute": {"axis": AXIS}, "universal": {"axes": [AXIS, ACROSS]},
    "fixed": {}, "cylindrical": {"axis": AXIS}, "prismatic": {"axis": AXIS},
    "planar": {"axis": AXIS}, "screw": {"axis": AXIS, "pitch": 0.3},
}  # fmt: skip


def run(content: Content, time: float, step: float = 0.01, **settings: Any) -> solver.Trajectory:
    """Run a scene in space."""
    drawn = {"name": "centres", "solver": {"assemble": True, "step_size": step} | settings}
    scene = solver.loads(json.dumps(drawn | content), name="centres.json", format="json")
    return solver.simulate(scene, stop_time=time, step_size=time / 20)


def two_bodies(at: str, **of_first: Any) -> dict[str, Content]:
    """Bodies that fly freely, of the places in `CENTRES`."""
    first, second, _ = CENTRES[at]
    return {
        "A": {
            "position": first, "mass": 2.0, "inertia": [0.11, 0.13, 0.17], **of_first,
            "orientation": {"rotation_vector": [0.2, -0.3, 0.4]},
        },
        "B": {"position": second, "mass": 1.0, "inertia": [0.05, 0.06, 0.04]},
    }  # fmt: skip


SPIN = {"velocity": [0.1, -0.2, 0.3], "angular_velocity": [1.0, -0.5, 0.7]}


@AT_CENTRES
@pytest.mark.parametrize("kind", KINDS)
def test_joints_at_centres_keep_energy_and_momenta(kind, at):
    place = CENTRES[at][2]
    joint = {"type": kind, "bodies": ["A", "B"], "position": place, **KINDS[kind]}
    moved = run({"bodies": two_bodies(at, **SPIN), "joints": {"j": joint}}, 2.0)
    assert moved["energy.error"].max() < 1e-13
    assert moved["constraint.position"].max() < 1e-13
    kept = np.hstack([vector(moved, "momentum."), vector(moved, "angular_momentum.")])
    assert np.ptp(kept, axis=0).max() < 1e-13 * np.abs(kept).max()


EXTRAS = {
    "alone": {},
    "torsion spring": {"forces": {"s": {"type": "torsion_spring", "joint": "j", "stiffness": 2}}},
    "torsion damper": {"forces": {"s": {"type": "torsion_damper", "joint": "j", "damping": 0.3}}},
    "driver": {"drivers": {"s": {"type": "angle", "joint": "j", "value": "0.3*t**2"}}},
    "stop": {"contacts": {"s": {"type": "stop", "joint": "j", "min": -0.2, "restitution": 0.8}}},
    "loop": {"joints": {"s": {"type": "distance", "points": ["A", "C"]}}},
}
ADDED = pytest.mark.parametrize("extra", EXTRAS)


@AT_CENTRES
@ADDED
def test_a_hinge_at_a_centre_moves_as_one_elsewhere_on_its_axis(extra, at):
    """Also in a tree with a third body, and in a loop that this one closes."""
    runs = []
    for shift in (0.0, 0.3):
        place = (np.array(CENTRES[at][2]) + shift * np.array(AXIS) / 3.0).tolist()
        joint = {"type": "revolute", "bodies": ["A", "B"], "position": place, "axis": AXIS}
        bodies = two_bodies(at)
        bodies["C"] = {"position": [0.9, 0.1, -0.2], "mass": 0.7, "inertia": [0.02, 0.03, 0.04]}
        joints = {"j": joint, "k": {"type": "spherical", "bodies": ["B", "C"], "position": B}}
        forces = {"push": {"type": "torque", "body": "A", "value": [1.0, -0.5, 0.7]}}
        content = {"bodies": bodies, "joints": joints, "forces": forces}
        for table, parts in EXTRAS[extra].items():
            content[table] = content.get(table, {}) | parts
        runs.append(run(content, 1.0))
    columns = [x for x in runs[0].names if x[0] in "ABC" and ".velocity" not in x]
    first, second = (np.column_stack([moved[x] for x in columns]) for moved in runs)
    assert np.ptp(first, axis=0).max() > 0.1
    assert np.abs(first - second).max() < 1e-11


def precession(spin: list[float], moments: tuple[float, float], times: np.ndarray) -> np.ndarray:
    """Axis of a free symmetric top drawn along z, which turns about its angular momentum."""
    across, along = moments
    momentum = np.array([across, across, along]) * spin
    size = np.linalg.norm(momentum)
    n, e = momentum / size, np.array([0.0, 0.0, 1.0])
    turn = (size / across * times)[:, None]
    return n * (n @ e) + np.cos(turn) * (e - n * (n @ e)) + np.sin(turn) * np.cross(n, e)


def test_tops_on_one_ball_at_their_common_centre_do_not_feel_each_other():
    tops = {"A": ([0.3, -0.2, 4.0], (0.3, 0.5)), "B": ([0.5, 0.4, -3.0], (0.2, 0.1))}
    bodies = {
        name: {
            "position": A, "mass": 1.5, "inertia": [across, across, along],
            "angular_velocity": spin, "points": {"tip": [0, 0, 1]},
        }
        for name, (spin, (across, along)) in tops.items()
    }  # fmt: skip
    joint = {"type": "spherical", "bodies": ["A", "B"], "position": A}
    moved = run({"bodies": bodies, "joints": {"j": joint}}, 2.0, tolerance=1e-9)
    for name, (spin, moments) in tops.items():
        tip = vector(moved, f"{name}.tip.") - A
        assert np.abs(tip - precession(spin, moments, moved.t)).max() < 3e-9


SQUARE = {
    "spherical": [], "universal": [(0, 1)], "revolute": [(0, 1), (0, 2)],
    "fixed": [(0, 1), (1, 2), (2, 0)],
}  # fmt: skip
"""Axes of the first body and of the second one that a joint keeps at right angles."""


@AT_CENTRES
@pytest.mark.parametrize("kind", SQUARE)
def test_hung_bodies_move_as_newton_and_euler_say(kind, at):
    """The first hangs on a ball beside its centre of mass, the second on the joint."""
    places = np.array(CENTRES[at][:2])
    pivot, joint_at = places[0] + [0.1, 0.2, 0.3], np.array(CENTRES[at][2])
    inertias, gravity = np.array([[0.11, 0.13, 0.17], [0.05, 0.06, 0.04]]), np.array([3.0, 0, -9])
    rows = [
        Meet(GROUND, pivot, 0, pivot - places[0]),
        Meet(0, joint_at - places[0], 1, joint_at - places[1]),
        *(Perpendicular(0, np.eye(3)[i], 1, np.eye(3)[k]) for i, k in SQUARE[kind]),
    ]
    axes = {"universal": {"axes": [[1, 0, 0], [0, 1, 0]]}, "revolute": {"axis": [1, 0, 0]}}
    joint = {"type": kind, "bodies": ["A", "B"], "position": joint_at.tolist()}
    bodies = {
        name: {"position": place.tolist(), "mass": mass, "inertia": inertia.tolist()}
        for name, place, mass, inertia in zip("AB", places, (2.0, 1.0), inertias, strict=True)
    }
    hung = {"type": "spherical", "bodies": ["ground", "A"], "position": pivot.tolist()}
    joints = {"root": hung, "j": joint | axes.get(kind, {})}
    content = {"bodies": bodies, "joints": joints, "gravity": gravity.tolist()}
    moved = run(content, 1.0, tolerance=1e-9)
    oracle = Mechanism(np.array([2.0, 1.0]), inertias, places, rows, gravity)
    exact, attitudes = oracle.motion(moved.t)
    for k, name in enumerate("AB"):
        assert np.abs(vector(moved, f"{name}.") - exact[:, k]).max() < 3e-9
    assert np.abs(attitudes[-1] - np.eye(3)).max() > 0.1
