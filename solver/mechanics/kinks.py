"""Kinks of energies and of forces: where abs, min, max or a profile of what moves goes over.

Slopes of an energy over a step are exact across its kinks, and a force that reads the step takes
the means there: they read no side. What a kink costs is accuracy. All steps end at kinks of forces,
and those that a tolerance chooses at those of energies, too. A compliant contact has one where its
gap is 0, and another where its damping takes all of its force.
"""

from __future__ import annotations

from collections.abc import Mapping

from solver.mechanics.derivative import derivative
from solver.mechanics.formulas import leaf_symbol, sensed, sensor, with_symbols
from solver.mechanics.knots import has_knots
from solver.mechanics.mechanism import Kink, Leaf
from solver.mechanics.parts import CompliantContact, Meaning
from solver.mechanics.rows import Rows
from solver.mechanics.switches import named, operations_that_switch
from solver.runtime.layout import LEAF_RATE, LEAF_VALUE
from solver.scene import Expr, Number
from solver.scene.expression import operate, select


def add_kinks(
    rows: Rows, number: Number, own: Mapping[str, Meaning] | None = None, *, of_energy: bool = True
) -> None:
    """Note kinks of an energy or a force as it is written; `own` is what symbols mean in it."""
    for operation in operations_that_switch(number):
        if operation.op != "spline" or has_knots(operation):
            found = sensed(rows.parts, operation, own, by_laws=False)
            _note(rows, found, named(rows.title, str(operation)), of_energy=of_energy)


def add_kinks_of_contact(rows: Rows, contact: CompliantContact, end: str) -> None:
    """Note those of a compliant contact; `end` tells which of its gaps it is."""
    value, rate = (sensor(Leaf(kind, contact.quantity)) for kind in (LEAF_VALUE, LEAF_RATE))
    depth = -1.0 * with_symbols(contact.gap, {leaf_symbol(0): value})
    _note(rows, operate("max", depth, 0.0), f"{rows.title}{end} opens or closes")
    if contact.damping == 0.0:
        return
    slope = with_symbols(derivative(contact.gap, "#0"), {leaf_symbol(0): value})
    share = select(operate("gt", depth, 0.0), 1.0 - contact.damping * slope * rate, 1.0)
    name = f"{rows.title}{end} pushes, or its damping takes all of its force"
    _note(rows, operate("max", share, 0.0), name)


def _note(rows: Rows, operation: Number, name: str, *, of_energy: bool = True) -> None:
    if isinstance(operation, Expr):
        rows.mechanism.kinks.append(Kink(operation, name, of_energy))
