"""A body on a ball and a rod closes at any pose within reach, however heavy a load hangs at it."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import solver

SCENE = """
name = "loaded"
[points]
load = {{ position = {load}, mass = {mass} }}
[bodies.arm]
position = {origin}
orientation = {{ rotation_vector = {turn} }}
mass = 1
inertia = [0.2, 0.25, 0.3]
center_of_mass = {centre}
points = {{ root = {root}, tip = {tip} }}
angular_velocity = {omega}
[joints]
ball = {{ type = "spherical", points = ["ground", "arm.root"], at = [0, 0, 0] }}
rod = {{ type = "distance", points = ["ground", "arm.tip"], at = {anchor}, length = {length} }}
rope = {{ type = "distance", points = ["load", "arm.tip"] }}
[solver]
assemble = true
"""


@pytest.mark.parametrize("mass", [1e-4, 1.0, 1e4, 1e8])
def test_an_arm_closes_and_keeps_its_velocity_beside_a_load(mass):
    """Turning about the way d from ball to anchor keeps the tip r as far from it.

    (d - r) . (d x r) = 0 allows w = 3 d.

    Given velocities are kept but for 1e-9 of the fastest motion, which is 3 a times a few metres.
    """
    draw = np.random.default_rng(7)
    for _ in range(25):
        anchor, root, tip, centre, turn = draw.normal(size=(5, 3))
        root, tip, centre = 0.5 * root, 0.5 * tip, 0.5 * centre
        drawn = Rotation.from_rotvec(turn)
        origin = -drawn.apply(root)
        reach, a = np.linalg.norm(tip - root), np.linalg.norm(anchor)
        length = abs(a - reach) + draw.uniform(0.05, 1.95) * min(a, reach)
        omega = 3.0 * anchor
        vectors = {
            "load": origin + drawn.apply(tip) + [1.0, 0.0, 0.0], "origin": origin, "turn": turn,
            "centre": centre, "root": root, "tip": tip, "omega": omega, "anchor": anchor,
        }  # fmt: skip
        lists = {name: x.tolist() for name, x in vectors.items()}
        text = SCENE.format(mass=mass, length=float(length), **lists)
        run = solver.Integrator(solver.assemble(solver.loads(text)), log=lambda _: None)
        run.initialise()
        assert float(run["constraint.position"]) < 1e-9
        assert float(run["constraint.velocity"]) < 1e-11
        found = [float(run[f"arm.w{x}"]) for x in "xyz"]
        assert found == pytest.approx(omega, abs=1e-8 * a)
        place = [float(run[f"arm.{x}"]) for x in "xyz"]
        speed = [float(run[f"arm.v{x}"]) for x in "xyz"]
        assert speed == pytest.approx(np.cross(omega, place), abs=1e-8 * a)
