"""The measurements that outputs are made of, at a mechanism's state, each from its definition."""

from __future__ import annotations

import numpy as np

from solver.runtime.layout import NODE_POINT
from tests.oracle.forces import stored_energy
from tests.oracle.mechanism import Array, Mechanism
from tests.oracle.start import row_rates
from tests.oracle.step import rows_now

LINK_FORCE, ROW_FORCE, ROW_TORQUE = 0, 1, 2
"""Kinds of what a reaction is made of."""


def at_present(mechanism: Mechanism, name: str = "") -> Array:
    """Multipliers ("") or forces on driven nodes ("driven_") at the present time.

    Those of a half step are constant over it and have a component of alternating sign, which the
    mean of two neighbours removes; the line through the last two means leads to the present.
    """
    head, vectors = mechanism.head, mechanism.vectors
    mean, before = vectors[f"{name}mean"], vectors[f"{name}mean_before"]
    gap, beyond = head["mean_time"] - head["mean_time_before"], head["time"] - head["mean_time"]
    return mean + (beyond / gap if 0.0 < gap < np.inf else 0.0) * (mean - before)


def rotation_quaternion(R: Array) -> Array:
    """Unit quaternion (w, x, y, z) of a rotation, of any sign: 4 q q' from the entries of R."""
    skew = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    K = np.zeros((4, 4))
    K[0, 0], K[0, 1:], K[1:, 0] = 1.0 + np.trace(R), skew, skew
    K[1:, 1:] = R + R.T + (1.0 - np.trace(R)) * np.eye(3)
    column = K[:, np.argmax(np.diag(K))]  # the largest is a root far from zero
    return column / np.linalg.norm(column)


def energies(mechanism: Mechanism) -> list[float]:
    """Kinetic, potential and total energy, work, dissipation, balance [J], relative error."""
    head, vectors = mechanism.head, mechanism.vectors
    kinetic = 0.5 * float(vectors["v"] @ mechanism.M @ mechanism.v)
    # On displacements: on positions weights lose digits far from the origin.
    moved = (vectors["q"] - vectors["start"]) + vectors["q_low"]
    change = -float(mechanism.weight @ moved) + stored_energy(mechanism) - head["stored_start"]
    potential = head["potential_start"] + change
    balance = kinetic - head["kinetic_start"] + change - (head["work"] - head["dissipated"])
    error = abs(balance) / (head["energy_reference"] or 1.0)
    return [
        kinetic, potential, kinetic + potential, head["work"], head["dissipated"], balance, error
    ]  # fmt: skip


def reactions(mechanism: Mechanism) -> tuple[Array, Array]:
    """Forces [N] and torques [N m] of joints on their second bodies."""
    dim, mu = mechanism.dim, at_present(mechanism)
    u, w = mechanism.links()
    count = mechanism.model.sizes["n_reactions"]
    forces, torques = np.zeros((count, dim)), np.zeros((count, 1 if dim == 2 else 3))
    entries = np.array(mechanism.model.tables["reaction_entry"], dtype=int).reshape(-1, 4)
    for reaction, kind, index, sign in entries:
        if kind == LINK_FORCE:
            first = mechanism.row_kinds[1].start + dim * index
            forces[reaction] += sign * mu[first : first + dim]
            continue
        form, factor = mechanism.row_form[index], -sign * mu[index]
        if kind == ROW_FORCE:
            forces[reaction] += factor * w[form]
        elif dim == 2:
            torques[reaction] += factor * (w[form, 0] * u[form, 1] - w[form, 1] * u[form, 0])
        else:
            torques[reaction] += factor * np.cross(w[form], u[form])
    return forces, torques


def measurements(mechanism: Mechanism) -> dict[str, Array]:
    """All of them, by the names of ``layout.measured_sections``; those of the solver left out."""
    section, vectors, head = mechanism.section, mechanism.vectors, mechanism.head
    model, dim, v = mechanism.model, mechanism.dim, mechanism.vectors["v"]
    u, w = mechanism.links()
    sigma = mechanism.sigma()
    s_dot = np.sum(u * (mechanism.W @ v) + w * (mechanism.U @ v), axis=1)
    rates = mechanism.rates_at(np.sum(u * w, axis=1), s_dot)
    numbers = (section[name] for name in ("stiffness", "rest", "damping", "drive"))
    mu, places = at_present(mechanism), list(model.tables["place_form"])
    quaternions, turning = [], []
    bodies = model.tables["body_node"] if dim == 3 else ()
    for node, near in zip(bodies, vectors["quaternion"].reshape(-1, 4), strict=True):
        d, d_dot = (x[3 * node : 3 * node + 9].reshape(3, 3) for x in (vectors["q"], v))
        found = rotation_quaternion(d.T)
        quaternions.append(found if found @ near >= 0.0 else -found)
        turning.append(0.5 * np.cross(d, d_dot).sum(axis=0))
    signal_rates = mechanism.signal_rates(head["time"])
    scale = section["row_scale"][: mechanism.n_rows]
    residuals = (rows_now(mechanism), row_rates(mechanism, signal_rates))
    x, p = vectors["q"].reshape(-1, dim), (mechanism.M @ mechanism.v).reshape(-1, dim)
    is_point = mechanism.node_kind[: len(x)] == NODE_POINT
    spin = x[:, 0] * p[:, 1] - x[:, 1] * p[:, 0] if dim == 2 else np.cross(x, p)
    force, torque = reactions(mechanism)
    found = {
        "position": vectors["q"],
        "velocity": v,
        "place": u[places],
        "place_velocity": mechanism.U[places] @ v,
        "quantity": sigma,
        "quantity_rate": rates,
        "element_force": [
            k * (sigma[i] - rest) + c * rates[i] - drive
            for i, k, rest, c, drive in zip(mechanism.elements, *numbers, strict=True)
        ],
        "rod_force": 2.0 * mu[: len(mechanism.row_form)]
        * np.linalg.norm(u[mechanism.row_form], axis=1),
        "multiplier": mu,
        "quaternion": quaternions,
        "body_rate": turning,
        "reaction_force": force,
        "reaction_torque": torque,
        "driven_force": at_present(mechanism, "driven_"),
        "energy": energies(mechanism),
        "residual": [np.max(np.abs(x) / scale, initial=0.0) for x in residuals],
        "momentum": p[is_point].sum(axis=0),
        "angular_momentum": spin.sum(axis=0),
    }  # fmt: skip
    return {name: np.ravel(values) for name, values in found.items()}
