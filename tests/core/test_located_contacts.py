"""The core's runs with contacts, through impacts, releases and slips, against the oracle's.

Each communication step of both starts from the same state, against chaos. The oracle tries all
choices of what may be closed and stick, and finds events by SciPy's `brentq` on whole steps.
"""

from __future__ import annotations

import json
import random
import warnings
from typing import Any

import numpy as np
import pytest

import solver
from solver.options import step_of
from solver.runtime import Integrator
from solver.runtime.layout import CONTACT, FRICTION, measured_sections
from tests.oracle import Mechanism
from tests.oracle.contacts import State
from tests.oracle.events import Located
from tests.oracle.start import consistent_velocities, rows_of
from tests.support.contact.contact_scenes import painleve_rod, rocking_block
from tests.support.contact.random_contacts import Content, RandomContacts
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.twins import numbers
from tests.support.mechanisms.problems import assemble, mechanism
from tests.support.mechanisms.scene_files import SCENES

NEAR = 1e-9
"""Of size, speed and energy: steps are solved to 1e-11, and impacts multiply what differs."""
NEAR_FORCES = 1e-7
"""Of forces in steps of a usual length, which divide the rounding of rows by its square."""

NEAR_EVENTS = 1e-6
"""Of times, over the step: releases of what is driven are known no better, from differences."""

ORDER_4 = {"belt_and_block", "falling_rod", "mass_in_a_circle"}
"""Scenes that are compared in steps of that order; the others, for the sake of time, of order 2."""
STEPS = {"ratchet": 0.005, "bowling_ball": 0.01}
"""Steps where those of the scene are too long to be solved, or end beside the event."""
EVENTS = {
    "ball_on_hills": 0.285, "belt_and_block": 0.26, "bouncing_ball": 0.46, "bowling_ball": 1.17,
    "falling_chain": 0.198, "falling_rod": 0.43,
    "four_bar_with_clearance": 0.0095, "gear_pair_with_backlash": 0.013,
    "jansen_with_clearance": 0.022, "mass_in_a_circle": 0.5, "newtons_cradle": 0.37,
    "quarter_car": 0.392, "ratchet": 0.23, "rocking_block": 0.34,
    "slider_crank_with_clearance": 0.0015, "slider_crank_with_play_in_the_guide": 0.0027,
    "thrown_block": 0.35, "woodpecker_toy": 0.027,
}  # fmt: skip
"""Ends of steps within which something hits, opens, slips or sticks [s].

Joints that rub in impacts are not here: the reference knows their friction between impacts alone,
and tests/physics/test_friction_of_joints.py has closed forms of them.
"""


def begun(model, **settings: float) -> Integrator:
    """Return the mechanism of a model at its start, in steps of one length."""
    run = Integrator(model, log=lambda _: None)
    run.initialise()
    run.state.head["tolerance"] = 0.0
    run.state.head["step_size"] = step_of(model.settings)
    for name, value in settings.items():
        run.state.head[name] = value
    return run


def vector(run: Integrator, name: str) -> np.ndarray:
    """Vector of the state, as a copy."""
    return np.array(run.state.vectors[name])


def modes(run: Integrator) -> tuple[np.ndarray, np.ndarray]:
    """Whether contacts are closed, and modes of frictions."""
    contacts = vector(run, "contacts").reshape(-1, len(CONTACT))
    return contacts[:, 0], vector(run, "frictions").reshape(-1, len(FRICTION))[:, 0]


def has_dependent_rows(mechanism: Mechanism) -> bool:
    """Whether rows that hold depend on each other, so that their forces are not unique."""
    G, on = rows_of(mechanism)[0][:, : mechanism.n_free], mechanism.rows_on()
    scaled = G[on] / np.sqrt(mechanism.m_node[: mechanism.n_free])
    sizes = np.sqrt(np.sum(scaled**2, axis=1, keepdims=True))
    return int(np.linalg.matrix_rank(scaled / np.where(sizes > 0.0, sizes, 1.0), tol=1e-6)) < sum(
        on
    )


