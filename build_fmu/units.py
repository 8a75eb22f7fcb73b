"""A unit string as powers of the SI base units, for UnitDefinitions of a model description.

    "N.m" = kg m2 s-2        "rad/s2" = rad s-2        "mm" = 0.001 m

Products are written with `.` or `*`, quotients with `/`, powers as `m2`, `m^2` or `m**2`. As in
FMI, the radian is a base unit, but it does not survive in derived units: N.m/rad is N.m.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from solver.runtime import Variable

_NEWTON = {"kg": 1, "m": 1, "s": -2}
_JOULE = {"kg": 1, "m": 2, "s": -2}
_WATT = {"kg": 1, "m": 2, "s": -3}
_PASCAL = {"kg": 1, "m": -1, "s": -2}

_SYMBOLS: dict[str, tuple[dict[str, int], float]] = {
    "1": ({}, 1.0),
    "%": ({}, 0.01),
    "m": ({"m": 1}, 1.0),
    "mm": ({"m": 1}, 1e-3),
    "cm": ({"m": 1}, 1e-2),
    "km": ({"m": 1}, 1e3),
    "s": ({"s": 1}, 1.0),
    "ms": ({"s": 1}, 1e-3),
    "min": ({"s": 1}, 60.0),
    "h": ({"s": 1}, 3600.0),
    "kg": ({"kg": 1}, 1.0),
    "g": ({"kg": 1}, 1e-3),
    "t": ({"kg": 1}, 1e3),
    "rad": ({"rad": 1}, 1.0),
    "deg": ({"rad": 1}, 0.017453292519943295),
    "rev": ({"rad": 1}, 6.283185307179586),
    "rpm": ({"rad": 1, "s": -1}, 0.10471975511965977),
    "Hz": ({"s": -1}, 1.0),
    "N": (_NEWTON, 1.0),
    "kN": (_NEWTON, 1e3),
    "MN": (_NEWTON, 1e6),
    "J": (_JOULE, 1.0),
    "kJ": (_JOULE, 1e3),
    "W": (_WATT, 1.0),
    "kW": (_WATT, 1e3),
    "MW": (_WATT, 1e6),
    "Pa": (_PASCAL, 1.0),
    "MPa": (_PASCAL, 1e6),
    "GPa": (_PASCAL, 1e9),
    "A": ({"A": 1}, 1.0),
    "K": ({"K": 1}, 1.0),
    "mol": ({"mol": 1}, 1.0),
    "cd": ({"cd": 1}, 1.0),
    "V": ({"kg": 1, "m": 2, "s": -3, "A": -1}, 1.0),
}
QUANTITIES = {
    "1": "Ratio",
    "m": "Length",
    "m/s": "Velocity",
    "m/s2": "Acceleration",
    "rad": "Angle",
    "rad/s": "AngularVelocity",
    "1/s": "Rate",
    "s": "Time",
    "kg": "Mass",
    "kg/m": "LinearDensity",
    "kg/m3": "Density",
    "kg.m2": "MomentOfInertia",
    "N": "Force",
    "N.m": "Torque",
    "J": "Energy",
    "W": "Power",
    "kg.m/s": "Momentum",
    "kg.m2/s": "AngularMomentum",
    "N/m": "TranslationalStiffness",
    "N.m/rad": "RotationalStiffness",
    "N.s/m": "TranslationalDamping",
    "N.m.s/rad": "RotationalDamping",
}
"""What is measured in a unit, as the names of declared types say it."""
_FACTOR = re.compile(r"(?P<symbol>[A-Za-z%]+|1)(?:(?:\^|\*\*)?(?P<power>-?\d+))?")
_OPERATORS = re.compile(r"(?<!\*)\*(?!\*)|[./]")


@dataclass(frozen=True)
class BaseUnit:
    """Value in SI = factor * value; `powers` of kg, m, s, A, K, mol, cd, rad without zeros."""

    powers: dict[str, int] = field(default_factory=dict)
    factor: float = 1.0

    def fits(self, other: BaseUnit, *, radians: bool = True) -> bool:
        """Whether it measures the same quantity; without radians, rad/s and 1/s are one."""
        bases = {*self.powers, *other.powers} - ({"rad"} if not radians else set())
        return all(self.powers.get(base) == other.powers.get(base) for base in bases)

    def attributes(self) -> dict[str, str]:
        """Attributes of an XML element BaseUnit, of FMI and of SSP."""
        powers = {name: str(power) for name, power in self.powers.items()}
        return powers if self.factor == 1.0 else {**powers, "factor": repr(self.factor)}


def base_unit(unit: str) -> BaseUnit | None:
    """Powers and factor of a unit string; None where a symbol of it is not known."""
    text = re.sub(r"\s+", ".", unit.strip()).replace("²", "2").replace("³", "3")
    operators = [".", *_OPERATORS.findall(text)]
    powers: dict[str, int] = {}
    factor = 1.0
    for operator, part in zip(operators, _OPERATORS.split(text), strict=True):
        match = _FACTOR.fullmatch(part)
        known = match and _SYMBOLS.get(match["symbol"])
        if not match or not known:
            return None
        power = int(match["power"] or 1) * (-1 if operator == "/" else 1)
        factor *= known[1] ** power
        for base, exponent in known[0].items():
            powers[base] = powers.get(base, 0) + exponent * power
    return BaseUnit({base: p for base, p in powers.items() if p and _keeps(base, powers)}, factor)


def declared_types(variables: Iterable[Variable]) -> dict[str, str]:
    """Name of the declared type by unit, of all units that variables have.

    A type must not be called as a variable: names of a scene have no dot, and what is measured of a
    part ends in a small letter's word.
    """
    units = sorted({variable.unit for variable in variables if variable.unit})
    return {
        unit: f"SI.{QUANTITIES[unit]}" if unit in QUANTITIES else f"In.{unit}" for unit in units
    }


def _keeps(base: str, powers: dict[str, int]) -> bool:
    """Whether a base unit stays: the radian of N.m/rad or J/rad is dropped, that of rad/s not."""
    return base != "rad" or not powers.get("kg")
