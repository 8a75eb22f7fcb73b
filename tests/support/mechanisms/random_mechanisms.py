"""Random mechanisms, for what must hold of all of them: trees of rods, bars and springs, loops."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st

from tests.support.mechanisms.problems import Array, Content, mechanism


def consistent_velocities(content: Content, velocities: Array) -> None:
    """Project velocities onto those that rods and bars allow; write them into the content."""
    points = content["points"]
    node = {name: place for place, name in enumerate(points)}
    q = np.array([point["position"] for point in points.values()])
    links = [part["points"] for table in ("joints", "bodies") for part in content[table].values()]
    fixed = [[name] for name, point in points.items() if point.get("fixed")]
    G = np.zeros((len(links) + len(fixed) * q.shape[1], *q.shape))
    for row, (first, second) in enumerate(links):
        a, b = node[first], node[second]
        G[row, b] = (q[b] - q[a]) / np.linalg.norm(q[b] - q[a])
        G[row, a] = -G[row, b]
    for i, (name,) in enumerate(fixed):
        for k in range(q.shape[1]):
            G[len(links) + i * q.shape[1] + k, node[name], k] = 1.0
    G = G.reshape(len(G), -1)
    allowed = velocities.ravel() - np.linalg.pinv(G) @ (G @ velocities.ravel())
    for (_, point), velocity in zip(points.items(), allowed.reshape(q.shape), strict=True):
        if not point.get("fixed"):
            point["velocity"] = velocity.tolist()


def fastest_link(content: Content) -> float:
    """Largest angular velocity of a rod or bar [rad/s]."""
    points, rates = content["points"], [0.0]
    still = [0.0] * content["dimension"]
    for part in (*content["joints"].values(), *content["bodies"].values()):
        a, b = (points[name] for name in part["points"])
        link = np.subtract(b["position"], a["position"])
        relative = np.subtract(b.get("velocity", still), a.get("velocity", still))
        rates.append(float(np.linalg.norm(relative) / np.linalg.norm(link)))
    return max(rates)


def _tree(random: np.random.Generator, dimension: int, n: int) -> Content:
    """Points joined to a tree by rods and bars of 0.5 to 2 m, with springs across it."""
    places, links = np.zeros((n, dimension)), []
    for i in range(1, n):
        parent = int(random.integers(i))
        link = random.normal(size=dimension)
        places[i] = places[parent] + link / np.linalg.norm(link) * random.uniform(0.5, 2.0)
        links.append((random.random() < 0.4, [f"P{parent}", f"P{i}"]))
    points: dict[str, Any] = {
        f"P{i}": {"position": place.tolist(), "mass": random.uniform(0.1, 3.0)}
        for i, place in enumerate(places)
    }
    joints = {
        f"rod{i}": {"type": "distance", "points": ends}
        for i, (is_bar, ends) in enumerate(links)
        if not is_bar
    }
    bodies = {
        f"bar{i}": {"type": "bar", "points": ends, "mass": random.uniform(0.1, 3.0)}
        for i, (is_bar, ends) in enumerate(links)
        if is_bar
    }
    forces: dict[str, Any] = {}
    for i in range(int(random.integers(3)) if n > 2 else 0):
        a, b = (int(node) for node in random.choice(n, size=2, replace=False))
        drawn = float(np.linalg.norm(places[a] - places[b]))
        forces[f"spring{i}"] = {
            "type": "spring",
            "points": [f"P{a}", f"P{b}"],
            "stiffness": random.uniform(0.0, 2.0),
            "free_length": drawn * random.uniform(0.0, 1.2),
        }
    return mechanism(
        "random", dimension, gravity=False,
        points=points, joints=joints, bodies=bodies, forces=forces,
    )  # fmt: skip


@st.composite
def free_systems(draw: st.DrawFn) -> tuple[Content, float]:
    """A free tree of rods, bars and springs, and a step in which it turns by 0.1 to 0.5 rad."""
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    content = _tree(random, draw(st.sampled_from([2, 3])), draw(st.integers(2, 7)))
    consistent_velocities(
        content, random.normal(size=(len(content["points"]), content["dimension"]))
    )
    return content, draw(st.floats(0.1, 0.5)) / max(fastest_link(content), 1.0)


@st.composite
def driven_systems(draw: st.DrawFn) -> Content:
    """A tree hung on its first point, with a loop, a damper, a load and a torque, under gravity."""
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    dimension, n = draw(st.sampled_from([2, 3])), draw(st.integers(3, 7))
    content = _tree(random, dimension, n)
    content["gravity"] = random.normal(size=dimension).tolist()
    content["points"]["P0"] = {"position": [0.0] * dimension, "fixed": True}
    if draw(st.booleans()):
        content["joints"]["loop"] = {"type": "distance", "points": ["P0", f"P{n - 1}"]}
    ends = {"points": ["P1", f"P{n - 1}"]}
    content["forces"]["damper"] = {"type": "damper", "damping": random.uniform(0, 2)} | ends
    load = [f"{random.normal()!r}*sin(3*t)" for _ in range(dimension)]
    content["forces"]["load"] = {"type": "force", "point": "P1", "value": load}
    for bar in content["bodies"]:
        value = random.normal() if dimension == 2 else random.normal(size=3).tolist()
        content["forces"][f"torque_{bar}"] = {"type": "torque", "body": bar, "value": value}
    consistent_velocities(content, random.normal(size=(n, dimension)))
    return content
