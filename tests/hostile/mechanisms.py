"""Random mechanisms with numbers far from one: solved to round-off, or the sentence says why not.

Sizes from 1e-9 to 1e9 m, masses from 1e-12 to 1e12 kg, up to 1e24 apart, far from the origin, with
stiff springs, redundant and contradicting joints; steps from 1 ns to 1000 s, or a tolerance.
"""

from __future__ import annotations

import json
import math
import random
import warnings
from pathlib import Path
from typing import Any

import solver

CPU_LIMIT = 120.0
"""A tolerance may take 1e6 internal steps before it is said that the step collapsed."""

PLANE = ("distance", "revolute", "prismatic", "point_on_line", "fixed")
SPACE = (
    *("distance", "spherical", "revolute", "universal", "cylindrical", "prismatic", "planar"),
    *("screw", "point_on_line", "point_on_plane", "fixed"),
)
SOLVED = {"energy.error": 1e-8, "constraint.position": 1e-9}
"""Largest values after steps that were solved without a remark."""
ACROSS = 0.3
"""Largest velocity across the rows of a run with a tolerance, against the fastest motion."""

Content = dict[str, Any]


def prepare(folder: Path) -> None:
    """Nothing to make."""


class _Scene:
    """One random scene."""

    def __init__(self, seed: str) -> None:
        self.chance = chance = random.Random(seed)
        self.dim = chance.choice((2, 3))
        self.size = 10.0 ** chance.choice((0, 0, 0, chance.uniform(-9, 9)))
        self.mass = 10.0 ** chance.choice((0, 0, chance.uniform(-12, 12)))
        self.spread = chance.choice((0, 0, 1, 4, 12))
        self.far = chance.choice((0.0, 0.0, 0.0, 1e3, 1e6, 1e9)) * self.size
        self.is_grid = chance.random() < 0.4
        pull = chance.choice((0.0, -9.81, 1e-9, 1e6)) * self.size
        self.content: Content = {
            "name": "hostile",
            "dimension": self.dim,
            "gravity": [0.0] * (self.dim - 1) + [pull],
        }
        ends = self._points() if chance.random() < 0.6 else self._bodies()
        self._forces(ends)
        self._settings()

    def _place(self) -> list[float]:
        chance = self.chance
        at = (
            (lambda: float(chance.randrange(-2, 3)))
            if self.is_grid
            else lambda: chance.uniform(-1, 1)
        )
        return [self.far + self.size * at() for _ in range(self.dim)]

    def _random_mass(self) -> float:
        return self.mass * 10.0 ** self.chance.uniform(-self.spread, self.spread)

    def _velocity(self) -> list[float]:
        speed = self.size * self.chance.choice((0.0, 1.0, 1.0, 1e3, 1e-6))
        return [speed * self.chance.uniform(-1, 1) for _ in range(self.dim)]

    def _points(self) -> list[str]:
        chance, count = self.chance, self.chance.randrange(2, 7)
        names = [f"P{k}" for k in range(count)]
        points = self.content["points"] = {}
        for k, name in enumerate(names):
            point = points[name] = {"position": self._place()}
            if chance.random() < (0.8 if k == 0 else 0.15):
                point["fixed"] = True
                continue
            point["mass"] = 0.0 if chance.random() < 0.1 else self._random_mass()
            if chance.random() < 0.3:
                point["velocity"] = self._velocity()
        for k in range(chance.randrange(1, 2 * count)):
            pair = chance.sample(names, 2)
            if chance.random() < 0.25:
                bar = {"type": "bar", "points": pair, "mass": self._random_mass()}
                self.content.setdefault("bodies", {})[f"b{k}"] = bar
            else:
                rod = {"type": "distance", "points": pair}
                self.content.setdefault("joints", {})[f"j{k}"] = rod
        return names

    def _bodies(self) -> list[str]:
        chance, count = self.chance, self.chance.randrange(2, 7)
        bodies = self.content["bodies"] = {f"B{k}": self._body() for k in range(count)}
        joints = self.content["joints"] = {}
        for k in range(chance.randrange(1, 2 * count)):
            first, second = chance.sample(["ground", *bodies], 2)
            joint = self._joint(first, second)
            if joint:
                joints[f"j{k}"] = joint
        return [*bodies, *(f"{name}.tip" for name in bodies)]

    def _body(self) -> Content:
        chance, mass = self.chance, self._random_mass()
        reach = self.size * 10.0 ** chance.choice((0, 0, chance.uniform(-6, 3)))
        tip = [reach * chance.uniform(-1, 1) for _ in range(self.dim)]
        body: Content = {"position": self._place(), "mass": mass, "points": {"tip": tip}}
        if self.dim == 2:
            body["inertia"] = mass * reach * reach * chance.choice((0.1, 0.1, 0.0, 1e-9))
        else:
            parts = [chance.choice((1, 1, 1, 0, 1e-6)) * chance.uniform(0.1, 1) for _ in range(3)]
            body["inertia"] = [mass * reach * reach * (sum(parts) - part) for part in parts]
            if chance.random() < 0.5:
                turn = [chance.uniform(-3, 3) for _ in range(3)]
                body["orientation"] = {"rotation_vector": turn}
        if chance.random() < 0.3:
            spin = [chance.uniform(-5, 5) for _ in range(3)]
            body["angular_velocity"] = spin[0] if self.dim == 2 else spin
        if chance.random() < 0.3:
            body["velocity"] = self._velocity()
        return body

    def _joint(self, first: str, second: str) -> Content | None:
        chance = self.chance
        kind = chance.choice(PLANE if self.dim == 2 else SPACE)
        axis = [chance.gauss(0, 1) for _ in range(self.dim)]
        if kind == "distance" or kind.startswith("point"):
            if "ground" in (first, second):
                return None
            if kind == "distance":
                return {"type": kind, "points": [f"{first}.tip", f"{second}.tip"]}
            return {"type": kind, "point": f"{second}.tip", "body": first, "axis": axis}
        joint: Content = {"type": kind, "bodies": [first, second], "position": self._place()}
        if kind == "universal":
            other = [chance.gauss(0, 1) for _ in range(3)]
            part = sum(map(float.__mul__, axis, other)) / sum(x * x for x in axis)
            joint["axes"] = [axis, [y - part * x for x, y in zip(axis, other, strict=True)]]
        elif kind == "prismatic" or (self.dim == 3 and kind not in ("spherical", "fixed")):
            joint["axis"] = axis
        if kind == "screw":
            joint["pitch"] = self.size * chance.choice((0.1, 1e-6, 10))
        return joint

    def _forces(self, ends: list[str]) -> None:
        chance, forces = self.chance, {}
        for k in range(chance.randrange(0, 4)):
            pair = chance.sample(ends, 2)
            forces[f"f{k}"] = force = {"points": pair}
            if chance.random() < 0.2:
                damping = self.mass * 10.0 ** chance.uniform(-6, 6)
                force |= {"type": "damper", "damping": damping}
                continue
            force |= {"type": "spring", "stiffness": self.mass * 10.0 ** chance.uniform(-6, 12)}
            if chance.random() < 0.5:
                force["free_length"] = self.size * chance.uniform(0, 2)
        if forces:
            self.content["forces"] = forces

    def _settings(self) -> None:
        chance = self.chance
        step = 10.0 ** chance.choice((-2, -2, -1, -4, chance.uniform(-9, 3)))
        settings: Content = {"step_size": step, "assemble": chance.random() < 0.6}
        if chance.random() < 0.15:
            settings["start"] = "equilibrium"
        if chance.random() < 0.2:
            settings["order"] = chance.choice((4, 6, 8))
        if chance.random() < 0.2:
            settings["tolerance"] = 10.0 ** chance.uniform(-4, -2)
        self.content["solver"] = settings
        self.content["experiment"] = {"step_size": 5 * step, "stop_time": 100 * step}


