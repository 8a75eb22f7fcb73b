"""Inputs that ramp: their slopes change at communication points, and velocities jump with them.

Rates of signals follow the slopes. By db/dt they jump, and velocities by what the rows ask for,

    M dv + G' p = 0,    G dv + Phi_b db/dt = 0,

the energy of which is the drivers' work.
"""

from __future__ import annotations

import numpy as np

from .clock import Clock
from .energy import kinetic_energy
from .mechanism import Mechanism
from .start import constrained, rows_of
from .state import Motion, add


def start_ramps(mechanism: Mechanism, motion: Motion, clock: Clock, step: float) -> None:
    """Set the slopes of the inputs for a communication step, and let velocities jump."""
    t, slopes = motion.head["time"], motion.vectors["inputs_slope"]
    before, new = clock.signal_rates(t), clock.ramp_slopes(step)
    changed = not np.array_equal(slopes, new)
    slopes[:] = new
    if not changed or not len(before):
        return
    jump = clock.signal_rates(t) - before
    free, kinetic = slice(mechanism.n_free), kinetic_energy(mechanism, motion)
    dv = np.zeros(mechanism.n)
    dv[mechanism.n_free :] = jump[: mechanism.n - mechanism.n_free]
    G, by_signals, _ = rows_of(mechanism, motion)
    rest = G @ dv + by_signals @ jump
    M, impulse = mechanism.M[free, free], (mechanism.M @ dv)[free]
    dv[free], _ = constrained(mechanism, M, G[:, free], -impulse, -rest)
    add(motion.v, motion.v_low, dv)
    motion.book("work", kinetic_energy(mechanism, motion) - kinetic)
    motion.start_anew()
