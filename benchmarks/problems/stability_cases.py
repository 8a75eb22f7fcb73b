"""The mechanisms of the stability maps, as scenes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import solver
from benchmarks.problems.mechanisms import GRAVITY, Content, four_bar, scene, waving_chain

SCENES = Path(__file__).resolve().parents[2] / "scenes"
STIFFNESSES = (1e2, 1e4, 1e6, 1e8, 1e12)


@dataclass(frozen=True, slots=True)
class Case:
    """A mechanism, how long it runs [s], and the length of its links [m]."""

    name: str
    drawn: solver.Scene
    stop: float
    length: float
    size: Sequence[float] = ()
    """What the peers' model of this name is built with."""
    on_paper: bool = True
    """Whether `solver.paper` takes it."""
    penalties: bool = False
    """Whether it is tried with several penalties."""
    stiffness: float | None = None
    """Of its spring [N/m]."""


def elastic_pendulum(stiffness: float) -> Content:
    """Two unit masses from the horizontal: one on a spring of 1 m, the other on a rod behind it."""
    points = {
        "A": {"position": [1.0, 0.0], "mass": 1.0},
        "B": {"position": [2.0, 0.0], "mass": 1.0},
    }
    tie = {"type": "spring", "points": ["ground", "A"], "at": [0, 0]}
    return {
        "name": "elastic",
        "dimension": 2,
        "gravity": [0.0, -GRAVITY],
        "experiment": {"stop_time": 10.0, "step_size": 10.0},
        "points": points,
        "joints": {"rod": {"type": "distance", "points": ["A", "B"], "length": 1.0}},
        "forces": {"tie": tie | {"stiffness": stiffness, "free_length": 1.0}},
    }


def chain(n: int, stop: float = 1.0) -> Case:
    """Chain of points: `waving_chain` of `benchmarks.problems.mechanisms`, in space."""
    return Case("chain", scene(waving_chain(n, 3)), stop, 0.1, (n,), penalties=True)


def maps() -> list[Case]:
    """Mechanisms of the maps, in their order."""
    springs = [
        Case("stiff spring", scene(elastic_pendulum(k)), 10.0, 1.0, (k,), stiffness=k)
        for k in STIFFNESSES
    ]
    return [
        chain(10),
        Case("four-bar", scene(four_bar(2)), 10.0, 1.0, penalties=True),
        Case("bricard", solver.load(SCENES / "bricard.toml"), 10.0, 1.0),
        Case("car axis", solver.load(SCENES / "car_axis.toml"), 3.0, 1.0, on_paper=False),
        *springs,
    ]
