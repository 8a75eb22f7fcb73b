"""modelDescription.xml of a compiled model, as FMI 2.0.5 wants it.

A variable's value reference is its index in `Model.variables`. Numbers are written with `repr`, so
every start value comes back as the same double.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cache, lru_cache
from typing import TYPE_CHECKING

from build_fmu.source_package import UNIT
from build_fmu.xml_parts import (
    Element,
    base_unit_attributes,
    declared_types,
    document,
    element,
    written,
)
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
NATIVE = {"needsExecutionTool": "false", "maxOutputDerivativeOrder": "1"}
EXPERIMENT = {
    "startTime": "start_time",
    "stopTime": "stop_time",
    "tolerance": "tolerance",
    "stepSize": "step_size",
}
DRAWING = "resources/drawing.json"
"""Path in the archive of the drawing of the mechanism, which an annotation names."""
DISPLAY_UNITS = {"m": ("mm",), "rad": ("deg",), "rad/s": ("rpm",), "Pa": ("bar",)}
"""Units that importers may show values in, besides those that a scene names."""
UNKNOWNS = {"Outputs": ("output",), "InitialUnknowns": ("output", "calculatedParameter")}


def model_description(
    model: Model, *, identifier: str, guid: str, date: str, tool: str,
    nominal: Mapping[str, float] | None = None, source: Source | None = None,
    native: bool = False, sources: bool = False, local: Collection[int] = (),
) -> bytes:  # fmt: skip
    """Text of modelDescription.xml.

    FMI 3.0 has its own, with the same arguments: ``model_description_fmi3``.

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
    sources
        Whether its sources in C are in the archive.
    local
        Indices of the variables that are no ports.
    """
    capabilities = CAPABILITIES | (NATIVE if native else {})
    files = [element("SourceFiles", element("File", name=UNIT))] if sources else []
    types, ports, parts = common_parts(model, nominal, local, _type)
    variables = (_variable(i, variable, types) for i, variable in enumerate(ports))
    return description(
        model, "2.0", {"guid": guid}, date, tool,
        element("CoSimulation", *files, modelIdentifier=identifier, **capabilities),
        *parts,
        element(
            "VendorAnnotations",
            *(element("Tool", each, name=name) for name, each in vendor_annotations(model, source)),
        ),
        element("ModelVariables", *variables),
        _structure(model, ports),
        numberOfEventIndicators="0",
    )  # fmt: skip


def description(
    model: Model, version: str, token: Mapping[str, str], date: str, tool: str,
    *parts: Element, **more: str,
) -> bytes:  # fmt: skip
    """Text of the description of a model with these parts, of which empty ones are left out."""
    return document(
        element(
            "fmiModelDescription",
            *(x for x in parts if x.attributes or x.children or x.tag.startswith("Model")),
            fmiVersion=version,
            modelName=model.name,
            **token,
            description=model.description or None,
            generationTool=tool,
            generationDateAndTime=date,
            variableNamingConvention="structured",
            **more,
        )
    )


def common_parts(
    model: Model, nominal: Mapping[str, float] | None, local: Collection[int],
    type_of: Callable[[str, Mapping[str, object]], Element],
) -> tuple[dict[str, str], list[Variable], list[Element]]:  # fmt: skip
    """Return types by unit, ports, and units, types, categories of the log and the experiment.

    `type_of` is the element of a type, from its name and the attributes of what has it.
    """
    types, known = declared_types(model.variables), nominal or {}
    experiment = {name: getattr(model.experiment, field) for name, field in EXPERIMENT.items()}
    categories = (element("Category", name=n, description=x) for n, x in LOG_CATEGORIES.items())
    declared = (
        type_of(x, {"quantity": x.rpartition(".")[2], "unit": unit, "nominal": known.get(unit)})
        for unit, x in types.items()
    )
    shown: dict[str, set[str]] = {}
    for variable in model.variables:
        if variable.display_unit:
            shown.setdefault(variable.unit, set()).add(variable.display_unit)
    # Importers may read what is no port.
    ports = [
        v._replace(causality="local") if i in local else v for i, v in enumerate(model.variables)
    ]
    parts = [
        element("UnitDefinitions", *(_unit(name, shown.get(name, ())) for name in types)),
        element("TypeDefinitions", *declared),
        element("LogCategories", *categories),
        element("DefaultExperiment", **experiment),
    ]
    return types, ports, parts


def _unit(name: str, shown: Collection[str]) -> Element:
    """Return the element of a unit, with base units and those that show it, where it is known."""
    base = base_unit(name)
    if base is None:
        return element("Unit", name=name)
    others = [*DISPLAY_UNITS.get(name, ()), *sorted({*shown} - {*DISPLAY_UNITS.get(name, ())})]
    known = {other: found for other in others if (found := base_unit(other))}
    displays = (
        element("DisplayUnit", name=other, factor=base.factor / found.factor)
        for other, found in known.items()
    )
    return element("Unit", element("BaseUnit", **base_unit_attributes(base)), *displays, name=name)


def _type(name: str, given: Mapping[str, object]) -> Element:
    return element("SimpleType", element("Real", **given), name=name)


def vendor_annotations(model: Model, source: Source | None) -> list[tuple[str, Element]]:
    """Names and content of annotations: the scene, where its drawing is, and inputs that move.

    From the scene an FMU can be built again; the drawing is for tools without holonom. Inputs that
    move within a communication step are to be set to their values at its end. FMI 2 has room for
    one element in each.
    """
    found = [("holonom.drawing", element("Drawing", file=DRAWING))]
    if moving := model.moving_inputs.items():
        inputs = (element("Input", name=name, interpolation=word) for name, word in moving)
        found.append(("holonom.inputs", element("Inputs", *inputs)))
    if source is None or not source.text:
        return found
    parts = [Element("Text", text=source.text)]
    parts += [Element("Override", text=text) for text in source.overrides.values()]
    return [("holonom", element("Scene", *parts, format=source.notation)), *found]


def _variable(index: int, variable: Variable, types: Mapping[str, str]) -> Element:
    value = Element(variable.type, attributes_of_value(variable, types))
    return Element("ScalarVariable", attributes_of_variable(index, variable), (value,))


def attributes_of_variable(index: int, variable: Variable) -> str:
    """Return who a variable is, and what it is to an importer, as attributes are written."""
    known = {"name": variable.name, "valueReference": str(index)}
    named = written({**known, "description": variable.description or None})
    return named + _kind(variable.causality, variable.variability)


@lru_cache(1024)
def _kind(causality: str, variability: str) -> str:
    # Inputs must not say it: their start value is exact by definition.
    initial = "exact" if is_settable(causality) else "calculated"
    return written(
        {
            "causality": causality,
            "variability": variability,
            "initial": None if causality == "input" else initial,
        }
    )


def attributes_of_value(
    variable: Variable, types: Mapping[str, str], with_start: bool = True
) -> str:
    """Return the type, unit, limits and start of a variable's value, as they are written."""
    text = ""
    if variable.type == "Real":
        limits = (None, None) if variable.clips else (variable.minimum, variable.maximum)
        shown = variable.display_unit or None
        text = _type_and_limits(types.get(variable.unit or ""), variable.unit, shown, *limits)
    if with_start and is_settable(variable.causality):
        text += written({"start": variable.start})
    return text


