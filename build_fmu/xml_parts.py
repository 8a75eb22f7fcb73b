"""What XML of a model description and a parameter set shares: base units, types, documents."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, indent, tostring

from solver.scene.units import BaseUnit

if TYPE_CHECKING:
    from solver.runtime import Variable

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
_ILLEGIBLE = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def base_unit_attributes(base: BaseUnit) -> dict[str, str]:
    """Attributes of an XML element BaseUnit, of FMI and of SSP."""
    powers = {name: str(power) for name, power in base.powers.items()}
    return powers if base.factor == 1.0 else {**powers, "factor": repr(base.factor)}


def declared_types(variables: Iterable[Variable]) -> dict[str, str]:
    """Name of the declared type by unit, of all units that variables have.

    A type must not have the name of a variable: names of a scene have no dot, and the last word of
    a quantity begins with a small letter.
    """
    units = sorted({variable.unit for variable in variables if variable.unit})
    return {
        unit: f"SI.{QUANTITIES[unit]}" if unit in QUANTITIES else f"In.{unit}" for unit in units
    }


def document(root: Element) -> bytes:
    """Text of a document, indented, without the characters that XML does not have."""
    indent(root)
    text = _ILLEGIBLE.sub("\N{REPLACEMENT CHARACTER}", tostring(root, "unicode"))
    return f"<?xml version='1.0' encoding='UTF-8'?>\n{text}\n".encode()


def element(tag: str, /, *children: Element, **attributes: object) -> Element:
    """Element with children, and with the attributes that are not None."""
    given = {name: _text(x) for name, x in attributes.items() if x is not None}
    element = Element(tag, given)
    element.extend(children)
    return element


def _text(value: object) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(float(value))  # type: ignore[arg-type]
