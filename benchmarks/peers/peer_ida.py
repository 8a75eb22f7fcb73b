"""SUNDIALS' IDAS on the constrained equations of planar mechanisms; runs where `casadi` is.

C. W. Gear, B. Leimkuhler, G. K. Gupta, J. CAM 12-13 (1985) 77-90: with multipliers lam of positions
and eta of velocities (index 2)

    q' = v - M^-1 G' eta,   M v' = f - G' lam,   Phi(q, t) = 0,   G v + Phi_t = 0

CasADi (J. A. E. Andersson et al., Math. Prog. Comp. 11 (2019) 1-36) gives IDAS the derivatives.
"""

from __future__ import annotations

import casadi
import numpy as np

from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_methods import SAMPLES, GaveUpError, Method, Observed, too_large
from benchmarks.problems.parts import GROUND, Array, Place, Problem, energies

TOLERANCES = tuple(10.0**-k for k in range(3, 13))


class Equations:
    """A planar problem in places and angles of its bodies (places alone of points)."""

    def __init__(self, problem: Problem) -> None:
        self.problem, self.t = problem, casadi.SX.sym("t")
        self.places: dict[str, slice] = {}
        start, speed, masses, load = [], [], [], []
        for name, body in problem.bodies.items():
            size = 2 if body.is_point else 3
            self.places[name] = slice(len(start), len(start) + size)
            start += [*body.position[:2], body.turn[2]][:size]
            speed += [*body.velocity[:2], body.omega[2]][:size]
            masses += [body.mass, body.mass, body.inertia[2]][:size]
            load += [body.mass * problem.gravity[0], body.mass * problem.gravity[1], 0.0][:size]
        n = len(start)
        self.q, self.v = casadi.SX.sym("q", n), casadi.SX.sym("v", n)
        self.start, self.speed = np.array(start), np.array(speed)
        self.mass, self.load = np.array(masses), np.array(load)

    def place(self, place: Place) -> casadi.SX:
        """Where a place of a body is."""
        name, (x, y, *_) = place
        if name == GROUND:
            return casadi.SX([x, y])
        q = self.q[self.places[name]]
        if q.numel() == 2:
            return q
        c, s = casadi.cos(q[2]), casadi.sin(q[2])
        return q[:2] + casadi.vertcat(c * x - s * y, s * x + c * y)

    def rows(self) -> casadi.SX:
        """Phi(q, t)."""
        rows = []
        for joint in self.problem.joints:
            ends = [self.place((name, self._local(name, joint.position))) for name in joint.pair]
            apart = ends[1] - ends[0]
            if joint.kind == "distance":
                as_drawn = [np.array(self._drawn(name)) for name in joint.pair]
                length2 = float(np.sum((as_drawn[1] - as_drawn[0]) ** 2))
                rows.append(0.5 * (casadi.dot(apart, apart) - length2))
            else:
                rows.append(apart)
        if self.problem.key == "car_axis":
            rows.append(casadi.dot(self.place(("A", (0.0, 0.0))), self._axle()))
        return casadi.vertcat(*rows)

    def _axle(self) -> casadi.SX:
        k = self.problem.data
        y = k["wave"] * casadi.sin(k["omega"] * self.t)
        return casadi.vertcat(casadi.sqrt(k["length"] ** 2 - y**2), y)

    def _drawn(self, name: str) -> tuple[float, ...]:
        return (0.0, 0.0) if name == GROUND else self.problem.bodies[name].position[:2]

    def _local(self, name: str, position: tuple[float, ...]) -> tuple[float, ...]:
        """Place in a body's axes of a position as drawn; the centre of a point."""
        if name == GROUND:
            return position[:2]
        body = self.problem.bodies[name]
        if body.is_point:
            return (0.0, 0.0)
        local = body.attitude.T @ (np.array(position) - np.array(body.position))
        return (float(local[0]), float(local[1]))

    def potential(self) -> casadi.SX:
        """Of springs [J]."""
        total = casadi.SX(0)
        for spring in self.problem.springs:
            apart = self.place(spring.ends[1]) - self.place(spring.ends[0])
            total += 0.5 * spring.stiffness * (casadi.norm_2(apart) - spring.length) ** 2
        if self.problem.key == "car_axis":
            k = self.problem.data
            for foot, end in ((casadi.SX([0, 0]), "A"), (self._axle(), "B")):
                apart = self.place((end, (0.0, 0.0))) - foot
                stretch = casadi.norm_2(apart) - k["free_length"]
                total += 0.5 * k["stiffness"] * stretch**2
        return total

    def force(self) -> casadi.SX:
        """All that acts on the bodies but joints."""
        force = self.load - casadi.gradient(self.potential(), self.q)
        for spring in self.problem.springs:
            if spring.damping:
                apart = self.place(spring.ends[1]) - self.place(spring.ends[0])
                along = casadi.gradient(casadi.norm_2(apart), self.q)
                force -= spring.damping * casadi.dot(along, self.v) * along
        if self.problem.torque:
            name, value = self.problem.torque
            turn = np.zeros(len(self.start))
            turn[self.places[name].stop - 1] = value
            force += turn
        return force

    def system(self) -> dict[str, casadi.SX]:
        """Semi-explicit equations for IDAS."""
        phi = self.rows()
        G = casadi.jacobian(phi, self.q)
        lam, eta = (casadi.SX.sym(name, phi.numel()) for name in ("lam", "eta"))
        drift = G @ self.v + casadi.jacobian(phi, self.t)
        places = self.v - (G.T @ eta) / self.mass
        speeds = (self.force() - G.T @ lam) / self.mass
        return {
            "x": casadi.vertcat(self.q, self.v),
            "z": casadi.vertcat(lam, eta),
            "t": self.t,
            "ode": casadi.vertcat(places, speeds),
            "alg": casadi.vertcat(phi, drift),
        }

    def multipliers(self) -> Array:
        """Those at the start, by the accelerations; eta is zero."""
        phi = self.rows()
        G = casadi.jacobian(phi, self.q)
        drift = G @ self.v + casadi.jacobian(phi, self.t)
        rest = casadi.jacobian(drift, self.q) @ self.v + casadi.jacobian(drift, self.t)
        known = [self.q, self.v, self.t]
        evaluate = casadi.Function("start", known, [G, rest, self.force()])
        g, right, force = (np.array(x) for x in evaluate(self.start, self.speed, 0.0))
        lam = np.linalg.lstsq((g / self.mass) @ g.T, (g / self.mass) @ force + right, rcond=None)[0]
        return np.concatenate([lam.ravel(), np.zeros(phi.numel())])


