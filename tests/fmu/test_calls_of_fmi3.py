"""Calls of FMI 3.0 that fmpy has no use for: of other kinds and types, and the log's switch."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import solver
from build_kernel.compiler import SLAVE_SOURCES
from tests.fmu.test_state_machine import ERROR, SCENE, stepped
from tests.support.fmus.fmu_instance import Instance, instance
from tests.support.fmus.native_fmus import native_fmu

HEADER = (Path(__file__).parents[2] / SLAVE_SOURCES / "fmi3.h").read_text("utf-8")
NAMES = re.findall(r"X\((fmi3\w+)\)", HEADER)
OTHER_TYPES = [name for name in NAMES if re.match(r"fmi3[GS]et(U?Int\d|Float|Binary|Clock)", name)]
REFERENCES = (ctypes.c_uint32 * 1)(0)
LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, *[ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p])


@pytest.fixture(scope="module")
def fmu() -> Iterator[Instance]:
    with instance(native_fmu(solver.assemble(solver.loads(SCENE)), 3)) as made:
        stepped(made)
        yield made


def call(fmu: Instance, name: str, *arguments: object) -> int:
    """Status of a function of the library, with any arguments."""
    function = ctypes.CDLL(fmu.fmu.dll._name)[name]
    return function(ctypes.c_void_p(fmu.fmu.component), *arguments)


@pytest.mark.parametrize("name", OTHER_TYPES)
def test_no_variable_has_another_type(name, fmu):
    assert call(fmu, name, None, ctypes.c_size_t(0)) == 0
    before = fmu.outputs()
    assert call(fmu, name, REFERENCES, ctypes.c_size_t(1)) == ERROR
    assert fmu.log[-1][2] == f"there are no variables of the type that {name} is for"
    assert fmu.outputs() == before


@pytest.mark.parametrize("name", sorted({*NAMES} - {*OTHER_TYPES}))
def test_a_call_of_events_or_model_exchange_is_refused_by_name(name, fmu):
    before = fmu.outputs()
    assert call(fmu, name) == ERROR
    assert fmu.log[-1][2].startswith(f"{name}: this FMU is for co-simulation without events")
    assert fmu.outputs() == before


def test_no_call_without_an_instance_ends_the_process(fmu):
    library, count = ctypes.CDLL(fmu.fmu.dll._name), ctypes.c_size_t(1)
    for name in NAMES:
        assert library[name](None, REFERENCES, count) == ERROR


@pytest.mark.parametrize("kind", ["ModelExchange", "ScheduledExecution"])
def test_there_is_no_instance_of_another_kind(kind, fmu):
    heard: list[tuple[int, bytes]] = []
    logger = LOGGER(lambda _, status, _category, text: heard.append((status, text)))
    make = ctypes.CDLL(fmu.fmu.dll._name)[f"fmi3Instantiate{kind}"]
    make.restype = ctypes.c_void_p
    texts = [ctypes.c_char_p(x) for x in (b"name", fmu.description.guid.encode(), b"")]
    nothing = [ctypes.c_void_p() for _ in range(3)]
    assert make(*texts, False, True, None, logger, *nothing) is None
    ((status, text),) = heard
    assert status == ERROR
    assert text.startswith(b"instantiate: this FMU is for co-simulation, not for ")


def test_the_version_is_3_0(fmu):
    version = ctypes.CDLL(fmu.fmu.dll._name).fmi3GetVersion
    version.restype = ctypes.c_char_p
    assert version() == b"3.0"


def test_a_freed_state_is_null_and_the_log_may_be_silenced(fmu):
    saved = fmu.fmu.getFMUState()
    assert saved
    fmu.fmu.freeFMUState(saved)
    assert not saved
    assert call(fmu, "fmi3SetDebugLogging", False, ctypes.c_size_t(0), None) == 0
    told = len(fmu.log)
    assert call(fmu, "fmi3SetTime") == ERROR
    assert len(fmu.log) == told
    assert call(fmu, "fmi3SetDebugLogging", True, ctypes.c_size_t(0), None) == 0


def test_truths_and_words_are_set_and_read_again():
    with instance(native_fmu(solver.assemble(solver.loads(SCENE)), 3)) as fmu:
        fmu.set(solver__assemble=True, solver__start="equilibrium")
        assert fmu.get("solver.assemble") is True
        assert fmu.get("solver.start") == "equilibrium"
