"""holonom on the problems of the work-precision curves: orders, and tolerances by each method."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_methods import SAMPLES, GaveUpError, Method, Observed
from benchmarks.problems.mechanisms import Content, hanging_chain, scene, waving_chain
from benchmarks.problems.parts import Array, Problem, Vector
from benchmarks.problems.space import net
from benchmarks.problems.vehicles import stewart
from scenes import generate
from solver import assemble
from solver.runtime import Integrator, Model, StepError

try:
    import tomllib
except ImportError:  # Python 3.10
    import tomli as tomllib

Value = float | str | bool
SCENES = Path(__file__).resolve().parents[2] / "scenes"
ORDERS = (2, 4, 6, 8)
STEPPED_BY = ("conserving", "fastest")
"""Values of the option `method`; equal steps are conserving."""
STAGES = {2: 1, 4: 5, 6: 9, 8: 15}
"""Pairs of half steps in a step of each order."""


def _drawn(name: str) -> Content:
    return tomllib.loads((SCENES / f"{name}.toml").read_text(encoding="utf-8"))


def _hanging_chain() -> Content:
    content = tomllib.loads(generate.hanging_chain(10))
    content["points"]["foot"] = {"position": [0.0, -2.0], "fixed": True}
    damper = {"type": "damper", "points": ["foot", "P5"], "damping": 0.5}
    return content | {"forces": {"damper": damper}}


def _double_wishbone() -> Content:
    """The suspension without its road's wave, falling at 1 m/s."""
    content = _drawn("double_wishbone")
    for part in (*content["bodies"].values(), content["points"]["axle"]):
        part["velocity"] = [0.0, 0.0, -1.0]
    return content


def content_of(problem: Problem) -> Content:
    """A problem in space as a scene, of its bodies, joints and springs without dampers."""
    content: Content = {
        "name": problem.key,
        "gravity": list(problem.gravity),
        "points": {},
        "bodies": {},
        "joints": {},
        "forces": {},
    }
    for name, body in problem.bodies.items():
        part = {"mass": body.mass, "position": body.position, "velocity": body.velocity}
        if not body.is_point:
            angle = math.hypot(*body.turn)
            part |= {"inertia": body.inertia, "points": {}}
            part["angular_velocity"] = (body.attitude @ np.array(body.omega)).tolist()
            if angle:
                part["orientation"] = {"axis": [x / angle for x in body.turn], "angle": angle}
        content["points" if body.is_point else "bodies"][name] = part
    for i, joint in enumerate(problem.joints):
        made: Content = {"type": joint.kind}
        if joint.kind == "distance":
            made["points"] = joint.pair
        else:
            made["bodies"] = [name or "ground" for name in joint.pair]
            made["axis" if joint.kind == "prismatic" else "position"] = (
                joint.axis if joint.kind == "prismatic" else joint.position
            )
        content["joints"][f"joint{i}"] = made
    for i, spring in enumerate(problem.springs):
        ends = [_eye(content, f"end{i}_{j}", *end) for j, end in enumerate(spring.ends)]
        law = {"stiffness": spring.stiffness, "free_length": spring.length}
        content["forces"][f"spring{i}"] = {"type": "spring", "points": ends} | law
    for i, (name, place) in enumerate(problem.watch):
        if name in content["bodies"]:
            content["bodies"][name]["points"][f"watch{i}"] = place
    return content


def _eye(content: Content, point: str, name: str, place: Vector) -> str:
    """Add a point of a body or of the ground; return its name."""
    if name:
        content["bodies"][name]["points"][point] = place
        return f"{name}.{point}"
    content["points"][point] = {"position": place, "fixed": True}
    return point


def _rigid_chain(n: int) -> Content:
    content = tomllib.loads(generate.rigid_chain(n))
    for name in (f"link{n}", f"link{(n + 1) // 2}"):
        content["bodies"][name]["points"] = {"end": [0.05, 0.0, 0.0]}
    return content


