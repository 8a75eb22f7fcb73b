"""The assertions that users import, and the plugin: they pass, and fail with a sentence."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import fmpy
import numpy as np
import pytest

from build_fmu.errors import UsageError
from build_fmu.reference import limits
from build_fmu.run import run_fmu
from build_fmu.testing import assert_conserves, assert_follows
from examples import demo
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, pendulum, scene_fmu

ROOT = SCENES.parent
USERS_TEST = """
from build_fmu.testing import assert_conserves

def test_of_a_scene(built_fmu):
    fmu = built_fmu({scene!r}, mass=2.0)
    assert fmu is built_fmu({scene!r}, mass=2.0)
    assert assert_conserves(fmu, stop_time=0.5).end_time == 0.5

def test_of_values_beside_parameters(built_fmu, tmp_path):
    from build_fmu.run import run_fmu
    (tmp_path / "a.toml").write_text("mass = 3.0\\nlength = 1.5")
    for parameters in ({{"mass": 3.0, "length": 1.5}}, tmp_path / "a.toml"):
        fmu = built_fmu({scene!r}, parameters, mass=2.0)
        assert fmu != built_fmu({scene!r}, parameters)
        run = run_fmu(fmu, stop_time=0.5)
        same = run_fmu(built_fmu({scene!r}, mass=2.0, length=1.5), stop_time=0.5)
        assert list(run.values["energy.total"]) == list(same.values["energy.total"])

def test_of_a_file(fmu_path):
    assert_conserves(fmu_path, stop_time=0.5)
