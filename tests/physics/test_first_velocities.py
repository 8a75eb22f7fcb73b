"""Velocities at the start lie on the rows at any ratio of masses, and belong to a motion."""

from __future__ import annotations

import pytest

import solver
from solver.scene import SceneError

LIGHT = """
name = "light"
[bodies]
B0 = {{ position = [0, 0, 0], mass = {m!r}, inertia = [{J!r}, {J!r}, {J!r}], points = {{ root = [0.3, 0.2, 0.1] }} }}
B1 = {{ position = [1.5, 0, 0], mass = 1, inertia = [0.2, 0.25, 0.3], points = {{ tip = [0.2, 0.3, 0.5] }}, angular_velocity = [0.7, -0.4, -1.25] }}
[joints]
J0 = {{ type = "revolute", bodies = ["ground", "B0"], position = [0, 0, 0], axis = [0, 0, 1] }}
J1 = {{ type = "universal", bodies = ["B0", "B1"], position = [1, 0, 0], axes = [[0, 0, 1], [0, 1, 0]] }}
J2 = {{ type = "distance", points = ["B0.root", "B1.tip"] }}
[drivers]
D0 = {{ type = "angle", joint = "J0", value = "0*t" }}
[solver]
assemble = true
{settings}
"""  # noqa: E501


def start(text: str) -> solver.Integrator:
    integrator = solver.Integrator(solver.assemble(solver.loads(text)), log=lambda _: None)
    integrator.initialise()
    return integrator


@pytest.mark.parametrize("settings", ["", "tolerance = 1e-6"], ids=["steps", "tolerance"])
@pytest.mark.parametrize("mass", [1e-12, 1e-9, 1e-6, 1.0, 1e6, 1e12])
def test_velocities_lie_on_the_rows_at_any_ratio_of_masses(mass, settings):
    """B0 is held: w = (0, wy, wz) of B1 keeps the distance, d . (w x r) = 0.42 wy - 0.35 wz = 0."""
    run = start(LIGHT.format(m=mass, J=0.2 * mass, settings=settings))
    assert float(run["constraint.velocity"]) < 1e-14
    assert float(run["B1.wx"]) == pytest.approx(0.0, abs=1e-14)
    assert float(run["B1.wz"]) == pytest.approx(1.2 * float(run["B1.wy"]), rel=1e-12)
    assert float(run["B1.wz"]) < -0.9  # it moves as the given velocity does
    for step in range(5):
        run.advance(0.01 * step, 0.01)
    assert float(run["energy.error"]) < 1e-10  # round-off of 1e-16 m moves 1e-12 kg far
    assert float(run["constraint.position"]) < 1e-12


PARALLEL = """
name = "dead"
dimension = 2
[bodies.a]
position = [0, 0]
mass = 1
inertia = 0.1
points = { e = [1, 0] }
angular_velocity = 3
[bodies.c]
position = [2, 0]
mass = 1
inertia = 0.1
points = { e = [1, 0] }
[bodies.k]
position = [1, 0]
mass = 1
inertia = 0.3
center_of_mass = [1, 0]
points = { l = [0, 0], r = [2, 0] }
[joints]
A = { type = "revolute", bodies = ["ground", "a"], position = [0, 0] }
C = { type = "revolute", bodies = ["ground", "c"], position = [2, 0] }
ka = { type = "revolute", points = ["a.e", "k.l"] }
kc = { type = "revolute", points = ["c.e", "k.r"] }
[solver]
assemble = true
"""


def test_velocities_of_no_branch_are_refused_at_a_dead_centre():
    with pytest.raises(SceneError) as caught:
        start(PARALLEL)
    text = str(caught.value)
    assert "singular place, a dead centre" in text
    assert all(f"joint '{name}'" in text for name in ("A", "C", "ka", "kc"))
    assert "give a velocity that chooses one, such as that of body 'c', body 'k'" in text
    assert "lengths" not in text


