"""The corpus: one file for each kind of motion, each with a tuple SYSTEMS."""

from __future__ import annotations

from tests.truth.system import System
from tests.truth.systems import gears, loops, pendulums, rotors, springs, tops

SYSTEMS: tuple[System, ...] = (
    *rotors.SYSTEMS,
    *gears.SYSTEMS,
    *tops.SYSTEMS,
    *pendulums.SYSTEMS,
    *loops.SYSTEMS,
    *springs.SYSTEMS,
)
