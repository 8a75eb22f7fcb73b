"""Random scenes of all kinds of shapes obey the laws of contact at every event and at rest.

Scenes run through the product, located and stepped; ``tests/support/contact/scene_laws.py`` has
the laws.
"""

from __future__ import annotations

import copy
import json
import random
import re
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import solver
from solver import SceneError
from solver.runtime import Integrator, StepError
from solver.runtime.layout import CONTACT
from tests.support.contact.random_shapes import Content, RandomShapes, write_box
from tests.support.contact.scene_laws import (
    Around,
    LawError,
    check_impact,
    check_outputs,
    check_path,
    check_rest,
    check_step,
    claim,
    enclose,
    value,
)

SOME, MANY, CHUNK = 100, 2000, 50
STEPS, EVENTS = 8, 2
"""Communication steps of a run, and events of it that are enclosed."""
STEPPED, STEPPED_STEPS = 5e-4, 60
"""Step of stepped runs [s], and how many."""

TWICE, FALLING = 10, 30
"""Scenes that run twice among the first 100, and scenes whose step falls."""
MOST_UNCLEAR, LEAST_FOLLOWED = 0.1, 0.4
"""Of enclosed events: most that are more than one impact, least whose path of rates is followed."""
UNDECIDED = "no choice of closed contacts"
"""What a start may be refused with."""
STILL = 1e-24
"""Kinetic energy, of the largest one, of what is parked."""


@dataclass
class Enclosed:
    """Events that were enclosed, and which of their laws were asked for."""

    all: int = 0
    unclear: int = 0
    """Behind which a contact lands between the two states: no law is asked for."""
    followed: int = 0
    """Whose rates were compared with those along the path of an impact."""

    def claim_most_are_checked(self) -> None:
        """Demand that what is left out is little."""
        assert self.unclear <= 1 + MOST_UNCLEAR * self.all, self
        assert self.followed >= LEAST_FOLLOWED * self.all, self


def chunks() -> list[object]:
    """Return first numbers of scenes that share a test; those beyond the first 100 are long."""
    return [
        pytest.param(first, marks=[pytest.mark.long] if first >= SOME else [])
        for first in range(0, MANY, CHUNK)
    ]


def scene(number: int, folder: Path) -> RandomShapes:
    """Return a random scene."""
    return RandomShapes(random.Random(f"laws {number}"), mesh=write_box(folder))


def started(content: Content) -> Integrator:
    """Return a run at its start."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", solver.SceneWarning)
        model = solver.assemble(solver.loads(json.dumps(content), format="json"))
    run = Integrator(model, log=lambda _: None)
    run.initialise()
    return run


def is_still(run: Integrator) -> bool:
    """Whether nothing moves."""
    return value(run, "energy.kinetic") <= STILL * run.state.head["energy_reference"]


def check_located(run: Integrator, size: float, found: Enclosed, *, knows: bool) -> None:
    """Check a run whose events are located; `knows` whether the NumPy model has its contacts."""
    left, h = EVENTS if knows else 0, run.model.experiment.step_size
    losses: dict[str, float] = {}
    if knows:
        check_rest(run)
    for step in range(STEPS):
        start, end = run.save(), run.time + h
        while left and end - run.time > 1e-3 * h and (states := enclose(run, end - run.time)):
            left -= 1
            around = Around(run, *states)
            found.all += 1
            found.unclear += not around.is_one
            if around.is_one:
                check_impact(around)
                found.followed += check_path(around)
        run.restore(start)
        still = step > 0 and is_still(run)  # what carries nothing opens in the first step
        run.advance(run.time, h)
        losses = check_outputs(run, size, losses)
        if still and is_still(run):
            claim(not value(run, "solver.events"), "what is parked has events")
    if knows and not value(run, "solver.stepped"):
        check_rest(run)


def check_stepped(run: Integrator, size: float, _found: Enclosed, *, knows: bool) -> None:
    """Check a run whose contacts change at the ends of half steps, step by step."""
    losses: dict[str, float] = {}
    for _ in range(STEPPED_STEPS):
        start, hits = run.save(), sum(run.state.vectors["contacts"][3 :: len(CONTACT)])
        run.advance(run.time, STEPPED)
        losses = check_outputs(run, size, losses)
        if knows and sum(run.state.vectors["contacts"][3 :: len(CONTACT)]) > hits:
            check_step(Around(run, start, run.save(), STEPPED), STEPPED)


def broken(number: int, folder: Path, found: Enclosed) -> str:
    """Return what a random scene breaks; empty if nothing, or if it ends with a contact's name."""
    random_scene = scene(number, folder)
    settings = random_scene.content["solver"]
    kinds = {contact["type"] for contact in random_scene.content["contacts"].values()}
    knows, check = not kinds & {"mesh"}, check_located
    if number % 3 == 2:
        settings |= {"contact_mode": "stepped", "step_size": STEPPED}
        check = check_stepped
    try:
        run = started(random_scene.content)
    except SceneError as error:
        return "" if UNDECIDED in str(error) else f"{number}: {error}\n"
    try:
        check(run, random_scene.extent, found, knows=knows)
    except LawError as error:
        return f"{number}: {error} at {run.time:g} s\n"
    except StepError as error:
        if not re.search("contact 'c[0-9]+'", str(error)):
            return f"{number}: {error}\n"
    return ""


