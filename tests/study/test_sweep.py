"""Sweeps: each run is the one that `simulate` makes, whatever engine, file or interruption."""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest

import build_fmu
from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.run import run_fmu
from build_fmu.study.plan import Plan
from tests.support.fmus.fmu_instance import PENDULUM, SCENES, pendulum, scene_fmu, text_fmu

GRID = {"length": [0.5, 1.0], "mass": [1.0, 2.0, 3.0]}
OUTPUTS = ("A.x", "energy.error")
BROKEN = {"mass": [1.0, -1.0, 2.0]}
"""The second cannot be assembled, and no limit of the parameter says so before."""
FAILING = {"mass": [1.0, -1.0, 2.0], "push": [0.0, 1.0]}
"""Runs 3 and 4 cannot be assembled, and take no step: their outputs are 0, which none other is."""
LATE = (
    PENDULUM.replace("{push}", "sqrt(late - t)")
    .replace("[parameters]", "[parameters]\nlate = 2.0")
    .format(length=1.0, mass=1.0)
)
"""Ends when its force is no number any more."""


# ------------------------------------------------------------------------------------ the runs


@pytest.mark.parametrize("engine", ["serial", "processes:2"])
def test_every_run_is_the_one_of_a_new_instance(engine):
    found = build_fmu.sweep(
        pendulum(), grid=GRID, outputs=OUTPUTS, trajectories=True, engine=engine
    )
    assert list(found["run"]) == [1, 2, 3, 4, 5, 6]
    assert found["finished"].all()
    for row in found:
        alone = run_fmu(pendulum(), settings={"length": row["length"], "mass": row["mass"]})
        assert list(row["time"]) == pytest.approx(list(alone.values["time"]))
        assert list(row["A.x"]) == list(alone.values["A.x"])  # bit for bit
        assert row["A.x.final"] == alone.values["A.x"][-1]
        assert (row["A.x.min"], row["A.x.max"]) == (row["A.x"].min(), row["A.x"].max())


def test_a_run_that_fails_is_recorded_and_the_others_are_as_without_it():
    found = build_fmu.sweep(pendulum(), grid=BROKEN, outputs=["A.x"], trajectories=True)
    assert list(found["finished"]) == [True, False, True]
    assert "mass" in found["reason"][1]
    assert np.isnan(found["A.x"][1][1:]).all()
    good = build_fmu.sweep(pendulum(), grid={"mass": [1.0, 2.0]}, outputs=["A.x"])
    assert list(found["A.x.final"][[0, 2]]) == list(good["A.x.final"])


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


def test_the_last_step_ends_at_the_stop_time():
    found = build_fmu.sweep(
        pendulum(), grid={"mass": [1]}, stop_time=0.25, step_size=0.1, trajectories=True
    )
    assert list(found["time"][0]) == pytest.approx([0.0, 0.1, 0.2, 0.25])
    assert found["finished"].all()


def test_a_scene_is_swept_as_its_fmu():
    arguments = {"grid": GRID, "outputs": ["A.x"], "stop_time": 0.5, "engine": "serial"}
    by_scene = build_fmu.sweep(SCENES / "double_pendulum.toml", **arguments)
    by_fmu = build_fmu.sweep(scene_fmu("double_pendulum"), **arguments)
    assert by_scene.tolist() == by_fmu.tolist()


# ----------------------------------------------------------------------------------- the forms


@pytest.mark.filterwarnings("ignore")  # those of their imports
def test_pandas_and_xarray_have_the_same_numbers():
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    found = build_fmu.sweep(pendulum(), grid=GRID, outputs=OUTPUTS, trajectories=True)
    for trajectories in (False, True):
        arguments = {"grid": GRID, "outputs": OUTPUTS, "trajectories": trajectories}
        data = build_fmu.sweep(pendulum(), form="xarray", **arguments)
        assert list(data["A.x.final"]) == list(found["A.x.final"])
        frame = build_fmu.sweep(pendulum(), form="pandas", **arguments)
        if trajectories:
            np.testing.assert_array_equal(data["A.x"], found["A.x"])
            np.testing.assert_array_equal(frame["A.x"].to_numpy(), found["A.x"].ravel())
        else:
            assert list(frame["A.x.final"]) == list(found["A.x.final"])


