"""Trees of rigid bodies: the joint that carries each one, in islands without other rows.

A joint makes one place of two bodies, or of a body and the ground, coincide, and keeps up to three
pairs of their directions at right angles. The rows of one joint are independent of each other, and
of those of the rest of a tree; those of a loop, or of other parts, need not be. So islands with
these have no trees here.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field

from solver.mechanics.structure import Structure
from solver.runtime.layout import FORM_AXES

FORTH, BACK = (1.0, 0.0), (-1.0, 0.0)
"""Coefficients of a centre of mass in a coincidence, without a turn."""


@dataclass(frozen=True, slots=True)
class Joint:
    """Bodies that a joint joins, by their numbers, one where it joins a body to the ground."""

    bodies: frozenset[int]
    coincidence: int
    directions: list[int] = field(default_factory=list)
    """Joint rows."""


@dataclass(frozen=True, slots=True)
class CarriedBody:
    """A body of a tree and the joint that carries it, None of a free one.

    `turn` and `place` are the nodes of its first director and its centre of mass; `parent` is the
    first director of the other body of the joint, None of the ground.
    """

    turn: int
    place: int
    joint: Joint | None = None
    parent: int | None = None


def carried_bodies(structure: Structure) -> list[CarriedBody]:
    """Return the bodies of islands whose joints form trees; none in the plane."""
    if structure.mechanism.dim == 2 or not structure.mechanism.rigid:
        return []
    survey = _TreeSearch(structure)
    return [body for island in range(structure.islands.count) for body in survey.of_island(island)]


class _TreeSearch:
    def __init__(self, structure: Structure) -> None:
        self._structure, node_of = structure, structure.node_of
        self._bodies = [[node_of[n] for n in nodes] for nodes in structure.mechanism.rigid]
        self._body_of = {n: k for k, nodes in enumerate(self._bodies) for n in nodes}

    def of_island(self, island: int) -> list[CarriedBody]:
        joints = self._joints(island)
        return [] if joints is None else list(self._forest(joints))

    def _joints(self, island: int) -> list[Joint] | None:
        """Return the joints of an island, or None if it has other rows."""
        structure = self._structure
        found: dict[frozenset[int], Joint] = {}
        for part in (structure.function_rows, structure.velocity_rows):
            if part.begin[island] < part.begin[island + 1]:
                return None
        links = structure.coincidences
        for k in range(links.begin[island], links.begin[island + 1]):
            bodies = self._joined(links.items[k].form)
            if bodies is None or bodies in found:
                return None
            found[bodies] = Joint(bodies, k)
        rows = structure.joint_rows
        for k in range(rows.begin[island], rows.begin[island + 1]):
            form = rows.items[k].form
            joint = found.get(frozenset(self._body_of.get(n, -1) for n in structure.free(form)))
            if joint is None or not structure.kinds[form] & FORM_AXES:
                return None
            if rows.items[k].row.name != links.items[joint.coincidence].row.name:
                return None  # rows of another part may repeat those of the joint
            joint.directions.append(k)
        return list(found.values())

    def _joined(self, form: int) -> frozenset[int] | None:
        """Return the bodies of a coincidence, which are one or two and move as wholes, or None."""
        free = {x.node: x for x in self._structure.entries[form]}
        free = {n: free[n] for n in self._structure.free(form)}
        bodies = frozenset(self._body_of.get(n, -1) for n in free)
        centres = [self._bodies[k][0] for k in bodies if k >= 0]
        if -1 in bodies or not 1 <= len(bodies) <= 2 or not free.keys() >= set(centres):
            return None
        shares = [free[n].alpha for n in centres]
        opposite = shares in ([FORTH, BACK], [BACK, FORTH]) or shares in ([FORTH], [BACK])
        return bodies if opposite else None

    def _forest(self, joints: list[Joint]) -> Iterator[CarriedBody]:
        """Go outwards from the ground, or from the first body; nothing if joints form a loop."""
        joints_of = defaultdict[int | None, list[Joint]](list)
        for joint in joints:
            for body in joint.bodies:
                joints_of[body].append(joint)
            if len(joint.bodies) == 1:
                joints_of[None].append(joint)
        seen = set[int | None]()
        found: list[CarriedBody] = []
        n_joints = 0
        for root in (None, *joints_of):
            if root in seen:
                continue
            seen.add(root)
            if root is not None:
                found.append(self._body(root))
            queue = [root]
            for parent in queue:
                for joint in joints_of[parent]:
                    others = joint.bodies - {parent}
                    if seen.issuperset(others):
                        continue
                    (body,) = others
                    seen.add(body)
                    queue.append(body)
                    n_joints += 1
                    turn = None if parent is None else self._bodies[parent][1]
                    found.append(self._body(body, joint, turn))
        if n_joints == len(joints):
            yield from found

    def _body(
        self, body: int, joint: Joint | None = None, parent: int | None = None
    ) -> CarriedBody:
        place, turn, *_ = self._bodies[body]
        return CarriedBody(turn, place, joint, parent)
