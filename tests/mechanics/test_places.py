"""Places on bodies: those on a named point are that point; what lies beside one is told.

Two descriptions of one mechanism, a joint by its position and one by named points, must mean the
same when the pose of a body is replaced or depends on a parameter.
"""

import json
import math
import warnings

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from solver import AssemblyError, Integrator, SceneError, SceneWarning, assemble, loads

TIP = (0.8, 0.3)
"""Named point of the arm in its own axes, beside `foot`, its origin being between."""
FOOT = (-0.6, 0.1)
unit = st.floats(-1.0, 1.0)
angles = st.floats(-3.0, 3.0)


def turned(angle, vector):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])


def arm_on_a_pin(at, *, space=False, kind="revolute", more=None, **fields):
    """Return the scene of an arm that is joined to the ground at a place, as JSON."""
    zero = [0] if space else []
    arm = {
        "position": [0, 0, *zero],
        "mass": 2.0,
        "inertia": [0.1, 0.2, 0.3] if space else 0.3,
        "points": {"tip": [*TIP, *zero], "foot": [*FOOT, *zero]},
    }
    pin = {"type": kind, "bodies": ["ground", "arm"], "position": [*at, *zero]}
    if space and kind == "revolute":
        pin["axis"] = [0, 0, 1]
    scene = {
        "name": "arm",
        "dimension": 3 if space else 2,
        "gravity": [0, -9.81, *zero],
        "bodies": {"arm": arm | fields},
        "joints": {"pin": pin},
    }
    return json.dumps(scene | (more or {}))


