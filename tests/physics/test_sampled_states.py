"""Sampled states: controllers and counters against recursions with closed forms between ticks."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import solver
from solver.runtime import Integrator
from solver.scene import SceneError

PID = """
name = "pushed"
dimension = 2
[points]
A = {{ position = [0, 0], mass = 1.0 }}
[states.pid]
type = "pid"
error = "1 - A.x"
kp = 20
ki = {ki}
kd = 6
min = -{most}
max = {most}
tracking_time = 0.1
sample_time = 0.02
[forces]
push = {{ type = "force", point = "A", value = ["pid.value", 0] }}
{force}
"""
BRAKED = PID.format(
    ki=15, most=5, force='brake = { type = "force", point = "A", value = ["-0.5*A.vx", 0] }'
)
SPRUNG = PID.format(ki=40, most=25, force='spring = { type = "potential", value = "15*A.x**2" }')

Flow = Callable[[float, float, float, float], tuple[float, float]]


def braked(x: float, v: float, u: float, h: float) -> tuple[float, float]:
    """Place and velocity after h of x'' = u - c x', c = 0.5."""
    c, end = 0.5, u / 0.5
    return x + end * h + (v - end) * (1.0 - math.exp(-c * h)) / c, end + (v - end) * math.exp(
        -c * h
    )


def sprung(x: float, v: float, u: float, h: float) -> tuple[float, float]:
    """Likewise of x'' = u - 30 x."""
    w, rest = math.sqrt(30.0), u / 30.0
    cosine, sine = math.cos(w * h), math.sin(w * h)
    return rest + (x - rest) * cosine + v / w * sine, -(x - rest) * w * sine + v * cosine


def recursion(flow: Flow, stop: float, ki: float, most: float) -> tuple[float, float, float]:
    """Place, velocity and integral before the tick at `stop`, from rest."""
    x = v = integral = before = 0.0
    for _ in range(round(stop / 0.02)):
        error = 1.0 - x
        free = 20.0 * error + integral - 6.0 * (x - before) / 0.02
        u = max(-most, min(most, free))
        integral += 0.02 * (ki * error + (u - free) / 0.1)
        before = x
        x, v = flow(x, v, u, 0.02)
    return x, v, integral


def moved(text: str, stop: float, step: float, **settings: Any) -> tuple[float, float]:
    found = solver.simulate(
        solver.loads(text), stop_time=stop, step_size=step, outputs=["A.x", "A.vx"], **settings
    )
    return found["A.x"][-1], found["A.vx"][-1]


def test_the_recursions_are_those_that_others_calculated() -> None:
    assert recursion(braked, 1.0, 15.0, 5.0) == pytest.approx(
        (0.808806416930, 0.356245515216, -2.465936792759), abs=2e-12
    )
    assert recursion(sprung, 0.9, 40.0, 25.0)[:2] == pytest.approx(
        (0.704761857730, 0.111449110297), abs=2e-12
    )


@pytest.mark.parametrize("method", ["conserving", "fastest"])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize(
    ("text", "flow", "stop", "step", "ki", "most"),
    [(BRAKED, braked, 1.0, 0.05, 15.0, 5.0), (SPRUNG, sprung, 0.9, 0.03, 40.0, 25.0)],
    ids=["braked", "sprung"],
)
def test_a_controller_keeps_a_tolerance_whose_ticks_lie_within_communication_steps(
    text: str, flow: Flow, stop: float, step: float, ki: float, most: float, tolerance: float,
    method: str,
) -> None:  # fmt: skip
    x, v, _ = recursion(flow, stop, ki, most)
    found = moved(text, stop, step, tolerance=tolerance, method=method)
    assert abs(found[0] - x) < 3.0 * tolerance
    assert abs(found[1] - v) < 3.0 * tolerance * 2.0  # the largest velocity


@pytest.mark.parametrize("order", [2, 4])  # at order 6 round-off is all
def test_ticks_within_communication_steps_hold_the_order(order: int) -> None:
    x, v, _ = recursion(sprung, 0.9, 40.0, 25.0)
    errors = []
    for step in (0.01, 0.005):
        found = moved(SPRUNG, 0.9, 0.03, order=order, internal_step=step)
        errors.append(math.hypot(found[0] - x, found[1] - v))
    assert math.log2(errors[0] / errors[1]) > order - 0.3


COUNTERS = """
name = "counters"
dimension = 2
[points]
A = { position = [0, 0], velocity = [1, 0], mass = 1.0 }
[inputs]
u = { start = 0 }
[parameters]
period = 0.1
[states]
count = { update = "count + 1", sample_time = "period" }
late = { update = "late + 1", sample_time = 0.1, offset = 0.025, start = 5 }
first = { update = "second", sample_time = 0.05, start = 1 }
second = { update = "first", sample_time = 0.05, start = 2 }
seen = { update = "floor(A.x/0.03)*0.03", sample_time = 0.01 }
asked = { update = "u", sample_time = 0.05 }
[outputs]
double = { value = "2*count" }
"""


