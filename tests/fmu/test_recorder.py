"""The loop over communication steps in C does what the same calls from Python do."""

from __future__ import annotations

import contextlib
import itertools
import tempfile

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException

import solver
from build_fmu.fmpy_slaves import Recorder
from build_fmu.fmu_runner import FmuRunner
from build_fmu.instance import Log, instantiated
from fmu_src.status import DISCARD, ERROR
from tests.support.fmus.fmu_instance import PENDULUM, scene_fmu
from tests.support.fmus.native_fmus import native_fmu, native_scene_fmu

TIMES = np.arange(21) * 0.05


@contextlib.contextmanager
def started(path):
    """Slave of an FMU of either version, at its start, and value references of its outputs."""
    description = fmpy.read_model_description(str(path))
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        fmpy.extract(str(path), folder)
        fmu = instantiated(description, folder, Log())
        fmu.setupExperiment()
        fmu.enterInitializationMode()
        fmu.exitInitializationMode()
        yield fmu, [v.valueReference for v in description.modelVariables if v.causality == "output"]
        fmu.freeInstance()


FMUS = {
    "native 2": lambda: native_scene_fmu("four_bar"),
    "native 3": lambda: native_scene_fmu("four_bar", 3),
    "Python": lambda: scene_fmu("four_bar"),
}


@pytest.mark.parametrize("kind", FMUS)
def test_steps_in_c_are_those_of_fmpy_however_many_are_taken_at_once(kind):
    with started(FMUS[kind]()) as (fmu, references):
        rows = [fmu.getReal(references)]
        for before, after in itertools.pairwise(TIMES):
            fmu.doStep(before, after - before)
            rows.append(fmu.getReal(references))
    for at_once in (1, 7, len(TIMES)):
        with started(FMUS[kind]()) as (fmu, references):
            recorder = Recorder(fmu, references, TIMES)
            while recorder.reached < len(TIMES):
                recorder.go_on(min(recorder.reached + at_once, len(TIMES)))
            assert np.array_equal(recorder.values, rows)


BROKEN = PENDULUM.format(length=1.0, mass=1.0, push="sqrt(0.12 - t)")
"""Its third step cannot be solved."""


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_step_that_fails_ends_the_loop_and_is_named(fmi):
    path = native_fmu(solver.assemble(solver.loads(BROKEN)), fmi)
    with started(path) as (fmu, references):
        recorder = Recorder(fmu, references, TIMES)
        with pytest.raises(FMICallException, match=f"fmi{fmi}DoStep") as error:
            recorder.go_on(len(TIMES))
        assert error.value.status == DISCARD
        assert recorder.reached == 3


@pytest.mark.parametrize(("fmi", "call"), [(2, "fmi2GetReal"), (3, "fmi3GetFloat64")])
def test_a_value_that_cannot_be_read_ends_the_loop_and_is_named(fmi, call):
    with started(native_scene_fmu("four_bar", fmi)) as (fmu, references):
        recorder = Recorder(fmu, [*references, 99999], TIMES)
        with pytest.raises(FMICallException, match=call) as error:
            recorder.go_on(len(TIMES))
        assert error.value.status == ERROR
        assert recorder.reached == 0


@pytest.mark.parametrize("kind", FMUS)
def test_numbers_are_the_same_beside_outputs_of_other_kinds(kind):
    """These are read by fmpy, one after the other."""
    names, times = ["B0.x", "solver.assemble", "energy.error"], TIMES.tolist()
    with contextlib.closing(FmuRunner(FMUS[kind]())) as fmu:
        mixed = fmu.run({}, times, names).values
        numbers = fmu.run({}, times, names[::2]).values
    assert np.array_equal(mixed[:, ::2], numbers)
    assert set(mixed[:, 1]) == {0.0}


def test_a_run_that_fails_beside_outputs_of_other_kinds_has_what_came_before():
    path = native_fmu(solver.assemble(solver.loads(BROKEN)))
    with contextlib.closing(FmuRunner(path)) as fmu:
        record = fmu.run({}, TIMES.tolist(), ["A.x", "solver.assemble"])
        alone = fmu.run({}, TIMES.tolist(), ["A.x"])
    assert "step from t = 0.1 s" in record.reason
    assert record.end_time == alone.end_time == 0.1
    assert np.array_equal(record.values[:, :1], alone.values)
