"""When contacts change, seen from outside, and runs that keep the worst of what they pass.

An event is looked for by trying ever closer ends of a communication step that contains it. Such a
step is solved in one piece up to the event, as the step that located the event was.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from solver.runtime import Integrator
from tests.support.mechanisms.problems import Content, start


def begin(content: Content, h: float = 0.01, order: int = 2, **settings: Any) -> Integrator:
    """Return a mechanism with contacts whose internal steps are of length `h`, in pairs."""
    return start(content, h=h, order=order, **settings)


def number(integrator: Integrator, name: str) -> float:
    """Value of a variable that is a number."""
    value = integrator[name]
    assert isinstance(value, float)
    return value


def contacts_of(integrator: Integrator) -> list[str]:
    """Names of all contacts."""
    names = (variable.name for variable in integrator.model.variables)
    return [name.removesuffix(".gap") for name in names if name.endswith(".gap")]


# ------------------------------------------------------------------------------------------ runs


@dataclass
class Passed:
    """The worst at the communication points that a run has passed."""

    error: float = 0.0
    """Largest energy.error."""
    gap: float = math.inf
    """Least gap of all contacts [m or rad]."""
    loss: float = math.inf
    """Least change of energy.friction + energy.impact from point to point [J]."""


def cover(integrator: Integrator, times: Iterable[float]) -> Passed:
    """Advance to each of these times, all later than the present one."""
    names = ["energy.error", "energy.friction", "energy.impact"]
    names += [f"{contact}.gap" for contact in contacts_of(integrator)]
    places, passed = [integrator.model.index(name) for name in names], Passed()
    before = number(integrator, "energy.friction") + number(integrator, "energy.impact")
    for t in times:
        integrator.advance(integrator.time, t - integrator.time)
        error, friction, impact, *gaps = np.array(integrator.get(places), float)
        passed.error = max(passed.error, error)
        passed.gap = min([passed.gap, *gaps])
        passed.loss, before = min(passed.loss, friction + impact - before), friction + impact
    return passed


def even(until: float, step: float, start: float = 0.0) -> list[float]:
    """Times from `start` to `until`, about `step` apart."""
    n = max(1, round((until - start) / step))
    return [start + (until - start) * (i + 1) / n for i in range(n)]


# ---------------------------------------------------------------------------------------- events


@dataclass(frozen=True)
class Event:
    """What changed in a contact, and when [s]."""

    time: float
    contact: str
    kind: str
    """hit, open, close; of friction stick, slip, or turn where a slip goes on the other way."""


def _conditions(integrator: Integrator) -> dict[str, tuple[float, float]]:
    """Mode and number of impacts of each contact."""
    return {
        name: (number(integrator, f"{name}.mode"), number(integrator, f"{name}.impacts"))
        for name in contacts_of(integrator)
    }


def _changes(integrator: Integrator, before: dict[str, tuple[float, float]]) -> list[Event]:
    """Return what differs from the conditions before an event that has just been passed."""
    events, t = [], integrator.time
    for name, (mode, impacts) in _conditions(integrator).items():
        mode_0, impacts_0 = before[name]
        if impacts > impacts_0:
            events.append(Event(t, name, "hit"))
        if mode != mode_0:
            kind = "stick" if mode == 1.0 else "slip"
            kind = "open" if mode == 0.0 else "close" if mode_0 == 0.0 else kind
            events.append(Event(t, name, kind))
        elif mode == 2.0 and abs(number(integrator, f"{name}.slip")) < 1e-9:
            events.append(Event(t, name, "turn"))
    return events


def _first(passes: Callable[[float], bool], low: float, high: float) -> float:
    """Return the first double after `low` that passes; `high` does."""
    while low < (middle := 0.5 * (low + high)) < high:
        if passes(middle):
            high = middle
        else:
            low = middle
    return high


def events_of(content: Content, until: float, h: float, **settings: Any) -> list[Event]:
    """Events of a run from its start to a time, in steps of length `h`."""
    integrator = begin(content, h, **settings)
    events: list[Event] = []
    step = 1
    while integrator.time < until:
        step += integrator.time > (step - 1e-3) * h  # no sliver after an event
        before, saved, t = _conditions(integrator), integrator.save(), integrator.time

        def passes(end: float, saved: bytes = saved, t: float = t) -> bool:
            integrator.restore(saved)
            integrator.advance(t, end - t)
            return number(integrator, "solver.events") > 0.0

        if passes(min(step * h, until)):
            passes(_first(passes, t, min(step * h, until)))
            events += _changes(integrator, before)
    return events


def times_of(events: Iterable[Event], kind: str, contact: str | None = None) -> list[float]:
    """Times of the events of a kind, of one contact or of all."""
    return [e.time for e in events if e.kind == kind and contact in (None, e.contact)]
