"""Drivers of angles that ask for many turns at the start.

The angle is theirs, and the pose is that of a motion from the drawing.
"""

from __future__ import annotations

import math

import pytest

from solver.closing import close
from solver.mechanics.assembly import assemble_parts
from solver.runtime import Integrator
from solver.scene import Rigid, SceneError, loads

_BODY = "mass = 1, inertia = 0.1"
_SOLVER = "[solver]\nassemble = true\nstep_size = 0.001\n"
CRANK = f"""
name = "slider_crank"
dimension = 2
[bodies]
crank = {{{{ position = [0, 0], {_BODY}, points = {{{{ tip = [0.3, 0] }}}} }}}}
rod = {{{{ position = [0.3, 0], {_BODY}, points = {{{{ end = [1.0, 0] }}}} }}}}
[joints]
a = {{{{ type = "revolute", bodies = ["ground", "crank"], position = [0, 0] }}}}
b = {{{{ type = "revolute", points = ["crank.tip", "rod"] }}}}
s = {{{{ type = "point_on_line", point = "rod.end", body = "ground", axis = [1, 0] }}}}
[drivers]
m = {{{{ type = "angle", joint = "a", value = "{{angle}}" }}}}
{_SOLVER}"""
GEAR = f"""
name = "gear"
dimension = 2
[bodies]
pinion = {{{{ position = [0, 0], {_BODY} }}}}
wheel = {{{{ position = [1, 0], {_BODY} }}}}
[joints]
a = {{{{ type = "revolute", bodies = ["ground", "pinion"], position = [0, 0] }}}}
b = {{{{ type = "revolute", bodies = ["ground", "wheel"], position = [1, 0] }}}}
g = {{{{ type = "gear", joints = ["a", "b"], ratio = {{ratio}} }}}}
[drivers]
m = {{{{ type = "angle", joint = "a", value = "{{angle}}" }}}}
{{more}}
{_SOLVER}"""
ROLLING = f"""
name = "cart"
dimension = 2
[bodies]
cart = {{{{ position = [0, 0.5], {_BODY} }}}}
wheel = {{{{ position = [0, 0.5], {_BODY} }}}}
[joints]
slide = {{{{ type = "prismatic", bodies = ["ground", "cart"], axis = [1, 0] }}}}
a = {{{{ type = "revolute", bodies = ["cart", "wheel"], position = [0, 0.5] }}}}
roll = {{{{ type = "rolling", body = "wheel", radius = 0.5 }}}}
[drivers]
m = {{{{ type = "angle", joint = "a", value = "{{angle}}" }}}}
{_SOLVER}"""
PLANETARY = f"""
name = "planetary"
dimension = 2
[bodies]
carrier = {{{{ position = [0, 0], {_BODY} }}}}
planet = {{{{ position = [1, 0], {_BODY} }}}}
ring = {{{{ position = [0, 0], {_BODY} }}}}
[joints]
held = {{{{ type = "fixed", bodies = ["ground", "ring"], position = [2, 0] }}}}
a = {{{{ type = "revolute", bodies = ["ground", "carrier"], position = [0, 0] }}}}
r = {{{{ type = "revolute", bodies = ["carrier", "ring"], position = [0, 0] }}}}
p = {{{{ type = "revolute", bodies = ["carrier", "planet"], position = [1, 0] }}}}
g = {{{{ type = "gear", joints = ["r", "p"], ratio = 1.7 }}}}
[drivers]
m = {{{{ type = "angle", joint = "a", value = "{{angle}}" }}}}
{_SOLVER}"""
ROCKER = f"""
name = "rocker"
dimension = 2
[bodies]
c = {{{{ position = [0, 0], {_BODY} }}}}
k = {{{{ position = [0.9, 0], {_BODY} }}}}
r = {{{{ position = [1, 0], {_BODY} }}}}
[joints]
a = {{{{ type = "revolute", bodies = ["ground", "c"], position = [0, 0] }}}}
b = {{{{ type = "revolute", bodies = ["c", "k"], position = [0, 0.9] }}}}
d = {{{{ type = "revolute", bodies = ["k", "r"], position = [1, 0.8] }}}}
e = {{{{ type = "revolute", bodies = ["ground", "r"], position = [1, 0] }}}}
[drivers]
m = {{{{ type = "angle", joint = "a", value = "{{angle}}" }}}}
{_SOLVER}"""
ROUND_OFF = 1e-9
"""Of a closed pose; an angle of so many turns has its last digit at 1e-16 of it."""


