"""A mechanism as dense matrices, at one state: masses, forms, quantities, functions.

Forms are s(q) = u . w with links u = U q + u_s, w = W q + w_s, where u_s and w_s come from fixed
nodes, so that ds/dq = u' W + w' U. Quantities are forms, lengths sqrt(s) and angles atan2(s, c).
Nodes are points and directions: `n_free` coordinates are unknown, those of driven nodes follow.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.runtime import Model
from solver.runtime.layout import (
    CONTACT,
    FORM_SQUARE,
    FORM_TURNED,
    FRICTION,
    FRICTION_MODES,
    NORMAL_SUMS,
    OFFSETS,
    QUANTITY_ANGLE,
    QUANTITY_FORM,
    QUANTITY_LENGTH,
)
from solver.runtime.state import State
from tests.oracle.tape import run_tape

Array = NDArray[np.float64]

QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])
TURN = 2.0 * np.pi
TINY = 1e-30
"""Imaginary step of a derivative: neither truncation nor cancellation."""
OFF, STICKS, SLIDES = map(float, range(len(FRICTION_MODES)))
"""Modes of frictions, as a state has them."""


class Friction(NamedTuple):
    """Rows of slip, and the multipliers whose norms, or negative, add up to the normal force."""

    rows: list[int]
    normals: list[list[int]]
    pushes: bool
    """The normal force is that of a contact, -mu of its gap."""


class Mechanism:
    """Matrices of a model at a state: `head` its scalars, `vectors` its vectors, as copies.

    `forces_at` sets the numbers of forces, `signals` returns prescribed values.
    """

    def __init__(
        self, model: Model, head: Mapping[str, float], vectors: Mapping[str, Array]
    ) -> None:
        self.model, self.head = model, dict(head)
        self.vectors = {name: np.array(vector, dtype=float) for name, vector in vectors.items()}
        self.numbers = np.array(model.numbers)
        ends = [*list(model.offsets.values())[1:], len(self.numbers)]
        self.section = {
            name: self.numbers[model.offsets[name] : end]
            for name, end in zip(OFFSETS, ends, strict=True)
        }
        self._write(self.head["time"])
        run_tape(model, self.numbers, "parameters")
        sides = np.asarray(model.tables["switch_table"], int).reshape(-1, 5)[:, 1]
        self.numbers[sides] = vectors["side"]
        begin = model.offsets["extent"]  # extent, row_scale and row_sigma lie side by side
        self.numbers[begin : begin + len(self.vectors["derived"])] = self.vectors["derived"]
        self._read_structure()
        self.forces_at(self.head["time"], 0.0, 0)

    @classmethod
    def of(cls, model: Model, state: State) -> Mechanism:
        """Mechanism at the present state of a run."""
        return cls(model, state.head, {n: np.asarray(v) for n, v in state.vectors.items()})

    def _table(self, name: str, width: int = 1) -> NDArray[np.int_]:
        table = np.array(self.model.tables[name], dtype=int)
        return table.reshape(-1, width) if width > 1 else table

    def _read_structure(self) -> None:
        sizes, section = self.model.sizes, self.section
        self.dim, self.n_rows = sizes["dim"], sizes["n_rows"]
        moving = sizes["n_free"] + sizes["n_driven"]
        self.n, self.n_free = self.dim * moving, self.dim * sizes["n_free"]
        self.node_kind = self._table("node_kind")
        self.m_node = np.repeat(section["node_mass"], self.dim)
        self.M = self.mass_matrix(section["mass"])
        weights = np.repeat(section["node_weight"], self.dim)
        self.weight = weights * np.tile(section["gravity"], moving)
        self._read_forms(moving)
        self.row_form = self._table("row_form")
        self.coincidence_form = self._table("coincidence_form")
        pairs = zip(self._table("quantity_kind"), self._table("quantity_form", 2), strict=True)
        self.quantities = [(int(kind), [f for f in forms if f >= 0]) for kind, forms in pairs]
        leaves = [
            self._table("leaf", 4)[a:b, :2].tolist()
            for a, b in pairwise(self.model.tables["leaf_ptr"])
        ]
        operations = [
            self._table("operation", 4)[a:b] for a, b in pairwise(self.model.tables["function_ptr"])
        ]
        count = sizes["n_elements"]
        self.elements = [leaf[0][1] for leaf in leaves[:count]]
        functions = list(zip(leaves[count:], operations, strict=True))
        first, second = sizes["n_function_rows"], sizes["n_velocity_rows"]
        self.function_rows = functions[:first]
        self.velocity_rows = functions[first : first + second]
        self.potentials = functions[first + second :]
        kinds = sizes["n_form_rows"], self.dim * sizes["n_coincidences"], first, second
        ends = np.cumsum([0, *kinds]).tolist()
        self.row_kinds = [slice(*piece) for piece in pairwise(ends)]
        """Form rows, coincidences, function rows and velocity rows among all rows."""
        self.rigidity = slice(kinds[0] - sizes["n_rigidity_rows"], kinds[0])
        """Rows that keep bodies rigid."""

        self._read_contacts(self.row_kinds[2].start - count)

    def _read_contacts(self, first: int) -> None:
        """Rows of contacts and frictions; composite j has the row first + j."""
        tables = self.model.tables
        self.contacts = [
            (first + j, f if f >= 0 else None)
            for j, f in zip(tables["contact_row"], tables["contact_friction"], strict=True)
        ]
        slips, normals = np.array(tables["friction_row"]), self._table("normal_row", 2)
        continues, pushes = NORMAL_SUMS.index("continues"), NORMAL_SUMS.index("pushes")
        self.frictions: list[Friction] = []
        for (a, b), (c, d) in zip(
            pairwise(tables["friction_row_ptr"]), pairwise(tables["normal_ptr"]), strict=True
        ):
            groups: list[list[int]] = []
            for row, how in normals[c:d].tolist():
                groups += [] if how == continues else [[]]
                groups[-1].append(row)
            rows = (first + slips[a:b]).tolist()
            self.frictions.append(Friction(rows, groups, bool(normals[c, 1] == pushes)))
        owned = [row for row, _ in self.contacts] + [r for f in self.frictions for r in f.rows]
        self.bilateral = np.ones(self.n_rows, dtype=bool)
        self.bilateral[owned] = False

    def _read_forms(self, moving: int) -> None:
        tables, dim = self.model.tables, self.dim
        count = self.model.sizes["n_forms"]
        self.U, self.u_s = np.zeros((count, dim, self.n)), np.zeros((count, dim))
        self.W, self.w_s = np.zeros_like(self.U), np.zeros_like(self.u_s)
        support = self.section["support"].reshape(-1, dim)
        for form, kind in enumerate(tables["form_kind"]):
            for entry in range(*tables["form_ptr"][form : form + 2]):
                node = tables["form_node"][entry]
                for name, matrix, fixed in (
                    ("alpha", self.U[form], self.u_s[form]),
                    ("beta", self.W[form], self.w_s[form]),
                ):
                    block = self.section[name][entry] * np.eye(dim)
                    if kind & FORM_TURNED:
                        block = block + self.section[f"{name}_turn"][entry] * QUARTER
                    if node < moving:
                        matrix[:, dim * node : dim * (node + 1)] += block
                    else:
                        fixed += block @ support[node - moving]
            if kind & FORM_SQUARE:
                self.W[form], self.w_s[form] = self.U[form], self.u_s[form]

    def mass_matrix(self, masses: Array) -> Array:
        """Mass matrix (n, n): each entry between two nodes acts on all their coordinates alike."""
        M = np.zeros((self.n // self.dim, self.n // self.dim))
        np.add.at(M, tuple(self._table("mass_node", 2).T), masses)
        return np.kron(M, np.eye(self.dim))

    # ------------------------------------------------------------------ configuration

    @property
    def x(self) -> Array:
        """Coordinates q with what rounding left over."""
        return self.vectors["q"] + self.vectors["q_low"]

    @property
    def v(self) -> Array:
        """Velocities likewise."""
        return self.vectors["v"] + self.vectors["v_low"]

    def links(self, low: Array | None = None) -> tuple[Array, Array]:
        """Links u, w (n_forms, dim) at q + low; `low` is q_low unless it is given."""
        q, low = self.vectors["q"], self.vectors["q_low"] if low is None else low
        return self.U @ q + self.u_s + self.U @ low, self.W @ q + self.w_s + self.W @ low

    def gradients(self, u: Array, w: Array) -> Array:
        """Gradients ds/dq (n_forms, n) for given links."""
        return np.einsum("fd,fdn->fn", u, self.W) + np.einsum("fd,fdn->fn", w, self.U)

    def quantities_at(self, s: Array) -> Array:
        """Quantities from forms; angles are the principal ones."""
        values = np.zeros(len(self.quantities))
        for index, (kind, f) in enumerate(self.quantities):
            angle = kind == QUANTITY_ANGLE  # + 0.0: no negative zero, whose angle would be -pi
            value = np.arctan2(s[f[-1]] + 0.0, s[f[0]]) if angle else s[f[0]]
            values[index] = np.sqrt(value) if kind == QUANTITY_LENGTH else value
        return values

    def rates_at(self, s: Array, s_dot: Array) -> Array:
        """Rates of the quantities; 0 where a direction is undefined."""
        rates = np.zeros(len(self.quantities))
        for index, (kind, f) in enumerate(self.quantities):
            if kind == QUANTITY_FORM:
                rates[index] = s_dot[f[0]]
            elif kind == QUANTITY_LENGTH and s[f[0]] > 0.0:
                rates[index] = 0.5 * s_dot[f[0]] / np.sqrt(s[f[0]])
            elif kind == QUANTITY_ANGLE and s[f] @ s[f] > 0.0:
                rates[index] = (s[f[0]] * s_dot[f[1]] - s[f[1]] * s_dot[f[0]]) / (s[f] @ s[f])
        return rates

    def exact_rows(self) -> Array:
        """Form rows and coincidences without rounding: errors of Phi enter forces over h^2."""
        pairs = zip(self.vectors["q"], self.vectors["q_low"], strict=True)
        q = [Fraction(high) + Fraction(low) for high, low in pairs]

        def link(fixed: Array, matrix: Array) -> list[Fraction]:
            rows = (sum(Fraction(row[i]) * q[i] for i in np.flatnonzero(row)) for row in matrix)
            return [Fraction(a) + b for a, b in zip(fixed, rows, strict=True)]

        phi = []
        for f, c in zip(self.row_form, self.section["row_constant"], strict=True):
            u, w = link(self.u_s[f], self.U[f]), link(self.w_s[f], self.W[f])
            phi.append(float(sum(a * b for a, b in zip(u, w, strict=True)) - Fraction(c)))
        for f in self.coincidence_form:
            phi.extend(map(float, link(self.u_s[f], self.U[f])))
        return np.array(phi)

    # ------------------------------------------------------------------ what holds

    @property
    def of_contacts(self) -> Array:
        """What the state has of each contact, shape (n_contacts, len(CONTACT)), shared."""
        return self.vectors["contacts"].reshape(-1, len(CONTACT))

    @property
    def of_frictions(self) -> Array:
        """What the state has of each friction, shape (n_frictions, len(FRICTION)), shared."""
        return self.vectors["frictions"].reshape(-1, len(FRICTION))

    def rows_on(self) -> Array:
        """Rows that hold: of contacts while they are closed, of frictions while they stick."""
        on = self.bilateral.copy()
        for (row, _), (closed, *_) in zip(self.contacts, self.of_contacts, strict=True):
            on[row] = closed != 0.0
        for friction, (mode, *_) in zip(self.frictions, self.of_frictions, strict=True):
            on[friction.rows] = mode == STICKS
        return on

    def references(self) -> Array:
        """Gaps (r,) at which the contacts of rows closed; 0 of other rows."""
        values = np.zeros(self.n_rows)
        values[[row for row, _ in self.contacts]] = self.of_contacts[:, CONTACT.index("reference")]
        return values

    def cone(self, f: int, mu: Array, coefficient: str = "sliding") -> float:
        """Friction c N + N_0 of friction f with multipliers mu, as it slides or at most sticks."""
        friction = self.frictions[f]
        normal = sum(np.sqrt(np.sum(mu[group] ** 2)) for group in friction.normals)
        if friction.pushes:
            normal = -mu[friction.normals[0][0]]
        return self.section[coefficient][f] * normal + self.section["preload"][f]

    def sliding_multipliers(self, mu: Array, slip: Array | None = None) -> Array:
        """Multipliers (r,) of the rows that do not hold: (c N + N_0) t where they slide, else 0.

        The direction t is that of the slip (r,) where that has several rates and is not 0, and else
        the one with which it began.
        """
        values = np.zeros(self.n_rows, dtype=np.result_type(mu, 0.0 if slip is None else slip))
        for f, (friction, (mode, *along)) in enumerate(
            zip(self.frictions, self.of_frictions, strict=True)
        ):
            if mode != SLIDES:
                continue
            t, rows = np.array(along[: len(friction.rows)]), friction.rows
            if len(rows) > 1 and slip is not None and np.any(slip[rows]):
                t = slip[rows] / np.sqrt(np.sum(slip[rows] ** 2))
            values[rows] = self.cone(f, mu) * t
        return values

    def cone_slopes(self, mu: Array, slip: Array | None = None) -> Array:
        """Derivatives (r, r) of the sliding multipliers with respect to mu."""
        if not np.any(self.of_frictions[:, 0] == SLIDES):
            return np.zeros((self.n_rows, self.n_rows))
        beside = mu + 1j * TINY * np.eye(self.n_rows)
        return np.array([self.sliding_multipliers(x, slip).imag for x in beside]).T / TINY

    # ------------------------------------------------------------------ numbers that change

    def _write(self, t: float) -> None:
        for name, values in (
            ("input", self.vectors["inputs"]),  # held: no test of the oracle ramps them
            ("parameter", self.vectors["parameters"]),
            ("time", [t]),
        ):
            self.section[name][: len(values)] = values

    def forces_at(self, t: float, h: float, half: int) -> None:
        """Set the numbers of forces for a half step of length h from t, at its middle.

        Sensors tell them the quantities where the middle is foreseen, q + h v/2 + h^2 a/8.
        """
        self._write(t + 0.5 * h)
        sizes = self.model.sizes
        if sizes["sensing"]:
            a = self.vectors[("a_first", "a_second")[half]]
            low = self.vectors["q_low"] + 0.5 * h * self.vectors["v"] + 0.125 * h**2 * a
            u, w = self.links(low)
            s, v = np.sum(u * w, axis=1), self.vectors["v"] + 0.5 * h * a
            value, now = self.quantities_at(s), self.sigma()
            angles = np.array([kind == QUANTITY_ANGLE for kind, _ in self.quantities])
            value += np.where(angles, TURN * np.round((now - value) / TURN), 0.0)
            rates = self.rates_at(s, np.sum(u * (self.W @ v) + w * (self.U @ v), axis=1))
            active = slice(sizes["n_active"])
            self.section["sensor"][active] = value[active]
            self.section["sensor_rate"][active] = rates[active]
        run_tape(self.model, self.numbers, "laws")

    def sigma(self) -> Array:
        """Quantities at the present; angles with their full turns."""
        u, w = self.links()
        return self.quantities_at(np.sum(u * w, axis=1)) + TURN * self.vectors["turns"]

    def signals(self, t: float) -> Array:
        """Prescribed values b(t), shape (n_signals,)."""
        kept = self.numbers.copy()
        self._write(t)
        run_tape(self.model, self.numbers, "signals")
        values = self.section["signal"][: self.model.sizes["n_signals"]].copy()
        self.numbers[:] = kept
        return values

    def signal_rates(self, t: float) -> Array:
        """Rates b'(t) by forward differences of order 4: what b is before t does not matter."""
        delta = 1e-2 * self.head["step_size"]
        now = self.signals(t)
        b = [self.signals(t + k * delta) - now for k in range(5)]
        return (48.0 * b[1] - 36.0 * b[2] + 16.0 * b[3] - 3.0 * b[4]) / (12.0 * delta)
