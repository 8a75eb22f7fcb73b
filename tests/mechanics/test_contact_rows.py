"""Gaps and slip rates against the motion of the materials that touch, at random configurations.

Bodies are placed and moved at random, without regard to what joins them. What is compared is
written from the geometry: the distance of surfaces, and velocities of material points v + w x r.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import solver
from solver.mechanics.build_mechanism import build_mechanism
from solver.mechanics.combination import Combination
from solver.mechanics.contacts import distance_left
from solver.mechanics.frames import RigidFrame
from solver.mechanics.mechanism import Formula, FunctionRow, Mechanism
from solver.mechanics.parts import Parts
from solver.runtime.layout import LEAF_RATE, QUANTITY_ANGLE, QUANTITY_FORM
from solver.scene import evaluate
from tests.support.mechanisms.reduced_models import Array, rotation

SEEDS = st.integers(0, 2**32 - 1)
FEW = settings(max_examples=25)
"""Poses at random: what holds at some holds at all."""
RADIUS, CLEARANCE, PIN = 0.3, 0.2, 0.7


@dataclass
class Pose:
    """Where a body is and how it moves: rotation from the drawing, origin, v of it, w."""

    R: Array
    x: Array
    v: Array
    w: Array

    def spun(self, arm: Array) -> Array:
        """Return w x arm, in the plane w J arm."""
        if len(arm) == 3:
            return np.cross(self.w, arm)
        return self.w[0] * np.array([-arm[1], arm[0]])

    def velocity(self, place: Array) -> Array:
        """Velocity of the material at a place."""
        return self.v + self.spun(place - self.x)


def posed(random: np.random.Generator, dim: int) -> Pose:
    turn = random.normal(size=2 * dim - 3)
    R = rotation(turn) if dim == 3 else np.array(
        [[np.cos(turn[0]), -np.sin(turn[0])], [np.sin(turn[0]), np.cos(turn[0])]]
    )  # fmt: skip
    return Pose(R, *random.normal(size=(2, dim)), random.normal(size=2 * dim - 3))


class Moved:
    """A scene's mechanism with its bodies `a` and `b` at some poses; they are drawn unturned."""

    def __init__(self, content: dict[str, Any], poses: dict[str, Pose]) -> None:
        text = json.dumps({"name": "x"} | content)
        self.parts: Parts = build_mechanism(solver.loads(text, format="json"))
        self.mechanism: Mechanism = self.parts.mechanism
        nodes = self.mechanism.nodes
        self.x = [np.array(node.position, float) for node in nodes]
        self.v = [np.zeros(self.mechanism.dim) for _ in nodes]
        for name, pose in poses.items():
            frame = self.parts.frames[name]
            assert isinstance(frame, RigidFrame)
            self.x[frame.centre], self.v[frame.centre] = pose.x, pose.v
            for k, director in enumerate(frame.directors):
                self.x[director] = pose.R[:, k]
                self.v[director] = pose.spun(pose.R[:, k])

    def _sum(self, u: Combination, of: list[Array]) -> Array:
        total = np.zeros(self.mechanism.dim)
        for n, straight, turn in u.terms:
            total = total + float(straight) * of[n]
            if turn != 0.0:
                total = total + float(turn) * np.array([-of[n][1], of[n][0]])
        return total

    def _form(self, form: int) -> tuple[float, float]:
        u, w = self.mechanism.forms[form]
        value = self._sum(u, self.x) @ self._sum(w, self.x)
        rate = self._sum(u, self.v) @ self._sum(w, self.x)
        return value, rate + self._sum(u, self.x) @ self._sum(w, self.v)

    def quantity(self, index: int) -> tuple[float, float]:
        """Value and rate of a quantity."""
        kind, forms = self.mechanism.quantities[index]
        values, rates = zip(*map(self._form, forms), strict=True)
        if kind == QUANTITY_FORM:
            return values[0], rates[0]
        if kind == QUANTITY_ANGLE:
            (c, s), (dc, ds) = values, rates
            return float(np.arctan2(s, c)), (c * ds - s * dc) / (c * c + s * s)
        length = float(np.sqrt(values[0]))
        return length, 0.5 * rates[0] / length

    def value(self, formula: Formula, **known: float) -> float:
        """Value of a formula; of a function row its value, of a velocity row the rate."""
        leaves = {
            f"#{k}": self.quantity(leaf.index)[leaf.kind == LEAF_RATE]
            for k, leaf in enumerate(formula.leaves)
        }
        return float(evaluate(formula.value, {**self.mechanism.defaults, **leaves, **known}))

    def gap_rate(self, row: FunctionRow) -> float:
        """Rate of a gap, by its slope: a gap is plus or minus one quantity, and a number."""
        (leaf,) = row.formula.leaves
        value, rate = self.quantity(leaf.index)
        ends = [float(evaluate(row.formula.value, {"#0": value + d})) for d in (-0.5, 0.5)]
        return (ends[1] - ends[0]) * rate

    @property
    def gap(self) -> FunctionRow:
        (row,) = self.mechanism.function_rows
        return row

    @property
    def slips(self) -> list[Formula]:
        return [row.formula for row in self.mechanism.velocity_rows]


