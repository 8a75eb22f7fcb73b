"""How a step can fail, that it leaves nothing behind when it does, and steps halved before."""

from __future__ import annotations

import math

import numpy as np
import pytest

from solver.runtime import AssemblyError, Integrator, OptionError, Status, StepError
from solver.runtime.layout import PLACE
from solver.scene import SceneError
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.twins import (
    PENDULUM,
    advance,
    block,
    internal_step,
    model_of,
    start,
    vector,
)

SPRUNG = """
name = "sprung"
dimension = 2
[inputs]
stiffness = { start = 1.0 }
free_length = { start = 0.0 }
push = { start = 0.0 }
[points]
A = { position = [0, 0], mass = 1.0 }
B = { position = [1, 0], mass = 1.0, velocity = [0, 0.3] }
[joints]
rod = { type = "distance", points = ["A", "B"] }
[forces.spring]
type = "spring"
points = ["ground", "A"]
at = [0, 0]
stiffness = "stiffness"
free_length = "free_length"
[forces.pusher]
type = "force"
point = "B"
value = ["push**2", "1e200**(2*push) if t > 0.055 else 0"]
"""

TIRING = (
    PENDULUM
    + """
[forces.damper]
type = "damper"
points = ["A", "ground"]
at = [3, 0]
damping = "1 - 50*t"
"""
)

SPINNING = """
name = "spinning"
dimension = 2
[bodies.wheel]
position = [0, 0]
mass = 1.0
inertia = 1.0
angular_velocity = 4000.0
"""
"""Turns by 3.1 rad in a half step of 0.1/64 s."""

DAMPED = 'name = "damped"\ndimension = 2\n[points]\n' + "".join(
    f"P{k} = {{ position = [10, {k}], mass = 1.0, velocity = [1, 0] }}\n" for k in range(17)
)
DAMPED += "[forces]\n" + "".join(
    f'D{k} = {{ type = "damper", points = ["P{k}", "ground"], at = [0, {k}], '
    f'damping = "{1.01 * 4 / 0.57386 * 2**k / 0.1}*tanh(1e12*t)" }}\n'
    for k in range(17)
)
"""Dampers, one for each halving of 0.1 s, near the pole of order 8's part of -0.574 steps: there an
implicit midpoint step backwards, (1 + x)/(1 - x) with x = 0.574 c h/(4 m), feeds without bound.
They begin within the step: from its beginning they would limit the order to 2."""

HEAVY_AND_LIGHT = """
name = "heavy_and_light"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1e-5 }
B = { position = [2, 0], mass = 1e10 }
C = { position = [3, 0], mass = 1e-5 }
[joints]
a = { type = "distance", points = ["O", "A"] }
b = { type = "distance", points = ["A", "B"] }
c = { type = "distance", points = ["B", "C"] }
"""

STOPPED = """
name = "stopped"
dimension = 2
[bodies.arm]
position = [0, 0]
mass = 1.0
inertia = 1.0
[joints]
hinge = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
[drivers]
motor = { type = "angle", joint = "hinge", value = "t" }
[contacts]
end = { type = "stop", joint = "hinge", max = 0.05 }
"""
"""Its motor pushes it through its stop."""

BALL = """
name = "ball"
dimension = 2
gravity = [0, -9.81]
[points]
ball = { mass = 1.0, position = [0, 0], velocity = [1, 3] }
[contacts]
floor = { type = "plane", point = "ball", axis = [0, 1], restitution = 0.9, friction = 0.1 }
"""

BOUNCING_AND_STOPPED = (
    STOPPED.replace("dimension = 2", "dimension = 2\ngravity = [0, -9.81]")
    + """
floor = { type = "plane", point = "ball", axis = [0, 1], restitution = 0.9 }
[points]
ball = { mass = 1.0, position = [0, 0], velocity = [0, 0.05] }
"""
)
"""A ball hits thrice before the motor comes to its stop, and no mode gets through that."""

