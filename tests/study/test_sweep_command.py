"""The command `sweep`: its files, extremes of the runs that came to their end, mistakes."""

from __future__ import annotations

import csv
import json
import sys
import warnings

import pytest

import build_fmu
from build_fmu.study import dask_workers
from tests.physics.test_order_limits import LIMITED, text
from tests.study.test_sweep import GRID, OUTPUTS
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import pendulum, text_fmu


def lines(path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def test_the_command_writes_a_summary_and_prints_the_extremes(capsys, tmp_path):
    grids = ("--grid", "length=0.5:1:2", "--grid", "mass=1,2,3", "--output", ",".join(OUTPUTS))
    file = tmp_path / "a.csv"
    code, out, err = run(capsys, "sweep", pendulum(), *grids, "-o", file, "--json")
    assert (code, err) == (0, "")
    document = json.loads(out)
    assert (document["runs"], document["failed"], document["resumed"]) == (6, [], 0)
    found = build_fmu.sweep(pendulum(), grid=GRID, outputs=OUTPUTS)
    rows = lines(file)
    assert [float(row["A.x.final"]) for row in rows] == list(found["A.x.final"])
    assert [float(row["length"]) for row in rows] == list(found["length"])
    assert document["outputs"]["A.x"]["min"] == found["A.x.min"].min()
    code, out, _ = run(capsys, "sweep", pendulum(), *grids, "-o", file)
    assert code == 0
    assert "6 runs, none failed; all of them were there from before" in out


def test_a_failed_run_ends_the_command_with_3_and_its_reason(capsys, tmp_path):
    arguments = ("--grid", "mass=1,-1,2", "--output", "A.x", "-o", tmp_path / "a.csv")
    code, out, err = run(capsys, "sweep", pendulum(), *arguments)
    assert code == 3
    assert "3 runs, 1 failed" in out
    assert err.startswith("holonom: run 2 ended at t = 0 s: ")
    assert [row["finished"] for row in lines(tmp_path / "a.csv")] == ["true", "false", "true"]


@pytest.mark.parametrize(
    ("masses", "extremes"),
    [
        ("1,-1,2", {"reach": {"min": 1.0, "run_of_min": 1, "max": 1.0, "run_of_max": 3}}),
        ("-1,-2", {}),
    ],
    ids=["some ended", "none ended"],
)
def test_extremes_are_of_runs_that_came_to_their_end(capsys, tmp_path, masses, extremes):
    arguments = ("--grid", f"mass={masses}", "--output", "reach", "-o", tmp_path / "a.csv")
    code, out, _ = run(capsys, "sweep", pendulum(), *arguments, "--json")
    assert code == 3
    assert json.loads(out)["outputs"] == extremes


# ------------------------------------------------------------------------------------ warnings


@pytest.mark.parametrize("engine", ["serial", "processes:2"])
def test_a_warning_of_the_runs_is_said_once(capsys, tmp_path, engine):
    fmu = text_fmu(text(LIMITED))
    grid = ("--grid", "solver.max_newton=20,25,30")
    options = ("--engine", engine, "-o", tmp_path / "a.csv", "--json")
    code, out, err = run(capsys, "sweep", fmu, *grid, *options)
    assert code == 0
    assert err.count("the tolerance is 1e-07, but steps in which contacts change") == 1
    assert json.loads(out)["warnings"] == [err.removeprefix("holonom: ").rstrip("\n")]


# ------------------------------------------------------------------------------------ mistakes


NAMELESS = ["", " ", "A.x,", "A.x,,reach"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((), ["nothing is varied"]),
        (("--grid", "mas=1,2"), ["pendulum has no parameter or input 'mas'", "mean 'mass'?"]),
        (("--grid", "mass=a,2"), ["--grid mass=a,2: error: mass: must be a number, got 'a'"]),
        (
            ("--grid", "solver.max_newton=0,2000", "--grid", "lenght=1"),
            ["must be >= 1, got 0", "must be <= 1000, got 2000", "did you mean 'length'?"],
        ),
        (("--grid", "mass=1", "--output", "A.z"), ["output A.z: error", "did you mean 'A."]),
        (("--grid", "mass=1", "--output", "speed"), ["no variable 'speed'", "known: clock, "]),
        (
            ("--grid", "mass=1", "--output", "solver.start"),
            ["output solver.start: error: solver.start: is a text, not a number"],
        ),
        (
            ("--grid", "mass=1:2", "--grid", "lenght=1,x", "--grid", "push=a", "--output", "A.z"),
            [
                "'1:2' is not a range",
                "did you mean 'length'?",
                "push: must be a number",
                "no variable 'A.z'",
            ],
        ),
        *((("--grid", "mass=1", "--output", each), ["a name is empty"]) for each in NAMELESS),
        (("--grid", "mass=1", "-o", "a.txt"), ["a.txt"]),
        (("--grid", "mass=1", "--stop", "-1"), ["the stop time must be a finite number after"]),
        (("--grid", "mass=1", "--engine", "threads"), ["there is no engine 'threads'"]),
        (("--grid", "mass=1", "--jobs", "0"), ["number of processes must be at least 1, got 0"]),
    ],
    ids=range(16),
)
def test_mistakes_end_with_2_before_anything_runs(capsys, tmp_path, monkeypatch, arguments, words):
    monkeypatch.chdir(tmp_path)
    code, out, err = run(capsys, "sweep", pendulum(), *arguments)
    assert (code, out) == (2, "")
    assert not [each for each in words if each not in err]
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("missing", [True, False], ids=["no package", "no scheduler"])
def test_an_engine_that_is_not_there_leaves_no_files(capsys, tmp_path, monkeypatch, missing):
    if missing:
        monkeypatch.setitem(sys.modules, "distributed", None)
    else:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            pytest.importorskip("distributed")
        monkeypatch.setattr(dask_workers, "CONNECTION", 0.5)
    arguments = ("--grid", "mass=1", "--engine", "dask://127.0.0.1:9", "-o", tmp_path / "a.csv")
    code, out, err = run(capsys, "sweep", pendulum(), *arguments)
    assert (code, out) == (4, "")
    assert ("pip install 'holonom[dask]'" if missing else "no scheduler") in err
    assert list(tmp_path.iterdir()) == []


def test_an_interrupted_fresh_sweep_goes_on_without_fresh(tmp_path):
    def interrupt(_done, _count):
        raise KeyboardInterrupt

    arguments = {"grid": {"mass": [1, 2]}, "path": tmp_path / "a.csv", "engine": "serial"}
    with pytest.raises(KeyboardInterrupt, match=r"1 of 2 runs are in .*a\.csv, the same command g"):
        build_fmu.sweep(pendulum(), progress=interrupt, **arguments)
    with pytest.raises(KeyboardInterrupt, match="the same command without --fresh goes on"):
        build_fmu.sweep(pendulum(), progress=interrupt, fresh=True, **arguments)
    del arguments["path"]
    with pytest.raises(KeyboardInterrupt, match=r"^$"):
        build_fmu.sweep(pendulum(), progress=interrupt, **arguments)
