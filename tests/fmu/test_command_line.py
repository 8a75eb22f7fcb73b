"""The command line: results on stdout, messages on stderr, exit codes that mean something."""

from __future__ import annotations

import json
import math
import re
import subprocess
import sys
import zipfile

import pytest

from build_fmu import build
from build_fmu.command_line import main, setting
from build_fmu.errors import EnvironmentLackError
from build_fmu.instance import check_unpack_folder
from build_fmu.printing import number, progress_bar
from build_fmu.run import run_fmu
from examples import demo
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, scene_fmu

ROOT = SCENES.parent
PENDULUM = str(SCENES / "double_pendulum.toml")

# ------------------------------------------------------------------------------------ build


def test_build_names_the_fmu_on_stdout_and_the_parameter_set_beside_it(capsys, tmp_path):
    code, out, err = run(capsys, "build", PENDULUM, "-o", tmp_path / "a.fmu")
    assert (code, out) == (0, f"{tmp_path / 'a.fmu'}\n")
    assert err.endswith(f"its parameter set is in {tmp_path / 'a.ssv'}\n")


def test_build_writes_what_the_python_function_writes(capsys, tmp_path):
    code, out, _ = run(capsys, "build", PENDULUM, "-o", tmp_path / "a.fmu")
    assert (code, out) == (0, f"{tmp_path / 'a.fmu'}\n")
    assert (tmp_path / "a.fmu").read_bytes() == scene_fmu("double_pendulum").read_bytes()


def test_set_replaces_any_number_of_the_scene(capsys, tmp_path):
    settings = {"mass": 2.0, "points.B.velocity": [0, 3], "solver.step_size": 0.02}
    arguments = [f"--set={name}={value}" for name, value in settings.items()]
    run(capsys, "build", PENDULUM, "-o", tmp_path / "a.fmu", *arguments)
    build(PENDULUM, tmp_path / "b.fmu", parameters=settings)
    assert (tmp_path / "a.fmu").read_bytes() == (tmp_path / "b.fmu").read_bytes()
    info = json.loads(run(capsys, "info", tmp_path / "a.fmu", "--json")[1])
    assert next(v["start"] for v in info["variables"] if v["name"] == "mass") == 2.0


def test_a_bad_scene_ends_with_2_and_its_report(capsys, tmp_path):
    scene = tmp_path / "bad.toml"
    scene.write_text('name = "bad"\ndimension = 2\n[points]\nA = { position = [0, 0], mas = 1 }\n')
    code, out, err = run(capsys, "build", scene)
    assert (code, out) == (2, "")
    assert err.startswith(f"{scene}:4: error: points.A.mas")
    assert "did you mean 'mass'?" in err


@pytest.mark.parametrize(
    "arguments",
    [
        ("build", "missing.toml"),
        ("simulate", "missing.fmu"),
        ("validate", PENDULUM),
        ("check", PENDULUM, "--step", "-1"),
        ("simulate", PENDULUM, "--stop", "-1"),
        ("simulate", PENDULUM, "--csv", "-", "--json"),
    ],
    ids=" ".join,
)
def test_a_usage_error_ends_with_2_and_one_line(capsys, arguments):
    code, out, err = run(capsys, *arguments)
    assert (code, out) == (2, "")
    assert err.startswith("holonom: ")
    assert err.count("\n") == 1


@pytest.mark.parametrize("argument", ["--nonsense", "--set=mass", "--set=gravity=[1", "--set==1"])
def test_an_argument_that_cannot_be_read_ends_with_2(argument):
    with pytest.raises(SystemExit, match="2"):
        main(["build", PENDULUM, argument])


@pytest.mark.parametrize(
    ("text", "name", "value"),
    [
        ("a=1", "a", 1),
        ("points.A.mass = 2.5", "points.A.mass", 2.5),
        ("a=1e-3", "a", 1e-3),
        ("gravity=[0, -9.81]", "gravity", [0, -9.81]),
        ("solver.assemble=false", "solver.assemble", False),
        ("solver.start=equilibrium", "solver.start", "equilibrium"),
        ("length=2*width", "length", "2*width"),
        ("a=b=c", "a", "b=c"),
    ],
)
def test_a_setting_is_a_number_a_truth_value_a_list_or_text(text, name, value):
    assert setting(text) == (name, value)
    assert type(setting(text)[1]) is type(value)


# --------------------------------------------------------------------------------- validate


def test_validate_lists_the_findings(capsys, tmp_path):
    assert run(capsys, "validate", scene_fmu("four_bar")) == (0, "no finding\n", "")
    broken = tmp_path / "broken.fmu"
    with zipfile.ZipFile(broken, "w") as archive:
        archive.writestr("modelDescription.xml", '<fmiModelDescription fmiVersion="2.0"/>')
    code, out, _ = run(capsys, "validate", broken, "--json")
    assert code == 1
    assert json.loads(out)["findings"]


# ------------------------------------------------------------------------------------- start


