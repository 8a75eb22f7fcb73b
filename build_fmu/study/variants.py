"""A family of FMUs: one for each row of a grid or table, and a manifest that tells them apart."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from build_fmu.errors import UsageError
from build_fmu.study.engines import Task, run_jobs
from build_fmu.study.grid import Row, rows_of
from build_fmu.study.settings import Source, entries_of, scene_overrides
from build_fmu.study.values import refuse

MANIFEST = "manifest.csv"


@dataclass(frozen=True)
class Variant:
    """One row of a manifest."""

    number: int
    """From 1, in the order of the grid or table."""
    fmu: str
    """Name of the file beside the manifest; empty where there is none."""
    parameters: dict[str, object]
    error: str = field(default="", repr=False)
    """Why there is no FMU."""


@dataclass(frozen=True)
class _Shared:
    scene: str
    overrides: Mapping[str, object]
    folder: str
    stem: str
    digits: int


def export_variants(
    scene: str | PathLike[str],
    folder: str | PathLike[str],
    *,
    grid: Sequence[str] | Mapping[str, object] = (),
    table: str | PathLike[str] | Sequence[Mapping[str, object]] | None = None,
    parameters: Source | None = None,
    manifest: str = MANIFEST,
    engine: str = "auto",
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> list[Variant]:
    """Write the FMUs and the manifest; see `build_fmu.variants`."""
    rows = rows_of(grid, table)
    target = Path(folder, manifest)
    if target.suffix not in (".csv", ".json"):
        text = f"{target}: a manifest is a .csv or .json file"
        raise UsageError(text)
    shared = _Shared(
        scene=fspath(scene),
        overrides=scene_overrides(scene, entries_of(parameters)),
        folder=fspath(folder),
        stem=_stem(scene),
        digits=len(str(len(rows))),
    )
    Path(folder).mkdir(parents=True, exist_ok=True)
    jobs = [(number, row) for number, row in enumerate(rows, start=1)]
    made: list[Variant] = []
    for variant in run_jobs(Task(_export, shared, _lost), jobs, engine, workers):
        made.append(variant)
        if progress:
            progress(len(made), len(jobs))
    made.sort(key=lambda variant: variant.number)
    if any(variant.fmu for variant in made):
        target.write_bytes(_manifest(made, target.suffix, shared.scene).encode())
    refuse(variant.error for variant in made if variant.error)
    return made


def _stem(scene: str | PathLike[str]) -> str:
    from build_fmu.export import identifier

    return identifier(Path(scene).stem)


def _export(shared: _Shared, jobs: Sequence[tuple[int, Row]]) -> list[Variant]:
    """Build some of the FMUs; a job is a number and a row."""
    return [_exported(shared, number, row) for number, row in jobs]


def _exported(shared: _Shared, number: int, row: Row) -> Variant:
    from build_fmu.export import compile_scene, load_scene, write_fmu, write_parameter_set
    from solver.scene import Given, SceneError

    own = {name: Given(entry.value, entry.where, entry.named) for name, entry in row.items()}
    values = {name: entry.value for name, entry in row.items()}
    try:
        scene = load_scene(shared.scene, {**shared.overrides, **own})
        model = compile_scene(scene)
    except SceneError as error:
        return Variant(number, "", values, str(error))
    path = Path(shared.folder, f"{shared.stem}_{number:0{shared.digits}d}.fmu")
    write_parameter_set(model, write_fmu(model, path, scene))
    return Variant(number, path.name, values)


def _lost(job: tuple[int, Row], reason: str) -> Variant:
    number, row = job
    values = {name: entry.value for name, entry in row.items()}
    return Variant(number, "", values, f"variant {number}: error: {reason}")


def _manifest(made: Sequence[Variant], kind: str, scene: str) -> str:
    if kind == ".json":
        variants = [
            {"variant": v.number, "fmu": v.fmu, "parameters": v.parameters, "error": v.error}
            for v in made
        ]
        return json.dumps({"scene": scene, "variants": variants}, indent=1) + "\n"
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    names = list(dict.fromkeys(name for v in made for name in v.parameters))
    writer.writerow(["variant", "fmu", *names, "error"])
    for v in made:
        cells = [cell(v.parameters.get(name, "")) for name in names]
        writer.writerow([v.number, v.fmu, *cells, v.error.partition("\n")[0]])
    return file.getvalue()


def cell(value: Any) -> str:
    """Value as a cell of a table, which reads back as the same value."""
    return value if isinstance(value, str) else json.dumps(value)
