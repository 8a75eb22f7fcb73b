"""Kernel and oracle agree on random mechanisms as closely as their conditioning allows."""

from __future__ import annotations

import itertools
import json
import random

import numpy as np
import pytest

import solver
from tests.oracle import HalfStep, Mechanism
from tests.twins import FORMULATIONS, internal_step, start, vector

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


def rounding(step):
    """First-order bound |J^-1| b on the error of (w, mu) by rounding b of the residual's terms.

    Terms of the momentum balance are (2/h) M w, h G' mu and the forces; those of a row are l^2,
    which Phi_n is a difference of, l |d| and mu/alpha.
    """
    equations, oracle, w, mu, h = step.equations, step.mechanism, step.w, step.mu, step.h
    path = equations.path(w)
    _, G_bar, _ = equations.rows(path)
    J, n = equations.tangent(w, mu, mu), len(w)
    inertia = 2.0 / h * np.abs(oracle.M) @ np.abs(w)
    reaction = h * np.abs(G_bar).T @ np.abs(mu)
    force = h * np.abs(oracle.weight)
    laws = (oracle.section[name] for name in ("stiffness", "damping"))
    for quantity, stiffness, damping in zip(oracle.elements, *laws, strict=True):
        (form,) = oracle.quantities[quantity][1]
        u_n, du = np.linalg.norm(path.u[form]), np.linalg.norm(path.du[form])
        along = h * stiffness * (u_n + du) + damping * du
        force += np.abs(oracle.U[form]).T @ np.full(oracle.dim, along)
    moments = oracle.section["moment"].reshape(-1, 1 if oracle.dim == 2 else 3)
    for form, moment in zip(oracle.model.tables["moment_form"], moments, strict=True):
        most = np.max(np.abs(moment)) / np.linalg.norm(path.u[form])
        force += h * np.abs(oracle.U[form]).T @ np.full(oracle.dim, most)
    C_w, scale = np.abs(J[n:, :n]), oracle.section["row_scale"][: len(mu)]
    row = np.sqrt(scale) * np.max(C_w, axis=1, initial=0.0) + C_w @ np.abs(path.d)
    b = np.concatenate([inertia + reaction + force, row + np.abs(mu / equations.alpha)])
    return EPSILON * (np.abs(np.linalg.inv(J)) @ b + np.abs(np.concatenate([w, mu]))), G_bar


def unknowns(run, half):
    """Solution (w, mu) of the last step."""
    h, name = run.state.head["step_size"], ("first", "second")[half]
    return 0.5 * h**2 * vector(run, f"a_{name}"), vector(run, f"mu_{name}")


def nearly_dependent(G):
    """Whether the rows, scaled to unit gradients, are dependent up to a hundred times 1/chi."""
    if len(G) == 0:
        return False
    scaled = G / np.linalg.norm(G, axis=1, keepdims=True)
    return np.linalg.svd(scaled, compute_uv=False)[-1] ** 2 < 1e-6


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("seed", range(24))
def test_random_mechanisms_move_by_the_equations_up_to_their_conditioning(seed, formulation):
    model = mechanism(seed)
    settings = {} if "-al" in formulation else {"penalty": 1e3}
    run = start(model, formulation=formulation, paired=False, **settings)
    for half in (0, 1, 0, 1):
        h = run.state.head["step_size"]
        step = HalfStep(Mechanism.of(model, run.state), h, half=half)
        internal_step(run)
        assert run.state.head["substeps"] == 1
        w, mu = unknowns(run, half)
        bound, G = rounding(step)
        # A rounding for each of the few updates of mu.
        bound_w, bound_mu = np.split(10.0 * bound, [len(w)])
        assert np.all(np.abs(w - step.w) <= bound_w)
        if nearly_dependent(G):
            # The multipliers are then what the iteration makes of them; their forces are not: by
            # the momentum balance they differ by the inertia of what w differs, and by rounding.
            force = 2.0 / h**2 * np.abs(step.mechanism.M) @ bound_w
            force += 10.0 * EPSILON * np.abs(G).T @ np.abs(mu)
            assert np.all(np.abs(G.T @ (mu - step.mu)) <= force)
        else:
            assert np.all(np.abs(mu - step.mu) <= bound_mu)
