"""What a run begins with: scales of rows, consistent velocities, first multipliers."""

from __future__ import annotations

import numpy as np

from solver.runtime.layout import LEAF_RATE, LEAF_SIGNAL, NODE_POINT
from tests.oracle.forces import applied, laws
from tests.oracle.mechanism import TINY, Array, Mechanism
from tests.oracle.path import Path, View
from tests.oracle.slopes import discrete_gradient, still

RANK = 1e-10
"""Singular values of the scaled equations below this belong to dependent rows."""


def rows_of(mechanism: Mechanism, view: View | None = None) -> tuple[Array, Array, Array]:
    """Gradients G (r, n) of the rows, slopes by signals (r, n_signals), and Psi(q, v) (r,).

    Of velocity rows G is dPsi/dv; Psi of other rows is 0. A view beside the present, by an
    imaginary step, has derivatives as imaginary parts.
    """
    view, r = view or Path(mechanism).over_step(), mechanism.n_rows
    forms, coincidences, functions, velocities = mechanism.row_kinds
    dtype = view.gradients.dtype
    G, psi = np.zeros((r, mechanism.n), dtype), np.zeros(r, dtype)
    by_signals = np.zeros((r, len(mechanism.vectors["signal"])), dtype)
    G[forms] = view.gradients[mechanism.row_form]
    G[coincidences] = mechanism.U[mechanism.coincidence_form].reshape(-1, mechanism.n)
    for row, function in enumerate(mechanism.function_rows, functions.start):
        _, G[row], by_signals[row] = view.function(function)
    for row, (leaves, operations) in enumerate(mechanism.velocity_rows, velocities.start):
        gradients = [
            np.zeros(mechanism.n, dtype) if kind == LEAF_SIGNAL else view.quantity(index)[1]
            for kind, index in leaves
        ]
        values = [
            still(view.signal_n[index]) if kind == LEAF_SIGNAL
            else still(gradient @ mechanism.v) if kind == LEAF_RATE
            else view.quantity(index)[0]
            for (kind, index), gradient in zip(leaves, gradients, strict=True)
        ]  # fmt: skip
        value, c = discrete_gradient(operations, mechanism.numbers, values)
        rates = np.array([kind == LEAF_RATE for kind, _ in leaves])
        psi[row], G[row] = value.n, np.where(rates, c, 0.0) @ np.array(gradients)
    return G, by_signals, psi


def row_rates(mechanism: Mechanism, signal_rates: Array, view: View | None = None) -> Array:
    """Rates dPhi/dt (r,) of the rows; of velocity rows, Psi."""
    G, by_signals, psi = rows_of(mechanism, view)
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
    mechanism: Mechanism,
    M: Array,
    G: Array,
    f: Array,
    g: Array,
    weight: Array | float = 1.0,
    off: Array | None = None,
) -> tuple[Array, Array]:
    """Solution x, lam of M x + G' lam = f, G x = g for the free coordinates.

    Of dependent rows, the multipliers of least size, scaled with their compliance, are taken.
    `weight` (n_free,) is that of the coordinates in M. A line of `off` (r, r) that is not zero
    takes the place of its row, off lam = g.
    """  # fmt: skip
    n, r, sigma = len(f), len(g), mechanism.section["row_sigma"][: len(g)]
    here = np.sum(G**2 / mechanism.m_node[:n], axis=1)  # the gradient of a gap may begin with 0
    sigma = np.where(mechanism.bilateral | (here == 0.0), sigma, here)
    off = np.zeros((r, r)) if off is None else off
    is_off = np.any(off, axis=1)
    G_on = np.where(is_off[:, None], 0.0, G)
    scale = np.concatenate([weight * mechanism.m_node[:n], sigma]) ** -0.5
    left = np.concatenate([scale[:n], np.where(is_off, 1.0 / scale[n:], scale[n:])])
    K = left[:, None] * np.block([[M, G.T], [G_on, off]]) * scale
    b, inverse = left * np.concatenate([f, g]), np.linalg.pinv(K, rcond=RANK)
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
    G, off = rows_of(at_start)[0][:, free], -np.diag(1.0 - mechanism.bilateral)
    for weights in (weight, weight, weight, np.ones_like(weight)):
        if weights is weight:
            v[free][given] = section["initial_velocity"][free][given]
        a, b = np.array(mechanism.model.tables["mass_node"]).reshape(-1, 2).T
        M = mechanism.mass_matrix(section["mass"] * np.sqrt(weights[a] * weights[b]))[free, free]
        heavy = np.repeat(weights, mechanism.dim)[free]
        rate = np.where(mechanism.bilateral, row_rates(at_start, rates), 0.0)
        nothing = np.zeros(mechanism.n_free)
        v[free] += constrained(mechanism, M, G, nothing, -rate, heavy, off)[0]
    return v


