"""Motion of random trees by MuJoCo, Runge-Kutta of order 4 at 20 microseconds: a second reference."""

from __future__ import annotations

import math

import mujoco
import numpy as np

from tests.truth.random_systems import STOP, Array, System

STEP = 2e-5


def _model(system: System) -> mujoco.MjModel:
    """Tree of MuJoCo with the axes of the ground in all bodies as drawn."""
    spec = mujoco.MjSpec()
    spec.option.gravity = system.gravity
    spec.option.timestep = STEP
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_RK4
    spec.option.disableflags = mujoco.mjtDisableBit.mjDSBL_CONTACT
    bodies = []
    for i, link in enumerate(system.links):
        parent = bodies[link.parent] if link.parent >= 0 else spec.worldbody
        origin = system.links[link.parent].place if link.parent >= 0 else np.zeros(3)
        body = parent.add_body(name=f"b{i}", pos=link.place - origin)
        J = link.inertia
        body.mass, body.ipos, body.explicitinertial = link.mass, link.centre - link.place, True
        body.fullinertia = [J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2]]
        slides = link.kind == "prismatic"
        kind = mujoco.mjtJoint.mjJNT_SLIDE if slides else mujoco.mjtJoint.mjJNT_HINGE
        body.add_joint(name=f"j{i}", type=kind, axis=link.axis)
        bodies.append(body)
    return spec.compile()


def end_by_mujoco(system: System) -> list[tuple[Array, Array]]:
    """Mass centres and their velocities, (3,) each, at the end of the run."""
    model = _model(system)
    data = mujoco.MjData(model)
    names = {"sin": math.sin}
    torques = [eval(f"lambda t: {link.torque}", names) for link in system.links]
    order = [model.joint(f"j{i}").qposadr[0] for i in range(len(system.links))]
    data.qvel[order] = [link.rate for link in system.links]

    def control(_: mujoco.MjModel, at: mujoco.MjData) -> None:
        for torque, link, k in zip(torques, system.links, order, strict=True):
            spring = link.stiffness * (at.qpos[k] - link.free) + link.damping * at.qvel[k]
            at.qfrc_applied[k] = torque(at.time) - spring

    mujoco.set_mjcb_control(control)
    try:
        for _ in range(round(STOP / STEP)):
            mujoco.mj_step(model, data)
    finally:
        mujoco.set_mjcb_control(None)
    mujoco.mj_forward(model, data)
    found = []
    for i in range(len(system.links)):
        body = model.body(f"b{i}").id
        twist = np.zeros(6)
        mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, body, twist, 0)
        found.append((data.xipos[body].copy(), twist[3:]))
    return found
