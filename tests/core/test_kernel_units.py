"""No unit is built into the kernel: in units that are powers of two every bit stays what it is."""

from __future__ import annotations

import json

import numpy as np
import pytest

import solver
from tests.support.kernel.twins import advance, start, vector


def mechanism(dim, length, mass, time):
    """All laws at once, in units of `length` m, `mass` kg and `time` s; numbers are the same."""
    speed, force = length / time, mass * length / time**2

    def place(*x):
        return [length * value for value in x[:dim]]

    def velocity(*x):
        return [speed * value for value in x[:dim]]

    moment = force * length * 0.75
    points = {
        "O": {"position": place(0, 0, 0), "fixed": True},
        "A": {"position": place(1, 0, 0), "velocity": velocity(0, 1, 0.5), "mass": 0.5 * mass},
        "B": {"position": place(1, 1.25, 0), "velocity": velocity(0.5, 1, 0)},
        "C": {"position": place(0, 2, 0.5), "velocity": velocity(-0.5, 0.25, 0), "mass": mass},
    }
    forces = {
        "spring": {
            "type": "spring",
            "points": ["B", "C"],
            "stiffness": 90.0 * mass / time**2,
            "free_length": 0.75 * length,
        },
        "damper": {"type": "damper", "points": ["A", "C"], "damping": 3.0 * mass / time},
        "pusher": {"type": "force", "point": "C", "value": [0.5 * force] * dim},
        "motor": {
            "type": "torque",
            "body": "bar",
            "value": moment if dim == 2 else [moment, -moment, 2 * moment],
        },
    }
    content = {
        "name": "units",
        "dimension": dim,
        "gravity": [0.25 * length / time**2] * (dim - 1) + [-10.0 * length / time**2],
        "points": points,
        "bodies": {"bar": {"type": "bar", "points": ["A", "B"], "mass": 1.5 * mass}},
        "joints": {"rod": {"type": "distance", "points": ["O", "A"]}},
        "forces": forces,
        "solver": {"step_size": 0.0625 * time},
    }
    return solver.assemble(solver.loads(json.dumps(content), format="json"))


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize(
    "units", [(2.0**-20, 2.0**-40, 2.0**-10), (2.0**20, 2.0**30, 2.0**14)], ids=["small", "large"]
)
def test_units_of_powers_of_two_change_no_bit(units, dim):
    """From micrometres and picograms to thousands of kilometres; scaling by 4^k rounds nothing."""
    length, mass, time = units
    ours, theirs = start(mechanism(dim, 1.0, 1.0, 1.0)), start(mechanism(dim, *units))
    for run in (ours, theirs):
        advance(run, 20)
    assert np.array_equal(length * vector(ours, "q"), vector(theirs, "q"))
    assert np.array_equal(length / time * vector(ours, "v"), vector(theirs, "v"))
    assert np.array_equal(mass / time**2 * vector(ours, "mu_first"), vector(theirs, "mu_first"))
    energy = mass * (length / time) ** 2
    assert ours["energy.work"] * energy == theirs["energy.work"]
    assert ours["energy.error"] == theirs["energy.error"]
