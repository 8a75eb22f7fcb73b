"""From runs of FMUs to a page: the scene that an FMU carries, and its drawing with a run's values."""

from __future__ import annotations

import json
import warnings
import zipfile
from collections.abc import Mapping, Sequence
from functools import cached_property
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from build_fmu.errors import UsageError, writing
from build_fmu.instance import description_of
from build_fmu.run import RECORDED
from build_fmu.study.values import nearest, read_value

if TYPE_CHECKING:
    from numpy import ndarray

    from build_fmu.run import Run
    from build_fmu.study.values import Entry
    from solver.runtime import Model
    from solver.scene import Scene
    from viewer.report import ReportRun

DRAWING = "resources/drawing.json"
"""In the archive, how the mechanism is drawn with the values that it was built with."""
MOST_TOLD = 8
"""Names of missing columns."""


def plain_values(entries: Mapping[str, Entry]) -> dict[str, Any]:
    """Return values without the places that they are from."""
    return {name: entry.value for name, entry in entries.items()}


class Carried:
    """What an FMU of ours carries of its mechanism."""

    def __init__(self, path: str | PathLike[str], beside: str = "") -> None:
        """Take an FMU, and a file in the folder of the files that its scene names."""
        self.path, self._beside = fspath(path), beside or fspath(path)

    @cached_property
    def model(self) -> Model:
        """The compiled model."""
        from build_fmu.target import fmu_model

        return fmu_model(self.path)

    @cached_property
    def scene(self) -> Scene:
        """The scene, from its text in the model description.

        Raises
        ------
        UsageError
            If there is none, or a file that it names is not beside the FMU.
        """
        from solver.scene import SceneError, loads

        with zipfile.ZipFile(self.path) as archive:
            root = ElementTree.fromstring(archive.read("modelDescription.xml"))
        found = next(root.iter("Scene"), None)
        text = "" if found is None else found.findtext("Text", "")
        if found is None or not text:
            text = f"{self.path}: it has no scene inside; build it from a file with this version"
            raise UsageError(text)
        pairs = (e.text.partition("=") for e in found.findall("Override") if e.text)
        overrides = {name.strip(): read_value(value) for name, _, value in pairs}
        try:
            form: Any = found.get("format", "toml")
            with warnings.catch_warnings():  # which were said when it was built
                warnings.simplefilter("ignore")
                return loads(text, name=self._beside, format=form, overrides=overrides)
        except SceneError as error:
            raise UsageError(str(error)) from None

    @cached_property
    def ports(self) -> list[str]:
        """Names of the columns of a run that are ports of the FMU."""
        shown = [v for v in description_of(self.path).modelVariables if v.causality in RECORDED]
        return ["time", *(v.name for v in shown if v.type != "String")]

    def drawing(self, values: Mapping[str, object] | None = None) -> Mapping[str, Any]:
        """How it is drawn with these values of its parameters."""
        from viewer.drawing import drawing

        known = {v.name: v.start for v in self.model.variables if v.kind == "parameter"}
        changed = {name: x for name, x in (values or {}).items() if name in known}
        try:
            return drawing(self.scene, known | changed)
        except UsageError:
            with zipfile.ZipFile(self.path) as archive:
                if changed or DRAWING not in archive.namelist():
                    raise
                return json.loads(archive.read(DRAWING))

    def report_run(
        self, times: ndarray, columns: Mapping[str, ndarray], values: Mapping[str, Any],
        where: str, **more: Any,
    ) -> ReportRun:  # fmt: skip
        """One run of a page, from values by name over the times.

        Raises
        ------
        UsageError
            If columns are missing that say where its parts are; `where` is named.
        """
        from viewer.packing import channels
        from viewer.report import ReportRun

        drawing = self.drawing(values)
        needed = channels(drawing)[0]
        missing = [name for name in needed if name not in columns]
        if missing:
            told = ", ".join(missing[:MOST_TOLD])
            rest = f" and {len(missing) - MOST_TOLD} more" if len(missing) > MOST_TOLD else ""
            hint = nearest(missing[0], [*columns])
            text = f"{where}: has no column {told}{rest}, by which {self.model.name} is drawn; "
            text += f"record all outputs of the FMU under their own names ({hint})"
            raise UsageError(text)
        return ReportRun(drawing, times, columns, settings=values, **more)

    def of_run(self, run: Run, values: Mapping[str, Any], label: str = "") -> ReportRun:
        """One run of a page, from a run in fmpy."""
        names = [n for n in run.values.dtype.names or () if n != "time"]
        columns = {name: run.values[name] for name in names}
        return self.report_run(
            run.values["time"], columns, values, self.path, label=label,
            stop_time=run.stop_time, wall_time=run.wall_time, reason=run.reason,
        )  # fmt: skip

    def write(
        self, path: str | PathLike[str], runs: Sequence[ReportRun], sentences: Sequence[str] = (),
        *, compare: bool = False,
    ) -> Path:  # fmt: skip
        """Write the page of runs of this FMU."""
        from viewer.report import write_report

        try:
            outputs = [*self.scene.outputs]
        except UsageError:
            outputs = []
        with writing(path):
            return write_report(
                path, runs, name=self.model.name, description=self.model.description,
                variables=self.model.variables, outputs=outputs, warnings=sentences,
                compare=compare,
            )  # fmt: skip
