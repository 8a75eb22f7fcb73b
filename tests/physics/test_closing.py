"""Mechanisms that are drawn far off are closed, next to their drawing; poses are closed forms."""

from __future__ import annotations

import math

import pytest

import solver
from solver.runtime.layout import CLOSINGS
from solver.scene import SceneError
from tests.support.fmus.fmu_instance import instance
from tests.support.fmus.native_fmus import native_fmu
from tests.support.mechanisms.excavator import (
    BODIES,
    DRAWN,
    OTHERS,
    SCENE,
    STROKES,
    branches,
    farthest,
)
from tests.support.mechanisms.straight_arm import HANDS, arm, targets

ROUND_OFF = 1e-9  # [m] of 2 m: rows hold to 1e-10 of the size where a pose is close to straight


def start(text: str, **overrides) -> tuple[solver.Integrator, list[str]]:
    said: list[str] = []
    model = solver.assemble(solver.loads(text, overrides=overrides))
    integrator = solver.Integrator(model, log=said.append)
    integrator.initialise()
    return integrator, said


def reaches(kind: str, target: list[float]) -> bool:
    integrator, _ = start(arm(kind, target))
    hand = [float(integrator[f"{HANDS[kind]}.{axis}"]) for axis in "xyz"[: len(target)]]
    return math.dist(hand, target) < ROUND_OFF and float(integrator["constraint.position"]) < 1e-10


@pytest.mark.parametrize("far", [0.1, 0.3, 0.6, 1.0])
@pytest.mark.parametrize("kind", HANDS)
def test_a_straight_arm_reaches_what_is_in_reach(kind, far):
    assert all(reaches(kind, target) for target in targets(kind, far, 3, seed=7))


@pytest.mark.parametrize("reach", [1.5, 0.3])
def test_an_arm_bends_where_nothing_tells_it_which_way(reach):
    """The hand is asked for along the arm: 2 cos(e/2) = reach, e the angle of the elbow."""
    integrator, said = start(arm("plane", [reach, 0.0]))
    assert abs(float(integrator["elbow.angle"])) == pytest.approx(2.0 * math.acos(reach / 2.0))
    assert "another pose closes it, too" in said[0]


def test_what_is_out_of_reach_is_told_with_the_gaps_of_the_best_pose():
    """0.5 m are missing, shared alike by three points: then the sum of squares is smallest."""
    with pytest.raises(SceneError) as caught:
        start(arm("plane", [2.5, 0.0]))
    text = str(caught.value)
    assert "joints contradict each other" in text
    for name in ("joint 'shoulder'", "joint 'elbow'", "driver 'hand'"):
        assert f"{name} (0.167 m)" in text


def driven(*drivers: str) -> str:
    """Arm in the plane whose joints are driven."""
    lines = "\n".join(drivers)
    head = arm("plane", [0.0, 0.0]).partition("[drivers]")[0]
    return f"{head}[drivers]\n{lines}\n[solver]\nassemble = true\n"


FAR_LEGS = """
name = "legs"
dimension = 2
gravity = [0, 0]
[bodies]
left = { position = [0, 0], orientation = 0.3, mass = 1, inertia = 1, points = { foot = [0, 0], tip = [1, 0] } }
right = { position = [3, 0], orientation = "pi - 0.3", mass = 1, inertia = 1, points = { foot = [0, 0], tip = [1, 0] } }
[joints]
hip = { type = "revolute", points = ["ground", "left.foot"], at = [0, 0] }
knee = { type = "revolute", points = ["left.tip", "right.tip"] }
[drivers]
foot = { type = "position", point = "right.foot", value = [1.2, 0] }
[solver]
assemble = true
"""  # noqa: E501


def test_drivers_help_joints_that_do_not_close_before():
    """Legs of 1 m, their feet drawn 3 m apart and led to 1.2 m: a triangle, 0.8 m high."""
    integrator, _ = start(FAR_LEGS)
    tip = [float(integrator[f"left.tip.{axis}"]) for axis in "xy"]
    assert tip == pytest.approx([0.6, 0.8], abs=ROUND_OFF)
    assert integrator.state.head["closing"] == CLOSINGS.index("on_path")


def test_angles_that_contradict_places_are_told_in_rad():
    """The angle of a link, and a place of its tip, beside the circle of that angle."""
    text = driven(
        'one = { type = "angle", joint = "shoulder", value = 0.3 }',
        'tip = { type = "position", point = "upper.tip", value = [0.0, 1.0] }',
    )
    with pytest.raises(SceneError, match=r"driver 'one' \(0\.\d+ rad\), driver 'tip' \(0\.\d+ m\)"):
        start(text)


