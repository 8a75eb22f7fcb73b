"""Random mechanisms that touch: ledger, losses, gaps and forces, or a sentence that says why."""

from __future__ import annotations

import json
import math
import random
import re
import warnings

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import solver
from solver.runtime import Integrator, StepError
from tests.support.contact.random_contacts import Content, RandomContacts

CLOSED = 1e-11
"""Error of the ledger, of the reference energy, that round-off of a run explains."""
OPEN = 1e-9
"""Penetration, of the size of the scene, that round-off explains: steps end up to 1e-10 late."""
ROUNDING = 1e-12
"""Of all energies at hand: what a loss may fall by."""


def started(content: Content) -> Integrator | None:
    """Return the mechanism at its start; None where no modes or impulses agree there."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", solver.SceneWarning)
        try:
            model = solver.assemble(solver.loads(json.dumps(content), format="json"))
        except solver.SceneError as error:
            if re.search("no choice of closed contacts|no impulses were found", str(error)):
                return None
            raise
    run = Integrator(model, log=lambda _: None)
    run.initialise()
    return run


def push(run: Integrator) -> None:
    """Set the input of the scene, if it has one."""
    if any(v.name == "push" for v in run.model.variables):
        run["push"] = 5.0 * math.sin(3.0 * run.time + 1.0)


def advanced(run: Integrator) -> bool:
    """Whether a communication step was solved; else a sentence names the contact at fault."""
    try:
        run.advance(run.time, run.model.experiment.step_size)
    except StepError as error:
        modes = [float(run[v.name]) for v in run.model.variables if v.name.endswith(".mode")]
        is_named = re.search("contact 'c[0-9]+': ", str(error))
        if "a fault of this program" in str(error) or (any(modes) and not is_named):
            raise
        return False
    return True


def check(run: Integrator, size: float, before: dict[str, float]) -> dict[str, float]:
    """Check what must hold after a step, and return the losses."""
    names = [v.name for v in run.model.variables if v.causality == "output"]
    values = {name: float(run[name]) for name in names}
    assert all(map(math.isfinite, values.values()))
    assert values["energy.error"] <= CLOSED
    energies = ("kinetic", "potential", "work", "dissipated")
    total = sum(abs(values[f"energy.{word}"]) for word in energies)
    losses = {name: values[name] for name in ("energy.impact", "energy.friction")}
    for name, loss in losses.items():
        assert loss >= before.get(name, 0.0) - ROUNDING * (total + 1e-3)
    for name in names:
        if name.endswith(".gap"):
            assert values[name] >= -OPEN * size, name
    return losses


@pytest.mark.parametrize("mode", ["located", "stepped"])
@given(seed=st.integers(0, 2**32 - 1), wild=st.booleans())
@settings(max_examples=60)
def test_ledgers_close_losses_grow_and_gaps_stay_open(mode, seed, wild):
    scene = RandomContacts(random.Random(seed), wild=wild)
    scene.content["solver"]["contact_mode"] = mode
    run = started(scene.content)
    losses: dict[str, float] = {}
    for _ in range(20 if run else 0):
        assert run is not None
        push(run)
        if not advanced(run):
            return
        losses = check(run, scene.extent, losses)


@given(seed=st.integers(0, 2**32 - 1), at=st.integers(1, 10))
@settings(max_examples=20)
def test_a_restored_mechanism_touches_as_before_bit_for_bit(seed, at):
    run = started(RandomContacts(random.Random(seed)).content)
    if run is None:
        return
    for _ in range(at):
        push(run)
        if not advanced(run):
            return
    kept = run.save()
    states: list[list[bytes | None]] = []
    for _ in range(2):
        run.restore(kept)
        states.append([])
        for _ in range(4):
            push(run)
            states[-1].append(run.save() if advanced(run) else None)
    assert states[0] == states[1]


@pytest.mark.parametrize("order", [2, 4])
@pytest.mark.parametrize("angle", [20, 50, 65, 80])
@pytest.mark.parametrize("speed", [-1.0, 1.0, 5.0])
def test_painleves_rod_finishes(angle, speed, order):
    turn = math.radians(angle)
    tip = [math.cos(turn), math.sin(turn)]
    content = {
        "name": "painleve",
        "dimension": 2,
        "gravity": [0.0, -9.81],
        "points": {
            "A": {"position": [0.0, 0.0], "mass": 0.0, "velocity": [speed, 0.0]},
            "B": {"position": tip, "mass": 0.0, "velocity": [speed, 0.0]},
        },
        "bodies": {"rod": {"type": "bar", "points": ["A", "B"], "mass": 1.0}},
        "contacts": {
            f"at_{end}": {"type": "plane", "point": end, "axis": [0, 1], "friction": 1.6}
            for end in "AB"
        },
        "solver": {"step_size": 0.01, "order": order, "max_events": 1000},
        "experiment": {"step_size": 0.05, "stop_time": 1.0},
    }
    run = started(content)
    assert run is not None
    losses: dict[str, float] = {}
    for _ in range(20):
        run.advance(run.time, 0.05)
        losses = check(run, 1.0, losses)
