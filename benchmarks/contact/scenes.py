"""Every scene with contacts or friction: time of its experiment, its ledger, and one known number.

The numbers are closed forms, or of reduced equations that were integrated by DOP853 with polished
events, by two step controls that agree to the digits that are shown.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import solver
from benchmarks.contact.problems import SLIDER_CRANK
from benchmarks.measuring.effort import Effort
from benchmarks.measuring.stepping import in_equal_steps
from benchmarks.measuring.timing import Entry, Times, interleave
from benchmarks.pages.report import Section, Table, Value
from solver.options import step_of
from solver.runtime import Integrator
from tests.support.mechanisms.scene_files import TOUCHING

BISECTIONS = 50
COLUMNS = {
    "scene": "scene",
    "bodies": ("bodies and points", ".0f"),
    "contacts": ("contacts", ".0f"),
    "order": ("order", ".0f"),
    "h": ("step, ms", ".4g"),
    "stop": ("simulated s", ".4g"),
    "cost": "ms per simulated s",
    "impacts": ("impacts", ".0f"),
    "stepped": "stepped over",
    "ledger": ("energy.error, largest", ".1e"),
    "what": "known",
    "value": ("value", ".12g"),
    "error": ("relative error", ".1e"),
    "noise": ("noise", ".2f"),
}


# ------------------------------------------------------------------------------- known numbers


def _until(integrator: Integrator, time: float) -> Integrator:
    """Advance in communication steps of the scene, the last one cut."""
    step = integrator.model.experiment.step_size
    while integrator.time < time - 1e-9 * step:
        integrator.advance(integrator.time, min(step, time - integrator.time))
    return integrator


def _at(time: float, name: str) -> Callable[[Integrator], float]:
    """Value of an output at a time [s]."""
    return lambda integrator: float(_until(integrator, time)[name])


def _change(name: str, start: float, end: float) -> Callable[[Integrator], float]:
    """By how much an output changes between two times [s]."""

    def found(integrator: Integrator) -> float:
        before = float(_until(integrator, start)[name])
        return float(_until(integrator, end)[name]) - before

    return found


def _ratio(name: str, end: float) -> Callable[[Integrator], float]:
    """Value of an output at a time [s] over that at the start."""

    def found(integrator: Integrator) -> float:
        before = float(integrator[name])
        return float(_until(integrator, end)[name]) / before

    return found


def _when(name: str, level: float, start: float) -> Callable[[Integrator], float]:
    """Time [s], in the communication step from a start on, at which an output gets to a level."""

    def found(integrator: Integrator) -> float:
        low, state = _until(integrator, start).time, integrator.save()
        high = low + integrator.model.experiment.step_size
        for _ in range(BISECTIONS):
            middle = 0.5 * (low + high)
            integrator.restore(state)
            _until(integrator, middle)
            low, high = (low, middle) if integrator[name] == level else (middle, high)
        return high

    return found


@dataclass(frozen=True, slots=True)
class Known:
    """A number that is known of a scene."""

    what: str
    value: float
    found: Callable[[Integrator], float]
    settings: Mapping[str, float] = field(default_factory=dict)
    """Values of the scene that are changed for it."""
    scale: float | None = None
    """What an error is measured by, if not by the value."""

    def error(self, integrator: Integrator) -> float:
        """Relative error of a scene at its start."""
        return abs(self.found(integrator) - self.value) / (self.scale or abs(self.value))


ROCKING = 9.81 * (0.1 * math.sin(0.2) + 0.3 * (math.cos(0.2) - 1.0))
"""Energy per mass with which Housner's block begins [J/kg]."""
PERIOD = 0.671238898038469
"""Of the stick-slip motion on the belt [s]."""
KNOWN = {
    "ball_in_a_bowl": Known("x at 2 s", -0.4749804981274, _at(2.0, "ball.x")),
    "ball_on_hills": Known("energy of impacts", 0.03812644165997, _at(1.2, "energy.impact")),
    "belt_and_block": Known(
        "friction in a period", 0.402743338823081, _change("energy.friction", 3.0, 3.0 + PERIOD)
    ),
    "bouncing_ball": Known("height at 2 s", 0.260741728327057, _at(2.0, "ball.y")),
    "bowling_ball": Known("speed when it rolls", 30.0 / 7.0, _at(2.0, "ball.vx")),
    "bowling_disc": Known("speed when it rolls", 2.0, _at(1.0, "disc.vx")),
    "cam_and_follower": Known("landing", 0.0665961038986019, _when("cam.impacts", 1.0, 0.066)),
    "falling_chain": Known("energy at the end", 0.0, _at(1.5, "energy.total"), scale=1.0),
    "falling_rod": Known("far end lands", 0.4374693840614, _when("upper_end.impacts", 1.0, 0.43)),
    "gear_pair_with_backlash": Known(
        "crosses its play", 0.012234118162435, _when("teeth.impacts", 1.0, 0.01)
    ),
    "geneva_drive": Known("turn in a turn", -0.5 * math.pi, _change("bearing.angle", 0.75, 1.75)),
    "mass_in_a_circle": Known("energy of impacts", 6.891693941328, _at(20.0, "energy.impact")),
    "newtons_cradle": Known("energy of impacts", 0.0, _at(3.0, "energy.impact"), scale=1.0),
    "pendulum_with_stop": Known(
        "third hit without friction", 3.35390204401844, _when("stop.impacts", 3.0, 3.35),
        {"friction": 0.0},
    ),
    "pile_of_discs": Known("energy at rest", 7.187239, _at(1.0, "energy.potential")),
    "putting_green": Known(
        "friction while it rolls", 0.0, _change("energy.friction", 1.0, 2.0), scale=0.1
    ),
    "quarter_car": Known(
        "energy of the landing", 23.58955156, _change("energy.impact", 0.39, 0.3908)
    ),
    "rocking_block": Known(
        "energy of the first landing", ROCKING * (1.0 - (1.0 - 1.5 * 0.01 / 0.1) ** 2),
        _at(0.5, "energy.impact"),
    ),
    "slider_crank_with_clearance": Known(
        "tenth hit", SLIDER_CRANK[9], _when("wrist_pin.impacts", 10.0, 0.021)
    ),
    "slider_crank_with_play_in_the_guide": Known(
        "first hit", 0.0026925027520213, _when("upper_left.impacts", 1.0, 0.002)
    ),
    "thrown_block": Known("stops", 0.34573831175214, _when("incline.mode", 1.0, 0.34)),
    "tippe_top": Known("Jellett's integral over its start", 1.0, _ratio("jellett", 4.0)),
}  # fmt: skip


