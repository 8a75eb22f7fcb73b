"""Contacts at a start at the equilibrium: statics by hand, and nothing moves from there on."""

from __future__ import annotations

import math

import pytest

import solver
from solver.runtime import Integrator
from tests.support.mechanisms.problems import GRAVITY, Content, assemble, mechanism, start


def at_rest(content: Content) -> Integrator:
    """Begin at the equilibrium and stay there for half a second."""
    run = start(content, start="equilibrium")
    forces = [f"{name}.force" for name in content["contacts"]]
    before = {name: float(run[name]) for name in forces}
    run.advance(0.0, 0.5)
    assert float(run["energy.kinetic"]) < 1e-16
    assert run["solver.events"] == 0.0
    assert float(run["energy.error"]) < 1e-11
    assert {name: float(run[name]) for name in before} == pytest.approx(before, abs=1e-6)
    return run


@pytest.mark.parametrize("friction", [None, 0.3])
def test_a_mass_on_a_spring_presses_the_floor_with_what_the_spring_does_not_carry(friction):
    """N = m g - k (l - L) of a spring under a ceiling, and 0 where the spring lifts it."""
    mass, stiffness = 2.0, 100.0
    for free, expected in ((0.95, mass * GRAVITY - stiffness * 0.05), (0.7, 0.0)):
        floor = {"type": "plane", "point": "A", "axis": [0, 1]}
        spring = {"type": "spring", "points": ["O", "A"], "free_length": free}
        content = mechanism(
            "pressed", 2, forces={"s": spring | {"stiffness": stiffness}},
            points={
                "O": {"position": [0, 1], "fixed": True}, "A": {"position": [0, 0.4], "mass": mass},
            },
            contacts={"c": floor | ({} if friction is None else {"friction": friction})},
        )  # fmt: skip
        ran = at_rest(content)
        assert ran["c.force"] == pytest.approx(expected, abs=1e-7)
        left = max(0.0, 1.0 - free - mass * GRAVITY / stiffness)
        assert ran["A.y"] == pytest.approx(left, abs=1e-9)


@pytest.mark.parametrize(("dim", "tilt"), [(2, 0.0), (2, 0.3), (3, 0.0)])
def test_a_box_that_is_drawn_above_the_floor_begins_flat_on_it(dim, tilt):
    half = 0.1
    body = {"mass": 2.0, "inertia": 0.1 if dim == 2 else [0.1] * 3}
    body |= {"position": [0.0] * (dim - 1) + [0.5]} | ({"orientation": tilt} if tilt else {})
    size = [0.6] * (dim - 1) + [2.0 * half]
    floor = {"type": "corners", "body": "box", "size": size, "friction": 0.3}
    floor["axis"] = [0.0] * (dim - 1) + [1.0]
    ran = at_rest(mechanism("laid", dim, bodies={"box": body}, contacts={"c": floor}))
    assert ran["c.force"] == pytest.approx(2.0 * GRAVITY, rel=1e-9)
    assert ran["box.z" if dim == 3 else "box.y"] == pytest.approx(half, abs=1e-10)
    if dim == 2:
        assert ran["box.angle"] == pytest.approx(0.0, abs=1e-9)


def test_a_beam_falls_onto_its_stop_which_carries_the_moment_of_its_weight():
    """M = m g l cos(angle)/2 at the stop of the hinge."""
    beam = {"mass": 3.0, "inertia": 1.0, "position": [0.5, 0.0]}
    hinge = {"type": "revolute", "bodies": ["ground", "beam"], "position": [0, 0]}
    stop = {"type": "stop", "joint": "hinge", "min": -0.4}
    content = mechanism(
        "beam", 2, bodies={"beam": beam}, joints={"hinge": hinge}, contacts={"c": stop}
    )  # fmt: skip
    ran = at_rest(content)
    assert ran["hinge.angle"] == pytest.approx(-0.4, abs=1e-10)
    assert ran["c.force"] == pytest.approx(3.0 * GRAVITY * 0.5 * math.cos(0.4), rel=1e-9)


def test_a_beam_on_two_buffers_and_a_ball_in_a_bowl_lie_where_statics_says():
    """Depth (m g/2/K)^(2/3) of each Hertzian buffer; the bottom of the bowl."""
    beam = {"mass": 3.0, "inertia": 1.0, "position": [0.0, 0.01], "points": {
        "left": [-0.5, 0.0], "right": [0.5, 0.0]}}  # fmt: skip
    law = {"type": "plane", "axis": [0, 1], "law": "hertz", "stiffness": 1e5}
    content = mechanism(
        "rests", 2, bodies={"beam": beam}, points={"ball": {"position": [3.3, 1.0], "mass": 0.5}},
        contacts={
            "left": law | {"point": "beam.left"}, "right": law | {"point": "beam.right"},
            "bowl": {"type": "surface", "point": "ball", "surface": "y - (x - 3)**2"},
        },
    )  # fmt: skip
    ran = at_rest(content)
    assert ran["beam.y"] == pytest.approx(-((1.5 * GRAVITY / 1e5) ** (2.0 / 3.0)), rel=1e-9)
    assert [ran["ball.x"], ran["ball.y"]] == pytest.approx([3.0, 0.0], abs=1e-9)
    assert ran["bowl.force"] == pytest.approx(0.5 * GRAVITY, rel=1e-9)


def test_a_block_on_a_slope_has_no_equilibrium_but_that_of_its_stop():
    """Friction holds nothing while it is sought; against a smooth floor and wall m g (cos, sin)."""
    slope = 0.3
    block = {"position": [0.0, 0.0], "mass": 2.0}
    contacts = {"c": {"type": "plane", "point": "A", "axis": [0, 1], "friction": 0.8}}
    content = mechanism("slope", 2, points={"A": block}, contacts=contacts)
    content["gravity"] = [GRAVITY * math.sin(slope), -GRAVITY * math.cos(slope)]
    with pytest.raises(solver.SceneError, match="no static equilibrium was found"):
        assemble(content, start="equilibrium")
    del contacts["c"]["friction"]
    contacts["wall"] = {"type": "plane", "point": "A", "axis": [-1, 0], "position": [0.7, 0]}
    ran = at_rest(content)
    assert ran["A.x"] == pytest.approx(0.7, abs=1e-10)
    assert ran["c.force"] == pytest.approx(2.0 * GRAVITY * math.cos(slope), rel=1e-9)
    assert ran["wall.force"] == pytest.approx(2.0 * GRAVITY * math.sin(slope), rel=1e-9)


def test_a_pendulum_whose_hinge_rubs_begins_hanging_down():
    bar = {"mass": 3.0, "inertia": 1.0, "position": [0.5, -0.1]}
    hinge = {
        "type": "revolute", "bodies": ["ground", "bar"], "position": [0, 0],
        "friction": {"coefficient": 0.1, "radius": 0.05},
    }  # fmt: skip
    content = mechanism("hangs", 2, bodies={"bar": bar}, joints={"hinge": hinge}, contacts={})
    ran = at_rest(content)
    assert [ran["bar.x"], ran["bar.y"]] == pytest.approx([0.0, -math.hypot(0.5, 0.1)], abs=1e-9)
