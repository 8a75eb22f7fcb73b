"""Mechanisms with numbers far from one: kept to round-off, or refused with a sentence.

`energy.error` is relative to the largest energy exchanged so far; 1e-12 is a hundred times what 300
steps of round-off leave.
"""

from __future__ import annotations

import json
import math
import time

import numpy as np
import pytest
from scipy.optimize import brentq

import solver
from benchmarks.problems.stress_scenes import (
    four_bar,
    linked_bodies,
    nearly_parallel,
    spinning,
    stiff_chain,
)
from benchmarks.sections.stress import _extremes
from benchmarks.sections.stress_random import mechanism as random_mechanism
from benchmarks.sections.stress_runs import Found, run
from solver.runtime import Integrator
from tests.support.mechanisms.problems import (
    GRAVITY,
    Content,
    double_pendulum,
    free_system,
    mechanism,
    observe,
    start,
)

ROUND_OFF = 1e-12
QUIET = ["energy.error", "constraint.position"]


def linked_points(*, ratio: float = 1.0, length: float = 1.0, rate: float = 0.0) -> str:
    """A double pendulum of points whose masses are `ratio` apart, turning at `rate` [rad/s]."""
    x, y = 0.6 * length, -0.8 * length
    vx, vy = -y * rate, x * rate
    return f"""
name = "linked_points"
dimension = 2
gravity = [0, -9.81]
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = [{x}, {y}], velocity = [{vx}, {vy}], mass = 1.0 }}
B = {{ position = [{2 * x}, {2 * y}], velocity = [{2 * vx}, {2 * vy}], mass = {ratio} }}
[joints]
upper = {{ type = "distance", points = ["O", "A"] }}
lower = {{ type = "distance", points = ["A", "B"] }}
"""


LOOPS = {
    "points": linked_points,
    "row": linked_bodies,
    "planar loop": four_bar,
    "spatial loop": lambda **numbers: four_bar(dimension=3, **numbers),
}


def assert_kept(found: Found, bound: float = ROUND_OFF) -> None:
    """All steps solved as asked for, energy and constraints at round-off."""
    assert not found.refused
    assert found.divided == 1.0
    assert found.energy < bound
    assert found.constraint < ROUND_OFF


def final(text: str, h: float, count: int, names: list[str]) -> Content:
    """Values after `count` pairs of h [s]."""
    integrator = solver.Integrator(solver.assemble(solver.loads(text)))
    integrator["solver.step_size"] = h
    integrator.initialise()
    for _ in range(count):
        integrator.advance(integrator.time, h)
    return {name: float(integrator[name]) for name in names}


# ------------------------------------------------------------------------------------------ scales


@pytest.mark.parametrize("ratio", [1e-6, 1e-3, 1e3, 1e6])
@pytest.mark.parametrize("name", LOOPS)
def test_masses_of_bodies_may_differ_by_six_powers_of_ten(name, ratio):
    assert_kept(run(LOOPS[name](ratio=ratio), 0.01, 300))


@pytest.mark.parametrize("length", [1e-6, 1e-3, 1e3, 1e6])
@pytest.mark.parametrize("name", LOOPS)
def test_bodies_may_be_microns_or_thousands_of_kilometres_long(name, length):
    # Steps of the same angle: times grow as the root of a length.
    numbers = {"length": length, "rate": 2.0 / math.sqrt(length)}
    assert_kept(run(LOOPS[name](**numbers), 0.01 * math.sqrt(length), 300))


@pytest.mark.parametrize(
    ("soft", "stiff"), [(1.0, 1e6), (1e-3, 1e6), (1e-6, 1e6), (1e-3, 1e9), (1.0, 1e12)]
)
def test_springs_may_differ_in_stiffness_by_twelve_powers_of_ten(soft, stiff):
    # The stiff spring's length is known to 2e-16 m, its force to 2e-16 k; over the 0.05 m of a step
    # that is 1e-17 k of the 20 J exchanged, and 300 of either sign make 1e-17 k.
    assert_kept(run(stiff_chain(soft, stiff), 0.01, 300), ROUND_OFF + 1e-22 * stiff * 1e5)