def bodies(dim: int, **points: dict[str, list[float]]) -> dict[str, Any]:
    """Two bodies that are drawn far apart."""
    inertia = [1.0, 1.0, 1.0] if dim == 3 else 1.0
    far = {"a": [0.0] * dim, "b": [9.0] + [0.0] * (dim - 1)}
    return {
        name: {"position": place, "mass": 1.0, "inertia": inertia, "points": points.get(name, {})}
        for name, place in far.items()
    }


def on_a_plane(random: np.random.Generator, dim: int, *, carried: bool) -> tuple[Any, ...]:
    """A ball about a point of body `a` at a plane of the ground or of body `b`."""
    tip = random.normal(size=dim).tolist()
    axis = random.normal(size=dim)
    axis[0] = -2.0 - abs(axis[0])  # towards body a, which is drawn to the left of b
    place = [8.0] + [0.0] * (dim - 1)
    contact = {
        "type": "plane", "point": "a.tip", "axis": axis.tolist(), "position": place,
        "radius": RADIUS, "friction": 0.1,
    }  # fmt: skip
    content = {
        "dimension": dim,
        "bodies": bodies(dim, a={"tip": tip}),
        "contacts": {"c": contact | ({"body": "b"} if carried else {})},
    }
    poses = {"a": posed(random, dim), "b": posed(random, dim)}
    still = Pose(np.eye(dim), np.zeros(dim), np.zeros(dim), np.zeros(2 * dim - 3))
    base, drawn = (poses["b"], [9.0] + [0.0] * (dim - 1)) if carried else (still, [0.0] * dim)
    n = base.R @ axis / np.linalg.norm(axis)
    p = base.x + base.R @ (np.array(place) - np.array(drawn))
    return content, poses, base, n, p, np.array(tip)


def between(
    random: np.random.Generator, kind: str, *, touching: bool, dim: int = 2
) -> tuple[Any, ...]:  # fmt: skip
    """Circles or balls of bodies a and b; the second is moved to where they touch."""
    tips = random.normal(size=(2, dim))
    contact: dict[str, Any] = {"type": kind, "points": ["a.tip", "b.tip"], "friction": 0.1}
    if kind == "sphere":
        contact |= {"radii": [RADIUS, PIN]}
        reach = RADIUS + PIN
    else:
        contact |= {"radius": CLEARANCE, "pin_radius": PIN}
        reach = CLEARANCE
    drawn = bodies(dim, a={"tip": tips[0].tolist()}, b={"tip": tips[1].tolist()})
    apart = 2.0 * np.eye(dim)[0] if kind == "sphere" else np.zeros(dim)
    drawn["b"]["position"] = (tips[0] - tips[1] + apart).tolist()
    poses = {name: posed(random, dim) for name in "ab"}
    places = [poses[name].x + poses[name].R @ tip for name, tip in zip("ab", tips, strict=True)]
    n = random.normal(size=dim)
    n /= np.linalg.norm(n)
    if touching:
        poses["b"].x = poses["b"].x + places[0] + reach * n - places[1]
        places[1] = places[0] + reach * n
    content = {"dimension": dim, "bodies": drawn, "contacts": {"c": contact}}
    return content, poses, places, n


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("carried", [False, True])
@FEW
@given(seed=SEEDS)
def test_the_gap_to_a_plane_is_the_distance_of_the_surfaces_and_its_rate_theirs(dim, carried, seed):
    content, poses, base, n, p, tip = on_a_plane(
        np.random.default_rng(seed), dim, carried=carried
    )  # fmt: skip
    moved = Moved(content, poses)
    a = poses["a"]
    centre = a.x + a.R @ tip
    assert moved.value(moved.gap.formula) == pytest.approx((centre - p) @ n - RADIUS, abs=1e-9)
    touch = centre - RADIUS * n
    rate = (a.velocity(touch) - base.velocity(touch)) @ n
    assert moved.gap_rate(moved.gap) == pytest.approx(rate, abs=1e-9)


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("carried", [False, True])
@FEW
@given(seed=SEEDS)
def test_slip_on_a_plane_is_the_tangential_velocity_of_the_materials(dim, carried, seed):
    content, poses, base, n, _, tip = on_a_plane(
        np.random.default_rng(seed), dim, carried=carried
    )  # fmt: skip
    moved = Moved(content, poses)
    a = poses["a"]
    touch = a.x + a.R @ tip - RADIUS * n
    slip = a.velocity(touch) - base.velocity(touch)
    found = [moved.value(formula) for formula in moved.slips]
    if dim == 2:
        assert found == pytest.approx([slip @ [n[1], -n[0]]], abs=1e-9)
    else:  # along two tangents at right angles: their size does not depend on which
        along = slip - (slip @ n) * n
        assert np.hypot(*found) == pytest.approx(np.linalg.norm(along), abs=1e-9)
        a.v += 0.1 * n  # nothing of the normal velocity is in it
        assert [Moved(content, poses).value(x) for x in moved.slips] == pytest.approx(found)


