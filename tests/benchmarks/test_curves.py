"""Work and precision: where curves end, what is told of them, goals and pictures."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from benchmarks.measuring.effort import TINY
from benchmarks.measuring.timing import Entry
from benchmarks.pages import picture
from benchmarks.pages.report import Section, Table, as_json, as_markdown
from benchmarks.peers import peer_processes
from benchmarks.peers.peer_interpreter import Packages
from benchmarks.peers.peer_methods import PATIENCE, GaveUpError, Limits, Method, Observed, measured
from benchmarks.problems.catalogue import PROBLEMS
from benchmarks.problems.work_precision_references import Reference
from benchmarks.sections import work_precision_goals
from benchmarks.sections.work_precision import judged
from benchmarks.sections.work_precision_goals import time_to_reach

EVERYTHING = Limits(run=math.inf, settings=99, repetitions=1, budget=0.0)


def problem_of(key):
    return PROBLEMS[key]()


# --------------------------------------------------------------------------------------- measuring


def method(errors, fails=()):
    """A solver whose error at a setting is known."""

    def observe(_, setting):
        if setting in fails:
            reason = "no"
            raise GaveUpError(reason)
        error = errors[int(setting)]
        return Observed.of(np.array([[error, 0, 0]]), np.zeros((1, 3)), [1.0, 1.0 + error])

    return Method(
        name="a",
        label="{:g}",
        settings=lambda _: range(len(errors)),
        observe=observe,
        entry=lambda *_: Entry(lambda: None),
    )


def test_a_curve_ends_where_the_reference_does():
    rows = measured(None, [method([1e-3, 1e-9, 1e-14, 1e-15])], EVERYTHING, [[0.0, 0.0, 0.0]])
    assert [row["setting"] for row in rows] == ["0", "1", "2"]
    assert all(row["ms"] >= 0.0 for row in rows)


def test_a_curve_is_given_up_after_failures_which_are_told():
    rows = measured(None, [method([1.0] * 20, range(20))], EVERYTHING, [[0.0, 0.0, 0.0]])
    assert [row["remark"] for row in rows] == ["no"] * PATIENCE


def test_where_energy_is_not_kept_its_change_counts():
    right = Reference([[0.0] * 3], [[0.0] * 3], -2.0, "")
    row = {"solver": "a", "q": [[0.0] * 3], "v": [[0.0] * 3], "energy": 5.0, "change": -2.5}
    assert judged(row, problem_of("governor"), right)["energy"] == pytest.approx(0.5)
    assert judged(row, problem_of("bricard"), right)["energy"] == 5.0


def test_what_is_not_installed_is_a_row_and_no_error():
    absent = Packages()
    rows = peer_processes.measured(problem_of("bricard"), Limits.of(TINY), [[0.0] * 3], absent)
    assert len(rows) == len(peer_processes.MODULES)
    assert all(row["remark"] == "not measured: not installed" for row in rows)
    assert "not installed" in peer_processes.remarks(absent)[0]


def test_a_curve_is_straight_between_settings_on_logarithmic_scales():
    points = [(1e-2, 1.0), (1e-4, 10.0)]
    assert time_to_reach(points, 1e-3) == pytest.approx(math.sqrt(10.0))
    assert time_to_reach(points, 1e-4) == 10.0
    assert time_to_reach(points, 1e-1) == 1.0
    assert time_to_reach(points, 1e-5) is None


def rows_of(**curves):
    names = {"ours": "holonom conserving, order 8", "exudyn": "Exudyn x", "scipy": "SciPy y"}
    return [
        {"solver": names[name], "ms": ms, "position": error}
        for name, points in curves.items()
        for error, ms in points
    ]


def test_goals_are_ratios_at_the_worst_level_that_the_other_code_reaches():
    rows = rows_of(ours=[(1e-3, 1.0), (1e-11, 4.0)], exudyn=[(1e-3, 2.0), (1e-4, 40.0)])
    (goal,) = work_precision_goals.goals({"bricard": (problem_of("bricard"), rows)})
    assert goal.value == pytest.approx(0.5)
    assert "at 1e-03" in goal.what
    assert "missed" in goal.verdict


def test_ratios_are_to_the_fastest_code_that_solves_the_mechanism_as_drawn():
    rows = rows_of(
        ours=[(1e-3, 1.0), (1e-5, 4.0)], exudyn=[(1e-4, 2.0), (1e-6, 8.0)], scipy=[(1e-12, 0.1)]
    )
    row, fastest = work_precision_goals.ratios({"bricard": (problem_of("bricard"), rows)}).rows
    assert row["solver"] == "holonom conserving"
    assert fastest["0.001"] == "not reached (Exudyn)"  # no curve of it
    assert row["0.001"] == "0.5 (Exudyn)"
    assert row["1e-06"] == "not reached (Exudyn)"
    assert "1e-07" not in row


def test_the_pendulum_is_compared_with_the_fastest_of_all():
    rows = rows_of(ours=[(1e-3, 0.9), (1e-11, 0.9)], scipy=[(1e-3, 0.6), (1e-9, 0.6)])
    goals = work_precision_goals.goals({"double_pendulum_30": (None, rows)})
    assert [goal.value for goal in goals[:4]] == [0.9] * 4
    assert goals[4].value == pytest.approx(1.5)
    assert "SciPy y" in goals[4].what
    assert goals[7].value == 0.0  # nobody else comes to 1e-11
    assert "no other code" in goals[7].what


# ------------------------------------------------------------------------------ page and pictures


def test_rows_of_a_picture_may_be_in_the_data_alone():
    table = Table(
        title="Curve", columns={"a": "A"}, rows=[{"a": 1.0}], picture="one.png", on_page=False
    )
    section = Section(name="x", title="X", method="", tables=[table])
    page = as_markdown({}, "full", [section])
    assert "![Curve](one.png)" in page
    assert "| A" not in page
    record = json.loads(as_json({}, "full", [section]))["sections"]["x"]
    assert record["tables"][0]["rows"] == [{"a": 1.0}]


class Paper:
    """Axes that remember what is drawn: matplotlib need not be installed."""

    def __init__(self):
        self.curves = {}

    def loglog(self, x, y, *, label, **_):
        self.curves[label] = (x, y)

    def grid(self, **_):
        pass


def test_a_curve_has_all_points_that_were_measured_and_none_at_zero():
    rows = [
        {"solver": solver, "ms": ms, "energy": energy}
        for solver in ("holonom conserving, order 2", "other")
        for ms, energy in [(1.0, 1e-3), (2.0, 0.0), (None, None)]
    ]
    paper = Paper()
    table = Table(title="T", columns={}, rows=rows)
    picture.draw_curves(paper, table, "energy", picture.styles([table]))
    expected = ([1.0, 2.0], [1e-3, picture.LEAST])
    assert paper.curves == dict.fromkeys(("holonom conserving, order 2", "other"), expected)


def test_a_solver_looks_the_same_in_all_pictures_and_ours_unlike_others():
    def table(*solvers):
        return Table(title="T", columns={}, rows=[{"solver": solver} for solver in solvers])

    ours = [f"holonom conserving, order {order}" for order in (2, 4, 6, 8)]
    both = [table(*ours, "a", "b", "c"), table(*ours[:1], "c")]
    looks = picture.styles(both)
    assert looks == picture.styles(both[:1])
    colours = [look["color"] for look in looks.values()]
    assert len(set(colours)) == len(colours) == 7


def test_there_is_a_picture_of_all_and_one_of_each(tmp_path):
    pytest.importorskip("matplotlib")
    rows = [{"solver": "a", "ms": 1.0, "position": 1e-3, "velocity": 1e-3, "energy": 0.0}]
    columns = {key: key for key in rows[0]}
    table = Table(title="T", columns=columns, rows=rows, picture="one.png")
    picture.draw(Section(name="x", title="X", method="", tables=[table]), tmp_path / "all.png")
    assert all((tmp_path / n).read_bytes()[:4] == b"\x89PNG" for n in ("all.png", "one.png"))
