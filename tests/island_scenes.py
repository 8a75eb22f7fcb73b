"""Scenes of several mechanisms side by side."""

from __future__ import annotations

import json

import solver
from solver.runtime import Integrator, Model
from tests.problems import double_pendulum, pendulum

H = 0.01
MASS, GRAVITY = 1.0, 9.81


def assembled(content: dict, **settings) -> Model:
    text = json.dumps(content | {"solver": {"step_size": H} | settings})
    return solver.assemble(solver.loads(text, name="islands.json", format="json"))


def beside(*contents: dict, **more) -> dict:
    """One scene of several, their names with the number of each behind them."""
    first, joined = contents[0], {"points": {}, "joints": {}}
    for k, content in enumerate(contents):
        for name, point in content["points"].items():
            joined["points"][f"{name}_{k}"] = dict(point)
        for name, joint in content["joints"].items():
            ends = [f"{point}_{k}" for point in joint["points"]]
            joined["joints"][f"{name}_{k}"] = joint | {"points": ends}
    return first | joined | more


def driven(content: dict, *numbers: int) -> dict:
    """The scene with the supports of some of its parts as points that move."""
    for k in numbers:
        del content["points"][f"O_{k}"]["fixed"]
    return content


def started(model: Model) -> Integrator:
    integrator = Integrator(model)
    integrator.initialise()
    return integrator


HANGING = pendulum(0.0)
SWINGING = double_pendulum(0.5)