@pytest.mark.parametrize(
    ("given", "ratio"),
    [("[bodies.k]\nvelocity = [0, 3]", 1.0), ("[bodies.c]\nangular_velocity = 3", 1.0),
     ("[bodies.c]\nangular_velocity = -9", -3.0)],
    ids=["of the coupler", "of the crank", "of the other branch"],
)  # fmt: skip
def test_a_velocity_chooses_the_branch(given, ratio):
    """With a = 3 rad/s two velocities of c keep the distance of the pins, 3 and -9 rad/s.

    4 = (2 - (c^2 - 9) t^2/2)^2 + (c - 3)^2 t^2.
    """
    head = given.partition("\n")[0]
    run = start(PARALLEL.replace(head, given))
    assert float(run["c.angular_velocity"]) == pytest.approx(3.0 * ratio, rel=1e-9)
    run.advance(0.0, 0.001)
    assert float(run["c.angle"]) == pytest.approx(ratio * float(run["a.angle"]), rel=1e-2)


def test_a_mechanism_at_rest_in_a_dead_centre_starts():
    run = start(PARALLEL.replace("angular_velocity = 3\n", ""))
    assert float(run["constraint.velocity"]) == 0.0


def test_a_driver_that_moves_out_of_a_stretched_arm_is_told():
    """At full reach the hand cannot move along the arm: 1 m/s are missing."""
    text = """
name = "arm"
dimension = 2
[bodies]
upper = { position = [0.5, 0], mass = 1, inertia = 0.1, points = { root = [-0.5, 0], tip = [0.5, 0] } }
lower = { position = [1.5, 0], mass = 1, inertia = 0.1, points = { root = [-0.5, 0], tip = [0.5, 0] } }
[joints]
shoulder = { type = "revolute", points = ["ground", "upper.root"], at = [0, 0] }
elbow = { type = "revolute", points = ["upper.tip", "lower.root"] }
[drivers]
hand = { type = "position", point = "lower.tip", value = ["2 - t", 0] }
[solver]
assemble = true
"""  # noqa: E501
    with pytest.raises(SceneError, match="no velocities at this place that its joints and drivers"):
        start(text)


LOADED_CRANK = """
name = "loaded"
dimension = 2
[bodies.crank]
position = [0, 0]
mass = 1e-3
inertia = 1e-4
points = {{ e = [0.3, 0] }}
angular_velocity = 5
[bodies.load]
position = [0.3, 0]
mass = {mass!r}
inertia = {mass!r}
points = {{ s = [0, 0] }}
[joints]
O = {{ type = "revolute", bodies = ["ground", "crank"], position = [0, 0] }}
pin = {{ type = "revolute", points = ["crank.e", "load.s"] }}
[solver]
assemble = true
"""


@pytest.mark.parametrize("mass", [1.0, 1e3, 1e6, 1e9, 1e12])
def test_a_given_velocity_is_kept_beside_parts_of_any_mass(mass):
    """The pin of the load goes along: v = w x r = 5 rad/s x 0.3 m."""
    run = start(LOADED_CRANK.format(mass=mass))
    assert float(run["crank.angular_velocity"]) == pytest.approx(5.0, rel=1e-9)
    assert float(run["load.vy"]) == pytest.approx(1.5, rel=1e-9)


TURNED_CRANK = """
name = "turned"
dimension = 2
[bodies]
crank.points.e = [0, 1.2]
crank.position = [0, 0]
crank.mass = 1
crank.inertia = 0.1
crank.angular_velocity = 5
rocker = { position = [2, 0], mass = 1000, inertia = 1000, points = { e = [0, 1.3] } }
[joints]
O = { type = "revolute", bodies = ["ground", "crank"], position = [0, 0] }
P = { type = "revolute", bodies = ["ground", "rocker"], position = [2, 0] }
rod = { type = "distance", points = ["crank.e", "rocker.e"], length = 1.4 }
[solver]
assemble = true
"""


