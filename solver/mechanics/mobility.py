"""What a mechanism consists of: coordinates, rows, redundant rows, mobility (theory 9.5).

Kutzbach's mobility is the number of coordinates less that of rows: 6 of each spatial body and 3 of
each planar one, less the constraints of the joints. By rank it is what can really move as drawn,
for rows may depend on each other. Drivers take freedom away afterwards; velocity rows, which are
not holonomic, take it from velocities and not from positions.
"""

from __future__ import annotations

from array import array
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from solver.runtime import Integrator, Model

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

LARGEST_RANKED = 2000
"""Rows up to which the rank is computed: the decomposition is dense."""
SMALL = 1e-9
"""Singular values below this part of the largest count as zero."""
SHARE = 1e-6
"""Least share of a row in a dependence."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Survey:
    """Counts of a mechanism in its drawn configuration.

    Whatever follows from ranks is None for more than `LARGEST_RANKED` rows.
    """

    moving_points: int
    supports: int
    coordinates: int
    rows: int
    redundant_rows: int | None
    redundant_parts: tuple[str, ...] | None
    """Joints and other parts whose rows depend on each other; reactions in them are not unique."""
    mobility_by_count: int
    """Kutzbach's: without drivers, as if no row depended on others."""
    mobility: int | None
    """By rank, without drivers."""
    drivers: int
    """Prescribed motions, one for each coordinate, distance, angle or displacement."""
    degrees_of_freedom: int | None
    """Of positions, with drivers."""
    velocity_freedom: int | None
    """Of velocities, with drivers and velocity rows."""
    forces: dict[str, list[str]]
    """Names of springs, dampers, torques and all other forces, by type."""
    stored_entries: int
    """Entries of the tangent's factors: proportional to the work of a step."""
    islands: int
    """Parts that no mass, row or force joins: each is solved by itself."""


def constraint_jacobian(integrator: Integrator) -> NDArray[np.float64]:
    """Return G at the present configuration: ndarray, shape (n_rows, n), n of all moving nodes.

    Column k is the rate of the rows at unit velocity of coordinate k, less that at rest, which
    signals have. Of velocity rows it is the row of C in C v = 0.
    """
    v = integrator.state.vectors["v"]
    kept = list(v)
    columns = []
    try:
        v[:] = memoryview(array("d", bytes(8 * len(v))))
        rest = np.array(integrator.residuals()[1])
        for k in range(len(v)):
            v[k] = 1.0
            columns.append(np.array(integrator.residuals()[1]) - rest)
            v[k] = 0.0
    finally:
        v[:] = memoryview(array("d", kept))
    return np.array(columns).T.reshape(len(integrator.model.rows), len(v))


def _rank(rows: NDArray[np.float64]) -> int:
    """Rank of rows scaled to unit length; rows of zeros count nothing."""
    size = np.linalg.norm(rows, axis=1)
    kept = rows[size > 0.0] / size[size > 0.0, None]
    return int(np.linalg.matrix_rank(kept, rtol=SMALL)) if kept.size else 0


def _dependent(rows: NDArray[np.float64], names: Sequence[str]) -> tuple[str, ...]:
    """Names of the rows that take part in dependences; a body's own rows are not to blame."""
    size = np.linalg.norm(rows, axis=1, keepdims=True)
    U, values, _ = np.linalg.svd(rows / np.where(size > 0.0, size, 1.0))
    rank = int((values > SMALL * values[0]).sum()) if values.size else 0
    shares = np.linalg.norm(U[:, rank:], axis=1)
    found = (name for name, share in zip(names, shares, strict=True) if share > SHARE)
    return tuple(dict.fromkeys(name for name in found if not name.startswith("body ")))


def is_lasting(model: Model) -> list[bool]:
    """Whether each row always holds; those of contacts and friction come and go."""
    owners = model.tables["row_owner"]
    first = model.sizes["n_rows"] - len(owners)
    return [True] * first + [owner < 0 for owner in owners]


def survey(model: Model) -> Survey:
    """Count what a mechanism consists of, with its default parameters."""
    integrator = Integrator(model, log=lambda _: None)  # what closing moves, a run says
    integrator.initialise()
    sizes = model.sizes
    dim, n_free, n_driven = sizes["dim"], sizes["n_free"], sizes["n_driven"]
    driver = np.array([row.kind == "driver" for row in model.rows], dtype=bool)
    lasting = np.array(is_lasting(model), dtype=bool)
    velocity = np.arange(sizes["n_rows"]) >= sizes["n_rows"] - sizes["n_velocity_rows"]
    driver, velocity = driver[lasting], velocity[lasting]
    names = [row.name for row, lasts in zip(model.rows, lasting, strict=True) if lasts]
    drivers = int(driver.sum()) + dim * n_driven
    n_joint_rows = int((~driver & ~velocity).sum())
    redundant = parts = mobility = freedom = velocity_freedom = None
    if sizes["n_rows"] <= LARGEST_RANKED:
        G = constraint_jacobian(integrator)[lasting]
        free = G[:, : dim * n_free]
        rank = _rank(free)
        redundant = len(names) - rank
        parts = _dependent(free, names) if redundant else ()
        plain = drivers == 0 and not velocity.any()  # then all of them are the same rank
        mobility = dim * (n_free + n_driven) - (rank if plain else _rank(G[~driver & ~velocity]))
        freedom = dim * n_free - (rank if plain else _rank(free[~velocity]))
        velocity_freedom = dim * n_free - rank
    points = [kind == 0 for kind in model.tables["node_kind"]]
    return Survey(
        moving_points=sum(points[: n_free + n_driven]),
        supports=sum(points[n_free + n_driven :]),
        coordinates=dim * n_free,
        rows=len(names),
        redundant_rows=redundant,
        redundant_parts=parts,
        mobility_by_count=dim * (n_free + n_driven) - n_joint_rows,
        mobility=mobility,
        drivers=drivers,
        degrees_of_freedom=freedom,
        velocity_freedom=velocity_freedom,
        forces={
            word: [name for name, kind in model.forces.items() if kind == word]
            for word in dict.fromkeys(model.forces.values())
        },
        stored_entries=sizes["n_lu_values"],
        islands=sizes["n_islands"],
    )
