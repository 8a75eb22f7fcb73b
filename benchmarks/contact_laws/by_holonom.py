"""The experiments as scenes, in both modes of contact, through the public interface."""

from __future__ import annotations

import json
from functools import cache, partial
from typing import Any

import numpy as np

import holonom
from benchmarks.contact_laws.experiments import (
    BOX_SPEED,
    BOX_TURN,
    GRAVITY,
    KANE_ANGLES,
    KANE_RATES,
    PARK_FRICTION,
    PARK_MASS,
    PARK_SIZE,
    PARK_TIME,
    ROD_ANGLE,
    ROD_SPEED,
    Impact,
    Rest,
    box_corners,
    box_inertia,
    turned_by,
)
from benchmarks.contact_laws.method import Method, RefusedError
from benchmarks.problems.parts import Array

LOCATED = 1e-5
"""Step [s]; bodies touch from the start, and velocities are led back to it in a straight line."""
STEPPED = 1e-5
"""Step of stepped mode [s]; bodies touch in the middle of the eleventh."""
COUNT = 10
PERIOD = 0.05
"""Communication step of the parked box [s]."""

Parts = dict[str, Any]


def _toml(table: Parts) -> str:
    """Text of a scene: keys of JSON, one table to a line."""

    def inline(value: Any) -> str:
        if isinstance(value, dict):
            return "{" + ", ".join(f"{json.dumps(k)} = {inline(x)}" for k, x in value.items()) + "}"
        return json.dumps(value)

    return "".join(f"{key} = {inline(value)}\n" for key, value in table.items())


def _floor(point: str, axis: list[float], height: float = 0.0) -> Parts:
    law = {"friction": "mu", "restitution": "e"}
    position = [height * x for x in axis]
    return {"type": "plane", "point": point, "axis": axis, "position": position, **law}


def _rod(lead: float) -> Parts:
    x, y = 0.5 * np.cos(ROD_ANGLE) - lead, 0.5 * np.sin(ROD_ANGLE) + lead * ROD_SPEED
    body = {
        "position": [float(x), float(y)], "orientation": ROD_ANGLE, "velocity": [1, -ROD_SPEED],
        "mass": 1, "inertia": "1/12", "points": {"a": [-0.5, 0]},
    }  # fmt: skip
    return {"dimension": 2, "bodies": {"b": body}, "contacts": {"c": _floor("b.a", [0, 1])}}


def _box(order: tuple[int, ...], vector: tuple[float, ...], lead: float) -> Parts:
    Q = turned_by(vector)
    corners = box_corners(Q)
    place = np.array([0.0, 0.0, -corners[0, 2]]) - lead * np.array(BOX_SPEED)
    angle = float(np.linalg.norm(vector))
    body = {
        "position": place.tolist(), "velocity": list(BOX_SPEED), "mass": 1,
        "inertia": box_inertia().tolist(),
        "points": {f"c{i}": (Q.T @ corners[i]).tolist() for i in order},
    }  # fmt: skip
    if angle:
        body["orientation"] = {"axis": list(vector), "angle": angle}
    floor = {f"f{i}": _floor(f"b.c{i}", [0, 0, 1]) for i in order}
    return {"bodies": {"b": body}, "contacts": floor}


def _kane(lead: float) -> Parts:
    bodies, joints = {}, {}
    low, speed = np.zeros(2), np.zeros(2)
    for k, (angle_then, rate) in enumerate(zip(KANE_ANGLES, KANE_RATES, strict=True)):
        angle = angle_then - lead * rate
        along = np.array([np.sin(angle), -np.cos(angle)])
        across = np.array([np.cos(angle), np.sin(angle)])
        bodies[f"b{k}"] = {
            "position": (low + 0.5 * along).tolist(), "orientation": angle, "mass": 1,
            "inertia": "1/12", "points": {"end": [0, -0.5]}, "angular_velocity": rate,
            "velocity": (speed + 0.5 * rate * across).tolist(),
        }  # fmt: skip
        pair = ["ground" if k == 0 else f"b{k - 1}", f"b{k}"]
        joints[f"j{k}"] = {"type": "revolute", "bodies": pair, "position": low.tolist()}
        low, speed = low + along, speed + rate * across
    floor = {"c": _floor("b1.end", [0, 1], -float(np.cos(KANE_ANGLES).sum()))}
    return {"dimension": 2, "bodies": bodies, "joints": joints, "contacts": floor}


