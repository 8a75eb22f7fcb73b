"""Benchmarks: their exact solutions are exact, their code runs; nothing here asserts a time."""

from __future__ import annotations

import itertools
import json
import math
from importlib import import_module
from pathlib import Path

import pytest

from benchmarks import __main__ as command
from benchmarks.measuring import kernel_run
from benchmarks.measuring.effort import QUICK, TINY, Effort
from benchmarks.measuring.observe import Observer
from benchmarks.measuring.timing import Entry, interleave
from benchmarks.pages.report import Goal, Section, as_json, as_markdown, merged
from benchmarks.problems.mechanisms import (
    four_bar,
    free_system,
    hanging_chain,
    scene,
    start,
    waving_chain,
)
from benchmarks.sections import instructions, skips
from benchmarks.sections.work_precision_ours import STEPPED_BY
from solver import assemble
from tests.support.kernel.kernels_without_skips import kernel_without

ROOT = Path(__file__).resolve().parents[2]
MACHINE = {"processor": "some", "cores": "1"}

# --------------------------------------------------------------------------- observed from outside


@pytest.mark.parametrize(
    "content",
    [hanging_chain(5), waving_chain(10, 3), four_bar(), free_system(3)],
    ids=lambda content: content["name"],
)
def test_the_observer_sees_what_the_solver_reports(content):
    integrator = start(content, step_size=0.01, newton_tolerance=1e-3)
    observer = Observer(content, integrator)
    before = observer.energy() - integrator["energy.total"]
    integrator.advance(0.0, 0.05)
    # The solver's total energy has that of the penalties as well, of the size of the violation.
    after = observer.energy() - integrator["energy.total"]
    residual = integrator["constraint.position"]
    assert after == pytest.approx(before, abs=1e3 * residual + 1e-12)
    assert observer.residual() == pytest.approx(residual, rel=1e-3, abs=1e-15)


def test_the_observer_sees_the_momenta_of_a_free_body():
    content = free_system(3)
    integrator = start(content)
    observer = Observer(content, integrator)
    linear, angular = observer.momenta()
    assert [integrator[f"momentum.{a}"] for a in "xyz"] == pytest.approx(linear, rel=1e-13)
    assert [integrator[f"angular_momentum.{a}"] for a in "xyz"] == pytest.approx(angular, rel=1e-13)


# ------------------------------------------------------------------------------------- measuring


@pytest.mark.parametrize("name", [name for name in command.SECTIONS if name != "instructions"])
def test_every_benchmark_runs_at_a_tiny_size(name, monkeypatch):
    monkeypatch.setattr(skips, "variant", kernel_without)  # compiled once for all skips
    section = import_module(command.SECTIONS[name]).measure(TINY)
    assert section.name == name
    assert all(table.rows for table in section.tables)
    assert not any(table.rows[0].get("failure") for table in section.tables)
    page = as_markdown(MACHINE, TINY.name, [section])
    assert f"## {section.title}" in page
    record = json.loads(as_json(MACHINE, TINY.name, [section]))["sections"][name]
    assert len(record["tables"]) == len(section.tables)


def test_without_valgrind_a_sentence_stands_for_the_counts(monkeypatch):
    monkeypatch.setattr(instructions.shutil, "which", lambda _: None)
    section = instructions.measure(TINY)
    assert not section.tables
    assert "valgrind is not installed" in section.remarks[0]


def test_what_valgrind_watches_takes_the_steps_it_says(tmp_path):
    model = assemble(scene(hanging_chain(2), step_size=1e-3))
    path = tmp_path / "model.bin"
    path.write_bytes(model.to_bytes())
    assert kernel_run.run(str(path), 7) == 14


