"""Motion of random systems in joint coordinates: Pinocchio's M and h, and DOP853 at 1e-12.

M(q) q'' + h(q, q') + A'mu = tau and A q'' = b, by Pinocchio's crba and nonLinearEffects (Carpentier
et al., 2019); rows A are those of drivers, gears, wheels that roll and rods that close loops.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from tests.truth.minimal import dop853
from tests.truth.random_systems import System

Array = NDArray[np.float64]
ACCURACY = 1e-12
MOST_IMPACTS = 20


class Reference:
    """The tree in Pinocchio, and its rows."""

    def __init__(self, system: System) -> None:
        import pinocchio as pin

        self.pin, self.system = pin, system
        self.model = pin.Model()
        self.model.gravity = pin.Motion(system.gravity, np.zeros(3))
        origins: list[Array] = []
        self.joints: list[int] = []
        for link in system.links:
            kind = {
                "revolute": pin.JointModelRevoluteUnaligned,
                "prismatic": pin.JointModelPrismaticUnaligned,
            }[link.kind]
            parent = self.joints[link.parent] if link.parent >= 0 else 0
            origin = origins[link.parent] if link.parent >= 0 else np.zeros(3)
            place = pin.SE3(np.eye(3), link.place - origin)
            joint = self.model.addJoint(parent, kind(link.axis), place, f"j{len(self.joints)}")
            body = pin.Inertia(link.mass, link.centre - link.place, link.inertia)
            self.model.appendBodyToJoint(joint, body, pin.SE3.Identity())
            self.joints.append(joint)
            origins.append(link.place)
        self.frames = [self._frame(i, link.centre, f"c{i}") for i, link in enumerate(system.links)]
        self.ends = [
            (self._frame(a, p, f"a{k}"), self._frame(b, r, f"e{k}"))
            for k, (a, p, b, r) in enumerate(system.rods)
        ]
        self.data = self.model.createData()
        names = {"sin": math.sin, "cos": math.cos}
        self.torques = [eval(f"lambda t: {link.torque}", names) for link in system.links]

    def _frame(self, link: int, place: Array, name: str) -> int:
        """Frame of a place of a link (-1: of the ground) as drawn."""
        pin = self.pin
        joint = self.joints[link] if link >= 0 else 0
        origin = self.system.links[link].place if link >= 0 else np.zeros(3)
        at = pin.SE3(np.eye(3), place - origin)
        return self.model.addFrame(pin.Frame(name, joint, 0, at, pin.FrameType.OP_FRAME))

    def torque(self, t: float, q: Array, v: Array) -> Array:
        """Torques of motors, springs and dampers, (n,)."""
        return np.array(
            [
                torque(t) - link.stiffness * (x - link.free) - link.damping * w
                for torque, link, x, w in zip(self.torques, self.system.links, q, v, strict=True)
            ]
        )

    def rows(self, t: float, q: Array, v: Array) -> tuple[Array, Array]:
        """A and b of A q'' = b."""
        pin, n = self.pin, len(q)
        rows, rhs = [], []
        if self.system.driver:
            i, value = self.system.driver
            rows.append(np.eye(n)[i])
            rhs.append(second_rate(value, t))
        if self.system.gear:
            i, k, ratio = self.system.gear
            rows.append(np.eye(n)[k] - ratio * np.eye(n)[i])
            rhs.append(0.0)
        if self.ends:
            pin.forwardKinematics(self.model, self.data, q, v, np.zeros(n))
            pin.computeJointJacobians(self.model, self.data, q)
            pin.updateFramePlacements(self.model, self.data)
        for ends in self.ends:
            a, b = (self.data.oMf[x].translation for x in ends)
            ja, jb = (
                pin.getFrameJacobian(self.model, self.data, x, pin.LOCAL_WORLD_ALIGNED)[:3]
                for x in ends
            )
            biases = [
                pin.getFrameClassicalAcceleration(
                    self.model, self.data, x, pin.LOCAL_WORLD_ALIGNED
                ).linear
                for x in ends
            ]
            across, rate = a - b, (ja - jb) @ v
            rows.append(across @ (ja - jb))
            rhs.append(-rate @ rate - across @ (biases[0] - biases[1]))
        return np.array(rows).reshape(-1, n), np.array(rhs)

    def accelerations(self, t: float, q: Array, v: Array) -> Array:
        """Q'' of the rates q' = v."""
        pin, n = self.pin, len(q)
        A, b = self.rows(t, q, v)
        M = pin.crba(self.model, self.data, q).copy()
        M = np.triu(M) + np.triu(M, 1).T
        f = self.torque(t, q, v) - pin.nonLinearEffects(self.model, self.data, q, v)
        K = np.block([[M, A.T], [A, np.zeros((len(A), len(A)))]])
        return np.linalg.solve(K, np.concatenate([f, b]))[:n]

    def allowed(self, q: Array, v: Array) -> Array:
        """Rates nearest to v in the metric of the kinetic energy that rods allow."""
        if not self.ends:
            return v
        A, _ = self.rows(0.0, q, v)
        M = self.pin.crba(self.model, self.data, q).copy()
        M = np.triu(M) + np.triu(M, 1).T
        X = np.linalg.solve(M, A.T)
        return v - X @ np.linalg.solve(A @ X, A @ v)

    def places(self, q: Array, v: Array) -> list[tuple[Array, Array, Array]]:
        """Of each link: mass centre, its velocity, angular velocity (3,) each."""
        pin = self.pin
        pin.forwardKinematics(self.model, self.data, q, v)
        pin.updateFramePlacements(self.model, self.data)
        found = []
        for frame in self.frames:
            twist = pin.getFrameVelocity(self.model, self.data, frame, pin.LOCAL_WORLD_ALIGNED)
            found.append((self.data.oMf[frame].translation.copy(), twist.linear, twist.angular))
        return found

    def start(self) -> tuple[Array, Array]:
        """Coordinates and rates of the drawing."""
        q = np.zeros(len(self.joints))
        return q, self.allowed(q, np.array([link.rate for link in self.system.links]))

    def motion(self, times: Array) -> tuple[Array, Array]:
        """Coordinates and rates (len(times), n) at the times, of which the first is 0."""
        q, v = self.start()
        n = len(q)
        y, t0 = np.concatenate([q, v]), 0.0
        rows, impacts = [y], 0
        breaks = [*self.system.jumps, float(times[-1])]

        def rates(t: float, y: Array) -> Array:
            inside = min(max(t, t0 + 1e-13), end - 1e-13)
            return np.concatenate([y[n:], self.accelerations(inside, y[:n], y[n:])])

        def gap(_: float, y: Array) -> float:
            return self.system.stop[1] - y[self.system.stop[0]] if self.system.stop else 1.0

        gap.terminal, gap.direction = True, -1.0  # type: ignore[attr-defined]
        for end in breaks:
            while t0 < end:
                wanted = [t for t in times if t0 < t <= end]
                found = dop853(
                    rates, (t0, end), y, ACCURACY,
                    t_eval=sorted({*wanted, end}), events=gap if self.system.stop else None,
                )  # fmt: skip
                hits = found.t_events[0] if self.system.stop else []
                reached = hits[0] if len(hits) else end
                columns = dict(zip(found.t, np.array(found.y).T, strict=True))
                rows += [columns[t] for t in wanted if t <= reached and t in columns]
                t0, y = (reached, found.y_events[0][0]) if len(hits) else (end, columns[end])
                if len(hits):
                    y = self._after_impact(y)
                    impacts += 1
                    assert impacts < MOST_IMPACTS, "it comes to rest at its stop"
        table = np.array(rows)
        return table[:, :n], table[:, n:]

    def _after_impact(self, y: Array) -> Array:
        """State after the stop has hit: Newton's law with the joint's restitution."""
        assert self.system.stop
        i, _, restitution = self.system.stop
        n = len(y) // 2
        q, v = y[:n], y[n:].copy()
        M = self.pin.crba(self.model, self.data, q).copy()
        column = np.linalg.solve(np.triu(M) + np.triu(M, 1).T, np.eye(n)[i])
        v -= (1 + restitution) * v[i] / column[i] * column
        return np.concatenate([q, v])


