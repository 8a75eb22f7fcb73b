"""Forms s(q) = u . w as dense matrices, in exact arithmetic and over a step.

Links are u = U q + u_s, w = W q + w_s, where u_s and w_s come from fixed nodes, so that

    ds/dq = u' W + w' U,      d2s/dq2 = H = U' W + W' U.

U and W hold +1 and -1 for the link between two points, so that links are differences and lose no
digits far from the origin. In the plane an entry may also turn its node by a quarter, J X.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from ..model import Model

Array = NDArray[np.float64]

SQUARE, LINEAR, TURNED = 1, 2, 4
"""Flags of a form's kind: w = u; w does not move; some entries turn their node."""

QUARTER = np.array([[0.0, -1.0], [1.0, 0.0]])
"""J: the quarter turn of the plane."""


def dot(a: Array, b: Array) -> float:
    """Sum of products, term by term, so that equal links give equal bits everywhere."""
    return float(sum(x * y for x, y in zip(a, b, strict=True)))


def exact_sum(fixed: Array, matrix: Array, x: Sequence[Fraction]) -> list[Fraction]:
    """Link fixed + matrix x without rounding."""
    rows = (sum(Fraction(a) * b for a, b in zip(row, x, strict=True) if a) for row in matrix)
    return [Fraction(constant) + row for constant, row in zip(fixed, rows, strict=True)]


class Forms:
    """All forms of a model: U, W (n_forms, dim, n), u_s, w_s (n_forms, dim).

    Parameters
    ----------
    model : Model
    section : mapping of str to ndarray
        Sections of the vector of numbers.
    """

    def __init__(self, model: Model, section: dict[str, Array]) -> None:
        sizes, tables = model.sizes, model.tables
        dim, count = sizes["dim"], sizes["n_forms"]
        n_moving = sizes["n_free"] + sizes["n_driven"]
        self.U, self.u_s = np.zeros((count, dim, dim * n_moving)), np.zeros((count, dim))
        self.W, self.w_s = np.zeros_like(self.U), np.zeros_like(self.u_s)
        support = section["support"].reshape(-1, dim)
        for form, kind in enumerate(tables["form_kind"]):
            for entry in range(*tables["form_ptr"][form : form + 2]):
                node = tables["form_node"][entry]
                for name, matrix, fixed in (
                    ("alpha", self.U[form], self.u_s[form]),
                    ("beta", self.W[form], self.w_s[form]),
                ):
                    block = section[name][entry] * np.eye(dim)
                    if kind & TURNED:
                        block = block + section[f"{name}_turn"][entry] * QUARTER
                    if node < n_moving:
                        matrix[:, dim * node : dim * (node + 1)] += block
                    else:
                        fixed += block @ support[node - n_moving]
            if kind & SQUARE:
                self.W[form], self.w_s[form] = self.U[form], self.u_s[form]

    def links(self, q: Array, q_low: Array) -> tuple[Array, Array]:
        """Links u, w (n_forms, dim) at the configuration q + q_low."""
        u = self.U @ q + self.u_s + self.U @ q_low
        w = self.W @ q + self.w_s + self.W @ q_low
        return u, w

    def gradients(self, u: Array, w: Array) -> Array:
        """Gradients ds/dq (n_forms, n) for given links."""
        return np.einsum("fd,fdn->fn", u, self.W) + np.einsum("fd,fdn->fn", w, self.U)

    def curvature(self, g: Array) -> Array:
        """Sum of g_f H_f, shape (n, n)."""
        used = np.flatnonzero(g)
        weighted = np.einsum("f,fdi,fdj->ij", g[used], self.U[used], self.W[used])
        return weighted + weighted.T

    def exact_link(self, form: int, x: Sequence[Fraction]) -> list[Fraction]:
        """Link u of a form at coordinates x (n,), without rounding."""
        return exact_sum(self.u_s[form], self.U[form], x)

    def exact(self, form: int, x: Sequence[Fraction]) -> Fraction:
        """Value s = u . w of a form at coordinates x (n,), without rounding."""
        u, w = self.exact_link(form, x), exact_sum(self.w_s[form], self.W[form], x)
        return sum((a * b for a, b in zip(u, w, strict=True)), Fraction(0))


def exact_coordinates(q: Array, q_low: Array) -> list[Fraction]:
    """Coordinates q + q_low without rounding."""
    return [Fraction(high) + Fraction(low) for high, low in zip(q, q_low, strict=True)]
