"""Manifests of variants: columns, failures, names, and what a folder held before."""

from __future__ import annotations

import csv
import json
import zipfile
from pathlib import Path

import pytest
from fmpy import read_model_description

import build_fmu
from build_fmu.errors import UsageError
from solver.scene import load
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES

PENDULUM = SCENES / "double_pendulum.toml"
NAMED_LIKE_COLUMNS = """
name = "swing"
dimension = 2
gravity = [0, -9.81]
[parameters]
error = 1.0
fmu = 1.0
variant = 1.0
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["error", 0], mass = "fmu + variant" }
[joints]
rod = { type = "distance", points = ["O", "A"] }
"""


def rows_of(manifest):
    with manifest.open(newline="") as file:
        return list(csv.DictReader(file))


def fmus(folder):
    return sorted(path.name for path in folder.glob("*.fmu"))


def test_parameters_that_are_called_as_a_column_have_columns_of_their_own(tmp_path):
    scene = tmp_path / "swing.toml"
    scene.write_text(NAMED_LIKE_COLUMNS)
    build_fmu.variants(
        scene, tmp_path / "v", grid={"error": [2, 3], "fmu": [4], "variant": [5]}, engine="serial"
    )
    first = rows_of(tmp_path / "v" / "manifest.csv")[0]
    assert (first["variant"], first["fmu"], first["error"]) == ("1", "swing_1.fmu", "")
    varied = [first[f"{name} (parameter)"] for name in ("error", "fmu", "variant")]
    assert varied == ["2", "4", "5"]


@pytest.mark.parametrize("manifest", ["manifest.csv", "manifest.json"])
def test_a_manifest_is_written_where_every_row_fails(tmp_path, manifest):
    with pytest.raises(UsageError):
        build_fmu.variants(
            PENDULUM,
            tmp_path,
            grid={"mass": [-1, float("nan")]},
            manifest=manifest,
            engine="serial",
        )
    text = (tmp_path / manifest).read_text()
    assert text.count("must be >= 1e-06 kg") == 1
    assert text.count("must be a finite number, got nan") == 1
    if manifest.endswith(".json"):
        values = [row["parameters"]["mass"] for row in strictly_read(text)["variants"]]
        assert values == [-1, None]


def strictly_read(text):
    """JSON by the standard, which knows no NaN."""
    return json.loads(text, parse_constant=lambda word: pytest.fail(f"{word} is not JSON"))


def test_numbers_of_one_parameter_are_written_in_one_form(tmp_path):
    grid = {"mass": "1,1.5", "length": [1, 2]}
    made = build_fmu.variants(PENDULUM, tmp_path, grid=grid, engine="serial")
    rows = rows_of(tmp_path / "manifest.csv")
    assert [row["mass"] for row in rows] == ["1.0", "1.0", "1.5", "1.5"]
    assert [row["length"] for row in rows] == ["1", "2", "1", "2"]
    assert [repr(variant.parameters["mass"]) for variant in made] == ["1.0", "1.0", "1.5", "1.5"]


def test_a_mistake_of_the_scene_is_said_once_and_not_for_each_row(capsys, tmp_path):
    arguments = ("--grid", "mass=-1,-2", "--set", "length=0", "-o", tmp_path)
    code, _, err = run(capsys, "variants", PENDULUM, *arguments)
    assert code == 2
    assert err.count("parameters.length.value: must be") == 1
    assert err.count("parameters.mass.value: must be") == 2


# ------------------------------------------------------------------------------------ before


@pytest.mark.parametrize("manifest", ["sub/m.csv", "../m.csv", "/m.csv"])
def test_a_manifest_stands_beside_the_fmus(capsys, tmp_path, manifest):
    arguments = ("--grid", "mass=1,2", "-o", tmp_path / "v", "--manifest", manifest)
    code, out, err = run(capsys, "variants", PENDULUM, *arguments)
    assert (code, out) == (2, "")
    assert err == f"holonom: {manifest}: a manifest stands beside the FMUs; write m.csv\n"
    assert not (tmp_path / "v").exists()


@pytest.mark.parametrize("name", ["manifest.csv", "manifest.json"])
def test_a_file_that_is_no_manifest_is_not_replaced(capsys, tmp_path, name):
    (tmp_path / name).write_text("mine\n")
    arguments = ("--grid", "mass=1,2", "-o", tmp_path, "--manifest", name)
    code, _, err = run(capsys, "variants", PENDULUM, *arguments)
    assert code == 2
    assert "is there and is no manifest of variants; name another with --manifest" in err
    assert (tmp_path / name).read_text() == "mine\n"
    assert not fmus(tmp_path)


def test_fmus_of_an_earlier_study_are_not_left_unmentioned(capsys, tmp_path):
    first = ("variants", PENDULUM, "--grid", "mass=1,2,3", "-o", tmp_path)
    assert run(capsys, *first)[0] == 0
    assert run(capsys, *first)[0] == 0  # the same names: replaced
    other = tmp_path / "double_pendulum_mine.fmu"
    other.write_bytes(b"not one of a study")
    second = ("variants", PENDULUM, "--grid", "mass=1,2", "-o", tmp_path)
    code, _, err = run(capsys, *second)
    assert code == 2
    assert err == (
        f"holonom: {tmp_path}: 1 FMU of an earlier study would stay there, double_pendulum_3.fmu;"
        " name another folder, or remove them with --fresh\n"
    )
    assert run(capsys, *second, "--fresh")[0] == 0
    kept = ["double_pendulum_1.fmu", "double_pendulum_2.fmu"]
    assert fmus(tmp_path) == [*kept, "double_pendulum_mine.fmu"]
    assert not (tmp_path / "double_pendulum_3.ssv").exists()


