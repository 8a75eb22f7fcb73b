"""Every call in every state of the standard's state machine: taken, or refused with a line.

FMI 2.0.5, 4.2.4. Two liberties are taken with the table there: values may be read before the
initialization mode, and a step may be tried again after a failed one. Neither harms anybody.
Steps that cannot be, and the state after them, are tried in ``test_impossible_steps``.
"""

from __future__ import annotations

import contextlib
import ctypes
import itertools
import math
import random
import tempfile
from pathlib import Path

import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import fmi2DoStepStatus, fmi2LastSuccessfulTime, fmi2PendingStatus, fmi2Terminated

import solver
from build_fmu.fmpy_slaves import FMU3Run
from fmu_src import status
from tests.support.fmus.fmu_instance import Instance, instance, text_fmu
from tests.support.fmus.native_fmus import native_fmu, slave_of_fmi3

DISCARD, ERROR = 2, 3

SCENE = """
name = "states"
dimension = 2
gravity = [0, -9.81]
[parameters]
length = 1.0
stiffness = { value = 20.0, variability = "tunable" }
[inputs]
push = { start = 0.0, unit = "N" }
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["length", 0], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
wind = { type = "force", point = "A", value = ["sqrt(push + 1)", 0] }
rope = { type = "spring", points = ["O", "A"], stiffness = "stiffness", free_length = 0.5 }
[outputs]
clock = { value = "t", unit = "s" }
[experiment]
stop_time = 2.0
step_size = 0.1
"""


# ------------------------------------------------------------------------------------- states


def instantiated(_: Instance) -> None:
    """State after fmi2Instantiate."""


def initializing(fmu: Instance) -> None:
    """Initialization mode."""
    fmu.fmu.setupExperiment(startTime=0.0, stopTime=2.0)
    fmu.fmu.enterInitializationMode()


def initialized(fmu: Instance) -> None:
    """State stepComplete, before the first step."""
    initializing(fmu)
    fmu.fmu.exitInitializationMode()


def stepped(fmu: Instance) -> None:
    """State stepComplete, after a step."""
    initialized(fmu)
    assert fmu.step(0.0, 0.1)


def failed(fmu: Instance) -> None:
    """State stepFailed: the root of a negative number."""
    stepped(fmu)
    fmu.set(push=-4.0)
    assert not fmu.step(0.1, 0.1)
    fmu.set(push=0.0)


def terminated(fmu: Instance) -> None:
    """State after fmi2Terminate."""
    stepped(fmu)
    fmu.fmu.terminate()


def reset(fmu: Instance) -> None:
    """State after fmi2Reset: instantiated once more."""
    stepped(fmu)
    fmu.fmu.reset()


STATES = (instantiated, initializing, initialized, stepped, failed, terminated, reset)
EARLY = {instantiated, reset}
MOVING = {initialized, stepped, failed}

# -------------------------------------------------------------------------------------- calls


def time_of(fmu: Instance) -> float:
    return fmu.get("clock")


