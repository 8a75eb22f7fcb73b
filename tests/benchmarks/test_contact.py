"""Problems with impacts: references agree with SciPy, scores are right, peers move the same."""

from __future__ import annotations

from contextlib import suppress
from importlib import import_module

import numpy as np
import pytest

from benchmarks.contact import methods, scenes, scipy_events, section
from benchmarks.contact.problems import CRANK, PROBLEMS, damping_ratio, score, touches
from tests.support.mechanisms.scene_files import TOUCHING

SHARP = {"method": "DOP853", "tolerance": 1e-12}


@pytest.mark.parametrize("name", PROBLEMS)
def test_scipy_with_events_hits_and_loses_what_the_reference_does(name):
    # The slider-crank multiplies an error 100 times in ten impacts; its reference has 1e-11.
    found = scipy_events.METHODS[0].score(PROBLEMS[name], SHARP)
    assert found.seen == len(PROBLEMS[name].hits)
    assert found.events is not None
    assert found.events < 1e-8
    assert found.energy < 1e-10


def test_the_energy_of_the_slider_crank_is_that_of_its_speeds():
    v = np.array([CRANK.speed, CRANK.rod_speed, 0.0])
    assert PROBLEMS["slider_crank"].energy == pytest.approx(0.5 * v @ CRANK.mass(v * 0.0) @ v)


def test_a_missing_impact_has_no_error_of_times():
    problem = PROBLEMS["ball_lossy"]
    late = [*problem.hits[:5], problem.hits[5] * 1.01, 99.0]
    assert score(problem, late, 0.5 * problem.loss).events == pytest.approx(0.01)
    assert score(problem, late, problem.loss).energy == 0.0
    assert score(problem, late[:5], problem.loss).events is None


@pytest.mark.parametrize("offset", [0.0, 0.3, 0.7])
def test_a_gap_closes_where_its_parabola_does(offset):
    t = np.arange(20) * 0.1 + 0.1 * offset
    gap, rate = 1.0 - t * t, -2.0 * t
    gap[t > 1.0] -= 0.05  # whatever the contact does to the sample behind
    assert touches(t, gap, rate) == pytest.approx([1.0], abs=1e-12)
    assert not touches(t, gap - 10.0, rate)


@pytest.mark.parametrize("restitution", [0.5, 0.8, 0.9, 1.0])
def test_a_spring_and_damper_that_cannot_pull_bounces_with_the_restitution(restitution):
    ratio = damping_ratio(restitution)
    x, v, h = 0.0, -1.0, 1e-4
    while (force := -x - 2.0 * ratio * v) > 0.0 or v < 0.0:
        v += h * force
        x += h * v
    assert v == pytest.approx(restitution, abs=1e-3)


def test_what_a_faster_run_beats_is_not_shown():
    rows = [
        {"ms": ms, "events": events, "energy": energy, "setting": {"h": h}}
        for ms, events, energy, h in (
            (1.0, 1e-2, 1e-3, 0.1), (2.0, 2e-2, 2e-3, 0.1), (3.0, None, 1e-4, 0.1),
            (4.0, 1e-4, 1e-2, 0.1), (5.0, 1e-3, 1e-2, methods.USUAL),
        )
    ]  # fmt: skip
    assert [row["ms"] for row in methods.best(rows)] == [1.0, 3.0, 4.0, 5.0]
    found = methods.reached(rows, 1e-3)
    assert found is not None
    assert found["ms"] == 4.0
    assert methods.reached(rows, 1e-9) is None


@pytest.mark.parametrize("name", [name for name in PROBLEMS if "elastic" not in name])
@pytest.mark.parametrize("peer", section.CODES)
def test_a_peer_hits_and_loses_nearly_the_same(peer, name):
    # A soft contact delays what follows by π/√k; the slider-crank multiplies that.
    pytest.importorskip(section.CODES[peer][1])
    method = import_module(f"benchmarks.contact.{peer}").METHODS[0]
    problem = PROBLEMS[name]
    h = 1e-5 if problem.kind == "slider_crank" else 3e-4
    settings = [s for family in method.families(problem) for s in family if s["h"] == h]
    found = []
    for setting in settings:
        with suppress(methods.GaveUpError):  # too stiff for this step
            found.append(method.score(problem, setting))
    events = [one.events for one in found if one.events is not None]
    assert min(events) < (0.05 if problem.kind == "slider_crank" else 0.005)
    assert min(one.energy for one in found) < 2e-3


@pytest.mark.parametrize("peer", section.CODES)
def test_the_elastic_contact_of_a_peer_bounces(peer):
    pytest.importorskip(section.CODES[peer][1])
    method = import_module(f"benchmarks.contact.{peer}").METHODS[0]
    problem = PROBLEMS["circle_elastic"]
    settings = [s for family in method.families(problem) for s in family if s["h"] == 1e-3]
    assert min(method.score(problem, setting).energy for setting in settings) < 2e-3


def test_what_is_known_is_known_of_scenes_that_exist():
    assert set(scenes.KNOWN) <= {path.stem for path in TOUCHING}
