"""Model files and states with random numbers in them and good checksums: refused, or run to an end.

Every value that a run hands out is finite, whatever the file says.
"""

from __future__ import annotations

import functools
import math
import random
import struct
import zlib
from pathlib import Path

import solver
from solver.runtime.layout import PLACE
from solver.runtime.model_file import HEADER
from tests.support.kernel.saved_states import NUMBERS_AT, signed

SCENES = Path(__file__).parents[2] / "scenes"
NAMES = (
    *("double_pendulum", "slider_crank", "heavy_top", "spring_pendulum", "four_bar"),
    *("slider_crank_with_clearance", "bowling_ball", "ball_on_hills", "woodpecker_toy"),
    *("bricard", "double_wishbone"),
)
INTEGERS = (0, -1, 1, 2, 7, 100, 2**31 - 1, -(2**31))
DOUBLES = (0.0, -1.0, 1e300, 5e-324, -1e300, math.nan, math.inf, 1e-9, 3.0)
STEPS = 3
CPU_LIMIT = 10.0
CHECKED_FROM = 12
"""Bytes before those under the checksum of a model."""


def prepare(_folder: Path) -> None:
    """Nothing to make."""


@functools.cache
def _model(name: str) -> solver.Model:
    return solver.assemble(solver.load(SCENES / f"{name}.toml"))


def case(seed: str, number: int, _folder: Path) -> str | None:
    """Run a damaged model, or from a damaged state of a good one."""
    chance = random.Random(f"{seed}/{number}")
    model = _model(chance.choice(NAMES))
    try:
        if chance.random() < 0.5:
            return _run(solver.Integrator(_damaged_model(chance, model), log=lambda _: None))
        run = solver.Integrator(model, log=lambda _: None)
        if chance.random() < 0.5:
            run["solver.order"] = 4.0
        run.advance(run.time, 0.01)
        run.restore(_damaged_state(chance, run.save()))
        return _run(run)
    except (ValueError, solver.OptionError, solver.AssemblyError, solver.StepError) as error:
        return None if str(error) else f"no sentence: {error!r}"


def _run(run: solver.Integrator) -> str | None:
    for _ in range(STEPS):
        run.advance(run.time, min(0.01, 2.0 * run.state.head["step_size"]))
        values = run.get(range(len(run.model.variables)))
        if not all(math.isfinite(x) for x in values if isinstance(x, float)):
            return "it handed out a number that is not finite"
    return None


def _damaged_model(chance: random.Random, model: solver.Model) -> solver.Model:
    data = bytearray(model.file)
    for _ in range(chance.randint(1, 3)):
        if chance.random() < 0.6:
            place = chance.randrange(CHECKED_FROM // 4, len(data) // 4) * 4
            old = int.from_bytes(data[place : place + 4], "little", signed=True)
            near = max(-(2**31), min(2**31 - 1, old + chance.randint(-3, 3)))
            struct.pack_into("<i", data, place, chance.choice((near, chance.choice(INTEGERS))))
        else:
            place = chance.randrange(HEADER.size // 8, len(data) // 8) * 8
            struct.pack_into("<d", data, place, chance.choice(DOUBLES))
    struct.pack_into("<I", data, CHECKED_FROM - 4, zlib.crc32(data[CHECKED_FROM:]))
    return solver.Model.from_bytes(bytes(data))


def _damaged_state(chance: random.Random, good: bytes) -> bytes:
    data = bytearray(good)
    for _ in range(chance.randint(1, 3)):
        places = len(PLACE) if chance.random() < 0.5 else (len(data) - NUMBERS_AT) // 8
        at = NUMBERS_AT + 8 * chance.randrange(places)
        struct.pack_into("<d", data, at, chance.choice(DOUBLES))
    return signed(data)
