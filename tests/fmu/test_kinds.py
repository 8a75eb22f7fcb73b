"""Commands and checks do the same with FMUs of every kind: of Python, native of FMI 2 and 3."""

from __future__ import annotations

from pathlib import Path

import pytest

from build_fmu import build
from build_fmu.run import run_fmu
from build_fmu.testing import assert_conserves, assert_follows
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES

KINDS = {"python": {}, "native 2": {"native": True}, "native 3": {"native": True, "fmi": 3}}
SCENE = SCENES / "four_bar.toml"


@pytest.fixture(scope="module")
def fmus(tmp_path_factory) -> list[Path]:
    """FMU of each kind, all with one name."""
    folder = tmp_path_factory.mktemp("kinds")
    return [build(SCENE, folder / kind / "a.fmu", **how) for kind, how in KINDS.items()]


def only(found: list) -> object:
    """What is the same for all kinds."""
    assert found == [found[0]] * len(KINDS)
    return found[0]


def test_the_same_run_is_simulated(fmus, capsys):
    files = [fmu.with_suffix(".csv") for fmu in fmus]
    for fmu, file in zip(fmus, files, strict=True):
        assert run(capsys, "simulate", fmu, "--stop", 1, "--csv", file)[0] == 0
    assert only([file.read_bytes() for file in files]).count(b"\n") == 22


def test_the_same_errors_are_checked(fmus, capsys):
    found = [run(capsys, "check", fmu, "--stop", 1) for fmu in fmus]
    code, errors, said = only([(code, *out.partition(".fmu")[2:], err) for code, out, err in found])
    assert (code, said) == (0, "")
    assert "energy.error" in errors


def test_the_same_runs_are_swept(fmus, capsys):
    files = [fmu.with_name("sweep.csv") for fmu in fmus]
    for fmu, file in zip(fmus, files, strict=True):
        grid = ("--grid", "drive=0:1:3", "--set", "solver.step_size=0.01", "--stop", 1)
        assert run(capsys, "sweep", fmu, *grid, "-o", file)[0] == 0
    assert only([file.read_bytes() for file in files]).count(b"\n") == 4


def test_all_are_valid(fmus, capsys):
    assert only([run(capsys, "validate", fmu) for fmu in fmus]) == (0, "no finding\n", "")


def test_info_tells_the_kind_and_else_the_same(fmus, capsys):
    texts = [run(capsys, "info", fmu)[1].splitlines() for fmu in fmus]
    packages = [line for text in texts for line in text if line.startswith("package")]
    for package, words in zip(packages, ("2.0, Python", "2.0, native", "3.0, native"), strict=True):
        assert words in package
    only([[line for line in text if not line.startswith("package")] for text in texts])


def test_all_pass_as_tests_of_fmus(fmus):
    for fmu in fmus:
        assert assert_conserves(fmu, stop_time=1.0).end_time == 1.0
    reference = run_of(fmus[0])
    for fmu in fmus[1:]:
        assert_follows(fmu, reference, absolute=0.0, relative=0.0)


def run_of(fmu: Path) -> dict:
    """Columns of a run."""
    values = run_fmu(fmu, stop_time=1.0).values
    return {name: values[name] for name in ("time", "B0.x", "energy.error")}


@pytest.mark.parametrize("kind", KINDS)
def test_variants_are_built_of_every_kind(kind, capsys, tmp_path):
    options = ["--native"] * ("native" in KINDS[kind]) + ["--fmi", 3] * ("fmi" in KINDS[kind])
    grid = ("--grid", "bodies.crank0.mass=1,2")
    assert run(capsys, "variants", SCENE, *grid, *options, "-o", tmp_path)[0] == 0
    first, second = (run_of(tmp_path / f"four_bar_{k}.fmu") for k in (1, 2))
    assert first["B0.x"][-1] != second["B0.x"][-1]
