"""Reference problems, each listed once: mechanisms as the contents of a scene.

A mechanism is a `Content`: what a scene file says, as a dict, so that tests can build mechanisms of
any size. `start` makes an integrator of it, `move` takes steps and records them.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import solver
from solver.runtime import Integrator, Model
from tests.support.kernel.kernel_calls import kernel_of

Content = dict[str, Any]
Array = NDArray[np.float64]

GRAVITY = 9.81


# ----------------------------------------------------------------------------- from content to run


def mechanism(name: str, dimension: int, *, gravity: bool = True, **tables: Any) -> Content:
    """Return the content of a scene; gravity acts along the last axis, downwards."""
    down = [0.0] * (dimension - 1) + [-GRAVITY]
    return {
        "name": name,
        "dimension": dimension,
        "gravity": down if gravity else [0.0] * dimension,
    } | tables


def scene(content: Content, **settings: Any) -> solver.Scene:
    """Return the scene of a content with settings of the solver."""
    complete = content | {"solver": content.get("solver", {}) | settings}
    complete.setdefault("experiment", {"stop_time": 10.0, "step_size": 10.0})
    return solver.loads(json.dumps(complete), name=f"{content['name']}.json", format="json")


def assemble(content: Content, **settings: Any) -> Model:
    """Return the model of a content."""
    return solver.assemble(scene(content, **settings))


def start(content: Content, *, h: float = 0.01, **settings: Any) -> Integrator:
    """Return an assembled mechanism whose internal step is `h`."""
    integrator = Integrator(assemble(content, **({"step_size": h} | settings)))
    integrator.initialise()
    return integrator


def view(integrator: Integrator, name: str) -> Array:
    """Vector of the state, shared: shape (nodes, dim) for coordinates and velocities."""
    values = np.asarray(integrator.state.vectors[name])
    of_nodes = name.partition("_")[0] in ("q", "v", "a")
    return values.reshape(-1, integrator.model.sizes["dim"]) if of_nodes else values


def step(integrator: Integrator, h: float) -> None:
    """Take one communication step from where the mechanism is."""
    integrator.advance(integrator.time, h)


@dataclass(frozen=True)
class Motion:
    """What `move` recorded: times (n + 1,), coordinates and velocities (n + 1, nodes, dim).

    `mu` (2 n, rows) are the multipliers of each half step, `phi` and
    `phi_dot` (n + 1, rows) residuals and `balance` (n + 1,) the energy balance [J].
    """

    t: Array
    q: Array
    v: Array
    mu: Array
    phi: Array
    phi_dot: Array
    balance: Array


def move(integrator: Integrator, h: float, n_steps: int) -> Motion:
    """Take steps of length h and record all of them."""
    place = integrator.model.index("energy.balance")

    def snapshot() -> tuple[Any, ...]:
        phi, phi_dot = kernel_of(integrator).residuals()
        q, v = view(integrator, "q").copy(), view(integrator, "v").copy()
        return integrator.time, q, v, phi, phi_dot, integrator.get([place])[0]

    rows, mu = [snapshot()], []
    for _ in range(n_steps):
        step(integrator, h)
        rows.append(snapshot())
        mu += [view(integrator, half).copy() for half in ("mu_first", "mu_second")]
    t, q, v, phi, phi_dot, balance = (np.array(column) for column in zip(*rows, strict=True))
    return Motion(t, q, v, np.array(mu), phi, phi_dot, balance)


def observe(integrator: Integrator, h: float, n_steps: int, names: Sequence[str]) -> Array:
    """Values of outputs, shape (n_steps + 1, len(names)), at the start and after each step of h."""
    places = [integrator.model.index(name) for name in names]
    rows = [integrator.get(places)]
    for _ in range(n_steps):
        step(integrator, h)
        rows.append(integrator.get(places))
    return np.array(rows, dtype=float)


def observed_order(steps: Sequence[float], errors: Sequence[float]) -> float:
    """Slope of log(error) over log(step), by least squares."""
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


# -------------------------------------------------------------------------------------- mechanisms


def rods(names: Iterable[tuple[str, str]], **law: float) -> Content:
    """Joints of type distance between pairs of points, as long as drawn or of one `length`."""
    joint: Content = {"type": "distance"} | law
    return {f"rod{i}": joint | {"points": list(pair)} for i, pair in enumerate(names, start=1)}


def chain(
    n: int,
    angle: float = math.pi / 2,
    *,
    dimension: int = 2,
    mass: float = 1.0,
    length: float = 1.0,
) -> Content:
    """N rods with a mass at each joint, at rest, all at `angle` from the vertical: horizontal."""
    x, y = length * math.sin(angle), -length * math.cos(angle)
    if angle == math.pi / 2:
        y = 0.0
    points: Content = {"P0": {"position": [0.0] * dimension, "fixed": True}}
    for i in range(1, n + 1):
        points[f"P{i}"] = {"position": [i * x, *[0.0] * (dimension - 2), i * y], "mass": mass}
    pairs = ((f"P{i - 1}", f"P{i}") for i in range(1, n + 1))
    return mechanism(f"chain{n}", dimension, points=points, joints=rods(pairs, length=length))


def tree(n: int, *, dimension: int = 2) -> Content:
    """N rods that branch in two at every joint, spread out flat, released from rest."""
    points: Content = {"P0": {"position": [0.0] * dimension, "fixed": True}}
    place = {0: (0.0, 0.0)}
    for i in range(1, n + 1):
        x, _ = place[(i - 1) // 2]
        level = (i + 1).bit_length()
        along = (i + 2 - 2 ** (level - 1)) / 2 ** (level - 1)
        place[i] = (x + 0.1, along)
        flat = [place[i][0], place[i][1]]
        points[f"P{i}"] = {"position": flat if dimension == 2 else [*flat, 0.0], "mass": 1.0}
    pairs = ((f"P{(i - 1) // 2}", f"P{i}") for i in range(1, n + 1))
    return mechanism(f"tree{n}", dimension, points=points, joints=rods(pairs))


def pendulum(angle: float, rate: float = 0.0, *, mass: float = 1.0, length: float = 1.0) -> Content:
    """Point on a rod, `angle` [rad] from the lowest position, turning at `rate` [rad/s]."""
    x, y = length * math.sin(angle), -length * math.cos(angle)
    points = {
        "O": {"position": [0.0, 0.0], "fixed": True},
        "A": {"position": [x, y], "velocity": [-y * rate, x * rate], "mass": mass},
    }
    return mechanism("pendulum", 2, points=points, joints=rods([("O", "A")]))


def conical_pendulum(angle: float) -> Content:
    """Point on a unit rod that circles about the vertical: rate^2 = g/(L cos angle)."""
    radius, rate = math.sin(angle), math.sqrt(GRAVITY / math.cos(angle))
    points = {
        "O": {"position": [0.0, 0.0, 0.0], "fixed": True},
        "A": {
            "position": [radius, 0, -math.cos(angle)],
            "velocity": [0, radius * rate, 0],
            "mass": 1.0,
        },
    }
    return mechanism("conical", 3, points=points, joints=rods([("O", "A")]))


def travelling_wave(n: int, dimension: int = 3) -> Content:
    """A straight chain of n light links without gravity, one period of a sine as velocity."""
    content = chain(n, dimension=dimension, mass=0.1, length=0.1)
    for i in range(1, n + 1):
        across = [0.0, 0.5 * math.sin(2 * math.pi * i / n), 0.0]
        content["points"][f"P{i}"]["velocity"] = across[:dimension]
    return content | {"name": f"wave{n}", "gravity": [0.0] * dimension}


def double_pendulum(angle: float = math.pi / 2) -> Content:
    """Two unit rods with unit masses, both at `angle` from the lowest position, at rest."""
    x, y = math.sin(angle), -math.cos(angle)
    points = {
        "O": {"position": [0.0, 0.0], "fixed": True},
        "A": {"position": [x, y], "mass": 1.0},
        "B": {"position": [2 * x, 2 * y], "mass": 1.0},
    }
    return mechanism("double", 2, points=points, joints=rods([("O", "A"), ("A", "B")]))


def four_bar(n: int = 2) -> Content:
    """N loops of uniform unit bars on N + 1 cranks, upright and moving at 1 m/s (IFToMM A02)."""
    points: Content = {}
    for i in range(n + 1):
        points[f"A{i}"] = {"position": [i, 0], "fixed": True}
        points[f"B{i}"] = {"position": [i, 1], "velocity": [1, 0]}
    bars = {f"crank{i}": (f"A{i}", f"B{i}") for i in range(n + 1)}
    bars |= {f"coupler{i}": (f"B{i}", f"B{i + 1}") for i in range(n)}
    bodies = {name: {"type": "bar", "points": ends, "mass": 1.0} for name, ends in bars.items()}
    return mechanism(f"four_bar{n}", 2, points=points, bodies=bodies)


def free_system(dimension: int) -> Content:
    """Points, a bar, rods and springs that tumble freely: one of everything, no regular shape."""
    places = [[0.0, 0.0, 0.0], [1.0, 0.1, 0.2], [0.3, 0.9, -0.1], [1.4, 1.1, 0.5], [-0.7, 0.6, 0.8]]
    turn = np.array([0.3, -0.4, 1.0]) if dimension == 3 else np.array([0.0, 0.0, 1.0])
    points = {}
    for i, place in enumerate(places):
        x = np.array(place) if dimension == 3 else np.array([*place[:2], 0.0])
        velocity = (np.cross(turn, x) + np.array([0.05, -0.02, 0.03]))[:dimension]
        points[f"P{i}"] = {
            "position": x[:dimension].tolist(),
            "velocity": velocity.tolist(),
            "mass": 0.5 + 0.3 * i,
        }
    springs = {
        "left": {"type": "spring", "points": ["P1", "P3"], "stiffness": 6.0, "free_length": 0.9},
        "right": {"type": "spring", "points": ["P4", "P0"], "stiffness": 3.0, "free_length": 1.3},
        "long": {"type": "spring", "points": ["P4", "P3"], "stiffness": 0.5, "free_length": 0.0},
    }
    return mechanism(
        "free", dimension, gravity=False, points=points,
        bodies={"bar": {"type": "bar", "points": ["P0", "P1"], "mass": 1.2}},
        joints=rods([("P0", "P2"), ("P1", "P2"), ("P2", "P4")]), forces=springs,
    )  # fmt: skip


def tethered(law: Content, dimension: int = 3, *, gravity: bool = False) -> Content:
    """A point of 2 kg that flies past the origin, tied to it by one force."""
    points = {
        "A": {
            "position": [0.6, -0.5, 0.4][:dimension],
            "velocity": [0.3, 1.0, -0.7][:dimension],
            "mass": 2.0,
        }
    }
    tie = law | {"points": ["ground", "A"], "at": [0.0] * dimension}
    return mechanism("tethered", dimension, gravity=gravity, points=points, forces={"tie": tie})


def turning_bar(dimension: int, torque: Any, *, pivoted: bool = True) -> Content:
    """A uniform bar of 1.2 kg and 2 m at rest along x, on a pivot or free, with a torque."""
    zero = [0.0] * dimension
    points = {"O": {"position": zero}, "A": {"position": [2.0, *zero[1:]]}}
    points["O"]["fixed"] = pivoted
    bar = {"type": "bar", "points": ["O", "A"], "mass": 1.2}
    motor = {"type": "torque", "body": "bar", "value": torque}
    return mechanism(
        "turning", dimension, gravity=False, points=points, bodies={"bar": bar},
        forces={"motor": motor},
    )  # fmt: skip