def biases(mechanism: Mechanism) -> Array:
    """Rates (r,) of ``row_rates`` at constant velocities, where the rows ask for G a = -bias."""
    delta, t = 1e-2 * mechanism.head["step_size"], mechanism.head["time"]
    rates = mechanism.signal_rates(t)
    later = [mechanism.signal_rates(t + k * delta) - rates for k in range(1, 5)]
    bends = np.array([48.0, -36.0, 16.0, -3.0]) @ later / (12.0 * delta)
    beside = mechanism.vectors["signal"] + 1j * TINY * rates
    view = Path(mechanism, 1j * TINY * mechanism.vectors["v"], beside).at_end()
    return row_rates(mechanism, rates + 1j * TINY * bends, view).imag / TINY + drift(mechanism)


def drift(mechanism: Mechanism) -> Array:
    """Rates (r,) of velocity rows by numbers that change with time, such as a surface's speed."""
    delta, t = 1e-2 * mechanism.head["step_size"], mechanism.head["time"]
    if not (mechanism.velocity_rows and mechanism.model.sizes["time_dependent"]):
        return np.zeros(mechanism.n_rows)
    psi = []
    for k in (4, 3, 2, 1, 0):
        mechanism.forces_at(t + k * delta, 0.0, 0)
        psi.append(rows_of(mechanism)[2])
    return np.array([-3.0, 16.0, -36.0, 48.0, -25.0]) @ psi / (12.0 * delta)


class Accelerations:
    """Forces, rows and biases at the present state, of accelerations and multipliers there.

    M a + G' mu = Q,    G a = -bias of rows that hold,    mu_k = (c N + N_0) t_k of the others.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism, n, head = mechanism, mechanism.n_free, mechanism.head
        delta, t = 1e-2 * head["step_size"], head["time"]
        b = [mechanism.signal_rates(t + k * delta) for k in range(3)]
        self.driven = ((-1.5 * b[0] + 2.0 * b[1] - 0.5 * b[2]) / delta)[: mechanism.n - n]
        self.G, _, _ = rows_of(mechanism)
        self.bias = biases(mechanism)
        # A step of no length, in which quantities change at their present rates.
        path = Path(mechanism)
        here = path.over_step()
        self.Q = mechanism.weight + applied(mechanism, path) + sum(laws(mechanism, here))
        for quantity, c in zip(mechanism.elements, mechanism.section["damping"], strict=True):
            if c:
                gradient = here.quantity(quantity)[1]
                self.Q = self.Q - c * (gradient @ mechanism.v) * gradient

    def solve(self) -> tuple[Array, Array]:
        """Multipliers (r,) and accelerations (n,) with the present modes."""
        mechanism, n, r = self.mechanism, self.mechanism.n_free, self.mechanism.n_rows
        free, off = slice(n), ~mechanism.rows_on()
        a, mu = np.concatenate([np.zeros(n), self.driven]), np.zeros(r)
        force, M = (self.Q - mechanism.M @ a)[free], mechanism.M[free, free]
        rates = -(self.bias + self.G @ a)
        for _ in range(30):  # normal forces of joints are norms of multipliers
            slope = mechanism.cone_slopes(mu) - np.diag(off.astype(float))
            g = np.where(off, slope @ mu + mu - mechanism.sliding_multipliers(mu), rates)
            a[free], found = constrained(mechanism, M, self.G[:, free], force, g, off=slope)
            moved, mu = np.max(np.abs(found - mu), initial=0.0), found
            if moved <= 1e-14 * np.max(np.abs(mu), initial=0.0) or not np.any(off):
                break
        return mu, a

    def second_rates(self, a: Array) -> Array:
        """Second derivatives of the rows, of velocity rows their rates (r,)."""
        return self.G @ a + self.bias


def first_multipliers(mechanism: Mechanism) -> tuple[Array, Array, Array]:
    """Multipliers, accelerations and forces on driven nodes: M a + G' lam = Q, G a = -bias."""
    at_start = Accelerations(mechanism)
    lam, a = at_start.solve()
    return lam, a, (mechanism.M @ a + at_start.G.T @ lam - at_start.Q)[mechanism.n_free :]
