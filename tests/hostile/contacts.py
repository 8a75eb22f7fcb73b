"""Odd and extreme contacts: a sentence, or a run that obeys the laws of contact to its end.

Radii, plays and frictions of zero, parallel faces, places that coincide, restitution 0 and 1,
friction from 1e-12 to 1e6, masses 1e8 apart, contacts declared twice or of a body with itself,
starts in contact and in penetration, drivers that push, normals without direction.
"""

from __future__ import annotations

import copy
import functools
import json
import math
import random
import re
import warnings
from pathlib import Path
from typing import Any

import solver
from tests.support.contact.random_shapes import RandomShapes, write_box

CPU_LIMIT = 60.0
"""Many contacts in stepped mode take some ms a step."""

Content = dict[str, Any]

STEPS = 12
WORK = 20_000.0
"""Newton iterations of a case."""
CLOSED, OPEN, ROUNDING = 1e-8, 1e-7, 1e-10
"""Errors of the ledger over its energies, of gaps over the size, of losses that fall."""
FAR = 1e-13
"""Error of the ledger by the round-off of places, per m of coordinates."""
NOTHING = 1e-15
"""Energies [J] and impulses [N s] that are nothing."""
RESTITUTIONS = (0.0, 0.0, 1.0, 1.0, 0.5, 1e-12, 1.0 - 1e-12)
FRICTIONS = (0.0, 1e-300, 1e-12, 1e-9, 0.3, 1.0, 100.0, 1e6)
LENGTHS = (0.0, 0.0, 1e-300, 1e-12, 1e-6, 0.1, 1.0, 1e6)
TINY = (0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3)


@functools.cache
def _mesh(folder: Path) -> Path:
    return write_box(folder)


def prepare(folder: Path) -> None:
    """Write a mesh."""
    _mesh(folder)


def case(seed: str, number: int, folder: Path) -> str | None:
    """Run an odd scene with contacts."""
    chance = random.Random(f"{seed}/{number}")
    content = odd_scene(chance, folder)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", solver.SceneWarning)
            model = solver.assemble(solver.loads(json.dumps(content), format="json"))
        run = solver.Integrator(model, log=lambda _: None)
        return _followed(run, _size(content), chance)
    except (solver.SceneError, solver.AssemblyError, solver.OptionError, solver.StepError) as error:
        return _unclear(str(error))


def odd_scene(chance: random.Random, folder: Path) -> Content:
    """Return a small scene of odd contacts, or a usual one whose contacts are made odd."""
    if chance.random() < 0.5:
        content = _small(chance)
    else:
        content = RandomShapes(chance, wild=chance.random() < 0.3, mesh=_mesh(folder)).content
    for _ in range(chance.choice((0, 1, 1, 2, 4))):
        chance.choice(ODDITIES)(chance, content)
    _set(chance, content)
    return content


def _unclear(text: str) -> str | None:
    """Return what is wrong with a sentence."""
    if "a fault of this program" in text or not text.strip():
        return f"no clear sentence: {text[:200]!r}"
    if (
        re.match(r"\S+ is not finite", text)
        or "a number of it is not finite" in text
        or (re.search(r"\bnan\b", text) and "'nan'" not in text)
    ):
        return f"a sentence with nan: {text[:300]!r}"
    return None


def _size(content: Content) -> float:
    places = [
        x
        for table in ("points", "bodies", "contacts")
        for part in content.get(table, {}).values()
        if isinstance(part.get("position"), list)
        for x in part["position"]
    ]
    return max([1.0, *map(abs, places)])


def _followed(run: solver.Integrator, size: float, chance: random.Random) -> str | None:
    model, left = run.model, WORK
    outputs = [v.name for v in model.variables if v.causality == "output"]
    inputs = [v.name for v in model.variables if v.causality == "input"]
    places = [model.index(name) for name in outputs]
    losses: dict[str, float] = {}
    for _ in range(STEPS):
        for name in inputs:
            run[name] = chance.choice((0.0, 1.0, -5.0))
        run.advance(run.time, model.experiment.step_size)
        values = dict(zip(outputs, map(float, run.get(places)), strict=True))
        found = _wrong(values, size, losses)
        if found:
            return f"{found} at t = {run.time:g} s"
        left -= run.state.head["newton_iterations"]
        if left < 0.0:
            return None
    return None


