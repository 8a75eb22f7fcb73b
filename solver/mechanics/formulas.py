"""Formulas of a scene: an expression becomes a function of quantities, rates and signals.

    phi(sigma_1, ..., b_1(t), ...),      b a part that depends on time, inputs or tunable parameters

Parts without any quantity are evaluated apart: in rows, which hold at the end of a step, they are
signals; in potentials and velocity rows, which act in its middle, numbers of the laws.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from solver.mechanics.mechanism import Formula, Leaf, Mechanism, Scale
from solver.mechanics.parts import Meaning, Parts
from solver.runtime.layout import LEAF_RATE, LEAF_SIGNAL, LEAF_VALUE
from solver.scene import Expr, ExpressionError, Number, evaluate, symbols
from solver.scene.expression import Operand, operate, symbol

SWITCHES = frozenset(
    {"sign", "floor", "ceil", "mod", "lt", "le", "gt", "ge", "eq", "ne", "and", "or", "not"}
)
"""Operations that jump: no slope over a step is exact where they do."""


def leaf_symbol(k: int) -> Expr:
    """Return the symbol that stands for leaf k of a formula; no name of a scene looks like it."""
    return symbol(f"#{k}")


def rewritten(number: Number, replace: Callable[[Expr], Number | None]) -> Number:
    """Return a number in which `replace` stands for what it does not return None for."""
    known: dict[Expr, Number] = {}

    def walk(part: Operand | str) -> Any:
        if not isinstance(part, Expr):
            return part
        if part not in known:
            new = replace(part)
            if new is None:
                new = operate(part.op, *(walk(arg) for arg in part.args))
            known[part] = new
        return known[part]

    return walk(number)


def with_symbols(number: Number, meanings: Mapping[Expr, Number]) -> Number:
    """Return a number with these meanings in the place of some symbols."""
    return rewritten(number, lambda x: meanings.get(x, x) if x.op == "symbol" else None)


def refuse_switches(value: Number) -> None:
    """Raise `ExpressionError` if what a formula decides, or the sign it takes, moves."""

    def refuse(part: Expr) -> Expr | None:
        deciding = (
            part.args[:1] if part.op == "select" else part.args if part.op in SWITCHES else ()
        )
        if any(
            name.startswith("#") for x in deciding if isinstance(x, Expr) for name in symbols(x)
        ):
            message = "it would jump where a condition, sign, floor, ceil or mod of what moves "
            message += "switches; write it with abs, min or max, which are exact"
            raise ExpressionError(message)
        return part if part.op == "symbol" else None

    rewritten(value, refuse)


def formula(
    parts: Parts, number: Number, *, signals: bool, own: Mapping[str, Meaning] | None = None,
    along: int | None = None,
) -> Formula:  # fmt: skip
    """Return the formula of an expression; its quantities take part in the motion.

    Parameters
    ----------
    parts : Parts
    number : Number
    signals : bool
        Whether parts that change with the time alone become signals.
    own : mapping, optional
        Symbols with a meaning of their own, such as ``length``.
    along : int, optional
        Quantity along which it is a force; then its value is the first leaf.

    Raises
    ------
    ExpressionError
        When it contains what cannot be part of a formula, or nothing that moves.
    """
    mechanism, own = parts.mechanism, own or {}
    known = mechanism.varying | parts.scene.parameters.keys()
    leaves = {} if along is None else {mechanism.leaf(along): 0}

    def leaf(found: Meaning) -> Number:
        if not isinstance(found, Leaf):
            return found
        if found.kind != LEAF_SIGNAL:
            mechanism.use(found.index)
        return leaf_symbol(leaves.setdefault(found, len(leaves)))

    def replace(part: Expr) -> Number | None:
        if part.op in ("symbol", "call"):
            found = _meaning(parts, part, own)
            if found is not None:
                return leaf(found)
        elif any(name in own or name not in known for name in symbols(part)):
            return None
        if signals and symbols(part) & mechanism.varying:
            return leaf(Leaf(LEAF_SIGNAL, mechanism.signal(part)))
        return part

    value = rewritten(number, replace)
    if not any(leaf.kind != LEAF_SIGNAL for leaf in leaves):
        message = "it does not depend on the motion"
        raise ExpressionError(message)
    if along is not None or not any(leaf.kind == LEAF_RATE for leaf in leaves):
        refuse_switches(value)  # but in velocity rows, which do no work
    return Formula(value, tuple(leaves))


def sensor(leaf: Leaf) -> Expr:
    """Return the symbol of a quantity, ``#value 3``, or of its rate, as a sensor tells it."""
    return symbol(f"#{'value' if leaf.kind == LEAF_VALUE else 'rate'} {leaf.index}")


def sensed(
    parts: Parts, number: Number, own: Mapping[str, Meaning] | None = None, *, by_laws: bool = True
) -> Number:
    """Return an expression whose quantities are read from the sensors.

    Those that laws read are followed all along, others where a switch is looked at; `own` is as in
    `formula`.
    """

    def replace(part: Expr) -> Number | None:
        if part.op not in ("symbol", "call"):
            return None
        found = _meaning(parts, part, own or {})
        if not isinstance(found, Leaf):
            return part if found is None else found
        parts.mechanism.use(found.index)
        if by_laws:
            parts.mechanism.sensing = True
            parts.mechanism.sensed[str(sensor(found))] = str(part)
        return sensor(found)

    return rewritten(number, replace)


def _meaning(parts: Parts, part: Expr, own: Mapping[str, Meaning]) -> Meaning | None:
    """What a symbol or a call stands for; None for parameters, inputs and the time."""
    if part.op == "call":
        return parts.distance(part)
    name = str(part)
    if name in own:
        return own[name]
    known = name in parts.mechanism.varying or name in parts.scene.parameters
    return None if known else parts.meaning(name)


# --------------------------------------------------------------------------------- judgement


def scale_of(mechanism: Mechanism, formula: Formula) -> Scale:
    """Return the size of a formula: its largest slope times the size of what it belongs to."""
    point = [_drawn(mechanism, leaf) for leaf in formula.leaves]
    best, largest = Scale(1.0, 0), 0.0
    for k, leaf in enumerate(formula.leaves):
        # The unit of a signal is unknown and taken for none.
        power = 0 if leaf.kind == LEAF_SIGNAL else mechanism.length_power(leaf.index)
        size = mechanism.extent**power
        d = 1e-6 * size
        try:
            first, second = (
                _value(mechanism, formula, [x + sign * d * (i == k) for i, x in enumerate(point)])
                for sign in (-1.0, 1.0)
            )
        except ExpressionError:
            continue
        slope = abs((second - first) / (2.0 * d))
        if slope * size > largest:
            largest, best = slope * size, Scale(slope, power)
    return best


def _value(mechanism: Mechanism, formula: Formula, leaves: Sequence[float]) -> float:
    """Value of a formula with default parameters for given values of its leaves."""
    known = {str(leaf_symbol(k)): x for k, x in enumerate(leaves)}
    return evaluate(formula.value, {**mechanism.defaults, **known})


def _drawn(mechanism: Mechanism, leaf: Leaf) -> float:
    if leaf.kind == LEAF_SIGNAL:
        return mechanism.default(mechanism.signals[leaf.index])
    return 0.0 if leaf.kind == LEAF_RATE else mechanism.default(mechanism.drawn_value(leaf.index))
