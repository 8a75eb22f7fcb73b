"""A short run of a model while its FMU is built: how large its values become, and how exact it is.

What it may cost is bounded by a count of unknowns, not by a clock: equal models get equal archives.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from build_fmu.jumps import jumps
from build_fmu.motion import RESIDUAL, Poses, lag_of_velocities, largest_by_unit, losses
from solver.options import LEAST_TOLERANCE, step_of, tolerance_of
from solver.runtime import AssemblyError, Integrator, OptionError, StepError
from solver.runtime.errors import in_one_line

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from solver.runtime import Model

MOST_WORK = 300_000
"""Unknowns times internal steps: some 50 ms."""
MANY = 1000
"""Unknowns above which a run is not what building a model may cost."""
MOST_ITERATIONS = 100_000
"""Unknowns times Newton iterations of a model of many: some 40 ms."""
MOST_LOOKS = 100
"""Communication steps: after each all outputs are read."""
AT_REST = 1e-6
"""A largest value, in its unit, below which nothing tells how large it is when it moves."""


@dataclass(frozen=True)
class SelfCheck:
    """What was seen of a run.

    Attributes
    ----------
    duration : float
        Length of the run [s].
    reason : str
        Why it ended early; empty where it did not.
    energy, constraint : float
        Largest of the outputs energy.error and constraint.position.
    moved : bool
        Whether any position or orientation changed.
    is_large : bool
        Whether the model has too many unknowns for a second, finer run.
    position_error, rotation_error : float or None
        Largest difference of a coordinate [m], and of an angle or orientation [rad], from a run
        that is more exact, at all times of the run; None where there is no such run, or nothing
        that turns.
    largest : mapping of str to float
        Largest size of what moves, by unit.
    is_explicit : bool
        Whether any step was explicit.
    taken : mapping of str to float
        Energy that each cause has taken out until the end [J], of a mechanism with contacts or
        friction.
    remarks : tuple of str
        What it said of itself: that dampers limit the order, for one.
    """

    duration: float
    reason: str = ""
    energy: float = 0.0
    constraint: float = 0.0
    moved: bool = True
    is_large: bool = False
    position_error: float | None = None
    rotation_error: float | None = None
    largest: Mapping[str, float] = field(default_factory=dict)
    is_explicit: bool = False
    taken: Mapping[str, float] = field(default_factory=dict)
    remarks: tuple[str, ...] = ()

    @property
    def nominal(self) -> dict[str, float]:
        """Nominal value by unit: the power of ten next to the largest value; none of what rests."""
        moving = {unit: x for unit, x in self.largest.items() if x > AT_REST}
        return {unit: float(f"1e{round(math.log10(x))}") for unit, x in moving.items()}


def self_check(model: Model) -> SelfCheck:
    """Run the default experiment, or as much of it as is cheap."""
    duration, steps = _extent(model)
    outputs = [v for v in model.variables if v.causality == "output"]
    names, poses = [v.name for v in outputs], Poses({v.name: v.unit for v in outputs})
    said: list[str] = []
    integrator = Integrator(model, log=said.append)
    rows, reason = _run(integrator, duration, steps, names)
    sizes = dict(zip(names, abs(rows).max(axis=0, initial=0.0).tolist(), strict=True))
    column = {name: k for k, name in enumerate(names)}
    motion = rows[:, [column[name] for name in poses.names]]
    apart = None if reason else _apart(model, duration, steps, poses, motion)
    largest = largest_by_unit({v.name: v.unit for v in outputs}, sizes)
    said += filter(
        None, [lag_of_velocities(sizes.get(RESIDUAL, 0.0), largest, lambda: jumps(model))]
    )
    return SelfCheck(
        duration=integrator.time - model.experiment.start_time,
        reason=reason,
        energy=sizes.get("energy.error", 0.0),
        constraint=sizes.get("constraint.position", 0.0),
        moved=poses.moved(motion),
        is_large=_unknowns(model) > MANY,
        position_error=apart and apart[0],
        rotation_error=apart[1] if apart and poses.turn else None,
        largest=largest,
        is_explicit=sizes.get("solver.method_in_use", 0.0) > 1.0,
        taken=losses(dict(zip(names, rows[-1].tolist(), strict=True))) if len(rows) else {},
        remarks=tuple(said),
    )


def _extent(model: Model) -> tuple[float, int]:
    """Length of the run [s] and its communication steps."""
    start, stop, communication, _ = model.experiment
    internal = min(step_of(model.settings), communication)
    affordable = max(1.0, MOST_WORK / _unknowns(model)) * internal
    duration = min(stop - start, affordable, MOST_LOOKS * communication)
    steps = max(1, math.ceil(duration / communication * (1.0 - 1e-9)))
    return duration, steps


def _unknowns(model: Model) -> int:
    return model.sizes["dim"] * model.sizes["n_free"] + model.sizes["n_rows"] + 1


def _run(
    integrator: Integrator, duration: float, steps: int, names: Sequence[str]
) -> tuple[NDArray[np.float64], str]:
    """Run; values by time and name, and why it ended early."""
    start, rows, reason = integrator.model.experiment.start_time, [], ""
    unknowns, iterations = _unknowns(integrator.model), 0.0
    indices = [integrator.model.index(name) for name in names]
    try:
        integrator.initialise(start)
        rows.append(np.array(integrator.get(indices), float))
        for k in range(steps):
            integrator.advance(
                integrator.time, start + (k + 1) * duration / steps - integrator.time
            )
            rows.append(np.array(integrator.get(indices), float))
            iterations += float(integrator["solver.newton_iterations"])
            if unknowns > MANY and unknowns * iterations > MOST_ITERATIONS:
                break
    except (AssemblyError, OptionError, StepError) as error:
        reason = in_one_line(error)
    return np.array(rows).reshape(len(rows), len(names)), reason


def _apart(
    model: Model, duration: float, steps: int, poses: Poses, coarse: NDArray[np.float64]
) -> tuple[float, float] | None:
    """Differences of positions [m] and rotations [rad] from a run with half the internal step.

    With a tolerance it has a hundredth: steps for half of it are often the same.
    """
    if _unknowns(model) > MANY:
        return None
    fine = Integrator(model, log=lambda _: None)  # the coarse one has said it
    settings = model.settings
    if tolerance := tolerance_of(settings):
        fine["solver.tolerance"] = max(0.01 * tolerance, LEAST_TOLERANCE)
    else:
        longest = min(step_of(settings), duration / steps)
        fine["solver.step_size"] = 0.5 * longest
    motion, reason = _run(fine, duration, steps, poses.names)
    return None if reason else poses.apart(coarse, motion)
