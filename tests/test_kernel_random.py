"""Kernel and reference agree on random mechanisms as closely as their conditioning allows."""

from __future__ import annotations

import itertools
import json
import random

import numpy as np
import pytest

import solver
from solver.runtime.reference.equations import Equations
from solver.runtime.reference.forces import length
from solver.runtime.reference.laws import elements
from solver.runtime.reference.mechanism import Mechanism
from solver.runtime.reference.state import Motion
from tests.twins import FORMULATIONS, KERNELS, block, internal_step, numbers, start, vector

EPSILON = float(np.finfo(float).eps)


def random_forces(choose, pairs, bars, dim):
    """Springs and dampers between some of the pairs, torques on some of the bars."""
    forces = {}
    for number, pair in enumerate(choose.sample(pairs, min(len(pairs), choose.randint(0, 4)))):
        spring = {"stiffness": 10 ** choose.uniform(0, 4), "free_length": choose.choice([0, 0.5])}
        law = choose.choice(
            [
                {"type": "spring"} | spring,
                {"type": "damper", "damping": 10 ** choose.uniform(-1, 2)},
            ]
        )
        forces[f"f{number}"] = law | {"points": pair}
    for name in bars:
        if choose.random() < 0.5:
            value = 5.0 if dim == 2 else [1.0, -2.0, 3.0]
            forces[f"torque_{name}"] = {"type": "torque", "body": name, "value": value}
    return forces


def mechanism(seed):
    """Up to six points with masses over four decades, linked at random, in plane or space.

    Some are trees, some have loops, some have dependent rows.
    """
    choose = random.Random(seed)
    dim = choose.choice([2, 3])
    count = choose.randint(1, 6)
    points = {
        f"P{i}": {
            "position": [choose.uniform(-1, 1) for _ in range(dim)],
            "mass": 10 ** choose.uniform(-2, 2),
        }
        for i in range(count)
    }
    points["O"] = {"position": [0.0] * dim, "fixed": True}
    pairs = [list(pair) for pair in itertools.combinations(points, 2)]
    choose.shuffle(pairs)
    rows = choose.randint(0, min(len(pairs), count * dim - 1))
    bars, joints = {}, {}
    for number, pair in enumerate(pairs[:rows]):
        if choose.random() < 0.4:
            bars[f"b{number}"] = {
                "type": "bar",
                "points": pair,
                "mass": 10 ** choose.uniform(-1, 1),
            }
        else:
            joints[f"j{number}"] = {"type": "distance", "points": pair}
    content = {
        "name": "random",
        "dimension": dim,
        "gravity": [0.0] * (dim - 1) + [-9.81],
        "points": points,
        "bodies": bars,
        "joints": joints,
        "forces": random_forces(choose, pairs, bars, dim),
    }
    return solver.assemble(solver.loads(json.dumps(content), format="json"))


def rounding(equations, w, mu):
    """First-order bound |J^-1| b on the error of (w, mu) by rounding b of the residual's terms.

    Terms of the momentum balance are (2/h) M w, h G' mu and the forces; those of a row are l^2,
    which Phi_n is a difference of, l |d| and mu/alpha.
    """
    mechanism, h, d = equations.mechanism, equations.h, equations.d(w)
    forms, u_n = mechanism.forms, equations.present.u
    inertia = 2.0 / h * np.abs(mechanism.M) @ np.abs(w)
    reaction = h * np.abs(equations.G_mid(w)).T @ np.abs(mu)
    force = h * np.abs(mechanism.weight)
    for law in elements(mechanism):
        (form,) = mechanism.quantities[law.quantity][1]
        du = length(forms.U[form] @ d)
        along = h * law.stiffness * (length(u_n[form]) + du) + law.damping * du
        force += np.abs(forms.U[form]).T @ np.full(mechanism.dim, along)
    for form, moment in zip(mechanism.moment_form, mechanism.moment, strict=True):
        most = np.max(np.abs(moment)) / length(u_n[form])
        force += h * np.abs(forms.U[form]).T @ np.full(mechanism.dim, most)
    _, C_w = equations.C(w)
    lengths = mechanism.row_scale * np.max(np.abs(C_w), axis=1, initial=0.0)
    row = lengths / np.sqrt(mechanism.row_scale) + np.abs(C_w) @ np.abs(d)
    b = np.concatenate([inertia + reaction + force, row + np.abs(mu / equations.alpha)])
    inverse = np.abs(np.linalg.inv(equations.tangent(w, mu)))
    return EPSILON * (inverse @ b + np.abs(np.concatenate([w, mu])))


def unknowns(run, half):
    """Solution (w, mu) of the last step."""
    h, name = run.state.head["step_size"], ("first", "second")[half]
    return 0.5 * h**2 * vector(run, f"a_{name}"), vector(run, f"mu_{name}")


def nearly_dependent(equations, w):
    """Whether the rows, scaled to unit gradients, are dependent up to a hundred times 1/chi."""
    G = equations.G_mid(w)
    if len(G) == 0:
        return False
    scaled = G / np.linalg.norm(G, axis=1, keepdims=True)
    return np.linalg.svd(scaled, compute_uv=False)[-1] ** 2 < 1e-6


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("seed", range(24))
def test_random_mechanisms_move_alike_up_to_their_conditioning(seed, formulation):
    model = mechanism(seed)
    settings = {} if "-al" in formulation else {"penalty": 1e3}
    kernel, oracle = (
        start(model, twin, formulation=formulation, paired=False, **settings) for twin in KERNELS
    )
    for half in (0, 1, 0, 1):
        block(oracle)[:] = block(kernel)
        equations = Equations(
            Mechanism(model, numbers(oracle)), Motion(model, oracle.engine.state), 0.01
        )
        for twin in (kernel, oracle):
            internal_step(twin)
        assert kernel.state.head["substeps"] == 1
        (w, mu), theirs = unknowns(kernel, half), unknowns(oracle, half)
        bound = 10.0 * rounding(equations, *theirs)  # a rounding for each of the few updates of mu
        bound_w, bound_mu = np.split(bound, [len(w)])
        assert np.all(np.abs(w - theirs[0]) <= bound_w)
        if nearly_dependent(equations, w):
            # The multipliers are then what the iteration makes of them; their forces are not: by
            # the momentum balance they differ by the inertia of what w differs, and by rounding.
            G, M = equations.G_mid(w), equations.mechanism.M
            force = 2.0 / equations.h**2 * np.abs(M) @ bound_w
            force += 10.0 * EPSILON * np.abs(G).T @ np.abs(mu)
            assert np.all(np.abs(G.T @ (mu - theirs[1])) <= force)
        else:
            assert np.all(np.abs(mu - theirs[1]) <= bound_mu)
