"""A mechanism as dense matrices: mass matrix, forms, and the tables that say what is made of them.

Nodes are points and directions, `n_free` of them unknown, then `n_driven` prescribed ones: all that
has `n` in its shape covers the coordinates of both; the first `n_free` coordinates are unknown.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ..layout import OFFSETS
from ..model import Model
from .forms import Forms, exact_coordinates

Array = NDArray[np.float64]

POINT, DIRECTION = 0, 1
"""Kinds of a node: a place [m], or a unit vector of a body [1]."""


Integers = NDArray[np.int_]


def pieces(rows: Integers, ends: Sequence[int]) -> list[Integers]:
    """Rows between each two neighbours of `ends`."""
    return [rows[begin:end] for begin, end in pairwise(ends)]


def table(model: Model, name: str, width: int) -> Integers:
    """An integer array of the model in rows of `width`."""
    return np.array(model.tables[name], dtype=int).reshape(-1, width)


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
        self.model, self.numbers = model, numbers
        ends = [*list(model.offsets.values())[1:], len(numbers)]
        self.section = {
            name: numbers[model.offsets[name] : end]
            for name, end in zip(OFFSETS, ends, strict=True)
        }
        section, sizes = self.section, model.sizes
        self.dim = sizes["dim"]
        self.n_moving = sizes["n_free"] + sizes["n_driven"]
        self.n_free = self.dim * sizes["n_free"]
        self.n = self.dim * self.n_moving
        self.node_kind = np.array(model.tables["node_kind"], dtype=int)
        self.m_node = np.repeat(section["node_mass"], self.dim)
        """Each coordinate's share of the mass [kg], for norms and the scaling of penalties."""
        self.weight = np.repeat(section["node_weight"], self.dim)
        """Each coordinate's share of the mass that gravity acts on [kg]."""
        self.weight = self.weight * np.tile(section["gravity"], self.n_moving)
        self.mass_node = table(model, "mass_node", 2)
        self.M = self.mass_matrix(section["mass"])
        self.forms = Forms(model, section)
        self._read_tables(model)
        self.c = section["row_constant"]
        self.row_scale, self.sigma = section["row_scale"], section["row_sigma"]
        self.load = section["load"].reshape(-1, self.dim)
        self.moment = section["moment"].reshape(-1, 1 if self.dim == 2 else 3)
        self.couples = section["body_moment"].reshape(-1, 3)

    @property
    def derived(self) -> Array:
        """What the start tells once and for all: extent (2), row scales and sigma of the rows."""
        start = self.model.offsets["extent"]  # the three sections lie side by side
        return self.numbers[start : start + 2 + 2 * len(self.sigma)]

    def _read_tables(self, model: Model) -> None:
        tables, sizes = model.tables, model.sizes
        self.row_form = np.array(tables["row_form"], dtype=int)
        self.coincidence_form = np.array(tables["coincidence_form"], dtype=int)
        self.quantities = [
            (int(kind), [int(form) for form in forms if form >= 0])
            for kind, forms in zip(
                tables["quantity_kind"], table(model, "quantity_form", 2), strict=True
            )
        ]
        leaves = pieces(table(model, "leaf", 4)[:, :2], tables["leaf_ptr"])
        operations = pieces(table(model, "operation", 4), tables["function_ptr"])
        n_elements, n_rows = sizes["n_elements"], sizes["n_function_rows"]
        self.elements = [int(leaf[0, 1]) for leaf in leaves[:n_elements]]
        functions = list(zip(leaves[n_elements:], operations, strict=True))
        self.function_rows = functions[:n_rows]
        self.velocity_rows = functions[n_rows : n_rows + sizes["n_velocity_rows"]]
        self.potentials = functions[n_rows + sizes["n_velocity_rows"] :]
        self.load_form, self.load_axes = list(tables["load_form"]), list(tables["load_axes"])
        self.moment_form = list(tables["moment_form"])
        self.body_moments = table(model, "body_moment", 2)

    def mass_matrix(self, masses: Array) -> Array:
        """Mass matrix (n, n): each entry between two nodes acts on all their coordinates alike."""
        M = np.zeros((self.n_moving, self.n_moving))
        np.add.at(M, (self.mass_node[:, 0], self.mass_node[:, 1]), masses)
        return np.kron(M, np.eye(self.dim)).astype(np.float64)

    @property
    def row_kinds(self) -> tuple[slice, slice, slice, slice]:
        """Where form rows, coincidences, function rows and velocity rows are among all rows."""
        sizes = self.model.sizes
        counts = (
            sizes["n_form_rows"], self.dim * sizes["n_coincidences"],
            sizes["n_function_rows"], sizes["n_velocity_rows"],
        )  # fmt: skip
        ends = np.cumsum([0, *counts]).tolist()
        form, coincidence, function, velocity = map(slice, ends[:-1], ends[1:])
        return form, coincidence, function, velocity

    @property
    def n_rows(self) -> int:
        """Number of multipliers."""
        return self.model.sizes["n_rows"]

    def quadratic_phi(self, q: Array, q_low: Array) -> Array:
        """Form rows and coincidences Phi(q) in exact arithmetic, shape (r,).

        A step would correct the rounding error of Phi by an impulse that grows as 1/h^2.
        """
        x = exact_coordinates(q, q_low)
        rows = zip(self.row_form, self.c, strict=True)
        phi = [float(self.forms.exact(form, x) - Fraction(c)) for form, c in rows]
        for form in self.coincidence_form:
            phi.extend(float(component) for component in self.forms.exact_link(form, x))
        return np.array(phi, dtype=np.float64)

    @property
    def coincidences(self) -> Array:
        """Gradients of the coincidences, shape (dim n_coincidences, n)."""
        return self.forms.U[self.coincidence_form].reshape(-1, self.n)

    def node(self, index: int) -> slice:
        """Coordinates of a moving node."""
        return slice(self.dim * index, self.dim * (index + 1))

    def norm(self, x: Array) -> float:
        """Size of an increment of the unknown coordinates in the mass norm [kg^1/2 m]."""
        return float(np.sqrt(np.sum(self.m_node[: self.n_free] * x[: self.n_free] ** 2)))