@pytest.mark.parametrize("length", [1e-3, 1e3, 1e6])
def test_neighbouring_rods_may_differ_in_length(length):
    # The shorter rod sets the step; one of 1 mm swings a hundred times faster than one of 10 m.
    content = double_pendulum(1.0)
    x, y = content["points"]["A"]["position"]
    content["points"]["B"]["position"] = [x + length, y]
    h = 0.01 * min(1.0, math.sqrt(length))
    assert observe(start(content, h=h), h, 500, QUIET).max() < 1e-12


def spring_pendulum(stiffness: float) -> Content:
    points = {"A": {"position": [1.0, 0.0], "mass": 1.0}}
    tie = {"type": "spring", "points": ["ground", "A"], "at": [0, 0], "stiffness": stiffness}
    return mechanism("stiff", 2, points=points, forces={"tie": tie})


@pytest.mark.filterwarnings("ignore:the energy is off by")
@pytest.mark.parametrize("h", [1e-3, 1e-2])
@pytest.mark.parametrize("stiffness", [1.0, 1e3, 1e6, 1e9, 1e12])
def test_a_spring_may_be_as_stiff_as_a_rod(stiffness, h):
    # Its length is known to 2e-16, so its force to 2e-16 k and the energy of a step, through 0.05
    # m, to 1e-17 k; 500 steps of either sign make 2e-16 k, with a factor of ten to spare.
    error = observe(start(spring_pendulum(stiffness), h=h), h, 500, ["energy.balance"])
    assert np.abs(error).max() < 1e-12 * GRAVITY + 2e-15 * stiffness


@pytest.mark.parametrize("h", [0.5, 1.0, 3.0])
def test_a_free_system_survives_steps_of_radians(h):
    # Beyond 1 rad a step is halved inside; it stays exact in energy.
    content = free_system(3) | {"forces": {}}
    assert observe(start(content, h=h), h, 300, QUIET).max() < 1e-12


# ----------------------------------------------------------------------------------- dependent rows


@pytest.mark.parametrize("dimension", [2, 3])
def test_copies_of_a_joint_change_nothing(dimension):
    names = ["left.x", "coupler.y"]
    text = four_bar(dimension=dimension)
    single = final(text, 0.01, 300, names)
    for copies in (2, 5):
        text = four_bar(dimension=dimension, copies=copies)
        assert_kept(run(text, 0.01, 300))
        assert final(text, 0.01, 300, names) == pytest.approx(single, abs=1e-10)


@pytest.mark.parametrize("apart", [1e-1, 1e-2, 1e-3, 1e-4, 1e-12, 1e-14])
def test_rods_that_are_nearly_one_hold_a_point_as_they_should(apart):
    # Ends of 1e-4 m give rows whose Gram determinant is 1e-8; at 1e-12 they are one row.
    assert_kept(run(nearly_parallel(apart), 0.01, 300))


@pytest.mark.parametrize("apart", [10.0**-k for k in range(5, 12)])
@pytest.mark.parametrize("across", [0.0, 5.0])
def test_in_between_they_do_or_a_sentence_says_why_not(apart, across):
    # Rows that are dependent to 1e-10 ... 1e-22 of their Gram determinant. A load across their
    # plane needs forces of across/apart N; lengths are known to 2e-16 m, so that some hundred
    # steps let in 1e-14 of that force in J, of 10 J.
    found = run(nearly_parallel(apart, across), 0.01, 300)
    assert found.constraint < ROUND_OFF
    assert found.energy < 1e-10 + 1e-14 * across / apart
    sentences = ("did not converge", "could not be met")
    assert not found.refused or any(sentence in found.refused for sentence in sentences)


# ------------------------------------------------------------------------------- singular passages


