"""Principal moments of a rigid body: whether one can have them, and the nearest that one can.

No moment is larger than the sum of the other two, in a flat body equal to it: J3 <= J1 + J2 of
J1 <= J2 <= J3. Numbers printed with few digits break this by what their digits left out. Each is
off by up to half a unit of its last digit, e_ik, so that with the axis a of the largest moment

    J3 - J1 - J2 <= sum |2 a_i a_k - delta_ik| e_ik.

As much is forgiven, and what is left of it, as well as `FORGIVEN`, is mended: each of the three
moments goes a third of the way, or, where one would be negative, the body becomes a rod.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal, InvalidOperation

Matrix = Sequence[Sequence[float]]

ROUND_OFF = 1e-12
"""By which a moment may exceed the sum of the others, relative to that sum: nothing is mended."""
FORGIVEN = 1e-7
"""The same for what is mended whatever its digits, relative to the largest moment: as little as a
body without extent in a direction is given anyway."""
MOST_MENDED = 0.1
"""What digits may explain, relative to the largest moment: one digit alone explains anything."""


def principal(J: Matrix) -> tuple[list[float], list[list[float]]]:
    """Return the moments, increasing, and their axes; those of a diagonal matrix are exact."""
    if all(J[i][k] == 0.0 for i in range(3) for k in range(3) if i != k):
        order = sorted(range(3), key=lambda i: J[i][i])
        return [J[i][i] for i in order], [[float(i == k) for k in range(3)] for i in order]
    from numpy.linalg import eigh  # takes long to import, and few bodies have products

    moments, axes = eigh(J)
    return moments.tolist(), axes.T.tolist()


def excess(moments: Sequence[float]) -> float:
    """Return by how much moments miss those of a body, 0 where it is round-off [kg.m2]."""
    small, middle, large = moments
    over = large - small - middle
    broken = over > ROUND_OFF * (small + middle) or small < -ROUND_OFF * large
    return max(over, -small) if broken else 0.0


def explained(moments: Sequence[float], axes: Matrix, written: Matrix) -> float:
    """Return the excess that is forgiven, given half a unit of the last digit of each number."""
    large, axis = moments[2], axes[2]
    by_digits = sum(
        abs(2.0 * axis[i] * axis[k] - float(i == k)) * written[i][k]
        for i in range(3) for k in range(3)
    )  # fmt: skip
    return max(FORGIVEN * large, min(by_digits * (1.0 + 1e-9), MOST_MENDED * large))


def nearest(moments: Sequence[float]) -> list[float]:
    """Return the nearest moments that a body can have, of those that exceed them."""
    small, middle, large = moments
    third = (large - small - middle) / 3.0
    flat = [small + third, middle + third, large - third]
    if min(flat) >= 0.0 and flat[1] <= flat[0] + flat[2]:
        return [flat[0], flat[1], flat[0] + flat[1]]
    mean = max(middle + large, 0.0) / 2.0
    return [0.0, mean, mean]


def composed(moments: Sequence[float], axes: Matrix) -> list[list[float]]:
    """Return the inertia of moments about axes."""
    return [
        [sum(x * a[i] * a[k] for x, a in zip(moments, axes, strict=True)) for k in range(3)]
        for i in range(3)
    ]  # fmt: skip


def half_units(texts: Matrix | Sequence[Sequence[str]]) -> list[list[float]]:
    """Return half a unit of the last digit of each number that a file writes, in its unit.

    A whole number and a formula are exact. A printer may have left out zeros at the end, but not in
    all of them: none has fewer places, or fewer digits in all, than the one with the most.
    """
    read = [[_decimal(str(text)) for text in row] for row in texts]
    given = [x for row in read for x in row if x is not None]
    finest = min((_last(x) for x in given), default=0)
    most = max((len(x.as_tuple().digits) for x in given if x), default=1)

    def half(x: Decimal | None) -> float:
        if x is None:
            return 0.0
        floor = max(finest, x.adjusted() - most + 1) if x else finest
        return 0.5 * 10.0 ** min(_last(x), floor)

    return [[half(x) for x in row] for row in read]


def _decimal(text: str) -> Decimal | None:
    """Return a number with the digits of a text; None of a whole one and of what is no number."""
    if not any(mark in text for mark in ".eE"):
        return None
    try:
        found = Decimal(text.replace("_", ""))
    except InvalidOperation:
        return None
    return found if found.is_finite() else None


def _last(x: Decimal) -> int:
    """Return the power of ten of the last digit."""
    exponent = x.as_tuple().exponent
    assert isinstance(exponent, int)
    return exponent
