"""Contacts that are far sleep: that changes what steps cost, and no bit of what they find."""

from __future__ import annotations

import math

import numpy as np
import pytest

import solver
from benchmarks.sections.skips import SKIPS
from solver.runtime import Integrator
from solver.runtime.layout import CONTACT
from tests.support.kernel.kernels_without_skips import integrator_without, needs_compiler
from tests.support.mechanisms.mechanism_runs import scene
from tests.support.mechanisms.problems import Content, assemble, chain, start

UNTIL = CONTACT.index("asleep_until")
SLEEP = SKIPS["far contacts"]


def contacts(run: Integrator) -> np.ndarray:
    """What the state knows of each contact."""
    return np.array(run.state.vectors["contacts"]).reshape(-1, len(CONTACT))


def n_asleep(run: Integrator) -> int:
    """Number of contacts that sleep."""
    return int((contacts(run)[:, UNTIL] > 0.0).sum())


def motion(run: Integrator) -> bytes:
    """Bits of the motion, of modes and impacts, and of the ledger."""
    vectors = run.state.vectors
    parts = [np.array(vectors[name]).ravel() for name in ("q", "q_low", "v", "v_low", "frictions")]
    ledger = [run.state.head[name] for name in ("friction", "impact", "work", "events")]
    return np.concatenate([*parts, contacts(run)[:, :UNTIL].ravel(), ledger]).tobytes()


CEILINGS = 7
"""More contacts than the floor's: of few ones none sleeps."""


def below_ceilings(content: Content, point: str) -> Content:
    """The scene, with ceilings that its point never reaches."""
    far = {"type": "plane", "axis": [0, -1], "position": [0, 60], "point": point}
    return content | {
        "contacts": content["contacts"] | {f"ceiling_{k}": far for k in range(CEILINGS)}
    }


def falling(height: float, **fields: object) -> Content:
    """A point above a floor."""
    content = {
        "name": "falling", "dimension": 2, "gravity": [0, -9.81],
        "points": {"p": {"position": [0, height], "mass": 1.0}},
        "contacts": {"floor": {"type": "plane", "point": "p", "axis": [0, 1]} | fields},
    }  # fmt: skip
    return below_ceilings(content, "p")


def above_a_floor(friction: float) -> Content:
    """A chain of ten, 50 m above a floor."""
    content = chain(10, dimension=2)
    names = [name for name, point in content["points"].items() if not point.get("fixed")]
    floor = {"type": "plane", "axis": [0, 1], "position": [0, -50], "friction": friction}
    return content | {"contacts": {f"floor_{name}": floor | {"point": name} for name in names}}


def spinning() -> Content:
    """A rod of 2 m that turns with 2 rad/s while it falls onto a floor."""
    ends = {"left": [-1, 0], "right": [1, 0]}
    body = {"position": [0, 30], "mass": 1.0, "inertia": 0.3, "angular_velocity": 2, "points": ends}
    floor = {"type": "plane", "axis": [0, 1], "restitution": 0.5, "friction": 0.3}
    content = {
        "name": "spinning", "dimension": 2, "gravity": [0, -9.81], "bodies": {"rod": body},
        "contacts": {end: floor | {"point": f"rod.{end}"} for end in ends},
    }  # fmt: skip
    return below_ceilings(content, "rod.left")


def kicked() -> Content:
    """A point that rests 1 m above a floor until a force throws it down with 2000 m/s^2."""
    content = falling(1.0, restitution=0.5) | {"gravity": [0, 0]}
    push = {"type": "force", "point": "p", "value": [0, "-2000*(t > 0.1055)"]}
    return content | {"forces": {"kick": push}}


SCENES = {"spinning": spinning, "falling": lambda: falling(3.0, restitution=0.5), "kicked": kicked}


@needs_compiler
@pytest.mark.parametrize("mode", ["located", "stepped"])
@pytest.mark.parametrize("name", [*SCENES, "dominoes", "pile_of_discs"])
def test_sleep_changes_no_bit_of_the_motion(name, mode):
    if name in SCENES:
        model, h, steps = assemble(SCENES[name]()), 0.01, 280
    else:
        model, h, steps = solver.assemble(solver.load(scene(name))), 0.01, 60
    settings = {"tolerance": 0.0, "step_size": 0.01, "contact_mode": mode}
    awake, sleepy = (integrator_without(bits, model, **settings) for bits in (SLEEP, 0))
    slept = 0
    for _ in range(steps):
        awake.advance(awake.time, h)
        sleepy.advance(sleepy.time, h)
        assert n_asleep(awake) == 0
        assert motion(sleepy) == motion(awake)
        slept += n_asleep(sleepy)
    assert slept > 0


@pytest.mark.parametrize("friction", [0.0, 0.3], ids=["frictionless", "friction"])
def test_all_contacts_that_are_far_sleep_from_the_first_steps_on(friction):
    run = start(above_a_floor(friction), h=0.01)
    for _ in range(3):
        run.advance(run.time, 0.01)
    assert n_asleep(run) == len(contacts(run)) == 10


def test_a_point_that_falls_from_far_hits_when_it_should():
    # One flight of constant acceleration: a located impact is at sqrt(2 h/g), to round-off.
    run = start(falling(20.0, restitution=0.5), h=0.01)
    while contacts(run)[0, CONTACT.index("impacts")] == 0.0:
        slept = n_asleep(run)
        run.advance(run.time, 0.01)
    assert slept == CEILINGS
    fall = math.sqrt(2 * 20.0 / 9.81)
    after = run.time - fall
    speed = 0.5 * 9.81 * fall
    assert 0.0 <= after <= 0.01
    assert run["p.y"] == pytest.approx(speed * after - 0.5 * 9.81 * after**2, abs=1e-11)


def test_a_gap_that_is_read_is_the_present_one_while_its_contact_sleeps():
    run = start(falling(20.0), h=0.01)
    for _ in range(100):
        run.advance(run.time, 0.01)
    assert n_asleep(run) == 1 + CEILINGS
    assert run["floor.gap"] == pytest.approx(20.0 - 0.5 * 9.81 * run.time**2, abs=1e-11)


def test_a_state_that_is_set_again_goes_on_as_it_did():
    # From asleep back to asleep, over an impact.
    run = start(falling(1.0, restitution=0.8), h=0.01)
    for _ in range(10):
        run.advance(run.time, 0.01)
    assert n_asleep(run) == 1 + CEILINGS
    far = list(run.state.block)
    ends = []
    for _ in range(2):
        for _ in range(60):
            run.advance(run.time, 0.01)
        ends.append(motion(run))
        run.state.block[:] = far
    assert ends[0] == ends[1]


@pytest.mark.parametrize("name", SCENES)
def test_scratch_filled_with_nan_changes_nothing_while_contacts_sleep(name):
    settings = {"tolerance": 0.0, "step_size": 0.01, "contact_mode": "stepped"}
    clean, spoilt = (start(SCENES[name](), **settings) for _ in range(2))
    slept = 0
    for _ in range(280):
        np.asarray(memoryview(spoilt.work).cast("B").cast("d"))[:] = np.nan
        clean.advance(clean.time, 0.01)
        spoilt.advance(spoilt.time, 0.01)
        assert motion(clean) == motion(spoilt)
        slept += n_asleep(clean)
    assert slept > 0
