"""Coefficients of the compositions against the conditions of their order.

A symmetric second-order pair is exp(h D1 + h^3 D3 + h^5 D5 + ...) with operators that do not
commute. A composition of parts gamma is the product of exp(gamma h D1 + gamma^3 h^3 D3 + ...),
whose words of weight k up to the order must be those of exp(h D1): D1^k/k! and nothing else.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from math import factorial
from pathlib import Path

import pytest

TEXT = (Path(__file__).parents[2] / "solver" / "kernel" / "methods" / "composition.h").read_text(
    "utf-8"
)
"""Where the kernel has them."""


def _numbers(text: str) -> tuple[float, ...]:
    return tuple(float(x) for x in text.split(","))


_ARRAYS = dict(re.findall(r"static const double (\w+)\[\] = \{(.*?)\};", TEXT, re.DOTALL))

FIRST_PARTS = {
    order: _numbers(_ARRAYS[name])
    for order, name in {2: "whole", 4: "fourth", 6: "sixth", 8: "eighth"}.items()
}
"""Parts of a step up to the middle one, by order."""


def stages(order: int) -> tuple[float, ...]:
    """Parts of a step, each taken by a pair of half steps."""
    first = FIRST_PARTS[order]
    return (*first, *first[-2::-1])


Series = dict[tuple[int, ...], Fraction]
"""Coefficients of words in the letters 1, 3, 5, ... for D1, D3, D5, ...; a letter is its weight."""

HIGHEST = 9
ONE: Series = {(): Fraction(1)}


def product(first: Series, second: Series) -> Series:
    """Product of two series up to the weight `HIGHEST`."""
    found: Series = {}
    for left, a in first.items():
        for right, b in second.items():
            if sum(left) + sum(right) <= HIGHEST:
                found[left + right] = found.get(left + right, Fraction(0)) + a * b
    return found


def pair(part: Fraction) -> Series:
    """Series of a pair of length `part`: exp(part D1 + part^3 D3 + ...)."""
    exponent: Series = {(k,): part**k for k in range(1, HIGHEST + 1, 2)}
    found, power = dict(ONE), dict(ONE)
    for n in range(1, HIGHEST + 1):
        power = product(power, exponent)
        for word, value in power.items():
            found[word] = found.get(word, Fraction(0)) + value / factorial(n)
    return found


def words(weight: int) -> Iterator[tuple[int, ...]]:
    """All words of a weight."""
    if weight == 0:
        yield ()
    for letter in range(1, weight + 1, 2):
        yield from ((letter, *rest) for rest in words(weight - letter))


def defects(order: int) -> dict[int, float]:
    """Largest difference of the words of each weight from those of exp(D1)."""
    total = dict(ONE)
    for part in stages(order):
        total = product(total, pair(Fraction(part).limit_denominator(10**18)))
    exact = {(1,) * k: Fraction(1, factorial(k)) for k in range(HIGHEST + 1)}
    return {
        k: max(float(abs(total.get(w, 0) - exact.get(w, 0))) for w in words(k))
        for k in range(1, HIGHEST + 1)
    }


@pytest.mark.parametrize("order", FIRST_PARTS)
def test_the_parts_fulfil_all_conditions_of_their_order_and_not_of_the_next(order):
    # Coefficients are doubles of size 1, words sums of products of up to eight of them.
    found = defects(order)
    assert max(found[k] for k in range(1, order + 1)) < 1e-14
    assert found[order + 1] > 1e-4
