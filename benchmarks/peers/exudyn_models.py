"""Mechanisms of `scenes/` for Exudyn, of which `tests/recorded/` has the motion.

Nothing of holonom's solver is used here, so that the models serve as an oracle, in any interpreter
that has `exudyn`. Where a scene has a redundant row, its joint lacks that row here.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import exudyn as exu
from exudyn.utilities import SensorObject

from benchmarks.peers.exudyn_problem import Build
from benchmarks.problems.catalogue import bricard, double_wishbone, governor, heavy_top
from benchmarks.problems.parts import GROUND, Body, Joint, O, Problem, Spring, X
from benchmarks.problems.space import box
from benchmarks.problems.vehicles import DOWN

Model = tuple[Problem, Callable[[Build], None], tuple[str, ...]]
"""A problem, what is drawn besides, and names of the places that it watches."""
SPEED = 150.0
"""Of the crank [rad/s]."""


def nothing(_: Build) -> None:
    """Draw nothing else."""


def slider_crank(more: Callable[[Build], None]) -> Model:
    """`scenes/spatial_slider_crank.toml`; the hinge at the wrist holds the rod in its plane."""
    mass, half = 7870 * 0.15 * 0.01 * 0.01, 0.075
    moving = {"velocity": (0.0, half * SPEED, 0.0)}
    bodies = {
        "crank": Body(
            mass=mass, position=(half, 0, 0), inertia=box(mass, (0.15, 0.01, 0.01)),
            omega=(0.0, 0.0, SPEED), **moving,
        ),
        "rod": Body(
            mass=0.151104, position=(0.3, 0, 0), inertia=(1e-6, 0.0045339259, 0.0045339259),
            omega=(0.0, 0.0, -0.5 * SPEED), **moving,
        ),
        "slider": Body(mass=0.075552, position=(0.45, 0, 0), inertia=(1e-5,) * 3),
    }  # fmt: skip
    hinge = [] if more is _motor else [Joint(kind="revolute", pair=(GROUND, "crank"))]
    wrist = {"position": (0.15, 0, 0), "redundant": True}
    joints = (
        *hinge,
        Joint(kind="spherical", pair=("crank", "rod"), **wrist),
        Joint(kind="revolute", pair=("rod", "slider"), position=(0.45, 0, 0)),
        Joint(kind="prismatic", pair=(GROUND, "slider"), position=(0.45, 0, 0), axis=X),
    )
    springs = (Spring(ends=((GROUND, (0.7, 0, 0)), ("slider", O)), stiffness=500.0, length=0.2),)
    problem = Problem(
        key="slider_crank", title="Spatial slider-crank", stop=0.1, gravity=DOWN, bodies=bodies,
        joints=joints, springs=springs, planar=False,
        watch=(("slider", O), ("crank", (half, 0, 0))),
    )  # fmt: skip
    return problem, more, ("slider", "crank.pin")


def _motor(build: Build) -> None:
    """Turn the crank at a constant speed, and record the torque on it, in the joint's axes."""
    motor = build.system.CreateGenericJoint(
        itemNumbers=[build.ground, build.bodies["crank"]], position=[0, 0, 0],
        offsetUserFunction=lambda _mbs, t, _item, _parameters: [0, 0, 0, 0, 0, SPEED * t],
    )  # fmt: skip
    kind = exu.OutputVariableType.TorqueLocal
    sensor = SensorObject(objectNumber=motor, outputVariableType=kind, storeInternal=True)
    build.sensors["motor", ""] = build.system.AddSensor(sensor)


def wavy_wishbone() -> Model:
    """`scenes/double_wishbone.toml` on a road of height 0.03 (1 - cos 6 t)."""
    flat = double_wishbone(0.0)
    coil, tyre = flat.springs
    patch = Body(mass=1.0, position=(0.0, -0.75, 0.0))
    names = "car", "axle", "upright"
    middle = ("upright", (0.0, -0.7 - flat.bodies["upright"].position[1], 0.0))
    problem = replace(
        flat, bodies={**flat.bodies, "patch": patch}, watch=(*flat.watch, middle),
        springs=(coil, replace(tyre, ends=(("patch", O), tyre.ends[1]))),
    )  # fmt: skip
    return problem, _road, names


def _road(build: Build) -> None:
    def height(_system: object, t: float, _item: int, _offset: float) -> float:
        return 0.03 * (1 - math.cos(6 * t))

    for axis in range(3):
        build.system.CreateCoordinateConstraint(
            itemNumbers=[None, build.bodies["patch"]], coordinates=[None, axis],
            offsetUserFunction=height if axis == 2 else 0,
        )  # fmt: skip


MODELS: dict[str, Callable[[], Model]] = {
    "bricard": lambda: (bricard(), nothing, ("rod3.end",)),
    "heavy_top": lambda: (heavy_top(), nothing, ("top.nose",)),
    "spatial_slider_crank": lambda: slider_crank(_motor),
    "free_slider_crank": lambda: slider_crank(nothing),
    "flyball_governor": lambda: (governor(), nothing, ("slider", "right_ball")),
    "double_wishbone": wavy_wishbone,
}


def moved(name: str, stop: float, period: float, step: float, newton: float) -> dict:
    """Places of a model, (times, 3) by name, recorded every `period` [s] in steps of `step` [s]."""
    problem, more, names = MODELS[name]()
    build = Build(problem, period, more)
    build.solve(round(stop / step), stop, newton=newton)
    found = build.recorded()
    watched = enumerate(zip(names, problem.watch, strict=True))
    places = {name: found[body, f"watch{i}"] for i, (name, (body, _)) in watched}
    return places | {key[0]: table for key, table in found.items() if not key[1]}