# ------------------------------------------------------------------------------------ the table


def _started(scene: solver.Scene) -> Integrator:
    integrator = Integrator(solver.assemble(scene), log=lambda _: None)
    integrator.initialise()
    return integrator


class Run:
    """A scene at its start, with its experiment in communication steps."""

    def __init__(self, path: Path, effort: Effort) -> None:
        self.path, scene = path, in_equal_steps(path)
        self.bodies = len(scene.bodies) + sum(not point.fixed for point in scene.points.values())
        self.integrator = _started(scene)
        self._start = self.integrator.save()
        experiment = self.integrator.model.experiment
        self.step = experiment.step_size
        self.count = effort.count(round(experiment.stop_time / self.step))

    def entry(self) -> Entry:
        """Its experiment, without looking at it."""
        return Entry(self.run, lambda: self.integrator.restore(self._start))

    def run(self) -> None:
        """Take all communication steps."""
        for _ in range(self.count):
            self.integrator.advance(self.integrator.time, self.step)

    def error(self, known: Known) -> float:
        """Relative error of what is known of it."""
        self.integrator.restore(self._start)
        changed = known.settings
        return known.error(
            _started(solver.load(self.path, changed)) if changed else self.integrator
        )

    def row(self, name: str, times: Times, known: Known | None) -> Row:
        """Repeat the experiment, and look at it."""
        integrator = self.integrator
        integrator.restore(self._start)
        ledger, stepped = 0.0, 0
        for _ in range(self.count):
            integrator.advance(integrator.time, self.step)
            ledger = max(ledger, float(integrator["energy.error"]))
            stepped += int(float(integrator["solver.stepped"]))
        names = [variable.name for variable in integrator.model.variables]
        impacts = [float(integrator[each]) for each in names if each.endswith(".impacts")]
        simulated = self.count * self.step
        return {
            "scene": name,
            "bodies": self.bodies,
            "contacts": sum(each.endswith(".gap") for each in names),
            "order": float(integrator["solver.order_in_use"]),
            "h": 1e3 * step_of(integrator.model.settings),
            "stop": simulated,
            "cost": 1e3 * times.minimum / simulated,
            "impacts": sum(impacts),
            "stepped": f"{stepped} of {self.count}" if stepped else "",
            "ledger": ledger,
            "what": known.what if known else "",
            "value": known.value if known else None,
            "error": self.error(known) if known else None,
            "noise": times.noise,
        }


Row = dict[str, Value]


def measure(effort: Effort) -> Section:
    runs = {path.stem: Run(path, effort) for path in TOUCHING}
    times = interleave({name: run.entry() for name, run in runs.items()}, effort)
    rows = [run.row(name, times[name], KNOWN.get(name)) for name, run in runs.items()]
    return Section(
        name="contact-scenes",
        title="Scenes with contacts",
        method=(
            "Every scene of `scenes/` that touches or rubs, from its start, with its own settings: "
            "CPU time of its experiment in its communication steps, without reading outputs; the "
            "largest energy.error at communication points; in how many of these steps contacts "
            "were stepped over; and one number that is known of it, with the error of the scene "
            "as it is."
        ),
        tables=[Table(title="", columns=COLUMNS, rows=rows)],
        remarks=[
            "The cam is given by 72 points; with more of them its landing converges.",
            "After some hits the worn four-bar, Jansen's leg and both slider-cranks are chaotic.",
        ],
    )
