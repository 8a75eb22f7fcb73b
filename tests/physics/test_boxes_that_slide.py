"""Boxes that slide on boxes: flat, where contacts hold the same thing twice, and over an edge."""

from __future__ import annotations

import json
from typing import Any

import pytest

import solver

SIDEWAYS, DOWN = 5.706788146288606, 7.979264944428144
"""Gravity on the box that lands flat [m/s^2]."""
MASS = 0.8342565108203346


def run(content: dict[str, Any]) -> solver.Integrator:
    """Return a scene at its start."""
    return solver.Integrator(solver.assemble(solver.loads(json.dumps(content), format="json")))


def box_that_lands_flat() -> dict[str, Any]:
    """A box that falls on a larger one at rest, without restitution, and slides."""
    return {
        "name": "flat",
        "dimension": 3,
        "gravity": [SIDEWAYS, 0.0, -DOWN],
        "bodies": {
            "box": {
                "position": [16.0, 0.0, 0.23073160662848058],
                "mass": MASS,
                "velocity": [0.043536817272720185, -0.6769215413175602, -0.8908655256956237],
                "angular_velocity": [0.5883253082883049, 0.32459448786610934, 0.526476277612469],
                "inertia": [0.004552219664149941, 0.006256224656009497, 0.003284969126227136],
            },
            "table": {
                "position": [16.0, 0.0, 0.0],
                "mass": 0.66,
                "inertia": [0.0044, 0.0027, 0.0029],
            },
        },
        "joints": {
            "foot": {"type": "fixed", "bodies": ["ground", "table"], "position": [16.0, 0.0, 0.0]}
        },
        "contacts": {
            "c": {
                "type": "box",
                "bodies": ["box", "table"],
                "sizes": [
                    [0.4780568780536729, 0.34342398314385547, 0.32007790626916155],
                    [0.2151893697805536, 0.3273604443375228, 0.14138530698779958],
                ],
                "friction": 0.1,
            }
        },
        "solver": {"step_size": 0.001, "order": 2},
        "experiment": {"step_size": 0.002, "stop_time": 0.1},
    }


def test_a_box_that_lands_flat_slides_with_its_weight_on_what_it_touches():
    # Up to eight contacts share it, of which three are enough: whichever they are, the centre has
    # no acceleration across the face. Forces of single ones are no closed form.
    box = run(box_that_lands_flat())
    increments = 0.0
    for _ in range(30):
        box.advance(box.time, 0.002)
        increments += box.state.head["newton_iterations"]
        assert box["energy.error"] < 1e-12
        assert box["solver.stepped"] == 0.0
    assert box["c.force"] == pytest.approx(MASS * DOWN, rel=1e-9)
    assert box["box.vz"] == pytest.approx(0.0, abs=1e-9)
    assert increments < 20_000


def box_over_an_edge() -> dict[str, Any]:
    """A box that falls on one with a hinge, turns it, and slides over an edge of it.

    Far from both a sledge slides on a floor.
    """
    return {
        "name": "edge",
        "dimension": 3,
        "gravity": [0.0, 0.0, -9.81],
        "bodies": {
            "box": {
                "position": [20.0, 0.0, 0.6366595440783174],
                "mass": 0.9170181845212964,
                "orientation": {
                    "rotation_vector": [
                        -0.5936489315800313, 0.11991875376027772, -0.5702982418277549,
                    ]
                },
                "velocity": [0.2789660625996133, 0.09782447641816905, -0.29993603512853007],
                "inertia": [0.013452367867781582, 0.010993094718093104, 0.014994019214890809],
            },
            "flap": {
                "position": [20.0, 0.0, -1e-15],
                "mass": 1.0841291665753643,
                "inertia": [0.020354666887640878, 0.014518105461913625, 0.016605571357114445],
            },
            "sledge": {
                "position": [24.0, 0.0, 0.21840119544609266],
                "mass": 0.6244559976001713,
                "velocity": [0.8654247470400847, 0.4285278526466654, -0.030019969720927353],
                "inertia": [0.007562851784236415, 0.008523589736599951, 0.010759538882463749],
            },
        },
        "joints": {
            "hinge": {
                "type": "revolute",
                "bodies": ["ground", "flap"],
                "position": [20.0, 0.0, 0.0],
                "axis": [0, 1, 0],
            }
        },
        "contacts": {
            "floor": {
                "type": "corners",
                "body": "sledge",
                "size": [0.3607509249030828, 0.24151546545348246, 0.4368023908921853],
                "axis": [0.0, 0.0, 1.0],
                "position": [24.0, 0.0, 0.0],
                "restitution": 1.0,
                "friction": 0.1,
            },
            "c": {
                "type": "box",
                "bodies": ["box", "flap"],
                "sizes": [
                    [0.31533127924112314, 0.4875510441488482, 0.10312216881892558],
                    [0.23337968759366418, 0.41807358176843923, 0.5835954087775596],
                ],
                "restitution": 0.6031343118603897,
            }
        },
        "solver": {
            "step_size": 0.1,
            "assemble": False,
            "order": 2,
            "rest_speed": 1000.0,
            "rest_time": 1.0,
        },
        "experiment": {"step_size": 0.2, "stop_time": 10.0},
    }  # fmt: skip


@pytest.mark.parametrize("h", [0.1, 0.02, 0.005])
def test_a_box_that_slides_over_an_edge_flies_on(h):
    # Where the edge ends at t = 0.186 s the surface falls away at 2.5 m/s. From there on the box
    # falls freely, and the flap, whose centre is on its hinge, turns as fast as before.
    scene = box_over_an_edge()
    scene["solver"]["step_size"] = h
    box = run(scene)
    box.advance(0.0, 0.19)
    before = [float(box[name]) for name in ("box.vx", "box.vy", "box.vz")]
    turns = float(box["flap.wy"])
    box.advance(0.19, 0.01)
    assert box["c.force"] == 0.0
    assert box["box.vx"] == pytest.approx(before[0], abs=1e-12)
    assert box["box.vy"] == pytest.approx(before[1], abs=1e-12)
    assert box["box.vz"] == pytest.approx(before[2] - 9.81 * 0.01, abs=1e-12)
    assert turns == pytest.approx(2.759, abs=1e-3)  # at each step
    assert box["energy.error"] < 1e-12