def _wrong(values: dict[str, float], size: float, losses: dict[str, float]) -> str | None:
    """Return what the outputs of a step break; remember its losses."""
    unlike = [name for name, x in values.items() if not math.isfinite(x)]
    if unlike:
        return f"{unlike[0]} is not finite"
    if values["energy.error"] > CLOSED + FAR * size:
        return f"energy.error is {values['energy.error']:.1e}"
    words = ("kinetic", "potential", "work", "dissipated")
    total = sum(abs(values[f"energy.{word}"]) for word in words)
    for name in ("energy.impact", "energy.friction"):
        before, now = losses.get(name, 0.0), values.get(name, 0.0)
        if now < before - ROUNDING * total - NOTHING:
            return f"{name} falls from {before!r} to {now!r}"
        losses[name] = now
    for name, x in values.items():
        part = name.partition(".")[0]
        if name.endswith(".gap") and f"{part}.mode" in values and x < -OPEN * size:
            return f"{name} is {x:.1e}"
        if name.endswith((".force", ".impulse")) and f"{part}.gap" in values and x < -NOTHING:
            return f"{name} is {x:.1e}"
    return None


# ------------------------------------------------------------------------------------ small scenes


def _small(chance: random.Random) -> Content:
    """One to three parts and some contacts of any type among them."""
    dim = chance.choice((2, 3))
    content: Content = {
        "name": "odd",
        "dimension": dim,
        "gravity": [0.0] * (dim - 1) + [chance.choice((0.0, -9.81, -9.81, 9.81, -1e6))],
        "points": {},
        "bodies": {},
        "contacts": {},
    }
    places = [[0.0] * dim]
    for k in range(chance.randrange(1, 4)):
        place = list(chance.choice(places))
        if chance.random() < 0.7:
            place[chance.randrange(dim)] += chance.choice((1.0, 0.1, *TINY))
        places.append(place)
        velocity = [chance.choice((0.0, 0.0, 1.0, -1.0, 1e3)) for _ in range(dim)]
        mass = chance.choice((1.0, 1.0, 1e-8, 1e8))
        if chance.random() < 0.4:
            content["points"][f"P{k}"] = {"position": place, "mass": mass, "velocity": velocity}
            continue
        parts = chance.choice(([1.0, 1.0, 1.0], [1e-8, 1.0, 1.0], [0.1, 0.2, 0.25]))
        spin = [chance.choice((0.0, 1.0, -10.0)) for _ in range(3)]
        content["bodies"][f"B{k}"] = {
            "position": place, "mass": mass, "velocity": velocity,
            "inertia": 0.1 * mass if dim == 2 else [mass * x for x in parts],
            "angular_velocity": spin[0] if dim == 2 else spin,
            "points": {"tip": [chance.choice((0.0, 0.1, 1.0)) for _ in range(dim)]},
        }  # fmt: skip
    if chance.random() < 0.3:
        content["points"]["O"] = {"position": list(chance.choice(places)), "fixed": True}
    for k in range(chance.choice((1, 1, 2, 3, 6))):
        contact = _contact(chance, content)
        if contact:
            content["contacts"][f"c{k}"] = contact
    return {k: v for k, v in content.items() if v or k == "dimension"}


def _vector(chance: random.Random, dim: int) -> list[float]:
    axis = [0.0] * dim
    axis[chance.randrange(dim)] = chance.choice((1.0, -1.0))
    if chance.random() < 0.3:
        axis = [chance.choice((0.0, 1.0, -1.0, 1e-12, 1e9)) for _ in range(dim)]
    return axis


