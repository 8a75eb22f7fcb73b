"""The measured mechanisms, as contents of scenes, and integrators of them.

Chains: N points of 0.1 kg on massless rods of 0.1 m, straight along x, the first rod pinned at the
origin, moving across with v_y,i = 0.5 sin(2 pi i/N) m/s, without gravity.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import pairwise
from typing import Any

import solver
from solver.runtime import Integrator
from tests.support.mechanisms.problems import (
    GRAVITY,
    Content,
    four_bar,
    free_system,
    mechanism,
    rods,
    scene,
)
from tests.support.mechanisms.problems import chain as hanging_chain
from tests.support.mechanisms.problems import travelling_wave as waving_chain

__all__ = [
    "GRAVITY", "Content", "chains_beside", "four_bar", "free_system", "hanging_chain", "scene",
    "start", "start_scene", "waving_chain",
]  # fmt: skip


def chains_beside(count: int, n: int, angles: Iterable[float]) -> Content:
    """Chains of `n` rods of 0.1 m side by side, each at its angle from the vertical, at rest."""
    points: Content = {}
    pairs: list[tuple[str, str]] = []
    for chain, angle in zip(range(count), angles, strict=True):
        x, y = 0.1 * math.sin(angle), -0.1 * math.cos(angle)
        names = [f"P{chain}_{i}" for i in range(n + 1)]
        for i, name in enumerate(names):
            at = {"position": [3.0 * chain + i * x, i * y]}
            points[name] = at | ({"mass": 0.1} if i else {"fixed": True})
        pairs += pairwise(names)
    return mechanism(f"beside{count}", 2, points=points, joints=rods(pairs, length=0.1))


def start(content: Content, **settings: Any) -> Integrator:
    """Integrator of a content with settings of the solver, ready for the first step."""
    return start_scene(scene(content, **settings))


def start_scene(drawn: solver.Scene) -> Integrator:
    """Integrator of a scene, ready for the first step; always with the compiled kernel."""
    integrator = Integrator(solver.assemble(drawn))
    integrator.initialise()
    return integrator
