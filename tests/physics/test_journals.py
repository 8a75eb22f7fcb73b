"""A journal in a bearing with play: it tilts, rolls, rubs and stops at the ends of the bearing."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

import solver
from solver.runtime import Integrator
from tests.support.contact.contact_events import begin, cover, even, number
from tests.support.mechanisms.problems import Content

G, MASS, LENGTH, PLAY, RADIUS = 9.81, 2.0, 0.2, 0.002, 0.03


def shaft(axis: list[float], *, mass: float = MASS, **more: Any) -> Content:
    """A shaft in a fixed bearing about an axis through the origin, its centre 50 mm along it."""
    body = {name: more.pop(name) for name in [*more] if name in ("velocity", "angular_velocity")}
    a = np.array(axis)
    return {
        "name": "shaft",
        "gravity": [0, 0, -G],
        "bodies": {
            "s": {
                "mass": mass, "inertia": [0.01, 0.01, 0.01], "position": (0.05 * a).tolist(),
            } | body,
        },
        "contacts": {
            "b": {
                "type": "journal", "bodies": ["ground", "s"], "position": [0, 0, 0],
                "axis": axis, "length": LENGTH, "radius": PLAY, "pin_radius": RADIUS,
            } | more,
        },
    }  # fmt: skip


def axis_of(integrator) -> np.ndarray:
    """Direction of the shaft that was drawn along x."""
    q = np.array([number(integrator, f"s.q{k}") for k in ("w", "x", "y", "z")])
    w, x, y, z = q
    return np.array([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)])


def test_a_shaft_falls_by_its_play_and_rests_on_both_ends():
    """Both ends carry a part of the weight; its centre is 50 mm from the middle of 200 mm."""
    integrator = begin(shaft([1.0, 0.0, 0.0]), 0.002)
    passed = cover(integrator, even(0.3, 0.02))
    assert integrator["s.z"] == pytest.approx(-PLAY, abs=1e-12)
    assert integrator["b.force"] == pytest.approx(MASS * G, rel=1e-9)
    assert integrator["b.gap"] == pytest.approx(0.0, abs=1e-12)
    assert integrator["energy.impact"] == pytest.approx(MASS * G * PLAY, rel=1e-9)
    assert passed.gap > -1e-12
    assert passed.error < 1e-11


def test_an_overhung_shaft_tilts_by_twice_its_play_over_the_length():
    """Its centre beyond the end: one end rises to the top of the hole, the other one sinks."""
    content = shaft([1.0, 0.0, 0.0])
    content["bodies"]["s"]["position"] = [0.3, 0.0, 0.0]
    integrator = begin(content, 0.002)
    passed = cover(integrator, even(0.5, 0.02))
    tilt = math.asin(-axis_of(integrator)[2])
    # ends at z = c and -c in planes across the shaft, 0.2 m apart along it
    assert tilt == pytest.approx(math.asin(2.0 * PLAY / LENGTH), abs=1e-9)
    # lever: the forces at the ends, -0.1 m and 0.1 m, balance the weight at 0.3 m
    assert integrator["b.force"] == pytest.approx(MASS * G * (2.0 + 1.0), rel=1e-3)
    assert passed.gap > -1e-12
    assert passed.error < 1e-11


def test_a_shaft_along_its_weight_falls_to_its_stop():
    """The axial play of 5 mm, inelastic; without a stop it falls on."""
    stopped = begin(shaft([0.0, 0.0, 1.0], axial_play=0.005), 0.002)
    passed = cover(stopped, even(0.2, 0.02))
    assert stopped["s.z"] == pytest.approx(0.05 - 0.005, abs=1e-12)
    assert stopped["b.force"] == pytest.approx(MASS * G, rel=1e-9)
    assert passed.gap > -1e-12
    free = begin(shaft([0.0, 0.0, 1.0]), 0.002)
    cover(free, even(0.2, 0.02))
    assert free["s.z"] == pytest.approx(0.05 - 0.5 * G * 0.04, abs=1e-12)


def test_a_spinning_shaft_moves_as_a_disc_in_its_hole_in_the_plane():
    """With its weight in the middle both ends are alike; friction carries it up the hole."""
    rubs = {"friction": 0.2, "restitution": 0.5}
    content = shaft([1.0, 0.0, 0.0], angular_velocity=[200.0, 0.0, 0.0], **rubs)
    content["bodies"]["s"]["position"] = [0.0, 0.0, 0.0]
    disc = {
        "name": "disc",
        "dimension": 2,
        "gravity": [0, -G],
        "points": {"o": {"position": [0, 0], "fixed": True}},
        "bodies": {
            "s": {"mass": MASS, "inertia": 0.01, "position": [0, 0], "angular_velocity": 200.0}
        },
        "contacts": {
            "b": {
                "type": "clearance", "points": ["s", "o"], "radius": PLAY, "pin_radius": RADIUS,
            } | rubs
        },
    }  # fmt: skip
    space, plane = begin(content, 0.001), begin(disc, 0.001)
    for t in even(0.1, 0.02):
        for integrator in (space, plane):
            integrator.advance(integrator.time, t - integrator.time)
        pairs = {"s.y": "s.x", "s.z": "s.y", "s.vy": "s.vx", "s.wx": "s.angular_velocity"}
        for first, second in pairs.items():
            assert space[first] == pytest.approx(plane[second], abs=1e-8)
    assert space["energy.friction"] == pytest.approx(plane["energy.friction"], abs=1e-8)
    assert space["b.mode"] == 2.0
    assert abs(number(space, "s.y")) > 1e-4


def test_a_shaft_slides_along_its_bearing_until_friction_stops_it():
    """It falls for sqrt(2c/g), loses mu sqrt(2 g c) of its speed there, then mu g in a second."""
    mu, speed = 0.3, 0.5
    content = shaft([1.0, 0.0, 0.0], friction=mu, velocity=[speed, 0.0, 0.0])
    integrator = begin(content, 0.002)
    passed = cover(integrator, even(0.4, 0.02))
    flown, left = speed * math.sqrt(2.0 * PLAY / G), speed - mu * math.sqrt(2.0 * G * PLAY)
    assert integrator["s.x"] == pytest.approx(0.05 + flown + left**2 / (2.0 * mu * G), abs=1e-8)
    assert integrator["b.mode"] == 1.0
    lost = 0.5 * MASS * speed**2 + MASS * G * PLAY
    assert integrator["energy.dissipated"] == pytest.approx(lost, rel=1e-8)
    assert passed.error < 1e-11
    assert passed.loss > -1e-12


def test_a_slip_past_its_stop_is_an_event_and_no_step_back_in_time():
    """Next to no friction cannot turn a slip: its direction outlives it."""
    play, axis = 4.4493103032679206e-05, [0.0, 1.0, 0.0]
    content = shaft(axis, length=0.008898620606535842, radius=play, friction=1e-300)
    inertia = [7.403317264116463e-06, 4.911704710761333e-06, 8.812328221717886e-06]
    place = [0.7118896485228673, 0.0, 0.0]
    content["bodies"]["s"] |= {"mass": 1.0, "inertia": inertia, "position": place}
    content["contacts"]["b"] |= {
        "position": place, "pin_radius": 0.0, "axial_play": play,
        "collar_radius": 0.0035594482426143364,
    }  # fmt: skip
    content["solver"] = {"step_size": 0.02, "order": 4, "rest_time": 0.0, "assemble": True}
    content["experiment"] = {"step_size": 0.04, "stop_time": 2.0}
    run = Integrator(solver.assemble(solver.loads(json.dumps(content), format="json")), log=print)
    for _ in range(10):
        run.advance(run.time, 0.04)
    assert run["s.z"] == pytest.approx(-play, abs=1e-9)
    assert number(run, "energy.error") < 1e-9


def test_a_collar_stays_before_its_face_where_friction_turns_a_slip_within_a_step():
    """The shaft's centre is far away: friction turns the slip 500 times faster than steps are.

    The equations of such a step have two solutions, which lengths beside each other tell apart.
    """
    play = 0.001
    content = shaft([0.0, 1.0, 0.0], radius=play, friction=0.5, axial_play=play)
    content["gravity"] = [0.0, 0.0, 0.0]
    content["bodies"]["s"] = {
        "position": [4.0, 0.0, 0.0], "mass": 1.447855042485633,
        "inertia": [0.010830094132255474, 0.012158592556753223, 0.012571922671187043],
        "velocity": [-0.9495837050628086, -0.17594329321515412, -0.4991919466346082],
        "angular_velocity": [0.6131984621912168, 0.03253040108284222, -0.9146608954893423],
    }  # fmt: skip
    content["contacts"]["b"] |= {
        "position": [16.0, 0.0, 0.0], "pin_radius": 0.0, "collar_radius": 0.08, "restitution": 0.0,
    }  # fmt: skip
    content["solver"] = {"step_size": 0.02621, "rest_time": 1.0}
    run = Integrator(solver.assemble(solver.loads(json.dumps(content), format="json")), log=print)
    for _ in range(20):
        run.advance(run.time, 0.02)
        assert run["b.gap"] > -1e-10
    assert number(run, "energy.error") < 1e-12
