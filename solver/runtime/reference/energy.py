"""Energies, the ledger of a step, and the measurements that outputs are made of.

    Delta E = work - dissipated - dPhi' mu + v_mid' R

term by term and exactly, for any mu and R (paper, eqs 10 and 17): `defect` and `residual` are what
an unfinished iteration leaves.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ..layout import measured_sections
from ..model import Model
from .equations import penalties
from .forces import couple, elongation, length
from .mechanism import Form, Mechanism, dot
from .state import Motion
from .step import Step

Array = NDArray[np.float64]


def spring_energy(mechanism: Mechanism, motion: Motion) -> float:
    """Energy k (l - l_free)^2/2 of all springs [J]."""
    stretch = np.array([length(form.links(motion.q, motion.q_low)[0]) for form in mechanism.lines])
    return float(np.sum(0.5 * mechanism.stiffness * (stretch - mechanism.free_length) ** 2))


def penalty_energy(mechanism: Mechanism, motion: Motion) -> float:
    """Energy alpha Phi^2/2 that eqs 7, 9 and 11 store in their rows [J]; eq 3 has no potential."""
    if not motion.formulation.endswith("-penalty"):
        return 0.0
    alpha = penalties(mechanism, motion, motion.head["step_size"])
    return float(np.sum(0.5 * alpha * mechanism.phi(motion.q, motion.q_low) ** 2))


def potential_change(mechanism: Mechanism, motion: Motion) -> float:
    """Change of the energy of gravity, springs and penalties since the start [J].

    Weights act on displacements: on positions they would lose the digits by which the mechanism is
    far from the origin.
    """
    weight = mechanism.m_node * np.tile(mechanism.gravity, mechanism.n_free)
    moved = (motion.q - mechanism.section["initial_position"]) + motion.q_low
    stored = spring_energy(mechanism, motion) + penalty_energy(mechanism, motion)
    return math.fsum(-weight * moved) + (stored - motion.head["stored_start"])


def momentum(mechanism: Mechanism, motion: Motion) -> Array:
    """Momenta M v of the nodes, shape (n_free, dim)."""
    return (mechanism.M @ (motion.v + motion.v_low)).reshape(-1, mechanism.dim)


def kinetic_energy(mechanism: Mechanism, motion: Motion) -> float:
    """Energy v' M v/2 [J]."""
    return float(0.5 * np.sum(momentum(mechanism, motion).ravel() * motion.v))


def follow_energy_reference(mechanism: Mechanism, motion: Motion) -> None:
    """Let the reference energy be the largest kinetic energy or change of potential seen so far."""
    change = abs(potential_change(mechanism, motion))
    # A thousandth of what the loads could do over the size of the mechanism.
    load = np.sum(np.linalg.norm(mechanism.load, axis=1)) * mechanism.section["extent"][0]
    floor = 1e-3 * float(load + np.sum(np.abs(mechanism.moment)))
    motion.head["energy_reference"] = max(
        motion.head["energy_reference"], kinetic_energy(mechanism, motion), change, floor
    )


def book_step(step: Step) -> None:
    """Book a solved step in the ledger, before the state takes it over."""
    mechanism, motion, equations, d, h = step.mechanism, step.motion, step.equations, step.d, step.h
    for mu, dphi in zip(step.mu, equations.G_mid(step.w) @ d, strict=True):
        motion.book("defect", mu * dphi)
    for power in d * equations.momentum(step.w, step.mu) / h:
        motion.book("residual", power)
    for node, load in zip(mechanism.load_nodes, mechanism.load, strict=True):
        motion.book("work", float(load @ d[mechanism.dim * node : mechanism.dim * (node + 1)]))
    for form, moment in zip(mechanism.moment_links, mechanism.moment, strict=True):
        u_n = equations.u_n[form]
        f, _ = couple(moment, u_n, form.U @ d)
        motion.book("work", float(f @ form.U @ d))
    for form, damping in zip(mechanism.lines, mechanism.damping, strict=True):
        if damping != 0.0:
            u_n = equations.u_n[form]
            motion.book("dissipated", damping * elongation(u_n, form.U @ d) ** 2 / h)


def crossings(u_n: Array, u_n1: Array) -> float:
    """Full turns that a planar link gains when it crosses the negative x axis, -1, 0 or 1."""
    turn = u_n[0] * u_n1[1] - u_n[1] * u_n1[0]
    if u_n[1] >= 0.0 > u_n1[1] and turn > 0.0:
        return 1.0
    return -1.0 if u_n[1] < 0.0 <= u_n1[1] and turn < 0.0 else 0.0


