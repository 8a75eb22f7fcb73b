"""A model's tables keep what the kernel relies on, for scenes with one of everything."""

from __future__ import annotations

import functools

import pytest

import solver
from solver.runtime import Model
from solver.runtime.layout import ABI, TABLES
from tests.support.mechanisms.zoo import PLANE, SPACE

BOTH = pytest.mark.parametrize("text", [PLANE, SPACE], ids=["plane", "space"])


@functools.cache
def model_of(text: str) -> Model:
    return solver.assemble(solver.loads(text))


@BOTH
def test_every_table_and_row_is_there_and_travels(text):
    model = model_of(text)
    assert tuple(model.tables) == tuple(TABLES)
    assert len(model.rows) == model.sizes["n_rows"] == len(model.tables["row_position"])
    assert Model.from_bytes(model.to_bytes()) == model


def test_a_model_of_another_version_is_refused(monkeypatch):
    data = model_of(PLANE).to_bytes()
    monkeypatch.setattr("solver.runtime.layout.ABI", ABI + 1)
    with pytest.raises(ValueError, match="another version of holonom"):
        Model.from_bytes(data)


def test_the_fingerprint_of_saved_states_is_that_of_a_version(monkeypatch):
    # Two versions may lay out states of one length differently, for one and the same model.
    before = Model.from_bytes(model_of(PLANE).to_bytes()).fingerprint
    monkeypatch.setattr("solver.runtime.layout.ABI", ABI + 1)
    assert Model.from_bytes(model_of(PLANE).to_bytes()).fingerprint != before


def test_a_model_with_a_damaged_bit_or_cut_off_is_refused():
    data = model_of(PLANE).to_bytes()
    for place in range(0, len(data), 7):
        flipped = bytearray(data)
        flipped[place] ^= 1 << place % 8
        for damaged in (bytes(flipped), data[:place]):
            with pytest.raises(ValueError, match="damaged"):
                Model.from_bytes(damaged)
