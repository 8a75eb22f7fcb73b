"""Native FMUs for the tests, as `build` makes them, but without trial run, picture and page."""

from __future__ import annotations

import functools
import tempfile
from pathlib import Path

import fmpy

import solver
from build_fmu.export import TOOL, generation_date, guid, identifier
from build_fmu.fmpy_slaves import FMU3Run
from build_fmu.instance import Log
from build_fmu.model_description import model_description
from build_fmu.model_description_fmi3 import model_description_fmi3
from build_fmu.package import chosen_package
from build_fmu.platforms import library_scope
from solver.runtime import Model
from tests.support.fmus.fmu_instance import SCENES, packed

_FOLDER = tempfile.TemporaryDirectory(prefix="native-", ignore_cleanup_errors=True)


@functools.cache
def native_scene_fmu(name: str, fmi: int = 2) -> Path:
    """Native FMU of a file in scenes/."""
    return native_fmu(solver.assemble(solver.load(SCENES / f"{name}.toml")), fmi)


def native_fmu(model: Model, fmi: int = 2, scope: str = "") -> Path:
    """Native FMU of a model, with its library or, if `scope` is given, that one."""
    name = identifier(model.name)
    scope = scope or library_scope(model.sizes)
    sizes = model.sizes | {"unilateral": scope == "contacts", "n_bodies": scope == "bodies"}
    entries = chosen_package(True, fmi).entries(name, sizes)
    entries["resources/model.bin"] = model.file
    own = guid(entries)
    entries["resources/model.bin"] = model.with_guid(own)
    of_fmi2 = functools.partial(model_description, native=True)
    describe = model_description_fmi3 if fmi == 3 else of_fmi2
    date = generation_date()
    text = describe(model, identifier=name, guid=own, date=date, tool=TOOL)
    entries["modelDescription.xml"] = text
    path = Path(_FOLDER.name, f"{name}_{own[1:9]}_{fmi}.fmu")
    path.write_bytes(packed(entries))
    return path


def slave_of_fmi3(path: Path, folder: str, log: Log | None = None) -> FMU3Run:
    """Return an instance of an FMU of FMI 3.0, unpacked into a folder."""
    description = fmpy.read_model_description(str(path))
    fmpy.extract(str(path), folder)
    assert description.coSimulation
    made = FMU3Run(
        guid=description.guid, unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
    )  # fmt: skip
    made.make(log or Log())
    return made
