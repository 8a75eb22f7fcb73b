"""Pages of runs: what is in the file, and what is said where none can be written."""

from __future__ import annotations

import base64
import json
import re
import subprocess
import sys
import zlib
from pathlib import Path

import pytest

import solver
from build_fmu import build
from build_fmu.command_line import main

SCENES = Path(__file__).parents[2] / "scenes"
PENDULUM = str(SCENES / "double_pendulum.toml")
ANY_ADDRESS = re.compile(r"""(?:src|href|url)\s*[=(]\s*["']?(?:https?:)?//""")


def data_of(page: Path) -> dict:
    text = page.read_text(encoding="utf-8")
    found = re.search(r'<script type="text/plain" id="data">(.*?)</script>', text)
    assert found
    return json.loads(zlib.decompress(base64.b64decode(found[1])))


@pytest.mark.parametrize("name", ["four_bar", "stewart", "double_wishbone", "pile_of_discs"])
def test_a_page_is_small_and_names_no_address(name, tmp_path):
    page = solver.simulate(SCENES / f"{name}.toml").report(tmp_path / "page.html")
    assert page.stat().st_size < 1_000_000
    assert not ANY_ADDRESS.search(page.read_text(encoding="utf-8"))


@pytest.mark.parametrize("command", ["simulate", "check"])
def test_commands_write_a_page(command, tmp_path):
    page = tmp_path / "run.html"
    assert main([command, PENDULUM, "--stop", "1", "--report", str(page)]) == 0
    data = data_of(page)
    assert data["name"] == "double_pendulum"
    assert data["runs"][0]["facts"][0]["value"] == "finished"


PROFILED = """
name = "pushed"
dimension = 2
[inputs]
pull = { start = 0.5 }
[profiles]
p = { file = "p.csv" }
[points]
A = { position = [0, 0], mass = 1 }
[forces]
push = { type = "force", point = "A", value = ["p(t)", "pull"] }
[experiment]
stop_time = 0.2
step_size = 0.1
"""


@pytest.fixture
def profiled(tmp_path):
    """Path of a scene whose force is a profile of a CSV file, y = x^2 at 0, 1 and 2."""
    (tmp_path / "p.csv").write_text("x,y\n0,0\n1,1\n2,4\n")
    (tmp_path / "m.toml").write_text(PROFILED)
    return tmp_path / "m.toml"


@pytest.mark.parametrize("command", ["simulate", "check"])
@pytest.mark.parametrize("built", [False, True])
def test_a_scene_with_a_profile_of_a_file_becomes_a_page(command, built, profiled):
    """Also as an FMU, which holds the points of the profile, far from the file."""
    target, page = profiled, profiled.parent / "run.html"
    if built:
        target = profiled.with_suffix(".fmu")
        overrides = ["--set", "pull=0.25", "--set", "points.A.mass=2*0.5"]
        assert main(["build", str(profiled), "-o", str(target), *overrides]) == 0
        (profiled.parent / "p.csv").unlink()
    assert main([command, str(target), "--report", str(page)]) == 0
    assert data_of(page)["name"] == "pushed"


def test_a_page_that_cannot_be_written_loses_no_table(profiled, capsys):
    table, page = profiled.parent / "o.csv", profiled.parent / "a file" / "page.html"
    page.parent.write_text("no folder")
    command = ["simulate", str(profiled), "--csv", str(table), "--report", str(page)]
    assert main(command) != 0
    assert "a file" in capsys.readouterr().err
    assert len(table.read_text().splitlines()) == 4


def test_a_page_does_not_change_what_a_command_prints(tmp_path, capsys):
    assert main(["simulate", PENDULUM, "--stop", "1", "--csv", "-"]) == 0
    without = capsys.readouterr().out
    page = str(tmp_path / "run.html")
    assert main(["simulate", PENDULUM, "--stop", "1", "--csv", "-", "--report", page]) == 0
    assert capsys.readouterr().out == without


def test_a_sweep_shows_each_run_with_its_values(tmp_path):
    page, grid = tmp_path / "sweep.html", "length=0.5:1.5:3"
    results = str(tmp_path / "sweep.csv")
    command = [
        "sweep",
        PENDULUM,
        "--grid",
        grid,
        "--stop",
        "1",
        "-o",
        results,
        "--engine",
        "serial",
    ]
    assert main([*command, "--output", "B.x", "--report", str(page)]) == 0
    data = data_of(page)
    assert [run["parameters"]["length"] for run in data["runs"]] == [0.5, 1.0, 1.5]
    assert len(data["drawings"]) == 3  # places depend on the length


