"""Siconos on the experiments: Moreau's and Jean's time stepping; runs where `siconos` is.

V. Acary, O. Bonnefon, M. Bremond, O. Huber, F. Perignon, S. Sinclair, "An introduction to Siconos",
INRIA TR-0340, 2019. Bodies are Lagrangian systems with constant mass matrix and constant rows, as
they are at the instant of the impact; one step takes it. Its law of impact is Newton's with
Coulomb's friction against the slip at the end (NewtonImpactFrictionNSL, NewtonImpactNSL).
"""

from __future__ import annotations

import numpy as np
import siconos.kernel as sk
import siconos.numerics as sn

from benchmarks.contact_laws.experiments import (
    GRAVITY,
    PARK_FRICTION,
    PARK_TIME,
    Impact,
    Rest,
    parked_rows,
)
from benchmarks.contact_laws.method import Method, RefusedError
from benchmarks.problems.parts import Array

THETA = 0.5
SHORT = 1e-6
"""The one step of an impact [s]."""
STEP = 1e-3
"""Of the parked box [s]."""
TOLERANCE = 1e-14
"""Of the one-step problem; a looser one decides what friction does."""
ITERATIONS = 100_000
ACTIVE = 1e-9
"""Gap [m] below which a contact acts: by default 0, which round-off leaves for some steps."""


def _run(
    M: Array, rows: list[Array], start: Array, force: Array, mu: float, e: float, h: float, n: int
) -> tuple[Array, Array]:
    """Displacements and velocities after n steps; rows[i] are those of contact i."""
    still = np.zeros(len(start))
    body = sk.LagrangianLinearTIDS(still, start, M)
    body.setFExtPtr(force)
    model = sk.NonSmoothDynamicalSystem(0.0, (n + 1) * h)
    model.insertDynamicalSystem(body)
    rubs = mu > 0.0
    size = len(rows[0]) if rubs else 1
    for contact in rows:
        law = sk.NewtonImpactFrictionNSL(e, 0.0, mu, size) if rubs else sk.NewtonImpactNSL(e)
        relation = sk.LagrangianLinearTIR(np.ascontiguousarray(contact[:size]))
        model.link(sk.Interaction(law, relation), body)
    problem = _problem(rubs, size)
    scheme = sk.MoreauJeanOSI(THETA)
    scheme.setConstraintActivationThreshold(ACTIVE)
    simulation = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, h), scheme, problem)
    simulation.setNewtonTolerance(1e-12)
    for _ in range(n):
        simulation.computeOneStep()
        simulation.nextStep()
    return np.array(body.q()), np.array(body.velocity())


def _problem(rubs: bool, size: int) -> sk.LinearOSNS:
    if not rubs:
        problem = sk.LCP()
    else:
        kind = sn.SICONOS_FRICTION_2D_ENUM if size == 2 else sn.SICONOS_FRICTION_3D_NSGS
        problem = sk.FrictionContact(size, kind)
        options = problem.numericsSolverOptions()
        options.dparam[sn.SICONOS_DPARAM_TOL] = TOLERANCE
        options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = ITERATIONS
    problem.setMaxSize(1000)
    problem.setMStorageType(0)
    return problem


def _impact(impact: Impact, mu: float, e: float) -> Array:
    size = 1 + impact.tangents
    rows = [impact.G[i * size : (i + 1) * size] for i in impact.order]
    force = np.zeros(len(impact.before))
    try:
        _, v = _run(impact.M, rows, impact.before, force, mu, e, SHORT, 1)
    except RuntimeError as error:
        raise RefusedError(str(error)) from error
    if not np.all(np.isfinite(v)):
        message = "its one-step problem was not solved"
        raise RefusedError(message)
    return v


def _rest(demand: float) -> Rest:
    M, rows = parked_rows()
    gravity = np.array([demand * GRAVITY, 0.0, -GRAVITY, 0.0, 0.0, 0.0])
    q, _ = _run(
        M, rows, np.zeros(6), M @ gravity, PARK_FRICTION, 0.0, STEP, round(PARK_TIME / STEP)
    )
    return Rest(float(q[0]), float(q[2]))


METHODS = (
    Method(
        name="Siconos, Moreau-Jean",
        settings=(
            f"theta {THETA:g}, contacts act below {ACTIVE:g} m; NSGS to {TOLERANCE:g}, in a plane "
            f"enumeration, without friction Lemke's LCP; an impact is one step, at rest steps of "
            f"{1e3 * STEP:g} ms"
        ),
        impact=_impact,
        rest=_rest,
    ),
)
