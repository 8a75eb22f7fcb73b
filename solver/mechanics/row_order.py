"""Which nodes can carry a row: those that weigh in its G M^-1 G' as drawn."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from solver.mechanics.structure import Structure

WEAK = 1e-4
"""A node whose share of a row's G M^-1 G' is smaller than this part of the largest carries none."""

Reals = NDArray[np.float64]


class Anchors:
    """Shares of the nodes in the rows of a mechanism, with the default numbers."""

    def __init__(self, structure: Structure) -> None:
        self._structure, mechanism = structure, structure.mechanism
        self._default = mechanism.default
        masses = ((a, self._default(mass)) for a, b, mass in structure.masses if a == b)
        self._masses = {node: mass for node, mass in masses if mass > 0.0}
        self._begin = np.cumsum([0, *map(len, structure.entries)]).tolist()
        entries = [entry for entries in structure.entries for entry in entries]
        self._nodes = [entry.node for entry in entries]
        self._alpha = self._values(x for entry in entries for x in entry.alpha).reshape(-1, 2)
        self._beta = self._values(x for entry in entries for x in entry.beta).reshape(-1, 2)
        with np.errstate(over="ignore", invalid="ignore"):  # checked when numbers are final
            gradients = self._gradients(mechanism.dim)
            self._squares = (gradients**2).sum(axis=1).tolist()
            self._direct = (self._alpha**2).sum(axis=1).tolist()

    def _values(self, numbers: Iterable) -> Reals:
        return np.array([x if type(x) is float else self._default(x) for x in numbers])

    def _gradients(self, dim: int) -> Reals:
        """Gradient of each entry's form with respect to its node: ndarray, shape (entries, dim)."""
        places = self._values(x for node in self._structure.nodes for x in node.position)
        places = places.reshape(-1, dim)[self._nodes]
        counts = np.diff(self._begin)
        form = np.repeat(np.arange(len(counts)), counts)
        u, w = np.zeros((2, len(counts), dim))
        for side, coefficients in ((u, self._alpha), (w, self._beta)):
            straight, turn = coefficients.T[:, :, None]
            np.add.at(side, form, straight * places + (turn * _turned(places) if dim == 2 else 0.0))
        a, a_turn, b, b_turn = np.column_stack([self._alpha, self._beta]).T[:, :, None]
        gradients = a * w[form] + b * u[form]
        if dim == 2:  # the transpose of J is -J
            gradients -= a_turn * _turned(w[form]) + b_turn * _turned(u[form])
        return gradients

    def of_forms(self, forms: Sequence[int]) -> list[int]:
        """Return the nodes that can carry a row made of these forms."""
        return self._heavy(forms, self._squares)

    def of_coincidence(self, form: int) -> list[int]:
        """Return the nodes that can carry the rows link = 0."""
        return self._heavy((form,), self._direct)

    def _heavy(self, forms: Sequence[int], sizes: Sequence[float]) -> list[int]:
        """Free nodes with a share of G M^-1 G' that is not negligible."""
        shares: dict[int, float] = {}
        for form in forms:
            for entry in range(self._begin[form], self._begin[form + 1]):
                node = self._nodes[entry]
                if node < self._structure.n_free:
                    share = sizes[entry] / self._masses.get(node, 1.0)
                    shares[node] = shares.get(node, 0.0) + share
        least = WEAK * max(shares.values(), default=0.0)
        return [node for node, share in shares.items() if share >= least]


def _turned(vectors: Reals) -> Reals:
    """Return the rows turned by a right angle."""
    return np.column_stack([-vectors[:, 1], vectors[:, 0]])