@FEW
@given(seed=SEEDS)
def test_both_tangents_of_a_plane_are_at_right_angles_to_each_other(seed):
    """Without rotation, slip rates are linear in v: their gradients are the tangents."""
    random = np.random.default_rng(seed)
    content, poses, _, n, _, _ = on_a_plane(random, 3, carried=False)
    tangents = []
    poses["a"].w[:] = 0.0
    for axis in np.eye(3):
        poses["a"].v = axis
        moved = Moved(content, poses)
        tangents.append([moved.value(x) for x in moved.slips])
    T = np.array(tangents)
    assert np.abs(T.T @ T - np.eye(2)).max() < 1e-12
    assert np.abs(n @ T).max() < 1e-12


@FEW
@given(seed=SEEDS, speed=st.floats(-3.0, 3.0))
def test_the_velocity_of_a_surface_is_subtracted_along_its_plane(seed, speed):
    random = np.random.default_rng(seed)
    content, poses, _, n, _, _ = on_a_plane(random, 2, carried=False)
    still = Moved(content, poses)
    content["inputs"] = {"belt": {}}
    content["contacts"]["c"]["surface_velocity"] = ["belt", "2*belt"]
    moving = Moved(content, poses)
    difference = moving.value(moving.slips[0], belt=speed) - still.value(still.slips[0])
    assert difference == pytest.approx(-speed * (n[1] - 2.0 * n[0]), abs=1e-9)


@pytest.mark.parametrize("kind", ["sphere", "clearance"])
@FEW
@given(seed=SEEDS)
def test_the_gap_of_circles_is_the_distance_of_their_surfaces(kind, seed):
    content, poses, places, _ = between(np.random.default_rng(seed), kind, touching=False)
    moved = Moved(content, poses)
    u = places[1] - places[0]
    apart = float(np.linalg.norm(u))
    gap, rate = moved.value(moved.gap.formula), moved.gap_rate(moved.gap)
    v = [poses[name].velocity(place) for name, place in zip("ab", places, strict=True)]
    growing = (v[1] - v[0]) @ u / apart
    if kind == "sphere":
        assert gap == pytest.approx(apart - RADIUS - PIN, abs=1e-9)
        assert rate == pytest.approx(growing, abs=1e-9)
    else:  # a polynomial, with the right slope where they touch
        assert distance_left(gap, CLEARANCE) == pytest.approx(CLEARANCE - apart, abs=1e-9)
        assert rate == pytest.approx(-growing * apart / CLEARANCE, abs=1e-7)


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("kind", ["sphere", "clearance"])
@FEW
@given(seed=SEEDS)
def test_slip_of_circles_and_balls_is_that_of_the_materials_where_they_touch(dim, kind, seed):
    """Of a clearance the first point is the pin: it touches the hole beyond its own centre."""
    content, poses, places, n = between(np.random.default_rng(seed), kind, touching=True, dim=dim)
    moved = Moved(content, poses)
    a, b = poses["a"], poses["b"]
    if kind == "sphere":
        touch, first, second = places[0] + RADIUS * n, a, b
    else:
        n = -n  # from the hole, the second point, to the pin
        touch, first, second = places[0] + PIN * n, b, a
    slip = second.velocity(touch) - first.velocity(touch)
    found = [moved.value(formula) for formula in moved.slips]
    if dim == 2:
        assert found == pytest.approx([slip @ [-n[1], n[0]]], abs=1e-8)
    else:  # along two tangents at right angles, which are steep only near one direction
        along = slip - (slip @ n) * n
        assert np.hypot(*found) == pytest.approx(np.linalg.norm(along), abs=1e-7)


