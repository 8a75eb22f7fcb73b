"""Repeats the same steps of a mechanism, so that they can be timed."""

from __future__ import annotations

from pathlib import Path

import solver
from benchmarks.measuring.timing import Entry, Times
from benchmarks.pages.report import Value
from solver.options import USUAL_STEP, tolerance_of
from solver.runtime import Integrator, StepError

WARM_UP = 20


def in_equal_steps(path: Path) -> solver.Scene:
    """Scene of a file; in equal steps of `USUAL_STEP` where it chooses none."""
    scene = solver.load(path)
    if scene.solver.tolerance or not tolerance_of(vars(scene.solver)):
        return scene
    return solver.load(path, {"solver.step_size": USUAL_STEP})


class Repeated:
    """`count` internal steps of length `h` [s], always the same ones, behind a few that warm up.

    The integrator's setting ``step_size`` must be `h`. `solves` is the number of implicit solves
    among the steps, `newton_per_solve` their average number of Newton iterations; `halved` says
    that some had to be divided, `failure` why one could not be solved (None if all were); `energy`
    and `constraint` are the errors at the end.
    """

    def __init__(
        self, integrator: Integrator, h: float, count: int, warm_up: int = WARM_UP
    ) -> None:
        self.integrator, self.count, self._length = integrator, count, count * h
        self.solves = 2 * count
        self.newton_per_solve = 0.0
        self.halved = False
        self.failure: str | None = None
        try:
            if warm_up:
                integrator.advance(integrator.time, warm_up * h)
            self._state = integrator.save()
            self._run()
            self._count()
            self.energy, self.constraint = (
                float(integrator[name]) for name in ("energy.error", "constraint.position")
            )
        except StepError as error:
            self.failure = str(error)

    def row(self, times: Times | None) -> dict[str, Value]:
        """What is told of the steps: µs per inner step, iterations, errors at the end, noise.

        There are no times where a step failed.
        """
        if times is None:
            return {"remark": "a step failed"}
        return {
            "solve": 1e6 * times.minimum / self.solves,
            "newton": self.newton_per_solve,
            "energy": self.energy,
            "constraint": self.constraint,
            "noise": times.noise,
            "remark": "some steps halved" if self.halved else "",
        }

    @property
    def entry(self) -> Entry:
        """The steps, and the way back to where they begin."""
        return Entry(self._run, self._restore)

    def _run(self) -> None:
        self.integrator.advance(self.integrator.time, self._length)

    def _restore(self) -> None:
        self.integrator.restore(self._state)

    def _count(self) -> None:
        substeps = float(self.integrator["solver.substeps"])
        self.newton_per_solve = float(self.integrator["solver.newton_iterations"]) / substeps
        self.halved = substeps != self.solves
