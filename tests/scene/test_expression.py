"""Expressions: what the text means, what is refused, and that folding changes no value."""

import copy
import math
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

import solver
from solver.scene.expression import (
    FUNCTIONS,
    Expr,
    ExpressionError,
    evaluate,
    operate,
    select,
    symbol,
    symbols,
)
from solver.scene.grammar import parse, read

PYTHON = {name: getattr(math, name, None) for name in FUNCTIONS} | {
    "abs": math.fabs,
    "min": min,
    "max": max,
    "sign": lambda x: 0.0 if x == 0 else math.copysign(1.0, x),
    "pi": math.pi,
}

numbers = st.floats(-1e3, 1e3).map(lambda x: round(x, 3)).map(lambda x: repr(x + 0.0))
leaves = numbers | st.sampled_from(["a", "b", "A.x", "pi", "2", "1", "0"])


def _combined(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    binary = st.sampled_from(["+", "-", "*", "/", "**", "<", "<=", ">", ">=", "==", "!="])
    unary = st.sampled_from([name for name, count in FUNCTIONS.items() if count == 1])
    two = st.sampled_from(["min", "max"])
    return st.one_of(
        st.builds("({} {} {})".format, inner, binary, inner),
        st.builds("{}({})".format, unary, inner),
        st.builds("{}({}, {})".format, two, inner, inner),
        st.builds("(-{})".format, inner),
        st.builds("({} if {} else {})".format, inner, inner, inner),
        st.builds("({} < {} <= {})".format, inner, inner, inner),
    )


texts = st.recursive(leaves, _combined, max_leaves=8)


class Part:
    """Stands for the point A in Python's own evaluation."""

    def __init__(self, x: float) -> None:
        self.x = x


def python_value(text: str, a: float, b: float, x: float) -> float | None:
    """Python's own value of a text with every literal a float; None where it has none."""
    names = {"a": a, "b": b, "A": Part(x)}
    try:
        value = float(eval(text, {"__builtins__": {}}, PYTHON | names))
    except (ArithmeticError, ValueError, TypeError):  # TypeError: a complex power
        return None
    return value if math.isfinite(value) else None


@given(texts, *[st.floats(-100, 100)] * 3)
def test_an_expression_has_pythons_own_value(text, a, b, x):
    expected = python_value(text, a, b, x)
    if expected is None:
        return
    try:
        value = evaluate(parse(text), {"a": a, "b": b, "A.x": x})
    except ExpressionError:  # an infinity inside, such as exp(1000) < 2, is refused throughout
        return
    assert value == pytest.approx(expected, rel=1e-9, abs=1e-300)


@given(texts, *[st.floats(-100, 100)] * 3)
def test_folding_never_changes_a_value(text, a, b, x):
    """Constants known as the tree is built, or only as it is evaluated, give the same bits."""
    values = {"a": a, "b": b, "A.x": x}
    try:
        late = evaluate(parse(text), values)
    except ExpressionError:
        return
    assert substitute(parse(text), values) == late


def substitute(number, values):
    """Build the tree anew with its symbols known, so that every operation folds."""
    if not isinstance(number, Expr):
        return number
    if number.op == "symbol":
        return values[number.args[0]]
    if number.op == "select":
        condition = substitute(number.args[0], values)
        return substitute(number.args[1] if condition else number.args[2], values)
    return operate(number.op, *(substitute(arg, values) for arg in number.args))


@given(texts)
def test_the_text_of_an_expression_reads_back_as_the_same_expression(text):
    try:
        number = parse(text)
    except ExpressionError:
        return
    assert parse(str(number) if isinstance(number, Expr) else f"({number!r})") == number


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2*(3 + 4)", 14.0),
        ("2**3**2", 512.0),
        ("-2**2", -4.0),
        ("7/2", 3.5),
        ("1e3", 1000.0),
        ("pi", math.pi),
        ("+1", 1.0),
        ("min(3, 1, 2)", 1.0),
        ("sign(-0.5)", -1.0),
        ("1 if 2 < 3 else 0", 1.0),
        ("1 < 2 < 2", 0.0),
        ("not 3", 0.0),
        ("2 and 3", 1.0),
        ("0 or 0", 0.0),
        ("  1 + 1  ", 2.0),
    ],
)
def test_constants_fold_to_a_float(text, value):
    number = parse(text)
    assert isinstance(number, float)
    assert number == value


@pytest.mark.parametrize("text", ["x + 0", "0 + x", "x - 0", "x*1", "1*x", "x/1", "x**1", "-(-x)"])
def test_neutral_elements_fold(text):
    assert parse(text) == symbol("x")


@pytest.mark.parametrize(("text", "value"), [("x*0", 0.0), ("0/x", 0.0), ("x**0", 1.0)])
def test_absorbing_elements_fold(text, value):
    assert parse(text) == value


