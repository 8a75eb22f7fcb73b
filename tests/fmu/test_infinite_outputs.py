"""An output that is no finite number is 0, alone, and said to be: never NaN, never in silence."""

from __future__ import annotations

import json

import pytest

from build_fmu import sweep
from build_fmu.run import run_fmu
from build_fmu.testing import assert_conserves, assert_follows
from fmu_src import status
from tests.commands import run
from tests.fmu_instance import PENDULUM, instance, text_fmu

TEXT = PENDULUM.format(length=1.0, mass=1.0, push="push").replace(
    "[experiment]", 'root = { value = "sqrt(0.05 - t)" }\n[experiment]'
)


LOGGED = "the run came to its end, but the FMU logged an error"
SENTENCE = "root is not finite at t = 0.1 s"


def test_one_output_that_is_not_finite_leaves_the_others_as_they_are():
    with instance(text_fmu(TEXT)) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.1)
        clock, reach, root = (fmu.references[name] for name in ("clock", "reach", "root"))
        place = fmu.references["A.y"]
        code = fmu.references["solver.status"]
        values = fmu.fmu.getReal([clock, root, reach, place, code])
        assert values[:3] == [0.1, 0.0, 1.0]
        assert values[3] < 0.0
        assert values[4] == status.NOT_FINITE
        assert any("root is not finite" in text for _, _, text in fmu.log)


def test_the_status_lasts_until_the_next_step():
    with instance(text_fmu(TEXT)) as fmu:
        fmu.initialise()
        fmu.step(0.0, 0.1)
        assert fmu.get("root") == 0.0
        assert fmu.get("solver.status") == status.NOT_FINITE
        assert fmu.step(0.1, 0.1)
        assert fmu.get("solver.status") == 0.0


# ------------------------------------------------------ a run with an error in its log is not clean


def test_a_run_with_an_error_in_its_log_comes_to_its_end_but_is_not_clean():
    found = run_fmu(text_fmu(TEXT), stop_time=0.3)
    assert found.finished
    assert found.end_time == pytest.approx(0.3)
    assert found.reason == SENTENCE
    assert found.failure == f"{LOGGED}: {SENTENCE}"


def test_check_fails_with_the_sentence(capsys):
    code, out, err = run(capsys, "check", text_fmu(TEXT), "--stop", 0.3, "--json")
    assert code == 1
    assert not json.loads(out)["holds"]
    assert SENTENCE in err


def test_simulate_ends_with_3_and_the_sentence(capsys):
    code, out, err = run(capsys, "simulate", text_fmu(TEXT), "--stop", 0.3, "--json")
    assert code == 3
    assert json.loads(out)["finished"]
    assert json.loads(out)["reason"] == SENTENCE
    assert f"holonom: {LOGGED}: {SENTENCE}" in err


def test_a_sweep_records_the_run_as_failed():
    arguments = {"stop_time": 0.3, "engine": "serial", "form": "sweep"}
    found = sweep(text_fmu(TEXT), grid={"mass": [1.0, 2.0]}, **arguments)
    assert found.failed["reason"].tolist() == [SENTENCE] * 2
    clean = sweep(text_fmu(TEXT), grid={"mass": [1.0]}, outputs=["A.x"], **arguments)
    assert not len(clean.failed)


def test_assertions_of_users_fail_with_the_sentence():
    with pytest.raises(AssertionError, match=SENTENCE):
        assert_conserves(text_fmu(TEXT), stop_time=0.3)
    reference = {"time": [0.0, 0.1, 0.2], "root": [0.0, 0.0, 0.0]}
    with pytest.raises(AssertionError, match=SENTENCE):
        assert_follows(text_fmu(TEXT), reference, absolute=1.0)
