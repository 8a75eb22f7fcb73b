"""Bodies, quantities, functions and drivers of models written by hand, against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from solver.runtime import Status
from tests import hand_scenes
from tests.hand_models import Hand
from tests.hand_runs import Run
from tests.kernel_calls import kernel_of

G = 9.81


# --------------------------------------------------------------------------- bodies


@pytest.mark.parametrize("law", [{}, {"damping": 0.0, "drive": 0.0}])
def test_the_ledger_of_a_planar_body_closes_to_round_off(law):
    run = Run(hand_scenes.planar_body(**law), step_size=0.05)
    run.advance(40)
    assert run["energy"][6] < 1e-14
    assert run["residual"][0] < 1e-15
    assert (run["energy"][4] > 0.0) == (law == {})


def test_a_physical_pendulum_swings_with_its_moment_about_the_pivot():
    """Released level, w^2 = 2 m g l sin(phi)/(m l^2 + I)."""
    still = {"stiffness": 0.0, "damping": 0.0, "drive": 0.0}
    hand = hand_scenes.planar_body(**still)
    hand.tables["load_form"], hand.tables["load_axes"], hand.numbers["load"] = [], [], []
    hand.tables["moment_form"], hand.numbers["moment"] = [], []
    run = Run(hand, step_size=0.01)
    run.advance(50)
    angle, rate = run["quantity"][0], run["quantity_rate"][0]
    # energy is exact; the velocity's part across the constraints, of size h^2, is not
    assert rate**2 == pytest.approx(1.0 - 2.0 * 2.0 * G * math.sin(angle) / 2.3, rel=1e-4)


def test_a_heavy_top_keeps_its_energy_and_its_vertical_momentum():
    """Axis after 2 s, of DOP853 at 1e-13; A = 5, C = 1, m g l = 20."""
    run = Run(hand_scenes.heavy_top(), step_size=0.01)
    before = run["energy"][2], run["angular_momentum"][2]
    assert before[0] == pytest.approx(1269.9750052078996, rel=1e-15)
    run.advance(200)
    assert run["energy"][2] == pytest.approx(before[0], rel=1e-14)
    assert run["angular_momentum"][2] == pytest.approx(before[1], rel=1e-13)
    # second order: 1.8e-5 was measured at half the step
    assert run["position"][9:12] == pytest.approx([0.03801721, -0.03291846, 0.99873473], abs=1e-4)


def test_a_free_body_keeps_both_momenta_and_its_quaternion_is_continuous():
    hand = Hand(3)
    nodes = hand.body([0, 0, 0], [2.0, 1.0, 0.1], velocity=[1.0, 2.0, 3.0], rate=[0.1, 5.0, 0.1])
    hand.tables["body_node"] = [nodes[1]]
    run = Run(hand, step_size=0.02)
    before, last = run["angular_momentum"], run["quaternion"]
    for _ in range(40):
        run.advance(1)
        assert last @ run["quaternion"] > 0.9
        last = run["quaternion"]
    assert run["angular_momentum"] == pytest.approx(before, rel=1e-13)
    assert run["momentum"] == pytest.approx([1.0, 2.0, 3.0], rel=1e-14)
    assert run["body_rate"] @ run["body_rate"] > 20.0
    assert np.linalg.norm(last) == pytest.approx(1.0, rel=1e-15)


@pytest.mark.parametrize("frame", [0, 1])
def test_a_moment_turns_a_free_body_by_the_law_of_angular_momentum(frame):
    """A sphere about a fixed axis: L = m t in both frames, work m phi."""
    hand = Hand(3)
    nodes = hand.body([0, 0, 0], [0.5] * 3)
    hand.tables["body_moment"] = [nodes[1], frame]
    hand.numbers["body_moment"] = [0.0, 0.0, 2.0]
    run = Run(hand, step_size=0.05)
    run.advance(20)
    assert run["angular_momentum"] == pytest.approx([0.0, 0.0, 2.0], abs=1e-13)
    assert run["energy"][3] == pytest.approx(2.0**2 / (2.0 * 1.0), rel=1e-3)  # L^2/(2 J), order 2
    assert run["energy"][6] < 1e-14


def test_a_body_that_would_turn_too_far_in_a_step_is_refused():
    """Forty turns a second against half steps of 0.1 s, and in the end of 0.1/64 s."""
    for speed, status in ((2.0 * math.pi * 40.0, Status.OK), (1e5, Status.TURN_TOO_LARGE)):
        hand = Hand(3)
        hand.body([0, 0, 0], [0.5] * 3, rate=[0.0, 0.0, speed])
        run = Run(hand, step_size=0.2)
        assert Status(kernel_of(run).advance(0.2)) is status
    assert run.vector("q")[:3] == pytest.approx([0.0] * 3)


def test_two_bodies_with_all_kinds_of_loads_close_their_ledger():
    run = Run(hand_scenes.two_bodies(), step_size=0.01)
    run.advance(20)
    assert run["energy"][3] > 0.5
    assert run["energy"][6] < 1e-14


def test_the_reaction_of_a_hinge_balances_a_hanging_body():
    """At rest: the weight at the hinge, and the torque of the weight about it."""
    hand = Hand(3, [0.0, 0.0, -G])
    wall, ground = hand.fixed([0.0, 0.0, 0.0]), hand_scenes.axes(hand)
    r, *d = hand.body([0.5, 0.2, 0.0], [0.1, 0.2, 0.3], mass=2.0)
    first = len(hand.tables["row_form"])
    for a, b in ((0, 1), (1, 2), (2, 0)):
        hand.row(hand.form({ground[a]: 1.0}, {d[b]: 1.0}), 0.0, 1.0)
    hand.coincidence(hand.form({wall: 1.0, r: -1.0, d[0]: 0.5, d[1]: 0.2}, {}))
    entries = [[0, 0, 0, 1], *([0, 2, first + k, 1] for k in range(3))]
    hand.tables["reaction_entry"] = [x for entry in entries for x in entry]
    hand.flags["n_reactions"] = 1
    run = Run(hand)
    run.advance(2)
    assert run["reaction_force"] == pytest.approx([0.0, 0.0, 2.0 * G], abs=1e-9)
    # about the centre of mass: the hinge's force has the arm (-0.5, -0.2, 0)
    assert run["reaction_torque"] == pytest.approx([0.4 * G, -G, 0.0], abs=1e-9)


# --------------------------------------------------------------------------- functions


def test_functions_of_quantities_hold_and_close_the_ledger():
    """Gear, sliding on a sine, rolling and a potential that is no quadratic."""
    run = Run(hand_scenes.functions(), step_size=0.02)
    x_start, turn_start = run["quantity"][3], run["quantity"][2]
    run.advance(10)
    first, second, third, x, y, _ = run["quantity"]
    assert first + 2.0 * second == pytest.approx(0.0, abs=1e-15)
    assert y == pytest.approx(2.0 + math.sin(x), abs=1e-15)
    assert x - x_start == pytest.approx(-0.4 * (third - turn_start), abs=1e-15)
    assert run["energy"][6] < 1e-14


def test_the_intermediate_configuration_conserves_energy_and_not_momentum():
    """Numerics 2.4: only the invariant form conserves both. Row |b - a|^4 + |c - b|^4 = const."""
    kept = {}
    for formulation in ("conserving-al", "conserving-al-beta"):
        hand = Hand(2)
        a = hand.free([0.5, 0.0], [0.0, 1.0], 1.0)
        b = hand.free([-0.4, 0.3], [0.3, -0.5], 3.0)
        c = hand.free([-1.0, -0.3], [-0.3, 0.5], 0.5)
        gaps = [hand.quantity(0, hand.form({x: 1.0, y: -1.0})) for x, y in ((a, b), (b, c))]
        total = hand.constant(0.9**2 + 0.72**2)
        quartic = [("mul", 0, 0), ("mul", 1, 1), ("add", 2, 3), ("sub", 4, total)]
        hand.function("row", [(0, gap) for gap in gaps], quartic)
        run = Run(hand, formulation=formulation, step_size=0.1, assemble=True)
        before = run["angular_momentum"][0]
        run.advance(20)
        assert run["energy"][6] < 1e-12
        kept[formulation] = abs(run["angular_momentum"][0] - before)
    assert kept["conserving-al"] < 1e-13
    assert kept["conserving-al-beta"] > 1e-6


# --------------------------------------------------------------------------- drivers


def test_a_driven_pin_moves_the_slider_and_its_work_is_booked():
    run = Run(hand_scenes.slider_crank(), step_size=0.01)
    run.advance(50)
    pin, phi = 0.15, 1.5
    slider = pin * math.cos(phi) + math.sqrt(0.3**2 - (pin * math.sin(phi)) ** 2)
    assert run["position"][0] == pytest.approx(slider, rel=1e-14)
    assert run["position"][2:] == pytest.approx([pin * math.cos(phi), pin * math.sin(phi)])
    assert run["energy"][6] < 1e-13
    assert run["residual"][1] < 1e-4  # velocities of driven nodes are those of the scheme


def test_a_prescribed_angle_needs_the_torque_of_the_equation_of_motion():
    errors = []
    for h in (0.02, 0.01):
        run = Run(hand_scenes.driven_angle(), step_size=h)
        run.advance(round(1.0 / h))
        angle = 0.3 * math.sin(2.0)
        assert run["quantity"][0] == pytest.approx(angle, rel=1e-13)
        torque = 2.3 * (-4.0 * angle) + 2.0 * G * math.cos(angle)
        errors.append(-run["multiplier"][-1] - torque)
        assert run["energy"][6] < 1e-13
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)


def test_an_input_that_ramps_acts_by_its_course():
    """A point of 1 kg under a force from 1 N to 3 N in 0.5 s: the impulse is 1 N s."""
    hand = Hand(2)
    point, (x, _) = hand.free([0.0, 0.0]), hand_scenes.axes(hand)
    hand.element(hand.quantity(0, hand.form({point: 1.0}, {x: 1.0})))
    hand.inputs, hand.tables["input_ramp"], hand.flags = [1.0], [1], {"time_dependent": 1}
    hand.let("laws", "copy", ("drive", 0), ("input", 0))
    run = Run(hand)
    run.set_inputs(3.0)
    run.advance(1, 0.5)
    assert run["velocity"][0] == pytest.approx(1.0, rel=1e-13)
    run.advance(1, 0.5)
    assert run["velocity"][0] == pytest.approx(2.5, rel=1e-13)


def test_velocities_follow_an_input_that_ramps_from_the_first_step():
    """The pin's speed jumps from 0 to 1 m/s; x^2 + y^2 = L^2 gives the slider's; work is booked."""
    run = Run(hand_scenes.ramped_slider())
    run.set_inputs(0.4)
    run.advance(1, 0.1)
    x, y = 0.4, math.sqrt(0.25 - 0.16)
    assert run["position"] == pytest.approx([0.0, y, x, 0.0], abs=1e-14)
    # velocities are second order, with steps of 0.01
    assert run["velocity"] == pytest.approx([0.0, -x / y, 1.0, 0.0], abs=2e-3)
    assert run["energy"][6] < 1e-14
    run.advance(1, 0.1)
    assert run["velocity"] == pytest.approx([0.0] * 4, abs=2e-3)
    assert run["energy"][6] < 1e-14


@pytest.mark.parametrize("order", [2, 4, 6])
def test_compositions_of_pairs_have_their_order(order):
    """Angle of a body with spring, drive and turning load, against order 8 with a small step."""

    def angle(h, order):
        run = Run(hand_scenes.planar_body(damping=0.0), step_size=h, order=float(order))
        run.advance(round(0.6 / h))
        assert run["energy"][6] < 1e-13
        return run["quantity"][0]

    exact = angle(0.06, 8)
    errors = [abs(angle(h, order) - exact) for h in (0.15, 0.1)]
    observed = math.log(errors[0] / errors[1]) / math.log(1.5)
    assert observed == pytest.approx(order, abs=0.1 * order)


def test_a_law_that_senses_a_rate_damps_like_a_damper():
    """Second order: the sensors are predicted, the damper is implicit."""
    differences = []
    for h in (0.02, 0.01):
        sensed = Run(hand_scenes.sensed(), step_size=h)
        hand = hand_scenes.sensed()
        hand.operations["laws"] = []
        hand.numbers["damping"][0], hand.numbers["drive"][0] = 2.0, 1.0
        damped = Run(hand, step_size=h)
        for run in (sensed, damped):
            run.advance(round(0.5 / h))
            assert run["energy"][6] < 1e-14
        differences.append(sensed["quantity"][0] - damped["quantity"][0])
    assert differences[0] / differences[1] == pytest.approx(4.0, rel=0.2)


# --------------------------------------------------------------------------- where to begin


def test_a_mechanism_drawn_inexactly_is_closed_with_the_velocities_it_allows():
    run = Run(hand_scenes.two_bodies(0.01), assemble=True)
    assert run.status is Status.OK
    assert run["residual"][0] < 1e-15
    assert run["residual"][1] < 1e-14


def test_velocities_that_are_given_stay():
    """The director's velocity is given, that of the centre is not."""
    hand = hand_scenes.planar_body()
    hand.nodes["free"][0][1][:] = [0.3, -0.2]
    run = Run(hand, assemble=True)
    assert run.vector("v")[2:] != pytest.approx([0.0, 1.0], abs=0.1)
    hand = hand_scenes.planar_body()
    hand.nodes["free"][0][1][:] = [0.3, -0.2]
    hand.given = {("free", 1)}
    run = Run(hand, assemble=True)
    # what the weight of 1e8 leaves of a change is put back in each round
    assert run.vector("v") == pytest.approx([0.0, 1.0, 0.0, 1.0], abs=1e-7)


def test_a_catenary_hangs_where_its_horizontal_pull_is_everywhere_the_same():
    run = Run(hand_scenes.catenary(0.05), assemble=True, start="equilibrium")
    x = np.vstack([[0.0, 0.0], run["position"].reshape(-1, 2), [3.0, 0.0]])
    pull = run["multiplier"][:, None] * 2.0 * np.diff(x, axis=0)
    assert pull[:, 0] == pytest.approx(pull[0, 0], rel=1e-9)
    assert np.diff(pull[:, 1]) == pytest.approx(G, rel=1e-9)
    before = run.vector("q")
    run.advance(10)
    assert run.vector("q") == pytest.approx(before, abs=1e-11)