def in_a_bearing(random: np.random.Generator, length: float = 0.4) -> tuple[Any, ...]:
    """A journal of body b in a bearing of body a, whose second end touches the hole."""
    axis = random.normal(size=3)
    axis /= np.linalg.norm(axis)
    drawn = bodies(3)
    drawn["b"]["position"] = [0.3, 0.1, -0.2]
    contact = {
        "type": "journal", "bodies": ["a", "b"], "position": [0.1, 0.2, 0.3],
        "axis": axis.tolist(), "length": length, "radius": CLEARANCE, "pin_radius": PIN,
        "friction": 0.1,
    }  # fmt: skip
    poses = {name: posed(random, 3) for name in "ab"}
    a, b = poses["a"], poses["b"]
    middle = np.array(contact["position"])
    end = middle + 0.5 * length * axis - drawn["b"]["position"]
    n = np.cross(axis, random.normal(size=3))
    n = a.R @ (n / np.linalg.norm(n))
    along = a.R @ axis
    b.x = a.x + a.R @ middle + CLEARANCE * n + random.normal() * along - b.R @ end
    content = {"dimension": 3, "bodies": drawn, "contacts": {"c": contact}}
    return content, poses, b.x + b.R @ end + PIN * n, n, along


@given(seed=SEEDS)
def test_slip_of_a_journal_is_that_of_the_materials_around_and_along_its_bearing(seed):
    content, poses, touch, n, along = in_a_bearing(np.random.default_rng(seed))
    moved = Moved(content, poses)
    slip = poses["b"].velocity(touch) - poses["a"].velocity(touch)
    found = [moved.value(formula) for formula in moved.slips[2:]]
    assert found == pytest.approx([slip @ np.cross(along, n), slip @ along], abs=1e-8)
    gap = moved.value(moved.mechanism.function_rows[1].formula)
    assert gap == pytest.approx(0.0, abs=1e-12)


@given(seed=SEEDS)
def test_forces_and_moments_of_a_journal_add_up_to_nothing(seed):
    random = np.random.default_rng(seed)
    content, poses, *_ = in_a_bearing(random)
    velocity, w = random.normal(size=(2, 3))
    for pose in poses.values():
        pose.w, pose.v = w, velocity + np.cross(w, pose.x)
    moved = Moved(content, poses)
    assert [moved.value(x) for x in moved.slips] == pytest.approx([0.0] * 4, abs=1e-8)


STOP = {
    "type": "stop",
    "points": ["a.tip", "b.tip"],
    "max": 30.0,
}


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("kind", ["plane", "sphere", "clearance", "stop"])
@FEW
@given(seed=SEEDS)
def test_forces_and_moments_of_a_contact_add_up_to_nothing(kind, dim, seed):
    """Rows whose rate vanishes when both bodies move as one push and turn them oppositely."""
    random = np.random.default_rng(seed)
    if kind == "plane":
        content, poses, *_ = on_a_plane(random, dim, carried=True)
    else:
        circles = "sphere" if kind == "stop" else kind
        content, poses, *_ = between(random, circles, touching=True, dim=dim)
        if kind == "stop":
            content["contacts"] = {"c": STOP}
    velocity, w = random.normal(size=dim), random.normal(size=2 * dim - 3)
    for pose in poses.values():
        pose.w = w
        pose.v = velocity + pose.spun(pose.x)
    moved = Moved(content, poses)
    assert moved.gap_rate(moved.gap) == pytest.approx(0.0, abs=1e-9)
    assert [moved.value(x) for x in moved.slips] == pytest.approx(
        [0.0] * len(moved.slips), abs=1e-9
    )


