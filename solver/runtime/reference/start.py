"""Start of a run: scaling of rows and penalties, the first multipliers and accelerations."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from .clock import Clock
from .course import RATE, Course, Present, Values
from .forces import step_force
from .laws import Function, elements, over_step
from .mechanism import POINT, Mechanism
from .slopes import discrete_gradient, still
from .state import Motion

Array = NDArray[np.float64]

RANK = 1e-10
"""Singular values of the scaled equations below this belong to dependent rows."""

TAU = 1e-3
"""Step of difference quotients along the motion, over the step size."""


def constrained(
    mechanism: Mechanism, M: Array, G: Array, f: Array, g: Array, weight: Array | float = 1.0
) -> tuple[Array, Array]:
    """Solution x, lam of M x + G' lam = f, G x = g for the free coordinates.

    Of dependent rows, the multipliers of least size, scaled with their compliance, are taken. A
    director can be next to massless, so that M is not inverted. `weight` (n_free,) is that of the
    coordinates in M: unscaled, heavy ones would let the rows of the others pass for dependent.
    """
    scale = np.concatenate([weight * mechanism.m_node[: len(f)], mechanism.sigma]) ** -0.5
    K = np.block([[M, G.T], [G, np.zeros((len(g), len(g)))]])
    K, b = scale[:, None] * K * scale, scale * np.concatenate([f, g])
    inverse = np.linalg.pinv(K, rcond=RANK)
    y = np.zeros(len(b))
    for _ in range(3):  # what rounding leaves is solved for again
        y += inverse @ (b - K @ y)
    return scale[: len(f)] * y[: len(f)], scale[len(f) :] * y[len(f) :]


def rows_of(mechanism: Mechanism, motion: Motion) -> tuple[Array, Array, Array]:
    """Gradients G (r, n) of the rows, shares of the signals (r, n_signals), and Psi(q, v) (r,).

    Of velocity rows G is dPsi/dv; Psi of other rows is 0.
    """
    present = Present(mechanism, motion)
    gradients, values = present.gradients(), present.values()
    forms, coincidences, functions, velocities = mechanism.row_kinds
    G = np.zeros((mechanism.n_rows, mechanism.n))
    by_signals = np.zeros((mechanism.n_rows, len(motion.signal)))
    psi = np.zeros(mechanism.n_rows)
    G[forms], G[coincidences] = gradients[mechanism.row_form], mechanism.coincidences
    for row, function in enumerate(mechanism.function_rows, functions.start):
        slopes = over_step(mechanism, function, values)
        G[row], by_signals[row] = slopes.g @ gradients, slopes.signals
    rates = present.form_rates(motion.v)
    for row, function in enumerate(mechanism.velocity_rows, velocities.start):
        psi[row], g = rolling_now(mechanism, function, values, rates)
        G[row] = g @ gradients
    return G, by_signals, psi


def rolling_now(
    mechanism: Mechanism, function: Function, values: Values, s_dot: Array
) -> tuple[float, Array]:
    """Psi(sigma, dsigma/dt) of a velocity row, and its slopes g (n_forms,) by the rates."""
    leaves, operations = function
    changes, p = [], []
    for kind, index in leaves:
        change, slopes = values.leaf(0 if kind == RATE else kind, index)
        changes.append(still(float(slopes @ s_dot)) if kind == RATE else change)
        p.append(slopes if kind == RATE else np.zeros_like(slopes))
    psi, c = discrete_gradient(operations, mechanism.numbers, changes)
    return float(psi.n), c @ np.array(p)


def row_rates(mechanism: Mechanism, motion: Motion, signal_rates: Array) -> Array:
    """Rates dPhi/dt (r,) of the rows; of velocity rows, Psi."""
    G, by_signals, psi = rows_of(mechanism, motion)
    rates = G @ motion.v + by_signals @ signal_rates
    velocities = mechanism.row_kinds[3]
    rates[velocities] = psi[velocities]
    return rates


def derive_scales(mechanism: Mechanism, motion: Motion) -> None:
    """Write extent of the mechanism, scales of the rows and sigma_i = (G m^-1 G')_ii."""
    section, dim = mechanism.section, mechanism.dim
    is_point = mechanism.node_kind[: mechanism.n_moving] == POINT
    mass = float(np.sum(section["node_mass"][is_point]))
    turning = float(np.sum(section["node_mass"][~is_point]))
    nodes = np.concatenate([motion.q, section["support"]]).reshape(-1, dim)
    points = nodes[mechanism.node_kind == POINT]
    box = np.ptp(points, axis=0) if len(points) else np.zeros(dim)
    extent = math.sqrt(float(box @ box) + (turning / mass if mass > 0.0 else 0.0))
    # Bodies that turn about fixed points alone: their inertia, with arms of 1.
    extent = extent or 1.0  # all in one place: nothing tells a size
    section["extent"][:] = extent, math.sqrt(mass if mass > 0.0 else turning) * extent
    power = np.array(mechanism.model.tables["row_power"], dtype=float)
    mechanism.row_scale[:] = section["row_base"] * extent**power
    free = slice(mechanism.n_free)
    G, _, _ = rows_of(mechanism, motion)
    sigma = np.sum(G[:, free] ** 2 / mechanism.m_node[free], axis=1)
    size = section["extent"][1] or 1.0
    mechanism.sigma[:] = np.where(sigma > 0.0, sigma, mechanism.row_scale**2 / size**2)


def forces_at_start(mechanism: Mechanism, motion: Motion) -> Array:
    """Forces Q(q, v) at the present state: those of a step of no length, and the dampers'."""
    present = Present(mechanism, motion)
    course = Course(present, np.zeros(mechanism.n), present.signal, 1.0)
    view = course.over_step()
    Q, _ = step_force(mechanism, view)
    rates = present.form_rates(motion.v)
    for law in elements(mechanism):
        if law.damping != 0.0:
            _, p = view.values.quantity(law.quantity)
            Q = Q - law.damping * (p @ rates) * (p @ view.gradients)
    return Q


def bias(mechanism: Mechanism, motion: Motion, clock: Clock, t: float) -> Array:
    """Rate of the rows' velocity along the motion with constant v: d/dtau (G v + phi_b b').

    Of form rows it is v' H v, of function and velocity rows a difference quotient.
    """
    forms, coincidences, _, _ = mechanism.row_kinds
    total = np.zeros(mechanism.n_rows)
    if mechanism.function_rows or mechanism.velocity_rows:
        tau = TAU * motion.head["step_size"]
        total = along(mechanism, motion, clock, t, tau, row_rates)
    U, W, v = mechanism.forms.U, mechanism.forms.W, motion.v
    quadratic = 2.0 * np.sum((U @ v) * (W @ v), axis=1)
    total[forms], total[coincidences] = quadratic[mechanism.row_form], 0.0
    return total


def along(
    mechanism: Mechanism,
    motion: Motion,
    clock: Clock,
    t: float,
    tau: float,
    rate: Callable[[Mechanism, Motion, Array], Array],
) -> Array:
    """Forward difference of `rate` at q, q + tau v and q + 2 tau v, with the signals then.

    Drivers may have a kink at the start, so nothing before it counts.
    """
    q_low, signal = motion.q_low.copy(), motion.signal.copy()
    values = []
    for step in (0.0, tau, 2.0 * tau):
        motion.q_low[:] = q_low + step * motion.v
        motion.signal[:] = clock.signals(t + step)
        values.append(rate(mechanism, motion, clock.signal_rates(t + step)))
    motion.q_low[:], motion.signal[:] = q_low, signal
    return (-1.5 * values[0] + 2.0 * values[1] - 0.5 * values[2]) / tau


def first_multipliers(
    mechanism: Mechanism, motion: Motion, clock: Clock
) -> tuple[Array, Array, Array]:
    """Multipliers, accelerations and forces on driven nodes: M a + G' lam = Q, G a = -bias."""
    free, driven = slice(mechanism.n_free), slice(mechanism.n_free, None)
    t = motion.head["time"]
    a = np.zeros(mechanism.n)
    a[driven] = clock.signal_accelerations(t)[: len(a[driven])]
    G, _, _ = rows_of(mechanism, motion)
    Q = forces_at_start(mechanism, motion)
    M, force = mechanism.M[free, free], (Q - mechanism.M @ a)[free]
    rest = bias(mechanism, motion, clock, t) + G @ a
    a[free], lam = constrained(mechanism, M, G[:, free], force, -rest)
    forces = (mechanism.M @ a + G.T @ lam - Q)[driven]
    return lam, a, forces


def has_dependent_rows(mechanism: Mechanism, motion: Motion) -> bool:
    """Whether some rows follow from the others at the present state."""
    G = rows_of(mechanism, motion)[0][:, : mechanism.n_free]
    scaled = G / np.sqrt(np.outer(mechanism.sigma, mechanism.m_node[: mechanism.n_free]))
    return np.linalg.matrix_rank(scaled, tol=1e-4) < len(G) if scaled.size else False
