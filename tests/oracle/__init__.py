"""The oracle: one half step of García Orden & Ortega's method from the equations, in NumPy.

Dense matrices, the equations in the order of the paper (docs/theory), and nothing that a step could
do without: no prediction, no kept factors, no islands apart, no order above 2, no
tolerance. `Mechanism` has the matrices of a model at a state, `HalfStep` solves one half step from
it, `start` has what a run begins with.
`contacts`, `impacts` and `events` let contacts and frictions change between steps (theory 10).
"""

from tests.oracle.mechanism import Mechanism
from tests.oracle.step import HalfStep, Residual, internal_step

__all__ = ["HalfStep", "Mechanism", "Residual", "internal_step"]
