"""Exudyn on the mechanisms of the stability maps, watched from outside.

Runs where the package `exudyn` is, without anything of holonom.
"""

from __future__ import annotations

from typing import Any

import exudyn as exu
import numpy as np

from benchmarks.peers.exudyn_problem import ALPHA, KINDS, TRAPEZOIDAL, Build
from benchmarks.problems.catalogue import MAPS
from benchmarks.problems.parts import energies
from benchmarks.sections.stability_rules import Outcome, steps, stride

METHODS = {
    "generalized alpha, 0.9": ALPHA,
    "generalized alpha, 0.5": (KINDS.GeneralizedAlpha, 0.5),
    "trapezoidal, index 2": TRAPEZOIDAL,
}
NEWTON = 50
"""Iterations of a step, at most: twice what Exudyn allows by itself."""


class Watch:
    """Energy of a system [J] and the largest violation of its constraints [m], from outside."""

    def __init__(self, build: Build) -> None:
        self.build, system = build, build.system
        parts = [system.GetObject(i) for i in range(system.systemData.NumberOfObjects())]
        self.pairs = [
            (p["markerNumbers"], float(p.get("distance", 0.0)))
            for p in parts
            if "Joint" in p["objectType"] or p["objectType"] == "ConnectorDistance"
        ]

    def energy(self) -> float:
        """Kinetic energy and that of gravity and springs [J]."""
        return float(energies(self.build.problem, self.build.now)[0])

    def violation(self) -> float:
        """Largest distance [m] by which two points of a joint are too far from each other."""
        read, kind = self.build.system.GetMarkerOutput, exu.OutputVariableType.Position
        gaps = ((read(b, kind) - read(a, kind), length) for (a, b), length in self.pairs)
        return max(abs(float(np.linalg.norm(gap)) - length) for gap, length in gaps)


class ChainWatch(Watch):
    """The same of the chain without gravity, from all coordinates at once."""

    def __init__(self, build: Build) -> None:
        super().__init__(build)
        data = build.system.systemData
        self.reference = np.array(data.GetODE2Coordinates(exu.ConfigurationType.Reference))

    def energy(self) -> float:
        """Kinetic energy [J]."""
        v = np.array(self.build.system.systemData.GetODE2Coordinates_t())
        return 0.05 * float(v @ v)

    def violation(self) -> float:
        """Largest error of a rod's length [m]."""
        data = self.build.system.systemData
        q = (self.reference + np.array(data.GetODE2Coordinates())).reshape(-1, 3)
        rods = np.diff(q, axis=0, prepend=np.zeros((1, 3)))
        return float(np.max(np.abs(np.linalg.norm(rods, axis=1) - 0.1)))


def run(
    mechanism: str, size: list[float], method: str, h: float, case: dict[str, float]
) -> Outcome:
    """Take steps of h [s] until `case["stop"]`, watched on the way."""
    build = Build(MAPS[mechanism](*size))
    watch = (ChainWatch if mechanism == "chain" else Watch)(build)
    outcome, before = Outcome(), watch.energy()
    count, taken = steps(case["stop"], h), 0

    def after_step(_: Any, t: float) -> bool:
        nonlocal taken
        taken += 1
        if taken % stride(count) and taken < count:
            return True
        energy = (watch.energy() - before) / case["reference"]
        return outcome.see(energy, watch.violation() / case["length"], t)

    build.system.SetPostStepUserFunction(after_step)
    try:
        build.solve(count, count * h, METHODS[method], iterations=NEWTON)
    except ArithmeticError as error:
        outcome.end = outcome.end or str(error) or "a step failed"
    outcome.newton = build.newton / count
    return outcome
