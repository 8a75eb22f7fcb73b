"""A small system with right values that this project did not compute, and its error in a run."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

import solver

Array = NDArray[np.float64]
Values = Mapping[str, Array]

WRONG = (AssertionError, solver.SceneError, solver.StepError)
"""What a check that fails may raise; all else is a mistake of the corpus."""
TOLERANCES = ("1e-4", "1e-6", "1e-8")
FASTEST = tuple(f"fastest {tolerance}" for tolerance in TOLERANCES)
BEYOND_TOLERANCE = 3.0
"""Largest error over the tolerance that a run may have."""
BY_DEFAULT = 3e-4
"""Largest error of a run without settings, of size and speed."""
ROUND_OFF = 1e-11
"""Errors below this are round-off of a run, which no order lowers."""
OF_ORDER = 0.7
"""Least part of 2^order by which half the step lowers the error; the order is a limit of h -> 0."""

LENGTHS = ("x", "y", "z", "displacement", "length", "gap")
ANGLES = ("angle", "qw", "qx", "qy", "qz")
SPEEDS = ("vx", "vy", "vz", "velocity", "slip")
TURNS = ("angular_velocity", "wx", "wy", "wz")
COUNTS = ("impacts", "mode", "friction_mode")


def kind_of(name: str) -> str:
    """Kind of a variable: what its errors are measured by."""
    last = name.split(".")[-1]
    if ".force" in name or name.startswith("momentum"):
        return "force" if ".force" in name else "momentum"
    if ".torque" in name or "angular_momentum" in name:
        return "torque"
    if last in COUNTS:
        return "count"
    if last in ("power", "impulse", "multiplier"):
        return last
    kinds = {"length": LENGTHS, "angle": ANGLES, "speed": SPEEDS, "turn": TURNS}
    for kind, endings in kinds.items():
        if last in endings:
            return kind
    return "energy" if name.startswith("energy.") else name if "." not in name else "force"


@dataclass(frozen=True, kw_only=True)
class System:
    """A mechanism, its run and its right values.

    Errors are over the largest right value of their kind in the run: lengths, speeds, turns,
    forces, torques. Errors of angles are in rad, those of modes and impacts in numbers.
    """

    name: str
    kind: str
    """Of motion: what the page lists it under."""
    origin: str
    """Where the right values come from: closed form, DOP853 in which coordinates, published."""
    scene: str | Mapping[str, object]
    """TOML or tables, without a name and settings that choose steps."""
    stop: float
    """End of the run [s]."""
    right: Callable[[Array], Values]
    """Values (n,) by name of variable at the times (n,) [s]."""
    points: int = 10
    """Communication steps of the run."""
    orders: Sequence[int] = (2, 4)
    """Orders of equal steps that are judged."""
    internal_step: float = 0.01
    """The longer of two equal steps by which an order is judged [s]."""
    scale: Mapping[str, float] = field(default_factory=dict)
    """What errors of a kind are measured by where it is not the largest right value."""
    settings: Mapping[str, float | str | bool] = field(default_factory=dict)
    """Settings of the solver in each run, such as assemble."""
    inputs: Mapping[str, object] = field(default_factory=dict)
    bounds: Mapping[str, float] = field(default_factory=dict)
    """Largest error of a check where it is not the general one; `reason` says why."""
    reason: str = ""
    fails: Mapping[str, int] = field(default_factory=dict)
    """Checks that fail today, each with the number of the issue that mends it."""

    def times(self) -> Array:
        """Communication points of the run [s]."""
        return np.linspace(0.0, self.stop, self.points + 1)

    def read(self) -> solver.Scene:
        """Scene as read."""
        if isinstance(self.scene, str):
            return solver.loads(f'name = "{self.kind}"\n{self.scene}')
        return solver.loads(json.dumps({"name": self.kind, **self.scene}), format="json")

    def error(self, right: Values, **settings: float | str | bool) -> float:
        """Largest error of a run at its communication points, over the scale of its kind."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # errors are judged here, not what a run says of itself
            found = solver.simulate(
                self.read(), stop_time=self.stop, step_size=self.stop / self.points,
                outputs=list(right), inputs=self.inputs, **{**self.settings, **settings},
            )  # fmt: skip
        scales = self.scales(right)
        errors = [np.abs(found[x] - right[x]).max() / scales[kind_of(x)] for x in right]
        return float(np.max(errors))  # NaN stays NaN, which Python's max may drop

    def scales(self, right: Values) -> dict[str, float]:
        """What errors of each kind are measured by."""
        largest: dict[str, float] = {}
        for name, values in right.items():
            kind = kind_of(name)
            largest[kind] = max(largest.get(kind, 0.0), float(np.abs(values).max()))
        stands = {kind: value or 1.0 for kind, value in largest.items()}
        return {**stands, "angle": 1.0, "count": 1.0, **self.scale}


def marked(systems: Sequence[System], fails: Mapping[str, Mapping[str, int]]) -> tuple[System, ...]:
    """Systems with the checks that each fails today, by name, and the issues that mend them."""
    assert fails.keys() <= {system.name for system in systems}
    return tuple(replace(system, fails=fails.get(system.name, {})) for system in systems)
