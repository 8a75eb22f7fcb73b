"""Files of parameters: what is read from them, and the set that is written beside every FMU."""

from __future__ import annotations

import itertools
import json
import zipfile
from pathlib import Path

import fmpy
import pytest
from lxml import etree

from build_fmu import build
from build_fmu.errors import UsageError
from build_fmu.run import run_fmu
from build_fmu.study.parameter_files import entries_of_files
from build_fmu.study.ssv import COMMON, VALUES
from build_fmu.study.values import refuse
from tests.commands import run
from tests.fmu_instance import SCENES, pendulum

PENDULUM = SCENES / "double_pendulum.toml"
SCHEMA = Path(fmpy.__file__).parent / "ssp" / "schema" / "SystemStructureParameterValues.xsd"
MEASURED = """
name = "measured"
dimension = 2
gravity = [0, -9.81]
[parameters]
length = {{ value = {length}, unit = "m" }}
mass = {{ value = 2.0, unit = "kg" }}
[points]
O = {{ position = [0, 0], fixed = true }}
A = {{ position = ["length", 0], mass = "mass" }}
[joints]
rod = {{ type = "distance", points = ["O", "A"] }}
"""
SET = f"""<?xml version="1.0"?>
<ssv:ParameterSet xmlns:ssv="{VALUES}" xmlns:ssc="{COMMON}" version="1.0" name="set">
  <ssv:Parameters>
    <ssv:Parameter name="length"><ssv:Real value="{{value}}" unit="{{unit}}"/></ssv:Parameter>
  </ssv:Parameters>
</ssv:ParameterSet>
"""
FILES = {
    "toml": 'mass = 2.0\n"points.B.velocity" = [0, 3]\n'
    "[solver]\nstep_size = 0.02\npaired = false\n",
    "json": json.dumps(
        {"mass": 2.0, "points.B.velocity": [0, 3], "solver": {"step_size": 0.02, "paired": False}}
    ),
    "csv": "name,value\nmass,2.0\npoints.B.velocity,'[0, 3]'\nsolver.step_size,0.02\n"
    "solver.paired,false\n".replace("'", '"'),
}
VALUES_OF_FILES = {
    "mass": 2.0,
    "points.B.velocity": [0, 3],
    "solver.step_size": 0.02,
    "solver.paired": False,
}


def measured(folder: Path, length=1.0) -> Path:
    """Scene whose parameters have units."""
    scene = folder / f"measured{length}.toml"
    scene.write_text(MEASURED.format(length=length))
    return scene


def written(folder: Path, name: str, text: str) -> Path:
    (folder / name).write_text(text)
    return folder / name


# ----------------------------------------------------------------------------------- read


@pytest.mark.parametrize("kind", FILES)
def test_a_file_says_the_same_in_every_notation(tmp_path, kind):
    file = written(tmp_path, f"values.{kind}", FILES[kind])
    assert {
        name: entry.value for name, entry in entries_of_files([file]).items()
    } == VALUES_OF_FILES
    by_file = build(PENDULUM, tmp_path / "a.fmu", parameters=file)
    by_name = build(PENDULUM, tmp_path / "b.fmu", parameters=VALUES_OF_FILES)
    assert by_file.read_bytes() == by_name.read_bytes()


def test_set_has_precedence_and_of_two_files_the_later(capsys, tmp_path):
    first = written(tmp_path, "a.toml", "mass = 2\nlength = 2\n")
    second = written(tmp_path, "b.toml", "length = 3\n")
    files = ("--parameters", first, "--parameters", second, "--set", "mass=5")
    code, out, _ = run(capsys, "info", PENDULUM, "--json", *files)
    starts = {v["name"]: v["start"] for v in json.loads(out)["variables"]}
    assert (code, starts["mass"], starts["length"]) == (0, 5.0, 3.0)


