"""docs/variants.md: what it says can be pasted, from the root of a clone, into any shell."""

from __future__ import annotations

import inspect
import re
import shlex
from pathlib import Path

import pytest

import build_fmu
from build_fmu import command_line

ROOT = Path(__file__).resolve().parents[2]
GUIDE = (ROOT / "docs" / "variants.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^    holonom (.*)$", GUIDE, flags=re.MULTILINE)
ARGUMENTS = re.findall(r"^\| (`-[^|]*`) \| (`[^|]*`) \|$", GUIDE, flags=re.MULTILINE)


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_name_scenes_that_are_there_or_fmus_that_are_built_before(command):
    arguments = command_line._parser().parse_args(shlex.split(command, comments=True))
    target = arguments.scene if "scene" in arguments else arguments.target
    built = re.findall(r"build \S+ -o (\S+\.fmu)", "\n".join(COMMANDS[: COMMANDS.index(command)]))
    assert (ROOT / target).is_file() or target in built


@pytest.mark.parametrize(("options", "names"), ARGUMENTS)
def test_arguments_have_the_names_in_python_that_the_guide_gives_them(capsys, options, names):
    functions = (build_fmu.variants, build_fmu.sweep)
    known = {name for each in functions for name in inspect.signature(each).parameters}
    assert set(re.findall(r"`(\w+)`", names)) <= known
    helps = ""
    for command in ("variants", "sweep"):
        with pytest.raises(SystemExit):
            command_line.main([command, "--help"])
        helps += capsys.readouterr().out
    assert not [each for each in re.findall(r"-[\w-]+", options) if each not in helps]


def test_the_guide_has_a_table_of_arguments():
    assert len(ARGUMENTS) > 4


@pytest.mark.parametrize("page", sorted((ROOT / "docs").glob("*.md")), ids=lambda page: page.stem)
def test_extras_are_in_quotes_which_zsh_needs(page):
    assert not re.findall(r"pip install [\w.]+\[", page.read_text(encoding="utf-8"))
