"""Coulomb friction that a force writes with a sign: it holds, where a force that jumps cannot.

    f = a - c sign(s'),    c > 0,    with s' the rate along which f acts

At s' = 0 the force is any between a - c and a + c. Friction has that law: a velocity row s' = 0
that holds up to the preload c, and a force of this size against the slip else.
"""

from __future__ import annotations

from collections.abc import Mapping

from solver.mechanics.formulas import leaf_symbol
from solver.mechanics.mechanism import Formula, Friction, Leaf, Scale
from solver.mechanics.rows import Rows
from solver.scene import Expr, Number, symbols
from solver.scene.expression import Operand, operate


def without_friction(
    rows: Rows, value: Number, slips: Mapping[str, float], scale: Scale
) -> Number:  # fmt: skip
    """Return a force without what rubs in it, which becomes a friction of the mechanism.

    Parameters
    ----------
    rows : Rows
        Of the force.
    value : float or Expr
    slips : mapping of str to float
        Names of the rates along which it acts, and the sign with which it does.
    scale : Scale
        Of the row that holds.
    """
    mechanism = rows.mechanism
    for name, direction in slips.items():
        split = _split(value, name) if name in symbols(value) else None
        rate = rows.parts.meaning(name) if split and split[1] != 0.0 else None
        if split is None or not isinstance(rate, Leaf):
            continue
        rest, jump = split
        size = -direction * jump
        if symbols(size) - rows.parts.scene.parameters.keys() or mechanism.default(size) <= 0.0:
            continue  # it pushes, or changes in motion: it is left to switch
        if isinstance(size, Expr):
            rows.rule(size, ">=", "the factor of the sign of its rate must not push")
        row = rows.velocity(
            Formula(leaf_symbol(0), (mechanism.leaf(rate.index, rate.kind),)), scale
        )
        rows.parts.rubbing[rows.name] = len(mechanism.frictions), direction
        normal = ((row,),)  # nothing presses: its coefficient is 0
        mechanism.frictions.append(Friction((row[1],), normal, 0.0, 0.0, size))
        return rest
    return value


def _operations_on(value: Operand | str, name: str) -> list[str]:
    """Return the operations of a tree that have a symbol for their only operand."""
    if not isinstance(value, Expr) or value.op in ("symbol", "call"):
        return []
    own = [value.op] if [str(arg) for arg in value.args] == [name] else []
    return own + [op for arg in value.args for op in _operations_on(arg, name)]


def _split(value: Operand | str, name: str) -> tuple[Number, Number] | None:
    """Return a and b of a + b sign(name), neither with that sign; None if it is no such sum."""
    if not isinstance(value, Expr):
        return (value, 0.0) if isinstance(value, float) else None
    if value.op == "sign" and str(value.args[0]) == name:
        return 0.0, 1.0
    if name not in symbols(value):
        return value, 0.0
    if not any(op == "sign" for op in _operations_on(value, name)):
        return value, 0.0
    parts = [_split(arg, name) for arg in value.args]
    first, second = parts[0], parts[-1]
    if first is None or second is None:
        return None
    if value.op in ("add", "sub"):
        rest, jump = (operate(value.op, x, y) for x, y in zip(first, second, strict=True))
        return rest, jump
    if value.op == "neg":
        return operate("neg", first[0]), operate("neg", first[1])
    if value.op == "mul" and 0.0 in (first[1], second[1]):
        factor, split = (first[0], second) if first[1] == 0.0 else (second[0], first)
        return operate("mul", factor, split[0]), operate("mul", factor, split[1])
    if value.op == "div" and second[1] == 0.0:
        return operate("div", first[0], second[0]), operate("div", first[1], second[0])
    return None
