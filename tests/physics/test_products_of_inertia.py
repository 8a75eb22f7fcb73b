"""The products of inertia of a body have the sign of the inertia tensor, J_xy = -sum m x y."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import solver

GUIDE = (Path(__file__).parents[2] / "docs" / "scene.md").read_text(encoding="utf-8")
MASSES = np.array([1.0, 2.0, 0.5, 1.5])
SPIN = np.array([1.0, -2.0, 3.0])
"""rad/s"""


def places() -> np.ndarray:
    """Of four masses about their centre, without a symmetry [m]."""
    given = np.array([[0.5, 0.4, 0.1], [-0.3, -0.2, 0.3], [0.1, -0.6, -0.2], [0.2, 0.1, -0.5]])
    return given - MASSES @ given / MASSES.sum()


def tensor(masses: np.ndarray, r: np.ndarray) -> np.ndarray:
    """Sum of m (r.r 1 - r r') [kg m2]."""
    return sum(m * (x @ x * np.eye(3) - np.outer(x, x)) for m, x in zip(masses, r, strict=True))


def path_of_first_mass(parts: dict[str, object]) -> np.ndarray:
    scene = solver.loads(json.dumps({"name": "masses", **parts}), format="json")
    run = solver.simulate(scene, stop_time=2.0, step_size=0.1, tolerance=1e-8)
    name = "b.first" if "bodies" in parts else "P0"
    return np.array([run[f"{name}.{axis}"] for axis in "xyz"]).T


def body(inertia: np.ndarray) -> dict[str, object]:
    return {
        "bodies": {
            "b": {
                "position": [0, 0, 0], "mass": MASSES.sum(), "inertia": inertia.tolist(),
                "angular_velocity": SPIN.tolist(), "points": {"first": places()[0].tolist()},
            }
        }
    }  # fmt: skip


def test_masses_on_rods_move_as_the_body_of_their_tensor():
    """The sign decides: with the other one the body moves elsewhere."""
    r = places()
    points = {
        f"P{i}": {
            "position": x.tolist(), "mass": float(m), "velocity": np.cross(SPIN, x).tolist(),
        }
        for i, (m, x) in enumerate(zip(MASSES, r, strict=True))
    }  # fmt: skip
    pairs = [(i, k) for i in range(4) for k in range(i)]
    rods = {f"r{i}{k}": {"type": "distance", "points": [f"P{i}", f"P{k}"]} for i, k in pairs}
    masses = path_of_first_mass({"points": points, "joints": rods})
    J = tensor(MASSES, r)
    assert path_of_first_mass(body(J)) == pytest.approx(masses, abs=1e-5)
    other = path_of_first_mass(body(2.0 * np.diag(np.diag(J)) - J))
    assert abs(other - masses).max() > 0.1


def test_the_guide_shows_the_tensor_of_two_masses():
    words = r"Two masses of 1 kg at \(0.3, 0.4, 0\) and \(-0.3, -0.4, 0\) m have `inertia = (.*?)`"
    found = re.search(words, GUIDE)
    assert found
    r = np.array([[0.3, 0.4, 0.0], [-0.3, -0.4, 0.0]])
    assert np.array(json.loads(found[1])) == pytest.approx(tensor(np.ones(2), r), abs=1e-15)