def test_clocks_tick_by_the_time_and_all_read_what_was_before() -> None:
    names = ["count", "late", "first", "second", "seen", "double", "A.x"]
    found = solver.simulate(
        solver.loads(COUNTERS), stop_time=0.5, step_size=0.05, outputs=names, tolerance=1e-8
    )
    k = np.arange(11)
    assert found["count"].tolist() == (1 + k // 2).tolist()  # a tick at the start, too
    assert found["late"].tolist() == (5 + (k + 1) // 2).tolist()
    assert found["first"].tolist() == [2.0, 1.0] * 5 + [2.0]  # they change places
    assert found["second"].tolist() == [1.0, 2.0] * 5 + [1.0]
    assert found["double"].tolist() == (2 * found["count"]).tolist()
    assert found["seen"] == pytest.approx(0.03 * np.floor(found["A.x"] / 0.03 + 1e-9), abs=1e-12)


def test_a_tick_at_the_end_of_a_step_reads_the_input_of_that_step() -> None:
    integrator = Integrator(solver.assemble(solver.loads(COUNTERS)))
    integrator.initialise()
    seen = []
    for k in range(4):
        integrator["u"] = 10.0 + k
        integrator.advance(0.05 * k, 0.05)
        seen.append(float(integrator["asked"]))
    assert seen == [10.0, 11.0, 12.0, 13.0]


@pytest.mark.parametrize("settings", [{}, {"tolerance": 1e-6}, {"order": 4, "step_size": 0.01}])
def test_states_are_saved_restored_and_reset(settings: dict[str, float]) -> None:
    lines = "".join(f"{name} = {value}\n" for name, value in settings.items())
    integrator = Integrator(solver.assemble(solver.loads(f"{BRAKED}[solver]\n{lines}")))

    def went(first: int, last: int) -> list[tuple[float, ...]]:
        rows = []
        for k in range(first, last):
            integrator.advance(0.03 * k, 0.03)
            rows.append(tuple(float(integrator[x]) for x in ("A.x", "A.vx", "pid.value")))
        return rows

    integrator.initialise()
    whole = went(0, 20)
    integrator.reset()
    integrator.initialise()
    assert went(0, 10) == whole[:10]
    saved = integrator.save()
    assert went(10, 20) == whole[10:]
    integrator.restore(saved)
    assert integrator["pid.value"] == whole[9][2]
    assert went(10, 20) == whole[10:]


def test_a_jump_of_the_set_point_does_not_kick_where_the_measurement_is_given() -> None:
    """The derivative is that of the measurement, filtered as y' = filter (kd x' - y), backwards."""
    text = """
name = "still"
dimension = 2
[points]
A = { position = [0, 0], velocity = [2, 0], mass = 1.0 }
[states.pid]
type = "pid"
error = "(3 if t > 0.055 else 0) - A.x"
measurement = "A.x"
kd = 4
filter = 50
sample_time = 0.01
"""
    found = solver.simulate(
        solver.loads(text), stop_time=0.1, step_size=0.01, outputs=["pid.value"]
    )
    slope, right = 0.0, []
    for k in range(11):
        slope = (slope + 50.0 * (4.0 * 0.02 if k else 0.0)) / (1.0 + 50.0 * 0.01)
        right.append(-slope)
    assert found["pid.value"] == pytest.approx(right, abs=1e-10)


CART_POLE = """
name = "cart_pole"
dimension = 2
gravity = [0, -9.81]
[bodies]
cart = { mass = 1.0, inertia = 0.1, position = [0, 0] }
[bodies.pole]
mass = 0.2
inertia = 0.02
position = [0, 0.5]
velocity = [0.4, 0]
angular_velocity = -0.8
[joints]
rail = { type = "prismatic", bodies = ["ground", "cart"], position = [0, 0], axis = [1, 0] }
hinge = { type = "revolute", bodies = ["cart", "pole"], position = [0, 0] }
[states.push]
update = "4*rail.displacement + 5*rail.velocity - 45*hinge.angle - 11*hinge.angular_velocity"
sample_time = 0.02
[forces.motor]
type = "actuator"
guide = "rail"
value = "push"
max_force = 8
"""
"""A pole that begins to fall over the cart's right side, which a controller at 50 Hz catches."""


def balanced(stop: float) -> np.ndarray:
    """Place, angle and their rates of cart and pole, by DOP853 from tick to tick.

    Lagrange's equations of M = 1 kg and m = 0.2 kg with its centre at a = 0.5 m: the angle is
    positive to the left.
    """
    M, m, a, inertia = 1.0, 0.2, 0.5, 0.02 + 0.2 * 0.25
    y = np.array([0.0, 0.0, 0.0, -0.8])

    def motion(_: float, y: np.ndarray, u: float) -> list[float]:
        _, angle, v, rate = y
        sine, cosine = math.sin(angle), math.cos(angle)
        matrix = [[M + m, -m * a * cosine], [-m * a * cosine, inertia]]
        right = [u - m * a * sine * rate**2, m * 9.81 * a * sine]
        return [v, rate, *np.linalg.solve(matrix, right)]

    for _ in range(round(stop / 0.02)):
        push = 4.0 * y[0] + 5.0 * y[2] - 45.0 * y[1] - 11.0 * y[3]
        u = max(-8.0, min(8.0, push))
        y = solve_ivp(motion, (0.0, 0.02), y, method="DOP853", rtol=1e-12, atol=1e-14, args=(u,)).y[
            :, -1
        ]
    return y


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
def test_a_pole_is_balanced_by_a_state_in_the_scene(tolerance: float) -> None:
    names = ["rail.displacement", "hinge.angle", "rail.velocity", "hinge.angular_velocity"]
    found = solver.simulate(
        solver.loads(CART_POLE), stop_time=3.0, step_size=0.05, outputs=names, tolerance=tolerance
    )
    right = balanced(3.0)
    assert abs(right[1]) < 0.02  # it stands
    assert np.abs(found["hinge.angle"]).max() < 0.3
    for name, value in zip(names, right, strict=True):
        assert abs(found[name][-1] - value) < 3.0 * tolerance * np.abs(found[name]).max()


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ('s = { update = "1", sample_time = 0 }', "must be > 0 s, got 0"),
        ('s = { update = "1" }', "'sample_time' is missing"),
        ('s = { sample_time = 0.1 }', "'update' is missing"),
        ('s = { update = "A.ax", sample_time = 0.1 }', "it is possible only in outputs"),
        ('s = { update = "r", sample_time = 0.1 }', "unknown symbol 'r'"),
        ('t = { update = "1", sample_time = 0.1 }', "reserved for the time"),
        ('s = { type = "pid", error = "A.x", sample_time = 0.1 }', "without kp, ki and kd"),
        ('s = { type = "pid", error = "s", kp = 1, sample_time = 1 }', "'s' has no value of its"),
        (
            's = { type = "pid", error = "A.x", kp = 1, tracking_time = 1, sample_time = 1 }',
            "has no effect without min or max",
        ),
        ('s = { update = "1", sample_time = 1 }\n[outputs]\ns = { value = "t" }', "already that"),
    ],
)  # fmt: skip
def test_bad_states_are_told(line: str, words: str) -> None:
    with pytest.raises(SceneError, match=words):
        solver.loads(COUNTERS.partition("[states]")[0] + f"[states]\n{line}\n")


