"""The tape computes what its expression says: same bits as Python, in the plane and in space."""

from __future__ import annotations

import math
from array import array

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.mechanics.mechanism import Leaf
from solver.mechanics.tape import CODES, Numbers, Segment, Tape
from solver.runtime.layout import LEAF_RATE, LEAF_VALUE, OFFSETS
from solver.scene.expression import (
    OPERATIONS,
    Curve,
    Expr,
    ExpressionError,
    Grid,
    apply,
    evaluate,
    operate,
    symbol,
)
from solver.scene.profiles import table_of
from tests.support.kernel.kernel_calls import Kernel
from tests.support.kernel.twins import PENDULUM, model_of, start

NAMES = ("a", "b", "c")

ARITY = {
    **dict.fromkeys(("add", "sub", "mul", "div", "pow", "atan2", "min", "max", "mod"), 2),
    **dict.fromkeys(("lt", "le", "gt", "ge", "eq", "ne", "and", "or"), 2),
    **dict.fromkeys(("neg", "sin", "cos", "tan", "asin", "acos", "atan", "sqrt"), 1),
    **dict.fromkeys(("exp", "log", "abs", "sign", "not"), 1),
    **dict.fromkeys(("sinh", "cosh", "tanh", "floor", "ceil"), 1),
    "select": 3,
    **dict.fromkeys(("spline", "spline_slope", "spline_curvature"), 1),
    **dict.fromkeys(("grid", "grid_x", "grid_y", "grid_z"), 3),
}
"""Operations by name and number of operands: all that an expression can hold. Of splines and grids,
besides their tables."""

TABLES = [
    Curve("lobe", table_of([-5.0, -1.0, 0.0, 2.0, 3.0], [0.0, 1.0, 3.0, -1.0, 0.0], periodic=True)),
    Curve("road", table_of([-9.0, 0.5, 2.0], [1.0, -2.0, 4.0], integrate=True)),
]
GRID = Grid(
    "bowl", array("d", [-3.0, -2.0, -1.0, 0.75, 6, 5, 7, *(math.sin(k * k) for k in range(210))])
)
TABLE = {
    name: TABLES[:1] if name.startswith("spline") else [GRID] if name.startswith("grid") else []
    for name in ARITY
}