class Drawn(NamedTuple):
    """A problem as we draw it."""

    content: Callable[[], Content]
    watched: tuple[str, ...]
    """Our names of the places that it watches."""
    first: int
    """Steps of the coarsest run of order 8; the lower orders begin with more of them."""


DRAWN = {
    "double_pendulum_30": Drawn(lambda: hanging_chain(2, math.radians(30.0)), ("P1", "P2"), 20),
    "double_pendulum_90": Drawn(lambda: hanging_chain(2), ("P1", "P2"), 40),
    "four_bar_2": Drawn(lambda: tomllib.loads(generate.n_four_bar(2)), ("B0", "B2"), 40),
    "four_bar_40": Drawn(lambda: tomllib.loads(generate.n_four_bar(40)), ("B0", "B40"), 40),
    "andrews": Drawn(lambda: _drawn("andrews"), ("K1.tip", "K2.tip"), 8),
    "bricard": Drawn(lambda: _drawn("bricard"), ("rod3.end",), 10),
    "heavy_top": Drawn(lambda: _drawn("heavy_top"), ("top.nose",), 10),
    "car_axis": Drawn(lambda: _drawn("car_axis"), ("A", "B"), 8),
    "chain_10": Drawn(lambda: waving_chain(10, 3), ("P10", "P5"), 1),
    "chain_100": Drawn(lambda: waving_chain(100, 3), ("P100", "P50"), 1),
    "chain_1000": Drawn(lambda: waving_chain(1000, 3), ("P1000", "P500"), 1),
    "hanging_chain": Drawn(_hanging_chain, ("P5", "P2"), 4),
    "governor": Drawn(lambda: _drawn("flyball_governor"), ("slider", "right_ball"), 40),
    "rigid_chain_10": Drawn(lambda: _rigid_chain(10), ("link10.end", "link5.end"), 10),
    "rigid_chain_100": Drawn(lambda: _rigid_chain(100), ("link100.end", "link50.end"), 10),
    "stewart": Drawn(lambda: content_of(stewart()), ("platform.watch0", "platform.watch1"), 10),
    "double_wishbone": Drawn(_double_wishbone, ("car", "axle"), 2),
    "net_30": Drawn(lambda: content_of(net(30)), ("P29_29", "P15_15"), 1),
}
"""By the key of the problem."""
WHEEL = 5e-4
"""Mass of the car's driven wheel in our scene [kg]; gravity is 1 m/s2 there."""


def methods(problem: Problem) -> list[Method]:
    """One for each curve."""
    run = _Runs(problem)
    return [run.method(curve) for curve in curves()]


@dataclass(frozen=True, slots=True)
class Curve:
    """Settings of the solver, by one number of which a curve has one point each."""

    name: str
    label: str
    values: Callable[[Problem], list[float]]
    settings: Callable[[Problem, float], dict[str, Value]]
    """Settings `solver.<name>` for a number."""
    solves: Callable[[float], float]
    """Implicit solves that a number means; more of them were steps that had to be halved."""


def curves() -> list[Curve]:
    """Orders, by numbers of steps, and the choice of both by a tolerance, with each method."""
    return [*(_of_order(order) for order in ORDERS), *map(_by_tolerance, STEPPED_BY)]


def _of_order(order: int) -> Curve:
    return Curve(
        name=f"holonom conserving, order {order}",
        label="{:g} steps",
        values=lambda problem: steps(problem, order),
        settings=lambda problem, count: {"order": order, "step_size": problem.stop / count},
        solves=lambda count: 2 * STAGES[order] * count,
    )


def _by_tolerance(method: str) -> Curve:
    return Curve(
        name=f"holonom {method}, tolerance",
        label="tolerance {:.0e}",
        values=lambda _: [10.0**-k for k in range(1, 12)],
        settings=lambda problem, tolerance: {
            "tolerance": tolerance,
            "order": 0,
            "method": method,
            "longest_step": problem.stop,
        },
        solves=lambda _: math.inf,
    )


