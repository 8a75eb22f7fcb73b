"""The method of García Orden and Ortega (2006), sections 2 and 3, as printed: dense NumPy.

It shows the method and its rivals on any constraint; it is not fast. The core has the conserving
formulation alone in mind; here are all six, and each iteration's multipliers, constraints and
energies. `motion` moves a `Problem` that one writes down, `simulate` a scene.
"""

from __future__ import annotations

from .energies import Iteration
from .problem import Functions, Method, Problem, penalties
from .step import Moment, motion, step

__all__ = ["Functions", "Iteration", "Method", "Moment", "Problem", "Run"]
__all__ += ["motion", "penalties", "problem_of", "simulate", "step"]