def test_variants_show_each_fmu(tmp_path):
    page = tmp_path / "variants.html"
    command = ["variants", PENDULUM, "--grid", "points.A.mass=1,2", "-o", str(tmp_path / "fmus")]
    assert main([*command, "--engine", "serial", "--report", str(page)]) == 0
    assert [run["parameters"]["points.A.mass"] for run in data_of(page)["runs"]] == [1, 2]


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """An FMU, and the results of a run in another program."""
    folder = tmp_path_factory.mktemp("results")
    fmu, table = build(PENDULUM, folder), folder / "any.csv"
    trajectory = solver.simulate(PENDULUM, stop_time=1.0)
    rows = [",".join(["time", *trajectory.names])]
    rows += [
        ",".join(map(repr, [float(t), *row.tolist()]))
        for t, row in zip(trajectory.t, trajectory.table, strict=True)
    ]
    table.write_text("\n".join(rows))
    return str(fmu), table


def test_results_of_any_program_become_a_page(results, tmp_path):
    fmu, table = results
    page = tmp_path / "page.html"
    assert main(["report", fmu, "--results", str(table), "-o", str(page)]) == 0
    assert data_of(page)["runs"][0]["n"] == len(table.read_text().splitlines()) - 1


def test_missing_columns_are_named(results, tmp_path, capsys):
    fmu, table = results
    other = tmp_path / "other.csv"
    other.write_text(table.read_text().replace("B.y", "height", 1))
    assert main(["report", fmu, "--results", str(other), "-o", str(tmp_path / "p.html")]) == 2
    assert "has no column B.y, by which double_pendulum is drawn" in capsys.readouterr().err


def test_results_without_times_are_refused(results, tmp_path, capsys):
    fmu, table = results
    other = tmp_path / "other.csv"
    other.write_text(table.read_text().replace("time", "t", 1))
    assert main(["report", fmu, "--results", str(other), "-o", str(tmp_path / "p.html")]) == 2
    assert "time" in capsys.readouterr().err


def test_a_trajectory_of_few_outputs_says_what_is_missing(tmp_path):
    trajectory = solver.simulate(PENDULUM, outputs=["energy.error"], stop_time=0.1)
    with pytest.raises(solver.OptionError, match=r"A\.x, A\.y, B\.x, B\.y not collected"):
        trajectory.report(tmp_path / "page.html")


def test_what_is_no_number_is_null(tmp_path):
    from viewer.report import filled

    page = tmp_path / "page.html"
    page.write_text(filled({"name": "x", "values": [float("nan"), float("inf")]}))
    assert data_of(page)["values"] == [None, None]


@pytest.mark.parametrize("module", ["holonom", "build_fmu.command_line", "solver.trajectory"])
def test_nothing_of_the_viewer_is_imported_unless_it_is_used(module):
    code = f"import sys, {module}; sys.exit(any(m.startswith('viewer') for m in sys.modules))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


CARRIED = """
name = "carried"
dimension = 2
gravity = [0, -9.81]
[bodies]
arm = { position = [0, 0], mass = 1, inertia = 0.1, center_of_mass = [0.5, 0] }
[joints]
pin = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
[sensors]
imu = { type = "imu", body = "arm", at = [1, 0] }
[outputs]
felt = { value = "arm.angular_acceleration", unit = "rad/s2" }
"""


@pytest.mark.parametrize("of_fmu", [False, True], ids=["run in Python", "FMU"])
def test_a_page_plots_outputs_and_then_what_sensors_show(of_fmu, tmp_path):
    scene, page = tmp_path / "carried.toml", tmp_path / "page.html"
    scene.write_text(CARRIED, encoding="utf-8")
    if of_fmu:
        fmu = build(scene, tmp_path / "carried.fmu")
        assert main(["simulate", str(fmu), "--stop", "1", "--report", str(page)]) == 0
    else:
        solver.simulate(scene).report(page)
    data = data_of(page)
    plotted = [plot["names"] for plot in data["plots"]]
    assert plotted[:3] == [["felt"], ["imu.fx", "imu.fy"], ["imu.w"]]
