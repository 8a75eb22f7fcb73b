"""Names of variables of an FMU: which can be set and which are seen, and what was perhaps meant."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from build_fmu.study.values import Mistake, listed, nearest

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription

SETTABLE = ("parameter", "input")
OURS = "holonom "
"""What the name of the tool begins with that wrote an FMU of this package."""


def not_settable(where: str, name: str, description: ModelDescription) -> Mistake:
    """Mistake of a name that is none of a parameter or input."""
    causality = {v.name: v.causality for v in description.modelVariables}
    settable = [each for each, kind in causality.items() if kind in SETTABLE]
    if name in causality:
        kind = "an output" if causality[name] == "output" else f"a variable ({causality[name]})"
        help = f"settable: {listed(settable)}" if settable else "it has no parameters and inputs"
        return Mistake(where, f"{name}: is {kind} and cannot be set", help)
    message = f"{description.modelName} has no parameter or input {name!r}"
    table, dot, part = str(name).partition(".")
    is_field = bool(dot) or name == "gravity" or "[" in part + table
    if table in ("parameters", "inputs"):
        return Mistake(where, message, nearest(part.partition(".")[0], settable))
    if is_field and table != "solver" and (description.generationTool or "").startswith(OURS):
        help = "fields of a scene are fixed in its FMU: declare a parameter for it in the scene, "
        return Mistake(where, message, help + "or build FMUs with other values (build, variants)")
    return Mistake(where, message, nearest(name, settable))


def outputs_of(
    description: ModelDescription, names: Sequence[str] | None, mistakes: list[Mistake]
) -> list[str]:
    """Outputs that are asked for, each once, or all; any variable that is a number can be one."""
    kinds = {v.name: v.type for v in description.modelVariables}
    outputs = [v.name for v in description.modelVariables if v.causality == "output"]
    if names is None:
        return outputs
    names = [names] if isinstance(names, str) else names
    for name in names:
        where = f"output {name}"
        if name not in kinds:
            message = f"{description.modelName} has no variable {name!r}"
            mistakes.append(Mistake(where, message, nearest(name, outputs, kinds)))
        elif kinds[name] == "String":
            help = "a sweep stores only numbers"
            mistakes.append(Mistake(where, f"{name}: is a text, not a number", help))
    return list(dict.fromkeys(names))
