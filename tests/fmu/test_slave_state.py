"""A slave takes its whole state back, or refuses it and goes no further."""

from __future__ import annotations

import math

import pytest

from fmu_src import snapshot, status
from tests.fmu_instance import instance, pendulum, scene_fmu, stepping_slave

ERROR = 3


@pytest.mark.parametrize(
    "data",
    [b"", b"x", snapshot.MARK, snapshot.MARK + b"\xff\xff\xff\x7f{}" + bytes(20), bytes(500)],
    ids=len,
)
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


def test_the_state_of_another_model_is_refused():
    with instance(pendulum()) as fmu, instance(scene_fmu("four_bar")) as other:
        fmu.initialise()
        other.initialise()
        data = other.fmu.serializeFMUState(other.fmu.getFMUState())
        fmu.fmu.setFMUState(fmu.fmu.deserializeFMUState(data))
        assert "another model" in fmu.log[-1][2]
        assert not fmu.step(0.0, 0.1)
        assert fmu.get("solver.status") == status.STATE_REFUSED


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


MEMORY = snapshot.Memory(2, True, -1, 0.1 + 0.2, {3: "text", "assembly": "ü\n"})


@pytest.mark.parametrize("start", [0.1 + 0.2, None])
def test_a_snapshot_comes_back_as_it_was(start):
    memory, state = MEMORY._replace(start_time=start), bytes(range(256))
    assert snapshot.unpack(snapshot.pack(memory, state)) == (memory, state)


@pytest.mark.parametrize(
    "wrong", [{"phase": 9}, {"start_time": math.inf}, {"refusals": [5]}, {"refusals": "3"}], ids=str
)
def test_a_memory_that_no_slave_has_is_refused_and_nothing_is_taken_over(wrong):
    slave = stepping_slave()
    good = slave._get_fmu_state()
    right, data = snapshot.unpack(good)
    assert slave.do_step(0.0, 0.1)
    before = slave._integrator.save()
    slave._set_fmu_state(snapshot.pack(right._replace(**wrong), data))
    assert slave.get_real([slave._status_index]) == [status.STATE_REFUSED]
    assert slave._integrator.save() == before
    assert not slave.do_step(0.1, 0.1)
    slave._set_fmu_state(good)
    assert slave.do_step(0.0, 0.1)


def test_a_state_with_one_damaged_bit_is_refused_wherever_it_is():
    slave = stepping_slave()
    good = slave._get_fmu_state()
    for place in range(len(good)):
        data = bytearray(good)
        data[place] ^= 1 << place % 8
        slave._set_fmu_state(bytes(data))
        assert "state" in slave._refusals, place
        slave._set_fmu_state(good)
    assert slave.do_step(0.0, 0.1)
