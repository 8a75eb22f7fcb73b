"""Springs and dampers whose joints move as a drawing is closed mean what they did."""

from __future__ import annotations

import pytest

import solver
from tests.scene.test_closed_text import arm, start, start_silent

SPRUNG = """
[constraints]
held = { value = "shoulder.angle - 0.2" }
[profiles]
law = { x = [-4, 0, 4], y = [-2, 0, 3] }
[forces]
coil = { type = "torsion_spring", joint = "shoulder", torque = "law(angle)" }
rope = { type = "spring", points = ["ground", "lower.tip"], at = [1, 1], force = "4*elongation**3" }
[solver]
assemble = true
tolerance = 1e-9
"""


def test_springs_of_joints_and_by_curves_mean_what_they_did():
    text = arm("plane", [1.2, 0.8]).partition("[drivers]")[0] + SPRUNG
    text = text.replace("position = [0.0, 0.0] }", "position = [0.0, 0.0], stiffness = 3 }")
    text = text.replace(
        "position = [1.0, 0.0] }",
        'position = [1.0, 0.0], stiffness = 2, damping = 0.1, free_angle = "2*0.05" }',
    )
    text = text.replace("lower = { position = [1.5, 0.0],", "lower = { position = [1.5, 0.1],")
    closing = solver.close(solver.loads(text))
    before, after = start_silent(text), start(closing.text)
    for step in range(20):
        for name in ("lower.x", "lower.y", "lower.angle", "shoulder.spring", "elbow.spring",
                     "coil.torque", "rope.force"):  # fmt: skip
            assert float(after[name]) == pytest.approx(float(before[name]), abs=1e-6)
        for integrator in (before, after):
            integrator.advance(0.05 * step, 0.05)
    remarks = "\n".join(closing.remarks)
    for said in (
        "joints.shoulder.free_angle: -0.2 is added, since shoulder.angle is 0.2 rad less",
        "forces.coil.free_angle: -0.2 is added",
        "joints.elbow.free_angle: ",
        "forces.rope.free_length: ",
    ):
        assert said in remarks


DAMPED = """
name = "damped"
dimension = 2
[bodies]
arm = { position = [0, 0], orientation = 0.1, mass = 1, inertia = 1, angular_velocity = 1 }
[joints]
pin = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
other = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
[forces]
brake = { type = "torsion_damper", joint = "pin", torque = "rate*(1 + angle**2)" }
[constraints]
held = { value = "other.angle - 0.2" }
[solver]
assemble = true
"""


def test_a_damper_that_reads_its_angle_reads_what_it_counted_from_the_old_drawing():
    closing = solver.close(solver.loads(DAMPED))
    assert 'torque = "rate*(1 + (angle + 0.2)**2)"' in closing.text
    assert any("brake.torque" in x and "since pin.angle is 0.2 rad less" in x
               for x in closing.remarks)  # fmt: skip
