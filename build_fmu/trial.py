"""A short run of a model while its FMU is built: how large its values become, and how exact it is.

What it may cost is bounded by a count of unknowns, not by a clock: equal models get equal archives.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from solver.runtime import AssemblyError, Integrator, OptionError, StepError
from solver.runtime.errors import in_one_line

if TYPE_CHECKING:
    from solver.runtime import Model

MOST_WORK = 300_000
"""Unknowns times internal steps: some 50 ms."""
MOST_LOOKS = 100
"""Communication steps: after each all outputs are read."""
FEWEST = 10
"""Internal steps that the work must allow for a second, finer run."""
AT_REST = 1e-6
"""A largest value, in its unit, below which nothing tells how large it is when it moves."""
OF_THE_SOLUTION = ("energy.balance", "energy.error", "constraint.", "solver.")
"""Beginnings of the names of outputs that say how exact a run is, not how it moves."""


@dataclass(frozen=True)
class Trial:
    """What was seen of a run.

    Attributes
    ----------
    duration : float
        Length of the run [s].
    reason : str
        Why it ended early; empty where it did not.
    energy, constraint : float
        Largest of the outputs energy.error and constraint.position.
    convergence : float or None
        Largest difference of a coordinate [m] at the end from a run that is twice as exact.
    largest : mapping of str to float
        Largest size of what moves, by unit.
    remarks : tuple of str
        What it said of itself: that dampers limit the order, for one.
    """

    duration: float
    reason: str = ""
    energy: float = 0.0
    constraint: float = 0.0
    convergence: float | None = None
    largest: Mapping[str, float] = field(default_factory=dict)
    remarks: tuple[str, ...] = ()

    @property
    def nominal(self) -> dict[str, float]:
        """Nominal value by unit: the power of ten next to the largest value; none of what rests."""
        moving = {unit: x for unit, x in self.largest.items() if x > AT_REST}
        return {unit: float(f"1e{round(math.log10(x))}") for unit, x in moving.items()}


def trial(model: Model) -> Trial:
    """Run the default experiment, or as much of it as is cheap."""
    duration, steps = _extent(model)
    outputs = [i for i, v in enumerate(model.variables) if v.causality == "output"]
    sizes = dict.fromkeys(outputs, 0.0)
    said: list[str] = []
    integrator = Integrator(model, log=said.append)
    reason = _run(integrator, duration, steps, sizes)
    by_name = {model.variables[i].name: size for i, size in sizes.items()}
    return Trial(
        duration=integrator.time - model.experiment.start_time,
        reason=reason,
        energy=by_name.get("energy.error", 0.0),
        constraint=by_name.get("constraint.position", 0.0),
        convergence=None if reason else _convergence(model, integrator, duration, steps),
        largest=_by_unit(model, sizes),
        remarks=tuple(said),
    )


def _extent(model: Model) -> tuple[float, int]:
    """Length of the run [s] and its communication steps."""
    start, stop, communication, _ = model.experiment
    internal = min(float(model.settings["step_size"]), communication)
    affordable = max(1.0, MOST_WORK / _unknowns(model)) * internal
    duration = min(stop - start, affordable, MOST_LOOKS * communication)
    steps = max(1, math.ceil(duration / communication * (1.0 - 1e-9)))
    return duration, steps


def _unknowns(model: Model) -> int:
    return model.sizes["dim"] * model.sizes["n_free"] + model.sizes["n_rows"] + 1


def _run(integrator: Integrator, duration: float, steps: int, sizes: dict[int, float]) -> str:
    """Run, keep the largest size of each output in `sizes`, and return why it ended early."""
    start = integrator.model.experiment.start_time
    try:
        integrator.initialise(start)
        _keep_largest(integrator, sizes)
        for k in range(steps):
            integrator.advance(
                integrator.time, start + (k + 1) * duration / steps - integrator.time
            )
            _keep_largest(integrator, sizes)
    except (AssemblyError, OptionError, StepError) as error:
        return in_one_line(error)
    return ""


def _keep_largest(integrator: Integrator, sizes: dict[int, float]) -> None:
    for index, value in zip(sizes, integrator.get(list(sizes)), strict=True):
        if abs(value) > sizes[index]:  # type: ignore[arg-type]
            sizes[index] = abs(value)  # type: ignore[arg-type]


def _convergence(model: Model, coarse: Integrator, duration: float, steps: int) -> float | None:
    """Largest difference of a coordinate at the end [m], in a run that is twice as exact."""
    if FEWEST * _unknowns(model) > MOST_WORK:
        return None
    fine = Integrator(model, log=lambda _: None)  # the coarse one has said it
    settings = model.settings
    if settings["tolerance"]:
        fine["solver.tolerance"] = max(0.5 * float(settings["tolerance"]), 1e-14)
    else:
        longest = min(float(settings["step_size"]), duration / steps)
        fine["solver.step_size"] = 0.5 * longest
    if _run(fine, duration, steps, {}):
        return None
    places = _coordinates(model)
    pairs = zip(coarse.get(places), fine.get(places), strict=True)
    return max((abs(a - b) for a, b in pairs), default=0.0)  # type: ignore[operator]


def _coordinates(model: Model) -> Sequence[int]:
    """Variables that are coordinates of points and bodies."""
    ends = (".x", ".y", ".z")
    variables = enumerate(model.variables)
    return [i for i, v in variables if v.unit == "m" and v.name.endswith(ends)]


def _by_unit(model: Model, sizes: Mapping[int, float]) -> dict[str, float]:
    largest: dict[str, float] = {}
    for index, size in sizes.items():
        variable = model.variables[index]
        if variable.unit and not variable.name.startswith(OF_THE_SOLUTION):
            largest[variable.unit] = max(largest.get(variable.unit, 0.0), size)
    return dict(sorted(largest.items()))
