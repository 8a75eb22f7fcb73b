"""The core's elementary functions: below 1 ulp, C99's special values, the same bits everywhere."""

from __future__ import annotations

import itertools
import math
import random
import struct

import mpmath
import pytest

from build_kernel import elementary_tables
from solver.runtime.operations import in_core

ONE = ("sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh")
TWO = ("atan2", "pow")
CASES = 1500
TINY = 2.0**-1074


def no_kernel(*_: float) -> float:
    raise AssertionError


def scattered(chance: random.Random, low: int, high: int) -> float:
    """Number of either sign with an exponent between two."""
    return chance.choice([1, -1]) * math.ldexp(chance.uniform(0.5, 1), chance.randint(low, high))


def near_a_multiple_of_half_pi(chance: random.Random) -> float:
    """Argument of sine and tangent whose remainder has lost most of its digits."""
    multiple = chance.randint(1, 10**6) * math.pi / 2
    return multiple * (1 + chance.choice([0, 1, -1, 3]) * 2.0**-52)


def argument(chance: random.Random, name: str) -> float:
    kind = chance.randrange(4)
    if name in ("sin", "cos", "tan"):
        choices = (
            chance.uniform(-10, 10), scattered(chance, -30, 22),
            near_a_multiple_of_half_pi(chance), scattered(chance, 20, 1023),
        )  # fmt: skip
        return choices[kind]
    if name in ("asin", "acos"):
        near_one = chance.choice([1, -1]) * (1 - abs(scattered(chance, -52, -2)))
        return (chance.uniform(-1, 1), scattered(chance, -30, -1), near_one, near_one)[kind]
    if name == "log":
        near_one = 1 + scattered(chance, -50, -2)
        return (abs(scattered(chance, -1073, 1023)), chance.uniform(0.3, 3), near_one, near_one)[
            kind
        ]
    large = 709.7 if name == "exp" else 60.0 if name == "atan" else 710.4
    return (
        chance.uniform(-large, large), scattered(chance, -40, 8), chance.uniform(-2, 2),
        scattered(chance, -5, 5),
    )[kind]  # fmt: skip


def arguments(chance: random.Random, name: str) -> tuple[float, ...]:
    if name in ONE:
        return (argument(chance, name),)
    if name == "atan2":
        middle = chance.randint(-1000, 950)
        low, high = chance.choice([(-3, 3), (middle, middle + 70), (-1000, 1000)])
        return scattered(chance, low, high), scattered(chance, low, high)
    y = scattered(chance, -10, 53)  # and x such that the power is a double
    largest = min(700.0 / abs(y), 700.0)
    x = math.exp(chance.uniform(-largest, largest))
    return (x, y) if x != 1.0 else (2.0, 0.5)


def error_in_ulp(exact: mpmath.mpf, found: float) -> float:
    exponent = max(int(mpmath.floor(mpmath.log(abs(exact), 2))) - 52, -1074) if exact else -1074
    return float(abs(mpmath.mpf(found) - exact) / mpmath.mpf(2) ** exponent)


@pytest.mark.parametrize("name", [*ONE, *TWO])
def test_an_elementary_function_is_off_by_less_than_an_ulp(name):
    chance, function = random.Random(f"ulp {name}"), in_core(name, no_kernel)
    exact = getattr(mpmath, "power" if name == "pow" else name)
    with mpmath.workprec(1300 if name in ("sin", "cos", "tan") else 200):
        for _ in range(CASES):
            values = arguments(chance, name)
            off = error_in_ulp(exact(*map(mpmath.mpf, values)), function(*values))
            assert off < 1.0, (name, values)


SPECIAL = [
    0.0, TINY, 2.0**-1022, 1e-300, 1e-20, 1e-8, 0.5, 1.0, 1.0 - 2.0**-53, 1.0 + 2.0**-52, 1.5, 2.0,
    3.0, 21.9, 22.1, 709.7, 709.8, 710.4, 710.5, 745.1, 745.2, 1e6, 2.0**53 - 1, 2.0**53, 1e22,
    1e300, 1.7976931348623157e308, math.inf, math.nan,
]  # fmt: skip


def by_python(name: str, values: tuple[float, ...]) -> float | None:
    """C99's value of a special argument; None where Python raises instead of naming it."""
    try:
        return getattr(math, name)(*values)
    except (ValueError, OverflowError):
        return None


@pytest.mark.parametrize("name", [*ONE, *TWO])
def test_special_arguments_have_the_values_of_c(name):
    function = in_core(name, no_kernel)
    signed = [*SPECIAL, *(-x for x in SPECIAL)]
    for values in itertools.product(signed, repeat=1 if name in ONE else 2):
        expected, found = by_python(name, values), function(*values)
        if expected is None:
            assert not math.isfinite(found), values
        elif math.isnan(expected):
            assert math.isnan(found), values
        elif expected == 0.0 or math.isinf(expected):
            assert struct.pack("d", found) == struct.pack("d", expected), values
        else:  # glibc's is off by up to an ulp as well
            assert abs(found - expected) <= 2.0 * math.ulp(expected), values


@pytest.mark.parametrize("name", ["sin", "tan", "asin", "atan", "sinh", "tanh"])
def test_an_odd_function_is_odd_to_the_bit(name):
    chance, function = random.Random(f"odd {name}"), in_core(name, no_kernel)
    for _ in range(CASES):
        x = argument(chance, name)
        assert function(-x) == -function(x)


def test_the_tables_are_those_of_their_definitions():
    assert elementary_tables.HEADER.read_text("utf-8") == elementary_tables.header()
