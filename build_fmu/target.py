"""What a command works on: a scene file or an FMU."""

from __future__ import annotations

import contextlib
import tempfile
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu.errors import UsageError
from solver.files import why_unreadable

if TYPE_CHECKING:
    from build_fmu.package import Package
    from build_fmu.study.values import Entry
    from solver.mechanics.parts import Parts
    from solver.runtime import Model


def is_fmu(target: str) -> bool:
    """Whether the file is an archive (rather than a scene).

    Raises
    ------
    UsageError
        If there is no such file, or it is a folder, a device or a pipe.
    """
    path = Path(target)
    if reason := why_unreadable(path):
        text = f"{target}: {reason}"
        raise UsageError(text)
    return path.suffix == ".fmu" or zipfile.is_zipfile(path)


def parts_and_model(target: str, entries: Mapping[str, Entry]) -> tuple[Parts, Model]:
    """Parts of a scene file with these values, and their model; mistakes become a UsageError."""
    from build_fmu.export import load_scene
    from build_fmu.study.settings import scene_overrides
    from solver.mechanics import assemble_parts
    from solver.scene import SceneError

    try:
        return assemble_parts(load_scene(target, scene_overrides(target, entries)))
    except SceneError as error:
        raise UsageError(str(error)) from None


def fmu_model(target: str) -> Model:
    """Compiled model inside an FMU of ours."""
    from build_fmu.instance import description_of
    from solver.runtime import Model, OptionError

    description_of(target)
    try:
        with zipfile.ZipFile(target) as archive:
            return Model.from_bytes(archive.read("resources/model.bin"))
    except (KeyError, ValueError, OptionError) as error:
        text = f"{target}: not made by this version of holonom ({error})"
        raise UsageError(text) from None


@contextlib.contextmanager
def runnable(
    target: str, entries: Mapping[str, Entry], package: Package | None = None
) -> Iterator[tuple[str, Mapping[str, Entry]]]:
    """FMU to run, and the values that are left for the run itself.

    A scene is built into a temporary folder with the values as overrides of its numbers,
    packaged with Python unless a package is given.
    """
    if is_fmu(target):
        yield target, entries
        return
    from build_fmu.export import write_fmu
    from build_fmu.package import PYTHON

    parts, model = parts_and_model(target, entries)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        yield str(write_fmu(parts, model, folder, package=package or PYTHON)), {}
