"""A run under stress and what became of it: kept, refused with a sentence, or wrong."""

from __future__ import annotations

from dataclasses import dataclass

import solver
from solver.runtime import AssemblyError, Integrator, StepError

ENERGY, CONSTRAINT = 1e-10, 1e-12
"""A run is kept while `energy.error` and `constraint.position` are below: round-off of a hundred
steps is 1e-14; nearly dependent rows and springs of 1e12 N/m multiply it."""


@dataclass(slots=True)
class Found:
    """Largest errors of a run, its effort, and the solver's sentence where it refused to go on."""

    energy: float = 0.0
    constraint: float = 0.0
    newton: float = 0.0
    """Newton iterations per solve."""
    divided: float = 1.0
    """Implicit solves over those asked for."""
    refused: str = ""

    @property
    def outcome(self) -> str:
        """In a word; a run that was refused is wrong, too, if it was before. NaN is wrong."""
        if not (self.energy <= ENERGY and self.constraint <= CONSTRAINT):
            return "wrong"
        if self.refused:
            return "refused"
        return "kept" if self.divided <= 1.0 else "kept, some steps divided"


def run(text: str, h: float, count: int) -> Found:
    """Take `count` pairs of half steps of a scene, h [s] each, and look after every one."""
    form = "json" if text.startswith("{") else "toml"
    model = solver.assemble(solver.loads(text, format=form))
    integrator = Integrator(model, log=lambda _: None)  # errors are measured below
    integrator["solver.step_size"] = h
    found, solves, iterations, taken = Found(), 0.0, 0.0, 0
    try:
        integrator.initialise()
        while taken < count:
            integrator.advance(integrator.time, h)
            taken += 1
            # A value that is not finite raises a StepError where it is read.
            found.energy = max(found.energy, float(integrator["energy.error"]))
            position = float(integrator["constraint.position"])
            found.constraint = max(found.constraint, position)
            solves += float(integrator["solver.substeps"])
            iterations += float(integrator["solver.newton_iterations"])
    except (AssemblyError, StepError) as error:
        found.refused = str(error)
    found.newton = iterations / max(solves, 1.0)
    found.divided = solves / (2.0 * taken) if taken else 1.0
    return found