class Build:
    """IDAS on a problem with a tolerance, and what is read of its states."""

    def __init__(self, problem: Problem, tolerance: float, samples: int) -> None:
        self.problem, self.equations = problem, Equations(problem)
        times = np.linspace(0.0, problem.stop, samples + 1)
        options = {
            "abstol": tolerance,
            "reltol": tolerance,
            "max_num_steps": 1_000_000,
            "suppress_algebraic": True,
            "calc_ic": False,
        }
        e = self.equations
        system = e.system()
        self._x0, self._z0 = np.concatenate([e.start, e.speed]), e.multipliers()
        slopes = casadi.Function("slopes", [system["x"], system["z"], e.t], [system["ode"]])
        options["init_xdot"] = np.array(slopes(self._x0, self._z0, 0.0)).ravel().tolist()
        self._solve = casadi.integrator("solve", "idas", system, 0.0, times[1:].tolist(), options)
        self.t = times

    def run(self) -> Array:
        """States (variables, samples)."""
        try:
            return np.array(self._solve(x0=self._x0, z0=self._z0)["xf"])
        except RuntimeError as error:
            message = "IDAS failed: " + str(error).strip().rpartition("\n")[2][-60:]
            raise GaveUpError(message) from error

    def observed(self) -> Observed:
        """What a run comes to."""
        states = np.hstack([self._x0[:, None], self.run()])
        e, problem = self.equations, self.problem
        q, v = states[: len(e.start)], states[len(e.start) :]

        def read(name: str, what: str) -> Array:
            columns = e.places[name]
            zero = np.zeros((len(self.t), 1))
            if what == "w":
                return np.hstack([zero, zero, v[columns][2:].T])
            if what in ("x", "v"):
                return np.hstack([(q if what == "x" else v)[columns][:2].T, zero])
            place = problem.springs[int(what[6])].ends[int(what[7])]
            return np.hstack([self._at(place, q, v)[0], zero])

        found = energies(problem, read)
        places, speeds = np.zeros((2, len(problem.watch), 3))
        for i, place in enumerate(problem.watch):
            x, dx = self._at(place, q[:, -1:], v[:, -1:])
            places[i, :2], speeds[i, :2] = x[0], dx[0]
        if problem.key == "car_axis":
            springs = casadi.Function("springs", [e.q, e.t], [e.potential()])
            found = found + np.array(
                [float(springs(a, t)) for a, t in zip(q.T, self.t, strict=True)]
            )
        return Observed.of(places, speeds, found.tolist())

    def _at(self, place: Place, q: Array, v: Array) -> tuple[Array, Array]:
        e = self.equations
        x = e.place(place)
        both = casadi.Function("place", [e.q, e.v], [x, casadi.jacobian(x, e.q) @ e.v])
        pairs = [both(a, b) for a, b in zip(q.T, v.T, strict=True)]
        return np.array([p[0] for p in pairs])[..., 0], np.array([p[1] for p in pairs])[..., 0]


def _entry(problem: Problem, tolerance: float) -> Entry:
    build = Build(problem, tolerance, 1)
    return Entry(build.run)


def _excuse(problem: Problem) -> str:
    bodies = problem.bodies.values()
    across = (x for b in bodies for x in (b.position[2], b.velocity[2], *b.turn[:2]))
    if any(across) or problem.gravity[2]:
        return "not modelled: this model of it is planar"
    return too_large(problem)


METHODS = (
    Method(
        name="IDAS, GGL",
        label="tolerance {:.0e}",
        settings=lambda _: TOLERANCES,
        observe=lambda problem, tolerance: Build(problem, tolerance, SAMPLES).observed(),
        entry=_entry,
        excuse=_excuse,
    ),
)