"""


def exact() -> dict[str, np.ndarray]:
    """Motion of the four-bar, by its equation of one degree of freedom."""
    t = np.linspace(0.0, 10.0, 101)
    phi = demo.exact_angle(t)
    return {"time": t, "B0.x": np.sin(phi), "B0.y": np.cos(phi)}


# ------------------------------------------------------------------------------------- conserves


@pytest.mark.parametrize("name", ["four_bar", "double_pendulum"])
def test_what_conserves_passes(name):
    run = assert_conserves(scene_fmu(name), stop_time=2.0)
    assert run.end_time == 2.0


def test_a_scene_stands_for_its_fmu():
    assert_conserves(SCENES / "double_pendulum.toml", stop_time=0.5, parameters={"mass": 3.0})


def test_what_does_not_conserve_says_what_and_when():
    with pytest.raises(AssertionError) as caught:
        assert_conserves(scene_fmu("four_bar"), stop_time=2.0, energy=1e-20)
    lines = str(caught.value).splitlines()
    assert lines[0].endswith("four_bar.fmu does not conserve:")
    assert lines[1].startswith("  energy.error is ")
    assert lines[1].endswith("more than 1e-20")
    assert " at t = " in lines[1]


def test_a_run_that_ends_early_does_not_pass():
    with pytest.raises(AssertionError, match=r"the run ended at t = 0\.0 s, before 1\.0 s: .*mass"):
        assert_conserves(pendulum(), parameters={"mass": -1.0})


# --------------------------------------------------------------------------------------- follows


def test_the_four_bar_follows_the_exact_motion():
    # Second order at steps of 5 ms leaves 3.1e-4 m after 10 s.
    found = assert_follows(scene_fmu("four_bar"), exact(), relative=0.0, absolute=4e-4)
    assert sorted(found) == ["B0.x", "B0.y", "time"]


def test_a_file_is_a_reference(tmp_path):
    file = tmp_path / "a.csv"
    columns = exact()
    rows = zip(*columns.values(), strict=True)
    file.write_text("\n".join([",".join(columns), *(",".join(map(str, row)) for row in rows)]))
    assert_follows(scene_fmu("four_bar"), file, relative=4e-4)
    with pytest.raises(AssertionError) as caught:
        assert_follows(scene_fmu("four_bar"), file, relative=0.0, absolute={"B0.x": 1.0})
    lines = str(caught.value).splitlines()
    assert lines[0] == f"{scene_fmu('four_bar')} does not follow {file}:"
    assert lines[1].startswith("  B0.y is off by ")
    assert "more than 0; " in lines[1]
    assert len(lines) == 2  # of B0.x a metre passes


def test_a_reference_that_begins_late_is_followed_from_the_start_of_the_run():
    late = {name: values[7:] for name, values in exact().items()}
    found = assert_follows(scene_fmu("four_bar"), late, absolute=4e-4, relative=0.0)
    assert list(found["time"]) == list(late["time"])
    early = {"time": [-1.0, 0.0], "B0.x": [0.0, 0.0]}
    with pytest.raises(UsageError, match="begins at t = -1 s, before the FMU, which starts at 0 s"):
        assert_follows(scene_fmu("four_bar"), early)


def test_columns_of_inputs_are_not_compared_unless_they_are_named():
    driven = {"time": [0.0, 0.1], "push": [2.0, 2.0], "A.x": [1.0, 1.0]}
    assert "push" not in assert_follows(pendulum(), driven, absolute=9.0)
    with pytest.raises(AssertionError, match="push is off by 2"):
        assert_follows(pendulum(), driven, absolute=1.0, columns=["A.x", "push"])


def test_of_many_columns_that_are_off_the_first_are_told():
    wrong = {"time": [0.0, 0.1, 0.2], "A.y": [0.0, 9.0, 9.0], "A.x": [1.0, 1.0, 9.0]}
    with pytest.raises(AssertionError) as failure:
        assert_follows(pendulum(), wrong, relative=0.0, absolute=1.0)
    lines = str(failure.value).splitlines()
    assert [line.split()[0] for line in lines[1:]] == ["A.y", "A.x"]
    assert lines[1].endswith("2 of 3 points are, from t = 0.1 s on")
    values = run_fmu(pendulum(), stop_time=0.2).values
    every = {name: values[name] + (name != "time") for name in values.dtype.names}
    with pytest.raises(AssertionError, match=r"and \d+ more columns are off"):
        assert_follows(pendulum(), every)


def test_communication_points_are_those_of_the_reference():
    times = [0.0, 0.03, 0.5, 0.51]
    found = assert_follows(
        pendulum(), {"time": times, "A.x": [1.0] * 4}, absolute=9.0, columns=["A.x"]
    )
    assert list(found["time"]) == times
    assert found["A.x"][1] == pytest.approx(1.0, abs=1e-4)  # it falls from rest: x changes as t^4


@pytest.mark.parametrize(
    ("text", "report"),
    [
        ("t,A.x\n0,1\n1,1\n", "has no column 'time'\n  = help: columns: t, A.x"),
        ("time,A.x\n0,1\n0,1\n", "time must ascend: line 3 has 0 s after 0 s\n  = help: sort"),
        ("time,A.x\n0,1\n", "time must ascend, from at least two rows, got 1"),
        ("time,A.x\n0,1\n1,one\n2\n", ":3: error: A.x: must be a finite number, got 'one'"),
        ("time,A.x\n0,1\n1,1\n2\n", ":4: error: has 1 cell, and the header has 2"),
        ("time,B.x\n0,1\n1,1\n", "no column is an output of the FMU"),
        ("", "no header\n  = help: write a name for each column into the first line"),
        ("time,A.x,A.x\n0,1,2\n", ":1: error: column 3: 'A.x' is given twice"),
        ("time,,A.x\n0,1,2\n", ":1: error: column 2 has no name"),
        ("time,A.x\n0,1\n1,\n", ":3: error: A.x: must be a finite number, got ''"),
        ("time,A.x\n0,1\n1,inf\n", ":3: error: A.x: must be a finite number, got 'inf'"),
        ("time,A.x\n0,1\n1,nan\n", ":3: error: A.x: must be a finite number, got 'nan'"),
        ('time,A.x\n0,"1\n1,1\n', ":3: error: not CSV: unexpected end of data"),
        ('time,A.x\n0,"1"2\n1,1\n', ":2: error: not CSV: "),
        ("time;A.x\n0;1\n1;1\n", "has no column 'time'\n  = help: columns: time;A.x"),
        ("time,solver.status\n0,0\n1,0\n", "all columns tell how exact a run is"),
    ],
    ids=range(16),
)
def test_a_wrong_reference_names_file_and_line(tmp_path, text, report):
    file = tmp_path / "a.csv"
    file.write_text(text)
    with pytest.raises(UsageError) as caught:
        assert_follows(pendulum(), file)
    assert report in str(caught.value)
    assert str(caught.value).startswith(str(file))


def test_a_reference_that_cannot_be_read_names_file_rule_and_remedy(tmp_path):
    with pytest.raises(UsageError, match=r"lost\.csv: error: cannot be read: No such file"):
        assert_follows(pendulum(), tmp_path / "lost.csv")
    file = tmp_path / "a.csv"
    file.write_bytes("time,A.x\n0,1\n1,\xe4\n".encode("latin-1"))
    with pytest.raises(UsageError) as caught:
        assert_follows(pendulum(), file)
    assert str(caught.value) == (
        f"{file}:3: error: not a UTF-8 text: byte 0xe4\n  = help: save the file as UTF-8"
    )


@pytest.mark.parametrize(
    ("values", "report"),
    [
        ([1.0, "a"], "the reference: error: A.x: not numbers: could not convert"),
        ([1.0, float("nan")], "the reference: error: A.x: must be finite numbers"),
        ([1.0], "the reference: error: A.x: not one value for each time"),
    ],
    ids=range(3),
)
def test_wrong_arrays_are_named(values, report):
    with pytest.raises(UsageError, match=report):
        assert_follows(pendulum(), {"time": [0.0, 1.0], "A.x": values})


@pytest.mark.parametrize("columns", [[], (), "A.x"])
def test_a_comparison_of_nothing_does_not_pass(columns):
    reference = {"time": [0.0, 1.0], "A.x": [1.0, 1.0]}
    with pytest.raises(UsageError, match="columns: error: must be a list of names") as caught:
        assert_follows(pendulum(), reference, columns=columns)
    assert "leave columns out to compare all" in str(caught.value)


def test_an_error_that_passes_for_a_column_that_is_not_compared_is_a_mistake():
    reference = {"time": [0.0, 1.0], "A.x": [1.0, 1.0]}
    with pytest.raises(UsageError, match=r"absolute: error: A\.xx: not compared") as caught:
        assert_follows(pendulum(), reference, absolute={"A.xx": 9.0})
    assert "did you mean 'A.x'?" in str(caught.value)


# ---------------------------------------------------------- references that holonom wrote itself


def written(capsys, file: Path, name: str, *settings: str) -> Path:
    """Trajectory of a scene, as `simulate --csv` writes it."""
    chosen = [part for setting in settings for part in ("--set", setting)]
    arguments = ("simulate", scene_fmu(name), "--stop", 2, "--csv", file, *chosen)
    code, _, err = run(capsys, *arguments)
    assert (code, err) == (0, "")
    return file


@pytest.mark.parametrize("name", ["four_bar", "peaucellier", "heavy_top", "slider_crank"])
def test_a_trajectory_that_rounded_otherwise_is_followed_at_the_tolerance_as_it_comes(
    capsys, tmp_path, name
):
    # Another penalty gives other factors and so other digits, as another machine does; what is zero
    # by symmetry, and what says how exact the run is, has no digit in common.
    path = scene_fmu(name)
    penalty = next(
        float(v.start)
        for v in fmpy.read_model_description(str(path)).modelVariables
        if v.name == "solver.penalty"
    )
    file = written(capsys, tmp_path / "a.csv", name, f"solver.penalty={1.0001 * penalty!r}")
    found = assert_follows(path, file)
    assert len(found) > 10
    assert not [name for name in found if name.startswith(("solver.", "constraint."))]
    with pytest.raises(AssertionError, match=r"energy\.error is off by"):
        assert_follows(path, file, columns=["energy.error"])


def test_a_trajectory_of_other_steps_is_followed_up_to_the_error_of_these(capsys, tmp_path):
    # Steps of 2.5 and of 5 ms differ by 4e-5 of the largest values, whatever is noise.
    file = written(capsys, tmp_path / "a.csv", "four_bar", "solver.step_size=0.0025")
    assert_follows(scene_fmu("four_bar"), file, relative=1e-4)
    with pytest.raises(AssertionError, match=r"B0\.x is off by"):
        assert_follows(scene_fmu("four_bar"), file)


def test_noise_passes_beside_what_is_large_and_nothing_passes_at_no_error():
    expected = {"a": np.array([1.0, 2.0]), "b": np.array([1e-15, 0.0]), "c": np.array([1e-15, 0.0])}
    units = {"a": "m", "b": "m", "c": ""}
    passes = limits(expected, list(expected), units, 1e-6, {"c": 1e-3})
    assert passes == pytest.approx({"a": 2e-6, "b": 2e-10, "c": 1e-3})
    assert set(limits(expected, list(expected), units, 0.0, 0.0).values()) == {0.0}
    assert limits(expected, ["a", "b"], units, 1e-12, 0.0) == pytest.approx(
        {"a": 2e-12, "b": 2e-12}
    )


def test_a_column_that_is_not_there_is_named_with_a_suggestion():
    reference = {"time": [0.0, 1.0], "A.x": [1.0, 1.0]}
    with pytest.raises(UsageError, match=r"A\.xx: not in the reference") as caught:
        assert_follows(pendulum(), reference, columns=["A.xx"])
    assert "did you mean 'A.x'?" in str(caught.value)


# ---------------------------------------------------------------------------------------- plugin


def users_tests(folder: Path, *arguments: str) -> str:
    """Output of pytest for a user's file."""
    scene = str(SCENES / "double_pendulum.toml")
    (folder / "test_mine.py").write_text(USERS_TEST.format(scene=scene))
    command = [sys.executable, "-m", "pytest", "-p", "build_fmu.pytest_plugin", "-q", "--no-header"]
    command += ["-p", "no:cacheprovider", "--rootdir", str(folder), str(folder), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT).stdout


def test_the_fixtures_build_and_take_fmus(tmp_path):
    assert "2 passed, 1 skipped" in users_tests(tmp_path)
    both = [f"--fmu={scene_fmu(name)}" for name in ("four_bar", "double_pendulum")]
    assert "2 passed" in users_tests(tmp_path, *both, "-k", "of_a_file")


def test_the_plugin_is_registered_under_the_name_by_which_it_is_imported():
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    assert '"build_fmu.pytest_plugin" = "build_fmu.pytest_plugin"' in text
