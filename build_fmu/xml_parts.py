"""What XML of a model description and a parameter set shares: base units, types, documents."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

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
_CONTROL = bytes({*range(0x20)} - {*b"\t\n\r"})
"""Characters of ASCII that XML does not have."""
_RESERVED = re.compile('[&<>"\r\n\t]')
_ESCAPED = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"}
_ESCAPED |= {character: f"&#{ord(character):02};" for character in "\r\n\t"}
_ESCAPED_TEXT = {character: _ESCAPED[character] for character in "&<>"}


class Element(NamedTuple):
    """An element of a document: a tenth of the work that `xml.etree` takes for large models.

    Attributes
    ----------
    tag : str
        Its name.
    attributes : str
        Attributes as they are written, each behind a space.
    children : sequence of Element
        What it holds.
    text : str
        Its text, where it has no children.
    """

    tag: str
    attributes: str = ""
    children: Sequence[Element] = ()
    text: str = ""


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
    lines = ["<?xml version='1.0' encoding='UTF-8'?>"]
    _write(root, "", lines)
    text = "\n".join([*lines, ""])
    if text.isascii():
        data = text.encode()
        if len(data.translate(None, _CONTROL)) == len(data):
            return data
    return _ILLEGIBLE.sub("\N{REPLACEMENT CHARACTER}", text).encode()


def _write(element: Element, margin: str, lines: list[str]) -> None:
    """Append the lines of an element."""
    tag, attributes, children, text = element
    if children:
        lines.append(f"{margin}<{tag}{attributes}>")
        for child in children:
            _write(child, margin + "  ", lines)
        lines.append(f"{margin}</{tag}>")
    elif text:
        lines.append(f"{margin}<{tag}{attributes}>{_escaped(text, _ESCAPED_TEXT)}</{tag}>")
    else:
        lines.append(f"{margin}<{tag}{attributes} />")


def element(tag: str, /, *children: Element, **attributes: object) -> Element:
    """Element with children, and with the attributes that are not None."""
    return Element(tag, written(attributes), children)


def written(attributes: Mapping[str, object]) -> str:
    """Text of the attributes that are not None, each behind a space."""
    given = attributes.items()
    return "".join([f' {name}="{_text(x)}"' for name, x in given if x is not None])


def _text(value: object) -> str:
    if isinstance(value, str):
        return _escaped(value, _ESCAPED) if _RESERVED.search(value) else value
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(float(value))  # type: ignore[arg-type]


def _escaped(text: str, escaped: Mapping[str, str]) -> str:
    return text.translate(str.maketrans(dict(escaped)))
