"""Inputs that change during the run of an FMU: from a CSV file, arrays, or functions of time."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from build_fmu.reference import Reference, name_of, read_columns
from build_fmu.study.values import Mistake, nearest, refuse
from solver.signals import Courses, Problem, changes, courses, moving_inputs

if TYPE_CHECKING:
    from os import PathLike

    from fmpy.model_description import ModelDescription


def interpolations_in(path: str | PathLike[str]) -> dict[str, str]:
    """Inputs of an FMU that move within a communication step, by its annotation: ramp or smooth."""
    with zipfile.ZipFile(path) as archive:
        root = ElementTree.fromstring(archive.read("modelDescription.xml"))
    found = root.iterfind(".//Inputs/Input")
    return {each.get("name", ""): each.get("interpolation", "") for each in found}


@dataclass(frozen=True)
class Inputs:
    """Inputs by name: those that change, with the "time" of arrays, and those with one value."""

    where: str
    """Name of the file, or of the argument, for messages."""
    changing: Mapping[str, Any]
    held: Mapping[str, Any]
    places: Sequence[str] = ()
    """Where the rows are in the file."""

    def courses(
        self,
        description: ModelDescription,
        interpolations: Mapping[str, str],
        values: Mapping[str, object],
        times: Sequence[float],
    ) -> Courses:
        """Inputs that change, over the communication points `times` [s]; `values` has the others.

        `interpolations` tells those that move within a step.

        Raises
        ------
        UsageError
            If a name is no input, an input has a value besides its signal, or a signal is wrong.
        """
        if not self.changing:
            return Courses([*times], range(len(times)))
        known = [v.name for v in description.modelVariables if v.causality == "input"]
        mistakes = []
        for name in self.changing.keys() - {"time"}:
            if name not in known:
                message = f"{description.modelName} has no input {name!r}"
                mistakes.append(Mistake(self.where, message, nearest(name, known)))
            elif name in values:
                help = "leave out the column, or the value"
                message = f"{name}: there is a value for the whole run"
                mistakes.append(Mistake(self.where, message, help))
        if self.changing.keys() <= {"time"}:
            mistakes.append(Mistake(self.where, "has no column of an input", nearest("", known)))
        refuse(mistakes)
        problems: list[Problem] = []
        moving = moving_inputs(interpolations, description.modelVariables)
        found = courses(self.changing, times, moving, problems, self.places)
        refuse(Mistake(self.where, *problem) for problem in problems)
        return found

    def notes(self, start: float) -> tuple[str, ...]:
        """A sentence if the times of arrays begin after the start of the run [s]."""
        times = self.changing.get("time")
        if times is None or callable(times) or not times[0] > start:
            return ()
        text = f"{self.where}: begins at t = {times[0]:g} s; from {start:g} s until then"
        return (f"{text} the inputs have the values of its first row",)


def inputs_of(inputs: Reference | None) -> Inputs:
    """Inputs as they are given, or from the columns of a file."""
    if inputs is None:
        return Inputs("", {}, {})
    if not isinstance(inputs, Mapping):
        columns, places = read_columns(inputs)
        return Inputs(name_of(inputs), columns, {}, places)
    changing = {name: signal for name, signal in inputs.items() if changes(signal)}
    held = {name: value for name, value in inputs.items() if name not in changing}
    return Inputs("inputs", changing, held)
