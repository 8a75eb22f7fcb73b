"""What a command works on: a scene file or an FMU."""

from __future__ import annotations

import contextlib
import tempfile
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu.errors import UsageError

if TYPE_CHECKING:
    from build_fmu.study.values import Entry
    from solver.runtime import Model
    from solver.scene import Scene


def is_fmu(target: str) -> bool:
    """Whether the file is an archive (rather than a scene).

    Raises
    ------
    UsageError
        If there is no such file.
    """
    path = Path(target)
    if not path.is_file():
        text = f"{target}: no such file"
        raise UsageError(text)
    return path.suffix == ".fmu" or zipfile.is_zipfile(path)


def scene_and_model(target: str, entries: Mapping[str, Entry]) -> tuple[Scene, Model]:
    """Scene of a file with these values, and its model; its mistakes become a UsageError."""
    from build_fmu.export import compile_scene, load_scene
    from build_fmu.study.settings import scene_overrides
    from solver.scene import SceneError

    try:
        scene = load_scene(target, scene_overrides(target, entries))
        return scene, compile_scene(scene)
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
    target: str, entries: Mapping[str, Entry]
) -> Iterator[tuple[str, Mapping[str, Entry]]]:
    """FMU to run, and the values that are left for the run itself.

    A scene is built into a temporary folder with the values as overrides of its numbers.
    """
    if is_fmu(target):
        yield target, entries
        return
    from build_fmu.export import write_fmu

    scene, model = scene_and_model(target, entries)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        yield str(write_fmu(model, folder, scene)), {}
