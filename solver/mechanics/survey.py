"""What a mechanism consists of: coordinates, rows, redundant rows, degrees of freedom."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from solver.runtime import Integrator, Model

if TYPE_CHECKING:
    from numpy.typing import NDArray

LARGEST_RANKED = 2000
"""Rows up to which the rank is computed: the decomposition is dense."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Survey:
    """Counts of a mechanism in its drawn configuration.

    `redundant_rows` and `degrees_of_freedom` are None for more than `LARGEST_RANKED` rows.
    """

    moving_points: int
    supports: int
    coordinates: int
    rows: int
    redundant_rows: int | None
    degrees_of_freedom: int | None
    springs_and_dampers: int
    loads_and_torques: int
    stored_entries: int
    """Entries of the tangent's factors: proportional to the work of a step."""


def constraint_jacobian(integrator: Integrator) -> NDArray[np.float64]:
    """Return G at the present configuration: ndarray, shape (n_rows, n), in m.

    Row i of a form s = u . w is the sum of alpha_e w + beta_e u over its entries e.
    """
    model, numbers = (
        integrator.model,
        np.asarray(memoryview(integrator.engine.numbers).cast("B").cast("d")),
    )
    dim, n_free = model.sizes["dim"], model.sizes["n_free"]
    tables, offsets = model.tables, model.offsets
    support = numbers[offsets["support"] :][: dim * model.sizes["n_support"]].reshape(-1, dim)
    moving = np.asarray(integrator.state.vectors["q"]).reshape(-1, dim)
    nodes = np.vstack([moving, support])
    jacobian = np.zeros((model.sizes["n_rows"], n_free, dim))
    for row, form in enumerate(tables["row_form"]):
        begin, end = tables["form_ptr"][form], tables["form_ptr"][form + 1]
        entry_nodes = np.array(tables["form_node"][begin:end])
        alpha = numbers[offsets["alpha"] + begin : offsets["alpha"] + end]
        beta = numbers[offsets["beta"] + begin : offsets["beta"] + end]
        u, w = alpha @ nodes[entry_nodes], beta @ nodes[entry_nodes]
        for node, a, b in zip(entry_nodes, alpha, beta, strict=True):
            if node < n_free:
                jacobian[row, node] += a * w + b * u
    return jacobian.reshape(len(jacobian), dim * n_free)


def survey(model: Model) -> Survey:
    """Count what a mechanism consists of, with its default parameters.

    The rank of the constraint Jacobian is that of its rows scaled to unit length, with singular
    values below 1e-9 of the largest taken for zero.
    """
    integrator = Integrator(model)
    integrator.initialise()
    sizes = model.sizes
    coordinates, rows = sizes["dim"] * sizes["n_free"], sizes["n_rows"]
    redundant = None
    if rows == 0:
        redundant = 0
    elif rows <= LARGEST_RANKED:
        jacobian = constraint_jacobian(integrator)
        jacobian /= np.linalg.norm(jacobian, axis=1, keepdims=True)
        redundant = rows - int(np.linalg.matrix_rank(jacobian, rtol=1e-9))
    return Survey(
        moving_points=sizes["n_free"],
        supports=sizes["n_support"],
        coordinates=coordinates,
        rows=rows,
        redundant_rows=redundant,
        degrees_of_freedom=None if redundant is None else coordinates - rows + redundant,
        springs_and_dampers=sizes["n_lines"],
        loads_and_torques=sizes["n_loads"] + sizes["n_moments"],
        stored_entries=sizes["n_lu_values"],
    )
