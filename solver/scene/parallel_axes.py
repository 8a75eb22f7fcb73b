"""Axes that are parallel or perpendicular but for the digits they are written with are made so.

A loop whose hinges are parallel, and guides perpendicular to them, moves as in a plane, with
redundant rows. Tilted by as little as 1e-9 rad its rows contradict each other a little further on:
the loop is locked there.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from solver.scene.draft import Draft
from solver.scene.fields import Part
from solver.scene.joints import BodyJoint

ROUNDED, WRITTEN = 1e-12, 2e-6
"""Angle in rad between parallel axes, or missing to a right one, that round-off leaves, and that
six digits of a file leave."""


class Groups:
    """Bodies that joints hold together."""

    def __init__(self) -> None:
        self._next: dict[str | None, str | None] = {}

    def _last_of(self, body: str | None) -> str | None:
        while body in self._next:
            body = self._next[body]
        return body

    def are_one(self, one: str | None, other: str | None) -> bool:
        """Whether these two are held together, or the same."""
        return self._last_of(one) == self._last_of(other)

    def join(self, one: str | None, other: str | None) -> None:
        """Hold two bodies together."""
        if not self.are_one(one, other):
            self._next[self._last_of(one)] = self._last_of(other)


def align_axes(draft: Draft, joints: Mapping[str, Part]) -> dict[str, Any]:
    """Return joints with new axes, by name, and warn of each; axes of parameters stay."""
    of_bodies = {n: j for n, j in joints.items() if isinstance(j, BodyJoint) and j.bodies}
    aligned: dict[str, Any] = {}
    axes: dict[str, list[float]] = {}  # of joints of other directions
    if not _have_loop(of_bodies):
        return aligned
    for name, joint in of_bodies.items():
        if joint.axis is None or len(joint.axis) < 3:
            continue
        numbers = [x for x in joint.axis if isinstance(x, float)]
        if len(numbers) < 3 or not any(numbers):
            continue
        own = [x / math.hypot(*numbers) for x in numbers]
        tilt, side, like = min(
            ((math.dist(own, [side * x for x in axis]), side, like)
             for like, axis in axes.items() for side in (1.0, -1.0)),
            default=(math.inf, 1.0, ""),
        )  # fmt: skip
        word = "parallel"
        if tilt > WRITTEN:
            word, tilt, like, axes[name] = _square(own, axes)
            new = axes[name]
        else:
            new = [side * x for x in axes[like]]
        if tilt > ROUNDED:
            aligned[name] = replace(joint, axis=tuple(new))
            message = f"is {word} to that of joint '{like}' but for {tilt:.3g} rad, and taken as "
            message += f"{word}: that tilt would lock a loop; velocities are made to fit"
            draft.warn(("joints", name, "axis"), message, "write both axes alike, with all digits")
    return aligned


def _square(
    own: list[float], axes: Mapping[str, list[float]]
) -> tuple[str, float, str, list[float]]:
    """Return an axis without what it lacks to right angles, with the largest part and its joint."""
    largest, of = 0.0, ""
    for name, axis in axes.items():
        along = sum(map(operator.mul, own, axis))
        if abs(along) <= WRITTEN:
            own = [x - along * y for x, y in zip(own, axis, strict=True)]
            largest, of = max((largest, of), (abs(along), name))
    return "perpendicular", largest, of, own


def _have_loop(joints: Mapping[str, BodyJoint]) -> bool:
    joined = Groups()
    for joint in joints.values():
        one, other = joint.bodies or (None, None)
        if joined.are_one(one, other):
            return True
        joined.join(one, other)
    return False
