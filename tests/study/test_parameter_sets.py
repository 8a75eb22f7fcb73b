"""Parameter sets of SSP (.ssv): units that the file defines, and what is refused in them."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from build_fmu import build
from build_fmu.errors import UsageError
from build_fmu.run import run_fmu
from build_fmu.study.parameter_files import entries_of_files
from build_fmu.study.ssv import COMMON, VALUES
from build_fmu.study.values import refuse
from tests.commands import run
from tests.fmu_instance import SCENES
from tests.study.test_parameter_files import PENDULUM, SCHEMA, measured, model_of, written

SET = f"""<?xml version="1.0"?>
<ssv:ParameterSet xmlns:ssv="{VALUES}" xmlns:ssc="{COMMON}" version="1.0" name="set">
  <ssv:Parameters>
{{parameters}}
  </ssv:Parameters>
  <ssv:Units>{{units}}</ssv:Units>
</ssv:ParameterSet>
"""
FOOT = '<ssc:Unit name="ft"><ssc:BaseUnit m="1" factor="0.3048"/></ssc:Unit>'


def real(name: str, value: object, unit: str) -> str:
    return f'<ssv:Parameter name="{name}"><ssv:Real value="{value}" unit="{unit}"/></ssv:Parameter>'


def set_of(folder: Path, *parameters: str, units: str = FOOT) -> Path:
    text = SET.format(parameters="\n".join(parameters), units=units)
    return written(folder, "set.ssv", text)


def test_a_unit_that_the_file_defines_is_converted(tmp_path):
    file = set_of(tmp_path, real("length", 10, "ft"))
    by_set = build(measured(tmp_path), tmp_path / "a.fmu", parameters=file)
    by_name = build(measured(tmp_path), tmp_path / "b.fmu", parameters={"length": 3.048})
    assert model_of(by_set) == model_of(by_name)
    unchanged = build(measured(tmp_path), tmp_path / "c.fmu")
    assert run_fmu(unchanged, settings=file).values["A.x"][0] == 3.048


def test_what_the_file_says_of_a_unit_goes_before_what_its_name_says(tmp_path):
    units = '<ssc:Unit name="m"><ssc:BaseUnit m="1" factor="0.001"/></ssc:Unit>'
    file = set_of(tmp_path, real("length", 500, "m"), units=units)
    fmu = build(measured(tmp_path), tmp_path / "a.fmu", parameters=file)
    half = build(measured(tmp_path), tmp_path / "b.fmu", parameters={"length": 0.5})
    assert model_of(fmu) == model_of(half)


def test_a_radian_of_the_same_name_may_be_without_dimension(tmp_path):
    scene = SCENES / "slider_crank.toml"
    units = '<ssc:Unit name="rad/s"><ssc:BaseUnit s="-1"/></ssc:Unit>'
    file = set_of(tmp_path, real("speed", 100, "rad/s"), units=units)
    by_set = build(scene, tmp_path / "a.fmu", parameters=file)
    by_name = build(scene, tmp_path / "b.fmu", parameters={"speed": 100.0})
    assert model_of(by_set) == model_of(by_name)


@pytest.mark.parametrize(
    ("unit", "units", "message"),
    [
        ("stone", '<ssc:Unit name="stone"><ssc:BaseUnit kg="1" factor="6.35"/></ssc:Unit>', "unit"),
        ("furlong", FOOT, "unit"),
        ("m_abs", '<ssc:Unit name="m_abs"><ssc:BaseUnit m="1" offset="2"/></ssc:Unit>', "offset"),
    ],
)
@pytest.mark.parametrize("target", ["scene", "fmu"])
def test_a_unit_that_cannot_be_converted_is_refused(capsys, tmp_path, target, unit, units, message):
    file = set_of(tmp_path, real("length", 1, unit), units=units)
    scene = measured(tmp_path)
    given = scene if target == "scene" else build(scene, tmp_path / "a.fmu")
    code, out, err = run(capsys, "simulate", given, "--parameters", file)
    assert (code, out) == (2, "")
    expected = {
        "unit": f"{file}:4: error: length: given in {unit!r}, but has the unit 'm'\n",
        "offset": f"{file}:4: error: length: the unit {unit!r} has an offset\n",
    }
    assert err.startswith(expected[message])


def test_the_longest_step_is_a_setting_of_the_scene_in_whatever_unit(tmp_path):
    changes = {"solver.tolerance": 1e-6, "solver.longest_step": 0.02}
    build(PENDULUM, tmp_path / "a.fmu", parameters=changes)
    text = (tmp_path / "a.ssv").read_text()
    assert text.count('value="0.02" unit="s"') == 1
    other = text.replace('value="0.02" unit="s"', 'value="20.0" unit="ms"', 1)
    other = other.replace('<ssc:Unit name="s">', '<ssc:Unit name="ms">'
        '<ssc:BaseUnit s="1" factor="0.001"/></ssc:Unit><ssc:Unit name="s">')  # fmt: skip
    fmu = build(PENDULUM, tmp_path / "b.fmu", parameters=written(tmp_path, "b2.ssv", other))
    assert model_of(fmu) == model_of(tmp_path / "a.fmu")


@pytest.mark.parametrize(
    ("text", "report"),
    [
        (
            '<?xml version="1.0" encoding="klingon"?><a/>',
            "set.ssv:1:39: error: not XML: Unsupported encoding: klingon",
        ),
        (
            '<?xml version="1.0" encoding="ascii"?><a>\u00fc</a>',
            "set.ssv:1:",
        ),
        (
            SET.format(
                parameters='<ssv:Parameter name="a"><ssv:Real value="1"/>\n'
                '<ssv:Real value="2"/></ssv:Parameter>',
                units="",
            ),
            "set.ssv:5: error: a: has two values\n  = help: the first is in line 4",
        ),
        (
            SET.format(parameters=real("a", 1, "m") + "\n" + real("a", 2, "m"), units=""),
            "set.ssv:5: error: a: given twice, first at set.ssv:4",
        ),
        (
            SET.format(parameters=real("a", "INF", "m"), units=""),
            "set.ssv:4: error: a: must be a finite number, got inf",
        ),
        (
            SET.format(parameters="", units=f"{FOOT}\n{FOOT}"),
            "set.ssv:7: error: unit 'ft': defined twice, first in line 6",
        ),
        *(
            (
                SET.format(
                    parameters="",
                    units=f'<ssc:Unit name="u"><ssc:BaseUnit factor="{factor}"/></ssc:Unit>',
                ),
                f"set.ssv:6: error: unit 'u': factor must be a finite number > 0, got '{factor}'",
            )
            for factor in ("0", "nan", "INF", "-1")
        ),
        (
            SET.format(
                parameters="", units='<ssc:Unit name="u"><ssc:BaseUnit factor="x"/></ssc:Unit>'
            ),
            "set.ssv:6: error: unit 'u': factor must be a number, got 'x'",
        ),
    ],
    ids=[
        "encoding",
        "multibyte",
        "two values",
        "twice",
        "infinite",
        "unit twice",
        "factor 0",
        "factor nan",
        "factor inf",
        "factor -1",
        "unit",
    ],
)
def test_mistakes_of_a_set_name_their_line(tmp_path, monkeypatch, text, report):
    monkeypatch.chdir(tmp_path)
    written(tmp_path, "set.ssv", text)
    with pytest.raises(UsageError) as caught:
        refuse(entry.wrong for entry in entries_of_files(["set.ssv"]).values() if entry.wrong)
    assert str(caught.value).startswith(report)


HELP_OF_UNITS = {
    "kg": "'kg' measures something else; give the value in m",
    "furlong": "'furlong' is not known, and the file does not define it; give the value in m",
}


@pytest.mark.parametrize("unit", HELP_OF_UNITS)
@pytest.mark.parametrize("target", ["scene", "fmu"])
def test_a_wrong_unit_is_one_mistake_with_its_remedy(capsys, tmp_path, target, unit):
    """Nobody knows then whether the value is within its limits."""
    scene = measured(tmp_path)
    scene.write_text(scene.read_text().replace('unit = "m"', 'unit = "m", max = 3'))
    given = scene if target == "scene" else build(scene, tmp_path / "a.fmu")
    file = set_of(tmp_path, real("length", 500, unit))
    code, _, err = run(capsys, "simulate", given, "--parameters", file)
    first = f"{file}:4: error: length: given in {unit!r}, but has the unit 'm'\n"
    assert (code, err) == (2, f"{first}  = help: {HELP_OF_UNITS[unit]}\n")


@pytest.mark.parametrize("target", ["scene", "fmu"])
def test_a_count_of_the_solver_has_no_unit(capsys, tmp_path, target):
    file = set_of(tmp_path, real("solver.max_newton", 20, "kg"))
    given = PENDULUM if target == "scene" else build(PENDULUM, tmp_path / "a.fmu")
    code, _, err = run(capsys, "simulate", given, "--parameters", file)
    assert code == 2
    first = f"{file}:4: error: solver.max_newton: given in 'kg', but has no unit\n"
    assert err == f"{first}  = help: leave the unit out\n"


@pytest.mark.parametrize("target", ["scene", "fmu"])
def test_a_value_that_cannot_be_read_and_an_unknown_name_are_told_in_one_run(
    capsys, tmp_path, target
):
    file = set_of(tmp_path, real("length", "long", "m"), real("lenth", 1, "m"))
    scene = measured(tmp_path)
    given = scene if target == "scene" else build(scene, tmp_path / "a.fmu")
    code, _, err = run(capsys, "simulate", given, "--parameters", file)
    assert code == 2
    assert f"{file}:4: error: length: must be a number, got 'long'" in err
    assert f"{file}:5: error: " in err
    assert "did you mean 'length'?" in err


def test_a_set_is_valid_whatever_a_description_has(tmp_path):
    scene = measured(tmp_path)
    text = scene.read_text().replace('unit = "kg"', 'unit = "kg", description = "a\\u0001b<&\\n"')
    fmu = build(written(tmp_path, "strange.toml", text), tmp_path / "a.fmu")
    etree.XMLSchema(etree.parse(SCHEMA)).assertValid(etree.parse(fmu.with_suffix(".ssv")))