class Measurement:
    """All that is measured at the present state, by the names of ``layout.measured_sections``."""

    def __init__(self, mechanism: Mechanism, motion: Motion) -> None:
        self.mechanism, self.motion = mechanism, motion

    def write(self, model: Model, measured: Array) -> None:
        """Write every section into `measured` (modified)."""
        for name, (start, count) in measured_sections(model.sizes).items():
            measured[start : start + count] = getattr(self, name)()

    def _link(self, form: Form) -> tuple[Array, Array]:
        """Link u of a form and its velocity."""
        return form.links(self.motion.q, self.motion.q_low)[0], form.U @ self.motion.v

    def position(self) -> Array:
        """Positions of the nodes [m]."""
        return self.motion.q

    def velocity(self) -> Array:
        """Velocities of the nodes [m/s]."""
        return self.motion.v

    def angle(self) -> list[float]:
        """Angles of planar links from the x axis, unwrapped [rad]."""
        links = [self._link(form)[0] for form in self.mechanism.angle_links]
        # + 0.0: no negative zero, whose angle would be -pi
        return [
            float(np.arctan2(u[1] + 0.0, u[0])) + 2.0 * np.pi * turns
            for u, turns in zip(links, self.motion.turns, strict=True)
        ]

    def angular_velocity(self) -> list[float]:
        """Angular velocities of planar links [rad/s]."""
        links = [self._link(form) for form in self.mechanism.angle_links]
        return [(u[0] * v[1] - u[1] * v[0]) / (u @ u) for u, v in links]

    def line_length(self) -> list[float]:
        """Lengths of springs and dampers [m]."""
        return [length(self._link(form)[0]) for form in self.mechanism.lines]

    def line_force(self) -> list[float]:
        """Tensions k (l - l_free) + c dl/dt [N]."""
        forces = []
        for j, form in enumerate(self.mechanism.lines):
            u, u_dot = self._link(form)
            rate = u @ u_dot / length(u) if length(u) > 0.0 else 0.0
            stretch = length(u) - self.mechanism.free_length[j]
            forces.append(self.mechanism.stiffness[j] * stretch + self.mechanism.damping[j] * rate)
        return forces

    def rod_force(self) -> Array:
        """Forces along the rods [N]: multiplier at the present time times |grad Phi|.

        mu is constant over a step and has a component of alternating sign, which the mean of two
        neighbours removes; the line through the last two means leads to the present time.
        """
        head, mean = self.motion.head, self.motion.vectors["mean"]
        gap = head["mean_time"] - head["mean_time_before"]
        ahead = (head["time"] - head["mean_time"]) / gap if 0.0 < gap < math.inf else 0.0
        mu = mean + ahead * (mean - self.motion.vectors["mean_before"])
        return mu * np.array([2.0 * length(self._link(row)[0]) for row in self.mechanism.rows])

    def energy(self) -> list[float]:
        """Kinetic, potential and total energy, work, dissipation, balance [J], relative error."""
        head = self.motion.head
        kinetic = kinetic_energy(self.mechanism, self.motion)
        change = potential_change(self.mechanism, self.motion)
        potential = head["potential_start"] + change
        spent = head["work"] - head["dissipated"]
        balance = (kinetic - head["kinetic_start"]) + change - spent
        reference = head["energy_reference"] if head["energy_reference"] > 0.0 else 1.0
        accounts = [head["work"], head["dissipated"], balance, abs(balance) / reference]
        return [kinetic, potential, kinetic + potential, *accounts]

    def residual(self) -> list[float]:
        """Largest |Phi|/l^2 and |dPhi/dt|/l^2 of the rows [1, 1/s]."""
        q, q_low = self.motion.q, self.motion.q_low
        rates = []
        for row in self.mechanism.rows:
            u, w = row.links(q, q_low)
            rates.append(dot(u, row.W @ self.motion.v) + dot(w, row.U @ self.motion.v))
        scaled = (
            np.abs(x) / self.mechanism.row_scale for x in (self.mechanism.phi(q, q_low), rates)
        )
        return [float(np.max(x, initial=0.0)) for x in scaled]

    def momentum(self) -> Array:
        """Linear momentum [kg m/s]."""
        return momentum(self.mechanism, self.motion).sum(axis=0)

    def angular_momentum(self) -> Array:
        """Angular momentum about the origin [kg m^2/s]: z in the plane, a vector in space."""
        nodes = zip(
            self.motion.q.reshape(-1, self.mechanism.dim),
            momentum(self.mechanism, self.motion),
            strict=True,
        )
        if self.mechanism.dim == 2:
            return np.array([sum(x[0] * p[1] - x[1] * p[0] for x, p in nodes)])
        return np.sum([np.cross(x, p) for x, p in nodes], axis=0)

    def solver(self) -> list[float]:
        """Newton iterations, Uzawa updates, substeps and status of the last communication step."""
        names = ("newton_iterations", "uzawa_iterations", "substeps", "status")
        return [self.motion.head[name] for name in names]
