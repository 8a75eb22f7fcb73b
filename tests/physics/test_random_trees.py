"""Random mechanisms of rigid bodies, bars, points, joints and springs keep what physics keeps.

Every mechanism is drawn at random and closed by `assemble`, which finds the velocities of all parts
but those that are given; steps are those in which the fastest body turns by some 0.05 to 0.2 rad.
"""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import solver
from tests.support.mechanisms.problems import Content
from tests.support.mechanisms.work_sums import vector

Random = np.random.Generator

JOINTS = {
    2: ["revolute", "revolute", "prismatic", "point_on_line", "distance"],
    3: [
        *("spherical", "revolute", "universal", "cylindrical", "prismatic", "planar", "screw"),
        *("distance", "point_on_line", "point_on_plane"),
    ],
}
TURNING = {"revolute", "cylindrical", "screw"}
"""Joints with an angle."""


def direction(random: Random, dimension: int) -> list[float]:
    """Unit vector."""
    found = random.normal(size=dimension)
    return (found / np.linalg.norm(found)).tolist()


def joint(random: Random, dimension: int, first: str, second: str, place: list[float]) -> Content:
    """A joint of two bodies that is met as they are drawn."""
    kind = str(random.choice(JOINTS[dimension]))
    if kind == "distance":
        return {"type": kind, "points": [f"{first}.tip", f"{second}.tip"]}
    if kind.startswith("point"):
        axis = direction(random, dimension)
        return {"type": kind, "point": f"{second}.tip", "body": first, "axis": axis}
    found = {"type": kind, "bodies": [first, second], "position": place}
    if kind == "universal":
        axes, _ = np.linalg.qr(random.normal(size=(3, 2)))
        return found | {"axes": axes.T.tolist()}
    if kind == "screw":
        found["pitch"] = random.uniform(0.1, 0.5)
    if kind != "spherical" and (dimension == 3 or kind == "prismatic"):
        found["axis"] = direction(random, dimension)
    return found


def body(random: Random, dimension: int, place: list[float]) -> Content:
    """A rigid body at rest with a named point."""
    found: Content = {
        "position": place,
        "mass": random.uniform(0.5, 2.0),
        "points": {"tip": random.uniform(-0.4, 0.4, size=dimension).tolist()},
    }
    if dimension == 2:
        return found | {"inertia": random.uniform(0.05, 0.2), "orientation": random.uniform(-3, 3)}
    second_moments = random.uniform(0.02, 0.1, size=3)
    return found | {
        "inertia": (second_moments.sum() - second_moments).tolist(),
        "orientation": {"rotation_vector": random.uniform(-1, 1, size=3).tolist()},
    }


def tree(random: Random, dimension: int, n: int) -> Content:
    """Bodies joined to a tree in free flight, a bar and a point at its end, springs across it."""
    places = random.uniform(-1, 1, size=(n, dimension)) * n**0.5
    bodies = {f"B{i}": body(random, dimension, place.tolist()) for i, place in enumerate(places)}
    joints, forces = {}, {}
    for i in range(1, n):
        parent = int(random.integers(i))
        place = (places[i] + 0.3 * random.normal(size=dimension)).tolist()
        joints[f"j{i}"] = joint(random, dimension, f"B{parent}", f"B{i}", place)
    spin = random.normal(size=dimension if dimension == 3 else 1)
    bodies["B0"]["velocity"] = random.normal(size=dimension).tolist()
    bodies["B0"]["angular_velocity"] = spin.tolist() if dimension == 3 else float(spin[0])
    points = {
        "E": {"position": places[-1].tolist()},
        "P": {"position": random.uniform(-2, 2, size=dimension).tolist(), "mass": 0.7},
        "Q": {"position": random.uniform(2, 3, size=dimension).tolist(), "mass": 0.4},
    }
    bodies["bar"] = {"type": "bar", "points": ["E", "P"], "mass": 0.6}
    shared = "revolute" if dimension == 2 else "spherical"
    joints["pin"] = {"type": shared, "points": [f"B{n - 1}", "E"]}
    joints["rod"] = {"type": "distance", "points": ["P", "Q"]}
    for i, ends in enumerate((["B0.tip", "Q"], ["P", "B0"])):
        length = random.uniform(0.3, 1.0)
        law = {"stiffness": random.uniform(0.5, 4.0), "free_length": length}
        forces[f"spring{i}"] = {"type": "spring", "points": ends} | law
    for name in [name for name in joints if joints[name]["type"] in TURNING and name != "pin"][:1]:
        forces["twist"] = {"type": "torsion_spring", "joint": name, "stiffness": 0.8}
    return {
        "name": "random", "dimension": dimension,
        "points": points, "bodies": bodies, "joints": joints, "forces": forces,
        "solver": {"assemble": True, "step_size": 0.02},
    }  # fmt: skip