@pytest.mark.parametrize(
    ("name", "text", "report"),
    [
        ("a.toml", "mass = 1\nlength = = 2\n", "a.toml:2:10: error: TOML: Invalid value"),
        ("a.json", '{"mass": 1,\n "length": }', "a.json:2:12: error: JSON: Expecting value"),
        ("a.json", "[1]", "a.json: error: must be a table of fields, got [1]"),
        (
            "a.json",
            '{"mass": 1,\n "mass": 2}',
            "a.json:2: error: mass: given twice, first in line 1",
        ),
        (
            "a.json",
            '{"solver.order": 2,\n "solver": {"order": 4}}',
            "a.json:2: error: solver.order: given twice, first at a.json:1",
        ),
        (
            "a.toml",
            '"solver.order" = 2\n[solver]\norder = 4\n',
            "a.toml:3: error: solver.order: given twice, first at a.toml:1",
        ),
        (
            "a.toml",
            "mass = 2\nparameters.mass = 4\n",
            "a.toml:2: error: parameters.mass: given twice, first as mass at a.toml:1",
        ),
        (
            "a.toml",
            "mass = 2\nmass = 4\n",
            "a.toml:2:9: error: TOML: Cannot overwrite a value\n"
            "  = help: the same key is given twice, first in line 1",
        ),
        ("a.json", '{"mass": NaN}', "a.json:1: error: mass: must be a finite number, got nan"),
        ("a.toml", "a = 1\nmass = inf\n", "a.toml:2: error: mass: must be a finite number"),
        ("a.csv", "name,value\nmass,nan\n", "a.csv:2: error: mass: must be a finite number"),
        ("a.json", '{"g": [0, Infinity]}', "a.json:1: error: g: must be a finite number, got inf"),
        ("a.json", '{"a":' * 100_000, "a.json: error: JSON: nested too deeply"),
        ("a.json", '{"a":' * 200 + "1" + "}" * 200, "a.json: error: nested too deeply"),
        ("a.toml", "a = " + "[" * 100_000, "a.toml: error: TOML: nested too deeply"),
        (
            "a.csv",
            '"name,value"\n"mass,1"\n',
            "a.csv:1: error: the header is 'name,value' in quotes, as one cell\n"
            "  = help: write it without quotes",
        ),
        (
            "a.csv",
            "name,value\na," + "[" * 100_000 + "\n",
            "a.csv:2: error: a: nested too deeply",
        ),
        (
            "a.csv",
            "parameter,value\nmass,1\nlength\nx,[1\n",
            "a.csv:1: error: the header is 'parameter,value'\n"
            "  = help: it must be name,value or name,value,unit\n"
            "a.csv:3: error: has 1 cell, and the header has 2\n"
            "  = help: put a text with a comma into quotes\n"
            "a.csv:4: error: x: Expecting ',' delimiter",
        ),
        (
            "a.csv",
            "parameter,value\nmass,1\n",
            "a.csv:1: error: the header is 'parameter,value'\n"
            "  = help: it must be name,value or name,value,unit",
        ),
        (
            "a.csv",
            "name;value\nmass;1\n",
            "a.csv:1: error: the header is 'name;value'\n"
            "  = help: it must be name,value or name,value,unit, separated by commas",
        ),
        (
            "a.csv",
            "name,value\nmass,1,2\nlength,\nlength,2\nlength,3\n",
            "a.csv:2: error: has 3 cells, and the header has 2\n"
            "  = help: put a text with a comma into quotes\n"
            "a.csv:3: error: length: an empty cell\n"
            "a.csv:5: error: length: given twice, first at a.csv:4",
        ),
        (
            "a.ssv",
            "<a>\n</b>",
            "a.ssv:2:5: error: not XML: Opening and ending tag mismatch: a line 1",
        ),
        ("a.ssv", "<a>\n</a>", "a.ssv:1: error: not a parameter set of SSP 1.0, but 'a'\n"),
        ("a.ssv", "", "a.ssv:1:1: error: not XML: Document is empty"),
        (
            "a.ssv",
            SET.format(value="long", unit="m"),
            "a.ssv:4: error: length: must be a number, got 'long'",
        ),
        (
            "a.yaml",
            "mass: 1",
            "a.yaml: error: unknown kind of file '.yaml'\n"
            "  = help: known: .toml, .json, .csv, .ssv",
        ),
    ],
    ids=itertools.count(),
)
def test_mistakes_of_a_file_name_their_line(tmp_path, monkeypatch, name, text, report):
    monkeypatch.chdir(tmp_path)
    written(tmp_path, name, text)
    with pytest.raises(UsageError) as caught:
        refuse(entry.wrong for entry in entries_of_files([name]).values() if entry.wrong)
    assert str(caught.value).startswith(report)


def test_a_file_that_is_missing_ends_with_2(capsys, tmp_path):
    code, out, err = run(capsys, "build", PENDULUM, "--parameters", tmp_path / "none.toml")
    assert (code, out) == (2, "")
    assert err == f"{tmp_path / 'none.toml'}: error: file not found\n"