@pytest.mark.parametrize("h", [0.1, 0.02, 0.01])
@pytest.mark.parametrize("dimension", [2, 3])
def test_a_flat_parallelogram_is_passed_at_every_phase_of_a_step(dimension, h):
    # On the other branch the coupler would turn like the cranks, by radians a second.
    turning = "coupler.angular_velocity" if dimension == 2 else "coupler.wz"
    for phase in range(12):
        text = four_bar(angle=0.3 + 6.0 * h * phase / 12, dimension=dimension)
        names = [turning, "left.y", "energy.error", "constraint.position"]
        end = final(text, h, round(1.0 / h), names)
        assert end["left.y"] < 0.0  # it went through
        assert abs(end[turning]) < 1e-6
        assert end["energy.error"] < ROUND_OFF
        assert end["constraint.position"] < ROUND_OFF


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("away", [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3])
def test_it_may_start_as_near_to_flat_as_one_likes(away, dimension):
    assert_kept(run(four_bar(angle=away, dimension=dimension), 0.01, 100))


# ------------------------------------------------------------------------------------ fast rotation


@pytest.mark.parametrize("pinned", [False, True], ids=["free", "pinned"])
@pytest.mark.parametrize("rate", [1e1, 1e3, 1e5, 1e7, 1e9])
def test_a_body_may_turn_at_any_rate_that_the_step_resolves(rate, pinned):
    assert_kept(run(spinning(rate, pinned=pinned), 0.2 / rate, 300))


ROTOR = """
name = "rotor"
dimension = 2
[bodies.rotor]
position = [0, 0]
mass = 1.0
inertia = 1.0
angular_velocity = 100.0
[joints]
pin = { type = "revolute", bodies = ["ground", "rotor"], position = [0, 0] }
"""


@pytest.mark.parametrize(
    "turn", [1.0, 2.0, 5.0, 2 * math.pi, 4 * math.pi, 20.0, 16 * math.pi, 100.0]
)
def test_whole_turns_in_a_step_are_not_lost(turn):
    # A rotation by 2 pi looks like none at all; a half step of 1.6 rad turns by 2 atan(0.8) of them
    # instead, 16 % less, and none may be shorter by more than that.
    end = final(ROTOR, turn / 100.0, 5, ["pin.angle", "energy.error"])
    assert 0.7 < end["pin.angle"] / (5 * turn) <= 1.0
    assert end["energy.error"] < ROUND_OFF


@pytest.mark.parametrize("turn", [400.0, 1e3, 1e6])
def test_what_turns_too_far_to_tell_is_refused(turn):
    found = run(ROTOR, turn / 100.0, 1)
    assert "turns by more than 2.5 rad" in found.refused


# ----------------------------------------------------------------------------------- all and sundry


def test_nothing_of_the_published_extremes_is_wrong():
    outcomes = {(what, value): run(text, h, 30).outcome for what, value, text, h in _extremes()}
    assert "wrong" not in outcomes.values()


@pytest.mark.parametrize("first", range(0, 60, 10))
def test_random_mechanisms_keep_energy_and_joints(first):
    for seed in range(first, first + 10):
        found = run(random_mechanism(seed), 0.01, 50)
        assert found.outcome.startswith("kept"), (seed, found)


def test_a_run_that_was_wrong_before_it_was_refused_is_wrong():
    assert Found(energy=1e-3, refused="a sentence").outcome == "wrong"
    assert Found(constraint=math.nan).outcome == "wrong"
    assert Found(refused="a sentence").outcome == "refused"
    assert Found(divided=1.5).outcome == "kept, some steps divided"


def bent_links(links: int, bend: float, load: float) -> str:
    """Bars of 1 m and 1 kg in zigzag, each turned by `bend` [rad], and a load at their end."""
    text, pins = 'name = "zigzag"\ndimension = 2\ngravity = [0, -9.81]\n[bodies]\n', ""
    x = y = 0.0
    before = "ground"
    for i in range(links):
        angle = bend if i % 2 else -bend
        c, s = math.cos(angle), math.sin(angle)
        place = f"position = [{x + c / 2!r}, {y + s / 2!r}], orientation = {angle}"
        text += f"b{i} = {{ {place}, mass = 1, inertia = 0.1 }}\n"
        pins += f'j{i} = {{ type = "revolute", bodies = ["{before}", "b{i}"], '
        pins += f"position = [{x!r}, {y!r}] }}\n"
        before, x, y = f"b{i}", x + c, y + s
    text += f"load = {{ position = [{x!r}, {y!r}], mass = {load}, inertia = {load} }}\n"
    pins += (
        f'end = {{ type = "revolute", bodies = ["{before}", "load"], position = [{x!r}, {y!r}] }}'
    )
    return f"{text}[joints]\n{pins}\n"