def test_drivers_turn_joints_by_more_than_half_a_turn():
    text = driven(
        'one = { type = "angle", joint = "shoulder", value = 4 }',
        'two = { type = "angle", joint = "elbow", value = -7 }',
    )
    integrator, _ = start(text)
    assert float(integrator["shoulder.angle"]) == pytest.approx(4.0, abs=1e-12)
    assert float(integrator["elbow.angle"]) == pytest.approx(-7.0, abs=1e-12)
    assert float(integrator["lower.tip.x"]) == pytest.approx(math.cos(4.0) + math.cos(-3.0))


def test_what_moves_far_is_said_with_way_and_angle():
    _, said = start(arm("plane", [1.2, 0.8]))
    assert len(said) == 1
    assert "closing the mechanism moved lower by 0.513 m and 1.35 rad" in said[0]
    assert "upper" not in said[0]  # by 0.09 m and 0.18 rad


def test_what_moves_a_little_is_not_said():
    one = '{ type = "angle", joint = "shoulder", value = 0.05 }'
    assert start(driven(f"one = {one}", f"two = {one.replace('shoulder', 'elbow')}"))[1] == []


def poses_of(integrator: solver.Integrator) -> list[float]:
    return [float(integrator[f"{body}.angle"]) for body in BODIES]


@pytest.mark.parametrize("strokes", STROKES[::8], ids=str)
def test_an_excavator_is_closed_on_the_branch_that_is_drawn(strokes):
    names = (f"{name}_stroke" for name in ("boom", "stick", "bucket"))
    integrator, _ = start(SCENE, **dict(zip(names, strokes, strict=True)))
    assert farthest(poses_of(integrator), branches(*strokes)[DRAWN]) < 1e-9


@pytest.mark.parametrize("strokes", OTHERS[4::21], ids=str)
def test_an_excavator_keeps_its_branch_at_all_strokes(strokes):
    """Four bars stand at a dead centre in the drawing: joints are closed before drivers move."""
    test_an_excavator_is_closed_on_the_branch_that_is_drawn(strokes)


def fmu_poses(strokes: list) -> list[float]:
    """Largest error of an angle in each pose, of a native FMU by its inputs."""
    errors = []
    with instance(native_fmu(solver.assemble(solver.loads(SCENE)))) as fmu:
        for boom, stick, bucket in strokes:
            fmu.fmu.reset()
            fmu.initialise(boom_stroke=boom, stick_stroke=stick, bucket_stroke=bucket)
            angles = [float(fmu.get(f"{body}.angle")) for body in BODIES]
            errors.append(farthest(angles, branches(boom, stick, bucket)[DRAWN]))
    return errors


def test_an_fmu_closes_it_with_its_inputs():
    assert max(fmu_poses(STROKES[3::11])) < 1e-9


CRANKS = """
name = "cranks"
dimension = 2
gravity = [0, -9.81]
[bodies]
coupler = { position = [0.764842, 0.644218], mass = 2, inertia = 0.5, points = { p0 = [0, 0], p1 = [1, 0], p2 = [2, 0] } }
c0 = { position = [0, 0], orientation = 0.7, mass = 1, inertia = 0.1, points = { tip = [1, 0] } }
c1 = { position = [1, 0], orientation = ANGLE, mass = 1, inertia = 0.1, points = { tip = [1, 0] } }
c2 = { position = [2, 0], orientation = 0.7, mass = 1, inertia = 0.1, points = { tip = [1, 0] } }
[joints]
a0 = { type = "revolute", points = ["ground", "c0"], at = [0, 0] }
a1 = { type = "revolute", points = ["ground", "c1"], at = [1, 0] }
a2 = { type = "revolute", points = ["ground", "c2"], at = [2, 0] }
b0 = { type = "revolute", points = ["c0.tip", "coupler.p0"] }
b1 = { type = "revolute", points = ["c1.tip", "coupler.p1"] }
b2 = { type = "revolute", points = ["c2.tip", "coupler.p2"] }
[solver]
assemble = true
step_size = 0.001
"""  # noqa: E501 - one body a line


@pytest.mark.parametrize("tolerance", [0.0, 1e-8])
@pytest.mark.parametrize("error", [1e-4, 0.01, 0.02, -0.02])
def test_three_parallel_cranks_are_closed_and_move_as_one(error, tolerance):
    """One of three is redundant. All turn alike: I w^2/2 + m g sin(a) is kept, I = 3 J + m."""
    text = CRANKS.replace("ANGLE", str(0.7 + error))
    integrator, _ = start(text)
    integrator["solver.tolerance"] = tolerance
    drawn = float(integrator["c0.angle"])
    assert drawn == pytest.approx(0.7, abs=abs(error))
    for _ in range(20):
        integrator.advance(integrator.time, 0.01)
    angles = [float(integrator[f"c{k}.angle"]) for k in range(3)]
    assert angles == pytest.approx([angles[0]] * 3, abs=ROUND_OFF)
    fallen = 2.0 * 9.81 * (math.sin(drawn) - math.sin(angles[0]))
    speed = float(integrator["c0.angular_velocity"])
    assert 0.5 * 2.3 * speed**2 == pytest.approx(fallen, rel=1e-9)
