"""Contacts that stay open take no part in a step: neither in its factors nor in its motion."""

from __future__ import annotations

import numpy as np
import pytest

from tests.support.mechanisms.problems import Content, assemble, chain, start, tree

DIMENSIONS = pytest.mark.parametrize("dimension", [2, 3], ids=["plane", "space"])
FRICTION = pytest.mark.parametrize("friction", [0.0, 0.3], ids=["frictionless", "friction"])


def beside_a_wall(content: Content, count: int, friction: float) -> Content:
    """The mechanism beside a wall through its support, which none of its last points touches."""
    names = [name for name, point in content["points"].items() if not point.get("fixed")][-count:]
    support = next(iter(content["points"].values()))["position"]
    last = content["points"][names[-1]]["position"]
    axis = [float(k == max(range(len(last)), key=lambda i: abs(last[i]))) for k in range(len(last))]
    away = 1.0 if sum(a * x for a, x in zip(axis, last, strict=True)) > 0.0 else -1.0
    fields = {"type": "plane", "axis": [away * x for x in axis], "position": support}
    fields |= {"friction": friction} if friction else {}
    return content | {"contacts": {f"wall_{n}": fields | {"point": n} for n in names}}


def moved(content: Content, steps: int) -> np.ndarray:
    """Coordinates after some steps."""
    integrator = start(content, h=0.01)
    integrator.advance(0.0, 0.01 * steps)
    return np.array(integrator.state.vectors["q"])


@DIMENSIONS
@FRICTION
@pytest.mark.parametrize("count", [1, 9], ids=["one", "many"])
@pytest.mark.parametrize("build", [chain, tree])
def test_a_mechanism_moves_alike_with_open_contacts(build, count, friction, dimension):
    # Round-off of the first multipliers, 1e-16 of 10 m, grows no faster than linearly.
    content = build(10, dimension=dimension)
    alone, above = moved(content, 20), moved(beside_a_wall(content, count, friction), 20)
    assert above == pytest.approx(alone, abs=1e-13)


@DIMENSIONS
def test_factors_of_open_contacts_are_those_of_the_scene_without_contacts(dimension):
    content = chain(10, dimension=dimension)
    alone, above = assemble(content), assemble(beside_a_wall(content, 3, 0.3))
    for kind, same in (("open", ""), ("bare", "lean_")):
        for table in ("node_position", "lu_column", "lu_target", "lu_island"):
            assert above.tables[f"{kind}_{table}"] == alone.tables[same + table]
