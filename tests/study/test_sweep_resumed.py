"""A file of results is the one of its sweep: in every line, and after every interruption."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import build_fmu
from build_fmu.errors import UsageError
from build_fmu.study import sweep as sweep_module
from tests.fmu_instance import pendulum
from tests.study.test_sweep import GRID, OUTPUTS

ARGUMENTS = {"grid": GRID, "outputs": OUTPUTS, "engine": "serial"}


def swept(path, **more):
    return build_fmu.sweep(pendulum(), path=path, **{**ARGUMENTS, **more})


def interrupt(*_, **__):
    raise KeyboardInterrupt


@pytest.fixture
def begun(monkeypatch) -> list[int]:
    """Numbers of the runs that are made."""
    numbers: list[int] = []
    one = sweep_module.run_row

    def counted(shared, job):
        numbers.append(job[0])
        return one(shared, job)

    monkeypatch.setattr(sweep_module, "run_row", counted)
    return numbers


def test_a_fresh_sweep_that_is_interrupted_at_once_leaves_none_of_the_old_results(
    tmp_path, monkeypatch
):
    file = tmp_path / "a.csv"
    swept(file, stop_time=0.3)
    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", interrupt)
        with pytest.raises(KeyboardInterrupt):
            swept(file, stop_time=0.5, fresh=True)
    assert swept(file, stop_time=0.5).tolist() == swept(None, stop_time=0.5).tolist()


def test_an_hdf5_file_that_was_not_made_whole_is_refused(tmp_path, monkeypatch):
    h5py = pytest.importorskip("h5py")
    file = tmp_path / "a.h5"
    with monkeypatch.context() as patch:
        patch.setattr(h5py.Group, "create_group", interrupt)
        with pytest.raises(KeyboardInterrupt):
            swept(file)
    with pytest.raises(UsageError, match=r"a\.h5 is damaged.*--fresh"):
        swept(file)
    assert swept(file, fresh=True)["finished"].all()


@pytest.mark.parametrize(
    ("old", "new"),
    [("length,mass", "mass,length"), ("A.x.final", "A.y.final"), ("run,", "Run,")],
    ids=["varied", "output", "own"],
)
def test_a_summary_with_another_first_line_is_refused(tmp_path, old, new):
    file = tmp_path / "a.csv"
    swept(file)
    file.write_text(file.read_text().replace(old, new, 1))
    with pytest.raises(UsageError, match=r"a\.csv is damaged.*its first line.*--fresh"):
        swept(file)


@pytest.mark.parametrize(("old", "new"), [("2,0.5,2.0,", "2,0.5,2.5,"), ("5,1.0,", "5,0.5,")])
def test_a_line_of_other_values_is_run_again(tmp_path, begun, old, new):
    file = tmp_path / "a.csv"
    whole = swept(file)
    text = file.read_text()
    assert f"\n{old}" in text
    file.write_text(text.replace(f"\n{old}", f"\n{new}"))
    begun.clear()
    assert swept(file).tolist() == whole.tolist()
    assert begun == [int(old[0])]
    assert file.read_text() == text


def test_a_run_of_other_values_in_hdf5_is_made_again(tmp_path, begun):
    h5py = pytest.importorskip("h5py")
    path = tmp_path / "a.h5"
    whole = swept(path)
    with h5py.File(path, "r+") as file:
        row = file["runs"][3]
        row["mass"] = 9.0
        file["runs"][3] = row
    begun.clear()
    assert swept(path).tolist() == whole.tolist()
    assert begun == [4]


def test_runs_in_hdf5_with_another_column_are_refused(tmp_path):
    h5py = pytest.importorskip("h5py")
    path = tmp_path / "a.h5"
    swept(path)
    with h5py.File(path, "r+") as file:
        runs = file["runs"][:]
        del file["runs"]
        names = [name.replace("A.x.final", "A.y.final") for name in runs.dtype.names]
        kinds = [runs.dtype[name] for name in runs.dtype.names]
        file["runs"] = runs.astype(np.dtype(list(zip(names, kinds, strict=True))))
    with pytest.raises(UsageError, match=r"a\.h5 is damaged"):
        swept(path)


def test_trajectories_that_nobody_asked_for_are_in_the_file_alone(tmp_path):
    pytest.importorskip("h5py")
    for _ in range(2):  # made, then read
        found = swept(tmp_path / "a.h5", form="sweep")
        assert found.trajectories is None
    whole = swept(tmp_path / "a.h5", trajectories=True)
    np.testing.assert_array_equal(whole["A.x"], swept(None, trajectories=True)["A.x"])
