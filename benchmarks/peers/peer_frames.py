"""A problem drawn for a code in joint coordinates: frames of bodies, and rates of joints.

Bodies' frames are drawn parallel to the global ones, in the joints that hold the bodies.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from benchmarks.problems.parts import GROUND, Array, Joint, Problem


class Frames:
    """Where the frames of a problem's bodies are."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.origins: dict[str, Array] = {GROUND: np.zeros(3)}
        """Where they are drawn [m], of the bodies that hang."""

    def hang(self, name: str, joint: Joint, parent: str) -> tuple[Array, Array]:
        """Put a body's frame into the joint by which its parent holds it.

        Returns its place in the parent's frame, and that of the body's centre of mass in its own,
        both (3,) in m.
        """
        anchor = np.array(joint.position, dtype=float)
        if joint.kind == "distance" and parent != GROUND:
            anchor = np.array(self.problem.bodies[parent].position)
        self.origins[name] = anchor
        return anchor - self.origins[parent], self.local(name, (0.0, 0.0, 0.0))

    def local(self, name: str, place: tuple[float, ...]) -> Array:
        """Place in a body's frame (3,), given from its centre of mass in its own axes [m]."""
        if name == GROUND:
            return np.array(place, dtype=float)
        body = self.problem.bodies[name]
        return np.array(body.position) + body.attitude @ np.array(place) - self.origins[name]

    def inertia(self, name: str) -> Array:
        """Inertia about the centre of mass in global axes, as xx, yy, zz, xy, xz, yz [kg m^2]."""
        body = self.problem.bodies[name]
        tensor = body.attitude @ np.diag(body.inertia) @ body.attitude.T
        return tensor[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]

    def rates(self, jacobian: Callable[[str], tuple[Array, Array]]) -> Array:
        """Rates of the joints for which all bodies have the velocities of the problem (n,).

        `jacobian` of a body: its angular velocity and the velocity of its centre of mass by the
        rates, both (3, n).
        """
        rows, right = [], []
        for name, body in self.problem.bodies.items():
            turning, moving = jacobian(name)
            rows.append(moving)
            right.append(np.array(body.velocity))
            if not body.is_point:
                rows.append(turning)
                right.append(body.attitude @ np.array(body.omega))
        found, *_ = np.linalg.lstsq(np.concatenate(rows), np.concatenate(right), rcond=None)
        return found
