"""The method of García Orden and Ortega (2006), sections 2 and 3, as printed: dense NumPy.

All six formulations take any Phi(q), and tell what each iteration did. `motion` moves a `Problem`
that one writes down, `simulate` a scene.
"""

from .energies import Iteration
from .gradients import FORMULATIONS
from .problem import Functions, Method, Problem
from .scenes import Run, problem_of, simulate
from .step import Moment, motion, step

__all__ = ["FORMULATIONS", "Functions", "Iteration", "Method", "Moment", "Problem", "Run"]
__all__ += ["motion", "problem_of", "simulate", "step"]
