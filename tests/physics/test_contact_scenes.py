"""The scenes with contacts and friction: their whole experiment, and one thing each that is known.

Numbers without another origin are closed forms, or events of reduced equations solved to 1e-12.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import solver
from solver.runtime import Integrator, Model
from tests.support.contact import woodpecker
from tests.support.contact.contact_events import contacts_of, number
from tests.support.mechanisms.problems import GRAVITY, observed_order
from tests.support.mechanisms.scene_files import SCENES, TOUCHING

LOSSES = ("energy.friction", "energy.impact")
NAMES = [path.stem for path in TOUCHING]
PLAY = "slider_crank_with_play_in_the_guide"


@cache
def played(name: str) -> dict[str, NDArray[np.float64]]:
    """All outputs of a scene's own experiment, at its communication points."""
    integrator = begin(name)
    experiment = integrator.model.experiment
    numbers = [v for v in integrator.model.variables if v.causality == "output"]
    places = [integrator.model.index(variable.name) for variable in numbers]
    rows = [integrator.get(places)]
    for _ in range(round(experiment.stop_time / experiment.step_size)):
        integrator.advance(integrator.time, experiment.step_size)
        rows.append(integrator.get(places))
    values = np.array(rows, dtype=float)
    return {variable.name: values[:, i] for i, variable in enumerate(numbers)}


@cache
def model(name: str, **settings: float) -> Model:
    """Return an assembled scene, with other parameters if any."""
    return solver.assemble(solver.load(SCENES / f"{name}.toml", settings))


def begin(name: str, **settings: float) -> Integrator:
    """Return a scene at its start."""
    integrator = Integrator(model(name, **settings))
    integrator.initialise()
    return integrator


def until(integrator: Integrator, time: float) -> Integrator:
    """Advance a scene in its own communication steps, the last one cut."""
    step = integrator.model.experiment.step_size
    while integrator.time < time - 1e-9:
        integrator.advance(integrator.time, min(step, time - integrator.time))
    return integrator


@pytest.mark.parametrize("name", NAMES)
def test_the_ledger_closes_and_what_is_lost_never_comes_back(name):
    found = played(name)
    assert found["energy.error"].max() <= 1e-11
    for loss in LOSSES:
        assert np.diff(found[loss]).min() >= -1e-15 * max(1.0, found[loss].max())


@pytest.mark.parametrize("name", NAMES)
def test_nothing_penetrates_and_nothing_pulls(name):
    found = played(name)
    for contact in contacts_of(begin(name)):
        assert found[f"{contact}.gap"].min() >= -1e-10
        assert found[f"{contact}.force"].min() >= 0.0


def test_a_slider_with_play_stays_within_it_and_meets_both_walls():
    found = played(PLAY)
    corners = ("upper_left", "upper_right", "lower_left", "lower_right")
    for corner in corners:
        assert found[f"{corner}.impacts"][-1] >= 5.0
        assert found[f"{corner}.gap"].max() <= 0.002 + 1e-4  # a tilted corner is no higher
    assert np.abs(found["slider.y"]).max() <= 0.001 + 1e-10


def test_a_slider_with_play_meets_its_wall_when_two_free_bars_carry_it_there():
    # Until then the slider, which hangs at its centre of mass, is a mass at the end of the rod.
    crank, rod, slider = 0.038, 0.038, 0.076
    a, b = 0.153, 0.306
    own = 7.4e-5 + crank * a**2 / 4.0 + (rod + slider) * a**2
    far, mixed = 5.9e-4 + rod * b**2 / 4.0 + slider * b**2, (rod / 2.0 + slider) * a * b
    torque = GRAVITY * np.array([a * (crank / 2.0 + rod + slider), b * (rod / 2.0 + slider)])

    def rates(_: float, x: NDArray[np.float64]) -> NDArray[Any]:
        c, s = mixed * math.cos(x[0] - x[1]), mixed * math.sin(x[0] - x[1])
        force = np.array([-s * x[3] ** 2, s * x[2] ** 2]) - torque * np.cos(x[:2])
        return np.concatenate([x[2:], np.linalg.solve([[own, c], [c, far]], force)])

    def room(_: float, x: NDArray[np.float64]) -> float:
        return 1e-3 - abs(a * math.sin(x[0]) + b * math.sin(x[1]))

    room.terminal = True  # pyright: ignore
    start = [0.0, 0.0, 150.0, -75.0]
    ran = solve_ivp(rates, (0.0, 0.01), start, "DOP853", events=room, rtol=1e-12, atol=1e-12)
    hit = ran.t_events[0][0]
    integrator = until(begin(PLAY), hit - 1e-6)
    assert integrator["energy.impact"] == 0.0
    until(integrator, hit + 1e-6)
    assert (integrator["upper_left.impacts"], integrator["upper_right.impacts"]) == (1.0, 1.0)


