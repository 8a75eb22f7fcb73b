"""Coulomb friction that a force writes with a sign: it holds, where a force that jumps cannot.

    f = a - c sign(s'),    c > 0 at s' = 0,    with s' the rate along which f acts

At s' = 0 the force is any between a - c and a + c. Friction has that law: a velocity row s' = 0
that holds up to the preload c, and a force of this size against the slip else. Where c depends on
s', as Stribeck's does, the friction has that of s' = 0, and the force keeps what c differs by.
"""

from __future__ import annotations

from collections.abc import Mapping

from solver.mechanics.formulas import leaf_symbol, with_symbols
from solver.mechanics.mechanism import Formula, Friction, Leaf, Scale
from solver.mechanics.rows import Rows
from solver.scene import Expr, Number, symbols
from solver.scene.expression import Operand, operate, symbol

SIDES = {
    "sign": (0.0, 1.0), "gt": (0.5, 0.5), "ge": (0.5, 0.5), "lt": (0.5, -0.5), "le": (0.5, -0.5),
    "eq": (0.0, 0.0), "ne": (1.0, 0.0),
}  # fmt: skip
"""Operations on a number x, or on x and 0, that jump at x = 0: a and b of a + b sign(x)."""


def without_friction(
    rows: Rows, value: Number, slips: Mapping[str, float], scale: Scale,
    own: Mapping[str, Leaf] | None = None,
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
    own : mapping, optional
        Symbols with a meaning in the force alone, such as ``rate``.
    """
    mechanism = rows.mechanism
    for name, direction in slips.items():
        split = _split(value, name) if name in symbols(value) else None
        rubs = split is not None and split[1] != 0.0
        rate = ((own or {}).get(name) or rows.parts.meaning(name)) if rubs else None
        if split is None or not isinstance(rate, Leaf):
            continue
        rest, jump = split[0], with_symbols(split[1], {symbol(name): 0.0})
        if name in symbols(split[1]):
            changes = operate("mul", operate("sub", split[1], jump), operate("sign", symbol(name)))
            rest = operate("add", rest, changes)
        size = -direction * jump
        if symbols(size) - rows.parts.scene.parameters.keys() or mechanism.default(size) <= 0.0:
            continue  # it pushes, or changes in motion: it is left to switch
        if isinstance(size, Expr):
            rows.rule(size, ">=", "the factor of the sign of its rate must not push")
        rows.detail = f" along {name}"
        row = rows.velocity(
            Formula(leaf_symbol(0), (mechanism.leaf(rate.index, rate.kind),)), scale
        )
        rows.parts.rubbing[rows.name] = len(mechanism.frictions), direction
        normal = ((row,),)  # nothing presses: its coefficient is 0
        mechanism.frictions.append(Friction((row[1],), normal, 0.0, 0.0, size))
        return rest
    return value


def _split(value: Operand | str, name: str) -> tuple[Number, Number] | None:
    """Return a and b of a + b sign(name), neither of which jumps at name = 0; None for another law.

    Comparisons with 0 are signs: name > 0 is (1 + sign(name))/2.
    """
    if not isinstance(value, Expr):
        return (value, 0.0) if isinstance(value, float) else None
    if value.op in SIDES and (sign := _sign(value, name)):
        return SIDES[value.op][0], sign * SIDES[value.op][1]
    if not _jumps(value, name):
        return value, 0.0
    parts = [_split(arg, name) for arg in value.args]
    first, second = parts[0], parts[-1]
    if first is None or second is None:
        return None
    if value.op == "select" and (chosen := parts[1]) is not None:
        ahead, behind = (
            operate("select", *(_at(x, side) for x in (first, chosen, second)))
            for side in (1.0, -1.0)
        )
        mean, half = operate("add", ahead, behind), operate("sub", ahead, behind)
        return operate("mul", 0.5, mean), operate("mul", 0.5, half)
    if value.op in ("add", "sub"):
        rest, jump = (operate(value.op, x, y) for x, y in zip(first, second, strict=True))
        return rest, jump
    if value.op == "neg":
        return operate("neg", first[0]), operate("neg", first[1])
    if value.op == "mul":
        (a, b), (c, d) = first, second
        rest = operate("add", operate("mul", a, c), operate("mul", b, d))
        return rest, operate("add", operate("mul", a, d), operate("mul", b, c))
    if value.op == "div" and second[1] == 0.0:
        return operate("div", first[0], second[0]), operate("div", first[1], second[0])
    return None


def _sign(value: Expr, name: str) -> float:
    """1 where an operation reads the sign of a name, -1 where that of its opposite, else 0."""
    first, second = value.args if len(value.args) == 2 else (*value.args, 0.0)
    if second == 0.0:
        return float(str(first) == name)
    return -1.0 if first == 0.0 and str(second) == name else 0.0


def _jumps(value: Operand | str, name: str) -> bool:
    """Whether a tree has an operation that jumps where a name is 0."""
    if not isinstance(value, Expr) or value.op in ("symbol", "call"):
        return False
    is_side = value.op in SIDES and _sign(value, name) != 0.0
    return is_side or any(_jumps(arg, name) for arg in value.args)


def _at(split: tuple[Number, Number], sign: float) -> Number:
    """Value of a + b sign."""
    return operate("add", split[0], operate("mul", sign, split[1]))
