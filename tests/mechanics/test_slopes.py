"""The discrete chain rule: slopes times differences are the difference of the function, exactly."""

from __future__ import annotations

import cmath
import math
from decimal import Decimal, localcontext

import numpy as np
import pytest

from solver.mechanics.tape import CODE
from tests.oracle.slopes import discrete_gradient, moving, still

RANDOM = np.random.default_rng(5)

UNARY = {
    "copy": (-2.0, 2.0), "neg": (-2.0, 2.0), "sin": (-9.0, 9.0), "cos": (-9.0, 9.0),
    "tan": (-1.5, 1.5), "asin": (-0.99, 0.99), "acos": (-0.99, 0.99), "atan": (-9.0, 9.0),
    "sqrt": (0.1, 9.0), "exp": (-3.0, 3.0), "log": (0.1, 9.0), "abs": (-2.0, 2.0),
    "sinh": (-3.0, 3.0), "cosh": (-3.0, 3.0), "tanh": (-3.0, 3.0),
}  # fmt: skip
BINARY = ("add", "sub", "mul", "div", "atan2", "min", "max")
ONE_CONSTANT = ("pow", "mul", "div", "add", "sub")

COMPLEX = {
    "copy": lambda x: x, "neg": lambda x: -x, "sin": cmath.sin, "cos": cmath.cos,
    "tan": cmath.tan, "asin": cmath.asin, "acos": cmath.acos, "atan": cmath.atan,
    "sqrt": cmath.sqrt, "exp": cmath.exp, "log": cmath.log,
    "sinh": cmath.sinh, "cosh": cmath.cosh, "tanh": cmath.tanh,
    "abs": lambda x: x if x.real > 0.0 else -x,
}  # fmt: skip


def one(name, *changes, constants=()):
    """Slopes of one operation on leaves, then on constants."""
    places = [*range(len(changes)), *(-1 - k for k in range(len(constants)))]
    operation = (CODE[name], *(places + places[-1:] * 2)[:3])
    return discrete_gradient([operation], np.array([*constants, 0.0]), changes)


def ends(name):
    low, high = UNARY[name]
    return RANDOM.uniform(low, high, size=(40, 2))


@pytest.mark.parametrize("name", UNARY)
def test_slope_times_difference_is_the_difference_of_the_function(name):
    for x_n, x_n1 in ends(name):
        change, (slope,) = one(name, moving(x_n, x_n1 - x_n))
        exact = change.n1 - change.n  # rounding of the two values, of their size
        assert slope * (x_n1 - x_n) == pytest.approx(exact, abs=4e-15 * (1 + abs(change.n)))
        assert change.d == slope * (x_n1 - x_n)


@pytest.mark.parametrize("name", UNARY)
def test_slopes_are_symmetric_in_the_two_ends(name):
    for x_n, x_n1 in ends(name):
        _, (forward,) = one(name, moving(x_n, x_n1 - x_n))
        _, (backward,) = one(name, moving(x_n1, x_n - x_n1))
        assert forward == pytest.approx(backward, rel=4e-15)


@pytest.mark.parametrize("name", UNARY)
def test_without_a_difference_the_slope_is_the_derivative(name):
    for x, _ in ends(name):
        _, (slope,) = one(name, still(x))
        assert slope == pytest.approx(COMPLEX[name](complex(x, 1e-30)).imag / 1e-30, rel=1e-14)


@pytest.mark.parametrize("dx", [1e-2, 1e-3, 1e-4, 1e-5, 1e-8, 1e-12, 1e-200])
@pytest.mark.parametrize("name", UNARY)
def test_small_differences_lose_no_digits(name, dx):
    """Against the mean of the derivative over the step by Gauss-Legendre quadrature of 8 points."""
    at, weight = np.polynomial.legendre.leggauss(8)
    for x, _ in ends(name):
        _, (slope,) = one(name, moving(x, dx))
        derivatives = [one(name, still(x + 0.5 * dx * (1.0 + a)))[1][0] for a in at]
        crosses_zero = name == "abs" and x < 0.0 < x + dx
        if not crosses_zero and (name not in ("asin", "acos") or abs(x) < 0.9):
            assert slope == pytest.approx(0.5 * weight @ derivatives, rel=2e-15)


def value(name, x, y):
    return {
        "add": x + y, "sub": x - y, "mul": x * y, "div": x / y, "atan2": math.atan2(x, y),
        "min": min(x, y), "max": max(x, y),
    }[name]  # fmt: skip


@pytest.mark.parametrize("x", [-800.0, -30.0, 0.0, 30.0, 800.0])
@pytest.mark.parametrize("dx", [-1600.0, -50.0, -1.5, 1e-3, 0.9, 60.0, 1600.0])
def test_the_slope_of_tanh_is_finite_where_it_no_longer_changes(x, dx):
    with np.errstate(over="ignore"):
        change, (slope,) = one("tanh", moving(x, dx))
    assert slope * dx == pytest.approx(math.tanh(x + dx) - math.tanh(x), abs=4e-16)
    assert change.d == slope * dx


