"""A unit string as powers of the SI base units.

    "N.m" = kg m2 s-2        "rad/s2" = rad s-2        "mN.m" = 0.001 kg m2 s-2

Products are written with `.` or `*`, quotients with `/`, powers as `m2`, `m^2` or `m**2`. A symbol
with a prefix of SI is one symbol: mN is a millinewton, and m.N a metre newton. As in FMI, the
radian is a base unit, but it does not survive in derived units: N.m/rad is N.m.

Scenes are in SI units throughout: there is no arithmetic of units, and a number that is said to be
in mm would act as one in m. Files of parameter values may be in any of these, and are converted.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from decimal import Decimal

_DEFINITIONS = """
    1, % = 0.01 1, m, s, min = 60 s, h = 3600 s, kg, g = 1e-3 kg, t = 1e3 kg
    rad, deg = 0.017453292519943295 rad, rev = 6.283185307179586 rad
    rpm = 0.10471975511965977 rad/s, Hz = 1 1/s, N = 1 kg.m/s2
    J = 1 kg.m2/s2, W = 1 kg.m2/s3, Pa = 1 kg/m/s2, A, K, mol, cd
    V = 1 W/A, C = 1 A.s, F = 1 C/V, H = 1 V.s/A, T = 1 V.s/m2, Wb = 1 V.s, Ohm = 1 V/A
"""
"""Symbols, each a base unit or a multiple of others before it."""
_PREFIXES = {
    "Y": 24, "Z": 21, "E": 18, "P": 15, "T": 12, "G": 9, "M": 6, "k": 3, "h": 2, "da": 1,
    "d": -1, "c": -2, "m": -3, "u": -6, "µ": -6, "μ": -6, "n": -9, "p": -12, "f": -15, "a": -18,
    "z": -21, "y": -24,
}  # fmt: skip
"""Powers of ten; of the micro sign and the Greek letter as of u."""
_PREFIXED = (
    *("m", "g", "s", "rad", "Hz", "N", "J", "W", "Pa", "A", "K", "mol", "cd"),
    *("V", "C", "F", "H", "T", "Wb", "Ohm"),
)
"""Units of SI that take a prefix: kg is one with it."""
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
_LONGEST = 8
"""Letters of a word that may be several symbols without signs between them."""
_WIDEST = 100
"""Letters of a number with its unit; the pattern takes long for very many digits."""
_NUMBER_AND_UNIT = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([^\W\d].*|°)\s*")
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


_SYMBOLS: dict[str, BaseUnit] = {}
_STEMS: dict[str, tuple[str, int]] = {}
"""Symbols without their prefix, and its power of ten."""


def base_unit(unit: str) -> BaseUnit | None:
    """Powers and factor of a unit string; None where a symbol of it is not known."""
    text = spelled(unit)
    operators = [".", *_OPERATORS.findall(text)]
    powers: dict[str, int] = {}
    factor, tens = 1.0, 0
    for operator, part in zip(operators, _OPERATORS.split(text), strict=True):
        match = _FACTOR.fullmatch(part)
        known = match and _SYMBOLS.get(match["symbol"])
        if not match or not known:
            return None
        power = int(match["power"] or 1) * (-1 if operator == "/" else 1)
        stem, ten = _STEMS.get(match["symbol"], (match["symbol"], 0))
        factor *= _SYMBOLS[stem].factor ** power
        tens += ten * power
        for base, exponent in known.powers.items():
            powers[base] = powers.get(base, 0) + exponent * power
    factor = float(Decimal(factor).scaleb(tens)) if tens else factor  # 1/mm3 is 1e9 1/m3
    if not 0.0 < factor < math.inf:
        return None
    return BaseUnit({base: p for base, p in powers.items() if p and _keeps(base, powers)}, factor)


def spelled(unit: str) -> str:
    """Write a unit that is known as FMI does: products with a point, powers behind the symbol."""
    text = re.sub(r"\s+", ".", unit.strip()).replace("²", "2").replace("³", "3")
    return re.sub(r"(?:\^|\*\*)(-?\d)", r"\1", text).replace("*", ".")


def _define(symbol: str, definition: str) -> None:
    value, _, unit = definition.partition(" ")
    known = base_unit(unit) if unit else BaseUnit({} if symbol == "1" else {symbol: 1})
    assert known is not None
    _SYMBOLS[symbol] = BaseUnit(known.powers, float(value or 1.0) * known.factor)


def _keeps(base: str, powers: dict[str, int]) -> bool:
    """Whether a base unit stays: the radian of N.m/rad or J/rad is dropped, that of rad/s not."""
    return base != "rad" or not powers.get("kg")


def not_of_si(unit: str) -> tuple[str, str]:
    """What is wrong with a unit of a scene, and the remedy; empty for one of SI or none."""
    unit = unit or "1"
    if offset := offset_of(unit):
        return offset
    base = base_unit(unit)
    meant = spelled(unit) if base else _respelled(unit)
    if not meant:
        known = ", ".join(symbol for symbol, known in _SYMBOLS.items() if known.factor == 1.0)
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


def in_si(text: str) -> str | None:
    """Say how a number with a unit behind it is written in a scene; None for another text."""
    match = _NUMBER_AND_UNIT.fullmatch(text) if len(text) <= _WIDEST else None
    unit = match[2].strip() if match else ""
    if offset := offset_of(unit):
        return "; ".join(offset)
    base = base_unit(unit) or base_unit(_respelled(unit))
    if not match or not base or not math.isfinite(float(match[1]) * base.factor):
        return None
    value, name = float(match[1]) * base.factor, _si_name(unit, base)
    return f"a unit is not written behind a number; all are in SI, here {name}: write {value:.12g}"


def _respelled(unit: str) -> str:
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
    si = {str(x.powers): symbol for symbol, x in _SYMBOLS.items() if x.factor == 1.0}

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
            _STEMS[f"{_prefix}{_unit}"] = _unit, _ten
            _define(f"{_prefix}{_unit}", f"1e{_ten} {_unit}")