def test_mistakes_in_values_name_the_file_and_all_are_reported(capsys, tmp_path):
    file = written(tmp_path, "a.csv", "name,value\nmas,1\nlength,0\npoints.A.mass,-1\n")
    code, out, err = run(capsys, "build", PENDULUM, "-o", tmp_path, "--parameters", file)
    assert (code, out) == (2, "")
    assert f"{file}:2: error: mas: unknown name\n     = help: did you mean 'mass'?" in err
    assert f"{file}:4: error: points.A.mass: must be >= 0 kg, got -1" in err
    assert not list(tmp_path.glob("*.fmu"))


# ----------------------------------------------------------------------------------- written


def model_of(fmu: Path) -> bytes:
    with zipfile.ZipFile(fmu) as archive:
        return archive.read("resources/model.bin")


@pytest.mark.parametrize(
    ("scene", "changes"),
    [
        ("double_pendulum", {"mass": 2, "solver.step_size": 0.001}),
        ("double_wishbone", {"solver.max_newton": 15}),
        ("four_bar", {}),
        ("double_pendulum", {"solver.tolerance": 1e-6, "solver.longest_step": 0.02}),
    ],
)
def test_the_set_beside_an_fmu_is_valid_and_gives_the_same_model(tmp_path, scene, changes):
    file = SCENES / f"{scene}.toml"
    first = build(file, tmp_path / "a.fmu", parameters=changes)
    beside = tmp_path / "a.ssv"
    etree.XMLSchema(etree.parse(SCHEMA)).assertValid(etree.parse(beside))
    second = build(file, tmp_path / "b.fmu", parameters=beside)
    assert model_of(second) == model_of(first)
    assert (tmp_path / "b.ssv").read_bytes() == beside.read_bytes()


def test_the_set_has_every_parameter_with_its_unit(tmp_path):
    fmu = build(measured(tmp_path), tmp_path / "a.fmu")
    variables = fmpy.read_model_description(str(fmu)).modelVariables
    expected = {v.name: v.unit or "" for v in variables if v.causality == "parameter"}
    found = entries_of_files([tmp_path / "a.ssv"])
    assert {name: entry.unit for name, entry in found.items()} == expected
    assert found["length"].unit == "m"


def test_a_value_in_another_unit_is_converted(tmp_path):
    file = written(tmp_path, "set.ssv", SET.format(value=500, unit="mm"))
    scene = build(measured(tmp_path), tmp_path / "a.fmu", parameters=file)
    half = build(measured(tmp_path), tmp_path / "b.fmu", parameters={"length": 0.5})
    assert model_of(scene) == model_of(half)
    unchanged = build(measured(tmp_path), tmp_path / "c.fmu")
    for settings in (file, {"length": 0.5}):
        values = run_fmu(unchanged, settings=settings).values
        assert values["A.x"][0] == 0.5


@pytest.mark.parametrize("target", ["scene", "fmu"])
def test_a_value_in_a_unit_of_another_kind_is_refused(capsys, tmp_path, target):
    file = written(tmp_path, "set.ssv", SET.format(value=500, unit="kg"))
    scene = measured(tmp_path)
    given = scene if target == "scene" else build(scene, tmp_path / "a.fmu")
    code, out, err = run(capsys, "simulate", given, "--parameters", file)
    assert (code, out) == (2, "")
    assert err == f"{file}:4: error: length: given in 'kg', but has the unit 'm'\n" + (
        "  = help: 'kg' measures something else; give the value in m\n"
    )


def test_an_fmu_is_simulated_with_values_of_a_file(capsys, tmp_path):
    file = written(tmp_path, "a.toml", "length = 0.5\n")
    by_file = run(capsys, "simulate", pendulum(), "--csv", "-", "--parameters", file)
    by_name = run(capsys, "simulate", pendulum(), "--csv", "-", "--set", "length=0.5")
    assert by_file == by_name
    assert by_file[0] == 0


def test_a_parameter_is_no_remedy_for_itself(capsys, tmp_path):
    file = written(tmp_path, "a.csv", "name,value\nlength,lengt\n")
    code, _, err = run(capsys, "build", PENDULUM, "-o", tmp_path, "--parameters", file)
    assert code == 2
    help = "     = help: known: mass\n"
    assert err == f"{file}:2: error: parameters.length.value: unknown symbol 'lengt'\n{help}"


def test_a_value_off_the_limits_of_its_parameter_is_one_mistake(capsys, tmp_path):
    """What is calculated from it is wrong too, and not for another reason."""
    code, _, err = run(capsys, "build", PENDULUM, "-o", tmp_path, "--set", "mass=-1")
    wrong = "--set mass=-1: error: parameters.mass.value: must be >= 1e-06 kg (min), got -1\n"
    assert (code, err) == (2, wrong)