CALLS = {
    "setupExperiment": (lambda fmu: fmu.fmu.setupExperiment(startTime=0.0), EARLY),
    "enterInitializationMode": (lambda fmu: fmu.fmu.enterInitializationMode(), EARLY),
    "exitInitializationMode": (lambda fmu: fmu.fmu.exitInitializationMode(), {initializing}),
    "doStep": (lambda fmu: fmu.step(time_of(fmu), 0.1), MOVING),
    "doStep of no length": (lambda fmu: fmu.step(time_of(fmu), 0.0), set()),
    "doStep of negative length": (lambda fmu: fmu.step(time_of(fmu), -0.1), set()),
    "doStep from earlier": (lambda fmu: fmu.step(time_of(fmu) - 0.05, 0.1), set()),
    "doStep from later": (lambda fmu: fmu.step(time_of(fmu) + 0.05, 0.1), set()),
    "doStep beyond the stop time": (lambda fmu: fmu.step(time_of(fmu), 5.0), set()),
    "doStep of NaN": (lambda fmu: fmu.step(time_of(fmu), math.nan), set()),
    "doStep without end": (lambda fmu: fmu.step(time_of(fmu), math.inf), set()),
    "set a fixed parameter": (lambda fmu: fmu.set(length=1.0), {*EARLY, initializing}),
    "set a setting": (lambda fmu: fmu.set(solver__step_size=0.01), {*EARLY, initializing}),
    "set a tunable parameter": (lambda fmu: fmu.set(stiffness=30.0), {*STATES} - {terminated}),
    "set an input": (lambda fmu: fmu.set(push=0.5), {*STATES} - {terminated}),
    "set NaN": (lambda fmu: fmu.set(push=math.nan), set()),
    "set an output": (lambda fmu: fmu.set(A__x=1.0), set()),
    "get an output": (lambda fmu: fmu.get("A.x"), {*STATES}),
    "get a parameter": (lambda fmu: fmu.get("length"), {*STATES}),
    "get a setting": (lambda fmu: fmu.get("solver.start"), {*STATES}),
    "get and set the state": (
        lambda fmu: fmu.fmu.setFMUState(fmu.fmu.getFMUState()), {*STATES},
    ),
    "serialize and deserialize": (
        lambda fmu: fmu.fmu.setFMUState(
            fmu.fmu.deserializeFMUState(fmu.fmu.serializeFMUState(fmu.fmu.getFMUState()))
        ), {*STATES},
    ),
    "set a state of other bytes": (
        lambda fmu: fmu.fmu.setFMUState(fmu.fmu.deserializeFMUState(b"other")), set(),
    ),
    "terminate": (lambda fmu: fmu.fmu.terminate(), MOVING),
    "reset": (lambda fmu: fmu.fmu.reset(), {*STATES}),
}  # fmt: skip
"""What is called, and the states in which it is taken."""


def derivative(fmu: Instance, name: str) -> object:
    fmi3 = isinstance(fmu.fmu, FMU3Run)
    get = fmu.fmu.getOutputDerivatives if fmi3 else fmu.fmu.getRealOutputDerivatives
    return get([fmu.references[name]], [1])


NATIVE_CALLS = {
    f"get a derivative of {name}": (
        lambda fmu, name=name: derivative(fmu, name),
        MOVING | {terminated},
    )
    for name in ("A.x", "A.vx")  # measured, and found by moving on
}
"""Likewise, of native FMUs alone."""


def refusals(fmu: Instance, call) -> list[tuple[int, str, str]]:
    """Lines of the log that a call leads to and that say no."""
    first = len(fmu.log)
    with contextlib.suppress(FMICallException):  # a native FMU answers at the call
        call(fmu)
    return [line for line in fmu.log[first:] if line[0] in (DISCARD, ERROR)]


KINDS = pytest.mark.parametrize("native", [False, True], ids=["python", "native"])


CASES = [
    *itertools.product(CALLS, ("python", "native", "native 3")),
    *itertools.product(NATIVE_CALLS, ("native", "native 3")),
]


@pytest.mark.parametrize(
    ("name", "kind"), [c for c in CASES if c != ("setupExperiment", "native 3")]
)
def test_a_call_is_taken_where_the_standard_allows_it_and_else_refused_with_a_line(name, kind):
    call, allowed = (CALLS | NATIVE_CALLS)[name]
    with instance(fmu_of(kind)) as fmu:
        for state in STATES:
            fmu.fmu.reset()
            state(fmu)
            before = fmu.outputs()[:-1]  # without solver.status
            said = refusals(fmu, call)
            if state in allowed:
                assert said == [], state
                continue
            ((level, category, text),) = said
            assert (level, category) in ((DISCARD, "logStatusDiscard"), (ERROR, "logStatusError"))
            assert len(text) > 20
            assert kind != "native 3" or "setupExperiment" not in text  # FMI 3.0 has none
            assert fmu.outputs()[:-1] == before, state
            told = name not in ELSEWHERE if kind == "python" else kind == "native"
            if name.startswith("doStep") and told:
                assert fmu.last_successful_time == before_time(before, fmu)