WAVERING = """
name = "wavering"
dimension = 2
[points]
A = { position = [0, 0], mass = 1.0, velocity = [0.05, 0] }
[forces]
brake = { type = "force", point = "A", value = ["-1 if A.vx + A.vy > 0 else 1", 0] }
"""
"""At rest each side of the law leads back to the other one."""

COUNTING = f"""{PENDULUM}
[states]
count = {{ update = "sqrt(1 - 30*t)", sample_time = 0.01 }}
"""

FAILURES = {
    Status.NEWTON_DIVERGED: (PENDULUM, {"max_newton": 1}, {}, 0.1),
    Status.UZAWA_DIVERGED: (PENDULUM, {"newton_tolerance": 1e-30, "max_uzawa": 1}, {}, 0.1),
    Status.SINGULAR_TANGENT: (SPRUNG, {"step_size": 0.1}, {"stiffness": 1e307}, 0.1),
    Status.NOT_FINITE: (SPRUNG, {}, {"push": 1e200}, 0.1),
    Status.ZERO_LENGTH: (SPRUNG.replace("[0, 0.3]", "[0, 0]"), {}, {"free_length": 0.1}, 0.1),
    Status.BAD_STEP: (PENDULUM, {}, {}, 1e12),
    Status.BAD_LAW: (TIRING, {}, {}, 0.1),
    Status.DAMPING_REVERSED: (DAMPED, {"order": 8.0, "step_size": 0.1}, {}, 0.1),
    Status.STEP_COLLAPSED: (PENDULUM, {"tolerance": 1e-14, "order": 2.0}, {}, 1e3),
    Status.TURN_TOO_LARGE: (SPINNING, {"step_size": 0.1}, {}, 0.1),
    Status.IMPACT_UNSOLVED: (STOPPED, {}, {}, 0.1),
    Status.BAD_DRIVER: (STOPPED.replace('"t"', '"sqrt(0.1 - t) - sqrt(0.1)"'), {}, {}, 0.1),
    Status.TOO_MANY_EVENTS: (BOUNCING_AND_STOPPED, {"max_events": 2}, {}, 0.1),
    Status.LAW_SWITCHES: (WAVERING, {}, {}, 0.1),
    Status.NEXT_STATE: (COUNTING, {}, {}, 0.1),
    Status.SIGNAL_JUMPS: (STOPPED.replace('"t"', '"0.01*t if t < 0.03 else 0.02*t"'), {}, {}, 0.1),
}
"""What provokes each status: scene, settings, inputs, communication step."""


HALVED = "even with the step halved again and again"
SENTENCES = {
    Status.NEWTON_DIVERGED: "Newton's iteration did not converge, " + HALVED,
    Status.UZAWA_DIVERGED: "the constraints could not be met, " + HALVED,
    Status.SINGULAR_TANGENT: "the tangent matrix is singular, " + HALVED,
    Status.NOT_FINITE: "a number grew beyond all bounds, " + HALVED,
    Status.ZERO_LENGTH: "so that its direction is undefined; move the points apart",
    Status.BAD_STEP: "must be a finite number > 1e-100 s and at most 1e9 internal steps long",
    Status.BAD_LAW: "a stiffness, free length or damping became negative",
    Status.DAMPING_REVERSED: "dampers fed energy, " + HALVED,
    Status.STEP_COLLAPSED: "the internal step collapsed: solver.tolerance asks for more than 1e6",
    Status.TURN_TOO_LARGE: "a body turns by more than 2.5 rad within a half step",
    Status.BAD_DRIVER: "the rate of driver 'motor': it has no finite value at this time",
    Status.IMPACT_UNSOLVED: "contact 'end': no impulses were found that obey the law of impact",
    Status.TOO_MANY_EVENTS: "contact 'floor': contacts change more often than solver.max_events",
    Status.SIGNAL_JUMPS: "driver 'motor': t < 0.03: what it drives would jump to another place",
    Status.NEXT_STATE: "state 'count': its next value is not a finite number",
    Status.LAW_SWITCHES: "force 'brake': (A.vx + A.vy) > 0: it switches 1000 times at one moment",
}
"""What is said of each."""


