"""Files of sweeps: continued after an interruption, never mixed, refused where damaged."""

from __future__ import annotations

import importlib.util
import os

import numpy as np
import pytest

import build_fmu
from build_fmu.errors import UsageError
from build_fmu.study import sweep as sweep_module
from build_fmu.study.plan import Plan
from build_fmu.study.stores import store_for
from tests.fmu_instance import pendulum
from tests.study.test_sweep import BROKEN, GRID, OUTPUTS


def files_of(tmp_path) -> list:
    kinds = [".csv", *([".h5"] if importlib.util.find_spec("h5py") else [])]
    return [tmp_path / f"a{kind}" for kind in kinds]


def test_an_interrupted_sweep_goes_on_where_it_stopped(tmp_path, monkeypatch):
    whole = build_fmu.sweep(pendulum(), grid=GRID, outputs=OUTPUTS, engine="serial")
    arguments = {"grid": GRID, "outputs": OUTPUTS, "engine": "serial"}
    one = sweep_module.run_row
    for file in files_of(tmp_path):
        begun = []

        def interrupted(shared, job, begun=begun):
            begun.append(job[0])
            if len(begun) == 4:
                raise KeyboardInterrupt
            return one(shared, job)

        monkeypatch.setattr(sweep_module, "run_row", interrupted)
        with pytest.raises(KeyboardInterrupt):
            build_fmu.sweep(pendulum(), path=file, **arguments)
        again = build_fmu.sweep(pendulum(), path=file, **arguments)
        assert begun == [1, 2, 3, 4, 4, 5, 6]
        assert again.tolist() == whole.tolist()


def test_a_line_that_was_cut_off_is_run_again(tmp_path):
    file = tmp_path / "a.csv"
    arguments = {"grid": GRID, "outputs": OUTPUTS, "path": file, "engine": "serial"}
    whole = build_fmu.sweep(pendulum(), **arguments)
    text = file.read_text()
    file.write_text(text[:-40])
    assert build_fmu.sweep(pendulum(), **arguments).tolist() == whole.tolist()
    assert file.read_text() == text


def test_a_plan_that_is_damaged_is_refused(tmp_path):
    file = tmp_path / "a.csv"
    build_fmu.sweep(pendulum(), grid=GRID, path=file, engine="serial")
    for text in ("{", "[]", ""):
        (tmp_path / "a.csv.plan.json").write_text(text)
        with pytest.raises(UsageError, match=r"a\.csv is damaged.*--fresh"):
            build_fmu.sweep(pendulum(), grid=GRID, path=file)


def test_another_sweep_is_not_mixed_into_a_file(tmp_path):
    for file in files_of(tmp_path):
        build_fmu.sweep(pendulum(), grid=GRID, path=file, engine="serial")
        with pytest.raises(UsageError, match="holds another sweep, which differs in times;"):
            build_fmu.sweep(pendulum(), grid=GRID, path=file, stop_time=0.5)
        with pytest.raises(UsageError, match="which differs in FMU;"):
            build_fmu.sweep(pendulum(mass=2), grid=GRID, path=file)
        arguments = {"grid": {"mass": [7]}, "outputs": ["A.y"], "stop_time": 0.5}
        with pytest.raises(UsageError, match="which differs in values, outputs and times;"):
            build_fmu.sweep(pendulum(), path=file, **arguments)
        build_fmu.sweep(pendulum(), grid=GRID, path=file, stop_time=0.5, fresh=True)
    (tmp_path / "b.csv").write_text("mine\n")
    with pytest.raises(UsageError, match="is not one of a sweep"):
        build_fmu.sweep(pendulum(), grid=GRID, path=tmp_path / "b.csv")
    assert (tmp_path / "b.csv").read_text() == "mine\n"


def test_a_file_that_holds_no_sweep_is_never_removed(tmp_path):
    notes = tmp_path / "notes.txt"
    notes.write_text("kept")
    with pytest.raises(UsageError, match=r"\.csv"):
        build_fmu.sweep(pendulum(), grid=GRID, outputs=OUTPUTS, path=notes, fresh=True)
    assert notes.read_text() == "kept"


def test_other_communication_steps_are_another_sweep(tmp_path):
    # Both have five points up to the stop time.
    path = tmp_path / "runs.csv"
    grid = {"mass": [1.0]}
    build_fmu.sweep(pendulum(), grid=grid, path=path, stop_time=1.0, step_size=0.3)
    with pytest.raises(UsageError, match="times"):
        build_fmu.sweep(pendulum(), grid=grid, path=path, stop_time=1.0, step_size=0.25)


# ----------------------------------------------------------------------------- what is in them


def test_hdf5_has_summary_and_trajectories(tmp_path):
    h5py = pytest.importorskip("h5py")
    arguments = {"outputs": OUTPUTS, "trajectories": True, "engine": "serial"}
    build_fmu.sweep(pendulum(), grid=BROKEN, path=tmp_path / "a.h5", **arguments)
    found = build_fmu.sweep(pendulum(), grid=BROKEN, **arguments)
    with h5py.File(tmp_path / "a.h5") as file:
        assert list(file["runs"]["finished"]) == [True, False, True]
        assert list(file["runs"]["mass"]) == BROKEN["mass"]
        assert file["trajectories/A.x"].attrs["unit"] == "m"
        np.testing.assert_array_equal(file["trajectories/A.x"][:], found["A.x"])
        np.testing.assert_array_equal(file["time"][:], found["time"][0])