def on_tape(number, values):
    """Value of a number on the tape of a kernel, for given values of its symbols."""
    places = {name: (place, Segment.PARAMETERS) for place, name in enumerate(NAMES)}
    tape = Tape(places.__getitem__, len(NAMES))
    place, _ = tape.compile(number)
    numbers = array("d", [values[name] for name in NAMES] + [0.0] * (tape.end - len(NAMES)))
    for constant_place, constant in tape.constants.items():
        numbers[constant_place] = constant
    operations = tape.operations[Segment.PARAMETERS]
    base = model_of(PENDULUM)
    lengths = {"n_tape_parameters": len(operations) // 5, "n_tape_laws": 0}
    lengths |= {"n_tape_signals": 0, "n_tape_outputs": 0}
    model = base._replace(
        sizes={**base.sizes, **lengths, "n_numbers": len(numbers)},
        tables={**base.tables, "tape": array("i", operations)},
        numbers=numbers,
    )
    bound = Kernel(model)
    bound.evaluate(0)
    return bound.numbers[place]


def same_bits(x, y):
    return x == y and math.copysign(1.0, x) == math.copysign(1.0, y)


@st.composite
def _operations(draw, operands):
    name = draw(st.sampled_from(sorted(ARITY)))
    arguments = [draw(operands) for _ in range(ARITY[name])]
    tables = [draw(st.sampled_from(TABLES))] if TABLE[name][:1] == TABLES[:1] else TABLE[name]
    return Expr(name, (*arguments, *tables))


finite = st.floats(-1e3, 1e3).map(lambda x: round(x, 2) + 0.0)
values = st.sampled_from([0.0, -0.0, 1.0, -1.0, 0.5, 2.0]) | st.floats(-1e3, 1e3)
leaves = st.sampled_from(NAMES).map(symbol) | finite
expressions = st.recursive(leaves, _operations, max_leaves=25)


@settings(max_examples=500)
@given(expressions, values, values, values)
def test_the_tape_has_the_value_of_its_expression(number, a, b, c):
    known = {"a": a, "b": b, "c": c}
    try:
        expected = evaluate(number, known)
    except ExpressionError:  # an infinity or no value on the way: the tape carries it on
        return
    assert same_bits(on_tape(number, known), expected)


def test_every_operation_of_expressions_has_a_code():
    assert set(ARITY) == set(OPERATIONS)
    assert set(CODES) == {"copy", *OPERATIONS}


NAN = {"a": math.nan, "b": 2.0, "c": -3.0}


@pytest.mark.parametrize(
    ("name", "operands", "expected"),
    [
        ("min", "ab", math.nan),
        ("min", "ba", math.nan),
        ("max", "ab", math.nan),
        ("max", "ba", math.nan),
        ("sign", "a", math.nan),
        ("abs", "a", math.nan),
        ("lt", "ab", 0.0),
        ("le", "ba", 0.0),
        ("gt", "ab", 0.0),
        ("ge", "ba", 0.0),
        ("eq", "aa", 0.0),
        ("ne", "aa", 1.0),
        ("not", "a", 0.0),
        ("select", "abc", 2.0),
        ("select", "bac", math.nan),
        ("select", "bca", -3.0),
    ],
)
def test_what_has_no_value_is_handed_on_and_never_hidden(name, operands, expected):
    """Unlike fmin and fmax of C; comparisons with it are false, a choice ignores the other side."""
    number = Expr(name, tuple(symbol(operand) for operand in operands))
    value = on_tape(number, NAN)
    assert value == expected or (math.isnan(value) and math.isnan(expected))


@pytest.mark.parametrize(
    ("name", "arguments", "expected"),
    [
        ("div", (1.0, 0.0), math.inf),
        ("div", (-1.0, 0.0), -math.inf),
        ("log", (0.0,), -math.inf),
        ("exp", (1e3,), math.inf),
        ("pow", (0.0, -1.0), math.inf),
        ("sqrt", (-1.0,), math.nan),
        ("log", (-1.0,), math.nan),
        ("asin", (2.0,), math.nan),
        ("pow", (-8.0, 1.0 / 3.0), math.nan),
        ("sinh", (-1e3,), -math.inf),
        ("cosh", (-1e3,), math.inf),
        ("mod", (1.0, 0.0), math.nan),
    ],
)
def test_beyond_its_domain_an_operation_is_that_of_ieee_754(name, arguments, expected):
    number = Expr(name, tuple(symbol(place) for place in NAMES[: len(arguments)]))
    known = dict(zip(NAMES, (*arguments, 0.0, 0.0), strict=False))
    value = on_tape(number, known)
    assert value == expected or (math.isnan(value) and math.isnan(expected))


@pytest.mark.parametrize("name", ["min", "max"])
@pytest.mark.parametrize("zeros", [(0.0, -0.0), (-0.0, 0.0)])
def test_of_two_equal_numbers_the_first_is_taken(name, zeros):
    """The sign of a zero decides over atan2(0, -1) = pi or -pi."""
    number = Expr(name, (symbol("a"), symbol("b")))
    value = on_tape(number, dict(zip(NAMES, (*zeros, 0.0), strict=True)))
    assert same_bits(value, apply(name, *zeros))


@pytest.mark.parametrize("x", [-7.25, -7.0, -0.5, -0.0, 0.0, 0.5, 7.0, 7.25, 1e300])
@pytest.mark.parametrize("y", [2.0, -2.0, 0.1])
def test_what_rounds_has_the_bits_of_its_expression(x, y):
    for name, arguments in (("floor", (x,)), ("ceil", (x,)), ("mod", (x, y))):
        number = Expr(name, tuple(symbol(place) for place in NAMES[: len(arguments)]))
        expected = apply(name, *arguments)
        assert same_bits(on_tape(number, {"a": x, "b": y, "c": 0.0}), expected)
    assert abs(apply("mod", x, y)) <= abs(y)
    assert apply("mod", x, y) * y >= 0.0


def test_equal_subexpressions_are_computed_once():
    tape = Tape(lambda _: (0, Segment.LAWS), 1)
    root = operate("sqrt", symbol("a"))
    tape.compile(root * root + operate("sin", root))
    codes = tape.operations[Segment.LAWS][::5]
    assert [CODES[code] for code in codes] == ["sqrt", "mul", "sin", "add"]


def test_what_parameters_do_not_fix_runs_when_it_is_needed():
    # Laws run in the middle of a step, signals at its end: neither may use what the other left.
    places = {"a": (0, Segment.PARAMETERS), "b": (1, Segment.LAWS), "c": (2, Segment.OUTPUTS)}
    tape = Tape(places.__getitem__, 3)
    a, b, c = (symbol(name) for name in NAMES)
    law, _ = tape.compile((a + 1.0) * b)
    signal, _ = tape.compile((a + 1.0) * b, Segment.SIGNALS)
    tape.compile((a + 1.0) * b - c, Segment.OUTPUTS)
    ran = {segment: [CODES[code] for code in tape.operations[segment][::5]] for segment in Segment}
    assert law != signal
    assert ran == {
        Segment.PARAMETERS: ["add"],
        Segment.LAWS: ["mul"],
        Segment.SIGNALS: ["mul"],
        Segment.OUTPUTS: ["mul", "sub"],
        Segment.TICKS: [],
    }


def test_parameters_inputs_and_measurements_reach_the_outputs_of_a_scene():
    text = """
    name = "outputs"
    dimension = 2
    [parameters]
    length = { value = 1.0 }
    half = { value = "length/2" }
    gain = { value = 3.0, variability = "tunable" }
    [inputs]
    drive = { start = 2.0 }
    [points]
    O = { position = [0, 0], fixed = true }
    A = { position = ["half", "sqrt(length**2 - half**2)"], mass = 1.0 }
    [joints]
    rod = { type = "distance", points = ["O", "A"] }
    [outputs]
    fixed = { value = "half" }
    driven = { value = "gain*drive if drive > length else -1" }
    moving = { value = "distance(O, A)*atan2(A.y, A.x) + t" }
    """
    run = start(text)
    assert [run[name] for name in ("fixed", "driven")] == [0.5, 6.0]
    assert run["moving"] == pytest.approx(math.pi / 3.0, rel=1e-15)
    run["length"] = 2.0
    assert [run[name] for name in ("half", "fixed", "driven")] == [1.0, 1.0, -1.0]
    run.advance(0.0, 0.25)
    run["drive"], run["gain"] = 5.0, 0.5
    assert run["driven"] == 2.5
    assert run["moving"] == pytest.approx(2.0 * math.pi / 3.0 + 0.25, rel=1e-14)


def test_an_output_that_uses_time_does_not_make_the_laws_run_in_every_step():
    text = (
        PENDULUM
        + """
[outputs]
swing = { value = "A.x*sin(t)" }
"""
    )
    model = model_of(text)
    assert model.sizes["time_dependent"] == 0
    run = start(text)
    run.advance(0.0, 0.1)
    assert run["swing"] == run["A.x"] * math.sin(run.time)


def _slips_of(*coordinates):
    """Operations of two slips with a grid at these coordinates: leaves are x, y, z and a rate."""
    leaves = [Leaf(LEAF_VALUE, k) for k in range(3)] + [Leaf(LEAF_RATE, 0)]
    height = operate("grid", *(symbol(f"#{k}") for k in coordinates), GRID)
    rate = symbol("#3")
    numbers = Numbers(dict.fromkeys(OFFSETS, ()), [], {}.__getitem__)
    return numbers.slips([height * rate, (height + 1.0) * rate], leaves)


def test_slips_share_a_grid_of_places_whose_coordinates_stand_one_behind_the_other():
    for slip in _slips_of(2, 0, 1):
        assert [x[0] for x in slip.each[:4]] == [CODES.index("copy")] * 3 + [CODES.index("grid")]
        assert slip.each[3][1] == 4  # the first of its coordinates, behind the leaves
        assert slip.still >= 4


@pytest.mark.parametrize("coordinates", [(3, 0, 1), (0, 3, 1), (0, 1, 3)])
def test_no_slip_has_a_grid_of_rates(coordinates):
    """Its coordinates would not be still, and be sorted behind others."""
    with pytest.raises(AssertionError, match="grid of rates"):
        _slips_of(*coordinates)