@FEW
@given(seed=SEEDS)
def test_a_stop_with_two_ends_has_a_gap_to_either(seed):
    random = np.random.default_rng(seed)
    hinge = {"type": "revolute", "bodies": ["a", "b"], "position": [0, 0]}
    content = {
        "dimension": 2,
        "bodies": bodies(2),
        "joints": {"hinge": hinge},
        "contacts": {"limit": {"type": "stop", "joint": "hinge", "min": -0.4, "max": 1.5}},
    }
    poses = {"a": posed(random, 2), "b": posed(random, 2)}
    moved = Moved(content, poses)
    angle = moved.quantity(moved.parts.joints["hinge"].angle)  # pyright: ignore[reportArgumentType]
    rows = [moved.mechanism.function_rows[x.row] for x in moved.mechanism.contacts]
    values = [moved.value(row.formula) for row in rows]
    assert values == pytest.approx([angle[0] + 0.4, 1.5 - angle[0]], abs=1e-12)
    relative = poses["b"].w[0] - poses["a"].w[0]
    assert [moved.gap_rate(row) for row in rows] == pytest.approx([relative, -relative], abs=1e-9)


def rubbing(dim: int, kind: str, first: str = "a", **fields: Any) -> dict[str, Any]:
    """Bodies a (or the ground) and b in a joint with friction."""
    joint = {"type": kind, "bodies": [first, "b"], "position": [1.0] * dim} | fields
    return {"dimension": dim, "bodies": bodies(dim), "joints": {"j": joint}}


@pytest.mark.parametrize("first", ["a", "ground"])
@FEW
@given(seed=SEEDS)
def test_slip_in_a_spherical_joint_is_the_angular_velocity_in_axes_of_the_first_body(first, seed):
    random = np.random.default_rng(seed)
    content = rubbing(3, "spherical", first, friction={"coefficient": 0.1, "radius": 0.02})
    poses = {"a": posed(random, 3), "b": posed(random, 3)}
    moved = Moved(content, poses)
    still = Pose(np.eye(3), np.zeros(3), np.zeros(3), np.zeros(3))
    base = poses["a"] if first == "a" else still
    wanted = base.R.T @ (poses["b"].w - base.w)
    assert [moved.value(x) for x in moved.slips] == pytest.approx(list(wanted), abs=1e-9)
    (friction,) = moved.mechanism.frictions
    assert (friction.sliding, friction.static) == pytest.approx((0.002, 0.002))
    assert friction.normal == ((("coincidence", 0),),)


@FEW
@given(seed=SEEDS)
def test_slip_in_a_cylindrical_joint_is_that_on_the_surface_of_the_journal(seed):
    random = np.random.default_rng(seed)
    friction = {"coefficient": 0.1, "static": 0.2, "radius": 0.5, "preload": 3.0}
    content = rubbing(3, "cylindrical", axis=[0, 0, 2], friction=friction)
    poses = {"a": posed(random, 3), "b": posed(random, 3)}
    moved = Moved(content, poses)
    joint = moved.parts.joints["j"]
    rates = [moved.quantity(q)[1] for q in (joint.angle, joint.displacement)]  # pyright: ignore
    wanted = [0.5 * rates[0], rates[1]]
    assert [moved.value(x) for x in moved.slips] == pytest.approx(wanted, abs=1e-9)
    (found,) = moved.mechanism.frictions
    assert (found.sliding, found.static, found.preload) == (0.1, 0.2, 3.0)
    ((first, second),) = found.normal
    rows = [moved.mechanism.form_rows[k] for _, k in (first, second)]
    assert [row.row.kind for row in rows] == ["off", "off"]  # across the axis


@pytest.mark.parametrize(("kind", "word"), [("revolute", "angle"), ("prismatic", "displacement")])
@FEW
@given(seed=SEEDS)
def test_slip_in_a_planar_joint_is_its_rate(kind, word, seed):
    random = np.random.default_rng(seed)
    arm = {"radius": 0.02} if kind == "revolute" else {}
    axis = {"axis": [1, 2]} if kind == "prismatic" else {}
    content = rubbing(2, kind, friction={"coefficient": 0.5, **arm}, **axis)
    moved = Moved(content, {"a": posed(random, 2), "b": posed(random, 2)})
    rate = moved.quantity(getattr(moved.parts.joints["j"], word))[1]
    assert [moved.value(x) for x in moved.slips] == pytest.approx([rate], abs=1e-9)
    (found,) = moved.mechanism.frictions
    assert found.sliding == pytest.approx(0.5 * arm.get("radius", 1.0))
    (((row_kind, row),),) = found.normal
    if kind == "revolute":
        assert (row_kind, row) == ("coincidence", 0)
    else:
        assert (row_kind, moved.mechanism.form_rows[row].row.kind) == ("form", "off")
