"""An output that is read alone: the others are not measured, and its bits are those among all."""

from __future__ import annotations

import math

import pytest

import solver
from solver.runtime import Integrator
from solver.runtime.layout import measured_sections, measured_size
from tests.support.mechanisms.mechanism_runs import scene

SCENES = ("flyball_governor", "stewart", "bricard", "bouncing_ball", "car_axis", "snakeboard")


def moved(name: str, *, accelerates: bool = False) -> Integrator:
    read = solver.load(scene(name))
    asked = [f"{part}.a{axis}" for part in (*read.points, *read.bodies) for axis in "xyz"]
    run = Integrator(solver.assemble(read, asked if accelerates else ()))
    for _ in range(5):
        run.advance(run.time, 0.01)
    return run


def forget(run: Integrator) -> None:
    """Make all measurements out of date, and NaN until they are taken again."""
    begin, size = run.model.offsets["measured"], measured_size(run.model.sizes)
    run.restore(run.save())
    run.numbers[begin : begin + size] = [math.nan] * size


@pytest.mark.parametrize("accelerates", [False, True], ids=["", "accelerations"])
@pytest.mark.parametrize("name", SCENES)
def test_an_output_has_the_same_bits_alone_and_among_all(name, accelerates):
    run = moved(name, accelerates=accelerates)
    assert run.model.sizes["accelerates"] == accelerates
    outputs = [i for i, v in enumerate(run.model.variables) if v.causality == "output"]
    together = run.get(outputs)
    alone = []
    for index in outputs:
        forget(run)
        alone += run.get([index])
    assert alone == together == [run.get([index])[0] for index in outputs]


@pytest.mark.parametrize("name", SCENES)
def test_no_bit_of_another_output_depends_on_accelerations(name):
    plain, asked = (moved(name, accelerates=accelerates) for accelerates in (False, True))
    names = [v.name for v in plain.model.variables if v.causality == "output"]
    first, second = (run.get([run.model.index(x) for x in names]) for run in (plain, asked))
    assert first == second


def test_a_position_is_read_without_energies_and_forces():
    run = moved("bricard")
    at = run.model.offsets["measured"]
    forget(run)
    assert math.isfinite(float(run["rod1.x"]))
    for section, measured in (("position", True), ("energy", False), ("reaction_force", False)):
        begin, length = measured_sections(run.model.sizes)[section]
        values = run.numbers[at + begin : at + begin + length]
        assert all(math.isnan(value) != measured for value in values)
