"""Our located contacts on problems with impacts, through the public interface.

A timed run is the whole motion in communication steps of a hundredth of it. For the times of
impacts it is repeated in communication steps of one internal step, and those in which the count of
impacts grows are bisected.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path

import solver
from benchmarks.contact.methods import Method, Setting
from benchmarks.contact.problems import Problem, Score, score
from benchmarks.measuring.timing import Entry
from benchmarks.peers.peer_methods import GaveUpError
from solver.runtime import Integrator, Model, StepError

CONTACTS = {"ball": "floor", "circle": "wall", "slider_crank": "wrist"}
COMMUNICATIONS = 100
ORDERS = (2, 4, 6)
DIVISIONS = (1, 2, 4, 8, 16, 32, 64, 128, 256)
"""Internal steps of a communication step."""
BISECTIONS = 50


@cache
def model(kind: str) -> Model:
    """The scene `<kind>.toml`, assembled."""
    path = Path(__file__).with_name(f"{kind}.toml")
    return solver.assemble(solver.loads(path.read_text(encoding="utf-8"), name=path.name))


class Run:
    """A problem with a setting, at its start."""

    def __init__(self, problem: Problem, setting: Setting) -> None:
        self.problem = problem
        self.period = problem.stop / COMMUNICATIONS
        self.h = self.period / setting["division"]
        self.integrator = Integrator(model(problem.kind), log=lambda _: None)
        self.integrator["restitution"] = problem.restitution
        self.integrator["solver.order"] = setting["order"]
        self.integrator["solver.step_size"] = self.h
        self.integrator.initialise()
        self._start = self.integrator.save()

    def reset(self) -> None:
        """Return to the start."""
        self.integrator.restore(self._start)

    def run(self) -> None:
        """Take all communication steps."""
        try:
            for _ in range(COMMUNICATIONS):
                self.integrator.advance(self.integrator.time, self.period)
        except StepError as error:
            raise GaveUpError(str(error)) from error

    def energy(self) -> float:
        """Kinetic and potential energy [J]."""
        return float(self.integrator["energy.kinetic"]) + float(self.integrator["energy.potential"])

    def scored(self) -> Score:
        """What the timed run loses, and when it hits."""
        before = self.energy()
        self.run()
        lost = before - self.energy()
        self.reset()
        try:
            hits = self._hits()
        except StepError as error:
            raise GaveUpError(str(error)) from error
        return score(self.problem, hits, lost)

    def _hits(self) -> list[float]:
        """Times of the impacts that count [s]."""
        integrator, hits = self.integrator, []
        last = self.problem.hits[-1] + 2.0 * self.period
        while integrator.time < min(last, self.problem.stop - 0.5 * self.h):
            state, begin = integrator.save(), integrator.time
            integrator.advance(begin, self.h)
            end, count = integrator.save(), self._count()
            while len(hits) < count:
                hits.append(begin + self._time_of(len(hits) + 1, state, begin))
            integrator.restore(end)
        return hits

    def _count(self) -> int:
        return round(float(self.integrator[f"{CONTACTS[self.problem.kind]}.impacts"]))

    def _time_of(self, count: int, state: bytes, begin: float) -> float:
        """Least step [s] from a state with which so many impacts have been."""
        low, high = 0.0, self.h
        for _ in range(BISECTIONS):
            middle = 0.5 * (low + high)
            self.integrator.restore(state)
            self.integrator.advance(begin, middle)
            if self._count() >= count:
                high = middle
            else:
                low = middle
        return high


def _families(_: Problem) -> Iterable[Iterable[Setting]]:
    for order in ORDERS:
        yield [{"order": order, "division": division} for division in DIVISIONS]


def _entry(problem: Problem, setting: Setting) -> Entry:
    run = Run(problem, setting)
    return Entry(run.run, run.reset)


METHODS = (
    Method(
        name="holonom",
        families=_families,
        label=lambda setting: (
            f"order {setting['order']}, {setting['division'] * COMMUNICATIONS} steps"
        ),
        entry=_entry,
        score=lambda problem, setting: Run(problem, setting).scored(),
    ),
)
