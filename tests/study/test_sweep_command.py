"""What a sweep says: extremes of the runs that came to their end, warnings, mistakes."""

from __future__ import annotations

import json
import sys
import warnings

import numpy as np
import pytest

import build_fmu
from build_fmu.study import dask_workers
from tests.commands import run
from tests.fmu_instance import PENDULUM, pendulum, text_fmu
from tests.physics.test_order_limits import text

FAILING = {"mass": [1.0, -1.0, 2.0], "push": [0.0, 1.0]}
"""Runs 3 and 4 cannot be assembled, and take no step: their outputs are 0, which none other is."""
LATE = (
    PENDULUM.replace("{push}", "sqrt(late - t)")
    .replace("[parameters]", "[parameters]\nlate = 2.0")
    .format(length=1.0, mass=1.0)
)
"""Ends when its force is no number any more."""


def test_extremes_are_of_runs_that_came_to_their_end(capsys, tmp_path):
    grids = ("--grid", "mass=1,-1,2", "--output", "reach", "-o", tmp_path / "a.csv")
    code, out, _ = run(capsys, "sweep", pendulum(), *grids, "--json")
    assert code == 3
    extremes = {"min": 1.0, "run_of_min": 1, "max": 1.0, "run_of_max": 3}
    assert json.loads(out)["outputs"]["reach"] == extremes


def test_the_table_without_any_run_that_ended_has_no_extremes(capsys, tmp_path):
    grids = ("--grid", "mass=-1,-2", "--output", "reach", "-o", tmp_path / "a.csv")
    code, out, _ = run(capsys, "sweep", pendulum(), *grids, "--json")
    assert code == 3
    assert json.loads(out)["outputs"] == {}


@pytest.mark.parametrize("kind", ["csv", "h5"])
def test_a_run_that_took_no_step_has_no_numbers(tmp_path, kind):
    if kind == "h5":
        pytest.importorskip("h5py")
    arguments = {"grid": FAILING, "outputs": ["reach"], "path": tmp_path / f"a.{kind}"}
    for _ in range(2):  # made, then read
        found = build_fmu.sweep(pendulum(), trajectories=kind == "h5", **arguments)
        assert list(found["finished"]) == [True, True, False, False, True, True]
        for name in ("reach.final", "reach.min", "reach.max"):
            assert list(np.isnan(found[name])) == list(~found["finished"])
        if kind == "h5":
            assert list(np.isnan(found["reach"]).any(axis=1)) == list(~found["finished"])


def test_a_run_that_failed_later_has_the_numbers_up_to_there(tmp_path):
    fmu = text_fmu(LATE)
    found = build_fmu.sweep(fmu, grid={"late": [0.55]}, outputs=["clock"], path=tmp_path / "a.csv")
    assert not found["finished"][0]
    assert found["end_time"][0] == found["clock.final"][0] == pytest.approx(0.5)


# ------------------------------------------------------------------------------------ warnings


@pytest.mark.parametrize("engine", ["serial", "processes:2"])
def test_a_warning_of_the_runs_is_said_once(capsys, tmp_path, engine):
    fmu = text_fmu(text("order = 4"))
    grid = ("--grid", "solver.max_newton=20,25,30")
    options = ("--engine", engine, "-o", tmp_path / "a.csv", "--json")
    code, out, err = run(capsys, "sweep", fmu, *grid, *options)
    assert code == 0
    assert err.count("solver.order is 4, but steps are of order 2") == 1
    assert json.loads(out)["warnings"] == [err.removeprefix("holonom: ").rstrip("\n")]


# ------------------------------------------------------------------------------------ mistakes


@pytest.mark.parametrize("names", ["", " ", "A.x,", "A.x,,reach"])
def test_an_output_without_a_name_is_refused(capsys, tmp_path, names):
    file = tmp_path / "a.csv"
    arguments = ("--grid", "mass=1", "--output", names, "-o", file)
    code, out, err = run(capsys, "sweep", pendulum(), *arguments)
    assert (code, out) == (2, "")
    assert "a name is empty" in err
    assert not file.exists()


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
    assert "distributed" in err if missing else "no scheduler" in err
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
