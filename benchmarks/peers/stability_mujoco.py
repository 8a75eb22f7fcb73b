"""MuJoCo on the mechanisms of the stability maps, watched on the way.

Trees in joint coordinates, hinges without friction, damping or limits; loops are closed by points
that coincide (`connect`), as stiff as MuJoCo advises: a time constant of two steps, impedance
0.9999. Runs where the package `mujoco` is, without anything of holonom.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

import mujoco
import numpy as np

from benchmarks.peers.peer_mujoco import SPECK, Build
from benchmarks.problems.catalogue import MAPS
from benchmarks.sections.stability_rules import Outcome, steps, stride

METHODS = {
    "RK4": mujoco.mjtIntegrator.mjINT_RK4,
    "implicitfast": mujoco.mjtIntegrator.mjINT_IMPLICITFAST,
}
SPRING = """
<mujoco><option gravity="0 -9.81 0"><flag contact="disable"/></option><worldbody>
  <body>
    <joint type="hinge" axis="0 0 1"/><joint type="slide" axis="1 0 0" stiffness="{stiffness!r}"/>
    <inertial pos="1 0 0" mass="1" diaginertia="{speck}"/>
    <body pos="1 0 0">
      <joint type="hinge" axis="0 0 1"/><inertial pos="1 0 0" mass="1" diaginertia="{speck}"/>
    </body>
  </body>
</worldbody></mujoco>"""
"""`elastic_pendulum` of the catalogue: no joint leads to its first mass, but what slides."""


@cache
def compiled(mechanism: str, *size: float) -> tuple[Any, Any]:
    """Model of a mechanism, and its velocities at the start; some seconds for a long chain."""
    if mechanism == "stiff spring":
        text = SPRING.format(stiffness=float(size[0]), speck=SPECK)
        model, speeds = mujoco.MjModel.from_xml_string(text), 0.0
    else:
        build = Build(MAPS[mechanism](*size), 1, "RK4")
        model, speeds = build.model, build.speeds
    option = model.opt
    option.iterations, option.tolerance = 200, 0.0
    option.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    option.disableflags |= mujoco.mjtDisableBit.mjDSBL_AUTORESET
    return model, speeds


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