def closed(text: str) -> tuple[Integrator, list[str]]:
    """Closed mechanism after 10 steps of 1 ms, and what was said."""
    said: list[str] = []
    integrator = Integrator(assemble_parts(loads(text))[1], log=said.append)
    integrator.initialise()
    for _ in range(10):
        integrator.advance(integrator.time, 1e-3)
    return integrator, said


@pytest.mark.parametrize("angle", [99.0, 101.0, -250.0, 1000.0, 200.0 * math.pi, 1e8])
def test_a_slider_crank_is_closed_at_any_number_of_turns(angle):
    run, said = closed(CRANK.format(angle=angle))
    assert run["a.angle"] == pytest.approx(angle, rel=1e-15, abs=ROUND_OFF)
    # l = 1 m, r = 0.3 m: x = r cos a + sqrt(l^2 - (r sin a)^2)
    end = 0.3 * math.cos(angle) + math.sqrt(1.0 - (0.3 * math.sin(angle)) ** 2)
    assert run["rod.end.x"] == pytest.approx(end, abs=ROUND_OFF + 1e-15 * abs(angle))
    assert not any("branch" in sentence or "pose" in sentence for sentence in said)


def test_a_driver_that_moves_on_starts_at_its_turns():
    run, _ = closed(CRANK.format(angle="150 + 3*t"))
    assert run["a.angle"] == pytest.approx(150.03, abs=ROUND_OFF)


@pytest.mark.parametrize("ratio", [-3.0, 0.5, 0.37, math.sqrt(2.0)])
@pytest.mark.parametrize("angle", [50.0, -150.0, 1000.0])
def test_both_wheels_of_a_gear_count_their_turns(ratio, angle):
    run, _ = closed(GEAR.format(ratio=ratio, angle=angle, more=""))
    assert run["b.angle"] == pytest.approx(ratio * angle, abs=ROUND_OFF)
    assert math.remainder(run["wheel.angle"] - ratio * angle, 2.0 * math.pi) == pytest.approx(
        0.0, abs=ROUND_OFF
    )


def test_a_planet_turns_as_far_as_its_carrier_drives_it():
    # The ring stands still, so that it turns by -angle in axes of the carrier.
    run, _ = closed(PLANETARY.format(angle=200.0))
    assert run["r.angle"] == pytest.approx(-200.0, abs=ROUND_OFF)
    assert run["p.angle"] == pytest.approx(-340.0, abs=ROUND_OFF)


def test_a_wheel_rolls_as_far_as_its_turns_lead():
    run, _ = closed(ROLLING.format(angle=300.0))
    assert run["cart.x"] == pytest.approx(-150.0, abs=ROUND_OFF)


def test_a_rocker_that_makes_no_turn_has_those_of_its_driver():
    # 120 rad are 19 turns and 0.6190 rad, which the rocker reaches.
    run, said = closed(ROCKER.format(angle=120.0))
    assert run["a.angle"] == pytest.approx(120.0, abs=ROUND_OFF)
    assert not any("branch" in sentence for sentence in said)


def test_drivers_of_both_wheels_that_agree_are_closed_and_others_told_in_radians():
    second = 'n = {{ type = "angle", joint = "b", value = "{}" }}'
    run, _ = closed(GEAR.format(ratio=2, angle=300, more=second.format(600)))
    assert run["b.angle"] == pytest.approx(600.0, abs=ROUND_OFF)
    with pytest.raises(SceneError, match=r"joint 'g' \([0-9.e-]+ rad\)"):
        closed(GEAR.format(ratio=2, angle=300, more=second.format(602)))


def test_a_scene_that_is_written_closed_has_no_turns_left():
    drawn = CRANK.format(angle="150 + 3*t")
    text = close(loads(drawn)).text
    crank = loads(text).bodies["crank"]
    angle = math.remainder(150.0, 2.0 * math.pi)  # -0.7964 rad
    assert isinstance(crank, Rigid)
    assert crank.rotation[1][0] == pytest.approx(math.sin(angle), abs=ROUND_OFF)
    assert "orientation = -0.796" in text
    run, _ = closed(text)
    assert run["a.angle"] == pytest.approx(0.03, abs=ROUND_OFF)


def test_an_equilibrium_keeps_the_turns_of_a_driver():
    text = CRANK.format(angle=100.0).replace("[solver]", '[solver]\nstart = "equilibrium"')
    run, _ = closed(text)
    assert run["a.angle"] == pytest.approx(100.0, abs=ROUND_OFF)
