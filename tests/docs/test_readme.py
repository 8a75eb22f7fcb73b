"""README and the page of settings say what happens: scenes, Python, options, commands are run."""

from __future__ import annotations

import re
import shlex
import textwrap
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import solver
from build_fmu import command_line
from scenes import generate
from solver import scene

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def fenced(language: str, place: int = 0) -> str:
    """Return a fenced block of a language."""
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.DOTALL | re.MULTILINE)[place]


def commands() -> list[str]:
    """Commands that the README shows, without their comments."""
    lines = re.findall(r"^    (holonom .*)$", README, re.MULTILINE)
    return [line.partition("  #")[0].rstrip() for line in lines]


def test_the_scene_of_the_first_screen_has_ten_lines_and_runs():
    text = fenced("toml")
    assert len(text.splitlines()) == 10
    trajectory = solver.simulate(solver.assemble(scene.loads(text)), stop_time=2.0)
    assert abs(trajectory["energy.error"]).max() < 1e-11  # round-off of 200 steps


def test_the_scene_in_space_runs_and_has_the_outputs_that_are_promised():
    model = solver.assemble(scene.loads(fenced("toml", 1)))
    trajectory = solver.simulate(model, stop_time=2.0)
    assert abs(trajectory["energy.error"]).max() < 1e-11  # round-off of 200 steps
    assert trajectory["motor.torque"].max() > 1.0  # N.m: it turns the arm from rest
    assert "shoulder.force.z" in trajectory.names


def test_it_is_short():
    assert len(README.splitlines()) <= 120


def test_every_scene_is_in_the_table():
    table = (ROOT / "scenes" / "README.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`(\w+)`", table))
    names = {path.stem for path in (ROOT / "scenes").glob("*.toml")}
    assert names <= named
    assert named - names == set(generate.GENERATORS) - {"hanging_chain"}


def test_check_prints_of_the_first_scene_what_the_first_screens_show(capsys, tmp_path):
    """But for round-off of energy and constraints."""
    (tmp_path / "pendulum.toml").write_text(fenced("toml"), encoding="utf-8")
    assert command_line.main(["check", str(tmp_path / "pendulum.toml")]) == 0
    found = capsys.readouterr().out.partition("differences from")
    text = "".join(f"    {line}\n" if line else "\n" for line in "".join(found[1:]).splitlines())
    for page in (README, (ROOT / "docs" / "index.md").read_text(encoding="utf-8")):
        assert text in page


def test_the_report_of_mistakes_is_what_a_scene_with_these_mistakes_gets():
    text = fenced("toml").replace("[2, 0], mass", "[2, 0], mas").replace('"B"] }', '"Bx"] }')
    with pytest.raises(scene.SceneError) as failure:
        scene.loads(text, name="pendulum.toml")
    assert textwrap.indent(str(failure.value), "    ") in README


def test_the_python_example_runs(monkeypatch):
    monkeypatch.chdir(ROOT)
    names: dict[str, Any] = {}
    exec(compile(fenced("python"), "README.md", "exec"), names)
    trajectory = names["trajectory"]
    assert trajectory.t.shape == trajectory["B.x"].shape == (201,)
    assert (trajectory.t[0], trajectory.t[-1]) == (0.0, 10.0)
    assert 0.0 < trajectory["energy.error"].max() < 1e-11  # round-off of 1000 steps
    assert np.ptp(trajectory["energy.kinetic"]) > 10.0  # J: the bars have swung


def test_the_commands_run_one_after_the_other(monkeypatch, tmp_path, capsys):
    (tmp_path / "scenes").symlink_to(ROOT / "scenes")
    monkeypatch.chdir(tmp_path)
    shown = [shlex.split(command)[1:] for command in commands()]
    assert {words[0] for words in shown} == {
        "build",
        "variants",
        "simulate",
        "sweep",
        "check",
        "info",
        "validate",
    }
    for words in shown:
        assert command_line.main(words) == 0, capsys.readouterr()
    assert (tmp_path / "out.csv").is_file()
