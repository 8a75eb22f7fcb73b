"""A controller as an FMU of its own, built by pythonfmu: it holds a pole on a cart upright.

    force = K [x, vx, lean, lean_rate]

with the gains of a linear-quadratic regulator for the cart and pole of cart_pole.toml, rounded.
pythonfmu runs this file by itself, so it imports nothing of the repository.
"""

import ctypes

from pythonfmu import Fmi2Causality, Fmi2Slave, Real

GAINS = {"x": 3.2, "vx": 6.1, "lean": 56.0, "lean_rate": 14.0}
"""N/m, N.s/m, N/rad, N.s/rad."""


class Controller(Fmi2Slave):
    """A linear state feedback that is sampled at the communication points."""

    description = "State feedback for a pole on a cart"

    def __init__(self, **kwargs) -> None:
        super().__init__(**kwargs)
        self.force = 0.0
        self.register_variable(Real("force", causality=Fmi2Causality.output))
        for name in GAINS:
            setattr(self, name, 0.0)
            self.register_variable(Real(name, causality=Fmi2Causality.input))

    def do_step(self, current_time: float, step_size: float) -> bool:
        """Sample the inputs, which hold for the whole step."""
        del current_time, step_size
        self.force = sum(gain * getattr(self, name) for name, gain in GAINS.items())
        return True


# pythonfmu's library releases a reference to this module's dictionary that it does not own, once
# per instance; without this one the second instance reads freed memory (docs/fmu.md, section 5).
ctypes.pythonapi.Py_IncRef(ctypes.py_object(globals()))