def test_a_worn_pin_lets_the_foot_of_a_leg_miss_its_path_by_millimetres():
    found = played("jansen_with_clearance")
    exact = solver.simulate(
        SCENES / "jansen.toml", outputs=["foot.x", "foot.y"], stop_time=3.0, step_size=0.02
    )
    miss = np.hypot(found["foot.x"] - exact["foot.x"], found["foot.y"] - exact["foot.y"])
    assert 5e-4 < miss.max() < 1e-2


def test_a_worn_pin_of_a_four_bar_linkage_knocks_and_rubs():
    found = played("four_bar_with_clearance")
    assert found["pin.impacts"][-1] >= 5.0
    assert found["energy.friction"][-1] > found["energy.impact"][-1] > 0.0


def test_the_woodpecker_pecks_in_a_rhythm_and_sinks_by_equal_steps():
    found = played("woodpecker_toy")
    pecks = np.flatnonzero(np.diff(found["beak.impacts"]))
    exact = woodpecker.pecks(2.0)
    assert len(pecks) == len(exact) == 11
    step, internal = 0.005, 0.0005  # the latter's error of places is that of order 2
    assert np.abs(step * (pecks + 0.5) - exact).max() <= 0.5 * step + internal
    periods, drops = np.diff(pecks)[2:], np.diff(found["bird.y"][pecks])[2:]
    assert np.ptp(periods) <= 1  # communication steps of 5 ms
    assert drops.max() < 0.0
    assert np.ptp(drops) < 0.05 * abs(drops.mean())


def test_the_tippe_top_turns_over_and_keeps_jelletts_integral():
    # Friction acts at the end of the arm that the integral is taken with: it has no share in it.
    found = played("tippe_top")
    assert found["tilt"][0] < 0.2
    assert found["tilt"].max() > 3.0
    assert found["jellett"] == pytest.approx(found["jellett"][0], rel=1e-7)
    assert found["table.mode"][300] == 2.0
    assert found["table.mode"][-1] == 1.0  # it rolls
    assert np.ptp(found["energy.friction"][-20:]) == 0.0


@pytest.mark.parametrize("order", [2, 4])
def test_jelletts_integral_converges_with_the_order(order):
    errors, steps = [], [2e-3, 1e-3, 5e-4]
    for h in steps:
        scene = solver.load(
            SCENES / "tippe_top.toml", {"solver.step_size": h, "solver.order": order}
        )
        found = solver.simulate(scene, outputs=["jellett"], stop_time=1.0)["jellett"]
        errors.append(np.abs(found / found[0] - 1.0).max())
    assert observed_order(steps, errors) == pytest.approx(order, abs=0.3)


def test_a_wheel_crosses_the_backlash_when_it_should_and_rattles_on_both_flanks():
    # 0.02/2 sin(40 t) + 0.2/(2 0.05) t^2 of 0.005 rad; the pinion's engine feels no knock.
    root = brentq(lambda t: 0.01 * math.sin(40.0 * t) + 2.0 * t**2 - 0.005, 0.0, 0.03)
    closes = float(root)  # pyright: ignore
    integrator = until(begin("gear_pair_with_backlash"), closes - 1e-7)
    assert integrator["teeth.impacts"] == 0.0
    assert until(integrator, closes + 1e-7)["teeth.impacts"] == 1.0
    rate = 0.4 * math.cos(40.0 * closes) + 4.0 * closes
    assert integrator["energy.impact"] == pytest.approx(0.75 * 0.025 * rate**2, rel=1e-6)
    play = played("gear_pair_with_backlash")["play"]
    assert play.max() == pytest.approx(0.005, abs=1e-10)
    assert play.min() < -0.0049


def test_a_die_tumbles_into_a_bowl_and_rests_on_a_face():
    """Three corners carry it; the normals there lean a little, and friction has a part of it."""
    found = played("die_in_a_bowl")
    assert found["bowl.impacts"][-1] >= 20.0
    assert found["energy.kinetic"][-1] <= 1e-12
    assert found["bowl.force"][-1] == pytest.approx(0.2 * 9.81, rel=0.02)
    assert found["energy.friction"][-1] > 0.005