def test_trajectories_that_a_summary_does_not_have_are_run(tmp_path):
    arguments = {"grid": GRID, "outputs": OUTPUTS, "engine": "serial"}
    whole = build_fmu.sweep(pendulum(), trajectories=True, **arguments)
    for file in files_of(tmp_path):
        build_fmu.sweep(pendulum(), path=file, **arguments)
        before = file.read_bytes()
        again = build_fmu.sweep(pendulum(), path=file, trajectories=True, **arguments)
        np.testing.assert_array_equal(again["A.x"], whole["A.x"])
        if file.suffix == ".csv":
            assert file.read_bytes() == before


def test_a_sweep_without_outputs_is_continued_too(tmp_path):
    for file in files_of(tmp_path):
        for _ in range(2):
            found = build_fmu.sweep(pendulum(), grid=BROKEN, outputs=[], path=file)
            assert list(found["finished"]) == [True, False, True]


def test_all_values_of_a_parameter_are_written_alike(tmp_path):
    build_fmu.sweep(pendulum(), grid=["mass=2,3:4:3"], path=tmp_path / "a.csv", engine="serial")
    rows = (tmp_path / "a.csv").read_text().splitlines()
    assert [row.split(",")[1] for row in rows] == ["mass", "2.0", "3.0", "3.5", "4.0"]


# ----------------------------------------------------------------------------------- what is not


@pytest.mark.parametrize("run", ["0", "7", "x"])
def test_a_line_of_no_run_of_the_sweep_is_run_again(tmp_path, run):
    file = tmp_path / "a.csv"
    arguments = {"grid": GRID, "outputs": OUTPUTS, "path": file, "engine": "serial"}
    whole = build_fmu.sweep(pendulum(), **arguments)
    text = file.read_text()
    file.write_text(text.replace("\n3,", f"\n{run},"))
    assert build_fmu.sweep(pendulum(), **arguments).tolist() == whole.tolist()
    assert file.read_text() == text


def test_a_summary_that_is_no_text_is_refused(tmp_path):
    file = tmp_path / "a.csv"
    build_fmu.sweep(pendulum(), grid=GRID, path=file, engine="serial")
    file.write_bytes(file.read_bytes()[:-4] + b"\xff\xfe\n")
    with pytest.raises(UsageError, match=r"a\.csv is damaged"):
        build_fmu.sweep(pendulum(), grid=GRID, path=file)


def without_plan(file) -> None:
    del file.attrs["plan"]


def with_half_a_plan(file) -> None:
    file.attrs["plan"] = file.attrs["plan"][:20]


def with_a_number_for_a_plan(file) -> None:
    file.attrs["plan"] = 7


def without_runs(file) -> None:
    del file["runs"]


def with_other_runs(file) -> None:
    del file["runs"]
    file["runs"] = np.ones(3)


def without_a_trajectory(file) -> None:
    del file["trajectories/A.x"]


@pytest.mark.parametrize(
    "damage",
    [
        without_plan,
        with_half_a_plan,
        with_a_number_for_a_plan,
        without_runs,
        with_other_runs,
        without_a_trajectory,
    ],
)
def test_a_damaged_hdf5_file_is_refused_with_a_sentence(tmp_path, damage):
    h5py = pytest.importorskip("h5py")
    path = tmp_path / "a.h5"
    arguments = {"grid": GRID, "outputs": OUTPUTS, "path": path, "engine": "serial"}
    build_fmu.sweep(pendulum(), **arguments)
    with h5py.File(path, "r+") as file:
        damage(file)
    with pytest.raises(UsageError, match=r"a\.h5 is damaged, or not the file of a sweep.*--fresh"):
        build_fmu.sweep(pendulum(), **arguments)
    assert build_fmu.sweep(pendulum(), fresh=True, **arguments)["finished"].all()


def test_an_output_that_hdf5_takes_for_a_group_is_refused(tmp_path):
    pytest.importorskip("h5py")
    plan = Plan("a.fmu", "", [{}], {}, ["rod/x"], [0.0, 1.0], {})
    with pytest.raises(UsageError, match=r"'rod/x'.*write a \.csv, or leave it out"):
        store_for(tmp_path / "a.h5", plan)
    assert list(tmp_path.iterdir()) == []
    store_for(tmp_path / "a.csv", plan).close()


# ----------------------------------------------------------------------------------- two at a time


@pytest.mark.skipif(os.name == "nt", reason="no flock")
@pytest.mark.parametrize("fresh", [False, True])
def test_a_file_takes_one_sweep_at_a_time(tmp_path, fresh):
    arguments = {"grid": GRID, "outputs": OUTPUTS, "engine": "serial"}
    for file in files_of(tmp_path):
        refused = []

        def second(done, _count, file=file, refused=refused):
            if done == 3:
                with pytest.raises(UsageError, match="in use: another sweep") as caught:
                    build_fmu.sweep(pendulum(), path=file, fresh=fresh, **arguments)
                refused.append(caught.value)

        found = build_fmu.sweep(pendulum(), path=file, progress=second, **arguments)
        assert found["finished"].all()
        assert len(refused) == 1
        again = build_fmu.sweep(pendulum(), path=file, **arguments)
        assert again.tolist() == found.tolist()
