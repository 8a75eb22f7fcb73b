"""From runs of FMUs to a page: the scene that an FMU carries, drawn with the values of a run."""

from __future__ import annotations

import json
import warnings
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from build_fmu.errors import UsageError
from build_fmu.instance import description_of
from build_fmu.printing import as_text
from build_fmu.run import RECORDED, run_fmu

if TYPE_CHECKING:
    from fmpy.model_description import ModelDescription
    from numpy import ndarray

    from build_fmu.run import Run
    from build_fmu.study.values import Entry
    from solver.runtime import Model
    from solver.scene import Scene
    from viewer.report import ReportRun

DRAWING = "resources/drawing.json"
"""In the archive, how the mechanism is drawn with the values that it was built with."""
MOST_RUNS = 24
"""Of a sweep, that one page shows; of more, evenly chosen ones."""


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
        overrides = {name.strip(): value for name, _, value in pairs}  # in TOML, as given
        try:
            form: Any = found.get("format", "toml")
            with warnings.catch_warnings():  # which were said when it was built
                warnings.simplefilter("ignore")
                return loads(text, name=self._beside, format=form, overrides=overrides)
        except SceneError as error:
            raise UsageError(str(error)) from None

    @cached_property
    def description(self) -> ModelDescription:
        """Its model description, checked."""
        return description_of(self.path)

    @cached_property
    def ports(self) -> list[str]:
        """Names of the columns of a run that are ports of the FMU."""
        shown = [v for v in self.description.modelVariables if v.causality in RECORDED]
        return ["time", *(v.name for v in shown if v.type != "String")]

    @property
    def scene_outputs(self) -> list[str]:
        """Names of the scene's own outputs; none if it has no scene."""
        try:
            return self.scene.results()
        except UsageError:
            return []

    def drawing(self, values: Mapping[str, object] | None = None) -> Mapping[str, Any]:
        """How it is drawn with these values of its parameters."""
        from viewer.drawing import drawing

        known: dict[str, Any] = {
            v.name: v.start for v in self.model.variables if v.kind == "parameter"
        }
        changed: dict[str, Any] = {n: x for n, x in (values or {}).items() if n in known}
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
        from viewer.report import ReportRun, missing_columns

        drawing = self.drawing(values)
        if missing := missing_columns(drawing, columns):
            text = f"{where}: has no column {missing}, by which {self.model.name} is drawn; "
            text += "record all outputs of the FMU under their own names"
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

        return write_report(
            path, runs, name=self.model.name, description=self.model.description,
            variables=self.model.variables, outputs=self.scene_outputs, warnings=sentences,
            compare=compare,
        )  # fmt: skip


def report_rows(
    path: str, rows: Sequence[tuple[str, Mapping[str, Any], Mapping[str, Any]]], beside: str = "",
    *, stop_time: float | None = None, step_size: float | None = None,
) -> str:  # fmt: skip
    """Run FMUs, and write one page of all of them; return a sentence about it.

    `rows` has an FMU, the values that all runs have, and those that tell it from the others; where
    these are in the FMU already, the values to run it with are empty.
    """
    chosen = rows[:: 1 + (len(rows) - 1) // MOST_RUNS]
    runs, carried = [], None
    for number, (fmu, values, shown) in enumerate(rows, start=1):
        if not any(values is row[1] for row in chosen):
            continue
        if carried is None or carried.path != fmu:
            carried = Carried(fmu, beside)
        result = run_fmu(
            fmu, stop_time=stop_time, step_size=step_size, settings=values, with_local=True
        )
        label = ", ".join(f"{name} = {as_text(value)}" for name, value in shown.items())
        run = carried.of_run(result, values, label or f"run {number}")
        runs.append(replace(run, parameters={"number": number, **shown}))
    assert carried is not None
    some = f"{len(runs)} of {len(rows)} runs" if len(runs) < len(rows) else f"{len(runs)} runs"
    carried.write(path, runs, [f"This page shows {some}."] if len(runs) < len(rows) else [])
    return f"{path}: a page of {some}, for any browser"
