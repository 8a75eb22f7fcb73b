"""When a step has survived, and what the stability maps claim of formulations and peers."""

from __future__ import annotations

import math
from dataclasses import asdict
from importlib import import_module

import pytest

import solver
from benchmarks.pages.report import Section, Table
from benchmarks.peers import stability_peer, stability_peers
from benchmarks.problems.stability_cases import STIFFNESSES, Case, chain, maps
from benchmarks.sections import stability, stability_picture
from benchmarks.sections.stability_rules import (
    LOOKS,
    LOOSE,
    TIGHT,
    Outcome,
    largest,
    scan,
    steps,
    stride,
)
from benchmarks.sections.stability_runs import prepare, run, run_by_paper

CASES = {f"{case.name} {case.stiffness or ''}".strip(): case for case in maps()}

# ------------------------------------------------------------------------------------------- rules


def test_a_run_reaches_its_end_in_steps_of_the_length_asked_for():
    assert [steps(1.0, h) for h in (2.0, 1.0, 0.7, 0.1, 1e-3)] == [1, 1, 2, 10, 1000]
    assert stride(LOOKS) == 1
    assert stride(LOOKS + 1) == 2


@pytest.mark.parametrize(
    ("energy", "constraint", "end"),
    [
        (0.5, 1e-3, ""),
        (-2.0, 0.0, "energy lost at 3 s"),
        (math.nan, 0.0, "energy lost at 3 s"),
        (0.0, 0.1, "constraints lost at 3 s"),
        (0.0, math.nan, "constraints lost at 3 s"),
    ],
)
def test_a_run_is_lost_with_its_energy_or_its_constraints(energy, constraint, end):
    outcome = Outcome()
    assert outcome.see(energy, constraint, 3.0) == (not end)
    assert outcome.end == end
    assert outcome.survived(LOOSE) == (not end)
    assert not outcome.survived(TIGHT)


def test_a_larger_step_that_survives_by_chance_does_not_count():
    ends = {0.1: "", 0.2: "lost", 0.4: ""}
    seen = scan(sorted(ends, reverse=True), lambda h: Outcome(energy=h / 20, end=ends[h]))
    assert [h for h, _ in seen] == [0.1, 0.2]
    assert largest(seen, LOOSE) == (0.1, Outcome(energy=0.005))
    assert largest(seen, 1e-3) is None


# ---------------------------------------------------------------------------------------- our runs


@pytest.mark.parametrize("name", [name for name in CASES if "1000000000000" not in name])
def test_the_conserving_scheme_keeps_energy_and_joints_at_a_twentieth_of_a_second(name):
    # Round-off of a force k |q| 1e-16 over the stroke of 1 m, a few times, is 1e-15 k. A spring of
    # 1e12 N/m survives shorter steps only.
    ready = prepare(CASES[name], 1.0)
    outcome = run(ready, 0.05)
    assert outcome.survived(1e-11 + 1e-15 * (ready.case.stiffness or 0.0))
    assert outcome.constraint < 1e-13


@pytest.mark.parametrize("name", ["chain", "four-bar", f"stiff spring {STIFFNESSES[1]}"])
def test_at_that_step_midpoint_and_penalty_lose_what_the_conserving_scheme_keeps(name):
    ready = prepare(CASES[name], 2.0)
    for formulation in ("midpoint-al", "midpoint-penalty", "penalty-velocity"):
        assert not run_by_paper(ready, 0.05, formulation=formulation).survived(TIGHT)
    kept = run_by_paper(ready, 0.05, formulation="conserving-al")
    assert kept.survived(1e-11 + 1e-15 * (ready.case.stiffness or 0.0))


def test_a_step_that_was_divided_has_not_survived():
    # A turn of more than 2.5 rad in a half step is always divided; one of 2 rad is not.
    text = """
name = "spinning"
dimension = 2
[bodies.disc]
position = [0, 0]
mass = 1.0
inertia = 1.0
angular_velocity = 2.0
"""
    ready = prepare(Case("spinning", solver.loads(text), 6.0, 1.0), 6.0)
    assert run(ready, 3.0).end == "a step was divided before 3 s"
    assert run(ready, 2.0).survived(1e-12)


def test_the_reference_energy_of_the_chain_is_that_of_its_wave():
    # Without gravity nothing is exchanged: m/2 sum (0.5 sin)^2 = 0.05 * 0.25 * N/2.
    assert prepare(chain(10), 1.0).reference == pytest.approx(0.0625, rel=1e-12)


# ------------------------------------------------------------------------------------------- peers


def test_what_a_peer_sends_is_read_back(monkeypatch):
    ready = prepare(chain(10), 0.1)
    seen = {"method": [(0.1, asdict(Outcome(energy=0.5, newton=2.0)))]}
    monkeypatch.setattr(stability_peers, "answer", lambda *_, **__: seen)
    found, problem = stability_peers.scanned("Exudyn", ready, [0.1])
    assert not problem
    assert found == {"method": [(0.1, Outcome(energy=0.5, newton=2.0))]}


@pytest.mark.parametrize("name", ["chain", "four-bar", "bricard", f"stiff spring {STIFFNESSES[1]}"])
@pytest.mark.parametrize("peer", ["Exudyn", "MuJoCo"])
def test_a_peer_moves_the_same_mechanism(peer, name):
    # With short steps it keeps its energy to 1e-3 and its joints to 1e-4 of the length.
    pytest.importorskip(peer.lower())
    ready = prepare(CASES[name], 0.5)
    module = import_module(stability_peer.MODULES[peer])
    method = next(iter(module.METHODS))
    facts = {"stop": ready.stop, "reference": ready.reference, "length": ready.case.length}
    outcome = module.run(name.partition(" 1")[0], list(ready.case.size), method, 1e-3, facts)
    assert outcome.survived(1e-3)
    assert outcome.constraint < 1e-4


# ----------------------------------------------------------------------------------------- picture


def test_the_picture_has_a_panel_for_each_map(tmp_path):
    pytest.importorskip("matplotlib")
    rows = [
        {"solver": "holonom", "setting": "conserving-al", "h": 0.1},
        {"solver": "holonom", "setting": "midpoint-al", "h": None},
        {"solver": "Exudyn", "setting": "alpha", "h": 0.01},
    ]
    columns = dict.fromkeys(stability.MAP, "")
    section = Section(
        name="stability", title="S", method="",
        tables=[Table(title=t, columns=columns, rows=rows) for t in "abc"],
    )  # fmt: skip
    path = tmp_path / "maps.png"
    stability_picture.draw(section, path)
    assert path.read_bytes()[:4] == b"\x89PNG"
