"""Polyhedra that fall on a floor that rubs, stepped: each run ends, and obeys Coulomb's law."""

from __future__ import annotations

import itertools
import math
import random

import numpy as np
import pytest

import solver
from solver.runtime import Integrator
from tests.support.contact.contact_events import number
from tests.support.contact.contact_scenes import toml_of
from tests.support.mechanisms.problems import GRAVITY, Content

GOLDEN = (1.0 + math.sqrt(5.0)) / 2.0
TETRAHEDRON = [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)]
CUBE = list(itertools.product((-1.0, 1.0), repeat=3))
ICOSAHEDRON = [
    tuple(np.roll((0.0, a, b * GOLDEN), turn).tolist())
    for turn in range(3)
    for a in (-1.0, 1.0)
    for b in (-1.0, 1.0)
]
SHAPES = {"tetrahedron": TETRAHEDRON, "cube": CUBE, "icosahedron": ICOSAHEDRON}
MASS, RADIUS = 0.2, 0.05
DEFERS = {("tetrahedron", 3), ("cube", 3), ("icosahedron", 1)}
"""Runs, with their steps, in which no choice of sticking corners agrees with the forces."""


def _falling(shape: str, seed: int) -> tuple[Content, float]:
    """Polyhedron above a floor, turned, spinning and moving at random; the friction."""
    chance = random.Random(f"{shape} {seed}")
    friction, restitution = chance.uniform(0.1, 1.0), chance.choice((0.0, chance.uniform(0.0, 0.8)))
    corners = np.array(SHAPES[shape])
    corners *= RADIUS / np.linalg.norm(corners[0])
    floor = {"type": "plane", "axis": [0, 0, 1], "friction": friction, "restitution": restitution}
    die = {
        "position": [0.0, 0.0, 0.1],
        "orientation": {
            "axis": [chance.gauss(0, 1) for _ in range(3)],
            "angle": chance.uniform(0, math.pi),
        },
        "velocity": [chance.uniform(-1, 1), chance.uniform(-1, 1), chance.uniform(-1, 0)],
        "angular_velocity": [chance.uniform(-8, 8) for _ in range(3)],
        "mass": MASS,
        "inertia": [0.25 * MASS * RADIUS**2] * 3,
        "points": {f"c{i}": x for i, x in enumerate(corners.tolist())},
    }
    content: Content = {
        "name": "falling",
        "dimension": 3,
        "gravity": [0.0, 0.0, -GRAVITY],
        "bodies": {"die": die},
        "contacts": {f"c{i}": floor | {"point": f"die.c{i}"} for i in range(len(corners))},
        "solver": {"contact_mode": "stepped", "step_size": 10.0 ** chance.uniform(-3, -2)},
    }
    return content, friction


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("seed", range(6))
def test_what_falls_on_a_floor_obeys_the_laws_of_contact_to_the_end(shape, seed):
    """No pull, friction in each cone, no energy made; what rests presses with its weight."""
    content, friction = _falling(shape, seed)
    sentences: list[str] = []
    run = Integrator(solver.assemble(solver.loads(toml_of(content))), log=sentences.append)
    run.initialise()
    step, lost, deferred, hardest = content["solver"]["step_size"], 0.0, 0.0, MASS * GRAVITY
    for _ in range(math.ceil(0.6 / step)):
        run.advance(run.time, step)
        assert number(run, "energy.error") < 1e-12
        assert number(run, "energy.dissipated") >= lost - 1e-14
        lost = number(run, "energy.dissipated")
        deferred += number(run, "solver.deferred_frictions")
        for name in content["contacts"]:
            force, rubs = number(run, f"{name}.force"), abs(number(run, f"{name}.friction"))
            hardest = max(hardest, force)
            assert force >= 0.0
            assert rubs <= friction * force + 1e-8 * hardest
    assert any("deferred_frictions" in sentence for sentence in sentences) == (deferred > 0.0)
    assert deferred > 0.0 or (shape, seed) not in DEFERS
    if number(run, "energy.kinetic") < 1e-16:
        forces = sum(number(run, f"{name}.force") for name in content["contacts"])
        assert forces == pytest.approx(MASS * GRAVITY, rel=1e-9)


def test_a_box_that_lands_on_corners_that_rub_and_others_that_do_not_slides_on():
    """Nothing pulls it down: the floor stops its fall and part of its spin, and never speeds it up.

    Newton's iteration did not converge in the first half step, however short that was.
    """
    x, y, z = 0.19278497, 0.15422798, 0.37598770
    corners = {"c0": [-x, -y, -z], "c1": [x, -y, -z], "c2": [x, y, -z], "c3": [-x, y, -z]}
    floor = {"type": "plane", "axis": [0, 0, 1], "position": [0, 0, -0.375988]}
    content = {
        "name": "box",
        "dimension": 3,
        "gravity": [0.0, 0.0, 0.0],
        "bodies": {
            "box": {
                "position": [0.0, 0.0, 0.0],
                "mass": 0.975624692999621,
                "inertia": [0.007645926944796475, 0.0038748355718340524, 0.007643559450370309],
                "points": corners,
                "velocity": [0.3298312654094615, -1.5601478963542523, -1.8530649376728627],
            }
        },
        "contacts": {
            f"c{i}": floor | {"point": f"box.c{i}", "friction": 0.602995 if i == 0 else 0.0}
            for i in range(3)
        },
        "solver": {"contact_mode": "stepped", "step_size": 0.01},
    }
    run = Integrator(solver.assemble(solver.loads(toml_of(content))), log=lambda _: None)
    run.initialise()
    energy, deferred = number(run, "energy.kinetic"), 0.0
    for _ in range(20):
        run.advance(run.time, 0.01)
        deferred += number(run, "solver.deferred_frictions")
        assert number(run, "energy.kinetic") <= energy * (1.0 + 1e-12)
        energy = number(run, "energy.kinetic")
        assert all(number(run, f"c{i}.gap") > -1e-10 for i in range(3))
        assert all(number(run, f"c{i}.impulse") >= 0.0 for i in range(3))
    assert number(run, "energy.impact") > 0.0
    assert deferred > 0.0
