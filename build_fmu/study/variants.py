"""A family of FMUs: one for each row of a grid or table, and a manifest that tells them apart."""

from __future__ import annotations

import contextlib
import shutil
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu.errors import UnfinishedError
from build_fmu.export import fmu_path
from build_fmu.package import Package, chosen_package
from build_fmu.study.engines import engine_of
from build_fmu.study.grid import Row, rows_of
from build_fmu.study.manifest import Variant, in_one_form, manifest_path, manifest_text
from build_fmu.study.output_folder import require_room, take_over
from build_fmu.study.processes import Task
from build_fmu.study.settings import Source, entries_of, scene_overrides
from build_fmu.study.values import Mistake, in_one_text, refuse
from solver.files import write_whole
from solver.scene import Given, SceneError, SceneWarning

if TYPE_CHECKING:
    from distributed import Client  # pyright: ignore[reportMissingImports]


@dataclass(frozen=True)
class _Shared:
    scene: str
    overrides: Mapping[str, object]
    folder: str
    """Where it is made."""
    count: int
    package: Package

    def name(self, number: int) -> str:
        """Name of the file of a variant."""
        return f"{Path(self.scene).stem}_{number:0{len(str(self.count))}d}.fmu"


def variants(
    scene: str | PathLike[str],
    folder: str | PathLike[str],
    *,
    grid: Sequence[str] | Mapping[str, object] = (),
    table: str | PathLike[str] | Sequence[Mapping[str, object]] | None = None,
    parameters: Source | None = None,
    manifest: str = "manifest.csv",
    fresh: bool = False,
    engine: str | Client = "auto",
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    native: bool = False,
    fmi: int = 2,
    platforms: str | Sequence[str] | None = None,
    sources: bool = False,
) -> list[Variant]:
    """Write one FMU for each row of a grid or table, and a manifest of them, into a folder.

    Parameters
    ----------
    scene
        A scene file.
    folder
        Where the FMUs, a parameter set beside each, and the manifest are written.
    grid
        Values by the name of a parameter or any field of the scene: a list, or a text such as
        "1:5:9", which is 9 values from 1 to 5. All combinations are built.
    table
        A CSV file with names in its first line, or rows of values by name.
    parameters
        Values of all variants, by name or in a file.
    manifest
        Name of the manifest, .csv or .json.
    fresh
        Remove the FMUs of an earlier study that are in the folder.
    engine, workers
        "auto", "serial", "processes", "dask://host:port" or a `dask.distributed.Client`, and the
        number of processes.
    progress
        Called with the number of variants that are done, and of all.
    native, fmi, platforms, sources
        How they are packaged, as of `build_fmu.build`.

    Returns
    -------
    list of Variant
        The rows of the manifest.

    Warns
    -----
    solver.scene.SceneWarning
        Of what is legal in the scenes and seldom meant, once for all of them.

    Raises
    ------
    solver.scene.SceneError, build_fmu.errors.UsageError
        With every mistake. If only values of some rows are wrong, the others are written.
    build_fmu.errors.UnfinishedError
        If a process died that wrote one of them; the others are written.
    """
    mistakes: list[Mistake] = []
    rows, entries = rows_of(grid, table, mistakes), entries_of(parameters)
    if mistakes:  # those of the names, which are in all rows, are told with them
        named = {name: entry for row in rows for name, entry in row.items()}
        scene_overrides(scene, {**entries, **named}, mistakes)
    run_jobs, package = engine_of(engine, workers), chosen_package(native, fmi, platforms, sources)
    target = manifest_path(Path(folder), manifest)
    stem = Path(scene).stem
    scratch = target.parent / f".{stem}.variants"
    overrides = scene_overrides(scene, entries)
    shared = _Shared(fspath(scene), overrides, fspath(scratch), len(rows), package)
    jobs = list(enumerate(rows, start=1))
    names = {fmu_path(target.parent / shared.name(number), "").name for number, _ in jobs}
    require_room(target.parent, stem, names, fresh)
    shutil.rmtree(scratch, ignore_errors=True)  # of a study that was killed
    scratch.mkdir(parents=True)
    made: list[Variant] = []
    try:
        with contextlib.closing(run_jobs(Task(_export, shared, _lost), jobs)) as results:
            for variant in results:
                made.append(variant)
                if progress:
                    progress(len(made), len(jobs))
    finally:
        made = in_one_form(sorted(made, key=lambda variant: variant.number))
        if made:  # an interrupted study says what it has written
            take_over(scratch, target.parent, stem, {variant.fmu for variant in made})
            write_whole(target, manifest_text(made, target.suffix, shared.scene))
        shutil.rmtree(scratch, ignore_errors=True)
    refuse(mistake for variant in made if not variant.lost for mistake in variant.mistakes)
    if lost := [mistake for variant in made for mistake in variant.mistakes]:
        raise UnfinishedError(in_one_text(lost))
    for text in dict.fromkeys(text for variant in made for text in variant.warnings):
        warnings.warn(text, SceneWarning, stacklevel=2)
    return made


def _export(shared: _Shared, job: tuple[int, Row]) -> Variant:
    """Build one of the FMUs, from its number and row."""
    from build_fmu.export import write_fmu
    from solver.mechanics import assemble_parts
    from solver.scene.reader import read_file

    number, row = job
    own = {name: Given(entry.value, entry.where, entry.named) for name, entry in row.items()}
    values = {name: entry.value for name, entry in row.items()}
    try:
        scene = read_file(shared.scene, {**shared.overrides, **own})
        parts, model = assemble_parts(scene)
    except SceneError as error:
        return Variant(number, "", values, tuple(error.sentences()))
    path = Path(shared.folder, shared.name(number))
    write_fmu(parts, model, path, package=shared.package)
    return Variant(number, path.name, values, warnings=scene.sentences())


def _lost(job: tuple[int, Row], reason: str) -> Variant:
    number, row = job
    values = {name: entry.value for name, entry in row.items()}
    return Variant(number, "", values, (f"variant {number}: error: {reason}",), lost=True)