def hung(random: Random, content: Content) -> Content:
    """The tree hung on its first body under gravity, with loops, damper, load and torque."""
    dimension, n = content["dimension"], sum(name[0] == "B" for name in content["bodies"])
    content["gravity"] = (3 * random.normal(size=dimension)).tolist()
    root = content["bodies"]["B0"]
    root.pop("velocity")
    root.pop("angular_velocity")
    place = root["position"]
    hinge = {"type": "revolute", "bodies": ["ground", "B0"], "position": place}
    content["joints"]["root"] = hinge | ({"axis": direction(random, 3)} if dimension == 3 else {})
    ends = sorted(f"B{i}" for i in random.choice(n, size=2, replace=False))
    content["joints"]["cross"] = joint(
        random, dimension, *ends, random.normal(size=dimension).tolist()
    )
    loop = {"type": "distance", "points": ["ground", "Q"], "at": [0.0] * dimension}
    content["joints"]["loop"] = loop
    content["forces"] |= {
        "damper": {"type": "damper", "points": ["B0.tip", "P"], "damping": random.uniform(0, 1)},
        "load": {"type": "force", "point": "Q", "value": ["2*sin(3*t)", *[0.3] * (dimension - 1)]},
        "motor": {"type": "joint_torque", "joint": "root", "value": "0.5*cos(t) - 0.2*root.angle"},
    }
    return content


@st.composite
def free_trees(draw: st.DrawFn) -> Content:
    """A tree of two to four bodies, a bar and a point in free flight."""
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    return tree(random, draw(st.sampled_from([2, 3])), draw(st.integers(2, 4)))


@st.composite
def hung_loops(draw: st.DrawFn) -> Content:
    """The same hung on the ground, with two loops, whose rows may be dependent."""
    return hung_loop(draw(st.integers(0, 2**32 - 1)), draw(st.sampled_from([2, 3])))


def hung_loop(seed: int, dimension: int) -> Content:
    """One of them."""
    random = np.random.default_rng(seed)
    return hung(random, tree(random, dimension, int(random.integers(2, 5))))


def scene(content: Content) -> solver.Scene:
    """Scene of a content."""
    return solver.loads(json.dumps(content), name="random.json", format="json")


def moved(content: Content, steps: int = 200) -> solver.Trajectory:
    """Run of pairs of half steps of 0.02 s, each recorded."""
    return solver.simulate(scene(content), stop_time=0.02 * steps, step_size=0.02)


@settings(max_examples=30)
@given(free_trees())
def test_a_free_tree_keeps_energy_momenta_and_its_joints(content):
    run = moved(content)
    axes, turning = ("xyz", "xyz") if content["dimension"] == 3 else ("xy", "z")
    assert run["energy.error"].max() < 1e-11
    assert run["constraint.position"].max() < 1e-12
    assert not run["energy.work"].any()
    kept = np.hstack([vector(run, "momentum.", axes), vector(run, "angular_momentum.", turning)])
    assert np.ptp(kept, axis=0).max() < 1e-11 * (1.0 + np.abs(kept).max())


@settings(max_examples=30)
@given(hung_loops())
def test_a_hung_loop_books_every_joule_and_keeps_its_joints(content):
    run = moved(content)
    assert run["energy.error"].max() < 1e-11
    assert run["constraint.position"].max() < 1e-12
    assert (np.diff(run["energy.dissipated"]) >= 0.0).all()
    assert np.ptp(run["energy.work"]) > 0.0


# -------------------------------------------------------------------------- velocities at the start


def struck(drawn: str, velocity: list[float]) -> float:
    """Velocity against a constraint that `assemble` leaves in a point given one."""
    text = f"""
name = "struck"
[points]
O = {{ position = [0, 0, 0], fixed = true }}
P = {{ position = [0.3, 0.1, -0.4], velocity = {velocity}, mass = 2.0 }}
{drawn}
[solver]
assemble = true
"""
    with pytest.warns(RuntimeWarning, match="the velocity that is given for point 'P': it starts"):
        run = solver.simulate(solver.loads(text), stop_time=0.01, step_size=0.01)
    return float(run["constraint.velocity"][0])


@pytest.mark.parametrize(
    "drawn",
    [
        '[joints]\nrod = { type = "distance", points = ["O", "P"] }',
        '[joints]\nplane = { type = "point_on_plane", point = "P", axis = [3, 1, -4] }',
        '[drivers]\nrod = { type = "distance", points = ["O", "P"], value = "sqrt(0.26) + t**2" }',
    ],
)
def test_assembly_takes_the_contradicting_part_from_a_velocity_that_is_given(drawn):
    # Without `assemble` the scene is refused, and the message recommends it.
    assert struck(drawn, [0.0, 0.5, 0.0]) < 1e-12
