"""Files of sweeps: continued after an interruption, never mixed, refused where damaged."""

from __future__ import annotations

import contextlib
import csv
import importlib.util
import os
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import build_fmu
from build_fmu.errors import UsageError
from build_fmu.study import sweep as sweep_module
from build_fmu.study.plan import Plan, Result
from build_fmu.study.stores import store_for
from tests.study.test_sweep import BROKEN, GRID, OUTPUTS
from tests.support.fmus.fmu_instance import pendulum

KINDS = ["csv", *(["h5"] if importlib.util.find_spec("h5py") else [])]
ARGUMENTS = {"grid": GRID, "outputs": OUTPUTS, "engine": "serial"}


def files_of(tmp_path) -> list[Path]:
    return [tmp_path / f"a.{kind}" for kind in KINDS]


def swept(path, **more):
    return build_fmu.sweep(pendulum(), path=path, **{**ARGUMENTS, **more})


def interrupt(*_, **__):
    raise KeyboardInterrupt


# ------------------------------------------------------------------------------------ continued

numbers = st.floats(allow_nan=False)
texts = st.text('aä,"\n', max_size=3)
rows = st.fixed_dictionaries({"a": numbers, "on": st.booleans(), "t": texts})
plans = st.builds(
    lambda rows, outputs: Plan("a.fmu", "", rows, {}, outputs, [0.0, 1.0], {}),
    st.lists(rows, min_size=1, max_size=5),
    st.lists(st.sampled_from(["x", "y"]), unique=True),
)


def made(path: Path, plan: Plan) -> tuple[list[int], list]:
    """Runs that are made for a file, and the results of all; those of every third one fail."""
    with contextlib.closing(store_for(path, plan)) as store:
        left = [at + 1 for at in (~store.is_done).nonzero()[0].tolist()]
        for run in reversed(left):
            numbers = [run / 3, -0.0, np.nan] * len(plan.outputs)
            values = np.full((2 if run % 3 else 1, len(plan.outputs)), run / 7)
            store.keep(Result(run, run / 9, "" if run % 3 else "lost, ä", numbers, values))
        return left, store.table.tolist()


DAMAGES = {
    "gone": lambda _cells: [],
    "cut": lambda cells: cells[:-1],
    "of no run": lambda cells: ["0", *cells[1:]],
    "of another run": lambda cells: [str(int(cells[0]) + 100), *cells[1:]],
    "no number": lambda cells: ["x", *cells[1:]],
    "of other values": lambda cells: [cells[0], "0.123", *cells[2:]],
}


@given(plans, st.lists(st.sampled_from([*DAMAGES, ""]), min_size=5, max_size=5))
def test_a_line_that_is_not_whole_or_has_other_values_is_run_again_and_no_other(plan, damages):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "a.csv")
        runs, whole = made(path, plan)
        assert runs == [*range(1, plan.count + 1)]
        before = path.read_bytes()
        with path.open(newline="") as file:
            head, *lines = csv.reader(file)
        damaged = [
            DAMAGES[damage](line) if damage else line
            for line, damage in zip(lines, damages, strict=False)
        ]
        with path.open("w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([head, *filter(None, damaged)])
        again, results = made(path, plan)
        assert again == [run for run in runs if damages[run - 1]]
        assert repr(results) == repr(whole)
        assert path.read_bytes() == before


@pytest.mark.skipif("h5" not in KINDS, reason="no h5py")
@settings(max_examples=40)  # a file of HDF5 takes 10 ms
@given(plans, st.sets(st.integers(0, 4)), st.sampled_from(["run", "a", "on"]))
def test_a_run_of_other_values_in_hdf5_is_made_again_and_no_other(plan, damaged, column):
    import h5py

    damaged = {at for at in damaged if at < plan.count}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "a.h5")
        _, whole = made(path, plan)
        with h5py.File(path, "r+") as file:
            runs = file["runs"][:]
            for at in damaged:
                runs[column][at] = 1 - runs[column][at] if column != "a" else np.pi
            file["runs"][:] = runs
            assert repr([*file["time"]]) == repr([*map(np.float64, plan.times)])
        again, results = made(path, plan)
    assert again == [at + 1 for at in sorted(damaged)]
    assert repr(results) == repr(whole)


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


# -------------------------------------------------------------------------- never mixed, refused


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


