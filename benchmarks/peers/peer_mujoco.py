"""MuJoCo on the problems of the work-precision curves; runs where the package `mujoco` is.

E. Todorov, T. Erez, Y. Tassa, "MuJoCo: a physics engine for model-based control", IROS 2012. A
mechanism is a tree of hinges, in fewest coordinates; what closes its loops are equality
constraints, which are soft: the integrators then see stiff springs.
"""

from __future__ import annotations

from collections.abc import Iterable
from xml.etree import ElementTree as Xml

import mujoco
import numpy as np

from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_frames import Frames
from benchmarks.peers.peer_methods import SAMPLES, GaveUpError, Method, Observed
from benchmarks.problems.parts import GROUND, Array, Joint, O, Problem, Vector

SPECK = "2e-15 2e-15 2e-15"
"""Moments of inertia of a point [kg m2], which MuJoCo wants to be positive."""


# What diverges is counted in the data and told as such; MuJoCo would write a file of it here.
mujoco.set_mju_user_warning(lambda _: None)


def _text(numbers: Iterable[float]) -> str:
    return " ".join(repr(float(x)) for x in numbers)


class Tree:
    """XML of a problem: joints that lead to a body nobody reached yet, and the loops they leave."""

    def __init__(self, problem: Problem, step: float) -> None:
        self.problem, self._step, self.frames = problem, step, Frames(problem)
        self.reached: dict[str, Xml.Element] = {}
        self.loops: list[Joint] = []

    def model(self, integrator: str) -> mujoco.MjModel:
        """Compiled model."""
        root, step = Xml.Element("mujoco"), repr(self._step)
        gravity = _text(self.problem.gravity)
        option = {"timestep": step, "integrator": integrator, "gravity": gravity}
        flags = {"contact": "disable", "warmstart": "enable"}
        Xml.SubElement(root, "compiler", {"angle": "radian", "inertiafromgeom": "false"})
        options = Xml.SubElement(root, "option", option | SHARP)
        Xml.SubElement(options, "flag", flags)
        self.reached[GROUND] = Xml.SubElement(root, "worldbody")
        if not any(GROUND in joint.pair for joint in self.problem.joints):
            self._float()
        waiting = list(self.problem.joints)
        while waiting:
            joint = next((j for j in waiting if self._leads_on(j)), waiting[0])
            waiting.remove(joint)
            self._add(joint)
        tendons = Xml.SubElement(root, "tendon")
        self._close(root, tendons)
        self._springs(tendons)
        return mujoco.MjModel.from_xml_string(Xml.tostring(root, encoding="unicode"))

    def _float(self) -> None:
        """Points without support slide along three axes each: all that holds them is a loop."""
        for name, body in self.problem.bodies.items():
            self.frames.origins[name] = np.array(body.position)
            element = self._body(name, GROUND, body.position)
            for axis in ("1 0 0", "0 1 0", "0 0 1"):
                Xml.SubElement(element, "joint", {"type": "slide", "axis": axis})

    def _body(self, name: str, parent: str, place: Iterable[float]) -> Xml.Element:
        """Element of a body whose frame has its origin at a place of its parent's."""
        body, frames = self.problem.bodies[name], self.frames
        found = {"name": name, "pos": _text(place)}
        element = self.reached[name] = Xml.SubElement(self.reached[parent], "body", found)
        inertia = {"diaginertia": SPECK}
        if not body.is_point:
            inertia = {"fullinertia": _text(frames.inertia(name))}
        inertial = {"pos": _text(frames.local(name, O)), "mass": repr(body.mass), **inertia}
        Xml.SubElement(element, "inertial", inertial)
        for i, (b, at) in enumerate(self.problem.watch):
            if b == name:
                self._site(f"watch{i}", name, at)
        for i, spring in enumerate(self.problem.springs):
            for j, (b, at) in enumerate(spring.ends):
                if b == name:
                    self._site(f"spring{i}{j}", name, at)
        return element

    def _leads_on(self, joint: Joint) -> bool:
        return sum(name in self.reached for name in joint.pair) == 1

    def _add(self, joint: Joint) -> None:
        if not self._leads_on(joint):
            self.loops.append(joint)
            return
        a, b = joint.pair if joint.pair[0] in self.reached else joint.pair[::-1]
        # All frames are drawn parallel to the global ones, with their origins in the joints.
        place, _ = self.frames.hang(b, joint, a)
        element = self._body(b, a, place)
        for kind, axis in _freedoms(joint, self.problem.planar):
            Xml.SubElement(element, "joint", {"type": kind, "axis": axis})

    def _site(self, site: str, name: str, at: Vector) -> None:
        """Mark a place of a body."""
        place = {"name": site, "pos": _text(self.frames.local(name, at))}
        Xml.SubElement(self.reached[name], "site", place)

    def _close(self, root: Xml.Element, tendons: Xml.Element) -> None:
        equality = Xml.SubElement(root, "equality")
        soft = {"solref": f"{2 * self._step!r} 1", "solimp": "0.9999 0.9999 0.001 0.5 2"}
        for i, joint in enumerate(self.loops):
            if joint.kind == "distance":
                tendon = Xml.SubElement(tendons, "spatial", {"name": f"rod{i}"})
                for j, (name, place) in enumerate(zip(joint.pair, joint.ends, strict=True)):
                    self._site(f"rod{i}{j}", name, place)
                    Xml.SubElement(tendon, "site", {"site": f"rod{i}{j}"})
                Xml.SubElement(equality, "tendon", {"tendon1": f"rod{i}"} | soft)
                continue
            a, b = (name or "world" for name in joint.pair)
            points = [np.array(joint.position) - self.frames.origins[joint.pair[0]]]
            # A hinge whose axis the others do not hold yet also keeps a second point in place.
            if not self.problem.planar and joint.kind == "revolute":
                points.append(points[0] + np.array(joint.axis))
            for point in points:
                pair = {"body1": a, "body2": b, "anchor": _text(point)}
                Xml.SubElement(equality, "connect", pair | soft)

    def _springs(self, tendons: Xml.Element) -> None:
        for i, spring in enumerate(self.problem.springs):
            law = {
                "stiffness": repr(spring.stiffness),
                "damping": repr(spring.damping),
                "springlength": repr(spring.length),
            }
            tendon = Xml.SubElement(tendons, "spatial", law)
            for j, (name, place) in enumerate(spring.ends):
                if name == GROUND:
                    self._site(f"spring{i}{j}", name, place)
                Xml.SubElement(tendon, "site", {"site": f"spring{i}{j}"})


