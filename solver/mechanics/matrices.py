"""A model as dense matrices: masses, rows, energies and forces as functions of all coordinates.

Forms are s = u . w with links u = U q + u_0, w = W q + w_0. Quantities are forms, lengths sqrt(s)
and angles; formulas are functions of quantities (theory 9). It is for what may be slow and must be
readable, such as `solver.paper`; the core has code of its own.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import leaf_symbol
from solver.runtime import Integrator, Model, OptionError
from solver.runtime.layout import (
    CODES,
    FORM_SQUARE,
    FORM_TURNED,
    LEAF_SIGNAL,
    OFFSETS,
    QUANTITY_ANGLE,
    QUANTITY_LENGTH,
)
from solver.scene import Number, evaluate
from solver.scene.expression import FUNCTIONS, INFIX, Curve, operate

Array = NDArray[np.float64]
Pair = Callable[[Array], tuple[Array, Array]]
"""Values (m,) of functions of the coordinates q (n,), and their gradients (m, n)."""
Formula = tuple[list[int], Number, list[Number], list[list[Number]]]
"""Quantities that are its leaves, its value, first and second derivatives in these."""

QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])
TURN = 2.0 * np.pi
SUBTRACT = CODES.index("sub")
LAWS, SIGNALS = 1, 2
"""Segments of the tape (``solver.mechanics.tape``)."""


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
        Where the model has more than constraints, drivers, springs, dampers, weights, and forces
        and moments that know the time alone; each sentence names a part.
    """

    def __init__(self, integrator: Integrator) -> None:
        model, numbers = integrator.model, np.array(integrator.numbers)
        ends = [*list(model.offsets.values())[1:], len(numbers)]
        self._section = {
            name: numbers[model.offsets[name] : end]
            for name, end in zip(OFFSETS, ends, strict=True)
        }
        self._tables, self._numbers, self._dim = model.tables, numbers, model.sizes["dim"]
        self._run_tape, self._sizes = integrator.tape(numbers.ctypes.data), model.sizes
        state = {name: np.array(x) for name, x in integrator.state.vectors.items()}
        self.q, self.v = state["q"], state["v"]
        self.sigma = state["derived"][2 + len(model.rows) :]
        kinds = np.array(model.tables["quantity_kind"], dtype=np.int64)
        self._is_angle = kinds == QUANTITY_ANGLE
        self._angles = TURN * state["turns"]
        pieces = [self._rows_of("leaf", 4)[a:b] for a, b in pairwise(self._tables["leaf_ptr"])]
        leaves = [[leaf[1] for leaf in piece if leaf[0] != LEAF_SIGNAL] for piece in pieces]
        count, rows = model.sizes["n_elements"], model.sizes["n_function_rows"]
        self._elements = [quantity for (quantity,) in leaves[:count]]
        ends = pairwise(self._tables["function_ptr"])
        operations = [self._rows_of("operation", 4)[a:b] for a, b in ends]
        self._driven = {}  # by function row, the signal that its quantity follows
        for j, piece in enumerate(pieces[count : count + rows]):
            kinds = [leaf[0] == LEAF_SIGNAL for leaf in piece]
            if kinds == [False, True] and [x[:3] for x in operations[j]] == [[SUBTRACT, 0, 1]]:
                self._driven[j], operations[j] = piece[1][1], []
        self._refuse(model, pieces[count:])
        self._read_forms(model.sizes["n_free"])
        functions = [*map(self._read_formula, leaves[count:], operations)]
        self._function_rows, self._potentials = functions[:rows], functions[rows:]
        self._stored_start = integrator.state.head["stored_start"]
        self._known: dict[tuple[str, bytes], tuple[Array, Array]] = {}
        self.follow(self.q)
        self._energy_start = float(self.energies(self.q)[0].sum())

    def _refuse(self, model: Model, pieces: list[list[list[int]]]) -> None:
        size, section = model.sizes, self._section
        function = size["n_form_rows"] + size["dim"] * size["n_coincidences"]
        velocity = function + size["n_function_rows"]
        contacts = [function + j - size["n_elements"] for j in self._tables["contact_row"]]
        timed = [
            function + j
            for j, piece in enumerate(pieces)
            if j not in self._driven and any(leaf[0] == LEAF_SIGNAL for leaf in piece)
        ]
        changing = size["time_dependent"] * size["variable_potential"]
        found = {
            "contacts": [model.rows[j].name for j in contacts],
            "rolling and friction": [row.name for row in model.rows[velocity:]],
            "damped contacts": ["a potential"] * bool(np.any(section["depth_damping"])),
            "driven points": ["a point"] * (size["n_driven"] > 0),
            "formulas that move with the time": [model.rows[j].name for j in timed],
            "springs and potentials that change": ["a law of time"] * changing,
            "loads that read the motion": [*model.sampled],
        }
        message = "; ".join(
            f"{', '.join(dict.fromkeys(names))}: the paper's method takes no {what}"
            for what, names in found.items()
            if names
        )
        if message:
            message += "; the core does: leave out 'formulation'"
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
        H = np.einsum("fdm,fdn->fmn", self._U, self._W)
        self._form_hessians = H + H.transpose(0, 2, 1)

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

    def _quantity_hessian(self, k: int, q: Array) -> Array:
        """Second derivatives (n, n) of a quantity."""
        (s, G), H = self._forms(q), self._form_hessians
        a, b = self._rows_of("quantity_form", 2)[k]
        if self._tables["quantity_kind"][k] == QUANTITY_LENGTH:
            length = np.sqrt(s[a])
            return (0.5 * H[a] - np.outer(G[a], G[a]) / (4.0 * s[a])) / length
        if not self._is_angle[k]:
            return H[a]
        x, y, square = s[a], s[b], s[a] ** 2 + s[b] ** 2
        mixed = np.outer(2.0 * (x * G[a] + y * G[b]), x * G[b] - y * G[a])
        return (x * H[b] - y * H[a] - 0.5 * (mixed + mixed.T) / square) / square

    def quantities(self, q: Array) -> tuple[Array, Array]:
        """Likewise, with the angles next to those that `follow` was told."""
        values, gradients = self._once(self._principal, q)
        turns = np.round((self._angles - values) / TURN)
        return np.where(self._is_angle, values + TURN * turns, values), gradients

    def follow(self, q: Array) -> None:
        """Let angles go on from those at q beyond half a turn."""
        self._angles = self.quantities(q)[0]
        self._known.clear()

    def _once(self, function: Pair, q: Array) -> tuple[Array, Array]:
        """Evaluate a function no more than once at each q of a step."""
        key = function.__name__, q.tobytes()
        if key not in self._known:
            self._known[key] = function(q)
        return self._known[key]

    def rows(self, q: Array) -> tuple[Array, Array]:
        """Constraints Phi (r,) at q (n,) and their gradients (r, n); of drivers what they move."""
        return self._once(self._rows, q)

    def _rows(self, q: Array) -> tuple[Array, Array]:
        held, links = list(self._tables["row_form"]), list(self._tables["coincidence_form"])
        s, G = self._forms(q)
        formulas = [self._formula(function, q) for function in self._function_rows]
        u = (self._U[links] @ q + self._u_0[links]).ravel()
        values = s[held] - self._section["row_constant"], u, np.array([f for f, _ in formulas])
        slopes = np.reshape([g for _, g in formulas], (-1, len(q)))
        links_q = self._U[links].reshape(-1, len(q))
        return np.concatenate(values), np.concatenate([G[held], links_q, slopes])

    def row_hessians(self, q: Array) -> Array:
        """Second derivatives (r, n, n) of the constraints at q."""
        n, held = len(q), list(self._tables["row_form"])
        links = np.zeros((self._dim * len(self._tables["coincidence_form"]), n, n))
        formulas = [self._formula_hessian(function, q) for function in self._function_rows]
        return np.concatenate([self._form_hessians[held], links, np.reshape(formulas, (-1, n, n))])

    def signals(self, t: float) -> Array:
        """What each row shall be at time t [s]: 0, or what a driver prescribes."""
        values = np.zeros(len(self.sigma))
        if self._driven:
            self._section["time"][:] = t
            self._run_tape(SIGNALS)
        first = len(values) - len(self._function_rows)
        for row, signal in self._driven.items():
            values[first + row] = self._section["signal"][signal]
        return values

    def energies(self, q: Array) -> tuple[Array, Array]:
        """Energies [J] of the weights, of each spring and of each potential; their gradients."""
        return self._once(self._energies, q)

    def _energies(self, q: Array) -> tuple[Array, Array]:
        if not self._elements and not self._potentials:
            return np.array([-self._weights @ q]), -self._weights[None]
        sigma, G = self.quantities(q)
        G, k = G[self._elements], self._section["stiffness"]
        stretch = sigma[self._elements] - self._section["rest"]
        formulas = [self._formula(function, q) for function in self._potentials]
        values = [-self._weights @ q, *(0.5 * k * stretch**2), *(f for f, _ in formulas)]
        slopes = [-self._weights, *((k * stretch)[:, None] * G), *(g for _, g in formulas)]
        return np.array(values), np.array(slopes)

    def energy_hessians(self, q: Array) -> Array:
        """Second derivatives of the energies at q, shape (count, n, n)."""
        sigma, G = self.quantities(q)
        found = [np.zeros((len(q), len(q)))]
        for e, stiffness, rest in zip(
            self._elements, self._section["stiffness"], self._section["rest"], strict=True
        ):
            bend = (sigma[e] - rest) * self._quantity_hessian(e, q) if stiffness else 0.0
            found.append(stiffness * (np.outer(G[e], G[e]) + bend))
        return np.array([*found, *(self._formula_hessian(f, q) for f in self._potentials)])

    def squares(self, q: Array) -> tuple[Array, Array]:
        """Form on which each of the energies depends alone, and its gradient; else NaN."""
        s, G = self._forms(q)
        return self._of_energies(s), self._of_energies(G)

    def square_hessians(self, q: Array) -> Array:  # noqa: ARG002 - they are constant
        """Second derivatives of these forms, else NaN."""
        return self._of_energies(self._form_hessians)

    def _of_energies(self, part: Array) -> Array:
        first = np.reshape(self._tables["quantity_form"], (-1, 2))[self._elements, 0]
        alone = np.flatnonzero(~self._is_angle[self._elements])
        found = np.full((1 + len(first) + len(self._potentials), *part.shape[1:]), np.nan)
        found[1 + alone] = part[first[alone]]
        return found

    @property
    def has_springs(self) -> bool:
        """Whether any of the energies depends on one form alone."""
        return bool(np.any(self._section["stiffness"]))

    @property
    def has_forces(self) -> bool:
        """Whether there are loads, moments, drives or dampers."""
        kinds = "load", "moment", "body_moment", "drive", "damping"
        numbers = (self._section[name] for name in kinds)
        return self._sizes["time_dependent"] > 0 or any(map(np.any, numbers))

    def forces(self, q: Array, v: Array, t: float) -> Array:
        """Forces (n,) of loads, moments and drives at time t [s] and of dampers."""
        if self._sizes["time_dependent"]:
            self._section["time"][:] = t
            self._run_tape(LAWS)
        section, G, tables, dim = self._section, self.quantities(q)[1], self._tables, self._dim
        along = section["drive"] - section["damping"] * (G[self._elements] @ v)
        Q = G[self._elements].T @ along
        for f, a, load in zip(
            tables["load_form"], tables["load_axes"], section["load"].reshape(-1, dim), strict=True
        ):
            Q += self._U[f].T @ (load if a < 0 else load @ self._axes(q, a))
        turning = section["moment"].reshape(-1, 2 * dim - 3)
        for f, moment in zip(tables["moment_form"], turning, strict=True):
            u = self._U[f] @ q + self._u_0[f]  # the moment's force is m x u/u^2
            force = QUARTER @ u * moment if dim == 2 else np.cross(moment, u)
            Q += self._U[f].T @ force / (u @ u)
        ends = zip(
            self._rows_of("body_moment", 2), section["body_moment"].reshape(-1, 3), strict=True
        )
        for (a, turns), moment in ends:  # on directors d_i it is m x d_i/2
            axes = self._axes(q, a)
            force = np.cross(moment @ axes if turns else moment, axes) / 2.0
            Q[3 * a : 3 * a + 9] += force.ravel()
        return Q

    def _axes(self, q: Array, node: int) -> Array:
        """Directors of a body from the node of its first on, shape (dim, dim)."""
        if self._dim == 2:
            return np.array([q[2 * node : 2 * node + 2], QUARTER @ q[2 * node : 2 * node + 2]])
        return q[3 * node : 3 * node + 9].reshape(3, 3)

    def put(
        self, integrator: Integrator, t: float, q: Array, v: Array, mu: Array, stored: float
    ) -> None:
        """Put an integrator at the end of a step that it did not take, so that it tells outputs.

        `stored` [J] is the energy at q in penalties. Work since the last place is booked.
        """
        head, vectors = integrator.state.head, integrator.state.vectors
        state = {name: np.asarray(vector) for name, vector in vectors.items()}
        before, middle = head["time"], 0.5 * (q + state["q"])
        d, between = q - state["q"], 0.5 * (before + t)
        pushed = float(self.forces(middle, 0.0 * d, between) @ d)
        u_n, u_n1 = self.signals(before), self.signals(t)  # which leaves those of t in the section
        head["work"] += pushed - float((u_n1 - u_n) @ mu)
        head["dissipated"] += pushed - float(self.forces(middle, d / (t - before), between) @ d)
        head["stored_start"] = self._stored_start - stored
        change = self.energies(q)[0].sum() - self._energy_start + stored
        sizes = head["energy_reference"], 0.5 * float(v @ self.M @ v), abs(float(change))
        head["energy_reference"] = max(sizes)
        head["mean_time_before"], head["mean_time"] = head["mean_time"], head["time"]
        head["time"] = t
        state["mean_before"][:] = state["mean"]
        state["mean"][:] = 0.5 * (state["mu_first"] + mu)
        state["q"][:], state["v"][:], state["mu_first"][:] = q, v, mu
        state["q_low"][:], state["v_low"][:] = 0.0, 0.0
        state["signal"][:] = self._section["signal"]
        turned = self.quantities(q)[0] - self._principal(q)[0]
        state["turns"][:] = np.round(turned / TURN)
        for j, node in enumerate(self._tables["body_node"] if len(state["quaternion"]) else ()):
            quaternion = state["quaternion"][4 * j : 4 * j + 4]
            quaternion[:] = _quaternion(q[3 * node : 3 * node + 9].reshape(3, 3).T, quaternion)
        integrator.set([], [])  # outputs are measured anew

    def _read_formula(self, leaves: list[int], operations: list[list[int]]) -> Formula:
        known: list[Number] = [leaf_symbol(k) for k in range(len(leaves))]
        names = [*map(str, known)]
        for code, *places in operations:
            name, given = CODES[code], places[: _count(CODES[code])]
            args: list = [known[a] if a >= 0 else float(self._numbers[-1 - a]) for a in given]
            if name.startswith("spline"):
                args.append(Curve(name, self._numbers[-1 - places[1] : -places[2]].tolist()))
            known.append(args[0] if name == "copy" else operate(name, *args))
        slopes = [derivative(known[-1], x) for x in names]
        return leaves, known[-1], slopes, [[derivative(y, x) for x in names] for y in slopes]

    def _formula(self, function: Formula, q: Array) -> tuple[float, Array]:
        """Value of a formula and its gradient (n,)."""
        leaves, value, slopes, _ = function
        values, gradients = (x[leaves] for x in self.quantities(q))
        return _evaluated([value], values)[0], _evaluated(slopes, values) @ gradients

    def _formula_hessian(self, function: Formula, q: Array) -> Array:
        """Second derivatives (n, n) of a formula."""
        leaves, _, slopes, bends = function
        values, G = (x[leaves] for x in self.quantities(q))
        H = G.T @ np.array([_evaluated(row, values) for row in bends]) @ G
        for k, slope in zip(leaves, _evaluated(slopes, values), strict=True):
            H += slope * self._quantity_hessian(k, q)
        return H


def _evaluated(numbers: list[Number], leaves: Array) -> Array:
    known = {str(leaf_symbol(k)): x for k, x in enumerate(leaves.tolist())}
    return np.array([evaluate(number, known) for number in numbers])


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
