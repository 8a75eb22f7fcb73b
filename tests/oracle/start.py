"""What a run begins with: scales of rows, consistent velocities, first multipliers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from solver.runtime.layout import LEAF_RATE, LEAF_SIGNAL, NODE_POINT
from tests.oracle.forces import applied, laws
from tests.oracle.mechanism import Array, Mechanism
from tests.oracle.path import Path
from tests.oracle.slopes import discrete_gradient, still

RANK = 1e-10
"""Singular values of the scaled equations below this belong to dependent rows."""
TAU = 1e-3
"""Step of difference quotients along the motion, over the step size."""


def rows_of(mechanism: Mechanism) -> tuple[Array, Array, Array]:
    """Gradients G (r, n) of the rows, slopes by signals (r, n_signals), and Psi(q, v) (r,).

    Of velocity rows G is dPsi/dv; Psi of other rows is 0.
    """
    view, r = Path(mechanism).over_step(), mechanism.n_rows
    forms, coincidences, functions, velocities = mechanism.row_kinds
    G, psi = np.zeros((r, mechanism.n)), np.zeros(r)
    by_signals = np.zeros((r, len(mechanism.vectors["signal"])))
    G[forms] = view.gradients[mechanism.row_form]
    G[coincidences] = mechanism.U[mechanism.coincidence_form].reshape(-1, mechanism.n)
    for row, function in enumerate(mechanism.function_rows, functions.start):
        _, G[row], by_signals[row] = view.function(function)
    for row, (leaves, operations) in enumerate(mechanism.velocity_rows, velocities.start):
        gradients = [
            np.zeros(mechanism.n) if kind == LEAF_SIGNAL else view.quantity(index)[1]
            for kind, index in leaves
        ]
        values = [
            still(mechanism.vectors["signal"][index]) if kind == LEAF_SIGNAL
            else still(gradient @ mechanism.v) if kind == LEAF_RATE
            else view.quantity(index)[0]
            for (kind, index), gradient in zip(leaves, gradients, strict=True)
        ]  # fmt: skip
        value, c = discrete_gradient(operations, mechanism.numbers, values)
        rates = np.array([kind == LEAF_RATE for kind, _ in leaves])
        psi[row], G[row] = value.n, np.where(rates, c, 0.0) @ np.array(gradients)
    return G, by_signals, psi


def row_rates(mechanism: Mechanism, signal_rates: Array) -> Array:
    """Rates dPhi/dt (r,) of the rows; of velocity rows, Psi."""
    G, by_signals, psi = rows_of(mechanism)
    rates, velocities = G @ mechanism.v + by_signals @ signal_rates, mechanism.row_kinds[3]
    rates[velocities] = psi[velocities]
    return rates


def scales(mechanism: Mechanism) -> Array:
    """Extent (2), scales of the rows and sigma_i = (G m^-1 G')_ii, as a state keeps them."""
    section, dim, free = mechanism.section, mechanism.dim, mechanism.n_free
    moving = mechanism.node_kind[: mechanism.n // dim] == NODE_POINT
    mass, turning = (section["node_mass"][kind].sum() for kind in (moving, ~moving))
    nodes = np.concatenate([mechanism.x, section["support"]]).reshape(-1, dim)
    points = nodes[mechanism.node_kind[: len(nodes)] == NODE_POINT]
    box = np.ptp(points, axis=0) if len(points) else np.zeros(dim)
    extent = np.sqrt(box @ box + (turning / mass if mass > 0.0 else 0.0)) or 1.0
    size = np.sqrt(mass if mass > 0.0 else turning) * extent
    power = np.array(mechanism.model.tables["row_power"], dtype=float)
    scale = section["row_base"][: len(power)] * extent**power
    G = rows_of(mechanism)[0][:, :free]
    sigma = np.sum(G**2 / mechanism.m_node[:free], axis=1)
    sigma = np.where(sigma > 0.0, sigma, scale**2 / (size or 1.0) ** 2)
    return np.concatenate([[extent, size], scale, sigma])


def constrained(
    mechanism: Mechanism, M: Array, G: Array, f: Array, g: Array, weight: Array | float = 1.0
) -> tuple[Array, Array]:
    """Solution x, lam of M x + G' lam = f, G x = g for the free coordinates.

    Of dependent rows, the multipliers of least size, scaled with their compliance, are taken.
    `weight` (n_free,) is that of the coordinates in M.
    """
    n, sigma = len(f), mechanism.section["row_sigma"][: len(g)]
    scale = np.concatenate([weight * mechanism.m_node[:n], sigma]) ** -0.5
    K = scale[:, None] * np.block([[M, G.T], [G, np.zeros((len(g), len(g)))]]) * scale
    b, inverse = scale * np.concatenate([f, g]), np.linalg.pinv(K, rcond=RANK)
    y = np.zeros(len(b))
    for _ in range(3):  # what rounding leaves is solved for again
        y += inverse @ (b - K @ y)
    return scale[:n] * y[:n], scale[n:] * y[n:]


def consistent_velocities(mechanism: Mechanism) -> Array:
    """Velocities of the free nodes that rows and signals allow, next to those of the scene.

    M_w (v - v_0) + G' mu = 0, with masses M_w that are heavier where the scene gives a velocity.
    What the weights give way is put back in the next round; in the last the rows have their way.
    """
    free, section = slice(mechanism.n_free), mechanism.section
    at_start = Mechanism(mechanism.model, mechanism.head, mechanism.vectors)
    at_start.vectors["v_low"][:] = 0.0
    v, weight = at_start.vectors["v"], section["velocity_weight"]
    rates = mechanism.signal_rates(mechanism.head["time"])
    v[:] = section["initial_velocity"]
    v[mechanism.n_free :] = rates[: len(v) - mechanism.n_free]
    given = np.repeat(weight, mechanism.dim)[free] > 1.0
    G = rows_of(at_start)[0][:, free]
    for weights in (weight, weight, weight, np.ones_like(weight)):
        if weights is weight:
            v[free][given] = section["initial_velocity"][free][given]
        a, b = np.array(mechanism.model.tables["mass_node"]).reshape(-1, 2).T
        M = mechanism.mass_matrix(section["mass"] * np.sqrt(weights[a] * weights[b]))[free, free]
        heavy = np.repeat(weights, mechanism.dim)[free]
        rate = row_rates(at_start, rates)
        v[free] += constrained(mechanism, M, G, np.zeros(mechanism.n_free), -rate, heavy)[0]
    return v


def along(mechanism: Mechanism, rate: Callable[[Mechanism, float], Array]) -> Array:
    """Forward difference of `rate` at q, q + tau v and q + 2 tau v, with the signals then.

    Drivers may have a kink at the start, so nothing before it counts.
    """
    tau, t, values = TAU * mechanism.head["step_size"], mechanism.head["time"], []
    for step in (0.0, tau, 2.0 * tau):
        there = Mechanism(mechanism.model, mechanism.head, mechanism.vectors)
        there.vectors["q_low"] += step * mechanism.vectors["v"]
        there.vectors["signal"][:] = mechanism.signals(t + step)
        values.append(rate(there, t + step))
    return (-1.5 * values[0] + 2.0 * values[1] - 0.5 * values[2]) / tau


def first_multipliers(mechanism: Mechanism) -> tuple[Array, Array, Array]:
    """Multipliers, accelerations and forces on driven nodes: M a + G' lam = Q, G a = -bias."""
    n, head = mechanism.n_free, mechanism.head
    free, driven = slice(n), slice(n, None)
    delta, t = 1e-2 * head["step_size"], head["time"]
    b = [mechanism.signal_rates(t + k * delta) for k in range(3)]
    a = np.zeros(mechanism.n)
    a[driven] = ((-1.5 * b[0] + 2.0 * b[1] - 0.5 * b[2]) / delta)[: mechanism.n - n]
    G, _, _ = rows_of(mechanism)
    # A step of no length, in which quantities change at their present rates.
    path = Path(mechanism)
    still_here = path.over_step()
    Q = mechanism.weight + applied(mechanism, path) + sum(laws(mechanism, still_here))
    for quantity, c in zip(mechanism.elements, mechanism.section["damping"], strict=True):
        if c:
            gradient = still_here.quantity(quantity)[1]
            Q = Q - c * (gradient @ mechanism.v) * gradient
    forms, coincidences, _, _ = mechanism.row_kinds
    bias = np.zeros(mechanism.n_rows)
    if mechanism.function_rows or mechanism.velocity_rows:
        bias = along(mechanism, lambda m, time: row_rates(m, mechanism.signal_rates(time)))
    U_v, W_v = mechanism.U @ mechanism.vectors["v"], mechanism.W @ mechanism.vectors["v"]
    bias[forms] = 2.0 * np.sum(U_v * W_v, axis=1)[mechanism.row_form]
    bias[coincidences] = 0.0
    M, force = mechanism.M[free, free], (Q - mechanism.M @ a)[free]
    a[free], lam = constrained(mechanism, M, G[:, free], force, -(bias + G @ a))
    return lam, a, (mechanism.M @ a + G.T @ lam - Q)[driven]
