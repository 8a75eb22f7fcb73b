"""A model as dense matrices: masses, rows, energies and forces as functions of all coordinates.

Forms are s = u . w with links u = U q + u_0, w = W q + w_0. Quantities are forms, lengths sqrt(s)
and angles; formulas are functions of quantities (theory 9). It is for what may be slow and must be
readable, such as `solver.paper`; the core has code of its own.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from solver.mechanics.derivative import SLOPES
from solver.runtime import Integrator, OptionError
from solver.runtime.layout import (
    CODES,
    FORM_SQUARE,
    FORM_TURNED,
    OFFSETS,
    QUANTITY_ANGLE,
    QUANTITY_LENGTH,
)
from solver.scene.expression import FUNCTIONS, INFIX, Curve, operate

Array = NDArray[np.float64]
Formula = tuple[list[int], list[list[int]]]
"""Quantities that are its leaves, and its operations."""

QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])
TURN = 2.0 * np.pi
LACKING = {
    "unilateral": "contacts and friction", "n_velocity_rows": "rolling", "n_signals": "drivers",
    "time_dependent": "laws of time", "sensing": "loads that read the motion",
}  # fmt: skip
"""What has no matrices here, by the size of a model that counts it."""


class Matrices:
    """The mechanism of an integrator that has been initialised, from where it stands.

    Attributes
    ----------
    q, v : ndarray, shape (n,)
        Coordinates and velocities.
    M : ndarray, shape (n, n)
    sigma : ndarray, shape (r,)
        Diagonal of G M^-1 G' at the start, as the core scales penalties.

    Raises
    ------
    OptionError
        Where the model has more than constraints, springs, dampers, weights and steady loads.
    """

    def __init__(self, integrator: Integrator) -> None:
        model, numbers = integrator.model, np.array(integrator.numbers)
        ends = [*list(model.offsets.values())[1:], len(numbers)]
        self._section = {
            name: numbers[model.offsets[name] : end]
            for name, end in zip(OFFSETS, ends, strict=True)
        }
        self._tables, self._numbers, self._dim = model.tables, numbers, model.sizes["dim"]
        self._refuse(model.sizes)
        state = {name: np.array(x) for name, x in integrator.state.vectors.items()}
        self.q, self.v = state["q"], state["v"]
        self.sigma = state["derived"][2 + len(model.rows) :]
        kinds = np.array(model.tables["quantity_kind"], dtype=np.int64)
        self._is_angle = kinds == QUANTITY_ANGLE
        self._angles = TURN * state["turns"]
        self._read_forms(model.sizes["n_free"])
        pieces = [self._rows_of("leaf", 4)[a:b] for a, b in pairwise(self._tables["leaf_ptr"])]
        leaves = [[leaf[1] for leaf in piece] for piece in pieces]
        count, rows = model.sizes["n_elements"], model.sizes["n_function_rows"]
        self._elements = [quantity for (quantity,) in leaves[:count]]
        ends = pairwise(self._tables["function_ptr"])
        operations = [self._rows_of("operation", 4)[a:b] for a, b in ends]
        functions = list(zip(leaves[count:], operations, strict=True))
        self._function_rows, self._potentials = functions[:rows], functions[rows:]
        self._stored_start = integrator.state.head["stored_start"]
        self.follow(self.q)

    def _refuse(self, sizes: dict[str, int]) -> None:
        found = [text for size, text in LACKING.items() if sizes[size]]
        moments = np.concatenate([self._section["moment"], self._section["body_moment"]])
        if np.any(moments) or max(self._tables["load_axes"], default=-1) >= 0:
            found.append("moments and loads that turn with bodies")
        if found:
            message = f"this method takes no {', no '.join(found)}; the default formulation does"
            raise OptionError(message)

    def _rows_of(self, table: str, width: int) -> list[list[int]]:
        return np.reshape(self._tables[table], (-1, width)).astype(int).tolist()

    def _read_forms(self, n_free: int) -> None:
        tables, section, dim = self._tables, self._section, self._dim
        n = dim * n_free
        fixed = np.concatenate([np.zeros(n), section["support"]])
        links = np.zeros((2, len(tables["form_kind"]), dim, len(fixed)))
        for form, kind in enumerate(tables["form_kind"]):
            for entry in range(*tables["form_ptr"][form : form + 2]):
                place = dim * tables["form_node"][entry]
                for link, name in zip(links[:, form], ("alpha", "beta"), strict=True):
                    block = section[name][entry] * np.eye(dim)
                    if kind & FORM_TURNED:
                        block = block + section[f"{name}_turn"][entry] * QUARTER
                    link[:, place : place + dim] += block
            if kind & FORM_SQUARE:
                links[1, form] = links[0, form]
        (self._U, self._W), (self._u_0, self._w_0) = links[..., :n], links @ fixed
        masses = np.zeros((n_free, n_free))
        np.add.at(masses, tuple(np.reshape(tables["mass_node"], (-1, 2)).T), section["mass"])
        self.M = np.kron(masses, np.eye(dim)).astype(np.float64)
        self._weights = np.multiply.outer(section["node_weight"], section["gravity"]).ravel()
        self._loads = np.zeros(n)
        for form, load in zip(tables["load_form"], section["load"].reshape(-1, dim), strict=True):
            self._loads += self._U[form].T @ load

    def _forms(self, q: Array) -> tuple[Array, Array]:
        """Forms (f,) and their gradients (f, n)."""
        u, w = self._U @ q + self._u_0, self._W @ q + self._w_0
        G = np.einsum("fd,fdn->fn", u, self._W) + np.einsum("fd,fdn->fn", w, self._U)
        return np.sum(u * w, axis=1), G

    def _principal(self, q: Array) -> tuple[Array, Array]:
        """Quantities (k,) and their gradients (k, n), with angles between -pi and pi."""
        s, G = self._forms(q)
        pairs = self._rows_of("quantity_form", 2)
        values, gradients = np.zeros(len(pairs)), np.zeros((len(pairs), len(q)))
        for k, (a, b) in enumerate(pairs):
            values[k], gradients[k] = s[a], G[a]
            if self._tables["quantity_kind"][k] == QUANTITY_LENGTH:
                values[k] = np.sqrt(s[a])
                gradients[k] = 0.5 * G[a] / values[k]
            elif self._is_angle[k]:
                values[k] = np.arctan2(s[b] + 0.0, s[a])  # no negative zero, whose angle is -pi
                gradients[k] = (s[a] * G[b] - s[b] * G[a]) / (s[a] ** 2 + s[b] ** 2)
        return values, gradients

    def quantities(self, q: Array) -> tuple[Array, Array]:
        """Likewise, with the angles next to those that `follow` was told."""
        values, gradients = self._principal(q)
        turns = np.round((self._angles - values) / TURN)
        return np.where(self._is_angle, values + TURN * turns, values), gradients

    def follow(self, q: Array) -> None:
        """Let angles go on from those at q beyond half a turn."""
        self._angles = self.quantities(q)[0]

    def rows(self, q: Array) -> tuple[Array, Array]:
        """Constraints Phi (r,) at q (n,) and their gradients (r, n)."""
        held, links = list(self._tables["row_form"]), list(self._tables["coincidence_form"])
        s, G = self._forms(q)
        formulas = [self._formula(function, q) for function in self._function_rows]
        u = (self._U[links] @ q + self._u_0[links]).ravel()
        values = s[held] - self._section["row_constant"], u, np.array([f for f, _ in formulas])
        slopes = np.reshape([g for _, g in formulas], (-1, len(q)))
        links_q = self._U[links].reshape(-1, len(q))
        return np.concatenate(values), np.concatenate([G[held], links_q, slopes])

    def energies(self, q: Array) -> tuple[Array, Array]:
        """Energies [J] of the weights, of each spring and of each potential; their gradients."""
        sigma, G = self.quantities(q)
        G, k = G[self._elements], self._section["stiffness"]
        stretch = sigma[self._elements] - self._section["rest"]
        formulas = [self._formula(function, q) for function in self._potentials]
        values = [-self._weights @ q, *(0.5 * k * stretch**2), *(f for f, _ in formulas)]
        slopes = [-self._weights, *((k * stretch)[:, None] * G), *(g for _, g in formulas)]
        return np.array(values), np.array(slopes)

    def squares(self, q: Array) -> tuple[Array, Array]:
        """Form on which each of the energies depends alone, and its gradient; else NaN."""
        s, G = self._forms(q)
        first = np.reshape(self._tables["quantity_form"], (-1, 2))[self._elements, 0]
        alone = ~self._is_angle[self._elements]
        count = 1 + len(first) + len(self._potentials)
        values, gradients = np.full(count, np.nan), np.full((count, len(q)), np.nan)
        springs = 1 + np.flatnonzero(alone)
        values[springs], gradients[springs] = s[first[alone]], G[first[alone]]
        return values, gradients

    def forces(self, q: Array, v: Array) -> Array:
        """Forces (n,) of steady loads, drives and dampers."""
        G = self.quantities(q)[1][self._elements]
        return self._loads + G.T @ (self._section["drive"] - self._section["damping"] * (G @ v))

    def put(
        self, integrator: Integrator, t: float, q: Array, v: Array, mu: Array, stored: float
    ) -> None:
        """Put an integrator at the end of a step that it did not take, so that it tells outputs.

        `stored` [J] is the energy at q in penalties. Work since the last place is booked.
        """
        head, vectors = integrator.state.head, integrator.state.vectors
        state = {name: np.asarray(vector) for name, vector in vectors.items()}
        d, middle = q - state["q"], 0.5 * (q + state["q"])
        driven = float(self.forces(middle, 0.0 * d) @ d)
        head["work"] += driven
        head["dissipated"] += driven - float(self.forces(middle, d / (t - head["time"])) @ d)
        head["stored_start"] = self._stored_start - stored
        change = self.energies(q)[0].sum() - self.energies(self.q)[0].sum() + stored
        sizes = head["energy_reference"], 0.5 * float(v @ self.M @ v), abs(float(change))
        head["energy_reference"] = max(sizes)
        head["mean_time_before"], head["mean_time"], head["time"] = (
            head["mean_time"],
            head["time"],
            t,
        )
        state["mean_before"][:] = state["mean"]
        state["mean"][:] = 0.5 * (state["mu_first"] + mu)
        state["q"][:], state["v"][:], state["mu_first"][:] = q, v, mu
        state["q_low"][:], state["v_low"][:] = 0.0, 0.0
        turned = self.quantities(q)[0] - self._principal(q)[0]
        state["turns"][:] = np.round(turned / TURN)
        for j, node in enumerate(self._tables["body_node"] if len(state["quaternion"]) else ()):
            quaternion = state["quaternion"][4 * j : 4 * j + 4]
            quaternion[:] = _quaternion(q[3 * node : 3 * node + 9].reshape(3, 3).T, quaternion)
        integrator.set([], [])  # outputs are measured anew

    def _formula(self, function: Formula, q: Array) -> tuple[float, Array]:
        """Value of a formula and its gradient (n,), by the chain rule."""
        leaves, operations = function
        values, gradients = self.quantities(q)
        known = [(float(values[leaf]), gradients[leaf]) for leaf in leaves]
        for code, *places in operations:
            name, given = CODES[code], places[: _count(CODES[code])]
            numbers = [known[a][0] if a >= 0 else float(self._numbers[-1 - a]) for a in given]
            if name in ("copy", "select"):
                chosen = 0 if name == "copy" else 1 if numbers[0] else 2
                slope = known[given[chosen]][1] if given[chosen] >= 0 else np.zeros(len(q))
                known.append((numbers[chosen], slope))
                continue
            args: list = list(numbers)
            if name.startswith("spline"):
                args.append(Curve(name, self._numbers[-1 - places[1] : -places[2]].tolist()))
            slopes = zip(given, SLOPES.get(name, ()), strict=False)
            parts = [float(slope(*args)) * known[a][1] for a, slope in slopes if a >= 0]  # type: ignore[arg-type]
            known.append((float(operate(name, *args)), sum(parts, np.zeros(len(q)))))  # type: ignore[arg-type]
        return known[-1]


def _quaternion(R: Array, near: Array) -> Array:
    """Quaternion (w, x, y, z) of a rotation, with the sign of one nearby: 4 p p' from R."""
    skew = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    K = np.zeros((4, 4))
    K[0, 0], K[0, 1:], K[1:, 0] = 1.0 + np.trace(R), skew, skew
    K[1:, 1:] = R + R.T + (1.0 - np.trace(R)) * np.eye(3)
    p = K[:, np.argmax(np.diag(K))]  # the largest is a root far from zero
    return np.copysign(1.0, p @ near) * p / np.linalg.norm(p)


def _count(operation: str) -> int:
    """How many arguments an operation has, without its table."""
    if operation == "select":
        return 3
    return 2 if operation in INFIX else FUNCTIONS.get(operation, 1)
