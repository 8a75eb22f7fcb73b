"""Random sets of contacts of rigid bodies that hit, and what any impact of them must obey."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from tests.support.contact.contact_laws import Impact, Laws
from tests.support.mechanisms.problems import Array


@dataclass(frozen=True)
class ContactSet:
    """Contacts with rows G of bodies with masses M that move with velocities v."""

    M: Array
    """Diagonal of the mass matrix, kg and kg m^2."""
    G: Array
    v: Array
    tangents: list[int]
    coefficient: Array
    restitution: Array

    @property
    def W(self) -> Array:  # noqa: N802
        return (self.G / self.M) @ self.G.T

    @property
    def before(self) -> Array:
        return self.G @ self.v

    @property
    def energy(self) -> float:
        return float(self.v @ (self.M * self.v)) / 2.0

    @property
    def first(self) -> list[int]:
        return [0, *np.cumsum(np.add(self.tangents, 1))[:-1].tolist()]

    @property
    def independent(self) -> bool:
        return np.linalg.matrix_rank(self.G) == len(self.G)

    def rows_of(self, contact: int) -> list[int]:
        k = int(self.first[contact])
        return list(range(k, k + 1 + self.tangents[contact]))

    def hit(self, laws: Laws) -> Impact:
        return laws.impact(self.W, self.before, self.tangents, self.coefficient, self.restitution)

    def with_contacts(self, order: list[int]) -> ContactSet:
        """Return the set with these contacts of it, in this order."""
        return replace(
            self,
            G=self.G[[k for i in order for k in self.rows_of(i)]],
            tangents=[self.tangents[i] for i in order],
            coefficient=self.coefficient[order],
            restitution=self.restitution[order],
        )


def random_sets(dimension: int, seed: int, most_contacts: int = 3) -> Iterator[ContactSet]:
    """Yield sets of 1 to 3 contacts of one or two bodies; a part of them rest on each other."""
    chance = np.random.default_rng(seed)
    per_body = 3 if dimension == 2 else 6
    while True:
        bodies, count = int(chance.integers(1, 3)), int(chance.integers(1, most_contacts + 1))
        masses = chance.uniform(0.3, 3.0, bodies)
        M = np.concatenate(
            [
                [m] * dimension + list(m * chance.uniform(0.05, 0.5, per_body - dimension))
                for m in masses
            ]
        )
        G = np.zeros((dimension * count, per_body * bodies))
        for i in range(count):
            axes = np.linalg.qr(chance.standard_normal((dimension, dimension)))[0].T
            pair = chance.permutation(bodies)[: 2 if chance.random() < 0.5 else 1]
            for body, sign in zip(pair, (1.0, -1.0), strict=False):
                arm = chance.uniform(-0.5, 0.5, dimension)
                for a, axis in enumerate(axes):
                    turn = np.atleast_1d(
                        np.cross(arm, axis)
                        if dimension == 3
                        else arm[0] * axis[1] - arm[1] * axis[0]
                    )
                    G[dimension * i + a, per_body * body : per_body * (body + 1)] = (
                        sign * np.concatenate([axis, turn])
                    )
        v = chance.standard_normal(len(M))
        for i in range(count):
            if G[dimension * i] @ v > 0.0:
                G[dimension * i] *= -1.0
        if chance.random() < 0.3 and count > 1:  # one is closed already
            row = G[0]
            v = v - (row @ v) / (row @ (row / M)) * row / M
            for i in range(1, count):
                if G[dimension * i] @ v > 0.0:
                    G[dimension * i] *= -1.0
        strong = chance.random() < 0.5
        friction = [0.05, 0.3, 0.6, 1.0, 1.5] if strong else [0.0, 1e-9, 0.05, 0.3, 0.6, 1.0]
        found = ContactSet(
            M=M,
            G=G,
            v=v,
            tangents=[dimension - 1] * count,
            coefficient=chance.choice(friction, count),
            restitution=chance.choice([0.0, 0.3, 0.7, 0.9, 1.0], count),
        )
        if np.min(found.before[found.first]) < -1e-6:
            yield found