def thrown_back(links: int, bend: float, end: float) -> float:
    """Height of a load that falls, and is thrown back where its massless chain is straight."""
    angles = [bend if i % 2 else -bend for i in range(links)]
    r, v = np.array([np.cos(angles).sum(), np.sin(angles).sum()]), np.zeros(2)
    g, t = np.array([0.0, -9.81]), 0.0

    def slack(s: float) -> float:
        return float(np.linalg.norm(r + v * s + g * s * s / 2)) - links

    while True:
        times = np.linspace(1e-9, end - t, 4001)
        gaps = np.array([slack(s) for s in times])
        hits = np.flatnonzero((gaps[1:] > 0) & (gaps[:-1] <= 0))
        s = brentq(slack, times[hits[0]], times[hits[0] + 1]) if hits.size else end - t
        r, v, t = r + v * s + g * s * s / 2, v + g * s, t + s
        if not hits.size:
            return float(r[1])
        v -= 2.0 * (v @ r) / (r @ r) * r


@pytest.mark.parametrize("h", [1e-3, 2e-2])
@pytest.mark.parametrize(("links", "bend"), [(2, 0.3), (3, 0.3), (5, 0.3), (10, 0.1)])
def test_a_load_of_1e8_kg_is_thrown_back_where_its_chain_of_light_bars_is_straight(links, bend, h):
    """Links whip there at 1e4 rad/s: steps of 20 ms are divided into 1e4 parts for a moment."""
    run = solver.simulate(
        solver.loads(bent_links(links, bend, 1e8)), step_size=0.02, stop_time=1.0, internal_step=h
    )
    # A step at the end of each of the six falls is h/2 at 3.4 m/s; links take some energy.
    bound = 6 * 3.4 * h / 2 + 0.005 * links
    assert run["load.y"][-1] == pytest.approx(thrown_back(links, bend, 1.0), abs=bound)
    assert run["energy.error"].max() < 1e-12
    assert run["constraint.position"].max() < ROUND_OFF


def test_a_chain_that_lands_far_from_the_origin_is_answered_soon():
    """Bars know their directions to 1e-7 there, so that slips which have stopped keep rests.

    The direction of such a rest turned in millions of steps of one impact, half a minute.
    """
    names = [f"P{k}" for k in range(4)]
    velocity = [-0.33520352567607614, 0.060547479150319994, 0.20089401753662894]
    floor = {"type": "plane", "axis": [0.0, 0.0, 1.0], "position": [1e9, 0.0, -0.002219656122521]}
    content: Content = {
        "name": "far",
        "dimension": 3,
        "gravity": [0.0, 0.0, -9.81],
        "points": {
            P: {"position": [1e9 + 0.8878624 * k, 0.0, 0.0], "mass": 0.0, "velocity": velocity}
            for k, P in enumerate(names)
        },
        "bodies": {
            f"b{k}": {"type": "bar", "points": names[k : k + 2], "mass": 1.0} for k in range(3)
        },
        "contacts": {
            f"at_{P}": floor | {"point": P, "friction": 0.5, "restitution": 0.5} for P in names
        },
        "solver": {
            "step_size": 0.05,
            "tolerance": 1.8e-6,
            "assemble": False,
            "impact_law": "sequential",
            "rest_time": 0.0,
        },
        "experiment": {"step_size": 0.1, "stop_time": 1.0},
    }
    content["contacts"]["at_P0"] |= {"friction": 100.0, "restitution": 1.0}
    scene = solver.loads(json.dumps(content), format="json")
    integrator = Integrator(solver.assemble(scene), log=lambda _: None)
    integrator.initialise()
    begin = time.process_time()
    for k in range(2):
        integrator.advance(0.1 * k, 0.1)
        assert float(integrator["energy.error"]) <= 1e-12
    assert time.process_time() - begin <= 3.0