def _contact(chance: random.Random, content: Content) -> Content | None:
    """Return a contact of random points and bodies."""
    dim, bodies = content["dimension"], ["ground", *content["bodies"]]
    points = [*content["points"], *content["bodies"], *(f"{b}.tip" for b in content["bodies"])]
    length = functools.partial(chance.choice, LENGTHS)
    size = [chance.choice((1.0, 0.2, length())) for _ in range(dim)]
    end = [chance.choice((0.0, 0.1, -0.1)) for _ in range(dim)]
    a, b = chance.choice(points), chance.choice(points)
    pair = [chance.choice(bodies), chance.choice(bodies)]
    body = chance.choice(bodies[1:] or bodies)
    axis, at = _vector(chance, dim), [chance.choice((0.0, -0.1, *TINY)) for _ in range(dim)]
    kinds: list[Content] = [
        {"type": "plane", "point": a, "axis": axis, "position": at, "radius": length()},
        {"type": "plane", "point": a, "axis": axis, "body": pair[0], "radius": length()},
        {"type": "sphere", "points": [a, b], "radii": [length(), length()]},
        {"type": "clearance", "points": [a, b], "radius": length()},
        {"type": "stop", "points": [a, b], "max": length()},
        {"type": "stop", "points": [a, b], "min": length(), "max": length()},
        {"type": "corners", "body": body, "size": size, "axis": axis, "position": at},
        {"type": "corners", "body": body, "corners": [end, end], "axis": axis, "on": pair[0]},
        {"type": "ellipsoid", "body": body, "semi_axes": size, "axis": axis, "position": at},
        {"type": "ellipsoid", "body": body, "semi_axes": size, "point": a, "radius": length()},
        {"type": "capsule", "bodies": pair, "segments": [[end, end], [end, at]],
         "radii": [length()] * 2},
        {"type": "capsule", "bodies": pair, "segments": [[end], [at]], "radii": [length(), 0.1]},
        {"type": "box", "bodies": pair, "sizes": [size, size]},
        {"type": "box", "bodies": pair, "sizes": [size], "segment": [end, at],
         "radii": [0.0, length()]},
        {"type": "superquadric", "point": a, "semi_axes": size, "power": chance.choice((2, 3, 40)),
         "side": chance.choice(("inside", "outside")), "position": at},
    ]  # fmt: skip
    if dim == 2:
        square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        kinds.append({"type": "polygon", "bodies": pair, "corners": [square, square[:3]]})
    else:
        kinds.append({"type": "cylinder", "body": body, "radius": length(), "length": length(),
                      "axis": axis, "position": at})  # fmt: skip
        kinds.append({"type": "journal", "bodies": pair, "position": at, "axis": axis,
                      "length": length(), "radius": length(), "pin_radius": length()})  # fmt: skip
    contact = chance.choice(kinds)
    if chance.random() < 0.5 and contact["type"] != "stop":
        contact["friction"] = chance.choice(FRICTIONS)
    contact["restitution"] = chance.choice(RESTITUTIONS)
    return contact


# --------------------------------------------------------------------------------------- oddities


def _some(chance: random.Random, content: Content, table: str) -> Content:
    return chance.choice(list(content.get(table, {}).values()) or [{}])


def _odd_law(chance: random.Random, content: Content) -> None:
    contact = _some(chance, content, "contacts")
    contact["restitution"] = chance.choice(RESTITUTIONS)
    if "friction" in contact:
        contact["friction"] = chance.choice(FRICTIONS)
        contact.pop("static_friction", None)
        if chance.random() < 0.5:
            contact["static_friction"] = contact["friction"] * chance.choice((1.0, 2.0, 1e6))


def _all_alike(chance: random.Random, content: Content) -> None:
    """Same restitution and friction everywhere."""
    e, mu = chance.choice(RESTITUTIONS), chance.choice(FRICTIONS)
    for contact in content.get("contacts", {}).values():
        contact["restitution"] = e
        if "friction" in contact:
            contact["friction"] = mu
            contact.pop("static_friction", None)


def _odd_length(chance: random.Random, content: Content) -> None:
    contact = _some(chance, content, "contacts")
    words = [w for w in ("radius", "radii", "min", "max", "length", "pin_radius", "ball_radius")
             if w in contact]  # fmt: skip
    if words:
        word = chance.choice(words)
        old, new = contact[word], chance.choice(LENGTHS)
        contact[word] = [new] * len(old) if isinstance(old, list) else new


def _twice(chance: random.Random, content: Content) -> None:
    """The same contact again, maybe with another law."""
    contacts = content.get("contacts", {})
    for name in list(contacts)[: chance.choice((1, 1, 100))]:
        contacts[f"{name}_again"] = copy.deepcopy(contacts[name])
    if chance.random() < 0.3:
        _odd_law(chance, content)


def _masses_apart(chance: random.Random, content: Content) -> None:
    part = _some(chance, content, chance.choice(("points", "bodies")))
    factor = chance.choice((1e8, 1e-8, 1e4, 1e-4))
    if isinstance(part.get("mass"), float) and part["mass"]:
        part["mass"] *= factor
        if "inertia" in part:
            old = part["inertia"]
            many = isinstance(old, list)
            part["inertia"] = [factor * x for x in old] if many else factor * old