def fmu_of(kind: str) -> Path:
    """FMU of the scene; FMI 3.0 has no setupExperiment, nor a call for the last successful time."""
    if kind == "native 3":
        return native_fmu(solver.assemble(solver.loads(SCENE)), 3)
    return text_fmu(SCENE, native=kind == "native")


def test_the_status_of_a_native_fmu_is_right_in_each_state():
    with instance(text_fmu(SCENE, native=True)) as fmu:
        library = ctypes.CDLL(fmu.fmu.dll._name)  # whose functions take any pointer
        component, place = ctypes.c_void_p(fmu.fmu.component), ctypes.byref(ctypes.c_double())
        for state in STATES:
            fmu.fmu.reset()
            state(fmu)
            assert fmu.last_successful_time == time_of(fmu)
            assert not fmu.fmu.getBooleanStatus(fmi2Terminated)
            said = len(fmu.log)
            for ask, kind in PENDING:
                assert getattr(library, ask)(component, kind, place) == DISCARD
            assert len(fmu.log) == said
            for ask in ("fmi2GetRealStatus", "fmi2GetBooleanStatus"):
                assert getattr(library, ask)(component, fmi2LastSuccessfulTime, None) == ERROR
                assert "no place" in fmu.log[-1][2]


PENDING = (
    ("fmi2GetStatus", fmi2DoStepStatus), ("fmi2GetIntegerStatus", fmi2DoStepStatus),
    ("fmi2GetStringStatus", fmi2PendingStatus), ("fmi2GetRealStatus", fmi2DoStepStatus),
    ("fmi2GetBooleanStatus", fmi2PendingStatus),
)  # fmt: skip
"""What is asked of steps that run on their own, of which there are none."""


def test_fmi_3_gives_the_last_successful_time_of_taken_refused_and_failed_steps():
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        model = solver.assemble(solver.loads(SCENE))
        made = slave_of_fmi3(native_fmu(model, 3), folder)
        flags, last = [ctypes.byref(ctypes.c_bool()) for _ in range(3)], ctypes.c_double()

        def step(t: float, h: float) -> tuple[int, float]:
            times = ctypes.c_double(t), ctypes.c_double(h)
            status = made.dll.fmi3DoStep(made.component, *times, True, *flags, ctypes.byref(last))
            return status, last.value

        made.setupExperiment(startTime=0.5, stopTime=2.0)
        made.enterInitializationMode()
        assert step(0.5, 0.1) == (ERROR, 0.5)
        made.exitInitializationMode()
        assert step(0.5, 0.1) == (0, 0.6)
        made.setReal([model.index("push") + 1], [-4.0])
        assert step(0.6, 0.1) == (DISCARD, 0.6)
        saved = made.getFMUState()
        assert step(0.5, 0.1) == (ERROR, 0.6)
        made.setFMUState(saved)
        assert step(0.6, 3.0) == (ERROR, 0.6)
        made.setFMUState(saved)
        made.terminate()
        assert step(0.6, 0.1) == (ERROR, 0.6)
        made.freeInstance()


ELSEWHERE = ("doStep from earlier", "doStep from later")
"""Of these the wrapper's library gives the time that was asked for as the last successful one."""


def before_time(before: list[float], fmu: Instance) -> float:
    """Time at which the instance stood, by its own output."""
    outputs = [v.name for v in fmu.description.modelVariables if v.causality == "output"]
    return before[outputs.index("clock")]


def test_what_the_wrapper_does_not_carry_is_an_error_and_harms_nothing():
    with instance(text_fmu(SCENE)) as fmu, instance(text_fmu(SCENE)) as straight:
        for each in (fmu, straight):
            stepped(each)
        with pytest.raises(FMICallException) as caught:
            fmu.fmu.cancelStep()
        assert caught.value.status == ERROR
        with pytest.raises(FMICallException) as caught:
            fmu.fmu.getDirectionalDerivative([fmu.references["A.x"]], [fmu.references["push"]], [1])
        assert caught.value.status == ERROR
        assert fmu.run(0.1, 0.1, 3) == straight.run(0.1, 0.1, 3)