@pytest.mark.parametrize("dx", [1.0, 1e-3, 1e-9])
@pytest.mark.parametrize("name", BINARY)
def test_two_slopes_together_give_the_difference(name, dx):
    for x_n, y_n, dx_n, dy_n in RANDOM.uniform(0.2, 2.0, size=(40, 4)):
        x, y = moving(x_n, dx * dx_n), moving(y_n, -0.1 * dx * dy_n)
        change, slopes = one(name, x, y)
        exact = value(name, x.n1, y.n1) - value(name, x.n, y.n)
        assert slopes @ [x.d, y.d] == pytest.approx(exact, abs=4e-15 * max(1, abs(change.n)))
        _, backward = one(name, moving(x.n1, -x.d), moving(y.n1, -y.d))
        assert slopes == pytest.approx(backward, rel=4e-15)


@pytest.mark.parametrize("exponent", [0.0, 1.0, 2.0, 3.0, 7.0, 16.0, -1.0, -3.0, 0.5, 2.5, -1.7])
def test_powers_with_a_constant_exponent(exponent):
    for x_n, dx in RANDOM.uniform(0.3, 1.7, size=(40, 2)):
        change, (slope,) = one("pow", moving(x_n, dx), constants=[exponent])
        scale = abs(change.n) + abs(change.n1)
        assert slope * dx == pytest.approx(change.n1 - change.n, abs=1e-14 * scale)
        _, (derivative,) = one("pow", still(x_n), constants=[exponent])
        assert derivative == pytest.approx(exponent * x_n ** (exponent - 1.0), rel=1e-14)


def test_a_whole_power_of_a_negative_number_is_a_product():
    change, (slope,) = one("pow", moving(-1.5, 2.25), constants=[3.0])
    assert slope * 2.25 == 0.75**3 + 1.5**3
    assert change.d == slope * 2.25


@pytest.mark.parametrize("dx", [0.5, 1e-3, 1e-10])
def test_a_power_with_a_moving_exponent(dx):
    for x_n, y_n in RANDOM.uniform(0.3, 1.7, size=(40, 2)):
        x, y = moving(x_n, dx), moving(y_n, 0.3 * dx)
        change, slopes = one("pow", x, y)
        assert slopes @ [x.d, y.d] == pytest.approx(change.n1 - change.n, abs=4e-15)


def test_the_angle_of_a_vector_keeps_its_sense_over_the_cut():
    before, after = 3.1, 3.3
    x = moving(math.cos(before), math.cos(after) - math.cos(before))
    y = moving(math.sin(before), math.sin(after) - math.sin(before))
    change, slopes = one("atan2", y, x)
    assert slopes @ [y.d, x.d] == pytest.approx(0.2, rel=1e-14)
    assert change.d == pytest.approx(0.2, rel=1e-14)


def test_a_composed_function_changes_by_its_slopes_to_the_last_digit():
    """The function sqrt(x^2 + y^2) exp(-x/3) against decimal arithmetic of 50 digits."""
    operations = [
        (CODE["mul"], 0, 0, 0), (CODE["mul"], 1, 1, 1), (CODE["add"], 2, 3, 3),
        (CODE["sqrt"], 4, 4, 4), (CODE["div"], 0, -1, -1), (CODE["neg"], 6, 6, 6),
        (CODE["exp"], 7, 7, 7), (CODE["mul"], 5, 8, 8),
    ]  # fmt: skip

    def exact(x, y):
        x, y = Decimal(x), Decimal(y)
        return (x * x + y * y).sqrt() * (-x / 3).exp()

    for size in (1.0, 1e-3, 1e-9, 1e-14):
        for x_n, y_n, dx, dy in RANDOM.uniform(0.5, 1.5, size=(20, 4)):
            x, y = moving(x_n, size * dx), moving(y_n, size * dy)
            change, slopes = discrete_gradient(operations, np.array([3.0]), [x, y])
            with localcontext() as context:
                context.prec = 50
                ends = [Decimal(p.n) + Decimal(p.d) for p in (x, y)]
                expected = float(exact(*ends) - exact(x.n, y.n))
            # the two terms can cancel each other
            assert slopes @ [x.d, y.d] == pytest.approx(expected, abs=2e-15 * size)
            assert change.d == pytest.approx(expected, abs=2e-15 * size)


def test_what_a_condition_selects_is_what_moves():
    for condition, expected in ((1.0, [1.0, 0.0]), (0.0, [0.0, 1.0])):
        _, slopes = discrete_gradient(
            [(CODE["select"], -1, 0, 1)],
            np.array([condition]),
            [moving(1.0, 0.5), moving(2.0, 0.1)],
        )
        assert slopes.tolist() == expected


def test_a_number_that_stays_zero_has_no_slope():
    assert one("abs", still(0.0))[1].tolist() == [0.0]
    assert one("abs", moving(-1.0, 2.0))[1].tolist() == [0.0]
