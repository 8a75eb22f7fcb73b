"""modelDescription.xml of a compiled model, as FMI 3.0 wants it.

Value references are places in the list, from 1, since OMSimulator takes those in `dependencies` for
such: the index in `Model.variables` and 1. That of the time, which comes last, is 0.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING

from build_fmu.model_description import (
    attributes_of_value,
    attributes_of_variable,
    common_parts,
    description,
    is_settable,
    unknowns,
    vendor_annotations,
)
from build_fmu.xml_parts import Element, element

if TYPE_CHECKING:
    from solver.runtime import Model, Variable
    from solver.scene import Source

CAPABILITIES = {
    "needsExecutionTool": "false",
    "canBeInstantiatedOnlyOncePerProcess": "false",
    "canGetAndSetFMUState": "true",
    "canSerializeFMUState": "true",
    "providesDirectionalDerivatives": "false",
    "providesAdjointDerivatives": "false",
    "providesPerElementDependencies": "false",
    "canHandleVariableCommunicationStepSize": "true",
    "maxOutputDerivativeOrder": "1",
    "providesIntermediateUpdate": "false",
    "mightReturnEarlyFromDoStep": "false",
    "canReturnEarlyAfterIntermediateUpdate": "false",
    "hasEventMode": "false",
    "providesEvaluateDiscreteStates": "false",
}
TYPES = {"Real": "Float64", "Boolean": "Boolean", "String": "String"}
"""What the types of variables are called."""


def model_description_fmi3(
    model: Model, *, identifier: str, guid: str, date: str, tool: str,
    nominal: Mapping[str, float] | None = None, source: Source | None = None,
    local: Collection[int] = (),
) -> bytes:  # fmt: skip
    """Text of modelDescription.xml; the arguments are those of ``model_description``."""
    types, ports, parts = common_parts(model, nominal, local, _type)
    variables = (_variable(i, variable, types) for i, variable in enumerate(ports, 1))
    time = element(  # no name of a scene is `time`
        "Float64", name="time", valueReference="0",
        causality="independent", variability="continuous", unit="s" if "s" in types else None,
    )  # fmt: skip
    return description(
        model, "3.0", {"instantiationToken": guid}, date, tool,
        element("CoSimulation", modelIdentifier=identifier, **CAPABILITIES),
        *parts,
        element("ModelVariables", *variables, time),
        _structure(model, ports),
        element(
            "Annotations",
            *(
                element("Annotation", each, type=name)
                for name, each in vendor_annotations(model, source)
            ),
        ),
    )  # fmt: skip


def _type(name: str, given: Mapping[str, object]) -> Element:
    return element("Float64Type", name=name, **given)


def _variable(index: int, variable: Variable, types: Mapping[str, str]) -> Element:
    is_text = variable.type == "String" and is_settable(variable.causality)
    value = attributes_of_value(variable, types, with_start=not is_text)
    start = [element("Start", value=variable.start)] if is_text else []  # several, of an array
    return Element(TYPES[variable.type], attributes_of_variable(index, variable) + value, start)


def _structure(model: Model, ports: Sequence[Variable]) -> Element:
    """Outputs and initial unknowns, each with the value references of what it depends on."""
    return element(
        "ModelStructure",
        *(
            Element(TAGS[name], f' valueReference="{place}"{known}')
            for name, place, known in unknowns(model, ports)
        ),
    )


TAGS = {"Outputs": "Output", "InitialUnknowns": "InitialUnknown"}
"""Elements of the model structure by the lists of FMI 2."""
