"""MuJoCo on the experiments: soft contacts of small spheres; runs where `mujoco` is.

E. Todorov, T. Erez, Y. Tassa, "MuJoCo: a physics engine for model-based control", IROS 2012. Pairs
of geoms have `solref` (-k, -d) for the normal, with d for the restitution of a linear spring and
damper, and `solreffriction` for the slip; cones are elliptic. Planar experiments move in x and z.
"""

from __future__ import annotations

import math

import mujoco
import numpy as np

from benchmarks.contact.problems import damping_ratio
from benchmarks.contact_laws.experiments import (
    BOX_TURN,
    GRAVITY,
    KANE_ANGLES,
    KANE_RATES,
    PARK_FRICTION,
    PARK_MASS,
    PARK_SIZE,
    PARK_TIME,
    ROD_ANGLE,
    Impact,
    Rest,
    box_corners,
    box_inertia,
    parked_rows,
    turned_by,
)
from benchmarks.contact_laws.method import Method, RefusedError
from benchmarks.problems.parts import Array

STEP = 1e-6
"""Of an impact [s]."""
STEPS = 100
"""Of a contact without friction."""
LONG = 5.0
"""Durations of a contact after which velocities are read."""
STOPS = 0.5
"""Of a slip that may stop, the part that goes in a step: of 1, .5, .35, .25, .2, .15, .1 and .05
that which makes the least energy. The faster friction stops slip the more it parts the bodies."""
PLASTIC = 10.0
"""Damping ratio that stands for restitution 0."""
RADIUS = 1e-3
PARK_STEP, PARK_STEPS = 1e-4, 20
"""Step [s] of the parked box, and how many its time constant has."""
RATIO = 1e4
"""`impratio`, how hard friction is over the normal."""

OPTIONS = (
    'cone="elliptic" impratio="{ratio}" solver="Newton" tolerance="0" iterations="200" '
    'ls_iterations="100"'
)


def _model(bodies: str, pairs: str, h: float, gravity: Array, more: str = "") -> mujoco.MjModel:
    options = OPTIONS.format(ratio=RATIO)
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler angle="radian" autolimits="false"/>'
        f'<option timestep="{h!r}" gravity="{_words(gravity)}" {options} {more}>'
        f'<flag nativeccd="enable"/></option>'
        f'<worldbody><geom name="floor" type="plane" size="9 9 9" contype="0" conaffinity="0"/>'
        f"{bodies}</worldbody><contact>{pairs}</contact></mujoco>"
    )


def _words(numbers: Array) -> str:
    return " ".join(repr(float(x)) for x in numbers)


def _pair(a: str, b: str, mu: float, law: str, size: int) -> str:
    return (
        f'<pair geom1="{a}" geom2="{b}" condim="{size}" friction="{mu!r} {mu!r} 0 0 0" {law} '
        f'solimp="0.9999 0.9999 0.001 0.5 2"/>'
    )


def _ball(name: str, at: Array) -> str:
    """Massless sphere whose lowest place is `at`, in axes of the body."""
    where = f'size="{RADIUS}" pos="{_words(at)}"'
    return f'<geom name="{name}" type="sphere" {where} mass="0" contype="0" conaffinity="0"/>'


def _law(e: float) -> str:
    """`solref` of a contact of STEPS steps, and of friction."""
    omega = math.pi / (STEPS * STEP)
    ratio = damping_ratio(e) if e else PLASTIC
    slip = f'solreffriction="-1 {-STOPS / STEP!r}"'
    return f'solref="{-(omega**2)!r} {-2.0 * ratio * omega!r}" {slip}'


def _impact(impact: Impact, mu: float, e: float) -> Array:
    size = 3 if impact.tangents and mu > 0.0 else 1
    law = _law(e)
    if impact.key.startswith("cradle"):
        return _cradle(impact, law)
    if impact.key == "kane":
        return _kane(mu, law, size)
    planar = impact.key == "rod"
    if planar:
        x, z = 0.5 * math.cos(ROD_ANGLE), 0.5 * math.sin(ROD_ANGLE)
        place, Q, inertia = np.array([x, 0.0, z]), np.eye(3), np.ones(3) / 12.0
        places = [np.array([-x, 0.0, -z])]
        v = np.array([impact.before[0], 0.0, impact.before[1], 0.0, 0.0, 0.0])
    else:
        Q = turned_by(BOX_TURN if impact.key == "corner" else (0.0, 0.0, 0.0))
        places, inertia, v = list(box_corners(Q)), box_inertia(), impact.before
        place = np.array([0.0, 0.0, -places[0][2]])
    balls = "".join(
        _ball(f"b{i}", Q.T @ (places[i] + np.array([0.0, 0.0, RADIUS]))) for i in impact.order
    )
    body = (
        f'<body pos="{_words(place)}" quat="{_words(_quaternion(Q))}"><freejoint/>'
        f'<inertial pos="0 0 0" mass="1" diaginertia="{_words(inertia)}"/>{balls}</body>'
    )
    pairs = "".join(_pair("floor", f"b{i}", mu, law, size) for i in impact.order)
    model = _model(body, pairs, STEP, np.zeros(3))
    data = mujoco.MjData(model)
    data.qvel[:3], data.qvel[3:] = v[:3], Q.T @ v[3:]
    _run(model, data)
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, data.qpos[3:7])
    w = turn.reshape(3, 3) @ data.qvel[3:]
    if planar:
        return np.array([data.qvel[0], data.qvel[2], -w[1]])
    return np.array([*data.qvel[:3], *w])