@pytest.mark.parametrize("first", chunks())
def test_random_scenes_obey_the_laws_at_every_event_and_at_rest(first, tmp_path):
    found = Enclosed()
    assert "".join(broken(k, tmp_path, found) for k in range(first, first + CHUNK)) == ""
    found.claim_most_are_checked()


def places(content: Content, steps: int = 4) -> dict[str, float]:
    """Return the places of all points after some communication steps."""
    run = started(content)
    for _ in range(steps):
        run.advance(run.time, run.model.experiment.step_size)
    names = [v.name for v in run.model.variables if v.name[-2:] in (".x", ".y", ".z")]
    names = [name for name in names if not name.endswith(("force.x", "force.y", "force.z"))]
    return {name: value(run, name) for name in names if "momentum" not in name}


def heavier(content: Content, factor: float) -> Content:
    """Return the scene with this factor on all masses and forces."""
    other = copy.deepcopy(content)
    for table in ("points", "bodies", "forces"):
        for part in other.get(table, {}).values():
            for word in ("mass", "inertia", "stiffness", "damping"):
                if word in part:
                    part[word] = (factor * np.array(part[word])).tolist()
    return other


def other_order(content: Content) -> Content:
    """Return the scene with its contacts in the opposite order."""
    return content | {"contacts": dict(reversed(content["contacts"].items()))}


@pytest.mark.parametrize("change", [other_order, lambda x: heavier(x, 10.0)], ids=["order", "mass"])
@pytest.mark.parametrize("first", [0, *(pytest.param(k, marks=pytest.mark.long) for k in (1, 2))])
def test_neither_the_order_of_contacts_nor_the_unit_of_mass_counts(first, change, tmp_path):
    """In the first steps: impacts that follow on each other make small differences large."""
    for number in range(100 * first, 100 * first + (TWICE if first == 0 else 100)):
        random_scene = scene(number, tmp_path)
        try:
            found = places(random_scene.content)
        except StepError:
            continue
        other = places(change(random_scene.content))
        assert other == pytest.approx(found, abs=1e-6 * random_scene.extent), number


@pytest.mark.long
def test_stepped_runs_tend_to_located_ones_as_the_step_falls(tmp_path):
    """Errors of places with a ninth of the step, of scenes that are no chains of impacts."""
    ratios = []
    for number in range(FALLING):
        content = scene(number, tmp_path).content
        content["experiment"]["step_size"] = 0.0135
        content["solver"] = {"order": 4, "step_size": 0.0015}
        try:
            right = np.array(list(places(content, 6).values()))
            errors = []
            for h in (4.5e-3, 5e-4):
                content["solver"] = {"contact_mode": "stepped", "step_size": h}
                stepped = np.array(list(places(content, 6).values()))
                errors.append(np.max(np.abs(stepped - right)))
        except StepError:
            continue
        if errors[0] > 1e-6:
            ratios.append(errors[1] / errors[0])
    assert len(ratios) >= FALLING // 3
    assert np.median(ratios) <= 1.0 / 4.0
