"""FMI 3.0 with loggingOn = false calls nobody, whatever goes wrong, until a category is wanted.

FMI 3.0.1, 2.3.1: "any logging is disabled and the logMessage callback must not be called". FMI 2.0
wants errors to be told all the same (2.0.5, 2.1.3).
"""

from __future__ import annotations

import contextlib
import ctypes
import math

import fmpy
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi3 import (
    fmi3InstanceEnvironment,
    fmi3IntermediateUpdateCallback,
    fmi3LogMessageCallback,
)

import solver
from build_fmu.fmpy_slaves import FMU3Run
from tests.fmu.test_state_machine import SCENE, fmu_of
from tests.support.fmus.fmu_instance import Instance, instance
from tests.support.fmus.native_fmus import native_fmu

MISTAKES = {
    "value": lambda fmu: fmu.set(push=math.nan),
    "output": lambda fmu: fmu.set(A__x=1.0),
    "call out of place": lambda fmu: fmu.fmu.exitInitializationMode(),
    "step that fails": lambda fmu: [fmu.set(push=-4.0), fmu.fmu.doStep(0.1, 0.1)],
    "state": lambda fmu: fmu.fmu.deserializeFMUState(b"other"),
    "category": lambda fmu: switch(fmu, True, "nonsense"),
    "step": lambda fmu: fmu.fmu.doStep(0.1, -0.1),
}
"""What is answered with Discard or Error; the last one ends the run."""


def switch(fmu: Instance, on: bool, *names: str) -> None:
    """Call fmi3SetDebugLogging, which fmpy has not."""
    given = (ctypes.c_char_p * len(names))(*(name.encode() for name in names))
    call = fmu.fmu.dll.fmi3SetDebugLogging
    arguments = (ctypes.c_void_p(fmu.fmu.component), on, ctypes.c_size_t(len(names)), given)
    if call(*arguments):
        raise FMICallException(function="fmi3SetDebugLogging", status=3)


def go_wrong(fmu: Instance) -> None:
    """Make all mistakes in turn."""
    fmu.initialise(stop=2.0)
    fmu.fmu.doStep(0.0, 0.1)
    for mistake in MISTAKES.values():
        with contextlib.suppress(FMICallException):
            mistake(fmu)


def test_with_logging_all_of_it_is_told():
    with instance(fmu_of("native 3")) as fmu:
        go_wrong(fmu)
        assert len([line for line in fmu.log if line[0] > 1]) == len(MISTAKES)


def test_without_logging_nobody_is_called():
    with instance(fmu_of("native 3"), logging=False) as fmu:
        go_wrong(fmu)
        assert fmu.get("solver.status") == 103
        fmu.fmu.reset()
        go_wrong(fmu)
        assert fmu.log == []


@pytest.mark.parametrize("name", ["logStatusError", "logStatusDiscard"])
def test_a_category_that_is_switched_on_is_told_and_no_other(name):
    with instance(fmu_of("native 3"), logging=False) as fmu:
        switch(fmu, True, name)
        go_wrong(fmu)
        assert {category for _, category, _ in fmu.log} == {name}
        switch(fmu, False)
        told = len(fmu.log)
        fmu.fmu.reset()
        go_wrong(fmu)
        assert len(fmu.log) == told


def test_native_fmi_2_tells_errors_all_the_same():
    with instance(fmu_of("native"), logging=False) as fmu:
        fmu.initialise()
        with contextlib.suppress(FMICallException):
            fmu.set(push=math.nan)
        assert len(fmu.log) == 1


@pytest.mark.parametrize("is_logging", [False, True])
def test_an_instance_that_cannot_be_made_says_why_only_with_logging(is_logging, tmp_path):
    path = native_fmu(solver.assemble(solver.loads(SCENE)), 3)
    description = fmpy.read_model_description(str(path))
    fmpy.extract(str(path), str(tmp_path))
    made = FMU3Run(
        guid=description.guid, unzipDirectory=str(tmp_path),
        modelIdentifier=description.coSimulation.modelIdentifier,
    )  # fmt: skip
    heard: list[bytes] = []
    logger = fmi3LogMessageCallback(lambda *line: heard.append(line[-1]))
    instantiate, token = made.fmi3InstantiateCoSimulation, description.guid.encode()
    resources = str(tmp_path / "resources").encode()
    end = (None, 0, fmi3InstanceEnvironment(), logger, fmi3IntermediateUpdateCallback())
    attempts = (
        (b"a", b"another", resources, False, is_logging, False, False, *end),
        (b"", token, resources, False, is_logging, False, False, *end),
        (b"a", token, b"/nowhere", False, is_logging, False, False, *end),
        (b"a", token, resources, False, is_logging, True, False, *end),
    )
    for attempt in attempts:
        assert not instantiate(*attempt)
    exchange = made.dll.fmi3InstantiateModelExchange
    exchange.restype = ctypes.c_void_p
    assert not exchange(b"a", token, resources, False, is_logging, None, logger)
    assert len(heard) == (len(attempts) + 1 if is_logging else 0)
    made.freeLibrary()