@pytest.mark.parametrize(
    ("start", "stop", "words"),
    [(math.nan, None, "start time"), (math.inf, 1.0, "start time"), (1.0, 0.5, "stop time"),
     (0.0, math.nan, "stop time")],
)  # fmt: skip
def test_times_that_no_experiment_has_are_refused_until_better_ones_come(start, stop, words):
    with instance(text_fmu(SCENE)) as fmu:
        fmu.fmu.setupExperiment(startTime=start, stopTime=stop)
        assert words in fmu.log[-1][2]
        fmu.fmu.enterInitializationMode()
        fmu.fmu.exitInitializationMode()
        assert not fmu.step(0.0, 0.1)
        assert words in fmu.log[-1][2]
        fmu.fmu.reset()
        stepped(fmu)
        assert fmu.get("solver.status") == 0


# -------------------------------------------------------------------------------------- times


@KINDS
def test_steps_of_any_size_end_at_the_last_digit_of_the_time_that_was_asked_for(native):
    sizes = random.Random(4)
    with instance(text_fmu(SCENE, native=native)) as fmu:
        fmu.initialise(start=-0.3)
        t = -0.3
        for _ in range(60):
            h = 10.0 ** sizes.uniform(-9, -0.5)
            assert fmu.step(t, h), fmu.log
            t = t + h
            assert fmu.get("clock") == t
        assert fmu.get("energy.error") < 1e-9


# ------------------------------------------------------------------------------- failed steps


@KINDS
def test_a_retry_after_a_failed_step_is_as_if_nothing_had_happened(native):
    fmus = (instance(text_fmu(SCENE, native=native)) for _ in range(2))
    with next(fmus) as fmu, next(fmus) as straight:
        for each in (fmu, straight):
            stepped(each)
        saved = fmu.fmu.getFMUState()
        fmu.set(push=-4.0)
        before = fmu.outputs()
        for k, h in enumerate((0.1, 0.05, 0.025)):
            assert not fmu.step(0.1, h)
            assert fmu.last_successful_time == 0.1
            assert 0 < fmu.get("solver.status") < status.ASSEMBLY_FAILED, k
            assert fmu.outputs()[:-1] == before[:-1]
            assert all(map(math.isfinite, fmu.outputs()))
        fmu.fmu.setFMUState(saved)
        assert fmu.get("push") == 0.0
        assert fmu.run(0.1, 0.02, 20) == straight.run(0.1, 0.02, 20)


@KINDS
def test_the_third_failure_in_a_row_says_what_else_to_change(native):
    with instance(text_fmu(SCENE, native=native)) as fmu:
        stepped(fmu)
        saved = fmu.fmu.getFMUState()
        fmu.set(push=-4.0)
        bad = fmu.fmu.getFMUState()
        said = []
        for h in (0.1, 0.05, 0.025, 0.0125):
            assert not fmu.step(0.1, h)
            said.append(fmu.log[-1][2])
            fmu.fmu.setFMUState(bad)  # as importers do between two attempts
        assert ["in a row" in text for text in said] == [False, False, True, True]
        assert "from 0.1 to 0.025 s" in said[2]
        assert "solver.step_size below 0.01 s" in said[2]
        assert "masses" in said[2]
        fmu.fmu.setFMUState(saved)
        assert fmu.step(0.1, 0.1)
        fmu.set(push=-4.0)
        assert not fmu.step(0.2, 0.1)
        assert "in a row" not in fmu.log[-1][2]


@KINDS
def test_the_same_step_tried_again_and_again_is_told_to_be_shorter(native):
    with instance(text_fmu(SCENE, native=native)) as fmu:
        stepped(fmu)
        fmu.set(push=-4.0)
        for _ in range(3):
            assert not fmu.step(0.1, 0.1)
        assert "all of 0.1 s: take a smaller communication step" in fmu.log[-1][2]
