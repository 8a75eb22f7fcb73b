"""Parameter sets of the SSP standard, System Structure Parameter Values 1.0 (.ssv files).

One is written beside every FMU, with all its parameters, their values and units; what was changed
in a copy of it can be given back to every command by `--parameters`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Collection, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from build_fmu.study.values import Entry, Mistake, keep
from build_fmu.xml_parts import Element, base_unit_attributes, document, element
from solver.files import read_whole
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


def parameter_set(model: Model, *, date: str, tool: str, local: Collection[int] = ()) -> bytes:
    """Text of the .ssv file of a model: parameters with start values, but for those in `local`."""
    variables = enumerate(model.variables)
    parameters = [v for i, v in variables if v.causality == "parameter" and i not in local]
    listed = [
        element(
            "ssv:Parameter",
            element(f"ssv:{variable.type}", **_value(variable)),
            name=variable.name or None,
            description=variable.description or None,
        )
        for variable in parameters
    ]
    units = _units(parameters)
    return document(
        element(
            "ssv:ParameterSet",
            element("ssv:Parameters", *listed),
            *([element("ssv:Units", *units)] if units else []),
            **({"xmlns:ssc": COMMON} if units else {}),
            **{"xmlns:ssv": VALUES},
            version="1.0",
            name=model.name,
            generationTool=tool,
            generationDateAndTime=date,
        )
    )


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


def _units(parameters: Iterable[Variable]) -> list[Element]:
    """Elements of the units that parameters have and whose base units are known."""
    bases = {v.unit: base_unit(v.unit) for v in parameters if v.unit}
    known = sorted((unit, base) for unit, base in bases.items() if base)
    return [
        element("ssc:Unit", element("ssc:BaseUnit", **base_unit_attributes(base)), name=name)
        for name, base in known
    ]


# ----------------------------------------------------------------------------------- read


def read_parameter_set(path: Path, mistakes: list[Mistake]) -> dict[str, Entry]:
    """Values of a .ssv file by name; lxml knows the line of each element."""
    from lxml import etree  # pyright: ignore[reportAttributeAccessIssue]

    def object_to(element: Any, message: str, help: str = "") -> None:
        mistakes.append(Mistake(f"{path}:{element.sourceline}", message, help))

    parser = etree.XMLParser(resolve_entities=False, no_network=True)
    try:
        root = etree.fromstring(read_whole(path), parser)
    except etree.XMLSyntaxError as error:
        where = f"{path}:{error.lineno}:{(error.offset or 0) + 1}"
        message = f"not XML: {str(error.msg).partition(', line ')[0]}"
        mistakes.append(Mistake(where, message))
        return {}
    if root.tag != f"{{{VALUES}}}ParameterSet":
        help = f"the root must be ParameterSet of the namespace {VALUES}"
        message = f"not a parameter set of SSP 1.0, but {etree.QName(root).localname!r}"
        object_to(root, message, help)
    units = _defined_units(root, object_to)
    found: dict[str, Entry] = {}
    for parameter in root.iter(f"{{{VALUES}}}Parameter"):
        name = parameter.get("name", "")
        given = list(parameter.iterchildren(*(f"{{{VALUES}}}{kind}" for kind in _READERS)))
        if not name:
            object_to(parameter, "a Parameter without a name")
        elif not given:
            help = f"write an element {', '.join(_READERS)} in it"
            object_to(parameter, f"{name}: has no value", help)
        elif len(given) > 1:
            help = f"the first is in line {given[0].sourceline}"
            object_to(given[1], f"{name}: has two values", help)
        else:
            element, unit = given[0], given[0].get("unit", "")
            base, offset = units.get(unit, (None, 0.0))
            if offset:
                help = "write the value in a unit without one"
                object_to(element, f"{name}: the unit {unit!r} has an offset", help)
                continue
            read, words = _READERS[etree.QName(element).localname]
            text, where = element.get("value", ""), f"{path}:{element.sourceline}"
            try:
                entry = Entry(read(text), where, unit, base=base, repeats=True)
                keep(found, name, entry, mistakes)
            except (ValueError, KeyError):
                object_to(element, f"{name}: must be {words}, got {text!r}")
    return found


def _defined_units(
    root: Any, object_to: Callable[[Any, str], None]
) -> dict[str, tuple[BaseUnit, float]]:
    """What the file says of each unit, and its offset: value in SI = factor * value + offset."""
    lines: dict[str, int] = {}
    found: dict[str, tuple[BaseUnit, float]] = {}
    for unit in root.iter(f"{{{COMMON}}}Unit"):
        name = unit.get("name", "")
        first = lines.setdefault(name, unit.sourceline)
        if first != unit.sourceline:
            object_to(unit, f"unit {name!r}: defined twice, first in line {first}")
        for base in unit.iterchildren(f"{{{COMMON}}}BaseUnit"):
            numbers: dict[str, float] = {}
            for key, text in base.items():
                try:
                    numbers[key] = float(text) if key in ("factor", "offset") else int(text)
                except ValueError:
                    object_to(base, f"unit {name!r}: {key} must be a number, got {text!r}")
            factor, offset = numbers.pop("factor", 1.0), numbers.pop("offset", 0.0)
            if not 0.0 < factor <= sys.float_info.max:
                message = f"unit {name!r}: factor must be a finite number > 0"
                object_to(base, f"{message}, got {base.get('factor')!r}")
            powers = {key: int(power) for key, power in numbers.items() if power}
            found[name] = BaseUnit(powers, factor), offset
    return found
