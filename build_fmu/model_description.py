"""modelDescription.xml of a compiled model, as FMI 2.0.5 wants it.

A variable's value reference is its index in `Model.variables`. Numbers are written with `repr`, so
every start value comes back as the same double.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from build_fmu.units import BaseUnit, base_unit
from fmu_src.status import LOG_CATEGORIES

if TYPE_CHECKING:
    from solver.runtime import Model, Variable

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


def model_description(model: Model, *, identifier: str, guid: str, date: str, tool: str) -> bytes:
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
    _log_categories(root)
    _default_experiment(root, model)
    variables = SubElement(root, "ModelVariables")
    variables.extend(_variable(i, variable) for i, variable in enumerate(model.variables))
    _structure(root, model.variables)
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
            SubElement(unit, "BaseUnit", _base_unit(base))


def _base_unit(base: BaseUnit) -> dict[str, str]:
    attributes = {name: str(power) for name, power in base.powers.items()}
    if base.factor != 1.0:
        attributes["factor"] = repr(base.factor)
    return attributes


def _log_categories(root: Element) -> None:
    categories = SubElement(root, "LogCategories")
    for name, description in LOG_CATEGORIES.items():
        SubElement(categories, "Category", {"name": name, "description": description})


def _default_experiment(root: Element, model: Model) -> None:
    values = {name: getattr(model.experiment, field) for name, field in EXPERIMENT.items()}
    given = {name: repr(float(value)) for name, value in values.items() if value is not None}
    if given:
        SubElement(root, "DefaultExperiment", given)


def _variable(index: int, variable: Variable) -> Element:
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
    limits = {"unit": variable.unit, "min": variable.minimum, "max": variable.maximum}
    values = limits if variable.type == "Real" else {}
    if settable:
        values = {**values, "start": variable.start}
    given = {k: _text(v) for k, v in values.items() if v is not None and (k != "unit" or v)}
    SubElement(element, variable.type, given)
    return element


def _text(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(float(value))  # type: ignore[arg-type]


def _structure(root: Element, variables: Iterable[Variable]) -> None:
    structure = SubElement(root, "ModelStructure")
    numbered = list(enumerate(variables, start=1))
    outputs = [str(i) for i, v in numbered if v.causality == "output"]
    unknowns = [str(i) for i, v in numbered if v.causality in ("output", "calculatedParameter")]
    for name, indices in (("Outputs", outputs), ("InitialUnknowns", unknowns)):
        if indices:
            element = SubElement(structure, name)
            element.extend(Element("Unknown", {"index": index}) for index in indices)
