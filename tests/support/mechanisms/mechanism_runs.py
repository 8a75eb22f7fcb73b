"""Runs of the mechanisms in `scenes/` for the tests."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

import solver
from tests.support.mechanisms.reduced_models import Array

SCENES = Path(__file__).resolve().parents[3] / "scenes"


def scene(name: str) -> Path:
    """File of a scene."""
    return SCENES / f"{name}.toml"


def steps_explicitly(integrator: solver.Integrator) -> bool:
    """Whether the last internal step was explicit: such a step leaves no half steps."""
    return integrator.state.head["halves"] == 0.0


def run(
    mechanism: str | solver.Scene | Path,
    names: Sequence[str],
    h: float,
    stop: float,
    *,
    every: float | None = None,
    **settings: float | str | bool,
) -> Array:
    """Values (n, len(names)) at communication points, `every` s or at the end alone.

    `mechanism` is a name in `scenes/`, a file or a scene; `h` [s] the internal step.
    """
    found = solver.simulate(
        scene(mechanism) if isinstance(mechanism, str) else mechanism,
        stop_time=stop, step_size=every or stop, outputs=list(names), internal_step=h, **settings,
    )  # fmt: skip
    return found.table


def extrapolated(
    mechanism: str | solver.Scene | Path,
    names: Sequence[str],
    h: float,
    stop: float,
    *,
    every: float | None = None,
) -> Array:
    """Values as of `run` for h -> 0, by Richardson from h and h/2 for a method of order two."""
    coarse, fine = (run(mechanism, names, step, stop, every=every) for step in (h, h / 2))
    return (4 * fine - coarse) / 3


def vector(name: str, quantity: str = "", axes: str = "xyz") -> list[str]:
    """Names of a vector's components: `vector("A", "v")` is A.vx, A.vy, A.vz."""
    return [f"{name}.{quantity}{axis}" for axis in axes]


def times(stop: float, every: float) -> Array:
    """Communication points of a run."""
    return np.arange(round(stop / every) + 1) * every
