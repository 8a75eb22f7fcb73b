"""An output that is no finite number is 0, alone, and said to be: never NaN, never in silence."""

from __future__ import annotations

import ctypes
import json

import pytest

from build_fmu.run import run_fmu
from fmu_src import status
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import PENDULUM, Instance, instance, text_fmu

TEXT = PENDULUM.format(length=1.0, mass=1.0, push="push").replace(
    "[experiment]", 'root = { value = "sqrt(0.05 - t)" }\n[experiment]'
)
TWO = TEXT.replace("[experiment]", 'inverse = { value = "1 / (t - 0.1)" }\n[experiment]')
OK, ERROR = 0, 3

LOGGED = "the run came to its end, but the FMU logged an error"
SENTENCE = "root is not finite at t = 0.1 s"


KINDS = pytest.mark.parametrize(("native", "answer"), [(False, OK), (True, ERROR)])
"""Whether an FMU is native, and its answer where a value cannot be read."""


def read(fmu: Instance, *names: str) -> tuple[int, list[float]]:
    """Status of fmi2GetReal, and what it hands out; by no name a reference that is none."""
    library = ctypes.CDLL(fmu.fmu.dll._name)  # fmpy raises, and has no values then
    count = len(names)
    index = (ctypes.c_uint32 * count)(*(fmu.references.get(name, 9999) for name in names))
    values = (ctypes.c_double * count)(*[7.0] * count)
    component = ctypes.c_void_p(fmu.fmu.component)
    return library.fmi2GetReal(component, index, ctypes.c_size_t(count), values), values[:]


@KINDS
def test_outputs_that_are_not_finite_are_named_and_leave_the_others_as_they_are(native, answer):
    with instance(text_fmu(TWO, native=native)) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.1)
        names = "clock", "root", "reach", "inverse", "A.y", "solver.status"
        given, values = read(fmu, *names)
        assert given == answer
        assert values[:4] == [0.1, 0.0, 1.0, 0.0]
        assert values[4] < 0.0
        assert values[5] == status.NOT_FINITE
        told = [text for level, _, text in fmu.log if level == ERROR]
        assert told == [f"{name} is not finite at t = 0.1 s" for name in ("root", "inverse")]


@KINDS
def test_what_cannot_be_read_in_a_call_is_0_and_the_rest_is_read(native, answer):
    with instance(text_fmu(TEXT, native=native)) as fmu:
        fmu.initialise()
        first = len(fmu.log)
        given, values = read(fmu, "reach", "none", "A.x", "solver.start", "mass")
        assert (given, values) == (answer, [1.0, 0.0, 1.0, 0.0, 1.0])
        ((_, _, text),) = fmu.log[first:]
        word = fmu.references["solver.start"]
        assert text == f"value references [9999, {word}] are not those of Real variables"


@KINDS
def test_the_status_lasts_until_the_next_step(native, answer):
    with instance(text_fmu(TEXT, native=native)) as fmu:
        fmu.initialise()
        fmu.step(0.0, 0.1)
        assert read(fmu, "root") == (answer, [0.0])
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