def _cradle(order: tuple[int, ...], lead: float) -> Parts:
    n = len(order) + 1
    points = {
        f"p{i}": {
            "position": [float(i) - lead * (i == 0), 0],
            "velocity": [float(i == 0), 0],
            "mass": 1,
        }
        for i in range(n)
    }
    touching = {
        f"c{i}": {"type": "sphere", "points": [f"p{i}", f"p{i + 1}"], "radii": [0.5, 0.5],
                  "restitution": "e", "friction": "mu"}
        for i in order
    }  # fmt: skip
    return {"dimension": 2, "points": points, "contacts": touching}


def _drawn(key: str, order: tuple[int, ...], lead: float) -> Parts:
    """Bodies and contacts a time `lead` [s] before they touch."""
    if key == "rod":
        return _rod(lead)
    if key == "kane":
        return _kane(lead)
    if key.startswith("cradle"):
        return _cradle(order, lead)
    return _box(order, BOX_TURN if key == "corner" else (0.0, 0.0, 0.0), lead)


@cache
def _model(key: str, order: tuple[int, ...], lead: float, rubs: bool) -> holonom.Model:
    parts = _drawn(key, order, lead)
    flat = parts.get("dimension") == 2
    if not rubs:
        for contact in parts["contacts"].values():
            contact.pop("friction", None)
    number = {"variability": "tunable", "min": 0}
    words = {"e": {"value": 0.5, "max": 1} | number}
    words |= {"mu": {"value": 0.1} | number} if rubs else {}
    content = {"name": key, "gravity": [0, 0] if flat else [0, 0, 0], "parameters": words}
    return holonom.assemble(holonom.loads(_toml(content | parts)))


def _names(key: str) -> list[str]:
    """Outputs that are the velocities of an experiment."""
    if key == "rod":
        return ["b.vx", "b.vy", "b.angular_velocity"]
    if key == "kane":
        return ["b0.angular_velocity", "b1.angular_velocity"]
    if key.startswith("cradle"):
        return [f"p{i}.vx" for i in range(int(key.removeprefix("cradle")))]
    return ["b.vx", "b.vy", "b.vz", "b.wx", "b.wy", "b.wz"]


def _impact(mode: str, impact: Impact, mu: float, e: float) -> Array:
    rubs, names = impact.tangents > 0 and mu > 0.0, _names(impact.key)
    located = mode == "located"
    step = LOCATED if located else STEPPED
    lead, count = (0.0, 2) if located else ((COUNT + 0.5) * step, COUNT + 2)
    model = _model(impact.key, impact.order, lead, rubs)
    given = {"e": e} | ({"mu": mu} if rubs else {})
    try:
        run = holonom.simulate(
            model, stop_time=count * step, step_size=step, internal_step=step, outputs=names,
            parameters=given, contact_mode=mode,
        )  # fmt: skip
    except holonom.StepError as error:
        raise RefusedError(str(error).partition("; ")[0]) from error
    last, end = (np.array([float(run[name][k]) for name in names]) for k in (-2, -1))
    return 2.0 * last - end if located else end


@cache
def _box_at_rest(demand: float) -> holonom.Model:
    size = list(PARK_SIZE)
    body = {"position": [0, 0, PARK_SIZE[2] / 2], "mass": PARK_MASS,
            "shape": {"type": "box", "size": size}}  # fmt: skip
    floor = {"type": "corners", "body": "b", "size": size, "axis": [0, 0, 1],
             "friction": PARK_FRICTION}  # fmt: skip
    gravity = [demand * GRAVITY, 0, -GRAVITY]
    content = {
        "name": "parked",
        "gravity": gravity,
        "bodies": {"b": body},
        "contacts": {"f": floor},
    }
    return holonom.assemble(holonom.loads(_toml(content)))


def _rest(mode: str, demand: float) -> Rest:
    names = ["b.x", "b.z", "solver.events"]
    try:
        run = holonom.simulate(
            _box_at_rest(demand), stop_time=PARK_TIME, step_size=PERIOD, outputs=names,
            contact_mode=mode,
        )  # fmt: skip
    except holonom.StepError as error:
        raise RefusedError(str(error).partition("; ")[0]) from error
    x, z, events = (run[name] for name in names)
    return Rest(float(x[-1] - x[0]), float(z[-1] - z[0]), int(events.sum()))


METHODS = (
    Method(
        name="holonom, located",
        settings="default: impacts located, law of impact simultaneous",
        impact=partial(_impact, "located"),
        rest=partial(_rest, "located"),
    ),
    Method(
        name="holonom, stepped",
        settings=f"stepped mode, steps of {1e6 * STEPPED:g} us; at rest the default step",
        impact=partial(_impact, "stepped"),
        rest=partial(_rest, "stepped"),
    ),
)
