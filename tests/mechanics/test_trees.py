"""Bodies of trees in space are eliminated with the joints that carry them, and move as by LU."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import solver
from scenes.generate import rigid_chain
from solver.mechanics import kkt_pattern
from solver.runtime import Integrator, Model
from solver.runtime.layout import LEAST_WITH_JOINT
from tests.support.fmus.fmu_instance import SCENES
from tests.support.mechanisms.problems import (
    Content,
    assemble,
    mechanism,
    observe,
    start,
    step,
    view,
)
from tests.support.mechanisms.scene_files import tomllib

KINDS = {"spherical": 0, "universal": 1, "revolute": 2, "fixed": 3}
"""Joints that let two places meet, and the pairs of directions that each keeps."""


def joint_pivots(model: Model) -> list[int]:
    """Pivots of each group of a body with its joint, in the order of elimination."""
    sizes = [after - first for first, after in pairwise(model.tables["lu_group"][::3])]
    return [size for size in sizes if size >= LEAST_WITH_JOINT]


@st.composite
def trees(draw: st.DrawFn) -> tuple[Content, list[int]]:
    """Up to five bodies on joints, with springs between any, and the pivots of each with its joint.

    The first body is free or on the ground. A joint lies anywhere, or at the centre of mass of the
    body that it carries, of the other one, or of both.
    """
    count, random = draw(st.integers(2, 5)), np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    grounded, kinds = draw(st.booleans()), []
    bodies, joints, places = {}, {}, random.uniform(-1.0, 1.0, (count, 3))
    for body in range(count):
        bodies[f"B{body}"] = {
            "position": places[body].tolist(), "mass": random.uniform(0.5, 2.0),
            "inertia": random.uniform(0.1, 0.15, 3).tolist(),
        }  # fmt: skip
        if body == 0 and not grounded:
            bodies["B0"] |= {"angular_velocity": random.uniform(-1.0, 1.0, 3).tolist()}
            continue
        kinds.append(draw(st.sampled_from([*KINDS])))
        parent = draw(st.integers(0, body - 1)) if body else None
        other = "ground" if parent is None else f"B{parent}"
        pair = [other, f"B{body}"] if draw(st.booleans()) else [f"B{body}", other]
        at = draw(st.sampled_from(["anywhere", "own centre", "other centre", "both"]))
        if parent is not None and at == "both":
            places[body] = places[parent]
            bodies[f"B{body}"]["position"] = places[body].tolist()
        centre = {"own centre": body, "other centre": parent, "both": body}.get(at)
        place = random.uniform(-1, 1, 3) if centre is None else places[centre]
        joint = {"type": kinds[-1], "bodies": pair, "position": place.tolist()}
        axis, second = np.linalg.qr(random.normal(size=(3, 2)))[0].T
        if kinds[-1] == "revolute":
            joint["axis"] = axis.tolist()
        elif kinds[-1] == "universal":
            joint["axes"] = [axis.tolist(), second.tolist()]
        joints[f"j{body}"] = joint
    ends = st.lists(st.integers(0, count - 1), min_size=2, max_size=2, unique=True)
    points = {"P": {"position": [0.1, 3.0, 0.2], "mass": 1.0}} if draw(st.booleans()) else {}
    if points:  # an odd number of later places
        other = f"B{draw(st.integers(0, count - 1))}"
        tie = {"tie": {"type": "spring", "points": ["P", other], "stiffness": 20.0}}
    forces = ({} if not points else tie) | {
        f"s{k}": {"type": "spring", "points": [f"B{a}", f"B{b}"], "stiffness": 20.0}
        for k, (a, b) in enumerate(draw(st.lists(ends, max_size=2)))
    }
    content = mechanism("tree", 3, points=points, bodies=bodies, joints=joints, forces=forces)
    return content, sorted(9 + KINDS[kind] for kind in kinds)


@given(trees())
def test_a_tree_moves_as_by_the_sparse_factors(drawn):
    # Without joints in groups all rows go through the LU, which knows nothing of trees.
    content, pivots = drawn
    settings = {"step_size": 2e-3, "assemble": True, "newton_tolerance": 1e-14}
    model = assemble(content, **settings)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kkt_pattern, "carried_bodies", lambda _: ())
        sparse = assemble(content, **settings)
    assert sorted(joint_pivots(model)) == pivots
    assert joint_pivots(sparse) == []
    runs = [Integrator(each) for each in (model, sparse)]
    for run in runs:
        run.initialise()
        for _ in range(20):
            step(run, 2e-3)
    first, second = runs
    assert np.abs(view(first, "q") - view(second, "q")).max() <= 1e-11
    size = 1.0 + np.abs(view(second, "v")).max()
    assert np.abs(view(first, "v") - view(second, "v")).max() <= 1e-10 * size
    errors = [first.model.index(name) for name in ("energy.error", "constraint.position")]
    assert np.abs(first.get(errors)).max() <= 1e-13


def test_trees_keep_rows_and_energy_at_the_least_penalty():
    # Trees leave the compliance out of their factors: at 1e2, which is refused, they would not
    # converge.
    run = start(tomllib.loads(rigid_chain(4)), h=2e-3, penalty=1e6)
    errors = observe(run, 2e-3, 20, ["energy.error", "constraint.position"])
    assert np.abs(errors).max() <= 1e-14


@pytest.mark.parametrize("name", ["bricard", "double_wishbone", "flyball_governor", "stewart"])
def test_islands_with_loops_or_other_rows_have_no_trees(name):
    assert joint_pivots(solver.assemble(solver.load(SCENES / f"{name}.toml"))) == []


HINGE = {"type": "revolute", "bodies": ["A", "B"], "position": [1, 0, 0], "axis": [0, 1, 0]}
BALL = {"type": "spherical", "bodies": ["A", "B"], "position": [1, 0, 0]}
ANGLE = {"type": "angle", "bodies": ["A", "B"], "axes": [[0, 1, 0], [1, 0, 0]]}


@pytest.mark.parametrize("joints", [[HINGE, ANGLE], [BALL, ANGLE, ANGLE]], ids=["hinge", "ball"])
def test_rows_that_repeat_those_of_a_joint_leave_its_island_to_the_sparse_factors(joints):
    # Their matrix without compliance is singular.
    body = {"mass": 1, "inertia": [0.1, 0.2, 0.25]}
    bodies = {"A": body | {"position": [0, 0, 0]}, "B": body | {"position": [2, 0, 0]}}
    named = {f"j{k}": joint for k, joint in enumerate(joints)}
    content = mechanism("repeated", 3, bodies=bodies, joints=named)
    assert joint_pivots(assemble(content)) == []
    errors = observe(start(content), 0.01, 20, ["energy.error", "constraint.position"])
    assert np.abs(errors).max() <= 1e-14


def test_a_heavy_top_is_eliminated_with_its_tip():
    assert joint_pivots(solver.assemble(solver.load(SCENES / "heavy_top.toml"))) == [9]


def test_a_driver_leaves_its_island_to_the_sparse_factors_and_others_as_they_are():
    swing = {
        "type": "revolute",
        "bodies": ["ground", "A"],
        "position": [0, 0, 0],
        "axis": [0, 1, 0],
    }
    body = {"position": [1, 0, 0], "mass": 1, "inertia": [0.1, 0.1, 0.1]}
    other = body | {"position": [1, 5, 0]}
    joints = {"a": swing, "b": swing | {"bodies": ["ground", "B"], "position": [0, 5, 0]}}
    content = mechanism("two", 3, bodies={"A": body, "B": other}, joints=joints)
    assert joint_pivots(assemble(content)) == [11, 11]
    driven = content | {"drivers": {"motor": {"type": "angle", "joint": "a", "value": "t"}}}
    assert joint_pivots(assemble(driven)) == [11]
