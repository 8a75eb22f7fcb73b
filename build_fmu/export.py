"""Scene to FMU: compile, collect the parts of the archive, write it."""

from __future__ import annotations

import json
import os
import re
import time
import uuid
from collections.abc import Callable, Collection, Mapping
from functools import partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu.archive import write_archive
from build_fmu.documentation import PICTURES, documentation
from build_fmu.errors import UsageError
from build_fmu.model_description import DRAWING, model_description
from build_fmu.model_description_fmi3 import model_description_fmi3
from build_fmu.package import PYTHON, Package
from build_fmu.payload import digest
from build_fmu.ports import local_variables
from build_fmu.self_check import SelfCheck, self_check
from build_fmu.source_package import model_files
from build_fmu.study.output_folder import require_own_set
from build_fmu.study.settings import Source, entries_of, scene_overrides
from build_fmu.study.ssv import parameter_set
from build_fmu.version import VERSION
from solver.files import is_reserved, write_whole

if TYPE_CHECKING:
    from solver.mechanics.parts import Parts
    from solver.runtime import Model
    from solver.scene import Scene

TOOL = f"holonom {VERSION}"
EARLIEST = 315532800  # 1980-01-01, the date of what has none: two builds must be equal
_NAMESPACE = uuid.UUID("c5a1d8f0-6a0b-5d63-9d3e-6f1f0c0b7e21")


def build_archive(
    scene: str | PathLike[str] | Scene,
    path: str | PathLike[str] | None,
    parameters: Source | None,
    package: Package = PYTHON,
) -> Path:
    """Write the FMU of a scene and its parameter set; see `build_fmu.build`."""
    from solver.mechanics import assemble_parts

    loaded = load_scene(scene, scene_overrides(scene, entries_of(parameters)))
    of_file = isinstance(scene, str | PathLike)
    target = fmu_path(path, Path(scene).stem if of_file else identifier(loaded.name))
    return write_fmu(*assemble_parts(loaded), target, package=package)


def write_fmu(
    parts: Parts,
    model: Model,
    path: str | PathLike[str],
    tell: Callable[[str], object] | None = None,
    package: Package = PYTHON,
    local: Collection[int] | None = None,
) -> Path:
    """Write the FMU of a model, and beside it its parameter set; `path` as in `fmu_path`.

    The scene of its parts travels along, as text and as a picture. `tell` is called
    with what the trial run has to say, which stands on the page of the FMU as well. `local` is what
    `local_variables` finds, where that is known.
    """
    from solver.mechanics.meshes import accuracy
    from solver.scene.reader import collector_paused

    target = fmu_path(path, identifier(model.name))
    beside = target.with_suffix(".ssv")
    require_own_set(target)
    local = local_variables(model, parts.scene) if local is None else local
    with collector_paused():
        seen = self_check(model)
        write_archive(target, archive_entries(parts, model, seen, package, local))
    values = parameter_set(model, date=generation_date(), tool=TOOL, local=local)
    write_whole(beside, values)
    failed = f"warning: the trial run of the default experiment failed: {seen.reason}"
    rough = (s for name, mesh in model.meshes.items() for s in accuracy(name, mesh))
    for sentence in (*rough, *seen.remarks, *([failed] if seen.reason else ())):
        if tell:
            tell(sentence)
    return target


def fmu_path(path: str | PathLike[str] | None, name: str) -> Path:
    """Path of an FMU; a folder or None means `<name>.fmu`, there.

    Raises
    ------
    UsageError
        If the name ends otherwise: parameter set and scene of the same name stand beside it; or if
        it is that of a device.
    """
    target = Path(path or ".")
    target = target / f"{name}.fmu" if target.is_dir() else target
    if is_reserved(target.name):
        text = f"{target}: Windows reserves this name of a file; name another"
        raise UsageError(text)
    if target.exists() and not target.is_file():
        text = f"{target}: an FMU is a file; name one, or a folder for it"
        raise UsageError(text)
    if target.suffix.lower() != ".fmu":
        remedy = f"write {target}.fmu, or make {target} a folder"
        text = f"{target}: the name of an FMU ends in .fmu; {remedy}"
        raise UsageError(text)
    return target


def load_scene(
    scene: str | PathLike[str] | Scene, overrides: Mapping[str, object] | None = None
) -> Scene:
    """Scene of a file with overrides, or the loaded scene itself."""
    from solver.scene import load

    if isinstance(scene, str | PathLike):
        return load(scene, overrides or {})
    if overrides:
        text = "parameters belong to a scene file; give them to solver.load for a loaded scene"
        raise ValueError(text)
    return scene


def archive_entries(
    parts: Parts, model: Model, seen: SelfCheck, package: Package = PYTHON,
    local: Collection[int] = (),
) -> dict[str, bytes]:  # fmt: skip
    """Content of the archive by path."""
    from viewer.drawing import drawing
    from viewer.picture import is_thinned, picture

    name = identifier(model.name)
    entries = package.entries(name, model.sizes)
    entries["resources/model.bin"] = model.file  # for the GUID, which is then in it
    found = drawing(parts.scene)
    entries |= documentation(model, seen, package, thinned=is_thinned(found))
    entries[DRAWING] = json.dumps(found, separators=(",", ":")).encode()
    entries[PICTURES[package.fmi]] = picture(found)
    own_guid = guid(entries)
    entries["resources/model.bin"] = model.with_guid(own_guid)
    of_fmi2 = partial(model_description, native=package.native, sources=package.sources)
    describe = model_description_fmi3 if package.fmi == 3 else of_fmi2
    if package.sources:
        data = entries["resources/model.bin"]
        entries |= model_files(model, data, package.fmi, name)
    entries["modelDescription.xml"] = describe(
        model, identifier=name, guid=own_guid, date=generation_date(), tool=TOOL,
        nominal=seen.nominal, source=parts.scene.source, local=local,
    )  # fmt: skip
    return entries


def identifier(name: str) -> str:
    """C identifier made of a scene's name."""
    text = re.sub(r"\W", "_", name, flags=re.ASCII)
    return f"_{text}" if text[:1].isdigit() else text or "mechanism"


def guid(entries: Mapping[str, bytes]) -> str:
    """Name-based UUID of the archive's content: equal content, equal GUID."""
    return f"{{{uuid.uuid5(_NAMESPACE, digest(entries))}}}"


def generation_date() -> str:
    """SOURCE_DATE_EPOCH as FMI writes it, 1980-01-01 without it."""
    seconds = int(os.environ.get("SOURCE_DATE_EPOCH", EARLIEST))
    return time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds))