def case(seed: str, number: int, _folder: Path) -> str | None:
    """Run a random mechanism over 20 communication steps, or fewer where they take long."""
    scene = _Scene(f"{seed}/{number}")
    said: list[str] = []
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", solver.SceneWarning)
            model = solver.assemble(solver.loads(json.dumps(scene.content), format="json"))
        run = solver.Integrator(model, log=said.append)
        left = 20_000.0  # Newton iterations
        for _ in range(20):
            run.advance(run.time, model.experiment.step_size)
            found = _wrong(run, scene, said)
            left -= run.state.head["newton_iterations"]
            if found or left < 0.0:
                return found
    except (solver.SceneError, solver.AssemblyError, solver.OptionError, solver.StepError):
        return None
    return None


def _wrong(run: solver.Integrator, scene: _Scene, said: list[str]) -> str | None:
    outputs = [v.name for v in run.model.variables if v.causality == "output"]
    values = {name: float(run[name]) for name in outputs}
    for name, limit in SOLVED.items():
        limit += 1e-15 * scene.far / scene.size  # round-off of places so far away
        if not values[name] <= limit and not any("energy is off" in text for text in said):
            return f"{name} is {values[name]:.1e} at t = {run.time:g} s, and nothing was said"
    if not run["solver.tolerance"]:
        return None
    speeds = [abs(x) / scene.size for name, x in values.items() if name[-3:-1] == ".v"]
    turns = [abs(x) for name, x in values.items() if name[-3:-1] == ".w" or name.endswith(".w")]
    fastest = max([*speeds, *turns, 0.0])
    # What a step cannot tell: round-off of places over its length.
    rounding = 1e-12 * (1.0 + scene.far / scene.size) / float(run["solver.step_size"])
    if values["constraint.velocity"] > ACROSS * fastest + rounding and math.isfinite(fastest):
        return f"constraint.velocity is {values['constraint.velocity']:.1e}, fastest {fastest:.1e}"
    return None
