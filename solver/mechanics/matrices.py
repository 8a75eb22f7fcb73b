"""A model as dense matrices: masses, rows, energies and forces as functions of all coordinates.

Forms are s = u . w with links u = U q + u_0, w = W q + w_0. Quantities are forms, lengths sqrt(s)
and angles; formulas are functions of quantities (theory 9). What the time prescribes, a place of a
driven node or a number b(t) in a formula, is a coordinate, and a row asks it to be what it shall:
so rows and energies are functions of q alone. It is for what may be slow and must be readable, such
as `solver.paper`; the core has code of its own.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import leaf_symbol
from solver.runtime import Integrator, Model
from solver.runtime.layout import (
    CODES,
    FORM_SQUARE,
    FORM_TURNED,
    LEAF_SIGNAL,
    OFFSETS,
    QUANTITY_ANGLE,
    QUANTITY_LENGTH,
    SWITCH_LEVEL,
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
LAWS, SIGNALS = 1, 2
"""Segments of the tape (``solver.mechanics.tape``)."""


class Matrices:
    """The mechanism of an integrator that has been initialised, from where it stands.

    Attributes
    ----------
    q, v : ndarray, shape (n,)
        Coordinates and velocities: of free nodes, of driven ones, and numbers that the time
        prescribes, each times a factor that makes it a length like those of the mechanism.
    M : ndarray, shape (n, n)
    sigma : ndarray, shape (r,)
        Diagonal of G M^-1 G' at the start, as the core scales penalties. The last rows, of what is
        prescribed, have the inverse of a mass like that of the mechanism.

    The model has constraints, drivers, springs, dampers, weights, forces and moments, and neither
    contacts nor rows of velocities.
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
        self._n_of_nodes, self._n_rows = len(state["q"]), len(model.rows)
        self._switches = np.reshape(model.tables["switch_table"], (-1, 5))[:, :3].astype(int)
        kinds = np.array(model.tables["quantity_kind"], dtype=np.int64)
        self._is_angle = kinds == QUANTITY_ANGLE
        self._angles = TURN * state["turns"]
        self._given = [model.offsets["signal"] + k for k in range(model.sizes["n_signals"])]
        self._n_driven = self._dim * model.sizes["n_driven"]
        functions = self._read_composites(model)
        self._function_rows = functions[: model.sizes["n_function_rows"]]
        self._potentials = functions[model.sizes["n_function_rows"] :]
        size, mass_size = state["derived"][:2]  # [m, kg^1/2 m]
        size, mass_size = (size, mass_size) if size * mass_size > 0.0 else (1.0, 1.0)
        self._factor = np.ones(len(self._given))
        later, t = slice(self._n_driven, None), integrator.time
        self._factor[later] = size / np.maximum(1.0, np.abs(self._given_at(t)[later]))
        e = 1e-5  # in s: rates are those just after the start
        given = [self._given_at(t + k * e)[later] for k in range(3)]
        rates = (4.0 * given[1] - 3.0 * given[0] - given[2]) / (2.0 * e)
        self.q, self.v = np.append(state["q"], given[0]), np.append(state["v"], rates)
        held = np.full(len(self._given), (size / mass_size) ** 2)
        self.sigma = np.append(state["derived"][2 + self._n_rows :], held)
        self._read_forms()
        self._stored_start = integrator.state.head["stored_start"]
        self._known: dict[tuple[str, bytes], tuple[Array, Array]] = {}
        self.follow(self.q)
        self._energy_start = float(self.energies(self.q)[0].sum())

    def _read_composites(self, model: Model) -> list[Formula]:
        """Return rows and potentials that are formulas, the springs that change among these."""
        count, n_quantities = model.sizes["n_elements"], len(self._is_angle)
        pieces = [self._rows_of("leaf", 4)[a:b] for a, b in pairwise(self._tables["leaf_ptr"])]
        leaves = [
            [leaf[1] + (n_quantities - self._n_driven) * (leaf[0] == LEAF_SIGNAL) for leaf in piece]
            for piece in pieces
        ]
        ends = pairwise(self._tables["function_ptr"])
        operations = [self._rows_of("operation", 4)[a:b] for a, b in ends]
        first = model.sizes["n_tape_parameters"]
        laws = self._rows_of("tape", 5)[first : first + model.sizes["n_tape_laws"]]
        written = {x[1] for x in laws} if model.sizes["time_dependent"] else set()
        self._elements = [quantity for (quantity,) in leaves[:count]]
        self._stiffness = self._section["stiffness"].copy()
        found = [*map(self._read_formula, leaves[count:], operations)]
        for e, quantity in enumerate(self._elements):
            places = [model.offsets[name] + e for name in ("stiffness", "rest")]
            if written.intersection(places):
                self._stiffness[e] = 0.0
                found.append(self._read_spring(quantity, *places))
        return found

    def _rows_of(self, table: str, width: int) -> list[list[int]]:
        return np.reshape(self._tables[table], (-1, width)).astype(int).tolist()

    def _read_forms(self) -> None:
        tables, section, dim = self._tables, self._section, self._dim
        n, n_moving = self._n_of_nodes, self._n_of_nodes // dim
        more = len(self.q) - n
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
        self._u_0, self._w_0 = links @ fixed
        self._U, self._W = np.pad(links[..., :n], ((0, 0),) * 3 + ((0, more),))
        masses = np.zeros((n_moving, n_moving))
        np.add.at(masses, tuple(np.reshape(tables["mass_node"], (-1, 2)).T), section["mass"])
        masses = np.kron(masses, np.eye(dim)).astype(np.float64)
        self.M = np.pad(masses, ((0, more), (0, more)))
        weights = np.multiply.outer(section["node_weight"], section["gravity"]).ravel()
        self._weights = np.pad(weights, (0, more))
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
        if k >= len(self._is_angle):
            return np.zeros((len(q), len(q)))
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
        """Likewise, with the angles next to those that `follow` was told; then prescribed numbers.

        Driven nodes are not among these: forms have them.
        """
        values, gradients = self._once(self._principal, q)
        turns = np.round((self._angles - values) / TURN)
        values = np.where(self._is_angle, values + TURN * turns, values)
        n, factor = self._n_of_nodes, self._factor[self._n_driven :]
        given = np.eye(len(q))[n:] / factor[:, None]
        return np.append(values, q[n:] / factor), np.concatenate([gradients, given])

    def follow(self, q: Array) -> None:
        """Let angles go on from those at q beyond half a turn."""
        self._angles = self.quantities(q)[0][: len(self._is_angle)]
        self._known.clear()

    def _once(self, function: Pair, q: Array) -> tuple[Array, Array]:
        """Evaluate a function no more than once at each q of a step."""
        key = function.__name__, q.tobytes()
        if key not in self._known:
            self._known[key] = function(q)
        return self._known[key]

    def rows(self, q: Array) -> tuple[Array, Array]:
        """Constraints Phi (r,) at q (n,) and their gradients (r, n), then what is prescribed."""
        return self._once(self._rows, q)

    def _rows(self, q: Array) -> tuple[Array, Array]:
        held, links = list(self._tables["row_form"]), list(self._tables["coincidence_form"])
        s, G = self._forms(q)
        formulas = [self._formula(function, q) for function in self._function_rows]
        u = (self._U[links] @ q + self._u_0[links]).ravel()
        values = s[held] - self._section["row_constant"], u, np.array([f for f, _ in formulas])
        slopes = np.reshape([g for _, g in formulas], (-1, len(q)))
        links_q, first = self._U[links].reshape(-1, len(q)), len(q) - len(self._given)
        gradients = G[held], links_q, slopes, np.eye(len(q))[first:]
        return np.concatenate([*values, q[first:]]), np.concatenate(gradients)

    def row_hessians(self, q: Array) -> Array:
        """Second derivatives (r, n, n) of the constraints at q."""
        n, held = len(q), list(self._tables["row_form"])
        links = np.zeros((self._dim * len(self._tables["coincidence_form"]), n, n))
        formulas = [self._formula_hessian(function, q) for function in self._function_rows]
        bends = self._form_hessians[held], links, np.reshape(formulas, (-1, n, n))
        return np.concatenate([*bends, np.zeros((len(self._given), n, n))])

    def signals(self, t: float) -> Array:
        """What each row shall be at time t [s]: 0, or what is prescribed."""
        return np.concatenate([np.zeros(self._n_rows), self._given_at(t)])

    def _given_at(self, t: float) -> Array:
        """Coordinates at time t [s] that it prescribes."""
        if self._sizes["n_signals"]:
            self._evaluate(SIGNALS, t)
        if len(self._given) > self._sizes["n_signals"]:
            self._evaluate(LAWS, t)
        return self._factor * self._numbers[self._given]

    def _evaluate(self, segment: int, t: float) -> None:
        """Evaluate laws or signals at time t [s], on the side of each switch that holds then."""
        self._section["time"][:] = t
        self._run_tape(segment)
        for _ in self._switches:  # a side may decide another
            arguments = self._numbers[self._switches[:, 0]]
            is_level = self._switches[:, 2] == SWITCH_LEVEL
            sides = np.where(is_level, np.floor(arguments), np.sign(arguments))
            if np.array_equal(sides, self._numbers[self._switches[:, 1]]):
                break
            self._numbers[self._switches[:, 1]] = sides
            self._run_tape(segment)

    def energies(self, q: Array) -> tuple[Array, Array]:
        """Energies [J] of the weights, of each spring and of each potential; their gradients."""
        return self._once(self._energies, q)

    def _energies(self, q: Array) -> tuple[Array, Array]:
        if not self._elements and not self._potentials:
            return np.array([-self._weights @ q]), -self._weights[None]
        sigma, G = self.quantities(q)
        G, k = G[self._elements], self._stiffness
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
            self._elements, self._stiffness, self._section["rest"], strict=True
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
        return bool(np.any(self._stiffness))

    @property
    def has_forces(self) -> bool:
        """Whether there are loads, moments, drives or dampers."""
        kinds = "load", "moment", "body_moment", "drive", "damping"
        numbers = (self._section[name] for name in kinds)
        changes = self._sizes["time_dependent"] + self._sizes["sensing"] > 0
        return changes or any(map(np.any, numbers))

    def forces(self, q: Array, v: Array, t: float) -> Array:
        """Forces (n,) of loads, moments and drives at time t [s] and of dampers."""
        return self._loads(q, v, t) + self._damper_forces(q, v)

    def _damper_forces(self, q: Array, v: Array) -> Array:
        G = self.quantities(q)[1][self._elements]
        return -G.T @ (self._section["damping"] * (G @ v))

    def _loads(self, q: Array, v: Array, t: float) -> Array:
        (sigma, G), section = self.quantities(q), self._section
        if self._sizes["sensing"]:
            section["sensor"][:] = sigma[: len(self._is_angle)]
            section["sensor_rate"][:] = (G @ v)[: len(self._is_angle)]
        if self._sizes["time_dependent"] or self._sizes["sensing"]:
            self._evaluate(LAWS, t)
        tables, dim = self._tables, self._dim
        Q = G[self._elements].T @ section["drive"]
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
        n, before, h = self._n_of_nodes, head["time"], t - head["time"]
        d = q - np.concatenate([state["q"], q[n:]])
        middle, slide = q - 0.5 * d, d / h
        pushed = float(self._loads(middle, slide, 0.5 * (before + t)) @ d)
        head["dissipated"] -= float(self._damper_forces(middle, slide) @ d)
        u_n, u_n1 = self.signals(before), self.signals(t)  # the section keeps those of t
        head["work"] += pushed - float((u_n1 - u_n) @ mu)
        mu, held = mu[: self._n_rows], mu[self._n_rows :][: self._n_driven]
        head["stored_start"] = self._stored_start - stored
        change = self.energies(q)[0].sum() - self._energy_start + stored
        sizes = head["energy_reference"], 0.5 * float(v @ self.M @ v), abs(float(change))
        head["energy_reference"] = max(sizes)
        head["mean_time_before"], head["mean_time"] = head["mean_time"], head["time"]
        head["time"] = t
        for kind, last, now in (("", "mu_first", mu), ("driven_", "driven_first", -held)):
            state[f"{kind}mean_before"][:] = state[f"{kind}mean"]
            state[f"{kind}mean"][:] = 0.5 * (state[last] + now)
            state[last][:] = now
        state["q"][:], state["v"][:] = q[:n], v[:n]
        state["q_low"][:], state["v_low"][:] = 0.0, 0.0
        state["signal"][:] = self._section["signal"]
        principal = self._principal(q)[0]
        state["turns"][:] = np.round((self.quantities(q)[0][: len(principal)] - principal) / TURN)
        for j, node in enumerate(self._tables["body_node"] if len(state["quaternion"]) else ()):
            quaternion = state["quaternion"][4 * j : 4 * j + 4]
            quaternion[:] = _quaternion(q[3 * node : 3 * node + 9].reshape(3, 3).T, quaternion)
        integrator.set([], [])  # outputs are measured anew

    def _read_formula(self, leaves: list[int], operations: list[list[int]]) -> Formula:
        known: list[Number] = [leaf_symbol(k) for k in range(len(leaves))]
        for code, *places in operations:
            name, given = CODES[code], places[: _count(CODES[code])]
            args: list = [known[a] if a >= 0 else float(self._numbers[-1 - a]) for a in given]
            if name.startswith("spline"):
                args.append(Curve(name, self._numbers[-1 - places[1] : -places[2]].tolist()))
            known.append(args[0] if name == "copy" else operate(name, *args))
        return _with_derivatives(leaves, known[-1])

    def _read_spring(self, quantity: int, *places: int) -> Formula:
        """Energy of a spring whose stiffness and free length the time prescribes."""
        first = len(self._is_angle) - self._n_driven + len(self._given)
        self._given += places
        stretch = operate("sub", leaf_symbol(0), leaf_symbol(2))
        energy = operate("mul", operate("mul", 0.5, leaf_symbol(1)), operate("pow", stretch, 2.0))
        return _with_derivatives([quantity, first, first + 1], energy)

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


def _with_derivatives(leaves: list[int], value: Number) -> Formula:
    names = [str(leaf_symbol(k)) for k in range(len(leaves))]
    slopes = [derivative(value, x) for x in names]
    return leaves, value, slopes, [[derivative(y, x) for x in names] for y in slopes]


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
