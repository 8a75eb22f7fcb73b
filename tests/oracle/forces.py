"""Forces besides the constraints, each in the discrete form whose work over a step is exact."""

from __future__ import annotations

import numpy as np

from solver.runtime.layout import QUANTITY_LENGTH
from tests.oracle.mechanism import QUARTER, Array, Mechanism
from tests.oracle.path import Path, View
from tests.oracle.slopes import angle_over

BODY_AXES = 1
"""Frame of a moment: that of the body, not the global one."""


def couple(moment: Array, u_n: Array, u_n1: Array) -> Array:
    """Force f = g m x u_mid of a moment m on a link, g = beta/|u_n x u_n1|, beta its turn.

    In the plane the work f . du = g m . (u_n x u_n1) is exactly m beta.
    """
    dim = len(u_n)
    a, b = (np.append(u, np.zeros(3 - dim)) for u in (u_n, u_n1))
    m = moment if dim == 3 else np.array([0.0, 0.0, moment[0]])
    cross = np.cross(a, b)
    g = angle_over(np.sqrt(np.sum(cross * cross)), np.sum(a * b))
    return (g * np.cross(m, 0.5 * (a + b)))[:dim]


def carried(axes: Array, load: Array) -> Array:
    """Load given in the axes of a body, from the coordinates of its directors."""
    if len(load) == 2:  # the second axis is J d
        return load[0] * axes + load[1] * QUARTER @ axes
    return load @ axes.reshape(3, 3)


def on_directors(directors: Array, moment: Array, frame: int) -> Array:
    """Forces f_i = m x d^i/2 (9,) on the directors of a body, with the dual directors d^i.

    With those, sum d_i x f_i = m also where d_i is shorter than 1 at the middle (theory 5.5).
    """
    D = directors.reshape(3, 3)
    m = moment @ D if frame == BODY_AXES else moment
    return 0.5 * np.cross(m, np.linalg.inv(D).T).ravel()


def applied(mechanism: Mechanism, path: Path) -> Array:
    """Loads on places, moments on links and on directors (n,); followers turn with their body."""
    x_mid, tables = mechanism.x + 0.5 * path.d, mechanism.model.tables
    Q = np.zeros_like(x_mid)
    loads = mechanism.section["load"].reshape(-1, mechanism.dim)
    width = 1 if mechanism.dim == 2 else 3
    for form, first, load in zip(tables["load_form"], tables["load_axes"], loads, strict=True):
        axes = x_mid[mechanism.dim * first : mechanism.dim * (first + width)]
        Q += mechanism.U[form].T @ (load if first < 0 else carried(axes, load))
    moments = mechanism.section["moment"].reshape(-1, width)
    for form, moment in zip(tables["moment_form"], moments, strict=True):
        u_n = path.u[form]
        Q += mechanism.U[form].T @ couple(moment, u_n, u_n + path.du[form])
    couples = mechanism.section["body_moment"].reshape(-1, 3)
    places = np.array(tables["body_moment"]).reshape(-1, 2)
    for (first, frame), moment in zip(places, couples, strict=True):
        nodes = slice(3 * first, 3 * first + 9)
        Q[nodes] += on_directors(x_mid[nodes], moment, frame)
    return Q


def laws(mechanism: Mechanism, view: View) -> tuple[Array, Array, Array]:
    """Forces -N grad sigma (n,) of springs and potentials, of dampers, and of drives.

    N = k (sigma_mean - rest), c dsigma/h and -drive for a quantity sigma.
    """
    stored, damping, drives = np.zeros((3, mechanism.n), dtype=view.gradients.dtype)
    names = ("stiffness", "rest", "damping", "drive")
    numbers = zip(*(mechanism.section[name] for name in names), strict=True)
    for quantity, (k, rest, c, drive) in zip(mechanism.elements, numbers, strict=True):
        kind, forms = mechanism.quantities[quantity]
        if kind == QUANTITY_LENGTH and rest == c == drive == 0.0:  # V = k s/2 needs no direction
            stored = stored - 0.5 * k * view.gradients[forms[0]]
            continue
        sigma, gradient = view.quantity(quantity)
        stored = stored - k * (sigma.mid - rest) * gradient
        damping = damping - c * sigma.d / view.h * gradient
        drives = drives + drive * gradient
    for potential in mechanism.potentials:
        stored = stored - view.function(potential)[1]
    return stored, damping, drives


def stored_energy(mechanism: Mechanism) -> float:
    """Energy k (sigma - rest)^2/2 of all springs, and that of the potentials [J]."""
    sigma, view = mechanism.sigma(), Path(mechanism).over_step()
    numbers = zip(mechanism.section["stiffness"], mechanism.section["rest"], strict=True)
    springs = sum(
        0.5 * k * (sigma[quantity] - rest) ** 2
        for quantity, (k, rest) in zip(mechanism.elements, numbers, strict=True)
        if k
    )
    return springs + sum(float(view.function(f)[0].n) for f in mechanism.potentials)
