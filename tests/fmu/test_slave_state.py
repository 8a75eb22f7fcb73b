"""A slave takes its whole state back, or refuses it and goes no further."""

from __future__ import annotations

import contextlib
import math

import pytest
from fmpy.fmi1 import FMICallException

from fmu_src import status
from tests.support.fmus.fmu_instance import instance, pendulum, scene_fmu, status_of, stepping_slave

ERROR = 3


@pytest.mark.parametrize("data", [b"", b"x", b"\n", b"holslv1\0", bytes(500)], ids=len)
def test_bytes_that_are_no_state_are_refused(data):
    with instance(pendulum()) as fmu:
        fmu.initialise()
        before = fmu.outputs()
        fmu.fmu.setFMUState(fmu.fmu.deserializeFMUState(data))
        assert fmu.log[-1][0] == ERROR
        assert fmu.outputs()[:-1] == before[:-1]
        assert not fmu.step(0.0, 0.1)
        fmu.fmu.reset()
        fmu.initialise()
        assert fmu.step(0.0, 0.1)


@pytest.mark.parametrize("native", [False, True])
@pytest.mark.parametrize("other", [scene_fmu, lambda _, native: pendulum(2.0, native=native)])
def test_the_state_of_another_model_is_refused(other, native):
    """One of another length, and one of the same."""
    with (
        instance(pendulum(native=native)) as fmu,
        instance(other("four_bar", native=native)) as stranger,
    ):
        fmu.initialise()
        stranger.initialise()
        data = stranger.fmu.serializeFMUState(stranger.fmu.getFMUState())
        with contextlib.suppress(FMICallException):  # of a native one
            fmu.fmu.setFMUState(fmu.fmu.deserializeFMUState(data))
        assert "another model" in fmu.log[-1][2]
        assert fmu.step(0.0, 0.1) == native
        assert fmu.get("solver.status") == (0.0 if native else status.STATE_REFUSED)


def test_a_good_state_ends_a_refusal():
    with instance(pendulum()) as fmu:
        fmu.initialise()
        good = fmu.fmu.getFMUState()
        fmu.set(push=math.nan)
        bad = fmu.fmu.getFMUState()
        fmu.fmu.setFMUState(good)
        assert fmu.step(0.0, 0.1)
        fmu.fmu.setFMUState(bad)
        assert not fmu.step(0.0, 0.1)


def test_a_state_with_one_damaged_bit_is_refused_wherever_it_is_and_nothing_is_taken_over():
    slave = stepping_slave()
    slave.set_integer([0], [1])  # refused, and so a part of the state
    good = slave._get_fmu_state()
    for place in range(len(good)):
        data = bytearray(good)
        data[place] ^= 1 << place % 8
        slave._set_fmu_state(bytes(data))
        assert status_of(slave) == status.STATE_REFUSED, place
        slave._set_fmu_state(good)
        assert status_of(slave) == status.VALUE_REFUSED
        assert slave._get_fmu_state() == good