def test_a_body_that_closing_turns_keeps_its_given_angular_velocity():
    """Closing turns it by 0.55 rad; velocities of 5 rad/s across its drawn axis are 4.26 rad/s."""
    run = start(TURNED_CRANK)
    assert abs(float(run["crank.angle"])) > 0.3
    assert float(run["crank.angular_velocity"]) == pytest.approx(5.0, rel=1e-9)


DEAD_CENTRE = """
name = "stretched"
dimension = 2
[bodies]
crank = { position = [0, 0], mass = 1, inertia = 0.1 }
rod = { position = [1.5, 0], mass = 1, inertia = 0.1 }
slider = { position = [2.5, 0], mass = 1, inertia = 0.1, velocity = [1, 0] }
[joints]
O = { type = "revolute", bodies = ["ground", "crank"], position = [0, 0] }
A = { type = "revolute", bodies = ["crank", "rod"], position = [0.5, 0] }
B = { type = "revolute", bodies = ["rod", "slider"], position = [2.5, 0] }
guide = { type = "prismatic", bodies = ["ground", "slider"], position = [2.5, 0], axis = [1, 0] }
[solver]
assemble = true
"""


def test_a_given_velocity_that_joints_do_not_allow_is_told():
    """At full reach the slider cannot move along its guide: all of its 1 m/s is lost."""
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(DEAD_CENTRE)), log=said.append)
    run.initialise()
    assert abs(float(run["slider.vx"])) < 1e-12
    told = "joints do not allow the velocity that is given for body 'slider': it starts 1 m/s away"
    assert said == [f"{told} from it; give velocities that belong to one motion, or one alone"]


GEARED = """
name = "geared"
dimension = 2
[bodies]
arm = {{ position = [0, 0], mass = 1, inertia = {arm}, angular_velocity = 5 }}
rotor = {{ position = [3, 0], mass = 1, inertia = {rotor} }}
[joints]
P = {{ type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }}
Q = {{ type = "revolute", bodies = ["ground", "rotor"], position = [3, 0] }}
gear = {{ type = "gear", joints = ["P", "Q"], ratio = {ratio} }}
[solver]
assemble = true
"""


@pytest.mark.parametrize("ratio", [-10, 100, 1000, 10000])
@pytest.mark.parametrize(("arm", "rotor"), [(1.0, 1.0), (1.0, 100.0), (1e-9, 1.0), (1e-9, 1e9)])
def test_a_given_velocity_is_kept_where_a_gear_makes_the_other_side_heavier(arm, rotor, ratio):
    """The rotor counts as ratio^2 rotor; what changes is 1e-9 of the fastest motion at most."""
    run = start(GEARED.format(arm=arm, rotor=rotor, ratio=ratio))
    assert float(run["arm.angular_velocity"]) == pytest.approx(5.0, abs=1e-9 * 5.0 * abs(ratio))
    turns = float(run["rotor.angular_velocity"])
    assert turns == pytest.approx(ratio * float(run["arm.angular_velocity"]), rel=1e-12)


def test_a_given_velocity_that_a_driver_contradicts_is_told_without_assemble_too():
    """The rod passes on what moves along it: B goes at 3 m/s, and A has been given 1 m/s."""
    text = """
name = "pushed"
dimension = 2
[points]
A = { position = [0, 0], mass = 1, velocity = [1, 2] }
B = { position = [1, 0], mass = 1 }
[joints]
rod = { type = "distance", points = ["A", "B"] }
[drivers]
hand = { type = "position", point = "B", value = ["1 + 3*t", 0] }
"""
    said: list[str] = []
    run = solver.Integrator(solver.assemble(solver.loads(text)), log=said.append)
    run.initialise()
    assert float(run["A.vx"]) == pytest.approx(3.0, rel=1e-9)
    told = (
        "joints and drivers do not allow the velocity that is given for point 'A': it starts 2 m/s"
    )
    assert said[0].startswith(told)
