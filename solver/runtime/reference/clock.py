"""What follows the time: inputs, laws, signals and sensors, through the tape.

An input either jumps at the beginning of a communication step or, if it ramps, runs evenly from
the value before to the new one. Laws hold forces and springs of a step, at its middle; signals are
prescribed values at its end. Sensors tell laws the quantities at the predicted middle.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..model import Model
from .course import ANGLE, TURN, Present, quantity_at, quantity_rate
from .energy import stored_energy
from .mechanism import Mechanism
from .state import Motion
from .tape import run_tape

Array = NDArray[np.float64]

DELTA = 1e-2
"""Step of difference quotients in time, over the step size."""


def sense(mechanism: Mechanism, motion: Motion, h: float, half: int) -> tuple[Array, Array]:
    """Quantities and their rates at the predicted middle of a step of length h (0: now).

    q_mid = q + h/2 v + h^2/8 a, v_mid = v + h/2 a; of angles, the unwrapped value next to the
    present one.
    """
    a = motion.a[half]
    q_low = motion.q_low + 0.5 * h * motion.v + 0.125 * h**2 * a
    v = motion.v + 0.5 * h * a
    forms = mechanism.forms
    u, w = forms.links(motion.q, q_low)
    s, s_dot = np.sum(u * w, axis=1), np.sum(u * (forms.W @ v) + w * (forms.U @ v), axis=1)
    now = Present(mechanism, motion).sigma
    values, rates = np.zeros(len(now)), np.zeros(len(now))
    for index, (kind, its) in enumerate(mechanism.quantities):
        value = quantity_at(kind, s[its], 0.0)
        turns = np.round((now[index] - value) / TURN) if kind == ANGLE else 0.0
        values[index], rates[index] = value + TURN * turns, quantity_rate(kind, s[its], s_dot[its])
    return values, rates


class Clock:
    """The numbers of a model at given times.

    Parameters
    ----------
    model : Model
    numbers : ndarray
        Contents, modified.
    motion : Motion
        Holds inputs and parameters; work is booked in it.
    """

    def __init__(self, model: Model, numbers: Array, motion: Motion) -> None:
        self.model, self.numbers, self.motion = model, numbers, motion
        self.follows = bool(model.sizes["time_dependent"] or model.sizes["sensing"])
        """Whether laws must be set for every step."""
        self._ramps = np.array(model.tables["input_ramp"], dtype=bool)

    def inputs_at(self, t: float) -> Array:
        """Effective values of the inputs at time t, around the present communication step."""
        vectors, start = self.motion.vectors, self.motion.head["time"]
        line = vectors["inputs_before"] + vectors["inputs_slope"] * (t - start)
        return np.where(self._ramps, line, vectors["inputs"])

    def ramp_slopes(self, step: float) -> Array:
        """Slopes of the inputs that ramp over a communication step; 0 of the others."""
        vectors = self.motion.vectors
        return np.where(self._ramps, (vectors["inputs"] - vectors["inputs_before"]) / step, 0.0)

    def _write(self, numbers: Array, t: float) -> None:
        for name, values in (
            ("input", self.inputs_at(t)),
            ("parameter", self.motion.vectors["parameters"]),
            ("time", np.array([t])),
        ):
            start = self.model.offsets[name]
            numbers[start : start + len(values)] = values

    def set_laws(self, mechanism: Mechanism, t: float, *, booked: bool = False) -> None:
        """Set the laws at time t between steps."""
        self._set(mechanism, t, 0.0, 0, booked=booked)

    def set_laws_of_step(self, mechanism: Mechanism, t: float, h: float, half: int) -> None:
        """Set the laws of a step of length h from t, at its middle."""
        self._set(mechanism, t + 0.5 * h, h, half, booked=True)

    def _set(self, mechanism: Mechanism, t: float, h: float, half: int, *, booked: bool) -> None:
        """Run the tape of the laws; a jump of stored energy is booked as work."""
        self._write(self.numbers, t)
        if not self.model.sizes["n_tape_laws"]:
            return
        booked = booked and bool(self.model.sizes["variable_potential"])
        before = stored_energy(mechanism, self.motion) if booked else 0.0
        if self.model.sizes["sensing"]:
            active = slice(self.model.sizes["n_active"])
            values, rates = sense(mechanism, self.motion, h, half)
            mechanism.section["sensor"][active] = values[active]
            mechanism.section["sensor_rate"][active] = rates[active]
        run_tape(self.model, self.numbers, "laws")
        if booked:
            self.motion.book("work", stored_energy(mechanism, self.motion) - before)

    def signals(self, t: float) -> Array:
        """Prescribed values b(t), shape (n_signals,)."""
        count = self.model.sizes["n_signals"]
        if not count:
            return np.zeros(0)
        numbers = self.numbers.copy()
        self._write(numbers, t)
        run_tape(self.model, numbers, "signals")
        start = self.model.offsets["signal"]
        return numbers[start : start + count]

    def signal_rates(self, t: float) -> Array:
        """Rates b'(t) by forward differences of order 4: what b is before t does not matter."""
        d = DELTA * self.motion.head["step_size"]
        now = self.signals(t)
        b = [self.signals(t + k * d) - now for k in range(5)]
        return (48.0 * b[1] - 36.0 * b[2] + 16.0 * b[3] - 3.0 * b[4]) / (12.0 * d)

    def signal_accelerations(self, t: float) -> Array:
        """Second derivatives b''(t) by a difference quotient."""
        d = DELTA * self.motion.head["step_size"]
        now, soon, later = (self.signal_rates(t + k * d) for k in range(3))
        return (-1.5 * now + 2.0 * soon - 0.5 * later) / d
