"""Libraries of native FMUs serve points and bars, bodies too, or contacts as well."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

import solver
from build_fmu.instance import Log
from build_fmu.platforms import SCOPES, library_path, library_scope, own_platform
from solver.runtime import Model
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, instance
from tests.support.fmus.native_fmus import native_fmu, native_scene_fmu, slave_of_fmi3

ROOT = Path(__file__).parents[2]
STEPS = 20


def model_of(name: str) -> Model:
    return solver.assemble(solver.load(SCENES / f"{name}.toml"))


@pytest.mark.parametrize("name", ["double_pendulum", "four_bar", "bricard", "stewart"])
def test_a_model_has_the_same_bits_in_each_library_that_serves_it(name):
    found = []
    model = model_of(name)
    for scope in SCOPES[SCOPES.index(library_scope(model.sizes)) :]:
        h = model.experiment.step_size
        with instance(native_fmu(model, scope=scope)) as fmu:
            fmu.initialise()
            rows = [fmu.outputs()]
            for k in range(STEPS):
                assert fmu.step(k * h, h)
                rows.append(fmu.outputs())
        found.append(rows)
    assert len(found) > 1
    assert all(rows == found[0] for rows in found)


@pytest.mark.parametrize(
    ("name", "scope", "parts"),
    [
        ("bouncing_ball", "bodies", "contacts or frictions"),
        ("pendulum_with_stop", "bodies", "contacts or frictions"),
        ("bricard", "points", "rigid bodies"),
    ],
)
def test_a_library_refuses_a_model_that_it_does_not_serve(name, scope, parts, tmp_path):
    log = Log()
    with pytest.raises(Exception, match="instantiate"):
        slave_of_fmi3(native_fmu(model_of(name), 3, scope), str(tmp_path), log)
    told = f"it has {parts}, and this library is for models without them"
    assert told in str(log.messages)


@pytest.mark.parametrize(
    ("name", "library"),
    [
        ("double_pendulum", "planar_points"),
        ("bricard", "spatial_bodies"),
        ("pendulum_with_stop", "planar_contacts"),
        ("die_in_a_bowl", "spatial_contacts"),
    ],
)
def test_an_fmu_has_the_library_of_its_model_and_info_names_it(capsys, name, library):
    fmu, model = native_scene_fmu(name), model_of(name)
    scope = library_scope(model.sizes)
    path = library_path(ROOT / "fmu_src", own_platform(), model.sizes["dim"], scope)
    assert path.stem == library
    with zipfile.ZipFile(fmu) as archive:
        binary = next(name for name in archive.namelist() if name.startswith("binaries/"))
        assert archive.read(binary) == path.read_bytes()
    assert f"native ({library}), {own_platform()}" in run(capsys, "info", fmu)[1]
