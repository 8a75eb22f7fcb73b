"""Saved states, damaged, cut, mixed or foreign: refused with a sentence, and nothing changed."""

from __future__ import annotations

import functools
import math
import random
import struct
from pathlib import Path

import solver

SCENE = """
name = "hung"
dimension = {dimension}
gravity = {gravity}
[inputs]
push = {{ start = 0.0 }}
[parameters]
stiffness = {{ value = 20.0, variability = "tunable" }}
[points]
O = {{ position = {origin}, fixed = true }}
A = {{ position = {first}, mass = 1.0 }}
B = {{ position = {second}, mass = 0.5 }}
[joints]
rod = {{ type = "distance", points = ["O", "A"] }}
[forces]
rope = {{ type = "spring", points = ["A", "B"], stiffness = "stiffness", free_length = 0.5 }}
wind = {{ type = "force", point = "B", value = {wind} }}
[solver]
order = {order}
"""
PLANE = {
    "dimension": 2,
    "gravity": [0, -9.81],
    "origin": [0, 0],
    "first": [1, 0],
    "second": [2, 0],
    "wind": '["push", 0]',
}
SPACE = {
    "dimension": 3,
    "gravity": [0, 0, -9.81],
    "origin": [0, 0, 0],
    "first": [1, 0, 0],
    "second": [2, 0, 0],
    "wind": '["push", 0, 0]',
}
NUMBERS = (math.nan, math.inf, -math.inf, 1e300, -1.0, 1e6, 0.0, 5e-324)


def prepare(folder: Path) -> None:
    """Write the scenes."""
    for name, values, order in (("a", PLANE, 2), ("b", PLANE, 4), ("c", SPACE, 2)):
        text = SCENE.format(**values, order=order)
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")


@functools.cache
def _moved(folder: Path, name: str) -> tuple[solver.Integrator, tuple[bytes, ...]]:
    """Run of a scene, and states before it, at its start and on its way."""
    run = solver.Integrator(solver.assemble(solver.load(folder / f"{name}.toml")))
    states = [run.save()]
    run.initialise(0.0)
    states.append(run.save())
    for k in range(3):
        run["push"] = float(k)
        run.advance(0.05 * k, 0.05)
        states.append(run.save())
    return run, tuple(states)


def case(seed: str, number: int, folder: Path) -> str | None:
    """Restore a damaged state, then a good one."""
    chance = random.Random(f"{seed}/{number}")
    run, states = _moved(folder, chance.choice("abc"))
    good = chance.choice(states)
    run.restore(good)
    after = _step(run)
    run.restore(good)
    damaged = _damaged(chance, good, _moved(folder, chance.choice("abc"))[1])
    try:
        run.restore(damaged)
    except solver.OptionError as error:
        if "\n" in str(error) or not str(error):
            return f"no sentence: {error!r}"
        if run.save() != good:
            return "it was refused, and the present state changed"
    else:
        if damaged not in states:
            return "a damaged state was taken"
        if run.save() != damaged:
            return "a good state came back otherwise"
    run.restore(good)
    return None if _step(run) == after else "the run goes on otherwise"


def _step(run: solver.Integrator) -> bytes:
    """State after a step from where the run is."""
    run.advance(run.time, 0.05)
    return run.save()


def _damaged(chance: random.Random, good: bytes, others: tuple[bytes, ...]) -> bytes:
    data, place = bytearray(good), chance.randrange(len(good))
    kind = chance.randrange(8)
    if kind == 0:
        data[place] ^= 1 << chance.randrange(8)
    elif kind == 1:
        del data[place:]
    elif kind == 2:
        data += chance.randbytes(chance.randrange(1, 100))
    elif kind == 3:
        data = bytearray(chance.choice(others))
    elif kind == 4:
        del data[place : place + chance.randrange(1, 64)]
    elif kind == 5:
        struct.pack_into("<d", data, min(place, len(data) - 8), chance.choice(NUMBERS))
    elif kind == 6:
        data = data[:place] + bytearray(chance.choice(others))[place:]
    else:
        data = bytearray(chance.randbytes(chance.randrange(300)))
    return bytes(data)
