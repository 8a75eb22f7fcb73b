"""A unit string as powers of the SI base units, and numbers with a unit behind them.

    "N.m" = kg m2 s-2        "rad/s2" = rad s-2        "mN.m" = 0.001 kg m2 s-2

Products are written with `.` or `*`, quotients with `/`, powers as `m2`, `m^2` or `m**2`, brackets
behind `/`. A symbol with a prefix of SI is one symbol: mN is a millinewton, and m.N a metre newton.
As in FMI, the radian is a base unit, but it does not survive in derived units: N.m/rad is N.m.

Scenes are in SI units throughout: there is no arithmetic of units. A literal, "500 mm", becomes the
double next to its exact value in SI, 0.5, as it is read.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

_DEFINITIONS = """
    1, % = 0.01 1, m, s, min = 60 s, h = 3600 s, kg, g = 1e-3 kg, t = 1e3 kg
    rad, deg = pi/180 rad, rev = pi/0.5 rad
    rpm = pi/30 rad/s, Hz = 1 1/s, N = 1 kg.m/s2
    J = 1 kg.m2/s2, W = 1 kg.m2/s3, Pa = 1 kg/m/s2, A, K, mol, cd
    V = 1 W/A, C = 1 A.s, F = 1 C/V, H = 1 V.s/A, T = 1 V.s/m2, Wb = 1 V.s, Ohm = 1 V/A
    bar = 1e5 Pa, L = 1e-3 m3, in = 0.0254 m, ft = 0.3048 m, lb = 0.45359237 kg
    kgf = 9.80665 N, lbf = 4.4482216152605 N, psi = 1 lbf/in2
