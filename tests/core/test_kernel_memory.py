"""All that survives a step is in the state: bits do not depend on scratch, history or process."""

from __future__ import annotations

import numpy as np
import pytest

from solver.runtime import Integrator
from solver.runtime.layout import measured_sections
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.twins import (
    EVERYTHING,
    advance,
    internal_step,
    model_of,
    numbers,
    start,
)
from tests.support.mechanisms.scene_files import ALL, TOUCHING

SOURCES = {path.stem: path for path in ALL}
SOURCES |= {f"everything in {dim}-D": text for dim, text in EVERYTHING.items()}


SOURCES["bead on a rod that a driver turns"] = """
name = "bead"
dimension = 2
gravity = [0, -9.81]
[points]
A = { position = [1, 0], velocity = [0.2, 1], mass = 1.0 }
[constraints]
rod = { value = "A.x*sin(t) - A.y*cos(t)" }
"""
"""A row that is not linear in its signals."""


SEGMENTS = ("parameters", "laws", "signals", "outputs")


def tape_targets(model, *segments):
    """Places in the numbers that segments of the tape write."""
    lengths = [model.sizes[f"n_tape_{name}"] for name in SEGMENTS]
    tape = np.asarray(model.tables["tape"]).reshape(-1, 5)
    rows = [tape[sum(lengths[:s]) : sum(lengths[: s + 1])] for s in segments]
    return np.concatenate(rows)[:, 1]


def spoil(integrator):
    """Fill with NaN all that need not survive: scratch, time, measurements, what laws write."""
    np.asarray(memoryview(kernel_of(integrator).work).cast("B").cast("d"))[:] = np.nan
    model, values = integrator.model, numbers(integrator)
    first, count = measured_sections(model.sizes)["solver"]
    base = model.offsets["measured"]
    values[base : base + first + count] = np.nan
    values[model.offsets["time"]] = np.nan
    values[tape_targets(model, 1, 2, 3)] = np.nan
    for kind in ("input", "parameter"):
        at = model.offsets[kind]
        values[at : at + model.sizes[f"n_{kind}s"]] = np.nan


def outputs(integrator):
    """Values of all variables."""
    return integrator.get(range(len(integrator.model.variables)))


@pytest.mark.parametrize("name", ["four_bar", "bowling_ball", "everything in 3-D"])
def test_the_start_does_not_depend_on_what_lay_in_the_memory_of_scratch(name):
    # `holonom_make` clears all but the scratch: a host may hand over any memory.
    clean, spoilt = (Integrator(model_of(SOURCES[name]), log=lambda _: None) for _ in range(2))
    np.asarray(memoryview(spoilt.work).cast("B").cast("d"))[:] = np.nan
    for integrator in (clean, spoilt):
        integrator.initialise()
    assert outputs(spoilt) == outputs(clean)


@pytest.mark.filterwarnings("ignore:.*contacts change without being located:RuntimeWarning")
@pytest.mark.parametrize("tolerance", [0.0, 1e-6])
@pytest.mark.parametrize("name", SOURCES)
def test_scratch_filled_with_nan_between_steps_changes_nothing(name, tolerance):
    clean, spoilt = (start(SOURCES[name], tolerance=tolerance) for _ in range(2))
    for _ in range(5):
        spoil(spoilt)
        internal_step(clean)
        internal_step(spoilt)
        assert bytes(kernel_of(clean).state) == bytes(kernel_of(spoilt).state)
        spoil(spoilt)
        assert outputs(clean) == outputs(spoilt)


@pytest.mark.parametrize("name", ["spring_pendulum", "everything in 2-D", "everything in 3-D"])
def test_scratch_filled_with_nan_before_an_input_changes_nothing(name):
    clean, spoilt = (start(SOURCES[name]) for _ in range(2))
    for value in (0.0, 3.0, -2.0):
        spoil(spoilt)
        for run in (clean, spoilt):
            run["push"] = value
            internal_step(run)
        assert bytes(kernel_of(clean).state) == bytes(kernel_of(spoilt).state)


@pytest.mark.parametrize("name", SOURCES)
def test_the_same_inputs_give_the_same_bits(name):
    """Also when another run with other settings takes its steps in between."""
    runs = [start(SOURCES[name]) for _ in range(2)]
    touches = name in {path.stem for path in TOUCHING}
    other = start(EVERYTHING[2] if touches else SOURCES[name], penalty=1e10, order=4)
    for _ in range(20):
        internal_step(runs[0])
        internal_step(other)
    advance(runs[1], 20)
    assert bytes(kernel_of(runs[0]).state) == bytes(kernel_of(runs[1]).state)
    assert outputs(runs[0]) == outputs(runs[1])


@pytest.mark.parametrize("name", SOURCES)
def test_100_steps_are_50_saved_and_restored_and_50_more_bit_for_bit(name):
    model = model_of(SOURCES[name])
    whole, parted = (start(model) for _ in range(2))
    advance(whole, 100)
    advance(parted, 50)
    saved = parted.save()
    advance(parted, 7)
    parted.restore(saved)
    fresh = Integrator(model)
    fresh.restore(saved)
    assert outputs(fresh) == outputs(parted)
    for run in (parted, fresh):
        advance(run, 50)
        assert bytes(kernel_of(run).state) == bytes(kernel_of(whole).state)
        assert outputs(run) == outputs(whole)
        assert run.save() == whole.save()


@pytest.mark.parametrize("order", [2, 4])
def test_settings_inputs_and_odd_steps_are_saved_too(order):
    run = start(EVERYTHING[2], penalty=1e7, order=order)
    advance(run, 3)
    run["push"] = 1.3
    run.advance(run.time, 0.0137)
    fresh = Integrator(run.model)
    fresh.restore(run.save())
    for each in (run, fresh):
        advance(each, 3)
    assert outputs(fresh) == outputs(run)
