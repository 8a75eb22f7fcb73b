"""Formulas of a scene: derivatives, sensors, and what has no place in them."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.mechanics.derivative import SLOPES, derivative
from solver.scene.expression import evaluate, operate, symbol
from solver.scene.grammar import parse

TEXTS = [
    "x**3 - 2*x + a/x", "sin(x)*cos(2*x) + tan(x/4)", "atan2(x, 1 + x**2)", "sqrt(1 + x*x)",
    "exp(-x)*log(2 + x)", "asin(x/5) - acos(x/6) + atan(x)", "x**a + a**x", "abs(x - 0.1)",
    "min(x, 2 - x) + max(x, a)", "x if a > 1 else x**2", "-x + a", "(1 + x)/(2 - x/9)",
    "sinh(x)/cosh(a*x) - tanh(3*x)",
]  # fmt: skip


@pytest.mark.parametrize("text", TEXTS)
@given(x=st.floats(0.2, 0.9), a=st.floats(1.1, 1.9))
def test_a_derivative_is_the_limit_of_differences(text, x, a):
    # Central differences with 1e-5: 1e-10 of truncation, 1e-11 of rounding.
    number = parse(text)
    exact = evaluate(derivative(number, "x"), {"x": x, "a": a})
    ends = [evaluate(number, {"x": x + d, "a": a}) for d in (-1e-5, 1e-5)]
    assert exact == pytest.approx((ends[1] - ends[0]) / 2e-5, rel=1e-7, abs=1e-7)


def test_every_operation_that_is_not_constant_in_pieces_has_its_slopes():
    flat = {
        "sign",
        "floor",
        "ceil",
        "mod",
        "lt",
        "le",
        "gt",
        "ge",
        "eq",
        "ne",
        "and",
        "or",
        "not",
        "select",
        "spline_curvature",  # of which no formula has a derivative: it jumps at knots
        "grid_x",
        "grid_y",
        "grid_z",  # nor of these: contacts with meshes need none
    }
    from solver.scene.expression import OPERATIONS

    assert set(SLOPES) | flat == set(OPERATIONS)
    assert derivative(operate("sign", symbol("x")), "x") == 0.0


POINTS = """
name = "formulas"
dimension = 2
[inputs]
u = {}
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 2], velocity = [0.5, 0], mass = 1.0 }
B = { position = [3, 1], mass = 2.0 }
"""


def start(text: str) -> solver.Integrator:
    integrator = solver.Integrator(solver.assemble(solver.loads(POINTS + text)))
    integrator.initialise()
    return integrator


def report(text: str) -> str:
    with pytest.raises(solver.SceneError) as caught:
        solver.assemble(solver.loads(POINTS + text))
    return str(caught.value)


def test_a_force_may_read_positions_and_velocities_of_the_middle_of_a_step():
    # A force -k x - c v written as a formula moves a point as a spring and a damper do.
    text = '[forces]\nf = { type = "force", point = "A", value = ["-9*(A.x - 0.4) - A.vx", 0] }\n'
    moved = start(text)
    for k in range(100):
        moved.advance(k * 0.01, 0.01)
    decay, w = 0.5, math.sqrt(9 - 0.25)
    x = 0.6 * math.cos(w) + (0.5 + decay * 0.6) / w * math.sin(w)
    assert moved["A.x"] == pytest.approx(0.4 + math.exp(-decay) * x, abs=2e-4)


def test_a_constraint_may_follow_the_time_and_inputs():
    moved = start('[constraints]\nc = { value = "A.x - 1 - u - 0.5*t" }\n')
    for k in range(50):
        moved.advance(k * 0.01, 0.01)
    assert moved["A.x"] == pytest.approx(1.25, abs=1e-13)


def test_a_potential_gives_the_force_of_its_slope():
    # V = 4.5 x^2: an oscillation with w = 3 about 0.
    moved = start('[forces]\nv = { type = "potential", value = "4.5*A.x**2" }\n')
    for k in range(100):
        moved.advance(k * 0.01, 0.01)
    expected = math.cos(3.0) + 0.5 / 3 * math.sin(3.0)
    assert moved["A.x"] == pytest.approx(expected, abs=3e-4)
    assert moved["v.energy"] == pytest.approx(4.5 * float(moved["A.x"]) ** 2, rel=1e-14)
    assert float(moved["energy.error"]) < 1e-13


def test_a_spring_with_an_energy_pulls_as_its_slope():
    moved = start('[forces]\ns = { type = "spring", points = ["A", "B"], energy = "length**3" }\n')
    assert moved["s.force"] == pytest.approx(3 * 5.0, rel=1e-14)


@pytest.mark.parametrize("value", ["A.vx**2 - A.vy", "A.vx - 0.5", "A.vx*B.vy", "A.vx - u"])
def test_a_velocity_row_must_be_linear_in_the_velocities(value):
    text = report(f'[constraints]\nc = {{ velocity = "{value}" }}\n')
    assert "constraints.c" in text
    assert "linear in the velocities" in text


@pytest.mark.parametrize("value", ["0*A.x", "O.x - u"])
def test_a_constraint_on_nothing_that_moves_is_refused(value):
    text = report(f'[constraints]\nc = {{ value = "{value}" }}\n')
    assert "constraints.c" in text
    assert "does not depend on the motion" in text


def test_a_constraint_scales_with_its_slope_and_the_size_of_the_mechanism():
    model = start('[constraints]\nc = { value = "1000*(A.y - 2)" }\n').model
    base = model.numbers[model.offsets["row_base"]]
    assert base == pytest.approx(1000.0, rel=1e-6)
    assert list(model.tables["row_power"]) == [1]


def test_a_force_need_not_be_finite_where_its_sensors_read_nothing_yet():
    # log(A.x) is 0 at the start; with a sensor that still reads 0 it would be refused.
    moved = start('[forces]\nf = { type = "force", point = "A", value = ["log(A.x)", 0] }\n')
    moved.advance(0.0, 0.01)
    assert moved["A.vx"] == pytest.approx(0.5, abs=1e-4)


@pytest.mark.parametrize("slope", ["t", "u"])
def test_a_velocity_row_takes_the_time_and_inputs_in_the_middle_of_a_step(slope):
    # y' = s x' with s = t, or an input that ramps as t does; a driver's signals, which are those of
    # the end, must not take their place. Means of a step hold to h^2/8 v = 1e-5, its end to h/2.
    text = '[points.D]\nposition = [0, 0]\n[drivers]\nd = { type = "position", point = "D", value'
    text += ' = ["u**2", 0] }\n[constraints]\nc = { velocity = "A.vy - S*A.vx" }\n'
    scene = POINTS.replace("u = {}", 'u = { interpolation = "ramp" }') + text.replace("S", slope)
    moved = solver.Integrator(solver.assemble(solver.loads(scene)))
    moved["solver.step_size"] = 0.01
    for k in range(5):
        moved["u"] = 0.1 * (k + 1)
        moved.advance(k * 0.1, 0.1)
    assert moved["A.vy"] == pytest.approx(0.5 * float(moved["A.vx"]), abs=1e-4)


def test_a_velocity_row_follows_the_time_where_nothing_else_does():
    moved = start(
        '[constraints]\nc = { velocity = "A.vy - t*A.vx" }\n[solver]\nstep_size = 0.01\n'
    )
    for k in range(50):
        moved.advance(k * 0.01, 0.01)
    assert moved["A.vy"] == pytest.approx(0.5 * float(moved["A.vx"]), abs=1e-4)


def test_a_tunable_parameter_that_turns_a_potential_does_work():
    text = '[parameters]\np = { value = 1.0, variability = "tunable" }\n'
    moved = start(text + '[forces]\nv = { type = "potential", value = "p*A.x**2" }\n')
    moved.advance(0.0, 0.01)
    stored = float(moved["v.energy"])
    moved["p"] = 3.0
    moved.advance(0.01, 0.01)
    assert moved["energy.work"] == pytest.approx(2.0 * stored, rel=1e-12)
    assert float(moved["energy.error"]) < 1e-13


@pytest.mark.parametrize(
    "part",
    [
        '[forces]\nv = { type = "potential", value = "A.x**2 if A.x > 0 else 3*A.x**2" }\n',
        '[forces]\nv = { type = "potential", value = "A.x*sign(A.x)" }\n',
        '[forces]\nv = { type = "potential", value = "floor(A.x)" }\n',
        '[forces]\nv = { type = "potential", value = "ceil(A.x + A.y)**2" }\n',
        '[forces]\nv = { type = "potential", value = "mod(A.x, 2)" }\n',
        '[forces]\nv = { type = "spring", points = ["A", "B"], energy = "length*(length > 1)" }\n',
        '[constraints]\nv = { value = "A.y - (2 if distance(A, B) < 9 else A.x)" }\n',
    ],
)
def test_a_formula_that_switches_with_what_moves_is_refused(part):
    # Its energy would jump in the midst of a step, by 6e-3 J for the second one.
    text = report(part)
    assert ".v" in text
    assert "abs, min or max" in text


def test_hyperbolic_potentials_and_loads_that_round_keep_the_ledger_closed():
    value = "3*cosh(A.x) + sinh(0.1*A.y) - tanh(distance(A, B))"
    text = f'[forces]\nv = {{ type = "potential", value = "{value}" }}\nw = {{ type = "force", '
    text += 'point = "A", value = ["floor(3*A.x) + ceil(A.vy)", "mod(t, 0.03)*A.x"] }\n'
    moved = solver.Integrator(solver.assemble(solver.loads(POINTS + text)))
    for k in range(100):
        moved.advance(k * 0.01, 0.01)
    assert moved["energy.work"] != 0.0
    assert float(moved["energy.error"]) < 1e-12


def test_a_formula_may_switch_with_the_time_and_parameters():
    with pytest.warns(RuntimeWarning, match="velocity that is given for point 'A': it starts 0.5"):
        moved = start('[constraints]\nc = { value = "A.x - (1 if t < 9 else 0)" }\n')
    moved.advance(0.0, 0.01)
    assert moved["A.x"] == pytest.approx(1.0, abs=1e-13)


def test_a_spring_that_only_pulls_is_exact_where_it_goes_slack():
    # V = 25 max(l - 2, 0)^2: it goes slack and taut again within 2 s.
    energy = "25*max(length - 2, 0)**2"
    moved = start(
        f'[forces]\ns = {{ type = "spring", points = ["A", "B"], energy = "{energy}" }}\n'
    )
    forces = []
    for k in range(200):
        moved.advance(k * 0.01, 0.01)
        forces.append(float(moved["s.force"]))
    assert min(forces) == 0.0 < forces[0]
    assert float(moved["energy.error"]) < 1e-12