@pytest.mark.parametrize(
    ("text", "column", "message"),
    [
        ("2*(3", 3, "'(' was never closed"),
        ("2 +", 4, "not an expression"),
        ("1 + ", 4, "not an expression"),
        ("   2 3", 6, "not an expression"),
        ("", 1, "empty expression"),
        ("1/0", 1, "1 / 0: division by zero"),
        ("2 + sqrt(-1)", 5, "sqrt(-1): no real value"),
        ("(-8)**(1/3)", 1, "(-8) ** 0.333333: no real value"),
        ("exp(1000)", 1, "exp(1000): larger than any floating-point number"),
        ("1e308*10", 1, "1e+308 * 10: larger than any floating-point number"),
        ("1e999", 1, "number larger than any floating-point number"),
        ("1" + "0" * 400, 1, "number larger than any floating-point number"),
        ("2 ^ 3", 1, "operator '^' is not available"),
        ("5 % 2", 1, "operator '%' is not available"),
        ("5 // 2", 1, "operator '//' is not available"),
        ("a[0]", 1, "square brackets are not available"),
        ("sine(1)", 1, "unknown function 'sine'"),
        ("1 + sin(1, 2)", 5, "sin() takes 1 argument, got 2"),
        ("min(1)", 1, "min() takes at least 2 arguments, got 1"),
        ("sin(x=1)", 1, "sin() takes 1 argument, got 1"),
        ("1 + True", 5, "True is not a real number"),
        ("2j", 1, "2j is not a real number"),
        ("'a'", 1, "'a' is not a real number"),
        ("a is b", 1, "comparisons are < <= > >= == !="),
        ("lambda: 1", 1, "'lambda' is not available"),
        ("__import__('os')", 1, "unknown function '__import__'"),
        ("(1).real", 2, "only a name can stand before or after a dot"),
        ("a := 1", 3, "not an expression"),
        ("distance(A, 2)", 13, "only a name can stand before or after a dot"),
        ("1 + é)", 6, "unmatched ')'"),
        ("é + 1/0", 5, "1 / 0: division by zero"),
        ("a\x00b", 1, None),
    ],
)
def test_what_is_no_expression_is_refused_with_its_column(text, column, message):
    with pytest.raises(ExpressionError) as caught:
        parse(text)
    assert caught.value.column == column
    if message is not None:
        assert caught.value.message == message


def test_deep_nesting_is_refused():
    for text in ("(" * 5000 + "1" + ")" * 5000, "1" + "+1" * 100_000, "-" * 50_000 + "1"):
        with pytest.raises(ExpressionError):
            parse(text)


def test_symbols_and_calls_are_found_even_where_they_fold_away():
    reading = read("0*foo + distance(A, B)/A.x")
    assert symbols(reading.number) == {"A.x", "distance(A, B)"}
    assert [(m.name, m.column, m.role) for m in reading.mentions] == [
        ("foo", 3, "symbol"),
        ("distance", 9, "function"),
        ("A", 18, "part"),
        ("B", 21, "part"),
        ("A.x", 24, "symbol"),
    ]


def test_a_call_is_evaluated_under_its_text():
    assert evaluate(parse("2*distance(A, B)"), {"distance(A, B)": 1.5}) == 3.0


def test_only_the_chosen_side_of_a_choice_is_evaluated():
    number = parse("1/x if x != 0 else 0")
    assert evaluate(number, {"x": 0.0}) == 0.0
    assert evaluate(number, {"x": 4.0}) == 0.25


def test_an_evaluation_without_a_real_value_is_an_error():
    with pytest.raises(ExpressionError, match=r"sqrt\(-4\): no real value"):
        evaluate(parse("sqrt(x)"), {"x": -4.0})


def test_shared_branches_cost_once():
    number = symbol("x")
    for _ in range(200):  # 2**200 leaves if the branches were not shared
        number = number + number
    assert evaluate(number, {"x": 1.0}) == 2.0**200
    assert symbols(number) == {"x"}
    assert hash(number) == hash(copy.copy(number))


def test_long_sums_need_no_recursion():
    number = symbol("x")
    for _ in range(20_000):
        number = number + 1.0
    assert evaluate(number, {"x": 0.0}) == 20_000.0


def test_expressions_are_immutable_hashable_and_picklable():
    number = parse("2*x + sin(y)")
    assert isinstance(number, Expr)
    assert {number: 1}[parse("2*x + sin(y)")] == 1
    assert pickle.loads(pickle.dumps(number)) == number
    with pytest.raises(AttributeError, match="immutable"):
        number.op = "mul"
    with pytest.raises(TypeError, match="select"):
        bool(number)


def test_numbers_combine_with_expressions():
    x = symbol("x")
    number = select(operate("lt", x, 0), -x, 2 / (1 - x**2))
    assert evaluate(number, {"x": -3.0}) == 3.0
    assert evaluate(number, {"x": 0.0}) == 2.0
    assert 2 + x == x.__radd__(2.0)
    assert 0 - x == -x
    assert x != 2.0


def test_a_part_may_be_called_floor_as_the_bracket_tells_the_function_apart():
    text = 'name = "f"\ndimension = 2\n[parameters]\nfloor = 2.5\nlow = "floor(floor) + floor"\n'
    text += '[points]\nA = { position = ["low", 0], mass = 1 }\n'
    assert evaluate(solver.loads(text).parameters["low"].value, {"floor": 2.5}) == 4.5
