"""MuJoCo on the mechanisms of the stability maps, watched on the way.

Trees in joint coordinates, hinges without friction, damping or limits; loops are closed by points
that coincide (`connect`), as stiff as MuJoCo advises: a time constant of two steps, impedance
0.9999. Runs where the package `mujoco` is, without anything of holonom.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import mujoco
import numpy as np

from benchmarks.stability_rules import Outcome, steps, stride

# What diverges would otherwise leave a file of warnings where the program runs.
mujoco.set_mju_user_warning(lambda _: None)

METHODS = {
    "RK4": mujoco.mjtIntegrator.mjINT_RK4,
    "implicitfast": mujoco.mjtIntegrator.mjINT_IMPLICITFAST,
}
SMALL = 1e-10
"""Moment of inertia of a point and of a slender rod about itself [kg m2]; it must be positive."""
ROD = 1.0 / 12.0
X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)

Vector = Sequence[float]


class Drawing:
    """A mechanism being drawn, and the rates of its joints at the start."""

    def __init__(self, gravity: float = -9.81) -> None:
        self.spec = mujoco.MjSpec()
        self.spec.compiler.boundmass = 0.0
        option = self.spec.option
        option.gravity = [0.0, gravity, 0.0]
        option.iterations, option.tolerance = 200, 0.0
        option.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
        option.disableflags |= mujoco.mjtDisableBit.mjDSBL_AUTORESET
        option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
        self.rates: list[float] = []

    def body(self, parent: Any, at: Vector, mass: float, com: Vector, inertia: Vector) -> Any:
        """A body at a place of its parent (None: the ground), its axes parallel as drawn."""
        name = f"body{len(self.spec.bodies)}"
        return (parent or self.spec.worldbody).add_body(
            name=name, pos=at, mass=mass, ipos=com, inertia=inertia, explicitinertial=True
        )

    def hinge(self, body: Any, axis: Vector, rate: float = 0.0) -> None:
        """Hinge at the body's origin, turning at a rate [rad/s] against its parent."""
        body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=axis)
        self.rates.append(rate)

    def slide(self, body: Any, axis: Vector, stiffness: float) -> None:
        """Let a body slide, held by a spring [N/m] that is relaxed as drawn."""
        body.add_joint(type=mujoco.mjtJoint.mjJNT_SLIDE, axis=axis, stiffness=stiffness)
        self.rates.append(0.0)

    def connect(self, body: Any, place: Vector) -> None:
        """Hold a place of a body where it is drawn."""
        equality = self.spec.add_equality(
            type=mujoco.mjtEq.mjEQ_CONNECT,
            objtype=mujoco.mjtObj.mjOBJ_BODY,
            name1=body.name,
            name2="world",
            solimp=[0.9999, 0.9999, 0.001, 0.5, 2.0],
        )
        equality.data[:3] = place


def chain(n: int) -> Drawing:
    """`benchmarks.mechanisms.waving_chain` in space: two hinges a rod."""
    drawing, body, before = Drawing(0.0), None, 0.0
    speed = [0.5 * math.sin(2 * math.pi * i / n) for i in range(n + 1)]
    speed[0] = 0.0
    for i in range(1, n + 1):
        rate = (speed[i] - speed[i - 1]) / 0.1
        at = (0.1, 0.0, 0.0) if body else (0.0, 0.0, 0.0)
        body = drawing.body(body, at, 0.1, (0.1, 0.0, 0.0), [SMALL] * 3)
        drawing.hinge(body, Z, rate - before)
        drawing.hinge(body, Y)
        before = rate
    return drawing


def elastic_pendulum(stiffness: float) -> Drawing:
    """`benchmarks.stability_cases.elastic_pendulum`: a hinge and a sliding joint with a spring."""
    drawing = Drawing()
    first = drawing.body(None, (0.0, 0.0, 0.0), 1.0, X, [SMALL] * 3)
    drawing.hinge(first, Z)
    drawing.slide(first, X, stiffness)
    drawing.hinge(drawing.body(first, X, 1.0, X, [SMALL] * 3), Z)
    return drawing


def _bar(drawing: Drawing, parent: Any, at: Vector, along: Vector, rate: float) -> Any:
    """Uniform slender bar of 1 m and 1 kg on a hinge along z."""
    inertia = [SMALL if along_axis else ROD for along_axis in along]
    body = drawing.body(parent, at, 1.0, [0.5 * a for a in along], inertia)
    drawing.hinge(body, Z, rate)
    return body


def four_bar() -> Drawing:
    """IFToMM benchmark A02 with two loops: the second and third crank hang from the couplers."""
    drawing, down = Drawing(), (0.0, -1.0, 0.0)
    crank = _bar(drawing, None, (0.0, 0.0, 0.0), Y, -1.0)
    first = _bar(drawing, crank, Y, X, 1.0)
    second = _bar(drawing, first, X, X, 0.0)
    for coupler in (first, second):
        drawing.connect(_bar(drawing, coupler, X, down, -1.0), down)
    return drawing


def bricard() -> Drawing:
    """`scenes/bricard.toml`; two points of the sixth hinge's axis close the loop."""
    drawing, body, at = Drawing(), None, (0.0, 0.0, 0.0)
    for along, axis in zip((X, (0, -1, 0), Z, (-1, 0, 0), Y), (Y, Z, X, Y, Z), strict=True):
        inertia = [0.02 / 12 if a else 1.01 / 12 for a in along]
        body = drawing.body(body, at, 1.0, [0.5 * a for a in along], inertia)
        drawing.hinge(body, axis)
        at = along
    for x in (0.0, 0.1):
        drawing.connect(body, (x, 1.0, 0.0))
    return drawing


BUILD: dict[str, Callable[..., Drawing]] = {
    "chain": chain,
    "four-bar": four_bar,
    "bricard": bricard,
    "stiff spring": elastic_pendulum,
}


@cache
def compiled(mechanism: str, *size: float) -> tuple[Any, list[float]]:
    """Model of a mechanism, and its velocities at the start; some seconds for a long chain."""
    drawing = BUILD[mechanism](*size)
    return drawing.spec.compile(), drawing.rates


def run(
    mechanism: str, size: Sequence[float], method: str, h: float, case: dict[str, float]
) -> Outcome:
    """Take steps of h [s] until `case["stop"]`, watched on the way."""
    model, rates = compiled(mechanism, *size)
    model.opt.integrator, model.opt.timestep = METHODS[method], h
    model.eq_solref[:] = [2.0 * h, 1.0]
    data = mujoco.MjData(model)
    data.qvel[:] = rates
    outcome, before = Outcome(), _energy(model, data)
    taken, count = 0, steps(case["stop"], h)
    while taken < count:
        more = min(stride(count), count - taken)
        mujoco.mj_step(model, data, more)
        taken += more
        energy = (_energy(model, data) - before) / case["reference"]
        gaps = np.linalg.norm(data.efc_pos[: data.ne].reshape(-1, 3), axis=1)
        violation = float(np.max(gaps, initial=0.0)) / case["length"]
        if not outcome.see(energy, violation, taken * h):
            break
    return outcome


def _energy(model: Any, data: Any) -> float:
    """Kinetic and potential energy of the present state [J]; its constraints are evaluated, too."""
    mujoco.mj_forward(model, data)
    return float(data.energy[0] + data.energy[1])