def test_help_waits_for_nothing_heavy():
    command = [sys.executable, "-X", "importtime", "-m", "build_fmu", "--help"]
    process = subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT)
    assert process.stdout.startswith("usage: holonom")
    modules = {line.split("|")[-1].strip() for line in process.stderr.splitlines()}
    modules -= {
        "solver",
        "solver.extras",
        "solver.files",
    }  # where names are, and which file names a command may write; they import nothing else
    heavy = {"numpy", "scipy", "rich", "fmpy", "pythonfmu", "solver", "zipfile"}
    assert not {name.split(".")[0] for name in modules} & heavy


# -------------------------------------------------------------------------------------- demo


def test_the_exact_motion_of_the_demonstration_is_that_of_the_benchmark():
    reference = {  # the equation of one degree of freedom, integrated once more to 1e-13
        1.0: (-0.195020302, -0.980799206),
        2.0: (0.057815796, 0.998327268),
        5.0: (-0.811310461, -0.584615545),
        10.0: (0.328458112, 0.944518538),
    }
    angles = demo.exact_angle([*reference])
    for angle, (x, y) in zip(angles, reference.values(), strict=True):
        assert (math.sin(angle), math.cos(angle)) == pytest.approx((x, y), abs=2e-9)


def test_the_demonstration_comes_to_its_end(capsys):
    assert demo.main() == 0
    out = capsys.readouterr().out
    assert "largest energy error" in out
    assert "finished" in out
    # The page on this run has rows of 20 ms, the demonstration of 50 ms.
    page = (ROOT / "docs/explanation/midpoint.md").read_text("utf-8")
    lost = re.search(r"off by 1 % of the largest kinetic energy after ([\d.]+) s", page)
    told = re.search(r"energy off by 0.7 J, 1 %, at t = ([\d.]+) s", out)
    assert 0.0 <= float(told[1]) - float(lost[1]) <= 0.05


def test_the_largest_kinetic_energy_of_the_demonstration_is_that_of_its_fmu():
    """By hand: I/2 + 2 W g, of 1.5 J at the start and a fall of 7 kg m."""
    assert demo.largest_kinetic_energy() == pytest.approx(1.5 + 7.0 * 9.81, rel=1e-15)
    kinetic = run_fmu(scene_fmu("four_bar"), step_size=0.005, stop_time=1.5).values[
        "energy.kinetic"
    ]
    assert kinetic.max() == pytest.approx(demo.largest_kinetic_energy(), rel=1e-3)


def test_tables_have_no_negative_zero():
    assert [number(x) for x in (-0.0, 0.0, -1.5)] == [" 0", " 0", "-1.5"]


def test_progress_runs_from_0_to_1():
    parts = []
    run_fmu(scene_fmu("four_bar"), stop_time=1.0, step_size=0.25, progress=parts.append)
    assert parts == pytest.approx([0.25, 0.5, 0.75, 1.0])


def test_progress_is_shown_on_a_terminal_only(capsys, monkeypatch):
    with progress_bar("title") as progress:
        assert progress is None
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    with progress_bar("title") as progress:
        progress(0.5)
    out, err = capsys.readouterr()
    assert out == ""
    assert "title" in err


@pytest.mark.parametrize("name", ["c#d", "a+b", "ü"])
def test_a_temporary_folder_that_would_end_the_process_is_refused(name, tmp_path):
    # pythonfmu's library decodes %20 alone and crashes where other characters are escaped.
    check_unpack_folder(tmp_path / "with a blank")
    with pytest.raises(EnvironmentLackError, match="set TMPDIR"):
        check_unpack_folder(tmp_path / name)


@pytest.mark.parametrize(
    ("word", "meant"),
    [("--stop-time", "--stop"), ("--step-size", "--step"), ("--stoptime", "--stop"),
     ("--duration", "--stop"), ("--dt", "--step"), ("--sett", "--set"), ("--inputt", "--inputs")],
)  # fmt: skip
@pytest.mark.parametrize("command", ["simulate", "check"])
def test_an_unknown_option_suggests_the_one_that_it_may_mean(capsys, command, word, meant):
    with pytest.raises(SystemExit, match="2"):
        main([command, PENDULUM, word, "1"])
    err = capsys.readouterr().err
    assert (
        f"holonom {command}: error: unrecognized arguments: {word} 1; did you mean {meant}?" in err
    )


def test_an_option_that_resembles_none_suggests_none(capsys):
    with pytest.raises(SystemExit, match="2"):
        main(["build", PENDULUM, "--zzz"])
    assert "did you mean" not in capsys.readouterr().err


@pytest.mark.parametrize("command", ["build", "simulate", "check", "info", "validate", "sweep"])
def test_an_abbreviated_help_shows_the_help(capsys, command):
    with pytest.raises(SystemExit) as end:
        main([command, "--h"])
    assert end.value.code == 0
    assert capsys.readouterr().out.startswith(f"usage: holonom {command}")
