"""Stepped mode: contacts change at the ends of half steps, and what they take stays physical."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy import special

import solver
from solver.runtime import Integrator
from tests.support.contact.contact_events import begin, contacts_of, cover, even, number
from tests.support.contact.contact_scenes import (
    ball,
    belt,
    bowling_ball,
    chain_over_a_floor,
    circle,
    painleve_rod,
    pendulum_at_a_stop,
    pile_of_discs,
    slider,
    slider_crank_with_clearance,
)
from tests.support.contact.exact_contacts import loss_of_a_pendulum_that_rubs
from tests.support.mechanisms.problems import GRAVITY, Content, mechanism
from tests.support.mechanisms.problems import scene as solver_scene
from tests.support.mechanisms.scene_files import SCENES

STEPPED: dict[str, Any] = {"contact_mode": "stepped"}
CLOSURE = 1e-12
"""Of the reference energy."""
LEAST_GAP = -1e-12


@pytest.mark.parametrize("h", [0.02, 0.01, 0.004, 0.001])
def test_a_ball_loses_by_impacts_what_its_restitution_says(h):
    # 1 - e^2 of the energy at each of three hits, wherever in a step they fall.
    integrator = begin(ball(), h, **STEPPED)
    passed = cover(integrator, even(2.0, h))
    assert integrator["floor.impacts"] == 3.0
    assert integrator["energy.impact"] == pytest.approx(7.23836736, abs=1e-9)
    assert passed.error <= CLOSURE
    assert passed.gap >= LEAST_GAP
    assert integrator["solver.stepped"] == 1.0


@pytest.mark.parametrize("h", [0.02, 0.01])
def test_an_elastic_ball_keeps_its_energy_over_a_hundred_impacts(h):
    integrator = begin(ball(restitution=1.0), h, **STEPPED)
    cover(integrator, even(91.0, h))
    assert number(integrator, "floor.impacts") >= 100.0
    assert abs(number(integrator, "energy.impact")) <= 1e-10


@pytest.mark.parametrize("h", [0.02, 0.01])
def test_a_ball_comes_to_rest_within_its_zeno_time(h):
    integrator = begin(ball(), h, **STEPPED)
    cover(integrator, even(4.2, h))
    assert integrator["floor.mode"] == 1.0
    assert integrator["energy.impact"] == pytest.approx(GRAVITY, abs=1e-12)
    assert integrator["floor.force"] == pytest.approx(GRAVITY, abs=1e-9)


@pytest.mark.parametrize("h", [0.02, 0.01])
def test_an_elastic_point_in_a_circle_keeps_its_energy(h):
    integrator = begin(circle(1.0), h, **STEPPED)
    passed = cover(integrator, even(20.0, h))
    assert number(integrator, "wall.impacts") > 20.0
    assert abs(number(integrator, "energy.impact")) <= 1e-10
    assert passed.error <= CLOSURE
    assert passed.gap >= LEAST_GAP


@pytest.mark.parametrize(("restitution", "loss"), [(0.5, 6.891693941328), (0.0, 6.504864815522)])
def test_the_loss_in_a_circle_is_right_to_first_order(restitution, loss):
    for h in (0.02, 0.005):
        integrator = begin(circle(restitution), h, **STEPPED)
        cover(integrator, even(20.0, h))
        assert integrator["energy.impact"] == pytest.approx(loss, rel=0.25 * h)


@pytest.mark.parametrize("h", [0.1, 0.05, 0.01, 0.007])
def test_a_slider_stops_where_it_must(h):
    # A slip that stops within a half step goes on until then: v^2/2a, and all is friction's.
    integrator = begin(slider(), h, **STEPPED)
    passed = cover(integrator, even(0.7, h))
    assert integrator["p.x"] == pytest.approx(0.382262996941896, abs=1e-13)
    assert integrator["p.vx"] == pytest.approx(0.0, abs=1e-15)
    assert integrator["energy.friction"] == pytest.approx(1.125, abs=1e-13)
    assert integrator["floor.mode"] == 1.0
    assert passed.error <= CLOSURE


@pytest.mark.parametrize(
    ("content", "until", "h"),
    [
        pytest.param(belt(), 3.0, 0.01, id="belt"),
        pytest.param(bowling_ball(0.6), 1.5, 0.01, id="bowling ball"),
        pytest.param(pendulum_at_a_stop(), 4.0, 0.01, id="pendulum at a stop"),
        pytest.param(slider_crank_with_clearance(), 0.03, 5e-5, id="slider-crank"),
        *(
            pytest.param(painleve_rod(mu, slope), 1.0, 0.01, id=f"rod {mu} {slope}")
            for mu in (0.5, 1.5, 2.5)
            for slope in (0.6, 1.2)
        ),
    ],
)
def test_the_ledger_closes_and_no_gap_is_crossed(content: Content, until, h):
    integrator = begin(content, h, **STEPPED)
    passed = cover(integrator, even(until, h))
    assert passed.error <= CLOSURE
    assert passed.gap >= LEAST_GAP
    assert number(integrator, "energy.dissipated") > 0.0


def test_a_pile_of_discs_comes_to_rest_with_the_same_energy_at_every_step():
    # 273 gaps, of which 42 are closed in the end. The energy at rest is that of the prototype.
    energies = []
    for h in (0.004, 0.002):
        integrator = begin(pile_of_discs(21), h, **STEPPED)
        passed = cover(integrator, even(1.0, 10.0 * h))
        assert passed.error <= CLOSURE
        assert passed.gap >= LEAST_GAP
        assert number(integrator, "energy.kinetic") <= 1e-20
        heights = (number(integrator, f"p{i}.y") for i in range(21))
        energies.append(0.1 * GRAVITY * sum(heights))
    assert energies[0] == pytest.approx(energies[1], abs=1e-9)
    assert energies[0] == pytest.approx(7.187239, abs=1e-6)


def test_a_pile_of_many_discs_rests_and_loses_what_it_falls():
    """More than 60 contacts touch in the end; the energy lost is that of the heights."""
    integrator = begin(pile_of_discs(40), 0.004, **STEPPED)

    def height() -> float:
        return 0.1 * GRAVITY * sum(number(integrator, f"p{i}.y") for i in range(40))

    before = height()
    passed = cover(integrator, even(1.2, 0.04))
    assert passed.error <= CLOSURE
    assert passed.gap >= LEAST_GAP
    assert sum(number(integrator, f"{name}.mode") > 0 for name in contacts_of(integrator)) > 60
    assert number(integrator, "energy.kinetic") <= 1e-12
    assert number(integrator, "energy.impact") == pytest.approx(before - height(), rel=1e-9)


@pytest.mark.parametrize("drop", [0.0, 0.01], ids=["at rest", "falls"])
def test_two_piles_apart_move_as_one_alone_does(drop: float):
    """Each is an island of 33 gaps: factors of both at once serve the solves of each alone."""
    one = pile_of_discs(6)
    for i in range(6):
        one["points"][f"p{i}"]["position"] = [0.05 + 0.104 * (i % 3), 0.05 + 0.1 * (i // 3) + drop]
    both = {**one, "points": dict(one["points"]), "contacts": dict(one["contacts"])}
    for table in ("points", "contacts"):
        for name, part in list(both[table].items()):
            copy = both[table][f"{name}_b"] = dict(part)
            if table == "points":
                copy["position"] = [part["position"][0] + 8.0, part["position"][1]]
            elif "point" in part:
                copy["point"] = part["point"] + "_b"
                copy["position"] = [part["position"][0] + 8.0, part["position"][1]]
            else:
                copy["points"] = [point + "_b" for point in part["points"]]
    alone, pair = (begin(content, 0.004, **STEPPED) for content in (one, both))
    for t in even(0.4, 0.04):
        for integrator in (alone, pair):
            integrator.advance(integrator.time, t - integrator.time)
    for i in range(6):
        for axis, shift in (("x", 8.0), ("y", 0.0)):
            expected = number(alone, f"p{i}.{axis}")
            assert number(pair, f"p{i}.{axis}") == pytest.approx(expected, abs=1e-11)
            assert number(pair, f"p{i}_b.{axis}") == pytest.approx(expected + shift, abs=1e-11)


@pytest.mark.parametrize("h", [0.005, 0.0025])
def test_a_chain_that_falls_on_a_floor_comes_to_rest(h):
    integrator = begin(chain_over_a_floor(), h, **STEPPED)
    passed = cover(integrator, even(1.5, 10.0 * h))
    assert passed.error <= CLOSURE
    assert passed.gap >= LEAST_GAP
    assert number(integrator, "energy.kinetic") <= 1e-20
    assert sum(number(integrator, f"{name}.mode") > 0.0 for name in contacts_of(integrator)) >= 8


@pytest.mark.parametrize("settings", [{}, {"tolerance": 1e-6}], ids=str)
@pytest.mark.parametrize("order", [2, 4])
def test_located_mode_steps_over_the_zeno_time_of_a_ball(order: int, settings: dict[str, Any]):
    # Flights of e^n get shorter without end until 4.06371276887158 s: infinitely many events.
    integrator = begin(ball(), 0.01, order, rest_speed=0.0, rest_time=0.0, **settings)
    cover(integrator, [3.0])
    assert integrator["solver.stepped"] == 0.0
    passed = cover(integrator, [4.1])
    assert integrator["solver.stepped"] == 1.0
    assert number(integrator, "solver.events") >= 50.0
    assert passed.error <= CLOSURE
    cover(integrator, [4.2, 4.3])
    assert integrator["solver.stepped"] == 0.0
    assert integrator["floor.mode"] == 1.0
    assert integrator["energy.impact"] == pytest.approx(GRAVITY, abs=1e-12)


def test_stepped_runs_continue_from_a_saved_state_bit_for_bit():
    whole = begin(pile_of_discs(6), 0.004, **STEPPED)
    cover(whole, even(0.4, 0.004))
    first, second = (begin(pile_of_discs(6), 0.004, **STEPPED) for _ in range(2))
    cover(first, even(0.4, 0.004)[:50])
    second.restore(first.save())
    cover(second, even(0.4, 0.004)[50:])
    assert [whole[f"p{i}.y"] for i in range(6)] == [second[f"p{i}.y"] for i in range(6)]


def test_stepped_mode_says_once_that_its_order_is_2():
    sentences: list[str] = []
    scene = solver_scene(ball(), order=4, step_size=0.01, **STEPPED)
    integrator = Integrator(solver.assemble(scene), log=sentences.append)
    integrator.initialise()
    cover(integrator, even(1.0, 0.1))
    assert integrator["solver.order_in_use"] == 2.0
    assert sum("of order 2" in sentence for sentence in sentences) == 1


@pytest.mark.parametrize("h", [0.05, 0.02, 0.005])
def test_neither_friction_nor_impacts_give_energy(h):
    # A spinning block lands on a corner that rubs and one that does not, in one half step.
    floor = {"type": "plane", "axis": [0, 1]}
    content = mechanism(
        "block",
        2,
        bodies={
            "b": {
                "position": [0.0, 0.013],
                "angular_velocity": -5.0,
                "mass": 0.8,
                "inertia": 6e-5,
                "points": {"l": [-0.02, -0.013], "r": [0.02, -0.013]},
            }
        },
        contacts={
            "left": floor | {"point": "b.l", "restitution": 1.0, "friction": 0.5},
            "right": floor | {"point": "b.r", "restitution": 0.5},
        },
    )
    integrator = begin(content, h, **STEPPED)
    losses = np.zeros(2)
    for t in even(0.3, h):
        integrator.advance(integrator.time, t - integrator.time)
        before = losses
        losses = np.array([number(integrator, f"energy.{word}") for word in ("friction", "impact")])
        assert np.all(losses >= before - 1e-17)
    assert losses.sum() > 0.0


@pytest.mark.parametrize("h", [2e-3, 1e-3, 5e-4])
def test_a_pin_that_is_drawn_in_the_middle_of_its_hole_leaves_it_when_it_would_pull(h):
    """The gap has no gradient there, and no scale of its force; friction is as in located mode."""
    path, names = SCENES / "four_bar_with_clearance.toml", ["pin.force", "energy.friction"]
    located = solver.simulate(path, outputs=names)
    found = solver.simulate(
        path, outputs=[*names, "pin.impacts", "energy.error"], contact_mode="stepped", step_size=h
    )
    assert found["energy.friction"][-1] == pytest.approx(
        located["energy.friction"][-1], rel=0.04 * h / 2e-3
    )
    assert found["pin.impacts"][-1] > 5
    assert found["energy.error"].max() < 1e-12


@pytest.mark.parametrize("h", [1e-2, 1e-3])
def test_a_bearing_that_rubs_goes_on_the_other_way_when_its_pendulum_rebounds(h):
    """Located, it rubs all along the hit: mu r |P| with P = m l dw/2, c = mu r m l/2.

    While the stop presses (I - c) dw = dQ, while it gives back (I + c) dw = dQ with the moment Q
    of the stop, so that the rate after is e ((I - c)/(I + c))^(1/2) of that before. Stepped, it
    rubs for a part of the hit only: no less than not at all, e, and no more than all along.
    """
    path, names = SCENES / "pendulum_with_stop.toml", ["energy.dissipated", "energy.error"]
    e, inertia, c = 0.7, 0.5, 0.1 * 0.02 * 0.5
    all_along = loss_of_a_pendulum_that_rubs(6.0, e * np.sqrt((inertia - c) / (inertia + c)))
    not_at_all = loss_of_a_pendulum_that_rubs(6.0, e)
    located = solver.simulate(path, outputs=names, stop_time=6.0)
    assert located["energy.dissipated"][-1] == pytest.approx(all_along, rel=1e-9)
    found = solver.simulate(
        path, outputs=[*names, "stop.impacts"], stop_time=6.0, step_size=h, order=2,
        contact_mode="stepped",
    )  # fmt: skip
    assert found["stop.impacts"][-1] == 4.0
    assert not_at_all < found["energy.dissipated"][-1] < all_along
    assert found["energy.error"].max() < 1e-12


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ({"tolerance": 1e-6}, "the tolerance is 1e-06"),
        ({"tolerance": 1e-6, "order": 4}, "the tolerance is 1e-06"),
        ({"order": 4}, "solver.order is 4"),
        ({}, ""),
    ],
    ids=str,
)
def test_a_run_that_does_not_follow_its_settings_says_so_once(setting, said):
    model = solver.assemble(solver_scene(ball()))
    sentences: list[str] = []
    integrator = Integrator(model, log=sentences.append)
    for name, value in ({"step_size": 0.01} | STEPPED | setting).items():
        integrator[f"solver.{name}"] = value
    for _ in range(3):
        integrator.advance(integrator.time, 0.1)
    assert len(sentences) == bool(said)
    assert all(sentence.startswith(said) for sentence in sentences)
    assert ("tolerance" in setting) == any("equal steps" in sentence for sentence in sentences)


@pytest.mark.parametrize("height", [0.0, 0.3])
@pytest.mark.parametrize("along", [[1.0, 0.0], [0.0, 1.0]], ids=["along", "away"])
def test_a_point_without_weight_starts_from_rest_under_a_force_that_grows(along, height):
    """There is no energy before the first half step to measure that one's ledger by.

    By hand x = (t^2/2 + t^3/6)/m. A half step h has the force of its middle, which adds h^3/12m.
    """
    mass, h = 3.7, 0.005
    content = mechanism(
        "push",
        2,
        gravity=False,
        points={"P": {"position": [0.0, height], "mass": mass}},
        contacts={"floor": {"type": "plane", "point": "P", "axis": [0, 1]}},
        forces={"push": {"type": "force", "point": "P", "value": [f"{a}*(1 + t)" for a in along]}},
    )
    integrator = begin(content, 2 * h, **STEPPED)
    passed = cover(integrator, even(1.0, 2 * h))
    moved = along[0] * number(integrator, "P.x") + along[1] * (number(integrator, "P.y") - height)
    assert moved == pytest.approx((1 / 2 + 1 / 6) / mass, abs=1.001 * h**2 / 12 / mass)
    assert passed.error <= CLOSURE


def row_of_balls(n: int, before: float, **contact: float) -> Content:
    """Equal balls that touch, of which the first moves at the others, that far from them [m]."""
    balls = {f"b{k}": {"position": [k + before * (k > 0), 0], "mass": 0.5} for k in range(n)}
    balls["b0"]["velocity"] = [1.0, 0.0]
    ball_on_ball = {"type": "sphere", "radii": [0.5, 0.5], **contact}
    pairs = {f"c{k}": ball_on_ball | {"points": [f"b{k}", f"b{k + 1}"]} for k in range(n - 1)}
    return mechanism("balls", 2, gravity=False, points=balls, contacts=pairs)


@pytest.mark.parametrize("h", [0.02, 0.007])
@pytest.mark.parametrize(
    ("law", "after"),
    [("sequential", [0, 0, 0, 0, 1]), ("simultaneous", [-0.6, 0.4, 0.4, 0.4, 0.4])],
)
def test_touching_balls_part_by_the_law_of_impact_that_the_scene_asks_for(law, after, h):
    """Of five equal balls the first hits the others; both rates keep momentum and energy."""
    integrator = begin(row_of_balls(5, 0.05, restitution=1.0), h, impact_law=law, **STEPPED)
    passed = cover(integrator, even(0.2, h))
    rates = [number(integrator, f"b{k}.vx") for k in range(5)]
    assert rates == pytest.approx(after, abs=1e-12)
    assert passed.error <= CLOSURE
    hit = [number(integrator, f"c{k}.impacts") for k in range(4)]
    assert hit == ([1.0] * 4 if law == "sequential" else [1.0, 0.0, 0.0, 0.0])


@pytest.mark.parametrize(
    ("friction", "restitution", "after"),
    [(0.0, 1.0, [0.0] * 69 + [1.0]), (0.1, 1.0, [0.0] * 69 + [1.0]), (0.1, 0.0, [1 / 70] * 70)],
)
def test_a_hit_goes_through_seventy_balls_one_by_one(friction, restitution, after):
    """Equal balls change their rates, one after the other, or go on together."""
    content = row_of_balls(70, 0.0, restitution=restitution, friction=friction)
    integrator = begin(content, 0.01, impact_law="sequential", **STEPPED)
    passed = cover(integrator, even(0.05, 0.01))
    rates = [number(integrator, f"b{k}.vx") for k in range(70)]
    assert rates == pytest.approx(after, abs=1e-12)
    assert passed.error <= CLOSURE


def test_the_last_ball_of_a_cradle_swings_as_far_as_the_first_one_did():
    """By energy; when it comes to rest, half a period of a pendulum, with its elliptic integral."""
    half = 2 * special.ellipk(math.sin(0.3) ** 2) * math.sqrt(0.5 / 9.81)
    errors = []
    for h in (4e-3, 1e-3):
        run = solver.simulate(
            SCENES / "newtons_cradle.toml",
            stop_time=half,
            step_size=half / 20,
            outputs=["first", "last", "energy.impact"],
            contact_mode="stepped",
            internal_step=h,
            order=2,
        )
        errors.append(max(abs(run["last"][-1] - 0.6), abs(run["first"][-1])))
        assert abs(run["energy.impact"][-1]) < 1e-4 * 0.25 * 9.81 * 0.5 * (1 - math.cos(0.6))
    assert errors[1] < errors[0] < 4e-3


@pytest.mark.parametrize("links", [3, 5])
@pytest.mark.parametrize("h", [1e-4, 5e-4])
def test_friction_of_a_chain_that_glides_without_load_gives_no_energy(links, h):
    # No weight presses it: the normal forces behind the impact are round-off, of both signs.
    names = [f"P{k}" for k in range(links + 1)]
    point = {"mass": 0.0, "velocity": [-0.22, -0.045]}
    law = {"type": "plane", "axis": [0.0, 1.0], "friction": 0.5}
    content: Content = {
        "name": "gliding_chain",
        "dimension": 2,
        "points": {P: {"position": [0.4 * k, 0.0]} | point for k, P in enumerate(names)},
        "bodies": {
            f"b{k}": {"type": "bar", "points": names[k : k + 2], "mass": 1.0} for k in range(links)
        },
        "contacts": {f"at_{P}": law | {"point": P} for P in names},
    }
    content["contacts"]["at_P0"]["restitution"] = 0.5
    content["contacts"][f"at_{names[-1]}"]["friction"] = 0.0
    integrator = begin(content, h, **STEPPED)
    losses = np.zeros(2)
    for _ in range(20):
        integrator.advance(integrator.time, h)
        found = [number(integrator, f"energy.{word}") for word in ("impact", "friction")]
        assert np.min(found - losses) >= -1e-14
        losses = np.array(found)


def test_ends_of_a_rod_that_stop_in_the_half_step_of_a_landing_are_found_in_few_choices():
    # A stiff rod whose upper end lands cannot have both ends at rest on the mean of that half step:
    # they stop at its start. A choice takes 2 to 8 increments, and 60 in turn end the search.
    scene = solver.load(SCENES / "falling_rod.toml", {"solver.contact_mode": "stepped"})
    integrator = Integrator(solver.assemble(scene), log=lambda _: None)
    integrator.initialise()
    for k in range(50):
        integrator.advance(0.01 * k, 0.01)
        assert integrator.state.head["newton_iterations"] <= 100
    assert integrator["lower_end.mode"] == integrator["upper_end.mode"] == 2.0


def test_two_hits_of_a_die_are_told_apart_by_steps_shorter_than_the_time_between_them():
    # Two corners land 0.4 ms one after the other, which a step of 2 ms takes for one impact.
    lost = []
    for settings in ({"order": 4}, STEPPED | {"step_size": 1e-4}, STEPPED | {"step_size": 2e-3}):
        over = {f"solver.{name}": value for name, value in settings.items()}
        scene = solver.load(SCENES / "die_in_a_bowl.toml", over)
        table = solver.simulate(scene, stop_time=0.2, outputs=["energy.impact"])
        lost.append(table["energy.impact"][-1])
    located, fine, coarse = lost
    assert fine == pytest.approx(located, rel=1e-3)
    assert abs(coarse - located) > 0.05 * located
