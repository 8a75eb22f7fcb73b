"""modelDescription.xml of a compiled model, as FMI 2.0.5 wants it.

A variable's value reference is its index in `Model.variables`. Numbers are written with `repr`, so
every start value comes back as the same double.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from build_fmu.units import base_unit_attributes, declared_types
from build_fmu.xml_text import legible
from fmu_src.status import LOG_CATEGORIES
from solver.scene.units import base_unit

if TYPE_CHECKING:
    from solver.runtime import Model, Variable
    from solver.scene import Source

CAPABILITIES = {
    "needsExecutionTool": "true",  # a Python interpreter
    "canHandleVariableCommunicationStepSize": "true",
    "canInterpolateInputs": "false",
    "maxOutputDerivativeOrder": "0",
    "canRunAsynchronuously": "false",  # the standard's own spelling
    "canBeInstantiatedOnlyOncePerProcess": "false",
    "canNotUseMemoryManagementFunctions": "true",
    "canGetAndSetFMUstate": "true",
    "canSerializeFMUstate": "true",
    "providesDirectionalDerivative": "false",
}
EXPERIMENT = {
    "startTime": "start_time",
    "stopTime": "stop_time",
    "tolerance": "tolerance",
    "stepSize": "step_size",
}
UNKNOWNS = {"Outputs": ("output",), "InitialUnknowns": ("output", "calculatedParameter")}


def model_description(
    model: Model, *, identifier: str, guid: str, date: str, tool: str,
    nominal: Mapping[str, float] | None = None, source: Source | None = None,
) -> bytes:  # fmt: skip
    """Text of modelDescription.xml.

    Parameters
    ----------
    model
        The compiled model.
    identifier
        Name of the libraries below `binaries/`, a C identifier.
    guid
        Derived from the content of the archive.
    date
        Generation date and time, `YYYY-MM-DDThh:mm:ssZ`.
    tool
        Name and version of this program.
    nominal
        Nominal value by unit.
    source
        Text of the scene, which becomes an annotation.
    """
    attributes = {
        "fmiVersion": "2.0",
        "modelName": model.name,
        "guid": guid,
        "description": model.description,
        "generationTool": tool,
        "generationDateAndTime": date,
        "variableNamingConvention": "structured",
        "numberOfEventIndicators": "0",
    }
    root = Element("fmiModelDescription", {k: v for k, v in attributes.items() if v})
    SubElement(root, "CoSimulation", {"modelIdentifier": identifier, **CAPABILITIES})
    _units(root, model.variables)
    types = declared_types(model.variables)
    _types(root, types, nominal or {})
    _log_categories(root)
    _default_experiment(root, model)
    _annotations(root, source)
    variables = SubElement(root, "ModelVariables")
    variables.extend(_variable(i, x, types) for i, x in enumerate(model.variables))
    _structure(root, model)
    for element in root.iter():
        for name, value in element.attrib.items():
            element.set(name, legible(value))
    indent(root)
    return tostring(root, "UTF-8", xml_declaration=True) + b"\n"


def _units(root: Element, variables: Iterable[Variable]) -> None:
    names = sorted({variable.unit for variable in variables if variable.unit})
    if not names:
        return
    definitions = SubElement(root, "UnitDefinitions")
    for name in names:
        unit = SubElement(definitions, "Unit", {"name": name})
        base = base_unit(name)
        if base is not None:
            SubElement(unit, "BaseUnit", base_unit_attributes(base))


def _types(root: Element, types: Mapping[str, str], nominal: Mapping[str, float]) -> None:
    """One type per unit, with the nominal value of what has it."""
    if not types:
        return
    definitions = SubElement(root, "TypeDefinitions")
    for unit, name in types.items():
        simple = SubElement(definitions, "SimpleType", {"name": name})
        size = {"nominal": repr(nominal[unit])} if unit in nominal else {}
        SubElement(simple, "Real", {"quantity": name.rpartition(".")[2], "unit": unit, **size})


def _annotations(root: Element, source: Source | None) -> None:
    """The scene, so that an FMU can be built again from what it carries."""
    if source is None or not source.text:
        return
    tool = SubElement(SubElement(root, "VendorAnnotations"), "Tool", {"name": "holonom"})
    scene = SubElement(tool, "Scene", {"format": source.notation})
    SubElement(scene, "Text").text = legible(source.text)
    for text in source.overrides.values():
        SubElement(scene, "Override").text = legible(text)


def _log_categories(root: Element) -> None:
    categories = SubElement(root, "LogCategories")
    for name, description in LOG_CATEGORIES.items():
        SubElement(categories, "Category", {"name": name, "description": description})


def _default_experiment(root: Element, model: Model) -> None:
    values = {name: getattr(model.experiment, field) for name, field in EXPERIMENT.items()}
    given = {name: repr(float(value)) for name, value in values.items() if value is not None}
    if given:
        SubElement(root, "DefaultExperiment", given)


def _variable(index: int, variable: Variable, types: Mapping[str, str]) -> Element:
    settable = variable.causality in ("parameter", "input")
    attributes = {
        "name": variable.name,
        "valueReference": str(index),
        "description": variable.description,
        "causality": variable.causality,
        "variability": variable.variability,
        # Inputs must not say it: their start value is exact by definition.
        "initial": "" if variable.causality == "input" else "exact" if settable else "calculated",
    }
    element = Element("ScalarVariable", {k: v for k, v in attributes.items() if v})
    limits = {"min": variable.minimum, "max": variable.maximum}
    if variable.clips:
        limits = {}  # importers refuse what is beyond
    values = {"unit": variable.unit, **limits} if variable.type == "Real" else {}
    if variable.type == "Real" and variable.unit:
        values = {"declaredType": types[variable.unit], **values}
    if settable:
        values = {**values, "start": variable.start}
    given = {k: _text(v) for k, v in values.items() if v is not None and (k != "unit" or v)}
    SubElement(element, variable.type, given)
    return element


def _text(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(float(value))  # type: ignore[arg-type]


def _structure(root: Element, model: Model) -> None:
    """Outputs and InitialUnknowns, each with what it depends on; indices count from 1.

    Of a model that was read from bytes that is not known, which means all.
    """
    structure, variables = SubElement(root, "ModelStructure"), model.variables
    of_unknown = model.dependencies or {}
    for place, (name, kinds) in enumerate(UNKNOWNS.items()):
        unknowns = [i for i, variable in enumerate(variables) if variable.causality in kinds]
        element = SubElement(structure, name) if unknowns else structure
        for i in unknowns:
            attributes = {"index": str(i + 1)}
            if i in of_unknown:
                attributes["dependencies"] = " ".join(str(k + 1) for k in of_unknown[i][place])
            SubElement(element, "Unknown", attributes)
