"""A second run of an FMU, with a tenth of its tolerance or less, or half of its equal steps."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from build_fmu.accuracy import Comparison, Difference, Verdict, of_a_tolerance, of_equal_steps
from build_fmu.errors import CommandError, UnfinishedError
from build_fmu.instance import description_of
from build_fmu.study.settings import fmu_settings
from build_fmu.target import fmu_model
from solver.options import OPTIONS, step_of, tolerance_of
from solver.runtime import AssemblyError, Integrator, OptionError, StepError

if TYPE_CHECKING:
    from build_fmu.run import Run
    from build_fmu.study.values import Entry
    from solver.runtime import Model

ORDER_OF_STEPPED = 1.0
"""Of contacts that are stepped: an impact moves to a half step."""


FEW = 1e-2
"""Part of a tolerance: two runs that differ by less may have the same steps, and the same error."""


@dataclass(frozen=True)
class Accuracy:
    """What a finer run shows of a run.

    Attributes
    ----------
    finer : mapping of str to float
        What the finer run had: ``solver.step_size``, or ``solver.tolerance``.
    differences : sequence of Difference
        How far outputs are apart, by kind.
    verdict : Verdict
        Its error is NaN where the finer run did not come to its end.
    """

    finer: Mapping[str, float]
    differences: Sequence[Difference]
    verdict: Verdict


def accuracy(
    path: str, entries: Mapping[str, Entry], coarse: Run, again: Callable[[dict[str, float]], Run]
) -> Accuracy:
    """Run an FMU again, finer, and compare.

    Parameters
    ----------
    path
        The FMU.
    entries
        Values that the first run had.
    coarse
        The first run, which came to its end.
    again
        Runs it once more, with these settings of the solver.

    """
    try:
        return _measured(path, entries, coarse, again)
    except CommandError as error:
        sentence = f"how exact the path is was not measured: {error}"
        return Accuracy({}, (), Verdict(math.nan, sentence, is_warning=True))


def _measured(
    path: str, entries: Mapping[str, Entry], coarse: Run, again: Callable[[dict[str, float]], Run]
) -> Accuracy:
    """As `accuracy`; a CommandError where the FMU is of another version, or a run fails."""
    model = fmu_model(path)
    values = fmu_settings(description_of(path), [entries])[0]
    settings: dict[str, Any] = {
        name: values.get(f"solver.{name}", start) for name, start in model.settings.items()
    }
    times, tolerance = coarse.values["time"], tolerance_of(settings)
    size = _size(model, values, float(times[0]))
    units = {v.name: v.unit for v in model.variables if v.causality == "output"}

    def compared(finer: dict[str, float]) -> Comparison:
        fine = again(finer)
        if fine.failure:
            text = f"with {', '.join(f'{n} = {x:.3g}' for n, x in finer.items())} {fine.failure}"
            raise UnfinishedError(text)
        a, b = ({name: run.values[name] for name in units} for run in (coarse, fine))
        return Comparison(times, a, b, units, size)

    is_stepped = settings.get("contact_mode") == "stepped"
    if tolerance:
        settings["tolerance"] = tolerance
        finer = _tolerances(settings, 0.1)
        seen = compared(finer)
        if seen.path < FEW * tolerance:  # communication steps limit all steps, or most of them
            much_finer = _tolerances(settings, 1e-3)
            other = compared(much_finer)
            if other.path >= seen.path:
                finer, seen = much_finer, other
        tolerance += settings["absolute_tolerance"] / seen.size
        return Accuracy(finer, [*seen.differences.values()], of_a_tolerance(seen, tolerance))
    longest = float(np.diff(times).max())
    step = longest / max(1.0, math.ceil(longest / step_of(settings) * (1.0 - 1e-10)))
    finer = {"solver.step_size": 0.5 * step}
    seen = compared(finer)
    orders = coarse.values["solver.order_in_use"][1:]  # none before the first step
    order = ORDER_OF_STEPPED if is_stepped else float(orders.min())
    chosen = " and ".join(f"solver.{name}" for name in ("step_size", "order") if settings[name])
    other = "" if is_stepped else f"leave {chosen} out, so that steps follow the motion, or "
    return Accuracy(finer, [*seen.differences.values()], of_equal_steps(seen, order, step, other))


def _tolerances(settings: Mapping[str, Any], part: float) -> dict[str, float]:
    """Return a part of the tolerances that are set, but none that is too small."""
    names = [name for name in ("tolerance", "absolute_tolerance") if settings[name]]
    return {f"solver.{n}": max(part * settings[n], OPTIONS[n].least) for n in names}


def _size(model: Model, values: Mapping[str, Any], start: float) -> float:
    """Size of a mechanism with these values [m], which a tolerance refers to."""
    integrator = Integrator(model, log=lambda _: None)  # the run has said it
    try:
        for name, value in values.items():
            integrator[name] = value
        integrator.initialise(start)
    except (AssemblyError, OptionError, StepError):
        return 0.0  # inputs that change have no value yet, and the FMU was given them
    return float(integrator.numbers[model.offsets["extent"]])
