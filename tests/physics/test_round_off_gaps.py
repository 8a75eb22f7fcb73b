"""Gaps that only the round-off of the drawing leaves below zero: what touches there starts closed.

The numbers of a drawing are sums and products of others: 0.3 - 0.1*3 is -5.55e-17.
"""

from __future__ import annotations

import re

import pytest

import solver
from solver import SceneError

PLANE = 'name = "gap"\ndimension = 2\ngravity = [0, -9.81]\n'
SPACE = 'name = "gap"\ngravity = [0, 0, -9.81]\n'
BODY = "mass = 1, inertia = [0.1, 0.1, 0.1]"
WELD = '[joints]\nweld = { type = "fixed", bodies = ["ground", "G"] }\n'
SCENES = {
    "plane": f"""{PLANE}[points]
A = {{ position = [X, "Y + (E)"], mass = 1 }}
[contacts]
c = {{ type = "plane", point = "A", axis = [0, 1], position = [X, Y] }}""",
    "plane in space": f"""{SPACE}[points]
A = {{ position = [X, 0, "Y + (E)"], mass = 1 }}
[contacts]
c = {{ type = "plane", point = "A", axis = [0, 0, 1], position = [X, 0, Y] }}""",
    "disc that rubs": f"""{PLANE}[points]
A = {{ position = [X, "Y + 0.3 + (E)"], mass = 1 }}
[contacts.c]
type = "plane"
point = "A"
axis = [0, 1]
position = [X, Y]
radius = 0.3
friction = 1""",
    "corners": f"""{SPACE}[bodies]
A = {{ position = [X, 0, "Y + 0.1 + (E)"], {BODY} }}
[contacts.c]
type = "corners"
body = "A"
size = [0.2, 0.2, 0.2]
axis = [0, 0, 1]
position = [X, 0, Y]""",
    "cylinder": f"""{SPACE}[bodies]
A = {{ position = [X, 0, "Y + 0.2 + (E)"], {BODY} }}
[contacts.c]
type = "cylinder"
body = "A"
radius = 0.2
length = 0.1
along = [0, 1, 0]
axis = [0, 0, 1]
position = [X, 0, Y]""",
    "sphere": f"""{PLANE}[points]
O = {{ position = [X, Y], fixed = true }}
A = {{ position = [X, "Y + 0.3 + (E)"], mass = 1 }}
[contacts]
c = {{ type = "sphere", points = ["O", "A"], radii = [0.1, 0.2] }}""",
    "clearance": f"""{PLANE}[points]
O = {{ position = [X, Y], fixed = true }}
A = {{ position = [X, "Y - 0.001 + (E)"], mass = 1 }}
[contacts]
c = {{ type = "clearance", points = ["A", "O"], radius = 0.001 }}""",
    "stop": f"""{PLANE}[bodies]
A = {{ position = [X, Y], mass = 1, inertia = 0.1 }}
[joints]
j = {{ type = "prismatic", bodies = ["ground", "A"], axis = [0, 1], position = [X, Y] }}
[contacts]
c = {{ type = "stop", joint = "j", min = "-(E)" }}""",
    "stop of an angle": f"""{PLANE}[bodies]
A = {{ position = ["X + 1", Y], mass = 1, inertia = 0.1 }}
[joints]
j = {{ type = "revolute", bodies = ["ground", "A"], position = [X, Y] }}
[contacts]
c = {{ type = "stop", joint = "j", min = "-(E)" }}""",
    "rope": f"""{PLANE}[points]
O = {{ position = [X, Y], fixed = true }}
A = {{ position = [X, "Y - 0.3 + (E)"], mass = 1 }}
[contacts]
c = {{ type = "stop", points = ["O", "A"], max = 0.3 }}""",
    "surface": f"""{PLANE}[bodies]
G = {{ position = [X, Y], mass = 1, inertia = 1 }}
[points]
A = {{ position = [X, "Y + (E)"], mass = 1 }}
{WELD}[contacts]
c = {{ type = "surface", point = "A", body = "G", surface = "y + x**2" }}""",
    "profile": f"""{PLANE}[profiles]
p = {{ x = [-2, -1, 0, 1, 2], y = [0, 0, 0, 0, 0] }}
[points]
A = {{ position = [X, "Y + (E)"], mass = 1 }}
[contacts]
c = {{ type = "profile", point = "A", profile = "p", position = [X, Y] }}""",
    "height field": f"""{SPACE}[points]
A = {{ position = [X, 0, "Y + (E)"], mass = 1 }}
[contacts.c]
type = "height_field"
point = "A"
x = [-2, 0, 2]
y = [-2, 0, 2]
z = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]
position = [0, 0, Y]""",
    "superquadric": f"""{SPACE}[points]
A = {{ position = [X, 0, "Y - 0.3 + (E)"], mass = 1 }}
[contacts]
c = {{ type = "superquadric", point = "A", semi_axes = [0.5, 0.5, 0.3], position = [X, 0, Y] }}""",
    "capsule": f"""{SPACE}[bodies]
A = {{ position = [X, 0, "Y + 0.3 + (E)"], {BODY} }}
G = {{ position = [X, 0, Y], {BODY} }}
{WELD}[contacts.c]
type = "capsule"
bodies = ["A", "G"]
segments = [[[0, 0, 0]], [[-0.5, 0, 0], [0.5, 0, 0]]]
radii = [0.1, 0.2]""",
    "box": f"""{SPACE}[bodies]
A = {{ position = [X, 0, "Y + 0.15 + (E)"], {BODY} }}
G = {{ position = [X, 0, Y], {BODY} }}
{WELD}[contacts.c]
type = "box"
bodies = ["A", "G"]
sizes = [[0.1, 0.1, 0.1], [0.5, 0.5, 0.2]]
radii = [0, 0]""",
    "polygon": f"""{PLANE}[bodies]
A = {{ position = [X, "Y + 0.15 + (E)"], mass = 1, inertia = 0.1 }}
G = {{ position = [X, Y], mass = 1, inertia = 1 }}
{WELD}[contacts.c]
type = "polygon"
bodies = ["A", "G"]
corners = [
    [[-0.05, -0.05], [0.05, -0.05], [0.05, 0.05], [-0.05, 0.05]],
    [[-0.5, -0.1], [0.5, -0.1], [0.5, 0.1], [-0.5, 0.1]],
]
radii = [0, 0]""",
}


