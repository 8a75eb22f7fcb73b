"""Laws of force along one quantity, read within a step: N(sigma, sigma', ...) on its means.

A law is exact in what it takes: N dsigma in each step, whatever its form. One that resists takes
energy or none; one that drives does work (theory 5.8).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from solver.mechanics.formulas import formula
from solver.mechanics.kinks import add_kinks
from solver.mechanics.mechanism import Leaf, Scale
from solver.mechanics.parts import ForceLaw
from solver.mechanics.rows import Rows
from solver.mechanics.rubbing import without_friction
from solver.runtime.layout import LEAF_RATE, LEAF_VALUE, TAKES, WORKS
from solver.scene import Expr, ExpressionError, Number, evaluate, symbols
from solver.scene.expression import Curve
from solver.scene.rules import RATE

FASTEST = 100.0
"""Largest rate at which a law that resists is looked at [m/s, rad/s]."""
_PUSHES = 1e-12
"""Part of the largest force beyond which a push is no round-off."""


def add_resistance(rows: Rows, quantity: int, word: str, force: Number, scale: Scale) -> None:
    """Add a force against the rate of a quantity, which takes energy or none.

    Parameters
    ----------
    rows : Rows
    quantity : int
    word : str
        What the quantity is called in the law, beside ``rate``.
    force : Number
        [N or N.m], of the sign of ``rate``.
    scale : Scale
        Of the row that holds where a sign of the rate rubs.

    Raises
    ------
    ExpressionError
        When it pushes at some rate, or jumps with the motion at another place than rest.
    """
    own = {word: Leaf(LEAF_VALUE, quantity), RATE: Leaf(LEAF_RATE, quantity)}
    _must_resist(rows, force)
    rest = -1.0 * without_friction(rows, -1.0 * force, {RATE: 1.0}, scale, own)
    _add(rows, quantity, ForceLaw(rest, own), TAKES)


def add_drive(rows: Rows, quantity: int, force: Number) -> None:
    """Add a force along a quantity, which may read its ``rate``, and does work.

    Raises
    ------
    ExpressionError
        When it jumps with the motion.
    """
    _add(rows, quantity, ForceLaw(-1.0 * force, {RATE: Leaf(LEAF_RATE, quantity)}), WORKS)


def _add(rows: Rows, quantity: int, law: ForceLaw, role: int) -> None:
    rows.parts.force_laws[rows.name] = law
    if not isinstance(law.force, Expr):  # all of it rubs
        return
    found = formula(rows.parts, law.force, signals=False, own=law.own, along=quantity)
    rows.mechanism.potentials.append(found._replace(role=role))
    add_kinks(rows, law.force, law.own, of_energy=False)


def _must_resist(rows: Rows, force: Number) -> None:
    """Raise `ExpressionError` where a law of its rate alone pushes along it."""
    mechanism = rows.mechanism
    if symbols(force) - {RATE} - rows.parts.scene.parameters.keys():
        return  # what else it reads moves: each step books what it does
    rates = sorted({*_rates(), *_knots(force)})
    taken = [(rate * evaluate(force, {**mechanism.defaults, RATE: rate}), rate) for rate in rates]
    least, rate = min(taken)
    if least < -_PUSHES * max(taken)[0]:
        message = f"it is {least / rate:.6g} at a rate of {rate:.6g}, and would push along it: a "
        message += "damper resists, so write a force of the sign of 'rate'; one that drives is an "
        message += "actuator"
        raise ExpressionError(message)


def _rates() -> Iterator[float]:
    for size in np.geomspace(1e-6, FASTEST, 200):
        yield float(size)
        yield -float(size)


def _knots(force: Number) -> Iterator[float]:
    """Yield arguments of the knots of profiles, and those between them, as rates."""
    if not isinstance(force, Expr):
        return
    table = force.args[-1] if force.op == "spline" else None
    if isinstance(table, Curve):
        knots = [x for x in table.numbers[1::6] if abs(x) < np.inf]
        yield from (x for x in knots if x)
        yield from (0.5 * (a + b) for a, b in pairwise(knots) if a + b)
    for part in force.args:
        if isinstance(part, Expr):
            yield from _knots(part)
