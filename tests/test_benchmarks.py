"""Benchmarks: their exact solutions are exact, their code runs; nothing here asserts a time."""

from __future__ import annotations

import itertools
import json
import math
from importlib import import_module

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from benchmarks import __main__ as command
from benchmarks import exact, instructions, kernel_run, picture
from benchmarks.effort import QUICK, TINY, Effort
from benchmarks.mechanisms import four_bar, free_body, hanging_chain, scene, start, waving_chain
from benchmarks.observe import Observer
from benchmarks.peers import PEERS
from benchmarks.problems import all_problems
from benchmarks.report import Goal, Section, Table, as_json, as_markdown
from benchmarks.timing import Entry, interleave
from benchmarks.work_precision import errors, time_to_reach
from solver import assemble

MACHINE = {"processor": "some", "cores": "1"}
PROBLEMS = all_problems()

# ------------------------------------------------------------------------------- exact solutions


@pytest.mark.parametrize(
    ("t", "points"),
    [
        (1.0, [(-0.585168391999, -0.810911803469), (-1.444818849943, -1.321794461381)]),
        (2.0, [(-0.4644128687, -0.885618816075), (-1.434124817464, -1.129870195647)]),
        (5.0, [(-0.586869209816, -0.809681746472), (-1.55077846947, -1.075912734813)]),
    ],
)
def test_the_double_pendulum_is_where_an_independent_integration_has_it(t, points):
    # DOP853 at 1e-13, printed with twelve digits; its error grows from t = 1 to 5.
    q, _ = PROBLEMS[1].exact(t)
    assert q == pytest.approx(np.array(points), abs=2e-11)


@pytest.mark.parametrize(
    ("t", "place"),
    [
        (1.0, (-0.195020302, -0.980799206)),
        (2.0, (0.057815796, 0.998327268)),
        (5.0, (-0.811310461, -0.584615545)),
        (10.0, (0.328458112, 0.944518538)),
    ],
)
def test_the_four_bar_is_where_an_independent_integration_has_it(t, place):
    q, _ = PROBLEMS[2].exact(t)
    assert q == pytest.approx(np.array([[i + place[0], place[1]] for i in range(3)]), abs=1e-9)


@pytest.mark.parametrize("angle", [math.pi / 6, math.pi / 2])
def test_the_extrapolated_solution_does_not_depend_on_its_step(angle):
    coarse, fine = (exact.double_pendulum_motion(angle, 3.0, h) for h in (0.025, 0.0125))
    assert np.max(np.abs(coarse - fine)) < 1e-13


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda p: p.name)
def test_exact_solutions_begin_at_the_start_and_solve_the_reduced_equations(problem):
    at_rest = problem.points(problem.start)
    assert problem.exact(0.0) == (
        pytest.approx(at_rest[0], abs=1e-14),
        pytest.approx(at_rest[1], abs=1e-14),
    )
    path = solve_ivp(
        problem.rates, (0.0, 2.0), problem.start, method="DOP853", rtol=1e-13, atol=1e-13
    )
    q, v = problem.points(path.y[:, -1])
    accuracy = errors(problem, q, v, 2.0)
    assert max(accuracy.values()) < 1e-10
    energy = problem.energy(path.y)
    assert np.max(np.abs(energy - energy[0])) < 1e-10


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda p: p.name)
def test_reduced_and_drawn_mechanism_have_the_same_energy_and_start(problem):
    observer = Observer(problem.content, start(problem.content))
    initial = float(problem.energy(np.array(problem.start)[:, None])[0])
    assert observer.energy() == pytest.approx(initial, abs=1e-13)
    q, v = observer.moving_points()
    q_reduced, v_reduced = problem.points(problem.start)
    assert (q, v) == (pytest.approx(q_reduced, abs=1e-15), pytest.approx(v_reduced, abs=1e-15))


@pytest.mark.parametrize("peer", PEERS, ids=lambda p: p.name)
@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda p: p.name)
def test_peers_reach_the_exact_solution(problem, peer):
    path = peer.path(problem, 1e-12, 2.0)
    assert max(errors(problem, *problem.points(path[:, -1]), 2.0).values()) < 1e-9
    last = np.asarray(peer.run(problem, 1e-12, 2.0))
    assert np.array_equal(last if last.ndim == 1 else last[:, -1], path[:, -1])


# --------------------------------------------------------------------------- observed from outside


@pytest.mark.parametrize(
    "content",
    [hanging_chain(5), waving_chain(10, 3), four_bar(), free_body()],
    ids=lambda content: content["name"],
)
def test_the_observer_sees_what_the_solver_reports(content):
    integrator = start(content, step_size=0.01, formulation="conserving-penalty", penalty=1e3)
    observer = Observer(content, integrator)
    before = observer.energy() - integrator["energy.total"]
    integrator.advance(0.0, 0.05)
    # The solver's total energy has that of the penalties as well, of the size of the violation.
    after = observer.energy() - integrator["energy.total"]
    residual = integrator["constraint.position"]
    assert after == pytest.approx(before, abs=1e3 * residual + 1e-12)
    assert observer.residual() == pytest.approx(residual, rel=1e-3, abs=1e-15)


def test_the_observer_sees_the_momenta_of_a_free_body():
    content = free_body()
    integrator = start(content)
    observer = Observer(content, integrator)
    linear, angular = observer.momenta()
    assert [integrator[f"momentum.{a}"] for a in "xyz"] == pytest.approx(linear, rel=1e-13)
    assert [integrator[f"angular_momentum.{a}"] for a in "xyz"] == pytest.approx(angular, rel=1e-13)


# ------------------------------------------------------------------------------------- measuring


@pytest.mark.parametrize("name", [name for name in command.SECTIONS if name != "instructions"])
def test_every_benchmark_runs_at_a_tiny_size(name):
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
    model = assemble(scene(hanging_chain(2), step_size=1e-3, paired=False))
    path = tmp_path / "model.bin"
    path.write_bytes(model.to_bytes())
    assert kernel_run.run(str(path), 7) == 7


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


def test_a_curve_is_straight_between_settings_on_logarithmic_scales():
    points = [(1e-2, 1.0), (1e-4, 10.0)]
    assert time_to_reach(points, 1e-3) == pytest.approx(math.sqrt(10.0))
    assert time_to_reach(points, 1e-4) == 10.0
    assert time_to_reach(points, 1e-1) == 1.0
    assert time_to_reach(points, 1e-5) is None


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
        for solver in picture.STYLES
        for ms, energy in [(1.0, 1e-3), (2.0, 0.0), (None, None)]
    ]
    paper = Paper()
    picture._curves(paper, Table(title="T", columns={}, rows=rows), "energy")
    expected = ([1.0, 2.0], [1e-3, picture.LEAST])
    assert paper.curves == dict.fromkeys(picture.STYLES, expected)


def test_the_picture_shows_all_curves(tmp_path):
    pytest.importorskip("matplotlib")
    rows = [
        {"solver": solver, "ms": 1.0, "position": 1e-3, "energy": 0.0} for solver in picture.STYLES
    ]
    columns = {key: key for key in rows[0]}
    table = Table(title="T", columns=columns, rows=rows)
    path = tmp_path / "curves.png"
    picture.draw_work_precision(Section(name="x", title="X", method="", tables=[table]), path)
    assert path.read_bytes()[:4] == b"\x89PNG"
