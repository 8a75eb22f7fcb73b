"""Parameter sets of the SSP standard, System Structure Parameter Values 1.0 (.ssv files).

One is written beside every FMU, with all its parameters, their values and units; what was changed
in a copy of it can be given back to every command by `--parameters`.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement
from xml.parsers import expat

from build_fmu.study.values import Entry, Mistake, keep
from build_fmu.xml_parts import base_unit_attributes, legible
from solver.scene.units import BaseUnit, base_unit

if TYPE_CHECKING:
    from solver.runtime import Model, Variable

VALUES = "http://ssp-standard.org/SSP1/SystemStructureParameterValues"
COMMON = "http://ssp-standard.org/SSP1/SystemStructureCommon"
_BOOLEAN = {"true": True, "1": True, "false": False, "0": False}
_READERS = {
    "Real": (float, "a number"),
    "Integer": (int, "a whole number"),
    "Boolean": (_BOOLEAN.__getitem__, "true or false"),
    "String": (str, "a text"),
    "Enumeration": (str, "a text"),
}


def parameter_set(model: Model, *, date: str, tool: str) -> bytes:
    """Text of the .ssv file of a model: all its parameters with their start values."""
    ElementTree.register_namespace("ssv", VALUES)
    ElementTree.register_namespace("ssc", COMMON)
    head = {"version": "1.0", "name": model.name, "generationTool": tool}
    root = Element(f"{{{VALUES}}}ParameterSet", head | {"generationDateAndTime": date})
    parameters = [v for v in model.variables if v.causality == "parameter"]
    listed = SubElement(root, f"{{{VALUES}}}Parameters")
    for variable in parameters:
        attributes = {"name": variable.name, "description": variable.description}
        given = {name: legible(text) for name, text in attributes.items() if text}
        parameter = SubElement(listed, f"{{{VALUES}}}Parameter", given)
        SubElement(parameter, f"{{{VALUES}}}{variable.type}", _value(variable))
    _units(root, parameters)
    ElementTree.indent(root)
    return ElementTree.tostring(root, "UTF-8", xml_declaration=True) + b"\n"


def _value(variable: Variable) -> dict[str, str]:
    start = variable.start
    if isinstance(start, bool):
        return {"value": str(start).lower()}
    if isinstance(start, str):
        return {"value": start}
    attributes = {"value": repr(float(start or 0.0))}
    # A unit must be one of those that the file defines, by powers of base units.
    if variable.unit and base_unit(variable.unit):
        attributes["unit"] = variable.unit
    return attributes


def _units(root: Element, parameters: Iterable[Variable]) -> None:
    bases = {v.unit: base_unit(v.unit) for v in parameters if v.unit}
    known = sorted((unit, base) for unit, base in bases.items() if base)
    units = SubElement(root, f"{{{VALUES}}}Units") if known else root
    for name, base in known:
        unit = SubElement(units, f"{{{COMMON}}}Unit", {"name": name})
        SubElement(unit, f"{{{COMMON}}}BaseUnit", base_unit_attributes(base))


def read_parameter_set(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    """Values of a .ssv file by name."""
    reader = _Reader(path, mistakes)
    try:
        reader.parser.Parse(path.read_bytes(), True)
    except expat.ExpatError as error:
        where = f"{path}:{error.lineno}:{error.offset + 1}"
        mistakes.append(Mistake(where, f"not XML: {expat.ErrorString(error.code)}"))
    except (LookupError, ValueError) as error:  # an encoding that Python or expat does not know
        mistakes.append(Mistake(f"{path}:1", f"not XML: {error}", "save the file as UTF-8"))
    return reader.in_stated_units()


class _Reader:
    """Reads the elements as they come: the parser alone knows their lines."""

    def __init__(self, path: Path, mistakes: list[Mistake]) -> None:
        self._found: dict[str, Entry] = {}
        self._units: dict[str, tuple[BaseUnit, float]] = {}  # and their offsets
        self._unit = ""
        self._unit_lines: dict[str, int] = {}
        self._path, self._mistakes = path, mistakes
        self._depth = 0
        self._name, self._line = "", 0  # of the Parameter that is open, and of its value
        self.parser = expat.ParserCreate(namespace_separator=" ")
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        namespace, _, kind = tag.rpartition(" ")
        self._depth += 1
        if self._depth == 1 and (namespace, kind) != (VALUES, "ParameterSet"):
            help = f"the root must be ParameterSet of the namespace {VALUES}"
            self._object(f"not a parameter set of SSP 1.0, but {kind!r}", help)
        if namespace == COMMON and kind == "Unit":
            self._begin_unit(attributes.get("name", ""))
        elif namespace == COMMON and kind == "BaseUnit":
            self._define(attributes)
        elif namespace != VALUES:
            return
        elif kind == "Parameter":
            self._name, self._line = attributes.get("name", ""), 0
            if not self._name:
                self._object("a Parameter without a name")
        elif self._name and kind in _READERS:
            if self._line:
                help = f"the first is in line {self._line}"
                self._object(f"{self._name}: has two values", help)
            else:
                self._take(kind, attributes)
            self._line = self._line or self.parser.CurrentLineNumber

    def _take(self, kind: str, attributes: dict[str, str]) -> None:
        read, words = _READERS[kind]
        text = attributes.get("value", "")
        try:
            value = read(text)
        except (ValueError, KeyError):
            self._object(f"{self._name}: must be {words}, got {text!r}")
            return
        entry = Entry(value, self._where(), attributes.get("unit", ""), repeats=True)
        keep(self._found, self._name, entry, self._mistakes)

    def _begin_unit(self, name: str) -> None:
        self._unit, line = name, self.parser.CurrentLineNumber
        first = self._unit_lines.setdefault(name, line)
        if first != line:
            self._object(f"unit {name!r}: defined twice, first in line {first}")

    def _define(self, attributes: dict[str, str]) -> None:
        """Take what the file says of a unit: value in SI = factor * value + offset."""
        numbers = {"factor": 1.0, "offset": 0.0}
        powers: dict[str, int] = {}
        for name, text in attributes.items():
            try:
                if name in numbers:
                    numbers[name] = float(text)
                    if name == "factor" and not 0.0 < numbers[name] <= sys.float_info.max:
                        message = f"unit {self._unit!r}: factor must be a finite number > 0"
                        self._object(f"{message}, got {text!r}")
                elif int(text):
                    powers[name] = int(text)
            except ValueError:
                self._object(f"unit {self._unit!r}: {name} must be a number, got {text!r}")
        base = BaseUnit(powers, numbers["factor"])
        self._units[self._unit] = base, numbers["offset"]

    def in_stated_units(self) -> dict[str, Entry]:
        """Values by name; units are defined behind the values that have them."""
        for name, entry in self._found.items():
            base, offset = self._units.get(entry.unit, (None, 0.0))
            if offset:
                message = f"{name}: the unit {entry.unit!r} has an offset"
                help = "write the value in a unit without one"
                self._mistakes.append(Mistake(entry.where, message, help))
            self._found[name] = replace(entry, base=base)
        return self._found

    def _end(self, tag: str) -> None:
        self._depth -= 1
        if tag != f"{VALUES} Parameter":
            return
        if self._name and not self._line:
            kinds = ", ".join(_READERS)
            self._object(f"{self._name}: has no value", f"write an element {kinds} in it")
        self._name = ""

    def _object(self, message: str, help: str = "") -> None:
        self._mistakes.append(Mistake(self._where(), message, help))

    def _where(self) -> str:
        return f"{self._path}:{self.parser.CurrentLineNumber}"