def provoked(status):
    """Integrator about to fail, and the step with which it does."""
    source, settings, inputs, step = FAILURES[status]
    run = start(source, **settings)
    if inputs:
        internal_step(run)  # before the first step, inputs are part of the assembly
    for name, value in inputs.items():
        run[name] = value
    return run, step


def test_every_status_has_a_sentence_and_is_provoked_below():
    at_the_start = {Status.PENETRATION, Status.AT_DEAD_CENTRE}
    # What is stepped over, and what test_interrupted_steps.py, test_repeated_meshes.py and
    # test_repeated_switches.py provoke.
    others = set(Status) - at_the_start - {Status.CONTACT_UNDECIDED, Status.STOPPED}
    others -= {Status.MESH_EVENTS, Status.MESH_METHODS, Status.MESH_STEPPED, Status.MESH_SWITCHES}
    assert {Status.OK, *FAILURES} == {Status.OK, *SENTENCES} == others


@pytest.mark.parametrize("status", FAILURES, ids=lambda status: status.name)
def test_a_step_that_fails_says_why_and_leaves_the_state_as_before(status):
    run, step = provoked(status)
    before = run.save()
    with pytest.raises(StepError) as caught:
        run.advance(run.time, step)
    assert SENTENCES[status] in str(caught.value)
    assert str(caught.value).startswith(f"step from t = {run.time:g} s with h = ")
    assert run.status is status
    assert run.state.head["status"] == status
    run.state.head["status"] = Status.OK
    run.state.head["at_fault"] = 0.0
    assert run.save() == before


LONG_ROD = """
name = "rod"
dimension = 2
[points]
top = { position = [0, 1], fixed = true }
ball = { mass = 1.0, position = [0, 0.5] }
[joints]
rod = { type = "distance", points = ["top", "ball"], length = 1.2 }
[contacts]
floor = { type = "plane", point = "ball", axis = [0, 1] }
[solver]
assemble = true
"""


def test_a_mechanism_that_closes_into_a_contact_is_refused():
    with pytest.raises(SceneError, match=r"contacts.floor: its gap is negative at the start"):
        model_of(LONG_ROD)


def test_what_located_mode_gives_up_is_stepped_over():
    run = start(BALL, max_events=2)
    run.advance(run.time, 2.0)
    assert run["solver.stepped"] == 1.0
    run.advance(run.time, 0.01)
    assert run["solver.stepped"] == 0.0


@pytest.mark.parametrize(("speed", "status"), [(250.0, Status.OK), (1e5, Status.TURN_TOO_LARGE)])
def test_a_body_in_space_turns_no_further_in_a_step_than_its_directors_can_tell(speed, status):
    """Forty turns a second against half steps of 0.1 s, and in the end of 0.1/64 s."""
    text = SPINNING.replace("dimension = 2", "").replace("[0, 0]", "[0, 0, 0]")
    text = text.replace("inertia = 1.0", "inertia = [1, 1, 1]").replace(
        "4000.0", f"[0, 0, {speed}]"
    )
    run = start(text, step_size=0.2)
    if status is Status.OK:
        run.advance(0.0, 0.2)
    else:
        with pytest.raises(StepError):
            run.advance(0.0, 0.2)
    assert run.status is status
    assert vector(run, "q")[:3] == pytest.approx([0.0] * 3)


@pytest.mark.parametrize("step", [-0.1, 0.0, math.nan, math.inf])
def test_a_step_that_is_no_length_of_time_is_refused(step):
    run = start(PENDULUM)
    before = run.save()
    with pytest.raises(StepError):
        run.advance(0.0, step)
    run.state.head["status"] = Status.OK
    assert run.save() == before