def test_entries_take_turns_and_the_minimum_counts():
    ticks = itertools.count()
    order = []
    lengths = {"a": iter([5, 3, 4]), "b": iter([2, 2, 9])}

    def entry(name):
        def run():
            order.append(name)
            for _ in range(next(lengths[name]) - 1):
                next(ticks)

        return Entry(run, lambda: order.append(f"before {name}"))

    effort = Effort(name="test", scale=1, repetitions=3, budget=0, largest=1, steps=1)
    times = interleave({name: entry(name) for name in "ab"}, effort, lambda: next(ticks))
    assert order == ["before a", "a", "before b", "b"] * 3
    assert (times["a"].minimum, times["b"].minimum) == (3, 2)
    assert times["a"].noise == pytest.approx(4 / 3)


def test_what_is_expensive_is_repeated_three_times_only():
    effort = Effort(name="test", scale=1, repetitions=9, budget=5.0, largest=1, steps=1)
    ticks = itertools.count(step=3)
    times = interleave({"a": Entry(lambda: None)}, effort, lambda: next(ticks))
    assert times["a"].seconds == (3, 3, 3)


# ------------------------------------------------------------------------------------- reporting


@pytest.mark.parametrize(
    ("value", "verdict"),
    [
        (2.0, "met (0.50 of it)"),
        (6.0, "**missed** (1.50 times it)"),
        (math.nan, "**missed** (nan times it)"),
        (None, "**missed** (no value)"),
    ],
)
def test_a_goal_is_met_or_missed(value, verdict):
    goal = Goal(what="x", unit="s", goal=4.0, value=value)
    assert goal.verdict == verdict
    section = Section(name="x", title="X", method="", goals=[goal])
    assert verdict in as_markdown(MACHINE, "full", [section])


def test_a_page_says_when_it_is_no_measurement():
    assert "not meant as a measurement" in as_markdown(MACHINE, QUICK.name, [])
    assert "not meant as a measurement" not in as_markdown(MACHINE, "full", [])


def test_what_ran_under_a_tolerance_is_told_by_which_method():
    """In a row, or where its section says how it was measured."""
    data = json.loads((ROOT / "docs" / "benchmarks.json").read_text(encoding="utf-8"))["sections"]
    for name in ("work-precision", "tolerances"):
        rows = [str(row) for table in data[name]["tables"] for row in table["rows"]]
        ours = [row for row in rows if "tolerance" in row and "holonom" in row]
        assert ours or name == "tolerances"
        for row in ours or rows:
            assert any(word in row + data[name]["method"] for word in STEPPED_BY)


def test_a_merged_section_replaces_its_older_self_and_leaves_the_others():
    def section(name, value):
        goals = [Goal(what=f"cost of {name}", unit="s", goal=1.0, value=value)]
        return Section(name=name, title=name.upper(), method=f"took {value}", goals=goals)

    old = [section("first", 0.5), section("second", 0.25)]
    page, data = (write(MACHINE, "full", old) for write in (as_markdown, as_json))
    machine = MACHINE | {"day": "2026-01-02"}
    page, data = merged(page, data, machine, "full", [section("second", 0.125)])
    assert page.index("## FIRST") < page.index("## SECOND")
    assert "took 0.5" in page
    assert "took 0.125" in page
    assert "0.25" not in page
    assert page.count("Measured on 2026-01-02 on some") == 1
    assert page.count("cost of") == 2
    sections = json.loads(data)["sections"]
    assert [part["goals"][0]["value"] for part in sections.values()] == [0.5, 0.125]


def test_a_part_is_written_only_where_it_is_told_to(tmp_path, capsys):
    assert command.main(["formulations", "--quick", "--output", str(tmp_path)]) == 0
    assert {path.name for path in tmp_path.iterdir()} == {"benchmarks.md", "benchmarks.json"}
    page = (tmp_path / "benchmarks.md").read_text(encoding="utf-8")
    assert page in capsys.readouterr().out
    assert str(tmp_path) not in page


def test_an_unknown_benchmark_is_refused_by_name(capsys):
    with pytest.raises(SystemExit):
        command.main(["stepss"])
    assert "no benchmark 'stepss'; there are steps" in capsys.readouterr().err
