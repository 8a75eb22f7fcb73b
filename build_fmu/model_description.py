"""modelDescription.xml of a compiled model, as FMI 2.0.5 wants it.

A variable's value reference is its index in `Model.variables`. Numbers are written with `repr`, so
every start value comes back as the same double.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import starmap
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from build_fmu.xml_parts import base_unit_attributes, declared_types, legible
from fmu_src.status import LOG_CATEGORIES
from solver.scene.units import base_unit

if TYPE_CHECKING:
    from solver.runtime import Model, Variable
    from solver.scene import Source

CAPABILITIES = {
    "needsExecutionTool": "true",  # a Python interpreter, unless it is native
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
    native: bool = False,
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
    native
        Whether it runs without Python.
    """
    types = declared_types(model.variables)
    capabilities = CAPABILITIES | ({"needsExecutionTool": "false"} if native else {})
    experiment = {name: getattr(model.experiment, field) for name, field in EXPERIMENT.items()}
    variables = (_variable(i, variable, types) for i, variable in enumerate(model.variables))
    parts = [
        _element("CoSimulation", modelIdentifier=identifier, **capabilities),
        _element("UnitDefinitions", *map(_unit, types)),
        _element("TypeDefinitions", *(_type(u, x, nominal or {}) for u, x in types.items())),
        _element("LogCategories", *starmap(_category, LOG_CATEGORIES.items())),
        _element("DefaultExperiment", **experiment),
        *_annotations(source),
        _element("ModelVariables", *variables),
        _structure(model),
    ]
    root = _element(
        "fmiModelDescription",
        *(part for part in parts if part.attrib or len(part) or part.tag.startswith("Model")),
        fmiVersion="2.0",
        modelName=model.name,
        guid=guid,
        description=model.description or None,
        generationTool=tool,
        generationDateAndTime=date,
        variableNamingConvention="structured",
        numberOfEventIndicators="0",
    )
    indent(root)
    return tostring(root, "UTF-8", xml_declaration=True) + b"\n"


def _element(tag: str, /, *children: Element, **attributes: object) -> Element:
    """Element with children, and with the attributes that are not None."""
    given = {name: legible(_text(x)) for name, x in attributes.items() if x is not None}
    element = Element(tag, given)
    element.extend(children)
    return element


def _text(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(float(value))  # type: ignore[arg-type]


def _category(name: str, description: str) -> Element:
    return _element("Category", name=name, description=description)


def _unit(name: str) -> Element:
    base = base_unit(name)
    bases = [] if base is None else [_element("BaseUnit", **base_unit_attributes(base))]
    return _element("Unit", *bases, name=name)


def _type(unit: str, name: str, nominal: Mapping[str, float]) -> Element:
    """Type of what has a unit, with its nominal value."""
    quantity = name.rpartition(".")[2]
    real = _element("Real", quantity=quantity, unit=unit, nominal=nominal.get(unit))
    return _element("SimpleType", real, name=name)


def _annotations(source: Source | None) -> list[Element]:
    """The scene, so that an FMU can be built again from what it carries."""
    if source is None or not source.text:
        return []
    scene = _element("Scene", format=source.notation)
    SubElement(scene, "Text").text = legible(source.text)
    for text in source.overrides.values():
        SubElement(scene, "Override").text = legible(text)
    return [_element("VendorAnnotations", _element("Tool", scene, name="holonom"))]


def _variable(index: int, variable: Variable, types: Mapping[str, str]) -> Element:
    settable = variable.causality in ("parameter", "input")
    # Inputs must not say it: their start value is exact by definition.
    initial = None if variable.causality == "input" else "exact" if settable else "calculated"
    given: dict[str, object] = {}
    if variable.type == "Real" and variable.unit:
        given = {"declaredType": types[variable.unit], "unit": variable.unit}
    if variable.type == "Real" and not variable.clips:  # importers refuse what is beyond
        given |= {"min": variable.minimum, "max": variable.maximum}
    if settable:
        given["start"] = variable.start
    return _element(
        "ScalarVariable",
        _element(variable.type, **given),
        name=variable.name,
        valueReference=str(index),
        description=variable.description or None,
        causality=variable.causality,
        variability=variable.variability,
        initial=initial,
    )


def _structure(model: Model) -> Element:
    """Outputs and InitialUnknowns, each with what it depends on; indices count from 1.

    Of a model that was read from bytes that is not known, which means all.
    """
    of_unknown, lists = model.dependencies or {}, []
    for place, (name, kinds) in enumerate(UNKNOWNS.items()):
        unknowns = []
        for i in (i for i, variable in enumerate(model.variables) if variable.causality in kinds):
            known = " ".join(str(k + 1) for k in of_unknown[i][place]) if i in of_unknown else None
            unknowns.append(_element("Unknown", index=str(i + 1), dependencies=known))
        lists += [_element(name, *unknowns)] if unknowns else []
    return _element("ModelStructure", *lists)
