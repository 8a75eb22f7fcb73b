"""The package `holonom`: the one name that users import, and the command of the same name."""

from __future__ import annotations

import ast
import importlib
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import build_fmu
import build_fmu.testing
import holonom
import solver
from build_fmu.payload import payload

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted([ROOT / "README.md", *(ROOT / "docs").rglob("*.md")])


def imported_for_types() -> dict[str, str]:
    """Names that a type checker finds in the package, each with the module it comes from."""
    tree = ast.parse(Path(holonom.__file__).read_text(encoding="utf-8"))
    branch = next(node for node in tree.body if isinstance(node, ast.If))
    found = {}
    for statement in branch.body:
        assert isinstance(statement, ast.ImportFrom)
        home = importlib.import_module(statement.module or "")
        names = [alias.name for alias in statement.names]
        found |= dict.fromkeys(home.__all__ if names == ["*"] else names, home.__name__)
    return found


def test_everything_that_is_public_elsewhere_is_in_the_package():
    assert {*solver.__all__, *build_fmu.__all__} < set(holonom.__all__)
    assert {"CommandError", "EnvironmentLackError", "UsageError", "run_fmu"} < set(holonom.__all__)


@pytest.mark.parametrize("name", holonom.__all__)
def test_a_name_is_listed_for_people_and_type_checkers_and_is_the_same_object(name):
    home = importlib.import_module(imported_for_types()[name])
    assert name in dir(holonom)
    assert getattr(holonom, name) is getattr(home, name)


def test_no_name_is_promised_to_a_type_checker_alone():
    assert set(imported_for_types()) == set(holonom.__all__)


def test_a_name_that_is_not_there_is_an_attribute_error():
    with pytest.raises(AttributeError, match="module 'holonom' has no attribute 'simulte'"):
        holonom.simulte  # noqa: B018


def test_the_assertions_for_users_are_those_of_build_fmu():
    names = importlib.import_module("holonom.testing")
    for name in ("assert_conserves", "assert_follows"):
        assert getattr(names, name) is getattr(build_fmu.testing, name)


def test_importing_it_loads_no_library_and_reads_no_scene_code():
    # Counted, not timed: what takes its time are NumPy, fmpy and our own readers.
    code = "import sys, holonom; dir(holonom); print(*sys.modules)"
    loaded = run(sys.executable, "-c", code).split()
    heavy = {"numpy", "scipy", "rich", "fmpy", "pythonfmu", "argparse", "zipfile"}
    assert not {name.partition(".")[0] for name in loaded} & heavy
    assert [name for name in loaded if name.startswith("solver.")] == ["solver.extras"]


@pytest.mark.parametrize("module", ["holonom", "build_fmu"])
def test_both_commands_are_one_and_call_themselves_holonom(module):
    shown = run(sys.executable, "-m", module, "--help")
    assert shown.startswith("usage: holonom ")
    assert "build-fmu" not in shown


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pages_teach_one_command_and_one_import(page):
    text = page.read_text(encoding="utf-8")
    assert not re.findall(r"^ +(?:\$ )?build-fmu .*", text, re.MULTILINE)
    assert not re.findall(r"^ *(?:import|from) (?:solver|build_fmu)\b.*", text, re.MULTILINE)


def test_messages_and_help_name_one_command():
    sources = [path.read_text(encoding="utf-8") for path in (ROOT / "build_fmu").rglob("*.py")]
    assert not [text for text in sources if "build-fmu" in text]


def test_no_file_of_the_package_travels_in_an_fmu():
    names = [Path(name).parts for dimension in (2, 3) for name in payload(dimension, "points")]
    assert not [parts for parts in names if "holonom" in parts]


def run(*command: str) -> str:
    """Standard output of a command that succeeds."""
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    return subprocess.check_output(command, text=True, env=environment, cwd=ROOT)
