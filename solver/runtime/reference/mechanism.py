"""A mechanism as dense matrices: mass matrix, quadratic forms, constraint rows and their scaling.

Everything is a function of forms s(q) = u . w with links u = U q + u_s, w = W q + w_s, where u_s
and w_s come from the supports, so that

    ds/dq = u' W + w' U,      d2s/dq2 = H = U' W + W' U.

A constraint row is Phi = s - c. U and W hold +1 and -1 for the link between two points, so that
links are differences and lose no digits far from the origin.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from ..layout import OFFSETS
from ..model import Model

Array = NDArray[np.float64]


def dot(a: Array, b: Array) -> float:
    """Sum of products, term by term, so that equal links give equal bits everywhere."""
    return float(sum(x * y for x, y in zip(a, b, strict=True)))


@dataclass(frozen=True, slots=True, eq=False)
class Form:
    """Form s(q) = u . w of one pair of links; U, W (dim, n), u_s, w_s (dim,), H (n, n)."""

    U: Array
    W: Array
    u_s: Array
    w_s: Array
    H: Array

    def links(self, q: Array, q_low: Array) -> tuple[Array, Array]:
        """Links u, w at the configuration q + q_low."""
        u = self.U @ q + self.u_s + self.U @ q_low
        w = self.W @ q + self.w_s + self.W @ q_low
        return u, w

    def exact(self, x: Sequence[Fraction]) -> Fraction:
        """Value s = u . w at coordinates x (n,), without rounding."""
        u, w = (
            [
                Fraction(fixed)
                + sum(Fraction(a) * b for a, b in zip(row, x, strict=True) if a != 0.0)
                for row, fixed in zip(matrix, support, strict=True)
            ]
            for matrix, support in ((self.U, self.u_s), (self.W, self.w_s))
        )
        return sum((a * b for a, b in zip(u, w, strict=True)), Fraction(0))

    def gradient(self, u: Array, w: Array) -> Array:
        """Gradient ds/dq, shape (n,), for given links."""
        return u @ self.W + w @ self.U


class Mechanism:
    """Matrices of a model with its present numbers; the force laws are views that follow the tape.

    Parameters
    ----------
    model : Model
        Structure.
    numbers : ndarray, shape (n_numbers,)
        Contents, not copied.
    """

    def __init__(self, model: Model, numbers: Array) -> None:
        ends = [*list(model.offsets.values())[1:], len(numbers)]
        section = {
            name: numbers[model.offsets[name] : end]
            for name, end in zip(OFFSETS, ends, strict=True)
        }
        self.section = section
        self.dim = model.sizes["dim"]
        self.n_free = model.sizes["n_free"]
        self.n = self.dim * self.n_free
        self.m_node = np.repeat(section["node_mass"], self.dim)
        """Each coordinate's share of the mass [kg], for norms, weight and scaling of penalties."""
        self.M = self._mass_matrix(model)
        forms = [self._form(model, index) for index in range(model.sizes["n_forms"])]
        tables = model.tables
        self.rows = [forms[index] for index in tables["row_form"]]
        self.lines = [forms[index] for index in tables["line_form"]]
        self.moment_links = [forms[index] for index in tables["moment_form"]]
        self.angle_links = [forms[index] for index in tables["angle_form"]]
        self.load_nodes = list(tables["load_node"])
        self.c = section["row_constant"]
        self.row_scale = section["row_scale"]
        self.sigma = section["row_sigma"]
        """Diagonal of G m^-1 G' at the start, with the nodes' shares of the mass [m^2/kg]."""
        self.gravity = section["gravity"]
        self.stiffness, self.free_length = section["stiffness"], section["free_length"]
        self.damping = section["damping"]
        self.load = section["load"].reshape(-1, self.dim)
        self.moment = section["moment"].reshape(-1, 1 if self.dim == 2 else 3)

    def _mass_matrix(self, model: Model) -> Array:
        """Mass matrix (n, n): each entry between two nodes acts on all their coordinates alike."""
        M = np.zeros((self.n_free, self.n_free))
        nodes = np.asarray(model.tables["mass_node"]).reshape(-1, 2)
        for (a, b), mass in zip(nodes, self.section["mass"], strict=True):
            M[a, b] += mass
        return np.kron(M, np.eye(self.dim)).astype(np.float64)

    def _form(self, model: Model, index: int) -> Form:
        """Form number `index`; its entries say with which factors each node enters u and w."""
        dim, eye = self.dim, np.eye(self.dim)
        U, W = np.zeros((dim, self.n)), np.zeros((dim, self.n))
        u_s, w_s = np.zeros(dim), np.zeros(dim)
        support = self.section["support"].reshape(-1, dim)
        for entry in range(*model.tables["form_ptr"][index : index + 2]):
            node = model.tables["form_node"][entry]
            in_u, in_w = self.section["alpha"][entry], self.section["beta"][entry]
            if node < self.n_free:
                U[:, dim * node : dim * (node + 1)] += in_u * eye
                W[:, dim * node : dim * (node + 1)] += in_w * eye
            else:
                u_s += in_u * support[node - self.n_free]
                w_s += in_w * support[node - self.n_free]
        return Form(U, W, u_s, w_s, U.T @ W + W.T @ U)

    def phi(self, q: Array, q_low: Array) -> Array:
        """Constraint rows Phi(q) [m^2], shape (r,), in exact arithmetic.

        A step would correct the rounding error of Phi by an impulse that grows as 1/h^2.
        """
        x = [Fraction(high) + Fraction(low) for high, low in zip(q, q_low, strict=True)]
        return np.array(
            [float(row.exact(x) - Fraction(c)) for row, c in zip(self.rows, self.c, strict=True)]
        )

    def G(self, q: Array, q_low: Array) -> Array:  # noqa: N802
        """Jacobian of the rows dPhi/dq [m], shape (r, n)."""
        rows = [row.gradient(*row.links(q, q_low)) for row in self.rows]
        return np.reshape(rows, (len(rows), self.n))

    def quadratic(self, x: Array) -> Array:
        """Second-order terms x' H_i x of each row i, shape (r,)."""
        return np.array([x @ row.H @ x for row in self.rows])

    def norm(self, x: Array) -> float:
        """Size of an increment in the mass norm [kg^1/2 m]."""
        return float(np.sqrt(np.sum(self.m_node * x**2)))
