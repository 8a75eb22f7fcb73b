"""MuJoCo on problems with impacts: soft contacts and limits; runs where the package `mujoco` is.

E. Todorov, T. Erez, Y. Tassa, "MuJoCo: a physics engine for model-based control", IROS 2012. The
documentation's way to bounce is `solref="-stiffness -damping"`, elastic with `solref="-k 0"`. The
floor is a plane under a sphere; the circle and the clearance are limits of a tendon's length, which
are the exact gap. An impact is when the gap closes, between two steps.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
from mujoco import rollout

from benchmarks.contact.methods import PHASES, Method, Setting, steps
from benchmarks.contact.problems import (
    CRANK,
    GRAVITY,
    START,
    Problem,
    Score,
    damping_ratio,
    gap_of,
    score,
    touches,
)
from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_methods import GaveUpError

# What diverges is seen in the score; MuJoCo would write a file of it here.
mujoco.set_mju_user_warning(lambda _: None)

SHARP = "0.9999 0.9999 0.001 0.5 2"
"""`solimp`: its largest impedance, at every depth."""
RADIUS = 0.1
PIN = CRANK.crank + CRANK.rod

MODELS = {
    "ball": """
<worldbody>
  <geom type="plane" size="1 1 1" {contact}/>
  <body pos="0 0 {height}">
    <joint type="slide" axis="0 0 1"/><geom type="sphere" size="{radius}" mass="1" {contact}/>
  </body>
</worldbody>""",
    "circle": """
<worldbody>
  <site name="centre"/>
  <body>
    <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/>
    <geom type="sphere" size="0.01" mass="1" contype="0" conaffinity="0"/><site name="mass"/>
  </body>
</worldbody>
<tendon><spatial limited="true" range="0 1" {limit}>
  <site site="centre"/><site site="mass"/>
</spatial></tendon>""",
    "slider_crank": """
<worldbody>
  <body>
    <joint type="hinge" axis="0 -1 0"/>
    <inertial pos="{crank_middle} 0 0" mass="{c.crank_mass}"
      diaginertia="{c.crank_inertia} {c.crank_inertia} {c.crank_inertia}"/>
    <body pos="{c.crank} 0 0">
      <joint type="hinge" axis="0 -1 0"/>
      <inertial pos="{rod_middle} 0 0" mass="{c.rod_mass}"
        diaginertia="{c.rod_inertia} {c.rod_inertia} {c.rod_inertia}"/>
      <site name="pin" pos="{c.rod} 0 0"/>
    </body>
  </body>
  <body pos="{pin} 0 0">
    <joint type="slide" axis="1 0 0"/>
    <inertial pos="0 0 0" mass="{c.slider_mass}" diaginertia="1e-4 1e-4 1e-4"/>
    <site name="slider"/>
  </body>
</worldbody>
<tendon><spatial limited="true" range="0 {c.clearance}" {limit}>
  <site site="pin"/><site site="slider"/>
</spatial></tendon>""",
}


@lru_cache(maxsize=1)
def _model(problem: str, setting: tuple[tuple[str, Any], ...]) -> mujoco.MjModel:
    given: dict[str, Any] = dict(setting)
    soft = {name: given[name] for name in ("solref", "solimp") if given[name]}
    contact = " ".join(f'{name}="{value}"' for name, value in soft.items())
    # Without friction a contact has its normal force alone.
    places = {
        "contact": f'condim="1" {contact}',
        "limit": contact.replace("solref", "solreflimit").replace("solimp", "solimplimit"),
        "height": 1.0 + RADIUS, "radius": RADIUS, "c": CRANK, "pin": PIN,
        "crank_middle": CRANK.crank / 2, "rod_middle": CRANK.rod / 2,
    }  # fmt: skip
    gravity = 0.0 if problem == "slider_crank" else -GRAVITY
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler angle="radian" autolimits="false"/>'
        f'<option timestep="{given["h"]!r}" integrator="{given["integrator"]}" '
        f'gravity="0 0 {gravity}"><flag energy="enable"/></option>'
        f"{MODELS[problem].format(**places)}</mujoco>"
    )


class Run:
    """A problem with a setting, at its start."""

    def __init__(self, problem: Problem, setting: Setting) -> None:
        self.problem, self.h = problem, setting["h"]
        self.count = round(problem.stop / self.h)
        self.model = _model(problem.kind, tuple(setting.items()))
        self.data = mujoco.MjData(self.model)
        self.reset()

    def reset(self) -> None:
        """Return to the start."""
        mujoco.mj_resetData(self.model, self.data)
        if self.problem.kind == "circle":
            self.data.qpos[:], self.data.qvel[:] = START
        elif self.problem.kind == "slider_crank":
            self.data.qvel[:] = CRANK.speed, CRANK.rod_speed - CRANK.speed, 0.0

    def run(self) -> None:
        """Take all steps."""
        mujoco.mj_step(self.model, self.data, self.count)

    def energy(self) -> float:
        """Kinetic and potential energy of the present state [J]."""
        mujoco.mj_forward(self.model, self.data)
        return float(self.data.energy.sum())

    def scored(self) -> Score:
        """Take all steps, looked at."""
        kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
        start = np.empty(mujoco.mj_stateSize(self.model, kind))
        before = self.energy()
        mujoco.mj_getState(self.model, self.data, start, kind)
        states, _ = rollout.rollout(self.model, self.data, start, nstep=self.count)
        states = np.vstack([start, states[0]])
        mujoco.mj_setState(self.model, self.data, np.ascontiguousarray(states[-1]), kind)
        if not np.all(np.isfinite(states)):
            message = "diverged"
            raise GaveUpError(message)
        nq = self.model.nq
        q, v = states[:, 1 : 1 + nq].T, states[:, 1 + nq : 1 + 2 * nq].T
        gap, rate = _gap(self.problem.kind, q, v)
        return score(self.problem, touches(states[:, 0], gap, rate), before - self.energy())


def _gap(kind: str, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gap and its rate [m, m/s] at all samples."""
    if kind == "ball":
        q = q + 1.0
    elif kind == "slider_crank":
        q, v = (np.stack([x[0], x[0] + x[1], x[2]]) for x in (q, v))
        q[2] += PIN
    return gap_of(kind, q, v)


def _families(problem: Problem) -> Iterable[Iterable[Setting]]:
    for integrator in ("Euler", "RK4"):
        # A user who sets nothing: a time constant of 0.02 s, critically damped.
        yield [{"h": 2e-3, "integrator": integrator, "solref": "", "solimp": ""}]
        for solimp in ("", SHARP):
            for phase in PHASES:
                yield [
                    {"h": h, "integrator": integrator, "solimp": solimp}
                    | {"solref": _solref(problem, (phase / h) ** 2)}
                    for h in steps(problem)
                ]


def _solref(problem: Problem, stiffness: float) -> str:
    damping = 2.0 * damping_ratio(problem.restitution) * math.sqrt(stiffness)
    return f"{-stiffness:.6g} {-damping:.6g}"


def _label(setting: Setting) -> str:
    soft = [f"{name} {setting[name]}" for name in ("solref", "solimp") if setting[name]]
    return ", ".join([setting["integrator"], f"h = {setting['h']:g} s", *(soft or ["defaults"])])


def _entry(problem: Problem, setting: Setting) -> Entry:
    run = Run(problem, setting)
    return Entry(run.run, run.reset)


METHODS = (
    Method(
        name="MuJoCo",
        families=_families,
        label=_label,
        entry=_entry,
        score=lambda problem, setting: Run(problem, setting).scored(),
    ),
)
