"""Files of parameters, and the set beside every FMU: units, precedence, mistakes of commands."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import fmpy
import pytest
from lxml import etree

from build_fmu import build
from build_fmu.run import run_fmu
from build_fmu.study.parameter_files import entries_of_files
from build_fmu.study.ssv import COMMON, VALUES
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, pendulum

PENDULUM = SCENES / "double_pendulum.toml"
SCHEMA = Path(fmpy.__file__).parent / "ssp" / "schema" / "SystemStructureParameterValues.xsd"
MEASURED = """
name = "measured"
dimension = 2
gravity = [0, -9.81]
[parameters]
length = { value = 1.0, unit = "m", max = 3 }
mass = { value = 2.0, unit = "kg" }
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["length", 0], mass = "mass" }
[joints]
rod = { type = "distance", points = ["O", "A"] }
"""
SET = f"""<?xml version="1.0"?>
<ssv:ParameterSet xmlns:ssv="{VALUES}" xmlns:ssc="{COMMON}" version="1.0" name="set">
  <ssv:Parameters>
{{parameters}}
  </ssv:Parameters>
  <ssv:Units>{{units}}</ssv:Units>
</ssv:ParameterSet>
"""


def written(folder: Path, name: str, text: str) -> Path:
    (folder / name).write_text(text)
    return folder / name


@pytest.fixture
def measured(tmp_path) -> Path:
    """Scene whose parameters have units."""
    return written(tmp_path, "measured.toml", MEASURED)


def real(name: str, value: object, unit: str) -> str:
    return f'<ssv:Parameter name="{name}"><ssv:Real value="{value}" unit="{unit}"/></ssv:Parameter>'


def unit(name: str, base: str) -> str:
    return f'<ssc:Unit name="{name}"><ssc:BaseUnit {base}/></ssc:Unit>'


def set_of(folder: Path, *parameters: str, units: str = "") -> Path:
    text = SET.format(parameters="\n".join(parameters), units=units)
    return written(folder, "set.ssv", text)


def model_of(fmu: Path) -> bytes:
    with zipfile.ZipFile(fmu) as archive:
        return archive.read("resources/model.bin")


# ------------------------------------------------------------------------------------- values


def test_set_has_precedence_and_of_two_files_the_later(capsys, tmp_path):
    first = written(tmp_path, "a.toml", "mass = 2\nlength = 2\n")
    second = written(tmp_path, "b.toml", "length = 3\n")
    files = ("--parameters", first, "--parameters", second, "--set", "mass=5")
    code, out, _ = run(capsys, "info", PENDULUM, "--json", *files)
    starts = {v["name"]: v["start"] for v in json.loads(out)["variables"]}
    assert (code, starts["mass"], starts["length"]) == (0, 5.0, 3.0)


def test_a_file_gives_the_fmu_and_the_run_that_its_values_give(capsys, tmp_path):
    file = written(tmp_path, "a.json", '{"mass": 2.0, "points": {"B": {"velocity": [0, 3]}}}')
    by_file = build(PENDULUM, tmp_path / "a.fmu", parameters=file)
    values = {"mass": 2.0, "points.B.velocity": [0, 3]}
    by_name = build(PENDULUM, tmp_path / "b.fmu", parameters=values)
    assert by_file.read_bytes() == by_name.read_bytes()
    file = written(tmp_path, "a.toml", "length = 0.5\n")
    by_file = run(capsys, "simulate", pendulum(), "--csv", "-", "--parameters", file)
    by_name = run(capsys, "simulate", pendulum(), "--csv", "-", "--set", "length=0.5")
    assert by_file == by_name
    assert by_file[0] == 0


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


def test_the_set_has_every_parameter_with_its_unit_whatever_a_description_has(tmp_path):
    strange = MEASURED.replace('unit = "kg"', 'unit = "kg", description = "a\\u0001b<&\\n"')
    fmu = build(written(tmp_path, "strange.toml", strange), tmp_path / "a.fmu")
    etree.XMLSchema(etree.parse(SCHEMA)).assertValid(etree.parse(tmp_path / "a.ssv"))
    variables = fmpy.read_model_description(str(fmu)).modelVariables
    expected = {v.name: v.unit or "" for v in variables if v.causality == "parameter"}
    found = entries_of_files([tmp_path / "a.ssv"])
    assert {name: entry.unit for name, entry in found.items()} == expected
    assert found["length"].unit == "m"


# -------------------------------------------------------------------------------------- units


@pytest.mark.parametrize(
    ("value", "name", "defined", "meters"),
    [
        (500, "mm", "", 0.5),
        (7e5, "um", "", 0.7),
        (3e-3, "km", "", 3.0),
        (30, "dm*cm/cm", "", 3.0),
        (10, "ft", 'm="1" factor="0.3048"', 3.048),
        (500, "m", 'm="1" factor="0.001"', 0.5),
    ],
    ids=["known", "um", "km", "product", "of the file", "of the file, named otherwise"],
)
def test_a_value_is_converted_by_what_the_file_says_of_its_unit_or_its_name(
    tmp_path, measured, value, name, defined, meters
):
    measured.write_text(MEASURED.replace("max = 3", "max = 4"))
    file = set_of(tmp_path, real("length", value, name), units=unit(name, defined) * bool(defined))
    by_set = build(measured, tmp_path / "a.fmu", parameters=file)
    by_name = build(measured, tmp_path / "b.fmu", parameters={"length": meters})
    assert model_of(by_set) == model_of(by_name)
    unchanged = build(measured, tmp_path / "c.fmu")
    for settings in (file, {"length": meters}):
        assert run_fmu(unchanged, settings=settings).values["A.x"][0] == meters


def test_a_radian_of_the_same_name_may_be_without_dimension(tmp_path):
    scene = SCENES / "slider_crank.toml"
    file = set_of(tmp_path, real("speed", 100, "rad/s"), units=unit("rad/s", 's="-1"'))
    by_set = build(scene, tmp_path / "a.fmu", parameters=file)
    by_name = build(scene, tmp_path / "b.fmu", parameters={"speed": 100.0})
    assert model_of(by_set) == model_of(by_name)


def test_the_longest_step_is_a_setting_of_the_scene_in_whatever_unit(tmp_path):
    changes = {"solver.tolerance": 1e-6, "solver.longest_step": 0.02}
    build(PENDULUM, tmp_path / "a.fmu", parameters=changes)
    text = (tmp_path / "a.ssv").read_text()
    assert text.count('value="0.02" unit="s"') == 1
    other = text.replace('value="0.02" unit="s"', 'value="20.0" unit="ms"', 1)
    seconds = '<ssc:Unit name="s">'
    other = other.replace(seconds, unit("ms", 's="1" factor="0.001"') + seconds)
    fmu = build(PENDULUM, tmp_path / "b.fmu", parameters=written(tmp_path, "b2.ssv", other))
    assert model_of(fmu) == model_of(tmp_path / "a.fmu")


UNKNOWN = "is not known, and the file does not define it; give the value in m"
WRONG_UNITS = [
    ("length", "kg", "", "given in 'kg', but has the unit 'm'", "'kg' measures something else; "),
    ("length", "furlong", "", "given in 'furlong', but has the unit 'm'", f"'furlong' {UNKNOWN}"),
    ("length", "stone", 'kg="1" factor="6.35"', "given in 'stone', but has the", "'stone' measu"),
    ("length", "abs", 'm="1" offset="2"', "the unit 'abs' has an offset", "write the value in a"),
    ("length", "degC", "", "given in 'degC', but has", "'degC' counts from another zero than SI"),
    ("solver.max_newton", "kg", "", "given in 'kg', but has no unit", "leave the unit out"),
]


@pytest.mark.parametrize("wrong", WRONG_UNITS, ids=lambda wrong: wrong[1])
@pytest.mark.parametrize("target", ["scene", "fmu"])
def test_a_wrong_unit_is_one_mistake_with_its_remedy(capsys, tmp_path, measured, target, wrong):
    """Nobody knows then whether the value, here 500 of at most 3, is within its limits."""
    name, given, defined, message, help = wrong
    file = set_of(tmp_path, real(name, 500, given), units=unit(given, defined) * bool(defined))
    scene = measured if target == "scene" else build(measured, tmp_path / "a.fmu")
    code, out, err = run(capsys, "simulate", scene, "--parameters", file)
    assert (code, out) == (2, "")
    assert err.startswith(f"{file}:4: error: {name}: {message}")
    assert f"\n  = help: {help}" in err
    assert err.count("error: ") == 1


# ----------------------------------------------------------------------------------- mistakes


@pytest.mark.parametrize("target", ["scene", "fmu"])
def test_a_value_that_cannot_be_read_and_an_unknown_name_are_told_in_one_run(
    capsys, tmp_path, measured, target
):
    file = set_of(tmp_path, real("length", "long", "m"), real("lenth", 1, "m"))
    given = measured if target == "scene" else build(measured, tmp_path / "a.fmu")
    code, _, err = run(capsys, "simulate", given, "--parameters", file)
    assert code == 2
    assert f"{file}:4: error: length: must be a number, got 'long'" in err
    assert f"{file}:5: error: " in err
    assert "did you mean 'length'?" in err


@pytest.mark.parametrize(
    ("text", "report"),
    [
        (
            None,
            "{file}: error: cannot be read: No such file or directory\n"
            "  = help: look at its name and folder\n",
        ),
        (
            "mas,1\nlength,0\npoints.A.mass,-1\n",
            "{file}:2: error: mas: unknown name\n     = help: did you mean 'mass'?\n"
            "{file}:3: error: parameters.length.value: must be >= 0.01 m (min), got 0\n"
            "{file}:4: error: points.A.mass: must be >= 0 kg, got -1\n",
        ),
        (
            "length,lengt\n",
            "{file}:2: error: parameters.length.value: unknown symbol 'lengt'\n"
            "     = help: known: mass\n",
        ),
    ],
    ids=["missing", "three", "no remedy for itself"],
)
def test_mistakes_in_values_name_the_file_and_all_are_told(capsys, tmp_path, text, report):
    file = tmp_path / "a.csv"
    if text is not None:
        file.write_text(f"name,value\n{text}")
    code, out, err = run(capsys, "build", PENDULUM, "-o", tmp_path, "--parameters", file)
    assert (code, out) == (2, "")
    assert sorted(err.splitlines()) == sorted(report.format(file=file).splitlines())
    assert not list(tmp_path.glob("*.fmu"))


def test_a_value_off_the_limits_of_its_parameter_is_one_mistake(capsys, tmp_path):
    """What is calculated from it is wrong too, and not for another reason."""
    code, _, err = run(capsys, "build", PENDULUM, "-o", tmp_path, "--set", "mass=-1")
    wrong = "--set mass=-1: error: parameters.mass.value: must be >= 1e-06 kg (min), got -1\n"
    assert (code, err) == (2, wrong)
