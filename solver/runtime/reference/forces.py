"""Forces besides the constraints, each in the discrete form whose work over a step is exact.

For a step d = q_n1 - q_n they are Q (n,) with the tangent dQ/dd (n, n), over all moving nodes:
weight, loads on places, moments on links and on directors, springs, dampers and potentials.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import Status
from .course import View
from .forms import QUARTER
from .laws import elements, forms_of, over_step, tangent
from .mechanism import Mechanism
from .unsolved import UnsolvedError

Array = NDArray[np.float64]

BODY_AXES = 1
"""Frame of a moment: that of the body, not the global one."""


def length(u: Array) -> float:
    """Euclidean length of a link."""
    return float(np.sqrt(u @ u))


def in_space(x: Array) -> Array:
    """Vector of the plane as a vector of space."""
    return np.append(x, np.zeros(3 - len(x)))


def couple(moment: Array, u_n: Array, du: Array) -> tuple[Array, Array]:
    """Force f [N] of a moment m on a link, and its derivative in du = u_n1 - u_n.

    f = g m x u_mid with g = beta/|u_n x u_n1|, beta the angle from u_n to u_n1. In the plane the
    work f . du = g m . (u_n x u_n1) is exactly m beta.
    """
    dim = len(u_n)
    m = in_space(moment) if dim == 3 else np.array([0.0, 0.0, moment[0]])
    u_n, u_n1 = in_space(u_n), in_space(u_n + du)
    size2 = length(u_n) * length(u_n1)
    if not size2 > 0.0:
        raise UnsolvedError(Status.ZERO_LENGTH)
    cross: Array = np.cross(u_n, u_n1).astype(np.float64)
    beta = float(np.arctan2(length(cross), u_n @ u_n1))
    g = 1.0 / (size2 * np.sinc(beta / np.pi))
    # dg/du_n1 from g = (beta/sin beta)/(|u_n| |u_n1|); the quotient below tends to 1/3.
    quotient = (
        (np.sin(beta) - beta * np.cos(beta)) / np.sin(beta) ** 3 if beta > 1e-3 else 1.0 / 3.0
    )
    dg = -g * u_n1 + quotient * np.cross(cross, u_n1) / size2**2
    dg /= u_n1 @ u_n1
    arm: Array = np.cross(m, 0.5 * (u_n + u_n1)).astype(np.float64)
    skew = np.cross(m, np.eye(3)).T
    tangent = np.outer(arm, dg) + 0.5 * g * skew
    return (g * arm)[:dim], tangent[:dim, :dim]


def carried(axes: Array, load: Array) -> Array:
    """Load given in the axes of a body, from the coordinates of its directors."""
    if len(load) == 2:  # the second axis is J d
        return load[0] * axes + load[1] * QUARTER @ axes
    return load @ axes.reshape(3, 3)


def directors_moved(directors: Array, moment: Array, frame: int) -> Array:
    """Forces (9,) on the directors of a body by a moment.

    f_i = m x d^i/2 with the dual directors d^i; with those, sum d_i x f_i = m also where a step
    has left d_i at its middle shorter than 1 (theory 5.5).
    """
    D = directors.reshape(3, 3)
    m = moment @ D if frame == BODY_AXES else moment
    try:
        dual = np.linalg.inv(D).T
    except np.linalg.LinAlgError:
        raise UnsolvedError(Status.NOT_FINITE) from None
    return 0.5 * np.cross(m, dual).astype(np.float64).ravel()


def loads(mechanism: Mechanism, view: View) -> tuple[Array, Array]:
    """Forces at places, and their tangent: a load in body axes turns with the body."""
    Q, Q_d = np.zeros(mechanism.n), np.zeros((mechanism.n, mechanism.n))
    for form, first, load in zip(
        mechanism.load_form, mechanism.load_axes, mechanism.load, strict=True
    ):
        U = mechanism.forms.U[form]
        if first < 0:
            Q += U.T @ load
            continue
        width = 1 if mechanism.dim == 2 else 3
        axes = slice(mechanism.dim * first, mechanism.dim * (first + width))
        Q += U.T @ carried(view.coordinates()[axes], load)
        turned = np.transpose([carried(unit, load) for unit in np.eye(mechanism.dim * width)])
        Q_d[:, axes] += view.part * U.T @ turned
    return Q, Q_d


def moments(mechanism: Mechanism, view: View) -> tuple[Array, Array]:
    """Moments on links and on directors, and their tangent."""
    Q, Q_d = np.zeros(mechanism.n), np.zeros((mechanism.n, mechanism.n))
    for form, moment in zip(mechanism.moment_form, mechanism.moment, strict=True):
        U = mechanism.forms.U[form]
        f, f_u = couple(moment, *view.link(form))
        Q += U.T @ f
        Q_d += view.of_end * U.T @ f_u @ U
    for (first, frame), moment in zip(mechanism.body_moments, mechanism.couples, strict=True):
        directors = slice(3 * first, 3 * first + 9)
        x, small = view.coordinates()[directors], 1e-5 * np.eye(9)
        Q[directors] += directors_moved(x, moment, frame)
        columns = [
            directors_moved(x + e, moment, frame) - directors_moved(x - e, moment, frame)
            for e in small
        ]
        Q_d[directors, directors] += view.part * np.transpose(columns) / 2e-5
    return Q, Q_d


def stored_forces(mechanism: Mechanism, view: View) -> tuple[Array, Array]:
    """Springs, dampers, drives and potentials, and their tangent."""
    Q, Q_d = np.zeros(mechanism.n), np.zeros((mechanism.n, mechanism.n))
    laws = [
        (element.slopes, mechanism.quantities[element.quantity][1])
        for element in elements(mechanism)
    ]
    for potential in mechanism.potentials:
        laws.append(
            (
                lambda values, function=potential: over_step(mechanism, function, values).g,
                forms_of(mechanism, potential[0]),
            )
        )
    for slopes, forms in laws:
        Q -= slopes(view.values) @ view.gradients
        Q_d -= tangent(view, slopes, forms)
    return Q, Q_d


def step_force(mechanism: Mechanism, view: View) -> tuple[Array, Array]:
    """Q (n,) of all forces over a step, and dQ/dd (n, n)."""
    parts = [law(mechanism, view) for law in (loads, moments, stored_forces)]
    Q = mechanism.weight + sum(Q for Q, _ in parts)
    return Q, np.asarray(sum(Q_d for _, Q_d in parts))
