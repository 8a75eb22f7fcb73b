"""The measured mechanisms, as contents of scenes, and integrators of them.

Chains: N points of 0.1 kg on massless rods of 0.1 m, straight along x, the first rod pinned at the
origin, moving across with v_y,i = 0.5 sin(2 pi i/N) m/s, without gravity.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from itertools import pairwise
from typing import Any

import solver
from solver.runtime import Integrator

Content = dict[str, Any]

GRAVITY = 9.81


def _content(name: str, dimension: int, gravity: float, **tables: Any) -> Content:
    down = [0.0] * (dimension - 1) + [-gravity]
    experiment = {"stop_time": 10.0, "step_size": 10.0}
    content = {"name": name, "dimension": dimension, "gravity": down, "experiment": experiment}
    return content | tables


def _rods(pairs: Iterable[tuple[str, str]], length: float) -> Content:
    return {
        f"rod{i}": {"type": "distance", "points": list(pair), "length": length}
        for i, pair in enumerate(pairs, start=1)
    }


def _line(n: int) -> list[tuple[str, str]]:
    return [(f"P{i - 1}", f"P{i}") for i in range(1, n + 1)]


def hanging_chain(n: int, angle: float = math.pi / 2) -> Content:
    """N unit rods with unit masses, all at `angle` from the vertical, at rest, under gravity.

    Two of them are the double pendulum; the default angle is the horizontal.
    """
    x, y = math.sin(angle), -math.cos(angle)
    if angle == math.pi / 2:
        y = 0.0
    points: Content = {"P0": {"position": [0.0, 0.0], "fixed": True}}
    for i in range(1, n + 1):
        points[f"P{i}"] = {"position": [i * x, i * y], "mass": 1.0}
    return _content(f"chain{n}", 2, GRAVITY, points=points, joints=_rods(_line(n), 1.0))


def waving_chain(n: int, dimension: int) -> Content:
    """N points of 0.1 kg on rods of 0.1 m, straight, with a wave of velocity across."""
    rest = [0.0] * (dimension - 2)
    points: Content = {"P0": {"position": [0.0, 0.0, *rest], "fixed": True}}
    for i in range(1, n + 1):
        across = 0.5 * math.sin(2 * math.pi * i / n)
        points[f"P{i}"] = {
            "position": [0.1 * i, 0.0, *rest],
            "velocity": [0.0, across, *rest],
            "mass": 0.1,
        }
    return _content(f"wave{n}", dimension, 0.0, points=points, joints=_rods(_line(n), 0.1))


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
    return _content(f"beside{count}", 2, GRAVITY, points=points, joints=_rods(pairs, 0.1))


def four_bar(loops: int = 2) -> Content:
    """Uniform unit bars, `loops` of them in a row on loops + 1 cranks (IFToMM benchmark A02)."""
    points: Content = {}
    for i in range(loops + 1):
        points[f"A{i}"] = {"position": [float(i), 0.0], "fixed": True}
        points[f"B{i}"] = {"position": [float(i), 1.0], "velocity": [1.0, 0.0]}
    bars = {f"crank{i}": (f"A{i}", f"B{i}") for i in range(loops + 1)}
    bars |= {f"coupler{i}": (f"B{i}", f"B{i + 1}") for i in range(loops)}
    bodies = {name: {"type": "bar", "points": list(e), "mass": 1.0} for name, e in bars.items()}
    return _content("four_bar", 2, GRAVITY, points=points, bodies=bodies)


def free_body() -> Content:
    """Five points, a bar, rods and springs that tumble in space, without gravity or support."""
    places = [(0.0, 0.0, 0.0), (1.0, 0.1, 0.2), (0.3, 0.9, -0.1), (1.4, 1.1, 0.5), (-0.7, 0.6, 0.8)]
    points: Content = {}
    for i, (x, y, z) in enumerate(places):
        # velocity = (0.3, -0.4, 1.0) x position + (0.05, -0.02, 0.03)
        velocity = [-0.4 * z - y + 0.05, x - 0.3 * z - 0.02, 0.3 * y + 0.4 * x + 0.03]
        points[f"P{i}"] = {"position": [x, y, z], "velocity": velocity, "mass": 0.5 + 0.3 * i}
    pairs = [("P0", "P2"), ("P1", "P2"), ("P2", "P4")]
    joints = {f"rod{i}": {"type": "distance", "points": list(p)} for i, p in enumerate(pairs)}
    springs = {
        "left": _spring("P1", "P3", 6.0, 0.9),
        "right": _spring("P4", "P0", 3.0, 1.3),
        "long": _spring("P4", "P3", 0.5, 0.0),
    }
    bodies = {"bar": {"type": "bar", "points": ["P0", "P1"], "mass": 1.2}}
    return _content("free", 3, 0.0, points=points, bodies=bodies, joints=joints, forces=springs)


def _spring(a: str, b: str, stiffness: float, free_length: float) -> Content:
    law = {"stiffness": stiffness, "free_length": free_length}
    return {"type": "spring", "points": [a, b]} | law


def scene(content: Content, **settings: Any) -> solver.Scene:
    """Scene of a content with settings of the solver."""
    text = json.dumps(content | {"solver": settings})
    return solver.loads(text, name=f"{content['name']}.json", format="json")


def start(content: Content, **settings: Any) -> Integrator:
    """Integrator of a content with settings of the solver, ready for the first step."""
    return start_scene(scene(content, **settings))


def start_scene(drawn: solver.Scene) -> Integrator:
    """Integrator of a scene, ready for the first step; always with the compiled kernel."""
    integrator = Integrator(solver.assemble(drawn))
    integrator.initialise()
    return integrator
