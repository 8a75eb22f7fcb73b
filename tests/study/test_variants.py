"""`holonom variants`: one FMU for each row, the same as built one by one, and a manifest."""

from __future__ import annotations

import csv
import json

import pytest

from build_fmu import build
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, scene_fmu

PENDULUM = SCENES / "double_pendulum.toml"


@pytest.mark.parametrize("engine", ["serial", "processes:2"])
def test_each_fmu_is_the_one_that_build_writes(capsys, tmp_path, engine):
    grids = ("--grid", "mass=1:3:3", "--grid", "points.B.velocity=[0,0],[0,1]")
    arguments = (*grids, "--set", "length=2", "--engine", engine, "-o", tmp_path)
    code, out, err = run(capsys, "variants", PENDULUM, *arguments)
    assert (code, out) == (0, f"{tmp_path / 'manifest.csv'}\n")
    assert err.startswith("6 FMUs in ")
    with (tmp_path / "manifest.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["variant"] for row in rows] == list("123456")
    row = rows[3]
    assert (row["fmu"], row["mass"]) == ("double_pendulum_4.fmu", "2")
    values = {"mass": 2, "points.B.velocity": json.loads(row["points.B.velocity"]), "length": 2}
    alone = build(PENDULUM, tmp_path / "alone.fmu", parameters=values)
    assert (tmp_path / row["fmu"]).read_bytes() == alone.read_bytes()
    assert (tmp_path / "double_pendulum_4.ssv").read_bytes() == (
        tmp_path / "alone.ssv"
    ).read_bytes()


def test_a_table_makes_the_variants_of_its_lines(capsys, tmp_path):
    table = tmp_path / "table.csv"
    table.write_text("mass,length\n1,1\n2,0.5\n")
    code, out, _ = run(
        capsys, "variants", PENDULUM, "--table", table, "-o", tmp_path / "v", "--json"
    )
    assert code == 0
    made = json.loads(out)["variants"]
    assert [row["parameters"] for row in made] == [
        {"mass": 1, "length": 1},
        {"mass": 2, "length": 0.5},
    ]
    assert (tmp_path / "v" / "double_pendulum_1.fmu").is_file()


def test_mistakes_are_reported_once_and_the_other_variants_are_written(capsys, tmp_path):
    arguments = ("--grid", "mass=1,-1", "--grid", "length=1,2", "-o", tmp_path)
    code, out, err = run(capsys, "variants", PENDULUM, *arguments)
    assert (code, out) == (2, "")
    wrong = "--grid mass=1,-1: error: parameters.mass.value: must be >= 1e-06 kg (min), got -1"
    assert err.count(wrong) == 1
    with (tmp_path / "manifest.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [bool(row["fmu"]) for row in rows] == [True, True, False, False]
    assert [bool(row["error"]) for row in rows] == [False, False, True, True]


def test_a_name_that_the_scene_does_not_have_is_one_of_the_header(capsys, tmp_path):
    table = tmp_path / "table.csv"
    table.write_text("mas\n1\n2\n")
    code, _, err = run(capsys, "variants", PENDULUM, "--table", table, "-o", tmp_path / "v")
    assert code == 2
    assert err == f"{table}:1: error: mas: unknown name\n     = help: did you mean 'mass'?\n"
    assert [path.name for path in (tmp_path / "v").iterdir()] == ["manifest.csv"]


@pytest.mark.parametrize(
    ("target", "arguments", "words"),
    [
        (PENDULUM, (), "nothing is varied"),
        (scene_fmu("four_bar"), ("--grid", "a=1"), "an FMU, not a scene"),
        (PENDULUM, ("--grid", "mass=1", "--manifest", "a.txt"), "a manifest is a .csv or .json"),
        (PENDULUM, ("--grid", "mass=1", "--engine", "magic"), "there is no engine 'magic'"),
    ],
    ids=["nothing", "fmu", "manifest", "engine"],
)
def test_what_cannot_be_done_ends_with_2(capsys, tmp_path, target, arguments, words):
    code, out, err = run(capsys, "variants", target, "-o", tmp_path, *arguments)
    assert (code, out) == (2, "")
    assert words in err