def measured(run: Integrator, group: str, width: int) -> np.ndarray:
    """Measurements of a group, shape (items, width)."""
    kernel_of(run).measure()
    begin, count = measured_sections(run.model.sizes)[group]
    begin += run.model.offsets["measured"]
    return np.array(numbers(run)[begin : begin + count]).reshape(-1, width)


def compare_outputs(run: Integrator, near: float) -> None:
    """Demand that gaps, slips and losses are measured as they are at the state of the core."""
    mechanism = Mechanism.of(run.model, run.state)
    state, slips = State(mechanism), measured(run, "friction", 3)[:, 1]
    assert measured(run, "contact", 5)[:, 0] == pytest.approx(state.gaps, abs=near)
    assert np.abs(slips) == pytest.approx([state.slip(f)[0] for f in range(len(slips))], abs=near)
    losses = [run.state.head[name] for name in ("dissipated", "friction", "impact")]
    assert measured(run, "loss", 3).ravel().tolist() == losses


def compare(run: Integrator, oracle: Mechanism, last: float) -> None:
    """Demand that both are in the same state; `last` is the length of the last piece."""
    extent, reference = oracle.section["extent"], run.state.head["energy_reference"]
    speed = np.sqrt(2.0 * reference) * extent[0] / extent[1] + np.max(np.abs(oracle.v))
    q, v = (vector(run, x) + vector(run, f"{x}_low") for x in "qv")
    assert q == pytest.approx(oracle.x, abs=NEAR * extent[0])
    assert v == pytest.approx(oracle.v, abs=NEAR * speed)
    for account in ("impact", "friction", "dissipated", "work"):
        theirs = pytest.approx(oracle.head[account], abs=10.0 * NEAR * reference)
        assert run.state.head[account] == theirs, account
    compare_outputs(run, 1e-12 * max(1.0, extent[0], speed))
    if has_dependent_rows(oracle):
        return
    contacts = vector(run, "contacts").reshape(-1, len(CONTACT))
    assert np.array_equal(contacts[:, 3], oracle.of_contacts[:, 3])
    assert contacts[:, 4] == pytest.approx(oracle.of_contacts[:, 4], rel=1e-8, abs=NEAR)
    for ours, theirs in zip(modes(run), (oracle.of_contacts, oracle.of_frictions), strict=True):
        assert np.array_equal(ours, theirs[:, 0])
    if last < 0.1 * run.state.head["step_size"]:
        return
    for half in ("first", "second"):
        both = vector(run, f"mu_{half}"), oracle.vectors[f"mu_{half}"]
        mu, its = (np.delete(x, oracle.rigidity) for x in both)  # turns of bodies have none
        size = np.max(np.abs(its), initial=0.0) + reference / extent[0]
        assert mu == pytest.approx(its, abs=NEAR_FORCES * size)


def step_both(run: Integrator, h: float) -> list[float]:
    """Cover a step by core and oracle, compare them, and return the times of the events."""
    oracle, kept = Located(Mechanism.of(run.model, run.state)), run.save()
    unsettled = run.state.head["unsettled"]
    oracle.advance(h)
    near = NEAR_EVENTS * run.state.head["step_size"]
    near *= 100.0 if run.model.sizes["dim"] == 3 else 1.0  # 1e-7 of the speed counts as no slip
    for n, t in enumerate(oracle.events):
        for end, least, most in ((t - near, 0, n + unsettled), (t + near, n + 1, np.inf)):
            if 0.0 < end - run.time < h:
                begin = run.time
                run.advance(begin, end - begin)
                assert least <= run.state.head["events"] <= most, t
                run.restore(kept)
    begin = run.time
    run.advance(begin, h)
    assert run.state.head["events"] == len(oracle.events) + unsettled
    compare(run, oracle.mechanism, begin + h - max([begin, *oracle.events]))
    return oracle.events


@pytest.mark.parametrize("name", EVENTS)
def test_a_step_with_events_is_that_of_the_equations(name):
    model = solver.assemble(solver.load(SCENES / f"{name}.toml"))
    run = begun(model)
    run.state.head["order"] = 4.0 if name in ORDER_4 else 2.0
    run.state.head["step_size"] = h = STEPS.get(name, run.state.head["step_size"])
    while run.time + 1.5 * h < EVENTS[name]:
        run.advance(run.time, h)
    assert step_both(run, h)