SHARP = {"tolerance": "1e-14", "iterations": "100", "solver": "Newton"}
"""Of the solver of constraints. The constraints of loops are as stiff as MuJoCo lets them be: a
time constant of two steps and an impedance of 0.9999, its largest."""


def _freedoms(joint: Joint, planar: bool) -> list[tuple[str, str]]:
    if planar or joint.kind == "revolute":
        return [("hinge", _text(joint.axis))]
    if joint.kind == "distance":
        return [("hinge", "0 0 1"), ("hinge", "0 1 0")]
    if joint.kind == "spherical":
        return [("ball", "0 0 1")]
    return [("slide", _text(joint.axis))]


class Build:
    """Model and data of a problem with a number of steps, and the velocities of its joints."""

    def __init__(self, problem: Problem, count: int, integrator: str) -> None:
        self.problem, self.count = problem, count
        tree = Tree(problem, problem.stop / count)
        self.model = tree.model(integrator)
        self.data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, self.data)
        self.speeds = tree.frames.rates(self._jacobian)
        self.reset()

    def _jacobian(self, name: str) -> tuple[Array, Array]:
        moving, turning = np.zeros((2, 3, self.model.nv))
        index = self.model.body(name).id
        mujoco.mj_jacBodyCom(self.model, self.data, moving, turning, index)
        return turning, moving

    def reset(self) -> None:
        """Return to the start."""
        mujoco.mj_resetData(self.model, self.data)
        self.data.qvel[:] = self.speeds
        if self.problem.torque:
            name, value = self.problem.torque
            first = self.model.body(name).dofadr[0]
            self.data.qfrc_applied[first] = value

    def run(self, steps: int | None = None) -> None:
        """Take steps, by default all."""
        mujoco.mj_step(self.model, self.data, nstep=steps or self.count)

    def energy(self) -> float:
        """Kinetic and potential energy [J]."""
        mujoco.mj_forward(self.model, self.data)
        mujoco.mj_energyPos(self.model, self.data)
        mujoco.mj_energyVel(self.model, self.data)
        return float(self.data.energy.sum())

    def watched(self) -> tuple[Array, Array]:
        """Positions and velocities of the watched places."""
        q, v = np.zeros((2, len(self.problem.watch), 3))
        velocity = np.zeros(6)
        for i in range(len(q)):
            site = self.model.site(f"watch{i}").id
            kind = mujoco.mjtObj.mjOBJ_SITE
            mujoco.mj_objectVelocity(self.model, self.data, kind, site, velocity, 0)
            q[i], v[i] = self.data.site(site).xpos, velocity[3:]
        return q, v


def _observe(problem: Problem, count: int, integrator: str) -> Observed:
    build = Build(problem, count, integrator)
    found = [build.energy()]
    pieces = max(k for k in range(1, min(SAMPLES, count) + 1) if count % k == 0)
    for _ in range(pieces):
        build.run(count // pieces)
        found.append(build.energy())
    q, v = build.watched()
    # MuJoCo returns to the start where numbers overflow, and counts it as a warning.
    if not np.all(np.isfinite(q)) or any(w.number for w in build.data.warning):
        message = "diverged"
        raise GaveUpError(message)
    return Observed.of(q, v, found)


def _method(integrator: str) -> Method:
    def entry(problem: Problem, count: float) -> Entry:
        build = Build(problem, int(count), integrator)
        return Entry(build.run, build.reset)

    return Method(
        name=f"MuJoCo {integrator}",
        label="{:g} steps",
        settings=_counts,
        observe=lambda problem, count: _observe(problem, int(count), integrator),
        entry=entry,
        excuse=_excuse,
    )


FIRST = {"andrews": 50, "governor": 1000}
"""Steps of the coarsest run."""


def _counts(problem: Problem) -> list[float]:
    if problem.key.startswith(("chain_", "net_")):
        return [8.0, 40.0, 200.0, 1000.0, 4000.0, 16000.0]
    return [float(FIRST.get(problem.key, 100) * 4**k) for k in range(9)]


def _excuse(problem: Problem) -> str:
    if problem.key == "car_axis":
        return "cannot model it: nothing moves as told but by soft constraints"
    if problem.key == "chain_1000":
        return "not measured: its mass matrix of 2000 columns is full"
    return ""


METHODS = tuple(_method(integrator) for integrator in ("RK4", "implicitfast"))
