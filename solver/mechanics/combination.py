"""Places and directions of a mechanism as linear combinations of its nodes.

    x = sum_a (c_a + t_a J) X_a,      J = a quarter turn, in the plane only

A place on a rigid body is r + sum xi_i d_i, a link is the difference of two places, a direction of
a planar bar is (X_2 - X_1)/L turned: all of them are such sums, with constant coefficients.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from solver.scene import Number


@dataclass(frozen=True, slots=True)
class Combination:
    """Terms (node, coefficient c, coefficient t of the quarter turn), in the order of nodes."""

    terms: tuple[tuple[int, Number, Number], ...] = ()

    @staticmethod
    def of(terms: Iterable[tuple[int, Number, Number]]) -> Combination:
        """Return the sum of these terms; what vanishes is left out."""
        sums: dict[int, tuple[Number, Number]] = {}
        for node, straight, turn in terms:
            known = sums.get(node, (0.0, 0.0))
            sums[node] = (known[0] + straight, known[1] + turn)
        return Combination(
            tuple((n, c, t) for n, (c, t) in sorted(sums.items()) if not (c == 0.0 and t == 0.0))
        )

    def __add__(self, other: Combination) -> Combination:
        return Combination.of((*self.terms, *other.terms))

    def __sub__(self, other: Combination) -> Combination:
        return Combination.of((*self.terms, *((n, -1.0 * c, -1.0 * t) for n, c, t in other.terms)))

    def scaled(self, factor: Number) -> Combination:
        """Return factor x."""
        return Combination.of((n, factor * c, factor * t) for n, c, t in self.terms)

    def turned(self) -> Combination:
        """Return J x: J (c + t J) = -t + c J."""
        return Combination.of((n, -1.0 * t, c) for n, c, t in self.terms)

    @property
    def nodes(self) -> tuple[int, ...]:
        """Nodes that take part."""
        return tuple([node for node, _, _ in self.terms])

    @property
    def single(self) -> int | None:
        """The node, where the combination is nothing but a node."""
        if len(self.terms) == 1 and self.terms[0][1] == 1.0 and self.terms[0][2] == 0.0:
            return self.terms[0][0]
        return None


def node(index: int) -> Combination:
    """Return the combination that is a node itself."""
    return Combination(((index, 1.0, 0.0),))
