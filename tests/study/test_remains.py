"""What a study of variants leaves in its folder: what its manifest says, however it ends."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

import build_fmu
from build_fmu.errors import EnvironmentLackError, UnfinishedError
from build_fmu.study import variants as variants_module
from build_fmu.study.processes import DIED
from tests.support.fmus.commands import run
from tests.support.fmus.crashing_runs import crashing_export
from tests.support.fmus.fmu_instance import SCENES

PENDULUM = SCENES / "double_pendulum.toml"
FOREIGN = '<ssv:ParameterSet generationTool="mine"/>'


def told(folder: Path) -> list[str]:
    """FMUs that the manifest has."""
    with (folder / "manifest.csv").open(newline="") as file:
        return [row["fmu"] for row in csv.DictReader(file) if row["fmu"]]


def found(folder: Path, kind: str) -> list[str]:
    return sorted(path.name for path in folder.iterdir() if path.suffix == kind)


def stopped_after(count: int):
    """A progress that interrupts a study."""

    def stop(done, _):
        if done == count:
            raise KeyboardInterrupt

    return stop


def written_ahead(shared, jobs):
    """Variants that are written, and of which only the first is reported in time."""
    made = [variants_module._export(shared, job) for job in jobs]
    yield made[0]
    raise KeyboardInterrupt


def test_an_interrupted_study_leaves_what_its_manifest_has_and_no_more(tmp_path, monkeypatch):
    """Processes write ahead of what is reported."""

    def run_ahead(_, __):
        return lambda task, jobs: written_ahead(task.shared, jobs)

    monkeypatch.setattr(variants_module, "engine_of", run_ahead)
    killed = tmp_path / ".double_pendulum.variants"
    killed.mkdir()
    (killed / "double_pendulum_1.ssv").write_bytes(b"of a study that was killed")
    with pytest.raises(KeyboardInterrupt):
        build_fmu.variants(PENDULUM, tmp_path, grid={"mass": [1, 2, 3]})
    assert found(tmp_path, ".fmu") == told(tmp_path) == ["double_pendulum_1.fmu"]
    assert found(tmp_path, ".ssv") == ["double_pendulum_1.ssv"]
    assert len(list(tmp_path.iterdir())) == 3


def test_an_interrupted_study_leaves_none_of_the_study_before(tmp_path):
    grid = {"mass": [1, 2, 3]}
    build_fmu.variants(PENDULUM, tmp_path, grid=grid, engine="serial")
    with pytest.raises(KeyboardInterrupt):
        build_fmu.variants(
            PENDULUM, tmp_path, grid=grid, engine="serial", progress=stopped_after(1)
        )
    assert found(tmp_path, ".fmu") == told(tmp_path) == ["double_pendulum_1.fmu"]
    assert found(tmp_path, ".ssv") == ["double_pendulum_1.ssv"]


def test_a_study_that_did_not_begin_leaves_the_one_before_as_it_is(tmp_path, monkeypatch):
    build_fmu.variants(PENDULUM, tmp_path, grid={"mass": [1, 2]}, engine="serial")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}

    def refused(_, __):
        text = "no scheduler answers"
        raise EnvironmentLackError(text)
        yield

    monkeypatch.setattr(variants_module, "engine_of", lambda _, __: refused)
    with pytest.raises(EnvironmentLackError):
        build_fmu.variants(PENDULUM, tmp_path, grid={"mass": [3, 4, 5]}, fresh=True)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_a_parameter_set_of_others_is_neither_replaced_nor_removed(capsys, tmp_path):
    mine = tmp_path / "double_pendulum_2.ssv"
    mine.write_text(FOREIGN)
    for grid in ("mass=1,2", "mass=1,-2"):
        code, _, err = run(capsys, "variants", PENDULUM, "--grid", grid, "-o", tmp_path)
        assert code == 2
        assert f"{mine}: was not written by holonom; move it, or name another folder" in err
    assert [path.name for path in tmp_path.iterdir()] == [mine.name]
    assert mine.read_text() == FOREIGN
    assert run(capsys, "variants", PENDULUM, "--grid", "mass=1", "-o", tmp_path)[0] == 0
    assert mine.read_text() == FOREIGN


def test_build_does_not_replace_a_parameter_set_of_others(capsys, tmp_path):
    mine = tmp_path / "a.ssv"
    mine.write_text(FOREIGN)
    code, out, err = run(capsys, "build", PENDULUM, "-o", tmp_path / "a.fmu")
    assert (code, out) == (2, "")
    assert err == f"holonom: {mine}: was not written by holonom; move it, or name another FMU\n"
    with pytest.raises(build_fmu.errors.UsageError, match="was not written by holonom"):
        build_fmu.build(PENDULUM, tmp_path / "a.fmu")
    assert [path.name for path in tmp_path.iterdir()] == [mine.name]
    mine.unlink()
    assert run(capsys, "build", PENDULUM, "-o", tmp_path / "a.fmu")[0] == 0
    assert run(capsys, "build", PENDULUM, "-o", tmp_path / "a.fmu")[0] == 0


@pytest.mark.parametrize("name", ["a.fmu", "there"])
def test_variants_go_into_a_folder(capsys, tmp_path, name):
    (tmp_path / "there").write_text("mine")
    code, out, err = run(capsys, "variants", PENDULUM, "--grid", "mass=1,2", "-o", tmp_path / name)
    assert (code, out) == (2, "")
    wanted = "there will be many FMUs; name a folder for them, not a file"
    assert err == f"holonom: {tmp_path / name}: {wanted}\n"
    assert [path.name for path in tmp_path.iterdir()] == ["there"]


def test_a_row_that_can_be_read_and_makes_no_mechanism_is_one_of_the_manifest(capsys, tmp_path):
    """One that cannot be read is none: nothing is written then, and all mistakes are said."""
    table = tmp_path / "table.csv"
    folder = tmp_path / "v"
    table.write_text("mass,length\n1,\n2\n3,1\n")
    code, _, err = run(capsys, "variants", PENDULUM, "--table", table, "-o", folder)
    assert (code, folder.exists()) == (2, False)
    assert f"{table}:2: error: length: an empty cell" in err
    assert f"{table}:3: error: has 1 cell, and the header has 2" in err
    table.write_text("mass,length\n1,abc\n3,1\n")
    code, _, err = run(capsys, "variants", PENDULUM, "--table", table, "-o", folder)
    assert code == 2
    assert f"{table}:2: error: parameters.length.value: " in err
    assert told(folder) == found(folder, ".fmu") == ["double_pendulum_2.fmu"]


def test_a_variant_whose_process_died_ends_with_3_and_the_others_are_written(tmp_path, monkeypatch):
    monkeypatch.setattr(variants_module, "_export", crashing_export)
    with pytest.raises(UnfinishedError, match=f"variant 2: error: {DIED}") as caught:
        build_fmu.variants(PENDULUM, tmp_path, grid={"mass": [1, 2, 3]}, engine="processes:2")
    assert caught.value.code == 3
    assert found(tmp_path, ".fmu") == told(tmp_path)
    assert told(tmp_path) == ["double_pendulum_1.fmu", "double_pendulum_3.fmu"]
