"""Our own runs of the stability maps, watched on the way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import solver
from benchmarks.problems.stability_cases import Case
from benchmarks.sections.stability_rules import Outcome, steps, stride
from solver.paper_scenes import run as moved
from solver.runtime import Integrator, Model, StepError

ENERGY = ("energy.kinetic", "energy.potential", "energy.work")
LEDGER = (*ENERGY, "constraint.position", "solver.substeps", "solver.newton_iterations")
FINE = 2e-3
"""Step [s] with which the reference energy is found."""


@dataclass(frozen=True, slots=True)
class Ready:
    """A case with its model, its length in time [s] and its reference energy [J]."""

    case: Case
    model: Model
    stop: float
    reference: float
    """Largest kinetic energy of the motion."""


def prepare(case: Case, stop: float) -> Ready:
    """Assemble a case and take its reference energy from a run with short steps of the default."""
    model = solver.assemble(case.drawn)
    integrator = _started(model, FINE)
    kinetic = float(integrator["energy.kinetic"])
    for _ in range(max(1, round(stop / (10 * FINE)))):
        integrator.advance(integrator.time, 10 * FINE)
        kinetic = max(kinetic, float(integrator["energy.kinetic"]))
    return Ready(case, model, stop, kinetic)


def _started(model: Model, h: float) -> Integrator:
    integrator = Integrator(model, log=lambda _: None)  # errors are measured below
    integrator["solver.step_size"] = h
    integrator.initialise()
    return integrator


def run(ready: Ready, h: float) -> Outcome:
    """Pairs of half steps over h [s] until the end, or until one is lost or divided."""
    integrator = _started(ready.model, h)
    places = [ready.model.index(name) for name in LEDGER]
    outcome, count, taken, iterations = Outcome(), steps(ready.stop, h), 0, 0.0
    before = sum(map(float, integrator.get(places[:2])))
    while taken < count and not outcome.end:
        more = min(stride(count), count - taken)
        try:
            integrator.advance(integrator.time, more * h)
            values = map(float, integrator.get(places))
        except StepError:
            outcome.end = f"a step failed after {integrator.time:.3g} s"
            break
        kinetic, potential, work, constraint, substeps, newton = values
        taken, iterations = taken + more, iterations + newton
        energy = (kinetic + potential - work - before) / ready.reference
        if outcome.see(energy, constraint, integrator.time) and substeps != 2 * more:
            outcome.end = f"a step was divided before {integrator.time:.3g} s"
    outcome.newton = iterations / (2 * max(taken, 1))
    return outcome


def run_by_paper(ready: Ready, h: float, **method: Any) -> Outcome:
    """Steps of h [s] by `solver.paper` until the end, or until one is lost or fails."""
    integrator = Integrator(ready.model, log=lambda _: None)
    integrator["solver.step_size"] = h
    places = [ready.model.index(name) for name in LEDGER[:4]]
    outcome, count, moments, before = Outcome(), steps(ready.stop, h), [], 0.0
    times = [h * k for k in (*range(0, count, stride(count)), count)]
    try:
        for row in moved(integrator, times, places, moments, **method):
            kinetic, potential, work, constraint = map(float, row)
            before = kinetic + potential if len(moments) == 1 else before
            energy = (kinetic + potential - work - before) / ready.reference
            if not outcome.see(energy, constraint, integrator.time):
                break
    except StepError:
        outcome.end = f"a step failed after {integrator.time:.3g} s"
    newton = [at.iterations[-1].newton for at in moments[1:]]
    outcome.newton = sum(newton) / max(1, len(newton))
    return outcome
