"""Reading and assembly grow linearly with a scene: calls and bytes are counted, not seconds."""

from __future__ import annotations

import gc
import sys
import tracemalloc
from collections.abc import Callable

import pytest

import solver
from scenes.generate import hanging_chain, n_four_bar, rigid_chain
from solver.mechanics.assembly import unchecked_model

HEAD = 'name = "large"\ndimension = 2\ngravity = [0, -9.81]\n'


def table(name: str, lines: list[str]) -> str:
    return "\n".join([f"[{name}]", *lines]) + "\n"


def points(n: int) -> list[str]:
    return [f"P{i} = {{ position = [{float(i)}, 0.0], mass = 1.0 }}" for i in range(n)]


def rods(n: int) -> str:
    """Text of a chain of rods."""
    ends = [f'type = "distance", points = ["P{i - 1}", "P{i}"]' for i in range(1, n)]
    joints = [f"R{i} = {{ {end} }}" for i, end in enumerate(ends)]
    return HEAD + table("points", points(n)) + table("joints", joints)


def springs(n: int) -> str:
    """Text of points on springs and dampers, with formulas in them and in outputs."""
    forces = []
    for i in range(1, n):
        ends = f'points = ["P{i - 1}", "P{i}"]'
        forces.append(f'S{i} = {{ type = "spring", {ends}, stiffness = "2*k" }}')
        forces.append(f'D{i} = {{ type = "damper", {ends}, damping = "2*c" }}')
    outputs = [f'O{i} = {{ value = "P{i}.x + S1.force" }}' for i in range(n)]
    parameters = ["k = 1.0", "c = 0.1"]
    return (
        HEAD + table("parameters", parameters) + table("points", points(n))
        + table("forces", forces) + table("outputs", outputs)
    )  # fmt: skip


def driven(n: int) -> str:
    """Text of points on paths of their own; each parameter is computed from the one before."""
    parameters = ["p0 = 0.5", *(f'p{i} = "p{i - 1} + 1.0"' for i in range(1, n))]
    inputs = [f"u{i} = {{ start = 0.0 }}" for i in range(n)]
    drivers = [
        f'D{i} = {{ type = "position", point = "P{i}", value = ["p{i} + sin(t)", "u{i} * t"] }}'
        for i in range(n)
    ]
    free = "F = { position = [0.0, 1.0], mass = 1.0 }"
    return (
        HEAD + table("parameters", parameters) + table("inputs", inputs)
        + table("points", [*points(n), free]) + table("drivers", drivers)
    )  # fmt: skip


def discs(n: int) -> str:
    """Text of discs in a row on a floor, each beside the next."""
    floor = 'type = "plane", axis = [0, 1], position = [0, -0.5], radius = 0.5'
    beside = 'type = "sphere", radii = [0.45, 0.45]'
    contacts = [f'F{i} = {{ {floor}, point = "P{i}" }}' for i in range(n)]
    contacts += [f'S{i} = {{ {beside}, points = ["P{i - 1}", "P{i}"] }}' for i in range(1, n)]
    return HEAD + table("points", points(n)) + table("contacts", contacts)


SCENES: dict[str, Callable[[int], str]] = {
    "rods": rods,
    "bars": hanging_chain,
    "bodies in the plane": lambda n: rigid_chain(n, 2),
    "bodies in space": rigid_chain,
    "loops": n_four_bar,
    "springs and outputs": springs,
    "driven": driven,
    "discs": discs,
}


def calls(run: Callable[[], object]) -> int:
    """Count the calls of functions, Python's and C's."""
    count = 0

    def note(_frame: object, event: str, _what: object) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(note)
    try:
        run()
    finally:
        sys.setprofile(None)
    return count


def peak(run: Callable[[], object]) -> int:
    """Largest memory of Python's objects and arrays in a run [bytes]."""
    gc.collect()
    tracemalloc.start()
    try:
        run()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def growth(count: Callable[[Callable[[], object]], int], text: Callable[[int], str]) -> float:
    """Cost of 40 more parts over that of 20 more: 2 where it is linear, 4 where quadratic."""
    sizes = (20, 40, 80)
    costs = [count(lambda n=n: unchecked_model(solver.loads(text(n)))) for n in sizes]
    return (costs[2] - costs[1]) / (costs[1] - costs[0])


@pytest.mark.parametrize("name", SCENES)
def test_reading_and_assembly_take_calls_in_proportion_to_the_parts(name):
    unchecked_model(solver.loads(SCENES[name](3)))  # what the first scene imports is no part of it
    assert growth(calls, SCENES[name]) <= 2.02


@pytest.mark.parametrize("name", SCENES)
def test_reading_and_assembly_take_memory_in_proportion_to_the_parts(name):
    # Python's tables grow in leaps when they are full, so that a size may lie off the line.
    unchecked_model(solver.loads(SCENES[name](3)))
    assert growth(peak, SCENES[name]) <= 2.5


def test_a_small_scene_is_read_without_a_count_of_what_a_caller_has_frozen(monkeypatch):
    # Of the objects of a large test suite, the count takes three quarters of its time.
    monkeypatch.setattr(gc, "get_freeze_count", lambda: pytest.fail("all objects are counted"))
    assert unchecked_model(solver.loads(discs(3)))