# -------------------------------------------------------------------------------- the mistakes


def test_a_form_that_is_not_there_is_refused():
    with pytest.raises(UsageError, match="no form 'list'; write one of numpy, pandas, xarray"):
        build_fmu.sweep(pendulum(), grid=GRID, form="list")


@pytest.mark.parametrize("form", ["pandas", "xarray"])
def test_a_form_whose_package_is_missing_says_how_to_get_it(monkeypatch, form):
    fmu = pendulum()  # its build looks for packages as well
    monkeypatch.setattr(importlib.util, "find_spec", lambda _name: None)
    with pytest.raises(EnvironmentLackError, match=rf"pip install 'holonom\[{form}\]'"):
        build_fmu.sweep(fmu, grid=GRID, form=form)


def test_the_form_of_a_sweep_has_the_plan_and_every_result():
    found = build_fmu.sweep(pendulum(), grid=BROKEN, outputs=["A.x"], form="sweep")
    assert list(found.failed["run"]) == [2]
    assert found.plan.rows[2] == {"mass": 2.0}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"grid": {"mass": [1, 2]}, "outputs": ["mass"], "trajectories": True}, "columns 'mass'"),
        ({"table": []}, "table: error: has no rows"),
        ({"table": [{1: 1}]}, "no parameter or input 1"),
        ({"grid": GRID, "outputs": [3]}, "has no variable 3"),
        ({"grid": {"mass": [object()]}}, "mass: must be a number, got <object"),
        ({"grid": {"mass": [None]}}, "mass: must be a number, got None"),
        ({"grid": {"mass": [float("inf")]}}, "mass: must be a finite number, got inf"),
        ({"grid": {"mass": [10**400]}}, "mass: must be a finite number, got an integer of 401"),
        ({"grid": GRID, "parameters": {"push": float("nan")}}, "finite number in N, got nan"),
        ({"grid": GRID, "parameters": {"mas": 1}}, "parameters['mas']=1: error: "),
        ({"grid": {"mas": [1, 2]}}, "grid['mas']=[1, 2]: error: "),
    ],
    ids=range(11),
)
def test_mistakes_in_python_are_sentences_too(arguments, words):
    with pytest.raises(UsageError) as caught:
        build_fmu.sweep(pendulum(), **arguments)
    assert words in str(caught.value)
    assert str(caught.value).count("error: ") <= 1


def plan(outputs: list[str], **varied: float) -> Plan:
    return Plan("a.fmu", "", [varied], {}, outputs, [0.0, 1.0], {})


@pytest.mark.parametrize(
    ("outputs", "varied"),
    [(["time"], {}), (["finished"], {}), (["mass"], {"mass": 1.0})],
    ids=["time", "finished", "mass"],
)
def test_trajectories_of_another_column_s_name_are_refused(outputs, varied):
    plan(outputs, **varied).check_columns(trajectories=False)  # its columns are NAME.final, ...
    with pytest.raises(UsageError, match=f"two columns '{outputs[0]}'"):
        plan(outputs, **varied).check_columns(trajectories=True)


def test_a_parameter_of_the_name_of_a_summary_is_refused():
    with pytest.raises(UsageError, match=r"two columns 'A\.x\.min'"):
        plan(["A.x"], **{"A.x.min": 1.0}).check_columns(trajectories=False)


def test_a_single_name_is_one_output():
    found = build_fmu.sweep(pendulum(), grid={"mass": [1]}, outputs="A.x")
    assert found.dtype.names[-1] == "A.x.max"


def test_the_package_has_its_functions_and_no_others():
    assert [getattr(build_fmu, name).__name__ for name in build_fmu.__all__] == build_fmu.__all__
    with pytest.raises(AttributeError, match="no attribute 'swep'"):
        _ = build_fmu.swep
