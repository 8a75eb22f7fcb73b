"""Random mechanisms of rigid bodies: masses over four decades, any joints, loops, springs.

Bodies are drawn at random and joined where they lie, most to a tree, some to loops, whose rows may
be redundant or may lock the mechanism; `assemble` finds the velocities.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np

Content = dict[str, Any]
Random = np.random.Generator

JOINTS = {
    2: ("revolute", "revolute", "revolute", "prismatic", "point_on_line", "distance"),
    3: (
        "spherical", "revolute", "revolute", "universal", "cylindrical", "prismatic", "planar",
        "screw", "distance", "point_on_line", "point_on_plane", "fixed",
    ),
}  # fmt: skip


def mechanism(seed: int) -> str:
    """Scene, as JSON, of a number."""
    random = np.random.default_rng(seed)
    dimension, n = int(random.integers(2, 4)), int(random.integers(2, 7))
    places = np.sqrt(n) * random.uniform(-1, 1, size=(n, dimension))
    bodies = {f"B{i}": _body(random, place) for i, place in enumerate(places)}
    spin = random.normal(size=3)
    bodies["B0"]["angular_velocity"] = spin.tolist() if dimension == 3 else float(spin[0])
    joints: Content = {}
    for i in range(n):
        before = f"B{random.integers(i)}" if i else "ground"
        if i or random.random() < 0.7:
            place = places[i] + 0.3 * random.normal(size=dimension)
            joints[f"j{i}"] = _joint(random, before, f"B{i}", place, tree=True)
    for k in range(int(random.integers(0, 3))):
        a, b = (f"B{i}" for i in random.choice(n, size=2, replace=False))
        joints[f"loop{k}"] = _joint(random, a, b, random.normal(size=dimension), tree=False)
    forces = {f"s{k}": _force(random, n) for k in range(int(random.integers(0, 4)))}
    content = {
        "name": "random",
        "dimension": dimension,
        "gravity": (3.0 * random.normal(size=dimension)).tolist(),
        "bodies": bodies,
        "joints": joints,
        "forces": forces,
        "solver": {"assemble": True, "step_size": 0.01},
    }
    return json.dumps(content)


def _body(random: Random, place: np.ndarray) -> Content:
    """Rigid body of 0.01 to 100 kg and some 0.3 m, with a named point."""
    dimension, mass = len(place), 10.0 ** random.uniform(-2, 2)
    found: Content = {
        "position": place.tolist(),
        "mass": mass,
        "points": {"tip": random.uniform(-0.4, 0.4, size=dimension).tolist()},
    }
    if dimension == 2:
        inertia = mass * random.uniform(0.03, 0.2)
        return found | {"inertia": inertia, "orientation": random.uniform(-3, 3)}
    moments = mass * random.uniform(0.01, 0.1, size=3)
    return found | {
        "inertia": (moments.sum() - moments).tolist(),
        "orientation": {"rotation_vector": random.uniform(-1, 1, size=3).tolist()},
    }


def _joint(random: Random, first: str, second: str, place: np.ndarray, *, tree: bool) -> Content:
    """A joint that is met as drawn; loops are closed by what leaves some freedom."""
    dimension = len(place)
    kind = str(random.choice(JOINTS[dimension]))
    if first == "ground" or not tree:
        kind = "revolute" if dimension == 2 else "spherical"
    if not tree and random.random() < 0.6:
        kind = "distance"
    if kind == "distance":
        return {"type": kind, "points": [f"{first}.tip", f"{second}.tip"]}
    axes, _ = np.linalg.qr(random.normal(size=(dimension, dimension)))
    axis = axes[:, 0].tolist()
    if kind.startswith("point"):
        return {"type": kind, "point": f"{second}.tip", "body": first, "axis": axis}
    found: Content = {"type": kind, "bodies": [first, second], "position": place.tolist()}
    if kind == "universal":
        return found | {"axes": axes[:, :2].T.tolist()}
    if kind == "screw":
        found["pitch"] = random.uniform(0.1, 0.5)
    if kind not in ("spherical", "fixed") and (dimension == 3 or kind == "prismatic"):
        found["axis"] = axis
    return found


def _force(random: Random, n: int) -> Content:
    """Spring of 0.1 to 1e4 N/m, or a damper, between two bodies."""
    a, b = random.choice(n, size=2, replace=False)
    ends = {"points": [f"B{a}.tip", f"B{b}"]}
    if random.random() < 0.3:
        return ends | {"type": "damper", "damping": random.uniform(0, 2)}
    stiffness = 10.0 ** random.uniform(-1, 4)
    return ends | {
        "type": "spring", "stiffness": stiffness, "free_length": random.uniform(0.3, 1.0),
    }  # fmt: skip
