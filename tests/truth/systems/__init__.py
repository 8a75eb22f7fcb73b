"""The corpus: one file for each kind of motion, each with a tuple SYSTEMS."""

from __future__ import annotations

from tests.truth.system import System
from tests.truth.systems import (
    buffers,
    drivers,
    equilibria,
    friction,
    gears,
    impacts,
    jumps,
    loops,
    pendulums,
    reactions,
    rolling,
    rotors,
    springs,
    tops,
)

SYSTEMS: tuple[System, ...] = (
    *rotors.SYSTEMS,
    *gears.SYSTEMS,
    *tops.SYSTEMS,
    *pendulums.SYSTEMS,
    *loops.SYSTEMS,
    *springs.SYSTEMS,
    *drivers.SYSTEMS,
    *rolling.SYSTEMS,
    *jumps.SYSTEMS,
    *equilibria.SYSTEMS,
    *reactions.SYSTEMS,
    *friction.SYSTEMS,
    *impacts.SYSTEMS,
    *buffers.SYSTEMS,
)