def test_a_row_that_fails_leaves_no_fmu_of_the_study_before(capsys, tmp_path):
    assert run(capsys, "variants", PENDULUM, "--grid", "mass=1,2", "-o", tmp_path)[0] == 0
    assert run(capsys, "variants", PENDULUM, "--grid", "mass=1,-2", "-o", tmp_path)[0] == 2
    assert fmus(tmp_path) == ["double_pendulum_1.fmu"]


def test_what_build_fmu_did_not_write_is_neither_replaced_nor_removed(capsys, tmp_path):
    mine = tmp_path / "double_pendulum_2.fmu"
    with zipfile.ZipFile(mine, "w") as archive:
        archive.writestr("modelDescription.xml", '<fmiModelDescription generationTool="mine"/>')
    before = mine.read_bytes()
    for grid in ("mass=1,2", "mass=1,-2", "mass=1,2,3"):
        arguments = ("--grid", grid, "--fresh", "-o", tmp_path)
        code, _, err = run(capsys, "variants", PENDULUM, *arguments)
        assert code == 2
        assert f"{mine}: was not written by holonom; move it, or name another folder" in err
        assert mine.read_bytes() == before
    assert run(capsys, "variants", PENDULUM, "--grid", "mass=1", "--fresh", "-o", tmp_path)[0] == 0
    assert mine.read_bytes() == before


# ------------------------------------------------------------------------------------- names


@pytest.mark.parametrize("stem", ["some file", "a.b", "x[1]"])
def test_fmus_are_called_as_the_file_of_the_scene_is(capsys, tmp_path, monkeypatch, stem):
    monkeypatch.chdir(tmp_path)
    scene = tmp_path / f"{stem}.toml"
    scene.write_text(PENDULUM.read_text())
    assert run(capsys, "build", scene)[1] == f"{stem}.fmu\n"
    for values in ("1,2", "3,4"):  # the second study replaces the first
        code, out, _ = run(capsys, "variants", scene, "--grid", f"mass={values}")
        assert (code, out) == (0, f"{Path(f'{stem}_variants', 'manifest.csv')}\n")
        assert fmus(tmp_path / f"{stem}_variants") == [f"{stem}_1.fmu", f"{stem}_2.fmu"]


@pytest.mark.parametrize("output", [(), ("-o", "out")])
def test_two_scenes_of_one_name_make_two_fmus(capsys, tmp_path, monkeypatch, output):
    """The name of the mechanism is that of the model in the FMU; the file has its scene's."""
    monkeypatch.chdir(tmp_path)
    Path("out").mkdir()
    for stem in ("first", "second"):
        Path(f"{stem}.toml").write_text(PENDULUM.read_text())
        path = Path(run(capsys, "build", f"{stem}.toml", *output)[1].strip())
        assert path.name == f"{stem}.fmu"
        assert build_fmu.build(f"{stem}.toml", "out").name == f"{stem}.fmu"
        description = read_model_description(path)
        assert description.coSimulation.modelIdentifier == "double_pendulum"
    assert len(list(Path(*output[1:]).glob("*.fmu"))) == 2


def test_the_fmu_of_a_loaded_scene_is_called_as_the_mechanism(tmp_path):
    assert build_fmu.build(load(PENDULUM), tmp_path).name == "double_pendulum.fmu"


@pytest.mark.parametrize("name", ["x.ssv", "a.v1", "scene.toml", "out"])
def test_the_name_of_an_fmu_ends_in_fmu(capsys, tmp_path, name):
    code, out, err = run(capsys, "build", PENDULUM, "-o", tmp_path / name)
    assert (code, out) == (2, "")
    assert f"{name}: the name of an FMU ends in .fmu; write " in err
    assert not list(tmp_path.iterdir())
    with pytest.raises(UsageError, match="ends in"):
        build_fmu.build(PENDULUM, tmp_path / name)


@pytest.mark.skipif(not Path("/dev/null").exists(), reason="no such device")
def test_an_fmu_is_written_into_no_device(capsys):
    code, out, err = run(capsys, "build", PENDULUM, "-o", "/dev/null")
    assert (code, out) == (2, "")
    assert err == "holonom: /dev/null: an FMU is a file; name one, or a folder for it\n"


def test_each_parameter_set_has_the_whole_name_of_its_fmu(capsys, tmp_path):
    for name in ("a.v1.fmu", "a.v2.fmu"):
        assert run(capsys, "build", PENDULUM, "-o", tmp_path / name)[0] == 0
    found = sorted(path.name for path in tmp_path.iterdir())
    assert found == ["a.v1.fmu", "a.v1.ssv", "a.v2.fmu", "a.v2.ssv"]
