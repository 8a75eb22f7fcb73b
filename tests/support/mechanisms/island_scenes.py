"""Scenes of several mechanisms side by side."""

from __future__ import annotations

from typing import Any

from solver.runtime import Integrator, Model
from tests.support.mechanisms.problems import Content, assemble, double_pendulum, pendulum

H = 0.01


def assembled(content: Content, **settings: Any) -> Model:
    return assemble(content, **({"step_size": H} | settings))


def beside(*contents: Content, **more: Any) -> Content:
    """One scene of several, the names of their parts with the number of each behind them."""
    joined: Content = {table: {} for table in ("points", "joints", "bodies", "forces")}
    for number, content in enumerate(contents):
        for table, parts in joined.items():
            for name, part in content.get(table, {}).items():
                parts[f"{name}_{number}"] = renamed = dict(part)
                for key in part.keys() & {"point", "body"}:
                    renamed[key] = f"{part[key]}_{number}"
                if "points" in part:
                    renamed["points"] = [f"{end}_{number}" for end in part["points"]]
    return contents[0] | joined | more


def driven(content: Content, *numbers: int) -> Content:
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