def _quaternion(Q: Array) -> Array:
    found = np.zeros(4)
    mujoco.mju_mat2Quat(found, Q.ravel())
    return found


def _kane(mu: float, law: str, size: int) -> Array:
    """Angles of the hinges about -y are from the vertical, that of the second from the first."""
    height = float(np.cos(KANE_ANGLES).sum())
    bar = f'<inertial pos="0 0 -0.5" mass="1" diaginertia="{_words(np.ones(3) / 12.0)}"/>'
    hinge = '<joint type="hinge" axis="0 -1 0"/>'
    # The lowest place of the sphere is the end of the rod where this is turned by its angle.
    up = turned_by((0.0, KANE_ANGLES[1], 0.0)) @ [0.0, 0.0, RADIUS]
    ball = _ball("b0", np.array([0.0, 0.0, -1.0]) + up)
    second = f'<body pos="0 0 -1">{hinge}{bar}{ball}</body>'
    body = f'<body pos="0 0 {height!r}">{hinge}{bar}{second}</body>'
    model = _model(body, _pair("floor", "b0", mu, law, size), STEP, np.zeros(3))
    data = mujoco.MjData(model)
    data.qpos[:] = KANE_ANGLES[0], KANE_ANGLES[1] - KANE_ANGLES[0]
    data.qvel[:] = KANE_RATES[0], KANE_RATES[1] - KANE_RATES[0]
    _run(model, data)
    return np.cumsum(data.qvel)


def _cradle(impact: Impact, law: str) -> Array:
    count = len(impact.before)
    bodies = "".join(
        f'<body pos="{i} 0 0"><joint type="slide" axis="1 0 0"/>'
        f'<geom name="b{i}" type="sphere" size="0.5" mass="1" contype="0" conaffinity="0"/></body>'
        for i in range(count)
    )
    pairs = "".join(_pair(f"b{i}", f"b{i + 1}", 0.0, law, 1) for i in impact.order)
    model = _model(bodies, pairs, STEP, np.zeros(3))
    data = mujoco.MjData(model)
    data.qvel[:] = impact.before
    _run(model, data, count)
    return data.qvel.copy()


def _run(model: mujoco.MjModel, data: mujoco.MjData, times: int = 1) -> None:
    for _ in range(round(LONG * STEPS) * times):
        mujoco.mj_step(model, data)
    if not np.all(np.isfinite(data.qvel)) or data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number:
        message = "diverged"
        raise RefusedError(message)


def _rest(demand: float) -> Rest:
    M, _ = parked_rows()
    half = 0.5 * np.array(PARK_SIZE)
    corners = [half * (x, y, -1.0) for x, y in ((-1, -1), (-1, 1), (1, -1), (1, 1))]
    balls = "".join(_ball(f"b{i}", c + np.array([0.0, 0.0, RADIUS])) for i, c in enumerate(corners))
    body = (
        f'<body pos="0 0 {half[2]}"><freejoint/>'
        f'<inertial pos="0 0 0" mass="{PARK_MASS}" diaginertia="{_words(np.diag(M)[3:])}"/>'
        f"{balls}</body>"
    )
    law = f'solref="{PARK_STEPS * PARK_STEP!r} 1" solreffriction="{2 * PARK_STEP!r} 1"'
    pairs = "".join(_pair("floor", f"b{i}", PARK_FRICTION, law, 3) for i in range(4))
    gravity = GRAVITY * np.array([demand, 0.0, -1.0])
    model = _model(body, pairs, PARK_STEP, gravity, 'noslip_iterations="100" noslip_tolerance="0"')
    data = mujoco.MjData(model)
    changes, before = 0, 4
    for k in range(round(PARK_TIME / PARK_STEP)):
        mujoco.mj_step(model, data)
        changes += k > 0 and data.ncon != before
        before = data.ncon
    return Rest(float(data.qpos[0]), float(data.qpos[2] - half[2]), changes)


METHODS = (
    Method(
        name="MuJoCo",
        settings=(
            f"Euler, steps of {1e6 * STEP:g} us; elliptic cones, impratio {RATIO:g}, Newton to "
            f"round-off; pairs with solref (-k, -d) for {STEPS} steps of a contact, damping ratio "
            f"{PLASTIC:g} for e = 0, solimp 0.9999, solreffriction that stops {STOPS:g} of a slip "
            f"in a step; at rest steps of {1e3 * PARK_STEP:g} ms, a time constant of {PARK_STEPS} "
            f"and 100 noslip iterations"
        ),
        impact=_impact,
        rest=_rest,
    ),
)
