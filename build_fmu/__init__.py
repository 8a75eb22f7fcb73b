"""Turns a scene into an FMI 2.0 co-simulation unit, and runs, checks and describes such units.

>>> from build_fmu import build
>>> build("scenes/four_bar.toml", parameters={"points.B0.velocity": [2, 0]})  # doctest: +SKIP
PosixPath('four_bar.fmu')
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from solver.extras import from_homes

if TYPE_CHECKING:
    from build_fmu.study.sweep import sweep
    from build_fmu.study.variants import variants
    from solver.scene import Scene

__all__ = ["build", "sweep", "variants"]


def build(
    scene: str | PathLike[str] | Scene,
    path: str | PathLike[str] | None = None,
    *,
    parameters: Mapping[str, object] | str | PathLike[str] | None = None,
    native: bool = False,
    fmi: int = 2,
    platforms: str | Sequence[str] | None = None,
    sources: bool = False,
) -> Path:
    """Write the FMU of a scene; the same scene gives the same bytes.

    Its parameters go into a second file beside it, a parameter set of SSP (.ssv).

    Parameters
    ----------
    scene
        A scene file (.toml or .json) or a loaded scene.
    path
        An .fmu file, or a folder; None: the current one. In a folder the FMU has the name of the
        scene's file, `<name>.fmu`, and that of the mechanism if the scene was loaded before.
    parameters
        Numbers and options that replace those of the scene file, by dotted name: a declared
        parameter ("length") or any field ("points.A.mass"); or a file of them, .toml, .json, .csv
        or .ssv.
    native
        Whether it has a library in C, and so runs without Python.
    fmi
        Version of the standard: 2 or, if it is native, 3.
    platforms
        Of a native FMU: "linux64", "win64", "darwin64", "linux-arm64", several of them, or "all";
        None: that of this machine; "none" of an FMU with sources.
    sources
        Whether a native FMU has its sources, too, in C.

    Returns
    -------
    Path
        The file that was written.

    Raises
    ------
    solver.scene.SceneError
        With every mistake of the scene.
    build_fmu.errors.UsageError
        With every mistake of a file of parameters; or if the package is none that there is.
    build_fmu.errors.EnvironmentLackError
        If the compiled kernel or pythonfmu's libraries are missing.
    """
    from build_fmu.export import build_archive
    from build_fmu.package import chosen_package

    return build_archive(scene, path, parameters, chosen_package(native, fmi, platforms, sources))


# A build need not wait for the imports of studies.
_HOMES = "build_fmu.study.sweep", "build_fmu.study.variants"
__getattr__, __dir__ = from_homes(__name__, __all__, _HOMES)