def random_scene(seed: int) -> Content:
    """Return a random scene in steps of one length and of order 2 or 4."""
    content = RandomContacts(random.Random(seed)).content
    settings = content["solver"]
    settings.pop("tolerance", None)
    settings["order"] = 4 if settings.get("order") == 4 else 2
    for value in content.get("inputs", {}).values():
        value.clear()  # held: the oracle does not ramp
    return content


def random_run(seed: int) -> Integrator:
    """Return a random mechanism at its start."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", solver.SceneWarning)
        scene = solver.loads(json.dumps(random_scene(seed)), format="json")
    return begun(solver.assemble(scene))


@pytest.mark.parametrize("seed", [117, 119, 120, 124, 134, 150, 176, 178, 186, 190, 206])
def test_random_mechanisms_touch_by_the_equations(seed):
    """In the first communication step with an event: impacts, releases, slips, both laws."""
    run = random_run(seed)
    h = run.model.experiment.step_size
    kept = run.save()
    while not run.state.head["events"]:
        kept, begin = run.save(), run.time
        run.advance(begin, h)
    run.restore(kept)
    assert step_both(run, h)


@pytest.mark.parametrize("seed", [9, 13, 24, 25, 27, 37, 54, 63, 78, 88, 93, 99, 101])
def test_random_mechanisms_begin_by_the_equations(seed):
    run = random_run(seed)
    compare(run, begun_anew(run), 1.0)


def hung(kind: str, **more: Any) -> Content:
    """Body on a joint with friction to the ground, off its centre of mass."""
    friction = {"coefficient": 0.3, "preload": 0.2} | more.pop("friction", {"radius": 0.05})
    joint = {"type": kind, "bodies": ["ground", "b"], "position": [0, 0, 0], "friction": friction}
    body = {"mass": 1.0, "inertia": [0.02, 0.03, 0.04], "position": [0.3, 0.0, 0.0]}
    for word in ("velocity", "angular_velocity"):
        if word in more:
            body[word] = more.pop(word)
    return mechanism("hung", 3, bodies={"b": body}, joints={"j": joint | more})


HUNG = [
    hung("revolute", axis=[0, 1, 0]),
    hung("spherical", velocity=[0, 0.6, -0.3], angular_velocity=[0.5, 1, 2]),
    hung("cylindrical", axis=[0, 0.6, 0.8], angular_velocity=[0, 1.2, 1.6]),
    hung("prismatic", axis=[0.6, 0, 0.8], friction={}),
]


@pytest.mark.parametrize("content", HUNG, ids=lambda content: content["joints"]["j"]["type"])
def test_joints_with_friction_move_by_the_equations(content):
    run = begun(assemble(content, assemble=True))
    compare(run, begun_anew(run), 1.0)
    step_both(run, run.state.head["step_size"])


@pytest.mark.parametrize(
    "content", [rocking_block(), painleve_rod(0.3, 1.0)], ids=["rocking block", "rod"]
)
def test_contacts_begin_by_the_equations(content):
    run = begun(assemble(content))
    compare(run, begun_anew(run), 1.0)


def begun_anew(run: Integrator) -> Mechanism:
    """Return the start as drawn, with impacts and modes as the oracle has them."""
    oracle = Mechanism.of(run.model, run.state)
    oracle.vectors["contacts"][:] = oracle.vectors["frictions"][:] = 0.0
    oracle.head["impact"] = oracle.head["work"] = 0.0
    oracle.vectors["v"], oracle.vectors["v_low"][:] = oracle.section["initial_velocity"], 0.0
    if oracle.head["assemble"] or len(oracle.vectors["signal"]):
        oracle.vectors["v"] = consistent_velocities(oracle)
    assert np.all(State(oracle).gaps > -1e-8)
    located = Located(oracle)
    located.settle()
    assert located.unique
    return oracle
