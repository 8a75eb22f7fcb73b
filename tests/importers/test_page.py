"""docs/importers.md tells of every importer what the tests run, and nothing else."""

from __future__ import annotations

import re
import sys

import pytest

from tests.importers import tools
from tests.importers.page import HEAD, PAGE, row_text, rows
from tests.importers.tools import DRIVERS, REQUIRED, ROOT, TOOLS, missing, version


@pytest.mark.skipif(bool(REQUIRED), reason="the table is renewed after this run")
def test_the_table_has_a_row_of_each_importer():
    page = PAGE.read_text(encoding="utf-8")
    found = rows(page)
    table = page.partition(HEAD)[2].partition("\n\n")[0]
    assert table.splitlines() == [
        row_text(tool, found[tool.name]["version"], found[tool.name]["date"]) for tool in TOOLS
    ]


def test_make_runs_every_importer():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    lists = re.findall(r"export IMPORTERS = (.*)", makefile)
    named = {name for line in lists for name in line.split()}
    assert named == {tool.name for tool in TOOLS if not tool.program}
    coupled = {path.name.removesuffix("_driver.py") for path in DRIVERS.glob("*_driver.py")}
    assert coupled == {tool.module for tool in TOOLS if not tool.program} - {"fmpy"}


def test_the_page_has_a_recipe_of_each_program():
    page = PAGE.read_text(encoding="utf-8")
    for tool in TOOLS:
        if tool.program:
            assert f"export {tool.program}=" in page
            assert tool.revision.rpartition("-g")[2] in page.partition("## Recipes")[2]


def test_what_has_to_be_there_is_there():
    wanted = [tool for tool in TOOLS if tool.name in REQUIRED]
    assert not [missing(tool) for tool in wanted if missing(tool)]
    assert all(version(tool) for tool in wanted)


def test_an_importer_that_is_missing_skips_a_test_or_fails_it_where_it_is_required(monkeypatch):
    monkeypatch.setattr(tools, "missing", lambda _: "not installed")
    monkeypatch.setattr(tools, "REQUIRED", [])
    with pytest.raises(pytest.skip.Exception, match="libcosimpy: not installed"):
        tools.need("libcosimpy")
    monkeypatch.setattr(tools, "REQUIRED", ["libcosimpy"])
    with pytest.raises(pytest.fail.Exception, match="libcosimpy: not installed"):
        tools.need("libcosimpy")


def test_an_importer_that_hangs_is_ended_and_named(monkeypatch):
    monkeypatch.setattr(tools, "LONGEST", 0.5)
    hanging = [sys.executable, "-c", "import time; time.sleep(60)"]
    with pytest.raises(pytest.fail.Exception, match=r"fmpy: ended, as it still ran after 0\.5 s"):
        tools.run_of(tools.BY_NAME["fmpy"], hanging)
