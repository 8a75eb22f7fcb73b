"""Turns a scene into an FMI 2.0 co-simulation unit, and runs, checks and describes such units.

>>> from build_fmu import build
>>> build("scenes/four_bar.toml", parameters={"points.B0.velocity": [2, 0]})  # doctest: +SKIP
PosixPath('four_bar.fmu')
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from build_fmu.study.manifest import Variant
    from build_fmu.study.sweep import sweep
    from solver.scene import Scene

__all__ = ["build", "sweep", "variants"]


def build(
    scene: str | PathLike[str] | Scene,
    path: str | PathLike[str] | None = None,
    *,
    parameters: Mapping[str, object] | str | PathLike[str] | None = None,
) -> Path:
    """Write the FMU of a scene; the same scene gives the same bytes.

    Its parameters go into a second file beside it, a parameter set of SSP (.ssv).

    Parameters
    ----------
    scene
        A scene file (.toml or .json) or a loaded scene.
    path
        An .fmu file, or a folder, for `<name of the scene>.fmu` in it; None: the current one.
    parameters
        Numbers and options that replace those of the scene file, by dotted name: a declared
        parameter ("length") or any field ("points.A.mass"); or a file of them, .toml, .json, .csv
        or .ssv.

    Returns
    -------
    Path
        The file that was written.

    Raises
    ------
    solver.scene.SceneError
        With every mistake of the scene.
    build_fmu.errors.UsageError
        With every mistake of a file of parameters.
    build_fmu.errors.EnvironmentLackError
        If the compiled kernel or pythonfmu's libraries are missing.
    """
    from build_fmu.export import build_archive

    return build_archive(scene, path, parameters)


def variants(
    scene: str | PathLike[str],
    folder: str | PathLike[str],
    *,
    grid: Mapping[str, object] | Sequence[str] = (),
    table: str | PathLike[str] | Sequence[Mapping[str, object]] | None = None,
    parameters: Mapping[str, object] | str | PathLike[str] | None = None,
    manifest: str = "manifest.csv",
    fresh: bool = False,
    engine: str = "auto",
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
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
        "auto", "serial", "processes" or "dask://host:port", and the number of processes.
    progress
        Called with the number of variants that are done, and of all.

    Returns
    -------
    list of Variant
        The rows of the manifest.

    Raises
    ------
    solver.scene.SceneError, build_fmu.errors.UsageError
        With every mistake; variants without one are written all the same.
    """
    from build_fmu.study.variants import export_variants

    return export_variants(
        scene,
        folder,
        grid=grid,
        table=table,
        parameters=parameters,
        manifest=manifest,
        fresh=fresh,
        engine=engine,
        workers=workers,
        progress=progress,
    )


def __getattr__(name: str) -> Any:
    if name != "sweep":
        text = f"module {__name__!r} has no attribute {name!r}"
        raise AttributeError(text)
    from build_fmu.study.sweep import sweep  # with its imports, for which a build need not wait

    globals()["sweep"] = sweep
    return sweep