def second_rate(value: str, t: float) -> float:
    """Second derivative of a driver r*t + s*sin(w*t)**2, in closed form."""
    _, _, rest = value.partition("+ ")
    size, _, inner = rest.partition("*sin(")
    w = float(inner.partition("*t")[0])
    return float(size) * 2 * w**2 * math.cos(2 * w * t)


def body_rates(system: System) -> list[tuple[Array, Array]]:
    """Velocity of the mass centre and angular velocity of each link at the start, by kinematics."""
    reference = Reference(system)
    return [(velocity, omega) for _, velocity, omega in reference.places(*reference.start())]


def right_values(system: System, times: Array) -> dict[str, Array]:
    """Right values at the times by name of variable."""
    reference = Reference(system)
    q, v = reference.motion(times)
    found = [reference.places(*x) for x in zip(q, v, strict=True)]
    axes = "xy" if system.planar else "xyz"
    values: dict[str, Array] = {}
    for i in range(len(system.links)):
        if system.kind == "rolling" and i == 0:
            continue
        for k, axis in enumerate(axes):
            values[f"b{i}.{axis}"] = np.array([row[i][0][k] for row in found])
            values[f"b{i}.v{axis}"] = np.array([row[i][1][k] for row in found])
            if not system.planar:
                values[f"b{i}.w{axis}"] = np.array([row[i][2][k] for row in found])
        if system.planar:
            values[f"b{i}.angular_velocity"] = np.array([row[i][2][2] for row in found])
    return values
