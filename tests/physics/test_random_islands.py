"""Random mechanisms side by side in one scene move as each of them alone, by every method."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.runtime import Integrator
from tests.support.mechanisms.island_scenes import assembled, beside, started
from tests.support.mechanisms.problems import Content
from tests.support.mechanisms.random_mechanisms import driven_systems, free_systems

STEPS, H = 6, 0.005
GRAVITY = [0.5, -9.81, 1.0]
METHODS: list[dict[str, Any]] = [
    {},
    {"penalty": 1e6},
]


def motion(run: Integrator, content: Content, behind: str = "") -> np.ndarray:
    """Positions and velocities of the moving points [m, m/s], after some steps."""
    axes = "xyz"[: content["dimension"]]
    moving = [name for name, point in content["points"].items() if not point.get("fixed")]
    return np.array(
        [[run[f"{p}{behind}.{kind}{axis}"] for axis in axes for kind in ("", "v")] for p in moving]
    )


def assert_all_move_as_alone(contents: list[Content], **method: Any) -> None:
    together = started(assembled(beside(*contents), step_size=H, **method))
    assert together.model.sizes["n_islands"] >= len(contents)
    each = [started(assembled(content, step_size=H, **method)) for content in contents]
    for run in (together, *each):
        for _ in range(STEPS):
            run.advance(run.time, H)
    for number, (run, content) in enumerate(zip(each, contents, strict=True)):
        # Rounding differs with the size of the whole, on which floors of the iterations rest.
        alone, with_others = motion(run, content), motion(together, content, f"_{number}")
        assert with_others == pytest.approx(alone, rel=1e-9, abs=1e-9)


def scenes(kind: st.SearchStrategy, dimension: int) -> st.SearchStrategy[list[Content]]:
    fitting = kind.filter(lambda content: content["dimension"] == dimension)
    alike = fitting.map(lambda content: content | {"gravity": GRAVITY[:dimension]})
    return st.lists(alike, min_size=2, max_size=3)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("method", METHODS, ids=str)
@settings(deadline=None, max_examples=6)
@given(data=st.data())
def test_damped_and_loaded_mechanisms_move_side_by_side_as_alone(method, dimension, data):
    assert_all_move_as_alone(data.draw(scenes(driven_systems(), dimension)), **method)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("order", [4, 6, 8])
@settings(deadline=None, max_examples=4)
@given(data=st.data())
def test_free_mechanisms_move_side_by_side_as_alone_at_any_order(order, dimension, data):
    free = free_systems().map(lambda drawn: drawn[0])
    assert_all_move_as_alone(data.draw(scenes(free, dimension)), order=order)
