"""The README says what happens: its scene, its Python, its options and its commands are run."""

from __future__ import annotations

import dataclasses
import re
import shlex
import textwrap
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import solver
from build_fmu import command_line
from solver import scene

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")


def fenced(language: str) -> str:
    """Return the one fenced block of a language."""
    (block,) = re.findall(rf"^```{language}\n(.*?)^```", README, re.DOTALL | re.MULTILINE)
    return block


def option_defaults() -> dict[str, str]:
    """Default of each option, as the README's table has it."""
    table = README.partition("| option | values | default |")[2].partition("\n\n")[0]
    rows = re.findall(r"^\| (`.*?) \| .* \| (.*?) \|$", table, re.MULTILINE)
    pairs = [
        (name, value)
        for names, values in rows
        for name, value in zip(names.split(", "), values.split(", "), strict=True)
    ]
    return {name.strip("`"): value.strip("`") for name, value in pairs}


def commands() -> list[str]:
    """Commands that the README shows, without their comments."""
    lines = re.findall(r"^    (build-fmu .*)$", README, re.MULTILINE)
    return [line.partition("  #")[0].rstrip() for line in lines]


def test_the_scene_of_the_first_screen_has_ten_lines_and_runs():
    text = fenced("toml")
    assert len(text.splitlines()) == 10
    trajectory = solver.simulate(solver.assemble(scene.loads(text)), stop_time=2.0)
    assert abs(trajectory["energy.error"]).max() < 1e-11  # round-off of 200 steps


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


@pytest.mark.parametrize(("option", "text"), option_defaults().items())
def test_the_defaults_are_those_of_the_code(option, text):
    value = getattr(scene.loads(fenced("toml")).solver, option)
    number = isinstance(value, int | float) and not isinstance(value, bool)
    assert value == (float(text) if number else {"true": True, "false": False}.get(text, text))


def test_every_option_is_in_the_table():
    options = {field.name for field in dataclasses.fields(scene.SolverSettings)}
    assert options == {"formulation", "order", *option_defaults()}


@pytest.mark.parametrize("command", commands())
def test_the_commands_exist(command):
    arguments = shlex.split(command)[1:]
    parsed = command_line._parser().parse_args(arguments)
    assert parsed.command == arguments[0]