def edited(old: str, new: str, name: str = "a.csv"):
    """Damage of a text file, all of which `old` is if it is empty."""

    def edit(folder: Path) -> None:
        text = (folder / name).read_text()
        (folder / name).write_text(text.replace(old, new, 1) if old else new)

    return edit


def no_text(folder: Path) -> None:
    (folder / "a.csv").write_bytes((folder / "a.csv").read_bytes()[:-4] + b"\xff\xfe\n")


def in_hdf5(damage):
    """Damage of the open HDF5 file."""

    def edit(folder: Path) -> None:
        h5py = pytest.importorskip("h5py")
        with h5py.File(folder / "a.h5", "r+") as file:
            damage(file)

    return edit


def other_runs(file) -> None:
    del file["runs"]
    file["runs"] = np.ones(3)


def another_column(file) -> None:
    runs = file["runs"][:]
    runs.dtype.names = [name.replace("A.x.final", "A.y.final") for name in runs.dtype.names]
    del file["runs"]
    file["runs"] = runs


DAMAGED = {
    "half a plan": edited("", "{", "a.csv.plan.json"),
    "a list for a plan": edited("", "[]", "a.csv.plan.json"),
    "an empty plan": edited("", "", "a.csv.plan.json"),
    "varied in another order": edited("length,mass", "mass,length"),
    "another output": edited("A.x.final", "A.y.final"),
    "another column of its own": edited("run,", "Run,"),
    "no text": no_text,
    "h5: no plan": in_hdf5(lambda file: file.attrs.pop("plan")),
    "h5: half a plan": in_hdf5(lambda file: file.attrs.modify("plan", file.attrs["plan"][:20])),
    "h5: a number for a plan": in_hdf5(lambda file: file.attrs.create("plan", 7)),
    "h5: no runs": in_hdf5(lambda file: file.pop("runs")),
    "h5: other runs": in_hdf5(other_runs),
    "h5: another column": in_hdf5(another_column),
    "h5: a trajectory gone": in_hdf5(lambda file: file["trajectories"].pop("A.x")),
}


@pytest.mark.parametrize("damage", DAMAGED)
def test_a_damaged_file_is_refused_with_a_sentence_until_it_is_made_anew(tmp_path, damage):
    kind = "h5" if damage.startswith("h5") else "csv"
    if kind not in KINDS:
        pytest.skip("no h5py")
    swept(tmp_path / f"a.{kind}")
    DAMAGED[damage](tmp_path)
    with pytest.raises(UsageError, match=rf"a\.{kind} is damaged, or not the file of a.*--fresh"):
        swept(tmp_path / f"a.{kind}")
    assert swept(tmp_path / f"a.{kind}", fresh=True)["finished"].all()


def test_an_hdf5_file_that_is_not_made_whole_is_not_left(tmp_path, monkeypatch):
    h5py = pytest.importorskip("h5py")
    file = tmp_path / "a.h5"
    with monkeypatch.context() as patch:
        patch.setattr(h5py.Group, "create_group", interrupt)
        with pytest.raises(KeyboardInterrupt):
            swept(file)
    assert list(tmp_path.iterdir()) == []
    assert swept(file)["finished"].all()


def test_an_output_that_hdf5_takes_for_a_group_is_refused(tmp_path):
    pytest.importorskip("h5py")
    plan = Plan("a.fmu", "", [{}], {}, ["rod/x"], [0.0, 1.0], {})
    with pytest.raises(UsageError, match=r"'rod/x'.*write a \.csv, or leave it out"):
        store_for(tmp_path / "a.h5", plan)
    assert list(tmp_path.iterdir()) == []
    store_for(tmp_path / "a.csv", plan).close()


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


def test_all_values_of_a_parameter_are_written_alike(tmp_path):
    build_fmu.sweep(pendulum(), grid=["mass=2,3:4:3"], path=tmp_path / "a.csv", engine="serial")
    rows = (tmp_path / "a.csv").read_text().splitlines()
    assert [row.split(",")[1] for row in rows] == ["mass", "2.0", "3.0", "3.5", "4.0"]


def test_trajectories_that_nobody_asked_for_are_in_the_file_alone(tmp_path):
    pytest.importorskip("h5py")
    for _ in range(2):  # made, then read
        found = swept(tmp_path / "a.h5", form="sweep")
        assert found.trajectories is None
    whole = swept(tmp_path / "a.h5", trajectories=True)
    np.testing.assert_array_equal(whole["A.x"], swept(None, trajectories=True)["A.x"])


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