def test_a_failure_late_in_a_communication_step_leaves_no_trace():
    """Five internal steps are solved, the sixth meets a force beyond all bounds."""
    failed, never = (start(SPRUNG, step_size=0.01) for _ in range(2))
    for run in (failed, never):
        advance(run, 2)
        run["push"] = 1.0
    before = block(failed).copy()
    with pytest.raises(StepError, match="grew beyond all bounds"):
        failed.advance(failed.time, 0.08)
    assert failed.status is Status.NOT_FINITE
    changed = np.flatnonzero(block(failed) != before)
    assert changed.tolist() == [PLACE["at_fault"], PLACE["status"]]  # which the sentence names
    for run in (failed, never):
        run["push"] = 0.0
        advance(run, 3)
        assert run.status is Status.OK
    assert bytes(kernel_of(failed).state) == bytes(kernel_of(never).state)


def test_a_step_that_does_not_converge_is_halved_until_it_does():
    """A second of a pendulum that turns by 10 rad in it, in one internal step."""
    text = PENDULUM.replace("[0.8, 0.6]", "[8.0, 6.0]")
    run = start(text, step_size=1.0, max_newton=8)
    internal_step(run)
    assert run.status is Status.OK
    assert run.time == 1.0
    assert run.state.head["substeps"] > 2
    assert run["constraint.position"] < 1e-14
    assert run["energy.error"] < 1e-13
    with_all = start(text, step_size=1.0, max_newton=1)
    with pytest.raises(StepError, match=HALVED):
        internal_step(with_all)


def test_why_steps_fail_is_said_where_a_tolerance_shortens_them_in_vain():
    run = start(PENDULUM, max_newton=1, tolerance=1e-6, order=6)
    with pytest.raises(StepError, match="Newton's iteration did not converge") as raised:
        run.advance(0.0, 1.0)
    assert raised.value.status is Status.NEWTON_DIVERGED


@pytest.mark.parametrize("tolerance", [0.0, 1e-6])
def test_masses_that_are_far_apart_are_named_where_steps_fail(tolerance):
    with pytest.raises(StepError, match="masses or sizes that are many powers of ten apart"):
        start(HEAVY_AND_LIGHT, tolerance=tolerance).advance(0.0, 0.1)


@pytest.mark.parametrize("value", ["\u00e9" * 3000, "a" + "\u00e9" * 3000, "\U0001f600" * 2000])
def test_a_long_word_is_cut_between_characters(value):
    with pytest.raises(OptionError, match=r"solver\.start: must be one of .*, got"):
        start(PENDULUM)["solver.start"] = value


def test_a_word_with_a_zero_is_not_the_word_before_the_zero():
    with pytest.raises(OptionError, match=r"solver\.start: must be one of"):
        start(PENDULUM)["solver.start"] = "drawn\0x"


DRIVEN = (
    PENDULUM
    + """
[forces.pump]
type = "spring"
points = ["A", "ground"]
at = [3, 0]
stiffness = "100*(1.5 + sin(20*t))"
free_length = 1.0
"""
)


def test_the_work_of_changing_a_spring_is_booked_once_however_a_step_is_halved():
    run = start(DRIVEN, step_size=0.25, max_newton=5)
    pieces = 0
    for _ in range(4):
        internal_step(run)
        pieces += run.state.head["substeps"]
    assert pieces > 8
    assert abs(run["energy.work"]) > 1.0
    assert run["energy.error"] < 1e-12


def test_a_length_that_fixed_ends_do_not_allow_is_a_sentence_and_no_crash():
    text = PENDULUM.replace("[joints]", "[parameters]\nlength = 1.0\n[joints]").replace(
        'points = ["O", "A"] }', 'points = ["O", "A"], length = "length" }'
    )
    run = Integrator(model_of(text))
    run["length"] = 1.5
    with pytest.raises(AssemblyError, match=r"length is 1\.5 m, but its points"):
        run.initialise()