@lru_cache(1024)
def _type_and_limits(
    type_name: str | None, unit: str | None, shown: str | None,
    minimum: float | None, maximum: float | None,
) -> str:  # fmt: skip
    # Importers refuse what is beyond.
    typed = {"declaredType": type_name, "unit": unit, "displayUnit": shown} if unit else {}
    return written({**typed, "min": minimum, "max": maximum})


def is_settable(causality: str) -> bool:
    """Whether a user may give a variable of this causality its start value."""
    return causality in ("parameter", "input")


def _structure(model: Model, ports: Sequence[Variable]) -> Element:
    """Outputs and InitialUnknowns, each with what it depends on; indices count from 1."""
    lists: dict[str, list[Element]] = {}
    for name, place, known in unknowns(model, ports):
        unknown = Element("Unknown", f' index="{place}"{known}')
        lists.setdefault(name, []).append(unknown)
    return element("ModelStructure", *(element(name, *each) for name, each in lists.items()))


def unknowns(model: Model, ports: Sequence[Variable]) -> Iterator[tuple[str, int, str]]:
    """Yield the list of each unknown, its place from 1 on, and its attribute `dependencies`.

    Of a model that was read from bytes these are not known, which means all: no attribute.
    """
    of_unknown: Mapping[int, Sequence[Sequence[int]]] = model.dependencies or {}

    @cache
    def listed(known: Sequence[int]) -> str:
        places = [str(k + 1) for k in known if ports[k].causality != "local"]
        return f' dependencies="{" ".join(places)}"'

    for place, (name, kinds) in enumerate(UNKNOWNS.items()):
        for i in [i for i, variable in enumerate(ports) if variable.causality in kinds]:
            yield name, i + 1, listed(of_unknown[i][place]) if i in of_unknown else ""