def drawn(kind: str, error: str, mode: str, x: float = 0.7, y: float = 0.3) -> solver.Scene:
    """Scene of 1 kg that rests, drawn at (x, y) with this error of its gap."""
    text = SCENES[kind].replace("E)", f"{error})")
    text = re.sub(r"\bY\b", repr(y), re.sub(r"\bX\b", repr(x), text))
    return solver.loads(f'{text}\n[solver]\ncontact_mode = "{mode}"\n')


@pytest.mark.parametrize("mode", ["located", "stepped"])
@pytest.mark.parametrize("kind", SCENES)
@pytest.mark.parametrize("error", ["0.3 - 0.1*3", "-1e-12", "0.1*3 - 0.3"])
def test_what_rests_starts_closed_and_stays(kind, error, mode):
    run = solver.simulate(drawn(kind, error, mode), stop_time=0.1, step_size=0.05)
    assert (run["c.mode"] == 1).all()
    assert abs(run["c.gap"]).max() <= 2e-12
    assert run["c.force"][1:] == pytest.approx(9.81, rel=1e-6)
    assert not run["c.impacts"].any()
    assert run["energy.error"].max() < 1e-12


@pytest.mark.parametrize("kind", ["plane", "plane in space", "sphere"])
@pytest.mark.parametrize(("x", "y"), [(0.0, 0.0), (1e4 + 0.1, 0.3), (0.1, 1e4 + 0.7)])
def test_round_off_is_that_of_the_coordinates(kind, x, y):
    """At the origin nothing but the error itself has a size; far from it round-off is larger."""
    error = -2e-12 * max(x, y, 0.5)
    for mode in ("located", "stepped"):
        scene = drawn(kind, repr(error / 2), mode, x, y)
        run = solver.simulate(scene, stop_time=0.05, step_size=0.05)
        assert run["c.mode"][0] == 1


@pytest.mark.parametrize("kind", SCENES)
def test_penetration_is_refused(kind):
    with pytest.raises(SceneError, match=r"drawn in penetration|must be <= 0|overlap"):
        solver.assemble(drawn(kind, "-1e-7", "located"))
