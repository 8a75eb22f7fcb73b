"""The measurements that outputs are made of, at the present state."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..layout import measured_sections
from ..model import Model
from .bodies import angular_velocity, directors, quaternion
from .course import Present, quantity_rate
from .energy import kinetic_energy, momentum, potential_change
from .equations import rows_at
from .forces import length
from .laws import elements
from .mechanism import POINT, Mechanism, table
from .slopes import still
from .start import row_rates
from .state import Motion

Array = NDArray[np.float64]

LINK_FORCE, ROW_FORCE, ROW_TORQUE = 0, 1, 2
"""Kinds of what a reaction is made of."""


class Measurement:
    """All that is measured at the present state, by the names of ``layout.measured_sections``.

    `signal_rates` (n_signals,) are those of the prescribed values.
    """

    def __init__(self, mechanism: Mechanism, motion: Motion, signal_rates: Array) -> None:
        self.mechanism, self.motion, self.signal_rates = mechanism, motion, signal_rates
        self.present = Present(mechanism, motion)
        self.mu = motion.at_present("")

    def write(self, model: Model, measured: Array) -> None:
        """Write every section into `measured` (modified)."""
        for name, (start, count) in measured_sections(model.sizes).items():
            measured[start : start + count] = np.ravel(getattr(self, name)())

    def position(self) -> Array:
        """Positions of the nodes [m], directions [1]."""
        return self.motion.q

    def velocity(self) -> Array:
        """Velocities of the nodes [m/s], of directions [1/s]."""
        return self.motion.v

    def place(self) -> Array:
        """Positions of body points [m]."""
        return self.present.u[list(self.mechanism.model.tables["place_form"])]

    def place_velocity(self) -> Array:
        """Velocities of body points [m/s]."""
        places = list(self.mechanism.model.tables["place_form"])
        return self.mechanism.forms.U[places] @ self.motion.v

    def quantity(self) -> Array:
        """Quantities: forms, lengths [m], angles, unwrapped [rad]."""
        return self.present.sigma

    def quantity_rate(self) -> list[float]:
        """Rates of the quantities."""
        s, s_dot = self.present.s, self.present.form_rates(self.motion.v)
        return [quantity_rate(kind, s[f], s_dot[f]) for kind, f in self.mechanism.quantities]

    def element_force(self) -> list[float]:
        """Generalised forces k (sigma - rest) + c dsigma/dt - drive."""
        sigma, rates = self.present.sigma, self.quantity_rate()
        return [
            law.force(still(sigma[law.quantity]), rates[law.quantity])
            for law in elements(self.mechanism)
        ]

    def rod_force(self) -> Array:
        """Forces along the rods [N]: multipliers times |grad Phi|."""
        lengths = [2.0 * length(u) for u in self.present.u[self.mechanism.row_form]]
        return self.mu[: len(lengths)] * np.array(lengths)

    def multiplier(self) -> Array:
        """Multipliers at the present time."""
        return self.mu

    def quaternion(self) -> list[Array]:
        """Orientations of the bodies."""
        nodes = self.mechanism.model.tables["body_node"]
        return [
            quaternion(directors(self.motion.q, node).T, near)
            for node, near in zip(nodes, self.motion.quaternion, strict=True)
        ]

    def body_rate(self) -> list[Array]:
        """Angular velocities of the bodies in global axes [rad/s]."""
        q, v = self.motion.q, self.motion.v
        nodes = self.mechanism.model.tables["body_node"]
        return [angular_velocity(directors(q, node), directors(v, node)) for node in nodes]

    def _reactions(self) -> list[tuple[int, int, Array]]:
        """Reaction, kind and contribution of each entry."""
        mechanism, found = self.mechanism, []
        coincidences = mechanism.row_kinds[1].start
        for reaction, kind, index, sign in table(mechanism.model, "reaction_entry", 4):
            if kind == LINK_FORCE:
                first = coincidences + mechanism.dim * index
                found.append((reaction, kind, sign * self.mu[first : first + mechanism.dim]))
                continue
            form = mechanism.row_form[index]
            u, w, factor = self.present.u[form], self.present.w[form], -sign * self.mu[index]
            if kind == ROW_FORCE:
                found.append((reaction, kind, factor * w))
            elif mechanism.dim == 2:
                found.append((reaction, kind, np.array([factor * (w[0] * u[1] - w[1] * u[0])])))
            else:
                found.append((reaction, kind, factor * np.cross(w, u)))
        return found

    def reaction_force(self) -> Array:
        """Forces of joints on their second bodies [N]."""
        total = np.zeros((self.mechanism.model.sizes["n_reactions"], self.mechanism.dim))
        for reaction, kind, part in self._reactions():
            if kind != ROW_TORQUE:
                total[reaction] += part
        return total

    def reaction_torque(self) -> Array:
        """Torques of joints on their second bodies [N m]."""
        width = 1 if self.mechanism.dim == 2 else 3
        total = np.zeros((self.mechanism.model.sizes["n_reactions"], width))
        for reaction, kind, part in self._reactions():
            if kind == ROW_TORQUE:
                total[reaction] += part
        return total

    def driven_force(self) -> Array:
        """Forces that move the driven nodes [N]."""
        return self.motion.at_present("driven_")

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
        """Largest |Phi| and |dPhi/dt| of the rows over their scales [1, 1/s]."""
        phi = rows_at(self.mechanism, self.motion, self.present)
        rates = row_rates(self.mechanism, self.motion, self.signal_rates)
        scaled = (np.abs(x) / self.mechanism.row_scale for x in (phi, rates))
        return [float(np.max(x, initial=0.0)) for x in scaled]

    def momentum(self) -> Array:
        """Linear momentum [kg m/s]: that of the points."""
        is_point = self.mechanism.node_kind[: self.mechanism.n_moving] == POINT
        return momentum(self.mechanism, self.motion)[is_point].sum(axis=0)

    def angular_momentum(self) -> Array:
        """Angular momentum about the origin [kg m^2/s]: z in the plane, a vector in space."""
        x = self.motion.q.reshape(-1, self.mechanism.dim)
        p = momentum(self.mechanism, self.motion)
        if self.mechanism.dim == 2:
            return np.array([np.sum(x[:, 0] * p[:, 1] - x[:, 1] * p[:, 0])])
        return np.cross(x, p).sum(axis=0)

    def solver(self) -> list[float]:
        """Return iterations, updates, substeps, order, 0 (it measures no sampling), and status."""
        names = ("newton_iterations", "uzawa_iterations", "substeps", "order_in_use")
        return [*(self.motion.head[name] for name in names), 0.0, self.motion.head["status"]]
