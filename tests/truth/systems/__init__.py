"""The corpus: one file for each kind of motion, each with a tuple SYSTEMS."""

from __future__ import annotations

from tests.truth.system import System
from tests.truth.systems import (
    drivers,
    equilibria,
    friction,
    impacts,
    jumps,
    pendulums,
    reactions,
    rolling,
    rotors,
)

SYSTEMS: tuple[System, ...] = (
    *rotors.SYSTEMS,
    *pendulums.SYSTEMS,
    *drivers.SYSTEMS,
    *rolling.SYSTEMS,
    *jumps.SYSTEMS,
    *equilibria.SYSTEMS,
    *reactions.SYSTEMS,
    *friction.SYSTEMS,
    *impacts.SYSTEMS,
)