"""
"""Symbols, each a base unit or a multiple of others before it; all but pi are exact."""
_PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")
_PREFIXES = {
    "Y": 24, "Z": 21, "E": 18, "P": 15, "T": 12, "G": 9, "M": 6, "k": 3, "h": 2, "da": 1,
    "d": -1, "c": -2, "m": -3, "u": -6, "µ": -6, "μ": -6, "n": -9, "p": -12, "f": -15, "a": -18,
    "z": -21, "y": -24,
}  # fmt: skip
"""Powers of ten; of the micro sign and the Greek letter as of u."""
_PREFIXED = (
    *("m", "g", "s", "rad", "Hz", "N", "J", "W", "Pa", "A", "K", "mol", "cd"),
    *("V", "C", "F", "H", "T", "Wb", "Ohm", "bar", "L"),
)
"""Units that take a prefix: kg is one with it."""
_USUAL = ["mm", "cm", "km", "ms", "kN", "kJ", "kW", "kPa", "kHz", "GPa"]
"""Symbols that a word in small letters may be meant for, besides those without a prefix."""
_USUAL_PREFIXES = "kMGcm"
"""Those of symbols that stand without a sign behind others: mNm, kNm."""
_OFFSET = {"degc": True, "°c": True, "celsius": True, "degf": False, "°f": False}
"""Units with another zero than SI, in small letters, and whether a degree of them is a kelvin."""
_NAMES = {
    "N": "newton newtons", "m": "meter meters metre metres", "s": "sec second seconds",
    "kg": "kilogram kilograms", "rad": "radian radians", "deg": "degree degrees °",
    "J": "joule joules", "W": "watt watts", "Hz": "hertz", "Pa": "pascal pascals",
}  # fmt: skip
_SPELLED = {name: symbol for symbol, names in _NAMES.items() for name in names.split()}
_EXAMPLES = {
    "m": "500 mm", "rad": "30 deg", "rad/s": "3000 rpm", "s": "5 ms", "kg": "250 g", "N": "2 kN",
    "N.m": "2 kN.m", "N/m": "1.5 kN/m", "m/s": "36 km/h", "kg.m2": "3 kg.cm2",
}  # fmt: skip
"""How numbers with a unit are written, by units of SI."""
_LONGEST = 8
"""Letters of a word that may be several symbols without signs between them."""
_WIDEST = 100
"""Letters of a number with its unit; the pattern takes long for very many digits."""
_NUMBER_AND_UNIT = re.compile(
    r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*([^\W\d].*|°|%|1/.*)\s*"
)
_UNIT_IN_FORMULA = re.compile(r"\d\.?\s*([^\W\d]+)")
_BRACKETS = re.compile(r"(/?)\(([^()]*)\)")
_FACTOR = re.compile(r"(?P<symbol>[A-Za-zµμ%]+|1)(?P<power>-?\d)?")
_OPERATORS = re.compile(r"[./]")


@dataclass(frozen=True)
class BaseUnit:
    """Value in SI = factor * value; `powers` of kg, m, s, A, K, mol, cd, rad without zeros."""

    powers: dict[str, int] = field(default_factory=dict)
    factor: float = 1.0

    def fits(self, other: BaseUnit, *, radians: bool = True) -> bool:
        """Whether it measures the same quantity; without radians, rad/s and 1/s are one."""
        bases = {*self.powers, *other.powers} - ({"rad"} if not radians else set())
        return all(self.powers.get(base) == other.powers.get(base) for base in bases)


class Literal(NamedTuple):
    """A number with a unit behind it."""

    value: float
    """In SI; infinite where no double is as large."""
    unit: str
    """As FMI writes it."""


_SYMBOLS: dict[str, BaseUnit] = {}
_EXACT: dict[str, Fraction] = {}
"""Factors of the symbols."""


def base_unit(unit: str) -> BaseUnit | None:
    """Powers and factor of a unit string; None where a symbol of it is not known."""
    return (_read(unit) or (None,))[0]


@lru_cache(1024)
def _read(unit: str) -> tuple[BaseUnit, Fraction] | None:
    """Base units and exact factor of a unit string; None where a symbol of it is not known."""
    text = _without_brackets(spelled(unit))
    operators = [".", *_OPERATORS.findall(text)]
    powers: dict[str, int] = {}
    exact = Fraction(1)
    for operator, part in zip(operators, _OPERATORS.split(text), strict=True):
        match = _FACTOR.fullmatch(part)
        known = match and _SYMBOLS.get(match["symbol"])
        if not match or not known:
            return None
        power = int(match["power"] or 1) * (-1 if operator == "/" else 1)
        exact *= _EXACT[match["symbol"]] ** power
        for base, exponent in known.powers.items():
            powers[base] = powers.get(base, 0) + exponent * power
    factor = _double(exact)
    if not 0.0 < factor < math.inf:
        return None
    kept = {base: p for base, p in powers.items() if p and _keeps(base, powers)}
    return BaseUnit(kept, factor), exact


def _without_brackets(text: str) -> str:
    """Write N/(m.s) as N/m/s."""

    def plain(match: re.Match[str]) -> str:
        return f"/{match[2].translate(_TURNED)}" if match[1] else match[2]

    return _BRACKETS.sub(plain, text)


_TURNED = str.maketrans("./", "/.")


def _double(exact: Fraction) -> float:
    """Double next to an exact number."""
    try:
        return float(exact)
    except OverflowError:
        return math.inf if exact > 0 else -math.inf


def literal(text: str) -> Literal | None:
    """Read a number with a unit behind it; None for another text."""
    number, unit = parted(text)
    known = _read(unit) if unit else None
    return Literal(_double(Fraction(number) * known[1]), unit) if known else None


def parted(text: str) -> tuple[str, str]:
    """Part a number and the unit behind it, as FMI writes it; no unit for another text."""
    match = _NUMBER_AND_UNIT.fullmatch(text) if len(text) <= _WIDEST else None
    known = match and base_unit(match[2].strip())
    return (match[1], spelled(match[2])) if match and known else (text, "")


def misfit(unit: str, wanted: str) -> str | None:
    """What is wrong with a literal in a unit where another one is wanted; None if it fits.

    `wanted` may name several, as "rad or m"; a unit that is none fits nothing.
    """
    given = base_unit(unit)
    possible = [base_unit(each or "1") for each in wanted.split(" or ")]
    if given and any(each and given.fits(each) for each in possible):
        return None
    if not wanted or wanted == "1":
        return "and must be a number without a unit"
    if None in possible:
        return f"and must be a plain number in {wanted}: no factor converts that unit"
    return f"and must be in {wanted}"


def si_unit(unit: str) -> str:
    """Unit of SI of the same quantity: m of mm, rad/s of rpm."""
    base = base_unit(unit)
    return _si_name(unit, base) if base else unit


def remedy(wanted: str) -> str | None:
    """Say how a number in this unit is written, or one of those that `wanted` names."""
    first = wanted.split(" or ")[0]
    if first in ("", "1"):
        return "leave the unit out"
    return (
        f'write for instance "{_EXAMPLES.get(first, f"2 {first}")}"' if base_unit(first) else None
    )


def spelled(unit: str) -> str:
    """Write a unit that is known as FMI does: products with a point, powers behind the symbol."""
    text = re.sub(r"\s+", ".", unit.strip()).replace("²", "2").replace("³", "3")
    return re.sub(r"(?:\^|\*\*)(-?\d)", r"\1", text).replace("*", ".")


def _define(symbol: str, definition: str) -> None:
    value, _, unit = definition.partition(" ")
    above, _, below = value.partition("/")
    factor = (_PI if above == "pi" else Fraction(above or 1)) / Fraction(below or 1)
    known = _read(unit) if unit else (BaseUnit({} if symbol == "1" else {symbol: 1}), Fraction(1))
    assert known is not None
    _EXACT[symbol] = factor * known[1]
    _SYMBOLS[symbol] = BaseUnit(known[0].powers, float(_EXACT[symbol]))


def _keeps(base: str, powers: dict[str, int]) -> bool:
    """Whether a base unit stays: the radian of N.m/rad or J/rad is dropped, that of rad/s not."""
    return base != "rad" or not powers.get("kg")


def not_of_si(unit: str) -> tuple[str, str]:
    """What is wrong with a unit of a scene, and the remedy; empty for one of SI or none."""
    unit = unit or "1"
    if offset := offset_of(unit):
        return offset
    base = base_unit(unit)
    meant = spelled(unit) if base else respelled(unit)
    if not meant:
        known = ", ".join(symbol for symbol in _ALONE if _EXACT[symbol] == 1)
        help = f"write products, quotients and powers of {known}, or leave it out"
        return f"there is no unit {unit!r}", help
    found = base or base_unit(meant) or BaseUnit()
    if found.factor != 1.0:
        message = f"must be an SI unit, as all numbers of a scene are in SI, got {unit!r}"
        name = _si_name(meant, found)
        return message, f"give the value in {name}: 1 {meant} is {found.factor:g} {name}"
    return ("", "") if base else (f"there is no unit {unit!r}", f"did you mean '{meant}'?")


def offset_of(unit: str) -> tuple[str, str] | None:
    """What is wrong with a unit that counts from another zero, and the remedy."""
    words = re.split(r"[\s.*/]+", re.sub(r"(deg|°)\s+(?=[CF]\b)", r"\1", unit.strip()))
    found = next((word for word in words if word.lower() in _OFFSET), "")
    if not found:
        return None
    celsius = _OFFSET[found.lower()]
    formula, step = ("value + 273.15", "1") if celsius else ("(value + 459.67)*5/9", "5/9")
    message = f"{found!r} counts from another zero than SI, so that no factor converts it"
    return message, f"give a temperature in K, {formula}; a difference of 1 {found} is {step} K"


def unit_help(text: str) -> str | None:
    """Say how a number with a unit behind it is written; None for another text."""
    match = _NUMBER_AND_UNIT.fullmatch(text) if len(text) <= _WIDEST else None
    unit = match[2].strip() if match else ""
    if offset := offset_of(unit):
        return "; ".join(offset)
    meant = unit if base_unit(unit) else respelled(unit)
    if match and meant:
        return f'write "{match[1]} {spelled(meant)}"'
    within = _UNIT_IN_FORMULA.search(text)
    return symbol_help(within[1]) if within and base_unit(within[1]) else None


def symbol_help(name: str) -> str | None:
    """Say how a unit within a formula is written; None for another word."""
    if offset := offset_of(name):
        return "; ".join(offset)
    meant = name if base_unit(name) else respelled(name)
    base = base_unit(meant)
    if not base:
        return None
    alone = f'a unit stands behind a single number alone, as in "2 {spelled(meant)}"'
    return f"{alone}; for {spelled(meant)} in a formula write {base.factor:.12g}"


def respelled(unit: str) -> str:
    """Write a unit with the symbols of SI that it was perhaps meant to have; empty if unclear."""
    folded = {symbol.lower(): symbol for symbol in (*_ALONE, *_USUAL)} | _SPELLED

    def respelled(match: re.Match[str]) -> str:
        word = match[0]
        known = word if word in _SYMBOLS else folded.get(word.lower())
        products = [] if known or len(word) > _LONGEST else _products(word)
        return known or ".".join(min(products, key=_likelihood, default=[word]))

    text = re.sub(r"[°A-Za-zµμ]+", respelled, re.sub(r"\s*[·⋅×\s-]\s*", ".", unit.strip()))
    return text if base_unit(text) else ""


def _products(word: str) -> list[list[str]]:
    """Ways of reading a word as several symbols: Nms as N.m.s or N.ms."""
    if not word:
        return [[]]
    first = [symbol for symbol in (*_ALONE, *_OF_WORDS) if word.startswith(symbol)]
    return [[symbol, *rest] for symbol in first for rest in _products(word[len(symbol) :])]


def _likelihood(symbols: list[str]) -> tuple[bool, int]:
    """Key of a product that is more likely the smaller it is: each symbol once, those of SI."""
    return len({*symbols}) < len(symbols), sum(_SYMBOLS[s].factor != 1.0 for s in symbols)


def _si_name(unit: str, base: BaseUnit) -> str:
    """Write a unit with symbols of SI."""
    si = {str(_SYMBOLS[symbol].powers): symbol for symbol in _ALONE if _EXACT[symbol] == 1}

    def same(match: re.Match[str]) -> str:
        known = _SYMBOLS.get(match[0])
        return si.get(str(known.powers), match[0]) if known else match[0]

    name = re.sub(r"[A-Za-zµμ%]+", same, unit)
    if base_unit(name) == BaseUnit(base.powers):
        return name
    above = [f"{name}{p if p > 1 else ''}" for name, p in base.powers.items() if p > 0]
    below = [f"/{name}{-p if p < -1 else ''}" for name, p in base.powers.items() if p < 0]
    return (".".join(above) or "1") + "".join(below)


for _entry in _DEFINITIONS.strip().replace("\n", ",").split(","):
    _define(*_entry.strip().partition(" = ")[::2])
_ALONE = [*_SYMBOLS]
"""Symbols without a prefix, and kg."""
_OF_WORDS = [f"{prefix}{unit}" for prefix in _USUAL_PREFIXES for unit in _PREFIXED]
for _unit in _PREFIXED:
    for _prefix, _ten in _PREFIXES.items():
        if f"{_prefix}{_unit}" not in _SYMBOLS:  # kg is one already
            _define(f"{_prefix}{_unit}", f"1e{_ten} {_unit}")