class _Runs:
    """A problem's scene, assembled once for each curve: its order decides what the state keeps."""

    def __init__(self, problem: Problem) -> None:
        self._key = problem.key
        experiment = {"stop_time": problem.stop, "step_size": problem.stop}
        self._content = DRAWN[problem.key].content() | {"experiment": experiment}
        self._models: dict[str, Model] = {}

    def _model(self, curve: Curve, settings: Mapping[str, Value]) -> Model:
        if curve.name not in self._models:
            own: Mapping[str, Any] = self._content.get("solver", {})
            chosen = {**own, "step_size": self._content["experiment"]["step_size"], **settings}
            self._models[curve.name] = assemble(scene(self._content, **chosen))
        return self._models[curve.name]

    def method(self, curve: Curve) -> Method:
        """What measures a curve."""

        def entry(problem: Problem, value: float) -> Entry:
            integrator = self._start(curve, curve.settings(problem, value))
            state = integrator.save()
            return Entry(
                lambda: integrator.advance(0.0, problem.stop), lambda: integrator.restore(state)
            )

        return Method(
            name=curve.name,
            label=curve.label,
            settings=curve.values,
            observe=lambda problem, value: self._observe(problem, curve, value),
            entry=entry,
        )

    def _start(self, curve: Curve, settings: Mapping[str, Value]) -> Integrator:
        integrator = Integrator(self._model(curve, settings))
        for name, value in settings.items():
            integrator[f"solver.{name}"] = value
        integrator.initialise()
        return integrator

    def _observe(self, problem: Problem, curve: Curve, value: float) -> Observed:
        settings = curve.settings(problem, value)
        integrator = self._start(curve, settings)
        # Steps that a tolerance chooses would be others if the run were divided.
        whole = round(problem.stop / float(settings.get("step_size", problem.stop)))
        pieces = max(k for k in range(1, min(SAMPLES, whole) + 1) if whole % k == 0)
        energies, substeps = [self._energy(integrator)], 0.0
        try:
            for i in range(pieces):
                t = (i + 1) / pieces * problem.stop
                integrator.advance(integrator.time, t - integrator.time)
                energies.append(self._energy(integrator))
                substeps += float(integrator["solver.substeps"])
        except StepError as error:
            raise GaveUpError(str(error).partition(";")[0]) from error
        remark = "some steps halved" if substeps > curve.solves(value) else ""
        used = float(integrator["solver.order_in_use"])
        if settings["order"] and used != settings["order"]:
            remark = f"limited to order {used:g}: dampers"
        return Observed.of(*watched(problem, integrator), energies, remark)

    def _energy(self, integrator: Integrator) -> float:
        """Energy [J] without that of the car's wheel, which is told where to be."""
        energy = float(integrator["energy.total"])
        if self._key == "car_axis":
            y, vx, vy = (float(integrator[f"R.{name}"]) for name in ("y", "vx", "vy"))
            energy -= WHEEL * (0.5 * (vx * vx + vy * vy) + y)
        return energy


def steps(problem: Problem, order: int) -> list[float]:
    """Numbers of steps from coarse to fine."""
    first = DRAWN[problem.key].first * {2: 2, 4: 1, 6: 1, 8: 1}[order]
    return [float(first * 2**k) for k in range(14)]


def watched(problem: Problem, integrator: Integrator) -> tuple[Array, Array]:
    """Positions and velocities of the watched places, shape (places, 3)."""
    axes = "xy" if problem.planar else "xyz"
    values = np.zeros((2, len(problem.watch), 3))
    for i, name in enumerate(DRAWN[problem.key].watched):
        for k, axis in enumerate(axes):
            values[0, i, k] = integrator[f"{name}.{axis}"]
            values[1, i, k] = integrator[f"{name}.v{axis}"]
    return values[0], values[1]
