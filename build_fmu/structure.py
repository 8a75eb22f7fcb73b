"""Counts of a compiled model: coordinates, constraint rows, rank, degrees of freedom.

A row is Phi = s . s - l^2 with the form s = sum_e alpha_e x_e of its nodes, so its part of the
Jacobian at node e is 2 alpha_e s. Rows that depend on others are redundant: accepted, but their
reactions are not unique.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numpy import ndarray

    from solver.runtime import Model

RANK_TOLERANCE = 1e-9
"""Singular values below this, relative to the largest, count as zero."""


@dataclass(frozen=True)
class Structure:
    """Counts at the initial configuration, with the default parameters."""

    dimension: int
    points: int
    fixed_points: int
    bodies: tuple[str, ...]
    joints: tuple[str, ...]
    coordinates: int
    rows: int
    rank: int

    @property
    def redundant_rows(self) -> int:
        """Rows that follow from the others."""
        return self.rows - self.rank

    @property
    def degrees_of_freedom(self) -> int:
        """Directions in which the mechanism can move."""
        return self.coordinates - self.rank


def structure(model: Model) -> Structure:
    """Counts of a model."""
    from numpy.linalg import svd

    singular_values = svd(constraint_jacobian(model), compute_uv=False)
    largest = singular_values.max(initial=0.0)
    labels = [name.partition(" ") for name in dict.fromkeys(model.row_names)]
    sizes = model.sizes
    return Structure(
        dimension=sizes["dim"],
        points=sizes["n_free"],
        fixed_points=sizes["n_support"],
        bodies=tuple(name.strip("'") for kind, _, name in labels if kind == "body"),
        joints=tuple(name.strip("'") for kind, _, name in labels if kind == "joint"),
        coordinates=sizes["dim"] * sizes["n_free"],
        rows=sizes["n_rows"],
        rank=int((singular_values > RANK_TOLERANCE * largest).sum()),
    )


def constraint_jacobian(model: Model) -> ndarray:
    """Jacobian of the rows at the initial configuration, each divided by its length.

    Returns
    -------
    ndarray, shape (rows, coordinates)
    """
    import numpy as np

    from solver.runtime import Integrator

    integrator = Integrator(model)
    integrator.initialise()
    numbers, tables, offsets = np.asarray(integrator.engine.numbers), model.tables, model.offsets
    dim, n_free, n_support = (model.sizes[name] for name in ("dim", "n_free", "n_support"))
    free, support = (
        numbers[offsets[name] :][: dim * count].reshape(count, dim)
        for name, count in (("initial_position", n_free), ("support", n_support))
    )
    places = np.vstack([free, support])
    jacobian = np.zeros((model.sizes["n_rows"], n_free, dim))
    for row, form in enumerate(tables["row_form"]):
        entries = slice(tables["form_ptr"][form], tables["form_ptr"][form + 1])
        nodes = np.asarray(tables["form_node"][entries])
        alphas = numbers[offsets["alpha"] :][entries]
        s = alphas @ places[nodes]
        for node, alpha in zip(nodes, alphas, strict=True):
            if node < n_free:
                jacobian[row, node] += 2.0 * alpha * s / (np.linalg.norm(s) or 1.0)
    return jacobian.reshape(len(jacobian), dim * n_free)
