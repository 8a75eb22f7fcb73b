"""A model's tables keep what the kernel relies on, for scenes with one of everything."""

from __future__ import annotations

import functools
import itertools

import numpy as np
import pytest

import solver
from solver.runtime import Model
from solver.runtime.layout import ABI, TABLES
from tests.zoo import PLANE, SPACE

BOTH = pytest.mark.parametrize("text", [PLANE, SPACE], ids=["plane", "space"])


@functools.cache
def model_of(text: str) -> Model:
    return solver.assemble(solver.loads(text))


def table(model: Model, name: str) -> list[int]:
    return list(model.tables[name])


def section(model: Model, name: str, count: int) -> np.ndarray:
    start = model.offsets[name]
    return np.array(model.numbers[start : start + count])


@BOTH
def test_free_nodes_come_first_in_every_form_then_driven_ones(text):
    model = model_of(text)
    n_free, n_driven = model.sizes["n_free"], model.sizes["n_driven"]
    ptr, nodes = table(model, "form_ptr"), table(model, "form_node")
    for form, (free, moving) in enumerate(
        zip(table(model, "form_free"), table(model, "form_moving"), strict=True)
    ):
        kinds = [
            0 if node < n_free else 1 if node < n_free + n_driven else 2
            for node in nodes[ptr[form] : ptr[form + 1]]
        ]
        assert kinds == sorted(kinds)
        assert (kinds.count(0), kinds.count(0) + kinds.count(1)) == (free, moving)


@BOTH
def test_flags_of_forms_are_those_of_their_coefficients(text):
    model = model_of(text)
    n = model.sizes["n_entries"]
    alpha, beta = section(model, "alpha", n), section(model, "beta", n)
    turned = model.offsets["beta_turn"] > model.offsets["alpha_turn"]
    turns = [section(model, f"{x}_turn", n if turned else 0) for x in ("alpha", "beta")]
    ptr, kinds = table(model, "form_ptr"), table(model, "form_kind")
    assert turned == any(kind & 4 for kind in kinds)
    for form, kind in enumerate(kinds):
        own = slice(ptr[form], ptr[form + 1])
        moving = slice(ptr[form], ptr[form] + model.tables["form_moving"][form])
        straight = not turned or not (turns[0][own].any() or turns[1][own].any())
        if kind & 1:
            assert (alpha[own] == beta[own]).all()
        if kind & 2:
            assert not beta[moving].any()
            assert not turned or not turns[1][moving].any()
        assert bool(kind & 4) != straight


@BOTH
def test_quantities_that_act_come_before_those_that_are_only_measured(text):
    model = model_of(text)
    leaves = np.array(model.tables["leaf"]).reshape(-1, 4)
    used = leaves[leaves[:, 0] < 2, 1]
    assert used.max() < model.sizes["n_active"] <= model.sizes["n_quantities"]


@BOTH
def test_leaves_point_at_their_forms_within_a_composite(text):
    model = model_of(text)
    ptr, forms = table(model, "composite_form_ptr"), table(model, "composite_form")
    leaves = np.array(model.tables["leaf"]).reshape(-1, 4)
    quantity_form = np.array(model.tables["quantity_form"]).reshape(-1, 2)
    leaf_ptr = table(model, "leaf_ptr")
    for composite in range(len(ptr) - 1):
        own = forms[ptr[composite] : ptr[composite + 1]]
        assert len(own) == len(set(own))
        for kind, index, *local in leaves[leaf_ptr[composite] : leaf_ptr[composite + 1]]:
            if kind == 2:
                assert index < model.sizes["n_signals"]
                assert local == [-1, -1]
                continue
            for place, form in zip(local, quantity_form[index], strict=True):
                assert form == (-1 if place < 0 else own[place])


@BOTH
def test_slots_have_the_lengths_that_the_kernel_counts(text):
    model = model_of(text)
    dim, sizes = model.sizes["dim"], model.sizes
    free, kinds = table(model, "form_free"), table(model, "form_kind")
    ptr = table(model, "composite_node_ptr")

    def row(form: int) -> int:
        k, block = free[form], dim * dim if kinds[form] & 4 else dim
        return (0 if kinds[form] & 2 else k * k * block) + 2 * k * dim

    width = [dim * (b - a) for a, b in itertools.pairwise(ptr)]
    rows = range(
        sizes["n_elements"],
        sizes["n_elements"] + sizes["n_function_rows"] + sizes["n_velocity_rows"],
    )
    directors = 1 if dim == 2 else 3
    followers = zip(table(model, "load_form"), table(model, "load_axes"), strict=True)
    expected = {
        "mass_slot": dim * sizes["n_mass_free"],
        "row_slot": sum(row(form) for form in table(model, "row_form")),
        "coincidence_slot": sum(
            2 * free[form] * (dim * dim if kinds[form] & 4 else dim)
            for form in table(model, "coincidence_form")
        ),
        "composite_slot": sum(w * w + 2 * w * (k in rows) for k, w in enumerate(width)),
        "load_slot": sum(free[f] * directors * dim * dim for f, axes in followers if axes >= 0),
        "moment_slot": sum((free[form] * dim) ** 2 for form in table(model, "moment_form")),
        "body_moment_slot": 81 * sizes["n_body_moments"],
    }
    assert {name: len(model.tables[name]) for name in expected} == expected
    for name in expected:
        assert all(0 <= slot < sizes["n_lu_values"] for slot in model.tables[name])


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