def test_a_state_stands_where_time_may() -> None:
    text = COUNTERS.replace("position = [0, 0]", 'position = ["count", 0]')
    with pytest.raises(SceneError, match="the state 'count' is possible only in forces"):
        solver.loads(text)


def test_a_next_value_that_is_no_number_ends_the_run_with_a_sentence() -> None:
    text = COUNTERS.replace('"count + 1"', '"count + 1 + 1e-30/(3 - count)"')
    with pytest.raises(solver.StepError, match="state 'count': its next value is not a finite"):
        solver.simulate(solver.loads(text), stop_time=1.0, step_size=0.1, outputs=["count"])


def test_a_next_value_that_is_no_number_at_the_start_is_told_with_its_state() -> None:
    text = COUNTERS.replace('"count + 1"', '"sqrt(t - 1)"')
    with pytest.raises(SceneError, match=r"states\.count: its next value is not a finite number"):
        solver.assemble(solver.loads(text))


def test_clocks_are_kept_however_many_there_are() -> None:
    """A formula may have 64 switches that steps end at; what ticks is no matter of accuracy."""
    clocks = [
        f's{k} = {{ update = "s{k} + 1", sample_time = {0.01 * (k + 1)} }}' for k in range(70)
    ]
    text = "\n".join([COUNTERS.partition("[inputs]")[0], "[states]", *clocks])
    names = [f"s{k}" for k in range(70)]
    found = solver.simulate(solver.loads(text), stop_time=0.995, step_size=0.199, outputs=names)
    assert [found[x][-1] for x in names] == [1 + int(0.995 / (0.01 * (k + 1))) for k in range(70)]