def test_a_ratchet_gives_way_by_less_than_a_tooth_and_advances():
    # Its torque has no mean. Twelve teeth; forwards is clockwise.
    angle = played("ratchet")["bearing.angle"]
    back = angle - np.minimum.accumulate(angle)
    assert 0.1 < back.max() < math.pi / 6.0
    assert angle[-1] < -4.0 * math.pi / 6.0


def deviation_of_geneva_wheel(
    turn: NDArray[np.float64], angle: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Turn of the wheel beyond that of a drive without play [rad].

    `turn` is that of the pin from the line of both axes; it is in a slot for less than pi/4.
    """
    turns = np.round(turn / (2.0 * math.pi))
    in_slot = np.clip(turn - 2.0 * math.pi * turns, -math.pi / 4.0, math.pi / 4.0)
    closed = np.arctan2(np.sin(in_slot), math.sqrt(2.0) - np.cos(in_slot))
    return angle + math.pi / 4.0 + closed + 0.5 * math.pi * turns


def test_a_geneva_wheel_turns_by_a_quarter_in_each_turn_and_dwells():
    # As in a drive without play, up to the play of 0.1 mm: of the pin in a slot at its distance
    # from the axis, and of the tips, at 40 mm.
    found = played("geneva_drive")
    turn = found["shaft.angle"] - 0.5 * math.pi
    beyond = deviation_of_geneva_wheel(turn, found["bearing.angle"])
    distance = 0.04 * np.sqrt(3.0 - 2.0 * math.sqrt(2.0) * np.cos(turn))
    engaged = np.cos(turn) > math.sqrt(0.5)
    assert np.abs(distance * beyond)[engaged].max() <= 1.03e-4  # it is slightly more at the mouth
    assert np.abs(0.04 * beyond)[~engaged].max() <= 1.03e-4
    assert found["bearing.angle"][-1] == pytest.approx(-math.pi, abs=3e-3)
    assert found["pin.impacts"][-1] >= 4.0  # both walls of two slots


@pytest.mark.parametrize("load", [-0.02, 0.02])
def test_the_lock_of_a_geneva_wheel_holds_a_load_either_way(load):
    # From 97 to 263 degrees, where two tips are at the disc: the wheel turns until one of them is
    # 33 mm from the axis instead of 33.1 mm, and a little further where the disc's edge is near.
    axes, radius = 0.04 * math.sqrt(2.0), 0.04
    reach = [
        math.acos((axes**2 + radius**2 - disc**2) / (2.0 * axes * radius))
        for disc in (0.033, 0.0331)
    ]
    play = reach[1] - reach[0]
    integrator = until(begin("geneva_drive", load=load), 0.5)
    for time in np.linspace(0.52, 0.98, 24):
        until(integrator, time)
        turn = np.array([number(integrator, "shaft.angle") - 0.5 * math.pi])
        angle = number(integrator, "bearing.angle")
        (beyond,) = deviation_of_geneva_wheel(turn, np.array([angle]))
        assert beyond == pytest.approx(math.copysign(play, load), rel=0.025)


def test_a_ball_on_a_green_slides_until_it_rolls_and_then_keeps_its_energy():
    found = played("putting_green")
    modes = found["green.mode"]
    rolls = np.flatnonzero(modes == 1.0)
    assert set(modes[: rolls[0]]) == {2.0}
    assert set(modes[rolls[0] :]) == {1.0}
    assert np.ptp(found["energy.friction"][rolls]) <= 1e-15
    speed2 = sum(found[f"ball.v{axis}"][rolls] ** 2 for axis in "xyz")
    rolling = 0.0459 * (0.7 * speed2 + 9.81 * found["ball.z"][rolls])
    assert rolling == pytest.approx(found["energy.total"][rolls], rel=3e-4)  # of order 2
    assert np.ptp(found["ball.z"]) > 0.03


def test_a_stick_comes_to_rest_across_another_one():
    found = played("crossed_sticks")
    assert found["sticks.impacts"][-1] >= 1.0
    assert (found["sticks.mode"][-1], found["upper_floor.mode"][-1]) == (1.0, 1.0)


def test_a_caltrop_tips_a_plank_and_comes_to_stand_on_a_face_on_the_floor():
    """Its centre is a/sqrt(24) above a face whose edges are a; the plank has left its block."""
    found = played("caltrop")
    assert found["hit.impacts"][-1] >= 1.0
    assert found["caltrop.z"][-1] == pytest.approx(0.1 / math.sqrt(24.0), abs=1e-8)
    assert found["caltrop_floor.force"][-1] == pytest.approx(0.5 * GRAVITY, rel=1e-6)
    assert found["support.mode"][-1] == 0.0