def read(text, **overrides):
    """Scene and the sentences of its warnings."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", SceneWarning)
        scene = loads(text, format="json", overrides=overrides)
    assert scene.sentences() == tuple(str(each.message) for each in caught)
    return scene, scene.sentences()


def gap_of(error):
    """Distance that a report of a joint drawn apart gives."""
    (problem,) = error.problems
    assert problem.location == "joints.pin"
    assert "'arm.tip' are drawn" in problem.message
    return float(problem.message.split("drawn ")[1].split(" m apart")[0])


@pytest.mark.parametrize("space", [False, True])
@given(x=unit, y=unit, angle=angles)
def test_a_joint_on_a_named_point_goes_with_it_when_the_pose_is_replaced(space, x, y, angle):
    """The distance that is reported is that by which the pose moves the point."""
    shift = turned(angle, TIP) + np.array((x, y)) - TIP
    zero = [0.0] if space else []
    orientation = {"axis": [0, 0, 1], "angle": angle} if space else angle
    overrides = {"bodies.arm.position": [x, y, *zero], "bodies.arm.orientation": orientation}
    text = arm_on_a_pin(TIP, space=space)
    assert read(text)[1] == ()
    if np.hypot(*shift) < 1e-6:
        return
    scene, _ = read(text, **overrides)
    with pytest.raises(SceneError) as caught:
        assemble(scene)
    assert gap_of(caught.value) == pytest.approx(np.hypot(*shift), rel=1e-5)


@pytest.mark.parametrize("kind", ["spherical", "fixed", "universal"])
def test_so_do_all_joints_at_which_two_places_meet(kind):
    more = {"solver": {"step_size": 0.01}}
    text = arm_on_a_pin(TIP, space=True, kind=kind, more=more)
    if kind == "universal":
        scene = json.loads(text)
        scene["joints"]["pin"]["axes"] = [[1, 0, 0], [0, 1, 0]]
        text = json.dumps(scene)
    scene, _ = read(text, **{"bodies.arm.position": [0.25, 0, 0]})
    with pytest.raises(SceneError, match=r"'arm\.tip' are drawn 0\.25 m apart"):
        assemble(scene)


@given(angle=angles)
def test_position_and_points_mean_the_same_when_the_pose_is_replaced(angle):
    given_by_points = json.loads(arm_on_a_pin(TIP))
    pin = {"type": "revolute", "points": ["ground", "arm.tip"], "at": [*TIP]}
    given_by_points["joints"]["pin"] = pin
    found = []
    for text in (arm_on_a_pin(TIP), json.dumps(given_by_points)):
        scene, _ = read(text, **{"bodies.arm.orientation": angle})
        try:
            assemble(scene)
        except SceneError as error:
            found.append(error.problems[0].message)
        else:
            found.append("")
    assert found[0] == found[1]


def test_assemble_closes_a_joint_whose_body_was_turned_away():
    scene, _ = read(arm_on_a_pin(TIP), **{"bodies.arm.orientation": 0.9, "solver.assemble": True})
    said: list[str] = []
    moved = Integrator(assemble(scene), log=said.append)
    moved.initialise()
    assert "closing the mechanism moved arm by" in said[0]
    assert [moved["arm.tip.x"], moved["arm.tip.y"]] == pytest.approx(TIP, abs=1e-9)


def test_a_pose_by_a_parameter_is_reported_when_the_fmu_is_initialised():
    """The places are decided with the default parameters; what a run sets is checked against it."""
    more = {"parameters": {"lift": 0.0}}
    model = assemble(read(arm_on_a_pin(TIP, orientation="lift", more=more))[0])
    integrator = Integrator(model)
    integrator["lift"] = 0.9
    shift = np.hypot(*(turned(0.9, TIP) - TIP))
    with pytest.raises(AssemblyError, match=rf"'arm\.tip' are drawn {shift:.6g} m apart"):
        integrator.initialise()
    closing = Integrator(model, log=lambda _: None)  # that the arm moves far
    closing["lift"], closing["solver.assemble"] = 0.9, True
    closing.initialise()
    assert [closing["arm.tip.x"], closing["arm.tip.y"]] == pytest.approx(TIP, abs=1e-9)


def test_a_joint_that_a_formula_keeps_on_its_point_fits_with_every_parameter():
    more = {"parameters": {"lift": 0.3}}
    at = [f"{TIP[0]}*cos(lift) - {TIP[1]}*sin(lift)", f"{TIP[0]}*sin(lift) + {TIP[1]}*cos(lift)"]
    integrator = Integrator(assemble(read(arm_on_a_pin(at, orientation="lift", more=more))[0]))
    integrator["lift"] = -1.2
    integrator.initialise()
    assert abs(integrator["constraint.position"]) < 1e-14


def test_a_place_with_a_parameter_of_its_own_goes_its_own_way():
    """That it lies on a point with the default parameters is then no more than a coincidence."""
    more = {"parameters": {"reach": TIP[0]}}
    scene, _ = read(arm_on_a_pin(["reach", TIP[1]], more=more))
    assert scene.joints["pin"].on == (None, None)
    integrator = Integrator(assemble(scene))
    integrator["reach"] = 0.5
    integrator.initialise()


@given(share=st.floats(0.01, 0.1), direction=angles)
def test_a_place_close_to_a_named_point_is_told(share, direction):
    """Close is a tenth of the distance to the next named point or the origin."""
    neighbour = math.hypot(*TIP)  # the origin; the foot is farther
    at = np.array(TIP) + 0.999 * share * neighbour * turned(direction, (1, 0))
    _, (sentence,) = read(arm_on_a_pin(at.tolist()))
    assert "warning: joints.pin.position: lies " in sentence
    assert f" {np.hypot(*(at - TIP)):.3g} m beside the point 'arm.tip'" in sentence
    assert "write [0.8, 0.3], where the point is, or name a point of 'arm'" in sentence


@given(distance=st.floats(0.101, 0.4), direction=angles)
def test_a_place_farther_away_is_not(distance, direction):
    neighbour = math.hypot(*TIP)
    at = np.array(TIP) + distance * neighbour * turned(direction, (1, 0))
    assert read(arm_on_a_pin(at.tolist()))[1] == ()


def test_a_point_named_at_the_place_says_that_it_is_meant():
    points = {"tip": TIP, "foot": FOOT, "beside": [0.8, 0.32]}
    assert read(arm_on_a_pin((0.8, 0.32), points=points))[1] == ()


@given(x=unit, angle=angles)
@example(x=0.0, angle=2e-10)
@example(x=0.0, angle=2.5e-8)
def test_a_place_that_only_fitted_the_old_pose_is_told(x, angle):
    """The distance is that between the place before and after, in the axes of the body.

    Round-off is 1e-9 of its coordinates, which are 0.4 to 1.5 m: nearby the drawing leaves it open.
    """
    at = np.array([0.1, 0.4])  # no named point is near
    moved = turned(-angle, at - (x, 0.0)) - at
    assume(not 1e-10 < np.hypot(*moved) < 1e-8)
    overrides = {"bodies.arm.position": [x, 0.0], "bodies.arm.orientation": angle}
    scene, sentences = read(arm_on_a_pin(at.tolist()), **overrides)
    assemble(scene)
    told = [text for text in sentences if "stays where it is drawn" in text]
    assert bool(told) == (np.hypot(*moved) > 1e-9)
    if told:
        assert f"{np.hypot(*moved):.3g} m elsewhere on 'arm', which bodies.arm." in told[0]


@pytest.mark.parametrize("at", [TIP, (0.1, 0.4)])
def test_a_place_that_is_replaced_as_well_is_right(at):
    new = (turned(0.9, at)).tolist()
    overrides = {"bodies.arm.orientation": 0.9, "joints.pin.position": new}
    scene, sentences = read(arm_on_a_pin(at), **overrides)
    assert sentences == ()
    assert scene.joints["pin"].on == (None, "arm.tip" if at == TIP else None)
    assemble(scene)


def test_a_pose_that_leaves_the_joint_in_its_place_is_right():
    overrides = {"bodies.arm.position": (TIP - turned(0.9, TIP)).tolist()}
    scene, sentences = read(arm_on_a_pin(TIP), **overrides, **{"bodies.arm.orientation": 0.9})
    assert sentences == ()
    assemble(scene)


def test_a_body_that_is_replaced_as_a_whole_is_moved_as_well():
    arm = json.loads(arm_on_a_pin(TIP))["bodies"]["arm"]
    overrides = {"bodies.arm": arm | {"position": [0.25, 0]}}
    _, (sentence,) = read(arm_on_a_pin((0.1, 0.4)), **overrides)
    assert "lies 0.25 m elsewhere on 'arm', which bodies.arm=a table has moved" in sentence


def test_places_of_springs_on_bodies_are_treated_alike():
    spring = {"type": "spring", "points": ["ground", "arm"], "stiffness": 50.0}
    for at, override, told in [
        (TIP, {}, ""),
        ((0.8, 0.31), {}, "forces.spring.at[1]: lies 0.01 m beside the point 'arm.tip'"),
        (TIP, {"bodies.arm.position": [0.5, 0.0]}, ""),  # it goes with the point
        ((0.1, 0.4), {"bodies.arm.position": [0.5, 0.0]}, "forces.spring.at[1]: stays where"),
    ]:
        more = {"forces": {"spring": spring | {"at": [[0, 2], list(at)]}}, "joints": {}}
        scene, sentences = read(arm_on_a_pin(FOOT, more=more), **override)
        assert len(sentences) == bool(told)
        assert told in "".join(sentences)
        assert scene.forces["spring"].points[1].point == ("arm.tip" if at == TIP else "arm")


def test_ends_of_bars_are_named_points():
    points = {"O": {"position": [0, 0], "fixed": True}, "A": {"position": [1, 0]}}
    bodies = {"rod": {"type": "bar", "points": ["O", "A"], "mass": 1.0}}
    arm = {"position": [1, 1], "mass": 1.0, "inertia": 0.1}
    pin = {"type": "revolute", "bodies": ["rod", "arm"], "position": [1, 0]}
    scene = {"name": "x", "dimension": 2, "points": points, "bodies": bodies | {"arm": arm}}
    text = json.dumps(scene | {"joints": {"pin": pin}})
    assert read(text)[0].joints["pin"].on == ("A", None)
    moved, _ = read(text, **{"points.A.position": [1.25, 0]})
    with pytest.raises(SceneError, match=r"on 'A' and 'arm' are drawn 0\.25 m apart"):
        assemble(moved)
    _, (sentence,) = read(text, **{"joints.pin.position": [0.95, 0]})
    assert "lies 0.05 m beside the point 'A'" in sentence


def test_two_points_at_one_place_leave_open_which_is_meant():
    points = {"tip": TIP, "end": TIP}
    assert read(arm_on_a_pin(TIP, points=points))[0].joints["pin"].on == (None, None)