def _moved(chance: random.Random, content: Content) -> None:
    """A part nearer to what it touches: closed, or pressed in."""
    part = _some(chance, content, chance.choice(("points", "bodies")))
    if isinstance(part.get("position"), list):
        part["position"][-1] -= chance.choice((*TINY[1:], 0.05, 0.1))


def _same_place(chance: random.Random, content: Content) -> None:
    first, second = (_some(chance, content, chance.choice(("points", "bodies"))) for _ in range(2))
    if isinstance(first.get("position"), list) and "position" in second:
        second["position"] = list(first["position"])


def _fast(chance: random.Random, content: Content) -> None:
    part = _some(chance, content, chance.choice(("points", "bodies")))
    if "velocity" in part:
        part["velocity"] = [x * chance.choice((0.0, 1e-9, 1e3, 1e6)) for x in part["velocity"]]


def _driven(chance: random.Random, content: Content) -> None:
    """A point that a driver holds or pushes."""
    free = [n for n, p in content.get("points", {}).items()
            if not p.get("fixed") and isinstance(p.get("position"), list)]  # fmt: skip
    if free:
        name = chance.choice(free)
        point = content["points"][name]
        value: list[Any] = [repr(x) for x in point["position"]]
        value[-1] += chance.choice(("", " - 0.1*t", " - t*t", " + 0.1*sin(50*t)"))
        point.pop("velocity", None)
        content.setdefault("drivers", {})[f"d{name}"] = {
            "type": "position", "point": name, "value": value,
        }  # fmt: skip


def _other_law(chance: random.Random, content: Content) -> None:
    contact = _some(chance, content, "contacts")
    if chance.random() < 0.5 and "friction" in contact:
        contact.pop("static_friction", None)
        contact["smooth_speed"] = chance.choice((1e-12, 1e-3, 1.0, 1e6))
    elif contact.get("type") in ("plane", "sphere", "clearance", "stop"):
        for word in ("friction", "static_friction", "restitution", "surface_velocity"):
            contact.pop(word, None)
        contact |= {"law": "hertz", "stiffness": chance.choice((1e-6, 1e4, 1e12))}


def _belt(chance: random.Random, content: Content) -> None:
    contact = _some(chance, content, "contacts")
    if "axis" in contact and "friction" in contact and contact["type"] != "journal":
        speed = chance.choice((1e-12, 1.0, 1e4, "sin(100*t)", "1e3*t"))
        contact["surface_velocity"] = [speed] + [0.0] * (content["dimension"] - 1)


def _far(chance: random.Random, content: Content) -> None:
    """Everything that has a place moved far from the origin."""
    shift = chance.choice((1e3, 1e6, 1e9))
    for table in ("points", "bodies", "joints", "contacts"):
        for part in content.get(table, {}).values():
            if isinstance(part.get("position"), list) and all(
                isinstance(x, float) for x in part["position"]
            ):
                part["position"][0] += shift


ODDITIES = (
    _odd_law, _odd_law, _all_alike, _odd_length, _odd_length, _twice, _twice, _masses_apart,
    _moved, _moved, _same_place, _fast, _driven, _other_law, _belt, _far,
)  # fmt: skip


def _set(chance: random.Random, content: Content) -> None:
    """Odd settings."""
    settings: Content = dict(content.get("solver", {}))
    step = settings.get("step_size", 0.01)
    if chance.random() < 0.2:
        step = chance.choice((1e-6, 1e-4, 0.1, 1.0))
    settings |= {"step_size": step, "assemble": chance.random() < 0.5}
    settings["contact_mode"] = chance.choice(("located", "located", "stepped"))
    if settings["contact_mode"] == "stepped":
        settings.pop("tolerance", None)
        settings.pop("order", None)
    if chance.random() < 0.3:
        settings["rest_speed"] = chance.choice((0.0, 1e-12, 1.0, 1000.0))
    if chance.random() < 0.3:
        settings["rest_time"] = chance.choice((0.0, 1e-9, 1.0))
    if chance.random() < 0.2:
        settings["max_events"] = chance.choice((1, 2, 1000))
    if chance.random() < 0.3:
        settings["impact_law"] = "sequential"
    if chance.random() < 0.1:
        settings["start"] = "equilibrium"
    content["solver"] = settings
    content["experiment"] = {"step_size": 2.0 * step, "stop_time": 100.0 * step}
